struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_13 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_37 {
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

struct type_41 {
    member: array<lt_bvh_Triangle>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_51;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_171_: bool;
    var phi_175_: f32;

    if (param != param) {
        phi_171_ = true;
    } else {
        let _e57 = (param_1 >= param);
        if _e57 {
        }
        phi_171_ = _e57;
    }
    let _e59 = phi_171_;
    if _e59 {
        phi_175_ = param_1;
    } else {
        phi_175_ = param;
    }
    let _e61 = phi_175_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_187_: bool;
    var phi_191_: f32;

    if (param_2 != param_2) {
        phi_187_ = true;
    } else {
        let _e57 = (param_3 <= param_2);
        if _e57 {
        }
        phi_187_ = _e57;
    }
    let _e59 = phi_187_;
    if _e59 {
        phi_191_ = param_3;
    } else {
        phi_191_ = param_2;
    }
    let _e61 = phi_191_;
    return _e61;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_276_: f32;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_359_: bool;
    var phi_363_: bool;
    var phi_433_: f32;
    var phi_440_: f32;
    var phi_447_: f32;
    var phi_454_: f32;
    var phi_461_: f32;
    var phi_468_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_516_: u32;
    var phi_521_: u32;
    var phi_526_: u32;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_672_: u32;
    var phi_674_: u32;
    var phi_677_: bool;
    var phi_757_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_784_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_811_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_817_: u32;
    var phi_820_: u32;
    var phi_834_: u32;
    var phi_844_: u32;
    var phi_854_: u32;
    var phi_872_: u32;
    var phi_882_: u32;
    var phi_892_: u32;
    var phi_928_: u32;
    var phi_941_: u32;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_818_: u32;
    var phi_821_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1006_: u32;
    var phi_1009_: bool;
    var phi_1058_: f32;
    var phi_1063_: f32;
    var phi_1068_: f32;
    var phi_1076_: f32;
    var phi_1081_: f32;
    var phi_1086_: f32;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1257_: bool;
    var phi_1261_: bool;
    var phi_1331_: f32;
    var phi_1338_: f32;
    var phi_1345_: f32;
    var phi_1352_: f32;
    var phi_1359_: f32;
    var phi_1366_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1393_: f32;
    var phi_1421_: bool;
    var phi_1422_: bool;
    var phi_1430_: u32;
    var phi_1431_: u32;
    var phi_1442_: vec3<f32>;
    var phi_1443_: vec3<f32>;
    var phi_1456_: u32;
    var phi_1461_: u32;
    var phi_1466_: u32;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1612_: u32;
    var phi_1614_: u32;
    var phi_1617_: bool;
    var phi_1697_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1724_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1751_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1757_: u32;
    var phi_1760_: u32;
    var phi_1774_: u32;
    var phi_1784_: u32;
    var phi_1794_: u32;
    var phi_1812_: u32;
    var phi_1822_: u32;
    var phi_1832_: u32;
    var phi_1868_: u32;
    var phi_1881_: u32;
    var phi_1886_: u32;
    var phi_1887_: u32;
    var phi_1888_: u32;
    var phi_1758_: u32;
    var phi_1761_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1946_: u32;
    var phi_1949_: bool;
    var phi_1993_: vec3<f32>;
    var phi_1994_: vec3<f32>;
    var phi_2023_: vec3<f32>;
    var phi_2024_: vec3<f32>;
    var phi_2053_: vec3<f32>;
    var phi_2054_: vec3<f32>;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2077_: f32;
    var phi_2078_: f32;
    var phi_2079_: f32;
    var phi_2080_: f32;
    var phi_2088_: f32;
    var phi_2098_: bool;
    var phi_2099_: bool;
    var phi_2103_: f32;
    var phi_2104_: f32;
    var phi_2105_: f32;
    var phi_2106_: f32;
    var phi_2114_: f32;
    var phi_2124_: bool;
    var phi_2125_: bool;
    var phi_2129_: f32;
    var phi_2130_: f32;
    var phi_2131_: f32;
    var phi_2132_: f32;
    var phi_2140_: f32;
    var phi_2155_: f32;
    var phi_2156_: bool;
    var phi_2157_: f32;
    var phi_2158_: bool;
    var phi_2159_: f32;
    var phi_2160_: bool;
    var phi_2178_: f32;
    var phi_2179_: bool;
    var phi_2180_: bool;
    var phi_2181_: f32;
    var phi_2182_: bool;
    var phi_2183_: bool;
    var phi_2187_: bool;
    var phi_2188_: f32;
    var phi_2189_: bool;
    var phi_2217_: vec3<f32>;
    var phi_2218_: vec3<f32>;
    var phi_2243_: vec3<f32>;
    var phi_2244_: vec3<f32>;
    var phi_2269_: vec3<f32>;
    var phi_2270_: vec3<f32>;
    var phi_2326_: f32;
    var phi_2335_: f32;
    var phi_2344_: f32;
    var phi_2353_: f32;
    var phi_2360_: f32;
    var phi_2367_: f32;
    var phi_2380_: f32;
    var phi_2389_: f32;
    var phi_2398_: f32;
    var phi_2407_: f32;
    var phi_2414_: f32;
    var phi_2421_: f32;
    var phi_2438_: f32;
    var phi_2443_: f32;
    var phi_2448_: f32;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2466_: f32;
    var phi_2478_: f32;
    var phi_2483_: f32;
    var phi_2488_: f32;
    var phi_2493_: f32;
    var phi_2498_: lt_bvh_triangle_Intersection;
    var phi_2499_: bool;
    var phi_2500_: lt_bvh_triangle_Intersection;
    var phi_2501_: bool;
    var phi_2505_: lt_bvh_triangle_Intersection;
    var phi_2506_: bool;
    var phi_2507_: lt_bvh_triangle_Intersection;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2513_: bool;
    var phi_2517_: lt_bvh_triangle_Intersection;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_1947_: u32;
    var phi_1950_: bool;
    var phi_2547_: bool;
    var local_8: bool;
    var phi_2589_: bool;
    var phi_2590_: bool;
    var phi_2621_: u32;
    var phi_2622_: u32;
    var phi_1615_: u32;
    var phi_1618_: bool;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var local_9: bool;
    var phi_2628_: bool;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2635_: bool;
    var phi_2639_: bool;
    var phi_2643_: bool;
    var phi_2644_: bool;
    var phi_2645_: bool;
    var phi_2646_: bool;
    var phi_2647_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_1007_: u32;
    var phi_1010_: bool;
    var phi_2653_: bool;
    var local_10: bool;
    var phi_2695_: bool;
    var phi_2696_: bool;
    var phi_2727_: u32;
    var phi_2728_: u32;
    var phi_675_: u32;
    var phi_678_: bool;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var local_11: bool;
    var phi_2734_: bool;
    var phi_2738_: bool;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2749_: bool;
    var phi_2753_: f32;
    var phi_2794_: u32;
    var phi_2813_: u32;
    var phi_2821_: u32;
    var phi_2829_: u32;
    var phi_2834_: u32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

    let _e56 = id_1;
    let _e63 = arrayLength((&nodes.member));
    let _e69 = arrayLength((&visibility.member));
    let _e72 = arrayLength((&list.member));
    let _e75 = arrayLength((&bits.member));
    let _e82 = ((_e56.y * 2097152u) + _e56.x);
    if (3u < _e72) {
    } else {
        return;
    }
    let _e85 = list.member[3u];
    if (_e82 < _e85) {
        let _e87 = (_e82 + 4u);
        if (_e87 < _e72) {
        } else {
            return;
        }
        let _e91 = list.member[(0u + _e87)];
        let _e93 = p.member.root;
        if (_e91 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e99 = samples.member[(0u + _e91)].position;
        let _e101 = samples.member[(0u + _e91)].normal;
        let _e103 = samples.member[(0u + _e91)].magnitude;
        let _e105 = ((8f / 8388608f) * _e103);
        let _e113 = (_e99.x + (_e101.x * _e105));
        let _e115 = (_e99.y + (_e101.y * _e105));
        let _e117 = (_e99.z + (_e101.z * _e105));
        let _e119 = p.member.light.place;
        if (_e119.w == 0f) {
            phi_276_ = 300000000000000000000000000000000000000f;
        } else {
            phi_276_ = 1f;
        }
        let _e123 = phi_276_;
        let _e131 = (_e119.x - (_e113 * _e119.w));
        let _e132 = (_e119.y - (_e115 * _e119.w));
        let _e133 = (_e119.z - (_e117 * _e119.w));
        let _e137 = abs(_e131);
        let _e138 = abs(_e132);
        let _e139 = abs(_e133);
        if (abs(_e113) < 1000000000000000f) {
            if (abs(_e115) < 1000000000000000f) {
                if (abs(_e117) < 1000000000000000f) {
                    if (_e137 < 1000000000000000f) {
                        if (_e138 < 1000000000000000f) {
                            if (_e139 < 1000000000000000f) {
                                if (_e137 > 0f) {
                                    phi_333_ = bool();
                                    phi_334_ = true;
                                } else {
                                    let _e147 = (_e138 > 0f);
                                    if _e147 {
                                        phi_332_ = bool();
                                    } else {
                                        phi_332_ = (_e139 > 0f);
                                    }
                                    let _e150 = phi_332_;
                                    phi_333_ = _e150;
                                    phi_334_ = _e147;
                                }
                                let _e152 = phi_333_;
                                let _e154 = phi_334_;
                                if _e154 {
                                    phi_338_ = true;
                                } else {
                                    phi_338_ = _e152;
                                }
                                let _e156 = phi_338_;
                                phi_339_ = _e156;
                                phi_340_ = false;
                            } else {
                                phi_339_ = bool();
                                phi_340_ = true;
                            }
                            let _e158 = phi_339_;
                            let _e160 = phi_340_;
                            phi_341_ = _e158;
                            phi_342_ = false;
                            phi_343_ = _e160;
                        } else {
                            phi_341_ = bool();
                            phi_342_ = true;
                            phi_343_ = false;
                        }
                        let _e162 = phi_341_;
                        let _e164 = phi_342_;
                        let _e166 = phi_343_;
                        phi_344_ = _e162;
                        phi_345_ = _e164;
                        phi_346_ = _e166;
                    } else {
                        phi_344_ = bool();
                        phi_345_ = true;
                        phi_346_ = false;
                    }
                    let _e168 = phi_344_;
                    let _e170 = phi_345_;
                    let _e172 = phi_346_;
                    phi_347_ = _e168;
                    phi_348_ = _e170;
                    phi_349_ = _e172;
                } else {
                    phi_347_ = bool();
                    phi_348_ = true;
                    phi_349_ = false;
                }
                let _e174 = phi_347_;
                let _e176 = phi_348_;
                let _e178 = phi_349_;
                phi_350_ = _e174;
                phi_351_ = _e176;
                phi_352_ = _e178;
            } else {
                phi_350_ = bool();
                phi_351_ = true;
                phi_352_ = false;
            }
            let _e180 = phi_350_;
            let _e182 = phi_351_;
            let _e184 = phi_352_;
            phi_353_ = _e180;
            phi_354_ = _e182;
            phi_355_ = _e184;
        } else {
            phi_353_ = bool();
            phi_354_ = true;
            phi_355_ = false;
        }
        let _e186 = phi_353_;
        let _e188 = phi_354_;
        let _e190 = phi_355_;
        if _e188 {
            phi_359_ = true;
        } else {
            phi_359_ = _e190;
        }
        let _e192 = phi_359_;
        if _e192 {
            phi_363_ = false;
        } else {
            phi_363_ = _e186;
        }
        let _e194 = phi_363_;
        if _e194 {
            let _e195 = (_e93 >= _e63);
            if _e195 {
                phi_2738_ = false;
            } else {
                if (_e93 < _e63) {
                } else {
                    return;
                }
                let _e201 = nodes.member[(0u + _e93)].frame[0u];
                let _e205 = nodes.member[(0u + _e93)].frame[1u];
                let _e209 = nodes.member[(0u + _e93)].frame[2u];
                let _e213 = nodes.member[(0u + _e93)].frame[0u];
                let _e217 = nodes.member[(0u + _e93)].frame[1u];
                let _e221 = nodes.member[(0u + _e93)].frame[2u];
                let _e225 = nodes.member[(0u + _e93)].frame[3u];
                let _e259 = core_intrinsics_maximum_number_nsz_f32_(abs(_e131), abs(_e132));
                let _e260 = core_intrinsics_maximum_number_nsz_f32_(_e259, abs(_e133));
                let _e261 = (_e260 * 0.0000000000009094947f);
                if (abs(_e131) < _e261) {
                    phi_433_ = _e261;
                } else {
                    phi_433_ = abs(_e131);
                }
                let _e266 = phi_433_;
                if (_e131 < 0f) {
                    phi_440_ = (-1f / _e266);
                } else {
                    phi_440_ = (1f / _e266);
                }
                let _e271 = phi_440_;
                if (abs(_e132) < _e261) {
                    phi_447_ = _e261;
                } else {
                    phi_447_ = abs(_e132);
                }
                let _e276 = phi_447_;
                if (_e132 < 0f) {
                    phi_454_ = (-1f / _e276);
                } else {
                    phi_454_ = (1f / _e276);
                }
                let _e281 = phi_454_;
                if (abs(_e133) < _e261) {
                    phi_461_ = _e261;
                } else {
                    phi_461_ = abs(_e133);
                }
                let _e286 = phi_461_;
                if (_e133 < 0f) {
                    phi_468_ = (-1f / _e286);
                } else {
                    phi_468_ = (1f / _e286);
                }
                let _e291 = phi_468_;
                let _e295 = abs((bitcast<f32>(_e201) - _e113));
                let _e296 = abs((bitcast<f32>(_e205) - _e115));
                let _e297 = abs((bitcast<f32>(_e209) - _e117));
                let _e301 = abs(((bitcast<f32>(_e213) + (bitcast<f32>((((_e225 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                let _e302 = abs(((bitcast<f32>(_e217) + (bitcast<f32>((((_e225 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e115));
                let _e303 = abs(((bitcast<f32>(_e221) + (bitcast<f32>((((_e225 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e117));
                if (_e295 > _e301) {
                    phi_485_ = _e295;
                } else {
                    phi_485_ = _e301;
                }
                let _e306 = phi_485_;
                if (_e296 > _e302) {
                    phi_490_ = _e296;
                } else {
                    phi_490_ = _e302;
                }
                let _e309 = phi_490_;
                if (_e297 > _e303) {
                    phi_495_ = _e297;
                } else {
                    phi_495_ = _e303;
                }
                let _e312 = phi_495_;
                let _e313 = core_intrinsics_maximum_number_nsz_f32_(_e306, _e309);
                let _e314 = core_intrinsics_maximum_number_nsz_f32_(_e313, _e312);
                let _e318 = (_e314 * 0.0000019073486f);
                let _e319 = (abs(_e271) * _e318);
                let _e320 = (abs(_e281) * _e318);
                let _e321 = (abs(_e291) * _e318);
                let _e325 = (_e314 * 0.0000009536743f);
                let _e326 = (abs(_e271) * _e325);
                let _e327 = (abs(_e281) * _e325);
                let _e328 = (abs(_e291) * _e325);
                if (_e271 < 0f) {
                    phi_516_ = 0u;
                } else {
                    phi_516_ = 1u;
                }
                let _e331 = phi_516_;
                if (_e281 < 0f) {
                    phi_521_ = 0u;
                } else {
                    phi_521_ = 2u;
                }
                let _e334 = phi_521_;
                if (_e291 < 0f) {
                    phi_526_ = 0u;
                } else {
                    phi_526_ = 4u;
                }
                let _e337 = phi_526_;
                let _e339 = ((_e331 | _e334) | _e337);
                let _e340 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e93, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e340.first[0], _e340.first[1], _e340.first[2], _e340.first[3], _e340.first[4], _e340.first[5], _e340.first[6], _e340.first[7], _e340.first[8], _e340.first[9], _e340.first[10], _e340.first[11], _e340.first[12], _e340.first[13], _e340.first[14], _e340.first[15], _e340.first[16], _e340.first[17], _e340.first[18], _e340.first[19], _e340.first[20], _e340.first[21], _e340.first[22], _e340.first[23], _e340.first[24], _e340.first[25], _e340.first[26], _e340.first[27], _e340.first[28], _e340.first[29], _e340.first[30], _e340.first[31]), array<u32, 32>(_e340.mask[0], _e340.mask[1], _e340.mask[2], _e340.mask[3], _e340.mask[4], _e340.mask[5], _e340.mask[6], _e340.mask[7], _e340.mask[8], _e340.mask[9], _e340.mask[10], _e340.mask[11], _e340.mask[12], _e340.mask[13], _e340.mask[14], _e340.mask[15], _e340.mask[16], _e340.mask[17], _e340.mask[18], _e340.mask[19], _e340.mask[20], _e340.mask[21], _e340.mask[22], _e340.mask[23], _e340.mask[24], _e340.mask[25], _e340.mask[26], _e340.mask[27], _e340.mask[28], _e340.mask[29], _e340.mask[30], _e340.mask[31]), _e340.len, _e340.group, _e340.group_mask);
                let _e414 = local_1.group_mask;
                if ((_e414 & 4278190080u) == 0u) {
                    let _e418 = local_1.len;
                    if (_e418 == 0u) {
                        phi_640_ = false;
                    } else {
                        let _e422 = local_1.len;
                        local_1.len = (_e422 - 1u);
                        let _e425 = local_1.len;
                        if (_e425 < 32u) {
                        } else {
                            return;
                        }
                        let _e430 = local_1.first[(0u + _e425)];
                        local_1.group = _e430;
                        let _e433 = local_1.len;
                        if (_e433 < 32u) {
                        } else {
                            return;
                        }
                        let _e438 = local_1.mask[(0u + _e433)];
                        local_1.group_mask = _e438;
                        phi_640_ = true;
                    }
                    let _e441 = phi_640_;
                    phi_641_ = _e441;
                } else {
                    phi_641_ = true;
                }
                let _e443 = phi_641_;
                if _e443 {
                    let _e445 = local_1.group_mask;
                    let _e451 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e445)), 32u, (_e445 == 0u)));
                    let _e455 = local_1.group_mask;
                    let _e469 = local_1.group_mask;
                    local_1.group_mask = (_e469 & ~((1u << bitcast<u32>((_e451 & 31u)))));
                    let _e472 = local_1.group;
                    phi_672_ = (_e472 + countOneBits(((_e455 & ~((4294967295u << bitcast<u32>((((_e451 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_672_ = 4294967295u;
                }
                let _e475 = phi_672_;
                phi_674_ = _e475;
                phi_677_ = false;
                loop {
                    let _e477 = phi_674_;
                    let _e479 = phi_677_;
                    if (_e477 != 4294967295u) {
                        if (_e477 < _e63) {
                        } else {
                            return;
                        }
                        let _e486 = nodes.member[(0u + _e477)].frame[3u];
                        let _e511 = (bitcast<f32>((((_e486 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e271);
                        let _e512 = (bitcast<f32>((((_e486 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e281);
                        let _e513 = (bitcast<f32>((((_e486 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e291);
                        let _e516 = nodes.member[(0u + _e477)].frame[0u];
                        let _e520 = nodes.member[(0u + _e477)].frame[1u];
                        let _e524 = nodes.member[(0u + _e477)].frame[2u];
                        let _e529 = ((bitcast<f32>(_e516) - _e113) * _e271);
                        let _e530 = ((bitcast<f32>(_e520) - _e115) * _e281);
                        let _e531 = ((bitcast<f32>(_e524) - _e117) * _e291);
                        let _e539 = nodes.member[(0u + _e477)].x;
                        if (_e271 < 0f) {
                            let _e550 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e539.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e556 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e550.unnamed.word, _e539.w), _e550.unnamed_1);
                            let _e562 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e556.unnamed, lt_mask_LightPlace(_e539.x, _e556.unnamed_1.shift));
                            phi_757_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e562.unnamed, lt_mask_LightPlace(_e562.unnamed_1.word, _e539.y));
                        } else {
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e539.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e578.unnamed.word, _e539.y), _e578.unnamed_1);
                            let _e590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e584.unnamed, lt_mask_LightPlace(_e539.z, _e584.unnamed_1.shift));
                            phi_757_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e590.unnamed, lt_mask_LightPlace(_e590.unnamed_1.word, _e539.w));
                        }
                        let _e598 = phi_757_;
                        let _e608 = nodes.member[(0u + _e477)].y;
                        if (_e281 < 0f) {
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e608.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e619.unnamed.word, _e608.w), _e619.unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_mask_LightPlace(_e608.x, _e625.unnamed_1.shift));
                            phi_784_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_mask_LightPlace(_e631.unnamed_1.word, _e608.y));
                        } else {
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e608.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e647.unnamed.word, _e608.y), _e647.unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e608.z, _e653.unnamed_1.shift));
                            phi_784_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_mask_LightPlace(_e659.unnamed_1.word, _e608.w));
                        }
                        let _e667 = phi_784_;
                        let _e677 = nodes.member[(0u + _e477)].z;
                        if (_e291 < 0f) {
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e677.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e688.unnamed.word, _e677.w), _e688.unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e677.x, _e694.unnamed_1.shift));
                            phi_811_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_mask_LightPlace(_e700.unnamed_1.word, _e677.y));
                        } else {
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e677.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e716.unnamed.word, _e677.y), _e716.unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e677.z, _e722.unnamed_1.shift));
                            phi_811_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_mask_LightPlace(_e728.unnamed_1.word, _e677.w));
                        }
                        let _e736 = phi_811_;
                        phi_817_ = 0u;
                        phi_820_ = 0u;
                        loop {
                            let _e746 = phi_817_;
                            let _e748 = phi_820_;
                            local_2 = _e748;
                            local_3 = _e748;
                            local_4 = _e748;
                            let _e749 = (_e746 < 8u);
                            if _e749 {
                                let _e751 = (_e746 >> bitcast<u32>(2i));
                                let _e752 = (_e746 & 3u);
                                if (_e751 == 0u) {
                                    phi_834_ = _e598.unnamed.word;
                                } else {
                                    phi_834_ = _e598.unnamed.shift;
                                }
                                let _e755 = phi_834_;
                                if (_e751 == 0u) {
                                    phi_844_ = _e667.unnamed.word;
                                } else {
                                    phi_844_ = _e667.unnamed.shift;
                                }
                                let _e764 = phi_844_;
                                if (_e751 == 0u) {
                                    phi_854_ = _e736.unnamed.word;
                                } else {
                                    phi_854_ = _e736.unnamed.shift;
                                }
                                let _e773 = phi_854_;
                                let _e786 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e755 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u)) * _e511) + (_e529 - _e319)), ((f32(((_e764 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u)) * _e512) + (_e530 - _e320)));
                                let _e787 = core_intrinsics_maximum_number_nsz_f32_(_e786, ((f32(((_e773 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u)) * _e513) + (_e531 - _e321)));
                                if (_e751 == 0u) {
                                    phi_872_ = _e598.unnamed_1.word;
                                } else {
                                    phi_872_ = _e598.unnamed_1.shift;
                                }
                                let _e790 = phi_872_;
                                if (_e751 == 0u) {
                                    phi_882_ = _e667.unnamed_1.word;
                                } else {
                                    phi_882_ = _e667.unnamed_1.shift;
                                }
                                let _e799 = phi_882_;
                                if (_e751 == 0u) {
                                    phi_892_ = _e736.unnamed_1.word;
                                } else {
                                    phi_892_ = _e736.unnamed_1.shift;
                                }
                                let _e808 = phi_892_;
                                let _e821 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e790 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u)) * _e511) + (_e529 + _e319)), ((f32(((_e799 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u)) * _e512) + (_e530 + _e320)));
                                let _e822 = core_intrinsics_minimum_number_nsz_f32_(_e821, ((f32(((_e808 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u)) * _e513) + (_e531 + _e321)));
                                if (_e787 <= _e822) {
                                    if (_e787 <= _e123) {
                                        if (_e822 >= 0f) {
                                            if (_e751 == 0u) {
                                                let _e829 = nodes.member[(0u + _e477)].links[2u];
                                                phi_928_ = _e829;
                                            } else {
                                                let _e832 = nodes.member[(0u + _e477)].links[3u];
                                                phi_928_ = _e832;
                                            }
                                            let _e834 = phi_928_;
                                            let _e839 = ((_e834 >> bitcast<u32>(((_e752 * 8u) & 31u))) & 255u);
                                            let _e840 = (_e839 & 31u);
                                            if (_e840 >= 24u) {
                                                phi_941_ = (24u + ((_e840 - 24u) ^ _e339));
                                            } else {
                                                phi_941_ = _e840;
                                            }
                                            let _e846 = phi_941_;
                                            phi_946_ = (_e748 | ((_e839 >> bitcast<u32>(5i)) << bitcast<u32>((_e846 & 31u))));
                                        } else {
                                            phi_946_ = _e748;
                                        }
                                        let _e854 = phi_946_;
                                        phi_947_ = _e854;
                                    } else {
                                        phi_947_ = _e748;
                                    }
                                    let _e856 = phi_947_;
                                    phi_948_ = _e856;
                                } else {
                                    phi_948_ = _e748;
                                }
                                let _e858 = phi_948_;
                                phi_818_ = (_e746 + 1u);
                                phi_821_ = _e858;
                            } else {
                                phi_818_ = u32();
                                phi_821_ = u32();
                            }
                            let _e861 = phi_818_;
                            let _e863 = phi_821_;
                            continue;
                            continuing {
                                phi_817_ = _e861;
                                phi_820_ = _e863;
                                break if !(_e749);
                            }
                        }
                        let _e867 = nodes.member[(0u + _e477)].links[0u];
                        let _e871 = nodes.member[(0u + _e477)].frame[3u];
                        let _e875 = local_2;
                        if ((_e875 & 4278190080u) == 0u) {
                        } else {
                            let _e879 = local_1.group_mask;
                            if ((_e879 & 4278190080u) == 0u) {
                            } else {
                                let _e883 = local_1.len;
                                if (_e883 < 32u) {
                                    let _e886 = local_1.group;
                                    let _e888 = local_1.len;
                                    if (_e888 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e888)] = _e886;
                                    let _e894 = local_1.group_mask;
                                    let _e896 = local_1.len;
                                    if (_e896 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e896)] = _e894;
                                    let _e903 = local_1.len;
                                    local_1.len = (_e903 + 1u);
                                }
                            }
                            local_1.group = (_e93 + _e867);
                            let _e907 = local_3;
                            local_1.group_mask = ((_e907 & 4278190080u) | (_e871 >> bitcast<u32>(24i)));
                        }
                        let _e912 = local_4;
                        phi_1006_ = (_e912 & 16777215u);
                        phi_1009_ = _e479;
                        loop {
                            let _e915 = phi_1006_;
                            let _e917 = phi_1009_;
                            local_15 = _e917;
                            let _e918 = (_e915 == 0u);
                            local_10 = _e918;
                            local_16 = _e918;
                            if _e918 {
                                phi_1007_ = u32();
                                phi_1010_ = bool();
                                phi_2653_ = false;
                            } else {
                                let _e921 = nodes.member[(0u + _e477)].links[1u];
                                let _e925 = (_e921 + select(firstTrailingBit(_e915), 32u, (_e915 == 0u)));
                                if (_e925 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e932 = instances.member[(0u + _e925)].low_world;
                                let _e934 = instances.member[(0u + _e925)].high_world;
                                let _e941 = ((_e932.x - _e113) * _e271);
                                let _e942 = ((_e932.y - _e115) * _e281);
                                let _e943 = ((_e932.z - _e117) * _e291);
                                let _e950 = ((_e934.x - _e113) * _e271);
                                let _e951 = ((_e934.y - _e115) * _e281);
                                let _e952 = ((_e934.z - _e117) * _e291);
                                if (_e941 < _e950) {
                                    phi_1058_ = _e941;
                                } else {
                                    phi_1058_ = _e950;
                                }
                                let _e955 = phi_1058_;
                                if (_e942 < _e951) {
                                    phi_1063_ = _e942;
                                } else {
                                    phi_1063_ = _e951;
                                }
                                let _e958 = phi_1063_;
                                if (_e943 < _e952) {
                                    phi_1068_ = _e943;
                                } else {
                                    phi_1068_ = _e952;
                                }
                                let _e961 = phi_1068_;
                                if (_e941 > _e950) {
                                    phi_1076_ = _e941;
                                } else {
                                    phi_1076_ = _e950;
                                }
                                let _e967 = phi_1076_;
                                if (_e942 > _e951) {
                                    phi_1081_ = _e942;
                                } else {
                                    phi_1081_ = _e951;
                                }
                                let _e970 = phi_1081_;
                                if (_e943 > _e952) {
                                    phi_1086_ = _e943;
                                } else {
                                    phi_1086_ = _e952;
                                }
                                let _e973 = phi_1086_;
                                let _e977 = core_intrinsics_maximum_number_nsz_f32_((_e955 - _e326), (_e958 - _e327));
                                let _e978 = core_intrinsics_maximum_number_nsz_f32_(_e977, (_e961 - _e328));
                                let _e979 = core_intrinsics_minimum_number_nsz_f32_((_e967 + _e326), (_e970 + _e327));
                                let _e980 = core_intrinsics_minimum_number_nsz_f32_(_e979, (_e973 + _e328));
                                if (_e978 <= _e980) {
                                    if (_e978 <= _e123) {
                                        if (_e980 >= 0f) {
                                            let _e986 = instances.member[(0u + _e925)].world_to_object[0u];
                                            let _e997 = ((((_e986.x * _e113) + (_e986.y * _e115)) + (_e986.z * _e117)) + (_e986.w * 1f));
                                            let _e999 = instances.member[(0u + _e925)].world_to_object[1u];
                                            let _e1010 = ((((_e999.x * _e113) + (_e999.y * _e115)) + (_e999.z * _e117)) + (_e999.w * 1f));
                                            let _e1012 = instances.member[(0u + _e925)].world_to_object[2u];
                                            let _e1023 = ((((_e1012.x * _e113) + (_e1012.y * _e115)) + (_e1012.z * _e117)) + (_e1012.w * 1f));
                                            let _e1026 = instances.member[(0u + _e925)].world_to_object[0u];
                                            let _e1037 = ((((_e1026.x * _e131) + (_e1026.y * _e132)) + (_e1026.z * _e133)) + (_e1026.w * 0f));
                                            let _e1039 = instances.member[(0u + _e925)].world_to_object[1u];
                                            let _e1050 = ((((_e1039.x * _e131) + (_e1039.y * _e132)) + (_e1039.z * _e133)) + (_e1039.w * 0f));
                                            let _e1052 = instances.member[(0u + _e925)].world_to_object[2u];
                                            let _e1063 = ((((_e1052.x * _e131) + (_e1052.y * _e132)) + (_e1052.z * _e133)) + (_e1052.w * 0f));
                                            let _e1066 = instances.member[(0u + _e925)].root;
                                            let _e1068 = instances.member[(0u + _e925)].first_triangle;
                                            let _e1072 = abs(_e1037);
                                            let _e1073 = abs(_e1050);
                                            let _e1074 = abs(_e1063);
                                            if (abs(_e997) < 1000000000000000f) {
                                                if (abs(_e1010) < 1000000000000000f) {
                                                    if (abs(_e1023) < 1000000000000000f) {
                                                        if (_e1072 < 1000000000000000f) {
                                                            if (_e1073 < 1000000000000000f) {
                                                                if (_e1074 < 1000000000000000f) {
                                                                    if (_e1072 > 0f) {
                                                                        phi_1231_ = bool();
                                                                        phi_1232_ = true;
                                                                    } else {
                                                                        let _e1082 = (_e1073 > 0f);
                                                                        if _e1082 {
                                                                            phi_1230_ = bool();
                                                                        } else {
                                                                            phi_1230_ = (_e1074 > 0f);
                                                                        }
                                                                        let _e1085 = phi_1230_;
                                                                        phi_1231_ = _e1085;
                                                                        phi_1232_ = _e1082;
                                                                    }
                                                                    let _e1087 = phi_1231_;
                                                                    let _e1089 = phi_1232_;
                                                                    if _e1089 {
                                                                        phi_1236_ = true;
                                                                    } else {
                                                                        phi_1236_ = _e1087;
                                                                    }
                                                                    let _e1091 = phi_1236_;
                                                                    phi_1237_ = _e1091;
                                                                    phi_1238_ = false;
                                                                } else {
                                                                    phi_1237_ = bool();
                                                                    phi_1238_ = true;
                                                                }
                                                                let _e1093 = phi_1237_;
                                                                let _e1095 = phi_1238_;
                                                                phi_1239_ = _e1093;
                                                                phi_1240_ = false;
                                                                phi_1241_ = _e1095;
                                                            } else {
                                                                phi_1239_ = bool();
                                                                phi_1240_ = true;
                                                                phi_1241_ = false;
                                                            }
                                                            let _e1097 = phi_1239_;
                                                            let _e1099 = phi_1240_;
                                                            let _e1101 = phi_1241_;
                                                            phi_1242_ = _e1097;
                                                            phi_1243_ = _e1099;
                                                            phi_1244_ = _e1101;
                                                        } else {
                                                            phi_1242_ = bool();
                                                            phi_1243_ = true;
                                                            phi_1244_ = false;
                                                        }
                                                        let _e1103 = phi_1242_;
                                                        let _e1105 = phi_1243_;
                                                        let _e1107 = phi_1244_;
                                                        phi_1245_ = _e1103;
                                                        phi_1246_ = _e1105;
                                                        phi_1247_ = _e1107;
                                                    } else {
                                                        phi_1245_ = bool();
                                                        phi_1246_ = true;
                                                        phi_1247_ = false;
                                                    }
                                                    let _e1109 = phi_1245_;
                                                    let _e1111 = phi_1246_;
                                                    let _e1113 = phi_1247_;
                                                    phi_1248_ = _e1109;
                                                    phi_1249_ = _e1111;
                                                    phi_1250_ = _e1113;
                                                } else {
                                                    phi_1248_ = bool();
                                                    phi_1249_ = true;
                                                    phi_1250_ = false;
                                                }
                                                let _e1115 = phi_1248_;
                                                let _e1117 = phi_1249_;
                                                let _e1119 = phi_1250_;
                                                phi_1251_ = _e1115;
                                                phi_1252_ = _e1117;
                                                phi_1253_ = _e1119;
                                            } else {
                                                phi_1251_ = bool();
                                                phi_1252_ = true;
                                                phi_1253_ = false;
                                            }
                                            let _e1121 = phi_1251_;
                                            let _e1123 = phi_1252_;
                                            let _e1125 = phi_1253_;
                                            if _e1123 {
                                                phi_1257_ = true;
                                            } else {
                                                phi_1257_ = _e1125;
                                            }
                                            let _e1127 = phi_1257_;
                                            if _e1127 {
                                                phi_1261_ = false;
                                            } else {
                                                phi_1261_ = _e1121;
                                            }
                                            let _e1129 = phi_1261_;
                                            if _e1129 {
                                                let _e1130 = (_e1066 >= _e63);
                                                if _e1130 {
                                                    phi_2633_ = bool();
                                                } else {
                                                    if (_e1066 < _e63) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1136 = nodes.member[(0u + _e1066)].frame[0u];
                                                    let _e1140 = nodes.member[(0u + _e1066)].frame[1u];
                                                    let _e1144 = nodes.member[(0u + _e1066)].frame[2u];
                                                    let _e1148 = nodes.member[(0u + _e1066)].frame[0u];
                                                    let _e1152 = nodes.member[(0u + _e1066)].frame[1u];
                                                    let _e1156 = nodes.member[(0u + _e1066)].frame[2u];
                                                    let _e1160 = nodes.member[(0u + _e1066)].frame[3u];
                                                    let _e1194 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1037), abs(_e1050));
                                                    let _e1195 = core_intrinsics_maximum_number_nsz_f32_(_e1194, abs(_e1063));
                                                    let _e1196 = (_e1195 * 0.0000000000009094947f);
                                                    if (abs(_e1037) < _e1196) {
                                                        phi_1331_ = _e1196;
                                                    } else {
                                                        phi_1331_ = abs(_e1037);
                                                    }
                                                    let _e1201 = phi_1331_;
                                                    if (_e1037 < 0f) {
                                                        phi_1338_ = (-1f / _e1201);
                                                    } else {
                                                        phi_1338_ = (1f / _e1201);
                                                    }
                                                    let _e1206 = phi_1338_;
                                                    if (abs(_e1050) < _e1196) {
                                                        phi_1345_ = _e1196;
                                                    } else {
                                                        phi_1345_ = abs(_e1050);
                                                    }
                                                    let _e1211 = phi_1345_;
                                                    if (_e1050 < 0f) {
                                                        phi_1352_ = (-1f / _e1211);
                                                    } else {
                                                        phi_1352_ = (1f / _e1211);
                                                    }
                                                    let _e1216 = phi_1352_;
                                                    if (abs(_e1063) < _e1196) {
                                                        phi_1359_ = _e1196;
                                                    } else {
                                                        phi_1359_ = abs(_e1063);
                                                    }
                                                    let _e1221 = phi_1359_;
                                                    if (_e1063 < 0f) {
                                                        phi_1366_ = (-1f / _e1221);
                                                    } else {
                                                        phi_1366_ = (1f / _e1221);
                                                    }
                                                    let _e1226 = phi_1366_;
                                                    let _e1230 = abs((bitcast<f32>(_e1136) - _e997));
                                                    let _e1231 = abs((bitcast<f32>(_e1140) - _e1010));
                                                    let _e1232 = abs((bitcast<f32>(_e1144) - _e1023));
                                                    let _e1236 = abs(((bitcast<f32>(_e1148) + (bitcast<f32>((((_e1160 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e997));
                                                    let _e1237 = abs(((bitcast<f32>(_e1152) + (bitcast<f32>((((_e1160 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1010));
                                                    let _e1238 = abs(((bitcast<f32>(_e1156) + (bitcast<f32>((((_e1160 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1023));
                                                    if (_e1230 > _e1236) {
                                                        phi_1383_ = _e1230;
                                                    } else {
                                                        phi_1383_ = _e1236;
                                                    }
                                                    let _e1241 = phi_1383_;
                                                    if (_e1231 > _e1237) {
                                                        phi_1388_ = _e1231;
                                                    } else {
                                                        phi_1388_ = _e1237;
                                                    }
                                                    let _e1244 = phi_1388_;
                                                    if (_e1232 > _e1238) {
                                                        phi_1393_ = _e1232;
                                                    } else {
                                                        phi_1393_ = _e1238;
                                                    }
                                                    let _e1247 = phi_1393_;
                                                    let _e1248 = core_intrinsics_maximum_number_nsz_f32_(_e1241, _e1244);
                                                    let _e1249 = core_intrinsics_maximum_number_nsz_f32_(_e1248, _e1247);
                                                    let _e1253 = (_e1249 * 0.0000019073486f);
                                                    let _e1254 = (abs(_e1206) * _e1253);
                                                    let _e1255 = (abs(_e1216) * _e1253);
                                                    let _e1256 = (abs(_e1226) * _e1253);
                                                    let _e1260 = (_e1249 * 0.0000009536743f);
                                                    let _e1261 = (abs(_e1206) * _e1260);
                                                    let _e1262 = (abs(_e1216) * _e1260);
                                                    let _e1263 = (abs(_e1226) * _e1260);
                                                    let _e1264 = abs(_e1037);
                                                    let _e1265 = abs(_e1050);
                                                    let _e1266 = abs(_e1063);
                                                    if (_e1264 >= _e1265) {
                                                        if (_e1264 >= _e1266) {
                                                            phi_1421_ = false;
                                                        } else {
                                                            phi_1421_ = true;
                                                        }
                                                        let _e1270 = phi_1421_;
                                                        phi_1422_ = _e1270;
                                                    } else {
                                                        phi_1422_ = true;
                                                    }
                                                    let _e1272 = phi_1422_;
                                                    if _e1272 {
                                                        if (_e1265 >= _e1266) {
                                                            phi_1430_ = 1u;
                                                        } else {
                                                            phi_1430_ = 2u;
                                                        }
                                                        let _e1275 = phi_1430_;
                                                        phi_1431_ = _e1275;
                                                    } else {
                                                        phi_1431_ = 0u;
                                                    }
                                                    let _e1277 = phi_1431_;
                                                    if (_e1277 == 0u) {
                                                        phi_1443_ = vec3<f32>(_e1050, _e1063, _e1037);
                                                    } else {
                                                        if (_e1277 == 1u) {
                                                            phi_1442_ = vec3<f32>(_e1063, _e1037, _e1050);
                                                        } else {
                                                            phi_1442_ = vec3<f32>(_e1037, _e1050, _e1063);
                                                        }
                                                        let _e1283 = phi_1442_;
                                                        phi_1443_ = _e1283;
                                                    }
                                                    let _e1285 = phi_1443_;
                                                    let _e1288 = (_e1285.x / _e1285.z);
                                                    let _e1291 = (_e1285.y / _e1285.z);
                                                    if (_e1206 < 0f) {
                                                        phi_1456_ = 0u;
                                                    } else {
                                                        phi_1456_ = 1u;
                                                    }
                                                    let _e1296 = phi_1456_;
                                                    if (_e1216 < 0f) {
                                                        phi_1461_ = 0u;
                                                    } else {
                                                        phi_1461_ = 2u;
                                                    }
                                                    let _e1299 = phi_1461_;
                                                    if (_e1226 < 0f) {
                                                        phi_1466_ = 0u;
                                                    } else {
                                                        phi_1466_ = 4u;
                                                    }
                                                    let _e1302 = phi_1466_;
                                                    let _e1304 = ((_e1296 | _e1299) | _e1302);
                                                    let _e1305 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1066, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1305.first[0], _e1305.first[1], _e1305.first[2], _e1305.first[3], _e1305.first[4], _e1305.first[5], _e1305.first[6], _e1305.first[7], _e1305.first[8], _e1305.first[9], _e1305.first[10], _e1305.first[11], _e1305.first[12], _e1305.first[13], _e1305.first[14], _e1305.first[15], _e1305.first[16], _e1305.first[17], _e1305.first[18], _e1305.first[19], _e1305.first[20], _e1305.first[21], _e1305.first[22], _e1305.first[23], _e1305.first[24], _e1305.first[25], _e1305.first[26], _e1305.first[27], _e1305.first[28], _e1305.first[29], _e1305.first[30], _e1305.first[31]), array<u32, 32>(_e1305.mask[0], _e1305.mask[1], _e1305.mask[2], _e1305.mask[3], _e1305.mask[4], _e1305.mask[5], _e1305.mask[6], _e1305.mask[7], _e1305.mask[8], _e1305.mask[9], _e1305.mask[10], _e1305.mask[11], _e1305.mask[12], _e1305.mask[13], _e1305.mask[14], _e1305.mask[15], _e1305.mask[16], _e1305.mask[17], _e1305.mask[18], _e1305.mask[19], _e1305.mask[20], _e1305.mask[21], _e1305.mask[22], _e1305.mask[23], _e1305.mask[24], _e1305.mask[25], _e1305.mask[26], _e1305.mask[27], _e1305.mask[28], _e1305.mask[29], _e1305.mask[30], _e1305.mask[31]), _e1305.len, _e1305.group, _e1305.group_mask);
                                                    let _e1379 = local.group_mask;
                                                    if ((_e1379 & 4278190080u) == 0u) {
                                                        let _e1383 = local.len;
                                                        if (_e1383 == 0u) {
                                                            phi_1580_ = false;
                                                        } else {
                                                            let _e1387 = local.len;
                                                            local.len = (_e1387 - 1u);
                                                            let _e1390 = local.len;
                                                            if (_e1390 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1395 = local.first[(0u + _e1390)];
                                                            local.group = _e1395;
                                                            let _e1398 = local.len;
                                                            if (_e1398 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1403 = local.mask[(0u + _e1398)];
                                                            local.group_mask = _e1403;
                                                            phi_1580_ = true;
                                                        }
                                                        let _e1406 = phi_1580_;
                                                        phi_1581_ = _e1406;
                                                    } else {
                                                        phi_1581_ = true;
                                                    }
                                                    let _e1408 = phi_1581_;
                                                    if _e1408 {
                                                        let _e1410 = local.group_mask;
                                                        let _e1416 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1410)), 32u, (_e1410 == 0u)));
                                                        let _e1420 = local.group_mask;
                                                        let _e1434 = local.group_mask;
                                                        local.group_mask = (_e1434 & ~((1u << bitcast<u32>((_e1416 & 31u)))));
                                                        let _e1437 = local.group;
                                                        phi_1612_ = (_e1437 + countOneBits(((_e1420 & ~((4294967295u << bitcast<u32>((((_e1416 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1612_ = 4294967295u;
                                                    }
                                                    let _e1440 = phi_1612_;
                                                    phi_1614_ = _e1440;
                                                    phi_1617_ = _e917;
                                                    loop {
                                                        let _e1442 = phi_1614_;
                                                        let _e1444 = phi_1617_;
                                                        local_14 = _e1444;
                                                        if (_e1442 != 4294967295u) {
                                                            if (_e1442 < _e63) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1451 = nodes.member[(0u + _e1442)].frame[3u];
                                                            let _e1476 = (bitcast<f32>((((_e1451 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1206);
                                                            let _e1477 = (bitcast<f32>((((_e1451 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1216);
                                                            let _e1478 = (bitcast<f32>((((_e1451 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1226);
                                                            let _e1481 = nodes.member[(0u + _e1442)].frame[0u];
                                                            let _e1485 = nodes.member[(0u + _e1442)].frame[1u];
                                                            let _e1489 = nodes.member[(0u + _e1442)].frame[2u];
                                                            let _e1494 = ((bitcast<f32>(_e1481) - _e997) * _e1206);
                                                            let _e1495 = ((bitcast<f32>(_e1485) - _e1010) * _e1216);
                                                            let _e1496 = ((bitcast<f32>(_e1489) - _e1023) * _e1226);
                                                            let _e1504 = nodes.member[(0u + _e1442)].x;
                                                            if (_e1206 < 0f) {
                                                                let _e1515 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1504.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1521 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1515.unnamed.word, _e1504.w), _e1515.unnamed_1);
                                                                let _e1527 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1521.unnamed, lt_mask_LightPlace(_e1504.x, _e1521.unnamed_1.shift));
                                                                phi_1697_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1527.unnamed, lt_mask_LightPlace(_e1527.unnamed_1.word, _e1504.y));
                                                            } else {
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1504.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1549 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1543.unnamed.word, _e1504.y), _e1543.unnamed_1);
                                                                let _e1555 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1549.unnamed, lt_mask_LightPlace(_e1504.z, _e1549.unnamed_1.shift));
                                                                phi_1697_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1555.unnamed, lt_mask_LightPlace(_e1555.unnamed_1.word, _e1504.w));
                                                            }
                                                            let _e1563 = phi_1697_;
                                                            let _e1573 = nodes.member[(0u + _e1442)].y;
                                                            if (_e1216 < 0f) {
                                                                let _e1584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1573.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1584.unnamed.word, _e1573.w), _e1584.unnamed_1);
                                                                let _e1596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1590.unnamed, lt_mask_LightPlace(_e1573.x, _e1590.unnamed_1.shift));
                                                                phi_1724_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1596.unnamed, lt_mask_LightPlace(_e1596.unnamed_1.word, _e1573.y));
                                                            } else {
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1573.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1612.unnamed.word, _e1573.y), _e1612.unnamed_1);
                                                                let _e1624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1618.unnamed, lt_mask_LightPlace(_e1573.z, _e1618.unnamed_1.shift));
                                                                phi_1724_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1624.unnamed, lt_mask_LightPlace(_e1624.unnamed_1.word, _e1573.w));
                                                            }
                                                            let _e1632 = phi_1724_;
                                                            let _e1642 = nodes.member[(0u + _e1442)].z;
                                                            if (_e1226 < 0f) {
                                                                let _e1653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1642.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1653.unnamed.word, _e1642.w), _e1653.unnamed_1);
                                                                let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1659.unnamed, lt_mask_LightPlace(_e1642.x, _e1659.unnamed_1.shift));
                                                                phi_1751_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1665.unnamed, lt_mask_LightPlace(_e1665.unnamed_1.word, _e1642.y));
                                                            } else {
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1642.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1681.unnamed.word, _e1642.y), _e1681.unnamed_1);
                                                                let _e1693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1687.unnamed, lt_mask_LightPlace(_e1642.z, _e1687.unnamed_1.shift));
                                                                phi_1751_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1693.unnamed, lt_mask_LightPlace(_e1693.unnamed_1.word, _e1642.w));
                                                            }
                                                            let _e1701 = phi_1751_;
                                                            phi_1757_ = 0u;
                                                            phi_1760_ = 0u;
                                                            loop {
                                                                let _e1711 = phi_1757_;
                                                                let _e1713 = phi_1760_;
                                                                local_5 = _e1713;
                                                                local_6 = _e1713;
                                                                local_7 = _e1713;
                                                                let _e1714 = (_e1711 < 8u);
                                                                if _e1714 {
                                                                    let _e1716 = (_e1711 >> bitcast<u32>(2i));
                                                                    let _e1717 = (_e1711 & 3u);
                                                                    if (_e1716 == 0u) {
                                                                        phi_1774_ = _e1563.unnamed.word;
                                                                    } else {
                                                                        phi_1774_ = _e1563.unnamed.shift;
                                                                    }
                                                                    let _e1720 = phi_1774_;
                                                                    if (_e1716 == 0u) {
                                                                        phi_1784_ = _e1632.unnamed.word;
                                                                    } else {
                                                                        phi_1784_ = _e1632.unnamed.shift;
                                                                    }
                                                                    let _e1729 = phi_1784_;
                                                                    if (_e1716 == 0u) {
                                                                        phi_1794_ = _e1701.unnamed.word;
                                                                    } else {
                                                                        phi_1794_ = _e1701.unnamed.shift;
                                                                    }
                                                                    let _e1738 = phi_1794_;
                                                                    let _e1751 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1720 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u)) * _e1476) + (_e1494 - _e1254)), ((f32(((_e1729 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u)) * _e1477) + (_e1495 - _e1255)));
                                                                    let _e1752 = core_intrinsics_maximum_number_nsz_f32_(_e1751, ((f32(((_e1738 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u)) * _e1478) + (_e1496 - _e1256)));
                                                                    if (_e1716 == 0u) {
                                                                        phi_1812_ = _e1563.unnamed_1.word;
                                                                    } else {
                                                                        phi_1812_ = _e1563.unnamed_1.shift;
                                                                    }
                                                                    let _e1755 = phi_1812_;
                                                                    if (_e1716 == 0u) {
                                                                        phi_1822_ = _e1632.unnamed_1.word;
                                                                    } else {
                                                                        phi_1822_ = _e1632.unnamed_1.shift;
                                                                    }
                                                                    let _e1764 = phi_1822_;
                                                                    if (_e1716 == 0u) {
                                                                        phi_1832_ = _e1701.unnamed_1.word;
                                                                    } else {
                                                                        phi_1832_ = _e1701.unnamed_1.shift;
                                                                    }
                                                                    let _e1773 = phi_1832_;
                                                                    let _e1786 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1755 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u)) * _e1476) + (_e1494 + _e1254)), ((f32(((_e1764 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u)) * _e1477) + (_e1495 + _e1255)));
                                                                    let _e1787 = core_intrinsics_minimum_number_nsz_f32_(_e1786, ((f32(((_e1773 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u)) * _e1478) + (_e1496 + _e1256)));
                                                                    if (_e1752 <= _e1787) {
                                                                        if (_e1752 <= _e123) {
                                                                            if (_e1787 >= 0f) {
                                                                                if (_e1716 == 0u) {
                                                                                    let _e1794 = nodes.member[(0u + _e1442)].links[2u];
                                                                                    phi_1868_ = _e1794;
                                                                                } else {
                                                                                    let _e1797 = nodes.member[(0u + _e1442)].links[3u];
                                                                                    phi_1868_ = _e1797;
                                                                                }
                                                                                let _e1799 = phi_1868_;
                                                                                let _e1804 = ((_e1799 >> bitcast<u32>(((_e1717 * 8u) & 31u))) & 255u);
                                                                                let _e1805 = (_e1804 & 31u);
                                                                                if (_e1805 >= 24u) {
                                                                                    phi_1881_ = (24u + ((_e1805 - 24u) ^ _e1304));
                                                                                } else {
                                                                                    phi_1881_ = _e1805;
                                                                                }
                                                                                let _e1811 = phi_1881_;
                                                                                phi_1886_ = (_e1713 | ((_e1804 >> bitcast<u32>(5i)) << bitcast<u32>((_e1811 & 31u))));
                                                                            } else {
                                                                                phi_1886_ = _e1713;
                                                                            }
                                                                            let _e1819 = phi_1886_;
                                                                            phi_1887_ = _e1819;
                                                                        } else {
                                                                            phi_1887_ = _e1713;
                                                                        }
                                                                        let _e1821 = phi_1887_;
                                                                        phi_1888_ = _e1821;
                                                                    } else {
                                                                        phi_1888_ = _e1713;
                                                                    }
                                                                    let _e1823 = phi_1888_;
                                                                    phi_1758_ = (_e1711 + 1u);
                                                                    phi_1761_ = _e1823;
                                                                } else {
                                                                    phi_1758_ = u32();
                                                                    phi_1761_ = u32();
                                                                }
                                                                let _e1826 = phi_1758_;
                                                                let _e1828 = phi_1761_;
                                                                continue;
                                                                continuing {
                                                                    phi_1757_ = _e1826;
                                                                    phi_1760_ = _e1828;
                                                                    break if !(_e1714);
                                                                }
                                                            }
                                                            let _e1832 = nodes.member[(0u + _e1442)].links[0u];
                                                            let _e1836 = nodes.member[(0u + _e1442)].frame[3u];
                                                            let _e1840 = local_5;
                                                            if ((_e1840 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1844 = local.group_mask;
                                                                if ((_e1844 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1848 = local.len;
                                                                    if (_e1848 < 32u) {
                                                                        let _e1851 = local.group;
                                                                        let _e1853 = local.len;
                                                                        if (_e1853 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1853)] = _e1851;
                                                                        let _e1859 = local.group_mask;
                                                                        let _e1861 = local.len;
                                                                        if (_e1861 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1861)] = _e1859;
                                                                        let _e1868 = local.len;
                                                                        local.len = (_e1868 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1066 + _e1832);
                                                                let _e1872 = local_6;
                                                                local.group_mask = ((_e1872 & 4278190080u) | (_e1836 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1877 = local_7;
                                                            phi_1946_ = (_e1877 & 16777215u);
                                                            phi_1949_ = _e1444;
                                                            loop {
                                                                let _e1880 = phi_1946_;
                                                                let _e1882 = phi_1949_;
                                                                local_12 = _e1882;
                                                                let _e1883 = (_e1880 == 0u);
                                                                local_8 = _e1883;
                                                                local_13 = _e1883;
                                                                if _e1883 {
                                                                    phi_1947_ = u32();
                                                                    phi_1950_ = bool();
                                                                    phi_2547_ = false;
                                                                } else {
                                                                    let _e1886 = nodes.member[(0u + _e1442)].links[1u];
                                                                    let _e1891 = ((_e1068 + _e1886) + select(firstTrailingBit(_e1880), 32u, (_e1880 == 0u)));
                                                                    if (_e1891 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1898 = triangles.member[(0u + _e1891)].v0_;
                                                                    let _e1900 = (_e1898.x - _e997);
                                                                    let _e1902 = (_e1898.y - _e1010);
                                                                    let _e1904 = (_e1898.z - _e1023);
                                                                    if (_e1277 == 0u) {
                                                                        phi_1994_ = vec3<f32>(_e1902, _e1904, _e1900);
                                                                    } else {
                                                                        if (_e1277 == 1u) {
                                                                            phi_1993_ = vec3<f32>(_e1904, _e1900, _e1902);
                                                                        } else {
                                                                            phi_1993_ = (_e1898 - vec3<f32>(_e997, _e1010, _e1023));
                                                                        }
                                                                        let _e1912 = phi_1993_;
                                                                        phi_1994_ = _e1912;
                                                                    }
                                                                    let _e1914 = phi_1994_;
                                                                    let _e1918 = (_e1914.x - (_e1288 * _e1914.z));
                                                                    let _e1922 = (_e1914.y - (_e1291 * _e1914.z));
                                                                    let _e1924 = triangles.member[(0u + _e1891)].v1_;
                                                                    let _e1926 = (_e1924.x - _e997);
                                                                    let _e1928 = (_e1924.y - _e1010);
                                                                    let _e1930 = (_e1924.z - _e1023);
                                                                    if (_e1277 == 0u) {
                                                                        phi_2024_ = vec3<f32>(_e1928, _e1930, _e1926);
                                                                    } else {
                                                                        if (_e1277 == 1u) {
                                                                            phi_2023_ = vec3<f32>(_e1930, _e1926, _e1928);
                                                                        } else {
                                                                            phi_2023_ = (_e1924 - vec3<f32>(_e997, _e1010, _e1023));
                                                                        }
                                                                        let _e1938 = phi_2023_;
                                                                        phi_2024_ = _e1938;
                                                                    }
                                                                    let _e1940 = phi_2024_;
                                                                    let _e1944 = (_e1940.x - (_e1288 * _e1940.z));
                                                                    let _e1948 = (_e1940.y - (_e1291 * _e1940.z));
                                                                    let _e1950 = triangles.member[(0u + _e1891)].v2_;
                                                                    let _e1952 = (_e1950.x - _e997);
                                                                    let _e1954 = (_e1950.y - _e1010);
                                                                    let _e1956 = (_e1950.z - _e1023);
                                                                    if (_e1277 == 0u) {
                                                                        phi_2054_ = vec3<f32>(_e1954, _e1956, _e1952);
                                                                    } else {
                                                                        if (_e1277 == 1u) {
                                                                            phi_2053_ = vec3<f32>(_e1956, _e1952, _e1954);
                                                                        } else {
                                                                            phi_2053_ = (_e1950 - vec3<f32>(_e997, _e1010, _e1023));
                                                                        }
                                                                        let _e1964 = phi_2053_;
                                                                        phi_2054_ = _e1964;
                                                                    }
                                                                    let _e1966 = phi_2054_;
                                                                    let _e1970 = (_e1966.x - (_e1288 * _e1966.z));
                                                                    let _e1974 = (_e1966.y - (_e1291 * _e1966.z));
                                                                    if (_e1944 < _e1970) {
                                                                        phi_2073_ = true;
                                                                    } else {
                                                                        if (_e1944 == _e1970) {
                                                                            phi_2072_ = (_e1948 < _e1974);
                                                                        } else {
                                                                            phi_2072_ = false;
                                                                        }
                                                                        let _e1979 = phi_2072_;
                                                                        phi_2073_ = _e1979;
                                                                    }
                                                                    let _e1981 = phi_2073_;
                                                                    if _e1981 {
                                                                        phi_2077_ = _e1974;
                                                                        phi_2078_ = _e1970;
                                                                        phi_2079_ = _e1948;
                                                                        phi_2080_ = _e1944;
                                                                    } else {
                                                                        phi_2077_ = _e1948;
                                                                        phi_2078_ = _e1944;
                                                                        phi_2079_ = _e1974;
                                                                        phi_2080_ = _e1970;
                                                                    }
                                                                    let _e1983 = phi_2077_;
                                                                    let _e1985 = phi_2078_;
                                                                    let _e1987 = phi_2079_;
                                                                    let _e1989 = phi_2080_;
                                                                    let _e1992 = ((_e1989 * _e1983) - (_e1987 * _e1985));
                                                                    if _e1981 {
                                                                        phi_2088_ = -(_e1992);
                                                                    } else {
                                                                        phi_2088_ = _e1992;
                                                                    }
                                                                    let _e1995 = phi_2088_;
                                                                    if (_e1970 < _e1918) {
                                                                        phi_2099_ = true;
                                                                    } else {
                                                                        if (_e1970 == _e1918) {
                                                                            phi_2098_ = (_e1974 < _e1922);
                                                                        } else {
                                                                            phi_2098_ = false;
                                                                        }
                                                                        let _e2000 = phi_2098_;
                                                                        phi_2099_ = _e2000;
                                                                    }
                                                                    let _e2002 = phi_2099_;
                                                                    if _e2002 {
                                                                        phi_2103_ = _e1922;
                                                                        phi_2104_ = _e1918;
                                                                        phi_2105_ = _e1974;
                                                                        phi_2106_ = _e1970;
                                                                    } else {
                                                                        phi_2103_ = _e1974;
                                                                        phi_2104_ = _e1970;
                                                                        phi_2105_ = _e1922;
                                                                        phi_2106_ = _e1918;
                                                                    }
                                                                    let _e2004 = phi_2103_;
                                                                    let _e2006 = phi_2104_;
                                                                    let _e2008 = phi_2105_;
                                                                    let _e2010 = phi_2106_;
                                                                    let _e2013 = ((_e2010 * _e2004) - (_e2008 * _e2006));
                                                                    if _e2002 {
                                                                        phi_2114_ = -(_e2013);
                                                                    } else {
                                                                        phi_2114_ = _e2013;
                                                                    }
                                                                    let _e2016 = phi_2114_;
                                                                    if (_e1918 < _e1944) {
                                                                        phi_2125_ = true;
                                                                    } else {
                                                                        if (_e1918 == _e1944) {
                                                                            phi_2124_ = (_e1922 < _e1948);
                                                                        } else {
                                                                            phi_2124_ = false;
                                                                        }
                                                                        let _e2021 = phi_2124_;
                                                                        phi_2125_ = _e2021;
                                                                    }
                                                                    let _e2023 = phi_2125_;
                                                                    if _e2023 {
                                                                        phi_2129_ = _e1948;
                                                                        phi_2130_ = _e1944;
                                                                        phi_2131_ = _e1922;
                                                                        phi_2132_ = _e1918;
                                                                    } else {
                                                                        phi_2129_ = _e1922;
                                                                        phi_2130_ = _e1918;
                                                                        phi_2131_ = _e1948;
                                                                        phi_2132_ = _e1944;
                                                                    }
                                                                    let _e2025 = phi_2129_;
                                                                    let _e2027 = phi_2130_;
                                                                    let _e2029 = phi_2131_;
                                                                    let _e2031 = phi_2132_;
                                                                    let _e2034 = ((_e2031 * _e2025) - (_e2029 * _e2027));
                                                                    if _e2023 {
                                                                        phi_2140_ = -(_e2034);
                                                                    } else {
                                                                        phi_2140_ = _e2034;
                                                                    }
                                                                    let _e2037 = phi_2140_;
                                                                    if (_e1995 >= 0f) {
                                                                        if (_e2016 >= 0f) {
                                                                            if (_e2037 >= 0f) {
                                                                                phi_2155_ = ((_e1995 + _e2016) + _e2037);
                                                                                phi_2156_ = false;
                                                                            } else {
                                                                                phi_2155_ = f32();
                                                                                phi_2156_ = true;
                                                                            }
                                                                            let _e2044 = phi_2155_;
                                                                            let _e2046 = phi_2156_;
                                                                            phi_2157_ = _e2044;
                                                                            phi_2158_ = _e2046;
                                                                        } else {
                                                                            phi_2157_ = f32();
                                                                            phi_2158_ = true;
                                                                        }
                                                                        let _e2048 = phi_2157_;
                                                                        let _e2050 = phi_2158_;
                                                                        phi_2159_ = _e2048;
                                                                        phi_2160_ = _e2050;
                                                                    } else {
                                                                        phi_2159_ = f32();
                                                                        phi_2160_ = true;
                                                                    }
                                                                    let _e2052 = phi_2159_;
                                                                    let _e2054 = phi_2160_;
                                                                    if _e2054 {
                                                                        if (_e1995 <= 0f) {
                                                                            if (_e2016 <= 0f) {
                                                                                let _e2057 = (_e2037 <= 0f);
                                                                                if _e2057 {
                                                                                }
                                                                                phi_2178_ = ((_e1995 + _e2016) + _e2037);
                                                                                phi_2179_ = false;
                                                                                phi_2180_ = _e2057;
                                                                            } else {
                                                                                phi_2178_ = f32();
                                                                                phi_2179_ = true;
                                                                                phi_2180_ = false;
                                                                            }
                                                                            let _e2061 = phi_2178_;
                                                                            let _e2063 = phi_2179_;
                                                                            let _e2065 = phi_2180_;
                                                                            phi_2181_ = _e2061;
                                                                            phi_2182_ = _e2063;
                                                                            phi_2183_ = _e2065;
                                                                        } else {
                                                                            phi_2181_ = f32();
                                                                            phi_2182_ = true;
                                                                            phi_2183_ = false;
                                                                        }
                                                                        let _e2067 = phi_2181_;
                                                                        let _e2069 = phi_2182_;
                                                                        let _e2071 = phi_2183_;
                                                                        if _e2069 {
                                                                            phi_2187_ = false;
                                                                        } else {
                                                                            phi_2187_ = _e2071;
                                                                        }
                                                                        let _e2073 = phi_2187_;
                                                                        phi_2188_ = _e2067;
                                                                        phi_2189_ = _e2073;
                                                                    } else {
                                                                        phi_2188_ = _e2052;
                                                                        phi_2189_ = true;
                                                                    }
                                                                    let _e2075 = phi_2188_;
                                                                    let _e2077 = phi_2189_;
                                                                    if _e2077 {
                                                                        let _e2078 = (_e2075 == 0f);
                                                                        if _e2078 {
                                                                            phi_2505_ = lt_bvh_triangle_Intersection();
                                                                            phi_2506_ = false;
                                                                        } else {
                                                                            let _e2080 = triangles.member[(0u + _e1891)].v0_;
                                                                            let _e2082 = (_e2080.x - _e997);
                                                                            let _e2084 = (_e2080.y - _e1010);
                                                                            let _e2086 = (_e2080.z - _e1023);
                                                                            if (_e1277 == 0u) {
                                                                                phi_2218_ = vec3<f32>(_e2084, _e2086, _e2082);
                                                                            } else {
                                                                                if (_e1277 == 1u) {
                                                                                    phi_2217_ = vec3<f32>(_e2086, _e2082, _e2084);
                                                                                } else {
                                                                                    phi_2217_ = (_e2080 - vec3<f32>(_e997, _e1010, _e1023));
                                                                                }
                                                                                let _e2094 = phi_2217_;
                                                                                phi_2218_ = _e2094;
                                                                            }
                                                                            let _e2096 = phi_2218_;
                                                                            let _e2098 = triangles.member[(0u + _e1891)].v1_;
                                                                            let _e2100 = triangles.member[(0u + _e1891)].v0_;
                                                                            let _e2103 = (_e2098.x - _e2100.x);
                                                                            let _e2106 = (_e2098.y - _e2100.y);
                                                                            let _e2109 = (_e2098.z - _e2100.z);
                                                                            if (_e1277 == 0u) {
                                                                                phi_2244_ = vec3<f32>(_e2106, _e2109, _e2103);
                                                                            } else {
                                                                                if (_e1277 == 1u) {
                                                                                    phi_2243_ = vec3<f32>(_e2109, _e2103, _e2106);
                                                                                } else {
                                                                                    phi_2243_ = (_e2098 - _e2100);
                                                                                }
                                                                                let _e2116 = phi_2243_;
                                                                                phi_2244_ = _e2116;
                                                                            }
                                                                            let _e2118 = phi_2244_;
                                                                            let _e2120 = triangles.member[(0u + _e1891)].v2_;
                                                                            let _e2122 = triangles.member[(0u + _e1891)].v0_;
                                                                            let _e2125 = (_e2120.x - _e2122.x);
                                                                            let _e2128 = (_e2120.y - _e2122.y);
                                                                            let _e2131 = (_e2120.z - _e2122.z);
                                                                            if (_e1277 == 0u) {
                                                                                phi_2270_ = vec3<f32>(_e2128, _e2131, _e2125);
                                                                            } else {
                                                                                if (_e1277 == 1u) {
                                                                                    phi_2269_ = vec3<f32>(_e2131, _e2125, _e2128);
                                                                                } else {
                                                                                    phi_2269_ = (_e2120 - _e2122);
                                                                                }
                                                                                let _e2138 = phi_2269_;
                                                                                phi_2270_ = _e2138;
                                                                            }
                                                                            let _e2140 = phi_2270_;
                                                                            let _e2147 = ((_e2118.y * _e2140.z) - (_e2118.z * _e2140.y));
                                                                            let _e2154 = ((_e2118.z * _e2140.x) - (_e2118.x * _e2140.z));
                                                                            let _e2161 = ((_e2118.x * _e2140.y) - (_e2118.y * _e2140.x));
                                                                            let _e2175 = (((1f / _e1285.z) * (((_e2147 * _e2096.x) + (_e2154 * _e2096.y)) + (_e2161 * _e2096.z))) / (((_e2147 * _e1288) + (_e2154 * _e1291)) + _e2161));
                                                                            if (_e2175 > 0f) {
                                                                                if (_e2175 < _e123) {
                                                                                    let _e2179 = triangles.member[(0u + _e1891)].v0_;
                                                                                    let _e2181 = triangles.member[(0u + _e1891)].v1_;
                                                                                    if (_e2179.x < _e2181.x) {
                                                                                        phi_2326_ = _e2179.x;
                                                                                    } else {
                                                                                        phi_2326_ = _e2181.x;
                                                                                    }
                                                                                    let _e2188 = phi_2326_;
                                                                                    if (_e2179.y < _e2181.y) {
                                                                                        phi_2335_ = _e2179.y;
                                                                                    } else {
                                                                                        phi_2335_ = _e2181.y;
                                                                                    }
                                                                                    let _e2195 = phi_2335_;
                                                                                    if (_e2179.z < _e2181.z) {
                                                                                        phi_2344_ = _e2179.z;
                                                                                    } else {
                                                                                        phi_2344_ = _e2181.z;
                                                                                    }
                                                                                    let _e2202 = phi_2344_;
                                                                                    let _e2204 = triangles.member[(0u + _e1891)].v2_;
                                                                                    if (_e2188 < _e2204.x) {
                                                                                        phi_2353_ = _e2188;
                                                                                    } else {
                                                                                        phi_2353_ = _e2204.x;
                                                                                    }
                                                                                    let _e2209 = phi_2353_;
                                                                                    if (_e2195 < _e2204.y) {
                                                                                        phi_2360_ = _e2195;
                                                                                    } else {
                                                                                        phi_2360_ = _e2204.y;
                                                                                    }
                                                                                    let _e2214 = phi_2360_;
                                                                                    if (_e2202 < _e2204.z) {
                                                                                        phi_2367_ = _e2202;
                                                                                    } else {
                                                                                        phi_2367_ = _e2204.z;
                                                                                    }
                                                                                    let _e2219 = phi_2367_;
                                                                                    let _e2221 = triangles.member[(0u + _e1891)].v0_;
                                                                                    let _e2223 = triangles.member[(0u + _e1891)].v1_;
                                                                                    if (_e2221.x > _e2223.x) {
                                                                                        phi_2380_ = _e2221.x;
                                                                                    } else {
                                                                                        phi_2380_ = _e2223.x;
                                                                                    }
                                                                                    let _e2230 = phi_2380_;
                                                                                    if (_e2221.y > _e2223.y) {
                                                                                        phi_2389_ = _e2221.y;
                                                                                    } else {
                                                                                        phi_2389_ = _e2223.y;
                                                                                    }
                                                                                    let _e2237 = phi_2389_;
                                                                                    if (_e2221.z > _e2223.z) {
                                                                                        phi_2398_ = _e2221.z;
                                                                                    } else {
                                                                                        phi_2398_ = _e2223.z;
                                                                                    }
                                                                                    let _e2244 = phi_2398_;
                                                                                    let _e2246 = triangles.member[(0u + _e1891)].v2_;
                                                                                    if (_e2230 > _e2246.x) {
                                                                                        phi_2407_ = _e2230;
                                                                                    } else {
                                                                                        phi_2407_ = _e2246.x;
                                                                                    }
                                                                                    let _e2251 = phi_2407_;
                                                                                    if (_e2237 > _e2246.y) {
                                                                                        phi_2414_ = _e2237;
                                                                                    } else {
                                                                                        phi_2414_ = _e2246.y;
                                                                                    }
                                                                                    let _e2256 = phi_2414_;
                                                                                    if (_e2244 > _e2246.z) {
                                                                                        phi_2421_ = _e2244;
                                                                                    } else {
                                                                                        phi_2421_ = _e2246.z;
                                                                                    }
                                                                                    let _e2261 = phi_2421_;
                                                                                    let _e2265 = ((_e2209 - _e997) * _e1206);
                                                                                    let _e2266 = ((_e2214 - _e1010) * _e1216);
                                                                                    let _e2267 = ((_e2219 - _e1023) * _e1226);
                                                                                    let _e2271 = ((_e2251 - _e997) * _e1206);
                                                                                    let _e2272 = ((_e2256 - _e1010) * _e1216);
                                                                                    let _e2273 = ((_e2261 - _e1023) * _e1226);
                                                                                    if (_e2265 < _e2271) {
                                                                                        phi_2438_ = _e2265;
                                                                                    } else {
                                                                                        phi_2438_ = _e2271;
                                                                                    }
                                                                                    let _e2276 = phi_2438_;
                                                                                    if (_e2266 < _e2272) {
                                                                                        phi_2443_ = _e2266;
                                                                                    } else {
                                                                                        phi_2443_ = _e2272;
                                                                                    }
                                                                                    let _e2279 = phi_2443_;
                                                                                    if (_e2267 < _e2273) {
                                                                                        phi_2448_ = _e2267;
                                                                                    } else {
                                                                                        phi_2448_ = _e2273;
                                                                                    }
                                                                                    let _e2282 = phi_2448_;
                                                                                    if (_e2265 > _e2271) {
                                                                                        phi_2456_ = _e2265;
                                                                                    } else {
                                                                                        phi_2456_ = _e2271;
                                                                                    }
                                                                                    let _e2288 = phi_2456_;
                                                                                    if (_e2266 > _e2272) {
                                                                                        phi_2461_ = _e2266;
                                                                                    } else {
                                                                                        phi_2461_ = _e2272;
                                                                                    }
                                                                                    let _e2291 = phi_2461_;
                                                                                    if (_e2267 > _e2273) {
                                                                                        phi_2466_ = _e2267;
                                                                                    } else {
                                                                                        phi_2466_ = _e2273;
                                                                                    }
                                                                                    let _e2294 = phi_2466_;
                                                                                    let _e2298 = core_intrinsics_maximum_number_nsz_f32_((_e2276 - _e1261), (_e2279 - _e1262));
                                                                                    let _e2299 = core_intrinsics_maximum_number_nsz_f32_(_e2298, (_e2282 - _e1263));
                                                                                    let _e2300 = core_intrinsics_minimum_number_nsz_f32_((_e2288 + _e1261), (_e2291 + _e1262));
                                                                                    let _e2301 = core_intrinsics_minimum_number_nsz_f32_(_e2300, (_e2294 + _e1263));
                                                                                    if (_e2299 > _e978) {
                                                                                        phi_2478_ = _e2299;
                                                                                    } else {
                                                                                        phi_2478_ = _e978;
                                                                                    }
                                                                                    let _e2304 = phi_2478_;
                                                                                    if (_e2301 < _e980) {
                                                                                        phi_2483_ = _e2301;
                                                                                    } else {
                                                                                        phi_2483_ = _e980;
                                                                                    }
                                                                                    let _e2307 = phi_2483_;
                                                                                    if (_e2175 < _e2304) {
                                                                                        phi_2488_ = _e2304;
                                                                                    } else {
                                                                                        phi_2488_ = _e2175;
                                                                                    }
                                                                                    let _e2310 = phi_2488_;
                                                                                    if (_e2310 > _e2307) {
                                                                                        phi_2493_ = _e2307;
                                                                                    } else {
                                                                                        phi_2493_ = _e2310;
                                                                                    }
                                                                                    let _e2313 = phi_2493_;
                                                                                    phi_2498_ = lt_bvh_triangle_Intersection(_e2313, (_e2016 / _e2075), (_e2037 / _e2075), (_e2304 <= _e2307));
                                                                                    phi_2499_ = false;
                                                                                } else {
                                                                                    phi_2498_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2499_ = true;
                                                                                }
                                                                                let _e2319 = phi_2498_;
                                                                                let _e2321 = phi_2499_;
                                                                                phi_2500_ = _e2319;
                                                                                phi_2501_ = _e2321;
                                                                            } else {
                                                                                phi_2500_ = lt_bvh_triangle_Intersection();
                                                                                phi_2501_ = true;
                                                                            }
                                                                            let _e2323 = phi_2500_;
                                                                            let _e2325 = phi_2501_;
                                                                            if _e2325 {
                                                                            }
                                                                            phi_2505_ = _e2323;
                                                                            phi_2506_ = _e2325;
                                                                        }
                                                                        let _e2327 = phi_2505_;
                                                                        let _e2329 = phi_2506_;
                                                                        phi_2507_ = _e2327;
                                                                        phi_2508_ = _e2078;
                                                                        phi_2509_ = _e2329;
                                                                    } else {
                                                                        phi_2507_ = lt_bvh_triangle_Intersection();
                                                                        phi_2508_ = true;
                                                                        phi_2509_ = false;
                                                                    }
                                                                    let _e2331 = phi_2507_;
                                                                    let _e2333 = phi_2508_;
                                                                    let _e2335 = phi_2509_;
                                                                    if _e2333 {
                                                                        phi_2513_ = true;
                                                                    } else {
                                                                        phi_2513_ = _e2335;
                                                                    }
                                                                    let _e2337 = phi_2513_;
                                                                    if _e2337 {
                                                                        phi_2517_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2517_ = _e2331;
                                                                    }
                                                                    let _e2339 = phi_2517_;
                                                                    if _e2339.is_hit {
                                                                        if (_e2339.t > 0f) {
                                                                            if (_e2339.t < _e123) {
                                                                                if true {
                                                                                    phi_2537_ = false;
                                                                                } else {
                                                                                    phi_2537_ = true;
                                                                                }
                                                                                let _e2348 = phi_2537_;
                                                                                phi_2538_ = true;
                                                                                phi_2539_ = _e2348;
                                                                            } else {
                                                                                phi_2538_ = _e1882;
                                                                                phi_2539_ = true;
                                                                            }
                                                                            let _e2350 = phi_2538_;
                                                                            let _e2352 = phi_2539_;
                                                                            phi_2540_ = _e2350;
                                                                            phi_2541_ = _e2352;
                                                                        } else {
                                                                            phi_2540_ = _e1882;
                                                                            phi_2541_ = true;
                                                                        }
                                                                        let _e2354 = phi_2540_;
                                                                        let _e2356 = phi_2541_;
                                                                        phi_2542_ = _e2354;
                                                                        phi_2543_ = _e2356;
                                                                    } else {
                                                                        phi_2542_ = _e1882;
                                                                        phi_2543_ = true;
                                                                    }
                                                                    let _e2358 = phi_2542_;
                                                                    let _e2360 = phi_2543_;
                                                                    if _e2360 {
                                                                    }
                                                                    phi_1947_ = (_e1880 & (_e1880 - 1u));
                                                                    phi_1950_ = _e2358;
                                                                    phi_2547_ = _e2360;
                                                                }
                                                                let _e2362 = phi_1947_;
                                                                let _e2364 = phi_1950_;
                                                                let _e2366 = phi_2547_;
                                                                continue;
                                                                continuing {
                                                                    phi_1946_ = _e2362;
                                                                    phi_1949_ = _e2364;
                                                                    break if !(_e2366);
                                                                }
                                                            }
                                                            let _e2369 = local_8;
                                                            if _e2369 {
                                                                let _e2371 = local.group_mask;
                                                                if ((_e2371 & 4278190080u) == 0u) {
                                                                    let _e2375 = local.len;
                                                                    if (_e2375 == 0u) {
                                                                        phi_2589_ = false;
                                                                    } else {
                                                                        let _e2379 = local.len;
                                                                        local.len = (_e2379 - 1u);
                                                                        let _e2382 = local.len;
                                                                        if (_e2382 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2387 = local.first[(0u + _e2382)];
                                                                        local.group = _e2387;
                                                                        let _e2390 = local.len;
                                                                        if (_e2390 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2395 = local.mask[(0u + _e2390)];
                                                                        local.group_mask = _e2395;
                                                                        phi_2589_ = true;
                                                                    }
                                                                    let _e2398 = phi_2589_;
                                                                    phi_2590_ = _e2398;
                                                                } else {
                                                                    phi_2590_ = true;
                                                                }
                                                                let _e2400 = phi_2590_;
                                                                if _e2400 {
                                                                    let _e2402 = local.group_mask;
                                                                    let _e2408 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2402)), 32u, (_e2402 == 0u)));
                                                                    let _e2412 = local.group_mask;
                                                                    let _e2426 = local.group_mask;
                                                                    local.group_mask = (_e2426 & ~((1u << bitcast<u32>((_e2408 & 31u)))));
                                                                    let _e2429 = local.group;
                                                                    phi_2621_ = (_e2429 + countOneBits(((_e2412 & ~((4294967295u << bitcast<u32>((((_e2408 - 24u) ^ _e1304) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2621_ = 4294967295u;
                                                                }
                                                                let _e2432 = phi_2621_;
                                                                phi_2622_ = _e2432;
                                                            } else {
                                                                phi_2622_ = u32();
                                                            }
                                                            let _e2434 = phi_2622_;
                                                            phi_1615_ = _e2434;
                                                            let _e2904 = local_12;
                                                            phi_1618_ = _e2904;
                                                            let _e2907 = local_13;
                                                            phi_2623_ = _e2907;
                                                            phi_2624_ = false;
                                                        } else {
                                                            phi_1615_ = u32();
                                                            phi_1618_ = bool();
                                                            phi_2623_ = false;
                                                            phi_2624_ = true;
                                                        }
                                                        let _e2436 = phi_1615_;
                                                        let _e2438 = phi_1618_;
                                                        let _e2440 = phi_2623_;
                                                        let _e2442 = phi_2624_;
                                                        local_9 = _e2442;
                                                        continue;
                                                        continuing {
                                                            phi_1614_ = _e2436;
                                                            phi_1617_ = _e2438;
                                                            break if !(_e2440);
                                                        }
                                                    }
                                                    let _e2445 = local_9;
                                                    if _e2445 {
                                                        phi_2628_ = false;
                                                    } else {
                                                        phi_2628_ = true;
                                                    }
                                                    let _e2447 = phi_2628_;
                                                    if _e2447 {
                                                        phi_2632_ = true;
                                                    } else {
                                                        let _e2913 = local_14;
                                                        phi_2632_ = _e2913;
                                                    }
                                                    let _e2449 = phi_2632_;
                                                    phi_2633_ = _e2449;
                                                }
                                                let _e2451 = phi_2633_;
                                                phi_2634_ = _e2451;
                                                phi_2635_ = _e1130;
                                            } else {
                                                phi_2634_ = bool();
                                                phi_2635_ = true;
                                            }
                                            let _e2453 = phi_2634_;
                                            let _e2455 = phi_2635_;
                                            if _e2455 {
                                                phi_2639_ = _e917;
                                            } else {
                                                phi_2639_ = _e2453;
                                            }
                                            let _e2457 = phi_2639_;
                                            if _e2457 {
                                                phi_2643_ = false;
                                            } else {
                                                phi_2643_ = true;
                                            }
                                            let _e2459 = phi_2643_;
                                            phi_2644_ = _e2457;
                                            phi_2645_ = _e2459;
                                        } else {
                                            phi_2644_ = _e917;
                                            phi_2645_ = true;
                                        }
                                        let _e2461 = phi_2644_;
                                        let _e2463 = phi_2645_;
                                        phi_2646_ = _e2461;
                                        phi_2647_ = _e2463;
                                    } else {
                                        phi_2646_ = _e917;
                                        phi_2647_ = true;
                                    }
                                    let _e2465 = phi_2646_;
                                    let _e2467 = phi_2647_;
                                    phi_2648_ = _e2465;
                                    phi_2649_ = _e2467;
                                } else {
                                    phi_2648_ = _e917;
                                    phi_2649_ = true;
                                }
                                let _e2469 = phi_2648_;
                                let _e2471 = phi_2649_;
                                if _e2471 {
                                }
                                phi_1007_ = (_e915 & (_e915 - 1u));
                                phi_1010_ = _e2469;
                                phi_2653_ = _e2471;
                            }
                            let _e2473 = phi_1007_;
                            let _e2475 = phi_1010_;
                            let _e2477 = phi_2653_;
                            continue;
                            continuing {
                                phi_1006_ = _e2473;
                                phi_1009_ = _e2475;
                                break if !(_e2477);
                            }
                        }
                        let _e2480 = local_10;
                        if _e2480 {
                            let _e2482 = local_1.group_mask;
                            if ((_e2482 & 4278190080u) == 0u) {
                                let _e2486 = local_1.len;
                                if (_e2486 == 0u) {
                                    phi_2695_ = false;
                                } else {
                                    let _e2490 = local_1.len;
                                    local_1.len = (_e2490 - 1u);
                                    let _e2493 = local_1.len;
                                    if (_e2493 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2498 = local_1.first[(0u + _e2493)];
                                    local_1.group = _e2498;
                                    let _e2501 = local_1.len;
                                    if (_e2501 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2506 = local_1.mask[(0u + _e2501)];
                                    local_1.group_mask = _e2506;
                                    phi_2695_ = true;
                                }
                                let _e2509 = phi_2695_;
                                phi_2696_ = _e2509;
                            } else {
                                phi_2696_ = true;
                            }
                            let _e2511 = phi_2696_;
                            if _e2511 {
                                let _e2513 = local_1.group_mask;
                                let _e2519 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2513)), 32u, (_e2513 == 0u)));
                                let _e2523 = local_1.group_mask;
                                let _e2537 = local_1.group_mask;
                                local_1.group_mask = (_e2537 & ~((1u << bitcast<u32>((_e2519 & 31u)))));
                                let _e2540 = local_1.group;
                                phi_2727_ = (_e2540 + countOneBits(((_e2523 & ~((4294967295u << bitcast<u32>((((_e2519 - 24u) ^ _e339) & 31u))))) & 255u)));
                            } else {
                                phi_2727_ = 4294967295u;
                            }
                            let _e2543 = phi_2727_;
                            phi_2728_ = _e2543;
                        } else {
                            phi_2728_ = u32();
                        }
                        let _e2545 = phi_2728_;
                        phi_675_ = _e2545;
                        let _e2936 = local_15;
                        phi_678_ = _e2936;
                        let _e2939 = local_16;
                        phi_2729_ = _e2939;
                        phi_2730_ = false;
                    } else {
                        phi_675_ = u32();
                        phi_678_ = bool();
                        phi_2729_ = false;
                        phi_2730_ = true;
                    }
                    let _e2547 = phi_675_;
                    let _e2549 = phi_678_;
                    let _e2551 = phi_2729_;
                    let _e2553 = phi_2730_;
                    local_11 = _e2553;
                    continue;
                    continuing {
                        phi_674_ = _e2547;
                        phi_677_ = _e2549;
                        break if !(_e2551);
                    }
                }
                let _e2556 = local_11;
                if _e2556 {
                    phi_2734_ = false;
                } else {
                    phi_2734_ = true;
                }
                let _e2558 = phi_2734_;
                if _e2558 {
                }
                phi_2738_ = _e2558;
            }
            let _e2560 = phi_2738_;
            phi_2739_ = _e195;
            phi_2740_ = _e2560;
        } else {
            phi_2739_ = true;
            phi_2740_ = false;
        }
        let _e2562 = phi_2739_;
        let _e2564 = phi_2740_;
        if _e2562 {
            phi_2744_ = false;
            phi_2745_ = true;
        } else {
            phi_2744_ = true;
            phi_2745_ = _e2564;
        }
        let _e2566 = phi_2744_;
        let _e2568 = phi_2745_;
        if _e2568 {
            phi_2749_ = _e2566;
        } else {
            phi_2749_ = false;
        }
        let _e2570 = phi_2749_;
        if _e2570 {
            phi_2753_ = 0f;
        } else {
            phi_2753_ = 1f;
        }
        let _e2572 = phi_2753_;
        if (_e91 < _e69) {
        } else {
            return;
        }
        visibility.member[(0u + _e91)] = _e2572;
        let _e2578 = p.member.light.number;
        let _e2579 = (_e2578 * 3u);
        let _e2580 = (_e2579 / 32u);
        let _e2581 = (_e2579 % 32u);
        let _e2583 = p.member.light.mask_words;
        if (_e91 < _e69) {
        } else {
            return;
        }
        let _e2587 = visibility.member[(0u + _e91)];
        let _e2589 = ((_e91 * _e2583) + _e2580);
        if (_e2581 > 29u) {
            let _e2591 = (_e2589 + 1u);
            if (_e2591 < _e75) {
            } else {
                return;
            }
            let _e2595 = bits.member[(0u + _e2591)];
            phi_2794_ = _e2595;
        } else {
            phi_2794_ = 0u;
        }
        let _e2597 = phi_2794_;
        if (_e2589 < _e75) {
        } else {
            return;
        }
        let _e2601 = bits.member[(0u + _e2589)];
        let _e2604 = (_e2601 >> bitcast<u32>((_e2581 & 31u)));
        if (_e2581 > 29u) {
            phi_2813_ = (_e2604 | (_e2597 << bitcast<u32>(((32u - _e2581) & 31u))));
        } else {
            phi_2813_ = _e2604;
        }
        let _e2612 = phi_2813_;
        if ((_e2612 & 2u) == 0u) {
            phi_2821_ = (_e2612 & 1u);
        } else {
            phi_2821_ = (_e2612 & 7u);
        }
        let _e2618 = phi_2821_;
        if ((_e2618 & 1u) != 0u) {
            phi_2829_ = (2u | 1u);
        } else {
            phi_2829_ = 2u;
        }
        let _e2624 = phi_2829_;
        if (_e2587 < 0.5f) {
            phi_2834_ = (_e2624 | 4u);
        } else {
            phi_2834_ = _e2624;
        }
        let _e2627 = phi_2834_;
        let _e2629 = ((_e91 * _e2583) + _e2580);
        if (_e2629 < _e75) {
        } else {
            return;
        }
        let _e2633 = bits.member[(0u + _e2629)];
        if (_e2629 < _e75) {
        } else {
            return;
        }
        bits.member[(0u + _e2629)] = ((_e2633 & ~((7u << bitcast<u32>((_e2581 & 31u))))) | (_e2627 << bitcast<u32>((_e2581 & 31u))));
        if (_e2581 > 29u) {
            let _e2647 = (_e2629 + 1u);
            if (_e2647 < _e75) {
            } else {
                return;
            }
            let _e2651 = bits.member[(0u + _e2647)];
            let _e2652 = (32u - _e2581);
            let _e2662 = (_e2629 + 1u);
            if (_e2662 < _e75) {
            } else {
                return;
            }
            bits.member[(0u + _e2662)] = ((_e2651 & ~((7u >> bitcast<u32>((_e2652 & 31u))))) | (_e2627 >> bitcast<u32>((_e2652 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
