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
    var phi_961_: u32;
    var phi_964_: u32;
    var phi_966_: u32;
    var phi_968_: u32;
    var phi_1041_: f32;
    var phi_1042_: f32;
    var phi_1056_: u32;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1094_: u32;
    var phi_1117_: f32;
    var phi_1118_: f32;
    var phi_1132_: u32;
    var phi_1279_: u32;
    var phi_1280_: u32;
    var phi_1284_: u32;
    var phi_1285_: u32;
    var phi_1286_: u32;
    var phi_1287_: u32;
    var phi_1288_: u32;
    var phi_1289_: u32;
    var phi_1307_: u32;
    var phi_1308_: u32;
    var phi_1309_: u32;
    var phi_1310_: u32;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1313_: u32;
    var phi_1314_: u32;
    var phi_962_: u32;
    var phi_965_: u32;
    var phi_967_: u32;
    var phi_969_: u32;
    var phi_1315_: bool;
    var local_3: bool;
    var phi_1320_: u32;
    var local_4: u32;
    var phi_1359_: u32;
    var phi_1360_: u32;
    var phi_1366_: u32;
    var phi_1395_: vec3<f32>;
    var phi_1396_: vec3<f32>;
    var phi_1425_: vec3<f32>;
    var phi_1426_: vec3<f32>;
    var phi_1455_: vec3<f32>;
    var phi_1456_: vec3<f32>;
    var phi_1474_: bool;
    var phi_1475_: bool;
    var phi_1479_: f32;
    var phi_1480_: f32;
    var phi_1481_: f32;
    var phi_1482_: f32;
    var phi_1490_: f32;
    var phi_1500_: bool;
    var phi_1501_: bool;
    var phi_1505_: f32;
    var phi_1506_: f32;
    var phi_1507_: f32;
    var phi_1508_: f32;
    var phi_1516_: f32;
    var phi_1526_: bool;
    var phi_1527_: bool;
    var phi_1531_: f32;
    var phi_1532_: f32;
    var phi_1533_: f32;
    var phi_1534_: f32;
    var phi_1542_: f32;
    var phi_1557_: f32;
    var phi_1558_: bool;
    var phi_1559_: f32;
    var phi_1560_: bool;
    var phi_1561_: f32;
    var phi_1562_: bool;
    var phi_1580_: f32;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1583_: f32;
    var phi_1584_: bool;
    var phi_1585_: bool;
    var phi_1589_: bool;
    var phi_1590_: f32;
    var phi_1591_: bool;
    var phi_1619_: vec3<f32>;
    var phi_1620_: vec3<f32>;
    var phi_1645_: vec3<f32>;
    var phi_1646_: vec3<f32>;
    var phi_1671_: vec3<f32>;
    var phi_1672_: vec3<f32>;
    var phi_1728_: f32;
    var phi_1737_: f32;
    var phi_1746_: f32;
    var phi_1755_: f32;
    var phi_1762_: f32;
    var phi_1769_: f32;
    var phi_1782_: f32;
    var phi_1791_: f32;
    var phi_1800_: f32;
    var phi_1809_: f32;
    var phi_1816_: f32;
    var phi_1823_: f32;
    var phi_1840_: f32;
    var phi_1845_: f32;
    var phi_1850_: f32;
    var phi_1858_: f32;
    var phi_1863_: f32;
    var phi_1868_: f32;
    var phi_1880_: f32;
    var phi_1885_: f32;
    var phi_1890_: f32;
    var phi_1895_: f32;
    var phi_1900_: lt_bvh_triangle_Intersection;
    var phi_1901_: bool;
    var phi_1902_: lt_bvh_triangle_Intersection;
    var phi_1903_: bool;
    var phi_1907_: lt_bvh_triangle_Intersection;
    var phi_1908_: bool;
    var phi_1909_: lt_bvh_triangle_Intersection;
    var phi_1910_: bool;
    var phi_1911_: bool;
    var phi_1915_: bool;
    var phi_1919_: lt_bvh_triangle_Intersection;
    var phi_1944_: bool;
    var phi_1945_: bool;
    var phi_1946_: bool;
    var phi_1947_: bool;
    var phi_1948_: bool;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1951_: bool;
    var phi_1952_: bool;
    var phi_1953_: bool;
    var phi_1954_: bool;
    var phi_1955_: bool;
    var phi_1956_: bool;
    var phi_1957_: bool;
    var phi_1961_: bool;
    var phi_1962_: bool;
    var phi_1963_: bool;
    var phi_1967_: bool;
    var phi_1968_: bool;
    var phi_1321_: u32;
    var phi_1969_: bool;
    var phi_1970_: bool;
    var phi_1971_: bool;
    var local_5: bool;
    var phi_1975_: bool;
    var phi_1976_: bool;
    var phi_950_: u32;
    var phi_953_: u32;
    var phi_1977_: bool;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var local_6: bool;
    var phi_1983_: bool;
    var phi_1984_: bool;
    var phi_1988_: bool;
    var phi_1992_: bool;
    var phi_1996_: bool;
    var phi_1997_: bool;
    var phi_2001_: bool;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2024_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2039_: bool;
    var phi_2040_: bool;
    var phi_2044_: bool;
    var phi_2057_: bool;
    var phi_2058_: bool;
    var phi_2059_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2067_: bool;
    var phi_2071_: bool;
    var phi_2141_: f32;
    var phi_2148_: f32;
    var phi_2155_: f32;
    var phi_2162_: f32;
    var phi_2169_: f32;
    var phi_2176_: f32;
    var phi_2193_: f32;
    var phi_2198_: f32;
    var phi_2203_: f32;
    var phi_2208_: f32;
    var phi_2213_: f32;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2248_: u32;
    var phi_2249_: u32;
    var phi_2260_: vec3<f32>;
    var phi_2261_: vec3<f32>;
    var phi_2274_: u32;
    var phi_2279_: u32;
    var phi_2284_: u32;
    var phi_2398_: bool;
    var phi_2399_: bool;
    var phi_2430_: u32;
    var phi_2432_: u32;
    var phi_2435_: bool;
    var phi_2515_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2542_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2569_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2575_: u32;
    var phi_2578_: u32;
    var phi_2592_: u32;
    var phi_2602_: u32;
    var phi_2612_: u32;
    var phi_2630_: u32;
    var phi_2640_: u32;
    var phi_2650_: u32;
    var phi_2686_: u32;
    var phi_2699_: u32;
    var phi_2704_: u32;
    var phi_2705_: u32;
    var phi_2706_: u32;
    var phi_2576_: u32;
    var phi_2579_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2764_: u32;
    var phi_2767_: bool;
    var phi_2811_: vec3<f32>;
    var phi_2812_: vec3<f32>;
    var phi_2841_: vec3<f32>;
    var phi_2842_: vec3<f32>;
    var phi_2871_: vec3<f32>;
    var phi_2872_: vec3<f32>;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var phi_2895_: f32;
    var phi_2896_: f32;
    var phi_2897_: f32;
    var phi_2898_: f32;
    var phi_2906_: f32;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var phi_2921_: f32;
    var phi_2922_: f32;
    var phi_2923_: f32;
    var phi_2924_: f32;
    var phi_2932_: f32;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2947_: f32;
    var phi_2948_: f32;
    var phi_2949_: f32;
    var phi_2950_: f32;
    var phi_2958_: f32;
    var phi_2973_: f32;
    var phi_2974_: bool;
    var phi_2975_: f32;
    var phi_2976_: bool;
    var phi_2977_: f32;
    var phi_2978_: bool;
    var phi_2996_: f32;
    var phi_2997_: bool;
    var phi_2998_: bool;
    var phi_2999_: f32;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3005_: bool;
    var phi_3006_: f32;
    var phi_3007_: bool;
    var phi_3035_: vec3<f32>;
    var phi_3036_: vec3<f32>;
    var phi_3061_: vec3<f32>;
    var phi_3062_: vec3<f32>;
    var phi_3087_: vec3<f32>;
    var phi_3088_: vec3<f32>;
    var phi_3144_: f32;
    var phi_3153_: f32;
    var phi_3162_: f32;
    var phi_3171_: f32;
    var phi_3178_: f32;
    var phi_3185_: f32;
    var phi_3198_: f32;
    var phi_3207_: f32;
    var phi_3216_: f32;
    var phi_3225_: f32;
    var phi_3232_: f32;
    var phi_3239_: f32;
    var phi_3256_: f32;
    var phi_3261_: f32;
    var phi_3266_: f32;
    var phi_3274_: f32;
    var phi_3279_: f32;
    var phi_3284_: f32;
    var phi_3296_: f32;
    var phi_3301_: f32;
    var phi_3306_: f32;
    var phi_3311_: f32;
    var phi_3316_: lt_bvh_triangle_Intersection;
    var phi_3317_: bool;
    var phi_3318_: lt_bvh_triangle_Intersection;
    var phi_3319_: bool;
    var phi_3323_: lt_bvh_triangle_Intersection;
    var phi_3324_: bool;
    var phi_3325_: lt_bvh_triangle_Intersection;
    var phi_3326_: bool;
    var phi_3327_: bool;
    var phi_3331_: bool;
    var phi_3335_: lt_bvh_triangle_Intersection;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3357_: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3361_: bool;
    var phi_2765_: u32;
    var phi_2768_: bool;
    var phi_3365_: bool;
    var local_10: bool;
    var phi_3407_: bool;
    var phi_3408_: bool;
    var phi_3439_: u32;
    var phi_3440_: u32;
    var phi_2433_: u32;
    var phi_2436_: bool;
    var phi_3441_: bool;
    var phi_3442_: bool;
    var local_11: bool;
    var phi_3446_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3452_: bool;
    var phi_3453_: bool;
    var phi_3457_: bool;
    var phi_3458_: bool;
    var phi_3459_: bool;
    var phi_3463_: f32;
    var phi_3464_: f32;
    var local_12: u32;
    var local_13: bool;
    var local_14: bool;
    var local_15: u32;
    var local_16: u32;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;

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
            phi_3464_ = _e231.unnamed.visibility;
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
                        phi_1996_ = false;
                        phi_1997_ = true;
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
                            local_6 = _e665;
                            if _e665 {
                                phi_950_ = u32();
                                phi_953_ = u32();
                                phi_1977_ = false;
                                phi_1978_ = false;
                                phi_1979_ = false;
                            } else {
                                phi_961_ = _e662;
                                phi_964_ = 0u;
                                phi_966_ = 0u;
                                phi_968_ = _e664;
                                loop {
                                    let _e667 = phi_961_;
                                    let _e669 = phi_964_;
                                    let _e671 = phi_966_;
                                    let _e673 = phi_968_;
                                    local_12 = _e671;
                                    local_4 = _e669;
                                    local_15 = _e667;
                                    local_16 = _e673;
                                    let _e674 = (_e667 == 0u);
                                    local_3 = _e674;
                                    if _e674 {
                                        phi_962_ = u32();
                                        phi_965_ = u32();
                                        phi_967_ = u32();
                                        phi_969_ = u32();
                                        phi_1315_ = false;
                                    } else {
                                        let _e675 = (_e671 == 0u);
                                        if _e675 {
                                            let _e682 = (((_e667 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e667), 32u, (_e667 == 0u))) * 4u);
                                            if (_e682 < _e84) {
                                            } else {
                                                return;
                                            }
                                            let _e686 = rows.member[(0u + _e682)];
                                            let _e687 = (_e682 + 1u);
                                            if (_e687 < _e84) {
                                            } else {
                                                return;
                                            }
                                            let _e691 = rows.member[(0u + _e687)];
                                            let _e692 = (_e682 + 2u);
                                            if (_e692 < _e84) {
                                            } else {
                                                return;
                                            }
                                            let _e696 = rows.member[(0u + _e692)];
                                            let _e697 = (_e682 + 3u);
                                            if (_e697 < _e84) {
                                            } else {
                                                return;
                                            }
                                            let _e701 = rows.member[(0u + _e697)];
                                            let _e702 = lt_bvh_LightNode(_e686, _e691, _e696, _e701);
                                            let _e704 = (_e667 & (_e667 - 1u));
                                            let _e716 = (_e492.unnamed.positive_exponent - bitcast<f32>(_e702.frame.x));
                                            let _e719 = bitcast<f32>((((_e702.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                            if (_e716 > 0f) {
                                                if (_e716 < (255f * _e719)) {
                                                    phi_1041_ = (_e716 / _e719);
                                                } else {
                                                    phi_1041_ = 255f;
                                                }
                                                let _e725 = phi_1041_;
                                                phi_1042_ = _e725;
                                            } else {
                                                phi_1042_ = 0f;
                                            }
                                            let _e727 = phi_1042_;
                                            let _e734 = select(select(u32(_e727), 0u, (_e727 < bitcast<f32>(0u))), 4294967295u, (_e727 > bitcast<f32>(1333788671u)));
                                            if (f32(_e734) < _e727) {
                                                phi_1056_ = (_e734 + 1u);
                                            } else {
                                                phi_1056_ = _e734;
                                            }
                                            let _e739 = phi_1056_;
                                            let _e740 = (_e734 * 16843009u);
                                            let _e741 = (_e739 * 16843009u);
                                            let _e751 = (_e492.unnamed.negative_exponent - bitcast<f32>(_e702.frame.y));
                                            let _e754 = bitcast<f32>((((_e702.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                            if (_e751 > 0f) {
                                                if (_e751 < (255f * _e754)) {
                                                    phi_1079_ = (_e751 / _e754);
                                                } else {
                                                    phi_1079_ = 255f;
                                                }
                                                let _e760 = phi_1079_;
                                                phi_1080_ = _e760;
                                            } else {
                                                phi_1080_ = 0f;
                                            }
                                            let _e762 = phi_1080_;
                                            let _e769 = select(select(u32(_e762), 0u, (_e762 < bitcast<f32>(0u))), 4294967295u, (_e762 > bitcast<f32>(1333788671u)));
                                            if (f32(_e769) < _e762) {
                                                phi_1094_ = (_e769 + 1u);
                                            } else {
                                                phi_1094_ = _e769;
                                            }
                                            let _e774 = phi_1094_;
                                            let _e775 = (_e769 * 16843009u);
                                            let _e776 = (_e774 * 16843009u);
                                            let _e786 = (_e492.unnamed.min_variance - bitcast<f32>(_e702.frame.z));
                                            let _e789 = bitcast<f32>((((_e702.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                            if (_e786 > 0f) {
                                                if (_e786 < (255f * _e789)) {
                                                    phi_1117_ = (_e786 / _e789);
                                                } else {
                                                    phi_1117_ = 255f;
                                                }
                                                let _e795 = phi_1117_;
                                                phi_1118_ = _e795;
                                            } else {
                                                phi_1118_ = 0f;
                                            }
                                            let _e797 = phi_1118_;
                                            let _e804 = select(select(u32(_e797), 0u, (_e797 < bitcast<f32>(0u))), 4294967295u, (_e797 > bitcast<f32>(1333788671u)));
                                            if (f32(_e804) < _e797) {
                                                phi_1132_ = (_e804 + 1u);
                                            } else {
                                                phi_1132_ = _e804;
                                            }
                                            let _e809 = phi_1132_;
                                            let _e810 = (_e809 * 16843009u);
                                            let _e943 = (((((((((((_e740 & ~(_e702.x.x)) | (~((_e702.x.x ^ _e740)) & ((_e740 | 2155905152u) - (_e702.x.x & 2139062143u)))) & ((_e702.x.z & ~(_e741)) | (~((_e741 ^ _e702.x.z)) & ((_e702.x.z | 2155905152u) - (_e741 & 2139062143u))))) & ((_e775 & ~(_e702.y.x)) | (~((_e702.y.x ^ _e775)) & ((_e775 | 2155905152u) - (_e702.y.x & 2139062143u))))) & ((_e702.y.z & ~(_e776)) | (~((_e776 ^ _e702.y.z)) & ((_e702.y.z | 2155905152u) - (_e776 & 2139062143u))))) & ((_e702.rest.x & ~(_e810)) | (~((_e810 ^ _e702.rest.x)) & ((_e702.rest.x | 2155905152u) - (_e810 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e740 & ~(_e702.x.y)) | (~((_e702.x.y ^ _e740)) & ((_e740 | 2155905152u) - (_e702.x.y & 2139062143u)))) & ((_e702.x.w & ~(_e741)) | (~((_e741 ^ _e702.x.w)) & ((_e702.x.w | 2155905152u) - (_e741 & 2139062143u))))) & ((_e775 & ~(_e702.y.y)) | (~((_e702.y.y ^ _e775)) & ((_e775 | 2155905152u) - (_e702.y.y & 2139062143u))))) & ((_e702.y.w & ~(_e776)) | (~((_e776 ^ _e702.y.w)) & ((_e702.y.w | 2155905152u) - (_e776 & 2139062143u))))) & ((_e702.rest.y & ~(_e810)) | (~((_e810 ^ _e702.rest.y)) & ((_e702.rest.y | 2155905152u) - (_e810 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                            if ((_e702.frame.w & 16777216u) != 0u) {
                                                phi_1286_ = _e704;
                                                phi_1287_ = _e702.rest.z;
                                                phi_1288_ = _e943;
                                                phi_1289_ = _e673;
                                            } else {
                                                if (_e943 == 0u) {
                                                    phi_1284_ = _e704;
                                                    phi_1285_ = _e673;
                                                } else {
                                                    if ((_e704 & 255u) == 0u) {
                                                        phi_1280_ = _e673;
                                                    } else {
                                                        if (_e673 < 32u) {
                                                            if (_e673 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            local_1[(0u + _e673)] = _e704;
                                                            phi_1279_ = (_e673 + 1u);
                                                        } else {
                                                            phi_1279_ = _e673;
                                                        }
                                                        let _e959 = phi_1279_;
                                                        phi_1280_ = _e959;
                                                    }
                                                    let _e961 = phi_1280_;
                                                    phi_1284_ = ((_e702.rest.z << bitcast<u32>(8i)) | _e943);
                                                    phi_1285_ = _e961;
                                                }
                                                let _e968 = phi_1284_;
                                                let _e970 = phi_1285_;
                                                phi_1286_ = _e968;
                                                phi_1287_ = _e669;
                                                phi_1288_ = _e671;
                                                phi_1289_ = _e970;
                                            }
                                            let _e972 = phi_1286_;
                                            let _e974 = phi_1287_;
                                            let _e976 = phi_1288_;
                                            let _e978 = phi_1289_;
                                            if ((_e972 & 255u) == 0u) {
                                                if (_e978 > 0u) {
                                                    let _e982 = (_e978 - 1u);
                                                    if (_e982 < 32u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e986 = local_1[(0u + _e982)];
                                                    phi_1307_ = _e986;
                                                    phi_1308_ = _e982;
                                                } else {
                                                    phi_1307_ = 0u;
                                                    phi_1308_ = _e978;
                                                }
                                                let _e988 = phi_1307_;
                                                let _e990 = phi_1308_;
                                                phi_1309_ = _e988;
                                                phi_1310_ = _e990;
                                            } else {
                                                phi_1309_ = _e972;
                                                phi_1310_ = _e978;
                                            }
                                            let _e992 = phi_1309_;
                                            let _e994 = phi_1310_;
                                            phi_1311_ = _e992;
                                            phi_1312_ = _e974;
                                            phi_1313_ = _e976;
                                            phi_1314_ = _e994;
                                        } else {
                                            phi_1311_ = u32();
                                            phi_1312_ = u32();
                                            phi_1313_ = u32();
                                            phi_1314_ = u32();
                                        }
                                        let _e996 = phi_1311_;
                                        let _e998 = phi_1312_;
                                        let _e1000 = phi_1313_;
                                        let _e1002 = phi_1314_;
                                        phi_962_ = _e996;
                                        phi_965_ = _e998;
                                        phi_967_ = _e1000;
                                        phi_969_ = _e1002;
                                        phi_1315_ = _e675;
                                    }
                                    let _e1004 = phi_962_;
                                    let _e1006 = phi_965_;
                                    let _e1008 = phi_967_;
                                    let _e1010 = phi_969_;
                                    let _e1012 = phi_1315_;
                                    continue;
                                    continuing {
                                        phi_961_ = _e1004;
                                        phi_964_ = _e1006;
                                        phi_966_ = _e1008;
                                        phi_968_ = _e1010;
                                        break if !(_e1012);
                                    }
                                }
                                let _e1015 = local_3;
                                if _e1015 {
                                }
                                let _e3107 = local_12;
                                phi_1320_ = _e3107;
                                loop {
                                    let _e1017 = phi_1320_;
                                    let _e1018 = (_e1017 == 0u);
                                    local_5 = _e1018;
                                    local_17 = _e1018;
                                    if _e1018 {
                                        phi_1321_ = u32();
                                        phi_1969_ = false;
                                        phi_1970_ = false;
                                        phi_1971_ = false;
                                    } else {
                                        let _e1021 = select(firstTrailingBit(_e1017), 32u, (_e1017 == 0u));
                                        let _e1025 = local_4;
                                        let _e1026 = (_e1025 + (_e1021 >> bitcast<u32>(2i)));
                                        if (_e1026 < _e84) {
                                        } else {
                                            return;
                                        }
                                        let _e1031 = rows.member[(0u + _e1026)][0u];
                                        let _e1035 = rows.member[(0u + _e1026)][1u];
                                        let _e1039 = rows.member[(0u + _e1026)][2u];
                                        let _e1043 = rows.member[(0u + _e1026)][3u];
                                        if ((_e1021 & 2u) == 0u) {
                                            phi_1359_ = _e1035;
                                            phi_1360_ = _e1031;
                                        } else {
                                            phi_1359_ = _e1043;
                                            phi_1360_ = _e1039;
                                        }
                                        let _e1047 = phi_1359_;
                                        let _e1049 = phi_1360_;
                                        if ((_e1021 & 1u) == 0u) {
                                            phi_1366_ = _e1049;
                                        } else {
                                            phi_1366_ = _e1047;
                                        }
                                        let _e1053 = phi_1366_;
                                        if (_e1053 < _e78) {
                                        } else {
                                            return;
                                        }
                                        let _e1060 = triangles.member[(0u + _e1053)].v0_;
                                        let _e1062 = (_e1060.x - _e252);
                                        let _e1064 = (_e1060.y - _e254);
                                        let _e1066 = (_e1060.z - _e256);
                                        if (_e641 == 0u) {
                                            phi_1396_ = vec3<f32>(_e1064, _e1066, _e1062);
                                        } else {
                                            if (_e641 == 1u) {
                                                phi_1395_ = vec3<f32>(_e1066, _e1062, _e1064);
                                            } else {
                                                phi_1395_ = (_e1060 - vec3<f32>(_e252, _e254, _e256));
                                            }
                                            let _e1074 = phi_1395_;
                                            phi_1396_ = _e1074;
                                        }
                                        let _e1076 = phi_1396_;
                                        let _e1080 = (_e1076.x - (_e652 * _e1076.z));
                                        let _e1084 = (_e1076.y - (_e655 * _e1076.z));
                                        let _e1086 = triangles.member[(0u + _e1053)].v1_;
                                        let _e1088 = (_e1086.x - _e252);
                                        let _e1090 = (_e1086.y - _e254);
                                        let _e1092 = (_e1086.z - _e256);
                                        if (_e641 == 0u) {
                                            phi_1426_ = vec3<f32>(_e1090, _e1092, _e1088);
                                        } else {
                                            if (_e641 == 1u) {
                                                phi_1425_ = vec3<f32>(_e1092, _e1088, _e1090);
                                            } else {
                                                phi_1425_ = (_e1086 - vec3<f32>(_e252, _e254, _e256));
                                            }
                                            let _e1100 = phi_1425_;
                                            phi_1426_ = _e1100;
                                        }
                                        let _e1102 = phi_1426_;
                                        let _e1106 = (_e1102.x - (_e652 * _e1102.z));
                                        let _e1110 = (_e1102.y - (_e655 * _e1102.z));
                                        let _e1112 = triangles.member[(0u + _e1053)].v2_;
                                        let _e1114 = (_e1112.x - _e252);
                                        let _e1116 = (_e1112.y - _e254);
                                        let _e1118 = (_e1112.z - _e256);
                                        if (_e641 == 0u) {
                                            phi_1456_ = vec3<f32>(_e1116, _e1118, _e1114);
                                        } else {
                                            if (_e641 == 1u) {
                                                phi_1455_ = vec3<f32>(_e1118, _e1114, _e1116);
                                            } else {
                                                phi_1455_ = (_e1112 - vec3<f32>(_e252, _e254, _e256));
                                            }
                                            let _e1126 = phi_1455_;
                                            phi_1456_ = _e1126;
                                        }
                                        let _e1128 = phi_1456_;
                                        let _e1132 = (_e1128.x - (_e652 * _e1128.z));
                                        let _e1136 = (_e1128.y - (_e655 * _e1128.z));
                                        if (_e1106 < _e1132) {
                                            phi_1475_ = true;
                                        } else {
                                            if (_e1106 == _e1132) {
                                                phi_1474_ = (_e1110 < _e1136);
                                            } else {
                                                phi_1474_ = false;
                                            }
                                            let _e1141 = phi_1474_;
                                            phi_1475_ = _e1141;
                                        }
                                        let _e1143 = phi_1475_;
                                        if _e1143 {
                                            phi_1479_ = _e1136;
                                            phi_1480_ = _e1132;
                                            phi_1481_ = _e1110;
                                            phi_1482_ = _e1106;
                                        } else {
                                            phi_1479_ = _e1110;
                                            phi_1480_ = _e1106;
                                            phi_1481_ = _e1136;
                                            phi_1482_ = _e1132;
                                        }
                                        let _e1145 = phi_1479_;
                                        let _e1147 = phi_1480_;
                                        let _e1149 = phi_1481_;
                                        let _e1151 = phi_1482_;
                                        let _e1154 = ((_e1151 * _e1145) - (_e1149 * _e1147));
                                        if _e1143 {
                                            phi_1490_ = -(_e1154);
                                        } else {
                                            phi_1490_ = _e1154;
                                        }
                                        let _e1157 = phi_1490_;
                                        if (_e1132 < _e1080) {
                                            phi_1501_ = true;
                                        } else {
                                            if (_e1132 == _e1080) {
                                                phi_1500_ = (_e1136 < _e1084);
                                            } else {
                                                phi_1500_ = false;
                                            }
                                            let _e1162 = phi_1500_;
                                            phi_1501_ = _e1162;
                                        }
                                        let _e1164 = phi_1501_;
                                        if _e1164 {
                                            phi_1505_ = _e1084;
                                            phi_1506_ = _e1080;
                                            phi_1507_ = _e1136;
                                            phi_1508_ = _e1132;
                                        } else {
                                            phi_1505_ = _e1136;
                                            phi_1506_ = _e1132;
                                            phi_1507_ = _e1084;
                                            phi_1508_ = _e1080;
                                        }
                                        let _e1166 = phi_1505_;
                                        let _e1168 = phi_1506_;
                                        let _e1170 = phi_1507_;
                                        let _e1172 = phi_1508_;
                                        let _e1175 = ((_e1172 * _e1166) - (_e1170 * _e1168));
                                        if _e1164 {
                                            phi_1516_ = -(_e1175);
                                        } else {
                                            phi_1516_ = _e1175;
                                        }
                                        let _e1178 = phi_1516_;
                                        if (_e1080 < _e1106) {
                                            phi_1527_ = true;
                                        } else {
                                            if (_e1080 == _e1106) {
                                                phi_1526_ = (_e1084 < _e1110);
                                            } else {
                                                phi_1526_ = false;
                                            }
                                            let _e1183 = phi_1526_;
                                            phi_1527_ = _e1183;
                                        }
                                        let _e1185 = phi_1527_;
                                        if _e1185 {
                                            phi_1531_ = _e1110;
                                            phi_1532_ = _e1106;
                                            phi_1533_ = _e1084;
                                            phi_1534_ = _e1080;
                                        } else {
                                            phi_1531_ = _e1084;
                                            phi_1532_ = _e1080;
                                            phi_1533_ = _e1110;
                                            phi_1534_ = _e1106;
                                        }
                                        let _e1187 = phi_1531_;
                                        let _e1189 = phi_1532_;
                                        let _e1191 = phi_1533_;
                                        let _e1193 = phi_1534_;
                                        let _e1196 = ((_e1193 * _e1187) - (_e1191 * _e1189));
                                        if _e1185 {
                                            phi_1542_ = -(_e1196);
                                        } else {
                                            phi_1542_ = _e1196;
                                        }
                                        let _e1199 = phi_1542_;
                                        if (_e1157 >= 0f) {
                                            if (_e1178 >= 0f) {
                                                if (_e1199 >= 0f) {
                                                    phi_1557_ = ((_e1157 + _e1178) + _e1199);
                                                    phi_1558_ = false;
                                                } else {
                                                    phi_1557_ = f32();
                                                    phi_1558_ = true;
                                                }
                                                let _e1206 = phi_1557_;
                                                let _e1208 = phi_1558_;
                                                phi_1559_ = _e1206;
                                                phi_1560_ = _e1208;
                                            } else {
                                                phi_1559_ = f32();
                                                phi_1560_ = true;
                                            }
                                            let _e1210 = phi_1559_;
                                            let _e1212 = phi_1560_;
                                            phi_1561_ = _e1210;
                                            phi_1562_ = _e1212;
                                        } else {
                                            phi_1561_ = f32();
                                            phi_1562_ = true;
                                        }
                                        let _e1214 = phi_1561_;
                                        let _e1216 = phi_1562_;
                                        if _e1216 {
                                            if (_e1157 <= 0f) {
                                                if (_e1178 <= 0f) {
                                                    let _e1219 = (_e1199 <= 0f);
                                                    if _e1219 {
                                                    }
                                                    phi_1580_ = ((_e1157 + _e1178) + _e1199);
                                                    phi_1581_ = false;
                                                    phi_1582_ = _e1219;
                                                } else {
                                                    phi_1580_ = f32();
                                                    phi_1581_ = true;
                                                    phi_1582_ = false;
                                                }
                                                let _e1223 = phi_1580_;
                                                let _e1225 = phi_1581_;
                                                let _e1227 = phi_1582_;
                                                phi_1583_ = _e1223;
                                                phi_1584_ = _e1225;
                                                phi_1585_ = _e1227;
                                            } else {
                                                phi_1583_ = f32();
                                                phi_1584_ = true;
                                                phi_1585_ = false;
                                            }
                                            let _e1229 = phi_1583_;
                                            let _e1231 = phi_1584_;
                                            let _e1233 = phi_1585_;
                                            if _e1231 {
                                                phi_1589_ = false;
                                            } else {
                                                phi_1589_ = _e1233;
                                            }
                                            let _e1235 = phi_1589_;
                                            phi_1590_ = _e1229;
                                            phi_1591_ = _e1235;
                                        } else {
                                            phi_1590_ = _e1214;
                                            phi_1591_ = true;
                                        }
                                        let _e1237 = phi_1590_;
                                        let _e1239 = phi_1591_;
                                        if _e1239 {
                                            let _e1240 = (_e1237 == 0f);
                                            if _e1240 {
                                                phi_1907_ = lt_bvh_triangle_Intersection();
                                                phi_1908_ = false;
                                            } else {
                                                let _e1242 = triangles.member[(0u + _e1053)].v0_;
                                                let _e1244 = (_e1242.x - _e252);
                                                let _e1246 = (_e1242.y - _e254);
                                                let _e1248 = (_e1242.z - _e256);
                                                if (_e641 == 0u) {
                                                    phi_1620_ = vec3<f32>(_e1246, _e1248, _e1244);
                                                } else {
                                                    if (_e641 == 1u) {
                                                        phi_1619_ = vec3<f32>(_e1248, _e1244, _e1246);
                                                    } else {
                                                        phi_1619_ = (_e1242 - vec3<f32>(_e252, _e254, _e256));
                                                    }
                                                    let _e1256 = phi_1619_;
                                                    phi_1620_ = _e1256;
                                                }
                                                let _e1258 = phi_1620_;
                                                let _e1260 = triangles.member[(0u + _e1053)].v1_;
                                                let _e1262 = triangles.member[(0u + _e1053)].v0_;
                                                let _e1265 = (_e1260.x - _e1262.x);
                                                let _e1268 = (_e1260.y - _e1262.y);
                                                let _e1271 = (_e1260.z - _e1262.z);
                                                if (_e641 == 0u) {
                                                    phi_1646_ = vec3<f32>(_e1268, _e1271, _e1265);
                                                } else {
                                                    if (_e641 == 1u) {
                                                        phi_1645_ = vec3<f32>(_e1271, _e1265, _e1268);
                                                    } else {
                                                        phi_1645_ = (_e1260 - _e1262);
                                                    }
                                                    let _e1278 = phi_1645_;
                                                    phi_1646_ = _e1278;
                                                }
                                                let _e1280 = phi_1646_;
                                                let _e1282 = triangles.member[(0u + _e1053)].v2_;
                                                let _e1284 = triangles.member[(0u + _e1053)].v0_;
                                                let _e1287 = (_e1282.x - _e1284.x);
                                                let _e1290 = (_e1282.y - _e1284.y);
                                                let _e1293 = (_e1282.z - _e1284.z);
                                                if (_e641 == 0u) {
                                                    phi_1672_ = vec3<f32>(_e1290, _e1293, _e1287);
                                                } else {
                                                    if (_e641 == 1u) {
                                                        phi_1671_ = vec3<f32>(_e1293, _e1287, _e1290);
                                                    } else {
                                                        phi_1671_ = (_e1282 - _e1284);
                                                    }
                                                    let _e1300 = phi_1671_;
                                                    phi_1672_ = _e1300;
                                                }
                                                let _e1302 = phi_1672_;
                                                let _e1309 = ((_e1280.y * _e1302.z) - (_e1280.z * _e1302.y));
                                                let _e1316 = ((_e1280.z * _e1302.x) - (_e1280.x * _e1302.z));
                                                let _e1323 = ((_e1280.x * _e1302.y) - (_e1280.y * _e1302.x));
                                                let _e1337 = (((1f / _e649.z) * (((_e1309 * _e1258.x) + (_e1316 * _e1258.y)) + (_e1323 * _e1258.z))) / (((_e1309 * _e652) + (_e1316 * _e655)) + _e1323));
                                                if (_e1337 > 0f) {
                                                    if (_e1337 < _e264) {
                                                        let _e1341 = triangles.member[(0u + _e1053)].v0_;
                                                        let _e1343 = triangles.member[(0u + _e1053)].v1_;
                                                        if (_e1341.x < _e1343.x) {
                                                            phi_1728_ = _e1341.x;
                                                        } else {
                                                            phi_1728_ = _e1343.x;
                                                        }
                                                        let _e1350 = phi_1728_;
                                                        if (_e1341.y < _e1343.y) {
                                                            phi_1737_ = _e1341.y;
                                                        } else {
                                                            phi_1737_ = _e1343.y;
                                                        }
                                                        let _e1357 = phi_1737_;
                                                        if (_e1341.z < _e1343.z) {
                                                            phi_1746_ = _e1341.z;
                                                        } else {
                                                            phi_1746_ = _e1343.z;
                                                        }
                                                        let _e1364 = phi_1746_;
                                                        let _e1366 = triangles.member[(0u + _e1053)].v2_;
                                                        if (_e1350 < _e1366.x) {
                                                            phi_1755_ = _e1350;
                                                        } else {
                                                            phi_1755_ = _e1366.x;
                                                        }
                                                        let _e1371 = phi_1755_;
                                                        if (_e1357 < _e1366.y) {
                                                            phi_1762_ = _e1357;
                                                        } else {
                                                            phi_1762_ = _e1366.y;
                                                        }
                                                        let _e1376 = phi_1762_;
                                                        if (_e1364 < _e1366.z) {
                                                            phi_1769_ = _e1364;
                                                        } else {
                                                            phi_1769_ = _e1366.z;
                                                        }
                                                        let _e1381 = phi_1769_;
                                                        let _e1383 = triangles.member[(0u + _e1053)].v0_;
                                                        let _e1385 = triangles.member[(0u + _e1053)].v1_;
                                                        if (_e1383.x > _e1385.x) {
                                                            phi_1782_ = _e1383.x;
                                                        } else {
                                                            phi_1782_ = _e1385.x;
                                                        }
                                                        let _e1392 = phi_1782_;
                                                        if (_e1383.y > _e1385.y) {
                                                            phi_1791_ = _e1383.y;
                                                        } else {
                                                            phi_1791_ = _e1385.y;
                                                        }
                                                        let _e1399 = phi_1791_;
                                                        if (_e1383.z > _e1385.z) {
                                                            phi_1800_ = _e1383.z;
                                                        } else {
                                                            phi_1800_ = _e1385.z;
                                                        }
                                                        let _e1406 = phi_1800_;
                                                        let _e1408 = triangles.member[(0u + _e1053)].v2_;
                                                        if (_e1392 > _e1408.x) {
                                                            phi_1809_ = _e1392;
                                                        } else {
                                                            phi_1809_ = _e1408.x;
                                                        }
                                                        let _e1413 = phi_1809_;
                                                        if (_e1399 > _e1408.y) {
                                                            phi_1816_ = _e1399;
                                                        } else {
                                                            phi_1816_ = _e1408.y;
                                                        }
                                                        let _e1418 = phi_1816_;
                                                        if (_e1406 > _e1408.z) {
                                                            phi_1823_ = _e1406;
                                                        } else {
                                                            phi_1823_ = _e1408.z;
                                                        }
                                                        let _e1423 = phi_1823_;
                                                        let _e1427 = ((_e1371 - _e252) * _e570);
                                                        let _e1428 = ((_e1376 - _e254) * _e580);
                                                        let _e1429 = ((_e1381 - _e256) * _e590);
                                                        let _e1433 = ((_e1413 - _e252) * _e570);
                                                        let _e1434 = ((_e1418 - _e254) * _e580);
                                                        let _e1435 = ((_e1423 - _e256) * _e590);
                                                        if (_e1427 < _e1433) {
                                                            phi_1840_ = _e1427;
                                                        } else {
                                                            phi_1840_ = _e1433;
                                                        }
                                                        let _e1438 = phi_1840_;
                                                        if (_e1428 < _e1434) {
                                                            phi_1845_ = _e1428;
                                                        } else {
                                                            phi_1845_ = _e1434;
                                                        }
                                                        let _e1441 = phi_1845_;
                                                        if (_e1429 < _e1435) {
                                                            phi_1850_ = _e1429;
                                                        } else {
                                                            phi_1850_ = _e1435;
                                                        }
                                                        let _e1444 = phi_1850_;
                                                        if (_e1427 > _e1433) {
                                                            phi_1858_ = _e1427;
                                                        } else {
                                                            phi_1858_ = _e1433;
                                                        }
                                                        let _e1450 = phi_1858_;
                                                        if (_e1428 > _e1434) {
                                                            phi_1863_ = _e1428;
                                                        } else {
                                                            phi_1863_ = _e1434;
                                                        }
                                                        let _e1453 = phi_1863_;
                                                        if (_e1429 > _e1435) {
                                                            phi_1868_ = _e1429;
                                                        } else {
                                                            phi_1868_ = _e1435;
                                                        }
                                                        let _e1456 = phi_1868_;
                                                        let _e1460 = core_intrinsics_maximum_number_nsz_f32_((_e1438 - _e625), (_e1441 - _e626));
                                                        let _e1461 = core_intrinsics_maximum_number_nsz_f32_(_e1460, (_e1444 - _e627));
                                                        let _e1462 = core_intrinsics_minimum_number_nsz_f32_((_e1450 + _e625), (_e1453 + _e626));
                                                        let _e1463 = core_intrinsics_minimum_number_nsz_f32_(_e1462, (_e1456 + _e627));
                                                        if (_e1461 > -300000000000000000000000000000000000000f) {
                                                            phi_1880_ = _e1461;
                                                        } else {
                                                            phi_1880_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1466 = phi_1880_;
                                                        if (_e1463 < 300000000000000000000000000000000000000f) {
                                                            phi_1885_ = _e1463;
                                                        } else {
                                                            phi_1885_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1469 = phi_1885_;
                                                        if (_e1337 < _e1466) {
                                                            phi_1890_ = _e1466;
                                                        } else {
                                                            phi_1890_ = _e1337;
                                                        }
                                                        let _e1472 = phi_1890_;
                                                        if (_e1472 > _e1469) {
                                                            phi_1895_ = _e1469;
                                                        } else {
                                                            phi_1895_ = _e1472;
                                                        }
                                                        let _e1475 = phi_1895_;
                                                        phi_1900_ = lt_bvh_triangle_Intersection(_e1475, (_e1178 / _e1237), (_e1199 / _e1237), (_e1466 <= _e1469));
                                                        phi_1901_ = false;
                                                    } else {
                                                        phi_1900_ = lt_bvh_triangle_Intersection();
                                                        phi_1901_ = true;
                                                    }
                                                    let _e1481 = phi_1900_;
                                                    let _e1483 = phi_1901_;
                                                    phi_1902_ = _e1481;
                                                    phi_1903_ = _e1483;
                                                } else {
                                                    phi_1902_ = lt_bvh_triangle_Intersection();
                                                    phi_1903_ = true;
                                                }
                                                let _e1485 = phi_1902_;
                                                let _e1487 = phi_1903_;
                                                if _e1487 {
                                                }
                                                phi_1907_ = _e1485;
                                                phi_1908_ = _e1487;
                                            }
                                            let _e1489 = phi_1907_;
                                            let _e1491 = phi_1908_;
                                            phi_1909_ = _e1489;
                                            phi_1910_ = _e1240;
                                            phi_1911_ = _e1491;
                                        } else {
                                            phi_1909_ = lt_bvh_triangle_Intersection();
                                            phi_1910_ = true;
                                            phi_1911_ = false;
                                        }
                                        let _e1493 = phi_1909_;
                                        let _e1495 = phi_1910_;
                                        let _e1497 = phi_1911_;
                                        if _e1495 {
                                            phi_1915_ = true;
                                        } else {
                                            phi_1915_ = _e1497;
                                        }
                                        let _e1499 = phi_1915_;
                                        if _e1499 {
                                            phi_1919_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_1919_ = _e1493;
                                        }
                                        let _e1501 = phi_1919_;
                                        if _e1501.is_hit {
                                            if (_e1501.t > 0f) {
                                                if (_e1501.t < _e264) {
                                                    let _e1508 = triangles.member[(0u + _e1053)].i0_;
                                                    let _e1510 = ((_e1508 & 2147483648u) == 0u);
                                                    if _e1510 {
                                                        phi_1945_ = false;
                                                        phi_1946_ = false;
                                                    } else {
                                                        if true {
                                                            phi_1944_ = false;
                                                        } else {
                                                            phi_1944_ = true;
                                                        }
                                                        let _e1512 = phi_1944_;
                                                        phi_1945_ = _e1512;
                                                        phi_1946_ = true;
                                                    }
                                                    let _e1514 = phi_1945_;
                                                    let _e1516 = phi_1946_;
                                                    phi_1947_ = _e1514;
                                                    phi_1948_ = _e1510;
                                                    phi_1949_ = _e1516;
                                                } else {
                                                    phi_1947_ = true;
                                                    phi_1948_ = false;
                                                    phi_1949_ = false;
                                                }
                                                let _e1518 = phi_1947_;
                                                let _e1520 = phi_1948_;
                                                let _e1522 = phi_1949_;
                                                phi_1950_ = false;
                                                phi_1951_ = _e1518;
                                                phi_1952_ = _e1520;
                                                phi_1953_ = _e1522;
                                            } else {
                                                phi_1950_ = true;
                                                phi_1951_ = false;
                                                phi_1952_ = false;
                                                phi_1953_ = false;
                                            }
                                            let _e1524 = phi_1950_;
                                            let _e1526 = phi_1951_;
                                            let _e1528 = phi_1952_;
                                            let _e1530 = phi_1953_;
                                            phi_1954_ = _e1524;
                                            phi_1955_ = _e1526;
                                            phi_1956_ = _e1528;
                                            phi_1957_ = _e1530;
                                        } else {
                                            phi_1954_ = true;
                                            phi_1955_ = false;
                                            phi_1956_ = false;
                                            phi_1957_ = false;
                                        }
                                        let _e1532 = phi_1954_;
                                        let _e1534 = phi_1955_;
                                        let _e1536 = phi_1956_;
                                        let _e1538 = phi_1957_;
                                        if _e1532 {
                                            phi_1961_ = true;
                                            phi_1962_ = false;
                                            phi_1963_ = false;
                                        } else {
                                            phi_1961_ = _e1534;
                                            phi_1962_ = _e1536;
                                            phi_1963_ = _e1538;
                                        }
                                        let _e1540 = phi_1961_;
                                        let _e1542 = phi_1962_;
                                        let _e1544 = phi_1963_;
                                        if _e1540 {
                                            phi_1967_ = false;
                                            phi_1968_ = false;
                                        } else {
                                            phi_1967_ = _e1542;
                                            phi_1968_ = _e1544;
                                        }
                                        let _e1546 = phi_1967_;
                                        let _e1548 = phi_1968_;
                                        phi_1321_ = (_e1017 & (_e1017 - 1u));
                                        phi_1969_ = _e1540;
                                        phi_1970_ = _e1546;
                                        phi_1971_ = _e1548;
                                    }
                                    let _e1550 = phi_1321_;
                                    let _e1552 = phi_1969_;
                                    let _e1554 = phi_1970_;
                                    let _e1556 = phi_1971_;
                                    local_13 = _e1554;
                                    local_14 = _e1556;
                                    continue;
                                    continuing {
                                        phi_1320_ = _e1550;
                                        break if !(_e1552);
                                    }
                                }
                                let _e1559 = local_5;
                                if _e1559 {
                                    phi_1975_ = false;
                                    phi_1976_ = false;
                                } else {
                                    let _e3219 = local_13;
                                    phi_1975_ = _e3219;
                                    let _e3222 = local_14;
                                    phi_1976_ = _e3222;
                                }
                                let _e1561 = phi_1975_;
                                let _e1563 = phi_1976_;
                                let _e3225 = local_15;
                                phi_950_ = _e3225;
                                let _e3228 = local_16;
                                phi_953_ = _e3228;
                                let _e3231 = local_17;
                                phi_1977_ = _e3231;
                                phi_1978_ = _e1561;
                                phi_1979_ = _e1563;
                            }
                            let _e1565 = phi_950_;
                            let _e1567 = phi_953_;
                            let _e1569 = phi_1977_;
                            let _e1571 = phi_1978_;
                            let _e1573 = phi_1979_;
                            local_18 = _e1571;
                            local_19 = _e1573;
                            continue;
                            continuing {
                                phi_949_ = _e1565;
                                phi_952_ = _e1567;
                                break if !(_e1569);
                            }
                        }
                        let _e1576 = local_6;
                        if _e1576 {
                            phi_1983_ = false;
                            phi_1984_ = false;
                        } else {
                            let _e3237 = local_18;
                            phi_1983_ = _e3237;
                            let _e3240 = local_19;
                            phi_1984_ = _e3240;
                        }
                        let _e1578 = phi_1983_;
                        let _e1580 = phi_1984_;
                        if _e1578 {
                            phi_1988_ = false;
                        } else {
                            phi_1988_ = _e1580;
                        }
                        let _e1582 = phi_1988_;
                        if _e1582 {
                            phi_1992_ = true;
                        } else {
                            phi_1992_ = _e1578;
                        }
                        let _e1584 = phi_1992_;
                        if _e1584 {
                        }
                        phi_1996_ = true;
                        phi_1997_ = _e1584;
                    }
                    let _e1586 = phi_1996_;
                    let _e1588 = phi_1997_;
                    if _e1588 {
                        phi_2001_ = _e1586;
                    } else {
                        phi_2001_ = false;
                    }
                    let _e1590 = phi_2001_;
                    phi_3458_ = _e1590;
                } else {
                    let _e1591 = abs(_e272);
                    let _e1592 = abs(_e273);
                    let _e1593 = abs(_e274);
                    if (abs(_e252) < 1000000000000000f) {
                        if (abs(_e254) < 1000000000000000f) {
                            phi_2017_ = (abs(_e256) < 1000000000000000f);
                            phi_2018_ = false;
                        } else {
                            phi_2017_ = bool();
                            phi_2018_ = true;
                        }
                        let _e1601 = phi_2017_;
                        let _e1603 = phi_2018_;
                        phi_2019_ = _e1601;
                        phi_2020_ = _e1603;
                    } else {
                        phi_2019_ = bool();
                        phi_2020_ = true;
                    }
                    let _e1605 = phi_2019_;
                    let _e1607 = phi_2020_;
                    if _e1607 {
                        phi_2024_ = false;
                    } else {
                        phi_2024_ = _e1605;
                    }
                    let _e1609 = phi_2024_;
                    if _e1609 {
                        if (_e1591 < 1000000000000000f) {
                            if (_e1592 < 1000000000000000f) {
                                phi_2037_ = (_e1593 < 1000000000000000f);
                                phi_2038_ = false;
                            } else {
                                phi_2037_ = bool();
                                phi_2038_ = true;
                            }
                            let _e1614 = phi_2037_;
                            let _e1616 = phi_2038_;
                            phi_2039_ = _e1614;
                            phi_2040_ = _e1616;
                        } else {
                            phi_2039_ = bool();
                            phi_2040_ = true;
                        }
                        let _e1618 = phi_2039_;
                        let _e1620 = phi_2040_;
                        if _e1620 {
                            phi_2044_ = false;
                        } else {
                            phi_2044_ = _e1618;
                        }
                        let _e1622 = phi_2044_;
                        if _e1622 {
                            if (_e1591 > 0f) {
                                phi_2058_ = bool();
                                phi_2059_ = true;
                            } else {
                                let _e1624 = (_e1592 > 0f);
                                if _e1624 {
                                    phi_2057_ = bool();
                                } else {
                                    phi_2057_ = (_e1593 > 0f);
                                }
                                let _e1627 = phi_2057_;
                                phi_2058_ = _e1627;
                                phi_2059_ = _e1624;
                            }
                            let _e1629 = phi_2058_;
                            let _e1631 = phi_2059_;
                            if _e1631 {
                                phi_2063_ = true;
                            } else {
                                phi_2063_ = _e1629;
                            }
                            let _e1633 = phi_2063_;
                            phi_2064_ = _e1633;
                            phi_2065_ = false;
                        } else {
                            phi_2064_ = bool();
                            phi_2065_ = true;
                        }
                        let _e1635 = phi_2064_;
                        let _e1637 = phi_2065_;
                        phi_2066_ = _e1635;
                        phi_2067_ = _e1637;
                    } else {
                        phi_2066_ = bool();
                        phi_2067_ = true;
                    }
                    let _e1639 = phi_2066_;
                    let _e1641 = phi_2067_;
                    if _e1641 {
                        phi_2071_ = false;
                    } else {
                        phi_2071_ = _e1639;
                    }
                    let _e1643 = phi_2071_;
                    if _e1643 {
                        let _e1644 = (0u >= _e75);
                        if _e1644 {
                            phi_3451_ = bool();
                        } else {
                            if (0u < _e75) {
                            } else {
                                return;
                            }
                            let _e1650 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1654 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1658 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1662 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1666 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1670 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1674 = nodes.member[(0u + 0u)].frame[3u];
                            let _e1708 = core_intrinsics_maximum_number_nsz_f32_(abs(_e272), abs(_e273));
                            let _e1709 = core_intrinsics_maximum_number_nsz_f32_(_e1708, abs(_e274));
                            let _e1710 = (_e1709 * 0.0000000000009094947f);
                            if (abs(_e272) < _e1710) {
                                phi_2141_ = _e1710;
                            } else {
                                phi_2141_ = abs(_e272);
                            }
                            let _e1715 = phi_2141_;
                            if (_e272 < 0f) {
                                phi_2148_ = (-1f / _e1715);
                            } else {
                                phi_2148_ = (1f / _e1715);
                            }
                            let _e1720 = phi_2148_;
                            if (abs(_e273) < _e1710) {
                                phi_2155_ = _e1710;
                            } else {
                                phi_2155_ = abs(_e273);
                            }
                            let _e1725 = phi_2155_;
                            if (_e273 < 0f) {
                                phi_2162_ = (-1f / _e1725);
                            } else {
                                phi_2162_ = (1f / _e1725);
                            }
                            let _e1730 = phi_2162_;
                            if (abs(_e274) < _e1710) {
                                phi_2169_ = _e1710;
                            } else {
                                phi_2169_ = abs(_e274);
                            }
                            let _e1735 = phi_2169_;
                            if (_e274 < 0f) {
                                phi_2176_ = (-1f / _e1735);
                            } else {
                                phi_2176_ = (1f / _e1735);
                            }
                            let _e1740 = phi_2176_;
                            let _e1744 = abs((bitcast<f32>(_e1650) - _e252));
                            let _e1745 = abs((bitcast<f32>(_e1654) - _e254));
                            let _e1746 = abs((bitcast<f32>(_e1658) - _e256));
                            let _e1750 = abs(((bitcast<f32>(_e1662) + (bitcast<f32>((((_e1674 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e252));
                            let _e1751 = abs(((bitcast<f32>(_e1666) + (bitcast<f32>((((_e1674 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e254));
                            let _e1752 = abs(((bitcast<f32>(_e1670) + (bitcast<f32>((((_e1674 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e256));
                            if (_e1744 > _e1750) {
                                phi_2193_ = _e1744;
                            } else {
                                phi_2193_ = _e1750;
                            }
                            let _e1755 = phi_2193_;
                            if (_e1745 > _e1751) {
                                phi_2198_ = _e1745;
                            } else {
                                phi_2198_ = _e1751;
                            }
                            let _e1758 = phi_2198_;
                            if (_e1746 > _e1752) {
                                phi_2203_ = _e1746;
                            } else {
                                phi_2203_ = _e1752;
                            }
                            let _e1761 = phi_2203_;
                            if (_e1755 > _e1758) {
                                phi_2208_ = _e1755;
                            } else {
                                phi_2208_ = _e1758;
                            }
                            let _e1764 = phi_2208_;
                            if (_e1764 > _e1761) {
                                phi_2213_ = _e1764;
                            } else {
                                phi_2213_ = _e1761;
                            }
                            let _e1767 = phi_2213_;
                            let _e1771 = (_e1767 * 0.0000019073486f);
                            let _e1772 = (abs(_e1720) * _e1771);
                            let _e1773 = (abs(_e1730) * _e1771);
                            let _e1774 = (abs(_e1740) * _e1771);
                            let _e1778 = (_e1767 * 0.0000009536743f);
                            let _e1779 = (abs(_e1720) * _e1778);
                            let _e1780 = (abs(_e1730) * _e1778);
                            let _e1781 = (abs(_e1740) * _e1778);
                            let _e1782 = abs(_e272);
                            let _e1783 = abs(_e273);
                            let _e1784 = abs(_e274);
                            if (_e1782 >= _e1783) {
                                if (_e1782 >= _e1784) {
                                    phi_2239_ = false;
                                } else {
                                    phi_2239_ = true;
                                }
                                let _e1788 = phi_2239_;
                                phi_2240_ = _e1788;
                            } else {
                                phi_2240_ = true;
                            }
                            let _e1790 = phi_2240_;
                            if _e1790 {
                                if (_e1783 >= _e1784) {
                                    phi_2248_ = 1u;
                                } else {
                                    phi_2248_ = 2u;
                                }
                                let _e1793 = phi_2248_;
                                phi_2249_ = _e1793;
                            } else {
                                phi_2249_ = 0u;
                            }
                            let _e1795 = phi_2249_;
                            if (_e1795 == 0u) {
                                phi_2261_ = vec3<f32>(_e273, _e274, _e272);
                            } else {
                                if (_e1795 == 1u) {
                                    phi_2260_ = vec3<f32>(_e274, _e272, _e273);
                                } else {
                                    phi_2260_ = _e275;
                                }
                                let _e1801 = phi_2260_;
                                phi_2261_ = _e1801;
                            }
                            let _e1803 = phi_2261_;
                            let _e1806 = (_e1803.x / _e1803.z);
                            let _e1809 = (_e1803.y / _e1803.z);
                            if (_e1720 < 0f) {
                                phi_2274_ = 0u;
                            } else {
                                phi_2274_ = 1u;
                            }
                            let _e1814 = phi_2274_;
                            if (_e1730 < 0f) {
                                phi_2279_ = 0u;
                            } else {
                                phi_2279_ = 2u;
                            }
                            let _e1817 = phi_2279_;
                            if (_e1740 < 0f) {
                                phi_2284_ = 0u;
                            } else {
                                phi_2284_ = 4u;
                            }
                            let _e1820 = phi_2284_;
                            let _e1822 = ((_e1814 | _e1817) | _e1820);
                            let _e1823 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                            local = lt_bvh_traverse_Stack(array<u32, 32>(_e1823.first[0], _e1823.first[1], _e1823.first[2], _e1823.first[3], _e1823.first[4], _e1823.first[5], _e1823.first[6], _e1823.first[7], _e1823.first[8], _e1823.first[9], _e1823.first[10], _e1823.first[11], _e1823.first[12], _e1823.first[13], _e1823.first[14], _e1823.first[15], _e1823.first[16], _e1823.first[17], _e1823.first[18], _e1823.first[19], _e1823.first[20], _e1823.first[21], _e1823.first[22], _e1823.first[23], _e1823.first[24], _e1823.first[25], _e1823.first[26], _e1823.first[27], _e1823.first[28], _e1823.first[29], _e1823.first[30], _e1823.first[31]), array<u32, 32>(_e1823.mask[0], _e1823.mask[1], _e1823.mask[2], _e1823.mask[3], _e1823.mask[4], _e1823.mask[5], _e1823.mask[6], _e1823.mask[7], _e1823.mask[8], _e1823.mask[9], _e1823.mask[10], _e1823.mask[11], _e1823.mask[12], _e1823.mask[13], _e1823.mask[14], _e1823.mask[15], _e1823.mask[16], _e1823.mask[17], _e1823.mask[18], _e1823.mask[19], _e1823.mask[20], _e1823.mask[21], _e1823.mask[22], _e1823.mask[23], _e1823.mask[24], _e1823.mask[25], _e1823.mask[26], _e1823.mask[27], _e1823.mask[28], _e1823.mask[29], _e1823.mask[30], _e1823.mask[31]), _e1823.len, _e1823.group, _e1823.group_mask);
                            let _e1897 = local.group_mask;
                            if ((_e1897 & 4278190080u) == 0u) {
                                let _e1901 = local.len;
                                if (_e1901 == 0u) {
                                    phi_2398_ = false;
                                } else {
                                    let _e1905 = local.len;
                                    local.len = (_e1905 - 1u);
                                    let _e1908 = local.len;
                                    if (_e1908 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1913 = local.first[(0u + _e1908)];
                                    local.group = _e1913;
                                    let _e1916 = local.len;
                                    if (_e1916 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1921 = local.mask[(0u + _e1916)];
                                    local.group_mask = _e1921;
                                    phi_2398_ = true;
                                }
                                let _e1924 = phi_2398_;
                                phi_2399_ = _e1924;
                            } else {
                                phi_2399_ = true;
                            }
                            let _e1926 = phi_2399_;
                            if _e1926 {
                                let _e1928 = local.group_mask;
                                let _e1934 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1928)), 32u, (_e1928 == 0u)));
                                let _e1938 = local.group_mask;
                                let _e1952 = local.group_mask;
                                local.group_mask = (_e1952 & ~((1u << bitcast<u32>((_e1934 & 31u)))));
                                let _e1955 = local.group;
                                phi_2430_ = (_e1955 + countOneBits(((_e1938 & ~((4294967295u << bitcast<u32>((((_e1934 - 24u) ^ 7u) & 31u))))) & 255u)));
                            } else {
                                phi_2430_ = 4294967295u;
                            }
                            let _e1958 = phi_2430_;
                            phi_2432_ = _e1958;
                            phi_2435_ = false;
                            loop {
                                let _e1960 = phi_2432_;
                                let _e1962 = phi_2435_;
                                local_22 = _e1962;
                                if (_e1960 != 4294967295u) {
                                    if (_e1960 < _e75) {
                                    } else {
                                        return;
                                    }
                                    let _e1969 = nodes.member[(0u + _e1960)].frame[3u];
                                    let _e1994 = (bitcast<f32>((((_e1969 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1720);
                                    let _e1995 = (bitcast<f32>((((_e1969 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1730);
                                    let _e1996 = (bitcast<f32>((((_e1969 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1740);
                                    let _e1999 = nodes.member[(0u + _e1960)].frame[0u];
                                    let _e2003 = nodes.member[(0u + _e1960)].frame[1u];
                                    let _e2007 = nodes.member[(0u + _e1960)].frame[2u];
                                    let _e2012 = ((bitcast<f32>(_e1999) - _e252) * _e1720);
                                    let _e2013 = ((bitcast<f32>(_e2003) - _e254) * _e1730);
                                    let _e2014 = ((bitcast<f32>(_e2007) - _e256) * _e1740);
                                    let _e2022 = nodes.member[(0u + _e1960)].x;
                                    if (_e1720 < 0f) {
                                        let _e2033 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2022.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2039 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2033.unnamed.word, _e2022.w), _e2033.unnamed_1);
                                        let _e2045 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2039.unnamed, lt_mask_LightPlace(_e2022.x, _e2039.unnamed_1.shift));
                                        phi_2515_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2045.unnamed, lt_mask_LightPlace(_e2045.unnamed_1.word, _e2022.y));
                                    } else {
                                        let _e2061 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2022.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2067 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2061.unnamed.word, _e2022.y), _e2061.unnamed_1);
                                        let _e2073 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2067.unnamed, lt_mask_LightPlace(_e2022.z, _e2067.unnamed_1.shift));
                                        phi_2515_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2073.unnamed, lt_mask_LightPlace(_e2073.unnamed_1.word, _e2022.w));
                                    }
                                    let _e2081 = phi_2515_;
                                    let _e2091 = nodes.member[(0u + _e1960)].y;
                                    if (_e1730 < 0f) {
                                        let _e2102 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2091.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2108 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2102.unnamed.word, _e2091.w), _e2102.unnamed_1);
                                        let _e2114 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2108.unnamed, lt_mask_LightPlace(_e2091.x, _e2108.unnamed_1.shift));
                                        phi_2542_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2114.unnamed, lt_mask_LightPlace(_e2114.unnamed_1.word, _e2091.y));
                                    } else {
                                        let _e2130 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2091.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2136 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2130.unnamed.word, _e2091.y), _e2130.unnamed_1);
                                        let _e2142 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2136.unnamed, lt_mask_LightPlace(_e2091.z, _e2136.unnamed_1.shift));
                                        phi_2542_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2142.unnamed, lt_mask_LightPlace(_e2142.unnamed_1.word, _e2091.w));
                                    }
                                    let _e2150 = phi_2542_;
                                    let _e2160 = nodes.member[(0u + _e1960)].z;
                                    if (_e1740 < 0f) {
                                        let _e2171 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2160.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2177 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2171.unnamed.word, _e2160.w), _e2171.unnamed_1);
                                        let _e2183 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2177.unnamed, lt_mask_LightPlace(_e2160.x, _e2177.unnamed_1.shift));
                                        phi_2569_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2183.unnamed, lt_mask_LightPlace(_e2183.unnamed_1.word, _e2160.y));
                                    } else {
                                        let _e2199 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2160.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2205 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2199.unnamed.word, _e2160.y), _e2199.unnamed_1);
                                        let _e2211 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2205.unnamed, lt_mask_LightPlace(_e2160.z, _e2205.unnamed_1.shift));
                                        phi_2569_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2211.unnamed, lt_mask_LightPlace(_e2211.unnamed_1.word, _e2160.w));
                                    }
                                    let _e2219 = phi_2569_;
                                    phi_2575_ = 0u;
                                    phi_2578_ = 0u;
                                    loop {
                                        let _e2229 = phi_2575_;
                                        let _e2231 = phi_2578_;
                                        local_7 = _e2231;
                                        local_8 = _e2231;
                                        local_9 = _e2231;
                                        let _e2232 = (_e2229 < 8u);
                                        if _e2232 {
                                            let _e2234 = (_e2229 >> bitcast<u32>(2i));
                                            let _e2235 = (_e2229 & 3u);
                                            if (_e2234 == 0u) {
                                                phi_2592_ = _e2081.unnamed.word;
                                            } else {
                                                phi_2592_ = _e2081.unnamed.shift;
                                            }
                                            let _e2238 = phi_2592_;
                                            if (_e2234 == 0u) {
                                                phi_2602_ = _e2150.unnamed.word;
                                            } else {
                                                phi_2602_ = _e2150.unnamed.shift;
                                            }
                                            let _e2247 = phi_2602_;
                                            if (_e2234 == 0u) {
                                                phi_2612_ = _e2219.unnamed.word;
                                            } else {
                                                phi_2612_ = _e2219.unnamed.shift;
                                            }
                                            let _e2256 = phi_2612_;
                                            let _e2269 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2238 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u)) * _e1994) + (_e2012 - _e1772)), ((f32(((_e2247 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u)) * _e1995) + (_e2013 - _e1773)));
                                            let _e2270 = core_intrinsics_maximum_number_nsz_f32_(_e2269, ((f32(((_e2256 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u)) * _e1996) + (_e2014 - _e1774)));
                                            if (_e2234 == 0u) {
                                                phi_2630_ = _e2081.unnamed_1.word;
                                            } else {
                                                phi_2630_ = _e2081.unnamed_1.shift;
                                            }
                                            let _e2273 = phi_2630_;
                                            if (_e2234 == 0u) {
                                                phi_2640_ = _e2150.unnamed_1.word;
                                            } else {
                                                phi_2640_ = _e2150.unnamed_1.shift;
                                            }
                                            let _e2282 = phi_2640_;
                                            if (_e2234 == 0u) {
                                                phi_2650_ = _e2219.unnamed_1.word;
                                            } else {
                                                phi_2650_ = _e2219.unnamed_1.shift;
                                            }
                                            let _e2291 = phi_2650_;
                                            let _e2304 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2273 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u)) * _e1994) + (_e2012 + _e1772)), ((f32(((_e2282 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u)) * _e1995) + (_e2013 + _e1773)));
                                            let _e2305 = core_intrinsics_minimum_number_nsz_f32_(_e2304, ((f32(((_e2291 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u)) * _e1996) + (_e2014 + _e1774)));
                                            if (_e2270 <= _e2305) {
                                                if (_e2270 <= _e264) {
                                                    if (_e2305 >= 0f) {
                                                        if (_e2234 == 0u) {
                                                            let _e2312 = nodes.member[(0u + _e1960)].links[2u];
                                                            phi_2686_ = _e2312;
                                                        } else {
                                                            let _e2315 = nodes.member[(0u + _e1960)].links[3u];
                                                            phi_2686_ = _e2315;
                                                        }
                                                        let _e2317 = phi_2686_;
                                                        let _e2322 = ((_e2317 >> bitcast<u32>(((_e2235 * 8u) & 31u))) & 255u);
                                                        let _e2323 = (_e2322 & 31u);
                                                        if (_e2323 >= 24u) {
                                                            phi_2699_ = (24u + ((_e2323 - 24u) ^ _e1822));
                                                        } else {
                                                            phi_2699_ = _e2323;
                                                        }
                                                        let _e2329 = phi_2699_;
                                                        phi_2704_ = (_e2231 | ((_e2322 >> bitcast<u32>(5i)) << bitcast<u32>((_e2329 & 31u))));
                                                    } else {
                                                        phi_2704_ = _e2231;
                                                    }
                                                    let _e2337 = phi_2704_;
                                                    phi_2705_ = _e2337;
                                                } else {
                                                    phi_2705_ = _e2231;
                                                }
                                                let _e2339 = phi_2705_;
                                                phi_2706_ = _e2339;
                                            } else {
                                                phi_2706_ = _e2231;
                                            }
                                            let _e2341 = phi_2706_;
                                            phi_2576_ = (_e2229 + 1u);
                                            phi_2579_ = _e2341;
                                        } else {
                                            phi_2576_ = u32();
                                            phi_2579_ = u32();
                                        }
                                        let _e2344 = phi_2576_;
                                        let _e2346 = phi_2579_;
                                        continue;
                                        continuing {
                                            phi_2575_ = _e2344;
                                            phi_2578_ = _e2346;
                                            break if !(_e2232);
                                        }
                                    }
                                    let _e2350 = nodes.member[(0u + _e1960)].links[0u];
                                    let _e2354 = nodes.member[(0u + _e1960)].frame[3u];
                                    let _e2358 = local_7;
                                    if ((_e2358 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2362 = local.group_mask;
                                        if ((_e2362 & 4278190080u) == 0u) {
                                        } else {
                                            let _e2366 = local.len;
                                            if (_e2366 < 32u) {
                                                let _e2369 = local.group;
                                                let _e2371 = local.len;
                                                if (_e2371 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local.first[(0u + _e2371)] = _e2369;
                                                let _e2377 = local.group_mask;
                                                let _e2379 = local.len;
                                                if (_e2379 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local.mask[(0u + _e2379)] = _e2377;
                                                let _e2386 = local.len;
                                                local.len = (_e2386 + 1u);
                                            }
                                        }
                                        local.group = (0u + _e2350);
                                        let _e2390 = local_8;
                                        local.group_mask = ((_e2390 & 4278190080u) | (_e2354 >> bitcast<u32>(24i)));
                                    }
                                    let _e2395 = local_9;
                                    phi_2764_ = (_e2395 & 16777215u);
                                    phi_2767_ = _e1962;
                                    loop {
                                        let _e2398 = phi_2764_;
                                        let _e2400 = phi_2767_;
                                        local_20 = _e2400;
                                        let _e2401 = (_e2398 == 0u);
                                        local_10 = _e2401;
                                        local_21 = _e2401;
                                        if _e2401 {
                                            phi_2765_ = u32();
                                            phi_2768_ = bool();
                                            phi_3365_ = false;
                                        } else {
                                            let _e2404 = nodes.member[(0u + _e1960)].links[1u];
                                            let _e2409 = ((0u + _e2404) + select(firstTrailingBit(_e2398), 32u, (_e2398 == 0u)));
                                            if (_e2409 < _e78) {
                                            } else {
                                                return;
                                            }
                                            let _e2416 = triangles.member[(0u + _e2409)].v0_;
                                            let _e2418 = (_e2416.x - _e252);
                                            let _e2420 = (_e2416.y - _e254);
                                            let _e2422 = (_e2416.z - _e256);
                                            if (_e1795 == 0u) {
                                                phi_2812_ = vec3<f32>(_e2420, _e2422, _e2418);
                                            } else {
                                                if (_e1795 == 1u) {
                                                    phi_2811_ = vec3<f32>(_e2422, _e2418, _e2420);
                                                } else {
                                                    phi_2811_ = (_e2416 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e2430 = phi_2811_;
                                                phi_2812_ = _e2430;
                                            }
                                            let _e2432 = phi_2812_;
                                            let _e2436 = (_e2432.x - (_e1806 * _e2432.z));
                                            let _e2440 = (_e2432.y - (_e1809 * _e2432.z));
                                            let _e2442 = triangles.member[(0u + _e2409)].v1_;
                                            let _e2444 = (_e2442.x - _e252);
                                            let _e2446 = (_e2442.y - _e254);
                                            let _e2448 = (_e2442.z - _e256);
                                            if (_e1795 == 0u) {
                                                phi_2842_ = vec3<f32>(_e2446, _e2448, _e2444);
                                            } else {
                                                if (_e1795 == 1u) {
                                                    phi_2841_ = vec3<f32>(_e2448, _e2444, _e2446);
                                                } else {
                                                    phi_2841_ = (_e2442 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e2456 = phi_2841_;
                                                phi_2842_ = _e2456;
                                            }
                                            let _e2458 = phi_2842_;
                                            let _e2462 = (_e2458.x - (_e1806 * _e2458.z));
                                            let _e2466 = (_e2458.y - (_e1809 * _e2458.z));
                                            let _e2468 = triangles.member[(0u + _e2409)].v2_;
                                            let _e2470 = (_e2468.x - _e252);
                                            let _e2472 = (_e2468.y - _e254);
                                            let _e2474 = (_e2468.z - _e256);
                                            if (_e1795 == 0u) {
                                                phi_2872_ = vec3<f32>(_e2472, _e2474, _e2470);
                                            } else {
                                                if (_e1795 == 1u) {
                                                    phi_2871_ = vec3<f32>(_e2474, _e2470, _e2472);
                                                } else {
                                                    phi_2871_ = (_e2468 - vec3<f32>(_e252, _e254, _e256));
                                                }
                                                let _e2482 = phi_2871_;
                                                phi_2872_ = _e2482;
                                            }
                                            let _e2484 = phi_2872_;
                                            let _e2488 = (_e2484.x - (_e1806 * _e2484.z));
                                            let _e2492 = (_e2484.y - (_e1809 * _e2484.z));
                                            if (_e2462 < _e2488) {
                                                phi_2891_ = true;
                                            } else {
                                                if (_e2462 == _e2488) {
                                                    phi_2890_ = (_e2466 < _e2492);
                                                } else {
                                                    phi_2890_ = false;
                                                }
                                                let _e2497 = phi_2890_;
                                                phi_2891_ = _e2497;
                                            }
                                            let _e2499 = phi_2891_;
                                            if _e2499 {
                                                phi_2895_ = _e2492;
                                                phi_2896_ = _e2488;
                                                phi_2897_ = _e2466;
                                                phi_2898_ = _e2462;
                                            } else {
                                                phi_2895_ = _e2466;
                                                phi_2896_ = _e2462;
                                                phi_2897_ = _e2492;
                                                phi_2898_ = _e2488;
                                            }
                                            let _e2501 = phi_2895_;
                                            let _e2503 = phi_2896_;
                                            let _e2505 = phi_2897_;
                                            let _e2507 = phi_2898_;
                                            let _e2510 = ((_e2507 * _e2501) - (_e2505 * _e2503));
                                            if _e2499 {
                                                phi_2906_ = -(_e2510);
                                            } else {
                                                phi_2906_ = _e2510;
                                            }
                                            let _e2513 = phi_2906_;
                                            if (_e2488 < _e2436) {
                                                phi_2917_ = true;
                                            } else {
                                                if (_e2488 == _e2436) {
                                                    phi_2916_ = (_e2492 < _e2440);
                                                } else {
                                                    phi_2916_ = false;
                                                }
                                                let _e2518 = phi_2916_;
                                                phi_2917_ = _e2518;
                                            }
                                            let _e2520 = phi_2917_;
                                            if _e2520 {
                                                phi_2921_ = _e2440;
                                                phi_2922_ = _e2436;
                                                phi_2923_ = _e2492;
                                                phi_2924_ = _e2488;
                                            } else {
                                                phi_2921_ = _e2492;
                                                phi_2922_ = _e2488;
                                                phi_2923_ = _e2440;
                                                phi_2924_ = _e2436;
                                            }
                                            let _e2522 = phi_2921_;
                                            let _e2524 = phi_2922_;
                                            let _e2526 = phi_2923_;
                                            let _e2528 = phi_2924_;
                                            let _e2531 = ((_e2528 * _e2522) - (_e2526 * _e2524));
                                            if _e2520 {
                                                phi_2932_ = -(_e2531);
                                            } else {
                                                phi_2932_ = _e2531;
                                            }
                                            let _e2534 = phi_2932_;
                                            if (_e2436 < _e2462) {
                                                phi_2943_ = true;
                                            } else {
                                                if (_e2436 == _e2462) {
                                                    phi_2942_ = (_e2440 < _e2466);
                                                } else {
                                                    phi_2942_ = false;
                                                }
                                                let _e2539 = phi_2942_;
                                                phi_2943_ = _e2539;
                                            }
                                            let _e2541 = phi_2943_;
                                            if _e2541 {
                                                phi_2947_ = _e2466;
                                                phi_2948_ = _e2462;
                                                phi_2949_ = _e2440;
                                                phi_2950_ = _e2436;
                                            } else {
                                                phi_2947_ = _e2440;
                                                phi_2948_ = _e2436;
                                                phi_2949_ = _e2466;
                                                phi_2950_ = _e2462;
                                            }
                                            let _e2543 = phi_2947_;
                                            let _e2545 = phi_2948_;
                                            let _e2547 = phi_2949_;
                                            let _e2549 = phi_2950_;
                                            let _e2552 = ((_e2549 * _e2543) - (_e2547 * _e2545));
                                            if _e2541 {
                                                phi_2958_ = -(_e2552);
                                            } else {
                                                phi_2958_ = _e2552;
                                            }
                                            let _e2555 = phi_2958_;
                                            if (_e2513 >= 0f) {
                                                if (_e2534 >= 0f) {
                                                    if (_e2555 >= 0f) {
                                                        phi_2973_ = ((_e2513 + _e2534) + _e2555);
                                                        phi_2974_ = false;
                                                    } else {
                                                        phi_2973_ = f32();
                                                        phi_2974_ = true;
                                                    }
                                                    let _e2562 = phi_2973_;
                                                    let _e2564 = phi_2974_;
                                                    phi_2975_ = _e2562;
                                                    phi_2976_ = _e2564;
                                                } else {
                                                    phi_2975_ = f32();
                                                    phi_2976_ = true;
                                                }
                                                let _e2566 = phi_2975_;
                                                let _e2568 = phi_2976_;
                                                phi_2977_ = _e2566;
                                                phi_2978_ = _e2568;
                                            } else {
                                                phi_2977_ = f32();
                                                phi_2978_ = true;
                                            }
                                            let _e2570 = phi_2977_;
                                            let _e2572 = phi_2978_;
                                            if _e2572 {
                                                if (_e2513 <= 0f) {
                                                    if (_e2534 <= 0f) {
                                                        let _e2575 = (_e2555 <= 0f);
                                                        if _e2575 {
                                                        }
                                                        phi_2996_ = ((_e2513 + _e2534) + _e2555);
                                                        phi_2997_ = false;
                                                        phi_2998_ = _e2575;
                                                    } else {
                                                        phi_2996_ = f32();
                                                        phi_2997_ = true;
                                                        phi_2998_ = false;
                                                    }
                                                    let _e2579 = phi_2996_;
                                                    let _e2581 = phi_2997_;
                                                    let _e2583 = phi_2998_;
                                                    phi_2999_ = _e2579;
                                                    phi_3000_ = _e2581;
                                                    phi_3001_ = _e2583;
                                                } else {
                                                    phi_2999_ = f32();
                                                    phi_3000_ = true;
                                                    phi_3001_ = false;
                                                }
                                                let _e2585 = phi_2999_;
                                                let _e2587 = phi_3000_;
                                                let _e2589 = phi_3001_;
                                                if _e2587 {
                                                    phi_3005_ = false;
                                                } else {
                                                    phi_3005_ = _e2589;
                                                }
                                                let _e2591 = phi_3005_;
                                                phi_3006_ = _e2585;
                                                phi_3007_ = _e2591;
                                            } else {
                                                phi_3006_ = _e2570;
                                                phi_3007_ = true;
                                            }
                                            let _e2593 = phi_3006_;
                                            let _e2595 = phi_3007_;
                                            if _e2595 {
                                                let _e2596 = (_e2593 == 0f);
                                                if _e2596 {
                                                    phi_3323_ = lt_bvh_triangle_Intersection();
                                                    phi_3324_ = false;
                                                } else {
                                                    let _e2598 = triangles.member[(0u + _e2409)].v0_;
                                                    let _e2600 = (_e2598.x - _e252);
                                                    let _e2602 = (_e2598.y - _e254);
                                                    let _e2604 = (_e2598.z - _e256);
                                                    if (_e1795 == 0u) {
                                                        phi_3036_ = vec3<f32>(_e2602, _e2604, _e2600);
                                                    } else {
                                                        if (_e1795 == 1u) {
                                                            phi_3035_ = vec3<f32>(_e2604, _e2600, _e2602);
                                                        } else {
                                                            phi_3035_ = (_e2598 - vec3<f32>(_e252, _e254, _e256));
                                                        }
                                                        let _e2612 = phi_3035_;
                                                        phi_3036_ = _e2612;
                                                    }
                                                    let _e2614 = phi_3036_;
                                                    let _e2616 = triangles.member[(0u + _e2409)].v1_;
                                                    let _e2618 = triangles.member[(0u + _e2409)].v0_;
                                                    let _e2621 = (_e2616.x - _e2618.x);
                                                    let _e2624 = (_e2616.y - _e2618.y);
                                                    let _e2627 = (_e2616.z - _e2618.z);
                                                    if (_e1795 == 0u) {
                                                        phi_3062_ = vec3<f32>(_e2624, _e2627, _e2621);
                                                    } else {
                                                        if (_e1795 == 1u) {
                                                            phi_3061_ = vec3<f32>(_e2627, _e2621, _e2624);
                                                        } else {
                                                            phi_3061_ = (_e2616 - _e2618);
                                                        }
                                                        let _e2634 = phi_3061_;
                                                        phi_3062_ = _e2634;
                                                    }
                                                    let _e2636 = phi_3062_;
                                                    let _e2638 = triangles.member[(0u + _e2409)].v2_;
                                                    let _e2640 = triangles.member[(0u + _e2409)].v0_;
                                                    let _e2643 = (_e2638.x - _e2640.x);
                                                    let _e2646 = (_e2638.y - _e2640.y);
                                                    let _e2649 = (_e2638.z - _e2640.z);
                                                    if (_e1795 == 0u) {
                                                        phi_3088_ = vec3<f32>(_e2646, _e2649, _e2643);
                                                    } else {
                                                        if (_e1795 == 1u) {
                                                            phi_3087_ = vec3<f32>(_e2649, _e2643, _e2646);
                                                        } else {
                                                            phi_3087_ = (_e2638 - _e2640);
                                                        }
                                                        let _e2656 = phi_3087_;
                                                        phi_3088_ = _e2656;
                                                    }
                                                    let _e2658 = phi_3088_;
                                                    let _e2665 = ((_e2636.y * _e2658.z) - (_e2636.z * _e2658.y));
                                                    let _e2672 = ((_e2636.z * _e2658.x) - (_e2636.x * _e2658.z));
                                                    let _e2679 = ((_e2636.x * _e2658.y) - (_e2636.y * _e2658.x));
                                                    let _e2693 = (((1f / _e1803.z) * (((_e2665 * _e2614.x) + (_e2672 * _e2614.y)) + (_e2679 * _e2614.z))) / (((_e2665 * _e1806) + (_e2672 * _e1809)) + _e2679));
                                                    if (_e2693 > 0f) {
                                                        if (_e2693 < _e264) {
                                                            let _e2697 = triangles.member[(0u + _e2409)].v0_;
                                                            let _e2699 = triangles.member[(0u + _e2409)].v1_;
                                                            if (_e2697.x < _e2699.x) {
                                                                phi_3144_ = _e2697.x;
                                                            } else {
                                                                phi_3144_ = _e2699.x;
                                                            }
                                                            let _e2706 = phi_3144_;
                                                            if (_e2697.y < _e2699.y) {
                                                                phi_3153_ = _e2697.y;
                                                            } else {
                                                                phi_3153_ = _e2699.y;
                                                            }
                                                            let _e2713 = phi_3153_;
                                                            if (_e2697.z < _e2699.z) {
                                                                phi_3162_ = _e2697.z;
                                                            } else {
                                                                phi_3162_ = _e2699.z;
                                                            }
                                                            let _e2720 = phi_3162_;
                                                            let _e2722 = triangles.member[(0u + _e2409)].v2_;
                                                            if (_e2706 < _e2722.x) {
                                                                phi_3171_ = _e2706;
                                                            } else {
                                                                phi_3171_ = _e2722.x;
                                                            }
                                                            let _e2727 = phi_3171_;
                                                            if (_e2713 < _e2722.y) {
                                                                phi_3178_ = _e2713;
                                                            } else {
                                                                phi_3178_ = _e2722.y;
                                                            }
                                                            let _e2732 = phi_3178_;
                                                            if (_e2720 < _e2722.z) {
                                                                phi_3185_ = _e2720;
                                                            } else {
                                                                phi_3185_ = _e2722.z;
                                                            }
                                                            let _e2737 = phi_3185_;
                                                            let _e2739 = triangles.member[(0u + _e2409)].v0_;
                                                            let _e2741 = triangles.member[(0u + _e2409)].v1_;
                                                            if (_e2739.x > _e2741.x) {
                                                                phi_3198_ = _e2739.x;
                                                            } else {
                                                                phi_3198_ = _e2741.x;
                                                            }
                                                            let _e2748 = phi_3198_;
                                                            if (_e2739.y > _e2741.y) {
                                                                phi_3207_ = _e2739.y;
                                                            } else {
                                                                phi_3207_ = _e2741.y;
                                                            }
                                                            let _e2755 = phi_3207_;
                                                            if (_e2739.z > _e2741.z) {
                                                                phi_3216_ = _e2739.z;
                                                            } else {
                                                                phi_3216_ = _e2741.z;
                                                            }
                                                            let _e2762 = phi_3216_;
                                                            let _e2764 = triangles.member[(0u + _e2409)].v2_;
                                                            if (_e2748 > _e2764.x) {
                                                                phi_3225_ = _e2748;
                                                            } else {
                                                                phi_3225_ = _e2764.x;
                                                            }
                                                            let _e2769 = phi_3225_;
                                                            if (_e2755 > _e2764.y) {
                                                                phi_3232_ = _e2755;
                                                            } else {
                                                                phi_3232_ = _e2764.y;
                                                            }
                                                            let _e2774 = phi_3232_;
                                                            if (_e2762 > _e2764.z) {
                                                                phi_3239_ = _e2762;
                                                            } else {
                                                                phi_3239_ = _e2764.z;
                                                            }
                                                            let _e2779 = phi_3239_;
                                                            let _e2783 = ((_e2727 - _e252) * _e1720);
                                                            let _e2784 = ((_e2732 - _e254) * _e1730);
                                                            let _e2785 = ((_e2737 - _e256) * _e1740);
                                                            let _e2789 = ((_e2769 - _e252) * _e1720);
                                                            let _e2790 = ((_e2774 - _e254) * _e1730);
                                                            let _e2791 = ((_e2779 - _e256) * _e1740);
                                                            if (_e2783 < _e2789) {
                                                                phi_3256_ = _e2783;
                                                            } else {
                                                                phi_3256_ = _e2789;
                                                            }
                                                            let _e2794 = phi_3256_;
                                                            if (_e2784 < _e2790) {
                                                                phi_3261_ = _e2784;
                                                            } else {
                                                                phi_3261_ = _e2790;
                                                            }
                                                            let _e2797 = phi_3261_;
                                                            if (_e2785 < _e2791) {
                                                                phi_3266_ = _e2785;
                                                            } else {
                                                                phi_3266_ = _e2791;
                                                            }
                                                            let _e2800 = phi_3266_;
                                                            if (_e2783 > _e2789) {
                                                                phi_3274_ = _e2783;
                                                            } else {
                                                                phi_3274_ = _e2789;
                                                            }
                                                            let _e2806 = phi_3274_;
                                                            if (_e2784 > _e2790) {
                                                                phi_3279_ = _e2784;
                                                            } else {
                                                                phi_3279_ = _e2790;
                                                            }
                                                            let _e2809 = phi_3279_;
                                                            if (_e2785 > _e2791) {
                                                                phi_3284_ = _e2785;
                                                            } else {
                                                                phi_3284_ = _e2791;
                                                            }
                                                            let _e2812 = phi_3284_;
                                                            let _e2816 = core_intrinsics_maximum_number_nsz_f32_((_e2794 - _e1779), (_e2797 - _e1780));
                                                            let _e2817 = core_intrinsics_maximum_number_nsz_f32_(_e2816, (_e2800 - _e1781));
                                                            let _e2818 = core_intrinsics_minimum_number_nsz_f32_((_e2806 + _e1779), (_e2809 + _e1780));
                                                            let _e2819 = core_intrinsics_minimum_number_nsz_f32_(_e2818, (_e2812 + _e1781));
                                                            if (_e2817 > -300000000000000000000000000000000000000f) {
                                                                phi_3296_ = _e2817;
                                                            } else {
                                                                phi_3296_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e2822 = phi_3296_;
                                                            if (_e2819 < 300000000000000000000000000000000000000f) {
                                                                phi_3301_ = _e2819;
                                                            } else {
                                                                phi_3301_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e2825 = phi_3301_;
                                                            if (_e2693 < _e2822) {
                                                                phi_3306_ = _e2822;
                                                            } else {
                                                                phi_3306_ = _e2693;
                                                            }
                                                            let _e2828 = phi_3306_;
                                                            if (_e2828 > _e2825) {
                                                                phi_3311_ = _e2825;
                                                            } else {
                                                                phi_3311_ = _e2828;
                                                            }
                                                            let _e2831 = phi_3311_;
                                                            phi_3316_ = lt_bvh_triangle_Intersection(_e2831, (_e2534 / _e2593), (_e2555 / _e2593), (_e2822 <= _e2825));
                                                            phi_3317_ = false;
                                                        } else {
                                                            phi_3316_ = lt_bvh_triangle_Intersection();
                                                            phi_3317_ = true;
                                                        }
                                                        let _e2837 = phi_3316_;
                                                        let _e2839 = phi_3317_;
                                                        phi_3318_ = _e2837;
                                                        phi_3319_ = _e2839;
                                                    } else {
                                                        phi_3318_ = lt_bvh_triangle_Intersection();
                                                        phi_3319_ = true;
                                                    }
                                                    let _e2841 = phi_3318_;
                                                    let _e2843 = phi_3319_;
                                                    if _e2843 {
                                                    }
                                                    phi_3323_ = _e2841;
                                                    phi_3324_ = _e2843;
                                                }
                                                let _e2845 = phi_3323_;
                                                let _e2847 = phi_3324_;
                                                phi_3325_ = _e2845;
                                                phi_3326_ = _e2596;
                                                phi_3327_ = _e2847;
                                            } else {
                                                phi_3325_ = lt_bvh_triangle_Intersection();
                                                phi_3326_ = true;
                                                phi_3327_ = false;
                                            }
                                            let _e2849 = phi_3325_;
                                            let _e2851 = phi_3326_;
                                            let _e2853 = phi_3327_;
                                            if _e2851 {
                                                phi_3331_ = true;
                                            } else {
                                                phi_3331_ = _e2853;
                                            }
                                            let _e2855 = phi_3331_;
                                            if _e2855 {
                                                phi_3335_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_3335_ = _e2849;
                                            }
                                            let _e2857 = phi_3335_;
                                            if _e2857.is_hit {
                                                if (_e2857.t > 0f) {
                                                    if (_e2857.t < _e264) {
                                                        if true {
                                                            phi_3355_ = false;
                                                        } else {
                                                            phi_3355_ = true;
                                                        }
                                                        let _e2866 = phi_3355_;
                                                        phi_3356_ = true;
                                                        phi_3357_ = _e2866;
                                                    } else {
                                                        phi_3356_ = _e2400;
                                                        phi_3357_ = true;
                                                    }
                                                    let _e2868 = phi_3356_;
                                                    let _e2870 = phi_3357_;
                                                    phi_3358_ = _e2868;
                                                    phi_3359_ = _e2870;
                                                } else {
                                                    phi_3358_ = _e2400;
                                                    phi_3359_ = true;
                                                }
                                                let _e2872 = phi_3358_;
                                                let _e2874 = phi_3359_;
                                                phi_3360_ = _e2872;
                                                phi_3361_ = _e2874;
                                            } else {
                                                phi_3360_ = _e2400;
                                                phi_3361_ = true;
                                            }
                                            let _e2876 = phi_3360_;
                                            let _e2878 = phi_3361_;
                                            if _e2878 {
                                            }
                                            phi_2765_ = (_e2398 & (_e2398 - 1u));
                                            phi_2768_ = _e2876;
                                            phi_3365_ = _e2878;
                                        }
                                        let _e2880 = phi_2765_;
                                        let _e2882 = phi_2768_;
                                        let _e2884 = phi_3365_;
                                        continue;
                                        continuing {
                                            phi_2764_ = _e2880;
                                            phi_2767_ = _e2882;
                                            break if !(_e2884);
                                        }
                                    }
                                    let _e2887 = local_10;
                                    if _e2887 {
                                        let _e2889 = local.group_mask;
                                        if ((_e2889 & 4278190080u) == 0u) {
                                            let _e2893 = local.len;
                                            if (_e2893 == 0u) {
                                                phi_3407_ = false;
                                            } else {
                                                let _e2897 = local.len;
                                                local.len = (_e2897 - 1u);
                                                let _e2900 = local.len;
                                                if (_e2900 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2905 = local.first[(0u + _e2900)];
                                                local.group = _e2905;
                                                let _e2908 = local.len;
                                                if (_e2908 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2913 = local.mask[(0u + _e2908)];
                                                local.group_mask = _e2913;
                                                phi_3407_ = true;
                                            }
                                            let _e2916 = phi_3407_;
                                            phi_3408_ = _e2916;
                                        } else {
                                            phi_3408_ = true;
                                        }
                                        let _e2918 = phi_3408_;
                                        if _e2918 {
                                            let _e2920 = local.group_mask;
                                            let _e2926 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2920)), 32u, (_e2920 == 0u)));
                                            let _e2930 = local.group_mask;
                                            let _e2944 = local.group_mask;
                                            local.group_mask = (_e2944 & ~((1u << bitcast<u32>((_e2926 & 31u)))));
                                            let _e2947 = local.group;
                                            phi_3439_ = (_e2947 + countOneBits(((_e2930 & ~((4294967295u << bitcast<u32>((((_e2926 - 24u) ^ _e1822) & 31u))))) & 255u)));
                                        } else {
                                            phi_3439_ = 4294967295u;
                                        }
                                        let _e2950 = phi_3439_;
                                        phi_3440_ = _e2950;
                                    } else {
                                        phi_3440_ = u32();
                                    }
                                    let _e2952 = phi_3440_;
                                    phi_2433_ = _e2952;
                                    let _e3412 = local_20;
                                    phi_2436_ = _e3412;
                                    let _e3415 = local_21;
                                    phi_3441_ = _e3415;
                                    phi_3442_ = false;
                                } else {
                                    phi_2433_ = u32();
                                    phi_2436_ = bool();
                                    phi_3441_ = false;
                                    phi_3442_ = true;
                                }
                                let _e2954 = phi_2433_;
                                let _e2956 = phi_2436_;
                                let _e2958 = phi_3441_;
                                let _e2960 = phi_3442_;
                                local_11 = _e2960;
                                continue;
                                continuing {
                                    phi_2432_ = _e2954;
                                    phi_2435_ = _e2956;
                                    break if !(_e2958);
                                }
                            }
                            let _e2963 = local_11;
                            if _e2963 {
                                phi_3446_ = false;
                            } else {
                                phi_3446_ = true;
                            }
                            let _e2965 = phi_3446_;
                            if _e2965 {
                                phi_3450_ = true;
                            } else {
                                let _e3421 = local_22;
                                phi_3450_ = _e3421;
                            }
                            let _e2967 = phi_3450_;
                            phi_3451_ = _e2967;
                        }
                        let _e2969 = phi_3451_;
                        phi_3452_ = _e2969;
                        phi_3453_ = _e1644;
                    } else {
                        phi_3452_ = bool();
                        phi_3453_ = true;
                    }
                    let _e2971 = phi_3452_;
                    let _e2973 = phi_3453_;
                    if _e2973 {
                        phi_3457_ = false;
                    } else {
                        phi_3457_ = _e2971;
                    }
                    let _e2975 = phi_3457_;
                    phi_3458_ = _e2975;
                }
                let _e2977 = phi_3458_;
                phi_3459_ = _e2977;
            } else {
                phi_3459_ = false;
            }
            let _e2979 = phi_3459_;
            if _e2979 {
                phi_3463_ = 0f;
            } else {
                phi_3463_ = 1f;
            }
            let _e2981 = phi_3463_;
            phi_3464_ = _e2981;
        }
        let _e2983 = phi_3464_;
        if (_e91.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e91.shift)] = _e2983;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
