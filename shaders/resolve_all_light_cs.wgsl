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

struct type_21 {
    member: array<abi_Sample>,
}

struct type_25 {
    member: array<f32>,
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

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_42 {
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

struct type_46 {
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

struct type_56 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_21;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> nodes: type_42;
@group(0) @binding(3) 
var<storage> triangles: type_46;
@group(0) @binding(5) 
var<storage> rows: type_9;
@group(0) @binding(6) 
var<uniform> space: type_56;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_204_: lt_bvh_traverse_Tree;
    var phi_205_: bool;
    var phi_206_: lt_bvh_traverse_Tree;
    var phi_207_: bool;
    var phi_212_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_204_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_205_ = false;
        } else {
            phi_204_ = lt_bvh_traverse_Tree();
            phi_205_ = true;
        }
        let _e79 = phi_204_;
        let _e81 = phi_205_;
        phi_206_ = _e79;
        phi_207_ = _e81;
    } else {
        phi_206_ = lt_bvh_traverse_Tree();
        phi_207_ = true;
    }
    let _e83 = phi_206_;
    let _e85 = phi_207_;
    if _e85 {
        phi_212_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_212_ = _e83;
    }
    let _e90 = phi_212_;
    return lt_bvh_traverse_Tree(_e90.root, _e90.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_227_: bool;
    var phi_231_: f32;

    if (param_3 != param_3) {
        phi_227_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_227_ = _e69;
    }
    let _e71 = phi_227_;
    if _e71 {
        phi_231_ = param_4;
    } else {
        phi_231_ = param_3;
    }
    let _e73 = phi_231_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_243_: bool;
    var phi_247_: f32;

    if (param_5 != param_5) {
        phi_243_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_243_ = _e69;
    }
    let _e71 = phi_243_;
    if _e71 {
        phi_247_ = param_6;
    } else {
        phi_247_ = param_5;
    }
    let _e73 = phi_247_;
    return _e73;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_272_: bool;
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_279_: bool;

    let _e69 = (*param_7).normal[0u];
    let _e71 = global[0u];
    if (_e69 == _e71) {
        let _e74 = (*param_7).normal[1u];
        let _e76 = global[1u];
        if (_e74 == _e76) {
            let _e79 = (*param_7).normal[2u];
            let _e81 = global[2u];
            phi_272_ = (_e79 == _e81);
            phi_273_ = false;
        } else {
            phi_272_ = bool();
            phi_273_ = true;
        }
        let _e84 = phi_272_;
        let _e86 = phi_273_;
        phi_274_ = _e84;
        phi_275_ = _e86;
    } else {
        phi_274_ = bool();
        phi_275_ = true;
    }
    let _e88 = phi_274_;
    let _e90 = phi_275_;
    if _e90 {
        phi_279_ = false;
    } else {
        phi_279_ = _e88;
    }
    let _e92 = phi_279_;
    return !(_e92);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: array<u32, 32>;
    var local_2: abi_Sample;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_407_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_408_: bool;
    var phi_409_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_410_: bool;
    var phi_417_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: f32;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_501_: bool;
    var phi_505_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_525_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_552_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_584_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_603_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_630_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_659_: u32;
    var phi_660_: f32;
    var phi_661_: u32;
    var phi_662_: f32;
    var phi_667_: f32;
    var phi_678_: u32;
    var phi_688_: u32;
    var phi_694_: u32;
    var phi_695_: u32;
    var phi_696_: u32;
    var phi_707_: vec3<f32>;
    var phi_708_: vec3<f32>;
    var phi_730_: vec3<f32>;
    var phi_731_: vec3<f32>;
    var phi_753_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_828_: f32;
    var phi_835_: f32;
    var phi_842_: f32;
    var phi_849_: f32;
    var phi_856_: f32;
    var phi_863_: f32;
    var phi_880_: f32;
    var phi_885_: f32;
    var phi_890_: f32;
    var phi_895_: f32;
    var phi_900_: f32;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_931_: u32;
    var phi_932_: u32;
    var phi_943_: vec3<f32>;
    var phi_944_: vec3<f32>;
    var phi_956_: u32;
    var phi_959_: u32;
    var phi_964_: u32;
    var phi_966_: u32;
    var phi_968_: u32;
    var phi_970_: u32;
    var phi_1042_: f32;
    var phi_1043_: f32;
    var phi_1057_: u32;
    var phi_1080_: f32;
    var phi_1081_: f32;
    var phi_1095_: u32;
    var phi_1117_: f32;
    var phi_1118_: f32;
    var phi_1132_: u32;
    var phi_1155_: f32;
    var phi_1156_: f32;
    var phi_1170_: u32;
    var phi_1362_: u32;
    var phi_1363_: u32;
    var phi_1368_: u32;
    var phi_1369_: u32;
    var phi_1370_: u32;
    var phi_967_: u32;
    var phi_969_: u32;
    var phi_1371_: u32;
    var phi_1389_: u32;
    var phi_1390_: u32;
    var phi_957_: u32;
    var phi_960_: u32;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var local_3: bool;
    var local_4: u32;
    var phi_1410_: u32;
    var local_5: u32;
    var phi_1445_: u32;
    var phi_1446_: u32;
    var phi_1452_: u32;
    var phi_1480_: vec3<f32>;
    var phi_1481_: vec3<f32>;
    var phi_1510_: vec3<f32>;
    var phi_1511_: vec3<f32>;
    var phi_1540_: vec3<f32>;
    var phi_1541_: vec3<f32>;
    var phi_1559_: bool;
    var phi_1560_: bool;
    var phi_1564_: f32;
    var phi_1565_: f32;
    var phi_1566_: f32;
    var phi_1567_: f32;
    var phi_1575_: f32;
    var phi_1585_: bool;
    var phi_1586_: bool;
    var phi_1590_: f32;
    var phi_1591_: f32;
    var phi_1592_: f32;
    var phi_1593_: f32;
    var phi_1601_: f32;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1616_: f32;
    var phi_1617_: f32;
    var phi_1618_: f32;
    var phi_1619_: f32;
    var phi_1627_: f32;
    var phi_1642_: f32;
    var phi_1643_: bool;
    var phi_1644_: f32;
    var phi_1645_: bool;
    var phi_1646_: f32;
    var phi_1647_: bool;
    var phi_1665_: f32;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: f32;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1674_: bool;
    var phi_1675_: f32;
    var phi_1676_: bool;
    var phi_1704_: vec3<f32>;
    var phi_1705_: vec3<f32>;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1756_: vec3<f32>;
    var phi_1757_: vec3<f32>;
    var phi_1813_: f32;
    var phi_1822_: f32;
    var phi_1831_: f32;
    var phi_1840_: f32;
    var phi_1847_: f32;
    var phi_1854_: f32;
    var phi_1867_: f32;
    var phi_1876_: f32;
    var phi_1885_: f32;
    var phi_1894_: f32;
    var phi_1901_: f32;
    var phi_1908_: f32;
    var phi_1925_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1943_: f32;
    var phi_1948_: f32;
    var phi_1953_: f32;
    var phi_1965_: f32;
    var phi_1970_: f32;
    var phi_1975_: f32;
    var phi_1980_: f32;
    var phi_1985_: lt_bvh_triangle_Intersection;
    var phi_1986_: bool;
    var phi_1987_: lt_bvh_triangle_Intersection;
    var phi_1988_: bool;
    var phi_1992_: lt_bvh_triangle_Intersection;
    var phi_1993_: bool;
    var phi_1994_: lt_bvh_triangle_Intersection;
    var phi_1995_: bool;
    var phi_1996_: bool;
    var phi_2000_: bool;
    var phi_2004_: lt_bvh_triangle_Intersection;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2031_: bool;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2034_: bool;
    var phi_2035_: bool;
    var phi_2036_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2039_: bool;
    var phi_2040_: bool;
    var phi_2041_: bool;
    var phi_2042_: bool;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_2048_: bool;
    var phi_2056_: bool;
    var phi_2057_: bool;
    var phi_2058_: bool;
    var phi_2059_: bool;
    var phi_2060_: bool;
    var local_6: bool;
    var phi_2064_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2067_: bool;
    var phi_2068_: bool;
    var local_7: u32;
    var phi_2076_: bool;
    var phi_2077_: bool;
    var phi_2078_: bool;
    var phi_2079_: bool;
    var local_8: bool;
    var phi_2083_: bool;
    var phi_2087_: bool;
    var phi_2091_: bool;
    var phi_2092_: bool;
    var phi_2108_: bool;
    var phi_2109_: bool;
    var phi_2110_: bool;
    var phi_2111_: bool;
    var phi_2115_: bool;
    var phi_2128_: bool;
    var phi_2129_: bool;
    var phi_2130_: bool;
    var phi_2131_: bool;
    var phi_2135_: bool;
    var phi_2148_: bool;
    var phi_2149_: bool;
    var phi_2150_: bool;
    var phi_2154_: bool;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2162_: bool;
    var phi_2232_: f32;
    var phi_2239_: f32;
    var phi_2246_: f32;
    var phi_2253_: f32;
    var phi_2260_: f32;
    var phi_2267_: f32;
    var phi_2284_: f32;
    var phi_2289_: f32;
    var phi_2294_: f32;
    var phi_2299_: f32;
    var phi_2304_: f32;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2339_: u32;
    var phi_2340_: u32;
    var phi_2351_: vec3<f32>;
    var phi_2352_: vec3<f32>;
    var phi_2365_: u32;
    var phi_2370_: u32;
    var phi_2375_: u32;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2521_: u32;
    var phi_2523_: u32;
    var phi_2526_: bool;
    var phi_2606_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2633_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2660_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2666_: u32;
    var phi_2669_: u32;
    var phi_2683_: u32;
    var phi_2693_: u32;
    var phi_2703_: u32;
    var phi_2721_: u32;
    var phi_2731_: u32;
    var phi_2741_: u32;
    var phi_2777_: u32;
    var phi_2790_: u32;
    var phi_2795_: u32;
    var phi_2796_: u32;
    var phi_2797_: u32;
    var phi_2667_: u32;
    var phi_2670_: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var phi_2855_: u32;
    var phi_2858_: bool;
    var phi_2902_: vec3<f32>;
    var phi_2903_: vec3<f32>;
    var phi_2932_: vec3<f32>;
    var phi_2933_: vec3<f32>;
    var phi_2962_: vec3<f32>;
    var phi_2963_: vec3<f32>;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2986_: f32;
    var phi_2987_: f32;
    var phi_2988_: f32;
    var phi_2989_: f32;
    var phi_2997_: f32;
    var phi_3007_: bool;
    var phi_3008_: bool;
    var phi_3012_: f32;
    var phi_3013_: f32;
    var phi_3014_: f32;
    var phi_3015_: f32;
    var phi_3023_: f32;
    var phi_3033_: bool;
    var phi_3034_: bool;
    var phi_3038_: f32;
    var phi_3039_: f32;
    var phi_3040_: f32;
    var phi_3041_: f32;
    var phi_3049_: f32;
    var phi_3064_: f32;
    var phi_3065_: bool;
    var phi_3066_: f32;
    var phi_3067_: bool;
    var phi_3068_: f32;
    var phi_3069_: bool;
    var phi_3087_: f32;
    var phi_3088_: bool;
    var phi_3089_: bool;
    var phi_3090_: f32;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3096_: bool;
    var phi_3097_: f32;
    var phi_3098_: bool;
    var phi_3126_: vec3<f32>;
    var phi_3127_: vec3<f32>;
    var phi_3152_: vec3<f32>;
    var phi_3153_: vec3<f32>;
    var phi_3178_: vec3<f32>;
    var phi_3179_: vec3<f32>;
    var phi_3235_: f32;
    var phi_3244_: f32;
    var phi_3253_: f32;
    var phi_3262_: f32;
    var phi_3269_: f32;
    var phi_3276_: f32;
    var phi_3289_: f32;
    var phi_3298_: f32;
    var phi_3307_: f32;
    var phi_3316_: f32;
    var phi_3323_: f32;
    var phi_3330_: f32;
    var phi_3347_: f32;
    var phi_3352_: f32;
    var phi_3357_: f32;
    var phi_3365_: f32;
    var phi_3370_: f32;
    var phi_3375_: f32;
    var phi_3387_: f32;
    var phi_3392_: f32;
    var phi_3397_: f32;
    var phi_3402_: f32;
    var phi_3407_: lt_bvh_triangle_Intersection;
    var phi_3408_: bool;
    var phi_3409_: lt_bvh_triangle_Intersection;
    var phi_3410_: bool;
    var phi_3414_: lt_bvh_triangle_Intersection;
    var phi_3415_: bool;
    var phi_3416_: lt_bvh_triangle_Intersection;
    var phi_3417_: bool;
    var phi_3418_: bool;
    var phi_3422_: bool;
    var phi_3426_: lt_bvh_triangle_Intersection;
    var phi_3446_: bool;
    var phi_3447_: bool;
    var phi_3448_: bool;
    var phi_3449_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3452_: bool;
    var phi_2856_: u32;
    var phi_2859_: bool;
    var phi_3456_: bool;
    var local_12: bool;
    var phi_3498_: bool;
    var phi_3499_: bool;
    var phi_3530_: u32;
    var phi_3531_: u32;
    var phi_2524_: u32;
    var phi_2527_: bool;
    var phi_3532_: bool;
    var phi_3533_: bool;
    var local_13: bool;
    var phi_3537_: bool;
    var phi_3541_: bool;
    var phi_3542_: bool;
    var phi_3543_: bool;
    var phi_3544_: bool;
    var phi_3548_: bool;
    var phi_3549_: bool;
    var phi_3550_: bool;
    var phi_3554_: f32;
    var phi_3555_: f32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&rows.member));
    let _e89 = p.member.size[0u];
    let _e91 = p.member.size[1u];
    let _e92 = lt_shaders_entry_pixel_index(_e69, _e89, _e91);
    if (bitcast<i32>(_e92.root) != 0i) {
        if (_e92.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e100 = samples.member[(0u + _e92.first_primitive)];
        local_2 = abi_Sample(_e100.position, _e100.magnitude, _e100.normal, _e100.flags, _e100.shading_normal, _e100.albedo);
        let _e109 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e109 {
            let _e111 = local_2.position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = local_2.normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_396_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_395_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_395_ = false;
                    }
                    let _e169 = phi_395_;
                    phi_396_ = _e169;
                }
                let _e171 = phi_396_;
                if _e171 {
                    let _e173 = local_2.flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_408_ = false;
                } else {
                    phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_408_ = true;
                }
                let _e192 = phi_407_;
                let _e194 = phi_408_;
                phi_409_ = _e192;
                phi_410_ = _e194;
            } else {
                phi_409_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_410_ = true;
            }
            let _e196 = phi_409_;
            let _e198 = phi_410_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_417_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_417_ = _e196;
            }
            let _e215 = phi_417_;
            phi_421_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_421_;
        let _e236 = space.member;
        if _e232.unnamed_1 {
            phi_3555_ = _e232.unnamed.visibility;
        } else {
            let _e239 = local_2.position;
            let _e241 = local_2.normal;
            let _e243 = local_2.magnitude;
            let _e245 = ((8f / 8388608f) * _e243);
            let _e247 = (_e241.x * _e245);
            let _e249 = (_e241.y * _e245);
            let _e251 = (_e241.z * _e245);
            let _e253 = (_e239.x + _e247);
            let _e255 = (_e239.y + _e249);
            let _e257 = (_e239.z + _e251);
            let _e261 = p.member.light.place;
            if (_e261.w == 0f) {
                phi_465_ = 300000000000000000000000000000000000000f;
            } else {
                phi_465_ = 1f;
            }
            let _e265 = phi_465_;
            let _e273 = (_e261.x - (_e253 * _e261.w));
            let _e274 = (_e261.y - (_e255 * _e261.w));
            let _e275 = (_e261.z - (_e257 * _e261.w));
            let _e276 = vec3<f32>(_e273, _e274, _e275);
            let _e277 = abs(_e273);
            let _e278 = abs(_e274);
            let _e279 = abs(_e275);
            if (abs(_e253) < 1000000000000000f) {
                if (abs(_e255) < 1000000000000000f) {
                    phi_498_ = (abs(_e257) < 1000000000000000f);
                    phi_499_ = false;
                } else {
                    phi_498_ = bool();
                    phi_499_ = true;
                }
                let _e287 = phi_498_;
                let _e289 = phi_499_;
                phi_500_ = _e287;
                phi_501_ = _e289;
            } else {
                phi_500_ = bool();
                phi_501_ = true;
            }
            let _e291 = phi_500_;
            let _e293 = phi_501_;
            if _e293 {
                phi_505_ = false;
            } else {
                phi_505_ = _e291;
            }
            let _e295 = phi_505_;
            if _e295 {
                if (_e277 < 1000000000000000f) {
                    if (_e278 < 1000000000000000f) {
                        phi_518_ = (_e279 < 1000000000000000f);
                        phi_519_ = false;
                    } else {
                        phi_518_ = bool();
                        phi_519_ = true;
                    }
                    let _e300 = phi_518_;
                    let _e302 = phi_519_;
                    phi_520_ = _e300;
                    phi_521_ = _e302;
                } else {
                    phi_520_ = bool();
                    phi_521_ = true;
                }
                let _e304 = phi_520_;
                let _e306 = phi_521_;
                if _e306 {
                    phi_525_ = false;
                } else {
                    phi_525_ = _e304;
                }
                let _e308 = phi_525_;
                if _e308 {
                    if (_e277 > 0f) {
                        phi_539_ = bool();
                        phi_540_ = true;
                    } else {
                        let _e310 = (_e278 > 0f);
                        if _e310 {
                            phi_538_ = bool();
                        } else {
                            phi_538_ = (_e279 > 0f);
                        }
                        let _e313 = phi_538_;
                        phi_539_ = _e313;
                        phi_540_ = _e310;
                    }
                    let _e315 = phi_539_;
                    let _e317 = phi_540_;
                    if _e317 {
                        phi_544_ = true;
                    } else {
                        phi_544_ = _e315;
                    }
                    let _e319 = phi_544_;
                    phi_545_ = _e319;
                    phi_546_ = false;
                } else {
                    phi_545_ = bool();
                    phi_546_ = true;
                }
                let _e321 = phi_545_;
                let _e323 = phi_546_;
                phi_547_ = _e321;
                phi_548_ = _e323;
            } else {
                phi_547_ = bool();
                phi_548_ = true;
            }
            let _e325 = phi_547_;
            let _e327 = phi_548_;
            if _e327 {
                phi_552_ = false;
            } else {
                phi_552_ = _e325;
            }
            let _e329 = phi_552_;
            if _e329 {
                if (_e236.low.x <= _e253) {
                    if (_e253 <= _e236.high.x) {
                        if (_e236.low.y <= _e255) {
                            phi_575_ = (_e255 <= _e236.high.y);
                            phi_576_ = false;
                        } else {
                            phi_575_ = bool();
                            phi_576_ = true;
                        }
                        let _e347 = phi_575_;
                        let _e349 = phi_576_;
                        phi_577_ = _e347;
                        phi_578_ = _e349;
                    } else {
                        phi_577_ = bool();
                        phi_578_ = true;
                    }
                    let _e351 = phi_577_;
                    let _e353 = phi_578_;
                    phi_579_ = _e351;
                    phi_580_ = _e353;
                } else {
                    phi_579_ = bool();
                    phi_580_ = true;
                }
                let _e355 = phi_579_;
                let _e357 = phi_580_;
                if _e357 {
                    phi_584_ = false;
                } else {
                    phi_584_ = _e355;
                }
                let _e359 = phi_584_;
                if (abs(_e273) > 0.000000000000000000000000000001f) {
                    phi_598_ = bool();
                    phi_599_ = true;
                } else {
                    let _e364 = (abs(_e274) > 0.000000000000000000000000000001f);
                    if _e364 {
                        phi_597_ = bool();
                    } else {
                        phi_597_ = (abs(_e275) > 0.000000000000000000000000000001f);
                    }
                    let _e367 = phi_597_;
                    phi_598_ = _e367;
                    phi_599_ = _e364;
                }
                let _e369 = phi_598_;
                let _e371 = phi_599_;
                if _e371 {
                    phi_603_ = true;
                } else {
                    phi_603_ = _e369;
                }
                let _e373 = phi_603_;
                if _e359 {
                    if (_e236.low.z <= _e257) {
                        if (_e257 <= _e236.high.z) {
                            if (_e236.is_parallel == 0u) {
                                phi_620_ = _e373;
                            } else {
                                phi_620_ = true;
                            }
                            let _e379 = phi_620_;
                            phi_621_ = _e379;
                            phi_622_ = false;
                        } else {
                            phi_621_ = bool();
                            phi_622_ = true;
                        }
                        let _e381 = phi_621_;
                        let _e383 = phi_622_;
                        phi_623_ = _e381;
                        phi_624_ = _e383;
                    } else {
                        phi_623_ = bool();
                        phi_624_ = true;
                    }
                    let _e385 = phi_623_;
                    let _e387 = phi_624_;
                    phi_625_ = _e385;
                    phi_626_ = _e387;
                } else {
                    phi_625_ = bool();
                    phi_626_ = true;
                }
                let _e389 = phi_625_;
                let _e391 = phi_626_;
                if _e391 {
                    phi_630_ = false;
                } else {
                    phi_630_ = _e389;
                }
                let _e393 = phi_630_;
                if _e393 {
                    if (_e236.is_parallel == 0u) {
                        let _e396 = abs(_e273);
                        let _e397 = abs(_e274);
                        let _e398 = abs(_e275);
                        if (_e396 >= _e397) {
                            if (_e396 >= _e398) {
                                phi_650_ = false;
                            } else {
                                phi_650_ = true;
                            }
                            let _e402 = phi_650_;
                            phi_651_ = _e402;
                        } else {
                            phi_651_ = true;
                        }
                        let _e404 = phi_651_;
                        if _e404 {
                            if (_e397 >= _e398) {
                                phi_659_ = 1u;
                                phi_660_ = _e274;
                            } else {
                                phi_659_ = 2u;
                                phi_660_ = _e275;
                            }
                            let _e407 = phi_659_;
                            let _e409 = phi_660_;
                            phi_661_ = _e407;
                            phi_662_ = _e409;
                        } else {
                            phi_661_ = 0u;
                            phi_662_ = _e273;
                        }
                        let _e411 = phi_661_;
                        let _e413 = phi_662_;
                        if (_e413 < 0f) {
                            phi_667_ = -1f;
                        } else {
                            phi_667_ = 1f;
                        }
                        let _e416 = phi_667_;
                        let _e417 = (_e416 < 0f);
                        if (_e411 == 0u) {
                            if _e417 {
                                phi_678_ = _e236.roots.y;
                            } else {
                                phi_678_ = _e236.roots.x;
                            }
                            let _e424 = phi_678_;
                            phi_696_ = _e424;
                        } else {
                            if (_e411 == 1u) {
                                if _e417 {
                                    phi_688_ = _e236.roots.w;
                                } else {
                                    phi_688_ = _e236.roots.z;
                                }
                                let _e431 = phi_688_;
                                phi_695_ = _e431;
                            } else {
                                if _e417 {
                                    phi_694_ = _e236.roots_z.y;
                                } else {
                                    phi_694_ = _e236.roots_z.x;
                                }
                                let _e437 = phi_694_;
                                phi_695_ = _e437;
                            }
                            let _e439 = phi_695_;
                            phi_696_ = _e439;
                        }
                        let _e441 = phi_696_;
                        if (_e411 == 0u) {
                            phi_708_ = vec3<f32>(_e274, _e275, _e273);
                        } else {
                            if (_e411 == 1u) {
                                phi_707_ = vec3<f32>(_e275, _e273, _e274);
                            } else {
                                phi_707_ = _e276;
                            }
                            let _e447 = phi_707_;
                            phi_708_ = _e447;
                        }
                        let _e449 = phi_708_;
                        phi_753_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e449.x / _e449.z), (_e449.y / _e449.z), (_e416 / _e449.z)), _e441);
                    } else {
                        if (_e236.axis == 0u) {
                            phi_731_ = vec3<f32>(_e255, _e257, _e253);
                        } else {
                            if (_e236.axis == 1u) {
                                phi_730_ = vec3<f32>(_e257, _e253, _e255);
                            } else {
                                phi_730_ = (_e239 + vec3<f32>(_e247, _e249, _e251));
                            }
                            let _e466 = phi_730_;
                            phi_731_ = _e466;
                        }
                        let _e468 = phi_731_;
                        let _e483 = (_e468.z - _e236.middle.z);
                        phi_753_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e468.x - _e236.middle.x) - (_e236.shear.x * _e483)), ((_e468.y - _e236.middle.y) - (_e236.shear.y * _e483)), (_e236.sign * _e483)), _e236.roots.x);
                    }
                    let _e494 = phi_753_;
                    if (_e494.unnamed_1 == 4294967295u) {
                        phi_2092_ = false;
                    } else {
                        if (0u < _e76) {
                        } else {
                            return;
                        }
                        let _e511 = nodes.member[0u].frame[0u];
                        let _e515 = nodes.member[0u].frame[1u];
                        let _e519 = nodes.member[0u].frame[2u];
                        let _e523 = nodes.member[0u].frame[0u];
                        let _e527 = nodes.member[0u].frame[1u];
                        let _e531 = nodes.member[0u].frame[2u];
                        let _e535 = nodes.member[0u].frame[3u];
                        let _e569 = core_intrinsics_maximum_number_nsz_f32_(abs(_e273), abs(_e274));
                        let _e570 = core_intrinsics_maximum_number_nsz_f32_(_e569, abs(_e275));
                        let _e571 = (_e570 * 0.0000000000009094947f);
                        if (abs(_e273) < _e571) {
                            phi_828_ = _e571;
                        } else {
                            phi_828_ = abs(_e273);
                        }
                        let _e576 = phi_828_;
                        if (_e273 < 0f) {
                            phi_835_ = (-1f / _e576);
                        } else {
                            phi_835_ = (1f / _e576);
                        }
                        let _e581 = phi_835_;
                        if (abs(_e274) < _e571) {
                            phi_842_ = _e571;
                        } else {
                            phi_842_ = abs(_e274);
                        }
                        let _e586 = phi_842_;
                        if (_e274 < 0f) {
                            phi_849_ = (-1f / _e586);
                        } else {
                            phi_849_ = (1f / _e586);
                        }
                        let _e591 = phi_849_;
                        if (abs(_e275) < _e571) {
                            phi_856_ = _e571;
                        } else {
                            phi_856_ = abs(_e275);
                        }
                        let _e596 = phi_856_;
                        if (_e275 < 0f) {
                            phi_863_ = (-1f / _e596);
                        } else {
                            phi_863_ = (1f / _e596);
                        }
                        let _e601 = phi_863_;
                        let _e605 = abs((bitcast<f32>(_e511) - _e253));
                        let _e606 = abs((bitcast<f32>(_e515) - _e255));
                        let _e607 = abs((bitcast<f32>(_e519) - _e257));
                        let _e611 = abs(((bitcast<f32>(_e523) + (bitcast<f32>((((_e535 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e253));
                        let _e612 = abs(((bitcast<f32>(_e527) + (bitcast<f32>((((_e535 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e255));
                        let _e613 = abs(((bitcast<f32>(_e531) + (bitcast<f32>((((_e535 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e257));
                        if (_e605 > _e611) {
                            phi_880_ = _e605;
                        } else {
                            phi_880_ = _e611;
                        }
                        let _e616 = phi_880_;
                        if (_e606 > _e612) {
                            phi_885_ = _e606;
                        } else {
                            phi_885_ = _e612;
                        }
                        let _e619 = phi_885_;
                        if (_e607 > _e613) {
                            phi_890_ = _e607;
                        } else {
                            phi_890_ = _e613;
                        }
                        let _e622 = phi_890_;
                        if (_e616 > _e619) {
                            phi_895_ = _e616;
                        } else {
                            phi_895_ = _e619;
                        }
                        let _e625 = phi_895_;
                        if (_e625 > _e622) {
                            phi_900_ = _e625;
                        } else {
                            phi_900_ = _e622;
                        }
                        let _e628 = phi_900_;
                        let _e635 = (_e628 * 0.0000009536743f);
                        let _e636 = (abs(_e581) * _e635);
                        let _e637 = (abs(_e591) * _e635);
                        let _e638 = (abs(_e601) * _e635);
                        let _e639 = abs(_e273);
                        let _e640 = abs(_e274);
                        let _e641 = abs(_e275);
                        if (_e639 >= _e640) {
                            if (_e639 >= _e641) {
                                phi_922_ = false;
                            } else {
                                phi_922_ = true;
                            }
                            let _e645 = phi_922_;
                            phi_923_ = _e645;
                        } else {
                            phi_923_ = true;
                        }
                        let _e647 = phi_923_;
                        if _e647 {
                            if (_e640 >= _e641) {
                                phi_931_ = 1u;
                            } else {
                                phi_931_ = 2u;
                            }
                            let _e650 = phi_931_;
                            phi_932_ = _e650;
                        } else {
                            phi_932_ = 0u;
                        }
                        let _e652 = phi_932_;
                        if (_e652 == 0u) {
                            phi_944_ = vec3<f32>(_e274, _e275, _e273);
                        } else {
                            if (_e652 == 1u) {
                                phi_943_ = vec3<f32>(_e275, _e273, _e274);
                            } else {
                                phi_943_ = _e276;
                            }
                            let _e658 = phi_943_;
                            phi_944_ = _e658;
                        }
                        let _e660 = phi_944_;
                        let _e663 = (_e660.x / _e660.z);
                        let _e666 = (_e660.y / _e660.z);
                        local_1 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_956_ = ((_e494.unnamed_1 << bitcast<u32>(8i)) | 1u);
                        phi_959_ = 0u;
                        loop {
                            let _e673 = phi_956_;
                            let _e675 = phi_959_;
                            phi_964_ = _e673;
                            phi_966_ = 0u;
                            phi_968_ = 0u;
                            phi_970_ = _e675;
                            loop {
                                let _e677 = phi_964_;
                                let _e679 = phi_966_;
                                let _e681 = phi_968_;
                                let _e683 = phi_970_;
                                let _e690 = (((_e677 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e677), 32u, (_e677 == 0u))) * 5u);
                                if (_e690 < _e85) {
                                } else {
                                    return;
                                }
                                let _e694 = rows.member[(0u + _e690)];
                                let _e695 = (_e690 + 1u);
                                if (_e695 < _e85) {
                                } else {
                                    return;
                                }
                                let _e699 = rows.member[(0u + _e695)];
                                let _e700 = (_e690 + 2u);
                                if (_e700 < _e85) {
                                } else {
                                    return;
                                }
                                let _e704 = rows.member[(0u + _e700)];
                                let _e705 = (_e690 + 3u);
                                if (_e705 < _e85) {
                                } else {
                                    return;
                                }
                                let _e709 = rows.member[(0u + _e705)];
                                let _e710 = (_e690 + 4u);
                                if (_e710 < _e85) {
                                } else {
                                    return;
                                }
                                let _e714 = rows.member[(0u + _e710)];
                                let _e715 = lt_bvh_Node(_e694, _e699, _e704, _e709, _e714);
                                let _e717 = (_e677 & (_e677 - 1u));
                                let _e729 = (_e494.unnamed.positive_exponent - bitcast<f32>(_e715.frame.x));
                                let _e732 = bitcast<f32>((((_e715.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e729 > 0f) {
                                    if (_e729 < (255f * _e732)) {
                                        phi_1042_ = (_e729 / _e732);
                                    } else {
                                        phi_1042_ = 255f;
                                    }
                                    let _e738 = phi_1042_;
                                    phi_1043_ = _e738;
                                } else {
                                    phi_1043_ = 0f;
                                }
                                let _e740 = phi_1043_;
                                let _e747 = select(select(u32(_e740), 0u, (_e740 < bitcast<f32>(0u))), 4294967295u, (_e740 > bitcast<f32>(1333788671u)));
                                if (f32(_e747) < _e740) {
                                    phi_1057_ = (_e747 + 1u);
                                } else {
                                    phi_1057_ = _e747;
                                }
                                let _e752 = phi_1057_;
                                let _e753 = (_e747 * 16843009u);
                                let _e754 = (_e752 * 16843009u);
                                let _e764 = (_e494.unnamed.negative_exponent - bitcast<f32>(_e715.frame.y));
                                let _e767 = bitcast<f32>((((_e715.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e764 > 0f) {
                                    if (_e764 < (255f * _e767)) {
                                        phi_1080_ = (_e764 / _e767);
                                    } else {
                                        phi_1080_ = 255f;
                                    }
                                    let _e773 = phi_1080_;
                                    phi_1081_ = _e773;
                                } else {
                                    phi_1081_ = 0f;
                                }
                                let _e775 = phi_1081_;
                                let _e782 = select(select(u32(_e775), 0u, (_e775 < bitcast<f32>(0u))), 4294967295u, (_e775 > bitcast<f32>(1333788671u)));
                                if (f32(_e782) < _e775) {
                                    phi_1095_ = (_e782 + 1u);
                                } else {
                                    phi_1095_ = _e782;
                                }
                                let _e787 = phi_1095_;
                                let _e788 = (_e782 * 16843009u);
                                let _e789 = (_e787 * 16843009u);
                                let _e798 = (((_e236.diagonal.x * _e494.unnamed.positive_exponent) + (_e236.diagonal.y * _e494.unnamed.negative_exponent)) - bitcast<f32>(_e715.frame.z));
                                let _e801 = bitcast<f32>((((_e715.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e798 > 0f) {
                                    if (_e798 < (255f * _e801)) {
                                        phi_1117_ = (_e798 / _e801);
                                    } else {
                                        phi_1117_ = 255f;
                                    }
                                    let _e807 = phi_1117_;
                                    phi_1118_ = _e807;
                                } else {
                                    phi_1118_ = 0f;
                                }
                                let _e809 = phi_1118_;
                                let _e816 = select(select(u32(_e809), 0u, (_e809 < bitcast<f32>(0u))), 4294967295u, (_e809 > bitcast<f32>(1333788671u)));
                                if (f32(_e816) < _e809) {
                                    phi_1132_ = (_e816 + 1u);
                                } else {
                                    phi_1132_ = _e816;
                                }
                                let _e821 = phi_1132_;
                                let _e822 = (_e816 * 16843009u);
                                let _e823 = (_e821 * 16843009u);
                                let _e833 = (_e494.unnamed.min_variance - bitcast<f32>(_e715.frame.w));
                                let _e836 = bitcast<f32>((((_e715.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e833 > 0f) {
                                    if (_e833 < (255f * _e836)) {
                                        phi_1155_ = (_e833 / _e836);
                                    } else {
                                        phi_1155_ = 255f;
                                    }
                                    let _e842 = phi_1155_;
                                    phi_1156_ = _e842;
                                } else {
                                    phi_1156_ = 0f;
                                }
                                let _e844 = phi_1156_;
                                let _e851 = select(select(u32(_e844), 0u, (_e844 < bitcast<f32>(0u))), 4294967295u, (_e844 > bitcast<f32>(1333788671u)));
                                if (f32(_e851) < _e844) {
                                    phi_1170_ = (_e851 + 1u);
                                } else {
                                    phi_1170_ = _e851;
                                }
                                let _e856 = phi_1170_;
                                let _e857 = (_e856 * 16843009u);
                                let _e1038 = (((((((((((_e753 & ~(_e715.links.x)) | (~((_e715.links.x ^ _e753)) & ((_e753 | 2155905152u) - (_e715.links.x & 2139062143u)))) & ((_e715.links.z & ~(_e754)) | (~((_e754 ^ _e715.links.z)) & ((_e715.links.z | 2155905152u) - (_e754 & 2139062143u))))) & (((_e788 & ~(_e715.x.x)) | (~((_e715.x.x ^ _e788)) & ((_e788 | 2155905152u) - (_e715.x.x & 2139062143u)))) & ((_e715.x.z & ~(_e789)) | (~((_e789 ^ _e715.x.z)) & ((_e715.x.z | 2155905152u) - (_e789 & 2139062143u)))))) & (((_e822 & ~(_e715.y.x)) | (~((_e715.y.x ^ _e822)) & ((_e822 | 2155905152u) - (_e715.y.x & 2139062143u)))) & ((_e715.y.z & ~(_e823)) | (~((_e823 ^ _e715.y.z)) & ((_e715.y.z | 2155905152u) - (_e823 & 2139062143u)))))) & ((_e715.z.x & ~(_e857)) | (~((_e857 ^ _e715.z.x)) & ((_e715.z.x | 2155905152u) - (_e857 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e753 & ~(_e715.links.y)) | (~((_e715.links.y ^ _e753)) & ((_e753 | 2155905152u) - (_e715.links.y & 2139062143u)))) & ((_e715.links.w & ~(_e754)) | (~((_e754 ^ _e715.links.w)) & ((_e715.links.w | 2155905152u) - (_e754 & 2139062143u))))) & (((_e788 & ~(_e715.x.y)) | (~((_e715.x.y ^ _e788)) & ((_e788 | 2155905152u) - (_e715.x.y & 2139062143u)))) & ((_e715.x.w & ~(_e789)) | (~((_e789 ^ _e715.x.w)) & ((_e715.x.w | 2155905152u) - (_e789 & 2139062143u)))))) & (((_e822 & ~(_e715.y.y)) | (~((_e715.y.y ^ _e822)) & ((_e822 | 2155905152u) - (_e715.y.y & 2139062143u)))) & ((_e715.y.w & ~(_e823)) | (~((_e823 ^ _e715.y.w)) & ((_e715.y.w | 2155905152u) - (_e823 & 2139062143u)))))) & ((_e715.z.y & ~(_e857)) | (~((_e857 ^ _e715.z.y)) & ((_e715.z.y | 2155905152u) - (_e857 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                if ((_e715.z.w & 2147483648u) != 0u) {
                                    phi_1370_ = _e717;
                                    phi_967_ = (_e715.z.w & 2147483647u);
                                    phi_969_ = _e1038;
                                    phi_1371_ = _e683;
                                } else {
                                    if (_e1038 == 0u) {
                                        phi_1368_ = _e717;
                                        phi_1369_ = _e683;
                                    } else {
                                        if ((_e717 & 255u) == 0u) {
                                            phi_1363_ = _e683;
                                        } else {
                                            if (_e683 < 32u) {
                                                if (_e683 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1[(0u + _e683)] = _e717;
                                                phi_1362_ = (_e683 + 1u);
                                            } else {
                                                phi_1362_ = _e683;
                                            }
                                            let _e1055 = phi_1362_;
                                            phi_1363_ = _e1055;
                                        }
                                        let _e1057 = phi_1363_;
                                        phi_1368_ = (((_e715.z.w & 2147483647u) << bitcast<u32>(8i)) | _e1038);
                                        phi_1369_ = _e1057;
                                    }
                                    let _e1065 = phi_1368_;
                                    let _e1067 = phi_1369_;
                                    phi_1370_ = _e1065;
                                    phi_967_ = _e679;
                                    phi_969_ = _e681;
                                    phi_1371_ = _e1067;
                                }
                                let _e1069 = phi_1370_;
                                let _e1071 = phi_967_;
                                let _e1073 = phi_969_;
                                let _e1075 = phi_1371_;
                                local_4 = _e1073;
                                local_16 = _e1073;
                                local_5 = _e1071;
                                if ((_e1069 & 255u) == 0u) {
                                    if (_e1075 > 0u) {
                                        let _e1079 = (_e1075 - 1u);
                                        if (_e1079 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1083 = local_1[(0u + _e1079)];
                                        phi_1389_ = _e1083;
                                        phi_1390_ = _e1079;
                                    } else {
                                        phi_1389_ = 0u;
                                        phi_1390_ = _e1075;
                                    }
                                    let _e1085 = phi_1389_;
                                    let _e1087 = phi_1390_;
                                    phi_957_ = _e1085;
                                    phi_960_ = _e1087;
                                } else {
                                    phi_957_ = _e1069;
                                    phi_960_ = _e1075;
                                }
                                let _e1089 = phi_957_;
                                let _e1091 = phi_960_;
                                local_14 = _e1089;
                                local_15 = _e1091;
                                local_7 = _e1089;
                                if (_e1073 == 0u) {
                                    let _e1093 = (_e1089 == 0u);
                                    if _e1093 {
                                        phi_1399_ = false;
                                    } else {
                                        phi_1399_ = true;
                                    }
                                    let _e1095 = phi_1399_;
                                    phi_1400_ = _e1095;
                                    phi_1401_ = _e1093;
                                } else {
                                    phi_1400_ = false;
                                    phi_1401_ = false;
                                }
                                let _e1097 = phi_1400_;
                                let _e1099 = phi_1401_;
                                local_3 = _e1099;
                                continue;
                                continuing {
                                    phi_964_ = _e1089;
                                    phi_966_ = _e1071;
                                    phi_968_ = _e1073;
                                    phi_970_ = _e1091;
                                    break if !(_e1097);
                                }
                            }
                            let _e1102 = local_3;
                            if _e1102 {
                            }
                            let _e1104 = local_4;
                            if (_e1104 == 0u) {
                                phi_2066_ = true;
                                phi_2067_ = false;
                                phi_2068_ = false;
                            } else {
                                let _e3198 = local_16;
                                phi_1410_ = _e3198;
                                loop {
                                    let _e1107 = phi_1410_;
                                    let _e1110 = select(firstTrailingBit(_e1107), 32u, (_e1107 == 0u));
                                    let _e1114 = local_5;
                                    let _e1115 = (_e1114 + (_e1110 >> bitcast<u32>(2i)));
                                    if (_e1115 < _e85) {
                                    } else {
                                        return;
                                    }
                                    let _e1120 = rows.member[(0u + _e1115)][0u];
                                    let _e1124 = rows.member[(0u + _e1115)][1u];
                                    let _e1128 = rows.member[(0u + _e1115)][2u];
                                    let _e1132 = rows.member[(0u + _e1115)][3u];
                                    if ((_e1110 & 2u) == 0u) {
                                        phi_1445_ = _e1124;
                                        phi_1446_ = _e1120;
                                    } else {
                                        phi_1445_ = _e1132;
                                        phi_1446_ = _e1128;
                                    }
                                    let _e1136 = phi_1445_;
                                    let _e1138 = phi_1446_;
                                    if ((_e1110 & 1u) == 0u) {
                                        phi_1452_ = _e1138;
                                    } else {
                                        phi_1452_ = _e1136;
                                    }
                                    let _e1142 = phi_1452_;
                                    let _e1144 = (_e1107 & (_e1107 - 1u));
                                    if (_e1142 < _e79) {
                                    } else {
                                        return;
                                    }
                                    let _e1149 = triangles.member[(0u + _e1142)].v0_;
                                    let _e1151 = (_e1149.x - _e253);
                                    let _e1153 = (_e1149.y - _e255);
                                    let _e1155 = (_e1149.z - _e257);
                                    if (_e652 == 0u) {
                                        phi_1481_ = vec3<f32>(_e1153, _e1155, _e1151);
                                    } else {
                                        if (_e652 == 1u) {
                                            phi_1480_ = vec3<f32>(_e1155, _e1151, _e1153);
                                        } else {
                                            phi_1480_ = (_e1149 - vec3<f32>(_e253, _e255, _e257));
                                        }
                                        let _e1163 = phi_1480_;
                                        phi_1481_ = _e1163;
                                    }
                                    let _e1165 = phi_1481_;
                                    let _e1169 = (_e1165.x - (_e663 * _e1165.z));
                                    let _e1173 = (_e1165.y - (_e666 * _e1165.z));
                                    let _e1175 = triangles.member[(0u + _e1142)].v1_;
                                    let _e1177 = (_e1175.x - _e253);
                                    let _e1179 = (_e1175.y - _e255);
                                    let _e1181 = (_e1175.z - _e257);
                                    if (_e652 == 0u) {
                                        phi_1511_ = vec3<f32>(_e1179, _e1181, _e1177);
                                    } else {
                                        if (_e652 == 1u) {
                                            phi_1510_ = vec3<f32>(_e1181, _e1177, _e1179);
                                        } else {
                                            phi_1510_ = (_e1175 - vec3<f32>(_e253, _e255, _e257));
                                        }
                                        let _e1189 = phi_1510_;
                                        phi_1511_ = _e1189;
                                    }
                                    let _e1191 = phi_1511_;
                                    let _e1195 = (_e1191.x - (_e663 * _e1191.z));
                                    let _e1199 = (_e1191.y - (_e666 * _e1191.z));
                                    let _e1201 = triangles.member[(0u + _e1142)].v2_;
                                    let _e1203 = (_e1201.x - _e253);
                                    let _e1205 = (_e1201.y - _e255);
                                    let _e1207 = (_e1201.z - _e257);
                                    if (_e652 == 0u) {
                                        phi_1541_ = vec3<f32>(_e1205, _e1207, _e1203);
                                    } else {
                                        if (_e652 == 1u) {
                                            phi_1540_ = vec3<f32>(_e1207, _e1203, _e1205);
                                        } else {
                                            phi_1540_ = (_e1201 - vec3<f32>(_e253, _e255, _e257));
                                        }
                                        let _e1215 = phi_1540_;
                                        phi_1541_ = _e1215;
                                    }
                                    let _e1217 = phi_1541_;
                                    let _e1221 = (_e1217.x - (_e663 * _e1217.z));
                                    let _e1225 = (_e1217.y - (_e666 * _e1217.z));
                                    if (_e1195 < _e1221) {
                                        phi_1560_ = true;
                                    } else {
                                        if (_e1195 == _e1221) {
                                            phi_1559_ = (_e1199 < _e1225);
                                        } else {
                                            phi_1559_ = false;
                                        }
                                        let _e1230 = phi_1559_;
                                        phi_1560_ = _e1230;
                                    }
                                    let _e1232 = phi_1560_;
                                    if _e1232 {
                                        phi_1564_ = _e1225;
                                        phi_1565_ = _e1221;
                                        phi_1566_ = _e1199;
                                        phi_1567_ = _e1195;
                                    } else {
                                        phi_1564_ = _e1199;
                                        phi_1565_ = _e1195;
                                        phi_1566_ = _e1225;
                                        phi_1567_ = _e1221;
                                    }
                                    let _e1234 = phi_1564_;
                                    let _e1236 = phi_1565_;
                                    let _e1238 = phi_1566_;
                                    let _e1240 = phi_1567_;
                                    let _e1243 = ((_e1240 * _e1234) - (_e1238 * _e1236));
                                    if _e1232 {
                                        phi_1575_ = -(_e1243);
                                    } else {
                                        phi_1575_ = _e1243;
                                    }
                                    let _e1246 = phi_1575_;
                                    if (_e1221 < _e1169) {
                                        phi_1586_ = true;
                                    } else {
                                        if (_e1221 == _e1169) {
                                            phi_1585_ = (_e1225 < _e1173);
                                        } else {
                                            phi_1585_ = false;
                                        }
                                        let _e1251 = phi_1585_;
                                        phi_1586_ = _e1251;
                                    }
                                    let _e1253 = phi_1586_;
                                    if _e1253 {
                                        phi_1590_ = _e1173;
                                        phi_1591_ = _e1169;
                                        phi_1592_ = _e1225;
                                        phi_1593_ = _e1221;
                                    } else {
                                        phi_1590_ = _e1225;
                                        phi_1591_ = _e1221;
                                        phi_1592_ = _e1173;
                                        phi_1593_ = _e1169;
                                    }
                                    let _e1255 = phi_1590_;
                                    let _e1257 = phi_1591_;
                                    let _e1259 = phi_1592_;
                                    let _e1261 = phi_1593_;
                                    let _e1264 = ((_e1261 * _e1255) - (_e1259 * _e1257));
                                    if _e1253 {
                                        phi_1601_ = -(_e1264);
                                    } else {
                                        phi_1601_ = _e1264;
                                    }
                                    let _e1267 = phi_1601_;
                                    if (_e1169 < _e1195) {
                                        phi_1612_ = true;
                                    } else {
                                        if (_e1169 == _e1195) {
                                            phi_1611_ = (_e1173 < _e1199);
                                        } else {
                                            phi_1611_ = false;
                                        }
                                        let _e1272 = phi_1611_;
                                        phi_1612_ = _e1272;
                                    }
                                    let _e1274 = phi_1612_;
                                    if _e1274 {
                                        phi_1616_ = _e1199;
                                        phi_1617_ = _e1195;
                                        phi_1618_ = _e1173;
                                        phi_1619_ = _e1169;
                                    } else {
                                        phi_1616_ = _e1173;
                                        phi_1617_ = _e1169;
                                        phi_1618_ = _e1199;
                                        phi_1619_ = _e1195;
                                    }
                                    let _e1276 = phi_1616_;
                                    let _e1278 = phi_1617_;
                                    let _e1280 = phi_1618_;
                                    let _e1282 = phi_1619_;
                                    let _e1285 = ((_e1282 * _e1276) - (_e1280 * _e1278));
                                    if _e1274 {
                                        phi_1627_ = -(_e1285);
                                    } else {
                                        phi_1627_ = _e1285;
                                    }
                                    let _e1288 = phi_1627_;
                                    if (_e1246 >= 0f) {
                                        if (_e1267 >= 0f) {
                                            if (_e1288 >= 0f) {
                                                phi_1642_ = ((_e1246 + _e1267) + _e1288);
                                                phi_1643_ = false;
                                            } else {
                                                phi_1642_ = f32();
                                                phi_1643_ = true;
                                            }
                                            let _e1295 = phi_1642_;
                                            let _e1297 = phi_1643_;
                                            phi_1644_ = _e1295;
                                            phi_1645_ = _e1297;
                                        } else {
                                            phi_1644_ = f32();
                                            phi_1645_ = true;
                                        }
                                        let _e1299 = phi_1644_;
                                        let _e1301 = phi_1645_;
                                        phi_1646_ = _e1299;
                                        phi_1647_ = _e1301;
                                    } else {
                                        phi_1646_ = f32();
                                        phi_1647_ = true;
                                    }
                                    let _e1303 = phi_1646_;
                                    let _e1305 = phi_1647_;
                                    if _e1305 {
                                        if (_e1246 <= 0f) {
                                            if (_e1267 <= 0f) {
                                                let _e1308 = (_e1288 <= 0f);
                                                if _e1308 {
                                                }
                                                phi_1665_ = ((_e1246 + _e1267) + _e1288);
                                                phi_1666_ = false;
                                                phi_1667_ = _e1308;
                                            } else {
                                                phi_1665_ = f32();
                                                phi_1666_ = true;
                                                phi_1667_ = false;
                                            }
                                            let _e1312 = phi_1665_;
                                            let _e1314 = phi_1666_;
                                            let _e1316 = phi_1667_;
                                            phi_1668_ = _e1312;
                                            phi_1669_ = _e1314;
                                            phi_1670_ = _e1316;
                                        } else {
                                            phi_1668_ = f32();
                                            phi_1669_ = true;
                                            phi_1670_ = false;
                                        }
                                        let _e1318 = phi_1668_;
                                        let _e1320 = phi_1669_;
                                        let _e1322 = phi_1670_;
                                        if _e1320 {
                                            phi_1674_ = false;
                                        } else {
                                            phi_1674_ = _e1322;
                                        }
                                        let _e1324 = phi_1674_;
                                        phi_1675_ = _e1318;
                                        phi_1676_ = _e1324;
                                    } else {
                                        phi_1675_ = _e1303;
                                        phi_1676_ = true;
                                    }
                                    let _e1326 = phi_1675_;
                                    let _e1328 = phi_1676_;
                                    if _e1328 {
                                        let _e1329 = (_e1326 == 0f);
                                        if _e1329 {
                                            phi_1992_ = lt_bvh_triangle_Intersection();
                                            phi_1993_ = false;
                                        } else {
                                            let _e1331 = triangles.member[(0u + _e1142)].v0_;
                                            let _e1333 = (_e1331.x - _e253);
                                            let _e1335 = (_e1331.y - _e255);
                                            let _e1337 = (_e1331.z - _e257);
                                            if (_e652 == 0u) {
                                                phi_1705_ = vec3<f32>(_e1335, _e1337, _e1333);
                                            } else {
                                                if (_e652 == 1u) {
                                                    phi_1704_ = vec3<f32>(_e1337, _e1333, _e1335);
                                                } else {
                                                    phi_1704_ = (_e1331 - vec3<f32>(_e253, _e255, _e257));
                                                }
                                                let _e1345 = phi_1704_;
                                                phi_1705_ = _e1345;
                                            }
                                            let _e1347 = phi_1705_;
                                            let _e1349 = triangles.member[(0u + _e1142)].v1_;
                                            let _e1351 = triangles.member[(0u + _e1142)].v0_;
                                            let _e1354 = (_e1349.x - _e1351.x);
                                            let _e1357 = (_e1349.y - _e1351.y);
                                            let _e1360 = (_e1349.z - _e1351.z);
                                            if (_e652 == 0u) {
                                                phi_1731_ = vec3<f32>(_e1357, _e1360, _e1354);
                                            } else {
                                                if (_e652 == 1u) {
                                                    phi_1730_ = vec3<f32>(_e1360, _e1354, _e1357);
                                                } else {
                                                    phi_1730_ = (_e1349 - _e1351);
                                                }
                                                let _e1367 = phi_1730_;
                                                phi_1731_ = _e1367;
                                            }
                                            let _e1369 = phi_1731_;
                                            let _e1371 = triangles.member[(0u + _e1142)].v2_;
                                            let _e1373 = triangles.member[(0u + _e1142)].v0_;
                                            let _e1376 = (_e1371.x - _e1373.x);
                                            let _e1379 = (_e1371.y - _e1373.y);
                                            let _e1382 = (_e1371.z - _e1373.z);
                                            if (_e652 == 0u) {
                                                phi_1757_ = vec3<f32>(_e1379, _e1382, _e1376);
                                            } else {
                                                if (_e652 == 1u) {
                                                    phi_1756_ = vec3<f32>(_e1382, _e1376, _e1379);
                                                } else {
                                                    phi_1756_ = (_e1371 - _e1373);
                                                }
                                                let _e1389 = phi_1756_;
                                                phi_1757_ = _e1389;
                                            }
                                            let _e1391 = phi_1757_;
                                            let _e1398 = ((_e1369.y * _e1391.z) - (_e1369.z * _e1391.y));
                                            let _e1405 = ((_e1369.z * _e1391.x) - (_e1369.x * _e1391.z));
                                            let _e1412 = ((_e1369.x * _e1391.y) - (_e1369.y * _e1391.x));
                                            let _e1426 = (((1f / _e660.z) * (((_e1398 * _e1347.x) + (_e1405 * _e1347.y)) + (_e1412 * _e1347.z))) / (((_e1398 * _e663) + (_e1405 * _e666)) + _e1412));
                                            if (_e1426 > 0f) {
                                                if (_e1426 < _e265) {
                                                    let _e1430 = triangles.member[(0u + _e1142)].v0_;
                                                    let _e1432 = triangles.member[(0u + _e1142)].v1_;
                                                    if (_e1430.x < _e1432.x) {
                                                        phi_1813_ = _e1430.x;
                                                    } else {
                                                        phi_1813_ = _e1432.x;
                                                    }
                                                    let _e1439 = phi_1813_;
                                                    if (_e1430.y < _e1432.y) {
                                                        phi_1822_ = _e1430.y;
                                                    } else {
                                                        phi_1822_ = _e1432.y;
                                                    }
                                                    let _e1446 = phi_1822_;
                                                    if (_e1430.z < _e1432.z) {
                                                        phi_1831_ = _e1430.z;
                                                    } else {
                                                        phi_1831_ = _e1432.z;
                                                    }
                                                    let _e1453 = phi_1831_;
                                                    let _e1455 = triangles.member[(0u + _e1142)].v2_;
                                                    if (_e1439 < _e1455.x) {
                                                        phi_1840_ = _e1439;
                                                    } else {
                                                        phi_1840_ = _e1455.x;
                                                    }
                                                    let _e1460 = phi_1840_;
                                                    if (_e1446 < _e1455.y) {
                                                        phi_1847_ = _e1446;
                                                    } else {
                                                        phi_1847_ = _e1455.y;
                                                    }
                                                    let _e1465 = phi_1847_;
                                                    if (_e1453 < _e1455.z) {
                                                        phi_1854_ = _e1453;
                                                    } else {
                                                        phi_1854_ = _e1455.z;
                                                    }
                                                    let _e1470 = phi_1854_;
                                                    let _e1472 = triangles.member[(0u + _e1142)].v0_;
                                                    let _e1474 = triangles.member[(0u + _e1142)].v1_;
                                                    if (_e1472.x > _e1474.x) {
                                                        phi_1867_ = _e1472.x;
                                                    } else {
                                                        phi_1867_ = _e1474.x;
                                                    }
                                                    let _e1481 = phi_1867_;
                                                    if (_e1472.y > _e1474.y) {
                                                        phi_1876_ = _e1472.y;
                                                    } else {
                                                        phi_1876_ = _e1474.y;
                                                    }
                                                    let _e1488 = phi_1876_;
                                                    if (_e1472.z > _e1474.z) {
                                                        phi_1885_ = _e1472.z;
                                                    } else {
                                                        phi_1885_ = _e1474.z;
                                                    }
                                                    let _e1495 = phi_1885_;
                                                    let _e1497 = triangles.member[(0u + _e1142)].v2_;
                                                    if (_e1481 > _e1497.x) {
                                                        phi_1894_ = _e1481;
                                                    } else {
                                                        phi_1894_ = _e1497.x;
                                                    }
                                                    let _e1502 = phi_1894_;
                                                    if (_e1488 > _e1497.y) {
                                                        phi_1901_ = _e1488;
                                                    } else {
                                                        phi_1901_ = _e1497.y;
                                                    }
                                                    let _e1507 = phi_1901_;
                                                    if (_e1495 > _e1497.z) {
                                                        phi_1908_ = _e1495;
                                                    } else {
                                                        phi_1908_ = _e1497.z;
                                                    }
                                                    let _e1512 = phi_1908_;
                                                    let _e1516 = ((_e1460 - _e253) * _e581);
                                                    let _e1517 = ((_e1465 - _e255) * _e591);
                                                    let _e1518 = ((_e1470 - _e257) * _e601);
                                                    let _e1522 = ((_e1502 - _e253) * _e581);
                                                    let _e1523 = ((_e1507 - _e255) * _e591);
                                                    let _e1524 = ((_e1512 - _e257) * _e601);
                                                    if (_e1516 < _e1522) {
                                                        phi_1925_ = _e1516;
                                                    } else {
                                                        phi_1925_ = _e1522;
                                                    }
                                                    let _e1527 = phi_1925_;
                                                    if (_e1517 < _e1523) {
                                                        phi_1930_ = _e1517;
                                                    } else {
                                                        phi_1930_ = _e1523;
                                                    }
                                                    let _e1530 = phi_1930_;
                                                    if (_e1518 < _e1524) {
                                                        phi_1935_ = _e1518;
                                                    } else {
                                                        phi_1935_ = _e1524;
                                                    }
                                                    let _e1533 = phi_1935_;
                                                    if (_e1516 > _e1522) {
                                                        phi_1943_ = _e1516;
                                                    } else {
                                                        phi_1943_ = _e1522;
                                                    }
                                                    let _e1539 = phi_1943_;
                                                    if (_e1517 > _e1523) {
                                                        phi_1948_ = _e1517;
                                                    } else {
                                                        phi_1948_ = _e1523;
                                                    }
                                                    let _e1542 = phi_1948_;
                                                    if (_e1518 > _e1524) {
                                                        phi_1953_ = _e1518;
                                                    } else {
                                                        phi_1953_ = _e1524;
                                                    }
                                                    let _e1545 = phi_1953_;
                                                    let _e1549 = core_intrinsics_maximum_number_nsz_f32_((_e1527 - _e636), (_e1530 - _e637));
                                                    let _e1550 = core_intrinsics_maximum_number_nsz_f32_(_e1549, (_e1533 - _e638));
                                                    let _e1551 = core_intrinsics_minimum_number_nsz_f32_((_e1539 + _e636), (_e1542 + _e637));
                                                    let _e1552 = core_intrinsics_minimum_number_nsz_f32_(_e1551, (_e1545 + _e638));
                                                    if (_e1550 > -300000000000000000000000000000000000000f) {
                                                        phi_1965_ = _e1550;
                                                    } else {
                                                        phi_1965_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1555 = phi_1965_;
                                                    if (_e1552 < 300000000000000000000000000000000000000f) {
                                                        phi_1970_ = _e1552;
                                                    } else {
                                                        phi_1970_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1558 = phi_1970_;
                                                    if (_e1426 < _e1555) {
                                                        phi_1975_ = _e1555;
                                                    } else {
                                                        phi_1975_ = _e1426;
                                                    }
                                                    let _e1561 = phi_1975_;
                                                    if (_e1561 > _e1558) {
                                                        phi_1980_ = _e1558;
                                                    } else {
                                                        phi_1980_ = _e1561;
                                                    }
                                                    let _e1564 = phi_1980_;
                                                    phi_1985_ = lt_bvh_triangle_Intersection(_e1564, (_e1267 / _e1326), (_e1288 / _e1326), (_e1555 <= _e1558));
                                                    phi_1986_ = false;
                                                } else {
                                                    phi_1985_ = lt_bvh_triangle_Intersection();
                                                    phi_1986_ = true;
                                                }
                                                let _e1570 = phi_1985_;
                                                let _e1572 = phi_1986_;
                                                phi_1987_ = _e1570;
                                                phi_1988_ = _e1572;
                                            } else {
                                                phi_1987_ = lt_bvh_triangle_Intersection();
                                                phi_1988_ = true;
                                            }
                                            let _e1574 = phi_1987_;
                                            let _e1576 = phi_1988_;
                                            if _e1576 {
                                            }
                                            phi_1992_ = _e1574;
                                            phi_1993_ = _e1576;
                                        }
                                        let _e1578 = phi_1992_;
                                        let _e1580 = phi_1993_;
                                        phi_1994_ = _e1578;
                                        phi_1995_ = _e1329;
                                        phi_1996_ = _e1580;
                                    } else {
                                        phi_1994_ = lt_bvh_triangle_Intersection();
                                        phi_1995_ = true;
                                        phi_1996_ = false;
                                    }
                                    let _e1582 = phi_1994_;
                                    let _e1584 = phi_1995_;
                                    let _e1586 = phi_1996_;
                                    if _e1584 {
                                        phi_2000_ = true;
                                    } else {
                                        phi_2000_ = _e1586;
                                    }
                                    let _e1588 = phi_2000_;
                                    if _e1588 {
                                        phi_2004_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2004_ = _e1582;
                                    }
                                    let _e1590 = phi_2004_;
                                    if _e1590.is_hit {
                                        if (_e1590.t > 0f) {
                                            if (_e1590.t < _e265) {
                                                let _e1597 = triangles.member[(0u + _e1142)].i0_;
                                                let _e1599 = ((_e1597 & 2147483648u) == 0u);
                                                if _e1599 {
                                                    phi_2030_ = false;
                                                    phi_2031_ = false;
                                                } else {
                                                    if true {
                                                        phi_2029_ = false;
                                                    } else {
                                                        phi_2029_ = true;
                                                    }
                                                    let _e1601 = phi_2029_;
                                                    phi_2030_ = _e1601;
                                                    phi_2031_ = true;
                                                }
                                                let _e1603 = phi_2030_;
                                                let _e1605 = phi_2031_;
                                                phi_2032_ = _e1603;
                                                phi_2033_ = _e1599;
                                                phi_2034_ = _e1605;
                                            } else {
                                                phi_2032_ = true;
                                                phi_2033_ = false;
                                                phi_2034_ = false;
                                            }
                                            let _e1607 = phi_2032_;
                                            let _e1609 = phi_2033_;
                                            let _e1611 = phi_2034_;
                                            phi_2035_ = false;
                                            phi_2036_ = _e1607;
                                            phi_2037_ = _e1609;
                                            phi_2038_ = _e1611;
                                        } else {
                                            phi_2035_ = true;
                                            phi_2036_ = false;
                                            phi_2037_ = false;
                                            phi_2038_ = false;
                                        }
                                        let _e1613 = phi_2035_;
                                        let _e1615 = phi_2036_;
                                        let _e1617 = phi_2037_;
                                        let _e1619 = phi_2038_;
                                        phi_2039_ = _e1613;
                                        phi_2040_ = _e1615;
                                        phi_2041_ = _e1617;
                                        phi_2042_ = _e1619;
                                    } else {
                                        phi_2039_ = true;
                                        phi_2040_ = false;
                                        phi_2041_ = false;
                                        phi_2042_ = false;
                                    }
                                    let _e1621 = phi_2039_;
                                    let _e1623 = phi_2040_;
                                    let _e1625 = phi_2041_;
                                    let _e1627 = phi_2042_;
                                    if _e1621 {
                                        phi_2046_ = true;
                                        phi_2047_ = false;
                                        phi_2048_ = false;
                                    } else {
                                        phi_2046_ = _e1623;
                                        phi_2047_ = _e1625;
                                        phi_2048_ = _e1627;
                                    }
                                    let _e1629 = phi_2046_;
                                    let _e1631 = phi_2047_;
                                    let _e1633 = phi_2048_;
                                    if _e1629 {
                                        let _e1634 = (_e1144 == 0u);
                                        if _e1634 {
                                            phi_2056_ = false;
                                        } else {
                                            phi_2056_ = true;
                                        }
                                        let _e1636 = phi_2056_;
                                        phi_2057_ = _e1636;
                                        phi_2058_ = _e1634;
                                        phi_2059_ = false;
                                        phi_2060_ = false;
                                    } else {
                                        phi_2057_ = false;
                                        phi_2058_ = false;
                                        phi_2059_ = _e1631;
                                        phi_2060_ = _e1633;
                                    }
                                    let _e1638 = phi_2057_;
                                    let _e1640 = phi_2058_;
                                    let _e1642 = phi_2059_;
                                    let _e1644 = phi_2060_;
                                    local_6 = _e1640;
                                    local_17 = _e1642;
                                    local_18 = _e1644;
                                    local_19 = _e1640;
                                    continue;
                                    continuing {
                                        phi_1410_ = _e1144;
                                        break if !(_e1638);
                                    }
                                }
                                let _e1647 = local_6;
                                if _e1647 {
                                    phi_2064_ = false;
                                    phi_2065_ = false;
                                } else {
                                    let _e3309 = local_17;
                                    phi_2064_ = _e3309;
                                    let _e3312 = local_18;
                                    phi_2065_ = _e3312;
                                }
                                let _e1649 = phi_2064_;
                                let _e1651 = phi_2065_;
                                let _e3315 = local_19;
                                phi_2066_ = _e3315;
                                phi_2067_ = _e1649;
                                phi_2068_ = _e1651;
                            }
                            let _e1653 = phi_2066_;
                            let _e1655 = phi_2067_;
                            let _e1657 = phi_2068_;
                            if _e1653 {
                                let _e1659 = local_7;
                                if (_e1659 == 0u) {
                                    phi_2076_ = false;
                                } else {
                                    phi_2076_ = true;
                                }
                                let _e1662 = phi_2076_;
                                phi_2077_ = _e1662;
                                phi_2078_ = false;
                                phi_2079_ = false;
                            } else {
                                phi_2077_ = false;
                                phi_2078_ = _e1655;
                                phi_2079_ = _e1657;
                            }
                            let _e1664 = phi_2077_;
                            let _e1666 = phi_2078_;
                            let _e1668 = phi_2079_;
                            local_8 = _e1666;
                            local_20 = _e1668;
                            local_21 = _e1666;
                            continue;
                            continuing {
                                let _e3159 = local_14;
                                phi_956_ = _e3159;
                                let _e3162 = local_15;
                                phi_959_ = _e3162;
                                break if !(_e1664);
                            }
                        }
                        let _e1671 = local_8;
                        if _e1671 {
                            phi_2083_ = false;
                        } else {
                            let _e3326 = local_20;
                            phi_2083_ = _e3326;
                        }
                        let _e1673 = phi_2083_;
                        if _e1673 {
                            phi_2087_ = true;
                        } else {
                            let _e3329 = local_21;
                            phi_2087_ = _e3329;
                        }
                        let _e1675 = phi_2087_;
                        if _e1675 {
                            phi_2091_ = true;
                        } else {
                            phi_2091_ = false;
                        }
                        let _e1677 = phi_2091_;
                        phi_2092_ = _e1677;
                    }
                    let _e1679 = phi_2092_;
                    phi_3549_ = _e1679;
                } else {
                    let _e1680 = abs(_e273);
                    let _e1681 = abs(_e274);
                    let _e1682 = abs(_e275);
                    if (abs(_e253) < 1000000000000000f) {
                        if (abs(_e255) < 1000000000000000f) {
                            phi_2108_ = (abs(_e257) < 1000000000000000f);
                            phi_2109_ = false;
                        } else {
                            phi_2108_ = bool();
                            phi_2109_ = true;
                        }
                        let _e1690 = phi_2108_;
                        let _e1692 = phi_2109_;
                        phi_2110_ = _e1690;
                        phi_2111_ = _e1692;
                    } else {
                        phi_2110_ = bool();
                        phi_2111_ = true;
                    }
                    let _e1694 = phi_2110_;
                    let _e1696 = phi_2111_;
                    if _e1696 {
                        phi_2115_ = false;
                    } else {
                        phi_2115_ = _e1694;
                    }
                    let _e1698 = phi_2115_;
                    if _e1698 {
                        if (_e1680 < 1000000000000000f) {
                            if (_e1681 < 1000000000000000f) {
                                phi_2128_ = (_e1682 < 1000000000000000f);
                                phi_2129_ = false;
                            } else {
                                phi_2128_ = bool();
                                phi_2129_ = true;
                            }
                            let _e1703 = phi_2128_;
                            let _e1705 = phi_2129_;
                            phi_2130_ = _e1703;
                            phi_2131_ = _e1705;
                        } else {
                            phi_2130_ = bool();
                            phi_2131_ = true;
                        }
                        let _e1707 = phi_2130_;
                        let _e1709 = phi_2131_;
                        if _e1709 {
                            phi_2135_ = false;
                        } else {
                            phi_2135_ = _e1707;
                        }
                        let _e1711 = phi_2135_;
                        if _e1711 {
                            if (_e1680 > 0f) {
                                phi_2149_ = bool();
                                phi_2150_ = true;
                            } else {
                                let _e1713 = (_e1681 > 0f);
                                if _e1713 {
                                    phi_2148_ = bool();
                                } else {
                                    phi_2148_ = (_e1682 > 0f);
                                }
                                let _e1716 = phi_2148_;
                                phi_2149_ = _e1716;
                                phi_2150_ = _e1713;
                            }
                            let _e1718 = phi_2149_;
                            let _e1720 = phi_2150_;
                            if _e1720 {
                                phi_2154_ = true;
                            } else {
                                phi_2154_ = _e1718;
                            }
                            let _e1722 = phi_2154_;
                            phi_2155_ = _e1722;
                            phi_2156_ = false;
                        } else {
                            phi_2155_ = bool();
                            phi_2156_ = true;
                        }
                        let _e1724 = phi_2155_;
                        let _e1726 = phi_2156_;
                        phi_2157_ = _e1724;
                        phi_2158_ = _e1726;
                    } else {
                        phi_2157_ = bool();
                        phi_2158_ = true;
                    }
                    let _e1728 = phi_2157_;
                    let _e1730 = phi_2158_;
                    if _e1730 {
                        phi_2162_ = false;
                    } else {
                        phi_2162_ = _e1728;
                    }
                    let _e1732 = phi_2162_;
                    if _e1732 {
                        let _e1733 = (0u >= _e76);
                        if _e1733 {
                            phi_3542_ = bool();
                        } else {
                            if (0u < _e76) {
                            } else {
                                return;
                            }
                            let _e1739 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1743 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1747 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1751 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1755 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1759 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1763 = nodes.member[(0u + 0u)].frame[3u];
                            let _e1797 = core_intrinsics_maximum_number_nsz_f32_(abs(_e273), abs(_e274));
                            let _e1798 = core_intrinsics_maximum_number_nsz_f32_(_e1797, abs(_e275));
                            let _e1799 = (_e1798 * 0.0000000000009094947f);
                            if (abs(_e273) < _e1799) {
                                phi_2232_ = _e1799;
                            } else {
                                phi_2232_ = abs(_e273);
                            }
                            let _e1804 = phi_2232_;
                            if (_e273 < 0f) {
                                phi_2239_ = (-1f / _e1804);
                            } else {
                                phi_2239_ = (1f / _e1804);
                            }
                            let _e1809 = phi_2239_;
                            if (abs(_e274) < _e1799) {
                                phi_2246_ = _e1799;
                            } else {
                                phi_2246_ = abs(_e274);
                            }
                            let _e1814 = phi_2246_;
                            if (_e274 < 0f) {
                                phi_2253_ = (-1f / _e1814);
                            } else {
                                phi_2253_ = (1f / _e1814);
                            }
                            let _e1819 = phi_2253_;
                            if (abs(_e275) < _e1799) {
                                phi_2260_ = _e1799;
                            } else {
                                phi_2260_ = abs(_e275);
                            }
                            let _e1824 = phi_2260_;
                            if (_e275 < 0f) {
                                phi_2267_ = (-1f / _e1824);
                            } else {
                                phi_2267_ = (1f / _e1824);
                            }
                            let _e1829 = phi_2267_;
                            let _e1833 = abs((bitcast<f32>(_e1739) - _e253));
                            let _e1834 = abs((bitcast<f32>(_e1743) - _e255));
                            let _e1835 = abs((bitcast<f32>(_e1747) - _e257));
                            let _e1839 = abs(((bitcast<f32>(_e1751) + (bitcast<f32>((((_e1763 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e253));
                            let _e1840 = abs(((bitcast<f32>(_e1755) + (bitcast<f32>((((_e1763 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e255));
                            let _e1841 = abs(((bitcast<f32>(_e1759) + (bitcast<f32>((((_e1763 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e257));
                            if (_e1833 > _e1839) {
                                phi_2284_ = _e1833;
                            } else {
                                phi_2284_ = _e1839;
                            }
                            let _e1844 = phi_2284_;
                            if (_e1834 > _e1840) {
                                phi_2289_ = _e1834;
                            } else {
                                phi_2289_ = _e1840;
                            }
                            let _e1847 = phi_2289_;
                            if (_e1835 > _e1841) {
                                phi_2294_ = _e1835;
                            } else {
                                phi_2294_ = _e1841;
                            }
                            let _e1850 = phi_2294_;
                            if (_e1844 > _e1847) {
                                phi_2299_ = _e1844;
                            } else {
                                phi_2299_ = _e1847;
                            }
                            let _e1853 = phi_2299_;
                            if (_e1853 > _e1850) {
                                phi_2304_ = _e1853;
                            } else {
                                phi_2304_ = _e1850;
                            }
                            let _e1856 = phi_2304_;
                            let _e1860 = (_e1856 * 0.0000019073486f);
                            let _e1861 = (abs(_e1809) * _e1860);
                            let _e1862 = (abs(_e1819) * _e1860);
                            let _e1863 = (abs(_e1829) * _e1860);
                            let _e1867 = (_e1856 * 0.0000009536743f);
                            let _e1868 = (abs(_e1809) * _e1867);
                            let _e1869 = (abs(_e1819) * _e1867);
                            let _e1870 = (abs(_e1829) * _e1867);
                            let _e1871 = abs(_e273);
                            let _e1872 = abs(_e274);
                            let _e1873 = abs(_e275);
                            if (_e1871 >= _e1872) {
                                if (_e1871 >= _e1873) {
                                    phi_2330_ = false;
                                } else {
                                    phi_2330_ = true;
                                }
                                let _e1877 = phi_2330_;
                                phi_2331_ = _e1877;
                            } else {
                                phi_2331_ = true;
                            }
                            let _e1879 = phi_2331_;
                            if _e1879 {
                                if (_e1872 >= _e1873) {
                                    phi_2339_ = 1u;
                                } else {
                                    phi_2339_ = 2u;
                                }
                                let _e1882 = phi_2339_;
                                phi_2340_ = _e1882;
                            } else {
                                phi_2340_ = 0u;
                            }
                            let _e1884 = phi_2340_;
                            if (_e1884 == 0u) {
                                phi_2352_ = vec3<f32>(_e274, _e275, _e273);
                            } else {
                                if (_e1884 == 1u) {
                                    phi_2351_ = vec3<f32>(_e275, _e273, _e274);
                                } else {
                                    phi_2351_ = _e276;
                                }
                                let _e1890 = phi_2351_;
                                phi_2352_ = _e1890;
                            }
                            let _e1892 = phi_2352_;
                            let _e1895 = (_e1892.x / _e1892.z);
                            let _e1898 = (_e1892.y / _e1892.z);
                            if (_e1809 < 0f) {
                                phi_2365_ = 0u;
                            } else {
                                phi_2365_ = 1u;
                            }
                            let _e1903 = phi_2365_;
                            if (_e1819 < 0f) {
                                phi_2370_ = 0u;
                            } else {
                                phi_2370_ = 2u;
                            }
                            let _e1906 = phi_2370_;
                            if (_e1829 < 0f) {
                                phi_2375_ = 0u;
                            } else {
                                phi_2375_ = 4u;
                            }
                            let _e1909 = phi_2375_;
                            let _e1911 = ((_e1903 | _e1906) | _e1909);
                            let _e1912 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                            local = lt_bvh_traverse_Stack(array<u32, 32>(_e1912.first[0], _e1912.first[1], _e1912.first[2], _e1912.first[3], _e1912.first[4], _e1912.first[5], _e1912.first[6], _e1912.first[7], _e1912.first[8], _e1912.first[9], _e1912.first[10], _e1912.first[11], _e1912.first[12], _e1912.first[13], _e1912.first[14], _e1912.first[15], _e1912.first[16], _e1912.first[17], _e1912.first[18], _e1912.first[19], _e1912.first[20], _e1912.first[21], _e1912.first[22], _e1912.first[23], _e1912.first[24], _e1912.first[25], _e1912.first[26], _e1912.first[27], _e1912.first[28], _e1912.first[29], _e1912.first[30], _e1912.first[31]), array<u32, 32>(_e1912.mask[0], _e1912.mask[1], _e1912.mask[2], _e1912.mask[3], _e1912.mask[4], _e1912.mask[5], _e1912.mask[6], _e1912.mask[7], _e1912.mask[8], _e1912.mask[9], _e1912.mask[10], _e1912.mask[11], _e1912.mask[12], _e1912.mask[13], _e1912.mask[14], _e1912.mask[15], _e1912.mask[16], _e1912.mask[17], _e1912.mask[18], _e1912.mask[19], _e1912.mask[20], _e1912.mask[21], _e1912.mask[22], _e1912.mask[23], _e1912.mask[24], _e1912.mask[25], _e1912.mask[26], _e1912.mask[27], _e1912.mask[28], _e1912.mask[29], _e1912.mask[30], _e1912.mask[31]), _e1912.len, _e1912.group, _e1912.group_mask);
                            let _e1986 = local.group_mask;
                            if ((_e1986 & 4278190080u) == 0u) {
                                let _e1990 = local.len;
                                if (_e1990 == 0u) {
                                    phi_2489_ = false;
                                } else {
                                    let _e1994 = local.len;
                                    local.len = (_e1994 - 1u);
                                    let _e1997 = local.len;
                                    if (_e1997 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2002 = local.first[(0u + _e1997)];
                                    local.group = _e2002;
                                    let _e2005 = local.len;
                                    if (_e2005 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2010 = local.mask[(0u + _e2005)];
                                    local.group_mask = _e2010;
                                    phi_2489_ = true;
                                }
                                let _e2013 = phi_2489_;
                                phi_2490_ = _e2013;
                            } else {
                                phi_2490_ = true;
                            }
                            let _e2015 = phi_2490_;
                            if _e2015 {
                                let _e2017 = local.group_mask;
                                let _e2023 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2017)), 32u, (_e2017 == 0u)));
                                let _e2027 = local.group_mask;
                                let _e2041 = local.group_mask;
                                local.group_mask = (_e2041 & ~((1u << bitcast<u32>((_e2023 & 31u)))));
                                let _e2044 = local.group;
                                phi_2521_ = (_e2044 + countOneBits(((_e2027 & ~((4294967295u << bitcast<u32>((((_e2023 - 24u) ^ 7u) & 31u))))) & 255u)));
                            } else {
                                phi_2521_ = 4294967295u;
                            }
                            let _e2047 = phi_2521_;
                            phi_2523_ = _e2047;
                            phi_2526_ = false;
                            loop {
                                let _e2049 = phi_2523_;
                                let _e2051 = phi_2526_;
                                local_24 = _e2051;
                                if (_e2049 != 4294967295u) {
                                    if (_e2049 < _e76) {
                                    } else {
                                        return;
                                    }
                                    let _e2058 = nodes.member[(0u + _e2049)].frame[3u];
                                    let _e2083 = (bitcast<f32>((((_e2058 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1809);
                                    let _e2084 = (bitcast<f32>((((_e2058 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1819);
                                    let _e2085 = (bitcast<f32>((((_e2058 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1829);
                                    let _e2088 = nodes.member[(0u + _e2049)].frame[0u];
                                    let _e2092 = nodes.member[(0u + _e2049)].frame[1u];
                                    let _e2096 = nodes.member[(0u + _e2049)].frame[2u];
                                    let _e2101 = ((bitcast<f32>(_e2088) - _e253) * _e1809);
                                    let _e2102 = ((bitcast<f32>(_e2092) - _e255) * _e1819);
                                    let _e2103 = ((bitcast<f32>(_e2096) - _e257) * _e1829);
                                    let _e2111 = nodes.member[(0u + _e2049)].x;
                                    if (_e1809 < 0f) {
                                        let _e2122 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2111.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2128 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2122.unnamed.root, _e2111.w), _e2122.unnamed_1);
                                        let _e2134 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2128.unnamed, lt_bvh_traverse_Tree(_e2111.x, _e2128.unnamed_1.first_primitive));
                                        phi_2606_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2134.unnamed, lt_bvh_traverse_Tree(_e2134.unnamed_1.root, _e2111.y));
                                    } else {
                                        let _e2150 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2111.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2156 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2150.unnamed.root, _e2111.y), _e2150.unnamed_1);
                                        let _e2162 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2156.unnamed, lt_bvh_traverse_Tree(_e2111.z, _e2156.unnamed_1.first_primitive));
                                        phi_2606_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2162.unnamed, lt_bvh_traverse_Tree(_e2162.unnamed_1.root, _e2111.w));
                                    }
                                    let _e2170 = phi_2606_;
                                    let _e2180 = nodes.member[(0u + _e2049)].y;
                                    if (_e1819 < 0f) {
                                        let _e2191 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2180.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2197 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2191.unnamed.root, _e2180.w), _e2191.unnamed_1);
                                        let _e2203 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2197.unnamed, lt_bvh_traverse_Tree(_e2180.x, _e2197.unnamed_1.first_primitive));
                                        phi_2633_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2203.unnamed, lt_bvh_traverse_Tree(_e2203.unnamed_1.root, _e2180.y));
                                    } else {
                                        let _e2219 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2180.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2225 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2219.unnamed.root, _e2180.y), _e2219.unnamed_1);
                                        let _e2231 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2225.unnamed, lt_bvh_traverse_Tree(_e2180.z, _e2225.unnamed_1.first_primitive));
                                        phi_2633_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2231.unnamed, lt_bvh_traverse_Tree(_e2231.unnamed_1.root, _e2180.w));
                                    }
                                    let _e2239 = phi_2633_;
                                    let _e2249 = nodes.member[(0u + _e2049)].z;
                                    if (_e1829 < 0f) {
                                        let _e2260 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2249.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2266 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2260.unnamed.root, _e2249.w), _e2260.unnamed_1);
                                        let _e2272 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2266.unnamed, lt_bvh_traverse_Tree(_e2249.x, _e2266.unnamed_1.first_primitive));
                                        phi_2660_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2272.unnamed, lt_bvh_traverse_Tree(_e2272.unnamed_1.root, _e2249.y));
                                    } else {
                                        let _e2288 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2249.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2294 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2288.unnamed.root, _e2249.y), _e2288.unnamed_1);
                                        let _e2300 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2294.unnamed, lt_bvh_traverse_Tree(_e2249.z, _e2294.unnamed_1.first_primitive));
                                        phi_2660_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2300.unnamed, lt_bvh_traverse_Tree(_e2300.unnamed_1.root, _e2249.w));
                                    }
                                    let _e2308 = phi_2660_;
                                    phi_2666_ = 0u;
                                    phi_2669_ = 0u;
                                    loop {
                                        let _e2318 = phi_2666_;
                                        let _e2320 = phi_2669_;
                                        local_9 = _e2320;
                                        local_10 = _e2320;
                                        local_11 = _e2320;
                                        let _e2321 = (_e2318 < 8u);
                                        if _e2321 {
                                            let _e2323 = (_e2318 >> bitcast<u32>(2i));
                                            let _e2324 = (_e2318 & 3u);
                                            if (_e2323 == 0u) {
                                                phi_2683_ = _e2170.unnamed.root;
                                            } else {
                                                phi_2683_ = _e2170.unnamed.first_primitive;
                                            }
                                            let _e2327 = phi_2683_;
                                            if (_e2323 == 0u) {
                                                phi_2693_ = _e2239.unnamed.root;
                                            } else {
                                                phi_2693_ = _e2239.unnamed.first_primitive;
                                            }
                                            let _e2336 = phi_2693_;
                                            if (_e2323 == 0u) {
                                                phi_2703_ = _e2308.unnamed.root;
                                            } else {
                                                phi_2703_ = _e2308.unnamed.first_primitive;
                                            }
                                            let _e2345 = phi_2703_;
                                            let _e2358 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2327 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u)) * _e2083) + (_e2101 - _e1861)), ((f32(((_e2336 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u)) * _e2084) + (_e2102 - _e1862)));
                                            let _e2359 = core_intrinsics_maximum_number_nsz_f32_(_e2358, ((f32(((_e2345 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u)) * _e2085) + (_e2103 - _e1863)));
                                            if (_e2323 == 0u) {
                                                phi_2721_ = _e2170.unnamed_1.root;
                                            } else {
                                                phi_2721_ = _e2170.unnamed_1.first_primitive;
                                            }
                                            let _e2362 = phi_2721_;
                                            if (_e2323 == 0u) {
                                                phi_2731_ = _e2239.unnamed_1.root;
                                            } else {
                                                phi_2731_ = _e2239.unnamed_1.first_primitive;
                                            }
                                            let _e2371 = phi_2731_;
                                            if (_e2323 == 0u) {
                                                phi_2741_ = _e2308.unnamed_1.root;
                                            } else {
                                                phi_2741_ = _e2308.unnamed_1.first_primitive;
                                            }
                                            let _e2380 = phi_2741_;
                                            let _e2393 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2362 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u)) * _e2083) + (_e2101 + _e1861)), ((f32(((_e2371 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u)) * _e2084) + (_e2102 + _e1862)));
                                            let _e2394 = core_intrinsics_minimum_number_nsz_f32_(_e2393, ((f32(((_e2380 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u)) * _e2085) + (_e2103 + _e1863)));
                                            if (_e2359 <= _e2394) {
                                                if (_e2359 <= _e265) {
                                                    if (_e2394 >= 0f) {
                                                        if (_e2323 == 0u) {
                                                            let _e2401 = nodes.member[(0u + _e2049)].links[2u];
                                                            phi_2777_ = _e2401;
                                                        } else {
                                                            let _e2404 = nodes.member[(0u + _e2049)].links[3u];
                                                            phi_2777_ = _e2404;
                                                        }
                                                        let _e2406 = phi_2777_;
                                                        let _e2411 = ((_e2406 >> bitcast<u32>(((_e2324 * 8u) & 31u))) & 255u);
                                                        let _e2412 = (_e2411 & 31u);
                                                        if (_e2412 >= 24u) {
                                                            phi_2790_ = (24u + ((_e2412 - 24u) ^ _e1911));
                                                        } else {
                                                            phi_2790_ = _e2412;
                                                        }
                                                        let _e2418 = phi_2790_;
                                                        phi_2795_ = (_e2320 | ((_e2411 >> bitcast<u32>(5i)) << bitcast<u32>((_e2418 & 31u))));
                                                    } else {
                                                        phi_2795_ = _e2320;
                                                    }
                                                    let _e2426 = phi_2795_;
                                                    phi_2796_ = _e2426;
                                                } else {
                                                    phi_2796_ = _e2320;
                                                }
                                                let _e2428 = phi_2796_;
                                                phi_2797_ = _e2428;
                                            } else {
                                                phi_2797_ = _e2320;
                                            }
                                            let _e2430 = phi_2797_;
                                            phi_2667_ = (_e2318 + 1u);
                                            phi_2670_ = _e2430;
                                        } else {
                                            phi_2667_ = u32();
                                            phi_2670_ = u32();
                                        }
                                        let _e2433 = phi_2667_;
                                        let _e2435 = phi_2670_;
                                        continue;
                                        continuing {
                                            phi_2666_ = _e2433;
                                            phi_2669_ = _e2435;
                                            break if !(_e2321);
                                        }
                                    }
                                    let _e2439 = nodes.member[(0u + _e2049)].links[0u];
                                    let _e2443 = nodes.member[(0u + _e2049)].frame[3u];
                                    let _e2447 = local_9;
                                    if ((_e2447 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2451 = local.group_mask;
                                        if ((_e2451 & 4278190080u) == 0u) {
                                        } else {
                                            let _e2455 = local.len;
                                            if (_e2455 < 32u) {
                                                let _e2458 = local.group;
                                                let _e2460 = local.len;
                                                if (_e2460 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local.first[(0u + _e2460)] = _e2458;
                                                let _e2466 = local.group_mask;
                                                let _e2468 = local.len;
                                                if (_e2468 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local.mask[(0u + _e2468)] = _e2466;
                                                let _e2475 = local.len;
                                                local.len = (_e2475 + 1u);
                                            }
                                        }
                                        local.group = (0u + _e2439);
                                        let _e2479 = local_10;
                                        local.group_mask = ((_e2479 & 4278190080u) | (_e2443 >> bitcast<u32>(24i)));
                                    }
                                    let _e2484 = local_11;
                                    phi_2855_ = (_e2484 & 16777215u);
                                    phi_2858_ = _e2051;
                                    loop {
                                        let _e2487 = phi_2855_;
                                        let _e2489 = phi_2858_;
                                        local_22 = _e2489;
                                        let _e2490 = (_e2487 == 0u);
                                        local_12 = _e2490;
                                        local_23 = _e2490;
                                        if _e2490 {
                                            phi_2856_ = u32();
                                            phi_2859_ = bool();
                                            phi_3456_ = false;
                                        } else {
                                            let _e2493 = nodes.member[(0u + _e2049)].links[1u];
                                            let _e2498 = ((0u + _e2493) + select(firstTrailingBit(_e2487), 32u, (_e2487 == 0u)));
                                            if (_e2498 < _e79) {
                                            } else {
                                                return;
                                            }
                                            let _e2505 = triangles.member[(0u + _e2498)].v0_;
                                            let _e2507 = (_e2505.x - _e253);
                                            let _e2509 = (_e2505.y - _e255);
                                            let _e2511 = (_e2505.z - _e257);
                                            if (_e1884 == 0u) {
                                                phi_2903_ = vec3<f32>(_e2509, _e2511, _e2507);
                                            } else {
                                                if (_e1884 == 1u) {
                                                    phi_2902_ = vec3<f32>(_e2511, _e2507, _e2509);
                                                } else {
                                                    phi_2902_ = (_e2505 - vec3<f32>(_e253, _e255, _e257));
                                                }
                                                let _e2519 = phi_2902_;
                                                phi_2903_ = _e2519;
                                            }
                                            let _e2521 = phi_2903_;
                                            let _e2525 = (_e2521.x - (_e1895 * _e2521.z));
                                            let _e2529 = (_e2521.y - (_e1898 * _e2521.z));
                                            let _e2531 = triangles.member[(0u + _e2498)].v1_;
                                            let _e2533 = (_e2531.x - _e253);
                                            let _e2535 = (_e2531.y - _e255);
                                            let _e2537 = (_e2531.z - _e257);
                                            if (_e1884 == 0u) {
                                                phi_2933_ = vec3<f32>(_e2535, _e2537, _e2533);
                                            } else {
                                                if (_e1884 == 1u) {
                                                    phi_2932_ = vec3<f32>(_e2537, _e2533, _e2535);
                                                } else {
                                                    phi_2932_ = (_e2531 - vec3<f32>(_e253, _e255, _e257));
                                                }
                                                let _e2545 = phi_2932_;
                                                phi_2933_ = _e2545;
                                            }
                                            let _e2547 = phi_2933_;
                                            let _e2551 = (_e2547.x - (_e1895 * _e2547.z));
                                            let _e2555 = (_e2547.y - (_e1898 * _e2547.z));
                                            let _e2557 = triangles.member[(0u + _e2498)].v2_;
                                            let _e2559 = (_e2557.x - _e253);
                                            let _e2561 = (_e2557.y - _e255);
                                            let _e2563 = (_e2557.z - _e257);
                                            if (_e1884 == 0u) {
                                                phi_2963_ = vec3<f32>(_e2561, _e2563, _e2559);
                                            } else {
                                                if (_e1884 == 1u) {
                                                    phi_2962_ = vec3<f32>(_e2563, _e2559, _e2561);
                                                } else {
                                                    phi_2962_ = (_e2557 - vec3<f32>(_e253, _e255, _e257));
                                                }
                                                let _e2571 = phi_2962_;
                                                phi_2963_ = _e2571;
                                            }
                                            let _e2573 = phi_2963_;
                                            let _e2577 = (_e2573.x - (_e1895 * _e2573.z));
                                            let _e2581 = (_e2573.y - (_e1898 * _e2573.z));
                                            if (_e2551 < _e2577) {
                                                phi_2982_ = true;
                                            } else {
                                                if (_e2551 == _e2577) {
                                                    phi_2981_ = (_e2555 < _e2581);
                                                } else {
                                                    phi_2981_ = false;
                                                }
                                                let _e2586 = phi_2981_;
                                                phi_2982_ = _e2586;
                                            }
                                            let _e2588 = phi_2982_;
                                            if _e2588 {
                                                phi_2986_ = _e2581;
                                                phi_2987_ = _e2577;
                                                phi_2988_ = _e2555;
                                                phi_2989_ = _e2551;
                                            } else {
                                                phi_2986_ = _e2555;
                                                phi_2987_ = _e2551;
                                                phi_2988_ = _e2581;
                                                phi_2989_ = _e2577;
                                            }
                                            let _e2590 = phi_2986_;
                                            let _e2592 = phi_2987_;
                                            let _e2594 = phi_2988_;
                                            let _e2596 = phi_2989_;
                                            let _e2599 = ((_e2596 * _e2590) - (_e2594 * _e2592));
                                            if _e2588 {
                                                phi_2997_ = -(_e2599);
                                            } else {
                                                phi_2997_ = _e2599;
                                            }
                                            let _e2602 = phi_2997_;
                                            if (_e2577 < _e2525) {
                                                phi_3008_ = true;
                                            } else {
                                                if (_e2577 == _e2525) {
                                                    phi_3007_ = (_e2581 < _e2529);
                                                } else {
                                                    phi_3007_ = false;
                                                }
                                                let _e2607 = phi_3007_;
                                                phi_3008_ = _e2607;
                                            }
                                            let _e2609 = phi_3008_;
                                            if _e2609 {
                                                phi_3012_ = _e2529;
                                                phi_3013_ = _e2525;
                                                phi_3014_ = _e2581;
                                                phi_3015_ = _e2577;
                                            } else {
                                                phi_3012_ = _e2581;
                                                phi_3013_ = _e2577;
                                                phi_3014_ = _e2529;
                                                phi_3015_ = _e2525;
                                            }
                                            let _e2611 = phi_3012_;
                                            let _e2613 = phi_3013_;
                                            let _e2615 = phi_3014_;
                                            let _e2617 = phi_3015_;
                                            let _e2620 = ((_e2617 * _e2611) - (_e2615 * _e2613));
                                            if _e2609 {
                                                phi_3023_ = -(_e2620);
                                            } else {
                                                phi_3023_ = _e2620;
                                            }
                                            let _e2623 = phi_3023_;
                                            if (_e2525 < _e2551) {
                                                phi_3034_ = true;
                                            } else {
                                                if (_e2525 == _e2551) {
                                                    phi_3033_ = (_e2529 < _e2555);
                                                } else {
                                                    phi_3033_ = false;
                                                }
                                                let _e2628 = phi_3033_;
                                                phi_3034_ = _e2628;
                                            }
                                            let _e2630 = phi_3034_;
                                            if _e2630 {
                                                phi_3038_ = _e2555;
                                                phi_3039_ = _e2551;
                                                phi_3040_ = _e2529;
                                                phi_3041_ = _e2525;
                                            } else {
                                                phi_3038_ = _e2529;
                                                phi_3039_ = _e2525;
                                                phi_3040_ = _e2555;
                                                phi_3041_ = _e2551;
                                            }
                                            let _e2632 = phi_3038_;
                                            let _e2634 = phi_3039_;
                                            let _e2636 = phi_3040_;
                                            let _e2638 = phi_3041_;
                                            let _e2641 = ((_e2638 * _e2632) - (_e2636 * _e2634));
                                            if _e2630 {
                                                phi_3049_ = -(_e2641);
                                            } else {
                                                phi_3049_ = _e2641;
                                            }
                                            let _e2644 = phi_3049_;
                                            if (_e2602 >= 0f) {
                                                if (_e2623 >= 0f) {
                                                    if (_e2644 >= 0f) {
                                                        phi_3064_ = ((_e2602 + _e2623) + _e2644);
                                                        phi_3065_ = false;
                                                    } else {
                                                        phi_3064_ = f32();
                                                        phi_3065_ = true;
                                                    }
                                                    let _e2651 = phi_3064_;
                                                    let _e2653 = phi_3065_;
                                                    phi_3066_ = _e2651;
                                                    phi_3067_ = _e2653;
                                                } else {
                                                    phi_3066_ = f32();
                                                    phi_3067_ = true;
                                                }
                                                let _e2655 = phi_3066_;
                                                let _e2657 = phi_3067_;
                                                phi_3068_ = _e2655;
                                                phi_3069_ = _e2657;
                                            } else {
                                                phi_3068_ = f32();
                                                phi_3069_ = true;
                                            }
                                            let _e2659 = phi_3068_;
                                            let _e2661 = phi_3069_;
                                            if _e2661 {
                                                if (_e2602 <= 0f) {
                                                    if (_e2623 <= 0f) {
                                                        let _e2664 = (_e2644 <= 0f);
                                                        if _e2664 {
                                                        }
                                                        phi_3087_ = ((_e2602 + _e2623) + _e2644);
                                                        phi_3088_ = false;
                                                        phi_3089_ = _e2664;
                                                    } else {
                                                        phi_3087_ = f32();
                                                        phi_3088_ = true;
                                                        phi_3089_ = false;
                                                    }
                                                    let _e2668 = phi_3087_;
                                                    let _e2670 = phi_3088_;
                                                    let _e2672 = phi_3089_;
                                                    phi_3090_ = _e2668;
                                                    phi_3091_ = _e2670;
                                                    phi_3092_ = _e2672;
                                                } else {
                                                    phi_3090_ = f32();
                                                    phi_3091_ = true;
                                                    phi_3092_ = false;
                                                }
                                                let _e2674 = phi_3090_;
                                                let _e2676 = phi_3091_;
                                                let _e2678 = phi_3092_;
                                                if _e2676 {
                                                    phi_3096_ = false;
                                                } else {
                                                    phi_3096_ = _e2678;
                                                }
                                                let _e2680 = phi_3096_;
                                                phi_3097_ = _e2674;
                                                phi_3098_ = _e2680;
                                            } else {
                                                phi_3097_ = _e2659;
                                                phi_3098_ = true;
                                            }
                                            let _e2682 = phi_3097_;
                                            let _e2684 = phi_3098_;
                                            if _e2684 {
                                                let _e2685 = (_e2682 == 0f);
                                                if _e2685 {
                                                    phi_3414_ = lt_bvh_triangle_Intersection();
                                                    phi_3415_ = false;
                                                } else {
                                                    let _e2687 = triangles.member[(0u + _e2498)].v0_;
                                                    let _e2689 = (_e2687.x - _e253);
                                                    let _e2691 = (_e2687.y - _e255);
                                                    let _e2693 = (_e2687.z - _e257);
                                                    if (_e1884 == 0u) {
                                                        phi_3127_ = vec3<f32>(_e2691, _e2693, _e2689);
                                                    } else {
                                                        if (_e1884 == 1u) {
                                                            phi_3126_ = vec3<f32>(_e2693, _e2689, _e2691);
                                                        } else {
                                                            phi_3126_ = (_e2687 - vec3<f32>(_e253, _e255, _e257));
                                                        }
                                                        let _e2701 = phi_3126_;
                                                        phi_3127_ = _e2701;
                                                    }
                                                    let _e2703 = phi_3127_;
                                                    let _e2705 = triangles.member[(0u + _e2498)].v1_;
                                                    let _e2707 = triangles.member[(0u + _e2498)].v0_;
                                                    let _e2710 = (_e2705.x - _e2707.x);
                                                    let _e2713 = (_e2705.y - _e2707.y);
                                                    let _e2716 = (_e2705.z - _e2707.z);
                                                    if (_e1884 == 0u) {
                                                        phi_3153_ = vec3<f32>(_e2713, _e2716, _e2710);
                                                    } else {
                                                        if (_e1884 == 1u) {
                                                            phi_3152_ = vec3<f32>(_e2716, _e2710, _e2713);
                                                        } else {
                                                            phi_3152_ = (_e2705 - _e2707);
                                                        }
                                                        let _e2723 = phi_3152_;
                                                        phi_3153_ = _e2723;
                                                    }
                                                    let _e2725 = phi_3153_;
                                                    let _e2727 = triangles.member[(0u + _e2498)].v2_;
                                                    let _e2729 = triangles.member[(0u + _e2498)].v0_;
                                                    let _e2732 = (_e2727.x - _e2729.x);
                                                    let _e2735 = (_e2727.y - _e2729.y);
                                                    let _e2738 = (_e2727.z - _e2729.z);
                                                    if (_e1884 == 0u) {
                                                        phi_3179_ = vec3<f32>(_e2735, _e2738, _e2732);
                                                    } else {
                                                        if (_e1884 == 1u) {
                                                            phi_3178_ = vec3<f32>(_e2738, _e2732, _e2735);
                                                        } else {
                                                            phi_3178_ = (_e2727 - _e2729);
                                                        }
                                                        let _e2745 = phi_3178_;
                                                        phi_3179_ = _e2745;
                                                    }
                                                    let _e2747 = phi_3179_;
                                                    let _e2754 = ((_e2725.y * _e2747.z) - (_e2725.z * _e2747.y));
                                                    let _e2761 = ((_e2725.z * _e2747.x) - (_e2725.x * _e2747.z));
                                                    let _e2768 = ((_e2725.x * _e2747.y) - (_e2725.y * _e2747.x));
                                                    let _e2782 = (((1f / _e1892.z) * (((_e2754 * _e2703.x) + (_e2761 * _e2703.y)) + (_e2768 * _e2703.z))) / (((_e2754 * _e1895) + (_e2761 * _e1898)) + _e2768));
                                                    if (_e2782 > 0f) {
                                                        if (_e2782 < _e265) {
                                                            let _e2786 = triangles.member[(0u + _e2498)].v0_;
                                                            let _e2788 = triangles.member[(0u + _e2498)].v1_;
                                                            if (_e2786.x < _e2788.x) {
                                                                phi_3235_ = _e2786.x;
                                                            } else {
                                                                phi_3235_ = _e2788.x;
                                                            }
                                                            let _e2795 = phi_3235_;
                                                            if (_e2786.y < _e2788.y) {
                                                                phi_3244_ = _e2786.y;
                                                            } else {
                                                                phi_3244_ = _e2788.y;
                                                            }
                                                            let _e2802 = phi_3244_;
                                                            if (_e2786.z < _e2788.z) {
                                                                phi_3253_ = _e2786.z;
                                                            } else {
                                                                phi_3253_ = _e2788.z;
                                                            }
                                                            let _e2809 = phi_3253_;
                                                            let _e2811 = triangles.member[(0u + _e2498)].v2_;
                                                            if (_e2795 < _e2811.x) {
                                                                phi_3262_ = _e2795;
                                                            } else {
                                                                phi_3262_ = _e2811.x;
                                                            }
                                                            let _e2816 = phi_3262_;
                                                            if (_e2802 < _e2811.y) {
                                                                phi_3269_ = _e2802;
                                                            } else {
                                                                phi_3269_ = _e2811.y;
                                                            }
                                                            let _e2821 = phi_3269_;
                                                            if (_e2809 < _e2811.z) {
                                                                phi_3276_ = _e2809;
                                                            } else {
                                                                phi_3276_ = _e2811.z;
                                                            }
                                                            let _e2826 = phi_3276_;
                                                            let _e2828 = triangles.member[(0u + _e2498)].v0_;
                                                            let _e2830 = triangles.member[(0u + _e2498)].v1_;
                                                            if (_e2828.x > _e2830.x) {
                                                                phi_3289_ = _e2828.x;
                                                            } else {
                                                                phi_3289_ = _e2830.x;
                                                            }
                                                            let _e2837 = phi_3289_;
                                                            if (_e2828.y > _e2830.y) {
                                                                phi_3298_ = _e2828.y;
                                                            } else {
                                                                phi_3298_ = _e2830.y;
                                                            }
                                                            let _e2844 = phi_3298_;
                                                            if (_e2828.z > _e2830.z) {
                                                                phi_3307_ = _e2828.z;
                                                            } else {
                                                                phi_3307_ = _e2830.z;
                                                            }
                                                            let _e2851 = phi_3307_;
                                                            let _e2853 = triangles.member[(0u + _e2498)].v2_;
                                                            if (_e2837 > _e2853.x) {
                                                                phi_3316_ = _e2837;
                                                            } else {
                                                                phi_3316_ = _e2853.x;
                                                            }
                                                            let _e2858 = phi_3316_;
                                                            if (_e2844 > _e2853.y) {
                                                                phi_3323_ = _e2844;
                                                            } else {
                                                                phi_3323_ = _e2853.y;
                                                            }
                                                            let _e2863 = phi_3323_;
                                                            if (_e2851 > _e2853.z) {
                                                                phi_3330_ = _e2851;
                                                            } else {
                                                                phi_3330_ = _e2853.z;
                                                            }
                                                            let _e2868 = phi_3330_;
                                                            let _e2872 = ((_e2816 - _e253) * _e1809);
                                                            let _e2873 = ((_e2821 - _e255) * _e1819);
                                                            let _e2874 = ((_e2826 - _e257) * _e1829);
                                                            let _e2878 = ((_e2858 - _e253) * _e1809);
                                                            let _e2879 = ((_e2863 - _e255) * _e1819);
                                                            let _e2880 = ((_e2868 - _e257) * _e1829);
                                                            if (_e2872 < _e2878) {
                                                                phi_3347_ = _e2872;
                                                            } else {
                                                                phi_3347_ = _e2878;
                                                            }
                                                            let _e2883 = phi_3347_;
                                                            if (_e2873 < _e2879) {
                                                                phi_3352_ = _e2873;
                                                            } else {
                                                                phi_3352_ = _e2879;
                                                            }
                                                            let _e2886 = phi_3352_;
                                                            if (_e2874 < _e2880) {
                                                                phi_3357_ = _e2874;
                                                            } else {
                                                                phi_3357_ = _e2880;
                                                            }
                                                            let _e2889 = phi_3357_;
                                                            if (_e2872 > _e2878) {
                                                                phi_3365_ = _e2872;
                                                            } else {
                                                                phi_3365_ = _e2878;
                                                            }
                                                            let _e2895 = phi_3365_;
                                                            if (_e2873 > _e2879) {
                                                                phi_3370_ = _e2873;
                                                            } else {
                                                                phi_3370_ = _e2879;
                                                            }
                                                            let _e2898 = phi_3370_;
                                                            if (_e2874 > _e2880) {
                                                                phi_3375_ = _e2874;
                                                            } else {
                                                                phi_3375_ = _e2880;
                                                            }
                                                            let _e2901 = phi_3375_;
                                                            let _e2905 = core_intrinsics_maximum_number_nsz_f32_((_e2883 - _e1868), (_e2886 - _e1869));
                                                            let _e2906 = core_intrinsics_maximum_number_nsz_f32_(_e2905, (_e2889 - _e1870));
                                                            let _e2907 = core_intrinsics_minimum_number_nsz_f32_((_e2895 + _e1868), (_e2898 + _e1869));
                                                            let _e2908 = core_intrinsics_minimum_number_nsz_f32_(_e2907, (_e2901 + _e1870));
                                                            if (_e2906 > -300000000000000000000000000000000000000f) {
                                                                phi_3387_ = _e2906;
                                                            } else {
                                                                phi_3387_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e2911 = phi_3387_;
                                                            if (_e2908 < 300000000000000000000000000000000000000f) {
                                                                phi_3392_ = _e2908;
                                                            } else {
                                                                phi_3392_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e2914 = phi_3392_;
                                                            if (_e2782 < _e2911) {
                                                                phi_3397_ = _e2911;
                                                            } else {
                                                                phi_3397_ = _e2782;
                                                            }
                                                            let _e2917 = phi_3397_;
                                                            if (_e2917 > _e2914) {
                                                                phi_3402_ = _e2914;
                                                            } else {
                                                                phi_3402_ = _e2917;
                                                            }
                                                            let _e2920 = phi_3402_;
                                                            phi_3407_ = lt_bvh_triangle_Intersection(_e2920, (_e2623 / _e2682), (_e2644 / _e2682), (_e2911 <= _e2914));
                                                            phi_3408_ = false;
                                                        } else {
                                                            phi_3407_ = lt_bvh_triangle_Intersection();
                                                            phi_3408_ = true;
                                                        }
                                                        let _e2926 = phi_3407_;
                                                        let _e2928 = phi_3408_;
                                                        phi_3409_ = _e2926;
                                                        phi_3410_ = _e2928;
                                                    } else {
                                                        phi_3409_ = lt_bvh_triangle_Intersection();
                                                        phi_3410_ = true;
                                                    }
                                                    let _e2930 = phi_3409_;
                                                    let _e2932 = phi_3410_;
                                                    if _e2932 {
                                                    }
                                                    phi_3414_ = _e2930;
                                                    phi_3415_ = _e2932;
                                                }
                                                let _e2934 = phi_3414_;
                                                let _e2936 = phi_3415_;
                                                phi_3416_ = _e2934;
                                                phi_3417_ = _e2685;
                                                phi_3418_ = _e2936;
                                            } else {
                                                phi_3416_ = lt_bvh_triangle_Intersection();
                                                phi_3417_ = true;
                                                phi_3418_ = false;
                                            }
                                            let _e2938 = phi_3416_;
                                            let _e2940 = phi_3417_;
                                            let _e2942 = phi_3418_;
                                            if _e2940 {
                                                phi_3422_ = true;
                                            } else {
                                                phi_3422_ = _e2942;
                                            }
                                            let _e2944 = phi_3422_;
                                            if _e2944 {
                                                phi_3426_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_3426_ = _e2938;
                                            }
                                            let _e2946 = phi_3426_;
                                            if _e2946.is_hit {
                                                if (_e2946.t > 0f) {
                                                    if (_e2946.t < _e265) {
                                                        if true {
                                                            phi_3446_ = false;
                                                        } else {
                                                            phi_3446_ = true;
                                                        }
                                                        let _e2955 = phi_3446_;
                                                        phi_3447_ = true;
                                                        phi_3448_ = _e2955;
                                                    } else {
                                                        phi_3447_ = _e2489;
                                                        phi_3448_ = true;
                                                    }
                                                    let _e2957 = phi_3447_;
                                                    let _e2959 = phi_3448_;
                                                    phi_3449_ = _e2957;
                                                    phi_3450_ = _e2959;
                                                } else {
                                                    phi_3449_ = _e2489;
                                                    phi_3450_ = true;
                                                }
                                                let _e2961 = phi_3449_;
                                                let _e2963 = phi_3450_;
                                                phi_3451_ = _e2961;
                                                phi_3452_ = _e2963;
                                            } else {
                                                phi_3451_ = _e2489;
                                                phi_3452_ = true;
                                            }
                                            let _e2965 = phi_3451_;
                                            let _e2967 = phi_3452_;
                                            if _e2967 {
                                            }
                                            phi_2856_ = (_e2487 & (_e2487 - 1u));
                                            phi_2859_ = _e2965;
                                            phi_3456_ = _e2967;
                                        }
                                        let _e2969 = phi_2856_;
                                        let _e2971 = phi_2859_;
                                        let _e2973 = phi_3456_;
                                        continue;
                                        continuing {
                                            phi_2855_ = _e2969;
                                            phi_2858_ = _e2971;
                                            break if !(_e2973);
                                        }
                                    }
                                    let _e2976 = local_12;
                                    if _e2976 {
                                        let _e2978 = local.group_mask;
                                        if ((_e2978 & 4278190080u) == 0u) {
                                            let _e2982 = local.len;
                                            if (_e2982 == 0u) {
                                                phi_3498_ = false;
                                            } else {
                                                let _e2986 = local.len;
                                                local.len = (_e2986 - 1u);
                                                let _e2989 = local.len;
                                                if (_e2989 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2994 = local.first[(0u + _e2989)];
                                                local.group = _e2994;
                                                let _e2997 = local.len;
                                                if (_e2997 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3002 = local.mask[(0u + _e2997)];
                                                local.group_mask = _e3002;
                                                phi_3498_ = true;
                                            }
                                            let _e3005 = phi_3498_;
                                            phi_3499_ = _e3005;
                                        } else {
                                            phi_3499_ = true;
                                        }
                                        let _e3007 = phi_3499_;
                                        if _e3007 {
                                            let _e3009 = local.group_mask;
                                            let _e3015 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3009)), 32u, (_e3009 == 0u)));
                                            let _e3019 = local.group_mask;
                                            let _e3033 = local.group_mask;
                                            local.group_mask = (_e3033 & ~((1u << bitcast<u32>((_e3015 & 31u)))));
                                            let _e3036 = local.group;
                                            phi_3530_ = (_e3036 + countOneBits(((_e3019 & ~((4294967295u << bitcast<u32>((((_e3015 - 24u) ^ _e1911) & 31u))))) & 255u)));
                                        } else {
                                            phi_3530_ = 4294967295u;
                                        }
                                        let _e3039 = phi_3530_;
                                        phi_3531_ = _e3039;
                                    } else {
                                        phi_3531_ = u32();
                                    }
                                    let _e3041 = phi_3531_;
                                    phi_2524_ = _e3041;
                                    let _e3498 = local_22;
                                    phi_2527_ = _e3498;
                                    let _e3501 = local_23;
                                    phi_3532_ = _e3501;
                                    phi_3533_ = false;
                                } else {
                                    phi_2524_ = u32();
                                    phi_2527_ = bool();
                                    phi_3532_ = false;
                                    phi_3533_ = true;
                                }
                                let _e3043 = phi_2524_;
                                let _e3045 = phi_2527_;
                                let _e3047 = phi_3532_;
                                let _e3049 = phi_3533_;
                                local_13 = _e3049;
                                continue;
                                continuing {
                                    phi_2523_ = _e3043;
                                    phi_2526_ = _e3045;
                                    break if !(_e3047);
                                }
                            }
                            let _e3052 = local_13;
                            if _e3052 {
                                phi_3537_ = false;
                            } else {
                                phi_3537_ = true;
                            }
                            let _e3054 = phi_3537_;
                            if _e3054 {
                                phi_3541_ = true;
                            } else {
                                let _e3507 = local_24;
                                phi_3541_ = _e3507;
                            }
                            let _e3056 = phi_3541_;
                            phi_3542_ = _e3056;
                        }
                        let _e3058 = phi_3542_;
                        phi_3543_ = _e3058;
                        phi_3544_ = _e1733;
                    } else {
                        phi_3543_ = bool();
                        phi_3544_ = true;
                    }
                    let _e3060 = phi_3543_;
                    let _e3062 = phi_3544_;
                    if _e3062 {
                        phi_3548_ = false;
                    } else {
                        phi_3548_ = _e3060;
                    }
                    let _e3064 = phi_3548_;
                    phi_3549_ = _e3064;
                }
                let _e3066 = phi_3549_;
                phi_3550_ = _e3066;
            } else {
                phi_3550_ = false;
            }
            let _e3068 = phi_3550_;
            if _e3068 {
                phi_3554_ = 0f;
            } else {
                phi_3554_ = 1f;
            }
            let _e3070 = phi_3554_;
            phi_3555_ = _e3070;
        }
        let _e3072 = phi_3555_;
        if (_e92.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e92.first_primitive)] = _e3072;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
