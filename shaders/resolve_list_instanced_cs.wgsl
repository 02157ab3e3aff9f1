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
    var phi_166_: bool;
    var phi_170_: f32;

    if (param != param) {
        phi_166_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_166_ = _e54;
    }
    let _e56 = phi_166_;
    if _e56 {
        phi_170_ = param_1;
    } else {
        phi_170_ = param;
    }
    let _e58 = phi_170_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_182_: bool;
    var phi_186_: f32;

    if (param_2 != param_2) {
        phi_182_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_182_ = _e54;
    }
    let _e56 = phi_182_;
    if _e56 {
        phi_186_ = param_3;
    } else {
        phi_186_ = param_2;
    }
    let _e58 = phi_186_;
    return _e58;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_doubt_slot_of(param_6: vec3<u32>) -> u32 {
    return ((param_6.y * 2097152u) + param_6.x);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_290_: f32;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_368_: bool;
    var phi_372_: bool;
    var phi_446_: f32;
    var phi_453_: f32;
    var phi_461_: f32;
    var phi_468_: f32;
    var phi_476_: f32;
    var phi_483_: f32;
    var phi_500_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_531_: u32;
    var phi_536_: u32;
    var phi_541_: u32;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_687_: u32;
    var phi_689_: u32;
    var phi_770_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_797_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_824_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_830_: u32;
    var phi_833_: u32;
    var phi_847_: u32;
    var phi_857_: u32;
    var phi_867_: u32;
    var phi_885_: u32;
    var phi_895_: u32;
    var phi_905_: u32;
    var phi_941_: u32;
    var phi_954_: u32;
    var phi_959_: u32;
    var phi_960_: u32;
    var phi_961_: u32;
    var phi_831_: u32;
    var phi_834_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1019_: u32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1087_: f32;
    var phi_1092_: f32;
    var phi_1097_: f32;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1271_: bool;
    var phi_1275_: bool;
    var phi_1345_: f32;
    var phi_1352_: f32;
    var phi_1359_: f32;
    var phi_1366_: f32;
    var phi_1373_: f32;
    var phi_1380_: f32;
    var phi_1397_: f32;
    var phi_1402_: f32;
    var phi_1407_: f32;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1444_: u32;
    var phi_1445_: u32;
    var phi_1456_: vec3<f32>;
    var phi_1457_: vec3<f32>;
    var phi_1470_: u32;
    var phi_1475_: u32;
    var phi_1480_: u32;
    var phi_1594_: bool;
    var phi_1595_: bool;
    var phi_1626_: u32;
    var phi_1628_: u32;
    var phi_1709_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1736_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1763_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1769_: u32;
    var phi_1772_: u32;
    var phi_1786_: u32;
    var phi_1796_: u32;
    var phi_1806_: u32;
    var phi_1824_: u32;
    var phi_1834_: u32;
    var phi_1844_: u32;
    var phi_1880_: u32;
    var phi_1893_: u32;
    var phi_1898_: u32;
    var phi_1899_: u32;
    var phi_1900_: u32;
    var phi_1770_: u32;
    var phi_1773_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1958_: u32;
    var phi_2003_: vec3<f32>;
    var phi_2004_: vec3<f32>;
    var phi_2035_: vec3<f32>;
    var phi_2036_: vec3<f32>;
    var phi_2067_: vec3<f32>;
    var phi_2068_: vec3<f32>;
    var phi_2088_: bool;
    var phi_2089_: bool;
    var phi_2093_: f32;
    var phi_2094_: f32;
    var phi_2095_: f32;
    var phi_2096_: f32;
    var phi_2104_: f32;
    var phi_2114_: bool;
    var phi_2115_: bool;
    var phi_2119_: f32;
    var phi_2120_: f32;
    var phi_2121_: f32;
    var phi_2122_: f32;
    var phi_2130_: f32;
    var phi_2140_: bool;
    var phi_2141_: bool;
    var phi_2145_: f32;
    var phi_2146_: f32;
    var phi_2147_: f32;
    var phi_2148_: f32;
    var phi_2156_: f32;
    var phi_2171_: f32;
    var phi_2172_: bool;
    var phi_2173_: f32;
    var phi_2174_: bool;
    var phi_2175_: f32;
    var phi_2176_: bool;
    var phi_2194_: f32;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2197_: f32;
    var phi_2198_: bool;
    var phi_2199_: bool;
    var phi_2203_: bool;
    var phi_2204_: f32;
    var phi_2205_: bool;
    var phi_2231_: f32;
    var phi_2240_: f32;
    var phi_2249_: f32;
    var phi_2258_: f32;
    var phi_2265_: f32;
    var phi_2272_: f32;
    var phi_2285_: f32;
    var phi_2294_: f32;
    var phi_2303_: f32;
    var phi_2312_: f32;
    var phi_2319_: f32;
    var phi_2326_: f32;
    var phi_2343_: f32;
    var phi_2348_: f32;
    var phi_2353_: f32;
    var phi_2361_: f32;
    var phi_2366_: f32;
    var phi_2371_: f32;
    var phi_2383_: f32;
    var phi_2388_: f32;
    var phi_2393_: f32;
    var phi_2398_: f32;
    var phi_2403_: lt_bvh_triangle_Intersection;
    var phi_2404_: lt_bvh_triangle_Intersection;
    var phi_2405_: bool;
    var phi_2409_: lt_bvh_triangle_Intersection;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2449_: bool;
    var phi_2450_: bool;
    var phi_1959_: u32;
    var phi_2451_: bool;
    var phi_2452_: bool;
    var phi_2453_: bool;
    var local_8: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2527_: u32;
    var phi_2528_: u32;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_1629_: u32;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var local_9: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2543_: bool;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2554_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_1020_: u32;
    var phi_2565_: bool;
    var local_10: bool;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2639_: u32;
    var phi_2640_: u32;
    var phi_690_: u32;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var local_11: bool;
    var phi_2646_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2657_: bool;
    var phi_2661_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e53 = id_1;
    let _e60 = arrayLength((&nodes.member));
    let _e69 = arrayLength((&list.member));
    let _e73 = lt_shaders_doubt_slot_of(_e53);
    if (3u < _e69) {
    } else {
        return;
    }
    let _e76 = list.member[3u];
    if (_e73 < _e76) {
        let _e78 = (_e73 + 4u);
        if (_e78 < _e69) {
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
            phi_290_ = 300000000000000000000000000000000000000f;
        } else {
            phi_290_ = 1f;
        }
        let _e115 = phi_290_;
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
                                    phi_342_ = bool();
                                    phi_343_ = true;
                                } else {
                                    let _e134 = (_e124 > 0f);
                                    if _e134 {
                                        phi_341_ = bool();
                                    } else {
                                        phi_341_ = (_e126 > 0f);
                                    }
                                    let _e137 = phi_341_;
                                    phi_342_ = _e137;
                                    phi_343_ = _e134;
                                }
                                let _e139 = phi_342_;
                                let _e141 = phi_343_;
                                if _e141 {
                                    phi_347_ = true;
                                } else {
                                    phi_347_ = _e139;
                                }
                                let _e143 = phi_347_;
                                phi_348_ = _e143;
                                phi_349_ = false;
                            } else {
                                phi_348_ = bool();
                                phi_349_ = true;
                            }
                            let _e145 = phi_348_;
                            let _e147 = phi_349_;
                            phi_350_ = _e145;
                            phi_351_ = false;
                            phi_352_ = _e147;
                        } else {
                            phi_350_ = bool();
                            phi_351_ = true;
                            phi_352_ = false;
                        }
                        let _e149 = phi_350_;
                        let _e151 = phi_351_;
                        let _e153 = phi_352_;
                        phi_353_ = _e149;
                        phi_354_ = _e151;
                        phi_355_ = _e153;
                    } else {
                        phi_353_ = bool();
                        phi_354_ = true;
                        phi_355_ = false;
                    }
                    let _e155 = phi_353_;
                    let _e157 = phi_354_;
                    let _e159 = phi_355_;
                    phi_356_ = _e155;
                    phi_357_ = _e157;
                    phi_358_ = _e159;
                } else {
                    phi_356_ = bool();
                    phi_357_ = true;
                    phi_358_ = false;
                }
                let _e161 = phi_356_;
                let _e163 = phi_357_;
                let _e165 = phi_358_;
                phi_359_ = _e161;
                phi_360_ = _e163;
                phi_361_ = _e165;
            } else {
                phi_359_ = bool();
                phi_360_ = true;
                phi_361_ = false;
            }
            let _e167 = phi_359_;
            let _e169 = phi_360_;
            let _e171 = phi_361_;
            phi_362_ = _e167;
            phi_363_ = _e169;
            phi_364_ = _e171;
        } else {
            phi_362_ = bool();
            phi_363_ = true;
            phi_364_ = false;
        }
        let _e173 = phi_362_;
        let _e175 = phi_363_;
        let _e177 = phi_364_;
        if _e175 {
            phi_368_ = true;
        } else {
            phi_368_ = _e177;
        }
        let _e179 = phi_368_;
        if _e179 {
            phi_372_ = false;
        } else {
            phi_372_ = _e173;
        }
        let _e181 = phi_372_;
        if _e181 {
            let _e182 = (_e84 >= _e60);
            if _e182 {
                phi_2651_ = bool();
            } else {
                if (_e84 < _e60) {
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
                    phi_446_ = _e251;
                } else {
                    phi_446_ = abs(_e117.direction.x);
                }
                let _e258 = phi_446_;
                if (_e117.direction.x < 0f) {
                    phi_453_ = (-1f / _e258);
                } else {
                    phi_453_ = (1f / _e258);
                }
                let _e263 = phi_453_;
                if (abs(_e117.direction.y) < _e251) {
                    phi_461_ = _e251;
                } else {
                    phi_461_ = abs(_e117.direction.y);
                }
                let _e270 = phi_461_;
                if (_e117.direction.y < 0f) {
                    phi_468_ = (-1f / _e270);
                } else {
                    phi_468_ = (1f / _e270);
                }
                let _e275 = phi_468_;
                if (abs(_e117.direction.z) < _e251) {
                    phi_476_ = _e251;
                } else {
                    phi_476_ = abs(_e117.direction.z);
                }
                let _e282 = phi_476_;
                if (_e117.direction.z < 0f) {
                    phi_483_ = (-1f / _e282);
                } else {
                    phi_483_ = (1f / _e282);
                }
                let _e287 = phi_483_;
                let _e291 = abs((bitcast<f32>(_e188) - _e105));
                let _e292 = abs((bitcast<f32>(_e192) - _e107));
                let _e293 = abs((bitcast<f32>(_e196) - _e109));
                let _e297 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e212 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105));
                let _e298 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e212 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e299 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e212 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                if (_e291 > _e297) {
                    phi_500_ = _e291;
                } else {
                    phi_500_ = _e297;
                }
                let _e302 = phi_500_;
                if (_e292 > _e298) {
                    phi_505_ = _e292;
                } else {
                    phi_505_ = _e298;
                }
                let _e305 = phi_505_;
                if (_e293 > _e299) {
                    phi_510_ = _e293;
                } else {
                    phi_510_ = _e299;
                }
                let _e308 = phi_510_;
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
                    phi_531_ = 0u;
                } else {
                    phi_531_ = 1u;
                }
                let _e327 = phi_531_;
                if (_e275 < 0f) {
                    phi_536_ = 0u;
                } else {
                    phi_536_ = 2u;
                }
                let _e330 = phi_536_;
                if (_e287 < 0f) {
                    phi_541_ = 0u;
                } else {
                    phi_541_ = 4u;
                }
                let _e333 = phi_541_;
                let _e335 = ((_e327 | _e330) | _e333);
                let _e336 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e84, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e336.first[0], _e336.first[1], _e336.first[2], _e336.first[3], _e336.first[4], _e336.first[5], _e336.first[6], _e336.first[7], _e336.first[8], _e336.first[9], _e336.first[10], _e336.first[11], _e336.first[12], _e336.first[13], _e336.first[14], _e336.first[15], _e336.first[16], _e336.first[17], _e336.first[18], _e336.first[19], _e336.first[20], _e336.first[21], _e336.first[22], _e336.first[23], _e336.first[24], _e336.first[25], _e336.first[26], _e336.first[27], _e336.first[28], _e336.first[29], _e336.first[30], _e336.first[31]), array<u32, 32>(_e336.mask[0], _e336.mask[1], _e336.mask[2], _e336.mask[3], _e336.mask[4], _e336.mask[5], _e336.mask[6], _e336.mask[7], _e336.mask[8], _e336.mask[9], _e336.mask[10], _e336.mask[11], _e336.mask[12], _e336.mask[13], _e336.mask[14], _e336.mask[15], _e336.mask[16], _e336.mask[17], _e336.mask[18], _e336.mask[19], _e336.mask[20], _e336.mask[21], _e336.mask[22], _e336.mask[23], _e336.mask[24], _e336.mask[25], _e336.mask[26], _e336.mask[27], _e336.mask[28], _e336.mask[29], _e336.mask[30], _e336.mask[31]), _e336.len, _e336.group, _e336.group_mask);
                let _e410 = local_1.group_mask;
                if ((_e410 & 4278190080u) == 0u) {
                    let _e414 = local_1.len;
                    if (_e414 == 0u) {
                        phi_655_ = false;
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
                        phi_655_ = true;
                    }
                    let _e437 = phi_655_;
                    phi_656_ = _e437;
                } else {
                    phi_656_ = true;
                }
                let _e439 = phi_656_;
                if _e439 {
                    let _e441 = local_1.group_mask;
                    let _e447 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e441)), 32u, (_e441 == 0u)));
                    let _e451 = local_1.group_mask;
                    let _e465 = local_1.group_mask;
                    local_1.group_mask = (_e465 & ~((1u << bitcast<u32>((_e447 & 31u)))));
                    let _e468 = local_1.group;
                    phi_687_ = (_e468 + countOneBits(((_e451 & ~((4294967295u << bitcast<u32>((((_e447 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_687_ = 4294967295u;
                }
                let _e471 = phi_687_;
                phi_689_ = _e471;
                loop {
                    let _e473 = phi_689_;
                    if (_e473 != 4294967295u) {
                        if (_e473 < _e60) {
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
                            phi_770_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e556.unnamed, lt_bvh_traverse_Tree(_e556.unnamed_1.root, _e533.y));
                        } else {
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e533.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e572.unnamed.root, _e533.y), _e572.unnamed_1);
                            let _e584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e533.z, _e578.unnamed_1.first_primitive));
                            phi_770_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e584.unnamed, lt_bvh_traverse_Tree(_e584.unnamed_1.root, _e533.w));
                        }
                        let _e592 = phi_770_;
                        let _e602 = nodes.member[(0u + _e473)].y;
                        if (_e275 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e613.unnamed.root, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_bvh_traverse_Tree(_e602.x, _e619.unnamed_1.first_primitive));
                            phi_797_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e625.unnamed_1.root, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e602.z, _e647.unnamed_1.first_primitive));
                            phi_797_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e602.w));
                        }
                        let _e661 = phi_797_;
                        let _e671 = nodes.member[(0u + _e473)].z;
                        if (_e287 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e682.unnamed.root, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_bvh_traverse_Tree(_e671.x, _e688.unnamed_1.first_primitive));
                            phi_824_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e694.unnamed_1.root, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e671.z, _e716.unnamed_1.first_primitive));
                            phi_824_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e671.w));
                        }
                        let _e730 = phi_824_;
                        phi_830_ = 0u;
                        phi_833_ = 0u;
                        loop {
                            let _e740 = phi_830_;
                            let _e742 = phi_833_;
                            local_2 = _e742;
                            local_3 = _e742;
                            local_4 = _e742;
                            let _e743 = (_e740 < 8u);
                            if _e743 {
                                let _e745 = (_e740 >> bitcast<u32>(2i));
                                let _e746 = (_e740 & 3u);
                                if (_e745 == 0u) {
                                    phi_847_ = _e592.unnamed.root;
                                } else {
                                    phi_847_ = _e592.unnamed.first_primitive;
                                }
                                let _e749 = phi_847_;
                                if (_e745 == 0u) {
                                    phi_857_ = _e661.unnamed.root;
                                } else {
                                    phi_857_ = _e661.unnamed.first_primitive;
                                }
                                let _e758 = phi_857_;
                                if (_e745 == 0u) {
                                    phi_867_ = _e730.unnamed.root;
                                } else {
                                    phi_867_ = _e730.unnamed.first_primitive;
                                }
                                let _e767 = phi_867_;
                                let _e780 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e749 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e505) + (_e523 - _e315)), ((f32(((_e758 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e506) + (_e524 - _e316)));
                                let _e781 = core_intrinsics_maximum_number_nsz_f32_(_e780, ((f32(((_e767 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e317)));
                                if (_e745 == 0u) {
                                    phi_885_ = _e592.unnamed_1.root;
                                } else {
                                    phi_885_ = _e592.unnamed_1.first_primitive;
                                }
                                let _e784 = phi_885_;
                                if (_e745 == 0u) {
                                    phi_895_ = _e661.unnamed_1.root;
                                } else {
                                    phi_895_ = _e661.unnamed_1.first_primitive;
                                }
                                let _e793 = phi_895_;
                                if (_e745 == 0u) {
                                    phi_905_ = _e730.unnamed_1.root;
                                } else {
                                    phi_905_ = _e730.unnamed_1.first_primitive;
                                }
                                let _e802 = phi_905_;
                                let _e815 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e784 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e505) + (_e523 + _e315)), ((f32(((_e793 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e506) + (_e524 + _e316)));
                                let _e816 = core_intrinsics_minimum_number_nsz_f32_(_e815, ((f32(((_e802 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e317)));
                                if (_e781 <= _e816) {
                                    if (_e781 <= _e115) {
                                        if (_e816 >= 0f) {
                                            if (_e745 == 0u) {
                                                let _e823 = nodes.member[(0u + _e473)].links[2u];
                                                phi_941_ = _e823;
                                            } else {
                                                let _e826 = nodes.member[(0u + _e473)].links[3u];
                                                phi_941_ = _e826;
                                            }
                                            let _e828 = phi_941_;
                                            let _e833 = ((_e828 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u);
                                            let _e834 = (_e833 & 31u);
                                            if (_e834 >= 24u) {
                                                phi_954_ = (24u + ((_e834 - 24u) ^ _e335));
                                            } else {
                                                phi_954_ = _e834;
                                            }
                                            let _e840 = phi_954_;
                                            phi_959_ = (_e742 | ((_e833 >> bitcast<u32>(5i)) << bitcast<u32>((_e840 & 31u))));
                                        } else {
                                            phi_959_ = _e742;
                                        }
                                        let _e848 = phi_959_;
                                        phi_960_ = _e848;
                                    } else {
                                        phi_960_ = _e742;
                                    }
                                    let _e850 = phi_960_;
                                    phi_961_ = _e850;
                                } else {
                                    phi_961_ = _e742;
                                }
                                let _e852 = phi_961_;
                                phi_831_ = (_e740 + 1u);
                                phi_834_ = _e852;
                            } else {
                                phi_831_ = u32();
                                phi_834_ = u32();
                            }
                            let _e855 = phi_831_;
                            let _e857 = phi_834_;
                            continue;
                            continuing {
                                phi_830_ = _e855;
                                phi_833_ = _e857;
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
                        phi_1019_ = (_e906 & 16777215u);
                        loop {
                            let _e909 = phi_1019_;
                            let _e910 = (_e909 == 0u);
                            local_10 = _e910;
                            local_17 = _e910;
                            if _e910 {
                                phi_1020_ = u32();
                                phi_2565_ = false;
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
                                    phi_1069_ = _e933;
                                } else {
                                    phi_1069_ = _e942;
                                }
                                let _e947 = phi_1069_;
                                if (_e934 < _e943) {
                                    phi_1074_ = _e934;
                                } else {
                                    phi_1074_ = _e943;
                                }
                                let _e950 = phi_1074_;
                                if (_e935 < _e944) {
                                    phi_1079_ = _e935;
                                } else {
                                    phi_1079_ = _e944;
                                }
                                let _e953 = phi_1079_;
                                if (_e933 > _e942) {
                                    phi_1087_ = _e933;
                                } else {
                                    phi_1087_ = _e942;
                                }
                                let _e959 = phi_1087_;
                                if (_e934 > _e943) {
                                    phi_1092_ = _e934;
                                } else {
                                    phi_1092_ = _e943;
                                }
                                let _e962 = phi_1092_;
                                if (_e935 > _e944) {
                                    phi_1097_ = _e935;
                                } else {
                                    phi_1097_ = _e944;
                                }
                                let _e965 = phi_1097_;
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
                                                                        phi_1245_ = bool();
                                                                        phi_1246_ = true;
                                                                    } else {
                                                                        let _e1077 = (_e1068 > 0f);
                                                                        if _e1077 {
                                                                            phi_1244_ = bool();
                                                                        } else {
                                                                            phi_1244_ = (_e1069 > 0f);
                                                                        }
                                                                        let _e1080 = phi_1244_;
                                                                        phi_1245_ = _e1080;
                                                                        phi_1246_ = _e1077;
                                                                    }
                                                                    let _e1082 = phi_1245_;
                                                                    let _e1084 = phi_1246_;
                                                                    if _e1084 {
                                                                        phi_1250_ = true;
                                                                    } else {
                                                                        phi_1250_ = _e1082;
                                                                    }
                                                                    let _e1086 = phi_1250_;
                                                                    phi_1251_ = _e1086;
                                                                    phi_1252_ = false;
                                                                } else {
                                                                    phi_1251_ = bool();
                                                                    phi_1252_ = true;
                                                                }
                                                                let _e1088 = phi_1251_;
                                                                let _e1090 = phi_1252_;
                                                                phi_1253_ = _e1088;
                                                                phi_1254_ = false;
                                                                phi_1255_ = _e1090;
                                                            } else {
                                                                phi_1253_ = bool();
                                                                phi_1254_ = true;
                                                                phi_1255_ = false;
                                                            }
                                                            let _e1092 = phi_1253_;
                                                            let _e1094 = phi_1254_;
                                                            let _e1096 = phi_1255_;
                                                            phi_1256_ = _e1092;
                                                            phi_1257_ = _e1094;
                                                            phi_1258_ = _e1096;
                                                        } else {
                                                            phi_1256_ = bool();
                                                            phi_1257_ = true;
                                                            phi_1258_ = false;
                                                        }
                                                        let _e1098 = phi_1256_;
                                                        let _e1100 = phi_1257_;
                                                        let _e1102 = phi_1258_;
                                                        phi_1259_ = _e1098;
                                                        phi_1260_ = _e1100;
                                                        phi_1261_ = _e1102;
                                                    } else {
                                                        phi_1259_ = bool();
                                                        phi_1260_ = true;
                                                        phi_1261_ = false;
                                                    }
                                                    let _e1104 = phi_1259_;
                                                    let _e1106 = phi_1260_;
                                                    let _e1108 = phi_1261_;
                                                    phi_1262_ = _e1104;
                                                    phi_1263_ = _e1106;
                                                    phi_1264_ = _e1108;
                                                } else {
                                                    phi_1262_ = bool();
                                                    phi_1263_ = true;
                                                    phi_1264_ = false;
                                                }
                                                let _e1110 = phi_1262_;
                                                let _e1112 = phi_1263_;
                                                let _e1114 = phi_1264_;
                                                phi_1265_ = _e1110;
                                                phi_1266_ = _e1112;
                                                phi_1267_ = _e1114;
                                            } else {
                                                phi_1265_ = bool();
                                                phi_1266_ = true;
                                                phi_1267_ = false;
                                            }
                                            let _e1116 = phi_1265_;
                                            let _e1118 = phi_1266_;
                                            let _e1120 = phi_1267_;
                                            if _e1118 {
                                                phi_1271_ = true;
                                            } else {
                                                phi_1271_ = _e1120;
                                            }
                                            let _e1122 = phi_1271_;
                                            if _e1122 {
                                                phi_1275_ = false;
                                            } else {
                                                phi_1275_ = _e1116;
                                            }
                                            let _e1124 = phi_1275_;
                                            if _e1124 {
                                                let _e1125 = (_e1061 >= _e60);
                                                if _e1125 {
                                                    phi_2548_ = bool();
                                                } else {
                                                    if (_e1061 < _e60) {
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
                                                        phi_1345_ = _e1191;
                                                    } else {
                                                        phi_1345_ = abs(_e1032);
                                                    }
                                                    let _e1196 = phi_1345_;
                                                    if (_e1032 < 0f) {
                                                        phi_1352_ = (-1f / _e1196);
                                                    } else {
                                                        phi_1352_ = (1f / _e1196);
                                                    }
                                                    let _e1201 = phi_1352_;
                                                    if (abs(_e1045) < _e1191) {
                                                        phi_1359_ = _e1191;
                                                    } else {
                                                        phi_1359_ = abs(_e1045);
                                                    }
                                                    let _e1206 = phi_1359_;
                                                    if (_e1045 < 0f) {
                                                        phi_1366_ = (-1f / _e1206);
                                                    } else {
                                                        phi_1366_ = (1f / _e1206);
                                                    }
                                                    let _e1211 = phi_1366_;
                                                    if (abs(_e1058) < _e1191) {
                                                        phi_1373_ = _e1191;
                                                    } else {
                                                        phi_1373_ = abs(_e1058);
                                                    }
                                                    let _e1216 = phi_1373_;
                                                    if (_e1058 < 0f) {
                                                        phi_1380_ = (-1f / _e1216);
                                                    } else {
                                                        phi_1380_ = (1f / _e1216);
                                                    }
                                                    let _e1221 = phi_1380_;
                                                    let _e1225 = abs((bitcast<f32>(_e1131) - _e989));
                                                    let _e1226 = abs((bitcast<f32>(_e1135) - _e1002));
                                                    let _e1227 = abs((bitcast<f32>(_e1139) - _e1015));
                                                    let _e1231 = abs(((bitcast<f32>(_e1143) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e989));
                                                    let _e1232 = abs(((bitcast<f32>(_e1147) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1002));
                                                    let _e1233 = abs(((bitcast<f32>(_e1151) + (bitcast<f32>((((_e1155 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1015));
                                                    if (_e1225 > _e1231) {
                                                        phi_1397_ = _e1225;
                                                    } else {
                                                        phi_1397_ = _e1231;
                                                    }
                                                    let _e1236 = phi_1397_;
                                                    if (_e1226 > _e1232) {
                                                        phi_1402_ = _e1226;
                                                    } else {
                                                        phi_1402_ = _e1232;
                                                    }
                                                    let _e1239 = phi_1402_;
                                                    if (_e1227 > _e1233) {
                                                        phi_1407_ = _e1227;
                                                    } else {
                                                        phi_1407_ = _e1233;
                                                    }
                                                    let _e1242 = phi_1407_;
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
                                                            phi_1435_ = false;
                                                        } else {
                                                            phi_1435_ = true;
                                                        }
                                                        let _e1265 = phi_1435_;
                                                        phi_1436_ = _e1265;
                                                    } else {
                                                        phi_1436_ = true;
                                                    }
                                                    let _e1267 = phi_1436_;
                                                    if _e1267 {
                                                        if (_e1260 >= _e1261) {
                                                            phi_1444_ = 1u;
                                                        } else {
                                                            phi_1444_ = 2u;
                                                        }
                                                        let _e1270 = phi_1444_;
                                                        phi_1445_ = _e1270;
                                                    } else {
                                                        phi_1445_ = 0u;
                                                    }
                                                    let _e1272 = phi_1445_;
                                                    if (_e1272 == 0u) {
                                                        phi_1457_ = vec3<f32>(_e1045, _e1058, _e1032);
                                                    } else {
                                                        if (_e1272 == 1u) {
                                                            phi_1456_ = vec3<f32>(_e1058, _e1032, _e1045);
                                                        } else {
                                                            phi_1456_ = vec3<f32>(_e1032, _e1045, _e1058);
                                                        }
                                                        let _e1278 = phi_1456_;
                                                        phi_1457_ = _e1278;
                                                    }
                                                    let _e1280 = phi_1457_;
                                                    let _e1283 = (_e1280.x / _e1280.z);
                                                    let _e1286 = (_e1280.y / _e1280.z);
                                                    let _e1288 = (1f / _e1280.z);
                                                    if (_e1201 < 0f) {
                                                        phi_1470_ = 0u;
                                                    } else {
                                                        phi_1470_ = 1u;
                                                    }
                                                    let _e1291 = phi_1470_;
                                                    if (_e1211 < 0f) {
                                                        phi_1475_ = 0u;
                                                    } else {
                                                        phi_1475_ = 2u;
                                                    }
                                                    let _e1294 = phi_1475_;
                                                    if (_e1221 < 0f) {
                                                        phi_1480_ = 0u;
                                                    } else {
                                                        phi_1480_ = 4u;
                                                    }
                                                    let _e1297 = phi_1480_;
                                                    let _e1299 = ((_e1291 | _e1294) | _e1297);
                                                    let _e1300 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1061, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1300.first[0], _e1300.first[1], _e1300.first[2], _e1300.first[3], _e1300.first[4], _e1300.first[5], _e1300.first[6], _e1300.first[7], _e1300.first[8], _e1300.first[9], _e1300.first[10], _e1300.first[11], _e1300.first[12], _e1300.first[13], _e1300.first[14], _e1300.first[15], _e1300.first[16], _e1300.first[17], _e1300.first[18], _e1300.first[19], _e1300.first[20], _e1300.first[21], _e1300.first[22], _e1300.first[23], _e1300.first[24], _e1300.first[25], _e1300.first[26], _e1300.first[27], _e1300.first[28], _e1300.first[29], _e1300.first[30], _e1300.first[31]), array<u32, 32>(_e1300.mask[0], _e1300.mask[1], _e1300.mask[2], _e1300.mask[3], _e1300.mask[4], _e1300.mask[5], _e1300.mask[6], _e1300.mask[7], _e1300.mask[8], _e1300.mask[9], _e1300.mask[10], _e1300.mask[11], _e1300.mask[12], _e1300.mask[13], _e1300.mask[14], _e1300.mask[15], _e1300.mask[16], _e1300.mask[17], _e1300.mask[18], _e1300.mask[19], _e1300.mask[20], _e1300.mask[21], _e1300.mask[22], _e1300.mask[23], _e1300.mask[24], _e1300.mask[25], _e1300.mask[26], _e1300.mask[27], _e1300.mask[28], _e1300.mask[29], _e1300.mask[30], _e1300.mask[31]), _e1300.len, _e1300.group, _e1300.group_mask);
                                                    let _e1374 = local.group_mask;
                                                    if ((_e1374 & 4278190080u) == 0u) {
                                                        let _e1378 = local.len;
                                                        if (_e1378 == 0u) {
                                                            phi_1594_ = false;
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
                                                            phi_1594_ = true;
                                                        }
                                                        let _e1401 = phi_1594_;
                                                        phi_1595_ = _e1401;
                                                    } else {
                                                        phi_1595_ = true;
                                                    }
                                                    let _e1403 = phi_1595_;
                                                    if _e1403 {
                                                        let _e1405 = local.group_mask;
                                                        let _e1411 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1405)), 32u, (_e1405 == 0u)));
                                                        let _e1415 = local.group_mask;
                                                        let _e1429 = local.group_mask;
                                                        local.group_mask = (_e1429 & ~((1u << bitcast<u32>((_e1411 & 31u)))));
                                                        let _e1432 = local.group;
                                                        phi_1626_ = (_e1432 + countOneBits(((_e1415 & ~((4294967295u << bitcast<u32>((((_e1411 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1626_ = 4294967295u;
                                                    }
                                                    let _e1435 = phi_1626_;
                                                    phi_1628_ = _e1435;
                                                    loop {
                                                        let _e1437 = phi_1628_;
                                                        if (_e1437 != 4294967295u) {
                                                            if (_e1437 < _e60) {
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
                                                                phi_1709_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1520.unnamed, lt_bvh_traverse_Tree(_e1520.unnamed_1.root, _e1497.y));
                                                            } else {
                                                                let _e1536 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1536.unnamed.root, _e1497.y), _e1536.unnamed_1);
                                                                let _e1548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1542.unnamed, lt_bvh_traverse_Tree(_e1497.z, _e1542.unnamed_1.first_primitive));
                                                                phi_1709_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1548.unnamed, lt_bvh_traverse_Tree(_e1548.unnamed_1.root, _e1497.w));
                                                            }
                                                            let _e1556 = phi_1709_;
                                                            let _e1566 = nodes.member[(0u + _e1437)].y;
                                                            if (_e1211 < 0f) {
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1577.unnamed.root, _e1566.w), _e1577.unnamed_1);
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1583.unnamed, lt_bvh_traverse_Tree(_e1566.x, _e1583.unnamed_1.first_primitive));
                                                                phi_1736_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1589.unnamed, lt_bvh_traverse_Tree(_e1589.unnamed_1.root, _e1566.y));
                                                            } else {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1605.unnamed.root, _e1566.y), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1566.z, _e1611.unnamed_1.first_primitive));
                                                                phi_1736_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1566.w));
                                                            }
                                                            let _e1625 = phi_1736_;
                                                            let _e1635 = nodes.member[(0u + _e1437)].z;
                                                            if (_e1221 < 0f) {
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1646.unnamed.root, _e1635.w), _e1646.unnamed_1);
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1652.unnamed, lt_bvh_traverse_Tree(_e1635.x, _e1652.unnamed_1.first_primitive));
                                                                phi_1763_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1658.unnamed, lt_bvh_traverse_Tree(_e1658.unnamed_1.root, _e1635.y));
                                                            } else {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1635.y), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1635.z, _e1680.unnamed_1.first_primitive));
                                                                phi_1763_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1635.w));
                                                            }
                                                            let _e1694 = phi_1763_;
                                                            phi_1769_ = 0u;
                                                            phi_1772_ = 0u;
                                                            loop {
                                                                let _e1704 = phi_1769_;
                                                                let _e1706 = phi_1772_;
                                                                local_5 = _e1706;
                                                                local_6 = _e1706;
                                                                local_7 = _e1706;
                                                                let _e1707 = (_e1704 < 8u);
                                                                if _e1707 {
                                                                    let _e1709 = (_e1704 >> bitcast<u32>(2i));
                                                                    let _e1710 = (_e1704 & 3u);
                                                                    if (_e1709 == 0u) {
                                                                        phi_1786_ = _e1556.unnamed.root;
                                                                    } else {
                                                                        phi_1786_ = _e1556.unnamed.first_primitive;
                                                                    }
                                                                    let _e1713 = phi_1786_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1796_ = _e1625.unnamed.root;
                                                                    } else {
                                                                        phi_1796_ = _e1625.unnamed.first_primitive;
                                                                    }
                                                                    let _e1722 = phi_1796_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1806_ = _e1694.unnamed.root;
                                                                    } else {
                                                                        phi_1806_ = _e1694.unnamed.first_primitive;
                                                                    }
                                                                    let _e1731 = phi_1806_;
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1713 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1249)), ((f32(((_e1722 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1250)));
                                                                    let _e1745 = core_intrinsics_maximum_number_nsz_f32_(_e1744, ((f32(((_e1731 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 - _e1251)));
                                                                    if (_e1709 == 0u) {
                                                                        phi_1824_ = _e1556.unnamed_1.root;
                                                                    } else {
                                                                        phi_1824_ = _e1556.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1748 = phi_1824_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1834_ = _e1625.unnamed_1.root;
                                                                    } else {
                                                                        phi_1834_ = _e1625.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1757 = phi_1834_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1844_ = _e1694.unnamed_1.root;
                                                                    } else {
                                                                        phi_1844_ = _e1694.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1766 = phi_1844_;
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1748 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1249)), ((f32(((_e1757 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1250)));
                                                                    let _e1780 = core_intrinsics_minimum_number_nsz_f32_(_e1779, ((f32(((_e1766 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 + _e1251)));
                                                                    if (_e1745 <= _e1780) {
                                                                        if (_e1745 <= _e115) {
                                                                            if (_e1780 >= 0f) {
                                                                                if (_e1709 == 0u) {
                                                                                    let _e1787 = nodes.member[(0u + _e1437)].links[2u];
                                                                                    phi_1880_ = _e1787;
                                                                                } else {
                                                                                    let _e1790 = nodes.member[(0u + _e1437)].links[3u];
                                                                                    phi_1880_ = _e1790;
                                                                                }
                                                                                let _e1792 = phi_1880_;
                                                                                let _e1797 = ((_e1792 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u);
                                                                                let _e1798 = (_e1797 & 31u);
                                                                                if (_e1798 >= 24u) {
                                                                                    phi_1893_ = (24u + ((_e1798 - 24u) ^ _e1299));
                                                                                } else {
                                                                                    phi_1893_ = _e1798;
                                                                                }
                                                                                let _e1804 = phi_1893_;
                                                                                phi_1898_ = (_e1706 | ((_e1797 >> bitcast<u32>(5i)) << bitcast<u32>((_e1804 & 31u))));
                                                                            } else {
                                                                                phi_1898_ = _e1706;
                                                                            }
                                                                            let _e1812 = phi_1898_;
                                                                            phi_1899_ = _e1812;
                                                                        } else {
                                                                            phi_1899_ = _e1706;
                                                                        }
                                                                        let _e1814 = phi_1899_;
                                                                        phi_1900_ = _e1814;
                                                                    } else {
                                                                        phi_1900_ = _e1706;
                                                                    }
                                                                    let _e1816 = phi_1900_;
                                                                    phi_1770_ = (_e1704 + 1u);
                                                                    phi_1773_ = _e1816;
                                                                } else {
                                                                    phi_1770_ = u32();
                                                                    phi_1773_ = u32();
                                                                }
                                                                let _e1819 = phi_1770_;
                                                                let _e1821 = phi_1773_;
                                                                continue;
                                                                continuing {
                                                                    phi_1769_ = _e1819;
                                                                    phi_1772_ = _e1821;
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
                                                            phi_1958_ = (_e1870 & 16777215u);
                                                            loop {
                                                                let _e1873 = phi_1958_;
                                                                let _e1874 = (_e1873 == 0u);
                                                                local_8 = _e1874;
                                                                local_14 = _e1874;
                                                                if _e1874 {
                                                                    phi_1959_ = u32();
                                                                    phi_2451_ = false;
                                                                    phi_2452_ = false;
                                                                    phi_2453_ = false;
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
                                                                        phi_2004_ = vec3<f32>(_e1893, _e1895, _e1891);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2003_ = vec3<f32>(_e1895, _e1891, _e1893);
                                                                        } else {
                                                                            phi_2003_ = (_e1889 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1903 = phi_2003_;
                                                                        phi_2004_ = _e1903;
                                                                    }
                                                                    let _e1905 = phi_2004_;
                                                                    let _e1909 = (_e1905.x - (_e1283 * _e1905.z));
                                                                    let _e1913 = (_e1905.y - (_e1286 * _e1905.z));
                                                                    let _e1917 = triangles.member[(0u + _e1882)].v1_;
                                                                    let _e1919 = (_e1917.x - _e989);
                                                                    let _e1921 = (_e1917.y - _e1002);
                                                                    let _e1923 = (_e1917.z - _e1015);
                                                                    if (_e1272 == 0u) {
                                                                        phi_2036_ = vec3<f32>(_e1921, _e1923, _e1919);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2035_ = vec3<f32>(_e1923, _e1919, _e1921);
                                                                        } else {
                                                                            phi_2035_ = (_e1917 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1931 = phi_2035_;
                                                                        phi_2036_ = _e1931;
                                                                    }
                                                                    let _e1933 = phi_2036_;
                                                                    let _e1937 = (_e1933.x - (_e1283 * _e1933.z));
                                                                    let _e1941 = (_e1933.y - (_e1286 * _e1933.z));
                                                                    let _e1945 = triangles.member[(0u + _e1882)].v2_;
                                                                    let _e1947 = (_e1945.x - _e989);
                                                                    let _e1949 = (_e1945.y - _e1002);
                                                                    let _e1951 = (_e1945.z - _e1015);
                                                                    if (_e1272 == 0u) {
                                                                        phi_2068_ = vec3<f32>(_e1949, _e1951, _e1947);
                                                                    } else {
                                                                        if (_e1272 == 1u) {
                                                                            phi_2067_ = vec3<f32>(_e1951, _e1947, _e1949);
                                                                        } else {
                                                                            phi_2067_ = (_e1945 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1959 = phi_2067_;
                                                                        phi_2068_ = _e1959;
                                                                    }
                                                                    let _e1961 = phi_2068_;
                                                                    let _e1965 = (_e1961.x - (_e1283 * _e1961.z));
                                                                    let _e1969 = (_e1961.y - (_e1286 * _e1961.z));
                                                                    if (_e1937 < _e1965) {
                                                                        phi_2089_ = true;
                                                                    } else {
                                                                        if (_e1937 == _e1965) {
                                                                            phi_2088_ = (_e1941 < _e1969);
                                                                        } else {
                                                                            phi_2088_ = false;
                                                                        }
                                                                        let _e1976 = phi_2088_;
                                                                        phi_2089_ = _e1976;
                                                                    }
                                                                    let _e1978 = phi_2089_;
                                                                    if _e1978 {
                                                                        phi_2093_ = _e1969;
                                                                        phi_2094_ = _e1965;
                                                                        phi_2095_ = _e1941;
                                                                        phi_2096_ = _e1937;
                                                                    } else {
                                                                        phi_2093_ = _e1941;
                                                                        phi_2094_ = _e1937;
                                                                        phi_2095_ = _e1969;
                                                                        phi_2096_ = _e1965;
                                                                    }
                                                                    let _e1980 = phi_2093_;
                                                                    let _e1982 = phi_2094_;
                                                                    let _e1984 = phi_2095_;
                                                                    let _e1986 = phi_2096_;
                                                                    let _e1989 = ((_e1986 * _e1980) - (_e1984 * _e1982));
                                                                    if _e1978 {
                                                                        phi_2104_ = -(_e1989);
                                                                    } else {
                                                                        phi_2104_ = _e1989;
                                                                    }
                                                                    let _e1992 = phi_2104_;
                                                                    if (_e1965 < _e1909) {
                                                                        phi_2115_ = true;
                                                                    } else {
                                                                        if (_e1965 == _e1909) {
                                                                            phi_2114_ = (_e1969 < _e1913);
                                                                        } else {
                                                                            phi_2114_ = false;
                                                                        }
                                                                        let _e1997 = phi_2114_;
                                                                        phi_2115_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2115_;
                                                                    if _e1999 {
                                                                        phi_2119_ = _e1913;
                                                                        phi_2120_ = _e1909;
                                                                        phi_2121_ = _e1969;
                                                                        phi_2122_ = _e1965;
                                                                    } else {
                                                                        phi_2119_ = _e1969;
                                                                        phi_2120_ = _e1965;
                                                                        phi_2121_ = _e1913;
                                                                        phi_2122_ = _e1909;
                                                                    }
                                                                    let _e2001 = phi_2119_;
                                                                    let _e2003 = phi_2120_;
                                                                    let _e2005 = phi_2121_;
                                                                    let _e2007 = phi_2122_;
                                                                    let _e2010 = ((_e2007 * _e2001) - (_e2005 * _e2003));
                                                                    if _e1999 {
                                                                        phi_2130_ = -(_e2010);
                                                                    } else {
                                                                        phi_2130_ = _e2010;
                                                                    }
                                                                    let _e2013 = phi_2130_;
                                                                    if (_e1909 < _e1937) {
                                                                        phi_2141_ = true;
                                                                    } else {
                                                                        if (_e1909 == _e1937) {
                                                                            phi_2140_ = (_e1913 < _e1941);
                                                                        } else {
                                                                            phi_2140_ = false;
                                                                        }
                                                                        let _e2018 = phi_2140_;
                                                                        phi_2141_ = _e2018;
                                                                    }
                                                                    let _e2020 = phi_2141_;
                                                                    if _e2020 {
                                                                        phi_2145_ = _e1941;
                                                                        phi_2146_ = _e1937;
                                                                        phi_2147_ = _e1913;
                                                                        phi_2148_ = _e1909;
                                                                    } else {
                                                                        phi_2145_ = _e1913;
                                                                        phi_2146_ = _e1909;
                                                                        phi_2147_ = _e1941;
                                                                        phi_2148_ = _e1937;
                                                                    }
                                                                    let _e2022 = phi_2145_;
                                                                    let _e2024 = phi_2146_;
                                                                    let _e2026 = phi_2147_;
                                                                    let _e2028 = phi_2148_;
                                                                    let _e2031 = ((_e2028 * _e2022) - (_e2026 * _e2024));
                                                                    if _e2020 {
                                                                        phi_2156_ = -(_e2031);
                                                                    } else {
                                                                        phi_2156_ = _e2031;
                                                                    }
                                                                    let _e2034 = phi_2156_;
                                                                    if (_e1992 >= 0f) {
                                                                        if (_e2013 >= 0f) {
                                                                            if (_e2034 >= 0f) {
                                                                                phi_2171_ = ((_e1992 + _e2013) + _e2034);
                                                                                phi_2172_ = false;
                                                                            } else {
                                                                                phi_2171_ = f32();
                                                                                phi_2172_ = true;
                                                                            }
                                                                            let _e2041 = phi_2171_;
                                                                            let _e2043 = phi_2172_;
                                                                            phi_2173_ = _e2041;
                                                                            phi_2174_ = _e2043;
                                                                        } else {
                                                                            phi_2173_ = f32();
                                                                            phi_2174_ = true;
                                                                        }
                                                                        let _e2045 = phi_2173_;
                                                                        let _e2047 = phi_2174_;
                                                                        phi_2175_ = _e2045;
                                                                        phi_2176_ = _e2047;
                                                                    } else {
                                                                        phi_2175_ = f32();
                                                                        phi_2176_ = true;
                                                                    }
                                                                    let _e2049 = phi_2175_;
                                                                    let _e2051 = phi_2176_;
                                                                    if _e2051 {
                                                                        if (_e1992 <= 0f) {
                                                                            if (_e2013 <= 0f) {
                                                                                let _e2054 = (_e2034 <= 0f);
                                                                                if _e2054 {
                                                                                }
                                                                                phi_2194_ = ((_e1992 + _e2013) + _e2034);
                                                                                phi_2195_ = false;
                                                                                phi_2196_ = _e2054;
                                                                            } else {
                                                                                phi_2194_ = f32();
                                                                                phi_2195_ = true;
                                                                                phi_2196_ = false;
                                                                            }
                                                                            let _e2058 = phi_2194_;
                                                                            let _e2060 = phi_2195_;
                                                                            let _e2062 = phi_2196_;
                                                                            phi_2197_ = _e2058;
                                                                            phi_2198_ = _e2060;
                                                                            phi_2199_ = _e2062;
                                                                        } else {
                                                                            phi_2197_ = f32();
                                                                            phi_2198_ = true;
                                                                            phi_2199_ = false;
                                                                        }
                                                                        let _e2064 = phi_2197_;
                                                                        let _e2066 = phi_2198_;
                                                                        let _e2068 = phi_2199_;
                                                                        if _e2066 {
                                                                            phi_2203_ = false;
                                                                        } else {
                                                                            phi_2203_ = _e2068;
                                                                        }
                                                                        let _e2070 = phi_2203_;
                                                                        phi_2204_ = _e2064;
                                                                        phi_2205_ = _e2070;
                                                                    } else {
                                                                        phi_2204_ = _e2049;
                                                                        phi_2205_ = true;
                                                                    }
                                                                    let _e2072 = phi_2204_;
                                                                    let _e2074 = phi_2205_;
                                                                    if _e2074 {
                                                                        let _e2075 = (_e2072 == 0f);
                                                                        if _e2075 {
                                                                            phi_2403_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2081 = ((((_e1992 * (_e1288 * _e1905.z)) + (_e2013 * (_e1288 * _e1933.z))) + (_e2034 * (_e1288 * _e1961.z))) / _e2072);
                                                                            let _e2083 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2085 = triangles.member[(0u + _e1882)].v1_;
                                                                            if (_e2083.x < _e2085.x) {
                                                                                phi_2231_ = _e2083.x;
                                                                            } else {
                                                                                phi_2231_ = _e2085.x;
                                                                            }
                                                                            let _e2092 = phi_2231_;
                                                                            if (_e2083.y < _e2085.y) {
                                                                                phi_2240_ = _e2083.y;
                                                                            } else {
                                                                                phi_2240_ = _e2085.y;
                                                                            }
                                                                            let _e2099 = phi_2240_;
                                                                            if (_e2083.z < _e2085.z) {
                                                                                phi_2249_ = _e2083.z;
                                                                            } else {
                                                                                phi_2249_ = _e2085.z;
                                                                            }
                                                                            let _e2106 = phi_2249_;
                                                                            let _e2108 = triangles.member[(0u + _e1882)].v2_;
                                                                            if (_e2092 < _e2108.x) {
                                                                                phi_2258_ = _e2092;
                                                                            } else {
                                                                                phi_2258_ = _e2108.x;
                                                                            }
                                                                            let _e2113 = phi_2258_;
                                                                            if (_e2099 < _e2108.y) {
                                                                                phi_2265_ = _e2099;
                                                                            } else {
                                                                                phi_2265_ = _e2108.y;
                                                                            }
                                                                            let _e2118 = phi_2265_;
                                                                            if (_e2106 < _e2108.z) {
                                                                                phi_2272_ = _e2106;
                                                                            } else {
                                                                                phi_2272_ = _e2108.z;
                                                                            }
                                                                            let _e2123 = phi_2272_;
                                                                            let _e2125 = triangles.member[(0u + _e1882)].v0_;
                                                                            let _e2127 = triangles.member[(0u + _e1882)].v1_;
                                                                            if (_e2125.x > _e2127.x) {
                                                                                phi_2285_ = _e2125.x;
                                                                            } else {
                                                                                phi_2285_ = _e2127.x;
                                                                            }
                                                                            let _e2134 = phi_2285_;
                                                                            if (_e2125.y > _e2127.y) {
                                                                                phi_2294_ = _e2125.y;
                                                                            } else {
                                                                                phi_2294_ = _e2127.y;
                                                                            }
                                                                            let _e2141 = phi_2294_;
                                                                            if (_e2125.z > _e2127.z) {
                                                                                phi_2303_ = _e2125.z;
                                                                            } else {
                                                                                phi_2303_ = _e2127.z;
                                                                            }
                                                                            let _e2148 = phi_2303_;
                                                                            let _e2150 = triangles.member[(0u + _e1882)].v2_;
                                                                            if (_e2134 > _e2150.x) {
                                                                                phi_2312_ = _e2134;
                                                                            } else {
                                                                                phi_2312_ = _e2150.x;
                                                                            }
                                                                            let _e2155 = phi_2312_;
                                                                            if (_e2141 > _e2150.y) {
                                                                                phi_2319_ = _e2141;
                                                                            } else {
                                                                                phi_2319_ = _e2150.y;
                                                                            }
                                                                            let _e2160 = phi_2319_;
                                                                            if (_e2148 > _e2150.z) {
                                                                                phi_2326_ = _e2148;
                                                                            } else {
                                                                                phi_2326_ = _e2150.z;
                                                                            }
                                                                            let _e2165 = phi_2326_;
                                                                            let _e2169 = ((_e2113 - _e989) * _e1201);
                                                                            let _e2170 = ((_e2118 - _e1002) * _e1211);
                                                                            let _e2171 = ((_e2123 - _e1015) * _e1221);
                                                                            let _e2175 = ((_e2155 - _e989) * _e1201);
                                                                            let _e2176 = ((_e2160 - _e1002) * _e1211);
                                                                            let _e2177 = ((_e2165 - _e1015) * _e1221);
                                                                            if (_e2169 < _e2175) {
                                                                                phi_2343_ = _e2169;
                                                                            } else {
                                                                                phi_2343_ = _e2175;
                                                                            }
                                                                            let _e2180 = phi_2343_;
                                                                            if (_e2170 < _e2176) {
                                                                                phi_2348_ = _e2170;
                                                                            } else {
                                                                                phi_2348_ = _e2176;
                                                                            }
                                                                            let _e2183 = phi_2348_;
                                                                            if (_e2171 < _e2177) {
                                                                                phi_2353_ = _e2171;
                                                                            } else {
                                                                                phi_2353_ = _e2177;
                                                                            }
                                                                            let _e2186 = phi_2353_;
                                                                            if (_e2169 > _e2175) {
                                                                                phi_2361_ = _e2169;
                                                                            } else {
                                                                                phi_2361_ = _e2175;
                                                                            }
                                                                            let _e2192 = phi_2361_;
                                                                            if (_e2170 > _e2176) {
                                                                                phi_2366_ = _e2170;
                                                                            } else {
                                                                                phi_2366_ = _e2176;
                                                                            }
                                                                            let _e2195 = phi_2366_;
                                                                            if (_e2171 > _e2177) {
                                                                                phi_2371_ = _e2171;
                                                                            } else {
                                                                                phi_2371_ = _e2177;
                                                                            }
                                                                            let _e2198 = phi_2371_;
                                                                            let _e2202 = core_intrinsics_maximum_number_nsz_f32_((_e2180 - _e1256), (_e2183 - _e1257));
                                                                            let _e2203 = core_intrinsics_maximum_number_nsz_f32_(_e2202, (_e2186 - _e1258));
                                                                            let _e2204 = core_intrinsics_minimum_number_nsz_f32_((_e2192 + _e1256), (_e2195 + _e1257));
                                                                            let _e2205 = core_intrinsics_minimum_number_nsz_f32_(_e2204, (_e2198 + _e1258));
                                                                            if (_e2203 > _e970) {
                                                                                phi_2383_ = _e2203;
                                                                            } else {
                                                                                phi_2383_ = _e970;
                                                                            }
                                                                            let _e2208 = phi_2383_;
                                                                            if (_e2205 < _e972) {
                                                                                phi_2388_ = _e2205;
                                                                            } else {
                                                                                phi_2388_ = _e972;
                                                                            }
                                                                            let _e2211 = phi_2388_;
                                                                            if (_e2081 < _e2208) {
                                                                                phi_2393_ = _e2208;
                                                                            } else {
                                                                                phi_2393_ = _e2081;
                                                                            }
                                                                            let _e2214 = phi_2393_;
                                                                            if (_e2214 > _e2211) {
                                                                                phi_2398_ = _e2211;
                                                                            } else {
                                                                                phi_2398_ = _e2214;
                                                                            }
                                                                            let _e2217 = phi_2398_;
                                                                            phi_2403_ = lt_bvh_triangle_Intersection(_e2217, (_e2013 / _e2072), (_e2034 / _e2072), (_e2208 <= _e2211));
                                                                        }
                                                                        let _e2223 = phi_2403_;
                                                                        phi_2404_ = _e2223;
                                                                        phi_2405_ = _e2075;
                                                                    } else {
                                                                        phi_2404_ = lt_bvh_triangle_Intersection();
                                                                        phi_2405_ = true;
                                                                    }
                                                                    let _e2225 = phi_2404_;
                                                                    let _e2227 = phi_2405_;
                                                                    if _e2227 {
                                                                        phi_2409_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2409_ = _e2225;
                                                                    }
                                                                    let _e2229 = phi_2409_;
                                                                    if _e2229.is_hit {
                                                                        if (_e2229.t > 0f) {
                                                                            if (_e2229.t < _e115) {
                                                                                let _e2236 = triangles.member[(0u + _e1882)].i0_;
                                                                                let _e2238 = ((_e2236 & 2147483648u) == 0u);
                                                                                if _e2238 {
                                                                                    phi_2435_ = false;
                                                                                    phi_2436_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2434_ = false;
                                                                                    } else {
                                                                                        phi_2434_ = true;
                                                                                    }
                                                                                    let _e2240 = phi_2434_;
                                                                                    phi_2435_ = _e2240;
                                                                                    phi_2436_ = true;
                                                                                }
                                                                                let _e2242 = phi_2435_;
                                                                                let _e2244 = phi_2436_;
                                                                                phi_2437_ = _e2242;
                                                                                phi_2438_ = _e2238;
                                                                                phi_2439_ = _e2244;
                                                                            } else {
                                                                                phi_2437_ = true;
                                                                                phi_2438_ = false;
                                                                                phi_2439_ = false;
                                                                            }
                                                                            let _e2246 = phi_2437_;
                                                                            let _e2248 = phi_2438_;
                                                                            let _e2250 = phi_2439_;
                                                                            phi_2440_ = _e2246;
                                                                            phi_2441_ = _e2248;
                                                                            phi_2442_ = _e2250;
                                                                        } else {
                                                                            phi_2440_ = true;
                                                                            phi_2441_ = false;
                                                                            phi_2442_ = false;
                                                                        }
                                                                        let _e2252 = phi_2440_;
                                                                        let _e2254 = phi_2441_;
                                                                        let _e2256 = phi_2442_;
                                                                        phi_2443_ = _e2252;
                                                                        phi_2444_ = _e2254;
                                                                        phi_2445_ = _e2256;
                                                                    } else {
                                                                        phi_2443_ = true;
                                                                        phi_2444_ = false;
                                                                        phi_2445_ = false;
                                                                    }
                                                                    let _e2258 = phi_2443_;
                                                                    let _e2260 = phi_2444_;
                                                                    let _e2262 = phi_2445_;
                                                                    if _e2258 {
                                                                        phi_2449_ = false;
                                                                        phi_2450_ = false;
                                                                    } else {
                                                                        phi_2449_ = _e2260;
                                                                        phi_2450_ = _e2262;
                                                                    }
                                                                    let _e2264 = phi_2449_;
                                                                    let _e2266 = phi_2450_;
                                                                    phi_1959_ = (_e1873 & (_e1873 - 1u));
                                                                    phi_2451_ = _e2258;
                                                                    phi_2452_ = _e2264;
                                                                    phi_2453_ = _e2266;
                                                                }
                                                                let _e2268 = phi_1959_;
                                                                let _e2270 = phi_2451_;
                                                                let _e2272 = phi_2452_;
                                                                let _e2274 = phi_2453_;
                                                                local_12 = _e2272;
                                                                local_13 = _e2274;
                                                                continue;
                                                                continuing {
                                                                    phi_1958_ = _e2268;
                                                                    break if !(_e2270);
                                                                }
                                                            }
                                                            let _e2277 = local_8;
                                                            if _e2277 {
                                                                let _e2279 = local.group_mask;
                                                                if ((_e2279 & 4278190080u) == 0u) {
                                                                    let _e2283 = local.len;
                                                                    if (_e2283 == 0u) {
                                                                        phi_2495_ = false;
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
                                                                        phi_2495_ = true;
                                                                    }
                                                                    let _e2306 = phi_2495_;
                                                                    phi_2496_ = _e2306;
                                                                } else {
                                                                    phi_2496_ = true;
                                                                }
                                                                let _e2308 = phi_2496_;
                                                                if _e2308 {
                                                                    let _e2310 = local.group_mask;
                                                                    let _e2316 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2310)), 32u, (_e2310 == 0u)));
                                                                    let _e2320 = local.group_mask;
                                                                    let _e2334 = local.group_mask;
                                                                    local.group_mask = (_e2334 & ~((1u << bitcast<u32>((_e2316 & 31u)))));
                                                                    let _e2337 = local.group;
                                                                    phi_2527_ = (_e2337 + countOneBits(((_e2320 & ~((4294967295u << bitcast<u32>((((_e2316 - 24u) ^ _e1299) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2527_ = 4294967295u;
                                                                }
                                                                let _e2340 = phi_2527_;
                                                                phi_2528_ = _e2340;
                                                                phi_2529_ = false;
                                                                phi_2530_ = false;
                                                            } else {
                                                                phi_2528_ = u32();
                                                                let _e2710 = local_12;
                                                                phi_2529_ = _e2710;
                                                                let _e2713 = local_13;
                                                                phi_2530_ = _e2713;
                                                            }
                                                            let _e2342 = phi_2528_;
                                                            let _e2344 = phi_2529_;
                                                            let _e2346 = phi_2530_;
                                                            phi_1629_ = _e2342;
                                                            let _e2717 = local_14;
                                                            phi_2531_ = _e2717;
                                                            phi_2532_ = false;
                                                            phi_2533_ = _e2344;
                                                            phi_2534_ = _e2346;
                                                        } else {
                                                            phi_1629_ = u32();
                                                            phi_2531_ = false;
                                                            phi_2532_ = true;
                                                            phi_2533_ = false;
                                                            phi_2534_ = false;
                                                        }
                                                        let _e2348 = phi_1629_;
                                                        let _e2350 = phi_2531_;
                                                        let _e2352 = phi_2532_;
                                                        let _e2354 = phi_2533_;
                                                        let _e2356 = phi_2534_;
                                                        local_9 = _e2352;
                                                        local_15 = _e2354;
                                                        local_16 = _e2356;
                                                        continue;
                                                        continuing {
                                                            phi_1628_ = _e2348;
                                                            break if !(_e2350);
                                                        }
                                                    }
                                                    let _e2359 = local_9;
                                                    if _e2359 {
                                                        phi_2538_ = false;
                                                        phi_2539_ = false;
                                                    } else {
                                                        let _e2724 = local_15;
                                                        phi_2538_ = _e2724;
                                                        let _e2727 = local_16;
                                                        phi_2539_ = _e2727;
                                                    }
                                                    let _e2361 = phi_2538_;
                                                    let _e2363 = phi_2539_;
                                                    if _e2361 {
                                                        phi_2543_ = true;
                                                    } else {
                                                        phi_2543_ = _e2363;
                                                    }
                                                    let _e2365 = phi_2543_;
                                                    if _e2365 {
                                                        phi_2547_ = true;
                                                    } else {
                                                        phi_2547_ = false;
                                                    }
                                                    let _e2367 = phi_2547_;
                                                    phi_2548_ = _e2367;
                                                }
                                                let _e2369 = phi_2548_;
                                                phi_2549_ = _e2369;
                                                phi_2550_ = _e1125;
                                            } else {
                                                phi_2549_ = bool();
                                                phi_2550_ = true;
                                            }
                                            let _e2371 = phi_2549_;
                                            let _e2373 = phi_2550_;
                                            if _e2373 {
                                                phi_2554_ = false;
                                            } else {
                                                phi_2554_ = _e2371;
                                            }
                                            let _e2375 = phi_2554_;
                                            if _e2375 {
                                                phi_2558_ = false;
                                            } else {
                                                phi_2558_ = true;
                                            }
                                            let _e2377 = phi_2558_;
                                            phi_2559_ = _e2377;
                                        } else {
                                            phi_2559_ = true;
                                        }
                                        let _e2379 = phi_2559_;
                                        phi_2560_ = _e2379;
                                    } else {
                                        phi_2560_ = true;
                                    }
                                    let _e2381 = phi_2560_;
                                    phi_2561_ = _e2381;
                                } else {
                                    phi_2561_ = true;
                                }
                                let _e2383 = phi_2561_;
                                if _e2383 {
                                }
                                phi_1020_ = (_e909 & (_e909 - 1u));
                                phi_2565_ = _e2383;
                            }
                            let _e2385 = phi_1020_;
                            let _e2387 = phi_2565_;
                            continue;
                            continuing {
                                phi_1019_ = _e2385;
                                break if !(_e2387);
                            }
                        }
                        let _e2390 = local_10;
                        if _e2390 {
                            let _e2392 = local_1.group_mask;
                            if ((_e2392 & 4278190080u) == 0u) {
                                let _e2396 = local_1.len;
                                if (_e2396 == 0u) {
                                    phi_2607_ = false;
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
                                    phi_2607_ = true;
                                }
                                let _e2419 = phi_2607_;
                                phi_2608_ = _e2419;
                            } else {
                                phi_2608_ = true;
                            }
                            let _e2421 = phi_2608_;
                            if _e2421 {
                                let _e2423 = local_1.group_mask;
                                let _e2429 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2423)), 32u, (_e2423 == 0u)));
                                let _e2433 = local_1.group_mask;
                                let _e2447 = local_1.group_mask;
                                local_1.group_mask = (_e2447 & ~((1u << bitcast<u32>((_e2429 & 31u)))));
                                let _e2450 = local_1.group;
                                phi_2639_ = (_e2450 + countOneBits(((_e2433 & ~((4294967295u << bitcast<u32>((((_e2429 - 24u) ^ _e335) & 31u))))) & 255u)));
                            } else {
                                phi_2639_ = 4294967295u;
                            }
                            let _e2453 = phi_2639_;
                            phi_2640_ = _e2453;
                        } else {
                            phi_2640_ = u32();
                        }
                        let _e2455 = phi_2640_;
                        phi_690_ = _e2455;
                        let _e2748 = local_17;
                        phi_2641_ = _e2748;
                        phi_2642_ = false;
                    } else {
                        phi_690_ = u32();
                        phi_2641_ = false;
                        phi_2642_ = true;
                    }
                    let _e2457 = phi_690_;
                    let _e2459 = phi_2641_;
                    let _e2461 = phi_2642_;
                    local_11 = _e2461;
                    continue;
                    continuing {
                        phi_689_ = _e2457;
                        break if !(_e2459);
                    }
                }
                let _e2464 = local_11;
                if _e2464 {
                    phi_2646_ = false;
                } else {
                    phi_2646_ = true;
                }
                let _e2466 = phi_2646_;
                if _e2466 {
                    phi_2650_ = true;
                } else {
                    phi_2650_ = false;
                }
                let _e2468 = phi_2650_;
                phi_2651_ = _e2468;
            }
            let _e2470 = phi_2651_;
            phi_2652_ = _e2470;
            phi_2653_ = _e182;
        } else {
            phi_2652_ = bool();
            phi_2653_ = true;
        }
        let _e2472 = phi_2652_;
        let _e2474 = phi_2653_;
        if _e2474 {
            phi_2657_ = false;
        } else {
            phi_2657_ = _e2472;
        }
        let _e2476 = phi_2657_;
        if _e2476 {
            phi_2661_ = 0f;
        } else {
            phi_2661_ = 1f;
        }
        let _e2478 = phi_2661_;
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
