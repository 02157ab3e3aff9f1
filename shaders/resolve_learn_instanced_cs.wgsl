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
@group(0) @binding(0) 
var<uniform> p: type_52;
@group(0) @binding(2) 
var<storage> nodes: type_46;
@group(0) @binding(3) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_37;

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
    var phi_747_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_774_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_801_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_807_: u32;
    var phi_810_: u32;
    var phi_824_: u32;
    var phi_834_: u32;
    var phi_844_: u32;
    var phi_862_: u32;
    var phi_872_: u32;
    var phi_882_: u32;
    var phi_918_: u32;
    var phi_931_: u32;
    var phi_936_: u32;
    var phi_937_: u32;
    var phi_938_: u32;
    var phi_808_: u32;
    var phi_811_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_996_: u32;
    var phi_1046_: f32;
    var phi_1051_: f32;
    var phi_1056_: f32;
    var phi_1064_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
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
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1245_: bool;
    var phi_1249_: bool;
    var phi_1319_: f32;
    var phi_1326_: f32;
    var phi_1333_: f32;
    var phi_1340_: f32;
    var phi_1347_: f32;
    var phi_1354_: f32;
    var phi_1371_: f32;
    var phi_1376_: f32;
    var phi_1381_: f32;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1418_: u32;
    var phi_1419_: u32;
    var phi_1430_: vec3<f32>;
    var phi_1431_: vec3<f32>;
    var phi_1444_: u32;
    var phi_1449_: u32;
    var phi_1454_: u32;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1600_: u32;
    var phi_1602_: u32;
    var phi_1683_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1710_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1737_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1743_: u32;
    var phi_1746_: u32;
    var phi_1760_: u32;
    var phi_1770_: u32;
    var phi_1780_: u32;
    var phi_1798_: u32;
    var phi_1808_: u32;
    var phi_1818_: u32;
    var phi_1854_: u32;
    var phi_1867_: u32;
    var phi_1872_: u32;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1744_: u32;
    var phi_1747_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1932_: u32;
    var phi_1977_: vec3<f32>;
    var phi_1978_: vec3<f32>;
    var phi_2007_: vec3<f32>;
    var phi_2008_: vec3<f32>;
    var phi_2037_: vec3<f32>;
    var phi_2038_: vec3<f32>;
    var phi_2056_: bool;
    var phi_2057_: bool;
    var phi_2061_: f32;
    var phi_2062_: f32;
    var phi_2063_: f32;
    var phi_2064_: f32;
    var phi_2072_: f32;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2087_: f32;
    var phi_2088_: f32;
    var phi_2089_: f32;
    var phi_2090_: f32;
    var phi_2098_: f32;
    var phi_2108_: bool;
    var phi_2109_: bool;
    var phi_2113_: f32;
    var phi_2114_: f32;
    var phi_2115_: f32;
    var phi_2116_: f32;
    var phi_2124_: f32;
    var phi_2139_: f32;
    var phi_2140_: bool;
    var phi_2141_: f32;
    var phi_2142_: bool;
    var phi_2143_: f32;
    var phi_2144_: bool;
    var phi_2162_: f32;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2165_: f32;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2171_: bool;
    var phi_2172_: f32;
    var phi_2173_: bool;
    var phi_2201_: vec3<f32>;
    var phi_2202_: vec3<f32>;
    var phi_2227_: vec3<f32>;
    var phi_2228_: vec3<f32>;
    var phi_2253_: vec3<f32>;
    var phi_2254_: vec3<f32>;
    var phi_2310_: f32;
    var phi_2319_: f32;
    var phi_2328_: f32;
    var phi_2337_: f32;
    var phi_2344_: f32;
    var phi_2351_: f32;
    var phi_2364_: f32;
    var phi_2373_: f32;
    var phi_2382_: f32;
    var phi_2391_: f32;
    var phi_2398_: f32;
    var phi_2405_: f32;
    var phi_2422_: f32;
    var phi_2427_: f32;
    var phi_2432_: f32;
    var phi_2440_: f32;
    var phi_2445_: f32;
    var phi_2450_: f32;
    var phi_2462_: f32;
    var phi_2467_: f32;
    var phi_2472_: f32;
    var phi_2477_: f32;
    var phi_2482_: lt_bvh_triangle_Intersection;
    var phi_2483_: bool;
    var phi_2484_: lt_bvh_triangle_Intersection;
    var phi_2485_: bool;
    var phi_2489_: lt_bvh_triangle_Intersection;
    var phi_2490_: bool;
    var phi_2491_: lt_bvh_triangle_Intersection;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2497_: bool;
    var phi_2501_: lt_bvh_triangle_Intersection;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_1933_: u32;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var local_8: bool;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2619_: u32;
    var phi_2620_: u32;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_1603_: u32;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var local_9: bool;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2635_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2646_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_997_: u32;
    var phi_2657_: bool;
    var local_10: bool;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2731_: u32;
    var phi_2732_: u32;
    var phi_667_: u32;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var local_11: bool;
    var phi_2738_: bool;
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2749_: bool;
    var phi_2753_: f32;
    var phi_2774_: u32;
    var phi_2789_: u32;
    var phi_2794_: u32;
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
                phi_2743_ = bool();
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
                loop {
                    let _e475 = phi_666_;
                    if (_e475 != 4294967295u) {
                        if (_e475 < _e62) {
                        } else {
                            return;
                        }
                        let _e482 = nodes.member[(0u + _e475)].frame[3u];
                        let _e507 = (bitcast<f32>((((_e482 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e269);
                        let _e508 = (bitcast<f32>((((_e482 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e279);
                        let _e509 = (bitcast<f32>((((_e482 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e512 = nodes.member[(0u + _e475)].frame[0u];
                        let _e516 = nodes.member[(0u + _e475)].frame[1u];
                        let _e520 = nodes.member[(0u + _e475)].frame[2u];
                        let _e525 = ((bitcast<f32>(_e512) - _e113) * _e269);
                        let _e526 = ((bitcast<f32>(_e516) - _e115) * _e279);
                        let _e527 = ((bitcast<f32>(_e520) - _e117) * _e289);
                        let _e535 = nodes.member[(0u + _e475)].x;
                        if (_e269 < 0f) {
                            let _e546 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e535.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e546.unnamed.root, _e535.w), _e546.unnamed_1);
                            let _e558 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e552.unnamed, lt_bvh_traverse_Tree(_e535.x, _e552.unnamed_1.first_primitive));
                            phi_747_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e558.unnamed, lt_bvh_traverse_Tree(_e558.unnamed_1.root, _e535.y));
                        } else {
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e535.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e574.unnamed.root, _e535.y), _e574.unnamed_1);
                            let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_bvh_traverse_Tree(_e535.z, _e580.unnamed_1.first_primitive));
                            phi_747_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e586.unnamed, lt_bvh_traverse_Tree(_e586.unnamed_1.root, _e535.w));
                        }
                        let _e594 = phi_747_;
                        let _e604 = nodes.member[(0u + _e475)].y;
                        if (_e279 < 0f) {
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e615.unnamed.root, _e604.w), _e615.unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_bvh_traverse_Tree(_e604.x, _e621.unnamed_1.first_primitive));
                            phi_774_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_bvh_traverse_Tree(_e627.unnamed_1.root, _e604.y));
                        } else {
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e643.unnamed.root, _e604.y), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e604.z, _e649.unnamed_1.first_primitive));
                            phi_774_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e655.unnamed_1.root, _e604.w));
                        }
                        let _e663 = phi_774_;
                        let _e673 = nodes.member[(0u + _e475)].z;
                        if (_e289 < 0f) {
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e684.unnamed.root, _e673.w), _e684.unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e673.x, _e690.unnamed_1.first_primitive));
                            phi_801_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e696.unnamed_1.root, _e673.y));
                        } else {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.unnamed.root, _e673.y), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e673.z, _e718.unnamed_1.first_primitive));
                            phi_801_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e724.unnamed_1.root, _e673.w));
                        }
                        let _e732 = phi_801_;
                        phi_807_ = 0u;
                        phi_810_ = 0u;
                        loop {
                            let _e742 = phi_807_;
                            let _e744 = phi_810_;
                            local_2 = _e744;
                            local_3 = _e744;
                            local_4 = _e744;
                            let _e745 = (_e742 < 8u);
                            if _e745 {
                                let _e747 = (_e742 >> bitcast<u32>(2i));
                                let _e748 = (_e742 & 3u);
                                if (_e747 == 0u) {
                                    phi_824_ = _e594.unnamed.root;
                                } else {
                                    phi_824_ = _e594.unnamed.first_primitive;
                                }
                                let _e751 = phi_824_;
                                if (_e747 == 0u) {
                                    phi_834_ = _e663.unnamed.root;
                                } else {
                                    phi_834_ = _e663.unnamed.first_primitive;
                                }
                                let _e760 = phi_834_;
                                if (_e747 == 0u) {
                                    phi_844_ = _e732.unnamed.root;
                                } else {
                                    phi_844_ = _e732.unnamed.first_primitive;
                                }
                                let _e769 = phi_844_;
                                let _e782 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e751 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e317)), ((f32(((_e760 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 - _e318)));
                                let _e783 = core_intrinsics_maximum_number_nsz_f32_(_e782, ((f32(((_e769 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e319)));
                                if (_e747 == 0u) {
                                    phi_862_ = _e594.unnamed_1.root;
                                } else {
                                    phi_862_ = _e594.unnamed_1.first_primitive;
                                }
                                let _e786 = phi_862_;
                                if (_e747 == 0u) {
                                    phi_872_ = _e663.unnamed_1.root;
                                } else {
                                    phi_872_ = _e663.unnamed_1.first_primitive;
                                }
                                let _e795 = phi_872_;
                                if (_e747 == 0u) {
                                    phi_882_ = _e732.unnamed_1.root;
                                } else {
                                    phi_882_ = _e732.unnamed_1.first_primitive;
                                }
                                let _e804 = phi_882_;
                                let _e817 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e786 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e317)), ((f32(((_e795 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 + _e318)));
                                let _e818 = core_intrinsics_minimum_number_nsz_f32_(_e817, ((f32(((_e804 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e319)));
                                if (_e783 <= _e818) {
                                    if (_e783 <= _e121) {
                                        if (_e818 >= 0f) {
                                            if (_e747 == 0u) {
                                                let _e825 = nodes.member[(0u + _e475)].links[2u];
                                                phi_918_ = _e825;
                                            } else {
                                                let _e828 = nodes.member[(0u + _e475)].links[3u];
                                                phi_918_ = _e828;
                                            }
                                            let _e830 = phi_918_;
                                            let _e835 = ((_e830 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u);
                                            let _e836 = (_e835 & 31u);
                                            if (_e836 >= 24u) {
                                                phi_931_ = (24u + ((_e836 - 24u) ^ _e337));
                                            } else {
                                                phi_931_ = _e836;
                                            }
                                            let _e842 = phi_931_;
                                            phi_936_ = (_e744 | ((_e835 >> bitcast<u32>(5i)) << bitcast<u32>((_e842 & 31u))));
                                        } else {
                                            phi_936_ = _e744;
                                        }
                                        let _e850 = phi_936_;
                                        phi_937_ = _e850;
                                    } else {
                                        phi_937_ = _e744;
                                    }
                                    let _e852 = phi_937_;
                                    phi_938_ = _e852;
                                } else {
                                    phi_938_ = _e744;
                                }
                                let _e854 = phi_938_;
                                phi_808_ = (_e742 + 1u);
                                phi_811_ = _e854;
                            } else {
                                phi_808_ = u32();
                                phi_811_ = u32();
                            }
                            let _e857 = phi_808_;
                            let _e859 = phi_811_;
                            continue;
                            continuing {
                                phi_807_ = _e857;
                                phi_810_ = _e859;
                                break if !(_e745);
                            }
                        }
                        let _e863 = nodes.member[(0u + _e475)].links[0u];
                        let _e867 = nodes.member[(0u + _e475)].frame[3u];
                        let _e871 = local_2;
                        if ((_e871 & 4278190080u) == 0u) {
                        } else {
                            let _e875 = local_1.group_mask;
                            if ((_e875 & 4278190080u) == 0u) {
                            } else {
                                let _e879 = local_1.len;
                                if (_e879 < 32u) {
                                    let _e882 = local_1.group;
                                    let _e884 = local_1.len;
                                    if (_e884 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e884)] = _e882;
                                    let _e890 = local_1.group_mask;
                                    let _e892 = local_1.len;
                                    if (_e892 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e892)] = _e890;
                                    let _e899 = local_1.len;
                                    local_1.len = (_e899 + 1u);
                                }
                            }
                            local_1.group = (_e92 + _e863);
                            let _e903 = local_3;
                            local_1.group_mask = ((_e903 & 4278190080u) | (_e867 >> bitcast<u32>(24i)));
                        }
                        let _e908 = local_4;
                        phi_996_ = (_e908 & 16777215u);
                        loop {
                            let _e911 = phi_996_;
                            let _e912 = (_e911 == 0u);
                            local_10 = _e912;
                            local_17 = _e912;
                            if _e912 {
                                phi_997_ = u32();
                                phi_2657_ = false;
                            } else {
                                let _e915 = nodes.member[(0u + _e475)].links[1u];
                                let _e919 = (_e915 + select(firstTrailingBit(_e911), 32u, (_e911 == 0u)));
                                if (_e919 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e926 = instances.member[(0u + _e919)].low_world;
                                let _e928 = instances.member[(0u + _e919)].high_world;
                                let _e935 = ((_e926.x - _e113) * _e269);
                                let _e936 = ((_e926.y - _e115) * _e279);
                                let _e937 = ((_e926.z - _e117) * _e289);
                                let _e944 = ((_e928.x - _e113) * _e269);
                                let _e945 = ((_e928.y - _e115) * _e279);
                                let _e946 = ((_e928.z - _e117) * _e289);
                                if (_e935 < _e944) {
                                    phi_1046_ = _e935;
                                } else {
                                    phi_1046_ = _e944;
                                }
                                let _e949 = phi_1046_;
                                if (_e936 < _e945) {
                                    phi_1051_ = _e936;
                                } else {
                                    phi_1051_ = _e945;
                                }
                                let _e952 = phi_1051_;
                                if (_e937 < _e946) {
                                    phi_1056_ = _e937;
                                } else {
                                    phi_1056_ = _e946;
                                }
                                let _e955 = phi_1056_;
                                if (_e935 > _e944) {
                                    phi_1064_ = _e935;
                                } else {
                                    phi_1064_ = _e944;
                                }
                                let _e961 = phi_1064_;
                                if (_e936 > _e945) {
                                    phi_1069_ = _e936;
                                } else {
                                    phi_1069_ = _e945;
                                }
                                let _e964 = phi_1069_;
                                if (_e937 > _e946) {
                                    phi_1074_ = _e937;
                                } else {
                                    phi_1074_ = _e946;
                                }
                                let _e967 = phi_1074_;
                                let _e971 = core_intrinsics_maximum_number_nsz_f32_((_e949 - _e324), (_e952 - _e325));
                                let _e972 = core_intrinsics_maximum_number_nsz_f32_(_e971, (_e955 - _e326));
                                let _e973 = core_intrinsics_minimum_number_nsz_f32_((_e961 + _e324), (_e964 + _e325));
                                let _e974 = core_intrinsics_minimum_number_nsz_f32_(_e973, (_e967 + _e326));
                                if (_e972 <= _e974) {
                                    if (_e972 <= _e121) {
                                        if (_e974 >= 0f) {
                                            let _e980 = instances.member[(0u + _e919)].world_to_object[0u];
                                            let _e991 = ((((_e980.x * _e113) + (_e980.y * _e115)) + (_e980.z * _e117)) + (_e980.w * 1f));
                                            let _e993 = instances.member[(0u + _e919)].world_to_object[1u];
                                            let _e1004 = ((((_e993.x * _e113) + (_e993.y * _e115)) + (_e993.z * _e117)) + (_e993.w * 1f));
                                            let _e1006 = instances.member[(0u + _e919)].world_to_object[2u];
                                            let _e1017 = ((((_e1006.x * _e113) + (_e1006.y * _e115)) + (_e1006.z * _e117)) + (_e1006.w * 1f));
                                            let _e1020 = instances.member[(0u + _e919)].world_to_object[0u];
                                            let _e1031 = ((((_e1020.x * _e129) + (_e1020.y * _e130)) + (_e1020.z * _e131)) + (_e1020.w * 0f));
                                            let _e1033 = instances.member[(0u + _e919)].world_to_object[1u];
                                            let _e1044 = ((((_e1033.x * _e129) + (_e1033.y * _e130)) + (_e1033.z * _e131)) + (_e1033.w * 0f));
                                            let _e1046 = instances.member[(0u + _e919)].world_to_object[2u];
                                            let _e1057 = ((((_e1046.x * _e129) + (_e1046.y * _e130)) + (_e1046.z * _e131)) + (_e1046.w * 0f));
                                            let _e1060 = instances.member[(0u + _e919)].root;
                                            let _e1062 = instances.member[(0u + _e919)].first_triangle;
                                            let _e1066 = abs(_e1031);
                                            let _e1067 = abs(_e1044);
                                            let _e1068 = abs(_e1057);
                                            if (abs(_e991) < 1000000000000000f) {
                                                if (abs(_e1004) < 1000000000000000f) {
                                                    if (abs(_e1017) < 1000000000000000f) {
                                                        if (_e1066 < 1000000000000000f) {
                                                            if (_e1067 < 1000000000000000f) {
                                                                if (_e1068 < 1000000000000000f) {
                                                                    if (_e1066 > 0f) {
                                                                        phi_1219_ = bool();
                                                                        phi_1220_ = true;
                                                                    } else {
                                                                        let _e1076 = (_e1067 > 0f);
                                                                        if _e1076 {
                                                                            phi_1218_ = bool();
                                                                        } else {
                                                                            phi_1218_ = (_e1068 > 0f);
                                                                        }
                                                                        let _e1079 = phi_1218_;
                                                                        phi_1219_ = _e1079;
                                                                        phi_1220_ = _e1076;
                                                                    }
                                                                    let _e1081 = phi_1219_;
                                                                    let _e1083 = phi_1220_;
                                                                    if _e1083 {
                                                                        phi_1224_ = true;
                                                                    } else {
                                                                        phi_1224_ = _e1081;
                                                                    }
                                                                    let _e1085 = phi_1224_;
                                                                    phi_1225_ = _e1085;
                                                                    phi_1226_ = false;
                                                                } else {
                                                                    phi_1225_ = bool();
                                                                    phi_1226_ = true;
                                                                }
                                                                let _e1087 = phi_1225_;
                                                                let _e1089 = phi_1226_;
                                                                phi_1227_ = _e1087;
                                                                phi_1228_ = false;
                                                                phi_1229_ = _e1089;
                                                            } else {
                                                                phi_1227_ = bool();
                                                                phi_1228_ = true;
                                                                phi_1229_ = false;
                                                            }
                                                            let _e1091 = phi_1227_;
                                                            let _e1093 = phi_1228_;
                                                            let _e1095 = phi_1229_;
                                                            phi_1230_ = _e1091;
                                                            phi_1231_ = _e1093;
                                                            phi_1232_ = _e1095;
                                                        } else {
                                                            phi_1230_ = bool();
                                                            phi_1231_ = true;
                                                            phi_1232_ = false;
                                                        }
                                                        let _e1097 = phi_1230_;
                                                        let _e1099 = phi_1231_;
                                                        let _e1101 = phi_1232_;
                                                        phi_1233_ = _e1097;
                                                        phi_1234_ = _e1099;
                                                        phi_1235_ = _e1101;
                                                    } else {
                                                        phi_1233_ = bool();
                                                        phi_1234_ = true;
                                                        phi_1235_ = false;
                                                    }
                                                    let _e1103 = phi_1233_;
                                                    let _e1105 = phi_1234_;
                                                    let _e1107 = phi_1235_;
                                                    phi_1236_ = _e1103;
                                                    phi_1237_ = _e1105;
                                                    phi_1238_ = _e1107;
                                                } else {
                                                    phi_1236_ = bool();
                                                    phi_1237_ = true;
                                                    phi_1238_ = false;
                                                }
                                                let _e1109 = phi_1236_;
                                                let _e1111 = phi_1237_;
                                                let _e1113 = phi_1238_;
                                                phi_1239_ = _e1109;
                                                phi_1240_ = _e1111;
                                                phi_1241_ = _e1113;
                                            } else {
                                                phi_1239_ = bool();
                                                phi_1240_ = true;
                                                phi_1241_ = false;
                                            }
                                            let _e1115 = phi_1239_;
                                            let _e1117 = phi_1240_;
                                            let _e1119 = phi_1241_;
                                            if _e1117 {
                                                phi_1245_ = true;
                                            } else {
                                                phi_1245_ = _e1119;
                                            }
                                            let _e1121 = phi_1245_;
                                            if _e1121 {
                                                phi_1249_ = false;
                                            } else {
                                                phi_1249_ = _e1115;
                                            }
                                            let _e1123 = phi_1249_;
                                            if _e1123 {
                                                let _e1124 = (_e1060 >= _e62);
                                                if _e1124 {
                                                    phi_2640_ = bool();
                                                } else {
                                                    if (_e1060 < _e62) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1130 = nodes.member[(0u + _e1060)].frame[0u];
                                                    let _e1134 = nodes.member[(0u + _e1060)].frame[1u];
                                                    let _e1138 = nodes.member[(0u + _e1060)].frame[2u];
                                                    let _e1142 = nodes.member[(0u + _e1060)].frame[0u];
                                                    let _e1146 = nodes.member[(0u + _e1060)].frame[1u];
                                                    let _e1150 = nodes.member[(0u + _e1060)].frame[2u];
                                                    let _e1154 = nodes.member[(0u + _e1060)].frame[3u];
                                                    let _e1188 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1031), abs(_e1044));
                                                    let _e1189 = core_intrinsics_maximum_number_nsz_f32_(_e1188, abs(_e1057));
                                                    let _e1190 = (_e1189 * 0.0000000000009094947f);
                                                    if (abs(_e1031) < _e1190) {
                                                        phi_1319_ = _e1190;
                                                    } else {
                                                        phi_1319_ = abs(_e1031);
                                                    }
                                                    let _e1195 = phi_1319_;
                                                    if (_e1031 < 0f) {
                                                        phi_1326_ = (-1f / _e1195);
                                                    } else {
                                                        phi_1326_ = (1f / _e1195);
                                                    }
                                                    let _e1200 = phi_1326_;
                                                    if (abs(_e1044) < _e1190) {
                                                        phi_1333_ = _e1190;
                                                    } else {
                                                        phi_1333_ = abs(_e1044);
                                                    }
                                                    let _e1205 = phi_1333_;
                                                    if (_e1044 < 0f) {
                                                        phi_1340_ = (-1f / _e1205);
                                                    } else {
                                                        phi_1340_ = (1f / _e1205);
                                                    }
                                                    let _e1210 = phi_1340_;
                                                    if (abs(_e1057) < _e1190) {
                                                        phi_1347_ = _e1190;
                                                    } else {
                                                        phi_1347_ = abs(_e1057);
                                                    }
                                                    let _e1215 = phi_1347_;
                                                    if (_e1057 < 0f) {
                                                        phi_1354_ = (-1f / _e1215);
                                                    } else {
                                                        phi_1354_ = (1f / _e1215);
                                                    }
                                                    let _e1220 = phi_1354_;
                                                    let _e1224 = abs((bitcast<f32>(_e1130) - _e991));
                                                    let _e1225 = abs((bitcast<f32>(_e1134) - _e1004));
                                                    let _e1226 = abs((bitcast<f32>(_e1138) - _e1017));
                                                    let _e1230 = abs(((bitcast<f32>(_e1142) + (bitcast<f32>((((_e1154 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e991));
                                                    let _e1231 = abs(((bitcast<f32>(_e1146) + (bitcast<f32>((((_e1154 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1004));
                                                    let _e1232 = abs(((bitcast<f32>(_e1150) + (bitcast<f32>((((_e1154 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1017));
                                                    if (_e1224 > _e1230) {
                                                        phi_1371_ = _e1224;
                                                    } else {
                                                        phi_1371_ = _e1230;
                                                    }
                                                    let _e1235 = phi_1371_;
                                                    if (_e1225 > _e1231) {
                                                        phi_1376_ = _e1225;
                                                    } else {
                                                        phi_1376_ = _e1231;
                                                    }
                                                    let _e1238 = phi_1376_;
                                                    if (_e1226 > _e1232) {
                                                        phi_1381_ = _e1226;
                                                    } else {
                                                        phi_1381_ = _e1232;
                                                    }
                                                    let _e1241 = phi_1381_;
                                                    let _e1242 = core_intrinsics_maximum_number_nsz_f32_(_e1235, _e1238);
                                                    let _e1243 = core_intrinsics_maximum_number_nsz_f32_(_e1242, _e1241);
                                                    let _e1247 = (_e1243 * 0.0000019073486f);
                                                    let _e1248 = (abs(_e1200) * _e1247);
                                                    let _e1249 = (abs(_e1210) * _e1247);
                                                    let _e1250 = (abs(_e1220) * _e1247);
                                                    let _e1254 = (_e1243 * 0.0000009536743f);
                                                    let _e1255 = (abs(_e1200) * _e1254);
                                                    let _e1256 = (abs(_e1210) * _e1254);
                                                    let _e1257 = (abs(_e1220) * _e1254);
                                                    let _e1258 = abs(_e1031);
                                                    let _e1259 = abs(_e1044);
                                                    let _e1260 = abs(_e1057);
                                                    if (_e1258 >= _e1259) {
                                                        if (_e1258 >= _e1260) {
                                                            phi_1409_ = false;
                                                        } else {
                                                            phi_1409_ = true;
                                                        }
                                                        let _e1264 = phi_1409_;
                                                        phi_1410_ = _e1264;
                                                    } else {
                                                        phi_1410_ = true;
                                                    }
                                                    let _e1266 = phi_1410_;
                                                    if _e1266 {
                                                        if (_e1259 >= _e1260) {
                                                            phi_1418_ = 1u;
                                                        } else {
                                                            phi_1418_ = 2u;
                                                        }
                                                        let _e1269 = phi_1418_;
                                                        phi_1419_ = _e1269;
                                                    } else {
                                                        phi_1419_ = 0u;
                                                    }
                                                    let _e1271 = phi_1419_;
                                                    if (_e1271 == 0u) {
                                                        phi_1431_ = vec3<f32>(_e1044, _e1057, _e1031);
                                                    } else {
                                                        if (_e1271 == 1u) {
                                                            phi_1430_ = vec3<f32>(_e1057, _e1031, _e1044);
                                                        } else {
                                                            phi_1430_ = vec3<f32>(_e1031, _e1044, _e1057);
                                                        }
                                                        let _e1277 = phi_1430_;
                                                        phi_1431_ = _e1277;
                                                    }
                                                    let _e1279 = phi_1431_;
                                                    let _e1282 = (_e1279.x / _e1279.z);
                                                    let _e1285 = (_e1279.y / _e1279.z);
                                                    if (_e1200 < 0f) {
                                                        phi_1444_ = 0u;
                                                    } else {
                                                        phi_1444_ = 1u;
                                                    }
                                                    let _e1290 = phi_1444_;
                                                    if (_e1210 < 0f) {
                                                        phi_1449_ = 0u;
                                                    } else {
                                                        phi_1449_ = 2u;
                                                    }
                                                    let _e1293 = phi_1449_;
                                                    if (_e1220 < 0f) {
                                                        phi_1454_ = 0u;
                                                    } else {
                                                        phi_1454_ = 4u;
                                                    }
                                                    let _e1296 = phi_1454_;
                                                    let _e1298 = ((_e1290 | _e1293) | _e1296);
                                                    let _e1299 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1060, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1299.first[0], _e1299.first[1], _e1299.first[2], _e1299.first[3], _e1299.first[4], _e1299.first[5], _e1299.first[6], _e1299.first[7], _e1299.first[8], _e1299.first[9], _e1299.first[10], _e1299.first[11], _e1299.first[12], _e1299.first[13], _e1299.first[14], _e1299.first[15], _e1299.first[16], _e1299.first[17], _e1299.first[18], _e1299.first[19], _e1299.first[20], _e1299.first[21], _e1299.first[22], _e1299.first[23], _e1299.first[24], _e1299.first[25], _e1299.first[26], _e1299.first[27], _e1299.first[28], _e1299.first[29], _e1299.first[30], _e1299.first[31]), array<u32, 32>(_e1299.mask[0], _e1299.mask[1], _e1299.mask[2], _e1299.mask[3], _e1299.mask[4], _e1299.mask[5], _e1299.mask[6], _e1299.mask[7], _e1299.mask[8], _e1299.mask[9], _e1299.mask[10], _e1299.mask[11], _e1299.mask[12], _e1299.mask[13], _e1299.mask[14], _e1299.mask[15], _e1299.mask[16], _e1299.mask[17], _e1299.mask[18], _e1299.mask[19], _e1299.mask[20], _e1299.mask[21], _e1299.mask[22], _e1299.mask[23], _e1299.mask[24], _e1299.mask[25], _e1299.mask[26], _e1299.mask[27], _e1299.mask[28], _e1299.mask[29], _e1299.mask[30], _e1299.mask[31]), _e1299.len, _e1299.group, _e1299.group_mask);
                                                    let _e1373 = local.group_mask;
                                                    if ((_e1373 & 4278190080u) == 0u) {
                                                        let _e1377 = local.len;
                                                        if (_e1377 == 0u) {
                                                            phi_1568_ = false;
                                                        } else {
                                                            let _e1381 = local.len;
                                                            local.len = (_e1381 - 1u);
                                                            let _e1384 = local.len;
                                                            if (_e1384 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1389 = local.first[(0u + _e1384)];
                                                            local.group = _e1389;
                                                            let _e1392 = local.len;
                                                            if (_e1392 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1397 = local.mask[(0u + _e1392)];
                                                            local.group_mask = _e1397;
                                                            phi_1568_ = true;
                                                        }
                                                        let _e1400 = phi_1568_;
                                                        phi_1569_ = _e1400;
                                                    } else {
                                                        phi_1569_ = true;
                                                    }
                                                    let _e1402 = phi_1569_;
                                                    if _e1402 {
                                                        let _e1404 = local.group_mask;
                                                        let _e1410 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1404)), 32u, (_e1404 == 0u)));
                                                        let _e1414 = local.group_mask;
                                                        let _e1428 = local.group_mask;
                                                        local.group_mask = (_e1428 & ~((1u << bitcast<u32>((_e1410 & 31u)))));
                                                        let _e1431 = local.group;
                                                        phi_1600_ = (_e1431 + countOneBits(((_e1414 & ~((4294967295u << bitcast<u32>((((_e1410 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1600_ = 4294967295u;
                                                    }
                                                    let _e1434 = phi_1600_;
                                                    phi_1602_ = _e1434;
                                                    loop {
                                                        let _e1436 = phi_1602_;
                                                        if (_e1436 != 4294967295u) {
                                                            if (_e1436 < _e62) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1443 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1468 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1200);
                                                            let _e1469 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1210);
                                                            let _e1470 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1220);
                                                            let _e1473 = nodes.member[(0u + _e1436)].frame[0u];
                                                            let _e1477 = nodes.member[(0u + _e1436)].frame[1u];
                                                            let _e1481 = nodes.member[(0u + _e1436)].frame[2u];
                                                            let _e1486 = ((bitcast<f32>(_e1473) - _e991) * _e1200);
                                                            let _e1487 = ((bitcast<f32>(_e1477) - _e1004) * _e1210);
                                                            let _e1488 = ((bitcast<f32>(_e1481) - _e1017) * _e1220);
                                                            let _e1496 = nodes.member[(0u + _e1436)].x;
                                                            if (_e1200 < 0f) {
                                                                let _e1507 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1496.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1513 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1507.unnamed.root, _e1496.w), _e1507.unnamed_1);
                                                                let _e1519 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1513.unnamed, lt_bvh_traverse_Tree(_e1496.x, _e1513.unnamed_1.first_primitive));
                                                                phi_1683_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1519.unnamed, lt_bvh_traverse_Tree(_e1519.unnamed_1.root, _e1496.y));
                                                            } else {
                                                                let _e1535 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1496.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1535.unnamed.root, _e1496.y), _e1535.unnamed_1);
                                                                let _e1547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_bvh_traverse_Tree(_e1496.z, _e1541.unnamed_1.first_primitive));
                                                                phi_1683_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1547.unnamed, lt_bvh_traverse_Tree(_e1547.unnamed_1.root, _e1496.w));
                                                            }
                                                            let _e1555 = phi_1683_;
                                                            let _e1565 = nodes.member[(0u + _e1436)].y;
                                                            if (_e1210 < 0f) {
                                                                let _e1576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1576.unnamed.root, _e1565.w), _e1576.unnamed_1);
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1582.unnamed, lt_bvh_traverse_Tree(_e1565.x, _e1582.unnamed_1.first_primitive));
                                                                phi_1710_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1588.unnamed, lt_bvh_traverse_Tree(_e1588.unnamed_1.root, _e1565.y));
                                                            } else {
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1604.unnamed.root, _e1565.y), _e1604.unnamed_1);
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_bvh_traverse_Tree(_e1565.z, _e1610.unnamed_1.first_primitive));
                                                                phi_1710_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1616.unnamed, lt_bvh_traverse_Tree(_e1616.unnamed_1.root, _e1565.w));
                                                            }
                                                            let _e1624 = phi_1710_;
                                                            let _e1634 = nodes.member[(0u + _e1436)].z;
                                                            if (_e1220 < 0f) {
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1645.unnamed.root, _e1634.w), _e1645.unnamed_1);
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1651.unnamed, lt_bvh_traverse_Tree(_e1634.x, _e1651.unnamed_1.first_primitive));
                                                                phi_1737_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_bvh_traverse_Tree(_e1657.unnamed_1.root, _e1634.y));
                                                            } else {
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1673.unnamed.root, _e1634.y), _e1673.unnamed_1);
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_bvh_traverse_Tree(_e1634.z, _e1679.unnamed_1.first_primitive));
                                                                phi_1737_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1685.unnamed, lt_bvh_traverse_Tree(_e1685.unnamed_1.root, _e1634.w));
                                                            }
                                                            let _e1693 = phi_1737_;
                                                            phi_1743_ = 0u;
                                                            phi_1746_ = 0u;
                                                            loop {
                                                                let _e1703 = phi_1743_;
                                                                let _e1705 = phi_1746_;
                                                                local_5 = _e1705;
                                                                local_6 = _e1705;
                                                                local_7 = _e1705;
                                                                let _e1706 = (_e1703 < 8u);
                                                                if _e1706 {
                                                                    let _e1708 = (_e1703 >> bitcast<u32>(2i));
                                                                    let _e1709 = (_e1703 & 3u);
                                                                    if (_e1708 == 0u) {
                                                                        phi_1760_ = _e1555.unnamed.root;
                                                                    } else {
                                                                        phi_1760_ = _e1555.unnamed.first_primitive;
                                                                    }
                                                                    let _e1712 = phi_1760_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1770_ = _e1624.unnamed.root;
                                                                    } else {
                                                                        phi_1770_ = _e1624.unnamed.first_primitive;
                                                                    }
                                                                    let _e1721 = phi_1770_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1780_ = _e1693.unnamed.root;
                                                                    } else {
                                                                        phi_1780_ = _e1693.unnamed.first_primitive;
                                                                    }
                                                                    let _e1730 = phi_1780_;
                                                                    let _e1743 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1712 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 - _e1248)), ((f32(((_e1721 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1249)));
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(_e1743, ((f32(((_e1730 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1250)));
                                                                    if (_e1708 == 0u) {
                                                                        phi_1798_ = _e1555.unnamed_1.root;
                                                                    } else {
                                                                        phi_1798_ = _e1555.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1747 = phi_1798_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1808_ = _e1624.unnamed_1.root;
                                                                    } else {
                                                                        phi_1808_ = _e1624.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1756 = phi_1808_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1818_ = _e1693.unnamed_1.root;
                                                                    } else {
                                                                        phi_1818_ = _e1693.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1765 = phi_1818_;
                                                                    let _e1778 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1747 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 + _e1248)), ((f32(((_e1756 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1249)));
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(_e1778, ((f32(((_e1765 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1250)));
                                                                    if (_e1744 <= _e1779) {
                                                                        if (_e1744 <= _e121) {
                                                                            if (_e1779 >= 0f) {
                                                                                if (_e1708 == 0u) {
                                                                                    let _e1786 = nodes.member[(0u + _e1436)].links[2u];
                                                                                    phi_1854_ = _e1786;
                                                                                } else {
                                                                                    let _e1789 = nodes.member[(0u + _e1436)].links[3u];
                                                                                    phi_1854_ = _e1789;
                                                                                }
                                                                                let _e1791 = phi_1854_;
                                                                                let _e1796 = ((_e1791 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u);
                                                                                let _e1797 = (_e1796 & 31u);
                                                                                if (_e1797 >= 24u) {
                                                                                    phi_1867_ = (24u + ((_e1797 - 24u) ^ _e1298));
                                                                                } else {
                                                                                    phi_1867_ = _e1797;
                                                                                }
                                                                                let _e1803 = phi_1867_;
                                                                                phi_1872_ = (_e1705 | ((_e1796 >> bitcast<u32>(5i)) << bitcast<u32>((_e1803 & 31u))));
                                                                            } else {
                                                                                phi_1872_ = _e1705;
                                                                            }
                                                                            let _e1811 = phi_1872_;
                                                                            phi_1873_ = _e1811;
                                                                        } else {
                                                                            phi_1873_ = _e1705;
                                                                        }
                                                                        let _e1813 = phi_1873_;
                                                                        phi_1874_ = _e1813;
                                                                    } else {
                                                                        phi_1874_ = _e1705;
                                                                    }
                                                                    let _e1815 = phi_1874_;
                                                                    phi_1744_ = (_e1703 + 1u);
                                                                    phi_1747_ = _e1815;
                                                                } else {
                                                                    phi_1744_ = u32();
                                                                    phi_1747_ = u32();
                                                                }
                                                                let _e1818 = phi_1744_;
                                                                let _e1820 = phi_1747_;
                                                                continue;
                                                                continuing {
                                                                    phi_1743_ = _e1818;
                                                                    phi_1746_ = _e1820;
                                                                    break if !(_e1706);
                                                                }
                                                            }
                                                            let _e1824 = nodes.member[(0u + _e1436)].links[0u];
                                                            let _e1828 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1832 = local_5;
                                                            if ((_e1832 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1836 = local.group_mask;
                                                                if ((_e1836 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1840 = local.len;
                                                                    if (_e1840 < 32u) {
                                                                        let _e1843 = local.group;
                                                                        let _e1845 = local.len;
                                                                        if (_e1845 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1845)] = _e1843;
                                                                        let _e1851 = local.group_mask;
                                                                        let _e1853 = local.len;
                                                                        if (_e1853 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1853)] = _e1851;
                                                                        let _e1860 = local.len;
                                                                        local.len = (_e1860 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1060 + _e1824);
                                                                let _e1864 = local_6;
                                                                local.group_mask = ((_e1864 & 4278190080u) | (_e1828 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1869 = local_7;
                                                            phi_1932_ = (_e1869 & 16777215u);
                                                            loop {
                                                                let _e1872 = phi_1932_;
                                                                let _e1873 = (_e1872 == 0u);
                                                                local_8 = _e1873;
                                                                local_14 = _e1873;
                                                                if _e1873 {
                                                                    phi_1933_ = u32();
                                                                    phi_2543_ = false;
                                                                    phi_2544_ = false;
                                                                    phi_2545_ = false;
                                                                } else {
                                                                    let _e1876 = nodes.member[(0u + _e1436)].links[1u];
                                                                    let _e1881 = ((_e1062 + _e1876) + select(firstTrailingBit(_e1872), 32u, (_e1872 == 0u)));
                                                                    if (_e1881 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1888 = triangles.member[(0u + _e1881)].v0_;
                                                                    let _e1890 = (_e1888.x - _e991);
                                                                    let _e1892 = (_e1888.y - _e1004);
                                                                    let _e1894 = (_e1888.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_1978_ = vec3<f32>(_e1892, _e1894, _e1890);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_1977_ = vec3<f32>(_e1894, _e1890, _e1892);
                                                                        } else {
                                                                            phi_1977_ = (_e1888 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1902 = phi_1977_;
                                                                        phi_1978_ = _e1902;
                                                                    }
                                                                    let _e1904 = phi_1978_;
                                                                    let _e1908 = (_e1904.x - (_e1282 * _e1904.z));
                                                                    let _e1912 = (_e1904.y - (_e1285 * _e1904.z));
                                                                    let _e1914 = triangles.member[(0u + _e1881)].v1_;
                                                                    let _e1916 = (_e1914.x - _e991);
                                                                    let _e1918 = (_e1914.y - _e1004);
                                                                    let _e1920 = (_e1914.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2008_ = vec3<f32>(_e1918, _e1920, _e1916);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2007_ = vec3<f32>(_e1920, _e1916, _e1918);
                                                                        } else {
                                                                            phi_2007_ = (_e1914 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1928 = phi_2007_;
                                                                        phi_2008_ = _e1928;
                                                                    }
                                                                    let _e1930 = phi_2008_;
                                                                    let _e1934 = (_e1930.x - (_e1282 * _e1930.z));
                                                                    let _e1938 = (_e1930.y - (_e1285 * _e1930.z));
                                                                    let _e1940 = triangles.member[(0u + _e1881)].v2_;
                                                                    let _e1942 = (_e1940.x - _e991);
                                                                    let _e1944 = (_e1940.y - _e1004);
                                                                    let _e1946 = (_e1940.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2038_ = vec3<f32>(_e1944, _e1946, _e1942);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2037_ = vec3<f32>(_e1946, _e1942, _e1944);
                                                                        } else {
                                                                            phi_2037_ = (_e1940 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1954 = phi_2037_;
                                                                        phi_2038_ = _e1954;
                                                                    }
                                                                    let _e1956 = phi_2038_;
                                                                    let _e1960 = (_e1956.x - (_e1282 * _e1956.z));
                                                                    let _e1964 = (_e1956.y - (_e1285 * _e1956.z));
                                                                    if (_e1934 < _e1960) {
                                                                        phi_2057_ = true;
                                                                    } else {
                                                                        if (_e1934 == _e1960) {
                                                                            phi_2056_ = (_e1938 < _e1964);
                                                                        } else {
                                                                            phi_2056_ = false;
                                                                        }
                                                                        let _e1969 = phi_2056_;
                                                                        phi_2057_ = _e1969;
                                                                    }
                                                                    let _e1971 = phi_2057_;
                                                                    if _e1971 {
                                                                        phi_2061_ = _e1964;
                                                                        phi_2062_ = _e1960;
                                                                        phi_2063_ = _e1938;
                                                                        phi_2064_ = _e1934;
                                                                    } else {
                                                                        phi_2061_ = _e1938;
                                                                        phi_2062_ = _e1934;
                                                                        phi_2063_ = _e1964;
                                                                        phi_2064_ = _e1960;
                                                                    }
                                                                    let _e1973 = phi_2061_;
                                                                    let _e1975 = phi_2062_;
                                                                    let _e1977 = phi_2063_;
                                                                    let _e1979 = phi_2064_;
                                                                    let _e1982 = ((_e1979 * _e1973) - (_e1977 * _e1975));
                                                                    if _e1971 {
                                                                        phi_2072_ = -(_e1982);
                                                                    } else {
                                                                        phi_2072_ = _e1982;
                                                                    }
                                                                    let _e1985 = phi_2072_;
                                                                    if (_e1960 < _e1908) {
                                                                        phi_2083_ = true;
                                                                    } else {
                                                                        if (_e1960 == _e1908) {
                                                                            phi_2082_ = (_e1964 < _e1912);
                                                                        } else {
                                                                            phi_2082_ = false;
                                                                        }
                                                                        let _e1990 = phi_2082_;
                                                                        phi_2083_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2083_;
                                                                    if _e1992 {
                                                                        phi_2087_ = _e1912;
                                                                        phi_2088_ = _e1908;
                                                                        phi_2089_ = _e1964;
                                                                        phi_2090_ = _e1960;
                                                                    } else {
                                                                        phi_2087_ = _e1964;
                                                                        phi_2088_ = _e1960;
                                                                        phi_2089_ = _e1912;
                                                                        phi_2090_ = _e1908;
                                                                    }
                                                                    let _e1994 = phi_2087_;
                                                                    let _e1996 = phi_2088_;
                                                                    let _e1998 = phi_2089_;
                                                                    let _e2000 = phi_2090_;
                                                                    let _e2003 = ((_e2000 * _e1994) - (_e1998 * _e1996));
                                                                    if _e1992 {
                                                                        phi_2098_ = -(_e2003);
                                                                    } else {
                                                                        phi_2098_ = _e2003;
                                                                    }
                                                                    let _e2006 = phi_2098_;
                                                                    if (_e1908 < _e1934) {
                                                                        phi_2109_ = true;
                                                                    } else {
                                                                        if (_e1908 == _e1934) {
                                                                            phi_2108_ = (_e1912 < _e1938);
                                                                        } else {
                                                                            phi_2108_ = false;
                                                                        }
                                                                        let _e2011 = phi_2108_;
                                                                        phi_2109_ = _e2011;
                                                                    }
                                                                    let _e2013 = phi_2109_;
                                                                    if _e2013 {
                                                                        phi_2113_ = _e1938;
                                                                        phi_2114_ = _e1934;
                                                                        phi_2115_ = _e1912;
                                                                        phi_2116_ = _e1908;
                                                                    } else {
                                                                        phi_2113_ = _e1912;
                                                                        phi_2114_ = _e1908;
                                                                        phi_2115_ = _e1938;
                                                                        phi_2116_ = _e1934;
                                                                    }
                                                                    let _e2015 = phi_2113_;
                                                                    let _e2017 = phi_2114_;
                                                                    let _e2019 = phi_2115_;
                                                                    let _e2021 = phi_2116_;
                                                                    let _e2024 = ((_e2021 * _e2015) - (_e2019 * _e2017));
                                                                    if _e2013 {
                                                                        phi_2124_ = -(_e2024);
                                                                    } else {
                                                                        phi_2124_ = _e2024;
                                                                    }
                                                                    let _e2027 = phi_2124_;
                                                                    if (_e1985 >= 0f) {
                                                                        if (_e2006 >= 0f) {
                                                                            if (_e2027 >= 0f) {
                                                                                phi_2139_ = ((_e1985 + _e2006) + _e2027);
                                                                                phi_2140_ = false;
                                                                            } else {
                                                                                phi_2139_ = f32();
                                                                                phi_2140_ = true;
                                                                            }
                                                                            let _e2034 = phi_2139_;
                                                                            let _e2036 = phi_2140_;
                                                                            phi_2141_ = _e2034;
                                                                            phi_2142_ = _e2036;
                                                                        } else {
                                                                            phi_2141_ = f32();
                                                                            phi_2142_ = true;
                                                                        }
                                                                        let _e2038 = phi_2141_;
                                                                        let _e2040 = phi_2142_;
                                                                        phi_2143_ = _e2038;
                                                                        phi_2144_ = _e2040;
                                                                    } else {
                                                                        phi_2143_ = f32();
                                                                        phi_2144_ = true;
                                                                    }
                                                                    let _e2042 = phi_2143_;
                                                                    let _e2044 = phi_2144_;
                                                                    if _e2044 {
                                                                        if (_e1985 <= 0f) {
                                                                            if (_e2006 <= 0f) {
                                                                                let _e2047 = (_e2027 <= 0f);
                                                                                if _e2047 {
                                                                                }
                                                                                phi_2162_ = ((_e1985 + _e2006) + _e2027);
                                                                                phi_2163_ = false;
                                                                                phi_2164_ = _e2047;
                                                                            } else {
                                                                                phi_2162_ = f32();
                                                                                phi_2163_ = true;
                                                                                phi_2164_ = false;
                                                                            }
                                                                            let _e2051 = phi_2162_;
                                                                            let _e2053 = phi_2163_;
                                                                            let _e2055 = phi_2164_;
                                                                            phi_2165_ = _e2051;
                                                                            phi_2166_ = _e2053;
                                                                            phi_2167_ = _e2055;
                                                                        } else {
                                                                            phi_2165_ = f32();
                                                                            phi_2166_ = true;
                                                                            phi_2167_ = false;
                                                                        }
                                                                        let _e2057 = phi_2165_;
                                                                        let _e2059 = phi_2166_;
                                                                        let _e2061 = phi_2167_;
                                                                        if _e2059 {
                                                                            phi_2171_ = false;
                                                                        } else {
                                                                            phi_2171_ = _e2061;
                                                                        }
                                                                        let _e2063 = phi_2171_;
                                                                        phi_2172_ = _e2057;
                                                                        phi_2173_ = _e2063;
                                                                    } else {
                                                                        phi_2172_ = _e2042;
                                                                        phi_2173_ = true;
                                                                    }
                                                                    let _e2065 = phi_2172_;
                                                                    let _e2067 = phi_2173_;
                                                                    if _e2067 {
                                                                        let _e2068 = (_e2065 == 0f);
                                                                        if _e2068 {
                                                                            phi_2489_ = lt_bvh_triangle_Intersection();
                                                                            phi_2490_ = false;
                                                                        } else {
                                                                            let _e2070 = triangles.member[(0u + _e1881)].v0_;
                                                                            let _e2072 = (_e2070.x - _e991);
                                                                            let _e2074 = (_e2070.y - _e1004);
                                                                            let _e2076 = (_e2070.z - _e1017);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2202_ = vec3<f32>(_e2074, _e2076, _e2072);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2201_ = vec3<f32>(_e2076, _e2072, _e2074);
                                                                                } else {
                                                                                    phi_2201_ = (_e2070 - vec3<f32>(_e991, _e1004, _e1017));
                                                                                }
                                                                                let _e2084 = phi_2201_;
                                                                                phi_2202_ = _e2084;
                                                                            }
                                                                            let _e2086 = phi_2202_;
                                                                            let _e2088 = triangles.member[(0u + _e1881)].v1_;
                                                                            let _e2090 = triangles.member[(0u + _e1881)].v0_;
                                                                            let _e2093 = (_e2088.x - _e2090.x);
                                                                            let _e2096 = (_e2088.y - _e2090.y);
                                                                            let _e2099 = (_e2088.z - _e2090.z);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2228_ = vec3<f32>(_e2096, _e2099, _e2093);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2227_ = vec3<f32>(_e2099, _e2093, _e2096);
                                                                                } else {
                                                                                    phi_2227_ = (_e2088 - _e2090);
                                                                                }
                                                                                let _e2106 = phi_2227_;
                                                                                phi_2228_ = _e2106;
                                                                            }
                                                                            let _e2108 = phi_2228_;
                                                                            let _e2110 = triangles.member[(0u + _e1881)].v2_;
                                                                            let _e2112 = triangles.member[(0u + _e1881)].v0_;
                                                                            let _e2115 = (_e2110.x - _e2112.x);
                                                                            let _e2118 = (_e2110.y - _e2112.y);
                                                                            let _e2121 = (_e2110.z - _e2112.z);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2254_ = vec3<f32>(_e2118, _e2121, _e2115);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2253_ = vec3<f32>(_e2121, _e2115, _e2118);
                                                                                } else {
                                                                                    phi_2253_ = (_e2110 - _e2112);
                                                                                }
                                                                                let _e2128 = phi_2253_;
                                                                                phi_2254_ = _e2128;
                                                                            }
                                                                            let _e2130 = phi_2254_;
                                                                            let _e2137 = ((_e2108.y * _e2130.z) - (_e2108.z * _e2130.y));
                                                                            let _e2144 = ((_e2108.z * _e2130.x) - (_e2108.x * _e2130.z));
                                                                            let _e2151 = ((_e2108.x * _e2130.y) - (_e2108.y * _e2130.x));
                                                                            let _e2165 = (((1f / _e1279.z) * (((_e2137 * _e2086.x) + (_e2144 * _e2086.y)) + (_e2151 * _e2086.z))) / (((_e2137 * _e1282) + (_e2144 * _e1285)) + _e2151));
                                                                            if (_e2165 > 0f) {
                                                                                if (_e2165 < _e121) {
                                                                                    let _e2169 = triangles.member[(0u + _e1881)].v0_;
                                                                                    let _e2171 = triangles.member[(0u + _e1881)].v1_;
                                                                                    if (_e2169.x < _e2171.x) {
                                                                                        phi_2310_ = _e2169.x;
                                                                                    } else {
                                                                                        phi_2310_ = _e2171.x;
                                                                                    }
                                                                                    let _e2178 = phi_2310_;
                                                                                    if (_e2169.y < _e2171.y) {
                                                                                        phi_2319_ = _e2169.y;
                                                                                    } else {
                                                                                        phi_2319_ = _e2171.y;
                                                                                    }
                                                                                    let _e2185 = phi_2319_;
                                                                                    if (_e2169.z < _e2171.z) {
                                                                                        phi_2328_ = _e2169.z;
                                                                                    } else {
                                                                                        phi_2328_ = _e2171.z;
                                                                                    }
                                                                                    let _e2192 = phi_2328_;
                                                                                    let _e2194 = triangles.member[(0u + _e1881)].v2_;
                                                                                    if (_e2178 < _e2194.x) {
                                                                                        phi_2337_ = _e2178;
                                                                                    } else {
                                                                                        phi_2337_ = _e2194.x;
                                                                                    }
                                                                                    let _e2199 = phi_2337_;
                                                                                    if (_e2185 < _e2194.y) {
                                                                                        phi_2344_ = _e2185;
                                                                                    } else {
                                                                                        phi_2344_ = _e2194.y;
                                                                                    }
                                                                                    let _e2204 = phi_2344_;
                                                                                    if (_e2192 < _e2194.z) {
                                                                                        phi_2351_ = _e2192;
                                                                                    } else {
                                                                                        phi_2351_ = _e2194.z;
                                                                                    }
                                                                                    let _e2209 = phi_2351_;
                                                                                    let _e2211 = triangles.member[(0u + _e1881)].v0_;
                                                                                    let _e2213 = triangles.member[(0u + _e1881)].v1_;
                                                                                    if (_e2211.x > _e2213.x) {
                                                                                        phi_2364_ = _e2211.x;
                                                                                    } else {
                                                                                        phi_2364_ = _e2213.x;
                                                                                    }
                                                                                    let _e2220 = phi_2364_;
                                                                                    if (_e2211.y > _e2213.y) {
                                                                                        phi_2373_ = _e2211.y;
                                                                                    } else {
                                                                                        phi_2373_ = _e2213.y;
                                                                                    }
                                                                                    let _e2227 = phi_2373_;
                                                                                    if (_e2211.z > _e2213.z) {
                                                                                        phi_2382_ = _e2211.z;
                                                                                    } else {
                                                                                        phi_2382_ = _e2213.z;
                                                                                    }
                                                                                    let _e2234 = phi_2382_;
                                                                                    let _e2236 = triangles.member[(0u + _e1881)].v2_;
                                                                                    if (_e2220 > _e2236.x) {
                                                                                        phi_2391_ = _e2220;
                                                                                    } else {
                                                                                        phi_2391_ = _e2236.x;
                                                                                    }
                                                                                    let _e2241 = phi_2391_;
                                                                                    if (_e2227 > _e2236.y) {
                                                                                        phi_2398_ = _e2227;
                                                                                    } else {
                                                                                        phi_2398_ = _e2236.y;
                                                                                    }
                                                                                    let _e2246 = phi_2398_;
                                                                                    if (_e2234 > _e2236.z) {
                                                                                        phi_2405_ = _e2234;
                                                                                    } else {
                                                                                        phi_2405_ = _e2236.z;
                                                                                    }
                                                                                    let _e2251 = phi_2405_;
                                                                                    let _e2255 = ((_e2199 - _e991) * _e1200);
                                                                                    let _e2256 = ((_e2204 - _e1004) * _e1210);
                                                                                    let _e2257 = ((_e2209 - _e1017) * _e1220);
                                                                                    let _e2261 = ((_e2241 - _e991) * _e1200);
                                                                                    let _e2262 = ((_e2246 - _e1004) * _e1210);
                                                                                    let _e2263 = ((_e2251 - _e1017) * _e1220);
                                                                                    if (_e2255 < _e2261) {
                                                                                        phi_2422_ = _e2255;
                                                                                    } else {
                                                                                        phi_2422_ = _e2261;
                                                                                    }
                                                                                    let _e2266 = phi_2422_;
                                                                                    if (_e2256 < _e2262) {
                                                                                        phi_2427_ = _e2256;
                                                                                    } else {
                                                                                        phi_2427_ = _e2262;
                                                                                    }
                                                                                    let _e2269 = phi_2427_;
                                                                                    if (_e2257 < _e2263) {
                                                                                        phi_2432_ = _e2257;
                                                                                    } else {
                                                                                        phi_2432_ = _e2263;
                                                                                    }
                                                                                    let _e2272 = phi_2432_;
                                                                                    if (_e2255 > _e2261) {
                                                                                        phi_2440_ = _e2255;
                                                                                    } else {
                                                                                        phi_2440_ = _e2261;
                                                                                    }
                                                                                    let _e2278 = phi_2440_;
                                                                                    if (_e2256 > _e2262) {
                                                                                        phi_2445_ = _e2256;
                                                                                    } else {
                                                                                        phi_2445_ = _e2262;
                                                                                    }
                                                                                    let _e2281 = phi_2445_;
                                                                                    if (_e2257 > _e2263) {
                                                                                        phi_2450_ = _e2257;
                                                                                    } else {
                                                                                        phi_2450_ = _e2263;
                                                                                    }
                                                                                    let _e2284 = phi_2450_;
                                                                                    let _e2288 = core_intrinsics_maximum_number_nsz_f32_((_e2266 - _e1255), (_e2269 - _e1256));
                                                                                    let _e2289 = core_intrinsics_maximum_number_nsz_f32_(_e2288, (_e2272 - _e1257));
                                                                                    let _e2290 = core_intrinsics_minimum_number_nsz_f32_((_e2278 + _e1255), (_e2281 + _e1256));
                                                                                    let _e2291 = core_intrinsics_minimum_number_nsz_f32_(_e2290, (_e2284 + _e1257));
                                                                                    if (_e2289 > _e972) {
                                                                                        phi_2462_ = _e2289;
                                                                                    } else {
                                                                                        phi_2462_ = _e972;
                                                                                    }
                                                                                    let _e2294 = phi_2462_;
                                                                                    if (_e2291 < _e974) {
                                                                                        phi_2467_ = _e2291;
                                                                                    } else {
                                                                                        phi_2467_ = _e974;
                                                                                    }
                                                                                    let _e2297 = phi_2467_;
                                                                                    if (_e2165 < _e2294) {
                                                                                        phi_2472_ = _e2294;
                                                                                    } else {
                                                                                        phi_2472_ = _e2165;
                                                                                    }
                                                                                    let _e2300 = phi_2472_;
                                                                                    if (_e2300 > _e2297) {
                                                                                        phi_2477_ = _e2297;
                                                                                    } else {
                                                                                        phi_2477_ = _e2300;
                                                                                    }
                                                                                    let _e2303 = phi_2477_;
                                                                                    phi_2482_ = lt_bvh_triangle_Intersection(_e2303, (_e2006 / _e2065), (_e2027 / _e2065), (_e2294 <= _e2297));
                                                                                    phi_2483_ = false;
                                                                                } else {
                                                                                    phi_2482_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2483_ = true;
                                                                                }
                                                                                let _e2309 = phi_2482_;
                                                                                let _e2311 = phi_2483_;
                                                                                phi_2484_ = _e2309;
                                                                                phi_2485_ = _e2311;
                                                                            } else {
                                                                                phi_2484_ = lt_bvh_triangle_Intersection();
                                                                                phi_2485_ = true;
                                                                            }
                                                                            let _e2313 = phi_2484_;
                                                                            let _e2315 = phi_2485_;
                                                                            if _e2315 {
                                                                            }
                                                                            phi_2489_ = _e2313;
                                                                            phi_2490_ = _e2315;
                                                                        }
                                                                        let _e2317 = phi_2489_;
                                                                        let _e2319 = phi_2490_;
                                                                        phi_2491_ = _e2317;
                                                                        phi_2492_ = _e2068;
                                                                        phi_2493_ = _e2319;
                                                                    } else {
                                                                        phi_2491_ = lt_bvh_triangle_Intersection();
                                                                        phi_2492_ = true;
                                                                        phi_2493_ = false;
                                                                    }
                                                                    let _e2321 = phi_2491_;
                                                                    let _e2323 = phi_2492_;
                                                                    let _e2325 = phi_2493_;
                                                                    if _e2323 {
                                                                        phi_2497_ = true;
                                                                    } else {
                                                                        phi_2497_ = _e2325;
                                                                    }
                                                                    let _e2327 = phi_2497_;
                                                                    if _e2327 {
                                                                        phi_2501_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2501_ = _e2321;
                                                                    }
                                                                    let _e2329 = phi_2501_;
                                                                    if _e2329.is_hit {
                                                                        if (_e2329.t > 0f) {
                                                                            if (_e2329.t < _e121) {
                                                                                let _e2336 = triangles.member[(0u + _e1881)].i0_;
                                                                                let _e2338 = ((_e2336 & 2147483648u) == 0u);
                                                                                if _e2338 {
                                                                                    phi_2527_ = false;
                                                                                    phi_2528_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2526_ = false;
                                                                                    } else {
                                                                                        phi_2526_ = true;
                                                                                    }
                                                                                    let _e2340 = phi_2526_;
                                                                                    phi_2527_ = _e2340;
                                                                                    phi_2528_ = true;
                                                                                }
                                                                                let _e2342 = phi_2527_;
                                                                                let _e2344 = phi_2528_;
                                                                                phi_2529_ = _e2342;
                                                                                phi_2530_ = _e2338;
                                                                                phi_2531_ = _e2344;
                                                                            } else {
                                                                                phi_2529_ = true;
                                                                                phi_2530_ = false;
                                                                                phi_2531_ = false;
                                                                            }
                                                                            let _e2346 = phi_2529_;
                                                                            let _e2348 = phi_2530_;
                                                                            let _e2350 = phi_2531_;
                                                                            phi_2532_ = _e2346;
                                                                            phi_2533_ = _e2348;
                                                                            phi_2534_ = _e2350;
                                                                        } else {
                                                                            phi_2532_ = true;
                                                                            phi_2533_ = false;
                                                                            phi_2534_ = false;
                                                                        }
                                                                        let _e2352 = phi_2532_;
                                                                        let _e2354 = phi_2533_;
                                                                        let _e2356 = phi_2534_;
                                                                        phi_2535_ = _e2352;
                                                                        phi_2536_ = _e2354;
                                                                        phi_2537_ = _e2356;
                                                                    } else {
                                                                        phi_2535_ = true;
                                                                        phi_2536_ = false;
                                                                        phi_2537_ = false;
                                                                    }
                                                                    let _e2358 = phi_2535_;
                                                                    let _e2360 = phi_2536_;
                                                                    let _e2362 = phi_2537_;
                                                                    if _e2358 {
                                                                        phi_2541_ = false;
                                                                        phi_2542_ = false;
                                                                    } else {
                                                                        phi_2541_ = _e2360;
                                                                        phi_2542_ = _e2362;
                                                                    }
                                                                    let _e2364 = phi_2541_;
                                                                    let _e2366 = phi_2542_;
                                                                    phi_1933_ = (_e1872 & (_e1872 - 1u));
                                                                    phi_2543_ = _e2358;
                                                                    phi_2544_ = _e2364;
                                                                    phi_2545_ = _e2366;
                                                                }
                                                                let _e2368 = phi_1933_;
                                                                let _e2370 = phi_2543_;
                                                                let _e2372 = phi_2544_;
                                                                let _e2374 = phi_2545_;
                                                                local_12 = _e2372;
                                                                local_13 = _e2374;
                                                                continue;
                                                                continuing {
                                                                    phi_1932_ = _e2368;
                                                                    break if !(_e2370);
                                                                }
                                                            }
                                                            let _e2377 = local_8;
                                                            if _e2377 {
                                                                let _e2379 = local.group_mask;
                                                                if ((_e2379 & 4278190080u) == 0u) {
                                                                    let _e2383 = local.len;
                                                                    if (_e2383 == 0u) {
                                                                        phi_2587_ = false;
                                                                    } else {
                                                                        let _e2387 = local.len;
                                                                        local.len = (_e2387 - 1u);
                                                                        let _e2390 = local.len;
                                                                        if (_e2390 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2395 = local.first[(0u + _e2390)];
                                                                        local.group = _e2395;
                                                                        let _e2398 = local.len;
                                                                        if (_e2398 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2403 = local.mask[(0u + _e2398)];
                                                                        local.group_mask = _e2403;
                                                                        phi_2587_ = true;
                                                                    }
                                                                    let _e2406 = phi_2587_;
                                                                    phi_2588_ = _e2406;
                                                                } else {
                                                                    phi_2588_ = true;
                                                                }
                                                                let _e2408 = phi_2588_;
                                                                if _e2408 {
                                                                    let _e2410 = local.group_mask;
                                                                    let _e2416 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2410)), 32u, (_e2410 == 0u)));
                                                                    let _e2420 = local.group_mask;
                                                                    let _e2434 = local.group_mask;
                                                                    local.group_mask = (_e2434 & ~((1u << bitcast<u32>((_e2416 & 31u)))));
                                                                    let _e2437 = local.group;
                                                                    phi_2619_ = (_e2437 + countOneBits(((_e2420 & ~((4294967295u << bitcast<u32>((((_e2416 - 24u) ^ _e1298) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2619_ = 4294967295u;
                                                                }
                                                                let _e2440 = phi_2619_;
                                                                phi_2620_ = _e2440;
                                                                phi_2621_ = false;
                                                                phi_2622_ = false;
                                                            } else {
                                                                phi_2620_ = u32();
                                                                let _e2849 = local_12;
                                                                phi_2621_ = _e2849;
                                                                let _e2852 = local_13;
                                                                phi_2622_ = _e2852;
                                                            }
                                                            let _e2442 = phi_2620_;
                                                            let _e2444 = phi_2621_;
                                                            let _e2446 = phi_2622_;
                                                            phi_1603_ = _e2442;
                                                            let _e2856 = local_14;
                                                            phi_2623_ = _e2856;
                                                            phi_2624_ = false;
                                                            phi_2625_ = _e2444;
                                                            phi_2626_ = _e2446;
                                                        } else {
                                                            phi_1603_ = u32();
                                                            phi_2623_ = false;
                                                            phi_2624_ = true;
                                                            phi_2625_ = false;
                                                            phi_2626_ = false;
                                                        }
                                                        let _e2448 = phi_1603_;
                                                        let _e2450 = phi_2623_;
                                                        let _e2452 = phi_2624_;
                                                        let _e2454 = phi_2625_;
                                                        let _e2456 = phi_2626_;
                                                        local_9 = _e2452;
                                                        local_15 = _e2454;
                                                        local_16 = _e2456;
                                                        continue;
                                                        continuing {
                                                            phi_1602_ = _e2448;
                                                            break if !(_e2450);
                                                        }
                                                    }
                                                    let _e2459 = local_9;
                                                    if _e2459 {
                                                        phi_2630_ = false;
                                                        phi_2631_ = false;
                                                    } else {
                                                        let _e2863 = local_15;
                                                        phi_2630_ = _e2863;
                                                        let _e2866 = local_16;
                                                        phi_2631_ = _e2866;
                                                    }
                                                    let _e2461 = phi_2630_;
                                                    let _e2463 = phi_2631_;
                                                    if _e2461 {
                                                        phi_2635_ = true;
                                                    } else {
                                                        phi_2635_ = _e2463;
                                                    }
                                                    let _e2465 = phi_2635_;
                                                    if _e2465 {
                                                        phi_2639_ = true;
                                                    } else {
                                                        phi_2639_ = false;
                                                    }
                                                    let _e2467 = phi_2639_;
                                                    phi_2640_ = _e2467;
                                                }
                                                let _e2469 = phi_2640_;
                                                phi_2641_ = _e2469;
                                                phi_2642_ = _e1124;
                                            } else {
                                                phi_2641_ = bool();
                                                phi_2642_ = true;
                                            }
                                            let _e2471 = phi_2641_;
                                            let _e2473 = phi_2642_;
                                            if _e2473 {
                                                phi_2646_ = false;
                                            } else {
                                                phi_2646_ = _e2471;
                                            }
                                            let _e2475 = phi_2646_;
                                            if _e2475 {
                                                phi_2650_ = false;
                                            } else {
                                                phi_2650_ = true;
                                            }
                                            let _e2477 = phi_2650_;
                                            phi_2651_ = _e2477;
                                        } else {
                                            phi_2651_ = true;
                                        }
                                        let _e2479 = phi_2651_;
                                        phi_2652_ = _e2479;
                                    } else {
                                        phi_2652_ = true;
                                    }
                                    let _e2481 = phi_2652_;
                                    phi_2653_ = _e2481;
                                } else {
                                    phi_2653_ = true;
                                }
                                let _e2483 = phi_2653_;
                                if _e2483 {
                                }
                                phi_997_ = (_e911 & (_e911 - 1u));
                                phi_2657_ = _e2483;
                            }
                            let _e2485 = phi_997_;
                            let _e2487 = phi_2657_;
                            continue;
                            continuing {
                                phi_996_ = _e2485;
                                break if !(_e2487);
                            }
                        }
                        let _e2490 = local_10;
                        if _e2490 {
                            let _e2492 = local_1.group_mask;
                            if ((_e2492 & 4278190080u) == 0u) {
                                let _e2496 = local_1.len;
                                if (_e2496 == 0u) {
                                    phi_2699_ = false;
                                } else {
                                    let _e2500 = local_1.len;
                                    local_1.len = (_e2500 - 1u);
                                    let _e2503 = local_1.len;
                                    if (_e2503 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2508 = local_1.first[(0u + _e2503)];
                                    local_1.group = _e2508;
                                    let _e2511 = local_1.len;
                                    if (_e2511 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2516 = local_1.mask[(0u + _e2511)];
                                    local_1.group_mask = _e2516;
                                    phi_2699_ = true;
                                }
                                let _e2519 = phi_2699_;
                                phi_2700_ = _e2519;
                            } else {
                                phi_2700_ = true;
                            }
                            let _e2521 = phi_2700_;
                            if _e2521 {
                                let _e2523 = local_1.group_mask;
                                let _e2529 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2523)), 32u, (_e2523 == 0u)));
                                let _e2533 = local_1.group_mask;
                                let _e2547 = local_1.group_mask;
                                local_1.group_mask = (_e2547 & ~((1u << bitcast<u32>((_e2529 & 31u)))));
                                let _e2550 = local_1.group;
                                phi_2731_ = (_e2550 + countOneBits(((_e2533 & ~((4294967295u << bitcast<u32>((((_e2529 - 24u) ^ _e337) & 31u))))) & 255u)));
                            } else {
                                phi_2731_ = 4294967295u;
                            }
                            let _e2553 = phi_2731_;
                            phi_2732_ = _e2553;
                        } else {
                            phi_2732_ = u32();
                        }
                        let _e2555 = phi_2732_;
                        phi_667_ = _e2555;
                        let _e2887 = local_17;
                        phi_2733_ = _e2887;
                        phi_2734_ = false;
                    } else {
                        phi_667_ = u32();
                        phi_2733_ = false;
                        phi_2734_ = true;
                    }
                    let _e2557 = phi_667_;
                    let _e2559 = phi_2733_;
                    let _e2561 = phi_2734_;
                    local_11 = _e2561;
                    continue;
                    continuing {
                        phi_666_ = _e2557;
                        break if !(_e2559);
                    }
                }
                let _e2564 = local_11;
                if _e2564 {
                    phi_2738_ = false;
                } else {
                    phi_2738_ = true;
                }
                let _e2566 = phi_2738_;
                if _e2566 {
                    phi_2742_ = true;
                } else {
                    phi_2742_ = false;
                }
                let _e2568 = phi_2742_;
                phi_2743_ = _e2568;
            }
            let _e2570 = phi_2743_;
            phi_2744_ = _e2570;
            phi_2745_ = _e193;
        } else {
            phi_2744_ = bool();
            phi_2745_ = true;
        }
        let _e2572 = phi_2744_;
        let _e2574 = phi_2745_;
        if _e2574 {
            phi_2749_ = false;
        } else {
            phi_2749_ = _e2572;
        }
        let _e2576 = phi_2749_;
        if _e2576 {
            phi_2753_ = 0f;
        } else {
            phi_2753_ = 1f;
        }
        let _e2578 = phi_2753_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e90)] = _e2578;
        if (_e90 < _e74) {
        } else {
            return;
        }
        let _e2585 = bits.member[(0u + _e90)];
        if ((_e2585 & 2u) == 0u) {
            phi_2774_ = (_e2585 & 1u);
        } else {
            phi_2774_ = (_e2585 & 7u);
        }
        let _e2591 = phi_2774_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        let _e2595 = visibility.member[(0u + _e90)];
        if ((_e2591 & 1u) != 0u) {
            phi_2789_ = (2u | 1u);
        } else {
            phi_2789_ = 2u;
        }
        let _e2601 = phi_2789_;
        if (_e2595 < 0.5f) {
            phi_2794_ = (_e2601 | 4u);
        } else {
            phi_2794_ = _e2601;
        }
        let _e2604 = phi_2794_;
        if (_e90 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e90)] = _e2604;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
