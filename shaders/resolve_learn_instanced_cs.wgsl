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
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;
@group(0) @binding(7) 
var<storage> instances: type_50;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_173_: bool;
    var phi_177_: f32;

    if (param != param) {
        phi_173_ = true;
    } else {
        let _e57 = (param_1 >= param);
        if _e57 {
        }
        phi_173_ = _e57;
    }
    let _e59 = phi_173_;
    if _e59 {
        phi_177_ = param_1;
    } else {
        phi_177_ = param;
    }
    let _e61 = phi_177_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_189_: bool;
    var phi_193_: f32;

    if (param_2 != param_2) {
        phi_189_ = true;
    } else {
        let _e57 = (param_3 <= param_2);
        if _e57 {
        }
        phi_189_ = _e57;
    }
    let _e59 = phi_189_;
    if _e59 {
        phi_193_ = param_3;
    } else {
        phi_193_ = param_2;
    }
    let _e61 = phi_193_;
    return _e61;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_278_: f32;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_317_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_337_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_364_: bool;
    var phi_434_: f32;
    var phi_441_: f32;
    var phi_448_: f32;
    var phi_455_: f32;
    var phi_462_: f32;
    var phi_469_: f32;
    var phi_486_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_506_: f32;
    var phi_525_: u32;
    var phi_530_: u32;
    var phi_535_: u32;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_681_: u32;
    var phi_683_: u32;
    var phi_686_: bool;
    var phi_766_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_793_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_820_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_826_: u32;
    var phi_829_: u32;
    var phi_843_: u32;
    var phi_853_: u32;
    var phi_863_: u32;
    var phi_881_: u32;
    var phi_891_: u32;
    var phi_901_: u32;
    var phi_937_: u32;
    var phi_950_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_827_: u32;
    var phi_830_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1015_: u32;
    var phi_1018_: bool;
    var phi_1067_: f32;
    var phi_1072_: f32;
    var phi_1077_: f32;
    var phi_1085_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1222_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1242_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1269_: bool;
    var phi_1339_: f32;
    var phi_1346_: f32;
    var phi_1353_: f32;
    var phi_1360_: f32;
    var phi_1367_: f32;
    var phi_1374_: f32;
    var phi_1391_: f32;
    var phi_1396_: f32;
    var phi_1401_: f32;
    var phi_1406_: f32;
    var phi_1411_: f32;
    var phi_1437_: bool;
    var phi_1438_: bool;
    var phi_1446_: u32;
    var phi_1447_: u32;
    var phi_1458_: vec3<f32>;
    var phi_1459_: vec3<f32>;
    var phi_1472_: u32;
    var phi_1477_: u32;
    var phi_1482_: u32;
    var phi_1596_: bool;
    var phi_1597_: bool;
    var phi_1628_: u32;
    var phi_1630_: u32;
    var phi_1633_: bool;
    var phi_1713_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1740_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1767_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1773_: u32;
    var phi_1776_: u32;
    var phi_1790_: u32;
    var phi_1800_: u32;
    var phi_1810_: u32;
    var phi_1828_: u32;
    var phi_1838_: u32;
    var phi_1848_: u32;
    var phi_1884_: u32;
    var phi_1897_: u32;
    var phi_1902_: u32;
    var phi_1903_: u32;
    var phi_1904_: u32;
    var phi_1774_: u32;
    var phi_1777_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1962_: u32;
    var phi_1965_: bool;
    var phi_2009_: vec3<f32>;
    var phi_2010_: vec3<f32>;
    var phi_2039_: vec3<f32>;
    var phi_2040_: vec3<f32>;
    var phi_2069_: vec3<f32>;
    var phi_2070_: vec3<f32>;
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
    var phi_2233_: vec3<f32>;
    var phi_2234_: vec3<f32>;
    var phi_2259_: vec3<f32>;
    var phi_2260_: vec3<f32>;
    var phi_2285_: vec3<f32>;
    var phi_2286_: vec3<f32>;
    var phi_2342_: f32;
    var phi_2351_: f32;
    var phi_2360_: f32;
    var phi_2369_: f32;
    var phi_2376_: f32;
    var phi_2383_: f32;
    var phi_2396_: f32;
    var phi_2405_: f32;
    var phi_2414_: f32;
    var phi_2423_: f32;
    var phi_2430_: f32;
    var phi_2437_: f32;
    var phi_2454_: f32;
    var phi_2459_: f32;
    var phi_2464_: f32;
    var phi_2472_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2494_: f32;
    var phi_2499_: f32;
    var phi_2504_: f32;
    var phi_2509_: f32;
    var phi_2514_: lt_bvh_triangle_Intersection;
    var phi_2515_: bool;
    var phi_2516_: lt_bvh_triangle_Intersection;
    var phi_2517_: bool;
    var phi_2521_: lt_bvh_triangle_Intersection;
    var phi_2522_: bool;
    var phi_2523_: lt_bvh_triangle_Intersection;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2529_: bool;
    var phi_2533_: lt_bvh_triangle_Intersection;
    var phi_2553_: bool;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_1963_: u32;
    var phi_1966_: bool;
    var phi_2563_: bool;
    var local_8: bool;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var phi_2637_: u32;
    var phi_2638_: u32;
    var phi_1631_: u32;
    var phi_1634_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var local_9: bool;
    var phi_2644_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2655_: bool;
    var phi_2659_: bool;
    var phi_2660_: bool;
    var phi_2661_: bool;
    var phi_2662_: bool;
    var phi_2663_: bool;
    var phi_2664_: bool;
    var phi_2665_: bool;
    var phi_1016_: u32;
    var phi_1019_: bool;
    var phi_2669_: bool;
    var local_10: bool;
    var phi_2711_: bool;
    var phi_2712_: bool;
    var phi_2743_: u32;
    var phi_2744_: u32;
    var phi_684_: u32;
    var phi_687_: bool;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var local_11: bool;
    var phi_2750_: bool;
    var phi_2754_: bool;
    var phi_2755_: bool;
    var phi_2756_: bool;
    var phi_2760_: bool;
    var phi_2761_: bool;
    var phi_2765_: bool;
    var phi_2769_: f32;
    var phi_2810_: u32;
    var phi_2829_: u32;
    var phi_2837_: u32;
    var phi_2845_: u32;
    var phi_2850_: u32;
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
            phi_278_ = 300000000000000000000000000000000000000f;
        } else {
            phi_278_ = 1f;
        }
        let _e123 = phi_278_;
        let _e131 = (_e119.x - (_e113 * _e119.w));
        let _e132 = (_e119.y - (_e115 * _e119.w));
        let _e133 = (_e119.z - (_e117 * _e119.w));
        let _e134 = abs(_e131);
        let _e135 = abs(_e132);
        let _e136 = abs(_e133);
        if (abs(_e113) < 1000000000000000f) {
            if (abs(_e115) < 1000000000000000f) {
                phi_310_ = (abs(_e117) < 1000000000000000f);
                phi_311_ = false;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
            }
            let _e144 = phi_310_;
            let _e146 = phi_311_;
            phi_312_ = _e144;
            phi_313_ = _e146;
        } else {
            phi_312_ = bool();
            phi_313_ = true;
        }
        let _e148 = phi_312_;
        let _e150 = phi_313_;
        if _e150 {
            phi_317_ = false;
        } else {
            phi_317_ = _e148;
        }
        let _e152 = phi_317_;
        if _e152 {
            if (_e134 < 1000000000000000f) {
                if (_e135 < 1000000000000000f) {
                    phi_330_ = (_e136 < 1000000000000000f);
                    phi_331_ = false;
                } else {
                    phi_330_ = bool();
                    phi_331_ = true;
                }
                let _e157 = phi_330_;
                let _e159 = phi_331_;
                phi_332_ = _e157;
                phi_333_ = _e159;
            } else {
                phi_332_ = bool();
                phi_333_ = true;
            }
            let _e161 = phi_332_;
            let _e163 = phi_333_;
            if _e163 {
                phi_337_ = false;
            } else {
                phi_337_ = _e161;
            }
            let _e165 = phi_337_;
            if _e165 {
                if (_e134 > 0f) {
                    phi_351_ = bool();
                    phi_352_ = true;
                } else {
                    let _e167 = (_e135 > 0f);
                    if _e167 {
                        phi_350_ = bool();
                    } else {
                        phi_350_ = (_e136 > 0f);
                    }
                    let _e170 = phi_350_;
                    phi_351_ = _e170;
                    phi_352_ = _e167;
                }
                let _e172 = phi_351_;
                let _e174 = phi_352_;
                if _e174 {
                    phi_356_ = true;
                } else {
                    phi_356_ = _e172;
                }
                let _e176 = phi_356_;
                phi_357_ = _e176;
                phi_358_ = false;
            } else {
                phi_357_ = bool();
                phi_358_ = true;
            }
            let _e178 = phi_357_;
            let _e180 = phi_358_;
            phi_359_ = _e178;
            phi_360_ = _e180;
        } else {
            phi_359_ = bool();
            phi_360_ = true;
        }
        let _e182 = phi_359_;
        let _e184 = phi_360_;
        if _e184 {
            phi_364_ = false;
        } else {
            phi_364_ = _e182;
        }
        let _e186 = phi_364_;
        if _e186 {
            let _e187 = (_e93 >= _e63);
            if _e187 {
                phi_2754_ = false;
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
                    phi_434_ = _e253;
                } else {
                    phi_434_ = abs(_e131);
                }
                let _e258 = phi_434_;
                if (_e131 < 0f) {
                    phi_441_ = (-1f / _e258);
                } else {
                    phi_441_ = (1f / _e258);
                }
                let _e263 = phi_441_;
                if (abs(_e132) < _e253) {
                    phi_448_ = _e253;
                } else {
                    phi_448_ = abs(_e132);
                }
                let _e268 = phi_448_;
                if (_e132 < 0f) {
                    phi_455_ = (-1f / _e268);
                } else {
                    phi_455_ = (1f / _e268);
                }
                let _e273 = phi_455_;
                if (abs(_e133) < _e253) {
                    phi_462_ = _e253;
                } else {
                    phi_462_ = abs(_e133);
                }
                let _e278 = phi_462_;
                if (_e133 < 0f) {
                    phi_469_ = (-1f / _e278);
                } else {
                    phi_469_ = (1f / _e278);
                }
                let _e283 = phi_469_;
                let _e287 = abs((bitcast<f32>(_e193) - _e113));
                let _e288 = abs((bitcast<f32>(_e197) - _e115));
                let _e289 = abs((bitcast<f32>(_e201) - _e117));
                let _e293 = abs(((bitcast<f32>(_e205) + (bitcast<f32>((((_e217 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                let _e294 = abs(((bitcast<f32>(_e209) + (bitcast<f32>((((_e217 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e115));
                let _e295 = abs(((bitcast<f32>(_e213) + (bitcast<f32>((((_e217 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e117));
                if (_e287 > _e293) {
                    phi_486_ = _e287;
                } else {
                    phi_486_ = _e293;
                }
                let _e298 = phi_486_;
                if (_e288 > _e294) {
                    phi_491_ = _e288;
                } else {
                    phi_491_ = _e294;
                }
                let _e301 = phi_491_;
                if (_e289 > _e295) {
                    phi_496_ = _e289;
                } else {
                    phi_496_ = _e295;
                }
                let _e304 = phi_496_;
                if (_e298 > _e301) {
                    phi_501_ = _e298;
                } else {
                    phi_501_ = _e301;
                }
                let _e307 = phi_501_;
                if (_e307 > _e304) {
                    phi_506_ = _e307;
                } else {
                    phi_506_ = _e304;
                }
                let _e310 = phi_506_;
                let _e314 = (_e310 * 0.0000019073486f);
                let _e315 = (abs(_e263) * _e314);
                let _e316 = (abs(_e273) * _e314);
                let _e317 = (abs(_e283) * _e314);
                let _e321 = (_e310 * 0.0000009536743f);
                let _e322 = (abs(_e263) * _e321);
                let _e323 = (abs(_e273) * _e321);
                let _e324 = (abs(_e283) * _e321);
                if (_e263 < 0f) {
                    phi_525_ = 0u;
                } else {
                    phi_525_ = 1u;
                }
                let _e327 = phi_525_;
                if (_e273 < 0f) {
                    phi_530_ = 0u;
                } else {
                    phi_530_ = 2u;
                }
                let _e330 = phi_530_;
                if (_e283 < 0f) {
                    phi_535_ = 0u;
                } else {
                    phi_535_ = 4u;
                }
                let _e333 = phi_535_;
                let _e335 = ((_e327 | _e330) | _e333);
                let _e336 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e93, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e336.first[0], _e336.first[1], _e336.first[2], _e336.first[3], _e336.first[4], _e336.first[5], _e336.first[6], _e336.first[7], _e336.first[8], _e336.first[9], _e336.first[10], _e336.first[11], _e336.first[12], _e336.first[13], _e336.first[14], _e336.first[15], _e336.first[16], _e336.first[17], _e336.first[18], _e336.first[19], _e336.first[20], _e336.first[21], _e336.first[22], _e336.first[23], _e336.first[24], _e336.first[25], _e336.first[26], _e336.first[27], _e336.first[28], _e336.first[29], _e336.first[30], _e336.first[31]), array<u32, 32>(_e336.mask[0], _e336.mask[1], _e336.mask[2], _e336.mask[3], _e336.mask[4], _e336.mask[5], _e336.mask[6], _e336.mask[7], _e336.mask[8], _e336.mask[9], _e336.mask[10], _e336.mask[11], _e336.mask[12], _e336.mask[13], _e336.mask[14], _e336.mask[15], _e336.mask[16], _e336.mask[17], _e336.mask[18], _e336.mask[19], _e336.mask[20], _e336.mask[21], _e336.mask[22], _e336.mask[23], _e336.mask[24], _e336.mask[25], _e336.mask[26], _e336.mask[27], _e336.mask[28], _e336.mask[29], _e336.mask[30], _e336.mask[31]), _e336.len, _e336.group, _e336.group_mask);
                let _e410 = local_1.group_mask;
                if ((_e410 & 4278190080u) == 0u) {
                    let _e414 = local_1.len;
                    if (_e414 == 0u) {
                        phi_649_ = false;
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
                        phi_649_ = true;
                    }
                    let _e437 = phi_649_;
                    phi_650_ = _e437;
                } else {
                    phi_650_ = true;
                }
                let _e439 = phi_650_;
                if _e439 {
                    let _e441 = local_1.group_mask;
                    let _e447 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e441)), 32u, (_e441 == 0u)));
                    let _e451 = local_1.group_mask;
                    let _e465 = local_1.group_mask;
                    local_1.group_mask = (_e465 & ~((1u << bitcast<u32>((_e447 & 31u)))));
                    let _e468 = local_1.group;
                    phi_681_ = (_e468 + countOneBits(((_e451 & ~((4294967295u << bitcast<u32>((((_e447 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_681_ = 4294967295u;
                }
                let _e471 = phi_681_;
                phi_683_ = _e471;
                phi_686_ = false;
                loop {
                    let _e473 = phi_683_;
                    let _e475 = phi_686_;
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
                            let _e546 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e535.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e546.unnamed.root, _e535.w), _e546.unnamed_1);
                            let _e558 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e552.unnamed, lt_bvh_traverse_Tree(_e535.x, _e552.unnamed_1.first_primitive));
                            phi_766_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e558.unnamed, lt_bvh_traverse_Tree(_e558.unnamed_1.root, _e535.y));
                        } else {
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e535.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e574.unnamed.root, _e535.y), _e574.unnamed_1);
                            let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_bvh_traverse_Tree(_e535.z, _e580.unnamed_1.first_primitive));
                            phi_766_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e586.unnamed, lt_bvh_traverse_Tree(_e586.unnamed_1.root, _e535.w));
                        }
                        let _e594 = phi_766_;
                        let _e604 = nodes.member[(0u + _e473)].y;
                        if (_e273 < 0f) {
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e615.unnamed.root, _e604.w), _e615.unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_bvh_traverse_Tree(_e604.x, _e621.unnamed_1.first_primitive));
                            phi_793_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_bvh_traverse_Tree(_e627.unnamed_1.root, _e604.y));
                        } else {
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e643.unnamed.root, _e604.y), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e604.z, _e649.unnamed_1.first_primitive));
                            phi_793_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e655.unnamed_1.root, _e604.w));
                        }
                        let _e663 = phi_793_;
                        let _e673 = nodes.member[(0u + _e473)].z;
                        if (_e283 < 0f) {
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e684.unnamed.root, _e673.w), _e684.unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e673.x, _e690.unnamed_1.first_primitive));
                            phi_820_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e696.unnamed_1.root, _e673.y));
                        } else {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.unnamed.root, _e673.y), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e673.z, _e718.unnamed_1.first_primitive));
                            phi_820_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e724.unnamed_1.root, _e673.w));
                        }
                        let _e732 = phi_820_;
                        phi_826_ = 0u;
                        phi_829_ = 0u;
                        loop {
                            let _e742 = phi_826_;
                            let _e744 = phi_829_;
                            local_2 = _e744;
                            local_3 = _e744;
                            local_4 = _e744;
                            let _e745 = (_e742 < 8u);
                            if _e745 {
                                let _e747 = (_e742 >> bitcast<u32>(2i));
                                let _e748 = (_e742 & 3u);
                                if (_e747 == 0u) {
                                    phi_843_ = _e594.unnamed.root;
                                } else {
                                    phi_843_ = _e594.unnamed.first_primitive;
                                }
                                let _e751 = phi_843_;
                                if (_e747 == 0u) {
                                    phi_853_ = _e663.unnamed.root;
                                } else {
                                    phi_853_ = _e663.unnamed.first_primitive;
                                }
                                let _e760 = phi_853_;
                                if (_e747 == 0u) {
                                    phi_863_ = _e732.unnamed.root;
                                } else {
                                    phi_863_ = _e732.unnamed.first_primitive;
                                }
                                let _e769 = phi_863_;
                                let _e782 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e751 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e315)), ((f32(((_e760 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 - _e316)));
                                let _e783 = core_intrinsics_maximum_number_nsz_f32_(_e782, ((f32(((_e769 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e317)));
                                if (_e747 == 0u) {
                                    phi_881_ = _e594.unnamed_1.root;
                                } else {
                                    phi_881_ = _e594.unnamed_1.first_primitive;
                                }
                                let _e786 = phi_881_;
                                if (_e747 == 0u) {
                                    phi_891_ = _e663.unnamed_1.root;
                                } else {
                                    phi_891_ = _e663.unnamed_1.first_primitive;
                                }
                                let _e795 = phi_891_;
                                if (_e747 == 0u) {
                                    phi_901_ = _e732.unnamed_1.root;
                                } else {
                                    phi_901_ = _e732.unnamed_1.first_primitive;
                                }
                                let _e804 = phi_901_;
                                let _e817 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e786 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e315)), ((f32(((_e795 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 + _e316)));
                                let _e818 = core_intrinsics_minimum_number_nsz_f32_(_e817, ((f32(((_e804 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e317)));
                                if (_e783 <= _e818) {
                                    if (_e783 <= _e123) {
                                        if (_e818 >= 0f) {
                                            if (_e747 == 0u) {
                                                let _e825 = nodes.member[(0u + _e473)].links[2u];
                                                phi_937_ = _e825;
                                            } else {
                                                let _e828 = nodes.member[(0u + _e473)].links[3u];
                                                phi_937_ = _e828;
                                            }
                                            let _e830 = phi_937_;
                                            let _e835 = ((_e830 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u);
                                            let _e836 = (_e835 & 31u);
                                            if (_e836 >= 24u) {
                                                phi_950_ = (24u + ((_e836 - 24u) ^ _e335));
                                            } else {
                                                phi_950_ = _e836;
                                            }
                                            let _e842 = phi_950_;
                                            phi_955_ = (_e744 | ((_e835 >> bitcast<u32>(5i)) << bitcast<u32>((_e842 & 31u))));
                                        } else {
                                            phi_955_ = _e744;
                                        }
                                        let _e850 = phi_955_;
                                        phi_956_ = _e850;
                                    } else {
                                        phi_956_ = _e744;
                                    }
                                    let _e852 = phi_956_;
                                    phi_957_ = _e852;
                                } else {
                                    phi_957_ = _e744;
                                }
                                let _e854 = phi_957_;
                                phi_827_ = (_e742 + 1u);
                                phi_830_ = _e854;
                            } else {
                                phi_827_ = u32();
                                phi_830_ = u32();
                            }
                            let _e857 = phi_827_;
                            let _e859 = phi_830_;
                            continue;
                            continuing {
                                phi_826_ = _e857;
                                phi_829_ = _e859;
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
                        phi_1015_ = (_e908 & 16777215u);
                        phi_1018_ = _e475;
                        loop {
                            let _e911 = phi_1015_;
                            let _e913 = phi_1018_;
                            local_15 = _e913;
                            let _e914 = (_e911 == 0u);
                            local_10 = _e914;
                            local_16 = _e914;
                            if _e914 {
                                phi_1016_ = u32();
                                phi_1019_ = bool();
                                phi_2669_ = false;
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
                                    phi_1067_ = _e937;
                                } else {
                                    phi_1067_ = _e946;
                                }
                                let _e951 = phi_1067_;
                                if (_e938 < _e947) {
                                    phi_1072_ = _e938;
                                } else {
                                    phi_1072_ = _e947;
                                }
                                let _e954 = phi_1072_;
                                if (_e939 < _e948) {
                                    phi_1077_ = _e939;
                                } else {
                                    phi_1077_ = _e948;
                                }
                                let _e957 = phi_1077_;
                                if (_e937 > _e946) {
                                    phi_1085_ = _e937;
                                } else {
                                    phi_1085_ = _e946;
                                }
                                let _e963 = phi_1085_;
                                if (_e938 > _e947) {
                                    phi_1090_ = _e938;
                                } else {
                                    phi_1090_ = _e947;
                                }
                                let _e966 = phi_1090_;
                                if (_e939 > _e948) {
                                    phi_1095_ = _e939;
                                } else {
                                    phi_1095_ = _e948;
                                }
                                let _e969 = phi_1095_;
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
                                                    phi_1215_ = (abs(_e1019) < 1000000000000000f);
                                                    phi_1216_ = false;
                                                } else {
                                                    phi_1215_ = bool();
                                                    phi_1216_ = true;
                                                }
                                                let _e1075 = phi_1215_;
                                                let _e1077 = phi_1216_;
                                                phi_1217_ = _e1075;
                                                phi_1218_ = _e1077;
                                            } else {
                                                phi_1217_ = bool();
                                                phi_1218_ = true;
                                            }
                                            let _e1079 = phi_1217_;
                                            let _e1081 = phi_1218_;
                                            if _e1081 {
                                                phi_1222_ = false;
                                            } else {
                                                phi_1222_ = _e1079;
                                            }
                                            let _e1083 = phi_1222_;
                                            if _e1083 {
                                                if (_e1065 < 1000000000000000f) {
                                                    if (_e1066 < 1000000000000000f) {
                                                        phi_1235_ = (_e1067 < 1000000000000000f);
                                                        phi_1236_ = false;
                                                    } else {
                                                        phi_1235_ = bool();
                                                        phi_1236_ = true;
                                                    }
                                                    let _e1088 = phi_1235_;
                                                    let _e1090 = phi_1236_;
                                                    phi_1237_ = _e1088;
                                                    phi_1238_ = _e1090;
                                                } else {
                                                    phi_1237_ = bool();
                                                    phi_1238_ = true;
                                                }
                                                let _e1092 = phi_1237_;
                                                let _e1094 = phi_1238_;
                                                if _e1094 {
                                                    phi_1242_ = false;
                                                } else {
                                                    phi_1242_ = _e1092;
                                                }
                                                let _e1096 = phi_1242_;
                                                if _e1096 {
                                                    if (_e1065 > 0f) {
                                                        phi_1256_ = bool();
                                                        phi_1257_ = true;
                                                    } else {
                                                        let _e1098 = (_e1066 > 0f);
                                                        if _e1098 {
                                                            phi_1255_ = bool();
                                                        } else {
                                                            phi_1255_ = (_e1067 > 0f);
                                                        }
                                                        let _e1101 = phi_1255_;
                                                        phi_1256_ = _e1101;
                                                        phi_1257_ = _e1098;
                                                    }
                                                    let _e1103 = phi_1256_;
                                                    let _e1105 = phi_1257_;
                                                    if _e1105 {
                                                        phi_1261_ = true;
                                                    } else {
                                                        phi_1261_ = _e1103;
                                                    }
                                                    let _e1107 = phi_1261_;
                                                    phi_1262_ = _e1107;
                                                    phi_1263_ = false;
                                                } else {
                                                    phi_1262_ = bool();
                                                    phi_1263_ = true;
                                                }
                                                let _e1109 = phi_1262_;
                                                let _e1111 = phi_1263_;
                                                phi_1264_ = _e1109;
                                                phi_1265_ = _e1111;
                                            } else {
                                                phi_1264_ = bool();
                                                phi_1265_ = true;
                                            }
                                            let _e1113 = phi_1264_;
                                            let _e1115 = phi_1265_;
                                            if _e1115 {
                                                phi_1269_ = false;
                                            } else {
                                                phi_1269_ = _e1113;
                                            }
                                            let _e1117 = phi_1269_;
                                            if _e1117 {
                                                let _e1118 = (_e1062 >= _e63);
                                                if _e1118 {
                                                    phi_2649_ = bool();
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
                                                        phi_1339_ = _e1184;
                                                    } else {
                                                        phi_1339_ = abs(_e1033);
                                                    }
                                                    let _e1189 = phi_1339_;
                                                    if (_e1033 < 0f) {
                                                        phi_1346_ = (-1f / _e1189);
                                                    } else {
                                                        phi_1346_ = (1f / _e1189);
                                                    }
                                                    let _e1194 = phi_1346_;
                                                    if (abs(_e1046) < _e1184) {
                                                        phi_1353_ = _e1184;
                                                    } else {
                                                        phi_1353_ = abs(_e1046);
                                                    }
                                                    let _e1199 = phi_1353_;
                                                    if (_e1046 < 0f) {
                                                        phi_1360_ = (-1f / _e1199);
                                                    } else {
                                                        phi_1360_ = (1f / _e1199);
                                                    }
                                                    let _e1204 = phi_1360_;
                                                    if (abs(_e1059) < _e1184) {
                                                        phi_1367_ = _e1184;
                                                    } else {
                                                        phi_1367_ = abs(_e1059);
                                                    }
                                                    let _e1209 = phi_1367_;
                                                    if (_e1059 < 0f) {
                                                        phi_1374_ = (-1f / _e1209);
                                                    } else {
                                                        phi_1374_ = (1f / _e1209);
                                                    }
                                                    let _e1214 = phi_1374_;
                                                    let _e1218 = abs((bitcast<f32>(_e1124) - _e993));
                                                    let _e1219 = abs((bitcast<f32>(_e1128) - _e1006));
                                                    let _e1220 = abs((bitcast<f32>(_e1132) - _e1019));
                                                    let _e1224 = abs(((bitcast<f32>(_e1136) + (bitcast<f32>((((_e1148 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e993));
                                                    let _e1225 = abs(((bitcast<f32>(_e1140) + (bitcast<f32>((((_e1148 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1006));
                                                    let _e1226 = abs(((bitcast<f32>(_e1144) + (bitcast<f32>((((_e1148 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1019));
                                                    if (_e1218 > _e1224) {
                                                        phi_1391_ = _e1218;
                                                    } else {
                                                        phi_1391_ = _e1224;
                                                    }
                                                    let _e1229 = phi_1391_;
                                                    if (_e1219 > _e1225) {
                                                        phi_1396_ = _e1219;
                                                    } else {
                                                        phi_1396_ = _e1225;
                                                    }
                                                    let _e1232 = phi_1396_;
                                                    if (_e1220 > _e1226) {
                                                        phi_1401_ = _e1220;
                                                    } else {
                                                        phi_1401_ = _e1226;
                                                    }
                                                    let _e1235 = phi_1401_;
                                                    if (_e1229 > _e1232) {
                                                        phi_1406_ = _e1229;
                                                    } else {
                                                        phi_1406_ = _e1232;
                                                    }
                                                    let _e1238 = phi_1406_;
                                                    if (_e1238 > _e1235) {
                                                        phi_1411_ = _e1238;
                                                    } else {
                                                        phi_1411_ = _e1235;
                                                    }
                                                    let _e1241 = phi_1411_;
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
                                                            phi_1437_ = false;
                                                        } else {
                                                            phi_1437_ = true;
                                                        }
                                                        let _e1262 = phi_1437_;
                                                        phi_1438_ = _e1262;
                                                    } else {
                                                        phi_1438_ = true;
                                                    }
                                                    let _e1264 = phi_1438_;
                                                    if _e1264 {
                                                        if (_e1257 >= _e1258) {
                                                            phi_1446_ = 1u;
                                                        } else {
                                                            phi_1446_ = 2u;
                                                        }
                                                        let _e1267 = phi_1446_;
                                                        phi_1447_ = _e1267;
                                                    } else {
                                                        phi_1447_ = 0u;
                                                    }
                                                    let _e1269 = phi_1447_;
                                                    if (_e1269 == 0u) {
                                                        phi_1459_ = vec3<f32>(_e1046, _e1059, _e1033);
                                                    } else {
                                                        if (_e1269 == 1u) {
                                                            phi_1458_ = vec3<f32>(_e1059, _e1033, _e1046);
                                                        } else {
                                                            phi_1458_ = vec3<f32>(_e1033, _e1046, _e1059);
                                                        }
                                                        let _e1275 = phi_1458_;
                                                        phi_1459_ = _e1275;
                                                    }
                                                    let _e1277 = phi_1459_;
                                                    let _e1280 = (_e1277.x / _e1277.z);
                                                    let _e1283 = (_e1277.y / _e1277.z);
                                                    if (_e1194 < 0f) {
                                                        phi_1472_ = 0u;
                                                    } else {
                                                        phi_1472_ = 1u;
                                                    }
                                                    let _e1288 = phi_1472_;
                                                    if (_e1204 < 0f) {
                                                        phi_1477_ = 0u;
                                                    } else {
                                                        phi_1477_ = 2u;
                                                    }
                                                    let _e1291 = phi_1477_;
                                                    if (_e1214 < 0f) {
                                                        phi_1482_ = 0u;
                                                    } else {
                                                        phi_1482_ = 4u;
                                                    }
                                                    let _e1294 = phi_1482_;
                                                    let _e1296 = ((_e1288 | _e1291) | _e1294);
                                                    let _e1297 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1062, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1297.first[0], _e1297.first[1], _e1297.first[2], _e1297.first[3], _e1297.first[4], _e1297.first[5], _e1297.first[6], _e1297.first[7], _e1297.first[8], _e1297.first[9], _e1297.first[10], _e1297.first[11], _e1297.first[12], _e1297.first[13], _e1297.first[14], _e1297.first[15], _e1297.first[16], _e1297.first[17], _e1297.first[18], _e1297.first[19], _e1297.first[20], _e1297.first[21], _e1297.first[22], _e1297.first[23], _e1297.first[24], _e1297.first[25], _e1297.first[26], _e1297.first[27], _e1297.first[28], _e1297.first[29], _e1297.first[30], _e1297.first[31]), array<u32, 32>(_e1297.mask[0], _e1297.mask[1], _e1297.mask[2], _e1297.mask[3], _e1297.mask[4], _e1297.mask[5], _e1297.mask[6], _e1297.mask[7], _e1297.mask[8], _e1297.mask[9], _e1297.mask[10], _e1297.mask[11], _e1297.mask[12], _e1297.mask[13], _e1297.mask[14], _e1297.mask[15], _e1297.mask[16], _e1297.mask[17], _e1297.mask[18], _e1297.mask[19], _e1297.mask[20], _e1297.mask[21], _e1297.mask[22], _e1297.mask[23], _e1297.mask[24], _e1297.mask[25], _e1297.mask[26], _e1297.mask[27], _e1297.mask[28], _e1297.mask[29], _e1297.mask[30], _e1297.mask[31]), _e1297.len, _e1297.group, _e1297.group_mask);
                                                    let _e1371 = local.group_mask;
                                                    if ((_e1371 & 4278190080u) == 0u) {
                                                        let _e1375 = local.len;
                                                        if (_e1375 == 0u) {
                                                            phi_1596_ = false;
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
                                                            phi_1596_ = true;
                                                        }
                                                        let _e1398 = phi_1596_;
                                                        phi_1597_ = _e1398;
                                                    } else {
                                                        phi_1597_ = true;
                                                    }
                                                    let _e1400 = phi_1597_;
                                                    if _e1400 {
                                                        let _e1402 = local.group_mask;
                                                        let _e1408 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1402)), 32u, (_e1402 == 0u)));
                                                        let _e1412 = local.group_mask;
                                                        let _e1426 = local.group_mask;
                                                        local.group_mask = (_e1426 & ~((1u << bitcast<u32>((_e1408 & 31u)))));
                                                        let _e1429 = local.group;
                                                        phi_1628_ = (_e1429 + countOneBits(((_e1412 & ~((4294967295u << bitcast<u32>((((_e1408 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1628_ = 4294967295u;
                                                    }
                                                    let _e1432 = phi_1628_;
                                                    phi_1630_ = _e1432;
                                                    phi_1633_ = _e913;
                                                    loop {
                                                        let _e1434 = phi_1630_;
                                                        let _e1436 = phi_1633_;
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
                                                                let _e1507 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1496.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1513 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1507.unnamed.root, _e1496.w), _e1507.unnamed_1);
                                                                let _e1519 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1513.unnamed, lt_bvh_traverse_Tree(_e1496.x, _e1513.unnamed_1.first_primitive));
                                                                phi_1713_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1519.unnamed, lt_bvh_traverse_Tree(_e1519.unnamed_1.root, _e1496.y));
                                                            } else {
                                                                let _e1535 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1496.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1535.unnamed.root, _e1496.y), _e1535.unnamed_1);
                                                                let _e1547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_bvh_traverse_Tree(_e1496.z, _e1541.unnamed_1.first_primitive));
                                                                phi_1713_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1547.unnamed, lt_bvh_traverse_Tree(_e1547.unnamed_1.root, _e1496.w));
                                                            }
                                                            let _e1555 = phi_1713_;
                                                            let _e1565 = nodes.member[(0u + _e1434)].y;
                                                            if (_e1204 < 0f) {
                                                                let _e1576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1576.unnamed.root, _e1565.w), _e1576.unnamed_1);
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1582.unnamed, lt_bvh_traverse_Tree(_e1565.x, _e1582.unnamed_1.first_primitive));
                                                                phi_1740_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1588.unnamed, lt_bvh_traverse_Tree(_e1588.unnamed_1.root, _e1565.y));
                                                            } else {
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1604.unnamed.root, _e1565.y), _e1604.unnamed_1);
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_bvh_traverse_Tree(_e1565.z, _e1610.unnamed_1.first_primitive));
                                                                phi_1740_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1616.unnamed, lt_bvh_traverse_Tree(_e1616.unnamed_1.root, _e1565.w));
                                                            }
                                                            let _e1624 = phi_1740_;
                                                            let _e1634 = nodes.member[(0u + _e1434)].z;
                                                            if (_e1214 < 0f) {
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1645.unnamed.root, _e1634.w), _e1645.unnamed_1);
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1651.unnamed, lt_bvh_traverse_Tree(_e1634.x, _e1651.unnamed_1.first_primitive));
                                                                phi_1767_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_bvh_traverse_Tree(_e1657.unnamed_1.root, _e1634.y));
                                                            } else {
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1673.unnamed.root, _e1634.y), _e1673.unnamed_1);
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_bvh_traverse_Tree(_e1634.z, _e1679.unnamed_1.first_primitive));
                                                                phi_1767_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1685.unnamed, lt_bvh_traverse_Tree(_e1685.unnamed_1.root, _e1634.w));
                                                            }
                                                            let _e1693 = phi_1767_;
                                                            phi_1773_ = 0u;
                                                            phi_1776_ = 0u;
                                                            loop {
                                                                let _e1703 = phi_1773_;
                                                                let _e1705 = phi_1776_;
                                                                local_5 = _e1705;
                                                                local_6 = _e1705;
                                                                local_7 = _e1705;
                                                                let _e1706 = (_e1703 < 8u);
                                                                if _e1706 {
                                                                    let _e1708 = (_e1703 >> bitcast<u32>(2i));
                                                                    let _e1709 = (_e1703 & 3u);
                                                                    if (_e1708 == 0u) {
                                                                        phi_1790_ = _e1555.unnamed.root;
                                                                    } else {
                                                                        phi_1790_ = _e1555.unnamed.first_primitive;
                                                                    }
                                                                    let _e1712 = phi_1790_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1800_ = _e1624.unnamed.root;
                                                                    } else {
                                                                        phi_1800_ = _e1624.unnamed.first_primitive;
                                                                    }
                                                                    let _e1721 = phi_1800_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1810_ = _e1693.unnamed.root;
                                                                    } else {
                                                                        phi_1810_ = _e1693.unnamed.first_primitive;
                                                                    }
                                                                    let _e1730 = phi_1810_;
                                                                    let _e1743 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1712 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 - _e1246)), ((f32(((_e1721 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1247)));
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(_e1743, ((f32(((_e1730 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1248)));
                                                                    if (_e1708 == 0u) {
                                                                        phi_1828_ = _e1555.unnamed_1.root;
                                                                    } else {
                                                                        phi_1828_ = _e1555.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1747 = phi_1828_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1838_ = _e1624.unnamed_1.root;
                                                                    } else {
                                                                        phi_1838_ = _e1624.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1756 = phi_1838_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1848_ = _e1693.unnamed_1.root;
                                                                    } else {
                                                                        phi_1848_ = _e1693.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1765 = phi_1848_;
                                                                    let _e1778 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1747 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 + _e1246)), ((f32(((_e1756 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1247)));
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(_e1778, ((f32(((_e1765 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1248)));
                                                                    if (_e1744 <= _e1779) {
                                                                        if (_e1744 <= _e123) {
                                                                            if (_e1779 >= 0f) {
                                                                                if (_e1708 == 0u) {
                                                                                    let _e1786 = nodes.member[(0u + _e1434)].links[2u];
                                                                                    phi_1884_ = _e1786;
                                                                                } else {
                                                                                    let _e1789 = nodes.member[(0u + _e1434)].links[3u];
                                                                                    phi_1884_ = _e1789;
                                                                                }
                                                                                let _e1791 = phi_1884_;
                                                                                let _e1796 = ((_e1791 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u);
                                                                                let _e1797 = (_e1796 & 31u);
                                                                                if (_e1797 >= 24u) {
                                                                                    phi_1897_ = (24u + ((_e1797 - 24u) ^ _e1296));
                                                                                } else {
                                                                                    phi_1897_ = _e1797;
                                                                                }
                                                                                let _e1803 = phi_1897_;
                                                                                phi_1902_ = (_e1705 | ((_e1796 >> bitcast<u32>(5i)) << bitcast<u32>((_e1803 & 31u))));
                                                                            } else {
                                                                                phi_1902_ = _e1705;
                                                                            }
                                                                            let _e1811 = phi_1902_;
                                                                            phi_1903_ = _e1811;
                                                                        } else {
                                                                            phi_1903_ = _e1705;
                                                                        }
                                                                        let _e1813 = phi_1903_;
                                                                        phi_1904_ = _e1813;
                                                                    } else {
                                                                        phi_1904_ = _e1705;
                                                                    }
                                                                    let _e1815 = phi_1904_;
                                                                    phi_1774_ = (_e1703 + 1u);
                                                                    phi_1777_ = _e1815;
                                                                } else {
                                                                    phi_1774_ = u32();
                                                                    phi_1777_ = u32();
                                                                }
                                                                let _e1818 = phi_1774_;
                                                                let _e1820 = phi_1777_;
                                                                continue;
                                                                continuing {
                                                                    phi_1773_ = _e1818;
                                                                    phi_1776_ = _e1820;
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
                                                            phi_1962_ = (_e1869 & 16777215u);
                                                            phi_1965_ = _e1436;
                                                            loop {
                                                                let _e1872 = phi_1962_;
                                                                let _e1874 = phi_1965_;
                                                                local_12 = _e1874;
                                                                let _e1875 = (_e1872 == 0u);
                                                                local_8 = _e1875;
                                                                local_13 = _e1875;
                                                                if _e1875 {
                                                                    phi_1963_ = u32();
                                                                    phi_1966_ = bool();
                                                                    phi_2563_ = false;
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
                                                                        phi_2010_ = vec3<f32>(_e1894, _e1896, _e1892);
                                                                    } else {
                                                                        if (_e1269 == 1u) {
                                                                            phi_2009_ = vec3<f32>(_e1896, _e1892, _e1894);
                                                                        } else {
                                                                            phi_2009_ = (_e1890 - vec3<f32>(_e993, _e1006, _e1019));
                                                                        }
                                                                        let _e1904 = phi_2009_;
                                                                        phi_2010_ = _e1904;
                                                                    }
                                                                    let _e1906 = phi_2010_;
                                                                    let _e1910 = (_e1906.x - (_e1280 * _e1906.z));
                                                                    let _e1914 = (_e1906.y - (_e1283 * _e1906.z));
                                                                    let _e1916 = triangles.member[(0u + _e1883)].v1_;
                                                                    let _e1918 = (_e1916.x - _e993);
                                                                    let _e1920 = (_e1916.y - _e1006);
                                                                    let _e1922 = (_e1916.z - _e1019);
                                                                    if (_e1269 == 0u) {
                                                                        phi_2040_ = vec3<f32>(_e1920, _e1922, _e1918);
                                                                    } else {
                                                                        if (_e1269 == 1u) {
                                                                            phi_2039_ = vec3<f32>(_e1922, _e1918, _e1920);
                                                                        } else {
                                                                            phi_2039_ = (_e1916 - vec3<f32>(_e993, _e1006, _e1019));
                                                                        }
                                                                        let _e1930 = phi_2039_;
                                                                        phi_2040_ = _e1930;
                                                                    }
                                                                    let _e1932 = phi_2040_;
                                                                    let _e1936 = (_e1932.x - (_e1280 * _e1932.z));
                                                                    let _e1940 = (_e1932.y - (_e1283 * _e1932.z));
                                                                    let _e1942 = triangles.member[(0u + _e1883)].v2_;
                                                                    let _e1944 = (_e1942.x - _e993);
                                                                    let _e1946 = (_e1942.y - _e1006);
                                                                    let _e1948 = (_e1942.z - _e1019);
                                                                    if (_e1269 == 0u) {
                                                                        phi_2070_ = vec3<f32>(_e1946, _e1948, _e1944);
                                                                    } else {
                                                                        if (_e1269 == 1u) {
                                                                            phi_2069_ = vec3<f32>(_e1948, _e1944, _e1946);
                                                                        } else {
                                                                            phi_2069_ = (_e1942 - vec3<f32>(_e993, _e1006, _e1019));
                                                                        }
                                                                        let _e1956 = phi_2069_;
                                                                        phi_2070_ = _e1956;
                                                                    }
                                                                    let _e1958 = phi_2070_;
                                                                    let _e1962 = (_e1958.x - (_e1280 * _e1958.z));
                                                                    let _e1966 = (_e1958.y - (_e1283 * _e1958.z));
                                                                    if (_e1936 < _e1962) {
                                                                        phi_2089_ = true;
                                                                    } else {
                                                                        if (_e1936 == _e1962) {
                                                                            phi_2088_ = (_e1940 < _e1966);
                                                                        } else {
                                                                            phi_2088_ = false;
                                                                        }
                                                                        let _e1971 = phi_2088_;
                                                                        phi_2089_ = _e1971;
                                                                    }
                                                                    let _e1973 = phi_2089_;
                                                                    if _e1973 {
                                                                        phi_2093_ = _e1966;
                                                                        phi_2094_ = _e1962;
                                                                        phi_2095_ = _e1940;
                                                                        phi_2096_ = _e1936;
                                                                    } else {
                                                                        phi_2093_ = _e1940;
                                                                        phi_2094_ = _e1936;
                                                                        phi_2095_ = _e1966;
                                                                        phi_2096_ = _e1962;
                                                                    }
                                                                    let _e1975 = phi_2093_;
                                                                    let _e1977 = phi_2094_;
                                                                    let _e1979 = phi_2095_;
                                                                    let _e1981 = phi_2096_;
                                                                    let _e1984 = ((_e1981 * _e1975) - (_e1979 * _e1977));
                                                                    if _e1973 {
                                                                        phi_2104_ = -(_e1984);
                                                                    } else {
                                                                        phi_2104_ = _e1984;
                                                                    }
                                                                    let _e1987 = phi_2104_;
                                                                    if (_e1962 < _e1910) {
                                                                        phi_2115_ = true;
                                                                    } else {
                                                                        if (_e1962 == _e1910) {
                                                                            phi_2114_ = (_e1966 < _e1914);
                                                                        } else {
                                                                            phi_2114_ = false;
                                                                        }
                                                                        let _e1992 = phi_2114_;
                                                                        phi_2115_ = _e1992;
                                                                    }
                                                                    let _e1994 = phi_2115_;
                                                                    if _e1994 {
                                                                        phi_2119_ = _e1914;
                                                                        phi_2120_ = _e1910;
                                                                        phi_2121_ = _e1966;
                                                                        phi_2122_ = _e1962;
                                                                    } else {
                                                                        phi_2119_ = _e1966;
                                                                        phi_2120_ = _e1962;
                                                                        phi_2121_ = _e1914;
                                                                        phi_2122_ = _e1910;
                                                                    }
                                                                    let _e1996 = phi_2119_;
                                                                    let _e1998 = phi_2120_;
                                                                    let _e2000 = phi_2121_;
                                                                    let _e2002 = phi_2122_;
                                                                    let _e2005 = ((_e2002 * _e1996) - (_e2000 * _e1998));
                                                                    if _e1994 {
                                                                        phi_2130_ = -(_e2005);
                                                                    } else {
                                                                        phi_2130_ = _e2005;
                                                                    }
                                                                    let _e2008 = phi_2130_;
                                                                    if (_e1910 < _e1936) {
                                                                        phi_2141_ = true;
                                                                    } else {
                                                                        if (_e1910 == _e1936) {
                                                                            phi_2140_ = (_e1914 < _e1940);
                                                                        } else {
                                                                            phi_2140_ = false;
                                                                        }
                                                                        let _e2013 = phi_2140_;
                                                                        phi_2141_ = _e2013;
                                                                    }
                                                                    let _e2015 = phi_2141_;
                                                                    if _e2015 {
                                                                        phi_2145_ = _e1940;
                                                                        phi_2146_ = _e1936;
                                                                        phi_2147_ = _e1914;
                                                                        phi_2148_ = _e1910;
                                                                    } else {
                                                                        phi_2145_ = _e1914;
                                                                        phi_2146_ = _e1910;
                                                                        phi_2147_ = _e1940;
                                                                        phi_2148_ = _e1936;
                                                                    }
                                                                    let _e2017 = phi_2145_;
                                                                    let _e2019 = phi_2146_;
                                                                    let _e2021 = phi_2147_;
                                                                    let _e2023 = phi_2148_;
                                                                    let _e2026 = ((_e2023 * _e2017) - (_e2021 * _e2019));
                                                                    if _e2015 {
                                                                        phi_2156_ = -(_e2026);
                                                                    } else {
                                                                        phi_2156_ = _e2026;
                                                                    }
                                                                    let _e2029 = phi_2156_;
                                                                    if (_e1987 >= 0f) {
                                                                        if (_e2008 >= 0f) {
                                                                            if (_e2029 >= 0f) {
                                                                                phi_2171_ = ((_e1987 + _e2008) + _e2029);
                                                                                phi_2172_ = false;
                                                                            } else {
                                                                                phi_2171_ = f32();
                                                                                phi_2172_ = true;
                                                                            }
                                                                            let _e2036 = phi_2171_;
                                                                            let _e2038 = phi_2172_;
                                                                            phi_2173_ = _e2036;
                                                                            phi_2174_ = _e2038;
                                                                        } else {
                                                                            phi_2173_ = f32();
                                                                            phi_2174_ = true;
                                                                        }
                                                                        let _e2040 = phi_2173_;
                                                                        let _e2042 = phi_2174_;
                                                                        phi_2175_ = _e2040;
                                                                        phi_2176_ = _e2042;
                                                                    } else {
                                                                        phi_2175_ = f32();
                                                                        phi_2176_ = true;
                                                                    }
                                                                    let _e2044 = phi_2175_;
                                                                    let _e2046 = phi_2176_;
                                                                    if _e2046 {
                                                                        if (_e1987 <= 0f) {
                                                                            if (_e2008 <= 0f) {
                                                                                let _e2049 = (_e2029 <= 0f);
                                                                                if _e2049 {
                                                                                }
                                                                                phi_2194_ = ((_e1987 + _e2008) + _e2029);
                                                                                phi_2195_ = false;
                                                                                phi_2196_ = _e2049;
                                                                            } else {
                                                                                phi_2194_ = f32();
                                                                                phi_2195_ = true;
                                                                                phi_2196_ = false;
                                                                            }
                                                                            let _e2053 = phi_2194_;
                                                                            let _e2055 = phi_2195_;
                                                                            let _e2057 = phi_2196_;
                                                                            phi_2197_ = _e2053;
                                                                            phi_2198_ = _e2055;
                                                                            phi_2199_ = _e2057;
                                                                        } else {
                                                                            phi_2197_ = f32();
                                                                            phi_2198_ = true;
                                                                            phi_2199_ = false;
                                                                        }
                                                                        let _e2059 = phi_2197_;
                                                                        let _e2061 = phi_2198_;
                                                                        let _e2063 = phi_2199_;
                                                                        if _e2061 {
                                                                            phi_2203_ = false;
                                                                        } else {
                                                                            phi_2203_ = _e2063;
                                                                        }
                                                                        let _e2065 = phi_2203_;
                                                                        phi_2204_ = _e2059;
                                                                        phi_2205_ = _e2065;
                                                                    } else {
                                                                        phi_2204_ = _e2044;
                                                                        phi_2205_ = true;
                                                                    }
                                                                    let _e2067 = phi_2204_;
                                                                    let _e2069 = phi_2205_;
                                                                    if _e2069 {
                                                                        let _e2070 = (_e2067 == 0f);
                                                                        if _e2070 {
                                                                            phi_2521_ = lt_bvh_triangle_Intersection();
                                                                            phi_2522_ = false;
                                                                        } else {
                                                                            let _e2072 = triangles.member[(0u + _e1883)].v0_;
                                                                            let _e2074 = (_e2072.x - _e993);
                                                                            let _e2076 = (_e2072.y - _e1006);
                                                                            let _e2078 = (_e2072.z - _e1019);
                                                                            if (_e1269 == 0u) {
                                                                                phi_2234_ = vec3<f32>(_e2076, _e2078, _e2074);
                                                                            } else {
                                                                                if (_e1269 == 1u) {
                                                                                    phi_2233_ = vec3<f32>(_e2078, _e2074, _e2076);
                                                                                } else {
                                                                                    phi_2233_ = (_e2072 - vec3<f32>(_e993, _e1006, _e1019));
                                                                                }
                                                                                let _e2086 = phi_2233_;
                                                                                phi_2234_ = _e2086;
                                                                            }
                                                                            let _e2088 = phi_2234_;
                                                                            let _e2090 = triangles.member[(0u + _e1883)].v1_;
                                                                            let _e2092 = triangles.member[(0u + _e1883)].v0_;
                                                                            let _e2095 = (_e2090.x - _e2092.x);
                                                                            let _e2098 = (_e2090.y - _e2092.y);
                                                                            let _e2101 = (_e2090.z - _e2092.z);
                                                                            if (_e1269 == 0u) {
                                                                                phi_2260_ = vec3<f32>(_e2098, _e2101, _e2095);
                                                                            } else {
                                                                                if (_e1269 == 1u) {
                                                                                    phi_2259_ = vec3<f32>(_e2101, _e2095, _e2098);
                                                                                } else {
                                                                                    phi_2259_ = (_e2090 - _e2092);
                                                                                }
                                                                                let _e2108 = phi_2259_;
                                                                                phi_2260_ = _e2108;
                                                                            }
                                                                            let _e2110 = phi_2260_;
                                                                            let _e2112 = triangles.member[(0u + _e1883)].v2_;
                                                                            let _e2114 = triangles.member[(0u + _e1883)].v0_;
                                                                            let _e2117 = (_e2112.x - _e2114.x);
                                                                            let _e2120 = (_e2112.y - _e2114.y);
                                                                            let _e2123 = (_e2112.z - _e2114.z);
                                                                            if (_e1269 == 0u) {
                                                                                phi_2286_ = vec3<f32>(_e2120, _e2123, _e2117);
                                                                            } else {
                                                                                if (_e1269 == 1u) {
                                                                                    phi_2285_ = vec3<f32>(_e2123, _e2117, _e2120);
                                                                                } else {
                                                                                    phi_2285_ = (_e2112 - _e2114);
                                                                                }
                                                                                let _e2130 = phi_2285_;
                                                                                phi_2286_ = _e2130;
                                                                            }
                                                                            let _e2132 = phi_2286_;
                                                                            let _e2139 = ((_e2110.y * _e2132.z) - (_e2110.z * _e2132.y));
                                                                            let _e2146 = ((_e2110.z * _e2132.x) - (_e2110.x * _e2132.z));
                                                                            let _e2153 = ((_e2110.x * _e2132.y) - (_e2110.y * _e2132.x));
                                                                            let _e2167 = (((1f / _e1277.z) * (((_e2139 * _e2088.x) + (_e2146 * _e2088.y)) + (_e2153 * _e2088.z))) / (((_e2139 * _e1280) + (_e2146 * _e1283)) + _e2153));
                                                                            if (_e2167 > 0f) {
                                                                                if (_e2167 < _e123) {
                                                                                    let _e2171 = triangles.member[(0u + _e1883)].v0_;
                                                                                    let _e2173 = triangles.member[(0u + _e1883)].v1_;
                                                                                    if (_e2171.x < _e2173.x) {
                                                                                        phi_2342_ = _e2171.x;
                                                                                    } else {
                                                                                        phi_2342_ = _e2173.x;
                                                                                    }
                                                                                    let _e2180 = phi_2342_;
                                                                                    if (_e2171.y < _e2173.y) {
                                                                                        phi_2351_ = _e2171.y;
                                                                                    } else {
                                                                                        phi_2351_ = _e2173.y;
                                                                                    }
                                                                                    let _e2187 = phi_2351_;
                                                                                    if (_e2171.z < _e2173.z) {
                                                                                        phi_2360_ = _e2171.z;
                                                                                    } else {
                                                                                        phi_2360_ = _e2173.z;
                                                                                    }
                                                                                    let _e2194 = phi_2360_;
                                                                                    let _e2196 = triangles.member[(0u + _e1883)].v2_;
                                                                                    if (_e2180 < _e2196.x) {
                                                                                        phi_2369_ = _e2180;
                                                                                    } else {
                                                                                        phi_2369_ = _e2196.x;
                                                                                    }
                                                                                    let _e2201 = phi_2369_;
                                                                                    if (_e2187 < _e2196.y) {
                                                                                        phi_2376_ = _e2187;
                                                                                    } else {
                                                                                        phi_2376_ = _e2196.y;
                                                                                    }
                                                                                    let _e2206 = phi_2376_;
                                                                                    if (_e2194 < _e2196.z) {
                                                                                        phi_2383_ = _e2194;
                                                                                    } else {
                                                                                        phi_2383_ = _e2196.z;
                                                                                    }
                                                                                    let _e2211 = phi_2383_;
                                                                                    let _e2213 = triangles.member[(0u + _e1883)].v0_;
                                                                                    let _e2215 = triangles.member[(0u + _e1883)].v1_;
                                                                                    if (_e2213.x > _e2215.x) {
                                                                                        phi_2396_ = _e2213.x;
                                                                                    } else {
                                                                                        phi_2396_ = _e2215.x;
                                                                                    }
                                                                                    let _e2222 = phi_2396_;
                                                                                    if (_e2213.y > _e2215.y) {
                                                                                        phi_2405_ = _e2213.y;
                                                                                    } else {
                                                                                        phi_2405_ = _e2215.y;
                                                                                    }
                                                                                    let _e2229 = phi_2405_;
                                                                                    if (_e2213.z > _e2215.z) {
                                                                                        phi_2414_ = _e2213.z;
                                                                                    } else {
                                                                                        phi_2414_ = _e2215.z;
                                                                                    }
                                                                                    let _e2236 = phi_2414_;
                                                                                    let _e2238 = triangles.member[(0u + _e1883)].v2_;
                                                                                    if (_e2222 > _e2238.x) {
                                                                                        phi_2423_ = _e2222;
                                                                                    } else {
                                                                                        phi_2423_ = _e2238.x;
                                                                                    }
                                                                                    let _e2243 = phi_2423_;
                                                                                    if (_e2229 > _e2238.y) {
                                                                                        phi_2430_ = _e2229;
                                                                                    } else {
                                                                                        phi_2430_ = _e2238.y;
                                                                                    }
                                                                                    let _e2248 = phi_2430_;
                                                                                    if (_e2236 > _e2238.z) {
                                                                                        phi_2437_ = _e2236;
                                                                                    } else {
                                                                                        phi_2437_ = _e2238.z;
                                                                                    }
                                                                                    let _e2253 = phi_2437_;
                                                                                    let _e2257 = ((_e2201 - _e993) * _e1194);
                                                                                    let _e2258 = ((_e2206 - _e1006) * _e1204);
                                                                                    let _e2259 = ((_e2211 - _e1019) * _e1214);
                                                                                    let _e2263 = ((_e2243 - _e993) * _e1194);
                                                                                    let _e2264 = ((_e2248 - _e1006) * _e1204);
                                                                                    let _e2265 = ((_e2253 - _e1019) * _e1214);
                                                                                    if (_e2257 < _e2263) {
                                                                                        phi_2454_ = _e2257;
                                                                                    } else {
                                                                                        phi_2454_ = _e2263;
                                                                                    }
                                                                                    let _e2268 = phi_2454_;
                                                                                    if (_e2258 < _e2264) {
                                                                                        phi_2459_ = _e2258;
                                                                                    } else {
                                                                                        phi_2459_ = _e2264;
                                                                                    }
                                                                                    let _e2271 = phi_2459_;
                                                                                    if (_e2259 < _e2265) {
                                                                                        phi_2464_ = _e2259;
                                                                                    } else {
                                                                                        phi_2464_ = _e2265;
                                                                                    }
                                                                                    let _e2274 = phi_2464_;
                                                                                    if (_e2257 > _e2263) {
                                                                                        phi_2472_ = _e2257;
                                                                                    } else {
                                                                                        phi_2472_ = _e2263;
                                                                                    }
                                                                                    let _e2280 = phi_2472_;
                                                                                    if (_e2258 > _e2264) {
                                                                                        phi_2477_ = _e2258;
                                                                                    } else {
                                                                                        phi_2477_ = _e2264;
                                                                                    }
                                                                                    let _e2283 = phi_2477_;
                                                                                    if (_e2259 > _e2265) {
                                                                                        phi_2482_ = _e2259;
                                                                                    } else {
                                                                                        phi_2482_ = _e2265;
                                                                                    }
                                                                                    let _e2286 = phi_2482_;
                                                                                    let _e2290 = core_intrinsics_maximum_number_nsz_f32_((_e2268 - _e1253), (_e2271 - _e1254));
                                                                                    let _e2291 = core_intrinsics_maximum_number_nsz_f32_(_e2290, (_e2274 - _e1255));
                                                                                    let _e2292 = core_intrinsics_minimum_number_nsz_f32_((_e2280 + _e1253), (_e2283 + _e1254));
                                                                                    let _e2293 = core_intrinsics_minimum_number_nsz_f32_(_e2292, (_e2286 + _e1255));
                                                                                    if (_e2291 > _e974) {
                                                                                        phi_2494_ = _e2291;
                                                                                    } else {
                                                                                        phi_2494_ = _e974;
                                                                                    }
                                                                                    let _e2296 = phi_2494_;
                                                                                    if (_e2293 < _e976) {
                                                                                        phi_2499_ = _e2293;
                                                                                    } else {
                                                                                        phi_2499_ = _e976;
                                                                                    }
                                                                                    let _e2299 = phi_2499_;
                                                                                    if (_e2167 < _e2296) {
                                                                                        phi_2504_ = _e2296;
                                                                                    } else {
                                                                                        phi_2504_ = _e2167;
                                                                                    }
                                                                                    let _e2302 = phi_2504_;
                                                                                    if (_e2302 > _e2299) {
                                                                                        phi_2509_ = _e2299;
                                                                                    } else {
                                                                                        phi_2509_ = _e2302;
                                                                                    }
                                                                                    let _e2305 = phi_2509_;
                                                                                    phi_2514_ = lt_bvh_triangle_Intersection(_e2305, (_e2008 / _e2067), (_e2029 / _e2067), (_e2296 <= _e2299));
                                                                                    phi_2515_ = false;
                                                                                } else {
                                                                                    phi_2514_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2515_ = true;
                                                                                }
                                                                                let _e2311 = phi_2514_;
                                                                                let _e2313 = phi_2515_;
                                                                                phi_2516_ = _e2311;
                                                                                phi_2517_ = _e2313;
                                                                            } else {
                                                                                phi_2516_ = lt_bvh_triangle_Intersection();
                                                                                phi_2517_ = true;
                                                                            }
                                                                            let _e2315 = phi_2516_;
                                                                            let _e2317 = phi_2517_;
                                                                            if _e2317 {
                                                                            }
                                                                            phi_2521_ = _e2315;
                                                                            phi_2522_ = _e2317;
                                                                        }
                                                                        let _e2319 = phi_2521_;
                                                                        let _e2321 = phi_2522_;
                                                                        phi_2523_ = _e2319;
                                                                        phi_2524_ = _e2070;
                                                                        phi_2525_ = _e2321;
                                                                    } else {
                                                                        phi_2523_ = lt_bvh_triangle_Intersection();
                                                                        phi_2524_ = true;
                                                                        phi_2525_ = false;
                                                                    }
                                                                    let _e2323 = phi_2523_;
                                                                    let _e2325 = phi_2524_;
                                                                    let _e2327 = phi_2525_;
                                                                    if _e2325 {
                                                                        phi_2529_ = true;
                                                                    } else {
                                                                        phi_2529_ = _e2327;
                                                                    }
                                                                    let _e2329 = phi_2529_;
                                                                    if _e2329 {
                                                                        phi_2533_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2533_ = _e2323;
                                                                    }
                                                                    let _e2331 = phi_2533_;
                                                                    if _e2331.is_hit {
                                                                        if (_e2331.t > 0f) {
                                                                            if (_e2331.t < _e123) {
                                                                                if true {
                                                                                    phi_2553_ = false;
                                                                                } else {
                                                                                    phi_2553_ = true;
                                                                                }
                                                                                let _e2340 = phi_2553_;
                                                                                phi_2554_ = true;
                                                                                phi_2555_ = _e2340;
                                                                            } else {
                                                                                phi_2554_ = _e1874;
                                                                                phi_2555_ = true;
                                                                            }
                                                                            let _e2342 = phi_2554_;
                                                                            let _e2344 = phi_2555_;
                                                                            phi_2556_ = _e2342;
                                                                            phi_2557_ = _e2344;
                                                                        } else {
                                                                            phi_2556_ = _e1874;
                                                                            phi_2557_ = true;
                                                                        }
                                                                        let _e2346 = phi_2556_;
                                                                        let _e2348 = phi_2557_;
                                                                        phi_2558_ = _e2346;
                                                                        phi_2559_ = _e2348;
                                                                    } else {
                                                                        phi_2558_ = _e1874;
                                                                        phi_2559_ = true;
                                                                    }
                                                                    let _e2350 = phi_2558_;
                                                                    let _e2352 = phi_2559_;
                                                                    if _e2352 {
                                                                    }
                                                                    phi_1963_ = (_e1872 & (_e1872 - 1u));
                                                                    phi_1966_ = _e2350;
                                                                    phi_2563_ = _e2352;
                                                                }
                                                                let _e2354 = phi_1963_;
                                                                let _e2356 = phi_1966_;
                                                                let _e2358 = phi_2563_;
                                                                continue;
                                                                continuing {
                                                                    phi_1962_ = _e2354;
                                                                    phi_1965_ = _e2356;
                                                                    break if !(_e2358);
                                                                }
                                                            }
                                                            let _e2361 = local_8;
                                                            if _e2361 {
                                                                let _e2363 = local.group_mask;
                                                                if ((_e2363 & 4278190080u) == 0u) {
                                                                    let _e2367 = local.len;
                                                                    if (_e2367 == 0u) {
                                                                        phi_2605_ = false;
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
                                                                        phi_2605_ = true;
                                                                    }
                                                                    let _e2390 = phi_2605_;
                                                                    phi_2606_ = _e2390;
                                                                } else {
                                                                    phi_2606_ = true;
                                                                }
                                                                let _e2392 = phi_2606_;
                                                                if _e2392 {
                                                                    let _e2394 = local.group_mask;
                                                                    let _e2400 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2394)), 32u, (_e2394 == 0u)));
                                                                    let _e2404 = local.group_mask;
                                                                    let _e2418 = local.group_mask;
                                                                    local.group_mask = (_e2418 & ~((1u << bitcast<u32>((_e2400 & 31u)))));
                                                                    let _e2421 = local.group;
                                                                    phi_2637_ = (_e2421 + countOneBits(((_e2404 & ~((4294967295u << bitcast<u32>((((_e2400 - 24u) ^ _e1296) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2637_ = 4294967295u;
                                                                }
                                                                let _e2424 = phi_2637_;
                                                                phi_2638_ = _e2424;
                                                            } else {
                                                                phi_2638_ = u32();
                                                            }
                                                            let _e2426 = phi_2638_;
                                                            phi_1631_ = _e2426;
                                                            let _e2892 = local_12;
                                                            phi_1634_ = _e2892;
                                                            let _e2895 = local_13;
                                                            phi_2639_ = _e2895;
                                                            phi_2640_ = false;
                                                        } else {
                                                            phi_1631_ = u32();
                                                            phi_1634_ = bool();
                                                            phi_2639_ = false;
                                                            phi_2640_ = true;
                                                        }
                                                        let _e2428 = phi_1631_;
                                                        let _e2430 = phi_1634_;
                                                        let _e2432 = phi_2639_;
                                                        let _e2434 = phi_2640_;
                                                        local_9 = _e2434;
                                                        continue;
                                                        continuing {
                                                            phi_1630_ = _e2428;
                                                            phi_1633_ = _e2430;
                                                            break if !(_e2432);
                                                        }
                                                    }
                                                    let _e2437 = local_9;
                                                    if _e2437 {
                                                        phi_2644_ = false;
                                                    } else {
                                                        phi_2644_ = true;
                                                    }
                                                    let _e2439 = phi_2644_;
                                                    if _e2439 {
                                                        phi_2648_ = true;
                                                    } else {
                                                        let _e2901 = local_14;
                                                        phi_2648_ = _e2901;
                                                    }
                                                    let _e2441 = phi_2648_;
                                                    phi_2649_ = _e2441;
                                                }
                                                let _e2443 = phi_2649_;
                                                phi_2650_ = _e2443;
                                                phi_2651_ = _e1118;
                                            } else {
                                                phi_2650_ = bool();
                                                phi_2651_ = true;
                                            }
                                            let _e2445 = phi_2650_;
                                            let _e2447 = phi_2651_;
                                            if _e2447 {
                                                phi_2655_ = _e913;
                                            } else {
                                                phi_2655_ = _e2445;
                                            }
                                            let _e2449 = phi_2655_;
                                            if _e2449 {
                                                phi_2659_ = false;
                                            } else {
                                                phi_2659_ = true;
                                            }
                                            let _e2451 = phi_2659_;
                                            phi_2660_ = _e2449;
                                            phi_2661_ = _e2451;
                                        } else {
                                            phi_2660_ = _e913;
                                            phi_2661_ = true;
                                        }
                                        let _e2453 = phi_2660_;
                                        let _e2455 = phi_2661_;
                                        phi_2662_ = _e2453;
                                        phi_2663_ = _e2455;
                                    } else {
                                        phi_2662_ = _e913;
                                        phi_2663_ = true;
                                    }
                                    let _e2457 = phi_2662_;
                                    let _e2459 = phi_2663_;
                                    phi_2664_ = _e2457;
                                    phi_2665_ = _e2459;
                                } else {
                                    phi_2664_ = _e913;
                                    phi_2665_ = true;
                                }
                                let _e2461 = phi_2664_;
                                let _e2463 = phi_2665_;
                                if _e2463 {
                                }
                                phi_1016_ = (_e911 & (_e911 - 1u));
                                phi_1019_ = _e2461;
                                phi_2669_ = _e2463;
                            }
                            let _e2465 = phi_1016_;
                            let _e2467 = phi_1019_;
                            let _e2469 = phi_2669_;
                            continue;
                            continuing {
                                phi_1015_ = _e2465;
                                phi_1018_ = _e2467;
                                break if !(_e2469);
                            }
                        }
                        let _e2472 = local_10;
                        if _e2472 {
                            let _e2474 = local_1.group_mask;
                            if ((_e2474 & 4278190080u) == 0u) {
                                let _e2478 = local_1.len;
                                if (_e2478 == 0u) {
                                    phi_2711_ = false;
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
                                    phi_2711_ = true;
                                }
                                let _e2501 = phi_2711_;
                                phi_2712_ = _e2501;
                            } else {
                                phi_2712_ = true;
                            }
                            let _e2503 = phi_2712_;
                            if _e2503 {
                                let _e2505 = local_1.group_mask;
                                let _e2511 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2505)), 32u, (_e2505 == 0u)));
                                let _e2515 = local_1.group_mask;
                                let _e2529 = local_1.group_mask;
                                local_1.group_mask = (_e2529 & ~((1u << bitcast<u32>((_e2511 & 31u)))));
                                let _e2532 = local_1.group;
                                phi_2743_ = (_e2532 + countOneBits(((_e2515 & ~((4294967295u << bitcast<u32>((((_e2511 - 24u) ^ _e335) & 31u))))) & 255u)));
                            } else {
                                phi_2743_ = 4294967295u;
                            }
                            let _e2535 = phi_2743_;
                            phi_2744_ = _e2535;
                        } else {
                            phi_2744_ = u32();
                        }
                        let _e2537 = phi_2744_;
                        phi_684_ = _e2537;
                        let _e2924 = local_15;
                        phi_687_ = _e2924;
                        let _e2927 = local_16;
                        phi_2745_ = _e2927;
                        phi_2746_ = false;
                    } else {
                        phi_684_ = u32();
                        phi_687_ = bool();
                        phi_2745_ = false;
                        phi_2746_ = true;
                    }
                    let _e2539 = phi_684_;
                    let _e2541 = phi_687_;
                    let _e2543 = phi_2745_;
                    let _e2545 = phi_2746_;
                    local_11 = _e2545;
                    continue;
                    continuing {
                        phi_683_ = _e2539;
                        phi_686_ = _e2541;
                        break if !(_e2543);
                    }
                }
                let _e2548 = local_11;
                if _e2548 {
                    phi_2750_ = false;
                } else {
                    phi_2750_ = true;
                }
                let _e2550 = phi_2750_;
                if _e2550 {
                }
                phi_2754_ = _e2550;
            }
            let _e2552 = phi_2754_;
            phi_2755_ = _e187;
            phi_2756_ = _e2552;
        } else {
            phi_2755_ = true;
            phi_2756_ = false;
        }
        let _e2554 = phi_2755_;
        let _e2556 = phi_2756_;
        if _e2554 {
            phi_2760_ = false;
            phi_2761_ = true;
        } else {
            phi_2760_ = true;
            phi_2761_ = _e2556;
        }
        let _e2558 = phi_2760_;
        let _e2560 = phi_2761_;
        if _e2560 {
            phi_2765_ = _e2558;
        } else {
            phi_2765_ = false;
        }
        let _e2562 = phi_2765_;
        if _e2562 {
            phi_2769_ = 0f;
        } else {
            phi_2769_ = 1f;
        }
        let _e2564 = phi_2769_;
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
            phi_2810_ = _e2587;
        } else {
            phi_2810_ = 0u;
        }
        let _e2589 = phi_2810_;
        if (_e2581 < _e75) {
        } else {
            return;
        }
        let _e2593 = bits.member[(0u + _e2581)];
        let _e2596 = (_e2593 >> bitcast<u32>((_e2573 & 31u)));
        if (_e2573 > 29u) {
            phi_2829_ = (_e2596 | (_e2589 << bitcast<u32>(((32u - _e2573) & 31u))));
        } else {
            phi_2829_ = _e2596;
        }
        let _e2604 = phi_2829_;
        if ((_e2604 & 2u) == 0u) {
            phi_2837_ = (_e2604 & 1u);
        } else {
            phi_2837_ = (_e2604 & 7u);
        }
        let _e2610 = phi_2837_;
        if ((_e2610 & 1u) != 0u) {
            phi_2845_ = (2u | 1u);
        } else {
            phi_2845_ = 2u;
        }
        let _e2616 = phi_2845_;
        if (_e2579 < 0.5f) {
            phi_2850_ = (_e2616 | 4u);
        } else {
            phi_2850_ = _e2616;
        }
        let _e2619 = phi_2850_;
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
