struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

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

struct type_31 {
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

struct type_38 {
    member: array<lt_bvh_Instance>,
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_53 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(2) 
var<storage> nodes: type_47;
@group(0) @binding(3) 
var<storage> triangles: type_31;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_38;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_166_: bool;
    var phi_170_: f32;

    if (param != param) {
        phi_166_ = true;
    } else {
        let _e56 = (param_1 >= param);
        if _e56 {
        }
        phi_166_ = _e56;
    }
    let _e58 = phi_166_;
    if _e58 {
        phi_170_ = param_1;
    } else {
        phi_170_ = param;
    }
    let _e60 = phi_170_;
    return _e60;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_182_: bool;
    var phi_186_: f32;

    if (param_2 != param_2) {
        phi_182_ = true;
    } else {
        let _e56 = (param_3 <= param_2);
        if _e56 {
        }
        phi_182_ = _e56;
    }
    let _e58 = phi_182_;
    if _e58 {
        phi_186_ = param_3;
    } else {
        phi_186_ = param_2;
    }
    let _e60 = phi_186_;
    return _e60;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_271_: f32;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
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
    var phi_354_: bool;
    var phi_358_: bool;
    var phi_428_: f32;
    var phi_435_: f32;
    var phi_442_: f32;
    var phi_449_: f32;
    var phi_456_: f32;
    var phi_463_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_511_: u32;
    var phi_516_: u32;
    var phi_521_: u32;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_667_: u32;
    var phi_669_: u32;
    var phi_750_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_777_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_804_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_810_: u32;
    var phi_813_: u32;
    var phi_827_: u32;
    var phi_837_: u32;
    var phi_847_: u32;
    var phi_865_: u32;
    var phi_875_: u32;
    var phi_885_: u32;
    var phi_921_: u32;
    var phi_934_: u32;
    var phi_939_: u32;
    var phi_940_: u32;
    var phi_941_: u32;
    var phi_811_: u32;
    var phi_814_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_999_: u32;
    var phi_1049_: f32;
    var phi_1054_: f32;
    var phi_1059_: f32;
    var phi_1067_: f32;
    var phi_1072_: f32;
    var phi_1077_: f32;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1248_: bool;
    var phi_1252_: bool;
    var phi_1322_: f32;
    var phi_1329_: f32;
    var phi_1336_: f32;
    var phi_1343_: f32;
    var phi_1350_: f32;
    var phi_1357_: f32;
    var phi_1374_: f32;
    var phi_1379_: f32;
    var phi_1384_: f32;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1421_: u32;
    var phi_1422_: u32;
    var phi_1433_: vec3<f32>;
    var phi_1434_: vec3<f32>;
    var phi_1447_: u32;
    var phi_1452_: u32;
    var phi_1457_: u32;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1603_: u32;
    var phi_1605_: u32;
    var phi_1686_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1713_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1740_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1746_: u32;
    var phi_1749_: u32;
    var phi_1763_: u32;
    var phi_1773_: u32;
    var phi_1783_: u32;
    var phi_1801_: u32;
    var phi_1811_: u32;
    var phi_1821_: u32;
    var phi_1857_: u32;
    var phi_1870_: u32;
    var phi_1875_: u32;
    var phi_1876_: u32;
    var phi_1877_: u32;
    var phi_1747_: u32;
    var phi_1750_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1935_: u32;
    var phi_1980_: vec3<f32>;
    var phi_1981_: vec3<f32>;
    var phi_2010_: vec3<f32>;
    var phi_2011_: vec3<f32>;
    var phi_2040_: vec3<f32>;
    var phi_2041_: vec3<f32>;
    var phi_2059_: bool;
    var phi_2060_: bool;
    var phi_2064_: f32;
    var phi_2065_: f32;
    var phi_2066_: f32;
    var phi_2067_: f32;
    var phi_2075_: f32;
    var phi_2085_: bool;
    var phi_2086_: bool;
    var phi_2090_: f32;
    var phi_2091_: f32;
    var phi_2092_: f32;
    var phi_2093_: f32;
    var phi_2101_: f32;
    var phi_2111_: bool;
    var phi_2112_: bool;
    var phi_2116_: f32;
    var phi_2117_: f32;
    var phi_2118_: f32;
    var phi_2119_: f32;
    var phi_2127_: f32;
    var phi_2142_: f32;
    var phi_2143_: bool;
    var phi_2144_: f32;
    var phi_2145_: bool;
    var phi_2146_: f32;
    var phi_2147_: bool;
    var phi_2165_: f32;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2168_: f32;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2174_: bool;
    var phi_2175_: f32;
    var phi_2176_: bool;
    var phi_2204_: vec3<f32>;
    var phi_2205_: vec3<f32>;
    var phi_2230_: vec3<f32>;
    var phi_2231_: vec3<f32>;
    var phi_2256_: vec3<f32>;
    var phi_2257_: vec3<f32>;
    var phi_2313_: f32;
    var phi_2322_: f32;
    var phi_2331_: f32;
    var phi_2340_: f32;
    var phi_2347_: f32;
    var phi_2354_: f32;
    var phi_2367_: f32;
    var phi_2376_: f32;
    var phi_2385_: f32;
    var phi_2394_: f32;
    var phi_2401_: f32;
    var phi_2408_: f32;
    var phi_2425_: f32;
    var phi_2430_: f32;
    var phi_2435_: f32;
    var phi_2443_: f32;
    var phi_2448_: f32;
    var phi_2453_: f32;
    var phi_2465_: f32;
    var phi_2470_: f32;
    var phi_2475_: f32;
    var phi_2480_: f32;
    var phi_2485_: lt_bvh_triangle_Intersection;
    var phi_2486_: bool;
    var phi_2487_: lt_bvh_triangle_Intersection;
    var phi_2488_: bool;
    var phi_2492_: lt_bvh_triangle_Intersection;
    var phi_2493_: bool;
    var phi_2494_: lt_bvh_triangle_Intersection;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2500_: bool;
    var phi_2504_: lt_bvh_triangle_Intersection;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_1936_: u32;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var local_8: bool;
    var phi_2590_: bool;
    var phi_2591_: bool;
    var phi_2622_: u32;
    var phi_2623_: u32;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_1606_: u32;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2628_: bool;
    var phi_2629_: bool;
    var local_9: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2638_: bool;
    var phi_2642_: bool;
    var phi_2643_: bool;
    var phi_2644_: bool;
    var phi_2645_: bool;
    var phi_2649_: bool;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_1000_: u32;
    var phi_2660_: bool;
    var local_10: bool;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2734_: u32;
    var phi_2735_: u32;
    var phi_670_: u32;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var local_11: bool;
    var phi_2741_: bool;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2752_: bool;
    var phi_2756_: f32;
    var phi_2777_: u32;
    var phi_2792_: u32;
    var phi_2797_: u32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e55 = id_1;
    let _e62 = arrayLength((&nodes.member));
    let _e68 = arrayLength((&visibility.member));
    let _e71 = arrayLength((&list.member));
    let _e74 = arrayLength((&bits.member));
    let _e81 = ((_e55.y * 2097152u) + _e55.x);
    if (3u < _e71) {
    } else {
        return;
    }
    let _e84 = list.member[3u];
    if (_e81 < _e84) {
        let _e86 = (_e81 + 4u);
        if (_e86 < _e71) {
        } else {
            return;
        }
        let _e90 = list.member[(0u + _e86)];
        let _e92 = p.member.root;
        if (_e90 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e98 = samples.member[(0u + _e90)].position;
        let _e100 = samples.member[(0u + _e90)].normal;
        let _e102 = samples.member[(0u + _e90)].magnitude;
        let _e104 = ((8f / 8388608f) * _e102);
        let _e112 = (_e98.x + (_e100.x * _e104));
        let _e114 = (_e98.y + (_e100.y * _e104));
        let _e116 = (_e98.z + (_e100.z * _e104));
        let _e118 = p.member.light.place;
        if (_e118.w == 0f) {
            phi_271_ = 300000000000000000000000000000000000000f;
        } else {
            phi_271_ = 1f;
        }
        let _e122 = phi_271_;
        let _e130 = (_e118.x - (_e112 * _e118.w));
        let _e131 = (_e118.y - (_e114 * _e118.w));
        let _e132 = (_e118.z - (_e116 * _e118.w));
        let _e136 = abs(_e130);
        let _e137 = abs(_e131);
        let _e138 = abs(_e132);
        if (abs(_e112) < 1000000000000000f) {
            if (abs(_e114) < 1000000000000000f) {
                if (abs(_e116) < 1000000000000000f) {
                    if (_e136 < 1000000000000000f) {
                        if (_e137 < 1000000000000000f) {
                            if (_e138 < 1000000000000000f) {
                                if (_e136 > 0f) {
                                    phi_328_ = bool();
                                    phi_329_ = true;
                                } else {
                                    let _e146 = (_e137 > 0f);
                                    if _e146 {
                                        phi_327_ = bool();
                                    } else {
                                        phi_327_ = (_e138 > 0f);
                                    }
                                    let _e149 = phi_327_;
                                    phi_328_ = _e149;
                                    phi_329_ = _e146;
                                }
                                let _e151 = phi_328_;
                                let _e153 = phi_329_;
                                if _e153 {
                                    phi_333_ = true;
                                } else {
                                    phi_333_ = _e151;
                                }
                                let _e155 = phi_333_;
                                phi_334_ = _e155;
                                phi_335_ = false;
                            } else {
                                phi_334_ = bool();
                                phi_335_ = true;
                            }
                            let _e157 = phi_334_;
                            let _e159 = phi_335_;
                            phi_336_ = _e157;
                            phi_337_ = false;
                            phi_338_ = _e159;
                        } else {
                            phi_336_ = bool();
                            phi_337_ = true;
                            phi_338_ = false;
                        }
                        let _e161 = phi_336_;
                        let _e163 = phi_337_;
                        let _e165 = phi_338_;
                        phi_339_ = _e161;
                        phi_340_ = _e163;
                        phi_341_ = _e165;
                    } else {
                        phi_339_ = bool();
                        phi_340_ = true;
                        phi_341_ = false;
                    }
                    let _e167 = phi_339_;
                    let _e169 = phi_340_;
                    let _e171 = phi_341_;
                    phi_342_ = _e167;
                    phi_343_ = _e169;
                    phi_344_ = _e171;
                } else {
                    phi_342_ = bool();
                    phi_343_ = true;
                    phi_344_ = false;
                }
                let _e173 = phi_342_;
                let _e175 = phi_343_;
                let _e177 = phi_344_;
                phi_345_ = _e173;
                phi_346_ = _e175;
                phi_347_ = _e177;
            } else {
                phi_345_ = bool();
                phi_346_ = true;
                phi_347_ = false;
            }
            let _e179 = phi_345_;
            let _e181 = phi_346_;
            let _e183 = phi_347_;
            phi_348_ = _e179;
            phi_349_ = _e181;
            phi_350_ = _e183;
        } else {
            phi_348_ = bool();
            phi_349_ = true;
            phi_350_ = false;
        }
        let _e185 = phi_348_;
        let _e187 = phi_349_;
        let _e189 = phi_350_;
        if _e187 {
            phi_354_ = true;
        } else {
            phi_354_ = _e189;
        }
        let _e191 = phi_354_;
        if _e191 {
            phi_358_ = false;
        } else {
            phi_358_ = _e185;
        }
        let _e193 = phi_358_;
        if _e193 {
            let _e194 = (_e92 >= _e62);
            if _e194 {
                phi_2746_ = bool();
            } else {
                if (_e92 < _e62) {
                } else {
                    return;
                }
                let _e200 = nodes.member[(0u + _e92)].frame[0u];
                let _e204 = nodes.member[(0u + _e92)].frame[1u];
                let _e208 = nodes.member[(0u + _e92)].frame[2u];
                let _e212 = nodes.member[(0u + _e92)].frame[0u];
                let _e216 = nodes.member[(0u + _e92)].frame[1u];
                let _e220 = nodes.member[(0u + _e92)].frame[2u];
                let _e224 = nodes.member[(0u + _e92)].frame[3u];
                let _e258 = core_intrinsics_maximum_number_nsz_f32_(abs(_e130), abs(_e131));
                let _e259 = core_intrinsics_maximum_number_nsz_f32_(_e258, abs(_e132));
                let _e260 = (_e259 * 0.0000000000009094947f);
                if (abs(_e130) < _e260) {
                    phi_428_ = _e260;
                } else {
                    phi_428_ = abs(_e130);
                }
                let _e265 = phi_428_;
                if (_e130 < 0f) {
                    phi_435_ = (-1f / _e265);
                } else {
                    phi_435_ = (1f / _e265);
                }
                let _e270 = phi_435_;
                if (abs(_e131) < _e260) {
                    phi_442_ = _e260;
                } else {
                    phi_442_ = abs(_e131);
                }
                let _e275 = phi_442_;
                if (_e131 < 0f) {
                    phi_449_ = (-1f / _e275);
                } else {
                    phi_449_ = (1f / _e275);
                }
                let _e280 = phi_449_;
                if (abs(_e132) < _e260) {
                    phi_456_ = _e260;
                } else {
                    phi_456_ = abs(_e132);
                }
                let _e285 = phi_456_;
                if (_e132 < 0f) {
                    phi_463_ = (-1f / _e285);
                } else {
                    phi_463_ = (1f / _e285);
                }
                let _e290 = phi_463_;
                let _e294 = abs((bitcast<f32>(_e200) - _e112));
                let _e295 = abs((bitcast<f32>(_e204) - _e114));
                let _e296 = abs((bitcast<f32>(_e208) - _e116));
                let _e300 = abs(((bitcast<f32>(_e212) + (bitcast<f32>((((_e224 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e112));
                let _e301 = abs(((bitcast<f32>(_e216) + (bitcast<f32>((((_e224 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e114));
                let _e302 = abs(((bitcast<f32>(_e220) + (bitcast<f32>((((_e224 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e116));
                if (_e294 > _e300) {
                    phi_480_ = _e294;
                } else {
                    phi_480_ = _e300;
                }
                let _e305 = phi_480_;
                if (_e295 > _e301) {
                    phi_485_ = _e295;
                } else {
                    phi_485_ = _e301;
                }
                let _e308 = phi_485_;
                if (_e296 > _e302) {
                    phi_490_ = _e296;
                } else {
                    phi_490_ = _e302;
                }
                let _e311 = phi_490_;
                let _e312 = core_intrinsics_maximum_number_nsz_f32_(_e305, _e308);
                let _e313 = core_intrinsics_maximum_number_nsz_f32_(_e312, _e311);
                let _e317 = (_e313 * 0.0000019073486f);
                let _e318 = (abs(_e270) * _e317);
                let _e319 = (abs(_e280) * _e317);
                let _e320 = (abs(_e290) * _e317);
                let _e324 = (_e313 * 0.0000009536743f);
                let _e325 = (abs(_e270) * _e324);
                let _e326 = (abs(_e280) * _e324);
                let _e327 = (abs(_e290) * _e324);
                if (_e270 < 0f) {
                    phi_511_ = 0u;
                } else {
                    phi_511_ = 1u;
                }
                let _e330 = phi_511_;
                if (_e280 < 0f) {
                    phi_516_ = 0u;
                } else {
                    phi_516_ = 2u;
                }
                let _e333 = phi_516_;
                if (_e290 < 0f) {
                    phi_521_ = 0u;
                } else {
                    phi_521_ = 4u;
                }
                let _e336 = phi_521_;
                let _e338 = ((_e330 | _e333) | _e336);
                let _e339 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e92, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e339.first[0], _e339.first[1], _e339.first[2], _e339.first[3], _e339.first[4], _e339.first[5], _e339.first[6], _e339.first[7], _e339.first[8], _e339.first[9], _e339.first[10], _e339.first[11], _e339.first[12], _e339.first[13], _e339.first[14], _e339.first[15], _e339.first[16], _e339.first[17], _e339.first[18], _e339.first[19], _e339.first[20], _e339.first[21], _e339.first[22], _e339.first[23], _e339.first[24], _e339.first[25], _e339.first[26], _e339.first[27], _e339.first[28], _e339.first[29], _e339.first[30], _e339.first[31]), array<u32, 32>(_e339.mask[0], _e339.mask[1], _e339.mask[2], _e339.mask[3], _e339.mask[4], _e339.mask[5], _e339.mask[6], _e339.mask[7], _e339.mask[8], _e339.mask[9], _e339.mask[10], _e339.mask[11], _e339.mask[12], _e339.mask[13], _e339.mask[14], _e339.mask[15], _e339.mask[16], _e339.mask[17], _e339.mask[18], _e339.mask[19], _e339.mask[20], _e339.mask[21], _e339.mask[22], _e339.mask[23], _e339.mask[24], _e339.mask[25], _e339.mask[26], _e339.mask[27], _e339.mask[28], _e339.mask[29], _e339.mask[30], _e339.mask[31]), _e339.len, _e339.group, _e339.group_mask);
                let _e413 = local_1.group_mask;
                if ((_e413 & 4278190080u) == 0u) {
                    let _e417 = local_1.len;
                    if (_e417 == 0u) {
                        phi_635_ = false;
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
                        phi_635_ = true;
                    }
                    let _e440 = phi_635_;
                    phi_636_ = _e440;
                } else {
                    phi_636_ = true;
                }
                let _e442 = phi_636_;
                if _e442 {
                    let _e444 = local_1.group_mask;
                    let _e450 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e444)), 32u, (_e444 == 0u)));
                    let _e454 = local_1.group_mask;
                    let _e468 = local_1.group_mask;
                    local_1.group_mask = (_e468 & ~((1u << bitcast<u32>((_e450 & 31u)))));
                    let _e471 = local_1.group;
                    phi_667_ = (_e471 + countOneBits(((_e454 & ~((4294967295u << bitcast<u32>((((_e450 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_667_ = 4294967295u;
                }
                let _e474 = phi_667_;
                phi_669_ = _e474;
                loop {
                    let _e476 = phi_669_;
                    if (_e476 != 4294967295u) {
                        if (_e476 < _e62) {
                        } else {
                            return;
                        }
                        let _e483 = nodes.member[(0u + _e476)].frame[3u];
                        let _e508 = (bitcast<f32>((((_e483 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e270);
                        let _e509 = (bitcast<f32>((((_e483 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e280);
                        let _e510 = (bitcast<f32>((((_e483 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                        let _e513 = nodes.member[(0u + _e476)].frame[0u];
                        let _e517 = nodes.member[(0u + _e476)].frame[1u];
                        let _e521 = nodes.member[(0u + _e476)].frame[2u];
                        let _e526 = ((bitcast<f32>(_e513) - _e112) * _e270);
                        let _e527 = ((bitcast<f32>(_e517) - _e114) * _e280);
                        let _e528 = ((bitcast<f32>(_e521) - _e116) * _e290);
                        let _e536 = nodes.member[(0u + _e476)].x;
                        if (_e270 < 0f) {
                            let _e547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e536.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e553 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e547.unnamed.root, _e536.w), _e547.unnamed_1);
                            let _e559 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e553.unnamed, lt_bvh_traverse_Tree(_e536.x, _e553.unnamed_1.first_primitive));
                            phi_750_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e559.unnamed, lt_bvh_traverse_Tree(_e559.unnamed_1.root, _e536.y));
                        } else {
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e536.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e575.unnamed.root, _e536.y), _e575.unnamed_1);
                            let _e587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_bvh_traverse_Tree(_e536.z, _e581.unnamed_1.first_primitive));
                            phi_750_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e587.unnamed, lt_bvh_traverse_Tree(_e587.unnamed_1.root, _e536.w));
                        }
                        let _e595 = phi_750_;
                        let _e605 = nodes.member[(0u + _e476)].y;
                        if (_e280 < 0f) {
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e605.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e616.unnamed.root, _e605.w), _e616.unnamed_1);
                            let _e628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e622.unnamed, lt_bvh_traverse_Tree(_e605.x, _e622.unnamed_1.first_primitive));
                            phi_777_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e628.unnamed, lt_bvh_traverse_Tree(_e628.unnamed_1.root, _e605.y));
                        } else {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e605.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.unnamed.root, _e605.y), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e605.z, _e650.unnamed_1.first_primitive));
                            phi_777_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_bvh_traverse_Tree(_e656.unnamed_1.root, _e605.w));
                        }
                        let _e664 = phi_777_;
                        let _e674 = nodes.member[(0u + _e476)].z;
                        if (_e290 < 0f) {
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e674.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e685.unnamed.root, _e674.w), _e685.unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e674.x, _e691.unnamed_1.first_primitive));
                            phi_804_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_bvh_traverse_Tree(_e697.unnamed_1.root, _e674.y));
                        } else {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e674.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.unnamed.root, _e674.y), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e674.z, _e719.unnamed_1.first_primitive));
                            phi_804_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_bvh_traverse_Tree(_e725.unnamed_1.root, _e674.w));
                        }
                        let _e733 = phi_804_;
                        phi_810_ = 0u;
                        phi_813_ = 0u;
                        loop {
                            let _e743 = phi_810_;
                            let _e745 = phi_813_;
                            local_2 = _e745;
                            local_3 = _e745;
                            local_4 = _e745;
                            let _e746 = (_e743 < 8u);
                            if _e746 {
                                let _e748 = (_e743 >> bitcast<u32>(2i));
                                let _e749 = (_e743 & 3u);
                                if (_e748 == 0u) {
                                    phi_827_ = _e595.unnamed.root;
                                } else {
                                    phi_827_ = _e595.unnamed.first_primitive;
                                }
                                let _e752 = phi_827_;
                                if (_e748 == 0u) {
                                    phi_837_ = _e664.unnamed.root;
                                } else {
                                    phi_837_ = _e664.unnamed.first_primitive;
                                }
                                let _e761 = phi_837_;
                                if (_e748 == 0u) {
                                    phi_847_ = _e733.unnamed.root;
                                } else {
                                    phi_847_ = _e733.unnamed.first_primitive;
                                }
                                let _e770 = phi_847_;
                                let _e783 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e752 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u)) * _e508) + (_e526 - _e318)), ((f32(((_e761 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e319)));
                                let _e784 = core_intrinsics_maximum_number_nsz_f32_(_e783, ((f32(((_e770 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u)) * _e510) + (_e528 - _e320)));
                                if (_e748 == 0u) {
                                    phi_865_ = _e595.unnamed_1.root;
                                } else {
                                    phi_865_ = _e595.unnamed_1.first_primitive;
                                }
                                let _e787 = phi_865_;
                                if (_e748 == 0u) {
                                    phi_875_ = _e664.unnamed_1.root;
                                } else {
                                    phi_875_ = _e664.unnamed_1.first_primitive;
                                }
                                let _e796 = phi_875_;
                                if (_e748 == 0u) {
                                    phi_885_ = _e733.unnamed_1.root;
                                } else {
                                    phi_885_ = _e733.unnamed_1.first_primitive;
                                }
                                let _e805 = phi_885_;
                                let _e818 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e787 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u)) * _e508) + (_e526 + _e318)), ((f32(((_e796 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e319)));
                                let _e819 = core_intrinsics_minimum_number_nsz_f32_(_e818, ((f32(((_e805 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u)) * _e510) + (_e528 + _e320)));
                                if (_e784 <= _e819) {
                                    if (_e784 <= _e122) {
                                        if (_e819 >= 0f) {
                                            if (_e748 == 0u) {
                                                let _e826 = nodes.member[(0u + _e476)].links[2u];
                                                phi_921_ = _e826;
                                            } else {
                                                let _e829 = nodes.member[(0u + _e476)].links[3u];
                                                phi_921_ = _e829;
                                            }
                                            let _e831 = phi_921_;
                                            let _e836 = ((_e831 >> bitcast<u32>(((_e749 * 8u) & 31u))) & 255u);
                                            let _e837 = (_e836 & 31u);
                                            if (_e837 >= 24u) {
                                                phi_934_ = (24u + ((_e837 - 24u) ^ _e338));
                                            } else {
                                                phi_934_ = _e837;
                                            }
                                            let _e843 = phi_934_;
                                            phi_939_ = (_e745 | ((_e836 >> bitcast<u32>(5i)) << bitcast<u32>((_e843 & 31u))));
                                        } else {
                                            phi_939_ = _e745;
                                        }
                                        let _e851 = phi_939_;
                                        phi_940_ = _e851;
                                    } else {
                                        phi_940_ = _e745;
                                    }
                                    let _e853 = phi_940_;
                                    phi_941_ = _e853;
                                } else {
                                    phi_941_ = _e745;
                                }
                                let _e855 = phi_941_;
                                phi_811_ = (_e743 + 1u);
                                phi_814_ = _e855;
                            } else {
                                phi_811_ = u32();
                                phi_814_ = u32();
                            }
                            let _e858 = phi_811_;
                            let _e860 = phi_814_;
                            continue;
                            continuing {
                                phi_810_ = _e858;
                                phi_813_ = _e860;
                                break if !(_e746);
                            }
                        }
                        let _e864 = nodes.member[(0u + _e476)].links[0u];
                        let _e868 = nodes.member[(0u + _e476)].frame[3u];
                        let _e872 = local_2;
                        if ((_e872 & 4278190080u) == 0u) {
                        } else {
                            let _e876 = local_1.group_mask;
                            if ((_e876 & 4278190080u) == 0u) {
                            } else {
                                let _e880 = local_1.len;
                                if (_e880 < 32u) {
                                    let _e883 = local_1.group;
                                    let _e885 = local_1.len;
                                    if (_e885 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e885)] = _e883;
                                    let _e891 = local_1.group_mask;
                                    let _e893 = local_1.len;
                                    if (_e893 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e893)] = _e891;
                                    let _e900 = local_1.len;
                                    local_1.len = (_e900 + 1u);
                                }
                            }
                            local_1.group = (_e92 + _e864);
                            let _e904 = local_3;
                            local_1.group_mask = ((_e904 & 4278190080u) | (_e868 >> bitcast<u32>(24i)));
                        }
                        let _e909 = local_4;
                        phi_999_ = (_e909 & 16777215u);
                        loop {
                            let _e912 = phi_999_;
                            let _e913 = (_e912 == 0u);
                            local_10 = _e913;
                            local_17 = _e913;
                            if _e913 {
                                phi_1000_ = u32();
                                phi_2660_ = false;
                            } else {
                                let _e916 = nodes.member[(0u + _e476)].links[1u];
                                let _e920 = (_e916 + select(firstTrailingBit(_e912), 32u, (_e912 == 0u)));
                                if (_e920 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e927 = instances.member[(0u + _e920)].low_world;
                                let _e929 = instances.member[(0u + _e920)].high_world;
                                let _e936 = ((_e927.x - _e112) * _e270);
                                let _e937 = ((_e927.y - _e114) * _e280);
                                let _e938 = ((_e927.z - _e116) * _e290);
                                let _e945 = ((_e929.x - _e112) * _e270);
                                let _e946 = ((_e929.y - _e114) * _e280);
                                let _e947 = ((_e929.z - _e116) * _e290);
                                if (_e936 < _e945) {
                                    phi_1049_ = _e936;
                                } else {
                                    phi_1049_ = _e945;
                                }
                                let _e950 = phi_1049_;
                                if (_e937 < _e946) {
                                    phi_1054_ = _e937;
                                } else {
                                    phi_1054_ = _e946;
                                }
                                let _e953 = phi_1054_;
                                if (_e938 < _e947) {
                                    phi_1059_ = _e938;
                                } else {
                                    phi_1059_ = _e947;
                                }
                                let _e956 = phi_1059_;
                                if (_e936 > _e945) {
                                    phi_1067_ = _e936;
                                } else {
                                    phi_1067_ = _e945;
                                }
                                let _e962 = phi_1067_;
                                if (_e937 > _e946) {
                                    phi_1072_ = _e937;
                                } else {
                                    phi_1072_ = _e946;
                                }
                                let _e965 = phi_1072_;
                                if (_e938 > _e947) {
                                    phi_1077_ = _e938;
                                } else {
                                    phi_1077_ = _e947;
                                }
                                let _e968 = phi_1077_;
                                let _e972 = core_intrinsics_maximum_number_nsz_f32_((_e950 - _e325), (_e953 - _e326));
                                let _e973 = core_intrinsics_maximum_number_nsz_f32_(_e972, (_e956 - _e327));
                                let _e974 = core_intrinsics_minimum_number_nsz_f32_((_e962 + _e325), (_e965 + _e326));
                                let _e975 = core_intrinsics_minimum_number_nsz_f32_(_e974, (_e968 + _e327));
                                if (_e973 <= _e975) {
                                    if (_e973 <= _e122) {
                                        if (_e975 >= 0f) {
                                            let _e981 = instances.member[(0u + _e920)].world_to_object[0u];
                                            let _e992 = ((((_e981.x * _e112) + (_e981.y * _e114)) + (_e981.z * _e116)) + (_e981.w * 1f));
                                            let _e994 = instances.member[(0u + _e920)].world_to_object[1u];
                                            let _e1005 = ((((_e994.x * _e112) + (_e994.y * _e114)) + (_e994.z * _e116)) + (_e994.w * 1f));
                                            let _e1007 = instances.member[(0u + _e920)].world_to_object[2u];
                                            let _e1018 = ((((_e1007.x * _e112) + (_e1007.y * _e114)) + (_e1007.z * _e116)) + (_e1007.w * 1f));
                                            let _e1021 = instances.member[(0u + _e920)].world_to_object[0u];
                                            let _e1032 = ((((_e1021.x * _e130) + (_e1021.y * _e131)) + (_e1021.z * _e132)) + (_e1021.w * 0f));
                                            let _e1034 = instances.member[(0u + _e920)].world_to_object[1u];
                                            let _e1045 = ((((_e1034.x * _e130) + (_e1034.y * _e131)) + (_e1034.z * _e132)) + (_e1034.w * 0f));
                                            let _e1047 = instances.member[(0u + _e920)].world_to_object[2u];
                                            let _e1058 = ((((_e1047.x * _e130) + (_e1047.y * _e131)) + (_e1047.z * _e132)) + (_e1047.w * 0f));
                                            let _e1061 = instances.member[(0u + _e920)].root;
                                            let _e1063 = instances.member[(0u + _e920)].first_triangle;
                                            let _e1067 = abs(_e1032);
                                            let _e1068 = abs(_e1045);
                                            let _e1069 = abs(_e1058);
                                            if (abs(_e992) < 1000000000000000f) {
                                                if (abs(_e1005) < 1000000000000000f) {
                                                    if (abs(_e1018) < 1000000000000000f) {
                                                        if (_e1067 < 1000000000000000f) {
                                                            if (_e1068 < 1000000000000000f) {
                                                                if (_e1069 < 1000000000000000f) {
                                                                    if (_e1067 > 0f) {
                                                                        phi_1222_ = bool();
                                                                        phi_1223_ = true;
                                                                    } else {
                                                                        let _e1077 = (_e1068 > 0f);
                                                                        if _e1077 {
                                                                            phi_1221_ = bool();
                                                                        } else {
                                                                            phi_1221_ = (_e1069 > 0f);
                                                                        }
                                                                        let _e1080 = phi_1221_;
                                                                        phi_1222_ = _e1080;
                                                                        phi_1223_ = _e1077;
                                                                    }
                                                                    let _e1082 = phi_1222_;
                                                                    let _e1084 = phi_1223_;
                                                                    if _e1084 {
                                                                        phi_1227_ = true;
                                                                    } else {
                                                                        phi_1227_ = _e1082;
                                                                    }
                                                                    let _e1086 = phi_1227_;
                                                                    phi_1228_ = _e1086;
                                                                    phi_1229_ = false;
                                                                } else {
                                                                    phi_1228_ = bool();
                                                                    phi_1229_ = true;
                                                                }
                                                                let _e1088 = phi_1228_;
                                                                let _e1090 = phi_1229_;
                                                                phi_1230_ = _e1088;
                                                                phi_1231_ = false;
                                                                phi_1232_ = _e1090;
                                                            } else {
                                                                phi_1230_ = bool();
                                                                phi_1231_ = true;
                                                                phi_1232_ = false;
                                                            }
                                                            let _e1092 = phi_1230_;
                                                            let _e1094 = phi_1231_;
                                                            let _e1096 = phi_1232_;
                                                            phi_1233_ = _e1092;
                                                            phi_1234_ = _e1094;
                                                            phi_1235_ = _e1096;
                                                        } else {
                                                            phi_1233_ = bool();
                                                            phi_1234_ = true;
                                                            phi_1235_ = false;
                                                        }
                                                        let _e1098 = phi_1233_;
                                                        let _e1100 = phi_1234_;
                                                        let _e1102 = phi_1235_;
                                                        phi_1236_ = _e1098;
                                                        phi_1237_ = _e1100;
                                                        phi_1238_ = _e1102;
                                                    } else {
                                                        phi_1236_ = bool();
                                                        phi_1237_ = true;
                                                        phi_1238_ = false;
                                                    }
                                                    let _e1104 = phi_1236_;
                                                    let _e1106 = phi_1237_;
                                                    let _e1108 = phi_1238_;
                                                    phi_1239_ = _e1104;
                                                    phi_1240_ = _e1106;
                                                    phi_1241_ = _e1108;
                                                } else {
                                                    phi_1239_ = bool();
                                                    phi_1240_ = true;
                                                    phi_1241_ = false;
                                                }
                                                let _e1110 = phi_1239_;
                                                let _e1112 = phi_1240_;
                                                let _e1114 = phi_1241_;
                                                phi_1242_ = _e1110;
                                                phi_1243_ = _e1112;
                                                phi_1244_ = _e1114;
                                            } else {
                                                phi_1242_ = bool();
                                                phi_1243_ = true;
                                                phi_1244_ = false;
                                            }
                                            let _e1116 = phi_1242_;
                                            let _e1118 = phi_1243_;
                                            let _e1120 = phi_1244_;
                                            if _e1118 {
                                                phi_1248_ = true;
                                            } else {
                                                phi_1248_ = _e1120;
                                            }
                                            let _e1122 = phi_1248_;
                                            if _e1122 {
                                                phi_1252_ = false;
                                            } else {
                                                phi_1252_ = _e1116;
                                            }
                                            let _e1124 = phi_1252_;
                                            if _e1124 {
                                                let _e1125 = (_e1061 >= _e62);
                                                if _e1125 {
                                                    phi_2643_ = bool();
                                                } else {
                                                    if (_e1061 < _e62) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1131 = nodes.member[(0u + _e1061)].frame[0u];
                                                    let _e1135 = nodes.member[(0u + _e1061)].frame[1u];
                                                    let _e1139 = nodes.member[(0u + _e1061)].frame[2u];
                                                    let _e1143 = nodes.member[(0u + _e1061)].frame[0u];
                                                    let _e1147 = nodes.member[(0u + _e1061)].frame[1u];
                                                    let _e1151 = nodes.member[(0u + _e1061)].frame[2u];
                                                    let _e1155 = nodes.member[(0u + _e1061)].frame[3u];
                                                    let _e1189 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1032), abs(_e1045));
                                                    let _e1190 = core_intrinsics_maximum_number_nsz_f32_(_e1189, abs(_e1058));
                                                    let _e1191 = (_e1190 * 0.0000000000009094947f);
                                                    if (abs(_e1032) < _e1191) {
                                                        phi_1322_ = _e1191;
                                                    } else {
                                                        phi_1322_ = abs(_e1032);
                                                    }
                                                    let _e1196 = phi_1322_;
                                                    if (_e1032 < 0f) {
                                                        phi_1329_ = (-1f / _e1196);
                                                    } else {
                                                        phi_1329_ = (1f / _e1196);
                                                    }
                                                    let _e1201 = phi_1329_;
                                                    if (abs(_e1045) < _e1191) {
                                                        phi_1336_ = _e1191;
                                                    } else {
                                                        phi_1336_ = abs(_e1045);
                                                    }
                                                    let _e1206 = phi_1336_;
                                                    if (_e1045 < 0f) {
                                                        phi_1343_ = (-1f / _e1206);
                                                    } else {
                                                        phi_1343_ = (1f / _e1206);
                                                    }
                                                    let _e1211 = phi_1343_;
                                                    if (abs(_e1058) < _e1191) {
                                                        phi_1350_ = _e1191;
                                                    } else {
                                                        phi_1350_ = abs(_e1058);
                                                    }
                                                    let _e1216 = phi_1350_;
                                                    if (_e1058 < 0f) {
                                                        phi_1357_ = (-1f / _e1216);
                                                    } else {
                                                        phi_1357_ = (1f / _e1216);
                                                    }
                                                    let _e1221 = phi_1357_;
                                                    let _e1225 = abs((bitcast<f32>(_e1131) - _e992));
                                                    let _e1226 = abs((bitcast<f32>(_e1135) - _e1005));
                                                    let _e1227 = abs((bitcast<f32>(_e1139) - _e1018));
                                                    let _e1231 = abs(((bitcast<f32>(_e1143) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e992));
                                                    let _e1232 = abs(((bitcast<f32>(_e1147) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1005));
                                                    let _e1233 = abs(((bitcast<f32>(_e1151) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1018));
                                                    if (_e1225 > _e1231) {
                                                        phi_1374_ = _e1225;
                                                    } else {
                                                        phi_1374_ = _e1231;
                                                    }
                                                    let _e1236 = phi_1374_;
                                                    if (_e1226 > _e1232) {
                                                        phi_1379_ = _e1226;
                                                    } else {
                                                        phi_1379_ = _e1232;
                                                    }
                                                    let _e1239 = phi_1379_;
                                                    if (_e1227 > _e1233) {
                                                        phi_1384_ = _e1227;
                                                    } else {
                                                        phi_1384_ = _e1233;
                                                    }
                                                    let _e1242 = phi_1384_;
                                                    let _e1243 = core_intrinsics_maximum_number_nsz_f32_(_e1236, _e1239);
                                                    let _e1244 = core_intrinsics_maximum_number_nsz_f32_(_e1243, _e1242);
                                                    let _e1248 = (_e1244 * 0.0000019073486f);
                                                    let _e1249 = (abs(_e1201) * _e1248);
                                                    let _e1250 = (abs(_e1211) * _e1248);
                                                    let _e1251 = (abs(_e1221) * _e1248);
                                                    let _e1255 = (_e1244 * 0.0000009536743f);
                                                    let _e1256 = (abs(_e1201) * _e1255);
                                                    let _e1257 = (abs(_e1211) * _e1255);
                                                    let _e1258 = (abs(_e1221) * _e1255);
                                                    let _e1259 = abs(_e1032);
                                                    let _e1260 = abs(_e1045);
                                                    let _e1261 = abs(_e1058);
                                                    if (_e1259 >= _e1260) {
                                                        if (_e1259 >= _e1261) {
                                                            phi_1412_ = false;
                                                        } else {
                                                            phi_1412_ = true;
                                                        }
                                                        let _e1265 = phi_1412_;
                                                        phi_1413_ = _e1265;
                                                    } else {
                                                        phi_1413_ = true;
                                                    }
                                                    let _e1267 = phi_1413_;
                                                    if _e1267 {
                                                        if (_e1260 >= _e1261) {
                                                            phi_1421_ = 1u;
                                                        } else {
                                                            phi_1421_ = 2u;
                                                        }
                                                        let _e1270 = phi_1421_;
                                                        phi_1422_ = _e1270;
                                                    } else {
                                                        phi_1422_ = 0u;
                                                    }
                                                    let _e1272 = phi_1422_;
                                                    if (_e1272 == 0u) {
                                                        phi_1434_ = vec3<f32>(_e1045, _e1058, _e1032);
                                                    } else {
                                                        if (_e1272 == 1u) {
                                                            phi_1433_ = vec3<f32>(_e1058, _e1032, _e1045);
                                                        } else {
                                                            phi_1433_ = vec3<f32>(_e1032, _e1045, _e1058);
                                                        }
                                                        let _e1278 = phi_1433_;
                                                        phi_1434_ = _e1278;
                                                    }
                                                    let _e1280 = phi_1434_;
                                                    let _e1283 = (_e1280.x / _e1280.z);
                                                    let _e1286 = (_e1280.y / _e1280.z);
                                                    if (_e1201 < 0f) {
                                                        phi_1447_ = 0u;
                                                    } else {
                                                        phi_1447_ = 1u;
                                                    }
                                                    let _e1291 = phi_1447_;
                                                    if (_e1211 < 0f) {
                                                        phi_1452_ = 0u;
                                                    } else {
                                                        phi_1452_ = 2u;
                                                    }
                                                    let _e1294 = phi_1452_;
                                                    if (_e1221 < 0f) {
                                                        phi_1457_ = 0u;
                                                    } else {
                                                        phi_1457_ = 4u;
                                                    }
                                                    let _e1297 = phi_1457_;
                                                    let _e1299 = ((_e1291 | _e1294) | _e1297);
                                                    let _e1300 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1061, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1300.first[0], _e1300.first[1], _e1300.first[2], _e1300.first[3], _e1300.first[4], _e1300.first[5], _e1300.first[6], _e1300.first[7], _e1300.first[8], _e1300.first[9], _e1300.first[10], _e1300.first[11], _e1300.first[12], _e1300.first[13], _e1300.first[14], _e1300.first[15], _e1300.first[16], _e1300.first[17], _e1300.first[18], _e1300.first[19], _e1300.first[20], _e1300.first[21], _e1300.first[22], _e1300.first[23], _e1300.first[24], _e1300.first[25], _e1300.first[26], _e1300.first[27], _e1300.first[28], _e1300.first[29], _e1300.first[30], _e1300.first[31]), array<u32, 32>(_e1300.mask[0], _e1300.mask[1], _e1300.mask[2], _e1300.mask[3], _e1300.mask[4], _e1300.mask[5], _e1300.mask[6], _e1300.mask[7], _e1300.mask[8], _e1300.mask[9], _e1300.mask[10], _e1300.mask[11], _e1300.mask[12], _e1300.mask[13], _e1300.mask[14], _e1300.mask[15], _e1300.mask[16], _e1300.mask[17], _e1300.mask[18], _e1300.mask[19], _e1300.mask[20], _e1300.mask[21], _e1300.mask[22], _e1300.mask[23], _e1300.mask[24], _e1300.mask[25], _e1300.mask[26], _e1300.mask[27], _e1300.mask[28], _e1300.mask[29], _e1300.mask[30], _e1300.mask[31]), _e1300.len, _e1300.group, _e1300.group_mask);
                                                    let _e1374 = local.group_mask;
                                                    if ((_e1374 & 4278190080u) == 0u) {
                                                        let _e1378 = local.len;
                                                        if (_e1378 == 0u) {
                                                            phi_1571_ = false;
                                                        } else {
                                                            let _e1382 = local.len;
                                                            local.len = (_e1382 - 1u);
                                                            let _e1385 = local.len;
                                                            if (_e1385 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1390 = local.first[(0u + _e1385)];
                                                            local.group = _e1390;
                                                            let _e1393 = local.len;
                                                            if (_e1393 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1398 = local.mask[(0u + _e1393)];
                                                            local.group_mask = _e1398;
                                                            phi_1571_ = true;
                                                        }
                                                        let _e1401 = phi_1571_;
                                                        phi_1572_ = _e1401;
                                                    } else {
                                                        phi_1572_ = true;
                                                    }
                                                    let _e1403 = phi_1572_;
                                                    if _e1403 {
                                                        let _e1405 = local.group_mask;
                                                        let _e1411 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1405)), 32u, (_e1405 == 0u)));
                                                        let _e1415 = local.group_mask;
                                                        let _e1429 = local.group_mask;
                                                        local.group_mask = (_e1429 & ~((1u << bitcast<u32>((_e1411 & 31u)))));
                                                        let _e1432 = local.group;
                                                        phi_1603_ = (_e1432 + countOneBits(((_e1415 & ~((4294967295u << bitcast<u32>((((_e1411 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1603_ = 4294967295u;
                                                    }
                                                    let _e1435 = phi_1603_;
                                                    phi_1605_ = _e1435;
                                                    loop {
                                                        let _e1437 = phi_1605_;
                                                        if (_e1437 != 4294967295u) {
                                                            if (_e1437 < _e62) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1444 = nodes.member[(0u + _e1437)].frame[3u];
                                                            let _e1469 = (bitcast<f32>((((_e1444 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1201);
                                                            let _e1470 = (bitcast<f32>((((_e1444 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1211);
                                                            let _e1471 = (bitcast<f32>((((_e1444 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1221);
                                                            let _e1474 = nodes.member[(0u + _e1437)].frame[0u];
                                                            let _e1478 = nodes.member[(0u + _e1437)].frame[1u];
                                                            let _e1482 = nodes.member[(0u + _e1437)].frame[2u];
                                                            let _e1487 = ((bitcast<f32>(_e1474) - _e992) * _e1201);
                                                            let _e1488 = ((bitcast<f32>(_e1478) - _e1005) * _e1211);
                                                            let _e1489 = ((bitcast<f32>(_e1482) - _e1018) * _e1221);
                                                            let _e1497 = nodes.member[(0u + _e1437)].x;
                                                            if (_e1201 < 0f) {
                                                                let _e1508 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1514 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1508.unnamed.root, _e1497.w), _e1508.unnamed_1);
                                                                let _e1520 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1514.unnamed, lt_bvh_traverse_Tree(_e1497.x, _e1514.unnamed_1.first_primitive));
                                                                phi_1686_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1520.unnamed, lt_bvh_traverse_Tree(_e1520.unnamed_1.root, _e1497.y));
                                                            } else {
                                                                let _e1536 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1536.unnamed.root, _e1497.y), _e1536.unnamed_1);
                                                                let _e1548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1542.unnamed, lt_bvh_traverse_Tree(_e1497.z, _e1542.unnamed_1.first_primitive));
                                                                phi_1686_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1548.unnamed, lt_bvh_traverse_Tree(_e1548.unnamed_1.root, _e1497.w));
                                                            }
                                                            let _e1556 = phi_1686_;
                                                            let _e1566 = nodes.member[(0u + _e1437)].y;
                                                            if (_e1211 < 0f) {
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1577.unnamed.root, _e1566.w), _e1577.unnamed_1);
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1583.unnamed, lt_bvh_traverse_Tree(_e1566.x, _e1583.unnamed_1.first_primitive));
                                                                phi_1713_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1589.unnamed, lt_bvh_traverse_Tree(_e1589.unnamed_1.root, _e1566.y));
                                                            } else {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1605.unnamed.root, _e1566.y), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1566.z, _e1611.unnamed_1.first_primitive));
                                                                phi_1713_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1566.w));
                                                            }
                                                            let _e1625 = phi_1713_;
                                                            let _e1635 = nodes.member[(0u + _e1437)].z;
                                                            if (_e1221 < 0f) {
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1646.unnamed.root, _e1635.w), _e1646.unnamed_1);
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1652.unnamed, lt_bvh_traverse_Tree(_e1635.x, _e1652.unnamed_1.first_primitive));
                                                                phi_1740_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1658.unnamed, lt_bvh_traverse_Tree(_e1658.unnamed_1.root, _e1635.y));
                                                            } else {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1635.y), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1635.z, _e1680.unnamed_1.first_primitive));
                                                                phi_1740_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1635.w));
                                                            }
                                                            let _e1694 = phi_1740_;
                                                            phi_1746_ = 0u;
                                                            phi_1749_ = 0u;
                                                            loop {
                                                                let _e1704 = phi_1746_;
                                                                let _e1706 = phi_1749_;
                                                                local_5 = _e1706;
                                                                local_6 = _e1706;
                                                                local_7 = _e1706;
                                                                let _e1707 = (_e1704 < 8u);
                                                                if _e1707 {
                                                                    let _e1709 = (_e1704 >> bitcast<u32>(2i));
                                                                    let _e1710 = (_e1704 & 3u);
                                                                    if (_e1709 == 0u) {
                                                                        phi_1763_ = _e1556.unnamed.root;
                                                                    } else {
                                                                        phi_1763_ = _e1556.unnamed.first_primitive;
                                                                    }
                                                                    let _e1713 = phi_1763_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1773_ = _e1625.unnamed.root;
                                                                    } else {
                                                                        phi_1773_ = _e1625.unnamed.first_primitive;
                                                                    }
                                                                    let _e1722 = phi_1773_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1783_ = _e1694.unnamed.root;
                                                                    } else {
                                                                        phi_1783_ = _e1694.unnamed.first_primitive;
                                                                    }
                                                                    let _e1731 = phi_1783_;
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1713 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1249)), ((f32(((_e1722 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1250)));
                                                                    let _e1745 = core_intrinsics_maximum_number_nsz_f32_(_e1744, ((f32(((_e1731 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 - _e1251)));
                                                                    if (_e1709 == 0u) {
                                                                        phi_1801_ = _e1556.unnamed_1.root;
                                                                    } else {
                                                                        phi_1801_ = _e1556.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1748 = phi_1801_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1811_ = _e1625.unnamed_1.root;
                                                                    } else {
                                                                        phi_1811_ = _e1625.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1757 = phi_1811_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1821_ = _e1694.unnamed_1.root;
                                                                    } else {
                                                                        phi_1821_ = _e1694.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1766 = phi_1821_;
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1748 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1249)), ((f32(((_e1757 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1250)));
                                                                    let _e1780 = core_intrinsics_minimum_number_nsz_f32_(_e1779, ((f32(((_e1766 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 + _e1251)));
                                                                    if (_e1745 <= _e1780) {
                                                                        if (_e1745 <= _e122) {
                                                                            if (_e1780 >= 0f) {
                                                                                if (_e1709 == 0u) {
                                                                                    let _e1787 = nodes.member[(0u + _e1437)].links[2u];
                                                                                    phi_1857_ = _e1787;
                                                                                } else {
                                                                                    let _e1790 = nodes.member[(0u + _e1437)].links[3u];
                                                                                    phi_1857_ = _e1790;
                                                                                }
                                                                                let _e1792 = phi_1857_;
                                                                                let _e1797 = ((_e1792 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u);
                                                                                let _e1798 = (_e1797 & 31u);
                                                                                if (_e1798 >= 24u) {
                                                                                    phi_1870_ = (24u + ((_e1798 - 24u) ^ _e1299));
                                                                                } else {
                                                                                    phi_1870_ = _e1798;
                                                                                }
                                                                                let _e1804 = phi_1870_;
                                                                                phi_1875_ = (_e1706 | ((_e1797 >> bitcast<u32>(5i)) << bitcast<u32>((_e1804 & 31u))));
                                                                            } else {
                                                                                phi_1875_ = _e1706;
                                                                            }
                                                                            let _e1812 = phi_1875_;
                                                                            phi_1876_ = _e1812;
                                                                        } else {
                                                                            phi_1876_ = _e1706;
                                                                        }
                                                                        let _e1814 = phi_1876_;
                                                                        phi_1877_ = _e1814;
                                                                    } else {
                                                                        phi_1877_ = _e1706;
                                                                    }
                                                                    let _e1816 = phi_1877_;
                                                                    phi_1747_ = (_e1704 + 1u);
                                                                    phi_1750_ = _e1816;
                                                                } else {
                                                                    phi_1747_ = u32();
                                                                    phi_1750_ = u32();
                                                                }
                                                                let _e1819 = phi_1747_;
                                                                let _e1821 = phi_1750_;
                                                                continue;
                                                                continuing {
                                                                    phi_1746_ = _e1819;
                                                                    phi_1749_ = _e1821;
                                                                    break if !(_e1707);
                                                                }
                                                            }
                                                            let _e1825 = nodes.member[(0u + _e1437)].links[0u];
                                                            let _e1829 = nodes.member[(0u + _e1437)].frame[3u];
                                                            let _e1833 = local_5;
                                                            if ((_e1833 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1837 = local.group_mask;
                                                                if ((_e1837 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1841 = local.len;
                                                                    if (_e1841 < 32u) {
                                                                        let _e1844 = local.group;
                                                                        let _e1846 = local.len;
                                                                        if (_e1846 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1846)] = _e1844;
                                                                        let _e1852 = local.group_mask;
                                                                        let _e1854 = local.len;
                                                                        if (_e1854 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1854)] = _e1852;
                                                                        let _e1861 = local.len;
                                                                        local.len = (_e1861 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1061 + _e1825);
                                                                let _e1865 = local_6;
                                                                local.group_mask = ((_e1865 & 4278190080u) | (_e1829 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1870 = local_7;
                                                            phi_1935_ = (_e1870 & 16777215u);
                                                            loop {
                                                                let _e1873 = phi_1935_;
                                                                let _e1874 = (_e1873 == 0u);
                                                                local_8 = _e1874;
                                                                local_14 = _e1874;
                                                                if _e1874 {
                                                                    phi_1936_ = u32();
                                                                    phi_2546_ = false;
                                                                    phi_2547_ = false;
                                                                    phi_2548_ = false;
                                                                } else {
                                                                    let _e1877 = nodes.member[(0u + _e1437)].links[1u];
                                                                    let _e1882 = ((_e1063 + _e1877) + select(firstTrailingBit(_e1873), 32u, (_e1873 == 0u)));
                                                                    if (_e1882 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1889 = triangles.member[(0u + _e1882)].v0_;
                                                                    let _e1891 = (_e1889.x - _e992);
                                                                    let _e1893 = (_e1889.y - _e1005);
                                                                    let _e1895 = (_e1889.z - _e1018);
                                                                    if (_e1272 == 0u) {
                                                                        phi_1981_ = vec3<f32>(_e1893, _e1895, _e1891);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_1980_ = vec3<f32>(_e1895, _e1891, _e1893);
                                                                        } else {
                                                                            phi_1980_ = (_e1889 - vec3<f32>(_e992, _e1005, _e1018));
                                                                        }
                                                                        let _e1903 = phi_1980_;
                                                                        phi_1981_ = _e1903;
                                                                    }
                                                                    let _e1905 = phi_1981_;
                                                                    let _e1909 = (_e1905.x - (_e1283 * _e1905.z));
                                                                    let _e1913 = (_e1905.y - (_e1286 * _e1905.z));
                                                                    let _e1915 = triangles.member[(0u + _e1882)].v1_;
                                                                    let _e1917 = (_e1915.x - _e992);
                                                                    let _e1919 = (_e1915.y - _e1005);
                                                                    let _e1921 = (_e1915.z - _e1018);
                                                                    if (_e1272 == 0u) {
                                                                        phi_2011_ = vec3<f32>(_e1919, _e1921, _e1917);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2010_ = vec3<f32>(_e1921, _e1917, _e1919);
                                                                        } else {
                                                                            phi_2010_ = (_e1915 - vec3<f32>(_e992, _e1005, _e1018));
                                                                        }
                                                                        let _e1929 = phi_2010_;
                                                                        phi_2011_ = _e1929;
                                                                    }
                                                                    let _e1931 = phi_2011_;
                                                                    let _e1935 = (_e1931.x - (_e1283 * _e1931.z));
                                                                    let _e1939 = (_e1931.y - (_e1286 * _e1931.z));
                                                                    let _e1941 = triangles.member[(0u + _e1882)].v2_;
                                                                    let _e1943 = (_e1941.x - _e992);
                                                                    let _e1945 = (_e1941.y - _e1005);
                                                                    let _e1947 = (_e1941.z - _e1018);
                                                                    if (_e1272 == 0u) {
                                                                        phi_2041_ = vec3<f32>(_e1945, _e1947, _e1943);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2040_ = vec3<f32>(_e1947, _e1943, _e1945);
                                                                        } else {
                                                                            phi_2040_ = (_e1941 - vec3<f32>(_e992, _e1005, _e1018));
                                                                        }
                                                                        let _e1955 = phi_2040_;
                                                                        phi_2041_ = _e1955;
                                                                    }
                                                                    let _e1957 = phi_2041_;
                                                                    let _e1961 = (_e1957.x - (_e1283 * _e1957.z));
                                                                    let _e1965 = (_e1957.y - (_e1286 * _e1957.z));
                                                                    if (_e1935 < _e1961) {
                                                                        phi_2060_ = true;
                                                                    } else {
                                                                        if (_e1935 == _e1961) {
                                                                            phi_2059_ = (_e1939 < _e1965);
                                                                        } else {
                                                                            phi_2059_ = false;
                                                                        }
                                                                        let _e1970 = phi_2059_;
                                                                        phi_2060_ = _e1970;
                                                                    }
                                                                    let _e1972 = phi_2060_;
                                                                    if _e1972 {
                                                                        phi_2064_ = _e1965;
                                                                        phi_2065_ = _e1961;
                                                                        phi_2066_ = _e1939;
                                                                        phi_2067_ = _e1935;
                                                                    } else {
                                                                        phi_2064_ = _e1939;
                                                                        phi_2065_ = _e1935;
                                                                        phi_2066_ = _e1965;
                                                                        phi_2067_ = _e1961;
                                                                    }
                                                                    let _e1974 = phi_2064_;
                                                                    let _e1976 = phi_2065_;
                                                                    let _e1978 = phi_2066_;
                                                                    let _e1980 = phi_2067_;
                                                                    let _e1983 = ((_e1980 * _e1974) - (_e1978 * _e1976));
                                                                    if _e1972 {
                                                                        phi_2075_ = -(_e1983);
                                                                    } else {
                                                                        phi_2075_ = _e1983;
                                                                    }
                                                                    let _e1986 = phi_2075_;
                                                                    if (_e1961 < _e1909) {
                                                                        phi_2086_ = true;
                                                                    } else {
                                                                        if (_e1961 == _e1909) {
                                                                            phi_2085_ = (_e1965 < _e1913);
                                                                        } else {
                                                                            phi_2085_ = false;
                                                                        }
                                                                        let _e1991 = phi_2085_;
                                                                        phi_2086_ = _e1991;
                                                                    }
                                                                    let _e1993 = phi_2086_;
                                                                    if _e1993 {
                                                                        phi_2090_ = _e1913;
                                                                        phi_2091_ = _e1909;
                                                                        phi_2092_ = _e1965;
                                                                        phi_2093_ = _e1961;
                                                                    } else {
                                                                        phi_2090_ = _e1965;
                                                                        phi_2091_ = _e1961;
                                                                        phi_2092_ = _e1913;
                                                                        phi_2093_ = _e1909;
                                                                    }
                                                                    let _e1995 = phi_2090_;
                                                                    let _e1997 = phi_2091_;
                                                                    let _e1999 = phi_2092_;
                                                                    let _e2001 = phi_2093_;
                                                                    let _e2004 = ((_e2001 * _e1995) - (_e1999 * _e1997));
                                                                    if _e1993 {
                                                                        phi_2101_ = -(_e2004);
                                                                    } else {
                                                                        phi_2101_ = _e2004;
                                                                    }
                                                                    let _e2007 = phi_2101_;
                                                                    if (_e1909 < _e1935) {
                                                                        phi_2112_ = true;
                                                                    } else {
                                                                        if (_e1909 == _e1935) {
                                                                            phi_2111_ = (_e1913 < _e1939);
                                                                        } else {
                                                                            phi_2111_ = false;
                                                                        }
                                                                        let _e2012 = phi_2111_;
                                                                        phi_2112_ = _e2012;
                                                                    }
                                                                    let _e2014 = phi_2112_;
                                                                    if _e2014 {
                                                                        phi_2116_ = _e1939;
                                                                        phi_2117_ = _e1935;
                                                                        phi_2118_ = _e1913;
                                                                        phi_2119_ = _e1909;
                                                                    } else {
                                                                        phi_2116_ = _e1913;
                                                                        phi_2117_ = _e1909;
                                                                        phi_2118_ = _e1939;
                                                                        phi_2119_ = _e1935;
                                                                    }
                                                                    let _e2016 = phi_2116_;
                                                                    let _e2018 = phi_2117_;
                                                                    let _e2020 = phi_2118_;
                                                                    let _e2022 = phi_2119_;
                                                                    let _e2025 = ((_e2022 * _e2016) - (_e2020 * _e2018));
                                                                    if _e2014 {
                                                                        phi_2127_ = -(_e2025);
                                                                    } else {
                                                                        phi_2127_ = _e2025;
                                                                    }
                                                                    let _e2028 = phi_2127_;
                                                                    if (_e1986 >= 0f) {
                                                                        if (_e2007 >= 0f) {
                                                                            if (_e2028 >= 0f) {
                                                                                phi_2142_ = ((_e1986 + _e2007) + _e2028);
                                                                                phi_2143_ = false;
                                                                            } else {
                                                                                phi_2142_ = f32();
                                                                                phi_2143_ = true;
                                                                            }
                                                                            let _e2035 = phi_2142_;
                                                                            let _e2037 = phi_2143_;
                                                                            phi_2144_ = _e2035;
                                                                            phi_2145_ = _e2037;
                                                                        } else {
                                                                            phi_2144_ = f32();
                                                                            phi_2145_ = true;
                                                                        }
                                                                        let _e2039 = phi_2144_;
                                                                        let _e2041 = phi_2145_;
                                                                        phi_2146_ = _e2039;
                                                                        phi_2147_ = _e2041;
                                                                    } else {
                                                                        phi_2146_ = f32();
                                                                        phi_2147_ = true;
                                                                    }
                                                                    let _e2043 = phi_2146_;
                                                                    let _e2045 = phi_2147_;
                                                                    if _e2045 {
                                                                        if (_e1986 <= 0f) {
                                                                            if (_e2007 <= 0f) {
                                                                                let _e2048 = (_e2028 <= 0f);
                                                                                if _e2048 {
                                                                                }
                                                                                phi_2165_ = ((_e1986 + _e2007) + _e2028);
                                                                                phi_2166_ = false;
                                                                                phi_2167_ = _e2048;
                                                                            } else {
                                                                                phi_2165_ = f32();
                                                                                phi_2166_ = true;
                                                                                phi_2167_ = false;
                                                                            }
                                                                            let _e2052 = phi_2165_;
                                                                            let _e2054 = phi_2166_;
                                                                            let _e2056 = phi_2167_;
                                                                            phi_2168_ = _e2052;
                                                                            phi_2169_ = _e2054;
                                                                            phi_2170_ = _e2056;
                                                                        } else {
                                                                            phi_2168_ = f32();
                                                                            phi_2169_ = true;
                                                                            phi_2170_ = false;
                                                                        }
                                                                        let _e2058 = phi_2168_;
                                                                        let _e2060 = phi_2169_;
                                                                        let _e2062 = phi_2170_;
                                                                        if _e2060 {
                                                                            phi_2174_ = false;
                                                                        } else {
                                                                            phi_2174_ = _e2062;
                                                                        }
                                                                        let _e2064 = phi_2174_;
                                                                        phi_2175_ = _e2058;
                                                                        phi_2176_ = _e2064;
                                                                    } else {
                                                                        phi_2175_ = _e2043;
                                                                        phi_2176_ = true;
                                                                    }
                                                                    let _e2066 = phi_2175_;
                                                                    let _e2068 = phi_2176_;
                                                                    if _e2068 {
                                                                        let _e2069 = (_e2066 == 0f);
                                                                        if _e2069 {
                                                                            phi_2492_ = lt_bvh_triangle_Intersection();
                                                                            phi_2493_ = false;
                                                                        } else {
                                                                            let _e2071 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2073 = (_e2071.x - _e992);
                                                                            let _e2075 = (_e2071.y - _e1005);
                                                                            let _e2077 = (_e2071.z - _e1018);
                                                                            if (_e1272 == 0u) {
                                                                                phi_2205_ = vec3<f32>(_e2075, _e2077, _e2073);
                                                                            } else {
                                                                                if (_e1272 == 1u) {
                                                                                    phi_2204_ = vec3<f32>(_e2077, _e2073, _e2075);
                                                                                } else {
                                                                                    phi_2204_ = (_e2071 - vec3<f32>(_e992, _e1005, _e1018));
                                                                                }
                                                                                let _e2085 = phi_2204_;
                                                                                phi_2205_ = _e2085;
                                                                            }
                                                                            let _e2087 = phi_2205_;
                                                                            let _e2089 = triangles.member[(0u + _e1882)].v1_;
                                                                            let _e2091 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2094 = (_e2089.x - _e2091.x);
                                                                            let _e2097 = (_e2089.y - _e2091.y);
                                                                            let _e2100 = (_e2089.z - _e2091.z);
                                                                            if (_e1272 == 0u) {
                                                                                phi_2231_ = vec3<f32>(_e2097, _e2100, _e2094);
                                                                            } else {
                                                                                if (_e1272 == 1u) {
                                                                                    phi_2230_ = vec3<f32>(_e2100, _e2094, _e2097);
                                                                                } else {
                                                                                    phi_2230_ = (_e2089 - _e2091);
                                                                                }
                                                                                let _e2107 = phi_2230_;
                                                                                phi_2231_ = _e2107;
                                                                            }
                                                                            let _e2109 = phi_2231_;
                                                                            let _e2111 = triangles.member[(0u + _e1882)].v2_;
                                                                            let _e2113 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2116 = (_e2111.x - _e2113.x);
                                                                            let _e2119 = (_e2111.y - _e2113.y);
                                                                            let _e2122 = (_e2111.z - _e2113.z);
                                                                            if (_e1272 == 0u) {
                                                                                phi_2257_ = vec3<f32>(_e2119, _e2122, _e2116);
                                                                            } else {
                                                                                if (_e1272 == 1u) {
                                                                                    phi_2256_ = vec3<f32>(_e2122, _e2116, _e2119);
                                                                                } else {
                                                                                    phi_2256_ = (_e2111 - _e2113);
                                                                                }
                                                                                let _e2129 = phi_2256_;
                                                                                phi_2257_ = _e2129;
                                                                            }
                                                                            let _e2131 = phi_2257_;
                                                                            let _e2138 = ((_e2109.y * _e2131.z) - (_e2109.z * _e2131.y));
                                                                            let _e2145 = ((_e2109.z * _e2131.x) - (_e2109.x * _e2131.z));
                                                                            let _e2152 = ((_e2109.x * _e2131.y) - (_e2109.y * _e2131.x));
                                                                            let _e2166 = (((1f / _e1280.z) * (((_e2138 * _e2087.x) + (_e2145 * _e2087.y)) + (_e2152 * _e2087.z))) / (((_e2138 * _e1283) + (_e2145 * _e1286)) + _e2152));
                                                                            if (_e2166 > 0f) {
                                                                                if (_e2166 < _e122) {
                                                                                    let _e2170 = triangles.member[(0u + _e1882)].v0_;
                                                                                    let _e2172 = triangles.member[(0u + _e1882)].v1_;
                                                                                    if (_e2170.x < _e2172.x) {
                                                                                        phi_2313_ = _e2170.x;
                                                                                    } else {
                                                                                        phi_2313_ = _e2172.x;
                                                                                    }
                                                                                    let _e2179 = phi_2313_;
                                                                                    if (_e2170.y < _e2172.y) {
                                                                                        phi_2322_ = _e2170.y;
                                                                                    } else {
                                                                                        phi_2322_ = _e2172.y;
                                                                                    }
                                                                                    let _e2186 = phi_2322_;
                                                                                    if (_e2170.z < _e2172.z) {
                                                                                        phi_2331_ = _e2170.z;
                                                                                    } else {
                                                                                        phi_2331_ = _e2172.z;
                                                                                    }
                                                                                    let _e2193 = phi_2331_;
                                                                                    let _e2195 = triangles.member[(0u + _e1882)].v2_;
                                                                                    if (_e2179 < _e2195.x) {
                                                                                        phi_2340_ = _e2179;
                                                                                    } else {
                                                                                        phi_2340_ = _e2195.x;
                                                                                    }
                                                                                    let _e2200 = phi_2340_;
                                                                                    if (_e2186 < _e2195.y) {
                                                                                        phi_2347_ = _e2186;
                                                                                    } else {
                                                                                        phi_2347_ = _e2195.y;
                                                                                    }
                                                                                    let _e2205 = phi_2347_;
                                                                                    if (_e2193 < _e2195.z) {
                                                                                        phi_2354_ = _e2193;
                                                                                    } else {
                                                                                        phi_2354_ = _e2195.z;
                                                                                    }
                                                                                    let _e2210 = phi_2354_;
                                                                                    let _e2212 = triangles.member[(0u + _e1882)].v0_;
                                                                                    let _e2214 = triangles.member[(0u + _e1882)].v1_;
                                                                                    if (_e2212.x > _e2214.x) {
                                                                                        phi_2367_ = _e2212.x;
                                                                                    } else {
                                                                                        phi_2367_ = _e2214.x;
                                                                                    }
                                                                                    let _e2221 = phi_2367_;
                                                                                    if (_e2212.y > _e2214.y) {
                                                                                        phi_2376_ = _e2212.y;
                                                                                    } else {
                                                                                        phi_2376_ = _e2214.y;
                                                                                    }
                                                                                    let _e2228 = phi_2376_;
                                                                                    if (_e2212.z > _e2214.z) {
                                                                                        phi_2385_ = _e2212.z;
                                                                                    } else {
                                                                                        phi_2385_ = _e2214.z;
                                                                                    }
                                                                                    let _e2235 = phi_2385_;
                                                                                    let _e2237 = triangles.member[(0u + _e1882)].v2_;
                                                                                    if (_e2221 > _e2237.x) {
                                                                                        phi_2394_ = _e2221;
                                                                                    } else {
                                                                                        phi_2394_ = _e2237.x;
                                                                                    }
                                                                                    let _e2242 = phi_2394_;
                                                                                    if (_e2228 > _e2237.y) {
                                                                                        phi_2401_ = _e2228;
                                                                                    } else {
                                                                                        phi_2401_ = _e2237.y;
                                                                                    }
                                                                                    let _e2247 = phi_2401_;
                                                                                    if (_e2235 > _e2237.z) {
                                                                                        phi_2408_ = _e2235;
                                                                                    } else {
                                                                                        phi_2408_ = _e2237.z;
                                                                                    }
                                                                                    let _e2252 = phi_2408_;
                                                                                    let _e2256 = ((_e2200 - _e992) * _e1201);
                                                                                    let _e2257 = ((_e2205 - _e1005) * _e1211);
                                                                                    let _e2258 = ((_e2210 - _e1018) * _e1221);
                                                                                    let _e2262 = ((_e2242 - _e992) * _e1201);
                                                                                    let _e2263 = ((_e2247 - _e1005) * _e1211);
                                                                                    let _e2264 = ((_e2252 - _e1018) * _e1221);
                                                                                    if (_e2256 < _e2262) {
                                                                                        phi_2425_ = _e2256;
                                                                                    } else {
                                                                                        phi_2425_ = _e2262;
                                                                                    }
                                                                                    let _e2267 = phi_2425_;
                                                                                    if (_e2257 < _e2263) {
                                                                                        phi_2430_ = _e2257;
                                                                                    } else {
                                                                                        phi_2430_ = _e2263;
                                                                                    }
                                                                                    let _e2270 = phi_2430_;
                                                                                    if (_e2258 < _e2264) {
                                                                                        phi_2435_ = _e2258;
                                                                                    } else {
                                                                                        phi_2435_ = _e2264;
                                                                                    }
                                                                                    let _e2273 = phi_2435_;
                                                                                    if (_e2256 > _e2262) {
                                                                                        phi_2443_ = _e2256;
                                                                                    } else {
                                                                                        phi_2443_ = _e2262;
                                                                                    }
                                                                                    let _e2279 = phi_2443_;
                                                                                    if (_e2257 > _e2263) {
                                                                                        phi_2448_ = _e2257;
                                                                                    } else {
                                                                                        phi_2448_ = _e2263;
                                                                                    }
                                                                                    let _e2282 = phi_2448_;
                                                                                    if (_e2258 > _e2264) {
                                                                                        phi_2453_ = _e2258;
                                                                                    } else {
                                                                                        phi_2453_ = _e2264;
                                                                                    }
                                                                                    let _e2285 = phi_2453_;
                                                                                    let _e2289 = core_intrinsics_maximum_number_nsz_f32_((_e2267 - _e1256), (_e2270 - _e1257));
                                                                                    let _e2290 = core_intrinsics_maximum_number_nsz_f32_(_e2289, (_e2273 - _e1258));
                                                                                    let _e2291 = core_intrinsics_minimum_number_nsz_f32_((_e2279 + _e1256), (_e2282 + _e1257));
                                                                                    let _e2292 = core_intrinsics_minimum_number_nsz_f32_(_e2291, (_e2285 + _e1258));
                                                                                    if (_e2290 > _e973) {
                                                                                        phi_2465_ = _e2290;
                                                                                    } else {
                                                                                        phi_2465_ = _e973;
                                                                                    }
                                                                                    let _e2295 = phi_2465_;
                                                                                    if (_e2292 < _e975) {
                                                                                        phi_2470_ = _e2292;
                                                                                    } else {
                                                                                        phi_2470_ = _e975;
                                                                                    }
                                                                                    let _e2298 = phi_2470_;
                                                                                    if (_e2166 < _e2295) {
                                                                                        phi_2475_ = _e2295;
                                                                                    } else {
                                                                                        phi_2475_ = _e2166;
                                                                                    }
                                                                                    let _e2301 = phi_2475_;
                                                                                    if (_e2301 > _e2298) {
                                                                                        phi_2480_ = _e2298;
                                                                                    } else {
                                                                                        phi_2480_ = _e2301;
                                                                                    }
                                                                                    let _e2304 = phi_2480_;
                                                                                    phi_2485_ = lt_bvh_triangle_Intersection(_e2304, (_e2007 / _e2066), (_e2028 / _e2066), (_e2295 <= _e2298));
                                                                                    phi_2486_ = false;
                                                                                } else {
                                                                                    phi_2485_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2486_ = true;
                                                                                }
                                                                                let _e2310 = phi_2485_;
                                                                                let _e2312 = phi_2486_;
                                                                                phi_2487_ = _e2310;
                                                                                phi_2488_ = _e2312;
                                                                            } else {
                                                                                phi_2487_ = lt_bvh_triangle_Intersection();
                                                                                phi_2488_ = true;
                                                                            }
                                                                            let _e2314 = phi_2487_;
                                                                            let _e2316 = phi_2488_;
                                                                            if _e2316 {
                                                                            }
                                                                            phi_2492_ = _e2314;
                                                                            phi_2493_ = _e2316;
                                                                        }
                                                                        let _e2318 = phi_2492_;
                                                                        let _e2320 = phi_2493_;
                                                                        phi_2494_ = _e2318;
                                                                        phi_2495_ = _e2069;
                                                                        phi_2496_ = _e2320;
                                                                    } else {
                                                                        phi_2494_ = lt_bvh_triangle_Intersection();
                                                                        phi_2495_ = true;
                                                                        phi_2496_ = false;
                                                                    }
                                                                    let _e2322 = phi_2494_;
                                                                    let _e2324 = phi_2495_;
                                                                    let _e2326 = phi_2496_;
                                                                    if _e2324 {
                                                                        phi_2500_ = true;
                                                                    } else {
                                                                        phi_2500_ = _e2326;
                                                                    }
                                                                    let _e2328 = phi_2500_;
                                                                    if _e2328 {
                                                                        phi_2504_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2504_ = _e2322;
                                                                    }
                                                                    let _e2330 = phi_2504_;
                                                                    if _e2330.is_hit {
                                                                        if (_e2330.t > 0f) {
                                                                            if (_e2330.t < _e122) {
                                                                                let _e2337 = triangles.member[(0u + _e1882)].i0_;
                                                                                let _e2339 = ((_e2337 & 2147483648u) == 0u);
                                                                                if _e2339 {
                                                                                    phi_2530_ = false;
                                                                                    phi_2531_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2529_ = false;
                                                                                    } else {
                                                                                        phi_2529_ = true;
                                                                                    }
                                                                                    let _e2341 = phi_2529_;
                                                                                    phi_2530_ = _e2341;
                                                                                    phi_2531_ = true;
                                                                                }
                                                                                let _e2343 = phi_2530_;
                                                                                let _e2345 = phi_2531_;
                                                                                phi_2532_ = _e2343;
                                                                                phi_2533_ = _e2339;
                                                                                phi_2534_ = _e2345;
                                                                            } else {
                                                                                phi_2532_ = true;
                                                                                phi_2533_ = false;
                                                                                phi_2534_ = false;
                                                                            }
                                                                            let _e2347 = phi_2532_;
                                                                            let _e2349 = phi_2533_;
                                                                            let _e2351 = phi_2534_;
                                                                            phi_2535_ = _e2347;
                                                                            phi_2536_ = _e2349;
                                                                            phi_2537_ = _e2351;
                                                                        } else {
                                                                            phi_2535_ = true;
                                                                            phi_2536_ = false;
                                                                            phi_2537_ = false;
                                                                        }
                                                                        let _e2353 = phi_2535_;
                                                                        let _e2355 = phi_2536_;
                                                                        let _e2357 = phi_2537_;
                                                                        phi_2538_ = _e2353;
                                                                        phi_2539_ = _e2355;
                                                                        phi_2540_ = _e2357;
                                                                    } else {
                                                                        phi_2538_ = true;
                                                                        phi_2539_ = false;
                                                                        phi_2540_ = false;
                                                                    }
                                                                    let _e2359 = phi_2538_;
                                                                    let _e2361 = phi_2539_;
                                                                    let _e2363 = phi_2540_;
                                                                    if _e2359 {
                                                                        phi_2544_ = false;
                                                                        phi_2545_ = false;
                                                                    } else {
                                                                        phi_2544_ = _e2361;
                                                                        phi_2545_ = _e2363;
                                                                    }
                                                                    let _e2365 = phi_2544_;
                                                                    let _e2367 = phi_2545_;
                                                                    phi_1936_ = (_e1873 & (_e1873 - 1u));
                                                                    phi_2546_ = _e2359;
                                                                    phi_2547_ = _e2365;
                                                                    phi_2548_ = _e2367;
                                                                }
                                                                let _e2369 = phi_1936_;
                                                                let _e2371 = phi_2546_;
                                                                let _e2373 = phi_2547_;
                                                                let _e2375 = phi_2548_;
                                                                local_12 = _e2373;
                                                                local_13 = _e2375;
                                                                continue;
                                                                continuing {
                                                                    phi_1935_ = _e2369;
                                                                    break if !(_e2371);
                                                                }
                                                            }
                                                            let _e2378 = local_8;
                                                            if _e2378 {
                                                                let _e2380 = local.group_mask;
                                                                if ((_e2380 & 4278190080u) == 0u) {
                                                                    let _e2384 = local.len;
                                                                    if (_e2384 == 0u) {
                                                                        phi_2590_ = false;
                                                                    } else {
                                                                        let _e2388 = local.len;
                                                                        local.len = (_e2388 - 1u);
                                                                        let _e2391 = local.len;
                                                                        if (_e2391 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2396 = local.first[(0u + _e2391)];
                                                                        local.group = _e2396;
                                                                        let _e2399 = local.len;
                                                                        if (_e2399 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2404 = local.mask[(0u + _e2399)];
                                                                        local.group_mask = _e2404;
                                                                        phi_2590_ = true;
                                                                    }
                                                                    let _e2407 = phi_2590_;
                                                                    phi_2591_ = _e2407;
                                                                } else {
                                                                    phi_2591_ = true;
                                                                }
                                                                let _e2409 = phi_2591_;
                                                                if _e2409 {
                                                                    let _e2411 = local.group_mask;
                                                                    let _e2417 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2411)), 32u, (_e2411 == 0u)));
                                                                    let _e2421 = local.group_mask;
                                                                    let _e2435 = local.group_mask;
                                                                    local.group_mask = (_e2435 & ~((1u << bitcast<u32>((_e2417 & 31u)))));
                                                                    let _e2438 = local.group;
                                                                    phi_2622_ = (_e2438 + countOneBits(((_e2421 & ~((4294967295u << bitcast<u32>((((_e2417 - 24u) ^ _e1299) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2622_ = 4294967295u;
                                                                }
                                                                let _e2441 = phi_2622_;
                                                                phi_2623_ = _e2441;
                                                                phi_2624_ = false;
                                                                phi_2625_ = false;
                                                            } else {
                                                                phi_2623_ = u32();
                                                                let _e2850 = local_12;
                                                                phi_2624_ = _e2850;
                                                                let _e2853 = local_13;
                                                                phi_2625_ = _e2853;
                                                            }
                                                            let _e2443 = phi_2623_;
                                                            let _e2445 = phi_2624_;
                                                            let _e2447 = phi_2625_;
                                                            phi_1606_ = _e2443;
                                                            let _e2857 = local_14;
                                                            phi_2626_ = _e2857;
                                                            phi_2627_ = false;
                                                            phi_2628_ = _e2445;
                                                            phi_2629_ = _e2447;
                                                        } else {
                                                            phi_1606_ = u32();
                                                            phi_2626_ = false;
                                                            phi_2627_ = true;
                                                            phi_2628_ = false;
                                                            phi_2629_ = false;
                                                        }
                                                        let _e2449 = phi_1606_;
                                                        let _e2451 = phi_2626_;
                                                        let _e2453 = phi_2627_;
                                                        let _e2455 = phi_2628_;
                                                        let _e2457 = phi_2629_;
                                                        local_9 = _e2453;
                                                        local_15 = _e2455;
                                                        local_16 = _e2457;
                                                        continue;
                                                        continuing {
                                                            phi_1605_ = _e2449;
                                                            break if !(_e2451);
                                                        }
                                                    }
                                                    let _e2460 = local_9;
                                                    if _e2460 {
                                                        phi_2633_ = false;
                                                        phi_2634_ = false;
                                                    } else {
                                                        let _e2864 = local_15;
                                                        phi_2633_ = _e2864;
                                                        let _e2867 = local_16;
                                                        phi_2634_ = _e2867;
                                                    }
                                                    let _e2462 = phi_2633_;
                                                    let _e2464 = phi_2634_;
                                                    if _e2462 {
                                                        phi_2638_ = true;
                                                    } else {
                                                        phi_2638_ = _e2464;
                                                    }
                                                    let _e2466 = phi_2638_;
                                                    if _e2466 {
                                                        phi_2642_ = true;
                                                    } else {
                                                        phi_2642_ = false;
                                                    }
                                                    let _e2468 = phi_2642_;
                                                    phi_2643_ = _e2468;
                                                }
                                                let _e2470 = phi_2643_;
                                                phi_2644_ = _e2470;
                                                phi_2645_ = _e1125;
                                            } else {
                                                phi_2644_ = bool();
                                                phi_2645_ = true;
                                            }
                                            let _e2472 = phi_2644_;
                                            let _e2474 = phi_2645_;
                                            if _e2474 {
                                                phi_2649_ = false;
                                            } else {
                                                phi_2649_ = _e2472;
                                            }
                                            let _e2476 = phi_2649_;
                                            if _e2476 {
                                                phi_2653_ = false;
                                            } else {
                                                phi_2653_ = true;
                                            }
                                            let _e2478 = phi_2653_;
                                            phi_2654_ = _e2478;
                                        } else {
                                            phi_2654_ = true;
                                        }
                                        let _e2480 = phi_2654_;
                                        phi_2655_ = _e2480;
                                    } else {
                                        phi_2655_ = true;
                                    }
                                    let _e2482 = phi_2655_;
                                    phi_2656_ = _e2482;
                                } else {
                                    phi_2656_ = true;
                                }
                                let _e2484 = phi_2656_;
                                if _e2484 {
                                }
                                phi_1000_ = (_e912 & (_e912 - 1u));
                                phi_2660_ = _e2484;
                            }
                            let _e2486 = phi_1000_;
                            let _e2488 = phi_2660_;
                            continue;
                            continuing {
                                phi_999_ = _e2486;
                                break if !(_e2488);
                            }
                        }
                        let _e2491 = local_10;
                        if _e2491 {
                            let _e2493 = local_1.group_mask;
                            if ((_e2493 & 4278190080u) == 0u) {
                                let _e2497 = local_1.len;
                                if (_e2497 == 0u) {
                                    phi_2702_ = false;
                                } else {
                                    let _e2501 = local_1.len;
                                    local_1.len = (_e2501 - 1u);
                                    let _e2504 = local_1.len;
                                    if (_e2504 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2509 = local_1.first[(0u + _e2504)];
                                    local_1.group = _e2509;
                                    let _e2512 = local_1.len;
                                    if (_e2512 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2517 = local_1.mask[(0u + _e2512)];
                                    local_1.group_mask = _e2517;
                                    phi_2702_ = true;
                                }
                                let _e2520 = phi_2702_;
                                phi_2703_ = _e2520;
                            } else {
                                phi_2703_ = true;
                            }
                            let _e2522 = phi_2703_;
                            if _e2522 {
                                let _e2524 = local_1.group_mask;
                                let _e2530 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2524)), 32u, (_e2524 == 0u)));
                                let _e2534 = local_1.group_mask;
                                let _e2548 = local_1.group_mask;
                                local_1.group_mask = (_e2548 & ~((1u << bitcast<u32>((_e2530 & 31u)))));
                                let _e2551 = local_1.group;
                                phi_2734_ = (_e2551 + countOneBits(((_e2534 & ~((4294967295u << bitcast<u32>((((_e2530 - 24u) ^ _e338) & 31u))))) & 255u)));
                            } else {
                                phi_2734_ = 4294967295u;
                            }
                            let _e2554 = phi_2734_;
                            phi_2735_ = _e2554;
                        } else {
                            phi_2735_ = u32();
                        }
                        let _e2556 = phi_2735_;
                        phi_670_ = _e2556;
                        let _e2888 = local_17;
                        phi_2736_ = _e2888;
                        phi_2737_ = false;
                    } else {
                        phi_670_ = u32();
                        phi_2736_ = false;
                        phi_2737_ = true;
                    }
                    let _e2558 = phi_670_;
                    let _e2560 = phi_2736_;
                    let _e2562 = phi_2737_;
                    local_11 = _e2562;
                    continue;
                    continuing {
                        phi_669_ = _e2558;
                        break if !(_e2560);
                    }
                }
                let _e2565 = local_11;
                if _e2565 {
                    phi_2741_ = false;
                } else {
                    phi_2741_ = true;
                }
                let _e2567 = phi_2741_;
                if _e2567 {
                    phi_2745_ = true;
                } else {
                    phi_2745_ = false;
                }
                let _e2569 = phi_2745_;
                phi_2746_ = _e2569;
            }
            let _e2571 = phi_2746_;
            phi_2747_ = _e2571;
            phi_2748_ = _e194;
        } else {
            phi_2747_ = bool();
            phi_2748_ = true;
        }
        let _e2573 = phi_2747_;
        let _e2575 = phi_2748_;
        if _e2575 {
            phi_2752_ = false;
        } else {
            phi_2752_ = _e2573;
        }
        let _e2577 = phi_2752_;
        if _e2577 {
            phi_2756_ = 0f;
        } else {
            phi_2756_ = 1f;
        }
        let _e2579 = phi_2756_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e90)] = _e2579;
        if (_e90 < _e74) {
        } else {
            return;
        }
        let _e2586 = bits.member[(0u + _e90)];
        if ((_e2586 & 2u) == 0u) {
            phi_2777_ = (_e2586 & 1u);
        } else {
            phi_2777_ = (_e2586 & 7u);
        }
        let _e2592 = phi_2777_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        let _e2596 = visibility.member[(0u + _e90)];
        if ((_e2592 & 1u) != 0u) {
            phi_2792_ = (2u | 1u);
        } else {
            phi_2792_ = 2u;
        }
        let _e2602 = phi_2792_;
        if (_e2596 < 0.5f) {
            phi_2797_ = (_e2602 | 4u);
        } else {
            phi_2797_ = _e2602;
        }
        let _e2605 = phi_2797_;
        if (_e90 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e90)] = _e2605;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
