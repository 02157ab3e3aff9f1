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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_36 {
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

struct type_40 {
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

struct type_49 {
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

struct type_52 {
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
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> rows: type_49;
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
    var phi_584_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_652_: f32;
    var phi_659_: f32;
    var phi_666_: f32;
    var phi_673_: f32;
    var phi_680_: f32;
    var phi_687_: f32;
    var phi_704_: f32;
    var phi_709_: f32;
    var phi_714_: f32;
    var phi_719_: f32;
    var phi_724_: f32;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_755_: u32;
    var phi_756_: u32;
    var phi_767_: vec3<f32>;
    var phi_768_: vec3<f32>;
    var phi_780_: u32;
    var phi_783_: u32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_867_: u32;
    var phi_890_: f32;
    var phi_891_: f32;
    var phi_905_: u32;
    var phi_928_: f32;
    var phi_929_: f32;
    var phi_943_: u32;
    var phi_1070_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_1117_: u32;
    var phi_1146_: vec3<f32>;
    var phi_1147_: vec3<f32>;
    var phi_1176_: vec3<f32>;
    var phi_1177_: vec3<f32>;
    var phi_1206_: vec3<f32>;
    var phi_1207_: vec3<f32>;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1230_: f32;
    var phi_1231_: f32;
    var phi_1232_: f32;
    var phi_1233_: f32;
    var phi_1241_: f32;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1256_: f32;
    var phi_1257_: f32;
    var phi_1258_: f32;
    var phi_1259_: f32;
    var phi_1267_: f32;
    var phi_1277_: bool;
    var phi_1278_: bool;
    var phi_1282_: f32;
    var phi_1283_: f32;
    var phi_1284_: f32;
    var phi_1285_: f32;
    var phi_1293_: f32;
    var phi_1308_: f32;
    var phi_1309_: bool;
    var phi_1310_: f32;
    var phi_1311_: bool;
    var phi_1312_: f32;
    var phi_1313_: bool;
    var phi_1331_: f32;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1334_: f32;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1340_: bool;
    var phi_1341_: f32;
    var phi_1342_: bool;
    var phi_1370_: vec3<f32>;
    var phi_1371_: vec3<f32>;
    var phi_1396_: vec3<f32>;
    var phi_1397_: vec3<f32>;
    var phi_1422_: vec3<f32>;
    var phi_1423_: vec3<f32>;
    var phi_1479_: f32;
    var phi_1488_: f32;
    var phi_1497_: f32;
    var phi_1506_: f32;
    var phi_1513_: f32;
    var phi_1520_: f32;
    var phi_1533_: f32;
    var phi_1542_: f32;
    var phi_1551_: f32;
    var phi_1560_: f32;
    var phi_1567_: f32;
    var phi_1574_: f32;
    var phi_1591_: f32;
    var phi_1596_: f32;
    var phi_1601_: f32;
    var phi_1609_: f32;
    var phi_1614_: f32;
    var phi_1619_: f32;
    var phi_1631_: f32;
    var phi_1636_: f32;
    var phi_1641_: f32;
    var phi_1646_: f32;
    var phi_1651_: lt_bvh_triangle_Intersection;
    var phi_1652_: bool;
    var phi_1653_: lt_bvh_triangle_Intersection;
    var phi_1654_: bool;
    var phi_1658_: lt_bvh_triangle_Intersection;
    var phi_1659_: bool;
    var phi_1660_: lt_bvh_triangle_Intersection;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1666_: bool;
    var phi_1670_: lt_bvh_triangle_Intersection;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1714_: bool;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1071_: u32;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var local_2: bool;
    var phi_1726_: bool;
    var phi_1727_: bool;
    var phi_1748_: u32;
    var phi_1749_: u32;
    var phi_1753_: u32;
    var phi_1754_: u32;
    var phi_1755_: u32;
    var phi_1756_: u32;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1780_: u32;
    var phi_1781_: u32;
    var phi_1782_: u32;
    var phi_1783_: u32;
    var phi_1784_: u32;
    var phi_1785_: u32;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_781_: u32;
    var phi_784_: u32;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var local_3: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1799_: bool;
    var phi_1803_: bool;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1812_: bool;
    var phi_1828_: bool;
    var phi_1829_: bool;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1835_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1855_: bool;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1870_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var phi_1878_: bool;
    var phi_1882_: bool;
    var phi_1952_: f32;
    var phi_1959_: f32;
    var phi_1966_: f32;
    var phi_1973_: f32;
    var phi_1980_: f32;
    var phi_1987_: f32;
    var phi_2004_: f32;
    var phi_2009_: f32;
    var phi_2014_: f32;
    var phi_2019_: f32;
    var phi_2024_: f32;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2059_: u32;
    var phi_2060_: u32;
    var phi_2071_: vec3<f32>;
    var phi_2072_: vec3<f32>;
    var phi_2085_: u32;
    var phi_2090_: u32;
    var phi_2095_: u32;
    var phi_2209_: bool;
    var phi_2210_: bool;
    var phi_2241_: u32;
    var phi_2243_: u32;
    var phi_2246_: bool;
    var phi_2326_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2353_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2380_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2386_: u32;
    var phi_2389_: u32;
    var phi_2403_: u32;
    var phi_2413_: u32;
    var phi_2423_: u32;
    var phi_2441_: u32;
    var phi_2451_: u32;
    var phi_2461_: u32;
    var phi_2497_: u32;
    var phi_2510_: u32;
    var phi_2515_: u32;
    var phi_2516_: u32;
    var phi_2517_: u32;
    var phi_2387_: u32;
    var phi_2390_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_2575_: u32;
    var phi_2578_: bool;
    var phi_2622_: vec3<f32>;
    var phi_2623_: vec3<f32>;
    var phi_2652_: vec3<f32>;
    var phi_2653_: vec3<f32>;
    var phi_2682_: vec3<f32>;
    var phi_2683_: vec3<f32>;
    var phi_2701_: bool;
    var phi_2702_: bool;
    var phi_2706_: f32;
    var phi_2707_: f32;
    var phi_2708_: f32;
    var phi_2709_: f32;
    var phi_2717_: f32;
    var phi_2727_: bool;
    var phi_2728_: bool;
    var phi_2732_: f32;
    var phi_2733_: f32;
    var phi_2734_: f32;
    var phi_2735_: f32;
    var phi_2743_: f32;
    var phi_2753_: bool;
    var phi_2754_: bool;
    var phi_2758_: f32;
    var phi_2759_: f32;
    var phi_2760_: f32;
    var phi_2761_: f32;
    var phi_2769_: f32;
    var phi_2784_: f32;
    var phi_2785_: bool;
    var phi_2786_: f32;
    var phi_2787_: bool;
    var phi_2788_: f32;
    var phi_2789_: bool;
    var phi_2807_: f32;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2810_: f32;
    var phi_2811_: bool;
    var phi_2812_: bool;
    var phi_2816_: bool;
    var phi_2817_: f32;
    var phi_2818_: bool;
    var phi_2846_: vec3<f32>;
    var phi_2847_: vec3<f32>;
    var phi_2872_: vec3<f32>;
    var phi_2873_: vec3<f32>;
    var phi_2898_: vec3<f32>;
    var phi_2899_: vec3<f32>;
    var phi_2955_: f32;
    var phi_2964_: f32;
    var phi_2973_: f32;
    var phi_2982_: f32;
    var phi_2989_: f32;
    var phi_2996_: f32;
    var phi_3009_: f32;
    var phi_3018_: f32;
    var phi_3027_: f32;
    var phi_3036_: f32;
    var phi_3043_: f32;
    var phi_3050_: f32;
    var phi_3067_: f32;
    var phi_3072_: f32;
    var phi_3077_: f32;
    var phi_3085_: f32;
    var phi_3090_: f32;
    var phi_3095_: f32;
    var phi_3107_: f32;
    var phi_3112_: f32;
    var phi_3117_: f32;
    var phi_3122_: f32;
    var phi_3127_: lt_bvh_triangle_Intersection;
    var phi_3128_: bool;
    var phi_3129_: lt_bvh_triangle_Intersection;
    var phi_3130_: bool;
    var phi_3134_: lt_bvh_triangle_Intersection;
    var phi_3135_: bool;
    var phi_3136_: lt_bvh_triangle_Intersection;
    var phi_3137_: bool;
    var phi_3138_: bool;
    var phi_3142_: bool;
    var phi_3146_: lt_bvh_triangle_Intersection;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_2576_: u32;
    var phi_2579_: bool;
    var phi_3176_: bool;
    var local_7: bool;
    var phi_3218_: bool;
    var phi_3219_: bool;
    var phi_3250_: u32;
    var phi_3251_: u32;
    var phi_2244_: u32;
    var phi_2247_: bool;
    var phi_3252_: bool;
    var phi_3253_: bool;
    var local_8: bool;
    var phi_3257_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_3274_: f32;
    var phi_3315_: u32;
    var phi_3334_: u32;
    var phi_3342_: u32;
    var phi_3350_: u32;
    var phi_3355_: u32;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

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
                    phi_584_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e322.x / _e322.z), (_e322.y / _e322.z), (_e289 / _e322.z)), _e314);
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
                    let _e353 = (_e341.z - _e106.middle.z);
                    phi_584_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e341.x - _e106.middle.x) - (_e106.shear.x * _e353)), ((_e341.y - _e106.middle.y) - (_e106.shear.y * _e353)), (_e106.sign * _e353)), _e106.roots.x);
                }
                let _e366 = phi_584_;
                if (_e366.unnamed_1 == 4294967295u) {
                    phi_1807_ = false;
                    phi_1808_ = true;
                } else {
                    if (0u < _e76) {
                    } else {
                        return;
                    }
                    let _e374 = nodes.member[0u].frame[0u];
                    let _e378 = nodes.member[0u].frame[1u];
                    let _e382 = nodes.member[0u].frame[2u];
                    let _e386 = nodes.member[0u].frame[0u];
                    let _e390 = nodes.member[0u].frame[1u];
                    let _e394 = nodes.member[0u].frame[2u];
                    let _e398 = nodes.member[0u].frame[3u];
                    let _e432 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146), abs(_e147));
                    let _e433 = core_intrinsics_maximum_number_nsz_f32_(_e432, abs(_e148));
                    let _e434 = (_e433 * 0.0000000000009094947f);
                    if (abs(_e146) < _e434) {
                        phi_652_ = _e434;
                    } else {
                        phi_652_ = abs(_e146);
                    }
                    let _e439 = phi_652_;
                    if (_e146 < 0f) {
                        phi_659_ = (-1f / _e439);
                    } else {
                        phi_659_ = (1f / _e439);
                    }
                    let _e444 = phi_659_;
                    if (abs(_e147) < _e434) {
                        phi_666_ = _e434;
                    } else {
                        phi_666_ = abs(_e147);
                    }
                    let _e449 = phi_666_;
                    if (_e147 < 0f) {
                        phi_673_ = (-1f / _e449);
                    } else {
                        phi_673_ = (1f / _e449);
                    }
                    let _e454 = phi_673_;
                    if (abs(_e148) < _e434) {
                        phi_680_ = _e434;
                    } else {
                        phi_680_ = abs(_e148);
                    }
                    let _e459 = phi_680_;
                    if (_e148 < 0f) {
                        phi_687_ = (-1f / _e459);
                    } else {
                        phi_687_ = (1f / _e459);
                    }
                    let _e464 = phi_687_;
                    let _e468 = abs((bitcast<f32>(_e374) - _e126));
                    let _e469 = abs((bitcast<f32>(_e378) - _e128));
                    let _e470 = abs((bitcast<f32>(_e382) - _e130));
                    let _e474 = abs(((bitcast<f32>(_e386) + (bitcast<f32>((((_e398 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                    let _e475 = abs(((bitcast<f32>(_e390) + (bitcast<f32>((((_e398 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                    let _e476 = abs(((bitcast<f32>(_e394) + (bitcast<f32>((((_e398 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                    if (_e468 > _e474) {
                        phi_704_ = _e468;
                    } else {
                        phi_704_ = _e474;
                    }
                    let _e479 = phi_704_;
                    if (_e469 > _e475) {
                        phi_709_ = _e469;
                    } else {
                        phi_709_ = _e475;
                    }
                    let _e482 = phi_709_;
                    if (_e470 > _e476) {
                        phi_714_ = _e470;
                    } else {
                        phi_714_ = _e476;
                    }
                    let _e485 = phi_714_;
                    if (_e479 > _e482) {
                        phi_719_ = _e479;
                    } else {
                        phi_719_ = _e482;
                    }
                    let _e488 = phi_719_;
                    if (_e488 > _e485) {
                        phi_724_ = _e488;
                    } else {
                        phi_724_ = _e485;
                    }
                    let _e491 = phi_724_;
                    let _e498 = (_e491 * 0.0000009536743f);
                    let _e499 = (abs(_e444) * _e498);
                    let _e500 = (abs(_e454) * _e498);
                    let _e501 = (abs(_e464) * _e498);
                    let _e502 = abs(_e146);
                    let _e503 = abs(_e147);
                    let _e504 = abs(_e148);
                    if (_e502 >= _e503) {
                        if (_e502 >= _e504) {
                            phi_746_ = false;
                        } else {
                            phi_746_ = true;
                        }
                        let _e508 = phi_746_;
                        phi_747_ = _e508;
                    } else {
                        phi_747_ = true;
                    }
                    let _e510 = phi_747_;
                    if _e510 {
                        if (_e503 >= _e504) {
                            phi_755_ = 1u;
                        } else {
                            phi_755_ = 2u;
                        }
                        let _e513 = phi_755_;
                        phi_756_ = _e513;
                    } else {
                        phi_756_ = 0u;
                    }
                    let _e515 = phi_756_;
                    if (_e515 == 0u) {
                        phi_768_ = vec3<f32>(_e147, _e148, _e146);
                    } else {
                        if (_e515 == 1u) {
                            phi_767_ = vec3<f32>(_e148, _e146, _e147);
                        } else {
                            phi_767_ = _e149;
                        }
                        let _e521 = phi_767_;
                        phi_768_ = _e521;
                    }
                    let _e523 = phi_768_;
                    let _e526 = (_e523.x / _e523.z);
                    let _e529 = (_e523.y / _e523.z);
                    local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_780_ = ((_e366.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_783_ = 0u;
                    loop {
                        let _e536 = phi_780_;
                        let _e538 = phi_783_;
                        let _e539 = (_e536 == 0u);
                        local_3 = _e539;
                        if _e539 {
                            phi_781_ = u32();
                            phi_784_ = u32();
                            phi_1788_ = false;
                            phi_1789_ = false;
                            phi_1790_ = false;
                        } else {
                            let _e547 = (_e536 & (_e536 - 1u));
                            let _e548 = (((_e536 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e536), 32u, (_e536 == 0u))) * 4u);
                            if (_e548 < _e91) {
                            } else {
                                return;
                            }
                            let _e552 = rows.member[(0u + _e548)];
                            let _e553 = (_e548 + 1u);
                            if (_e553 < _e91) {
                            } else {
                                return;
                            }
                            let _e557 = rows.member[(0u + _e553)];
                            let _e558 = (_e548 + 2u);
                            if (_e558 < _e91) {
                            } else {
                                return;
                            }
                            let _e562 = rows.member[(0u + _e558)];
                            let _e563 = (_e548 + 3u);
                            if (_e563 < _e91) {
                            } else {
                                return;
                            }
                            let _e567 = rows.member[(0u + _e563)];
                            let _e568 = lt_bvh_LightNode(_e552, _e557, _e562, _e567);
                            let _e580 = (_e366.unnamed.positive_exponent - bitcast<f32>(_e568.frame.x));
                            let _e583 = bitcast<f32>((((_e568.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e580 > 0f) {
                                if (_e580 < (255f * _e583)) {
                                    phi_852_ = (_e580 / _e583);
                                } else {
                                    phi_852_ = 255f;
                                }
                                let _e589 = phi_852_;
                                phi_853_ = _e589;
                            } else {
                                phi_853_ = 0f;
                            }
                            let _e591 = phi_853_;
                            let _e598 = select(select(u32(_e591), 0u, (_e591 < bitcast<f32>(0u))), 4294967295u, (_e591 > bitcast<f32>(1333788671u)));
                            if (f32(_e598) < _e591) {
                                phi_867_ = (_e598 + 1u);
                            } else {
                                phi_867_ = _e598;
                            }
                            let _e603 = phi_867_;
                            let _e604 = (_e598 * 16843009u);
                            let _e605 = (_e603 * 16843009u);
                            let _e615 = (_e366.unnamed.negative_exponent - bitcast<f32>(_e568.frame.y));
                            let _e618 = bitcast<f32>((((_e568.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e615 > 0f) {
                                if (_e615 < (255f * _e618)) {
                                    phi_890_ = (_e615 / _e618);
                                } else {
                                    phi_890_ = 255f;
                                }
                                let _e624 = phi_890_;
                                phi_891_ = _e624;
                            } else {
                                phi_891_ = 0f;
                            }
                            let _e626 = phi_891_;
                            let _e633 = select(select(u32(_e626), 0u, (_e626 < bitcast<f32>(0u))), 4294967295u, (_e626 > bitcast<f32>(1333788671u)));
                            if (f32(_e633) < _e626) {
                                phi_905_ = (_e633 + 1u);
                            } else {
                                phi_905_ = _e633;
                            }
                            let _e638 = phi_905_;
                            let _e639 = (_e633 * 16843009u);
                            let _e640 = (_e638 * 16843009u);
                            let _e650 = (_e366.unnamed.min_variance - bitcast<f32>(_e568.frame.z));
                            let _e653 = bitcast<f32>((((_e568.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e650 > 0f) {
                                if (_e650 < (255f * _e653)) {
                                    phi_928_ = (_e650 / _e653);
                                } else {
                                    phi_928_ = 255f;
                                }
                                let _e659 = phi_928_;
                                phi_929_ = _e659;
                            } else {
                                phi_929_ = 0f;
                            }
                            let _e661 = phi_929_;
                            let _e668 = select(select(u32(_e661), 0u, (_e661 < bitcast<f32>(0u))), 4294967295u, (_e661 > bitcast<f32>(1333788671u)));
                            if (f32(_e668) < _e661) {
                                phi_943_ = (_e668 + 1u);
                            } else {
                                phi_943_ = _e668;
                            }
                            let _e673 = phi_943_;
                            let _e674 = (_e673 * 16843009u);
                            let _e807 = (((((((((((_e604 & ~(_e568.x.x)) | (~((_e568.x.x ^ _e604)) & ((_e604 | 2155905152u) - (_e568.x.x & 2139062143u)))) & ((_e568.x.z & ~(_e605)) | (~((_e605 ^ _e568.x.z)) & ((_e568.x.z | 2155905152u) - (_e605 & 2139062143u))))) & ((_e639 & ~(_e568.y.x)) | (~((_e568.y.x ^ _e639)) & ((_e639 | 2155905152u) - (_e568.y.x & 2139062143u))))) & ((_e568.y.z & ~(_e640)) | (~((_e640 ^ _e568.y.z)) & ((_e568.y.z | 2155905152u) - (_e640 & 2139062143u))))) & ((_e568.rest.x & ~(_e674)) | (~((_e674 ^ _e568.rest.x)) & ((_e568.rest.x | 2155905152u) - (_e674 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e604 & ~(_e568.x.y)) | (~((_e568.x.y ^ _e604)) & ((_e604 | 2155905152u) - (_e568.x.y & 2139062143u)))) & ((_e568.x.w & ~(_e605)) | (~((_e605 ^ _e568.x.w)) & ((_e568.x.w | 2155905152u) - (_e605 & 2139062143u))))) & ((_e639 & ~(_e568.y.y)) | (~((_e568.y.y ^ _e639)) & ((_e639 | 2155905152u) - (_e568.y.y & 2139062143u))))) & ((_e568.y.w & ~(_e640)) | (~((_e640 ^ _e568.y.w)) & ((_e568.y.w | 2155905152u) - (_e640 & 2139062143u))))) & ((_e568.rest.y & ~(_e674)) | (~((_e674 ^ _e568.rest.y)) & ((_e568.rest.y | 2155905152u) - (_e674 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e568.frame.w & 16777216u) != 0u) {
                                phi_1070_ = _e807;
                                loop {
                                    let _e813 = phi_1070_;
                                    let _e814 = (_e813 == 0u);
                                    local_2 = _e814;
                                    local_11 = _e814;
                                    if _e814 {
                                        phi_1071_ = u32();
                                        phi_1720_ = false;
                                        phi_1721_ = false;
                                        phi_1722_ = false;
                                    } else {
                                        let _e817 = select(firstTrailingBit(_e813), 32u, (_e813 == 0u));
                                        let _e822 = (_e568.rest.z + (_e817 >> bitcast<u32>(2i)));
                                        if (_e822 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e827 = rows.member[(0u + _e822)][0u];
                                        let _e831 = rows.member[(0u + _e822)][1u];
                                        let _e835 = rows.member[(0u + _e822)][2u];
                                        let _e839 = rows.member[(0u + _e822)][3u];
                                        if ((_e817 & 2u) == 0u) {
                                            phi_1110_ = _e831;
                                            phi_1111_ = _e827;
                                        } else {
                                            phi_1110_ = _e839;
                                            phi_1111_ = _e835;
                                        }
                                        let _e843 = phi_1110_;
                                        let _e845 = phi_1111_;
                                        if ((_e817 & 1u) == 0u) {
                                            phi_1117_ = _e845;
                                        } else {
                                            phi_1117_ = _e843;
                                        }
                                        let _e849 = phi_1117_;
                                        if (_e849 < _e79) {
                                        } else {
                                            return;
                                        }
                                        let _e856 = triangles.member[(0u + _e849)].v0_;
                                        let _e858 = (_e856.x - _e126);
                                        let _e860 = (_e856.y - _e128);
                                        let _e862 = (_e856.z - _e130);
                                        if (_e515 == 0u) {
                                            phi_1147_ = vec3<f32>(_e860, _e862, _e858);
                                        } else {
                                            if (_e515 == 1u) {
                                                phi_1146_ = vec3<f32>(_e862, _e858, _e860);
                                            } else {
                                                phi_1146_ = (_e856 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e870 = phi_1146_;
                                            phi_1147_ = _e870;
                                        }
                                        let _e872 = phi_1147_;
                                        let _e876 = (_e872.x - (_e526 * _e872.z));
                                        let _e880 = (_e872.y - (_e529 * _e872.z));
                                        let _e882 = triangles.member[(0u + _e849)].v1_;
                                        let _e884 = (_e882.x - _e126);
                                        let _e886 = (_e882.y - _e128);
                                        let _e888 = (_e882.z - _e130);
                                        if (_e515 == 0u) {
                                            phi_1177_ = vec3<f32>(_e886, _e888, _e884);
                                        } else {
                                            if (_e515 == 1u) {
                                                phi_1176_ = vec3<f32>(_e888, _e884, _e886);
                                            } else {
                                                phi_1176_ = (_e882 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e896 = phi_1176_;
                                            phi_1177_ = _e896;
                                        }
                                        let _e898 = phi_1177_;
                                        let _e902 = (_e898.x - (_e526 * _e898.z));
                                        let _e906 = (_e898.y - (_e529 * _e898.z));
                                        let _e908 = triangles.member[(0u + _e849)].v2_;
                                        let _e910 = (_e908.x - _e126);
                                        let _e912 = (_e908.y - _e128);
                                        let _e914 = (_e908.z - _e130);
                                        if (_e515 == 0u) {
                                            phi_1207_ = vec3<f32>(_e912, _e914, _e910);
                                        } else {
                                            if (_e515 == 1u) {
                                                phi_1206_ = vec3<f32>(_e914, _e910, _e912);
                                            } else {
                                                phi_1206_ = (_e908 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e922 = phi_1206_;
                                            phi_1207_ = _e922;
                                        }
                                        let _e924 = phi_1207_;
                                        let _e928 = (_e924.x - (_e526 * _e924.z));
                                        let _e932 = (_e924.y - (_e529 * _e924.z));
                                        if (_e902 < _e928) {
                                            phi_1226_ = true;
                                        } else {
                                            if (_e902 == _e928) {
                                                phi_1225_ = (_e906 < _e932);
                                            } else {
                                                phi_1225_ = false;
                                            }
                                            let _e937 = phi_1225_;
                                            phi_1226_ = _e937;
                                        }
                                        let _e939 = phi_1226_;
                                        if _e939 {
                                            phi_1230_ = _e932;
                                            phi_1231_ = _e928;
                                            phi_1232_ = _e906;
                                            phi_1233_ = _e902;
                                        } else {
                                            phi_1230_ = _e906;
                                            phi_1231_ = _e902;
                                            phi_1232_ = _e932;
                                            phi_1233_ = _e928;
                                        }
                                        let _e941 = phi_1230_;
                                        let _e943 = phi_1231_;
                                        let _e945 = phi_1232_;
                                        let _e947 = phi_1233_;
                                        let _e950 = ((_e947 * _e941) - (_e945 * _e943));
                                        if _e939 {
                                            phi_1241_ = -(_e950);
                                        } else {
                                            phi_1241_ = _e950;
                                        }
                                        let _e953 = phi_1241_;
                                        if (_e928 < _e876) {
                                            phi_1252_ = true;
                                        } else {
                                            if (_e928 == _e876) {
                                                phi_1251_ = (_e932 < _e880);
                                            } else {
                                                phi_1251_ = false;
                                            }
                                            let _e958 = phi_1251_;
                                            phi_1252_ = _e958;
                                        }
                                        let _e960 = phi_1252_;
                                        if _e960 {
                                            phi_1256_ = _e880;
                                            phi_1257_ = _e876;
                                            phi_1258_ = _e932;
                                            phi_1259_ = _e928;
                                        } else {
                                            phi_1256_ = _e932;
                                            phi_1257_ = _e928;
                                            phi_1258_ = _e880;
                                            phi_1259_ = _e876;
                                        }
                                        let _e962 = phi_1256_;
                                        let _e964 = phi_1257_;
                                        let _e966 = phi_1258_;
                                        let _e968 = phi_1259_;
                                        let _e971 = ((_e968 * _e962) - (_e966 * _e964));
                                        if _e960 {
                                            phi_1267_ = -(_e971);
                                        } else {
                                            phi_1267_ = _e971;
                                        }
                                        let _e974 = phi_1267_;
                                        if (_e876 < _e902) {
                                            phi_1278_ = true;
                                        } else {
                                            if (_e876 == _e902) {
                                                phi_1277_ = (_e880 < _e906);
                                            } else {
                                                phi_1277_ = false;
                                            }
                                            let _e979 = phi_1277_;
                                            phi_1278_ = _e979;
                                        }
                                        let _e981 = phi_1278_;
                                        if _e981 {
                                            phi_1282_ = _e906;
                                            phi_1283_ = _e902;
                                            phi_1284_ = _e880;
                                            phi_1285_ = _e876;
                                        } else {
                                            phi_1282_ = _e880;
                                            phi_1283_ = _e876;
                                            phi_1284_ = _e906;
                                            phi_1285_ = _e902;
                                        }
                                        let _e983 = phi_1282_;
                                        let _e985 = phi_1283_;
                                        let _e987 = phi_1284_;
                                        let _e989 = phi_1285_;
                                        let _e992 = ((_e989 * _e983) - (_e987 * _e985));
                                        if _e981 {
                                            phi_1293_ = -(_e992);
                                        } else {
                                            phi_1293_ = _e992;
                                        }
                                        let _e995 = phi_1293_;
                                        if (_e953 >= 0f) {
                                            if (_e974 >= 0f) {
                                                if (_e995 >= 0f) {
                                                    phi_1308_ = ((_e953 + _e974) + _e995);
                                                    phi_1309_ = false;
                                                } else {
                                                    phi_1308_ = f32();
                                                    phi_1309_ = true;
                                                }
                                                let _e1002 = phi_1308_;
                                                let _e1004 = phi_1309_;
                                                phi_1310_ = _e1002;
                                                phi_1311_ = _e1004;
                                            } else {
                                                phi_1310_ = f32();
                                                phi_1311_ = true;
                                            }
                                            let _e1006 = phi_1310_;
                                            let _e1008 = phi_1311_;
                                            phi_1312_ = _e1006;
                                            phi_1313_ = _e1008;
                                        } else {
                                            phi_1312_ = f32();
                                            phi_1313_ = true;
                                        }
                                        let _e1010 = phi_1312_;
                                        let _e1012 = phi_1313_;
                                        if _e1012 {
                                            if (_e953 <= 0f) {
                                                if (_e974 <= 0f) {
                                                    let _e1015 = (_e995 <= 0f);
                                                    if _e1015 {
                                                    }
                                                    phi_1331_ = ((_e953 + _e974) + _e995);
                                                    phi_1332_ = false;
                                                    phi_1333_ = _e1015;
                                                } else {
                                                    phi_1331_ = f32();
                                                    phi_1332_ = true;
                                                    phi_1333_ = false;
                                                }
                                                let _e1019 = phi_1331_;
                                                let _e1021 = phi_1332_;
                                                let _e1023 = phi_1333_;
                                                phi_1334_ = _e1019;
                                                phi_1335_ = _e1021;
                                                phi_1336_ = _e1023;
                                            } else {
                                                phi_1334_ = f32();
                                                phi_1335_ = true;
                                                phi_1336_ = false;
                                            }
                                            let _e1025 = phi_1334_;
                                            let _e1027 = phi_1335_;
                                            let _e1029 = phi_1336_;
                                            if _e1027 {
                                                phi_1340_ = false;
                                            } else {
                                                phi_1340_ = _e1029;
                                            }
                                            let _e1031 = phi_1340_;
                                            phi_1341_ = _e1025;
                                            phi_1342_ = _e1031;
                                        } else {
                                            phi_1341_ = _e1010;
                                            phi_1342_ = true;
                                        }
                                        let _e1033 = phi_1341_;
                                        let _e1035 = phi_1342_;
                                        if _e1035 {
                                            let _e1036 = (_e1033 == 0f);
                                            if _e1036 {
                                                phi_1658_ = lt_bvh_triangle_Intersection();
                                                phi_1659_ = false;
                                            } else {
                                                let _e1038 = triangles.member[(0u + _e849)].v0_;
                                                let _e1040 = (_e1038.x - _e126);
                                                let _e1042 = (_e1038.y - _e128);
                                                let _e1044 = (_e1038.z - _e130);
                                                if (_e515 == 0u) {
                                                    phi_1371_ = vec3<f32>(_e1042, _e1044, _e1040);
                                                } else {
                                                    if (_e515 == 1u) {
                                                        phi_1370_ = vec3<f32>(_e1044, _e1040, _e1042);
                                                    } else {
                                                        phi_1370_ = (_e1038 - vec3<f32>(_e126, _e128, _e130));
                                                    }
                                                    let _e1052 = phi_1370_;
                                                    phi_1371_ = _e1052;
                                                }
                                                let _e1054 = phi_1371_;
                                                let _e1056 = triangles.member[(0u + _e849)].v1_;
                                                let _e1058 = triangles.member[(0u + _e849)].v0_;
                                                let _e1061 = (_e1056.x - _e1058.x);
                                                let _e1064 = (_e1056.y - _e1058.y);
                                                let _e1067 = (_e1056.z - _e1058.z);
                                                if (_e515 == 0u) {
                                                    phi_1397_ = vec3<f32>(_e1064, _e1067, _e1061);
                                                } else {
                                                    if (_e515 == 1u) {
                                                        phi_1396_ = vec3<f32>(_e1067, _e1061, _e1064);
                                                    } else {
                                                        phi_1396_ = (_e1056 - _e1058);
                                                    }
                                                    let _e1074 = phi_1396_;
                                                    phi_1397_ = _e1074;
                                                }
                                                let _e1076 = phi_1397_;
                                                let _e1078 = triangles.member[(0u + _e849)].v2_;
                                                let _e1080 = triangles.member[(0u + _e849)].v0_;
                                                let _e1083 = (_e1078.x - _e1080.x);
                                                let _e1086 = (_e1078.y - _e1080.y);
                                                let _e1089 = (_e1078.z - _e1080.z);
                                                if (_e515 == 0u) {
                                                    phi_1423_ = vec3<f32>(_e1086, _e1089, _e1083);
                                                } else {
                                                    if (_e515 == 1u) {
                                                        phi_1422_ = vec3<f32>(_e1089, _e1083, _e1086);
                                                    } else {
                                                        phi_1422_ = (_e1078 - _e1080);
                                                    }
                                                    let _e1096 = phi_1422_;
                                                    phi_1423_ = _e1096;
                                                }
                                                let _e1098 = phi_1423_;
                                                let _e1105 = ((_e1076.y * _e1098.z) - (_e1076.z * _e1098.y));
                                                let _e1112 = ((_e1076.z * _e1098.x) - (_e1076.x * _e1098.z));
                                                let _e1119 = ((_e1076.x * _e1098.y) - (_e1076.y * _e1098.x));
                                                let _e1133 = (((1f / _e523.z) * (((_e1105 * _e1054.x) + (_e1112 * _e1054.y)) + (_e1119 * _e1054.z))) / (((_e1105 * _e526) + (_e1112 * _e529)) + _e1119));
                                                if (_e1133 > 0f) {
                                                    if (_e1133 < _e138) {
                                                        let _e1137 = triangles.member[(0u + _e849)].v0_;
                                                        let _e1139 = triangles.member[(0u + _e849)].v1_;
                                                        if (_e1137.x < _e1139.x) {
                                                            phi_1479_ = _e1137.x;
                                                        } else {
                                                            phi_1479_ = _e1139.x;
                                                        }
                                                        let _e1146 = phi_1479_;
                                                        if (_e1137.y < _e1139.y) {
                                                            phi_1488_ = _e1137.y;
                                                        } else {
                                                            phi_1488_ = _e1139.y;
                                                        }
                                                        let _e1153 = phi_1488_;
                                                        if (_e1137.z < _e1139.z) {
                                                            phi_1497_ = _e1137.z;
                                                        } else {
                                                            phi_1497_ = _e1139.z;
                                                        }
                                                        let _e1160 = phi_1497_;
                                                        let _e1162 = triangles.member[(0u + _e849)].v2_;
                                                        if (_e1146 < _e1162.x) {
                                                            phi_1506_ = _e1146;
                                                        } else {
                                                            phi_1506_ = _e1162.x;
                                                        }
                                                        let _e1167 = phi_1506_;
                                                        if (_e1153 < _e1162.y) {
                                                            phi_1513_ = _e1153;
                                                        } else {
                                                            phi_1513_ = _e1162.y;
                                                        }
                                                        let _e1172 = phi_1513_;
                                                        if (_e1160 < _e1162.z) {
                                                            phi_1520_ = _e1160;
                                                        } else {
                                                            phi_1520_ = _e1162.z;
                                                        }
                                                        let _e1177 = phi_1520_;
                                                        let _e1179 = triangles.member[(0u + _e849)].v0_;
                                                        let _e1181 = triangles.member[(0u + _e849)].v1_;
                                                        if (_e1179.x > _e1181.x) {
                                                            phi_1533_ = _e1179.x;
                                                        } else {
                                                            phi_1533_ = _e1181.x;
                                                        }
                                                        let _e1188 = phi_1533_;
                                                        if (_e1179.y > _e1181.y) {
                                                            phi_1542_ = _e1179.y;
                                                        } else {
                                                            phi_1542_ = _e1181.y;
                                                        }
                                                        let _e1195 = phi_1542_;
                                                        if (_e1179.z > _e1181.z) {
                                                            phi_1551_ = _e1179.z;
                                                        } else {
                                                            phi_1551_ = _e1181.z;
                                                        }
                                                        let _e1202 = phi_1551_;
                                                        let _e1204 = triangles.member[(0u + _e849)].v2_;
                                                        if (_e1188 > _e1204.x) {
                                                            phi_1560_ = _e1188;
                                                        } else {
                                                            phi_1560_ = _e1204.x;
                                                        }
                                                        let _e1209 = phi_1560_;
                                                        if (_e1195 > _e1204.y) {
                                                            phi_1567_ = _e1195;
                                                        } else {
                                                            phi_1567_ = _e1204.y;
                                                        }
                                                        let _e1214 = phi_1567_;
                                                        if (_e1202 > _e1204.z) {
                                                            phi_1574_ = _e1202;
                                                        } else {
                                                            phi_1574_ = _e1204.z;
                                                        }
                                                        let _e1219 = phi_1574_;
                                                        let _e1223 = ((_e1167 - _e126) * _e444);
                                                        let _e1224 = ((_e1172 - _e128) * _e454);
                                                        let _e1225 = ((_e1177 - _e130) * _e464);
                                                        let _e1229 = ((_e1209 - _e126) * _e444);
                                                        let _e1230 = ((_e1214 - _e128) * _e454);
                                                        let _e1231 = ((_e1219 - _e130) * _e464);
                                                        if (_e1223 < _e1229) {
                                                            phi_1591_ = _e1223;
                                                        } else {
                                                            phi_1591_ = _e1229;
                                                        }
                                                        let _e1234 = phi_1591_;
                                                        if (_e1224 < _e1230) {
                                                            phi_1596_ = _e1224;
                                                        } else {
                                                            phi_1596_ = _e1230;
                                                        }
                                                        let _e1237 = phi_1596_;
                                                        if (_e1225 < _e1231) {
                                                            phi_1601_ = _e1225;
                                                        } else {
                                                            phi_1601_ = _e1231;
                                                        }
                                                        let _e1240 = phi_1601_;
                                                        if (_e1223 > _e1229) {
                                                            phi_1609_ = _e1223;
                                                        } else {
                                                            phi_1609_ = _e1229;
                                                        }
                                                        let _e1246 = phi_1609_;
                                                        if (_e1224 > _e1230) {
                                                            phi_1614_ = _e1224;
                                                        } else {
                                                            phi_1614_ = _e1230;
                                                        }
                                                        let _e1249 = phi_1614_;
                                                        if (_e1225 > _e1231) {
                                                            phi_1619_ = _e1225;
                                                        } else {
                                                            phi_1619_ = _e1231;
                                                        }
                                                        let _e1252 = phi_1619_;
                                                        let _e1256 = core_intrinsics_maximum_number_nsz_f32_((_e1234 - _e499), (_e1237 - _e500));
                                                        let _e1257 = core_intrinsics_maximum_number_nsz_f32_(_e1256, (_e1240 - _e501));
                                                        let _e1258 = core_intrinsics_minimum_number_nsz_f32_((_e1246 + _e499), (_e1249 + _e500));
                                                        let _e1259 = core_intrinsics_minimum_number_nsz_f32_(_e1258, (_e1252 + _e501));
                                                        if (_e1257 > -300000000000000000000000000000000000000f) {
                                                            phi_1631_ = _e1257;
                                                        } else {
                                                            phi_1631_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1262 = phi_1631_;
                                                        if (_e1259 < 300000000000000000000000000000000000000f) {
                                                            phi_1636_ = _e1259;
                                                        } else {
                                                            phi_1636_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1265 = phi_1636_;
                                                        if (_e1133 < _e1262) {
                                                            phi_1641_ = _e1262;
                                                        } else {
                                                            phi_1641_ = _e1133;
                                                        }
                                                        let _e1268 = phi_1641_;
                                                        if (_e1268 > _e1265) {
                                                            phi_1646_ = _e1265;
                                                        } else {
                                                            phi_1646_ = _e1268;
                                                        }
                                                        let _e1271 = phi_1646_;
                                                        phi_1651_ = lt_bvh_triangle_Intersection(_e1271, (_e974 / _e1033), (_e995 / _e1033), (_e1262 <= _e1265));
                                                        phi_1652_ = false;
                                                    } else {
                                                        phi_1651_ = lt_bvh_triangle_Intersection();
                                                        phi_1652_ = true;
                                                    }
                                                    let _e1277 = phi_1651_;
                                                    let _e1279 = phi_1652_;
                                                    phi_1653_ = _e1277;
                                                    phi_1654_ = _e1279;
                                                } else {
                                                    phi_1653_ = lt_bvh_triangle_Intersection();
                                                    phi_1654_ = true;
                                                }
                                                let _e1281 = phi_1653_;
                                                let _e1283 = phi_1654_;
                                                if _e1283 {
                                                }
                                                phi_1658_ = _e1281;
                                                phi_1659_ = _e1283;
                                            }
                                            let _e1285 = phi_1658_;
                                            let _e1287 = phi_1659_;
                                            phi_1660_ = _e1285;
                                            phi_1661_ = _e1036;
                                            phi_1662_ = _e1287;
                                        } else {
                                            phi_1660_ = lt_bvh_triangle_Intersection();
                                            phi_1661_ = true;
                                            phi_1662_ = false;
                                        }
                                        let _e1289 = phi_1660_;
                                        let _e1291 = phi_1661_;
                                        let _e1293 = phi_1662_;
                                        if _e1291 {
                                            phi_1666_ = true;
                                        } else {
                                            phi_1666_ = _e1293;
                                        }
                                        let _e1295 = phi_1666_;
                                        if _e1295 {
                                            phi_1670_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_1670_ = _e1289;
                                        }
                                        let _e1297 = phi_1670_;
                                        if _e1297.is_hit {
                                            if (_e1297.t > 0f) {
                                                if (_e1297.t < _e138) {
                                                    let _e1304 = triangles.member[(0u + _e849)].i0_;
                                                    let _e1306 = ((_e1304 & 2147483648u) == 0u);
                                                    if _e1306 {
                                                        phi_1696_ = false;
                                                        phi_1697_ = false;
                                                    } else {
                                                        if true {
                                                            phi_1695_ = false;
                                                        } else {
                                                            phi_1695_ = true;
                                                        }
                                                        let _e1308 = phi_1695_;
                                                        phi_1696_ = _e1308;
                                                        phi_1697_ = true;
                                                    }
                                                    let _e1310 = phi_1696_;
                                                    let _e1312 = phi_1697_;
                                                    phi_1698_ = _e1310;
                                                    phi_1699_ = _e1306;
                                                    phi_1700_ = _e1312;
                                                } else {
                                                    phi_1698_ = true;
                                                    phi_1699_ = false;
                                                    phi_1700_ = false;
                                                }
                                                let _e1314 = phi_1698_;
                                                let _e1316 = phi_1699_;
                                                let _e1318 = phi_1700_;
                                                phi_1701_ = false;
                                                phi_1702_ = _e1314;
                                                phi_1703_ = _e1316;
                                                phi_1704_ = _e1318;
                                            } else {
                                                phi_1701_ = true;
                                                phi_1702_ = false;
                                                phi_1703_ = false;
                                                phi_1704_ = false;
                                            }
                                            let _e1320 = phi_1701_;
                                            let _e1322 = phi_1702_;
                                            let _e1324 = phi_1703_;
                                            let _e1326 = phi_1704_;
                                            phi_1705_ = _e1320;
                                            phi_1706_ = _e1322;
                                            phi_1707_ = _e1324;
                                            phi_1708_ = _e1326;
                                        } else {
                                            phi_1705_ = true;
                                            phi_1706_ = false;
                                            phi_1707_ = false;
                                            phi_1708_ = false;
                                        }
                                        let _e1328 = phi_1705_;
                                        let _e1330 = phi_1706_;
                                        let _e1332 = phi_1707_;
                                        let _e1334 = phi_1708_;
                                        if _e1328 {
                                            phi_1712_ = true;
                                            phi_1713_ = false;
                                            phi_1714_ = false;
                                        } else {
                                            phi_1712_ = _e1330;
                                            phi_1713_ = _e1332;
                                            phi_1714_ = _e1334;
                                        }
                                        let _e1336 = phi_1712_;
                                        let _e1338 = phi_1713_;
                                        let _e1340 = phi_1714_;
                                        if _e1336 {
                                            phi_1718_ = false;
                                            phi_1719_ = false;
                                        } else {
                                            phi_1718_ = _e1338;
                                            phi_1719_ = _e1340;
                                        }
                                        let _e1342 = phi_1718_;
                                        let _e1344 = phi_1719_;
                                        phi_1071_ = (_e813 & (_e813 - 1u));
                                        phi_1720_ = _e1336;
                                        phi_1721_ = _e1342;
                                        phi_1722_ = _e1344;
                                    }
                                    let _e1346 = phi_1071_;
                                    let _e1348 = phi_1720_;
                                    let _e1350 = phi_1721_;
                                    let _e1352 = phi_1722_;
                                    local_9 = _e1350;
                                    local_10 = _e1352;
                                    continue;
                                    continuing {
                                        phi_1070_ = _e1346;
                                        break if !(_e1348);
                                    }
                                }
                                let _e1355 = local_2;
                                if _e1355 {
                                    phi_1726_ = false;
                                    phi_1727_ = false;
                                } else {
                                    let _e3121 = local_9;
                                    phi_1726_ = _e3121;
                                    let _e3124 = local_10;
                                    phi_1727_ = _e3124;
                                }
                                let _e1357 = phi_1726_;
                                let _e1359 = phi_1727_;
                                phi_1755_ = _e547;
                                phi_1756_ = _e538;
                                let _e3133 = local_11;
                                phi_1757_ = _e3133;
                                phi_1758_ = _e1357;
                                phi_1759_ = _e1359;
                            } else {
                                if (_e807 == 0u) {
                                    phi_1753_ = _e547;
                                    phi_1754_ = _e538;
                                } else {
                                    if ((_e547 & 255u) == 0u) {
                                        phi_1749_ = _e538;
                                    } else {
                                        if (_e538 < 32u) {
                                            if (_e538 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1[(0u + _e538)] = _e547;
                                            phi_1748_ = (_e538 + 1u);
                                        } else {
                                            phi_1748_ = _e538;
                                        }
                                        let _e1369 = phi_1748_;
                                        phi_1749_ = _e1369;
                                    }
                                    let _e1371 = phi_1749_;
                                    phi_1753_ = ((_e568.rest.z << bitcast<u32>(8i)) | _e807);
                                    phi_1754_ = _e1371;
                                }
                                let _e1378 = phi_1753_;
                                let _e1380 = phi_1754_;
                                phi_1755_ = _e1378;
                                phi_1756_ = _e1380;
                                phi_1757_ = true;
                                phi_1758_ = false;
                                phi_1759_ = false;
                            }
                            let _e1382 = phi_1755_;
                            let _e1384 = phi_1756_;
                            let _e1386 = phi_1757_;
                            let _e1388 = phi_1758_;
                            let _e1390 = phi_1759_;
                            if _e1386 {
                                if ((_e1382 & 255u) == 0u) {
                                    if (_e1384 > 0u) {
                                        let _e1394 = (_e1384 - 1u);
                                        if (_e1394 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1398 = local_1[(0u + _e1394)];
                                        phi_1780_ = _e1398;
                                        phi_1781_ = _e1394;
                                    } else {
                                        phi_1780_ = 0u;
                                        phi_1781_ = _e1384;
                                    }
                                    let _e1400 = phi_1780_;
                                    let _e1402 = phi_1781_;
                                    phi_1782_ = _e1400;
                                    phi_1783_ = _e1402;
                                } else {
                                    phi_1782_ = _e1382;
                                    phi_1783_ = _e1384;
                                }
                                let _e1404 = phi_1782_;
                                let _e1406 = phi_1783_;
                                phi_1784_ = _e1404;
                                phi_1785_ = _e1406;
                                phi_1786_ = false;
                                phi_1787_ = false;
                            } else {
                                phi_1784_ = u32();
                                phi_1785_ = u32();
                                phi_1786_ = _e1388;
                                phi_1787_ = _e1390;
                            }
                            let _e1408 = phi_1784_;
                            let _e1410 = phi_1785_;
                            let _e1412 = phi_1786_;
                            let _e1414 = phi_1787_;
                            phi_781_ = _e1408;
                            phi_784_ = _e1410;
                            phi_1788_ = _e1386;
                            phi_1789_ = _e1412;
                            phi_1790_ = _e1414;
                        }
                        let _e1416 = phi_781_;
                        let _e1418 = phi_784_;
                        let _e1420 = phi_1788_;
                        let _e1422 = phi_1789_;
                        let _e1424 = phi_1790_;
                        local_12 = _e1422;
                        local_13 = _e1424;
                        continue;
                        continuing {
                            phi_780_ = _e1416;
                            phi_783_ = _e1418;
                            break if !(_e1420);
                        }
                    }
                    let _e1427 = local_3;
                    if _e1427 {
                        phi_1794_ = false;
                        phi_1795_ = false;
                    } else {
                        let _e3152 = local_12;
                        phi_1794_ = _e3152;
                        let _e3155 = local_13;
                        phi_1795_ = _e3155;
                    }
                    let _e1429 = phi_1794_;
                    let _e1431 = phi_1795_;
                    if _e1429 {
                        phi_1799_ = false;
                    } else {
                        phi_1799_ = _e1431;
                    }
                    let _e1433 = phi_1799_;
                    if _e1433 {
                        phi_1803_ = true;
                    } else {
                        phi_1803_ = _e1429;
                    }
                    let _e1435 = phi_1803_;
                    if _e1435 {
                    }
                    phi_1807_ = true;
                    phi_1808_ = _e1435;
                }
                let _e1437 = phi_1807_;
                let _e1439 = phi_1808_;
                if _e1439 {
                    phi_1812_ = _e1437;
                } else {
                    phi_1812_ = false;
                }
                let _e1441 = phi_1812_;
                phi_3269_ = _e1441;
            } else {
                let _e1442 = abs(_e146);
                let _e1443 = abs(_e147);
                let _e1444 = abs(_e148);
                if (abs(_e126) < 1000000000000000f) {
                    if (abs(_e128) < 1000000000000000f) {
                        phi_1828_ = (abs(_e130) < 1000000000000000f);
                        phi_1829_ = false;
                    } else {
                        phi_1828_ = bool();
                        phi_1829_ = true;
                    }
                    let _e1452 = phi_1828_;
                    let _e1454 = phi_1829_;
                    phi_1830_ = _e1452;
                    phi_1831_ = _e1454;
                } else {
                    phi_1830_ = bool();
                    phi_1831_ = true;
                }
                let _e1456 = phi_1830_;
                let _e1458 = phi_1831_;
                if _e1458 {
                    phi_1835_ = false;
                } else {
                    phi_1835_ = _e1456;
                }
                let _e1460 = phi_1835_;
                if _e1460 {
                    if (_e1442 < 1000000000000000f) {
                        if (_e1443 < 1000000000000000f) {
                            phi_1848_ = (_e1444 < 1000000000000000f);
                            phi_1849_ = false;
                        } else {
                            phi_1848_ = bool();
                            phi_1849_ = true;
                        }
                        let _e1465 = phi_1848_;
                        let _e1467 = phi_1849_;
                        phi_1850_ = _e1465;
                        phi_1851_ = _e1467;
                    } else {
                        phi_1850_ = bool();
                        phi_1851_ = true;
                    }
                    let _e1469 = phi_1850_;
                    let _e1471 = phi_1851_;
                    if _e1471 {
                        phi_1855_ = false;
                    } else {
                        phi_1855_ = _e1469;
                    }
                    let _e1473 = phi_1855_;
                    if _e1473 {
                        if (_e1442 > 0f) {
                            phi_1869_ = bool();
                            phi_1870_ = true;
                        } else {
                            let _e1475 = (_e1443 > 0f);
                            if _e1475 {
                                phi_1868_ = bool();
                            } else {
                                phi_1868_ = (_e1444 > 0f);
                            }
                            let _e1478 = phi_1868_;
                            phi_1869_ = _e1478;
                            phi_1870_ = _e1475;
                        }
                        let _e1480 = phi_1869_;
                        let _e1482 = phi_1870_;
                        if _e1482 {
                            phi_1874_ = true;
                        } else {
                            phi_1874_ = _e1480;
                        }
                        let _e1484 = phi_1874_;
                        phi_1875_ = _e1484;
                        phi_1876_ = false;
                    } else {
                        phi_1875_ = bool();
                        phi_1876_ = true;
                    }
                    let _e1486 = phi_1875_;
                    let _e1488 = phi_1876_;
                    phi_1877_ = _e1486;
                    phi_1878_ = _e1488;
                } else {
                    phi_1877_ = bool();
                    phi_1878_ = true;
                }
                let _e1490 = phi_1877_;
                let _e1492 = phi_1878_;
                if _e1492 {
                    phi_1882_ = false;
                } else {
                    phi_1882_ = _e1490;
                }
                let _e1494 = phi_1882_;
                if _e1494 {
                    let _e1495 = (0u >= _e76);
                    if _e1495 {
                        phi_3262_ = bool();
                    } else {
                        if (0u < _e76) {
                        } else {
                            return;
                        }
                        let _e1501 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1505 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1509 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1513 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1517 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1521 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1525 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1559 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146), abs(_e147));
                        let _e1560 = core_intrinsics_maximum_number_nsz_f32_(_e1559, abs(_e148));
                        let _e1561 = (_e1560 * 0.0000000000009094947f);
                        if (abs(_e146) < _e1561) {
                            phi_1952_ = _e1561;
                        } else {
                            phi_1952_ = abs(_e146);
                        }
                        let _e1566 = phi_1952_;
                        if (_e146 < 0f) {
                            phi_1959_ = (-1f / _e1566);
                        } else {
                            phi_1959_ = (1f / _e1566);
                        }
                        let _e1571 = phi_1959_;
                        if (abs(_e147) < _e1561) {
                            phi_1966_ = _e1561;
                        } else {
                            phi_1966_ = abs(_e147);
                        }
                        let _e1576 = phi_1966_;
                        if (_e147 < 0f) {
                            phi_1973_ = (-1f / _e1576);
                        } else {
                            phi_1973_ = (1f / _e1576);
                        }
                        let _e1581 = phi_1973_;
                        if (abs(_e148) < _e1561) {
                            phi_1980_ = _e1561;
                        } else {
                            phi_1980_ = abs(_e148);
                        }
                        let _e1586 = phi_1980_;
                        if (_e148 < 0f) {
                            phi_1987_ = (-1f / _e1586);
                        } else {
                            phi_1987_ = (1f / _e1586);
                        }
                        let _e1591 = phi_1987_;
                        let _e1595 = abs((bitcast<f32>(_e1501) - _e126));
                        let _e1596 = abs((bitcast<f32>(_e1505) - _e128));
                        let _e1597 = abs((bitcast<f32>(_e1509) - _e130));
                        let _e1601 = abs(((bitcast<f32>(_e1513) + (bitcast<f32>((((_e1525 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                        let _e1602 = abs(((bitcast<f32>(_e1517) + (bitcast<f32>((((_e1525 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                        let _e1603 = abs(((bitcast<f32>(_e1521) + (bitcast<f32>((((_e1525 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                        if (_e1595 > _e1601) {
                            phi_2004_ = _e1595;
                        } else {
                            phi_2004_ = _e1601;
                        }
                        let _e1606 = phi_2004_;
                        if (_e1596 > _e1602) {
                            phi_2009_ = _e1596;
                        } else {
                            phi_2009_ = _e1602;
                        }
                        let _e1609 = phi_2009_;
                        if (_e1597 > _e1603) {
                            phi_2014_ = _e1597;
                        } else {
                            phi_2014_ = _e1603;
                        }
                        let _e1612 = phi_2014_;
                        if (_e1606 > _e1609) {
                            phi_2019_ = _e1606;
                        } else {
                            phi_2019_ = _e1609;
                        }
                        let _e1615 = phi_2019_;
                        if (_e1615 > _e1612) {
                            phi_2024_ = _e1615;
                        } else {
                            phi_2024_ = _e1612;
                        }
                        let _e1618 = phi_2024_;
                        let _e1622 = (_e1618 * 0.0000019073486f);
                        let _e1623 = (abs(_e1571) * _e1622);
                        let _e1624 = (abs(_e1581) * _e1622);
                        let _e1625 = (abs(_e1591) * _e1622);
                        let _e1629 = (_e1618 * 0.0000009536743f);
                        let _e1630 = (abs(_e1571) * _e1629);
                        let _e1631 = (abs(_e1581) * _e1629);
                        let _e1632 = (abs(_e1591) * _e1629);
                        let _e1633 = abs(_e146);
                        let _e1634 = abs(_e147);
                        let _e1635 = abs(_e148);
                        if (_e1633 >= _e1634) {
                            if (_e1633 >= _e1635) {
                                phi_2050_ = false;
                            } else {
                                phi_2050_ = true;
                            }
                            let _e1639 = phi_2050_;
                            phi_2051_ = _e1639;
                        } else {
                            phi_2051_ = true;
                        }
                        let _e1641 = phi_2051_;
                        if _e1641 {
                            if (_e1634 >= _e1635) {
                                phi_2059_ = 1u;
                            } else {
                                phi_2059_ = 2u;
                            }
                            let _e1644 = phi_2059_;
                            phi_2060_ = _e1644;
                        } else {
                            phi_2060_ = 0u;
                        }
                        let _e1646 = phi_2060_;
                        if (_e1646 == 0u) {
                            phi_2072_ = vec3<f32>(_e147, _e148, _e146);
                        } else {
                            if (_e1646 == 1u) {
                                phi_2071_ = vec3<f32>(_e148, _e146, _e147);
                            } else {
                                phi_2071_ = _e149;
                            }
                            let _e1652 = phi_2071_;
                            phi_2072_ = _e1652;
                        }
                        let _e1654 = phi_2072_;
                        let _e1657 = (_e1654.x / _e1654.z);
                        let _e1660 = (_e1654.y / _e1654.z);
                        if (_e1571 < 0f) {
                            phi_2085_ = 0u;
                        } else {
                            phi_2085_ = 1u;
                        }
                        let _e1665 = phi_2085_;
                        if (_e1581 < 0f) {
                            phi_2090_ = 0u;
                        } else {
                            phi_2090_ = 2u;
                        }
                        let _e1668 = phi_2090_;
                        if (_e1591 < 0f) {
                            phi_2095_ = 0u;
                        } else {
                            phi_2095_ = 4u;
                        }
                        let _e1671 = phi_2095_;
                        let _e1673 = ((_e1665 | _e1668) | _e1671);
                        let _e1674 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1674.first[0], _e1674.first[1], _e1674.first[2], _e1674.first[3], _e1674.first[4], _e1674.first[5], _e1674.first[6], _e1674.first[7], _e1674.first[8], _e1674.first[9], _e1674.first[10], _e1674.first[11], _e1674.first[12], _e1674.first[13], _e1674.first[14], _e1674.first[15], _e1674.first[16], _e1674.first[17], _e1674.first[18], _e1674.first[19], _e1674.first[20], _e1674.first[21], _e1674.first[22], _e1674.first[23], _e1674.first[24], _e1674.first[25], _e1674.first[26], _e1674.first[27], _e1674.first[28], _e1674.first[29], _e1674.first[30], _e1674.first[31]), array<u32, 32>(_e1674.mask[0], _e1674.mask[1], _e1674.mask[2], _e1674.mask[3], _e1674.mask[4], _e1674.mask[5], _e1674.mask[6], _e1674.mask[7], _e1674.mask[8], _e1674.mask[9], _e1674.mask[10], _e1674.mask[11], _e1674.mask[12], _e1674.mask[13], _e1674.mask[14], _e1674.mask[15], _e1674.mask[16], _e1674.mask[17], _e1674.mask[18], _e1674.mask[19], _e1674.mask[20], _e1674.mask[21], _e1674.mask[22], _e1674.mask[23], _e1674.mask[24], _e1674.mask[25], _e1674.mask[26], _e1674.mask[27], _e1674.mask[28], _e1674.mask[29], _e1674.mask[30], _e1674.mask[31]), _e1674.len, _e1674.group, _e1674.group_mask);
                        let _e1748 = local.group_mask;
                        if ((_e1748 & 4278190080u) == 0u) {
                            let _e1752 = local.len;
                            if (_e1752 == 0u) {
                                phi_2209_ = false;
                            } else {
                                let _e1756 = local.len;
                                local.len = (_e1756 - 1u);
                                let _e1759 = local.len;
                                if (_e1759 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1764 = local.first[(0u + _e1759)];
                                local.group = _e1764;
                                let _e1767 = local.len;
                                if (_e1767 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1772 = local.mask[(0u + _e1767)];
                                local.group_mask = _e1772;
                                phi_2209_ = true;
                            }
                            let _e1775 = phi_2209_;
                            phi_2210_ = _e1775;
                        } else {
                            phi_2210_ = true;
                        }
                        let _e1777 = phi_2210_;
                        if _e1777 {
                            let _e1779 = local.group_mask;
                            let _e1785 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1779)), 32u, (_e1779 == 0u)));
                            let _e1789 = local.group_mask;
                            let _e1803 = local.group_mask;
                            local.group_mask = (_e1803 & ~((1u << bitcast<u32>((_e1785 & 31u)))));
                            let _e1806 = local.group;
                            phi_2241_ = (_e1806 + countOneBits(((_e1789 & ~((4294967295u << bitcast<u32>((((_e1785 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2241_ = 4294967295u;
                        }
                        let _e1809 = phi_2241_;
                        phi_2243_ = _e1809;
                        phi_2246_ = false;
                        loop {
                            let _e1811 = phi_2243_;
                            let _e1813 = phi_2246_;
                            local_16 = _e1813;
                            if (_e1811 != 4294967295u) {
                                if (_e1811 < _e76) {
                                } else {
                                    return;
                                }
                                let _e1820 = nodes.member[(0u + _e1811)].frame[3u];
                                let _e1845 = (bitcast<f32>((((_e1820 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1571);
                                let _e1846 = (bitcast<f32>((((_e1820 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1581);
                                let _e1847 = (bitcast<f32>((((_e1820 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1591);
                                let _e1850 = nodes.member[(0u + _e1811)].frame[0u];
                                let _e1854 = nodes.member[(0u + _e1811)].frame[1u];
                                let _e1858 = nodes.member[(0u + _e1811)].frame[2u];
                                let _e1863 = ((bitcast<f32>(_e1850) - _e126) * _e1571);
                                let _e1864 = ((bitcast<f32>(_e1854) - _e128) * _e1581);
                                let _e1865 = ((bitcast<f32>(_e1858) - _e130) * _e1591);
                                let _e1873 = nodes.member[(0u + _e1811)].x;
                                if (_e1571 < 0f) {
                                    let _e1884 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1873.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1890 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1884.unnamed.word, _e1873.w), _e1884.unnamed_1);
                                    let _e1896 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1890.unnamed, lt_mask_LightPlace(_e1873.x, _e1890.unnamed_1.shift));
                                    phi_2326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1896.unnamed, lt_mask_LightPlace(_e1896.unnamed_1.word, _e1873.y));
                                } else {
                                    let _e1912 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1873.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1918 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1912.unnamed.word, _e1873.y), _e1912.unnamed_1);
                                    let _e1924 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1918.unnamed, lt_mask_LightPlace(_e1873.z, _e1918.unnamed_1.shift));
                                    phi_2326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1924.unnamed, lt_mask_LightPlace(_e1924.unnamed_1.word, _e1873.w));
                                }
                                let _e1932 = phi_2326_;
                                let _e1942 = nodes.member[(0u + _e1811)].y;
                                if (_e1581 < 0f) {
                                    let _e1953 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1942.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1959 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1953.unnamed.word, _e1942.w), _e1953.unnamed_1);
                                    let _e1965 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1959.unnamed, lt_mask_LightPlace(_e1942.x, _e1959.unnamed_1.shift));
                                    phi_2353_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1965.unnamed, lt_mask_LightPlace(_e1965.unnamed_1.word, _e1942.y));
                                } else {
                                    let _e1981 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1942.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1987 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1981.unnamed.word, _e1942.y), _e1981.unnamed_1);
                                    let _e1993 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1987.unnamed, lt_mask_LightPlace(_e1942.z, _e1987.unnamed_1.shift));
                                    phi_2353_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1993.unnamed, lt_mask_LightPlace(_e1993.unnamed_1.word, _e1942.w));
                                }
                                let _e2001 = phi_2353_;
                                let _e2011 = nodes.member[(0u + _e1811)].z;
                                if (_e1591 < 0f) {
                                    let _e2022 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2011.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2028 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2022.unnamed.word, _e2011.w), _e2022.unnamed_1);
                                    let _e2034 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2028.unnamed, lt_mask_LightPlace(_e2011.x, _e2028.unnamed_1.shift));
                                    phi_2380_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2034.unnamed, lt_mask_LightPlace(_e2034.unnamed_1.word, _e2011.y));
                                } else {
                                    let _e2050 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2011.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2056 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2050.unnamed.word, _e2011.y), _e2050.unnamed_1);
                                    let _e2062 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2056.unnamed, lt_mask_LightPlace(_e2011.z, _e2056.unnamed_1.shift));
                                    phi_2380_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2062.unnamed, lt_mask_LightPlace(_e2062.unnamed_1.word, _e2011.w));
                                }
                                let _e2070 = phi_2380_;
                                phi_2386_ = 0u;
                                phi_2389_ = 0u;
                                loop {
                                    let _e2080 = phi_2386_;
                                    let _e2082 = phi_2389_;
                                    local_4 = _e2082;
                                    local_5 = _e2082;
                                    local_6 = _e2082;
                                    let _e2083 = (_e2080 < 8u);
                                    if _e2083 {
                                        let _e2085 = (_e2080 >> bitcast<u32>(2i));
                                        let _e2086 = (_e2080 & 3u);
                                        if (_e2085 == 0u) {
                                            phi_2403_ = _e1932.unnamed.word;
                                        } else {
                                            phi_2403_ = _e1932.unnamed.shift;
                                        }
                                        let _e2089 = phi_2403_;
                                        if (_e2085 == 0u) {
                                            phi_2413_ = _e2001.unnamed.word;
                                        } else {
                                            phi_2413_ = _e2001.unnamed.shift;
                                        }
                                        let _e2098 = phi_2413_;
                                        if (_e2085 == 0u) {
                                            phi_2423_ = _e2070.unnamed.word;
                                        } else {
                                            phi_2423_ = _e2070.unnamed.shift;
                                        }
                                        let _e2107 = phi_2423_;
                                        let _e2120 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2089 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u)) * _e1845) + (_e1863 - _e1623)), ((f32(((_e2098 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u)) * _e1846) + (_e1864 - _e1624)));
                                        let _e2121 = core_intrinsics_maximum_number_nsz_f32_(_e2120, ((f32(((_e2107 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u)) * _e1847) + (_e1865 - _e1625)));
                                        if (_e2085 == 0u) {
                                            phi_2441_ = _e1932.unnamed_1.word;
                                        } else {
                                            phi_2441_ = _e1932.unnamed_1.shift;
                                        }
                                        let _e2124 = phi_2441_;
                                        if (_e2085 == 0u) {
                                            phi_2451_ = _e2001.unnamed_1.word;
                                        } else {
                                            phi_2451_ = _e2001.unnamed_1.shift;
                                        }
                                        let _e2133 = phi_2451_;
                                        if (_e2085 == 0u) {
                                            phi_2461_ = _e2070.unnamed_1.word;
                                        } else {
                                            phi_2461_ = _e2070.unnamed_1.shift;
                                        }
                                        let _e2142 = phi_2461_;
                                        let _e2155 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2124 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u)) * _e1845) + (_e1863 + _e1623)), ((f32(((_e2133 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u)) * _e1846) + (_e1864 + _e1624)));
                                        let _e2156 = core_intrinsics_minimum_number_nsz_f32_(_e2155, ((f32(((_e2142 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u)) * _e1847) + (_e1865 + _e1625)));
                                        if (_e2121 <= _e2156) {
                                            if (_e2121 <= _e138) {
                                                if (_e2156 >= 0f) {
                                                    if (_e2085 == 0u) {
                                                        let _e2163 = nodes.member[(0u + _e1811)].links[2u];
                                                        phi_2497_ = _e2163;
                                                    } else {
                                                        let _e2166 = nodes.member[(0u + _e1811)].links[3u];
                                                        phi_2497_ = _e2166;
                                                    }
                                                    let _e2168 = phi_2497_;
                                                    let _e2173 = ((_e2168 >> bitcast<u32>(((_e2086 * 8u) & 31u))) & 255u);
                                                    let _e2174 = (_e2173 & 31u);
                                                    if (_e2174 >= 24u) {
                                                        phi_2510_ = (24u + ((_e2174 - 24u) ^ _e1673));
                                                    } else {
                                                        phi_2510_ = _e2174;
                                                    }
                                                    let _e2180 = phi_2510_;
                                                    phi_2515_ = (_e2082 | ((_e2173 >> bitcast<u32>(5i)) << bitcast<u32>((_e2180 & 31u))));
                                                } else {
                                                    phi_2515_ = _e2082;
                                                }
                                                let _e2188 = phi_2515_;
                                                phi_2516_ = _e2188;
                                            } else {
                                                phi_2516_ = _e2082;
                                            }
                                            let _e2190 = phi_2516_;
                                            phi_2517_ = _e2190;
                                        } else {
                                            phi_2517_ = _e2082;
                                        }
                                        let _e2192 = phi_2517_;
                                        phi_2387_ = (_e2080 + 1u);
                                        phi_2390_ = _e2192;
                                    } else {
                                        phi_2387_ = u32();
                                        phi_2390_ = u32();
                                    }
                                    let _e2195 = phi_2387_;
                                    let _e2197 = phi_2390_;
                                    continue;
                                    continuing {
                                        phi_2386_ = _e2195;
                                        phi_2389_ = _e2197;
                                        break if !(_e2083);
                                    }
                                }
                                let _e2201 = nodes.member[(0u + _e1811)].links[0u];
                                let _e2205 = nodes.member[(0u + _e1811)].frame[3u];
                                let _e2209 = local_4;
                                if ((_e2209 & 4278190080u) == 0u) {
                                } else {
                                    let _e2213 = local.group_mask;
                                    if ((_e2213 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2217 = local.len;
                                        if (_e2217 < 32u) {
                                            let _e2220 = local.group;
                                            let _e2222 = local.len;
                                            if (_e2222 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2222)] = _e2220;
                                            let _e2228 = local.group_mask;
                                            let _e2230 = local.len;
                                            if (_e2230 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2230)] = _e2228;
                                            let _e2237 = local.len;
                                            local.len = (_e2237 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2201);
                                    let _e2241 = local_5;
                                    local.group_mask = ((_e2241 & 4278190080u) | (_e2205 >> bitcast<u32>(24i)));
                                }
                                let _e2246 = local_6;
                                phi_2575_ = (_e2246 & 16777215u);
                                phi_2578_ = _e1813;
                                loop {
                                    let _e2249 = phi_2575_;
                                    let _e2251 = phi_2578_;
                                    local_14 = _e2251;
                                    let _e2252 = (_e2249 == 0u);
                                    local_7 = _e2252;
                                    local_15 = _e2252;
                                    if _e2252 {
                                        phi_2576_ = u32();
                                        phi_2579_ = bool();
                                        phi_3176_ = false;
                                    } else {
                                        let _e2255 = nodes.member[(0u + _e1811)].links[1u];
                                        let _e2260 = ((0u + _e2255) + select(firstTrailingBit(_e2249), 32u, (_e2249 == 0u)));
                                        if (_e2260 < _e79) {
                                        } else {
                                            return;
                                        }
                                        let _e2267 = triangles.member[(0u + _e2260)].v0_;
                                        let _e2269 = (_e2267.x - _e126);
                                        let _e2271 = (_e2267.y - _e128);
                                        let _e2273 = (_e2267.z - _e130);
                                        if (_e1646 == 0u) {
                                            phi_2623_ = vec3<f32>(_e2271, _e2273, _e2269);
                                        } else {
                                            if (_e1646 == 1u) {
                                                phi_2622_ = vec3<f32>(_e2273, _e2269, _e2271);
                                            } else {
                                                phi_2622_ = (_e2267 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2281 = phi_2622_;
                                            phi_2623_ = _e2281;
                                        }
                                        let _e2283 = phi_2623_;
                                        let _e2287 = (_e2283.x - (_e1657 * _e2283.z));
                                        let _e2291 = (_e2283.y - (_e1660 * _e2283.z));
                                        let _e2293 = triangles.member[(0u + _e2260)].v1_;
                                        let _e2295 = (_e2293.x - _e126);
                                        let _e2297 = (_e2293.y - _e128);
                                        let _e2299 = (_e2293.z - _e130);
                                        if (_e1646 == 0u) {
                                            phi_2653_ = vec3<f32>(_e2297, _e2299, _e2295);
                                        } else {
                                            if (_e1646 == 1u) {
                                                phi_2652_ = vec3<f32>(_e2299, _e2295, _e2297);
                                            } else {
                                                phi_2652_ = (_e2293 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2307 = phi_2652_;
                                            phi_2653_ = _e2307;
                                        }
                                        let _e2309 = phi_2653_;
                                        let _e2313 = (_e2309.x - (_e1657 * _e2309.z));
                                        let _e2317 = (_e2309.y - (_e1660 * _e2309.z));
                                        let _e2319 = triangles.member[(0u + _e2260)].v2_;
                                        let _e2321 = (_e2319.x - _e126);
                                        let _e2323 = (_e2319.y - _e128);
                                        let _e2325 = (_e2319.z - _e130);
                                        if (_e1646 == 0u) {
                                            phi_2683_ = vec3<f32>(_e2323, _e2325, _e2321);
                                        } else {
                                            if (_e1646 == 1u) {
                                                phi_2682_ = vec3<f32>(_e2325, _e2321, _e2323);
                                            } else {
                                                phi_2682_ = (_e2319 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2333 = phi_2682_;
                                            phi_2683_ = _e2333;
                                        }
                                        let _e2335 = phi_2683_;
                                        let _e2339 = (_e2335.x - (_e1657 * _e2335.z));
                                        let _e2343 = (_e2335.y - (_e1660 * _e2335.z));
                                        if (_e2313 < _e2339) {
                                            phi_2702_ = true;
                                        } else {
                                            if (_e2313 == _e2339) {
                                                phi_2701_ = (_e2317 < _e2343);
                                            } else {
                                                phi_2701_ = false;
                                            }
                                            let _e2348 = phi_2701_;
                                            phi_2702_ = _e2348;
                                        }
                                        let _e2350 = phi_2702_;
                                        if _e2350 {
                                            phi_2706_ = _e2343;
                                            phi_2707_ = _e2339;
                                            phi_2708_ = _e2317;
                                            phi_2709_ = _e2313;
                                        } else {
                                            phi_2706_ = _e2317;
                                            phi_2707_ = _e2313;
                                            phi_2708_ = _e2343;
                                            phi_2709_ = _e2339;
                                        }
                                        let _e2352 = phi_2706_;
                                        let _e2354 = phi_2707_;
                                        let _e2356 = phi_2708_;
                                        let _e2358 = phi_2709_;
                                        let _e2361 = ((_e2358 * _e2352) - (_e2356 * _e2354));
                                        if _e2350 {
                                            phi_2717_ = -(_e2361);
                                        } else {
                                            phi_2717_ = _e2361;
                                        }
                                        let _e2364 = phi_2717_;
                                        if (_e2339 < _e2287) {
                                            phi_2728_ = true;
                                        } else {
                                            if (_e2339 == _e2287) {
                                                phi_2727_ = (_e2343 < _e2291);
                                            } else {
                                                phi_2727_ = false;
                                            }
                                            let _e2369 = phi_2727_;
                                            phi_2728_ = _e2369;
                                        }
                                        let _e2371 = phi_2728_;
                                        if _e2371 {
                                            phi_2732_ = _e2291;
                                            phi_2733_ = _e2287;
                                            phi_2734_ = _e2343;
                                            phi_2735_ = _e2339;
                                        } else {
                                            phi_2732_ = _e2343;
                                            phi_2733_ = _e2339;
                                            phi_2734_ = _e2291;
                                            phi_2735_ = _e2287;
                                        }
                                        let _e2373 = phi_2732_;
                                        let _e2375 = phi_2733_;
                                        let _e2377 = phi_2734_;
                                        let _e2379 = phi_2735_;
                                        let _e2382 = ((_e2379 * _e2373) - (_e2377 * _e2375));
                                        if _e2371 {
                                            phi_2743_ = -(_e2382);
                                        } else {
                                            phi_2743_ = _e2382;
                                        }
                                        let _e2385 = phi_2743_;
                                        if (_e2287 < _e2313) {
                                            phi_2754_ = true;
                                        } else {
                                            if (_e2287 == _e2313) {
                                                phi_2753_ = (_e2291 < _e2317);
                                            } else {
                                                phi_2753_ = false;
                                            }
                                            let _e2390 = phi_2753_;
                                            phi_2754_ = _e2390;
                                        }
                                        let _e2392 = phi_2754_;
                                        if _e2392 {
                                            phi_2758_ = _e2317;
                                            phi_2759_ = _e2313;
                                            phi_2760_ = _e2291;
                                            phi_2761_ = _e2287;
                                        } else {
                                            phi_2758_ = _e2291;
                                            phi_2759_ = _e2287;
                                            phi_2760_ = _e2317;
                                            phi_2761_ = _e2313;
                                        }
                                        let _e2394 = phi_2758_;
                                        let _e2396 = phi_2759_;
                                        let _e2398 = phi_2760_;
                                        let _e2400 = phi_2761_;
                                        let _e2403 = ((_e2400 * _e2394) - (_e2398 * _e2396));
                                        if _e2392 {
                                            phi_2769_ = -(_e2403);
                                        } else {
                                            phi_2769_ = _e2403;
                                        }
                                        let _e2406 = phi_2769_;
                                        if (_e2364 >= 0f) {
                                            if (_e2385 >= 0f) {
                                                if (_e2406 >= 0f) {
                                                    phi_2784_ = ((_e2364 + _e2385) + _e2406);
                                                    phi_2785_ = false;
                                                } else {
                                                    phi_2784_ = f32();
                                                    phi_2785_ = true;
                                                }
                                                let _e2413 = phi_2784_;
                                                let _e2415 = phi_2785_;
                                                phi_2786_ = _e2413;
                                                phi_2787_ = _e2415;
                                            } else {
                                                phi_2786_ = f32();
                                                phi_2787_ = true;
                                            }
                                            let _e2417 = phi_2786_;
                                            let _e2419 = phi_2787_;
                                            phi_2788_ = _e2417;
                                            phi_2789_ = _e2419;
                                        } else {
                                            phi_2788_ = f32();
                                            phi_2789_ = true;
                                        }
                                        let _e2421 = phi_2788_;
                                        let _e2423 = phi_2789_;
                                        if _e2423 {
                                            if (_e2364 <= 0f) {
                                                if (_e2385 <= 0f) {
                                                    let _e2426 = (_e2406 <= 0f);
                                                    if _e2426 {
                                                    }
                                                    phi_2807_ = ((_e2364 + _e2385) + _e2406);
                                                    phi_2808_ = false;
                                                    phi_2809_ = _e2426;
                                                } else {
                                                    phi_2807_ = f32();
                                                    phi_2808_ = true;
                                                    phi_2809_ = false;
                                                }
                                                let _e2430 = phi_2807_;
                                                let _e2432 = phi_2808_;
                                                let _e2434 = phi_2809_;
                                                phi_2810_ = _e2430;
                                                phi_2811_ = _e2432;
                                                phi_2812_ = _e2434;
                                            } else {
                                                phi_2810_ = f32();
                                                phi_2811_ = true;
                                                phi_2812_ = false;
                                            }
                                            let _e2436 = phi_2810_;
                                            let _e2438 = phi_2811_;
                                            let _e2440 = phi_2812_;
                                            if _e2438 {
                                                phi_2816_ = false;
                                            } else {
                                                phi_2816_ = _e2440;
                                            }
                                            let _e2442 = phi_2816_;
                                            phi_2817_ = _e2436;
                                            phi_2818_ = _e2442;
                                        } else {
                                            phi_2817_ = _e2421;
                                            phi_2818_ = true;
                                        }
                                        let _e2444 = phi_2817_;
                                        let _e2446 = phi_2818_;
                                        if _e2446 {
                                            let _e2447 = (_e2444 == 0f);
                                            if _e2447 {
                                                phi_3134_ = lt_bvh_triangle_Intersection();
                                                phi_3135_ = false;
                                            } else {
                                                let _e2449 = triangles.member[(0u + _e2260)].v0_;
                                                let _e2451 = (_e2449.x - _e126);
                                                let _e2453 = (_e2449.y - _e128);
                                                let _e2455 = (_e2449.z - _e130);
                                                if (_e1646 == 0u) {
                                                    phi_2847_ = vec3<f32>(_e2453, _e2455, _e2451);
                                                } else {
                                                    if (_e1646 == 1u) {
                                                        phi_2846_ = vec3<f32>(_e2455, _e2451, _e2453);
                                                    } else {
                                                        phi_2846_ = (_e2449 - vec3<f32>(_e126, _e128, _e130));
                                                    }
                                                    let _e2463 = phi_2846_;
                                                    phi_2847_ = _e2463;
                                                }
                                                let _e2465 = phi_2847_;
                                                let _e2467 = triangles.member[(0u + _e2260)].v1_;
                                                let _e2469 = triangles.member[(0u + _e2260)].v0_;
                                                let _e2472 = (_e2467.x - _e2469.x);
                                                let _e2475 = (_e2467.y - _e2469.y);
                                                let _e2478 = (_e2467.z - _e2469.z);
                                                if (_e1646 == 0u) {
                                                    phi_2873_ = vec3<f32>(_e2475, _e2478, _e2472);
                                                } else {
                                                    if (_e1646 == 1u) {
                                                        phi_2872_ = vec3<f32>(_e2478, _e2472, _e2475);
                                                    } else {
                                                        phi_2872_ = (_e2467 - _e2469);
                                                    }
                                                    let _e2485 = phi_2872_;
                                                    phi_2873_ = _e2485;
                                                }
                                                let _e2487 = phi_2873_;
                                                let _e2489 = triangles.member[(0u + _e2260)].v2_;
                                                let _e2491 = triangles.member[(0u + _e2260)].v0_;
                                                let _e2494 = (_e2489.x - _e2491.x);
                                                let _e2497 = (_e2489.y - _e2491.y);
                                                let _e2500 = (_e2489.z - _e2491.z);
                                                if (_e1646 == 0u) {
                                                    phi_2899_ = vec3<f32>(_e2497, _e2500, _e2494);
                                                } else {
                                                    if (_e1646 == 1u) {
                                                        phi_2898_ = vec3<f32>(_e2500, _e2494, _e2497);
                                                    } else {
                                                        phi_2898_ = (_e2489 - _e2491);
                                                    }
                                                    let _e2507 = phi_2898_;
                                                    phi_2899_ = _e2507;
                                                }
                                                let _e2509 = phi_2899_;
                                                let _e2516 = ((_e2487.y * _e2509.z) - (_e2487.z * _e2509.y));
                                                let _e2523 = ((_e2487.z * _e2509.x) - (_e2487.x * _e2509.z));
                                                let _e2530 = ((_e2487.x * _e2509.y) - (_e2487.y * _e2509.x));
                                                let _e2544 = (((1f / _e1654.z) * (((_e2516 * _e2465.x) + (_e2523 * _e2465.y)) + (_e2530 * _e2465.z))) / (((_e2516 * _e1657) + (_e2523 * _e1660)) + _e2530));
                                                if (_e2544 > 0f) {
                                                    if (_e2544 < _e138) {
                                                        let _e2548 = triangles.member[(0u + _e2260)].v0_;
                                                        let _e2550 = triangles.member[(0u + _e2260)].v1_;
                                                        if (_e2548.x < _e2550.x) {
                                                            phi_2955_ = _e2548.x;
                                                        } else {
                                                            phi_2955_ = _e2550.x;
                                                        }
                                                        let _e2557 = phi_2955_;
                                                        if (_e2548.y < _e2550.y) {
                                                            phi_2964_ = _e2548.y;
                                                        } else {
                                                            phi_2964_ = _e2550.y;
                                                        }
                                                        let _e2564 = phi_2964_;
                                                        if (_e2548.z < _e2550.z) {
                                                            phi_2973_ = _e2548.z;
                                                        } else {
                                                            phi_2973_ = _e2550.z;
                                                        }
                                                        let _e2571 = phi_2973_;
                                                        let _e2573 = triangles.member[(0u + _e2260)].v2_;
                                                        if (_e2557 < _e2573.x) {
                                                            phi_2982_ = _e2557;
                                                        } else {
                                                            phi_2982_ = _e2573.x;
                                                        }
                                                        let _e2578 = phi_2982_;
                                                        if (_e2564 < _e2573.y) {
                                                            phi_2989_ = _e2564;
                                                        } else {
                                                            phi_2989_ = _e2573.y;
                                                        }
                                                        let _e2583 = phi_2989_;
                                                        if (_e2571 < _e2573.z) {
                                                            phi_2996_ = _e2571;
                                                        } else {
                                                            phi_2996_ = _e2573.z;
                                                        }
                                                        let _e2588 = phi_2996_;
                                                        let _e2590 = triangles.member[(0u + _e2260)].v0_;
                                                        let _e2592 = triangles.member[(0u + _e2260)].v1_;
                                                        if (_e2590.x > _e2592.x) {
                                                            phi_3009_ = _e2590.x;
                                                        } else {
                                                            phi_3009_ = _e2592.x;
                                                        }
                                                        let _e2599 = phi_3009_;
                                                        if (_e2590.y > _e2592.y) {
                                                            phi_3018_ = _e2590.y;
                                                        } else {
                                                            phi_3018_ = _e2592.y;
                                                        }
                                                        let _e2606 = phi_3018_;
                                                        if (_e2590.z > _e2592.z) {
                                                            phi_3027_ = _e2590.z;
                                                        } else {
                                                            phi_3027_ = _e2592.z;
                                                        }
                                                        let _e2613 = phi_3027_;
                                                        let _e2615 = triangles.member[(0u + _e2260)].v2_;
                                                        if (_e2599 > _e2615.x) {
                                                            phi_3036_ = _e2599;
                                                        } else {
                                                            phi_3036_ = _e2615.x;
                                                        }
                                                        let _e2620 = phi_3036_;
                                                        if (_e2606 > _e2615.y) {
                                                            phi_3043_ = _e2606;
                                                        } else {
                                                            phi_3043_ = _e2615.y;
                                                        }
                                                        let _e2625 = phi_3043_;
                                                        if (_e2613 > _e2615.z) {
                                                            phi_3050_ = _e2613;
                                                        } else {
                                                            phi_3050_ = _e2615.z;
                                                        }
                                                        let _e2630 = phi_3050_;
                                                        let _e2634 = ((_e2578 - _e126) * _e1571);
                                                        let _e2635 = ((_e2583 - _e128) * _e1581);
                                                        let _e2636 = ((_e2588 - _e130) * _e1591);
                                                        let _e2640 = ((_e2620 - _e126) * _e1571);
                                                        let _e2641 = ((_e2625 - _e128) * _e1581);
                                                        let _e2642 = ((_e2630 - _e130) * _e1591);
                                                        if (_e2634 < _e2640) {
                                                            phi_3067_ = _e2634;
                                                        } else {
                                                            phi_3067_ = _e2640;
                                                        }
                                                        let _e2645 = phi_3067_;
                                                        if (_e2635 < _e2641) {
                                                            phi_3072_ = _e2635;
                                                        } else {
                                                            phi_3072_ = _e2641;
                                                        }
                                                        let _e2648 = phi_3072_;
                                                        if (_e2636 < _e2642) {
                                                            phi_3077_ = _e2636;
                                                        } else {
                                                            phi_3077_ = _e2642;
                                                        }
                                                        let _e2651 = phi_3077_;
                                                        if (_e2634 > _e2640) {
                                                            phi_3085_ = _e2634;
                                                        } else {
                                                            phi_3085_ = _e2640;
                                                        }
                                                        let _e2657 = phi_3085_;
                                                        if (_e2635 > _e2641) {
                                                            phi_3090_ = _e2635;
                                                        } else {
                                                            phi_3090_ = _e2641;
                                                        }
                                                        let _e2660 = phi_3090_;
                                                        if (_e2636 > _e2642) {
                                                            phi_3095_ = _e2636;
                                                        } else {
                                                            phi_3095_ = _e2642;
                                                        }
                                                        let _e2663 = phi_3095_;
                                                        let _e2667 = core_intrinsics_maximum_number_nsz_f32_((_e2645 - _e1630), (_e2648 - _e1631));
                                                        let _e2668 = core_intrinsics_maximum_number_nsz_f32_(_e2667, (_e2651 - _e1632));
                                                        let _e2669 = core_intrinsics_minimum_number_nsz_f32_((_e2657 + _e1630), (_e2660 + _e1631));
                                                        let _e2670 = core_intrinsics_minimum_number_nsz_f32_(_e2669, (_e2663 + _e1632));
                                                        if (_e2668 > -300000000000000000000000000000000000000f) {
                                                            phi_3107_ = _e2668;
                                                        } else {
                                                            phi_3107_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2673 = phi_3107_;
                                                        if (_e2670 < 300000000000000000000000000000000000000f) {
                                                            phi_3112_ = _e2670;
                                                        } else {
                                                            phi_3112_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2676 = phi_3112_;
                                                        if (_e2544 < _e2673) {
                                                            phi_3117_ = _e2673;
                                                        } else {
                                                            phi_3117_ = _e2544;
                                                        }
                                                        let _e2679 = phi_3117_;
                                                        if (_e2679 > _e2676) {
                                                            phi_3122_ = _e2676;
                                                        } else {
                                                            phi_3122_ = _e2679;
                                                        }
                                                        let _e2682 = phi_3122_;
                                                        phi_3127_ = lt_bvh_triangle_Intersection(_e2682, (_e2385 / _e2444), (_e2406 / _e2444), (_e2673 <= _e2676));
                                                        phi_3128_ = false;
                                                    } else {
                                                        phi_3127_ = lt_bvh_triangle_Intersection();
                                                        phi_3128_ = true;
                                                    }
                                                    let _e2688 = phi_3127_;
                                                    let _e2690 = phi_3128_;
                                                    phi_3129_ = _e2688;
                                                    phi_3130_ = _e2690;
                                                } else {
                                                    phi_3129_ = lt_bvh_triangle_Intersection();
                                                    phi_3130_ = true;
                                                }
                                                let _e2692 = phi_3129_;
                                                let _e2694 = phi_3130_;
                                                if _e2694 {
                                                }
                                                phi_3134_ = _e2692;
                                                phi_3135_ = _e2694;
                                            }
                                            let _e2696 = phi_3134_;
                                            let _e2698 = phi_3135_;
                                            phi_3136_ = _e2696;
                                            phi_3137_ = _e2447;
                                            phi_3138_ = _e2698;
                                        } else {
                                            phi_3136_ = lt_bvh_triangle_Intersection();
                                            phi_3137_ = true;
                                            phi_3138_ = false;
                                        }
                                        let _e2700 = phi_3136_;
                                        let _e2702 = phi_3137_;
                                        let _e2704 = phi_3138_;
                                        if _e2702 {
                                            phi_3142_ = true;
                                        } else {
                                            phi_3142_ = _e2704;
                                        }
                                        let _e2706 = phi_3142_;
                                        if _e2706 {
                                            phi_3146_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3146_ = _e2700;
                                        }
                                        let _e2708 = phi_3146_;
                                        if _e2708.is_hit {
                                            if (_e2708.t > 0f) {
                                                if (_e2708.t < _e138) {
                                                    if true {
                                                        phi_3166_ = false;
                                                    } else {
                                                        phi_3166_ = true;
                                                    }
                                                    let _e2717 = phi_3166_;
                                                    phi_3167_ = true;
                                                    phi_3168_ = _e2717;
                                                } else {
                                                    phi_3167_ = _e2251;
                                                    phi_3168_ = true;
                                                }
                                                let _e2719 = phi_3167_;
                                                let _e2721 = phi_3168_;
                                                phi_3169_ = _e2719;
                                                phi_3170_ = _e2721;
                                            } else {
                                                phi_3169_ = _e2251;
                                                phi_3170_ = true;
                                            }
                                            let _e2723 = phi_3169_;
                                            let _e2725 = phi_3170_;
                                            phi_3171_ = _e2723;
                                            phi_3172_ = _e2725;
                                        } else {
                                            phi_3171_ = _e2251;
                                            phi_3172_ = true;
                                        }
                                        let _e2727 = phi_3171_;
                                        let _e2729 = phi_3172_;
                                        if _e2729 {
                                        }
                                        phi_2576_ = (_e2249 & (_e2249 - 1u));
                                        phi_2579_ = _e2727;
                                        phi_3176_ = _e2729;
                                    }
                                    let _e2731 = phi_2576_;
                                    let _e2733 = phi_2579_;
                                    let _e2735 = phi_3176_;
                                    continue;
                                    continuing {
                                        phi_2575_ = _e2731;
                                        phi_2578_ = _e2733;
                                        break if !(_e2735);
                                    }
                                }
                                let _e2738 = local_7;
                                if _e2738 {
                                    let _e2740 = local.group_mask;
                                    if ((_e2740 & 4278190080u) == 0u) {
                                        let _e2744 = local.len;
                                        if (_e2744 == 0u) {
                                            phi_3218_ = false;
                                        } else {
                                            let _e2748 = local.len;
                                            local.len = (_e2748 - 1u);
                                            let _e2751 = local.len;
                                            if (_e2751 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2756 = local.first[(0u + _e2751)];
                                            local.group = _e2756;
                                            let _e2759 = local.len;
                                            if (_e2759 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2764 = local.mask[(0u + _e2759)];
                                            local.group_mask = _e2764;
                                            phi_3218_ = true;
                                        }
                                        let _e2767 = phi_3218_;
                                        phi_3219_ = _e2767;
                                    } else {
                                        phi_3219_ = true;
                                    }
                                    let _e2769 = phi_3219_;
                                    if _e2769 {
                                        let _e2771 = local.group_mask;
                                        let _e2777 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2771)), 32u, (_e2771 == 0u)));
                                        let _e2781 = local.group_mask;
                                        let _e2795 = local.group_mask;
                                        local.group_mask = (_e2795 & ~((1u << bitcast<u32>((_e2777 & 31u)))));
                                        let _e2798 = local.group;
                                        phi_3250_ = (_e2798 + countOneBits(((_e2781 & ~((4294967295u << bitcast<u32>((((_e2777 - 24u) ^ _e1673) & 31u))))) & 255u)));
                                    } else {
                                        phi_3250_ = 4294967295u;
                                    }
                                    let _e2801 = phi_3250_;
                                    phi_3251_ = _e2801;
                                } else {
                                    phi_3251_ = u32();
                                }
                                let _e2803 = phi_3251_;
                                phi_2244_ = _e2803;
                                let _e3327 = local_14;
                                phi_2247_ = _e3327;
                                let _e3330 = local_15;
                                phi_3252_ = _e3330;
                                phi_3253_ = false;
                            } else {
                                phi_2244_ = u32();
                                phi_2247_ = bool();
                                phi_3252_ = false;
                                phi_3253_ = true;
                            }
                            let _e2805 = phi_2244_;
                            let _e2807 = phi_2247_;
                            let _e2809 = phi_3252_;
                            let _e2811 = phi_3253_;
                            local_8 = _e2811;
                            continue;
                            continuing {
                                phi_2243_ = _e2805;
                                phi_2246_ = _e2807;
                                break if !(_e2809);
                            }
                        }
                        let _e2814 = local_8;
                        if _e2814 {
                            phi_3257_ = false;
                        } else {
                            phi_3257_ = true;
                        }
                        let _e2816 = phi_3257_;
                        if _e2816 {
                            phi_3261_ = true;
                        } else {
                            let _e3336 = local_16;
                            phi_3261_ = _e3336;
                        }
                        let _e2818 = phi_3261_;
                        phi_3262_ = _e2818;
                    }
                    let _e2820 = phi_3262_;
                    phi_3263_ = _e2820;
                    phi_3264_ = _e1495;
                } else {
                    phi_3263_ = bool();
                    phi_3264_ = true;
                }
                let _e2822 = phi_3263_;
                let _e2824 = phi_3264_;
                if _e2824 {
                    phi_3268_ = false;
                } else {
                    phi_3268_ = _e2822;
                }
                let _e2826 = phi_3268_;
                phi_3269_ = _e2826;
            }
            let _e2828 = phi_3269_;
            phi_3270_ = _e2828;
        } else {
            phi_3270_ = false;
        }
        let _e2830 = phi_3270_;
        if _e2830 {
            phi_3274_ = 0f;
        } else {
            phi_3274_ = 1f;
        }
        let _e2832 = phi_3274_;
        if (_e105 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e105)] = _e2832;
        let _e2838 = p.member.light.number;
        let _e2839 = (_e2838 * 3u);
        let _e2840 = (_e2839 / 32u);
        let _e2841 = (_e2839 % 32u);
        let _e2843 = p.member.light.mask_words;
        if (_e105 < _e82) {
        } else {
            return;
        }
        let _e2847 = visibility.member[(0u + _e105)];
        let _e2849 = ((_e105 * _e2843) + _e2840);
        if (_e2841 > 29u) {
            let _e2851 = (_e2849 + 1u);
            if (_e2851 < _e88) {
            } else {
                return;
            }
            let _e2855 = bits.member[(0u + _e2851)];
            phi_3315_ = _e2855;
        } else {
            phi_3315_ = 0u;
        }
        let _e2857 = phi_3315_;
        if (_e2849 < _e88) {
        } else {
            return;
        }
        let _e2861 = bits.member[(0u + _e2849)];
        let _e2864 = (_e2861 >> bitcast<u32>((_e2841 & 31u)));
        if (_e2841 > 29u) {
            phi_3334_ = (_e2864 | (_e2857 << bitcast<u32>(((32u - _e2841) & 31u))));
        } else {
            phi_3334_ = _e2864;
        }
        let _e2872 = phi_3334_;
        if ((_e2872 & 2u) == 0u) {
            phi_3342_ = (_e2872 & 1u);
        } else {
            phi_3342_ = (_e2872 & 7u);
        }
        let _e2878 = phi_3342_;
        if ((_e2878 & 1u) != 0u) {
            phi_3350_ = (2u | 1u);
        } else {
            phi_3350_ = 2u;
        }
        let _e2884 = phi_3350_;
        if (_e2847 < 0.5f) {
            phi_3355_ = (_e2884 | 4u);
        } else {
            phi_3355_ = _e2884;
        }
        let _e2887 = phi_3355_;
        let _e2889 = ((_e105 * _e2843) + _e2840);
        if (_e2889 < _e88) {
        } else {
            return;
        }
        let _e2893 = bits.member[(0u + _e2889)];
        if (_e2889 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e2889)] = ((_e2893 & ~((7u << bitcast<u32>((_e2841 & 31u))))) | (_e2887 << bitcast<u32>((_e2841 & 31u))));
        if (_e2841 > 29u) {
            let _e2907 = (_e2889 + 1u);
            if (_e2907 < _e88) {
            } else {
                return;
            }
            let _e2911 = bits.member[(0u + _e2907)];
            let _e2912 = (32u - _e2841);
            let _e2922 = (_e2889 + 1u);
            if (_e2922 < _e88) {
            } else {
                return;
            }
            bits.member[(0u + _e2922)] = ((_e2911 & ~((7u >> bitcast<u32>((_e2912 & 31u))))) | (_e2887 >> bitcast<u32>((_e2912 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
