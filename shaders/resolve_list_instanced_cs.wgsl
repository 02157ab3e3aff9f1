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

struct type_30 {
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

struct type_37 {
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

struct type_46 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_52 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(6) 
var<storage> instances: type_37;
@group(0) @binding(0) 
var<uniform> p: type_52;
@group(0) @binding(2) 
var<storage> nodes: type_46;
@group(0) @binding(3) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_160_: bool;
    var phi_164_: f32;

    if (param != param) {
        phi_160_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_160_ = _e54;
    }
    let _e56 = phi_160_;
    if _e56 {
        phi_164_ = param_1;
    } else {
        phi_164_ = param;
    }
    let _e58 = phi_164_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_176_: bool;
    var phi_180_: f32;

    if (param_2 != param_2) {
        phi_176_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_176_ = _e54;
    }
    let _e56 = phi_176_;
    if _e56 {
        phi_180_ = param_3;
    } else {
        phi_180_ = param_2;
    }
    let _e58 = phi_180_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_262_: f32;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_345_: bool;
    var phi_349_: bool;
    var phi_419_: f32;
    var phi_426_: f32;
    var phi_433_: f32;
    var phi_440_: f32;
    var phi_447_: f32;
    var phi_454_: f32;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_502_: u32;
    var phi_507_: u32;
    var phi_512_: u32;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_658_: u32;
    var phi_660_: u32;
    var phi_741_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_768_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_795_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_801_: u32;
    var phi_804_: u32;
    var phi_818_: u32;
    var phi_828_: u32;
    var phi_838_: u32;
    var phi_856_: u32;
    var phi_866_: u32;
    var phi_876_: u32;
    var phi_912_: u32;
    var phi_925_: u32;
    var phi_930_: u32;
    var phi_931_: u32;
    var phi_932_: u32;
    var phi_802_: u32;
    var phi_805_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_990_: u32;
    var phi_1040_: f32;
    var phi_1045_: f32;
    var phi_1050_: f32;
    var phi_1058_: f32;
    var phi_1063_: f32;
    var phi_1068_: f32;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1239_: bool;
    var phi_1243_: bool;
    var phi_1313_: f32;
    var phi_1320_: f32;
    var phi_1327_: f32;
    var phi_1334_: f32;
    var phi_1341_: f32;
    var phi_1348_: f32;
    var phi_1365_: f32;
    var phi_1370_: f32;
    var phi_1375_: f32;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1412_: u32;
    var phi_1413_: u32;
    var phi_1424_: vec3<f32>;
    var phi_1425_: vec3<f32>;
    var phi_1438_: u32;
    var phi_1443_: u32;
    var phi_1448_: u32;
    var phi_1562_: bool;
    var phi_1563_: bool;
    var phi_1594_: u32;
    var phi_1596_: u32;
    var phi_1677_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1704_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1731_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1737_: u32;
    var phi_1740_: u32;
    var phi_1754_: u32;
    var phi_1764_: u32;
    var phi_1774_: u32;
    var phi_1792_: u32;
    var phi_1802_: u32;
    var phi_1812_: u32;
    var phi_1848_: u32;
    var phi_1861_: u32;
    var phi_1866_: u32;
    var phi_1867_: u32;
    var phi_1868_: u32;
    var phi_1738_: u32;
    var phi_1741_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1926_: u32;
    var phi_1971_: vec3<f32>;
    var phi_1972_: vec3<f32>;
    var phi_2001_: vec3<f32>;
    var phi_2002_: vec3<f32>;
    var phi_2031_: vec3<f32>;
    var phi_2032_: vec3<f32>;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2055_: f32;
    var phi_2056_: f32;
    var phi_2057_: f32;
    var phi_2058_: f32;
    var phi_2066_: f32;
    var phi_2076_: bool;
    var phi_2077_: bool;
    var phi_2081_: f32;
    var phi_2082_: f32;
    var phi_2083_: f32;
    var phi_2084_: f32;
    var phi_2092_: f32;
    var phi_2102_: bool;
    var phi_2103_: bool;
    var phi_2107_: f32;
    var phi_2108_: f32;
    var phi_2109_: f32;
    var phi_2110_: f32;
    var phi_2118_: f32;
    var phi_2133_: f32;
    var phi_2134_: bool;
    var phi_2135_: f32;
    var phi_2136_: bool;
    var phi_2137_: f32;
    var phi_2138_: bool;
    var phi_2156_: f32;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2159_: f32;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2165_: bool;
    var phi_2166_: f32;
    var phi_2167_: bool;
    var phi_2195_: vec3<f32>;
    var phi_2196_: vec3<f32>;
    var phi_2221_: vec3<f32>;
    var phi_2222_: vec3<f32>;
    var phi_2247_: vec3<f32>;
    var phi_2248_: vec3<f32>;
    var phi_2304_: f32;
    var phi_2313_: f32;
    var phi_2322_: f32;
    var phi_2331_: f32;
    var phi_2338_: f32;
    var phi_2345_: f32;
    var phi_2358_: f32;
    var phi_2367_: f32;
    var phi_2376_: f32;
    var phi_2385_: f32;
    var phi_2392_: f32;
    var phi_2399_: f32;
    var phi_2416_: f32;
    var phi_2421_: f32;
    var phi_2426_: f32;
    var phi_2434_: f32;
    var phi_2439_: f32;
    var phi_2444_: f32;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2466_: f32;
    var phi_2471_: f32;
    var phi_2476_: lt_bvh_triangle_Intersection;
    var phi_2477_: bool;
    var phi_2478_: lt_bvh_triangle_Intersection;
    var phi_2479_: bool;
    var phi_2483_: lt_bvh_triangle_Intersection;
    var phi_2484_: bool;
    var phi_2485_: lt_bvh_triangle_Intersection;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2491_: bool;
    var phi_2495_: lt_bvh_triangle_Intersection;
    var phi_2520_: bool;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_1927_: u32;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var local_8: bool;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_1597_: u32;
    var phi_2617_: bool;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var phi_2620_: bool;
    var local_9: bool;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2629_: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2640_: bool;
    var phi_2644_: bool;
    var phi_2645_: bool;
    var phi_2646_: bool;
    var phi_2647_: bool;
    var phi_991_: u32;
    var phi_2651_: bool;
    var local_10: bool;
    var phi_2693_: bool;
    var phi_2694_: bool;
    var phi_2725_: u32;
    var phi_2726_: u32;
    var phi_661_: u32;
    var phi_2727_: bool;
    var phi_2728_: bool;
    var local_11: bool;
    var phi_2732_: bool;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var phi_2739_: bool;
    var phi_2743_: bool;
    var phi_2747_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e53 = id_1;
    let _e60 = arrayLength((&nodes.member));
    let _e69 = arrayLength((&list.member));
    let _e76 = ((_e53.y * 2097152u) + _e53.x);
    if (3u < _e69) {
    } else {
        return;
    }
    let _e79 = list.member[3u];
    if (_e76 < _e79) {
        let _e81 = (_e76 + 4u);
        if (_e81 < _e69) {
        } else {
            return;
        }
        let _e85 = list.member[(0u + _e81)];
        let _e87 = p.member.root;
        if (_e85 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e92 = p.member.light;
        let _e94 = samples.member[(0u + _e85)].position;
        let _e96 = samples.member[(0u + _e85)].normal;
        let _e98 = samples.member[(0u + _e85)].magnitude;
        let _e100 = ((8f / 8388608f) * _e98);
        let _e108 = (_e94.x + (_e96.x * _e100));
        let _e110 = (_e94.y + (_e96.y * _e100));
        let _e112 = (_e94.z + (_e96.z * _e100));
        if (_e92.w == 0f) {
            phi_262_ = 300000000000000000000000000000000000000f;
        } else {
            phi_262_ = 1f;
        }
        let _e116 = phi_262_;
        let _e124 = (_e92.x - (_e108 * _e92.w));
        let _e125 = (_e92.y - (_e110 * _e92.w));
        let _e126 = (_e92.z - (_e112 * _e92.w));
        let _e130 = abs(_e124);
        let _e131 = abs(_e125);
        let _e132 = abs(_e126);
        if (abs(_e108) < 1000000000000000f) {
            if (abs(_e110) < 1000000000000000f) {
                if (abs(_e112) < 1000000000000000f) {
                    if (_e130 < 1000000000000000f) {
                        if (_e131 < 1000000000000000f) {
                            if (_e132 < 1000000000000000f) {
                                if (_e130 > 0f) {
                                    phi_319_ = bool();
                                    phi_320_ = true;
                                } else {
                                    let _e140 = (_e131 > 0f);
                                    if _e140 {
                                        phi_318_ = bool();
                                    } else {
                                        phi_318_ = (_e132 > 0f);
                                    }
                                    let _e143 = phi_318_;
                                    phi_319_ = _e143;
                                    phi_320_ = _e140;
                                }
                                let _e145 = phi_319_;
                                let _e147 = phi_320_;
                                if _e147 {
                                    phi_324_ = true;
                                } else {
                                    phi_324_ = _e145;
                                }
                                let _e149 = phi_324_;
                                phi_325_ = _e149;
                                phi_326_ = false;
                            } else {
                                phi_325_ = bool();
                                phi_326_ = true;
                            }
                            let _e151 = phi_325_;
                            let _e153 = phi_326_;
                            phi_327_ = _e151;
                            phi_328_ = false;
                            phi_329_ = _e153;
                        } else {
                            phi_327_ = bool();
                            phi_328_ = true;
                            phi_329_ = false;
                        }
                        let _e155 = phi_327_;
                        let _e157 = phi_328_;
                        let _e159 = phi_329_;
                        phi_330_ = _e155;
                        phi_331_ = _e157;
                        phi_332_ = _e159;
                    } else {
                        phi_330_ = bool();
                        phi_331_ = true;
                        phi_332_ = false;
                    }
                    let _e161 = phi_330_;
                    let _e163 = phi_331_;
                    let _e165 = phi_332_;
                    phi_333_ = _e161;
                    phi_334_ = _e163;
                    phi_335_ = _e165;
                } else {
                    phi_333_ = bool();
                    phi_334_ = true;
                    phi_335_ = false;
                }
                let _e167 = phi_333_;
                let _e169 = phi_334_;
                let _e171 = phi_335_;
                phi_336_ = _e167;
                phi_337_ = _e169;
                phi_338_ = _e171;
            } else {
                phi_336_ = bool();
                phi_337_ = true;
                phi_338_ = false;
            }
            let _e173 = phi_336_;
            let _e175 = phi_337_;
            let _e177 = phi_338_;
            phi_339_ = _e173;
            phi_340_ = _e175;
            phi_341_ = _e177;
        } else {
            phi_339_ = bool();
            phi_340_ = true;
            phi_341_ = false;
        }
        let _e179 = phi_339_;
        let _e181 = phi_340_;
        let _e183 = phi_341_;
        if _e181 {
            phi_345_ = true;
        } else {
            phi_345_ = _e183;
        }
        let _e185 = phi_345_;
        if _e185 {
            phi_349_ = false;
        } else {
            phi_349_ = _e179;
        }
        let _e187 = phi_349_;
        if _e187 {
            let _e188 = (_e87 >= _e60);
            if _e188 {
                phi_2737_ = bool();
            } else {
                if (_e87 < _e60) {
                } else {
                    return;
                }
                let _e194 = nodes.member[(0u + _e87)].frame[0u];
                let _e198 = nodes.member[(0u + _e87)].frame[1u];
                let _e202 = nodes.member[(0u + _e87)].frame[2u];
                let _e206 = nodes.member[(0u + _e87)].frame[0u];
                let _e210 = nodes.member[(0u + _e87)].frame[1u];
                let _e214 = nodes.member[(0u + _e87)].frame[2u];
                let _e218 = nodes.member[(0u + _e87)].frame[3u];
                let _e252 = core_intrinsics_maximum_number_nsz_f32_(abs(_e124), abs(_e125));
                let _e253 = core_intrinsics_maximum_number_nsz_f32_(_e252, abs(_e126));
                let _e254 = (_e253 * 0.0000000000009094947f);
                if (abs(_e124) < _e254) {
                    phi_419_ = _e254;
                } else {
                    phi_419_ = abs(_e124);
                }
                let _e259 = phi_419_;
                if (_e124 < 0f) {
                    phi_426_ = (-1f / _e259);
                } else {
                    phi_426_ = (1f / _e259);
                }
                let _e264 = phi_426_;
                if (abs(_e125) < _e254) {
                    phi_433_ = _e254;
                } else {
                    phi_433_ = abs(_e125);
                }
                let _e269 = phi_433_;
                if (_e125 < 0f) {
                    phi_440_ = (-1f / _e269);
                } else {
                    phi_440_ = (1f / _e269);
                }
                let _e274 = phi_440_;
                if (abs(_e126) < _e254) {
                    phi_447_ = _e254;
                } else {
                    phi_447_ = abs(_e126);
                }
                let _e279 = phi_447_;
                if (_e126 < 0f) {
                    phi_454_ = (-1f / _e279);
                } else {
                    phi_454_ = (1f / _e279);
                }
                let _e284 = phi_454_;
                let _e288 = abs((bitcast<f32>(_e194) - _e108));
                let _e289 = abs((bitcast<f32>(_e198) - _e110));
                let _e290 = abs((bitcast<f32>(_e202) - _e112));
                let _e294 = abs(((bitcast<f32>(_e206) + (bitcast<f32>((((_e218 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e108));
                let _e295 = abs(((bitcast<f32>(_e210) + (bitcast<f32>((((_e218 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e110));
                let _e296 = abs(((bitcast<f32>(_e214) + (bitcast<f32>((((_e218 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e112));
                if (_e288 > _e294) {
                    phi_471_ = _e288;
                } else {
                    phi_471_ = _e294;
                }
                let _e299 = phi_471_;
                if (_e289 > _e295) {
                    phi_476_ = _e289;
                } else {
                    phi_476_ = _e295;
                }
                let _e302 = phi_476_;
                if (_e290 > _e296) {
                    phi_481_ = _e290;
                } else {
                    phi_481_ = _e296;
                }
                let _e305 = phi_481_;
                let _e306 = core_intrinsics_maximum_number_nsz_f32_(_e299, _e302);
                let _e307 = core_intrinsics_maximum_number_nsz_f32_(_e306, _e305);
                let _e311 = (_e307 * 0.0000019073486f);
                let _e312 = (abs(_e264) * _e311);
                let _e313 = (abs(_e274) * _e311);
                let _e314 = (abs(_e284) * _e311);
                let _e318 = (_e307 * 0.0000009536743f);
                let _e319 = (abs(_e264) * _e318);
                let _e320 = (abs(_e274) * _e318);
                let _e321 = (abs(_e284) * _e318);
                if (_e264 < 0f) {
                    phi_502_ = 0u;
                } else {
                    phi_502_ = 1u;
                }
                let _e324 = phi_502_;
                if (_e274 < 0f) {
                    phi_507_ = 0u;
                } else {
                    phi_507_ = 2u;
                }
                let _e327 = phi_507_;
                if (_e284 < 0f) {
                    phi_512_ = 0u;
                } else {
                    phi_512_ = 4u;
                }
                let _e330 = phi_512_;
                let _e332 = ((_e324 | _e327) | _e330);
                let _e333 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e87, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e333.first[0], _e333.first[1], _e333.first[2], _e333.first[3], _e333.first[4], _e333.first[5], _e333.first[6], _e333.first[7], _e333.first[8], _e333.first[9], _e333.first[10], _e333.first[11], _e333.first[12], _e333.first[13], _e333.first[14], _e333.first[15], _e333.first[16], _e333.first[17], _e333.first[18], _e333.first[19], _e333.first[20], _e333.first[21], _e333.first[22], _e333.first[23], _e333.first[24], _e333.first[25], _e333.first[26], _e333.first[27], _e333.first[28], _e333.first[29], _e333.first[30], _e333.first[31]), array<u32, 32>(_e333.mask[0], _e333.mask[1], _e333.mask[2], _e333.mask[3], _e333.mask[4], _e333.mask[5], _e333.mask[6], _e333.mask[7], _e333.mask[8], _e333.mask[9], _e333.mask[10], _e333.mask[11], _e333.mask[12], _e333.mask[13], _e333.mask[14], _e333.mask[15], _e333.mask[16], _e333.mask[17], _e333.mask[18], _e333.mask[19], _e333.mask[20], _e333.mask[21], _e333.mask[22], _e333.mask[23], _e333.mask[24], _e333.mask[25], _e333.mask[26], _e333.mask[27], _e333.mask[28], _e333.mask[29], _e333.mask[30], _e333.mask[31]), _e333.len, _e333.group, _e333.group_mask);
                let _e407 = local_1.group_mask;
                if ((_e407 & 4278190080u) == 0u) {
                    let _e411 = local_1.len;
                    if (_e411 == 0u) {
                        phi_626_ = false;
                    } else {
                        let _e415 = local_1.len;
                        local_1.len = (_e415 - 1u);
                        let _e418 = local_1.len;
                        if (_e418 < 32u) {
                        } else {
                            return;
                        }
                        let _e423 = local_1.first[(0u + _e418)];
                        local_1.group = _e423;
                        let _e426 = local_1.len;
                        if (_e426 < 32u) {
                        } else {
                            return;
                        }
                        let _e431 = local_1.mask[(0u + _e426)];
                        local_1.group_mask = _e431;
                        phi_626_ = true;
                    }
                    let _e434 = phi_626_;
                    phi_627_ = _e434;
                } else {
                    phi_627_ = true;
                }
                let _e436 = phi_627_;
                if _e436 {
                    let _e438 = local_1.group_mask;
                    let _e444 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e438)), 32u, (_e438 == 0u)));
                    let _e448 = local_1.group_mask;
                    let _e462 = local_1.group_mask;
                    local_1.group_mask = (_e462 & ~((1u << bitcast<u32>((_e444 & 31u)))));
                    let _e465 = local_1.group;
                    phi_658_ = (_e465 + countOneBits(((_e448 & ~((4294967295u << bitcast<u32>((((_e444 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_658_ = 4294967295u;
                }
                let _e468 = phi_658_;
                phi_660_ = _e468;
                loop {
                    let _e470 = phi_660_;
                    if (_e470 != 4294967295u) {
                        if (_e470 < _e60) {
                        } else {
                            return;
                        }
                        let _e477 = nodes.member[(0u + _e470)].frame[3u];
                        let _e502 = (bitcast<f32>((((_e477 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e264);
                        let _e503 = (bitcast<f32>((((_e477 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e274);
                        let _e504 = (bitcast<f32>((((_e477 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e507 = nodes.member[(0u + _e470)].frame[0u];
                        let _e511 = nodes.member[(0u + _e470)].frame[1u];
                        let _e515 = nodes.member[(0u + _e470)].frame[2u];
                        let _e520 = ((bitcast<f32>(_e507) - _e108) * _e264);
                        let _e521 = ((bitcast<f32>(_e511) - _e110) * _e274);
                        let _e522 = ((bitcast<f32>(_e515) - _e112) * _e284);
                        let _e530 = nodes.member[(0u + _e470)].x;
                        if (_e264 < 0f) {
                            let _e541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e530.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e541.unnamed.root, _e530.w), _e541.unnamed_1);
                            let _e553 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e547.unnamed, lt_bvh_traverse_Tree(_e530.x, _e547.unnamed_1.first_primitive));
                            phi_741_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e553.unnamed, lt_bvh_traverse_Tree(_e553.unnamed_1.root, _e530.y));
                        } else {
                            let _e569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e530.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e569.unnamed.root, _e530.y), _e569.unnamed_1);
                            let _e581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e575.unnamed, lt_bvh_traverse_Tree(_e530.z, _e575.unnamed_1.first_primitive));
                            phi_741_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_bvh_traverse_Tree(_e581.unnamed_1.root, _e530.w));
                        }
                        let _e589 = phi_741_;
                        let _e599 = nodes.member[(0u + _e470)].y;
                        if (_e274 < 0f) {
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e610.unnamed.root, _e599.w), _e610.unnamed_1);
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e616.unnamed, lt_bvh_traverse_Tree(_e599.x, _e616.unnamed_1.first_primitive));
                            phi_768_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e622.unnamed, lt_bvh_traverse_Tree(_e622.unnamed_1.root, _e599.y));
                        } else {
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e638.unnamed.root, _e599.y), _e638.unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e599.z, _e644.unnamed_1.first_primitive));
                            phi_768_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e650.unnamed_1.root, _e599.w));
                        }
                        let _e658 = phi_768_;
                        let _e668 = nodes.member[(0u + _e470)].z;
                        if (_e284 < 0f) {
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.unnamed.root, _e668.w), _e679.unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_bvh_traverse_Tree(_e668.x, _e685.unnamed_1.first_primitive));
                            phi_795_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e691.unnamed_1.root, _e668.y));
                        } else {
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e707.unnamed.root, _e668.y), _e707.unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e668.z, _e713.unnamed_1.first_primitive));
                            phi_795_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e719.unnamed_1.root, _e668.w));
                        }
                        let _e727 = phi_795_;
                        phi_801_ = 0u;
                        phi_804_ = 0u;
                        loop {
                            let _e737 = phi_801_;
                            let _e739 = phi_804_;
                            local_2 = _e739;
                            local_3 = _e739;
                            local_4 = _e739;
                            let _e740 = (_e737 < 8u);
                            if _e740 {
                                let _e742 = (_e737 >> bitcast<u32>(2i));
                                let _e743 = (_e737 & 3u);
                                if (_e742 == 0u) {
                                    phi_818_ = _e589.unnamed.root;
                                } else {
                                    phi_818_ = _e589.unnamed.first_primitive;
                                }
                                let _e746 = phi_818_;
                                if (_e742 == 0u) {
                                    phi_828_ = _e658.unnamed.root;
                                } else {
                                    phi_828_ = _e658.unnamed.first_primitive;
                                }
                                let _e755 = phi_828_;
                                if (_e742 == 0u) {
                                    phi_838_ = _e727.unnamed.root;
                                } else {
                                    phi_838_ = _e727.unnamed.first_primitive;
                                }
                                let _e764 = phi_838_;
                                let _e777 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e746 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u)) * _e502) + (_e520 - _e312)), ((f32(((_e755 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u)) * _e503) + (_e521 - _e313)));
                                let _e778 = core_intrinsics_maximum_number_nsz_f32_(_e777, ((f32(((_e764 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u)) * _e504) + (_e522 - _e314)));
                                if (_e742 == 0u) {
                                    phi_856_ = _e589.unnamed_1.root;
                                } else {
                                    phi_856_ = _e589.unnamed_1.first_primitive;
                                }
                                let _e781 = phi_856_;
                                if (_e742 == 0u) {
                                    phi_866_ = _e658.unnamed_1.root;
                                } else {
                                    phi_866_ = _e658.unnamed_1.first_primitive;
                                }
                                let _e790 = phi_866_;
                                if (_e742 == 0u) {
                                    phi_876_ = _e727.unnamed_1.root;
                                } else {
                                    phi_876_ = _e727.unnamed_1.first_primitive;
                                }
                                let _e799 = phi_876_;
                                let _e812 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e781 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u)) * _e502) + (_e520 + _e312)), ((f32(((_e790 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u)) * _e503) + (_e521 + _e313)));
                                let _e813 = core_intrinsics_minimum_number_nsz_f32_(_e812, ((f32(((_e799 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u)) * _e504) + (_e522 + _e314)));
                                if (_e778 <= _e813) {
                                    if (_e778 <= _e116) {
                                        if (_e813 >= 0f) {
                                            if (_e742 == 0u) {
                                                let _e820 = nodes.member[(0u + _e470)].links[2u];
                                                phi_912_ = _e820;
                                            } else {
                                                let _e823 = nodes.member[(0u + _e470)].links[3u];
                                                phi_912_ = _e823;
                                            }
                                            let _e825 = phi_912_;
                                            let _e830 = ((_e825 >> bitcast<u32>(((_e743 * 8u) & 31u))) & 255u);
                                            let _e831 = (_e830 & 31u);
                                            if (_e831 >= 24u) {
                                                phi_925_ = (24u + ((_e831 - 24u) ^ _e332));
                                            } else {
                                                phi_925_ = _e831;
                                            }
                                            let _e837 = phi_925_;
                                            phi_930_ = (_e739 | ((_e830 >> bitcast<u32>(5i)) << bitcast<u32>((_e837 & 31u))));
                                        } else {
                                            phi_930_ = _e739;
                                        }
                                        let _e845 = phi_930_;
                                        phi_931_ = _e845;
                                    } else {
                                        phi_931_ = _e739;
                                    }
                                    let _e847 = phi_931_;
                                    phi_932_ = _e847;
                                } else {
                                    phi_932_ = _e739;
                                }
                                let _e849 = phi_932_;
                                phi_802_ = (_e737 + 1u);
                                phi_805_ = _e849;
                            } else {
                                phi_802_ = u32();
                                phi_805_ = u32();
                            }
                            let _e852 = phi_802_;
                            let _e854 = phi_805_;
                            continue;
                            continuing {
                                phi_801_ = _e852;
                                phi_804_ = _e854;
                                break if !(_e740);
                            }
                        }
                        let _e858 = nodes.member[(0u + _e470)].links[0u];
                        let _e862 = nodes.member[(0u + _e470)].frame[3u];
                        let _e866 = local_2;
                        if ((_e866 & 4278190080u) == 0u) {
                        } else {
                            let _e870 = local_1.group_mask;
                            if ((_e870 & 4278190080u) == 0u) {
                            } else {
                                let _e874 = local_1.len;
                                if (_e874 < 32u) {
                                    let _e877 = local_1.group;
                                    let _e879 = local_1.len;
                                    if (_e879 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e879)] = _e877;
                                    let _e885 = local_1.group_mask;
                                    let _e887 = local_1.len;
                                    if (_e887 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e887)] = _e885;
                                    let _e894 = local_1.len;
                                    local_1.len = (_e894 + 1u);
                                }
                            }
                            local_1.group = (_e87 + _e858);
                            let _e898 = local_3;
                            local_1.group_mask = ((_e898 & 4278190080u) | (_e862 >> bitcast<u32>(24i)));
                        }
                        let _e903 = local_4;
                        phi_990_ = (_e903 & 16777215u);
                        loop {
                            let _e906 = phi_990_;
                            let _e907 = (_e906 == 0u);
                            local_10 = _e907;
                            local_17 = _e907;
                            if _e907 {
                                phi_991_ = u32();
                                phi_2651_ = false;
                            } else {
                                let _e910 = nodes.member[(0u + _e470)].links[1u];
                                let _e914 = (_e910 + select(firstTrailingBit(_e906), 32u, (_e906 == 0u)));
                                if (_e914 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e921 = instances.member[(0u + _e914)].low_world;
                                let _e923 = instances.member[(0u + _e914)].high_world;
                                let _e930 = ((_e921.x - _e108) * _e264);
                                let _e931 = ((_e921.y - _e110) * _e274);
                                let _e932 = ((_e921.z - _e112) * _e284);
                                let _e939 = ((_e923.x - _e108) * _e264);
                                let _e940 = ((_e923.y - _e110) * _e274);
                                let _e941 = ((_e923.z - _e112) * _e284);
                                if (_e930 < _e939) {
                                    phi_1040_ = _e930;
                                } else {
                                    phi_1040_ = _e939;
                                }
                                let _e944 = phi_1040_;
                                if (_e931 < _e940) {
                                    phi_1045_ = _e931;
                                } else {
                                    phi_1045_ = _e940;
                                }
                                let _e947 = phi_1045_;
                                if (_e932 < _e941) {
                                    phi_1050_ = _e932;
                                } else {
                                    phi_1050_ = _e941;
                                }
                                let _e950 = phi_1050_;
                                if (_e930 > _e939) {
                                    phi_1058_ = _e930;
                                } else {
                                    phi_1058_ = _e939;
                                }
                                let _e956 = phi_1058_;
                                if (_e931 > _e940) {
                                    phi_1063_ = _e931;
                                } else {
                                    phi_1063_ = _e940;
                                }
                                let _e959 = phi_1063_;
                                if (_e932 > _e941) {
                                    phi_1068_ = _e932;
                                } else {
                                    phi_1068_ = _e941;
                                }
                                let _e962 = phi_1068_;
                                let _e966 = core_intrinsics_maximum_number_nsz_f32_((_e944 - _e319), (_e947 - _e320));
                                let _e967 = core_intrinsics_maximum_number_nsz_f32_(_e966, (_e950 - _e321));
                                let _e968 = core_intrinsics_minimum_number_nsz_f32_((_e956 + _e319), (_e959 + _e320));
                                let _e969 = core_intrinsics_minimum_number_nsz_f32_(_e968, (_e962 + _e321));
                                if (_e967 <= _e969) {
                                    if (_e967 <= _e116) {
                                        if (_e969 >= 0f) {
                                            let _e975 = instances.member[(0u + _e914)].world_to_object[0u];
                                            let _e986 = ((((_e975.x * _e108) + (_e975.y * _e110)) + (_e975.z * _e112)) + (_e975.w * 1f));
                                            let _e988 = instances.member[(0u + _e914)].world_to_object[1u];
                                            let _e999 = ((((_e988.x * _e108) + (_e988.y * _e110)) + (_e988.z * _e112)) + (_e988.w * 1f));
                                            let _e1001 = instances.member[(0u + _e914)].world_to_object[2u];
                                            let _e1012 = ((((_e1001.x * _e108) + (_e1001.y * _e110)) + (_e1001.z * _e112)) + (_e1001.w * 1f));
                                            let _e1015 = instances.member[(0u + _e914)].world_to_object[0u];
                                            let _e1026 = ((((_e1015.x * _e124) + (_e1015.y * _e125)) + (_e1015.z * _e126)) + (_e1015.w * 0f));
                                            let _e1028 = instances.member[(0u + _e914)].world_to_object[1u];
                                            let _e1039 = ((((_e1028.x * _e124) + (_e1028.y * _e125)) + (_e1028.z * _e126)) + (_e1028.w * 0f));
                                            let _e1041 = instances.member[(0u + _e914)].world_to_object[2u];
                                            let _e1052 = ((((_e1041.x * _e124) + (_e1041.y * _e125)) + (_e1041.z * _e126)) + (_e1041.w * 0f));
                                            let _e1055 = instances.member[(0u + _e914)].root;
                                            let _e1057 = instances.member[(0u + _e914)].first_triangle;
                                            let _e1061 = abs(_e1026);
                                            let _e1062 = abs(_e1039);
                                            let _e1063 = abs(_e1052);
                                            if (abs(_e986) < 1000000000000000f) {
                                                if (abs(_e999) < 1000000000000000f) {
                                                    if (abs(_e1012) < 1000000000000000f) {
                                                        if (_e1061 < 1000000000000000f) {
                                                            if (_e1062 < 1000000000000000f) {
                                                                if (_e1063 < 1000000000000000f) {
                                                                    if (_e1061 > 0f) {
                                                                        phi_1213_ = bool();
                                                                        phi_1214_ = true;
                                                                    } else {
                                                                        let _e1071 = (_e1062 > 0f);
                                                                        if _e1071 {
                                                                            phi_1212_ = bool();
                                                                        } else {
                                                                            phi_1212_ = (_e1063 > 0f);
                                                                        }
                                                                        let _e1074 = phi_1212_;
                                                                        phi_1213_ = _e1074;
                                                                        phi_1214_ = _e1071;
                                                                    }
                                                                    let _e1076 = phi_1213_;
                                                                    let _e1078 = phi_1214_;
                                                                    if _e1078 {
                                                                        phi_1218_ = true;
                                                                    } else {
                                                                        phi_1218_ = _e1076;
                                                                    }
                                                                    let _e1080 = phi_1218_;
                                                                    phi_1219_ = _e1080;
                                                                    phi_1220_ = false;
                                                                } else {
                                                                    phi_1219_ = bool();
                                                                    phi_1220_ = true;
                                                                }
                                                                let _e1082 = phi_1219_;
                                                                let _e1084 = phi_1220_;
                                                                phi_1221_ = _e1082;
                                                                phi_1222_ = false;
                                                                phi_1223_ = _e1084;
                                                            } else {
                                                                phi_1221_ = bool();
                                                                phi_1222_ = true;
                                                                phi_1223_ = false;
                                                            }
                                                            let _e1086 = phi_1221_;
                                                            let _e1088 = phi_1222_;
                                                            let _e1090 = phi_1223_;
                                                            phi_1224_ = _e1086;
                                                            phi_1225_ = _e1088;
                                                            phi_1226_ = _e1090;
                                                        } else {
                                                            phi_1224_ = bool();
                                                            phi_1225_ = true;
                                                            phi_1226_ = false;
                                                        }
                                                        let _e1092 = phi_1224_;
                                                        let _e1094 = phi_1225_;
                                                        let _e1096 = phi_1226_;
                                                        phi_1227_ = _e1092;
                                                        phi_1228_ = _e1094;
                                                        phi_1229_ = _e1096;
                                                    } else {
                                                        phi_1227_ = bool();
                                                        phi_1228_ = true;
                                                        phi_1229_ = false;
                                                    }
                                                    let _e1098 = phi_1227_;
                                                    let _e1100 = phi_1228_;
                                                    let _e1102 = phi_1229_;
                                                    phi_1230_ = _e1098;
                                                    phi_1231_ = _e1100;
                                                    phi_1232_ = _e1102;
                                                } else {
                                                    phi_1230_ = bool();
                                                    phi_1231_ = true;
                                                    phi_1232_ = false;
                                                }
                                                let _e1104 = phi_1230_;
                                                let _e1106 = phi_1231_;
                                                let _e1108 = phi_1232_;
                                                phi_1233_ = _e1104;
                                                phi_1234_ = _e1106;
                                                phi_1235_ = _e1108;
                                            } else {
                                                phi_1233_ = bool();
                                                phi_1234_ = true;
                                                phi_1235_ = false;
                                            }
                                            let _e1110 = phi_1233_;
                                            let _e1112 = phi_1234_;
                                            let _e1114 = phi_1235_;
                                            if _e1112 {
                                                phi_1239_ = true;
                                            } else {
                                                phi_1239_ = _e1114;
                                            }
                                            let _e1116 = phi_1239_;
                                            if _e1116 {
                                                phi_1243_ = false;
                                            } else {
                                                phi_1243_ = _e1110;
                                            }
                                            let _e1118 = phi_1243_;
                                            if _e1118 {
                                                let _e1119 = (_e1055 >= _e60);
                                                if _e1119 {
                                                    phi_2634_ = bool();
                                                } else {
                                                    if (_e1055 < _e60) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1125 = nodes.member[(0u + _e1055)].frame[0u];
                                                    let _e1129 = nodes.member[(0u + _e1055)].frame[1u];
                                                    let _e1133 = nodes.member[(0u + _e1055)].frame[2u];
                                                    let _e1137 = nodes.member[(0u + _e1055)].frame[0u];
                                                    let _e1141 = nodes.member[(0u + _e1055)].frame[1u];
                                                    let _e1145 = nodes.member[(0u + _e1055)].frame[2u];
                                                    let _e1149 = nodes.member[(0u + _e1055)].frame[3u];
                                                    let _e1183 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1026), abs(_e1039));
                                                    let _e1184 = core_intrinsics_maximum_number_nsz_f32_(_e1183, abs(_e1052));
                                                    let _e1185 = (_e1184 * 0.0000000000009094947f);
                                                    if (abs(_e1026) < _e1185) {
                                                        phi_1313_ = _e1185;
                                                    } else {
                                                        phi_1313_ = abs(_e1026);
                                                    }
                                                    let _e1190 = phi_1313_;
                                                    if (_e1026 < 0f) {
                                                        phi_1320_ = (-1f / _e1190);
                                                    } else {
                                                        phi_1320_ = (1f / _e1190);
                                                    }
                                                    let _e1195 = phi_1320_;
                                                    if (abs(_e1039) < _e1185) {
                                                        phi_1327_ = _e1185;
                                                    } else {
                                                        phi_1327_ = abs(_e1039);
                                                    }
                                                    let _e1200 = phi_1327_;
                                                    if (_e1039 < 0f) {
                                                        phi_1334_ = (-1f / _e1200);
                                                    } else {
                                                        phi_1334_ = (1f / _e1200);
                                                    }
                                                    let _e1205 = phi_1334_;
                                                    if (abs(_e1052) < _e1185) {
                                                        phi_1341_ = _e1185;
                                                    } else {
                                                        phi_1341_ = abs(_e1052);
                                                    }
                                                    let _e1210 = phi_1341_;
                                                    if (_e1052 < 0f) {
                                                        phi_1348_ = (-1f / _e1210);
                                                    } else {
                                                        phi_1348_ = (1f / _e1210);
                                                    }
                                                    let _e1215 = phi_1348_;
                                                    let _e1219 = abs((bitcast<f32>(_e1125) - _e986));
                                                    let _e1220 = abs((bitcast<f32>(_e1129) - _e999));
                                                    let _e1221 = abs((bitcast<f32>(_e1133) - _e1012));
                                                    let _e1225 = abs(((bitcast<f32>(_e1137) + (bitcast<f32>((((_e1149 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e986));
                                                    let _e1226 = abs(((bitcast<f32>(_e1141) + (bitcast<f32>((((_e1149 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e999));
                                                    let _e1227 = abs(((bitcast<f32>(_e1145) + (bitcast<f32>((((_e1149 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1012));
                                                    if (_e1219 > _e1225) {
                                                        phi_1365_ = _e1219;
                                                    } else {
                                                        phi_1365_ = _e1225;
                                                    }
                                                    let _e1230 = phi_1365_;
                                                    if (_e1220 > _e1226) {
                                                        phi_1370_ = _e1220;
                                                    } else {
                                                        phi_1370_ = _e1226;
                                                    }
                                                    let _e1233 = phi_1370_;
                                                    if (_e1221 > _e1227) {
                                                        phi_1375_ = _e1221;
                                                    } else {
                                                        phi_1375_ = _e1227;
                                                    }
                                                    let _e1236 = phi_1375_;
                                                    let _e1237 = core_intrinsics_maximum_number_nsz_f32_(_e1230, _e1233);
                                                    let _e1238 = core_intrinsics_maximum_number_nsz_f32_(_e1237, _e1236);
                                                    let _e1242 = (_e1238 * 0.0000019073486f);
                                                    let _e1243 = (abs(_e1195) * _e1242);
                                                    let _e1244 = (abs(_e1205) * _e1242);
                                                    let _e1245 = (abs(_e1215) * _e1242);
                                                    let _e1249 = (_e1238 * 0.0000009536743f);
                                                    let _e1250 = (abs(_e1195) * _e1249);
                                                    let _e1251 = (abs(_e1205) * _e1249);
                                                    let _e1252 = (abs(_e1215) * _e1249);
                                                    let _e1253 = abs(_e1026);
                                                    let _e1254 = abs(_e1039);
                                                    let _e1255 = abs(_e1052);
                                                    if (_e1253 >= _e1254) {
                                                        if (_e1253 >= _e1255) {
                                                            phi_1403_ = false;
                                                        } else {
                                                            phi_1403_ = true;
                                                        }
                                                        let _e1259 = phi_1403_;
                                                        phi_1404_ = _e1259;
                                                    } else {
                                                        phi_1404_ = true;
                                                    }
                                                    let _e1261 = phi_1404_;
                                                    if _e1261 {
                                                        if (_e1254 >= _e1255) {
                                                            phi_1412_ = 1u;
                                                        } else {
                                                            phi_1412_ = 2u;
                                                        }
                                                        let _e1264 = phi_1412_;
                                                        phi_1413_ = _e1264;
                                                    } else {
                                                        phi_1413_ = 0u;
                                                    }
                                                    let _e1266 = phi_1413_;
                                                    if (_e1266 == 0u) {
                                                        phi_1425_ = vec3<f32>(_e1039, _e1052, _e1026);
                                                    } else {
                                                        if (_e1266 == 1u) {
                                                            phi_1424_ = vec3<f32>(_e1052, _e1026, _e1039);
                                                        } else {
                                                            phi_1424_ = vec3<f32>(_e1026, _e1039, _e1052);
                                                        }
                                                        let _e1272 = phi_1424_;
                                                        phi_1425_ = _e1272;
                                                    }
                                                    let _e1274 = phi_1425_;
                                                    let _e1277 = (_e1274.x / _e1274.z);
                                                    let _e1280 = (_e1274.y / _e1274.z);
                                                    if (_e1195 < 0f) {
                                                        phi_1438_ = 0u;
                                                    } else {
                                                        phi_1438_ = 1u;
                                                    }
                                                    let _e1285 = phi_1438_;
                                                    if (_e1205 < 0f) {
                                                        phi_1443_ = 0u;
                                                    } else {
                                                        phi_1443_ = 2u;
                                                    }
                                                    let _e1288 = phi_1443_;
                                                    if (_e1215 < 0f) {
                                                        phi_1448_ = 0u;
                                                    } else {
                                                        phi_1448_ = 4u;
                                                    }
                                                    let _e1291 = phi_1448_;
                                                    let _e1293 = ((_e1285 | _e1288) | _e1291);
                                                    let _e1294 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1055, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1294.first[0], _e1294.first[1], _e1294.first[2], _e1294.first[3], _e1294.first[4], _e1294.first[5], _e1294.first[6], _e1294.first[7], _e1294.first[8], _e1294.first[9], _e1294.first[10], _e1294.first[11], _e1294.first[12], _e1294.first[13], _e1294.first[14], _e1294.first[15], _e1294.first[16], _e1294.first[17], _e1294.first[18], _e1294.first[19], _e1294.first[20], _e1294.first[21], _e1294.first[22], _e1294.first[23], _e1294.first[24], _e1294.first[25], _e1294.first[26], _e1294.first[27], _e1294.first[28], _e1294.first[29], _e1294.first[30], _e1294.first[31]), array<u32, 32>(_e1294.mask[0], _e1294.mask[1], _e1294.mask[2], _e1294.mask[3], _e1294.mask[4], _e1294.mask[5], _e1294.mask[6], _e1294.mask[7], _e1294.mask[8], _e1294.mask[9], _e1294.mask[10], _e1294.mask[11], _e1294.mask[12], _e1294.mask[13], _e1294.mask[14], _e1294.mask[15], _e1294.mask[16], _e1294.mask[17], _e1294.mask[18], _e1294.mask[19], _e1294.mask[20], _e1294.mask[21], _e1294.mask[22], _e1294.mask[23], _e1294.mask[24], _e1294.mask[25], _e1294.mask[26], _e1294.mask[27], _e1294.mask[28], _e1294.mask[29], _e1294.mask[30], _e1294.mask[31]), _e1294.len, _e1294.group, _e1294.group_mask);
                                                    let _e1368 = local.group_mask;
                                                    if ((_e1368 & 4278190080u) == 0u) {
                                                        let _e1372 = local.len;
                                                        if (_e1372 == 0u) {
                                                            phi_1562_ = false;
                                                        } else {
                                                            let _e1376 = local.len;
                                                            local.len = (_e1376 - 1u);
                                                            let _e1379 = local.len;
                                                            if (_e1379 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1384 = local.first[(0u + _e1379)];
                                                            local.group = _e1384;
                                                            let _e1387 = local.len;
                                                            if (_e1387 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1392 = local.mask[(0u + _e1387)];
                                                            local.group_mask = _e1392;
                                                            phi_1562_ = true;
                                                        }
                                                        let _e1395 = phi_1562_;
                                                        phi_1563_ = _e1395;
                                                    } else {
                                                        phi_1563_ = true;
                                                    }
                                                    let _e1397 = phi_1563_;
                                                    if _e1397 {
                                                        let _e1399 = local.group_mask;
                                                        let _e1405 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1399)), 32u, (_e1399 == 0u)));
                                                        let _e1409 = local.group_mask;
                                                        let _e1423 = local.group_mask;
                                                        local.group_mask = (_e1423 & ~((1u << bitcast<u32>((_e1405 & 31u)))));
                                                        let _e1426 = local.group;
                                                        phi_1594_ = (_e1426 + countOneBits(((_e1409 & ~((4294967295u << bitcast<u32>((((_e1405 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1594_ = 4294967295u;
                                                    }
                                                    let _e1429 = phi_1594_;
                                                    phi_1596_ = _e1429;
                                                    loop {
                                                        let _e1431 = phi_1596_;
                                                        if (_e1431 != 4294967295u) {
                                                            if (_e1431 < _e60) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1438 = nodes.member[(0u + _e1431)].frame[3u];
                                                            let _e1463 = (bitcast<f32>((((_e1438 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1195);
                                                            let _e1464 = (bitcast<f32>((((_e1438 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1205);
                                                            let _e1465 = (bitcast<f32>((((_e1438 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1215);
                                                            let _e1468 = nodes.member[(0u + _e1431)].frame[0u];
                                                            let _e1472 = nodes.member[(0u + _e1431)].frame[1u];
                                                            let _e1476 = nodes.member[(0u + _e1431)].frame[2u];
                                                            let _e1481 = ((bitcast<f32>(_e1468) - _e986) * _e1195);
                                                            let _e1482 = ((bitcast<f32>(_e1472) - _e999) * _e1205);
                                                            let _e1483 = ((bitcast<f32>(_e1476) - _e1012) * _e1215);
                                                            let _e1491 = nodes.member[(0u + _e1431)].x;
                                                            if (_e1195 < 0f) {
                                                                let _e1502 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1491.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1508 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1502.unnamed.root, _e1491.w), _e1502.unnamed_1);
                                                                let _e1514 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1508.unnamed, lt_bvh_traverse_Tree(_e1491.x, _e1508.unnamed_1.first_primitive));
                                                                phi_1677_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1514.unnamed, lt_bvh_traverse_Tree(_e1514.unnamed_1.root, _e1491.y));
                                                            } else {
                                                                let _e1530 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1491.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1536 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1530.unnamed.root, _e1491.y), _e1530.unnamed_1);
                                                                let _e1542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1536.unnamed, lt_bvh_traverse_Tree(_e1491.z, _e1536.unnamed_1.first_primitive));
                                                                phi_1677_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1542.unnamed, lt_bvh_traverse_Tree(_e1542.unnamed_1.root, _e1491.w));
                                                            }
                                                            let _e1550 = phi_1677_;
                                                            let _e1560 = nodes.member[(0u + _e1431)].y;
                                                            if (_e1205 < 0f) {
                                                                let _e1571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1560.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1571.unnamed.root, _e1560.w), _e1571.unnamed_1);
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1577.unnamed, lt_bvh_traverse_Tree(_e1560.x, _e1577.unnamed_1.first_primitive));
                                                                phi_1704_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1583.unnamed, lt_bvh_traverse_Tree(_e1583.unnamed_1.root, _e1560.y));
                                                            } else {
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1560.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1599.unnamed.root, _e1560.y), _e1599.unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1605.unnamed, lt_bvh_traverse_Tree(_e1560.z, _e1605.unnamed_1.first_primitive));
                                                                phi_1704_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1611.unnamed_1.root, _e1560.w));
                                                            }
                                                            let _e1619 = phi_1704_;
                                                            let _e1629 = nodes.member[(0u + _e1431)].z;
                                                            if (_e1215 < 0f) {
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1640.unnamed.root, _e1629.w), _e1640.unnamed_1);
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1646.unnamed, lt_bvh_traverse_Tree(_e1629.x, _e1646.unnamed_1.first_primitive));
                                                                phi_1731_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1652.unnamed, lt_bvh_traverse_Tree(_e1652.unnamed_1.root, _e1629.y));
                                                            } else {
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1668.unnamed.root, _e1629.y), _e1668.unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1674.unnamed, lt_bvh_traverse_Tree(_e1629.z, _e1674.unnamed_1.first_primitive));
                                                                phi_1731_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1680.unnamed_1.root, _e1629.w));
                                                            }
                                                            let _e1688 = phi_1731_;
                                                            phi_1737_ = 0u;
                                                            phi_1740_ = 0u;
                                                            loop {
                                                                let _e1698 = phi_1737_;
                                                                let _e1700 = phi_1740_;
                                                                local_5 = _e1700;
                                                                local_6 = _e1700;
                                                                local_7 = _e1700;
                                                                let _e1701 = (_e1698 < 8u);
                                                                if _e1701 {
                                                                    let _e1703 = (_e1698 >> bitcast<u32>(2i));
                                                                    let _e1704 = (_e1698 & 3u);
                                                                    if (_e1703 == 0u) {
                                                                        phi_1754_ = _e1550.unnamed.root;
                                                                    } else {
                                                                        phi_1754_ = _e1550.unnamed.first_primitive;
                                                                    }
                                                                    let _e1707 = phi_1754_;
                                                                    if (_e1703 == 0u) {
                                                                        phi_1764_ = _e1619.unnamed.root;
                                                                    } else {
                                                                        phi_1764_ = _e1619.unnamed.first_primitive;
                                                                    }
                                                                    let _e1716 = phi_1764_;
                                                                    if (_e1703 == 0u) {
                                                                        phi_1774_ = _e1688.unnamed.root;
                                                                    } else {
                                                                        phi_1774_ = _e1688.unnamed.first_primitive;
                                                                    }
                                                                    let _e1725 = phi_1774_;
                                                                    let _e1738 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1707 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u)) * _e1463) + (_e1481 - _e1243)), ((f32(((_e1716 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 - _e1244)));
                                                                    let _e1739 = core_intrinsics_maximum_number_nsz_f32_(_e1738, ((f32(((_e1725 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u)) * _e1465) + (_e1483 - _e1245)));
                                                                    if (_e1703 == 0u) {
                                                                        phi_1792_ = _e1550.unnamed_1.root;
                                                                    } else {
                                                                        phi_1792_ = _e1550.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1742 = phi_1792_;
                                                                    if (_e1703 == 0u) {
                                                                        phi_1802_ = _e1619.unnamed_1.root;
                                                                    } else {
                                                                        phi_1802_ = _e1619.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1751 = phi_1802_;
                                                                    if (_e1703 == 0u) {
                                                                        phi_1812_ = _e1688.unnamed_1.root;
                                                                    } else {
                                                                        phi_1812_ = _e1688.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1760 = phi_1812_;
                                                                    let _e1773 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1742 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u)) * _e1463) + (_e1481 + _e1243)), ((f32(((_e1751 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 + _e1244)));
                                                                    let _e1774 = core_intrinsics_minimum_number_nsz_f32_(_e1773, ((f32(((_e1760 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u)) * _e1465) + (_e1483 + _e1245)));
                                                                    if (_e1739 <= _e1774) {
                                                                        if (_e1739 <= _e116) {
                                                                            if (_e1774 >= 0f) {
                                                                                if (_e1703 == 0u) {
                                                                                    let _e1781 = nodes.member[(0u + _e1431)].links[2u];
                                                                                    phi_1848_ = _e1781;
                                                                                } else {
                                                                                    let _e1784 = nodes.member[(0u + _e1431)].links[3u];
                                                                                    phi_1848_ = _e1784;
                                                                                }
                                                                                let _e1786 = phi_1848_;
                                                                                let _e1791 = ((_e1786 >> bitcast<u32>(((_e1704 * 8u) & 31u))) & 255u);
                                                                                let _e1792 = (_e1791 & 31u);
                                                                                if (_e1792 >= 24u) {
                                                                                    phi_1861_ = (24u + ((_e1792 - 24u) ^ _e1293));
                                                                                } else {
                                                                                    phi_1861_ = _e1792;
                                                                                }
                                                                                let _e1798 = phi_1861_;
                                                                                phi_1866_ = (_e1700 | ((_e1791 >> bitcast<u32>(5i)) << bitcast<u32>((_e1798 & 31u))));
                                                                            } else {
                                                                                phi_1866_ = _e1700;
                                                                            }
                                                                            let _e1806 = phi_1866_;
                                                                            phi_1867_ = _e1806;
                                                                        } else {
                                                                            phi_1867_ = _e1700;
                                                                        }
                                                                        let _e1808 = phi_1867_;
                                                                        phi_1868_ = _e1808;
                                                                    } else {
                                                                        phi_1868_ = _e1700;
                                                                    }
                                                                    let _e1810 = phi_1868_;
                                                                    phi_1738_ = (_e1698 + 1u);
                                                                    phi_1741_ = _e1810;
                                                                } else {
                                                                    phi_1738_ = u32();
                                                                    phi_1741_ = u32();
                                                                }
                                                                let _e1813 = phi_1738_;
                                                                let _e1815 = phi_1741_;
                                                                continue;
                                                                continuing {
                                                                    phi_1737_ = _e1813;
                                                                    phi_1740_ = _e1815;
                                                                    break if !(_e1701);
                                                                }
                                                            }
                                                            let _e1819 = nodes.member[(0u + _e1431)].links[0u];
                                                            let _e1823 = nodes.member[(0u + _e1431)].frame[3u];
                                                            let _e1827 = local_5;
                                                            if ((_e1827 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1831 = local.group_mask;
                                                                if ((_e1831 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1835 = local.len;
                                                                    if (_e1835 < 32u) {
                                                                        let _e1838 = local.group;
                                                                        let _e1840 = local.len;
                                                                        if (_e1840 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1840)] = _e1838;
                                                                        let _e1846 = local.group_mask;
                                                                        let _e1848 = local.len;
                                                                        if (_e1848 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1848)] = _e1846;
                                                                        let _e1855 = local.len;
                                                                        local.len = (_e1855 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1055 + _e1819);
                                                                let _e1859 = local_6;
                                                                local.group_mask = ((_e1859 & 4278190080u) | (_e1823 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1864 = local_7;
                                                            phi_1926_ = (_e1864 & 16777215u);
                                                            loop {
                                                                let _e1867 = phi_1926_;
                                                                let _e1868 = (_e1867 == 0u);
                                                                local_8 = _e1868;
                                                                local_14 = _e1868;
                                                                if _e1868 {
                                                                    phi_1927_ = u32();
                                                                    phi_2537_ = false;
                                                                    phi_2538_ = false;
                                                                    phi_2539_ = false;
                                                                } else {
                                                                    let _e1871 = nodes.member[(0u + _e1431)].links[1u];
                                                                    let _e1876 = ((_e1057 + _e1871) + select(firstTrailingBit(_e1867), 32u, (_e1867 == 0u)));
                                                                    if (_e1876 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1883 = triangles.member[(0u + _e1876)].v0_;
                                                                    let _e1885 = (_e1883.x - _e986);
                                                                    let _e1887 = (_e1883.y - _e999);
                                                                    let _e1889 = (_e1883.z - _e1012);
                                                                    if (_e1266 == 0u) {
                                                                        phi_1972_ = vec3<f32>(_e1887, _e1889, _e1885);
                                                                    } else {
                                                                        if (_e1266 == 1u) {
                                                                            phi_1971_ = vec3<f32>(_e1889, _e1885, _e1887);
                                                                        } else {
                                                                            phi_1971_ = (_e1883 - vec3<f32>(_e986, _e999, _e1012));
                                                                        }
                                                                        let _e1897 = phi_1971_;
                                                                        phi_1972_ = _e1897;
                                                                    }
                                                                    let _e1899 = phi_1972_;
                                                                    let _e1903 = (_e1899.x - (_e1277 * _e1899.z));
                                                                    let _e1907 = (_e1899.y - (_e1280 * _e1899.z));
                                                                    let _e1909 = triangles.member[(0u + _e1876)].v1_;
                                                                    let _e1911 = (_e1909.x - _e986);
                                                                    let _e1913 = (_e1909.y - _e999);
                                                                    let _e1915 = (_e1909.z - _e1012);
                                                                    if (_e1266 == 0u) {
                                                                        phi_2002_ = vec3<f32>(_e1913, _e1915, _e1911);
                                                                    } else {
                                                                        if (_e1266 == 1u) {
                                                                            phi_2001_ = vec3<f32>(_e1915, _e1911, _e1913);
                                                                        } else {
                                                                            phi_2001_ = (_e1909 - vec3<f32>(_e986, _e999, _e1012));
                                                                        }
                                                                        let _e1923 = phi_2001_;
                                                                        phi_2002_ = _e1923;
                                                                    }
                                                                    let _e1925 = phi_2002_;
                                                                    let _e1929 = (_e1925.x - (_e1277 * _e1925.z));
                                                                    let _e1933 = (_e1925.y - (_e1280 * _e1925.z));
                                                                    let _e1935 = triangles.member[(0u + _e1876)].v2_;
                                                                    let _e1937 = (_e1935.x - _e986);
                                                                    let _e1939 = (_e1935.y - _e999);
                                                                    let _e1941 = (_e1935.z - _e1012);
                                                                    if (_e1266 == 0u) {
                                                                        phi_2032_ = vec3<f32>(_e1939, _e1941, _e1937);
                                                                    } else {
                                                                        if (_e1266 == 1u) {
                                                                            phi_2031_ = vec3<f32>(_e1941, _e1937, _e1939);
                                                                        } else {
                                                                            phi_2031_ = (_e1935 - vec3<f32>(_e986, _e999, _e1012));
                                                                        }
                                                                        let _e1949 = phi_2031_;
                                                                        phi_2032_ = _e1949;
                                                                    }
                                                                    let _e1951 = phi_2032_;
                                                                    let _e1955 = (_e1951.x - (_e1277 * _e1951.z));
                                                                    let _e1959 = (_e1951.y - (_e1280 * _e1951.z));
                                                                    if (_e1929 < _e1955) {
                                                                        phi_2051_ = true;
                                                                    } else {
                                                                        if (_e1929 == _e1955) {
                                                                            phi_2050_ = (_e1933 < _e1959);
                                                                        } else {
                                                                            phi_2050_ = false;
                                                                        }
                                                                        let _e1964 = phi_2050_;
                                                                        phi_2051_ = _e1964;
                                                                    }
                                                                    let _e1966 = phi_2051_;
                                                                    if _e1966 {
                                                                        phi_2055_ = _e1959;
                                                                        phi_2056_ = _e1955;
                                                                        phi_2057_ = _e1933;
                                                                        phi_2058_ = _e1929;
                                                                    } else {
                                                                        phi_2055_ = _e1933;
                                                                        phi_2056_ = _e1929;
                                                                        phi_2057_ = _e1959;
                                                                        phi_2058_ = _e1955;
                                                                    }
                                                                    let _e1968 = phi_2055_;
                                                                    let _e1970 = phi_2056_;
                                                                    let _e1972 = phi_2057_;
                                                                    let _e1974 = phi_2058_;
                                                                    let _e1977 = ((_e1974 * _e1968) - (_e1972 * _e1970));
                                                                    if _e1966 {
                                                                        phi_2066_ = -(_e1977);
                                                                    } else {
                                                                        phi_2066_ = _e1977;
                                                                    }
                                                                    let _e1980 = phi_2066_;
                                                                    if (_e1955 < _e1903) {
                                                                        phi_2077_ = true;
                                                                    } else {
                                                                        if (_e1955 == _e1903) {
                                                                            phi_2076_ = (_e1959 < _e1907);
                                                                        } else {
                                                                            phi_2076_ = false;
                                                                        }
                                                                        let _e1985 = phi_2076_;
                                                                        phi_2077_ = _e1985;
                                                                    }
                                                                    let _e1987 = phi_2077_;
                                                                    if _e1987 {
                                                                        phi_2081_ = _e1907;
                                                                        phi_2082_ = _e1903;
                                                                        phi_2083_ = _e1959;
                                                                        phi_2084_ = _e1955;
                                                                    } else {
                                                                        phi_2081_ = _e1959;
                                                                        phi_2082_ = _e1955;
                                                                        phi_2083_ = _e1907;
                                                                        phi_2084_ = _e1903;
                                                                    }
                                                                    let _e1989 = phi_2081_;
                                                                    let _e1991 = phi_2082_;
                                                                    let _e1993 = phi_2083_;
                                                                    let _e1995 = phi_2084_;
                                                                    let _e1998 = ((_e1995 * _e1989) - (_e1993 * _e1991));
                                                                    if _e1987 {
                                                                        phi_2092_ = -(_e1998);
                                                                    } else {
                                                                        phi_2092_ = _e1998;
                                                                    }
                                                                    let _e2001 = phi_2092_;
                                                                    if (_e1903 < _e1929) {
                                                                        phi_2103_ = true;
                                                                    } else {
                                                                        if (_e1903 == _e1929) {
                                                                            phi_2102_ = (_e1907 < _e1933);
                                                                        } else {
                                                                            phi_2102_ = false;
                                                                        }
                                                                        let _e2006 = phi_2102_;
                                                                        phi_2103_ = _e2006;
                                                                    }
                                                                    let _e2008 = phi_2103_;
                                                                    if _e2008 {
                                                                        phi_2107_ = _e1933;
                                                                        phi_2108_ = _e1929;
                                                                        phi_2109_ = _e1907;
                                                                        phi_2110_ = _e1903;
                                                                    } else {
                                                                        phi_2107_ = _e1907;
                                                                        phi_2108_ = _e1903;
                                                                        phi_2109_ = _e1933;
                                                                        phi_2110_ = _e1929;
                                                                    }
                                                                    let _e2010 = phi_2107_;
                                                                    let _e2012 = phi_2108_;
                                                                    let _e2014 = phi_2109_;
                                                                    let _e2016 = phi_2110_;
                                                                    let _e2019 = ((_e2016 * _e2010) - (_e2014 * _e2012));
                                                                    if _e2008 {
                                                                        phi_2118_ = -(_e2019);
                                                                    } else {
                                                                        phi_2118_ = _e2019;
                                                                    }
                                                                    let _e2022 = phi_2118_;
                                                                    if (_e1980 >= 0f) {
                                                                        if (_e2001 >= 0f) {
                                                                            if (_e2022 >= 0f) {
                                                                                phi_2133_ = ((_e1980 + _e2001) + _e2022);
                                                                                phi_2134_ = false;
                                                                            } else {
                                                                                phi_2133_ = f32();
                                                                                phi_2134_ = true;
                                                                            }
                                                                            let _e2029 = phi_2133_;
                                                                            let _e2031 = phi_2134_;
                                                                            phi_2135_ = _e2029;
                                                                            phi_2136_ = _e2031;
                                                                        } else {
                                                                            phi_2135_ = f32();
                                                                            phi_2136_ = true;
                                                                        }
                                                                        let _e2033 = phi_2135_;
                                                                        let _e2035 = phi_2136_;
                                                                        phi_2137_ = _e2033;
                                                                        phi_2138_ = _e2035;
                                                                    } else {
                                                                        phi_2137_ = f32();
                                                                        phi_2138_ = true;
                                                                    }
                                                                    let _e2037 = phi_2137_;
                                                                    let _e2039 = phi_2138_;
                                                                    if _e2039 {
                                                                        if (_e1980 <= 0f) {
                                                                            if (_e2001 <= 0f) {
                                                                                let _e2042 = (_e2022 <= 0f);
                                                                                if _e2042 {
                                                                                }
                                                                                phi_2156_ = ((_e1980 + _e2001) + _e2022);
                                                                                phi_2157_ = false;
                                                                                phi_2158_ = _e2042;
                                                                            } else {
                                                                                phi_2156_ = f32();
                                                                                phi_2157_ = true;
                                                                                phi_2158_ = false;
                                                                            }
                                                                            let _e2046 = phi_2156_;
                                                                            let _e2048 = phi_2157_;
                                                                            let _e2050 = phi_2158_;
                                                                            phi_2159_ = _e2046;
                                                                            phi_2160_ = _e2048;
                                                                            phi_2161_ = _e2050;
                                                                        } else {
                                                                            phi_2159_ = f32();
                                                                            phi_2160_ = true;
                                                                            phi_2161_ = false;
                                                                        }
                                                                        let _e2052 = phi_2159_;
                                                                        let _e2054 = phi_2160_;
                                                                        let _e2056 = phi_2161_;
                                                                        if _e2054 {
                                                                            phi_2165_ = false;
                                                                        } else {
                                                                            phi_2165_ = _e2056;
                                                                        }
                                                                        let _e2058 = phi_2165_;
                                                                        phi_2166_ = _e2052;
                                                                        phi_2167_ = _e2058;
                                                                    } else {
                                                                        phi_2166_ = _e2037;
                                                                        phi_2167_ = true;
                                                                    }
                                                                    let _e2060 = phi_2166_;
                                                                    let _e2062 = phi_2167_;
                                                                    if _e2062 {
                                                                        let _e2063 = (_e2060 == 0f);
                                                                        if _e2063 {
                                                                            phi_2483_ = lt_bvh_triangle_Intersection();
                                                                            phi_2484_ = false;
                                                                        } else {
                                                                            let _e2065 = triangles.member[(0u + _e1876)].v0_;
                                                                            let _e2067 = (_e2065.x - _e986);
                                                                            let _e2069 = (_e2065.y - _e999);
                                                                            let _e2071 = (_e2065.z - _e1012);
                                                                            if (_e1266 == 0u) {
                                                                                phi_2196_ = vec3<f32>(_e2069, _e2071, _e2067);
                                                                            } else {
                                                                                if (_e1266 == 1u) {
                                                                                    phi_2195_ = vec3<f32>(_e2071, _e2067, _e2069);
                                                                                } else {
                                                                                    phi_2195_ = (_e2065 - vec3<f32>(_e986, _e999, _e1012));
                                                                                }
                                                                                let _e2079 = phi_2195_;
                                                                                phi_2196_ = _e2079;
                                                                            }
                                                                            let _e2081 = phi_2196_;
                                                                            let _e2083 = triangles.member[(0u + _e1876)].v1_;
                                                                            let _e2085 = triangles.member[(0u + _e1876)].v0_;
                                                                            let _e2088 = (_e2083.x - _e2085.x);
                                                                            let _e2091 = (_e2083.y - _e2085.y);
                                                                            let _e2094 = (_e2083.z - _e2085.z);
                                                                            if (_e1266 == 0u) {
                                                                                phi_2222_ = vec3<f32>(_e2091, _e2094, _e2088);
                                                                            } else {
                                                                                if (_e1266 == 1u) {
                                                                                    phi_2221_ = vec3<f32>(_e2094, _e2088, _e2091);
                                                                                } else {
                                                                                    phi_2221_ = (_e2083 - _e2085);
                                                                                }
                                                                                let _e2101 = phi_2221_;
                                                                                phi_2222_ = _e2101;
                                                                            }
                                                                            let _e2103 = phi_2222_;
                                                                            let _e2105 = triangles.member[(0u + _e1876)].v2_;
                                                                            let _e2107 = triangles.member[(0u + _e1876)].v0_;
                                                                            let _e2110 = (_e2105.x - _e2107.x);
                                                                            let _e2113 = (_e2105.y - _e2107.y);
                                                                            let _e2116 = (_e2105.z - _e2107.z);
                                                                            if (_e1266 == 0u) {
                                                                                phi_2248_ = vec3<f32>(_e2113, _e2116, _e2110);
                                                                            } else {
                                                                                if (_e1266 == 1u) {
                                                                                    phi_2247_ = vec3<f32>(_e2116, _e2110, _e2113);
                                                                                } else {
                                                                                    phi_2247_ = (_e2105 - _e2107);
                                                                                }
                                                                                let _e2123 = phi_2247_;
                                                                                phi_2248_ = _e2123;
                                                                            }
                                                                            let _e2125 = phi_2248_;
                                                                            let _e2132 = ((_e2103.y * _e2125.z) - (_e2103.z * _e2125.y));
                                                                            let _e2139 = ((_e2103.z * _e2125.x) - (_e2103.x * _e2125.z));
                                                                            let _e2146 = ((_e2103.x * _e2125.y) - (_e2103.y * _e2125.x));
                                                                            let _e2160 = (((1f / _e1274.z) * (((_e2132 * _e2081.x) + (_e2139 * _e2081.y)) + (_e2146 * _e2081.z))) / (((_e2132 * _e1277) + (_e2139 * _e1280)) + _e2146));
                                                                            if (_e2160 > 0f) {
                                                                                if (_e2160 < _e116) {
                                                                                    let _e2164 = triangles.member[(0u + _e1876)].v0_;
                                                                                    let _e2166 = triangles.member[(0u + _e1876)].v1_;
                                                                                    if (_e2164.x < _e2166.x) {
                                                                                        phi_2304_ = _e2164.x;
                                                                                    } else {
                                                                                        phi_2304_ = _e2166.x;
                                                                                    }
                                                                                    let _e2173 = phi_2304_;
                                                                                    if (_e2164.y < _e2166.y) {
                                                                                        phi_2313_ = _e2164.y;
                                                                                    } else {
                                                                                        phi_2313_ = _e2166.y;
                                                                                    }
                                                                                    let _e2180 = phi_2313_;
                                                                                    if (_e2164.z < _e2166.z) {
                                                                                        phi_2322_ = _e2164.z;
                                                                                    } else {
                                                                                        phi_2322_ = _e2166.z;
                                                                                    }
                                                                                    let _e2187 = phi_2322_;
                                                                                    let _e2189 = triangles.member[(0u + _e1876)].v2_;
                                                                                    if (_e2173 < _e2189.x) {
                                                                                        phi_2331_ = _e2173;
                                                                                    } else {
                                                                                        phi_2331_ = _e2189.x;
                                                                                    }
                                                                                    let _e2194 = phi_2331_;
                                                                                    if (_e2180 < _e2189.y) {
                                                                                        phi_2338_ = _e2180;
                                                                                    } else {
                                                                                        phi_2338_ = _e2189.y;
                                                                                    }
                                                                                    let _e2199 = phi_2338_;
                                                                                    if (_e2187 < _e2189.z) {
                                                                                        phi_2345_ = _e2187;
                                                                                    } else {
                                                                                        phi_2345_ = _e2189.z;
                                                                                    }
                                                                                    let _e2204 = phi_2345_;
                                                                                    let _e2206 = triangles.member[(0u + _e1876)].v0_;
                                                                                    let _e2208 = triangles.member[(0u + _e1876)].v1_;
                                                                                    if (_e2206.x > _e2208.x) {
                                                                                        phi_2358_ = _e2206.x;
                                                                                    } else {
                                                                                        phi_2358_ = _e2208.x;
                                                                                    }
                                                                                    let _e2215 = phi_2358_;
                                                                                    if (_e2206.y > _e2208.y) {
                                                                                        phi_2367_ = _e2206.y;
                                                                                    } else {
                                                                                        phi_2367_ = _e2208.y;
                                                                                    }
                                                                                    let _e2222 = phi_2367_;
                                                                                    if (_e2206.z > _e2208.z) {
                                                                                        phi_2376_ = _e2206.z;
                                                                                    } else {
                                                                                        phi_2376_ = _e2208.z;
                                                                                    }
                                                                                    let _e2229 = phi_2376_;
                                                                                    let _e2231 = triangles.member[(0u + _e1876)].v2_;
                                                                                    if (_e2215 > _e2231.x) {
                                                                                        phi_2385_ = _e2215;
                                                                                    } else {
                                                                                        phi_2385_ = _e2231.x;
                                                                                    }
                                                                                    let _e2236 = phi_2385_;
                                                                                    if (_e2222 > _e2231.y) {
                                                                                        phi_2392_ = _e2222;
                                                                                    } else {
                                                                                        phi_2392_ = _e2231.y;
                                                                                    }
                                                                                    let _e2241 = phi_2392_;
                                                                                    if (_e2229 > _e2231.z) {
                                                                                        phi_2399_ = _e2229;
                                                                                    } else {
                                                                                        phi_2399_ = _e2231.z;
                                                                                    }
                                                                                    let _e2246 = phi_2399_;
                                                                                    let _e2250 = ((_e2194 - _e986) * _e1195);
                                                                                    let _e2251 = ((_e2199 - _e999) * _e1205);
                                                                                    let _e2252 = ((_e2204 - _e1012) * _e1215);
                                                                                    let _e2256 = ((_e2236 - _e986) * _e1195);
                                                                                    let _e2257 = ((_e2241 - _e999) * _e1205);
                                                                                    let _e2258 = ((_e2246 - _e1012) * _e1215);
                                                                                    if (_e2250 < _e2256) {
                                                                                        phi_2416_ = _e2250;
                                                                                    } else {
                                                                                        phi_2416_ = _e2256;
                                                                                    }
                                                                                    let _e2261 = phi_2416_;
                                                                                    if (_e2251 < _e2257) {
                                                                                        phi_2421_ = _e2251;
                                                                                    } else {
                                                                                        phi_2421_ = _e2257;
                                                                                    }
                                                                                    let _e2264 = phi_2421_;
                                                                                    if (_e2252 < _e2258) {
                                                                                        phi_2426_ = _e2252;
                                                                                    } else {
                                                                                        phi_2426_ = _e2258;
                                                                                    }
                                                                                    let _e2267 = phi_2426_;
                                                                                    if (_e2250 > _e2256) {
                                                                                        phi_2434_ = _e2250;
                                                                                    } else {
                                                                                        phi_2434_ = _e2256;
                                                                                    }
                                                                                    let _e2273 = phi_2434_;
                                                                                    if (_e2251 > _e2257) {
                                                                                        phi_2439_ = _e2251;
                                                                                    } else {
                                                                                        phi_2439_ = _e2257;
                                                                                    }
                                                                                    let _e2276 = phi_2439_;
                                                                                    if (_e2252 > _e2258) {
                                                                                        phi_2444_ = _e2252;
                                                                                    } else {
                                                                                        phi_2444_ = _e2258;
                                                                                    }
                                                                                    let _e2279 = phi_2444_;
                                                                                    let _e2283 = core_intrinsics_maximum_number_nsz_f32_((_e2261 - _e1250), (_e2264 - _e1251));
                                                                                    let _e2284 = core_intrinsics_maximum_number_nsz_f32_(_e2283, (_e2267 - _e1252));
                                                                                    let _e2285 = core_intrinsics_minimum_number_nsz_f32_((_e2273 + _e1250), (_e2276 + _e1251));
                                                                                    let _e2286 = core_intrinsics_minimum_number_nsz_f32_(_e2285, (_e2279 + _e1252));
                                                                                    if (_e2284 > _e967) {
                                                                                        phi_2456_ = _e2284;
                                                                                    } else {
                                                                                        phi_2456_ = _e967;
                                                                                    }
                                                                                    let _e2289 = phi_2456_;
                                                                                    if (_e2286 < _e969) {
                                                                                        phi_2461_ = _e2286;
                                                                                    } else {
                                                                                        phi_2461_ = _e969;
                                                                                    }
                                                                                    let _e2292 = phi_2461_;
                                                                                    if (_e2160 < _e2289) {
                                                                                        phi_2466_ = _e2289;
                                                                                    } else {
                                                                                        phi_2466_ = _e2160;
                                                                                    }
                                                                                    let _e2295 = phi_2466_;
                                                                                    if (_e2295 > _e2292) {
                                                                                        phi_2471_ = _e2292;
                                                                                    } else {
                                                                                        phi_2471_ = _e2295;
                                                                                    }
                                                                                    let _e2298 = phi_2471_;
                                                                                    phi_2476_ = lt_bvh_triangle_Intersection(_e2298, (_e2001 / _e2060), (_e2022 / _e2060), (_e2289 <= _e2292));
                                                                                    phi_2477_ = false;
                                                                                } else {
                                                                                    phi_2476_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2477_ = true;
                                                                                }
                                                                                let _e2304 = phi_2476_;
                                                                                let _e2306 = phi_2477_;
                                                                                phi_2478_ = _e2304;
                                                                                phi_2479_ = _e2306;
                                                                            } else {
                                                                                phi_2478_ = lt_bvh_triangle_Intersection();
                                                                                phi_2479_ = true;
                                                                            }
                                                                            let _e2308 = phi_2478_;
                                                                            let _e2310 = phi_2479_;
                                                                            if _e2310 {
                                                                            }
                                                                            phi_2483_ = _e2308;
                                                                            phi_2484_ = _e2310;
                                                                        }
                                                                        let _e2312 = phi_2483_;
                                                                        let _e2314 = phi_2484_;
                                                                        phi_2485_ = _e2312;
                                                                        phi_2486_ = _e2063;
                                                                        phi_2487_ = _e2314;
                                                                    } else {
                                                                        phi_2485_ = lt_bvh_triangle_Intersection();
                                                                        phi_2486_ = true;
                                                                        phi_2487_ = false;
                                                                    }
                                                                    let _e2316 = phi_2485_;
                                                                    let _e2318 = phi_2486_;
                                                                    let _e2320 = phi_2487_;
                                                                    if _e2318 {
                                                                        phi_2491_ = true;
                                                                    } else {
                                                                        phi_2491_ = _e2320;
                                                                    }
                                                                    let _e2322 = phi_2491_;
                                                                    if _e2322 {
                                                                        phi_2495_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2495_ = _e2316;
                                                                    }
                                                                    let _e2324 = phi_2495_;
                                                                    if _e2324.is_hit {
                                                                        if (_e2324.t > 0f) {
                                                                            if (_e2324.t < _e116) {
                                                                                let _e2331 = triangles.member[(0u + _e1876)].i0_;
                                                                                let _e2333 = ((_e2331 & 2147483648u) == 0u);
                                                                                if _e2333 {
                                                                                    phi_2521_ = false;
                                                                                    phi_2522_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2520_ = false;
                                                                                    } else {
                                                                                        phi_2520_ = true;
                                                                                    }
                                                                                    let _e2335 = phi_2520_;
                                                                                    phi_2521_ = _e2335;
                                                                                    phi_2522_ = true;
                                                                                }
                                                                                let _e2337 = phi_2521_;
                                                                                let _e2339 = phi_2522_;
                                                                                phi_2523_ = _e2337;
                                                                                phi_2524_ = _e2333;
                                                                                phi_2525_ = _e2339;
                                                                            } else {
                                                                                phi_2523_ = true;
                                                                                phi_2524_ = false;
                                                                                phi_2525_ = false;
                                                                            }
                                                                            let _e2341 = phi_2523_;
                                                                            let _e2343 = phi_2524_;
                                                                            let _e2345 = phi_2525_;
                                                                            phi_2526_ = _e2341;
                                                                            phi_2527_ = _e2343;
                                                                            phi_2528_ = _e2345;
                                                                        } else {
                                                                            phi_2526_ = true;
                                                                            phi_2527_ = false;
                                                                            phi_2528_ = false;
                                                                        }
                                                                        let _e2347 = phi_2526_;
                                                                        let _e2349 = phi_2527_;
                                                                        let _e2351 = phi_2528_;
                                                                        phi_2529_ = _e2347;
                                                                        phi_2530_ = _e2349;
                                                                        phi_2531_ = _e2351;
                                                                    } else {
                                                                        phi_2529_ = true;
                                                                        phi_2530_ = false;
                                                                        phi_2531_ = false;
                                                                    }
                                                                    let _e2353 = phi_2529_;
                                                                    let _e2355 = phi_2530_;
                                                                    let _e2357 = phi_2531_;
                                                                    if _e2353 {
                                                                        phi_2535_ = false;
                                                                        phi_2536_ = false;
                                                                    } else {
                                                                        phi_2535_ = _e2355;
                                                                        phi_2536_ = _e2357;
                                                                    }
                                                                    let _e2359 = phi_2535_;
                                                                    let _e2361 = phi_2536_;
                                                                    phi_1927_ = (_e1867 & (_e1867 - 1u));
                                                                    phi_2537_ = _e2353;
                                                                    phi_2538_ = _e2359;
                                                                    phi_2539_ = _e2361;
                                                                }
                                                                let _e2363 = phi_1927_;
                                                                let _e2365 = phi_2537_;
                                                                let _e2367 = phi_2538_;
                                                                let _e2369 = phi_2539_;
                                                                local_12 = _e2367;
                                                                local_13 = _e2369;
                                                                continue;
                                                                continuing {
                                                                    phi_1926_ = _e2363;
                                                                    break if !(_e2365);
                                                                }
                                                            }
                                                            let _e2372 = local_8;
                                                            if _e2372 {
                                                                let _e2374 = local.group_mask;
                                                                if ((_e2374 & 4278190080u) == 0u) {
                                                                    let _e2378 = local.len;
                                                                    if (_e2378 == 0u) {
                                                                        phi_2581_ = false;
                                                                    } else {
                                                                        let _e2382 = local.len;
                                                                        local.len = (_e2382 - 1u);
                                                                        let _e2385 = local.len;
                                                                        if (_e2385 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2390 = local.first[(0u + _e2385)];
                                                                        local.group = _e2390;
                                                                        let _e2393 = local.len;
                                                                        if (_e2393 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2398 = local.mask[(0u + _e2393)];
                                                                        local.group_mask = _e2398;
                                                                        phi_2581_ = true;
                                                                    }
                                                                    let _e2401 = phi_2581_;
                                                                    phi_2582_ = _e2401;
                                                                } else {
                                                                    phi_2582_ = true;
                                                                }
                                                                let _e2403 = phi_2582_;
                                                                if _e2403 {
                                                                    let _e2405 = local.group_mask;
                                                                    let _e2411 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2405)), 32u, (_e2405 == 0u)));
                                                                    let _e2415 = local.group_mask;
                                                                    let _e2429 = local.group_mask;
                                                                    local.group_mask = (_e2429 & ~((1u << bitcast<u32>((_e2411 & 31u)))));
                                                                    let _e2432 = local.group;
                                                                    phi_2613_ = (_e2432 + countOneBits(((_e2415 & ~((4294967295u << bitcast<u32>((((_e2411 - 24u) ^ _e1293) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2613_ = 4294967295u;
                                                                }
                                                                let _e2435 = phi_2613_;
                                                                phi_2614_ = _e2435;
                                                                phi_2615_ = false;
                                                                phi_2616_ = false;
                                                            } else {
                                                                phi_2614_ = u32();
                                                                let _e2818 = local_12;
                                                                phi_2615_ = _e2818;
                                                                let _e2821 = local_13;
                                                                phi_2616_ = _e2821;
                                                            }
                                                            let _e2437 = phi_2614_;
                                                            let _e2439 = phi_2615_;
                                                            let _e2441 = phi_2616_;
                                                            phi_1597_ = _e2437;
                                                            let _e2825 = local_14;
                                                            phi_2617_ = _e2825;
                                                            phi_2618_ = false;
                                                            phi_2619_ = _e2439;
                                                            phi_2620_ = _e2441;
                                                        } else {
                                                            phi_1597_ = u32();
                                                            phi_2617_ = false;
                                                            phi_2618_ = true;
                                                            phi_2619_ = false;
                                                            phi_2620_ = false;
                                                        }
                                                        let _e2443 = phi_1597_;
                                                        let _e2445 = phi_2617_;
                                                        let _e2447 = phi_2618_;
                                                        let _e2449 = phi_2619_;
                                                        let _e2451 = phi_2620_;
                                                        local_9 = _e2447;
                                                        local_15 = _e2449;
                                                        local_16 = _e2451;
                                                        continue;
                                                        continuing {
                                                            phi_1596_ = _e2443;
                                                            break if !(_e2445);
                                                        }
                                                    }
                                                    let _e2454 = local_9;
                                                    if _e2454 {
                                                        phi_2624_ = false;
                                                        phi_2625_ = false;
                                                    } else {
                                                        let _e2832 = local_15;
                                                        phi_2624_ = _e2832;
                                                        let _e2835 = local_16;
                                                        phi_2625_ = _e2835;
                                                    }
                                                    let _e2456 = phi_2624_;
                                                    let _e2458 = phi_2625_;
                                                    if _e2456 {
                                                        phi_2629_ = true;
                                                    } else {
                                                        phi_2629_ = _e2458;
                                                    }
                                                    let _e2460 = phi_2629_;
                                                    if _e2460 {
                                                        phi_2633_ = true;
                                                    } else {
                                                        phi_2633_ = false;
                                                    }
                                                    let _e2462 = phi_2633_;
                                                    phi_2634_ = _e2462;
                                                }
                                                let _e2464 = phi_2634_;
                                                phi_2635_ = _e2464;
                                                phi_2636_ = _e1119;
                                            } else {
                                                phi_2635_ = bool();
                                                phi_2636_ = true;
                                            }
                                            let _e2466 = phi_2635_;
                                            let _e2468 = phi_2636_;
                                            if _e2468 {
                                                phi_2640_ = false;
                                            } else {
                                                phi_2640_ = _e2466;
                                            }
                                            let _e2470 = phi_2640_;
                                            if _e2470 {
                                                phi_2644_ = false;
                                            } else {
                                                phi_2644_ = true;
                                            }
                                            let _e2472 = phi_2644_;
                                            phi_2645_ = _e2472;
                                        } else {
                                            phi_2645_ = true;
                                        }
                                        let _e2474 = phi_2645_;
                                        phi_2646_ = _e2474;
                                    } else {
                                        phi_2646_ = true;
                                    }
                                    let _e2476 = phi_2646_;
                                    phi_2647_ = _e2476;
                                } else {
                                    phi_2647_ = true;
                                }
                                let _e2478 = phi_2647_;
                                if _e2478 {
                                }
                                phi_991_ = (_e906 & (_e906 - 1u));
                                phi_2651_ = _e2478;
                            }
                            let _e2480 = phi_991_;
                            let _e2482 = phi_2651_;
                            continue;
                            continuing {
                                phi_990_ = _e2480;
                                break if !(_e2482);
                            }
                        }
                        let _e2485 = local_10;
                        if _e2485 {
                            let _e2487 = local_1.group_mask;
                            if ((_e2487 & 4278190080u) == 0u) {
                                let _e2491 = local_1.len;
                                if (_e2491 == 0u) {
                                    phi_2693_ = false;
                                } else {
                                    let _e2495 = local_1.len;
                                    local_1.len = (_e2495 - 1u);
                                    let _e2498 = local_1.len;
                                    if (_e2498 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2503 = local_1.first[(0u + _e2498)];
                                    local_1.group = _e2503;
                                    let _e2506 = local_1.len;
                                    if (_e2506 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2511 = local_1.mask[(0u + _e2506)];
                                    local_1.group_mask = _e2511;
                                    phi_2693_ = true;
                                }
                                let _e2514 = phi_2693_;
                                phi_2694_ = _e2514;
                            } else {
                                phi_2694_ = true;
                            }
                            let _e2516 = phi_2694_;
                            if _e2516 {
                                let _e2518 = local_1.group_mask;
                                let _e2524 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2518)), 32u, (_e2518 == 0u)));
                                let _e2528 = local_1.group_mask;
                                let _e2542 = local_1.group_mask;
                                local_1.group_mask = (_e2542 & ~((1u << bitcast<u32>((_e2524 & 31u)))));
                                let _e2545 = local_1.group;
                                phi_2725_ = (_e2545 + countOneBits(((_e2528 & ~((4294967295u << bitcast<u32>((((_e2524 - 24u) ^ _e332) & 31u))))) & 255u)));
                            } else {
                                phi_2725_ = 4294967295u;
                            }
                            let _e2548 = phi_2725_;
                            phi_2726_ = _e2548;
                        } else {
                            phi_2726_ = u32();
                        }
                        let _e2550 = phi_2726_;
                        phi_661_ = _e2550;
                        let _e2856 = local_17;
                        phi_2727_ = _e2856;
                        phi_2728_ = false;
                    } else {
                        phi_661_ = u32();
                        phi_2727_ = false;
                        phi_2728_ = true;
                    }
                    let _e2552 = phi_661_;
                    let _e2554 = phi_2727_;
                    let _e2556 = phi_2728_;
                    local_11 = _e2556;
                    continue;
                    continuing {
                        phi_660_ = _e2552;
                        break if !(_e2554);
                    }
                }
                let _e2559 = local_11;
                if _e2559 {
                    phi_2732_ = false;
                } else {
                    phi_2732_ = true;
                }
                let _e2561 = phi_2732_;
                if _e2561 {
                    phi_2736_ = true;
                } else {
                    phi_2736_ = false;
                }
                let _e2563 = phi_2736_;
                phi_2737_ = _e2563;
            }
            let _e2565 = phi_2737_;
            phi_2738_ = _e2565;
            phi_2739_ = _e188;
        } else {
            phi_2738_ = bool();
            phi_2739_ = true;
        }
        let _e2567 = phi_2738_;
        let _e2569 = phi_2739_;
        if _e2569 {
            phi_2743_ = false;
        } else {
            phi_2743_ = _e2567;
        }
        let _e2571 = phi_2743_;
        if _e2571 {
            phi_2747_ = 0f;
        } else {
            phi_2747_ = 1f;
        }
        let _e2573 = phi_2747_;
        if (_e85 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e85)] = _e2573;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
