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
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_53 {
    member: array<vec4<u32>>,
}

struct lt_bvh_LightSpace {
    shear: vec3<f32>,
    axis: u32,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    pad: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_56 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

struct lt_bvh_LightNode {
    frame: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    rest: vec4<u32>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(5) 
var<storage> rows: type_53;
@group(0) @binding(6) 
var<uniform> space: type_56;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_203_: lt_mask_LightPlace;
    var phi_204_: bool;
    var phi_205_: lt_mask_LightPlace;
    var phi_206_: bool;
    var phi_211_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_203_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_204_ = false;
        } else {
            phi_203_ = lt_mask_LightPlace();
            phi_204_ = true;
        }
        let _e78 = phi_203_;
        let _e80 = phi_204_;
        phi_205_ = _e78;
        phi_206_ = _e80;
    } else {
        phi_205_ = lt_mask_LightPlace();
        phi_206_ = true;
    }
    let _e82 = phi_205_;
    let _e84 = phi_206_;
    if _e84 {
        phi_211_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_211_ = _e82;
    }
    let _e89 = phi_211_;
    return lt_mask_LightPlace(_e89.word, _e89.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_226_: bool;
    var phi_230_: f32;

    if (param_3 != param_3) {
        phi_226_ = true;
    } else {
        let _e68 = (param_4 >= param_3);
        if _e68 {
        }
        phi_226_ = _e68;
    }
    let _e70 = phi_226_;
    if _e70 {
        phi_230_ = param_4;
    } else {
        phi_230_ = param_3;
    }
    let _e72 = phi_230_;
    return _e72;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_242_: bool;
    var phi_246_: f32;

    if (param_5 != param_5) {
        phi_242_ = true;
    } else {
        let _e68 = (param_6 <= param_5);
        if _e68 {
        }
        phi_242_ = _e68;
    }
    let _e70 = phi_242_;
    if _e70 {
        phi_246_ = param_6;
    } else {
        phi_246_ = param_5;
    }
    let _e72 = phi_246_;
    return _e72;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_271_: bool;
    var phi_272_: bool;
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_278_: bool;

    let _e68 = (*param_7).normal[0u];
    let _e70 = global[0u];
    if (_e68 == _e70) {
        let _e73 = (*param_7).normal[1u];
        let _e75 = global[1u];
        if (_e73 == _e75) {
            let _e78 = (*param_7).normal[2u];
            let _e80 = global[2u];
            phi_271_ = (_e78 == _e80);
            phi_272_ = false;
        } else {
            phi_271_ = bool();
            phi_272_ = true;
        }
        let _e83 = phi_271_;
        let _e85 = phi_272_;
        phi_273_ = _e83;
        phi_274_ = _e85;
    } else {
        phi_273_ = bool();
        phi_274_ = true;
    }
    let _e87 = phi_273_;
    let _e89 = phi_274_;
    if _e89 {
        phi_278_ = false;
    } else {
        phi_278_ = _e87;
    }
    let _e91 = phi_278_;
    return !(_e91);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: array<u32, 32>;
    var local_2: abi_Sample;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_406_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_407_: bool;
    var phi_408_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_409_: bool;
    var phi_416_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_420_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_464_: f32;
    var phi_497_: bool;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_504_: bool;
    var phi_517_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_524_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_551_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_583_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_602_: bool;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_629_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_658_: u32;
    var phi_659_: f32;
    var phi_660_: u32;
    var phi_661_: f32;
    var phi_666_: f32;
    var phi_677_: u32;
    var phi_687_: u32;
    var phi_693_: u32;
    var phi_694_: u32;
    var phi_695_: u32;
    var phi_706_: vec3<f32>;
    var phi_707_: vec3<f32>;
    var phi_729_: vec3<f32>;
    var phi_730_: vec3<f32>;
    var phi_753_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_821_: f32;
    var phi_828_: f32;
    var phi_835_: f32;
    var phi_842_: f32;
    var phi_849_: f32;
    var phi_856_: f32;
    var phi_873_: f32;
    var phi_878_: f32;
    var phi_883_: f32;
    var phi_888_: f32;
    var phi_893_: f32;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_924_: u32;
    var phi_925_: u32;
    var phi_936_: vec3<f32>;
    var phi_937_: vec3<f32>;
    var phi_949_: u32;
    var phi_952_: u32;
    var phi_1021_: f32;
    var phi_1022_: f32;
    var phi_1036_: u32;
    var phi_1059_: f32;
    var phi_1060_: f32;
    var phi_1074_: u32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1112_: u32;
    var phi_1239_: u32;
    var phi_1279_: u32;
    var phi_1280_: u32;
    var phi_1286_: u32;
    var phi_1315_: vec3<f32>;
    var phi_1316_: vec3<f32>;
    var phi_1345_: vec3<f32>;
    var phi_1346_: vec3<f32>;
    var phi_1375_: vec3<f32>;
    var phi_1376_: vec3<f32>;
    var phi_1394_: bool;
    var phi_1395_: bool;
    var phi_1399_: f32;
    var phi_1400_: f32;
    var phi_1401_: f32;
    var phi_1402_: f32;
    var phi_1410_: f32;
    var phi_1420_: bool;
    var phi_1421_: bool;
    var phi_1425_: f32;
    var phi_1426_: f32;
    var phi_1427_: f32;
    var phi_1428_: f32;
    var phi_1436_: f32;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1451_: f32;
    var phi_1452_: f32;
    var phi_1453_: f32;
    var phi_1454_: f32;
    var phi_1462_: f32;
    var phi_1477_: f32;
    var phi_1478_: bool;
    var phi_1479_: f32;
    var phi_1480_: bool;
    var phi_1481_: f32;
    var phi_1482_: bool;
    var phi_1500_: f32;
    var phi_1501_: bool;
    var phi_1502_: bool;
    var phi_1503_: f32;
    var phi_1504_: bool;
    var phi_1505_: bool;
    var phi_1509_: bool;
    var phi_1510_: f32;
    var phi_1511_: bool;
    var phi_1539_: vec3<f32>;
    var phi_1540_: vec3<f32>;
    var phi_1565_: vec3<f32>;
    var phi_1566_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1592_: vec3<f32>;
    var phi_1648_: f32;
    var phi_1657_: f32;
    var phi_1666_: f32;
    var phi_1675_: f32;
    var phi_1682_: f32;
    var phi_1689_: f32;
    var phi_1702_: f32;
    var phi_1711_: f32;
    var phi_1720_: f32;
    var phi_1729_: f32;
    var phi_1736_: f32;
    var phi_1743_: f32;
    var phi_1760_: f32;
    var phi_1765_: f32;
    var phi_1770_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1788_: f32;
    var phi_1800_: f32;
    var phi_1805_: f32;
    var phi_1810_: f32;
    var phi_1815_: f32;
    var phi_1820_: lt_bvh_triangle_Intersection;
    var phi_1821_: bool;
    var phi_1822_: lt_bvh_triangle_Intersection;
    var phi_1823_: bool;
    var phi_1827_: lt_bvh_triangle_Intersection;
    var phi_1828_: bool;
    var phi_1829_: lt_bvh_triangle_Intersection;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1835_: bool;
    var phi_1839_: lt_bvh_triangle_Intersection;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1866_: bool;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1870_: bool;
    var phi_1871_: bool;
    var phi_1872_: bool;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var phi_1881_: bool;
    var phi_1882_: bool;
    var phi_1883_: bool;
    var phi_1887_: bool;
    var phi_1888_: bool;
    var phi_1240_: u32;
    var phi_1889_: bool;
    var phi_1890_: bool;
    var phi_1891_: bool;
    var local_3: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var phi_1917_: u32;
    var phi_1918_: u32;
    var phi_1922_: u32;
    var phi_1923_: u32;
    var phi_1924_: u32;
    var phi_1925_: u32;
    var phi_1926_: bool;
    var phi_1927_: bool;
    var phi_1928_: bool;
    var phi_1949_: u32;
    var phi_1950_: u32;
    var phi_1951_: u32;
    var phi_1952_: u32;
    var phi_1953_: u32;
    var phi_1954_: u32;
    var phi_1955_: bool;
    var phi_1956_: bool;
    var phi_950_: u32;
    var phi_953_: u32;
    var phi_1957_: bool;
    var phi_1958_: bool;
    var phi_1959_: bool;
    var local_4: bool;
    var phi_1963_: bool;
    var phi_1964_: bool;
    var phi_1968_: bool;
    var phi_1972_: bool;
    var phi_1976_: bool;
    var phi_1977_: bool;
    var phi_1981_: bool;
    var phi_1997_: bool;
    var phi_1998_: bool;
    var phi_1999_: bool;
    var phi_2000_: bool;
    var phi_2004_: bool;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2024_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2039_: bool;
    var phi_2043_: bool;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_2051_: bool;
    var phi_2121_: f32;
    var phi_2128_: f32;
    var phi_2135_: f32;
    var phi_2142_: f32;
    var phi_2149_: f32;
    var phi_2156_: f32;
    var phi_2173_: f32;
    var phi_2178_: f32;
    var phi_2183_: f32;
    var phi_2188_: f32;
    var phi_2193_: f32;
    var phi_2219_: bool;
    var phi_2220_: bool;
    var phi_2228_: u32;
    var phi_2229_: u32;
    var phi_2240_: vec3<f32>;
    var phi_2241_: vec3<f32>;
    var phi_2254_: u32;
    var phi_2259_: u32;
    var phi_2264_: u32;
    var phi_2378_: bool;
    var phi_2379_: bool;
    var phi_2410_: u32;
    var phi_2412_: u32;
    var phi_2415_: bool;
    var phi_2495_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2522_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2549_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2555_: u32;
    var phi_2558_: u32;
    var phi_2572_: u32;
    var phi_2582_: u32;
    var phi_2592_: u32;
    var phi_2610_: u32;
    var phi_2620_: u32;
    var phi_2630_: u32;
    var phi_2666_: u32;
    var phi_2679_: u32;
    var phi_2684_: u32;
    var phi_2685_: u32;
    var phi_2686_: u32;
    var phi_2556_: u32;
    var phi_2559_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2744_: u32;
    var phi_2747_: bool;
    var phi_2791_: vec3<f32>;
    var phi_2792_: vec3<f32>;
    var phi_2821_: vec3<f32>;
    var phi_2822_: vec3<f32>;
    var phi_2851_: vec3<f32>;
    var phi_2852_: vec3<f32>;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var phi_2875_: f32;
    var phi_2876_: f32;
    var phi_2877_: f32;
    var phi_2878_: f32;
    var phi_2886_: f32;
    var phi_2896_: bool;
    var phi_2897_: bool;
    var phi_2901_: f32;
    var phi_2902_: f32;
    var phi_2903_: f32;
    var phi_2904_: f32;
    var phi_2912_: f32;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2927_: f32;
    var phi_2928_: f32;
    var phi_2929_: f32;
    var phi_2930_: f32;
    var phi_2938_: f32;
    var phi_2953_: f32;
    var phi_2954_: bool;
    var phi_2955_: f32;
    var phi_2956_: bool;
    var phi_2957_: f32;
    var phi_2958_: bool;
    var phi_2976_: f32;
    var phi_2977_: bool;
    var phi_2978_: bool;
    var phi_2979_: f32;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2985_: bool;
    var phi_2986_: f32;
    var phi_2987_: bool;
    var phi_3015_: vec3<f32>;
    var phi_3016_: vec3<f32>;
    var phi_3041_: vec3<f32>;
    var phi_3042_: vec3<f32>;
    var phi_3067_: vec3<f32>;
    var phi_3068_: vec3<f32>;
    var phi_3124_: f32;
    var phi_3133_: f32;
    var phi_3142_: f32;
    var phi_3151_: f32;
    var phi_3158_: f32;
    var phi_3165_: f32;
    var phi_3178_: f32;
    var phi_3187_: f32;
    var phi_3196_: f32;
    var phi_3205_: f32;
    var phi_3212_: f32;
    var phi_3219_: f32;
    var phi_3236_: f32;
    var phi_3241_: f32;
    var phi_3246_: f32;
    var phi_3254_: f32;
    var phi_3259_: f32;
    var phi_3264_: f32;
    var phi_3276_: f32;
    var phi_3281_: f32;
    var phi_3286_: f32;
    var phi_3291_: f32;
    var phi_3296_: lt_bvh_triangle_Intersection;
    var phi_3297_: bool;
    var phi_3298_: lt_bvh_triangle_Intersection;
    var phi_3299_: bool;
    var phi_3303_: lt_bvh_triangle_Intersection;
    var phi_3304_: bool;
    var phi_3305_: lt_bvh_triangle_Intersection;
    var phi_3306_: bool;
    var phi_3307_: bool;
    var phi_3311_: bool;
    var phi_3315_: lt_bvh_triangle_Intersection;
    var phi_3335_: bool;
    var phi_3336_: bool;
    var phi_3337_: bool;
    var phi_3338_: bool;
    var phi_3339_: bool;
    var phi_3340_: bool;
    var phi_3341_: bool;
    var phi_2745_: u32;
    var phi_2748_: bool;
    var phi_3345_: bool;
    var local_8: bool;
    var phi_3387_: bool;
    var phi_3388_: bool;
    var phi_3419_: u32;
    var phi_3420_: u32;
    var phi_2413_: u32;
    var phi_2416_: bool;
    var phi_3421_: bool;
    var phi_3422_: bool;
    var local_9: bool;
    var phi_3426_: bool;
    var phi_3430_: bool;
    var phi_3431_: bool;
    var phi_3432_: bool;
    var phi_3433_: bool;
    var phi_3437_: bool;
    var phi_3438_: bool;
    var phi_3439_: bool;
    var phi_3443_: f32;
    var phi_3444_: f32;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e68 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&rows.member));
    let _e88 = p.member.size[0u];
    let _e90 = p.member.size[1u];
    let _e91 = lt_shaders_entry_pixel_index(_e68, _e88, _e90);
    if (bitcast<i32>(_e91.word) != 0i) {
        if (_e91.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e99 = samples.member[(0u + _e91.shift)];
        local_2 = abi_Sample(_e99.position, _e99.magnitude, _e99.normal, _e99.flags, _e99.shading_normal, _e99.albedo);
        let _e108 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e108 {
            let _e110 = local_2.position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = local_2.normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_395_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_394_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_394_ = false;
                    }
                    let _e168 = phi_394_;
                    phi_395_ = _e168;
                }
                let _e170 = phi_395_;
                if _e170 {
                    let _e172 = local_2.flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_406_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_407_ = false;
                } else {
                    phi_406_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_407_ = true;
                }
                let _e191 = phi_406_;
                let _e193 = phi_407_;
                phi_408_ = _e191;
                phi_409_ = _e193;
            } else {
                phi_408_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_409_ = true;
            }
            let _e195 = phi_408_;
            let _e197 = phi_409_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_416_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_416_ = _e195;
            }
            let _e214 = phi_416_;
            phi_420_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_420_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_420_;
        let _e235 = space.member;
        if _e231.unnamed_1 {
            phi_3444_ = _e231.unnamed.visibility;
        } else {
            let _e238 = local_2.position;
            let _e240 = local_2.normal;
            let _e242 = local_2.magnitude;
            let _e244 = ((8f / 8388608f) * _e242);
            let _e246 = (_e240.x * _e244);
            let _e248 = (_e240.y * _e244);
            let _e250 = (_e240.z * _e244);
            let _e252 = (_e238.x + _e246);
            let _e254 = (_e238.y + _e248);
            let _e256 = (_e238.z + _e250);
            let _e260 = p.member.light.place;
            if (_e260.w == 0f) {
                phi_464_ = 300000000000000000000000000000000000000f;
            } else {
                phi_464_ = 1f;
            }
            let _e264 = phi_464_;
            let _e272 = (_e260.x - (_e252 * _e260.w));
            let _e273 = (_e260.y - (_e254 * _e260.w));
            let _e274 = (_e260.z - (_e256 * _e260.w));
            let _e275 = vec3<f32>(_e272, _e273, _e274);
            let _e276 = abs(_e272);
            let _e277 = abs(_e273);
            let _e278 = abs(_e274);
            if (abs(_e252) < 1000000000000000f) {
                if (abs(_e254) < 1000000000000000f) {
                    phi_497_ = (abs(_e256) < 1000000000000000f);
                    phi_498_ = false;
                } else {
                    phi_497_ = bool();
                    phi_498_ = true;
                }
                let _e286 = phi_497_;
                let _e288 = phi_498_;
                phi_499_ = _e286;
                phi_500_ = _e288;
            } else {
                phi_499_ = bool();
                phi_500_ = true;
            }
            let _e290 = phi_499_;
            let _e292 = phi_500_;
            if _e292 {
                phi_504_ = false;
            } else {
                phi_504_ = _e290;
            }
            let _e294 = phi_504_;
            if _e294 {
                if (_e276 < 1000000000000000f) {
                    if (_e277 < 1000000000000000f) {
                        phi_517_ = (_e278 < 1000000000000000f);
                        phi_518_ = false;
                    } else {
                        phi_517_ = bool();
                        phi_518_ = true;
                    }
                    let _e299 = phi_517_;
                    let _e301 = phi_518_;
                    phi_519_ = _e299;
                    phi_520_ = _e301;
                } else {
                    phi_519_ = bool();
                    phi_520_ = true;
                }
                let _e303 = phi_519_;
                let _e305 = phi_520_;
                if _e305 {
                    phi_524_ = false;
                } else {
                    phi_524_ = _e303;
                }
                let _e307 = phi_524_;
                if _e307 {
                    if (_e276 > 0f) {
                        phi_538_ = bool();
                        phi_539_ = true;
                    } else {
                        let _e309 = (_e277 > 0f);
                        if _e309 {
                            phi_537_ = bool();
                        } else {
                            phi_537_ = (_e278 > 0f);
                        }
                        let _e312 = phi_537_;
                        phi_538_ = _e312;
                        phi_539_ = _e309;
                    }
                    let _e314 = phi_538_;
                    let _e316 = phi_539_;
                    if _e316 {
                        phi_543_ = true;
                    } else {
                        phi_543_ = _e314;
                    }
                    let _e318 = phi_543_;
                    phi_544_ = _e318;
                    phi_545_ = false;
                } else {
                    phi_544_ = bool();
                    phi_545_ = true;
                }
                let _e320 = phi_544_;
                let _e322 = phi_545_;
                phi_546_ = _e320;
                phi_547_ = _e322;
            } else {
                phi_546_ = bool();
                phi_547_ = true;
            }
            let _e324 = phi_546_;
            let _e326 = phi_547_;
            if _e326 {
                phi_551_ = false;
            } else {
                phi_551_ = _e324;
            }
            let _e328 = phi_551_;
            if _e328 {
                if (_e235.low.x <= _e252) {
                    if (_e252 <= _e235.high.x) {
                        if (_e235.low.y <= _e254) {
                            phi_574_ = (_e254 <= _e235.high.y);
                            phi_575_ = false;
                        } else {
                            phi_574_ = bool();
                            phi_575_ = true;
                        }
                        let _e346 = phi_574_;
                        let _e348 = phi_575_;
                        phi_576_ = _e346;
                        phi_577_ = _e348;
                    } else {
                        phi_576_ = bool();
                        phi_577_ = true;
                    }
                    let _e350 = phi_576_;
                    let _e352 = phi_577_;
                    phi_578_ = _e350;
                    phi_579_ = _e352;
                } else {
                    phi_578_ = bool();
                    phi_579_ = true;
                }
                let _e354 = phi_578_;
                let _e356 = phi_579_;
                if _e356 {
                    phi_583_ = false;
                } else {
                    phi_583_ = _e354;
                }
                let _e358 = phi_583_;
                if (abs(_e272) > 0.000000000000000000000000000001f) {
                    phi_597_ = bool();
                    phi_598_ = true;
                } else {
                    let _e363 = (abs(_e273) > 0.000000000000000000000000000001f);
                    if _e363 {
                        phi_596_ = bool();
                    } else {
                        phi_596_ = (abs(_e274) > 0.000000000000000000000000000001f);
                    }
                    let _e366 = phi_596_;
                    phi_597_ = _e366;
                    phi_598_ = _e363;
                }
                let _e368 = phi_597_;
                let _e370 = phi_598_;
                if _e370 {
                    phi_602_ = true;
                } else {
                    phi_602_ = _e368;
                }
                let _e372 = phi_602_;
                if _e358 {
                    if (_e235.low.z <= _e256) {
                        if (_e256 <= _e235.high.z) {
                            if (_e235.is_parallel == 0u) {
                                phi_619_ = _e372;
                            } else {
                                phi_619_ = true;
                            }
                            let _e378 = phi_619_;
                            phi_620_ = _e378;
                            phi_621_ = false;
                        } else {
                            phi_620_ = bool();
                            phi_621_ = true;
                        }
                        let _e380 = phi_620_;
                        let _e382 = phi_621_;
                        phi_622_ = _e380;
                        phi_623_ = _e382;
                    } else {
                        phi_622_ = bool();
                        phi_623_ = true;
                    }
                    let _e384 = phi_622_;
                    let _e386 = phi_623_;
                    phi_624_ = _e384;
                    phi_625_ = _e386;
                } else {
                    phi_624_ = bool();
                    phi_625_ = true;
                }
                let _e388 = phi_624_;
                let _e390 = phi_625_;
                if _e390 {
                    phi_629_ = false;
                } else {
                    phi_629_ = _e388;
                }
                let _e392 = phi_629_;
                if _e392 {
                    if (_e235.is_parallel == 0u) {
                        let _e395 = abs(_e272);
                        let _e396 = abs(_e273);
                        let _e397 = abs(_e274);
                        if (_e395 >= _e396) {
                            if (_e395 >= _e397) {
                                phi_649_ = false;
                            } else {
                                phi_649_ = true;
                            }
                            let _e401 = phi_649_;
                            phi_650_ = _e401;
                        } else {
                            phi_650_ = true;
                        }
                        let _e403 = phi_650_;
                        if _e403 {
                            if (_e396 >= _e397) {
                                phi_658_ = 1u;
                                phi_659_ = _e273;
                            } else {
                                phi_658_ = 2u;
                                phi_659_ = _e274;
                            }
                            let _e406 = phi_658_;
                            let _e408 = phi_659_;
                            phi_660_ = _e406;
                            phi_661_ = _e408;
                        } else {
                            phi_660_ = 0u;
                            phi_661_ = _e272;
                        }
                        let _e410 = phi_660_;
                        let _e412 = phi_661_;
                        if (_e412 < 0f) {
                            phi_666_ = -1f;
                        } else {
                            phi_666_ = 1f;
                        }
                        let _e415 = phi_666_;
                        let _e416 = (_e415 < 0f);
                        if (_e410 == 0u) {
                            if _e416 {
                                phi_677_ = _e235.roots.y;
                            } else {
                                phi_677_ = _e235.roots.x;
                            }
                            let _e423 = phi_677_;
                            phi_695_ = _e423;
                        } else {
                            if (_e410 == 1u) {
                                if _e416 {
                                    phi_687_ = _e235.roots.w;
                                } else {
                                    phi_687_ = _e235.roots.z;
                                }
                                let _e430 = phi_687_;
                                phi_694_ = _e430;
                            } else {
                                if _e416 {
                                    phi_693_ = _e235.roots_z.y;
                                } else {
                                    phi_693_ = _e235.roots_z.x;
                                }
                                let _e436 = phi_693_;
                                phi_694_ = _e436;
                            }
                            let _e438 = phi_694_;
                            phi_695_ = _e438;
                        }
                        let _e440 = phi_695_;
                        if (_e410 == 0u) {
                            phi_707_ = vec3<f32>(_e273, _e274, _e272);
                        } else {
                            if (_e410 == 1u) {
                                phi_706_ = vec3<f32>(_e274, _e272, _e273);
                            } else {
                                phi_706_ = _e275;
                            }
                            let _e446 = phi_706_;
                            phi_707_ = _e446;
                        }
                        let _e448 = phi_707_;
                        phi_753_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e448.x / _e448.z), (_e448.y / _e448.z), (_e415 / _e448.z)), _e440);
                    } else {
                        if (_e235.axis == 0u) {
                            phi_730_ = vec3<f32>(_e254, _e256, _e252);
                        } else {
                            if (_e235.axis == 1u) {
                                phi_729_ = vec3<f32>(_e256, _e252, _e254);
                            } else {
                                phi_729_ = (_e238 + vec3<f32>(_e246, _e248, _e250));
                            }
                            let _e465 = phi_729_;
                            phi_730_ = _e465;
                        }
                        let _e467 = phi_730_;
                        let _e479 = (_e467.z - _e235.middle.z);
                        phi_753_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e467.x - _e235.middle.x) - (_e235.shear.x * _e479)), ((_e467.y - _e235.middle.y) - (_e235.shear.y * _e479)), (_e235.sign * _e479)), _e235.roots.x);
                    }
                    let _e492 = phi_753_;
                    if (_e492.unnamed_1 == 4294967295u) {
                        phi_1976_ = false;
                        phi_1977_ = true;
                    } else {
                        if (0u < _e75) {
                        } else {
                            return;
                        }
                        let _e500 = nodes.member[0u].frame[0u];
                        let _e504 = nodes.member[0u].frame[1u];
                        let _e508 = nodes.member[0u].frame[2u];
                        let _e512 = nodes.member[0u].frame[0u];
                        let _e516 = nodes.member[0u].frame[1u];
                        let _e520 = nodes.member[0u].frame[2u];
                        let _e524 = nodes.member[0u].frame[3u];
                        let _e558 = core_intrinsics_maximum_number_nsz_f32_(abs(_e272), abs(_e273));
                        let _e559 = core_intrinsics_maximum_number_nsz_f32_(_e558, abs(_e274));
                        let _e560 = (_e559 * 0.0000000000009094947f);
                        if (abs(_e272) < _e560) {
                            phi_821_ = _e560;
                        } else {
                            phi_821_ = abs(_e272);
                        }
                        let _e565 = phi_821_;
                        if (_e272 < 0f) {
                            phi_828_ = (-1f / _e565);
                        } else {
                            phi_828_ = (1f / _e565);
                        }
                        let _e570 = phi_828_;
                        if (abs(_e273) < _e560) {
                            phi_835_ = _e560;
                        } else {
                            phi_835_ = abs(_e273);
                        }
                        let _e575 = phi_835_;
                        if (_e273 < 0f) {
                            phi_842_ = (-1f / _e575);
                        } else {
                            phi_842_ = (1f / _e575);
                        }
                        let _e580 = phi_842_;
                        if (abs(_e274) < _e560) {
                            phi_849_ = _e560;
                        } else {
                            phi_849_ = abs(_e274);
                        }
                        let _e585 = phi_849_;
                        if (_e274 < 0f) {
                            phi_856_ = (-1f / _e585);
                        } else {
                            phi_856_ = (1f / _e585);
                        }
                        let _e590 = phi_856_;
                        let _e594 = abs((bitcast<f32>(_e500) - _e252));
                        let _e595 = abs((bitcast<f32>(_e504) - _e254));
                        let _e596 = abs((bitcast<f32>(_e508) - _e256));
                        let _e600 = abs(((bitcast<f32>(_e512) + (bitcast<f32>((((_e524 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e252));
                        let _e601 = abs(((bitcast<f32>(_e516) + (bitcast<f32>((((_e524 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e254));
                        let _e602 = abs(((bitcast<f32>(_e520) + (bitcast<f32>((((_e524 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e256));
                        if (_e594 > _e600) {
                            phi_873_ = _e594;
                        } else {
                            phi_873_ = _e600;
                        }
                        let _e605 = phi_873_;
                        if (_e595 > _e601) {
                            phi_878_ = _e595;
                        } else {
                            phi_878_ = _e601;
                        }
                        let _e608 = phi_878_;
                        if (_e596 > _e602) {
                            phi_883_ = _e596;
                        } else {
                            phi_883_ = _e602;
                        }
                        let _e611 = phi_883_;
                        if (_e605 > _e608) {
                            phi_888_ = _e605;
                        } else {
                            phi_888_ = _e608;
                        }
                        let _e614 = phi_888_;
                        if (_e614 > _e611) {
                            phi_893_ = _e614;
                        } else {
                            phi_893_ = _e611;
                        }
                        let _e617 = phi_893_;
                        let _e624 = (_e617 * 0.0000009536743f);
                        let _e625 = (abs(_e570) * _e624);
                        let _e626 = (abs(_e580) * _e624);
                        let _e627 = (abs(_e590) * _e624);
                        let _e628 = abs(_e272);
                        let _e629 = abs(_e273);
                        let _e630 = abs(_e274);
                        if (_e628 >= _e629) {
                            if (_e628 >= _e630) {
                                phi_915_ = false;
                            } else {
                                phi_915_ = true;
                            }
                            let _e634 = phi_915_;
                            phi_916_ = _e634;
                        } else {
                            phi_916_ = true;
                        }
                        let _e636 = phi_916_;
                        if _e636 {
                            if (_e629 >= _e630) {
                                phi_924_ = 1u;
                            } else {
                                phi_924_ = 2u;
                            }
                            let _e639 = phi_924_;
                            phi_925_ = _e639;
                        } else {
                            phi_925_ = 0u;
                        }
                        let _e641 = phi_925_;
                        if (_e641 == 0u) {
                            phi_937_ = vec3<f32>(_e273, _e274, _e272);
                        } else {
                            if (_e641 == 1u) {
                                phi_936_ = vec3<f32>(_e274, _e272, _e273);
                            } else {
                                phi_936_ = _e275;
                            }
                            let _e647 = phi_936_;
                            phi_937_ = _e647;
                        }
                        let _e649 = phi_937_;
                        let _e652 = (_e649.x / _e649.z);
                        let _e655 = (_e649.y / _e649.z);
                        local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_949_ = ((_e492.unnamed_1 << bitcast<u32>(8i)) | 1u);
                        phi_952_ = 0u;
                        loop {
                            let _e662 = phi_949_;
                            let _e664 = phi_952_;
                            let _e665 = (_e662 == 0u);
                            local_4 = _e665;
                            if _e665 {
                                phi_950_ = u32();
                                phi_953_ = u32();
                                phi_1957_ = false;
                                phi_1958_ = false;
                                phi_1959_ = false;
                            } else {
                                let _e673 = (_e662 & (_e662 - 1u));
                                let _e674 = (((_e662 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e662), 32u, (_e662 == 0u))) * 4u);
                                if (_e674 < _e84) {
                                } else {
                                    return;
                                }
                                let _e678 = rows.member[(0u + _e674)];
                                let _e679 = (_e674 + 1u);
                                if (_e679 < _e84) {
                                } else {
                                    return;
                                }
                                let _e683 = rows.member[(0u + _e679)];
                                let _e684 = (_e674 + 2u);
                                if (_e684 < _e84) {
                                } else {
                                    return;
                                }
                                let _e688 = rows.member[(0u + _e684)];
                                let _e689 = (_e674 + 3u);
                                if (_e689 < _e84) {
                                } else {
                                    return;
                                }
                                let _e693 = rows.member[(0u + _e689)];
                                let _e694 = lt_bvh_LightNode(_e678, _e683, _e688, _e693);
                                let _e706 = (_e492.unnamed.positive_exponent - bitcast<f32>(_e694.frame.x));
                                let _e709 = bitcast<f32>((((_e694.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e706 > 0f) {
                                    if (_e706 < (255f * _e709)) {
                                        phi_1021_ = (_e706 / _e709);
                                    } else {
                                        phi_1021_ = 255f;
                                    }
                                    let _e715 = phi_1021_;
                                    phi_1022_ = _e715;
                                } else {
                                    phi_1022_ = 0f;
                                }
                                let _e717 = phi_1022_;
                                let _e724 = select(select(u32(_e717), 0u, (_e717 < bitcast<f32>(0u))), 4294967295u, (_e717 > bitcast<f32>(1333788671u)));
                                if (f32(_e724) < _e717) {
                                    phi_1036_ = (_e724 + 1u);
                                } else {
                                    phi_1036_ = _e724;
                                }
                                let _e729 = phi_1036_;
                                let _e730 = (_e724 * 16843009u);
                                let _e731 = (_e729 * 16843009u);
                                let _e741 = (_e492.unnamed.negative_exponent - bitcast<f32>(_e694.frame.y));
                                let _e744 = bitcast<f32>((((_e694.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e741 > 0f) {
                                    if (_e741 < (255f * _e744)) {
                                        phi_1059_ = (_e741 / _e744);
                                    } else {
                                        phi_1059_ = 255f;
                                    }
                                    let _e750 = phi_1059_;
                                    phi_1060_ = _e750;
                                } else {
                                    phi_1060_ = 0f;
                                }
                                let _e752 = phi_1060_;
                                let _e759 = select(select(u32(_e752), 0u, (_e752 < bitcast<f32>(0u))), 4294967295u, (_e752 > bitcast<f32>(1333788671u)));
                                if (f32(_e759) < _e752) {
                                    phi_1074_ = (_e759 + 1u);
                                } else {
                                    phi_1074_ = _e759;
                                }
                                let _e764 = phi_1074_;
                                let _e765 = (_e759 * 16843009u);
                                let _e766 = (_e764 * 16843009u);
                                let _e776 = (_e492.unnamed.min_variance - bitcast<f32>(_e694.frame.z));
                                let _e779 = bitcast<f32>((((_e694.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e776 > 0f) {
                                    if (_e776 < (255f * _e779)) {
                                        phi_1097_ = (_e776 / _e779);
                                    } else {
                                        phi_1097_ = 255f;
                                    }
                                    let _e785 = phi_1097_;
                                    phi_1098_ = _e785;
                                } else {
                                    phi_1098_ = 0f;
                                }
                                let _e787 = phi_1098_;
                                let _e794 = select(select(u32(_e787), 0u, (_e787 < bitcast<f32>(0u))), 4294967295u, (_e787 > bitcast<f32>(1333788671u)));
                                if (f32(_e794) < _e787) {
                                    phi_1112_ = (_e794 + 1u);
                                } else {
                                    phi_1112_ = _e794;
                                }
                                let _e799 = phi_1112_;
                                let _e800 = (_e799 * 16843009u);
                                let _e933 = (((((((((((_e730 & ~(_e694.x.x)) | (~((_e694.x.x ^ _e730)) & ((_e730 | 2155905152u) - (_e694.x.x & 2139062143u)))) & ((_e694.x.z & ~(_e731)) | (~((_e731 ^ _e694.x.z)) & ((_e694.x.z | 2155905152u) - (_e731 & 2139062143u))))) & ((_e765 & ~(_e694.y.x)) | (~((_e694.y.x ^ _e765)) & ((_e765 | 2155905152u) - (_e694.y.x & 2139062143u))))) & ((_e694.y.z & ~(_e766)) | (~((_e766 ^ _e694.y.z)) & ((_e694.y.z | 2155905152u) - (_e766 & 2139062143u))))) & ((_e694.rest.x & ~(_e800)) | (~((_e800 ^ _e694.rest.x)) & ((_e694.rest.x | 2155905152u) - (_e800 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e730 & ~(_e694.x.y)) | (~((_e694.x.y ^ _e730)) & ((_e730 | 2155905152u) - (_e694.x.y & 2139062143u)))) & ((_e694.x.w & ~(_e731)) | (~((_e731 ^ _e694.x.w)) & ((_e694.x.w | 2155905152u) - (_e731 & 2139062143u))))) & ((_e765 & ~(_e694.y.y)) | (~((_e694.y.y ^ _e765)) & ((_e765 | 2155905152u) - (_e694.y.y & 2139062143u))))) & ((_e694.y.w & ~(_e766)) | (~((_e766 ^ _e694.y.w)) & ((_e694.y.w | 2155905152u) - (_e766 & 2139062143u))))) & ((_e694.rest.y & ~(_e800)) | (~((_e800 ^ _e694.rest.y)) & ((_e694.rest.y | 2155905152u) - (_e800 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                if ((_e694.frame.w & 16777216u) != 0u) {
                                    phi_1239_ = _e933;
                                    loop {
                                        let _e939 = phi_1239_;
                                        let _e940 = (_e939 == 0u);
                                        local_3 = _e940;
                                        local_12 = _e940;
                                        if _e940 {
                                            phi_1240_ = u32();
                                            phi_1889_ = false;
                                            phi_1890_ = false;
                                            phi_1891_ = false;
                                        } else {
                                            let _e943 = select(firstTrailingBit(_e939), 32u, (_e939 == 0u));
                                            let _e948 = (_e694.rest.z + (_e943 >> bitcast<u32>(2i)));
                                            if (_e948 < _e84) {
                                            } else {
                                                return;
                                            }
                                            let _e953 = rows.member[(0u + _e948)][0u];
                                            let _e957 = rows.member[(0u + _e948)][1u];
                                            let _e961 = rows.member[(0u + _e948)][2u];
                                            let _e965 = rows.member[(0u + _e948)][3u];
                                            if ((_e943 & 2u) == 0u) {
                                                phi_1279_ = _e957;
                                                phi_1280_ = _e953;
                                            } else {
                                                phi_1279_ = _e965;
                                                phi_1280_ = _e961;
                                            }
                                            let _e969 = phi_1279_;
                                            let _e971 = phi_1280_;
                                            if ((_e943 & 1u) == 0u) {
                                                phi_1286_ = _e971;
                                            } else {
                                                phi_1286_ = _e969;
                                            }
                                            let _e975 = phi_1286_;
                                            if (_e975 < _e78) {
                                            } else {
                                                return;
                                            }
                                            let _e982 = triangles.member[(0u + _e975)].v0_;
                                            let _e984 = (_e982.x - _e252);
                                            let _e986 = (_e982.y - _e254);
                                            let _e988 = (_e982.z - _e256);
                                            if (_e641 == 0u) {
                                                phi_1316_ = vec3<f32>(_e986, _e988, _e984);
                                            } else {
                                                if (_e641 == 1u) {
                                                    phi_1315_ = vec3<f32>(_e988, _e984, _e986);
                                                } else {
                                                    phi_1315_ = (_e982 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e996 = phi_1315_;
                                                phi_1316_ = _e996;
                                            }
                                            let _e998 = phi_1316_;
                                            let _e1002 = (_e998.x - (_e652 * _e998.z));
                                            let _e1006 = (_e998.y - (_e655 * _e998.z));
                                            let _e1008 = triangles.member[(0u + _e975)].v1_;
                                            let _e1010 = (_e1008.x - _e252);
                                            let _e1012 = (_e1008.y - _e254);
                                            let _e1014 = (_e1008.z - _e256);
                                            if (_e641 == 0u) {
                                                phi_1346_ = vec3<f32>(_e1012, _e1014, _e1010);
                                            } else {
                                                if (_e641 == 1u) {
                                                    phi_1345_ = vec3<f32>(_e1014, _e1010, _e1012);
                                                } else {
                                                    phi_1345_ = (_e1008 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e1022 = phi_1345_;
                                                phi_1346_ = _e1022;
                                            }
                                            let _e1024 = phi_1346_;
                                            let _e1028 = (_e1024.x - (_e652 * _e1024.z));
                                            let _e1032 = (_e1024.y - (_e655 * _e1024.z));
                                            let _e1034 = triangles.member[(0u + _e975)].v2_;
                                            let _e1036 = (_e1034.x - _e252);
                                            let _e1038 = (_e1034.y - _e254);
                                            let _e1040 = (_e1034.z - _e256);
                                            if (_e641 == 0u) {
                                                phi_1376_ = vec3<f32>(_e1038, _e1040, _e1036);
                                            } else {
                                                if (_e641 == 1u) {
                                                    phi_1375_ = vec3<f32>(_e1040, _e1036, _e1038);
                                                } else {
                                                    phi_1375_ = (_e1034 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e1048 = phi_1375_;
                                                phi_1376_ = _e1048;
                                            }
                                            let _e1050 = phi_1376_;
                                            let _e1054 = (_e1050.x - (_e652 * _e1050.z));
                                            let _e1058 = (_e1050.y - (_e655 * _e1050.z));
                                            if (_e1028 < _e1054) {
                                                phi_1395_ = true;
                                            } else {
                                                if (_e1028 == _e1054) {
                                                    phi_1394_ = (_e1032 < _e1058);
                                                } else {
                                                    phi_1394_ = false;
                                                }
                                                let _e1063 = phi_1394_;
                                                phi_1395_ = _e1063;
                                            }
                                            let _e1065 = phi_1395_;
                                            if _e1065 {
                                                phi_1399_ = _e1058;
                                                phi_1400_ = _e1054;
                                                phi_1401_ = _e1032;
                                                phi_1402_ = _e1028;
                                            } else {
                                                phi_1399_ = _e1032;
                                                phi_1400_ = _e1028;
                                                phi_1401_ = _e1058;
                                                phi_1402_ = _e1054;
                                            }
                                            let _e1067 = phi_1399_;
                                            let _e1069 = phi_1400_;
                                            let _e1071 = phi_1401_;
                                            let _e1073 = phi_1402_;
                                            let _e1076 = ((_e1073 * _e1067) - (_e1071 * _e1069));
                                            if _e1065 {
                                                phi_1410_ = -(_e1076);
                                            } else {
                                                phi_1410_ = _e1076;
                                            }
                                            let _e1079 = phi_1410_;
                                            if (_e1054 < _e1002) {
                                                phi_1421_ = true;
                                            } else {
                                                if (_e1054 == _e1002) {
                                                    phi_1420_ = (_e1058 < _e1006);
                                                } else {
                                                    phi_1420_ = false;
                                                }
                                                let _e1084 = phi_1420_;
                                                phi_1421_ = _e1084;
                                            }
                                            let _e1086 = phi_1421_;
                                            if _e1086 {
                                                phi_1425_ = _e1006;
                                                phi_1426_ = _e1002;
                                                phi_1427_ = _e1058;
                                                phi_1428_ = _e1054;
                                            } else {
                                                phi_1425_ = _e1058;
                                                phi_1426_ = _e1054;
                                                phi_1427_ = _e1006;
                                                phi_1428_ = _e1002;
                                            }
                                            let _e1088 = phi_1425_;
                                            let _e1090 = phi_1426_;
                                            let _e1092 = phi_1427_;
                                            let _e1094 = phi_1428_;
                                            let _e1097 = ((_e1094 * _e1088) - (_e1092 * _e1090));
                                            if _e1086 {
                                                phi_1436_ = -(_e1097);
                                            } else {
                                                phi_1436_ = _e1097;
                                            }
                                            let _e1100 = phi_1436_;
                                            if (_e1002 < _e1028) {
                                                phi_1447_ = true;
                                            } else {
                                                if (_e1002 == _e1028) {
                                                    phi_1446_ = (_e1006 < _e1032);
                                                } else {
                                                    phi_1446_ = false;
                                                }
                                                let _e1105 = phi_1446_;
                                                phi_1447_ = _e1105;
                                            }
                                            let _e1107 = phi_1447_;
                                            if _e1107 {
                                                phi_1451_ = _e1032;
                                                phi_1452_ = _e1028;
                                                phi_1453_ = _e1006;
                                                phi_1454_ = _e1002;
                                            } else {
                                                phi_1451_ = _e1006;
                                                phi_1452_ = _e1002;
                                                phi_1453_ = _e1032;
                                                phi_1454_ = _e1028;
                                            }
                                            let _e1109 = phi_1451_;
                                            let _e1111 = phi_1452_;
                                            let _e1113 = phi_1453_;
                                            let _e1115 = phi_1454_;
                                            let _e1118 = ((_e1115 * _e1109) - (_e1113 * _e1111));
                                            if _e1107 {
                                                phi_1462_ = -(_e1118);
                                            } else {
                                                phi_1462_ = _e1118;
                                            }
                                            let _e1121 = phi_1462_;
                                            if (_e1079 >= 0f) {
                                                if (_e1100 >= 0f) {
                                                    if (_e1121 >= 0f) {
                                                        phi_1477_ = ((_e1079 + _e1100) + _e1121);
                                                        phi_1478_ = false;
                                                    } else {
                                                        phi_1477_ = f32();
                                                        phi_1478_ = true;
                                                    }
                                                    let _e1128 = phi_1477_;
                                                    let _e1130 = phi_1478_;
                                                    phi_1479_ = _e1128;
                                                    phi_1480_ = _e1130;
                                                } else {
                                                    phi_1479_ = f32();
                                                    phi_1480_ = true;
                                                }
                                                let _e1132 = phi_1479_;
                                                let _e1134 = phi_1480_;
                                                phi_1481_ = _e1132;
                                                phi_1482_ = _e1134;
                                            } else {
                                                phi_1481_ = f32();
                                                phi_1482_ = true;
                                            }
                                            let _e1136 = phi_1481_;
                                            let _e1138 = phi_1482_;
                                            if _e1138 {
                                                if (_e1079 <= 0f) {
                                                    if (_e1100 <= 0f) {
                                                        let _e1141 = (_e1121 <= 0f);
                                                        if _e1141 {
                                                        }
                                                        phi_1500_ = ((_e1079 + _e1100) + _e1121);
                                                        phi_1501_ = false;
                                                        phi_1502_ = _e1141;
                                                    } else {
                                                        phi_1500_ = f32();
                                                        phi_1501_ = true;
                                                        phi_1502_ = false;
                                                    }
                                                    let _e1145 = phi_1500_;
                                                    let _e1147 = phi_1501_;
                                                    let _e1149 = phi_1502_;
                                                    phi_1503_ = _e1145;
                                                    phi_1504_ = _e1147;
                                                    phi_1505_ = _e1149;
                                                } else {
                                                    phi_1503_ = f32();
                                                    phi_1504_ = true;
                                                    phi_1505_ = false;
                                                }
                                                let _e1151 = phi_1503_;
                                                let _e1153 = phi_1504_;
                                                let _e1155 = phi_1505_;
                                                if _e1153 {
                                                    phi_1509_ = false;
                                                } else {
                                                    phi_1509_ = _e1155;
                                                }
                                                let _e1157 = phi_1509_;
                                                phi_1510_ = _e1151;
                                                phi_1511_ = _e1157;
                                            } else {
                                                phi_1510_ = _e1136;
                                                phi_1511_ = true;
                                            }
                                            let _e1159 = phi_1510_;
                                            let _e1161 = phi_1511_;
                                            if _e1161 {
                                                let _e1162 = (_e1159 == 0f);
                                                if _e1162 {
                                                    phi_1827_ = lt_bvh_triangle_Intersection();
                                                    phi_1828_ = false;
                                                } else {
                                                    let _e1164 = triangles.member[(0u + _e975)].v0_;
                                                    let _e1166 = (_e1164.x - _e252);
                                                    let _e1168 = (_e1164.y - _e254);
                                                    let _e1170 = (_e1164.z - _e256);
                                                    if (_e641 == 0u) {
                                                        phi_1540_ = vec3<f32>(_e1168, _e1170, _e1166);
                                                    } else {
                                                        if (_e641 == 1u) {
                                                            phi_1539_ = vec3<f32>(_e1170, _e1166, _e1168);
                                                        } else {
                                                            phi_1539_ = (_e1164 - vec3<f32>(_e252, _e254, _e256));
                                                        }
                                                        let _e1178 = phi_1539_;
                                                        phi_1540_ = _e1178;
                                                    }
                                                    let _e1180 = phi_1540_;
                                                    let _e1182 = triangles.member[(0u + _e975)].v1_;
                                                    let _e1184 = triangles.member[(0u + _e975)].v0_;
                                                    let _e1187 = (_e1182.x - _e1184.x);
                                                    let _e1190 = (_e1182.y - _e1184.y);
                                                    let _e1193 = (_e1182.z - _e1184.z);
                                                    if (_e641 == 0u) {
                                                        phi_1566_ = vec3<f32>(_e1190, _e1193, _e1187);
                                                    } else {
                                                        if (_e641 == 1u) {
                                                            phi_1565_ = vec3<f32>(_e1193, _e1187, _e1190);
                                                        } else {
                                                            phi_1565_ = (_e1182 - _e1184);
                                                        }
                                                        let _e1200 = phi_1565_;
                                                        phi_1566_ = _e1200;
                                                    }
                                                    let _e1202 = phi_1566_;
                                                    let _e1204 = triangles.member[(0u + _e975)].v2_;
                                                    let _e1206 = triangles.member[(0u + _e975)].v0_;
                                                    let _e1209 = (_e1204.x - _e1206.x);
                                                    let _e1212 = (_e1204.y - _e1206.y);
                                                    let _e1215 = (_e1204.z - _e1206.z);
                                                    if (_e641 == 0u) {
                                                        phi_1592_ = vec3<f32>(_e1212, _e1215, _e1209);
                                                    } else {
                                                        if (_e641 == 1u) {
                                                            phi_1591_ = vec3<f32>(_e1215, _e1209, _e1212);
                                                        } else {
                                                            phi_1591_ = (_e1204 - _e1206);
                                                        }
                                                        let _e1222 = phi_1591_;
                                                        phi_1592_ = _e1222;
                                                    }
                                                    let _e1224 = phi_1592_;
                                                    let _e1231 = ((_e1202.y * _e1224.z) - (_e1202.z * _e1224.y));
                                                    let _e1238 = ((_e1202.z * _e1224.x) - (_e1202.x * _e1224.z));
                                                    let _e1245 = ((_e1202.x * _e1224.y) - (_e1202.y * _e1224.x));
                                                    let _e1259 = (((1f / _e649.z) * (((_e1231 * _e1180.x) + (_e1238 * _e1180.y)) + (_e1245 * _e1180.z))) / (((_e1231 * _e652) + (_e1238 * _e655)) + _e1245));
                                                    if (_e1259 > 0f) {
                                                        if (_e1259 < _e264) {
                                                            let _e1263 = triangles.member[(0u + _e975)].v0_;
                                                            let _e1265 = triangles.member[(0u + _e975)].v1_;
                                                            if (_e1263.x < _e1265.x) {
                                                                phi_1648_ = _e1263.x;
                                                            } else {
                                                                phi_1648_ = _e1265.x;
                                                            }
                                                            let _e1272 = phi_1648_;
                                                            if (_e1263.y < _e1265.y) {
                                                                phi_1657_ = _e1263.y;
                                                            } else {
                                                                phi_1657_ = _e1265.y;
                                                            }
                                                            let _e1279 = phi_1657_;
                                                            if (_e1263.z < _e1265.z) {
                                                                phi_1666_ = _e1263.z;
                                                            } else {
                                                                phi_1666_ = _e1265.z;
                                                            }
                                                            let _e1286 = phi_1666_;
                                                            let _e1288 = triangles.member[(0u + _e975)].v2_;
                                                            if (_e1272 < _e1288.x) {
                                                                phi_1675_ = _e1272;
                                                            } else {
                                                                phi_1675_ = _e1288.x;
                                                            }
                                                            let _e1293 = phi_1675_;
                                                            if (_e1279 < _e1288.y) {
                                                                phi_1682_ = _e1279;
                                                            } else {
                                                                phi_1682_ = _e1288.y;
                                                            }
                                                            let _e1298 = phi_1682_;
                                                            if (_e1286 < _e1288.z) {
                                                                phi_1689_ = _e1286;
                                                            } else {
                                                                phi_1689_ = _e1288.z;
                                                            }
                                                            let _e1303 = phi_1689_;
                                                            let _e1305 = triangles.member[(0u + _e975)].v0_;
                                                            let _e1307 = triangles.member[(0u + _e975)].v1_;
                                                            if (_e1305.x > _e1307.x) {
                                                                phi_1702_ = _e1305.x;
                                                            } else {
                                                                phi_1702_ = _e1307.x;
                                                            }
                                                            let _e1314 = phi_1702_;
                                                            if (_e1305.y > _e1307.y) {
                                                                phi_1711_ = _e1305.y;
                                                            } else {
                                                                phi_1711_ = _e1307.y;
                                                            }
                                                            let _e1321 = phi_1711_;
                                                            if (_e1305.z > _e1307.z) {
                                                                phi_1720_ = _e1305.z;
                                                            } else {
                                                                phi_1720_ = _e1307.z;
                                                            }
                                                            let _e1328 = phi_1720_;
                                                            let _e1330 = triangles.member[(0u + _e975)].v2_;
                                                            if (_e1314 > _e1330.x) {
                                                                phi_1729_ = _e1314;
                                                            } else {
                                                                phi_1729_ = _e1330.x;
                                                            }
                                                            let _e1335 = phi_1729_;
                                                            if (_e1321 > _e1330.y) {
                                                                phi_1736_ = _e1321;
                                                            } else {
                                                                phi_1736_ = _e1330.y;
                                                            }
                                                            let _e1340 = phi_1736_;
                                                            if (_e1328 > _e1330.z) {
                                                                phi_1743_ = _e1328;
                                                            } else {
                                                                phi_1743_ = _e1330.z;
                                                            }
                                                            let _e1345 = phi_1743_;
                                                            let _e1349 = ((_e1293 - _e252) * _e570);
                                                            let _e1350 = ((_e1298 - _e254) * _e580);
                                                            let _e1351 = ((_e1303 - _e256) * _e590);
                                                            let _e1355 = ((_e1335 - _e252) * _e570);
                                                            let _e1356 = ((_e1340 - _e254) * _e580);
                                                            let _e1357 = ((_e1345 - _e256) * _e590);
                                                            if (_e1349 < _e1355) {
                                                                phi_1760_ = _e1349;
                                                            } else {
                                                                phi_1760_ = _e1355;
                                                            }
                                                            let _e1360 = phi_1760_;
                                                            if (_e1350 < _e1356) {
                                                                phi_1765_ = _e1350;
                                                            } else {
                                                                phi_1765_ = _e1356;
                                                            }
                                                            let _e1363 = phi_1765_;
                                                            if (_e1351 < _e1357) {
                                                                phi_1770_ = _e1351;
                                                            } else {
                                                                phi_1770_ = _e1357;
                                                            }
                                                            let _e1366 = phi_1770_;
                                                            if (_e1349 > _e1355) {
                                                                phi_1778_ = _e1349;
                                                            } else {
                                                                phi_1778_ = _e1355;
                                                            }
                                                            let _e1372 = phi_1778_;
                                                            if (_e1350 > _e1356) {
                                                                phi_1783_ = _e1350;
                                                            } else {
                                                                phi_1783_ = _e1356;
                                                            }
                                                            let _e1375 = phi_1783_;
                                                            if (_e1351 > _e1357) {
                                                                phi_1788_ = _e1351;
                                                            } else {
                                                                phi_1788_ = _e1357;
                                                            }
                                                            let _e1378 = phi_1788_;
                                                            let _e1382 = core_intrinsics_maximum_number_nsz_f32_((_e1360 - _e625), (_e1363 - _e626));
                                                            let _e1383 = core_intrinsics_maximum_number_nsz_f32_(_e1382, (_e1366 - _e627));
                                                            let _e1384 = core_intrinsics_minimum_number_nsz_f32_((_e1372 + _e625), (_e1375 + _e626));
                                                            let _e1385 = core_intrinsics_minimum_number_nsz_f32_(_e1384, (_e1378 + _e627));
                                                            if (_e1383 > -300000000000000000000000000000000000000f) {
                                                                phi_1800_ = _e1383;
                                                            } else {
                                                                phi_1800_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e1388 = phi_1800_;
                                                            if (_e1385 < 300000000000000000000000000000000000000f) {
                                                                phi_1805_ = _e1385;
                                                            } else {
                                                                phi_1805_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e1391 = phi_1805_;
                                                            if (_e1259 < _e1388) {
                                                                phi_1810_ = _e1388;
                                                            } else {
                                                                phi_1810_ = _e1259;
                                                            }
                                                            let _e1394 = phi_1810_;
                                                            if (_e1394 > _e1391) {
                                                                phi_1815_ = _e1391;
                                                            } else {
                                                                phi_1815_ = _e1394;
                                                            }
                                                            let _e1397 = phi_1815_;
                                                            phi_1820_ = lt_bvh_triangle_Intersection(_e1397, (_e1100 / _e1159), (_e1121 / _e1159), (_e1388 <= _e1391));
                                                            phi_1821_ = false;
                                                        } else {
                                                            phi_1820_ = lt_bvh_triangle_Intersection();
                                                            phi_1821_ = true;
                                                        }
                                                        let _e1403 = phi_1820_;
                                                        let _e1405 = phi_1821_;
                                                        phi_1822_ = _e1403;
                                                        phi_1823_ = _e1405;
                                                    } else {
                                                        phi_1822_ = lt_bvh_triangle_Intersection();
                                                        phi_1823_ = true;
                                                    }
                                                    let _e1407 = phi_1822_;
                                                    let _e1409 = phi_1823_;
                                                    if _e1409 {
                                                    }
                                                    phi_1827_ = _e1407;
                                                    phi_1828_ = _e1409;
                                                }
                                                let _e1411 = phi_1827_;
                                                let _e1413 = phi_1828_;
                                                phi_1829_ = _e1411;
                                                phi_1830_ = _e1162;
                                                phi_1831_ = _e1413;
                                            } else {
                                                phi_1829_ = lt_bvh_triangle_Intersection();
                                                phi_1830_ = true;
                                                phi_1831_ = false;
                                            }
                                            let _e1415 = phi_1829_;
                                            let _e1417 = phi_1830_;
                                            let _e1419 = phi_1831_;
                                            if _e1417 {
                                                phi_1835_ = true;
                                            } else {
                                                phi_1835_ = _e1419;
                                            }
                                            let _e1421 = phi_1835_;
                                            if _e1421 {
                                                phi_1839_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_1839_ = _e1415;
                                            }
                                            let _e1423 = phi_1839_;
                                            if _e1423.is_hit {
                                                if (_e1423.t > 0f) {
                                                    if (_e1423.t < _e264) {
                                                        let _e1430 = triangles.member[(0u + _e975)].i0_;
                                                        let _e1432 = ((_e1430 & 2147483648u) == 0u);
                                                        if _e1432 {
                                                            phi_1865_ = false;
                                                            phi_1866_ = false;
                                                        } else {
                                                            if true {
                                                                phi_1864_ = false;
                                                            } else {
                                                                phi_1864_ = true;
                                                            }
                                                            let _e1434 = phi_1864_;
                                                            phi_1865_ = _e1434;
                                                            phi_1866_ = true;
                                                        }
                                                        let _e1436 = phi_1865_;
                                                        let _e1438 = phi_1866_;
                                                        phi_1867_ = _e1436;
                                                        phi_1868_ = _e1432;
                                                        phi_1869_ = _e1438;
                                                    } else {
                                                        phi_1867_ = true;
                                                        phi_1868_ = false;
                                                        phi_1869_ = false;
                                                    }
                                                    let _e1440 = phi_1867_;
                                                    let _e1442 = phi_1868_;
                                                    let _e1444 = phi_1869_;
                                                    phi_1870_ = false;
                                                    phi_1871_ = _e1440;
                                                    phi_1872_ = _e1442;
                                                    phi_1873_ = _e1444;
                                                } else {
                                                    phi_1870_ = true;
                                                    phi_1871_ = false;
                                                    phi_1872_ = false;
                                                    phi_1873_ = false;
                                                }
                                                let _e1446 = phi_1870_;
                                                let _e1448 = phi_1871_;
                                                let _e1450 = phi_1872_;
                                                let _e1452 = phi_1873_;
                                                phi_1874_ = _e1446;
                                                phi_1875_ = _e1448;
                                                phi_1876_ = _e1450;
                                                phi_1877_ = _e1452;
                                            } else {
                                                phi_1874_ = true;
                                                phi_1875_ = false;
                                                phi_1876_ = false;
                                                phi_1877_ = false;
                                            }
                                            let _e1454 = phi_1874_;
                                            let _e1456 = phi_1875_;
                                            let _e1458 = phi_1876_;
                                            let _e1460 = phi_1877_;
                                            if _e1454 {
                                                phi_1881_ = true;
                                                phi_1882_ = false;
                                                phi_1883_ = false;
                                            } else {
                                                phi_1881_ = _e1456;
                                                phi_1882_ = _e1458;
                                                phi_1883_ = _e1460;
                                            }
                                            let _e1462 = phi_1881_;
                                            let _e1464 = phi_1882_;
                                            let _e1466 = phi_1883_;
                                            if _e1462 {
                                                phi_1887_ = false;
                                                phi_1888_ = false;
                                            } else {
                                                phi_1887_ = _e1464;
                                                phi_1888_ = _e1466;
                                            }
                                            let _e1468 = phi_1887_;
                                            let _e1470 = phi_1888_;
                                            phi_1240_ = (_e939 & (_e939 - 1u));
                                            phi_1889_ = _e1462;
                                            phi_1890_ = _e1468;
                                            phi_1891_ = _e1470;
                                        }
                                        let _e1472 = phi_1240_;
                                        let _e1474 = phi_1889_;
                                        let _e1476 = phi_1890_;
                                        let _e1478 = phi_1891_;
                                        local_10 = _e1476;
                                        local_11 = _e1478;
                                        continue;
                                        continuing {
                                            phi_1239_ = _e1472;
                                            break if !(_e1474);
                                        }
                                    }
                                    let _e1481 = local_3;
                                    if _e1481 {
                                        phi_1895_ = false;
                                        phi_1896_ = false;
                                    } else {
                                        let _e3167 = local_10;
                                        phi_1895_ = _e3167;
                                        let _e3170 = local_11;
                                        phi_1896_ = _e3170;
                                    }
                                    let _e1483 = phi_1895_;
                                    let _e1485 = phi_1896_;
                                    phi_1924_ = _e673;
                                    phi_1925_ = _e664;
                                    let _e3179 = local_12;
                                    phi_1926_ = _e3179;
                                    phi_1927_ = _e1483;
                                    phi_1928_ = _e1485;
                                } else {
                                    if (_e933 == 0u) {
                                        phi_1922_ = _e673;
                                        phi_1923_ = _e664;
                                    } else {
                                        if ((_e673 & 255u) == 0u) {
                                            phi_1918_ = _e664;
                                        } else {
                                            if (_e664 < 32u) {
                                                if (_e664 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1[(0u + _e664)] = _e673;
                                                phi_1917_ = (_e664 + 1u);
                                            } else {
                                                phi_1917_ = _e664;
                                            }
                                            let _e1495 = phi_1917_;
                                            phi_1918_ = _e1495;
                                        }
                                        let _e1497 = phi_1918_;
                                        phi_1922_ = ((_e694.rest.z << bitcast<u32>(8i)) | _e933);
                                        phi_1923_ = _e1497;
                                    }
                                    let _e1504 = phi_1922_;
                                    let _e1506 = phi_1923_;
                                    phi_1924_ = _e1504;
                                    phi_1925_ = _e1506;
                                    phi_1926_ = true;
                                    phi_1927_ = false;
                                    phi_1928_ = false;
                                }
                                let _e1508 = phi_1924_;
                                let _e1510 = phi_1925_;
                                let _e1512 = phi_1926_;
                                let _e1514 = phi_1927_;
                                let _e1516 = phi_1928_;
                                if _e1512 {
                                    if ((_e1508 & 255u) == 0u) {
                                        if (_e1510 > 0u) {
                                            let _e1520 = (_e1510 - 1u);
                                            if (_e1520 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e1524 = local_1[(0u + _e1520)];
                                            phi_1949_ = _e1524;
                                            phi_1950_ = _e1520;
                                        } else {
                                            phi_1949_ = 0u;
                                            phi_1950_ = _e1510;
                                        }
                                        let _e1526 = phi_1949_;
                                        let _e1528 = phi_1950_;
                                        phi_1951_ = _e1526;
                                        phi_1952_ = _e1528;
                                    } else {
                                        phi_1951_ = _e1508;
                                        phi_1952_ = _e1510;
                                    }
                                    let _e1530 = phi_1951_;
                                    let _e1532 = phi_1952_;
                                    phi_1953_ = _e1530;
                                    phi_1954_ = _e1532;
                                    phi_1955_ = false;
                                    phi_1956_ = false;
                                } else {
                                    phi_1953_ = u32();
                                    phi_1954_ = u32();
                                    phi_1955_ = _e1514;
                                    phi_1956_ = _e1516;
                                }
                                let _e1534 = phi_1953_;
                                let _e1536 = phi_1954_;
                                let _e1538 = phi_1955_;
                                let _e1540 = phi_1956_;
                                phi_950_ = _e1534;
                                phi_953_ = _e1536;
                                phi_1957_ = _e1512;
                                phi_1958_ = _e1538;
                                phi_1959_ = _e1540;
                            }
                            let _e1542 = phi_950_;
                            let _e1544 = phi_953_;
                            let _e1546 = phi_1957_;
                            let _e1548 = phi_1958_;
                            let _e1550 = phi_1959_;
                            local_13 = _e1548;
                            local_14 = _e1550;
                            continue;
                            continuing {
                                phi_949_ = _e1542;
                                phi_952_ = _e1544;
                                break if !(_e1546);
                            }
                        }
                        let _e1553 = local_4;
                        if _e1553 {
                            phi_1963_ = false;
                            phi_1964_ = false;
                        } else {
                            let _e3198 = local_13;
                            phi_1963_ = _e3198;
                            let _e3201 = local_14;
                            phi_1964_ = _e3201;
                        }
                        let _e1555 = phi_1963_;
                        let _e1557 = phi_1964_;
                        if _e1555 {
                            phi_1968_ = false;
                        } else {
                            phi_1968_ = _e1557;
                        }
                        let _e1559 = phi_1968_;
                        if _e1559 {
                            phi_1972_ = true;
                        } else {
                            phi_1972_ = _e1555;
                        }
                        let _e1561 = phi_1972_;
                        if _e1561 {
                        }
                        phi_1976_ = true;
                        phi_1977_ = _e1561;
                    }
                    let _e1563 = phi_1976_;
                    let _e1565 = phi_1977_;
                    if _e1565 {
                        phi_1981_ = _e1563;
                    } else {
                        phi_1981_ = false;
                    }
                    let _e1567 = phi_1981_;
                    phi_3438_ = _e1567;
                } else {
                    let _e1568 = abs(_e272);
                    let _e1569 = abs(_e273);
                    let _e1570 = abs(_e274);
                    if (abs(_e252) < 1000000000000000f) {
                        if (abs(_e254) < 1000000000000000f) {
                            phi_1997_ = (abs(_e256) < 1000000000000000f);
                            phi_1998_ = false;
                        } else {
                            phi_1997_ = bool();
                            phi_1998_ = true;
                        }
                        let _e1578 = phi_1997_;
                        let _e1580 = phi_1998_;
                        phi_1999_ = _e1578;
                        phi_2000_ = _e1580;
                    } else {
                        phi_1999_ = bool();
                        phi_2000_ = true;
                    }
                    let _e1582 = phi_1999_;
                    let _e1584 = phi_2000_;
                    if _e1584 {
                        phi_2004_ = false;
                    } else {
                        phi_2004_ = _e1582;
                    }
                    let _e1586 = phi_2004_;
                    if _e1586 {
                        if (_e1568 < 1000000000000000f) {
                            if (_e1569 < 1000000000000000f) {
                                phi_2017_ = (_e1570 < 1000000000000000f);
                                phi_2018_ = false;
                            } else {
                                phi_2017_ = bool();
                                phi_2018_ = true;
                            }
                            let _e1591 = phi_2017_;
                            let _e1593 = phi_2018_;
                            phi_2019_ = _e1591;
                            phi_2020_ = _e1593;
                        } else {
                            phi_2019_ = bool();
                            phi_2020_ = true;
                        }
                        let _e1595 = phi_2019_;
                        let _e1597 = phi_2020_;
                        if _e1597 {
                            phi_2024_ = false;
                        } else {
                            phi_2024_ = _e1595;
                        }
                        let _e1599 = phi_2024_;
                        if _e1599 {
                            if (_e1568 > 0f) {
                                phi_2038_ = bool();
                                phi_2039_ = true;
                            } else {
                                let _e1601 = (_e1569 > 0f);
                                if _e1601 {
                                    phi_2037_ = bool();
                                } else {
                                    phi_2037_ = (_e1570 > 0f);
                                }
                                let _e1604 = phi_2037_;
                                phi_2038_ = _e1604;
                                phi_2039_ = _e1601;
                            }
                            let _e1606 = phi_2038_;
                            let _e1608 = phi_2039_;
                            if _e1608 {
                                phi_2043_ = true;
                            } else {
                                phi_2043_ = _e1606;
                            }
                            let _e1610 = phi_2043_;
                            phi_2044_ = _e1610;
                            phi_2045_ = false;
                        } else {
                            phi_2044_ = bool();
                            phi_2045_ = true;
                        }
                        let _e1612 = phi_2044_;
                        let _e1614 = phi_2045_;
                        phi_2046_ = _e1612;
                        phi_2047_ = _e1614;
                    } else {
                        phi_2046_ = bool();
                        phi_2047_ = true;
                    }
                    let _e1616 = phi_2046_;
                    let _e1618 = phi_2047_;
                    if _e1618 {
                        phi_2051_ = false;
                    } else {
                        phi_2051_ = _e1616;
                    }
                    let _e1620 = phi_2051_;
                    if _e1620 {
                        let _e1621 = (0u >= _e75);
                        if _e1621 {
                            phi_3431_ = bool();
                        } else {
                            if (0u < _e75) {
                            } else {
                                return;
                            }
                            let _e1627 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1631 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1635 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1639 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1643 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1647 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1651 = nodes.member[(0u + 0u)].frame[3u];
                            let _e1685 = core_intrinsics_maximum_number_nsz_f32_(abs(_e272), abs(_e273));
                            let _e1686 = core_intrinsics_maximum_number_nsz_f32_(_e1685, abs(_e274));
                            let _e1687 = (_e1686 * 0.0000000000009094947f);
                            if (abs(_e272) < _e1687) {
                                phi_2121_ = _e1687;
                            } else {
                                phi_2121_ = abs(_e272);
                            }
                            let _e1692 = phi_2121_;
                            if (_e272 < 0f) {
                                phi_2128_ = (-1f / _e1692);
                            } else {
                                phi_2128_ = (1f / _e1692);
                            }
                            let _e1697 = phi_2128_;
                            if (abs(_e273) < _e1687) {
                                phi_2135_ = _e1687;
                            } else {
                                phi_2135_ = abs(_e273);
                            }
                            let _e1702 = phi_2135_;
                            if (_e273 < 0f) {
                                phi_2142_ = (-1f / _e1702);
                            } else {
                                phi_2142_ = (1f / _e1702);
                            }
                            let _e1707 = phi_2142_;
                            if (abs(_e274) < _e1687) {
                                phi_2149_ = _e1687;
                            } else {
                                phi_2149_ = abs(_e274);
                            }
                            let _e1712 = phi_2149_;
                            if (_e274 < 0f) {
                                phi_2156_ = (-1f / _e1712);
                            } else {
                                phi_2156_ = (1f / _e1712);
                            }
                            let _e1717 = phi_2156_;
                            let _e1721 = abs((bitcast<f32>(_e1627) - _e252));
                            let _e1722 = abs((bitcast<f32>(_e1631) - _e254));
                            let _e1723 = abs((bitcast<f32>(_e1635) - _e256));
                            let _e1727 = abs(((bitcast<f32>(_e1639) + (bitcast<f32>((((_e1651 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e252));
                            let _e1728 = abs(((bitcast<f32>(_e1643) + (bitcast<f32>((((_e1651 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e254));
                            let _e1729 = abs(((bitcast<f32>(_e1647) + (bitcast<f32>((((_e1651 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e256));
                            if (_e1721 > _e1727) {
                                phi_2173_ = _e1721;
                            } else {
                                phi_2173_ = _e1727;
                            }
                            let _e1732 = phi_2173_;
                            if (_e1722 > _e1728) {
                                phi_2178_ = _e1722;
                            } else {
                                phi_2178_ = _e1728;
                            }
                            let _e1735 = phi_2178_;
                            if (_e1723 > _e1729) {
                                phi_2183_ = _e1723;
                            } else {
                                phi_2183_ = _e1729;
                            }
                            let _e1738 = phi_2183_;
                            if (_e1732 > _e1735) {
                                phi_2188_ = _e1732;
                            } else {
                                phi_2188_ = _e1735;
                            }
                            let _e1741 = phi_2188_;
                            if (_e1741 > _e1738) {
                                phi_2193_ = _e1741;
                            } else {
                                phi_2193_ = _e1738;
                            }
                            let _e1744 = phi_2193_;
                            let _e1748 = (_e1744 * 0.0000019073486f);
                            let _e1749 = (abs(_e1697) * _e1748);
                            let _e1750 = (abs(_e1707) * _e1748);
                            let _e1751 = (abs(_e1717) * _e1748);
                            let _e1755 = (_e1744 * 0.0000009536743f);
                            let _e1756 = (abs(_e1697) * _e1755);
                            let _e1757 = (abs(_e1707) * _e1755);
                            let _e1758 = (abs(_e1717) * _e1755);
                            let _e1759 = abs(_e272);
                            let _e1760 = abs(_e273);
                            let _e1761 = abs(_e274);
                            if (_e1759 >= _e1760) {
                                if (_e1759 >= _e1761) {
                                    phi_2219_ = false;
                                } else {
                                    phi_2219_ = true;
                                }
                                let _e1765 = phi_2219_;
                                phi_2220_ = _e1765;
                            } else {
                                phi_2220_ = true;
                            }
                            let _e1767 = phi_2220_;
                            if _e1767 {
                                if (_e1760 >= _e1761) {
                                    phi_2228_ = 1u;
                                } else {
                                    phi_2228_ = 2u;
                                }
                                let _e1770 = phi_2228_;
                                phi_2229_ = _e1770;
                            } else {
                                phi_2229_ = 0u;
                            }
                            let _e1772 = phi_2229_;
                            if (_e1772 == 0u) {
                                phi_2241_ = vec3<f32>(_e273, _e274, _e272);
                            } else {
                                if (_e1772 == 1u) {
                                    phi_2240_ = vec3<f32>(_e274, _e272, _e273);
                                } else {
                                    phi_2240_ = _e275;
                                }
                                let _e1778 = phi_2240_;
                                phi_2241_ = _e1778;
                            }
                            let _e1780 = phi_2241_;
                            let _e1783 = (_e1780.x / _e1780.z);
                            let _e1786 = (_e1780.y / _e1780.z);
                            if (_e1697 < 0f) {
                                phi_2254_ = 0u;
                            } else {
                                phi_2254_ = 1u;
                            }
                            let _e1791 = phi_2254_;
                            if (_e1707 < 0f) {
                                phi_2259_ = 0u;
                            } else {
                                phi_2259_ = 2u;
                            }
                            let _e1794 = phi_2259_;
                            if (_e1717 < 0f) {
                                phi_2264_ = 0u;
                            } else {
                                phi_2264_ = 4u;
                            }
                            let _e1797 = phi_2264_;
                            let _e1799 = ((_e1791 | _e1794) | _e1797);
                            let _e1800 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                            local = lt_bvh_traverse_Stack(array<u32, 32>(_e1800.first[0], _e1800.first[1], _e1800.first[2], _e1800.first[3], _e1800.first[4], _e1800.first[5], _e1800.first[6], _e1800.first[7], _e1800.first[8], _e1800.first[9], _e1800.first[10], _e1800.first[11], _e1800.first[12], _e1800.first[13], _e1800.first[14], _e1800.first[15], _e1800.first[16], _e1800.first[17], _e1800.first[18], _e1800.first[19], _e1800.first[20], _e1800.first[21], _e1800.first[22], _e1800.first[23], _e1800.first[24], _e1800.first[25], _e1800.first[26], _e1800.first[27], _e1800.first[28], _e1800.first[29], _e1800.first[30], _e1800.first[31]), array<u32, 32>(_e1800.mask[0], _e1800.mask[1], _e1800.mask[2], _e1800.mask[3], _e1800.mask[4], _e1800.mask[5], _e1800.mask[6], _e1800.mask[7], _e1800.mask[8], _e1800.mask[9], _e1800.mask[10], _e1800.mask[11], _e1800.mask[12], _e1800.mask[13], _e1800.mask[14], _e1800.mask[15], _e1800.mask[16], _e1800.mask[17], _e1800.mask[18], _e1800.mask[19], _e1800.mask[20], _e1800.mask[21], _e1800.mask[22], _e1800.mask[23], _e1800.mask[24], _e1800.mask[25], _e1800.mask[26], _e1800.mask[27], _e1800.mask[28], _e1800.mask[29], _e1800.mask[30], _e1800.mask[31]), _e1800.len, _e1800.group, _e1800.group_mask);
                            let _e1874 = local.group_mask;
                            if ((_e1874 & 4278190080u) == 0u) {
                                let _e1878 = local.len;
                                if (_e1878 == 0u) {
                                    phi_2378_ = false;
                                } else {
                                    let _e1882 = local.len;
                                    local.len = (_e1882 - 1u);
                                    let _e1885 = local.len;
                                    if (_e1885 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1890 = local.first[(0u + _e1885)];
                                    local.group = _e1890;
                                    let _e1893 = local.len;
                                    if (_e1893 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1898 = local.mask[(0u + _e1893)];
                                    local.group_mask = _e1898;
                                    phi_2378_ = true;
                                }
                                let _e1901 = phi_2378_;
                                phi_2379_ = _e1901;
                            } else {
                                phi_2379_ = true;
                            }
                            let _e1903 = phi_2379_;
                            if _e1903 {
                                let _e1905 = local.group_mask;
                                let _e1911 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1905)), 32u, (_e1905 == 0u)));
                                let _e1915 = local.group_mask;
                                let _e1929 = local.group_mask;
                                local.group_mask = (_e1929 & ~((1u << bitcast<u32>((_e1911 & 31u)))));
                                let _e1932 = local.group;
                                phi_2410_ = (_e1932 + countOneBits(((_e1915 & ~((4294967295u << bitcast<u32>((((_e1911 - 24u) ^ 7u) & 31u))))) & 255u)));
                            } else {
                                phi_2410_ = 4294967295u;
                            }
                            let _e1935 = phi_2410_;
                            phi_2412_ = _e1935;
                            phi_2415_ = false;
                            loop {
                                let _e1937 = phi_2412_;
                                let _e1939 = phi_2415_;
                                local_17 = _e1939;
                                if (_e1937 != 4294967295u) {
                                    if (_e1937 < _e75) {
                                    } else {
                                        return;
                                    }
                                    let _e1946 = nodes.member[(0u + _e1937)].frame[3u];
                                    let _e1971 = (bitcast<f32>((((_e1946 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1697);
                                    let _e1972 = (bitcast<f32>((((_e1946 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1707);
                                    let _e1973 = (bitcast<f32>((((_e1946 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1717);
                                    let _e1976 = nodes.member[(0u + _e1937)].frame[0u];
                                    let _e1980 = nodes.member[(0u + _e1937)].frame[1u];
                                    let _e1984 = nodes.member[(0u + _e1937)].frame[2u];
                                    let _e1989 = ((bitcast<f32>(_e1976) - _e252) * _e1697);
                                    let _e1990 = ((bitcast<f32>(_e1980) - _e254) * _e1707);
                                    let _e1991 = ((bitcast<f32>(_e1984) - _e256) * _e1717);
                                    let _e1999 = nodes.member[(0u + _e1937)].x;
                                    if (_e1697 < 0f) {
                                        let _e2010 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1999.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2016 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2010.unnamed.word, _e1999.w), _e2010.unnamed_1);
                                        let _e2022 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2016.unnamed, lt_mask_LightPlace(_e1999.x, _e2016.unnamed_1.shift));
                                        phi_2495_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2022.unnamed, lt_mask_LightPlace(_e2022.unnamed_1.word, _e1999.y));
                                    } else {
                                        let _e2038 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1999.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2044 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2038.unnamed.word, _e1999.y), _e2038.unnamed_1);
                                        let _e2050 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2044.unnamed, lt_mask_LightPlace(_e1999.z, _e2044.unnamed_1.shift));
                                        phi_2495_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2050.unnamed, lt_mask_LightPlace(_e2050.unnamed_1.word, _e1999.w));
                                    }
                                    let _e2058 = phi_2495_;
                                    let _e2068 = nodes.member[(0u + _e1937)].y;
                                    if (_e1707 < 0f) {
                                        let _e2079 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2068.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2085 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2079.unnamed.word, _e2068.w), _e2079.unnamed_1);
                                        let _e2091 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2085.unnamed, lt_mask_LightPlace(_e2068.x, _e2085.unnamed_1.shift));
                                        phi_2522_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2091.unnamed, lt_mask_LightPlace(_e2091.unnamed_1.word, _e2068.y));
                                    } else {
                                        let _e2107 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2068.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2113 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2107.unnamed.word, _e2068.y), _e2107.unnamed_1);
                                        let _e2119 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2113.unnamed, lt_mask_LightPlace(_e2068.z, _e2113.unnamed_1.shift));
                                        phi_2522_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2119.unnamed, lt_mask_LightPlace(_e2119.unnamed_1.word, _e2068.w));
                                    }
                                    let _e2127 = phi_2522_;
                                    let _e2137 = nodes.member[(0u + _e1937)].z;
                                    if (_e1717 < 0f) {
                                        let _e2148 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2137.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2154 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2148.unnamed.word, _e2137.w), _e2148.unnamed_1);
                                        let _e2160 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2154.unnamed, lt_mask_LightPlace(_e2137.x, _e2154.unnamed_1.shift));
                                        phi_2549_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2160.unnamed, lt_mask_LightPlace(_e2160.unnamed_1.word, _e2137.y));
                                    } else {
                                        let _e2176 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2137.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2182 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2176.unnamed.word, _e2137.y), _e2176.unnamed_1);
                                        let _e2188 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2182.unnamed, lt_mask_LightPlace(_e2137.z, _e2182.unnamed_1.shift));
                                        phi_2549_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2188.unnamed, lt_mask_LightPlace(_e2188.unnamed_1.word, _e2137.w));
                                    }
                                    let _e2196 = phi_2549_;
                                    phi_2555_ = 0u;
                                    phi_2558_ = 0u;
                                    loop {
                                        let _e2206 = phi_2555_;
                                        let _e2208 = phi_2558_;
                                        local_5 = _e2208;
                                        local_6 = _e2208;
                                        local_7 = _e2208;
                                        let _e2209 = (_e2206 < 8u);
                                        if _e2209 {
                                            let _e2211 = (_e2206 >> bitcast<u32>(2i));
                                            let _e2212 = (_e2206 & 3u);
                                            if (_e2211 == 0u) {
                                                phi_2572_ = _e2058.unnamed.word;
                                            } else {
                                                phi_2572_ = _e2058.unnamed.shift;
                                            }
                                            let _e2215 = phi_2572_;
                                            if (_e2211 == 0u) {
                                                phi_2582_ = _e2127.unnamed.word;
                                            } else {
                                                phi_2582_ = _e2127.unnamed.shift;
                                            }
                                            let _e2224 = phi_2582_;
                                            if (_e2211 == 0u) {
                                                phi_2592_ = _e2196.unnamed.word;
                                            } else {
                                                phi_2592_ = _e2196.unnamed.shift;
                                            }
                                            let _e2233 = phi_2592_;
                                            let _e2246 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2215 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u)) * _e1971) + (_e1989 - _e1749)), ((f32(((_e2224 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u)) * _e1972) + (_e1990 - _e1750)));
                                            let _e2247 = core_intrinsics_maximum_number_nsz_f32_(_e2246, ((f32(((_e2233 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u)) * _e1973) + (_e1991 - _e1751)));
                                            if (_e2211 == 0u) {
                                                phi_2610_ = _e2058.unnamed_1.word;
                                            } else {
                                                phi_2610_ = _e2058.unnamed_1.shift;
                                            }
                                            let _e2250 = phi_2610_;
                                            if (_e2211 == 0u) {
                                                phi_2620_ = _e2127.unnamed_1.word;
                                            } else {
                                                phi_2620_ = _e2127.unnamed_1.shift;
                                            }
                                            let _e2259 = phi_2620_;
                                            if (_e2211 == 0u) {
                                                phi_2630_ = _e2196.unnamed_1.word;
                                            } else {
                                                phi_2630_ = _e2196.unnamed_1.shift;
                                            }
                                            let _e2268 = phi_2630_;
                                            let _e2281 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2250 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u)) * _e1971) + (_e1989 + _e1749)), ((f32(((_e2259 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u)) * _e1972) + (_e1990 + _e1750)));
                                            let _e2282 = core_intrinsics_minimum_number_nsz_f32_(_e2281, ((f32(((_e2268 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u)) * _e1973) + (_e1991 + _e1751)));
                                            if (_e2247 <= _e2282) {
                                                if (_e2247 <= _e264) {
                                                    if (_e2282 >= 0f) {
                                                        if (_e2211 == 0u) {
                                                            let _e2289 = nodes.member[(0u + _e1937)].links[2u];
                                                            phi_2666_ = _e2289;
                                                        } else {
                                                            let _e2292 = nodes.member[(0u + _e1937)].links[3u];
                                                            phi_2666_ = _e2292;
                                                        }
                                                        let _e2294 = phi_2666_;
                                                        let _e2299 = ((_e2294 >> bitcast<u32>(((_e2212 * 8u) & 31u))) & 255u);
                                                        let _e2300 = (_e2299 & 31u);
                                                        if (_e2300 >= 24u) {
                                                            phi_2679_ = (24u + ((_e2300 - 24u) ^ _e1799));
                                                        } else {
                                                            phi_2679_ = _e2300;
                                                        }
                                                        let _e2306 = phi_2679_;
                                                        phi_2684_ = (_e2208 | ((_e2299 >> bitcast<u32>(5i)) << bitcast<u32>((_e2306 & 31u))));
                                                    } else {
                                                        phi_2684_ = _e2208;
                                                    }
                                                    let _e2314 = phi_2684_;
                                                    phi_2685_ = _e2314;
                                                } else {
                                                    phi_2685_ = _e2208;
                                                }
                                                let _e2316 = phi_2685_;
                                                phi_2686_ = _e2316;
                                            } else {
                                                phi_2686_ = _e2208;
                                            }
                                            let _e2318 = phi_2686_;
                                            phi_2556_ = (_e2206 + 1u);
                                            phi_2559_ = _e2318;
                                        } else {
                                            phi_2556_ = u32();
                                            phi_2559_ = u32();
                                        }
                                        let _e2321 = phi_2556_;
                                        let _e2323 = phi_2559_;
                                        continue;
                                        continuing {
                                            phi_2555_ = _e2321;
                                            phi_2558_ = _e2323;
                                            break if !(_e2209);
                                        }
                                    }
                                    let _e2327 = nodes.member[(0u + _e1937)].links[0u];
                                    let _e2331 = nodes.member[(0u + _e1937)].frame[3u];
                                    let _e2335 = local_5;
                                    if ((_e2335 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2339 = local.group_mask;
                                        if ((_e2339 & 4278190080u) == 0u) {
                                        } else {
                                            let _e2343 = local.len;
                                            if (_e2343 < 32u) {
                                                let _e2346 = local.group;
                                                let _e2348 = local.len;
                                                if (_e2348 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local.first[(0u + _e2348)] = _e2346;
                                                let _e2354 = local.group_mask;
                                                let _e2356 = local.len;
                                                if (_e2356 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local.mask[(0u + _e2356)] = _e2354;
                                                let _e2363 = local.len;
                                                local.len = (_e2363 + 1u);
                                            }
                                        }
                                        local.group = (0u + _e2327);
                                        let _e2367 = local_6;
                                        local.group_mask = ((_e2367 & 4278190080u) | (_e2331 >> bitcast<u32>(24i)));
                                    }
                                    let _e2372 = local_7;
                                    phi_2744_ = (_e2372 & 16777215u);
                                    phi_2747_ = _e1939;
                                    loop {
                                        let _e2375 = phi_2744_;
                                        let _e2377 = phi_2747_;
                                        local_15 = _e2377;
                                        let _e2378 = (_e2375 == 0u);
                                        local_8 = _e2378;
                                        local_16 = _e2378;
                                        if _e2378 {
                                            phi_2745_ = u32();
                                            phi_2748_ = bool();
                                            phi_3345_ = false;
                                        } else {
                                            let _e2381 = nodes.member[(0u + _e1937)].links[1u];
                                            let _e2386 = ((0u + _e2381) + select(firstTrailingBit(_e2375), 32u, (_e2375 == 0u)));
                                            if (_e2386 < _e78) {
                                            } else {
                                                return;
                                            }
                                            let _e2393 = triangles.member[(0u + _e2386)].v0_;
                                            let _e2395 = (_e2393.x - _e252);
                                            let _e2397 = (_e2393.y - _e254);
                                            let _e2399 = (_e2393.z - _e256);
                                            if (_e1772 == 0u) {
                                                phi_2792_ = vec3<f32>(_e2397, _e2399, _e2395);
                                            } else {
                                                if (_e1772 == 1u) {
                                                    phi_2791_ = vec3<f32>(_e2399, _e2395, _e2397);
                                                } else {
                                                    phi_2791_ = (_e2393 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e2407 = phi_2791_;
                                                phi_2792_ = _e2407;
                                            }
                                            let _e2409 = phi_2792_;
                                            let _e2413 = (_e2409.x - (_e1783 * _e2409.z));
                                            let _e2417 = (_e2409.y - (_e1786 * _e2409.z));
                                            let _e2419 = triangles.member[(0u + _e2386)].v1_;
                                            let _e2421 = (_e2419.x - _e252);
                                            let _e2423 = (_e2419.y - _e254);
                                            let _e2425 = (_e2419.z - _e256);
                                            if (_e1772 == 0u) {
                                                phi_2822_ = vec3<f32>(_e2423, _e2425, _e2421);
                                            } else {
                                                if (_e1772 == 1u) {
                                                    phi_2821_ = vec3<f32>(_e2425, _e2421, _e2423);
                                                } else {
                                                    phi_2821_ = (_e2419 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e2433 = phi_2821_;
                                                phi_2822_ = _e2433;
                                            }
                                            let _e2435 = phi_2822_;
                                            let _e2439 = (_e2435.x - (_e1783 * _e2435.z));
                                            let _e2443 = (_e2435.y - (_e1786 * _e2435.z));
                                            let _e2445 = triangles.member[(0u + _e2386)].v2_;
                                            let _e2447 = (_e2445.x - _e252);
                                            let _e2449 = (_e2445.y - _e254);
                                            let _e2451 = (_e2445.z - _e256);
                                            if (_e1772 == 0u) {
                                                phi_2852_ = vec3<f32>(_e2449, _e2451, _e2447);
                                            } else {
                                                if (_e1772 == 1u) {
                                                    phi_2851_ = vec3<f32>(_e2451, _e2447, _e2449);
                                                } else {
                                                    phi_2851_ = (_e2445 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e2459 = phi_2851_;
                                                phi_2852_ = _e2459;
                                            }
                                            let _e2461 = phi_2852_;
                                            let _e2465 = (_e2461.x - (_e1783 * _e2461.z));
                                            let _e2469 = (_e2461.y - (_e1786 * _e2461.z));
                                            if (_e2439 < _e2465) {
                                                phi_2871_ = true;
                                            } else {
                                                if (_e2439 == _e2465) {
                                                    phi_2870_ = (_e2443 < _e2469);
                                                } else {
                                                    phi_2870_ = false;
                                                }
                                                let _e2474 = phi_2870_;
                                                phi_2871_ = _e2474;
                                            }
                                            let _e2476 = phi_2871_;
                                            if _e2476 {
                                                phi_2875_ = _e2469;
                                                phi_2876_ = _e2465;
                                                phi_2877_ = _e2443;
                                                phi_2878_ = _e2439;
                                            } else {
                                                phi_2875_ = _e2443;
                                                phi_2876_ = _e2439;
                                                phi_2877_ = _e2469;
                                                phi_2878_ = _e2465;
                                            }
                                            let _e2478 = phi_2875_;
                                            let _e2480 = phi_2876_;
                                            let _e2482 = phi_2877_;
                                            let _e2484 = phi_2878_;
                                            let _e2487 = ((_e2484 * _e2478) - (_e2482 * _e2480));
                                            if _e2476 {
                                                phi_2886_ = -(_e2487);
                                            } else {
                                                phi_2886_ = _e2487;
                                            }
                                            let _e2490 = phi_2886_;
                                            if (_e2465 < _e2413) {
                                                phi_2897_ = true;
                                            } else {
                                                if (_e2465 == _e2413) {
                                                    phi_2896_ = (_e2469 < _e2417);
                                                } else {
                                                    phi_2896_ = false;
                                                }
                                                let _e2495 = phi_2896_;
                                                phi_2897_ = _e2495;
                                            }
                                            let _e2497 = phi_2897_;
                                            if _e2497 {
                                                phi_2901_ = _e2417;
                                                phi_2902_ = _e2413;
                                                phi_2903_ = _e2469;
                                                phi_2904_ = _e2465;
                                            } else {
                                                phi_2901_ = _e2469;
                                                phi_2902_ = _e2465;
                                                phi_2903_ = _e2417;
                                                phi_2904_ = _e2413;
                                            }
                                            let _e2499 = phi_2901_;
                                            let _e2501 = phi_2902_;
                                            let _e2503 = phi_2903_;
                                            let _e2505 = phi_2904_;
                                            let _e2508 = ((_e2505 * _e2499) - (_e2503 * _e2501));
                                            if _e2497 {
                                                phi_2912_ = -(_e2508);
                                            } else {
                                                phi_2912_ = _e2508;
                                            }
                                            let _e2511 = phi_2912_;
                                            if (_e2413 < _e2439) {
                                                phi_2923_ = true;
                                            } else {
                                                if (_e2413 == _e2439) {
                                                    phi_2922_ = (_e2417 < _e2443);
                                                } else {
                                                    phi_2922_ = false;
                                                }
                                                let _e2516 = phi_2922_;
                                                phi_2923_ = _e2516;
                                            }
                                            let _e2518 = phi_2923_;
                                            if _e2518 {
                                                phi_2927_ = _e2443;
                                                phi_2928_ = _e2439;
                                                phi_2929_ = _e2417;
                                                phi_2930_ = _e2413;
                                            } else {
                                                phi_2927_ = _e2417;
                                                phi_2928_ = _e2413;
                                                phi_2929_ = _e2443;
                                                phi_2930_ = _e2439;
                                            }
                                            let _e2520 = phi_2927_;
                                            let _e2522 = phi_2928_;
                                            let _e2524 = phi_2929_;
                                            let _e2526 = phi_2930_;
                                            let _e2529 = ((_e2526 * _e2520) - (_e2524 * _e2522));
                                            if _e2518 {
                                                phi_2938_ = -(_e2529);
                                            } else {
                                                phi_2938_ = _e2529;
                                            }
                                            let _e2532 = phi_2938_;
                                            if (_e2490 >= 0f) {
                                                if (_e2511 >= 0f) {
                                                    if (_e2532 >= 0f) {
                                                        phi_2953_ = ((_e2490 + _e2511) + _e2532);
                                                        phi_2954_ = false;
                                                    } else {
                                                        phi_2953_ = f32();
                                                        phi_2954_ = true;
                                                    }
                                                    let _e2539 = phi_2953_;
                                                    let _e2541 = phi_2954_;
                                                    phi_2955_ = _e2539;
                                                    phi_2956_ = _e2541;
                                                } else {
                                                    phi_2955_ = f32();
                                                    phi_2956_ = true;
                                                }
                                                let _e2543 = phi_2955_;
                                                let _e2545 = phi_2956_;
                                                phi_2957_ = _e2543;
                                                phi_2958_ = _e2545;
                                            } else {
                                                phi_2957_ = f32();
                                                phi_2958_ = true;
                                            }
                                            let _e2547 = phi_2957_;
                                            let _e2549 = phi_2958_;
                                            if _e2549 {
                                                if (_e2490 <= 0f) {
                                                    if (_e2511 <= 0f) {
                                                        let _e2552 = (_e2532 <= 0f);
                                                        if _e2552 {
                                                        }
                                                        phi_2976_ = ((_e2490 + _e2511) + _e2532);
                                                        phi_2977_ = false;
                                                        phi_2978_ = _e2552;
                                                    } else {
                                                        phi_2976_ = f32();
                                                        phi_2977_ = true;
                                                        phi_2978_ = false;
                                                    }
                                                    let _e2556 = phi_2976_;
                                                    let _e2558 = phi_2977_;
                                                    let _e2560 = phi_2978_;
                                                    phi_2979_ = _e2556;
                                                    phi_2980_ = _e2558;
                                                    phi_2981_ = _e2560;
                                                } else {
                                                    phi_2979_ = f32();
                                                    phi_2980_ = true;
                                                    phi_2981_ = false;
                                                }
                                                let _e2562 = phi_2979_;
                                                let _e2564 = phi_2980_;
                                                let _e2566 = phi_2981_;
                                                if _e2564 {
                                                    phi_2985_ = false;
                                                } else {
                                                    phi_2985_ = _e2566;
                                                }
                                                let _e2568 = phi_2985_;
                                                phi_2986_ = _e2562;
                                                phi_2987_ = _e2568;
                                            } else {
                                                phi_2986_ = _e2547;
                                                phi_2987_ = true;
                                            }
                                            let _e2570 = phi_2986_;
                                            let _e2572 = phi_2987_;
                                            if _e2572 {
                                                let _e2573 = (_e2570 == 0f);
                                                if _e2573 {
                                                    phi_3303_ = lt_bvh_triangle_Intersection();
                                                    phi_3304_ = false;
                                                } else {
                                                    let _e2575 = triangles.member[(0u + _e2386)].v0_;
                                                    let _e2577 = (_e2575.x - _e252);
                                                    let _e2579 = (_e2575.y - _e254);
                                                    let _e2581 = (_e2575.z - _e256);
                                                    if (_e1772 == 0u) {
                                                        phi_3016_ = vec3<f32>(_e2579, _e2581, _e2577);
                                                    } else {
                                                        if (_e1772 == 1u) {
                                                            phi_3015_ = vec3<f32>(_e2581, _e2577, _e2579);
                                                        } else {
                                                            phi_3015_ = (_e2575 - vec3<f32>(_e252, _e254, _e256));
                                                        }
                                                        let _e2589 = phi_3015_;
                                                        phi_3016_ = _e2589;
                                                    }
                                                    let _e2591 = phi_3016_;
                                                    let _e2593 = triangles.member[(0u + _e2386)].v1_;
                                                    let _e2595 = triangles.member[(0u + _e2386)].v0_;
                                                    let _e2598 = (_e2593.x - _e2595.x);
                                                    let _e2601 = (_e2593.y - _e2595.y);
                                                    let _e2604 = (_e2593.z - _e2595.z);
                                                    if (_e1772 == 0u) {
                                                        phi_3042_ = vec3<f32>(_e2601, _e2604, _e2598);
                                                    } else {
                                                        if (_e1772 == 1u) {
                                                            phi_3041_ = vec3<f32>(_e2604, _e2598, _e2601);
                                                        } else {
                                                            phi_3041_ = (_e2593 - _e2595);
                                                        }
                                                        let _e2611 = phi_3041_;
                                                        phi_3042_ = _e2611;
                                                    }
                                                    let _e2613 = phi_3042_;
                                                    let _e2615 = triangles.member[(0u + _e2386)].v2_;
                                                    let _e2617 = triangles.member[(0u + _e2386)].v0_;
                                                    let _e2620 = (_e2615.x - _e2617.x);
                                                    let _e2623 = (_e2615.y - _e2617.y);
                                                    let _e2626 = (_e2615.z - _e2617.z);
                                                    if (_e1772 == 0u) {
                                                        phi_3068_ = vec3<f32>(_e2623, _e2626, _e2620);
                                                    } else {
                                                        if (_e1772 == 1u) {
                                                            phi_3067_ = vec3<f32>(_e2626, _e2620, _e2623);
                                                        } else {
                                                            phi_3067_ = (_e2615 - _e2617);
                                                        }
                                                        let _e2633 = phi_3067_;
                                                        phi_3068_ = _e2633;
                                                    }
                                                    let _e2635 = phi_3068_;
                                                    let _e2642 = ((_e2613.y * _e2635.z) - (_e2613.z * _e2635.y));
                                                    let _e2649 = ((_e2613.z * _e2635.x) - (_e2613.x * _e2635.z));
                                                    let _e2656 = ((_e2613.x * _e2635.y) - (_e2613.y * _e2635.x));
                                                    let _e2670 = (((1f / _e1780.z) * (((_e2642 * _e2591.x) + (_e2649 * _e2591.y)) + (_e2656 * _e2591.z))) / (((_e2642 * _e1783) + (_e2649 * _e1786)) + _e2656));
                                                    if (_e2670 > 0f) {
                                                        if (_e2670 < _e264) {
                                                            let _e2674 = triangles.member[(0u + _e2386)].v0_;
                                                            let _e2676 = triangles.member[(0u + _e2386)].v1_;
                                                            if (_e2674.x < _e2676.x) {
                                                                phi_3124_ = _e2674.x;
                                                            } else {
                                                                phi_3124_ = _e2676.x;
                                                            }
                                                            let _e2683 = phi_3124_;
                                                            if (_e2674.y < _e2676.y) {
                                                                phi_3133_ = _e2674.y;
                                                            } else {
                                                                phi_3133_ = _e2676.y;
                                                            }
                                                            let _e2690 = phi_3133_;
                                                            if (_e2674.z < _e2676.z) {
                                                                phi_3142_ = _e2674.z;
                                                            } else {
                                                                phi_3142_ = _e2676.z;
                                                            }
                                                            let _e2697 = phi_3142_;
                                                            let _e2699 = triangles.member[(0u + _e2386)].v2_;
                                                            if (_e2683 < _e2699.x) {
                                                                phi_3151_ = _e2683;
                                                            } else {
                                                                phi_3151_ = _e2699.x;
                                                            }
                                                            let _e2704 = phi_3151_;
                                                            if (_e2690 < _e2699.y) {
                                                                phi_3158_ = _e2690;
                                                            } else {
                                                                phi_3158_ = _e2699.y;
                                                            }
                                                            let _e2709 = phi_3158_;
                                                            if (_e2697 < _e2699.z) {
                                                                phi_3165_ = _e2697;
                                                            } else {
                                                                phi_3165_ = _e2699.z;
                                                            }
                                                            let _e2714 = phi_3165_;
                                                            let _e2716 = triangles.member[(0u + _e2386)].v0_;
                                                            let _e2718 = triangles.member[(0u + _e2386)].v1_;
                                                            if (_e2716.x > _e2718.x) {
                                                                phi_3178_ = _e2716.x;
                                                            } else {
                                                                phi_3178_ = _e2718.x;
                                                            }
                                                            let _e2725 = phi_3178_;
                                                            if (_e2716.y > _e2718.y) {
                                                                phi_3187_ = _e2716.y;
                                                            } else {
                                                                phi_3187_ = _e2718.y;
                                                            }
                                                            let _e2732 = phi_3187_;
                                                            if (_e2716.z > _e2718.z) {
                                                                phi_3196_ = _e2716.z;
                                                            } else {
                                                                phi_3196_ = _e2718.z;
                                                            }
                                                            let _e2739 = phi_3196_;
                                                            let _e2741 = triangles.member[(0u + _e2386)].v2_;
                                                            if (_e2725 > _e2741.x) {
                                                                phi_3205_ = _e2725;
                                                            } else {
                                                                phi_3205_ = _e2741.x;
                                                            }
                                                            let _e2746 = phi_3205_;
                                                            if (_e2732 > _e2741.y) {
                                                                phi_3212_ = _e2732;
                                                            } else {
                                                                phi_3212_ = _e2741.y;
                                                            }
                                                            let _e2751 = phi_3212_;
                                                            if (_e2739 > _e2741.z) {
                                                                phi_3219_ = _e2739;
                                                            } else {
                                                                phi_3219_ = _e2741.z;
                                                            }
                                                            let _e2756 = phi_3219_;
                                                            let _e2760 = ((_e2704 - _e252) * _e1697);
                                                            let _e2761 = ((_e2709 - _e254) * _e1707);
                                                            let _e2762 = ((_e2714 - _e256) * _e1717);
                                                            let _e2766 = ((_e2746 - _e252) * _e1697);
                                                            let _e2767 = ((_e2751 - _e254) * _e1707);
                                                            let _e2768 = ((_e2756 - _e256) * _e1717);
                                                            if (_e2760 < _e2766) {
                                                                phi_3236_ = _e2760;
                                                            } else {
                                                                phi_3236_ = _e2766;
                                                            }
                                                            let _e2771 = phi_3236_;
                                                            if (_e2761 < _e2767) {
                                                                phi_3241_ = _e2761;
                                                            } else {
                                                                phi_3241_ = _e2767;
                                                            }
                                                            let _e2774 = phi_3241_;
                                                            if (_e2762 < _e2768) {
                                                                phi_3246_ = _e2762;
                                                            } else {
                                                                phi_3246_ = _e2768;
                                                            }
                                                            let _e2777 = phi_3246_;
                                                            if (_e2760 > _e2766) {
                                                                phi_3254_ = _e2760;
                                                            } else {
                                                                phi_3254_ = _e2766;
                                                            }
                                                            let _e2783 = phi_3254_;
                                                            if (_e2761 > _e2767) {
                                                                phi_3259_ = _e2761;
                                                            } else {
                                                                phi_3259_ = _e2767;
                                                            }
                                                            let _e2786 = phi_3259_;
                                                            if (_e2762 > _e2768) {
                                                                phi_3264_ = _e2762;
                                                            } else {
                                                                phi_3264_ = _e2768;
                                                            }
                                                            let _e2789 = phi_3264_;
                                                            let _e2793 = core_intrinsics_maximum_number_nsz_f32_((_e2771 - _e1756), (_e2774 - _e1757));
                                                            let _e2794 = core_intrinsics_maximum_number_nsz_f32_(_e2793, (_e2777 - _e1758));
                                                            let _e2795 = core_intrinsics_minimum_number_nsz_f32_((_e2783 + _e1756), (_e2786 + _e1757));
                                                            let _e2796 = core_intrinsics_minimum_number_nsz_f32_(_e2795, (_e2789 + _e1758));
                                                            if (_e2794 > -300000000000000000000000000000000000000f) {
                                                                phi_3276_ = _e2794;
                                                            } else {
                                                                phi_3276_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e2799 = phi_3276_;
                                                            if (_e2796 < 300000000000000000000000000000000000000f) {
                                                                phi_3281_ = _e2796;
                                                            } else {
                                                                phi_3281_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e2802 = phi_3281_;
                                                            if (_e2670 < _e2799) {
                                                                phi_3286_ = _e2799;
                                                            } else {
                                                                phi_3286_ = _e2670;
                                                            }
                                                            let _e2805 = phi_3286_;
                                                            if (_e2805 > _e2802) {
                                                                phi_3291_ = _e2802;
                                                            } else {
                                                                phi_3291_ = _e2805;
                                                            }
                                                            let _e2808 = phi_3291_;
                                                            phi_3296_ = lt_bvh_triangle_Intersection(_e2808, (_e2511 / _e2570), (_e2532 / _e2570), (_e2799 <= _e2802));
                                                            phi_3297_ = false;
                                                        } else {
                                                            phi_3296_ = lt_bvh_triangle_Intersection();
                                                            phi_3297_ = true;
                                                        }
                                                        let _e2814 = phi_3296_;
                                                        let _e2816 = phi_3297_;
                                                        phi_3298_ = _e2814;
                                                        phi_3299_ = _e2816;
                                                    } else {
                                                        phi_3298_ = lt_bvh_triangle_Intersection();
                                                        phi_3299_ = true;
                                                    }
                                                    let _e2818 = phi_3298_;
                                                    let _e2820 = phi_3299_;
                                                    if _e2820 {
                                                    }
                                                    phi_3303_ = _e2818;
                                                    phi_3304_ = _e2820;
                                                }
                                                let _e2822 = phi_3303_;
                                                let _e2824 = phi_3304_;
                                                phi_3305_ = _e2822;
                                                phi_3306_ = _e2573;
                                                phi_3307_ = _e2824;
                                            } else {
                                                phi_3305_ = lt_bvh_triangle_Intersection();
                                                phi_3306_ = true;
                                                phi_3307_ = false;
                                            }
                                            let _e2826 = phi_3305_;
                                            let _e2828 = phi_3306_;
                                            let _e2830 = phi_3307_;
                                            if _e2828 {
                                                phi_3311_ = true;
                                            } else {
                                                phi_3311_ = _e2830;
                                            }
                                            let _e2832 = phi_3311_;
                                            if _e2832 {
                                                phi_3315_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_3315_ = _e2826;
                                            }
                                            let _e2834 = phi_3315_;
                                            if _e2834.is_hit {
                                                if (_e2834.t > 0f) {
                                                    if (_e2834.t < _e264) {
                                                        if true {
                                                            phi_3335_ = false;
                                                        } else {
                                                            phi_3335_ = true;
                                                        }
                                                        let _e2843 = phi_3335_;
                                                        phi_3336_ = true;
                                                        phi_3337_ = _e2843;
                                                    } else {
                                                        phi_3336_ = _e2377;
                                                        phi_3337_ = true;
                                                    }
                                                    let _e2845 = phi_3336_;
                                                    let _e2847 = phi_3337_;
                                                    phi_3338_ = _e2845;
                                                    phi_3339_ = _e2847;
                                                } else {
                                                    phi_3338_ = _e2377;
                                                    phi_3339_ = true;
                                                }
                                                let _e2849 = phi_3338_;
                                                let _e2851 = phi_3339_;
                                                phi_3340_ = _e2849;
                                                phi_3341_ = _e2851;
                                            } else {
                                                phi_3340_ = _e2377;
                                                phi_3341_ = true;
                                            }
                                            let _e2853 = phi_3340_;
                                            let _e2855 = phi_3341_;
                                            if _e2855 {
                                            }
                                            phi_2745_ = (_e2375 & (_e2375 - 1u));
                                            phi_2748_ = _e2853;
                                            phi_3345_ = _e2855;
                                        }
                                        let _e2857 = phi_2745_;
                                        let _e2859 = phi_2748_;
                                        let _e2861 = phi_3345_;
                                        continue;
                                        continuing {
                                            phi_2744_ = _e2857;
                                            phi_2747_ = _e2859;
                                            break if !(_e2861);
                                        }
                                    }
                                    let _e2864 = local_8;
                                    if _e2864 {
                                        let _e2866 = local.group_mask;
                                        if ((_e2866 & 4278190080u) == 0u) {
                                            let _e2870 = local.len;
                                            if (_e2870 == 0u) {
                                                phi_3387_ = false;
                                            } else {
                                                let _e2874 = local.len;
                                                local.len = (_e2874 - 1u);
                                                let _e2877 = local.len;
                                                if (_e2877 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2882 = local.first[(0u + _e2877)];
                                                local.group = _e2882;
                                                let _e2885 = local.len;
                                                if (_e2885 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2890 = local.mask[(0u + _e2885)];
                                                local.group_mask = _e2890;
                                                phi_3387_ = true;
                                            }
                                            let _e2893 = phi_3387_;
                                            phi_3388_ = _e2893;
                                        } else {
                                            phi_3388_ = true;
                                        }
                                        let _e2895 = phi_3388_;
                                        if _e2895 {
                                            let _e2897 = local.group_mask;
                                            let _e2903 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2897)), 32u, (_e2897 == 0u)));
                                            let _e2907 = local.group_mask;
                                            let _e2921 = local.group_mask;
                                            local.group_mask = (_e2921 & ~((1u << bitcast<u32>((_e2903 & 31u)))));
                                            let _e2924 = local.group;
                                            phi_3419_ = (_e2924 + countOneBits(((_e2907 & ~((4294967295u << bitcast<u32>((((_e2903 - 24u) ^ _e1799) & 31u))))) & 255u)));
                                        } else {
                                            phi_3419_ = 4294967295u;
                                        }
                                        let _e2927 = phi_3419_;
                                        phi_3420_ = _e2927;
                                    } else {
                                        phi_3420_ = u32();
                                    }
                                    let _e2929 = phi_3420_;
                                    phi_2413_ = _e2929;
                                    let _e3373 = local_15;
                                    phi_2416_ = _e3373;
                                    let _e3376 = local_16;
                                    phi_3421_ = _e3376;
                                    phi_3422_ = false;
                                } else {
                                    phi_2413_ = u32();
                                    phi_2416_ = bool();
                                    phi_3421_ = false;
                                    phi_3422_ = true;
                                }
                                let _e2931 = phi_2413_;
                                let _e2933 = phi_2416_;
                                let _e2935 = phi_3421_;
                                let _e2937 = phi_3422_;
                                local_9 = _e2937;
                                continue;
                                continuing {
                                    phi_2412_ = _e2931;
                                    phi_2415_ = _e2933;
                                    break if !(_e2935);
                                }
                            }
                            let _e2940 = local_9;
                            if _e2940 {
                                phi_3426_ = false;
                            } else {
                                phi_3426_ = true;
                            }
                            let _e2942 = phi_3426_;
                            if _e2942 {
                                phi_3430_ = true;
                            } else {
                                let _e3382 = local_17;
                                phi_3430_ = _e3382;
                            }
                            let _e2944 = phi_3430_;
                            phi_3431_ = _e2944;
                        }
                        let _e2946 = phi_3431_;
                        phi_3432_ = _e2946;
                        phi_3433_ = _e1621;
                    } else {
                        phi_3432_ = bool();
                        phi_3433_ = true;
                    }
                    let _e2948 = phi_3432_;
                    let _e2950 = phi_3433_;
                    if _e2950 {
                        phi_3437_ = false;
                    } else {
                        phi_3437_ = _e2948;
                    }
                    let _e2952 = phi_3437_;
                    phi_3438_ = _e2952;
                }
                let _e2954 = phi_3438_;
                phi_3439_ = _e2954;
            } else {
                phi_3439_ = false;
            }
            let _e2956 = phi_3439_;
            if _e2956 {
                phi_3443_ = 0f;
            } else {
                phi_3443_ = 1f;
            }
            let _e2958 = phi_3443_;
            phi_3444_ = _e2958;
        }
        let _e2960 = phi_3444_;
        if (_e91.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e91.shift)] = _e2960;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
