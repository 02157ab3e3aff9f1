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
    var phi_672_: bool;
    var phi_752_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_779_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_806_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_812_: u32;
    var phi_815_: u32;
    var phi_829_: u32;
    var phi_839_: u32;
    var phi_849_: u32;
    var phi_867_: u32;
    var phi_877_: u32;
    var phi_887_: u32;
    var phi_923_: u32;
    var phi_936_: u32;
    var phi_941_: u32;
    var phi_942_: u32;
    var phi_943_: u32;
    var phi_813_: u32;
    var phi_816_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1001_: u32;
    var phi_1004_: bool;
    var phi_1053_: f32;
    var phi_1058_: f32;
    var phi_1063_: f32;
    var phi_1071_: f32;
    var phi_1076_: f32;
    var phi_1081_: f32;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
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
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1252_: bool;
    var phi_1256_: bool;
    var phi_1326_: f32;
    var phi_1333_: f32;
    var phi_1340_: f32;
    var phi_1347_: f32;
    var phi_1354_: f32;
    var phi_1361_: f32;
    var phi_1378_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1425_: u32;
    var phi_1426_: u32;
    var phi_1437_: vec3<f32>;
    var phi_1438_: vec3<f32>;
    var phi_1451_: u32;
    var phi_1456_: u32;
    var phi_1461_: u32;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1607_: u32;
    var phi_1609_: u32;
    var phi_1612_: bool;
    var phi_1692_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1719_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1746_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1752_: u32;
    var phi_1755_: u32;
    var phi_1769_: u32;
    var phi_1779_: u32;
    var phi_1789_: u32;
    var phi_1807_: u32;
    var phi_1817_: u32;
    var phi_1827_: u32;
    var phi_1863_: u32;
    var phi_1876_: u32;
    var phi_1881_: u32;
    var phi_1882_: u32;
    var phi_1883_: u32;
    var phi_1753_: u32;
    var phi_1756_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1941_: u32;
    var phi_1944_: bool;
    var phi_1988_: vec3<f32>;
    var phi_1989_: vec3<f32>;
    var phi_2018_: vec3<f32>;
    var phi_2019_: vec3<f32>;
    var phi_2048_: vec3<f32>;
    var phi_2049_: vec3<f32>;
    var phi_2067_: bool;
    var phi_2068_: bool;
    var phi_2072_: f32;
    var phi_2073_: f32;
    var phi_2074_: f32;
    var phi_2075_: f32;
    var phi_2083_: f32;
    var phi_2093_: bool;
    var phi_2094_: bool;
    var phi_2098_: f32;
    var phi_2099_: f32;
    var phi_2100_: f32;
    var phi_2101_: f32;
    var phi_2109_: f32;
    var phi_2119_: bool;
    var phi_2120_: bool;
    var phi_2124_: f32;
    var phi_2125_: f32;
    var phi_2126_: f32;
    var phi_2127_: f32;
    var phi_2135_: f32;
    var phi_2150_: f32;
    var phi_2151_: bool;
    var phi_2152_: f32;
    var phi_2153_: bool;
    var phi_2154_: f32;
    var phi_2155_: bool;
    var phi_2173_: f32;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2176_: f32;
    var phi_2177_: bool;
    var phi_2178_: bool;
    var phi_2182_: bool;
    var phi_2183_: f32;
    var phi_2184_: bool;
    var phi_2212_: vec3<f32>;
    var phi_2213_: vec3<f32>;
    var phi_2238_: vec3<f32>;
    var phi_2239_: vec3<f32>;
    var phi_2264_: vec3<f32>;
    var phi_2265_: vec3<f32>;
    var phi_2321_: f32;
    var phi_2330_: f32;
    var phi_2339_: f32;
    var phi_2348_: f32;
    var phi_2355_: f32;
    var phi_2362_: f32;
    var phi_2375_: f32;
    var phi_2384_: f32;
    var phi_2393_: f32;
    var phi_2402_: f32;
    var phi_2409_: f32;
    var phi_2416_: f32;
    var phi_2433_: f32;
    var phi_2438_: f32;
    var phi_2443_: f32;
    var phi_2451_: f32;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2473_: f32;
    var phi_2478_: f32;
    var phi_2483_: f32;
    var phi_2488_: f32;
    var phi_2493_: lt_bvh_triangle_Intersection;
    var phi_2494_: bool;
    var phi_2495_: lt_bvh_triangle_Intersection;
    var phi_2496_: bool;
    var phi_2500_: lt_bvh_triangle_Intersection;
    var phi_2501_: bool;
    var phi_2502_: lt_bvh_triangle_Intersection;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2508_: bool;
    var phi_2512_: lt_bvh_triangle_Intersection;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_1942_: u32;
    var phi_1945_: bool;
    var phi_2542_: bool;
    var local_8: bool;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2616_: u32;
    var phi_2617_: u32;
    var phi_1610_: u32;
    var phi_1613_: bool;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var local_9: bool;
    var phi_2623_: bool;
    var phi_2627_: bool;
    var phi_2628_: bool;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2634_: bool;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2643_: bool;
    var phi_2644_: bool;
    var phi_1002_: u32;
    var phi_1005_: bool;
    var phi_2648_: bool;
    var local_10: bool;
    var phi_2690_: bool;
    var phi_2691_: bool;
    var phi_2722_: u32;
    var phi_2723_: u32;
    var phi_670_: u32;
    var phi_673_: bool;
    var phi_2724_: bool;
    var phi_2725_: bool;
    var local_11: bool;
    var phi_2729_: bool;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var phi_2735_: bool;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2744_: bool;
    var phi_2748_: f32;
    var phi_2769_: u32;
    var phi_2784_: u32;
    var phi_2789_: u32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

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
                phi_2733_ = false;
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
                phi_672_ = false;
                loop {
                    let _e476 = phi_669_;
                    let _e478 = phi_672_;
                    if (_e476 != 4294967295u) {
                        if (_e476 < _e62) {
                        } else {
                            return;
                        }
                        let _e485 = nodes.member[(0u + _e476)].frame[3u];
                        let _e510 = (bitcast<f32>((((_e485 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e270);
                        let _e511 = (bitcast<f32>((((_e485 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e280);
                        let _e512 = (bitcast<f32>((((_e485 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                        let _e515 = nodes.member[(0u + _e476)].frame[0u];
                        let _e519 = nodes.member[(0u + _e476)].frame[1u];
                        let _e523 = nodes.member[(0u + _e476)].frame[2u];
                        let _e528 = ((bitcast<f32>(_e515) - _e112) * _e270);
                        let _e529 = ((bitcast<f32>(_e519) - _e114) * _e280);
                        let _e530 = ((bitcast<f32>(_e523) - _e116) * _e290);
                        let _e538 = nodes.member[(0u + _e476)].x;
                        if (_e270 < 0f) {
                            let _e549 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e538.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e555 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e549.unnamed.root, _e538.w), _e549.unnamed_1);
                            let _e561 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e555.unnamed, lt_bvh_traverse_Tree(_e538.x, _e555.unnamed_1.first_primitive));
                            phi_752_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e561.unnamed, lt_bvh_traverse_Tree(_e561.unnamed_1.root, _e538.y));
                        } else {
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e538.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e577.unnamed.root, _e538.y), _e577.unnamed_1);
                            let _e589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_bvh_traverse_Tree(_e538.z, _e583.unnamed_1.first_primitive));
                            phi_752_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e589.unnamed, lt_bvh_traverse_Tree(_e589.unnamed_1.root, _e538.w));
                        }
                        let _e597 = phi_752_;
                        let _e607 = nodes.member[(0u + _e476)].y;
                        if (_e280 < 0f) {
                            let _e618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e607.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e618.unnamed.root, _e607.w), _e618.unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_bvh_traverse_Tree(_e607.x, _e624.unnamed_1.first_primitive));
                            phi_779_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_bvh_traverse_Tree(_e630.unnamed_1.root, _e607.y));
                        } else {
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e607.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.unnamed.root, _e607.y), _e646.unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e607.z, _e652.unnamed_1.first_primitive));
                            phi_779_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_bvh_traverse_Tree(_e658.unnamed_1.root, _e607.w));
                        }
                        let _e666 = phi_779_;
                        let _e676 = nodes.member[(0u + _e476)].z;
                        if (_e290 < 0f) {
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e676.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e687.unnamed.root, _e676.w), _e687.unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_bvh_traverse_Tree(_e676.x, _e693.unnamed_1.first_primitive));
                            phi_806_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_bvh_traverse_Tree(_e699.unnamed_1.root, _e676.y));
                        } else {
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e676.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.unnamed.root, _e676.y), _e715.unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e676.z, _e721.unnamed_1.first_primitive));
                            phi_806_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_bvh_traverse_Tree(_e727.unnamed_1.root, _e676.w));
                        }
                        let _e735 = phi_806_;
                        phi_812_ = 0u;
                        phi_815_ = 0u;
                        loop {
                            let _e745 = phi_812_;
                            let _e747 = phi_815_;
                            local_2 = _e747;
                            local_3 = _e747;
                            local_4 = _e747;
                            let _e748 = (_e745 < 8u);
                            if _e748 {
                                let _e750 = (_e745 >> bitcast<u32>(2i));
                                let _e751 = (_e745 & 3u);
                                if (_e750 == 0u) {
                                    phi_829_ = _e597.unnamed.root;
                                } else {
                                    phi_829_ = _e597.unnamed.first_primitive;
                                }
                                let _e754 = phi_829_;
                                if (_e750 == 0u) {
                                    phi_839_ = _e666.unnamed.root;
                                } else {
                                    phi_839_ = _e666.unnamed.first_primitive;
                                }
                                let _e763 = phi_839_;
                                if (_e750 == 0u) {
                                    phi_849_ = _e735.unnamed.root;
                                } else {
                                    phi_849_ = _e735.unnamed.first_primitive;
                                }
                                let _e772 = phi_849_;
                                let _e785 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e754 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u)) * _e510) + (_e528 - _e318)), ((f32(((_e763 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u)) * _e511) + (_e529 - _e319)));
                                let _e786 = core_intrinsics_maximum_number_nsz_f32_(_e785, ((f32(((_e772 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u)) * _e512) + (_e530 - _e320)));
                                if (_e750 == 0u) {
                                    phi_867_ = _e597.unnamed_1.root;
                                } else {
                                    phi_867_ = _e597.unnamed_1.first_primitive;
                                }
                                let _e789 = phi_867_;
                                if (_e750 == 0u) {
                                    phi_877_ = _e666.unnamed_1.root;
                                } else {
                                    phi_877_ = _e666.unnamed_1.first_primitive;
                                }
                                let _e798 = phi_877_;
                                if (_e750 == 0u) {
                                    phi_887_ = _e735.unnamed_1.root;
                                } else {
                                    phi_887_ = _e735.unnamed_1.first_primitive;
                                }
                                let _e807 = phi_887_;
                                let _e820 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e789 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u)) * _e510) + (_e528 + _e318)), ((f32(((_e798 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u)) * _e511) + (_e529 + _e319)));
                                let _e821 = core_intrinsics_minimum_number_nsz_f32_(_e820, ((f32(((_e807 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u)) * _e512) + (_e530 + _e320)));
                                if (_e786 <= _e821) {
                                    if (_e786 <= _e122) {
                                        if (_e821 >= 0f) {
                                            if (_e750 == 0u) {
                                                let _e828 = nodes.member[(0u + _e476)].links[2u];
                                                phi_923_ = _e828;
                                            } else {
                                                let _e831 = nodes.member[(0u + _e476)].links[3u];
                                                phi_923_ = _e831;
                                            }
                                            let _e833 = phi_923_;
                                            let _e838 = ((_e833 >> bitcast<u32>(((_e751 * 8u) & 31u))) & 255u);
                                            let _e839 = (_e838 & 31u);
                                            if (_e839 >= 24u) {
                                                phi_936_ = (24u + ((_e839 - 24u) ^ _e338));
                                            } else {
                                                phi_936_ = _e839;
                                            }
                                            let _e845 = phi_936_;
                                            phi_941_ = (_e747 | ((_e838 >> bitcast<u32>(5i)) << bitcast<u32>((_e845 & 31u))));
                                        } else {
                                            phi_941_ = _e747;
                                        }
                                        let _e853 = phi_941_;
                                        phi_942_ = _e853;
                                    } else {
                                        phi_942_ = _e747;
                                    }
                                    let _e855 = phi_942_;
                                    phi_943_ = _e855;
                                } else {
                                    phi_943_ = _e747;
                                }
                                let _e857 = phi_943_;
                                phi_813_ = (_e745 + 1u);
                                phi_816_ = _e857;
                            } else {
                                phi_813_ = u32();
                                phi_816_ = u32();
                            }
                            let _e860 = phi_813_;
                            let _e862 = phi_816_;
                            continue;
                            continuing {
                                phi_812_ = _e860;
                                phi_815_ = _e862;
                                break if !(_e748);
                            }
                        }
                        let _e866 = nodes.member[(0u + _e476)].links[0u];
                        let _e870 = nodes.member[(0u + _e476)].frame[3u];
                        let _e874 = local_2;
                        if ((_e874 & 4278190080u) == 0u) {
                        } else {
                            let _e878 = local_1.group_mask;
                            if ((_e878 & 4278190080u) == 0u) {
                            } else {
                                let _e882 = local_1.len;
                                if (_e882 < 32u) {
                                    let _e885 = local_1.group;
                                    let _e887 = local_1.len;
                                    if (_e887 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e887)] = _e885;
                                    let _e893 = local_1.group_mask;
                                    let _e895 = local_1.len;
                                    if (_e895 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e895)] = _e893;
                                    let _e902 = local_1.len;
                                    local_1.len = (_e902 + 1u);
                                }
                            }
                            local_1.group = (_e92 + _e866);
                            let _e906 = local_3;
                            local_1.group_mask = ((_e906 & 4278190080u) | (_e870 >> bitcast<u32>(24i)));
                        }
                        let _e911 = local_4;
                        phi_1001_ = (_e911 & 16777215u);
                        phi_1004_ = _e478;
                        loop {
                            let _e914 = phi_1001_;
                            let _e916 = phi_1004_;
                            local_15 = _e916;
                            let _e917 = (_e914 == 0u);
                            local_10 = _e917;
                            local_16 = _e917;
                            if _e917 {
                                phi_1002_ = u32();
                                phi_1005_ = bool();
                                phi_2648_ = false;
                            } else {
                                let _e920 = nodes.member[(0u + _e476)].links[1u];
                                let _e924 = (_e920 + select(firstTrailingBit(_e914), 32u, (_e914 == 0u)));
                                if (_e924 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e931 = instances.member[(0u + _e924)].low_world;
                                let _e933 = instances.member[(0u + _e924)].high_world;
                                let _e940 = ((_e931.x - _e112) * _e270);
                                let _e941 = ((_e931.y - _e114) * _e280);
                                let _e942 = ((_e931.z - _e116) * _e290);
                                let _e949 = ((_e933.x - _e112) * _e270);
                                let _e950 = ((_e933.y - _e114) * _e280);
                                let _e951 = ((_e933.z - _e116) * _e290);
                                if (_e940 < _e949) {
                                    phi_1053_ = _e940;
                                } else {
                                    phi_1053_ = _e949;
                                }
                                let _e954 = phi_1053_;
                                if (_e941 < _e950) {
                                    phi_1058_ = _e941;
                                } else {
                                    phi_1058_ = _e950;
                                }
                                let _e957 = phi_1058_;
                                if (_e942 < _e951) {
                                    phi_1063_ = _e942;
                                } else {
                                    phi_1063_ = _e951;
                                }
                                let _e960 = phi_1063_;
                                if (_e940 > _e949) {
                                    phi_1071_ = _e940;
                                } else {
                                    phi_1071_ = _e949;
                                }
                                let _e966 = phi_1071_;
                                if (_e941 > _e950) {
                                    phi_1076_ = _e941;
                                } else {
                                    phi_1076_ = _e950;
                                }
                                let _e969 = phi_1076_;
                                if (_e942 > _e951) {
                                    phi_1081_ = _e942;
                                } else {
                                    phi_1081_ = _e951;
                                }
                                let _e972 = phi_1081_;
                                let _e976 = core_intrinsics_maximum_number_nsz_f32_((_e954 - _e325), (_e957 - _e326));
                                let _e977 = core_intrinsics_maximum_number_nsz_f32_(_e976, (_e960 - _e327));
                                let _e978 = core_intrinsics_minimum_number_nsz_f32_((_e966 + _e325), (_e969 + _e326));
                                let _e979 = core_intrinsics_minimum_number_nsz_f32_(_e978, (_e972 + _e327));
                                if (_e977 <= _e979) {
                                    if (_e977 <= _e122) {
                                        if (_e979 >= 0f) {
                                            let _e985 = instances.member[(0u + _e924)].world_to_object[0u];
                                            let _e996 = ((((_e985.x * _e112) + (_e985.y * _e114)) + (_e985.z * _e116)) + (_e985.w * 1f));
                                            let _e998 = instances.member[(0u + _e924)].world_to_object[1u];
                                            let _e1009 = ((((_e998.x * _e112) + (_e998.y * _e114)) + (_e998.z * _e116)) + (_e998.w * 1f));
                                            let _e1011 = instances.member[(0u + _e924)].world_to_object[2u];
                                            let _e1022 = ((((_e1011.x * _e112) + (_e1011.y * _e114)) + (_e1011.z * _e116)) + (_e1011.w * 1f));
                                            let _e1025 = instances.member[(0u + _e924)].world_to_object[0u];
                                            let _e1036 = ((((_e1025.x * _e130) + (_e1025.y * _e131)) + (_e1025.z * _e132)) + (_e1025.w * 0f));
                                            let _e1038 = instances.member[(0u + _e924)].world_to_object[1u];
                                            let _e1049 = ((((_e1038.x * _e130) + (_e1038.y * _e131)) + (_e1038.z * _e132)) + (_e1038.w * 0f));
                                            let _e1051 = instances.member[(0u + _e924)].world_to_object[2u];
                                            let _e1062 = ((((_e1051.x * _e130) + (_e1051.y * _e131)) + (_e1051.z * _e132)) + (_e1051.w * 0f));
                                            let _e1065 = instances.member[(0u + _e924)].root;
                                            let _e1067 = instances.member[(0u + _e924)].first_triangle;
                                            let _e1071 = abs(_e1036);
                                            let _e1072 = abs(_e1049);
                                            let _e1073 = abs(_e1062);
                                            if (abs(_e996) < 1000000000000000f) {
                                                if (abs(_e1009) < 1000000000000000f) {
                                                    if (abs(_e1022) < 1000000000000000f) {
                                                        if (_e1071 < 1000000000000000f) {
                                                            if (_e1072 < 1000000000000000f) {
                                                                if (_e1073 < 1000000000000000f) {
                                                                    if (_e1071 > 0f) {
                                                                        phi_1226_ = bool();
                                                                        phi_1227_ = true;
                                                                    } else {
                                                                        let _e1081 = (_e1072 > 0f);
                                                                        if _e1081 {
                                                                            phi_1225_ = bool();
                                                                        } else {
                                                                            phi_1225_ = (_e1073 > 0f);
                                                                        }
                                                                        let _e1084 = phi_1225_;
                                                                        phi_1226_ = _e1084;
                                                                        phi_1227_ = _e1081;
                                                                    }
                                                                    let _e1086 = phi_1226_;
                                                                    let _e1088 = phi_1227_;
                                                                    if _e1088 {
                                                                        phi_1231_ = true;
                                                                    } else {
                                                                        phi_1231_ = _e1086;
                                                                    }
                                                                    let _e1090 = phi_1231_;
                                                                    phi_1232_ = _e1090;
                                                                    phi_1233_ = false;
                                                                } else {
                                                                    phi_1232_ = bool();
                                                                    phi_1233_ = true;
                                                                }
                                                                let _e1092 = phi_1232_;
                                                                let _e1094 = phi_1233_;
                                                                phi_1234_ = _e1092;
                                                                phi_1235_ = false;
                                                                phi_1236_ = _e1094;
                                                            } else {
                                                                phi_1234_ = bool();
                                                                phi_1235_ = true;
                                                                phi_1236_ = false;
                                                            }
                                                            let _e1096 = phi_1234_;
                                                            let _e1098 = phi_1235_;
                                                            let _e1100 = phi_1236_;
                                                            phi_1237_ = _e1096;
                                                            phi_1238_ = _e1098;
                                                            phi_1239_ = _e1100;
                                                        } else {
                                                            phi_1237_ = bool();
                                                            phi_1238_ = true;
                                                            phi_1239_ = false;
                                                        }
                                                        let _e1102 = phi_1237_;
                                                        let _e1104 = phi_1238_;
                                                        let _e1106 = phi_1239_;
                                                        phi_1240_ = _e1102;
                                                        phi_1241_ = _e1104;
                                                        phi_1242_ = _e1106;
                                                    } else {
                                                        phi_1240_ = bool();
                                                        phi_1241_ = true;
                                                        phi_1242_ = false;
                                                    }
                                                    let _e1108 = phi_1240_;
                                                    let _e1110 = phi_1241_;
                                                    let _e1112 = phi_1242_;
                                                    phi_1243_ = _e1108;
                                                    phi_1244_ = _e1110;
                                                    phi_1245_ = _e1112;
                                                } else {
                                                    phi_1243_ = bool();
                                                    phi_1244_ = true;
                                                    phi_1245_ = false;
                                                }
                                                let _e1114 = phi_1243_;
                                                let _e1116 = phi_1244_;
                                                let _e1118 = phi_1245_;
                                                phi_1246_ = _e1114;
                                                phi_1247_ = _e1116;
                                                phi_1248_ = _e1118;
                                            } else {
                                                phi_1246_ = bool();
                                                phi_1247_ = true;
                                                phi_1248_ = false;
                                            }
                                            let _e1120 = phi_1246_;
                                            let _e1122 = phi_1247_;
                                            let _e1124 = phi_1248_;
                                            if _e1122 {
                                                phi_1252_ = true;
                                            } else {
                                                phi_1252_ = _e1124;
                                            }
                                            let _e1126 = phi_1252_;
                                            if _e1126 {
                                                phi_1256_ = false;
                                            } else {
                                                phi_1256_ = _e1120;
                                            }
                                            let _e1128 = phi_1256_;
                                            if _e1128 {
                                                let _e1129 = (_e1065 >= _e62);
                                                if _e1129 {
                                                    phi_2628_ = bool();
                                                } else {
                                                    if (_e1065 < _e62) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1135 = nodes.member[(0u + _e1065)].frame[0u];
                                                    let _e1139 = nodes.member[(0u + _e1065)].frame[1u];
                                                    let _e1143 = nodes.member[(0u + _e1065)].frame[2u];
                                                    let _e1147 = nodes.member[(0u + _e1065)].frame[0u];
                                                    let _e1151 = nodes.member[(0u + _e1065)].frame[1u];
                                                    let _e1155 = nodes.member[(0u + _e1065)].frame[2u];
                                                    let _e1159 = nodes.member[(0u + _e1065)].frame[3u];
                                                    let _e1193 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1036), abs(_e1049));
                                                    let _e1194 = core_intrinsics_maximum_number_nsz_f32_(_e1193, abs(_e1062));
                                                    let _e1195 = (_e1194 * 0.0000000000009094947f);
                                                    if (abs(_e1036) < _e1195) {
                                                        phi_1326_ = _e1195;
                                                    } else {
                                                        phi_1326_ = abs(_e1036);
                                                    }
                                                    let _e1200 = phi_1326_;
                                                    if (_e1036 < 0f) {
                                                        phi_1333_ = (-1f / _e1200);
                                                    } else {
                                                        phi_1333_ = (1f / _e1200);
                                                    }
                                                    let _e1205 = phi_1333_;
                                                    if (abs(_e1049) < _e1195) {
                                                        phi_1340_ = _e1195;
                                                    } else {
                                                        phi_1340_ = abs(_e1049);
                                                    }
                                                    let _e1210 = phi_1340_;
                                                    if (_e1049 < 0f) {
                                                        phi_1347_ = (-1f / _e1210);
                                                    } else {
                                                        phi_1347_ = (1f / _e1210);
                                                    }
                                                    let _e1215 = phi_1347_;
                                                    if (abs(_e1062) < _e1195) {
                                                        phi_1354_ = _e1195;
                                                    } else {
                                                        phi_1354_ = abs(_e1062);
                                                    }
                                                    let _e1220 = phi_1354_;
                                                    if (_e1062 < 0f) {
                                                        phi_1361_ = (-1f / _e1220);
                                                    } else {
                                                        phi_1361_ = (1f / _e1220);
                                                    }
                                                    let _e1225 = phi_1361_;
                                                    let _e1229 = abs((bitcast<f32>(_e1135) - _e996));
                                                    let _e1230 = abs((bitcast<f32>(_e1139) - _e1009));
                                                    let _e1231 = abs((bitcast<f32>(_e1143) - _e1022));
                                                    let _e1235 = abs(((bitcast<f32>(_e1147) + (bitcast<f32>((((_e1159 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e996));
                                                    let _e1236 = abs(((bitcast<f32>(_e1151) + (bitcast<f32>((((_e1159 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1009));
                                                    let _e1237 = abs(((bitcast<f32>(_e1155) + (bitcast<f32>((((_e1159 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1022));
                                                    if (_e1229 > _e1235) {
                                                        phi_1378_ = _e1229;
                                                    } else {
                                                        phi_1378_ = _e1235;
                                                    }
                                                    let _e1240 = phi_1378_;
                                                    if (_e1230 > _e1236) {
                                                        phi_1383_ = _e1230;
                                                    } else {
                                                        phi_1383_ = _e1236;
                                                    }
                                                    let _e1243 = phi_1383_;
                                                    if (_e1231 > _e1237) {
                                                        phi_1388_ = _e1231;
                                                    } else {
                                                        phi_1388_ = _e1237;
                                                    }
                                                    let _e1246 = phi_1388_;
                                                    let _e1247 = core_intrinsics_maximum_number_nsz_f32_(_e1240, _e1243);
                                                    let _e1248 = core_intrinsics_maximum_number_nsz_f32_(_e1247, _e1246);
                                                    let _e1252 = (_e1248 * 0.0000019073486f);
                                                    let _e1253 = (abs(_e1205) * _e1252);
                                                    let _e1254 = (abs(_e1215) * _e1252);
                                                    let _e1255 = (abs(_e1225) * _e1252);
                                                    let _e1259 = (_e1248 * 0.0000009536743f);
                                                    let _e1260 = (abs(_e1205) * _e1259);
                                                    let _e1261 = (abs(_e1215) * _e1259);
                                                    let _e1262 = (abs(_e1225) * _e1259);
                                                    let _e1263 = abs(_e1036);
                                                    let _e1264 = abs(_e1049);
                                                    let _e1265 = abs(_e1062);
                                                    if (_e1263 >= _e1264) {
                                                        if (_e1263 >= _e1265) {
                                                            phi_1416_ = false;
                                                        } else {
                                                            phi_1416_ = true;
                                                        }
                                                        let _e1269 = phi_1416_;
                                                        phi_1417_ = _e1269;
                                                    } else {
                                                        phi_1417_ = true;
                                                    }
                                                    let _e1271 = phi_1417_;
                                                    if _e1271 {
                                                        if (_e1264 >= _e1265) {
                                                            phi_1425_ = 1u;
                                                        } else {
                                                            phi_1425_ = 2u;
                                                        }
                                                        let _e1274 = phi_1425_;
                                                        phi_1426_ = _e1274;
                                                    } else {
                                                        phi_1426_ = 0u;
                                                    }
                                                    let _e1276 = phi_1426_;
                                                    if (_e1276 == 0u) {
                                                        phi_1438_ = vec3<f32>(_e1049, _e1062, _e1036);
                                                    } else {
                                                        if (_e1276 == 1u) {
                                                            phi_1437_ = vec3<f32>(_e1062, _e1036, _e1049);
                                                        } else {
                                                            phi_1437_ = vec3<f32>(_e1036, _e1049, _e1062);
                                                        }
                                                        let _e1282 = phi_1437_;
                                                        phi_1438_ = _e1282;
                                                    }
                                                    let _e1284 = phi_1438_;
                                                    let _e1287 = (_e1284.x / _e1284.z);
                                                    let _e1290 = (_e1284.y / _e1284.z);
                                                    if (_e1205 < 0f) {
                                                        phi_1451_ = 0u;
                                                    } else {
                                                        phi_1451_ = 1u;
                                                    }
                                                    let _e1295 = phi_1451_;
                                                    if (_e1215 < 0f) {
                                                        phi_1456_ = 0u;
                                                    } else {
                                                        phi_1456_ = 2u;
                                                    }
                                                    let _e1298 = phi_1456_;
                                                    if (_e1225 < 0f) {
                                                        phi_1461_ = 0u;
                                                    } else {
                                                        phi_1461_ = 4u;
                                                    }
                                                    let _e1301 = phi_1461_;
                                                    let _e1303 = ((_e1295 | _e1298) | _e1301);
                                                    let _e1304 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1065, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1304.first[0], _e1304.first[1], _e1304.first[2], _e1304.first[3], _e1304.first[4], _e1304.first[5], _e1304.first[6], _e1304.first[7], _e1304.first[8], _e1304.first[9], _e1304.first[10], _e1304.first[11], _e1304.first[12], _e1304.first[13], _e1304.first[14], _e1304.first[15], _e1304.first[16], _e1304.first[17], _e1304.first[18], _e1304.first[19], _e1304.first[20], _e1304.first[21], _e1304.first[22], _e1304.first[23], _e1304.first[24], _e1304.first[25], _e1304.first[26], _e1304.first[27], _e1304.first[28], _e1304.first[29], _e1304.first[30], _e1304.first[31]), array<u32, 32>(_e1304.mask[0], _e1304.mask[1], _e1304.mask[2], _e1304.mask[3], _e1304.mask[4], _e1304.mask[5], _e1304.mask[6], _e1304.mask[7], _e1304.mask[8], _e1304.mask[9], _e1304.mask[10], _e1304.mask[11], _e1304.mask[12], _e1304.mask[13], _e1304.mask[14], _e1304.mask[15], _e1304.mask[16], _e1304.mask[17], _e1304.mask[18], _e1304.mask[19], _e1304.mask[20], _e1304.mask[21], _e1304.mask[22], _e1304.mask[23], _e1304.mask[24], _e1304.mask[25], _e1304.mask[26], _e1304.mask[27], _e1304.mask[28], _e1304.mask[29], _e1304.mask[30], _e1304.mask[31]), _e1304.len, _e1304.group, _e1304.group_mask);
                                                    let _e1378 = local.group_mask;
                                                    if ((_e1378 & 4278190080u) == 0u) {
                                                        let _e1382 = local.len;
                                                        if (_e1382 == 0u) {
                                                            phi_1575_ = false;
                                                        } else {
                                                            let _e1386 = local.len;
                                                            local.len = (_e1386 - 1u);
                                                            let _e1389 = local.len;
                                                            if (_e1389 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1394 = local.first[(0u + _e1389)];
                                                            local.group = _e1394;
                                                            let _e1397 = local.len;
                                                            if (_e1397 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1402 = local.mask[(0u + _e1397)];
                                                            local.group_mask = _e1402;
                                                            phi_1575_ = true;
                                                        }
                                                        let _e1405 = phi_1575_;
                                                        phi_1576_ = _e1405;
                                                    } else {
                                                        phi_1576_ = true;
                                                    }
                                                    let _e1407 = phi_1576_;
                                                    if _e1407 {
                                                        let _e1409 = local.group_mask;
                                                        let _e1415 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1409)), 32u, (_e1409 == 0u)));
                                                        let _e1419 = local.group_mask;
                                                        let _e1433 = local.group_mask;
                                                        local.group_mask = (_e1433 & ~((1u << bitcast<u32>((_e1415 & 31u)))));
                                                        let _e1436 = local.group;
                                                        phi_1607_ = (_e1436 + countOneBits(((_e1419 & ~((4294967295u << bitcast<u32>((((_e1415 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1607_ = 4294967295u;
                                                    }
                                                    let _e1439 = phi_1607_;
                                                    phi_1609_ = _e1439;
                                                    phi_1612_ = _e916;
                                                    loop {
                                                        let _e1441 = phi_1609_;
                                                        let _e1443 = phi_1612_;
                                                        local_14 = _e1443;
                                                        if (_e1441 != 4294967295u) {
                                                            if (_e1441 < _e62) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1450 = nodes.member[(0u + _e1441)].frame[3u];
                                                            let _e1475 = (bitcast<f32>((((_e1450 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1205);
                                                            let _e1476 = (bitcast<f32>((((_e1450 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1215);
                                                            let _e1477 = (bitcast<f32>((((_e1450 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1225);
                                                            let _e1480 = nodes.member[(0u + _e1441)].frame[0u];
                                                            let _e1484 = nodes.member[(0u + _e1441)].frame[1u];
                                                            let _e1488 = nodes.member[(0u + _e1441)].frame[2u];
                                                            let _e1493 = ((bitcast<f32>(_e1480) - _e996) * _e1205);
                                                            let _e1494 = ((bitcast<f32>(_e1484) - _e1009) * _e1215);
                                                            let _e1495 = ((bitcast<f32>(_e1488) - _e1022) * _e1225);
                                                            let _e1503 = nodes.member[(0u + _e1441)].x;
                                                            if (_e1205 < 0f) {
                                                                let _e1514 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1503.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1520 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1514.unnamed.root, _e1503.w), _e1514.unnamed_1);
                                                                let _e1526 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1520.unnamed, lt_bvh_traverse_Tree(_e1503.x, _e1520.unnamed_1.first_primitive));
                                                                phi_1692_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1526.unnamed, lt_bvh_traverse_Tree(_e1526.unnamed_1.root, _e1503.y));
                                                            } else {
                                                                let _e1542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1503.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1542.unnamed.root, _e1503.y), _e1542.unnamed_1);
                                                                let _e1554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1548.unnamed, lt_bvh_traverse_Tree(_e1503.z, _e1548.unnamed_1.first_primitive));
                                                                phi_1692_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1554.unnamed, lt_bvh_traverse_Tree(_e1554.unnamed_1.root, _e1503.w));
                                                            }
                                                            let _e1562 = phi_1692_;
                                                            let _e1572 = nodes.member[(0u + _e1441)].y;
                                                            if (_e1215 < 0f) {
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1572.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1583.unnamed.root, _e1572.w), _e1583.unnamed_1);
                                                                let _e1595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1589.unnamed, lt_bvh_traverse_Tree(_e1572.x, _e1589.unnamed_1.first_primitive));
                                                                phi_1719_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1595.unnamed, lt_bvh_traverse_Tree(_e1595.unnamed_1.root, _e1572.y));
                                                            } else {
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1572.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1611.unnamed.root, _e1572.y), _e1611.unnamed_1);
                                                                let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1572.z, _e1617.unnamed_1.first_primitive));
                                                                phi_1719_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1623.unnamed, lt_bvh_traverse_Tree(_e1623.unnamed_1.root, _e1572.w));
                                                            }
                                                            let _e1631 = phi_1719_;
                                                            let _e1641 = nodes.member[(0u + _e1441)].z;
                                                            if (_e1225 < 0f) {
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1641.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1652.unnamed.root, _e1641.w), _e1652.unnamed_1);
                                                                let _e1664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1658.unnamed, lt_bvh_traverse_Tree(_e1641.x, _e1658.unnamed_1.first_primitive));
                                                                phi_1746_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1664.unnamed, lt_bvh_traverse_Tree(_e1664.unnamed_1.root, _e1641.y));
                                                            } else {
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1641.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1680.unnamed.root, _e1641.y), _e1680.unnamed_1);
                                                                let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1641.z, _e1686.unnamed_1.first_primitive));
                                                                phi_1746_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1692.unnamed, lt_bvh_traverse_Tree(_e1692.unnamed_1.root, _e1641.w));
                                                            }
                                                            let _e1700 = phi_1746_;
                                                            phi_1752_ = 0u;
                                                            phi_1755_ = 0u;
                                                            loop {
                                                                let _e1710 = phi_1752_;
                                                                let _e1712 = phi_1755_;
                                                                local_5 = _e1712;
                                                                local_6 = _e1712;
                                                                local_7 = _e1712;
                                                                let _e1713 = (_e1710 < 8u);
                                                                if _e1713 {
                                                                    let _e1715 = (_e1710 >> bitcast<u32>(2i));
                                                                    let _e1716 = (_e1710 & 3u);
                                                                    if (_e1715 == 0u) {
                                                                        phi_1769_ = _e1562.unnamed.root;
                                                                    } else {
                                                                        phi_1769_ = _e1562.unnamed.first_primitive;
                                                                    }
                                                                    let _e1719 = phi_1769_;
                                                                    if (_e1715 == 0u) {
                                                                        phi_1779_ = _e1631.unnamed.root;
                                                                    } else {
                                                                        phi_1779_ = _e1631.unnamed.first_primitive;
                                                                    }
                                                                    let _e1728 = phi_1779_;
                                                                    if (_e1715 == 0u) {
                                                                        phi_1789_ = _e1700.unnamed.root;
                                                                    } else {
                                                                        phi_1789_ = _e1700.unnamed.first_primitive;
                                                                    }
                                                                    let _e1737 = phi_1789_;
                                                                    let _e1750 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1719 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u)) * _e1475) + (_e1493 - _e1253)), ((f32(((_e1728 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u)) * _e1476) + (_e1494 - _e1254)));
                                                                    let _e1751 = core_intrinsics_maximum_number_nsz_f32_(_e1750, ((f32(((_e1737 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u)) * _e1477) + (_e1495 - _e1255)));
                                                                    if (_e1715 == 0u) {
                                                                        phi_1807_ = _e1562.unnamed_1.root;
                                                                    } else {
                                                                        phi_1807_ = _e1562.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1754 = phi_1807_;
                                                                    if (_e1715 == 0u) {
                                                                        phi_1817_ = _e1631.unnamed_1.root;
                                                                    } else {
                                                                        phi_1817_ = _e1631.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1763 = phi_1817_;
                                                                    if (_e1715 == 0u) {
                                                                        phi_1827_ = _e1700.unnamed_1.root;
                                                                    } else {
                                                                        phi_1827_ = _e1700.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1772 = phi_1827_;
                                                                    let _e1785 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1754 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u)) * _e1475) + (_e1493 + _e1253)), ((f32(((_e1763 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u)) * _e1476) + (_e1494 + _e1254)));
                                                                    let _e1786 = core_intrinsics_minimum_number_nsz_f32_(_e1785, ((f32(((_e1772 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u)) * _e1477) + (_e1495 + _e1255)));
                                                                    if (_e1751 <= _e1786) {
                                                                        if (_e1751 <= _e122) {
                                                                            if (_e1786 >= 0f) {
                                                                                if (_e1715 == 0u) {
                                                                                    let _e1793 = nodes.member[(0u + _e1441)].links[2u];
                                                                                    phi_1863_ = _e1793;
                                                                                } else {
                                                                                    let _e1796 = nodes.member[(0u + _e1441)].links[3u];
                                                                                    phi_1863_ = _e1796;
                                                                                }
                                                                                let _e1798 = phi_1863_;
                                                                                let _e1803 = ((_e1798 >> bitcast<u32>(((_e1716 * 8u) & 31u))) & 255u);
                                                                                let _e1804 = (_e1803 & 31u);
                                                                                if (_e1804 >= 24u) {
                                                                                    phi_1876_ = (24u + ((_e1804 - 24u) ^ _e1303));
                                                                                } else {
                                                                                    phi_1876_ = _e1804;
                                                                                }
                                                                                let _e1810 = phi_1876_;
                                                                                phi_1881_ = (_e1712 | ((_e1803 >> bitcast<u32>(5i)) << bitcast<u32>((_e1810 & 31u))));
                                                                            } else {
                                                                                phi_1881_ = _e1712;
                                                                            }
                                                                            let _e1818 = phi_1881_;
                                                                            phi_1882_ = _e1818;
                                                                        } else {
                                                                            phi_1882_ = _e1712;
                                                                        }
                                                                        let _e1820 = phi_1882_;
                                                                        phi_1883_ = _e1820;
                                                                    } else {
                                                                        phi_1883_ = _e1712;
                                                                    }
                                                                    let _e1822 = phi_1883_;
                                                                    phi_1753_ = (_e1710 + 1u);
                                                                    phi_1756_ = _e1822;
                                                                } else {
                                                                    phi_1753_ = u32();
                                                                    phi_1756_ = u32();
                                                                }
                                                                let _e1825 = phi_1753_;
                                                                let _e1827 = phi_1756_;
                                                                continue;
                                                                continuing {
                                                                    phi_1752_ = _e1825;
                                                                    phi_1755_ = _e1827;
                                                                    break if !(_e1713);
                                                                }
                                                            }
                                                            let _e1831 = nodes.member[(0u + _e1441)].links[0u];
                                                            let _e1835 = nodes.member[(0u + _e1441)].frame[3u];
                                                            let _e1839 = local_5;
                                                            if ((_e1839 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1843 = local.group_mask;
                                                                if ((_e1843 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1847 = local.len;
                                                                    if (_e1847 < 32u) {
                                                                        let _e1850 = local.group;
                                                                        let _e1852 = local.len;
                                                                        if (_e1852 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1852)] = _e1850;
                                                                        let _e1858 = local.group_mask;
                                                                        let _e1860 = local.len;
                                                                        if (_e1860 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1860)] = _e1858;
                                                                        let _e1867 = local.len;
                                                                        local.len = (_e1867 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1065 + _e1831);
                                                                let _e1871 = local_6;
                                                                local.group_mask = ((_e1871 & 4278190080u) | (_e1835 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1876 = local_7;
                                                            phi_1941_ = (_e1876 & 16777215u);
                                                            phi_1944_ = _e1443;
                                                            loop {
                                                                let _e1879 = phi_1941_;
                                                                let _e1881 = phi_1944_;
                                                                local_12 = _e1881;
                                                                let _e1882 = (_e1879 == 0u);
                                                                local_8 = _e1882;
                                                                local_13 = _e1882;
                                                                if _e1882 {
                                                                    phi_1942_ = u32();
                                                                    phi_1945_ = bool();
                                                                    phi_2542_ = false;
                                                                } else {
                                                                    let _e1885 = nodes.member[(0u + _e1441)].links[1u];
                                                                    let _e1890 = ((_e1067 + _e1885) + select(firstTrailingBit(_e1879), 32u, (_e1879 == 0u)));
                                                                    if (_e1890 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1897 = triangles.member[(0u + _e1890)].v0_;
                                                                    let _e1899 = (_e1897.x - _e996);
                                                                    let _e1901 = (_e1897.y - _e1009);
                                                                    let _e1903 = (_e1897.z - _e1022);
                                                                    if (_e1276 == 0u) {
                                                                        phi_1989_ = vec3<f32>(_e1901, _e1903, _e1899);
                                                                    } else {
                                                                        if (_e1276 == 1u) {
                                                                            phi_1988_ = vec3<f32>(_e1903, _e1899, _e1901);
                                                                        } else {
                                                                            phi_1988_ = (_e1897 - vec3<f32>(_e996, _e1009, _e1022));
                                                                        }
                                                                        let _e1911 = phi_1988_;
                                                                        phi_1989_ = _e1911;
                                                                    }
                                                                    let _e1913 = phi_1989_;
                                                                    let _e1917 = (_e1913.x - (_e1287 * _e1913.z));
                                                                    let _e1921 = (_e1913.y - (_e1290 * _e1913.z));
                                                                    let _e1923 = triangles.member[(0u + _e1890)].v1_;
                                                                    let _e1925 = (_e1923.x - _e996);
                                                                    let _e1927 = (_e1923.y - _e1009);
                                                                    let _e1929 = (_e1923.z - _e1022);
                                                                    if (_e1276 == 0u) {
                                                                        phi_2019_ = vec3<f32>(_e1927, _e1929, _e1925);
                                                                    } else {
                                                                        if (_e1276 == 1u) {
                                                                            phi_2018_ = vec3<f32>(_e1929, _e1925, _e1927);
                                                                        } else {
                                                                            phi_2018_ = (_e1923 - vec3<f32>(_e996, _e1009, _e1022));
                                                                        }
                                                                        let _e1937 = phi_2018_;
                                                                        phi_2019_ = _e1937;
                                                                    }
                                                                    let _e1939 = phi_2019_;
                                                                    let _e1943 = (_e1939.x - (_e1287 * _e1939.z));
                                                                    let _e1947 = (_e1939.y - (_e1290 * _e1939.z));
                                                                    let _e1949 = triangles.member[(0u + _e1890)].v2_;
                                                                    let _e1951 = (_e1949.x - _e996);
                                                                    let _e1953 = (_e1949.y - _e1009);
                                                                    let _e1955 = (_e1949.z - _e1022);
                                                                    if (_e1276 == 0u) {
                                                                        phi_2049_ = vec3<f32>(_e1953, _e1955, _e1951);
                                                                    } else {
                                                                        if (_e1276 == 1u) {
                                                                            phi_2048_ = vec3<f32>(_e1955, _e1951, _e1953);
                                                                        } else {
                                                                            phi_2048_ = (_e1949 - vec3<f32>(_e996, _e1009, _e1022));
                                                                        }
                                                                        let _e1963 = phi_2048_;
                                                                        phi_2049_ = _e1963;
                                                                    }
                                                                    let _e1965 = phi_2049_;
                                                                    let _e1969 = (_e1965.x - (_e1287 * _e1965.z));
                                                                    let _e1973 = (_e1965.y - (_e1290 * _e1965.z));
                                                                    if (_e1943 < _e1969) {
                                                                        phi_2068_ = true;
                                                                    } else {
                                                                        if (_e1943 == _e1969) {
                                                                            phi_2067_ = (_e1947 < _e1973);
                                                                        } else {
                                                                            phi_2067_ = false;
                                                                        }
                                                                        let _e1978 = phi_2067_;
                                                                        phi_2068_ = _e1978;
                                                                    }
                                                                    let _e1980 = phi_2068_;
                                                                    if _e1980 {
                                                                        phi_2072_ = _e1973;
                                                                        phi_2073_ = _e1969;
                                                                        phi_2074_ = _e1947;
                                                                        phi_2075_ = _e1943;
                                                                    } else {
                                                                        phi_2072_ = _e1947;
                                                                        phi_2073_ = _e1943;
                                                                        phi_2074_ = _e1973;
                                                                        phi_2075_ = _e1969;
                                                                    }
                                                                    let _e1982 = phi_2072_;
                                                                    let _e1984 = phi_2073_;
                                                                    let _e1986 = phi_2074_;
                                                                    let _e1988 = phi_2075_;
                                                                    let _e1991 = ((_e1988 * _e1982) - (_e1986 * _e1984));
                                                                    if _e1980 {
                                                                        phi_2083_ = -(_e1991);
                                                                    } else {
                                                                        phi_2083_ = _e1991;
                                                                    }
                                                                    let _e1994 = phi_2083_;
                                                                    if (_e1969 < _e1917) {
                                                                        phi_2094_ = true;
                                                                    } else {
                                                                        if (_e1969 == _e1917) {
                                                                            phi_2093_ = (_e1973 < _e1921);
                                                                        } else {
                                                                            phi_2093_ = false;
                                                                        }
                                                                        let _e1999 = phi_2093_;
                                                                        phi_2094_ = _e1999;
                                                                    }
                                                                    let _e2001 = phi_2094_;
                                                                    if _e2001 {
                                                                        phi_2098_ = _e1921;
                                                                        phi_2099_ = _e1917;
                                                                        phi_2100_ = _e1973;
                                                                        phi_2101_ = _e1969;
                                                                    } else {
                                                                        phi_2098_ = _e1973;
                                                                        phi_2099_ = _e1969;
                                                                        phi_2100_ = _e1921;
                                                                        phi_2101_ = _e1917;
                                                                    }
                                                                    let _e2003 = phi_2098_;
                                                                    let _e2005 = phi_2099_;
                                                                    let _e2007 = phi_2100_;
                                                                    let _e2009 = phi_2101_;
                                                                    let _e2012 = ((_e2009 * _e2003) - (_e2007 * _e2005));
                                                                    if _e2001 {
                                                                        phi_2109_ = -(_e2012);
                                                                    } else {
                                                                        phi_2109_ = _e2012;
                                                                    }
                                                                    let _e2015 = phi_2109_;
                                                                    if (_e1917 < _e1943) {
                                                                        phi_2120_ = true;
                                                                    } else {
                                                                        if (_e1917 == _e1943) {
                                                                            phi_2119_ = (_e1921 < _e1947);
                                                                        } else {
                                                                            phi_2119_ = false;
                                                                        }
                                                                        let _e2020 = phi_2119_;
                                                                        phi_2120_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2120_;
                                                                    if _e2022 {
                                                                        phi_2124_ = _e1947;
                                                                        phi_2125_ = _e1943;
                                                                        phi_2126_ = _e1921;
                                                                        phi_2127_ = _e1917;
                                                                    } else {
                                                                        phi_2124_ = _e1921;
                                                                        phi_2125_ = _e1917;
                                                                        phi_2126_ = _e1947;
                                                                        phi_2127_ = _e1943;
                                                                    }
                                                                    let _e2024 = phi_2124_;
                                                                    let _e2026 = phi_2125_;
                                                                    let _e2028 = phi_2126_;
                                                                    let _e2030 = phi_2127_;
                                                                    let _e2033 = ((_e2030 * _e2024) - (_e2028 * _e2026));
                                                                    if _e2022 {
                                                                        phi_2135_ = -(_e2033);
                                                                    } else {
                                                                        phi_2135_ = _e2033;
                                                                    }
                                                                    let _e2036 = phi_2135_;
                                                                    if (_e1994 >= 0f) {
                                                                        if (_e2015 >= 0f) {
                                                                            if (_e2036 >= 0f) {
                                                                                phi_2150_ = ((_e1994 + _e2015) + _e2036);
                                                                                phi_2151_ = false;
                                                                            } else {
                                                                                phi_2150_ = f32();
                                                                                phi_2151_ = true;
                                                                            }
                                                                            let _e2043 = phi_2150_;
                                                                            let _e2045 = phi_2151_;
                                                                            phi_2152_ = _e2043;
                                                                            phi_2153_ = _e2045;
                                                                        } else {
                                                                            phi_2152_ = f32();
                                                                            phi_2153_ = true;
                                                                        }
                                                                        let _e2047 = phi_2152_;
                                                                        let _e2049 = phi_2153_;
                                                                        phi_2154_ = _e2047;
                                                                        phi_2155_ = _e2049;
                                                                    } else {
                                                                        phi_2154_ = f32();
                                                                        phi_2155_ = true;
                                                                    }
                                                                    let _e2051 = phi_2154_;
                                                                    let _e2053 = phi_2155_;
                                                                    if _e2053 {
                                                                        if (_e1994 <= 0f) {
                                                                            if (_e2015 <= 0f) {
                                                                                let _e2056 = (_e2036 <= 0f);
                                                                                if _e2056 {
                                                                                }
                                                                                phi_2173_ = ((_e1994 + _e2015) + _e2036);
                                                                                phi_2174_ = false;
                                                                                phi_2175_ = _e2056;
                                                                            } else {
                                                                                phi_2173_ = f32();
                                                                                phi_2174_ = true;
                                                                                phi_2175_ = false;
                                                                            }
                                                                            let _e2060 = phi_2173_;
                                                                            let _e2062 = phi_2174_;
                                                                            let _e2064 = phi_2175_;
                                                                            phi_2176_ = _e2060;
                                                                            phi_2177_ = _e2062;
                                                                            phi_2178_ = _e2064;
                                                                        } else {
                                                                            phi_2176_ = f32();
                                                                            phi_2177_ = true;
                                                                            phi_2178_ = false;
                                                                        }
                                                                        let _e2066 = phi_2176_;
                                                                        let _e2068 = phi_2177_;
                                                                        let _e2070 = phi_2178_;
                                                                        if _e2068 {
                                                                            phi_2182_ = false;
                                                                        } else {
                                                                            phi_2182_ = _e2070;
                                                                        }
                                                                        let _e2072 = phi_2182_;
                                                                        phi_2183_ = _e2066;
                                                                        phi_2184_ = _e2072;
                                                                    } else {
                                                                        phi_2183_ = _e2051;
                                                                        phi_2184_ = true;
                                                                    }
                                                                    let _e2074 = phi_2183_;
                                                                    let _e2076 = phi_2184_;
                                                                    if _e2076 {
                                                                        let _e2077 = (_e2074 == 0f);
                                                                        if _e2077 {
                                                                            phi_2500_ = lt_bvh_triangle_Intersection();
                                                                            phi_2501_ = false;
                                                                        } else {
                                                                            let _e2079 = triangles.member[(0u + _e1890)].v0_;
                                                                            let _e2081 = (_e2079.x - _e996);
                                                                            let _e2083 = (_e2079.y - _e1009);
                                                                            let _e2085 = (_e2079.z - _e1022);
                                                                            if (_e1276 == 0u) {
                                                                                phi_2213_ = vec3<f32>(_e2083, _e2085, _e2081);
                                                                            } else {
                                                                                if (_e1276 == 1u) {
                                                                                    phi_2212_ = vec3<f32>(_e2085, _e2081, _e2083);
                                                                                } else {
                                                                                    phi_2212_ = (_e2079 - vec3<f32>(_e996, _e1009, _e1022));
                                                                                }
                                                                                let _e2093 = phi_2212_;
                                                                                phi_2213_ = _e2093;
                                                                            }
                                                                            let _e2095 = phi_2213_;
                                                                            let _e2097 = triangles.member[(0u + _e1890)].v1_;
                                                                            let _e2099 = triangles.member[(0u + _e1890)].v0_;
                                                                            let _e2102 = (_e2097.x - _e2099.x);
                                                                            let _e2105 = (_e2097.y - _e2099.y);
                                                                            let _e2108 = (_e2097.z - _e2099.z);
                                                                            if (_e1276 == 0u) {
                                                                                phi_2239_ = vec3<f32>(_e2105, _e2108, _e2102);
                                                                            } else {
                                                                                if (_e1276 == 1u) {
                                                                                    phi_2238_ = vec3<f32>(_e2108, _e2102, _e2105);
                                                                                } else {
                                                                                    phi_2238_ = (_e2097 - _e2099);
                                                                                }
                                                                                let _e2115 = phi_2238_;
                                                                                phi_2239_ = _e2115;
                                                                            }
                                                                            let _e2117 = phi_2239_;
                                                                            let _e2119 = triangles.member[(0u + _e1890)].v2_;
                                                                            let _e2121 = triangles.member[(0u + _e1890)].v0_;
                                                                            let _e2124 = (_e2119.x - _e2121.x);
                                                                            let _e2127 = (_e2119.y - _e2121.y);
                                                                            let _e2130 = (_e2119.z - _e2121.z);
                                                                            if (_e1276 == 0u) {
                                                                                phi_2265_ = vec3<f32>(_e2127, _e2130, _e2124);
                                                                            } else {
                                                                                if (_e1276 == 1u) {
                                                                                    phi_2264_ = vec3<f32>(_e2130, _e2124, _e2127);
                                                                                } else {
                                                                                    phi_2264_ = (_e2119 - _e2121);
                                                                                }
                                                                                let _e2137 = phi_2264_;
                                                                                phi_2265_ = _e2137;
                                                                            }
                                                                            let _e2139 = phi_2265_;
                                                                            let _e2146 = ((_e2117.y * _e2139.z) - (_e2117.z * _e2139.y));
                                                                            let _e2153 = ((_e2117.z * _e2139.x) - (_e2117.x * _e2139.z));
                                                                            let _e2160 = ((_e2117.x * _e2139.y) - (_e2117.y * _e2139.x));
                                                                            let _e2174 = (((1f / _e1284.z) * (((_e2146 * _e2095.x) + (_e2153 * _e2095.y)) + (_e2160 * _e2095.z))) / (((_e2146 * _e1287) + (_e2153 * _e1290)) + _e2160));
                                                                            if (_e2174 > 0f) {
                                                                                if (_e2174 < _e122) {
                                                                                    let _e2178 = triangles.member[(0u + _e1890)].v0_;
                                                                                    let _e2180 = triangles.member[(0u + _e1890)].v1_;
                                                                                    if (_e2178.x < _e2180.x) {
                                                                                        phi_2321_ = _e2178.x;
                                                                                    } else {
                                                                                        phi_2321_ = _e2180.x;
                                                                                    }
                                                                                    let _e2187 = phi_2321_;
                                                                                    if (_e2178.y < _e2180.y) {
                                                                                        phi_2330_ = _e2178.y;
                                                                                    } else {
                                                                                        phi_2330_ = _e2180.y;
                                                                                    }
                                                                                    let _e2194 = phi_2330_;
                                                                                    if (_e2178.z < _e2180.z) {
                                                                                        phi_2339_ = _e2178.z;
                                                                                    } else {
                                                                                        phi_2339_ = _e2180.z;
                                                                                    }
                                                                                    let _e2201 = phi_2339_;
                                                                                    let _e2203 = triangles.member[(0u + _e1890)].v2_;
                                                                                    if (_e2187 < _e2203.x) {
                                                                                        phi_2348_ = _e2187;
                                                                                    } else {
                                                                                        phi_2348_ = _e2203.x;
                                                                                    }
                                                                                    let _e2208 = phi_2348_;
                                                                                    if (_e2194 < _e2203.y) {
                                                                                        phi_2355_ = _e2194;
                                                                                    } else {
                                                                                        phi_2355_ = _e2203.y;
                                                                                    }
                                                                                    let _e2213 = phi_2355_;
                                                                                    if (_e2201 < _e2203.z) {
                                                                                        phi_2362_ = _e2201;
                                                                                    } else {
                                                                                        phi_2362_ = _e2203.z;
                                                                                    }
                                                                                    let _e2218 = phi_2362_;
                                                                                    let _e2220 = triangles.member[(0u + _e1890)].v0_;
                                                                                    let _e2222 = triangles.member[(0u + _e1890)].v1_;
                                                                                    if (_e2220.x > _e2222.x) {
                                                                                        phi_2375_ = _e2220.x;
                                                                                    } else {
                                                                                        phi_2375_ = _e2222.x;
                                                                                    }
                                                                                    let _e2229 = phi_2375_;
                                                                                    if (_e2220.y > _e2222.y) {
                                                                                        phi_2384_ = _e2220.y;
                                                                                    } else {
                                                                                        phi_2384_ = _e2222.y;
                                                                                    }
                                                                                    let _e2236 = phi_2384_;
                                                                                    if (_e2220.z > _e2222.z) {
                                                                                        phi_2393_ = _e2220.z;
                                                                                    } else {
                                                                                        phi_2393_ = _e2222.z;
                                                                                    }
                                                                                    let _e2243 = phi_2393_;
                                                                                    let _e2245 = triangles.member[(0u + _e1890)].v2_;
                                                                                    if (_e2229 > _e2245.x) {
                                                                                        phi_2402_ = _e2229;
                                                                                    } else {
                                                                                        phi_2402_ = _e2245.x;
                                                                                    }
                                                                                    let _e2250 = phi_2402_;
                                                                                    if (_e2236 > _e2245.y) {
                                                                                        phi_2409_ = _e2236;
                                                                                    } else {
                                                                                        phi_2409_ = _e2245.y;
                                                                                    }
                                                                                    let _e2255 = phi_2409_;
                                                                                    if (_e2243 > _e2245.z) {
                                                                                        phi_2416_ = _e2243;
                                                                                    } else {
                                                                                        phi_2416_ = _e2245.z;
                                                                                    }
                                                                                    let _e2260 = phi_2416_;
                                                                                    let _e2264 = ((_e2208 - _e996) * _e1205);
                                                                                    let _e2265 = ((_e2213 - _e1009) * _e1215);
                                                                                    let _e2266 = ((_e2218 - _e1022) * _e1225);
                                                                                    let _e2270 = ((_e2250 - _e996) * _e1205);
                                                                                    let _e2271 = ((_e2255 - _e1009) * _e1215);
                                                                                    let _e2272 = ((_e2260 - _e1022) * _e1225);
                                                                                    if (_e2264 < _e2270) {
                                                                                        phi_2433_ = _e2264;
                                                                                    } else {
                                                                                        phi_2433_ = _e2270;
                                                                                    }
                                                                                    let _e2275 = phi_2433_;
                                                                                    if (_e2265 < _e2271) {
                                                                                        phi_2438_ = _e2265;
                                                                                    } else {
                                                                                        phi_2438_ = _e2271;
                                                                                    }
                                                                                    let _e2278 = phi_2438_;
                                                                                    if (_e2266 < _e2272) {
                                                                                        phi_2443_ = _e2266;
                                                                                    } else {
                                                                                        phi_2443_ = _e2272;
                                                                                    }
                                                                                    let _e2281 = phi_2443_;
                                                                                    if (_e2264 > _e2270) {
                                                                                        phi_2451_ = _e2264;
                                                                                    } else {
                                                                                        phi_2451_ = _e2270;
                                                                                    }
                                                                                    let _e2287 = phi_2451_;
                                                                                    if (_e2265 > _e2271) {
                                                                                        phi_2456_ = _e2265;
                                                                                    } else {
                                                                                        phi_2456_ = _e2271;
                                                                                    }
                                                                                    let _e2290 = phi_2456_;
                                                                                    if (_e2266 > _e2272) {
                                                                                        phi_2461_ = _e2266;
                                                                                    } else {
                                                                                        phi_2461_ = _e2272;
                                                                                    }
                                                                                    let _e2293 = phi_2461_;
                                                                                    let _e2297 = core_intrinsics_maximum_number_nsz_f32_((_e2275 - _e1260), (_e2278 - _e1261));
                                                                                    let _e2298 = core_intrinsics_maximum_number_nsz_f32_(_e2297, (_e2281 - _e1262));
                                                                                    let _e2299 = core_intrinsics_minimum_number_nsz_f32_((_e2287 + _e1260), (_e2290 + _e1261));
                                                                                    let _e2300 = core_intrinsics_minimum_number_nsz_f32_(_e2299, (_e2293 + _e1262));
                                                                                    if (_e2298 > _e977) {
                                                                                        phi_2473_ = _e2298;
                                                                                    } else {
                                                                                        phi_2473_ = _e977;
                                                                                    }
                                                                                    let _e2303 = phi_2473_;
                                                                                    if (_e2300 < _e979) {
                                                                                        phi_2478_ = _e2300;
                                                                                    } else {
                                                                                        phi_2478_ = _e979;
                                                                                    }
                                                                                    let _e2306 = phi_2478_;
                                                                                    if (_e2174 < _e2303) {
                                                                                        phi_2483_ = _e2303;
                                                                                    } else {
                                                                                        phi_2483_ = _e2174;
                                                                                    }
                                                                                    let _e2309 = phi_2483_;
                                                                                    if (_e2309 > _e2306) {
                                                                                        phi_2488_ = _e2306;
                                                                                    } else {
                                                                                        phi_2488_ = _e2309;
                                                                                    }
                                                                                    let _e2312 = phi_2488_;
                                                                                    phi_2493_ = lt_bvh_triangle_Intersection(_e2312, (_e2015 / _e2074), (_e2036 / _e2074), (_e2303 <= _e2306));
                                                                                    phi_2494_ = false;
                                                                                } else {
                                                                                    phi_2493_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2494_ = true;
                                                                                }
                                                                                let _e2318 = phi_2493_;
                                                                                let _e2320 = phi_2494_;
                                                                                phi_2495_ = _e2318;
                                                                                phi_2496_ = _e2320;
                                                                            } else {
                                                                                phi_2495_ = lt_bvh_triangle_Intersection();
                                                                                phi_2496_ = true;
                                                                            }
                                                                            let _e2322 = phi_2495_;
                                                                            let _e2324 = phi_2496_;
                                                                            if _e2324 {
                                                                            }
                                                                            phi_2500_ = _e2322;
                                                                            phi_2501_ = _e2324;
                                                                        }
                                                                        let _e2326 = phi_2500_;
                                                                        let _e2328 = phi_2501_;
                                                                        phi_2502_ = _e2326;
                                                                        phi_2503_ = _e2077;
                                                                        phi_2504_ = _e2328;
                                                                    } else {
                                                                        phi_2502_ = lt_bvh_triangle_Intersection();
                                                                        phi_2503_ = true;
                                                                        phi_2504_ = false;
                                                                    }
                                                                    let _e2330 = phi_2502_;
                                                                    let _e2332 = phi_2503_;
                                                                    let _e2334 = phi_2504_;
                                                                    if _e2332 {
                                                                        phi_2508_ = true;
                                                                    } else {
                                                                        phi_2508_ = _e2334;
                                                                    }
                                                                    let _e2336 = phi_2508_;
                                                                    if _e2336 {
                                                                        phi_2512_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2512_ = _e2330;
                                                                    }
                                                                    let _e2338 = phi_2512_;
                                                                    if _e2338.is_hit {
                                                                        if (_e2338.t > 0f) {
                                                                            if (_e2338.t < _e122) {
                                                                                if true {
                                                                                    phi_2532_ = false;
                                                                                } else {
                                                                                    phi_2532_ = true;
                                                                                }
                                                                                let _e2347 = phi_2532_;
                                                                                phi_2533_ = true;
                                                                                phi_2534_ = _e2347;
                                                                            } else {
                                                                                phi_2533_ = _e1881;
                                                                                phi_2534_ = true;
                                                                            }
                                                                            let _e2349 = phi_2533_;
                                                                            let _e2351 = phi_2534_;
                                                                            phi_2535_ = _e2349;
                                                                            phi_2536_ = _e2351;
                                                                        } else {
                                                                            phi_2535_ = _e1881;
                                                                            phi_2536_ = true;
                                                                        }
                                                                        let _e2353 = phi_2535_;
                                                                        let _e2355 = phi_2536_;
                                                                        phi_2537_ = _e2353;
                                                                        phi_2538_ = _e2355;
                                                                    } else {
                                                                        phi_2537_ = _e1881;
                                                                        phi_2538_ = true;
                                                                    }
                                                                    let _e2357 = phi_2537_;
                                                                    let _e2359 = phi_2538_;
                                                                    if _e2359 {
                                                                    }
                                                                    phi_1942_ = (_e1879 & (_e1879 - 1u));
                                                                    phi_1945_ = _e2357;
                                                                    phi_2542_ = _e2359;
                                                                }
                                                                let _e2361 = phi_1942_;
                                                                let _e2363 = phi_1945_;
                                                                let _e2365 = phi_2542_;
                                                                continue;
                                                                continuing {
                                                                    phi_1941_ = _e2361;
                                                                    phi_1944_ = _e2363;
                                                                    break if !(_e2365);
                                                                }
                                                            }
                                                            let _e2368 = local_8;
                                                            if _e2368 {
                                                                let _e2370 = local.group_mask;
                                                                if ((_e2370 & 4278190080u) == 0u) {
                                                                    let _e2374 = local.len;
                                                                    if (_e2374 == 0u) {
                                                                        phi_2584_ = false;
                                                                    } else {
                                                                        let _e2378 = local.len;
                                                                        local.len = (_e2378 - 1u);
                                                                        let _e2381 = local.len;
                                                                        if (_e2381 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2386 = local.first[(0u + _e2381)];
                                                                        local.group = _e2386;
                                                                        let _e2389 = local.len;
                                                                        if (_e2389 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2394 = local.mask[(0u + _e2389)];
                                                                        local.group_mask = _e2394;
                                                                        phi_2584_ = true;
                                                                    }
                                                                    let _e2397 = phi_2584_;
                                                                    phi_2585_ = _e2397;
                                                                } else {
                                                                    phi_2585_ = true;
                                                                }
                                                                let _e2399 = phi_2585_;
                                                                if _e2399 {
                                                                    let _e2401 = local.group_mask;
                                                                    let _e2407 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2401)), 32u, (_e2401 == 0u)));
                                                                    let _e2411 = local.group_mask;
                                                                    let _e2425 = local.group_mask;
                                                                    local.group_mask = (_e2425 & ~((1u << bitcast<u32>((_e2407 & 31u)))));
                                                                    let _e2428 = local.group;
                                                                    phi_2616_ = (_e2428 + countOneBits(((_e2411 & ~((4294967295u << bitcast<u32>((((_e2407 - 24u) ^ _e1303) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2616_ = 4294967295u;
                                                                }
                                                                let _e2431 = phi_2616_;
                                                                phi_2617_ = _e2431;
                                                            } else {
                                                                phi_2617_ = u32();
                                                            }
                                                            let _e2433 = phi_2617_;
                                                            phi_1610_ = _e2433;
                                                            let _e2839 = local_12;
                                                            phi_1613_ = _e2839;
                                                            let _e2842 = local_13;
                                                            phi_2618_ = _e2842;
                                                            phi_2619_ = false;
                                                        } else {
                                                            phi_1610_ = u32();
                                                            phi_1613_ = bool();
                                                            phi_2618_ = false;
                                                            phi_2619_ = true;
                                                        }
                                                        let _e2435 = phi_1610_;
                                                        let _e2437 = phi_1613_;
                                                        let _e2439 = phi_2618_;
                                                        let _e2441 = phi_2619_;
                                                        local_9 = _e2441;
                                                        continue;
                                                        continuing {
                                                            phi_1609_ = _e2435;
                                                            phi_1612_ = _e2437;
                                                            break if !(_e2439);
                                                        }
                                                    }
                                                    let _e2444 = local_9;
                                                    if _e2444 {
                                                        phi_2623_ = false;
                                                    } else {
                                                        phi_2623_ = true;
                                                    }
                                                    let _e2446 = phi_2623_;
                                                    if _e2446 {
                                                        phi_2627_ = true;
                                                    } else {
                                                        let _e2848 = local_14;
                                                        phi_2627_ = _e2848;
                                                    }
                                                    let _e2448 = phi_2627_;
                                                    phi_2628_ = _e2448;
                                                }
                                                let _e2450 = phi_2628_;
                                                phi_2629_ = _e2450;
                                                phi_2630_ = _e1129;
                                            } else {
                                                phi_2629_ = bool();
                                                phi_2630_ = true;
                                            }
                                            let _e2452 = phi_2629_;
                                            let _e2454 = phi_2630_;
                                            if _e2454 {
                                                phi_2634_ = _e916;
                                            } else {
                                                phi_2634_ = _e2452;
                                            }
                                            let _e2456 = phi_2634_;
                                            if _e2456 {
                                                phi_2638_ = false;
                                            } else {
                                                phi_2638_ = true;
                                            }
                                            let _e2458 = phi_2638_;
                                            phi_2639_ = _e2456;
                                            phi_2640_ = _e2458;
                                        } else {
                                            phi_2639_ = _e916;
                                            phi_2640_ = true;
                                        }
                                        let _e2460 = phi_2639_;
                                        let _e2462 = phi_2640_;
                                        phi_2641_ = _e2460;
                                        phi_2642_ = _e2462;
                                    } else {
                                        phi_2641_ = _e916;
                                        phi_2642_ = true;
                                    }
                                    let _e2464 = phi_2641_;
                                    let _e2466 = phi_2642_;
                                    phi_2643_ = _e2464;
                                    phi_2644_ = _e2466;
                                } else {
                                    phi_2643_ = _e916;
                                    phi_2644_ = true;
                                }
                                let _e2468 = phi_2643_;
                                let _e2470 = phi_2644_;
                                if _e2470 {
                                }
                                phi_1002_ = (_e914 & (_e914 - 1u));
                                phi_1005_ = _e2468;
                                phi_2648_ = _e2470;
                            }
                            let _e2472 = phi_1002_;
                            let _e2474 = phi_1005_;
                            let _e2476 = phi_2648_;
                            continue;
                            continuing {
                                phi_1001_ = _e2472;
                                phi_1004_ = _e2474;
                                break if !(_e2476);
                            }
                        }
                        let _e2479 = local_10;
                        if _e2479 {
                            let _e2481 = local_1.group_mask;
                            if ((_e2481 & 4278190080u) == 0u) {
                                let _e2485 = local_1.len;
                                if (_e2485 == 0u) {
                                    phi_2690_ = false;
                                } else {
                                    let _e2489 = local_1.len;
                                    local_1.len = (_e2489 - 1u);
                                    let _e2492 = local_1.len;
                                    if (_e2492 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2497 = local_1.first[(0u + _e2492)];
                                    local_1.group = _e2497;
                                    let _e2500 = local_1.len;
                                    if (_e2500 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2505 = local_1.mask[(0u + _e2500)];
                                    local_1.group_mask = _e2505;
                                    phi_2690_ = true;
                                }
                                let _e2508 = phi_2690_;
                                phi_2691_ = _e2508;
                            } else {
                                phi_2691_ = true;
                            }
                            let _e2510 = phi_2691_;
                            if _e2510 {
                                let _e2512 = local_1.group_mask;
                                let _e2518 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2512)), 32u, (_e2512 == 0u)));
                                let _e2522 = local_1.group_mask;
                                let _e2536 = local_1.group_mask;
                                local_1.group_mask = (_e2536 & ~((1u << bitcast<u32>((_e2518 & 31u)))));
                                let _e2539 = local_1.group;
                                phi_2722_ = (_e2539 + countOneBits(((_e2522 & ~((4294967295u << bitcast<u32>((((_e2518 - 24u) ^ _e338) & 31u))))) & 255u)));
                            } else {
                                phi_2722_ = 4294967295u;
                            }
                            let _e2542 = phi_2722_;
                            phi_2723_ = _e2542;
                        } else {
                            phi_2723_ = u32();
                        }
                        let _e2544 = phi_2723_;
                        phi_670_ = _e2544;
                        let _e2871 = local_15;
                        phi_673_ = _e2871;
                        let _e2874 = local_16;
                        phi_2724_ = _e2874;
                        phi_2725_ = false;
                    } else {
                        phi_670_ = u32();
                        phi_673_ = bool();
                        phi_2724_ = false;
                        phi_2725_ = true;
                    }
                    let _e2546 = phi_670_;
                    let _e2548 = phi_673_;
                    let _e2550 = phi_2724_;
                    let _e2552 = phi_2725_;
                    local_11 = _e2552;
                    continue;
                    continuing {
                        phi_669_ = _e2546;
                        phi_672_ = _e2548;
                        break if !(_e2550);
                    }
                }
                let _e2555 = local_11;
                if _e2555 {
                    phi_2729_ = false;
                } else {
                    phi_2729_ = true;
                }
                let _e2557 = phi_2729_;
                if _e2557 {
                }
                phi_2733_ = _e2557;
            }
            let _e2559 = phi_2733_;
            phi_2734_ = _e194;
            phi_2735_ = _e2559;
        } else {
            phi_2734_ = true;
            phi_2735_ = false;
        }
        let _e2561 = phi_2734_;
        let _e2563 = phi_2735_;
        if _e2561 {
            phi_2739_ = false;
            phi_2740_ = true;
        } else {
            phi_2739_ = true;
            phi_2740_ = _e2563;
        }
        let _e2565 = phi_2739_;
        let _e2567 = phi_2740_;
        if _e2567 {
            phi_2744_ = _e2565;
        } else {
            phi_2744_ = false;
        }
        let _e2569 = phi_2744_;
        if _e2569 {
            phi_2748_ = 0f;
        } else {
            phi_2748_ = 1f;
        }
        let _e2571 = phi_2748_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e90)] = _e2571;
        if (_e90 < _e74) {
        } else {
            return;
        }
        let _e2578 = bits.member[(0u + _e90)];
        if ((_e2578 & 2u) == 0u) {
            phi_2769_ = (_e2578 & 1u);
        } else {
            phi_2769_ = (_e2578 & 7u);
        }
        let _e2584 = phi_2769_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        let _e2588 = visibility.member[(0u + _e90)];
        if ((_e2584 & 1u) != 0u) {
            phi_2784_ = (2u | 1u);
        } else {
            phi_2784_ = 2u;
        }
        let _e2594 = phi_2784_;
        if (_e2588 < 0.5f) {
            phi_2789_ = (_e2594 | 4u);
        } else {
            phi_2789_ = _e2594;
        }
        let _e2597 = phi_2789_;
        if (_e90 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e90)] = _e2597;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
