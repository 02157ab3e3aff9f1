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
    var phi_164_: bool;
    var phi_168_: f32;

    if (param != param) {
        phi_164_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_164_ = _e54;
    }
    let _e56 = phi_164_;
    if _e56 {
        phi_168_ = param_1;
    } else {
        phi_168_ = param;
    }
    let _e58 = phi_168_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_180_: bool;
    var phi_184_: f32;

    if (param_2 != param_2) {
        phi_180_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_180_ = _e54;
    }
    let _e56 = phi_180_;
    if _e56 {
        phi_184_ = param_3;
    } else {
        phi_184_ = param_2;
    }
    let _e58 = phi_184_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_267_: f32;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_326_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_353_: bool;
    var phi_423_: f32;
    var phi_430_: f32;
    var phi_437_: f32;
    var phi_444_: f32;
    var phi_451_: f32;
    var phi_458_: f32;
    var phi_475_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_514_: u32;
    var phi_519_: u32;
    var phi_524_: u32;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_670_: u32;
    var phi_672_: u32;
    var phi_675_: bool;
    var phi_755_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_782_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_809_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_815_: u32;
    var phi_818_: u32;
    var phi_832_: u32;
    var phi_842_: u32;
    var phi_852_: u32;
    var phi_870_: u32;
    var phi_880_: u32;
    var phi_890_: u32;
    var phi_926_: u32;
    var phi_939_: u32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_946_: u32;
    var phi_816_: u32;
    var phi_819_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1004_: u32;
    var phi_1007_: bool;
    var phi_1056_: f32;
    var phi_1061_: f32;
    var phi_1066_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1084_: f32;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1211_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1231_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1258_: bool;
    var phi_1328_: f32;
    var phi_1335_: f32;
    var phi_1342_: f32;
    var phi_1349_: f32;
    var phi_1356_: f32;
    var phi_1363_: f32;
    var phi_1380_: f32;
    var phi_1385_: f32;
    var phi_1390_: f32;
    var phi_1395_: f32;
    var phi_1400_: f32;
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
    var phi_1622_: bool;
    var phi_1702_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1729_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1756_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1762_: u32;
    var phi_1765_: u32;
    var phi_1779_: u32;
    var phi_1789_: u32;
    var phi_1799_: u32;
    var phi_1817_: u32;
    var phi_1827_: u32;
    var phi_1837_: u32;
    var phi_1873_: u32;
    var phi_1886_: u32;
    var phi_1891_: u32;
    var phi_1892_: u32;
    var phi_1893_: u32;
    var phi_1763_: u32;
    var phi_1766_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1951_: u32;
    var phi_1954_: bool;
    var phi_1998_: vec3<f32>;
    var phi_1999_: vec3<f32>;
    var phi_2028_: vec3<f32>;
    var phi_2029_: vec3<f32>;
    var phi_2058_: vec3<f32>;
    var phi_2059_: vec3<f32>;
    var phi_2077_: bool;
    var phi_2078_: bool;
    var phi_2082_: f32;
    var phi_2083_: f32;
    var phi_2084_: f32;
    var phi_2085_: f32;
    var phi_2093_: f32;
    var phi_2103_: bool;
    var phi_2104_: bool;
    var phi_2108_: f32;
    var phi_2109_: f32;
    var phi_2110_: f32;
    var phi_2111_: f32;
    var phi_2119_: f32;
    var phi_2129_: bool;
    var phi_2130_: bool;
    var phi_2134_: f32;
    var phi_2135_: f32;
    var phi_2136_: f32;
    var phi_2137_: f32;
    var phi_2145_: f32;
    var phi_2160_: f32;
    var phi_2161_: bool;
    var phi_2162_: f32;
    var phi_2163_: bool;
    var phi_2164_: f32;
    var phi_2165_: bool;
    var phi_2183_: f32;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2186_: f32;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2192_: bool;
    var phi_2193_: f32;
    var phi_2194_: bool;
    var phi_2222_: vec3<f32>;
    var phi_2223_: vec3<f32>;
    var phi_2248_: vec3<f32>;
    var phi_2249_: vec3<f32>;
    var phi_2274_: vec3<f32>;
    var phi_2275_: vec3<f32>;
    var phi_2331_: f32;
    var phi_2340_: f32;
    var phi_2349_: f32;
    var phi_2358_: f32;
    var phi_2365_: f32;
    var phi_2372_: f32;
    var phi_2385_: f32;
    var phi_2394_: f32;
    var phi_2403_: f32;
    var phi_2412_: f32;
    var phi_2419_: f32;
    var phi_2426_: f32;
    var phi_2443_: f32;
    var phi_2448_: f32;
    var phi_2453_: f32;
    var phi_2461_: f32;
    var phi_2466_: f32;
    var phi_2471_: f32;
    var phi_2483_: f32;
    var phi_2488_: f32;
    var phi_2493_: f32;
    var phi_2498_: f32;
    var phi_2503_: lt_bvh_triangle_Intersection;
    var phi_2504_: bool;
    var phi_2505_: lt_bvh_triangle_Intersection;
    var phi_2506_: bool;
    var phi_2510_: lt_bvh_triangle_Intersection;
    var phi_2511_: bool;
    var phi_2512_: lt_bvh_triangle_Intersection;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2518_: bool;
    var phi_2522_: lt_bvh_triangle_Intersection;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_1952_: u32;
    var phi_1955_: bool;
    var phi_2552_: bool;
    var local_8: bool;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2626_: u32;
    var phi_2627_: u32;
    var phi_1620_: u32;
    var phi_1623_: bool;
    var phi_2628_: bool;
    var phi_2629_: bool;
    var local_9: bool;
    var phi_2633_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2644_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_1005_: u32;
    var phi_1008_: bool;
    var phi_2658_: bool;
    var local_10: bool;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2732_: u32;
    var phi_2733_: u32;
    var phi_673_: u32;
    var phi_676_: bool;
    var phi_2734_: bool;
    var phi_2735_: bool;
    var local_11: bool;
    var phi_2739_: bool;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2749_: bool;
    var phi_2750_: bool;
    var phi_2754_: bool;
    var phi_2758_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

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
        let _e93 = samples.member[(0u + _e85)].position;
        let _e95 = samples.member[(0u + _e85)].normal;
        let _e97 = samples.member[(0u + _e85)].magnitude;
        let _e99 = ((8f / 8388608f) * _e97);
        let _e107 = (_e93.x + (_e95.x * _e99));
        let _e109 = (_e93.y + (_e95.y * _e99));
        let _e111 = (_e93.z + (_e95.z * _e99));
        let _e113 = p.member.light.place;
        if (_e113.w == 0f) {
            phi_267_ = 300000000000000000000000000000000000000f;
        } else {
            phi_267_ = 1f;
        }
        let _e117 = phi_267_;
        let _e125 = (_e113.x - (_e107 * _e113.w));
        let _e126 = (_e113.y - (_e109 * _e113.w));
        let _e127 = (_e113.z - (_e111 * _e113.w));
        let _e128 = abs(_e125);
        let _e129 = abs(_e126);
        let _e130 = abs(_e127);
        if (abs(_e107) < 1000000000000000f) {
            if (abs(_e109) < 1000000000000000f) {
                phi_299_ = (abs(_e111) < 1000000000000000f);
                phi_300_ = false;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
            }
            let _e138 = phi_299_;
            let _e140 = phi_300_;
            phi_301_ = _e138;
            phi_302_ = _e140;
        } else {
            phi_301_ = bool();
            phi_302_ = true;
        }
        let _e142 = phi_301_;
        let _e144 = phi_302_;
        if _e144 {
            phi_306_ = false;
        } else {
            phi_306_ = _e142;
        }
        let _e146 = phi_306_;
        if _e146 {
            if (_e128 < 1000000000000000f) {
                if (_e129 < 1000000000000000f) {
                    phi_319_ = (_e130 < 1000000000000000f);
                    phi_320_ = false;
                } else {
                    phi_319_ = bool();
                    phi_320_ = true;
                }
                let _e151 = phi_319_;
                let _e153 = phi_320_;
                phi_321_ = _e151;
                phi_322_ = _e153;
            } else {
                phi_321_ = bool();
                phi_322_ = true;
            }
            let _e155 = phi_321_;
            let _e157 = phi_322_;
            if _e157 {
                phi_326_ = false;
            } else {
                phi_326_ = _e155;
            }
            let _e159 = phi_326_;
            if _e159 {
                if (_e128 > 0f) {
                    phi_340_ = bool();
                    phi_341_ = true;
                } else {
                    let _e161 = (_e129 > 0f);
                    if _e161 {
                        phi_339_ = bool();
                    } else {
                        phi_339_ = (_e130 > 0f);
                    }
                    let _e164 = phi_339_;
                    phi_340_ = _e164;
                    phi_341_ = _e161;
                }
                let _e166 = phi_340_;
                let _e168 = phi_341_;
                if _e168 {
                    phi_345_ = true;
                } else {
                    phi_345_ = _e166;
                }
                let _e170 = phi_345_;
                phi_346_ = _e170;
                phi_347_ = false;
            } else {
                phi_346_ = bool();
                phi_347_ = true;
            }
            let _e172 = phi_346_;
            let _e174 = phi_347_;
            phi_348_ = _e172;
            phi_349_ = _e174;
        } else {
            phi_348_ = bool();
            phi_349_ = true;
        }
        let _e176 = phi_348_;
        let _e178 = phi_349_;
        if _e178 {
            phi_353_ = false;
        } else {
            phi_353_ = _e176;
        }
        let _e180 = phi_353_;
        if _e180 {
            let _e181 = (_e87 >= _e60);
            if _e181 {
                phi_2743_ = false;
            } else {
                if (_e87 < _e60) {
                } else {
                    return;
                }
                let _e187 = nodes.member[(0u + _e87)].frame[0u];
                let _e191 = nodes.member[(0u + _e87)].frame[1u];
                let _e195 = nodes.member[(0u + _e87)].frame[2u];
                let _e199 = nodes.member[(0u + _e87)].frame[0u];
                let _e203 = nodes.member[(0u + _e87)].frame[1u];
                let _e207 = nodes.member[(0u + _e87)].frame[2u];
                let _e211 = nodes.member[(0u + _e87)].frame[3u];
                let _e245 = core_intrinsics_maximum_number_nsz_f32_(abs(_e125), abs(_e126));
                let _e246 = core_intrinsics_maximum_number_nsz_f32_(_e245, abs(_e127));
                let _e247 = (_e246 * 0.0000000000009094947f);
                if (abs(_e125) < _e247) {
                    phi_423_ = _e247;
                } else {
                    phi_423_ = abs(_e125);
                }
                let _e252 = phi_423_;
                if (_e125 < 0f) {
                    phi_430_ = (-1f / _e252);
                } else {
                    phi_430_ = (1f / _e252);
                }
                let _e257 = phi_430_;
                if (abs(_e126) < _e247) {
                    phi_437_ = _e247;
                } else {
                    phi_437_ = abs(_e126);
                }
                let _e262 = phi_437_;
                if (_e126 < 0f) {
                    phi_444_ = (-1f / _e262);
                } else {
                    phi_444_ = (1f / _e262);
                }
                let _e267 = phi_444_;
                if (abs(_e127) < _e247) {
                    phi_451_ = _e247;
                } else {
                    phi_451_ = abs(_e127);
                }
                let _e272 = phi_451_;
                if (_e127 < 0f) {
                    phi_458_ = (-1f / _e272);
                } else {
                    phi_458_ = (1f / _e272);
                }
                let _e277 = phi_458_;
                let _e281 = abs((bitcast<f32>(_e187) - _e107));
                let _e282 = abs((bitcast<f32>(_e191) - _e109));
                let _e283 = abs((bitcast<f32>(_e195) - _e111));
                let _e287 = abs(((bitcast<f32>(_e199) + (bitcast<f32>((((_e211 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e288 = abs(((bitcast<f32>(_e203) + (bitcast<f32>((((_e211 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e289 = abs(((bitcast<f32>(_e207) + (bitcast<f32>((((_e211 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                if (_e281 > _e287) {
                    phi_475_ = _e281;
                } else {
                    phi_475_ = _e287;
                }
                let _e292 = phi_475_;
                if (_e282 > _e288) {
                    phi_480_ = _e282;
                } else {
                    phi_480_ = _e288;
                }
                let _e295 = phi_480_;
                if (_e283 > _e289) {
                    phi_485_ = _e283;
                } else {
                    phi_485_ = _e289;
                }
                let _e298 = phi_485_;
                if (_e292 > _e295) {
                    phi_490_ = _e292;
                } else {
                    phi_490_ = _e295;
                }
                let _e301 = phi_490_;
                if (_e301 > _e298) {
                    phi_495_ = _e301;
                } else {
                    phi_495_ = _e298;
                }
                let _e304 = phi_495_;
                let _e308 = (_e304 * 0.0000019073486f);
                let _e309 = (abs(_e257) * _e308);
                let _e310 = (abs(_e267) * _e308);
                let _e311 = (abs(_e277) * _e308);
                let _e315 = (_e304 * 0.0000009536743f);
                let _e316 = (abs(_e257) * _e315);
                let _e317 = (abs(_e267) * _e315);
                let _e318 = (abs(_e277) * _e315);
                if (_e257 < 0f) {
                    phi_514_ = 0u;
                } else {
                    phi_514_ = 1u;
                }
                let _e321 = phi_514_;
                if (_e267 < 0f) {
                    phi_519_ = 0u;
                } else {
                    phi_519_ = 2u;
                }
                let _e324 = phi_519_;
                if (_e277 < 0f) {
                    phi_524_ = 0u;
                } else {
                    phi_524_ = 4u;
                }
                let _e327 = phi_524_;
                let _e329 = ((_e321 | _e324) | _e327);
                let _e330 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e87, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e330.first[0], _e330.first[1], _e330.first[2], _e330.first[3], _e330.first[4], _e330.first[5], _e330.first[6], _e330.first[7], _e330.first[8], _e330.first[9], _e330.first[10], _e330.first[11], _e330.first[12], _e330.first[13], _e330.first[14], _e330.first[15], _e330.first[16], _e330.first[17], _e330.first[18], _e330.first[19], _e330.first[20], _e330.first[21], _e330.first[22], _e330.first[23], _e330.first[24], _e330.first[25], _e330.first[26], _e330.first[27], _e330.first[28], _e330.first[29], _e330.first[30], _e330.first[31]), array<u32, 32>(_e330.mask[0], _e330.mask[1], _e330.mask[2], _e330.mask[3], _e330.mask[4], _e330.mask[5], _e330.mask[6], _e330.mask[7], _e330.mask[8], _e330.mask[9], _e330.mask[10], _e330.mask[11], _e330.mask[12], _e330.mask[13], _e330.mask[14], _e330.mask[15], _e330.mask[16], _e330.mask[17], _e330.mask[18], _e330.mask[19], _e330.mask[20], _e330.mask[21], _e330.mask[22], _e330.mask[23], _e330.mask[24], _e330.mask[25], _e330.mask[26], _e330.mask[27], _e330.mask[28], _e330.mask[29], _e330.mask[30], _e330.mask[31]), _e330.len, _e330.group, _e330.group_mask);
                let _e404 = local_1.group_mask;
                if ((_e404 & 4278190080u) == 0u) {
                    let _e408 = local_1.len;
                    if (_e408 == 0u) {
                        phi_638_ = false;
                    } else {
                        let _e412 = local_1.len;
                        local_1.len = (_e412 - 1u);
                        let _e415 = local_1.len;
                        if (_e415 < 32u) {
                        } else {
                            return;
                        }
                        let _e420 = local_1.first[(0u + _e415)];
                        local_1.group = _e420;
                        let _e423 = local_1.len;
                        if (_e423 < 32u) {
                        } else {
                            return;
                        }
                        let _e428 = local_1.mask[(0u + _e423)];
                        local_1.group_mask = _e428;
                        phi_638_ = true;
                    }
                    let _e431 = phi_638_;
                    phi_639_ = _e431;
                } else {
                    phi_639_ = true;
                }
                let _e433 = phi_639_;
                if _e433 {
                    let _e435 = local_1.group_mask;
                    let _e441 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e435)), 32u, (_e435 == 0u)));
                    let _e445 = local_1.group_mask;
                    let _e459 = local_1.group_mask;
                    local_1.group_mask = (_e459 & ~((1u << bitcast<u32>((_e441 & 31u)))));
                    let _e462 = local_1.group;
                    phi_670_ = (_e462 + countOneBits(((_e445 & ~((4294967295u << bitcast<u32>((((_e441 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_670_ = 4294967295u;
                }
                let _e465 = phi_670_;
                phi_672_ = _e465;
                phi_675_ = false;
                loop {
                    let _e467 = phi_672_;
                    let _e469 = phi_675_;
                    if (_e467 != 4294967295u) {
                        if (_e467 < _e60) {
                        } else {
                            return;
                        }
                        let _e476 = nodes.member[(0u + _e467)].frame[3u];
                        let _e501 = (bitcast<f32>((((_e476 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e257);
                        let _e502 = (bitcast<f32>((((_e476 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e267);
                        let _e503 = (bitcast<f32>((((_e476 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e277);
                        let _e506 = nodes.member[(0u + _e467)].frame[0u];
                        let _e510 = nodes.member[(0u + _e467)].frame[1u];
                        let _e514 = nodes.member[(0u + _e467)].frame[2u];
                        let _e519 = ((bitcast<f32>(_e506) - _e107) * _e257);
                        let _e520 = ((bitcast<f32>(_e510) - _e109) * _e267);
                        let _e521 = ((bitcast<f32>(_e514) - _e111) * _e277);
                        let _e529 = nodes.member[(0u + _e467)].x;
                        if (_e257 < 0f) {
                            let _e540 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e529.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e546 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e540.unnamed.root, _e529.w), _e540.unnamed_1);
                            let _e552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e546.unnamed, lt_bvh_traverse_Tree(_e529.x, _e546.unnamed_1.first_primitive));
                            phi_755_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e552.unnamed, lt_bvh_traverse_Tree(_e552.unnamed_1.root, _e529.y));
                        } else {
                            let _e568 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e529.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e568.unnamed.root, _e529.y), _e568.unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e574.unnamed, lt_bvh_traverse_Tree(_e529.z, _e574.unnamed_1.first_primitive));
                            phi_755_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_bvh_traverse_Tree(_e580.unnamed_1.root, _e529.w));
                        }
                        let _e588 = phi_755_;
                        let _e598 = nodes.member[(0u + _e467)].y;
                        if (_e267 < 0f) {
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e609.unnamed.root, _e598.w), _e609.unnamed_1);
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e615.unnamed, lt_bvh_traverse_Tree(_e598.x, _e615.unnamed_1.first_primitive));
                            phi_782_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_bvh_traverse_Tree(_e621.unnamed_1.root, _e598.y));
                        } else {
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e637.unnamed.root, _e598.y), _e637.unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e643.unnamed, lt_bvh_traverse_Tree(_e598.z, _e643.unnamed_1.first_primitive));
                            phi_782_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e649.unnamed_1.root, _e598.w));
                        }
                        let _e657 = phi_782_;
                        let _e667 = nodes.member[(0u + _e467)].z;
                        if (_e277 < 0f) {
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e678.unnamed.root, _e667.w), _e678.unnamed_1);
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_bvh_traverse_Tree(_e667.x, _e684.unnamed_1.first_primitive));
                            phi_809_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e690.unnamed_1.root, _e667.y));
                        } else {
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e706.unnamed.root, _e667.y), _e706.unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_bvh_traverse_Tree(_e667.z, _e712.unnamed_1.first_primitive));
                            phi_809_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e718.unnamed_1.root, _e667.w));
                        }
                        let _e726 = phi_809_;
                        phi_815_ = 0u;
                        phi_818_ = 0u;
                        loop {
                            let _e736 = phi_815_;
                            let _e738 = phi_818_;
                            local_2 = _e738;
                            local_3 = _e738;
                            local_4 = _e738;
                            let _e739 = (_e736 < 8u);
                            if _e739 {
                                let _e741 = (_e736 >> bitcast<u32>(2i));
                                let _e742 = (_e736 & 3u);
                                if (_e741 == 0u) {
                                    phi_832_ = _e588.unnamed.root;
                                } else {
                                    phi_832_ = _e588.unnamed.first_primitive;
                                }
                                let _e745 = phi_832_;
                                if (_e741 == 0u) {
                                    phi_842_ = _e657.unnamed.root;
                                } else {
                                    phi_842_ = _e657.unnamed.first_primitive;
                                }
                                let _e754 = phi_842_;
                                if (_e741 == 0u) {
                                    phi_852_ = _e726.unnamed.root;
                                } else {
                                    phi_852_ = _e726.unnamed.first_primitive;
                                }
                                let _e763 = phi_852_;
                                let _e776 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e745 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u)) * _e501) + (_e519 - _e309)), ((f32(((_e754 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u)) * _e502) + (_e520 - _e310)));
                                let _e777 = core_intrinsics_maximum_number_nsz_f32_(_e776, ((f32(((_e763 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u)) * _e503) + (_e521 - _e311)));
                                if (_e741 == 0u) {
                                    phi_870_ = _e588.unnamed_1.root;
                                } else {
                                    phi_870_ = _e588.unnamed_1.first_primitive;
                                }
                                let _e780 = phi_870_;
                                if (_e741 == 0u) {
                                    phi_880_ = _e657.unnamed_1.root;
                                } else {
                                    phi_880_ = _e657.unnamed_1.first_primitive;
                                }
                                let _e789 = phi_880_;
                                if (_e741 == 0u) {
                                    phi_890_ = _e726.unnamed_1.root;
                                } else {
                                    phi_890_ = _e726.unnamed_1.first_primitive;
                                }
                                let _e798 = phi_890_;
                                let _e811 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e780 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u)) * _e501) + (_e519 + _e309)), ((f32(((_e789 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u)) * _e502) + (_e520 + _e310)));
                                let _e812 = core_intrinsics_minimum_number_nsz_f32_(_e811, ((f32(((_e798 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u)) * _e503) + (_e521 + _e311)));
                                if (_e777 <= _e812) {
                                    if (_e777 <= _e117) {
                                        if (_e812 >= 0f) {
                                            if (_e741 == 0u) {
                                                let _e819 = nodes.member[(0u + _e467)].links[2u];
                                                phi_926_ = _e819;
                                            } else {
                                                let _e822 = nodes.member[(0u + _e467)].links[3u];
                                                phi_926_ = _e822;
                                            }
                                            let _e824 = phi_926_;
                                            let _e829 = ((_e824 >> bitcast<u32>(((_e742 * 8u) & 31u))) & 255u);
                                            let _e830 = (_e829 & 31u);
                                            if (_e830 >= 24u) {
                                                phi_939_ = (24u + ((_e830 - 24u) ^ _e329));
                                            } else {
                                                phi_939_ = _e830;
                                            }
                                            let _e836 = phi_939_;
                                            phi_944_ = (_e738 | ((_e829 >> bitcast<u32>(5i)) << bitcast<u32>((_e836 & 31u))));
                                        } else {
                                            phi_944_ = _e738;
                                        }
                                        let _e844 = phi_944_;
                                        phi_945_ = _e844;
                                    } else {
                                        phi_945_ = _e738;
                                    }
                                    let _e846 = phi_945_;
                                    phi_946_ = _e846;
                                } else {
                                    phi_946_ = _e738;
                                }
                                let _e848 = phi_946_;
                                phi_816_ = (_e736 + 1u);
                                phi_819_ = _e848;
                            } else {
                                phi_816_ = u32();
                                phi_819_ = u32();
                            }
                            let _e851 = phi_816_;
                            let _e853 = phi_819_;
                            continue;
                            continuing {
                                phi_815_ = _e851;
                                phi_818_ = _e853;
                                break if !(_e739);
                            }
                        }
                        let _e857 = nodes.member[(0u + _e467)].links[0u];
                        let _e861 = nodes.member[(0u + _e467)].frame[3u];
                        let _e865 = local_2;
                        if ((_e865 & 4278190080u) == 0u) {
                        } else {
                            let _e869 = local_1.group_mask;
                            if ((_e869 & 4278190080u) == 0u) {
                            } else {
                                let _e873 = local_1.len;
                                if (_e873 < 32u) {
                                    let _e876 = local_1.group;
                                    let _e878 = local_1.len;
                                    if (_e878 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e878)] = _e876;
                                    let _e884 = local_1.group_mask;
                                    let _e886 = local_1.len;
                                    if (_e886 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e886)] = _e884;
                                    let _e893 = local_1.len;
                                    local_1.len = (_e893 + 1u);
                                }
                            }
                            local_1.group = (_e87 + _e857);
                            let _e897 = local_3;
                            local_1.group_mask = ((_e897 & 4278190080u) | (_e861 >> bitcast<u32>(24i)));
                        }
                        let _e902 = local_4;
                        phi_1004_ = (_e902 & 16777215u);
                        phi_1007_ = _e469;
                        loop {
                            let _e905 = phi_1004_;
                            let _e907 = phi_1007_;
                            local_15 = _e907;
                            let _e908 = (_e905 == 0u);
                            local_10 = _e908;
                            local_16 = _e908;
                            if _e908 {
                                phi_1005_ = u32();
                                phi_1008_ = bool();
                                phi_2658_ = false;
                            } else {
                                let _e911 = nodes.member[(0u + _e467)].links[1u];
                                let _e915 = (_e911 + select(firstTrailingBit(_e905), 32u, (_e905 == 0u)));
                                if (_e915 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e922 = instances.member[(0u + _e915)].low_world;
                                let _e924 = instances.member[(0u + _e915)].high_world;
                                let _e931 = ((_e922.x - _e107) * _e257);
                                let _e932 = ((_e922.y - _e109) * _e267);
                                let _e933 = ((_e922.z - _e111) * _e277);
                                let _e940 = ((_e924.x - _e107) * _e257);
                                let _e941 = ((_e924.y - _e109) * _e267);
                                let _e942 = ((_e924.z - _e111) * _e277);
                                if (_e931 < _e940) {
                                    phi_1056_ = _e931;
                                } else {
                                    phi_1056_ = _e940;
                                }
                                let _e945 = phi_1056_;
                                if (_e932 < _e941) {
                                    phi_1061_ = _e932;
                                } else {
                                    phi_1061_ = _e941;
                                }
                                let _e948 = phi_1061_;
                                if (_e933 < _e942) {
                                    phi_1066_ = _e933;
                                } else {
                                    phi_1066_ = _e942;
                                }
                                let _e951 = phi_1066_;
                                if (_e931 > _e940) {
                                    phi_1074_ = _e931;
                                } else {
                                    phi_1074_ = _e940;
                                }
                                let _e957 = phi_1074_;
                                if (_e932 > _e941) {
                                    phi_1079_ = _e932;
                                } else {
                                    phi_1079_ = _e941;
                                }
                                let _e960 = phi_1079_;
                                if (_e933 > _e942) {
                                    phi_1084_ = _e933;
                                } else {
                                    phi_1084_ = _e942;
                                }
                                let _e963 = phi_1084_;
                                let _e967 = core_intrinsics_maximum_number_nsz_f32_((_e945 - _e316), (_e948 - _e317));
                                let _e968 = core_intrinsics_maximum_number_nsz_f32_(_e967, (_e951 - _e318));
                                let _e969 = core_intrinsics_minimum_number_nsz_f32_((_e957 + _e316), (_e960 + _e317));
                                let _e970 = core_intrinsics_minimum_number_nsz_f32_(_e969, (_e963 + _e318));
                                if (_e968 <= _e970) {
                                    if (_e968 <= _e117) {
                                        if (_e970 >= 0f) {
                                            let _e976 = instances.member[(0u + _e915)].world_to_object[0u];
                                            let _e987 = ((((_e976.x * _e107) + (_e976.y * _e109)) + (_e976.z * _e111)) + (_e976.w * 1f));
                                            let _e989 = instances.member[(0u + _e915)].world_to_object[1u];
                                            let _e1000 = ((((_e989.x * _e107) + (_e989.y * _e109)) + (_e989.z * _e111)) + (_e989.w * 1f));
                                            let _e1002 = instances.member[(0u + _e915)].world_to_object[2u];
                                            let _e1013 = ((((_e1002.x * _e107) + (_e1002.y * _e109)) + (_e1002.z * _e111)) + (_e1002.w * 1f));
                                            let _e1016 = instances.member[(0u + _e915)].world_to_object[0u];
                                            let _e1027 = ((((_e1016.x * _e125) + (_e1016.y * _e126)) + (_e1016.z * _e127)) + (_e1016.w * 0f));
                                            let _e1029 = instances.member[(0u + _e915)].world_to_object[1u];
                                            let _e1040 = ((((_e1029.x * _e125) + (_e1029.y * _e126)) + (_e1029.z * _e127)) + (_e1029.w * 0f));
                                            let _e1042 = instances.member[(0u + _e915)].world_to_object[2u];
                                            let _e1053 = ((((_e1042.x * _e125) + (_e1042.y * _e126)) + (_e1042.z * _e127)) + (_e1042.w * 0f));
                                            let _e1056 = instances.member[(0u + _e915)].root;
                                            let _e1058 = instances.member[(0u + _e915)].first_triangle;
                                            let _e1059 = abs(_e1027);
                                            let _e1060 = abs(_e1040);
                                            let _e1061 = abs(_e1053);
                                            if (abs(_e987) < 1000000000000000f) {
                                                if (abs(_e1000) < 1000000000000000f) {
                                                    phi_1204_ = (abs(_e1013) < 1000000000000000f);
                                                    phi_1205_ = false;
                                                } else {
                                                    phi_1204_ = bool();
                                                    phi_1205_ = true;
                                                }
                                                let _e1069 = phi_1204_;
                                                let _e1071 = phi_1205_;
                                                phi_1206_ = _e1069;
                                                phi_1207_ = _e1071;
                                            } else {
                                                phi_1206_ = bool();
                                                phi_1207_ = true;
                                            }
                                            let _e1073 = phi_1206_;
                                            let _e1075 = phi_1207_;
                                            if _e1075 {
                                                phi_1211_ = false;
                                            } else {
                                                phi_1211_ = _e1073;
                                            }
                                            let _e1077 = phi_1211_;
                                            if _e1077 {
                                                if (_e1059 < 1000000000000000f) {
                                                    if (_e1060 < 1000000000000000f) {
                                                        phi_1224_ = (_e1061 < 1000000000000000f);
                                                        phi_1225_ = false;
                                                    } else {
                                                        phi_1224_ = bool();
                                                        phi_1225_ = true;
                                                    }
                                                    let _e1082 = phi_1224_;
                                                    let _e1084 = phi_1225_;
                                                    phi_1226_ = _e1082;
                                                    phi_1227_ = _e1084;
                                                } else {
                                                    phi_1226_ = bool();
                                                    phi_1227_ = true;
                                                }
                                                let _e1086 = phi_1226_;
                                                let _e1088 = phi_1227_;
                                                if _e1088 {
                                                    phi_1231_ = false;
                                                } else {
                                                    phi_1231_ = _e1086;
                                                }
                                                let _e1090 = phi_1231_;
                                                if _e1090 {
                                                    if (_e1059 > 0f) {
                                                        phi_1245_ = bool();
                                                        phi_1246_ = true;
                                                    } else {
                                                        let _e1092 = (_e1060 > 0f);
                                                        if _e1092 {
                                                            phi_1244_ = bool();
                                                        } else {
                                                            phi_1244_ = (_e1061 > 0f);
                                                        }
                                                        let _e1095 = phi_1244_;
                                                        phi_1245_ = _e1095;
                                                        phi_1246_ = _e1092;
                                                    }
                                                    let _e1097 = phi_1245_;
                                                    let _e1099 = phi_1246_;
                                                    if _e1099 {
                                                        phi_1250_ = true;
                                                    } else {
                                                        phi_1250_ = _e1097;
                                                    }
                                                    let _e1101 = phi_1250_;
                                                    phi_1251_ = _e1101;
                                                    phi_1252_ = false;
                                                } else {
                                                    phi_1251_ = bool();
                                                    phi_1252_ = true;
                                                }
                                                let _e1103 = phi_1251_;
                                                let _e1105 = phi_1252_;
                                                phi_1253_ = _e1103;
                                                phi_1254_ = _e1105;
                                            } else {
                                                phi_1253_ = bool();
                                                phi_1254_ = true;
                                            }
                                            let _e1107 = phi_1253_;
                                            let _e1109 = phi_1254_;
                                            if _e1109 {
                                                phi_1258_ = false;
                                            } else {
                                                phi_1258_ = _e1107;
                                            }
                                            let _e1111 = phi_1258_;
                                            if _e1111 {
                                                let _e1112 = (_e1056 >= _e60);
                                                if _e1112 {
                                                    phi_2638_ = bool();
                                                } else {
                                                    if (_e1056 < _e60) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1118 = nodes.member[(0u + _e1056)].frame[0u];
                                                    let _e1122 = nodes.member[(0u + _e1056)].frame[1u];
                                                    let _e1126 = nodes.member[(0u + _e1056)].frame[2u];
                                                    let _e1130 = nodes.member[(0u + _e1056)].frame[0u];
                                                    let _e1134 = nodes.member[(0u + _e1056)].frame[1u];
                                                    let _e1138 = nodes.member[(0u + _e1056)].frame[2u];
                                                    let _e1142 = nodes.member[(0u + _e1056)].frame[3u];
                                                    let _e1176 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1027), abs(_e1040));
                                                    let _e1177 = core_intrinsics_maximum_number_nsz_f32_(_e1176, abs(_e1053));
                                                    let _e1178 = (_e1177 * 0.0000000000009094947f);
                                                    if (abs(_e1027) < _e1178) {
                                                        phi_1328_ = _e1178;
                                                    } else {
                                                        phi_1328_ = abs(_e1027);
                                                    }
                                                    let _e1183 = phi_1328_;
                                                    if (_e1027 < 0f) {
                                                        phi_1335_ = (-1f / _e1183);
                                                    } else {
                                                        phi_1335_ = (1f / _e1183);
                                                    }
                                                    let _e1188 = phi_1335_;
                                                    if (abs(_e1040) < _e1178) {
                                                        phi_1342_ = _e1178;
                                                    } else {
                                                        phi_1342_ = abs(_e1040);
                                                    }
                                                    let _e1193 = phi_1342_;
                                                    if (_e1040 < 0f) {
                                                        phi_1349_ = (-1f / _e1193);
                                                    } else {
                                                        phi_1349_ = (1f / _e1193);
                                                    }
                                                    let _e1198 = phi_1349_;
                                                    if (abs(_e1053) < _e1178) {
                                                        phi_1356_ = _e1178;
                                                    } else {
                                                        phi_1356_ = abs(_e1053);
                                                    }
                                                    let _e1203 = phi_1356_;
                                                    if (_e1053 < 0f) {
                                                        phi_1363_ = (-1f / _e1203);
                                                    } else {
                                                        phi_1363_ = (1f / _e1203);
                                                    }
                                                    let _e1208 = phi_1363_;
                                                    let _e1212 = abs((bitcast<f32>(_e1118) - _e987));
                                                    let _e1213 = abs((bitcast<f32>(_e1122) - _e1000));
                                                    let _e1214 = abs((bitcast<f32>(_e1126) - _e1013));
                                                    let _e1218 = abs(((bitcast<f32>(_e1130) + (bitcast<f32>((((_e1142 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e987));
                                                    let _e1219 = abs(((bitcast<f32>(_e1134) + (bitcast<f32>((((_e1142 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1000));
                                                    let _e1220 = abs(((bitcast<f32>(_e1138) + (bitcast<f32>((((_e1142 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1013));
                                                    if (_e1212 > _e1218) {
                                                        phi_1380_ = _e1212;
                                                    } else {
                                                        phi_1380_ = _e1218;
                                                    }
                                                    let _e1223 = phi_1380_;
                                                    if (_e1213 > _e1219) {
                                                        phi_1385_ = _e1213;
                                                    } else {
                                                        phi_1385_ = _e1219;
                                                    }
                                                    let _e1226 = phi_1385_;
                                                    if (_e1214 > _e1220) {
                                                        phi_1390_ = _e1214;
                                                    } else {
                                                        phi_1390_ = _e1220;
                                                    }
                                                    let _e1229 = phi_1390_;
                                                    if (_e1223 > _e1226) {
                                                        phi_1395_ = _e1223;
                                                    } else {
                                                        phi_1395_ = _e1226;
                                                    }
                                                    let _e1232 = phi_1395_;
                                                    if (_e1232 > _e1229) {
                                                        phi_1400_ = _e1232;
                                                    } else {
                                                        phi_1400_ = _e1229;
                                                    }
                                                    let _e1235 = phi_1400_;
                                                    let _e1239 = (_e1235 * 0.0000019073486f);
                                                    let _e1240 = (abs(_e1188) * _e1239);
                                                    let _e1241 = (abs(_e1198) * _e1239);
                                                    let _e1242 = (abs(_e1208) * _e1239);
                                                    let _e1246 = (_e1235 * 0.0000009536743f);
                                                    let _e1247 = (abs(_e1188) * _e1246);
                                                    let _e1248 = (abs(_e1198) * _e1246);
                                                    let _e1249 = (abs(_e1208) * _e1246);
                                                    let _e1250 = abs(_e1027);
                                                    let _e1251 = abs(_e1040);
                                                    let _e1252 = abs(_e1053);
                                                    if (_e1250 >= _e1251) {
                                                        if (_e1250 >= _e1252) {
                                                            phi_1426_ = false;
                                                        } else {
                                                            phi_1426_ = true;
                                                        }
                                                        let _e1256 = phi_1426_;
                                                        phi_1427_ = _e1256;
                                                    } else {
                                                        phi_1427_ = true;
                                                    }
                                                    let _e1258 = phi_1427_;
                                                    if _e1258 {
                                                        if (_e1251 >= _e1252) {
                                                            phi_1435_ = 1u;
                                                        } else {
                                                            phi_1435_ = 2u;
                                                        }
                                                        let _e1261 = phi_1435_;
                                                        phi_1436_ = _e1261;
                                                    } else {
                                                        phi_1436_ = 0u;
                                                    }
                                                    let _e1263 = phi_1436_;
                                                    if (_e1263 == 0u) {
                                                        phi_1448_ = vec3<f32>(_e1040, _e1053, _e1027);
                                                    } else {
                                                        if (_e1263 == 1u) {
                                                            phi_1447_ = vec3<f32>(_e1053, _e1027, _e1040);
                                                        } else {
                                                            phi_1447_ = vec3<f32>(_e1027, _e1040, _e1053);
                                                        }
                                                        let _e1269 = phi_1447_;
                                                        phi_1448_ = _e1269;
                                                    }
                                                    let _e1271 = phi_1448_;
                                                    let _e1274 = (_e1271.x / _e1271.z);
                                                    let _e1277 = (_e1271.y / _e1271.z);
                                                    if (_e1188 < 0f) {
                                                        phi_1461_ = 0u;
                                                    } else {
                                                        phi_1461_ = 1u;
                                                    }
                                                    let _e1282 = phi_1461_;
                                                    if (_e1198 < 0f) {
                                                        phi_1466_ = 0u;
                                                    } else {
                                                        phi_1466_ = 2u;
                                                    }
                                                    let _e1285 = phi_1466_;
                                                    if (_e1208 < 0f) {
                                                        phi_1471_ = 0u;
                                                    } else {
                                                        phi_1471_ = 4u;
                                                    }
                                                    let _e1288 = phi_1471_;
                                                    let _e1290 = ((_e1282 | _e1285) | _e1288);
                                                    let _e1291 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1056, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1291.first[0], _e1291.first[1], _e1291.first[2], _e1291.first[3], _e1291.first[4], _e1291.first[5], _e1291.first[6], _e1291.first[7], _e1291.first[8], _e1291.first[9], _e1291.first[10], _e1291.first[11], _e1291.first[12], _e1291.first[13], _e1291.first[14], _e1291.first[15], _e1291.first[16], _e1291.first[17], _e1291.first[18], _e1291.first[19], _e1291.first[20], _e1291.first[21], _e1291.first[22], _e1291.first[23], _e1291.first[24], _e1291.first[25], _e1291.first[26], _e1291.first[27], _e1291.first[28], _e1291.first[29], _e1291.first[30], _e1291.first[31]), array<u32, 32>(_e1291.mask[0], _e1291.mask[1], _e1291.mask[2], _e1291.mask[3], _e1291.mask[4], _e1291.mask[5], _e1291.mask[6], _e1291.mask[7], _e1291.mask[8], _e1291.mask[9], _e1291.mask[10], _e1291.mask[11], _e1291.mask[12], _e1291.mask[13], _e1291.mask[14], _e1291.mask[15], _e1291.mask[16], _e1291.mask[17], _e1291.mask[18], _e1291.mask[19], _e1291.mask[20], _e1291.mask[21], _e1291.mask[22], _e1291.mask[23], _e1291.mask[24], _e1291.mask[25], _e1291.mask[26], _e1291.mask[27], _e1291.mask[28], _e1291.mask[29], _e1291.mask[30], _e1291.mask[31]), _e1291.len, _e1291.group, _e1291.group_mask);
                                                    let _e1365 = local.group_mask;
                                                    if ((_e1365 & 4278190080u) == 0u) {
                                                        let _e1369 = local.len;
                                                        if (_e1369 == 0u) {
                                                            phi_1585_ = false;
                                                        } else {
                                                            let _e1373 = local.len;
                                                            local.len = (_e1373 - 1u);
                                                            let _e1376 = local.len;
                                                            if (_e1376 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1381 = local.first[(0u + _e1376)];
                                                            local.group = _e1381;
                                                            let _e1384 = local.len;
                                                            if (_e1384 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1389 = local.mask[(0u + _e1384)];
                                                            local.group_mask = _e1389;
                                                            phi_1585_ = true;
                                                        }
                                                        let _e1392 = phi_1585_;
                                                        phi_1586_ = _e1392;
                                                    } else {
                                                        phi_1586_ = true;
                                                    }
                                                    let _e1394 = phi_1586_;
                                                    if _e1394 {
                                                        let _e1396 = local.group_mask;
                                                        let _e1402 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1396)), 32u, (_e1396 == 0u)));
                                                        let _e1406 = local.group_mask;
                                                        let _e1420 = local.group_mask;
                                                        local.group_mask = (_e1420 & ~((1u << bitcast<u32>((_e1402 & 31u)))));
                                                        let _e1423 = local.group;
                                                        phi_1617_ = (_e1423 + countOneBits(((_e1406 & ~((4294967295u << bitcast<u32>((((_e1402 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1617_ = 4294967295u;
                                                    }
                                                    let _e1426 = phi_1617_;
                                                    phi_1619_ = _e1426;
                                                    phi_1622_ = _e907;
                                                    loop {
                                                        let _e1428 = phi_1619_;
                                                        let _e1430 = phi_1622_;
                                                        local_14 = _e1430;
                                                        if (_e1428 != 4294967295u) {
                                                            if (_e1428 < _e60) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1437 = nodes.member[(0u + _e1428)].frame[3u];
                                                            let _e1462 = (bitcast<f32>((((_e1437 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1188);
                                                            let _e1463 = (bitcast<f32>((((_e1437 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1198);
                                                            let _e1464 = (bitcast<f32>((((_e1437 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1208);
                                                            let _e1467 = nodes.member[(0u + _e1428)].frame[0u];
                                                            let _e1471 = nodes.member[(0u + _e1428)].frame[1u];
                                                            let _e1475 = nodes.member[(0u + _e1428)].frame[2u];
                                                            let _e1480 = ((bitcast<f32>(_e1467) - _e987) * _e1188);
                                                            let _e1481 = ((bitcast<f32>(_e1471) - _e1000) * _e1198);
                                                            let _e1482 = ((bitcast<f32>(_e1475) - _e1013) * _e1208);
                                                            let _e1490 = nodes.member[(0u + _e1428)].x;
                                                            if (_e1188 < 0f) {
                                                                let _e1501 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1490.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1507 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1501.unnamed.root, _e1490.w), _e1501.unnamed_1);
                                                                let _e1513 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1507.unnamed, lt_bvh_traverse_Tree(_e1490.x, _e1507.unnamed_1.first_primitive));
                                                                phi_1702_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1513.unnamed, lt_bvh_traverse_Tree(_e1513.unnamed_1.root, _e1490.y));
                                                            } else {
                                                                let _e1529 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1490.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1535 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1529.unnamed.root, _e1490.y), _e1529.unnamed_1);
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1535.unnamed, lt_bvh_traverse_Tree(_e1490.z, _e1535.unnamed_1.first_primitive));
                                                                phi_1702_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_bvh_traverse_Tree(_e1541.unnamed_1.root, _e1490.w));
                                                            }
                                                            let _e1549 = phi_1702_;
                                                            let _e1559 = nodes.member[(0u + _e1428)].y;
                                                            if (_e1198 < 0f) {
                                                                let _e1570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1559.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1570.unnamed.root, _e1559.w), _e1570.unnamed_1);
                                                                let _e1582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1576.unnamed, lt_bvh_traverse_Tree(_e1559.x, _e1576.unnamed_1.first_primitive));
                                                                phi_1729_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1582.unnamed, lt_bvh_traverse_Tree(_e1582.unnamed_1.root, _e1559.y));
                                                            } else {
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1559.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1598.unnamed.root, _e1559.y), _e1598.unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_bvh_traverse_Tree(_e1559.z, _e1604.unnamed_1.first_primitive));
                                                                phi_1729_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_bvh_traverse_Tree(_e1610.unnamed_1.root, _e1559.w));
                                                            }
                                                            let _e1618 = phi_1729_;
                                                            let _e1628 = nodes.member[(0u + _e1428)].z;
                                                            if (_e1208 < 0f) {
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1639.unnamed.root, _e1628.w), _e1639.unnamed_1);
                                                                let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_bvh_traverse_Tree(_e1628.x, _e1645.unnamed_1.first_primitive));
                                                                phi_1756_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1651.unnamed, lt_bvh_traverse_Tree(_e1651.unnamed_1.root, _e1628.y));
                                                            } else {
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1667.unnamed.root, _e1628.y), _e1667.unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_bvh_traverse_Tree(_e1628.z, _e1673.unnamed_1.first_primitive));
                                                                phi_1756_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_bvh_traverse_Tree(_e1679.unnamed_1.root, _e1628.w));
                                                            }
                                                            let _e1687 = phi_1756_;
                                                            phi_1762_ = 0u;
                                                            phi_1765_ = 0u;
                                                            loop {
                                                                let _e1697 = phi_1762_;
                                                                let _e1699 = phi_1765_;
                                                                local_5 = _e1699;
                                                                local_6 = _e1699;
                                                                local_7 = _e1699;
                                                                let _e1700 = (_e1697 < 8u);
                                                                if _e1700 {
                                                                    let _e1702 = (_e1697 >> bitcast<u32>(2i));
                                                                    let _e1703 = (_e1697 & 3u);
                                                                    if (_e1702 == 0u) {
                                                                        phi_1779_ = _e1549.unnamed.root;
                                                                    } else {
                                                                        phi_1779_ = _e1549.unnamed.first_primitive;
                                                                    }
                                                                    let _e1706 = phi_1779_;
                                                                    if (_e1702 == 0u) {
                                                                        phi_1789_ = _e1618.unnamed.root;
                                                                    } else {
                                                                        phi_1789_ = _e1618.unnamed.first_primitive;
                                                                    }
                                                                    let _e1715 = phi_1789_;
                                                                    if (_e1702 == 0u) {
                                                                        phi_1799_ = _e1687.unnamed.root;
                                                                    } else {
                                                                        phi_1799_ = _e1687.unnamed.first_primitive;
                                                                    }
                                                                    let _e1724 = phi_1799_;
                                                                    let _e1737 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1706 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u)) * _e1462) + (_e1480 - _e1240)), ((f32(((_e1715 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u)) * _e1463) + (_e1481 - _e1241)));
                                                                    let _e1738 = core_intrinsics_maximum_number_nsz_f32_(_e1737, ((f32(((_e1724 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 - _e1242)));
                                                                    if (_e1702 == 0u) {
                                                                        phi_1817_ = _e1549.unnamed_1.root;
                                                                    } else {
                                                                        phi_1817_ = _e1549.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1741 = phi_1817_;
                                                                    if (_e1702 == 0u) {
                                                                        phi_1827_ = _e1618.unnamed_1.root;
                                                                    } else {
                                                                        phi_1827_ = _e1618.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1750 = phi_1827_;
                                                                    if (_e1702 == 0u) {
                                                                        phi_1837_ = _e1687.unnamed_1.root;
                                                                    } else {
                                                                        phi_1837_ = _e1687.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1759 = phi_1837_;
                                                                    let _e1772 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1741 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u)) * _e1462) + (_e1480 + _e1240)), ((f32(((_e1750 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u)) * _e1463) + (_e1481 + _e1241)));
                                                                    let _e1773 = core_intrinsics_minimum_number_nsz_f32_(_e1772, ((f32(((_e1759 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 + _e1242)));
                                                                    if (_e1738 <= _e1773) {
                                                                        if (_e1738 <= _e117) {
                                                                            if (_e1773 >= 0f) {
                                                                                if (_e1702 == 0u) {
                                                                                    let _e1780 = nodes.member[(0u + _e1428)].links[2u];
                                                                                    phi_1873_ = _e1780;
                                                                                } else {
                                                                                    let _e1783 = nodes.member[(0u + _e1428)].links[3u];
                                                                                    phi_1873_ = _e1783;
                                                                                }
                                                                                let _e1785 = phi_1873_;
                                                                                let _e1790 = ((_e1785 >> bitcast<u32>(((_e1703 * 8u) & 31u))) & 255u);
                                                                                let _e1791 = (_e1790 & 31u);
                                                                                if (_e1791 >= 24u) {
                                                                                    phi_1886_ = (24u + ((_e1791 - 24u) ^ _e1290));
                                                                                } else {
                                                                                    phi_1886_ = _e1791;
                                                                                }
                                                                                let _e1797 = phi_1886_;
                                                                                phi_1891_ = (_e1699 | ((_e1790 >> bitcast<u32>(5i)) << bitcast<u32>((_e1797 & 31u))));
                                                                            } else {
                                                                                phi_1891_ = _e1699;
                                                                            }
                                                                            let _e1805 = phi_1891_;
                                                                            phi_1892_ = _e1805;
                                                                        } else {
                                                                            phi_1892_ = _e1699;
                                                                        }
                                                                        let _e1807 = phi_1892_;
                                                                        phi_1893_ = _e1807;
                                                                    } else {
                                                                        phi_1893_ = _e1699;
                                                                    }
                                                                    let _e1809 = phi_1893_;
                                                                    phi_1763_ = (_e1697 + 1u);
                                                                    phi_1766_ = _e1809;
                                                                } else {
                                                                    phi_1763_ = u32();
                                                                    phi_1766_ = u32();
                                                                }
                                                                let _e1812 = phi_1763_;
                                                                let _e1814 = phi_1766_;
                                                                continue;
                                                                continuing {
                                                                    phi_1762_ = _e1812;
                                                                    phi_1765_ = _e1814;
                                                                    break if !(_e1700);
                                                                }
                                                            }
                                                            let _e1818 = nodes.member[(0u + _e1428)].links[0u];
                                                            let _e1822 = nodes.member[(0u + _e1428)].frame[3u];
                                                            let _e1826 = local_5;
                                                            if ((_e1826 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1830 = local.group_mask;
                                                                if ((_e1830 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1834 = local.len;
                                                                    if (_e1834 < 32u) {
                                                                        let _e1837 = local.group;
                                                                        let _e1839 = local.len;
                                                                        if (_e1839 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1839)] = _e1837;
                                                                        let _e1845 = local.group_mask;
                                                                        let _e1847 = local.len;
                                                                        if (_e1847 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1847)] = _e1845;
                                                                        let _e1854 = local.len;
                                                                        local.len = (_e1854 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1056 + _e1818);
                                                                let _e1858 = local_6;
                                                                local.group_mask = ((_e1858 & 4278190080u) | (_e1822 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1863 = local_7;
                                                            phi_1951_ = (_e1863 & 16777215u);
                                                            phi_1954_ = _e1430;
                                                            loop {
                                                                let _e1866 = phi_1951_;
                                                                let _e1868 = phi_1954_;
                                                                local_12 = _e1868;
                                                                let _e1869 = (_e1866 == 0u);
                                                                local_8 = _e1869;
                                                                local_13 = _e1869;
                                                                if _e1869 {
                                                                    phi_1952_ = u32();
                                                                    phi_1955_ = bool();
                                                                    phi_2552_ = false;
                                                                } else {
                                                                    let _e1872 = nodes.member[(0u + _e1428)].links[1u];
                                                                    let _e1877 = ((_e1058 + _e1872) + select(firstTrailingBit(_e1866), 32u, (_e1866 == 0u)));
                                                                    if (_e1877 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1884 = triangles.member[(0u + _e1877)].v0_;
                                                                    let _e1886 = (_e1884.x - _e987);
                                                                    let _e1888 = (_e1884.y - _e1000);
                                                                    let _e1890 = (_e1884.z - _e1013);
                                                                    if (_e1263 == 0u) {
                                                                        phi_1999_ = vec3<f32>(_e1888, _e1890, _e1886);
                                                                    } else {
                                                                        if (_e1263 == 1u) {
                                                                            phi_1998_ = vec3<f32>(_e1890, _e1886, _e1888);
                                                                        } else {
                                                                            phi_1998_ = (_e1884 - vec3<f32>(_e987, _e1000, _e1013));
                                                                        }
                                                                        let _e1898 = phi_1998_;
                                                                        phi_1999_ = _e1898;
                                                                    }
                                                                    let _e1900 = phi_1999_;
                                                                    let _e1904 = (_e1900.x - (_e1274 * _e1900.z));
                                                                    let _e1908 = (_e1900.y - (_e1277 * _e1900.z));
                                                                    let _e1910 = triangles.member[(0u + _e1877)].v1_;
                                                                    let _e1912 = (_e1910.x - _e987);
                                                                    let _e1914 = (_e1910.y - _e1000);
                                                                    let _e1916 = (_e1910.z - _e1013);
                                                                    if (_e1263 == 0u) {
                                                                        phi_2029_ = vec3<f32>(_e1914, _e1916, _e1912);
                                                                    } else {
                                                                        if (_e1263 == 1u) {
                                                                            phi_2028_ = vec3<f32>(_e1916, _e1912, _e1914);
                                                                        } else {
                                                                            phi_2028_ = (_e1910 - vec3<f32>(_e987, _e1000, _e1013));
                                                                        }
                                                                        let _e1924 = phi_2028_;
                                                                        phi_2029_ = _e1924;
                                                                    }
                                                                    let _e1926 = phi_2029_;
                                                                    let _e1930 = (_e1926.x - (_e1274 * _e1926.z));
                                                                    let _e1934 = (_e1926.y - (_e1277 * _e1926.z));
                                                                    let _e1936 = triangles.member[(0u + _e1877)].v2_;
                                                                    let _e1938 = (_e1936.x - _e987);
                                                                    let _e1940 = (_e1936.y - _e1000);
                                                                    let _e1942 = (_e1936.z - _e1013);
                                                                    if (_e1263 == 0u) {
                                                                        phi_2059_ = vec3<f32>(_e1940, _e1942, _e1938);
                                                                    } else {
                                                                        if (_e1263 == 1u) {
                                                                            phi_2058_ = vec3<f32>(_e1942, _e1938, _e1940);
                                                                        } else {
                                                                            phi_2058_ = (_e1936 - vec3<f32>(_e987, _e1000, _e1013));
                                                                        }
                                                                        let _e1950 = phi_2058_;
                                                                        phi_2059_ = _e1950;
                                                                    }
                                                                    let _e1952 = phi_2059_;
                                                                    let _e1956 = (_e1952.x - (_e1274 * _e1952.z));
                                                                    let _e1960 = (_e1952.y - (_e1277 * _e1952.z));
                                                                    if (_e1930 < _e1956) {
                                                                        phi_2078_ = true;
                                                                    } else {
                                                                        if (_e1930 == _e1956) {
                                                                            phi_2077_ = (_e1934 < _e1960);
                                                                        } else {
                                                                            phi_2077_ = false;
                                                                        }
                                                                        let _e1965 = phi_2077_;
                                                                        phi_2078_ = _e1965;
                                                                    }
                                                                    let _e1967 = phi_2078_;
                                                                    if _e1967 {
                                                                        phi_2082_ = _e1960;
                                                                        phi_2083_ = _e1956;
                                                                        phi_2084_ = _e1934;
                                                                        phi_2085_ = _e1930;
                                                                    } else {
                                                                        phi_2082_ = _e1934;
                                                                        phi_2083_ = _e1930;
                                                                        phi_2084_ = _e1960;
                                                                        phi_2085_ = _e1956;
                                                                    }
                                                                    let _e1969 = phi_2082_;
                                                                    let _e1971 = phi_2083_;
                                                                    let _e1973 = phi_2084_;
                                                                    let _e1975 = phi_2085_;
                                                                    let _e1978 = ((_e1975 * _e1969) - (_e1973 * _e1971));
                                                                    if _e1967 {
                                                                        phi_2093_ = -(_e1978);
                                                                    } else {
                                                                        phi_2093_ = _e1978;
                                                                    }
                                                                    let _e1981 = phi_2093_;
                                                                    if (_e1956 < _e1904) {
                                                                        phi_2104_ = true;
                                                                    } else {
                                                                        if (_e1956 == _e1904) {
                                                                            phi_2103_ = (_e1960 < _e1908);
                                                                        } else {
                                                                            phi_2103_ = false;
                                                                        }
                                                                        let _e1986 = phi_2103_;
                                                                        phi_2104_ = _e1986;
                                                                    }
                                                                    let _e1988 = phi_2104_;
                                                                    if _e1988 {
                                                                        phi_2108_ = _e1908;
                                                                        phi_2109_ = _e1904;
                                                                        phi_2110_ = _e1960;
                                                                        phi_2111_ = _e1956;
                                                                    } else {
                                                                        phi_2108_ = _e1960;
                                                                        phi_2109_ = _e1956;
                                                                        phi_2110_ = _e1908;
                                                                        phi_2111_ = _e1904;
                                                                    }
                                                                    let _e1990 = phi_2108_;
                                                                    let _e1992 = phi_2109_;
                                                                    let _e1994 = phi_2110_;
                                                                    let _e1996 = phi_2111_;
                                                                    let _e1999 = ((_e1996 * _e1990) - (_e1994 * _e1992));
                                                                    if _e1988 {
                                                                        phi_2119_ = -(_e1999);
                                                                    } else {
                                                                        phi_2119_ = _e1999;
                                                                    }
                                                                    let _e2002 = phi_2119_;
                                                                    if (_e1904 < _e1930) {
                                                                        phi_2130_ = true;
                                                                    } else {
                                                                        if (_e1904 == _e1930) {
                                                                            phi_2129_ = (_e1908 < _e1934);
                                                                        } else {
                                                                            phi_2129_ = false;
                                                                        }
                                                                        let _e2007 = phi_2129_;
                                                                        phi_2130_ = _e2007;
                                                                    }
                                                                    let _e2009 = phi_2130_;
                                                                    if _e2009 {
                                                                        phi_2134_ = _e1934;
                                                                        phi_2135_ = _e1930;
                                                                        phi_2136_ = _e1908;
                                                                        phi_2137_ = _e1904;
                                                                    } else {
                                                                        phi_2134_ = _e1908;
                                                                        phi_2135_ = _e1904;
                                                                        phi_2136_ = _e1934;
                                                                        phi_2137_ = _e1930;
                                                                    }
                                                                    let _e2011 = phi_2134_;
                                                                    let _e2013 = phi_2135_;
                                                                    let _e2015 = phi_2136_;
                                                                    let _e2017 = phi_2137_;
                                                                    let _e2020 = ((_e2017 * _e2011) - (_e2015 * _e2013));
                                                                    if _e2009 {
                                                                        phi_2145_ = -(_e2020);
                                                                    } else {
                                                                        phi_2145_ = _e2020;
                                                                    }
                                                                    let _e2023 = phi_2145_;
                                                                    if (_e1981 >= 0f) {
                                                                        if (_e2002 >= 0f) {
                                                                            if (_e2023 >= 0f) {
                                                                                phi_2160_ = ((_e1981 + _e2002) + _e2023);
                                                                                phi_2161_ = false;
                                                                            } else {
                                                                                phi_2160_ = f32();
                                                                                phi_2161_ = true;
                                                                            }
                                                                            let _e2030 = phi_2160_;
                                                                            let _e2032 = phi_2161_;
                                                                            phi_2162_ = _e2030;
                                                                            phi_2163_ = _e2032;
                                                                        } else {
                                                                            phi_2162_ = f32();
                                                                            phi_2163_ = true;
                                                                        }
                                                                        let _e2034 = phi_2162_;
                                                                        let _e2036 = phi_2163_;
                                                                        phi_2164_ = _e2034;
                                                                        phi_2165_ = _e2036;
                                                                    } else {
                                                                        phi_2164_ = f32();
                                                                        phi_2165_ = true;
                                                                    }
                                                                    let _e2038 = phi_2164_;
                                                                    let _e2040 = phi_2165_;
                                                                    if _e2040 {
                                                                        if (_e1981 <= 0f) {
                                                                            if (_e2002 <= 0f) {
                                                                                let _e2043 = (_e2023 <= 0f);
                                                                                if _e2043 {
                                                                                }
                                                                                phi_2183_ = ((_e1981 + _e2002) + _e2023);
                                                                                phi_2184_ = false;
                                                                                phi_2185_ = _e2043;
                                                                            } else {
                                                                                phi_2183_ = f32();
                                                                                phi_2184_ = true;
                                                                                phi_2185_ = false;
                                                                            }
                                                                            let _e2047 = phi_2183_;
                                                                            let _e2049 = phi_2184_;
                                                                            let _e2051 = phi_2185_;
                                                                            phi_2186_ = _e2047;
                                                                            phi_2187_ = _e2049;
                                                                            phi_2188_ = _e2051;
                                                                        } else {
                                                                            phi_2186_ = f32();
                                                                            phi_2187_ = true;
                                                                            phi_2188_ = false;
                                                                        }
                                                                        let _e2053 = phi_2186_;
                                                                        let _e2055 = phi_2187_;
                                                                        let _e2057 = phi_2188_;
                                                                        if _e2055 {
                                                                            phi_2192_ = false;
                                                                        } else {
                                                                            phi_2192_ = _e2057;
                                                                        }
                                                                        let _e2059 = phi_2192_;
                                                                        phi_2193_ = _e2053;
                                                                        phi_2194_ = _e2059;
                                                                    } else {
                                                                        phi_2193_ = _e2038;
                                                                        phi_2194_ = true;
                                                                    }
                                                                    let _e2061 = phi_2193_;
                                                                    let _e2063 = phi_2194_;
                                                                    if _e2063 {
                                                                        let _e2064 = (_e2061 == 0f);
                                                                        if _e2064 {
                                                                            phi_2510_ = lt_bvh_triangle_Intersection();
                                                                            phi_2511_ = false;
                                                                        } else {
                                                                            let _e2066 = triangles.member[(0u + _e1877)].v0_;
                                                                            let _e2068 = (_e2066.x - _e987);
                                                                            let _e2070 = (_e2066.y - _e1000);
                                                                            let _e2072 = (_e2066.z - _e1013);
                                                                            if (_e1263 == 0u) {
                                                                                phi_2223_ = vec3<f32>(_e2070, _e2072, _e2068);
                                                                            } else {
                                                                                if (_e1263 == 1u) {
                                                                                    phi_2222_ = vec3<f32>(_e2072, _e2068, _e2070);
                                                                                } else {
                                                                                    phi_2222_ = (_e2066 - vec3<f32>(_e987, _e1000, _e1013));
                                                                                }
                                                                                let _e2080 = phi_2222_;
                                                                                phi_2223_ = _e2080;
                                                                            }
                                                                            let _e2082 = phi_2223_;
                                                                            let _e2084 = triangles.member[(0u + _e1877)].v1_;
                                                                            let _e2086 = triangles.member[(0u + _e1877)].v0_;
                                                                            let _e2089 = (_e2084.x - _e2086.x);
                                                                            let _e2092 = (_e2084.y - _e2086.y);
                                                                            let _e2095 = (_e2084.z - _e2086.z);
                                                                            if (_e1263 == 0u) {
                                                                                phi_2249_ = vec3<f32>(_e2092, _e2095, _e2089);
                                                                            } else {
                                                                                if (_e1263 == 1u) {
                                                                                    phi_2248_ = vec3<f32>(_e2095, _e2089, _e2092);
                                                                                } else {
                                                                                    phi_2248_ = (_e2084 - _e2086);
                                                                                }
                                                                                let _e2102 = phi_2248_;
                                                                                phi_2249_ = _e2102;
                                                                            }
                                                                            let _e2104 = phi_2249_;
                                                                            let _e2106 = triangles.member[(0u + _e1877)].v2_;
                                                                            let _e2108 = triangles.member[(0u + _e1877)].v0_;
                                                                            let _e2111 = (_e2106.x - _e2108.x);
                                                                            let _e2114 = (_e2106.y - _e2108.y);
                                                                            let _e2117 = (_e2106.z - _e2108.z);
                                                                            if (_e1263 == 0u) {
                                                                                phi_2275_ = vec3<f32>(_e2114, _e2117, _e2111);
                                                                            } else {
                                                                                if (_e1263 == 1u) {
                                                                                    phi_2274_ = vec3<f32>(_e2117, _e2111, _e2114);
                                                                                } else {
                                                                                    phi_2274_ = (_e2106 - _e2108);
                                                                                }
                                                                                let _e2124 = phi_2274_;
                                                                                phi_2275_ = _e2124;
                                                                            }
                                                                            let _e2126 = phi_2275_;
                                                                            let _e2133 = ((_e2104.y * _e2126.z) - (_e2104.z * _e2126.y));
                                                                            let _e2140 = ((_e2104.z * _e2126.x) - (_e2104.x * _e2126.z));
                                                                            let _e2147 = ((_e2104.x * _e2126.y) - (_e2104.y * _e2126.x));
                                                                            let _e2161 = (((1f / _e1271.z) * (((_e2133 * _e2082.x) + (_e2140 * _e2082.y)) + (_e2147 * _e2082.z))) / (((_e2133 * _e1274) + (_e2140 * _e1277)) + _e2147));
                                                                            if (_e2161 > 0f) {
                                                                                if (_e2161 < _e117) {
                                                                                    let _e2165 = triangles.member[(0u + _e1877)].v0_;
                                                                                    let _e2167 = triangles.member[(0u + _e1877)].v1_;
                                                                                    if (_e2165.x < _e2167.x) {
                                                                                        phi_2331_ = _e2165.x;
                                                                                    } else {
                                                                                        phi_2331_ = _e2167.x;
                                                                                    }
                                                                                    let _e2174 = phi_2331_;
                                                                                    if (_e2165.y < _e2167.y) {
                                                                                        phi_2340_ = _e2165.y;
                                                                                    } else {
                                                                                        phi_2340_ = _e2167.y;
                                                                                    }
                                                                                    let _e2181 = phi_2340_;
                                                                                    if (_e2165.z < _e2167.z) {
                                                                                        phi_2349_ = _e2165.z;
                                                                                    } else {
                                                                                        phi_2349_ = _e2167.z;
                                                                                    }
                                                                                    let _e2188 = phi_2349_;
                                                                                    let _e2190 = triangles.member[(0u + _e1877)].v2_;
                                                                                    if (_e2174 < _e2190.x) {
                                                                                        phi_2358_ = _e2174;
                                                                                    } else {
                                                                                        phi_2358_ = _e2190.x;
                                                                                    }
                                                                                    let _e2195 = phi_2358_;
                                                                                    if (_e2181 < _e2190.y) {
                                                                                        phi_2365_ = _e2181;
                                                                                    } else {
                                                                                        phi_2365_ = _e2190.y;
                                                                                    }
                                                                                    let _e2200 = phi_2365_;
                                                                                    if (_e2188 < _e2190.z) {
                                                                                        phi_2372_ = _e2188;
                                                                                    } else {
                                                                                        phi_2372_ = _e2190.z;
                                                                                    }
                                                                                    let _e2205 = phi_2372_;
                                                                                    let _e2207 = triangles.member[(0u + _e1877)].v0_;
                                                                                    let _e2209 = triangles.member[(0u + _e1877)].v1_;
                                                                                    if (_e2207.x > _e2209.x) {
                                                                                        phi_2385_ = _e2207.x;
                                                                                    } else {
                                                                                        phi_2385_ = _e2209.x;
                                                                                    }
                                                                                    let _e2216 = phi_2385_;
                                                                                    if (_e2207.y > _e2209.y) {
                                                                                        phi_2394_ = _e2207.y;
                                                                                    } else {
                                                                                        phi_2394_ = _e2209.y;
                                                                                    }
                                                                                    let _e2223 = phi_2394_;
                                                                                    if (_e2207.z > _e2209.z) {
                                                                                        phi_2403_ = _e2207.z;
                                                                                    } else {
                                                                                        phi_2403_ = _e2209.z;
                                                                                    }
                                                                                    let _e2230 = phi_2403_;
                                                                                    let _e2232 = triangles.member[(0u + _e1877)].v2_;
                                                                                    if (_e2216 > _e2232.x) {
                                                                                        phi_2412_ = _e2216;
                                                                                    } else {
                                                                                        phi_2412_ = _e2232.x;
                                                                                    }
                                                                                    let _e2237 = phi_2412_;
                                                                                    if (_e2223 > _e2232.y) {
                                                                                        phi_2419_ = _e2223;
                                                                                    } else {
                                                                                        phi_2419_ = _e2232.y;
                                                                                    }
                                                                                    let _e2242 = phi_2419_;
                                                                                    if (_e2230 > _e2232.z) {
                                                                                        phi_2426_ = _e2230;
                                                                                    } else {
                                                                                        phi_2426_ = _e2232.z;
                                                                                    }
                                                                                    let _e2247 = phi_2426_;
                                                                                    let _e2251 = ((_e2195 - _e987) * _e1188);
                                                                                    let _e2252 = ((_e2200 - _e1000) * _e1198);
                                                                                    let _e2253 = ((_e2205 - _e1013) * _e1208);
                                                                                    let _e2257 = ((_e2237 - _e987) * _e1188);
                                                                                    let _e2258 = ((_e2242 - _e1000) * _e1198);
                                                                                    let _e2259 = ((_e2247 - _e1013) * _e1208);
                                                                                    if (_e2251 < _e2257) {
                                                                                        phi_2443_ = _e2251;
                                                                                    } else {
                                                                                        phi_2443_ = _e2257;
                                                                                    }
                                                                                    let _e2262 = phi_2443_;
                                                                                    if (_e2252 < _e2258) {
                                                                                        phi_2448_ = _e2252;
                                                                                    } else {
                                                                                        phi_2448_ = _e2258;
                                                                                    }
                                                                                    let _e2265 = phi_2448_;
                                                                                    if (_e2253 < _e2259) {
                                                                                        phi_2453_ = _e2253;
                                                                                    } else {
                                                                                        phi_2453_ = _e2259;
                                                                                    }
                                                                                    let _e2268 = phi_2453_;
                                                                                    if (_e2251 > _e2257) {
                                                                                        phi_2461_ = _e2251;
                                                                                    } else {
                                                                                        phi_2461_ = _e2257;
                                                                                    }
                                                                                    let _e2274 = phi_2461_;
                                                                                    if (_e2252 > _e2258) {
                                                                                        phi_2466_ = _e2252;
                                                                                    } else {
                                                                                        phi_2466_ = _e2258;
                                                                                    }
                                                                                    let _e2277 = phi_2466_;
                                                                                    if (_e2253 > _e2259) {
                                                                                        phi_2471_ = _e2253;
                                                                                    } else {
                                                                                        phi_2471_ = _e2259;
                                                                                    }
                                                                                    let _e2280 = phi_2471_;
                                                                                    let _e2284 = core_intrinsics_maximum_number_nsz_f32_((_e2262 - _e1247), (_e2265 - _e1248));
                                                                                    let _e2285 = core_intrinsics_maximum_number_nsz_f32_(_e2284, (_e2268 - _e1249));
                                                                                    let _e2286 = core_intrinsics_minimum_number_nsz_f32_((_e2274 + _e1247), (_e2277 + _e1248));
                                                                                    let _e2287 = core_intrinsics_minimum_number_nsz_f32_(_e2286, (_e2280 + _e1249));
                                                                                    if (_e2285 > _e968) {
                                                                                        phi_2483_ = _e2285;
                                                                                    } else {
                                                                                        phi_2483_ = _e968;
                                                                                    }
                                                                                    let _e2290 = phi_2483_;
                                                                                    if (_e2287 < _e970) {
                                                                                        phi_2488_ = _e2287;
                                                                                    } else {
                                                                                        phi_2488_ = _e970;
                                                                                    }
                                                                                    let _e2293 = phi_2488_;
                                                                                    if (_e2161 < _e2290) {
                                                                                        phi_2493_ = _e2290;
                                                                                    } else {
                                                                                        phi_2493_ = _e2161;
                                                                                    }
                                                                                    let _e2296 = phi_2493_;
                                                                                    if (_e2296 > _e2293) {
                                                                                        phi_2498_ = _e2293;
                                                                                    } else {
                                                                                        phi_2498_ = _e2296;
                                                                                    }
                                                                                    let _e2299 = phi_2498_;
                                                                                    phi_2503_ = lt_bvh_triangle_Intersection(_e2299, (_e2002 / _e2061), (_e2023 / _e2061), (_e2290 <= _e2293));
                                                                                    phi_2504_ = false;
                                                                                } else {
                                                                                    phi_2503_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2504_ = true;
                                                                                }
                                                                                let _e2305 = phi_2503_;
                                                                                let _e2307 = phi_2504_;
                                                                                phi_2505_ = _e2305;
                                                                                phi_2506_ = _e2307;
                                                                            } else {
                                                                                phi_2505_ = lt_bvh_triangle_Intersection();
                                                                                phi_2506_ = true;
                                                                            }
                                                                            let _e2309 = phi_2505_;
                                                                            let _e2311 = phi_2506_;
                                                                            if _e2311 {
                                                                            }
                                                                            phi_2510_ = _e2309;
                                                                            phi_2511_ = _e2311;
                                                                        }
                                                                        let _e2313 = phi_2510_;
                                                                        let _e2315 = phi_2511_;
                                                                        phi_2512_ = _e2313;
                                                                        phi_2513_ = _e2064;
                                                                        phi_2514_ = _e2315;
                                                                    } else {
                                                                        phi_2512_ = lt_bvh_triangle_Intersection();
                                                                        phi_2513_ = true;
                                                                        phi_2514_ = false;
                                                                    }
                                                                    let _e2317 = phi_2512_;
                                                                    let _e2319 = phi_2513_;
                                                                    let _e2321 = phi_2514_;
                                                                    if _e2319 {
                                                                        phi_2518_ = true;
                                                                    } else {
                                                                        phi_2518_ = _e2321;
                                                                    }
                                                                    let _e2323 = phi_2518_;
                                                                    if _e2323 {
                                                                        phi_2522_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2522_ = _e2317;
                                                                    }
                                                                    let _e2325 = phi_2522_;
                                                                    if _e2325.is_hit {
                                                                        if (_e2325.t > 0f) {
                                                                            if (_e2325.t < _e117) {
                                                                                if true {
                                                                                    phi_2542_ = false;
                                                                                } else {
                                                                                    phi_2542_ = true;
                                                                                }
                                                                                let _e2334 = phi_2542_;
                                                                                phi_2543_ = true;
                                                                                phi_2544_ = _e2334;
                                                                            } else {
                                                                                phi_2543_ = _e1868;
                                                                                phi_2544_ = true;
                                                                            }
                                                                            let _e2336 = phi_2543_;
                                                                            let _e2338 = phi_2544_;
                                                                            phi_2545_ = _e2336;
                                                                            phi_2546_ = _e2338;
                                                                        } else {
                                                                            phi_2545_ = _e1868;
                                                                            phi_2546_ = true;
                                                                        }
                                                                        let _e2340 = phi_2545_;
                                                                        let _e2342 = phi_2546_;
                                                                        phi_2547_ = _e2340;
                                                                        phi_2548_ = _e2342;
                                                                    } else {
                                                                        phi_2547_ = _e1868;
                                                                        phi_2548_ = true;
                                                                    }
                                                                    let _e2344 = phi_2547_;
                                                                    let _e2346 = phi_2548_;
                                                                    if _e2346 {
                                                                    }
                                                                    phi_1952_ = (_e1866 & (_e1866 - 1u));
                                                                    phi_1955_ = _e2344;
                                                                    phi_2552_ = _e2346;
                                                                }
                                                                let _e2348 = phi_1952_;
                                                                let _e2350 = phi_1955_;
                                                                let _e2352 = phi_2552_;
                                                                continue;
                                                                continuing {
                                                                    phi_1951_ = _e2348;
                                                                    phi_1954_ = _e2350;
                                                                    break if !(_e2352);
                                                                }
                                                            }
                                                            let _e2355 = local_8;
                                                            if _e2355 {
                                                                let _e2357 = local.group_mask;
                                                                if ((_e2357 & 4278190080u) == 0u) {
                                                                    let _e2361 = local.len;
                                                                    if (_e2361 == 0u) {
                                                                        phi_2594_ = false;
                                                                    } else {
                                                                        let _e2365 = local.len;
                                                                        local.len = (_e2365 - 1u);
                                                                        let _e2368 = local.len;
                                                                        if (_e2368 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2373 = local.first[(0u + _e2368)];
                                                                        local.group = _e2373;
                                                                        let _e2376 = local.len;
                                                                        if (_e2376 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2381 = local.mask[(0u + _e2376)];
                                                                        local.group_mask = _e2381;
                                                                        phi_2594_ = true;
                                                                    }
                                                                    let _e2384 = phi_2594_;
                                                                    phi_2595_ = _e2384;
                                                                } else {
                                                                    phi_2595_ = true;
                                                                }
                                                                let _e2386 = phi_2595_;
                                                                if _e2386 {
                                                                    let _e2388 = local.group_mask;
                                                                    let _e2394 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2388)), 32u, (_e2388 == 0u)));
                                                                    let _e2398 = local.group_mask;
                                                                    let _e2412 = local.group_mask;
                                                                    local.group_mask = (_e2412 & ~((1u << bitcast<u32>((_e2394 & 31u)))));
                                                                    let _e2415 = local.group;
                                                                    phi_2626_ = (_e2415 + countOneBits(((_e2398 & ~((4294967295u << bitcast<u32>((((_e2394 - 24u) ^ _e1290) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2626_ = 4294967295u;
                                                                }
                                                                let _e2418 = phi_2626_;
                                                                phi_2627_ = _e2418;
                                                            } else {
                                                                phi_2627_ = u32();
                                                            }
                                                            let _e2420 = phi_2627_;
                                                            phi_1620_ = _e2420;
                                                            let _e2796 = local_12;
                                                            phi_1623_ = _e2796;
                                                            let _e2799 = local_13;
                                                            phi_2628_ = _e2799;
                                                            phi_2629_ = false;
                                                        } else {
                                                            phi_1620_ = u32();
                                                            phi_1623_ = bool();
                                                            phi_2628_ = false;
                                                            phi_2629_ = true;
                                                        }
                                                        let _e2422 = phi_1620_;
                                                        let _e2424 = phi_1623_;
                                                        let _e2426 = phi_2628_;
                                                        let _e2428 = phi_2629_;
                                                        local_9 = _e2428;
                                                        continue;
                                                        continuing {
                                                            phi_1619_ = _e2422;
                                                            phi_1622_ = _e2424;
                                                            break if !(_e2426);
                                                        }
                                                    }
                                                    let _e2431 = local_9;
                                                    if _e2431 {
                                                        phi_2633_ = false;
                                                    } else {
                                                        phi_2633_ = true;
                                                    }
                                                    let _e2433 = phi_2633_;
                                                    if _e2433 {
                                                        phi_2637_ = true;
                                                    } else {
                                                        let _e2805 = local_14;
                                                        phi_2637_ = _e2805;
                                                    }
                                                    let _e2435 = phi_2637_;
                                                    phi_2638_ = _e2435;
                                                }
                                                let _e2437 = phi_2638_;
                                                phi_2639_ = _e2437;
                                                phi_2640_ = _e1112;
                                            } else {
                                                phi_2639_ = bool();
                                                phi_2640_ = true;
                                            }
                                            let _e2439 = phi_2639_;
                                            let _e2441 = phi_2640_;
                                            if _e2441 {
                                                phi_2644_ = _e907;
                                            } else {
                                                phi_2644_ = _e2439;
                                            }
                                            let _e2443 = phi_2644_;
                                            if _e2443 {
                                                phi_2648_ = false;
                                            } else {
                                                phi_2648_ = true;
                                            }
                                            let _e2445 = phi_2648_;
                                            phi_2649_ = _e2443;
                                            phi_2650_ = _e2445;
                                        } else {
                                            phi_2649_ = _e907;
                                            phi_2650_ = true;
                                        }
                                        let _e2447 = phi_2649_;
                                        let _e2449 = phi_2650_;
                                        phi_2651_ = _e2447;
                                        phi_2652_ = _e2449;
                                    } else {
                                        phi_2651_ = _e907;
                                        phi_2652_ = true;
                                    }
                                    let _e2451 = phi_2651_;
                                    let _e2453 = phi_2652_;
                                    phi_2653_ = _e2451;
                                    phi_2654_ = _e2453;
                                } else {
                                    phi_2653_ = _e907;
                                    phi_2654_ = true;
                                }
                                let _e2455 = phi_2653_;
                                let _e2457 = phi_2654_;
                                if _e2457 {
                                }
                                phi_1005_ = (_e905 & (_e905 - 1u));
                                phi_1008_ = _e2455;
                                phi_2658_ = _e2457;
                            }
                            let _e2459 = phi_1005_;
                            let _e2461 = phi_1008_;
                            let _e2463 = phi_2658_;
                            continue;
                            continuing {
                                phi_1004_ = _e2459;
                                phi_1007_ = _e2461;
                                break if !(_e2463);
                            }
                        }
                        let _e2466 = local_10;
                        if _e2466 {
                            let _e2468 = local_1.group_mask;
                            if ((_e2468 & 4278190080u) == 0u) {
                                let _e2472 = local_1.len;
                                if (_e2472 == 0u) {
                                    phi_2700_ = false;
                                } else {
                                    let _e2476 = local_1.len;
                                    local_1.len = (_e2476 - 1u);
                                    let _e2479 = local_1.len;
                                    if (_e2479 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2484 = local_1.first[(0u + _e2479)];
                                    local_1.group = _e2484;
                                    let _e2487 = local_1.len;
                                    if (_e2487 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2492 = local_1.mask[(0u + _e2487)];
                                    local_1.group_mask = _e2492;
                                    phi_2700_ = true;
                                }
                                let _e2495 = phi_2700_;
                                phi_2701_ = _e2495;
                            } else {
                                phi_2701_ = true;
                            }
                            let _e2497 = phi_2701_;
                            if _e2497 {
                                let _e2499 = local_1.group_mask;
                                let _e2505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2499)), 32u, (_e2499 == 0u)));
                                let _e2509 = local_1.group_mask;
                                let _e2523 = local_1.group_mask;
                                local_1.group_mask = (_e2523 & ~((1u << bitcast<u32>((_e2505 & 31u)))));
                                let _e2526 = local_1.group;
                                phi_2732_ = (_e2526 + countOneBits(((_e2509 & ~((4294967295u << bitcast<u32>((((_e2505 - 24u) ^ _e329) & 31u))))) & 255u)));
                            } else {
                                phi_2732_ = 4294967295u;
                            }
                            let _e2529 = phi_2732_;
                            phi_2733_ = _e2529;
                        } else {
                            phi_2733_ = u32();
                        }
                        let _e2531 = phi_2733_;
                        phi_673_ = _e2531;
                        let _e2828 = local_15;
                        phi_676_ = _e2828;
                        let _e2831 = local_16;
                        phi_2734_ = _e2831;
                        phi_2735_ = false;
                    } else {
                        phi_673_ = u32();
                        phi_676_ = bool();
                        phi_2734_ = false;
                        phi_2735_ = true;
                    }
                    let _e2533 = phi_673_;
                    let _e2535 = phi_676_;
                    let _e2537 = phi_2734_;
                    let _e2539 = phi_2735_;
                    local_11 = _e2539;
                    continue;
                    continuing {
                        phi_672_ = _e2533;
                        phi_675_ = _e2535;
                        break if !(_e2537);
                    }
                }
                let _e2542 = local_11;
                if _e2542 {
                    phi_2739_ = false;
                } else {
                    phi_2739_ = true;
                }
                let _e2544 = phi_2739_;
                if _e2544 {
                }
                phi_2743_ = _e2544;
            }
            let _e2546 = phi_2743_;
            phi_2744_ = _e181;
            phi_2745_ = _e2546;
        } else {
            phi_2744_ = true;
            phi_2745_ = false;
        }
        let _e2548 = phi_2744_;
        let _e2550 = phi_2745_;
        if _e2548 {
            phi_2749_ = false;
            phi_2750_ = true;
        } else {
            phi_2749_ = true;
            phi_2750_ = _e2550;
        }
        let _e2552 = phi_2749_;
        let _e2554 = phi_2750_;
        if _e2554 {
            phi_2754_ = _e2552;
        } else {
            phi_2754_ = false;
        }
        let _e2556 = phi_2754_;
        if _e2556 {
            phi_2758_ = 0f;
        } else {
            phi_2758_ = 1f;
        }
        let _e2558 = phi_2758_;
        if (_e85 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e85)] = _e2558;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
