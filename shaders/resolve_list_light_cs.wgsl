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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_35 {
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

struct type_39 {
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

struct type_48 {
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

struct type_51 {
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
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> nodes: type_35;
@group(0) @binding(3) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage> rows: type_48;
@group(0) @binding(7) 
var<uniform> space: type_51;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_176_: bool;
    var phi_180_: f32;

    if (param != param) {
        phi_176_ = true;
    } else {
        let _e65 = (param_1 >= param);
        if _e65 {
        }
        phi_176_ = _e65;
    }
    let _e67 = phi_176_;
    if _e67 {
        phi_180_ = param_1;
    } else {
        phi_180_ = param;
    }
    let _e69 = phi_180_;
    return _e69;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_192_: bool;
    var phi_196_: f32;

    if (param_2 != param_2) {
        phi_192_ = true;
    } else {
        let _e65 = (param_3 <= param_2);
        if _e65 {
        }
        phi_192_ = _e65;
    }
    let _e67 = phi_192_;
    if _e67 {
        phi_196_ = param_3;
    } else {
        phi_196_ = param_2;
    }
    let _e69 = phi_196_;
    return _e69;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: array<u32, 32>;
    var phi_281_: f32;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_321_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_341_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_360_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_368_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_400_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_419_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_446_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_475_: u32;
    var phi_476_: f32;
    var phi_477_: u32;
    var phi_478_: f32;
    var phi_483_: f32;
    var phi_494_: u32;
    var phi_504_: u32;
    var phi_510_: u32;
    var phi_511_: u32;
    var phi_512_: u32;
    var phi_523_: vec3<f32>;
    var phi_524_: vec3<f32>;
    var phi_546_: vec3<f32>;
    var phi_547_: vec3<f32>;
    var phi_570_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_638_: f32;
    var phi_645_: f32;
    var phi_652_: f32;
    var phi_659_: f32;
    var phi_666_: f32;
    var phi_673_: f32;
    var phi_690_: f32;
    var phi_695_: f32;
    var phi_700_: f32;
    var phi_705_: f32;
    var phi_710_: f32;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_741_: u32;
    var phi_742_: u32;
    var phi_753_: vec3<f32>;
    var phi_754_: vec3<f32>;
    var phi_766_: u32;
    var phi_769_: u32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_853_: u32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_891_: u32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_929_: u32;
    var phi_1056_: u32;
    var phi_1096_: u32;
    var phi_1097_: u32;
    var phi_1103_: u32;
    var phi_1132_: vec3<f32>;
    var phi_1133_: vec3<f32>;
    var phi_1162_: vec3<f32>;
    var phi_1163_: vec3<f32>;
    var phi_1192_: vec3<f32>;
    var phi_1193_: vec3<f32>;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1216_: f32;
    var phi_1217_: f32;
    var phi_1218_: f32;
    var phi_1219_: f32;
    var phi_1227_: f32;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1242_: f32;
    var phi_1243_: f32;
    var phi_1244_: f32;
    var phi_1245_: f32;
    var phi_1253_: f32;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1268_: f32;
    var phi_1269_: f32;
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1279_: f32;
    var phi_1294_: f32;
    var phi_1295_: bool;
    var phi_1296_: f32;
    var phi_1297_: bool;
    var phi_1298_: f32;
    var phi_1299_: bool;
    var phi_1317_: f32;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1320_: f32;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1326_: bool;
    var phi_1327_: f32;
    var phi_1328_: bool;
    var phi_1356_: vec3<f32>;
    var phi_1357_: vec3<f32>;
    var phi_1382_: vec3<f32>;
    var phi_1383_: vec3<f32>;
    var phi_1408_: vec3<f32>;
    var phi_1409_: vec3<f32>;
    var phi_1465_: f32;
    var phi_1474_: f32;
    var phi_1483_: f32;
    var phi_1492_: f32;
    var phi_1499_: f32;
    var phi_1506_: f32;
    var phi_1519_: f32;
    var phi_1528_: f32;
    var phi_1537_: f32;
    var phi_1546_: f32;
    var phi_1553_: f32;
    var phi_1560_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1587_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1605_: f32;
    var phi_1617_: f32;
    var phi_1622_: f32;
    var phi_1627_: f32;
    var phi_1632_: f32;
    var phi_1637_: lt_bvh_triangle_Intersection;
    var phi_1638_: bool;
    var phi_1639_: lt_bvh_triangle_Intersection;
    var phi_1640_: bool;
    var phi_1644_: lt_bvh_triangle_Intersection;
    var phi_1645_: bool;
    var phi_1646_: lt_bvh_triangle_Intersection;
    var phi_1647_: bool;
    var phi_1648_: bool;
    var phi_1652_: bool;
    var phi_1656_: lt_bvh_triangle_Intersection;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1057_: u32;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var local_2: bool;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1734_: u32;
    var phi_1735_: u32;
    var phi_1739_: u32;
    var phi_1740_: u32;
    var phi_1741_: u32;
    var phi_1742_: u32;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1766_: u32;
    var phi_1767_: u32;
    var phi_1768_: u32;
    var phi_1769_: u32;
    var phi_1770_: u32;
    var phi_1771_: u32;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_767_: u32;
    var phi_770_: u32;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var local_3: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1785_: bool;
    var phi_1789_: bool;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1798_: bool;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1821_: bool;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1837_: bool;
    var phi_1841_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1862_: bool;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1868_: bool;
    var phi_1938_: f32;
    var phi_1945_: f32;
    var phi_1952_: f32;
    var phi_1959_: f32;
    var phi_1966_: f32;
    var phi_1973_: f32;
    var phi_1990_: f32;
    var phi_1995_: f32;
    var phi_2000_: f32;
    var phi_2005_: f32;
    var phi_2010_: f32;
    var phi_2036_: bool;
    var phi_2037_: bool;
    var phi_2045_: u32;
    var phi_2046_: u32;
    var phi_2057_: vec3<f32>;
    var phi_2058_: vec3<f32>;
    var phi_2071_: u32;
    var phi_2076_: u32;
    var phi_2081_: u32;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2227_: u32;
    var phi_2229_: u32;
    var phi_2232_: bool;
    var phi_2312_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2339_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2366_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2372_: u32;
    var phi_2375_: u32;
    var phi_2389_: u32;
    var phi_2399_: u32;
    var phi_2409_: u32;
    var phi_2427_: u32;
    var phi_2437_: u32;
    var phi_2447_: u32;
    var phi_2483_: u32;
    var phi_2496_: u32;
    var phi_2501_: u32;
    var phi_2502_: u32;
    var phi_2503_: u32;
    var phi_2373_: u32;
    var phi_2376_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_2561_: u32;
    var phi_2564_: bool;
    var phi_2608_: vec3<f32>;
    var phi_2609_: vec3<f32>;
    var phi_2638_: vec3<f32>;
    var phi_2639_: vec3<f32>;
    var phi_2668_: vec3<f32>;
    var phi_2669_: vec3<f32>;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2692_: f32;
    var phi_2693_: f32;
    var phi_2694_: f32;
    var phi_2695_: f32;
    var phi_2703_: f32;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2718_: f32;
    var phi_2719_: f32;
    var phi_2720_: f32;
    var phi_2721_: f32;
    var phi_2729_: f32;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2744_: f32;
    var phi_2745_: f32;
    var phi_2746_: f32;
    var phi_2747_: f32;
    var phi_2755_: f32;
    var phi_2770_: f32;
    var phi_2771_: bool;
    var phi_2772_: f32;
    var phi_2773_: bool;
    var phi_2774_: f32;
    var phi_2775_: bool;
    var phi_2793_: f32;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var phi_2796_: f32;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2802_: bool;
    var phi_2803_: f32;
    var phi_2804_: bool;
    var phi_2832_: vec3<f32>;
    var phi_2833_: vec3<f32>;
    var phi_2858_: vec3<f32>;
    var phi_2859_: vec3<f32>;
    var phi_2884_: vec3<f32>;
    var phi_2885_: vec3<f32>;
    var phi_2941_: f32;
    var phi_2950_: f32;
    var phi_2959_: f32;
    var phi_2968_: f32;
    var phi_2975_: f32;
    var phi_2982_: f32;
    var phi_2995_: f32;
    var phi_3004_: f32;
    var phi_3013_: f32;
    var phi_3022_: f32;
    var phi_3029_: f32;
    var phi_3036_: f32;
    var phi_3053_: f32;
    var phi_3058_: f32;
    var phi_3063_: f32;
    var phi_3071_: f32;
    var phi_3076_: f32;
    var phi_3081_: f32;
    var phi_3093_: f32;
    var phi_3098_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3113_: lt_bvh_triangle_Intersection;
    var phi_3114_: bool;
    var phi_3115_: lt_bvh_triangle_Intersection;
    var phi_3116_: bool;
    var phi_3120_: lt_bvh_triangle_Intersection;
    var phi_3121_: bool;
    var phi_3122_: lt_bvh_triangle_Intersection;
    var phi_3123_: bool;
    var phi_3124_: bool;
    var phi_3128_: bool;
    var phi_3132_: lt_bvh_triangle_Intersection;
    var phi_3152_: bool;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_2562_: u32;
    var phi_2565_: bool;
    var phi_3162_: bool;
    var local_7: bool;
    var phi_3204_: bool;
    var phi_3205_: bool;
    var phi_3236_: u32;
    var phi_3237_: u32;
    var phi_2230_: u32;
    var phi_2233_: bool;
    var phi_3238_: bool;
    var phi_3239_: bool;
    var local_8: bool;
    var phi_3243_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3249_: bool;
    var phi_3250_: bool;
    var phi_3254_: bool;
    var phi_3255_: bool;
    var phi_3256_: bool;
    var phi_3260_: f32;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

    let _e64 = id_1;
    let _e71 = arrayLength((&nodes.member));
    let _e74 = arrayLength((&triangles.member));
    let _e80 = arrayLength((&list.member));
    let _e83 = arrayLength((&rows.member));
    let _e88 = ((_e64.y * 2097152u) + _e64.x);
    if (3u < _e80) {
    } else {
        return;
    }
    let _e91 = list.member[3u];
    if (_e88 < _e91) {
        let _e93 = (_e88 + 4u);
        if (_e93 < _e80) {
        } else {
            return;
        }
        let _e97 = list.member[(0u + _e93)];
        let _e98 = space.member;
        if (_e97 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e104 = samples.member[(0u + _e97)].position;
        let _e106 = samples.member[(0u + _e97)].normal;
        let _e108 = samples.member[(0u + _e97)].magnitude;
        let _e110 = ((8f / 8388608f) * _e108);
        let _e112 = (_e106.x * _e110);
        let _e114 = (_e106.y * _e110);
        let _e116 = (_e106.z * _e110);
        let _e118 = (_e104.x + _e112);
        let _e120 = (_e104.y + _e114);
        let _e122 = (_e104.z + _e116);
        let _e126 = p.member.light.place;
        if (_e126.w == 0f) {
            phi_281_ = 300000000000000000000000000000000000000f;
        } else {
            phi_281_ = 1f;
        }
        let _e130 = phi_281_;
        let _e138 = (_e126.x - (_e118 * _e126.w));
        let _e139 = (_e126.y - (_e120 * _e126.w));
        let _e140 = (_e126.z - (_e122 * _e126.w));
        let _e141 = vec3<f32>(_e138, _e139, _e140);
        let _e142 = abs(_e138);
        let _e143 = abs(_e139);
        let _e144 = abs(_e140);
        if (abs(_e118) < 1000000000000000f) {
            if (abs(_e120) < 1000000000000000f) {
                phi_314_ = (abs(_e122) < 1000000000000000f);
                phi_315_ = false;
            } else {
                phi_314_ = bool();
                phi_315_ = true;
            }
            let _e152 = phi_314_;
            let _e154 = phi_315_;
            phi_316_ = _e152;
            phi_317_ = _e154;
        } else {
            phi_316_ = bool();
            phi_317_ = true;
        }
        let _e156 = phi_316_;
        let _e158 = phi_317_;
        if _e158 {
            phi_321_ = false;
        } else {
            phi_321_ = _e156;
        }
        let _e160 = phi_321_;
        if _e160 {
            if (_e142 < 1000000000000000f) {
                if (_e143 < 1000000000000000f) {
                    phi_334_ = (_e144 < 1000000000000000f);
                    phi_335_ = false;
                } else {
                    phi_334_ = bool();
                    phi_335_ = true;
                }
                let _e165 = phi_334_;
                let _e167 = phi_335_;
                phi_336_ = _e165;
                phi_337_ = _e167;
            } else {
                phi_336_ = bool();
                phi_337_ = true;
            }
            let _e169 = phi_336_;
            let _e171 = phi_337_;
            if _e171 {
                phi_341_ = false;
            } else {
                phi_341_ = _e169;
            }
            let _e173 = phi_341_;
            if _e173 {
                if (_e142 > 0f) {
                    phi_355_ = bool();
                    phi_356_ = true;
                } else {
                    let _e175 = (_e143 > 0f);
                    if _e175 {
                        phi_354_ = bool();
                    } else {
                        phi_354_ = (_e144 > 0f);
                    }
                    let _e178 = phi_354_;
                    phi_355_ = _e178;
                    phi_356_ = _e175;
                }
                let _e180 = phi_355_;
                let _e182 = phi_356_;
                if _e182 {
                    phi_360_ = true;
                } else {
                    phi_360_ = _e180;
                }
                let _e184 = phi_360_;
                phi_361_ = _e184;
                phi_362_ = false;
            } else {
                phi_361_ = bool();
                phi_362_ = true;
            }
            let _e186 = phi_361_;
            let _e188 = phi_362_;
            phi_363_ = _e186;
            phi_364_ = _e188;
        } else {
            phi_363_ = bool();
            phi_364_ = true;
        }
        let _e190 = phi_363_;
        let _e192 = phi_364_;
        if _e192 {
            phi_368_ = false;
        } else {
            phi_368_ = _e190;
        }
        let _e194 = phi_368_;
        if _e194 {
            if (_e98.low.x <= _e118) {
                if (_e118 <= _e98.high.x) {
                    if (_e98.low.y <= _e120) {
                        phi_391_ = (_e120 <= _e98.high.y);
                        phi_392_ = false;
                    } else {
                        phi_391_ = bool();
                        phi_392_ = true;
                    }
                    let _e212 = phi_391_;
                    let _e214 = phi_392_;
                    phi_393_ = _e212;
                    phi_394_ = _e214;
                } else {
                    phi_393_ = bool();
                    phi_394_ = true;
                }
                let _e216 = phi_393_;
                let _e218 = phi_394_;
                phi_395_ = _e216;
                phi_396_ = _e218;
            } else {
                phi_395_ = bool();
                phi_396_ = true;
            }
            let _e220 = phi_395_;
            let _e222 = phi_396_;
            if _e222 {
                phi_400_ = false;
            } else {
                phi_400_ = _e220;
            }
            let _e224 = phi_400_;
            if (abs(_e138) > 0.000000000000000000000000000001f) {
                phi_414_ = bool();
                phi_415_ = true;
            } else {
                let _e229 = (abs(_e139) > 0.000000000000000000000000000001f);
                if _e229 {
                    phi_413_ = bool();
                } else {
                    phi_413_ = (abs(_e140) > 0.000000000000000000000000000001f);
                }
                let _e232 = phi_413_;
                phi_414_ = _e232;
                phi_415_ = _e229;
            }
            let _e234 = phi_414_;
            let _e236 = phi_415_;
            if _e236 {
                phi_419_ = true;
            } else {
                phi_419_ = _e234;
            }
            let _e238 = phi_419_;
            if _e224 {
                if (_e98.low.z <= _e122) {
                    if (_e122 <= _e98.high.z) {
                        if (_e98.is_parallel == 0u) {
                            phi_436_ = _e238;
                        } else {
                            phi_436_ = true;
                        }
                        let _e244 = phi_436_;
                        phi_437_ = _e244;
                        phi_438_ = false;
                    } else {
                        phi_437_ = bool();
                        phi_438_ = true;
                    }
                    let _e246 = phi_437_;
                    let _e248 = phi_438_;
                    phi_439_ = _e246;
                    phi_440_ = _e248;
                } else {
                    phi_439_ = bool();
                    phi_440_ = true;
                }
                let _e250 = phi_439_;
                let _e252 = phi_440_;
                phi_441_ = _e250;
                phi_442_ = _e252;
            } else {
                phi_441_ = bool();
                phi_442_ = true;
            }
            let _e254 = phi_441_;
            let _e256 = phi_442_;
            if _e256 {
                phi_446_ = false;
            } else {
                phi_446_ = _e254;
            }
            let _e258 = phi_446_;
            if _e258 {
                if (_e98.is_parallel == 0u) {
                    let _e261 = abs(_e138);
                    let _e262 = abs(_e139);
                    let _e263 = abs(_e140);
                    if (_e261 >= _e262) {
                        if (_e261 >= _e263) {
                            phi_466_ = false;
                        } else {
                            phi_466_ = true;
                        }
                        let _e267 = phi_466_;
                        phi_467_ = _e267;
                    } else {
                        phi_467_ = true;
                    }
                    let _e269 = phi_467_;
                    if _e269 {
                        if (_e262 >= _e263) {
                            phi_475_ = 1u;
                            phi_476_ = _e139;
                        } else {
                            phi_475_ = 2u;
                            phi_476_ = _e140;
                        }
                        let _e272 = phi_475_;
                        let _e274 = phi_476_;
                        phi_477_ = _e272;
                        phi_478_ = _e274;
                    } else {
                        phi_477_ = 0u;
                        phi_478_ = _e138;
                    }
                    let _e276 = phi_477_;
                    let _e278 = phi_478_;
                    if (_e278 < 0f) {
                        phi_483_ = -1f;
                    } else {
                        phi_483_ = 1f;
                    }
                    let _e281 = phi_483_;
                    let _e282 = (_e281 < 0f);
                    if (_e276 == 0u) {
                        if _e282 {
                            phi_494_ = _e98.roots.y;
                        } else {
                            phi_494_ = _e98.roots.x;
                        }
                        let _e289 = phi_494_;
                        phi_512_ = _e289;
                    } else {
                        if (_e276 == 1u) {
                            if _e282 {
                                phi_504_ = _e98.roots.w;
                            } else {
                                phi_504_ = _e98.roots.z;
                            }
                            let _e296 = phi_504_;
                            phi_511_ = _e296;
                        } else {
                            if _e282 {
                                phi_510_ = _e98.roots_z.y;
                            } else {
                                phi_510_ = _e98.roots_z.x;
                            }
                            let _e302 = phi_510_;
                            phi_511_ = _e302;
                        }
                        let _e304 = phi_511_;
                        phi_512_ = _e304;
                    }
                    let _e306 = phi_512_;
                    if (_e276 == 0u) {
                        phi_524_ = vec3<f32>(_e139, _e140, _e138);
                    } else {
                        if (_e276 == 1u) {
                            phi_523_ = vec3<f32>(_e140, _e138, _e139);
                        } else {
                            phi_523_ = _e141;
                        }
                        let _e312 = phi_523_;
                        phi_524_ = _e312;
                    }
                    let _e314 = phi_524_;
                    phi_570_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e314.x / _e314.z), (_e314.y / _e314.z), (_e281 / _e314.z)), _e306);
                } else {
                    if (_e98.axis == 0u) {
                        phi_547_ = vec3<f32>(_e120, _e122, _e118);
                    } else {
                        if (_e98.axis == 1u) {
                            phi_546_ = vec3<f32>(_e122, _e118, _e120);
                        } else {
                            phi_546_ = (_e104 + vec3<f32>(_e112, _e114, _e116));
                        }
                        let _e331 = phi_546_;
                        phi_547_ = _e331;
                    }
                    let _e333 = phi_547_;
                    let _e345 = (_e333.z - _e98.middle.z);
                    phi_570_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e333.x - _e98.middle.x) - (_e98.shear.x * _e345)), ((_e333.y - _e98.middle.y) - (_e98.shear.y * _e345)), (_e98.sign * _e345)), _e98.roots.x);
                }
                let _e358 = phi_570_;
                if (_e358.unnamed_1 == 4294967295u) {
                    phi_1793_ = false;
                    phi_1794_ = true;
                } else {
                    if (0u < _e71) {
                    } else {
                        return;
                    }
                    let _e366 = nodes.member[0u].frame[0u];
                    let _e370 = nodes.member[0u].frame[1u];
                    let _e374 = nodes.member[0u].frame[2u];
                    let _e378 = nodes.member[0u].frame[0u];
                    let _e382 = nodes.member[0u].frame[1u];
                    let _e386 = nodes.member[0u].frame[2u];
                    let _e390 = nodes.member[0u].frame[3u];
                    let _e424 = core_intrinsics_maximum_number_nsz_f32_(abs(_e138), abs(_e139));
                    let _e425 = core_intrinsics_maximum_number_nsz_f32_(_e424, abs(_e140));
                    let _e426 = (_e425 * 0.0000000000009094947f);
                    if (abs(_e138) < _e426) {
                        phi_638_ = _e426;
                    } else {
                        phi_638_ = abs(_e138);
                    }
                    let _e431 = phi_638_;
                    if (_e138 < 0f) {
                        phi_645_ = (-1f / _e431);
                    } else {
                        phi_645_ = (1f / _e431);
                    }
                    let _e436 = phi_645_;
                    if (abs(_e139) < _e426) {
                        phi_652_ = _e426;
                    } else {
                        phi_652_ = abs(_e139);
                    }
                    let _e441 = phi_652_;
                    if (_e139 < 0f) {
                        phi_659_ = (-1f / _e441);
                    } else {
                        phi_659_ = (1f / _e441);
                    }
                    let _e446 = phi_659_;
                    if (abs(_e140) < _e426) {
                        phi_666_ = _e426;
                    } else {
                        phi_666_ = abs(_e140);
                    }
                    let _e451 = phi_666_;
                    if (_e140 < 0f) {
                        phi_673_ = (-1f / _e451);
                    } else {
                        phi_673_ = (1f / _e451);
                    }
                    let _e456 = phi_673_;
                    let _e460 = abs((bitcast<f32>(_e366) - _e118));
                    let _e461 = abs((bitcast<f32>(_e370) - _e120));
                    let _e462 = abs((bitcast<f32>(_e374) - _e122));
                    let _e466 = abs(((bitcast<f32>(_e378) + (bitcast<f32>((((_e390 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e118));
                    let _e467 = abs(((bitcast<f32>(_e382) + (bitcast<f32>((((_e390 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                    let _e468 = abs(((bitcast<f32>(_e386) + (bitcast<f32>((((_e390 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                    if (_e460 > _e466) {
                        phi_690_ = _e460;
                    } else {
                        phi_690_ = _e466;
                    }
                    let _e471 = phi_690_;
                    if (_e461 > _e467) {
                        phi_695_ = _e461;
                    } else {
                        phi_695_ = _e467;
                    }
                    let _e474 = phi_695_;
                    if (_e462 > _e468) {
                        phi_700_ = _e462;
                    } else {
                        phi_700_ = _e468;
                    }
                    let _e477 = phi_700_;
                    if (_e471 > _e474) {
                        phi_705_ = _e471;
                    } else {
                        phi_705_ = _e474;
                    }
                    let _e480 = phi_705_;
                    if (_e480 > _e477) {
                        phi_710_ = _e480;
                    } else {
                        phi_710_ = _e477;
                    }
                    let _e483 = phi_710_;
                    let _e490 = (_e483 * 0.0000009536743f);
                    let _e491 = (abs(_e436) * _e490);
                    let _e492 = (abs(_e446) * _e490);
                    let _e493 = (abs(_e456) * _e490);
                    let _e494 = abs(_e138);
                    let _e495 = abs(_e139);
                    let _e496 = abs(_e140);
                    if (_e494 >= _e495) {
                        if (_e494 >= _e496) {
                            phi_732_ = false;
                        } else {
                            phi_732_ = true;
                        }
                        let _e500 = phi_732_;
                        phi_733_ = _e500;
                    } else {
                        phi_733_ = true;
                    }
                    let _e502 = phi_733_;
                    if _e502 {
                        if (_e495 >= _e496) {
                            phi_741_ = 1u;
                        } else {
                            phi_741_ = 2u;
                        }
                        let _e505 = phi_741_;
                        phi_742_ = _e505;
                    } else {
                        phi_742_ = 0u;
                    }
                    let _e507 = phi_742_;
                    if (_e507 == 0u) {
                        phi_754_ = vec3<f32>(_e139, _e140, _e138);
                    } else {
                        if (_e507 == 1u) {
                            phi_753_ = vec3<f32>(_e140, _e138, _e139);
                        } else {
                            phi_753_ = _e141;
                        }
                        let _e513 = phi_753_;
                        phi_754_ = _e513;
                    }
                    let _e515 = phi_754_;
                    let _e518 = (_e515.x / _e515.z);
                    let _e521 = (_e515.y / _e515.z);
                    local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_766_ = ((_e358.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_769_ = 0u;
                    loop {
                        let _e528 = phi_766_;
                        let _e530 = phi_769_;
                        let _e531 = (_e528 == 0u);
                        local_3 = _e531;
                        if _e531 {
                            phi_767_ = u32();
                            phi_770_ = u32();
                            phi_1774_ = false;
                            phi_1775_ = false;
                            phi_1776_ = false;
                        } else {
                            let _e539 = (_e528 & (_e528 - 1u));
                            let _e540 = (((_e528 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e528), 32u, (_e528 == 0u))) * 4u);
                            if (_e540 < _e83) {
                            } else {
                                return;
                            }
                            let _e544 = rows.member[(0u + _e540)];
                            let _e545 = (_e540 + 1u);
                            if (_e545 < _e83) {
                            } else {
                                return;
                            }
                            let _e549 = rows.member[(0u + _e545)];
                            let _e550 = (_e540 + 2u);
                            if (_e550 < _e83) {
                            } else {
                                return;
                            }
                            let _e554 = rows.member[(0u + _e550)];
                            let _e555 = (_e540 + 3u);
                            if (_e555 < _e83) {
                            } else {
                                return;
                            }
                            let _e559 = rows.member[(0u + _e555)];
                            let _e560 = lt_bvh_LightNode(_e544, _e549, _e554, _e559);
                            let _e572 = (_e358.unnamed.positive_exponent - bitcast<f32>(_e560.frame.x));
                            let _e575 = bitcast<f32>((((_e560.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e572 > 0f) {
                                if (_e572 < (255f * _e575)) {
                                    phi_838_ = (_e572 / _e575);
                                } else {
                                    phi_838_ = 255f;
                                }
                                let _e581 = phi_838_;
                                phi_839_ = _e581;
                            } else {
                                phi_839_ = 0f;
                            }
                            let _e583 = phi_839_;
                            let _e590 = select(select(u32(_e583), 0u, (_e583 < bitcast<f32>(0u))), 4294967295u, (_e583 > bitcast<f32>(1333788671u)));
                            if (f32(_e590) < _e583) {
                                phi_853_ = (_e590 + 1u);
                            } else {
                                phi_853_ = _e590;
                            }
                            let _e595 = phi_853_;
                            let _e596 = (_e590 * 16843009u);
                            let _e597 = (_e595 * 16843009u);
                            let _e607 = (_e358.unnamed.negative_exponent - bitcast<f32>(_e560.frame.y));
                            let _e610 = bitcast<f32>((((_e560.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e607 > 0f) {
                                if (_e607 < (255f * _e610)) {
                                    phi_876_ = (_e607 / _e610);
                                } else {
                                    phi_876_ = 255f;
                                }
                                let _e616 = phi_876_;
                                phi_877_ = _e616;
                            } else {
                                phi_877_ = 0f;
                            }
                            let _e618 = phi_877_;
                            let _e625 = select(select(u32(_e618), 0u, (_e618 < bitcast<f32>(0u))), 4294967295u, (_e618 > bitcast<f32>(1333788671u)));
                            if (f32(_e625) < _e618) {
                                phi_891_ = (_e625 + 1u);
                            } else {
                                phi_891_ = _e625;
                            }
                            let _e630 = phi_891_;
                            let _e631 = (_e625 * 16843009u);
                            let _e632 = (_e630 * 16843009u);
                            let _e642 = (_e358.unnamed.min_variance - bitcast<f32>(_e560.frame.z));
                            let _e645 = bitcast<f32>((((_e560.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e642 > 0f) {
                                if (_e642 < (255f * _e645)) {
                                    phi_914_ = (_e642 / _e645);
                                } else {
                                    phi_914_ = 255f;
                                }
                                let _e651 = phi_914_;
                                phi_915_ = _e651;
                            } else {
                                phi_915_ = 0f;
                            }
                            let _e653 = phi_915_;
                            let _e660 = select(select(u32(_e653), 0u, (_e653 < bitcast<f32>(0u))), 4294967295u, (_e653 > bitcast<f32>(1333788671u)));
                            if (f32(_e660) < _e653) {
                                phi_929_ = (_e660 + 1u);
                            } else {
                                phi_929_ = _e660;
                            }
                            let _e665 = phi_929_;
                            let _e666 = (_e665 * 16843009u);
                            let _e799 = (((((((((((_e596 & ~(_e560.x.x)) | (~((_e560.x.x ^ _e596)) & ((_e596 | 2155905152u) - (_e560.x.x & 2139062143u)))) & ((_e560.x.z & ~(_e597)) | (~((_e597 ^ _e560.x.z)) & ((_e560.x.z | 2155905152u) - (_e597 & 2139062143u))))) & ((_e631 & ~(_e560.y.x)) | (~((_e560.y.x ^ _e631)) & ((_e631 | 2155905152u) - (_e560.y.x & 2139062143u))))) & ((_e560.y.z & ~(_e632)) | (~((_e632 ^ _e560.y.z)) & ((_e560.y.z | 2155905152u) - (_e632 & 2139062143u))))) & ((_e560.rest.x & ~(_e666)) | (~((_e666 ^ _e560.rest.x)) & ((_e560.rest.x | 2155905152u) - (_e666 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e596 & ~(_e560.x.y)) | (~((_e560.x.y ^ _e596)) & ((_e596 | 2155905152u) - (_e560.x.y & 2139062143u)))) & ((_e560.x.w & ~(_e597)) | (~((_e597 ^ _e560.x.w)) & ((_e560.x.w | 2155905152u) - (_e597 & 2139062143u))))) & ((_e631 & ~(_e560.y.y)) | (~((_e560.y.y ^ _e631)) & ((_e631 | 2155905152u) - (_e560.y.y & 2139062143u))))) & ((_e560.y.w & ~(_e632)) | (~((_e632 ^ _e560.y.w)) & ((_e560.y.w | 2155905152u) - (_e632 & 2139062143u))))) & ((_e560.rest.y & ~(_e666)) | (~((_e666 ^ _e560.rest.y)) & ((_e560.rest.y | 2155905152u) - (_e666 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e560.frame.w & 16777216u) != 0u) {
                                phi_1056_ = _e799;
                                loop {
                                    let _e805 = phi_1056_;
                                    let _e806 = (_e805 == 0u);
                                    local_2 = _e806;
                                    local_11 = _e806;
                                    if _e806 {
                                        phi_1057_ = u32();
                                        phi_1706_ = false;
                                        phi_1707_ = false;
                                        phi_1708_ = false;
                                    } else {
                                        let _e809 = select(firstTrailingBit(_e805), 32u, (_e805 == 0u));
                                        let _e814 = (_e560.rest.z + (_e809 >> bitcast<u32>(2i)));
                                        if (_e814 < _e83) {
                                        } else {
                                            return;
                                        }
                                        let _e819 = rows.member[(0u + _e814)][0u];
                                        let _e823 = rows.member[(0u + _e814)][1u];
                                        let _e827 = rows.member[(0u + _e814)][2u];
                                        let _e831 = rows.member[(0u + _e814)][3u];
                                        if ((_e809 & 2u) == 0u) {
                                            phi_1096_ = _e823;
                                            phi_1097_ = _e819;
                                        } else {
                                            phi_1096_ = _e831;
                                            phi_1097_ = _e827;
                                        }
                                        let _e835 = phi_1096_;
                                        let _e837 = phi_1097_;
                                        if ((_e809 & 1u) == 0u) {
                                            phi_1103_ = _e837;
                                        } else {
                                            phi_1103_ = _e835;
                                        }
                                        let _e841 = phi_1103_;
                                        if (_e841 < _e74) {
                                        } else {
                                            return;
                                        }
                                        let _e848 = triangles.member[(0u + _e841)].v0_;
                                        let _e850 = (_e848.x - _e118);
                                        let _e852 = (_e848.y - _e120);
                                        let _e854 = (_e848.z - _e122);
                                        if (_e507 == 0u) {
                                            phi_1133_ = vec3<f32>(_e852, _e854, _e850);
                                        } else {
                                            if (_e507 == 1u) {
                                                phi_1132_ = vec3<f32>(_e854, _e850, _e852);
                                            } else {
                                                phi_1132_ = (_e848 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e862 = phi_1132_;
                                            phi_1133_ = _e862;
                                        }
                                        let _e864 = phi_1133_;
                                        let _e868 = (_e864.x - (_e518 * _e864.z));
                                        let _e872 = (_e864.y - (_e521 * _e864.z));
                                        let _e874 = triangles.member[(0u + _e841)].v1_;
                                        let _e876 = (_e874.x - _e118);
                                        let _e878 = (_e874.y - _e120);
                                        let _e880 = (_e874.z - _e122);
                                        if (_e507 == 0u) {
                                            phi_1163_ = vec3<f32>(_e878, _e880, _e876);
                                        } else {
                                            if (_e507 == 1u) {
                                                phi_1162_ = vec3<f32>(_e880, _e876, _e878);
                                            } else {
                                                phi_1162_ = (_e874 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e888 = phi_1162_;
                                            phi_1163_ = _e888;
                                        }
                                        let _e890 = phi_1163_;
                                        let _e894 = (_e890.x - (_e518 * _e890.z));
                                        let _e898 = (_e890.y - (_e521 * _e890.z));
                                        let _e900 = triangles.member[(0u + _e841)].v2_;
                                        let _e902 = (_e900.x - _e118);
                                        let _e904 = (_e900.y - _e120);
                                        let _e906 = (_e900.z - _e122);
                                        if (_e507 == 0u) {
                                            phi_1193_ = vec3<f32>(_e904, _e906, _e902);
                                        } else {
                                            if (_e507 == 1u) {
                                                phi_1192_ = vec3<f32>(_e906, _e902, _e904);
                                            } else {
                                                phi_1192_ = (_e900 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e914 = phi_1192_;
                                            phi_1193_ = _e914;
                                        }
                                        let _e916 = phi_1193_;
                                        let _e920 = (_e916.x - (_e518 * _e916.z));
                                        let _e924 = (_e916.y - (_e521 * _e916.z));
                                        if (_e894 < _e920) {
                                            phi_1212_ = true;
                                        } else {
                                            if (_e894 == _e920) {
                                                phi_1211_ = (_e898 < _e924);
                                            } else {
                                                phi_1211_ = false;
                                            }
                                            let _e929 = phi_1211_;
                                            phi_1212_ = _e929;
                                        }
                                        let _e931 = phi_1212_;
                                        if _e931 {
                                            phi_1216_ = _e924;
                                            phi_1217_ = _e920;
                                            phi_1218_ = _e898;
                                            phi_1219_ = _e894;
                                        } else {
                                            phi_1216_ = _e898;
                                            phi_1217_ = _e894;
                                            phi_1218_ = _e924;
                                            phi_1219_ = _e920;
                                        }
                                        let _e933 = phi_1216_;
                                        let _e935 = phi_1217_;
                                        let _e937 = phi_1218_;
                                        let _e939 = phi_1219_;
                                        let _e942 = ((_e939 * _e933) - (_e937 * _e935));
                                        if _e931 {
                                            phi_1227_ = -(_e942);
                                        } else {
                                            phi_1227_ = _e942;
                                        }
                                        let _e945 = phi_1227_;
                                        if (_e920 < _e868) {
                                            phi_1238_ = true;
                                        } else {
                                            if (_e920 == _e868) {
                                                phi_1237_ = (_e924 < _e872);
                                            } else {
                                                phi_1237_ = false;
                                            }
                                            let _e950 = phi_1237_;
                                            phi_1238_ = _e950;
                                        }
                                        let _e952 = phi_1238_;
                                        if _e952 {
                                            phi_1242_ = _e872;
                                            phi_1243_ = _e868;
                                            phi_1244_ = _e924;
                                            phi_1245_ = _e920;
                                        } else {
                                            phi_1242_ = _e924;
                                            phi_1243_ = _e920;
                                            phi_1244_ = _e872;
                                            phi_1245_ = _e868;
                                        }
                                        let _e954 = phi_1242_;
                                        let _e956 = phi_1243_;
                                        let _e958 = phi_1244_;
                                        let _e960 = phi_1245_;
                                        let _e963 = ((_e960 * _e954) - (_e958 * _e956));
                                        if _e952 {
                                            phi_1253_ = -(_e963);
                                        } else {
                                            phi_1253_ = _e963;
                                        }
                                        let _e966 = phi_1253_;
                                        if (_e868 < _e894) {
                                            phi_1264_ = true;
                                        } else {
                                            if (_e868 == _e894) {
                                                phi_1263_ = (_e872 < _e898);
                                            } else {
                                                phi_1263_ = false;
                                            }
                                            let _e971 = phi_1263_;
                                            phi_1264_ = _e971;
                                        }
                                        let _e973 = phi_1264_;
                                        if _e973 {
                                            phi_1268_ = _e898;
                                            phi_1269_ = _e894;
                                            phi_1270_ = _e872;
                                            phi_1271_ = _e868;
                                        } else {
                                            phi_1268_ = _e872;
                                            phi_1269_ = _e868;
                                            phi_1270_ = _e898;
                                            phi_1271_ = _e894;
                                        }
                                        let _e975 = phi_1268_;
                                        let _e977 = phi_1269_;
                                        let _e979 = phi_1270_;
                                        let _e981 = phi_1271_;
                                        let _e984 = ((_e981 * _e975) - (_e979 * _e977));
                                        if _e973 {
                                            phi_1279_ = -(_e984);
                                        } else {
                                            phi_1279_ = _e984;
                                        }
                                        let _e987 = phi_1279_;
                                        if (_e945 >= 0f) {
                                            if (_e966 >= 0f) {
                                                if (_e987 >= 0f) {
                                                    phi_1294_ = ((_e945 + _e966) + _e987);
                                                    phi_1295_ = false;
                                                } else {
                                                    phi_1294_ = f32();
                                                    phi_1295_ = true;
                                                }
                                                let _e994 = phi_1294_;
                                                let _e996 = phi_1295_;
                                                phi_1296_ = _e994;
                                                phi_1297_ = _e996;
                                            } else {
                                                phi_1296_ = f32();
                                                phi_1297_ = true;
                                            }
                                            let _e998 = phi_1296_;
                                            let _e1000 = phi_1297_;
                                            phi_1298_ = _e998;
                                            phi_1299_ = _e1000;
                                        } else {
                                            phi_1298_ = f32();
                                            phi_1299_ = true;
                                        }
                                        let _e1002 = phi_1298_;
                                        let _e1004 = phi_1299_;
                                        if _e1004 {
                                            if (_e945 <= 0f) {
                                                if (_e966 <= 0f) {
                                                    let _e1007 = (_e987 <= 0f);
                                                    if _e1007 {
                                                    }
                                                    phi_1317_ = ((_e945 + _e966) + _e987);
                                                    phi_1318_ = false;
                                                    phi_1319_ = _e1007;
                                                } else {
                                                    phi_1317_ = f32();
                                                    phi_1318_ = true;
                                                    phi_1319_ = false;
                                                }
                                                let _e1011 = phi_1317_;
                                                let _e1013 = phi_1318_;
                                                let _e1015 = phi_1319_;
                                                phi_1320_ = _e1011;
                                                phi_1321_ = _e1013;
                                                phi_1322_ = _e1015;
                                            } else {
                                                phi_1320_ = f32();
                                                phi_1321_ = true;
                                                phi_1322_ = false;
                                            }
                                            let _e1017 = phi_1320_;
                                            let _e1019 = phi_1321_;
                                            let _e1021 = phi_1322_;
                                            if _e1019 {
                                                phi_1326_ = false;
                                            } else {
                                                phi_1326_ = _e1021;
                                            }
                                            let _e1023 = phi_1326_;
                                            phi_1327_ = _e1017;
                                            phi_1328_ = _e1023;
                                        } else {
                                            phi_1327_ = _e1002;
                                            phi_1328_ = true;
                                        }
                                        let _e1025 = phi_1327_;
                                        let _e1027 = phi_1328_;
                                        if _e1027 {
                                            let _e1028 = (_e1025 == 0f);
                                            if _e1028 {
                                                phi_1644_ = lt_bvh_triangle_Intersection();
                                                phi_1645_ = false;
                                            } else {
                                                let _e1030 = triangles.member[(0u + _e841)].v0_;
                                                let _e1032 = (_e1030.x - _e118);
                                                let _e1034 = (_e1030.y - _e120);
                                                let _e1036 = (_e1030.z - _e122);
                                                if (_e507 == 0u) {
                                                    phi_1357_ = vec3<f32>(_e1034, _e1036, _e1032);
                                                } else {
                                                    if (_e507 == 1u) {
                                                        phi_1356_ = vec3<f32>(_e1036, _e1032, _e1034);
                                                    } else {
                                                        phi_1356_ = (_e1030 - vec3<f32>(_e118, _e120, _e122));
                                                    }
                                                    let _e1044 = phi_1356_;
                                                    phi_1357_ = _e1044;
                                                }
                                                let _e1046 = phi_1357_;
                                                let _e1048 = triangles.member[(0u + _e841)].v1_;
                                                let _e1050 = triangles.member[(0u + _e841)].v0_;
                                                let _e1053 = (_e1048.x - _e1050.x);
                                                let _e1056 = (_e1048.y - _e1050.y);
                                                let _e1059 = (_e1048.z - _e1050.z);
                                                if (_e507 == 0u) {
                                                    phi_1383_ = vec3<f32>(_e1056, _e1059, _e1053);
                                                } else {
                                                    if (_e507 == 1u) {
                                                        phi_1382_ = vec3<f32>(_e1059, _e1053, _e1056);
                                                    } else {
                                                        phi_1382_ = (_e1048 - _e1050);
                                                    }
                                                    let _e1066 = phi_1382_;
                                                    phi_1383_ = _e1066;
                                                }
                                                let _e1068 = phi_1383_;
                                                let _e1070 = triangles.member[(0u + _e841)].v2_;
                                                let _e1072 = triangles.member[(0u + _e841)].v0_;
                                                let _e1075 = (_e1070.x - _e1072.x);
                                                let _e1078 = (_e1070.y - _e1072.y);
                                                let _e1081 = (_e1070.z - _e1072.z);
                                                if (_e507 == 0u) {
                                                    phi_1409_ = vec3<f32>(_e1078, _e1081, _e1075);
                                                } else {
                                                    if (_e507 == 1u) {
                                                        phi_1408_ = vec3<f32>(_e1081, _e1075, _e1078);
                                                    } else {
                                                        phi_1408_ = (_e1070 - _e1072);
                                                    }
                                                    let _e1088 = phi_1408_;
                                                    phi_1409_ = _e1088;
                                                }
                                                let _e1090 = phi_1409_;
                                                let _e1097 = ((_e1068.y * _e1090.z) - (_e1068.z * _e1090.y));
                                                let _e1104 = ((_e1068.z * _e1090.x) - (_e1068.x * _e1090.z));
                                                let _e1111 = ((_e1068.x * _e1090.y) - (_e1068.y * _e1090.x));
                                                let _e1125 = (((1f / _e515.z) * (((_e1097 * _e1046.x) + (_e1104 * _e1046.y)) + (_e1111 * _e1046.z))) / (((_e1097 * _e518) + (_e1104 * _e521)) + _e1111));
                                                if (_e1125 > 0f) {
                                                    if (_e1125 < _e130) {
                                                        let _e1129 = triangles.member[(0u + _e841)].v0_;
                                                        let _e1131 = triangles.member[(0u + _e841)].v1_;
                                                        if (_e1129.x < _e1131.x) {
                                                            phi_1465_ = _e1129.x;
                                                        } else {
                                                            phi_1465_ = _e1131.x;
                                                        }
                                                        let _e1138 = phi_1465_;
                                                        if (_e1129.y < _e1131.y) {
                                                            phi_1474_ = _e1129.y;
                                                        } else {
                                                            phi_1474_ = _e1131.y;
                                                        }
                                                        let _e1145 = phi_1474_;
                                                        if (_e1129.z < _e1131.z) {
                                                            phi_1483_ = _e1129.z;
                                                        } else {
                                                            phi_1483_ = _e1131.z;
                                                        }
                                                        let _e1152 = phi_1483_;
                                                        let _e1154 = triangles.member[(0u + _e841)].v2_;
                                                        if (_e1138 < _e1154.x) {
                                                            phi_1492_ = _e1138;
                                                        } else {
                                                            phi_1492_ = _e1154.x;
                                                        }
                                                        let _e1159 = phi_1492_;
                                                        if (_e1145 < _e1154.y) {
                                                            phi_1499_ = _e1145;
                                                        } else {
                                                            phi_1499_ = _e1154.y;
                                                        }
                                                        let _e1164 = phi_1499_;
                                                        if (_e1152 < _e1154.z) {
                                                            phi_1506_ = _e1152;
                                                        } else {
                                                            phi_1506_ = _e1154.z;
                                                        }
                                                        let _e1169 = phi_1506_;
                                                        let _e1171 = triangles.member[(0u + _e841)].v0_;
                                                        let _e1173 = triangles.member[(0u + _e841)].v1_;
                                                        if (_e1171.x > _e1173.x) {
                                                            phi_1519_ = _e1171.x;
                                                        } else {
                                                            phi_1519_ = _e1173.x;
                                                        }
                                                        let _e1180 = phi_1519_;
                                                        if (_e1171.y > _e1173.y) {
                                                            phi_1528_ = _e1171.y;
                                                        } else {
                                                            phi_1528_ = _e1173.y;
                                                        }
                                                        let _e1187 = phi_1528_;
                                                        if (_e1171.z > _e1173.z) {
                                                            phi_1537_ = _e1171.z;
                                                        } else {
                                                            phi_1537_ = _e1173.z;
                                                        }
                                                        let _e1194 = phi_1537_;
                                                        let _e1196 = triangles.member[(0u + _e841)].v2_;
                                                        if (_e1180 > _e1196.x) {
                                                            phi_1546_ = _e1180;
                                                        } else {
                                                            phi_1546_ = _e1196.x;
                                                        }
                                                        let _e1201 = phi_1546_;
                                                        if (_e1187 > _e1196.y) {
                                                            phi_1553_ = _e1187;
                                                        } else {
                                                            phi_1553_ = _e1196.y;
                                                        }
                                                        let _e1206 = phi_1553_;
                                                        if (_e1194 > _e1196.z) {
                                                            phi_1560_ = _e1194;
                                                        } else {
                                                            phi_1560_ = _e1196.z;
                                                        }
                                                        let _e1211 = phi_1560_;
                                                        let _e1215 = ((_e1159 - _e118) * _e436);
                                                        let _e1216 = ((_e1164 - _e120) * _e446);
                                                        let _e1217 = ((_e1169 - _e122) * _e456);
                                                        let _e1221 = ((_e1201 - _e118) * _e436);
                                                        let _e1222 = ((_e1206 - _e120) * _e446);
                                                        let _e1223 = ((_e1211 - _e122) * _e456);
                                                        if (_e1215 < _e1221) {
                                                            phi_1577_ = _e1215;
                                                        } else {
                                                            phi_1577_ = _e1221;
                                                        }
                                                        let _e1226 = phi_1577_;
                                                        if (_e1216 < _e1222) {
                                                            phi_1582_ = _e1216;
                                                        } else {
                                                            phi_1582_ = _e1222;
                                                        }
                                                        let _e1229 = phi_1582_;
                                                        if (_e1217 < _e1223) {
                                                            phi_1587_ = _e1217;
                                                        } else {
                                                            phi_1587_ = _e1223;
                                                        }
                                                        let _e1232 = phi_1587_;
                                                        if (_e1215 > _e1221) {
                                                            phi_1595_ = _e1215;
                                                        } else {
                                                            phi_1595_ = _e1221;
                                                        }
                                                        let _e1238 = phi_1595_;
                                                        if (_e1216 > _e1222) {
                                                            phi_1600_ = _e1216;
                                                        } else {
                                                            phi_1600_ = _e1222;
                                                        }
                                                        let _e1241 = phi_1600_;
                                                        if (_e1217 > _e1223) {
                                                            phi_1605_ = _e1217;
                                                        } else {
                                                            phi_1605_ = _e1223;
                                                        }
                                                        let _e1244 = phi_1605_;
                                                        let _e1248 = core_intrinsics_maximum_number_nsz_f32_((_e1226 - _e491), (_e1229 - _e492));
                                                        let _e1249 = core_intrinsics_maximum_number_nsz_f32_(_e1248, (_e1232 - _e493));
                                                        let _e1250 = core_intrinsics_minimum_number_nsz_f32_((_e1238 + _e491), (_e1241 + _e492));
                                                        let _e1251 = core_intrinsics_minimum_number_nsz_f32_(_e1250, (_e1244 + _e493));
                                                        if (_e1249 > -300000000000000000000000000000000000000f) {
                                                            phi_1617_ = _e1249;
                                                        } else {
                                                            phi_1617_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1254 = phi_1617_;
                                                        if (_e1251 < 300000000000000000000000000000000000000f) {
                                                            phi_1622_ = _e1251;
                                                        } else {
                                                            phi_1622_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1257 = phi_1622_;
                                                        if (_e1125 < _e1254) {
                                                            phi_1627_ = _e1254;
                                                        } else {
                                                            phi_1627_ = _e1125;
                                                        }
                                                        let _e1260 = phi_1627_;
                                                        if (_e1260 > _e1257) {
                                                            phi_1632_ = _e1257;
                                                        } else {
                                                            phi_1632_ = _e1260;
                                                        }
                                                        let _e1263 = phi_1632_;
                                                        phi_1637_ = lt_bvh_triangle_Intersection(_e1263, (_e966 / _e1025), (_e987 / _e1025), (_e1254 <= _e1257));
                                                        phi_1638_ = false;
                                                    } else {
                                                        phi_1637_ = lt_bvh_triangle_Intersection();
                                                        phi_1638_ = true;
                                                    }
                                                    let _e1269 = phi_1637_;
                                                    let _e1271 = phi_1638_;
                                                    phi_1639_ = _e1269;
                                                    phi_1640_ = _e1271;
                                                } else {
                                                    phi_1639_ = lt_bvh_triangle_Intersection();
                                                    phi_1640_ = true;
                                                }
                                                let _e1273 = phi_1639_;
                                                let _e1275 = phi_1640_;
                                                if _e1275 {
                                                }
                                                phi_1644_ = _e1273;
                                                phi_1645_ = _e1275;
                                            }
                                            let _e1277 = phi_1644_;
                                            let _e1279 = phi_1645_;
                                            phi_1646_ = _e1277;
                                            phi_1647_ = _e1028;
                                            phi_1648_ = _e1279;
                                        } else {
                                            phi_1646_ = lt_bvh_triangle_Intersection();
                                            phi_1647_ = true;
                                            phi_1648_ = false;
                                        }
                                        let _e1281 = phi_1646_;
                                        let _e1283 = phi_1647_;
                                        let _e1285 = phi_1648_;
                                        if _e1283 {
                                            phi_1652_ = true;
                                        } else {
                                            phi_1652_ = _e1285;
                                        }
                                        let _e1287 = phi_1652_;
                                        if _e1287 {
                                            phi_1656_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_1656_ = _e1281;
                                        }
                                        let _e1289 = phi_1656_;
                                        if _e1289.is_hit {
                                            if (_e1289.t > 0f) {
                                                if (_e1289.t < _e130) {
                                                    let _e1296 = triangles.member[(0u + _e841)].i0_;
                                                    let _e1298 = ((_e1296 & 2147483648u) == 0u);
                                                    if _e1298 {
                                                        phi_1682_ = false;
                                                        phi_1683_ = false;
                                                    } else {
                                                        if true {
                                                            phi_1681_ = false;
                                                        } else {
                                                            phi_1681_ = true;
                                                        }
                                                        let _e1300 = phi_1681_;
                                                        phi_1682_ = _e1300;
                                                        phi_1683_ = true;
                                                    }
                                                    let _e1302 = phi_1682_;
                                                    let _e1304 = phi_1683_;
                                                    phi_1684_ = _e1302;
                                                    phi_1685_ = _e1298;
                                                    phi_1686_ = _e1304;
                                                } else {
                                                    phi_1684_ = true;
                                                    phi_1685_ = false;
                                                    phi_1686_ = false;
                                                }
                                                let _e1306 = phi_1684_;
                                                let _e1308 = phi_1685_;
                                                let _e1310 = phi_1686_;
                                                phi_1687_ = false;
                                                phi_1688_ = _e1306;
                                                phi_1689_ = _e1308;
                                                phi_1690_ = _e1310;
                                            } else {
                                                phi_1687_ = true;
                                                phi_1688_ = false;
                                                phi_1689_ = false;
                                                phi_1690_ = false;
                                            }
                                            let _e1312 = phi_1687_;
                                            let _e1314 = phi_1688_;
                                            let _e1316 = phi_1689_;
                                            let _e1318 = phi_1690_;
                                            phi_1691_ = _e1312;
                                            phi_1692_ = _e1314;
                                            phi_1693_ = _e1316;
                                            phi_1694_ = _e1318;
                                        } else {
                                            phi_1691_ = true;
                                            phi_1692_ = false;
                                            phi_1693_ = false;
                                            phi_1694_ = false;
                                        }
                                        let _e1320 = phi_1691_;
                                        let _e1322 = phi_1692_;
                                        let _e1324 = phi_1693_;
                                        let _e1326 = phi_1694_;
                                        if _e1320 {
                                            phi_1698_ = true;
                                            phi_1699_ = false;
                                            phi_1700_ = false;
                                        } else {
                                            phi_1698_ = _e1322;
                                            phi_1699_ = _e1324;
                                            phi_1700_ = _e1326;
                                        }
                                        let _e1328 = phi_1698_;
                                        let _e1330 = phi_1699_;
                                        let _e1332 = phi_1700_;
                                        if _e1328 {
                                            phi_1704_ = false;
                                            phi_1705_ = false;
                                        } else {
                                            phi_1704_ = _e1330;
                                            phi_1705_ = _e1332;
                                        }
                                        let _e1334 = phi_1704_;
                                        let _e1336 = phi_1705_;
                                        phi_1057_ = (_e805 & (_e805 - 1u));
                                        phi_1706_ = _e1328;
                                        phi_1707_ = _e1334;
                                        phi_1708_ = _e1336;
                                    }
                                    let _e1338 = phi_1057_;
                                    let _e1340 = phi_1706_;
                                    let _e1342 = phi_1707_;
                                    let _e1344 = phi_1708_;
                                    local_9 = _e1342;
                                    local_10 = _e1344;
                                    continue;
                                    continuing {
                                        phi_1056_ = _e1338;
                                        break if !(_e1340);
                                    }
                                }
                                let _e1347 = local_2;
                                if _e1347 {
                                    phi_1712_ = false;
                                    phi_1713_ = false;
                                } else {
                                    let _e3023 = local_9;
                                    phi_1712_ = _e3023;
                                    let _e3026 = local_10;
                                    phi_1713_ = _e3026;
                                }
                                let _e1349 = phi_1712_;
                                let _e1351 = phi_1713_;
                                phi_1741_ = _e539;
                                phi_1742_ = _e530;
                                let _e3035 = local_11;
                                phi_1743_ = _e3035;
                                phi_1744_ = _e1349;
                                phi_1745_ = _e1351;
                            } else {
                                if (_e799 == 0u) {
                                    phi_1739_ = _e539;
                                    phi_1740_ = _e530;
                                } else {
                                    if ((_e539 & 255u) == 0u) {
                                        phi_1735_ = _e530;
                                    } else {
                                        if (_e530 < 32u) {
                                            if (_e530 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1[(0u + _e530)] = _e539;
                                            phi_1734_ = (_e530 + 1u);
                                        } else {
                                            phi_1734_ = _e530;
                                        }
                                        let _e1361 = phi_1734_;
                                        phi_1735_ = _e1361;
                                    }
                                    let _e1363 = phi_1735_;
                                    phi_1739_ = ((_e560.rest.z << bitcast<u32>(8i)) | _e799);
                                    phi_1740_ = _e1363;
                                }
                                let _e1370 = phi_1739_;
                                let _e1372 = phi_1740_;
                                phi_1741_ = _e1370;
                                phi_1742_ = _e1372;
                                phi_1743_ = true;
                                phi_1744_ = false;
                                phi_1745_ = false;
                            }
                            let _e1374 = phi_1741_;
                            let _e1376 = phi_1742_;
                            let _e1378 = phi_1743_;
                            let _e1380 = phi_1744_;
                            let _e1382 = phi_1745_;
                            if _e1378 {
                                if ((_e1374 & 255u) == 0u) {
                                    if (_e1376 > 0u) {
                                        let _e1386 = (_e1376 - 1u);
                                        if (_e1386 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1390 = local_1[(0u + _e1386)];
                                        phi_1766_ = _e1390;
                                        phi_1767_ = _e1386;
                                    } else {
                                        phi_1766_ = 0u;
                                        phi_1767_ = _e1376;
                                    }
                                    let _e1392 = phi_1766_;
                                    let _e1394 = phi_1767_;
                                    phi_1768_ = _e1392;
                                    phi_1769_ = _e1394;
                                } else {
                                    phi_1768_ = _e1374;
                                    phi_1769_ = _e1376;
                                }
                                let _e1396 = phi_1768_;
                                let _e1398 = phi_1769_;
                                phi_1770_ = _e1396;
                                phi_1771_ = _e1398;
                                phi_1772_ = false;
                                phi_1773_ = false;
                            } else {
                                phi_1770_ = u32();
                                phi_1771_ = u32();
                                phi_1772_ = _e1380;
                                phi_1773_ = _e1382;
                            }
                            let _e1400 = phi_1770_;
                            let _e1402 = phi_1771_;
                            let _e1404 = phi_1772_;
                            let _e1406 = phi_1773_;
                            phi_767_ = _e1400;
                            phi_770_ = _e1402;
                            phi_1774_ = _e1378;
                            phi_1775_ = _e1404;
                            phi_1776_ = _e1406;
                        }
                        let _e1408 = phi_767_;
                        let _e1410 = phi_770_;
                        let _e1412 = phi_1774_;
                        let _e1414 = phi_1775_;
                        let _e1416 = phi_1776_;
                        local_12 = _e1414;
                        local_13 = _e1416;
                        continue;
                        continuing {
                            phi_766_ = _e1408;
                            phi_769_ = _e1410;
                            break if !(_e1412);
                        }
                    }
                    let _e1419 = local_3;
                    if _e1419 {
                        phi_1780_ = false;
                        phi_1781_ = false;
                    } else {
                        let _e3054 = local_12;
                        phi_1780_ = _e3054;
                        let _e3057 = local_13;
                        phi_1781_ = _e3057;
                    }
                    let _e1421 = phi_1780_;
                    let _e1423 = phi_1781_;
                    if _e1421 {
                        phi_1785_ = false;
                    } else {
                        phi_1785_ = _e1423;
                    }
                    let _e1425 = phi_1785_;
                    if _e1425 {
                        phi_1789_ = true;
                    } else {
                        phi_1789_ = _e1421;
                    }
                    let _e1427 = phi_1789_;
                    if _e1427 {
                    }
                    phi_1793_ = true;
                    phi_1794_ = _e1427;
                }
                let _e1429 = phi_1793_;
                let _e1431 = phi_1794_;
                if _e1431 {
                    phi_1798_ = _e1429;
                } else {
                    phi_1798_ = false;
                }
                let _e1433 = phi_1798_;
                phi_3255_ = _e1433;
            } else {
                let _e1434 = abs(_e138);
                let _e1435 = abs(_e139);
                let _e1436 = abs(_e140);
                if (abs(_e118) < 1000000000000000f) {
                    if (abs(_e120) < 1000000000000000f) {
                        phi_1814_ = (abs(_e122) < 1000000000000000f);
                        phi_1815_ = false;
                    } else {
                        phi_1814_ = bool();
                        phi_1815_ = true;
                    }
                    let _e1444 = phi_1814_;
                    let _e1446 = phi_1815_;
                    phi_1816_ = _e1444;
                    phi_1817_ = _e1446;
                } else {
                    phi_1816_ = bool();
                    phi_1817_ = true;
                }
                let _e1448 = phi_1816_;
                let _e1450 = phi_1817_;
                if _e1450 {
                    phi_1821_ = false;
                } else {
                    phi_1821_ = _e1448;
                }
                let _e1452 = phi_1821_;
                if _e1452 {
                    if (_e1434 < 1000000000000000f) {
                        if (_e1435 < 1000000000000000f) {
                            phi_1834_ = (_e1436 < 1000000000000000f);
                            phi_1835_ = false;
                        } else {
                            phi_1834_ = bool();
                            phi_1835_ = true;
                        }
                        let _e1457 = phi_1834_;
                        let _e1459 = phi_1835_;
                        phi_1836_ = _e1457;
                        phi_1837_ = _e1459;
                    } else {
                        phi_1836_ = bool();
                        phi_1837_ = true;
                    }
                    let _e1461 = phi_1836_;
                    let _e1463 = phi_1837_;
                    if _e1463 {
                        phi_1841_ = false;
                    } else {
                        phi_1841_ = _e1461;
                    }
                    let _e1465 = phi_1841_;
                    if _e1465 {
                        if (_e1434 > 0f) {
                            phi_1855_ = bool();
                            phi_1856_ = true;
                        } else {
                            let _e1467 = (_e1435 > 0f);
                            if _e1467 {
                                phi_1854_ = bool();
                            } else {
                                phi_1854_ = (_e1436 > 0f);
                            }
                            let _e1470 = phi_1854_;
                            phi_1855_ = _e1470;
                            phi_1856_ = _e1467;
                        }
                        let _e1472 = phi_1855_;
                        let _e1474 = phi_1856_;
                        if _e1474 {
                            phi_1860_ = true;
                        } else {
                            phi_1860_ = _e1472;
                        }
                        let _e1476 = phi_1860_;
                        phi_1861_ = _e1476;
                        phi_1862_ = false;
                    } else {
                        phi_1861_ = bool();
                        phi_1862_ = true;
                    }
                    let _e1478 = phi_1861_;
                    let _e1480 = phi_1862_;
                    phi_1863_ = _e1478;
                    phi_1864_ = _e1480;
                } else {
                    phi_1863_ = bool();
                    phi_1864_ = true;
                }
                let _e1482 = phi_1863_;
                let _e1484 = phi_1864_;
                if _e1484 {
                    phi_1868_ = false;
                } else {
                    phi_1868_ = _e1482;
                }
                let _e1486 = phi_1868_;
                if _e1486 {
                    let _e1487 = (0u >= _e71);
                    if _e1487 {
                        phi_3248_ = bool();
                    } else {
                        if (0u < _e71) {
                        } else {
                            return;
                        }
                        let _e1493 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1497 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1501 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1505 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1509 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1513 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1517 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1551 = core_intrinsics_maximum_number_nsz_f32_(abs(_e138), abs(_e139));
                        let _e1552 = core_intrinsics_maximum_number_nsz_f32_(_e1551, abs(_e140));
                        let _e1553 = (_e1552 * 0.0000000000009094947f);
                        if (abs(_e138) < _e1553) {
                            phi_1938_ = _e1553;
                        } else {
                            phi_1938_ = abs(_e138);
                        }
                        let _e1558 = phi_1938_;
                        if (_e138 < 0f) {
                            phi_1945_ = (-1f / _e1558);
                        } else {
                            phi_1945_ = (1f / _e1558);
                        }
                        let _e1563 = phi_1945_;
                        if (abs(_e139) < _e1553) {
                            phi_1952_ = _e1553;
                        } else {
                            phi_1952_ = abs(_e139);
                        }
                        let _e1568 = phi_1952_;
                        if (_e139 < 0f) {
                            phi_1959_ = (-1f / _e1568);
                        } else {
                            phi_1959_ = (1f / _e1568);
                        }
                        let _e1573 = phi_1959_;
                        if (abs(_e140) < _e1553) {
                            phi_1966_ = _e1553;
                        } else {
                            phi_1966_ = abs(_e140);
                        }
                        let _e1578 = phi_1966_;
                        if (_e140 < 0f) {
                            phi_1973_ = (-1f / _e1578);
                        } else {
                            phi_1973_ = (1f / _e1578);
                        }
                        let _e1583 = phi_1973_;
                        let _e1587 = abs((bitcast<f32>(_e1493) - _e118));
                        let _e1588 = abs((bitcast<f32>(_e1497) - _e120));
                        let _e1589 = abs((bitcast<f32>(_e1501) - _e122));
                        let _e1593 = abs(((bitcast<f32>(_e1505) + (bitcast<f32>((((_e1517 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e118));
                        let _e1594 = abs(((bitcast<f32>(_e1509) + (bitcast<f32>((((_e1517 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                        let _e1595 = abs(((bitcast<f32>(_e1513) + (bitcast<f32>((((_e1517 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                        if (_e1587 > _e1593) {
                            phi_1990_ = _e1587;
                        } else {
                            phi_1990_ = _e1593;
                        }
                        let _e1598 = phi_1990_;
                        if (_e1588 > _e1594) {
                            phi_1995_ = _e1588;
                        } else {
                            phi_1995_ = _e1594;
                        }
                        let _e1601 = phi_1995_;
                        if (_e1589 > _e1595) {
                            phi_2000_ = _e1589;
                        } else {
                            phi_2000_ = _e1595;
                        }
                        let _e1604 = phi_2000_;
                        if (_e1598 > _e1601) {
                            phi_2005_ = _e1598;
                        } else {
                            phi_2005_ = _e1601;
                        }
                        let _e1607 = phi_2005_;
                        if (_e1607 > _e1604) {
                            phi_2010_ = _e1607;
                        } else {
                            phi_2010_ = _e1604;
                        }
                        let _e1610 = phi_2010_;
                        let _e1614 = (_e1610 * 0.0000019073486f);
                        let _e1615 = (abs(_e1563) * _e1614);
                        let _e1616 = (abs(_e1573) * _e1614);
                        let _e1617 = (abs(_e1583) * _e1614);
                        let _e1621 = (_e1610 * 0.0000009536743f);
                        let _e1622 = (abs(_e1563) * _e1621);
                        let _e1623 = (abs(_e1573) * _e1621);
                        let _e1624 = (abs(_e1583) * _e1621);
                        let _e1625 = abs(_e138);
                        let _e1626 = abs(_e139);
                        let _e1627 = abs(_e140);
                        if (_e1625 >= _e1626) {
                            if (_e1625 >= _e1627) {
                                phi_2036_ = false;
                            } else {
                                phi_2036_ = true;
                            }
                            let _e1631 = phi_2036_;
                            phi_2037_ = _e1631;
                        } else {
                            phi_2037_ = true;
                        }
                        let _e1633 = phi_2037_;
                        if _e1633 {
                            if (_e1626 >= _e1627) {
                                phi_2045_ = 1u;
                            } else {
                                phi_2045_ = 2u;
                            }
                            let _e1636 = phi_2045_;
                            phi_2046_ = _e1636;
                        } else {
                            phi_2046_ = 0u;
                        }
                        let _e1638 = phi_2046_;
                        if (_e1638 == 0u) {
                            phi_2058_ = vec3<f32>(_e139, _e140, _e138);
                        } else {
                            if (_e1638 == 1u) {
                                phi_2057_ = vec3<f32>(_e140, _e138, _e139);
                            } else {
                                phi_2057_ = _e141;
                            }
                            let _e1644 = phi_2057_;
                            phi_2058_ = _e1644;
                        }
                        let _e1646 = phi_2058_;
                        let _e1649 = (_e1646.x / _e1646.z);
                        let _e1652 = (_e1646.y / _e1646.z);
                        if (_e1563 < 0f) {
                            phi_2071_ = 0u;
                        } else {
                            phi_2071_ = 1u;
                        }
                        let _e1657 = phi_2071_;
                        if (_e1573 < 0f) {
                            phi_2076_ = 0u;
                        } else {
                            phi_2076_ = 2u;
                        }
                        let _e1660 = phi_2076_;
                        if (_e1583 < 0f) {
                            phi_2081_ = 0u;
                        } else {
                            phi_2081_ = 4u;
                        }
                        let _e1663 = phi_2081_;
                        let _e1665 = ((_e1657 | _e1660) | _e1663);
                        let _e1666 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1666.first[0], _e1666.first[1], _e1666.first[2], _e1666.first[3], _e1666.first[4], _e1666.first[5], _e1666.first[6], _e1666.first[7], _e1666.first[8], _e1666.first[9], _e1666.first[10], _e1666.first[11], _e1666.first[12], _e1666.first[13], _e1666.first[14], _e1666.first[15], _e1666.first[16], _e1666.first[17], _e1666.first[18], _e1666.first[19], _e1666.first[20], _e1666.first[21], _e1666.first[22], _e1666.first[23], _e1666.first[24], _e1666.first[25], _e1666.first[26], _e1666.first[27], _e1666.first[28], _e1666.first[29], _e1666.first[30], _e1666.first[31]), array<u32, 32>(_e1666.mask[0], _e1666.mask[1], _e1666.mask[2], _e1666.mask[3], _e1666.mask[4], _e1666.mask[5], _e1666.mask[6], _e1666.mask[7], _e1666.mask[8], _e1666.mask[9], _e1666.mask[10], _e1666.mask[11], _e1666.mask[12], _e1666.mask[13], _e1666.mask[14], _e1666.mask[15], _e1666.mask[16], _e1666.mask[17], _e1666.mask[18], _e1666.mask[19], _e1666.mask[20], _e1666.mask[21], _e1666.mask[22], _e1666.mask[23], _e1666.mask[24], _e1666.mask[25], _e1666.mask[26], _e1666.mask[27], _e1666.mask[28], _e1666.mask[29], _e1666.mask[30], _e1666.mask[31]), _e1666.len, _e1666.group, _e1666.group_mask);
                        let _e1740 = local.group_mask;
                        if ((_e1740 & 4278190080u) == 0u) {
                            let _e1744 = local.len;
                            if (_e1744 == 0u) {
                                phi_2195_ = false;
                            } else {
                                let _e1748 = local.len;
                                local.len = (_e1748 - 1u);
                                let _e1751 = local.len;
                                if (_e1751 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1756 = local.first[(0u + _e1751)];
                                local.group = _e1756;
                                let _e1759 = local.len;
                                if (_e1759 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1764 = local.mask[(0u + _e1759)];
                                local.group_mask = _e1764;
                                phi_2195_ = true;
                            }
                            let _e1767 = phi_2195_;
                            phi_2196_ = _e1767;
                        } else {
                            phi_2196_ = true;
                        }
                        let _e1769 = phi_2196_;
                        if _e1769 {
                            let _e1771 = local.group_mask;
                            let _e1777 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1771)), 32u, (_e1771 == 0u)));
                            let _e1781 = local.group_mask;
                            let _e1795 = local.group_mask;
                            local.group_mask = (_e1795 & ~((1u << bitcast<u32>((_e1777 & 31u)))));
                            let _e1798 = local.group;
                            phi_2227_ = (_e1798 + countOneBits(((_e1781 & ~((4294967295u << bitcast<u32>((((_e1777 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2227_ = 4294967295u;
                        }
                        let _e1801 = phi_2227_;
                        phi_2229_ = _e1801;
                        phi_2232_ = false;
                        loop {
                            let _e1803 = phi_2229_;
                            let _e1805 = phi_2232_;
                            local_16 = _e1805;
                            if (_e1803 != 4294967295u) {
                                if (_e1803 < _e71) {
                                } else {
                                    return;
                                }
                                let _e1812 = nodes.member[(0u + _e1803)].frame[3u];
                                let _e1837 = (bitcast<f32>((((_e1812 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1563);
                                let _e1838 = (bitcast<f32>((((_e1812 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1573);
                                let _e1839 = (bitcast<f32>((((_e1812 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1583);
                                let _e1842 = nodes.member[(0u + _e1803)].frame[0u];
                                let _e1846 = nodes.member[(0u + _e1803)].frame[1u];
                                let _e1850 = nodes.member[(0u + _e1803)].frame[2u];
                                let _e1855 = ((bitcast<f32>(_e1842) - _e118) * _e1563);
                                let _e1856 = ((bitcast<f32>(_e1846) - _e120) * _e1573);
                                let _e1857 = ((bitcast<f32>(_e1850) - _e122) * _e1583);
                                let _e1865 = nodes.member[(0u + _e1803)].x;
                                if (_e1563 < 0f) {
                                    let _e1876 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1865.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1882 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1876.unnamed.word, _e1865.w), _e1876.unnamed_1);
                                    let _e1888 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1882.unnamed, lt_mask_LightPlace(_e1865.x, _e1882.unnamed_1.shift));
                                    phi_2312_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1888.unnamed, lt_mask_LightPlace(_e1888.unnamed_1.word, _e1865.y));
                                } else {
                                    let _e1904 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1865.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1910 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1904.unnamed.word, _e1865.y), _e1904.unnamed_1);
                                    let _e1916 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1910.unnamed, lt_mask_LightPlace(_e1865.z, _e1910.unnamed_1.shift));
                                    phi_2312_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1916.unnamed, lt_mask_LightPlace(_e1916.unnamed_1.word, _e1865.w));
                                }
                                let _e1924 = phi_2312_;
                                let _e1934 = nodes.member[(0u + _e1803)].y;
                                if (_e1573 < 0f) {
                                    let _e1945 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1934.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1951 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1945.unnamed.word, _e1934.w), _e1945.unnamed_1);
                                    let _e1957 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1951.unnamed, lt_mask_LightPlace(_e1934.x, _e1951.unnamed_1.shift));
                                    phi_2339_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1957.unnamed, lt_mask_LightPlace(_e1957.unnamed_1.word, _e1934.y));
                                } else {
                                    let _e1973 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1934.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1979 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1973.unnamed.word, _e1934.y), _e1973.unnamed_1);
                                    let _e1985 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1979.unnamed, lt_mask_LightPlace(_e1934.z, _e1979.unnamed_1.shift));
                                    phi_2339_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1985.unnamed, lt_mask_LightPlace(_e1985.unnamed_1.word, _e1934.w));
                                }
                                let _e1993 = phi_2339_;
                                let _e2003 = nodes.member[(0u + _e1803)].z;
                                if (_e1583 < 0f) {
                                    let _e2014 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2003.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2020 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2014.unnamed.word, _e2003.w), _e2014.unnamed_1);
                                    let _e2026 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2020.unnamed, lt_mask_LightPlace(_e2003.x, _e2020.unnamed_1.shift));
                                    phi_2366_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2026.unnamed, lt_mask_LightPlace(_e2026.unnamed_1.word, _e2003.y));
                                } else {
                                    let _e2042 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2003.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2048 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2042.unnamed.word, _e2003.y), _e2042.unnamed_1);
                                    let _e2054 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2048.unnamed, lt_mask_LightPlace(_e2003.z, _e2048.unnamed_1.shift));
                                    phi_2366_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2054.unnamed, lt_mask_LightPlace(_e2054.unnamed_1.word, _e2003.w));
                                }
                                let _e2062 = phi_2366_;
                                phi_2372_ = 0u;
                                phi_2375_ = 0u;
                                loop {
                                    let _e2072 = phi_2372_;
                                    let _e2074 = phi_2375_;
                                    local_4 = _e2074;
                                    local_5 = _e2074;
                                    local_6 = _e2074;
                                    let _e2075 = (_e2072 < 8u);
                                    if _e2075 {
                                        let _e2077 = (_e2072 >> bitcast<u32>(2i));
                                        let _e2078 = (_e2072 & 3u);
                                        if (_e2077 == 0u) {
                                            phi_2389_ = _e1924.unnamed.word;
                                        } else {
                                            phi_2389_ = _e1924.unnamed.shift;
                                        }
                                        let _e2081 = phi_2389_;
                                        if (_e2077 == 0u) {
                                            phi_2399_ = _e1993.unnamed.word;
                                        } else {
                                            phi_2399_ = _e1993.unnamed.shift;
                                        }
                                        let _e2090 = phi_2399_;
                                        if (_e2077 == 0u) {
                                            phi_2409_ = _e2062.unnamed.word;
                                        } else {
                                            phi_2409_ = _e2062.unnamed.shift;
                                        }
                                        let _e2099 = phi_2409_;
                                        let _e2112 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2081 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u)) * _e1837) + (_e1855 - _e1615)), ((f32(((_e2090 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u)) * _e1838) + (_e1856 - _e1616)));
                                        let _e2113 = core_intrinsics_maximum_number_nsz_f32_(_e2112, ((f32(((_e2099 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u)) * _e1839) + (_e1857 - _e1617)));
                                        if (_e2077 == 0u) {
                                            phi_2427_ = _e1924.unnamed_1.word;
                                        } else {
                                            phi_2427_ = _e1924.unnamed_1.shift;
                                        }
                                        let _e2116 = phi_2427_;
                                        if (_e2077 == 0u) {
                                            phi_2437_ = _e1993.unnamed_1.word;
                                        } else {
                                            phi_2437_ = _e1993.unnamed_1.shift;
                                        }
                                        let _e2125 = phi_2437_;
                                        if (_e2077 == 0u) {
                                            phi_2447_ = _e2062.unnamed_1.word;
                                        } else {
                                            phi_2447_ = _e2062.unnamed_1.shift;
                                        }
                                        let _e2134 = phi_2447_;
                                        let _e2147 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2116 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u)) * _e1837) + (_e1855 + _e1615)), ((f32(((_e2125 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u)) * _e1838) + (_e1856 + _e1616)));
                                        let _e2148 = core_intrinsics_minimum_number_nsz_f32_(_e2147, ((f32(((_e2134 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u)) * _e1839) + (_e1857 + _e1617)));
                                        if (_e2113 <= _e2148) {
                                            if (_e2113 <= _e130) {
                                                if (_e2148 >= 0f) {
                                                    if (_e2077 == 0u) {
                                                        let _e2155 = nodes.member[(0u + _e1803)].links[2u];
                                                        phi_2483_ = _e2155;
                                                    } else {
                                                        let _e2158 = nodes.member[(0u + _e1803)].links[3u];
                                                        phi_2483_ = _e2158;
                                                    }
                                                    let _e2160 = phi_2483_;
                                                    let _e2165 = ((_e2160 >> bitcast<u32>(((_e2078 * 8u) & 31u))) & 255u);
                                                    let _e2166 = (_e2165 & 31u);
                                                    if (_e2166 >= 24u) {
                                                        phi_2496_ = (24u + ((_e2166 - 24u) ^ _e1665));
                                                    } else {
                                                        phi_2496_ = _e2166;
                                                    }
                                                    let _e2172 = phi_2496_;
                                                    phi_2501_ = (_e2074 | ((_e2165 >> bitcast<u32>(5i)) << bitcast<u32>((_e2172 & 31u))));
                                                } else {
                                                    phi_2501_ = _e2074;
                                                }
                                                let _e2180 = phi_2501_;
                                                phi_2502_ = _e2180;
                                            } else {
                                                phi_2502_ = _e2074;
                                            }
                                            let _e2182 = phi_2502_;
                                            phi_2503_ = _e2182;
                                        } else {
                                            phi_2503_ = _e2074;
                                        }
                                        let _e2184 = phi_2503_;
                                        phi_2373_ = (_e2072 + 1u);
                                        phi_2376_ = _e2184;
                                    } else {
                                        phi_2373_ = u32();
                                        phi_2376_ = u32();
                                    }
                                    let _e2187 = phi_2373_;
                                    let _e2189 = phi_2376_;
                                    continue;
                                    continuing {
                                        phi_2372_ = _e2187;
                                        phi_2375_ = _e2189;
                                        break if !(_e2075);
                                    }
                                }
                                let _e2193 = nodes.member[(0u + _e1803)].links[0u];
                                let _e2197 = nodes.member[(0u + _e1803)].frame[3u];
                                let _e2201 = local_4;
                                if ((_e2201 & 4278190080u) == 0u) {
                                } else {
                                    let _e2205 = local.group_mask;
                                    if ((_e2205 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2209 = local.len;
                                        if (_e2209 < 32u) {
                                            let _e2212 = local.group;
                                            let _e2214 = local.len;
                                            if (_e2214 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2214)] = _e2212;
                                            let _e2220 = local.group_mask;
                                            let _e2222 = local.len;
                                            if (_e2222 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2222)] = _e2220;
                                            let _e2229 = local.len;
                                            local.len = (_e2229 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2193);
                                    let _e2233 = local_5;
                                    local.group_mask = ((_e2233 & 4278190080u) | (_e2197 >> bitcast<u32>(24i)));
                                }
                                let _e2238 = local_6;
                                phi_2561_ = (_e2238 & 16777215u);
                                phi_2564_ = _e1805;
                                loop {
                                    let _e2241 = phi_2561_;
                                    let _e2243 = phi_2564_;
                                    local_14 = _e2243;
                                    let _e2244 = (_e2241 == 0u);
                                    local_7 = _e2244;
                                    local_15 = _e2244;
                                    if _e2244 {
                                        phi_2562_ = u32();
                                        phi_2565_ = bool();
                                        phi_3162_ = false;
                                    } else {
                                        let _e2247 = nodes.member[(0u + _e1803)].links[1u];
                                        let _e2252 = ((0u + _e2247) + select(firstTrailingBit(_e2241), 32u, (_e2241 == 0u)));
                                        if (_e2252 < _e74) {
                                        } else {
                                            return;
                                        }
                                        let _e2259 = triangles.member[(0u + _e2252)].v0_;
                                        let _e2261 = (_e2259.x - _e118);
                                        let _e2263 = (_e2259.y - _e120);
                                        let _e2265 = (_e2259.z - _e122);
                                        if (_e1638 == 0u) {
                                            phi_2609_ = vec3<f32>(_e2263, _e2265, _e2261);
                                        } else {
                                            if (_e1638 == 1u) {
                                                phi_2608_ = vec3<f32>(_e2265, _e2261, _e2263);
                                            } else {
                                                phi_2608_ = (_e2259 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e2273 = phi_2608_;
                                            phi_2609_ = _e2273;
                                        }
                                        let _e2275 = phi_2609_;
                                        let _e2279 = (_e2275.x - (_e1649 * _e2275.z));
                                        let _e2283 = (_e2275.y - (_e1652 * _e2275.z));
                                        let _e2285 = triangles.member[(0u + _e2252)].v1_;
                                        let _e2287 = (_e2285.x - _e118);
                                        let _e2289 = (_e2285.y - _e120);
                                        let _e2291 = (_e2285.z - _e122);
                                        if (_e1638 == 0u) {
                                            phi_2639_ = vec3<f32>(_e2289, _e2291, _e2287);
                                        } else {
                                            if (_e1638 == 1u) {
                                                phi_2638_ = vec3<f32>(_e2291, _e2287, _e2289);
                                            } else {
                                                phi_2638_ = (_e2285 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e2299 = phi_2638_;
                                            phi_2639_ = _e2299;
                                        }
                                        let _e2301 = phi_2639_;
                                        let _e2305 = (_e2301.x - (_e1649 * _e2301.z));
                                        let _e2309 = (_e2301.y - (_e1652 * _e2301.z));
                                        let _e2311 = triangles.member[(0u + _e2252)].v2_;
                                        let _e2313 = (_e2311.x - _e118);
                                        let _e2315 = (_e2311.y - _e120);
                                        let _e2317 = (_e2311.z - _e122);
                                        if (_e1638 == 0u) {
                                            phi_2669_ = vec3<f32>(_e2315, _e2317, _e2313);
                                        } else {
                                            if (_e1638 == 1u) {
                                                phi_2668_ = vec3<f32>(_e2317, _e2313, _e2315);
                                            } else {
                                                phi_2668_ = (_e2311 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e2325 = phi_2668_;
                                            phi_2669_ = _e2325;
                                        }
                                        let _e2327 = phi_2669_;
                                        let _e2331 = (_e2327.x - (_e1649 * _e2327.z));
                                        let _e2335 = (_e2327.y - (_e1652 * _e2327.z));
                                        if (_e2305 < _e2331) {
                                            phi_2688_ = true;
                                        } else {
                                            if (_e2305 == _e2331) {
                                                phi_2687_ = (_e2309 < _e2335);
                                            } else {
                                                phi_2687_ = false;
                                            }
                                            let _e2340 = phi_2687_;
                                            phi_2688_ = _e2340;
                                        }
                                        let _e2342 = phi_2688_;
                                        if _e2342 {
                                            phi_2692_ = _e2335;
                                            phi_2693_ = _e2331;
                                            phi_2694_ = _e2309;
                                            phi_2695_ = _e2305;
                                        } else {
                                            phi_2692_ = _e2309;
                                            phi_2693_ = _e2305;
                                            phi_2694_ = _e2335;
                                            phi_2695_ = _e2331;
                                        }
                                        let _e2344 = phi_2692_;
                                        let _e2346 = phi_2693_;
                                        let _e2348 = phi_2694_;
                                        let _e2350 = phi_2695_;
                                        let _e2353 = ((_e2350 * _e2344) - (_e2348 * _e2346));
                                        if _e2342 {
                                            phi_2703_ = -(_e2353);
                                        } else {
                                            phi_2703_ = _e2353;
                                        }
                                        let _e2356 = phi_2703_;
                                        if (_e2331 < _e2279) {
                                            phi_2714_ = true;
                                        } else {
                                            if (_e2331 == _e2279) {
                                                phi_2713_ = (_e2335 < _e2283);
                                            } else {
                                                phi_2713_ = false;
                                            }
                                            let _e2361 = phi_2713_;
                                            phi_2714_ = _e2361;
                                        }
                                        let _e2363 = phi_2714_;
                                        if _e2363 {
                                            phi_2718_ = _e2283;
                                            phi_2719_ = _e2279;
                                            phi_2720_ = _e2335;
                                            phi_2721_ = _e2331;
                                        } else {
                                            phi_2718_ = _e2335;
                                            phi_2719_ = _e2331;
                                            phi_2720_ = _e2283;
                                            phi_2721_ = _e2279;
                                        }
                                        let _e2365 = phi_2718_;
                                        let _e2367 = phi_2719_;
                                        let _e2369 = phi_2720_;
                                        let _e2371 = phi_2721_;
                                        let _e2374 = ((_e2371 * _e2365) - (_e2369 * _e2367));
                                        if _e2363 {
                                            phi_2729_ = -(_e2374);
                                        } else {
                                            phi_2729_ = _e2374;
                                        }
                                        let _e2377 = phi_2729_;
                                        if (_e2279 < _e2305) {
                                            phi_2740_ = true;
                                        } else {
                                            if (_e2279 == _e2305) {
                                                phi_2739_ = (_e2283 < _e2309);
                                            } else {
                                                phi_2739_ = false;
                                            }
                                            let _e2382 = phi_2739_;
                                            phi_2740_ = _e2382;
                                        }
                                        let _e2384 = phi_2740_;
                                        if _e2384 {
                                            phi_2744_ = _e2309;
                                            phi_2745_ = _e2305;
                                            phi_2746_ = _e2283;
                                            phi_2747_ = _e2279;
                                        } else {
                                            phi_2744_ = _e2283;
                                            phi_2745_ = _e2279;
                                            phi_2746_ = _e2309;
                                            phi_2747_ = _e2305;
                                        }
                                        let _e2386 = phi_2744_;
                                        let _e2388 = phi_2745_;
                                        let _e2390 = phi_2746_;
                                        let _e2392 = phi_2747_;
                                        let _e2395 = ((_e2392 * _e2386) - (_e2390 * _e2388));
                                        if _e2384 {
                                            phi_2755_ = -(_e2395);
                                        } else {
                                            phi_2755_ = _e2395;
                                        }
                                        let _e2398 = phi_2755_;
                                        if (_e2356 >= 0f) {
                                            if (_e2377 >= 0f) {
                                                if (_e2398 >= 0f) {
                                                    phi_2770_ = ((_e2356 + _e2377) + _e2398);
                                                    phi_2771_ = false;
                                                } else {
                                                    phi_2770_ = f32();
                                                    phi_2771_ = true;
                                                }
                                                let _e2405 = phi_2770_;
                                                let _e2407 = phi_2771_;
                                                phi_2772_ = _e2405;
                                                phi_2773_ = _e2407;
                                            } else {
                                                phi_2772_ = f32();
                                                phi_2773_ = true;
                                            }
                                            let _e2409 = phi_2772_;
                                            let _e2411 = phi_2773_;
                                            phi_2774_ = _e2409;
                                            phi_2775_ = _e2411;
                                        } else {
                                            phi_2774_ = f32();
                                            phi_2775_ = true;
                                        }
                                        let _e2413 = phi_2774_;
                                        let _e2415 = phi_2775_;
                                        if _e2415 {
                                            if (_e2356 <= 0f) {
                                                if (_e2377 <= 0f) {
                                                    let _e2418 = (_e2398 <= 0f);
                                                    if _e2418 {
                                                    }
                                                    phi_2793_ = ((_e2356 + _e2377) + _e2398);
                                                    phi_2794_ = false;
                                                    phi_2795_ = _e2418;
                                                } else {
                                                    phi_2793_ = f32();
                                                    phi_2794_ = true;
                                                    phi_2795_ = false;
                                                }
                                                let _e2422 = phi_2793_;
                                                let _e2424 = phi_2794_;
                                                let _e2426 = phi_2795_;
                                                phi_2796_ = _e2422;
                                                phi_2797_ = _e2424;
                                                phi_2798_ = _e2426;
                                            } else {
                                                phi_2796_ = f32();
                                                phi_2797_ = true;
                                                phi_2798_ = false;
                                            }
                                            let _e2428 = phi_2796_;
                                            let _e2430 = phi_2797_;
                                            let _e2432 = phi_2798_;
                                            if _e2430 {
                                                phi_2802_ = false;
                                            } else {
                                                phi_2802_ = _e2432;
                                            }
                                            let _e2434 = phi_2802_;
                                            phi_2803_ = _e2428;
                                            phi_2804_ = _e2434;
                                        } else {
                                            phi_2803_ = _e2413;
                                            phi_2804_ = true;
                                        }
                                        let _e2436 = phi_2803_;
                                        let _e2438 = phi_2804_;
                                        if _e2438 {
                                            let _e2439 = (_e2436 == 0f);
                                            if _e2439 {
                                                phi_3120_ = lt_bvh_triangle_Intersection();
                                                phi_3121_ = false;
                                            } else {
                                                let _e2441 = triangles.member[(0u + _e2252)].v0_;
                                                let _e2443 = (_e2441.x - _e118);
                                                let _e2445 = (_e2441.y - _e120);
                                                let _e2447 = (_e2441.z - _e122);
                                                if (_e1638 == 0u) {
                                                    phi_2833_ = vec3<f32>(_e2445, _e2447, _e2443);
                                                } else {
                                                    if (_e1638 == 1u) {
                                                        phi_2832_ = vec3<f32>(_e2447, _e2443, _e2445);
                                                    } else {
                                                        phi_2832_ = (_e2441 - vec3<f32>(_e118, _e120, _e122));
                                                    }
                                                    let _e2455 = phi_2832_;
                                                    phi_2833_ = _e2455;
                                                }
                                                let _e2457 = phi_2833_;
                                                let _e2459 = triangles.member[(0u + _e2252)].v1_;
                                                let _e2461 = triangles.member[(0u + _e2252)].v0_;
                                                let _e2464 = (_e2459.x - _e2461.x);
                                                let _e2467 = (_e2459.y - _e2461.y);
                                                let _e2470 = (_e2459.z - _e2461.z);
                                                if (_e1638 == 0u) {
                                                    phi_2859_ = vec3<f32>(_e2467, _e2470, _e2464);
                                                } else {
                                                    if (_e1638 == 1u) {
                                                        phi_2858_ = vec3<f32>(_e2470, _e2464, _e2467);
                                                    } else {
                                                        phi_2858_ = (_e2459 - _e2461);
                                                    }
                                                    let _e2477 = phi_2858_;
                                                    phi_2859_ = _e2477;
                                                }
                                                let _e2479 = phi_2859_;
                                                let _e2481 = triangles.member[(0u + _e2252)].v2_;
                                                let _e2483 = triangles.member[(0u + _e2252)].v0_;
                                                let _e2486 = (_e2481.x - _e2483.x);
                                                let _e2489 = (_e2481.y - _e2483.y);
                                                let _e2492 = (_e2481.z - _e2483.z);
                                                if (_e1638 == 0u) {
                                                    phi_2885_ = vec3<f32>(_e2489, _e2492, _e2486);
                                                } else {
                                                    if (_e1638 == 1u) {
                                                        phi_2884_ = vec3<f32>(_e2492, _e2486, _e2489);
                                                    } else {
                                                        phi_2884_ = (_e2481 - _e2483);
                                                    }
                                                    let _e2499 = phi_2884_;
                                                    phi_2885_ = _e2499;
                                                }
                                                let _e2501 = phi_2885_;
                                                let _e2508 = ((_e2479.y * _e2501.z) - (_e2479.z * _e2501.y));
                                                let _e2515 = ((_e2479.z * _e2501.x) - (_e2479.x * _e2501.z));
                                                let _e2522 = ((_e2479.x * _e2501.y) - (_e2479.y * _e2501.x));
                                                let _e2536 = (((1f / _e1646.z) * (((_e2508 * _e2457.x) + (_e2515 * _e2457.y)) + (_e2522 * _e2457.z))) / (((_e2508 * _e1649) + (_e2515 * _e1652)) + _e2522));
                                                if (_e2536 > 0f) {
                                                    if (_e2536 < _e130) {
                                                        let _e2540 = triangles.member[(0u + _e2252)].v0_;
                                                        let _e2542 = triangles.member[(0u + _e2252)].v1_;
                                                        if (_e2540.x < _e2542.x) {
                                                            phi_2941_ = _e2540.x;
                                                        } else {
                                                            phi_2941_ = _e2542.x;
                                                        }
                                                        let _e2549 = phi_2941_;
                                                        if (_e2540.y < _e2542.y) {
                                                            phi_2950_ = _e2540.y;
                                                        } else {
                                                            phi_2950_ = _e2542.y;
                                                        }
                                                        let _e2556 = phi_2950_;
                                                        if (_e2540.z < _e2542.z) {
                                                            phi_2959_ = _e2540.z;
                                                        } else {
                                                            phi_2959_ = _e2542.z;
                                                        }
                                                        let _e2563 = phi_2959_;
                                                        let _e2565 = triangles.member[(0u + _e2252)].v2_;
                                                        if (_e2549 < _e2565.x) {
                                                            phi_2968_ = _e2549;
                                                        } else {
                                                            phi_2968_ = _e2565.x;
                                                        }
                                                        let _e2570 = phi_2968_;
                                                        if (_e2556 < _e2565.y) {
                                                            phi_2975_ = _e2556;
                                                        } else {
                                                            phi_2975_ = _e2565.y;
                                                        }
                                                        let _e2575 = phi_2975_;
                                                        if (_e2563 < _e2565.z) {
                                                            phi_2982_ = _e2563;
                                                        } else {
                                                            phi_2982_ = _e2565.z;
                                                        }
                                                        let _e2580 = phi_2982_;
                                                        let _e2582 = triangles.member[(0u + _e2252)].v0_;
                                                        let _e2584 = triangles.member[(0u + _e2252)].v1_;
                                                        if (_e2582.x > _e2584.x) {
                                                            phi_2995_ = _e2582.x;
                                                        } else {
                                                            phi_2995_ = _e2584.x;
                                                        }
                                                        let _e2591 = phi_2995_;
                                                        if (_e2582.y > _e2584.y) {
                                                            phi_3004_ = _e2582.y;
                                                        } else {
                                                            phi_3004_ = _e2584.y;
                                                        }
                                                        let _e2598 = phi_3004_;
                                                        if (_e2582.z > _e2584.z) {
                                                            phi_3013_ = _e2582.z;
                                                        } else {
                                                            phi_3013_ = _e2584.z;
                                                        }
                                                        let _e2605 = phi_3013_;
                                                        let _e2607 = triangles.member[(0u + _e2252)].v2_;
                                                        if (_e2591 > _e2607.x) {
                                                            phi_3022_ = _e2591;
                                                        } else {
                                                            phi_3022_ = _e2607.x;
                                                        }
                                                        let _e2612 = phi_3022_;
                                                        if (_e2598 > _e2607.y) {
                                                            phi_3029_ = _e2598;
                                                        } else {
                                                            phi_3029_ = _e2607.y;
                                                        }
                                                        let _e2617 = phi_3029_;
                                                        if (_e2605 > _e2607.z) {
                                                            phi_3036_ = _e2605;
                                                        } else {
                                                            phi_3036_ = _e2607.z;
                                                        }
                                                        let _e2622 = phi_3036_;
                                                        let _e2626 = ((_e2570 - _e118) * _e1563);
                                                        let _e2627 = ((_e2575 - _e120) * _e1573);
                                                        let _e2628 = ((_e2580 - _e122) * _e1583);
                                                        let _e2632 = ((_e2612 - _e118) * _e1563);
                                                        let _e2633 = ((_e2617 - _e120) * _e1573);
                                                        let _e2634 = ((_e2622 - _e122) * _e1583);
                                                        if (_e2626 < _e2632) {
                                                            phi_3053_ = _e2626;
                                                        } else {
                                                            phi_3053_ = _e2632;
                                                        }
                                                        let _e2637 = phi_3053_;
                                                        if (_e2627 < _e2633) {
                                                            phi_3058_ = _e2627;
                                                        } else {
                                                            phi_3058_ = _e2633;
                                                        }
                                                        let _e2640 = phi_3058_;
                                                        if (_e2628 < _e2634) {
                                                            phi_3063_ = _e2628;
                                                        } else {
                                                            phi_3063_ = _e2634;
                                                        }
                                                        let _e2643 = phi_3063_;
                                                        if (_e2626 > _e2632) {
                                                            phi_3071_ = _e2626;
                                                        } else {
                                                            phi_3071_ = _e2632;
                                                        }
                                                        let _e2649 = phi_3071_;
                                                        if (_e2627 > _e2633) {
                                                            phi_3076_ = _e2627;
                                                        } else {
                                                            phi_3076_ = _e2633;
                                                        }
                                                        let _e2652 = phi_3076_;
                                                        if (_e2628 > _e2634) {
                                                            phi_3081_ = _e2628;
                                                        } else {
                                                            phi_3081_ = _e2634;
                                                        }
                                                        let _e2655 = phi_3081_;
                                                        let _e2659 = core_intrinsics_maximum_number_nsz_f32_((_e2637 - _e1622), (_e2640 - _e1623));
                                                        let _e2660 = core_intrinsics_maximum_number_nsz_f32_(_e2659, (_e2643 - _e1624));
                                                        let _e2661 = core_intrinsics_minimum_number_nsz_f32_((_e2649 + _e1622), (_e2652 + _e1623));
                                                        let _e2662 = core_intrinsics_minimum_number_nsz_f32_(_e2661, (_e2655 + _e1624));
                                                        if (_e2660 > -300000000000000000000000000000000000000f) {
                                                            phi_3093_ = _e2660;
                                                        } else {
                                                            phi_3093_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2665 = phi_3093_;
                                                        if (_e2662 < 300000000000000000000000000000000000000f) {
                                                            phi_3098_ = _e2662;
                                                        } else {
                                                            phi_3098_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2668 = phi_3098_;
                                                        if (_e2536 < _e2665) {
                                                            phi_3103_ = _e2665;
                                                        } else {
                                                            phi_3103_ = _e2536;
                                                        }
                                                        let _e2671 = phi_3103_;
                                                        if (_e2671 > _e2668) {
                                                            phi_3108_ = _e2668;
                                                        } else {
                                                            phi_3108_ = _e2671;
                                                        }
                                                        let _e2674 = phi_3108_;
                                                        phi_3113_ = lt_bvh_triangle_Intersection(_e2674, (_e2377 / _e2436), (_e2398 / _e2436), (_e2665 <= _e2668));
                                                        phi_3114_ = false;
                                                    } else {
                                                        phi_3113_ = lt_bvh_triangle_Intersection();
                                                        phi_3114_ = true;
                                                    }
                                                    let _e2680 = phi_3113_;
                                                    let _e2682 = phi_3114_;
                                                    phi_3115_ = _e2680;
                                                    phi_3116_ = _e2682;
                                                } else {
                                                    phi_3115_ = lt_bvh_triangle_Intersection();
                                                    phi_3116_ = true;
                                                }
                                                let _e2684 = phi_3115_;
                                                let _e2686 = phi_3116_;
                                                if _e2686 {
                                                }
                                                phi_3120_ = _e2684;
                                                phi_3121_ = _e2686;
                                            }
                                            let _e2688 = phi_3120_;
                                            let _e2690 = phi_3121_;
                                            phi_3122_ = _e2688;
                                            phi_3123_ = _e2439;
                                            phi_3124_ = _e2690;
                                        } else {
                                            phi_3122_ = lt_bvh_triangle_Intersection();
                                            phi_3123_ = true;
                                            phi_3124_ = false;
                                        }
                                        let _e2692 = phi_3122_;
                                        let _e2694 = phi_3123_;
                                        let _e2696 = phi_3124_;
                                        if _e2694 {
                                            phi_3128_ = true;
                                        } else {
                                            phi_3128_ = _e2696;
                                        }
                                        let _e2698 = phi_3128_;
                                        if _e2698 {
                                            phi_3132_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3132_ = _e2692;
                                        }
                                        let _e2700 = phi_3132_;
                                        if _e2700.is_hit {
                                            if (_e2700.t > 0f) {
                                                if (_e2700.t < _e130) {
                                                    if true {
                                                        phi_3152_ = false;
                                                    } else {
                                                        phi_3152_ = true;
                                                    }
                                                    let _e2709 = phi_3152_;
                                                    phi_3153_ = true;
                                                    phi_3154_ = _e2709;
                                                } else {
                                                    phi_3153_ = _e2243;
                                                    phi_3154_ = true;
                                                }
                                                let _e2711 = phi_3153_;
                                                let _e2713 = phi_3154_;
                                                phi_3155_ = _e2711;
                                                phi_3156_ = _e2713;
                                            } else {
                                                phi_3155_ = _e2243;
                                                phi_3156_ = true;
                                            }
                                            let _e2715 = phi_3155_;
                                            let _e2717 = phi_3156_;
                                            phi_3157_ = _e2715;
                                            phi_3158_ = _e2717;
                                        } else {
                                            phi_3157_ = _e2243;
                                            phi_3158_ = true;
                                        }
                                        let _e2719 = phi_3157_;
                                        let _e2721 = phi_3158_;
                                        if _e2721 {
                                        }
                                        phi_2562_ = (_e2241 & (_e2241 - 1u));
                                        phi_2565_ = _e2719;
                                        phi_3162_ = _e2721;
                                    }
                                    let _e2723 = phi_2562_;
                                    let _e2725 = phi_2565_;
                                    let _e2727 = phi_3162_;
                                    continue;
                                    continuing {
                                        phi_2561_ = _e2723;
                                        phi_2564_ = _e2725;
                                        break if !(_e2727);
                                    }
                                }
                                let _e2730 = local_7;
                                if _e2730 {
                                    let _e2732 = local.group_mask;
                                    if ((_e2732 & 4278190080u) == 0u) {
                                        let _e2736 = local.len;
                                        if (_e2736 == 0u) {
                                            phi_3204_ = false;
                                        } else {
                                            let _e2740 = local.len;
                                            local.len = (_e2740 - 1u);
                                            let _e2743 = local.len;
                                            if (_e2743 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2748 = local.first[(0u + _e2743)];
                                            local.group = _e2748;
                                            let _e2751 = local.len;
                                            if (_e2751 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2756 = local.mask[(0u + _e2751)];
                                            local.group_mask = _e2756;
                                            phi_3204_ = true;
                                        }
                                        let _e2759 = phi_3204_;
                                        phi_3205_ = _e2759;
                                    } else {
                                        phi_3205_ = true;
                                    }
                                    let _e2761 = phi_3205_;
                                    if _e2761 {
                                        let _e2763 = local.group_mask;
                                        let _e2769 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2763)), 32u, (_e2763 == 0u)));
                                        let _e2773 = local.group_mask;
                                        let _e2787 = local.group_mask;
                                        local.group_mask = (_e2787 & ~((1u << bitcast<u32>((_e2769 & 31u)))));
                                        let _e2790 = local.group;
                                        phi_3236_ = (_e2790 + countOneBits(((_e2773 & ~((4294967295u << bitcast<u32>((((_e2769 - 24u) ^ _e1665) & 31u))))) & 255u)));
                                    } else {
                                        phi_3236_ = 4294967295u;
                                    }
                                    let _e2793 = phi_3236_;
                                    phi_3237_ = _e2793;
                                } else {
                                    phi_3237_ = u32();
                                }
                                let _e2795 = phi_3237_;
                                phi_2230_ = _e2795;
                                let _e3229 = local_14;
                                phi_2233_ = _e3229;
                                let _e3232 = local_15;
                                phi_3238_ = _e3232;
                                phi_3239_ = false;
                            } else {
                                phi_2230_ = u32();
                                phi_2233_ = bool();
                                phi_3238_ = false;
                                phi_3239_ = true;
                            }
                            let _e2797 = phi_2230_;
                            let _e2799 = phi_2233_;
                            let _e2801 = phi_3238_;
                            let _e2803 = phi_3239_;
                            local_8 = _e2803;
                            continue;
                            continuing {
                                phi_2229_ = _e2797;
                                phi_2232_ = _e2799;
                                break if !(_e2801);
                            }
                        }
                        let _e2806 = local_8;
                        if _e2806 {
                            phi_3243_ = false;
                        } else {
                            phi_3243_ = true;
                        }
                        let _e2808 = phi_3243_;
                        if _e2808 {
                            phi_3247_ = true;
                        } else {
                            let _e3238 = local_16;
                            phi_3247_ = _e3238;
                        }
                        let _e2810 = phi_3247_;
                        phi_3248_ = _e2810;
                    }
                    let _e2812 = phi_3248_;
                    phi_3249_ = _e2812;
                    phi_3250_ = _e1487;
                } else {
                    phi_3249_ = bool();
                    phi_3250_ = true;
                }
                let _e2814 = phi_3249_;
                let _e2816 = phi_3250_;
                if _e2816 {
                    phi_3254_ = false;
                } else {
                    phi_3254_ = _e2814;
                }
                let _e2818 = phi_3254_;
                phi_3255_ = _e2818;
            }
            let _e2820 = phi_3255_;
            phi_3256_ = _e2820;
        } else {
            phi_3256_ = false;
        }
        let _e2822 = phi_3256_;
        if _e2822 {
            phi_3260_ = 0f;
        } else {
            phi_3260_ = 1f;
        }
        let _e2824 = phi_3260_;
        if (_e97 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e97)] = _e2824;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
