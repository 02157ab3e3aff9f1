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

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_38 {
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

struct type_42 {
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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_52 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(5) 
var<storage> instances: type_52;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_188_: lt_mask_LightPlace;
    var phi_189_: bool;
    var phi_190_: lt_mask_LightPlace;
    var phi_191_: bool;
    var phi_196_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_188_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_189_ = false;
        } else {
            phi_188_ = lt_mask_LightPlace();
            phi_189_ = true;
        }
        let _e67 = phi_188_;
        let _e69 = phi_189_;
        phi_190_ = _e67;
        phi_191_ = _e69;
    } else {
        phi_190_ = lt_mask_LightPlace();
        phi_191_ = true;
    }
    let _e71 = phi_190_;
    let _e73 = phi_191_;
    if _e73 {
        phi_196_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_196_ = _e71;
    }
    let _e78 = phi_196_;
    return lt_mask_LightPlace(_e78.word, _e78.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_211_: bool;
    var phi_215_: f32;

    if (param_3 != param_3) {
        phi_211_ = true;
    } else {
        let _e57 = (param_4 >= param_3);
        if _e57 {
        }
        phi_211_ = _e57;
    }
    let _e59 = phi_211_;
    if _e59 {
        phi_215_ = param_4;
    } else {
        phi_215_ = param_3;
    }
    let _e61 = phi_215_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_227_: bool;
    var phi_231_: f32;

    if (param_5 != param_5) {
        phi_227_ = true;
    } else {
        let _e57 = (param_6 <= param_5);
        if _e57 {
        }
        phi_227_ = _e57;
    }
    let _e59 = phi_227_;
    if _e59 {
        phi_231_ = param_6;
    } else {
        phi_231_ = param_5;
    }
    let _e61 = phi_231_;
    return _e61;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_263_: bool;

    let _e57 = (*param_7).normal[0u];
    let _e59 = global[0u];
    if (_e57 == _e59) {
        let _e62 = (*param_7).normal[1u];
        let _e64 = global[1u];
        if (_e62 == _e64) {
            let _e67 = (*param_7).normal[2u];
            let _e69 = global[2u];
            phi_256_ = (_e67 == _e69);
            phi_257_ = false;
        } else {
            phi_256_ = bool();
            phi_257_ = true;
        }
        let _e72 = phi_256_;
        let _e74 = phi_257_;
        phi_258_ = _e72;
        phi_259_ = _e74;
    } else {
        phi_258_ = bool();
        phi_259_ = true;
    }
    let _e76 = phi_258_;
    let _e78 = phi_259_;
    if _e78 {
        phi_263_ = false;
    } else {
        phi_263_ = _e76;
    }
    let _e80 = phi_263_;
    return !(_e80);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_390_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: bool;
    var phi_392_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_393_: bool;
    var phi_400_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_404_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_447_: f32;
    var phi_503_: bool;
    var phi_504_: bool;
    var phi_505_: bool;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_515_: bool;
    var phi_516_: bool;
    var phi_517_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_530_: bool;
    var phi_534_: bool;
    var phi_604_: f32;
    var phi_611_: f32;
    var phi_618_: f32;
    var phi_625_: f32;
    var phi_632_: f32;
    var phi_639_: f32;
    var phi_656_: f32;
    var phi_661_: f32;
    var phi_666_: f32;
    var phi_687_: u32;
    var phi_692_: u32;
    var phi_697_: u32;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_843_: u32;
    var phi_845_: u32;
    var phi_848_: bool;
    var phi_928_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_955_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_982_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_988_: u32;
    var phi_991_: u32;
    var phi_1005_: u32;
    var phi_1015_: u32;
    var phi_1025_: u32;
    var phi_1043_: u32;
    var phi_1053_: u32;
    var phi_1063_: u32;
    var phi_1099_: u32;
    var phi_1112_: u32;
    var phi_1117_: u32;
    var phi_1118_: u32;
    var phi_1119_: u32;
    var phi_989_: u32;
    var phi_992_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1177_: u32;
    var phi_1180_: bool;
    var phi_1229_: f32;
    var phi_1234_: f32;
    var phi_1239_: f32;
    var phi_1247_: f32;
    var phi_1252_: f32;
    var phi_1257_: f32;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1420_: bool;
    var phi_1421_: bool;
    var phi_1422_: bool;
    var phi_1423_: bool;
    var phi_1424_: bool;
    var phi_1428_: bool;
    var phi_1432_: bool;
    var phi_1502_: f32;
    var phi_1509_: f32;
    var phi_1516_: f32;
    var phi_1523_: f32;
    var phi_1530_: f32;
    var phi_1537_: f32;
    var phi_1554_: f32;
    var phi_1559_: f32;
    var phi_1564_: f32;
    var phi_1592_: bool;
    var phi_1593_: bool;
    var phi_1601_: u32;
    var phi_1602_: u32;
    var phi_1613_: vec3<f32>;
    var phi_1614_: vec3<f32>;
    var phi_1627_: u32;
    var phi_1632_: u32;
    var phi_1637_: u32;
    var phi_1751_: bool;
    var phi_1752_: bool;
    var phi_1783_: u32;
    var phi_1785_: u32;
    var phi_1788_: bool;
    var phi_1868_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1895_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1922_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1928_: u32;
    var phi_1931_: u32;
    var phi_1945_: u32;
    var phi_1955_: u32;
    var phi_1965_: u32;
    var phi_1983_: u32;
    var phi_1993_: u32;
    var phi_2003_: u32;
    var phi_2039_: u32;
    var phi_2052_: u32;
    var phi_2057_: u32;
    var phi_2058_: u32;
    var phi_2059_: u32;
    var phi_1929_: u32;
    var phi_1932_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2117_: u32;
    var phi_2120_: bool;
    var phi_2164_: vec3<f32>;
    var phi_2165_: vec3<f32>;
    var phi_2194_: vec3<f32>;
    var phi_2195_: vec3<f32>;
    var phi_2224_: vec3<f32>;
    var phi_2225_: vec3<f32>;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2248_: f32;
    var phi_2249_: f32;
    var phi_2250_: f32;
    var phi_2251_: f32;
    var phi_2259_: f32;
    var phi_2269_: bool;
    var phi_2270_: bool;
    var phi_2274_: f32;
    var phi_2275_: f32;
    var phi_2276_: f32;
    var phi_2277_: f32;
    var phi_2285_: f32;
    var phi_2295_: bool;
    var phi_2296_: bool;
    var phi_2300_: f32;
    var phi_2301_: f32;
    var phi_2302_: f32;
    var phi_2303_: f32;
    var phi_2311_: f32;
    var phi_2326_: f32;
    var phi_2327_: bool;
    var phi_2328_: f32;
    var phi_2329_: bool;
    var phi_2330_: f32;
    var phi_2331_: bool;
    var phi_2349_: f32;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2352_: f32;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2358_: bool;
    var phi_2359_: f32;
    var phi_2360_: bool;
    var phi_2388_: vec3<f32>;
    var phi_2389_: vec3<f32>;
    var phi_2414_: vec3<f32>;
    var phi_2415_: vec3<f32>;
    var phi_2440_: vec3<f32>;
    var phi_2441_: vec3<f32>;
    var phi_2497_: f32;
    var phi_2506_: f32;
    var phi_2515_: f32;
    var phi_2524_: f32;
    var phi_2531_: f32;
    var phi_2538_: f32;
    var phi_2551_: f32;
    var phi_2560_: f32;
    var phi_2569_: f32;
    var phi_2578_: f32;
    var phi_2585_: f32;
    var phi_2592_: f32;
    var phi_2609_: f32;
    var phi_2614_: f32;
    var phi_2619_: f32;
    var phi_2627_: f32;
    var phi_2632_: f32;
    var phi_2637_: f32;
    var phi_2649_: f32;
    var phi_2654_: f32;
    var phi_2659_: f32;
    var phi_2664_: f32;
    var phi_2669_: lt_bvh_triangle_Intersection;
    var phi_2670_: bool;
    var phi_2671_: lt_bvh_triangle_Intersection;
    var phi_2672_: bool;
    var phi_2676_: lt_bvh_triangle_Intersection;
    var phi_2677_: bool;
    var phi_2678_: lt_bvh_triangle_Intersection;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2684_: bool;
    var phi_2688_: lt_bvh_triangle_Intersection;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2712_: bool;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2118_: u32;
    var phi_2121_: bool;
    var phi_2718_: bool;
    var local_9: bool;
    var phi_2760_: bool;
    var phi_2761_: bool;
    var phi_2792_: u32;
    var phi_2793_: u32;
    var phi_1786_: u32;
    var phi_1789_: bool;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var local_10: bool;
    var phi_2799_: bool;
    var phi_2803_: bool;
    var phi_2804_: bool;
    var phi_2805_: bool;
    var phi_2806_: bool;
    var phi_2810_: bool;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2816_: bool;
    var phi_2817_: bool;
    var phi_2818_: bool;
    var phi_2819_: bool;
    var phi_2820_: bool;
    var phi_1178_: u32;
    var phi_1181_: bool;
    var phi_2824_: bool;
    var local_11: bool;
    var phi_2866_: bool;
    var phi_2867_: bool;
    var phi_2898_: u32;
    var phi_2899_: u32;
    var phi_846_: u32;
    var phi_849_: bool;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var local_12: bool;
    var phi_2905_: bool;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2915_: bool;
    var phi_2916_: bool;
    var phi_2920_: bool;
    var phi_2924_: f32;
    var phi_2925_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e57 = id_1;
    let _e64 = arrayLength((&nodes.member));
    let _e76 = p.member.size[0u];
    let _e78 = p.member.size[1u];
    let _e79 = lt_shaders_entry_pixel_index(_e57, _e76, _e78);
    if (bitcast<i32>(_e79.word) != 0i) {
        if (_e79.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e87 = samples.member[(0u + _e79.shift)];
        local_2 = abi_Sample(_e87.position, _e87.magnitude, _e87.normal, _e87.flags, _e87.shading_normal, _e87.albedo);
        let _e96 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e96 {
            let _e98 = local_2.position;
            let _e100 = p.member.light.place;
            let _e106 = p.member.light.place[3u];
            let _e113 = (_e100.x - (_e98.x * _e106));
            let _e114 = (_e100.y - (_e98.y * _e106));
            let _e115 = (_e100.z - (_e98.z * _e106));
            let _e117 = local_2.normal;
            if ((((_e117.x * _e113) + (_e117.y * _e114)) + (_e117.z * _e115)) > 0f) {
                let _e131 = (((_e113 * _e113) + (_e114 * _e114)) + (_e115 * _e115));
                let _e133 = p.member.light.axis;
                let _e145 = p.member.light.place[3u];
                if (_e145 == 0f) {
                    phi_379_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_378_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_378_ = false;
                    }
                    let _e156 = phi_378_;
                    phi_379_ = _e156;
                }
                let _e158 = phi_379_;
                if _e158 {
                    let _e160 = local_2.flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_390_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_391_ = false;
                } else {
                    phi_390_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_391_ = true;
                }
                let _e179 = phi_390_;
                let _e181 = phi_391_;
                phi_392_ = _e179;
                phi_393_ = _e181;
            } else {
                phi_392_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_393_ = true;
            }
            let _e183 = phi_392_;
            let _e185 = phi_393_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_400_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_400_ = _e183;
            }
            let _e202 = phi_400_;
            phi_404_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_404_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_404_;
        let _e224 = p.member.root;
        if _e219.unnamed_1 {
            phi_2925_ = _e219.unnamed.visibility;
        } else {
            let _e227 = local_2.position;
            let _e229 = local_2.normal;
            let _e231 = local_2.magnitude;
            let _e233 = ((8f / 8388608f) * _e231);
            let _e241 = (_e227.x + (_e229.x * _e233));
            let _e243 = (_e227.y + (_e229.y * _e233));
            let _e245 = (_e227.z + (_e229.z * _e233));
            let _e247 = p.member.light.place;
            if (_e247.w == 0f) {
                phi_447_ = 300000000000000000000000000000000000000f;
            } else {
                phi_447_ = 1f;
            }
            let _e251 = phi_447_;
            let _e259 = (_e247.x - (_e241 * _e247.w));
            let _e260 = (_e247.y - (_e243 * _e247.w));
            let _e261 = (_e247.z - (_e245 * _e247.w));
            let _e265 = abs(_e259);
            let _e266 = abs(_e260);
            let _e267 = abs(_e261);
            if (abs(_e241) < 1000000000000000f) {
                if (abs(_e243) < 1000000000000000f) {
                    if (abs(_e245) < 1000000000000000f) {
                        if (_e265 < 1000000000000000f) {
                            if (_e266 < 1000000000000000f) {
                                if (_e267 < 1000000000000000f) {
                                    if (_e265 > 0f) {
                                        phi_504_ = bool();
                                        phi_505_ = true;
                                    } else {
                                        let _e275 = (_e266 > 0f);
                                        if _e275 {
                                            phi_503_ = bool();
                                        } else {
                                            phi_503_ = (_e267 > 0f);
                                        }
                                        let _e278 = phi_503_;
                                        phi_504_ = _e278;
                                        phi_505_ = _e275;
                                    }
                                    let _e280 = phi_504_;
                                    let _e282 = phi_505_;
                                    if _e282 {
                                        phi_509_ = true;
                                    } else {
                                        phi_509_ = _e280;
                                    }
                                    let _e284 = phi_509_;
                                    phi_510_ = _e284;
                                    phi_511_ = false;
                                } else {
                                    phi_510_ = bool();
                                    phi_511_ = true;
                                }
                                let _e286 = phi_510_;
                                let _e288 = phi_511_;
                                phi_512_ = _e286;
                                phi_513_ = false;
                                phi_514_ = _e288;
                            } else {
                                phi_512_ = bool();
                                phi_513_ = true;
                                phi_514_ = false;
                            }
                            let _e290 = phi_512_;
                            let _e292 = phi_513_;
                            let _e294 = phi_514_;
                            phi_515_ = _e290;
                            phi_516_ = _e292;
                            phi_517_ = _e294;
                        } else {
                            phi_515_ = bool();
                            phi_516_ = true;
                            phi_517_ = false;
                        }
                        let _e296 = phi_515_;
                        let _e298 = phi_516_;
                        let _e300 = phi_517_;
                        phi_518_ = _e296;
                        phi_519_ = _e298;
                        phi_520_ = _e300;
                    } else {
                        phi_518_ = bool();
                        phi_519_ = true;
                        phi_520_ = false;
                    }
                    let _e302 = phi_518_;
                    let _e304 = phi_519_;
                    let _e306 = phi_520_;
                    phi_521_ = _e302;
                    phi_522_ = _e304;
                    phi_523_ = _e306;
                } else {
                    phi_521_ = bool();
                    phi_522_ = true;
                    phi_523_ = false;
                }
                let _e308 = phi_521_;
                let _e310 = phi_522_;
                let _e312 = phi_523_;
                phi_524_ = _e308;
                phi_525_ = _e310;
                phi_526_ = _e312;
            } else {
                phi_524_ = bool();
                phi_525_ = true;
                phi_526_ = false;
            }
            let _e314 = phi_524_;
            let _e316 = phi_525_;
            let _e318 = phi_526_;
            if _e316 {
                phi_530_ = true;
            } else {
                phi_530_ = _e318;
            }
            let _e320 = phi_530_;
            if _e320 {
                phi_534_ = false;
            } else {
                phi_534_ = _e314;
            }
            let _e322 = phi_534_;
            if _e322 {
                let _e323 = (_e224 >= _e64);
                if _e323 {
                    phi_2909_ = false;
                } else {
                    if (_e224 < _e64) {
                    } else {
                        return;
                    }
                    let _e329 = nodes.member[(0u + _e224)].frame[0u];
                    let _e333 = nodes.member[(0u + _e224)].frame[1u];
                    let _e337 = nodes.member[(0u + _e224)].frame[2u];
                    let _e341 = nodes.member[(0u + _e224)].frame[0u];
                    let _e345 = nodes.member[(0u + _e224)].frame[1u];
                    let _e349 = nodes.member[(0u + _e224)].frame[2u];
                    let _e353 = nodes.member[(0u + _e224)].frame[3u];
                    let _e387 = core_intrinsics_maximum_number_nsz_f32_(abs(_e259), abs(_e260));
                    let _e388 = core_intrinsics_maximum_number_nsz_f32_(_e387, abs(_e261));
                    let _e389 = (_e388 * 0.0000000000009094947f);
                    if (abs(_e259) < _e389) {
                        phi_604_ = _e389;
                    } else {
                        phi_604_ = abs(_e259);
                    }
                    let _e394 = phi_604_;
                    if (_e259 < 0f) {
                        phi_611_ = (-1f / _e394);
                    } else {
                        phi_611_ = (1f / _e394);
                    }
                    let _e399 = phi_611_;
                    if (abs(_e260) < _e389) {
                        phi_618_ = _e389;
                    } else {
                        phi_618_ = abs(_e260);
                    }
                    let _e404 = phi_618_;
                    if (_e260 < 0f) {
                        phi_625_ = (-1f / _e404);
                    } else {
                        phi_625_ = (1f / _e404);
                    }
                    let _e409 = phi_625_;
                    if (abs(_e261) < _e389) {
                        phi_632_ = _e389;
                    } else {
                        phi_632_ = abs(_e261);
                    }
                    let _e414 = phi_632_;
                    if (_e261 < 0f) {
                        phi_639_ = (-1f / _e414);
                    } else {
                        phi_639_ = (1f / _e414);
                    }
                    let _e419 = phi_639_;
                    let _e423 = abs((bitcast<f32>(_e329) - _e241));
                    let _e424 = abs((bitcast<f32>(_e333) - _e243));
                    let _e425 = abs((bitcast<f32>(_e337) - _e245));
                    let _e429 = abs(((bitcast<f32>(_e341) + (bitcast<f32>((((_e353 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e241));
                    let _e430 = abs(((bitcast<f32>(_e345) + (bitcast<f32>((((_e353 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e243));
                    let _e431 = abs(((bitcast<f32>(_e349) + (bitcast<f32>((((_e353 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e245));
                    if (_e423 > _e429) {
                        phi_656_ = _e423;
                    } else {
                        phi_656_ = _e429;
                    }
                    let _e434 = phi_656_;
                    if (_e424 > _e430) {
                        phi_661_ = _e424;
                    } else {
                        phi_661_ = _e430;
                    }
                    let _e437 = phi_661_;
                    if (_e425 > _e431) {
                        phi_666_ = _e425;
                    } else {
                        phi_666_ = _e431;
                    }
                    let _e440 = phi_666_;
                    let _e441 = core_intrinsics_maximum_number_nsz_f32_(_e434, _e437);
                    let _e442 = core_intrinsics_maximum_number_nsz_f32_(_e441, _e440);
                    let _e446 = (_e442 * 0.0000019073486f);
                    let _e447 = (abs(_e399) * _e446);
                    let _e448 = (abs(_e409) * _e446);
                    let _e449 = (abs(_e419) * _e446);
                    let _e453 = (_e442 * 0.0000009536743f);
                    let _e454 = (abs(_e399) * _e453);
                    let _e455 = (abs(_e409) * _e453);
                    let _e456 = (abs(_e419) * _e453);
                    if (_e399 < 0f) {
                        phi_687_ = 0u;
                    } else {
                        phi_687_ = 1u;
                    }
                    let _e459 = phi_687_;
                    if (_e409 < 0f) {
                        phi_692_ = 0u;
                    } else {
                        phi_692_ = 2u;
                    }
                    let _e462 = phi_692_;
                    if (_e419 < 0f) {
                        phi_697_ = 0u;
                    } else {
                        phi_697_ = 4u;
                    }
                    let _e465 = phi_697_;
                    let _e467 = ((_e459 | _e462) | _e465);
                    let _e468 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e224, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e468.first[0], _e468.first[1], _e468.first[2], _e468.first[3], _e468.first[4], _e468.first[5], _e468.first[6], _e468.first[7], _e468.first[8], _e468.first[9], _e468.first[10], _e468.first[11], _e468.first[12], _e468.first[13], _e468.first[14], _e468.first[15], _e468.first[16], _e468.first[17], _e468.first[18], _e468.first[19], _e468.first[20], _e468.first[21], _e468.first[22], _e468.first[23], _e468.first[24], _e468.first[25], _e468.first[26], _e468.first[27], _e468.first[28], _e468.first[29], _e468.first[30], _e468.first[31]), array<u32, 32>(_e468.mask[0], _e468.mask[1], _e468.mask[2], _e468.mask[3], _e468.mask[4], _e468.mask[5], _e468.mask[6], _e468.mask[7], _e468.mask[8], _e468.mask[9], _e468.mask[10], _e468.mask[11], _e468.mask[12], _e468.mask[13], _e468.mask[14], _e468.mask[15], _e468.mask[16], _e468.mask[17], _e468.mask[18], _e468.mask[19], _e468.mask[20], _e468.mask[21], _e468.mask[22], _e468.mask[23], _e468.mask[24], _e468.mask[25], _e468.mask[26], _e468.mask[27], _e468.mask[28], _e468.mask[29], _e468.mask[30], _e468.mask[31]), _e468.len, _e468.group, _e468.group_mask);
                    let _e542 = local_1.group_mask;
                    if ((_e542 & 4278190080u) == 0u) {
                        let _e546 = local_1.len;
                        if (_e546 == 0u) {
                            phi_811_ = false;
                        } else {
                            let _e550 = local_1.len;
                            local_1.len = (_e550 - 1u);
                            let _e553 = local_1.len;
                            if (_e553 < 32u) {
                            } else {
                                return;
                            }
                            let _e558 = local_1.first[(0u + _e553)];
                            local_1.group = _e558;
                            let _e561 = local_1.len;
                            if (_e561 < 32u) {
                            } else {
                                return;
                            }
                            let _e566 = local_1.mask[(0u + _e561)];
                            local_1.group_mask = _e566;
                            phi_811_ = true;
                        }
                        let _e569 = phi_811_;
                        phi_812_ = _e569;
                    } else {
                        phi_812_ = true;
                    }
                    let _e571 = phi_812_;
                    if _e571 {
                        let _e573 = local_1.group_mask;
                        let _e579 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e573)), 32u, (_e573 == 0u)));
                        let _e583 = local_1.group_mask;
                        let _e597 = local_1.group_mask;
                        local_1.group_mask = (_e597 & ~((1u << bitcast<u32>((_e579 & 31u)))));
                        let _e600 = local_1.group;
                        phi_843_ = (_e600 + countOneBits(((_e583 & ~((4294967295u << bitcast<u32>((((_e579 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_843_ = 4294967295u;
                    }
                    let _e603 = phi_843_;
                    phi_845_ = _e603;
                    phi_848_ = false;
                    loop {
                        let _e605 = phi_845_;
                        let _e607 = phi_848_;
                        if (_e605 != 4294967295u) {
                            if (_e605 < _e64) {
                            } else {
                                return;
                            }
                            let _e614 = nodes.member[(0u + _e605)].frame[3u];
                            let _e639 = (bitcast<f32>((((_e614 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e399);
                            let _e640 = (bitcast<f32>((((_e614 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e409);
                            let _e641 = (bitcast<f32>((((_e614 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e419);
                            let _e644 = nodes.member[(0u + _e605)].frame[0u];
                            let _e648 = nodes.member[(0u + _e605)].frame[1u];
                            let _e652 = nodes.member[(0u + _e605)].frame[2u];
                            let _e657 = ((bitcast<f32>(_e644) - _e241) * _e399);
                            let _e658 = ((bitcast<f32>(_e648) - _e243) * _e409);
                            let _e659 = ((bitcast<f32>(_e652) - _e245) * _e419);
                            let _e667 = nodes.member[(0u + _e605)].x;
                            if (_e399 < 0f) {
                                let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e667.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e678.unnamed.word, _e667.w), _e678.unnamed_1);
                                let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_mask_LightPlace(_e667.x, _e684.unnamed_1.shift));
                                phi_928_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_mask_LightPlace(_e690.unnamed_1.word, _e667.y));
                            } else {
                                let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e667.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e706.unnamed.word, _e667.y), _e706.unnamed_1);
                                let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_mask_LightPlace(_e667.z, _e712.unnamed_1.shift));
                                phi_928_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_mask_LightPlace(_e718.unnamed_1.word, _e667.w));
                            }
                            let _e726 = phi_928_;
                            let _e736 = nodes.member[(0u + _e605)].y;
                            if (_e409 < 0f) {
                                let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e736.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e747.unnamed.word, _e736.w), _e747.unnamed_1);
                                let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e753.unnamed, lt_mask_LightPlace(_e736.x, _e753.unnamed_1.shift));
                                phi_955_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_mask_LightPlace(_e759.unnamed_1.word, _e736.y));
                            } else {
                                let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e736.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e775.unnamed.word, _e736.y), _e775.unnamed_1);
                                let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e781.unnamed, lt_mask_LightPlace(_e736.z, _e781.unnamed_1.shift));
                                phi_955_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e787.unnamed, lt_mask_LightPlace(_e787.unnamed_1.word, _e736.w));
                            }
                            let _e795 = phi_955_;
                            let _e805 = nodes.member[(0u + _e605)].z;
                            if (_e419 < 0f) {
                                let _e816 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e805.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e816.unnamed.word, _e805.w), _e816.unnamed_1);
                                let _e828 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e822.unnamed, lt_mask_LightPlace(_e805.x, _e822.unnamed_1.shift));
                                phi_982_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e828.unnamed, lt_mask_LightPlace(_e828.unnamed_1.word, _e805.y));
                            } else {
                                let _e844 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e805.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e850 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e844.unnamed.word, _e805.y), _e844.unnamed_1);
                                let _e856 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e850.unnamed, lt_mask_LightPlace(_e805.z, _e850.unnamed_1.shift));
                                phi_982_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e856.unnamed, lt_mask_LightPlace(_e856.unnamed_1.word, _e805.w));
                            }
                            let _e864 = phi_982_;
                            phi_988_ = 0u;
                            phi_991_ = 0u;
                            loop {
                                let _e874 = phi_988_;
                                let _e876 = phi_991_;
                                local_3 = _e876;
                                local_4 = _e876;
                                local_5 = _e876;
                                let _e877 = (_e874 < 8u);
                                if _e877 {
                                    let _e879 = (_e874 >> bitcast<u32>(2i));
                                    let _e880 = (_e874 & 3u);
                                    if (_e879 == 0u) {
                                        phi_1005_ = _e726.unnamed.word;
                                    } else {
                                        phi_1005_ = _e726.unnamed.shift;
                                    }
                                    let _e883 = phi_1005_;
                                    if (_e879 == 0u) {
                                        phi_1015_ = _e795.unnamed.word;
                                    } else {
                                        phi_1015_ = _e795.unnamed.shift;
                                    }
                                    let _e892 = phi_1015_;
                                    if (_e879 == 0u) {
                                        phi_1025_ = _e864.unnamed.word;
                                    } else {
                                        phi_1025_ = _e864.unnamed.shift;
                                    }
                                    let _e901 = phi_1025_;
                                    let _e914 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e883 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u)) * _e639) + (_e657 - _e447)), ((f32(((_e892 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u)) * _e640) + (_e658 - _e448)));
                                    let _e915 = core_intrinsics_maximum_number_nsz_f32_(_e914, ((f32(((_e901 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u)) * _e641) + (_e659 - _e449)));
                                    if (_e879 == 0u) {
                                        phi_1043_ = _e726.unnamed_1.word;
                                    } else {
                                        phi_1043_ = _e726.unnamed_1.shift;
                                    }
                                    let _e918 = phi_1043_;
                                    if (_e879 == 0u) {
                                        phi_1053_ = _e795.unnamed_1.word;
                                    } else {
                                        phi_1053_ = _e795.unnamed_1.shift;
                                    }
                                    let _e927 = phi_1053_;
                                    if (_e879 == 0u) {
                                        phi_1063_ = _e864.unnamed_1.word;
                                    } else {
                                        phi_1063_ = _e864.unnamed_1.shift;
                                    }
                                    let _e936 = phi_1063_;
                                    let _e949 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e918 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u)) * _e639) + (_e657 + _e447)), ((f32(((_e927 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u)) * _e640) + (_e658 + _e448)));
                                    let _e950 = core_intrinsics_minimum_number_nsz_f32_(_e949, ((f32(((_e936 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u)) * _e641) + (_e659 + _e449)));
                                    if (_e915 <= _e950) {
                                        if (_e915 <= _e251) {
                                            if (_e950 >= 0f) {
                                                if (_e879 == 0u) {
                                                    let _e957 = nodes.member[(0u + _e605)].links[2u];
                                                    phi_1099_ = _e957;
                                                } else {
                                                    let _e960 = nodes.member[(0u + _e605)].links[3u];
                                                    phi_1099_ = _e960;
                                                }
                                                let _e962 = phi_1099_;
                                                let _e967 = ((_e962 >> bitcast<u32>(((_e880 * 8u) & 31u))) & 255u);
                                                let _e968 = (_e967 & 31u);
                                                if (_e968 >= 24u) {
                                                    phi_1112_ = (24u + ((_e968 - 24u) ^ _e467));
                                                } else {
                                                    phi_1112_ = _e968;
                                                }
                                                let _e974 = phi_1112_;
                                                phi_1117_ = (_e876 | ((_e967 >> bitcast<u32>(5i)) << bitcast<u32>((_e974 & 31u))));
                                            } else {
                                                phi_1117_ = _e876;
                                            }
                                            let _e982 = phi_1117_;
                                            phi_1118_ = _e982;
                                        } else {
                                            phi_1118_ = _e876;
                                        }
                                        let _e984 = phi_1118_;
                                        phi_1119_ = _e984;
                                    } else {
                                        phi_1119_ = _e876;
                                    }
                                    let _e986 = phi_1119_;
                                    phi_989_ = (_e874 + 1u);
                                    phi_992_ = _e986;
                                } else {
                                    phi_989_ = u32();
                                    phi_992_ = u32();
                                }
                                let _e989 = phi_989_;
                                let _e991 = phi_992_;
                                continue;
                                continuing {
                                    phi_988_ = _e989;
                                    phi_991_ = _e991;
                                    break if !(_e877);
                                }
                            }
                            let _e995 = nodes.member[(0u + _e605)].links[0u];
                            let _e999 = nodes.member[(0u + _e605)].frame[3u];
                            let _e1003 = local_3;
                            if ((_e1003 & 4278190080u) == 0u) {
                            } else {
                                let _e1007 = local_1.group_mask;
                                if ((_e1007 & 4278190080u) == 0u) {
                                } else {
                                    let _e1011 = local_1.len;
                                    if (_e1011 < 32u) {
                                        let _e1014 = local_1.group;
                                        let _e1016 = local_1.len;
                                        if (_e1016 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1016)] = _e1014;
                                        let _e1022 = local_1.group_mask;
                                        let _e1024 = local_1.len;
                                        if (_e1024 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1024)] = _e1022;
                                        let _e1031 = local_1.len;
                                        local_1.len = (_e1031 + 1u);
                                    }
                                }
                                local_1.group = (_e224 + _e995);
                                let _e1035 = local_4;
                                local_1.group_mask = ((_e1035 & 4278190080u) | (_e999 >> bitcast<u32>(24i)));
                            }
                            let _e1040 = local_5;
                            phi_1177_ = (_e1040 & 16777215u);
                            phi_1180_ = _e607;
                            loop {
                                let _e1043 = phi_1177_;
                                let _e1045 = phi_1180_;
                                local_16 = _e1045;
                                let _e1046 = (_e1043 == 0u);
                                local_11 = _e1046;
                                local_17 = _e1046;
                                if _e1046 {
                                    phi_1178_ = u32();
                                    phi_1181_ = bool();
                                    phi_2824_ = false;
                                } else {
                                    let _e1049 = nodes.member[(0u + _e605)].links[1u];
                                    let _e1053 = (_e1049 + select(firstTrailingBit(_e1043), 32u, (_e1043 == 0u)));
                                    if (_e1053 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1060 = instances.member[(0u + _e1053)].low_world;
                                    let _e1062 = instances.member[(0u + _e1053)].high_world;
                                    let _e1069 = ((_e1060.x - _e241) * _e399);
                                    let _e1070 = ((_e1060.y - _e243) * _e409);
                                    let _e1071 = ((_e1060.z - _e245) * _e419);
                                    let _e1078 = ((_e1062.x - _e241) * _e399);
                                    let _e1079 = ((_e1062.y - _e243) * _e409);
                                    let _e1080 = ((_e1062.z - _e245) * _e419);
                                    if (_e1069 < _e1078) {
                                        phi_1229_ = _e1069;
                                    } else {
                                        phi_1229_ = _e1078;
                                    }
                                    let _e1083 = phi_1229_;
                                    if (_e1070 < _e1079) {
                                        phi_1234_ = _e1070;
                                    } else {
                                        phi_1234_ = _e1079;
                                    }
                                    let _e1086 = phi_1234_;
                                    if (_e1071 < _e1080) {
                                        phi_1239_ = _e1071;
                                    } else {
                                        phi_1239_ = _e1080;
                                    }
                                    let _e1089 = phi_1239_;
                                    if (_e1069 > _e1078) {
                                        phi_1247_ = _e1069;
                                    } else {
                                        phi_1247_ = _e1078;
                                    }
                                    let _e1095 = phi_1247_;
                                    if (_e1070 > _e1079) {
                                        phi_1252_ = _e1070;
                                    } else {
                                        phi_1252_ = _e1079;
                                    }
                                    let _e1098 = phi_1252_;
                                    if (_e1071 > _e1080) {
                                        phi_1257_ = _e1071;
                                    } else {
                                        phi_1257_ = _e1080;
                                    }
                                    let _e1101 = phi_1257_;
                                    let _e1105 = core_intrinsics_maximum_number_nsz_f32_((_e1083 - _e454), (_e1086 - _e455));
                                    let _e1106 = core_intrinsics_maximum_number_nsz_f32_(_e1105, (_e1089 - _e456));
                                    let _e1107 = core_intrinsics_minimum_number_nsz_f32_((_e1095 + _e454), (_e1098 + _e455));
                                    let _e1108 = core_intrinsics_minimum_number_nsz_f32_(_e1107, (_e1101 + _e456));
                                    if (_e1106 <= _e1108) {
                                        if (_e1106 <= _e251) {
                                            if (_e1108 >= 0f) {
                                                let _e1114 = instances.member[(0u + _e1053)].world_to_object[0u];
                                                let _e1125 = ((((_e1114.x * _e241) + (_e1114.y * _e243)) + (_e1114.z * _e245)) + (_e1114.w * 1f));
                                                let _e1127 = instances.member[(0u + _e1053)].world_to_object[1u];
                                                let _e1138 = ((((_e1127.x * _e241) + (_e1127.y * _e243)) + (_e1127.z * _e245)) + (_e1127.w * 1f));
                                                let _e1140 = instances.member[(0u + _e1053)].world_to_object[2u];
                                                let _e1151 = ((((_e1140.x * _e241) + (_e1140.y * _e243)) + (_e1140.z * _e245)) + (_e1140.w * 1f));
                                                let _e1154 = instances.member[(0u + _e1053)].world_to_object[0u];
                                                let _e1165 = ((((_e1154.x * _e259) + (_e1154.y * _e260)) + (_e1154.z * _e261)) + (_e1154.w * 0f));
                                                let _e1167 = instances.member[(0u + _e1053)].world_to_object[1u];
                                                let _e1178 = ((((_e1167.x * _e259) + (_e1167.y * _e260)) + (_e1167.z * _e261)) + (_e1167.w * 0f));
                                                let _e1180 = instances.member[(0u + _e1053)].world_to_object[2u];
                                                let _e1191 = ((((_e1180.x * _e259) + (_e1180.y * _e260)) + (_e1180.z * _e261)) + (_e1180.w * 0f));
                                                let _e1194 = instances.member[(0u + _e1053)].root;
                                                let _e1196 = instances.member[(0u + _e1053)].first_triangle;
                                                let _e1200 = abs(_e1165);
                                                let _e1201 = abs(_e1178);
                                                let _e1202 = abs(_e1191);
                                                if (abs(_e1125) < 1000000000000000f) {
                                                    if (abs(_e1138) < 1000000000000000f) {
                                                        if (abs(_e1151) < 1000000000000000f) {
                                                            if (_e1200 < 1000000000000000f) {
                                                                if (_e1201 < 1000000000000000f) {
                                                                    if (_e1202 < 1000000000000000f) {
                                                                        if (_e1200 > 0f) {
                                                                            phi_1402_ = bool();
                                                                            phi_1403_ = true;
                                                                        } else {
                                                                            let _e1210 = (_e1201 > 0f);
                                                                            if _e1210 {
                                                                                phi_1401_ = bool();
                                                                            } else {
                                                                                phi_1401_ = (_e1202 > 0f);
                                                                            }
                                                                            let _e1213 = phi_1401_;
                                                                            phi_1402_ = _e1213;
                                                                            phi_1403_ = _e1210;
                                                                        }
                                                                        let _e1215 = phi_1402_;
                                                                        let _e1217 = phi_1403_;
                                                                        if _e1217 {
                                                                            phi_1407_ = true;
                                                                        } else {
                                                                            phi_1407_ = _e1215;
                                                                        }
                                                                        let _e1219 = phi_1407_;
                                                                        phi_1408_ = _e1219;
                                                                        phi_1409_ = false;
                                                                    } else {
                                                                        phi_1408_ = bool();
                                                                        phi_1409_ = true;
                                                                    }
                                                                    let _e1221 = phi_1408_;
                                                                    let _e1223 = phi_1409_;
                                                                    phi_1410_ = _e1221;
                                                                    phi_1411_ = false;
                                                                    phi_1412_ = _e1223;
                                                                } else {
                                                                    phi_1410_ = bool();
                                                                    phi_1411_ = true;
                                                                    phi_1412_ = false;
                                                                }
                                                                let _e1225 = phi_1410_;
                                                                let _e1227 = phi_1411_;
                                                                let _e1229 = phi_1412_;
                                                                phi_1413_ = _e1225;
                                                                phi_1414_ = _e1227;
                                                                phi_1415_ = _e1229;
                                                            } else {
                                                                phi_1413_ = bool();
                                                                phi_1414_ = true;
                                                                phi_1415_ = false;
                                                            }
                                                            let _e1231 = phi_1413_;
                                                            let _e1233 = phi_1414_;
                                                            let _e1235 = phi_1415_;
                                                            phi_1416_ = _e1231;
                                                            phi_1417_ = _e1233;
                                                            phi_1418_ = _e1235;
                                                        } else {
                                                            phi_1416_ = bool();
                                                            phi_1417_ = true;
                                                            phi_1418_ = false;
                                                        }
                                                        let _e1237 = phi_1416_;
                                                        let _e1239 = phi_1417_;
                                                        let _e1241 = phi_1418_;
                                                        phi_1419_ = _e1237;
                                                        phi_1420_ = _e1239;
                                                        phi_1421_ = _e1241;
                                                    } else {
                                                        phi_1419_ = bool();
                                                        phi_1420_ = true;
                                                        phi_1421_ = false;
                                                    }
                                                    let _e1243 = phi_1419_;
                                                    let _e1245 = phi_1420_;
                                                    let _e1247 = phi_1421_;
                                                    phi_1422_ = _e1243;
                                                    phi_1423_ = _e1245;
                                                    phi_1424_ = _e1247;
                                                } else {
                                                    phi_1422_ = bool();
                                                    phi_1423_ = true;
                                                    phi_1424_ = false;
                                                }
                                                let _e1249 = phi_1422_;
                                                let _e1251 = phi_1423_;
                                                let _e1253 = phi_1424_;
                                                if _e1251 {
                                                    phi_1428_ = true;
                                                } else {
                                                    phi_1428_ = _e1253;
                                                }
                                                let _e1255 = phi_1428_;
                                                if _e1255 {
                                                    phi_1432_ = false;
                                                } else {
                                                    phi_1432_ = _e1249;
                                                }
                                                let _e1257 = phi_1432_;
                                                if _e1257 {
                                                    let _e1258 = (_e1194 >= _e64);
                                                    if _e1258 {
                                                        phi_2804_ = bool();
                                                    } else {
                                                        if (_e1194 < _e64) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1264 = nodes.member[(0u + _e1194)].frame[0u];
                                                        let _e1268 = nodes.member[(0u + _e1194)].frame[1u];
                                                        let _e1272 = nodes.member[(0u + _e1194)].frame[2u];
                                                        let _e1276 = nodes.member[(0u + _e1194)].frame[0u];
                                                        let _e1280 = nodes.member[(0u + _e1194)].frame[1u];
                                                        let _e1284 = nodes.member[(0u + _e1194)].frame[2u];
                                                        let _e1288 = nodes.member[(0u + _e1194)].frame[3u];
                                                        let _e1322 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1165), abs(_e1178));
                                                        let _e1323 = core_intrinsics_maximum_number_nsz_f32_(_e1322, abs(_e1191));
                                                        let _e1324 = (_e1323 * 0.0000000000009094947f);
                                                        if (abs(_e1165) < _e1324) {
                                                            phi_1502_ = _e1324;
                                                        } else {
                                                            phi_1502_ = abs(_e1165);
                                                        }
                                                        let _e1329 = phi_1502_;
                                                        if (_e1165 < 0f) {
                                                            phi_1509_ = (-1f / _e1329);
                                                        } else {
                                                            phi_1509_ = (1f / _e1329);
                                                        }
                                                        let _e1334 = phi_1509_;
                                                        if (abs(_e1178) < _e1324) {
                                                            phi_1516_ = _e1324;
                                                        } else {
                                                            phi_1516_ = abs(_e1178);
                                                        }
                                                        let _e1339 = phi_1516_;
                                                        if (_e1178 < 0f) {
                                                            phi_1523_ = (-1f / _e1339);
                                                        } else {
                                                            phi_1523_ = (1f / _e1339);
                                                        }
                                                        let _e1344 = phi_1523_;
                                                        if (abs(_e1191) < _e1324) {
                                                            phi_1530_ = _e1324;
                                                        } else {
                                                            phi_1530_ = abs(_e1191);
                                                        }
                                                        let _e1349 = phi_1530_;
                                                        if (_e1191 < 0f) {
                                                            phi_1537_ = (-1f / _e1349);
                                                        } else {
                                                            phi_1537_ = (1f / _e1349);
                                                        }
                                                        let _e1354 = phi_1537_;
                                                        let _e1358 = abs((bitcast<f32>(_e1264) - _e1125));
                                                        let _e1359 = abs((bitcast<f32>(_e1268) - _e1138));
                                                        let _e1360 = abs((bitcast<f32>(_e1272) - _e1151));
                                                        let _e1364 = abs(((bitcast<f32>(_e1276) + (bitcast<f32>((((_e1288 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1125));
                                                        let _e1365 = abs(((bitcast<f32>(_e1280) + (bitcast<f32>((((_e1288 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1138));
                                                        let _e1366 = abs(((bitcast<f32>(_e1284) + (bitcast<f32>((((_e1288 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1151));
                                                        if (_e1358 > _e1364) {
                                                            phi_1554_ = _e1358;
                                                        } else {
                                                            phi_1554_ = _e1364;
                                                        }
                                                        let _e1369 = phi_1554_;
                                                        if (_e1359 > _e1365) {
                                                            phi_1559_ = _e1359;
                                                        } else {
                                                            phi_1559_ = _e1365;
                                                        }
                                                        let _e1372 = phi_1559_;
                                                        if (_e1360 > _e1366) {
                                                            phi_1564_ = _e1360;
                                                        } else {
                                                            phi_1564_ = _e1366;
                                                        }
                                                        let _e1375 = phi_1564_;
                                                        let _e1376 = core_intrinsics_maximum_number_nsz_f32_(_e1369, _e1372);
                                                        let _e1377 = core_intrinsics_maximum_number_nsz_f32_(_e1376, _e1375);
                                                        let _e1381 = (_e1377 * 0.0000019073486f);
                                                        let _e1382 = (abs(_e1334) * _e1381);
                                                        let _e1383 = (abs(_e1344) * _e1381);
                                                        let _e1384 = (abs(_e1354) * _e1381);
                                                        let _e1388 = (_e1377 * 0.0000009536743f);
                                                        let _e1389 = (abs(_e1334) * _e1388);
                                                        let _e1390 = (abs(_e1344) * _e1388);
                                                        let _e1391 = (abs(_e1354) * _e1388);
                                                        let _e1392 = abs(_e1165);
                                                        let _e1393 = abs(_e1178);
                                                        let _e1394 = abs(_e1191);
                                                        if (_e1392 >= _e1393) {
                                                            if (_e1392 >= _e1394) {
                                                                phi_1592_ = false;
                                                            } else {
                                                                phi_1592_ = true;
                                                            }
                                                            let _e1398 = phi_1592_;
                                                            phi_1593_ = _e1398;
                                                        } else {
                                                            phi_1593_ = true;
                                                        }
                                                        let _e1400 = phi_1593_;
                                                        if _e1400 {
                                                            if (_e1393 >= _e1394) {
                                                                phi_1601_ = 1u;
                                                            } else {
                                                                phi_1601_ = 2u;
                                                            }
                                                            let _e1403 = phi_1601_;
                                                            phi_1602_ = _e1403;
                                                        } else {
                                                            phi_1602_ = 0u;
                                                        }
                                                        let _e1405 = phi_1602_;
                                                        if (_e1405 == 0u) {
                                                            phi_1614_ = vec3<f32>(_e1178, _e1191, _e1165);
                                                        } else {
                                                            if (_e1405 == 1u) {
                                                                phi_1613_ = vec3<f32>(_e1191, _e1165, _e1178);
                                                            } else {
                                                                phi_1613_ = vec3<f32>(_e1165, _e1178, _e1191);
                                                            }
                                                            let _e1411 = phi_1613_;
                                                            phi_1614_ = _e1411;
                                                        }
                                                        let _e1413 = phi_1614_;
                                                        let _e1416 = (_e1413.x / _e1413.z);
                                                        let _e1419 = (_e1413.y / _e1413.z);
                                                        if (_e1334 < 0f) {
                                                            phi_1627_ = 0u;
                                                        } else {
                                                            phi_1627_ = 1u;
                                                        }
                                                        let _e1424 = phi_1627_;
                                                        if (_e1344 < 0f) {
                                                            phi_1632_ = 0u;
                                                        } else {
                                                            phi_1632_ = 2u;
                                                        }
                                                        let _e1427 = phi_1632_;
                                                        if (_e1354 < 0f) {
                                                            phi_1637_ = 0u;
                                                        } else {
                                                            phi_1637_ = 4u;
                                                        }
                                                        let _e1430 = phi_1637_;
                                                        let _e1432 = ((_e1424 | _e1427) | _e1430);
                                                        let _e1433 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1194, 2147483648u);
                                                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1433.first[0], _e1433.first[1], _e1433.first[2], _e1433.first[3], _e1433.first[4], _e1433.first[5], _e1433.first[6], _e1433.first[7], _e1433.first[8], _e1433.first[9], _e1433.first[10], _e1433.first[11], _e1433.first[12], _e1433.first[13], _e1433.first[14], _e1433.first[15], _e1433.first[16], _e1433.first[17], _e1433.first[18], _e1433.first[19], _e1433.first[20], _e1433.first[21], _e1433.first[22], _e1433.first[23], _e1433.first[24], _e1433.first[25], _e1433.first[26], _e1433.first[27], _e1433.first[28], _e1433.first[29], _e1433.first[30], _e1433.first[31]), array<u32, 32>(_e1433.mask[0], _e1433.mask[1], _e1433.mask[2], _e1433.mask[3], _e1433.mask[4], _e1433.mask[5], _e1433.mask[6], _e1433.mask[7], _e1433.mask[8], _e1433.mask[9], _e1433.mask[10], _e1433.mask[11], _e1433.mask[12], _e1433.mask[13], _e1433.mask[14], _e1433.mask[15], _e1433.mask[16], _e1433.mask[17], _e1433.mask[18], _e1433.mask[19], _e1433.mask[20], _e1433.mask[21], _e1433.mask[22], _e1433.mask[23], _e1433.mask[24], _e1433.mask[25], _e1433.mask[26], _e1433.mask[27], _e1433.mask[28], _e1433.mask[29], _e1433.mask[30], _e1433.mask[31]), _e1433.len, _e1433.group, _e1433.group_mask);
                                                        let _e1507 = local.group_mask;
                                                        if ((_e1507 & 4278190080u) == 0u) {
                                                            let _e1511 = local.len;
                                                            if (_e1511 == 0u) {
                                                                phi_1751_ = false;
                                                            } else {
                                                                let _e1515 = local.len;
                                                                local.len = (_e1515 - 1u);
                                                                let _e1518 = local.len;
                                                                if (_e1518 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1523 = local.first[(0u + _e1518)];
                                                                local.group = _e1523;
                                                                let _e1526 = local.len;
                                                                if (_e1526 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1531 = local.mask[(0u + _e1526)];
                                                                local.group_mask = _e1531;
                                                                phi_1751_ = true;
                                                            }
                                                            let _e1534 = phi_1751_;
                                                            phi_1752_ = _e1534;
                                                        } else {
                                                            phi_1752_ = true;
                                                        }
                                                        let _e1536 = phi_1752_;
                                                        if _e1536 {
                                                            let _e1538 = local.group_mask;
                                                            let _e1544 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1538)), 32u, (_e1538 == 0u)));
                                                            let _e1548 = local.group_mask;
                                                            let _e1562 = local.group_mask;
                                                            local.group_mask = (_e1562 & ~((1u << bitcast<u32>((_e1544 & 31u)))));
                                                            let _e1565 = local.group;
                                                            phi_1783_ = (_e1565 + countOneBits(((_e1548 & ~((4294967295u << bitcast<u32>((((_e1544 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_1783_ = 4294967295u;
                                                        }
                                                        let _e1568 = phi_1783_;
                                                        phi_1785_ = _e1568;
                                                        phi_1788_ = _e1045;
                                                        loop {
                                                            let _e1570 = phi_1785_;
                                                            let _e1572 = phi_1788_;
                                                            local_15 = _e1572;
                                                            if (_e1570 != 4294967295u) {
                                                                if (_e1570 < _e64) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1579 = nodes.member[(0u + _e1570)].frame[3u];
                                                                let _e1604 = (bitcast<f32>((((_e1579 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1334);
                                                                let _e1605 = (bitcast<f32>((((_e1579 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1344);
                                                                let _e1606 = (bitcast<f32>((((_e1579 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1354);
                                                                let _e1609 = nodes.member[(0u + _e1570)].frame[0u];
                                                                let _e1613 = nodes.member[(0u + _e1570)].frame[1u];
                                                                let _e1617 = nodes.member[(0u + _e1570)].frame[2u];
                                                                let _e1622 = ((bitcast<f32>(_e1609) - _e1125) * _e1334);
                                                                let _e1623 = ((bitcast<f32>(_e1613) - _e1138) * _e1344);
                                                                let _e1624 = ((bitcast<f32>(_e1617) - _e1151) * _e1354);
                                                                let _e1632 = nodes.member[(0u + _e1570)].x;
                                                                if (_e1334 < 0f) {
                                                                    let _e1643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1632.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1643.unnamed.word, _e1632.w), _e1643.unnamed_1);
                                                                    let _e1655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1649.unnamed, lt_mask_LightPlace(_e1632.x, _e1649.unnamed_1.shift));
                                                                    phi_1868_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1655.unnamed, lt_mask_LightPlace(_e1655.unnamed_1.word, _e1632.y));
                                                                } else {
                                                                    let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1632.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1671.unnamed.word, _e1632.y), _e1671.unnamed_1);
                                                                    let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_mask_LightPlace(_e1632.z, _e1677.unnamed_1.shift));
                                                                    phi_1868_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_mask_LightPlace(_e1683.unnamed_1.word, _e1632.w));
                                                                }
                                                                let _e1691 = phi_1868_;
                                                                let _e1701 = nodes.member[(0u + _e1570)].y;
                                                                if (_e1344 < 0f) {
                                                                    let _e1712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1701.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1712.unnamed.word, _e1701.w), _e1712.unnamed_1);
                                                                    let _e1724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1718.unnamed, lt_mask_LightPlace(_e1701.x, _e1718.unnamed_1.shift));
                                                                    phi_1895_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1724.unnamed, lt_mask_LightPlace(_e1724.unnamed_1.word, _e1701.y));
                                                                } else {
                                                                    let _e1740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1701.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1740.unnamed.word, _e1701.y), _e1740.unnamed_1);
                                                                    let _e1752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1746.unnamed, lt_mask_LightPlace(_e1701.z, _e1746.unnamed_1.shift));
                                                                    phi_1895_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1752.unnamed, lt_mask_LightPlace(_e1752.unnamed_1.word, _e1701.w));
                                                                }
                                                                let _e1760 = phi_1895_;
                                                                let _e1770 = nodes.member[(0u + _e1570)].z;
                                                                if (_e1354 < 0f) {
                                                                    let _e1781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1770.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1781.unnamed.word, _e1770.w), _e1781.unnamed_1);
                                                                    let _e1793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1787.unnamed, lt_mask_LightPlace(_e1770.x, _e1787.unnamed_1.shift));
                                                                    phi_1922_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1793.unnamed, lt_mask_LightPlace(_e1793.unnamed_1.word, _e1770.y));
                                                                } else {
                                                                    let _e1809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1770.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1809.unnamed.word, _e1770.y), _e1809.unnamed_1);
                                                                    let _e1821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1815.unnamed, lt_mask_LightPlace(_e1770.z, _e1815.unnamed_1.shift));
                                                                    phi_1922_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1821.unnamed, lt_mask_LightPlace(_e1821.unnamed_1.word, _e1770.w));
                                                                }
                                                                let _e1829 = phi_1922_;
                                                                phi_1928_ = 0u;
                                                                phi_1931_ = 0u;
                                                                loop {
                                                                    let _e1839 = phi_1928_;
                                                                    let _e1841 = phi_1931_;
                                                                    local_6 = _e1841;
                                                                    local_7 = _e1841;
                                                                    local_8 = _e1841;
                                                                    let _e1842 = (_e1839 < 8u);
                                                                    if _e1842 {
                                                                        let _e1844 = (_e1839 >> bitcast<u32>(2i));
                                                                        let _e1845 = (_e1839 & 3u);
                                                                        if (_e1844 == 0u) {
                                                                            phi_1945_ = _e1691.unnamed.word;
                                                                        } else {
                                                                            phi_1945_ = _e1691.unnamed.shift;
                                                                        }
                                                                        let _e1848 = phi_1945_;
                                                                        if (_e1844 == 0u) {
                                                                            phi_1955_ = _e1760.unnamed.word;
                                                                        } else {
                                                                            phi_1955_ = _e1760.unnamed.shift;
                                                                        }
                                                                        let _e1857 = phi_1955_;
                                                                        if (_e1844 == 0u) {
                                                                            phi_1965_ = _e1829.unnamed.word;
                                                                        } else {
                                                                            phi_1965_ = _e1829.unnamed.shift;
                                                                        }
                                                                        let _e1866 = phi_1965_;
                                                                        let _e1879 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1848 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u)) * _e1604) + (_e1622 - _e1382)), ((f32(((_e1857 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u)) * _e1605) + (_e1623 - _e1383)));
                                                                        let _e1880 = core_intrinsics_maximum_number_nsz_f32_(_e1879, ((f32(((_e1866 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u)) * _e1606) + (_e1624 - _e1384)));
                                                                        if (_e1844 == 0u) {
                                                                            phi_1983_ = _e1691.unnamed_1.word;
                                                                        } else {
                                                                            phi_1983_ = _e1691.unnamed_1.shift;
                                                                        }
                                                                        let _e1883 = phi_1983_;
                                                                        if (_e1844 == 0u) {
                                                                            phi_1993_ = _e1760.unnamed_1.word;
                                                                        } else {
                                                                            phi_1993_ = _e1760.unnamed_1.shift;
                                                                        }
                                                                        let _e1892 = phi_1993_;
                                                                        if (_e1844 == 0u) {
                                                                            phi_2003_ = _e1829.unnamed_1.word;
                                                                        } else {
                                                                            phi_2003_ = _e1829.unnamed_1.shift;
                                                                        }
                                                                        let _e1901 = phi_2003_;
                                                                        let _e1914 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1883 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u)) * _e1604) + (_e1622 + _e1382)), ((f32(((_e1892 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u)) * _e1605) + (_e1623 + _e1383)));
                                                                        let _e1915 = core_intrinsics_minimum_number_nsz_f32_(_e1914, ((f32(((_e1901 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u)) * _e1606) + (_e1624 + _e1384)));
                                                                        if (_e1880 <= _e1915) {
                                                                            if (_e1880 <= _e251) {
                                                                                if (_e1915 >= 0f) {
                                                                                    if (_e1844 == 0u) {
                                                                                        let _e1922 = nodes.member[(0u + _e1570)].links[2u];
                                                                                        phi_2039_ = _e1922;
                                                                                    } else {
                                                                                        let _e1925 = nodes.member[(0u + _e1570)].links[3u];
                                                                                        phi_2039_ = _e1925;
                                                                                    }
                                                                                    let _e1927 = phi_2039_;
                                                                                    let _e1932 = ((_e1927 >> bitcast<u32>(((_e1845 * 8u) & 31u))) & 255u);
                                                                                    let _e1933 = (_e1932 & 31u);
                                                                                    if (_e1933 >= 24u) {
                                                                                        phi_2052_ = (24u + ((_e1933 - 24u) ^ _e1432));
                                                                                    } else {
                                                                                        phi_2052_ = _e1933;
                                                                                    }
                                                                                    let _e1939 = phi_2052_;
                                                                                    phi_2057_ = (_e1841 | ((_e1932 >> bitcast<u32>(5i)) << bitcast<u32>((_e1939 & 31u))));
                                                                                } else {
                                                                                    phi_2057_ = _e1841;
                                                                                }
                                                                                let _e1947 = phi_2057_;
                                                                                phi_2058_ = _e1947;
                                                                            } else {
                                                                                phi_2058_ = _e1841;
                                                                            }
                                                                            let _e1949 = phi_2058_;
                                                                            phi_2059_ = _e1949;
                                                                        } else {
                                                                            phi_2059_ = _e1841;
                                                                        }
                                                                        let _e1951 = phi_2059_;
                                                                        phi_1929_ = (_e1839 + 1u);
                                                                        phi_1932_ = _e1951;
                                                                    } else {
                                                                        phi_1929_ = u32();
                                                                        phi_1932_ = u32();
                                                                    }
                                                                    let _e1954 = phi_1929_;
                                                                    let _e1956 = phi_1932_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1928_ = _e1954;
                                                                        phi_1931_ = _e1956;
                                                                        break if !(_e1842);
                                                                    }
                                                                }
                                                                let _e1960 = nodes.member[(0u + _e1570)].links[0u];
                                                                let _e1964 = nodes.member[(0u + _e1570)].frame[3u];
                                                                let _e1968 = local_6;
                                                                if ((_e1968 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1972 = local.group_mask;
                                                                    if ((_e1972 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1976 = local.len;
                                                                        if (_e1976 < 32u) {
                                                                            let _e1979 = local.group;
                                                                            let _e1981 = local.len;
                                                                            if (_e1981 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.first[(0u + _e1981)] = _e1979;
                                                                            let _e1987 = local.group_mask;
                                                                            let _e1989 = local.len;
                                                                            if (_e1989 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.mask[(0u + _e1989)] = _e1987;
                                                                            let _e1996 = local.len;
                                                                            local.len = (_e1996 + 1u);
                                                                        }
                                                                    }
                                                                    local.group = (_e1194 + _e1960);
                                                                    let _e2000 = local_7;
                                                                    local.group_mask = ((_e2000 & 4278190080u) | (_e1964 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e2005 = local_8;
                                                                phi_2117_ = (_e2005 & 16777215u);
                                                                phi_2120_ = _e1572;
                                                                loop {
                                                                    let _e2008 = phi_2117_;
                                                                    let _e2010 = phi_2120_;
                                                                    local_13 = _e2010;
                                                                    let _e2011 = (_e2008 == 0u);
                                                                    local_9 = _e2011;
                                                                    local_14 = _e2011;
                                                                    if _e2011 {
                                                                        phi_2118_ = u32();
                                                                        phi_2121_ = bool();
                                                                        phi_2718_ = false;
                                                                    } else {
                                                                        let _e2014 = nodes.member[(0u + _e1570)].links[1u];
                                                                        let _e2019 = ((_e1196 + _e2014) + select(firstTrailingBit(_e2008), 32u, (_e2008 == 0u)));
                                                                        if (_e2019 < arrayLength((&triangles.member))) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2026 = triangles.member[(0u + _e2019)].v0_;
                                                                        let _e2028 = (_e2026.x - _e1125);
                                                                        let _e2030 = (_e2026.y - _e1138);
                                                                        let _e2032 = (_e2026.z - _e1151);
                                                                        if (_e1405 == 0u) {
                                                                            phi_2165_ = vec3<f32>(_e2030, _e2032, _e2028);
                                                                        } else {
                                                                            if (_e1405 == 1u) {
                                                                                phi_2164_ = vec3<f32>(_e2032, _e2028, _e2030);
                                                                            } else {
                                                                                phi_2164_ = (_e2026 - vec3<f32>(_e1125, _e1138, _e1151));
                                                                            }
                                                                            let _e2040 = phi_2164_;
                                                                            phi_2165_ = _e2040;
                                                                        }
                                                                        let _e2042 = phi_2165_;
                                                                        let _e2046 = (_e2042.x - (_e1416 * _e2042.z));
                                                                        let _e2050 = (_e2042.y - (_e1419 * _e2042.z));
                                                                        let _e2052 = triangles.member[(0u + _e2019)].v1_;
                                                                        let _e2054 = (_e2052.x - _e1125);
                                                                        let _e2056 = (_e2052.y - _e1138);
                                                                        let _e2058 = (_e2052.z - _e1151);
                                                                        if (_e1405 == 0u) {
                                                                            phi_2195_ = vec3<f32>(_e2056, _e2058, _e2054);
                                                                        } else {
                                                                            if (_e1405 == 1u) {
                                                                                phi_2194_ = vec3<f32>(_e2058, _e2054, _e2056);
                                                                            } else {
                                                                                phi_2194_ = (_e2052 - vec3<f32>(_e1125, _e1138, _e1151));
                                                                            }
                                                                            let _e2066 = phi_2194_;
                                                                            phi_2195_ = _e2066;
                                                                        }
                                                                        let _e2068 = phi_2195_;
                                                                        let _e2072 = (_e2068.x - (_e1416 * _e2068.z));
                                                                        let _e2076 = (_e2068.y - (_e1419 * _e2068.z));
                                                                        let _e2078 = triangles.member[(0u + _e2019)].v2_;
                                                                        let _e2080 = (_e2078.x - _e1125);
                                                                        let _e2082 = (_e2078.y - _e1138);
                                                                        let _e2084 = (_e2078.z - _e1151);
                                                                        if (_e1405 == 0u) {
                                                                            phi_2225_ = vec3<f32>(_e2082, _e2084, _e2080);
                                                                        } else {
                                                                            if (_e1405 == 1u) {
                                                                                phi_2224_ = vec3<f32>(_e2084, _e2080, _e2082);
                                                                            } else {
                                                                                phi_2224_ = (_e2078 - vec3<f32>(_e1125, _e1138, _e1151));
                                                                            }
                                                                            let _e2092 = phi_2224_;
                                                                            phi_2225_ = _e2092;
                                                                        }
                                                                        let _e2094 = phi_2225_;
                                                                        let _e2098 = (_e2094.x - (_e1416 * _e2094.z));
                                                                        let _e2102 = (_e2094.y - (_e1419 * _e2094.z));
                                                                        if (_e2072 < _e2098) {
                                                                            phi_2244_ = true;
                                                                        } else {
                                                                            if (_e2072 == _e2098) {
                                                                                phi_2243_ = (_e2076 < _e2102);
                                                                            } else {
                                                                                phi_2243_ = false;
                                                                            }
                                                                            let _e2107 = phi_2243_;
                                                                            phi_2244_ = _e2107;
                                                                        }
                                                                        let _e2109 = phi_2244_;
                                                                        if _e2109 {
                                                                            phi_2248_ = _e2102;
                                                                            phi_2249_ = _e2098;
                                                                            phi_2250_ = _e2076;
                                                                            phi_2251_ = _e2072;
                                                                        } else {
                                                                            phi_2248_ = _e2076;
                                                                            phi_2249_ = _e2072;
                                                                            phi_2250_ = _e2102;
                                                                            phi_2251_ = _e2098;
                                                                        }
                                                                        let _e2111 = phi_2248_;
                                                                        let _e2113 = phi_2249_;
                                                                        let _e2115 = phi_2250_;
                                                                        let _e2117 = phi_2251_;
                                                                        let _e2120 = ((_e2117 * _e2111) - (_e2115 * _e2113));
                                                                        if _e2109 {
                                                                            phi_2259_ = -(_e2120);
                                                                        } else {
                                                                            phi_2259_ = _e2120;
                                                                        }
                                                                        let _e2123 = phi_2259_;
                                                                        if (_e2098 < _e2046) {
                                                                            phi_2270_ = true;
                                                                        } else {
                                                                            if (_e2098 == _e2046) {
                                                                                phi_2269_ = (_e2102 < _e2050);
                                                                            } else {
                                                                                phi_2269_ = false;
                                                                            }
                                                                            let _e2128 = phi_2269_;
                                                                            phi_2270_ = _e2128;
                                                                        }
                                                                        let _e2130 = phi_2270_;
                                                                        if _e2130 {
                                                                            phi_2274_ = _e2050;
                                                                            phi_2275_ = _e2046;
                                                                            phi_2276_ = _e2102;
                                                                            phi_2277_ = _e2098;
                                                                        } else {
                                                                            phi_2274_ = _e2102;
                                                                            phi_2275_ = _e2098;
                                                                            phi_2276_ = _e2050;
                                                                            phi_2277_ = _e2046;
                                                                        }
                                                                        let _e2132 = phi_2274_;
                                                                        let _e2134 = phi_2275_;
                                                                        let _e2136 = phi_2276_;
                                                                        let _e2138 = phi_2277_;
                                                                        let _e2141 = ((_e2138 * _e2132) - (_e2136 * _e2134));
                                                                        if _e2130 {
                                                                            phi_2285_ = -(_e2141);
                                                                        } else {
                                                                            phi_2285_ = _e2141;
                                                                        }
                                                                        let _e2144 = phi_2285_;
                                                                        if (_e2046 < _e2072) {
                                                                            phi_2296_ = true;
                                                                        } else {
                                                                            if (_e2046 == _e2072) {
                                                                                phi_2295_ = (_e2050 < _e2076);
                                                                            } else {
                                                                                phi_2295_ = false;
                                                                            }
                                                                            let _e2149 = phi_2295_;
                                                                            phi_2296_ = _e2149;
                                                                        }
                                                                        let _e2151 = phi_2296_;
                                                                        if _e2151 {
                                                                            phi_2300_ = _e2076;
                                                                            phi_2301_ = _e2072;
                                                                            phi_2302_ = _e2050;
                                                                            phi_2303_ = _e2046;
                                                                        } else {
                                                                            phi_2300_ = _e2050;
                                                                            phi_2301_ = _e2046;
                                                                            phi_2302_ = _e2076;
                                                                            phi_2303_ = _e2072;
                                                                        }
                                                                        let _e2153 = phi_2300_;
                                                                        let _e2155 = phi_2301_;
                                                                        let _e2157 = phi_2302_;
                                                                        let _e2159 = phi_2303_;
                                                                        let _e2162 = ((_e2159 * _e2153) - (_e2157 * _e2155));
                                                                        if _e2151 {
                                                                            phi_2311_ = -(_e2162);
                                                                        } else {
                                                                            phi_2311_ = _e2162;
                                                                        }
                                                                        let _e2165 = phi_2311_;
                                                                        if (_e2123 >= 0f) {
                                                                            if (_e2144 >= 0f) {
                                                                                if (_e2165 >= 0f) {
                                                                                    phi_2326_ = ((_e2123 + _e2144) + _e2165);
                                                                                    phi_2327_ = false;
                                                                                } else {
                                                                                    phi_2326_ = f32();
                                                                                    phi_2327_ = true;
                                                                                }
                                                                                let _e2172 = phi_2326_;
                                                                                let _e2174 = phi_2327_;
                                                                                phi_2328_ = _e2172;
                                                                                phi_2329_ = _e2174;
                                                                            } else {
                                                                                phi_2328_ = f32();
                                                                                phi_2329_ = true;
                                                                            }
                                                                            let _e2176 = phi_2328_;
                                                                            let _e2178 = phi_2329_;
                                                                            phi_2330_ = _e2176;
                                                                            phi_2331_ = _e2178;
                                                                        } else {
                                                                            phi_2330_ = f32();
                                                                            phi_2331_ = true;
                                                                        }
                                                                        let _e2180 = phi_2330_;
                                                                        let _e2182 = phi_2331_;
                                                                        if _e2182 {
                                                                            if (_e2123 <= 0f) {
                                                                                if (_e2144 <= 0f) {
                                                                                    let _e2185 = (_e2165 <= 0f);
                                                                                    if _e2185 {
                                                                                    }
                                                                                    phi_2349_ = ((_e2123 + _e2144) + _e2165);
                                                                                    phi_2350_ = false;
                                                                                    phi_2351_ = _e2185;
                                                                                } else {
                                                                                    phi_2349_ = f32();
                                                                                    phi_2350_ = true;
                                                                                    phi_2351_ = false;
                                                                                }
                                                                                let _e2189 = phi_2349_;
                                                                                let _e2191 = phi_2350_;
                                                                                let _e2193 = phi_2351_;
                                                                                phi_2352_ = _e2189;
                                                                                phi_2353_ = _e2191;
                                                                                phi_2354_ = _e2193;
                                                                            } else {
                                                                                phi_2352_ = f32();
                                                                                phi_2353_ = true;
                                                                                phi_2354_ = false;
                                                                            }
                                                                            let _e2195 = phi_2352_;
                                                                            let _e2197 = phi_2353_;
                                                                            let _e2199 = phi_2354_;
                                                                            if _e2197 {
                                                                                phi_2358_ = false;
                                                                            } else {
                                                                                phi_2358_ = _e2199;
                                                                            }
                                                                            let _e2201 = phi_2358_;
                                                                            phi_2359_ = _e2195;
                                                                            phi_2360_ = _e2201;
                                                                        } else {
                                                                            phi_2359_ = _e2180;
                                                                            phi_2360_ = true;
                                                                        }
                                                                        let _e2203 = phi_2359_;
                                                                        let _e2205 = phi_2360_;
                                                                        if _e2205 {
                                                                            let _e2206 = (_e2203 == 0f);
                                                                            if _e2206 {
                                                                                phi_2676_ = lt_bvh_triangle_Intersection();
                                                                                phi_2677_ = false;
                                                                            } else {
                                                                                let _e2208 = triangles.member[(0u + _e2019)].v0_;
                                                                                let _e2210 = (_e2208.x - _e1125);
                                                                                let _e2212 = (_e2208.y - _e1138);
                                                                                let _e2214 = (_e2208.z - _e1151);
                                                                                if (_e1405 == 0u) {
                                                                                    phi_2389_ = vec3<f32>(_e2212, _e2214, _e2210);
                                                                                } else {
                                                                                    if (_e1405 == 1u) {
                                                                                        phi_2388_ = vec3<f32>(_e2214, _e2210, _e2212);
                                                                                    } else {
                                                                                        phi_2388_ = (_e2208 - vec3<f32>(_e1125, _e1138, _e1151));
                                                                                    }
                                                                                    let _e2222 = phi_2388_;
                                                                                    phi_2389_ = _e2222;
                                                                                }
                                                                                let _e2224 = phi_2389_;
                                                                                let _e2226 = triangles.member[(0u + _e2019)].v1_;
                                                                                let _e2228 = triangles.member[(0u + _e2019)].v0_;
                                                                                let _e2231 = (_e2226.x - _e2228.x);
                                                                                let _e2234 = (_e2226.y - _e2228.y);
                                                                                let _e2237 = (_e2226.z - _e2228.z);
                                                                                if (_e1405 == 0u) {
                                                                                    phi_2415_ = vec3<f32>(_e2234, _e2237, _e2231);
                                                                                } else {
                                                                                    if (_e1405 == 1u) {
                                                                                        phi_2414_ = vec3<f32>(_e2237, _e2231, _e2234);
                                                                                    } else {
                                                                                        phi_2414_ = (_e2226 - _e2228);
                                                                                    }
                                                                                    let _e2244 = phi_2414_;
                                                                                    phi_2415_ = _e2244;
                                                                                }
                                                                                let _e2246 = phi_2415_;
                                                                                let _e2248 = triangles.member[(0u + _e2019)].v2_;
                                                                                let _e2250 = triangles.member[(0u + _e2019)].v0_;
                                                                                let _e2253 = (_e2248.x - _e2250.x);
                                                                                let _e2256 = (_e2248.y - _e2250.y);
                                                                                let _e2259 = (_e2248.z - _e2250.z);
                                                                                if (_e1405 == 0u) {
                                                                                    phi_2441_ = vec3<f32>(_e2256, _e2259, _e2253);
                                                                                } else {
                                                                                    if (_e1405 == 1u) {
                                                                                        phi_2440_ = vec3<f32>(_e2259, _e2253, _e2256);
                                                                                    } else {
                                                                                        phi_2440_ = (_e2248 - _e2250);
                                                                                    }
                                                                                    let _e2266 = phi_2440_;
                                                                                    phi_2441_ = _e2266;
                                                                                }
                                                                                let _e2268 = phi_2441_;
                                                                                let _e2275 = ((_e2246.y * _e2268.z) - (_e2246.z * _e2268.y));
                                                                                let _e2282 = ((_e2246.z * _e2268.x) - (_e2246.x * _e2268.z));
                                                                                let _e2289 = ((_e2246.x * _e2268.y) - (_e2246.y * _e2268.x));
                                                                                let _e2303 = (((1f / _e1413.z) * (((_e2275 * _e2224.x) + (_e2282 * _e2224.y)) + (_e2289 * _e2224.z))) / (((_e2275 * _e1416) + (_e2282 * _e1419)) + _e2289));
                                                                                if (_e2303 > 0f) {
                                                                                    if (_e2303 < _e251) {
                                                                                        let _e2307 = triangles.member[(0u + _e2019)].v0_;
                                                                                        let _e2309 = triangles.member[(0u + _e2019)].v1_;
                                                                                        if (_e2307.x < _e2309.x) {
                                                                                            phi_2497_ = _e2307.x;
                                                                                        } else {
                                                                                            phi_2497_ = _e2309.x;
                                                                                        }
                                                                                        let _e2316 = phi_2497_;
                                                                                        if (_e2307.y < _e2309.y) {
                                                                                            phi_2506_ = _e2307.y;
                                                                                        } else {
                                                                                            phi_2506_ = _e2309.y;
                                                                                        }
                                                                                        let _e2323 = phi_2506_;
                                                                                        if (_e2307.z < _e2309.z) {
                                                                                            phi_2515_ = _e2307.z;
                                                                                        } else {
                                                                                            phi_2515_ = _e2309.z;
                                                                                        }
                                                                                        let _e2330 = phi_2515_;
                                                                                        let _e2332 = triangles.member[(0u + _e2019)].v2_;
                                                                                        if (_e2316 < _e2332.x) {
                                                                                            phi_2524_ = _e2316;
                                                                                        } else {
                                                                                            phi_2524_ = _e2332.x;
                                                                                        }
                                                                                        let _e2337 = phi_2524_;
                                                                                        if (_e2323 < _e2332.y) {
                                                                                            phi_2531_ = _e2323;
                                                                                        } else {
                                                                                            phi_2531_ = _e2332.y;
                                                                                        }
                                                                                        let _e2342 = phi_2531_;
                                                                                        if (_e2330 < _e2332.z) {
                                                                                            phi_2538_ = _e2330;
                                                                                        } else {
                                                                                            phi_2538_ = _e2332.z;
                                                                                        }
                                                                                        let _e2347 = phi_2538_;
                                                                                        let _e2349 = triangles.member[(0u + _e2019)].v0_;
                                                                                        let _e2351 = triangles.member[(0u + _e2019)].v1_;
                                                                                        if (_e2349.x > _e2351.x) {
                                                                                            phi_2551_ = _e2349.x;
                                                                                        } else {
                                                                                            phi_2551_ = _e2351.x;
                                                                                        }
                                                                                        let _e2358 = phi_2551_;
                                                                                        if (_e2349.y > _e2351.y) {
                                                                                            phi_2560_ = _e2349.y;
                                                                                        } else {
                                                                                            phi_2560_ = _e2351.y;
                                                                                        }
                                                                                        let _e2365 = phi_2560_;
                                                                                        if (_e2349.z > _e2351.z) {
                                                                                            phi_2569_ = _e2349.z;
                                                                                        } else {
                                                                                            phi_2569_ = _e2351.z;
                                                                                        }
                                                                                        let _e2372 = phi_2569_;
                                                                                        let _e2374 = triangles.member[(0u + _e2019)].v2_;
                                                                                        if (_e2358 > _e2374.x) {
                                                                                            phi_2578_ = _e2358;
                                                                                        } else {
                                                                                            phi_2578_ = _e2374.x;
                                                                                        }
                                                                                        let _e2379 = phi_2578_;
                                                                                        if (_e2365 > _e2374.y) {
                                                                                            phi_2585_ = _e2365;
                                                                                        } else {
                                                                                            phi_2585_ = _e2374.y;
                                                                                        }
                                                                                        let _e2384 = phi_2585_;
                                                                                        if (_e2372 > _e2374.z) {
                                                                                            phi_2592_ = _e2372;
                                                                                        } else {
                                                                                            phi_2592_ = _e2374.z;
                                                                                        }
                                                                                        let _e2389 = phi_2592_;
                                                                                        let _e2393 = ((_e2337 - _e1125) * _e1334);
                                                                                        let _e2394 = ((_e2342 - _e1138) * _e1344);
                                                                                        let _e2395 = ((_e2347 - _e1151) * _e1354);
                                                                                        let _e2399 = ((_e2379 - _e1125) * _e1334);
                                                                                        let _e2400 = ((_e2384 - _e1138) * _e1344);
                                                                                        let _e2401 = ((_e2389 - _e1151) * _e1354);
                                                                                        if (_e2393 < _e2399) {
                                                                                            phi_2609_ = _e2393;
                                                                                        } else {
                                                                                            phi_2609_ = _e2399;
                                                                                        }
                                                                                        let _e2404 = phi_2609_;
                                                                                        if (_e2394 < _e2400) {
                                                                                            phi_2614_ = _e2394;
                                                                                        } else {
                                                                                            phi_2614_ = _e2400;
                                                                                        }
                                                                                        let _e2407 = phi_2614_;
                                                                                        if (_e2395 < _e2401) {
                                                                                            phi_2619_ = _e2395;
                                                                                        } else {
                                                                                            phi_2619_ = _e2401;
                                                                                        }
                                                                                        let _e2410 = phi_2619_;
                                                                                        if (_e2393 > _e2399) {
                                                                                            phi_2627_ = _e2393;
                                                                                        } else {
                                                                                            phi_2627_ = _e2399;
                                                                                        }
                                                                                        let _e2416 = phi_2627_;
                                                                                        if (_e2394 > _e2400) {
                                                                                            phi_2632_ = _e2394;
                                                                                        } else {
                                                                                            phi_2632_ = _e2400;
                                                                                        }
                                                                                        let _e2419 = phi_2632_;
                                                                                        if (_e2395 > _e2401) {
                                                                                            phi_2637_ = _e2395;
                                                                                        } else {
                                                                                            phi_2637_ = _e2401;
                                                                                        }
                                                                                        let _e2422 = phi_2637_;
                                                                                        let _e2426 = core_intrinsics_maximum_number_nsz_f32_((_e2404 - _e1389), (_e2407 - _e1390));
                                                                                        let _e2427 = core_intrinsics_maximum_number_nsz_f32_(_e2426, (_e2410 - _e1391));
                                                                                        let _e2428 = core_intrinsics_minimum_number_nsz_f32_((_e2416 + _e1389), (_e2419 + _e1390));
                                                                                        let _e2429 = core_intrinsics_minimum_number_nsz_f32_(_e2428, (_e2422 + _e1391));
                                                                                        if (_e2427 > _e1106) {
                                                                                            phi_2649_ = _e2427;
                                                                                        } else {
                                                                                            phi_2649_ = _e1106;
                                                                                        }
                                                                                        let _e2432 = phi_2649_;
                                                                                        if (_e2429 < _e1108) {
                                                                                            phi_2654_ = _e2429;
                                                                                        } else {
                                                                                            phi_2654_ = _e1108;
                                                                                        }
                                                                                        let _e2435 = phi_2654_;
                                                                                        if (_e2303 < _e2432) {
                                                                                            phi_2659_ = _e2432;
                                                                                        } else {
                                                                                            phi_2659_ = _e2303;
                                                                                        }
                                                                                        let _e2438 = phi_2659_;
                                                                                        if (_e2438 > _e2435) {
                                                                                            phi_2664_ = _e2435;
                                                                                        } else {
                                                                                            phi_2664_ = _e2438;
                                                                                        }
                                                                                        let _e2441 = phi_2664_;
                                                                                        phi_2669_ = lt_bvh_triangle_Intersection(_e2441, (_e2144 / _e2203), (_e2165 / _e2203), (_e2432 <= _e2435));
                                                                                        phi_2670_ = false;
                                                                                    } else {
                                                                                        phi_2669_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2670_ = true;
                                                                                    }
                                                                                    let _e2447 = phi_2669_;
                                                                                    let _e2449 = phi_2670_;
                                                                                    phi_2671_ = _e2447;
                                                                                    phi_2672_ = _e2449;
                                                                                } else {
                                                                                    phi_2671_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2672_ = true;
                                                                                }
                                                                                let _e2451 = phi_2671_;
                                                                                let _e2453 = phi_2672_;
                                                                                if _e2453 {
                                                                                }
                                                                                phi_2676_ = _e2451;
                                                                                phi_2677_ = _e2453;
                                                                            }
                                                                            let _e2455 = phi_2676_;
                                                                            let _e2457 = phi_2677_;
                                                                            phi_2678_ = _e2455;
                                                                            phi_2679_ = _e2206;
                                                                            phi_2680_ = _e2457;
                                                                        } else {
                                                                            phi_2678_ = lt_bvh_triangle_Intersection();
                                                                            phi_2679_ = true;
                                                                            phi_2680_ = false;
                                                                        }
                                                                        let _e2459 = phi_2678_;
                                                                        let _e2461 = phi_2679_;
                                                                        let _e2463 = phi_2680_;
                                                                        if _e2461 {
                                                                            phi_2684_ = true;
                                                                        } else {
                                                                            phi_2684_ = _e2463;
                                                                        }
                                                                        let _e2465 = phi_2684_;
                                                                        if _e2465 {
                                                                            phi_2688_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2688_ = _e2459;
                                                                        }
                                                                        let _e2467 = phi_2688_;
                                                                        if _e2467.is_hit {
                                                                            if (_e2467.t > 0f) {
                                                                                if (_e2467.t < _e251) {
                                                                                    if true {
                                                                                        phi_2708_ = false;
                                                                                    } else {
                                                                                        phi_2708_ = true;
                                                                                    }
                                                                                    let _e2476 = phi_2708_;
                                                                                    phi_2709_ = true;
                                                                                    phi_2710_ = _e2476;
                                                                                } else {
                                                                                    phi_2709_ = _e2010;
                                                                                    phi_2710_ = true;
                                                                                }
                                                                                let _e2478 = phi_2709_;
                                                                                let _e2480 = phi_2710_;
                                                                                phi_2711_ = _e2478;
                                                                                phi_2712_ = _e2480;
                                                                            } else {
                                                                                phi_2711_ = _e2010;
                                                                                phi_2712_ = true;
                                                                            }
                                                                            let _e2482 = phi_2711_;
                                                                            let _e2484 = phi_2712_;
                                                                            phi_2713_ = _e2482;
                                                                            phi_2714_ = _e2484;
                                                                        } else {
                                                                            phi_2713_ = _e2010;
                                                                            phi_2714_ = true;
                                                                        }
                                                                        let _e2486 = phi_2713_;
                                                                        let _e2488 = phi_2714_;
                                                                        if _e2488 {
                                                                        }
                                                                        phi_2118_ = (_e2008 & (_e2008 - 1u));
                                                                        phi_2121_ = _e2486;
                                                                        phi_2718_ = _e2488;
                                                                    }
                                                                    let _e2490 = phi_2118_;
                                                                    let _e2492 = phi_2121_;
                                                                    let _e2494 = phi_2718_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2117_ = _e2490;
                                                                        phi_2120_ = _e2492;
                                                                        break if !(_e2494);
                                                                    }
                                                                }
                                                                let _e2497 = local_9;
                                                                if _e2497 {
                                                                    let _e2499 = local.group_mask;
                                                                    if ((_e2499 & 4278190080u) == 0u) {
                                                                        let _e2503 = local.len;
                                                                        if (_e2503 == 0u) {
                                                                            phi_2760_ = false;
                                                                        } else {
                                                                            let _e2507 = local.len;
                                                                            local.len = (_e2507 - 1u);
                                                                            let _e2510 = local.len;
                                                                            if (_e2510 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2515 = local.first[(0u + _e2510)];
                                                                            local.group = _e2515;
                                                                            let _e2518 = local.len;
                                                                            if (_e2518 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2523 = local.mask[(0u + _e2518)];
                                                                            local.group_mask = _e2523;
                                                                            phi_2760_ = true;
                                                                        }
                                                                        let _e2526 = phi_2760_;
                                                                        phi_2761_ = _e2526;
                                                                    } else {
                                                                        phi_2761_ = true;
                                                                    }
                                                                    let _e2528 = phi_2761_;
                                                                    if _e2528 {
                                                                        let _e2530 = local.group_mask;
                                                                        let _e2536 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2530)), 32u, (_e2530 == 0u)));
                                                                        let _e2540 = local.group_mask;
                                                                        let _e2554 = local.group_mask;
                                                                        local.group_mask = (_e2554 & ~((1u << bitcast<u32>((_e2536 & 31u)))));
                                                                        let _e2557 = local.group;
                                                                        phi_2792_ = (_e2557 + countOneBits(((_e2540 & ~((4294967295u << bitcast<u32>((((_e2536 - 24u) ^ _e1432) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2792_ = 4294967295u;
                                                                    }
                                                                    let _e2560 = phi_2792_;
                                                                    phi_2793_ = _e2560;
                                                                } else {
                                                                    phi_2793_ = u32();
                                                                }
                                                                let _e2562 = phi_2793_;
                                                                phi_1786_ = _e2562;
                                                                let _e2952 = local_13;
                                                                phi_1789_ = _e2952;
                                                                let _e2955 = local_14;
                                                                phi_2794_ = _e2955;
                                                                phi_2795_ = false;
                                                            } else {
                                                                phi_1786_ = u32();
                                                                phi_1789_ = bool();
                                                                phi_2794_ = false;
                                                                phi_2795_ = true;
                                                            }
                                                            let _e2564 = phi_1786_;
                                                            let _e2566 = phi_1789_;
                                                            let _e2568 = phi_2794_;
                                                            let _e2570 = phi_2795_;
                                                            local_10 = _e2570;
                                                            continue;
                                                            continuing {
                                                                phi_1785_ = _e2564;
                                                                phi_1788_ = _e2566;
                                                                break if !(_e2568);
                                                            }
                                                        }
                                                        let _e2573 = local_10;
                                                        if _e2573 {
                                                            phi_2799_ = false;
                                                        } else {
                                                            phi_2799_ = true;
                                                        }
                                                        let _e2575 = phi_2799_;
                                                        if _e2575 {
                                                            phi_2803_ = true;
                                                        } else {
                                                            let _e2961 = local_15;
                                                            phi_2803_ = _e2961;
                                                        }
                                                        let _e2577 = phi_2803_;
                                                        phi_2804_ = _e2577;
                                                    }
                                                    let _e2579 = phi_2804_;
                                                    phi_2805_ = _e2579;
                                                    phi_2806_ = _e1258;
                                                } else {
                                                    phi_2805_ = bool();
                                                    phi_2806_ = true;
                                                }
                                                let _e2581 = phi_2805_;
                                                let _e2583 = phi_2806_;
                                                if _e2583 {
                                                    phi_2810_ = _e1045;
                                                } else {
                                                    phi_2810_ = _e2581;
                                                }
                                                let _e2585 = phi_2810_;
                                                if _e2585 {
                                                    phi_2814_ = false;
                                                } else {
                                                    phi_2814_ = true;
                                                }
                                                let _e2587 = phi_2814_;
                                                phi_2815_ = _e2585;
                                                phi_2816_ = _e2587;
                                            } else {
                                                phi_2815_ = _e1045;
                                                phi_2816_ = true;
                                            }
                                            let _e2589 = phi_2815_;
                                            let _e2591 = phi_2816_;
                                            phi_2817_ = _e2589;
                                            phi_2818_ = _e2591;
                                        } else {
                                            phi_2817_ = _e1045;
                                            phi_2818_ = true;
                                        }
                                        let _e2593 = phi_2817_;
                                        let _e2595 = phi_2818_;
                                        phi_2819_ = _e2593;
                                        phi_2820_ = _e2595;
                                    } else {
                                        phi_2819_ = _e1045;
                                        phi_2820_ = true;
                                    }
                                    let _e2597 = phi_2819_;
                                    let _e2599 = phi_2820_;
                                    if _e2599 {
                                    }
                                    phi_1178_ = (_e1043 & (_e1043 - 1u));
                                    phi_1181_ = _e2597;
                                    phi_2824_ = _e2599;
                                }
                                let _e2601 = phi_1178_;
                                let _e2603 = phi_1181_;
                                let _e2605 = phi_2824_;
                                continue;
                                continuing {
                                    phi_1177_ = _e2601;
                                    phi_1180_ = _e2603;
                                    break if !(_e2605);
                                }
                            }
                            let _e2608 = local_11;
                            if _e2608 {
                                let _e2610 = local_1.group_mask;
                                if ((_e2610 & 4278190080u) == 0u) {
                                    let _e2614 = local_1.len;
                                    if (_e2614 == 0u) {
                                        phi_2866_ = false;
                                    } else {
                                        let _e2618 = local_1.len;
                                        local_1.len = (_e2618 - 1u);
                                        let _e2621 = local_1.len;
                                        if (_e2621 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2626 = local_1.first[(0u + _e2621)];
                                        local_1.group = _e2626;
                                        let _e2629 = local_1.len;
                                        if (_e2629 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2634 = local_1.mask[(0u + _e2629)];
                                        local_1.group_mask = _e2634;
                                        phi_2866_ = true;
                                    }
                                    let _e2637 = phi_2866_;
                                    phi_2867_ = _e2637;
                                } else {
                                    phi_2867_ = true;
                                }
                                let _e2639 = phi_2867_;
                                if _e2639 {
                                    let _e2641 = local_1.group_mask;
                                    let _e2647 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2641)), 32u, (_e2641 == 0u)));
                                    let _e2651 = local_1.group_mask;
                                    let _e2665 = local_1.group_mask;
                                    local_1.group_mask = (_e2665 & ~((1u << bitcast<u32>((_e2647 & 31u)))));
                                    let _e2668 = local_1.group;
                                    phi_2898_ = (_e2668 + countOneBits(((_e2651 & ~((4294967295u << bitcast<u32>((((_e2647 - 24u) ^ _e467) & 31u))))) & 255u)));
                                } else {
                                    phi_2898_ = 4294967295u;
                                }
                                let _e2671 = phi_2898_;
                                phi_2899_ = _e2671;
                            } else {
                                phi_2899_ = u32();
                            }
                            let _e2673 = phi_2899_;
                            phi_846_ = _e2673;
                            let _e2984 = local_16;
                            phi_849_ = _e2984;
                            let _e2987 = local_17;
                            phi_2900_ = _e2987;
                            phi_2901_ = false;
                        } else {
                            phi_846_ = u32();
                            phi_849_ = bool();
                            phi_2900_ = false;
                            phi_2901_ = true;
                        }
                        let _e2675 = phi_846_;
                        let _e2677 = phi_849_;
                        let _e2679 = phi_2900_;
                        let _e2681 = phi_2901_;
                        local_12 = _e2681;
                        continue;
                        continuing {
                            phi_845_ = _e2675;
                            phi_848_ = _e2677;
                            break if !(_e2679);
                        }
                    }
                    let _e2684 = local_12;
                    if _e2684 {
                        phi_2905_ = false;
                    } else {
                        phi_2905_ = true;
                    }
                    let _e2686 = phi_2905_;
                    if _e2686 {
                    }
                    phi_2909_ = _e2686;
                }
                let _e2688 = phi_2909_;
                phi_2910_ = _e323;
                phi_2911_ = _e2688;
            } else {
                phi_2910_ = true;
                phi_2911_ = false;
            }
            let _e2690 = phi_2910_;
            let _e2692 = phi_2911_;
            if _e2690 {
                phi_2915_ = false;
                phi_2916_ = true;
            } else {
                phi_2915_ = true;
                phi_2916_ = _e2692;
            }
            let _e2694 = phi_2915_;
            let _e2696 = phi_2916_;
            if _e2696 {
                phi_2920_ = _e2694;
            } else {
                phi_2920_ = false;
            }
            let _e2698 = phi_2920_;
            if _e2698 {
                phi_2924_ = 0f;
            } else {
                phi_2924_ = 1f;
            }
            let _e2700 = phi_2924_;
            phi_2925_ = _e2700;
        }
        let _e2702 = phi_2925_;
        if (_e79.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.shift)] = _e2702;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
