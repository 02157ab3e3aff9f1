struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<f32>,
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

struct type_34 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_38 {
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

struct type_42 {
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
var<storage> samples: type_20;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(6) 
var<storage> instances: type_50;
@group(0) @binding(5) 
var<storage> list: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_165_: bool;
    var phi_169_: f32;

    if (param != param) {
        phi_165_ = true;
    } else {
        let _e55 = (param_1 >= param);
        if _e55 {
        }
        phi_165_ = _e55;
    }
    let _e57 = phi_165_;
    if _e57 {
        phi_169_ = param_1;
    } else {
        phi_169_ = param;
    }
    let _e59 = phi_169_;
    return _e59;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_181_: bool;
    var phi_185_: f32;

    if (param_2 != param_2) {
        phi_181_ = true;
    } else {
        let _e55 = (param_3 <= param_2);
        if _e55 {
        }
        phi_181_ = _e55;
    }
    let _e57 = phi_181_;
    if _e57 {
        phi_185_ = param_3;
    } else {
        phi_185_ = param_2;
    }
    let _e59 = phi_185_;
    return _e59;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_269_: f32;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_308_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_328_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
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
    var phi_492_: f32;
    var phi_497_: f32;
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
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1213_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1233_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1260_: bool;
    var phi_1330_: f32;
    var phi_1337_: f32;
    var phi_1344_: f32;
    var phi_1351_: f32;
    var phi_1358_: f32;
    var phi_1365_: f32;
    var phi_1382_: f32;
    var phi_1387_: f32;
    var phi_1392_: f32;
    var phi_1397_: f32;
    var phi_1402_: f32;
    var phi_1428_: bool;
    var phi_1429_: bool;
    var phi_1437_: u32;
    var phi_1438_: u32;
    var phi_1449_: vec3<f32>;
    var phi_1450_: vec3<f32>;
    var phi_1463_: u32;
    var phi_1468_: u32;
    var phi_1473_: u32;
    var phi_1587_: bool;
    var phi_1588_: bool;
    var phi_1619_: u32;
    var phi_1621_: u32;
    var phi_1624_: bool;
    var phi_1704_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1731_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1758_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1764_: u32;
    var phi_1767_: u32;
    var phi_1781_: u32;
    var phi_1791_: u32;
    var phi_1801_: u32;
    var phi_1819_: u32;
    var phi_1829_: u32;
    var phi_1839_: u32;
    var phi_1875_: u32;
    var phi_1888_: u32;
    var phi_1893_: u32;
    var phi_1894_: u32;
    var phi_1895_: u32;
    var phi_1765_: u32;
    var phi_1768_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1953_: u32;
    var phi_1956_: bool;
    var phi_2000_: vec3<f32>;
    var phi_2001_: vec3<f32>;
    var phi_2030_: vec3<f32>;
    var phi_2031_: vec3<f32>;
    var phi_2060_: vec3<f32>;
    var phi_2061_: vec3<f32>;
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
    var phi_2224_: vec3<f32>;
    var phi_2225_: vec3<f32>;
    var phi_2250_: vec3<f32>;
    var phi_2251_: vec3<f32>;
    var phi_2276_: vec3<f32>;
    var phi_2277_: vec3<f32>;
    var phi_2333_: f32;
    var phi_2342_: f32;
    var phi_2351_: f32;
    var phi_2360_: f32;
    var phi_2367_: f32;
    var phi_2374_: f32;
    var phi_2387_: f32;
    var phi_2396_: f32;
    var phi_2405_: f32;
    var phi_2414_: f32;
    var phi_2421_: f32;
    var phi_2428_: f32;
    var phi_2445_: f32;
    var phi_2450_: f32;
    var phi_2455_: f32;
    var phi_2463_: f32;
    var phi_2468_: f32;
    var phi_2473_: f32;
    var phi_2485_: f32;
    var phi_2490_: f32;
    var phi_2495_: f32;
    var phi_2500_: f32;
    var phi_2505_: lt_bvh_triangle_Intersection;
    var phi_2506_: bool;
    var phi_2507_: lt_bvh_triangle_Intersection;
    var phi_2508_: bool;
    var phi_2512_: lt_bvh_triangle_Intersection;
    var phi_2513_: bool;
    var phi_2514_: lt_bvh_triangle_Intersection;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2520_: bool;
    var phi_2524_: lt_bvh_triangle_Intersection;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_1954_: u32;
    var phi_1957_: bool;
    var phi_2554_: bool;
    var local_8: bool;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2628_: u32;
    var phi_2629_: u32;
    var phi_1622_: u32;
    var phi_1625_: bool;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var local_9: bool;
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
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_1007_: u32;
    var phi_1010_: bool;
    var phi_2660_: bool;
    var local_10: bool;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2734_: u32;
    var phi_2735_: u32;
    var phi_675_: u32;
    var phi_678_: bool;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var local_11: bool;
    var phi_2741_: bool;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var phi_2747_: bool;
    var phi_2751_: bool;
    var phi_2752_: bool;
    var phi_2756_: bool;
    var phi_2760_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

    let _e54 = id_1;
    let _e61 = arrayLength((&nodes.member));
    let _e70 = arrayLength((&list.member));
    let _e77 = ((_e54.y * 2097152u) + _e54.x);
    if (3u < _e70) {
    } else {
        return;
    }
    let _e80 = list.member[3u];
    if (_e77 < _e80) {
        let _e82 = (_e77 + 4u);
        if (_e82 < _e70) {
        } else {
            return;
        }
        let _e86 = list.member[(0u + _e82)];
        let _e87 = (_e86 & 2147483647u);
        let _e89 = p.member.root;
        if (_e87 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e95 = samples.member[(0u + _e87)].position;
        let _e97 = samples.member[(0u + _e87)].normal;
        let _e99 = samples.member[(0u + _e87)].magnitude;
        let _e101 = ((8f / 8388608f) * _e99);
        let _e109 = (_e95.x + (_e97.x * _e101));
        let _e111 = (_e95.y + (_e97.y * _e101));
        let _e113 = (_e95.z + (_e97.z * _e101));
        let _e115 = p.member.light.place;
        if (_e115.w == 0f) {
            phi_269_ = 300000000000000000000000000000000000000f;
        } else {
            phi_269_ = 1f;
        }
        let _e119 = phi_269_;
        let _e127 = (_e115.x - (_e109 * _e115.w));
        let _e128 = (_e115.y - (_e111 * _e115.w));
        let _e129 = (_e115.z - (_e113 * _e115.w));
        let _e130 = abs(_e127);
        let _e131 = abs(_e128);
        let _e132 = abs(_e129);
        if (abs(_e109) < 1000000000000000f) {
            if (abs(_e111) < 1000000000000000f) {
                phi_301_ = (abs(_e113) < 1000000000000000f);
                phi_302_ = false;
            } else {
                phi_301_ = bool();
                phi_302_ = true;
            }
            let _e140 = phi_301_;
            let _e142 = phi_302_;
            phi_303_ = _e140;
            phi_304_ = _e142;
        } else {
            phi_303_ = bool();
            phi_304_ = true;
        }
        let _e144 = phi_303_;
        let _e146 = phi_304_;
        if _e146 {
            phi_308_ = false;
        } else {
            phi_308_ = _e144;
        }
        let _e148 = phi_308_;
        if _e148 {
            if (_e130 < 1000000000000000f) {
                if (_e131 < 1000000000000000f) {
                    phi_321_ = (_e132 < 1000000000000000f);
                    phi_322_ = false;
                } else {
                    phi_321_ = bool();
                    phi_322_ = true;
                }
                let _e153 = phi_321_;
                let _e155 = phi_322_;
                phi_323_ = _e153;
                phi_324_ = _e155;
            } else {
                phi_323_ = bool();
                phi_324_ = true;
            }
            let _e157 = phi_323_;
            let _e159 = phi_324_;
            if _e159 {
                phi_328_ = false;
            } else {
                phi_328_ = _e157;
            }
            let _e161 = phi_328_;
            if _e161 {
                if (_e130 > 0f) {
                    phi_342_ = bool();
                    phi_343_ = true;
                } else {
                    let _e163 = (_e131 > 0f);
                    if _e163 {
                        phi_341_ = bool();
                    } else {
                        phi_341_ = (_e132 > 0f);
                    }
                    let _e166 = phi_341_;
                    phi_342_ = _e166;
                    phi_343_ = _e163;
                }
                let _e168 = phi_342_;
                let _e170 = phi_343_;
                if _e170 {
                    phi_347_ = true;
                } else {
                    phi_347_ = _e168;
                }
                let _e172 = phi_347_;
                phi_348_ = _e172;
                phi_349_ = false;
            } else {
                phi_348_ = bool();
                phi_349_ = true;
            }
            let _e174 = phi_348_;
            let _e176 = phi_349_;
            phi_350_ = _e174;
            phi_351_ = _e176;
        } else {
            phi_350_ = bool();
            phi_351_ = true;
        }
        let _e178 = phi_350_;
        let _e180 = phi_351_;
        if _e180 {
            phi_355_ = false;
        } else {
            phi_355_ = _e178;
        }
        let _e182 = phi_355_;
        if _e182 {
            let _e183 = (_e89 >= _e61);
            if _e183 {
                phi_2745_ = false;
            } else {
                if (_e89 < _e61) {
                } else {
                    return;
                }
                let _e189 = nodes.member[(0u + _e89)].frame[0u];
                let _e193 = nodes.member[(0u + _e89)].frame[1u];
                let _e197 = nodes.member[(0u + _e89)].frame[2u];
                let _e201 = nodes.member[(0u + _e89)].frame[0u];
                let _e205 = nodes.member[(0u + _e89)].frame[1u];
                let _e209 = nodes.member[(0u + _e89)].frame[2u];
                let _e213 = nodes.member[(0u + _e89)].frame[3u];
                let _e247 = core_intrinsics_maximum_number_nsz_f32_(abs(_e127), abs(_e128));
                let _e248 = core_intrinsics_maximum_number_nsz_f32_(_e247, abs(_e129));
                let _e249 = (_e248 * 0.0000000000009094947f);
                if (abs(_e127) < _e249) {
                    phi_425_ = _e249;
                } else {
                    phi_425_ = abs(_e127);
                }
                let _e254 = phi_425_;
                if (_e127 < 0f) {
                    phi_432_ = (-1f / _e254);
                } else {
                    phi_432_ = (1f / _e254);
                }
                let _e259 = phi_432_;
                if (abs(_e128) < _e249) {
                    phi_439_ = _e249;
                } else {
                    phi_439_ = abs(_e128);
                }
                let _e264 = phi_439_;
                if (_e128 < 0f) {
                    phi_446_ = (-1f / _e264);
                } else {
                    phi_446_ = (1f / _e264);
                }
                let _e269 = phi_446_;
                if (abs(_e129) < _e249) {
                    phi_453_ = _e249;
                } else {
                    phi_453_ = abs(_e129);
                }
                let _e274 = phi_453_;
                if (_e129 < 0f) {
                    phi_460_ = (-1f / _e274);
                } else {
                    phi_460_ = (1f / _e274);
                }
                let _e279 = phi_460_;
                let _e283 = abs((bitcast<f32>(_e189) - _e109));
                let _e284 = abs((bitcast<f32>(_e193) - _e111));
                let _e285 = abs((bitcast<f32>(_e197) - _e113));
                let _e289 = abs(((bitcast<f32>(_e201) + (bitcast<f32>((((_e213 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e290 = abs(((bitcast<f32>(_e205) + (bitcast<f32>((((_e213 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                let _e291 = abs(((bitcast<f32>(_e209) + (bitcast<f32>((((_e213 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                if (_e283 > _e289) {
                    phi_477_ = _e283;
                } else {
                    phi_477_ = _e289;
                }
                let _e294 = phi_477_;
                if (_e284 > _e290) {
                    phi_482_ = _e284;
                } else {
                    phi_482_ = _e290;
                }
                let _e297 = phi_482_;
                if (_e285 > _e291) {
                    phi_487_ = _e285;
                } else {
                    phi_487_ = _e291;
                }
                let _e300 = phi_487_;
                if (_e294 > _e297) {
                    phi_492_ = _e294;
                } else {
                    phi_492_ = _e297;
                }
                let _e303 = phi_492_;
                if (_e303 > _e300) {
                    phi_497_ = _e303;
                } else {
                    phi_497_ = _e300;
                }
                let _e306 = phi_497_;
                let _e310 = (_e306 * 0.0000019073486f);
                let _e311 = (abs(_e259) * _e310);
                let _e312 = (abs(_e269) * _e310);
                let _e313 = (abs(_e279) * _e310);
                let _e317 = (_e306 * 0.0000009536743f);
                let _e318 = (abs(_e259) * _e317);
                let _e319 = (abs(_e269) * _e317);
                let _e320 = (abs(_e279) * _e317);
                if (_e259 < 0f) {
                    phi_516_ = 0u;
                } else {
                    phi_516_ = 1u;
                }
                let _e323 = phi_516_;
                if (_e269 < 0f) {
                    phi_521_ = 0u;
                } else {
                    phi_521_ = 2u;
                }
                let _e326 = phi_521_;
                if (_e279 < 0f) {
                    phi_526_ = 0u;
                } else {
                    phi_526_ = 4u;
                }
                let _e329 = phi_526_;
                let _e331 = ((_e323 | _e326) | _e329);
                let _e332 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e89, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e332.first[0], _e332.first[1], _e332.first[2], _e332.first[3], _e332.first[4], _e332.first[5], _e332.first[6], _e332.first[7], _e332.first[8], _e332.first[9], _e332.first[10], _e332.first[11], _e332.first[12], _e332.first[13], _e332.first[14], _e332.first[15], _e332.first[16], _e332.first[17], _e332.first[18], _e332.first[19], _e332.first[20], _e332.first[21], _e332.first[22], _e332.first[23], _e332.first[24], _e332.first[25], _e332.first[26], _e332.first[27], _e332.first[28], _e332.first[29], _e332.first[30], _e332.first[31]), array<u32, 32>(_e332.mask[0], _e332.mask[1], _e332.mask[2], _e332.mask[3], _e332.mask[4], _e332.mask[5], _e332.mask[6], _e332.mask[7], _e332.mask[8], _e332.mask[9], _e332.mask[10], _e332.mask[11], _e332.mask[12], _e332.mask[13], _e332.mask[14], _e332.mask[15], _e332.mask[16], _e332.mask[17], _e332.mask[18], _e332.mask[19], _e332.mask[20], _e332.mask[21], _e332.mask[22], _e332.mask[23], _e332.mask[24], _e332.mask[25], _e332.mask[26], _e332.mask[27], _e332.mask[28], _e332.mask[29], _e332.mask[30], _e332.mask[31]), _e332.len, _e332.group, _e332.group_mask);
                let _e406 = local_1.group_mask;
                if ((_e406 & 4278190080u) == 0u) {
                    let _e410 = local_1.len;
                    if (_e410 == 0u) {
                        phi_640_ = false;
                    } else {
                        let _e414 = local_1.len;
                        local_1.len = (_e414 - 1u);
                        let _e417 = local_1.len;
                        if (_e417 < 32u) {
                        } else {
                            return;
                        }
                        let _e422 = local_1.first[(0u + _e417)];
                        local_1.group = _e422;
                        let _e425 = local_1.len;
                        if (_e425 < 32u) {
                        } else {
                            return;
                        }
                        let _e430 = local_1.mask[(0u + _e425)];
                        local_1.group_mask = _e430;
                        phi_640_ = true;
                    }
                    let _e433 = phi_640_;
                    phi_641_ = _e433;
                } else {
                    phi_641_ = true;
                }
                let _e435 = phi_641_;
                if _e435 {
                    let _e437 = local_1.group_mask;
                    let _e443 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e437)), 32u, (_e437 == 0u)));
                    let _e447 = local_1.group_mask;
                    let _e461 = local_1.group_mask;
                    local_1.group_mask = (_e461 & ~((1u << bitcast<u32>((_e443 & 31u)))));
                    let _e464 = local_1.group;
                    phi_672_ = (_e464 + countOneBits(((_e447 & ~((4294967295u << bitcast<u32>((((_e443 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_672_ = 4294967295u;
                }
                let _e467 = phi_672_;
                phi_674_ = _e467;
                phi_677_ = false;
                loop {
                    let _e469 = phi_674_;
                    let _e471 = phi_677_;
                    if (_e469 != 4294967295u) {
                        if (_e469 < _e61) {
                        } else {
                            return;
                        }
                        let _e478 = nodes.member[(0u + _e469)].frame[3u];
                        let _e503 = (bitcast<f32>((((_e478 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e259);
                        let _e504 = (bitcast<f32>((((_e478 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e269);
                        let _e505 = (bitcast<f32>((((_e478 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e279);
                        let _e508 = nodes.member[(0u + _e469)].frame[0u];
                        let _e512 = nodes.member[(0u + _e469)].frame[1u];
                        let _e516 = nodes.member[(0u + _e469)].frame[2u];
                        let _e521 = ((bitcast<f32>(_e508) - _e109) * _e259);
                        let _e522 = ((bitcast<f32>(_e512) - _e111) * _e269);
                        let _e523 = ((bitcast<f32>(_e516) - _e113) * _e279);
                        let _e531 = nodes.member[(0u + _e469)].x;
                        if (_e259 < 0f) {
                            let _e542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e531.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e542.unnamed.root, _e531.w), _e542.unnamed_1);
                            let _e554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e548.unnamed, lt_bvh_traverse_Tree(_e531.x, _e548.unnamed_1.first_primitive));
                            phi_757_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e554.unnamed, lt_bvh_traverse_Tree(_e554.unnamed_1.root, _e531.y));
                        } else {
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e531.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e570.unnamed.root, _e531.y), _e570.unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e531.z, _e576.unnamed_1.first_primitive));
                            phi_757_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e582.unnamed_1.root, _e531.w));
                        }
                        let _e590 = phi_757_;
                        let _e600 = nodes.member[(0u + _e469)].y;
                        if (_e269 < 0f) {
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e600.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e611.unnamed.root, _e600.w), _e611.unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e617.unnamed, lt_bvh_traverse_Tree(_e600.x, _e617.unnamed_1.first_primitive));
                            phi_784_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_bvh_traverse_Tree(_e623.unnamed_1.root, _e600.y));
                        } else {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e600.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e600.y), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e600.z, _e645.unnamed_1.first_primitive));
                            phi_784_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e600.w));
                        }
                        let _e659 = phi_784_;
                        let _e669 = nodes.member[(0u + _e469)].z;
                        if (_e279 < 0f) {
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e680.unnamed.root, _e669.w), _e680.unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e669.x, _e686.unnamed_1.first_primitive));
                            phi_811_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e692.unnamed_1.root, _e669.y));
                        } else {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e669.y), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e669.z, _e714.unnamed_1.first_primitive));
                            phi_811_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e669.w));
                        }
                        let _e728 = phi_811_;
                        phi_817_ = 0u;
                        phi_820_ = 0u;
                        loop {
                            let _e738 = phi_817_;
                            let _e740 = phi_820_;
                            local_2 = _e740;
                            local_3 = _e740;
                            local_4 = _e740;
                            let _e741 = (_e738 < 8u);
                            if _e741 {
                                let _e743 = (_e738 >> bitcast<u32>(2i));
                                let _e744 = (_e738 & 3u);
                                if (_e743 == 0u) {
                                    phi_834_ = _e590.unnamed.root;
                                } else {
                                    phi_834_ = _e590.unnamed.first_primitive;
                                }
                                let _e747 = phi_834_;
                                if (_e743 == 0u) {
                                    phi_844_ = _e659.unnamed.root;
                                } else {
                                    phi_844_ = _e659.unnamed.first_primitive;
                                }
                                let _e756 = phi_844_;
                                if (_e743 == 0u) {
                                    phi_854_ = _e728.unnamed.root;
                                } else {
                                    phi_854_ = _e728.unnamed.first_primitive;
                                }
                                let _e765 = phi_854_;
                                let _e778 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e747 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e503) + (_e521 - _e311)), ((f32(((_e756 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e504) + (_e522 - _e312)));
                                let _e779 = core_intrinsics_maximum_number_nsz_f32_(_e778, ((f32(((_e765 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e505) + (_e523 - _e313)));
                                if (_e743 == 0u) {
                                    phi_872_ = _e590.unnamed_1.root;
                                } else {
                                    phi_872_ = _e590.unnamed_1.first_primitive;
                                }
                                let _e782 = phi_872_;
                                if (_e743 == 0u) {
                                    phi_882_ = _e659.unnamed_1.root;
                                } else {
                                    phi_882_ = _e659.unnamed_1.first_primitive;
                                }
                                let _e791 = phi_882_;
                                if (_e743 == 0u) {
                                    phi_892_ = _e728.unnamed_1.root;
                                } else {
                                    phi_892_ = _e728.unnamed_1.first_primitive;
                                }
                                let _e800 = phi_892_;
                                let _e813 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e782 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e503) + (_e521 + _e311)), ((f32(((_e791 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e504) + (_e522 + _e312)));
                                let _e814 = core_intrinsics_minimum_number_nsz_f32_(_e813, ((f32(((_e800 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e505) + (_e523 + _e313)));
                                if (_e779 <= _e814) {
                                    if (_e779 <= _e119) {
                                        if (_e814 >= 0f) {
                                            if (_e743 == 0u) {
                                                let _e821 = nodes.member[(0u + _e469)].links[2u];
                                                phi_928_ = _e821;
                                            } else {
                                                let _e824 = nodes.member[(0u + _e469)].links[3u];
                                                phi_928_ = _e824;
                                            }
                                            let _e826 = phi_928_;
                                            let _e831 = ((_e826 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u);
                                            let _e832 = (_e831 & 31u);
                                            if (_e832 >= 24u) {
                                                phi_941_ = (24u + ((_e832 - 24u) ^ _e331));
                                            } else {
                                                phi_941_ = _e832;
                                            }
                                            let _e838 = phi_941_;
                                            phi_946_ = (_e740 | ((_e831 >> bitcast<u32>(5i)) << bitcast<u32>((_e838 & 31u))));
                                        } else {
                                            phi_946_ = _e740;
                                        }
                                        let _e846 = phi_946_;
                                        phi_947_ = _e846;
                                    } else {
                                        phi_947_ = _e740;
                                    }
                                    let _e848 = phi_947_;
                                    phi_948_ = _e848;
                                } else {
                                    phi_948_ = _e740;
                                }
                                let _e850 = phi_948_;
                                phi_818_ = (_e738 + 1u);
                                phi_821_ = _e850;
                            } else {
                                phi_818_ = u32();
                                phi_821_ = u32();
                            }
                            let _e853 = phi_818_;
                            let _e855 = phi_821_;
                            continue;
                            continuing {
                                phi_817_ = _e853;
                                phi_820_ = _e855;
                                break if !(_e741);
                            }
                        }
                        let _e859 = nodes.member[(0u + _e469)].links[0u];
                        let _e863 = nodes.member[(0u + _e469)].frame[3u];
                        let _e867 = local_2;
                        if ((_e867 & 4278190080u) == 0u) {
                        } else {
                            let _e871 = local_1.group_mask;
                            if ((_e871 & 4278190080u) == 0u) {
                            } else {
                                let _e875 = local_1.len;
                                if (_e875 < 32u) {
                                    let _e878 = local_1.group;
                                    let _e880 = local_1.len;
                                    if (_e880 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e880)] = _e878;
                                    let _e886 = local_1.group_mask;
                                    let _e888 = local_1.len;
                                    if (_e888 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e888)] = _e886;
                                    let _e895 = local_1.len;
                                    local_1.len = (_e895 + 1u);
                                }
                            }
                            local_1.group = (_e89 + _e859);
                            let _e899 = local_3;
                            local_1.group_mask = ((_e899 & 4278190080u) | (_e863 >> bitcast<u32>(24i)));
                        }
                        let _e904 = local_4;
                        phi_1006_ = (_e904 & 16777215u);
                        phi_1009_ = _e471;
                        loop {
                            let _e907 = phi_1006_;
                            let _e909 = phi_1009_;
                            local_15 = _e909;
                            let _e910 = (_e907 == 0u);
                            local_10 = _e910;
                            local_16 = _e910;
                            if _e910 {
                                phi_1007_ = u32();
                                phi_1010_ = bool();
                                phi_2660_ = false;
                            } else {
                                let _e913 = nodes.member[(0u + _e469)].links[1u];
                                let _e917 = (_e913 + select(firstTrailingBit(_e907), 32u, (_e907 == 0u)));
                                if (_e917 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e924 = instances.member[(0u + _e917)].low_world;
                                let _e926 = instances.member[(0u + _e917)].high_world;
                                let _e933 = ((_e924.x - _e109) * _e259);
                                let _e934 = ((_e924.y - _e111) * _e269);
                                let _e935 = ((_e924.z - _e113) * _e279);
                                let _e942 = ((_e926.x - _e109) * _e259);
                                let _e943 = ((_e926.y - _e111) * _e269);
                                let _e944 = ((_e926.z - _e113) * _e279);
                                if (_e933 < _e942) {
                                    phi_1058_ = _e933;
                                } else {
                                    phi_1058_ = _e942;
                                }
                                let _e947 = phi_1058_;
                                if (_e934 < _e943) {
                                    phi_1063_ = _e934;
                                } else {
                                    phi_1063_ = _e943;
                                }
                                let _e950 = phi_1063_;
                                if (_e935 < _e944) {
                                    phi_1068_ = _e935;
                                } else {
                                    phi_1068_ = _e944;
                                }
                                let _e953 = phi_1068_;
                                if (_e933 > _e942) {
                                    phi_1076_ = _e933;
                                } else {
                                    phi_1076_ = _e942;
                                }
                                let _e959 = phi_1076_;
                                if (_e934 > _e943) {
                                    phi_1081_ = _e934;
                                } else {
                                    phi_1081_ = _e943;
                                }
                                let _e962 = phi_1081_;
                                if (_e935 > _e944) {
                                    phi_1086_ = _e935;
                                } else {
                                    phi_1086_ = _e944;
                                }
                                let _e965 = phi_1086_;
                                let _e969 = core_intrinsics_maximum_number_nsz_f32_((_e947 - _e318), (_e950 - _e319));
                                let _e970 = core_intrinsics_maximum_number_nsz_f32_(_e969, (_e953 - _e320));
                                let _e971 = core_intrinsics_minimum_number_nsz_f32_((_e959 + _e318), (_e962 + _e319));
                                let _e972 = core_intrinsics_minimum_number_nsz_f32_(_e971, (_e965 + _e320));
                                if (_e970 <= _e972) {
                                    if (_e970 <= _e119) {
                                        if (_e972 >= 0f) {
                                            let _e978 = instances.member[(0u + _e917)].world_to_object[0u];
                                            let _e989 = ((((_e978.x * _e109) + (_e978.y * _e111)) + (_e978.z * _e113)) + (_e978.w * 1f));
                                            let _e991 = instances.member[(0u + _e917)].world_to_object[1u];
                                            let _e1002 = ((((_e991.x * _e109) + (_e991.y * _e111)) + (_e991.z * _e113)) + (_e991.w * 1f));
                                            let _e1004 = instances.member[(0u + _e917)].world_to_object[2u];
                                            let _e1015 = ((((_e1004.x * _e109) + (_e1004.y * _e111)) + (_e1004.z * _e113)) + (_e1004.w * 1f));
                                            let _e1018 = instances.member[(0u + _e917)].world_to_object[0u];
                                            let _e1029 = ((((_e1018.x * _e127) + (_e1018.y * _e128)) + (_e1018.z * _e129)) + (_e1018.w * 0f));
                                            let _e1031 = instances.member[(0u + _e917)].world_to_object[1u];
                                            let _e1042 = ((((_e1031.x * _e127) + (_e1031.y * _e128)) + (_e1031.z * _e129)) + (_e1031.w * 0f));
                                            let _e1044 = instances.member[(0u + _e917)].world_to_object[2u];
                                            let _e1055 = ((((_e1044.x * _e127) + (_e1044.y * _e128)) + (_e1044.z * _e129)) + (_e1044.w * 0f));
                                            let _e1058 = instances.member[(0u + _e917)].root;
                                            let _e1060 = instances.member[(0u + _e917)].first_triangle;
                                            let _e1061 = abs(_e1029);
                                            let _e1062 = abs(_e1042);
                                            let _e1063 = abs(_e1055);
                                            if (abs(_e989) < 1000000000000000f) {
                                                if (abs(_e1002) < 1000000000000000f) {
                                                    phi_1206_ = (abs(_e1015) < 1000000000000000f);
                                                    phi_1207_ = false;
                                                } else {
                                                    phi_1206_ = bool();
                                                    phi_1207_ = true;
                                                }
                                                let _e1071 = phi_1206_;
                                                let _e1073 = phi_1207_;
                                                phi_1208_ = _e1071;
                                                phi_1209_ = _e1073;
                                            } else {
                                                phi_1208_ = bool();
                                                phi_1209_ = true;
                                            }
                                            let _e1075 = phi_1208_;
                                            let _e1077 = phi_1209_;
                                            if _e1077 {
                                                phi_1213_ = false;
                                            } else {
                                                phi_1213_ = _e1075;
                                            }
                                            let _e1079 = phi_1213_;
                                            if _e1079 {
                                                if (_e1061 < 1000000000000000f) {
                                                    if (_e1062 < 1000000000000000f) {
                                                        phi_1226_ = (_e1063 < 1000000000000000f);
                                                        phi_1227_ = false;
                                                    } else {
                                                        phi_1226_ = bool();
                                                        phi_1227_ = true;
                                                    }
                                                    let _e1084 = phi_1226_;
                                                    let _e1086 = phi_1227_;
                                                    phi_1228_ = _e1084;
                                                    phi_1229_ = _e1086;
                                                } else {
                                                    phi_1228_ = bool();
                                                    phi_1229_ = true;
                                                }
                                                let _e1088 = phi_1228_;
                                                let _e1090 = phi_1229_;
                                                if _e1090 {
                                                    phi_1233_ = false;
                                                } else {
                                                    phi_1233_ = _e1088;
                                                }
                                                let _e1092 = phi_1233_;
                                                if _e1092 {
                                                    if (_e1061 > 0f) {
                                                        phi_1247_ = bool();
                                                        phi_1248_ = true;
                                                    } else {
                                                        let _e1094 = (_e1062 > 0f);
                                                        if _e1094 {
                                                            phi_1246_ = bool();
                                                        } else {
                                                            phi_1246_ = (_e1063 > 0f);
                                                        }
                                                        let _e1097 = phi_1246_;
                                                        phi_1247_ = _e1097;
                                                        phi_1248_ = _e1094;
                                                    }
                                                    let _e1099 = phi_1247_;
                                                    let _e1101 = phi_1248_;
                                                    if _e1101 {
                                                        phi_1252_ = true;
                                                    } else {
                                                        phi_1252_ = _e1099;
                                                    }
                                                    let _e1103 = phi_1252_;
                                                    phi_1253_ = _e1103;
                                                    phi_1254_ = false;
                                                } else {
                                                    phi_1253_ = bool();
                                                    phi_1254_ = true;
                                                }
                                                let _e1105 = phi_1253_;
                                                let _e1107 = phi_1254_;
                                                phi_1255_ = _e1105;
                                                phi_1256_ = _e1107;
                                            } else {
                                                phi_1255_ = bool();
                                                phi_1256_ = true;
                                            }
                                            let _e1109 = phi_1255_;
                                            let _e1111 = phi_1256_;
                                            if _e1111 {
                                                phi_1260_ = false;
                                            } else {
                                                phi_1260_ = _e1109;
                                            }
                                            let _e1113 = phi_1260_;
                                            if _e1113 {
                                                let _e1114 = (_e1058 >= _e61);
                                                if _e1114 {
                                                    phi_2640_ = bool();
                                                } else {
                                                    if (_e1058 < _e61) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1120 = nodes.member[(0u + _e1058)].frame[0u];
                                                    let _e1124 = nodes.member[(0u + _e1058)].frame[1u];
                                                    let _e1128 = nodes.member[(0u + _e1058)].frame[2u];
                                                    let _e1132 = nodes.member[(0u + _e1058)].frame[0u];
                                                    let _e1136 = nodes.member[(0u + _e1058)].frame[1u];
                                                    let _e1140 = nodes.member[(0u + _e1058)].frame[2u];
                                                    let _e1144 = nodes.member[(0u + _e1058)].frame[3u];
                                                    let _e1178 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1029), abs(_e1042));
                                                    let _e1179 = core_intrinsics_maximum_number_nsz_f32_(_e1178, abs(_e1055));
                                                    let _e1180 = (_e1179 * 0.0000000000009094947f);
                                                    if (abs(_e1029) < _e1180) {
                                                        phi_1330_ = _e1180;
                                                    } else {
                                                        phi_1330_ = abs(_e1029);
                                                    }
                                                    let _e1185 = phi_1330_;
                                                    if (_e1029 < 0f) {
                                                        phi_1337_ = (-1f / _e1185);
                                                    } else {
                                                        phi_1337_ = (1f / _e1185);
                                                    }
                                                    let _e1190 = phi_1337_;
                                                    if (abs(_e1042) < _e1180) {
                                                        phi_1344_ = _e1180;
                                                    } else {
                                                        phi_1344_ = abs(_e1042);
                                                    }
                                                    let _e1195 = phi_1344_;
                                                    if (_e1042 < 0f) {
                                                        phi_1351_ = (-1f / _e1195);
                                                    } else {
                                                        phi_1351_ = (1f / _e1195);
                                                    }
                                                    let _e1200 = phi_1351_;
                                                    if (abs(_e1055) < _e1180) {
                                                        phi_1358_ = _e1180;
                                                    } else {
                                                        phi_1358_ = abs(_e1055);
                                                    }
                                                    let _e1205 = phi_1358_;
                                                    if (_e1055 < 0f) {
                                                        phi_1365_ = (-1f / _e1205);
                                                    } else {
                                                        phi_1365_ = (1f / _e1205);
                                                    }
                                                    let _e1210 = phi_1365_;
                                                    let _e1214 = abs((bitcast<f32>(_e1120) - _e989));
                                                    let _e1215 = abs((bitcast<f32>(_e1124) - _e1002));
                                                    let _e1216 = abs((bitcast<f32>(_e1128) - _e1015));
                                                    let _e1220 = abs(((bitcast<f32>(_e1132) + (bitcast<f32>((((_e1144 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e989));
                                                    let _e1221 = abs(((bitcast<f32>(_e1136) + (bitcast<f32>((((_e1144 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1002));
                                                    let _e1222 = abs(((bitcast<f32>(_e1140) + (bitcast<f32>((((_e1144 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1015));
                                                    if (_e1214 > _e1220) {
                                                        phi_1382_ = _e1214;
                                                    } else {
                                                        phi_1382_ = _e1220;
                                                    }
                                                    let _e1225 = phi_1382_;
                                                    if (_e1215 > _e1221) {
                                                        phi_1387_ = _e1215;
                                                    } else {
                                                        phi_1387_ = _e1221;
                                                    }
                                                    let _e1228 = phi_1387_;
                                                    if (_e1216 > _e1222) {
                                                        phi_1392_ = _e1216;
                                                    } else {
                                                        phi_1392_ = _e1222;
                                                    }
                                                    let _e1231 = phi_1392_;
                                                    if (_e1225 > _e1228) {
                                                        phi_1397_ = _e1225;
                                                    } else {
                                                        phi_1397_ = _e1228;
                                                    }
                                                    let _e1234 = phi_1397_;
                                                    if (_e1234 > _e1231) {
                                                        phi_1402_ = _e1234;
                                                    } else {
                                                        phi_1402_ = _e1231;
                                                    }
                                                    let _e1237 = phi_1402_;
                                                    let _e1241 = (_e1237 * 0.0000019073486f);
                                                    let _e1242 = (abs(_e1190) * _e1241);
                                                    let _e1243 = (abs(_e1200) * _e1241);
                                                    let _e1244 = (abs(_e1210) * _e1241);
                                                    let _e1248 = (_e1237 * 0.0000009536743f);
                                                    let _e1249 = (abs(_e1190) * _e1248);
                                                    let _e1250 = (abs(_e1200) * _e1248);
                                                    let _e1251 = (abs(_e1210) * _e1248);
                                                    let _e1252 = abs(_e1029);
                                                    let _e1253 = abs(_e1042);
                                                    let _e1254 = abs(_e1055);
                                                    if (_e1252 >= _e1253) {
                                                        if (_e1252 >= _e1254) {
                                                            phi_1428_ = false;
                                                        } else {
                                                            phi_1428_ = true;
                                                        }
                                                        let _e1258 = phi_1428_;
                                                        phi_1429_ = _e1258;
                                                    } else {
                                                        phi_1429_ = true;
                                                    }
                                                    let _e1260 = phi_1429_;
                                                    if _e1260 {
                                                        if (_e1253 >= _e1254) {
                                                            phi_1437_ = 1u;
                                                        } else {
                                                            phi_1437_ = 2u;
                                                        }
                                                        let _e1263 = phi_1437_;
                                                        phi_1438_ = _e1263;
                                                    } else {
                                                        phi_1438_ = 0u;
                                                    }
                                                    let _e1265 = phi_1438_;
                                                    if (_e1265 == 0u) {
                                                        phi_1450_ = vec3<f32>(_e1042, _e1055, _e1029);
                                                    } else {
                                                        if (_e1265 == 1u) {
                                                            phi_1449_ = vec3<f32>(_e1055, _e1029, _e1042);
                                                        } else {
                                                            phi_1449_ = vec3<f32>(_e1029, _e1042, _e1055);
                                                        }
                                                        let _e1271 = phi_1449_;
                                                        phi_1450_ = _e1271;
                                                    }
                                                    let _e1273 = phi_1450_;
                                                    let _e1276 = (_e1273.x / _e1273.z);
                                                    let _e1279 = (_e1273.y / _e1273.z);
                                                    if (_e1190 < 0f) {
                                                        phi_1463_ = 0u;
                                                    } else {
                                                        phi_1463_ = 1u;
                                                    }
                                                    let _e1284 = phi_1463_;
                                                    if (_e1200 < 0f) {
                                                        phi_1468_ = 0u;
                                                    } else {
                                                        phi_1468_ = 2u;
                                                    }
                                                    let _e1287 = phi_1468_;
                                                    if (_e1210 < 0f) {
                                                        phi_1473_ = 0u;
                                                    } else {
                                                        phi_1473_ = 4u;
                                                    }
                                                    let _e1290 = phi_1473_;
                                                    let _e1292 = ((_e1284 | _e1287) | _e1290);
                                                    let _e1293 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1058, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1293.first[0], _e1293.first[1], _e1293.first[2], _e1293.first[3], _e1293.first[4], _e1293.first[5], _e1293.first[6], _e1293.first[7], _e1293.first[8], _e1293.first[9], _e1293.first[10], _e1293.first[11], _e1293.first[12], _e1293.first[13], _e1293.first[14], _e1293.first[15], _e1293.first[16], _e1293.first[17], _e1293.first[18], _e1293.first[19], _e1293.first[20], _e1293.first[21], _e1293.first[22], _e1293.first[23], _e1293.first[24], _e1293.first[25], _e1293.first[26], _e1293.first[27], _e1293.first[28], _e1293.first[29], _e1293.first[30], _e1293.first[31]), array<u32, 32>(_e1293.mask[0], _e1293.mask[1], _e1293.mask[2], _e1293.mask[3], _e1293.mask[4], _e1293.mask[5], _e1293.mask[6], _e1293.mask[7], _e1293.mask[8], _e1293.mask[9], _e1293.mask[10], _e1293.mask[11], _e1293.mask[12], _e1293.mask[13], _e1293.mask[14], _e1293.mask[15], _e1293.mask[16], _e1293.mask[17], _e1293.mask[18], _e1293.mask[19], _e1293.mask[20], _e1293.mask[21], _e1293.mask[22], _e1293.mask[23], _e1293.mask[24], _e1293.mask[25], _e1293.mask[26], _e1293.mask[27], _e1293.mask[28], _e1293.mask[29], _e1293.mask[30], _e1293.mask[31]), _e1293.len, _e1293.group, _e1293.group_mask);
                                                    let _e1367 = local.group_mask;
                                                    if ((_e1367 & 4278190080u) == 0u) {
                                                        let _e1371 = local.len;
                                                        if (_e1371 == 0u) {
                                                            phi_1587_ = false;
                                                        } else {
                                                            let _e1375 = local.len;
                                                            local.len = (_e1375 - 1u);
                                                            let _e1378 = local.len;
                                                            if (_e1378 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1383 = local.first[(0u + _e1378)];
                                                            local.group = _e1383;
                                                            let _e1386 = local.len;
                                                            if (_e1386 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1391 = local.mask[(0u + _e1386)];
                                                            local.group_mask = _e1391;
                                                            phi_1587_ = true;
                                                        }
                                                        let _e1394 = phi_1587_;
                                                        phi_1588_ = _e1394;
                                                    } else {
                                                        phi_1588_ = true;
                                                    }
                                                    let _e1396 = phi_1588_;
                                                    if _e1396 {
                                                        let _e1398 = local.group_mask;
                                                        let _e1404 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1398)), 32u, (_e1398 == 0u)));
                                                        let _e1408 = local.group_mask;
                                                        let _e1422 = local.group_mask;
                                                        local.group_mask = (_e1422 & ~((1u << bitcast<u32>((_e1404 & 31u)))));
                                                        let _e1425 = local.group;
                                                        phi_1619_ = (_e1425 + countOneBits(((_e1408 & ~((4294967295u << bitcast<u32>((((_e1404 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1619_ = 4294967295u;
                                                    }
                                                    let _e1428 = phi_1619_;
                                                    phi_1621_ = _e1428;
                                                    phi_1624_ = _e909;
                                                    loop {
                                                        let _e1430 = phi_1621_;
                                                        let _e1432 = phi_1624_;
                                                        local_14 = _e1432;
                                                        if (_e1430 != 4294967295u) {
                                                            if (_e1430 < _e61) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1439 = nodes.member[(0u + _e1430)].frame[3u];
                                                            let _e1464 = (bitcast<f32>((((_e1439 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1190);
                                                            let _e1465 = (bitcast<f32>((((_e1439 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1200);
                                                            let _e1466 = (bitcast<f32>((((_e1439 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1210);
                                                            let _e1469 = nodes.member[(0u + _e1430)].frame[0u];
                                                            let _e1473 = nodes.member[(0u + _e1430)].frame[1u];
                                                            let _e1477 = nodes.member[(0u + _e1430)].frame[2u];
                                                            let _e1482 = ((bitcast<f32>(_e1469) - _e989) * _e1190);
                                                            let _e1483 = ((bitcast<f32>(_e1473) - _e1002) * _e1200);
                                                            let _e1484 = ((bitcast<f32>(_e1477) - _e1015) * _e1210);
                                                            let _e1492 = nodes.member[(0u + _e1430)].x;
                                                            if (_e1190 < 0f) {
                                                                let _e1503 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1492.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1509 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1503.unnamed.root, _e1492.w), _e1503.unnamed_1);
                                                                let _e1515 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1509.unnamed, lt_bvh_traverse_Tree(_e1492.x, _e1509.unnamed_1.first_primitive));
                                                                phi_1704_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1515.unnamed, lt_bvh_traverse_Tree(_e1515.unnamed_1.root, _e1492.y));
                                                            } else {
                                                                let _e1531 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1492.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1531.unnamed.root, _e1492.y), _e1531.unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1537.unnamed, lt_bvh_traverse_Tree(_e1492.z, _e1537.unnamed_1.first_primitive));
                                                                phi_1704_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1543.unnamed_1.root, _e1492.w));
                                                            }
                                                            let _e1551 = phi_1704_;
                                                            let _e1561 = nodes.member[(0u + _e1430)].y;
                                                            if (_e1200 < 0f) {
                                                                let _e1572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1561.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1572.unnamed.root, _e1561.w), _e1572.unnamed_1);
                                                                let _e1584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1578.unnamed, lt_bvh_traverse_Tree(_e1561.x, _e1578.unnamed_1.first_primitive));
                                                                phi_1731_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1584.unnamed, lt_bvh_traverse_Tree(_e1584.unnamed_1.root, _e1561.y));
                                                            } else {
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1561.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1600.unnamed.root, _e1561.y), _e1600.unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_bvh_traverse_Tree(_e1561.z, _e1606.unnamed_1.first_primitive));
                                                                phi_1731_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1612.unnamed_1.root, _e1561.w));
                                                            }
                                                            let _e1620 = phi_1731_;
                                                            let _e1630 = nodes.member[(0u + _e1430)].z;
                                                            if (_e1210 < 0f) {
                                                                let _e1641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1641.unnamed.root, _e1630.w), _e1641.unnamed_1);
                                                                let _e1653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1647.unnamed, lt_bvh_traverse_Tree(_e1630.x, _e1647.unnamed_1.first_primitive));
                                                                phi_1758_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1653.unnamed, lt_bvh_traverse_Tree(_e1653.unnamed_1.root, _e1630.y));
                                                            } else {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1669.unnamed.root, _e1630.y), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1630.z, _e1675.unnamed_1.first_primitive));
                                                                phi_1758_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1681.unnamed_1.root, _e1630.w));
                                                            }
                                                            let _e1689 = phi_1758_;
                                                            phi_1764_ = 0u;
                                                            phi_1767_ = 0u;
                                                            loop {
                                                                let _e1699 = phi_1764_;
                                                                let _e1701 = phi_1767_;
                                                                local_5 = _e1701;
                                                                local_6 = _e1701;
                                                                local_7 = _e1701;
                                                                let _e1702 = (_e1699 < 8u);
                                                                if _e1702 {
                                                                    let _e1704 = (_e1699 >> bitcast<u32>(2i));
                                                                    let _e1705 = (_e1699 & 3u);
                                                                    if (_e1704 == 0u) {
                                                                        phi_1781_ = _e1551.unnamed.root;
                                                                    } else {
                                                                        phi_1781_ = _e1551.unnamed.first_primitive;
                                                                    }
                                                                    let _e1708 = phi_1781_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1791_ = _e1620.unnamed.root;
                                                                    } else {
                                                                        phi_1791_ = _e1620.unnamed.first_primitive;
                                                                    }
                                                                    let _e1717 = phi_1791_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1801_ = _e1689.unnamed.root;
                                                                    } else {
                                                                        phi_1801_ = _e1689.unnamed.first_primitive;
                                                                    }
                                                                    let _e1726 = phi_1801_;
                                                                    let _e1739 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1708 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 - _e1242)), ((f32(((_e1717 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1465) + (_e1483 - _e1243)));
                                                                    let _e1740 = core_intrinsics_maximum_number_nsz_f32_(_e1739, ((f32(((_e1726 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1466) + (_e1484 - _e1244)));
                                                                    if (_e1704 == 0u) {
                                                                        phi_1819_ = _e1551.unnamed_1.root;
                                                                    } else {
                                                                        phi_1819_ = _e1551.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1743 = phi_1819_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1829_ = _e1620.unnamed_1.root;
                                                                    } else {
                                                                        phi_1829_ = _e1620.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1752 = phi_1829_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1839_ = _e1689.unnamed_1.root;
                                                                    } else {
                                                                        phi_1839_ = _e1689.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1761 = phi_1839_;
                                                                    let _e1774 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1743 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 + _e1242)), ((f32(((_e1752 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1465) + (_e1483 + _e1243)));
                                                                    let _e1775 = core_intrinsics_minimum_number_nsz_f32_(_e1774, ((f32(((_e1761 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1466) + (_e1484 + _e1244)));
                                                                    if (_e1740 <= _e1775) {
                                                                        if (_e1740 <= _e119) {
                                                                            if (_e1775 >= 0f) {
                                                                                if (_e1704 == 0u) {
                                                                                    let _e1782 = nodes.member[(0u + _e1430)].links[2u];
                                                                                    phi_1875_ = _e1782;
                                                                                } else {
                                                                                    let _e1785 = nodes.member[(0u + _e1430)].links[3u];
                                                                                    phi_1875_ = _e1785;
                                                                                }
                                                                                let _e1787 = phi_1875_;
                                                                                let _e1792 = ((_e1787 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u);
                                                                                let _e1793 = (_e1792 & 31u);
                                                                                if (_e1793 >= 24u) {
                                                                                    phi_1888_ = (24u + ((_e1793 - 24u) ^ _e1292));
                                                                                } else {
                                                                                    phi_1888_ = _e1793;
                                                                                }
                                                                                let _e1799 = phi_1888_;
                                                                                phi_1893_ = (_e1701 | ((_e1792 >> bitcast<u32>(5i)) << bitcast<u32>((_e1799 & 31u))));
                                                                            } else {
                                                                                phi_1893_ = _e1701;
                                                                            }
                                                                            let _e1807 = phi_1893_;
                                                                            phi_1894_ = _e1807;
                                                                        } else {
                                                                            phi_1894_ = _e1701;
                                                                        }
                                                                        let _e1809 = phi_1894_;
                                                                        phi_1895_ = _e1809;
                                                                    } else {
                                                                        phi_1895_ = _e1701;
                                                                    }
                                                                    let _e1811 = phi_1895_;
                                                                    phi_1765_ = (_e1699 + 1u);
                                                                    phi_1768_ = _e1811;
                                                                } else {
                                                                    phi_1765_ = u32();
                                                                    phi_1768_ = u32();
                                                                }
                                                                let _e1814 = phi_1765_;
                                                                let _e1816 = phi_1768_;
                                                                continue;
                                                                continuing {
                                                                    phi_1764_ = _e1814;
                                                                    phi_1767_ = _e1816;
                                                                    break if !(_e1702);
                                                                }
                                                            }
                                                            let _e1820 = nodes.member[(0u + _e1430)].links[0u];
                                                            let _e1824 = nodes.member[(0u + _e1430)].frame[3u];
                                                            let _e1828 = local_5;
                                                            if ((_e1828 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1832 = local.group_mask;
                                                                if ((_e1832 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1836 = local.len;
                                                                    if (_e1836 < 32u) {
                                                                        let _e1839 = local.group;
                                                                        let _e1841 = local.len;
                                                                        if (_e1841 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1841)] = _e1839;
                                                                        let _e1847 = local.group_mask;
                                                                        let _e1849 = local.len;
                                                                        if (_e1849 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1849)] = _e1847;
                                                                        let _e1856 = local.len;
                                                                        local.len = (_e1856 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1058 + _e1820);
                                                                let _e1860 = local_6;
                                                                local.group_mask = ((_e1860 & 4278190080u) | (_e1824 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1865 = local_7;
                                                            phi_1953_ = (_e1865 & 16777215u);
                                                            phi_1956_ = _e1432;
                                                            loop {
                                                                let _e1868 = phi_1953_;
                                                                let _e1870 = phi_1956_;
                                                                local_12 = _e1870;
                                                                let _e1871 = (_e1868 == 0u);
                                                                local_8 = _e1871;
                                                                local_13 = _e1871;
                                                                if _e1871 {
                                                                    phi_1954_ = u32();
                                                                    phi_1957_ = bool();
                                                                    phi_2554_ = false;
                                                                } else {
                                                                    let _e1874 = nodes.member[(0u + _e1430)].links[1u];
                                                                    let _e1879 = ((_e1060 + _e1874) + select(firstTrailingBit(_e1868), 32u, (_e1868 == 0u)));
                                                                    if (_e1879 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1886 = triangles.member[(0u + _e1879)].v0_;
                                                                    let _e1888 = (_e1886.x - _e989);
                                                                    let _e1890 = (_e1886.y - _e1002);
                                                                    let _e1892 = (_e1886.z - _e1015);
                                                                    if (_e1265 == 0u) {
                                                                        phi_2001_ = vec3<f32>(_e1890, _e1892, _e1888);
                                                                    } else {
                                                                        if (_e1265 == 1u) {
                                                                            phi_2000_ = vec3<f32>(_e1892, _e1888, _e1890);
                                                                        } else {
                                                                            phi_2000_ = (_e1886 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1900 = phi_2000_;
                                                                        phi_2001_ = _e1900;
                                                                    }
                                                                    let _e1902 = phi_2001_;
                                                                    let _e1906 = (_e1902.x - (_e1276 * _e1902.z));
                                                                    let _e1910 = (_e1902.y - (_e1279 * _e1902.z));
                                                                    let _e1912 = triangles.member[(0u + _e1879)].v1_;
                                                                    let _e1914 = (_e1912.x - _e989);
                                                                    let _e1916 = (_e1912.y - _e1002);
                                                                    let _e1918 = (_e1912.z - _e1015);
                                                                    if (_e1265 == 0u) {
                                                                        phi_2031_ = vec3<f32>(_e1916, _e1918, _e1914);
                                                                    } else {
                                                                        if (_e1265 == 1u) {
                                                                            phi_2030_ = vec3<f32>(_e1918, _e1914, _e1916);
                                                                        } else {
                                                                            phi_2030_ = (_e1912 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1926 = phi_2030_;
                                                                        phi_2031_ = _e1926;
                                                                    }
                                                                    let _e1928 = phi_2031_;
                                                                    let _e1932 = (_e1928.x - (_e1276 * _e1928.z));
                                                                    let _e1936 = (_e1928.y - (_e1279 * _e1928.z));
                                                                    let _e1938 = triangles.member[(0u + _e1879)].v2_;
                                                                    let _e1940 = (_e1938.x - _e989);
                                                                    let _e1942 = (_e1938.y - _e1002);
                                                                    let _e1944 = (_e1938.z - _e1015);
                                                                    if (_e1265 == 0u) {
                                                                        phi_2061_ = vec3<f32>(_e1942, _e1944, _e1940);
                                                                    } else {
                                                                        if (_e1265 == 1u) {
                                                                            phi_2060_ = vec3<f32>(_e1944, _e1940, _e1942);
                                                                        } else {
                                                                            phi_2060_ = (_e1938 - vec3<f32>(_e989, _e1002, _e1015));
                                                                        }
                                                                        let _e1952 = phi_2060_;
                                                                        phi_2061_ = _e1952;
                                                                    }
                                                                    let _e1954 = phi_2061_;
                                                                    let _e1958 = (_e1954.x - (_e1276 * _e1954.z));
                                                                    let _e1962 = (_e1954.y - (_e1279 * _e1954.z));
                                                                    if (_e1932 < _e1958) {
                                                                        phi_2080_ = true;
                                                                    } else {
                                                                        if (_e1932 == _e1958) {
                                                                            phi_2079_ = (_e1936 < _e1962);
                                                                        } else {
                                                                            phi_2079_ = false;
                                                                        }
                                                                        let _e1967 = phi_2079_;
                                                                        phi_2080_ = _e1967;
                                                                    }
                                                                    let _e1969 = phi_2080_;
                                                                    if _e1969 {
                                                                        phi_2084_ = _e1962;
                                                                        phi_2085_ = _e1958;
                                                                        phi_2086_ = _e1936;
                                                                        phi_2087_ = _e1932;
                                                                    } else {
                                                                        phi_2084_ = _e1936;
                                                                        phi_2085_ = _e1932;
                                                                        phi_2086_ = _e1962;
                                                                        phi_2087_ = _e1958;
                                                                    }
                                                                    let _e1971 = phi_2084_;
                                                                    let _e1973 = phi_2085_;
                                                                    let _e1975 = phi_2086_;
                                                                    let _e1977 = phi_2087_;
                                                                    let _e1980 = ((_e1977 * _e1971) - (_e1975 * _e1973));
                                                                    if _e1969 {
                                                                        phi_2095_ = -(_e1980);
                                                                    } else {
                                                                        phi_2095_ = _e1980;
                                                                    }
                                                                    let _e1983 = phi_2095_;
                                                                    if (_e1958 < _e1906) {
                                                                        phi_2106_ = true;
                                                                    } else {
                                                                        if (_e1958 == _e1906) {
                                                                            phi_2105_ = (_e1962 < _e1910);
                                                                        } else {
                                                                            phi_2105_ = false;
                                                                        }
                                                                        let _e1988 = phi_2105_;
                                                                        phi_2106_ = _e1988;
                                                                    }
                                                                    let _e1990 = phi_2106_;
                                                                    if _e1990 {
                                                                        phi_2110_ = _e1910;
                                                                        phi_2111_ = _e1906;
                                                                        phi_2112_ = _e1962;
                                                                        phi_2113_ = _e1958;
                                                                    } else {
                                                                        phi_2110_ = _e1962;
                                                                        phi_2111_ = _e1958;
                                                                        phi_2112_ = _e1910;
                                                                        phi_2113_ = _e1906;
                                                                    }
                                                                    let _e1992 = phi_2110_;
                                                                    let _e1994 = phi_2111_;
                                                                    let _e1996 = phi_2112_;
                                                                    let _e1998 = phi_2113_;
                                                                    let _e2001 = ((_e1998 * _e1992) - (_e1996 * _e1994));
                                                                    if _e1990 {
                                                                        phi_2121_ = -(_e2001);
                                                                    } else {
                                                                        phi_2121_ = _e2001;
                                                                    }
                                                                    let _e2004 = phi_2121_;
                                                                    if (_e1906 < _e1932) {
                                                                        phi_2132_ = true;
                                                                    } else {
                                                                        if (_e1906 == _e1932) {
                                                                            phi_2131_ = (_e1910 < _e1936);
                                                                        } else {
                                                                            phi_2131_ = false;
                                                                        }
                                                                        let _e2009 = phi_2131_;
                                                                        phi_2132_ = _e2009;
                                                                    }
                                                                    let _e2011 = phi_2132_;
                                                                    if _e2011 {
                                                                        phi_2136_ = _e1936;
                                                                        phi_2137_ = _e1932;
                                                                        phi_2138_ = _e1910;
                                                                        phi_2139_ = _e1906;
                                                                    } else {
                                                                        phi_2136_ = _e1910;
                                                                        phi_2137_ = _e1906;
                                                                        phi_2138_ = _e1936;
                                                                        phi_2139_ = _e1932;
                                                                    }
                                                                    let _e2013 = phi_2136_;
                                                                    let _e2015 = phi_2137_;
                                                                    let _e2017 = phi_2138_;
                                                                    let _e2019 = phi_2139_;
                                                                    let _e2022 = ((_e2019 * _e2013) - (_e2017 * _e2015));
                                                                    if _e2011 {
                                                                        phi_2147_ = -(_e2022);
                                                                    } else {
                                                                        phi_2147_ = _e2022;
                                                                    }
                                                                    let _e2025 = phi_2147_;
                                                                    if (_e1983 >= 0f) {
                                                                        if (_e2004 >= 0f) {
                                                                            if (_e2025 >= 0f) {
                                                                                phi_2162_ = ((_e1983 + _e2004) + _e2025);
                                                                                phi_2163_ = false;
                                                                            } else {
                                                                                phi_2162_ = f32();
                                                                                phi_2163_ = true;
                                                                            }
                                                                            let _e2032 = phi_2162_;
                                                                            let _e2034 = phi_2163_;
                                                                            phi_2164_ = _e2032;
                                                                            phi_2165_ = _e2034;
                                                                        } else {
                                                                            phi_2164_ = f32();
                                                                            phi_2165_ = true;
                                                                        }
                                                                        let _e2036 = phi_2164_;
                                                                        let _e2038 = phi_2165_;
                                                                        phi_2166_ = _e2036;
                                                                        phi_2167_ = _e2038;
                                                                    } else {
                                                                        phi_2166_ = f32();
                                                                        phi_2167_ = true;
                                                                    }
                                                                    let _e2040 = phi_2166_;
                                                                    let _e2042 = phi_2167_;
                                                                    if _e2042 {
                                                                        if (_e1983 <= 0f) {
                                                                            if (_e2004 <= 0f) {
                                                                                let _e2045 = (_e2025 <= 0f);
                                                                                if _e2045 {
                                                                                }
                                                                                phi_2185_ = ((_e1983 + _e2004) + _e2025);
                                                                                phi_2186_ = false;
                                                                                phi_2187_ = _e2045;
                                                                            } else {
                                                                                phi_2185_ = f32();
                                                                                phi_2186_ = true;
                                                                                phi_2187_ = false;
                                                                            }
                                                                            let _e2049 = phi_2185_;
                                                                            let _e2051 = phi_2186_;
                                                                            let _e2053 = phi_2187_;
                                                                            phi_2188_ = _e2049;
                                                                            phi_2189_ = _e2051;
                                                                            phi_2190_ = _e2053;
                                                                        } else {
                                                                            phi_2188_ = f32();
                                                                            phi_2189_ = true;
                                                                            phi_2190_ = false;
                                                                        }
                                                                        let _e2055 = phi_2188_;
                                                                        let _e2057 = phi_2189_;
                                                                        let _e2059 = phi_2190_;
                                                                        if _e2057 {
                                                                            phi_2194_ = false;
                                                                        } else {
                                                                            phi_2194_ = _e2059;
                                                                        }
                                                                        let _e2061 = phi_2194_;
                                                                        phi_2195_ = _e2055;
                                                                        phi_2196_ = _e2061;
                                                                    } else {
                                                                        phi_2195_ = _e2040;
                                                                        phi_2196_ = true;
                                                                    }
                                                                    let _e2063 = phi_2195_;
                                                                    let _e2065 = phi_2196_;
                                                                    if _e2065 {
                                                                        let _e2066 = (_e2063 == 0f);
                                                                        if _e2066 {
                                                                            phi_2512_ = lt_bvh_triangle_Intersection();
                                                                            phi_2513_ = false;
                                                                        } else {
                                                                            let _e2068 = triangles.member[(0u + _e1879)].v0_;
                                                                            let _e2070 = (_e2068.x - _e989);
                                                                            let _e2072 = (_e2068.y - _e1002);
                                                                            let _e2074 = (_e2068.z - _e1015);
                                                                            if (_e1265 == 0u) {
                                                                                phi_2225_ = vec3<f32>(_e2072, _e2074, _e2070);
                                                                            } else {
                                                                                if (_e1265 == 1u) {
                                                                                    phi_2224_ = vec3<f32>(_e2074, _e2070, _e2072);
                                                                                } else {
                                                                                    phi_2224_ = (_e2068 - vec3<f32>(_e989, _e1002, _e1015));
                                                                                }
                                                                                let _e2082 = phi_2224_;
                                                                                phi_2225_ = _e2082;
                                                                            }
                                                                            let _e2084 = phi_2225_;
                                                                            let _e2086 = triangles.member[(0u + _e1879)].v1_;
                                                                            let _e2088 = triangles.member[(0u + _e1879)].v0_;
                                                                            let _e2091 = (_e2086.x - _e2088.x);
                                                                            let _e2094 = (_e2086.y - _e2088.y);
                                                                            let _e2097 = (_e2086.z - _e2088.z);
                                                                            if (_e1265 == 0u) {
                                                                                phi_2251_ = vec3<f32>(_e2094, _e2097, _e2091);
                                                                            } else {
                                                                                if (_e1265 == 1u) {
                                                                                    phi_2250_ = vec3<f32>(_e2097, _e2091, _e2094);
                                                                                } else {
                                                                                    phi_2250_ = (_e2086 - _e2088);
                                                                                }
                                                                                let _e2104 = phi_2250_;
                                                                                phi_2251_ = _e2104;
                                                                            }
                                                                            let _e2106 = phi_2251_;
                                                                            let _e2108 = triangles.member[(0u + _e1879)].v2_;
                                                                            let _e2110 = triangles.member[(0u + _e1879)].v0_;
                                                                            let _e2113 = (_e2108.x - _e2110.x);
                                                                            let _e2116 = (_e2108.y - _e2110.y);
                                                                            let _e2119 = (_e2108.z - _e2110.z);
                                                                            if (_e1265 == 0u) {
                                                                                phi_2277_ = vec3<f32>(_e2116, _e2119, _e2113);
                                                                            } else {
                                                                                if (_e1265 == 1u) {
                                                                                    phi_2276_ = vec3<f32>(_e2119, _e2113, _e2116);
                                                                                } else {
                                                                                    phi_2276_ = (_e2108 - _e2110);
                                                                                }
                                                                                let _e2126 = phi_2276_;
                                                                                phi_2277_ = _e2126;
                                                                            }
                                                                            let _e2128 = phi_2277_;
                                                                            let _e2135 = ((_e2106.y * _e2128.z) - (_e2106.z * _e2128.y));
                                                                            let _e2142 = ((_e2106.z * _e2128.x) - (_e2106.x * _e2128.z));
                                                                            let _e2149 = ((_e2106.x * _e2128.y) - (_e2106.y * _e2128.x));
                                                                            let _e2163 = (((1f / _e1273.z) * (((_e2135 * _e2084.x) + (_e2142 * _e2084.y)) + (_e2149 * _e2084.z))) / (((_e2135 * _e1276) + (_e2142 * _e1279)) + _e2149));
                                                                            if (_e2163 > 0f) {
                                                                                if (_e2163 < _e119) {
                                                                                    let _e2167 = triangles.member[(0u + _e1879)].v0_;
                                                                                    let _e2169 = triangles.member[(0u + _e1879)].v1_;
                                                                                    if (_e2167.x < _e2169.x) {
                                                                                        phi_2333_ = _e2167.x;
                                                                                    } else {
                                                                                        phi_2333_ = _e2169.x;
                                                                                    }
                                                                                    let _e2176 = phi_2333_;
                                                                                    if (_e2167.y < _e2169.y) {
                                                                                        phi_2342_ = _e2167.y;
                                                                                    } else {
                                                                                        phi_2342_ = _e2169.y;
                                                                                    }
                                                                                    let _e2183 = phi_2342_;
                                                                                    if (_e2167.z < _e2169.z) {
                                                                                        phi_2351_ = _e2167.z;
                                                                                    } else {
                                                                                        phi_2351_ = _e2169.z;
                                                                                    }
                                                                                    let _e2190 = phi_2351_;
                                                                                    let _e2192 = triangles.member[(0u + _e1879)].v2_;
                                                                                    if (_e2176 < _e2192.x) {
                                                                                        phi_2360_ = _e2176;
                                                                                    } else {
                                                                                        phi_2360_ = _e2192.x;
                                                                                    }
                                                                                    let _e2197 = phi_2360_;
                                                                                    if (_e2183 < _e2192.y) {
                                                                                        phi_2367_ = _e2183;
                                                                                    } else {
                                                                                        phi_2367_ = _e2192.y;
                                                                                    }
                                                                                    let _e2202 = phi_2367_;
                                                                                    if (_e2190 < _e2192.z) {
                                                                                        phi_2374_ = _e2190;
                                                                                    } else {
                                                                                        phi_2374_ = _e2192.z;
                                                                                    }
                                                                                    let _e2207 = phi_2374_;
                                                                                    let _e2209 = triangles.member[(0u + _e1879)].v0_;
                                                                                    let _e2211 = triangles.member[(0u + _e1879)].v1_;
                                                                                    if (_e2209.x > _e2211.x) {
                                                                                        phi_2387_ = _e2209.x;
                                                                                    } else {
                                                                                        phi_2387_ = _e2211.x;
                                                                                    }
                                                                                    let _e2218 = phi_2387_;
                                                                                    if (_e2209.y > _e2211.y) {
                                                                                        phi_2396_ = _e2209.y;
                                                                                    } else {
                                                                                        phi_2396_ = _e2211.y;
                                                                                    }
                                                                                    let _e2225 = phi_2396_;
                                                                                    if (_e2209.z > _e2211.z) {
                                                                                        phi_2405_ = _e2209.z;
                                                                                    } else {
                                                                                        phi_2405_ = _e2211.z;
                                                                                    }
                                                                                    let _e2232 = phi_2405_;
                                                                                    let _e2234 = triangles.member[(0u + _e1879)].v2_;
                                                                                    if (_e2218 > _e2234.x) {
                                                                                        phi_2414_ = _e2218;
                                                                                    } else {
                                                                                        phi_2414_ = _e2234.x;
                                                                                    }
                                                                                    let _e2239 = phi_2414_;
                                                                                    if (_e2225 > _e2234.y) {
                                                                                        phi_2421_ = _e2225;
                                                                                    } else {
                                                                                        phi_2421_ = _e2234.y;
                                                                                    }
                                                                                    let _e2244 = phi_2421_;
                                                                                    if (_e2232 > _e2234.z) {
                                                                                        phi_2428_ = _e2232;
                                                                                    } else {
                                                                                        phi_2428_ = _e2234.z;
                                                                                    }
                                                                                    let _e2249 = phi_2428_;
                                                                                    let _e2253 = ((_e2197 - _e989) * _e1190);
                                                                                    let _e2254 = ((_e2202 - _e1002) * _e1200);
                                                                                    let _e2255 = ((_e2207 - _e1015) * _e1210);
                                                                                    let _e2259 = ((_e2239 - _e989) * _e1190);
                                                                                    let _e2260 = ((_e2244 - _e1002) * _e1200);
                                                                                    let _e2261 = ((_e2249 - _e1015) * _e1210);
                                                                                    if (_e2253 < _e2259) {
                                                                                        phi_2445_ = _e2253;
                                                                                    } else {
                                                                                        phi_2445_ = _e2259;
                                                                                    }
                                                                                    let _e2264 = phi_2445_;
                                                                                    if (_e2254 < _e2260) {
                                                                                        phi_2450_ = _e2254;
                                                                                    } else {
                                                                                        phi_2450_ = _e2260;
                                                                                    }
                                                                                    let _e2267 = phi_2450_;
                                                                                    if (_e2255 < _e2261) {
                                                                                        phi_2455_ = _e2255;
                                                                                    } else {
                                                                                        phi_2455_ = _e2261;
                                                                                    }
                                                                                    let _e2270 = phi_2455_;
                                                                                    if (_e2253 > _e2259) {
                                                                                        phi_2463_ = _e2253;
                                                                                    } else {
                                                                                        phi_2463_ = _e2259;
                                                                                    }
                                                                                    let _e2276 = phi_2463_;
                                                                                    if (_e2254 > _e2260) {
                                                                                        phi_2468_ = _e2254;
                                                                                    } else {
                                                                                        phi_2468_ = _e2260;
                                                                                    }
                                                                                    let _e2279 = phi_2468_;
                                                                                    if (_e2255 > _e2261) {
                                                                                        phi_2473_ = _e2255;
                                                                                    } else {
                                                                                        phi_2473_ = _e2261;
                                                                                    }
                                                                                    let _e2282 = phi_2473_;
                                                                                    let _e2286 = core_intrinsics_maximum_number_nsz_f32_((_e2264 - _e1249), (_e2267 - _e1250));
                                                                                    let _e2287 = core_intrinsics_maximum_number_nsz_f32_(_e2286, (_e2270 - _e1251));
                                                                                    let _e2288 = core_intrinsics_minimum_number_nsz_f32_((_e2276 + _e1249), (_e2279 + _e1250));
                                                                                    let _e2289 = core_intrinsics_minimum_number_nsz_f32_(_e2288, (_e2282 + _e1251));
                                                                                    if (_e2287 > _e970) {
                                                                                        phi_2485_ = _e2287;
                                                                                    } else {
                                                                                        phi_2485_ = _e970;
                                                                                    }
                                                                                    let _e2292 = phi_2485_;
                                                                                    if (_e2289 < _e972) {
                                                                                        phi_2490_ = _e2289;
                                                                                    } else {
                                                                                        phi_2490_ = _e972;
                                                                                    }
                                                                                    let _e2295 = phi_2490_;
                                                                                    if (_e2163 < _e2292) {
                                                                                        phi_2495_ = _e2292;
                                                                                    } else {
                                                                                        phi_2495_ = _e2163;
                                                                                    }
                                                                                    let _e2298 = phi_2495_;
                                                                                    if (_e2298 > _e2295) {
                                                                                        phi_2500_ = _e2295;
                                                                                    } else {
                                                                                        phi_2500_ = _e2298;
                                                                                    }
                                                                                    let _e2301 = phi_2500_;
                                                                                    phi_2505_ = lt_bvh_triangle_Intersection(_e2301, (_e2004 / _e2063), (_e2025 / _e2063), (_e2292 <= _e2295));
                                                                                    phi_2506_ = false;
                                                                                } else {
                                                                                    phi_2505_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2506_ = true;
                                                                                }
                                                                                let _e2307 = phi_2505_;
                                                                                let _e2309 = phi_2506_;
                                                                                phi_2507_ = _e2307;
                                                                                phi_2508_ = _e2309;
                                                                            } else {
                                                                                phi_2507_ = lt_bvh_triangle_Intersection();
                                                                                phi_2508_ = true;
                                                                            }
                                                                            let _e2311 = phi_2507_;
                                                                            let _e2313 = phi_2508_;
                                                                            if _e2313 {
                                                                            }
                                                                            phi_2512_ = _e2311;
                                                                            phi_2513_ = _e2313;
                                                                        }
                                                                        let _e2315 = phi_2512_;
                                                                        let _e2317 = phi_2513_;
                                                                        phi_2514_ = _e2315;
                                                                        phi_2515_ = _e2066;
                                                                        phi_2516_ = _e2317;
                                                                    } else {
                                                                        phi_2514_ = lt_bvh_triangle_Intersection();
                                                                        phi_2515_ = true;
                                                                        phi_2516_ = false;
                                                                    }
                                                                    let _e2319 = phi_2514_;
                                                                    let _e2321 = phi_2515_;
                                                                    let _e2323 = phi_2516_;
                                                                    if _e2321 {
                                                                        phi_2520_ = true;
                                                                    } else {
                                                                        phi_2520_ = _e2323;
                                                                    }
                                                                    let _e2325 = phi_2520_;
                                                                    if _e2325 {
                                                                        phi_2524_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2524_ = _e2319;
                                                                    }
                                                                    let _e2327 = phi_2524_;
                                                                    if _e2327.is_hit {
                                                                        if (_e2327.t > 0f) {
                                                                            if (_e2327.t < _e119) {
                                                                                if true {
                                                                                    phi_2544_ = false;
                                                                                } else {
                                                                                    phi_2544_ = true;
                                                                                }
                                                                                let _e2336 = phi_2544_;
                                                                                phi_2545_ = true;
                                                                                phi_2546_ = _e2336;
                                                                            } else {
                                                                                phi_2545_ = _e1870;
                                                                                phi_2546_ = true;
                                                                            }
                                                                            let _e2338 = phi_2545_;
                                                                            let _e2340 = phi_2546_;
                                                                            phi_2547_ = _e2338;
                                                                            phi_2548_ = _e2340;
                                                                        } else {
                                                                            phi_2547_ = _e1870;
                                                                            phi_2548_ = true;
                                                                        }
                                                                        let _e2342 = phi_2547_;
                                                                        let _e2344 = phi_2548_;
                                                                        phi_2549_ = _e2342;
                                                                        phi_2550_ = _e2344;
                                                                    } else {
                                                                        phi_2549_ = _e1870;
                                                                        phi_2550_ = true;
                                                                    }
                                                                    let _e2346 = phi_2549_;
                                                                    let _e2348 = phi_2550_;
                                                                    if _e2348 {
                                                                    }
                                                                    phi_1954_ = (_e1868 & (_e1868 - 1u));
                                                                    phi_1957_ = _e2346;
                                                                    phi_2554_ = _e2348;
                                                                }
                                                                let _e2350 = phi_1954_;
                                                                let _e2352 = phi_1957_;
                                                                let _e2354 = phi_2554_;
                                                                continue;
                                                                continuing {
                                                                    phi_1953_ = _e2350;
                                                                    phi_1956_ = _e2352;
                                                                    break if !(_e2354);
                                                                }
                                                            }
                                                            let _e2357 = local_8;
                                                            if _e2357 {
                                                                let _e2359 = local.group_mask;
                                                                if ((_e2359 & 4278190080u) == 0u) {
                                                                    let _e2363 = local.len;
                                                                    if (_e2363 == 0u) {
                                                                        phi_2596_ = false;
                                                                    } else {
                                                                        let _e2367 = local.len;
                                                                        local.len = (_e2367 - 1u);
                                                                        let _e2370 = local.len;
                                                                        if (_e2370 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2375 = local.first[(0u + _e2370)];
                                                                        local.group = _e2375;
                                                                        let _e2378 = local.len;
                                                                        if (_e2378 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2383 = local.mask[(0u + _e2378)];
                                                                        local.group_mask = _e2383;
                                                                        phi_2596_ = true;
                                                                    }
                                                                    let _e2386 = phi_2596_;
                                                                    phi_2597_ = _e2386;
                                                                } else {
                                                                    phi_2597_ = true;
                                                                }
                                                                let _e2388 = phi_2597_;
                                                                if _e2388 {
                                                                    let _e2390 = local.group_mask;
                                                                    let _e2396 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2390)), 32u, (_e2390 == 0u)));
                                                                    let _e2400 = local.group_mask;
                                                                    let _e2414 = local.group_mask;
                                                                    local.group_mask = (_e2414 & ~((1u << bitcast<u32>((_e2396 & 31u)))));
                                                                    let _e2417 = local.group;
                                                                    phi_2628_ = (_e2417 + countOneBits(((_e2400 & ~((4294967295u << bitcast<u32>((((_e2396 - 24u) ^ _e1292) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2628_ = 4294967295u;
                                                                }
                                                                let _e2420 = phi_2628_;
                                                                phi_2629_ = _e2420;
                                                            } else {
                                                                phi_2629_ = u32();
                                                            }
                                                            let _e2422 = phi_2629_;
                                                            phi_1622_ = _e2422;
                                                            let _e2798 = local_12;
                                                            phi_1625_ = _e2798;
                                                            let _e2801 = local_13;
                                                            phi_2630_ = _e2801;
                                                            phi_2631_ = false;
                                                        } else {
                                                            phi_1622_ = u32();
                                                            phi_1625_ = bool();
                                                            phi_2630_ = false;
                                                            phi_2631_ = true;
                                                        }
                                                        let _e2424 = phi_1622_;
                                                        let _e2426 = phi_1625_;
                                                        let _e2428 = phi_2630_;
                                                        let _e2430 = phi_2631_;
                                                        local_9 = _e2430;
                                                        continue;
                                                        continuing {
                                                            phi_1621_ = _e2424;
                                                            phi_1624_ = _e2426;
                                                            break if !(_e2428);
                                                        }
                                                    }
                                                    let _e2433 = local_9;
                                                    if _e2433 {
                                                        phi_2635_ = false;
                                                    } else {
                                                        phi_2635_ = true;
                                                    }
                                                    let _e2435 = phi_2635_;
                                                    if _e2435 {
                                                        phi_2639_ = true;
                                                    } else {
                                                        let _e2807 = local_14;
                                                        phi_2639_ = _e2807;
                                                    }
                                                    let _e2437 = phi_2639_;
                                                    phi_2640_ = _e2437;
                                                }
                                                let _e2439 = phi_2640_;
                                                phi_2641_ = _e2439;
                                                phi_2642_ = _e1114;
                                            } else {
                                                phi_2641_ = bool();
                                                phi_2642_ = true;
                                            }
                                            let _e2441 = phi_2641_;
                                            let _e2443 = phi_2642_;
                                            if _e2443 {
                                                phi_2646_ = _e909;
                                            } else {
                                                phi_2646_ = _e2441;
                                            }
                                            let _e2445 = phi_2646_;
                                            if _e2445 {
                                                phi_2650_ = false;
                                            } else {
                                                phi_2650_ = true;
                                            }
                                            let _e2447 = phi_2650_;
                                            phi_2651_ = _e2445;
                                            phi_2652_ = _e2447;
                                        } else {
                                            phi_2651_ = _e909;
                                            phi_2652_ = true;
                                        }
                                        let _e2449 = phi_2651_;
                                        let _e2451 = phi_2652_;
                                        phi_2653_ = _e2449;
                                        phi_2654_ = _e2451;
                                    } else {
                                        phi_2653_ = _e909;
                                        phi_2654_ = true;
                                    }
                                    let _e2453 = phi_2653_;
                                    let _e2455 = phi_2654_;
                                    phi_2655_ = _e2453;
                                    phi_2656_ = _e2455;
                                } else {
                                    phi_2655_ = _e909;
                                    phi_2656_ = true;
                                }
                                let _e2457 = phi_2655_;
                                let _e2459 = phi_2656_;
                                if _e2459 {
                                }
                                phi_1007_ = (_e907 & (_e907 - 1u));
                                phi_1010_ = _e2457;
                                phi_2660_ = _e2459;
                            }
                            let _e2461 = phi_1007_;
                            let _e2463 = phi_1010_;
                            let _e2465 = phi_2660_;
                            continue;
                            continuing {
                                phi_1006_ = _e2461;
                                phi_1009_ = _e2463;
                                break if !(_e2465);
                            }
                        }
                        let _e2468 = local_10;
                        if _e2468 {
                            let _e2470 = local_1.group_mask;
                            if ((_e2470 & 4278190080u) == 0u) {
                                let _e2474 = local_1.len;
                                if (_e2474 == 0u) {
                                    phi_2702_ = false;
                                } else {
                                    let _e2478 = local_1.len;
                                    local_1.len = (_e2478 - 1u);
                                    let _e2481 = local_1.len;
                                    if (_e2481 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2486 = local_1.first[(0u + _e2481)];
                                    local_1.group = _e2486;
                                    let _e2489 = local_1.len;
                                    if (_e2489 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2494 = local_1.mask[(0u + _e2489)];
                                    local_1.group_mask = _e2494;
                                    phi_2702_ = true;
                                }
                                let _e2497 = phi_2702_;
                                phi_2703_ = _e2497;
                            } else {
                                phi_2703_ = true;
                            }
                            let _e2499 = phi_2703_;
                            if _e2499 {
                                let _e2501 = local_1.group_mask;
                                let _e2507 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2501)), 32u, (_e2501 == 0u)));
                                let _e2511 = local_1.group_mask;
                                let _e2525 = local_1.group_mask;
                                local_1.group_mask = (_e2525 & ~((1u << bitcast<u32>((_e2507 & 31u)))));
                                let _e2528 = local_1.group;
                                phi_2734_ = (_e2528 + countOneBits(((_e2511 & ~((4294967295u << bitcast<u32>((((_e2507 - 24u) ^ _e331) & 31u))))) & 255u)));
                            } else {
                                phi_2734_ = 4294967295u;
                            }
                            let _e2531 = phi_2734_;
                            phi_2735_ = _e2531;
                        } else {
                            phi_2735_ = u32();
                        }
                        let _e2533 = phi_2735_;
                        phi_675_ = _e2533;
                        let _e2830 = local_15;
                        phi_678_ = _e2830;
                        let _e2833 = local_16;
                        phi_2736_ = _e2833;
                        phi_2737_ = false;
                    } else {
                        phi_675_ = u32();
                        phi_678_ = bool();
                        phi_2736_ = false;
                        phi_2737_ = true;
                    }
                    let _e2535 = phi_675_;
                    let _e2537 = phi_678_;
                    let _e2539 = phi_2736_;
                    let _e2541 = phi_2737_;
                    local_11 = _e2541;
                    continue;
                    continuing {
                        phi_674_ = _e2535;
                        phi_677_ = _e2537;
                        break if !(_e2539);
                    }
                }
                let _e2544 = local_11;
                if _e2544 {
                    phi_2741_ = false;
                } else {
                    phi_2741_ = true;
                }
                let _e2546 = phi_2741_;
                if _e2546 {
                }
                phi_2745_ = _e2546;
            }
            let _e2548 = phi_2745_;
            phi_2746_ = _e183;
            phi_2747_ = _e2548;
        } else {
            phi_2746_ = true;
            phi_2747_ = false;
        }
        let _e2550 = phi_2746_;
        let _e2552 = phi_2747_;
        if _e2550 {
            phi_2751_ = false;
            phi_2752_ = true;
        } else {
            phi_2751_ = true;
            phi_2752_ = _e2552;
        }
        let _e2554 = phi_2751_;
        let _e2556 = phi_2752_;
        if _e2556 {
            phi_2756_ = _e2554;
        } else {
            phi_2756_ = false;
        }
        let _e2558 = phi_2756_;
        if _e2558 {
            phi_2760_ = 0f;
        } else {
            phi_2760_ = 1f;
        }
        let _e2560 = phi_2760_;
        if (_e87 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e87)] = _e2560;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
