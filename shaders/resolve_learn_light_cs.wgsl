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

struct type_13 {
    member: array<vec4<u32>>,
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

struct type_24 {
    member: array<abi_Sample>,
}

struct type_28 {
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

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_41 {
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

struct type_45 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_bvh_LightSpace {
    shear: vec2<f32>,
    diagonal: vec2<f32>,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    axis: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_52 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_24;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_28;
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> nodes: type_41;
@group(0) @binding(3) 
var<storage> triangles: type_45;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;
@group(0) @binding(7) 
var<storage> rows: type_13;
@group(0) @binding(8) 
var<uniform> space: type_52;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_188_: bool;
    var phi_192_: f32;

    if (param != param) {
        phi_188_ = true;
    } else {
        let _e70 = (param_1 >= param);
        if _e70 {
        }
        phi_188_ = _e70;
    }
    let _e72 = phi_188_;
    if _e72 {
        phi_192_ = param_1;
    } else {
        phi_192_ = param;
    }
    let _e74 = phi_192_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_204_: bool;
    var phi_208_: f32;

    if (param_2 != param_2) {
        phi_204_ = true;
    } else {
        let _e70 = (param_3 <= param_2);
        if _e70 {
        }
        phi_204_ = _e70;
    }
    let _e72 = phi_204_;
    if _e72 {
        phi_208_ = param_3;
    } else {
        phi_208_ = param_2;
    }
    let _e74 = phi_208_;
    return _e74;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: array<u32, 32>;
    var phi_295_: f32;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_335_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_355_: bool;
    var phi_368_: bool;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_382_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_414_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_433_: bool;
    var phi_450_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_460_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_489_: u32;
    var phi_490_: f32;
    var phi_491_: u32;
    var phi_492_: f32;
    var phi_497_: f32;
    var phi_508_: u32;
    var phi_518_: u32;
    var phi_524_: u32;
    var phi_525_: u32;
    var phi_526_: u32;
    var phi_537_: vec3<f32>;
    var phi_538_: vec3<f32>;
    var phi_560_: vec3<f32>;
    var phi_561_: vec3<f32>;
    var phi_583_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_658_: f32;
    var phi_665_: f32;
    var phi_672_: f32;
    var phi_679_: f32;
    var phi_686_: f32;
    var phi_693_: f32;
    var phi_710_: f32;
    var phi_715_: f32;
    var phi_720_: f32;
    var phi_725_: f32;
    var phi_730_: f32;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_761_: u32;
    var phi_762_: u32;
    var phi_773_: vec3<f32>;
    var phi_774_: vec3<f32>;
    var phi_786_: u32;
    var phi_789_: u32;
    var phi_794_: u32;
    var phi_796_: u32;
    var phi_798_: u32;
    var phi_800_: u32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_887_: u32;
    var phi_910_: f32;
    var phi_911_: f32;
    var phi_925_: u32;
    var phi_947_: f32;
    var phi_948_: f32;
    var phi_962_: u32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_1000_: u32;
    var phi_1192_: u32;
    var phi_1193_: u32;
    var phi_1198_: u32;
    var phi_1199_: u32;
    var phi_1200_: u32;
    var phi_797_: u32;
    var phi_799_: u32;
    var phi_1201_: u32;
    var phi_1219_: u32;
    var phi_1220_: u32;
    var phi_787_: u32;
    var phi_790_: u32;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var local_2: bool;
    var local_3: u32;
    var phi_1240_: u32;
    var local_4: u32;
    var phi_1275_: u32;
    var phi_1276_: u32;
    var phi_1282_: u32;
    var phi_1310_: vec3<f32>;
    var phi_1311_: vec3<f32>;
    var phi_1340_: vec3<f32>;
    var phi_1341_: vec3<f32>;
    var phi_1370_: vec3<f32>;
    var phi_1371_: vec3<f32>;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1394_: f32;
    var phi_1395_: f32;
    var phi_1396_: f32;
    var phi_1397_: f32;
    var phi_1405_: f32;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1420_: f32;
    var phi_1421_: f32;
    var phi_1422_: f32;
    var phi_1423_: f32;
    var phi_1431_: f32;
    var phi_1441_: bool;
    var phi_1442_: bool;
    var phi_1446_: f32;
    var phi_1447_: f32;
    var phi_1448_: f32;
    var phi_1449_: f32;
    var phi_1457_: f32;
    var phi_1472_: f32;
    var phi_1473_: bool;
    var phi_1474_: f32;
    var phi_1475_: bool;
    var phi_1476_: f32;
    var phi_1477_: bool;
    var phi_1495_: f32;
    var phi_1496_: bool;
    var phi_1497_: bool;
    var phi_1498_: f32;
    var phi_1499_: bool;
    var phi_1500_: bool;
    var phi_1504_: bool;
    var phi_1505_: f32;
    var phi_1506_: bool;
    var phi_1534_: vec3<f32>;
    var phi_1535_: vec3<f32>;
    var phi_1560_: vec3<f32>;
    var phi_1561_: vec3<f32>;
    var phi_1586_: vec3<f32>;
    var phi_1587_: vec3<f32>;
    var phi_1643_: f32;
    var phi_1652_: f32;
    var phi_1661_: f32;
    var phi_1670_: f32;
    var phi_1677_: f32;
    var phi_1684_: f32;
    var phi_1697_: f32;
    var phi_1706_: f32;
    var phi_1715_: f32;
    var phi_1724_: f32;
    var phi_1731_: f32;
    var phi_1738_: f32;
    var phi_1755_: f32;
    var phi_1760_: f32;
    var phi_1765_: f32;
    var phi_1773_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1795_: f32;
    var phi_1800_: f32;
    var phi_1805_: f32;
    var phi_1810_: f32;
    var phi_1815_: lt_bvh_triangle_Intersection;
    var phi_1816_: bool;
    var phi_1817_: lt_bvh_triangle_Intersection;
    var phi_1818_: bool;
    var phi_1822_: lt_bvh_triangle_Intersection;
    var phi_1823_: bool;
    var phi_1824_: lt_bvh_triangle_Intersection;
    var phi_1825_: bool;
    var phi_1826_: bool;
    var phi_1830_: bool;
    var phi_1834_: lt_bvh_triangle_Intersection;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1862_: bool;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1866_: bool;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1870_: bool;
    var phi_1871_: bool;
    var phi_1872_: bool;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var phi_1878_: bool;
    var phi_1886_: bool;
    var phi_1887_: bool;
    var phi_1888_: bool;
    var phi_1889_: bool;
    var phi_1890_: bool;
    var local_5: bool;
    var phi_1894_: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var phi_1897_: bool;
    var phi_1898_: bool;
    var local_6: u32;
    var phi_1906_: bool;
    var phi_1907_: bool;
    var phi_1908_: bool;
    var phi_1909_: bool;
    var local_7: bool;
    var phi_1913_: bool;
    var phi_1917_: bool;
    var phi_1921_: bool;
    var phi_1922_: bool;
    var phi_1938_: bool;
    var phi_1939_: bool;
    var phi_1940_: bool;
    var phi_1941_: bool;
    var phi_1945_: bool;
    var phi_1958_: bool;
    var phi_1959_: bool;
    var phi_1960_: bool;
    var phi_1961_: bool;
    var phi_1965_: bool;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var phi_1980_: bool;
    var phi_1984_: bool;
    var phi_1985_: bool;
    var phi_1986_: bool;
    var phi_1987_: bool;
    var phi_1988_: bool;
    var phi_1992_: bool;
    var phi_2062_: f32;
    var phi_2069_: f32;
    var phi_2076_: f32;
    var phi_2083_: f32;
    var phi_2090_: f32;
    var phi_2097_: f32;
    var phi_2114_: f32;
    var phi_2119_: f32;
    var phi_2124_: f32;
    var phi_2129_: f32;
    var phi_2134_: f32;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2169_: u32;
    var phi_2170_: u32;
    var phi_2181_: vec3<f32>;
    var phi_2182_: vec3<f32>;
    var phi_2195_: u32;
    var phi_2200_: u32;
    var phi_2205_: u32;
    var phi_2319_: bool;
    var phi_2320_: bool;
    var phi_2351_: u32;
    var phi_2353_: u32;
    var phi_2356_: bool;
    var phi_2436_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2463_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2490_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2496_: u32;
    var phi_2499_: u32;
    var phi_2513_: u32;
    var phi_2523_: u32;
    var phi_2533_: u32;
    var phi_2551_: u32;
    var phi_2561_: u32;
    var phi_2571_: u32;
    var phi_2607_: u32;
    var phi_2620_: u32;
    var phi_2625_: u32;
    var phi_2626_: u32;
    var phi_2627_: u32;
    var phi_2497_: u32;
    var phi_2500_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_2685_: u32;
    var phi_2688_: bool;
    var phi_2732_: vec3<f32>;
    var phi_2733_: vec3<f32>;
    var phi_2762_: vec3<f32>;
    var phi_2763_: vec3<f32>;
    var phi_2792_: vec3<f32>;
    var phi_2793_: vec3<f32>;
    var phi_2811_: bool;
    var phi_2812_: bool;
    var phi_2816_: f32;
    var phi_2817_: f32;
    var phi_2818_: f32;
    var phi_2819_: f32;
    var phi_2827_: f32;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2842_: f32;
    var phi_2843_: f32;
    var phi_2844_: f32;
    var phi_2845_: f32;
    var phi_2853_: f32;
    var phi_2863_: bool;
    var phi_2864_: bool;
    var phi_2868_: f32;
    var phi_2869_: f32;
    var phi_2870_: f32;
    var phi_2871_: f32;
    var phi_2879_: f32;
    var phi_2894_: f32;
    var phi_2895_: bool;
    var phi_2896_: f32;
    var phi_2897_: bool;
    var phi_2898_: f32;
    var phi_2899_: bool;
    var phi_2917_: f32;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: f32;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2926_: bool;
    var phi_2927_: f32;
    var phi_2928_: bool;
    var phi_2956_: vec3<f32>;
    var phi_2957_: vec3<f32>;
    var phi_2982_: vec3<f32>;
    var phi_2983_: vec3<f32>;
    var phi_3008_: vec3<f32>;
    var phi_3009_: vec3<f32>;
    var phi_3065_: f32;
    var phi_3074_: f32;
    var phi_3083_: f32;
    var phi_3092_: f32;
    var phi_3099_: f32;
    var phi_3106_: f32;
    var phi_3119_: f32;
    var phi_3128_: f32;
    var phi_3137_: f32;
    var phi_3146_: f32;
    var phi_3153_: f32;
    var phi_3160_: f32;
    var phi_3177_: f32;
    var phi_3182_: f32;
    var phi_3187_: f32;
    var phi_3195_: f32;
    var phi_3200_: f32;
    var phi_3205_: f32;
    var phi_3217_: f32;
    var phi_3222_: f32;
    var phi_3227_: f32;
    var phi_3232_: f32;
    var phi_3237_: lt_bvh_triangle_Intersection;
    var phi_3238_: bool;
    var phi_3239_: lt_bvh_triangle_Intersection;
    var phi_3240_: bool;
    var phi_3244_: lt_bvh_triangle_Intersection;
    var phi_3245_: bool;
    var phi_3246_: lt_bvh_triangle_Intersection;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3252_: bool;
    var phi_3256_: lt_bvh_triangle_Intersection;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3280_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_2686_: u32;
    var phi_2689_: bool;
    var phi_3286_: bool;
    var local_11: bool;
    var phi_3328_: bool;
    var phi_3329_: bool;
    var phi_3360_: u32;
    var phi_3361_: u32;
    var phi_2354_: u32;
    var phi_2357_: bool;
    var phi_3362_: bool;
    var phi_3363_: bool;
    var local_12: bool;
    var phi_3367_: bool;
    var phi_3371_: bool;
    var phi_3372_: bool;
    var phi_3373_: bool;
    var phi_3374_: bool;
    var phi_3378_: bool;
    var phi_3379_: bool;
    var phi_3380_: bool;
    var phi_3384_: f32;
    var phi_3425_: u32;
    var phi_3444_: u32;
    var phi_3452_: u32;
    var phi_3460_: u32;
    var phi_3465_: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&visibility.member));
    let _e85 = arrayLength((&list.member));
    let _e88 = arrayLength((&bits.member));
    let _e91 = arrayLength((&rows.member));
    let _e96 = ((_e69.y * 2097152u) + _e69.x);
    if (3u < _e85) {
    } else {
        return;
    }
    let _e99 = list.member[3u];
    if (_e96 < _e99) {
        let _e101 = (_e96 + 4u);
        if (_e101 < _e85) {
        } else {
            return;
        }
        let _e105 = list.member[(0u + _e101)];
        let _e106 = space.member;
        if (_e105 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e112 = samples.member[(0u + _e105)].position;
        let _e114 = samples.member[(0u + _e105)].normal;
        let _e116 = samples.member[(0u + _e105)].magnitude;
        let _e118 = ((8f / 8388608f) * _e116);
        let _e120 = (_e114.x * _e118);
        let _e122 = (_e114.y * _e118);
        let _e124 = (_e114.z * _e118);
        let _e126 = (_e112.x + _e120);
        let _e128 = (_e112.y + _e122);
        let _e130 = (_e112.z + _e124);
        let _e134 = p.member.light.place;
        if (_e134.w == 0f) {
            phi_295_ = 300000000000000000000000000000000000000f;
        } else {
            phi_295_ = 1f;
        }
        let _e138 = phi_295_;
        let _e146 = (_e134.x - (_e126 * _e134.w));
        let _e147 = (_e134.y - (_e128 * _e134.w));
        let _e148 = (_e134.z - (_e130 * _e134.w));
        let _e149 = vec3<f32>(_e146, _e147, _e148);
        let _e150 = abs(_e146);
        let _e151 = abs(_e147);
        let _e152 = abs(_e148);
        if (abs(_e126) < 1000000000000000f) {
            if (abs(_e128) < 1000000000000000f) {
                phi_328_ = (abs(_e130) < 1000000000000000f);
                phi_329_ = false;
            } else {
                phi_328_ = bool();
                phi_329_ = true;
            }
            let _e160 = phi_328_;
            let _e162 = phi_329_;
            phi_330_ = _e160;
            phi_331_ = _e162;
        } else {
            phi_330_ = bool();
            phi_331_ = true;
        }
        let _e164 = phi_330_;
        let _e166 = phi_331_;
        if _e166 {
            phi_335_ = false;
        } else {
            phi_335_ = _e164;
        }
        let _e168 = phi_335_;
        if _e168 {
            if (_e150 < 1000000000000000f) {
                if (_e151 < 1000000000000000f) {
                    phi_348_ = (_e152 < 1000000000000000f);
                    phi_349_ = false;
                } else {
                    phi_348_ = bool();
                    phi_349_ = true;
                }
                let _e173 = phi_348_;
                let _e175 = phi_349_;
                phi_350_ = _e173;
                phi_351_ = _e175;
            } else {
                phi_350_ = bool();
                phi_351_ = true;
            }
            let _e177 = phi_350_;
            let _e179 = phi_351_;
            if _e179 {
                phi_355_ = false;
            } else {
                phi_355_ = _e177;
            }
            let _e181 = phi_355_;
            if _e181 {
                if (_e150 > 0f) {
                    phi_369_ = bool();
                    phi_370_ = true;
                } else {
                    let _e183 = (_e151 > 0f);
                    if _e183 {
                        phi_368_ = bool();
                    } else {
                        phi_368_ = (_e152 > 0f);
                    }
                    let _e186 = phi_368_;
                    phi_369_ = _e186;
                    phi_370_ = _e183;
                }
                let _e188 = phi_369_;
                let _e190 = phi_370_;
                if _e190 {
                    phi_374_ = true;
                } else {
                    phi_374_ = _e188;
                }
                let _e192 = phi_374_;
                phi_375_ = _e192;
                phi_376_ = false;
            } else {
                phi_375_ = bool();
                phi_376_ = true;
            }
            let _e194 = phi_375_;
            let _e196 = phi_376_;
            phi_377_ = _e194;
            phi_378_ = _e196;
        } else {
            phi_377_ = bool();
            phi_378_ = true;
        }
        let _e198 = phi_377_;
        let _e200 = phi_378_;
        if _e200 {
            phi_382_ = false;
        } else {
            phi_382_ = _e198;
        }
        let _e202 = phi_382_;
        if _e202 {
            if (_e106.low.x <= _e126) {
                if (_e126 <= _e106.high.x) {
                    if (_e106.low.y <= _e128) {
                        phi_405_ = (_e128 <= _e106.high.y);
                        phi_406_ = false;
                    } else {
                        phi_405_ = bool();
                        phi_406_ = true;
                    }
                    let _e220 = phi_405_;
                    let _e222 = phi_406_;
                    phi_407_ = _e220;
                    phi_408_ = _e222;
                } else {
                    phi_407_ = bool();
                    phi_408_ = true;
                }
                let _e224 = phi_407_;
                let _e226 = phi_408_;
                phi_409_ = _e224;
                phi_410_ = _e226;
            } else {
                phi_409_ = bool();
                phi_410_ = true;
            }
            let _e228 = phi_409_;
            let _e230 = phi_410_;
            if _e230 {
                phi_414_ = false;
            } else {
                phi_414_ = _e228;
            }
            let _e232 = phi_414_;
            if (abs(_e146) > 0.000000000000000000000000000001f) {
                phi_428_ = bool();
                phi_429_ = true;
            } else {
                let _e237 = (abs(_e147) > 0.000000000000000000000000000001f);
                if _e237 {
                    phi_427_ = bool();
                } else {
                    phi_427_ = (abs(_e148) > 0.000000000000000000000000000001f);
                }
                let _e240 = phi_427_;
                phi_428_ = _e240;
                phi_429_ = _e237;
            }
            let _e242 = phi_428_;
            let _e244 = phi_429_;
            if _e244 {
                phi_433_ = true;
            } else {
                phi_433_ = _e242;
            }
            let _e246 = phi_433_;
            if _e232 {
                if (_e106.low.z <= _e130) {
                    if (_e130 <= _e106.high.z) {
                        if (_e106.is_parallel == 0u) {
                            phi_450_ = _e246;
                        } else {
                            phi_450_ = true;
                        }
                        let _e252 = phi_450_;
                        phi_451_ = _e252;
                        phi_452_ = false;
                    } else {
                        phi_451_ = bool();
                        phi_452_ = true;
                    }
                    let _e254 = phi_451_;
                    let _e256 = phi_452_;
                    phi_453_ = _e254;
                    phi_454_ = _e256;
                } else {
                    phi_453_ = bool();
                    phi_454_ = true;
                }
                let _e258 = phi_453_;
                let _e260 = phi_454_;
                phi_455_ = _e258;
                phi_456_ = _e260;
            } else {
                phi_455_ = bool();
                phi_456_ = true;
            }
            let _e262 = phi_455_;
            let _e264 = phi_456_;
            if _e264 {
                phi_460_ = false;
            } else {
                phi_460_ = _e262;
            }
            let _e266 = phi_460_;
            if _e266 {
                if (_e106.is_parallel == 0u) {
                    let _e269 = abs(_e146);
                    let _e270 = abs(_e147);
                    let _e271 = abs(_e148);
                    if (_e269 >= _e270) {
                        if (_e269 >= _e271) {
                            phi_480_ = false;
                        } else {
                            phi_480_ = true;
                        }
                        let _e275 = phi_480_;
                        phi_481_ = _e275;
                    } else {
                        phi_481_ = true;
                    }
                    let _e277 = phi_481_;
                    if _e277 {
                        if (_e270 >= _e271) {
                            phi_489_ = 1u;
                            phi_490_ = _e147;
                        } else {
                            phi_489_ = 2u;
                            phi_490_ = _e148;
                        }
                        let _e280 = phi_489_;
                        let _e282 = phi_490_;
                        phi_491_ = _e280;
                        phi_492_ = _e282;
                    } else {
                        phi_491_ = 0u;
                        phi_492_ = _e146;
                    }
                    let _e284 = phi_491_;
                    let _e286 = phi_492_;
                    if (_e286 < 0f) {
                        phi_497_ = -1f;
                    } else {
                        phi_497_ = 1f;
                    }
                    let _e289 = phi_497_;
                    let _e290 = (_e289 < 0f);
                    if (_e284 == 0u) {
                        if _e290 {
                            phi_508_ = _e106.roots.y;
                        } else {
                            phi_508_ = _e106.roots.x;
                        }
                        let _e297 = phi_508_;
                        phi_526_ = _e297;
                    } else {
                        if (_e284 == 1u) {
                            if _e290 {
                                phi_518_ = _e106.roots.w;
                            } else {
                                phi_518_ = _e106.roots.z;
                            }
                            let _e304 = phi_518_;
                            phi_525_ = _e304;
                        } else {
                            if _e290 {
                                phi_524_ = _e106.roots_z.y;
                            } else {
                                phi_524_ = _e106.roots_z.x;
                            }
                            let _e310 = phi_524_;
                            phi_525_ = _e310;
                        }
                        let _e312 = phi_525_;
                        phi_526_ = _e312;
                    }
                    let _e314 = phi_526_;
                    if (_e284 == 0u) {
                        phi_538_ = vec3<f32>(_e147, _e148, _e146);
                    } else {
                        if (_e284 == 1u) {
                            phi_537_ = vec3<f32>(_e148, _e146, _e147);
                        } else {
                            phi_537_ = _e149;
                        }
                        let _e320 = phi_537_;
                        phi_538_ = _e320;
                    }
                    let _e322 = phi_538_;
                    phi_583_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e322.x / _e322.z), (_e322.y / _e322.z), (_e289 / _e322.z)), _e314);
                } else {
                    if (_e106.axis == 0u) {
                        phi_561_ = vec3<f32>(_e128, _e130, _e126);
                    } else {
                        if (_e106.axis == 1u) {
                            phi_560_ = vec3<f32>(_e130, _e126, _e128);
                        } else {
                            phi_560_ = (_e112 + vec3<f32>(_e120, _e122, _e124));
                        }
                        let _e339 = phi_560_;
                        phi_561_ = _e339;
                    }
                    let _e341 = phi_561_;
                    let _e356 = (_e341.z - _e106.middle.z);
                    phi_583_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e341.x - _e106.middle.x) - (_e106.shear.x * _e356)), ((_e341.y - _e106.middle.y) - (_e106.shear.y * _e356)), (_e106.sign * _e356)), _e106.roots.x);
                }
                let _e367 = phi_583_;
                if (_e367.unnamed_1 == 4294967295u) {
                    phi_1922_ = false;
                } else {
                    if (0u < _e76) {
                    } else {
                        return;
                    }
                    let _e384 = nodes.member[0u].frame[0u];
                    let _e388 = nodes.member[0u].frame[1u];
                    let _e392 = nodes.member[0u].frame[2u];
                    let _e396 = nodes.member[0u].frame[0u];
                    let _e400 = nodes.member[0u].frame[1u];
                    let _e404 = nodes.member[0u].frame[2u];
                    let _e408 = nodes.member[0u].frame[3u];
                    let _e442 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146), abs(_e147));
                    let _e443 = core_intrinsics_maximum_number_nsz_f32_(_e442, abs(_e148));
                    let _e444 = (_e443 * 0.0000000000009094947f);
                    if (abs(_e146) < _e444) {
                        phi_658_ = _e444;
                    } else {
                        phi_658_ = abs(_e146);
                    }
                    let _e449 = phi_658_;
                    if (_e146 < 0f) {
                        phi_665_ = (-1f / _e449);
                    } else {
                        phi_665_ = (1f / _e449);
                    }
                    let _e454 = phi_665_;
                    if (abs(_e147) < _e444) {
                        phi_672_ = _e444;
                    } else {
                        phi_672_ = abs(_e147);
                    }
                    let _e459 = phi_672_;
                    if (_e147 < 0f) {
                        phi_679_ = (-1f / _e459);
                    } else {
                        phi_679_ = (1f / _e459);
                    }
                    let _e464 = phi_679_;
                    if (abs(_e148) < _e444) {
                        phi_686_ = _e444;
                    } else {
                        phi_686_ = abs(_e148);
                    }
                    let _e469 = phi_686_;
                    if (_e148 < 0f) {
                        phi_693_ = (-1f / _e469);
                    } else {
                        phi_693_ = (1f / _e469);
                    }
                    let _e474 = phi_693_;
                    let _e478 = abs((bitcast<f32>(_e384) - _e126));
                    let _e479 = abs((bitcast<f32>(_e388) - _e128));
                    let _e480 = abs((bitcast<f32>(_e392) - _e130));
                    let _e484 = abs(((bitcast<f32>(_e396) + (bitcast<f32>((((_e408 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                    let _e485 = abs(((bitcast<f32>(_e400) + (bitcast<f32>((((_e408 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                    let _e486 = abs(((bitcast<f32>(_e404) + (bitcast<f32>((((_e408 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                    if (_e478 > _e484) {
                        phi_710_ = _e478;
                    } else {
                        phi_710_ = _e484;
                    }
                    let _e489 = phi_710_;
                    if (_e479 > _e485) {
                        phi_715_ = _e479;
                    } else {
                        phi_715_ = _e485;
                    }
                    let _e492 = phi_715_;
                    if (_e480 > _e486) {
                        phi_720_ = _e480;
                    } else {
                        phi_720_ = _e486;
                    }
                    let _e495 = phi_720_;
                    if (_e489 > _e492) {
                        phi_725_ = _e489;
                    } else {
                        phi_725_ = _e492;
                    }
                    let _e498 = phi_725_;
                    if (_e498 > _e495) {
                        phi_730_ = _e498;
                    } else {
                        phi_730_ = _e495;
                    }
                    let _e501 = phi_730_;
                    let _e508 = (_e501 * 0.0000009536743f);
                    let _e509 = (abs(_e454) * _e508);
                    let _e510 = (abs(_e464) * _e508);
                    let _e511 = (abs(_e474) * _e508);
                    let _e512 = abs(_e146);
                    let _e513 = abs(_e147);
                    let _e514 = abs(_e148);
                    if (_e512 >= _e513) {
                        if (_e512 >= _e514) {
                            phi_752_ = false;
                        } else {
                            phi_752_ = true;
                        }
                        let _e518 = phi_752_;
                        phi_753_ = _e518;
                    } else {
                        phi_753_ = true;
                    }
                    let _e520 = phi_753_;
                    if _e520 {
                        if (_e513 >= _e514) {
                            phi_761_ = 1u;
                        } else {
                            phi_761_ = 2u;
                        }
                        let _e523 = phi_761_;
                        phi_762_ = _e523;
                    } else {
                        phi_762_ = 0u;
                    }
                    let _e525 = phi_762_;
                    if (_e525 == 0u) {
                        phi_774_ = vec3<f32>(_e147, _e148, _e146);
                    } else {
                        if (_e525 == 1u) {
                            phi_773_ = vec3<f32>(_e148, _e146, _e147);
                        } else {
                            phi_773_ = _e149;
                        }
                        let _e531 = phi_773_;
                        phi_774_ = _e531;
                    }
                    let _e533 = phi_774_;
                    let _e536 = (_e533.x / _e533.z);
                    let _e539 = (_e533.y / _e533.z);
                    local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_786_ = ((_e367.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_789_ = 0u;
                    loop {
                        let _e546 = phi_786_;
                        let _e548 = phi_789_;
                        phi_794_ = _e546;
                        phi_796_ = 0u;
                        phi_798_ = 0u;
                        phi_800_ = _e548;
                        loop {
                            let _e550 = phi_794_;
                            let _e552 = phi_796_;
                            let _e554 = phi_798_;
                            let _e556 = phi_800_;
                            let _e563 = (((_e550 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e550), 32u, (_e550 == 0u))) * 5u);
                            if (_e563 < _e91) {
                            } else {
                                return;
                            }
                            let _e567 = rows.member[(0u + _e563)];
                            let _e568 = (_e563 + 1u);
                            if (_e568 < _e91) {
                            } else {
                                return;
                            }
                            let _e572 = rows.member[(0u + _e568)];
                            let _e573 = (_e563 + 2u);
                            if (_e573 < _e91) {
                            } else {
                                return;
                            }
                            let _e577 = rows.member[(0u + _e573)];
                            let _e578 = (_e563 + 3u);
                            if (_e578 < _e91) {
                            } else {
                                return;
                            }
                            let _e582 = rows.member[(0u + _e578)];
                            let _e583 = (_e563 + 4u);
                            if (_e583 < _e91) {
                            } else {
                                return;
                            }
                            let _e587 = rows.member[(0u + _e583)];
                            let _e588 = lt_bvh_Node(_e567, _e572, _e577, _e582, _e587);
                            let _e590 = (_e550 & (_e550 - 1u));
                            let _e602 = (_e367.unnamed.positive_exponent - bitcast<f32>(_e588.frame.x));
                            let _e605 = bitcast<f32>((((_e588.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e602 > 0f) {
                                if (_e602 < (255f * _e605)) {
                                    phi_872_ = (_e602 / _e605);
                                } else {
                                    phi_872_ = 255f;
                                }
                                let _e611 = phi_872_;
                                phi_873_ = _e611;
                            } else {
                                phi_873_ = 0f;
                            }
                            let _e613 = phi_873_;
                            let _e620 = select(select(u32(_e613), 0u, (_e613 < bitcast<f32>(0u))), 4294967295u, (_e613 > bitcast<f32>(1333788671u)));
                            if (f32(_e620) < _e613) {
                                phi_887_ = (_e620 + 1u);
                            } else {
                                phi_887_ = _e620;
                            }
                            let _e625 = phi_887_;
                            let _e626 = (_e620 * 16843009u);
                            let _e627 = (_e625 * 16843009u);
                            let _e637 = (_e367.unnamed.negative_exponent - bitcast<f32>(_e588.frame.y));
                            let _e640 = bitcast<f32>((((_e588.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e637 > 0f) {
                                if (_e637 < (255f * _e640)) {
                                    phi_910_ = (_e637 / _e640);
                                } else {
                                    phi_910_ = 255f;
                                }
                                let _e646 = phi_910_;
                                phi_911_ = _e646;
                            } else {
                                phi_911_ = 0f;
                            }
                            let _e648 = phi_911_;
                            let _e655 = select(select(u32(_e648), 0u, (_e648 < bitcast<f32>(0u))), 4294967295u, (_e648 > bitcast<f32>(1333788671u)));
                            if (f32(_e655) < _e648) {
                                phi_925_ = (_e655 + 1u);
                            } else {
                                phi_925_ = _e655;
                            }
                            let _e660 = phi_925_;
                            let _e661 = (_e655 * 16843009u);
                            let _e662 = (_e660 * 16843009u);
                            let _e671 = (((_e106.diagonal.x * _e367.unnamed.positive_exponent) + (_e106.diagonal.y * _e367.unnamed.negative_exponent)) - bitcast<f32>(_e588.frame.z));
                            let _e674 = bitcast<f32>((((_e588.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e671 > 0f) {
                                if (_e671 < (255f * _e674)) {
                                    phi_947_ = (_e671 / _e674);
                                } else {
                                    phi_947_ = 255f;
                                }
                                let _e680 = phi_947_;
                                phi_948_ = _e680;
                            } else {
                                phi_948_ = 0f;
                            }
                            let _e682 = phi_948_;
                            let _e689 = select(select(u32(_e682), 0u, (_e682 < bitcast<f32>(0u))), 4294967295u, (_e682 > bitcast<f32>(1333788671u)));
                            if (f32(_e689) < _e682) {
                                phi_962_ = (_e689 + 1u);
                            } else {
                                phi_962_ = _e689;
                            }
                            let _e694 = phi_962_;
                            let _e695 = (_e689 * 16843009u);
                            let _e696 = (_e694 * 16843009u);
                            let _e706 = (_e367.unnamed.min_variance - bitcast<f32>(_e588.frame.w));
                            let _e709 = bitcast<f32>((((_e588.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e706 > 0f) {
                                if (_e706 < (255f * _e709)) {
                                    phi_985_ = (_e706 / _e709);
                                } else {
                                    phi_985_ = 255f;
                                }
                                let _e715 = phi_985_;
                                phi_986_ = _e715;
                            } else {
                                phi_986_ = 0f;
                            }
                            let _e717 = phi_986_;
                            let _e724 = select(select(u32(_e717), 0u, (_e717 < bitcast<f32>(0u))), 4294967295u, (_e717 > bitcast<f32>(1333788671u)));
                            if (f32(_e724) < _e717) {
                                phi_1000_ = (_e724 + 1u);
                            } else {
                                phi_1000_ = _e724;
                            }
                            let _e729 = phi_1000_;
                            let _e730 = (_e729 * 16843009u);
                            let _e911 = (((((((((((_e626 & ~(_e588.links.x)) | (~((_e588.links.x ^ _e626)) & ((_e626 | 2155905152u) - (_e588.links.x & 2139062143u)))) & ((_e588.links.z & ~(_e627)) | (~((_e627 ^ _e588.links.z)) & ((_e588.links.z | 2155905152u) - (_e627 & 2139062143u))))) & (((_e661 & ~(_e588.x.x)) | (~((_e588.x.x ^ _e661)) & ((_e661 | 2155905152u) - (_e588.x.x & 2139062143u)))) & ((_e588.x.z & ~(_e662)) | (~((_e662 ^ _e588.x.z)) & ((_e588.x.z | 2155905152u) - (_e662 & 2139062143u)))))) & (((_e695 & ~(_e588.y.x)) | (~((_e588.y.x ^ _e695)) & ((_e695 | 2155905152u) - (_e588.y.x & 2139062143u)))) & ((_e588.y.z & ~(_e696)) | (~((_e696 ^ _e588.y.z)) & ((_e588.y.z | 2155905152u) - (_e696 & 2139062143u)))))) & ((_e588.z.x & ~(_e730)) | (~((_e730 ^ _e588.z.x)) & ((_e588.z.x | 2155905152u) - (_e730 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e626 & ~(_e588.links.y)) | (~((_e588.links.y ^ _e626)) & ((_e626 | 2155905152u) - (_e588.links.y & 2139062143u)))) & ((_e588.links.w & ~(_e627)) | (~((_e627 ^ _e588.links.w)) & ((_e588.links.w | 2155905152u) - (_e627 & 2139062143u))))) & (((_e661 & ~(_e588.x.y)) | (~((_e588.x.y ^ _e661)) & ((_e661 | 2155905152u) - (_e588.x.y & 2139062143u)))) & ((_e588.x.w & ~(_e662)) | (~((_e662 ^ _e588.x.w)) & ((_e588.x.w | 2155905152u) - (_e662 & 2139062143u)))))) & (((_e695 & ~(_e588.y.y)) | (~((_e588.y.y ^ _e695)) & ((_e695 | 2155905152u) - (_e588.y.y & 2139062143u)))) & ((_e588.y.w & ~(_e696)) | (~((_e696 ^ _e588.y.w)) & ((_e588.y.w | 2155905152u) - (_e696 & 2139062143u)))))) & ((_e588.z.y & ~(_e730)) | (~((_e730 ^ _e588.z.y)) & ((_e588.z.y | 2155905152u) - (_e730 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e588.z.w & 2147483648u) != 0u) {
                                phi_1200_ = _e590;
                                phi_797_ = (_e588.z.w & 2147483647u);
                                phi_799_ = _e911;
                                phi_1201_ = _e556;
                            } else {
                                if (_e911 == 0u) {
                                    phi_1198_ = _e590;
                                    phi_1199_ = _e556;
                                } else {
                                    if ((_e590 & 255u) == 0u) {
                                        phi_1193_ = _e556;
                                    } else {
                                        if (_e556 < 32u) {
                                            if (_e556 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1[(0u + _e556)] = _e590;
                                            phi_1192_ = (_e556 + 1u);
                                        } else {
                                            phi_1192_ = _e556;
                                        }
                                        let _e928 = phi_1192_;
                                        phi_1193_ = _e928;
                                    }
                                    let _e930 = phi_1193_;
                                    phi_1198_ = (((_e588.z.w & 2147483647u) << bitcast<u32>(8i)) | _e911);
                                    phi_1199_ = _e930;
                                }
                                let _e938 = phi_1198_;
                                let _e940 = phi_1199_;
                                phi_1200_ = _e938;
                                phi_797_ = _e552;
                                phi_799_ = _e554;
                                phi_1201_ = _e940;
                            }
                            let _e942 = phi_1200_;
                            let _e944 = phi_797_;
                            let _e946 = phi_799_;
                            let _e948 = phi_1201_;
                            local_3 = _e946;
                            local_15 = _e946;
                            local_4 = _e944;
                            if ((_e942 & 255u) == 0u) {
                                if (_e948 > 0u) {
                                    let _e952 = (_e948 - 1u);
                                    if (_e952 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e956 = local_1[(0u + _e952)];
                                    phi_1219_ = _e956;
                                    phi_1220_ = _e952;
                                } else {
                                    phi_1219_ = 0u;
                                    phi_1220_ = _e948;
                                }
                                let _e958 = phi_1219_;
                                let _e960 = phi_1220_;
                                phi_787_ = _e958;
                                phi_790_ = _e960;
                            } else {
                                phi_787_ = _e942;
                                phi_790_ = _e948;
                            }
                            let _e962 = phi_787_;
                            let _e964 = phi_790_;
                            local_13 = _e962;
                            local_14 = _e964;
                            local_6 = _e962;
                            if (_e946 == 0u) {
                                let _e966 = (_e962 == 0u);
                                if _e966 {
                                    phi_1229_ = false;
                                } else {
                                    phi_1229_ = true;
                                }
                                let _e968 = phi_1229_;
                                phi_1230_ = _e968;
                                phi_1231_ = _e966;
                            } else {
                                phi_1230_ = false;
                                phi_1231_ = false;
                            }
                            let _e970 = phi_1230_;
                            let _e972 = phi_1231_;
                            local_2 = _e972;
                            continue;
                            continuing {
                                phi_794_ = _e962;
                                phi_796_ = _e944;
                                phi_798_ = _e946;
                                phi_800_ = _e964;
                                break if !(_e970);
                            }
                        }
                        let _e975 = local_2;
                        if _e975 {
                        }
                        let _e977 = local_3;
                        if (_e977 == 0u) {
                            phi_1896_ = true;
                            phi_1897_ = false;
                            phi_1898_ = false;
                        } else {
                            let _e3151 = local_15;
                            phi_1240_ = _e3151;
                            loop {
                                let _e980 = phi_1240_;
                                let _e983 = select(firstTrailingBit(_e980), 32u, (_e980 == 0u));
                                let _e987 = local_4;
                                let _e988 = (_e987 + (_e983 >> bitcast<u32>(2i)));
                                if (_e988 < _e91) {
                                } else {
                                    return;
                                }
                                let _e993 = rows.member[(0u + _e988)][0u];
                                let _e997 = rows.member[(0u + _e988)][1u];
                                let _e1001 = rows.member[(0u + _e988)][2u];
                                let _e1005 = rows.member[(0u + _e988)][3u];
                                if ((_e983 & 2u) == 0u) {
                                    phi_1275_ = _e997;
                                    phi_1276_ = _e993;
                                } else {
                                    phi_1275_ = _e1005;
                                    phi_1276_ = _e1001;
                                }
                                let _e1009 = phi_1275_;
                                let _e1011 = phi_1276_;
                                if ((_e983 & 1u) == 0u) {
                                    phi_1282_ = _e1011;
                                } else {
                                    phi_1282_ = _e1009;
                                }
                                let _e1015 = phi_1282_;
                                let _e1017 = (_e980 & (_e980 - 1u));
                                if (_e1015 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1022 = triangles.member[(0u + _e1015)].v0_;
                                let _e1024 = (_e1022.x - _e126);
                                let _e1026 = (_e1022.y - _e128);
                                let _e1028 = (_e1022.z - _e130);
                                if (_e525 == 0u) {
                                    phi_1311_ = vec3<f32>(_e1026, _e1028, _e1024);
                                } else {
                                    if (_e525 == 1u) {
                                        phi_1310_ = vec3<f32>(_e1028, _e1024, _e1026);
                                    } else {
                                        phi_1310_ = (_e1022 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1036 = phi_1310_;
                                    phi_1311_ = _e1036;
                                }
                                let _e1038 = phi_1311_;
                                let _e1042 = (_e1038.x - (_e536 * _e1038.z));
                                let _e1046 = (_e1038.y - (_e539 * _e1038.z));
                                let _e1048 = triangles.member[(0u + _e1015)].v1_;
                                let _e1050 = (_e1048.x - _e126);
                                let _e1052 = (_e1048.y - _e128);
                                let _e1054 = (_e1048.z - _e130);
                                if (_e525 == 0u) {
                                    phi_1341_ = vec3<f32>(_e1052, _e1054, _e1050);
                                } else {
                                    if (_e525 == 1u) {
                                        phi_1340_ = vec3<f32>(_e1054, _e1050, _e1052);
                                    } else {
                                        phi_1340_ = (_e1048 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1062 = phi_1340_;
                                    phi_1341_ = _e1062;
                                }
                                let _e1064 = phi_1341_;
                                let _e1068 = (_e1064.x - (_e536 * _e1064.z));
                                let _e1072 = (_e1064.y - (_e539 * _e1064.z));
                                let _e1074 = triangles.member[(0u + _e1015)].v2_;
                                let _e1076 = (_e1074.x - _e126);
                                let _e1078 = (_e1074.y - _e128);
                                let _e1080 = (_e1074.z - _e130);
                                if (_e525 == 0u) {
                                    phi_1371_ = vec3<f32>(_e1078, _e1080, _e1076);
                                } else {
                                    if (_e525 == 1u) {
                                        phi_1370_ = vec3<f32>(_e1080, _e1076, _e1078);
                                    } else {
                                        phi_1370_ = (_e1074 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1088 = phi_1370_;
                                    phi_1371_ = _e1088;
                                }
                                let _e1090 = phi_1371_;
                                let _e1094 = (_e1090.x - (_e536 * _e1090.z));
                                let _e1098 = (_e1090.y - (_e539 * _e1090.z));
                                if (_e1068 < _e1094) {
                                    phi_1390_ = true;
                                } else {
                                    if (_e1068 == _e1094) {
                                        phi_1389_ = (_e1072 < _e1098);
                                    } else {
                                        phi_1389_ = false;
                                    }
                                    let _e1103 = phi_1389_;
                                    phi_1390_ = _e1103;
                                }
                                let _e1105 = phi_1390_;
                                if _e1105 {
                                    phi_1394_ = _e1098;
                                    phi_1395_ = _e1094;
                                    phi_1396_ = _e1072;
                                    phi_1397_ = _e1068;
                                } else {
                                    phi_1394_ = _e1072;
                                    phi_1395_ = _e1068;
                                    phi_1396_ = _e1098;
                                    phi_1397_ = _e1094;
                                }
                                let _e1107 = phi_1394_;
                                let _e1109 = phi_1395_;
                                let _e1111 = phi_1396_;
                                let _e1113 = phi_1397_;
                                let _e1116 = ((_e1113 * _e1107) - (_e1111 * _e1109));
                                if _e1105 {
                                    phi_1405_ = -(_e1116);
                                } else {
                                    phi_1405_ = _e1116;
                                }
                                let _e1119 = phi_1405_;
                                if (_e1094 < _e1042) {
                                    phi_1416_ = true;
                                } else {
                                    if (_e1094 == _e1042) {
                                        phi_1415_ = (_e1098 < _e1046);
                                    } else {
                                        phi_1415_ = false;
                                    }
                                    let _e1124 = phi_1415_;
                                    phi_1416_ = _e1124;
                                }
                                let _e1126 = phi_1416_;
                                if _e1126 {
                                    phi_1420_ = _e1046;
                                    phi_1421_ = _e1042;
                                    phi_1422_ = _e1098;
                                    phi_1423_ = _e1094;
                                } else {
                                    phi_1420_ = _e1098;
                                    phi_1421_ = _e1094;
                                    phi_1422_ = _e1046;
                                    phi_1423_ = _e1042;
                                }
                                let _e1128 = phi_1420_;
                                let _e1130 = phi_1421_;
                                let _e1132 = phi_1422_;
                                let _e1134 = phi_1423_;
                                let _e1137 = ((_e1134 * _e1128) - (_e1132 * _e1130));
                                if _e1126 {
                                    phi_1431_ = -(_e1137);
                                } else {
                                    phi_1431_ = _e1137;
                                }
                                let _e1140 = phi_1431_;
                                if (_e1042 < _e1068) {
                                    phi_1442_ = true;
                                } else {
                                    if (_e1042 == _e1068) {
                                        phi_1441_ = (_e1046 < _e1072);
                                    } else {
                                        phi_1441_ = false;
                                    }
                                    let _e1145 = phi_1441_;
                                    phi_1442_ = _e1145;
                                }
                                let _e1147 = phi_1442_;
                                if _e1147 {
                                    phi_1446_ = _e1072;
                                    phi_1447_ = _e1068;
                                    phi_1448_ = _e1046;
                                    phi_1449_ = _e1042;
                                } else {
                                    phi_1446_ = _e1046;
                                    phi_1447_ = _e1042;
                                    phi_1448_ = _e1072;
                                    phi_1449_ = _e1068;
                                }
                                let _e1149 = phi_1446_;
                                let _e1151 = phi_1447_;
                                let _e1153 = phi_1448_;
                                let _e1155 = phi_1449_;
                                let _e1158 = ((_e1155 * _e1149) - (_e1153 * _e1151));
                                if _e1147 {
                                    phi_1457_ = -(_e1158);
                                } else {
                                    phi_1457_ = _e1158;
                                }
                                let _e1161 = phi_1457_;
                                if (_e1119 >= 0f) {
                                    if (_e1140 >= 0f) {
                                        if (_e1161 >= 0f) {
                                            phi_1472_ = ((_e1119 + _e1140) + _e1161);
                                            phi_1473_ = false;
                                        } else {
                                            phi_1472_ = f32();
                                            phi_1473_ = true;
                                        }
                                        let _e1168 = phi_1472_;
                                        let _e1170 = phi_1473_;
                                        phi_1474_ = _e1168;
                                        phi_1475_ = _e1170;
                                    } else {
                                        phi_1474_ = f32();
                                        phi_1475_ = true;
                                    }
                                    let _e1172 = phi_1474_;
                                    let _e1174 = phi_1475_;
                                    phi_1476_ = _e1172;
                                    phi_1477_ = _e1174;
                                } else {
                                    phi_1476_ = f32();
                                    phi_1477_ = true;
                                }
                                let _e1176 = phi_1476_;
                                let _e1178 = phi_1477_;
                                if _e1178 {
                                    if (_e1119 <= 0f) {
                                        if (_e1140 <= 0f) {
                                            let _e1181 = (_e1161 <= 0f);
                                            if _e1181 {
                                            }
                                            phi_1495_ = ((_e1119 + _e1140) + _e1161);
                                            phi_1496_ = false;
                                            phi_1497_ = _e1181;
                                        } else {
                                            phi_1495_ = f32();
                                            phi_1496_ = true;
                                            phi_1497_ = false;
                                        }
                                        let _e1185 = phi_1495_;
                                        let _e1187 = phi_1496_;
                                        let _e1189 = phi_1497_;
                                        phi_1498_ = _e1185;
                                        phi_1499_ = _e1187;
                                        phi_1500_ = _e1189;
                                    } else {
                                        phi_1498_ = f32();
                                        phi_1499_ = true;
                                        phi_1500_ = false;
                                    }
                                    let _e1191 = phi_1498_;
                                    let _e1193 = phi_1499_;
                                    let _e1195 = phi_1500_;
                                    if _e1193 {
                                        phi_1504_ = false;
                                    } else {
                                        phi_1504_ = _e1195;
                                    }
                                    let _e1197 = phi_1504_;
                                    phi_1505_ = _e1191;
                                    phi_1506_ = _e1197;
                                } else {
                                    phi_1505_ = _e1176;
                                    phi_1506_ = true;
                                }
                                let _e1199 = phi_1505_;
                                let _e1201 = phi_1506_;
                                if _e1201 {
                                    let _e1202 = (_e1199 == 0f);
                                    if _e1202 {
                                        phi_1822_ = lt_bvh_triangle_Intersection();
                                        phi_1823_ = false;
                                    } else {
                                        let _e1204 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1206 = (_e1204.x - _e126);
                                        let _e1208 = (_e1204.y - _e128);
                                        let _e1210 = (_e1204.z - _e130);
                                        if (_e525 == 0u) {
                                            phi_1535_ = vec3<f32>(_e1208, _e1210, _e1206);
                                        } else {
                                            if (_e525 == 1u) {
                                                phi_1534_ = vec3<f32>(_e1210, _e1206, _e1208);
                                            } else {
                                                phi_1534_ = (_e1204 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e1218 = phi_1534_;
                                            phi_1535_ = _e1218;
                                        }
                                        let _e1220 = phi_1535_;
                                        let _e1222 = triangles.member[(0u + _e1015)].v1_;
                                        let _e1224 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1227 = (_e1222.x - _e1224.x);
                                        let _e1230 = (_e1222.y - _e1224.y);
                                        let _e1233 = (_e1222.z - _e1224.z);
                                        if (_e525 == 0u) {
                                            phi_1561_ = vec3<f32>(_e1230, _e1233, _e1227);
                                        } else {
                                            if (_e525 == 1u) {
                                                phi_1560_ = vec3<f32>(_e1233, _e1227, _e1230);
                                            } else {
                                                phi_1560_ = (_e1222 - _e1224);
                                            }
                                            let _e1240 = phi_1560_;
                                            phi_1561_ = _e1240;
                                        }
                                        let _e1242 = phi_1561_;
                                        let _e1244 = triangles.member[(0u + _e1015)].v2_;
                                        let _e1246 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1249 = (_e1244.x - _e1246.x);
                                        let _e1252 = (_e1244.y - _e1246.y);
                                        let _e1255 = (_e1244.z - _e1246.z);
                                        if (_e525 == 0u) {
                                            phi_1587_ = vec3<f32>(_e1252, _e1255, _e1249);
                                        } else {
                                            if (_e525 == 1u) {
                                                phi_1586_ = vec3<f32>(_e1255, _e1249, _e1252);
                                            } else {
                                                phi_1586_ = (_e1244 - _e1246);
                                            }
                                            let _e1262 = phi_1586_;
                                            phi_1587_ = _e1262;
                                        }
                                        let _e1264 = phi_1587_;
                                        let _e1271 = ((_e1242.y * _e1264.z) - (_e1242.z * _e1264.y));
                                        let _e1278 = ((_e1242.z * _e1264.x) - (_e1242.x * _e1264.z));
                                        let _e1285 = ((_e1242.x * _e1264.y) - (_e1242.y * _e1264.x));
                                        let _e1299 = (((1f / _e533.z) * (((_e1271 * _e1220.x) + (_e1278 * _e1220.y)) + (_e1285 * _e1220.z))) / (((_e1271 * _e536) + (_e1278 * _e539)) + _e1285));
                                        if (_e1299 > 0f) {
                                            if (_e1299 < _e138) {
                                                let _e1303 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1305 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1303.x < _e1305.x) {
                                                    phi_1643_ = _e1303.x;
                                                } else {
                                                    phi_1643_ = _e1305.x;
                                                }
                                                let _e1312 = phi_1643_;
                                                if (_e1303.y < _e1305.y) {
                                                    phi_1652_ = _e1303.y;
                                                } else {
                                                    phi_1652_ = _e1305.y;
                                                }
                                                let _e1319 = phi_1652_;
                                                if (_e1303.z < _e1305.z) {
                                                    phi_1661_ = _e1303.z;
                                                } else {
                                                    phi_1661_ = _e1305.z;
                                                }
                                                let _e1326 = phi_1661_;
                                                let _e1328 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1312 < _e1328.x) {
                                                    phi_1670_ = _e1312;
                                                } else {
                                                    phi_1670_ = _e1328.x;
                                                }
                                                let _e1333 = phi_1670_;
                                                if (_e1319 < _e1328.y) {
                                                    phi_1677_ = _e1319;
                                                } else {
                                                    phi_1677_ = _e1328.y;
                                                }
                                                let _e1338 = phi_1677_;
                                                if (_e1326 < _e1328.z) {
                                                    phi_1684_ = _e1326;
                                                } else {
                                                    phi_1684_ = _e1328.z;
                                                }
                                                let _e1343 = phi_1684_;
                                                let _e1345 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1347 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1345.x > _e1347.x) {
                                                    phi_1697_ = _e1345.x;
                                                } else {
                                                    phi_1697_ = _e1347.x;
                                                }
                                                let _e1354 = phi_1697_;
                                                if (_e1345.y > _e1347.y) {
                                                    phi_1706_ = _e1345.y;
                                                } else {
                                                    phi_1706_ = _e1347.y;
                                                }
                                                let _e1361 = phi_1706_;
                                                if (_e1345.z > _e1347.z) {
                                                    phi_1715_ = _e1345.z;
                                                } else {
                                                    phi_1715_ = _e1347.z;
                                                }
                                                let _e1368 = phi_1715_;
                                                let _e1370 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1354 > _e1370.x) {
                                                    phi_1724_ = _e1354;
                                                } else {
                                                    phi_1724_ = _e1370.x;
                                                }
                                                let _e1375 = phi_1724_;
                                                if (_e1361 > _e1370.y) {
                                                    phi_1731_ = _e1361;
                                                } else {
                                                    phi_1731_ = _e1370.y;
                                                }
                                                let _e1380 = phi_1731_;
                                                if (_e1368 > _e1370.z) {
                                                    phi_1738_ = _e1368;
                                                } else {
                                                    phi_1738_ = _e1370.z;
                                                }
                                                let _e1385 = phi_1738_;
                                                let _e1389 = ((_e1333 - _e126) * _e454);
                                                let _e1390 = ((_e1338 - _e128) * _e464);
                                                let _e1391 = ((_e1343 - _e130) * _e474);
                                                let _e1395 = ((_e1375 - _e126) * _e454);
                                                let _e1396 = ((_e1380 - _e128) * _e464);
                                                let _e1397 = ((_e1385 - _e130) * _e474);
                                                if (_e1389 < _e1395) {
                                                    phi_1755_ = _e1389;
                                                } else {
                                                    phi_1755_ = _e1395;
                                                }
                                                let _e1400 = phi_1755_;
                                                if (_e1390 < _e1396) {
                                                    phi_1760_ = _e1390;
                                                } else {
                                                    phi_1760_ = _e1396;
                                                }
                                                let _e1403 = phi_1760_;
                                                if (_e1391 < _e1397) {
                                                    phi_1765_ = _e1391;
                                                } else {
                                                    phi_1765_ = _e1397;
                                                }
                                                let _e1406 = phi_1765_;
                                                if (_e1389 > _e1395) {
                                                    phi_1773_ = _e1389;
                                                } else {
                                                    phi_1773_ = _e1395;
                                                }
                                                let _e1412 = phi_1773_;
                                                if (_e1390 > _e1396) {
                                                    phi_1778_ = _e1390;
                                                } else {
                                                    phi_1778_ = _e1396;
                                                }
                                                let _e1415 = phi_1778_;
                                                if (_e1391 > _e1397) {
                                                    phi_1783_ = _e1391;
                                                } else {
                                                    phi_1783_ = _e1397;
                                                }
                                                let _e1418 = phi_1783_;
                                                let _e1422 = core_intrinsics_maximum_number_nsz_f32_((_e1400 - _e509), (_e1403 - _e510));
                                                let _e1423 = core_intrinsics_maximum_number_nsz_f32_(_e1422, (_e1406 - _e511));
                                                let _e1424 = core_intrinsics_minimum_number_nsz_f32_((_e1412 + _e509), (_e1415 + _e510));
                                                let _e1425 = core_intrinsics_minimum_number_nsz_f32_(_e1424, (_e1418 + _e511));
                                                if (_e1423 > -300000000000000000000000000000000000000f) {
                                                    phi_1795_ = _e1423;
                                                } else {
                                                    phi_1795_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1428 = phi_1795_;
                                                if (_e1425 < 300000000000000000000000000000000000000f) {
                                                    phi_1800_ = _e1425;
                                                } else {
                                                    phi_1800_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1431 = phi_1800_;
                                                if (_e1299 < _e1428) {
                                                    phi_1805_ = _e1428;
                                                } else {
                                                    phi_1805_ = _e1299;
                                                }
                                                let _e1434 = phi_1805_;
                                                if (_e1434 > _e1431) {
                                                    phi_1810_ = _e1431;
                                                } else {
                                                    phi_1810_ = _e1434;
                                                }
                                                let _e1437 = phi_1810_;
                                                phi_1815_ = lt_bvh_triangle_Intersection(_e1437, (_e1140 / _e1199), (_e1161 / _e1199), (_e1428 <= _e1431));
                                                phi_1816_ = false;
                                            } else {
                                                phi_1815_ = lt_bvh_triangle_Intersection();
                                                phi_1816_ = true;
                                            }
                                            let _e1443 = phi_1815_;
                                            let _e1445 = phi_1816_;
                                            phi_1817_ = _e1443;
                                            phi_1818_ = _e1445;
                                        } else {
                                            phi_1817_ = lt_bvh_triangle_Intersection();
                                            phi_1818_ = true;
                                        }
                                        let _e1447 = phi_1817_;
                                        let _e1449 = phi_1818_;
                                        if _e1449 {
                                        }
                                        phi_1822_ = _e1447;
                                        phi_1823_ = _e1449;
                                    }
                                    let _e1451 = phi_1822_;
                                    let _e1453 = phi_1823_;
                                    phi_1824_ = _e1451;
                                    phi_1825_ = _e1202;
                                    phi_1826_ = _e1453;
                                } else {
                                    phi_1824_ = lt_bvh_triangle_Intersection();
                                    phi_1825_ = true;
                                    phi_1826_ = false;
                                }
                                let _e1455 = phi_1824_;
                                let _e1457 = phi_1825_;
                                let _e1459 = phi_1826_;
                                if _e1457 {
                                    phi_1830_ = true;
                                } else {
                                    phi_1830_ = _e1459;
                                }
                                let _e1461 = phi_1830_;
                                if _e1461 {
                                    phi_1834_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1834_ = _e1455;
                                }
                                let _e1463 = phi_1834_;
                                if _e1463.is_hit {
                                    if (_e1463.t > 0f) {
                                        if (_e1463.t < _e138) {
                                            let _e1470 = triangles.member[(0u + _e1015)].i0_;
                                            let _e1472 = ((_e1470 & 2147483648u) == 0u);
                                            if _e1472 {
                                                phi_1860_ = false;
                                                phi_1861_ = false;
                                            } else {
                                                if true {
                                                    phi_1859_ = false;
                                                } else {
                                                    phi_1859_ = true;
                                                }
                                                let _e1474 = phi_1859_;
                                                phi_1860_ = _e1474;
                                                phi_1861_ = true;
                                            }
                                            let _e1476 = phi_1860_;
                                            let _e1478 = phi_1861_;
                                            phi_1862_ = _e1476;
                                            phi_1863_ = _e1472;
                                            phi_1864_ = _e1478;
                                        } else {
                                            phi_1862_ = true;
                                            phi_1863_ = false;
                                            phi_1864_ = false;
                                        }
                                        let _e1480 = phi_1862_;
                                        let _e1482 = phi_1863_;
                                        let _e1484 = phi_1864_;
                                        phi_1865_ = false;
                                        phi_1866_ = _e1480;
                                        phi_1867_ = _e1482;
                                        phi_1868_ = _e1484;
                                    } else {
                                        phi_1865_ = true;
                                        phi_1866_ = false;
                                        phi_1867_ = false;
                                        phi_1868_ = false;
                                    }
                                    let _e1486 = phi_1865_;
                                    let _e1488 = phi_1866_;
                                    let _e1490 = phi_1867_;
                                    let _e1492 = phi_1868_;
                                    phi_1869_ = _e1486;
                                    phi_1870_ = _e1488;
                                    phi_1871_ = _e1490;
                                    phi_1872_ = _e1492;
                                } else {
                                    phi_1869_ = true;
                                    phi_1870_ = false;
                                    phi_1871_ = false;
                                    phi_1872_ = false;
                                }
                                let _e1494 = phi_1869_;
                                let _e1496 = phi_1870_;
                                let _e1498 = phi_1871_;
                                let _e1500 = phi_1872_;
                                if _e1494 {
                                    phi_1876_ = true;
                                    phi_1877_ = false;
                                    phi_1878_ = false;
                                } else {
                                    phi_1876_ = _e1496;
                                    phi_1877_ = _e1498;
                                    phi_1878_ = _e1500;
                                }
                                let _e1502 = phi_1876_;
                                let _e1504 = phi_1877_;
                                let _e1506 = phi_1878_;
                                if _e1502 {
                                    let _e1507 = (_e1017 == 0u);
                                    if _e1507 {
                                        phi_1886_ = false;
                                    } else {
                                        phi_1886_ = true;
                                    }
                                    let _e1509 = phi_1886_;
                                    phi_1887_ = _e1509;
                                    phi_1888_ = _e1507;
                                    phi_1889_ = false;
                                    phi_1890_ = false;
                                } else {
                                    phi_1887_ = false;
                                    phi_1888_ = false;
                                    phi_1889_ = _e1504;
                                    phi_1890_ = _e1506;
                                }
                                let _e1511 = phi_1887_;
                                let _e1513 = phi_1888_;
                                let _e1515 = phi_1889_;
                                let _e1517 = phi_1890_;
                                local_5 = _e1513;
                                local_16 = _e1515;
                                local_17 = _e1517;
                                local_18 = _e1513;
                                continue;
                                continuing {
                                    phi_1240_ = _e1017;
                                    break if !(_e1511);
                                }
                            }
                            let _e1520 = local_5;
                            if _e1520 {
                                phi_1894_ = false;
                                phi_1895_ = false;
                            } else {
                                let _e3262 = local_16;
                                phi_1894_ = _e3262;
                                let _e3265 = local_17;
                                phi_1895_ = _e3265;
                            }
                            let _e1522 = phi_1894_;
                            let _e1524 = phi_1895_;
                            let _e3268 = local_18;
                            phi_1896_ = _e3268;
                            phi_1897_ = _e1522;
                            phi_1898_ = _e1524;
                        }
                        let _e1526 = phi_1896_;
                        let _e1528 = phi_1897_;
                        let _e1530 = phi_1898_;
                        if _e1526 {
                            let _e1532 = local_6;
                            if (_e1532 == 0u) {
                                phi_1906_ = false;
                            } else {
                                phi_1906_ = true;
                            }
                            let _e1535 = phi_1906_;
                            phi_1907_ = _e1535;
                            phi_1908_ = false;
                            phi_1909_ = false;
                        } else {
                            phi_1907_ = false;
                            phi_1908_ = _e1528;
                            phi_1909_ = _e1530;
                        }
                        let _e1537 = phi_1907_;
                        let _e1539 = phi_1908_;
                        let _e1541 = phi_1909_;
                        local_7 = _e1539;
                        local_19 = _e1541;
                        local_20 = _e1539;
                        continue;
                        continuing {
                            let _e3112 = local_13;
                            phi_786_ = _e3112;
                            let _e3115 = local_14;
                            phi_789_ = _e3115;
                            break if !(_e1537);
                        }
                    }
                    let _e1544 = local_7;
                    if _e1544 {
                        phi_1913_ = false;
                    } else {
                        let _e3279 = local_19;
                        phi_1913_ = _e3279;
                    }
                    let _e1546 = phi_1913_;
                    if _e1546 {
                        phi_1917_ = true;
                    } else {
                        let _e3282 = local_20;
                        phi_1917_ = _e3282;
                    }
                    let _e1548 = phi_1917_;
                    if _e1548 {
                        phi_1921_ = true;
                    } else {
                        phi_1921_ = false;
                    }
                    let _e1550 = phi_1921_;
                    phi_1922_ = _e1550;
                }
                let _e1552 = phi_1922_;
                phi_3379_ = _e1552;
            } else {
                let _e1553 = abs(_e146);
                let _e1554 = abs(_e147);
                let _e1555 = abs(_e148);
                if (abs(_e126) < 1000000000000000f) {
                    if (abs(_e128) < 1000000000000000f) {
                        phi_1938_ = (abs(_e130) < 1000000000000000f);
                        phi_1939_ = false;
                    } else {
                        phi_1938_ = bool();
                        phi_1939_ = true;
                    }
                    let _e1563 = phi_1938_;
                    let _e1565 = phi_1939_;
                    phi_1940_ = _e1563;
                    phi_1941_ = _e1565;
                } else {
                    phi_1940_ = bool();
                    phi_1941_ = true;
                }
                let _e1567 = phi_1940_;
                let _e1569 = phi_1941_;
                if _e1569 {
                    phi_1945_ = false;
                } else {
                    phi_1945_ = _e1567;
                }
                let _e1571 = phi_1945_;
                if _e1571 {
                    if (_e1553 < 1000000000000000f) {
                        if (_e1554 < 1000000000000000f) {
                            phi_1958_ = (_e1555 < 1000000000000000f);
                            phi_1959_ = false;
                        } else {
                            phi_1958_ = bool();
                            phi_1959_ = true;
                        }
                        let _e1576 = phi_1958_;
                        let _e1578 = phi_1959_;
                        phi_1960_ = _e1576;
                        phi_1961_ = _e1578;
                    } else {
                        phi_1960_ = bool();
                        phi_1961_ = true;
                    }
                    let _e1580 = phi_1960_;
                    let _e1582 = phi_1961_;
                    if _e1582 {
                        phi_1965_ = false;
                    } else {
                        phi_1965_ = _e1580;
                    }
                    let _e1584 = phi_1965_;
                    if _e1584 {
                        if (_e1553 > 0f) {
                            phi_1979_ = bool();
                            phi_1980_ = true;
                        } else {
                            let _e1586 = (_e1554 > 0f);
                            if _e1586 {
                                phi_1978_ = bool();
                            } else {
                                phi_1978_ = (_e1555 > 0f);
                            }
                            let _e1589 = phi_1978_;
                            phi_1979_ = _e1589;
                            phi_1980_ = _e1586;
                        }
                        let _e1591 = phi_1979_;
                        let _e1593 = phi_1980_;
                        if _e1593 {
                            phi_1984_ = true;
                        } else {
                            phi_1984_ = _e1591;
                        }
                        let _e1595 = phi_1984_;
                        phi_1985_ = _e1595;
                        phi_1986_ = false;
                    } else {
                        phi_1985_ = bool();
                        phi_1986_ = true;
                    }
                    let _e1597 = phi_1985_;
                    let _e1599 = phi_1986_;
                    phi_1987_ = _e1597;
                    phi_1988_ = _e1599;
                } else {
                    phi_1987_ = bool();
                    phi_1988_ = true;
                }
                let _e1601 = phi_1987_;
                let _e1603 = phi_1988_;
                if _e1603 {
                    phi_1992_ = false;
                } else {
                    phi_1992_ = _e1601;
                }
                let _e1605 = phi_1992_;
                if _e1605 {
                    let _e1606 = (0u >= _e76);
                    if _e1606 {
                        phi_3372_ = bool();
                    } else {
                        if (0u < _e76) {
                        } else {
                            return;
                        }
                        let _e1612 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1616 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1620 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1624 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1628 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1632 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1636 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1670 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146), abs(_e147));
                        let _e1671 = core_intrinsics_maximum_number_nsz_f32_(_e1670, abs(_e148));
                        let _e1672 = (_e1671 * 0.0000000000009094947f);
                        if (abs(_e146) < _e1672) {
                            phi_2062_ = _e1672;
                        } else {
                            phi_2062_ = abs(_e146);
                        }
                        let _e1677 = phi_2062_;
                        if (_e146 < 0f) {
                            phi_2069_ = (-1f / _e1677);
                        } else {
                            phi_2069_ = (1f / _e1677);
                        }
                        let _e1682 = phi_2069_;
                        if (abs(_e147) < _e1672) {
                            phi_2076_ = _e1672;
                        } else {
                            phi_2076_ = abs(_e147);
                        }
                        let _e1687 = phi_2076_;
                        if (_e147 < 0f) {
                            phi_2083_ = (-1f / _e1687);
                        } else {
                            phi_2083_ = (1f / _e1687);
                        }
                        let _e1692 = phi_2083_;
                        if (abs(_e148) < _e1672) {
                            phi_2090_ = _e1672;
                        } else {
                            phi_2090_ = abs(_e148);
                        }
                        let _e1697 = phi_2090_;
                        if (_e148 < 0f) {
                            phi_2097_ = (-1f / _e1697);
                        } else {
                            phi_2097_ = (1f / _e1697);
                        }
                        let _e1702 = phi_2097_;
                        let _e1706 = abs((bitcast<f32>(_e1612) - _e126));
                        let _e1707 = abs((bitcast<f32>(_e1616) - _e128));
                        let _e1708 = abs((bitcast<f32>(_e1620) - _e130));
                        let _e1712 = abs(((bitcast<f32>(_e1624) + (bitcast<f32>((((_e1636 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                        let _e1713 = abs(((bitcast<f32>(_e1628) + (bitcast<f32>((((_e1636 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                        let _e1714 = abs(((bitcast<f32>(_e1632) + (bitcast<f32>((((_e1636 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                        if (_e1706 > _e1712) {
                            phi_2114_ = _e1706;
                        } else {
                            phi_2114_ = _e1712;
                        }
                        let _e1717 = phi_2114_;
                        if (_e1707 > _e1713) {
                            phi_2119_ = _e1707;
                        } else {
                            phi_2119_ = _e1713;
                        }
                        let _e1720 = phi_2119_;
                        if (_e1708 > _e1714) {
                            phi_2124_ = _e1708;
                        } else {
                            phi_2124_ = _e1714;
                        }
                        let _e1723 = phi_2124_;
                        if (_e1717 > _e1720) {
                            phi_2129_ = _e1717;
                        } else {
                            phi_2129_ = _e1720;
                        }
                        let _e1726 = phi_2129_;
                        if (_e1726 > _e1723) {
                            phi_2134_ = _e1726;
                        } else {
                            phi_2134_ = _e1723;
                        }
                        let _e1729 = phi_2134_;
                        let _e1733 = (_e1729 * 0.0000019073486f);
                        let _e1734 = (abs(_e1682) * _e1733);
                        let _e1735 = (abs(_e1692) * _e1733);
                        let _e1736 = (abs(_e1702) * _e1733);
                        let _e1740 = (_e1729 * 0.0000009536743f);
                        let _e1741 = (abs(_e1682) * _e1740);
                        let _e1742 = (abs(_e1692) * _e1740);
                        let _e1743 = (abs(_e1702) * _e1740);
                        let _e1744 = abs(_e146);
                        let _e1745 = abs(_e147);
                        let _e1746 = abs(_e148);
                        if (_e1744 >= _e1745) {
                            if (_e1744 >= _e1746) {
                                phi_2160_ = false;
                            } else {
                                phi_2160_ = true;
                            }
                            let _e1750 = phi_2160_;
                            phi_2161_ = _e1750;
                        } else {
                            phi_2161_ = true;
                        }
                        let _e1752 = phi_2161_;
                        if _e1752 {
                            if (_e1745 >= _e1746) {
                                phi_2169_ = 1u;
                            } else {
                                phi_2169_ = 2u;
                            }
                            let _e1755 = phi_2169_;
                            phi_2170_ = _e1755;
                        } else {
                            phi_2170_ = 0u;
                        }
                        let _e1757 = phi_2170_;
                        if (_e1757 == 0u) {
                            phi_2182_ = vec3<f32>(_e147, _e148, _e146);
                        } else {
                            if (_e1757 == 1u) {
                                phi_2181_ = vec3<f32>(_e148, _e146, _e147);
                            } else {
                                phi_2181_ = _e149;
                            }
                            let _e1763 = phi_2181_;
                            phi_2182_ = _e1763;
                        }
                        let _e1765 = phi_2182_;
                        let _e1768 = (_e1765.x / _e1765.z);
                        let _e1771 = (_e1765.y / _e1765.z);
                        if (_e1682 < 0f) {
                            phi_2195_ = 0u;
                        } else {
                            phi_2195_ = 1u;
                        }
                        let _e1776 = phi_2195_;
                        if (_e1692 < 0f) {
                            phi_2200_ = 0u;
                        } else {
                            phi_2200_ = 2u;
                        }
                        let _e1779 = phi_2200_;
                        if (_e1702 < 0f) {
                            phi_2205_ = 0u;
                        } else {
                            phi_2205_ = 4u;
                        }
                        let _e1782 = phi_2205_;
                        let _e1784 = ((_e1776 | _e1779) | _e1782);
                        let _e1785 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1785.first[0], _e1785.first[1], _e1785.first[2], _e1785.first[3], _e1785.first[4], _e1785.first[5], _e1785.first[6], _e1785.first[7], _e1785.first[8], _e1785.first[9], _e1785.first[10], _e1785.first[11], _e1785.first[12], _e1785.first[13], _e1785.first[14], _e1785.first[15], _e1785.first[16], _e1785.first[17], _e1785.first[18], _e1785.first[19], _e1785.first[20], _e1785.first[21], _e1785.first[22], _e1785.first[23], _e1785.first[24], _e1785.first[25], _e1785.first[26], _e1785.first[27], _e1785.first[28], _e1785.first[29], _e1785.first[30], _e1785.first[31]), array<u32, 32>(_e1785.mask[0], _e1785.mask[1], _e1785.mask[2], _e1785.mask[3], _e1785.mask[4], _e1785.mask[5], _e1785.mask[6], _e1785.mask[7], _e1785.mask[8], _e1785.mask[9], _e1785.mask[10], _e1785.mask[11], _e1785.mask[12], _e1785.mask[13], _e1785.mask[14], _e1785.mask[15], _e1785.mask[16], _e1785.mask[17], _e1785.mask[18], _e1785.mask[19], _e1785.mask[20], _e1785.mask[21], _e1785.mask[22], _e1785.mask[23], _e1785.mask[24], _e1785.mask[25], _e1785.mask[26], _e1785.mask[27], _e1785.mask[28], _e1785.mask[29], _e1785.mask[30], _e1785.mask[31]), _e1785.len, _e1785.group, _e1785.group_mask);
                        let _e1859 = local.group_mask;
                        if ((_e1859 & 4278190080u) == 0u) {
                            let _e1863 = local.len;
                            if (_e1863 == 0u) {
                                phi_2319_ = false;
                            } else {
                                let _e1867 = local.len;
                                local.len = (_e1867 - 1u);
                                let _e1870 = local.len;
                                if (_e1870 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1875 = local.first[(0u + _e1870)];
                                local.group = _e1875;
                                let _e1878 = local.len;
                                if (_e1878 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1883 = local.mask[(0u + _e1878)];
                                local.group_mask = _e1883;
                                phi_2319_ = true;
                            }
                            let _e1886 = phi_2319_;
                            phi_2320_ = _e1886;
                        } else {
                            phi_2320_ = true;
                        }
                        let _e1888 = phi_2320_;
                        if _e1888 {
                            let _e1890 = local.group_mask;
                            let _e1896 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1890)), 32u, (_e1890 == 0u)));
                            let _e1900 = local.group_mask;
                            let _e1914 = local.group_mask;
                            local.group_mask = (_e1914 & ~((1u << bitcast<u32>((_e1896 & 31u)))));
                            let _e1917 = local.group;
                            phi_2351_ = (_e1917 + countOneBits(((_e1900 & ~((4294967295u << bitcast<u32>((((_e1896 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2351_ = 4294967295u;
                        }
                        let _e1920 = phi_2351_;
                        phi_2353_ = _e1920;
                        phi_2356_ = false;
                        loop {
                            let _e1922 = phi_2353_;
                            let _e1924 = phi_2356_;
                            local_23 = _e1924;
                            if (_e1922 != 4294967295u) {
                                if (_e1922 < _e76) {
                                } else {
                                    return;
                                }
                                let _e1931 = nodes.member[(0u + _e1922)].frame[3u];
                                let _e1956 = (bitcast<f32>((((_e1931 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1682);
                                let _e1957 = (bitcast<f32>((((_e1931 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1692);
                                let _e1958 = (bitcast<f32>((((_e1931 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1702);
                                let _e1961 = nodes.member[(0u + _e1922)].frame[0u];
                                let _e1965 = nodes.member[(0u + _e1922)].frame[1u];
                                let _e1969 = nodes.member[(0u + _e1922)].frame[2u];
                                let _e1974 = ((bitcast<f32>(_e1961) - _e126) * _e1682);
                                let _e1975 = ((bitcast<f32>(_e1965) - _e128) * _e1692);
                                let _e1976 = ((bitcast<f32>(_e1969) - _e130) * _e1702);
                                let _e1984 = nodes.member[(0u + _e1922)].x;
                                if (_e1682 < 0f) {
                                    let _e1995 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1984.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2001 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1995.unnamed.root, _e1984.w), _e1995.unnamed_1);
                                    let _e2007 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2001.unnamed, lt_bvh_traverse_Tree(_e1984.x, _e2001.unnamed_1.first_primitive));
                                    phi_2436_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2007.unnamed, lt_bvh_traverse_Tree(_e2007.unnamed_1.root, _e1984.y));
                                } else {
                                    let _e2023 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1984.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2029 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2023.unnamed.root, _e1984.y), _e2023.unnamed_1);
                                    let _e2035 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2029.unnamed, lt_bvh_traverse_Tree(_e1984.z, _e2029.unnamed_1.first_primitive));
                                    phi_2436_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2035.unnamed, lt_bvh_traverse_Tree(_e2035.unnamed_1.root, _e1984.w));
                                }
                                let _e2043 = phi_2436_;
                                let _e2053 = nodes.member[(0u + _e1922)].y;
                                if (_e1692 < 0f) {
                                    let _e2064 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2053.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2070 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2064.unnamed.root, _e2053.w), _e2064.unnamed_1);
                                    let _e2076 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2070.unnamed, lt_bvh_traverse_Tree(_e2053.x, _e2070.unnamed_1.first_primitive));
                                    phi_2463_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2076.unnamed, lt_bvh_traverse_Tree(_e2076.unnamed_1.root, _e2053.y));
                                } else {
                                    let _e2092 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2053.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2098 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2092.unnamed.root, _e2053.y), _e2092.unnamed_1);
                                    let _e2104 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2098.unnamed, lt_bvh_traverse_Tree(_e2053.z, _e2098.unnamed_1.first_primitive));
                                    phi_2463_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2104.unnamed, lt_bvh_traverse_Tree(_e2104.unnamed_1.root, _e2053.w));
                                }
                                let _e2112 = phi_2463_;
                                let _e2122 = nodes.member[(0u + _e1922)].z;
                                if (_e1702 < 0f) {
                                    let _e2133 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2122.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2139 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2133.unnamed.root, _e2122.w), _e2133.unnamed_1);
                                    let _e2145 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2139.unnamed, lt_bvh_traverse_Tree(_e2122.x, _e2139.unnamed_1.first_primitive));
                                    phi_2490_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2145.unnamed, lt_bvh_traverse_Tree(_e2145.unnamed_1.root, _e2122.y));
                                } else {
                                    let _e2161 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2122.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2167 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2161.unnamed.root, _e2122.y), _e2161.unnamed_1);
                                    let _e2173 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2167.unnamed, lt_bvh_traverse_Tree(_e2122.z, _e2167.unnamed_1.first_primitive));
                                    phi_2490_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2173.unnamed, lt_bvh_traverse_Tree(_e2173.unnamed_1.root, _e2122.w));
                                }
                                let _e2181 = phi_2490_;
                                phi_2496_ = 0u;
                                phi_2499_ = 0u;
                                loop {
                                    let _e2191 = phi_2496_;
                                    let _e2193 = phi_2499_;
                                    local_8 = _e2193;
                                    local_9 = _e2193;
                                    local_10 = _e2193;
                                    let _e2194 = (_e2191 < 8u);
                                    if _e2194 {
                                        let _e2196 = (_e2191 >> bitcast<u32>(2i));
                                        let _e2197 = (_e2191 & 3u);
                                        if (_e2196 == 0u) {
                                            phi_2513_ = _e2043.unnamed.root;
                                        } else {
                                            phi_2513_ = _e2043.unnamed.first_primitive;
                                        }
                                        let _e2200 = phi_2513_;
                                        if (_e2196 == 0u) {
                                            phi_2523_ = _e2112.unnamed.root;
                                        } else {
                                            phi_2523_ = _e2112.unnamed.first_primitive;
                                        }
                                        let _e2209 = phi_2523_;
                                        if (_e2196 == 0u) {
                                            phi_2533_ = _e2181.unnamed.root;
                                        } else {
                                            phi_2533_ = _e2181.unnamed.first_primitive;
                                        }
                                        let _e2218 = phi_2533_;
                                        let _e2231 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2200 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u)) * _e1956) + (_e1974 - _e1734)), ((f32(((_e2209 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u)) * _e1957) + (_e1975 - _e1735)));
                                        let _e2232 = core_intrinsics_maximum_number_nsz_f32_(_e2231, ((f32(((_e2218 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u)) * _e1958) + (_e1976 - _e1736)));
                                        if (_e2196 == 0u) {
                                            phi_2551_ = _e2043.unnamed_1.root;
                                        } else {
                                            phi_2551_ = _e2043.unnamed_1.first_primitive;
                                        }
                                        let _e2235 = phi_2551_;
                                        if (_e2196 == 0u) {
                                            phi_2561_ = _e2112.unnamed_1.root;
                                        } else {
                                            phi_2561_ = _e2112.unnamed_1.first_primitive;
                                        }
                                        let _e2244 = phi_2561_;
                                        if (_e2196 == 0u) {
                                            phi_2571_ = _e2181.unnamed_1.root;
                                        } else {
                                            phi_2571_ = _e2181.unnamed_1.first_primitive;
                                        }
                                        let _e2253 = phi_2571_;
                                        let _e2266 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2235 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u)) * _e1956) + (_e1974 + _e1734)), ((f32(((_e2244 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u)) * _e1957) + (_e1975 + _e1735)));
                                        let _e2267 = core_intrinsics_minimum_number_nsz_f32_(_e2266, ((f32(((_e2253 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u)) * _e1958) + (_e1976 + _e1736)));
                                        if (_e2232 <= _e2267) {
                                            if (_e2232 <= _e138) {
                                                if (_e2267 >= 0f) {
                                                    if (_e2196 == 0u) {
                                                        let _e2274 = nodes.member[(0u + _e1922)].links[2u];
                                                        phi_2607_ = _e2274;
                                                    } else {
                                                        let _e2277 = nodes.member[(0u + _e1922)].links[3u];
                                                        phi_2607_ = _e2277;
                                                    }
                                                    let _e2279 = phi_2607_;
                                                    let _e2284 = ((_e2279 >> bitcast<u32>(((_e2197 * 8u) & 31u))) & 255u);
                                                    let _e2285 = (_e2284 & 31u);
                                                    if (_e2285 >= 24u) {
                                                        phi_2620_ = (24u + ((_e2285 - 24u) ^ _e1784));
                                                    } else {
                                                        phi_2620_ = _e2285;
                                                    }
                                                    let _e2291 = phi_2620_;
                                                    phi_2625_ = (_e2193 | ((_e2284 >> bitcast<u32>(5i)) << bitcast<u32>((_e2291 & 31u))));
                                                } else {
                                                    phi_2625_ = _e2193;
                                                }
                                                let _e2299 = phi_2625_;
                                                phi_2626_ = _e2299;
                                            } else {
                                                phi_2626_ = _e2193;
                                            }
                                            let _e2301 = phi_2626_;
                                            phi_2627_ = _e2301;
                                        } else {
                                            phi_2627_ = _e2193;
                                        }
                                        let _e2303 = phi_2627_;
                                        phi_2497_ = (_e2191 + 1u);
                                        phi_2500_ = _e2303;
                                    } else {
                                        phi_2497_ = u32();
                                        phi_2500_ = u32();
                                    }
                                    let _e2306 = phi_2497_;
                                    let _e2308 = phi_2500_;
                                    continue;
                                    continuing {
                                        phi_2496_ = _e2306;
                                        phi_2499_ = _e2308;
                                        break if !(_e2194);
                                    }
                                }
                                let _e2312 = nodes.member[(0u + _e1922)].links[0u];
                                let _e2316 = nodes.member[(0u + _e1922)].frame[3u];
                                let _e2320 = local_8;
                                if ((_e2320 & 4278190080u) == 0u) {
                                } else {
                                    let _e2324 = local.group_mask;
                                    if ((_e2324 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2328 = local.len;
                                        if (_e2328 < 32u) {
                                            let _e2331 = local.group;
                                            let _e2333 = local.len;
                                            if (_e2333 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2333)] = _e2331;
                                            let _e2339 = local.group_mask;
                                            let _e2341 = local.len;
                                            if (_e2341 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2341)] = _e2339;
                                            let _e2348 = local.len;
                                            local.len = (_e2348 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2312);
                                    let _e2352 = local_9;
                                    local.group_mask = ((_e2352 & 4278190080u) | (_e2316 >> bitcast<u32>(24i)));
                                }
                                let _e2357 = local_10;
                                phi_2685_ = (_e2357 & 16777215u);
                                phi_2688_ = _e1924;
                                loop {
                                    let _e2360 = phi_2685_;
                                    let _e2362 = phi_2688_;
                                    local_21 = _e2362;
                                    let _e2363 = (_e2360 == 0u);
                                    local_11 = _e2363;
                                    local_22 = _e2363;
                                    if _e2363 {
                                        phi_2686_ = u32();
                                        phi_2689_ = bool();
                                        phi_3286_ = false;
                                    } else {
                                        let _e2366 = nodes.member[(0u + _e1922)].links[1u];
                                        let _e2371 = ((0u + _e2366) + select(firstTrailingBit(_e2360), 32u, (_e2360 == 0u)));
                                        if (_e2371 < _e79) {
                                        } else {
                                            return;
                                        }
                                        let _e2378 = triangles.member[(0u + _e2371)].v0_;
                                        let _e2380 = (_e2378.x - _e126);
                                        let _e2382 = (_e2378.y - _e128);
                                        let _e2384 = (_e2378.z - _e130);
                                        if (_e1757 == 0u) {
                                            phi_2733_ = vec3<f32>(_e2382, _e2384, _e2380);
                                        } else {
                                            if (_e1757 == 1u) {
                                                phi_2732_ = vec3<f32>(_e2384, _e2380, _e2382);
                                            } else {
                                                phi_2732_ = (_e2378 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2392 = phi_2732_;
                                            phi_2733_ = _e2392;
                                        }
                                        let _e2394 = phi_2733_;
                                        let _e2398 = (_e2394.x - (_e1768 * _e2394.z));
                                        let _e2402 = (_e2394.y - (_e1771 * _e2394.z));
                                        let _e2404 = triangles.member[(0u + _e2371)].v1_;
                                        let _e2406 = (_e2404.x - _e126);
                                        let _e2408 = (_e2404.y - _e128);
                                        let _e2410 = (_e2404.z - _e130);
                                        if (_e1757 == 0u) {
                                            phi_2763_ = vec3<f32>(_e2408, _e2410, _e2406);
                                        } else {
                                            if (_e1757 == 1u) {
                                                phi_2762_ = vec3<f32>(_e2410, _e2406, _e2408);
                                            } else {
                                                phi_2762_ = (_e2404 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2418 = phi_2762_;
                                            phi_2763_ = _e2418;
                                        }
                                        let _e2420 = phi_2763_;
                                        let _e2424 = (_e2420.x - (_e1768 * _e2420.z));
                                        let _e2428 = (_e2420.y - (_e1771 * _e2420.z));
                                        let _e2430 = triangles.member[(0u + _e2371)].v2_;
                                        let _e2432 = (_e2430.x - _e126);
                                        let _e2434 = (_e2430.y - _e128);
                                        let _e2436 = (_e2430.z - _e130);
                                        if (_e1757 == 0u) {
                                            phi_2793_ = vec3<f32>(_e2434, _e2436, _e2432);
                                        } else {
                                            if (_e1757 == 1u) {
                                                phi_2792_ = vec3<f32>(_e2436, _e2432, _e2434);
                                            } else {
                                                phi_2792_ = (_e2430 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2444 = phi_2792_;
                                            phi_2793_ = _e2444;
                                        }
                                        let _e2446 = phi_2793_;
                                        let _e2450 = (_e2446.x - (_e1768 * _e2446.z));
                                        let _e2454 = (_e2446.y - (_e1771 * _e2446.z));
                                        if (_e2424 < _e2450) {
                                            phi_2812_ = true;
                                        } else {
                                            if (_e2424 == _e2450) {
                                                phi_2811_ = (_e2428 < _e2454);
                                            } else {
                                                phi_2811_ = false;
                                            }
                                            let _e2459 = phi_2811_;
                                            phi_2812_ = _e2459;
                                        }
                                        let _e2461 = phi_2812_;
                                        if _e2461 {
                                            phi_2816_ = _e2454;
                                            phi_2817_ = _e2450;
                                            phi_2818_ = _e2428;
                                            phi_2819_ = _e2424;
                                        } else {
                                            phi_2816_ = _e2428;
                                            phi_2817_ = _e2424;
                                            phi_2818_ = _e2454;
                                            phi_2819_ = _e2450;
                                        }
                                        let _e2463 = phi_2816_;
                                        let _e2465 = phi_2817_;
                                        let _e2467 = phi_2818_;
                                        let _e2469 = phi_2819_;
                                        let _e2472 = ((_e2469 * _e2463) - (_e2467 * _e2465));
                                        if _e2461 {
                                            phi_2827_ = -(_e2472);
                                        } else {
                                            phi_2827_ = _e2472;
                                        }
                                        let _e2475 = phi_2827_;
                                        if (_e2450 < _e2398) {
                                            phi_2838_ = true;
                                        } else {
                                            if (_e2450 == _e2398) {
                                                phi_2837_ = (_e2454 < _e2402);
                                            } else {
                                                phi_2837_ = false;
                                            }
                                            let _e2480 = phi_2837_;
                                            phi_2838_ = _e2480;
                                        }
                                        let _e2482 = phi_2838_;
                                        if _e2482 {
                                            phi_2842_ = _e2402;
                                            phi_2843_ = _e2398;
                                            phi_2844_ = _e2454;
                                            phi_2845_ = _e2450;
                                        } else {
                                            phi_2842_ = _e2454;
                                            phi_2843_ = _e2450;
                                            phi_2844_ = _e2402;
                                            phi_2845_ = _e2398;
                                        }
                                        let _e2484 = phi_2842_;
                                        let _e2486 = phi_2843_;
                                        let _e2488 = phi_2844_;
                                        let _e2490 = phi_2845_;
                                        let _e2493 = ((_e2490 * _e2484) - (_e2488 * _e2486));
                                        if _e2482 {
                                            phi_2853_ = -(_e2493);
                                        } else {
                                            phi_2853_ = _e2493;
                                        }
                                        let _e2496 = phi_2853_;
                                        if (_e2398 < _e2424) {
                                            phi_2864_ = true;
                                        } else {
                                            if (_e2398 == _e2424) {
                                                phi_2863_ = (_e2402 < _e2428);
                                            } else {
                                                phi_2863_ = false;
                                            }
                                            let _e2501 = phi_2863_;
                                            phi_2864_ = _e2501;
                                        }
                                        let _e2503 = phi_2864_;
                                        if _e2503 {
                                            phi_2868_ = _e2428;
                                            phi_2869_ = _e2424;
                                            phi_2870_ = _e2402;
                                            phi_2871_ = _e2398;
                                        } else {
                                            phi_2868_ = _e2402;
                                            phi_2869_ = _e2398;
                                            phi_2870_ = _e2428;
                                            phi_2871_ = _e2424;
                                        }
                                        let _e2505 = phi_2868_;
                                        let _e2507 = phi_2869_;
                                        let _e2509 = phi_2870_;
                                        let _e2511 = phi_2871_;
                                        let _e2514 = ((_e2511 * _e2505) - (_e2509 * _e2507));
                                        if _e2503 {
                                            phi_2879_ = -(_e2514);
                                        } else {
                                            phi_2879_ = _e2514;
                                        }
                                        let _e2517 = phi_2879_;
                                        if (_e2475 >= 0f) {
                                            if (_e2496 >= 0f) {
                                                if (_e2517 >= 0f) {
                                                    phi_2894_ = ((_e2475 + _e2496) + _e2517);
                                                    phi_2895_ = false;
                                                } else {
                                                    phi_2894_ = f32();
                                                    phi_2895_ = true;
                                                }
                                                let _e2524 = phi_2894_;
                                                let _e2526 = phi_2895_;
                                                phi_2896_ = _e2524;
                                                phi_2897_ = _e2526;
                                            } else {
                                                phi_2896_ = f32();
                                                phi_2897_ = true;
                                            }
                                            let _e2528 = phi_2896_;
                                            let _e2530 = phi_2897_;
                                            phi_2898_ = _e2528;
                                            phi_2899_ = _e2530;
                                        } else {
                                            phi_2898_ = f32();
                                            phi_2899_ = true;
                                        }
                                        let _e2532 = phi_2898_;
                                        let _e2534 = phi_2899_;
                                        if _e2534 {
                                            if (_e2475 <= 0f) {
                                                if (_e2496 <= 0f) {
                                                    let _e2537 = (_e2517 <= 0f);
                                                    if _e2537 {
                                                    }
                                                    phi_2917_ = ((_e2475 + _e2496) + _e2517);
                                                    phi_2918_ = false;
                                                    phi_2919_ = _e2537;
                                                } else {
                                                    phi_2917_ = f32();
                                                    phi_2918_ = true;
                                                    phi_2919_ = false;
                                                }
                                                let _e2541 = phi_2917_;
                                                let _e2543 = phi_2918_;
                                                let _e2545 = phi_2919_;
                                                phi_2920_ = _e2541;
                                                phi_2921_ = _e2543;
                                                phi_2922_ = _e2545;
                                            } else {
                                                phi_2920_ = f32();
                                                phi_2921_ = true;
                                                phi_2922_ = false;
                                            }
                                            let _e2547 = phi_2920_;
                                            let _e2549 = phi_2921_;
                                            let _e2551 = phi_2922_;
                                            if _e2549 {
                                                phi_2926_ = false;
                                            } else {
                                                phi_2926_ = _e2551;
                                            }
                                            let _e2553 = phi_2926_;
                                            phi_2927_ = _e2547;
                                            phi_2928_ = _e2553;
                                        } else {
                                            phi_2927_ = _e2532;
                                            phi_2928_ = true;
                                        }
                                        let _e2555 = phi_2927_;
                                        let _e2557 = phi_2928_;
                                        if _e2557 {
                                            let _e2558 = (_e2555 == 0f);
                                            if _e2558 {
                                                phi_3244_ = lt_bvh_triangle_Intersection();
                                                phi_3245_ = false;
                                            } else {
                                                let _e2560 = triangles.member[(0u + _e2371)].v0_;
                                                let _e2562 = (_e2560.x - _e126);
                                                let _e2564 = (_e2560.y - _e128);
                                                let _e2566 = (_e2560.z - _e130);
                                                if (_e1757 == 0u) {
                                                    phi_2957_ = vec3<f32>(_e2564, _e2566, _e2562);
                                                } else {
                                                    if (_e1757 == 1u) {
                                                        phi_2956_ = vec3<f32>(_e2566, _e2562, _e2564);
                                                    } else {
                                                        phi_2956_ = (_e2560 - vec3<f32>(_e126, _e128, _e130));
                                                    }
                                                    let _e2574 = phi_2956_;
                                                    phi_2957_ = _e2574;
                                                }
                                                let _e2576 = phi_2957_;
                                                let _e2578 = triangles.member[(0u + _e2371)].v1_;
                                                let _e2580 = triangles.member[(0u + _e2371)].v0_;
                                                let _e2583 = (_e2578.x - _e2580.x);
                                                let _e2586 = (_e2578.y - _e2580.y);
                                                let _e2589 = (_e2578.z - _e2580.z);
                                                if (_e1757 == 0u) {
                                                    phi_2983_ = vec3<f32>(_e2586, _e2589, _e2583);
                                                } else {
                                                    if (_e1757 == 1u) {
                                                        phi_2982_ = vec3<f32>(_e2589, _e2583, _e2586);
                                                    } else {
                                                        phi_2982_ = (_e2578 - _e2580);
                                                    }
                                                    let _e2596 = phi_2982_;
                                                    phi_2983_ = _e2596;
                                                }
                                                let _e2598 = phi_2983_;
                                                let _e2600 = triangles.member[(0u + _e2371)].v2_;
                                                let _e2602 = triangles.member[(0u + _e2371)].v0_;
                                                let _e2605 = (_e2600.x - _e2602.x);
                                                let _e2608 = (_e2600.y - _e2602.y);
                                                let _e2611 = (_e2600.z - _e2602.z);
                                                if (_e1757 == 0u) {
                                                    phi_3009_ = vec3<f32>(_e2608, _e2611, _e2605);
                                                } else {
                                                    if (_e1757 == 1u) {
                                                        phi_3008_ = vec3<f32>(_e2611, _e2605, _e2608);
                                                    } else {
                                                        phi_3008_ = (_e2600 - _e2602);
                                                    }
                                                    let _e2618 = phi_3008_;
                                                    phi_3009_ = _e2618;
                                                }
                                                let _e2620 = phi_3009_;
                                                let _e2627 = ((_e2598.y * _e2620.z) - (_e2598.z * _e2620.y));
                                                let _e2634 = ((_e2598.z * _e2620.x) - (_e2598.x * _e2620.z));
                                                let _e2641 = ((_e2598.x * _e2620.y) - (_e2598.y * _e2620.x));
                                                let _e2655 = (((1f / _e1765.z) * (((_e2627 * _e2576.x) + (_e2634 * _e2576.y)) + (_e2641 * _e2576.z))) / (((_e2627 * _e1768) + (_e2634 * _e1771)) + _e2641));
                                                if (_e2655 > 0f) {
                                                    if (_e2655 < _e138) {
                                                        let _e2659 = triangles.member[(0u + _e2371)].v0_;
                                                        let _e2661 = triangles.member[(0u + _e2371)].v1_;
                                                        if (_e2659.x < _e2661.x) {
                                                            phi_3065_ = _e2659.x;
                                                        } else {
                                                            phi_3065_ = _e2661.x;
                                                        }
                                                        let _e2668 = phi_3065_;
                                                        if (_e2659.y < _e2661.y) {
                                                            phi_3074_ = _e2659.y;
                                                        } else {
                                                            phi_3074_ = _e2661.y;
                                                        }
                                                        let _e2675 = phi_3074_;
                                                        if (_e2659.z < _e2661.z) {
                                                            phi_3083_ = _e2659.z;
                                                        } else {
                                                            phi_3083_ = _e2661.z;
                                                        }
                                                        let _e2682 = phi_3083_;
                                                        let _e2684 = triangles.member[(0u + _e2371)].v2_;
                                                        if (_e2668 < _e2684.x) {
                                                            phi_3092_ = _e2668;
                                                        } else {
                                                            phi_3092_ = _e2684.x;
                                                        }
                                                        let _e2689 = phi_3092_;
                                                        if (_e2675 < _e2684.y) {
                                                            phi_3099_ = _e2675;
                                                        } else {
                                                            phi_3099_ = _e2684.y;
                                                        }
                                                        let _e2694 = phi_3099_;
                                                        if (_e2682 < _e2684.z) {
                                                            phi_3106_ = _e2682;
                                                        } else {
                                                            phi_3106_ = _e2684.z;
                                                        }
                                                        let _e2699 = phi_3106_;
                                                        let _e2701 = triangles.member[(0u + _e2371)].v0_;
                                                        let _e2703 = triangles.member[(0u + _e2371)].v1_;
                                                        if (_e2701.x > _e2703.x) {
                                                            phi_3119_ = _e2701.x;
                                                        } else {
                                                            phi_3119_ = _e2703.x;
                                                        }
                                                        let _e2710 = phi_3119_;
                                                        if (_e2701.y > _e2703.y) {
                                                            phi_3128_ = _e2701.y;
                                                        } else {
                                                            phi_3128_ = _e2703.y;
                                                        }
                                                        let _e2717 = phi_3128_;
                                                        if (_e2701.z > _e2703.z) {
                                                            phi_3137_ = _e2701.z;
                                                        } else {
                                                            phi_3137_ = _e2703.z;
                                                        }
                                                        let _e2724 = phi_3137_;
                                                        let _e2726 = triangles.member[(0u + _e2371)].v2_;
                                                        if (_e2710 > _e2726.x) {
                                                            phi_3146_ = _e2710;
                                                        } else {
                                                            phi_3146_ = _e2726.x;
                                                        }
                                                        let _e2731 = phi_3146_;
                                                        if (_e2717 > _e2726.y) {
                                                            phi_3153_ = _e2717;
                                                        } else {
                                                            phi_3153_ = _e2726.y;
                                                        }
                                                        let _e2736 = phi_3153_;
                                                        if (_e2724 > _e2726.z) {
                                                            phi_3160_ = _e2724;
                                                        } else {
                                                            phi_3160_ = _e2726.z;
                                                        }
                                                        let _e2741 = phi_3160_;
                                                        let _e2745 = ((_e2689 - _e126) * _e1682);
                                                        let _e2746 = ((_e2694 - _e128) * _e1692);
                                                        let _e2747 = ((_e2699 - _e130) * _e1702);
                                                        let _e2751 = ((_e2731 - _e126) * _e1682);
                                                        let _e2752 = ((_e2736 - _e128) * _e1692);
                                                        let _e2753 = ((_e2741 - _e130) * _e1702);
                                                        if (_e2745 < _e2751) {
                                                            phi_3177_ = _e2745;
                                                        } else {
                                                            phi_3177_ = _e2751;
                                                        }
                                                        let _e2756 = phi_3177_;
                                                        if (_e2746 < _e2752) {
                                                            phi_3182_ = _e2746;
                                                        } else {
                                                            phi_3182_ = _e2752;
                                                        }
                                                        let _e2759 = phi_3182_;
                                                        if (_e2747 < _e2753) {
                                                            phi_3187_ = _e2747;
                                                        } else {
                                                            phi_3187_ = _e2753;
                                                        }
                                                        let _e2762 = phi_3187_;
                                                        if (_e2745 > _e2751) {
                                                            phi_3195_ = _e2745;
                                                        } else {
                                                            phi_3195_ = _e2751;
                                                        }
                                                        let _e2768 = phi_3195_;
                                                        if (_e2746 > _e2752) {
                                                            phi_3200_ = _e2746;
                                                        } else {
                                                            phi_3200_ = _e2752;
                                                        }
                                                        let _e2771 = phi_3200_;
                                                        if (_e2747 > _e2753) {
                                                            phi_3205_ = _e2747;
                                                        } else {
                                                            phi_3205_ = _e2753;
                                                        }
                                                        let _e2774 = phi_3205_;
                                                        let _e2778 = core_intrinsics_maximum_number_nsz_f32_((_e2756 - _e1741), (_e2759 - _e1742));
                                                        let _e2779 = core_intrinsics_maximum_number_nsz_f32_(_e2778, (_e2762 - _e1743));
                                                        let _e2780 = core_intrinsics_minimum_number_nsz_f32_((_e2768 + _e1741), (_e2771 + _e1742));
                                                        let _e2781 = core_intrinsics_minimum_number_nsz_f32_(_e2780, (_e2774 + _e1743));
                                                        if (_e2779 > -300000000000000000000000000000000000000f) {
                                                            phi_3217_ = _e2779;
                                                        } else {
                                                            phi_3217_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2784 = phi_3217_;
                                                        if (_e2781 < 300000000000000000000000000000000000000f) {
                                                            phi_3222_ = _e2781;
                                                        } else {
                                                            phi_3222_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2787 = phi_3222_;
                                                        if (_e2655 < _e2784) {
                                                            phi_3227_ = _e2784;
                                                        } else {
                                                            phi_3227_ = _e2655;
                                                        }
                                                        let _e2790 = phi_3227_;
                                                        if (_e2790 > _e2787) {
                                                            phi_3232_ = _e2787;
                                                        } else {
                                                            phi_3232_ = _e2790;
                                                        }
                                                        let _e2793 = phi_3232_;
                                                        phi_3237_ = lt_bvh_triangle_Intersection(_e2793, (_e2496 / _e2555), (_e2517 / _e2555), (_e2784 <= _e2787));
                                                        phi_3238_ = false;
                                                    } else {
                                                        phi_3237_ = lt_bvh_triangle_Intersection();
                                                        phi_3238_ = true;
                                                    }
                                                    let _e2799 = phi_3237_;
                                                    let _e2801 = phi_3238_;
                                                    phi_3239_ = _e2799;
                                                    phi_3240_ = _e2801;
                                                } else {
                                                    phi_3239_ = lt_bvh_triangle_Intersection();
                                                    phi_3240_ = true;
                                                }
                                                let _e2803 = phi_3239_;
                                                let _e2805 = phi_3240_;
                                                if _e2805 {
                                                }
                                                phi_3244_ = _e2803;
                                                phi_3245_ = _e2805;
                                            }
                                            let _e2807 = phi_3244_;
                                            let _e2809 = phi_3245_;
                                            phi_3246_ = _e2807;
                                            phi_3247_ = _e2558;
                                            phi_3248_ = _e2809;
                                        } else {
                                            phi_3246_ = lt_bvh_triangle_Intersection();
                                            phi_3247_ = true;
                                            phi_3248_ = false;
                                        }
                                        let _e2811 = phi_3246_;
                                        let _e2813 = phi_3247_;
                                        let _e2815 = phi_3248_;
                                        if _e2813 {
                                            phi_3252_ = true;
                                        } else {
                                            phi_3252_ = _e2815;
                                        }
                                        let _e2817 = phi_3252_;
                                        if _e2817 {
                                            phi_3256_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3256_ = _e2811;
                                        }
                                        let _e2819 = phi_3256_;
                                        if _e2819.is_hit {
                                            if (_e2819.t > 0f) {
                                                if (_e2819.t < _e138) {
                                                    if true {
                                                        phi_3276_ = false;
                                                    } else {
                                                        phi_3276_ = true;
                                                    }
                                                    let _e2828 = phi_3276_;
                                                    phi_3277_ = true;
                                                    phi_3278_ = _e2828;
                                                } else {
                                                    phi_3277_ = _e2362;
                                                    phi_3278_ = true;
                                                }
                                                let _e2830 = phi_3277_;
                                                let _e2832 = phi_3278_;
                                                phi_3279_ = _e2830;
                                                phi_3280_ = _e2832;
                                            } else {
                                                phi_3279_ = _e2362;
                                                phi_3280_ = true;
                                            }
                                            let _e2834 = phi_3279_;
                                            let _e2836 = phi_3280_;
                                            phi_3281_ = _e2834;
                                            phi_3282_ = _e2836;
                                        } else {
                                            phi_3281_ = _e2362;
                                            phi_3282_ = true;
                                        }
                                        let _e2838 = phi_3281_;
                                        let _e2840 = phi_3282_;
                                        if _e2840 {
                                        }
                                        phi_2686_ = (_e2360 & (_e2360 - 1u));
                                        phi_2689_ = _e2838;
                                        phi_3286_ = _e2840;
                                    }
                                    let _e2842 = phi_2686_;
                                    let _e2844 = phi_2689_;
                                    let _e2846 = phi_3286_;
                                    continue;
                                    continuing {
                                        phi_2685_ = _e2842;
                                        phi_2688_ = _e2844;
                                        break if !(_e2846);
                                    }
                                }
                                let _e2849 = local_11;
                                if _e2849 {
                                    let _e2851 = local.group_mask;
                                    if ((_e2851 & 4278190080u) == 0u) {
                                        let _e2855 = local.len;
                                        if (_e2855 == 0u) {
                                            phi_3328_ = false;
                                        } else {
                                            let _e2859 = local.len;
                                            local.len = (_e2859 - 1u);
                                            let _e2862 = local.len;
                                            if (_e2862 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2867 = local.first[(0u + _e2862)];
                                            local.group = _e2867;
                                            let _e2870 = local.len;
                                            if (_e2870 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2875 = local.mask[(0u + _e2870)];
                                            local.group_mask = _e2875;
                                            phi_3328_ = true;
                                        }
                                        let _e2878 = phi_3328_;
                                        phi_3329_ = _e2878;
                                    } else {
                                        phi_3329_ = true;
                                    }
                                    let _e2880 = phi_3329_;
                                    if _e2880 {
                                        let _e2882 = local.group_mask;
                                        let _e2888 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2882)), 32u, (_e2882 == 0u)));
                                        let _e2892 = local.group_mask;
                                        let _e2906 = local.group_mask;
                                        local.group_mask = (_e2906 & ~((1u << bitcast<u32>((_e2888 & 31u)))));
                                        let _e2909 = local.group;
                                        phi_3360_ = (_e2909 + countOneBits(((_e2892 & ~((4294967295u << bitcast<u32>((((_e2888 - 24u) ^ _e1784) & 31u))))) & 255u)));
                                    } else {
                                        phi_3360_ = 4294967295u;
                                    }
                                    let _e2912 = phi_3360_;
                                    phi_3361_ = _e2912;
                                } else {
                                    phi_3361_ = u32();
                                }
                                let _e2914 = phi_3361_;
                                phi_2354_ = _e2914;
                                let _e3451 = local_21;
                                phi_2357_ = _e3451;
                                let _e3454 = local_22;
                                phi_3362_ = _e3454;
                                phi_3363_ = false;
                            } else {
                                phi_2354_ = u32();
                                phi_2357_ = bool();
                                phi_3362_ = false;
                                phi_3363_ = true;
                            }
                            let _e2916 = phi_2354_;
                            let _e2918 = phi_2357_;
                            let _e2920 = phi_3362_;
                            let _e2922 = phi_3363_;
                            local_12 = _e2922;
                            continue;
                            continuing {
                                phi_2353_ = _e2916;
                                phi_2356_ = _e2918;
                                break if !(_e2920);
                            }
                        }
                        let _e2925 = local_12;
                        if _e2925 {
                            phi_3367_ = false;
                        } else {
                            phi_3367_ = true;
                        }
                        let _e2927 = phi_3367_;
                        if _e2927 {
                            phi_3371_ = true;
                        } else {
                            let _e3460 = local_23;
                            phi_3371_ = _e3460;
                        }
                        let _e2929 = phi_3371_;
                        phi_3372_ = _e2929;
                    }
                    let _e2931 = phi_3372_;
                    phi_3373_ = _e2931;
                    phi_3374_ = _e1606;
                } else {
                    phi_3373_ = bool();
                    phi_3374_ = true;
                }
                let _e2933 = phi_3373_;
                let _e2935 = phi_3374_;
                if _e2935 {
                    phi_3378_ = false;
                } else {
                    phi_3378_ = _e2933;
                }
                let _e2937 = phi_3378_;
                phi_3379_ = _e2937;
            }
            let _e2939 = phi_3379_;
            phi_3380_ = _e2939;
        } else {
            phi_3380_ = false;
        }
        let _e2941 = phi_3380_;
        if _e2941 {
            phi_3384_ = 0f;
        } else {
            phi_3384_ = 1f;
        }
        let _e2943 = phi_3384_;
        if (_e105 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e105)] = _e2943;
        let _e2949 = p.member.light.number;
        let _e2950 = (_e2949 * 3u);
        let _e2951 = (_e2950 / 32u);
        let _e2952 = (_e2950 % 32u);
        let _e2954 = p.member.light.mask_words;
        if (_e105 < _e82) {
        } else {
            return;
        }
        let _e2958 = visibility.member[(0u + _e105)];
        let _e2960 = ((_e105 * _e2954) + _e2951);
        if (_e2952 > 29u) {
            let _e2962 = (_e2960 + 1u);
            if (_e2962 < _e88) {
            } else {
                return;
            }
            let _e2966 = bits.member[(0u + _e2962)];
            phi_3425_ = _e2966;
        } else {
            phi_3425_ = 0u;
        }
        let _e2968 = phi_3425_;
        if (_e2960 < _e88) {
        } else {
            return;
        }
        let _e2972 = bits.member[(0u + _e2960)];
        let _e2975 = (_e2972 >> bitcast<u32>((_e2952 & 31u)));
        if (_e2952 > 29u) {
            phi_3444_ = (_e2975 | (_e2968 << bitcast<u32>(((32u - _e2952) & 31u))));
        } else {
            phi_3444_ = _e2975;
        }
        let _e2983 = phi_3444_;
        if ((_e2983 & 2u) == 0u) {
            phi_3452_ = (_e2983 & 1u);
        } else {
            phi_3452_ = (_e2983 & 7u);
        }
        let _e2989 = phi_3452_;
        if ((_e2989 & 1u) != 0u) {
            phi_3460_ = (2u | 1u);
        } else {
            phi_3460_ = 2u;
        }
        let _e2995 = phi_3460_;
        if (_e2958 < 0.5f) {
            phi_3465_ = (_e2995 | 4u);
        } else {
            phi_3465_ = _e2995;
        }
        let _e2998 = phi_3465_;
        let _e3000 = ((_e105 * _e2954) + _e2951);
        if (_e3000 < _e88) {
        } else {
            return;
        }
        let _e3004 = bits.member[(0u + _e3000)];
        if (_e3000 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e3000)] = ((_e3004 & ~((7u << bitcast<u32>((_e2952 & 31u))))) | (_e2998 << bitcast<u32>((_e2952 & 31u))));
        if (_e2952 > 29u) {
            let _e3018 = (_e3000 + 1u);
            if (_e3018 < _e88) {
            } else {
                return;
            }
            let _e3022 = bits.member[(0u + _e3018)];
            let _e3023 = (32u - _e2952);
            let _e3033 = (_e3000 + 1u);
            if (_e3033 < _e88) {
            } else {
                return;
            }
            bits.member[(0u + _e3033)] = ((_e3022 & ~((7u >> bitcast<u32>((_e3023 & 31u))))) | (_e2998 >> bitcast<u32>((_e3023 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
