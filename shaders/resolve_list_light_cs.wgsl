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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
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

struct type_36 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_40 {
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

struct type_44 {
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

struct type_51 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_27;
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> nodes: type_40;
@group(0) @binding(3) 
var<storage> triangles: type_44;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage> rows: type_13;
@group(0) @binding(7) 
var<uniform> space: type_51;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_177_: bool;
    var phi_181_: f32;

    if (param != param) {
        phi_177_ = true;
    } else {
        let _e66 = (param_1 >= param);
        if _e66 {
        }
        phi_177_ = _e66;
    }
    let _e68 = phi_177_;
    if _e68 {
        phi_181_ = param_1;
    } else {
        phi_181_ = param;
    }
    let _e70 = phi_181_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_193_: bool;
    var phi_197_: f32;

    if (param_2 != param_2) {
        phi_193_ = true;
    } else {
        let _e66 = (param_3 <= param_2);
        if _e66 {
        }
        phi_193_ = _e66;
    }
    let _e68 = phi_193_;
    if _e68 {
        phi_197_ = param_3;
    } else {
        phi_197_ = param_2;
    }
    let _e70 = phi_197_;
    return _e70;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: array<u32, 32>;
    var phi_283_: f32;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_323_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_343_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_370_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_402_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_421_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_448_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_477_: u32;
    var phi_478_: f32;
    var phi_479_: u32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_496_: u32;
    var phi_506_: u32;
    var phi_512_: u32;
    var phi_513_: u32;
    var phi_514_: u32;
    var phi_525_: vec3<f32>;
    var phi_526_: vec3<f32>;
    var phi_548_: vec3<f32>;
    var phi_549_: vec3<f32>;
    var phi_571_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_646_: f32;
    var phi_653_: f32;
    var phi_660_: f32;
    var phi_667_: f32;
    var phi_674_: f32;
    var phi_681_: f32;
    var phi_698_: f32;
    var phi_703_: f32;
    var phi_708_: f32;
    var phi_713_: f32;
    var phi_718_: f32;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_749_: u32;
    var phi_750_: u32;
    var phi_761_: vec3<f32>;
    var phi_762_: vec3<f32>;
    var phi_774_: u32;
    var phi_777_: u32;
    var phi_782_: u32;
    var phi_784_: u32;
    var phi_786_: u32;
    var phi_788_: u32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_875_: u32;
    var phi_898_: f32;
    var phi_899_: f32;
    var phi_913_: u32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_950_: u32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_988_: u32;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1186_: u32;
    var phi_1187_: u32;
    var phi_1188_: u32;
    var phi_785_: u32;
    var phi_787_: u32;
    var phi_1189_: u32;
    var phi_1207_: u32;
    var phi_1208_: u32;
    var phi_775_: u32;
    var phi_778_: u32;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var local_2: bool;
    var local_3: u32;
    var phi_1228_: u32;
    var local_4: u32;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_1270_: u32;
    var phi_1298_: vec3<f32>;
    var phi_1299_: vec3<f32>;
    var phi_1328_: vec3<f32>;
    var phi_1329_: vec3<f32>;
    var phi_1358_: vec3<f32>;
    var phi_1359_: vec3<f32>;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1382_: f32;
    var phi_1383_: f32;
    var phi_1384_: f32;
    var phi_1385_: f32;
    var phi_1393_: f32;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1408_: f32;
    var phi_1409_: f32;
    var phi_1410_: f32;
    var phi_1411_: f32;
    var phi_1419_: f32;
    var phi_1429_: bool;
    var phi_1430_: bool;
    var phi_1434_: f32;
    var phi_1435_: f32;
    var phi_1436_: f32;
    var phi_1437_: f32;
    var phi_1445_: f32;
    var phi_1460_: f32;
    var phi_1461_: bool;
    var phi_1462_: f32;
    var phi_1463_: bool;
    var phi_1464_: f32;
    var phi_1465_: bool;
    var phi_1483_: f32;
    var phi_1484_: bool;
    var phi_1485_: bool;
    var phi_1486_: f32;
    var phi_1487_: bool;
    var phi_1488_: bool;
    var phi_1492_: bool;
    var phi_1493_: f32;
    var phi_1494_: bool;
    var phi_1522_: vec3<f32>;
    var phi_1523_: vec3<f32>;
    var phi_1548_: vec3<f32>;
    var phi_1549_: vec3<f32>;
    var phi_1574_: vec3<f32>;
    var phi_1575_: vec3<f32>;
    var phi_1631_: f32;
    var phi_1640_: f32;
    var phi_1649_: f32;
    var phi_1658_: f32;
    var phi_1665_: f32;
    var phi_1672_: f32;
    var phi_1685_: f32;
    var phi_1694_: f32;
    var phi_1703_: f32;
    var phi_1712_: f32;
    var phi_1719_: f32;
    var phi_1726_: f32;
    var phi_1743_: f32;
    var phi_1748_: f32;
    var phi_1753_: f32;
    var phi_1761_: f32;
    var phi_1766_: f32;
    var phi_1771_: f32;
    var phi_1783_: f32;
    var phi_1788_: f32;
    var phi_1793_: f32;
    var phi_1798_: f32;
    var phi_1803_: lt_bvh_triangle_Intersection;
    var phi_1804_: bool;
    var phi_1805_: lt_bvh_triangle_Intersection;
    var phi_1806_: bool;
    var phi_1810_: lt_bvh_triangle_Intersection;
    var phi_1811_: bool;
    var phi_1812_: lt_bvh_triangle_Intersection;
    var phi_1813_: bool;
    var phi_1814_: bool;
    var phi_1818_: bool;
    var phi_1822_: lt_bvh_triangle_Intersection;
    var phi_1847_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1857_: bool;
    var phi_1858_: bool;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1866_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var phi_1878_: bool;
    var local_5: bool;
    var phi_1882_: bool;
    var phi_1883_: bool;
    var phi_1884_: bool;
    var phi_1885_: bool;
    var phi_1886_: bool;
    var local_6: u32;
    var phi_1894_: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var phi_1897_: bool;
    var local_7: bool;
    var phi_1901_: bool;
    var phi_1905_: bool;
    var phi_1909_: bool;
    var phi_1910_: bool;
    var phi_1926_: bool;
    var phi_1927_: bool;
    var phi_1928_: bool;
    var phi_1929_: bool;
    var phi_1933_: bool;
    var phi_1946_: bool;
    var phi_1947_: bool;
    var phi_1948_: bool;
    var phi_1949_: bool;
    var phi_1953_: bool;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1968_: bool;
    var phi_1972_: bool;
    var phi_1973_: bool;
    var phi_1974_: bool;
    var phi_1975_: bool;
    var phi_1976_: bool;
    var phi_1980_: bool;
    var phi_2050_: f32;
    var phi_2057_: f32;
    var phi_2064_: f32;
    var phi_2071_: f32;
    var phi_2078_: f32;
    var phi_2085_: f32;
    var phi_2102_: f32;
    var phi_2107_: f32;
    var phi_2112_: f32;
    var phi_2117_: f32;
    var phi_2122_: f32;
    var phi_2148_: bool;
    var phi_2149_: bool;
    var phi_2157_: u32;
    var phi_2158_: u32;
    var phi_2169_: vec3<f32>;
    var phi_2170_: vec3<f32>;
    var phi_2183_: u32;
    var phi_2188_: u32;
    var phi_2193_: u32;
    var phi_2307_: bool;
    var phi_2308_: bool;
    var phi_2339_: u32;
    var phi_2341_: u32;
    var phi_2344_: bool;
    var phi_2424_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2451_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2478_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2484_: u32;
    var phi_2487_: u32;
    var phi_2501_: u32;
    var phi_2511_: u32;
    var phi_2521_: u32;
    var phi_2539_: u32;
    var phi_2549_: u32;
    var phi_2559_: u32;
    var phi_2595_: u32;
    var phi_2608_: u32;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_2615_: u32;
    var phi_2485_: u32;
    var phi_2488_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_2673_: u32;
    var phi_2676_: bool;
    var phi_2720_: vec3<f32>;
    var phi_2721_: vec3<f32>;
    var phi_2750_: vec3<f32>;
    var phi_2751_: vec3<f32>;
    var phi_2780_: vec3<f32>;
    var phi_2781_: vec3<f32>;
    var phi_2799_: bool;
    var phi_2800_: bool;
    var phi_2804_: f32;
    var phi_2805_: f32;
    var phi_2806_: f32;
    var phi_2807_: f32;
    var phi_2815_: f32;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2830_: f32;
    var phi_2831_: f32;
    var phi_2832_: f32;
    var phi_2833_: f32;
    var phi_2841_: f32;
    var phi_2851_: bool;
    var phi_2852_: bool;
    var phi_2856_: f32;
    var phi_2857_: f32;
    var phi_2858_: f32;
    var phi_2859_: f32;
    var phi_2867_: f32;
    var phi_2882_: f32;
    var phi_2883_: bool;
    var phi_2884_: f32;
    var phi_2885_: bool;
    var phi_2886_: f32;
    var phi_2887_: bool;
    var phi_2905_: f32;
    var phi_2906_: bool;
    var phi_2907_: bool;
    var phi_2908_: f32;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2914_: bool;
    var phi_2915_: f32;
    var phi_2916_: bool;
    var phi_2944_: vec3<f32>;
    var phi_2945_: vec3<f32>;
    var phi_2970_: vec3<f32>;
    var phi_2971_: vec3<f32>;
    var phi_2996_: vec3<f32>;
    var phi_2997_: vec3<f32>;
    var phi_3053_: f32;
    var phi_3062_: f32;
    var phi_3071_: f32;
    var phi_3080_: f32;
    var phi_3087_: f32;
    var phi_3094_: f32;
    var phi_3107_: f32;
    var phi_3116_: f32;
    var phi_3125_: f32;
    var phi_3134_: f32;
    var phi_3141_: f32;
    var phi_3148_: f32;
    var phi_3165_: f32;
    var phi_3170_: f32;
    var phi_3175_: f32;
    var phi_3183_: f32;
    var phi_3188_: f32;
    var phi_3193_: f32;
    var phi_3205_: f32;
    var phi_3210_: f32;
    var phi_3215_: f32;
    var phi_3220_: f32;
    var phi_3225_: lt_bvh_triangle_Intersection;
    var phi_3226_: bool;
    var phi_3227_: lt_bvh_triangle_Intersection;
    var phi_3228_: bool;
    var phi_3232_: lt_bvh_triangle_Intersection;
    var phi_3233_: bool;
    var phi_3234_: lt_bvh_triangle_Intersection;
    var phi_3235_: bool;
    var phi_3236_: bool;
    var phi_3240_: bool;
    var phi_3244_: lt_bvh_triangle_Intersection;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_2674_: u32;
    var phi_2677_: bool;
    var phi_3274_: bool;
    var local_11: bool;
    var phi_3316_: bool;
    var phi_3317_: bool;
    var phi_3348_: u32;
    var phi_3349_: u32;
    var phi_2342_: u32;
    var phi_2345_: bool;
    var phi_3350_: bool;
    var phi_3351_: bool;
    var local_12: bool;
    var phi_3355_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3361_: bool;
    var phi_3362_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3368_: bool;
    var phi_3372_: f32;
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

    let _e65 = id_1;
    let _e72 = arrayLength((&nodes.member));
    let _e75 = arrayLength((&triangles.member));
    let _e81 = arrayLength((&list.member));
    let _e84 = arrayLength((&rows.member));
    let _e89 = ((_e65.y * 2097152u) + _e65.x);
    if (3u < _e81) {
    } else {
        return;
    }
    let _e92 = list.member[3u];
    if (_e89 < _e92) {
        let _e94 = (_e89 + 4u);
        if (_e94 < _e81) {
        } else {
            return;
        }
        let _e98 = list.member[(0u + _e94)];
        let _e99 = (_e98 & 2147483647u);
        let _e100 = space.member;
        if (_e99 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e106 = samples.member[(0u + _e99)].position;
        let _e108 = samples.member[(0u + _e99)].normal;
        let _e110 = samples.member[(0u + _e99)].magnitude;
        let _e112 = ((8f / 8388608f) * _e110);
        let _e114 = (_e108.x * _e112);
        let _e116 = (_e108.y * _e112);
        let _e118 = (_e108.z * _e112);
        let _e120 = (_e106.x + _e114);
        let _e122 = (_e106.y + _e116);
        let _e124 = (_e106.z + _e118);
        let _e128 = p.member.light.place;
        if (_e128.w == 0f) {
            phi_283_ = 300000000000000000000000000000000000000f;
        } else {
            phi_283_ = 1f;
        }
        let _e132 = phi_283_;
        let _e140 = (_e128.x - (_e120 * _e128.w));
        let _e141 = (_e128.y - (_e122 * _e128.w));
        let _e142 = (_e128.z - (_e124 * _e128.w));
        let _e143 = vec3<f32>(_e140, _e141, _e142);
        let _e144 = abs(_e140);
        let _e145 = abs(_e141);
        let _e146 = abs(_e142);
        if (abs(_e120) < 1000000000000000f) {
            if (abs(_e122) < 1000000000000000f) {
                phi_316_ = (abs(_e124) < 1000000000000000f);
                phi_317_ = false;
            } else {
                phi_316_ = bool();
                phi_317_ = true;
            }
            let _e154 = phi_316_;
            let _e156 = phi_317_;
            phi_318_ = _e154;
            phi_319_ = _e156;
        } else {
            phi_318_ = bool();
            phi_319_ = true;
        }
        let _e158 = phi_318_;
        let _e160 = phi_319_;
        if _e160 {
            phi_323_ = false;
        } else {
            phi_323_ = _e158;
        }
        let _e162 = phi_323_;
        if _e162 {
            if (_e144 < 1000000000000000f) {
                if (_e145 < 1000000000000000f) {
                    phi_336_ = (_e146 < 1000000000000000f);
                    phi_337_ = false;
                } else {
                    phi_336_ = bool();
                    phi_337_ = true;
                }
                let _e167 = phi_336_;
                let _e169 = phi_337_;
                phi_338_ = _e167;
                phi_339_ = _e169;
            } else {
                phi_338_ = bool();
                phi_339_ = true;
            }
            let _e171 = phi_338_;
            let _e173 = phi_339_;
            if _e173 {
                phi_343_ = false;
            } else {
                phi_343_ = _e171;
            }
            let _e175 = phi_343_;
            if _e175 {
                if (_e144 > 0f) {
                    phi_357_ = bool();
                    phi_358_ = true;
                } else {
                    let _e177 = (_e145 > 0f);
                    if _e177 {
                        phi_356_ = bool();
                    } else {
                        phi_356_ = (_e146 > 0f);
                    }
                    let _e180 = phi_356_;
                    phi_357_ = _e180;
                    phi_358_ = _e177;
                }
                let _e182 = phi_357_;
                let _e184 = phi_358_;
                if _e184 {
                    phi_362_ = true;
                } else {
                    phi_362_ = _e182;
                }
                let _e186 = phi_362_;
                phi_363_ = _e186;
                phi_364_ = false;
            } else {
                phi_363_ = bool();
                phi_364_ = true;
            }
            let _e188 = phi_363_;
            let _e190 = phi_364_;
            phi_365_ = _e188;
            phi_366_ = _e190;
        } else {
            phi_365_ = bool();
            phi_366_ = true;
        }
        let _e192 = phi_365_;
        let _e194 = phi_366_;
        if _e194 {
            phi_370_ = false;
        } else {
            phi_370_ = _e192;
        }
        let _e196 = phi_370_;
        if _e196 {
            if (_e100.low.x <= _e120) {
                if (_e120 <= _e100.high.x) {
                    if (_e100.low.y <= _e122) {
                        phi_393_ = (_e122 <= _e100.high.y);
                        phi_394_ = false;
                    } else {
                        phi_393_ = bool();
                        phi_394_ = true;
                    }
                    let _e214 = phi_393_;
                    let _e216 = phi_394_;
                    phi_395_ = _e214;
                    phi_396_ = _e216;
                } else {
                    phi_395_ = bool();
                    phi_396_ = true;
                }
                let _e218 = phi_395_;
                let _e220 = phi_396_;
                phi_397_ = _e218;
                phi_398_ = _e220;
            } else {
                phi_397_ = bool();
                phi_398_ = true;
            }
            let _e222 = phi_397_;
            let _e224 = phi_398_;
            if _e224 {
                phi_402_ = false;
            } else {
                phi_402_ = _e222;
            }
            let _e226 = phi_402_;
            if (abs(_e140) > 0.000000000000000000000000000001f) {
                phi_416_ = bool();
                phi_417_ = true;
            } else {
                let _e231 = (abs(_e141) > 0.000000000000000000000000000001f);
                if _e231 {
                    phi_415_ = bool();
                } else {
                    phi_415_ = (abs(_e142) > 0.000000000000000000000000000001f);
                }
                let _e234 = phi_415_;
                phi_416_ = _e234;
                phi_417_ = _e231;
            }
            let _e236 = phi_416_;
            let _e238 = phi_417_;
            if _e238 {
                phi_421_ = true;
            } else {
                phi_421_ = _e236;
            }
            let _e240 = phi_421_;
            if _e226 {
                if (_e100.low.z <= _e124) {
                    if (_e124 <= _e100.high.z) {
                        if (_e100.is_parallel == 0u) {
                            phi_438_ = _e240;
                        } else {
                            phi_438_ = true;
                        }
                        let _e246 = phi_438_;
                        phi_439_ = _e246;
                        phi_440_ = false;
                    } else {
                        phi_439_ = bool();
                        phi_440_ = true;
                    }
                    let _e248 = phi_439_;
                    let _e250 = phi_440_;
                    phi_441_ = _e248;
                    phi_442_ = _e250;
                } else {
                    phi_441_ = bool();
                    phi_442_ = true;
                }
                let _e252 = phi_441_;
                let _e254 = phi_442_;
                phi_443_ = _e252;
                phi_444_ = _e254;
            } else {
                phi_443_ = bool();
                phi_444_ = true;
            }
            let _e256 = phi_443_;
            let _e258 = phi_444_;
            if _e258 {
                phi_448_ = false;
            } else {
                phi_448_ = _e256;
            }
            let _e260 = phi_448_;
            if _e260 {
                if (_e100.is_parallel == 0u) {
                    let _e263 = abs(_e140);
                    let _e264 = abs(_e141);
                    let _e265 = abs(_e142);
                    if (_e263 >= _e264) {
                        if (_e263 >= _e265) {
                            phi_468_ = false;
                        } else {
                            phi_468_ = true;
                        }
                        let _e269 = phi_468_;
                        phi_469_ = _e269;
                    } else {
                        phi_469_ = true;
                    }
                    let _e271 = phi_469_;
                    if _e271 {
                        if (_e264 >= _e265) {
                            phi_477_ = 1u;
                            phi_478_ = _e141;
                        } else {
                            phi_477_ = 2u;
                            phi_478_ = _e142;
                        }
                        let _e274 = phi_477_;
                        let _e276 = phi_478_;
                        phi_479_ = _e274;
                        phi_480_ = _e276;
                    } else {
                        phi_479_ = 0u;
                        phi_480_ = _e140;
                    }
                    let _e278 = phi_479_;
                    let _e280 = phi_480_;
                    if (_e280 < 0f) {
                        phi_485_ = -1f;
                    } else {
                        phi_485_ = 1f;
                    }
                    let _e283 = phi_485_;
                    let _e284 = (_e283 < 0f);
                    if (_e278 == 0u) {
                        if _e284 {
                            phi_496_ = _e100.roots.y;
                        } else {
                            phi_496_ = _e100.roots.x;
                        }
                        let _e291 = phi_496_;
                        phi_514_ = _e291;
                    } else {
                        if (_e278 == 1u) {
                            if _e284 {
                                phi_506_ = _e100.roots.w;
                            } else {
                                phi_506_ = _e100.roots.z;
                            }
                            let _e298 = phi_506_;
                            phi_513_ = _e298;
                        } else {
                            if _e284 {
                                phi_512_ = _e100.roots_z.y;
                            } else {
                                phi_512_ = _e100.roots_z.x;
                            }
                            let _e304 = phi_512_;
                            phi_513_ = _e304;
                        }
                        let _e306 = phi_513_;
                        phi_514_ = _e306;
                    }
                    let _e308 = phi_514_;
                    if (_e278 == 0u) {
                        phi_526_ = vec3<f32>(_e141, _e142, _e140);
                    } else {
                        if (_e278 == 1u) {
                            phi_525_ = vec3<f32>(_e142, _e140, _e141);
                        } else {
                            phi_525_ = _e143;
                        }
                        let _e314 = phi_525_;
                        phi_526_ = _e314;
                    }
                    let _e316 = phi_526_;
                    phi_571_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e316.x / _e316.z), (_e316.y / _e316.z), (_e283 / _e316.z)), _e308);
                } else {
                    if (_e100.axis == 0u) {
                        phi_549_ = vec3<f32>(_e122, _e124, _e120);
                    } else {
                        if (_e100.axis == 1u) {
                            phi_548_ = vec3<f32>(_e124, _e120, _e122);
                        } else {
                            phi_548_ = (_e106 + vec3<f32>(_e114, _e116, _e118));
                        }
                        let _e333 = phi_548_;
                        phi_549_ = _e333;
                    }
                    let _e335 = phi_549_;
                    let _e350 = (_e335.z - _e100.middle.z);
                    phi_571_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e335.x - _e100.middle.x) - (_e100.shear.x * _e350)), ((_e335.y - _e100.middle.y) - (_e100.shear.y * _e350)), (_e100.sign * _e350)), _e100.roots.x);
                }
                let _e361 = phi_571_;
                if (_e361.unnamed_1 == 4294967295u) {
                    phi_1910_ = false;
                } else {
                    if (0u < _e72) {
                    } else {
                        return;
                    }
                    let _e378 = nodes.member[0u].frame[0u];
                    let _e382 = nodes.member[0u].frame[1u];
                    let _e386 = nodes.member[0u].frame[2u];
                    let _e390 = nodes.member[0u].frame[0u];
                    let _e394 = nodes.member[0u].frame[1u];
                    let _e398 = nodes.member[0u].frame[2u];
                    let _e402 = nodes.member[0u].frame[3u];
                    let _e436 = core_intrinsics_maximum_number_nsz_f32_(abs(_e140), abs(_e141));
                    let _e437 = core_intrinsics_maximum_number_nsz_f32_(_e436, abs(_e142));
                    let _e438 = (_e437 * 0.0000000000009094947f);
                    if (abs(_e140) < _e438) {
                        phi_646_ = _e438;
                    } else {
                        phi_646_ = abs(_e140);
                    }
                    let _e443 = phi_646_;
                    if (_e140 < 0f) {
                        phi_653_ = (-1f / _e443);
                    } else {
                        phi_653_ = (1f / _e443);
                    }
                    let _e448 = phi_653_;
                    if (abs(_e141) < _e438) {
                        phi_660_ = _e438;
                    } else {
                        phi_660_ = abs(_e141);
                    }
                    let _e453 = phi_660_;
                    if (_e141 < 0f) {
                        phi_667_ = (-1f / _e453);
                    } else {
                        phi_667_ = (1f / _e453);
                    }
                    let _e458 = phi_667_;
                    if (abs(_e142) < _e438) {
                        phi_674_ = _e438;
                    } else {
                        phi_674_ = abs(_e142);
                    }
                    let _e463 = phi_674_;
                    if (_e142 < 0f) {
                        phi_681_ = (-1f / _e463);
                    } else {
                        phi_681_ = (1f / _e463);
                    }
                    let _e468 = phi_681_;
                    let _e472 = abs((bitcast<f32>(_e378) - _e120));
                    let _e473 = abs((bitcast<f32>(_e382) - _e122));
                    let _e474 = abs((bitcast<f32>(_e386) - _e124));
                    let _e478 = abs(((bitcast<f32>(_e390) + (bitcast<f32>((((_e402 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                    let _e479 = abs(((bitcast<f32>(_e394) + (bitcast<f32>((((_e402 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                    let _e480 = abs(((bitcast<f32>(_e398) + (bitcast<f32>((((_e402 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e124));
                    if (_e472 > _e478) {
                        phi_698_ = _e472;
                    } else {
                        phi_698_ = _e478;
                    }
                    let _e483 = phi_698_;
                    if (_e473 > _e479) {
                        phi_703_ = _e473;
                    } else {
                        phi_703_ = _e479;
                    }
                    let _e486 = phi_703_;
                    if (_e474 > _e480) {
                        phi_708_ = _e474;
                    } else {
                        phi_708_ = _e480;
                    }
                    let _e489 = phi_708_;
                    if (_e483 > _e486) {
                        phi_713_ = _e483;
                    } else {
                        phi_713_ = _e486;
                    }
                    let _e492 = phi_713_;
                    if (_e492 > _e489) {
                        phi_718_ = _e492;
                    } else {
                        phi_718_ = _e489;
                    }
                    let _e495 = phi_718_;
                    let _e502 = (_e495 * 0.0000009536743f);
                    let _e503 = (abs(_e448) * _e502);
                    let _e504 = (abs(_e458) * _e502);
                    let _e505 = (abs(_e468) * _e502);
                    let _e506 = abs(_e140);
                    let _e507 = abs(_e141);
                    let _e508 = abs(_e142);
                    if (_e506 >= _e507) {
                        if (_e506 >= _e508) {
                            phi_740_ = false;
                        } else {
                            phi_740_ = true;
                        }
                        let _e512 = phi_740_;
                        phi_741_ = _e512;
                    } else {
                        phi_741_ = true;
                    }
                    let _e514 = phi_741_;
                    if _e514 {
                        if (_e507 >= _e508) {
                            phi_749_ = 1u;
                        } else {
                            phi_749_ = 2u;
                        }
                        let _e517 = phi_749_;
                        phi_750_ = _e517;
                    } else {
                        phi_750_ = 0u;
                    }
                    let _e519 = phi_750_;
                    if (_e519 == 0u) {
                        phi_762_ = vec3<f32>(_e141, _e142, _e140);
                    } else {
                        if (_e519 == 1u) {
                            phi_761_ = vec3<f32>(_e142, _e140, _e141);
                        } else {
                            phi_761_ = _e143;
                        }
                        let _e525 = phi_761_;
                        phi_762_ = _e525;
                    }
                    let _e527 = phi_762_;
                    let _e530 = (_e527.x / _e527.z);
                    let _e533 = (_e527.y / _e527.z);
                    local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_774_ = ((_e361.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_777_ = 0u;
                    loop {
                        let _e540 = phi_774_;
                        let _e542 = phi_777_;
                        phi_782_ = _e540;
                        phi_784_ = 0u;
                        phi_786_ = 0u;
                        phi_788_ = _e542;
                        loop {
                            let _e544 = phi_782_;
                            let _e546 = phi_784_;
                            let _e548 = phi_786_;
                            let _e550 = phi_788_;
                            let _e557 = (((_e544 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e544), 32u, (_e544 == 0u))) * 5u);
                            if (_e557 < _e84) {
                            } else {
                                return;
                            }
                            let _e561 = rows.member[(0u + _e557)];
                            let _e562 = (_e557 + 1u);
                            if (_e562 < _e84) {
                            } else {
                                return;
                            }
                            let _e566 = rows.member[(0u + _e562)];
                            let _e567 = (_e557 + 2u);
                            if (_e567 < _e84) {
                            } else {
                                return;
                            }
                            let _e571 = rows.member[(0u + _e567)];
                            let _e572 = (_e557 + 3u);
                            if (_e572 < _e84) {
                            } else {
                                return;
                            }
                            let _e576 = rows.member[(0u + _e572)];
                            let _e577 = (_e557 + 4u);
                            if (_e577 < _e84) {
                            } else {
                                return;
                            }
                            let _e581 = rows.member[(0u + _e577)];
                            let _e582 = lt_bvh_Node(_e561, _e566, _e571, _e576, _e581);
                            let _e584 = (_e544 & (_e544 - 1u));
                            let _e596 = (_e361.unnamed.positive_exponent - bitcast<f32>(_e582.frame.x));
                            let _e599 = bitcast<f32>((((_e582.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e596 > 0f) {
                                if (_e596 < (255f * _e599)) {
                                    phi_860_ = (_e596 / _e599);
                                } else {
                                    phi_860_ = 255f;
                                }
                                let _e605 = phi_860_;
                                phi_861_ = _e605;
                            } else {
                                phi_861_ = 0f;
                            }
                            let _e607 = phi_861_;
                            let _e614 = select(select(u32(_e607), 0u, (_e607 < bitcast<f32>(0u))), 4294967295u, (_e607 > bitcast<f32>(1333788671u)));
                            if (f32(_e614) < _e607) {
                                phi_875_ = (_e614 + 1u);
                            } else {
                                phi_875_ = _e614;
                            }
                            let _e619 = phi_875_;
                            let _e620 = (_e614 * 16843009u);
                            let _e621 = (_e619 * 16843009u);
                            let _e631 = (_e361.unnamed.negative_exponent - bitcast<f32>(_e582.frame.y));
                            let _e634 = bitcast<f32>((((_e582.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e631 > 0f) {
                                if (_e631 < (255f * _e634)) {
                                    phi_898_ = (_e631 / _e634);
                                } else {
                                    phi_898_ = 255f;
                                }
                                let _e640 = phi_898_;
                                phi_899_ = _e640;
                            } else {
                                phi_899_ = 0f;
                            }
                            let _e642 = phi_899_;
                            let _e649 = select(select(u32(_e642), 0u, (_e642 < bitcast<f32>(0u))), 4294967295u, (_e642 > bitcast<f32>(1333788671u)));
                            if (f32(_e649) < _e642) {
                                phi_913_ = (_e649 + 1u);
                            } else {
                                phi_913_ = _e649;
                            }
                            let _e654 = phi_913_;
                            let _e655 = (_e649 * 16843009u);
                            let _e656 = (_e654 * 16843009u);
                            let _e665 = (((_e100.diagonal.x * _e361.unnamed.positive_exponent) + (_e100.diagonal.y * _e361.unnamed.negative_exponent)) - bitcast<f32>(_e582.frame.z));
                            let _e668 = bitcast<f32>((((_e582.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e665 > 0f) {
                                if (_e665 < (255f * _e668)) {
                                    phi_935_ = (_e665 / _e668);
                                } else {
                                    phi_935_ = 255f;
                                }
                                let _e674 = phi_935_;
                                phi_936_ = _e674;
                            } else {
                                phi_936_ = 0f;
                            }
                            let _e676 = phi_936_;
                            let _e683 = select(select(u32(_e676), 0u, (_e676 < bitcast<f32>(0u))), 4294967295u, (_e676 > bitcast<f32>(1333788671u)));
                            if (f32(_e683) < _e676) {
                                phi_950_ = (_e683 + 1u);
                            } else {
                                phi_950_ = _e683;
                            }
                            let _e688 = phi_950_;
                            let _e689 = (_e683 * 16843009u);
                            let _e690 = (_e688 * 16843009u);
                            let _e700 = (_e361.unnamed.min_variance - bitcast<f32>(_e582.frame.w));
                            let _e703 = bitcast<f32>((((_e582.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e700 > 0f) {
                                if (_e700 < (255f * _e703)) {
                                    phi_973_ = (_e700 / _e703);
                                } else {
                                    phi_973_ = 255f;
                                }
                                let _e709 = phi_973_;
                                phi_974_ = _e709;
                            } else {
                                phi_974_ = 0f;
                            }
                            let _e711 = phi_974_;
                            let _e718 = select(select(u32(_e711), 0u, (_e711 < bitcast<f32>(0u))), 4294967295u, (_e711 > bitcast<f32>(1333788671u)));
                            if (f32(_e718) < _e711) {
                                phi_988_ = (_e718 + 1u);
                            } else {
                                phi_988_ = _e718;
                            }
                            let _e723 = phi_988_;
                            let _e724 = (_e723 * 16843009u);
                            let _e905 = (((((((((((_e620 & ~(_e582.links.x)) | (~((_e582.links.x ^ _e620)) & ((_e620 | 2155905152u) - (_e582.links.x & 2139062143u)))) & ((_e582.links.z & ~(_e621)) | (~((_e621 ^ _e582.links.z)) & ((_e582.links.z | 2155905152u) - (_e621 & 2139062143u))))) & (((_e655 & ~(_e582.x.x)) | (~((_e582.x.x ^ _e655)) & ((_e655 | 2155905152u) - (_e582.x.x & 2139062143u)))) & ((_e582.x.z & ~(_e656)) | (~((_e656 ^ _e582.x.z)) & ((_e582.x.z | 2155905152u) - (_e656 & 2139062143u)))))) & (((_e689 & ~(_e582.y.x)) | (~((_e582.y.x ^ _e689)) & ((_e689 | 2155905152u) - (_e582.y.x & 2139062143u)))) & ((_e582.y.z & ~(_e690)) | (~((_e690 ^ _e582.y.z)) & ((_e582.y.z | 2155905152u) - (_e690 & 2139062143u)))))) & ((_e582.z.x & ~(_e724)) | (~((_e724 ^ _e582.z.x)) & ((_e582.z.x | 2155905152u) - (_e724 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e620 & ~(_e582.links.y)) | (~((_e582.links.y ^ _e620)) & ((_e620 | 2155905152u) - (_e582.links.y & 2139062143u)))) & ((_e582.links.w & ~(_e621)) | (~((_e621 ^ _e582.links.w)) & ((_e582.links.w | 2155905152u) - (_e621 & 2139062143u))))) & (((_e655 & ~(_e582.x.y)) | (~((_e582.x.y ^ _e655)) & ((_e655 | 2155905152u) - (_e582.x.y & 2139062143u)))) & ((_e582.x.w & ~(_e656)) | (~((_e656 ^ _e582.x.w)) & ((_e582.x.w | 2155905152u) - (_e656 & 2139062143u)))))) & (((_e689 & ~(_e582.y.y)) | (~((_e582.y.y ^ _e689)) & ((_e689 | 2155905152u) - (_e582.y.y & 2139062143u)))) & ((_e582.y.w & ~(_e690)) | (~((_e690 ^ _e582.y.w)) & ((_e582.y.w | 2155905152u) - (_e690 & 2139062143u)))))) & ((_e582.z.y & ~(_e724)) | (~((_e724 ^ _e582.z.y)) & ((_e582.z.y | 2155905152u) - (_e724 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e582.z.w & 2147483648u) != 0u) {
                                phi_1188_ = _e584;
                                phi_785_ = (_e582.z.w & 2147483647u);
                                phi_787_ = _e905;
                                phi_1189_ = _e550;
                            } else {
                                if (_e905 == 0u) {
                                    phi_1186_ = _e584;
                                    phi_1187_ = _e550;
                                } else {
                                    if ((_e584 & 255u) == 0u) {
                                        phi_1181_ = _e550;
                                    } else {
                                        if (_e550 < 32u) {
                                            if (_e550 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1[(0u + _e550)] = _e584;
                                            phi_1180_ = (_e550 + 1u);
                                        } else {
                                            phi_1180_ = _e550;
                                        }
                                        let _e922 = phi_1180_;
                                        phi_1181_ = _e922;
                                    }
                                    let _e924 = phi_1181_;
                                    phi_1186_ = (((_e582.z.w & 2147483647u) << bitcast<u32>(8i)) | _e905);
                                    phi_1187_ = _e924;
                                }
                                let _e932 = phi_1186_;
                                let _e934 = phi_1187_;
                                phi_1188_ = _e932;
                                phi_785_ = _e546;
                                phi_787_ = _e548;
                                phi_1189_ = _e934;
                            }
                            let _e936 = phi_1188_;
                            let _e938 = phi_785_;
                            let _e940 = phi_787_;
                            let _e942 = phi_1189_;
                            local_3 = _e940;
                            local_15 = _e940;
                            local_4 = _e938;
                            if ((_e936 & 255u) == 0u) {
                                if (_e942 > 0u) {
                                    let _e946 = (_e942 - 1u);
                                    if (_e946 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e950 = local_1[(0u + _e946)];
                                    phi_1207_ = _e950;
                                    phi_1208_ = _e946;
                                } else {
                                    phi_1207_ = 0u;
                                    phi_1208_ = _e942;
                                }
                                let _e952 = phi_1207_;
                                let _e954 = phi_1208_;
                                phi_775_ = _e952;
                                phi_778_ = _e954;
                            } else {
                                phi_775_ = _e936;
                                phi_778_ = _e942;
                            }
                            let _e956 = phi_775_;
                            let _e958 = phi_778_;
                            local_13 = _e956;
                            local_14 = _e958;
                            local_6 = _e956;
                            if (_e940 == 0u) {
                                let _e960 = (_e956 == 0u);
                                if _e960 {
                                    phi_1217_ = false;
                                } else {
                                    phi_1217_ = true;
                                }
                                let _e962 = phi_1217_;
                                phi_1218_ = _e962;
                                phi_1219_ = _e960;
                            } else {
                                phi_1218_ = false;
                                phi_1219_ = false;
                            }
                            let _e964 = phi_1218_;
                            let _e966 = phi_1219_;
                            local_2 = _e966;
                            continue;
                            continuing {
                                phi_782_ = _e956;
                                phi_784_ = _e938;
                                phi_786_ = _e940;
                                phi_788_ = _e958;
                                break if !(_e964);
                            }
                        }
                        let _e969 = local_2;
                        if _e969 {
                        }
                        let _e971 = local_3;
                        if (_e971 == 0u) {
                            phi_1884_ = true;
                            phi_1885_ = false;
                            phi_1886_ = false;
                        } else {
                            let _e3055 = local_15;
                            phi_1228_ = _e3055;
                            loop {
                                let _e974 = phi_1228_;
                                let _e977 = select(firstTrailingBit(_e974), 32u, (_e974 == 0u));
                                let _e981 = local_4;
                                let _e982 = (_e981 + (_e977 >> bitcast<u32>(2i)));
                                if (_e982 < _e84) {
                                } else {
                                    return;
                                }
                                let _e987 = rows.member[(0u + _e982)][0u];
                                let _e991 = rows.member[(0u + _e982)][1u];
                                let _e995 = rows.member[(0u + _e982)][2u];
                                let _e999 = rows.member[(0u + _e982)][3u];
                                if ((_e977 & 2u) == 0u) {
                                    phi_1263_ = _e991;
                                    phi_1264_ = _e987;
                                } else {
                                    phi_1263_ = _e999;
                                    phi_1264_ = _e995;
                                }
                                let _e1003 = phi_1263_;
                                let _e1005 = phi_1264_;
                                if ((_e977 & 1u) == 0u) {
                                    phi_1270_ = _e1005;
                                } else {
                                    phi_1270_ = _e1003;
                                }
                                let _e1009 = phi_1270_;
                                let _e1011 = (_e974 & (_e974 - 1u));
                                if (_e1009 < _e75) {
                                } else {
                                    return;
                                }
                                let _e1016 = triangles.member[(0u + _e1009)].v0_;
                                let _e1018 = (_e1016.x - _e120);
                                let _e1020 = (_e1016.y - _e122);
                                let _e1022 = (_e1016.z - _e124);
                                if (_e519 == 0u) {
                                    phi_1299_ = vec3<f32>(_e1020, _e1022, _e1018);
                                } else {
                                    if (_e519 == 1u) {
                                        phi_1298_ = vec3<f32>(_e1022, _e1018, _e1020);
                                    } else {
                                        phi_1298_ = (_e1016 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1030 = phi_1298_;
                                    phi_1299_ = _e1030;
                                }
                                let _e1032 = phi_1299_;
                                let _e1036 = (_e1032.x - (_e530 * _e1032.z));
                                let _e1040 = (_e1032.y - (_e533 * _e1032.z));
                                let _e1042 = triangles.member[(0u + _e1009)].v1_;
                                let _e1044 = (_e1042.x - _e120);
                                let _e1046 = (_e1042.y - _e122);
                                let _e1048 = (_e1042.z - _e124);
                                if (_e519 == 0u) {
                                    phi_1329_ = vec3<f32>(_e1046, _e1048, _e1044);
                                } else {
                                    if (_e519 == 1u) {
                                        phi_1328_ = vec3<f32>(_e1048, _e1044, _e1046);
                                    } else {
                                        phi_1328_ = (_e1042 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1056 = phi_1328_;
                                    phi_1329_ = _e1056;
                                }
                                let _e1058 = phi_1329_;
                                let _e1062 = (_e1058.x - (_e530 * _e1058.z));
                                let _e1066 = (_e1058.y - (_e533 * _e1058.z));
                                let _e1068 = triangles.member[(0u + _e1009)].v2_;
                                let _e1070 = (_e1068.x - _e120);
                                let _e1072 = (_e1068.y - _e122);
                                let _e1074 = (_e1068.z - _e124);
                                if (_e519 == 0u) {
                                    phi_1359_ = vec3<f32>(_e1072, _e1074, _e1070);
                                } else {
                                    if (_e519 == 1u) {
                                        phi_1358_ = vec3<f32>(_e1074, _e1070, _e1072);
                                    } else {
                                        phi_1358_ = (_e1068 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1082 = phi_1358_;
                                    phi_1359_ = _e1082;
                                }
                                let _e1084 = phi_1359_;
                                let _e1088 = (_e1084.x - (_e530 * _e1084.z));
                                let _e1092 = (_e1084.y - (_e533 * _e1084.z));
                                if (_e1062 < _e1088) {
                                    phi_1378_ = true;
                                } else {
                                    if (_e1062 == _e1088) {
                                        phi_1377_ = (_e1066 < _e1092);
                                    } else {
                                        phi_1377_ = false;
                                    }
                                    let _e1097 = phi_1377_;
                                    phi_1378_ = _e1097;
                                }
                                let _e1099 = phi_1378_;
                                if _e1099 {
                                    phi_1382_ = _e1092;
                                    phi_1383_ = _e1088;
                                    phi_1384_ = _e1066;
                                    phi_1385_ = _e1062;
                                } else {
                                    phi_1382_ = _e1066;
                                    phi_1383_ = _e1062;
                                    phi_1384_ = _e1092;
                                    phi_1385_ = _e1088;
                                }
                                let _e1101 = phi_1382_;
                                let _e1103 = phi_1383_;
                                let _e1105 = phi_1384_;
                                let _e1107 = phi_1385_;
                                let _e1110 = ((_e1107 * _e1101) - (_e1105 * _e1103));
                                if _e1099 {
                                    phi_1393_ = -(_e1110);
                                } else {
                                    phi_1393_ = _e1110;
                                }
                                let _e1113 = phi_1393_;
                                if (_e1088 < _e1036) {
                                    phi_1404_ = true;
                                } else {
                                    if (_e1088 == _e1036) {
                                        phi_1403_ = (_e1092 < _e1040);
                                    } else {
                                        phi_1403_ = false;
                                    }
                                    let _e1118 = phi_1403_;
                                    phi_1404_ = _e1118;
                                }
                                let _e1120 = phi_1404_;
                                if _e1120 {
                                    phi_1408_ = _e1040;
                                    phi_1409_ = _e1036;
                                    phi_1410_ = _e1092;
                                    phi_1411_ = _e1088;
                                } else {
                                    phi_1408_ = _e1092;
                                    phi_1409_ = _e1088;
                                    phi_1410_ = _e1040;
                                    phi_1411_ = _e1036;
                                }
                                let _e1122 = phi_1408_;
                                let _e1124 = phi_1409_;
                                let _e1126 = phi_1410_;
                                let _e1128 = phi_1411_;
                                let _e1131 = ((_e1128 * _e1122) - (_e1126 * _e1124));
                                if _e1120 {
                                    phi_1419_ = -(_e1131);
                                } else {
                                    phi_1419_ = _e1131;
                                }
                                let _e1134 = phi_1419_;
                                if (_e1036 < _e1062) {
                                    phi_1430_ = true;
                                } else {
                                    if (_e1036 == _e1062) {
                                        phi_1429_ = (_e1040 < _e1066);
                                    } else {
                                        phi_1429_ = false;
                                    }
                                    let _e1139 = phi_1429_;
                                    phi_1430_ = _e1139;
                                }
                                let _e1141 = phi_1430_;
                                if _e1141 {
                                    phi_1434_ = _e1066;
                                    phi_1435_ = _e1062;
                                    phi_1436_ = _e1040;
                                    phi_1437_ = _e1036;
                                } else {
                                    phi_1434_ = _e1040;
                                    phi_1435_ = _e1036;
                                    phi_1436_ = _e1066;
                                    phi_1437_ = _e1062;
                                }
                                let _e1143 = phi_1434_;
                                let _e1145 = phi_1435_;
                                let _e1147 = phi_1436_;
                                let _e1149 = phi_1437_;
                                let _e1152 = ((_e1149 * _e1143) - (_e1147 * _e1145));
                                if _e1141 {
                                    phi_1445_ = -(_e1152);
                                } else {
                                    phi_1445_ = _e1152;
                                }
                                let _e1155 = phi_1445_;
                                if (_e1113 >= 0f) {
                                    if (_e1134 >= 0f) {
                                        if (_e1155 >= 0f) {
                                            phi_1460_ = ((_e1113 + _e1134) + _e1155);
                                            phi_1461_ = false;
                                        } else {
                                            phi_1460_ = f32();
                                            phi_1461_ = true;
                                        }
                                        let _e1162 = phi_1460_;
                                        let _e1164 = phi_1461_;
                                        phi_1462_ = _e1162;
                                        phi_1463_ = _e1164;
                                    } else {
                                        phi_1462_ = f32();
                                        phi_1463_ = true;
                                    }
                                    let _e1166 = phi_1462_;
                                    let _e1168 = phi_1463_;
                                    phi_1464_ = _e1166;
                                    phi_1465_ = _e1168;
                                } else {
                                    phi_1464_ = f32();
                                    phi_1465_ = true;
                                }
                                let _e1170 = phi_1464_;
                                let _e1172 = phi_1465_;
                                if _e1172 {
                                    if (_e1113 <= 0f) {
                                        if (_e1134 <= 0f) {
                                            let _e1175 = (_e1155 <= 0f);
                                            if _e1175 {
                                            }
                                            phi_1483_ = ((_e1113 + _e1134) + _e1155);
                                            phi_1484_ = false;
                                            phi_1485_ = _e1175;
                                        } else {
                                            phi_1483_ = f32();
                                            phi_1484_ = true;
                                            phi_1485_ = false;
                                        }
                                        let _e1179 = phi_1483_;
                                        let _e1181 = phi_1484_;
                                        let _e1183 = phi_1485_;
                                        phi_1486_ = _e1179;
                                        phi_1487_ = _e1181;
                                        phi_1488_ = _e1183;
                                    } else {
                                        phi_1486_ = f32();
                                        phi_1487_ = true;
                                        phi_1488_ = false;
                                    }
                                    let _e1185 = phi_1486_;
                                    let _e1187 = phi_1487_;
                                    let _e1189 = phi_1488_;
                                    if _e1187 {
                                        phi_1492_ = false;
                                    } else {
                                        phi_1492_ = _e1189;
                                    }
                                    let _e1191 = phi_1492_;
                                    phi_1493_ = _e1185;
                                    phi_1494_ = _e1191;
                                } else {
                                    phi_1493_ = _e1170;
                                    phi_1494_ = true;
                                }
                                let _e1193 = phi_1493_;
                                let _e1195 = phi_1494_;
                                if _e1195 {
                                    let _e1196 = (_e1193 == 0f);
                                    if _e1196 {
                                        phi_1810_ = lt_bvh_triangle_Intersection();
                                        phi_1811_ = false;
                                    } else {
                                        let _e1198 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1200 = (_e1198.x - _e120);
                                        let _e1202 = (_e1198.y - _e122);
                                        let _e1204 = (_e1198.z - _e124);
                                        if (_e519 == 0u) {
                                            phi_1523_ = vec3<f32>(_e1202, _e1204, _e1200);
                                        } else {
                                            if (_e519 == 1u) {
                                                phi_1522_ = vec3<f32>(_e1204, _e1200, _e1202);
                                            } else {
                                                phi_1522_ = (_e1198 - vec3<f32>(_e120, _e122, _e124));
                                            }
                                            let _e1212 = phi_1522_;
                                            phi_1523_ = _e1212;
                                        }
                                        let _e1214 = phi_1523_;
                                        let _e1216 = triangles.member[(0u + _e1009)].v1_;
                                        let _e1218 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1221 = (_e1216.x - _e1218.x);
                                        let _e1224 = (_e1216.y - _e1218.y);
                                        let _e1227 = (_e1216.z - _e1218.z);
                                        if (_e519 == 0u) {
                                            phi_1549_ = vec3<f32>(_e1224, _e1227, _e1221);
                                        } else {
                                            if (_e519 == 1u) {
                                                phi_1548_ = vec3<f32>(_e1227, _e1221, _e1224);
                                            } else {
                                                phi_1548_ = (_e1216 - _e1218);
                                            }
                                            let _e1234 = phi_1548_;
                                            phi_1549_ = _e1234;
                                        }
                                        let _e1236 = phi_1549_;
                                        let _e1238 = triangles.member[(0u + _e1009)].v2_;
                                        let _e1240 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1243 = (_e1238.x - _e1240.x);
                                        let _e1246 = (_e1238.y - _e1240.y);
                                        let _e1249 = (_e1238.z - _e1240.z);
                                        if (_e519 == 0u) {
                                            phi_1575_ = vec3<f32>(_e1246, _e1249, _e1243);
                                        } else {
                                            if (_e519 == 1u) {
                                                phi_1574_ = vec3<f32>(_e1249, _e1243, _e1246);
                                            } else {
                                                phi_1574_ = (_e1238 - _e1240);
                                            }
                                            let _e1256 = phi_1574_;
                                            phi_1575_ = _e1256;
                                        }
                                        let _e1258 = phi_1575_;
                                        let _e1265 = ((_e1236.y * _e1258.z) - (_e1236.z * _e1258.y));
                                        let _e1272 = ((_e1236.z * _e1258.x) - (_e1236.x * _e1258.z));
                                        let _e1279 = ((_e1236.x * _e1258.y) - (_e1236.y * _e1258.x));
                                        let _e1293 = (((1f / _e527.z) * (((_e1265 * _e1214.x) + (_e1272 * _e1214.y)) + (_e1279 * _e1214.z))) / (((_e1265 * _e530) + (_e1272 * _e533)) + _e1279));
                                        if (_e1293 > 0f) {
                                            if (_e1293 < _e132) {
                                                let _e1297 = triangles.member[(0u + _e1009)].v0_;
                                                let _e1299 = triangles.member[(0u + _e1009)].v1_;
                                                if (_e1297.x < _e1299.x) {
                                                    phi_1631_ = _e1297.x;
                                                } else {
                                                    phi_1631_ = _e1299.x;
                                                }
                                                let _e1306 = phi_1631_;
                                                if (_e1297.y < _e1299.y) {
                                                    phi_1640_ = _e1297.y;
                                                } else {
                                                    phi_1640_ = _e1299.y;
                                                }
                                                let _e1313 = phi_1640_;
                                                if (_e1297.z < _e1299.z) {
                                                    phi_1649_ = _e1297.z;
                                                } else {
                                                    phi_1649_ = _e1299.z;
                                                }
                                                let _e1320 = phi_1649_;
                                                let _e1322 = triangles.member[(0u + _e1009)].v2_;
                                                if (_e1306 < _e1322.x) {
                                                    phi_1658_ = _e1306;
                                                } else {
                                                    phi_1658_ = _e1322.x;
                                                }
                                                let _e1327 = phi_1658_;
                                                if (_e1313 < _e1322.y) {
                                                    phi_1665_ = _e1313;
                                                } else {
                                                    phi_1665_ = _e1322.y;
                                                }
                                                let _e1332 = phi_1665_;
                                                if (_e1320 < _e1322.z) {
                                                    phi_1672_ = _e1320;
                                                } else {
                                                    phi_1672_ = _e1322.z;
                                                }
                                                let _e1337 = phi_1672_;
                                                let _e1339 = triangles.member[(0u + _e1009)].v0_;
                                                let _e1341 = triangles.member[(0u + _e1009)].v1_;
                                                if (_e1339.x > _e1341.x) {
                                                    phi_1685_ = _e1339.x;
                                                } else {
                                                    phi_1685_ = _e1341.x;
                                                }
                                                let _e1348 = phi_1685_;
                                                if (_e1339.y > _e1341.y) {
                                                    phi_1694_ = _e1339.y;
                                                } else {
                                                    phi_1694_ = _e1341.y;
                                                }
                                                let _e1355 = phi_1694_;
                                                if (_e1339.z > _e1341.z) {
                                                    phi_1703_ = _e1339.z;
                                                } else {
                                                    phi_1703_ = _e1341.z;
                                                }
                                                let _e1362 = phi_1703_;
                                                let _e1364 = triangles.member[(0u + _e1009)].v2_;
                                                if (_e1348 > _e1364.x) {
                                                    phi_1712_ = _e1348;
                                                } else {
                                                    phi_1712_ = _e1364.x;
                                                }
                                                let _e1369 = phi_1712_;
                                                if (_e1355 > _e1364.y) {
                                                    phi_1719_ = _e1355;
                                                } else {
                                                    phi_1719_ = _e1364.y;
                                                }
                                                let _e1374 = phi_1719_;
                                                if (_e1362 > _e1364.z) {
                                                    phi_1726_ = _e1362;
                                                } else {
                                                    phi_1726_ = _e1364.z;
                                                }
                                                let _e1379 = phi_1726_;
                                                let _e1383 = ((_e1327 - _e120) * _e448);
                                                let _e1384 = ((_e1332 - _e122) * _e458);
                                                let _e1385 = ((_e1337 - _e124) * _e468);
                                                let _e1389 = ((_e1369 - _e120) * _e448);
                                                let _e1390 = ((_e1374 - _e122) * _e458);
                                                let _e1391 = ((_e1379 - _e124) * _e468);
                                                if (_e1383 < _e1389) {
                                                    phi_1743_ = _e1383;
                                                } else {
                                                    phi_1743_ = _e1389;
                                                }
                                                let _e1394 = phi_1743_;
                                                if (_e1384 < _e1390) {
                                                    phi_1748_ = _e1384;
                                                } else {
                                                    phi_1748_ = _e1390;
                                                }
                                                let _e1397 = phi_1748_;
                                                if (_e1385 < _e1391) {
                                                    phi_1753_ = _e1385;
                                                } else {
                                                    phi_1753_ = _e1391;
                                                }
                                                let _e1400 = phi_1753_;
                                                if (_e1383 > _e1389) {
                                                    phi_1761_ = _e1383;
                                                } else {
                                                    phi_1761_ = _e1389;
                                                }
                                                let _e1406 = phi_1761_;
                                                if (_e1384 > _e1390) {
                                                    phi_1766_ = _e1384;
                                                } else {
                                                    phi_1766_ = _e1390;
                                                }
                                                let _e1409 = phi_1766_;
                                                if (_e1385 > _e1391) {
                                                    phi_1771_ = _e1385;
                                                } else {
                                                    phi_1771_ = _e1391;
                                                }
                                                let _e1412 = phi_1771_;
                                                let _e1416 = core_intrinsics_maximum_number_nsz_f32_((_e1394 - _e503), (_e1397 - _e504));
                                                let _e1417 = core_intrinsics_maximum_number_nsz_f32_(_e1416, (_e1400 - _e505));
                                                let _e1418 = core_intrinsics_minimum_number_nsz_f32_((_e1406 + _e503), (_e1409 + _e504));
                                                let _e1419 = core_intrinsics_minimum_number_nsz_f32_(_e1418, (_e1412 + _e505));
                                                if (_e1417 > -300000000000000000000000000000000000000f) {
                                                    phi_1783_ = _e1417;
                                                } else {
                                                    phi_1783_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1422 = phi_1783_;
                                                if (_e1419 < 300000000000000000000000000000000000000f) {
                                                    phi_1788_ = _e1419;
                                                } else {
                                                    phi_1788_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1425 = phi_1788_;
                                                if (_e1293 < _e1422) {
                                                    phi_1793_ = _e1422;
                                                } else {
                                                    phi_1793_ = _e1293;
                                                }
                                                let _e1428 = phi_1793_;
                                                if (_e1428 > _e1425) {
                                                    phi_1798_ = _e1425;
                                                } else {
                                                    phi_1798_ = _e1428;
                                                }
                                                let _e1431 = phi_1798_;
                                                phi_1803_ = lt_bvh_triangle_Intersection(_e1431, (_e1134 / _e1193), (_e1155 / _e1193), (_e1422 <= _e1425));
                                                phi_1804_ = false;
                                            } else {
                                                phi_1803_ = lt_bvh_triangle_Intersection();
                                                phi_1804_ = true;
                                            }
                                            let _e1437 = phi_1803_;
                                            let _e1439 = phi_1804_;
                                            phi_1805_ = _e1437;
                                            phi_1806_ = _e1439;
                                        } else {
                                            phi_1805_ = lt_bvh_triangle_Intersection();
                                            phi_1806_ = true;
                                        }
                                        let _e1441 = phi_1805_;
                                        let _e1443 = phi_1806_;
                                        if _e1443 {
                                        }
                                        phi_1810_ = _e1441;
                                        phi_1811_ = _e1443;
                                    }
                                    let _e1445 = phi_1810_;
                                    let _e1447 = phi_1811_;
                                    phi_1812_ = _e1445;
                                    phi_1813_ = _e1196;
                                    phi_1814_ = _e1447;
                                } else {
                                    phi_1812_ = lt_bvh_triangle_Intersection();
                                    phi_1813_ = true;
                                    phi_1814_ = false;
                                }
                                let _e1449 = phi_1812_;
                                let _e1451 = phi_1813_;
                                let _e1453 = phi_1814_;
                                if _e1451 {
                                    phi_1818_ = true;
                                } else {
                                    phi_1818_ = _e1453;
                                }
                                let _e1455 = phi_1818_;
                                if _e1455 {
                                    phi_1822_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1822_ = _e1449;
                                }
                                let _e1457 = phi_1822_;
                                if _e1457.is_hit {
                                    if (_e1457.t > 0f) {
                                        if (_e1457.t < _e132) {
                                            let _e1464 = triangles.member[(0u + _e1009)].i0_;
                                            let _e1466 = ((_e1464 & 2147483648u) == 0u);
                                            if _e1466 {
                                                phi_1848_ = false;
                                                phi_1849_ = false;
                                            } else {
                                                if true {
                                                    phi_1847_ = false;
                                                } else {
                                                    phi_1847_ = true;
                                                }
                                                let _e1468 = phi_1847_;
                                                phi_1848_ = _e1468;
                                                phi_1849_ = true;
                                            }
                                            let _e1470 = phi_1848_;
                                            let _e1472 = phi_1849_;
                                            phi_1850_ = _e1470;
                                            phi_1851_ = _e1466;
                                            phi_1852_ = _e1472;
                                        } else {
                                            phi_1850_ = true;
                                            phi_1851_ = false;
                                            phi_1852_ = false;
                                        }
                                        let _e1474 = phi_1850_;
                                        let _e1476 = phi_1851_;
                                        let _e1478 = phi_1852_;
                                        phi_1853_ = false;
                                        phi_1854_ = _e1474;
                                        phi_1855_ = _e1476;
                                        phi_1856_ = _e1478;
                                    } else {
                                        phi_1853_ = true;
                                        phi_1854_ = false;
                                        phi_1855_ = false;
                                        phi_1856_ = false;
                                    }
                                    let _e1480 = phi_1853_;
                                    let _e1482 = phi_1854_;
                                    let _e1484 = phi_1855_;
                                    let _e1486 = phi_1856_;
                                    phi_1857_ = _e1480;
                                    phi_1858_ = _e1482;
                                    phi_1859_ = _e1484;
                                    phi_1860_ = _e1486;
                                } else {
                                    phi_1857_ = true;
                                    phi_1858_ = false;
                                    phi_1859_ = false;
                                    phi_1860_ = false;
                                }
                                let _e1488 = phi_1857_;
                                let _e1490 = phi_1858_;
                                let _e1492 = phi_1859_;
                                let _e1494 = phi_1860_;
                                if _e1488 {
                                    phi_1864_ = true;
                                    phi_1865_ = false;
                                    phi_1866_ = false;
                                } else {
                                    phi_1864_ = _e1490;
                                    phi_1865_ = _e1492;
                                    phi_1866_ = _e1494;
                                }
                                let _e1496 = phi_1864_;
                                let _e1498 = phi_1865_;
                                let _e1500 = phi_1866_;
                                if _e1496 {
                                    let _e1501 = (_e1011 == 0u);
                                    if _e1501 {
                                        phi_1874_ = false;
                                    } else {
                                        phi_1874_ = true;
                                    }
                                    let _e1503 = phi_1874_;
                                    phi_1875_ = _e1503;
                                    phi_1876_ = _e1501;
                                    phi_1877_ = false;
                                    phi_1878_ = false;
                                } else {
                                    phi_1875_ = false;
                                    phi_1876_ = false;
                                    phi_1877_ = _e1498;
                                    phi_1878_ = _e1500;
                                }
                                let _e1505 = phi_1875_;
                                let _e1507 = phi_1876_;
                                let _e1509 = phi_1877_;
                                let _e1511 = phi_1878_;
                                local_5 = _e1507;
                                local_16 = _e1509;
                                local_17 = _e1511;
                                local_18 = _e1507;
                                continue;
                                continuing {
                                    phi_1228_ = _e1011;
                                    break if !(_e1505);
                                }
                            }
                            let _e1514 = local_5;
                            if _e1514 {
                                phi_1882_ = false;
                                phi_1883_ = false;
                            } else {
                                let _e3166 = local_16;
                                phi_1882_ = _e3166;
                                let _e3169 = local_17;
                                phi_1883_ = _e3169;
                            }
                            let _e1516 = phi_1882_;
                            let _e1518 = phi_1883_;
                            let _e3172 = local_18;
                            phi_1884_ = _e3172;
                            phi_1885_ = _e1516;
                            phi_1886_ = _e1518;
                        }
                        let _e1520 = phi_1884_;
                        let _e1522 = phi_1885_;
                        let _e1524 = phi_1886_;
                        if _e1520 {
                            let _e1526 = local_6;
                            if (_e1526 == 0u) {
                                phi_1894_ = false;
                            } else {
                                phi_1894_ = true;
                            }
                            let _e1529 = phi_1894_;
                            phi_1895_ = _e1529;
                            phi_1896_ = false;
                            phi_1897_ = false;
                        } else {
                            phi_1895_ = false;
                            phi_1896_ = _e1522;
                            phi_1897_ = _e1524;
                        }
                        let _e1531 = phi_1895_;
                        let _e1533 = phi_1896_;
                        let _e1535 = phi_1897_;
                        local_7 = _e1533;
                        local_19 = _e1535;
                        local_20 = _e1533;
                        continue;
                        continuing {
                            let _e3016 = local_13;
                            phi_774_ = _e3016;
                            let _e3019 = local_14;
                            phi_777_ = _e3019;
                            break if !(_e1531);
                        }
                    }
                    let _e1538 = local_7;
                    if _e1538 {
                        phi_1901_ = false;
                    } else {
                        let _e3183 = local_19;
                        phi_1901_ = _e3183;
                    }
                    let _e1540 = phi_1901_;
                    if _e1540 {
                        phi_1905_ = true;
                    } else {
                        let _e3186 = local_20;
                        phi_1905_ = _e3186;
                    }
                    let _e1542 = phi_1905_;
                    if _e1542 {
                        phi_1909_ = true;
                    } else {
                        phi_1909_ = false;
                    }
                    let _e1544 = phi_1909_;
                    phi_1910_ = _e1544;
                }
                let _e1546 = phi_1910_;
                phi_3367_ = _e1546;
            } else {
                let _e1547 = abs(_e140);
                let _e1548 = abs(_e141);
                let _e1549 = abs(_e142);
                if (abs(_e120) < 1000000000000000f) {
                    if (abs(_e122) < 1000000000000000f) {
                        phi_1926_ = (abs(_e124) < 1000000000000000f);
                        phi_1927_ = false;
                    } else {
                        phi_1926_ = bool();
                        phi_1927_ = true;
                    }
                    let _e1557 = phi_1926_;
                    let _e1559 = phi_1927_;
                    phi_1928_ = _e1557;
                    phi_1929_ = _e1559;
                } else {
                    phi_1928_ = bool();
                    phi_1929_ = true;
                }
                let _e1561 = phi_1928_;
                let _e1563 = phi_1929_;
                if _e1563 {
                    phi_1933_ = false;
                } else {
                    phi_1933_ = _e1561;
                }
                let _e1565 = phi_1933_;
                if _e1565 {
                    if (_e1547 < 1000000000000000f) {
                        if (_e1548 < 1000000000000000f) {
                            phi_1946_ = (_e1549 < 1000000000000000f);
                            phi_1947_ = false;
                        } else {
                            phi_1946_ = bool();
                            phi_1947_ = true;
                        }
                        let _e1570 = phi_1946_;
                        let _e1572 = phi_1947_;
                        phi_1948_ = _e1570;
                        phi_1949_ = _e1572;
                    } else {
                        phi_1948_ = bool();
                        phi_1949_ = true;
                    }
                    let _e1574 = phi_1948_;
                    let _e1576 = phi_1949_;
                    if _e1576 {
                        phi_1953_ = false;
                    } else {
                        phi_1953_ = _e1574;
                    }
                    let _e1578 = phi_1953_;
                    if _e1578 {
                        if (_e1547 > 0f) {
                            phi_1967_ = bool();
                            phi_1968_ = true;
                        } else {
                            let _e1580 = (_e1548 > 0f);
                            if _e1580 {
                                phi_1966_ = bool();
                            } else {
                                phi_1966_ = (_e1549 > 0f);
                            }
                            let _e1583 = phi_1966_;
                            phi_1967_ = _e1583;
                            phi_1968_ = _e1580;
                        }
                        let _e1585 = phi_1967_;
                        let _e1587 = phi_1968_;
                        if _e1587 {
                            phi_1972_ = true;
                        } else {
                            phi_1972_ = _e1585;
                        }
                        let _e1589 = phi_1972_;
                        phi_1973_ = _e1589;
                        phi_1974_ = false;
                    } else {
                        phi_1973_ = bool();
                        phi_1974_ = true;
                    }
                    let _e1591 = phi_1973_;
                    let _e1593 = phi_1974_;
                    phi_1975_ = _e1591;
                    phi_1976_ = _e1593;
                } else {
                    phi_1975_ = bool();
                    phi_1976_ = true;
                }
                let _e1595 = phi_1975_;
                let _e1597 = phi_1976_;
                if _e1597 {
                    phi_1980_ = false;
                } else {
                    phi_1980_ = _e1595;
                }
                let _e1599 = phi_1980_;
                if _e1599 {
                    let _e1600 = (0u >= _e72);
                    if _e1600 {
                        phi_3360_ = bool();
                    } else {
                        if (0u < _e72) {
                        } else {
                            return;
                        }
                        let _e1606 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1610 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1614 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1618 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1622 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1626 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1630 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1664 = core_intrinsics_maximum_number_nsz_f32_(abs(_e140), abs(_e141));
                        let _e1665 = core_intrinsics_maximum_number_nsz_f32_(_e1664, abs(_e142));
                        let _e1666 = (_e1665 * 0.0000000000009094947f);
                        if (abs(_e140) < _e1666) {
                            phi_2050_ = _e1666;
                        } else {
                            phi_2050_ = abs(_e140);
                        }
                        let _e1671 = phi_2050_;
                        if (_e140 < 0f) {
                            phi_2057_ = (-1f / _e1671);
                        } else {
                            phi_2057_ = (1f / _e1671);
                        }
                        let _e1676 = phi_2057_;
                        if (abs(_e141) < _e1666) {
                            phi_2064_ = _e1666;
                        } else {
                            phi_2064_ = abs(_e141);
                        }
                        let _e1681 = phi_2064_;
                        if (_e141 < 0f) {
                            phi_2071_ = (-1f / _e1681);
                        } else {
                            phi_2071_ = (1f / _e1681);
                        }
                        let _e1686 = phi_2071_;
                        if (abs(_e142) < _e1666) {
                            phi_2078_ = _e1666;
                        } else {
                            phi_2078_ = abs(_e142);
                        }
                        let _e1691 = phi_2078_;
                        if (_e142 < 0f) {
                            phi_2085_ = (-1f / _e1691);
                        } else {
                            phi_2085_ = (1f / _e1691);
                        }
                        let _e1696 = phi_2085_;
                        let _e1700 = abs((bitcast<f32>(_e1606) - _e120));
                        let _e1701 = abs((bitcast<f32>(_e1610) - _e122));
                        let _e1702 = abs((bitcast<f32>(_e1614) - _e124));
                        let _e1706 = abs(((bitcast<f32>(_e1618) + (bitcast<f32>((((_e1630 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                        let _e1707 = abs(((bitcast<f32>(_e1622) + (bitcast<f32>((((_e1630 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                        let _e1708 = abs(((bitcast<f32>(_e1626) + (bitcast<f32>((((_e1630 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e124));
                        if (_e1700 > _e1706) {
                            phi_2102_ = _e1700;
                        } else {
                            phi_2102_ = _e1706;
                        }
                        let _e1711 = phi_2102_;
                        if (_e1701 > _e1707) {
                            phi_2107_ = _e1701;
                        } else {
                            phi_2107_ = _e1707;
                        }
                        let _e1714 = phi_2107_;
                        if (_e1702 > _e1708) {
                            phi_2112_ = _e1702;
                        } else {
                            phi_2112_ = _e1708;
                        }
                        let _e1717 = phi_2112_;
                        if (_e1711 > _e1714) {
                            phi_2117_ = _e1711;
                        } else {
                            phi_2117_ = _e1714;
                        }
                        let _e1720 = phi_2117_;
                        if (_e1720 > _e1717) {
                            phi_2122_ = _e1720;
                        } else {
                            phi_2122_ = _e1717;
                        }
                        let _e1723 = phi_2122_;
                        let _e1727 = (_e1723 * 0.0000019073486f);
                        let _e1728 = (abs(_e1676) * _e1727);
                        let _e1729 = (abs(_e1686) * _e1727);
                        let _e1730 = (abs(_e1696) * _e1727);
                        let _e1734 = (_e1723 * 0.0000009536743f);
                        let _e1735 = (abs(_e1676) * _e1734);
                        let _e1736 = (abs(_e1686) * _e1734);
                        let _e1737 = (abs(_e1696) * _e1734);
                        let _e1738 = abs(_e140);
                        let _e1739 = abs(_e141);
                        let _e1740 = abs(_e142);
                        if (_e1738 >= _e1739) {
                            if (_e1738 >= _e1740) {
                                phi_2148_ = false;
                            } else {
                                phi_2148_ = true;
                            }
                            let _e1744 = phi_2148_;
                            phi_2149_ = _e1744;
                        } else {
                            phi_2149_ = true;
                        }
                        let _e1746 = phi_2149_;
                        if _e1746 {
                            if (_e1739 >= _e1740) {
                                phi_2157_ = 1u;
                            } else {
                                phi_2157_ = 2u;
                            }
                            let _e1749 = phi_2157_;
                            phi_2158_ = _e1749;
                        } else {
                            phi_2158_ = 0u;
                        }
                        let _e1751 = phi_2158_;
                        if (_e1751 == 0u) {
                            phi_2170_ = vec3<f32>(_e141, _e142, _e140);
                        } else {
                            if (_e1751 == 1u) {
                                phi_2169_ = vec3<f32>(_e142, _e140, _e141);
                            } else {
                                phi_2169_ = _e143;
                            }
                            let _e1757 = phi_2169_;
                            phi_2170_ = _e1757;
                        }
                        let _e1759 = phi_2170_;
                        let _e1762 = (_e1759.x / _e1759.z);
                        let _e1765 = (_e1759.y / _e1759.z);
                        if (_e1676 < 0f) {
                            phi_2183_ = 0u;
                        } else {
                            phi_2183_ = 1u;
                        }
                        let _e1770 = phi_2183_;
                        if (_e1686 < 0f) {
                            phi_2188_ = 0u;
                        } else {
                            phi_2188_ = 2u;
                        }
                        let _e1773 = phi_2188_;
                        if (_e1696 < 0f) {
                            phi_2193_ = 0u;
                        } else {
                            phi_2193_ = 4u;
                        }
                        let _e1776 = phi_2193_;
                        let _e1778 = ((_e1770 | _e1773) | _e1776);
                        let _e1779 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1779.first[0], _e1779.first[1], _e1779.first[2], _e1779.first[3], _e1779.first[4], _e1779.first[5], _e1779.first[6], _e1779.first[7], _e1779.first[8], _e1779.first[9], _e1779.first[10], _e1779.first[11], _e1779.first[12], _e1779.first[13], _e1779.first[14], _e1779.first[15], _e1779.first[16], _e1779.first[17], _e1779.first[18], _e1779.first[19], _e1779.first[20], _e1779.first[21], _e1779.first[22], _e1779.first[23], _e1779.first[24], _e1779.first[25], _e1779.first[26], _e1779.first[27], _e1779.first[28], _e1779.first[29], _e1779.first[30], _e1779.first[31]), array<u32, 32>(_e1779.mask[0], _e1779.mask[1], _e1779.mask[2], _e1779.mask[3], _e1779.mask[4], _e1779.mask[5], _e1779.mask[6], _e1779.mask[7], _e1779.mask[8], _e1779.mask[9], _e1779.mask[10], _e1779.mask[11], _e1779.mask[12], _e1779.mask[13], _e1779.mask[14], _e1779.mask[15], _e1779.mask[16], _e1779.mask[17], _e1779.mask[18], _e1779.mask[19], _e1779.mask[20], _e1779.mask[21], _e1779.mask[22], _e1779.mask[23], _e1779.mask[24], _e1779.mask[25], _e1779.mask[26], _e1779.mask[27], _e1779.mask[28], _e1779.mask[29], _e1779.mask[30], _e1779.mask[31]), _e1779.len, _e1779.group, _e1779.group_mask);
                        let _e1853 = local.group_mask;
                        if ((_e1853 & 4278190080u) == 0u) {
                            let _e1857 = local.len;
                            if (_e1857 == 0u) {
                                phi_2307_ = false;
                            } else {
                                let _e1861 = local.len;
                                local.len = (_e1861 - 1u);
                                let _e1864 = local.len;
                                if (_e1864 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1869 = local.first[(0u + _e1864)];
                                local.group = _e1869;
                                let _e1872 = local.len;
                                if (_e1872 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1877 = local.mask[(0u + _e1872)];
                                local.group_mask = _e1877;
                                phi_2307_ = true;
                            }
                            let _e1880 = phi_2307_;
                            phi_2308_ = _e1880;
                        } else {
                            phi_2308_ = true;
                        }
                        let _e1882 = phi_2308_;
                        if _e1882 {
                            let _e1884 = local.group_mask;
                            let _e1890 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1884)), 32u, (_e1884 == 0u)));
                            let _e1894 = local.group_mask;
                            let _e1908 = local.group_mask;
                            local.group_mask = (_e1908 & ~((1u << bitcast<u32>((_e1890 & 31u)))));
                            let _e1911 = local.group;
                            phi_2339_ = (_e1911 + countOneBits(((_e1894 & ~((4294967295u << bitcast<u32>((((_e1890 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2339_ = 4294967295u;
                        }
                        let _e1914 = phi_2339_;
                        phi_2341_ = _e1914;
                        phi_2344_ = false;
                        loop {
                            let _e1916 = phi_2341_;
                            let _e1918 = phi_2344_;
                            local_23 = _e1918;
                            if (_e1916 != 4294967295u) {
                                if (_e1916 < _e72) {
                                } else {
                                    return;
                                }
                                let _e1925 = nodes.member[(0u + _e1916)].frame[3u];
                                let _e1950 = (bitcast<f32>((((_e1925 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1676);
                                let _e1951 = (bitcast<f32>((((_e1925 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1686);
                                let _e1952 = (bitcast<f32>((((_e1925 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1696);
                                let _e1955 = nodes.member[(0u + _e1916)].frame[0u];
                                let _e1959 = nodes.member[(0u + _e1916)].frame[1u];
                                let _e1963 = nodes.member[(0u + _e1916)].frame[2u];
                                let _e1968 = ((bitcast<f32>(_e1955) - _e120) * _e1676);
                                let _e1969 = ((bitcast<f32>(_e1959) - _e122) * _e1686);
                                let _e1970 = ((bitcast<f32>(_e1963) - _e124) * _e1696);
                                let _e1978 = nodes.member[(0u + _e1916)].x;
                                if (_e1676 < 0f) {
                                    let _e1989 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1978.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1995 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1989.unnamed.root, _e1978.w), _e1989.unnamed_1);
                                    let _e2001 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1995.unnamed, lt_bvh_traverse_Tree(_e1978.x, _e1995.unnamed_1.first_primitive));
                                    phi_2424_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2001.unnamed, lt_bvh_traverse_Tree(_e2001.unnamed_1.root, _e1978.y));
                                } else {
                                    let _e2017 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1978.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2023 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2017.unnamed.root, _e1978.y), _e2017.unnamed_1);
                                    let _e2029 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2023.unnamed, lt_bvh_traverse_Tree(_e1978.z, _e2023.unnamed_1.first_primitive));
                                    phi_2424_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2029.unnamed, lt_bvh_traverse_Tree(_e2029.unnamed_1.root, _e1978.w));
                                }
                                let _e2037 = phi_2424_;
                                let _e2047 = nodes.member[(0u + _e1916)].y;
                                if (_e1686 < 0f) {
                                    let _e2058 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2047.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2064 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2058.unnamed.root, _e2047.w), _e2058.unnamed_1);
                                    let _e2070 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2064.unnamed, lt_bvh_traverse_Tree(_e2047.x, _e2064.unnamed_1.first_primitive));
                                    phi_2451_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2070.unnamed, lt_bvh_traverse_Tree(_e2070.unnamed_1.root, _e2047.y));
                                } else {
                                    let _e2086 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2047.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2092 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2086.unnamed.root, _e2047.y), _e2086.unnamed_1);
                                    let _e2098 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2092.unnamed, lt_bvh_traverse_Tree(_e2047.z, _e2092.unnamed_1.first_primitive));
                                    phi_2451_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2098.unnamed, lt_bvh_traverse_Tree(_e2098.unnamed_1.root, _e2047.w));
                                }
                                let _e2106 = phi_2451_;
                                let _e2116 = nodes.member[(0u + _e1916)].z;
                                if (_e1696 < 0f) {
                                    let _e2127 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2116.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2133 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2127.unnamed.root, _e2116.w), _e2127.unnamed_1);
                                    let _e2139 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2133.unnamed, lt_bvh_traverse_Tree(_e2116.x, _e2133.unnamed_1.first_primitive));
                                    phi_2478_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2139.unnamed, lt_bvh_traverse_Tree(_e2139.unnamed_1.root, _e2116.y));
                                } else {
                                    let _e2155 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2116.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2161 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2155.unnamed.root, _e2116.y), _e2155.unnamed_1);
                                    let _e2167 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2161.unnamed, lt_bvh_traverse_Tree(_e2116.z, _e2161.unnamed_1.first_primitive));
                                    phi_2478_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2167.unnamed, lt_bvh_traverse_Tree(_e2167.unnamed_1.root, _e2116.w));
                                }
                                let _e2175 = phi_2478_;
                                phi_2484_ = 0u;
                                phi_2487_ = 0u;
                                loop {
                                    let _e2185 = phi_2484_;
                                    let _e2187 = phi_2487_;
                                    local_8 = _e2187;
                                    local_9 = _e2187;
                                    local_10 = _e2187;
                                    let _e2188 = (_e2185 < 8u);
                                    if _e2188 {
                                        let _e2190 = (_e2185 >> bitcast<u32>(2i));
                                        let _e2191 = (_e2185 & 3u);
                                        if (_e2190 == 0u) {
                                            phi_2501_ = _e2037.unnamed.root;
                                        } else {
                                            phi_2501_ = _e2037.unnamed.first_primitive;
                                        }
                                        let _e2194 = phi_2501_;
                                        if (_e2190 == 0u) {
                                            phi_2511_ = _e2106.unnamed.root;
                                        } else {
                                            phi_2511_ = _e2106.unnamed.first_primitive;
                                        }
                                        let _e2203 = phi_2511_;
                                        if (_e2190 == 0u) {
                                            phi_2521_ = _e2175.unnamed.root;
                                        } else {
                                            phi_2521_ = _e2175.unnamed.first_primitive;
                                        }
                                        let _e2212 = phi_2521_;
                                        let _e2225 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2194 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u)) * _e1950) + (_e1968 - _e1728)), ((f32(((_e2203 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u)) * _e1951) + (_e1969 - _e1729)));
                                        let _e2226 = core_intrinsics_maximum_number_nsz_f32_(_e2225, ((f32(((_e2212 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u)) * _e1952) + (_e1970 - _e1730)));
                                        if (_e2190 == 0u) {
                                            phi_2539_ = _e2037.unnamed_1.root;
                                        } else {
                                            phi_2539_ = _e2037.unnamed_1.first_primitive;
                                        }
                                        let _e2229 = phi_2539_;
                                        if (_e2190 == 0u) {
                                            phi_2549_ = _e2106.unnamed_1.root;
                                        } else {
                                            phi_2549_ = _e2106.unnamed_1.first_primitive;
                                        }
                                        let _e2238 = phi_2549_;
                                        if (_e2190 == 0u) {
                                            phi_2559_ = _e2175.unnamed_1.root;
                                        } else {
                                            phi_2559_ = _e2175.unnamed_1.first_primitive;
                                        }
                                        let _e2247 = phi_2559_;
                                        let _e2260 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2229 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u)) * _e1950) + (_e1968 + _e1728)), ((f32(((_e2238 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u)) * _e1951) + (_e1969 + _e1729)));
                                        let _e2261 = core_intrinsics_minimum_number_nsz_f32_(_e2260, ((f32(((_e2247 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u)) * _e1952) + (_e1970 + _e1730)));
                                        if (_e2226 <= _e2261) {
                                            if (_e2226 <= _e132) {
                                                if (_e2261 >= 0f) {
                                                    if (_e2190 == 0u) {
                                                        let _e2268 = nodes.member[(0u + _e1916)].links[2u];
                                                        phi_2595_ = _e2268;
                                                    } else {
                                                        let _e2271 = nodes.member[(0u + _e1916)].links[3u];
                                                        phi_2595_ = _e2271;
                                                    }
                                                    let _e2273 = phi_2595_;
                                                    let _e2278 = ((_e2273 >> bitcast<u32>(((_e2191 * 8u) & 31u))) & 255u);
                                                    let _e2279 = (_e2278 & 31u);
                                                    if (_e2279 >= 24u) {
                                                        phi_2608_ = (24u + ((_e2279 - 24u) ^ _e1778));
                                                    } else {
                                                        phi_2608_ = _e2279;
                                                    }
                                                    let _e2285 = phi_2608_;
                                                    phi_2613_ = (_e2187 | ((_e2278 >> bitcast<u32>(5i)) << bitcast<u32>((_e2285 & 31u))));
                                                } else {
                                                    phi_2613_ = _e2187;
                                                }
                                                let _e2293 = phi_2613_;
                                                phi_2614_ = _e2293;
                                            } else {
                                                phi_2614_ = _e2187;
                                            }
                                            let _e2295 = phi_2614_;
                                            phi_2615_ = _e2295;
                                        } else {
                                            phi_2615_ = _e2187;
                                        }
                                        let _e2297 = phi_2615_;
                                        phi_2485_ = (_e2185 + 1u);
                                        phi_2488_ = _e2297;
                                    } else {
                                        phi_2485_ = u32();
                                        phi_2488_ = u32();
                                    }
                                    let _e2300 = phi_2485_;
                                    let _e2302 = phi_2488_;
                                    continue;
                                    continuing {
                                        phi_2484_ = _e2300;
                                        phi_2487_ = _e2302;
                                        break if !(_e2188);
                                    }
                                }
                                let _e2306 = nodes.member[(0u + _e1916)].links[0u];
                                let _e2310 = nodes.member[(0u + _e1916)].frame[3u];
                                let _e2314 = local_8;
                                if ((_e2314 & 4278190080u) == 0u) {
                                } else {
                                    let _e2318 = local.group_mask;
                                    if ((_e2318 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2322 = local.len;
                                        if (_e2322 < 32u) {
                                            let _e2325 = local.group;
                                            let _e2327 = local.len;
                                            if (_e2327 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2327)] = _e2325;
                                            let _e2333 = local.group_mask;
                                            let _e2335 = local.len;
                                            if (_e2335 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2335)] = _e2333;
                                            let _e2342 = local.len;
                                            local.len = (_e2342 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2306);
                                    let _e2346 = local_9;
                                    local.group_mask = ((_e2346 & 4278190080u) | (_e2310 >> bitcast<u32>(24i)));
                                }
                                let _e2351 = local_10;
                                phi_2673_ = (_e2351 & 16777215u);
                                phi_2676_ = _e1918;
                                loop {
                                    let _e2354 = phi_2673_;
                                    let _e2356 = phi_2676_;
                                    local_21 = _e2356;
                                    let _e2357 = (_e2354 == 0u);
                                    local_11 = _e2357;
                                    local_22 = _e2357;
                                    if _e2357 {
                                        phi_2674_ = u32();
                                        phi_2677_ = bool();
                                        phi_3274_ = false;
                                    } else {
                                        let _e2360 = nodes.member[(0u + _e1916)].links[1u];
                                        let _e2365 = ((0u + _e2360) + select(firstTrailingBit(_e2354), 32u, (_e2354 == 0u)));
                                        if (_e2365 < _e75) {
                                        } else {
                                            return;
                                        }
                                        let _e2372 = triangles.member[(0u + _e2365)].v0_;
                                        let _e2374 = (_e2372.x - _e120);
                                        let _e2376 = (_e2372.y - _e122);
                                        let _e2378 = (_e2372.z - _e124);
                                        if (_e1751 == 0u) {
                                            phi_2721_ = vec3<f32>(_e2376, _e2378, _e2374);
                                        } else {
                                            if (_e1751 == 1u) {
                                                phi_2720_ = vec3<f32>(_e2378, _e2374, _e2376);
                                            } else {
                                                phi_2720_ = (_e2372 - vec3<f32>(_e120, _e122, _e124));
                                            }
                                            let _e2386 = phi_2720_;
                                            phi_2721_ = _e2386;
                                        }
                                        let _e2388 = phi_2721_;
                                        let _e2392 = (_e2388.x - (_e1762 * _e2388.z));
                                        let _e2396 = (_e2388.y - (_e1765 * _e2388.z));
                                        let _e2398 = triangles.member[(0u + _e2365)].v1_;
                                        let _e2400 = (_e2398.x - _e120);
                                        let _e2402 = (_e2398.y - _e122);
                                        let _e2404 = (_e2398.z - _e124);
                                        if (_e1751 == 0u) {
                                            phi_2751_ = vec3<f32>(_e2402, _e2404, _e2400);
                                        } else {
                                            if (_e1751 == 1u) {
                                                phi_2750_ = vec3<f32>(_e2404, _e2400, _e2402);
                                            } else {
                                                phi_2750_ = (_e2398 - vec3<f32>(_e120, _e122, _e124));
                                            }
                                            let _e2412 = phi_2750_;
                                            phi_2751_ = _e2412;
                                        }
                                        let _e2414 = phi_2751_;
                                        let _e2418 = (_e2414.x - (_e1762 * _e2414.z));
                                        let _e2422 = (_e2414.y - (_e1765 * _e2414.z));
                                        let _e2424 = triangles.member[(0u + _e2365)].v2_;
                                        let _e2426 = (_e2424.x - _e120);
                                        let _e2428 = (_e2424.y - _e122);
                                        let _e2430 = (_e2424.z - _e124);
                                        if (_e1751 == 0u) {
                                            phi_2781_ = vec3<f32>(_e2428, _e2430, _e2426);
                                        } else {
                                            if (_e1751 == 1u) {
                                                phi_2780_ = vec3<f32>(_e2430, _e2426, _e2428);
                                            } else {
                                                phi_2780_ = (_e2424 - vec3<f32>(_e120, _e122, _e124));
                                            }
                                            let _e2438 = phi_2780_;
                                            phi_2781_ = _e2438;
                                        }
                                        let _e2440 = phi_2781_;
                                        let _e2444 = (_e2440.x - (_e1762 * _e2440.z));
                                        let _e2448 = (_e2440.y - (_e1765 * _e2440.z));
                                        if (_e2418 < _e2444) {
                                            phi_2800_ = true;
                                        } else {
                                            if (_e2418 == _e2444) {
                                                phi_2799_ = (_e2422 < _e2448);
                                            } else {
                                                phi_2799_ = false;
                                            }
                                            let _e2453 = phi_2799_;
                                            phi_2800_ = _e2453;
                                        }
                                        let _e2455 = phi_2800_;
                                        if _e2455 {
                                            phi_2804_ = _e2448;
                                            phi_2805_ = _e2444;
                                            phi_2806_ = _e2422;
                                            phi_2807_ = _e2418;
                                        } else {
                                            phi_2804_ = _e2422;
                                            phi_2805_ = _e2418;
                                            phi_2806_ = _e2448;
                                            phi_2807_ = _e2444;
                                        }
                                        let _e2457 = phi_2804_;
                                        let _e2459 = phi_2805_;
                                        let _e2461 = phi_2806_;
                                        let _e2463 = phi_2807_;
                                        let _e2466 = ((_e2463 * _e2457) - (_e2461 * _e2459));
                                        if _e2455 {
                                            phi_2815_ = -(_e2466);
                                        } else {
                                            phi_2815_ = _e2466;
                                        }
                                        let _e2469 = phi_2815_;
                                        if (_e2444 < _e2392) {
                                            phi_2826_ = true;
                                        } else {
                                            if (_e2444 == _e2392) {
                                                phi_2825_ = (_e2448 < _e2396);
                                            } else {
                                                phi_2825_ = false;
                                            }
                                            let _e2474 = phi_2825_;
                                            phi_2826_ = _e2474;
                                        }
                                        let _e2476 = phi_2826_;
                                        if _e2476 {
                                            phi_2830_ = _e2396;
                                            phi_2831_ = _e2392;
                                            phi_2832_ = _e2448;
                                            phi_2833_ = _e2444;
                                        } else {
                                            phi_2830_ = _e2448;
                                            phi_2831_ = _e2444;
                                            phi_2832_ = _e2396;
                                            phi_2833_ = _e2392;
                                        }
                                        let _e2478 = phi_2830_;
                                        let _e2480 = phi_2831_;
                                        let _e2482 = phi_2832_;
                                        let _e2484 = phi_2833_;
                                        let _e2487 = ((_e2484 * _e2478) - (_e2482 * _e2480));
                                        if _e2476 {
                                            phi_2841_ = -(_e2487);
                                        } else {
                                            phi_2841_ = _e2487;
                                        }
                                        let _e2490 = phi_2841_;
                                        if (_e2392 < _e2418) {
                                            phi_2852_ = true;
                                        } else {
                                            if (_e2392 == _e2418) {
                                                phi_2851_ = (_e2396 < _e2422);
                                            } else {
                                                phi_2851_ = false;
                                            }
                                            let _e2495 = phi_2851_;
                                            phi_2852_ = _e2495;
                                        }
                                        let _e2497 = phi_2852_;
                                        if _e2497 {
                                            phi_2856_ = _e2422;
                                            phi_2857_ = _e2418;
                                            phi_2858_ = _e2396;
                                            phi_2859_ = _e2392;
                                        } else {
                                            phi_2856_ = _e2396;
                                            phi_2857_ = _e2392;
                                            phi_2858_ = _e2422;
                                            phi_2859_ = _e2418;
                                        }
                                        let _e2499 = phi_2856_;
                                        let _e2501 = phi_2857_;
                                        let _e2503 = phi_2858_;
                                        let _e2505 = phi_2859_;
                                        let _e2508 = ((_e2505 * _e2499) - (_e2503 * _e2501));
                                        if _e2497 {
                                            phi_2867_ = -(_e2508);
                                        } else {
                                            phi_2867_ = _e2508;
                                        }
                                        let _e2511 = phi_2867_;
                                        if (_e2469 >= 0f) {
                                            if (_e2490 >= 0f) {
                                                if (_e2511 >= 0f) {
                                                    phi_2882_ = ((_e2469 + _e2490) + _e2511);
                                                    phi_2883_ = false;
                                                } else {
                                                    phi_2882_ = f32();
                                                    phi_2883_ = true;
                                                }
                                                let _e2518 = phi_2882_;
                                                let _e2520 = phi_2883_;
                                                phi_2884_ = _e2518;
                                                phi_2885_ = _e2520;
                                            } else {
                                                phi_2884_ = f32();
                                                phi_2885_ = true;
                                            }
                                            let _e2522 = phi_2884_;
                                            let _e2524 = phi_2885_;
                                            phi_2886_ = _e2522;
                                            phi_2887_ = _e2524;
                                        } else {
                                            phi_2886_ = f32();
                                            phi_2887_ = true;
                                        }
                                        let _e2526 = phi_2886_;
                                        let _e2528 = phi_2887_;
                                        if _e2528 {
                                            if (_e2469 <= 0f) {
                                                if (_e2490 <= 0f) {
                                                    let _e2531 = (_e2511 <= 0f);
                                                    if _e2531 {
                                                    }
                                                    phi_2905_ = ((_e2469 + _e2490) + _e2511);
                                                    phi_2906_ = false;
                                                    phi_2907_ = _e2531;
                                                } else {
                                                    phi_2905_ = f32();
                                                    phi_2906_ = true;
                                                    phi_2907_ = false;
                                                }
                                                let _e2535 = phi_2905_;
                                                let _e2537 = phi_2906_;
                                                let _e2539 = phi_2907_;
                                                phi_2908_ = _e2535;
                                                phi_2909_ = _e2537;
                                                phi_2910_ = _e2539;
                                            } else {
                                                phi_2908_ = f32();
                                                phi_2909_ = true;
                                                phi_2910_ = false;
                                            }
                                            let _e2541 = phi_2908_;
                                            let _e2543 = phi_2909_;
                                            let _e2545 = phi_2910_;
                                            if _e2543 {
                                                phi_2914_ = false;
                                            } else {
                                                phi_2914_ = _e2545;
                                            }
                                            let _e2547 = phi_2914_;
                                            phi_2915_ = _e2541;
                                            phi_2916_ = _e2547;
                                        } else {
                                            phi_2915_ = _e2526;
                                            phi_2916_ = true;
                                        }
                                        let _e2549 = phi_2915_;
                                        let _e2551 = phi_2916_;
                                        if _e2551 {
                                            let _e2552 = (_e2549 == 0f);
                                            if _e2552 {
                                                phi_3232_ = lt_bvh_triangle_Intersection();
                                                phi_3233_ = false;
                                            } else {
                                                let _e2554 = triangles.member[(0u + _e2365)].v0_;
                                                let _e2556 = (_e2554.x - _e120);
                                                let _e2558 = (_e2554.y - _e122);
                                                let _e2560 = (_e2554.z - _e124);
                                                if (_e1751 == 0u) {
                                                    phi_2945_ = vec3<f32>(_e2558, _e2560, _e2556);
                                                } else {
                                                    if (_e1751 == 1u) {
                                                        phi_2944_ = vec3<f32>(_e2560, _e2556, _e2558);
                                                    } else {
                                                        phi_2944_ = (_e2554 - vec3<f32>(_e120, _e122, _e124));
                                                    }
                                                    let _e2568 = phi_2944_;
                                                    phi_2945_ = _e2568;
                                                }
                                                let _e2570 = phi_2945_;
                                                let _e2572 = triangles.member[(0u + _e2365)].v1_;
                                                let _e2574 = triangles.member[(0u + _e2365)].v0_;
                                                let _e2577 = (_e2572.x - _e2574.x);
                                                let _e2580 = (_e2572.y - _e2574.y);
                                                let _e2583 = (_e2572.z - _e2574.z);
                                                if (_e1751 == 0u) {
                                                    phi_2971_ = vec3<f32>(_e2580, _e2583, _e2577);
                                                } else {
                                                    if (_e1751 == 1u) {
                                                        phi_2970_ = vec3<f32>(_e2583, _e2577, _e2580);
                                                    } else {
                                                        phi_2970_ = (_e2572 - _e2574);
                                                    }
                                                    let _e2590 = phi_2970_;
                                                    phi_2971_ = _e2590;
                                                }
                                                let _e2592 = phi_2971_;
                                                let _e2594 = triangles.member[(0u + _e2365)].v2_;
                                                let _e2596 = triangles.member[(0u + _e2365)].v0_;
                                                let _e2599 = (_e2594.x - _e2596.x);
                                                let _e2602 = (_e2594.y - _e2596.y);
                                                let _e2605 = (_e2594.z - _e2596.z);
                                                if (_e1751 == 0u) {
                                                    phi_2997_ = vec3<f32>(_e2602, _e2605, _e2599);
                                                } else {
                                                    if (_e1751 == 1u) {
                                                        phi_2996_ = vec3<f32>(_e2605, _e2599, _e2602);
                                                    } else {
                                                        phi_2996_ = (_e2594 - _e2596);
                                                    }
                                                    let _e2612 = phi_2996_;
                                                    phi_2997_ = _e2612;
                                                }
                                                let _e2614 = phi_2997_;
                                                let _e2621 = ((_e2592.y * _e2614.z) - (_e2592.z * _e2614.y));
                                                let _e2628 = ((_e2592.z * _e2614.x) - (_e2592.x * _e2614.z));
                                                let _e2635 = ((_e2592.x * _e2614.y) - (_e2592.y * _e2614.x));
                                                let _e2649 = (((1f / _e1759.z) * (((_e2621 * _e2570.x) + (_e2628 * _e2570.y)) + (_e2635 * _e2570.z))) / (((_e2621 * _e1762) + (_e2628 * _e1765)) + _e2635));
                                                if (_e2649 > 0f) {
                                                    if (_e2649 < _e132) {
                                                        let _e2653 = triangles.member[(0u + _e2365)].v0_;
                                                        let _e2655 = triangles.member[(0u + _e2365)].v1_;
                                                        if (_e2653.x < _e2655.x) {
                                                            phi_3053_ = _e2653.x;
                                                        } else {
                                                            phi_3053_ = _e2655.x;
                                                        }
                                                        let _e2662 = phi_3053_;
                                                        if (_e2653.y < _e2655.y) {
                                                            phi_3062_ = _e2653.y;
                                                        } else {
                                                            phi_3062_ = _e2655.y;
                                                        }
                                                        let _e2669 = phi_3062_;
                                                        if (_e2653.z < _e2655.z) {
                                                            phi_3071_ = _e2653.z;
                                                        } else {
                                                            phi_3071_ = _e2655.z;
                                                        }
                                                        let _e2676 = phi_3071_;
                                                        let _e2678 = triangles.member[(0u + _e2365)].v2_;
                                                        if (_e2662 < _e2678.x) {
                                                            phi_3080_ = _e2662;
                                                        } else {
                                                            phi_3080_ = _e2678.x;
                                                        }
                                                        let _e2683 = phi_3080_;
                                                        if (_e2669 < _e2678.y) {
                                                            phi_3087_ = _e2669;
                                                        } else {
                                                            phi_3087_ = _e2678.y;
                                                        }
                                                        let _e2688 = phi_3087_;
                                                        if (_e2676 < _e2678.z) {
                                                            phi_3094_ = _e2676;
                                                        } else {
                                                            phi_3094_ = _e2678.z;
                                                        }
                                                        let _e2693 = phi_3094_;
                                                        let _e2695 = triangles.member[(0u + _e2365)].v0_;
                                                        let _e2697 = triangles.member[(0u + _e2365)].v1_;
                                                        if (_e2695.x > _e2697.x) {
                                                            phi_3107_ = _e2695.x;
                                                        } else {
                                                            phi_3107_ = _e2697.x;
                                                        }
                                                        let _e2704 = phi_3107_;
                                                        if (_e2695.y > _e2697.y) {
                                                            phi_3116_ = _e2695.y;
                                                        } else {
                                                            phi_3116_ = _e2697.y;
                                                        }
                                                        let _e2711 = phi_3116_;
                                                        if (_e2695.z > _e2697.z) {
                                                            phi_3125_ = _e2695.z;
                                                        } else {
                                                            phi_3125_ = _e2697.z;
                                                        }
                                                        let _e2718 = phi_3125_;
                                                        let _e2720 = triangles.member[(0u + _e2365)].v2_;
                                                        if (_e2704 > _e2720.x) {
                                                            phi_3134_ = _e2704;
                                                        } else {
                                                            phi_3134_ = _e2720.x;
                                                        }
                                                        let _e2725 = phi_3134_;
                                                        if (_e2711 > _e2720.y) {
                                                            phi_3141_ = _e2711;
                                                        } else {
                                                            phi_3141_ = _e2720.y;
                                                        }
                                                        let _e2730 = phi_3141_;
                                                        if (_e2718 > _e2720.z) {
                                                            phi_3148_ = _e2718;
                                                        } else {
                                                            phi_3148_ = _e2720.z;
                                                        }
                                                        let _e2735 = phi_3148_;
                                                        let _e2739 = ((_e2683 - _e120) * _e1676);
                                                        let _e2740 = ((_e2688 - _e122) * _e1686);
                                                        let _e2741 = ((_e2693 - _e124) * _e1696);
                                                        let _e2745 = ((_e2725 - _e120) * _e1676);
                                                        let _e2746 = ((_e2730 - _e122) * _e1686);
                                                        let _e2747 = ((_e2735 - _e124) * _e1696);
                                                        if (_e2739 < _e2745) {
                                                            phi_3165_ = _e2739;
                                                        } else {
                                                            phi_3165_ = _e2745;
                                                        }
                                                        let _e2750 = phi_3165_;
                                                        if (_e2740 < _e2746) {
                                                            phi_3170_ = _e2740;
                                                        } else {
                                                            phi_3170_ = _e2746;
                                                        }
                                                        let _e2753 = phi_3170_;
                                                        if (_e2741 < _e2747) {
                                                            phi_3175_ = _e2741;
                                                        } else {
                                                            phi_3175_ = _e2747;
                                                        }
                                                        let _e2756 = phi_3175_;
                                                        if (_e2739 > _e2745) {
                                                            phi_3183_ = _e2739;
                                                        } else {
                                                            phi_3183_ = _e2745;
                                                        }
                                                        let _e2762 = phi_3183_;
                                                        if (_e2740 > _e2746) {
                                                            phi_3188_ = _e2740;
                                                        } else {
                                                            phi_3188_ = _e2746;
                                                        }
                                                        let _e2765 = phi_3188_;
                                                        if (_e2741 > _e2747) {
                                                            phi_3193_ = _e2741;
                                                        } else {
                                                            phi_3193_ = _e2747;
                                                        }
                                                        let _e2768 = phi_3193_;
                                                        let _e2772 = core_intrinsics_maximum_number_nsz_f32_((_e2750 - _e1735), (_e2753 - _e1736));
                                                        let _e2773 = core_intrinsics_maximum_number_nsz_f32_(_e2772, (_e2756 - _e1737));
                                                        let _e2774 = core_intrinsics_minimum_number_nsz_f32_((_e2762 + _e1735), (_e2765 + _e1736));
                                                        let _e2775 = core_intrinsics_minimum_number_nsz_f32_(_e2774, (_e2768 + _e1737));
                                                        if (_e2773 > -300000000000000000000000000000000000000f) {
                                                            phi_3205_ = _e2773;
                                                        } else {
                                                            phi_3205_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2778 = phi_3205_;
                                                        if (_e2775 < 300000000000000000000000000000000000000f) {
                                                            phi_3210_ = _e2775;
                                                        } else {
                                                            phi_3210_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2781 = phi_3210_;
                                                        if (_e2649 < _e2778) {
                                                            phi_3215_ = _e2778;
                                                        } else {
                                                            phi_3215_ = _e2649;
                                                        }
                                                        let _e2784 = phi_3215_;
                                                        if (_e2784 > _e2781) {
                                                            phi_3220_ = _e2781;
                                                        } else {
                                                            phi_3220_ = _e2784;
                                                        }
                                                        let _e2787 = phi_3220_;
                                                        phi_3225_ = lt_bvh_triangle_Intersection(_e2787, (_e2490 / _e2549), (_e2511 / _e2549), (_e2778 <= _e2781));
                                                        phi_3226_ = false;
                                                    } else {
                                                        phi_3225_ = lt_bvh_triangle_Intersection();
                                                        phi_3226_ = true;
                                                    }
                                                    let _e2793 = phi_3225_;
                                                    let _e2795 = phi_3226_;
                                                    phi_3227_ = _e2793;
                                                    phi_3228_ = _e2795;
                                                } else {
                                                    phi_3227_ = lt_bvh_triangle_Intersection();
                                                    phi_3228_ = true;
                                                }
                                                let _e2797 = phi_3227_;
                                                let _e2799 = phi_3228_;
                                                if _e2799 {
                                                }
                                                phi_3232_ = _e2797;
                                                phi_3233_ = _e2799;
                                            }
                                            let _e2801 = phi_3232_;
                                            let _e2803 = phi_3233_;
                                            phi_3234_ = _e2801;
                                            phi_3235_ = _e2552;
                                            phi_3236_ = _e2803;
                                        } else {
                                            phi_3234_ = lt_bvh_triangle_Intersection();
                                            phi_3235_ = true;
                                            phi_3236_ = false;
                                        }
                                        let _e2805 = phi_3234_;
                                        let _e2807 = phi_3235_;
                                        let _e2809 = phi_3236_;
                                        if _e2807 {
                                            phi_3240_ = true;
                                        } else {
                                            phi_3240_ = _e2809;
                                        }
                                        let _e2811 = phi_3240_;
                                        if _e2811 {
                                            phi_3244_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3244_ = _e2805;
                                        }
                                        let _e2813 = phi_3244_;
                                        if _e2813.is_hit {
                                            if (_e2813.t > 0f) {
                                                if (_e2813.t < _e132) {
                                                    if true {
                                                        phi_3264_ = false;
                                                    } else {
                                                        phi_3264_ = true;
                                                    }
                                                    let _e2822 = phi_3264_;
                                                    phi_3265_ = true;
                                                    phi_3266_ = _e2822;
                                                } else {
                                                    phi_3265_ = _e2356;
                                                    phi_3266_ = true;
                                                }
                                                let _e2824 = phi_3265_;
                                                let _e2826 = phi_3266_;
                                                phi_3267_ = _e2824;
                                                phi_3268_ = _e2826;
                                            } else {
                                                phi_3267_ = _e2356;
                                                phi_3268_ = true;
                                            }
                                            let _e2828 = phi_3267_;
                                            let _e2830 = phi_3268_;
                                            phi_3269_ = _e2828;
                                            phi_3270_ = _e2830;
                                        } else {
                                            phi_3269_ = _e2356;
                                            phi_3270_ = true;
                                        }
                                        let _e2832 = phi_3269_;
                                        let _e2834 = phi_3270_;
                                        if _e2834 {
                                        }
                                        phi_2674_ = (_e2354 & (_e2354 - 1u));
                                        phi_2677_ = _e2832;
                                        phi_3274_ = _e2834;
                                    }
                                    let _e2836 = phi_2674_;
                                    let _e2838 = phi_2677_;
                                    let _e2840 = phi_3274_;
                                    continue;
                                    continuing {
                                        phi_2673_ = _e2836;
                                        phi_2676_ = _e2838;
                                        break if !(_e2840);
                                    }
                                }
                                let _e2843 = local_11;
                                if _e2843 {
                                    let _e2845 = local.group_mask;
                                    if ((_e2845 & 4278190080u) == 0u) {
                                        let _e2849 = local.len;
                                        if (_e2849 == 0u) {
                                            phi_3316_ = false;
                                        } else {
                                            let _e2853 = local.len;
                                            local.len = (_e2853 - 1u);
                                            let _e2856 = local.len;
                                            if (_e2856 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2861 = local.first[(0u + _e2856)];
                                            local.group = _e2861;
                                            let _e2864 = local.len;
                                            if (_e2864 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2869 = local.mask[(0u + _e2864)];
                                            local.group_mask = _e2869;
                                            phi_3316_ = true;
                                        }
                                        let _e2872 = phi_3316_;
                                        phi_3317_ = _e2872;
                                    } else {
                                        phi_3317_ = true;
                                    }
                                    let _e2874 = phi_3317_;
                                    if _e2874 {
                                        let _e2876 = local.group_mask;
                                        let _e2882 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2876)), 32u, (_e2876 == 0u)));
                                        let _e2886 = local.group_mask;
                                        let _e2900 = local.group_mask;
                                        local.group_mask = (_e2900 & ~((1u << bitcast<u32>((_e2882 & 31u)))));
                                        let _e2903 = local.group;
                                        phi_3348_ = (_e2903 + countOneBits(((_e2886 & ~((4294967295u << bitcast<u32>((((_e2882 - 24u) ^ _e1778) & 31u))))) & 255u)));
                                    } else {
                                        phi_3348_ = 4294967295u;
                                    }
                                    let _e2906 = phi_3348_;
                                    phi_3349_ = _e2906;
                                } else {
                                    phi_3349_ = u32();
                                }
                                let _e2908 = phi_3349_;
                                phi_2342_ = _e2908;
                                let _e3355 = local_21;
                                phi_2345_ = _e3355;
                                let _e3358 = local_22;
                                phi_3350_ = _e3358;
                                phi_3351_ = false;
                            } else {
                                phi_2342_ = u32();
                                phi_2345_ = bool();
                                phi_3350_ = false;
                                phi_3351_ = true;
                            }
                            let _e2910 = phi_2342_;
                            let _e2912 = phi_2345_;
                            let _e2914 = phi_3350_;
                            let _e2916 = phi_3351_;
                            local_12 = _e2916;
                            continue;
                            continuing {
                                phi_2341_ = _e2910;
                                phi_2344_ = _e2912;
                                break if !(_e2914);
                            }
                        }
                        let _e2919 = local_12;
                        if _e2919 {
                            phi_3355_ = false;
                        } else {
                            phi_3355_ = true;
                        }
                        let _e2921 = phi_3355_;
                        if _e2921 {
                            phi_3359_ = true;
                        } else {
                            let _e3364 = local_23;
                            phi_3359_ = _e3364;
                        }
                        let _e2923 = phi_3359_;
                        phi_3360_ = _e2923;
                    }
                    let _e2925 = phi_3360_;
                    phi_3361_ = _e2925;
                    phi_3362_ = _e1600;
                } else {
                    phi_3361_ = bool();
                    phi_3362_ = true;
                }
                let _e2927 = phi_3361_;
                let _e2929 = phi_3362_;
                if _e2929 {
                    phi_3366_ = false;
                } else {
                    phi_3366_ = _e2927;
                }
                let _e2931 = phi_3366_;
                phi_3367_ = _e2931;
            }
            let _e2933 = phi_3367_;
            phi_3368_ = _e2933;
        } else {
            phi_3368_ = false;
        }
        let _e2935 = phi_3368_;
        if _e2935 {
            phi_3372_ = 0f;
        } else {
            phi_3372_ = 1f;
        }
        let _e2937 = phi_3372_;
        if (_e99 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99)] = _e2937;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
