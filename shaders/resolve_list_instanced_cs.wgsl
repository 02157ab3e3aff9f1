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

struct type_11 {
    member: array<u32>,
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

struct type_25 {
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

struct type_34 {
    member: array<abi_Sample>,
}

struct type_38 {
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

struct type_46 {
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

struct type_52 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_34;
@group(0) @binding(6) 
var<storage> instances: type_25;
@group(0) @binding(0) 
var<uniform> p: type_52;
@group(0) @binding(2) 
var<storage> nodes: type_46;
@group(0) @binding(3) 
var<storage> triangles: type_6;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_38;
@group(0) @binding(5) 
var<storage> list: type_11;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_162_: bool;
    var phi_166_: f32;

    if (param != param) {
        phi_162_ = true;
    } else {
        let _e53 = (param_1 >= param);
        if _e53 {
        }
        phi_162_ = _e53;
    }
    let _e55 = phi_162_;
    if _e55 {
        phi_166_ = param_1;
    } else {
        phi_166_ = param;
    }
    let _e57 = phi_166_;
    return _e57;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_178_: bool;
    var phi_182_: f32;

    if (param_2 != param_2) {
        phi_178_ = true;
    } else {
        let _e53 = (param_3 <= param_2);
        if _e53 {
        }
        phi_178_ = _e53;
    }
    let _e55 = phi_178_;
    if _e55 {
        phi_182_ = param_3;
    } else {
        phi_182_ = param_2;
    }
    let _e57 = phi_182_;
    return _e57;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_281_: f32;
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
    var phi_437_: f32;
    var phi_444_: f32;
    var phi_452_: f32;
    var phi_459_: f32;
    var phi_467_: f32;
    var phi_474_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_522_: u32;
    var phi_527_: u32;
    var phi_532_: u32;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_678_: u32;
    var phi_680_: u32;
    var phi_761_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_788_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_815_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_821_: u32;
    var phi_824_: u32;
    var phi_838_: u32;
    var phi_848_: u32;
    var phi_858_: u32;
    var phi_876_: u32;
    var phi_886_: u32;
    var phi_896_: u32;
    var phi_932_: u32;
    var phi_945_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_822_: u32;
    var phi_825_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1010_: u32;
    var phi_1060_: f32;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1078_: f32;
    var phi_1083_: f32;
    var phi_1088_: f32;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
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
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1262_: bool;
    var phi_1266_: bool;
    var phi_1336_: f32;
    var phi_1343_: f32;
    var phi_1350_: f32;
    var phi_1357_: f32;
    var phi_1364_: f32;
    var phi_1371_: f32;
    var phi_1388_: f32;
    var phi_1393_: f32;
    var phi_1398_: f32;
    var phi_1426_: bool;
    var phi_1427_: bool;
    var phi_1435_: u32;
    var phi_1436_: u32;
    var phi_1447_: vec3<f32>;
    var phi_1448_: vec3<f32>;
    var phi_1461_: u32;
    var phi_1466_: u32;
    var phi_1471_: u32;
    var phi_1585_: bool;
    var phi_1586_: bool;
    var phi_1617_: u32;
    var phi_1619_: u32;
    var phi_1700_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1727_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1754_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1760_: u32;
    var phi_1763_: u32;
    var phi_1777_: u32;
    var phi_1787_: u32;
    var phi_1797_: u32;
    var phi_1815_: u32;
    var phi_1825_: u32;
    var phi_1835_: u32;
    var phi_1871_: u32;
    var phi_1884_: u32;
    var phi_1889_: u32;
    var phi_1890_: u32;
    var phi_1891_: u32;
    var phi_1761_: u32;
    var phi_1764_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1949_: u32;
    var phi_1994_: vec3<f32>;
    var phi_1995_: vec3<f32>;
    var phi_2026_: vec3<f32>;
    var phi_2027_: vec3<f32>;
    var phi_2058_: vec3<f32>;
    var phi_2059_: vec3<f32>;
    var phi_2079_: bool;
    var phi_2080_: bool;
    var phi_2084_: f32;
    var phi_2085_: f32;
    var phi_2086_: f32;
    var phi_2087_: f32;
    var phi_2095_: f32;
    var phi_2105_: bool;
    var phi_2106_: bool;
    var phi_2110_: f32;
    var phi_2111_: f32;
    var phi_2112_: f32;
    var phi_2113_: f32;
    var phi_2121_: f32;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2136_: f32;
    var phi_2137_: f32;
    var phi_2138_: f32;
    var phi_2139_: f32;
    var phi_2147_: f32;
    var phi_2162_: f32;
    var phi_2163_: bool;
    var phi_2164_: f32;
    var phi_2165_: bool;
    var phi_2166_: f32;
    var phi_2167_: bool;
    var phi_2185_: f32;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2188_: f32;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2194_: bool;
    var phi_2195_: f32;
    var phi_2196_: bool;
    var phi_2222_: f32;
    var phi_2231_: f32;
    var phi_2240_: f32;
    var phi_2249_: f32;
    var phi_2256_: f32;
    var phi_2263_: f32;
    var phi_2276_: f32;
    var phi_2285_: f32;
    var phi_2294_: f32;
    var phi_2303_: f32;
    var phi_2310_: f32;
    var phi_2317_: f32;
    var phi_2334_: f32;
    var phi_2339_: f32;
    var phi_2344_: f32;
    var phi_2352_: f32;
    var phi_2357_: f32;
    var phi_2362_: f32;
    var phi_2374_: f32;
    var phi_2379_: f32;
    var phi_2384_: f32;
    var phi_2389_: f32;
    var phi_2394_: lt_bvh_triangle_Intersection;
    var phi_2395_: lt_bvh_triangle_Intersection;
    var phi_2396_: bool;
    var phi_2400_: lt_bvh_triangle_Intersection;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_1950_: u32;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2444_: bool;
    var local_8: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2518_: u32;
    var phi_2519_: u32;
    var phi_2520_: bool;
    var phi_2521_: bool;
    var phi_1620_: u32;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var local_9: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2534_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2545_: bool;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_1011_: u32;
    var phi_2556_: bool;
    var local_10: bool;
    var phi_2598_: bool;
    var phi_2599_: bool;
    var phi_2630_: u32;
    var phi_2631_: u32;
    var phi_681_: u32;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var local_11: bool;
    var phi_2637_: bool;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2643_: bool;
    var phi_2644_: bool;
    var phi_2648_: bool;
    var phi_2652_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e52 = id_1;
    let _e59 = arrayLength((&nodes.member));
    let _e68 = arrayLength((&list.member));
    if (3u < _e68) {
    } else {
        return;
    }
    let _e75 = list.member[3u];
    if (_e52.x < _e75) {
        let _e78 = (_e52.x + 4u);
        if (_e78 < _e68) {
        } else {
            return;
        }
        let _e82 = list.member[(0u + _e78)];
        let _e84 = p.member.root;
        if (_e82 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e89 = p.member.light;
        let _e91 = samples.member[(0u + _e82)].position;
        let _e93 = samples.member[(0u + _e82)].normal;
        let _e95 = samples.member[(0u + _e82)].magnitude;
        let _e97 = ((8f / 8388608f) * _e95);
        let _e99 = (_e93.x * _e97);
        let _e101 = (_e93.y * _e97);
        let _e103 = (_e93.z * _e97);
        let _e105 = (_e91.x + _e99);
        let _e107 = (_e91.y + _e101);
        let _e109 = (_e91.z + _e103);
        let _e111 = (_e91 + vec3<f32>(_e99, _e101, _e103));
        if (_e89.w == 0f) {
            phi_281_ = 300000000000000000000000000000000000000f;
        } else {
            phi_281_ = 1f;
        }
        let _e115 = phi_281_;
        let _e116 = lt_shaders_evaluate_to_light(_e111, _e89);
        let _e117 = lt_bvh_Ray(_e111, 0f, _e116, _e115);
        let _e122 = abs(_e116.x);
        let _e124 = abs(_e116.y);
        let _e126 = abs(_e116.z);
        if (abs(_e105) < 1000000000000000f) {
            if (abs(_e107) < 1000000000000000f) {
                if (abs(_e109) < 1000000000000000f) {
                    if (_e122 < 1000000000000000f) {
                        if (_e124 < 1000000000000000f) {
                            if (_e126 < 1000000000000000f) {
                                if (_e122 > 0f) {
                                    phi_333_ = bool();
                                    phi_334_ = true;
                                } else {
                                    let _e134 = (_e124 > 0f);
                                    if _e134 {
                                        phi_332_ = bool();
                                    } else {
                                        phi_332_ = (_e126 > 0f);
                                    }
                                    let _e137 = phi_332_;
                                    phi_333_ = _e137;
                                    phi_334_ = _e134;
                                }
                                let _e139 = phi_333_;
                                let _e141 = phi_334_;
                                if _e141 {
                                    phi_338_ = true;
                                } else {
                                    phi_338_ = _e139;
                                }
                                let _e143 = phi_338_;
                                phi_339_ = _e143;
                                phi_340_ = false;
                            } else {
                                phi_339_ = bool();
                                phi_340_ = true;
                            }
                            let _e145 = phi_339_;
                            let _e147 = phi_340_;
                            phi_341_ = _e145;
                            phi_342_ = false;
                            phi_343_ = _e147;
                        } else {
                            phi_341_ = bool();
                            phi_342_ = true;
                            phi_343_ = false;
                        }
                        let _e149 = phi_341_;
                        let _e151 = phi_342_;
                        let _e153 = phi_343_;
                        phi_344_ = _e149;
                        phi_345_ = _e151;
                        phi_346_ = _e153;
                    } else {
                        phi_344_ = bool();
                        phi_345_ = true;
                        phi_346_ = false;
                    }
                    let _e155 = phi_344_;
                    let _e157 = phi_345_;
                    let _e159 = phi_346_;
                    phi_347_ = _e155;
                    phi_348_ = _e157;
                    phi_349_ = _e159;
                } else {
                    phi_347_ = bool();
                    phi_348_ = true;
                    phi_349_ = false;
                }
                let _e161 = phi_347_;
                let _e163 = phi_348_;
                let _e165 = phi_349_;
                phi_350_ = _e161;
                phi_351_ = _e163;
                phi_352_ = _e165;
            } else {
                phi_350_ = bool();
                phi_351_ = true;
                phi_352_ = false;
            }
            let _e167 = phi_350_;
            let _e169 = phi_351_;
            let _e171 = phi_352_;
            phi_353_ = _e167;
            phi_354_ = _e169;
            phi_355_ = _e171;
        } else {
            phi_353_ = bool();
            phi_354_ = true;
            phi_355_ = false;
        }
        let _e173 = phi_353_;
        let _e175 = phi_354_;
        let _e177 = phi_355_;
        if _e175 {
            phi_359_ = true;
        } else {
            phi_359_ = _e177;
        }
        let _e179 = phi_359_;
        if _e179 {
            phi_363_ = false;
        } else {
            phi_363_ = _e173;
        }
        let _e181 = phi_363_;
        if _e181 {
            let _e182 = (_e84 >= _e59);
            if _e182 {
                phi_2642_ = bool();
            } else {
                if (_e84 < _e59) {
                } else {
                    return;
                }
                let _e188 = nodes.member[(0u + _e84)].frame[0u];
                let _e192 = nodes.member[(0u + _e84)].frame[1u];
                let _e196 = nodes.member[(0u + _e84)].frame[2u];
                let _e200 = nodes.member[(0u + _e84)].frame[0u];
                let _e204 = nodes.member[(0u + _e84)].frame[1u];
                let _e208 = nodes.member[(0u + _e84)].frame[2u];
                let _e212 = nodes.member[(0u + _e84)].frame[3u];
                let _e249 = core_intrinsics_maximum_number_nsz_f32_(abs(_e116.x), abs(_e116.y));
                let _e250 = core_intrinsics_maximum_number_nsz_f32_(_e249, abs(_e116.z));
                let _e251 = (_e250 * 0.0000000000009094947f);
                if (abs(_e117.direction.x) < _e251) {
                    phi_437_ = _e251;
                } else {
                    phi_437_ = abs(_e117.direction.x);
                }
                let _e258 = phi_437_;
                if (_e117.direction.x < 0f) {
                    phi_444_ = (-1f / _e258);
                } else {
                    phi_444_ = (1f / _e258);
                }
                let _e263 = phi_444_;
                if (abs(_e117.direction.y) < _e251) {
                    phi_452_ = _e251;
                } else {
                    phi_452_ = abs(_e117.direction.y);
                }
                let _e270 = phi_452_;
                if (_e117.direction.y < 0f) {
                    phi_459_ = (-1f / _e270);
                } else {
                    phi_459_ = (1f / _e270);
                }
                let _e275 = phi_459_;
                if (abs(_e117.direction.z) < _e251) {
                    phi_467_ = _e251;
                } else {
                    phi_467_ = abs(_e117.direction.z);
                }
                let _e282 = phi_467_;
                if (_e117.direction.z < 0f) {
                    phi_474_ = (-1f / _e282);
                } else {
                    phi_474_ = (1f / _e282);
                }
                let _e287 = phi_474_;
                let _e291 = abs((bitcast<f32>(_e188) - _e105));
                let _e292 = abs((bitcast<f32>(_e192) - _e107));
                let _e293 = abs((bitcast<f32>(_e196) - _e109));
                let _e297 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e212 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105));
                let _e298 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e212 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e299 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e212 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                if (_e291 > _e297) {
                    phi_491_ = _e291;
                } else {
                    phi_491_ = _e297;
                }
                let _e302 = phi_491_;
                if (_e292 > _e298) {
                    phi_496_ = _e292;
                } else {
                    phi_496_ = _e298;
                }
                let _e305 = phi_496_;
                if (_e293 > _e299) {
                    phi_501_ = _e293;
                } else {
                    phi_501_ = _e299;
                }
                let _e308 = phi_501_;
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(_e302, _e305);
                let _e310 = core_intrinsics_maximum_number_nsz_f32_(_e309, _e308);
                let _e314 = (_e310 * 0.0000019073486f);
                let _e315 = (abs(_e263) * _e314);
                let _e316 = (abs(_e275) * _e314);
                let _e317 = (abs(_e287) * _e314);
                let _e321 = (_e310 * 0.0000009536743f);
                let _e322 = (abs(_e263) * _e321);
                let _e323 = (abs(_e275) * _e321);
                let _e324 = (abs(_e287) * _e321);
                if (_e263 < 0f) {
                    phi_522_ = 0u;
                } else {
                    phi_522_ = 1u;
                }
                let _e327 = phi_522_;
                if (_e275 < 0f) {
                    phi_527_ = 0u;
                } else {
                    phi_527_ = 2u;
                }
                let _e330 = phi_527_;
                if (_e287 < 0f) {
                    phi_532_ = 0u;
                } else {
                    phi_532_ = 4u;
                }
                let _e333 = phi_532_;
                let _e335 = ((_e327 | _e330) | _e333);
                let _e336 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e84, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e336.first[0], _e336.first[1], _e336.first[2], _e336.first[3], _e336.first[4], _e336.first[5], _e336.first[6], _e336.first[7], _e336.first[8], _e336.first[9], _e336.first[10], _e336.first[11], _e336.first[12], _e336.first[13], _e336.first[14], _e336.first[15], _e336.first[16], _e336.first[17], _e336.first[18], _e336.first[19], _e336.first[20], _e336.first[21], _e336.first[22], _e336.first[23], _e336.first[24], _e336.first[25], _e336.first[26], _e336.first[27], _e336.first[28], _e336.first[29], _e336.first[30], _e336.first[31]), array<u32, 32>(_e336.mask[0], _e336.mask[1], _e336.mask[2], _e336.mask[3], _e336.mask[4], _e336.mask[5], _e336.mask[6], _e336.mask[7], _e336.mask[8], _e336.mask[9], _e336.mask[10], _e336.mask[11], _e336.mask[12], _e336.mask[13], _e336.mask[14], _e336.mask[15], _e336.mask[16], _e336.mask[17], _e336.mask[18], _e336.mask[19], _e336.mask[20], _e336.mask[21], _e336.mask[22], _e336.mask[23], _e336.mask[24], _e336.mask[25], _e336.mask[26], _e336.mask[27], _e336.mask[28], _e336.mask[29], _e336.mask[30], _e336.mask[31]), _e336.len, _e336.group, _e336.group_mask);
                let _e410 = local_1.group_mask;
                if ((_e410 & 4278190080u) == 0u) {
                    let _e414 = local_1.len;
                    if (_e414 == 0u) {
                        phi_646_ = false;
                    } else {
                        let _e418 = local_1.len;
                        local_1.len = (_e418 - 1u);
                        let _e421 = local_1.len;
                        if (_e421 < 32u) {
                        } else {
                            return;
                        }
                        let _e426 = local_1.first[(0u + _e421)];
                        local_1.group = _e426;
                        let _e429 = local_1.len;
                        if (_e429 < 32u) {
                        } else {
                            return;
                        }
                        let _e434 = local_1.mask[(0u + _e429)];
                        local_1.group_mask = _e434;
                        phi_646_ = true;
                    }
                    let _e437 = phi_646_;
                    phi_647_ = _e437;
                } else {
                    phi_647_ = true;
                }
                let _e439 = phi_647_;
                if _e439 {
                    let _e441 = local_1.group_mask;
                    let _e447 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e441)), 32u, (_e441 == 0u)));
                    let _e451 = local_1.group_mask;
                    let _e465 = local_1.group_mask;
                    local_1.group_mask = (_e465 & ~((1u << bitcast<u32>((_e447 & 31u)))));
                    let _e468 = local_1.group;
                    phi_678_ = (_e468 + countOneBits(((_e451 & ~((4294967295u << bitcast<u32>((((_e447 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_678_ = 4294967295u;
                }
                let _e471 = phi_678_;
                phi_680_ = _e471;
                loop {
                    let _e473 = phi_680_;
                    if (_e473 != 4294967295u) {
                        if (_e473 < _e59) {
                        } else {
                            return;
                        }
                        let _e480 = nodes.member[(0u + _e473)].frame[3u];
                        let _e505 = (bitcast<f32>((((_e480 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e263);
                        let _e506 = (bitcast<f32>((((_e480 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e275);
                        let _e507 = (bitcast<f32>((((_e480 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e287);
                        let _e510 = nodes.member[(0u + _e473)].frame[0u];
                        let _e514 = nodes.member[(0u + _e473)].frame[1u];
                        let _e518 = nodes.member[(0u + _e473)].frame[2u];
                        let _e523 = ((bitcast<f32>(_e510) - _e105) * _e263);
                        let _e524 = ((bitcast<f32>(_e514) - _e107) * _e275);
                        let _e525 = ((bitcast<f32>(_e518) - _e109) * _e287);
                        let _e533 = nodes.member[(0u + _e473)].x;
                        if (_e263 < 0f) {
                            let _e544 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e533.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e550 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e544.unnamed.root, _e533.w), _e544.unnamed_1);
                            let _e556 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e550.unnamed, lt_bvh_traverse_Tree(_e533.x, _e550.unnamed_1.first_primitive));
                            phi_761_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e556.unnamed, lt_bvh_traverse_Tree(_e556.unnamed_1.root, _e533.y));
                        } else {
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e533.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e572.unnamed.root, _e533.y), _e572.unnamed_1);
                            let _e584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e533.z, _e578.unnamed_1.first_primitive));
                            phi_761_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e584.unnamed, lt_bvh_traverse_Tree(_e584.unnamed_1.root, _e533.w));
                        }
                        let _e592 = phi_761_;
                        let _e602 = nodes.member[(0u + _e473)].y;
                        if (_e275 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e613.unnamed.root, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_bvh_traverse_Tree(_e602.x, _e619.unnamed_1.first_primitive));
                            phi_788_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e625.unnamed_1.root, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e602.z, _e647.unnamed_1.first_primitive));
                            phi_788_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e602.w));
                        }
                        let _e661 = phi_788_;
                        let _e671 = nodes.member[(0u + _e473)].z;
                        if (_e287 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e682.unnamed.root, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_bvh_traverse_Tree(_e671.x, _e688.unnamed_1.first_primitive));
                            phi_815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e694.unnamed_1.root, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e671.z, _e716.unnamed_1.first_primitive));
                            phi_815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e671.w));
                        }
                        let _e730 = phi_815_;
                        phi_821_ = 0u;
                        phi_824_ = 0u;
                        loop {
                            let _e740 = phi_821_;
                            let _e742 = phi_824_;
                            local_2 = _e742;
                            local_3 = _e742;
                            local_4 = _e742;
                            let _e743 = (_e740 < 8u);
                            if _e743 {
                                let _e745 = (_e740 >> bitcast<u32>(2i));
                                let _e746 = (_e740 & 3u);
                                if (_e745 == 0u) {
                                    phi_838_ = _e592.unnamed.root;
                                } else {
                                    phi_838_ = _e592.unnamed.first_primitive;
                                }
                                let _e749 = phi_838_;
                                if (_e745 == 0u) {
                                    phi_848_ = _e661.unnamed.root;
                                } else {
                                    phi_848_ = _e661.unnamed.first_primitive;
                                }
                                let _e758 = phi_848_;
                                if (_e745 == 0u) {
                                    phi_858_ = _e730.unnamed.root;
                                } else {
                                    phi_858_ = _e730.unnamed.first_primitive;
                                }
                                let _e767 = phi_858_;
                                let _e780 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e749 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e505) + (_e523 - _e315)), ((f32(((_e758 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e506) + (_e524 - _e316)));
                                let _e781 = core_intrinsics_maximum_number_nsz_f32_(_e780, ((f32(((_e767 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e317)));
                                if (_e745 == 0u) {
                                    phi_876_ = _e592.unnamed_1.root;
                                } else {
                                    phi_876_ = _e592.unnamed_1.first_primitive;
                                }
                                let _e784 = phi_876_;
                                if (_e745 == 0u) {
                                    phi_886_ = _e661.unnamed_1.root;
                                } else {
                                    phi_886_ = _e661.unnamed_1.first_primitive;
                                }
                                let _e793 = phi_886_;
                                if (_e745 == 0u) {
                                    phi_896_ = _e730.unnamed_1.root;
                                } else {
                                    phi_896_ = _e730.unnamed_1.first_primitive;
                                }
                                let _e802 = phi_896_;
                                let _e815 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e784 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e505) + (_e523 + _e315)), ((f32(((_e793 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e506) + (_e524 + _e316)));
                                let _e816 = core_intrinsics_minimum_number_nsz_f32_(_e815, ((f32(((_e802 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e317)));
                                if (_e781 <= _e816) {
                                    if (_e781 <= _e115) {
                                        if (_e816 >= 0f) {
                                            if (_e745 == 0u) {
                                                let _e823 = nodes.member[(0u + _e473)].links[2u];
                                                phi_932_ = _e823;
                                            } else {
                                                let _e826 = nodes.member[(0u + _e473)].links[3u];
                                                phi_932_ = _e826;
                                            }
                                            let _e828 = phi_932_;
                                            let _e833 = ((_e828 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u);
                                            let _e834 = (_e833 & 31u);
                                            if (_e834 >= 24u) {
                                                phi_945_ = (24u + ((_e834 - 24u) ^ _e335));
                                            } else {
                                                phi_945_ = _e834;
                                            }
                                            let _e840 = phi_945_;
                                            phi_950_ = (_e742 | ((_e833 >> bitcast<u32>(5i)) << bitcast<u32>((_e840 & 31u))));
                                        } else {
                                            phi_950_ = _e742;
                                        }
                                        let _e848 = phi_950_;
                                        phi_951_ = _e848;
                                    } else {
                                        phi_951_ = _e742;
                                    }
                                    let _e850 = phi_951_;
                                    phi_952_ = _e850;
                                } else {
                                    phi_952_ = _e742;
                                }
                                let _e852 = phi_952_;
                                phi_822_ = (_e740 + 1u);
                                phi_825_ = _e852;
                            } else {
                                phi_822_ = u32();
                                phi_825_ = u32();
                            }
                            let _e855 = phi_822_;
                            let _e857 = phi_825_;
                            continue;
                            continuing {
                                phi_821_ = _e855;
                                phi_824_ = _e857;
                                break if !(_e743);
                            }
                        }
                        let _e861 = nodes.member[(0u + _e473)].links[0u];
                        let _e865 = nodes.member[(0u + _e473)].frame[3u];
                        let _e869 = local_2;
                        if ((_e869 & 4278190080u) == 0u) {
                        } else {
                            let _e873 = local_1.group_mask;
                            if ((_e873 & 4278190080u) == 0u) {
                            } else {
                                let _e877 = local_1.len;
                                if (_e877 < 32u) {
                                    let _e880 = local_1.group;
                                    let _e882 = local_1.len;
                                    if (_e882 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e882)] = _e880;
                                    let _e888 = local_1.group_mask;
                                    let _e890 = local_1.len;
                                    if (_e890 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e890)] = _e888;
                                    let _e897 = local_1.len;
                                    local_1.len = (_e897 + 1u);
                                }
                            }
                            local_1.group = (_e84 + _e861);
                            let _e901 = local_3;
                            local_1.group_mask = ((_e901 & 4278190080u) | (_e865 >> bitcast<u32>(24i)));
                        }
                        let _e906 = local_4;
                        phi_1010_ = (_e906 & 16777215u);
                        loop {
                            let _e909 = phi_1010_;
                            let _e910 = (_e909 == 0u);
                            local_10 = _e910;
                            local_17 = _e910;
                            if _e910 {
                                phi_1011_ = u32();
                                phi_2556_ = false;
                            } else {
                                let _e913 = nodes.member[(0u + _e473)].links[1u];
                                let _e917 = (_e913 + select(firstTrailingBit(_e909), 32u, (_e909 == 0u)));
                                if (_e917 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e924 = instances.member[(0u + _e917)].low_world;
                                let _e926 = instances.member[(0u + _e917)].high_world;
                                let _e933 = ((_e924.x - _e105) * _e263);
                                let _e934 = ((_e924.y - _e107) * _e275);
                                let _e935 = ((_e924.z - _e109) * _e287);
                                let _e942 = ((_e926.x - _e105) * _e263);
                                let _e943 = ((_e926.y - _e107) * _e275);
                                let _e944 = ((_e926.z - _e109) * _e287);
                                if (_e933 < _e942) {
                                    phi_1060_ = _e933;
                                } else {
                                    phi_1060_ = _e942;
                                }
                                let _e947 = phi_1060_;
                                if (_e934 < _e943) {
                                    phi_1065_ = _e934;
                                } else {
                                    phi_1065_ = _e943;
                                }
                                let _e950 = phi_1065_;
                                if (_e935 < _e944) {
                                    phi_1070_ = _e935;
                                } else {
                                    phi_1070_ = _e944;
                                }
                                let _e953 = phi_1070_;
                                if (_e933 > _e942) {
                                    phi_1078_ = _e933;
                                } else {
                                    phi_1078_ = _e942;
                                }
                                let _e959 = phi_1078_;
                                if (_e934 > _e943) {
                                    phi_1083_ = _e934;
                                } else {
                                    phi_1083_ = _e943;
                                }
                                let _e962 = phi_1083_;
                                if (_e935 > _e944) {
                                    phi_1088_ = _e935;
                                } else {
                                    phi_1088_ = _e944;
                                }
                                let _e965 = phi_1088_;
                                let _e969 = core_intrinsics_maximum_number_nsz_f32_((_e947 - _e322), (_e950 - _e323));
                                let _e970 = core_intrinsics_maximum_number_nsz_f32_(_e969, (_e953 - _e324));
                                let _e971 = core_intrinsics_minimum_number_nsz_f32_((_e959 + _e322), (_e962 + _e323));
                                let _e972 = core_intrinsics_minimum_number_nsz_f32_(_e971, (_e965 + _e324));
                                if (_e970 <= _e972) {
                                    if (_e970 <= _e115) {
                                        if (_e972 >= 0f) {
                                            let _e978 = instances.member[(0u + _e917)].world_to_object[0u];
                                            let _e989 = ((((_e978.x * _e105) + (_e978.y * _e107)) + (_e978.z * _e109)) + (_e978.w * 1f));
                                            let _e991 = instances.member[(0u + _e917)].world_to_object[1u];
                                            let _e1002 = ((((_e991.x * _e105) + (_e991.y * _e107)) + (_e991.z * _e109)) + (_e991.w * 1f));
                                            let _e1004 = instances.member[(0u + _e917)].world_to_object[2u];
                                            let _e1015 = ((((_e1004.x * _e105) + (_e1004.y * _e107)) + (_e1004.z * _e109)) + (_e1004.w * 1f));
                                            let _e1021 = instances.member[(0u + _e917)].world_to_object[0u];
                                            let _e1032 = ((((_e1021.x * _e116.x) + (_e1021.y * _e116.y)) + (_e1021.z * _e116.z)) + (_e1021.w * 0f));
                                            let _e1034 = instances.member[(0u + _e917)].world_to_object[1u];
                                            let _e1045 = ((((_e1034.x * _e116.x) + (_e1034.y * _e116.y)) + (_e1034.z * _e116.z)) + (_e1034.w * 0f));
                                            let _e1047 = instances.member[(0u + _e917)].world_to_object[2u];
                                            let _e1058 = ((((_e1047.x * _e116.x) + (_e1047.y * _e116.y)) + (_e1047.z * _e116.z)) + (_e1047.w * 0f));
                                            let _e1061 = instances.member[(0u + _e917)].root;
                                            let _e1063 = instances.member[(0u + _e917)].first_triangle;
                                            let _e1067 = abs(_e1032);
                                            let _e1068 = abs(_e1045);
                                            let _e1069 = abs(_e1058);
                                            if (abs(_e989) < 1000000000000000f) {
                                                if (abs(_e1002) < 1000000000000000f) {
                                                    if (abs(_e1015) < 1000000000000000f) {
                                                        if (_e1067 < 1000000000000000f) {
                                                            if (_e1068 < 1000000000000000f) {
                                                                if (_e1069 < 1000000000000000f) {
                                                                    if (_e1067 > 0f) {
                                                                        phi_1236_ = bool();
                                                                        phi_1237_ = true;
                                                                    } else {
                                                                        let _e1077 = (_e1068 > 0f);
                                                                        if _e1077 {
                                                                            phi_1235_ = bool();
                                                                        } else {
                                                                            phi_1235_ = (_e1069 > 0f);
                                                                        }
                                                                        let _e1080 = phi_1235_;
                                                                        phi_1236_ = _e1080;
                                                                        phi_1237_ = _e1077;
                                                                    }
                                                                    let _e1082 = phi_1236_;
                                                                    let _e1084 = phi_1237_;
                                                                    if _e1084 {
                                                                        phi_1241_ = true;
                                                                    } else {
                                                                        phi_1241_ = _e1082;
                                                                    }
                                                                    let _e1086 = phi_1241_;
                                                                    phi_1242_ = _e1086;
                                                                    phi_1243_ = false;
                                                                } else {
                                                                    phi_1242_ = bool();
                                                                    phi_1243_ = true;
                                                                }
                                                                let _e1088 = phi_1242_;
                                                                let _e1090 = phi_1243_;
                                                                phi_1244_ = _e1088;
                                                                phi_1245_ = false;
                                                                phi_1246_ = _e1090;
                                                            } else {
                                                                phi_1244_ = bool();
                                                                phi_1245_ = true;
                                                                phi_1246_ = false;
                                                            }
                                                            let _e1092 = phi_1244_;
                                                            let _e1094 = phi_1245_;
                                                            let _e1096 = phi_1246_;
                                                            phi_1247_ = _e1092;
                                                            phi_1248_ = _e1094;
                                                            phi_1249_ = _e1096;
                                                        } else {
                                                            phi_1247_ = bool();
                                                            phi_1248_ = true;
                                                            phi_1249_ = false;
                                                        }
                                                        let _e1098 = phi_1247_;
                                                        let _e1100 = phi_1248_;
                                                        let _e1102 = phi_1249_;
                                                        phi_1250_ = _e1098;
                                                        phi_1251_ = _e1100;
                                                        phi_1252_ = _e1102;
                                                    } else {
                                                        phi_1250_ = bool();
                                                        phi_1251_ = true;
                                                        phi_1252_ = false;
                                                    }
                                                    let _e1104 = phi_1250_;
                                                    let _e1106 = phi_1251_;
                                                    let _e1108 = phi_1252_;
                                                    phi_1253_ = _e1104;
                                                    phi_1254_ = _e1106;
                                                    phi_1255_ = _e1108;
                                                } else {
                                                    phi_1253_ = bool();
                                                    phi_1254_ = true;
                                                    phi_1255_ = false;
                                                }
                                                let _e1110 = phi_1253_;
                                                let _e1112 = phi_1254_;
                                                let _e1114 = phi_1255_;
                                                phi_1256_ = _e1110;
                                                phi_1257_ = _e1112;
                                                phi_1258_ = _e1114;
                                            } else {
                                                phi_1256_ = bool();
                                                phi_1257_ = true;
                                                phi_1258_ = false;
                                            }
                                            let _e1116 = phi_1256_;
                                            let _e1118 = phi_1257_;
                                            let _e1120 = phi_1258_;
                                            if _e1118 {
                                                phi_1262_ = true;
                                            } else {
                                                phi_1262_ = _e1120;
                                            }
                                            let _e1122 = phi_1262_;
                                            if _e1122 {
                                                phi_1266_ = false;
                                            } else {
                                                phi_1266_ = _e1116;
                                            }
                                            let _e1124 = phi_1266_;
                                            if _e1124 {
                                                let _e1125 = (_e1061 >= _e59);
                                                if _e1125 {
                                                    phi_2539_ = bool();
                                                } else {
                                                    if (_e1061 < _e59) {
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
                                                        phi_1336_ = _e1191;
                                                    } else {
                                                        phi_1336_ = abs(_e1032);
                                                    }
                                                    let _e1196 = phi_1336_;
                                                    if (_e1032 < 0f) {
                                                        phi_1343_ = (-1f / _e1196);
                                                    } else {
                                                        phi_1343_ = (1f / _e1196);
                                                    }
                                                    let _e1201 = phi_1343_;
                                                    if (abs(_e1045) < _e1191) {
                                                        phi_1350_ = _e1191;
                                                    } else {
                                                        phi_1350_ = abs(_e1045);
                                                    }
                                                    let _e1206 = phi_1350_;
                                                    if (_e1045 < 0f) {
                                                        phi_1357_ = (-1f / _e1206);
                                                    } else {
                                                        phi_1357_ = (1f / _e1206);
                                                    }
                                                    let _e1211 = phi_1357_;
                                                    if (abs(_e1058) < _e1191) {
                                                        phi_1364_ = _e1191;
                                                    } else {
                                                        phi_1364_ = abs(_e1058);
                                                    }
                                                    let _e1216 = phi_1364_;
                                                    if (_e1058 < 0f) {
                                                        phi_1371_ = (-1f / _e1216);
                                                    } else {
                                                        phi_1371_ = (1f / _e1216);
                                                    }
                                                    let _e1221 = phi_1371_;
                                                    let _e1225 = abs((bitcast<f32>(_e1131) - _e989));
                                                    let _e1226 = abs((bitcast<f32>(_e1135) - _e1002));
                                                    let _e1227 = abs((bitcast<f32>(_e1139) - _e1015));
                                                    let _e1231 = abs(((bitcast<f32>(_e1143) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e989));
                                                    let _e1232 = abs(((bitcast<f32>(_e1147) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1002));
                                                    let _e1233 = abs(((bitcast<f32>(_e1151) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1015));
                                                    if (_e1225 > _e1231) {
                                                        phi_1388_ = _e1225;
                                                    } else {
                                                        phi_1388_ = _e1231;
                                                    }
                                                    let _e1236 = phi_1388_;
                                                    if (_e1226 > _e1232) {
                                                        phi_1393_ = _e1226;
                                                    } else {
                                                        phi_1393_ = _e1232;
                                                    }
                                                    let _e1239 = phi_1393_;
                                                    if (_e1227 > _e1233) {
                                                        phi_1398_ = _e1227;
                                                    } else {
                                                        phi_1398_ = _e1233;
                                                    }
                                                    let _e1242 = phi_1398_;
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
                                                            phi_1426_ = false;
                                                        } else {
                                                            phi_1426_ = true;
                                                        }
                                                        let _e1265 = phi_1426_;
                                                        phi_1427_ = _e1265;
                                                    } else {
                                                        phi_1427_ = true;
                                                    }
                                                    let _e1267 = phi_1427_;
                                                    if _e1267 {
                                                        if (_e1260 >= _e1261) {
                                                            phi_1435_ = 1u;
                                                        } else {
                                                            phi_1435_ = 2u;
                                                        }
                                                        let _e1270 = phi_1435_;
                                                        phi_1436_ = _e1270;
                                                    } else {
                                                        phi_1436_ = 0u;
                                                    }
                                                    let _e1272 = phi_1436_;
                                                    if (_e1272 == 0u) {
                                                        phi_1448_ = vec3<f32>(_e1045, _e1058, _e1032);
                                                    } else {
                                                        if (_e1272 == 1u) {
                                                            phi_1447_ = vec3<f32>(_e1058, _e1032, _e1045);
                                                        } else {
                                                            phi_1447_ = vec3<f32>(_e1032, _e1045, _e1058);
                                                        }
                                                        let _e1278 = phi_1447_;
                                                        phi_1448_ = _e1278;
                                                    }
                                                    let _e1280 = phi_1448_;
                                                    let _e1283 = (_e1280.x / _e1280.z);
                                                    let _e1286 = (_e1280.y / _e1280.z);
                                                    let _e1288 = (1f / _e1280.z);
                                                    if (_e1201 < 0f) {
                                                        phi_1461_ = 0u;
                                                    } else {
                                                        phi_1461_ = 1u;
                                                    }
                                                    let _e1291 = phi_1461_;
                                                    if (_e1211 < 0f) {
                                                        phi_1466_ = 0u;
                                                    } else {
                                                        phi_1466_ = 2u;
                                                    }
                                                    let _e1294 = phi_1466_;
                                                    if (_e1221 < 0f) {
                                                        phi_1471_ = 0u;
                                                    } else {
                                                        phi_1471_ = 4u;
                                                    }
                                                    let _e1297 = phi_1471_;
                                                    let _e1299 = ((_e1291 | _e1294) | _e1297);
                                                    let _e1300 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1061, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1300.first[0], _e1300.first[1], _e1300.first[2], _e1300.first[3], _e1300.first[4], _e1300.first[5], _e1300.first[6], _e1300.first[7], _e1300.first[8], _e1300.first[9], _e1300.first[10], _e1300.first[11], _e1300.first[12], _e1300.first[13], _e1300.first[14], _e1300.first[15], _e1300.first[16], _e1300.first[17], _e1300.first[18], _e1300.first[19], _e1300.first[20], _e1300.first[21], _e1300.first[22], _e1300.first[23], _e1300.first[24], _e1300.first[25], _e1300.first[26], _e1300.first[27], _e1300.first[28], _e1300.first[29], _e1300.first[30], _e1300.first[31]), array<u32, 32>(_e1300.mask[0], _e1300.mask[1], _e1300.mask[2], _e1300.mask[3], _e1300.mask[4], _e1300.mask[5], _e1300.mask[6], _e1300.mask[7], _e1300.mask[8], _e1300.mask[9], _e1300.mask[10], _e1300.mask[11], _e1300.mask[12], _e1300.mask[13], _e1300.mask[14], _e1300.mask[15], _e1300.mask[16], _e1300.mask[17], _e1300.mask[18], _e1300.mask[19], _e1300.mask[20], _e1300.mask[21], _e1300.mask[22], _e1300.mask[23], _e1300.mask[24], _e1300.mask[25], _e1300.mask[26], _e1300.mask[27], _e1300.mask[28], _e1300.mask[29], _e1300.mask[30], _e1300.mask[31]), _e1300.len, _e1300.group, _e1300.group_mask);
                                                    let _e1374 = local.group_mask;
                                                    if ((_e1374 & 4278190080u) == 0u) {
                                                        let _e1378 = local.len;
                                                        if (_e1378 == 0u) {
                                                            phi_1585_ = false;
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
                                                            phi_1585_ = true;
                                                        }
                                                        let _e1401 = phi_1585_;
                                                        phi_1586_ = _e1401;
                                                    } else {
                                                        phi_1586_ = true;
                                                    }
                                                    let _e1403 = phi_1586_;
                                                    if _e1403 {
                                                        let _e1405 = local.group_mask;
                                                        let _e1411 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1405)), 32u, (_e1405 == 0u)));
                                                        let _e1415 = local.group_mask;
                                                        let _e1429 = local.group_mask;
                                                        local.group_mask = (_e1429 & ~((1u << bitcast<u32>((_e1411 & 31u)))));
                                                        let _e1432 = local.group;
                                                        phi_1617_ = (_e1432 + countOneBits(((_e1415 & ~((4294967295u << bitcast<u32>((((_e1411 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1617_ = 4294967295u;
                                                    }
                                                    let _e1435 = phi_1617_;
                                                    phi_1619_ = _e1435;
                                                    loop {
                                                        let _e1437 = phi_1619_;
                                                        if (_e1437 != 4294967295u) {
                                                            if (_e1437 < _e59) {
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
                                                            let _e1487 = ((bitcast<f32>(_e1474) - _e989) * _e1201);
                                                            let _e1488 = ((bitcast<f32>(_e1478) - _e1002) * _e1211);
                                                            let _e1489 = ((bitcast<f32>(_e1482) - _e1015) * _e1221);
                                                            let _e1497 = nodes.member[(0u + _e1437)].x;
                                                            if (_e1201 < 0f) {
                                                                let _e1508 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1514 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1508.unnamed.root, _e1497.w), _e1508.unnamed_1);
                                                                let _e1520 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1514.unnamed, lt_bvh_traverse_Tree(_e1497.x, _e1514.unnamed_1.first_primitive));
                                                                phi_1700_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1520.unnamed, lt_bvh_traverse_Tree(_e1520.unnamed_1.root, _e1497.y));
                                                            } else {
                                                                let _e1536 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1536.unnamed.root, _e1497.y), _e1536.unnamed_1);
                                                                let _e1548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1542.unnamed, lt_bvh_traverse_Tree(_e1497.z, _e1542.unnamed_1.first_primitive));
                                                                phi_1700_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1548.unnamed, lt_bvh_traverse_Tree(_e1548.unnamed_1.root, _e1497.w));
                                                            }
                                                            let _e1556 = phi_1700_;
                                                            let _e1566 = nodes.member[(0u + _e1437)].y;
                                                            if (_e1211 < 0f) {
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1577.unnamed.root, _e1566.w), _e1577.unnamed_1);
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1583.unnamed, lt_bvh_traverse_Tree(_e1566.x, _e1583.unnamed_1.first_primitive));
                                                                phi_1727_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1589.unnamed, lt_bvh_traverse_Tree(_e1589.unnamed_1.root, _e1566.y));
                                                            } else {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1605.unnamed.root, _e1566.y), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1566.z, _e1611.unnamed_1.first_primitive));
                                                                phi_1727_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1566.w));
                                                            }
                                                            let _e1625 = phi_1727_;
                                                            let _e1635 = nodes.member[(0u + _e1437)].z;
                                                            if (_e1221 < 0f) {
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1646.unnamed.root, _e1635.w), _e1646.unnamed_1);
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1652.unnamed, lt_bvh_traverse_Tree(_e1635.x, _e1652.unnamed_1.first_primitive));
                                                                phi_1754_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1658.unnamed, lt_bvh_traverse_Tree(_e1658.unnamed_1.root, _e1635.y));
                                                            } else {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1635.y), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1635.z, _e1680.unnamed_1.first_primitive));
                                                                phi_1754_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1635.w));
                                                            }
                                                            let _e1694 = phi_1754_;
                                                            phi_1760_ = 0u;
                                                            phi_1763_ = 0u;
                                                            loop {
                                                                let _e1704 = phi_1760_;
                                                                let _e1706 = phi_1763_;
                                                                local_5 = _e1706;
                                                                local_6 = _e1706;
                                                                local_7 = _e1706;
                                                                let _e1707 = (_e1704 < 8u);
                                                                if _e1707 {
                                                                    let _e1709 = (_e1704 >> bitcast<u32>(2i));
                                                                    let _e1710 = (_e1704 & 3u);
                                                                    if (_e1709 == 0u) {
                                                                        phi_1777_ = _e1556.unnamed.root;
                                                                    } else {
                                                                        phi_1777_ = _e1556.unnamed.first_primitive;
                                                                    }
                                                                    let _e1713 = phi_1777_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1787_ = _e1625.unnamed.root;
                                                                    } else {
                                                                        phi_1787_ = _e1625.unnamed.first_primitive;
                                                                    }
                                                                    let _e1722 = phi_1787_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1797_ = _e1694.unnamed.root;
                                                                    } else {
                                                                        phi_1797_ = _e1694.unnamed.first_primitive;
                                                                    }
                                                                    let _e1731 = phi_1797_;
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1713 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1249)), ((f32(((_e1722 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1250)));
                                                                    let _e1745 = core_intrinsics_maximum_number_nsz_f32_(_e1744, ((f32(((_e1731 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 - _e1251)));
                                                                    if (_e1709 == 0u) {
                                                                        phi_1815_ = _e1556.unnamed_1.root;
                                                                    } else {
                                                                        phi_1815_ = _e1556.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1748 = phi_1815_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1825_ = _e1625.unnamed_1.root;
                                                                    } else {
                                                                        phi_1825_ = _e1625.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1757 = phi_1825_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1835_ = _e1694.unnamed_1.root;
                                                                    } else {
                                                                        phi_1835_ = _e1694.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1766 = phi_1835_;
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1748 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1249)), ((f32(((_e1757 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1250)));
                                                                    let _e1780 = core_intrinsics_minimum_number_nsz_f32_(_e1779, ((f32(((_e1766 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 + _e1251)));
                                                                    if (_e1745 <= _e1780) {
                                                                        if (_e1745 <= _e115) {
                                                                            if (_e1780 >= 0f) {
                                                                                if (_e1709 == 0u) {
                                                                                    let _e1787 = nodes.member[(0u + _e1437)].links[2u];
                                                                                    phi_1871_ = _e1787;
                                                                                } else {
                                                                                    let _e1790 = nodes.member[(0u + _e1437)].links[3u];
                                                                                    phi_1871_ = _e1790;
                                                                                }
                                                                                let _e1792 = phi_1871_;
                                                                                let _e1797 = ((_e1792 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u);
                                                                                let _e1798 = (_e1797 & 31u);
                                                                                if (_e1798 >= 24u) {
                                                                                    phi_1884_ = (24u + ((_e1798 - 24u) ^ _e1299));
                                                                                } else {
                                                                                    phi_1884_ = _e1798;
                                                                                }
                                                                                let _e1804 = phi_1884_;
                                                                                phi_1889_ = (_e1706 | ((_e1797 >> bitcast<u32>(5i)) << bitcast<u32>((_e1804 & 31u))));
                                                                            } else {
                                                                                phi_1889_ = _e1706;
                                                                            }
                                                                            let _e1812 = phi_1889_;
                                                                            phi_1890_ = _e1812;
                                                                        } else {
                                                                            phi_1890_ = _e1706;
                                                                        }
                                                                        let _e1814 = phi_1890_;
                                                                        phi_1891_ = _e1814;
                                                                    } else {
                                                                        phi_1891_ = _e1706;
                                                                    }
                                                                    let _e1816 = phi_1891_;
                                                                    phi_1761_ = (_e1704 + 1u);
                                                                    phi_1764_ = _e1816;
                                                                } else {
                                                                    phi_1761_ = u32();
                                                                    phi_1764_ = u32();
                                                                }
                                                                let _e1819 = phi_1761_;
                                                                let _e1821 = phi_1764_;
                                                                continue;
                                                                continuing {
                                                                    phi_1760_ = _e1819;
                                                                    phi_1763_ = _e1821;
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
                                                            phi_1949_ = (_e1870 & 16777215u);
                                                            loop {
                                                                let _e1873 = phi_1949_;
                                                                let _e1874 = (_e1873 == 0u);
                                                                local_8 = _e1874;
                                                                local_14 = _e1874;
                                                                if _e1874 {
                                                                    phi_1950_ = u32();
                                                                    phi_2442_ = false;
                                                                    phi_2443_ = false;
                                                                    phi_2444_ = false;
                                                                } else {
                                                                    let _e1877 = nodes.member[(0u + _e1437)].links[1u];
                                                                    let _e1882 = ((_e1063 + _e1877) + select(firstTrailingBit(_e1873), 32u, (_e1873 == 0u)));
                                                                    if (_e1882 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1889 = triangles.member[(0u + _e1882)].v0_;
                                                                    let _e1891 = (_e1889.x - _e989);
                                                                    let _e1893 = (_e1889.y - _e1002);
                                                                    let _e1895 = (_e1889.z - _e1015);
                                                                    if (_e1272 == 0u) {
                                                                        phi_1995_ = vec3<f32>(_e1893, _e1895, _e1891);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_1994_ = vec3<f32>(_e1895, _e1891, _e1893);
                                                                        } else {
                                                                            phi_1994_ = (_e1889 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1903 = phi_1994_;
                                                                        phi_1995_ = _e1903;
                                                                    }
                                                                    let _e1905 = phi_1995_;
                                                                    let _e1909 = (_e1905.x - (_e1283 * _e1905.z));
                                                                    let _e1913 = (_e1905.y - (_e1286 * _e1905.z));
                                                                    let _e1917 = triangles.member[(0u + _e1882)].v1_;
                                                                    let _e1919 = (_e1917.x - _e989);
                                                                    let _e1921 = (_e1917.y - _e1002);
                                                                    let _e1923 = (_e1917.z - _e1015);
                                                                    if (_e1272 == 0u) {
                                                                        phi_2027_ = vec3<f32>(_e1921, _e1923, _e1919);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2026_ = vec3<f32>(_e1923, _e1919, _e1921);
                                                                        } else {
                                                                            phi_2026_ = (_e1917 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1931 = phi_2026_;
                                                                        phi_2027_ = _e1931;
                                                                    }
                                                                    let _e1933 = phi_2027_;
                                                                    let _e1937 = (_e1933.x - (_e1283 * _e1933.z));
                                                                    let _e1941 = (_e1933.y - (_e1286 * _e1933.z));
                                                                    let _e1945 = triangles.member[(0u + _e1882)].v2_;
                                                                    let _e1947 = (_e1945.x - _e989);
                                                                    let _e1949 = (_e1945.y - _e1002);
                                                                    let _e1951 = (_e1945.z - _e1015);
                                                                    if (_e1272 == 0u) {
                                                                        phi_2059_ = vec3<f32>(_e1949, _e1951, _e1947);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2058_ = vec3<f32>(_e1951, _e1947, _e1949);
                                                                        } else {
                                                                            phi_2058_ = (_e1945 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1959 = phi_2058_;
                                                                        phi_2059_ = _e1959;
                                                                    }
                                                                    let _e1961 = phi_2059_;
                                                                    let _e1965 = (_e1961.x - (_e1283 * _e1961.z));
                                                                    let _e1969 = (_e1961.y - (_e1286 * _e1961.z));
                                                                    if (_e1937 < _e1965) {
                                                                        phi_2080_ = true;
                                                                    } else {
                                                                        if (_e1937 == _e1965) {
                                                                            phi_2079_ = (_e1941 < _e1969);
                                                                        } else {
                                                                            phi_2079_ = false;
                                                                        }
                                                                        let _e1976 = phi_2079_;
                                                                        phi_2080_ = _e1976;
                                                                    }
                                                                    let _e1978 = phi_2080_;
                                                                    if _e1978 {
                                                                        phi_2084_ = _e1969;
                                                                        phi_2085_ = _e1965;
                                                                        phi_2086_ = _e1941;
                                                                        phi_2087_ = _e1937;
                                                                    } else {
                                                                        phi_2084_ = _e1941;
                                                                        phi_2085_ = _e1937;
                                                                        phi_2086_ = _e1969;
                                                                        phi_2087_ = _e1965;
                                                                    }
                                                                    let _e1980 = phi_2084_;
                                                                    let _e1982 = phi_2085_;
                                                                    let _e1984 = phi_2086_;
                                                                    let _e1986 = phi_2087_;
                                                                    let _e1989 = ((_e1986 * _e1980) - (_e1984 * _e1982));
                                                                    if _e1978 {
                                                                        phi_2095_ = -(_e1989);
                                                                    } else {
                                                                        phi_2095_ = _e1989;
                                                                    }
                                                                    let _e1992 = phi_2095_;
                                                                    if (_e1965 < _e1909) {
                                                                        phi_2106_ = true;
                                                                    } else {
                                                                        if (_e1965 == _e1909) {
                                                                            phi_2105_ = (_e1969 < _e1913);
                                                                        } else {
                                                                            phi_2105_ = false;
                                                                        }
                                                                        let _e1997 = phi_2105_;
                                                                        phi_2106_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2106_;
                                                                    if _e1999 {
                                                                        phi_2110_ = _e1913;
                                                                        phi_2111_ = _e1909;
                                                                        phi_2112_ = _e1969;
                                                                        phi_2113_ = _e1965;
                                                                    } else {
                                                                        phi_2110_ = _e1969;
                                                                        phi_2111_ = _e1965;
                                                                        phi_2112_ = _e1913;
                                                                        phi_2113_ = _e1909;
                                                                    }
                                                                    let _e2001 = phi_2110_;
                                                                    let _e2003 = phi_2111_;
                                                                    let _e2005 = phi_2112_;
                                                                    let _e2007 = phi_2113_;
                                                                    let _e2010 = ((_e2007 * _e2001) - (_e2005 * _e2003));
                                                                    if _e1999 {
                                                                        phi_2121_ = -(_e2010);
                                                                    } else {
                                                                        phi_2121_ = _e2010;
                                                                    }
                                                                    let _e2013 = phi_2121_;
                                                                    if (_e1909 < _e1937) {
                                                                        phi_2132_ = true;
                                                                    } else {
                                                                        if (_e1909 == _e1937) {
                                                                            phi_2131_ = (_e1913 < _e1941);
                                                                        } else {
                                                                            phi_2131_ = false;
                                                                        }
                                                                        let _e2018 = phi_2131_;
                                                                        phi_2132_ = _e2018;
                                                                    }
                                                                    let _e2020 = phi_2132_;
                                                                    if _e2020 {
                                                                        phi_2136_ = _e1941;
                                                                        phi_2137_ = _e1937;
                                                                        phi_2138_ = _e1913;
                                                                        phi_2139_ = _e1909;
                                                                    } else {
                                                                        phi_2136_ = _e1913;
                                                                        phi_2137_ = _e1909;
                                                                        phi_2138_ = _e1941;
                                                                        phi_2139_ = _e1937;
                                                                    }
                                                                    let _e2022 = phi_2136_;
                                                                    let _e2024 = phi_2137_;
                                                                    let _e2026 = phi_2138_;
                                                                    let _e2028 = phi_2139_;
                                                                    let _e2031 = ((_e2028 * _e2022) - (_e2026 * _e2024));
                                                                    if _e2020 {
                                                                        phi_2147_ = -(_e2031);
                                                                    } else {
                                                                        phi_2147_ = _e2031;
                                                                    }
                                                                    let _e2034 = phi_2147_;
                                                                    if (_e1992 >= 0f) {
                                                                        if (_e2013 >= 0f) {
                                                                            if (_e2034 >= 0f) {
                                                                                phi_2162_ = ((_e1992 + _e2013) + _e2034);
                                                                                phi_2163_ = false;
                                                                            } else {
                                                                                phi_2162_ = f32();
                                                                                phi_2163_ = true;
                                                                            }
                                                                            let _e2041 = phi_2162_;
                                                                            let _e2043 = phi_2163_;
                                                                            phi_2164_ = _e2041;
                                                                            phi_2165_ = _e2043;
                                                                        } else {
                                                                            phi_2164_ = f32();
                                                                            phi_2165_ = true;
                                                                        }
                                                                        let _e2045 = phi_2164_;
                                                                        let _e2047 = phi_2165_;
                                                                        phi_2166_ = _e2045;
                                                                        phi_2167_ = _e2047;
                                                                    } else {
                                                                        phi_2166_ = f32();
                                                                        phi_2167_ = true;
                                                                    }
                                                                    let _e2049 = phi_2166_;
                                                                    let _e2051 = phi_2167_;
                                                                    if _e2051 {
                                                                        if (_e1992 <= 0f) {
                                                                            if (_e2013 <= 0f) {
                                                                                let _e2054 = (_e2034 <= 0f);
                                                                                if _e2054 {
                                                                                }
                                                                                phi_2185_ = ((_e1992 + _e2013) + _e2034);
                                                                                phi_2186_ = false;
                                                                                phi_2187_ = _e2054;
                                                                            } else {
                                                                                phi_2185_ = f32();
                                                                                phi_2186_ = true;
                                                                                phi_2187_ = false;
                                                                            }
                                                                            let _e2058 = phi_2185_;
                                                                            let _e2060 = phi_2186_;
                                                                            let _e2062 = phi_2187_;
                                                                            phi_2188_ = _e2058;
                                                                            phi_2189_ = _e2060;
                                                                            phi_2190_ = _e2062;
                                                                        } else {
                                                                            phi_2188_ = f32();
                                                                            phi_2189_ = true;
                                                                            phi_2190_ = false;
                                                                        }
                                                                        let _e2064 = phi_2188_;
                                                                        let _e2066 = phi_2189_;
                                                                        let _e2068 = phi_2190_;
                                                                        if _e2066 {
                                                                            phi_2194_ = false;
                                                                        } else {
                                                                            phi_2194_ = _e2068;
                                                                        }
                                                                        let _e2070 = phi_2194_;
                                                                        phi_2195_ = _e2064;
                                                                        phi_2196_ = _e2070;
                                                                    } else {
                                                                        phi_2195_ = _e2049;
                                                                        phi_2196_ = true;
                                                                    }
                                                                    let _e2072 = phi_2195_;
                                                                    let _e2074 = phi_2196_;
                                                                    if _e2074 {
                                                                        let _e2075 = (_e2072 == 0f);
                                                                        if _e2075 {
                                                                            phi_2394_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2081 = ((((_e1992 * (_e1288 * _e1905.z)) + (_e2013 * (_e1288 * _e1933.z))) + (_e2034 * (_e1288 * _e1961.z))) / _e2072);
                                                                            let _e2083 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2085 = triangles.member[(0u + _e1882)].v1_;
                                                                            if (_e2083.x < _e2085.x) {
                                                                                phi_2222_ = _e2083.x;
                                                                            } else {
                                                                                phi_2222_ = _e2085.x;
                                                                            }
                                                                            let _e2092 = phi_2222_;
                                                                            if (_e2083.y < _e2085.y) {
                                                                                phi_2231_ = _e2083.y;
                                                                            } else {
                                                                                phi_2231_ = _e2085.y;
                                                                            }
                                                                            let _e2099 = phi_2231_;
                                                                            if (_e2083.z < _e2085.z) {
                                                                                phi_2240_ = _e2083.z;
                                                                            } else {
                                                                                phi_2240_ = _e2085.z;
                                                                            }
                                                                            let _e2106 = phi_2240_;
                                                                            let _e2108 = triangles.member[(0u + _e1882)].v2_;
                                                                            if (_e2092 < _e2108.x) {
                                                                                phi_2249_ = _e2092;
                                                                            } else {
                                                                                phi_2249_ = _e2108.x;
                                                                            }
                                                                            let _e2113 = phi_2249_;
                                                                            if (_e2099 < _e2108.y) {
                                                                                phi_2256_ = _e2099;
                                                                            } else {
                                                                                phi_2256_ = _e2108.y;
                                                                            }
                                                                            let _e2118 = phi_2256_;
                                                                            if (_e2106 < _e2108.z) {
                                                                                phi_2263_ = _e2106;
                                                                            } else {
                                                                                phi_2263_ = _e2108.z;
                                                                            }
                                                                            let _e2123 = phi_2263_;
                                                                            let _e2125 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2127 = triangles.member[(0u + _e1882)].v1_;
                                                                            if (_e2125.x > _e2127.x) {
                                                                                phi_2276_ = _e2125.x;
                                                                            } else {
                                                                                phi_2276_ = _e2127.x;
                                                                            }
                                                                            let _e2134 = phi_2276_;
                                                                            if (_e2125.y > _e2127.y) {
                                                                                phi_2285_ = _e2125.y;
                                                                            } else {
                                                                                phi_2285_ = _e2127.y;
                                                                            }
                                                                            let _e2141 = phi_2285_;
                                                                            if (_e2125.z > _e2127.z) {
                                                                                phi_2294_ = _e2125.z;
                                                                            } else {
                                                                                phi_2294_ = _e2127.z;
                                                                            }
                                                                            let _e2148 = phi_2294_;
                                                                            let _e2150 = triangles.member[(0u + _e1882)].v2_;
                                                                            if (_e2134 > _e2150.x) {
                                                                                phi_2303_ = _e2134;
                                                                            } else {
                                                                                phi_2303_ = _e2150.x;
                                                                            }
                                                                            let _e2155 = phi_2303_;
                                                                            if (_e2141 > _e2150.y) {
                                                                                phi_2310_ = _e2141;
                                                                            } else {
                                                                                phi_2310_ = _e2150.y;
                                                                            }
                                                                            let _e2160 = phi_2310_;
                                                                            if (_e2148 > _e2150.z) {
                                                                                phi_2317_ = _e2148;
                                                                            } else {
                                                                                phi_2317_ = _e2150.z;
                                                                            }
                                                                            let _e2165 = phi_2317_;
                                                                            let _e2169 = ((_e2113 - _e989) * _e1201);
                                                                            let _e2170 = ((_e2118 - _e1002) * _e1211);
                                                                            let _e2171 = ((_e2123 - _e1015) * _e1221);
                                                                            let _e2175 = ((_e2155 - _e989) * _e1201);
                                                                            let _e2176 = ((_e2160 - _e1002) * _e1211);
                                                                            let _e2177 = ((_e2165 - _e1015) * _e1221);
                                                                            if (_e2169 < _e2175) {
                                                                                phi_2334_ = _e2169;
                                                                            } else {
                                                                                phi_2334_ = _e2175;
                                                                            }
                                                                            let _e2180 = phi_2334_;
                                                                            if (_e2170 < _e2176) {
                                                                                phi_2339_ = _e2170;
                                                                            } else {
                                                                                phi_2339_ = _e2176;
                                                                            }
                                                                            let _e2183 = phi_2339_;
                                                                            if (_e2171 < _e2177) {
                                                                                phi_2344_ = _e2171;
                                                                            } else {
                                                                                phi_2344_ = _e2177;
                                                                            }
                                                                            let _e2186 = phi_2344_;
                                                                            if (_e2169 > _e2175) {
                                                                                phi_2352_ = _e2169;
                                                                            } else {
                                                                                phi_2352_ = _e2175;
                                                                            }
                                                                            let _e2192 = phi_2352_;
                                                                            if (_e2170 > _e2176) {
                                                                                phi_2357_ = _e2170;
                                                                            } else {
                                                                                phi_2357_ = _e2176;
                                                                            }
                                                                            let _e2195 = phi_2357_;
                                                                            if (_e2171 > _e2177) {
                                                                                phi_2362_ = _e2171;
                                                                            } else {
                                                                                phi_2362_ = _e2177;
                                                                            }
                                                                            let _e2198 = phi_2362_;
                                                                            let _e2202 = core_intrinsics_maximum_number_nsz_f32_((_e2180 - _e1256), (_e2183 - _e1257));
                                                                            let _e2203 = core_intrinsics_maximum_number_nsz_f32_(_e2202, (_e2186 - _e1258));
                                                                            let _e2204 = core_intrinsics_minimum_number_nsz_f32_((_e2192 + _e1256), (_e2195 + _e1257));
                                                                            let _e2205 = core_intrinsics_minimum_number_nsz_f32_(_e2204, (_e2198 + _e1258));
                                                                            if (_e2203 > _e970) {
                                                                                phi_2374_ = _e2203;
                                                                            } else {
                                                                                phi_2374_ = _e970;
                                                                            }
                                                                            let _e2208 = phi_2374_;
                                                                            if (_e2205 < _e972) {
                                                                                phi_2379_ = _e2205;
                                                                            } else {
                                                                                phi_2379_ = _e972;
                                                                            }
                                                                            let _e2211 = phi_2379_;
                                                                            if (_e2081 < _e2208) {
                                                                                phi_2384_ = _e2208;
                                                                            } else {
                                                                                phi_2384_ = _e2081;
                                                                            }
                                                                            let _e2214 = phi_2384_;
                                                                            if (_e2214 > _e2211) {
                                                                                phi_2389_ = _e2211;
                                                                            } else {
                                                                                phi_2389_ = _e2214;
                                                                            }
                                                                            let _e2217 = phi_2389_;
                                                                            phi_2394_ = lt_bvh_triangle_Intersection(_e2217, (_e2013 / _e2072), (_e2034 / _e2072), (_e2208 <= _e2211));
                                                                        }
                                                                        let _e2223 = phi_2394_;
                                                                        phi_2395_ = _e2223;
                                                                        phi_2396_ = _e2075;
                                                                    } else {
                                                                        phi_2395_ = lt_bvh_triangle_Intersection();
                                                                        phi_2396_ = true;
                                                                    }
                                                                    let _e2225 = phi_2395_;
                                                                    let _e2227 = phi_2396_;
                                                                    if _e2227 {
                                                                        phi_2400_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2400_ = _e2225;
                                                                    }
                                                                    let _e2229 = phi_2400_;
                                                                    if _e2229.is_hit {
                                                                        if (_e2229.t > 0f) {
                                                                            if (_e2229.t < _e115) {
                                                                                let _e2236 = triangles.member[(0u + _e1882)].i0_;
                                                                                let _e2238 = ((_e2236 & 2147483648u) == 0u);
                                                                                if _e2238 {
                                                                                    phi_2426_ = false;
                                                                                    phi_2427_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2425_ = false;
                                                                                    } else {
                                                                                        phi_2425_ = true;
                                                                                    }
                                                                                    let _e2240 = phi_2425_;
                                                                                    phi_2426_ = _e2240;
                                                                                    phi_2427_ = true;
                                                                                }
                                                                                let _e2242 = phi_2426_;
                                                                                let _e2244 = phi_2427_;
                                                                                phi_2428_ = _e2242;
                                                                                phi_2429_ = _e2238;
                                                                                phi_2430_ = _e2244;
                                                                            } else {
                                                                                phi_2428_ = true;
                                                                                phi_2429_ = false;
                                                                                phi_2430_ = false;
                                                                            }
                                                                            let _e2246 = phi_2428_;
                                                                            let _e2248 = phi_2429_;
                                                                            let _e2250 = phi_2430_;
                                                                            phi_2431_ = _e2246;
                                                                            phi_2432_ = _e2248;
                                                                            phi_2433_ = _e2250;
                                                                        } else {
                                                                            phi_2431_ = true;
                                                                            phi_2432_ = false;
                                                                            phi_2433_ = false;
                                                                        }
                                                                        let _e2252 = phi_2431_;
                                                                        let _e2254 = phi_2432_;
                                                                        let _e2256 = phi_2433_;
                                                                        phi_2434_ = _e2252;
                                                                        phi_2435_ = _e2254;
                                                                        phi_2436_ = _e2256;
                                                                    } else {
                                                                        phi_2434_ = true;
                                                                        phi_2435_ = false;
                                                                        phi_2436_ = false;
                                                                    }
                                                                    let _e2258 = phi_2434_;
                                                                    let _e2260 = phi_2435_;
                                                                    let _e2262 = phi_2436_;
                                                                    if _e2258 {
                                                                        phi_2440_ = false;
                                                                        phi_2441_ = false;
                                                                    } else {
                                                                        phi_2440_ = _e2260;
                                                                        phi_2441_ = _e2262;
                                                                    }
                                                                    let _e2264 = phi_2440_;
                                                                    let _e2266 = phi_2441_;
                                                                    phi_1950_ = (_e1873 & (_e1873 - 1u));
                                                                    phi_2442_ = _e2258;
                                                                    phi_2443_ = _e2264;
                                                                    phi_2444_ = _e2266;
                                                                }
                                                                let _e2268 = phi_1950_;
                                                                let _e2270 = phi_2442_;
                                                                let _e2272 = phi_2443_;
                                                                let _e2274 = phi_2444_;
                                                                local_12 = _e2272;
                                                                local_13 = _e2274;
                                                                continue;
                                                                continuing {
                                                                    phi_1949_ = _e2268;
                                                                    break if !(_e2270);
                                                                }
                                                            }
                                                            let _e2277 = local_8;
                                                            if _e2277 {
                                                                let _e2279 = local.group_mask;
                                                                if ((_e2279 & 4278190080u) == 0u) {
                                                                    let _e2283 = local.len;
                                                                    if (_e2283 == 0u) {
                                                                        phi_2486_ = false;
                                                                    } else {
                                                                        let _e2287 = local.len;
                                                                        local.len = (_e2287 - 1u);
                                                                        let _e2290 = local.len;
                                                                        if (_e2290 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2295 = local.first[(0u + _e2290)];
                                                                        local.group = _e2295;
                                                                        let _e2298 = local.len;
                                                                        if (_e2298 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2303 = local.mask[(0u + _e2298)];
                                                                        local.group_mask = _e2303;
                                                                        phi_2486_ = true;
                                                                    }
                                                                    let _e2306 = phi_2486_;
                                                                    phi_2487_ = _e2306;
                                                                } else {
                                                                    phi_2487_ = true;
                                                                }
                                                                let _e2308 = phi_2487_;
                                                                if _e2308 {
                                                                    let _e2310 = local.group_mask;
                                                                    let _e2316 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2310)), 32u, (_e2310 == 0u)));
                                                                    let _e2320 = local.group_mask;
                                                                    let _e2334 = local.group_mask;
                                                                    local.group_mask = (_e2334 & ~((1u << bitcast<u32>((_e2316 & 31u)))));
                                                                    let _e2337 = local.group;
                                                                    phi_2518_ = (_e2337 + countOneBits(((_e2320 & ~((4294967295u << bitcast<u32>((((_e2316 - 24u) ^ _e1299) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2518_ = 4294967295u;
                                                                }
                                                                let _e2340 = phi_2518_;
                                                                phi_2519_ = _e2340;
                                                                phi_2520_ = false;
                                                                phi_2521_ = false;
                                                            } else {
                                                                phi_2519_ = u32();
                                                                let _e2710 = local_12;
                                                                phi_2520_ = _e2710;
                                                                let _e2713 = local_13;
                                                                phi_2521_ = _e2713;
                                                            }
                                                            let _e2342 = phi_2519_;
                                                            let _e2344 = phi_2520_;
                                                            let _e2346 = phi_2521_;
                                                            phi_1620_ = _e2342;
                                                            let _e2717 = local_14;
                                                            phi_2522_ = _e2717;
                                                            phi_2523_ = false;
                                                            phi_2524_ = _e2344;
                                                            phi_2525_ = _e2346;
                                                        } else {
                                                            phi_1620_ = u32();
                                                            phi_2522_ = false;
                                                            phi_2523_ = true;
                                                            phi_2524_ = false;
                                                            phi_2525_ = false;
                                                        }
                                                        let _e2348 = phi_1620_;
                                                        let _e2350 = phi_2522_;
                                                        let _e2352 = phi_2523_;
                                                        let _e2354 = phi_2524_;
                                                        let _e2356 = phi_2525_;
                                                        local_9 = _e2352;
                                                        local_15 = _e2354;
                                                        local_16 = _e2356;
                                                        continue;
                                                        continuing {
                                                            phi_1619_ = _e2348;
                                                            break if !(_e2350);
                                                        }
                                                    }
                                                    let _e2359 = local_9;
                                                    if _e2359 {
                                                        phi_2529_ = false;
                                                        phi_2530_ = false;
                                                    } else {
                                                        let _e2724 = local_15;
                                                        phi_2529_ = _e2724;
                                                        let _e2727 = local_16;
                                                        phi_2530_ = _e2727;
                                                    }
                                                    let _e2361 = phi_2529_;
                                                    let _e2363 = phi_2530_;
                                                    if _e2361 {
                                                        phi_2534_ = true;
                                                    } else {
                                                        phi_2534_ = _e2363;
                                                    }
                                                    let _e2365 = phi_2534_;
                                                    if _e2365 {
                                                        phi_2538_ = true;
                                                    } else {
                                                        phi_2538_ = false;
                                                    }
                                                    let _e2367 = phi_2538_;
                                                    phi_2539_ = _e2367;
                                                }
                                                let _e2369 = phi_2539_;
                                                phi_2540_ = _e2369;
                                                phi_2541_ = _e1125;
                                            } else {
                                                phi_2540_ = bool();
                                                phi_2541_ = true;
                                            }
                                            let _e2371 = phi_2540_;
                                            let _e2373 = phi_2541_;
                                            if _e2373 {
                                                phi_2545_ = false;
                                            } else {
                                                phi_2545_ = _e2371;
                                            }
                                            let _e2375 = phi_2545_;
                                            if _e2375 {
                                                phi_2549_ = false;
                                            } else {
                                                phi_2549_ = true;
                                            }
                                            let _e2377 = phi_2549_;
                                            phi_2550_ = _e2377;
                                        } else {
                                            phi_2550_ = true;
                                        }
                                        let _e2379 = phi_2550_;
                                        phi_2551_ = _e2379;
                                    } else {
                                        phi_2551_ = true;
                                    }
                                    let _e2381 = phi_2551_;
                                    phi_2552_ = _e2381;
                                } else {
                                    phi_2552_ = true;
                                }
                                let _e2383 = phi_2552_;
                                if _e2383 {
                                }
                                phi_1011_ = (_e909 & (_e909 - 1u));
                                phi_2556_ = _e2383;
                            }
                            let _e2385 = phi_1011_;
                            let _e2387 = phi_2556_;
                            continue;
                            continuing {
                                phi_1010_ = _e2385;
                                break if !(_e2387);
                            }
                        }
                        let _e2390 = local_10;
                        if _e2390 {
                            let _e2392 = local_1.group_mask;
                            if ((_e2392 & 4278190080u) == 0u) {
                                let _e2396 = local_1.len;
                                if (_e2396 == 0u) {
                                    phi_2598_ = false;
                                } else {
                                    let _e2400 = local_1.len;
                                    local_1.len = (_e2400 - 1u);
                                    let _e2403 = local_1.len;
                                    if (_e2403 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2408 = local_1.first[(0u + _e2403)];
                                    local_1.group = _e2408;
                                    let _e2411 = local_1.len;
                                    if (_e2411 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2416 = local_1.mask[(0u + _e2411)];
                                    local_1.group_mask = _e2416;
                                    phi_2598_ = true;
                                }
                                let _e2419 = phi_2598_;
                                phi_2599_ = _e2419;
                            } else {
                                phi_2599_ = true;
                            }
                            let _e2421 = phi_2599_;
                            if _e2421 {
                                let _e2423 = local_1.group_mask;
                                let _e2429 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2423)), 32u, (_e2423 == 0u)));
                                let _e2433 = local_1.group_mask;
                                let _e2447 = local_1.group_mask;
                                local_1.group_mask = (_e2447 & ~((1u << bitcast<u32>((_e2429 & 31u)))));
                                let _e2450 = local_1.group;
                                phi_2630_ = (_e2450 + countOneBits(((_e2433 & ~((4294967295u << bitcast<u32>((((_e2429 - 24u) ^ _e335) & 31u))))) & 255u)));
                            } else {
                                phi_2630_ = 4294967295u;
                            }
                            let _e2453 = phi_2630_;
                            phi_2631_ = _e2453;
                        } else {
                            phi_2631_ = u32();
                        }
                        let _e2455 = phi_2631_;
                        phi_681_ = _e2455;
                        let _e2748 = local_17;
                        phi_2632_ = _e2748;
                        phi_2633_ = false;
                    } else {
                        phi_681_ = u32();
                        phi_2632_ = false;
                        phi_2633_ = true;
                    }
                    let _e2457 = phi_681_;
                    let _e2459 = phi_2632_;
                    let _e2461 = phi_2633_;
                    local_11 = _e2461;
                    continue;
                    continuing {
                        phi_680_ = _e2457;
                        break if !(_e2459);
                    }
                }
                let _e2464 = local_11;
                if _e2464 {
                    phi_2637_ = false;
                } else {
                    phi_2637_ = true;
                }
                let _e2466 = phi_2637_;
                if _e2466 {
                    phi_2641_ = true;
                } else {
                    phi_2641_ = false;
                }
                let _e2468 = phi_2641_;
                phi_2642_ = _e2468;
            }
            let _e2470 = phi_2642_;
            phi_2643_ = _e2470;
            phi_2644_ = _e182;
        } else {
            phi_2643_ = bool();
            phi_2644_ = true;
        }
        let _e2472 = phi_2643_;
        let _e2474 = phi_2644_;
        if _e2474 {
            phi_2648_ = false;
        } else {
            phi_2648_ = _e2472;
        }
        let _e2476 = phi_2648_;
        if _e2476 {
            phi_2652_ = 0f;
        } else {
            phi_2652_ = 1f;
        }
        let _e2478 = phi_2652_;
        if (_e82 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e82)] = _e2478;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
