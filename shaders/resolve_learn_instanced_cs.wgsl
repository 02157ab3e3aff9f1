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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_36 {
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

struct type_40 {
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

struct type_50 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_50;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_164_: bool;
    var phi_168_: f32;

    if (param != param) {
        phi_164_ = true;
    } else {
        let _e56 = (param_1 >= param);
        if _e56 {
        }
        phi_164_ = _e56;
    }
    let _e58 = phi_164_;
    if _e58 {
        phi_168_ = param_1;
    } else {
        phi_168_ = param;
    }
    let _e60 = phi_168_;
    return _e60;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_180_: bool;
    var phi_184_: f32;

    if (param_2 != param_2) {
        phi_180_ = true;
    } else {
        let _e56 = (param_3 <= param_2);
        if _e56 {
        }
        phi_180_ = _e56;
    }
    let _e58 = phi_180_;
    if _e58 {
        phi_184_ = param_3;
    } else {
        phi_184_ = param_2;
    }
    let _e60 = phi_184_;
    return _e60;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_268_: f32;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
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
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_351_: bool;
    var phi_355_: bool;
    var phi_425_: f32;
    var phi_432_: f32;
    var phi_439_: f32;
    var phi_446_: f32;
    var phi_453_: f32;
    var phi_460_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_487_: f32;
    var phi_508_: u32;
    var phi_513_: u32;
    var phi_518_: u32;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_664_: u32;
    var phi_666_: u32;
    var phi_669_: bool;
    var phi_749_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_776_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_803_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_809_: u32;
    var phi_812_: u32;
    var phi_826_: u32;
    var phi_836_: u32;
    var phi_846_: u32;
    var phi_864_: u32;
    var phi_874_: u32;
    var phi_884_: u32;
    var phi_920_: u32;
    var phi_933_: u32;
    var phi_938_: u32;
    var phi_939_: u32;
    var phi_940_: u32;
    var phi_810_: u32;
    var phi_813_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_998_: u32;
    var phi_1001_: bool;
    var phi_1050_: f32;
    var phi_1055_: f32;
    var phi_1060_: f32;
    var phi_1068_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1224_: bool;
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
    var phi_1245_: bool;
    var phi_1249_: bool;
    var phi_1253_: bool;
    var phi_1323_: f32;
    var phi_1330_: f32;
    var phi_1337_: f32;
    var phi_1344_: f32;
    var phi_1351_: f32;
    var phi_1358_: f32;
    var phi_1375_: f32;
    var phi_1380_: f32;
    var phi_1385_: f32;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1422_: u32;
    var phi_1423_: u32;
    var phi_1434_: vec3<f32>;
    var phi_1435_: vec3<f32>;
    var phi_1448_: u32;
    var phi_1453_: u32;
    var phi_1458_: u32;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1604_: u32;
    var phi_1606_: u32;
    var phi_1609_: bool;
    var phi_1689_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1716_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1743_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1749_: u32;
    var phi_1752_: u32;
    var phi_1766_: u32;
    var phi_1776_: u32;
    var phi_1786_: u32;
    var phi_1804_: u32;
    var phi_1814_: u32;
    var phi_1824_: u32;
    var phi_1860_: u32;
    var phi_1873_: u32;
    var phi_1878_: u32;
    var phi_1879_: u32;
    var phi_1880_: u32;
    var phi_1750_: u32;
    var phi_1753_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1938_: u32;
    var phi_1941_: bool;
    var phi_1985_: vec3<f32>;
    var phi_1986_: vec3<f32>;
    var phi_2015_: vec3<f32>;
    var phi_2016_: vec3<f32>;
    var phi_2045_: vec3<f32>;
    var phi_2046_: vec3<f32>;
    var phi_2064_: bool;
    var phi_2065_: bool;
    var phi_2069_: f32;
    var phi_2070_: f32;
    var phi_2071_: f32;
    var phi_2072_: f32;
    var phi_2080_: f32;
    var phi_2090_: bool;
    var phi_2091_: bool;
    var phi_2095_: f32;
    var phi_2096_: f32;
    var phi_2097_: f32;
    var phi_2098_: f32;
    var phi_2106_: f32;
    var phi_2116_: bool;
    var phi_2117_: bool;
    var phi_2121_: f32;
    var phi_2122_: f32;
    var phi_2123_: f32;
    var phi_2124_: f32;
    var phi_2132_: f32;
    var phi_2147_: f32;
    var phi_2148_: bool;
    var phi_2149_: f32;
    var phi_2150_: bool;
    var phi_2151_: f32;
    var phi_2152_: bool;
    var phi_2170_: f32;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2173_: f32;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2179_: bool;
    var phi_2180_: f32;
    var phi_2181_: bool;
    var phi_2209_: vec3<f32>;
    var phi_2210_: vec3<f32>;
    var phi_2235_: vec3<f32>;
    var phi_2236_: vec3<f32>;
    var phi_2261_: vec3<f32>;
    var phi_2262_: vec3<f32>;
    var phi_2318_: f32;
    var phi_2327_: f32;
    var phi_2336_: f32;
    var phi_2345_: f32;
    var phi_2352_: f32;
    var phi_2359_: f32;
    var phi_2372_: f32;
    var phi_2381_: f32;
    var phi_2390_: f32;
    var phi_2399_: f32;
    var phi_2406_: f32;
    var phi_2413_: f32;
    var phi_2430_: f32;
    var phi_2435_: f32;
    var phi_2440_: f32;
    var phi_2448_: f32;
    var phi_2453_: f32;
    var phi_2458_: f32;
    var phi_2470_: f32;
    var phi_2475_: f32;
    var phi_2480_: f32;
    var phi_2485_: f32;
    var phi_2490_: lt_bvh_triangle_Intersection;
    var phi_2491_: bool;
    var phi_2492_: lt_bvh_triangle_Intersection;
    var phi_2493_: bool;
    var phi_2497_: lt_bvh_triangle_Intersection;
    var phi_2498_: bool;
    var phi_2499_: lt_bvh_triangle_Intersection;
    var phi_2500_: bool;
    var phi_2501_: bool;
    var phi_2505_: bool;
    var phi_2509_: lt_bvh_triangle_Intersection;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_1939_: u32;
    var phi_1942_: bool;
    var phi_2539_: bool;
    var local_8: bool;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_1607_: u32;
    var phi_1610_: bool;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var local_9: bool;
    var phi_2620_: bool;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2631_: bool;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_999_: u32;
    var phi_1002_: bool;
    var phi_2645_: bool;
    var local_10: bool;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2719_: u32;
    var phi_2720_: u32;
    var phi_667_: u32;
    var phi_670_: bool;
    var phi_2721_: bool;
    var phi_2722_: bool;
    var local_11: bool;
    var phi_2726_: bool;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var phi_2732_: bool;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2741_: bool;
    var phi_2745_: f32;
    var phi_2766_: u32;
    var phi_2781_: u32;
    var phi_2786_: u32;
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
        let _e97 = p.member.light;
        let _e99 = samples.member[(0u + _e90)].position;
        let _e101 = samples.member[(0u + _e90)].normal;
        let _e103 = samples.member[(0u + _e90)].magnitude;
        let _e105 = ((8f / 8388608f) * _e103);
        let _e113 = (_e99.x + (_e101.x * _e105));
        let _e115 = (_e99.y + (_e101.y * _e105));
        let _e117 = (_e99.z + (_e101.z * _e105));
        if (_e97.w == 0f) {
            phi_268_ = 300000000000000000000000000000000000000f;
        } else {
            phi_268_ = 1f;
        }
        let _e121 = phi_268_;
        let _e129 = (_e97.x - (_e113 * _e97.w));
        let _e130 = (_e97.y - (_e115 * _e97.w));
        let _e131 = (_e97.z - (_e117 * _e97.w));
        let _e135 = abs(_e129);
        let _e136 = abs(_e130);
        let _e137 = abs(_e131);
        if (abs(_e113) < 1000000000000000f) {
            if (abs(_e115) < 1000000000000000f) {
                if (abs(_e117) < 1000000000000000f) {
                    if (_e135 < 1000000000000000f) {
                        if (_e136 < 1000000000000000f) {
                            if (_e137 < 1000000000000000f) {
                                if (_e135 > 0f) {
                                    phi_325_ = bool();
                                    phi_326_ = true;
                                } else {
                                    let _e145 = (_e136 > 0f);
                                    if _e145 {
                                        phi_324_ = bool();
                                    } else {
                                        phi_324_ = (_e137 > 0f);
                                    }
                                    let _e148 = phi_324_;
                                    phi_325_ = _e148;
                                    phi_326_ = _e145;
                                }
                                let _e150 = phi_325_;
                                let _e152 = phi_326_;
                                if _e152 {
                                    phi_330_ = true;
                                } else {
                                    phi_330_ = _e150;
                                }
                                let _e154 = phi_330_;
                                phi_331_ = _e154;
                                phi_332_ = false;
                            } else {
                                phi_331_ = bool();
                                phi_332_ = true;
                            }
                            let _e156 = phi_331_;
                            let _e158 = phi_332_;
                            phi_333_ = _e156;
                            phi_334_ = false;
                            phi_335_ = _e158;
                        } else {
                            phi_333_ = bool();
                            phi_334_ = true;
                            phi_335_ = false;
                        }
                        let _e160 = phi_333_;
                        let _e162 = phi_334_;
                        let _e164 = phi_335_;
                        phi_336_ = _e160;
                        phi_337_ = _e162;
                        phi_338_ = _e164;
                    } else {
                        phi_336_ = bool();
                        phi_337_ = true;
                        phi_338_ = false;
                    }
                    let _e166 = phi_336_;
                    let _e168 = phi_337_;
                    let _e170 = phi_338_;
                    phi_339_ = _e166;
                    phi_340_ = _e168;
                    phi_341_ = _e170;
                } else {
                    phi_339_ = bool();
                    phi_340_ = true;
                    phi_341_ = false;
                }
                let _e172 = phi_339_;
                let _e174 = phi_340_;
                let _e176 = phi_341_;
                phi_342_ = _e172;
                phi_343_ = _e174;
                phi_344_ = _e176;
            } else {
                phi_342_ = bool();
                phi_343_ = true;
                phi_344_ = false;
            }
            let _e178 = phi_342_;
            let _e180 = phi_343_;
            let _e182 = phi_344_;
            phi_345_ = _e178;
            phi_346_ = _e180;
            phi_347_ = _e182;
        } else {
            phi_345_ = bool();
            phi_346_ = true;
            phi_347_ = false;
        }
        let _e184 = phi_345_;
        let _e186 = phi_346_;
        let _e188 = phi_347_;
        if _e186 {
            phi_351_ = true;
        } else {
            phi_351_ = _e188;
        }
        let _e190 = phi_351_;
        if _e190 {
            phi_355_ = false;
        } else {
            phi_355_ = _e184;
        }
        let _e192 = phi_355_;
        if _e192 {
            let _e193 = (_e92 >= _e62);
            if _e193 {
                phi_2730_ = false;
            } else {
                if (_e92 < _e62) {
                } else {
                    return;
                }
                let _e199 = nodes.member[(0u + _e92)].frame[0u];
                let _e203 = nodes.member[(0u + _e92)].frame[1u];
                let _e207 = nodes.member[(0u + _e92)].frame[2u];
                let _e211 = nodes.member[(0u + _e92)].frame[0u];
                let _e215 = nodes.member[(0u + _e92)].frame[1u];
                let _e219 = nodes.member[(0u + _e92)].frame[2u];
                let _e223 = nodes.member[(0u + _e92)].frame[3u];
                let _e257 = core_intrinsics_maximum_number_nsz_f32_(abs(_e129), abs(_e130));
                let _e258 = core_intrinsics_maximum_number_nsz_f32_(_e257, abs(_e131));
                let _e259 = (_e258 * 0.0000000000009094947f);
                if (abs(_e129) < _e259) {
                    phi_425_ = _e259;
                } else {
                    phi_425_ = abs(_e129);
                }
                let _e264 = phi_425_;
                if (_e129 < 0f) {
                    phi_432_ = (-1f / _e264);
                } else {
                    phi_432_ = (1f / _e264);
                }
                let _e269 = phi_432_;
                if (abs(_e130) < _e259) {
                    phi_439_ = _e259;
                } else {
                    phi_439_ = abs(_e130);
                }
                let _e274 = phi_439_;
                if (_e130 < 0f) {
                    phi_446_ = (-1f / _e274);
                } else {
                    phi_446_ = (1f / _e274);
                }
                let _e279 = phi_446_;
                if (abs(_e131) < _e259) {
                    phi_453_ = _e259;
                } else {
                    phi_453_ = abs(_e131);
                }
                let _e284 = phi_453_;
                if (_e131 < 0f) {
                    phi_460_ = (-1f / _e284);
                } else {
                    phi_460_ = (1f / _e284);
                }
                let _e289 = phi_460_;
                let _e293 = abs((bitcast<f32>(_e199) - _e113));
                let _e294 = abs((bitcast<f32>(_e203) - _e115));
                let _e295 = abs((bitcast<f32>(_e207) - _e117));
                let _e299 = abs(((bitcast<f32>(_e211) + (bitcast<f32>((((_e223 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                let _e300 = abs(((bitcast<f32>(_e215) + (bitcast<f32>((((_e223 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e115));
                let _e301 = abs(((bitcast<f32>(_e219) + (bitcast<f32>((((_e223 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e117));
                if (_e293 > _e299) {
                    phi_477_ = _e293;
                } else {
                    phi_477_ = _e299;
                }
                let _e304 = phi_477_;
                if (_e294 > _e300) {
                    phi_482_ = _e294;
                } else {
                    phi_482_ = _e300;
                }
                let _e307 = phi_482_;
                if (_e295 > _e301) {
                    phi_487_ = _e295;
                } else {
                    phi_487_ = _e301;
                }
                let _e310 = phi_487_;
                let _e311 = core_intrinsics_maximum_number_nsz_f32_(_e304, _e307);
                let _e312 = core_intrinsics_maximum_number_nsz_f32_(_e311, _e310);
                let _e316 = (_e312 * 0.0000019073486f);
                let _e317 = (abs(_e269) * _e316);
                let _e318 = (abs(_e279) * _e316);
                let _e319 = (abs(_e289) * _e316);
                let _e323 = (_e312 * 0.0000009536743f);
                let _e324 = (abs(_e269) * _e323);
                let _e325 = (abs(_e279) * _e323);
                let _e326 = (abs(_e289) * _e323);
                if (_e269 < 0f) {
                    phi_508_ = 0u;
                } else {
                    phi_508_ = 1u;
                }
                let _e329 = phi_508_;
                if (_e279 < 0f) {
                    phi_513_ = 0u;
                } else {
                    phi_513_ = 2u;
                }
                let _e332 = phi_513_;
                if (_e289 < 0f) {
                    phi_518_ = 0u;
                } else {
                    phi_518_ = 4u;
                }
                let _e335 = phi_518_;
                let _e337 = ((_e329 | _e332) | _e335);
                let _e338 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e92, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e338.first[0], _e338.first[1], _e338.first[2], _e338.first[3], _e338.first[4], _e338.first[5], _e338.first[6], _e338.first[7], _e338.first[8], _e338.first[9], _e338.first[10], _e338.first[11], _e338.first[12], _e338.first[13], _e338.first[14], _e338.first[15], _e338.first[16], _e338.first[17], _e338.first[18], _e338.first[19], _e338.first[20], _e338.first[21], _e338.first[22], _e338.first[23], _e338.first[24], _e338.first[25], _e338.first[26], _e338.first[27], _e338.first[28], _e338.first[29], _e338.first[30], _e338.first[31]), array<u32, 32>(_e338.mask[0], _e338.mask[1], _e338.mask[2], _e338.mask[3], _e338.mask[4], _e338.mask[5], _e338.mask[6], _e338.mask[7], _e338.mask[8], _e338.mask[9], _e338.mask[10], _e338.mask[11], _e338.mask[12], _e338.mask[13], _e338.mask[14], _e338.mask[15], _e338.mask[16], _e338.mask[17], _e338.mask[18], _e338.mask[19], _e338.mask[20], _e338.mask[21], _e338.mask[22], _e338.mask[23], _e338.mask[24], _e338.mask[25], _e338.mask[26], _e338.mask[27], _e338.mask[28], _e338.mask[29], _e338.mask[30], _e338.mask[31]), _e338.len, _e338.group, _e338.group_mask);
                let _e412 = local_1.group_mask;
                if ((_e412 & 4278190080u) == 0u) {
                    let _e416 = local_1.len;
                    if (_e416 == 0u) {
                        phi_632_ = false;
                    } else {
                        let _e420 = local_1.len;
                        local_1.len = (_e420 - 1u);
                        let _e423 = local_1.len;
                        if (_e423 < 32u) {
                        } else {
                            return;
                        }
                        let _e428 = local_1.first[(0u + _e423)];
                        local_1.group = _e428;
                        let _e431 = local_1.len;
                        if (_e431 < 32u) {
                        } else {
                            return;
                        }
                        let _e436 = local_1.mask[(0u + _e431)];
                        local_1.group_mask = _e436;
                        phi_632_ = true;
                    }
                    let _e439 = phi_632_;
                    phi_633_ = _e439;
                } else {
                    phi_633_ = true;
                }
                let _e441 = phi_633_;
                if _e441 {
                    let _e443 = local_1.group_mask;
                    let _e449 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e443)), 32u, (_e443 == 0u)));
                    let _e453 = local_1.group_mask;
                    let _e467 = local_1.group_mask;
                    local_1.group_mask = (_e467 & ~((1u << bitcast<u32>((_e449 & 31u)))));
                    let _e470 = local_1.group;
                    phi_664_ = (_e470 + countOneBits(((_e453 & ~((4294967295u << bitcast<u32>((((_e449 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_664_ = 4294967295u;
                }
                let _e473 = phi_664_;
                phi_666_ = _e473;
                phi_669_ = false;
                loop {
                    let _e475 = phi_666_;
                    let _e477 = phi_669_;
                    if (_e475 != 4294967295u) {
                        if (_e475 < _e62) {
                        } else {
                            return;
                        }
                        let _e484 = nodes.member[(0u + _e475)].frame[3u];
                        let _e509 = (bitcast<f32>((((_e484 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e269);
                        let _e510 = (bitcast<f32>((((_e484 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e279);
                        let _e511 = (bitcast<f32>((((_e484 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e514 = nodes.member[(0u + _e475)].frame[0u];
                        let _e518 = nodes.member[(0u + _e475)].frame[1u];
                        let _e522 = nodes.member[(0u + _e475)].frame[2u];
                        let _e527 = ((bitcast<f32>(_e514) - _e113) * _e269);
                        let _e528 = ((bitcast<f32>(_e518) - _e115) * _e279);
                        let _e529 = ((bitcast<f32>(_e522) - _e117) * _e289);
                        let _e537 = nodes.member[(0u + _e475)].x;
                        if (_e269 < 0f) {
                            let _e548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e537.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e548.unnamed.root, _e537.w), _e548.unnamed_1);
                            let _e560 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e554.unnamed, lt_bvh_traverse_Tree(_e537.x, _e554.unnamed_1.first_primitive));
                            phi_749_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e560.unnamed, lt_bvh_traverse_Tree(_e560.unnamed_1.root, _e537.y));
                        } else {
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e537.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e576.unnamed.root, _e537.y), _e576.unnamed_1);
                            let _e588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e537.z, _e582.unnamed_1.first_primitive));
                            phi_749_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e588.unnamed, lt_bvh_traverse_Tree(_e588.unnamed_1.root, _e537.w));
                        }
                        let _e596 = phi_749_;
                        let _e606 = nodes.member[(0u + _e475)].y;
                        if (_e279 < 0f) {
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e617.unnamed.root, _e606.w), _e617.unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_bvh_traverse_Tree(_e606.x, _e623.unnamed_1.first_primitive));
                            phi_776_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e629.unnamed_1.root, _e606.y));
                        } else {
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e645.unnamed.root, _e606.y), _e645.unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e606.z, _e651.unnamed_1.first_primitive));
                            phi_776_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_bvh_traverse_Tree(_e657.unnamed_1.root, _e606.w));
                        }
                        let _e665 = phi_776_;
                        let _e675 = nodes.member[(0u + _e475)].z;
                        if (_e289 < 0f) {
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.unnamed.root, _e675.w), _e686.unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e675.x, _e692.unnamed_1.first_primitive));
                            phi_803_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e698.unnamed_1.root, _e675.y));
                        } else {
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.unnamed.root, _e675.y), _e714.unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e675.z, _e720.unnamed_1.first_primitive));
                            phi_803_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e726.unnamed_1.root, _e675.w));
                        }
                        let _e734 = phi_803_;
                        phi_809_ = 0u;
                        phi_812_ = 0u;
                        loop {
                            let _e744 = phi_809_;
                            let _e746 = phi_812_;
                            local_2 = _e746;
                            local_3 = _e746;
                            local_4 = _e746;
                            let _e747 = (_e744 < 8u);
                            if _e747 {
                                let _e749 = (_e744 >> bitcast<u32>(2i));
                                let _e750 = (_e744 & 3u);
                                if (_e749 == 0u) {
                                    phi_826_ = _e596.unnamed.root;
                                } else {
                                    phi_826_ = _e596.unnamed.first_primitive;
                                }
                                let _e753 = phi_826_;
                                if (_e749 == 0u) {
                                    phi_836_ = _e665.unnamed.root;
                                } else {
                                    phi_836_ = _e665.unnamed.first_primitive;
                                }
                                let _e762 = phi_836_;
                                if (_e749 == 0u) {
                                    phi_846_ = _e734.unnamed.root;
                                } else {
                                    phi_846_ = _e734.unnamed.first_primitive;
                                }
                                let _e771 = phi_846_;
                                let _e784 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e753 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e317)), ((f32(((_e762 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e510) + (_e528 - _e318)));
                                let _e785 = core_intrinsics_maximum_number_nsz_f32_(_e784, ((f32(((_e771 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e511) + (_e529 - _e319)));
                                if (_e749 == 0u) {
                                    phi_864_ = _e596.unnamed_1.root;
                                } else {
                                    phi_864_ = _e596.unnamed_1.first_primitive;
                                }
                                let _e788 = phi_864_;
                                if (_e749 == 0u) {
                                    phi_874_ = _e665.unnamed_1.root;
                                } else {
                                    phi_874_ = _e665.unnamed_1.first_primitive;
                                }
                                let _e797 = phi_874_;
                                if (_e749 == 0u) {
                                    phi_884_ = _e734.unnamed_1.root;
                                } else {
                                    phi_884_ = _e734.unnamed_1.first_primitive;
                                }
                                let _e806 = phi_884_;
                                let _e819 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e788 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e317)), ((f32(((_e797 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e510) + (_e528 + _e318)));
                                let _e820 = core_intrinsics_minimum_number_nsz_f32_(_e819, ((f32(((_e806 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e511) + (_e529 + _e319)));
                                if (_e785 <= _e820) {
                                    if (_e785 <= _e121) {
                                        if (_e820 >= 0f) {
                                            if (_e749 == 0u) {
                                                let _e827 = nodes.member[(0u + _e475)].links[2u];
                                                phi_920_ = _e827;
                                            } else {
                                                let _e830 = nodes.member[(0u + _e475)].links[3u];
                                                phi_920_ = _e830;
                                            }
                                            let _e832 = phi_920_;
                                            let _e837 = ((_e832 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u);
                                            let _e838 = (_e837 & 31u);
                                            if (_e838 >= 24u) {
                                                phi_933_ = (24u + ((_e838 - 24u) ^ _e337));
                                            } else {
                                                phi_933_ = _e838;
                                            }
                                            let _e844 = phi_933_;
                                            phi_938_ = (_e746 | ((_e837 >> bitcast<u32>(5i)) << bitcast<u32>((_e844 & 31u))));
                                        } else {
                                            phi_938_ = _e746;
                                        }
                                        let _e852 = phi_938_;
                                        phi_939_ = _e852;
                                    } else {
                                        phi_939_ = _e746;
                                    }
                                    let _e854 = phi_939_;
                                    phi_940_ = _e854;
                                } else {
                                    phi_940_ = _e746;
                                }
                                let _e856 = phi_940_;
                                phi_810_ = (_e744 + 1u);
                                phi_813_ = _e856;
                            } else {
                                phi_810_ = u32();
                                phi_813_ = u32();
                            }
                            let _e859 = phi_810_;
                            let _e861 = phi_813_;
                            continue;
                            continuing {
                                phi_809_ = _e859;
                                phi_812_ = _e861;
                                break if !(_e747);
                            }
                        }
                        let _e865 = nodes.member[(0u + _e475)].links[0u];
                        let _e869 = nodes.member[(0u + _e475)].frame[3u];
                        let _e873 = local_2;
                        if ((_e873 & 4278190080u) == 0u) {
                        } else {
                            let _e877 = local_1.group_mask;
                            if ((_e877 & 4278190080u) == 0u) {
                            } else {
                                let _e881 = local_1.len;
                                if (_e881 < 32u) {
                                    let _e884 = local_1.group;
                                    let _e886 = local_1.len;
                                    if (_e886 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e886)] = _e884;
                                    let _e892 = local_1.group_mask;
                                    let _e894 = local_1.len;
                                    if (_e894 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e894)] = _e892;
                                    let _e901 = local_1.len;
                                    local_1.len = (_e901 + 1u);
                                }
                            }
                            local_1.group = (_e92 + _e865);
                            let _e905 = local_3;
                            local_1.group_mask = ((_e905 & 4278190080u) | (_e869 >> bitcast<u32>(24i)));
                        }
                        let _e910 = local_4;
                        phi_998_ = (_e910 & 16777215u);
                        phi_1001_ = _e477;
                        loop {
                            let _e913 = phi_998_;
                            let _e915 = phi_1001_;
                            local_15 = _e915;
                            let _e916 = (_e913 == 0u);
                            local_10 = _e916;
                            local_16 = _e916;
                            if _e916 {
                                phi_999_ = u32();
                                phi_1002_ = bool();
                                phi_2645_ = false;
                            } else {
                                let _e919 = nodes.member[(0u + _e475)].links[1u];
                                let _e923 = (_e919 + select(firstTrailingBit(_e913), 32u, (_e913 == 0u)));
                                if (_e923 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e930 = instances.member[(0u + _e923)].low_world;
                                let _e932 = instances.member[(0u + _e923)].high_world;
                                let _e939 = ((_e930.x - _e113) * _e269);
                                let _e940 = ((_e930.y - _e115) * _e279);
                                let _e941 = ((_e930.z - _e117) * _e289);
                                let _e948 = ((_e932.x - _e113) * _e269);
                                let _e949 = ((_e932.y - _e115) * _e279);
                                let _e950 = ((_e932.z - _e117) * _e289);
                                if (_e939 < _e948) {
                                    phi_1050_ = _e939;
                                } else {
                                    phi_1050_ = _e948;
                                }
                                let _e953 = phi_1050_;
                                if (_e940 < _e949) {
                                    phi_1055_ = _e940;
                                } else {
                                    phi_1055_ = _e949;
                                }
                                let _e956 = phi_1055_;
                                if (_e941 < _e950) {
                                    phi_1060_ = _e941;
                                } else {
                                    phi_1060_ = _e950;
                                }
                                let _e959 = phi_1060_;
                                if (_e939 > _e948) {
                                    phi_1068_ = _e939;
                                } else {
                                    phi_1068_ = _e948;
                                }
                                let _e965 = phi_1068_;
                                if (_e940 > _e949) {
                                    phi_1073_ = _e940;
                                } else {
                                    phi_1073_ = _e949;
                                }
                                let _e968 = phi_1073_;
                                if (_e941 > _e950) {
                                    phi_1078_ = _e941;
                                } else {
                                    phi_1078_ = _e950;
                                }
                                let _e971 = phi_1078_;
                                let _e975 = core_intrinsics_maximum_number_nsz_f32_((_e953 - _e324), (_e956 - _e325));
                                let _e976 = core_intrinsics_maximum_number_nsz_f32_(_e975, (_e959 - _e326));
                                let _e977 = core_intrinsics_minimum_number_nsz_f32_((_e965 + _e324), (_e968 + _e325));
                                let _e978 = core_intrinsics_minimum_number_nsz_f32_(_e977, (_e971 + _e326));
                                if (_e976 <= _e978) {
                                    if (_e976 <= _e121) {
                                        if (_e978 >= 0f) {
                                            let _e984 = instances.member[(0u + _e923)].world_to_object[0u];
                                            let _e995 = ((((_e984.x * _e113) + (_e984.y * _e115)) + (_e984.z * _e117)) + (_e984.w * 1f));
                                            let _e997 = instances.member[(0u + _e923)].world_to_object[1u];
                                            let _e1008 = ((((_e997.x * _e113) + (_e997.y * _e115)) + (_e997.z * _e117)) + (_e997.w * 1f));
                                            let _e1010 = instances.member[(0u + _e923)].world_to_object[2u];
                                            let _e1021 = ((((_e1010.x * _e113) + (_e1010.y * _e115)) + (_e1010.z * _e117)) + (_e1010.w * 1f));
                                            let _e1024 = instances.member[(0u + _e923)].world_to_object[0u];
                                            let _e1035 = ((((_e1024.x * _e129) + (_e1024.y * _e130)) + (_e1024.z * _e131)) + (_e1024.w * 0f));
                                            let _e1037 = instances.member[(0u + _e923)].world_to_object[1u];
                                            let _e1048 = ((((_e1037.x * _e129) + (_e1037.y * _e130)) + (_e1037.z * _e131)) + (_e1037.w * 0f));
                                            let _e1050 = instances.member[(0u + _e923)].world_to_object[2u];
                                            let _e1061 = ((((_e1050.x * _e129) + (_e1050.y * _e130)) + (_e1050.z * _e131)) + (_e1050.w * 0f));
                                            let _e1064 = instances.member[(0u + _e923)].root;
                                            let _e1066 = instances.member[(0u + _e923)].first_triangle;
                                            let _e1070 = abs(_e1035);
                                            let _e1071 = abs(_e1048);
                                            let _e1072 = abs(_e1061);
                                            if (abs(_e995) < 1000000000000000f) {
                                                if (abs(_e1008) < 1000000000000000f) {
                                                    if (abs(_e1021) < 1000000000000000f) {
                                                        if (_e1070 < 1000000000000000f) {
                                                            if (_e1071 < 1000000000000000f) {
                                                                if (_e1072 < 1000000000000000f) {
                                                                    if (_e1070 > 0f) {
                                                                        phi_1223_ = bool();
                                                                        phi_1224_ = true;
                                                                    } else {
                                                                        let _e1080 = (_e1071 > 0f);
                                                                        if _e1080 {
                                                                            phi_1222_ = bool();
                                                                        } else {
                                                                            phi_1222_ = (_e1072 > 0f);
                                                                        }
                                                                        let _e1083 = phi_1222_;
                                                                        phi_1223_ = _e1083;
                                                                        phi_1224_ = _e1080;
                                                                    }
                                                                    let _e1085 = phi_1223_;
                                                                    let _e1087 = phi_1224_;
                                                                    if _e1087 {
                                                                        phi_1228_ = true;
                                                                    } else {
                                                                        phi_1228_ = _e1085;
                                                                    }
                                                                    let _e1089 = phi_1228_;
                                                                    phi_1229_ = _e1089;
                                                                    phi_1230_ = false;
                                                                } else {
                                                                    phi_1229_ = bool();
                                                                    phi_1230_ = true;
                                                                }
                                                                let _e1091 = phi_1229_;
                                                                let _e1093 = phi_1230_;
                                                                phi_1231_ = _e1091;
                                                                phi_1232_ = false;
                                                                phi_1233_ = _e1093;
                                                            } else {
                                                                phi_1231_ = bool();
                                                                phi_1232_ = true;
                                                                phi_1233_ = false;
                                                            }
                                                            let _e1095 = phi_1231_;
                                                            let _e1097 = phi_1232_;
                                                            let _e1099 = phi_1233_;
                                                            phi_1234_ = _e1095;
                                                            phi_1235_ = _e1097;
                                                            phi_1236_ = _e1099;
                                                        } else {
                                                            phi_1234_ = bool();
                                                            phi_1235_ = true;
                                                            phi_1236_ = false;
                                                        }
                                                        let _e1101 = phi_1234_;
                                                        let _e1103 = phi_1235_;
                                                        let _e1105 = phi_1236_;
                                                        phi_1237_ = _e1101;
                                                        phi_1238_ = _e1103;
                                                        phi_1239_ = _e1105;
                                                    } else {
                                                        phi_1237_ = bool();
                                                        phi_1238_ = true;
                                                        phi_1239_ = false;
                                                    }
                                                    let _e1107 = phi_1237_;
                                                    let _e1109 = phi_1238_;
                                                    let _e1111 = phi_1239_;
                                                    phi_1240_ = _e1107;
                                                    phi_1241_ = _e1109;
                                                    phi_1242_ = _e1111;
                                                } else {
                                                    phi_1240_ = bool();
                                                    phi_1241_ = true;
                                                    phi_1242_ = false;
                                                }
                                                let _e1113 = phi_1240_;
                                                let _e1115 = phi_1241_;
                                                let _e1117 = phi_1242_;
                                                phi_1243_ = _e1113;
                                                phi_1244_ = _e1115;
                                                phi_1245_ = _e1117;
                                            } else {
                                                phi_1243_ = bool();
                                                phi_1244_ = true;
                                                phi_1245_ = false;
                                            }
                                            let _e1119 = phi_1243_;
                                            let _e1121 = phi_1244_;
                                            let _e1123 = phi_1245_;
                                            if _e1121 {
                                                phi_1249_ = true;
                                            } else {
                                                phi_1249_ = _e1123;
                                            }
                                            let _e1125 = phi_1249_;
                                            if _e1125 {
                                                phi_1253_ = false;
                                            } else {
                                                phi_1253_ = _e1119;
                                            }
                                            let _e1127 = phi_1253_;
                                            if _e1127 {
                                                let _e1128 = (_e1064 >= _e62);
                                                if _e1128 {
                                                    phi_2625_ = bool();
                                                } else {
                                                    if (_e1064 < _e62) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1134 = nodes.member[(0u + _e1064)].frame[0u];
                                                    let _e1138 = nodes.member[(0u + _e1064)].frame[1u];
                                                    let _e1142 = nodes.member[(0u + _e1064)].frame[2u];
                                                    let _e1146 = nodes.member[(0u + _e1064)].frame[0u];
                                                    let _e1150 = nodes.member[(0u + _e1064)].frame[1u];
                                                    let _e1154 = nodes.member[(0u + _e1064)].frame[2u];
                                                    let _e1158 = nodes.member[(0u + _e1064)].frame[3u];
                                                    let _e1192 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1035), abs(_e1048));
                                                    let _e1193 = core_intrinsics_maximum_number_nsz_f32_(_e1192, abs(_e1061));
                                                    let _e1194 = (_e1193 * 0.0000000000009094947f);
                                                    if (abs(_e1035) < _e1194) {
                                                        phi_1323_ = _e1194;
                                                    } else {
                                                        phi_1323_ = abs(_e1035);
                                                    }
                                                    let _e1199 = phi_1323_;
                                                    if (_e1035 < 0f) {
                                                        phi_1330_ = (-1f / _e1199);
                                                    } else {
                                                        phi_1330_ = (1f / _e1199);
                                                    }
                                                    let _e1204 = phi_1330_;
                                                    if (abs(_e1048) < _e1194) {
                                                        phi_1337_ = _e1194;
                                                    } else {
                                                        phi_1337_ = abs(_e1048);
                                                    }
                                                    let _e1209 = phi_1337_;
                                                    if (_e1048 < 0f) {
                                                        phi_1344_ = (-1f / _e1209);
                                                    } else {
                                                        phi_1344_ = (1f / _e1209);
                                                    }
                                                    let _e1214 = phi_1344_;
                                                    if (abs(_e1061) < _e1194) {
                                                        phi_1351_ = _e1194;
                                                    } else {
                                                        phi_1351_ = abs(_e1061);
                                                    }
                                                    let _e1219 = phi_1351_;
                                                    if (_e1061 < 0f) {
                                                        phi_1358_ = (-1f / _e1219);
                                                    } else {
                                                        phi_1358_ = (1f / _e1219);
                                                    }
                                                    let _e1224 = phi_1358_;
                                                    let _e1228 = abs((bitcast<f32>(_e1134) - _e995));
                                                    let _e1229 = abs((bitcast<f32>(_e1138) - _e1008));
                                                    let _e1230 = abs((bitcast<f32>(_e1142) - _e1021));
                                                    let _e1234 = abs(((bitcast<f32>(_e1146) + (bitcast<f32>((((_e1158 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e995));
                                                    let _e1235 = abs(((bitcast<f32>(_e1150) + (bitcast<f32>((((_e1158 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1008));
                                                    let _e1236 = abs(((bitcast<f32>(_e1154) + (bitcast<f32>((((_e1158 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1021));
                                                    if (_e1228 > _e1234) {
                                                        phi_1375_ = _e1228;
                                                    } else {
                                                        phi_1375_ = _e1234;
                                                    }
                                                    let _e1239 = phi_1375_;
                                                    if (_e1229 > _e1235) {
                                                        phi_1380_ = _e1229;
                                                    } else {
                                                        phi_1380_ = _e1235;
                                                    }
                                                    let _e1242 = phi_1380_;
                                                    if (_e1230 > _e1236) {
                                                        phi_1385_ = _e1230;
                                                    } else {
                                                        phi_1385_ = _e1236;
                                                    }
                                                    let _e1245 = phi_1385_;
                                                    let _e1246 = core_intrinsics_maximum_number_nsz_f32_(_e1239, _e1242);
                                                    let _e1247 = core_intrinsics_maximum_number_nsz_f32_(_e1246, _e1245);
                                                    let _e1251 = (_e1247 * 0.0000019073486f);
                                                    let _e1252 = (abs(_e1204) * _e1251);
                                                    let _e1253 = (abs(_e1214) * _e1251);
                                                    let _e1254 = (abs(_e1224) * _e1251);
                                                    let _e1258 = (_e1247 * 0.0000009536743f);
                                                    let _e1259 = (abs(_e1204) * _e1258);
                                                    let _e1260 = (abs(_e1214) * _e1258);
                                                    let _e1261 = (abs(_e1224) * _e1258);
                                                    let _e1262 = abs(_e1035);
                                                    let _e1263 = abs(_e1048);
                                                    let _e1264 = abs(_e1061);
                                                    if (_e1262 >= _e1263) {
                                                        if (_e1262 >= _e1264) {
                                                            phi_1413_ = false;
                                                        } else {
                                                            phi_1413_ = true;
                                                        }
                                                        let _e1268 = phi_1413_;
                                                        phi_1414_ = _e1268;
                                                    } else {
                                                        phi_1414_ = true;
                                                    }
                                                    let _e1270 = phi_1414_;
                                                    if _e1270 {
                                                        if (_e1263 >= _e1264) {
                                                            phi_1422_ = 1u;
                                                        } else {
                                                            phi_1422_ = 2u;
                                                        }
                                                        let _e1273 = phi_1422_;
                                                        phi_1423_ = _e1273;
                                                    } else {
                                                        phi_1423_ = 0u;
                                                    }
                                                    let _e1275 = phi_1423_;
                                                    if (_e1275 == 0u) {
                                                        phi_1435_ = vec3<f32>(_e1048, _e1061, _e1035);
                                                    } else {
                                                        if (_e1275 == 1u) {
                                                            phi_1434_ = vec3<f32>(_e1061, _e1035, _e1048);
                                                        } else {
                                                            phi_1434_ = vec3<f32>(_e1035, _e1048, _e1061);
                                                        }
                                                        let _e1281 = phi_1434_;
                                                        phi_1435_ = _e1281;
                                                    }
                                                    let _e1283 = phi_1435_;
                                                    let _e1286 = (_e1283.x / _e1283.z);
                                                    let _e1289 = (_e1283.y / _e1283.z);
                                                    if (_e1204 < 0f) {
                                                        phi_1448_ = 0u;
                                                    } else {
                                                        phi_1448_ = 1u;
                                                    }
                                                    let _e1294 = phi_1448_;
                                                    if (_e1214 < 0f) {
                                                        phi_1453_ = 0u;
                                                    } else {
                                                        phi_1453_ = 2u;
                                                    }
                                                    let _e1297 = phi_1453_;
                                                    if (_e1224 < 0f) {
                                                        phi_1458_ = 0u;
                                                    } else {
                                                        phi_1458_ = 4u;
                                                    }
                                                    let _e1300 = phi_1458_;
                                                    let _e1302 = ((_e1294 | _e1297) | _e1300);
                                                    let _e1303 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1064, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1303.first[0], _e1303.first[1], _e1303.first[2], _e1303.first[3], _e1303.first[4], _e1303.first[5], _e1303.first[6], _e1303.first[7], _e1303.first[8], _e1303.first[9], _e1303.first[10], _e1303.first[11], _e1303.first[12], _e1303.first[13], _e1303.first[14], _e1303.first[15], _e1303.first[16], _e1303.first[17], _e1303.first[18], _e1303.first[19], _e1303.first[20], _e1303.first[21], _e1303.first[22], _e1303.first[23], _e1303.first[24], _e1303.first[25], _e1303.first[26], _e1303.first[27], _e1303.first[28], _e1303.first[29], _e1303.first[30], _e1303.first[31]), array<u32, 32>(_e1303.mask[0], _e1303.mask[1], _e1303.mask[2], _e1303.mask[3], _e1303.mask[4], _e1303.mask[5], _e1303.mask[6], _e1303.mask[7], _e1303.mask[8], _e1303.mask[9], _e1303.mask[10], _e1303.mask[11], _e1303.mask[12], _e1303.mask[13], _e1303.mask[14], _e1303.mask[15], _e1303.mask[16], _e1303.mask[17], _e1303.mask[18], _e1303.mask[19], _e1303.mask[20], _e1303.mask[21], _e1303.mask[22], _e1303.mask[23], _e1303.mask[24], _e1303.mask[25], _e1303.mask[26], _e1303.mask[27], _e1303.mask[28], _e1303.mask[29], _e1303.mask[30], _e1303.mask[31]), _e1303.len, _e1303.group, _e1303.group_mask);
                                                    let _e1377 = local.group_mask;
                                                    if ((_e1377 & 4278190080u) == 0u) {
                                                        let _e1381 = local.len;
                                                        if (_e1381 == 0u) {
                                                            phi_1572_ = false;
                                                        } else {
                                                            let _e1385 = local.len;
                                                            local.len = (_e1385 - 1u);
                                                            let _e1388 = local.len;
                                                            if (_e1388 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1393 = local.first[(0u + _e1388)];
                                                            local.group = _e1393;
                                                            let _e1396 = local.len;
                                                            if (_e1396 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1401 = local.mask[(0u + _e1396)];
                                                            local.group_mask = _e1401;
                                                            phi_1572_ = true;
                                                        }
                                                        let _e1404 = phi_1572_;
                                                        phi_1573_ = _e1404;
                                                    } else {
                                                        phi_1573_ = true;
                                                    }
                                                    let _e1406 = phi_1573_;
                                                    if _e1406 {
                                                        let _e1408 = local.group_mask;
                                                        let _e1414 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1408)), 32u, (_e1408 == 0u)));
                                                        let _e1418 = local.group_mask;
                                                        let _e1432 = local.group_mask;
                                                        local.group_mask = (_e1432 & ~((1u << bitcast<u32>((_e1414 & 31u)))));
                                                        let _e1435 = local.group;
                                                        phi_1604_ = (_e1435 + countOneBits(((_e1418 & ~((4294967295u << bitcast<u32>((((_e1414 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1604_ = 4294967295u;
                                                    }
                                                    let _e1438 = phi_1604_;
                                                    phi_1606_ = _e1438;
                                                    phi_1609_ = _e915;
                                                    loop {
                                                        let _e1440 = phi_1606_;
                                                        let _e1442 = phi_1609_;
                                                        local_14 = _e1442;
                                                        if (_e1440 != 4294967295u) {
                                                            if (_e1440 < _e62) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1449 = nodes.member[(0u + _e1440)].frame[3u];
                                                            let _e1474 = (bitcast<f32>((((_e1449 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1204);
                                                            let _e1475 = (bitcast<f32>((((_e1449 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1214);
                                                            let _e1476 = (bitcast<f32>((((_e1449 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1224);
                                                            let _e1479 = nodes.member[(0u + _e1440)].frame[0u];
                                                            let _e1483 = nodes.member[(0u + _e1440)].frame[1u];
                                                            let _e1487 = nodes.member[(0u + _e1440)].frame[2u];
                                                            let _e1492 = ((bitcast<f32>(_e1479) - _e995) * _e1204);
                                                            let _e1493 = ((bitcast<f32>(_e1483) - _e1008) * _e1214);
                                                            let _e1494 = ((bitcast<f32>(_e1487) - _e1021) * _e1224);
                                                            let _e1502 = nodes.member[(0u + _e1440)].x;
                                                            if (_e1204 < 0f) {
                                                                let _e1513 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1502.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1519 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1513.unnamed.root, _e1502.w), _e1513.unnamed_1);
                                                                let _e1525 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1519.unnamed, lt_bvh_traverse_Tree(_e1502.x, _e1519.unnamed_1.first_primitive));
                                                                phi_1689_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1525.unnamed, lt_bvh_traverse_Tree(_e1525.unnamed_1.root, _e1502.y));
                                                            } else {
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1502.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1541.unnamed.root, _e1502.y), _e1541.unnamed_1);
                                                                let _e1553 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1547.unnamed, lt_bvh_traverse_Tree(_e1502.z, _e1547.unnamed_1.first_primitive));
                                                                phi_1689_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1553.unnamed, lt_bvh_traverse_Tree(_e1553.unnamed_1.root, _e1502.w));
                                                            }
                                                            let _e1561 = phi_1689_;
                                                            let _e1571 = nodes.member[(0u + _e1440)].y;
                                                            if (_e1214 < 0f) {
                                                                let _e1582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1571.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.unnamed.root, _e1571.w), _e1582.unnamed_1);
                                                                let _e1594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1588.unnamed, lt_bvh_traverse_Tree(_e1571.x, _e1588.unnamed_1.first_primitive));
                                                                phi_1716_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1594.unnamed, lt_bvh_traverse_Tree(_e1594.unnamed_1.root, _e1571.y));
                                                            } else {
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1571.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1610.unnamed.root, _e1571.y), _e1610.unnamed_1);
                                                                let _e1622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1616.unnamed, lt_bvh_traverse_Tree(_e1571.z, _e1616.unnamed_1.first_primitive));
                                                                phi_1716_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1622.unnamed, lt_bvh_traverse_Tree(_e1622.unnamed_1.root, _e1571.w));
                                                            }
                                                            let _e1630 = phi_1716_;
                                                            let _e1640 = nodes.member[(0u + _e1440)].z;
                                                            if (_e1224 < 0f) {
                                                                let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1640.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.unnamed.root, _e1640.w), _e1651.unnamed_1);
                                                                let _e1663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_bvh_traverse_Tree(_e1640.x, _e1657.unnamed_1.first_primitive));
                                                                phi_1743_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1663.unnamed, lt_bvh_traverse_Tree(_e1663.unnamed_1.root, _e1640.y));
                                                            } else {
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1640.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1679.unnamed.root, _e1640.y), _e1679.unnamed_1);
                                                                let _e1691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1685.unnamed, lt_bvh_traverse_Tree(_e1640.z, _e1685.unnamed_1.first_primitive));
                                                                phi_1743_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1691.unnamed, lt_bvh_traverse_Tree(_e1691.unnamed_1.root, _e1640.w));
                                                            }
                                                            let _e1699 = phi_1743_;
                                                            phi_1749_ = 0u;
                                                            phi_1752_ = 0u;
                                                            loop {
                                                                let _e1709 = phi_1749_;
                                                                let _e1711 = phi_1752_;
                                                                local_5 = _e1711;
                                                                local_6 = _e1711;
                                                                local_7 = _e1711;
                                                                let _e1712 = (_e1709 < 8u);
                                                                if _e1712 {
                                                                    let _e1714 = (_e1709 >> bitcast<u32>(2i));
                                                                    let _e1715 = (_e1709 & 3u);
                                                                    if (_e1714 == 0u) {
                                                                        phi_1766_ = _e1561.unnamed.root;
                                                                    } else {
                                                                        phi_1766_ = _e1561.unnamed.first_primitive;
                                                                    }
                                                                    let _e1718 = phi_1766_;
                                                                    if (_e1714 == 0u) {
                                                                        phi_1776_ = _e1630.unnamed.root;
                                                                    } else {
                                                                        phi_1776_ = _e1630.unnamed.first_primitive;
                                                                    }
                                                                    let _e1727 = phi_1776_;
                                                                    if (_e1714 == 0u) {
                                                                        phi_1786_ = _e1699.unnamed.root;
                                                                    } else {
                                                                        phi_1786_ = _e1699.unnamed.first_primitive;
                                                                    }
                                                                    let _e1736 = phi_1786_;
                                                                    let _e1749 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1718 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u)) * _e1474) + (_e1492 - _e1252)), ((f32(((_e1727 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u)) * _e1475) + (_e1493 - _e1253)));
                                                                    let _e1750 = core_intrinsics_maximum_number_nsz_f32_(_e1749, ((f32(((_e1736 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u)) * _e1476) + (_e1494 - _e1254)));
                                                                    if (_e1714 == 0u) {
                                                                        phi_1804_ = _e1561.unnamed_1.root;
                                                                    } else {
                                                                        phi_1804_ = _e1561.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1753 = phi_1804_;
                                                                    if (_e1714 == 0u) {
                                                                        phi_1814_ = _e1630.unnamed_1.root;
                                                                    } else {
                                                                        phi_1814_ = _e1630.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1762 = phi_1814_;
                                                                    if (_e1714 == 0u) {
                                                                        phi_1824_ = _e1699.unnamed_1.root;
                                                                    } else {
                                                                        phi_1824_ = _e1699.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1771 = phi_1824_;
                                                                    let _e1784 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1753 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u)) * _e1474) + (_e1492 + _e1252)), ((f32(((_e1762 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u)) * _e1475) + (_e1493 + _e1253)));
                                                                    let _e1785 = core_intrinsics_minimum_number_nsz_f32_(_e1784, ((f32(((_e1771 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u)) * _e1476) + (_e1494 + _e1254)));
                                                                    if (_e1750 <= _e1785) {
                                                                        if (_e1750 <= _e121) {
                                                                            if (_e1785 >= 0f) {
                                                                                if (_e1714 == 0u) {
                                                                                    let _e1792 = nodes.member[(0u + _e1440)].links[2u];
                                                                                    phi_1860_ = _e1792;
                                                                                } else {
                                                                                    let _e1795 = nodes.member[(0u + _e1440)].links[3u];
                                                                                    phi_1860_ = _e1795;
                                                                                }
                                                                                let _e1797 = phi_1860_;
                                                                                let _e1802 = ((_e1797 >> bitcast<u32>(((_e1715 * 8u) & 31u))) & 255u);
                                                                                let _e1803 = (_e1802 & 31u);
                                                                                if (_e1803 >= 24u) {
                                                                                    phi_1873_ = (24u + ((_e1803 - 24u) ^ _e1302));
                                                                                } else {
                                                                                    phi_1873_ = _e1803;
                                                                                }
                                                                                let _e1809 = phi_1873_;
                                                                                phi_1878_ = (_e1711 | ((_e1802 >> bitcast<u32>(5i)) << bitcast<u32>((_e1809 & 31u))));
                                                                            } else {
                                                                                phi_1878_ = _e1711;
                                                                            }
                                                                            let _e1817 = phi_1878_;
                                                                            phi_1879_ = _e1817;
                                                                        } else {
                                                                            phi_1879_ = _e1711;
                                                                        }
                                                                        let _e1819 = phi_1879_;
                                                                        phi_1880_ = _e1819;
                                                                    } else {
                                                                        phi_1880_ = _e1711;
                                                                    }
                                                                    let _e1821 = phi_1880_;
                                                                    phi_1750_ = (_e1709 + 1u);
                                                                    phi_1753_ = _e1821;
                                                                } else {
                                                                    phi_1750_ = u32();
                                                                    phi_1753_ = u32();
                                                                }
                                                                let _e1824 = phi_1750_;
                                                                let _e1826 = phi_1753_;
                                                                continue;
                                                                continuing {
                                                                    phi_1749_ = _e1824;
                                                                    phi_1752_ = _e1826;
                                                                    break if !(_e1712);
                                                                }
                                                            }
                                                            let _e1830 = nodes.member[(0u + _e1440)].links[0u];
                                                            let _e1834 = nodes.member[(0u + _e1440)].frame[3u];
                                                            let _e1838 = local_5;
                                                            if ((_e1838 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1842 = local.group_mask;
                                                                if ((_e1842 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1846 = local.len;
                                                                    if (_e1846 < 32u) {
                                                                        let _e1849 = local.group;
                                                                        let _e1851 = local.len;
                                                                        if (_e1851 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1851)] = _e1849;
                                                                        let _e1857 = local.group_mask;
                                                                        let _e1859 = local.len;
                                                                        if (_e1859 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1859)] = _e1857;
                                                                        let _e1866 = local.len;
                                                                        local.len = (_e1866 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1064 + _e1830);
                                                                let _e1870 = local_6;
                                                                local.group_mask = ((_e1870 & 4278190080u) | (_e1834 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1875 = local_7;
                                                            phi_1938_ = (_e1875 & 16777215u);
                                                            phi_1941_ = _e1442;
                                                            loop {
                                                                let _e1878 = phi_1938_;
                                                                let _e1880 = phi_1941_;
                                                                local_12 = _e1880;
                                                                let _e1881 = (_e1878 == 0u);
                                                                local_8 = _e1881;
                                                                local_13 = _e1881;
                                                                if _e1881 {
                                                                    phi_1939_ = u32();
                                                                    phi_1942_ = bool();
                                                                    phi_2539_ = false;
                                                                } else {
                                                                    let _e1884 = nodes.member[(0u + _e1440)].links[1u];
                                                                    let _e1889 = ((_e1066 + _e1884) + select(firstTrailingBit(_e1878), 32u, (_e1878 == 0u)));
                                                                    if (_e1889 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1896 = triangles.member[(0u + _e1889)].v0_;
                                                                    let _e1898 = (_e1896.x - _e995);
                                                                    let _e1900 = (_e1896.y - _e1008);
                                                                    let _e1902 = (_e1896.z - _e1021);
                                                                    if (_e1275 == 0u) {
                                                                        phi_1986_ = vec3<f32>(_e1900, _e1902, _e1898);
                                                                    } else {
                                                                        if (_e1275 == 1u) {
                                                                            phi_1985_ = vec3<f32>(_e1902, _e1898, _e1900);
                                                                        } else {
                                                                            phi_1985_ = (_e1896 - vec3<f32>(_e995, _e1008, _e1021));
                                                                        }
                                                                        let _e1910 = phi_1985_;
                                                                        phi_1986_ = _e1910;
                                                                    }
                                                                    let _e1912 = phi_1986_;
                                                                    let _e1916 = (_e1912.x - (_e1286 * _e1912.z));
                                                                    let _e1920 = (_e1912.y - (_e1289 * _e1912.z));
                                                                    let _e1922 = triangles.member[(0u + _e1889)].v1_;
                                                                    let _e1924 = (_e1922.x - _e995);
                                                                    let _e1926 = (_e1922.y - _e1008);
                                                                    let _e1928 = (_e1922.z - _e1021);
                                                                    if (_e1275 == 0u) {
                                                                        phi_2016_ = vec3<f32>(_e1926, _e1928, _e1924);
                                                                    } else {
                                                                        if (_e1275 == 1u) {
                                                                            phi_2015_ = vec3<f32>(_e1928, _e1924, _e1926);
                                                                        } else {
                                                                            phi_2015_ = (_e1922 - vec3<f32>(_e995, _e1008, _e1021));
                                                                        }
                                                                        let _e1936 = phi_2015_;
                                                                        phi_2016_ = _e1936;
                                                                    }
                                                                    let _e1938 = phi_2016_;
                                                                    let _e1942 = (_e1938.x - (_e1286 * _e1938.z));
                                                                    let _e1946 = (_e1938.y - (_e1289 * _e1938.z));
                                                                    let _e1948 = triangles.member[(0u + _e1889)].v2_;
                                                                    let _e1950 = (_e1948.x - _e995);
                                                                    let _e1952 = (_e1948.y - _e1008);
                                                                    let _e1954 = (_e1948.z - _e1021);
                                                                    if (_e1275 == 0u) {
                                                                        phi_2046_ = vec3<f32>(_e1952, _e1954, _e1950);
                                                                    } else {
                                                                        if (_e1275 == 1u) {
                                                                            phi_2045_ = vec3<f32>(_e1954, _e1950, _e1952);
                                                                        } else {
                                                                            phi_2045_ = (_e1948 - vec3<f32>(_e995, _e1008, _e1021));
                                                                        }
                                                                        let _e1962 = phi_2045_;
                                                                        phi_2046_ = _e1962;
                                                                    }
                                                                    let _e1964 = phi_2046_;
                                                                    let _e1968 = (_e1964.x - (_e1286 * _e1964.z));
                                                                    let _e1972 = (_e1964.y - (_e1289 * _e1964.z));
                                                                    if (_e1942 < _e1968) {
                                                                        phi_2065_ = true;
                                                                    } else {
                                                                        if (_e1942 == _e1968) {
                                                                            phi_2064_ = (_e1946 < _e1972);
                                                                        } else {
                                                                            phi_2064_ = false;
                                                                        }
                                                                        let _e1977 = phi_2064_;
                                                                        phi_2065_ = _e1977;
                                                                    }
                                                                    let _e1979 = phi_2065_;
                                                                    if _e1979 {
                                                                        phi_2069_ = _e1972;
                                                                        phi_2070_ = _e1968;
                                                                        phi_2071_ = _e1946;
                                                                        phi_2072_ = _e1942;
                                                                    } else {
                                                                        phi_2069_ = _e1946;
                                                                        phi_2070_ = _e1942;
                                                                        phi_2071_ = _e1972;
                                                                        phi_2072_ = _e1968;
                                                                    }
                                                                    let _e1981 = phi_2069_;
                                                                    let _e1983 = phi_2070_;
                                                                    let _e1985 = phi_2071_;
                                                                    let _e1987 = phi_2072_;
                                                                    let _e1990 = ((_e1987 * _e1981) - (_e1985 * _e1983));
                                                                    if _e1979 {
                                                                        phi_2080_ = -(_e1990);
                                                                    } else {
                                                                        phi_2080_ = _e1990;
                                                                    }
                                                                    let _e1993 = phi_2080_;
                                                                    if (_e1968 < _e1916) {
                                                                        phi_2091_ = true;
                                                                    } else {
                                                                        if (_e1968 == _e1916) {
                                                                            phi_2090_ = (_e1972 < _e1920);
                                                                        } else {
                                                                            phi_2090_ = false;
                                                                        }
                                                                        let _e1998 = phi_2090_;
                                                                        phi_2091_ = _e1998;
                                                                    }
                                                                    let _e2000 = phi_2091_;
                                                                    if _e2000 {
                                                                        phi_2095_ = _e1920;
                                                                        phi_2096_ = _e1916;
                                                                        phi_2097_ = _e1972;
                                                                        phi_2098_ = _e1968;
                                                                    } else {
                                                                        phi_2095_ = _e1972;
                                                                        phi_2096_ = _e1968;
                                                                        phi_2097_ = _e1920;
                                                                        phi_2098_ = _e1916;
                                                                    }
                                                                    let _e2002 = phi_2095_;
                                                                    let _e2004 = phi_2096_;
                                                                    let _e2006 = phi_2097_;
                                                                    let _e2008 = phi_2098_;
                                                                    let _e2011 = ((_e2008 * _e2002) - (_e2006 * _e2004));
                                                                    if _e2000 {
                                                                        phi_2106_ = -(_e2011);
                                                                    } else {
                                                                        phi_2106_ = _e2011;
                                                                    }
                                                                    let _e2014 = phi_2106_;
                                                                    if (_e1916 < _e1942) {
                                                                        phi_2117_ = true;
                                                                    } else {
                                                                        if (_e1916 == _e1942) {
                                                                            phi_2116_ = (_e1920 < _e1946);
                                                                        } else {
                                                                            phi_2116_ = false;
                                                                        }
                                                                        let _e2019 = phi_2116_;
                                                                        phi_2117_ = _e2019;
                                                                    }
                                                                    let _e2021 = phi_2117_;
                                                                    if _e2021 {
                                                                        phi_2121_ = _e1946;
                                                                        phi_2122_ = _e1942;
                                                                        phi_2123_ = _e1920;
                                                                        phi_2124_ = _e1916;
                                                                    } else {
                                                                        phi_2121_ = _e1920;
                                                                        phi_2122_ = _e1916;
                                                                        phi_2123_ = _e1946;
                                                                        phi_2124_ = _e1942;
                                                                    }
                                                                    let _e2023 = phi_2121_;
                                                                    let _e2025 = phi_2122_;
                                                                    let _e2027 = phi_2123_;
                                                                    let _e2029 = phi_2124_;
                                                                    let _e2032 = ((_e2029 * _e2023) - (_e2027 * _e2025));
                                                                    if _e2021 {
                                                                        phi_2132_ = -(_e2032);
                                                                    } else {
                                                                        phi_2132_ = _e2032;
                                                                    }
                                                                    let _e2035 = phi_2132_;
                                                                    if (_e1993 >= 0f) {
                                                                        if (_e2014 >= 0f) {
                                                                            if (_e2035 >= 0f) {
                                                                                phi_2147_ = ((_e1993 + _e2014) + _e2035);
                                                                                phi_2148_ = false;
                                                                            } else {
                                                                                phi_2147_ = f32();
                                                                                phi_2148_ = true;
                                                                            }
                                                                            let _e2042 = phi_2147_;
                                                                            let _e2044 = phi_2148_;
                                                                            phi_2149_ = _e2042;
                                                                            phi_2150_ = _e2044;
                                                                        } else {
                                                                            phi_2149_ = f32();
                                                                            phi_2150_ = true;
                                                                        }
                                                                        let _e2046 = phi_2149_;
                                                                        let _e2048 = phi_2150_;
                                                                        phi_2151_ = _e2046;
                                                                        phi_2152_ = _e2048;
                                                                    } else {
                                                                        phi_2151_ = f32();
                                                                        phi_2152_ = true;
                                                                    }
                                                                    let _e2050 = phi_2151_;
                                                                    let _e2052 = phi_2152_;
                                                                    if _e2052 {
                                                                        if (_e1993 <= 0f) {
                                                                            if (_e2014 <= 0f) {
                                                                                let _e2055 = (_e2035 <= 0f);
                                                                                if _e2055 {
                                                                                }
                                                                                phi_2170_ = ((_e1993 + _e2014) + _e2035);
                                                                                phi_2171_ = false;
                                                                                phi_2172_ = _e2055;
                                                                            } else {
                                                                                phi_2170_ = f32();
                                                                                phi_2171_ = true;
                                                                                phi_2172_ = false;
                                                                            }
                                                                            let _e2059 = phi_2170_;
                                                                            let _e2061 = phi_2171_;
                                                                            let _e2063 = phi_2172_;
                                                                            phi_2173_ = _e2059;
                                                                            phi_2174_ = _e2061;
                                                                            phi_2175_ = _e2063;
                                                                        } else {
                                                                            phi_2173_ = f32();
                                                                            phi_2174_ = true;
                                                                            phi_2175_ = false;
                                                                        }
                                                                        let _e2065 = phi_2173_;
                                                                        let _e2067 = phi_2174_;
                                                                        let _e2069 = phi_2175_;
                                                                        if _e2067 {
                                                                            phi_2179_ = false;
                                                                        } else {
                                                                            phi_2179_ = _e2069;
                                                                        }
                                                                        let _e2071 = phi_2179_;
                                                                        phi_2180_ = _e2065;
                                                                        phi_2181_ = _e2071;
                                                                    } else {
                                                                        phi_2180_ = _e2050;
                                                                        phi_2181_ = true;
                                                                    }
                                                                    let _e2073 = phi_2180_;
                                                                    let _e2075 = phi_2181_;
                                                                    if _e2075 {
                                                                        let _e2076 = (_e2073 == 0f);
                                                                        if _e2076 {
                                                                            phi_2497_ = lt_bvh_triangle_Intersection();
                                                                            phi_2498_ = false;
                                                                        } else {
                                                                            let _e2078 = triangles.member[(0u + _e1889)].v0_;
                                                                            let _e2080 = (_e2078.x - _e995);
                                                                            let _e2082 = (_e2078.y - _e1008);
                                                                            let _e2084 = (_e2078.z - _e1021);
                                                                            if (_e1275 == 0u) {
                                                                                phi_2210_ = vec3<f32>(_e2082, _e2084, _e2080);
                                                                            } else {
                                                                                if (_e1275 == 1u) {
                                                                                    phi_2209_ = vec3<f32>(_e2084, _e2080, _e2082);
                                                                                } else {
                                                                                    phi_2209_ = (_e2078 - vec3<f32>(_e995, _e1008, _e1021));
                                                                                }
                                                                                let _e2092 = phi_2209_;
                                                                                phi_2210_ = _e2092;
                                                                            }
                                                                            let _e2094 = phi_2210_;
                                                                            let _e2096 = triangles.member[(0u + _e1889)].v1_;
                                                                            let _e2098 = triangles.member[(0u + _e1889)].v0_;
                                                                            let _e2101 = (_e2096.x - _e2098.x);
                                                                            let _e2104 = (_e2096.y - _e2098.y);
                                                                            let _e2107 = (_e2096.z - _e2098.z);
                                                                            if (_e1275 == 0u) {
                                                                                phi_2236_ = vec3<f32>(_e2104, _e2107, _e2101);
                                                                            } else {
                                                                                if (_e1275 == 1u) {
                                                                                    phi_2235_ = vec3<f32>(_e2107, _e2101, _e2104);
                                                                                } else {
                                                                                    phi_2235_ = (_e2096 - _e2098);
                                                                                }
                                                                                let _e2114 = phi_2235_;
                                                                                phi_2236_ = _e2114;
                                                                            }
                                                                            let _e2116 = phi_2236_;
                                                                            let _e2118 = triangles.member[(0u + _e1889)].v2_;
                                                                            let _e2120 = triangles.member[(0u + _e1889)].v0_;
                                                                            let _e2123 = (_e2118.x - _e2120.x);
                                                                            let _e2126 = (_e2118.y - _e2120.y);
                                                                            let _e2129 = (_e2118.z - _e2120.z);
                                                                            if (_e1275 == 0u) {
                                                                                phi_2262_ = vec3<f32>(_e2126, _e2129, _e2123);
                                                                            } else {
                                                                                if (_e1275 == 1u) {
                                                                                    phi_2261_ = vec3<f32>(_e2129, _e2123, _e2126);
                                                                                } else {
                                                                                    phi_2261_ = (_e2118 - _e2120);
                                                                                }
                                                                                let _e2136 = phi_2261_;
                                                                                phi_2262_ = _e2136;
                                                                            }
                                                                            let _e2138 = phi_2262_;
                                                                            let _e2145 = ((_e2116.y * _e2138.z) - (_e2116.z * _e2138.y));
                                                                            let _e2152 = ((_e2116.z * _e2138.x) - (_e2116.x * _e2138.z));
                                                                            let _e2159 = ((_e2116.x * _e2138.y) - (_e2116.y * _e2138.x));
                                                                            let _e2173 = (((1f / _e1283.z) * (((_e2145 * _e2094.x) + (_e2152 * _e2094.y)) + (_e2159 * _e2094.z))) / (((_e2145 * _e1286) + (_e2152 * _e1289)) + _e2159));
                                                                            if (_e2173 > 0f) {
                                                                                if (_e2173 < _e121) {
                                                                                    let _e2177 = triangles.member[(0u + _e1889)].v0_;
                                                                                    let _e2179 = triangles.member[(0u + _e1889)].v1_;
                                                                                    if (_e2177.x < _e2179.x) {
                                                                                        phi_2318_ = _e2177.x;
                                                                                    } else {
                                                                                        phi_2318_ = _e2179.x;
                                                                                    }
                                                                                    let _e2186 = phi_2318_;
                                                                                    if (_e2177.y < _e2179.y) {
                                                                                        phi_2327_ = _e2177.y;
                                                                                    } else {
                                                                                        phi_2327_ = _e2179.y;
                                                                                    }
                                                                                    let _e2193 = phi_2327_;
                                                                                    if (_e2177.z < _e2179.z) {
                                                                                        phi_2336_ = _e2177.z;
                                                                                    } else {
                                                                                        phi_2336_ = _e2179.z;
                                                                                    }
                                                                                    let _e2200 = phi_2336_;
                                                                                    let _e2202 = triangles.member[(0u + _e1889)].v2_;
                                                                                    if (_e2186 < _e2202.x) {
                                                                                        phi_2345_ = _e2186;
                                                                                    } else {
                                                                                        phi_2345_ = _e2202.x;
                                                                                    }
                                                                                    let _e2207 = phi_2345_;
                                                                                    if (_e2193 < _e2202.y) {
                                                                                        phi_2352_ = _e2193;
                                                                                    } else {
                                                                                        phi_2352_ = _e2202.y;
                                                                                    }
                                                                                    let _e2212 = phi_2352_;
                                                                                    if (_e2200 < _e2202.z) {
                                                                                        phi_2359_ = _e2200;
                                                                                    } else {
                                                                                        phi_2359_ = _e2202.z;
                                                                                    }
                                                                                    let _e2217 = phi_2359_;
                                                                                    let _e2219 = triangles.member[(0u + _e1889)].v0_;
                                                                                    let _e2221 = triangles.member[(0u + _e1889)].v1_;
                                                                                    if (_e2219.x > _e2221.x) {
                                                                                        phi_2372_ = _e2219.x;
                                                                                    } else {
                                                                                        phi_2372_ = _e2221.x;
                                                                                    }
                                                                                    let _e2228 = phi_2372_;
                                                                                    if (_e2219.y > _e2221.y) {
                                                                                        phi_2381_ = _e2219.y;
                                                                                    } else {
                                                                                        phi_2381_ = _e2221.y;
                                                                                    }
                                                                                    let _e2235 = phi_2381_;
                                                                                    if (_e2219.z > _e2221.z) {
                                                                                        phi_2390_ = _e2219.z;
                                                                                    } else {
                                                                                        phi_2390_ = _e2221.z;
                                                                                    }
                                                                                    let _e2242 = phi_2390_;
                                                                                    let _e2244 = triangles.member[(0u + _e1889)].v2_;
                                                                                    if (_e2228 > _e2244.x) {
                                                                                        phi_2399_ = _e2228;
                                                                                    } else {
                                                                                        phi_2399_ = _e2244.x;
                                                                                    }
                                                                                    let _e2249 = phi_2399_;
                                                                                    if (_e2235 > _e2244.y) {
                                                                                        phi_2406_ = _e2235;
                                                                                    } else {
                                                                                        phi_2406_ = _e2244.y;
                                                                                    }
                                                                                    let _e2254 = phi_2406_;
                                                                                    if (_e2242 > _e2244.z) {
                                                                                        phi_2413_ = _e2242;
                                                                                    } else {
                                                                                        phi_2413_ = _e2244.z;
                                                                                    }
                                                                                    let _e2259 = phi_2413_;
                                                                                    let _e2263 = ((_e2207 - _e995) * _e1204);
                                                                                    let _e2264 = ((_e2212 - _e1008) * _e1214);
                                                                                    let _e2265 = ((_e2217 - _e1021) * _e1224);
                                                                                    let _e2269 = ((_e2249 - _e995) * _e1204);
                                                                                    let _e2270 = ((_e2254 - _e1008) * _e1214);
                                                                                    let _e2271 = ((_e2259 - _e1021) * _e1224);
                                                                                    if (_e2263 < _e2269) {
                                                                                        phi_2430_ = _e2263;
                                                                                    } else {
                                                                                        phi_2430_ = _e2269;
                                                                                    }
                                                                                    let _e2274 = phi_2430_;
                                                                                    if (_e2264 < _e2270) {
                                                                                        phi_2435_ = _e2264;
                                                                                    } else {
                                                                                        phi_2435_ = _e2270;
                                                                                    }
                                                                                    let _e2277 = phi_2435_;
                                                                                    if (_e2265 < _e2271) {
                                                                                        phi_2440_ = _e2265;
                                                                                    } else {
                                                                                        phi_2440_ = _e2271;
                                                                                    }
                                                                                    let _e2280 = phi_2440_;
                                                                                    if (_e2263 > _e2269) {
                                                                                        phi_2448_ = _e2263;
                                                                                    } else {
                                                                                        phi_2448_ = _e2269;
                                                                                    }
                                                                                    let _e2286 = phi_2448_;
                                                                                    if (_e2264 > _e2270) {
                                                                                        phi_2453_ = _e2264;
                                                                                    } else {
                                                                                        phi_2453_ = _e2270;
                                                                                    }
                                                                                    let _e2289 = phi_2453_;
                                                                                    if (_e2265 > _e2271) {
                                                                                        phi_2458_ = _e2265;
                                                                                    } else {
                                                                                        phi_2458_ = _e2271;
                                                                                    }
                                                                                    let _e2292 = phi_2458_;
                                                                                    let _e2296 = core_intrinsics_maximum_number_nsz_f32_((_e2274 - _e1259), (_e2277 - _e1260));
                                                                                    let _e2297 = core_intrinsics_maximum_number_nsz_f32_(_e2296, (_e2280 - _e1261));
                                                                                    let _e2298 = core_intrinsics_minimum_number_nsz_f32_((_e2286 + _e1259), (_e2289 + _e1260));
                                                                                    let _e2299 = core_intrinsics_minimum_number_nsz_f32_(_e2298, (_e2292 + _e1261));
                                                                                    if (_e2297 > _e976) {
                                                                                        phi_2470_ = _e2297;
                                                                                    } else {
                                                                                        phi_2470_ = _e976;
                                                                                    }
                                                                                    let _e2302 = phi_2470_;
                                                                                    if (_e2299 < _e978) {
                                                                                        phi_2475_ = _e2299;
                                                                                    } else {
                                                                                        phi_2475_ = _e978;
                                                                                    }
                                                                                    let _e2305 = phi_2475_;
                                                                                    if (_e2173 < _e2302) {
                                                                                        phi_2480_ = _e2302;
                                                                                    } else {
                                                                                        phi_2480_ = _e2173;
                                                                                    }
                                                                                    let _e2308 = phi_2480_;
                                                                                    if (_e2308 > _e2305) {
                                                                                        phi_2485_ = _e2305;
                                                                                    } else {
                                                                                        phi_2485_ = _e2308;
                                                                                    }
                                                                                    let _e2311 = phi_2485_;
                                                                                    phi_2490_ = lt_bvh_triangle_Intersection(_e2311, (_e2014 / _e2073), (_e2035 / _e2073), (_e2302 <= _e2305));
                                                                                    phi_2491_ = false;
                                                                                } else {
                                                                                    phi_2490_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2491_ = true;
                                                                                }
                                                                                let _e2317 = phi_2490_;
                                                                                let _e2319 = phi_2491_;
                                                                                phi_2492_ = _e2317;
                                                                                phi_2493_ = _e2319;
                                                                            } else {
                                                                                phi_2492_ = lt_bvh_triangle_Intersection();
                                                                                phi_2493_ = true;
                                                                            }
                                                                            let _e2321 = phi_2492_;
                                                                            let _e2323 = phi_2493_;
                                                                            if _e2323 {
                                                                            }
                                                                            phi_2497_ = _e2321;
                                                                            phi_2498_ = _e2323;
                                                                        }
                                                                        let _e2325 = phi_2497_;
                                                                        let _e2327 = phi_2498_;
                                                                        phi_2499_ = _e2325;
                                                                        phi_2500_ = _e2076;
                                                                        phi_2501_ = _e2327;
                                                                    } else {
                                                                        phi_2499_ = lt_bvh_triangle_Intersection();
                                                                        phi_2500_ = true;
                                                                        phi_2501_ = false;
                                                                    }
                                                                    let _e2329 = phi_2499_;
                                                                    let _e2331 = phi_2500_;
                                                                    let _e2333 = phi_2501_;
                                                                    if _e2331 {
                                                                        phi_2505_ = true;
                                                                    } else {
                                                                        phi_2505_ = _e2333;
                                                                    }
                                                                    let _e2335 = phi_2505_;
                                                                    if _e2335 {
                                                                        phi_2509_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2509_ = _e2329;
                                                                    }
                                                                    let _e2337 = phi_2509_;
                                                                    if _e2337.is_hit {
                                                                        if (_e2337.t > 0f) {
                                                                            if (_e2337.t < _e121) {
                                                                                if true {
                                                                                    phi_2529_ = false;
                                                                                } else {
                                                                                    phi_2529_ = true;
                                                                                }
                                                                                let _e2346 = phi_2529_;
                                                                                phi_2530_ = true;
                                                                                phi_2531_ = _e2346;
                                                                            } else {
                                                                                phi_2530_ = _e1880;
                                                                                phi_2531_ = true;
                                                                            }
                                                                            let _e2348 = phi_2530_;
                                                                            let _e2350 = phi_2531_;
                                                                            phi_2532_ = _e2348;
                                                                            phi_2533_ = _e2350;
                                                                        } else {
                                                                            phi_2532_ = _e1880;
                                                                            phi_2533_ = true;
                                                                        }
                                                                        let _e2352 = phi_2532_;
                                                                        let _e2354 = phi_2533_;
                                                                        phi_2534_ = _e2352;
                                                                        phi_2535_ = _e2354;
                                                                    } else {
                                                                        phi_2534_ = _e1880;
                                                                        phi_2535_ = true;
                                                                    }
                                                                    let _e2356 = phi_2534_;
                                                                    let _e2358 = phi_2535_;
                                                                    if _e2358 {
                                                                    }
                                                                    phi_1939_ = (_e1878 & (_e1878 - 1u));
                                                                    phi_1942_ = _e2356;
                                                                    phi_2539_ = _e2358;
                                                                }
                                                                let _e2360 = phi_1939_;
                                                                let _e2362 = phi_1942_;
                                                                let _e2364 = phi_2539_;
                                                                continue;
                                                                continuing {
                                                                    phi_1938_ = _e2360;
                                                                    phi_1941_ = _e2362;
                                                                    break if !(_e2364);
                                                                }
                                                            }
                                                            let _e2367 = local_8;
                                                            if _e2367 {
                                                                let _e2369 = local.group_mask;
                                                                if ((_e2369 & 4278190080u) == 0u) {
                                                                    let _e2373 = local.len;
                                                                    if (_e2373 == 0u) {
                                                                        phi_2581_ = false;
                                                                    } else {
                                                                        let _e2377 = local.len;
                                                                        local.len = (_e2377 - 1u);
                                                                        let _e2380 = local.len;
                                                                        if (_e2380 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2385 = local.first[(0u + _e2380)];
                                                                        local.group = _e2385;
                                                                        let _e2388 = local.len;
                                                                        if (_e2388 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2393 = local.mask[(0u + _e2388)];
                                                                        local.group_mask = _e2393;
                                                                        phi_2581_ = true;
                                                                    }
                                                                    let _e2396 = phi_2581_;
                                                                    phi_2582_ = _e2396;
                                                                } else {
                                                                    phi_2582_ = true;
                                                                }
                                                                let _e2398 = phi_2582_;
                                                                if _e2398 {
                                                                    let _e2400 = local.group_mask;
                                                                    let _e2406 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2400)), 32u, (_e2400 == 0u)));
                                                                    let _e2410 = local.group_mask;
                                                                    let _e2424 = local.group_mask;
                                                                    local.group_mask = (_e2424 & ~((1u << bitcast<u32>((_e2406 & 31u)))));
                                                                    let _e2427 = local.group;
                                                                    phi_2613_ = (_e2427 + countOneBits(((_e2410 & ~((4294967295u << bitcast<u32>((((_e2406 - 24u) ^ _e1302) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2613_ = 4294967295u;
                                                                }
                                                                let _e2430 = phi_2613_;
                                                                phi_2614_ = _e2430;
                                                            } else {
                                                                phi_2614_ = u32();
                                                            }
                                                            let _e2432 = phi_2614_;
                                                            phi_1607_ = _e2432;
                                                            let _e2838 = local_12;
                                                            phi_1610_ = _e2838;
                                                            let _e2841 = local_13;
                                                            phi_2615_ = _e2841;
                                                            phi_2616_ = false;
                                                        } else {
                                                            phi_1607_ = u32();
                                                            phi_1610_ = bool();
                                                            phi_2615_ = false;
                                                            phi_2616_ = true;
                                                        }
                                                        let _e2434 = phi_1607_;
                                                        let _e2436 = phi_1610_;
                                                        let _e2438 = phi_2615_;
                                                        let _e2440 = phi_2616_;
                                                        local_9 = _e2440;
                                                        continue;
                                                        continuing {
                                                            phi_1606_ = _e2434;
                                                            phi_1609_ = _e2436;
                                                            break if !(_e2438);
                                                        }
                                                    }
                                                    let _e2443 = local_9;
                                                    if _e2443 {
                                                        phi_2620_ = false;
                                                    } else {
                                                        phi_2620_ = true;
                                                    }
                                                    let _e2445 = phi_2620_;
                                                    if _e2445 {
                                                        phi_2624_ = true;
                                                    } else {
                                                        let _e2847 = local_14;
                                                        phi_2624_ = _e2847;
                                                    }
                                                    let _e2447 = phi_2624_;
                                                    phi_2625_ = _e2447;
                                                }
                                                let _e2449 = phi_2625_;
                                                phi_2626_ = _e2449;
                                                phi_2627_ = _e1128;
                                            } else {
                                                phi_2626_ = bool();
                                                phi_2627_ = true;
                                            }
                                            let _e2451 = phi_2626_;
                                            let _e2453 = phi_2627_;
                                            if _e2453 {
                                                phi_2631_ = _e915;
                                            } else {
                                                phi_2631_ = _e2451;
                                            }
                                            let _e2455 = phi_2631_;
                                            if _e2455 {
                                                phi_2635_ = false;
                                            } else {
                                                phi_2635_ = true;
                                            }
                                            let _e2457 = phi_2635_;
                                            phi_2636_ = _e2455;
                                            phi_2637_ = _e2457;
                                        } else {
                                            phi_2636_ = _e915;
                                            phi_2637_ = true;
                                        }
                                        let _e2459 = phi_2636_;
                                        let _e2461 = phi_2637_;
                                        phi_2638_ = _e2459;
                                        phi_2639_ = _e2461;
                                    } else {
                                        phi_2638_ = _e915;
                                        phi_2639_ = true;
                                    }
                                    let _e2463 = phi_2638_;
                                    let _e2465 = phi_2639_;
                                    phi_2640_ = _e2463;
                                    phi_2641_ = _e2465;
                                } else {
                                    phi_2640_ = _e915;
                                    phi_2641_ = true;
                                }
                                let _e2467 = phi_2640_;
                                let _e2469 = phi_2641_;
                                if _e2469 {
                                }
                                phi_999_ = (_e913 & (_e913 - 1u));
                                phi_1002_ = _e2467;
                                phi_2645_ = _e2469;
                            }
                            let _e2471 = phi_999_;
                            let _e2473 = phi_1002_;
                            let _e2475 = phi_2645_;
                            continue;
                            continuing {
                                phi_998_ = _e2471;
                                phi_1001_ = _e2473;
                                break if !(_e2475);
                            }
                        }
                        let _e2478 = local_10;
                        if _e2478 {
                            let _e2480 = local_1.group_mask;
                            if ((_e2480 & 4278190080u) == 0u) {
                                let _e2484 = local_1.len;
                                if (_e2484 == 0u) {
                                    phi_2687_ = false;
                                } else {
                                    let _e2488 = local_1.len;
                                    local_1.len = (_e2488 - 1u);
                                    let _e2491 = local_1.len;
                                    if (_e2491 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2496 = local_1.first[(0u + _e2491)];
                                    local_1.group = _e2496;
                                    let _e2499 = local_1.len;
                                    if (_e2499 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2504 = local_1.mask[(0u + _e2499)];
                                    local_1.group_mask = _e2504;
                                    phi_2687_ = true;
                                }
                                let _e2507 = phi_2687_;
                                phi_2688_ = _e2507;
                            } else {
                                phi_2688_ = true;
                            }
                            let _e2509 = phi_2688_;
                            if _e2509 {
                                let _e2511 = local_1.group_mask;
                                let _e2517 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2511)), 32u, (_e2511 == 0u)));
                                let _e2521 = local_1.group_mask;
                                let _e2535 = local_1.group_mask;
                                local_1.group_mask = (_e2535 & ~((1u << bitcast<u32>((_e2517 & 31u)))));
                                let _e2538 = local_1.group;
                                phi_2719_ = (_e2538 + countOneBits(((_e2521 & ~((4294967295u << bitcast<u32>((((_e2517 - 24u) ^ _e337) & 31u))))) & 255u)));
                            } else {
                                phi_2719_ = 4294967295u;
                            }
                            let _e2541 = phi_2719_;
                            phi_2720_ = _e2541;
                        } else {
                            phi_2720_ = u32();
                        }
                        let _e2543 = phi_2720_;
                        phi_667_ = _e2543;
                        let _e2870 = local_15;
                        phi_670_ = _e2870;
                        let _e2873 = local_16;
                        phi_2721_ = _e2873;
                        phi_2722_ = false;
                    } else {
                        phi_667_ = u32();
                        phi_670_ = bool();
                        phi_2721_ = false;
                        phi_2722_ = true;
                    }
                    let _e2545 = phi_667_;
                    let _e2547 = phi_670_;
                    let _e2549 = phi_2721_;
                    let _e2551 = phi_2722_;
                    local_11 = _e2551;
                    continue;
                    continuing {
                        phi_666_ = _e2545;
                        phi_669_ = _e2547;
                        break if !(_e2549);
                    }
                }
                let _e2554 = local_11;
                if _e2554 {
                    phi_2726_ = false;
                } else {
                    phi_2726_ = true;
                }
                let _e2556 = phi_2726_;
                if _e2556 {
                }
                phi_2730_ = _e2556;
            }
            let _e2558 = phi_2730_;
            phi_2731_ = _e193;
            phi_2732_ = _e2558;
        } else {
            phi_2731_ = true;
            phi_2732_ = false;
        }
        let _e2560 = phi_2731_;
        let _e2562 = phi_2732_;
        if _e2560 {
            phi_2736_ = false;
            phi_2737_ = true;
        } else {
            phi_2736_ = true;
            phi_2737_ = _e2562;
        }
        let _e2564 = phi_2736_;
        let _e2566 = phi_2737_;
        if _e2566 {
            phi_2741_ = _e2564;
        } else {
            phi_2741_ = false;
        }
        let _e2568 = phi_2741_;
        if _e2568 {
            phi_2745_ = 0f;
        } else {
            phi_2745_ = 1f;
        }
        let _e2570 = phi_2745_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e90)] = _e2570;
        if (_e90 < _e74) {
        } else {
            return;
        }
        let _e2577 = bits.member[(0u + _e90)];
        if ((_e2577 & 2u) == 0u) {
            phi_2766_ = (_e2577 & 1u);
        } else {
            phi_2766_ = (_e2577 & 7u);
        }
        let _e2583 = phi_2766_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        let _e2587 = visibility.member[(0u + _e90)];
        if ((_e2583 & 1u) != 0u) {
            phi_2781_ = (2u | 1u);
        } else {
            phi_2781_ = 2u;
        }
        let _e2593 = phi_2781_;
        if (_e2587 < 0.5f) {
            phi_2786_ = (_e2593 | 4u);
        } else {
            phi_2786_ = _e2593;
        }
        let _e2596 = phi_2786_;
        if (_e90 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e90)] = _e2596;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
