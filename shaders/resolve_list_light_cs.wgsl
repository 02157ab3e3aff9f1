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
    var phi_778_: u32;
    var phi_781_: u32;
    var phi_783_: u32;
    var phi_785_: u32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_873_: u32;
    var phi_896_: f32;
    var phi_897_: f32;
    var phi_911_: u32;
    var phi_934_: f32;
    var phi_935_: f32;
    var phi_949_: u32;
    var phi_1096_: u32;
    var phi_1097_: u32;
    var phi_1101_: u32;
    var phi_1102_: u32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1105_: u32;
    var phi_1106_: u32;
    var phi_1124_: u32;
    var phi_1125_: u32;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1128_: u32;
    var phi_1129_: u32;
    var phi_1130_: u32;
    var phi_1131_: u32;
    var phi_779_: u32;
    var phi_782_: u32;
    var phi_784_: u32;
    var phi_786_: u32;
    var phi_1132_: bool;
    var local_2: bool;
    var phi_1137_: u32;
    var local_3: u32;
    var phi_1176_: u32;
    var phi_1177_: u32;
    var phi_1183_: u32;
    var phi_1212_: vec3<f32>;
    var phi_1213_: vec3<f32>;
    var phi_1242_: vec3<f32>;
    var phi_1243_: vec3<f32>;
    var phi_1272_: vec3<f32>;
    var phi_1273_: vec3<f32>;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1296_: f32;
    var phi_1297_: f32;
    var phi_1298_: f32;
    var phi_1299_: f32;
    var phi_1307_: f32;
    var phi_1317_: bool;
    var phi_1318_: bool;
    var phi_1322_: f32;
    var phi_1323_: f32;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_1333_: f32;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1348_: f32;
    var phi_1349_: f32;
    var phi_1350_: f32;
    var phi_1351_: f32;
    var phi_1359_: f32;
    var phi_1374_: f32;
    var phi_1375_: bool;
    var phi_1376_: f32;
    var phi_1377_: bool;
    var phi_1378_: f32;
    var phi_1379_: bool;
    var phi_1397_: f32;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: f32;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1406_: bool;
    var phi_1407_: f32;
    var phi_1408_: bool;
    var phi_1436_: vec3<f32>;
    var phi_1437_: vec3<f32>;
    var phi_1462_: vec3<f32>;
    var phi_1463_: vec3<f32>;
    var phi_1488_: vec3<f32>;
    var phi_1489_: vec3<f32>;
    var phi_1545_: f32;
    var phi_1554_: f32;
    var phi_1563_: f32;
    var phi_1572_: f32;
    var phi_1579_: f32;
    var phi_1586_: f32;
    var phi_1599_: f32;
    var phi_1608_: f32;
    var phi_1617_: f32;
    var phi_1626_: f32;
    var phi_1633_: f32;
    var phi_1640_: f32;
    var phi_1657_: f32;
    var phi_1662_: f32;
    var phi_1667_: f32;
    var phi_1675_: f32;
    var phi_1680_: f32;
    var phi_1685_: f32;
    var phi_1697_: f32;
    var phi_1702_: f32;
    var phi_1707_: f32;
    var phi_1712_: f32;
    var phi_1717_: lt_bvh_triangle_Intersection;
    var phi_1718_: bool;
    var phi_1719_: lt_bvh_triangle_Intersection;
    var phi_1720_: bool;
    var phi_1724_: lt_bvh_triangle_Intersection;
    var phi_1725_: bool;
    var phi_1726_: lt_bvh_triangle_Intersection;
    var phi_1727_: bool;
    var phi_1728_: bool;
    var phi_1732_: bool;
    var phi_1736_: lt_bvh_triangle_Intersection;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1784_: bool;
    var phi_1785_: bool;
    var phi_1138_: u32;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var local_4: bool;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_767_: u32;
    var phi_770_: u32;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var local_5: bool;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var phi_1805_: bool;
    var phi_1809_: bool;
    var phi_1813_: bool;
    var phi_1814_: bool;
    var phi_1818_: bool;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1837_: bool;
    var phi_1841_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1857_: bool;
    var phi_1861_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1880_: bool;
    var phi_1881_: bool;
    var phi_1882_: bool;
    var phi_1883_: bool;
    var phi_1884_: bool;
    var phi_1888_: bool;
    var phi_1958_: f32;
    var phi_1965_: f32;
    var phi_1972_: f32;
    var phi_1979_: f32;
    var phi_1986_: f32;
    var phi_1993_: f32;
    var phi_2010_: f32;
    var phi_2015_: f32;
    var phi_2020_: f32;
    var phi_2025_: f32;
    var phi_2030_: f32;
    var phi_2056_: bool;
    var phi_2057_: bool;
    var phi_2065_: u32;
    var phi_2066_: u32;
    var phi_2077_: vec3<f32>;
    var phi_2078_: vec3<f32>;
    var phi_2091_: u32;
    var phi_2096_: u32;
    var phi_2101_: u32;
    var phi_2215_: bool;
    var phi_2216_: bool;
    var phi_2247_: u32;
    var phi_2249_: u32;
    var phi_2252_: bool;
    var phi_2332_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2359_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2386_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2392_: u32;
    var phi_2395_: u32;
    var phi_2409_: u32;
    var phi_2419_: u32;
    var phi_2429_: u32;
    var phi_2447_: u32;
    var phi_2457_: u32;
    var phi_2467_: u32;
    var phi_2503_: u32;
    var phi_2516_: u32;
    var phi_2521_: u32;
    var phi_2522_: u32;
    var phi_2523_: u32;
    var phi_2393_: u32;
    var phi_2396_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2581_: u32;
    var phi_2584_: bool;
    var phi_2628_: vec3<f32>;
    var phi_2629_: vec3<f32>;
    var phi_2658_: vec3<f32>;
    var phi_2659_: vec3<f32>;
    var phi_2688_: vec3<f32>;
    var phi_2689_: vec3<f32>;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2712_: f32;
    var phi_2713_: f32;
    var phi_2714_: f32;
    var phi_2715_: f32;
    var phi_2723_: f32;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var phi_2738_: f32;
    var phi_2739_: f32;
    var phi_2740_: f32;
    var phi_2741_: f32;
    var phi_2749_: f32;
    var phi_2759_: bool;
    var phi_2760_: bool;
    var phi_2764_: f32;
    var phi_2765_: f32;
    var phi_2766_: f32;
    var phi_2767_: f32;
    var phi_2775_: f32;
    var phi_2790_: f32;
    var phi_2791_: bool;
    var phi_2792_: f32;
    var phi_2793_: bool;
    var phi_2794_: f32;
    var phi_2795_: bool;
    var phi_2813_: f32;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2816_: f32;
    var phi_2817_: bool;
    var phi_2818_: bool;
    var phi_2822_: bool;
    var phi_2823_: f32;
    var phi_2824_: bool;
    var phi_2852_: vec3<f32>;
    var phi_2853_: vec3<f32>;
    var phi_2878_: vec3<f32>;
    var phi_2879_: vec3<f32>;
    var phi_2904_: vec3<f32>;
    var phi_2905_: vec3<f32>;
    var phi_2961_: f32;
    var phi_2970_: f32;
    var phi_2979_: f32;
    var phi_2988_: f32;
    var phi_2995_: f32;
    var phi_3002_: f32;
    var phi_3015_: f32;
    var phi_3024_: f32;
    var phi_3033_: f32;
    var phi_3042_: f32;
    var phi_3049_: f32;
    var phi_3056_: f32;
    var phi_3073_: f32;
    var phi_3078_: f32;
    var phi_3083_: f32;
    var phi_3091_: f32;
    var phi_3096_: f32;
    var phi_3101_: f32;
    var phi_3113_: f32;
    var phi_3118_: f32;
    var phi_3123_: f32;
    var phi_3128_: f32;
    var phi_3133_: lt_bvh_triangle_Intersection;
    var phi_3134_: bool;
    var phi_3135_: lt_bvh_triangle_Intersection;
    var phi_3136_: bool;
    var phi_3140_: lt_bvh_triangle_Intersection;
    var phi_3141_: bool;
    var phi_3142_: lt_bvh_triangle_Intersection;
    var phi_3143_: bool;
    var phi_3144_: bool;
    var phi_3148_: bool;
    var phi_3152_: lt_bvh_triangle_Intersection;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_2582_: u32;
    var phi_2585_: bool;
    var phi_3182_: bool;
    var local_9: bool;
    var phi_3224_: bool;
    var phi_3225_: bool;
    var phi_3256_: u32;
    var phi_3257_: u32;
    var phi_2250_: u32;
    var phi_2253_: bool;
    var phi_3258_: bool;
    var phi_3259_: bool;
    var local_10: bool;
    var phi_3263_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3280_: f32;
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
                    phi_1813_ = false;
                    phi_1814_ = true;
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
                        local_5 = _e531;
                        if _e531 {
                            phi_767_ = u32();
                            phi_770_ = u32();
                            phi_1794_ = false;
                            phi_1795_ = false;
                            phi_1796_ = false;
                        } else {
                            phi_778_ = _e528;
                            phi_781_ = 0u;
                            phi_783_ = 0u;
                            phi_785_ = _e530;
                            loop {
                                let _e533 = phi_778_;
                                let _e535 = phi_781_;
                                let _e537 = phi_783_;
                                let _e539 = phi_785_;
                                local_11 = _e537;
                                local_3 = _e535;
                                local_14 = _e533;
                                local_15 = _e539;
                                let _e540 = (_e533 == 0u);
                                local_2 = _e540;
                                if _e540 {
                                    phi_779_ = u32();
                                    phi_782_ = u32();
                                    phi_784_ = u32();
                                    phi_786_ = u32();
                                    phi_1132_ = false;
                                } else {
                                    let _e541 = (_e537 == 0u);
                                    if _e541 {
                                        let _e548 = (((_e533 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e533), 32u, (_e533 == 0u))) * 4u);
                                        if (_e548 < _e83) {
                                        } else {
                                            return;
                                        }
                                        let _e552 = rows.member[(0u + _e548)];
                                        let _e553 = (_e548 + 1u);
                                        if (_e553 < _e83) {
                                        } else {
                                            return;
                                        }
                                        let _e557 = rows.member[(0u + _e553)];
                                        let _e558 = (_e548 + 2u);
                                        if (_e558 < _e83) {
                                        } else {
                                            return;
                                        }
                                        let _e562 = rows.member[(0u + _e558)];
                                        let _e563 = (_e548 + 3u);
                                        if (_e563 < _e83) {
                                        } else {
                                            return;
                                        }
                                        let _e567 = rows.member[(0u + _e563)];
                                        let _e568 = lt_bvh_LightNode(_e552, _e557, _e562, _e567);
                                        let _e570 = (_e533 & (_e533 - 1u));
                                        let _e582 = (_e358.unnamed.positive_exponent - bitcast<f32>(_e568.frame.x));
                                        let _e585 = bitcast<f32>((((_e568.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e582 > 0f) {
                                            if (_e582 < (255f * _e585)) {
                                                phi_858_ = (_e582 / _e585);
                                            } else {
                                                phi_858_ = 255f;
                                            }
                                            let _e591 = phi_858_;
                                            phi_859_ = _e591;
                                        } else {
                                            phi_859_ = 0f;
                                        }
                                        let _e593 = phi_859_;
                                        let _e600 = select(select(u32(_e593), 0u, (_e593 < bitcast<f32>(0u))), 4294967295u, (_e593 > bitcast<f32>(1333788671u)));
                                        if (f32(_e600) < _e593) {
                                            phi_873_ = (_e600 + 1u);
                                        } else {
                                            phi_873_ = _e600;
                                        }
                                        let _e605 = phi_873_;
                                        let _e606 = (_e600 * 16843009u);
                                        let _e607 = (_e605 * 16843009u);
                                        let _e617 = (_e358.unnamed.negative_exponent - bitcast<f32>(_e568.frame.y));
                                        let _e620 = bitcast<f32>((((_e568.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e617 > 0f) {
                                            if (_e617 < (255f * _e620)) {
                                                phi_896_ = (_e617 / _e620);
                                            } else {
                                                phi_896_ = 255f;
                                            }
                                            let _e626 = phi_896_;
                                            phi_897_ = _e626;
                                        } else {
                                            phi_897_ = 0f;
                                        }
                                        let _e628 = phi_897_;
                                        let _e635 = select(select(u32(_e628), 0u, (_e628 < bitcast<f32>(0u))), 4294967295u, (_e628 > bitcast<f32>(1333788671u)));
                                        if (f32(_e635) < _e628) {
                                            phi_911_ = (_e635 + 1u);
                                        } else {
                                            phi_911_ = _e635;
                                        }
                                        let _e640 = phi_911_;
                                        let _e641 = (_e635 * 16843009u);
                                        let _e642 = (_e640 * 16843009u);
                                        let _e652 = (_e358.unnamed.min_variance - bitcast<f32>(_e568.frame.z));
                                        let _e655 = bitcast<f32>((((_e568.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e652 > 0f) {
                                            if (_e652 < (255f * _e655)) {
                                                phi_934_ = (_e652 / _e655);
                                            } else {
                                                phi_934_ = 255f;
                                            }
                                            let _e661 = phi_934_;
                                            phi_935_ = _e661;
                                        } else {
                                            phi_935_ = 0f;
                                        }
                                        let _e663 = phi_935_;
                                        let _e670 = select(select(u32(_e663), 0u, (_e663 < bitcast<f32>(0u))), 4294967295u, (_e663 > bitcast<f32>(1333788671u)));
                                        if (f32(_e670) < _e663) {
                                            phi_949_ = (_e670 + 1u);
                                        } else {
                                            phi_949_ = _e670;
                                        }
                                        let _e675 = phi_949_;
                                        let _e676 = (_e675 * 16843009u);
                                        let _e809 = (((((((((((_e606 & ~(_e568.x.x)) | (~((_e568.x.x ^ _e606)) & ((_e606 | 2155905152u) - (_e568.x.x & 2139062143u)))) & ((_e568.x.z & ~(_e607)) | (~((_e607 ^ _e568.x.z)) & ((_e568.x.z | 2155905152u) - (_e607 & 2139062143u))))) & ((_e641 & ~(_e568.y.x)) | (~((_e568.y.x ^ _e641)) & ((_e641 | 2155905152u) - (_e568.y.x & 2139062143u))))) & ((_e568.y.z & ~(_e642)) | (~((_e642 ^ _e568.y.z)) & ((_e568.y.z | 2155905152u) - (_e642 & 2139062143u))))) & ((_e568.rest.x & ~(_e676)) | (~((_e676 ^ _e568.rest.x)) & ((_e568.rest.x | 2155905152u) - (_e676 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e606 & ~(_e568.x.y)) | (~((_e568.x.y ^ _e606)) & ((_e606 | 2155905152u) - (_e568.x.y & 2139062143u)))) & ((_e568.x.w & ~(_e607)) | (~((_e607 ^ _e568.x.w)) & ((_e568.x.w | 2155905152u) - (_e607 & 2139062143u))))) & ((_e641 & ~(_e568.y.y)) | (~((_e568.y.y ^ _e641)) & ((_e641 | 2155905152u) - (_e568.y.y & 2139062143u))))) & ((_e568.y.w & ~(_e642)) | (~((_e642 ^ _e568.y.w)) & ((_e568.y.w | 2155905152u) - (_e642 & 2139062143u))))) & ((_e568.rest.y & ~(_e676)) | (~((_e676 ^ _e568.rest.y)) & ((_e568.rest.y | 2155905152u) - (_e676 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                        if ((_e568.frame.w & 16777216u) != 0u) {
                                            phi_1103_ = _e570;
                                            phi_1104_ = _e568.rest.z;
                                            phi_1105_ = _e809;
                                            phi_1106_ = _e539;
                                        } else {
                                            if (_e809 == 0u) {
                                                phi_1101_ = _e570;
                                                phi_1102_ = _e539;
                                            } else {
                                                if ((_e570 & 255u) == 0u) {
                                                    phi_1097_ = _e539;
                                                } else {
                                                    if (_e539 < 32u) {
                                                        if (_e539 < 32u) {
                                                        } else {
                                                            return;
                                                        }
                                                        local_1[(0u + _e539)] = _e570;
                                                        phi_1096_ = (_e539 + 1u);
                                                    } else {
                                                        phi_1096_ = _e539;
                                                    }
                                                    let _e825 = phi_1096_;
                                                    phi_1097_ = _e825;
                                                }
                                                let _e827 = phi_1097_;
                                                phi_1101_ = ((_e568.rest.z << bitcast<u32>(8i)) | _e809);
                                                phi_1102_ = _e827;
                                            }
                                            let _e834 = phi_1101_;
                                            let _e836 = phi_1102_;
                                            phi_1103_ = _e834;
                                            phi_1104_ = _e535;
                                            phi_1105_ = _e537;
                                            phi_1106_ = _e836;
                                        }
                                        let _e838 = phi_1103_;
                                        let _e840 = phi_1104_;
                                        let _e842 = phi_1105_;
                                        let _e844 = phi_1106_;
                                        if ((_e838 & 255u) == 0u) {
                                            if (_e844 > 0u) {
                                                let _e848 = (_e844 - 1u);
                                                if (_e848 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e852 = local_1[(0u + _e848)];
                                                phi_1124_ = _e852;
                                                phi_1125_ = _e848;
                                            } else {
                                                phi_1124_ = 0u;
                                                phi_1125_ = _e844;
                                            }
                                            let _e854 = phi_1124_;
                                            let _e856 = phi_1125_;
                                            phi_1126_ = _e854;
                                            phi_1127_ = _e856;
                                        } else {
                                            phi_1126_ = _e838;
                                            phi_1127_ = _e844;
                                        }
                                        let _e858 = phi_1126_;
                                        let _e860 = phi_1127_;
                                        phi_1128_ = _e858;
                                        phi_1129_ = _e840;
                                        phi_1130_ = _e842;
                                        phi_1131_ = _e860;
                                    } else {
                                        phi_1128_ = u32();
                                        phi_1129_ = u32();
                                        phi_1130_ = u32();
                                        phi_1131_ = u32();
                                    }
                                    let _e862 = phi_1128_;
                                    let _e864 = phi_1129_;
                                    let _e866 = phi_1130_;
                                    let _e868 = phi_1131_;
                                    phi_779_ = _e862;
                                    phi_782_ = _e864;
                                    phi_784_ = _e866;
                                    phi_786_ = _e868;
                                    phi_1132_ = _e541;
                                }
                                let _e870 = phi_779_;
                                let _e872 = phi_782_;
                                let _e874 = phi_784_;
                                let _e876 = phi_786_;
                                let _e878 = phi_1132_;
                                continue;
                                continuing {
                                    phi_778_ = _e870;
                                    phi_781_ = _e872;
                                    phi_783_ = _e874;
                                    phi_785_ = _e876;
                                    break if !(_e878);
                                }
                            }
                            let _e881 = local_2;
                            if _e881 {
                            }
                            let _e2963 = local_11;
                            phi_1137_ = _e2963;
                            loop {
                                let _e883 = phi_1137_;
                                let _e884 = (_e883 == 0u);
                                local_4 = _e884;
                                local_16 = _e884;
                                if _e884 {
                                    phi_1138_ = u32();
                                    phi_1786_ = false;
                                    phi_1787_ = false;
                                    phi_1788_ = false;
                                } else {
                                    let _e887 = select(firstTrailingBit(_e883), 32u, (_e883 == 0u));
                                    let _e891 = local_3;
                                    let _e892 = (_e891 + (_e887 >> bitcast<u32>(2i)));
                                    if (_e892 < _e83) {
                                    } else {
                                        return;
                                    }
                                    let _e897 = rows.member[(0u + _e892)][0u];
                                    let _e901 = rows.member[(0u + _e892)][1u];
                                    let _e905 = rows.member[(0u + _e892)][2u];
                                    let _e909 = rows.member[(0u + _e892)][3u];
                                    if ((_e887 & 2u) == 0u) {
                                        phi_1176_ = _e901;
                                        phi_1177_ = _e897;
                                    } else {
                                        phi_1176_ = _e909;
                                        phi_1177_ = _e905;
                                    }
                                    let _e913 = phi_1176_;
                                    let _e915 = phi_1177_;
                                    if ((_e887 & 1u) == 0u) {
                                        phi_1183_ = _e915;
                                    } else {
                                        phi_1183_ = _e913;
                                    }
                                    let _e919 = phi_1183_;
                                    if (_e919 < _e74) {
                                    } else {
                                        return;
                                    }
                                    let _e926 = triangles.member[(0u + _e919)].v0_;
                                    let _e928 = (_e926.x - _e118);
                                    let _e930 = (_e926.y - _e120);
                                    let _e932 = (_e926.z - _e122);
                                    if (_e507 == 0u) {
                                        phi_1213_ = vec3<f32>(_e930, _e932, _e928);
                                    } else {
                                        if (_e507 == 1u) {
                                            phi_1212_ = vec3<f32>(_e932, _e928, _e930);
                                        } else {
                                            phi_1212_ = (_e926 - vec3<f32>(_e118, _e120, _e122));
                                        }
                                        let _e940 = phi_1212_;
                                        phi_1213_ = _e940;
                                    }
                                    let _e942 = phi_1213_;
                                    let _e946 = (_e942.x - (_e518 * _e942.z));
                                    let _e950 = (_e942.y - (_e521 * _e942.z));
                                    let _e952 = triangles.member[(0u + _e919)].v1_;
                                    let _e954 = (_e952.x - _e118);
                                    let _e956 = (_e952.y - _e120);
                                    let _e958 = (_e952.z - _e122);
                                    if (_e507 == 0u) {
                                        phi_1243_ = vec3<f32>(_e956, _e958, _e954);
                                    } else {
                                        if (_e507 == 1u) {
                                            phi_1242_ = vec3<f32>(_e958, _e954, _e956);
                                        } else {
                                            phi_1242_ = (_e952 - vec3<f32>(_e118, _e120, _e122));
                                        }
                                        let _e966 = phi_1242_;
                                        phi_1243_ = _e966;
                                    }
                                    let _e968 = phi_1243_;
                                    let _e972 = (_e968.x - (_e518 * _e968.z));
                                    let _e976 = (_e968.y - (_e521 * _e968.z));
                                    let _e978 = triangles.member[(0u + _e919)].v2_;
                                    let _e980 = (_e978.x - _e118);
                                    let _e982 = (_e978.y - _e120);
                                    let _e984 = (_e978.z - _e122);
                                    if (_e507 == 0u) {
                                        phi_1273_ = vec3<f32>(_e982, _e984, _e980);
                                    } else {
                                        if (_e507 == 1u) {
                                            phi_1272_ = vec3<f32>(_e984, _e980, _e982);
                                        } else {
                                            phi_1272_ = (_e978 - vec3<f32>(_e118, _e120, _e122));
                                        }
                                        let _e992 = phi_1272_;
                                        phi_1273_ = _e992;
                                    }
                                    let _e994 = phi_1273_;
                                    let _e998 = (_e994.x - (_e518 * _e994.z));
                                    let _e1002 = (_e994.y - (_e521 * _e994.z));
                                    if (_e972 < _e998) {
                                        phi_1292_ = true;
                                    } else {
                                        if (_e972 == _e998) {
                                            phi_1291_ = (_e976 < _e1002);
                                        } else {
                                            phi_1291_ = false;
                                        }
                                        let _e1007 = phi_1291_;
                                        phi_1292_ = _e1007;
                                    }
                                    let _e1009 = phi_1292_;
                                    if _e1009 {
                                        phi_1296_ = _e1002;
                                        phi_1297_ = _e998;
                                        phi_1298_ = _e976;
                                        phi_1299_ = _e972;
                                    } else {
                                        phi_1296_ = _e976;
                                        phi_1297_ = _e972;
                                        phi_1298_ = _e1002;
                                        phi_1299_ = _e998;
                                    }
                                    let _e1011 = phi_1296_;
                                    let _e1013 = phi_1297_;
                                    let _e1015 = phi_1298_;
                                    let _e1017 = phi_1299_;
                                    let _e1020 = ((_e1017 * _e1011) - (_e1015 * _e1013));
                                    if _e1009 {
                                        phi_1307_ = -(_e1020);
                                    } else {
                                        phi_1307_ = _e1020;
                                    }
                                    let _e1023 = phi_1307_;
                                    if (_e998 < _e946) {
                                        phi_1318_ = true;
                                    } else {
                                        if (_e998 == _e946) {
                                            phi_1317_ = (_e1002 < _e950);
                                        } else {
                                            phi_1317_ = false;
                                        }
                                        let _e1028 = phi_1317_;
                                        phi_1318_ = _e1028;
                                    }
                                    let _e1030 = phi_1318_;
                                    if _e1030 {
                                        phi_1322_ = _e950;
                                        phi_1323_ = _e946;
                                        phi_1324_ = _e1002;
                                        phi_1325_ = _e998;
                                    } else {
                                        phi_1322_ = _e1002;
                                        phi_1323_ = _e998;
                                        phi_1324_ = _e950;
                                        phi_1325_ = _e946;
                                    }
                                    let _e1032 = phi_1322_;
                                    let _e1034 = phi_1323_;
                                    let _e1036 = phi_1324_;
                                    let _e1038 = phi_1325_;
                                    let _e1041 = ((_e1038 * _e1032) - (_e1036 * _e1034));
                                    if _e1030 {
                                        phi_1333_ = -(_e1041);
                                    } else {
                                        phi_1333_ = _e1041;
                                    }
                                    let _e1044 = phi_1333_;
                                    if (_e946 < _e972) {
                                        phi_1344_ = true;
                                    } else {
                                        if (_e946 == _e972) {
                                            phi_1343_ = (_e950 < _e976);
                                        } else {
                                            phi_1343_ = false;
                                        }
                                        let _e1049 = phi_1343_;
                                        phi_1344_ = _e1049;
                                    }
                                    let _e1051 = phi_1344_;
                                    if _e1051 {
                                        phi_1348_ = _e976;
                                        phi_1349_ = _e972;
                                        phi_1350_ = _e950;
                                        phi_1351_ = _e946;
                                    } else {
                                        phi_1348_ = _e950;
                                        phi_1349_ = _e946;
                                        phi_1350_ = _e976;
                                        phi_1351_ = _e972;
                                    }
                                    let _e1053 = phi_1348_;
                                    let _e1055 = phi_1349_;
                                    let _e1057 = phi_1350_;
                                    let _e1059 = phi_1351_;
                                    let _e1062 = ((_e1059 * _e1053) - (_e1057 * _e1055));
                                    if _e1051 {
                                        phi_1359_ = -(_e1062);
                                    } else {
                                        phi_1359_ = _e1062;
                                    }
                                    let _e1065 = phi_1359_;
                                    if (_e1023 >= 0f) {
                                        if (_e1044 >= 0f) {
                                            if (_e1065 >= 0f) {
                                                phi_1374_ = ((_e1023 + _e1044) + _e1065);
                                                phi_1375_ = false;
                                            } else {
                                                phi_1374_ = f32();
                                                phi_1375_ = true;
                                            }
                                            let _e1072 = phi_1374_;
                                            let _e1074 = phi_1375_;
                                            phi_1376_ = _e1072;
                                            phi_1377_ = _e1074;
                                        } else {
                                            phi_1376_ = f32();
                                            phi_1377_ = true;
                                        }
                                        let _e1076 = phi_1376_;
                                        let _e1078 = phi_1377_;
                                        phi_1378_ = _e1076;
                                        phi_1379_ = _e1078;
                                    } else {
                                        phi_1378_ = f32();
                                        phi_1379_ = true;
                                    }
                                    let _e1080 = phi_1378_;
                                    let _e1082 = phi_1379_;
                                    if _e1082 {
                                        if (_e1023 <= 0f) {
                                            if (_e1044 <= 0f) {
                                                let _e1085 = (_e1065 <= 0f);
                                                if _e1085 {
                                                }
                                                phi_1397_ = ((_e1023 + _e1044) + _e1065);
                                                phi_1398_ = false;
                                                phi_1399_ = _e1085;
                                            } else {
                                                phi_1397_ = f32();
                                                phi_1398_ = true;
                                                phi_1399_ = false;
                                            }
                                            let _e1089 = phi_1397_;
                                            let _e1091 = phi_1398_;
                                            let _e1093 = phi_1399_;
                                            phi_1400_ = _e1089;
                                            phi_1401_ = _e1091;
                                            phi_1402_ = _e1093;
                                        } else {
                                            phi_1400_ = f32();
                                            phi_1401_ = true;
                                            phi_1402_ = false;
                                        }
                                        let _e1095 = phi_1400_;
                                        let _e1097 = phi_1401_;
                                        let _e1099 = phi_1402_;
                                        if _e1097 {
                                            phi_1406_ = false;
                                        } else {
                                            phi_1406_ = _e1099;
                                        }
                                        let _e1101 = phi_1406_;
                                        phi_1407_ = _e1095;
                                        phi_1408_ = _e1101;
                                    } else {
                                        phi_1407_ = _e1080;
                                        phi_1408_ = true;
                                    }
                                    let _e1103 = phi_1407_;
                                    let _e1105 = phi_1408_;
                                    if _e1105 {
                                        let _e1106 = (_e1103 == 0f);
                                        if _e1106 {
                                            phi_1724_ = lt_bvh_triangle_Intersection();
                                            phi_1725_ = false;
                                        } else {
                                            let _e1108 = triangles.member[(0u + _e919)].v0_;
                                            let _e1110 = (_e1108.x - _e118);
                                            let _e1112 = (_e1108.y - _e120);
                                            let _e1114 = (_e1108.z - _e122);
                                            if (_e507 == 0u) {
                                                phi_1437_ = vec3<f32>(_e1112, _e1114, _e1110);
                                            } else {
                                                if (_e507 == 1u) {
                                                    phi_1436_ = vec3<f32>(_e1114, _e1110, _e1112);
                                                } else {
                                                    phi_1436_ = (_e1108 - vec3<f32>(_e118, _e120, _e122));
                                                }
                                                let _e1122 = phi_1436_;
                                                phi_1437_ = _e1122;
                                            }
                                            let _e1124 = phi_1437_;
                                            let _e1126 = triangles.member[(0u + _e919)].v1_;
                                            let _e1128 = triangles.member[(0u + _e919)].v0_;
                                            let _e1131 = (_e1126.x - _e1128.x);
                                            let _e1134 = (_e1126.y - _e1128.y);
                                            let _e1137 = (_e1126.z - _e1128.z);
                                            if (_e507 == 0u) {
                                                phi_1463_ = vec3<f32>(_e1134, _e1137, _e1131);
                                            } else {
                                                if (_e507 == 1u) {
                                                    phi_1462_ = vec3<f32>(_e1137, _e1131, _e1134);
                                                } else {
                                                    phi_1462_ = (_e1126 - _e1128);
                                                }
                                                let _e1144 = phi_1462_;
                                                phi_1463_ = _e1144;
                                            }
                                            let _e1146 = phi_1463_;
                                            let _e1148 = triangles.member[(0u + _e919)].v2_;
                                            let _e1150 = triangles.member[(0u + _e919)].v0_;
                                            let _e1153 = (_e1148.x - _e1150.x);
                                            let _e1156 = (_e1148.y - _e1150.y);
                                            let _e1159 = (_e1148.z - _e1150.z);
                                            if (_e507 == 0u) {
                                                phi_1489_ = vec3<f32>(_e1156, _e1159, _e1153);
                                            } else {
                                                if (_e507 == 1u) {
                                                    phi_1488_ = vec3<f32>(_e1159, _e1153, _e1156);
                                                } else {
                                                    phi_1488_ = (_e1148 - _e1150);
                                                }
                                                let _e1166 = phi_1488_;
                                                phi_1489_ = _e1166;
                                            }
                                            let _e1168 = phi_1489_;
                                            let _e1175 = ((_e1146.y * _e1168.z) - (_e1146.z * _e1168.y));
                                            let _e1182 = ((_e1146.z * _e1168.x) - (_e1146.x * _e1168.z));
                                            let _e1189 = ((_e1146.x * _e1168.y) - (_e1146.y * _e1168.x));
                                            let _e1203 = (((1f / _e515.z) * (((_e1175 * _e1124.x) + (_e1182 * _e1124.y)) + (_e1189 * _e1124.z))) / (((_e1175 * _e518) + (_e1182 * _e521)) + _e1189));
                                            if (_e1203 > 0f) {
                                                if (_e1203 < _e130) {
                                                    let _e1207 = triangles.member[(0u + _e919)].v0_;
                                                    let _e1209 = triangles.member[(0u + _e919)].v1_;
                                                    if (_e1207.x < _e1209.x) {
                                                        phi_1545_ = _e1207.x;
                                                    } else {
                                                        phi_1545_ = _e1209.x;
                                                    }
                                                    let _e1216 = phi_1545_;
                                                    if (_e1207.y < _e1209.y) {
                                                        phi_1554_ = _e1207.y;
                                                    } else {
                                                        phi_1554_ = _e1209.y;
                                                    }
                                                    let _e1223 = phi_1554_;
                                                    if (_e1207.z < _e1209.z) {
                                                        phi_1563_ = _e1207.z;
                                                    } else {
                                                        phi_1563_ = _e1209.z;
                                                    }
                                                    let _e1230 = phi_1563_;
                                                    let _e1232 = triangles.member[(0u + _e919)].v2_;
                                                    if (_e1216 < _e1232.x) {
                                                        phi_1572_ = _e1216;
                                                    } else {
                                                        phi_1572_ = _e1232.x;
                                                    }
                                                    let _e1237 = phi_1572_;
                                                    if (_e1223 < _e1232.y) {
                                                        phi_1579_ = _e1223;
                                                    } else {
                                                        phi_1579_ = _e1232.y;
                                                    }
                                                    let _e1242 = phi_1579_;
                                                    if (_e1230 < _e1232.z) {
                                                        phi_1586_ = _e1230;
                                                    } else {
                                                        phi_1586_ = _e1232.z;
                                                    }
                                                    let _e1247 = phi_1586_;
                                                    let _e1249 = triangles.member[(0u + _e919)].v0_;
                                                    let _e1251 = triangles.member[(0u + _e919)].v1_;
                                                    if (_e1249.x > _e1251.x) {
                                                        phi_1599_ = _e1249.x;
                                                    } else {
                                                        phi_1599_ = _e1251.x;
                                                    }
                                                    let _e1258 = phi_1599_;
                                                    if (_e1249.y > _e1251.y) {
                                                        phi_1608_ = _e1249.y;
                                                    } else {
                                                        phi_1608_ = _e1251.y;
                                                    }
                                                    let _e1265 = phi_1608_;
                                                    if (_e1249.z > _e1251.z) {
                                                        phi_1617_ = _e1249.z;
                                                    } else {
                                                        phi_1617_ = _e1251.z;
                                                    }
                                                    let _e1272 = phi_1617_;
                                                    let _e1274 = triangles.member[(0u + _e919)].v2_;
                                                    if (_e1258 > _e1274.x) {
                                                        phi_1626_ = _e1258;
                                                    } else {
                                                        phi_1626_ = _e1274.x;
                                                    }
                                                    let _e1279 = phi_1626_;
                                                    if (_e1265 > _e1274.y) {
                                                        phi_1633_ = _e1265;
                                                    } else {
                                                        phi_1633_ = _e1274.y;
                                                    }
                                                    let _e1284 = phi_1633_;
                                                    if (_e1272 > _e1274.z) {
                                                        phi_1640_ = _e1272;
                                                    } else {
                                                        phi_1640_ = _e1274.z;
                                                    }
                                                    let _e1289 = phi_1640_;
                                                    let _e1293 = ((_e1237 - _e118) * _e436);
                                                    let _e1294 = ((_e1242 - _e120) * _e446);
                                                    let _e1295 = ((_e1247 - _e122) * _e456);
                                                    let _e1299 = ((_e1279 - _e118) * _e436);
                                                    let _e1300 = ((_e1284 - _e120) * _e446);
                                                    let _e1301 = ((_e1289 - _e122) * _e456);
                                                    if (_e1293 < _e1299) {
                                                        phi_1657_ = _e1293;
                                                    } else {
                                                        phi_1657_ = _e1299;
                                                    }
                                                    let _e1304 = phi_1657_;
                                                    if (_e1294 < _e1300) {
                                                        phi_1662_ = _e1294;
                                                    } else {
                                                        phi_1662_ = _e1300;
                                                    }
                                                    let _e1307 = phi_1662_;
                                                    if (_e1295 < _e1301) {
                                                        phi_1667_ = _e1295;
                                                    } else {
                                                        phi_1667_ = _e1301;
                                                    }
                                                    let _e1310 = phi_1667_;
                                                    if (_e1293 > _e1299) {
                                                        phi_1675_ = _e1293;
                                                    } else {
                                                        phi_1675_ = _e1299;
                                                    }
                                                    let _e1316 = phi_1675_;
                                                    if (_e1294 > _e1300) {
                                                        phi_1680_ = _e1294;
                                                    } else {
                                                        phi_1680_ = _e1300;
                                                    }
                                                    let _e1319 = phi_1680_;
                                                    if (_e1295 > _e1301) {
                                                        phi_1685_ = _e1295;
                                                    } else {
                                                        phi_1685_ = _e1301;
                                                    }
                                                    let _e1322 = phi_1685_;
                                                    let _e1326 = core_intrinsics_maximum_number_nsz_f32_((_e1304 - _e491), (_e1307 - _e492));
                                                    let _e1327 = core_intrinsics_maximum_number_nsz_f32_(_e1326, (_e1310 - _e493));
                                                    let _e1328 = core_intrinsics_minimum_number_nsz_f32_((_e1316 + _e491), (_e1319 + _e492));
                                                    let _e1329 = core_intrinsics_minimum_number_nsz_f32_(_e1328, (_e1322 + _e493));
                                                    if (_e1327 > -300000000000000000000000000000000000000f) {
                                                        phi_1697_ = _e1327;
                                                    } else {
                                                        phi_1697_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1332 = phi_1697_;
                                                    if (_e1329 < 300000000000000000000000000000000000000f) {
                                                        phi_1702_ = _e1329;
                                                    } else {
                                                        phi_1702_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1335 = phi_1702_;
                                                    if (_e1203 < _e1332) {
                                                        phi_1707_ = _e1332;
                                                    } else {
                                                        phi_1707_ = _e1203;
                                                    }
                                                    let _e1338 = phi_1707_;
                                                    if (_e1338 > _e1335) {
                                                        phi_1712_ = _e1335;
                                                    } else {
                                                        phi_1712_ = _e1338;
                                                    }
                                                    let _e1341 = phi_1712_;
                                                    phi_1717_ = lt_bvh_triangle_Intersection(_e1341, (_e1044 / _e1103), (_e1065 / _e1103), (_e1332 <= _e1335));
                                                    phi_1718_ = false;
                                                } else {
                                                    phi_1717_ = lt_bvh_triangle_Intersection();
                                                    phi_1718_ = true;
                                                }
                                                let _e1347 = phi_1717_;
                                                let _e1349 = phi_1718_;
                                                phi_1719_ = _e1347;
                                                phi_1720_ = _e1349;
                                            } else {
                                                phi_1719_ = lt_bvh_triangle_Intersection();
                                                phi_1720_ = true;
                                            }
                                            let _e1351 = phi_1719_;
                                            let _e1353 = phi_1720_;
                                            if _e1353 {
                                            }
                                            phi_1724_ = _e1351;
                                            phi_1725_ = _e1353;
                                        }
                                        let _e1355 = phi_1724_;
                                        let _e1357 = phi_1725_;
                                        phi_1726_ = _e1355;
                                        phi_1727_ = _e1106;
                                        phi_1728_ = _e1357;
                                    } else {
                                        phi_1726_ = lt_bvh_triangle_Intersection();
                                        phi_1727_ = true;
                                        phi_1728_ = false;
                                    }
                                    let _e1359 = phi_1726_;
                                    let _e1361 = phi_1727_;
                                    let _e1363 = phi_1728_;
                                    if _e1361 {
                                        phi_1732_ = true;
                                    } else {
                                        phi_1732_ = _e1363;
                                    }
                                    let _e1365 = phi_1732_;
                                    if _e1365 {
                                        phi_1736_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1736_ = _e1359;
                                    }
                                    let _e1367 = phi_1736_;
                                    if _e1367.is_hit {
                                        if (_e1367.t > 0f) {
                                            if (_e1367.t < _e130) {
                                                let _e1374 = triangles.member[(0u + _e919)].i0_;
                                                let _e1376 = ((_e1374 & 2147483648u) == 0u);
                                                if _e1376 {
                                                    phi_1762_ = false;
                                                    phi_1763_ = false;
                                                } else {
                                                    if true {
                                                        phi_1761_ = false;
                                                    } else {
                                                        phi_1761_ = true;
                                                    }
                                                    let _e1378 = phi_1761_;
                                                    phi_1762_ = _e1378;
                                                    phi_1763_ = true;
                                                }
                                                let _e1380 = phi_1762_;
                                                let _e1382 = phi_1763_;
                                                phi_1764_ = _e1380;
                                                phi_1765_ = _e1376;
                                                phi_1766_ = _e1382;
                                            } else {
                                                phi_1764_ = true;
                                                phi_1765_ = false;
                                                phi_1766_ = false;
                                            }
                                            let _e1384 = phi_1764_;
                                            let _e1386 = phi_1765_;
                                            let _e1388 = phi_1766_;
                                            phi_1767_ = false;
                                            phi_1768_ = _e1384;
                                            phi_1769_ = _e1386;
                                            phi_1770_ = _e1388;
                                        } else {
                                            phi_1767_ = true;
                                            phi_1768_ = false;
                                            phi_1769_ = false;
                                            phi_1770_ = false;
                                        }
                                        let _e1390 = phi_1767_;
                                        let _e1392 = phi_1768_;
                                        let _e1394 = phi_1769_;
                                        let _e1396 = phi_1770_;
                                        phi_1771_ = _e1390;
                                        phi_1772_ = _e1392;
                                        phi_1773_ = _e1394;
                                        phi_1774_ = _e1396;
                                    } else {
                                        phi_1771_ = true;
                                        phi_1772_ = false;
                                        phi_1773_ = false;
                                        phi_1774_ = false;
                                    }
                                    let _e1398 = phi_1771_;
                                    let _e1400 = phi_1772_;
                                    let _e1402 = phi_1773_;
                                    let _e1404 = phi_1774_;
                                    if _e1398 {
                                        phi_1778_ = true;
                                        phi_1779_ = false;
                                        phi_1780_ = false;
                                    } else {
                                        phi_1778_ = _e1400;
                                        phi_1779_ = _e1402;
                                        phi_1780_ = _e1404;
                                    }
                                    let _e1406 = phi_1778_;
                                    let _e1408 = phi_1779_;
                                    let _e1410 = phi_1780_;
                                    if _e1406 {
                                        phi_1784_ = false;
                                        phi_1785_ = false;
                                    } else {
                                        phi_1784_ = _e1408;
                                        phi_1785_ = _e1410;
                                    }
                                    let _e1412 = phi_1784_;
                                    let _e1414 = phi_1785_;
                                    phi_1138_ = (_e883 & (_e883 - 1u));
                                    phi_1786_ = _e1406;
                                    phi_1787_ = _e1412;
                                    phi_1788_ = _e1414;
                                }
                                let _e1416 = phi_1138_;
                                let _e1418 = phi_1786_;
                                let _e1420 = phi_1787_;
                                let _e1422 = phi_1788_;
                                local_12 = _e1420;
                                local_13 = _e1422;
                                continue;
                                continuing {
                                    phi_1137_ = _e1416;
                                    break if !(_e1418);
                                }
                            }
                            let _e1425 = local_4;
                            if _e1425 {
                                phi_1792_ = false;
                                phi_1793_ = false;
                            } else {
                                let _e3075 = local_12;
                                phi_1792_ = _e3075;
                                let _e3078 = local_13;
                                phi_1793_ = _e3078;
                            }
                            let _e1427 = phi_1792_;
                            let _e1429 = phi_1793_;
                            let _e3081 = local_14;
                            phi_767_ = _e3081;
                            let _e3084 = local_15;
                            phi_770_ = _e3084;
                            let _e3087 = local_16;
                            phi_1794_ = _e3087;
                            phi_1795_ = _e1427;
                            phi_1796_ = _e1429;
                        }
                        let _e1431 = phi_767_;
                        let _e1433 = phi_770_;
                        let _e1435 = phi_1794_;
                        let _e1437 = phi_1795_;
                        let _e1439 = phi_1796_;
                        local_17 = _e1437;
                        local_18 = _e1439;
                        continue;
                        continuing {
                            phi_766_ = _e1431;
                            phi_769_ = _e1433;
                            break if !(_e1435);
                        }
                    }
                    let _e1442 = local_5;
                    if _e1442 {
                        phi_1800_ = false;
                        phi_1801_ = false;
                    } else {
                        let _e3093 = local_17;
                        phi_1800_ = _e3093;
                        let _e3096 = local_18;
                        phi_1801_ = _e3096;
                    }
                    let _e1444 = phi_1800_;
                    let _e1446 = phi_1801_;
                    if _e1444 {
                        phi_1805_ = false;
                    } else {
                        phi_1805_ = _e1446;
                    }
                    let _e1448 = phi_1805_;
                    if _e1448 {
                        phi_1809_ = true;
                    } else {
                        phi_1809_ = _e1444;
                    }
                    let _e1450 = phi_1809_;
                    if _e1450 {
                    }
                    phi_1813_ = true;
                    phi_1814_ = _e1450;
                }
                let _e1452 = phi_1813_;
                let _e1454 = phi_1814_;
                if _e1454 {
                    phi_1818_ = _e1452;
                } else {
                    phi_1818_ = false;
                }
                let _e1456 = phi_1818_;
                phi_3275_ = _e1456;
            } else {
                let _e1457 = abs(_e138);
                let _e1458 = abs(_e139);
                let _e1459 = abs(_e140);
                if (abs(_e118) < 1000000000000000f) {
                    if (abs(_e120) < 1000000000000000f) {
                        phi_1834_ = (abs(_e122) < 1000000000000000f);
                        phi_1835_ = false;
                    } else {
                        phi_1834_ = bool();
                        phi_1835_ = true;
                    }
                    let _e1467 = phi_1834_;
                    let _e1469 = phi_1835_;
                    phi_1836_ = _e1467;
                    phi_1837_ = _e1469;
                } else {
                    phi_1836_ = bool();
                    phi_1837_ = true;
                }
                let _e1471 = phi_1836_;
                let _e1473 = phi_1837_;
                if _e1473 {
                    phi_1841_ = false;
                } else {
                    phi_1841_ = _e1471;
                }
                let _e1475 = phi_1841_;
                if _e1475 {
                    if (_e1457 < 1000000000000000f) {
                        if (_e1458 < 1000000000000000f) {
                            phi_1854_ = (_e1459 < 1000000000000000f);
                            phi_1855_ = false;
                        } else {
                            phi_1854_ = bool();
                            phi_1855_ = true;
                        }
                        let _e1480 = phi_1854_;
                        let _e1482 = phi_1855_;
                        phi_1856_ = _e1480;
                        phi_1857_ = _e1482;
                    } else {
                        phi_1856_ = bool();
                        phi_1857_ = true;
                    }
                    let _e1484 = phi_1856_;
                    let _e1486 = phi_1857_;
                    if _e1486 {
                        phi_1861_ = false;
                    } else {
                        phi_1861_ = _e1484;
                    }
                    let _e1488 = phi_1861_;
                    if _e1488 {
                        if (_e1457 > 0f) {
                            phi_1875_ = bool();
                            phi_1876_ = true;
                        } else {
                            let _e1490 = (_e1458 > 0f);
                            if _e1490 {
                                phi_1874_ = bool();
                            } else {
                                phi_1874_ = (_e1459 > 0f);
                            }
                            let _e1493 = phi_1874_;
                            phi_1875_ = _e1493;
                            phi_1876_ = _e1490;
                        }
                        let _e1495 = phi_1875_;
                        let _e1497 = phi_1876_;
                        if _e1497 {
                            phi_1880_ = true;
                        } else {
                            phi_1880_ = _e1495;
                        }
                        let _e1499 = phi_1880_;
                        phi_1881_ = _e1499;
                        phi_1882_ = false;
                    } else {
                        phi_1881_ = bool();
                        phi_1882_ = true;
                    }
                    let _e1501 = phi_1881_;
                    let _e1503 = phi_1882_;
                    phi_1883_ = _e1501;
                    phi_1884_ = _e1503;
                } else {
                    phi_1883_ = bool();
                    phi_1884_ = true;
                }
                let _e1505 = phi_1883_;
                let _e1507 = phi_1884_;
                if _e1507 {
                    phi_1888_ = false;
                } else {
                    phi_1888_ = _e1505;
                }
                let _e1509 = phi_1888_;
                if _e1509 {
                    let _e1510 = (0u >= _e71);
                    if _e1510 {
                        phi_3268_ = bool();
                    } else {
                        if (0u < _e71) {
                        } else {
                            return;
                        }
                        let _e1516 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1520 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1524 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1528 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1532 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1536 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1540 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1574 = core_intrinsics_maximum_number_nsz_f32_(abs(_e138), abs(_e139));
                        let _e1575 = core_intrinsics_maximum_number_nsz_f32_(_e1574, abs(_e140));
                        let _e1576 = (_e1575 * 0.0000000000009094947f);
                        if (abs(_e138) < _e1576) {
                            phi_1958_ = _e1576;
                        } else {
                            phi_1958_ = abs(_e138);
                        }
                        let _e1581 = phi_1958_;
                        if (_e138 < 0f) {
                            phi_1965_ = (-1f / _e1581);
                        } else {
                            phi_1965_ = (1f / _e1581);
                        }
                        let _e1586 = phi_1965_;
                        if (abs(_e139) < _e1576) {
                            phi_1972_ = _e1576;
                        } else {
                            phi_1972_ = abs(_e139);
                        }
                        let _e1591 = phi_1972_;
                        if (_e139 < 0f) {
                            phi_1979_ = (-1f / _e1591);
                        } else {
                            phi_1979_ = (1f / _e1591);
                        }
                        let _e1596 = phi_1979_;
                        if (abs(_e140) < _e1576) {
                            phi_1986_ = _e1576;
                        } else {
                            phi_1986_ = abs(_e140);
                        }
                        let _e1601 = phi_1986_;
                        if (_e140 < 0f) {
                            phi_1993_ = (-1f / _e1601);
                        } else {
                            phi_1993_ = (1f / _e1601);
                        }
                        let _e1606 = phi_1993_;
                        let _e1610 = abs((bitcast<f32>(_e1516) - _e118));
                        let _e1611 = abs((bitcast<f32>(_e1520) - _e120));
                        let _e1612 = abs((bitcast<f32>(_e1524) - _e122));
                        let _e1616 = abs(((bitcast<f32>(_e1528) + (bitcast<f32>((((_e1540 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e118));
                        let _e1617 = abs(((bitcast<f32>(_e1532) + (bitcast<f32>((((_e1540 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                        let _e1618 = abs(((bitcast<f32>(_e1536) + (bitcast<f32>((((_e1540 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                        if (_e1610 > _e1616) {
                            phi_2010_ = _e1610;
                        } else {
                            phi_2010_ = _e1616;
                        }
                        let _e1621 = phi_2010_;
                        if (_e1611 > _e1617) {
                            phi_2015_ = _e1611;
                        } else {
                            phi_2015_ = _e1617;
                        }
                        let _e1624 = phi_2015_;
                        if (_e1612 > _e1618) {
                            phi_2020_ = _e1612;
                        } else {
                            phi_2020_ = _e1618;
                        }
                        let _e1627 = phi_2020_;
                        if (_e1621 > _e1624) {
                            phi_2025_ = _e1621;
                        } else {
                            phi_2025_ = _e1624;
                        }
                        let _e1630 = phi_2025_;
                        if (_e1630 > _e1627) {
                            phi_2030_ = _e1630;
                        } else {
                            phi_2030_ = _e1627;
                        }
                        let _e1633 = phi_2030_;
                        let _e1637 = (_e1633 * 0.0000019073486f);
                        let _e1638 = (abs(_e1586) * _e1637);
                        let _e1639 = (abs(_e1596) * _e1637);
                        let _e1640 = (abs(_e1606) * _e1637);
                        let _e1644 = (_e1633 * 0.0000009536743f);
                        let _e1645 = (abs(_e1586) * _e1644);
                        let _e1646 = (abs(_e1596) * _e1644);
                        let _e1647 = (abs(_e1606) * _e1644);
                        let _e1648 = abs(_e138);
                        let _e1649 = abs(_e139);
                        let _e1650 = abs(_e140);
                        if (_e1648 >= _e1649) {
                            if (_e1648 >= _e1650) {
                                phi_2056_ = false;
                            } else {
                                phi_2056_ = true;
                            }
                            let _e1654 = phi_2056_;
                            phi_2057_ = _e1654;
                        } else {
                            phi_2057_ = true;
                        }
                        let _e1656 = phi_2057_;
                        if _e1656 {
                            if (_e1649 >= _e1650) {
                                phi_2065_ = 1u;
                            } else {
                                phi_2065_ = 2u;
                            }
                            let _e1659 = phi_2065_;
                            phi_2066_ = _e1659;
                        } else {
                            phi_2066_ = 0u;
                        }
                        let _e1661 = phi_2066_;
                        if (_e1661 == 0u) {
                            phi_2078_ = vec3<f32>(_e139, _e140, _e138);
                        } else {
                            if (_e1661 == 1u) {
                                phi_2077_ = vec3<f32>(_e140, _e138, _e139);
                            } else {
                                phi_2077_ = _e141;
                            }
                            let _e1667 = phi_2077_;
                            phi_2078_ = _e1667;
                        }
                        let _e1669 = phi_2078_;
                        let _e1672 = (_e1669.x / _e1669.z);
                        let _e1675 = (_e1669.y / _e1669.z);
                        if (_e1586 < 0f) {
                            phi_2091_ = 0u;
                        } else {
                            phi_2091_ = 1u;
                        }
                        let _e1680 = phi_2091_;
                        if (_e1596 < 0f) {
                            phi_2096_ = 0u;
                        } else {
                            phi_2096_ = 2u;
                        }
                        let _e1683 = phi_2096_;
                        if (_e1606 < 0f) {
                            phi_2101_ = 0u;
                        } else {
                            phi_2101_ = 4u;
                        }
                        let _e1686 = phi_2101_;
                        let _e1688 = ((_e1680 | _e1683) | _e1686);
                        let _e1689 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1689.first[0], _e1689.first[1], _e1689.first[2], _e1689.first[3], _e1689.first[4], _e1689.first[5], _e1689.first[6], _e1689.first[7], _e1689.first[8], _e1689.first[9], _e1689.first[10], _e1689.first[11], _e1689.first[12], _e1689.first[13], _e1689.first[14], _e1689.first[15], _e1689.first[16], _e1689.first[17], _e1689.first[18], _e1689.first[19], _e1689.first[20], _e1689.first[21], _e1689.first[22], _e1689.first[23], _e1689.first[24], _e1689.first[25], _e1689.first[26], _e1689.first[27], _e1689.first[28], _e1689.first[29], _e1689.first[30], _e1689.first[31]), array<u32, 32>(_e1689.mask[0], _e1689.mask[1], _e1689.mask[2], _e1689.mask[3], _e1689.mask[4], _e1689.mask[5], _e1689.mask[6], _e1689.mask[7], _e1689.mask[8], _e1689.mask[9], _e1689.mask[10], _e1689.mask[11], _e1689.mask[12], _e1689.mask[13], _e1689.mask[14], _e1689.mask[15], _e1689.mask[16], _e1689.mask[17], _e1689.mask[18], _e1689.mask[19], _e1689.mask[20], _e1689.mask[21], _e1689.mask[22], _e1689.mask[23], _e1689.mask[24], _e1689.mask[25], _e1689.mask[26], _e1689.mask[27], _e1689.mask[28], _e1689.mask[29], _e1689.mask[30], _e1689.mask[31]), _e1689.len, _e1689.group, _e1689.group_mask);
                        let _e1763 = local.group_mask;
                        if ((_e1763 & 4278190080u) == 0u) {
                            let _e1767 = local.len;
                            if (_e1767 == 0u) {
                                phi_2215_ = false;
                            } else {
                                let _e1771 = local.len;
                                local.len = (_e1771 - 1u);
                                let _e1774 = local.len;
                                if (_e1774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1779 = local.first[(0u + _e1774)];
                                local.group = _e1779;
                                let _e1782 = local.len;
                                if (_e1782 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1787 = local.mask[(0u + _e1782)];
                                local.group_mask = _e1787;
                                phi_2215_ = true;
                            }
                            let _e1790 = phi_2215_;
                            phi_2216_ = _e1790;
                        } else {
                            phi_2216_ = true;
                        }
                        let _e1792 = phi_2216_;
                        if _e1792 {
                            let _e1794 = local.group_mask;
                            let _e1800 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1794)), 32u, (_e1794 == 0u)));
                            let _e1804 = local.group_mask;
                            let _e1818 = local.group_mask;
                            local.group_mask = (_e1818 & ~((1u << bitcast<u32>((_e1800 & 31u)))));
                            let _e1821 = local.group;
                            phi_2247_ = (_e1821 + countOneBits(((_e1804 & ~((4294967295u << bitcast<u32>((((_e1800 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2247_ = 4294967295u;
                        }
                        let _e1824 = phi_2247_;
                        phi_2249_ = _e1824;
                        phi_2252_ = false;
                        loop {
                            let _e1826 = phi_2249_;
                            let _e1828 = phi_2252_;
                            local_21 = _e1828;
                            if (_e1826 != 4294967295u) {
                                if (_e1826 < _e71) {
                                } else {
                                    return;
                                }
                                let _e1835 = nodes.member[(0u + _e1826)].frame[3u];
                                let _e1860 = (bitcast<f32>((((_e1835 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1586);
                                let _e1861 = (bitcast<f32>((((_e1835 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1596);
                                let _e1862 = (bitcast<f32>((((_e1835 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1606);
                                let _e1865 = nodes.member[(0u + _e1826)].frame[0u];
                                let _e1869 = nodes.member[(0u + _e1826)].frame[1u];
                                let _e1873 = nodes.member[(0u + _e1826)].frame[2u];
                                let _e1878 = ((bitcast<f32>(_e1865) - _e118) * _e1586);
                                let _e1879 = ((bitcast<f32>(_e1869) - _e120) * _e1596);
                                let _e1880 = ((bitcast<f32>(_e1873) - _e122) * _e1606);
                                let _e1888 = nodes.member[(0u + _e1826)].x;
                                if (_e1586 < 0f) {
                                    let _e1899 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1888.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1905 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1899.unnamed.word, _e1888.w), _e1899.unnamed_1);
                                    let _e1911 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1905.unnamed, lt_mask_LightPlace(_e1888.x, _e1905.unnamed_1.shift));
                                    phi_2332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1911.unnamed, lt_mask_LightPlace(_e1911.unnamed_1.word, _e1888.y));
                                } else {
                                    let _e1927 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1888.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1933 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1927.unnamed.word, _e1888.y), _e1927.unnamed_1);
                                    let _e1939 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1933.unnamed, lt_mask_LightPlace(_e1888.z, _e1933.unnamed_1.shift));
                                    phi_2332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1939.unnamed, lt_mask_LightPlace(_e1939.unnamed_1.word, _e1888.w));
                                }
                                let _e1947 = phi_2332_;
                                let _e1957 = nodes.member[(0u + _e1826)].y;
                                if (_e1596 < 0f) {
                                    let _e1968 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1957.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e1974 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1968.unnamed.word, _e1957.w), _e1968.unnamed_1);
                                    let _e1980 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1974.unnamed, lt_mask_LightPlace(_e1957.x, _e1974.unnamed_1.shift));
                                    phi_2359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1980.unnamed, lt_mask_LightPlace(_e1980.unnamed_1.word, _e1957.y));
                                } else {
                                    let _e1996 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1957.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2002 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1996.unnamed.word, _e1957.y), _e1996.unnamed_1);
                                    let _e2008 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2002.unnamed, lt_mask_LightPlace(_e1957.z, _e2002.unnamed_1.shift));
                                    phi_2359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2008.unnamed, lt_mask_LightPlace(_e2008.unnamed_1.word, _e1957.w));
                                }
                                let _e2016 = phi_2359_;
                                let _e2026 = nodes.member[(0u + _e1826)].z;
                                if (_e1606 < 0f) {
                                    let _e2037 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2026.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2043 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2037.unnamed.word, _e2026.w), _e2037.unnamed_1);
                                    let _e2049 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2043.unnamed, lt_mask_LightPlace(_e2026.x, _e2043.unnamed_1.shift));
                                    phi_2386_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2049.unnamed, lt_mask_LightPlace(_e2049.unnamed_1.word, _e2026.y));
                                } else {
                                    let _e2065 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2026.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2071 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2065.unnamed.word, _e2026.y), _e2065.unnamed_1);
                                    let _e2077 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2071.unnamed, lt_mask_LightPlace(_e2026.z, _e2071.unnamed_1.shift));
                                    phi_2386_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2077.unnamed, lt_mask_LightPlace(_e2077.unnamed_1.word, _e2026.w));
                                }
                                let _e2085 = phi_2386_;
                                phi_2392_ = 0u;
                                phi_2395_ = 0u;
                                loop {
                                    let _e2095 = phi_2392_;
                                    let _e2097 = phi_2395_;
                                    local_6 = _e2097;
                                    local_7 = _e2097;
                                    local_8 = _e2097;
                                    let _e2098 = (_e2095 < 8u);
                                    if _e2098 {
                                        let _e2100 = (_e2095 >> bitcast<u32>(2i));
                                        let _e2101 = (_e2095 & 3u);
                                        if (_e2100 == 0u) {
                                            phi_2409_ = _e1947.unnamed.word;
                                        } else {
                                            phi_2409_ = _e1947.unnamed.shift;
                                        }
                                        let _e2104 = phi_2409_;
                                        if (_e2100 == 0u) {
                                            phi_2419_ = _e2016.unnamed.word;
                                        } else {
                                            phi_2419_ = _e2016.unnamed.shift;
                                        }
                                        let _e2113 = phi_2419_;
                                        if (_e2100 == 0u) {
                                            phi_2429_ = _e2085.unnamed.word;
                                        } else {
                                            phi_2429_ = _e2085.unnamed.shift;
                                        }
                                        let _e2122 = phi_2429_;
                                        let _e2135 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2104 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u)) * _e1860) + (_e1878 - _e1638)), ((f32(((_e2113 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u)) * _e1861) + (_e1879 - _e1639)));
                                        let _e2136 = core_intrinsics_maximum_number_nsz_f32_(_e2135, ((f32(((_e2122 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u)) * _e1862) + (_e1880 - _e1640)));
                                        if (_e2100 == 0u) {
                                            phi_2447_ = _e1947.unnamed_1.word;
                                        } else {
                                            phi_2447_ = _e1947.unnamed_1.shift;
                                        }
                                        let _e2139 = phi_2447_;
                                        if (_e2100 == 0u) {
                                            phi_2457_ = _e2016.unnamed_1.word;
                                        } else {
                                            phi_2457_ = _e2016.unnamed_1.shift;
                                        }
                                        let _e2148 = phi_2457_;
                                        if (_e2100 == 0u) {
                                            phi_2467_ = _e2085.unnamed_1.word;
                                        } else {
                                            phi_2467_ = _e2085.unnamed_1.shift;
                                        }
                                        let _e2157 = phi_2467_;
                                        let _e2170 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2139 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u)) * _e1860) + (_e1878 + _e1638)), ((f32(((_e2148 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u)) * _e1861) + (_e1879 + _e1639)));
                                        let _e2171 = core_intrinsics_minimum_number_nsz_f32_(_e2170, ((f32(((_e2157 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u)) * _e1862) + (_e1880 + _e1640)));
                                        if (_e2136 <= _e2171) {
                                            if (_e2136 <= _e130) {
                                                if (_e2171 >= 0f) {
                                                    if (_e2100 == 0u) {
                                                        let _e2178 = nodes.member[(0u + _e1826)].links[2u];
                                                        phi_2503_ = _e2178;
                                                    } else {
                                                        let _e2181 = nodes.member[(0u + _e1826)].links[3u];
                                                        phi_2503_ = _e2181;
                                                    }
                                                    let _e2183 = phi_2503_;
                                                    let _e2188 = ((_e2183 >> bitcast<u32>(((_e2101 * 8u) & 31u))) & 255u);
                                                    let _e2189 = (_e2188 & 31u);
                                                    if (_e2189 >= 24u) {
                                                        phi_2516_ = (24u + ((_e2189 - 24u) ^ _e1688));
                                                    } else {
                                                        phi_2516_ = _e2189;
                                                    }
                                                    let _e2195 = phi_2516_;
                                                    phi_2521_ = (_e2097 | ((_e2188 >> bitcast<u32>(5i)) << bitcast<u32>((_e2195 & 31u))));
                                                } else {
                                                    phi_2521_ = _e2097;
                                                }
                                                let _e2203 = phi_2521_;
                                                phi_2522_ = _e2203;
                                            } else {
                                                phi_2522_ = _e2097;
                                            }
                                            let _e2205 = phi_2522_;
                                            phi_2523_ = _e2205;
                                        } else {
                                            phi_2523_ = _e2097;
                                        }
                                        let _e2207 = phi_2523_;
                                        phi_2393_ = (_e2095 + 1u);
                                        phi_2396_ = _e2207;
                                    } else {
                                        phi_2393_ = u32();
                                        phi_2396_ = u32();
                                    }
                                    let _e2210 = phi_2393_;
                                    let _e2212 = phi_2396_;
                                    continue;
                                    continuing {
                                        phi_2392_ = _e2210;
                                        phi_2395_ = _e2212;
                                        break if !(_e2098);
                                    }
                                }
                                let _e2216 = nodes.member[(0u + _e1826)].links[0u];
                                let _e2220 = nodes.member[(0u + _e1826)].frame[3u];
                                let _e2224 = local_6;
                                if ((_e2224 & 4278190080u) == 0u) {
                                } else {
                                    let _e2228 = local.group_mask;
                                    if ((_e2228 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2232 = local.len;
                                        if (_e2232 < 32u) {
                                            let _e2235 = local.group;
                                            let _e2237 = local.len;
                                            if (_e2237 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2237)] = _e2235;
                                            let _e2243 = local.group_mask;
                                            let _e2245 = local.len;
                                            if (_e2245 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2245)] = _e2243;
                                            let _e2252 = local.len;
                                            local.len = (_e2252 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2216);
                                    let _e2256 = local_7;
                                    local.group_mask = ((_e2256 & 4278190080u) | (_e2220 >> bitcast<u32>(24i)));
                                }
                                let _e2261 = local_8;
                                phi_2581_ = (_e2261 & 16777215u);
                                phi_2584_ = _e1828;
                                loop {
                                    let _e2264 = phi_2581_;
                                    let _e2266 = phi_2584_;
                                    local_19 = _e2266;
                                    let _e2267 = (_e2264 == 0u);
                                    local_9 = _e2267;
                                    local_20 = _e2267;
                                    if _e2267 {
                                        phi_2582_ = u32();
                                        phi_2585_ = bool();
                                        phi_3182_ = false;
                                    } else {
                                        let _e2270 = nodes.member[(0u + _e1826)].links[1u];
                                        let _e2275 = ((0u + _e2270) + select(firstTrailingBit(_e2264), 32u, (_e2264 == 0u)));
                                        if (_e2275 < _e74) {
                                        } else {
                                            return;
                                        }
                                        let _e2282 = triangles.member[(0u + _e2275)].v0_;
                                        let _e2284 = (_e2282.x - _e118);
                                        let _e2286 = (_e2282.y - _e120);
                                        let _e2288 = (_e2282.z - _e122);
                                        if (_e1661 == 0u) {
                                            phi_2629_ = vec3<f32>(_e2286, _e2288, _e2284);
                                        } else {
                                            if (_e1661 == 1u) {
                                                phi_2628_ = vec3<f32>(_e2288, _e2284, _e2286);
                                            } else {
                                                phi_2628_ = (_e2282 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e2296 = phi_2628_;
                                            phi_2629_ = _e2296;
                                        }
                                        let _e2298 = phi_2629_;
                                        let _e2302 = (_e2298.x - (_e1672 * _e2298.z));
                                        let _e2306 = (_e2298.y - (_e1675 * _e2298.z));
                                        let _e2308 = triangles.member[(0u + _e2275)].v1_;
                                        let _e2310 = (_e2308.x - _e118);
                                        let _e2312 = (_e2308.y - _e120);
                                        let _e2314 = (_e2308.z - _e122);
                                        if (_e1661 == 0u) {
                                            phi_2659_ = vec3<f32>(_e2312, _e2314, _e2310);
                                        } else {
                                            if (_e1661 == 1u) {
                                                phi_2658_ = vec3<f32>(_e2314, _e2310, _e2312);
                                            } else {
                                                phi_2658_ = (_e2308 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e2322 = phi_2658_;
                                            phi_2659_ = _e2322;
                                        }
                                        let _e2324 = phi_2659_;
                                        let _e2328 = (_e2324.x - (_e1672 * _e2324.z));
                                        let _e2332 = (_e2324.y - (_e1675 * _e2324.z));
                                        let _e2334 = triangles.member[(0u + _e2275)].v2_;
                                        let _e2336 = (_e2334.x - _e118);
                                        let _e2338 = (_e2334.y - _e120);
                                        let _e2340 = (_e2334.z - _e122);
                                        if (_e1661 == 0u) {
                                            phi_2689_ = vec3<f32>(_e2338, _e2340, _e2336);
                                        } else {
                                            if (_e1661 == 1u) {
                                                phi_2688_ = vec3<f32>(_e2340, _e2336, _e2338);
                                            } else {
                                                phi_2688_ = (_e2334 - vec3<f32>(_e118, _e120, _e122));
                                            }
                                            let _e2348 = phi_2688_;
                                            phi_2689_ = _e2348;
                                        }
                                        let _e2350 = phi_2689_;
                                        let _e2354 = (_e2350.x - (_e1672 * _e2350.z));
                                        let _e2358 = (_e2350.y - (_e1675 * _e2350.z));
                                        if (_e2328 < _e2354) {
                                            phi_2708_ = true;
                                        } else {
                                            if (_e2328 == _e2354) {
                                                phi_2707_ = (_e2332 < _e2358);
                                            } else {
                                                phi_2707_ = false;
                                            }
                                            let _e2363 = phi_2707_;
                                            phi_2708_ = _e2363;
                                        }
                                        let _e2365 = phi_2708_;
                                        if _e2365 {
                                            phi_2712_ = _e2358;
                                            phi_2713_ = _e2354;
                                            phi_2714_ = _e2332;
                                            phi_2715_ = _e2328;
                                        } else {
                                            phi_2712_ = _e2332;
                                            phi_2713_ = _e2328;
                                            phi_2714_ = _e2358;
                                            phi_2715_ = _e2354;
                                        }
                                        let _e2367 = phi_2712_;
                                        let _e2369 = phi_2713_;
                                        let _e2371 = phi_2714_;
                                        let _e2373 = phi_2715_;
                                        let _e2376 = ((_e2373 * _e2367) - (_e2371 * _e2369));
                                        if _e2365 {
                                            phi_2723_ = -(_e2376);
                                        } else {
                                            phi_2723_ = _e2376;
                                        }
                                        let _e2379 = phi_2723_;
                                        if (_e2354 < _e2302) {
                                            phi_2734_ = true;
                                        } else {
                                            if (_e2354 == _e2302) {
                                                phi_2733_ = (_e2358 < _e2306);
                                            } else {
                                                phi_2733_ = false;
                                            }
                                            let _e2384 = phi_2733_;
                                            phi_2734_ = _e2384;
                                        }
                                        let _e2386 = phi_2734_;
                                        if _e2386 {
                                            phi_2738_ = _e2306;
                                            phi_2739_ = _e2302;
                                            phi_2740_ = _e2358;
                                            phi_2741_ = _e2354;
                                        } else {
                                            phi_2738_ = _e2358;
                                            phi_2739_ = _e2354;
                                            phi_2740_ = _e2306;
                                            phi_2741_ = _e2302;
                                        }
                                        let _e2388 = phi_2738_;
                                        let _e2390 = phi_2739_;
                                        let _e2392 = phi_2740_;
                                        let _e2394 = phi_2741_;
                                        let _e2397 = ((_e2394 * _e2388) - (_e2392 * _e2390));
                                        if _e2386 {
                                            phi_2749_ = -(_e2397);
                                        } else {
                                            phi_2749_ = _e2397;
                                        }
                                        let _e2400 = phi_2749_;
                                        if (_e2302 < _e2328) {
                                            phi_2760_ = true;
                                        } else {
                                            if (_e2302 == _e2328) {
                                                phi_2759_ = (_e2306 < _e2332);
                                            } else {
                                                phi_2759_ = false;
                                            }
                                            let _e2405 = phi_2759_;
                                            phi_2760_ = _e2405;
                                        }
                                        let _e2407 = phi_2760_;
                                        if _e2407 {
                                            phi_2764_ = _e2332;
                                            phi_2765_ = _e2328;
                                            phi_2766_ = _e2306;
                                            phi_2767_ = _e2302;
                                        } else {
                                            phi_2764_ = _e2306;
                                            phi_2765_ = _e2302;
                                            phi_2766_ = _e2332;
                                            phi_2767_ = _e2328;
                                        }
                                        let _e2409 = phi_2764_;
                                        let _e2411 = phi_2765_;
                                        let _e2413 = phi_2766_;
                                        let _e2415 = phi_2767_;
                                        let _e2418 = ((_e2415 * _e2409) - (_e2413 * _e2411));
                                        if _e2407 {
                                            phi_2775_ = -(_e2418);
                                        } else {
                                            phi_2775_ = _e2418;
                                        }
                                        let _e2421 = phi_2775_;
                                        if (_e2379 >= 0f) {
                                            if (_e2400 >= 0f) {
                                                if (_e2421 >= 0f) {
                                                    phi_2790_ = ((_e2379 + _e2400) + _e2421);
                                                    phi_2791_ = false;
                                                } else {
                                                    phi_2790_ = f32();
                                                    phi_2791_ = true;
                                                }
                                                let _e2428 = phi_2790_;
                                                let _e2430 = phi_2791_;
                                                phi_2792_ = _e2428;
                                                phi_2793_ = _e2430;
                                            } else {
                                                phi_2792_ = f32();
                                                phi_2793_ = true;
                                            }
                                            let _e2432 = phi_2792_;
                                            let _e2434 = phi_2793_;
                                            phi_2794_ = _e2432;
                                            phi_2795_ = _e2434;
                                        } else {
                                            phi_2794_ = f32();
                                            phi_2795_ = true;
                                        }
                                        let _e2436 = phi_2794_;
                                        let _e2438 = phi_2795_;
                                        if _e2438 {
                                            if (_e2379 <= 0f) {
                                                if (_e2400 <= 0f) {
                                                    let _e2441 = (_e2421 <= 0f);
                                                    if _e2441 {
                                                    }
                                                    phi_2813_ = ((_e2379 + _e2400) + _e2421);
                                                    phi_2814_ = false;
                                                    phi_2815_ = _e2441;
                                                } else {
                                                    phi_2813_ = f32();
                                                    phi_2814_ = true;
                                                    phi_2815_ = false;
                                                }
                                                let _e2445 = phi_2813_;
                                                let _e2447 = phi_2814_;
                                                let _e2449 = phi_2815_;
                                                phi_2816_ = _e2445;
                                                phi_2817_ = _e2447;
                                                phi_2818_ = _e2449;
                                            } else {
                                                phi_2816_ = f32();
                                                phi_2817_ = true;
                                                phi_2818_ = false;
                                            }
                                            let _e2451 = phi_2816_;
                                            let _e2453 = phi_2817_;
                                            let _e2455 = phi_2818_;
                                            if _e2453 {
                                                phi_2822_ = false;
                                            } else {
                                                phi_2822_ = _e2455;
                                            }
                                            let _e2457 = phi_2822_;
                                            phi_2823_ = _e2451;
                                            phi_2824_ = _e2457;
                                        } else {
                                            phi_2823_ = _e2436;
                                            phi_2824_ = true;
                                        }
                                        let _e2459 = phi_2823_;
                                        let _e2461 = phi_2824_;
                                        if _e2461 {
                                            let _e2462 = (_e2459 == 0f);
                                            if _e2462 {
                                                phi_3140_ = lt_bvh_triangle_Intersection();
                                                phi_3141_ = false;
                                            } else {
                                                let _e2464 = triangles.member[(0u + _e2275)].v0_;
                                                let _e2466 = (_e2464.x - _e118);
                                                let _e2468 = (_e2464.y - _e120);
                                                let _e2470 = (_e2464.z - _e122);
                                                if (_e1661 == 0u) {
                                                    phi_2853_ = vec3<f32>(_e2468, _e2470, _e2466);
                                                } else {
                                                    if (_e1661 == 1u) {
                                                        phi_2852_ = vec3<f32>(_e2470, _e2466, _e2468);
                                                    } else {
                                                        phi_2852_ = (_e2464 - vec3<f32>(_e118, _e120, _e122));
                                                    }
                                                    let _e2478 = phi_2852_;
                                                    phi_2853_ = _e2478;
                                                }
                                                let _e2480 = phi_2853_;
                                                let _e2482 = triangles.member[(0u + _e2275)].v1_;
                                                let _e2484 = triangles.member[(0u + _e2275)].v0_;
                                                let _e2487 = (_e2482.x - _e2484.x);
                                                let _e2490 = (_e2482.y - _e2484.y);
                                                let _e2493 = (_e2482.z - _e2484.z);
                                                if (_e1661 == 0u) {
                                                    phi_2879_ = vec3<f32>(_e2490, _e2493, _e2487);
                                                } else {
                                                    if (_e1661 == 1u) {
                                                        phi_2878_ = vec3<f32>(_e2493, _e2487, _e2490);
                                                    } else {
                                                        phi_2878_ = (_e2482 - _e2484);
                                                    }
                                                    let _e2500 = phi_2878_;
                                                    phi_2879_ = _e2500;
                                                }
                                                let _e2502 = phi_2879_;
                                                let _e2504 = triangles.member[(0u + _e2275)].v2_;
                                                let _e2506 = triangles.member[(0u + _e2275)].v0_;
                                                let _e2509 = (_e2504.x - _e2506.x);
                                                let _e2512 = (_e2504.y - _e2506.y);
                                                let _e2515 = (_e2504.z - _e2506.z);
                                                if (_e1661 == 0u) {
                                                    phi_2905_ = vec3<f32>(_e2512, _e2515, _e2509);
                                                } else {
                                                    if (_e1661 == 1u) {
                                                        phi_2904_ = vec3<f32>(_e2515, _e2509, _e2512);
                                                    } else {
                                                        phi_2904_ = (_e2504 - _e2506);
                                                    }
                                                    let _e2522 = phi_2904_;
                                                    phi_2905_ = _e2522;
                                                }
                                                let _e2524 = phi_2905_;
                                                let _e2531 = ((_e2502.y * _e2524.z) - (_e2502.z * _e2524.y));
                                                let _e2538 = ((_e2502.z * _e2524.x) - (_e2502.x * _e2524.z));
                                                let _e2545 = ((_e2502.x * _e2524.y) - (_e2502.y * _e2524.x));
                                                let _e2559 = (((1f / _e1669.z) * (((_e2531 * _e2480.x) + (_e2538 * _e2480.y)) + (_e2545 * _e2480.z))) / (((_e2531 * _e1672) + (_e2538 * _e1675)) + _e2545));
                                                if (_e2559 > 0f) {
                                                    if (_e2559 < _e130) {
                                                        let _e2563 = triangles.member[(0u + _e2275)].v0_;
                                                        let _e2565 = triangles.member[(0u + _e2275)].v1_;
                                                        if (_e2563.x < _e2565.x) {
                                                            phi_2961_ = _e2563.x;
                                                        } else {
                                                            phi_2961_ = _e2565.x;
                                                        }
                                                        let _e2572 = phi_2961_;
                                                        if (_e2563.y < _e2565.y) {
                                                            phi_2970_ = _e2563.y;
                                                        } else {
                                                            phi_2970_ = _e2565.y;
                                                        }
                                                        let _e2579 = phi_2970_;
                                                        if (_e2563.z < _e2565.z) {
                                                            phi_2979_ = _e2563.z;
                                                        } else {
                                                            phi_2979_ = _e2565.z;
                                                        }
                                                        let _e2586 = phi_2979_;
                                                        let _e2588 = triangles.member[(0u + _e2275)].v2_;
                                                        if (_e2572 < _e2588.x) {
                                                            phi_2988_ = _e2572;
                                                        } else {
                                                            phi_2988_ = _e2588.x;
                                                        }
                                                        let _e2593 = phi_2988_;
                                                        if (_e2579 < _e2588.y) {
                                                            phi_2995_ = _e2579;
                                                        } else {
                                                            phi_2995_ = _e2588.y;
                                                        }
                                                        let _e2598 = phi_2995_;
                                                        if (_e2586 < _e2588.z) {
                                                            phi_3002_ = _e2586;
                                                        } else {
                                                            phi_3002_ = _e2588.z;
                                                        }
                                                        let _e2603 = phi_3002_;
                                                        let _e2605 = triangles.member[(0u + _e2275)].v0_;
                                                        let _e2607 = triangles.member[(0u + _e2275)].v1_;
                                                        if (_e2605.x > _e2607.x) {
                                                            phi_3015_ = _e2605.x;
                                                        } else {
                                                            phi_3015_ = _e2607.x;
                                                        }
                                                        let _e2614 = phi_3015_;
                                                        if (_e2605.y > _e2607.y) {
                                                            phi_3024_ = _e2605.y;
                                                        } else {
                                                            phi_3024_ = _e2607.y;
                                                        }
                                                        let _e2621 = phi_3024_;
                                                        if (_e2605.z > _e2607.z) {
                                                            phi_3033_ = _e2605.z;
                                                        } else {
                                                            phi_3033_ = _e2607.z;
                                                        }
                                                        let _e2628 = phi_3033_;
                                                        let _e2630 = triangles.member[(0u + _e2275)].v2_;
                                                        if (_e2614 > _e2630.x) {
                                                            phi_3042_ = _e2614;
                                                        } else {
                                                            phi_3042_ = _e2630.x;
                                                        }
                                                        let _e2635 = phi_3042_;
                                                        if (_e2621 > _e2630.y) {
                                                            phi_3049_ = _e2621;
                                                        } else {
                                                            phi_3049_ = _e2630.y;
                                                        }
                                                        let _e2640 = phi_3049_;
                                                        if (_e2628 > _e2630.z) {
                                                            phi_3056_ = _e2628;
                                                        } else {
                                                            phi_3056_ = _e2630.z;
                                                        }
                                                        let _e2645 = phi_3056_;
                                                        let _e2649 = ((_e2593 - _e118) * _e1586);
                                                        let _e2650 = ((_e2598 - _e120) * _e1596);
                                                        let _e2651 = ((_e2603 - _e122) * _e1606);
                                                        let _e2655 = ((_e2635 - _e118) * _e1586);
                                                        let _e2656 = ((_e2640 - _e120) * _e1596);
                                                        let _e2657 = ((_e2645 - _e122) * _e1606);
                                                        if (_e2649 < _e2655) {
                                                            phi_3073_ = _e2649;
                                                        } else {
                                                            phi_3073_ = _e2655;
                                                        }
                                                        let _e2660 = phi_3073_;
                                                        if (_e2650 < _e2656) {
                                                            phi_3078_ = _e2650;
                                                        } else {
                                                            phi_3078_ = _e2656;
                                                        }
                                                        let _e2663 = phi_3078_;
                                                        if (_e2651 < _e2657) {
                                                            phi_3083_ = _e2651;
                                                        } else {
                                                            phi_3083_ = _e2657;
                                                        }
                                                        let _e2666 = phi_3083_;
                                                        if (_e2649 > _e2655) {
                                                            phi_3091_ = _e2649;
                                                        } else {
                                                            phi_3091_ = _e2655;
                                                        }
                                                        let _e2672 = phi_3091_;
                                                        if (_e2650 > _e2656) {
                                                            phi_3096_ = _e2650;
                                                        } else {
                                                            phi_3096_ = _e2656;
                                                        }
                                                        let _e2675 = phi_3096_;
                                                        if (_e2651 > _e2657) {
                                                            phi_3101_ = _e2651;
                                                        } else {
                                                            phi_3101_ = _e2657;
                                                        }
                                                        let _e2678 = phi_3101_;
                                                        let _e2682 = core_intrinsics_maximum_number_nsz_f32_((_e2660 - _e1645), (_e2663 - _e1646));
                                                        let _e2683 = core_intrinsics_maximum_number_nsz_f32_(_e2682, (_e2666 - _e1647));
                                                        let _e2684 = core_intrinsics_minimum_number_nsz_f32_((_e2672 + _e1645), (_e2675 + _e1646));
                                                        let _e2685 = core_intrinsics_minimum_number_nsz_f32_(_e2684, (_e2678 + _e1647));
                                                        if (_e2683 > -300000000000000000000000000000000000000f) {
                                                            phi_3113_ = _e2683;
                                                        } else {
                                                            phi_3113_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2688 = phi_3113_;
                                                        if (_e2685 < 300000000000000000000000000000000000000f) {
                                                            phi_3118_ = _e2685;
                                                        } else {
                                                            phi_3118_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2691 = phi_3118_;
                                                        if (_e2559 < _e2688) {
                                                            phi_3123_ = _e2688;
                                                        } else {
                                                            phi_3123_ = _e2559;
                                                        }
                                                        let _e2694 = phi_3123_;
                                                        if (_e2694 > _e2691) {
                                                            phi_3128_ = _e2691;
                                                        } else {
                                                            phi_3128_ = _e2694;
                                                        }
                                                        let _e2697 = phi_3128_;
                                                        phi_3133_ = lt_bvh_triangle_Intersection(_e2697, (_e2400 / _e2459), (_e2421 / _e2459), (_e2688 <= _e2691));
                                                        phi_3134_ = false;
                                                    } else {
                                                        phi_3133_ = lt_bvh_triangle_Intersection();
                                                        phi_3134_ = true;
                                                    }
                                                    let _e2703 = phi_3133_;
                                                    let _e2705 = phi_3134_;
                                                    phi_3135_ = _e2703;
                                                    phi_3136_ = _e2705;
                                                } else {
                                                    phi_3135_ = lt_bvh_triangle_Intersection();
                                                    phi_3136_ = true;
                                                }
                                                let _e2707 = phi_3135_;
                                                let _e2709 = phi_3136_;
                                                if _e2709 {
                                                }
                                                phi_3140_ = _e2707;
                                                phi_3141_ = _e2709;
                                            }
                                            let _e2711 = phi_3140_;
                                            let _e2713 = phi_3141_;
                                            phi_3142_ = _e2711;
                                            phi_3143_ = _e2462;
                                            phi_3144_ = _e2713;
                                        } else {
                                            phi_3142_ = lt_bvh_triangle_Intersection();
                                            phi_3143_ = true;
                                            phi_3144_ = false;
                                        }
                                        let _e2715 = phi_3142_;
                                        let _e2717 = phi_3143_;
                                        let _e2719 = phi_3144_;
                                        if _e2717 {
                                            phi_3148_ = true;
                                        } else {
                                            phi_3148_ = _e2719;
                                        }
                                        let _e2721 = phi_3148_;
                                        if _e2721 {
                                            phi_3152_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3152_ = _e2715;
                                        }
                                        let _e2723 = phi_3152_;
                                        if _e2723.is_hit {
                                            if (_e2723.t > 0f) {
                                                if (_e2723.t < _e130) {
                                                    if true {
                                                        phi_3172_ = false;
                                                    } else {
                                                        phi_3172_ = true;
                                                    }
                                                    let _e2732 = phi_3172_;
                                                    phi_3173_ = true;
                                                    phi_3174_ = _e2732;
                                                } else {
                                                    phi_3173_ = _e2266;
                                                    phi_3174_ = true;
                                                }
                                                let _e2734 = phi_3173_;
                                                let _e2736 = phi_3174_;
                                                phi_3175_ = _e2734;
                                                phi_3176_ = _e2736;
                                            } else {
                                                phi_3175_ = _e2266;
                                                phi_3176_ = true;
                                            }
                                            let _e2738 = phi_3175_;
                                            let _e2740 = phi_3176_;
                                            phi_3177_ = _e2738;
                                            phi_3178_ = _e2740;
                                        } else {
                                            phi_3177_ = _e2266;
                                            phi_3178_ = true;
                                        }
                                        let _e2742 = phi_3177_;
                                        let _e2744 = phi_3178_;
                                        if _e2744 {
                                        }
                                        phi_2582_ = (_e2264 & (_e2264 - 1u));
                                        phi_2585_ = _e2742;
                                        phi_3182_ = _e2744;
                                    }
                                    let _e2746 = phi_2582_;
                                    let _e2748 = phi_2585_;
                                    let _e2750 = phi_3182_;
                                    continue;
                                    continuing {
                                        phi_2581_ = _e2746;
                                        phi_2584_ = _e2748;
                                        break if !(_e2750);
                                    }
                                }
                                let _e2753 = local_9;
                                if _e2753 {
                                    let _e2755 = local.group_mask;
                                    if ((_e2755 & 4278190080u) == 0u) {
                                        let _e2759 = local.len;
                                        if (_e2759 == 0u) {
                                            phi_3224_ = false;
                                        } else {
                                            let _e2763 = local.len;
                                            local.len = (_e2763 - 1u);
                                            let _e2766 = local.len;
                                            if (_e2766 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2771 = local.first[(0u + _e2766)];
                                            local.group = _e2771;
                                            let _e2774 = local.len;
                                            if (_e2774 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2779 = local.mask[(0u + _e2774)];
                                            local.group_mask = _e2779;
                                            phi_3224_ = true;
                                        }
                                        let _e2782 = phi_3224_;
                                        phi_3225_ = _e2782;
                                    } else {
                                        phi_3225_ = true;
                                    }
                                    let _e2784 = phi_3225_;
                                    if _e2784 {
                                        let _e2786 = local.group_mask;
                                        let _e2792 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2786)), 32u, (_e2786 == 0u)));
                                        let _e2796 = local.group_mask;
                                        let _e2810 = local.group_mask;
                                        local.group_mask = (_e2810 & ~((1u << bitcast<u32>((_e2792 & 31u)))));
                                        let _e2813 = local.group;
                                        phi_3256_ = (_e2813 + countOneBits(((_e2796 & ~((4294967295u << bitcast<u32>((((_e2792 - 24u) ^ _e1688) & 31u))))) & 255u)));
                                    } else {
                                        phi_3256_ = 4294967295u;
                                    }
                                    let _e2816 = phi_3256_;
                                    phi_3257_ = _e2816;
                                } else {
                                    phi_3257_ = u32();
                                }
                                let _e2818 = phi_3257_;
                                phi_2250_ = _e2818;
                                let _e3268 = local_19;
                                phi_2253_ = _e3268;
                                let _e3271 = local_20;
                                phi_3258_ = _e3271;
                                phi_3259_ = false;
                            } else {
                                phi_2250_ = u32();
                                phi_2253_ = bool();
                                phi_3258_ = false;
                                phi_3259_ = true;
                            }
                            let _e2820 = phi_2250_;
                            let _e2822 = phi_2253_;
                            let _e2824 = phi_3258_;
                            let _e2826 = phi_3259_;
                            local_10 = _e2826;
                            continue;
                            continuing {
                                phi_2249_ = _e2820;
                                phi_2252_ = _e2822;
                                break if !(_e2824);
                            }
                        }
                        let _e2829 = local_10;
                        if _e2829 {
                            phi_3263_ = false;
                        } else {
                            phi_3263_ = true;
                        }
                        let _e2831 = phi_3263_;
                        if _e2831 {
                            phi_3267_ = true;
                        } else {
                            let _e3277 = local_21;
                            phi_3267_ = _e3277;
                        }
                        let _e2833 = phi_3267_;
                        phi_3268_ = _e2833;
                    }
                    let _e2835 = phi_3268_;
                    phi_3269_ = _e2835;
                    phi_3270_ = _e1510;
                } else {
                    phi_3269_ = bool();
                    phi_3270_ = true;
                }
                let _e2837 = phi_3269_;
                let _e2839 = phi_3270_;
                if _e2839 {
                    phi_3274_ = false;
                } else {
                    phi_3274_ = _e2837;
                }
                let _e2841 = phi_3274_;
                phi_3275_ = _e2841;
            }
            let _e2843 = phi_3275_;
            phi_3276_ = _e2843;
        } else {
            phi_3276_ = false;
        }
        let _e2845 = phi_3276_;
        if _e2845 {
            phi_3280_ = 0f;
        } else {
            phi_3280_ = 1f;
        }
        let _e2847 = phi_3280_;
        if (_e97 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e97)] = _e2847;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
