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
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_335_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_362_: bool;
    var phi_432_: f32;
    var phi_439_: f32;
    var phi_446_: f32;
    var phi_453_: f32;
    var phi_460_: f32;
    var phi_467_: f32;
    var phi_484_: f32;
    var phi_489_: f32;
    var phi_494_: f32;
    var phi_499_: f32;
    var phi_504_: f32;
    var phi_523_: u32;
    var phi_528_: u32;
    var phi_533_: u32;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_679_: u32;
    var phi_681_: u32;
    var phi_684_: bool;
    var phi_764_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_791_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_818_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_824_: u32;
    var phi_827_: u32;
    var phi_841_: u32;
    var phi_851_: u32;
    var phi_861_: u32;
    var phi_879_: u32;
    var phi_889_: u32;
    var phi_899_: u32;
    var phi_935_: u32;
    var phi_948_: u32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_825_: u32;
    var phi_828_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1013_: u32;
    var phi_1016_: bool;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1075_: f32;
    var phi_1083_: f32;
    var phi_1088_: f32;
    var phi_1093_: f32;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1220_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1240_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1267_: bool;
    var phi_1337_: f32;
    var phi_1344_: f32;
    var phi_1351_: f32;
    var phi_1358_: f32;
    var phi_1365_: f32;
    var phi_1372_: f32;
    var phi_1389_: f32;
    var phi_1394_: f32;
    var phi_1399_: f32;
    var phi_1404_: f32;
    var phi_1409_: f32;
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
    var phi_1631_: bool;
    var phi_1711_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1738_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1765_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1771_: u32;
    var phi_1774_: u32;
    var phi_1788_: u32;
    var phi_1798_: u32;
    var phi_1808_: u32;
    var phi_1826_: u32;
    var phi_1836_: u32;
    var phi_1846_: u32;
    var phi_1882_: u32;
    var phi_1895_: u32;
    var phi_1900_: u32;
    var phi_1901_: u32;
    var phi_1902_: u32;
    var phi_1772_: u32;
    var phi_1775_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1960_: u32;
    var phi_1963_: bool;
    var phi_2007_: vec3<f32>;
    var phi_2008_: vec3<f32>;
    var phi_2037_: vec3<f32>;
    var phi_2038_: vec3<f32>;
    var phi_2067_: vec3<f32>;
    var phi_2068_: vec3<f32>;
    var phi_2086_: bool;
    var phi_2087_: bool;
    var phi_2091_: f32;
    var phi_2092_: f32;
    var phi_2093_: f32;
    var phi_2094_: f32;
    var phi_2102_: f32;
    var phi_2112_: bool;
    var phi_2113_: bool;
    var phi_2117_: f32;
    var phi_2118_: f32;
    var phi_2119_: f32;
    var phi_2120_: f32;
    var phi_2128_: f32;
    var phi_2138_: bool;
    var phi_2139_: bool;
    var phi_2143_: f32;
    var phi_2144_: f32;
    var phi_2145_: f32;
    var phi_2146_: f32;
    var phi_2154_: f32;
    var phi_2169_: f32;
    var phi_2170_: bool;
    var phi_2171_: f32;
    var phi_2172_: bool;
    var phi_2173_: f32;
    var phi_2174_: bool;
    var phi_2192_: f32;
    var phi_2193_: bool;
    var phi_2194_: bool;
    var phi_2195_: f32;
    var phi_2196_: bool;
    var phi_2197_: bool;
    var phi_2201_: bool;
    var phi_2202_: f32;
    var phi_2203_: bool;
    var phi_2231_: vec3<f32>;
    var phi_2232_: vec3<f32>;
    var phi_2257_: vec3<f32>;
    var phi_2258_: vec3<f32>;
    var phi_2283_: vec3<f32>;
    var phi_2284_: vec3<f32>;
    var phi_2340_: f32;
    var phi_2349_: f32;
    var phi_2358_: f32;
    var phi_2367_: f32;
    var phi_2374_: f32;
    var phi_2381_: f32;
    var phi_2394_: f32;
    var phi_2403_: f32;
    var phi_2412_: f32;
    var phi_2421_: f32;
    var phi_2428_: f32;
    var phi_2435_: f32;
    var phi_2452_: f32;
    var phi_2457_: f32;
    var phi_2462_: f32;
    var phi_2470_: f32;
    var phi_2475_: f32;
    var phi_2480_: f32;
    var phi_2492_: f32;
    var phi_2497_: f32;
    var phi_2502_: f32;
    var phi_2507_: f32;
    var phi_2512_: lt_bvh_triangle_Intersection;
    var phi_2513_: bool;
    var phi_2514_: lt_bvh_triangle_Intersection;
    var phi_2515_: bool;
    var phi_2519_: lt_bvh_triangle_Intersection;
    var phi_2520_: bool;
    var phi_2521_: lt_bvh_triangle_Intersection;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2527_: bool;
    var phi_2531_: lt_bvh_triangle_Intersection;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_1961_: u32;
    var phi_1964_: bool;
    var phi_2561_: bool;
    var local_8: bool;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2635_: u32;
    var phi_2636_: u32;
    var phi_1629_: u32;
    var phi_1632_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var local_9: bool;
    var phi_2642_: bool;
    var phi_2646_: bool;
    var phi_2647_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2653_: bool;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2660_: bool;
    var phi_2661_: bool;
    var phi_2662_: bool;
    var phi_2663_: bool;
    var phi_1014_: u32;
    var phi_1017_: bool;
    var phi_2667_: bool;
    var local_10: bool;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2741_: u32;
    var phi_2742_: u32;
    var phi_682_: u32;
    var phi_685_: bool;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var local_11: bool;
    var phi_2748_: bool;
    var phi_2752_: bool;
    var phi_2753_: bool;
    var phi_2754_: bool;
    var phi_2758_: bool;
    var phi_2759_: bool;
    var phi_2763_: bool;
    var phi_2767_: f32;
    var phi_2808_: u32;
    var phi_2827_: u32;
    var phi_2835_: u32;
    var phi_2843_: u32;
    var phi_2848_: u32;
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
        let _e134 = abs(_e131);
        let _e135 = abs(_e132);
        let _e136 = abs(_e133);
        if (abs(_e113) < 1000000000000000f) {
            if (abs(_e115) < 1000000000000000f) {
                phi_308_ = (abs(_e117) < 1000000000000000f);
                phi_309_ = false;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
            }
            let _e144 = phi_308_;
            let _e146 = phi_309_;
            phi_310_ = _e144;
            phi_311_ = _e146;
        } else {
            phi_310_ = bool();
            phi_311_ = true;
        }
        let _e148 = phi_310_;
        let _e150 = phi_311_;
        if _e150 {
            phi_315_ = false;
        } else {
            phi_315_ = _e148;
        }
        let _e152 = phi_315_;
        if _e152 {
            if (_e134 < 1000000000000000f) {
                if (_e135 < 1000000000000000f) {
                    phi_328_ = (_e136 < 1000000000000000f);
                    phi_329_ = false;
                } else {
                    phi_328_ = bool();
                    phi_329_ = true;
                }
                let _e157 = phi_328_;
                let _e159 = phi_329_;
                phi_330_ = _e157;
                phi_331_ = _e159;
            } else {
                phi_330_ = bool();
                phi_331_ = true;
            }
            let _e161 = phi_330_;
            let _e163 = phi_331_;
            if _e163 {
                phi_335_ = false;
            } else {
                phi_335_ = _e161;
            }
            let _e165 = phi_335_;
            if _e165 {
                if (_e134 > 0f) {
                    phi_349_ = bool();
                    phi_350_ = true;
                } else {
                    let _e167 = (_e135 > 0f);
                    if _e167 {
                        phi_348_ = bool();
                    } else {
                        phi_348_ = (_e136 > 0f);
                    }
                    let _e170 = phi_348_;
                    phi_349_ = _e170;
                    phi_350_ = _e167;
                }
                let _e172 = phi_349_;
                let _e174 = phi_350_;
                if _e174 {
                    phi_354_ = true;
                } else {
                    phi_354_ = _e172;
                }
                let _e176 = phi_354_;
                phi_355_ = _e176;
                phi_356_ = false;
            } else {
                phi_355_ = bool();
                phi_356_ = true;
            }
            let _e178 = phi_355_;
            let _e180 = phi_356_;
            phi_357_ = _e178;
            phi_358_ = _e180;
        } else {
            phi_357_ = bool();
            phi_358_ = true;
        }
        let _e182 = phi_357_;
        let _e184 = phi_358_;
        if _e184 {
            phi_362_ = false;
        } else {
            phi_362_ = _e182;
        }
        let _e186 = phi_362_;
        if _e186 {
            let _e187 = (_e93 >= _e63);
            if _e187 {
                phi_2752_ = false;
            } else {
                if (_e93 < _e63) {
                } else {
                    return;
                }
                let _e193 = nodes.member[(0u + _e93)].frame[0u];
                let _e197 = nodes.member[(0u + _e93)].frame[1u];
                let _e201 = nodes.member[(0u + _e93)].frame[2u];
                let _e205 = nodes.member[(0u + _e93)].frame[0u];
                let _e209 = nodes.member[(0u + _e93)].frame[1u];
                let _e213 = nodes.member[(0u + _e93)].frame[2u];
                let _e217 = nodes.member[(0u + _e93)].frame[3u];
                let _e251 = core_intrinsics_maximum_number_nsz_f32_(abs(_e131), abs(_e132));
                let _e252 = core_intrinsics_maximum_number_nsz_f32_(_e251, abs(_e133));
                let _e253 = (_e252 * 0.0000000000009094947f);
                if (abs(_e131) < _e253) {
                    phi_432_ = _e253;
                } else {
                    phi_432_ = abs(_e131);
                }
                let _e258 = phi_432_;
                if (_e131 < 0f) {
                    phi_439_ = (-1f / _e258);
                } else {
                    phi_439_ = (1f / _e258);
                }
                let _e263 = phi_439_;
                if (abs(_e132) < _e253) {
                    phi_446_ = _e253;
                } else {
                    phi_446_ = abs(_e132);
                }
                let _e268 = phi_446_;
                if (_e132 < 0f) {
                    phi_453_ = (-1f / _e268);
                } else {
                    phi_453_ = (1f / _e268);
                }
                let _e273 = phi_453_;
                if (abs(_e133) < _e253) {
                    phi_460_ = _e253;
                } else {
                    phi_460_ = abs(_e133);
                }
                let _e278 = phi_460_;
                if (_e133 < 0f) {
                    phi_467_ = (-1f / _e278);
                } else {
                    phi_467_ = (1f / _e278);
                }
                let _e283 = phi_467_;
                let _e287 = abs((bitcast<f32>(_e193) - _e113));
                let _e288 = abs((bitcast<f32>(_e197) - _e115));
                let _e289 = abs((bitcast<f32>(_e201) - _e117));
                let _e293 = abs(((bitcast<f32>(_e205) + (bitcast<f32>((((_e217 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                let _e294 = abs(((bitcast<f32>(_e209) + (bitcast<f32>((((_e217 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e115));
                let _e295 = abs(((bitcast<f32>(_e213) + (bitcast<f32>((((_e217 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e117));
                if (_e287 > _e293) {
                    phi_484_ = _e287;
                } else {
                    phi_484_ = _e293;
                }
                let _e298 = phi_484_;
                if (_e288 > _e294) {
                    phi_489_ = _e288;
                } else {
                    phi_489_ = _e294;
                }
                let _e301 = phi_489_;
                if (_e289 > _e295) {
                    phi_494_ = _e289;
                } else {
                    phi_494_ = _e295;
                }
                let _e304 = phi_494_;
                if (_e298 > _e301) {
                    phi_499_ = _e298;
                } else {
                    phi_499_ = _e301;
                }
                let _e307 = phi_499_;
                if (_e307 > _e304) {
                    phi_504_ = _e307;
                } else {
                    phi_504_ = _e304;
                }
                let _e310 = phi_504_;
                let _e314 = (_e310 * 0.0000019073486f);
                let _e315 = (abs(_e263) * _e314);
                let _e316 = (abs(_e273) * _e314);
                let _e317 = (abs(_e283) * _e314);
                let _e321 = (_e310 * 0.0000009536743f);
                let _e322 = (abs(_e263) * _e321);
                let _e323 = (abs(_e273) * _e321);
                let _e324 = (abs(_e283) * _e321);
                if (_e263 < 0f) {
                    phi_523_ = 0u;
                } else {
                    phi_523_ = 1u;
                }
                let _e327 = phi_523_;
                if (_e273 < 0f) {
                    phi_528_ = 0u;
                } else {
                    phi_528_ = 2u;
                }
                let _e330 = phi_528_;
                if (_e283 < 0f) {
                    phi_533_ = 0u;
                } else {
                    phi_533_ = 4u;
                }
                let _e333 = phi_533_;
                let _e335 = ((_e327 | _e330) | _e333);
                let _e336 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e93, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e336.first[0], _e336.first[1], _e336.first[2], _e336.first[3], _e336.first[4], _e336.first[5], _e336.first[6], _e336.first[7], _e336.first[8], _e336.first[9], _e336.first[10], _e336.first[11], _e336.first[12], _e336.first[13], _e336.first[14], _e336.first[15], _e336.first[16], _e336.first[17], _e336.first[18], _e336.first[19], _e336.first[20], _e336.first[21], _e336.first[22], _e336.first[23], _e336.first[24], _e336.first[25], _e336.first[26], _e336.first[27], _e336.first[28], _e336.first[29], _e336.first[30], _e336.first[31]), array<u32, 32>(_e336.mask[0], _e336.mask[1], _e336.mask[2], _e336.mask[3], _e336.mask[4], _e336.mask[5], _e336.mask[6], _e336.mask[7], _e336.mask[8], _e336.mask[9], _e336.mask[10], _e336.mask[11], _e336.mask[12], _e336.mask[13], _e336.mask[14], _e336.mask[15], _e336.mask[16], _e336.mask[17], _e336.mask[18], _e336.mask[19], _e336.mask[20], _e336.mask[21], _e336.mask[22], _e336.mask[23], _e336.mask[24], _e336.mask[25], _e336.mask[26], _e336.mask[27], _e336.mask[28], _e336.mask[29], _e336.mask[30], _e336.mask[31]), _e336.len, _e336.group, _e336.group_mask);
                let _e410 = local_1.group_mask;
                if ((_e410 & 4278190080u) == 0u) {
                    let _e414 = local_1.len;
                    if (_e414 == 0u) {
                        phi_647_ = false;
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
                        phi_647_ = true;
                    }
                    let _e437 = phi_647_;
                    phi_648_ = _e437;
                } else {
                    phi_648_ = true;
                }
                let _e439 = phi_648_;
                if _e439 {
                    let _e441 = local_1.group_mask;
                    let _e447 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e441)), 32u, (_e441 == 0u)));
                    let _e451 = local_1.group_mask;
                    let _e465 = local_1.group_mask;
                    local_1.group_mask = (_e465 & ~((1u << bitcast<u32>((_e447 & 31u)))));
                    let _e468 = local_1.group;
                    phi_679_ = (_e468 + countOneBits(((_e451 & ~((4294967295u << bitcast<u32>((((_e447 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_679_ = 4294967295u;
                }
                let _e471 = phi_679_;
                phi_681_ = _e471;
                phi_684_ = false;
                loop {
                    let _e473 = phi_681_;
                    let _e475 = phi_684_;
                    if (_e473 != 4294967295u) {
                        if (_e473 < _e63) {
                        } else {
                            return;
                        }
                        let _e482 = nodes.member[(0u + _e473)].frame[3u];
                        let _e507 = (bitcast<f32>((((_e482 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e263);
                        let _e508 = (bitcast<f32>((((_e482 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e273);
                        let _e509 = (bitcast<f32>((((_e482 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e283);
                        let _e512 = nodes.member[(0u + _e473)].frame[0u];
                        let _e516 = nodes.member[(0u + _e473)].frame[1u];
                        let _e520 = nodes.member[(0u + _e473)].frame[2u];
                        let _e525 = ((bitcast<f32>(_e512) - _e113) * _e263);
                        let _e526 = ((bitcast<f32>(_e516) - _e115) * _e273);
                        let _e527 = ((bitcast<f32>(_e520) - _e117) * _e283);
                        let _e535 = nodes.member[(0u + _e473)].x;
                        if (_e263 < 0f) {
                            let _e546 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e535.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e546.unnamed.word, _e535.w), _e546.unnamed_1);
                            let _e558 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e552.unnamed, lt_mask_LightPlace(_e535.x, _e552.unnamed_1.shift));
                            phi_764_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e558.unnamed, lt_mask_LightPlace(_e558.unnamed_1.word, _e535.y));
                        } else {
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e535.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e574.unnamed.word, _e535.y), _e574.unnamed_1);
                            let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_mask_LightPlace(_e535.z, _e580.unnamed_1.shift));
                            phi_764_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e586.unnamed, lt_mask_LightPlace(_e586.unnamed_1.word, _e535.w));
                        }
                        let _e594 = phi_764_;
                        let _e604 = nodes.member[(0u + _e473)].y;
                        if (_e273 < 0f) {
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e604.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e615.unnamed.word, _e604.w), _e615.unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_mask_LightPlace(_e604.x, _e621.unnamed_1.shift));
                            phi_791_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_mask_LightPlace(_e627.unnamed_1.word, _e604.y));
                        } else {
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e604.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e643.unnamed.word, _e604.y), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_mask_LightPlace(_e604.z, _e649.unnamed_1.shift));
                            phi_791_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e655.unnamed_1.word, _e604.w));
                        }
                        let _e663 = phi_791_;
                        let _e673 = nodes.member[(0u + _e473)].z;
                        if (_e283 < 0f) {
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e673.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e684.unnamed.word, _e673.w), _e684.unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_mask_LightPlace(_e673.x, _e690.unnamed_1.shift));
                            phi_818_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_mask_LightPlace(_e696.unnamed_1.word, _e673.y));
                        } else {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e673.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e712.unnamed.word, _e673.y), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_mask_LightPlace(_e673.z, _e718.unnamed_1.shift));
                            phi_818_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e724.unnamed_1.word, _e673.w));
                        }
                        let _e732 = phi_818_;
                        phi_824_ = 0u;
                        phi_827_ = 0u;
                        loop {
                            let _e742 = phi_824_;
                            let _e744 = phi_827_;
                            local_2 = _e744;
                            local_3 = _e744;
                            local_4 = _e744;
                            let _e745 = (_e742 < 8u);
                            if _e745 {
                                let _e747 = (_e742 >> bitcast<u32>(2i));
                                let _e748 = (_e742 & 3u);
                                if (_e747 == 0u) {
                                    phi_841_ = _e594.unnamed.word;
                                } else {
                                    phi_841_ = _e594.unnamed.shift;
                                }
                                let _e751 = phi_841_;
                                if (_e747 == 0u) {
                                    phi_851_ = _e663.unnamed.word;
                                } else {
                                    phi_851_ = _e663.unnamed.shift;
                                }
                                let _e760 = phi_851_;
                                if (_e747 == 0u) {
                                    phi_861_ = _e732.unnamed.word;
                                } else {
                                    phi_861_ = _e732.unnamed.shift;
                                }
                                let _e769 = phi_861_;
                                let _e782 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e751 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e315)), ((f32(((_e760 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 - _e316)));
                                let _e783 = core_intrinsics_maximum_number_nsz_f32_(_e782, ((f32(((_e769 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e317)));
                                if (_e747 == 0u) {
                                    phi_879_ = _e594.unnamed_1.word;
                                } else {
                                    phi_879_ = _e594.unnamed_1.shift;
                                }
                                let _e786 = phi_879_;
                                if (_e747 == 0u) {
                                    phi_889_ = _e663.unnamed_1.word;
                                } else {
                                    phi_889_ = _e663.unnamed_1.shift;
                                }
                                let _e795 = phi_889_;
                                if (_e747 == 0u) {
                                    phi_899_ = _e732.unnamed_1.word;
                                } else {
                                    phi_899_ = _e732.unnamed_1.shift;
                                }
                                let _e804 = phi_899_;
                                let _e817 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e786 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e315)), ((f32(((_e795 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 + _e316)));
                                let _e818 = core_intrinsics_minimum_number_nsz_f32_(_e817, ((f32(((_e804 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e317)));
                                if (_e783 <= _e818) {
                                    if (_e783 <= _e123) {
                                        if (_e818 >= 0f) {
                                            if (_e747 == 0u) {
                                                let _e825 = nodes.member[(0u + _e473)].links[2u];
                                                phi_935_ = _e825;
                                            } else {
                                                let _e828 = nodes.member[(0u + _e473)].links[3u];
                                                phi_935_ = _e828;
                                            }
                                            let _e830 = phi_935_;
                                            let _e835 = ((_e830 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u);
                                            let _e836 = (_e835 & 31u);
                                            if (_e836 >= 24u) {
                                                phi_948_ = (24u + ((_e836 - 24u) ^ _e335));
                                            } else {
                                                phi_948_ = _e836;
                                            }
                                            let _e842 = phi_948_;
                                            phi_953_ = (_e744 | ((_e835 >> bitcast<u32>(5i)) << bitcast<u32>((_e842 & 31u))));
                                        } else {
                                            phi_953_ = _e744;
                                        }
                                        let _e850 = phi_953_;
                                        phi_954_ = _e850;
                                    } else {
                                        phi_954_ = _e744;
                                    }
                                    let _e852 = phi_954_;
                                    phi_955_ = _e852;
                                } else {
                                    phi_955_ = _e744;
                                }
                                let _e854 = phi_955_;
                                phi_825_ = (_e742 + 1u);
                                phi_828_ = _e854;
                            } else {
                                phi_825_ = u32();
                                phi_828_ = u32();
                            }
                            let _e857 = phi_825_;
                            let _e859 = phi_828_;
                            continue;
                            continuing {
                                phi_824_ = _e857;
                                phi_827_ = _e859;
                                break if !(_e745);
                            }
                        }
                        let _e863 = nodes.member[(0u + _e473)].links[0u];
                        let _e867 = nodes.member[(0u + _e473)].frame[3u];
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
                            local_1.group = (_e93 + _e863);
                            let _e903 = local_3;
                            local_1.group_mask = ((_e903 & 4278190080u) | (_e867 >> bitcast<u32>(24i)));
                        }
                        let _e908 = local_4;
                        phi_1013_ = (_e908 & 16777215u);
                        phi_1016_ = _e475;
                        loop {
                            let _e911 = phi_1013_;
                            let _e913 = phi_1016_;
                            local_15 = _e913;
                            let _e914 = (_e911 == 0u);
                            local_10 = _e914;
                            local_16 = _e914;
                            if _e914 {
                                phi_1014_ = u32();
                                phi_1017_ = bool();
                                phi_2667_ = false;
                            } else {
                                let _e917 = nodes.member[(0u + _e473)].links[1u];
                                let _e921 = (_e917 + select(firstTrailingBit(_e911), 32u, (_e911 == 0u)));
                                if (_e921 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e928 = instances.member[(0u + _e921)].low_world;
                                let _e930 = instances.member[(0u + _e921)].high_world;
                                let _e937 = ((_e928.x - _e113) * _e263);
                                let _e938 = ((_e928.y - _e115) * _e273);
                                let _e939 = ((_e928.z - _e117) * _e283);
                                let _e946 = ((_e930.x - _e113) * _e263);
                                let _e947 = ((_e930.y - _e115) * _e273);
                                let _e948 = ((_e930.z - _e117) * _e283);
                                if (_e937 < _e946) {
                                    phi_1065_ = _e937;
                                } else {
                                    phi_1065_ = _e946;
                                }
                                let _e951 = phi_1065_;
                                if (_e938 < _e947) {
                                    phi_1070_ = _e938;
                                } else {
                                    phi_1070_ = _e947;
                                }
                                let _e954 = phi_1070_;
                                if (_e939 < _e948) {
                                    phi_1075_ = _e939;
                                } else {
                                    phi_1075_ = _e948;
                                }
                                let _e957 = phi_1075_;
                                if (_e937 > _e946) {
                                    phi_1083_ = _e937;
                                } else {
                                    phi_1083_ = _e946;
                                }
                                let _e963 = phi_1083_;
                                if (_e938 > _e947) {
                                    phi_1088_ = _e938;
                                } else {
                                    phi_1088_ = _e947;
                                }
                                let _e966 = phi_1088_;
                                if (_e939 > _e948) {
                                    phi_1093_ = _e939;
                                } else {
                                    phi_1093_ = _e948;
                                }
                                let _e969 = phi_1093_;
                                let _e973 = core_intrinsics_maximum_number_nsz_f32_((_e951 - _e322), (_e954 - _e323));
                                let _e974 = core_intrinsics_maximum_number_nsz_f32_(_e973, (_e957 - _e324));
                                let _e975 = core_intrinsics_minimum_number_nsz_f32_((_e963 + _e322), (_e966 + _e323));
                                let _e976 = core_intrinsics_minimum_number_nsz_f32_(_e975, (_e969 + _e324));
                                if (_e974 <= _e976) {
                                    if (_e974 <= _e123) {
                                        if (_e976 >= 0f) {
                                            let _e982 = instances.member[(0u + _e921)].world_to_object[0u];
                                            let _e993 = ((((_e982.x * _e113) + (_e982.y * _e115)) + (_e982.z * _e117)) + (_e982.w * 1f));
                                            let _e995 = instances.member[(0u + _e921)].world_to_object[1u];
                                            let _e1006 = ((((_e995.x * _e113) + (_e995.y * _e115)) + (_e995.z * _e117)) + (_e995.w * 1f));
                                            let _e1008 = instances.member[(0u + _e921)].world_to_object[2u];
                                            let _e1019 = ((((_e1008.x * _e113) + (_e1008.y * _e115)) + (_e1008.z * _e117)) + (_e1008.w * 1f));
                                            let _e1022 = instances.member[(0u + _e921)].world_to_object[0u];
                                            let _e1033 = ((((_e1022.x * _e131) + (_e1022.y * _e132)) + (_e1022.z * _e133)) + (_e1022.w * 0f));
                                            let _e1035 = instances.member[(0u + _e921)].world_to_object[1u];
                                            let _e1046 = ((((_e1035.x * _e131) + (_e1035.y * _e132)) + (_e1035.z * _e133)) + (_e1035.w * 0f));
                                            let _e1048 = instances.member[(0u + _e921)].world_to_object[2u];
                                            let _e1059 = ((((_e1048.x * _e131) + (_e1048.y * _e132)) + (_e1048.z * _e133)) + (_e1048.w * 0f));
                                            let _e1062 = instances.member[(0u + _e921)].root;
                                            let _e1064 = instances.member[(0u + _e921)].first_triangle;
                                            let _e1065 = abs(_e1033);
                                            let _e1066 = abs(_e1046);
                                            let _e1067 = abs(_e1059);
                                            if (abs(_e993) < 1000000000000000f) {
                                                if (abs(_e1006) < 1000000000000000f) {
                                                    phi_1213_ = (abs(_e1019) < 1000000000000000f);
                                                    phi_1214_ = false;
                                                } else {
                                                    phi_1213_ = bool();
                                                    phi_1214_ = true;
                                                }
                                                let _e1075 = phi_1213_;
                                                let _e1077 = phi_1214_;
                                                phi_1215_ = _e1075;
                                                phi_1216_ = _e1077;
                                            } else {
                                                phi_1215_ = bool();
                                                phi_1216_ = true;
                                            }
                                            let _e1079 = phi_1215_;
                                            let _e1081 = phi_1216_;
                                            if _e1081 {
                                                phi_1220_ = false;
                                            } else {
                                                phi_1220_ = _e1079;
                                            }
                                            let _e1083 = phi_1220_;
                                            if _e1083 {
                                                if (_e1065 < 1000000000000000f) {
                                                    if (_e1066 < 1000000000000000f) {
                                                        phi_1233_ = (_e1067 < 1000000000000000f);
                                                        phi_1234_ = false;
                                                    } else {
                                                        phi_1233_ = bool();
                                                        phi_1234_ = true;
                                                    }
                                                    let _e1088 = phi_1233_;
                                                    let _e1090 = phi_1234_;
                                                    phi_1235_ = _e1088;
                                                    phi_1236_ = _e1090;
                                                } else {
                                                    phi_1235_ = bool();
                                                    phi_1236_ = true;
                                                }
                                                let _e1092 = phi_1235_;
                                                let _e1094 = phi_1236_;
                                                if _e1094 {
                                                    phi_1240_ = false;
                                                } else {
                                                    phi_1240_ = _e1092;
                                                }
                                                let _e1096 = phi_1240_;
                                                if _e1096 {
                                                    if (_e1065 > 0f) {
                                                        phi_1254_ = bool();
                                                        phi_1255_ = true;
                                                    } else {
                                                        let _e1098 = (_e1066 > 0f);
                                                        if _e1098 {
                                                            phi_1253_ = bool();
                                                        } else {
                                                            phi_1253_ = (_e1067 > 0f);
                                                        }
                                                        let _e1101 = phi_1253_;
                                                        phi_1254_ = _e1101;
                                                        phi_1255_ = _e1098;
                                                    }
                                                    let _e1103 = phi_1254_;
                                                    let _e1105 = phi_1255_;
                                                    if _e1105 {
                                                        phi_1259_ = true;
                                                    } else {
                                                        phi_1259_ = _e1103;
                                                    }
                                                    let _e1107 = phi_1259_;
                                                    phi_1260_ = _e1107;
                                                    phi_1261_ = false;
                                                } else {
                                                    phi_1260_ = bool();
                                                    phi_1261_ = true;
                                                }
                                                let _e1109 = phi_1260_;
                                                let _e1111 = phi_1261_;
                                                phi_1262_ = _e1109;
                                                phi_1263_ = _e1111;
                                            } else {
                                                phi_1262_ = bool();
                                                phi_1263_ = true;
                                            }
                                            let _e1113 = phi_1262_;
                                            let _e1115 = phi_1263_;
                                            if _e1115 {
                                                phi_1267_ = false;
                                            } else {
                                                phi_1267_ = _e1113;
                                            }
                                            let _e1117 = phi_1267_;
                                            if _e1117 {
                                                let _e1118 = (_e1062 >= _e63);
                                                if _e1118 {
                                                    phi_2647_ = bool();
                                                } else {
                                                    if (_e1062 < _e63) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1124 = nodes.member[(0u + _e1062)].frame[0u];
                                                    let _e1128 = nodes.member[(0u + _e1062)].frame[1u];
                                                    let _e1132 = nodes.member[(0u + _e1062)].frame[2u];
                                                    let _e1136 = nodes.member[(0u + _e1062)].frame[0u];
                                                    let _e1140 = nodes.member[(0u + _e1062)].frame[1u];
                                                    let _e1144 = nodes.member[(0u + _e1062)].frame[2u];
                                                    let _e1148 = nodes.member[(0u + _e1062)].frame[3u];
                                                    let _e1182 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1033), abs(_e1046));
                                                    let _e1183 = core_intrinsics_maximum_number_nsz_f32_(_e1182, abs(_e1059));
                                                    let _e1184 = (_e1183 * 0.0000000000009094947f);
                                                    if (abs(_e1033) < _e1184) {
                                                        phi_1337_ = _e1184;
                                                    } else {
                                                        phi_1337_ = abs(_e1033);
                                                    }
                                                    let _e1189 = phi_1337_;
                                                    if (_e1033 < 0f) {
                                                        phi_1344_ = (-1f / _e1189);
                                                    } else {
                                                        phi_1344_ = (1f / _e1189);
                                                    }
                                                    let _e1194 = phi_1344_;
                                                    if (abs(_e1046) < _e1184) {
                                                        phi_1351_ = _e1184;
                                                    } else {
                                                        phi_1351_ = abs(_e1046);
                                                    }
                                                    let _e1199 = phi_1351_;
                                                    if (_e1046 < 0f) {
                                                        phi_1358_ = (-1f / _e1199);
                                                    } else {
                                                        phi_1358_ = (1f / _e1199);
                                                    }
                                                    let _e1204 = phi_1358_;
                                                    if (abs(_e1059) < _e1184) {
                                                        phi_1365_ = _e1184;
                                                    } else {
                                                        phi_1365_ = abs(_e1059);
                                                    }
                                                    let _e1209 = phi_1365_;
                                                    if (_e1059 < 0f) {
                                                        phi_1372_ = (-1f / _e1209);
                                                    } else {
                                                        phi_1372_ = (1f / _e1209);
                                                    }
                                                    let _e1214 = phi_1372_;
                                                    let _e1218 = abs((bitcast<f32>(_e1124) - _e993));
                                                    let _e1219 = abs((bitcast<f32>(_e1128) - _e1006));
                                                    let _e1220 = abs((bitcast<f32>(_e1132) - _e1019));
                                                    let _e1224 = abs(((bitcast<f32>(_e1136) + (bitcast<f32>((((_e1148 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e993));
                                                    let _e1225 = abs(((bitcast<f32>(_e1140) + (bitcast<f32>((((_e1148 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1006));
                                                    let _e1226 = abs(((bitcast<f32>(_e1144) + (bitcast<f32>((((_e1148 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1019));
                                                    if (_e1218 > _e1224) {
                                                        phi_1389_ = _e1218;
                                                    } else {
                                                        phi_1389_ = _e1224;
                                                    }
                                                    let _e1229 = phi_1389_;
                                                    if (_e1219 > _e1225) {
                                                        phi_1394_ = _e1219;
                                                    } else {
                                                        phi_1394_ = _e1225;
                                                    }
                                                    let _e1232 = phi_1394_;
                                                    if (_e1220 > _e1226) {
                                                        phi_1399_ = _e1220;
                                                    } else {
                                                        phi_1399_ = _e1226;
                                                    }
                                                    let _e1235 = phi_1399_;
                                                    if (_e1229 > _e1232) {
                                                        phi_1404_ = _e1229;
                                                    } else {
                                                        phi_1404_ = _e1232;
                                                    }
                                                    let _e1238 = phi_1404_;
                                                    if (_e1238 > _e1235) {
                                                        phi_1409_ = _e1238;
                                                    } else {
                                                        phi_1409_ = _e1235;
                                                    }
                                                    let _e1241 = phi_1409_;
                                                    let _e1245 = (_e1241 * 0.0000019073486f);
                                                    let _e1246 = (abs(_e1194) * _e1245);
                                                    let _e1247 = (abs(_e1204) * _e1245);
                                                    let _e1248 = (abs(_e1214) * _e1245);
                                                    let _e1252 = (_e1241 * 0.0000009536743f);
                                                    let _e1253 = (abs(_e1194) * _e1252);
                                                    let _e1254 = (abs(_e1204) * _e1252);
                                                    let _e1255 = (abs(_e1214) * _e1252);
                                                    let _e1256 = abs(_e1033);
                                                    let _e1257 = abs(_e1046);
                                                    let _e1258 = abs(_e1059);
                                                    if (_e1256 >= _e1257) {
                                                        if (_e1256 >= _e1258) {
                                                            phi_1435_ = false;
                                                        } else {
                                                            phi_1435_ = true;
                                                        }
                                                        let _e1262 = phi_1435_;
                                                        phi_1436_ = _e1262;
                                                    } else {
                                                        phi_1436_ = true;
                                                    }
                                                    let _e1264 = phi_1436_;
                                                    if _e1264 {
                                                        if (_e1257 >= _e1258) {
                                                            phi_1444_ = 1u;
                                                        } else {
                                                            phi_1444_ = 2u;
                                                        }
                                                        let _e1267 = phi_1444_;
                                                        phi_1445_ = _e1267;
                                                    } else {
                                                        phi_1445_ = 0u;
                                                    }
                                                    let _e1269 = phi_1445_;
                                                    if (_e1269 == 0u) {
                                                        phi_1457_ = vec3<f32>(_e1046, _e1059, _e1033);
                                                    } else {
                                                        if (_e1269 == 1u) {
                                                            phi_1456_ = vec3<f32>(_e1059, _e1033, _e1046);
                                                        } else {
                                                            phi_1456_ = vec3<f32>(_e1033, _e1046, _e1059);
                                                        }
                                                        let _e1275 = phi_1456_;
                                                        phi_1457_ = _e1275;
                                                    }
                                                    let _e1277 = phi_1457_;
                                                    let _e1280 = (_e1277.x / _e1277.z);
                                                    let _e1283 = (_e1277.y / _e1277.z);
                                                    if (_e1194 < 0f) {
                                                        phi_1470_ = 0u;
                                                    } else {
                                                        phi_1470_ = 1u;
                                                    }
                                                    let _e1288 = phi_1470_;
                                                    if (_e1204 < 0f) {
                                                        phi_1475_ = 0u;
                                                    } else {
                                                        phi_1475_ = 2u;
                                                    }
                                                    let _e1291 = phi_1475_;
                                                    if (_e1214 < 0f) {
                                                        phi_1480_ = 0u;
                                                    } else {
                                                        phi_1480_ = 4u;
                                                    }
                                                    let _e1294 = phi_1480_;
                                                    let _e1296 = ((_e1288 | _e1291) | _e1294);
                                                    let _e1297 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1062, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1297.first[0], _e1297.first[1], _e1297.first[2], _e1297.first[3], _e1297.first[4], _e1297.first[5], _e1297.first[6], _e1297.first[7], _e1297.first[8], _e1297.first[9], _e1297.first[10], _e1297.first[11], _e1297.first[12], _e1297.first[13], _e1297.first[14], _e1297.first[15], _e1297.first[16], _e1297.first[17], _e1297.first[18], _e1297.first[19], _e1297.first[20], _e1297.first[21], _e1297.first[22], _e1297.first[23], _e1297.first[24], _e1297.first[25], _e1297.first[26], _e1297.first[27], _e1297.first[28], _e1297.first[29], _e1297.first[30], _e1297.first[31]), array<u32, 32>(_e1297.mask[0], _e1297.mask[1], _e1297.mask[2], _e1297.mask[3], _e1297.mask[4], _e1297.mask[5], _e1297.mask[6], _e1297.mask[7], _e1297.mask[8], _e1297.mask[9], _e1297.mask[10], _e1297.mask[11], _e1297.mask[12], _e1297.mask[13], _e1297.mask[14], _e1297.mask[15], _e1297.mask[16], _e1297.mask[17], _e1297.mask[18], _e1297.mask[19], _e1297.mask[20], _e1297.mask[21], _e1297.mask[22], _e1297.mask[23], _e1297.mask[24], _e1297.mask[25], _e1297.mask[26], _e1297.mask[27], _e1297.mask[28], _e1297.mask[29], _e1297.mask[30], _e1297.mask[31]), _e1297.len, _e1297.group, _e1297.group_mask);
                                                    let _e1371 = local.group_mask;
                                                    if ((_e1371 & 4278190080u) == 0u) {
                                                        let _e1375 = local.len;
                                                        if (_e1375 == 0u) {
                                                            phi_1594_ = false;
                                                        } else {
                                                            let _e1379 = local.len;
                                                            local.len = (_e1379 - 1u);
                                                            let _e1382 = local.len;
                                                            if (_e1382 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1387 = local.first[(0u + _e1382)];
                                                            local.group = _e1387;
                                                            let _e1390 = local.len;
                                                            if (_e1390 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1395 = local.mask[(0u + _e1390)];
                                                            local.group_mask = _e1395;
                                                            phi_1594_ = true;
                                                        }
                                                        let _e1398 = phi_1594_;
                                                        phi_1595_ = _e1398;
                                                    } else {
                                                        phi_1595_ = true;
                                                    }
                                                    let _e1400 = phi_1595_;
                                                    if _e1400 {
                                                        let _e1402 = local.group_mask;
                                                        let _e1408 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1402)), 32u, (_e1402 == 0u)));
                                                        let _e1412 = local.group_mask;
                                                        let _e1426 = local.group_mask;
                                                        local.group_mask = (_e1426 & ~((1u << bitcast<u32>((_e1408 & 31u)))));
                                                        let _e1429 = local.group;
                                                        phi_1626_ = (_e1429 + countOneBits(((_e1412 & ~((4294967295u << bitcast<u32>((((_e1408 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1626_ = 4294967295u;
                                                    }
                                                    let _e1432 = phi_1626_;
                                                    phi_1628_ = _e1432;
                                                    phi_1631_ = _e913;
                                                    loop {
                                                        let _e1434 = phi_1628_;
                                                        let _e1436 = phi_1631_;
                                                        local_14 = _e1436;
                                                        if (_e1434 != 4294967295u) {
                                                            if (_e1434 < _e63) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1443 = nodes.member[(0u + _e1434)].frame[3u];
                                                            let _e1468 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1194);
                                                            let _e1469 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1204);
                                                            let _e1470 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1214);
                                                            let _e1473 = nodes.member[(0u + _e1434)].frame[0u];
                                                            let _e1477 = nodes.member[(0u + _e1434)].frame[1u];
                                                            let _e1481 = nodes.member[(0u + _e1434)].frame[2u];
                                                            let _e1486 = ((bitcast<f32>(_e1473) - _e993) * _e1194);
                                                            let _e1487 = ((bitcast<f32>(_e1477) - _e1006) * _e1204);
                                                            let _e1488 = ((bitcast<f32>(_e1481) - _e1019) * _e1214);
                                                            let _e1496 = nodes.member[(0u + _e1434)].x;
                                                            if (_e1194 < 0f) {
                                                                let _e1507 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1496.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1513 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1507.unnamed.word, _e1496.w), _e1507.unnamed_1);
                                                                let _e1519 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1513.unnamed, lt_mask_LightPlace(_e1496.x, _e1513.unnamed_1.shift));
                                                                phi_1711_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1519.unnamed, lt_mask_LightPlace(_e1519.unnamed_1.word, _e1496.y));
                                                            } else {
                                                                let _e1535 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1496.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1535.unnamed.word, _e1496.y), _e1535.unnamed_1);
                                                                let _e1547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_mask_LightPlace(_e1496.z, _e1541.unnamed_1.shift));
                                                                phi_1711_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1547.unnamed, lt_mask_LightPlace(_e1547.unnamed_1.word, _e1496.w));
                                                            }
                                                            let _e1555 = phi_1711_;
                                                            let _e1565 = nodes.member[(0u + _e1434)].y;
                                                            if (_e1204 < 0f) {
                                                                let _e1576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1565.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1576.unnamed.word, _e1565.w), _e1576.unnamed_1);
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1582.unnamed, lt_mask_LightPlace(_e1565.x, _e1582.unnamed_1.shift));
                                                                phi_1738_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1588.unnamed, lt_mask_LightPlace(_e1588.unnamed_1.word, _e1565.y));
                                                            } else {
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1565.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1604.unnamed.word, _e1565.y), _e1604.unnamed_1);
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_mask_LightPlace(_e1565.z, _e1610.unnamed_1.shift));
                                                                phi_1738_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1616.unnamed, lt_mask_LightPlace(_e1616.unnamed_1.word, _e1565.w));
                                                            }
                                                            let _e1624 = phi_1738_;
                                                            let _e1634 = nodes.member[(0u + _e1434)].z;
                                                            if (_e1214 < 0f) {
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1634.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1645.unnamed.word, _e1634.w), _e1645.unnamed_1);
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1651.unnamed, lt_mask_LightPlace(_e1634.x, _e1651.unnamed_1.shift));
                                                                phi_1765_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_mask_LightPlace(_e1657.unnamed_1.word, _e1634.y));
                                                            } else {
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1634.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1673.unnamed.word, _e1634.y), _e1673.unnamed_1);
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_mask_LightPlace(_e1634.z, _e1679.unnamed_1.shift));
                                                                phi_1765_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1685.unnamed, lt_mask_LightPlace(_e1685.unnamed_1.word, _e1634.w));
                                                            }
                                                            let _e1693 = phi_1765_;
                                                            phi_1771_ = 0u;
                                                            phi_1774_ = 0u;
                                                            loop {
                                                                let _e1703 = phi_1771_;
                                                                let _e1705 = phi_1774_;
                                                                local_5 = _e1705;
                                                                local_6 = _e1705;
                                                                local_7 = _e1705;
                                                                let _e1706 = (_e1703 < 8u);
                                                                if _e1706 {
                                                                    let _e1708 = (_e1703 >> bitcast<u32>(2i));
                                                                    let _e1709 = (_e1703 & 3u);
                                                                    if (_e1708 == 0u) {
                                                                        phi_1788_ = _e1555.unnamed.word;
                                                                    } else {
                                                                        phi_1788_ = _e1555.unnamed.shift;
                                                                    }
                                                                    let _e1712 = phi_1788_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1798_ = _e1624.unnamed.word;
                                                                    } else {
                                                                        phi_1798_ = _e1624.unnamed.shift;
                                                                    }
                                                                    let _e1721 = phi_1798_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1808_ = _e1693.unnamed.word;
                                                                    } else {
                                                                        phi_1808_ = _e1693.unnamed.shift;
                                                                    }
                                                                    let _e1730 = phi_1808_;
                                                                    let _e1743 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1712 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 - _e1246)), ((f32(((_e1721 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1247)));
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(_e1743, ((f32(((_e1730 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1248)));
                                                                    if (_e1708 == 0u) {
                                                                        phi_1826_ = _e1555.unnamed_1.word;
                                                                    } else {
                                                                        phi_1826_ = _e1555.unnamed_1.shift;
                                                                    }
                                                                    let _e1747 = phi_1826_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1836_ = _e1624.unnamed_1.word;
                                                                    } else {
                                                                        phi_1836_ = _e1624.unnamed_1.shift;
                                                                    }
                                                                    let _e1756 = phi_1836_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1846_ = _e1693.unnamed_1.word;
                                                                    } else {
                                                                        phi_1846_ = _e1693.unnamed_1.shift;
                                                                    }
                                                                    let _e1765 = phi_1846_;
                                                                    let _e1778 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1747 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 + _e1246)), ((f32(((_e1756 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1247)));
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(_e1778, ((f32(((_e1765 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1248)));
                                                                    if (_e1744 <= _e1779) {
                                                                        if (_e1744 <= _e123) {
                                                                            if (_e1779 >= 0f) {
                                                                                if (_e1708 == 0u) {
                                                                                    let _e1786 = nodes.member[(0u + _e1434)].links[2u];
                                                                                    phi_1882_ = _e1786;
                                                                                } else {
                                                                                    let _e1789 = nodes.member[(0u + _e1434)].links[3u];
                                                                                    phi_1882_ = _e1789;
                                                                                }
                                                                                let _e1791 = phi_1882_;
                                                                                let _e1796 = ((_e1791 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u);
                                                                                let _e1797 = (_e1796 & 31u);
                                                                                if (_e1797 >= 24u) {
                                                                                    phi_1895_ = (24u + ((_e1797 - 24u) ^ _e1296));
                                                                                } else {
                                                                                    phi_1895_ = _e1797;
                                                                                }
                                                                                let _e1803 = phi_1895_;
                                                                                phi_1900_ = (_e1705 | ((_e1796 >> bitcast<u32>(5i)) << bitcast<u32>((_e1803 & 31u))));
                                                                            } else {
                                                                                phi_1900_ = _e1705;
                                                                            }
                                                                            let _e1811 = phi_1900_;
                                                                            phi_1901_ = _e1811;
                                                                        } else {
                                                                            phi_1901_ = _e1705;
                                                                        }
                                                                        let _e1813 = phi_1901_;
                                                                        phi_1902_ = _e1813;
                                                                    } else {
                                                                        phi_1902_ = _e1705;
                                                                    }
                                                                    let _e1815 = phi_1902_;
                                                                    phi_1772_ = (_e1703 + 1u);
                                                                    phi_1775_ = _e1815;
                                                                } else {
                                                                    phi_1772_ = u32();
                                                                    phi_1775_ = u32();
                                                                }
                                                                let _e1818 = phi_1772_;
                                                                let _e1820 = phi_1775_;
                                                                continue;
                                                                continuing {
                                                                    phi_1771_ = _e1818;
                                                                    phi_1774_ = _e1820;
                                                                    break if !(_e1706);
                                                                }
                                                            }
                                                            let _e1824 = nodes.member[(0u + _e1434)].links[0u];
                                                            let _e1828 = nodes.member[(0u + _e1434)].frame[3u];
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
                                                                local.group = (_e1062 + _e1824);
                                                                let _e1864 = local_6;
                                                                local.group_mask = ((_e1864 & 4278190080u) | (_e1828 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1869 = local_7;
                                                            phi_1960_ = (_e1869 & 16777215u);
                                                            phi_1963_ = _e1436;
                                                            loop {
                                                                let _e1872 = phi_1960_;
                                                                let _e1874 = phi_1963_;
                                                                local_12 = _e1874;
                                                                let _e1875 = (_e1872 == 0u);
                                                                local_8 = _e1875;
                                                                local_13 = _e1875;
                                                                if _e1875 {
                                                                    phi_1961_ = u32();
                                                                    phi_1964_ = bool();
                                                                    phi_2561_ = false;
                                                                } else {
                                                                    let _e1878 = nodes.member[(0u + _e1434)].links[1u];
                                                                    let _e1883 = ((_e1064 + _e1878) + select(firstTrailingBit(_e1872), 32u, (_e1872 == 0u)));
                                                                    if (_e1883 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1890 = triangles.member[(0u + _e1883)].v0_;
                                                                    let _e1892 = (_e1890.x - _e993);
                                                                    let _e1894 = (_e1890.y - _e1006);
                                                                    let _e1896 = (_e1890.z - _e1019);
                                                                    if (_e1269 == 0u) {
                                                                        phi_2008_ = vec3<f32>(_e1894, _e1896, _e1892);
                                                                    } else {
                                                                        if (_e1269 == 1u) {
                                                                            phi_2007_ = vec3<f32>(_e1896, _e1892, _e1894);
                                                                        } else {
                                                                            phi_2007_ = (_e1890 - vec3<f32>(_e993, _e1006, _e1019));
                                                                        }
                                                                        let _e1904 = phi_2007_;
                                                                        phi_2008_ = _e1904;
                                                                    }
                                                                    let _e1906 = phi_2008_;
                                                                    let _e1910 = (_e1906.x - (_e1280 * _e1906.z));
                                                                    let _e1914 = (_e1906.y - (_e1283 * _e1906.z));
                                                                    let _e1916 = triangles.member[(0u + _e1883)].v1_;
                                                                    let _e1918 = (_e1916.x - _e993);
                                                                    let _e1920 = (_e1916.y - _e1006);
                                                                    let _e1922 = (_e1916.z - _e1019);
                                                                    if (_e1269 == 0u) {
                                                                        phi_2038_ = vec3<f32>(_e1920, _e1922, _e1918);
                                                                    } else {
                                                                        if (_e1269 == 1u) {
                                                                            phi_2037_ = vec3<f32>(_e1922, _e1918, _e1920);
                                                                        } else {
                                                                            phi_2037_ = (_e1916 - vec3<f32>(_e993, _e1006, _e1019));
                                                                        }
                                                                        let _e1930 = phi_2037_;
                                                                        phi_2038_ = _e1930;
                                                                    }
                                                                    let _e1932 = phi_2038_;
                                                                    let _e1936 = (_e1932.x - (_e1280 * _e1932.z));
                                                                    let _e1940 = (_e1932.y - (_e1283 * _e1932.z));
                                                                    let _e1942 = triangles.member[(0u + _e1883)].v2_;
                                                                    let _e1944 = (_e1942.x - _e993);
                                                                    let _e1946 = (_e1942.y - _e1006);
                                                                    let _e1948 = (_e1942.z - _e1019);
                                                                    if (_e1269 == 0u) {
                                                                        phi_2068_ = vec3<f32>(_e1946, _e1948, _e1944);
                                                                    } else {
                                                                        if (_e1269 == 1u) {
                                                                            phi_2067_ = vec3<f32>(_e1948, _e1944, _e1946);
                                                                        } else {
                                                                            phi_2067_ = (_e1942 - vec3<f32>(_e993, _e1006, _e1019));
                                                                        }
                                                                        let _e1956 = phi_2067_;
                                                                        phi_2068_ = _e1956;
                                                                    }
                                                                    let _e1958 = phi_2068_;
                                                                    let _e1962 = (_e1958.x - (_e1280 * _e1958.z));
                                                                    let _e1966 = (_e1958.y - (_e1283 * _e1958.z));
                                                                    if (_e1936 < _e1962) {
                                                                        phi_2087_ = true;
                                                                    } else {
                                                                        if (_e1936 == _e1962) {
                                                                            phi_2086_ = (_e1940 < _e1966);
                                                                        } else {
                                                                            phi_2086_ = false;
                                                                        }
                                                                        let _e1971 = phi_2086_;
                                                                        phi_2087_ = _e1971;
                                                                    }
                                                                    let _e1973 = phi_2087_;
                                                                    if _e1973 {
                                                                        phi_2091_ = _e1966;
                                                                        phi_2092_ = _e1962;
                                                                        phi_2093_ = _e1940;
                                                                        phi_2094_ = _e1936;
                                                                    } else {
                                                                        phi_2091_ = _e1940;
                                                                        phi_2092_ = _e1936;
                                                                        phi_2093_ = _e1966;
                                                                        phi_2094_ = _e1962;
                                                                    }
                                                                    let _e1975 = phi_2091_;
                                                                    let _e1977 = phi_2092_;
                                                                    let _e1979 = phi_2093_;
                                                                    let _e1981 = phi_2094_;
                                                                    let _e1984 = ((_e1981 * _e1975) - (_e1979 * _e1977));
                                                                    if _e1973 {
                                                                        phi_2102_ = -(_e1984);
                                                                    } else {
                                                                        phi_2102_ = _e1984;
                                                                    }
                                                                    let _e1987 = phi_2102_;
                                                                    if (_e1962 < _e1910) {
                                                                        phi_2113_ = true;
                                                                    } else {
                                                                        if (_e1962 == _e1910) {
                                                                            phi_2112_ = (_e1966 < _e1914);
                                                                        } else {
                                                                            phi_2112_ = false;
                                                                        }
                                                                        let _e1992 = phi_2112_;
                                                                        phi_2113_ = _e1992;
                                                                    }
                                                                    let _e1994 = phi_2113_;
                                                                    if _e1994 {
                                                                        phi_2117_ = _e1914;
                                                                        phi_2118_ = _e1910;
                                                                        phi_2119_ = _e1966;
                                                                        phi_2120_ = _e1962;
                                                                    } else {
                                                                        phi_2117_ = _e1966;
                                                                        phi_2118_ = _e1962;
                                                                        phi_2119_ = _e1914;
                                                                        phi_2120_ = _e1910;
                                                                    }
                                                                    let _e1996 = phi_2117_;
                                                                    let _e1998 = phi_2118_;
                                                                    let _e2000 = phi_2119_;
                                                                    let _e2002 = phi_2120_;
                                                                    let _e2005 = ((_e2002 * _e1996) - (_e2000 * _e1998));
                                                                    if _e1994 {
                                                                        phi_2128_ = -(_e2005);
                                                                    } else {
                                                                        phi_2128_ = _e2005;
                                                                    }
                                                                    let _e2008 = phi_2128_;
                                                                    if (_e1910 < _e1936) {
                                                                        phi_2139_ = true;
                                                                    } else {
                                                                        if (_e1910 == _e1936) {
                                                                            phi_2138_ = (_e1914 < _e1940);
                                                                        } else {
                                                                            phi_2138_ = false;
                                                                        }
                                                                        let _e2013 = phi_2138_;
                                                                        phi_2139_ = _e2013;
                                                                    }
                                                                    let _e2015 = phi_2139_;
                                                                    if _e2015 {
                                                                        phi_2143_ = _e1940;
                                                                        phi_2144_ = _e1936;
                                                                        phi_2145_ = _e1914;
                                                                        phi_2146_ = _e1910;
                                                                    } else {
                                                                        phi_2143_ = _e1914;
                                                                        phi_2144_ = _e1910;
                                                                        phi_2145_ = _e1940;
                                                                        phi_2146_ = _e1936;
                                                                    }
                                                                    let _e2017 = phi_2143_;
                                                                    let _e2019 = phi_2144_;
                                                                    let _e2021 = phi_2145_;
                                                                    let _e2023 = phi_2146_;
                                                                    let _e2026 = ((_e2023 * _e2017) - (_e2021 * _e2019));
                                                                    if _e2015 {
                                                                        phi_2154_ = -(_e2026);
                                                                    } else {
                                                                        phi_2154_ = _e2026;
                                                                    }
                                                                    let _e2029 = phi_2154_;
                                                                    if (_e1987 >= 0f) {
                                                                        if (_e2008 >= 0f) {
                                                                            if (_e2029 >= 0f) {
                                                                                phi_2169_ = ((_e1987 + _e2008) + _e2029);
                                                                                phi_2170_ = false;
                                                                            } else {
                                                                                phi_2169_ = f32();
                                                                                phi_2170_ = true;
                                                                            }
                                                                            let _e2036 = phi_2169_;
                                                                            let _e2038 = phi_2170_;
                                                                            phi_2171_ = _e2036;
                                                                            phi_2172_ = _e2038;
                                                                        } else {
                                                                            phi_2171_ = f32();
                                                                            phi_2172_ = true;
                                                                        }
                                                                        let _e2040 = phi_2171_;
                                                                        let _e2042 = phi_2172_;
                                                                        phi_2173_ = _e2040;
                                                                        phi_2174_ = _e2042;
                                                                    } else {
                                                                        phi_2173_ = f32();
                                                                        phi_2174_ = true;
                                                                    }
                                                                    let _e2044 = phi_2173_;
                                                                    let _e2046 = phi_2174_;
                                                                    if _e2046 {
                                                                        if (_e1987 <= 0f) {
                                                                            if (_e2008 <= 0f) {
                                                                                let _e2049 = (_e2029 <= 0f);
                                                                                if _e2049 {
                                                                                }
                                                                                phi_2192_ = ((_e1987 + _e2008) + _e2029);
                                                                                phi_2193_ = false;
                                                                                phi_2194_ = _e2049;
                                                                            } else {
                                                                                phi_2192_ = f32();
                                                                                phi_2193_ = true;
                                                                                phi_2194_ = false;
                                                                            }
                                                                            let _e2053 = phi_2192_;
                                                                            let _e2055 = phi_2193_;
                                                                            let _e2057 = phi_2194_;
                                                                            phi_2195_ = _e2053;
                                                                            phi_2196_ = _e2055;
                                                                            phi_2197_ = _e2057;
                                                                        } else {
                                                                            phi_2195_ = f32();
                                                                            phi_2196_ = true;
                                                                            phi_2197_ = false;
                                                                        }
                                                                        let _e2059 = phi_2195_;
                                                                        let _e2061 = phi_2196_;
                                                                        let _e2063 = phi_2197_;
                                                                        if _e2061 {
                                                                            phi_2201_ = false;
                                                                        } else {
                                                                            phi_2201_ = _e2063;
                                                                        }
                                                                        let _e2065 = phi_2201_;
                                                                        phi_2202_ = _e2059;
                                                                        phi_2203_ = _e2065;
                                                                    } else {
                                                                        phi_2202_ = _e2044;
                                                                        phi_2203_ = true;
                                                                    }
                                                                    let _e2067 = phi_2202_;
                                                                    let _e2069 = phi_2203_;
                                                                    if _e2069 {
                                                                        let _e2070 = (_e2067 == 0f);
                                                                        if _e2070 {
                                                                            phi_2519_ = lt_bvh_triangle_Intersection();
                                                                            phi_2520_ = false;
                                                                        } else {
                                                                            let _e2072 = triangles.member[(0u + _e1883)].v0_;
                                                                            let _e2074 = (_e2072.x - _e993);
                                                                            let _e2076 = (_e2072.y - _e1006);
                                                                            let _e2078 = (_e2072.z - _e1019);
                                                                            if (_e1269 == 0u) {
                                                                                phi_2232_ = vec3<f32>(_e2076, _e2078, _e2074);
                                                                            } else {
                                                                                if (_e1269 == 1u) {
                                                                                    phi_2231_ = vec3<f32>(_e2078, _e2074, _e2076);
                                                                                } else {
                                                                                    phi_2231_ = (_e2072 - vec3<f32>(_e993, _e1006, _e1019));
                                                                                }
                                                                                let _e2086 = phi_2231_;
                                                                                phi_2232_ = _e2086;
                                                                            }
                                                                            let _e2088 = phi_2232_;
                                                                            let _e2090 = triangles.member[(0u + _e1883)].v1_;
                                                                            let _e2092 = triangles.member[(0u + _e1883)].v0_;
                                                                            let _e2095 = (_e2090.x - _e2092.x);
                                                                            let _e2098 = (_e2090.y - _e2092.y);
                                                                            let _e2101 = (_e2090.z - _e2092.z);
                                                                            if (_e1269 == 0u) {
                                                                                phi_2258_ = vec3<f32>(_e2098, _e2101, _e2095);
                                                                            } else {
                                                                                if (_e1269 == 1u) {
                                                                                    phi_2257_ = vec3<f32>(_e2101, _e2095, _e2098);
                                                                                } else {
                                                                                    phi_2257_ = (_e2090 - _e2092);
                                                                                }
                                                                                let _e2108 = phi_2257_;
                                                                                phi_2258_ = _e2108;
                                                                            }
                                                                            let _e2110 = phi_2258_;
                                                                            let _e2112 = triangles.member[(0u + _e1883)].v2_;
                                                                            let _e2114 = triangles.member[(0u + _e1883)].v0_;
                                                                            let _e2117 = (_e2112.x - _e2114.x);
                                                                            let _e2120 = (_e2112.y - _e2114.y);
                                                                            let _e2123 = (_e2112.z - _e2114.z);
                                                                            if (_e1269 == 0u) {
                                                                                phi_2284_ = vec3<f32>(_e2120, _e2123, _e2117);
                                                                            } else {
                                                                                if (_e1269 == 1u) {
                                                                                    phi_2283_ = vec3<f32>(_e2123, _e2117, _e2120);
                                                                                } else {
                                                                                    phi_2283_ = (_e2112 - _e2114);
                                                                                }
                                                                                let _e2130 = phi_2283_;
                                                                                phi_2284_ = _e2130;
                                                                            }
                                                                            let _e2132 = phi_2284_;
                                                                            let _e2139 = ((_e2110.y * _e2132.z) - (_e2110.z * _e2132.y));
                                                                            let _e2146 = ((_e2110.z * _e2132.x) - (_e2110.x * _e2132.z));
                                                                            let _e2153 = ((_e2110.x * _e2132.y) - (_e2110.y * _e2132.x));
                                                                            let _e2167 = (((1f / _e1277.z) * (((_e2139 * _e2088.x) + (_e2146 * _e2088.y)) + (_e2153 * _e2088.z))) / (((_e2139 * _e1280) + (_e2146 * _e1283)) + _e2153));
                                                                            if (_e2167 > 0f) {
                                                                                if (_e2167 < _e123) {
                                                                                    let _e2171 = triangles.member[(0u + _e1883)].v0_;
                                                                                    let _e2173 = triangles.member[(0u + _e1883)].v1_;
                                                                                    if (_e2171.x < _e2173.x) {
                                                                                        phi_2340_ = _e2171.x;
                                                                                    } else {
                                                                                        phi_2340_ = _e2173.x;
                                                                                    }
                                                                                    let _e2180 = phi_2340_;
                                                                                    if (_e2171.y < _e2173.y) {
                                                                                        phi_2349_ = _e2171.y;
                                                                                    } else {
                                                                                        phi_2349_ = _e2173.y;
                                                                                    }
                                                                                    let _e2187 = phi_2349_;
                                                                                    if (_e2171.z < _e2173.z) {
                                                                                        phi_2358_ = _e2171.z;
                                                                                    } else {
                                                                                        phi_2358_ = _e2173.z;
                                                                                    }
                                                                                    let _e2194 = phi_2358_;
                                                                                    let _e2196 = triangles.member[(0u + _e1883)].v2_;
                                                                                    if (_e2180 < _e2196.x) {
                                                                                        phi_2367_ = _e2180;
                                                                                    } else {
                                                                                        phi_2367_ = _e2196.x;
                                                                                    }
                                                                                    let _e2201 = phi_2367_;
                                                                                    if (_e2187 < _e2196.y) {
                                                                                        phi_2374_ = _e2187;
                                                                                    } else {
                                                                                        phi_2374_ = _e2196.y;
                                                                                    }
                                                                                    let _e2206 = phi_2374_;
                                                                                    if (_e2194 < _e2196.z) {
                                                                                        phi_2381_ = _e2194;
                                                                                    } else {
                                                                                        phi_2381_ = _e2196.z;
                                                                                    }
                                                                                    let _e2211 = phi_2381_;
                                                                                    let _e2213 = triangles.member[(0u + _e1883)].v0_;
                                                                                    let _e2215 = triangles.member[(0u + _e1883)].v1_;
                                                                                    if (_e2213.x > _e2215.x) {
                                                                                        phi_2394_ = _e2213.x;
                                                                                    } else {
                                                                                        phi_2394_ = _e2215.x;
                                                                                    }
                                                                                    let _e2222 = phi_2394_;
                                                                                    if (_e2213.y > _e2215.y) {
                                                                                        phi_2403_ = _e2213.y;
                                                                                    } else {
                                                                                        phi_2403_ = _e2215.y;
                                                                                    }
                                                                                    let _e2229 = phi_2403_;
                                                                                    if (_e2213.z > _e2215.z) {
                                                                                        phi_2412_ = _e2213.z;
                                                                                    } else {
                                                                                        phi_2412_ = _e2215.z;
                                                                                    }
                                                                                    let _e2236 = phi_2412_;
                                                                                    let _e2238 = triangles.member[(0u + _e1883)].v2_;
                                                                                    if (_e2222 > _e2238.x) {
                                                                                        phi_2421_ = _e2222;
                                                                                    } else {
                                                                                        phi_2421_ = _e2238.x;
                                                                                    }
                                                                                    let _e2243 = phi_2421_;
                                                                                    if (_e2229 > _e2238.y) {
                                                                                        phi_2428_ = _e2229;
                                                                                    } else {
                                                                                        phi_2428_ = _e2238.y;
                                                                                    }
                                                                                    let _e2248 = phi_2428_;
                                                                                    if (_e2236 > _e2238.z) {
                                                                                        phi_2435_ = _e2236;
                                                                                    } else {
                                                                                        phi_2435_ = _e2238.z;
                                                                                    }
                                                                                    let _e2253 = phi_2435_;
                                                                                    let _e2257 = ((_e2201 - _e993) * _e1194);
                                                                                    let _e2258 = ((_e2206 - _e1006) * _e1204);
                                                                                    let _e2259 = ((_e2211 - _e1019) * _e1214);
                                                                                    let _e2263 = ((_e2243 - _e993) * _e1194);
                                                                                    let _e2264 = ((_e2248 - _e1006) * _e1204);
                                                                                    let _e2265 = ((_e2253 - _e1019) * _e1214);
                                                                                    if (_e2257 < _e2263) {
                                                                                        phi_2452_ = _e2257;
                                                                                    } else {
                                                                                        phi_2452_ = _e2263;
                                                                                    }
                                                                                    let _e2268 = phi_2452_;
                                                                                    if (_e2258 < _e2264) {
                                                                                        phi_2457_ = _e2258;
                                                                                    } else {
                                                                                        phi_2457_ = _e2264;
                                                                                    }
                                                                                    let _e2271 = phi_2457_;
                                                                                    if (_e2259 < _e2265) {
                                                                                        phi_2462_ = _e2259;
                                                                                    } else {
                                                                                        phi_2462_ = _e2265;
                                                                                    }
                                                                                    let _e2274 = phi_2462_;
                                                                                    if (_e2257 > _e2263) {
                                                                                        phi_2470_ = _e2257;
                                                                                    } else {
                                                                                        phi_2470_ = _e2263;
                                                                                    }
                                                                                    let _e2280 = phi_2470_;
                                                                                    if (_e2258 > _e2264) {
                                                                                        phi_2475_ = _e2258;
                                                                                    } else {
                                                                                        phi_2475_ = _e2264;
                                                                                    }
                                                                                    let _e2283 = phi_2475_;
                                                                                    if (_e2259 > _e2265) {
                                                                                        phi_2480_ = _e2259;
                                                                                    } else {
                                                                                        phi_2480_ = _e2265;
                                                                                    }
                                                                                    let _e2286 = phi_2480_;
                                                                                    let _e2290 = core_intrinsics_maximum_number_nsz_f32_((_e2268 - _e1253), (_e2271 - _e1254));
                                                                                    let _e2291 = core_intrinsics_maximum_number_nsz_f32_(_e2290, (_e2274 - _e1255));
                                                                                    let _e2292 = core_intrinsics_minimum_number_nsz_f32_((_e2280 + _e1253), (_e2283 + _e1254));
                                                                                    let _e2293 = core_intrinsics_minimum_number_nsz_f32_(_e2292, (_e2286 + _e1255));
                                                                                    if (_e2291 > _e974) {
                                                                                        phi_2492_ = _e2291;
                                                                                    } else {
                                                                                        phi_2492_ = _e974;
                                                                                    }
                                                                                    let _e2296 = phi_2492_;
                                                                                    if (_e2293 < _e976) {
                                                                                        phi_2497_ = _e2293;
                                                                                    } else {
                                                                                        phi_2497_ = _e976;
                                                                                    }
                                                                                    let _e2299 = phi_2497_;
                                                                                    if (_e2167 < _e2296) {
                                                                                        phi_2502_ = _e2296;
                                                                                    } else {
                                                                                        phi_2502_ = _e2167;
                                                                                    }
                                                                                    let _e2302 = phi_2502_;
                                                                                    if (_e2302 > _e2299) {
                                                                                        phi_2507_ = _e2299;
                                                                                    } else {
                                                                                        phi_2507_ = _e2302;
                                                                                    }
                                                                                    let _e2305 = phi_2507_;
                                                                                    phi_2512_ = lt_bvh_triangle_Intersection(_e2305, (_e2008 / _e2067), (_e2029 / _e2067), (_e2296 <= _e2299));
                                                                                    phi_2513_ = false;
                                                                                } else {
                                                                                    phi_2512_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2513_ = true;
                                                                                }
                                                                                let _e2311 = phi_2512_;
                                                                                let _e2313 = phi_2513_;
                                                                                phi_2514_ = _e2311;
                                                                                phi_2515_ = _e2313;
                                                                            } else {
                                                                                phi_2514_ = lt_bvh_triangle_Intersection();
                                                                                phi_2515_ = true;
                                                                            }
                                                                            let _e2315 = phi_2514_;
                                                                            let _e2317 = phi_2515_;
                                                                            if _e2317 {
                                                                            }
                                                                            phi_2519_ = _e2315;
                                                                            phi_2520_ = _e2317;
                                                                        }
                                                                        let _e2319 = phi_2519_;
                                                                        let _e2321 = phi_2520_;
                                                                        phi_2521_ = _e2319;
                                                                        phi_2522_ = _e2070;
                                                                        phi_2523_ = _e2321;
                                                                    } else {
                                                                        phi_2521_ = lt_bvh_triangle_Intersection();
                                                                        phi_2522_ = true;
                                                                        phi_2523_ = false;
                                                                    }
                                                                    let _e2323 = phi_2521_;
                                                                    let _e2325 = phi_2522_;
                                                                    let _e2327 = phi_2523_;
                                                                    if _e2325 {
                                                                        phi_2527_ = true;
                                                                    } else {
                                                                        phi_2527_ = _e2327;
                                                                    }
                                                                    let _e2329 = phi_2527_;
                                                                    if _e2329 {
                                                                        phi_2531_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2531_ = _e2323;
                                                                    }
                                                                    let _e2331 = phi_2531_;
                                                                    if _e2331.is_hit {
                                                                        if (_e2331.t > 0f) {
                                                                            if (_e2331.t < _e123) {
                                                                                if true {
                                                                                    phi_2551_ = false;
                                                                                } else {
                                                                                    phi_2551_ = true;
                                                                                }
                                                                                let _e2340 = phi_2551_;
                                                                                phi_2552_ = true;
                                                                                phi_2553_ = _e2340;
                                                                            } else {
                                                                                phi_2552_ = _e1874;
                                                                                phi_2553_ = true;
                                                                            }
                                                                            let _e2342 = phi_2552_;
                                                                            let _e2344 = phi_2553_;
                                                                            phi_2554_ = _e2342;
                                                                            phi_2555_ = _e2344;
                                                                        } else {
                                                                            phi_2554_ = _e1874;
                                                                            phi_2555_ = true;
                                                                        }
                                                                        let _e2346 = phi_2554_;
                                                                        let _e2348 = phi_2555_;
                                                                        phi_2556_ = _e2346;
                                                                        phi_2557_ = _e2348;
                                                                    } else {
                                                                        phi_2556_ = _e1874;
                                                                        phi_2557_ = true;
                                                                    }
                                                                    let _e2350 = phi_2556_;
                                                                    let _e2352 = phi_2557_;
                                                                    if _e2352 {
                                                                    }
                                                                    phi_1961_ = (_e1872 & (_e1872 - 1u));
                                                                    phi_1964_ = _e2350;
                                                                    phi_2561_ = _e2352;
                                                                }
                                                                let _e2354 = phi_1961_;
                                                                let _e2356 = phi_1964_;
                                                                let _e2358 = phi_2561_;
                                                                continue;
                                                                continuing {
                                                                    phi_1960_ = _e2354;
                                                                    phi_1963_ = _e2356;
                                                                    break if !(_e2358);
                                                                }
                                                            }
                                                            let _e2361 = local_8;
                                                            if _e2361 {
                                                                let _e2363 = local.group_mask;
                                                                if ((_e2363 & 4278190080u) == 0u) {
                                                                    let _e2367 = local.len;
                                                                    if (_e2367 == 0u) {
                                                                        phi_2603_ = false;
                                                                    } else {
                                                                        let _e2371 = local.len;
                                                                        local.len = (_e2371 - 1u);
                                                                        let _e2374 = local.len;
                                                                        if (_e2374 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2379 = local.first[(0u + _e2374)];
                                                                        local.group = _e2379;
                                                                        let _e2382 = local.len;
                                                                        if (_e2382 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2387 = local.mask[(0u + _e2382)];
                                                                        local.group_mask = _e2387;
                                                                        phi_2603_ = true;
                                                                    }
                                                                    let _e2390 = phi_2603_;
                                                                    phi_2604_ = _e2390;
                                                                } else {
                                                                    phi_2604_ = true;
                                                                }
                                                                let _e2392 = phi_2604_;
                                                                if _e2392 {
                                                                    let _e2394 = local.group_mask;
                                                                    let _e2400 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2394)), 32u, (_e2394 == 0u)));
                                                                    let _e2404 = local.group_mask;
                                                                    let _e2418 = local.group_mask;
                                                                    local.group_mask = (_e2418 & ~((1u << bitcast<u32>((_e2400 & 31u)))));
                                                                    let _e2421 = local.group;
                                                                    phi_2635_ = (_e2421 + countOneBits(((_e2404 & ~((4294967295u << bitcast<u32>((((_e2400 - 24u) ^ _e1296) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2635_ = 4294967295u;
                                                                }
                                                                let _e2424 = phi_2635_;
                                                                phi_2636_ = _e2424;
                                                            } else {
                                                                phi_2636_ = u32();
                                                            }
                                                            let _e2426 = phi_2636_;
                                                            phi_1629_ = _e2426;
                                                            let _e2892 = local_12;
                                                            phi_1632_ = _e2892;
                                                            let _e2895 = local_13;
                                                            phi_2637_ = _e2895;
                                                            phi_2638_ = false;
                                                        } else {
                                                            phi_1629_ = u32();
                                                            phi_1632_ = bool();
                                                            phi_2637_ = false;
                                                            phi_2638_ = true;
                                                        }
                                                        let _e2428 = phi_1629_;
                                                        let _e2430 = phi_1632_;
                                                        let _e2432 = phi_2637_;
                                                        let _e2434 = phi_2638_;
                                                        local_9 = _e2434;
                                                        continue;
                                                        continuing {
                                                            phi_1628_ = _e2428;
                                                            phi_1631_ = _e2430;
                                                            break if !(_e2432);
                                                        }
                                                    }
                                                    let _e2437 = local_9;
                                                    if _e2437 {
                                                        phi_2642_ = false;
                                                    } else {
                                                        phi_2642_ = true;
                                                    }
                                                    let _e2439 = phi_2642_;
                                                    if _e2439 {
                                                        phi_2646_ = true;
                                                    } else {
                                                        let _e2901 = local_14;
                                                        phi_2646_ = _e2901;
                                                    }
                                                    let _e2441 = phi_2646_;
                                                    phi_2647_ = _e2441;
                                                }
                                                let _e2443 = phi_2647_;
                                                phi_2648_ = _e2443;
                                                phi_2649_ = _e1118;
                                            } else {
                                                phi_2648_ = bool();
                                                phi_2649_ = true;
                                            }
                                            let _e2445 = phi_2648_;
                                            let _e2447 = phi_2649_;
                                            if _e2447 {
                                                phi_2653_ = _e913;
                                            } else {
                                                phi_2653_ = _e2445;
                                            }
                                            let _e2449 = phi_2653_;
                                            if _e2449 {
                                                phi_2657_ = false;
                                            } else {
                                                phi_2657_ = true;
                                            }
                                            let _e2451 = phi_2657_;
                                            phi_2658_ = _e2449;
                                            phi_2659_ = _e2451;
                                        } else {
                                            phi_2658_ = _e913;
                                            phi_2659_ = true;
                                        }
                                        let _e2453 = phi_2658_;
                                        let _e2455 = phi_2659_;
                                        phi_2660_ = _e2453;
                                        phi_2661_ = _e2455;
                                    } else {
                                        phi_2660_ = _e913;
                                        phi_2661_ = true;
                                    }
                                    let _e2457 = phi_2660_;
                                    let _e2459 = phi_2661_;
                                    phi_2662_ = _e2457;
                                    phi_2663_ = _e2459;
                                } else {
                                    phi_2662_ = _e913;
                                    phi_2663_ = true;
                                }
                                let _e2461 = phi_2662_;
                                let _e2463 = phi_2663_;
                                if _e2463 {
                                }
                                phi_1014_ = (_e911 & (_e911 - 1u));
                                phi_1017_ = _e2461;
                                phi_2667_ = _e2463;
                            }
                            let _e2465 = phi_1014_;
                            let _e2467 = phi_1017_;
                            let _e2469 = phi_2667_;
                            continue;
                            continuing {
                                phi_1013_ = _e2465;
                                phi_1016_ = _e2467;
                                break if !(_e2469);
                            }
                        }
                        let _e2472 = local_10;
                        if _e2472 {
                            let _e2474 = local_1.group_mask;
                            if ((_e2474 & 4278190080u) == 0u) {
                                let _e2478 = local_1.len;
                                if (_e2478 == 0u) {
                                    phi_2709_ = false;
                                } else {
                                    let _e2482 = local_1.len;
                                    local_1.len = (_e2482 - 1u);
                                    let _e2485 = local_1.len;
                                    if (_e2485 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2490 = local_1.first[(0u + _e2485)];
                                    local_1.group = _e2490;
                                    let _e2493 = local_1.len;
                                    if (_e2493 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2498 = local_1.mask[(0u + _e2493)];
                                    local_1.group_mask = _e2498;
                                    phi_2709_ = true;
                                }
                                let _e2501 = phi_2709_;
                                phi_2710_ = _e2501;
                            } else {
                                phi_2710_ = true;
                            }
                            let _e2503 = phi_2710_;
                            if _e2503 {
                                let _e2505 = local_1.group_mask;
                                let _e2511 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2505)), 32u, (_e2505 == 0u)));
                                let _e2515 = local_1.group_mask;
                                let _e2529 = local_1.group_mask;
                                local_1.group_mask = (_e2529 & ~((1u << bitcast<u32>((_e2511 & 31u)))));
                                let _e2532 = local_1.group;
                                phi_2741_ = (_e2532 + countOneBits(((_e2515 & ~((4294967295u << bitcast<u32>((((_e2511 - 24u) ^ _e335) & 31u))))) & 255u)));
                            } else {
                                phi_2741_ = 4294967295u;
                            }
                            let _e2535 = phi_2741_;
                            phi_2742_ = _e2535;
                        } else {
                            phi_2742_ = u32();
                        }
                        let _e2537 = phi_2742_;
                        phi_682_ = _e2537;
                        let _e2924 = local_15;
                        phi_685_ = _e2924;
                        let _e2927 = local_16;
                        phi_2743_ = _e2927;
                        phi_2744_ = false;
                    } else {
                        phi_682_ = u32();
                        phi_685_ = bool();
                        phi_2743_ = false;
                        phi_2744_ = true;
                    }
                    let _e2539 = phi_682_;
                    let _e2541 = phi_685_;
                    let _e2543 = phi_2743_;
                    let _e2545 = phi_2744_;
                    local_11 = _e2545;
                    continue;
                    continuing {
                        phi_681_ = _e2539;
                        phi_684_ = _e2541;
                        break if !(_e2543);
                    }
                }
                let _e2548 = local_11;
                if _e2548 {
                    phi_2748_ = false;
                } else {
                    phi_2748_ = true;
                }
                let _e2550 = phi_2748_;
                if _e2550 {
                }
                phi_2752_ = _e2550;
            }
            let _e2552 = phi_2752_;
            phi_2753_ = _e187;
            phi_2754_ = _e2552;
        } else {
            phi_2753_ = true;
            phi_2754_ = false;
        }
        let _e2554 = phi_2753_;
        let _e2556 = phi_2754_;
        if _e2554 {
            phi_2758_ = false;
            phi_2759_ = true;
        } else {
            phi_2758_ = true;
            phi_2759_ = _e2556;
        }
        let _e2558 = phi_2758_;
        let _e2560 = phi_2759_;
        if _e2560 {
            phi_2763_ = _e2558;
        } else {
            phi_2763_ = false;
        }
        let _e2562 = phi_2763_;
        if _e2562 {
            phi_2767_ = 0f;
        } else {
            phi_2767_ = 1f;
        }
        let _e2564 = phi_2767_;
        if (_e91 < _e69) {
        } else {
            return;
        }
        visibility.member[(0u + _e91)] = _e2564;
        let _e2570 = p.member.light.number;
        let _e2571 = (_e2570 * 3u);
        let _e2572 = (_e2571 / 32u);
        let _e2573 = (_e2571 % 32u);
        let _e2575 = p.member.light.mask_words;
        if (_e91 < _e69) {
        } else {
            return;
        }
        let _e2579 = visibility.member[(0u + _e91)];
        let _e2581 = ((_e91 * _e2575) + _e2572);
        if (_e2573 > 29u) {
            let _e2583 = (_e2581 + 1u);
            if (_e2583 < _e75) {
            } else {
                return;
            }
            let _e2587 = bits.member[(0u + _e2583)];
            phi_2808_ = _e2587;
        } else {
            phi_2808_ = 0u;
        }
        let _e2589 = phi_2808_;
        if (_e2581 < _e75) {
        } else {
            return;
        }
        let _e2593 = bits.member[(0u + _e2581)];
        let _e2596 = (_e2593 >> bitcast<u32>((_e2573 & 31u)));
        if (_e2573 > 29u) {
            phi_2827_ = (_e2596 | (_e2589 << bitcast<u32>(((32u - _e2573) & 31u))));
        } else {
            phi_2827_ = _e2596;
        }
        let _e2604 = phi_2827_;
        if ((_e2604 & 2u) == 0u) {
            phi_2835_ = (_e2604 & 1u);
        } else {
            phi_2835_ = (_e2604 & 7u);
        }
        let _e2610 = phi_2835_;
        if ((_e2610 & 1u) != 0u) {
            phi_2843_ = (2u | 1u);
        } else {
            phi_2843_ = 2u;
        }
        let _e2616 = phi_2843_;
        if (_e2579 < 0.5f) {
            phi_2848_ = (_e2616 | 4u);
        } else {
            phi_2848_ = _e2616;
        }
        let _e2619 = phi_2848_;
        let _e2621 = ((_e91 * _e2575) + _e2572);
        if (_e2621 < _e75) {
        } else {
            return;
        }
        let _e2625 = bits.member[(0u + _e2621)];
        if (_e2621 < _e75) {
        } else {
            return;
        }
        bits.member[(0u + _e2621)] = ((_e2625 & ~((7u << bitcast<u32>((_e2573 & 31u))))) | (_e2619 << bitcast<u32>((_e2573 & 31u))));
        if (_e2573 > 29u) {
            let _e2639 = (_e2621 + 1u);
            if (_e2639 < _e75) {
            } else {
                return;
            }
            let _e2643 = bits.member[(0u + _e2639)];
            let _e2644 = (32u - _e2573);
            let _e2654 = (_e2621 + 1u);
            if (_e2654 < _e75) {
            } else {
                return;
            }
            bits.member[(0u + _e2654)] = ((_e2643 & ~((7u >> bitcast<u32>((_e2644 & 31u))))) | (_e2619 >> bitcast<u32>((_e2644 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
