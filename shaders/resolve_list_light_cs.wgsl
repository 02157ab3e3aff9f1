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
    var phi_282_: f32;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_322_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_342_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_369_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_401_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_420_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_447_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_476_: u32;
    var phi_477_: f32;
    var phi_478_: u32;
    var phi_479_: f32;
    var phi_484_: f32;
    var phi_495_: u32;
    var phi_505_: u32;
    var phi_511_: u32;
    var phi_512_: u32;
    var phi_513_: u32;
    var phi_524_: vec3<f32>;
    var phi_525_: vec3<f32>;
    var phi_547_: vec3<f32>;
    var phi_548_: vec3<f32>;
    var phi_570_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_645_: f32;
    var phi_652_: f32;
    var phi_659_: f32;
    var phi_666_: f32;
    var phi_673_: f32;
    var phi_680_: f32;
    var phi_697_: f32;
    var phi_702_: f32;
    var phi_707_: f32;
    var phi_712_: f32;
    var phi_717_: f32;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_748_: u32;
    var phi_749_: u32;
    var phi_760_: vec3<f32>;
    var phi_761_: vec3<f32>;
    var phi_773_: u32;
    var phi_776_: u32;
    var phi_781_: u32;
    var phi_783_: u32;
    var phi_785_: u32;
    var phi_787_: u32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_874_: u32;
    var phi_897_: f32;
    var phi_898_: f32;
    var phi_912_: u32;
    var phi_934_: f32;
    var phi_935_: f32;
    var phi_949_: u32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_987_: u32;
    var phi_1179_: u32;
    var phi_1180_: u32;
    var phi_1185_: u32;
    var phi_1186_: u32;
    var phi_1187_: u32;
    var phi_784_: u32;
    var phi_786_: u32;
    var phi_1188_: u32;
    var phi_1206_: u32;
    var phi_1207_: u32;
    var phi_774_: u32;
    var phi_777_: u32;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var local_2: bool;
    var local_3: u32;
    var phi_1227_: u32;
    var local_4: u32;
    var phi_1262_: u32;
    var phi_1263_: u32;
    var phi_1269_: u32;
    var phi_1297_: vec3<f32>;
    var phi_1298_: vec3<f32>;
    var phi_1327_: vec3<f32>;
    var phi_1328_: vec3<f32>;
    var phi_1357_: vec3<f32>;
    var phi_1358_: vec3<f32>;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1381_: f32;
    var phi_1382_: f32;
    var phi_1383_: f32;
    var phi_1384_: f32;
    var phi_1392_: f32;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1407_: f32;
    var phi_1408_: f32;
    var phi_1409_: f32;
    var phi_1410_: f32;
    var phi_1418_: f32;
    var phi_1428_: bool;
    var phi_1429_: bool;
    var phi_1433_: f32;
    var phi_1434_: f32;
    var phi_1435_: f32;
    var phi_1436_: f32;
    var phi_1444_: f32;
    var phi_1459_: f32;
    var phi_1460_: bool;
    var phi_1461_: f32;
    var phi_1462_: bool;
    var phi_1463_: f32;
    var phi_1464_: bool;
    var phi_1482_: f32;
    var phi_1483_: bool;
    var phi_1484_: bool;
    var phi_1485_: f32;
    var phi_1486_: bool;
    var phi_1487_: bool;
    var phi_1491_: bool;
    var phi_1492_: f32;
    var phi_1493_: bool;
    var phi_1521_: vec3<f32>;
    var phi_1522_: vec3<f32>;
    var phi_1547_: vec3<f32>;
    var phi_1548_: vec3<f32>;
    var phi_1573_: vec3<f32>;
    var phi_1574_: vec3<f32>;
    var phi_1630_: f32;
    var phi_1639_: f32;
    var phi_1648_: f32;
    var phi_1657_: f32;
    var phi_1664_: f32;
    var phi_1671_: f32;
    var phi_1684_: f32;
    var phi_1693_: f32;
    var phi_1702_: f32;
    var phi_1711_: f32;
    var phi_1718_: f32;
    var phi_1725_: f32;
    var phi_1742_: f32;
    var phi_1747_: f32;
    var phi_1752_: f32;
    var phi_1760_: f32;
    var phi_1765_: f32;
    var phi_1770_: f32;
    var phi_1782_: f32;
    var phi_1787_: f32;
    var phi_1792_: f32;
    var phi_1797_: f32;
    var phi_1802_: lt_bvh_triangle_Intersection;
    var phi_1803_: bool;
    var phi_1804_: lt_bvh_triangle_Intersection;
    var phi_1805_: bool;
    var phi_1809_: lt_bvh_triangle_Intersection;
    var phi_1810_: bool;
    var phi_1811_: lt_bvh_triangle_Intersection;
    var phi_1812_: bool;
    var phi_1813_: bool;
    var phi_1817_: bool;
    var phi_1821_: lt_bvh_triangle_Intersection;
    var phi_1846_: bool;
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
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var local_5: bool;
    var phi_1881_: bool;
    var phi_1882_: bool;
    var phi_1883_: bool;
    var phi_1884_: bool;
    var phi_1885_: bool;
    var local_6: u32;
    var phi_1893_: bool;
    var phi_1894_: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var local_7: bool;
    var phi_1900_: bool;
    var phi_1904_: bool;
    var phi_1908_: bool;
    var phi_1909_: bool;
    var phi_1925_: bool;
    var phi_1926_: bool;
    var phi_1927_: bool;
    var phi_1928_: bool;
    var phi_1932_: bool;
    var phi_1945_: bool;
    var phi_1946_: bool;
    var phi_1947_: bool;
    var phi_1948_: bool;
    var phi_1952_: bool;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1971_: bool;
    var phi_1972_: bool;
    var phi_1973_: bool;
    var phi_1974_: bool;
    var phi_1975_: bool;
    var phi_1979_: bool;
    var phi_2049_: f32;
    var phi_2056_: f32;
    var phi_2063_: f32;
    var phi_2070_: f32;
    var phi_2077_: f32;
    var phi_2084_: f32;
    var phi_2101_: f32;
    var phi_2106_: f32;
    var phi_2111_: f32;
    var phi_2116_: f32;
    var phi_2121_: f32;
    var phi_2147_: bool;
    var phi_2148_: bool;
    var phi_2156_: u32;
    var phi_2157_: u32;
    var phi_2168_: vec3<f32>;
    var phi_2169_: vec3<f32>;
    var phi_2182_: u32;
    var phi_2187_: u32;
    var phi_2192_: u32;
    var phi_2306_: bool;
    var phi_2307_: bool;
    var phi_2338_: u32;
    var phi_2340_: u32;
    var phi_2343_: bool;
    var phi_2423_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2450_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2477_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2483_: u32;
    var phi_2486_: u32;
    var phi_2500_: u32;
    var phi_2510_: u32;
    var phi_2520_: u32;
    var phi_2538_: u32;
    var phi_2548_: u32;
    var phi_2558_: u32;
    var phi_2594_: u32;
    var phi_2607_: u32;
    var phi_2612_: u32;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_2484_: u32;
    var phi_2487_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_2672_: u32;
    var phi_2675_: bool;
    var phi_2719_: vec3<f32>;
    var phi_2720_: vec3<f32>;
    var phi_2749_: vec3<f32>;
    var phi_2750_: vec3<f32>;
    var phi_2779_: vec3<f32>;
    var phi_2780_: vec3<f32>;
    var phi_2798_: bool;
    var phi_2799_: bool;
    var phi_2803_: f32;
    var phi_2804_: f32;
    var phi_2805_: f32;
    var phi_2806_: f32;
    var phi_2814_: f32;
    var phi_2824_: bool;
    var phi_2825_: bool;
    var phi_2829_: f32;
    var phi_2830_: f32;
    var phi_2831_: f32;
    var phi_2832_: f32;
    var phi_2840_: f32;
    var phi_2850_: bool;
    var phi_2851_: bool;
    var phi_2855_: f32;
    var phi_2856_: f32;
    var phi_2857_: f32;
    var phi_2858_: f32;
    var phi_2866_: f32;
    var phi_2881_: f32;
    var phi_2882_: bool;
    var phi_2883_: f32;
    var phi_2884_: bool;
    var phi_2885_: f32;
    var phi_2886_: bool;
    var phi_2904_: f32;
    var phi_2905_: bool;
    var phi_2906_: bool;
    var phi_2907_: f32;
    var phi_2908_: bool;
    var phi_2909_: bool;
    var phi_2913_: bool;
    var phi_2914_: f32;
    var phi_2915_: bool;
    var phi_2943_: vec3<f32>;
    var phi_2944_: vec3<f32>;
    var phi_2969_: vec3<f32>;
    var phi_2970_: vec3<f32>;
    var phi_2995_: vec3<f32>;
    var phi_2996_: vec3<f32>;
    var phi_3052_: f32;
    var phi_3061_: f32;
    var phi_3070_: f32;
    var phi_3079_: f32;
    var phi_3086_: f32;
    var phi_3093_: f32;
    var phi_3106_: f32;
    var phi_3115_: f32;
    var phi_3124_: f32;
    var phi_3133_: f32;
    var phi_3140_: f32;
    var phi_3147_: f32;
    var phi_3164_: f32;
    var phi_3169_: f32;
    var phi_3174_: f32;
    var phi_3182_: f32;
    var phi_3187_: f32;
    var phi_3192_: f32;
    var phi_3204_: f32;
    var phi_3209_: f32;
    var phi_3214_: f32;
    var phi_3219_: f32;
    var phi_3224_: lt_bvh_triangle_Intersection;
    var phi_3225_: bool;
    var phi_3226_: lt_bvh_triangle_Intersection;
    var phi_3227_: bool;
    var phi_3231_: lt_bvh_triangle_Intersection;
    var phi_3232_: bool;
    var phi_3233_: lt_bvh_triangle_Intersection;
    var phi_3234_: bool;
    var phi_3235_: bool;
    var phi_3239_: bool;
    var phi_3243_: lt_bvh_triangle_Intersection;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_2673_: u32;
    var phi_2676_: bool;
    var phi_3273_: bool;
    var local_11: bool;
    var phi_3315_: bool;
    var phi_3316_: bool;
    var phi_3347_: u32;
    var phi_3348_: u32;
    var phi_2341_: u32;
    var phi_2344_: bool;
    var phi_3349_: bool;
    var phi_3350_: bool;
    var local_12: bool;
    var phi_3354_: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3361_: bool;
    var phi_3365_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3371_: f32;
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
        let _e99 = space.member;
        if (_e98 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e105 = samples.member[(0u + _e98)].position;
        let _e107 = samples.member[(0u + _e98)].normal;
        let _e109 = samples.member[(0u + _e98)].magnitude;
        let _e111 = ((8f / 8388608f) * _e109);
        let _e113 = (_e107.x * _e111);
        let _e115 = (_e107.y * _e111);
        let _e117 = (_e107.z * _e111);
        let _e119 = (_e105.x + _e113);
        let _e121 = (_e105.y + _e115);
        let _e123 = (_e105.z + _e117);
        let _e127 = p.member.light.place;
        if (_e127.w == 0f) {
            phi_282_ = 300000000000000000000000000000000000000f;
        } else {
            phi_282_ = 1f;
        }
        let _e131 = phi_282_;
        let _e139 = (_e127.x - (_e119 * _e127.w));
        let _e140 = (_e127.y - (_e121 * _e127.w));
        let _e141 = (_e127.z - (_e123 * _e127.w));
        let _e142 = vec3<f32>(_e139, _e140, _e141);
        let _e143 = abs(_e139);
        let _e144 = abs(_e140);
        let _e145 = abs(_e141);
        if (abs(_e119) < 1000000000000000f) {
            if (abs(_e121) < 1000000000000000f) {
                phi_315_ = (abs(_e123) < 1000000000000000f);
                phi_316_ = false;
            } else {
                phi_315_ = bool();
                phi_316_ = true;
            }
            let _e153 = phi_315_;
            let _e155 = phi_316_;
            phi_317_ = _e153;
            phi_318_ = _e155;
        } else {
            phi_317_ = bool();
            phi_318_ = true;
        }
        let _e157 = phi_317_;
        let _e159 = phi_318_;
        if _e159 {
            phi_322_ = false;
        } else {
            phi_322_ = _e157;
        }
        let _e161 = phi_322_;
        if _e161 {
            if (_e143 < 1000000000000000f) {
                if (_e144 < 1000000000000000f) {
                    phi_335_ = (_e145 < 1000000000000000f);
                    phi_336_ = false;
                } else {
                    phi_335_ = bool();
                    phi_336_ = true;
                }
                let _e166 = phi_335_;
                let _e168 = phi_336_;
                phi_337_ = _e166;
                phi_338_ = _e168;
            } else {
                phi_337_ = bool();
                phi_338_ = true;
            }
            let _e170 = phi_337_;
            let _e172 = phi_338_;
            if _e172 {
                phi_342_ = false;
            } else {
                phi_342_ = _e170;
            }
            let _e174 = phi_342_;
            if _e174 {
                if (_e143 > 0f) {
                    phi_356_ = bool();
                    phi_357_ = true;
                } else {
                    let _e176 = (_e144 > 0f);
                    if _e176 {
                        phi_355_ = bool();
                    } else {
                        phi_355_ = (_e145 > 0f);
                    }
                    let _e179 = phi_355_;
                    phi_356_ = _e179;
                    phi_357_ = _e176;
                }
                let _e181 = phi_356_;
                let _e183 = phi_357_;
                if _e183 {
                    phi_361_ = true;
                } else {
                    phi_361_ = _e181;
                }
                let _e185 = phi_361_;
                phi_362_ = _e185;
                phi_363_ = false;
            } else {
                phi_362_ = bool();
                phi_363_ = true;
            }
            let _e187 = phi_362_;
            let _e189 = phi_363_;
            phi_364_ = _e187;
            phi_365_ = _e189;
        } else {
            phi_364_ = bool();
            phi_365_ = true;
        }
        let _e191 = phi_364_;
        let _e193 = phi_365_;
        if _e193 {
            phi_369_ = false;
        } else {
            phi_369_ = _e191;
        }
        let _e195 = phi_369_;
        if _e195 {
            if (_e99.low.x <= _e119) {
                if (_e119 <= _e99.high.x) {
                    if (_e99.low.y <= _e121) {
                        phi_392_ = (_e121 <= _e99.high.y);
                        phi_393_ = false;
                    } else {
                        phi_392_ = bool();
                        phi_393_ = true;
                    }
                    let _e213 = phi_392_;
                    let _e215 = phi_393_;
                    phi_394_ = _e213;
                    phi_395_ = _e215;
                } else {
                    phi_394_ = bool();
                    phi_395_ = true;
                }
                let _e217 = phi_394_;
                let _e219 = phi_395_;
                phi_396_ = _e217;
                phi_397_ = _e219;
            } else {
                phi_396_ = bool();
                phi_397_ = true;
            }
            let _e221 = phi_396_;
            let _e223 = phi_397_;
            if _e223 {
                phi_401_ = false;
            } else {
                phi_401_ = _e221;
            }
            let _e225 = phi_401_;
            if (abs(_e139) > 0.000000000000000000000000000001f) {
                phi_415_ = bool();
                phi_416_ = true;
            } else {
                let _e230 = (abs(_e140) > 0.000000000000000000000000000001f);
                if _e230 {
                    phi_414_ = bool();
                } else {
                    phi_414_ = (abs(_e141) > 0.000000000000000000000000000001f);
                }
                let _e233 = phi_414_;
                phi_415_ = _e233;
                phi_416_ = _e230;
            }
            let _e235 = phi_415_;
            let _e237 = phi_416_;
            if _e237 {
                phi_420_ = true;
            } else {
                phi_420_ = _e235;
            }
            let _e239 = phi_420_;
            if _e225 {
                if (_e99.low.z <= _e123) {
                    if (_e123 <= _e99.high.z) {
                        if (_e99.is_parallel == 0u) {
                            phi_437_ = _e239;
                        } else {
                            phi_437_ = true;
                        }
                        let _e245 = phi_437_;
                        phi_438_ = _e245;
                        phi_439_ = false;
                    } else {
                        phi_438_ = bool();
                        phi_439_ = true;
                    }
                    let _e247 = phi_438_;
                    let _e249 = phi_439_;
                    phi_440_ = _e247;
                    phi_441_ = _e249;
                } else {
                    phi_440_ = bool();
                    phi_441_ = true;
                }
                let _e251 = phi_440_;
                let _e253 = phi_441_;
                phi_442_ = _e251;
                phi_443_ = _e253;
            } else {
                phi_442_ = bool();
                phi_443_ = true;
            }
            let _e255 = phi_442_;
            let _e257 = phi_443_;
            if _e257 {
                phi_447_ = false;
            } else {
                phi_447_ = _e255;
            }
            let _e259 = phi_447_;
            if _e259 {
                if (_e99.is_parallel == 0u) {
                    let _e262 = abs(_e139);
                    let _e263 = abs(_e140);
                    let _e264 = abs(_e141);
                    if (_e262 >= _e263) {
                        if (_e262 >= _e264) {
                            phi_467_ = false;
                        } else {
                            phi_467_ = true;
                        }
                        let _e268 = phi_467_;
                        phi_468_ = _e268;
                    } else {
                        phi_468_ = true;
                    }
                    let _e270 = phi_468_;
                    if _e270 {
                        if (_e263 >= _e264) {
                            phi_476_ = 1u;
                            phi_477_ = _e140;
                        } else {
                            phi_476_ = 2u;
                            phi_477_ = _e141;
                        }
                        let _e273 = phi_476_;
                        let _e275 = phi_477_;
                        phi_478_ = _e273;
                        phi_479_ = _e275;
                    } else {
                        phi_478_ = 0u;
                        phi_479_ = _e139;
                    }
                    let _e277 = phi_478_;
                    let _e279 = phi_479_;
                    if (_e279 < 0f) {
                        phi_484_ = -1f;
                    } else {
                        phi_484_ = 1f;
                    }
                    let _e282 = phi_484_;
                    let _e283 = (_e282 < 0f);
                    if (_e277 == 0u) {
                        if _e283 {
                            phi_495_ = _e99.roots.y;
                        } else {
                            phi_495_ = _e99.roots.x;
                        }
                        let _e290 = phi_495_;
                        phi_513_ = _e290;
                    } else {
                        if (_e277 == 1u) {
                            if _e283 {
                                phi_505_ = _e99.roots.w;
                            } else {
                                phi_505_ = _e99.roots.z;
                            }
                            let _e297 = phi_505_;
                            phi_512_ = _e297;
                        } else {
                            if _e283 {
                                phi_511_ = _e99.roots_z.y;
                            } else {
                                phi_511_ = _e99.roots_z.x;
                            }
                            let _e303 = phi_511_;
                            phi_512_ = _e303;
                        }
                        let _e305 = phi_512_;
                        phi_513_ = _e305;
                    }
                    let _e307 = phi_513_;
                    if (_e277 == 0u) {
                        phi_525_ = vec3<f32>(_e140, _e141, _e139);
                    } else {
                        if (_e277 == 1u) {
                            phi_524_ = vec3<f32>(_e141, _e139, _e140);
                        } else {
                            phi_524_ = _e142;
                        }
                        let _e313 = phi_524_;
                        phi_525_ = _e313;
                    }
                    let _e315 = phi_525_;
                    phi_570_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e315.x / _e315.z), (_e315.y / _e315.z), (_e282 / _e315.z)), _e307);
                } else {
                    if (_e99.axis == 0u) {
                        phi_548_ = vec3<f32>(_e121, _e123, _e119);
                    } else {
                        if (_e99.axis == 1u) {
                            phi_547_ = vec3<f32>(_e123, _e119, _e121);
                        } else {
                            phi_547_ = (_e105 + vec3<f32>(_e113, _e115, _e117));
                        }
                        let _e332 = phi_547_;
                        phi_548_ = _e332;
                    }
                    let _e334 = phi_548_;
                    let _e349 = (_e334.z - _e99.middle.z);
                    phi_570_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e334.x - _e99.middle.x) - (_e99.shear.x * _e349)), ((_e334.y - _e99.middle.y) - (_e99.shear.y * _e349)), (_e99.sign * _e349)), _e99.roots.x);
                }
                let _e360 = phi_570_;
                if (_e360.unnamed_1 == 4294967295u) {
                    phi_1909_ = false;
                } else {
                    if (0u < _e72) {
                    } else {
                        return;
                    }
                    let _e377 = nodes.member[0u].frame[0u];
                    let _e381 = nodes.member[0u].frame[1u];
                    let _e385 = nodes.member[0u].frame[2u];
                    let _e389 = nodes.member[0u].frame[0u];
                    let _e393 = nodes.member[0u].frame[1u];
                    let _e397 = nodes.member[0u].frame[2u];
                    let _e401 = nodes.member[0u].frame[3u];
                    let _e435 = core_intrinsics_maximum_number_nsz_f32_(abs(_e139), abs(_e140));
                    let _e436 = core_intrinsics_maximum_number_nsz_f32_(_e435, abs(_e141));
                    let _e437 = (_e436 * 0.0000000000009094947f);
                    if (abs(_e139) < _e437) {
                        phi_645_ = _e437;
                    } else {
                        phi_645_ = abs(_e139);
                    }
                    let _e442 = phi_645_;
                    if (_e139 < 0f) {
                        phi_652_ = (-1f / _e442);
                    } else {
                        phi_652_ = (1f / _e442);
                    }
                    let _e447 = phi_652_;
                    if (abs(_e140) < _e437) {
                        phi_659_ = _e437;
                    } else {
                        phi_659_ = abs(_e140);
                    }
                    let _e452 = phi_659_;
                    if (_e140 < 0f) {
                        phi_666_ = (-1f / _e452);
                    } else {
                        phi_666_ = (1f / _e452);
                    }
                    let _e457 = phi_666_;
                    if (abs(_e141) < _e437) {
                        phi_673_ = _e437;
                    } else {
                        phi_673_ = abs(_e141);
                    }
                    let _e462 = phi_673_;
                    if (_e141 < 0f) {
                        phi_680_ = (-1f / _e462);
                    } else {
                        phi_680_ = (1f / _e462);
                    }
                    let _e467 = phi_680_;
                    let _e471 = abs((bitcast<f32>(_e377) - _e119));
                    let _e472 = abs((bitcast<f32>(_e381) - _e121));
                    let _e473 = abs((bitcast<f32>(_e385) - _e123));
                    let _e477 = abs(((bitcast<f32>(_e389) + (bitcast<f32>((((_e401 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e119));
                    let _e478 = abs(((bitcast<f32>(_e393) + (bitcast<f32>((((_e401 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e121));
                    let _e479 = abs(((bitcast<f32>(_e397) + (bitcast<f32>((((_e401 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e123));
                    if (_e471 > _e477) {
                        phi_697_ = _e471;
                    } else {
                        phi_697_ = _e477;
                    }
                    let _e482 = phi_697_;
                    if (_e472 > _e478) {
                        phi_702_ = _e472;
                    } else {
                        phi_702_ = _e478;
                    }
                    let _e485 = phi_702_;
                    if (_e473 > _e479) {
                        phi_707_ = _e473;
                    } else {
                        phi_707_ = _e479;
                    }
                    let _e488 = phi_707_;
                    if (_e482 > _e485) {
                        phi_712_ = _e482;
                    } else {
                        phi_712_ = _e485;
                    }
                    let _e491 = phi_712_;
                    if (_e491 > _e488) {
                        phi_717_ = _e491;
                    } else {
                        phi_717_ = _e488;
                    }
                    let _e494 = phi_717_;
                    let _e501 = (_e494 * 0.0000009536743f);
                    let _e502 = (abs(_e447) * _e501);
                    let _e503 = (abs(_e457) * _e501);
                    let _e504 = (abs(_e467) * _e501);
                    let _e505 = abs(_e139);
                    let _e506 = abs(_e140);
                    let _e507 = abs(_e141);
                    if (_e505 >= _e506) {
                        if (_e505 >= _e507) {
                            phi_739_ = false;
                        } else {
                            phi_739_ = true;
                        }
                        let _e511 = phi_739_;
                        phi_740_ = _e511;
                    } else {
                        phi_740_ = true;
                    }
                    let _e513 = phi_740_;
                    if _e513 {
                        if (_e506 >= _e507) {
                            phi_748_ = 1u;
                        } else {
                            phi_748_ = 2u;
                        }
                        let _e516 = phi_748_;
                        phi_749_ = _e516;
                    } else {
                        phi_749_ = 0u;
                    }
                    let _e518 = phi_749_;
                    if (_e518 == 0u) {
                        phi_761_ = vec3<f32>(_e140, _e141, _e139);
                    } else {
                        if (_e518 == 1u) {
                            phi_760_ = vec3<f32>(_e141, _e139, _e140);
                        } else {
                            phi_760_ = _e142;
                        }
                        let _e524 = phi_760_;
                        phi_761_ = _e524;
                    }
                    let _e526 = phi_761_;
                    let _e529 = (_e526.x / _e526.z);
                    let _e532 = (_e526.y / _e526.z);
                    local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_773_ = ((_e360.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_776_ = 0u;
                    loop {
                        let _e539 = phi_773_;
                        let _e541 = phi_776_;
                        phi_781_ = _e539;
                        phi_783_ = 0u;
                        phi_785_ = 0u;
                        phi_787_ = _e541;
                        loop {
                            let _e543 = phi_781_;
                            let _e545 = phi_783_;
                            let _e547 = phi_785_;
                            let _e549 = phi_787_;
                            let _e556 = (((_e543 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e543), 32u, (_e543 == 0u))) * 5u);
                            if (_e556 < _e84) {
                            } else {
                                return;
                            }
                            let _e560 = rows.member[(0u + _e556)];
                            let _e561 = (_e556 + 1u);
                            if (_e561 < _e84) {
                            } else {
                                return;
                            }
                            let _e565 = rows.member[(0u + _e561)];
                            let _e566 = (_e556 + 2u);
                            if (_e566 < _e84) {
                            } else {
                                return;
                            }
                            let _e570 = rows.member[(0u + _e566)];
                            let _e571 = (_e556 + 3u);
                            if (_e571 < _e84) {
                            } else {
                                return;
                            }
                            let _e575 = rows.member[(0u + _e571)];
                            let _e576 = (_e556 + 4u);
                            if (_e576 < _e84) {
                            } else {
                                return;
                            }
                            let _e580 = rows.member[(0u + _e576)];
                            let _e581 = lt_bvh_Node(_e560, _e565, _e570, _e575, _e580);
                            let _e583 = (_e543 & (_e543 - 1u));
                            let _e595 = (_e360.unnamed.positive_exponent - bitcast<f32>(_e581.frame.x));
                            let _e598 = bitcast<f32>((((_e581.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e595 > 0f) {
                                if (_e595 < (255f * _e598)) {
                                    phi_859_ = (_e595 / _e598);
                                } else {
                                    phi_859_ = 255f;
                                }
                                let _e604 = phi_859_;
                                phi_860_ = _e604;
                            } else {
                                phi_860_ = 0f;
                            }
                            let _e606 = phi_860_;
                            let _e613 = select(select(u32(_e606), 0u, (_e606 < bitcast<f32>(0u))), 4294967295u, (_e606 > bitcast<f32>(1333788671u)));
                            if (f32(_e613) < _e606) {
                                phi_874_ = (_e613 + 1u);
                            } else {
                                phi_874_ = _e613;
                            }
                            let _e618 = phi_874_;
                            let _e619 = (_e613 * 16843009u);
                            let _e620 = (_e618 * 16843009u);
                            let _e630 = (_e360.unnamed.negative_exponent - bitcast<f32>(_e581.frame.y));
                            let _e633 = bitcast<f32>((((_e581.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e630 > 0f) {
                                if (_e630 < (255f * _e633)) {
                                    phi_897_ = (_e630 / _e633);
                                } else {
                                    phi_897_ = 255f;
                                }
                                let _e639 = phi_897_;
                                phi_898_ = _e639;
                            } else {
                                phi_898_ = 0f;
                            }
                            let _e641 = phi_898_;
                            let _e648 = select(select(u32(_e641), 0u, (_e641 < bitcast<f32>(0u))), 4294967295u, (_e641 > bitcast<f32>(1333788671u)));
                            if (f32(_e648) < _e641) {
                                phi_912_ = (_e648 + 1u);
                            } else {
                                phi_912_ = _e648;
                            }
                            let _e653 = phi_912_;
                            let _e654 = (_e648 * 16843009u);
                            let _e655 = (_e653 * 16843009u);
                            let _e664 = (((_e99.diagonal.x * _e360.unnamed.positive_exponent) + (_e99.diagonal.y * _e360.unnamed.negative_exponent)) - bitcast<f32>(_e581.frame.z));
                            let _e667 = bitcast<f32>((((_e581.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e664 > 0f) {
                                if (_e664 < (255f * _e667)) {
                                    phi_934_ = (_e664 / _e667);
                                } else {
                                    phi_934_ = 255f;
                                }
                                let _e673 = phi_934_;
                                phi_935_ = _e673;
                            } else {
                                phi_935_ = 0f;
                            }
                            let _e675 = phi_935_;
                            let _e682 = select(select(u32(_e675), 0u, (_e675 < bitcast<f32>(0u))), 4294967295u, (_e675 > bitcast<f32>(1333788671u)));
                            if (f32(_e682) < _e675) {
                                phi_949_ = (_e682 + 1u);
                            } else {
                                phi_949_ = _e682;
                            }
                            let _e687 = phi_949_;
                            let _e688 = (_e682 * 16843009u);
                            let _e689 = (_e687 * 16843009u);
                            let _e699 = (_e360.unnamed.min_variance - bitcast<f32>(_e581.frame.w));
                            let _e702 = bitcast<f32>((((_e581.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e699 > 0f) {
                                if (_e699 < (255f * _e702)) {
                                    phi_972_ = (_e699 / _e702);
                                } else {
                                    phi_972_ = 255f;
                                }
                                let _e708 = phi_972_;
                                phi_973_ = _e708;
                            } else {
                                phi_973_ = 0f;
                            }
                            let _e710 = phi_973_;
                            let _e717 = select(select(u32(_e710), 0u, (_e710 < bitcast<f32>(0u))), 4294967295u, (_e710 > bitcast<f32>(1333788671u)));
                            if (f32(_e717) < _e710) {
                                phi_987_ = (_e717 + 1u);
                            } else {
                                phi_987_ = _e717;
                            }
                            let _e722 = phi_987_;
                            let _e723 = (_e722 * 16843009u);
                            let _e904 = (((((((((((_e619 & ~(_e581.links.x)) | (~((_e581.links.x ^ _e619)) & ((_e619 | 2155905152u) - (_e581.links.x & 2139062143u)))) & ((_e581.links.z & ~(_e620)) | (~((_e620 ^ _e581.links.z)) & ((_e581.links.z | 2155905152u) - (_e620 & 2139062143u))))) & (((_e654 & ~(_e581.x.x)) | (~((_e581.x.x ^ _e654)) & ((_e654 | 2155905152u) - (_e581.x.x & 2139062143u)))) & ((_e581.x.z & ~(_e655)) | (~((_e655 ^ _e581.x.z)) & ((_e581.x.z | 2155905152u) - (_e655 & 2139062143u)))))) & (((_e688 & ~(_e581.y.x)) | (~((_e581.y.x ^ _e688)) & ((_e688 | 2155905152u) - (_e581.y.x & 2139062143u)))) & ((_e581.y.z & ~(_e689)) | (~((_e689 ^ _e581.y.z)) & ((_e581.y.z | 2155905152u) - (_e689 & 2139062143u)))))) & ((_e581.z.x & ~(_e723)) | (~((_e723 ^ _e581.z.x)) & ((_e581.z.x | 2155905152u) - (_e723 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e619 & ~(_e581.links.y)) | (~((_e581.links.y ^ _e619)) & ((_e619 | 2155905152u) - (_e581.links.y & 2139062143u)))) & ((_e581.links.w & ~(_e620)) | (~((_e620 ^ _e581.links.w)) & ((_e581.links.w | 2155905152u) - (_e620 & 2139062143u))))) & (((_e654 & ~(_e581.x.y)) | (~((_e581.x.y ^ _e654)) & ((_e654 | 2155905152u) - (_e581.x.y & 2139062143u)))) & ((_e581.x.w & ~(_e655)) | (~((_e655 ^ _e581.x.w)) & ((_e581.x.w | 2155905152u) - (_e655 & 2139062143u)))))) & (((_e688 & ~(_e581.y.y)) | (~((_e581.y.y ^ _e688)) & ((_e688 | 2155905152u) - (_e581.y.y & 2139062143u)))) & ((_e581.y.w & ~(_e689)) | (~((_e689 ^ _e581.y.w)) & ((_e581.y.w | 2155905152u) - (_e689 & 2139062143u)))))) & ((_e581.z.y & ~(_e723)) | (~((_e723 ^ _e581.z.y)) & ((_e581.z.y | 2155905152u) - (_e723 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e581.z.w & 2147483648u) != 0u) {
                                phi_1187_ = _e583;
                                phi_784_ = (_e581.z.w & 2147483647u);
                                phi_786_ = _e904;
                                phi_1188_ = _e549;
                            } else {
                                if (_e904 == 0u) {
                                    phi_1185_ = _e583;
                                    phi_1186_ = _e549;
                                } else {
                                    if ((_e583 & 255u) == 0u) {
                                        phi_1180_ = _e549;
                                    } else {
                                        if (_e549 < 32u) {
                                            if (_e549 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1[(0u + _e549)] = _e583;
                                            phi_1179_ = (_e549 + 1u);
                                        } else {
                                            phi_1179_ = _e549;
                                        }
                                        let _e921 = phi_1179_;
                                        phi_1180_ = _e921;
                                    }
                                    let _e923 = phi_1180_;
                                    phi_1185_ = (((_e581.z.w & 2147483647u) << bitcast<u32>(8i)) | _e904);
                                    phi_1186_ = _e923;
                                }
                                let _e931 = phi_1185_;
                                let _e933 = phi_1186_;
                                phi_1187_ = _e931;
                                phi_784_ = _e545;
                                phi_786_ = _e547;
                                phi_1188_ = _e933;
                            }
                            let _e935 = phi_1187_;
                            let _e937 = phi_784_;
                            let _e939 = phi_786_;
                            let _e941 = phi_1188_;
                            local_3 = _e939;
                            local_15 = _e939;
                            local_4 = _e937;
                            if ((_e935 & 255u) == 0u) {
                                if (_e941 > 0u) {
                                    let _e945 = (_e941 - 1u);
                                    if (_e945 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e949 = local_1[(0u + _e945)];
                                    phi_1206_ = _e949;
                                    phi_1207_ = _e945;
                                } else {
                                    phi_1206_ = 0u;
                                    phi_1207_ = _e941;
                                }
                                let _e951 = phi_1206_;
                                let _e953 = phi_1207_;
                                phi_774_ = _e951;
                                phi_777_ = _e953;
                            } else {
                                phi_774_ = _e935;
                                phi_777_ = _e941;
                            }
                            let _e955 = phi_774_;
                            let _e957 = phi_777_;
                            local_13 = _e955;
                            local_14 = _e957;
                            local_6 = _e955;
                            if (_e939 == 0u) {
                                let _e959 = (_e955 == 0u);
                                if _e959 {
                                    phi_1216_ = false;
                                } else {
                                    phi_1216_ = true;
                                }
                                let _e961 = phi_1216_;
                                phi_1217_ = _e961;
                                phi_1218_ = _e959;
                            } else {
                                phi_1217_ = false;
                                phi_1218_ = false;
                            }
                            let _e963 = phi_1217_;
                            let _e965 = phi_1218_;
                            local_2 = _e965;
                            continue;
                            continuing {
                                phi_781_ = _e955;
                                phi_783_ = _e937;
                                phi_785_ = _e939;
                                phi_787_ = _e957;
                                break if !(_e963);
                            }
                        }
                        let _e968 = local_2;
                        if _e968 {
                        }
                        let _e970 = local_3;
                        if (_e970 == 0u) {
                            phi_1883_ = true;
                            phi_1884_ = false;
                            phi_1885_ = false;
                        } else {
                            let _e3054 = local_15;
                            phi_1227_ = _e3054;
                            loop {
                                let _e973 = phi_1227_;
                                let _e976 = select(firstTrailingBit(_e973), 32u, (_e973 == 0u));
                                let _e980 = local_4;
                                let _e981 = (_e980 + (_e976 >> bitcast<u32>(2i)));
                                if (_e981 < _e84) {
                                } else {
                                    return;
                                }
                                let _e986 = rows.member[(0u + _e981)][0u];
                                let _e990 = rows.member[(0u + _e981)][1u];
                                let _e994 = rows.member[(0u + _e981)][2u];
                                let _e998 = rows.member[(0u + _e981)][3u];
                                if ((_e976 & 2u) == 0u) {
                                    phi_1262_ = _e990;
                                    phi_1263_ = _e986;
                                } else {
                                    phi_1262_ = _e998;
                                    phi_1263_ = _e994;
                                }
                                let _e1002 = phi_1262_;
                                let _e1004 = phi_1263_;
                                if ((_e976 & 1u) == 0u) {
                                    phi_1269_ = _e1004;
                                } else {
                                    phi_1269_ = _e1002;
                                }
                                let _e1008 = phi_1269_;
                                let _e1010 = (_e973 & (_e973 - 1u));
                                if (_e1008 < _e75) {
                                } else {
                                    return;
                                }
                                let _e1015 = triangles.member[(0u + _e1008)].v0_;
                                let _e1017 = (_e1015.x - _e119);
                                let _e1019 = (_e1015.y - _e121);
                                let _e1021 = (_e1015.z - _e123);
                                if (_e518 == 0u) {
                                    phi_1298_ = vec3<f32>(_e1019, _e1021, _e1017);
                                } else {
                                    if (_e518 == 1u) {
                                        phi_1297_ = vec3<f32>(_e1021, _e1017, _e1019);
                                    } else {
                                        phi_1297_ = (_e1015 - vec3<f32>(_e119, _e121, _e123));
                                    }
                                    let _e1029 = phi_1297_;
                                    phi_1298_ = _e1029;
                                }
                                let _e1031 = phi_1298_;
                                let _e1035 = (_e1031.x - (_e529 * _e1031.z));
                                let _e1039 = (_e1031.y - (_e532 * _e1031.z));
                                let _e1041 = triangles.member[(0u + _e1008)].v1_;
                                let _e1043 = (_e1041.x - _e119);
                                let _e1045 = (_e1041.y - _e121);
                                let _e1047 = (_e1041.z - _e123);
                                if (_e518 == 0u) {
                                    phi_1328_ = vec3<f32>(_e1045, _e1047, _e1043);
                                } else {
                                    if (_e518 == 1u) {
                                        phi_1327_ = vec3<f32>(_e1047, _e1043, _e1045);
                                    } else {
                                        phi_1327_ = (_e1041 - vec3<f32>(_e119, _e121, _e123));
                                    }
                                    let _e1055 = phi_1327_;
                                    phi_1328_ = _e1055;
                                }
                                let _e1057 = phi_1328_;
                                let _e1061 = (_e1057.x - (_e529 * _e1057.z));
                                let _e1065 = (_e1057.y - (_e532 * _e1057.z));
                                let _e1067 = triangles.member[(0u + _e1008)].v2_;
                                let _e1069 = (_e1067.x - _e119);
                                let _e1071 = (_e1067.y - _e121);
                                let _e1073 = (_e1067.z - _e123);
                                if (_e518 == 0u) {
                                    phi_1358_ = vec3<f32>(_e1071, _e1073, _e1069);
                                } else {
                                    if (_e518 == 1u) {
                                        phi_1357_ = vec3<f32>(_e1073, _e1069, _e1071);
                                    } else {
                                        phi_1357_ = (_e1067 - vec3<f32>(_e119, _e121, _e123));
                                    }
                                    let _e1081 = phi_1357_;
                                    phi_1358_ = _e1081;
                                }
                                let _e1083 = phi_1358_;
                                let _e1087 = (_e1083.x - (_e529 * _e1083.z));
                                let _e1091 = (_e1083.y - (_e532 * _e1083.z));
                                if (_e1061 < _e1087) {
                                    phi_1377_ = true;
                                } else {
                                    if (_e1061 == _e1087) {
                                        phi_1376_ = (_e1065 < _e1091);
                                    } else {
                                        phi_1376_ = false;
                                    }
                                    let _e1096 = phi_1376_;
                                    phi_1377_ = _e1096;
                                }
                                let _e1098 = phi_1377_;
                                if _e1098 {
                                    phi_1381_ = _e1091;
                                    phi_1382_ = _e1087;
                                    phi_1383_ = _e1065;
                                    phi_1384_ = _e1061;
                                } else {
                                    phi_1381_ = _e1065;
                                    phi_1382_ = _e1061;
                                    phi_1383_ = _e1091;
                                    phi_1384_ = _e1087;
                                }
                                let _e1100 = phi_1381_;
                                let _e1102 = phi_1382_;
                                let _e1104 = phi_1383_;
                                let _e1106 = phi_1384_;
                                let _e1109 = ((_e1106 * _e1100) - (_e1104 * _e1102));
                                if _e1098 {
                                    phi_1392_ = -(_e1109);
                                } else {
                                    phi_1392_ = _e1109;
                                }
                                let _e1112 = phi_1392_;
                                if (_e1087 < _e1035) {
                                    phi_1403_ = true;
                                } else {
                                    if (_e1087 == _e1035) {
                                        phi_1402_ = (_e1091 < _e1039);
                                    } else {
                                        phi_1402_ = false;
                                    }
                                    let _e1117 = phi_1402_;
                                    phi_1403_ = _e1117;
                                }
                                let _e1119 = phi_1403_;
                                if _e1119 {
                                    phi_1407_ = _e1039;
                                    phi_1408_ = _e1035;
                                    phi_1409_ = _e1091;
                                    phi_1410_ = _e1087;
                                } else {
                                    phi_1407_ = _e1091;
                                    phi_1408_ = _e1087;
                                    phi_1409_ = _e1039;
                                    phi_1410_ = _e1035;
                                }
                                let _e1121 = phi_1407_;
                                let _e1123 = phi_1408_;
                                let _e1125 = phi_1409_;
                                let _e1127 = phi_1410_;
                                let _e1130 = ((_e1127 * _e1121) - (_e1125 * _e1123));
                                if _e1119 {
                                    phi_1418_ = -(_e1130);
                                } else {
                                    phi_1418_ = _e1130;
                                }
                                let _e1133 = phi_1418_;
                                if (_e1035 < _e1061) {
                                    phi_1429_ = true;
                                } else {
                                    if (_e1035 == _e1061) {
                                        phi_1428_ = (_e1039 < _e1065);
                                    } else {
                                        phi_1428_ = false;
                                    }
                                    let _e1138 = phi_1428_;
                                    phi_1429_ = _e1138;
                                }
                                let _e1140 = phi_1429_;
                                if _e1140 {
                                    phi_1433_ = _e1065;
                                    phi_1434_ = _e1061;
                                    phi_1435_ = _e1039;
                                    phi_1436_ = _e1035;
                                } else {
                                    phi_1433_ = _e1039;
                                    phi_1434_ = _e1035;
                                    phi_1435_ = _e1065;
                                    phi_1436_ = _e1061;
                                }
                                let _e1142 = phi_1433_;
                                let _e1144 = phi_1434_;
                                let _e1146 = phi_1435_;
                                let _e1148 = phi_1436_;
                                let _e1151 = ((_e1148 * _e1142) - (_e1146 * _e1144));
                                if _e1140 {
                                    phi_1444_ = -(_e1151);
                                } else {
                                    phi_1444_ = _e1151;
                                }
                                let _e1154 = phi_1444_;
                                if (_e1112 >= 0f) {
                                    if (_e1133 >= 0f) {
                                        if (_e1154 >= 0f) {
                                            phi_1459_ = ((_e1112 + _e1133) + _e1154);
                                            phi_1460_ = false;
                                        } else {
                                            phi_1459_ = f32();
                                            phi_1460_ = true;
                                        }
                                        let _e1161 = phi_1459_;
                                        let _e1163 = phi_1460_;
                                        phi_1461_ = _e1161;
                                        phi_1462_ = _e1163;
                                    } else {
                                        phi_1461_ = f32();
                                        phi_1462_ = true;
                                    }
                                    let _e1165 = phi_1461_;
                                    let _e1167 = phi_1462_;
                                    phi_1463_ = _e1165;
                                    phi_1464_ = _e1167;
                                } else {
                                    phi_1463_ = f32();
                                    phi_1464_ = true;
                                }
                                let _e1169 = phi_1463_;
                                let _e1171 = phi_1464_;
                                if _e1171 {
                                    if (_e1112 <= 0f) {
                                        if (_e1133 <= 0f) {
                                            let _e1174 = (_e1154 <= 0f);
                                            if _e1174 {
                                            }
                                            phi_1482_ = ((_e1112 + _e1133) + _e1154);
                                            phi_1483_ = false;
                                            phi_1484_ = _e1174;
                                        } else {
                                            phi_1482_ = f32();
                                            phi_1483_ = true;
                                            phi_1484_ = false;
                                        }
                                        let _e1178 = phi_1482_;
                                        let _e1180 = phi_1483_;
                                        let _e1182 = phi_1484_;
                                        phi_1485_ = _e1178;
                                        phi_1486_ = _e1180;
                                        phi_1487_ = _e1182;
                                    } else {
                                        phi_1485_ = f32();
                                        phi_1486_ = true;
                                        phi_1487_ = false;
                                    }
                                    let _e1184 = phi_1485_;
                                    let _e1186 = phi_1486_;
                                    let _e1188 = phi_1487_;
                                    if _e1186 {
                                        phi_1491_ = false;
                                    } else {
                                        phi_1491_ = _e1188;
                                    }
                                    let _e1190 = phi_1491_;
                                    phi_1492_ = _e1184;
                                    phi_1493_ = _e1190;
                                } else {
                                    phi_1492_ = _e1169;
                                    phi_1493_ = true;
                                }
                                let _e1192 = phi_1492_;
                                let _e1194 = phi_1493_;
                                if _e1194 {
                                    let _e1195 = (_e1192 == 0f);
                                    if _e1195 {
                                        phi_1809_ = lt_bvh_triangle_Intersection();
                                        phi_1810_ = false;
                                    } else {
                                        let _e1197 = triangles.member[(0u + _e1008)].v0_;
                                        let _e1199 = (_e1197.x - _e119);
                                        let _e1201 = (_e1197.y - _e121);
                                        let _e1203 = (_e1197.z - _e123);
                                        if (_e518 == 0u) {
                                            phi_1522_ = vec3<f32>(_e1201, _e1203, _e1199);
                                        } else {
                                            if (_e518 == 1u) {
                                                phi_1521_ = vec3<f32>(_e1203, _e1199, _e1201);
                                            } else {
                                                phi_1521_ = (_e1197 - vec3<f32>(_e119, _e121, _e123));
                                            }
                                            let _e1211 = phi_1521_;
                                            phi_1522_ = _e1211;
                                        }
                                        let _e1213 = phi_1522_;
                                        let _e1215 = triangles.member[(0u + _e1008)].v1_;
                                        let _e1217 = triangles.member[(0u + _e1008)].v0_;
                                        let _e1220 = (_e1215.x - _e1217.x);
                                        let _e1223 = (_e1215.y - _e1217.y);
                                        let _e1226 = (_e1215.z - _e1217.z);
                                        if (_e518 == 0u) {
                                            phi_1548_ = vec3<f32>(_e1223, _e1226, _e1220);
                                        } else {
                                            if (_e518 == 1u) {
                                                phi_1547_ = vec3<f32>(_e1226, _e1220, _e1223);
                                            } else {
                                                phi_1547_ = (_e1215 - _e1217);
                                            }
                                            let _e1233 = phi_1547_;
                                            phi_1548_ = _e1233;
                                        }
                                        let _e1235 = phi_1548_;
                                        let _e1237 = triangles.member[(0u + _e1008)].v2_;
                                        let _e1239 = triangles.member[(0u + _e1008)].v0_;
                                        let _e1242 = (_e1237.x - _e1239.x);
                                        let _e1245 = (_e1237.y - _e1239.y);
                                        let _e1248 = (_e1237.z - _e1239.z);
                                        if (_e518 == 0u) {
                                            phi_1574_ = vec3<f32>(_e1245, _e1248, _e1242);
                                        } else {
                                            if (_e518 == 1u) {
                                                phi_1573_ = vec3<f32>(_e1248, _e1242, _e1245);
                                            } else {
                                                phi_1573_ = (_e1237 - _e1239);
                                            }
                                            let _e1255 = phi_1573_;
                                            phi_1574_ = _e1255;
                                        }
                                        let _e1257 = phi_1574_;
                                        let _e1264 = ((_e1235.y * _e1257.z) - (_e1235.z * _e1257.y));
                                        let _e1271 = ((_e1235.z * _e1257.x) - (_e1235.x * _e1257.z));
                                        let _e1278 = ((_e1235.x * _e1257.y) - (_e1235.y * _e1257.x));
                                        let _e1292 = (((1f / _e526.z) * (((_e1264 * _e1213.x) + (_e1271 * _e1213.y)) + (_e1278 * _e1213.z))) / (((_e1264 * _e529) + (_e1271 * _e532)) + _e1278));
                                        if (_e1292 > 0f) {
                                            if (_e1292 < _e131) {
                                                let _e1296 = triangles.member[(0u + _e1008)].v0_;
                                                let _e1298 = triangles.member[(0u + _e1008)].v1_;
                                                if (_e1296.x < _e1298.x) {
                                                    phi_1630_ = _e1296.x;
                                                } else {
                                                    phi_1630_ = _e1298.x;
                                                }
                                                let _e1305 = phi_1630_;
                                                if (_e1296.y < _e1298.y) {
                                                    phi_1639_ = _e1296.y;
                                                } else {
                                                    phi_1639_ = _e1298.y;
                                                }
                                                let _e1312 = phi_1639_;
                                                if (_e1296.z < _e1298.z) {
                                                    phi_1648_ = _e1296.z;
                                                } else {
                                                    phi_1648_ = _e1298.z;
                                                }
                                                let _e1319 = phi_1648_;
                                                let _e1321 = triangles.member[(0u + _e1008)].v2_;
                                                if (_e1305 < _e1321.x) {
                                                    phi_1657_ = _e1305;
                                                } else {
                                                    phi_1657_ = _e1321.x;
                                                }
                                                let _e1326 = phi_1657_;
                                                if (_e1312 < _e1321.y) {
                                                    phi_1664_ = _e1312;
                                                } else {
                                                    phi_1664_ = _e1321.y;
                                                }
                                                let _e1331 = phi_1664_;
                                                if (_e1319 < _e1321.z) {
                                                    phi_1671_ = _e1319;
                                                } else {
                                                    phi_1671_ = _e1321.z;
                                                }
                                                let _e1336 = phi_1671_;
                                                let _e1338 = triangles.member[(0u + _e1008)].v0_;
                                                let _e1340 = triangles.member[(0u + _e1008)].v1_;
                                                if (_e1338.x > _e1340.x) {
                                                    phi_1684_ = _e1338.x;
                                                } else {
                                                    phi_1684_ = _e1340.x;
                                                }
                                                let _e1347 = phi_1684_;
                                                if (_e1338.y > _e1340.y) {
                                                    phi_1693_ = _e1338.y;
                                                } else {
                                                    phi_1693_ = _e1340.y;
                                                }
                                                let _e1354 = phi_1693_;
                                                if (_e1338.z > _e1340.z) {
                                                    phi_1702_ = _e1338.z;
                                                } else {
                                                    phi_1702_ = _e1340.z;
                                                }
                                                let _e1361 = phi_1702_;
                                                let _e1363 = triangles.member[(0u + _e1008)].v2_;
                                                if (_e1347 > _e1363.x) {
                                                    phi_1711_ = _e1347;
                                                } else {
                                                    phi_1711_ = _e1363.x;
                                                }
                                                let _e1368 = phi_1711_;
                                                if (_e1354 > _e1363.y) {
                                                    phi_1718_ = _e1354;
                                                } else {
                                                    phi_1718_ = _e1363.y;
                                                }
                                                let _e1373 = phi_1718_;
                                                if (_e1361 > _e1363.z) {
                                                    phi_1725_ = _e1361;
                                                } else {
                                                    phi_1725_ = _e1363.z;
                                                }
                                                let _e1378 = phi_1725_;
                                                let _e1382 = ((_e1326 - _e119) * _e447);
                                                let _e1383 = ((_e1331 - _e121) * _e457);
                                                let _e1384 = ((_e1336 - _e123) * _e467);
                                                let _e1388 = ((_e1368 - _e119) * _e447);
                                                let _e1389 = ((_e1373 - _e121) * _e457);
                                                let _e1390 = ((_e1378 - _e123) * _e467);
                                                if (_e1382 < _e1388) {
                                                    phi_1742_ = _e1382;
                                                } else {
                                                    phi_1742_ = _e1388;
                                                }
                                                let _e1393 = phi_1742_;
                                                if (_e1383 < _e1389) {
                                                    phi_1747_ = _e1383;
                                                } else {
                                                    phi_1747_ = _e1389;
                                                }
                                                let _e1396 = phi_1747_;
                                                if (_e1384 < _e1390) {
                                                    phi_1752_ = _e1384;
                                                } else {
                                                    phi_1752_ = _e1390;
                                                }
                                                let _e1399 = phi_1752_;
                                                if (_e1382 > _e1388) {
                                                    phi_1760_ = _e1382;
                                                } else {
                                                    phi_1760_ = _e1388;
                                                }
                                                let _e1405 = phi_1760_;
                                                if (_e1383 > _e1389) {
                                                    phi_1765_ = _e1383;
                                                } else {
                                                    phi_1765_ = _e1389;
                                                }
                                                let _e1408 = phi_1765_;
                                                if (_e1384 > _e1390) {
                                                    phi_1770_ = _e1384;
                                                } else {
                                                    phi_1770_ = _e1390;
                                                }
                                                let _e1411 = phi_1770_;
                                                let _e1415 = core_intrinsics_maximum_number_nsz_f32_((_e1393 - _e502), (_e1396 - _e503));
                                                let _e1416 = core_intrinsics_maximum_number_nsz_f32_(_e1415, (_e1399 - _e504));
                                                let _e1417 = core_intrinsics_minimum_number_nsz_f32_((_e1405 + _e502), (_e1408 + _e503));
                                                let _e1418 = core_intrinsics_minimum_number_nsz_f32_(_e1417, (_e1411 + _e504));
                                                if (_e1416 > -300000000000000000000000000000000000000f) {
                                                    phi_1782_ = _e1416;
                                                } else {
                                                    phi_1782_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1421 = phi_1782_;
                                                if (_e1418 < 300000000000000000000000000000000000000f) {
                                                    phi_1787_ = _e1418;
                                                } else {
                                                    phi_1787_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1424 = phi_1787_;
                                                if (_e1292 < _e1421) {
                                                    phi_1792_ = _e1421;
                                                } else {
                                                    phi_1792_ = _e1292;
                                                }
                                                let _e1427 = phi_1792_;
                                                if (_e1427 > _e1424) {
                                                    phi_1797_ = _e1424;
                                                } else {
                                                    phi_1797_ = _e1427;
                                                }
                                                let _e1430 = phi_1797_;
                                                phi_1802_ = lt_bvh_triangle_Intersection(_e1430, (_e1133 / _e1192), (_e1154 / _e1192), (_e1421 <= _e1424));
                                                phi_1803_ = false;
                                            } else {
                                                phi_1802_ = lt_bvh_triangle_Intersection();
                                                phi_1803_ = true;
                                            }
                                            let _e1436 = phi_1802_;
                                            let _e1438 = phi_1803_;
                                            phi_1804_ = _e1436;
                                            phi_1805_ = _e1438;
                                        } else {
                                            phi_1804_ = lt_bvh_triangle_Intersection();
                                            phi_1805_ = true;
                                        }
                                        let _e1440 = phi_1804_;
                                        let _e1442 = phi_1805_;
                                        if _e1442 {
                                        }
                                        phi_1809_ = _e1440;
                                        phi_1810_ = _e1442;
                                    }
                                    let _e1444 = phi_1809_;
                                    let _e1446 = phi_1810_;
                                    phi_1811_ = _e1444;
                                    phi_1812_ = _e1195;
                                    phi_1813_ = _e1446;
                                } else {
                                    phi_1811_ = lt_bvh_triangle_Intersection();
                                    phi_1812_ = true;
                                    phi_1813_ = false;
                                }
                                let _e1448 = phi_1811_;
                                let _e1450 = phi_1812_;
                                let _e1452 = phi_1813_;
                                if _e1450 {
                                    phi_1817_ = true;
                                } else {
                                    phi_1817_ = _e1452;
                                }
                                let _e1454 = phi_1817_;
                                if _e1454 {
                                    phi_1821_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1821_ = _e1448;
                                }
                                let _e1456 = phi_1821_;
                                if _e1456.is_hit {
                                    if (_e1456.t > 0f) {
                                        if (_e1456.t < _e131) {
                                            let _e1463 = triangles.member[(0u + _e1008)].i0_;
                                            let _e1465 = ((_e1463 & 2147483648u) == 0u);
                                            if _e1465 {
                                                phi_1847_ = false;
                                                phi_1848_ = false;
                                            } else {
                                                if true {
                                                    phi_1846_ = false;
                                                } else {
                                                    phi_1846_ = true;
                                                }
                                                let _e1467 = phi_1846_;
                                                phi_1847_ = _e1467;
                                                phi_1848_ = true;
                                            }
                                            let _e1469 = phi_1847_;
                                            let _e1471 = phi_1848_;
                                            phi_1849_ = _e1469;
                                            phi_1850_ = _e1465;
                                            phi_1851_ = _e1471;
                                        } else {
                                            phi_1849_ = true;
                                            phi_1850_ = false;
                                            phi_1851_ = false;
                                        }
                                        let _e1473 = phi_1849_;
                                        let _e1475 = phi_1850_;
                                        let _e1477 = phi_1851_;
                                        phi_1852_ = false;
                                        phi_1853_ = _e1473;
                                        phi_1854_ = _e1475;
                                        phi_1855_ = _e1477;
                                    } else {
                                        phi_1852_ = true;
                                        phi_1853_ = false;
                                        phi_1854_ = false;
                                        phi_1855_ = false;
                                    }
                                    let _e1479 = phi_1852_;
                                    let _e1481 = phi_1853_;
                                    let _e1483 = phi_1854_;
                                    let _e1485 = phi_1855_;
                                    phi_1856_ = _e1479;
                                    phi_1857_ = _e1481;
                                    phi_1858_ = _e1483;
                                    phi_1859_ = _e1485;
                                } else {
                                    phi_1856_ = true;
                                    phi_1857_ = false;
                                    phi_1858_ = false;
                                    phi_1859_ = false;
                                }
                                let _e1487 = phi_1856_;
                                let _e1489 = phi_1857_;
                                let _e1491 = phi_1858_;
                                let _e1493 = phi_1859_;
                                if _e1487 {
                                    phi_1863_ = true;
                                    phi_1864_ = false;
                                    phi_1865_ = false;
                                } else {
                                    phi_1863_ = _e1489;
                                    phi_1864_ = _e1491;
                                    phi_1865_ = _e1493;
                                }
                                let _e1495 = phi_1863_;
                                let _e1497 = phi_1864_;
                                let _e1499 = phi_1865_;
                                if _e1495 {
                                    let _e1500 = (_e1010 == 0u);
                                    if _e1500 {
                                        phi_1873_ = false;
                                    } else {
                                        phi_1873_ = true;
                                    }
                                    let _e1502 = phi_1873_;
                                    phi_1874_ = _e1502;
                                    phi_1875_ = _e1500;
                                    phi_1876_ = false;
                                    phi_1877_ = false;
                                } else {
                                    phi_1874_ = false;
                                    phi_1875_ = false;
                                    phi_1876_ = _e1497;
                                    phi_1877_ = _e1499;
                                }
                                let _e1504 = phi_1874_;
                                let _e1506 = phi_1875_;
                                let _e1508 = phi_1876_;
                                let _e1510 = phi_1877_;
                                local_5 = _e1506;
                                local_16 = _e1508;
                                local_17 = _e1510;
                                local_18 = _e1506;
                                continue;
                                continuing {
                                    phi_1227_ = _e1010;
                                    break if !(_e1504);
                                }
                            }
                            let _e1513 = local_5;
                            if _e1513 {
                                phi_1881_ = false;
                                phi_1882_ = false;
                            } else {
                                let _e3165 = local_16;
                                phi_1881_ = _e3165;
                                let _e3168 = local_17;
                                phi_1882_ = _e3168;
                            }
                            let _e1515 = phi_1881_;
                            let _e1517 = phi_1882_;
                            let _e3171 = local_18;
                            phi_1883_ = _e3171;
                            phi_1884_ = _e1515;
                            phi_1885_ = _e1517;
                        }
                        let _e1519 = phi_1883_;
                        let _e1521 = phi_1884_;
                        let _e1523 = phi_1885_;
                        if _e1519 {
                            let _e1525 = local_6;
                            if (_e1525 == 0u) {
                                phi_1893_ = false;
                            } else {
                                phi_1893_ = true;
                            }
                            let _e1528 = phi_1893_;
                            phi_1894_ = _e1528;
                            phi_1895_ = false;
                            phi_1896_ = false;
                        } else {
                            phi_1894_ = false;
                            phi_1895_ = _e1521;
                            phi_1896_ = _e1523;
                        }
                        let _e1530 = phi_1894_;
                        let _e1532 = phi_1895_;
                        let _e1534 = phi_1896_;
                        local_7 = _e1532;
                        local_19 = _e1534;
                        local_20 = _e1532;
                        continue;
                        continuing {
                            let _e3015 = local_13;
                            phi_773_ = _e3015;
                            let _e3018 = local_14;
                            phi_776_ = _e3018;
                            break if !(_e1530);
                        }
                    }
                    let _e1537 = local_7;
                    if _e1537 {
                        phi_1900_ = false;
                    } else {
                        let _e3182 = local_19;
                        phi_1900_ = _e3182;
                    }
                    let _e1539 = phi_1900_;
                    if _e1539 {
                        phi_1904_ = true;
                    } else {
                        let _e3185 = local_20;
                        phi_1904_ = _e3185;
                    }
                    let _e1541 = phi_1904_;
                    if _e1541 {
                        phi_1908_ = true;
                    } else {
                        phi_1908_ = false;
                    }
                    let _e1543 = phi_1908_;
                    phi_1909_ = _e1543;
                }
                let _e1545 = phi_1909_;
                phi_3366_ = _e1545;
            } else {
                let _e1546 = abs(_e139);
                let _e1547 = abs(_e140);
                let _e1548 = abs(_e141);
                if (abs(_e119) < 1000000000000000f) {
                    if (abs(_e121) < 1000000000000000f) {
                        phi_1925_ = (abs(_e123) < 1000000000000000f);
                        phi_1926_ = false;
                    } else {
                        phi_1925_ = bool();
                        phi_1926_ = true;
                    }
                    let _e1556 = phi_1925_;
                    let _e1558 = phi_1926_;
                    phi_1927_ = _e1556;
                    phi_1928_ = _e1558;
                } else {
                    phi_1927_ = bool();
                    phi_1928_ = true;
                }
                let _e1560 = phi_1927_;
                let _e1562 = phi_1928_;
                if _e1562 {
                    phi_1932_ = false;
                } else {
                    phi_1932_ = _e1560;
                }
                let _e1564 = phi_1932_;
                if _e1564 {
                    if (_e1546 < 1000000000000000f) {
                        if (_e1547 < 1000000000000000f) {
                            phi_1945_ = (_e1548 < 1000000000000000f);
                            phi_1946_ = false;
                        } else {
                            phi_1945_ = bool();
                            phi_1946_ = true;
                        }
                        let _e1569 = phi_1945_;
                        let _e1571 = phi_1946_;
                        phi_1947_ = _e1569;
                        phi_1948_ = _e1571;
                    } else {
                        phi_1947_ = bool();
                        phi_1948_ = true;
                    }
                    let _e1573 = phi_1947_;
                    let _e1575 = phi_1948_;
                    if _e1575 {
                        phi_1952_ = false;
                    } else {
                        phi_1952_ = _e1573;
                    }
                    let _e1577 = phi_1952_;
                    if _e1577 {
                        if (_e1546 > 0f) {
                            phi_1966_ = bool();
                            phi_1967_ = true;
                        } else {
                            let _e1579 = (_e1547 > 0f);
                            if _e1579 {
                                phi_1965_ = bool();
                            } else {
                                phi_1965_ = (_e1548 > 0f);
                            }
                            let _e1582 = phi_1965_;
                            phi_1966_ = _e1582;
                            phi_1967_ = _e1579;
                        }
                        let _e1584 = phi_1966_;
                        let _e1586 = phi_1967_;
                        if _e1586 {
                            phi_1971_ = true;
                        } else {
                            phi_1971_ = _e1584;
                        }
                        let _e1588 = phi_1971_;
                        phi_1972_ = _e1588;
                        phi_1973_ = false;
                    } else {
                        phi_1972_ = bool();
                        phi_1973_ = true;
                    }
                    let _e1590 = phi_1972_;
                    let _e1592 = phi_1973_;
                    phi_1974_ = _e1590;
                    phi_1975_ = _e1592;
                } else {
                    phi_1974_ = bool();
                    phi_1975_ = true;
                }
                let _e1594 = phi_1974_;
                let _e1596 = phi_1975_;
                if _e1596 {
                    phi_1979_ = false;
                } else {
                    phi_1979_ = _e1594;
                }
                let _e1598 = phi_1979_;
                if _e1598 {
                    let _e1599 = (0u >= _e72);
                    if _e1599 {
                        phi_3359_ = bool();
                    } else {
                        if (0u < _e72) {
                        } else {
                            return;
                        }
                        let _e1605 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1609 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1613 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1617 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1621 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1625 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1629 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1663 = core_intrinsics_maximum_number_nsz_f32_(abs(_e139), abs(_e140));
                        let _e1664 = core_intrinsics_maximum_number_nsz_f32_(_e1663, abs(_e141));
                        let _e1665 = (_e1664 * 0.0000000000009094947f);
                        if (abs(_e139) < _e1665) {
                            phi_2049_ = _e1665;
                        } else {
                            phi_2049_ = abs(_e139);
                        }
                        let _e1670 = phi_2049_;
                        if (_e139 < 0f) {
                            phi_2056_ = (-1f / _e1670);
                        } else {
                            phi_2056_ = (1f / _e1670);
                        }
                        let _e1675 = phi_2056_;
                        if (abs(_e140) < _e1665) {
                            phi_2063_ = _e1665;
                        } else {
                            phi_2063_ = abs(_e140);
                        }
                        let _e1680 = phi_2063_;
                        if (_e140 < 0f) {
                            phi_2070_ = (-1f / _e1680);
                        } else {
                            phi_2070_ = (1f / _e1680);
                        }
                        let _e1685 = phi_2070_;
                        if (abs(_e141) < _e1665) {
                            phi_2077_ = _e1665;
                        } else {
                            phi_2077_ = abs(_e141);
                        }
                        let _e1690 = phi_2077_;
                        if (_e141 < 0f) {
                            phi_2084_ = (-1f / _e1690);
                        } else {
                            phi_2084_ = (1f / _e1690);
                        }
                        let _e1695 = phi_2084_;
                        let _e1699 = abs((bitcast<f32>(_e1605) - _e119));
                        let _e1700 = abs((bitcast<f32>(_e1609) - _e121));
                        let _e1701 = abs((bitcast<f32>(_e1613) - _e123));
                        let _e1705 = abs(((bitcast<f32>(_e1617) + (bitcast<f32>((((_e1629 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e119));
                        let _e1706 = abs(((bitcast<f32>(_e1621) + (bitcast<f32>((((_e1629 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e121));
                        let _e1707 = abs(((bitcast<f32>(_e1625) + (bitcast<f32>((((_e1629 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e123));
                        if (_e1699 > _e1705) {
                            phi_2101_ = _e1699;
                        } else {
                            phi_2101_ = _e1705;
                        }
                        let _e1710 = phi_2101_;
                        if (_e1700 > _e1706) {
                            phi_2106_ = _e1700;
                        } else {
                            phi_2106_ = _e1706;
                        }
                        let _e1713 = phi_2106_;
                        if (_e1701 > _e1707) {
                            phi_2111_ = _e1701;
                        } else {
                            phi_2111_ = _e1707;
                        }
                        let _e1716 = phi_2111_;
                        if (_e1710 > _e1713) {
                            phi_2116_ = _e1710;
                        } else {
                            phi_2116_ = _e1713;
                        }
                        let _e1719 = phi_2116_;
                        if (_e1719 > _e1716) {
                            phi_2121_ = _e1719;
                        } else {
                            phi_2121_ = _e1716;
                        }
                        let _e1722 = phi_2121_;
                        let _e1726 = (_e1722 * 0.0000019073486f);
                        let _e1727 = (abs(_e1675) * _e1726);
                        let _e1728 = (abs(_e1685) * _e1726);
                        let _e1729 = (abs(_e1695) * _e1726);
                        let _e1733 = (_e1722 * 0.0000009536743f);
                        let _e1734 = (abs(_e1675) * _e1733);
                        let _e1735 = (abs(_e1685) * _e1733);
                        let _e1736 = (abs(_e1695) * _e1733);
                        let _e1737 = abs(_e139);
                        let _e1738 = abs(_e140);
                        let _e1739 = abs(_e141);
                        if (_e1737 >= _e1738) {
                            if (_e1737 >= _e1739) {
                                phi_2147_ = false;
                            } else {
                                phi_2147_ = true;
                            }
                            let _e1743 = phi_2147_;
                            phi_2148_ = _e1743;
                        } else {
                            phi_2148_ = true;
                        }
                        let _e1745 = phi_2148_;
                        if _e1745 {
                            if (_e1738 >= _e1739) {
                                phi_2156_ = 1u;
                            } else {
                                phi_2156_ = 2u;
                            }
                            let _e1748 = phi_2156_;
                            phi_2157_ = _e1748;
                        } else {
                            phi_2157_ = 0u;
                        }
                        let _e1750 = phi_2157_;
                        if (_e1750 == 0u) {
                            phi_2169_ = vec3<f32>(_e140, _e141, _e139);
                        } else {
                            if (_e1750 == 1u) {
                                phi_2168_ = vec3<f32>(_e141, _e139, _e140);
                            } else {
                                phi_2168_ = _e142;
                            }
                            let _e1756 = phi_2168_;
                            phi_2169_ = _e1756;
                        }
                        let _e1758 = phi_2169_;
                        let _e1761 = (_e1758.x / _e1758.z);
                        let _e1764 = (_e1758.y / _e1758.z);
                        if (_e1675 < 0f) {
                            phi_2182_ = 0u;
                        } else {
                            phi_2182_ = 1u;
                        }
                        let _e1769 = phi_2182_;
                        if (_e1685 < 0f) {
                            phi_2187_ = 0u;
                        } else {
                            phi_2187_ = 2u;
                        }
                        let _e1772 = phi_2187_;
                        if (_e1695 < 0f) {
                            phi_2192_ = 0u;
                        } else {
                            phi_2192_ = 4u;
                        }
                        let _e1775 = phi_2192_;
                        let _e1777 = ((_e1769 | _e1772) | _e1775);
                        let _e1778 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1778.first[0], _e1778.first[1], _e1778.first[2], _e1778.first[3], _e1778.first[4], _e1778.first[5], _e1778.first[6], _e1778.first[7], _e1778.first[8], _e1778.first[9], _e1778.first[10], _e1778.first[11], _e1778.first[12], _e1778.first[13], _e1778.first[14], _e1778.first[15], _e1778.first[16], _e1778.first[17], _e1778.first[18], _e1778.first[19], _e1778.first[20], _e1778.first[21], _e1778.first[22], _e1778.first[23], _e1778.first[24], _e1778.first[25], _e1778.first[26], _e1778.first[27], _e1778.first[28], _e1778.first[29], _e1778.first[30], _e1778.first[31]), array<u32, 32>(_e1778.mask[0], _e1778.mask[1], _e1778.mask[2], _e1778.mask[3], _e1778.mask[4], _e1778.mask[5], _e1778.mask[6], _e1778.mask[7], _e1778.mask[8], _e1778.mask[9], _e1778.mask[10], _e1778.mask[11], _e1778.mask[12], _e1778.mask[13], _e1778.mask[14], _e1778.mask[15], _e1778.mask[16], _e1778.mask[17], _e1778.mask[18], _e1778.mask[19], _e1778.mask[20], _e1778.mask[21], _e1778.mask[22], _e1778.mask[23], _e1778.mask[24], _e1778.mask[25], _e1778.mask[26], _e1778.mask[27], _e1778.mask[28], _e1778.mask[29], _e1778.mask[30], _e1778.mask[31]), _e1778.len, _e1778.group, _e1778.group_mask);
                        let _e1852 = local.group_mask;
                        if ((_e1852 & 4278190080u) == 0u) {
                            let _e1856 = local.len;
                            if (_e1856 == 0u) {
                                phi_2306_ = false;
                            } else {
                                let _e1860 = local.len;
                                local.len = (_e1860 - 1u);
                                let _e1863 = local.len;
                                if (_e1863 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1868 = local.first[(0u + _e1863)];
                                local.group = _e1868;
                                let _e1871 = local.len;
                                if (_e1871 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1876 = local.mask[(0u + _e1871)];
                                local.group_mask = _e1876;
                                phi_2306_ = true;
                            }
                            let _e1879 = phi_2306_;
                            phi_2307_ = _e1879;
                        } else {
                            phi_2307_ = true;
                        }
                        let _e1881 = phi_2307_;
                        if _e1881 {
                            let _e1883 = local.group_mask;
                            let _e1889 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1883)), 32u, (_e1883 == 0u)));
                            let _e1893 = local.group_mask;
                            let _e1907 = local.group_mask;
                            local.group_mask = (_e1907 & ~((1u << bitcast<u32>((_e1889 & 31u)))));
                            let _e1910 = local.group;
                            phi_2338_ = (_e1910 + countOneBits(((_e1893 & ~((4294967295u << bitcast<u32>((((_e1889 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2338_ = 4294967295u;
                        }
                        let _e1913 = phi_2338_;
                        phi_2340_ = _e1913;
                        phi_2343_ = false;
                        loop {
                            let _e1915 = phi_2340_;
                            let _e1917 = phi_2343_;
                            local_23 = _e1917;
                            if (_e1915 != 4294967295u) {
                                if (_e1915 < _e72) {
                                } else {
                                    return;
                                }
                                let _e1924 = nodes.member[(0u + _e1915)].frame[3u];
                                let _e1949 = (bitcast<f32>((((_e1924 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1675);
                                let _e1950 = (bitcast<f32>((((_e1924 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1685);
                                let _e1951 = (bitcast<f32>((((_e1924 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1695);
                                let _e1954 = nodes.member[(0u + _e1915)].frame[0u];
                                let _e1958 = nodes.member[(0u + _e1915)].frame[1u];
                                let _e1962 = nodes.member[(0u + _e1915)].frame[2u];
                                let _e1967 = ((bitcast<f32>(_e1954) - _e119) * _e1675);
                                let _e1968 = ((bitcast<f32>(_e1958) - _e121) * _e1685);
                                let _e1969 = ((bitcast<f32>(_e1962) - _e123) * _e1695);
                                let _e1977 = nodes.member[(0u + _e1915)].x;
                                if (_e1675 < 0f) {
                                    let _e1988 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1977.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1994 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1988.unnamed.root, _e1977.w), _e1988.unnamed_1);
                                    let _e2000 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1994.unnamed, lt_bvh_traverse_Tree(_e1977.x, _e1994.unnamed_1.first_primitive));
                                    phi_2423_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2000.unnamed, lt_bvh_traverse_Tree(_e2000.unnamed_1.root, _e1977.y));
                                } else {
                                    let _e2016 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1977.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2022 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2016.unnamed.root, _e1977.y), _e2016.unnamed_1);
                                    let _e2028 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2022.unnamed, lt_bvh_traverse_Tree(_e1977.z, _e2022.unnamed_1.first_primitive));
                                    phi_2423_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2028.unnamed, lt_bvh_traverse_Tree(_e2028.unnamed_1.root, _e1977.w));
                                }
                                let _e2036 = phi_2423_;
                                let _e2046 = nodes.member[(0u + _e1915)].y;
                                if (_e1685 < 0f) {
                                    let _e2057 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2046.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2063 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2057.unnamed.root, _e2046.w), _e2057.unnamed_1);
                                    let _e2069 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2063.unnamed, lt_bvh_traverse_Tree(_e2046.x, _e2063.unnamed_1.first_primitive));
                                    phi_2450_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2069.unnamed, lt_bvh_traverse_Tree(_e2069.unnamed_1.root, _e2046.y));
                                } else {
                                    let _e2085 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2046.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2091 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2085.unnamed.root, _e2046.y), _e2085.unnamed_1);
                                    let _e2097 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2091.unnamed, lt_bvh_traverse_Tree(_e2046.z, _e2091.unnamed_1.first_primitive));
                                    phi_2450_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2097.unnamed, lt_bvh_traverse_Tree(_e2097.unnamed_1.root, _e2046.w));
                                }
                                let _e2105 = phi_2450_;
                                let _e2115 = nodes.member[(0u + _e1915)].z;
                                if (_e1695 < 0f) {
                                    let _e2126 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2115.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2132 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2126.unnamed.root, _e2115.w), _e2126.unnamed_1);
                                    let _e2138 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2132.unnamed, lt_bvh_traverse_Tree(_e2115.x, _e2132.unnamed_1.first_primitive));
                                    phi_2477_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2138.unnamed, lt_bvh_traverse_Tree(_e2138.unnamed_1.root, _e2115.y));
                                } else {
                                    let _e2154 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2115.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2160 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2154.unnamed.root, _e2115.y), _e2154.unnamed_1);
                                    let _e2166 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2160.unnamed, lt_bvh_traverse_Tree(_e2115.z, _e2160.unnamed_1.first_primitive));
                                    phi_2477_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2166.unnamed, lt_bvh_traverse_Tree(_e2166.unnamed_1.root, _e2115.w));
                                }
                                let _e2174 = phi_2477_;
                                phi_2483_ = 0u;
                                phi_2486_ = 0u;
                                loop {
                                    let _e2184 = phi_2483_;
                                    let _e2186 = phi_2486_;
                                    local_8 = _e2186;
                                    local_9 = _e2186;
                                    local_10 = _e2186;
                                    let _e2187 = (_e2184 < 8u);
                                    if _e2187 {
                                        let _e2189 = (_e2184 >> bitcast<u32>(2i));
                                        let _e2190 = (_e2184 & 3u);
                                        if (_e2189 == 0u) {
                                            phi_2500_ = _e2036.unnamed.root;
                                        } else {
                                            phi_2500_ = _e2036.unnamed.first_primitive;
                                        }
                                        let _e2193 = phi_2500_;
                                        if (_e2189 == 0u) {
                                            phi_2510_ = _e2105.unnamed.root;
                                        } else {
                                            phi_2510_ = _e2105.unnamed.first_primitive;
                                        }
                                        let _e2202 = phi_2510_;
                                        if (_e2189 == 0u) {
                                            phi_2520_ = _e2174.unnamed.root;
                                        } else {
                                            phi_2520_ = _e2174.unnamed.first_primitive;
                                        }
                                        let _e2211 = phi_2520_;
                                        let _e2224 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2193 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u)) * _e1949) + (_e1967 - _e1727)), ((f32(((_e2202 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u)) * _e1950) + (_e1968 - _e1728)));
                                        let _e2225 = core_intrinsics_maximum_number_nsz_f32_(_e2224, ((f32(((_e2211 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u)) * _e1951) + (_e1969 - _e1729)));
                                        if (_e2189 == 0u) {
                                            phi_2538_ = _e2036.unnamed_1.root;
                                        } else {
                                            phi_2538_ = _e2036.unnamed_1.first_primitive;
                                        }
                                        let _e2228 = phi_2538_;
                                        if (_e2189 == 0u) {
                                            phi_2548_ = _e2105.unnamed_1.root;
                                        } else {
                                            phi_2548_ = _e2105.unnamed_1.first_primitive;
                                        }
                                        let _e2237 = phi_2548_;
                                        if (_e2189 == 0u) {
                                            phi_2558_ = _e2174.unnamed_1.root;
                                        } else {
                                            phi_2558_ = _e2174.unnamed_1.first_primitive;
                                        }
                                        let _e2246 = phi_2558_;
                                        let _e2259 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2228 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u)) * _e1949) + (_e1967 + _e1727)), ((f32(((_e2237 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u)) * _e1950) + (_e1968 + _e1728)));
                                        let _e2260 = core_intrinsics_minimum_number_nsz_f32_(_e2259, ((f32(((_e2246 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u)) * _e1951) + (_e1969 + _e1729)));
                                        if (_e2225 <= _e2260) {
                                            if (_e2225 <= _e131) {
                                                if (_e2260 >= 0f) {
                                                    if (_e2189 == 0u) {
                                                        let _e2267 = nodes.member[(0u + _e1915)].links[2u];
                                                        phi_2594_ = _e2267;
                                                    } else {
                                                        let _e2270 = nodes.member[(0u + _e1915)].links[3u];
                                                        phi_2594_ = _e2270;
                                                    }
                                                    let _e2272 = phi_2594_;
                                                    let _e2277 = ((_e2272 >> bitcast<u32>(((_e2190 * 8u) & 31u))) & 255u);
                                                    let _e2278 = (_e2277 & 31u);
                                                    if (_e2278 >= 24u) {
                                                        phi_2607_ = (24u + ((_e2278 - 24u) ^ _e1777));
                                                    } else {
                                                        phi_2607_ = _e2278;
                                                    }
                                                    let _e2284 = phi_2607_;
                                                    phi_2612_ = (_e2186 | ((_e2277 >> bitcast<u32>(5i)) << bitcast<u32>((_e2284 & 31u))));
                                                } else {
                                                    phi_2612_ = _e2186;
                                                }
                                                let _e2292 = phi_2612_;
                                                phi_2613_ = _e2292;
                                            } else {
                                                phi_2613_ = _e2186;
                                            }
                                            let _e2294 = phi_2613_;
                                            phi_2614_ = _e2294;
                                        } else {
                                            phi_2614_ = _e2186;
                                        }
                                        let _e2296 = phi_2614_;
                                        phi_2484_ = (_e2184 + 1u);
                                        phi_2487_ = _e2296;
                                    } else {
                                        phi_2484_ = u32();
                                        phi_2487_ = u32();
                                    }
                                    let _e2299 = phi_2484_;
                                    let _e2301 = phi_2487_;
                                    continue;
                                    continuing {
                                        phi_2483_ = _e2299;
                                        phi_2486_ = _e2301;
                                        break if !(_e2187);
                                    }
                                }
                                let _e2305 = nodes.member[(0u + _e1915)].links[0u];
                                let _e2309 = nodes.member[(0u + _e1915)].frame[3u];
                                let _e2313 = local_8;
                                if ((_e2313 & 4278190080u) == 0u) {
                                } else {
                                    let _e2317 = local.group_mask;
                                    if ((_e2317 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2321 = local.len;
                                        if (_e2321 < 32u) {
                                            let _e2324 = local.group;
                                            let _e2326 = local.len;
                                            if (_e2326 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2326)] = _e2324;
                                            let _e2332 = local.group_mask;
                                            let _e2334 = local.len;
                                            if (_e2334 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2334)] = _e2332;
                                            let _e2341 = local.len;
                                            local.len = (_e2341 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2305);
                                    let _e2345 = local_9;
                                    local.group_mask = ((_e2345 & 4278190080u) | (_e2309 >> bitcast<u32>(24i)));
                                }
                                let _e2350 = local_10;
                                phi_2672_ = (_e2350 & 16777215u);
                                phi_2675_ = _e1917;
                                loop {
                                    let _e2353 = phi_2672_;
                                    let _e2355 = phi_2675_;
                                    local_21 = _e2355;
                                    let _e2356 = (_e2353 == 0u);
                                    local_11 = _e2356;
                                    local_22 = _e2356;
                                    if _e2356 {
                                        phi_2673_ = u32();
                                        phi_2676_ = bool();
                                        phi_3273_ = false;
                                    } else {
                                        let _e2359 = nodes.member[(0u + _e1915)].links[1u];
                                        let _e2364 = ((0u + _e2359) + select(firstTrailingBit(_e2353), 32u, (_e2353 == 0u)));
                                        if (_e2364 < _e75) {
                                        } else {
                                            return;
                                        }
                                        let _e2371 = triangles.member[(0u + _e2364)].v0_;
                                        let _e2373 = (_e2371.x - _e119);
                                        let _e2375 = (_e2371.y - _e121);
                                        let _e2377 = (_e2371.z - _e123);
                                        if (_e1750 == 0u) {
                                            phi_2720_ = vec3<f32>(_e2375, _e2377, _e2373);
                                        } else {
                                            if (_e1750 == 1u) {
                                                phi_2719_ = vec3<f32>(_e2377, _e2373, _e2375);
                                            } else {
                                                phi_2719_ = (_e2371 - vec3<f32>(_e119, _e121, _e123));
                                            }
                                            let _e2385 = phi_2719_;
                                            phi_2720_ = _e2385;
                                        }
                                        let _e2387 = phi_2720_;
                                        let _e2391 = (_e2387.x - (_e1761 * _e2387.z));
                                        let _e2395 = (_e2387.y - (_e1764 * _e2387.z));
                                        let _e2397 = triangles.member[(0u + _e2364)].v1_;
                                        let _e2399 = (_e2397.x - _e119);
                                        let _e2401 = (_e2397.y - _e121);
                                        let _e2403 = (_e2397.z - _e123);
                                        if (_e1750 == 0u) {
                                            phi_2750_ = vec3<f32>(_e2401, _e2403, _e2399);
                                        } else {
                                            if (_e1750 == 1u) {
                                                phi_2749_ = vec3<f32>(_e2403, _e2399, _e2401);
                                            } else {
                                                phi_2749_ = (_e2397 - vec3<f32>(_e119, _e121, _e123));
                                            }
                                            let _e2411 = phi_2749_;
                                            phi_2750_ = _e2411;
                                        }
                                        let _e2413 = phi_2750_;
                                        let _e2417 = (_e2413.x - (_e1761 * _e2413.z));
                                        let _e2421 = (_e2413.y - (_e1764 * _e2413.z));
                                        let _e2423 = triangles.member[(0u + _e2364)].v2_;
                                        let _e2425 = (_e2423.x - _e119);
                                        let _e2427 = (_e2423.y - _e121);
                                        let _e2429 = (_e2423.z - _e123);
                                        if (_e1750 == 0u) {
                                            phi_2780_ = vec3<f32>(_e2427, _e2429, _e2425);
                                        } else {
                                            if (_e1750 == 1u) {
                                                phi_2779_ = vec3<f32>(_e2429, _e2425, _e2427);
                                            } else {
                                                phi_2779_ = (_e2423 - vec3<f32>(_e119, _e121, _e123));
                                            }
                                            let _e2437 = phi_2779_;
                                            phi_2780_ = _e2437;
                                        }
                                        let _e2439 = phi_2780_;
                                        let _e2443 = (_e2439.x - (_e1761 * _e2439.z));
                                        let _e2447 = (_e2439.y - (_e1764 * _e2439.z));
                                        if (_e2417 < _e2443) {
                                            phi_2799_ = true;
                                        } else {
                                            if (_e2417 == _e2443) {
                                                phi_2798_ = (_e2421 < _e2447);
                                            } else {
                                                phi_2798_ = false;
                                            }
                                            let _e2452 = phi_2798_;
                                            phi_2799_ = _e2452;
                                        }
                                        let _e2454 = phi_2799_;
                                        if _e2454 {
                                            phi_2803_ = _e2447;
                                            phi_2804_ = _e2443;
                                            phi_2805_ = _e2421;
                                            phi_2806_ = _e2417;
                                        } else {
                                            phi_2803_ = _e2421;
                                            phi_2804_ = _e2417;
                                            phi_2805_ = _e2447;
                                            phi_2806_ = _e2443;
                                        }
                                        let _e2456 = phi_2803_;
                                        let _e2458 = phi_2804_;
                                        let _e2460 = phi_2805_;
                                        let _e2462 = phi_2806_;
                                        let _e2465 = ((_e2462 * _e2456) - (_e2460 * _e2458));
                                        if _e2454 {
                                            phi_2814_ = -(_e2465);
                                        } else {
                                            phi_2814_ = _e2465;
                                        }
                                        let _e2468 = phi_2814_;
                                        if (_e2443 < _e2391) {
                                            phi_2825_ = true;
                                        } else {
                                            if (_e2443 == _e2391) {
                                                phi_2824_ = (_e2447 < _e2395);
                                            } else {
                                                phi_2824_ = false;
                                            }
                                            let _e2473 = phi_2824_;
                                            phi_2825_ = _e2473;
                                        }
                                        let _e2475 = phi_2825_;
                                        if _e2475 {
                                            phi_2829_ = _e2395;
                                            phi_2830_ = _e2391;
                                            phi_2831_ = _e2447;
                                            phi_2832_ = _e2443;
                                        } else {
                                            phi_2829_ = _e2447;
                                            phi_2830_ = _e2443;
                                            phi_2831_ = _e2395;
                                            phi_2832_ = _e2391;
                                        }
                                        let _e2477 = phi_2829_;
                                        let _e2479 = phi_2830_;
                                        let _e2481 = phi_2831_;
                                        let _e2483 = phi_2832_;
                                        let _e2486 = ((_e2483 * _e2477) - (_e2481 * _e2479));
                                        if _e2475 {
                                            phi_2840_ = -(_e2486);
                                        } else {
                                            phi_2840_ = _e2486;
                                        }
                                        let _e2489 = phi_2840_;
                                        if (_e2391 < _e2417) {
                                            phi_2851_ = true;
                                        } else {
                                            if (_e2391 == _e2417) {
                                                phi_2850_ = (_e2395 < _e2421);
                                            } else {
                                                phi_2850_ = false;
                                            }
                                            let _e2494 = phi_2850_;
                                            phi_2851_ = _e2494;
                                        }
                                        let _e2496 = phi_2851_;
                                        if _e2496 {
                                            phi_2855_ = _e2421;
                                            phi_2856_ = _e2417;
                                            phi_2857_ = _e2395;
                                            phi_2858_ = _e2391;
                                        } else {
                                            phi_2855_ = _e2395;
                                            phi_2856_ = _e2391;
                                            phi_2857_ = _e2421;
                                            phi_2858_ = _e2417;
                                        }
                                        let _e2498 = phi_2855_;
                                        let _e2500 = phi_2856_;
                                        let _e2502 = phi_2857_;
                                        let _e2504 = phi_2858_;
                                        let _e2507 = ((_e2504 * _e2498) - (_e2502 * _e2500));
                                        if _e2496 {
                                            phi_2866_ = -(_e2507);
                                        } else {
                                            phi_2866_ = _e2507;
                                        }
                                        let _e2510 = phi_2866_;
                                        if (_e2468 >= 0f) {
                                            if (_e2489 >= 0f) {
                                                if (_e2510 >= 0f) {
                                                    phi_2881_ = ((_e2468 + _e2489) + _e2510);
                                                    phi_2882_ = false;
                                                } else {
                                                    phi_2881_ = f32();
                                                    phi_2882_ = true;
                                                }
                                                let _e2517 = phi_2881_;
                                                let _e2519 = phi_2882_;
                                                phi_2883_ = _e2517;
                                                phi_2884_ = _e2519;
                                            } else {
                                                phi_2883_ = f32();
                                                phi_2884_ = true;
                                            }
                                            let _e2521 = phi_2883_;
                                            let _e2523 = phi_2884_;
                                            phi_2885_ = _e2521;
                                            phi_2886_ = _e2523;
                                        } else {
                                            phi_2885_ = f32();
                                            phi_2886_ = true;
                                        }
                                        let _e2525 = phi_2885_;
                                        let _e2527 = phi_2886_;
                                        if _e2527 {
                                            if (_e2468 <= 0f) {
                                                if (_e2489 <= 0f) {
                                                    let _e2530 = (_e2510 <= 0f);
                                                    if _e2530 {
                                                    }
                                                    phi_2904_ = ((_e2468 + _e2489) + _e2510);
                                                    phi_2905_ = false;
                                                    phi_2906_ = _e2530;
                                                } else {
                                                    phi_2904_ = f32();
                                                    phi_2905_ = true;
                                                    phi_2906_ = false;
                                                }
                                                let _e2534 = phi_2904_;
                                                let _e2536 = phi_2905_;
                                                let _e2538 = phi_2906_;
                                                phi_2907_ = _e2534;
                                                phi_2908_ = _e2536;
                                                phi_2909_ = _e2538;
                                            } else {
                                                phi_2907_ = f32();
                                                phi_2908_ = true;
                                                phi_2909_ = false;
                                            }
                                            let _e2540 = phi_2907_;
                                            let _e2542 = phi_2908_;
                                            let _e2544 = phi_2909_;
                                            if _e2542 {
                                                phi_2913_ = false;
                                            } else {
                                                phi_2913_ = _e2544;
                                            }
                                            let _e2546 = phi_2913_;
                                            phi_2914_ = _e2540;
                                            phi_2915_ = _e2546;
                                        } else {
                                            phi_2914_ = _e2525;
                                            phi_2915_ = true;
                                        }
                                        let _e2548 = phi_2914_;
                                        let _e2550 = phi_2915_;
                                        if _e2550 {
                                            let _e2551 = (_e2548 == 0f);
                                            if _e2551 {
                                                phi_3231_ = lt_bvh_triangle_Intersection();
                                                phi_3232_ = false;
                                            } else {
                                                let _e2553 = triangles.member[(0u + _e2364)].v0_;
                                                let _e2555 = (_e2553.x - _e119);
                                                let _e2557 = (_e2553.y - _e121);
                                                let _e2559 = (_e2553.z - _e123);
                                                if (_e1750 == 0u) {
                                                    phi_2944_ = vec3<f32>(_e2557, _e2559, _e2555);
                                                } else {
                                                    if (_e1750 == 1u) {
                                                        phi_2943_ = vec3<f32>(_e2559, _e2555, _e2557);
                                                    } else {
                                                        phi_2943_ = (_e2553 - vec3<f32>(_e119, _e121, _e123));
                                                    }
                                                    let _e2567 = phi_2943_;
                                                    phi_2944_ = _e2567;
                                                }
                                                let _e2569 = phi_2944_;
                                                let _e2571 = triangles.member[(0u + _e2364)].v1_;
                                                let _e2573 = triangles.member[(0u + _e2364)].v0_;
                                                let _e2576 = (_e2571.x - _e2573.x);
                                                let _e2579 = (_e2571.y - _e2573.y);
                                                let _e2582 = (_e2571.z - _e2573.z);
                                                if (_e1750 == 0u) {
                                                    phi_2970_ = vec3<f32>(_e2579, _e2582, _e2576);
                                                } else {
                                                    if (_e1750 == 1u) {
                                                        phi_2969_ = vec3<f32>(_e2582, _e2576, _e2579);
                                                    } else {
                                                        phi_2969_ = (_e2571 - _e2573);
                                                    }
                                                    let _e2589 = phi_2969_;
                                                    phi_2970_ = _e2589;
                                                }
                                                let _e2591 = phi_2970_;
                                                let _e2593 = triangles.member[(0u + _e2364)].v2_;
                                                let _e2595 = triangles.member[(0u + _e2364)].v0_;
                                                let _e2598 = (_e2593.x - _e2595.x);
                                                let _e2601 = (_e2593.y - _e2595.y);
                                                let _e2604 = (_e2593.z - _e2595.z);
                                                if (_e1750 == 0u) {
                                                    phi_2996_ = vec3<f32>(_e2601, _e2604, _e2598);
                                                } else {
                                                    if (_e1750 == 1u) {
                                                        phi_2995_ = vec3<f32>(_e2604, _e2598, _e2601);
                                                    } else {
                                                        phi_2995_ = (_e2593 - _e2595);
                                                    }
                                                    let _e2611 = phi_2995_;
                                                    phi_2996_ = _e2611;
                                                }
                                                let _e2613 = phi_2996_;
                                                let _e2620 = ((_e2591.y * _e2613.z) - (_e2591.z * _e2613.y));
                                                let _e2627 = ((_e2591.z * _e2613.x) - (_e2591.x * _e2613.z));
                                                let _e2634 = ((_e2591.x * _e2613.y) - (_e2591.y * _e2613.x));
                                                let _e2648 = (((1f / _e1758.z) * (((_e2620 * _e2569.x) + (_e2627 * _e2569.y)) + (_e2634 * _e2569.z))) / (((_e2620 * _e1761) + (_e2627 * _e1764)) + _e2634));
                                                if (_e2648 > 0f) {
                                                    if (_e2648 < _e131) {
                                                        let _e2652 = triangles.member[(0u + _e2364)].v0_;
                                                        let _e2654 = triangles.member[(0u + _e2364)].v1_;
                                                        if (_e2652.x < _e2654.x) {
                                                            phi_3052_ = _e2652.x;
                                                        } else {
                                                            phi_3052_ = _e2654.x;
                                                        }
                                                        let _e2661 = phi_3052_;
                                                        if (_e2652.y < _e2654.y) {
                                                            phi_3061_ = _e2652.y;
                                                        } else {
                                                            phi_3061_ = _e2654.y;
                                                        }
                                                        let _e2668 = phi_3061_;
                                                        if (_e2652.z < _e2654.z) {
                                                            phi_3070_ = _e2652.z;
                                                        } else {
                                                            phi_3070_ = _e2654.z;
                                                        }
                                                        let _e2675 = phi_3070_;
                                                        let _e2677 = triangles.member[(0u + _e2364)].v2_;
                                                        if (_e2661 < _e2677.x) {
                                                            phi_3079_ = _e2661;
                                                        } else {
                                                            phi_3079_ = _e2677.x;
                                                        }
                                                        let _e2682 = phi_3079_;
                                                        if (_e2668 < _e2677.y) {
                                                            phi_3086_ = _e2668;
                                                        } else {
                                                            phi_3086_ = _e2677.y;
                                                        }
                                                        let _e2687 = phi_3086_;
                                                        if (_e2675 < _e2677.z) {
                                                            phi_3093_ = _e2675;
                                                        } else {
                                                            phi_3093_ = _e2677.z;
                                                        }
                                                        let _e2692 = phi_3093_;
                                                        let _e2694 = triangles.member[(0u + _e2364)].v0_;
                                                        let _e2696 = triangles.member[(0u + _e2364)].v1_;
                                                        if (_e2694.x > _e2696.x) {
                                                            phi_3106_ = _e2694.x;
                                                        } else {
                                                            phi_3106_ = _e2696.x;
                                                        }
                                                        let _e2703 = phi_3106_;
                                                        if (_e2694.y > _e2696.y) {
                                                            phi_3115_ = _e2694.y;
                                                        } else {
                                                            phi_3115_ = _e2696.y;
                                                        }
                                                        let _e2710 = phi_3115_;
                                                        if (_e2694.z > _e2696.z) {
                                                            phi_3124_ = _e2694.z;
                                                        } else {
                                                            phi_3124_ = _e2696.z;
                                                        }
                                                        let _e2717 = phi_3124_;
                                                        let _e2719 = triangles.member[(0u + _e2364)].v2_;
                                                        if (_e2703 > _e2719.x) {
                                                            phi_3133_ = _e2703;
                                                        } else {
                                                            phi_3133_ = _e2719.x;
                                                        }
                                                        let _e2724 = phi_3133_;
                                                        if (_e2710 > _e2719.y) {
                                                            phi_3140_ = _e2710;
                                                        } else {
                                                            phi_3140_ = _e2719.y;
                                                        }
                                                        let _e2729 = phi_3140_;
                                                        if (_e2717 > _e2719.z) {
                                                            phi_3147_ = _e2717;
                                                        } else {
                                                            phi_3147_ = _e2719.z;
                                                        }
                                                        let _e2734 = phi_3147_;
                                                        let _e2738 = ((_e2682 - _e119) * _e1675);
                                                        let _e2739 = ((_e2687 - _e121) * _e1685);
                                                        let _e2740 = ((_e2692 - _e123) * _e1695);
                                                        let _e2744 = ((_e2724 - _e119) * _e1675);
                                                        let _e2745 = ((_e2729 - _e121) * _e1685);
                                                        let _e2746 = ((_e2734 - _e123) * _e1695);
                                                        if (_e2738 < _e2744) {
                                                            phi_3164_ = _e2738;
                                                        } else {
                                                            phi_3164_ = _e2744;
                                                        }
                                                        let _e2749 = phi_3164_;
                                                        if (_e2739 < _e2745) {
                                                            phi_3169_ = _e2739;
                                                        } else {
                                                            phi_3169_ = _e2745;
                                                        }
                                                        let _e2752 = phi_3169_;
                                                        if (_e2740 < _e2746) {
                                                            phi_3174_ = _e2740;
                                                        } else {
                                                            phi_3174_ = _e2746;
                                                        }
                                                        let _e2755 = phi_3174_;
                                                        if (_e2738 > _e2744) {
                                                            phi_3182_ = _e2738;
                                                        } else {
                                                            phi_3182_ = _e2744;
                                                        }
                                                        let _e2761 = phi_3182_;
                                                        if (_e2739 > _e2745) {
                                                            phi_3187_ = _e2739;
                                                        } else {
                                                            phi_3187_ = _e2745;
                                                        }
                                                        let _e2764 = phi_3187_;
                                                        if (_e2740 > _e2746) {
                                                            phi_3192_ = _e2740;
                                                        } else {
                                                            phi_3192_ = _e2746;
                                                        }
                                                        let _e2767 = phi_3192_;
                                                        let _e2771 = core_intrinsics_maximum_number_nsz_f32_((_e2749 - _e1734), (_e2752 - _e1735));
                                                        let _e2772 = core_intrinsics_maximum_number_nsz_f32_(_e2771, (_e2755 - _e1736));
                                                        let _e2773 = core_intrinsics_minimum_number_nsz_f32_((_e2761 + _e1734), (_e2764 + _e1735));
                                                        let _e2774 = core_intrinsics_minimum_number_nsz_f32_(_e2773, (_e2767 + _e1736));
                                                        if (_e2772 > -300000000000000000000000000000000000000f) {
                                                            phi_3204_ = _e2772;
                                                        } else {
                                                            phi_3204_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2777 = phi_3204_;
                                                        if (_e2774 < 300000000000000000000000000000000000000f) {
                                                            phi_3209_ = _e2774;
                                                        } else {
                                                            phi_3209_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2780 = phi_3209_;
                                                        if (_e2648 < _e2777) {
                                                            phi_3214_ = _e2777;
                                                        } else {
                                                            phi_3214_ = _e2648;
                                                        }
                                                        let _e2783 = phi_3214_;
                                                        if (_e2783 > _e2780) {
                                                            phi_3219_ = _e2780;
                                                        } else {
                                                            phi_3219_ = _e2783;
                                                        }
                                                        let _e2786 = phi_3219_;
                                                        phi_3224_ = lt_bvh_triangle_Intersection(_e2786, (_e2489 / _e2548), (_e2510 / _e2548), (_e2777 <= _e2780));
                                                        phi_3225_ = false;
                                                    } else {
                                                        phi_3224_ = lt_bvh_triangle_Intersection();
                                                        phi_3225_ = true;
                                                    }
                                                    let _e2792 = phi_3224_;
                                                    let _e2794 = phi_3225_;
                                                    phi_3226_ = _e2792;
                                                    phi_3227_ = _e2794;
                                                } else {
                                                    phi_3226_ = lt_bvh_triangle_Intersection();
                                                    phi_3227_ = true;
                                                }
                                                let _e2796 = phi_3226_;
                                                let _e2798 = phi_3227_;
                                                if _e2798 {
                                                }
                                                phi_3231_ = _e2796;
                                                phi_3232_ = _e2798;
                                            }
                                            let _e2800 = phi_3231_;
                                            let _e2802 = phi_3232_;
                                            phi_3233_ = _e2800;
                                            phi_3234_ = _e2551;
                                            phi_3235_ = _e2802;
                                        } else {
                                            phi_3233_ = lt_bvh_triangle_Intersection();
                                            phi_3234_ = true;
                                            phi_3235_ = false;
                                        }
                                        let _e2804 = phi_3233_;
                                        let _e2806 = phi_3234_;
                                        let _e2808 = phi_3235_;
                                        if _e2806 {
                                            phi_3239_ = true;
                                        } else {
                                            phi_3239_ = _e2808;
                                        }
                                        let _e2810 = phi_3239_;
                                        if _e2810 {
                                            phi_3243_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3243_ = _e2804;
                                        }
                                        let _e2812 = phi_3243_;
                                        if _e2812.is_hit {
                                            if (_e2812.t > 0f) {
                                                if (_e2812.t < _e131) {
                                                    if true {
                                                        phi_3263_ = false;
                                                    } else {
                                                        phi_3263_ = true;
                                                    }
                                                    let _e2821 = phi_3263_;
                                                    phi_3264_ = true;
                                                    phi_3265_ = _e2821;
                                                } else {
                                                    phi_3264_ = _e2355;
                                                    phi_3265_ = true;
                                                }
                                                let _e2823 = phi_3264_;
                                                let _e2825 = phi_3265_;
                                                phi_3266_ = _e2823;
                                                phi_3267_ = _e2825;
                                            } else {
                                                phi_3266_ = _e2355;
                                                phi_3267_ = true;
                                            }
                                            let _e2827 = phi_3266_;
                                            let _e2829 = phi_3267_;
                                            phi_3268_ = _e2827;
                                            phi_3269_ = _e2829;
                                        } else {
                                            phi_3268_ = _e2355;
                                            phi_3269_ = true;
                                        }
                                        let _e2831 = phi_3268_;
                                        let _e2833 = phi_3269_;
                                        if _e2833 {
                                        }
                                        phi_2673_ = (_e2353 & (_e2353 - 1u));
                                        phi_2676_ = _e2831;
                                        phi_3273_ = _e2833;
                                    }
                                    let _e2835 = phi_2673_;
                                    let _e2837 = phi_2676_;
                                    let _e2839 = phi_3273_;
                                    continue;
                                    continuing {
                                        phi_2672_ = _e2835;
                                        phi_2675_ = _e2837;
                                        break if !(_e2839);
                                    }
                                }
                                let _e2842 = local_11;
                                if _e2842 {
                                    let _e2844 = local.group_mask;
                                    if ((_e2844 & 4278190080u) == 0u) {
                                        let _e2848 = local.len;
                                        if (_e2848 == 0u) {
                                            phi_3315_ = false;
                                        } else {
                                            let _e2852 = local.len;
                                            local.len = (_e2852 - 1u);
                                            let _e2855 = local.len;
                                            if (_e2855 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2860 = local.first[(0u + _e2855)];
                                            local.group = _e2860;
                                            let _e2863 = local.len;
                                            if (_e2863 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2868 = local.mask[(0u + _e2863)];
                                            local.group_mask = _e2868;
                                            phi_3315_ = true;
                                        }
                                        let _e2871 = phi_3315_;
                                        phi_3316_ = _e2871;
                                    } else {
                                        phi_3316_ = true;
                                    }
                                    let _e2873 = phi_3316_;
                                    if _e2873 {
                                        let _e2875 = local.group_mask;
                                        let _e2881 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2875)), 32u, (_e2875 == 0u)));
                                        let _e2885 = local.group_mask;
                                        let _e2899 = local.group_mask;
                                        local.group_mask = (_e2899 & ~((1u << bitcast<u32>((_e2881 & 31u)))));
                                        let _e2902 = local.group;
                                        phi_3347_ = (_e2902 + countOneBits(((_e2885 & ~((4294967295u << bitcast<u32>((((_e2881 - 24u) ^ _e1777) & 31u))))) & 255u)));
                                    } else {
                                        phi_3347_ = 4294967295u;
                                    }
                                    let _e2905 = phi_3347_;
                                    phi_3348_ = _e2905;
                                } else {
                                    phi_3348_ = u32();
                                }
                                let _e2907 = phi_3348_;
                                phi_2341_ = _e2907;
                                let _e3354 = local_21;
                                phi_2344_ = _e3354;
                                let _e3357 = local_22;
                                phi_3349_ = _e3357;
                                phi_3350_ = false;
                            } else {
                                phi_2341_ = u32();
                                phi_2344_ = bool();
                                phi_3349_ = false;
                                phi_3350_ = true;
                            }
                            let _e2909 = phi_2341_;
                            let _e2911 = phi_2344_;
                            let _e2913 = phi_3349_;
                            let _e2915 = phi_3350_;
                            local_12 = _e2915;
                            continue;
                            continuing {
                                phi_2340_ = _e2909;
                                phi_2343_ = _e2911;
                                break if !(_e2913);
                            }
                        }
                        let _e2918 = local_12;
                        if _e2918 {
                            phi_3354_ = false;
                        } else {
                            phi_3354_ = true;
                        }
                        let _e2920 = phi_3354_;
                        if _e2920 {
                            phi_3358_ = true;
                        } else {
                            let _e3363 = local_23;
                            phi_3358_ = _e3363;
                        }
                        let _e2922 = phi_3358_;
                        phi_3359_ = _e2922;
                    }
                    let _e2924 = phi_3359_;
                    phi_3360_ = _e2924;
                    phi_3361_ = _e1599;
                } else {
                    phi_3360_ = bool();
                    phi_3361_ = true;
                }
                let _e2926 = phi_3360_;
                let _e2928 = phi_3361_;
                if _e2928 {
                    phi_3365_ = false;
                } else {
                    phi_3365_ = _e2926;
                }
                let _e2930 = phi_3365_;
                phi_3366_ = _e2930;
            }
            let _e2932 = phi_3366_;
            phi_3367_ = _e2932;
        } else {
            phi_3367_ = false;
        }
        let _e2934 = phi_3367_;
        if _e2934 {
            phi_3371_ = 0f;
        } else {
            phi_3371_ = 1f;
        }
        let _e2936 = phi_3371_;
        if (_e98 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e98)] = _e2936;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
