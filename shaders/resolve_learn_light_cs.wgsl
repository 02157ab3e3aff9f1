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
    var phi_296_: f32;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_356_: bool;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_371_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_383_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_415_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_434_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_461_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_490_: u32;
    var phi_491_: f32;
    var phi_492_: u32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_509_: u32;
    var phi_519_: u32;
    var phi_525_: u32;
    var phi_526_: u32;
    var phi_527_: u32;
    var phi_538_: vec3<f32>;
    var phi_539_: vec3<f32>;
    var phi_561_: vec3<f32>;
    var phi_562_: vec3<f32>;
    var phi_584_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_659_: f32;
    var phi_666_: f32;
    var phi_673_: f32;
    var phi_680_: f32;
    var phi_687_: f32;
    var phi_694_: f32;
    var phi_711_: f32;
    var phi_716_: f32;
    var phi_721_: f32;
    var phi_726_: f32;
    var phi_731_: f32;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_762_: u32;
    var phi_763_: u32;
    var phi_774_: vec3<f32>;
    var phi_775_: vec3<f32>;
    var phi_787_: u32;
    var phi_790_: u32;
    var phi_795_: u32;
    var phi_797_: u32;
    var phi_799_: u32;
    var phi_801_: u32;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_888_: u32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_926_: u32;
    var phi_948_: f32;
    var phi_949_: f32;
    var phi_963_: u32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_1001_: u32;
    var phi_1193_: u32;
    var phi_1194_: u32;
    var phi_1199_: u32;
    var phi_1200_: u32;
    var phi_1201_: u32;
    var phi_798_: u32;
    var phi_800_: u32;
    var phi_1202_: u32;
    var phi_1220_: u32;
    var phi_1221_: u32;
    var phi_788_: u32;
    var phi_791_: u32;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var local_2: bool;
    var local_3: u32;
    var phi_1241_: u32;
    var local_4: u32;
    var phi_1276_: u32;
    var phi_1277_: u32;
    var phi_1283_: u32;
    var phi_1311_: vec3<f32>;
    var phi_1312_: vec3<f32>;
    var phi_1341_: vec3<f32>;
    var phi_1342_: vec3<f32>;
    var phi_1371_: vec3<f32>;
    var phi_1372_: vec3<f32>;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1395_: f32;
    var phi_1396_: f32;
    var phi_1397_: f32;
    var phi_1398_: f32;
    var phi_1406_: f32;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1421_: f32;
    var phi_1422_: f32;
    var phi_1423_: f32;
    var phi_1424_: f32;
    var phi_1432_: f32;
    var phi_1442_: bool;
    var phi_1443_: bool;
    var phi_1447_: f32;
    var phi_1448_: f32;
    var phi_1449_: f32;
    var phi_1450_: f32;
    var phi_1458_: f32;
    var phi_1473_: f32;
    var phi_1474_: bool;
    var phi_1475_: f32;
    var phi_1476_: bool;
    var phi_1477_: f32;
    var phi_1478_: bool;
    var phi_1496_: f32;
    var phi_1497_: bool;
    var phi_1498_: bool;
    var phi_1499_: f32;
    var phi_1500_: bool;
    var phi_1501_: bool;
    var phi_1505_: bool;
    var phi_1506_: f32;
    var phi_1507_: bool;
    var phi_1535_: vec3<f32>;
    var phi_1536_: vec3<f32>;
    var phi_1561_: vec3<f32>;
    var phi_1562_: vec3<f32>;
    var phi_1587_: vec3<f32>;
    var phi_1588_: vec3<f32>;
    var phi_1644_: f32;
    var phi_1653_: f32;
    var phi_1662_: f32;
    var phi_1671_: f32;
    var phi_1678_: f32;
    var phi_1685_: f32;
    var phi_1698_: f32;
    var phi_1707_: f32;
    var phi_1716_: f32;
    var phi_1725_: f32;
    var phi_1732_: f32;
    var phi_1739_: f32;
    var phi_1756_: f32;
    var phi_1761_: f32;
    var phi_1766_: f32;
    var phi_1774_: f32;
    var phi_1779_: f32;
    var phi_1784_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1806_: f32;
    var phi_1811_: f32;
    var phi_1816_: lt_bvh_triangle_Intersection;
    var phi_1817_: bool;
    var phi_1818_: lt_bvh_triangle_Intersection;
    var phi_1819_: bool;
    var phi_1823_: lt_bvh_triangle_Intersection;
    var phi_1824_: bool;
    var phi_1825_: lt_bvh_triangle_Intersection;
    var phi_1826_: bool;
    var phi_1827_: bool;
    var phi_1831_: bool;
    var phi_1835_: lt_bvh_triangle_Intersection;
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
    var phi_1873_: bool;
    var phi_1877_: bool;
    var phi_1878_: bool;
    var phi_1879_: bool;
    var phi_1887_: bool;
    var phi_1888_: bool;
    var phi_1889_: bool;
    var phi_1890_: bool;
    var phi_1891_: bool;
    var local_5: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var phi_1897_: bool;
    var phi_1898_: bool;
    var phi_1899_: bool;
    var local_6: u32;
    var phi_1907_: bool;
    var phi_1908_: bool;
    var phi_1909_: bool;
    var phi_1910_: bool;
    var local_7: bool;
    var phi_1914_: bool;
    var phi_1918_: bool;
    var phi_1922_: bool;
    var phi_1923_: bool;
    var phi_1939_: bool;
    var phi_1940_: bool;
    var phi_1941_: bool;
    var phi_1942_: bool;
    var phi_1946_: bool;
    var phi_1959_: bool;
    var phi_1960_: bool;
    var phi_1961_: bool;
    var phi_1962_: bool;
    var phi_1966_: bool;
    var phi_1979_: bool;
    var phi_1980_: bool;
    var phi_1981_: bool;
    var phi_1985_: bool;
    var phi_1986_: bool;
    var phi_1987_: bool;
    var phi_1988_: bool;
    var phi_1989_: bool;
    var phi_1993_: bool;
    var phi_2063_: f32;
    var phi_2070_: f32;
    var phi_2077_: f32;
    var phi_2084_: f32;
    var phi_2091_: f32;
    var phi_2098_: f32;
    var phi_2115_: f32;
    var phi_2120_: f32;
    var phi_2125_: f32;
    var phi_2130_: f32;
    var phi_2135_: f32;
    var phi_2161_: bool;
    var phi_2162_: bool;
    var phi_2170_: u32;
    var phi_2171_: u32;
    var phi_2182_: vec3<f32>;
    var phi_2183_: vec3<f32>;
    var phi_2196_: u32;
    var phi_2201_: u32;
    var phi_2206_: u32;
    var phi_2320_: bool;
    var phi_2321_: bool;
    var phi_2352_: u32;
    var phi_2354_: u32;
    var phi_2357_: bool;
    var phi_2437_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2464_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2491_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2497_: u32;
    var phi_2500_: u32;
    var phi_2514_: u32;
    var phi_2524_: u32;
    var phi_2534_: u32;
    var phi_2552_: u32;
    var phi_2562_: u32;
    var phi_2572_: u32;
    var phi_2608_: u32;
    var phi_2621_: u32;
    var phi_2626_: u32;
    var phi_2627_: u32;
    var phi_2628_: u32;
    var phi_2498_: u32;
    var phi_2501_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_2686_: u32;
    var phi_2689_: bool;
    var phi_2733_: vec3<f32>;
    var phi_2734_: vec3<f32>;
    var phi_2763_: vec3<f32>;
    var phi_2764_: vec3<f32>;
    var phi_2793_: vec3<f32>;
    var phi_2794_: vec3<f32>;
    var phi_2812_: bool;
    var phi_2813_: bool;
    var phi_2817_: f32;
    var phi_2818_: f32;
    var phi_2819_: f32;
    var phi_2820_: f32;
    var phi_2828_: f32;
    var phi_2838_: bool;
    var phi_2839_: bool;
    var phi_2843_: f32;
    var phi_2844_: f32;
    var phi_2845_: f32;
    var phi_2846_: f32;
    var phi_2854_: f32;
    var phi_2864_: bool;
    var phi_2865_: bool;
    var phi_2869_: f32;
    var phi_2870_: f32;
    var phi_2871_: f32;
    var phi_2872_: f32;
    var phi_2880_: f32;
    var phi_2895_: f32;
    var phi_2896_: bool;
    var phi_2897_: f32;
    var phi_2898_: bool;
    var phi_2899_: f32;
    var phi_2900_: bool;
    var phi_2918_: f32;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2921_: f32;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2927_: bool;
    var phi_2928_: f32;
    var phi_2929_: bool;
    var phi_2957_: vec3<f32>;
    var phi_2958_: vec3<f32>;
    var phi_2983_: vec3<f32>;
    var phi_2984_: vec3<f32>;
    var phi_3009_: vec3<f32>;
    var phi_3010_: vec3<f32>;
    var phi_3066_: f32;
    var phi_3075_: f32;
    var phi_3084_: f32;
    var phi_3093_: f32;
    var phi_3100_: f32;
    var phi_3107_: f32;
    var phi_3120_: f32;
    var phi_3129_: f32;
    var phi_3138_: f32;
    var phi_3147_: f32;
    var phi_3154_: f32;
    var phi_3161_: f32;
    var phi_3178_: f32;
    var phi_3183_: f32;
    var phi_3188_: f32;
    var phi_3196_: f32;
    var phi_3201_: f32;
    var phi_3206_: f32;
    var phi_3218_: f32;
    var phi_3223_: f32;
    var phi_3228_: f32;
    var phi_3233_: f32;
    var phi_3238_: lt_bvh_triangle_Intersection;
    var phi_3239_: bool;
    var phi_3240_: lt_bvh_triangle_Intersection;
    var phi_3241_: bool;
    var phi_3245_: lt_bvh_triangle_Intersection;
    var phi_3246_: bool;
    var phi_3247_: lt_bvh_triangle_Intersection;
    var phi_3248_: bool;
    var phi_3249_: bool;
    var phi_3253_: bool;
    var phi_3257_: lt_bvh_triangle_Intersection;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3280_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_2687_: u32;
    var phi_2690_: bool;
    var phi_3287_: bool;
    var local_11: bool;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3361_: u32;
    var phi_3362_: u32;
    var phi_2355_: u32;
    var phi_2358_: bool;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var local_12: bool;
    var phi_3368_: bool;
    var phi_3372_: bool;
    var phi_3373_: bool;
    var phi_3374_: bool;
    var phi_3375_: bool;
    var phi_3379_: bool;
    var phi_3380_: bool;
    var phi_3381_: bool;
    var phi_3385_: f32;
    var phi_3426_: u32;
    var phi_3445_: u32;
    var phi_3453_: u32;
    var phi_3461_: u32;
    var phi_3466_: u32;
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
        let _e106 = (_e105 & 2147483647u);
        let _e107 = space.member;
        if (_e106 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e113 = samples.member[(0u + _e106)].position;
        let _e115 = samples.member[(0u + _e106)].normal;
        let _e117 = samples.member[(0u + _e106)].magnitude;
        let _e119 = ((8f / 8388608f) * _e117);
        let _e121 = (_e115.x * _e119);
        let _e123 = (_e115.y * _e119);
        let _e125 = (_e115.z * _e119);
        let _e127 = (_e113.x + _e121);
        let _e129 = (_e113.y + _e123);
        let _e131 = (_e113.z + _e125);
        let _e135 = p.member.light.place;
        if (_e135.w == 0f) {
            phi_296_ = 300000000000000000000000000000000000000f;
        } else {
            phi_296_ = 1f;
        }
        let _e139 = phi_296_;
        let _e147 = (_e135.x - (_e127 * _e135.w));
        let _e148 = (_e135.y - (_e129 * _e135.w));
        let _e149 = (_e135.z - (_e131 * _e135.w));
        let _e150 = vec3<f32>(_e147, _e148, _e149);
        let _e151 = abs(_e147);
        let _e152 = abs(_e148);
        let _e153 = abs(_e149);
        if (abs(_e127) < 1000000000000000f) {
            if (abs(_e129) < 1000000000000000f) {
                phi_329_ = (abs(_e131) < 1000000000000000f);
                phi_330_ = false;
            } else {
                phi_329_ = bool();
                phi_330_ = true;
            }
            let _e161 = phi_329_;
            let _e163 = phi_330_;
            phi_331_ = _e161;
            phi_332_ = _e163;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
        }
        let _e165 = phi_331_;
        let _e167 = phi_332_;
        if _e167 {
            phi_336_ = false;
        } else {
            phi_336_ = _e165;
        }
        let _e169 = phi_336_;
        if _e169 {
            if (_e151 < 1000000000000000f) {
                if (_e152 < 1000000000000000f) {
                    phi_349_ = (_e153 < 1000000000000000f);
                    phi_350_ = false;
                } else {
                    phi_349_ = bool();
                    phi_350_ = true;
                }
                let _e174 = phi_349_;
                let _e176 = phi_350_;
                phi_351_ = _e174;
                phi_352_ = _e176;
            } else {
                phi_351_ = bool();
                phi_352_ = true;
            }
            let _e178 = phi_351_;
            let _e180 = phi_352_;
            if _e180 {
                phi_356_ = false;
            } else {
                phi_356_ = _e178;
            }
            let _e182 = phi_356_;
            if _e182 {
                if (_e151 > 0f) {
                    phi_370_ = bool();
                    phi_371_ = true;
                } else {
                    let _e184 = (_e152 > 0f);
                    if _e184 {
                        phi_369_ = bool();
                    } else {
                        phi_369_ = (_e153 > 0f);
                    }
                    let _e187 = phi_369_;
                    phi_370_ = _e187;
                    phi_371_ = _e184;
                }
                let _e189 = phi_370_;
                let _e191 = phi_371_;
                if _e191 {
                    phi_375_ = true;
                } else {
                    phi_375_ = _e189;
                }
                let _e193 = phi_375_;
                phi_376_ = _e193;
                phi_377_ = false;
            } else {
                phi_376_ = bool();
                phi_377_ = true;
            }
            let _e195 = phi_376_;
            let _e197 = phi_377_;
            phi_378_ = _e195;
            phi_379_ = _e197;
        } else {
            phi_378_ = bool();
            phi_379_ = true;
        }
        let _e199 = phi_378_;
        let _e201 = phi_379_;
        if _e201 {
            phi_383_ = false;
        } else {
            phi_383_ = _e199;
        }
        let _e203 = phi_383_;
        if _e203 {
            if (_e107.low.x <= _e127) {
                if (_e127 <= _e107.high.x) {
                    if (_e107.low.y <= _e129) {
                        phi_406_ = (_e129 <= _e107.high.y);
                        phi_407_ = false;
                    } else {
                        phi_406_ = bool();
                        phi_407_ = true;
                    }
                    let _e221 = phi_406_;
                    let _e223 = phi_407_;
                    phi_408_ = _e221;
                    phi_409_ = _e223;
                } else {
                    phi_408_ = bool();
                    phi_409_ = true;
                }
                let _e225 = phi_408_;
                let _e227 = phi_409_;
                phi_410_ = _e225;
                phi_411_ = _e227;
            } else {
                phi_410_ = bool();
                phi_411_ = true;
            }
            let _e229 = phi_410_;
            let _e231 = phi_411_;
            if _e231 {
                phi_415_ = false;
            } else {
                phi_415_ = _e229;
            }
            let _e233 = phi_415_;
            if (abs(_e147) > 0.000000000000000000000000000001f) {
                phi_429_ = bool();
                phi_430_ = true;
            } else {
                let _e238 = (abs(_e148) > 0.000000000000000000000000000001f);
                if _e238 {
                    phi_428_ = bool();
                } else {
                    phi_428_ = (abs(_e149) > 0.000000000000000000000000000001f);
                }
                let _e241 = phi_428_;
                phi_429_ = _e241;
                phi_430_ = _e238;
            }
            let _e243 = phi_429_;
            let _e245 = phi_430_;
            if _e245 {
                phi_434_ = true;
            } else {
                phi_434_ = _e243;
            }
            let _e247 = phi_434_;
            if _e233 {
                if (_e107.low.z <= _e131) {
                    if (_e131 <= _e107.high.z) {
                        if (_e107.is_parallel == 0u) {
                            phi_451_ = _e247;
                        } else {
                            phi_451_ = true;
                        }
                        let _e253 = phi_451_;
                        phi_452_ = _e253;
                        phi_453_ = false;
                    } else {
                        phi_452_ = bool();
                        phi_453_ = true;
                    }
                    let _e255 = phi_452_;
                    let _e257 = phi_453_;
                    phi_454_ = _e255;
                    phi_455_ = _e257;
                } else {
                    phi_454_ = bool();
                    phi_455_ = true;
                }
                let _e259 = phi_454_;
                let _e261 = phi_455_;
                phi_456_ = _e259;
                phi_457_ = _e261;
            } else {
                phi_456_ = bool();
                phi_457_ = true;
            }
            let _e263 = phi_456_;
            let _e265 = phi_457_;
            if _e265 {
                phi_461_ = false;
            } else {
                phi_461_ = _e263;
            }
            let _e267 = phi_461_;
            if _e267 {
                if (_e107.is_parallel == 0u) {
                    let _e270 = abs(_e147);
                    let _e271 = abs(_e148);
                    let _e272 = abs(_e149);
                    if (_e270 >= _e271) {
                        if (_e270 >= _e272) {
                            phi_481_ = false;
                        } else {
                            phi_481_ = true;
                        }
                        let _e276 = phi_481_;
                        phi_482_ = _e276;
                    } else {
                        phi_482_ = true;
                    }
                    let _e278 = phi_482_;
                    if _e278 {
                        if (_e271 >= _e272) {
                            phi_490_ = 1u;
                            phi_491_ = _e148;
                        } else {
                            phi_490_ = 2u;
                            phi_491_ = _e149;
                        }
                        let _e281 = phi_490_;
                        let _e283 = phi_491_;
                        phi_492_ = _e281;
                        phi_493_ = _e283;
                    } else {
                        phi_492_ = 0u;
                        phi_493_ = _e147;
                    }
                    let _e285 = phi_492_;
                    let _e287 = phi_493_;
                    if (_e287 < 0f) {
                        phi_498_ = -1f;
                    } else {
                        phi_498_ = 1f;
                    }
                    let _e290 = phi_498_;
                    let _e291 = (_e290 < 0f);
                    if (_e285 == 0u) {
                        if _e291 {
                            phi_509_ = _e107.roots.y;
                        } else {
                            phi_509_ = _e107.roots.x;
                        }
                        let _e298 = phi_509_;
                        phi_527_ = _e298;
                    } else {
                        if (_e285 == 1u) {
                            if _e291 {
                                phi_519_ = _e107.roots.w;
                            } else {
                                phi_519_ = _e107.roots.z;
                            }
                            let _e305 = phi_519_;
                            phi_526_ = _e305;
                        } else {
                            if _e291 {
                                phi_525_ = _e107.roots_z.y;
                            } else {
                                phi_525_ = _e107.roots_z.x;
                            }
                            let _e311 = phi_525_;
                            phi_526_ = _e311;
                        }
                        let _e313 = phi_526_;
                        phi_527_ = _e313;
                    }
                    let _e315 = phi_527_;
                    if (_e285 == 0u) {
                        phi_539_ = vec3<f32>(_e148, _e149, _e147);
                    } else {
                        if (_e285 == 1u) {
                            phi_538_ = vec3<f32>(_e149, _e147, _e148);
                        } else {
                            phi_538_ = _e150;
                        }
                        let _e321 = phi_538_;
                        phi_539_ = _e321;
                    }
                    let _e323 = phi_539_;
                    phi_584_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e323.x / _e323.z), (_e323.y / _e323.z), (_e290 / _e323.z)), _e315);
                } else {
                    if (_e107.axis == 0u) {
                        phi_562_ = vec3<f32>(_e129, _e131, _e127);
                    } else {
                        if (_e107.axis == 1u) {
                            phi_561_ = vec3<f32>(_e131, _e127, _e129);
                        } else {
                            phi_561_ = (_e113 + vec3<f32>(_e121, _e123, _e125));
                        }
                        let _e340 = phi_561_;
                        phi_562_ = _e340;
                    }
                    let _e342 = phi_562_;
                    let _e357 = (_e342.z - _e107.middle.z);
                    phi_584_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e342.x - _e107.middle.x) - (_e107.shear.x * _e357)), ((_e342.y - _e107.middle.y) - (_e107.shear.y * _e357)), (_e107.sign * _e357)), _e107.roots.x);
                }
                let _e368 = phi_584_;
                if (_e368.unnamed_1 == 4294967295u) {
                    phi_1923_ = false;
                } else {
                    if (0u < _e76) {
                    } else {
                        return;
                    }
                    let _e385 = nodes.member[0u].frame[0u];
                    let _e389 = nodes.member[0u].frame[1u];
                    let _e393 = nodes.member[0u].frame[2u];
                    let _e397 = nodes.member[0u].frame[0u];
                    let _e401 = nodes.member[0u].frame[1u];
                    let _e405 = nodes.member[0u].frame[2u];
                    let _e409 = nodes.member[0u].frame[3u];
                    let _e443 = core_intrinsics_maximum_number_nsz_f32_(abs(_e147), abs(_e148));
                    let _e444 = core_intrinsics_maximum_number_nsz_f32_(_e443, abs(_e149));
                    let _e445 = (_e444 * 0.0000000000009094947f);
                    if (abs(_e147) < _e445) {
                        phi_659_ = _e445;
                    } else {
                        phi_659_ = abs(_e147);
                    }
                    let _e450 = phi_659_;
                    if (_e147 < 0f) {
                        phi_666_ = (-1f / _e450);
                    } else {
                        phi_666_ = (1f / _e450);
                    }
                    let _e455 = phi_666_;
                    if (abs(_e148) < _e445) {
                        phi_673_ = _e445;
                    } else {
                        phi_673_ = abs(_e148);
                    }
                    let _e460 = phi_673_;
                    if (_e148 < 0f) {
                        phi_680_ = (-1f / _e460);
                    } else {
                        phi_680_ = (1f / _e460);
                    }
                    let _e465 = phi_680_;
                    if (abs(_e149) < _e445) {
                        phi_687_ = _e445;
                    } else {
                        phi_687_ = abs(_e149);
                    }
                    let _e470 = phi_687_;
                    if (_e149 < 0f) {
                        phi_694_ = (-1f / _e470);
                    } else {
                        phi_694_ = (1f / _e470);
                    }
                    let _e475 = phi_694_;
                    let _e479 = abs((bitcast<f32>(_e385) - _e127));
                    let _e480 = abs((bitcast<f32>(_e389) - _e129));
                    let _e481 = abs((bitcast<f32>(_e393) - _e131));
                    let _e485 = abs(((bitcast<f32>(_e397) + (bitcast<f32>((((_e409 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e127));
                    let _e486 = abs(((bitcast<f32>(_e401) + (bitcast<f32>((((_e409 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e129));
                    let _e487 = abs(((bitcast<f32>(_e405) + (bitcast<f32>((((_e409 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                    if (_e479 > _e485) {
                        phi_711_ = _e479;
                    } else {
                        phi_711_ = _e485;
                    }
                    let _e490 = phi_711_;
                    if (_e480 > _e486) {
                        phi_716_ = _e480;
                    } else {
                        phi_716_ = _e486;
                    }
                    let _e493 = phi_716_;
                    if (_e481 > _e487) {
                        phi_721_ = _e481;
                    } else {
                        phi_721_ = _e487;
                    }
                    let _e496 = phi_721_;
                    if (_e490 > _e493) {
                        phi_726_ = _e490;
                    } else {
                        phi_726_ = _e493;
                    }
                    let _e499 = phi_726_;
                    if (_e499 > _e496) {
                        phi_731_ = _e499;
                    } else {
                        phi_731_ = _e496;
                    }
                    let _e502 = phi_731_;
                    let _e509 = (_e502 * 0.0000009536743f);
                    let _e510 = (abs(_e455) * _e509);
                    let _e511 = (abs(_e465) * _e509);
                    let _e512 = (abs(_e475) * _e509);
                    let _e513 = abs(_e147);
                    let _e514 = abs(_e148);
                    let _e515 = abs(_e149);
                    if (_e513 >= _e514) {
                        if (_e513 >= _e515) {
                            phi_753_ = false;
                        } else {
                            phi_753_ = true;
                        }
                        let _e519 = phi_753_;
                        phi_754_ = _e519;
                    } else {
                        phi_754_ = true;
                    }
                    let _e521 = phi_754_;
                    if _e521 {
                        if (_e514 >= _e515) {
                            phi_762_ = 1u;
                        } else {
                            phi_762_ = 2u;
                        }
                        let _e524 = phi_762_;
                        phi_763_ = _e524;
                    } else {
                        phi_763_ = 0u;
                    }
                    let _e526 = phi_763_;
                    if (_e526 == 0u) {
                        phi_775_ = vec3<f32>(_e148, _e149, _e147);
                    } else {
                        if (_e526 == 1u) {
                            phi_774_ = vec3<f32>(_e149, _e147, _e148);
                        } else {
                            phi_774_ = _e150;
                        }
                        let _e532 = phi_774_;
                        phi_775_ = _e532;
                    }
                    let _e534 = phi_775_;
                    let _e537 = (_e534.x / _e534.z);
                    let _e540 = (_e534.y / _e534.z);
                    local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_787_ = ((_e368.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_790_ = 0u;
                    loop {
                        let _e547 = phi_787_;
                        let _e549 = phi_790_;
                        phi_795_ = _e547;
                        phi_797_ = 0u;
                        phi_799_ = 0u;
                        phi_801_ = _e549;
                        loop {
                            let _e551 = phi_795_;
                            let _e553 = phi_797_;
                            let _e555 = phi_799_;
                            let _e557 = phi_801_;
                            let _e564 = (((_e551 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e551), 32u, (_e551 == 0u))) * 5u);
                            if (_e564 < _e91) {
                            } else {
                                return;
                            }
                            let _e568 = rows.member[(0u + _e564)];
                            let _e569 = (_e564 + 1u);
                            if (_e569 < _e91) {
                            } else {
                                return;
                            }
                            let _e573 = rows.member[(0u + _e569)];
                            let _e574 = (_e564 + 2u);
                            if (_e574 < _e91) {
                            } else {
                                return;
                            }
                            let _e578 = rows.member[(0u + _e574)];
                            let _e579 = (_e564 + 3u);
                            if (_e579 < _e91) {
                            } else {
                                return;
                            }
                            let _e583 = rows.member[(0u + _e579)];
                            let _e584 = (_e564 + 4u);
                            if (_e584 < _e91) {
                            } else {
                                return;
                            }
                            let _e588 = rows.member[(0u + _e584)];
                            let _e589 = lt_bvh_Node(_e568, _e573, _e578, _e583, _e588);
                            let _e591 = (_e551 & (_e551 - 1u));
                            let _e603 = (_e368.unnamed.positive_exponent - bitcast<f32>(_e589.frame.x));
                            let _e606 = bitcast<f32>((((_e589.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e603 > 0f) {
                                if (_e603 < (255f * _e606)) {
                                    phi_873_ = (_e603 / _e606);
                                } else {
                                    phi_873_ = 255f;
                                }
                                let _e612 = phi_873_;
                                phi_874_ = _e612;
                            } else {
                                phi_874_ = 0f;
                            }
                            let _e614 = phi_874_;
                            let _e621 = select(select(u32(_e614), 0u, (_e614 < bitcast<f32>(0u))), 4294967295u, (_e614 > bitcast<f32>(1333788671u)));
                            if (f32(_e621) < _e614) {
                                phi_888_ = (_e621 + 1u);
                            } else {
                                phi_888_ = _e621;
                            }
                            let _e626 = phi_888_;
                            let _e627 = (_e621 * 16843009u);
                            let _e628 = (_e626 * 16843009u);
                            let _e638 = (_e368.unnamed.negative_exponent - bitcast<f32>(_e589.frame.y));
                            let _e641 = bitcast<f32>((((_e589.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e638 > 0f) {
                                if (_e638 < (255f * _e641)) {
                                    phi_911_ = (_e638 / _e641);
                                } else {
                                    phi_911_ = 255f;
                                }
                                let _e647 = phi_911_;
                                phi_912_ = _e647;
                            } else {
                                phi_912_ = 0f;
                            }
                            let _e649 = phi_912_;
                            let _e656 = select(select(u32(_e649), 0u, (_e649 < bitcast<f32>(0u))), 4294967295u, (_e649 > bitcast<f32>(1333788671u)));
                            if (f32(_e656) < _e649) {
                                phi_926_ = (_e656 + 1u);
                            } else {
                                phi_926_ = _e656;
                            }
                            let _e661 = phi_926_;
                            let _e662 = (_e656 * 16843009u);
                            let _e663 = (_e661 * 16843009u);
                            let _e672 = (((_e107.diagonal.x * _e368.unnamed.positive_exponent) + (_e107.diagonal.y * _e368.unnamed.negative_exponent)) - bitcast<f32>(_e589.frame.z));
                            let _e675 = bitcast<f32>((((_e589.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e672 > 0f) {
                                if (_e672 < (255f * _e675)) {
                                    phi_948_ = (_e672 / _e675);
                                } else {
                                    phi_948_ = 255f;
                                }
                                let _e681 = phi_948_;
                                phi_949_ = _e681;
                            } else {
                                phi_949_ = 0f;
                            }
                            let _e683 = phi_949_;
                            let _e690 = select(select(u32(_e683), 0u, (_e683 < bitcast<f32>(0u))), 4294967295u, (_e683 > bitcast<f32>(1333788671u)));
                            if (f32(_e690) < _e683) {
                                phi_963_ = (_e690 + 1u);
                            } else {
                                phi_963_ = _e690;
                            }
                            let _e695 = phi_963_;
                            let _e696 = (_e690 * 16843009u);
                            let _e697 = (_e695 * 16843009u);
                            let _e707 = (_e368.unnamed.min_variance - bitcast<f32>(_e589.frame.w));
                            let _e710 = bitcast<f32>((((_e589.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e707 > 0f) {
                                if (_e707 < (255f * _e710)) {
                                    phi_986_ = (_e707 / _e710);
                                } else {
                                    phi_986_ = 255f;
                                }
                                let _e716 = phi_986_;
                                phi_987_ = _e716;
                            } else {
                                phi_987_ = 0f;
                            }
                            let _e718 = phi_987_;
                            let _e725 = select(select(u32(_e718), 0u, (_e718 < bitcast<f32>(0u))), 4294967295u, (_e718 > bitcast<f32>(1333788671u)));
                            if (f32(_e725) < _e718) {
                                phi_1001_ = (_e725 + 1u);
                            } else {
                                phi_1001_ = _e725;
                            }
                            let _e730 = phi_1001_;
                            let _e731 = (_e730 * 16843009u);
                            let _e912 = (((((((((((_e627 & ~(_e589.links.x)) | (~((_e589.links.x ^ _e627)) & ((_e627 | 2155905152u) - (_e589.links.x & 2139062143u)))) & ((_e589.links.z & ~(_e628)) | (~((_e628 ^ _e589.links.z)) & ((_e589.links.z | 2155905152u) - (_e628 & 2139062143u))))) & (((_e662 & ~(_e589.x.x)) | (~((_e589.x.x ^ _e662)) & ((_e662 | 2155905152u) - (_e589.x.x & 2139062143u)))) & ((_e589.x.z & ~(_e663)) | (~((_e663 ^ _e589.x.z)) & ((_e589.x.z | 2155905152u) - (_e663 & 2139062143u)))))) & (((_e696 & ~(_e589.y.x)) | (~((_e589.y.x ^ _e696)) & ((_e696 | 2155905152u) - (_e589.y.x & 2139062143u)))) & ((_e589.y.z & ~(_e697)) | (~((_e697 ^ _e589.y.z)) & ((_e589.y.z | 2155905152u) - (_e697 & 2139062143u)))))) & ((_e589.z.x & ~(_e731)) | (~((_e731 ^ _e589.z.x)) & ((_e589.z.x | 2155905152u) - (_e731 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e627 & ~(_e589.links.y)) | (~((_e589.links.y ^ _e627)) & ((_e627 | 2155905152u) - (_e589.links.y & 2139062143u)))) & ((_e589.links.w & ~(_e628)) | (~((_e628 ^ _e589.links.w)) & ((_e589.links.w | 2155905152u) - (_e628 & 2139062143u))))) & (((_e662 & ~(_e589.x.y)) | (~((_e589.x.y ^ _e662)) & ((_e662 | 2155905152u) - (_e589.x.y & 2139062143u)))) & ((_e589.x.w & ~(_e663)) | (~((_e663 ^ _e589.x.w)) & ((_e589.x.w | 2155905152u) - (_e663 & 2139062143u)))))) & (((_e696 & ~(_e589.y.y)) | (~((_e589.y.y ^ _e696)) & ((_e696 | 2155905152u) - (_e589.y.y & 2139062143u)))) & ((_e589.y.w & ~(_e697)) | (~((_e697 ^ _e589.y.w)) & ((_e589.y.w | 2155905152u) - (_e697 & 2139062143u)))))) & ((_e589.z.y & ~(_e731)) | (~((_e731 ^ _e589.z.y)) & ((_e589.z.y | 2155905152u) - (_e731 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e589.z.w & 2147483648u) != 0u) {
                                phi_1201_ = _e591;
                                phi_798_ = (_e589.z.w & 2147483647u);
                                phi_800_ = _e912;
                                phi_1202_ = _e557;
                            } else {
                                if (_e912 == 0u) {
                                    phi_1199_ = _e591;
                                    phi_1200_ = _e557;
                                } else {
                                    if ((_e591 & 255u) == 0u) {
                                        phi_1194_ = _e557;
                                    } else {
                                        if (_e557 < 32u) {
                                            if (_e557 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1[(0u + _e557)] = _e591;
                                            phi_1193_ = (_e557 + 1u);
                                        } else {
                                            phi_1193_ = _e557;
                                        }
                                        let _e929 = phi_1193_;
                                        phi_1194_ = _e929;
                                    }
                                    let _e931 = phi_1194_;
                                    phi_1199_ = (((_e589.z.w & 2147483647u) << bitcast<u32>(8i)) | _e912);
                                    phi_1200_ = _e931;
                                }
                                let _e939 = phi_1199_;
                                let _e941 = phi_1200_;
                                phi_1201_ = _e939;
                                phi_798_ = _e553;
                                phi_800_ = _e555;
                                phi_1202_ = _e941;
                            }
                            let _e943 = phi_1201_;
                            let _e945 = phi_798_;
                            let _e947 = phi_800_;
                            let _e949 = phi_1202_;
                            local_3 = _e947;
                            local_15 = _e947;
                            local_4 = _e945;
                            if ((_e943 & 255u) == 0u) {
                                if (_e949 > 0u) {
                                    let _e953 = (_e949 - 1u);
                                    if (_e953 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e957 = local_1[(0u + _e953)];
                                    phi_1220_ = _e957;
                                    phi_1221_ = _e953;
                                } else {
                                    phi_1220_ = 0u;
                                    phi_1221_ = _e949;
                                }
                                let _e959 = phi_1220_;
                                let _e961 = phi_1221_;
                                phi_788_ = _e959;
                                phi_791_ = _e961;
                            } else {
                                phi_788_ = _e943;
                                phi_791_ = _e949;
                            }
                            let _e963 = phi_788_;
                            let _e965 = phi_791_;
                            local_13 = _e963;
                            local_14 = _e965;
                            local_6 = _e963;
                            if (_e947 == 0u) {
                                let _e967 = (_e963 == 0u);
                                if _e967 {
                                    phi_1230_ = false;
                                } else {
                                    phi_1230_ = true;
                                }
                                let _e969 = phi_1230_;
                                phi_1231_ = _e969;
                                phi_1232_ = _e967;
                            } else {
                                phi_1231_ = false;
                                phi_1232_ = false;
                            }
                            let _e971 = phi_1231_;
                            let _e973 = phi_1232_;
                            local_2 = _e973;
                            continue;
                            continuing {
                                phi_795_ = _e963;
                                phi_797_ = _e945;
                                phi_799_ = _e947;
                                phi_801_ = _e965;
                                break if !(_e971);
                            }
                        }
                        let _e976 = local_2;
                        if _e976 {
                        }
                        let _e978 = local_3;
                        if (_e978 == 0u) {
                            phi_1897_ = true;
                            phi_1898_ = false;
                            phi_1899_ = false;
                        } else {
                            let _e3152 = local_15;
                            phi_1241_ = _e3152;
                            loop {
                                let _e981 = phi_1241_;
                                let _e984 = select(firstTrailingBit(_e981), 32u, (_e981 == 0u));
                                let _e988 = local_4;
                                let _e989 = (_e988 + (_e984 >> bitcast<u32>(2i)));
                                if (_e989 < _e91) {
                                } else {
                                    return;
                                }
                                let _e994 = rows.member[(0u + _e989)][0u];
                                let _e998 = rows.member[(0u + _e989)][1u];
                                let _e1002 = rows.member[(0u + _e989)][2u];
                                let _e1006 = rows.member[(0u + _e989)][3u];
                                if ((_e984 & 2u) == 0u) {
                                    phi_1276_ = _e998;
                                    phi_1277_ = _e994;
                                } else {
                                    phi_1276_ = _e1006;
                                    phi_1277_ = _e1002;
                                }
                                let _e1010 = phi_1276_;
                                let _e1012 = phi_1277_;
                                if ((_e984 & 1u) == 0u) {
                                    phi_1283_ = _e1012;
                                } else {
                                    phi_1283_ = _e1010;
                                }
                                let _e1016 = phi_1283_;
                                let _e1018 = (_e981 & (_e981 - 1u));
                                if (_e1016 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1023 = triangles.member[(0u + _e1016)].v0_;
                                let _e1025 = (_e1023.x - _e127);
                                let _e1027 = (_e1023.y - _e129);
                                let _e1029 = (_e1023.z - _e131);
                                if (_e526 == 0u) {
                                    phi_1312_ = vec3<f32>(_e1027, _e1029, _e1025);
                                } else {
                                    if (_e526 == 1u) {
                                        phi_1311_ = vec3<f32>(_e1029, _e1025, _e1027);
                                    } else {
                                        phi_1311_ = (_e1023 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1037 = phi_1311_;
                                    phi_1312_ = _e1037;
                                }
                                let _e1039 = phi_1312_;
                                let _e1043 = (_e1039.x - (_e537 * _e1039.z));
                                let _e1047 = (_e1039.y - (_e540 * _e1039.z));
                                let _e1049 = triangles.member[(0u + _e1016)].v1_;
                                let _e1051 = (_e1049.x - _e127);
                                let _e1053 = (_e1049.y - _e129);
                                let _e1055 = (_e1049.z - _e131);
                                if (_e526 == 0u) {
                                    phi_1342_ = vec3<f32>(_e1053, _e1055, _e1051);
                                } else {
                                    if (_e526 == 1u) {
                                        phi_1341_ = vec3<f32>(_e1055, _e1051, _e1053);
                                    } else {
                                        phi_1341_ = (_e1049 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1063 = phi_1341_;
                                    phi_1342_ = _e1063;
                                }
                                let _e1065 = phi_1342_;
                                let _e1069 = (_e1065.x - (_e537 * _e1065.z));
                                let _e1073 = (_e1065.y - (_e540 * _e1065.z));
                                let _e1075 = triangles.member[(0u + _e1016)].v2_;
                                let _e1077 = (_e1075.x - _e127);
                                let _e1079 = (_e1075.y - _e129);
                                let _e1081 = (_e1075.z - _e131);
                                if (_e526 == 0u) {
                                    phi_1372_ = vec3<f32>(_e1079, _e1081, _e1077);
                                } else {
                                    if (_e526 == 1u) {
                                        phi_1371_ = vec3<f32>(_e1081, _e1077, _e1079);
                                    } else {
                                        phi_1371_ = (_e1075 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1089 = phi_1371_;
                                    phi_1372_ = _e1089;
                                }
                                let _e1091 = phi_1372_;
                                let _e1095 = (_e1091.x - (_e537 * _e1091.z));
                                let _e1099 = (_e1091.y - (_e540 * _e1091.z));
                                if (_e1069 < _e1095) {
                                    phi_1391_ = true;
                                } else {
                                    if (_e1069 == _e1095) {
                                        phi_1390_ = (_e1073 < _e1099);
                                    } else {
                                        phi_1390_ = false;
                                    }
                                    let _e1104 = phi_1390_;
                                    phi_1391_ = _e1104;
                                }
                                let _e1106 = phi_1391_;
                                if _e1106 {
                                    phi_1395_ = _e1099;
                                    phi_1396_ = _e1095;
                                    phi_1397_ = _e1073;
                                    phi_1398_ = _e1069;
                                } else {
                                    phi_1395_ = _e1073;
                                    phi_1396_ = _e1069;
                                    phi_1397_ = _e1099;
                                    phi_1398_ = _e1095;
                                }
                                let _e1108 = phi_1395_;
                                let _e1110 = phi_1396_;
                                let _e1112 = phi_1397_;
                                let _e1114 = phi_1398_;
                                let _e1117 = ((_e1114 * _e1108) - (_e1112 * _e1110));
                                if _e1106 {
                                    phi_1406_ = -(_e1117);
                                } else {
                                    phi_1406_ = _e1117;
                                }
                                let _e1120 = phi_1406_;
                                if (_e1095 < _e1043) {
                                    phi_1417_ = true;
                                } else {
                                    if (_e1095 == _e1043) {
                                        phi_1416_ = (_e1099 < _e1047);
                                    } else {
                                        phi_1416_ = false;
                                    }
                                    let _e1125 = phi_1416_;
                                    phi_1417_ = _e1125;
                                }
                                let _e1127 = phi_1417_;
                                if _e1127 {
                                    phi_1421_ = _e1047;
                                    phi_1422_ = _e1043;
                                    phi_1423_ = _e1099;
                                    phi_1424_ = _e1095;
                                } else {
                                    phi_1421_ = _e1099;
                                    phi_1422_ = _e1095;
                                    phi_1423_ = _e1047;
                                    phi_1424_ = _e1043;
                                }
                                let _e1129 = phi_1421_;
                                let _e1131 = phi_1422_;
                                let _e1133 = phi_1423_;
                                let _e1135 = phi_1424_;
                                let _e1138 = ((_e1135 * _e1129) - (_e1133 * _e1131));
                                if _e1127 {
                                    phi_1432_ = -(_e1138);
                                } else {
                                    phi_1432_ = _e1138;
                                }
                                let _e1141 = phi_1432_;
                                if (_e1043 < _e1069) {
                                    phi_1443_ = true;
                                } else {
                                    if (_e1043 == _e1069) {
                                        phi_1442_ = (_e1047 < _e1073);
                                    } else {
                                        phi_1442_ = false;
                                    }
                                    let _e1146 = phi_1442_;
                                    phi_1443_ = _e1146;
                                }
                                let _e1148 = phi_1443_;
                                if _e1148 {
                                    phi_1447_ = _e1073;
                                    phi_1448_ = _e1069;
                                    phi_1449_ = _e1047;
                                    phi_1450_ = _e1043;
                                } else {
                                    phi_1447_ = _e1047;
                                    phi_1448_ = _e1043;
                                    phi_1449_ = _e1073;
                                    phi_1450_ = _e1069;
                                }
                                let _e1150 = phi_1447_;
                                let _e1152 = phi_1448_;
                                let _e1154 = phi_1449_;
                                let _e1156 = phi_1450_;
                                let _e1159 = ((_e1156 * _e1150) - (_e1154 * _e1152));
                                if _e1148 {
                                    phi_1458_ = -(_e1159);
                                } else {
                                    phi_1458_ = _e1159;
                                }
                                let _e1162 = phi_1458_;
                                if (_e1120 >= 0f) {
                                    if (_e1141 >= 0f) {
                                        if (_e1162 >= 0f) {
                                            phi_1473_ = ((_e1120 + _e1141) + _e1162);
                                            phi_1474_ = false;
                                        } else {
                                            phi_1473_ = f32();
                                            phi_1474_ = true;
                                        }
                                        let _e1169 = phi_1473_;
                                        let _e1171 = phi_1474_;
                                        phi_1475_ = _e1169;
                                        phi_1476_ = _e1171;
                                    } else {
                                        phi_1475_ = f32();
                                        phi_1476_ = true;
                                    }
                                    let _e1173 = phi_1475_;
                                    let _e1175 = phi_1476_;
                                    phi_1477_ = _e1173;
                                    phi_1478_ = _e1175;
                                } else {
                                    phi_1477_ = f32();
                                    phi_1478_ = true;
                                }
                                let _e1177 = phi_1477_;
                                let _e1179 = phi_1478_;
                                if _e1179 {
                                    if (_e1120 <= 0f) {
                                        if (_e1141 <= 0f) {
                                            let _e1182 = (_e1162 <= 0f);
                                            if _e1182 {
                                            }
                                            phi_1496_ = ((_e1120 + _e1141) + _e1162);
                                            phi_1497_ = false;
                                            phi_1498_ = _e1182;
                                        } else {
                                            phi_1496_ = f32();
                                            phi_1497_ = true;
                                            phi_1498_ = false;
                                        }
                                        let _e1186 = phi_1496_;
                                        let _e1188 = phi_1497_;
                                        let _e1190 = phi_1498_;
                                        phi_1499_ = _e1186;
                                        phi_1500_ = _e1188;
                                        phi_1501_ = _e1190;
                                    } else {
                                        phi_1499_ = f32();
                                        phi_1500_ = true;
                                        phi_1501_ = false;
                                    }
                                    let _e1192 = phi_1499_;
                                    let _e1194 = phi_1500_;
                                    let _e1196 = phi_1501_;
                                    if _e1194 {
                                        phi_1505_ = false;
                                    } else {
                                        phi_1505_ = _e1196;
                                    }
                                    let _e1198 = phi_1505_;
                                    phi_1506_ = _e1192;
                                    phi_1507_ = _e1198;
                                } else {
                                    phi_1506_ = _e1177;
                                    phi_1507_ = true;
                                }
                                let _e1200 = phi_1506_;
                                let _e1202 = phi_1507_;
                                if _e1202 {
                                    let _e1203 = (_e1200 == 0f);
                                    if _e1203 {
                                        phi_1823_ = lt_bvh_triangle_Intersection();
                                        phi_1824_ = false;
                                    } else {
                                        let _e1205 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1207 = (_e1205.x - _e127);
                                        let _e1209 = (_e1205.y - _e129);
                                        let _e1211 = (_e1205.z - _e131);
                                        if (_e526 == 0u) {
                                            phi_1536_ = vec3<f32>(_e1209, _e1211, _e1207);
                                        } else {
                                            if (_e526 == 1u) {
                                                phi_1535_ = vec3<f32>(_e1211, _e1207, _e1209);
                                            } else {
                                                phi_1535_ = (_e1205 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e1219 = phi_1535_;
                                            phi_1536_ = _e1219;
                                        }
                                        let _e1221 = phi_1536_;
                                        let _e1223 = triangles.member[(0u + _e1016)].v1_;
                                        let _e1225 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1228 = (_e1223.x - _e1225.x);
                                        let _e1231 = (_e1223.y - _e1225.y);
                                        let _e1234 = (_e1223.z - _e1225.z);
                                        if (_e526 == 0u) {
                                            phi_1562_ = vec3<f32>(_e1231, _e1234, _e1228);
                                        } else {
                                            if (_e526 == 1u) {
                                                phi_1561_ = vec3<f32>(_e1234, _e1228, _e1231);
                                            } else {
                                                phi_1561_ = (_e1223 - _e1225);
                                            }
                                            let _e1241 = phi_1561_;
                                            phi_1562_ = _e1241;
                                        }
                                        let _e1243 = phi_1562_;
                                        let _e1245 = triangles.member[(0u + _e1016)].v2_;
                                        let _e1247 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1250 = (_e1245.x - _e1247.x);
                                        let _e1253 = (_e1245.y - _e1247.y);
                                        let _e1256 = (_e1245.z - _e1247.z);
                                        if (_e526 == 0u) {
                                            phi_1588_ = vec3<f32>(_e1253, _e1256, _e1250);
                                        } else {
                                            if (_e526 == 1u) {
                                                phi_1587_ = vec3<f32>(_e1256, _e1250, _e1253);
                                            } else {
                                                phi_1587_ = (_e1245 - _e1247);
                                            }
                                            let _e1263 = phi_1587_;
                                            phi_1588_ = _e1263;
                                        }
                                        let _e1265 = phi_1588_;
                                        let _e1272 = ((_e1243.y * _e1265.z) - (_e1243.z * _e1265.y));
                                        let _e1279 = ((_e1243.z * _e1265.x) - (_e1243.x * _e1265.z));
                                        let _e1286 = ((_e1243.x * _e1265.y) - (_e1243.y * _e1265.x));
                                        let _e1300 = (((1f / _e534.z) * (((_e1272 * _e1221.x) + (_e1279 * _e1221.y)) + (_e1286 * _e1221.z))) / (((_e1272 * _e537) + (_e1279 * _e540)) + _e1286));
                                        if (_e1300 > 0f) {
                                            if (_e1300 < _e139) {
                                                let _e1304 = triangles.member[(0u + _e1016)].v0_;
                                                let _e1306 = triangles.member[(0u + _e1016)].v1_;
                                                if (_e1304.x < _e1306.x) {
                                                    phi_1644_ = _e1304.x;
                                                } else {
                                                    phi_1644_ = _e1306.x;
                                                }
                                                let _e1313 = phi_1644_;
                                                if (_e1304.y < _e1306.y) {
                                                    phi_1653_ = _e1304.y;
                                                } else {
                                                    phi_1653_ = _e1306.y;
                                                }
                                                let _e1320 = phi_1653_;
                                                if (_e1304.z < _e1306.z) {
                                                    phi_1662_ = _e1304.z;
                                                } else {
                                                    phi_1662_ = _e1306.z;
                                                }
                                                let _e1327 = phi_1662_;
                                                let _e1329 = triangles.member[(0u + _e1016)].v2_;
                                                if (_e1313 < _e1329.x) {
                                                    phi_1671_ = _e1313;
                                                } else {
                                                    phi_1671_ = _e1329.x;
                                                }
                                                let _e1334 = phi_1671_;
                                                if (_e1320 < _e1329.y) {
                                                    phi_1678_ = _e1320;
                                                } else {
                                                    phi_1678_ = _e1329.y;
                                                }
                                                let _e1339 = phi_1678_;
                                                if (_e1327 < _e1329.z) {
                                                    phi_1685_ = _e1327;
                                                } else {
                                                    phi_1685_ = _e1329.z;
                                                }
                                                let _e1344 = phi_1685_;
                                                let _e1346 = triangles.member[(0u + _e1016)].v0_;
                                                let _e1348 = triangles.member[(0u + _e1016)].v1_;
                                                if (_e1346.x > _e1348.x) {
                                                    phi_1698_ = _e1346.x;
                                                } else {
                                                    phi_1698_ = _e1348.x;
                                                }
                                                let _e1355 = phi_1698_;
                                                if (_e1346.y > _e1348.y) {
                                                    phi_1707_ = _e1346.y;
                                                } else {
                                                    phi_1707_ = _e1348.y;
                                                }
                                                let _e1362 = phi_1707_;
                                                if (_e1346.z > _e1348.z) {
                                                    phi_1716_ = _e1346.z;
                                                } else {
                                                    phi_1716_ = _e1348.z;
                                                }
                                                let _e1369 = phi_1716_;
                                                let _e1371 = triangles.member[(0u + _e1016)].v2_;
                                                if (_e1355 > _e1371.x) {
                                                    phi_1725_ = _e1355;
                                                } else {
                                                    phi_1725_ = _e1371.x;
                                                }
                                                let _e1376 = phi_1725_;
                                                if (_e1362 > _e1371.y) {
                                                    phi_1732_ = _e1362;
                                                } else {
                                                    phi_1732_ = _e1371.y;
                                                }
                                                let _e1381 = phi_1732_;
                                                if (_e1369 > _e1371.z) {
                                                    phi_1739_ = _e1369;
                                                } else {
                                                    phi_1739_ = _e1371.z;
                                                }
                                                let _e1386 = phi_1739_;
                                                let _e1390 = ((_e1334 - _e127) * _e455);
                                                let _e1391 = ((_e1339 - _e129) * _e465);
                                                let _e1392 = ((_e1344 - _e131) * _e475);
                                                let _e1396 = ((_e1376 - _e127) * _e455);
                                                let _e1397 = ((_e1381 - _e129) * _e465);
                                                let _e1398 = ((_e1386 - _e131) * _e475);
                                                if (_e1390 < _e1396) {
                                                    phi_1756_ = _e1390;
                                                } else {
                                                    phi_1756_ = _e1396;
                                                }
                                                let _e1401 = phi_1756_;
                                                if (_e1391 < _e1397) {
                                                    phi_1761_ = _e1391;
                                                } else {
                                                    phi_1761_ = _e1397;
                                                }
                                                let _e1404 = phi_1761_;
                                                if (_e1392 < _e1398) {
                                                    phi_1766_ = _e1392;
                                                } else {
                                                    phi_1766_ = _e1398;
                                                }
                                                let _e1407 = phi_1766_;
                                                if (_e1390 > _e1396) {
                                                    phi_1774_ = _e1390;
                                                } else {
                                                    phi_1774_ = _e1396;
                                                }
                                                let _e1413 = phi_1774_;
                                                if (_e1391 > _e1397) {
                                                    phi_1779_ = _e1391;
                                                } else {
                                                    phi_1779_ = _e1397;
                                                }
                                                let _e1416 = phi_1779_;
                                                if (_e1392 > _e1398) {
                                                    phi_1784_ = _e1392;
                                                } else {
                                                    phi_1784_ = _e1398;
                                                }
                                                let _e1419 = phi_1784_;
                                                let _e1423 = core_intrinsics_maximum_number_nsz_f32_((_e1401 - _e510), (_e1404 - _e511));
                                                let _e1424 = core_intrinsics_maximum_number_nsz_f32_(_e1423, (_e1407 - _e512));
                                                let _e1425 = core_intrinsics_minimum_number_nsz_f32_((_e1413 + _e510), (_e1416 + _e511));
                                                let _e1426 = core_intrinsics_minimum_number_nsz_f32_(_e1425, (_e1419 + _e512));
                                                if (_e1424 > -300000000000000000000000000000000000000f) {
                                                    phi_1796_ = _e1424;
                                                } else {
                                                    phi_1796_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1429 = phi_1796_;
                                                if (_e1426 < 300000000000000000000000000000000000000f) {
                                                    phi_1801_ = _e1426;
                                                } else {
                                                    phi_1801_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1432 = phi_1801_;
                                                if (_e1300 < _e1429) {
                                                    phi_1806_ = _e1429;
                                                } else {
                                                    phi_1806_ = _e1300;
                                                }
                                                let _e1435 = phi_1806_;
                                                if (_e1435 > _e1432) {
                                                    phi_1811_ = _e1432;
                                                } else {
                                                    phi_1811_ = _e1435;
                                                }
                                                let _e1438 = phi_1811_;
                                                phi_1816_ = lt_bvh_triangle_Intersection(_e1438, (_e1141 / _e1200), (_e1162 / _e1200), (_e1429 <= _e1432));
                                                phi_1817_ = false;
                                            } else {
                                                phi_1816_ = lt_bvh_triangle_Intersection();
                                                phi_1817_ = true;
                                            }
                                            let _e1444 = phi_1816_;
                                            let _e1446 = phi_1817_;
                                            phi_1818_ = _e1444;
                                            phi_1819_ = _e1446;
                                        } else {
                                            phi_1818_ = lt_bvh_triangle_Intersection();
                                            phi_1819_ = true;
                                        }
                                        let _e1448 = phi_1818_;
                                        let _e1450 = phi_1819_;
                                        if _e1450 {
                                        }
                                        phi_1823_ = _e1448;
                                        phi_1824_ = _e1450;
                                    }
                                    let _e1452 = phi_1823_;
                                    let _e1454 = phi_1824_;
                                    phi_1825_ = _e1452;
                                    phi_1826_ = _e1203;
                                    phi_1827_ = _e1454;
                                } else {
                                    phi_1825_ = lt_bvh_triangle_Intersection();
                                    phi_1826_ = true;
                                    phi_1827_ = false;
                                }
                                let _e1456 = phi_1825_;
                                let _e1458 = phi_1826_;
                                let _e1460 = phi_1827_;
                                if _e1458 {
                                    phi_1831_ = true;
                                } else {
                                    phi_1831_ = _e1460;
                                }
                                let _e1462 = phi_1831_;
                                if _e1462 {
                                    phi_1835_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1835_ = _e1456;
                                }
                                let _e1464 = phi_1835_;
                                if _e1464.is_hit {
                                    if (_e1464.t > 0f) {
                                        if (_e1464.t < _e139) {
                                            let _e1471 = triangles.member[(0u + _e1016)].i0_;
                                            let _e1473 = ((_e1471 & 2147483648u) == 0u);
                                            if _e1473 {
                                                phi_1861_ = false;
                                                phi_1862_ = false;
                                            } else {
                                                if true {
                                                    phi_1860_ = false;
                                                } else {
                                                    phi_1860_ = true;
                                                }
                                                let _e1475 = phi_1860_;
                                                phi_1861_ = _e1475;
                                                phi_1862_ = true;
                                            }
                                            let _e1477 = phi_1861_;
                                            let _e1479 = phi_1862_;
                                            phi_1863_ = _e1477;
                                            phi_1864_ = _e1473;
                                            phi_1865_ = _e1479;
                                        } else {
                                            phi_1863_ = true;
                                            phi_1864_ = false;
                                            phi_1865_ = false;
                                        }
                                        let _e1481 = phi_1863_;
                                        let _e1483 = phi_1864_;
                                        let _e1485 = phi_1865_;
                                        phi_1866_ = false;
                                        phi_1867_ = _e1481;
                                        phi_1868_ = _e1483;
                                        phi_1869_ = _e1485;
                                    } else {
                                        phi_1866_ = true;
                                        phi_1867_ = false;
                                        phi_1868_ = false;
                                        phi_1869_ = false;
                                    }
                                    let _e1487 = phi_1866_;
                                    let _e1489 = phi_1867_;
                                    let _e1491 = phi_1868_;
                                    let _e1493 = phi_1869_;
                                    phi_1870_ = _e1487;
                                    phi_1871_ = _e1489;
                                    phi_1872_ = _e1491;
                                    phi_1873_ = _e1493;
                                } else {
                                    phi_1870_ = true;
                                    phi_1871_ = false;
                                    phi_1872_ = false;
                                    phi_1873_ = false;
                                }
                                let _e1495 = phi_1870_;
                                let _e1497 = phi_1871_;
                                let _e1499 = phi_1872_;
                                let _e1501 = phi_1873_;
                                if _e1495 {
                                    phi_1877_ = true;
                                    phi_1878_ = false;
                                    phi_1879_ = false;
                                } else {
                                    phi_1877_ = _e1497;
                                    phi_1878_ = _e1499;
                                    phi_1879_ = _e1501;
                                }
                                let _e1503 = phi_1877_;
                                let _e1505 = phi_1878_;
                                let _e1507 = phi_1879_;
                                if _e1503 {
                                    let _e1508 = (_e1018 == 0u);
                                    if _e1508 {
                                        phi_1887_ = false;
                                    } else {
                                        phi_1887_ = true;
                                    }
                                    let _e1510 = phi_1887_;
                                    phi_1888_ = _e1510;
                                    phi_1889_ = _e1508;
                                    phi_1890_ = false;
                                    phi_1891_ = false;
                                } else {
                                    phi_1888_ = false;
                                    phi_1889_ = false;
                                    phi_1890_ = _e1505;
                                    phi_1891_ = _e1507;
                                }
                                let _e1512 = phi_1888_;
                                let _e1514 = phi_1889_;
                                let _e1516 = phi_1890_;
                                let _e1518 = phi_1891_;
                                local_5 = _e1514;
                                local_16 = _e1516;
                                local_17 = _e1518;
                                local_18 = _e1514;
                                continue;
                                continuing {
                                    phi_1241_ = _e1018;
                                    break if !(_e1512);
                                }
                            }
                            let _e1521 = local_5;
                            if _e1521 {
                                phi_1895_ = false;
                                phi_1896_ = false;
                            } else {
                                let _e3263 = local_16;
                                phi_1895_ = _e3263;
                                let _e3266 = local_17;
                                phi_1896_ = _e3266;
                            }
                            let _e1523 = phi_1895_;
                            let _e1525 = phi_1896_;
                            let _e3269 = local_18;
                            phi_1897_ = _e3269;
                            phi_1898_ = _e1523;
                            phi_1899_ = _e1525;
                        }
                        let _e1527 = phi_1897_;
                        let _e1529 = phi_1898_;
                        let _e1531 = phi_1899_;
                        if _e1527 {
                            let _e1533 = local_6;
                            if (_e1533 == 0u) {
                                phi_1907_ = false;
                            } else {
                                phi_1907_ = true;
                            }
                            let _e1536 = phi_1907_;
                            phi_1908_ = _e1536;
                            phi_1909_ = false;
                            phi_1910_ = false;
                        } else {
                            phi_1908_ = false;
                            phi_1909_ = _e1529;
                            phi_1910_ = _e1531;
                        }
                        let _e1538 = phi_1908_;
                        let _e1540 = phi_1909_;
                        let _e1542 = phi_1910_;
                        local_7 = _e1540;
                        local_19 = _e1542;
                        local_20 = _e1540;
                        continue;
                        continuing {
                            let _e3113 = local_13;
                            phi_787_ = _e3113;
                            let _e3116 = local_14;
                            phi_790_ = _e3116;
                            break if !(_e1538);
                        }
                    }
                    let _e1545 = local_7;
                    if _e1545 {
                        phi_1914_ = false;
                    } else {
                        let _e3280 = local_19;
                        phi_1914_ = _e3280;
                    }
                    let _e1547 = phi_1914_;
                    if _e1547 {
                        phi_1918_ = true;
                    } else {
                        let _e3283 = local_20;
                        phi_1918_ = _e3283;
                    }
                    let _e1549 = phi_1918_;
                    if _e1549 {
                        phi_1922_ = true;
                    } else {
                        phi_1922_ = false;
                    }
                    let _e1551 = phi_1922_;
                    phi_1923_ = _e1551;
                }
                let _e1553 = phi_1923_;
                phi_3380_ = _e1553;
            } else {
                let _e1554 = abs(_e147);
                let _e1555 = abs(_e148);
                let _e1556 = abs(_e149);
                if (abs(_e127) < 1000000000000000f) {
                    if (abs(_e129) < 1000000000000000f) {
                        phi_1939_ = (abs(_e131) < 1000000000000000f);
                        phi_1940_ = false;
                    } else {
                        phi_1939_ = bool();
                        phi_1940_ = true;
                    }
                    let _e1564 = phi_1939_;
                    let _e1566 = phi_1940_;
                    phi_1941_ = _e1564;
                    phi_1942_ = _e1566;
                } else {
                    phi_1941_ = bool();
                    phi_1942_ = true;
                }
                let _e1568 = phi_1941_;
                let _e1570 = phi_1942_;
                if _e1570 {
                    phi_1946_ = false;
                } else {
                    phi_1946_ = _e1568;
                }
                let _e1572 = phi_1946_;
                if _e1572 {
                    if (_e1554 < 1000000000000000f) {
                        if (_e1555 < 1000000000000000f) {
                            phi_1959_ = (_e1556 < 1000000000000000f);
                            phi_1960_ = false;
                        } else {
                            phi_1959_ = bool();
                            phi_1960_ = true;
                        }
                        let _e1577 = phi_1959_;
                        let _e1579 = phi_1960_;
                        phi_1961_ = _e1577;
                        phi_1962_ = _e1579;
                    } else {
                        phi_1961_ = bool();
                        phi_1962_ = true;
                    }
                    let _e1581 = phi_1961_;
                    let _e1583 = phi_1962_;
                    if _e1583 {
                        phi_1966_ = false;
                    } else {
                        phi_1966_ = _e1581;
                    }
                    let _e1585 = phi_1966_;
                    if _e1585 {
                        if (_e1554 > 0f) {
                            phi_1980_ = bool();
                            phi_1981_ = true;
                        } else {
                            let _e1587 = (_e1555 > 0f);
                            if _e1587 {
                                phi_1979_ = bool();
                            } else {
                                phi_1979_ = (_e1556 > 0f);
                            }
                            let _e1590 = phi_1979_;
                            phi_1980_ = _e1590;
                            phi_1981_ = _e1587;
                        }
                        let _e1592 = phi_1980_;
                        let _e1594 = phi_1981_;
                        if _e1594 {
                            phi_1985_ = true;
                        } else {
                            phi_1985_ = _e1592;
                        }
                        let _e1596 = phi_1985_;
                        phi_1986_ = _e1596;
                        phi_1987_ = false;
                    } else {
                        phi_1986_ = bool();
                        phi_1987_ = true;
                    }
                    let _e1598 = phi_1986_;
                    let _e1600 = phi_1987_;
                    phi_1988_ = _e1598;
                    phi_1989_ = _e1600;
                } else {
                    phi_1988_ = bool();
                    phi_1989_ = true;
                }
                let _e1602 = phi_1988_;
                let _e1604 = phi_1989_;
                if _e1604 {
                    phi_1993_ = false;
                } else {
                    phi_1993_ = _e1602;
                }
                let _e1606 = phi_1993_;
                if _e1606 {
                    let _e1607 = (0u >= _e76);
                    if _e1607 {
                        phi_3373_ = bool();
                    } else {
                        if (0u < _e76) {
                        } else {
                            return;
                        }
                        let _e1613 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1617 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1621 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1625 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1629 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1633 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1637 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1671 = core_intrinsics_maximum_number_nsz_f32_(abs(_e147), abs(_e148));
                        let _e1672 = core_intrinsics_maximum_number_nsz_f32_(_e1671, abs(_e149));
                        let _e1673 = (_e1672 * 0.0000000000009094947f);
                        if (abs(_e147) < _e1673) {
                            phi_2063_ = _e1673;
                        } else {
                            phi_2063_ = abs(_e147);
                        }
                        let _e1678 = phi_2063_;
                        if (_e147 < 0f) {
                            phi_2070_ = (-1f / _e1678);
                        } else {
                            phi_2070_ = (1f / _e1678);
                        }
                        let _e1683 = phi_2070_;
                        if (abs(_e148) < _e1673) {
                            phi_2077_ = _e1673;
                        } else {
                            phi_2077_ = abs(_e148);
                        }
                        let _e1688 = phi_2077_;
                        if (_e148 < 0f) {
                            phi_2084_ = (-1f / _e1688);
                        } else {
                            phi_2084_ = (1f / _e1688);
                        }
                        let _e1693 = phi_2084_;
                        if (abs(_e149) < _e1673) {
                            phi_2091_ = _e1673;
                        } else {
                            phi_2091_ = abs(_e149);
                        }
                        let _e1698 = phi_2091_;
                        if (_e149 < 0f) {
                            phi_2098_ = (-1f / _e1698);
                        } else {
                            phi_2098_ = (1f / _e1698);
                        }
                        let _e1703 = phi_2098_;
                        let _e1707 = abs((bitcast<f32>(_e1613) - _e127));
                        let _e1708 = abs((bitcast<f32>(_e1617) - _e129));
                        let _e1709 = abs((bitcast<f32>(_e1621) - _e131));
                        let _e1713 = abs(((bitcast<f32>(_e1625) + (bitcast<f32>((((_e1637 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e127));
                        let _e1714 = abs(((bitcast<f32>(_e1629) + (bitcast<f32>((((_e1637 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e129));
                        let _e1715 = abs(((bitcast<f32>(_e1633) + (bitcast<f32>((((_e1637 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                        if (_e1707 > _e1713) {
                            phi_2115_ = _e1707;
                        } else {
                            phi_2115_ = _e1713;
                        }
                        let _e1718 = phi_2115_;
                        if (_e1708 > _e1714) {
                            phi_2120_ = _e1708;
                        } else {
                            phi_2120_ = _e1714;
                        }
                        let _e1721 = phi_2120_;
                        if (_e1709 > _e1715) {
                            phi_2125_ = _e1709;
                        } else {
                            phi_2125_ = _e1715;
                        }
                        let _e1724 = phi_2125_;
                        if (_e1718 > _e1721) {
                            phi_2130_ = _e1718;
                        } else {
                            phi_2130_ = _e1721;
                        }
                        let _e1727 = phi_2130_;
                        if (_e1727 > _e1724) {
                            phi_2135_ = _e1727;
                        } else {
                            phi_2135_ = _e1724;
                        }
                        let _e1730 = phi_2135_;
                        let _e1734 = (_e1730 * 0.0000019073486f);
                        let _e1735 = (abs(_e1683) * _e1734);
                        let _e1736 = (abs(_e1693) * _e1734);
                        let _e1737 = (abs(_e1703) * _e1734);
                        let _e1741 = (_e1730 * 0.0000009536743f);
                        let _e1742 = (abs(_e1683) * _e1741);
                        let _e1743 = (abs(_e1693) * _e1741);
                        let _e1744 = (abs(_e1703) * _e1741);
                        let _e1745 = abs(_e147);
                        let _e1746 = abs(_e148);
                        let _e1747 = abs(_e149);
                        if (_e1745 >= _e1746) {
                            if (_e1745 >= _e1747) {
                                phi_2161_ = false;
                            } else {
                                phi_2161_ = true;
                            }
                            let _e1751 = phi_2161_;
                            phi_2162_ = _e1751;
                        } else {
                            phi_2162_ = true;
                        }
                        let _e1753 = phi_2162_;
                        if _e1753 {
                            if (_e1746 >= _e1747) {
                                phi_2170_ = 1u;
                            } else {
                                phi_2170_ = 2u;
                            }
                            let _e1756 = phi_2170_;
                            phi_2171_ = _e1756;
                        } else {
                            phi_2171_ = 0u;
                        }
                        let _e1758 = phi_2171_;
                        if (_e1758 == 0u) {
                            phi_2183_ = vec3<f32>(_e148, _e149, _e147);
                        } else {
                            if (_e1758 == 1u) {
                                phi_2182_ = vec3<f32>(_e149, _e147, _e148);
                            } else {
                                phi_2182_ = _e150;
                            }
                            let _e1764 = phi_2182_;
                            phi_2183_ = _e1764;
                        }
                        let _e1766 = phi_2183_;
                        let _e1769 = (_e1766.x / _e1766.z);
                        let _e1772 = (_e1766.y / _e1766.z);
                        if (_e1683 < 0f) {
                            phi_2196_ = 0u;
                        } else {
                            phi_2196_ = 1u;
                        }
                        let _e1777 = phi_2196_;
                        if (_e1693 < 0f) {
                            phi_2201_ = 0u;
                        } else {
                            phi_2201_ = 2u;
                        }
                        let _e1780 = phi_2201_;
                        if (_e1703 < 0f) {
                            phi_2206_ = 0u;
                        } else {
                            phi_2206_ = 4u;
                        }
                        let _e1783 = phi_2206_;
                        let _e1785 = ((_e1777 | _e1780) | _e1783);
                        let _e1786 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1786.first[0], _e1786.first[1], _e1786.first[2], _e1786.first[3], _e1786.first[4], _e1786.first[5], _e1786.first[6], _e1786.first[7], _e1786.first[8], _e1786.first[9], _e1786.first[10], _e1786.first[11], _e1786.first[12], _e1786.first[13], _e1786.first[14], _e1786.first[15], _e1786.first[16], _e1786.first[17], _e1786.first[18], _e1786.first[19], _e1786.first[20], _e1786.first[21], _e1786.first[22], _e1786.first[23], _e1786.first[24], _e1786.first[25], _e1786.first[26], _e1786.first[27], _e1786.first[28], _e1786.first[29], _e1786.first[30], _e1786.first[31]), array<u32, 32>(_e1786.mask[0], _e1786.mask[1], _e1786.mask[2], _e1786.mask[3], _e1786.mask[4], _e1786.mask[5], _e1786.mask[6], _e1786.mask[7], _e1786.mask[8], _e1786.mask[9], _e1786.mask[10], _e1786.mask[11], _e1786.mask[12], _e1786.mask[13], _e1786.mask[14], _e1786.mask[15], _e1786.mask[16], _e1786.mask[17], _e1786.mask[18], _e1786.mask[19], _e1786.mask[20], _e1786.mask[21], _e1786.mask[22], _e1786.mask[23], _e1786.mask[24], _e1786.mask[25], _e1786.mask[26], _e1786.mask[27], _e1786.mask[28], _e1786.mask[29], _e1786.mask[30], _e1786.mask[31]), _e1786.len, _e1786.group, _e1786.group_mask);
                        let _e1860 = local.group_mask;
                        if ((_e1860 & 4278190080u) == 0u) {
                            let _e1864 = local.len;
                            if (_e1864 == 0u) {
                                phi_2320_ = false;
                            } else {
                                let _e1868 = local.len;
                                local.len = (_e1868 - 1u);
                                let _e1871 = local.len;
                                if (_e1871 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1876 = local.first[(0u + _e1871)];
                                local.group = _e1876;
                                let _e1879 = local.len;
                                if (_e1879 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1884 = local.mask[(0u + _e1879)];
                                local.group_mask = _e1884;
                                phi_2320_ = true;
                            }
                            let _e1887 = phi_2320_;
                            phi_2321_ = _e1887;
                        } else {
                            phi_2321_ = true;
                        }
                        let _e1889 = phi_2321_;
                        if _e1889 {
                            let _e1891 = local.group_mask;
                            let _e1897 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1891)), 32u, (_e1891 == 0u)));
                            let _e1901 = local.group_mask;
                            let _e1915 = local.group_mask;
                            local.group_mask = (_e1915 & ~((1u << bitcast<u32>((_e1897 & 31u)))));
                            let _e1918 = local.group;
                            phi_2352_ = (_e1918 + countOneBits(((_e1901 & ~((4294967295u << bitcast<u32>((((_e1897 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2352_ = 4294967295u;
                        }
                        let _e1921 = phi_2352_;
                        phi_2354_ = _e1921;
                        phi_2357_ = false;
                        loop {
                            let _e1923 = phi_2354_;
                            let _e1925 = phi_2357_;
                            local_23 = _e1925;
                            if (_e1923 != 4294967295u) {
                                if (_e1923 < _e76) {
                                } else {
                                    return;
                                }
                                let _e1932 = nodes.member[(0u + _e1923)].frame[3u];
                                let _e1957 = (bitcast<f32>((((_e1932 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1683);
                                let _e1958 = (bitcast<f32>((((_e1932 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1693);
                                let _e1959 = (bitcast<f32>((((_e1932 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1703);
                                let _e1962 = nodes.member[(0u + _e1923)].frame[0u];
                                let _e1966 = nodes.member[(0u + _e1923)].frame[1u];
                                let _e1970 = nodes.member[(0u + _e1923)].frame[2u];
                                let _e1975 = ((bitcast<f32>(_e1962) - _e127) * _e1683);
                                let _e1976 = ((bitcast<f32>(_e1966) - _e129) * _e1693);
                                let _e1977 = ((bitcast<f32>(_e1970) - _e131) * _e1703);
                                let _e1985 = nodes.member[(0u + _e1923)].x;
                                if (_e1683 < 0f) {
                                    let _e1996 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1985.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2002 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1996.unnamed.root, _e1985.w), _e1996.unnamed_1);
                                    let _e2008 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2002.unnamed, lt_bvh_traverse_Tree(_e1985.x, _e2002.unnamed_1.first_primitive));
                                    phi_2437_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2008.unnamed, lt_bvh_traverse_Tree(_e2008.unnamed_1.root, _e1985.y));
                                } else {
                                    let _e2024 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1985.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2030 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2024.unnamed.root, _e1985.y), _e2024.unnamed_1);
                                    let _e2036 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2030.unnamed, lt_bvh_traverse_Tree(_e1985.z, _e2030.unnamed_1.first_primitive));
                                    phi_2437_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2036.unnamed, lt_bvh_traverse_Tree(_e2036.unnamed_1.root, _e1985.w));
                                }
                                let _e2044 = phi_2437_;
                                let _e2054 = nodes.member[(0u + _e1923)].y;
                                if (_e1693 < 0f) {
                                    let _e2065 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2054.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2071 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2065.unnamed.root, _e2054.w), _e2065.unnamed_1);
                                    let _e2077 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2071.unnamed, lt_bvh_traverse_Tree(_e2054.x, _e2071.unnamed_1.first_primitive));
                                    phi_2464_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2077.unnamed, lt_bvh_traverse_Tree(_e2077.unnamed_1.root, _e2054.y));
                                } else {
                                    let _e2093 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2054.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2099 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2093.unnamed.root, _e2054.y), _e2093.unnamed_1);
                                    let _e2105 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2099.unnamed, lt_bvh_traverse_Tree(_e2054.z, _e2099.unnamed_1.first_primitive));
                                    phi_2464_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2105.unnamed, lt_bvh_traverse_Tree(_e2105.unnamed_1.root, _e2054.w));
                                }
                                let _e2113 = phi_2464_;
                                let _e2123 = nodes.member[(0u + _e1923)].z;
                                if (_e1703 < 0f) {
                                    let _e2134 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2123.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2140 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2134.unnamed.root, _e2123.w), _e2134.unnamed_1);
                                    let _e2146 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2140.unnamed, lt_bvh_traverse_Tree(_e2123.x, _e2140.unnamed_1.first_primitive));
                                    phi_2491_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2146.unnamed, lt_bvh_traverse_Tree(_e2146.unnamed_1.root, _e2123.y));
                                } else {
                                    let _e2162 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2123.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2168 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2162.unnamed.root, _e2123.y), _e2162.unnamed_1);
                                    let _e2174 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2168.unnamed, lt_bvh_traverse_Tree(_e2123.z, _e2168.unnamed_1.first_primitive));
                                    phi_2491_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2174.unnamed, lt_bvh_traverse_Tree(_e2174.unnamed_1.root, _e2123.w));
                                }
                                let _e2182 = phi_2491_;
                                phi_2497_ = 0u;
                                phi_2500_ = 0u;
                                loop {
                                    let _e2192 = phi_2497_;
                                    let _e2194 = phi_2500_;
                                    local_8 = _e2194;
                                    local_9 = _e2194;
                                    local_10 = _e2194;
                                    let _e2195 = (_e2192 < 8u);
                                    if _e2195 {
                                        let _e2197 = (_e2192 >> bitcast<u32>(2i));
                                        let _e2198 = (_e2192 & 3u);
                                        if (_e2197 == 0u) {
                                            phi_2514_ = _e2044.unnamed.root;
                                        } else {
                                            phi_2514_ = _e2044.unnamed.first_primitive;
                                        }
                                        let _e2201 = phi_2514_;
                                        if (_e2197 == 0u) {
                                            phi_2524_ = _e2113.unnamed.root;
                                        } else {
                                            phi_2524_ = _e2113.unnamed.first_primitive;
                                        }
                                        let _e2210 = phi_2524_;
                                        if (_e2197 == 0u) {
                                            phi_2534_ = _e2182.unnamed.root;
                                        } else {
                                            phi_2534_ = _e2182.unnamed.first_primitive;
                                        }
                                        let _e2219 = phi_2534_;
                                        let _e2232 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2201 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u)) * _e1957) + (_e1975 - _e1735)), ((f32(((_e2210 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u)) * _e1958) + (_e1976 - _e1736)));
                                        let _e2233 = core_intrinsics_maximum_number_nsz_f32_(_e2232, ((f32(((_e2219 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u)) * _e1959) + (_e1977 - _e1737)));
                                        if (_e2197 == 0u) {
                                            phi_2552_ = _e2044.unnamed_1.root;
                                        } else {
                                            phi_2552_ = _e2044.unnamed_1.first_primitive;
                                        }
                                        let _e2236 = phi_2552_;
                                        if (_e2197 == 0u) {
                                            phi_2562_ = _e2113.unnamed_1.root;
                                        } else {
                                            phi_2562_ = _e2113.unnamed_1.first_primitive;
                                        }
                                        let _e2245 = phi_2562_;
                                        if (_e2197 == 0u) {
                                            phi_2572_ = _e2182.unnamed_1.root;
                                        } else {
                                            phi_2572_ = _e2182.unnamed_1.first_primitive;
                                        }
                                        let _e2254 = phi_2572_;
                                        let _e2267 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2236 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u)) * _e1957) + (_e1975 + _e1735)), ((f32(((_e2245 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u)) * _e1958) + (_e1976 + _e1736)));
                                        let _e2268 = core_intrinsics_minimum_number_nsz_f32_(_e2267, ((f32(((_e2254 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u)) * _e1959) + (_e1977 + _e1737)));
                                        if (_e2233 <= _e2268) {
                                            if (_e2233 <= _e139) {
                                                if (_e2268 >= 0f) {
                                                    if (_e2197 == 0u) {
                                                        let _e2275 = nodes.member[(0u + _e1923)].links[2u];
                                                        phi_2608_ = _e2275;
                                                    } else {
                                                        let _e2278 = nodes.member[(0u + _e1923)].links[3u];
                                                        phi_2608_ = _e2278;
                                                    }
                                                    let _e2280 = phi_2608_;
                                                    let _e2285 = ((_e2280 >> bitcast<u32>(((_e2198 * 8u) & 31u))) & 255u);
                                                    let _e2286 = (_e2285 & 31u);
                                                    if (_e2286 >= 24u) {
                                                        phi_2621_ = (24u + ((_e2286 - 24u) ^ _e1785));
                                                    } else {
                                                        phi_2621_ = _e2286;
                                                    }
                                                    let _e2292 = phi_2621_;
                                                    phi_2626_ = (_e2194 | ((_e2285 >> bitcast<u32>(5i)) << bitcast<u32>((_e2292 & 31u))));
                                                } else {
                                                    phi_2626_ = _e2194;
                                                }
                                                let _e2300 = phi_2626_;
                                                phi_2627_ = _e2300;
                                            } else {
                                                phi_2627_ = _e2194;
                                            }
                                            let _e2302 = phi_2627_;
                                            phi_2628_ = _e2302;
                                        } else {
                                            phi_2628_ = _e2194;
                                        }
                                        let _e2304 = phi_2628_;
                                        phi_2498_ = (_e2192 + 1u);
                                        phi_2501_ = _e2304;
                                    } else {
                                        phi_2498_ = u32();
                                        phi_2501_ = u32();
                                    }
                                    let _e2307 = phi_2498_;
                                    let _e2309 = phi_2501_;
                                    continue;
                                    continuing {
                                        phi_2497_ = _e2307;
                                        phi_2500_ = _e2309;
                                        break if !(_e2195);
                                    }
                                }
                                let _e2313 = nodes.member[(0u + _e1923)].links[0u];
                                let _e2317 = nodes.member[(0u + _e1923)].frame[3u];
                                let _e2321 = local_8;
                                if ((_e2321 & 4278190080u) == 0u) {
                                } else {
                                    let _e2325 = local.group_mask;
                                    if ((_e2325 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2329 = local.len;
                                        if (_e2329 < 32u) {
                                            let _e2332 = local.group;
                                            let _e2334 = local.len;
                                            if (_e2334 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.first[(0u + _e2334)] = _e2332;
                                            let _e2340 = local.group_mask;
                                            let _e2342 = local.len;
                                            if (_e2342 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local.mask[(0u + _e2342)] = _e2340;
                                            let _e2349 = local.len;
                                            local.len = (_e2349 + 1u);
                                        }
                                    }
                                    local.group = (0u + _e2313);
                                    let _e2353 = local_9;
                                    local.group_mask = ((_e2353 & 4278190080u) | (_e2317 >> bitcast<u32>(24i)));
                                }
                                let _e2358 = local_10;
                                phi_2686_ = (_e2358 & 16777215u);
                                phi_2689_ = _e1925;
                                loop {
                                    let _e2361 = phi_2686_;
                                    let _e2363 = phi_2689_;
                                    local_21 = _e2363;
                                    let _e2364 = (_e2361 == 0u);
                                    local_11 = _e2364;
                                    local_22 = _e2364;
                                    if _e2364 {
                                        phi_2687_ = u32();
                                        phi_2690_ = bool();
                                        phi_3287_ = false;
                                    } else {
                                        let _e2367 = nodes.member[(0u + _e1923)].links[1u];
                                        let _e2372 = ((0u + _e2367) + select(firstTrailingBit(_e2361), 32u, (_e2361 == 0u)));
                                        if (_e2372 < _e79) {
                                        } else {
                                            return;
                                        }
                                        let _e2379 = triangles.member[(0u + _e2372)].v0_;
                                        let _e2381 = (_e2379.x - _e127);
                                        let _e2383 = (_e2379.y - _e129);
                                        let _e2385 = (_e2379.z - _e131);
                                        if (_e1758 == 0u) {
                                            phi_2734_ = vec3<f32>(_e2383, _e2385, _e2381);
                                        } else {
                                            if (_e1758 == 1u) {
                                                phi_2733_ = vec3<f32>(_e2385, _e2381, _e2383);
                                            } else {
                                                phi_2733_ = (_e2379 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e2393 = phi_2733_;
                                            phi_2734_ = _e2393;
                                        }
                                        let _e2395 = phi_2734_;
                                        let _e2399 = (_e2395.x - (_e1769 * _e2395.z));
                                        let _e2403 = (_e2395.y - (_e1772 * _e2395.z));
                                        let _e2405 = triangles.member[(0u + _e2372)].v1_;
                                        let _e2407 = (_e2405.x - _e127);
                                        let _e2409 = (_e2405.y - _e129);
                                        let _e2411 = (_e2405.z - _e131);
                                        if (_e1758 == 0u) {
                                            phi_2764_ = vec3<f32>(_e2409, _e2411, _e2407);
                                        } else {
                                            if (_e1758 == 1u) {
                                                phi_2763_ = vec3<f32>(_e2411, _e2407, _e2409);
                                            } else {
                                                phi_2763_ = (_e2405 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e2419 = phi_2763_;
                                            phi_2764_ = _e2419;
                                        }
                                        let _e2421 = phi_2764_;
                                        let _e2425 = (_e2421.x - (_e1769 * _e2421.z));
                                        let _e2429 = (_e2421.y - (_e1772 * _e2421.z));
                                        let _e2431 = triangles.member[(0u + _e2372)].v2_;
                                        let _e2433 = (_e2431.x - _e127);
                                        let _e2435 = (_e2431.y - _e129);
                                        let _e2437 = (_e2431.z - _e131);
                                        if (_e1758 == 0u) {
                                            phi_2794_ = vec3<f32>(_e2435, _e2437, _e2433);
                                        } else {
                                            if (_e1758 == 1u) {
                                                phi_2793_ = vec3<f32>(_e2437, _e2433, _e2435);
                                            } else {
                                                phi_2793_ = (_e2431 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e2445 = phi_2793_;
                                            phi_2794_ = _e2445;
                                        }
                                        let _e2447 = phi_2794_;
                                        let _e2451 = (_e2447.x - (_e1769 * _e2447.z));
                                        let _e2455 = (_e2447.y - (_e1772 * _e2447.z));
                                        if (_e2425 < _e2451) {
                                            phi_2813_ = true;
                                        } else {
                                            if (_e2425 == _e2451) {
                                                phi_2812_ = (_e2429 < _e2455);
                                            } else {
                                                phi_2812_ = false;
                                            }
                                            let _e2460 = phi_2812_;
                                            phi_2813_ = _e2460;
                                        }
                                        let _e2462 = phi_2813_;
                                        if _e2462 {
                                            phi_2817_ = _e2455;
                                            phi_2818_ = _e2451;
                                            phi_2819_ = _e2429;
                                            phi_2820_ = _e2425;
                                        } else {
                                            phi_2817_ = _e2429;
                                            phi_2818_ = _e2425;
                                            phi_2819_ = _e2455;
                                            phi_2820_ = _e2451;
                                        }
                                        let _e2464 = phi_2817_;
                                        let _e2466 = phi_2818_;
                                        let _e2468 = phi_2819_;
                                        let _e2470 = phi_2820_;
                                        let _e2473 = ((_e2470 * _e2464) - (_e2468 * _e2466));
                                        if _e2462 {
                                            phi_2828_ = -(_e2473);
                                        } else {
                                            phi_2828_ = _e2473;
                                        }
                                        let _e2476 = phi_2828_;
                                        if (_e2451 < _e2399) {
                                            phi_2839_ = true;
                                        } else {
                                            if (_e2451 == _e2399) {
                                                phi_2838_ = (_e2455 < _e2403);
                                            } else {
                                                phi_2838_ = false;
                                            }
                                            let _e2481 = phi_2838_;
                                            phi_2839_ = _e2481;
                                        }
                                        let _e2483 = phi_2839_;
                                        if _e2483 {
                                            phi_2843_ = _e2403;
                                            phi_2844_ = _e2399;
                                            phi_2845_ = _e2455;
                                            phi_2846_ = _e2451;
                                        } else {
                                            phi_2843_ = _e2455;
                                            phi_2844_ = _e2451;
                                            phi_2845_ = _e2403;
                                            phi_2846_ = _e2399;
                                        }
                                        let _e2485 = phi_2843_;
                                        let _e2487 = phi_2844_;
                                        let _e2489 = phi_2845_;
                                        let _e2491 = phi_2846_;
                                        let _e2494 = ((_e2491 * _e2485) - (_e2489 * _e2487));
                                        if _e2483 {
                                            phi_2854_ = -(_e2494);
                                        } else {
                                            phi_2854_ = _e2494;
                                        }
                                        let _e2497 = phi_2854_;
                                        if (_e2399 < _e2425) {
                                            phi_2865_ = true;
                                        } else {
                                            if (_e2399 == _e2425) {
                                                phi_2864_ = (_e2403 < _e2429);
                                            } else {
                                                phi_2864_ = false;
                                            }
                                            let _e2502 = phi_2864_;
                                            phi_2865_ = _e2502;
                                        }
                                        let _e2504 = phi_2865_;
                                        if _e2504 {
                                            phi_2869_ = _e2429;
                                            phi_2870_ = _e2425;
                                            phi_2871_ = _e2403;
                                            phi_2872_ = _e2399;
                                        } else {
                                            phi_2869_ = _e2403;
                                            phi_2870_ = _e2399;
                                            phi_2871_ = _e2429;
                                            phi_2872_ = _e2425;
                                        }
                                        let _e2506 = phi_2869_;
                                        let _e2508 = phi_2870_;
                                        let _e2510 = phi_2871_;
                                        let _e2512 = phi_2872_;
                                        let _e2515 = ((_e2512 * _e2506) - (_e2510 * _e2508));
                                        if _e2504 {
                                            phi_2880_ = -(_e2515);
                                        } else {
                                            phi_2880_ = _e2515;
                                        }
                                        let _e2518 = phi_2880_;
                                        if (_e2476 >= 0f) {
                                            if (_e2497 >= 0f) {
                                                if (_e2518 >= 0f) {
                                                    phi_2895_ = ((_e2476 + _e2497) + _e2518);
                                                    phi_2896_ = false;
                                                } else {
                                                    phi_2895_ = f32();
                                                    phi_2896_ = true;
                                                }
                                                let _e2525 = phi_2895_;
                                                let _e2527 = phi_2896_;
                                                phi_2897_ = _e2525;
                                                phi_2898_ = _e2527;
                                            } else {
                                                phi_2897_ = f32();
                                                phi_2898_ = true;
                                            }
                                            let _e2529 = phi_2897_;
                                            let _e2531 = phi_2898_;
                                            phi_2899_ = _e2529;
                                            phi_2900_ = _e2531;
                                        } else {
                                            phi_2899_ = f32();
                                            phi_2900_ = true;
                                        }
                                        let _e2533 = phi_2899_;
                                        let _e2535 = phi_2900_;
                                        if _e2535 {
                                            if (_e2476 <= 0f) {
                                                if (_e2497 <= 0f) {
                                                    let _e2538 = (_e2518 <= 0f);
                                                    if _e2538 {
                                                    }
                                                    phi_2918_ = ((_e2476 + _e2497) + _e2518);
                                                    phi_2919_ = false;
                                                    phi_2920_ = _e2538;
                                                } else {
                                                    phi_2918_ = f32();
                                                    phi_2919_ = true;
                                                    phi_2920_ = false;
                                                }
                                                let _e2542 = phi_2918_;
                                                let _e2544 = phi_2919_;
                                                let _e2546 = phi_2920_;
                                                phi_2921_ = _e2542;
                                                phi_2922_ = _e2544;
                                                phi_2923_ = _e2546;
                                            } else {
                                                phi_2921_ = f32();
                                                phi_2922_ = true;
                                                phi_2923_ = false;
                                            }
                                            let _e2548 = phi_2921_;
                                            let _e2550 = phi_2922_;
                                            let _e2552 = phi_2923_;
                                            if _e2550 {
                                                phi_2927_ = false;
                                            } else {
                                                phi_2927_ = _e2552;
                                            }
                                            let _e2554 = phi_2927_;
                                            phi_2928_ = _e2548;
                                            phi_2929_ = _e2554;
                                        } else {
                                            phi_2928_ = _e2533;
                                            phi_2929_ = true;
                                        }
                                        let _e2556 = phi_2928_;
                                        let _e2558 = phi_2929_;
                                        if _e2558 {
                                            let _e2559 = (_e2556 == 0f);
                                            if _e2559 {
                                                phi_3245_ = lt_bvh_triangle_Intersection();
                                                phi_3246_ = false;
                                            } else {
                                                let _e2561 = triangles.member[(0u + _e2372)].v0_;
                                                let _e2563 = (_e2561.x - _e127);
                                                let _e2565 = (_e2561.y - _e129);
                                                let _e2567 = (_e2561.z - _e131);
                                                if (_e1758 == 0u) {
                                                    phi_2958_ = vec3<f32>(_e2565, _e2567, _e2563);
                                                } else {
                                                    if (_e1758 == 1u) {
                                                        phi_2957_ = vec3<f32>(_e2567, _e2563, _e2565);
                                                    } else {
                                                        phi_2957_ = (_e2561 - vec3<f32>(_e127, _e129, _e131));
                                                    }
                                                    let _e2575 = phi_2957_;
                                                    phi_2958_ = _e2575;
                                                }
                                                let _e2577 = phi_2958_;
                                                let _e2579 = triangles.member[(0u + _e2372)].v1_;
                                                let _e2581 = triangles.member[(0u + _e2372)].v0_;
                                                let _e2584 = (_e2579.x - _e2581.x);
                                                let _e2587 = (_e2579.y - _e2581.y);
                                                let _e2590 = (_e2579.z - _e2581.z);
                                                if (_e1758 == 0u) {
                                                    phi_2984_ = vec3<f32>(_e2587, _e2590, _e2584);
                                                } else {
                                                    if (_e1758 == 1u) {
                                                        phi_2983_ = vec3<f32>(_e2590, _e2584, _e2587);
                                                    } else {
                                                        phi_2983_ = (_e2579 - _e2581);
                                                    }
                                                    let _e2597 = phi_2983_;
                                                    phi_2984_ = _e2597;
                                                }
                                                let _e2599 = phi_2984_;
                                                let _e2601 = triangles.member[(0u + _e2372)].v2_;
                                                let _e2603 = triangles.member[(0u + _e2372)].v0_;
                                                let _e2606 = (_e2601.x - _e2603.x);
                                                let _e2609 = (_e2601.y - _e2603.y);
                                                let _e2612 = (_e2601.z - _e2603.z);
                                                if (_e1758 == 0u) {
                                                    phi_3010_ = vec3<f32>(_e2609, _e2612, _e2606);
                                                } else {
                                                    if (_e1758 == 1u) {
                                                        phi_3009_ = vec3<f32>(_e2612, _e2606, _e2609);
                                                    } else {
                                                        phi_3009_ = (_e2601 - _e2603);
                                                    }
                                                    let _e2619 = phi_3009_;
                                                    phi_3010_ = _e2619;
                                                }
                                                let _e2621 = phi_3010_;
                                                let _e2628 = ((_e2599.y * _e2621.z) - (_e2599.z * _e2621.y));
                                                let _e2635 = ((_e2599.z * _e2621.x) - (_e2599.x * _e2621.z));
                                                let _e2642 = ((_e2599.x * _e2621.y) - (_e2599.y * _e2621.x));
                                                let _e2656 = (((1f / _e1766.z) * (((_e2628 * _e2577.x) + (_e2635 * _e2577.y)) + (_e2642 * _e2577.z))) / (((_e2628 * _e1769) + (_e2635 * _e1772)) + _e2642));
                                                if (_e2656 > 0f) {
                                                    if (_e2656 < _e139) {
                                                        let _e2660 = triangles.member[(0u + _e2372)].v0_;
                                                        let _e2662 = triangles.member[(0u + _e2372)].v1_;
                                                        if (_e2660.x < _e2662.x) {
                                                            phi_3066_ = _e2660.x;
                                                        } else {
                                                            phi_3066_ = _e2662.x;
                                                        }
                                                        let _e2669 = phi_3066_;
                                                        if (_e2660.y < _e2662.y) {
                                                            phi_3075_ = _e2660.y;
                                                        } else {
                                                            phi_3075_ = _e2662.y;
                                                        }
                                                        let _e2676 = phi_3075_;
                                                        if (_e2660.z < _e2662.z) {
                                                            phi_3084_ = _e2660.z;
                                                        } else {
                                                            phi_3084_ = _e2662.z;
                                                        }
                                                        let _e2683 = phi_3084_;
                                                        let _e2685 = triangles.member[(0u + _e2372)].v2_;
                                                        if (_e2669 < _e2685.x) {
                                                            phi_3093_ = _e2669;
                                                        } else {
                                                            phi_3093_ = _e2685.x;
                                                        }
                                                        let _e2690 = phi_3093_;
                                                        if (_e2676 < _e2685.y) {
                                                            phi_3100_ = _e2676;
                                                        } else {
                                                            phi_3100_ = _e2685.y;
                                                        }
                                                        let _e2695 = phi_3100_;
                                                        if (_e2683 < _e2685.z) {
                                                            phi_3107_ = _e2683;
                                                        } else {
                                                            phi_3107_ = _e2685.z;
                                                        }
                                                        let _e2700 = phi_3107_;
                                                        let _e2702 = triangles.member[(0u + _e2372)].v0_;
                                                        let _e2704 = triangles.member[(0u + _e2372)].v1_;
                                                        if (_e2702.x > _e2704.x) {
                                                            phi_3120_ = _e2702.x;
                                                        } else {
                                                            phi_3120_ = _e2704.x;
                                                        }
                                                        let _e2711 = phi_3120_;
                                                        if (_e2702.y > _e2704.y) {
                                                            phi_3129_ = _e2702.y;
                                                        } else {
                                                            phi_3129_ = _e2704.y;
                                                        }
                                                        let _e2718 = phi_3129_;
                                                        if (_e2702.z > _e2704.z) {
                                                            phi_3138_ = _e2702.z;
                                                        } else {
                                                            phi_3138_ = _e2704.z;
                                                        }
                                                        let _e2725 = phi_3138_;
                                                        let _e2727 = triangles.member[(0u + _e2372)].v2_;
                                                        if (_e2711 > _e2727.x) {
                                                            phi_3147_ = _e2711;
                                                        } else {
                                                            phi_3147_ = _e2727.x;
                                                        }
                                                        let _e2732 = phi_3147_;
                                                        if (_e2718 > _e2727.y) {
                                                            phi_3154_ = _e2718;
                                                        } else {
                                                            phi_3154_ = _e2727.y;
                                                        }
                                                        let _e2737 = phi_3154_;
                                                        if (_e2725 > _e2727.z) {
                                                            phi_3161_ = _e2725;
                                                        } else {
                                                            phi_3161_ = _e2727.z;
                                                        }
                                                        let _e2742 = phi_3161_;
                                                        let _e2746 = ((_e2690 - _e127) * _e1683);
                                                        let _e2747 = ((_e2695 - _e129) * _e1693);
                                                        let _e2748 = ((_e2700 - _e131) * _e1703);
                                                        let _e2752 = ((_e2732 - _e127) * _e1683);
                                                        let _e2753 = ((_e2737 - _e129) * _e1693);
                                                        let _e2754 = ((_e2742 - _e131) * _e1703);
                                                        if (_e2746 < _e2752) {
                                                            phi_3178_ = _e2746;
                                                        } else {
                                                            phi_3178_ = _e2752;
                                                        }
                                                        let _e2757 = phi_3178_;
                                                        if (_e2747 < _e2753) {
                                                            phi_3183_ = _e2747;
                                                        } else {
                                                            phi_3183_ = _e2753;
                                                        }
                                                        let _e2760 = phi_3183_;
                                                        if (_e2748 < _e2754) {
                                                            phi_3188_ = _e2748;
                                                        } else {
                                                            phi_3188_ = _e2754;
                                                        }
                                                        let _e2763 = phi_3188_;
                                                        if (_e2746 > _e2752) {
                                                            phi_3196_ = _e2746;
                                                        } else {
                                                            phi_3196_ = _e2752;
                                                        }
                                                        let _e2769 = phi_3196_;
                                                        if (_e2747 > _e2753) {
                                                            phi_3201_ = _e2747;
                                                        } else {
                                                            phi_3201_ = _e2753;
                                                        }
                                                        let _e2772 = phi_3201_;
                                                        if (_e2748 > _e2754) {
                                                            phi_3206_ = _e2748;
                                                        } else {
                                                            phi_3206_ = _e2754;
                                                        }
                                                        let _e2775 = phi_3206_;
                                                        let _e2779 = core_intrinsics_maximum_number_nsz_f32_((_e2757 - _e1742), (_e2760 - _e1743));
                                                        let _e2780 = core_intrinsics_maximum_number_nsz_f32_(_e2779, (_e2763 - _e1744));
                                                        let _e2781 = core_intrinsics_minimum_number_nsz_f32_((_e2769 + _e1742), (_e2772 + _e1743));
                                                        let _e2782 = core_intrinsics_minimum_number_nsz_f32_(_e2781, (_e2775 + _e1744));
                                                        if (_e2780 > -300000000000000000000000000000000000000f) {
                                                            phi_3218_ = _e2780;
                                                        } else {
                                                            phi_3218_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2785 = phi_3218_;
                                                        if (_e2782 < 300000000000000000000000000000000000000f) {
                                                            phi_3223_ = _e2782;
                                                        } else {
                                                            phi_3223_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2788 = phi_3223_;
                                                        if (_e2656 < _e2785) {
                                                            phi_3228_ = _e2785;
                                                        } else {
                                                            phi_3228_ = _e2656;
                                                        }
                                                        let _e2791 = phi_3228_;
                                                        if (_e2791 > _e2788) {
                                                            phi_3233_ = _e2788;
                                                        } else {
                                                            phi_3233_ = _e2791;
                                                        }
                                                        let _e2794 = phi_3233_;
                                                        phi_3238_ = lt_bvh_triangle_Intersection(_e2794, (_e2497 / _e2556), (_e2518 / _e2556), (_e2785 <= _e2788));
                                                        phi_3239_ = false;
                                                    } else {
                                                        phi_3238_ = lt_bvh_triangle_Intersection();
                                                        phi_3239_ = true;
                                                    }
                                                    let _e2800 = phi_3238_;
                                                    let _e2802 = phi_3239_;
                                                    phi_3240_ = _e2800;
                                                    phi_3241_ = _e2802;
                                                } else {
                                                    phi_3240_ = lt_bvh_triangle_Intersection();
                                                    phi_3241_ = true;
                                                }
                                                let _e2804 = phi_3240_;
                                                let _e2806 = phi_3241_;
                                                if _e2806 {
                                                }
                                                phi_3245_ = _e2804;
                                                phi_3246_ = _e2806;
                                            }
                                            let _e2808 = phi_3245_;
                                            let _e2810 = phi_3246_;
                                            phi_3247_ = _e2808;
                                            phi_3248_ = _e2559;
                                            phi_3249_ = _e2810;
                                        } else {
                                            phi_3247_ = lt_bvh_triangle_Intersection();
                                            phi_3248_ = true;
                                            phi_3249_ = false;
                                        }
                                        let _e2812 = phi_3247_;
                                        let _e2814 = phi_3248_;
                                        let _e2816 = phi_3249_;
                                        if _e2814 {
                                            phi_3253_ = true;
                                        } else {
                                            phi_3253_ = _e2816;
                                        }
                                        let _e2818 = phi_3253_;
                                        if _e2818 {
                                            phi_3257_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3257_ = _e2812;
                                        }
                                        let _e2820 = phi_3257_;
                                        if _e2820.is_hit {
                                            if (_e2820.t > 0f) {
                                                if (_e2820.t < _e139) {
                                                    if true {
                                                        phi_3277_ = false;
                                                    } else {
                                                        phi_3277_ = true;
                                                    }
                                                    let _e2829 = phi_3277_;
                                                    phi_3278_ = true;
                                                    phi_3279_ = _e2829;
                                                } else {
                                                    phi_3278_ = _e2363;
                                                    phi_3279_ = true;
                                                }
                                                let _e2831 = phi_3278_;
                                                let _e2833 = phi_3279_;
                                                phi_3280_ = _e2831;
                                                phi_3281_ = _e2833;
                                            } else {
                                                phi_3280_ = _e2363;
                                                phi_3281_ = true;
                                            }
                                            let _e2835 = phi_3280_;
                                            let _e2837 = phi_3281_;
                                            phi_3282_ = _e2835;
                                            phi_3283_ = _e2837;
                                        } else {
                                            phi_3282_ = _e2363;
                                            phi_3283_ = true;
                                        }
                                        let _e2839 = phi_3282_;
                                        let _e2841 = phi_3283_;
                                        if _e2841 {
                                        }
                                        phi_2687_ = (_e2361 & (_e2361 - 1u));
                                        phi_2690_ = _e2839;
                                        phi_3287_ = _e2841;
                                    }
                                    let _e2843 = phi_2687_;
                                    let _e2845 = phi_2690_;
                                    let _e2847 = phi_3287_;
                                    continue;
                                    continuing {
                                        phi_2686_ = _e2843;
                                        phi_2689_ = _e2845;
                                        break if !(_e2847);
                                    }
                                }
                                let _e2850 = local_11;
                                if _e2850 {
                                    let _e2852 = local.group_mask;
                                    if ((_e2852 & 4278190080u) == 0u) {
                                        let _e2856 = local.len;
                                        if (_e2856 == 0u) {
                                            phi_3329_ = false;
                                        } else {
                                            let _e2860 = local.len;
                                            local.len = (_e2860 - 1u);
                                            let _e2863 = local.len;
                                            if (_e2863 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2868 = local.first[(0u + _e2863)];
                                            local.group = _e2868;
                                            let _e2871 = local.len;
                                            if (_e2871 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e2876 = local.mask[(0u + _e2871)];
                                            local.group_mask = _e2876;
                                            phi_3329_ = true;
                                        }
                                        let _e2879 = phi_3329_;
                                        phi_3330_ = _e2879;
                                    } else {
                                        phi_3330_ = true;
                                    }
                                    let _e2881 = phi_3330_;
                                    if _e2881 {
                                        let _e2883 = local.group_mask;
                                        let _e2889 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2883)), 32u, (_e2883 == 0u)));
                                        let _e2893 = local.group_mask;
                                        let _e2907 = local.group_mask;
                                        local.group_mask = (_e2907 & ~((1u << bitcast<u32>((_e2889 & 31u)))));
                                        let _e2910 = local.group;
                                        phi_3361_ = (_e2910 + countOneBits(((_e2893 & ~((4294967295u << bitcast<u32>((((_e2889 - 24u) ^ _e1785) & 31u))))) & 255u)));
                                    } else {
                                        phi_3361_ = 4294967295u;
                                    }
                                    let _e2913 = phi_3361_;
                                    phi_3362_ = _e2913;
                                } else {
                                    phi_3362_ = u32();
                                }
                                let _e2915 = phi_3362_;
                                phi_2355_ = _e2915;
                                let _e3452 = local_21;
                                phi_2358_ = _e3452;
                                let _e3455 = local_22;
                                phi_3363_ = _e3455;
                                phi_3364_ = false;
                            } else {
                                phi_2355_ = u32();
                                phi_2358_ = bool();
                                phi_3363_ = false;
                                phi_3364_ = true;
                            }
                            let _e2917 = phi_2355_;
                            let _e2919 = phi_2358_;
                            let _e2921 = phi_3363_;
                            let _e2923 = phi_3364_;
                            local_12 = _e2923;
                            continue;
                            continuing {
                                phi_2354_ = _e2917;
                                phi_2357_ = _e2919;
                                break if !(_e2921);
                            }
                        }
                        let _e2926 = local_12;
                        if _e2926 {
                            phi_3368_ = false;
                        } else {
                            phi_3368_ = true;
                        }
                        let _e2928 = phi_3368_;
                        if _e2928 {
                            phi_3372_ = true;
                        } else {
                            let _e3461 = local_23;
                            phi_3372_ = _e3461;
                        }
                        let _e2930 = phi_3372_;
                        phi_3373_ = _e2930;
                    }
                    let _e2932 = phi_3373_;
                    phi_3374_ = _e2932;
                    phi_3375_ = _e1607;
                } else {
                    phi_3374_ = bool();
                    phi_3375_ = true;
                }
                let _e2934 = phi_3374_;
                let _e2936 = phi_3375_;
                if _e2936 {
                    phi_3379_ = false;
                } else {
                    phi_3379_ = _e2934;
                }
                let _e2938 = phi_3379_;
                phi_3380_ = _e2938;
            }
            let _e2940 = phi_3380_;
            phi_3381_ = _e2940;
        } else {
            phi_3381_ = false;
        }
        let _e2942 = phi_3381_;
        if _e2942 {
            phi_3385_ = 0f;
        } else {
            phi_3385_ = 1f;
        }
        let _e2944 = phi_3385_;
        if (_e106 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e2944;
        let _e2950 = p.member.light.number;
        let _e2951 = (_e2950 * 3u);
        let _e2952 = (_e2951 / 32u);
        let _e2953 = (_e2951 % 32u);
        let _e2955 = p.member.light.mask_words;
        if (_e106 < _e82) {
        } else {
            return;
        }
        let _e2959 = visibility.member[(0u + _e106)];
        let _e2961 = ((_e106 * _e2955) + _e2952);
        if (_e2953 > 29u) {
            let _e2963 = (_e2961 + 1u);
            if (_e2963 < _e88) {
            } else {
                return;
            }
            let _e2967 = bits.member[(0u + _e2963)];
            phi_3426_ = _e2967;
        } else {
            phi_3426_ = 0u;
        }
        let _e2969 = phi_3426_;
        if (_e2961 < _e88) {
        } else {
            return;
        }
        let _e2973 = bits.member[(0u + _e2961)];
        let _e2976 = (_e2973 >> bitcast<u32>((_e2953 & 31u)));
        if (_e2953 > 29u) {
            phi_3445_ = (_e2976 | (_e2969 << bitcast<u32>(((32u - _e2953) & 31u))));
        } else {
            phi_3445_ = _e2976;
        }
        let _e2984 = phi_3445_;
        if ((_e2984 & 2u) == 0u) {
            phi_3453_ = (_e2984 & 1u);
        } else {
            phi_3453_ = (_e2984 & 7u);
        }
        let _e2990 = phi_3453_;
        if ((_e2990 & 1u) != 0u) {
            phi_3461_ = (2u | 1u);
        } else {
            phi_3461_ = 2u;
        }
        let _e2996 = phi_3461_;
        if (_e2959 < 0.5f) {
            phi_3466_ = (_e2996 | 4u);
        } else {
            phi_3466_ = _e2996;
        }
        let _e2999 = phi_3466_;
        let _e3001 = ((_e106 * _e2955) + _e2952);
        if (_e3001 < _e88) {
        } else {
            return;
        }
        let _e3005 = bits.member[(0u + _e3001)];
        if (_e3001 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e3001)] = ((_e3005 & ~((7u << bitcast<u32>((_e2953 & 31u))))) | (_e2999 << bitcast<u32>((_e2953 & 31u))));
        if (_e2953 > 29u) {
            let _e3019 = (_e3001 + 1u);
            if (_e3019 < _e88) {
            } else {
                return;
            }
            let _e3023 = bits.member[(0u + _e3019)];
            let _e3024 = (32u - _e2953);
            let _e3034 = (_e3001 + 1u);
            if (_e3034 < _e88) {
            } else {
                return;
            }
            bits.member[(0u + _e3034)] = ((_e3023 & ~((7u >> bitcast<u32>((_e3024 & 31u))))) | (_e2999 >> bitcast<u32>((_e3024 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
