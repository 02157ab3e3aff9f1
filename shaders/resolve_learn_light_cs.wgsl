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
    var phi_792_: u32;
    var phi_795_: u32;
    var phi_797_: u32;
    var phi_799_: u32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_887_: u32;
    var phi_910_: f32;
    var phi_911_: f32;
    var phi_925_: u32;
    var phi_948_: f32;
    var phi_949_: f32;
    var phi_963_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_1115_: u32;
    var phi_1116_: u32;
    var phi_1117_: u32;
    var phi_1118_: u32;
    var phi_1119_: u32;
    var phi_1120_: u32;
    var phi_1138_: u32;
    var phi_1139_: u32;
    var phi_1140_: u32;
    var phi_1141_: u32;
    var phi_1142_: u32;
    var phi_1143_: u32;
    var phi_1144_: u32;
    var phi_1145_: u32;
    var phi_793_: u32;
    var phi_796_: u32;
    var phi_798_: u32;
    var phi_800_: u32;
    var phi_1146_: bool;
    var local_2: bool;
    var phi_1151_: u32;
    var local_3: u32;
    var phi_1190_: u32;
    var phi_1191_: u32;
    var phi_1197_: u32;
    var phi_1226_: vec3<f32>;
    var phi_1227_: vec3<f32>;
    var phi_1256_: vec3<f32>;
    var phi_1257_: vec3<f32>;
    var phi_1286_: vec3<f32>;
    var phi_1287_: vec3<f32>;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1310_: f32;
    var phi_1311_: f32;
    var phi_1312_: f32;
    var phi_1313_: f32;
    var phi_1321_: f32;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1336_: f32;
    var phi_1337_: f32;
    var phi_1338_: f32;
    var phi_1339_: f32;
    var phi_1347_: f32;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1362_: f32;
    var phi_1363_: f32;
    var phi_1364_: f32;
    var phi_1365_: f32;
    var phi_1373_: f32;
    var phi_1388_: f32;
    var phi_1389_: bool;
    var phi_1390_: f32;
    var phi_1391_: bool;
    var phi_1392_: f32;
    var phi_1393_: bool;
    var phi_1411_: f32;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: f32;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1420_: bool;
    var phi_1421_: f32;
    var phi_1422_: bool;
    var phi_1450_: vec3<f32>;
    var phi_1451_: vec3<f32>;
    var phi_1476_: vec3<f32>;
    var phi_1477_: vec3<f32>;
    var phi_1502_: vec3<f32>;
    var phi_1503_: vec3<f32>;
    var phi_1559_: f32;
    var phi_1568_: f32;
    var phi_1577_: f32;
    var phi_1586_: f32;
    var phi_1593_: f32;
    var phi_1600_: f32;
    var phi_1613_: f32;
    var phi_1622_: f32;
    var phi_1631_: f32;
    var phi_1640_: f32;
    var phi_1647_: f32;
    var phi_1654_: f32;
    var phi_1671_: f32;
    var phi_1676_: f32;
    var phi_1681_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1699_: f32;
    var phi_1711_: f32;
    var phi_1716_: f32;
    var phi_1721_: f32;
    var phi_1726_: f32;
    var phi_1731_: lt_bvh_triangle_Intersection;
    var phi_1732_: bool;
    var phi_1733_: lt_bvh_triangle_Intersection;
    var phi_1734_: bool;
    var phi_1738_: lt_bvh_triangle_Intersection;
    var phi_1739_: bool;
    var phi_1740_: lt_bvh_triangle_Intersection;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1746_: bool;
    var phi_1750_: lt_bvh_triangle_Intersection;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1152_: u32;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var local_4: bool;
    var phi_1806_: bool;
    var phi_1807_: bool;
    var phi_781_: u32;
    var phi_784_: u32;
    var phi_1808_: bool;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var local_5: bool;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1819_: bool;
    var phi_1823_: bool;
    var phi_1827_: bool;
    var phi_1828_: bool;
    var phi_1832_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1855_: bool;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1870_: bool;
    var phi_1871_: bool;
    var phi_1875_: bool;
    var phi_1888_: bool;
    var phi_1889_: bool;
    var phi_1890_: bool;
    var phi_1894_: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var phi_1897_: bool;
    var phi_1898_: bool;
    var phi_1902_: bool;
    var phi_1972_: f32;
    var phi_1979_: f32;
    var phi_1986_: f32;
    var phi_1993_: f32;
    var phi_2000_: f32;
    var phi_2007_: f32;
    var phi_2024_: f32;
    var phi_2029_: f32;
    var phi_2034_: f32;
    var phi_2039_: f32;
    var phi_2044_: f32;
    var phi_2070_: bool;
    var phi_2071_: bool;
    var phi_2079_: u32;
    var phi_2080_: u32;
    var phi_2091_: vec3<f32>;
    var phi_2092_: vec3<f32>;
    var phi_2105_: u32;
    var phi_2110_: u32;
    var phi_2115_: u32;
    var phi_2229_: bool;
    var phi_2230_: bool;
    var phi_2261_: u32;
    var phi_2263_: u32;
    var phi_2266_: bool;
    var phi_2346_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2373_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2400_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2406_: u32;
    var phi_2409_: u32;
    var phi_2423_: u32;
    var phi_2433_: u32;
    var phi_2443_: u32;
    var phi_2461_: u32;
    var phi_2471_: u32;
    var phi_2481_: u32;
    var phi_2517_: u32;
    var phi_2530_: u32;
    var phi_2535_: u32;
    var phi_2536_: u32;
    var phi_2537_: u32;
    var phi_2407_: u32;
    var phi_2410_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2595_: u32;
    var phi_2598_: bool;
    var phi_2642_: vec3<f32>;
    var phi_2643_: vec3<f32>;
    var phi_2672_: vec3<f32>;
    var phi_2673_: vec3<f32>;
    var phi_2702_: vec3<f32>;
    var phi_2703_: vec3<f32>;
    var phi_2721_: bool;
    var phi_2722_: bool;
    var phi_2726_: f32;
    var phi_2727_: f32;
    var phi_2728_: f32;
    var phi_2729_: f32;
    var phi_2737_: f32;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2752_: f32;
    var phi_2753_: f32;
    var phi_2754_: f32;
    var phi_2755_: f32;
    var phi_2763_: f32;
    var phi_2773_: bool;
    var phi_2774_: bool;
    var phi_2778_: f32;
    var phi_2779_: f32;
    var phi_2780_: f32;
    var phi_2781_: f32;
    var phi_2789_: f32;
    var phi_2804_: f32;
    var phi_2805_: bool;
    var phi_2806_: f32;
    var phi_2807_: bool;
    var phi_2808_: f32;
    var phi_2809_: bool;
    var phi_2827_: f32;
    var phi_2828_: bool;
    var phi_2829_: bool;
    var phi_2830_: f32;
    var phi_2831_: bool;
    var phi_2832_: bool;
    var phi_2836_: bool;
    var phi_2837_: f32;
    var phi_2838_: bool;
    var phi_2866_: vec3<f32>;
    var phi_2867_: vec3<f32>;
    var phi_2892_: vec3<f32>;
    var phi_2893_: vec3<f32>;
    var phi_2918_: vec3<f32>;
    var phi_2919_: vec3<f32>;
    var phi_2975_: f32;
    var phi_2984_: f32;
    var phi_2993_: f32;
    var phi_3002_: f32;
    var phi_3009_: f32;
    var phi_3016_: f32;
    var phi_3029_: f32;
    var phi_3038_: f32;
    var phi_3047_: f32;
    var phi_3056_: f32;
    var phi_3063_: f32;
    var phi_3070_: f32;
    var phi_3087_: f32;
    var phi_3092_: f32;
    var phi_3097_: f32;
    var phi_3105_: f32;
    var phi_3110_: f32;
    var phi_3115_: f32;
    var phi_3127_: f32;
    var phi_3132_: f32;
    var phi_3137_: f32;
    var phi_3142_: f32;
    var phi_3147_: lt_bvh_triangle_Intersection;
    var phi_3148_: bool;
    var phi_3149_: lt_bvh_triangle_Intersection;
    var phi_3150_: bool;
    var phi_3154_: lt_bvh_triangle_Intersection;
    var phi_3155_: bool;
    var phi_3156_: lt_bvh_triangle_Intersection;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3162_: bool;
    var phi_3166_: lt_bvh_triangle_Intersection;
    var phi_3186_: bool;
    var phi_3187_: bool;
    var phi_3188_: bool;
    var phi_3189_: bool;
    var phi_3190_: bool;
    var phi_3191_: bool;
    var phi_3192_: bool;
    var phi_2596_: u32;
    var phi_2599_: bool;
    var phi_3196_: bool;
    var local_9: bool;
    var phi_3238_: bool;
    var phi_3239_: bool;
    var phi_3270_: u32;
    var phi_3271_: u32;
    var phi_2264_: u32;
    var phi_2267_: bool;
    var phi_3272_: bool;
    var phi_3273_: bool;
    var local_10: bool;
    var phi_3277_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_3284_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3294_: f32;
    var phi_3335_: u32;
    var phi_3354_: u32;
    var phi_3362_: u32;
    var phi_3370_: u32;
    var phi_3375_: u32;
    var local_11: u32;
    var local_12: bool;
    var local_13: bool;
    var local_14: u32;
    var local_15: u32;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;

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
                    phi_1827_ = false;
                    phi_1828_ = true;
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
                        local_5 = _e539;
                        if _e539 {
                            phi_781_ = u32();
                            phi_784_ = u32();
                            phi_1808_ = false;
                            phi_1809_ = false;
                            phi_1810_ = false;
                        } else {
                            phi_792_ = _e536;
                            phi_795_ = 0u;
                            phi_797_ = 0u;
                            phi_799_ = _e538;
                            loop {
                                let _e541 = phi_792_;
                                let _e543 = phi_795_;
                                let _e545 = phi_797_;
                                let _e547 = phi_799_;
                                local_11 = _e545;
                                local_3 = _e543;
                                local_14 = _e541;
                                local_15 = _e547;
                                let _e548 = (_e541 == 0u);
                                local_2 = _e548;
                                if _e548 {
                                    phi_793_ = u32();
                                    phi_796_ = u32();
                                    phi_798_ = u32();
                                    phi_800_ = u32();
                                    phi_1146_ = false;
                                } else {
                                    let _e549 = (_e545 == 0u);
                                    if _e549 {
                                        let _e556 = (((_e541 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e541), 32u, (_e541 == 0u))) * 4u);
                                        if (_e556 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e560 = rows.member[(0u + _e556)];
                                        let _e561 = (_e556 + 1u);
                                        if (_e561 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e565 = rows.member[(0u + _e561)];
                                        let _e566 = (_e556 + 2u);
                                        if (_e566 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e570 = rows.member[(0u + _e566)];
                                        let _e571 = (_e556 + 3u);
                                        if (_e571 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e575 = rows.member[(0u + _e571)];
                                        let _e576 = lt_bvh_LightNode(_e560, _e565, _e570, _e575);
                                        let _e578 = (_e541 & (_e541 - 1u));
                                        let _e590 = (_e366.unnamed.positive_exponent - bitcast<f32>(_e576.frame.x));
                                        let _e593 = bitcast<f32>((((_e576.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e590 > 0f) {
                                            if (_e590 < (255f * _e593)) {
                                                phi_872_ = (_e590 / _e593);
                                            } else {
                                                phi_872_ = 255f;
                                            }
                                            let _e599 = phi_872_;
                                            phi_873_ = _e599;
                                        } else {
                                            phi_873_ = 0f;
                                        }
                                        let _e601 = phi_873_;
                                        let _e608 = select(select(u32(_e601), 0u, (_e601 < bitcast<f32>(0u))), 4294967295u, (_e601 > bitcast<f32>(1333788671u)));
                                        if (f32(_e608) < _e601) {
                                            phi_887_ = (_e608 + 1u);
                                        } else {
                                            phi_887_ = _e608;
                                        }
                                        let _e613 = phi_887_;
                                        let _e614 = (_e608 * 16843009u);
                                        let _e615 = (_e613 * 16843009u);
                                        let _e625 = (_e366.unnamed.negative_exponent - bitcast<f32>(_e576.frame.y));
                                        let _e628 = bitcast<f32>((((_e576.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e625 > 0f) {
                                            if (_e625 < (255f * _e628)) {
                                                phi_910_ = (_e625 / _e628);
                                            } else {
                                                phi_910_ = 255f;
                                            }
                                            let _e634 = phi_910_;
                                            phi_911_ = _e634;
                                        } else {
                                            phi_911_ = 0f;
                                        }
                                        let _e636 = phi_911_;
                                        let _e643 = select(select(u32(_e636), 0u, (_e636 < bitcast<f32>(0u))), 4294967295u, (_e636 > bitcast<f32>(1333788671u)));
                                        if (f32(_e643) < _e636) {
                                            phi_925_ = (_e643 + 1u);
                                        } else {
                                            phi_925_ = _e643;
                                        }
                                        let _e648 = phi_925_;
                                        let _e649 = (_e643 * 16843009u);
                                        let _e650 = (_e648 * 16843009u);
                                        let _e660 = (_e366.unnamed.min_variance - bitcast<f32>(_e576.frame.z));
                                        let _e663 = bitcast<f32>((((_e576.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e660 > 0f) {
                                            if (_e660 < (255f * _e663)) {
                                                phi_948_ = (_e660 / _e663);
                                            } else {
                                                phi_948_ = 255f;
                                            }
                                            let _e669 = phi_948_;
                                            phi_949_ = _e669;
                                        } else {
                                            phi_949_ = 0f;
                                        }
                                        let _e671 = phi_949_;
                                        let _e678 = select(select(u32(_e671), 0u, (_e671 < bitcast<f32>(0u))), 4294967295u, (_e671 > bitcast<f32>(1333788671u)));
                                        if (f32(_e678) < _e671) {
                                            phi_963_ = (_e678 + 1u);
                                        } else {
                                            phi_963_ = _e678;
                                        }
                                        let _e683 = phi_963_;
                                        let _e684 = (_e683 * 16843009u);
                                        let _e817 = (((((((((((_e614 & ~(_e576.x.x)) | (~((_e576.x.x ^ _e614)) & ((_e614 | 2155905152u) - (_e576.x.x & 2139062143u)))) & ((_e576.x.z & ~(_e615)) | (~((_e615 ^ _e576.x.z)) & ((_e576.x.z | 2155905152u) - (_e615 & 2139062143u))))) & ((_e649 & ~(_e576.y.x)) | (~((_e576.y.x ^ _e649)) & ((_e649 | 2155905152u) - (_e576.y.x & 2139062143u))))) & ((_e576.y.z & ~(_e650)) | (~((_e650 ^ _e576.y.z)) & ((_e576.y.z | 2155905152u) - (_e650 & 2139062143u))))) & ((_e576.rest.x & ~(_e684)) | (~((_e684 ^ _e576.rest.x)) & ((_e576.rest.x | 2155905152u) - (_e684 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e614 & ~(_e576.x.y)) | (~((_e576.x.y ^ _e614)) & ((_e614 | 2155905152u) - (_e576.x.y & 2139062143u)))) & ((_e576.x.w & ~(_e615)) | (~((_e615 ^ _e576.x.w)) & ((_e576.x.w | 2155905152u) - (_e615 & 2139062143u))))) & ((_e649 & ~(_e576.y.y)) | (~((_e576.y.y ^ _e649)) & ((_e649 | 2155905152u) - (_e576.y.y & 2139062143u))))) & ((_e576.y.w & ~(_e650)) | (~((_e650 ^ _e576.y.w)) & ((_e576.y.w | 2155905152u) - (_e650 & 2139062143u))))) & ((_e576.rest.y & ~(_e684)) | (~((_e684 ^ _e576.rest.y)) & ((_e576.rest.y | 2155905152u) - (_e684 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                        if ((_e576.frame.w & 16777216u) != 0u) {
                                            phi_1117_ = _e578;
                                            phi_1118_ = _e576.rest.z;
                                            phi_1119_ = _e817;
                                            phi_1120_ = _e547;
                                        } else {
                                            if (_e817 == 0u) {
                                                phi_1115_ = _e578;
                                                phi_1116_ = _e547;
                                            } else {
                                                if ((_e578 & 255u) == 0u) {
                                                    phi_1111_ = _e547;
                                                } else {
                                                    if (_e547 < 32u) {
                                                        if (_e547 < 32u) {
                                                        } else {
                                                            return;
                                                        }
                                                        local_1[(0u + _e547)] = _e578;
                                                        phi_1110_ = (_e547 + 1u);
                                                    } else {
                                                        phi_1110_ = _e547;
                                                    }
                                                    let _e833 = phi_1110_;
                                                    phi_1111_ = _e833;
                                                }
                                                let _e835 = phi_1111_;
                                                phi_1115_ = ((_e576.rest.z << bitcast<u32>(8i)) | _e817);
                                                phi_1116_ = _e835;
                                            }
                                            let _e842 = phi_1115_;
                                            let _e844 = phi_1116_;
                                            phi_1117_ = _e842;
                                            phi_1118_ = _e543;
                                            phi_1119_ = _e545;
                                            phi_1120_ = _e844;
                                        }
                                        let _e846 = phi_1117_;
                                        let _e848 = phi_1118_;
                                        let _e850 = phi_1119_;
                                        let _e852 = phi_1120_;
                                        if ((_e846 & 255u) == 0u) {
                                            if (_e852 > 0u) {
                                                let _e856 = (_e852 - 1u);
                                                if (_e856 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e860 = local_1[(0u + _e856)];
                                                phi_1138_ = _e860;
                                                phi_1139_ = _e856;
                                            } else {
                                                phi_1138_ = 0u;
                                                phi_1139_ = _e852;
                                            }
                                            let _e862 = phi_1138_;
                                            let _e864 = phi_1139_;
                                            phi_1140_ = _e862;
                                            phi_1141_ = _e864;
                                        } else {
                                            phi_1140_ = _e846;
                                            phi_1141_ = _e852;
                                        }
                                        let _e866 = phi_1140_;
                                        let _e868 = phi_1141_;
                                        phi_1142_ = _e866;
                                        phi_1143_ = _e848;
                                        phi_1144_ = _e850;
                                        phi_1145_ = _e868;
                                    } else {
                                        phi_1142_ = u32();
                                        phi_1143_ = u32();
                                        phi_1144_ = u32();
                                        phi_1145_ = u32();
                                    }
                                    let _e870 = phi_1142_;
                                    let _e872 = phi_1143_;
                                    let _e874 = phi_1144_;
                                    let _e876 = phi_1145_;
                                    phi_793_ = _e870;
                                    phi_796_ = _e872;
                                    phi_798_ = _e874;
                                    phi_800_ = _e876;
                                    phi_1146_ = _e549;
                                }
                                let _e878 = phi_793_;
                                let _e880 = phi_796_;
                                let _e882 = phi_798_;
                                let _e884 = phi_800_;
                                let _e886 = phi_1146_;
                                continue;
                                continuing {
                                    phi_792_ = _e878;
                                    phi_795_ = _e880;
                                    phi_797_ = _e882;
                                    phi_799_ = _e884;
                                    break if !(_e886);
                                }
                            }
                            let _e889 = local_2;
                            if _e889 {
                            }
                            let _e3061 = local_11;
                            phi_1151_ = _e3061;
                            loop {
                                let _e891 = phi_1151_;
                                let _e892 = (_e891 == 0u);
                                local_4 = _e892;
                                local_16 = _e892;
                                if _e892 {
                                    phi_1152_ = u32();
                                    phi_1800_ = false;
                                    phi_1801_ = false;
                                    phi_1802_ = false;
                                } else {
                                    let _e895 = select(firstTrailingBit(_e891), 32u, (_e891 == 0u));
                                    let _e899 = local_3;
                                    let _e900 = (_e899 + (_e895 >> bitcast<u32>(2i)));
                                    if (_e900 < _e91) {
                                    } else {
                                        return;
                                    }
                                    let _e905 = rows.member[(0u + _e900)][0u];
                                    let _e909 = rows.member[(0u + _e900)][1u];
                                    let _e913 = rows.member[(0u + _e900)][2u];
                                    let _e917 = rows.member[(0u + _e900)][3u];
                                    if ((_e895 & 2u) == 0u) {
                                        phi_1190_ = _e909;
                                        phi_1191_ = _e905;
                                    } else {
                                        phi_1190_ = _e917;
                                        phi_1191_ = _e913;
                                    }
                                    let _e921 = phi_1190_;
                                    let _e923 = phi_1191_;
                                    if ((_e895 & 1u) == 0u) {
                                        phi_1197_ = _e923;
                                    } else {
                                        phi_1197_ = _e921;
                                    }
                                    let _e927 = phi_1197_;
                                    if (_e927 < _e79) {
                                    } else {
                                        return;
                                    }
                                    let _e934 = triangles.member[(0u + _e927)].v0_;
                                    let _e936 = (_e934.x - _e126);
                                    let _e938 = (_e934.y - _e128);
                                    let _e940 = (_e934.z - _e130);
                                    if (_e515 == 0u) {
                                        phi_1227_ = vec3<f32>(_e938, _e940, _e936);
                                    } else {
                                        if (_e515 == 1u) {
                                            phi_1226_ = vec3<f32>(_e940, _e936, _e938);
                                        } else {
                                            phi_1226_ = (_e934 - vec3<f32>(_e126, _e128, _e130));
                                        }
                                        let _e948 = phi_1226_;
                                        phi_1227_ = _e948;
                                    }
                                    let _e950 = phi_1227_;
                                    let _e954 = (_e950.x - (_e526 * _e950.z));
                                    let _e958 = (_e950.y - (_e529 * _e950.z));
                                    let _e960 = triangles.member[(0u + _e927)].v1_;
                                    let _e962 = (_e960.x - _e126);
                                    let _e964 = (_e960.y - _e128);
                                    let _e966 = (_e960.z - _e130);
                                    if (_e515 == 0u) {
                                        phi_1257_ = vec3<f32>(_e964, _e966, _e962);
                                    } else {
                                        if (_e515 == 1u) {
                                            phi_1256_ = vec3<f32>(_e966, _e962, _e964);
                                        } else {
                                            phi_1256_ = (_e960 - vec3<f32>(_e126, _e128, _e130));
                                        }
                                        let _e974 = phi_1256_;
                                        phi_1257_ = _e974;
                                    }
                                    let _e976 = phi_1257_;
                                    let _e980 = (_e976.x - (_e526 * _e976.z));
                                    let _e984 = (_e976.y - (_e529 * _e976.z));
                                    let _e986 = triangles.member[(0u + _e927)].v2_;
                                    let _e988 = (_e986.x - _e126);
                                    let _e990 = (_e986.y - _e128);
                                    let _e992 = (_e986.z - _e130);
                                    if (_e515 == 0u) {
                                        phi_1287_ = vec3<f32>(_e990, _e992, _e988);
                                    } else {
                                        if (_e515 == 1u) {
                                            phi_1286_ = vec3<f32>(_e992, _e988, _e990);
                                        } else {
                                            phi_1286_ = (_e986 - vec3<f32>(_e126, _e128, _e130));
                                        }
                                        let _e1000 = phi_1286_;
                                        phi_1287_ = _e1000;
                                    }
                                    let _e1002 = phi_1287_;
                                    let _e1006 = (_e1002.x - (_e526 * _e1002.z));
                                    let _e1010 = (_e1002.y - (_e529 * _e1002.z));
                                    if (_e980 < _e1006) {
                                        phi_1306_ = true;
                                    } else {
                                        if (_e980 == _e1006) {
                                            phi_1305_ = (_e984 < _e1010);
                                        } else {
                                            phi_1305_ = false;
                                        }
                                        let _e1015 = phi_1305_;
                                        phi_1306_ = _e1015;
                                    }
                                    let _e1017 = phi_1306_;
                                    if _e1017 {
                                        phi_1310_ = _e1010;
                                        phi_1311_ = _e1006;
                                        phi_1312_ = _e984;
                                        phi_1313_ = _e980;
                                    } else {
                                        phi_1310_ = _e984;
                                        phi_1311_ = _e980;
                                        phi_1312_ = _e1010;
                                        phi_1313_ = _e1006;
                                    }
                                    let _e1019 = phi_1310_;
                                    let _e1021 = phi_1311_;
                                    let _e1023 = phi_1312_;
                                    let _e1025 = phi_1313_;
                                    let _e1028 = ((_e1025 * _e1019) - (_e1023 * _e1021));
                                    if _e1017 {
                                        phi_1321_ = -(_e1028);
                                    } else {
                                        phi_1321_ = _e1028;
                                    }
                                    let _e1031 = phi_1321_;
                                    if (_e1006 < _e954) {
                                        phi_1332_ = true;
                                    } else {
                                        if (_e1006 == _e954) {
                                            phi_1331_ = (_e1010 < _e958);
                                        } else {
                                            phi_1331_ = false;
                                        }
                                        let _e1036 = phi_1331_;
                                        phi_1332_ = _e1036;
                                    }
                                    let _e1038 = phi_1332_;
                                    if _e1038 {
                                        phi_1336_ = _e958;
                                        phi_1337_ = _e954;
                                        phi_1338_ = _e1010;
                                        phi_1339_ = _e1006;
                                    } else {
                                        phi_1336_ = _e1010;
                                        phi_1337_ = _e1006;
                                        phi_1338_ = _e958;
                                        phi_1339_ = _e954;
                                    }
                                    let _e1040 = phi_1336_;
                                    let _e1042 = phi_1337_;
                                    let _e1044 = phi_1338_;
                                    let _e1046 = phi_1339_;
                                    let _e1049 = ((_e1046 * _e1040) - (_e1044 * _e1042));
                                    if _e1038 {
                                        phi_1347_ = -(_e1049);
                                    } else {
                                        phi_1347_ = _e1049;
                                    }
                                    let _e1052 = phi_1347_;
                                    if (_e954 < _e980) {
                                        phi_1358_ = true;
                                    } else {
                                        if (_e954 == _e980) {
                                            phi_1357_ = (_e958 < _e984);
                                        } else {
                                            phi_1357_ = false;
                                        }
                                        let _e1057 = phi_1357_;
                                        phi_1358_ = _e1057;
                                    }
                                    let _e1059 = phi_1358_;
                                    if _e1059 {
                                        phi_1362_ = _e984;
                                        phi_1363_ = _e980;
                                        phi_1364_ = _e958;
                                        phi_1365_ = _e954;
                                    } else {
                                        phi_1362_ = _e958;
                                        phi_1363_ = _e954;
                                        phi_1364_ = _e984;
                                        phi_1365_ = _e980;
                                    }
                                    let _e1061 = phi_1362_;
                                    let _e1063 = phi_1363_;
                                    let _e1065 = phi_1364_;
                                    let _e1067 = phi_1365_;
                                    let _e1070 = ((_e1067 * _e1061) - (_e1065 * _e1063));
                                    if _e1059 {
                                        phi_1373_ = -(_e1070);
                                    } else {
                                        phi_1373_ = _e1070;
                                    }
                                    let _e1073 = phi_1373_;
                                    if (_e1031 >= 0f) {
                                        if (_e1052 >= 0f) {
                                            if (_e1073 >= 0f) {
                                                phi_1388_ = ((_e1031 + _e1052) + _e1073);
                                                phi_1389_ = false;
                                            } else {
                                                phi_1388_ = f32();
                                                phi_1389_ = true;
                                            }
                                            let _e1080 = phi_1388_;
                                            let _e1082 = phi_1389_;
                                            phi_1390_ = _e1080;
                                            phi_1391_ = _e1082;
                                        } else {
                                            phi_1390_ = f32();
                                            phi_1391_ = true;
                                        }
                                        let _e1084 = phi_1390_;
                                        let _e1086 = phi_1391_;
                                        phi_1392_ = _e1084;
                                        phi_1393_ = _e1086;
                                    } else {
                                        phi_1392_ = f32();
                                        phi_1393_ = true;
                                    }
                                    let _e1088 = phi_1392_;
                                    let _e1090 = phi_1393_;
                                    if _e1090 {
                                        if (_e1031 <= 0f) {
                                            if (_e1052 <= 0f) {
                                                let _e1093 = (_e1073 <= 0f);
                                                if _e1093 {
                                                }
                                                phi_1411_ = ((_e1031 + _e1052) + _e1073);
                                                phi_1412_ = false;
                                                phi_1413_ = _e1093;
                                            } else {
                                                phi_1411_ = f32();
                                                phi_1412_ = true;
                                                phi_1413_ = false;
                                            }
                                            let _e1097 = phi_1411_;
                                            let _e1099 = phi_1412_;
                                            let _e1101 = phi_1413_;
                                            phi_1414_ = _e1097;
                                            phi_1415_ = _e1099;
                                            phi_1416_ = _e1101;
                                        } else {
                                            phi_1414_ = f32();
                                            phi_1415_ = true;
                                            phi_1416_ = false;
                                        }
                                        let _e1103 = phi_1414_;
                                        let _e1105 = phi_1415_;
                                        let _e1107 = phi_1416_;
                                        if _e1105 {
                                            phi_1420_ = false;
                                        } else {
                                            phi_1420_ = _e1107;
                                        }
                                        let _e1109 = phi_1420_;
                                        phi_1421_ = _e1103;
                                        phi_1422_ = _e1109;
                                    } else {
                                        phi_1421_ = _e1088;
                                        phi_1422_ = true;
                                    }
                                    let _e1111 = phi_1421_;
                                    let _e1113 = phi_1422_;
                                    if _e1113 {
                                        let _e1114 = (_e1111 == 0f);
                                        if _e1114 {
                                            phi_1738_ = lt_bvh_triangle_Intersection();
                                            phi_1739_ = false;
                                        } else {
                                            let _e1116 = triangles.member[(0u + _e927)].v0_;
                                            let _e1118 = (_e1116.x - _e126);
                                            let _e1120 = (_e1116.y - _e128);
                                            let _e1122 = (_e1116.z - _e130);
                                            if (_e515 == 0u) {
                                                phi_1451_ = vec3<f32>(_e1120, _e1122, _e1118);
                                            } else {
                                                if (_e515 == 1u) {
                                                    phi_1450_ = vec3<f32>(_e1122, _e1118, _e1120);
                                                } else {
                                                    phi_1450_ = (_e1116 - vec3<f32>(_e126, _e128, _e130));
                                                }
                                                let _e1130 = phi_1450_;
                                                phi_1451_ = _e1130;
                                            }
                                            let _e1132 = phi_1451_;
                                            let _e1134 = triangles.member[(0u + _e927)].v1_;
                                            let _e1136 = triangles.member[(0u + _e927)].v0_;
                                            let _e1139 = (_e1134.x - _e1136.x);
                                            let _e1142 = (_e1134.y - _e1136.y);
                                            let _e1145 = (_e1134.z - _e1136.z);
                                            if (_e515 == 0u) {
                                                phi_1477_ = vec3<f32>(_e1142, _e1145, _e1139);
                                            } else {
                                                if (_e515 == 1u) {
                                                    phi_1476_ = vec3<f32>(_e1145, _e1139, _e1142);
                                                } else {
                                                    phi_1476_ = (_e1134 - _e1136);
                                                }
                                                let _e1152 = phi_1476_;
                                                phi_1477_ = _e1152;
                                            }
                                            let _e1154 = phi_1477_;
                                            let _e1156 = triangles.member[(0u + _e927)].v2_;
                                            let _e1158 = triangles.member[(0u + _e927)].v0_;
                                            let _e1161 = (_e1156.x - _e1158.x);
                                            let _e1164 = (_e1156.y - _e1158.y);
                                            let _e1167 = (_e1156.z - _e1158.z);
                                            if (_e515 == 0u) {
                                                phi_1503_ = vec3<f32>(_e1164, _e1167, _e1161);
                                            } else {
                                                if (_e515 == 1u) {
                                                    phi_1502_ = vec3<f32>(_e1167, _e1161, _e1164);
                                                } else {
                                                    phi_1502_ = (_e1156 - _e1158);
                                                }
                                                let _e1174 = phi_1502_;
                                                phi_1503_ = _e1174;
                                            }
                                            let _e1176 = phi_1503_;
                                            let _e1183 = ((_e1154.y * _e1176.z) - (_e1154.z * _e1176.y));
                                            let _e1190 = ((_e1154.z * _e1176.x) - (_e1154.x * _e1176.z));
                                            let _e1197 = ((_e1154.x * _e1176.y) - (_e1154.y * _e1176.x));
                                            let _e1211 = (((1f / _e523.z) * (((_e1183 * _e1132.x) + (_e1190 * _e1132.y)) + (_e1197 * _e1132.z))) / (((_e1183 * _e526) + (_e1190 * _e529)) + _e1197));
                                            if (_e1211 > 0f) {
                                                if (_e1211 < _e138) {
                                                    let _e1215 = triangles.member[(0u + _e927)].v0_;
                                                    let _e1217 = triangles.member[(0u + _e927)].v1_;
                                                    if (_e1215.x < _e1217.x) {
                                                        phi_1559_ = _e1215.x;
                                                    } else {
                                                        phi_1559_ = _e1217.x;
                                                    }
                                                    let _e1224 = phi_1559_;
                                                    if (_e1215.y < _e1217.y) {
                                                        phi_1568_ = _e1215.y;
                                                    } else {
                                                        phi_1568_ = _e1217.y;
                                                    }
                                                    let _e1231 = phi_1568_;
                                                    if (_e1215.z < _e1217.z) {
                                                        phi_1577_ = _e1215.z;
                                                    } else {
                                                        phi_1577_ = _e1217.z;
                                                    }
                                                    let _e1238 = phi_1577_;
                                                    let _e1240 = triangles.member[(0u + _e927)].v2_;
                                                    if (_e1224 < _e1240.x) {
                                                        phi_1586_ = _e1224;
                                                    } else {
                                                        phi_1586_ = _e1240.x;
                                                    }
                                                    let _e1245 = phi_1586_;
                                                    if (_e1231 < _e1240.y) {
                                                        phi_1593_ = _e1231;
                                                    } else {
                                                        phi_1593_ = _e1240.y;
                                                    }
                                                    let _e1250 = phi_1593_;
                                                    if (_e1238 < _e1240.z) {
                                                        phi_1600_ = _e1238;
                                                    } else {
                                                        phi_1600_ = _e1240.z;
                                                    }
                                                    let _e1255 = phi_1600_;
                                                    let _e1257 = triangles.member[(0u + _e927)].v0_;
                                                    let _e1259 = triangles.member[(0u + _e927)].v1_;
                                                    if (_e1257.x > _e1259.x) {
                                                        phi_1613_ = _e1257.x;
                                                    } else {
                                                        phi_1613_ = _e1259.x;
                                                    }
                                                    let _e1266 = phi_1613_;
                                                    if (_e1257.y > _e1259.y) {
                                                        phi_1622_ = _e1257.y;
                                                    } else {
                                                        phi_1622_ = _e1259.y;
                                                    }
                                                    let _e1273 = phi_1622_;
                                                    if (_e1257.z > _e1259.z) {
                                                        phi_1631_ = _e1257.z;
                                                    } else {
                                                        phi_1631_ = _e1259.z;
                                                    }
                                                    let _e1280 = phi_1631_;
                                                    let _e1282 = triangles.member[(0u + _e927)].v2_;
                                                    if (_e1266 > _e1282.x) {
                                                        phi_1640_ = _e1266;
                                                    } else {
                                                        phi_1640_ = _e1282.x;
                                                    }
                                                    let _e1287 = phi_1640_;
                                                    if (_e1273 > _e1282.y) {
                                                        phi_1647_ = _e1273;
                                                    } else {
                                                        phi_1647_ = _e1282.y;
                                                    }
                                                    let _e1292 = phi_1647_;
                                                    if (_e1280 > _e1282.z) {
                                                        phi_1654_ = _e1280;
                                                    } else {
                                                        phi_1654_ = _e1282.z;
                                                    }
                                                    let _e1297 = phi_1654_;
                                                    let _e1301 = ((_e1245 - _e126) * _e444);
                                                    let _e1302 = ((_e1250 - _e128) * _e454);
                                                    let _e1303 = ((_e1255 - _e130) * _e464);
                                                    let _e1307 = ((_e1287 - _e126) * _e444);
                                                    let _e1308 = ((_e1292 - _e128) * _e454);
                                                    let _e1309 = ((_e1297 - _e130) * _e464);
                                                    if (_e1301 < _e1307) {
                                                        phi_1671_ = _e1301;
                                                    } else {
                                                        phi_1671_ = _e1307;
                                                    }
                                                    let _e1312 = phi_1671_;
                                                    if (_e1302 < _e1308) {
                                                        phi_1676_ = _e1302;
                                                    } else {
                                                        phi_1676_ = _e1308;
                                                    }
                                                    let _e1315 = phi_1676_;
                                                    if (_e1303 < _e1309) {
                                                        phi_1681_ = _e1303;
                                                    } else {
                                                        phi_1681_ = _e1309;
                                                    }
                                                    let _e1318 = phi_1681_;
                                                    if (_e1301 > _e1307) {
                                                        phi_1689_ = _e1301;
                                                    } else {
                                                        phi_1689_ = _e1307;
                                                    }
                                                    let _e1324 = phi_1689_;
                                                    if (_e1302 > _e1308) {
                                                        phi_1694_ = _e1302;
                                                    } else {
                                                        phi_1694_ = _e1308;
                                                    }
                                                    let _e1327 = phi_1694_;
                                                    if (_e1303 > _e1309) {
                                                        phi_1699_ = _e1303;
                                                    } else {
                                                        phi_1699_ = _e1309;
                                                    }
                                                    let _e1330 = phi_1699_;
                                                    let _e1334 = core_intrinsics_maximum_number_nsz_f32_((_e1312 - _e499), (_e1315 - _e500));
                                                    let _e1335 = core_intrinsics_maximum_number_nsz_f32_(_e1334, (_e1318 - _e501));
                                                    let _e1336 = core_intrinsics_minimum_number_nsz_f32_((_e1324 + _e499), (_e1327 + _e500));
                                                    let _e1337 = core_intrinsics_minimum_number_nsz_f32_(_e1336, (_e1330 + _e501));
                                                    if (_e1335 > -300000000000000000000000000000000000000f) {
                                                        phi_1711_ = _e1335;
                                                    } else {
                                                        phi_1711_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1340 = phi_1711_;
                                                    if (_e1337 < 300000000000000000000000000000000000000f) {
                                                        phi_1716_ = _e1337;
                                                    } else {
                                                        phi_1716_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1343 = phi_1716_;
                                                    if (_e1211 < _e1340) {
                                                        phi_1721_ = _e1340;
                                                    } else {
                                                        phi_1721_ = _e1211;
                                                    }
                                                    let _e1346 = phi_1721_;
                                                    if (_e1346 > _e1343) {
                                                        phi_1726_ = _e1343;
                                                    } else {
                                                        phi_1726_ = _e1346;
                                                    }
                                                    let _e1349 = phi_1726_;
                                                    phi_1731_ = lt_bvh_triangle_Intersection(_e1349, (_e1052 / _e1111), (_e1073 / _e1111), (_e1340 <= _e1343));
                                                    phi_1732_ = false;
                                                } else {
                                                    phi_1731_ = lt_bvh_triangle_Intersection();
                                                    phi_1732_ = true;
                                                }
                                                let _e1355 = phi_1731_;
                                                let _e1357 = phi_1732_;
                                                phi_1733_ = _e1355;
                                                phi_1734_ = _e1357;
                                            } else {
                                                phi_1733_ = lt_bvh_triangle_Intersection();
                                                phi_1734_ = true;
                                            }
                                            let _e1359 = phi_1733_;
                                            let _e1361 = phi_1734_;
                                            if _e1361 {
                                            }
                                            phi_1738_ = _e1359;
                                            phi_1739_ = _e1361;
                                        }
                                        let _e1363 = phi_1738_;
                                        let _e1365 = phi_1739_;
                                        phi_1740_ = _e1363;
                                        phi_1741_ = _e1114;
                                        phi_1742_ = _e1365;
                                    } else {
                                        phi_1740_ = lt_bvh_triangle_Intersection();
                                        phi_1741_ = true;
                                        phi_1742_ = false;
                                    }
                                    let _e1367 = phi_1740_;
                                    let _e1369 = phi_1741_;
                                    let _e1371 = phi_1742_;
                                    if _e1369 {
                                        phi_1746_ = true;
                                    } else {
                                        phi_1746_ = _e1371;
                                    }
                                    let _e1373 = phi_1746_;
                                    if _e1373 {
                                        phi_1750_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1750_ = _e1367;
                                    }
                                    let _e1375 = phi_1750_;
                                    if _e1375.is_hit {
                                        if (_e1375.t > 0f) {
                                            if (_e1375.t < _e138) {
                                                let _e1382 = triangles.member[(0u + _e927)].i0_;
                                                let _e1384 = ((_e1382 & 2147483648u) == 0u);
                                                if _e1384 {
                                                    phi_1776_ = false;
                                                    phi_1777_ = false;
                                                } else {
                                                    if true {
                                                        phi_1775_ = false;
                                                    } else {
                                                        phi_1775_ = true;
                                                    }
                                                    let _e1386 = phi_1775_;
                                                    phi_1776_ = _e1386;
                                                    phi_1777_ = true;
                                                }
                                                let _e1388 = phi_1776_;
                                                let _e1390 = phi_1777_;
                                                phi_1778_ = _e1388;
                                                phi_1779_ = _e1384;
                                                phi_1780_ = _e1390;
                                            } else {
                                                phi_1778_ = true;
                                                phi_1779_ = false;
                                                phi_1780_ = false;
                                            }
                                            let _e1392 = phi_1778_;
                                            let _e1394 = phi_1779_;
                                            let _e1396 = phi_1780_;
                                            phi_1781_ = false;
                                            phi_1782_ = _e1392;
                                            phi_1783_ = _e1394;
                                            phi_1784_ = _e1396;
                                        } else {
                                            phi_1781_ = true;
                                            phi_1782_ = false;
                                            phi_1783_ = false;
                                            phi_1784_ = false;
                                        }
                                        let _e1398 = phi_1781_;
                                        let _e1400 = phi_1782_;
                                        let _e1402 = phi_1783_;
                                        let _e1404 = phi_1784_;
                                        phi_1785_ = _e1398;
                                        phi_1786_ = _e1400;
                                        phi_1787_ = _e1402;
                                        phi_1788_ = _e1404;
                                    } else {
                                        phi_1785_ = true;
                                        phi_1786_ = false;
                                        phi_1787_ = false;
                                        phi_1788_ = false;
                                    }
                                    let _e1406 = phi_1785_;
                                    let _e1408 = phi_1786_;
                                    let _e1410 = phi_1787_;
                                    let _e1412 = phi_1788_;
                                    if _e1406 {
                                        phi_1792_ = true;
                                        phi_1793_ = false;
                                        phi_1794_ = false;
                                    } else {
                                        phi_1792_ = _e1408;
                                        phi_1793_ = _e1410;
                                        phi_1794_ = _e1412;
                                    }
                                    let _e1414 = phi_1792_;
                                    let _e1416 = phi_1793_;
                                    let _e1418 = phi_1794_;
                                    if _e1414 {
                                        phi_1798_ = false;
                                        phi_1799_ = false;
                                    } else {
                                        phi_1798_ = _e1416;
                                        phi_1799_ = _e1418;
                                    }
                                    let _e1420 = phi_1798_;
                                    let _e1422 = phi_1799_;
                                    phi_1152_ = (_e891 & (_e891 - 1u));
                                    phi_1800_ = _e1414;
                                    phi_1801_ = _e1420;
                                    phi_1802_ = _e1422;
                                }
                                let _e1424 = phi_1152_;
                                let _e1426 = phi_1800_;
                                let _e1428 = phi_1801_;
                                let _e1430 = phi_1802_;
                                local_12 = _e1428;
                                local_13 = _e1430;
                                continue;
                                continuing {
                                    phi_1151_ = _e1424;
                                    break if !(_e1426);
                                }
                            }
                            let _e1433 = local_4;
                            if _e1433 {
                                phi_1806_ = false;
                                phi_1807_ = false;
                            } else {
                                let _e3173 = local_12;
                                phi_1806_ = _e3173;
                                let _e3176 = local_13;
                                phi_1807_ = _e3176;
                            }
                            let _e1435 = phi_1806_;
                            let _e1437 = phi_1807_;
                            let _e3179 = local_14;
                            phi_781_ = _e3179;
                            let _e3182 = local_15;
                            phi_784_ = _e3182;
                            let _e3185 = local_16;
                            phi_1808_ = _e3185;
                            phi_1809_ = _e1435;
                            phi_1810_ = _e1437;
                        }
                        let _e1439 = phi_781_;
                        let _e1441 = phi_784_;
                        let _e1443 = phi_1808_;
                        let _e1445 = phi_1809_;
                        let _e1447 = phi_1810_;
                        local_17 = _e1445;
                        local_18 = _e1447;
                        continue;
                        continuing {
                            phi_780_ = _e1439;
                            phi_783_ = _e1441;
                            break if !(_e1443);
                        }
                    }
                    let _e1450 = local_5;
                    if _e1450 {
                        phi_1814_ = false;
                        phi_1815_ = false;
                    } else {
                        let _e3191 = local_17;
                        phi_1814_ = _e3191;
                        let _e3194 = local_18;
                        phi_1815_ = _e3194;
                    }
                    let _e1452 = phi_1814_;
                    let _e1454 = phi_1815_;
                    if _e1452 {
                        phi_1819_ = false;
                    } else {
                        phi_1819_ = _e1454;
                    }
                    let _e1456 = phi_1819_;
                    if _e1456 {
                        phi_1823_ = true;
                    } else {
                        phi_1823_ = _e1452;
                    }
                    let _e1458 = phi_1823_;
                    if _e1458 {
                    }
                    phi_1827_ = true;
                    phi_1828_ = _e1458;
                }
                let _e1460 = phi_1827_;
                let _e1462 = phi_1828_;
                if _e1462 {
                    phi_1832_ = _e1460;
                } else {
                    phi_1832_ = false;
                }
                let _e1464 = phi_1832_;
                phi_3289_ = _e1464;
            } else {
                let _e1465 = abs(_e146);
                let _e1466 = abs(_e147);
                let _e1467 = abs(_e148);
                if (abs(_e126) < 1000000000000000f) {
                    if (abs(_e128) < 1000000000000000f) {
                        phi_1848_ = (abs(_e130) < 1000000000000000f);
                        phi_1849_ = false;
                    } else {
                        phi_1848_ = bool();
                        phi_1849_ = true;
                    }
                    let _e1475 = phi_1848_;
                    let _e1477 = phi_1849_;
                    phi_1850_ = _e1475;
                    phi_1851_ = _e1477;
                } else {
                    phi_1850_ = bool();
                    phi_1851_ = true;
                }
                let _e1479 = phi_1850_;
                let _e1481 = phi_1851_;
                if _e1481 {
                    phi_1855_ = false;
                } else {
                    phi_1855_ = _e1479;
                }
                let _e1483 = phi_1855_;
                if _e1483 {
                    if (_e1465 < 1000000000000000f) {
                        if (_e1466 < 1000000000000000f) {
                            phi_1868_ = (_e1467 < 1000000000000000f);
                            phi_1869_ = false;
                        } else {
                            phi_1868_ = bool();
                            phi_1869_ = true;
                        }
                        let _e1488 = phi_1868_;
                        let _e1490 = phi_1869_;
                        phi_1870_ = _e1488;
                        phi_1871_ = _e1490;
                    } else {
                        phi_1870_ = bool();
                        phi_1871_ = true;
                    }
                    let _e1492 = phi_1870_;
                    let _e1494 = phi_1871_;
                    if _e1494 {
                        phi_1875_ = false;
                    } else {
                        phi_1875_ = _e1492;
                    }
                    let _e1496 = phi_1875_;
                    if _e1496 {
                        if (_e1465 > 0f) {
                            phi_1889_ = bool();
                            phi_1890_ = true;
                        } else {
                            let _e1498 = (_e1466 > 0f);
                            if _e1498 {
                                phi_1888_ = bool();
                            } else {
                                phi_1888_ = (_e1467 > 0f);
                            }
                            let _e1501 = phi_1888_;
                            phi_1889_ = _e1501;
                            phi_1890_ = _e1498;
                        }
                        let _e1503 = phi_1889_;
                        let _e1505 = phi_1890_;
                        if _e1505 {
                            phi_1894_ = true;
                        } else {
                            phi_1894_ = _e1503;
                        }
                        let _e1507 = phi_1894_;
                        phi_1895_ = _e1507;
                        phi_1896_ = false;
                    } else {
                        phi_1895_ = bool();
                        phi_1896_ = true;
                    }
                    let _e1509 = phi_1895_;
                    let _e1511 = phi_1896_;
                    phi_1897_ = _e1509;
                    phi_1898_ = _e1511;
                } else {
                    phi_1897_ = bool();
                    phi_1898_ = true;
                }
                let _e1513 = phi_1897_;
                let _e1515 = phi_1898_;
                if _e1515 {
                    phi_1902_ = false;
                } else {
                    phi_1902_ = _e1513;
                }
                let _e1517 = phi_1902_;
                if _e1517 {
                    let _e1518 = (0u >= _e76);
                    if _e1518 {
                        phi_3282_ = bool();
                    } else {
                        if (0u < _e76) {
                        } else {
                            return;
                        }
                        let _e1524 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1528 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1532 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1536 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1540 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1544 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1548 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1582 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146), abs(_e147));
                        let _e1583 = core_intrinsics_maximum_number_nsz_f32_(_e1582, abs(_e148));
                        let _e1584 = (_e1583 * 0.0000000000009094947f);
                        if (abs(_e146) < _e1584) {
                            phi_1972_ = _e1584;
                        } else {
                            phi_1972_ = abs(_e146);
                        }
                        let _e1589 = phi_1972_;
                        if (_e146 < 0f) {
                            phi_1979_ = (-1f / _e1589);
                        } else {
                            phi_1979_ = (1f / _e1589);
                        }
                        let _e1594 = phi_1979_;
                        if (abs(_e147) < _e1584) {
                            phi_1986_ = _e1584;
                        } else {
                            phi_1986_ = abs(_e147);
                        }
                        let _e1599 = phi_1986_;
                        if (_e147 < 0f) {
                            phi_1993_ = (-1f / _e1599);
                        } else {
                            phi_1993_ = (1f / _e1599);
                        }
                        let _e1604 = phi_1993_;
                        if (abs(_e148) < _e1584) {
                            phi_2000_ = _e1584;
                        } else {
                            phi_2000_ = abs(_e148);
                        }
                        let _e1609 = phi_2000_;
                        if (_e148 < 0f) {
                            phi_2007_ = (-1f / _e1609);
                        } else {
                            phi_2007_ = (1f / _e1609);
                        }
                        let _e1614 = phi_2007_;
                        let _e1618 = abs((bitcast<f32>(_e1524) - _e126));
                        let _e1619 = abs((bitcast<f32>(_e1528) - _e128));
                        let _e1620 = abs((bitcast<f32>(_e1532) - _e130));
                        let _e1624 = abs(((bitcast<f32>(_e1536) + (bitcast<f32>((((_e1548 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                        let _e1625 = abs(((bitcast<f32>(_e1540) + (bitcast<f32>((((_e1548 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                        let _e1626 = abs(((bitcast<f32>(_e1544) + (bitcast<f32>((((_e1548 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                        if (_e1618 > _e1624) {
                            phi_2024_ = _e1618;
                        } else {
                            phi_2024_ = _e1624;
                        }
                        let _e1629 = phi_2024_;
                        if (_e1619 > _e1625) {
                            phi_2029_ = _e1619;
                        } else {
                            phi_2029_ = _e1625;
                        }
                        let _e1632 = phi_2029_;
                        if (_e1620 > _e1626) {
                            phi_2034_ = _e1620;
                        } else {
                            phi_2034_ = _e1626;
                        }
                        let _e1635 = phi_2034_;
                        if (_e1629 > _e1632) {
                            phi_2039_ = _e1629;
                        } else {
                            phi_2039_ = _e1632;
                        }
                        let _e1638 = phi_2039_;
                        if (_e1638 > _e1635) {
                            phi_2044_ = _e1638;
                        } else {
                            phi_2044_ = _e1635;
                        }
                        let _e1641 = phi_2044_;
                        let _e1645 = (_e1641 * 0.0000019073486f);
                        let _e1646 = (abs(_e1594) * _e1645);
                        let _e1647 = (abs(_e1604) * _e1645);
                        let _e1648 = (abs(_e1614) * _e1645);
                        let _e1652 = (_e1641 * 0.0000009536743f);
                        let _e1653 = (abs(_e1594) * _e1652);
                        let _e1654 = (abs(_e1604) * _e1652);
                        let _e1655 = (abs(_e1614) * _e1652);
                        let _e1656 = abs(_e146);
                        let _e1657 = abs(_e147);
                        let _e1658 = abs(_e148);
                        if (_e1656 >= _e1657) {
                            if (_e1656 >= _e1658) {
                                phi_2070_ = false;
                            } else {
                                phi_2070_ = true;
                            }
                            let _e1662 = phi_2070_;
                            phi_2071_ = _e1662;
                        } else {
                            phi_2071_ = true;
                        }
                        let _e1664 = phi_2071_;
                        if _e1664 {
                            if (_e1657 >= _e1658) {
                                phi_2079_ = 1u;
                            } else {
                                phi_2079_ = 2u;
                            }
                            let _e1667 = phi_2079_;
                            phi_2080_ = _e1667;
                        } else {
                            phi_2080_ = 0u;
                        }
                        let _e1669 = phi_2080_;
                        if (_e1669 == 0u) {
                            phi_2092_ = vec3<f32>(_e147, _e148, _e146);
                        } else {
                            if (_e1669 == 1u) {
                                phi_2091_ = vec3<f32>(_e148, _e146, _e147);
                            } else {
                                phi_2091_ = _e149;
                            }
                            let _e1675 = phi_2091_;
                            phi_2092_ = _e1675;
                        }
                        let _e1677 = phi_2092_;
                        let _e1680 = (_e1677.x / _e1677.z);
                        let _e1683 = (_e1677.y / _e1677.z);
                        if (_e1594 < 0f) {
                            phi_2105_ = 0u;
                        } else {
                            phi_2105_ = 1u;
                        }
                        let _e1688 = phi_2105_;
                        if (_e1604 < 0f) {
                            phi_2110_ = 0u;
                        } else {
                            phi_2110_ = 2u;
                        }
                        let _e1691 = phi_2110_;
                        if (_e1614 < 0f) {
                            phi_2115_ = 0u;
                        } else {
                            phi_2115_ = 4u;
                        }
                        let _e1694 = phi_2115_;
                        let _e1696 = ((_e1688 | _e1691) | _e1694);
                        let _e1697 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1697.first[0], _e1697.first[1], _e1697.first[2], _e1697.first[3], _e1697.first[4], _e1697.first[5], _e1697.first[6], _e1697.first[7], _e1697.first[8], _e1697.first[9], _e1697.first[10], _e1697.first[11], _e1697.first[12], _e1697.first[13], _e1697.first[14], _e1697.first[15], _e1697.first[16], _e1697.first[17], _e1697.first[18], _e1697.first[19], _e1697.first[20], _e1697.first[21], _e1697.first[22], _e1697.first[23], _e1697.first[24], _e1697.first[25], _e1697.first[26], _e1697.first[27], _e1697.first[28], _e1697.first[29], _e1697.first[30], _e1697.first[31]), array<u32, 32>(_e1697.mask[0], _e1697.mask[1], _e1697.mask[2], _e1697.mask[3], _e1697.mask[4], _e1697.mask[5], _e1697.mask[6], _e1697.mask[7], _e1697.mask[8], _e1697.mask[9], _e1697.mask[10], _e1697.mask[11], _e1697.mask[12], _e1697.mask[13], _e1697.mask[14], _e1697.mask[15], _e1697.mask[16], _e1697.mask[17], _e1697.mask[18], _e1697.mask[19], _e1697.mask[20], _e1697.mask[21], _e1697.mask[22], _e1697.mask[23], _e1697.mask[24], _e1697.mask[25], _e1697.mask[26], _e1697.mask[27], _e1697.mask[28], _e1697.mask[29], _e1697.mask[30], _e1697.mask[31]), _e1697.len, _e1697.group, _e1697.group_mask);
                        let _e1771 = local.group_mask;
                        if ((_e1771 & 4278190080u) == 0u) {
                            let _e1775 = local.len;
                            if (_e1775 == 0u) {
                                phi_2229_ = false;
                            } else {
                                let _e1779 = local.len;
                                local.len = (_e1779 - 1u);
                                let _e1782 = local.len;
                                if (_e1782 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1787 = local.first[(0u + _e1782)];
                                local.group = _e1787;
                                let _e1790 = local.len;
                                if (_e1790 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1795 = local.mask[(0u + _e1790)];
                                local.group_mask = _e1795;
                                phi_2229_ = true;
                            }
                            let _e1798 = phi_2229_;
                            phi_2230_ = _e1798;
                        } else {
                            phi_2230_ = true;
                        }
                        let _e1800 = phi_2230_;
                        if _e1800 {
                            let _e1802 = local.group_mask;
                            let _e1808 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1802)), 32u, (_e1802 == 0u)));
                            let _e1812 = local.group_mask;
                            let _e1826 = local.group_mask;
                            local.group_mask = (_e1826 & ~((1u << bitcast<u32>((_e1808 & 31u)))));
                            let _e1829 = local.group;
                            phi_2261_ = (_e1829 + countOneBits(((_e1812 & ~((4294967295u << bitcast<u32>((((_e1808 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2261_ = 4294967295u;
                        }
                        let _e1832 = phi_2261_;
                        phi_2263_ = _e1832;
                        phi_2266_ = false;
                        loop {
                            let _e1834 = phi_2263_;
                            let _e1836 = phi_2266_;
                            local_21 = _e1836;
                            if (_e1834 != 4294967295u) {
                                if (_e1834 < _e76) {
                                } else {
                                    return;
                                }
                                let _e1843 = nodes.member[(0u + _e1834)].frame[3u];
                                let _e1868 = (bitcast<f32>((((_e1843 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1594);
                                let _e1869 = (bitcast<f32>((((_e1843 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1604);
                                let _e1870 = (bitcast<f32>((((_e1843 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1614);
                                let _e1873 = nodes.member[(0u + _e1834)].frame[0u];
                                let _e1877 = nodes.member[(0u + _e1834)].frame[1u];
                                let _e1881 = nodes.member[(0u + _e1834)].frame[2u];
                                let _e1886 = ((bitcast<f32>(_e1873) - _e126) * _e1594);
                                let _e1887 = ((bitcast<f32>(_e1877) - _e128) * _e1604);
                                let _e1888 = ((bitcast<f32>(_e1881) - _e130) * _e1614);
                                let _e1896 = nodes.member[(0u + _e1834)].x;
                                if (_e1594 < 0f) {
                                    let _e1907 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1896.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1913 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1907.unnamed.word, _e1896.w), _e1907.unnamed_1);
                                    let _e1919 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1913.unnamed, lt_mask_LightPlace(_e1896.x, _e1913.unnamed_1.shift));
                                    phi_2346_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1919.unnamed, lt_mask_LightPlace(_e1919.unnamed_1.word, _e1896.y));
                                } else {
                                    let _e1935 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1896.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1941 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1935.unnamed.word, _e1896.y), _e1935.unnamed_1);
                                    let _e1947 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1941.unnamed, lt_mask_LightPlace(_e1896.z, _e1941.unnamed_1.shift));
                                    phi_2346_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1947.unnamed, lt_mask_LightPlace(_e1947.unnamed_1.word, _e1896.w));
                                }
                                let _e1955 = phi_2346_;
                                let _e1965 = nodes.member[(0u + _e1834)].y;
                                if (_e1604 < 0f) {
                                    let _e1976 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1965.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1982 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1976.unnamed.word, _e1965.w), _e1976.unnamed_1);
                                    let _e1988 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1982.unnamed, lt_mask_LightPlace(_e1965.x, _e1982.unnamed_1.shift));
                                    phi_2373_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1988.unnamed, lt_mask_LightPlace(_e1988.unnamed_1.word, _e1965.y));
                                } else {
                                    let _e2004 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1965.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2010 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2004.unnamed.word, _e1965.y), _e2004.unnamed_1);
                                    let _e2016 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2010.unnamed, lt_mask_LightPlace(_e1965.z, _e2010.unnamed_1.shift));
                                    phi_2373_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2016.unnamed, lt_mask_LightPlace(_e2016.unnamed_1.word, _e1965.w));
                                }
                                let _e2024 = phi_2373_;
                                let _e2034 = nodes.member[(0u + _e1834)].z;
                                if (_e1614 < 0f) {
                                    let _e2045 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2034.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2051 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2045.unnamed.word, _e2034.w), _e2045.unnamed_1);
                                    let _e2057 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2051.unnamed, lt_mask_LightPlace(_e2034.x, _e2051.unnamed_1.shift));
                                    phi_2400_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2057.unnamed, lt_mask_LightPlace(_e2057.unnamed_1.word, _e2034.y));
                                } else {
                                    let _e2073 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2034.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2079 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2073.unnamed.word, _e2034.y), _e2073.unnamed_1);
                                    let _e2085 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2079.unnamed, lt_mask_LightPlace(_e2034.z, _e2079.unnamed_1.shift));
                                    phi_2400_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2085.unnamed, lt_mask_LightPlace(_e2085.unnamed_1.word, _e2034.w));
                                }
                                let _e2093 = phi_2400_;
                                phi_2406_ = 0u;
                                phi_2409_ = 0u;
                                loop {
                                    let _e2103 = phi_2406_;
                                    let _e2105 = phi_2409_;
                                    local_6 = _e2105;
                                    local_7 = _e2105;
                                    local_8 = _e2105;
                                    let _e2106 = (_e2103 < 8u);
                                    if _e2106 {
                                        let _e2108 = (_e2103 >> bitcast<u32>(2i));
                                        let _e2109 = (_e2103 & 3u);
                                        if (_e2108 == 0u) {
                                            phi_2423_ = _e1955.unnamed.word;
                                        } else {
                                            phi_2423_ = _e1955.unnamed.shift;
                                        }
                                        let _e2112 = phi_2423_;
                                        if (_e2108 == 0u) {
                                            phi_2433_ = _e2024.unnamed.word;
                                        } else {
                                            phi_2433_ = _e2024.unnamed.shift;
                                        }
                                        let _e2121 = phi_2433_;
                                        if (_e2108 == 0u) {
                                            phi_2443_ = _e2093.unnamed.word;
                                        } else {
                                            phi_2443_ = _e2093.unnamed.shift;
                                        }
                                        let _e2130 = phi_2443_;
                                        let _e2143 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2112 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u)) * _e1868) + (_e1886 - _e1646)), ((f32(((_e2121 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u)) * _e1869) + (_e1887 - _e1647)));
                                        let _e2144 = core_intrinsics_maximum_number_nsz_f32_(_e2143, ((f32(((_e2130 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u)) * _e1870) + (_e1888 - _e1648)));
                                        if (_e2108 == 0u) {
                                            phi_2461_ = _e1955.unnamed_1.word;
                                        } else {
                                            phi_2461_ = _e1955.unnamed_1.shift;
                                        }
                                        let _e2147 = phi_2461_;
                                        if (_e2108 == 0u) {
                                            phi_2471_ = _e2024.unnamed_1.word;
                                        } else {
                                            phi_2471_ = _e2024.unnamed_1.shift;
                                        }
                                        let _e2156 = phi_2471_;
                                        if (_e2108 == 0u) {
                                            phi_2481_ = _e2093.unnamed_1.word;
                                        } else {
                                            phi_2481_ = _e2093.unnamed_1.shift;
                                        }
                                        let _e2165 = phi_2481_;
                                        let _e2178 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2147 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u)) * _e1868) + (_e1886 + _e1646)), ((f32(((_e2156 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u)) * _e1869) + (_e1887 + _e1647)));
                                        let _e2179 = core_intrinsics_minimum_number_nsz_f32_(_e2178, ((f32(((_e2165 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u)) * _e1870) + (_e1888 + _e1648)));
                                        if (_e2144 <= _e2179) {
                                            if (_e2144 <= _e138) {
                                                if (_e2179 >= 0f) {
                                                    if (_e2108 == 0u) {
                                                        let _e2186 = nodes.member[(0u + _e1834)].links[2u];
                                                        phi_2517_ = _e2186;
                                                    } else {
                                                        let _e2189 = nodes.member[(0u + _e1834)].links[3u];
                                                        phi_2517_ = _e2189;
                                                    }
                                                    let _e2191 = phi_2517_;
                                                    let _e2196 = ((_e2191 >> bitcast<u32>(((_e2109 * 8u) & 31u))) & 255u);
                                                    let _e2197 = (_e2196 & 31u);
                                                    if (_e2197 >= 24u) {
                                                        phi_2530_ = (24u + ((_e2197 - 24u) ^ _e1696));
                                                    } else {
                                                        phi_2530_ = _e2197;
                                                    }
                                                    let _e2203 = phi_2530_;
                                                    phi_2535_ = (_e2105 | ((_e2196 >> bitcast<u32>(5i)) << bitcast<u32>((_e2203 & 31u))));
                                                } else {
                                                    phi_2535_ = _e2105;
                                                }
                                                let _e2211 = phi_2535_;
                                                phi_2536_ = _e2211;
                                            } else {
                                                phi_2536_ = _e2105;
                                            }
                                            let _e2213 = phi_2536_;
                                            phi_2537_ = _e2213;
                                        } else {
                                            phi_2537_ = _e2105;
                                        }
                                        let _e2215 = phi_2537_;
                                        phi_2407_ = (_e2103 + 1u);
                                        phi_2410_ = _e2215;
                                    } else {
                                        phi_2407_ = u32();
                                        phi_2410_ = u32();
                                    }
                                    let _e2218 = phi_2407_;
                                    let _e2220 = phi_2410_;
                                    continue;
                                    continuing {
                                        phi_2406_ = _e2218;
                                        phi_2409_ = _e2220;
                                        break if !(_e2106);
                                    }
                                }
                                let _e2224 = nodes.member[(0u + _e1834)].links[0u];
                                let _e2228 = nodes.member[(0u + _e1834)].frame[3u];
                                let _e2232 = local_6;
                                if ((_e2232 & 4278190080u) == 0u) {
                                } else {
                                    let _e2236 = local.group_mask;
                                    if ((_e2236 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2240 = local.len;
                                        if (_e2240 < 32u) {
                                            let _e2243 = local.group;
                                            let _e2245 = local.len;
                                            if (_e2245 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2245)] = _e2243;
                                            let _e2251 = local.group_mask;
                                            let _e2253 = local.len;
                                            if (_e2253 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2253)] = _e2251;
                                            let _e2260 = local.len;
                                            local.len = (_e2260 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2224);
                                    let _e2264 = local_7;
                                    local.group_mask = ((_e2264 & 4278190080u) | (_e2228 >> bitcast<u32>(24i)));
                                }
                                let _e2269 = local_8;
                                phi_2595_ = (_e2269 & 16777215u);
                                phi_2598_ = _e1836;
                                loop {
                                    let _e2272 = phi_2595_;
                                    let _e2274 = phi_2598_;
                                    local_19 = _e2274;
                                    let _e2275 = (_e2272 == 0u);
                                    local_9 = _e2275;
                                    local_20 = _e2275;
                                    if _e2275 {
                                        phi_2596_ = u32();
                                        phi_2599_ = bool();
                                        phi_3196_ = false;
                                    } else {
                                        let _e2278 = nodes.member[(0u + _e1834)].links[1u];
                                        let _e2283 = ((0u + _e2278) + select(firstTrailingBit(_e2272), 32u, (_e2272 == 0u)));
                                        if (_e2283 < _e79) {
                                        } else {
                                            return;
                                        }
                                        let _e2290 = triangles.member[(0u + _e2283)].v0_;
                                        let _e2292 = (_e2290.x - _e126);
                                        let _e2294 = (_e2290.y - _e128);
                                        let _e2296 = (_e2290.z - _e130);
                                        if (_e1669 == 0u) {
                                            phi_2643_ = vec3<f32>(_e2294, _e2296, _e2292);
                                        } else {
                                            if (_e1669 == 1u) {
                                                phi_2642_ = vec3<f32>(_e2296, _e2292, _e2294);
                                            } else {
                                                phi_2642_ = (_e2290 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2304 = phi_2642_;
                                            phi_2643_ = _e2304;
                                        }
                                        let _e2306 = phi_2643_;
                                        let _e2310 = (_e2306.x - (_e1680 * _e2306.z));
                                        let _e2314 = (_e2306.y - (_e1683 * _e2306.z));
                                        let _e2316 = triangles.member[(0u + _e2283)].v1_;
                                        let _e2318 = (_e2316.x - _e126);
                                        let _e2320 = (_e2316.y - _e128);
                                        let _e2322 = (_e2316.z - _e130);
                                        if (_e1669 == 0u) {
                                            phi_2673_ = vec3<f32>(_e2320, _e2322, _e2318);
                                        } else {
                                            if (_e1669 == 1u) {
                                                phi_2672_ = vec3<f32>(_e2322, _e2318, _e2320);
                                            } else {
                                                phi_2672_ = (_e2316 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2330 = phi_2672_;
                                            phi_2673_ = _e2330;
                                        }
                                        let _e2332 = phi_2673_;
                                        let _e2336 = (_e2332.x - (_e1680 * _e2332.z));
                                        let _e2340 = (_e2332.y - (_e1683 * _e2332.z));
                                        let _e2342 = triangles.member[(0u + _e2283)].v2_;
                                        let _e2344 = (_e2342.x - _e126);
                                        let _e2346 = (_e2342.y - _e128);
                                        let _e2348 = (_e2342.z - _e130);
                                        if (_e1669 == 0u) {
                                            phi_2703_ = vec3<f32>(_e2346, _e2348, _e2344);
                                        } else {
                                            if (_e1669 == 1u) {
                                                phi_2702_ = vec3<f32>(_e2348, _e2344, _e2346);
                                            } else {
                                                phi_2702_ = (_e2342 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e2356 = phi_2702_;
                                            phi_2703_ = _e2356;
                                        }
                                        let _e2358 = phi_2703_;
                                        let _e2362 = (_e2358.x - (_e1680 * _e2358.z));
                                        let _e2366 = (_e2358.y - (_e1683 * _e2358.z));
                                        if (_e2336 < _e2362) {
                                            phi_2722_ = true;
                                        } else {
                                            if (_e2336 == _e2362) {
                                                phi_2721_ = (_e2340 < _e2366);
                                            } else {
                                                phi_2721_ = false;
                                            }
                                            let _e2371 = phi_2721_;
                                            phi_2722_ = _e2371;
                                        }
                                        let _e2373 = phi_2722_;
                                        if _e2373 {
                                            phi_2726_ = _e2366;
                                            phi_2727_ = _e2362;
                                            phi_2728_ = _e2340;
                                            phi_2729_ = _e2336;
                                        } else {
                                            phi_2726_ = _e2340;
                                            phi_2727_ = _e2336;
                                            phi_2728_ = _e2366;
                                            phi_2729_ = _e2362;
                                        }
                                        let _e2375 = phi_2726_;
                                        let _e2377 = phi_2727_;
                                        let _e2379 = phi_2728_;
                                        let _e2381 = phi_2729_;
                                        let _e2384 = ((_e2381 * _e2375) - (_e2379 * _e2377));
                                        if _e2373 {
                                            phi_2737_ = -(_e2384);
                                        } else {
                                            phi_2737_ = _e2384;
                                        }
                                        let _e2387 = phi_2737_;
                                        if (_e2362 < _e2310) {
                                            phi_2748_ = true;
                                        } else {
                                            if (_e2362 == _e2310) {
                                                phi_2747_ = (_e2366 < _e2314);
                                            } else {
                                                phi_2747_ = false;
                                            }
                                            let _e2392 = phi_2747_;
                                            phi_2748_ = _e2392;
                                        }
                                        let _e2394 = phi_2748_;
                                        if _e2394 {
                                            phi_2752_ = _e2314;
                                            phi_2753_ = _e2310;
                                            phi_2754_ = _e2366;
                                            phi_2755_ = _e2362;
                                        } else {
                                            phi_2752_ = _e2366;
                                            phi_2753_ = _e2362;
                                            phi_2754_ = _e2314;
                                            phi_2755_ = _e2310;
                                        }
                                        let _e2396 = phi_2752_;
                                        let _e2398 = phi_2753_;
                                        let _e2400 = phi_2754_;
                                        let _e2402 = phi_2755_;
                                        let _e2405 = ((_e2402 * _e2396) - (_e2400 * _e2398));
                                        if _e2394 {
                                            phi_2763_ = -(_e2405);
                                        } else {
                                            phi_2763_ = _e2405;
                                        }
                                        let _e2408 = phi_2763_;
                                        if (_e2310 < _e2336) {
                                            phi_2774_ = true;
                                        } else {
                                            if (_e2310 == _e2336) {
                                                phi_2773_ = (_e2314 < _e2340);
                                            } else {
                                                phi_2773_ = false;
                                            }
                                            let _e2413 = phi_2773_;
                                            phi_2774_ = _e2413;
                                        }
                                        let _e2415 = phi_2774_;
                                        if _e2415 {
                                            phi_2778_ = _e2340;
                                            phi_2779_ = _e2336;
                                            phi_2780_ = _e2314;
                                            phi_2781_ = _e2310;
                                        } else {
                                            phi_2778_ = _e2314;
                                            phi_2779_ = _e2310;
                                            phi_2780_ = _e2340;
                                            phi_2781_ = _e2336;
                                        }
                                        let _e2417 = phi_2778_;
                                        let _e2419 = phi_2779_;
                                        let _e2421 = phi_2780_;
                                        let _e2423 = phi_2781_;
                                        let _e2426 = ((_e2423 * _e2417) - (_e2421 * _e2419));
                                        if _e2415 {
                                            phi_2789_ = -(_e2426);
                                        } else {
                                            phi_2789_ = _e2426;
                                        }
                                        let _e2429 = phi_2789_;
                                        if (_e2387 >= 0f) {
                                            if (_e2408 >= 0f) {
                                                if (_e2429 >= 0f) {
                                                    phi_2804_ = ((_e2387 + _e2408) + _e2429);
                                                    phi_2805_ = false;
                                                } else {
                                                    phi_2804_ = f32();
                                                    phi_2805_ = true;
                                                }
                                                let _e2436 = phi_2804_;
                                                let _e2438 = phi_2805_;
                                                phi_2806_ = _e2436;
                                                phi_2807_ = _e2438;
                                            } else {
                                                phi_2806_ = f32();
                                                phi_2807_ = true;
                                            }
                                            let _e2440 = phi_2806_;
                                            let _e2442 = phi_2807_;
                                            phi_2808_ = _e2440;
                                            phi_2809_ = _e2442;
                                        } else {
                                            phi_2808_ = f32();
                                            phi_2809_ = true;
                                        }
                                        let _e2444 = phi_2808_;
                                        let _e2446 = phi_2809_;
                                        if _e2446 {
                                            if (_e2387 <= 0f) {
                                                if (_e2408 <= 0f) {
                                                    let _e2449 = (_e2429 <= 0f);
                                                    if _e2449 {
                                                    }
                                                    phi_2827_ = ((_e2387 + _e2408) + _e2429);
                                                    phi_2828_ = false;
                                                    phi_2829_ = _e2449;
                                                } else {
                                                    phi_2827_ = f32();
                                                    phi_2828_ = true;
                                                    phi_2829_ = false;
                                                }
                                                let _e2453 = phi_2827_;
                                                let _e2455 = phi_2828_;
                                                let _e2457 = phi_2829_;
                                                phi_2830_ = _e2453;
                                                phi_2831_ = _e2455;
                                                phi_2832_ = _e2457;
                                            } else {
                                                phi_2830_ = f32();
                                                phi_2831_ = true;
                                                phi_2832_ = false;
                                            }
                                            let _e2459 = phi_2830_;
                                            let _e2461 = phi_2831_;
                                            let _e2463 = phi_2832_;
                                            if _e2461 {
                                                phi_2836_ = false;
                                            } else {
                                                phi_2836_ = _e2463;
                                            }
                                            let _e2465 = phi_2836_;
                                            phi_2837_ = _e2459;
                                            phi_2838_ = _e2465;
                                        } else {
                                            phi_2837_ = _e2444;
                                            phi_2838_ = true;
                                        }
                                        let _e2467 = phi_2837_;
                                        let _e2469 = phi_2838_;
                                        if _e2469 {
                                            let _e2470 = (_e2467 == 0f);
                                            if _e2470 {
                                                phi_3154_ = lt_bvh_triangle_Intersection();
                                                phi_3155_ = false;
                                            } else {
                                                let _e2472 = triangles.member[(0u + _e2283)].v0_;
                                                let _e2474 = (_e2472.x - _e126);
                                                let _e2476 = (_e2472.y - _e128);
                                                let _e2478 = (_e2472.z - _e130);
                                                if (_e1669 == 0u) {
                                                    phi_2867_ = vec3<f32>(_e2476, _e2478, _e2474);
                                                } else {
                                                    if (_e1669 == 1u) {
                                                        phi_2866_ = vec3<f32>(_e2478, _e2474, _e2476);
                                                    } else {
                                                        phi_2866_ = (_e2472 - vec3<f32>(_e126, _e128, _e130));
                                                    }
                                                    let _e2486 = phi_2866_;
                                                    phi_2867_ = _e2486;
                                                }
                                                let _e2488 = phi_2867_;
                                                let _e2490 = triangles.member[(0u + _e2283)].v1_;
                                                let _e2492 = triangles.member[(0u + _e2283)].v0_;
                                                let _e2495 = (_e2490.x - _e2492.x);
                                                let _e2498 = (_e2490.y - _e2492.y);
                                                let _e2501 = (_e2490.z - _e2492.z);
                                                if (_e1669 == 0u) {
                                                    phi_2893_ = vec3<f32>(_e2498, _e2501, _e2495);
                                                } else {
                                                    if (_e1669 == 1u) {
                                                        phi_2892_ = vec3<f32>(_e2501, _e2495, _e2498);
                                                    } else {
                                                        phi_2892_ = (_e2490 - _e2492);
                                                    }
                                                    let _e2508 = phi_2892_;
                                                    phi_2893_ = _e2508;
                                                }
                                                let _e2510 = phi_2893_;
                                                let _e2512 = triangles.member[(0u + _e2283)].v2_;
                                                let _e2514 = triangles.member[(0u + _e2283)].v0_;
                                                let _e2517 = (_e2512.x - _e2514.x);
                                                let _e2520 = (_e2512.y - _e2514.y);
                                                let _e2523 = (_e2512.z - _e2514.z);
                                                if (_e1669 == 0u) {
                                                    phi_2919_ = vec3<f32>(_e2520, _e2523, _e2517);
                                                } else {
                                                    if (_e1669 == 1u) {
                                                        phi_2918_ = vec3<f32>(_e2523, _e2517, _e2520);
                                                    } else {
                                                        phi_2918_ = (_e2512 - _e2514);
                                                    }
                                                    let _e2530 = phi_2918_;
                                                    phi_2919_ = _e2530;
                                                }
                                                let _e2532 = phi_2919_;
                                                let _e2539 = ((_e2510.y * _e2532.z) - (_e2510.z * _e2532.y));
                                                let _e2546 = ((_e2510.z * _e2532.x) - (_e2510.x * _e2532.z));
                                                let _e2553 = ((_e2510.x * _e2532.y) - (_e2510.y * _e2532.x));
                                                let _e2567 = (((1f / _e1677.z) * (((_e2539 * _e2488.x) + (_e2546 * _e2488.y)) + (_e2553 * _e2488.z))) / (((_e2539 * _e1680) + (_e2546 * _e1683)) + _e2553));
                                                if (_e2567 > 0f) {
                                                    if (_e2567 < _e138) {
                                                        let _e2571 = triangles.member[(0u + _e2283)].v0_;
                                                        let _e2573 = triangles.member[(0u + _e2283)].v1_;
                                                        if (_e2571.x < _e2573.x) {
                                                            phi_2975_ = _e2571.x;
                                                        } else {
                                                            phi_2975_ = _e2573.x;
                                                        }
                                                        let _e2580 = phi_2975_;
                                                        if (_e2571.y < _e2573.y) {
                                                            phi_2984_ = _e2571.y;
                                                        } else {
                                                            phi_2984_ = _e2573.y;
                                                        }
                                                        let _e2587 = phi_2984_;
                                                        if (_e2571.z < _e2573.z) {
                                                            phi_2993_ = _e2571.z;
                                                        } else {
                                                            phi_2993_ = _e2573.z;
                                                        }
                                                        let _e2594 = phi_2993_;
                                                        let _e2596 = triangles.member[(0u + _e2283)].v2_;
                                                        if (_e2580 < _e2596.x) {
                                                            phi_3002_ = _e2580;
                                                        } else {
                                                            phi_3002_ = _e2596.x;
                                                        }
                                                        let _e2601 = phi_3002_;
                                                        if (_e2587 < _e2596.y) {
                                                            phi_3009_ = _e2587;
                                                        } else {
                                                            phi_3009_ = _e2596.y;
                                                        }
                                                        let _e2606 = phi_3009_;
                                                        if (_e2594 < _e2596.z) {
                                                            phi_3016_ = _e2594;
                                                        } else {
                                                            phi_3016_ = _e2596.z;
                                                        }
                                                        let _e2611 = phi_3016_;
                                                        let _e2613 = triangles.member[(0u + _e2283)].v0_;
                                                        let _e2615 = triangles.member[(0u + _e2283)].v1_;
                                                        if (_e2613.x > _e2615.x) {
                                                            phi_3029_ = _e2613.x;
                                                        } else {
                                                            phi_3029_ = _e2615.x;
                                                        }
                                                        let _e2622 = phi_3029_;
                                                        if (_e2613.y > _e2615.y) {
                                                            phi_3038_ = _e2613.y;
                                                        } else {
                                                            phi_3038_ = _e2615.y;
                                                        }
                                                        let _e2629 = phi_3038_;
                                                        if (_e2613.z > _e2615.z) {
                                                            phi_3047_ = _e2613.z;
                                                        } else {
                                                            phi_3047_ = _e2615.z;
                                                        }
                                                        let _e2636 = phi_3047_;
                                                        let _e2638 = triangles.member[(0u + _e2283)].v2_;
                                                        if (_e2622 > _e2638.x) {
                                                            phi_3056_ = _e2622;
                                                        } else {
                                                            phi_3056_ = _e2638.x;
                                                        }
                                                        let _e2643 = phi_3056_;
                                                        if (_e2629 > _e2638.y) {
                                                            phi_3063_ = _e2629;
                                                        } else {
                                                            phi_3063_ = _e2638.y;
                                                        }
                                                        let _e2648 = phi_3063_;
                                                        if (_e2636 > _e2638.z) {
                                                            phi_3070_ = _e2636;
                                                        } else {
                                                            phi_3070_ = _e2638.z;
                                                        }
                                                        let _e2653 = phi_3070_;
                                                        let _e2657 = ((_e2601 - _e126) * _e1594);
                                                        let _e2658 = ((_e2606 - _e128) * _e1604);
                                                        let _e2659 = ((_e2611 - _e130) * _e1614);
                                                        let _e2663 = ((_e2643 - _e126) * _e1594);
                                                        let _e2664 = ((_e2648 - _e128) * _e1604);
                                                        let _e2665 = ((_e2653 - _e130) * _e1614);
                                                        if (_e2657 < _e2663) {
                                                            phi_3087_ = _e2657;
                                                        } else {
                                                            phi_3087_ = _e2663;
                                                        }
                                                        let _e2668 = phi_3087_;
                                                        if (_e2658 < _e2664) {
                                                            phi_3092_ = _e2658;
                                                        } else {
                                                            phi_3092_ = _e2664;
                                                        }
                                                        let _e2671 = phi_3092_;
                                                        if (_e2659 < _e2665) {
                                                            phi_3097_ = _e2659;
                                                        } else {
                                                            phi_3097_ = _e2665;
                                                        }
                                                        let _e2674 = phi_3097_;
                                                        if (_e2657 > _e2663) {
                                                            phi_3105_ = _e2657;
                                                        } else {
                                                            phi_3105_ = _e2663;
                                                        }
                                                        let _e2680 = phi_3105_;
                                                        if (_e2658 > _e2664) {
                                                            phi_3110_ = _e2658;
                                                        } else {
                                                            phi_3110_ = _e2664;
                                                        }
                                                        let _e2683 = phi_3110_;
                                                        if (_e2659 > _e2665) {
                                                            phi_3115_ = _e2659;
                                                        } else {
                                                            phi_3115_ = _e2665;
                                                        }
                                                        let _e2686 = phi_3115_;
                                                        let _e2690 = core_intrinsics_maximum_number_nsz_f32_((_e2668 - _e1653), (_e2671 - _e1654));
                                                        let _e2691 = core_intrinsics_maximum_number_nsz_f32_(_e2690, (_e2674 - _e1655));
                                                        let _e2692 = core_intrinsics_minimum_number_nsz_f32_((_e2680 + _e1653), (_e2683 + _e1654));
                                                        let _e2693 = core_intrinsics_minimum_number_nsz_f32_(_e2692, (_e2686 + _e1655));
                                                        if (_e2691 > -300000000000000000000000000000000000000f) {
                                                            phi_3127_ = _e2691;
                                                        } else {
                                                            phi_3127_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2696 = phi_3127_;
                                                        if (_e2693 < 300000000000000000000000000000000000000f) {
                                                            phi_3132_ = _e2693;
                                                        } else {
                                                            phi_3132_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2699 = phi_3132_;
                                                        if (_e2567 < _e2696) {
                                                            phi_3137_ = _e2696;
                                                        } else {
                                                            phi_3137_ = _e2567;
                                                        }
                                                        let _e2702 = phi_3137_;
                                                        if (_e2702 > _e2699) {
                                                            phi_3142_ = _e2699;
                                                        } else {
                                                            phi_3142_ = _e2702;
                                                        }
                                                        let _e2705 = phi_3142_;
                                                        phi_3147_ = lt_bvh_triangle_Intersection(_e2705, (_e2408 / _e2467), (_e2429 / _e2467), (_e2696 <= _e2699));
                                                        phi_3148_ = false;
                                                    } else {
                                                        phi_3147_ = lt_bvh_triangle_Intersection();
                                                        phi_3148_ = true;
                                                    }
                                                    let _e2711 = phi_3147_;
                                                    let _e2713 = phi_3148_;
                                                    phi_3149_ = _e2711;
                                                    phi_3150_ = _e2713;
                                                } else {
                                                    phi_3149_ = lt_bvh_triangle_Intersection();
                                                    phi_3150_ = true;
                                                }
                                                let _e2715 = phi_3149_;
                                                let _e2717 = phi_3150_;
                                                if _e2717 {
                                                }
                                                phi_3154_ = _e2715;
                                                phi_3155_ = _e2717;
                                            }
                                            let _e2719 = phi_3154_;
                                            let _e2721 = phi_3155_;
                                            phi_3156_ = _e2719;
                                            phi_3157_ = _e2470;
                                            phi_3158_ = _e2721;
                                        } else {
                                            phi_3156_ = lt_bvh_triangle_Intersection();
                                            phi_3157_ = true;
                                            phi_3158_ = false;
                                        }
                                        let _e2723 = phi_3156_;
                                        let _e2725 = phi_3157_;
                                        let _e2727 = phi_3158_;
                                        if _e2725 {
                                            phi_3162_ = true;
                                        } else {
                                            phi_3162_ = _e2727;
                                        }
                                        let _e2729 = phi_3162_;
                                        if _e2729 {
                                            phi_3166_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3166_ = _e2723;
                                        }
                                        let _e2731 = phi_3166_;
                                        if _e2731.is_hit {
                                            if (_e2731.t > 0f) {
                                                if (_e2731.t < _e138) {
                                                    if true {
                                                        phi_3186_ = false;
                                                    } else {
                                                        phi_3186_ = true;
                                                    }
                                                    let _e2740 = phi_3186_;
                                                    phi_3187_ = true;
                                                    phi_3188_ = _e2740;
                                                } else {
                                                    phi_3187_ = _e2274;
                                                    phi_3188_ = true;
                                                }
                                                let _e2742 = phi_3187_;
                                                let _e2744 = phi_3188_;
                                                phi_3189_ = _e2742;
                                                phi_3190_ = _e2744;
                                            } else {
                                                phi_3189_ = _e2274;
                                                phi_3190_ = true;
                                            }
                                            let _e2746 = phi_3189_;
                                            let _e2748 = phi_3190_;
                                            phi_3191_ = _e2746;
                                            phi_3192_ = _e2748;
                                        } else {
                                            phi_3191_ = _e2274;
                                            phi_3192_ = true;
                                        }
                                        let _e2750 = phi_3191_;
                                        let _e2752 = phi_3192_;
                                        if _e2752 {
                                        }
                                        phi_2596_ = (_e2272 & (_e2272 - 1u));
                                        phi_2599_ = _e2750;
                                        phi_3196_ = _e2752;
                                    }
                                    let _e2754 = phi_2596_;
                                    let _e2756 = phi_2599_;
                                    let _e2758 = phi_3196_;
                                    continue;
                                    continuing {
                                        phi_2595_ = _e2754;
                                        phi_2598_ = _e2756;
                                        break if !(_e2758);
                                    }
                                }
                                let _e2761 = local_9;
                                if _e2761 {
                                    let _e2763 = local.group_mask;
                                    if ((_e2763 & 4278190080u) == 0u) {
                                        let _e2767 = local.len;
                                        if (_e2767 == 0u) {
                                            phi_3238_ = false;
                                        } else {
                                            let _e2771 = local.len;
                                            local.len = (_e2771 - 1u);
                                            let _e2774 = local.len;
                                            if (_e2774 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2779 = local.first[(0u + _e2774)];
                                            local.group = _e2779;
                                            let _e2782 = local.len;
                                            if (_e2782 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2787 = local.mask[(0u + _e2782)];
                                            local.group_mask = _e2787;
                                            phi_3238_ = true;
                                        }
                                        let _e2790 = phi_3238_;
                                        phi_3239_ = _e2790;
                                    } else {
                                        phi_3239_ = true;
                                    }
                                    let _e2792 = phi_3239_;
                                    if _e2792 {
                                        let _e2794 = local.group_mask;
                                        let _e2800 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2794)), 32u, (_e2794 == 0u)));
                                        let _e2804 = local.group_mask;
                                        let _e2818 = local.group_mask;
                                        local.group_mask = (_e2818 & ~((1u << bitcast<u32>((_e2800 & 31u)))));
                                        let _e2821 = local.group;
                                        phi_3270_ = (_e2821 + countOneBits(((_e2804 & ~((4294967295u << bitcast<u32>((((_e2800 - 24u) ^ _e1696) & 31u))))) & 255u)));
                                    } else {
                                        phi_3270_ = 4294967295u;
                                    }
                                    let _e2824 = phi_3270_;
                                    phi_3271_ = _e2824;
                                } else {
                                    phi_3271_ = u32();
                                }
                                let _e2826 = phi_3271_;
                                phi_2264_ = _e2826;
                                let _e3366 = local_19;
                                phi_2267_ = _e3366;
                                let _e3369 = local_20;
                                phi_3272_ = _e3369;
                                phi_3273_ = false;
                            } else {
                                phi_2264_ = u32();
                                phi_2267_ = bool();
                                phi_3272_ = false;
                                phi_3273_ = true;
                            }
                            let _e2828 = phi_2264_;
                            let _e2830 = phi_2267_;
                            let _e2832 = phi_3272_;
                            let _e2834 = phi_3273_;
                            local_10 = _e2834;
                            continue;
                            continuing {
                                phi_2263_ = _e2828;
                                phi_2266_ = _e2830;
                                break if !(_e2832);
                            }
                        }
                        let _e2837 = local_10;
                        if _e2837 {
                            phi_3277_ = false;
                        } else {
                            phi_3277_ = true;
                        }
                        let _e2839 = phi_3277_;
                        if _e2839 {
                            phi_3281_ = true;
                        } else {
                            let _e3375 = local_21;
                            phi_3281_ = _e3375;
                        }
                        let _e2841 = phi_3281_;
                        phi_3282_ = _e2841;
                    }
                    let _e2843 = phi_3282_;
                    phi_3283_ = _e2843;
                    phi_3284_ = _e1518;
                } else {
                    phi_3283_ = bool();
                    phi_3284_ = true;
                }
                let _e2845 = phi_3283_;
                let _e2847 = phi_3284_;
                if _e2847 {
                    phi_3288_ = false;
                } else {
                    phi_3288_ = _e2845;
                }
                let _e2849 = phi_3288_;
                phi_3289_ = _e2849;
            }
            let _e2851 = phi_3289_;
            phi_3290_ = _e2851;
        } else {
            phi_3290_ = false;
        }
        let _e2853 = phi_3290_;
        if _e2853 {
            phi_3294_ = 0f;
        } else {
            phi_3294_ = 1f;
        }
        let _e2855 = phi_3294_;
        if (_e105 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e105)] = _e2855;
        let _e2861 = p.member.light.number;
        let _e2862 = (_e2861 * 3u);
        let _e2863 = (_e2862 / 32u);
        let _e2864 = (_e2862 % 32u);
        let _e2866 = p.member.light.mask_words;
        if (_e105 < _e82) {
        } else {
            return;
        }
        let _e2870 = visibility.member[(0u + _e105)];
        let _e2872 = ((_e105 * _e2866) + _e2863);
        if (_e2864 > 29u) {
            let _e2874 = (_e2872 + 1u);
            if (_e2874 < _e88) {
            } else {
                return;
            }
            let _e2878 = bits.member[(0u + _e2874)];
            phi_3335_ = _e2878;
        } else {
            phi_3335_ = 0u;
        }
        let _e2880 = phi_3335_;
        if (_e2872 < _e88) {
        } else {
            return;
        }
        let _e2884 = bits.member[(0u + _e2872)];
        let _e2887 = (_e2884 >> bitcast<u32>((_e2864 & 31u)));
        if (_e2864 > 29u) {
            phi_3354_ = (_e2887 | (_e2880 << bitcast<u32>(((32u - _e2864) & 31u))));
        } else {
            phi_3354_ = _e2887;
        }
        let _e2895 = phi_3354_;
        if ((_e2895 & 2u) == 0u) {
            phi_3362_ = (_e2895 & 1u);
        } else {
            phi_3362_ = (_e2895 & 7u);
        }
        let _e2901 = phi_3362_;
        if ((_e2901 & 1u) != 0u) {
            phi_3370_ = (2u | 1u);
        } else {
            phi_3370_ = 2u;
        }
        let _e2907 = phi_3370_;
        if (_e2870 < 0.5f) {
            phi_3375_ = (_e2907 | 4u);
        } else {
            phi_3375_ = _e2907;
        }
        let _e2910 = phi_3375_;
        let _e2912 = ((_e105 * _e2866) + _e2863);
        if (_e2912 < _e88) {
        } else {
            return;
        }
        let _e2916 = bits.member[(0u + _e2912)];
        if (_e2912 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e2912)] = ((_e2916 & ~((7u << bitcast<u32>((_e2864 & 31u))))) | (_e2910 << bitcast<u32>((_e2864 & 31u))));
        if (_e2864 > 29u) {
            let _e2930 = (_e2912 + 1u);
            if (_e2930 < _e88) {
            } else {
                return;
            }
            let _e2934 = bits.member[(0u + _e2930)];
            let _e2935 = (32u - _e2864);
            let _e2945 = (_e2912 + 1u);
            if (_e2945 < _e88) {
            } else {
                return;
            }
            bits.member[(0u + _e2945)] = ((_e2934 & ~((7u >> bitcast<u32>((_e2935 & 31u))))) | (_e2910 >> bitcast<u32>((_e2935 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
