struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_32 {
    member: array<lt_bvh_Triangle>,
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

struct type_39 {
    member: array<lt_bvh_Instance>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_48 {
    member: array<lt_bvh_Node>,
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

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_56 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(2) 
var<storage> nodes: type_48;
@group(0) @binding(3) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage> instances: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_188_: lt_bvh_traverse_Tree;
    var phi_189_: bool;
    var phi_190_: lt_bvh_traverse_Tree;
    var phi_191_: bool;
    var phi_196_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_188_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_189_ = false;
        } else {
            phi_188_ = lt_bvh_traverse_Tree();
            phi_189_ = true;
        }
        let _e67 = phi_188_;
        let _e69 = phi_189_;
        phi_190_ = _e67;
        phi_191_ = _e69;
    } else {
        phi_190_ = lt_bvh_traverse_Tree();
        phi_191_ = true;
    }
    let _e71 = phi_190_;
    let _e73 = phi_191_;
    if _e73 {
        phi_196_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_196_ = _e71;
    }
    let _e78 = phi_196_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
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
    var phi_926_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_953_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_980_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_986_: u32;
    var phi_989_: u32;
    var phi_1003_: u32;
    var phi_1013_: u32;
    var phi_1023_: u32;
    var phi_1041_: u32;
    var phi_1051_: u32;
    var phi_1061_: u32;
    var phi_1097_: u32;
    var phi_1110_: u32;
    var phi_1115_: u32;
    var phi_1116_: u32;
    var phi_1117_: u32;
    var phi_987_: u32;
    var phi_990_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1175_: u32;
    var phi_1225_: f32;
    var phi_1230_: f32;
    var phi_1235_: f32;
    var phi_1243_: f32;
    var phi_1248_: f32;
    var phi_1253_: f32;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1405_: bool;
    var phi_1406_: bool;
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
    var phi_1424_: bool;
    var phi_1428_: bool;
    var phi_1498_: f32;
    var phi_1505_: f32;
    var phi_1512_: f32;
    var phi_1519_: f32;
    var phi_1526_: f32;
    var phi_1533_: f32;
    var phi_1550_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1588_: bool;
    var phi_1589_: bool;
    var phi_1597_: u32;
    var phi_1598_: u32;
    var phi_1609_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1623_: u32;
    var phi_1628_: u32;
    var phi_1633_: u32;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1779_: u32;
    var phi_1781_: u32;
    var phi_1862_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1889_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1916_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1922_: u32;
    var phi_1925_: u32;
    var phi_1939_: u32;
    var phi_1949_: u32;
    var phi_1959_: u32;
    var phi_1977_: u32;
    var phi_1987_: u32;
    var phi_1997_: u32;
    var phi_2033_: u32;
    var phi_2046_: u32;
    var phi_2051_: u32;
    var phi_2052_: u32;
    var phi_2053_: u32;
    var phi_1923_: u32;
    var phi_1926_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2111_: u32;
    var phi_2156_: vec3<f32>;
    var phi_2157_: vec3<f32>;
    var phi_2186_: vec3<f32>;
    var phi_2187_: vec3<f32>;
    var phi_2216_: vec3<f32>;
    var phi_2217_: vec3<f32>;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2240_: f32;
    var phi_2241_: f32;
    var phi_2242_: f32;
    var phi_2243_: f32;
    var phi_2251_: f32;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2266_: f32;
    var phi_2267_: f32;
    var phi_2268_: f32;
    var phi_2269_: f32;
    var phi_2277_: f32;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2292_: f32;
    var phi_2293_: f32;
    var phi_2294_: f32;
    var phi_2295_: f32;
    var phi_2303_: f32;
    var phi_2318_: f32;
    var phi_2319_: bool;
    var phi_2320_: f32;
    var phi_2321_: bool;
    var phi_2322_: f32;
    var phi_2323_: bool;
    var phi_2341_: f32;
    var phi_2342_: bool;
    var phi_2343_: bool;
    var phi_2344_: f32;
    var phi_2345_: bool;
    var phi_2346_: bool;
    var phi_2350_: bool;
    var phi_2351_: f32;
    var phi_2352_: bool;
    var phi_2380_: vec3<f32>;
    var phi_2381_: vec3<f32>;
    var phi_2406_: vec3<f32>;
    var phi_2407_: vec3<f32>;
    var phi_2432_: vec3<f32>;
    var phi_2433_: vec3<f32>;
    var phi_2489_: f32;
    var phi_2498_: f32;
    var phi_2507_: f32;
    var phi_2516_: f32;
    var phi_2523_: f32;
    var phi_2530_: f32;
    var phi_2543_: f32;
    var phi_2552_: f32;
    var phi_2561_: f32;
    var phi_2570_: f32;
    var phi_2577_: f32;
    var phi_2584_: f32;
    var phi_2601_: f32;
    var phi_2606_: f32;
    var phi_2611_: f32;
    var phi_2619_: f32;
    var phi_2624_: f32;
    var phi_2629_: f32;
    var phi_2641_: f32;
    var phi_2646_: f32;
    var phi_2651_: f32;
    var phi_2656_: f32;
    var phi_2661_: lt_bvh_triangle_Intersection;
    var phi_2662_: bool;
    var phi_2663_: lt_bvh_triangle_Intersection;
    var phi_2664_: bool;
    var phi_2668_: lt_bvh_triangle_Intersection;
    var phi_2669_: bool;
    var phi_2670_: lt_bvh_triangle_Intersection;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2676_: bool;
    var phi_2680_: lt_bvh_triangle_Intersection;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2712_: bool;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var phi_2112_: u32;
    var phi_2722_: bool;
    var phi_2723_: bool;
    var phi_2724_: bool;
    var local_9: bool;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2798_: u32;
    var phi_2799_: u32;
    var phi_2800_: bool;
    var phi_2801_: bool;
    var phi_1782_: u32;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2804_: bool;
    var phi_2805_: bool;
    var local_10: bool;
    var phi_2809_: bool;
    var phi_2810_: bool;
    var phi_2814_: bool;
    var phi_2818_: bool;
    var phi_2819_: bool;
    var phi_2820_: bool;
    var phi_2821_: bool;
    var phi_2825_: bool;
    var phi_2829_: bool;
    var phi_2830_: bool;
    var phi_2831_: bool;
    var phi_2832_: bool;
    var phi_1176_: u32;
    var phi_2836_: bool;
    var local_11: bool;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2910_: u32;
    var phi_2911_: u32;
    var phi_846_: u32;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var local_12: bool;
    var phi_2917_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2928_: bool;
    var phi_2932_: f32;
    var phi_2933_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;

    let _e57 = id_1;
    let _e64 = arrayLength((&nodes.member));
    let _e76 = p.member.size[0u];
    let _e78 = p.member.size[1u];
    let _e79 = lt_shaders_entry_pixel_index(_e57, _e76, _e78);
    if (bitcast<i32>(_e79.root) != 0i) {
        if (_e79.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e87 = samples.member[(0u + _e79.first_primitive)];
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
            phi_2933_ = _e219.unnamed.visibility;
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
                    phi_2922_ = bool();
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
                    loop {
                        let _e605 = phi_845_;
                        if (_e605 != 4294967295u) {
                            if (_e605 < _e64) {
                            } else {
                                return;
                            }
                            let _e612 = nodes.member[(0u + _e605)].frame[3u];
                            let _e637 = (bitcast<f32>((((_e612 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e399);
                            let _e638 = (bitcast<f32>((((_e612 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e409);
                            let _e639 = (bitcast<f32>((((_e612 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e419);
                            let _e642 = nodes.member[(0u + _e605)].frame[0u];
                            let _e646 = nodes.member[(0u + _e605)].frame[1u];
                            let _e650 = nodes.member[(0u + _e605)].frame[2u];
                            let _e655 = ((bitcast<f32>(_e642) - _e241) * _e399);
                            let _e656 = ((bitcast<f32>(_e646) - _e243) * _e409);
                            let _e657 = ((bitcast<f32>(_e650) - _e245) * _e419);
                            let _e665 = nodes.member[(0u + _e605)].x;
                            if (_e399 < 0f) {
                                let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e665.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e676.unnamed.root, _e665.w), _e676.unnamed_1);
                                let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_bvh_traverse_Tree(_e665.x, _e682.unnamed_1.first_primitive));
                                phi_926_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_bvh_traverse_Tree(_e688.unnamed_1.root, _e665.y));
                            } else {
                                let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e665.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.unnamed.root, _e665.y), _e704.unnamed_1);
                                let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_bvh_traverse_Tree(_e665.z, _e710.unnamed_1.first_primitive));
                                phi_926_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e716.unnamed_1.root, _e665.w));
                            }
                            let _e724 = phi_926_;
                            let _e734 = nodes.member[(0u + _e605)].y;
                            if (_e409 < 0f) {
                                let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e734.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e745.unnamed.root, _e734.w), _e745.unnamed_1);
                                let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_bvh_traverse_Tree(_e734.x, _e751.unnamed_1.first_primitive));
                                phi_953_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_bvh_traverse_Tree(_e757.unnamed_1.root, _e734.y));
                            } else {
                                let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e734.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e773.unnamed.root, _e734.y), _e773.unnamed_1);
                                let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e779.unnamed, lt_bvh_traverse_Tree(_e734.z, _e779.unnamed_1.first_primitive));
                                phi_953_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_bvh_traverse_Tree(_e785.unnamed_1.root, _e734.w));
                            }
                            let _e793 = phi_953_;
                            let _e803 = nodes.member[(0u + _e605)].z;
                            if (_e419 < 0f) {
                                let _e814 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e803.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e820 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e814.unnamed.root, _e803.w), _e814.unnamed_1);
                                let _e826 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e820.unnamed, lt_bvh_traverse_Tree(_e803.x, _e820.unnamed_1.first_primitive));
                                phi_980_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e826.unnamed, lt_bvh_traverse_Tree(_e826.unnamed_1.root, _e803.y));
                            } else {
                                let _e842 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e803.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e848 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e842.unnamed.root, _e803.y), _e842.unnamed_1);
                                let _e854 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e848.unnamed, lt_bvh_traverse_Tree(_e803.z, _e848.unnamed_1.first_primitive));
                                phi_980_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e854.unnamed, lt_bvh_traverse_Tree(_e854.unnamed_1.root, _e803.w));
                            }
                            let _e862 = phi_980_;
                            phi_986_ = 0u;
                            phi_989_ = 0u;
                            loop {
                                let _e872 = phi_986_;
                                let _e874 = phi_989_;
                                local_3 = _e874;
                                local_4 = _e874;
                                local_5 = _e874;
                                let _e875 = (_e872 < 8u);
                                if _e875 {
                                    let _e877 = (_e872 >> bitcast<u32>(2i));
                                    let _e878 = (_e872 & 3u);
                                    if (_e877 == 0u) {
                                        phi_1003_ = _e724.unnamed.root;
                                    } else {
                                        phi_1003_ = _e724.unnamed.first_primitive;
                                    }
                                    let _e881 = phi_1003_;
                                    if (_e877 == 0u) {
                                        phi_1013_ = _e793.unnamed.root;
                                    } else {
                                        phi_1013_ = _e793.unnamed.first_primitive;
                                    }
                                    let _e890 = phi_1013_;
                                    if (_e877 == 0u) {
                                        phi_1023_ = _e862.unnamed.root;
                                    } else {
                                        phi_1023_ = _e862.unnamed.first_primitive;
                                    }
                                    let _e899 = phi_1023_;
                                    let _e912 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e881 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u)) * _e637) + (_e655 - _e447)), ((f32(((_e890 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u)) * _e638) + (_e656 - _e448)));
                                    let _e913 = core_intrinsics_maximum_number_nsz_f32_(_e912, ((f32(((_e899 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u)) * _e639) + (_e657 - _e449)));
                                    if (_e877 == 0u) {
                                        phi_1041_ = _e724.unnamed_1.root;
                                    } else {
                                        phi_1041_ = _e724.unnamed_1.first_primitive;
                                    }
                                    let _e916 = phi_1041_;
                                    if (_e877 == 0u) {
                                        phi_1051_ = _e793.unnamed_1.root;
                                    } else {
                                        phi_1051_ = _e793.unnamed_1.first_primitive;
                                    }
                                    let _e925 = phi_1051_;
                                    if (_e877 == 0u) {
                                        phi_1061_ = _e862.unnamed_1.root;
                                    } else {
                                        phi_1061_ = _e862.unnamed_1.first_primitive;
                                    }
                                    let _e934 = phi_1061_;
                                    let _e947 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e916 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u)) * _e637) + (_e655 + _e447)), ((f32(((_e925 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u)) * _e638) + (_e656 + _e448)));
                                    let _e948 = core_intrinsics_minimum_number_nsz_f32_(_e947, ((f32(((_e934 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u)) * _e639) + (_e657 + _e449)));
                                    if (_e913 <= _e948) {
                                        if (_e913 <= _e251) {
                                            if (_e948 >= 0f) {
                                                if (_e877 == 0u) {
                                                    let _e955 = nodes.member[(0u + _e605)].links[2u];
                                                    phi_1097_ = _e955;
                                                } else {
                                                    let _e958 = nodes.member[(0u + _e605)].links[3u];
                                                    phi_1097_ = _e958;
                                                }
                                                let _e960 = phi_1097_;
                                                let _e965 = ((_e960 >> bitcast<u32>(((_e878 * 8u) & 31u))) & 255u);
                                                let _e966 = (_e965 & 31u);
                                                if (_e966 >= 24u) {
                                                    phi_1110_ = (24u + ((_e966 - 24u) ^ _e467));
                                                } else {
                                                    phi_1110_ = _e966;
                                                }
                                                let _e972 = phi_1110_;
                                                phi_1115_ = (_e874 | ((_e965 >> bitcast<u32>(5i)) << bitcast<u32>((_e972 & 31u))));
                                            } else {
                                                phi_1115_ = _e874;
                                            }
                                            let _e980 = phi_1115_;
                                            phi_1116_ = _e980;
                                        } else {
                                            phi_1116_ = _e874;
                                        }
                                        let _e982 = phi_1116_;
                                        phi_1117_ = _e982;
                                    } else {
                                        phi_1117_ = _e874;
                                    }
                                    let _e984 = phi_1117_;
                                    phi_987_ = (_e872 + 1u);
                                    phi_990_ = _e984;
                                } else {
                                    phi_987_ = u32();
                                    phi_990_ = u32();
                                }
                                let _e987 = phi_987_;
                                let _e989 = phi_990_;
                                continue;
                                continuing {
                                    phi_986_ = _e987;
                                    phi_989_ = _e989;
                                    break if !(_e875);
                                }
                            }
                            let _e993 = nodes.member[(0u + _e605)].links[0u];
                            let _e997 = nodes.member[(0u + _e605)].frame[3u];
                            let _e1001 = local_3;
                            if ((_e1001 & 4278190080u) == 0u) {
                            } else {
                                let _e1005 = local_1.group_mask;
                                if ((_e1005 & 4278190080u) == 0u) {
                                } else {
                                    let _e1009 = local_1.len;
                                    if (_e1009 < 32u) {
                                        let _e1012 = local_1.group;
                                        let _e1014 = local_1.len;
                                        if (_e1014 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1014)] = _e1012;
                                        let _e1020 = local_1.group_mask;
                                        let _e1022 = local_1.len;
                                        if (_e1022 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1022)] = _e1020;
                                        let _e1029 = local_1.len;
                                        local_1.len = (_e1029 + 1u);
                                    }
                                }
                                local_1.group = (_e224 + _e993);
                                let _e1033 = local_4;
                                local_1.group_mask = ((_e1033 & 4278190080u) | (_e997 >> bitcast<u32>(24i)));
                            }
                            let _e1038 = local_5;
                            phi_1175_ = (_e1038 & 16777215u);
                            loop {
                                let _e1041 = phi_1175_;
                                let _e1042 = (_e1041 == 0u);
                                local_11 = _e1042;
                                local_18 = _e1042;
                                if _e1042 {
                                    phi_1176_ = u32();
                                    phi_2836_ = false;
                                } else {
                                    let _e1045 = nodes.member[(0u + _e605)].links[1u];
                                    let _e1049 = (_e1045 + select(firstTrailingBit(_e1041), 32u, (_e1041 == 0u)));
                                    if (_e1049 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1056 = instances.member[(0u + _e1049)].low_world;
                                    let _e1058 = instances.member[(0u + _e1049)].high_world;
                                    let _e1065 = ((_e1056.x - _e241) * _e399);
                                    let _e1066 = ((_e1056.y - _e243) * _e409);
                                    let _e1067 = ((_e1056.z - _e245) * _e419);
                                    let _e1074 = ((_e1058.x - _e241) * _e399);
                                    let _e1075 = ((_e1058.y - _e243) * _e409);
                                    let _e1076 = ((_e1058.z - _e245) * _e419);
                                    if (_e1065 < _e1074) {
                                        phi_1225_ = _e1065;
                                    } else {
                                        phi_1225_ = _e1074;
                                    }
                                    let _e1079 = phi_1225_;
                                    if (_e1066 < _e1075) {
                                        phi_1230_ = _e1066;
                                    } else {
                                        phi_1230_ = _e1075;
                                    }
                                    let _e1082 = phi_1230_;
                                    if (_e1067 < _e1076) {
                                        phi_1235_ = _e1067;
                                    } else {
                                        phi_1235_ = _e1076;
                                    }
                                    let _e1085 = phi_1235_;
                                    if (_e1065 > _e1074) {
                                        phi_1243_ = _e1065;
                                    } else {
                                        phi_1243_ = _e1074;
                                    }
                                    let _e1091 = phi_1243_;
                                    if (_e1066 > _e1075) {
                                        phi_1248_ = _e1066;
                                    } else {
                                        phi_1248_ = _e1075;
                                    }
                                    let _e1094 = phi_1248_;
                                    if (_e1067 > _e1076) {
                                        phi_1253_ = _e1067;
                                    } else {
                                        phi_1253_ = _e1076;
                                    }
                                    let _e1097 = phi_1253_;
                                    let _e1101 = core_intrinsics_maximum_number_nsz_f32_((_e1079 - _e454), (_e1082 - _e455));
                                    let _e1102 = core_intrinsics_maximum_number_nsz_f32_(_e1101, (_e1085 - _e456));
                                    let _e1103 = core_intrinsics_minimum_number_nsz_f32_((_e1091 + _e454), (_e1094 + _e455));
                                    let _e1104 = core_intrinsics_minimum_number_nsz_f32_(_e1103, (_e1097 + _e456));
                                    if (_e1102 <= _e1104) {
                                        if (_e1102 <= _e251) {
                                            if (_e1104 >= 0f) {
                                                let _e1110 = instances.member[(0u + _e1049)].world_to_object[0u];
                                                let _e1121 = ((((_e1110.x * _e241) + (_e1110.y * _e243)) + (_e1110.z * _e245)) + (_e1110.w * 1f));
                                                let _e1123 = instances.member[(0u + _e1049)].world_to_object[1u];
                                                let _e1134 = ((((_e1123.x * _e241) + (_e1123.y * _e243)) + (_e1123.z * _e245)) + (_e1123.w * 1f));
                                                let _e1136 = instances.member[(0u + _e1049)].world_to_object[2u];
                                                let _e1147 = ((((_e1136.x * _e241) + (_e1136.y * _e243)) + (_e1136.z * _e245)) + (_e1136.w * 1f));
                                                let _e1150 = instances.member[(0u + _e1049)].world_to_object[0u];
                                                let _e1161 = ((((_e1150.x * _e259) + (_e1150.y * _e260)) + (_e1150.z * _e261)) + (_e1150.w * 0f));
                                                let _e1163 = instances.member[(0u + _e1049)].world_to_object[1u];
                                                let _e1174 = ((((_e1163.x * _e259) + (_e1163.y * _e260)) + (_e1163.z * _e261)) + (_e1163.w * 0f));
                                                let _e1176 = instances.member[(0u + _e1049)].world_to_object[2u];
                                                let _e1187 = ((((_e1176.x * _e259) + (_e1176.y * _e260)) + (_e1176.z * _e261)) + (_e1176.w * 0f));
                                                let _e1190 = instances.member[(0u + _e1049)].root;
                                                let _e1192 = instances.member[(0u + _e1049)].first_triangle;
                                                let _e1196 = abs(_e1161);
                                                let _e1197 = abs(_e1174);
                                                let _e1198 = abs(_e1187);
                                                if (abs(_e1121) < 1000000000000000f) {
                                                    if (abs(_e1134) < 1000000000000000f) {
                                                        if (abs(_e1147) < 1000000000000000f) {
                                                            if (_e1196 < 1000000000000000f) {
                                                                if (_e1197 < 1000000000000000f) {
                                                                    if (_e1198 < 1000000000000000f) {
                                                                        if (_e1196 > 0f) {
                                                                            phi_1398_ = bool();
                                                                            phi_1399_ = true;
                                                                        } else {
                                                                            let _e1206 = (_e1197 > 0f);
                                                                            if _e1206 {
                                                                                phi_1397_ = bool();
                                                                            } else {
                                                                                phi_1397_ = (_e1198 > 0f);
                                                                            }
                                                                            let _e1209 = phi_1397_;
                                                                            phi_1398_ = _e1209;
                                                                            phi_1399_ = _e1206;
                                                                        }
                                                                        let _e1211 = phi_1398_;
                                                                        let _e1213 = phi_1399_;
                                                                        if _e1213 {
                                                                            phi_1403_ = true;
                                                                        } else {
                                                                            phi_1403_ = _e1211;
                                                                        }
                                                                        let _e1215 = phi_1403_;
                                                                        phi_1404_ = _e1215;
                                                                        phi_1405_ = false;
                                                                    } else {
                                                                        phi_1404_ = bool();
                                                                        phi_1405_ = true;
                                                                    }
                                                                    let _e1217 = phi_1404_;
                                                                    let _e1219 = phi_1405_;
                                                                    phi_1406_ = _e1217;
                                                                    phi_1407_ = false;
                                                                    phi_1408_ = _e1219;
                                                                } else {
                                                                    phi_1406_ = bool();
                                                                    phi_1407_ = true;
                                                                    phi_1408_ = false;
                                                                }
                                                                let _e1221 = phi_1406_;
                                                                let _e1223 = phi_1407_;
                                                                let _e1225 = phi_1408_;
                                                                phi_1409_ = _e1221;
                                                                phi_1410_ = _e1223;
                                                                phi_1411_ = _e1225;
                                                            } else {
                                                                phi_1409_ = bool();
                                                                phi_1410_ = true;
                                                                phi_1411_ = false;
                                                            }
                                                            let _e1227 = phi_1409_;
                                                            let _e1229 = phi_1410_;
                                                            let _e1231 = phi_1411_;
                                                            phi_1412_ = _e1227;
                                                            phi_1413_ = _e1229;
                                                            phi_1414_ = _e1231;
                                                        } else {
                                                            phi_1412_ = bool();
                                                            phi_1413_ = true;
                                                            phi_1414_ = false;
                                                        }
                                                        let _e1233 = phi_1412_;
                                                        let _e1235 = phi_1413_;
                                                        let _e1237 = phi_1414_;
                                                        phi_1415_ = _e1233;
                                                        phi_1416_ = _e1235;
                                                        phi_1417_ = _e1237;
                                                    } else {
                                                        phi_1415_ = bool();
                                                        phi_1416_ = true;
                                                        phi_1417_ = false;
                                                    }
                                                    let _e1239 = phi_1415_;
                                                    let _e1241 = phi_1416_;
                                                    let _e1243 = phi_1417_;
                                                    phi_1418_ = _e1239;
                                                    phi_1419_ = _e1241;
                                                    phi_1420_ = _e1243;
                                                } else {
                                                    phi_1418_ = bool();
                                                    phi_1419_ = true;
                                                    phi_1420_ = false;
                                                }
                                                let _e1245 = phi_1418_;
                                                let _e1247 = phi_1419_;
                                                let _e1249 = phi_1420_;
                                                if _e1247 {
                                                    phi_1424_ = true;
                                                } else {
                                                    phi_1424_ = _e1249;
                                                }
                                                let _e1251 = phi_1424_;
                                                if _e1251 {
                                                    phi_1428_ = false;
                                                } else {
                                                    phi_1428_ = _e1245;
                                                }
                                                let _e1253 = phi_1428_;
                                                if _e1253 {
                                                    let _e1254 = (_e1190 >= _e64);
                                                    if _e1254 {
                                                        phi_2819_ = bool();
                                                    } else {
                                                        if (_e1190 < _e64) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1260 = nodes.member[(0u + _e1190)].frame[0u];
                                                        let _e1264 = nodes.member[(0u + _e1190)].frame[1u];
                                                        let _e1268 = nodes.member[(0u + _e1190)].frame[2u];
                                                        let _e1272 = nodes.member[(0u + _e1190)].frame[0u];
                                                        let _e1276 = nodes.member[(0u + _e1190)].frame[1u];
                                                        let _e1280 = nodes.member[(0u + _e1190)].frame[2u];
                                                        let _e1284 = nodes.member[(0u + _e1190)].frame[3u];
                                                        let _e1318 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1161), abs(_e1174));
                                                        let _e1319 = core_intrinsics_maximum_number_nsz_f32_(_e1318, abs(_e1187));
                                                        let _e1320 = (_e1319 * 0.0000000000009094947f);
                                                        if (abs(_e1161) < _e1320) {
                                                            phi_1498_ = _e1320;
                                                        } else {
                                                            phi_1498_ = abs(_e1161);
                                                        }
                                                        let _e1325 = phi_1498_;
                                                        if (_e1161 < 0f) {
                                                            phi_1505_ = (-1f / _e1325);
                                                        } else {
                                                            phi_1505_ = (1f / _e1325);
                                                        }
                                                        let _e1330 = phi_1505_;
                                                        if (abs(_e1174) < _e1320) {
                                                            phi_1512_ = _e1320;
                                                        } else {
                                                            phi_1512_ = abs(_e1174);
                                                        }
                                                        let _e1335 = phi_1512_;
                                                        if (_e1174 < 0f) {
                                                            phi_1519_ = (-1f / _e1335);
                                                        } else {
                                                            phi_1519_ = (1f / _e1335);
                                                        }
                                                        let _e1340 = phi_1519_;
                                                        if (abs(_e1187) < _e1320) {
                                                            phi_1526_ = _e1320;
                                                        } else {
                                                            phi_1526_ = abs(_e1187);
                                                        }
                                                        let _e1345 = phi_1526_;
                                                        if (_e1187 < 0f) {
                                                            phi_1533_ = (-1f / _e1345);
                                                        } else {
                                                            phi_1533_ = (1f / _e1345);
                                                        }
                                                        let _e1350 = phi_1533_;
                                                        let _e1354 = abs((bitcast<f32>(_e1260) - _e1121));
                                                        let _e1355 = abs((bitcast<f32>(_e1264) - _e1134));
                                                        let _e1356 = abs((bitcast<f32>(_e1268) - _e1147));
                                                        let _e1360 = abs(((bitcast<f32>(_e1272) + (bitcast<f32>((((_e1284 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1121));
                                                        let _e1361 = abs(((bitcast<f32>(_e1276) + (bitcast<f32>((((_e1284 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1134));
                                                        let _e1362 = abs(((bitcast<f32>(_e1280) + (bitcast<f32>((((_e1284 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1147));
                                                        if (_e1354 > _e1360) {
                                                            phi_1550_ = _e1354;
                                                        } else {
                                                            phi_1550_ = _e1360;
                                                        }
                                                        let _e1365 = phi_1550_;
                                                        if (_e1355 > _e1361) {
                                                            phi_1555_ = _e1355;
                                                        } else {
                                                            phi_1555_ = _e1361;
                                                        }
                                                        let _e1368 = phi_1555_;
                                                        if (_e1356 > _e1362) {
                                                            phi_1560_ = _e1356;
                                                        } else {
                                                            phi_1560_ = _e1362;
                                                        }
                                                        let _e1371 = phi_1560_;
                                                        let _e1372 = core_intrinsics_maximum_number_nsz_f32_(_e1365, _e1368);
                                                        let _e1373 = core_intrinsics_maximum_number_nsz_f32_(_e1372, _e1371);
                                                        let _e1377 = (_e1373 * 0.0000019073486f);
                                                        let _e1378 = (abs(_e1330) * _e1377);
                                                        let _e1379 = (abs(_e1340) * _e1377);
                                                        let _e1380 = (abs(_e1350) * _e1377);
                                                        let _e1384 = (_e1373 * 0.0000009536743f);
                                                        let _e1385 = (abs(_e1330) * _e1384);
                                                        let _e1386 = (abs(_e1340) * _e1384);
                                                        let _e1387 = (abs(_e1350) * _e1384);
                                                        let _e1388 = abs(_e1161);
                                                        let _e1389 = abs(_e1174);
                                                        let _e1390 = abs(_e1187);
                                                        if (_e1388 >= _e1389) {
                                                            if (_e1388 >= _e1390) {
                                                                phi_1588_ = false;
                                                            } else {
                                                                phi_1588_ = true;
                                                            }
                                                            let _e1394 = phi_1588_;
                                                            phi_1589_ = _e1394;
                                                        } else {
                                                            phi_1589_ = true;
                                                        }
                                                        let _e1396 = phi_1589_;
                                                        if _e1396 {
                                                            if (_e1389 >= _e1390) {
                                                                phi_1597_ = 1u;
                                                            } else {
                                                                phi_1597_ = 2u;
                                                            }
                                                            let _e1399 = phi_1597_;
                                                            phi_1598_ = _e1399;
                                                        } else {
                                                            phi_1598_ = 0u;
                                                        }
                                                        let _e1401 = phi_1598_;
                                                        if (_e1401 == 0u) {
                                                            phi_1610_ = vec3<f32>(_e1174, _e1187, _e1161);
                                                        } else {
                                                            if (_e1401 == 1u) {
                                                                phi_1609_ = vec3<f32>(_e1187, _e1161, _e1174);
                                                            } else {
                                                                phi_1609_ = vec3<f32>(_e1161, _e1174, _e1187);
                                                            }
                                                            let _e1407 = phi_1609_;
                                                            phi_1610_ = _e1407;
                                                        }
                                                        let _e1409 = phi_1610_;
                                                        let _e1412 = (_e1409.x / _e1409.z);
                                                        let _e1415 = (_e1409.y / _e1409.z);
                                                        if (_e1330 < 0f) {
                                                            phi_1623_ = 0u;
                                                        } else {
                                                            phi_1623_ = 1u;
                                                        }
                                                        let _e1420 = phi_1623_;
                                                        if (_e1340 < 0f) {
                                                            phi_1628_ = 0u;
                                                        } else {
                                                            phi_1628_ = 2u;
                                                        }
                                                        let _e1423 = phi_1628_;
                                                        if (_e1350 < 0f) {
                                                            phi_1633_ = 0u;
                                                        } else {
                                                            phi_1633_ = 4u;
                                                        }
                                                        let _e1426 = phi_1633_;
                                                        let _e1428 = ((_e1420 | _e1423) | _e1426);
                                                        let _e1429 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1190, 2147483648u);
                                                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1429.first[0], _e1429.first[1], _e1429.first[2], _e1429.first[3], _e1429.first[4], _e1429.first[5], _e1429.first[6], _e1429.first[7], _e1429.first[8], _e1429.first[9], _e1429.first[10], _e1429.first[11], _e1429.first[12], _e1429.first[13], _e1429.first[14], _e1429.first[15], _e1429.first[16], _e1429.first[17], _e1429.first[18], _e1429.first[19], _e1429.first[20], _e1429.first[21], _e1429.first[22], _e1429.first[23], _e1429.first[24], _e1429.first[25], _e1429.first[26], _e1429.first[27], _e1429.first[28], _e1429.first[29], _e1429.first[30], _e1429.first[31]), array<u32, 32>(_e1429.mask[0], _e1429.mask[1], _e1429.mask[2], _e1429.mask[3], _e1429.mask[4], _e1429.mask[5], _e1429.mask[6], _e1429.mask[7], _e1429.mask[8], _e1429.mask[9], _e1429.mask[10], _e1429.mask[11], _e1429.mask[12], _e1429.mask[13], _e1429.mask[14], _e1429.mask[15], _e1429.mask[16], _e1429.mask[17], _e1429.mask[18], _e1429.mask[19], _e1429.mask[20], _e1429.mask[21], _e1429.mask[22], _e1429.mask[23], _e1429.mask[24], _e1429.mask[25], _e1429.mask[26], _e1429.mask[27], _e1429.mask[28], _e1429.mask[29], _e1429.mask[30], _e1429.mask[31]), _e1429.len, _e1429.group, _e1429.group_mask);
                                                        let _e1503 = local.group_mask;
                                                        if ((_e1503 & 4278190080u) == 0u) {
                                                            let _e1507 = local.len;
                                                            if (_e1507 == 0u) {
                                                                phi_1747_ = false;
                                                            } else {
                                                                let _e1511 = local.len;
                                                                local.len = (_e1511 - 1u);
                                                                let _e1514 = local.len;
                                                                if (_e1514 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1519 = local.first[(0u + _e1514)];
                                                                local.group = _e1519;
                                                                let _e1522 = local.len;
                                                                if (_e1522 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1527 = local.mask[(0u + _e1522)];
                                                                local.group_mask = _e1527;
                                                                phi_1747_ = true;
                                                            }
                                                            let _e1530 = phi_1747_;
                                                            phi_1748_ = _e1530;
                                                        } else {
                                                            phi_1748_ = true;
                                                        }
                                                        let _e1532 = phi_1748_;
                                                        if _e1532 {
                                                            let _e1534 = local.group_mask;
                                                            let _e1540 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1534)), 32u, (_e1534 == 0u)));
                                                            let _e1544 = local.group_mask;
                                                            let _e1558 = local.group_mask;
                                                            local.group_mask = (_e1558 & ~((1u << bitcast<u32>((_e1540 & 31u)))));
                                                            let _e1561 = local.group;
                                                            phi_1779_ = (_e1561 + countOneBits(((_e1544 & ~((4294967295u << bitcast<u32>((((_e1540 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_1779_ = 4294967295u;
                                                        }
                                                        let _e1564 = phi_1779_;
                                                        phi_1781_ = _e1564;
                                                        loop {
                                                            let _e1566 = phi_1781_;
                                                            if (_e1566 != 4294967295u) {
                                                                if (_e1566 < _e64) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1573 = nodes.member[(0u + _e1566)].frame[3u];
                                                                let _e1598 = (bitcast<f32>((((_e1573 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1330);
                                                                let _e1599 = (bitcast<f32>((((_e1573 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1340);
                                                                let _e1600 = (bitcast<f32>((((_e1573 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1350);
                                                                let _e1603 = nodes.member[(0u + _e1566)].frame[0u];
                                                                let _e1607 = nodes.member[(0u + _e1566)].frame[1u];
                                                                let _e1611 = nodes.member[(0u + _e1566)].frame[2u];
                                                                let _e1616 = ((bitcast<f32>(_e1603) - _e1121) * _e1330);
                                                                let _e1617 = ((bitcast<f32>(_e1607) - _e1134) * _e1340);
                                                                let _e1618 = ((bitcast<f32>(_e1611) - _e1147) * _e1350);
                                                                let _e1626 = nodes.member[(0u + _e1566)].x;
                                                                if (_e1330 < 0f) {
                                                                    let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1626.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1637.unnamed.root, _e1626.w), _e1637.unnamed_1);
                                                                    let _e1649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1643.unnamed, lt_bvh_traverse_Tree(_e1626.x, _e1643.unnamed_1.first_primitive));
                                                                    phi_1862_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1649.unnamed, lt_bvh_traverse_Tree(_e1649.unnamed_1.root, _e1626.y));
                                                                } else {
                                                                    let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1626.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1665.unnamed.root, _e1626.y), _e1665.unnamed_1);
                                                                    let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1671.unnamed, lt_bvh_traverse_Tree(_e1626.z, _e1671.unnamed_1.first_primitive));
                                                                    phi_1862_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_bvh_traverse_Tree(_e1677.unnamed_1.root, _e1626.w));
                                                                }
                                                                let _e1685 = phi_1862_;
                                                                let _e1695 = nodes.member[(0u + _e1566)].y;
                                                                if (_e1340 < 0f) {
                                                                    let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1695.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1706.unnamed.root, _e1695.w), _e1706.unnamed_1);
                                                                    let _e1718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1712.unnamed, lt_bvh_traverse_Tree(_e1695.x, _e1712.unnamed_1.first_primitive));
                                                                    phi_1889_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1718.unnamed, lt_bvh_traverse_Tree(_e1718.unnamed_1.root, _e1695.y));
                                                                } else {
                                                                    let _e1734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1695.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1734.unnamed.root, _e1695.y), _e1734.unnamed_1);
                                                                    let _e1746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1740.unnamed, lt_bvh_traverse_Tree(_e1695.z, _e1740.unnamed_1.first_primitive));
                                                                    phi_1889_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1746.unnamed, lt_bvh_traverse_Tree(_e1746.unnamed_1.root, _e1695.w));
                                                                }
                                                                let _e1754 = phi_1889_;
                                                                let _e1764 = nodes.member[(0u + _e1566)].z;
                                                                if (_e1350 < 0f) {
                                                                    let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1764.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1775.unnamed.root, _e1764.w), _e1775.unnamed_1);
                                                                    let _e1787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1781.unnamed, lt_bvh_traverse_Tree(_e1764.x, _e1781.unnamed_1.first_primitive));
                                                                    phi_1916_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1787.unnamed, lt_bvh_traverse_Tree(_e1787.unnamed_1.root, _e1764.y));
                                                                } else {
                                                                    let _e1803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1764.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1803.unnamed.root, _e1764.y), _e1803.unnamed_1);
                                                                    let _e1815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1809.unnamed, lt_bvh_traverse_Tree(_e1764.z, _e1809.unnamed_1.first_primitive));
                                                                    phi_1916_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1815.unnamed, lt_bvh_traverse_Tree(_e1815.unnamed_1.root, _e1764.w));
                                                                }
                                                                let _e1823 = phi_1916_;
                                                                phi_1922_ = 0u;
                                                                phi_1925_ = 0u;
                                                                loop {
                                                                    let _e1833 = phi_1922_;
                                                                    let _e1835 = phi_1925_;
                                                                    local_6 = _e1835;
                                                                    local_7 = _e1835;
                                                                    local_8 = _e1835;
                                                                    let _e1836 = (_e1833 < 8u);
                                                                    if _e1836 {
                                                                        let _e1838 = (_e1833 >> bitcast<u32>(2i));
                                                                        let _e1839 = (_e1833 & 3u);
                                                                        if (_e1838 == 0u) {
                                                                            phi_1939_ = _e1685.unnamed.root;
                                                                        } else {
                                                                            phi_1939_ = _e1685.unnamed.first_primitive;
                                                                        }
                                                                        let _e1842 = phi_1939_;
                                                                        if (_e1838 == 0u) {
                                                                            phi_1949_ = _e1754.unnamed.root;
                                                                        } else {
                                                                            phi_1949_ = _e1754.unnamed.first_primitive;
                                                                        }
                                                                        let _e1851 = phi_1949_;
                                                                        if (_e1838 == 0u) {
                                                                            phi_1959_ = _e1823.unnamed.root;
                                                                        } else {
                                                                            phi_1959_ = _e1823.unnamed.first_primitive;
                                                                        }
                                                                        let _e1860 = phi_1959_;
                                                                        let _e1873 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1842 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u)) * _e1598) + (_e1616 - _e1378)), ((f32(((_e1851 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u)) * _e1599) + (_e1617 - _e1379)));
                                                                        let _e1874 = core_intrinsics_maximum_number_nsz_f32_(_e1873, ((f32(((_e1860 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u)) * _e1600) + (_e1618 - _e1380)));
                                                                        if (_e1838 == 0u) {
                                                                            phi_1977_ = _e1685.unnamed_1.root;
                                                                        } else {
                                                                            phi_1977_ = _e1685.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1877 = phi_1977_;
                                                                        if (_e1838 == 0u) {
                                                                            phi_1987_ = _e1754.unnamed_1.root;
                                                                        } else {
                                                                            phi_1987_ = _e1754.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1886 = phi_1987_;
                                                                        if (_e1838 == 0u) {
                                                                            phi_1997_ = _e1823.unnamed_1.root;
                                                                        } else {
                                                                            phi_1997_ = _e1823.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1895 = phi_1997_;
                                                                        let _e1908 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1877 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u)) * _e1598) + (_e1616 + _e1378)), ((f32(((_e1886 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u)) * _e1599) + (_e1617 + _e1379)));
                                                                        let _e1909 = core_intrinsics_minimum_number_nsz_f32_(_e1908, ((f32(((_e1895 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u)) * _e1600) + (_e1618 + _e1380)));
                                                                        if (_e1874 <= _e1909) {
                                                                            if (_e1874 <= _e251) {
                                                                                if (_e1909 >= 0f) {
                                                                                    if (_e1838 == 0u) {
                                                                                        let _e1916 = nodes.member[(0u + _e1566)].links[2u];
                                                                                        phi_2033_ = _e1916;
                                                                                    } else {
                                                                                        let _e1919 = nodes.member[(0u + _e1566)].links[3u];
                                                                                        phi_2033_ = _e1919;
                                                                                    }
                                                                                    let _e1921 = phi_2033_;
                                                                                    let _e1926 = ((_e1921 >> bitcast<u32>(((_e1839 * 8u) & 31u))) & 255u);
                                                                                    let _e1927 = (_e1926 & 31u);
                                                                                    if (_e1927 >= 24u) {
                                                                                        phi_2046_ = (24u + ((_e1927 - 24u) ^ _e1428));
                                                                                    } else {
                                                                                        phi_2046_ = _e1927;
                                                                                    }
                                                                                    let _e1933 = phi_2046_;
                                                                                    phi_2051_ = (_e1835 | ((_e1926 >> bitcast<u32>(5i)) << bitcast<u32>((_e1933 & 31u))));
                                                                                } else {
                                                                                    phi_2051_ = _e1835;
                                                                                }
                                                                                let _e1941 = phi_2051_;
                                                                                phi_2052_ = _e1941;
                                                                            } else {
                                                                                phi_2052_ = _e1835;
                                                                            }
                                                                            let _e1943 = phi_2052_;
                                                                            phi_2053_ = _e1943;
                                                                        } else {
                                                                            phi_2053_ = _e1835;
                                                                        }
                                                                        let _e1945 = phi_2053_;
                                                                        phi_1923_ = (_e1833 + 1u);
                                                                        phi_1926_ = _e1945;
                                                                    } else {
                                                                        phi_1923_ = u32();
                                                                        phi_1926_ = u32();
                                                                    }
                                                                    let _e1948 = phi_1923_;
                                                                    let _e1950 = phi_1926_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1922_ = _e1948;
                                                                        phi_1925_ = _e1950;
                                                                        break if !(_e1836);
                                                                    }
                                                                }
                                                                let _e1954 = nodes.member[(0u + _e1566)].links[0u];
                                                                let _e1958 = nodes.member[(0u + _e1566)].frame[3u];
                                                                let _e1962 = local_6;
                                                                if ((_e1962 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1966 = local.group_mask;
                                                                    if ((_e1966 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1970 = local.len;
                                                                        if (_e1970 < 32u) {
                                                                            let _e1973 = local.group;
                                                                            let _e1975 = local.len;
                                                                            if (_e1975 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.first[(0u + _e1975)] = _e1973;
                                                                            let _e1981 = local.group_mask;
                                                                            let _e1983 = local.len;
                                                                            if (_e1983 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.mask[(0u + _e1983)] = _e1981;
                                                                            let _e1990 = local.len;
                                                                            local.len = (_e1990 + 1u);
                                                                        }
                                                                    }
                                                                    local.group = (_e1190 + _e1954);
                                                                    let _e1994 = local_7;
                                                                    local.group_mask = ((_e1994 & 4278190080u) | (_e1958 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1999 = local_8;
                                                                phi_2111_ = (_e1999 & 16777215u);
                                                                loop {
                                                                    let _e2002 = phi_2111_;
                                                                    let _e2003 = (_e2002 == 0u);
                                                                    local_9 = _e2003;
                                                                    local_15 = _e2003;
                                                                    if _e2003 {
                                                                        phi_2112_ = u32();
                                                                        phi_2722_ = false;
                                                                        phi_2723_ = false;
                                                                        phi_2724_ = false;
                                                                    } else {
                                                                        let _e2006 = nodes.member[(0u + _e1566)].links[1u];
                                                                        let _e2011 = ((_e1192 + _e2006) + select(firstTrailingBit(_e2002), 32u, (_e2002 == 0u)));
                                                                        if (_e2011 < arrayLength((&triangles.member))) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2018 = triangles.member[(0u + _e2011)].v0_;
                                                                        let _e2020 = (_e2018.x - _e1121);
                                                                        let _e2022 = (_e2018.y - _e1134);
                                                                        let _e2024 = (_e2018.z - _e1147);
                                                                        if (_e1401 == 0u) {
                                                                            phi_2157_ = vec3<f32>(_e2022, _e2024, _e2020);
                                                                        } else {
                                                                            if (_e1401 == 1u) {
                                                                                phi_2156_ = vec3<f32>(_e2024, _e2020, _e2022);
                                                                            } else {
                                                                                phi_2156_ = (_e2018 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                            }
                                                                            let _e2032 = phi_2156_;
                                                                            phi_2157_ = _e2032;
                                                                        }
                                                                        let _e2034 = phi_2157_;
                                                                        let _e2038 = (_e2034.x - (_e1412 * _e2034.z));
                                                                        let _e2042 = (_e2034.y - (_e1415 * _e2034.z));
                                                                        let _e2044 = triangles.member[(0u + _e2011)].v1_;
                                                                        let _e2046 = (_e2044.x - _e1121);
                                                                        let _e2048 = (_e2044.y - _e1134);
                                                                        let _e2050 = (_e2044.z - _e1147);
                                                                        if (_e1401 == 0u) {
                                                                            phi_2187_ = vec3<f32>(_e2048, _e2050, _e2046);
                                                                        } else {
                                                                            if (_e1401 == 1u) {
                                                                                phi_2186_ = vec3<f32>(_e2050, _e2046, _e2048);
                                                                            } else {
                                                                                phi_2186_ = (_e2044 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                            }
                                                                            let _e2058 = phi_2186_;
                                                                            phi_2187_ = _e2058;
                                                                        }
                                                                        let _e2060 = phi_2187_;
                                                                        let _e2064 = (_e2060.x - (_e1412 * _e2060.z));
                                                                        let _e2068 = (_e2060.y - (_e1415 * _e2060.z));
                                                                        let _e2070 = triangles.member[(0u + _e2011)].v2_;
                                                                        let _e2072 = (_e2070.x - _e1121);
                                                                        let _e2074 = (_e2070.y - _e1134);
                                                                        let _e2076 = (_e2070.z - _e1147);
                                                                        if (_e1401 == 0u) {
                                                                            phi_2217_ = vec3<f32>(_e2074, _e2076, _e2072);
                                                                        } else {
                                                                            if (_e1401 == 1u) {
                                                                                phi_2216_ = vec3<f32>(_e2076, _e2072, _e2074);
                                                                            } else {
                                                                                phi_2216_ = (_e2070 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                            }
                                                                            let _e2084 = phi_2216_;
                                                                            phi_2217_ = _e2084;
                                                                        }
                                                                        let _e2086 = phi_2217_;
                                                                        let _e2090 = (_e2086.x - (_e1412 * _e2086.z));
                                                                        let _e2094 = (_e2086.y - (_e1415 * _e2086.z));
                                                                        if (_e2064 < _e2090) {
                                                                            phi_2236_ = true;
                                                                        } else {
                                                                            if (_e2064 == _e2090) {
                                                                                phi_2235_ = (_e2068 < _e2094);
                                                                            } else {
                                                                                phi_2235_ = false;
                                                                            }
                                                                            let _e2099 = phi_2235_;
                                                                            phi_2236_ = _e2099;
                                                                        }
                                                                        let _e2101 = phi_2236_;
                                                                        if _e2101 {
                                                                            phi_2240_ = _e2094;
                                                                            phi_2241_ = _e2090;
                                                                            phi_2242_ = _e2068;
                                                                            phi_2243_ = _e2064;
                                                                        } else {
                                                                            phi_2240_ = _e2068;
                                                                            phi_2241_ = _e2064;
                                                                            phi_2242_ = _e2094;
                                                                            phi_2243_ = _e2090;
                                                                        }
                                                                        let _e2103 = phi_2240_;
                                                                        let _e2105 = phi_2241_;
                                                                        let _e2107 = phi_2242_;
                                                                        let _e2109 = phi_2243_;
                                                                        let _e2112 = ((_e2109 * _e2103) - (_e2107 * _e2105));
                                                                        if _e2101 {
                                                                            phi_2251_ = -(_e2112);
                                                                        } else {
                                                                            phi_2251_ = _e2112;
                                                                        }
                                                                        let _e2115 = phi_2251_;
                                                                        if (_e2090 < _e2038) {
                                                                            phi_2262_ = true;
                                                                        } else {
                                                                            if (_e2090 == _e2038) {
                                                                                phi_2261_ = (_e2094 < _e2042);
                                                                            } else {
                                                                                phi_2261_ = false;
                                                                            }
                                                                            let _e2120 = phi_2261_;
                                                                            phi_2262_ = _e2120;
                                                                        }
                                                                        let _e2122 = phi_2262_;
                                                                        if _e2122 {
                                                                            phi_2266_ = _e2042;
                                                                            phi_2267_ = _e2038;
                                                                            phi_2268_ = _e2094;
                                                                            phi_2269_ = _e2090;
                                                                        } else {
                                                                            phi_2266_ = _e2094;
                                                                            phi_2267_ = _e2090;
                                                                            phi_2268_ = _e2042;
                                                                            phi_2269_ = _e2038;
                                                                        }
                                                                        let _e2124 = phi_2266_;
                                                                        let _e2126 = phi_2267_;
                                                                        let _e2128 = phi_2268_;
                                                                        let _e2130 = phi_2269_;
                                                                        let _e2133 = ((_e2130 * _e2124) - (_e2128 * _e2126));
                                                                        if _e2122 {
                                                                            phi_2277_ = -(_e2133);
                                                                        } else {
                                                                            phi_2277_ = _e2133;
                                                                        }
                                                                        let _e2136 = phi_2277_;
                                                                        if (_e2038 < _e2064) {
                                                                            phi_2288_ = true;
                                                                        } else {
                                                                            if (_e2038 == _e2064) {
                                                                                phi_2287_ = (_e2042 < _e2068);
                                                                            } else {
                                                                                phi_2287_ = false;
                                                                            }
                                                                            let _e2141 = phi_2287_;
                                                                            phi_2288_ = _e2141;
                                                                        }
                                                                        let _e2143 = phi_2288_;
                                                                        if _e2143 {
                                                                            phi_2292_ = _e2068;
                                                                            phi_2293_ = _e2064;
                                                                            phi_2294_ = _e2042;
                                                                            phi_2295_ = _e2038;
                                                                        } else {
                                                                            phi_2292_ = _e2042;
                                                                            phi_2293_ = _e2038;
                                                                            phi_2294_ = _e2068;
                                                                            phi_2295_ = _e2064;
                                                                        }
                                                                        let _e2145 = phi_2292_;
                                                                        let _e2147 = phi_2293_;
                                                                        let _e2149 = phi_2294_;
                                                                        let _e2151 = phi_2295_;
                                                                        let _e2154 = ((_e2151 * _e2145) - (_e2149 * _e2147));
                                                                        if _e2143 {
                                                                            phi_2303_ = -(_e2154);
                                                                        } else {
                                                                            phi_2303_ = _e2154;
                                                                        }
                                                                        let _e2157 = phi_2303_;
                                                                        if (_e2115 >= 0f) {
                                                                            if (_e2136 >= 0f) {
                                                                                if (_e2157 >= 0f) {
                                                                                    phi_2318_ = ((_e2115 + _e2136) + _e2157);
                                                                                    phi_2319_ = false;
                                                                                } else {
                                                                                    phi_2318_ = f32();
                                                                                    phi_2319_ = true;
                                                                                }
                                                                                let _e2164 = phi_2318_;
                                                                                let _e2166 = phi_2319_;
                                                                                phi_2320_ = _e2164;
                                                                                phi_2321_ = _e2166;
                                                                            } else {
                                                                                phi_2320_ = f32();
                                                                                phi_2321_ = true;
                                                                            }
                                                                            let _e2168 = phi_2320_;
                                                                            let _e2170 = phi_2321_;
                                                                            phi_2322_ = _e2168;
                                                                            phi_2323_ = _e2170;
                                                                        } else {
                                                                            phi_2322_ = f32();
                                                                            phi_2323_ = true;
                                                                        }
                                                                        let _e2172 = phi_2322_;
                                                                        let _e2174 = phi_2323_;
                                                                        if _e2174 {
                                                                            if (_e2115 <= 0f) {
                                                                                if (_e2136 <= 0f) {
                                                                                    let _e2177 = (_e2157 <= 0f);
                                                                                    if _e2177 {
                                                                                    }
                                                                                    phi_2341_ = ((_e2115 + _e2136) + _e2157);
                                                                                    phi_2342_ = false;
                                                                                    phi_2343_ = _e2177;
                                                                                } else {
                                                                                    phi_2341_ = f32();
                                                                                    phi_2342_ = true;
                                                                                    phi_2343_ = false;
                                                                                }
                                                                                let _e2181 = phi_2341_;
                                                                                let _e2183 = phi_2342_;
                                                                                let _e2185 = phi_2343_;
                                                                                phi_2344_ = _e2181;
                                                                                phi_2345_ = _e2183;
                                                                                phi_2346_ = _e2185;
                                                                            } else {
                                                                                phi_2344_ = f32();
                                                                                phi_2345_ = true;
                                                                                phi_2346_ = false;
                                                                            }
                                                                            let _e2187 = phi_2344_;
                                                                            let _e2189 = phi_2345_;
                                                                            let _e2191 = phi_2346_;
                                                                            if _e2189 {
                                                                                phi_2350_ = false;
                                                                            } else {
                                                                                phi_2350_ = _e2191;
                                                                            }
                                                                            let _e2193 = phi_2350_;
                                                                            phi_2351_ = _e2187;
                                                                            phi_2352_ = _e2193;
                                                                        } else {
                                                                            phi_2351_ = _e2172;
                                                                            phi_2352_ = true;
                                                                        }
                                                                        let _e2195 = phi_2351_;
                                                                        let _e2197 = phi_2352_;
                                                                        if _e2197 {
                                                                            let _e2198 = (_e2195 == 0f);
                                                                            if _e2198 {
                                                                                phi_2668_ = lt_bvh_triangle_Intersection();
                                                                                phi_2669_ = false;
                                                                            } else {
                                                                                let _e2200 = triangles.member[(0u + _e2011)].v0_;
                                                                                let _e2202 = (_e2200.x - _e1121);
                                                                                let _e2204 = (_e2200.y - _e1134);
                                                                                let _e2206 = (_e2200.z - _e1147);
                                                                                if (_e1401 == 0u) {
                                                                                    phi_2381_ = vec3<f32>(_e2204, _e2206, _e2202);
                                                                                } else {
                                                                                    if (_e1401 == 1u) {
                                                                                        phi_2380_ = vec3<f32>(_e2206, _e2202, _e2204);
                                                                                    } else {
                                                                                        phi_2380_ = (_e2200 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                                    }
                                                                                    let _e2214 = phi_2380_;
                                                                                    phi_2381_ = _e2214;
                                                                                }
                                                                                let _e2216 = phi_2381_;
                                                                                let _e2218 = triangles.member[(0u + _e2011)].v1_;
                                                                                let _e2220 = triangles.member[(0u + _e2011)].v0_;
                                                                                let _e2223 = (_e2218.x - _e2220.x);
                                                                                let _e2226 = (_e2218.y - _e2220.y);
                                                                                let _e2229 = (_e2218.z - _e2220.z);
                                                                                if (_e1401 == 0u) {
                                                                                    phi_2407_ = vec3<f32>(_e2226, _e2229, _e2223);
                                                                                } else {
                                                                                    if (_e1401 == 1u) {
                                                                                        phi_2406_ = vec3<f32>(_e2229, _e2223, _e2226);
                                                                                    } else {
                                                                                        phi_2406_ = (_e2218 - _e2220);
                                                                                    }
                                                                                    let _e2236 = phi_2406_;
                                                                                    phi_2407_ = _e2236;
                                                                                }
                                                                                let _e2238 = phi_2407_;
                                                                                let _e2240 = triangles.member[(0u + _e2011)].v2_;
                                                                                let _e2242 = triangles.member[(0u + _e2011)].v0_;
                                                                                let _e2245 = (_e2240.x - _e2242.x);
                                                                                let _e2248 = (_e2240.y - _e2242.y);
                                                                                let _e2251 = (_e2240.z - _e2242.z);
                                                                                if (_e1401 == 0u) {
                                                                                    phi_2433_ = vec3<f32>(_e2248, _e2251, _e2245);
                                                                                } else {
                                                                                    if (_e1401 == 1u) {
                                                                                        phi_2432_ = vec3<f32>(_e2251, _e2245, _e2248);
                                                                                    } else {
                                                                                        phi_2432_ = (_e2240 - _e2242);
                                                                                    }
                                                                                    let _e2258 = phi_2432_;
                                                                                    phi_2433_ = _e2258;
                                                                                }
                                                                                let _e2260 = phi_2433_;
                                                                                let _e2267 = ((_e2238.y * _e2260.z) - (_e2238.z * _e2260.y));
                                                                                let _e2274 = ((_e2238.z * _e2260.x) - (_e2238.x * _e2260.z));
                                                                                let _e2281 = ((_e2238.x * _e2260.y) - (_e2238.y * _e2260.x));
                                                                                let _e2295 = (((1f / _e1409.z) * (((_e2267 * _e2216.x) + (_e2274 * _e2216.y)) + (_e2281 * _e2216.z))) / (((_e2267 * _e1412) + (_e2274 * _e1415)) + _e2281));
                                                                                if (_e2295 > 0f) {
                                                                                    if (_e2295 < _e251) {
                                                                                        let _e2299 = triangles.member[(0u + _e2011)].v0_;
                                                                                        let _e2301 = triangles.member[(0u + _e2011)].v1_;
                                                                                        if (_e2299.x < _e2301.x) {
                                                                                            phi_2489_ = _e2299.x;
                                                                                        } else {
                                                                                            phi_2489_ = _e2301.x;
                                                                                        }
                                                                                        let _e2308 = phi_2489_;
                                                                                        if (_e2299.y < _e2301.y) {
                                                                                            phi_2498_ = _e2299.y;
                                                                                        } else {
                                                                                            phi_2498_ = _e2301.y;
                                                                                        }
                                                                                        let _e2315 = phi_2498_;
                                                                                        if (_e2299.z < _e2301.z) {
                                                                                            phi_2507_ = _e2299.z;
                                                                                        } else {
                                                                                            phi_2507_ = _e2301.z;
                                                                                        }
                                                                                        let _e2322 = phi_2507_;
                                                                                        let _e2324 = triangles.member[(0u + _e2011)].v2_;
                                                                                        if (_e2308 < _e2324.x) {
                                                                                            phi_2516_ = _e2308;
                                                                                        } else {
                                                                                            phi_2516_ = _e2324.x;
                                                                                        }
                                                                                        let _e2329 = phi_2516_;
                                                                                        if (_e2315 < _e2324.y) {
                                                                                            phi_2523_ = _e2315;
                                                                                        } else {
                                                                                            phi_2523_ = _e2324.y;
                                                                                        }
                                                                                        let _e2334 = phi_2523_;
                                                                                        if (_e2322 < _e2324.z) {
                                                                                            phi_2530_ = _e2322;
                                                                                        } else {
                                                                                            phi_2530_ = _e2324.z;
                                                                                        }
                                                                                        let _e2339 = phi_2530_;
                                                                                        let _e2341 = triangles.member[(0u + _e2011)].v0_;
                                                                                        let _e2343 = triangles.member[(0u + _e2011)].v1_;
                                                                                        if (_e2341.x > _e2343.x) {
                                                                                            phi_2543_ = _e2341.x;
                                                                                        } else {
                                                                                            phi_2543_ = _e2343.x;
                                                                                        }
                                                                                        let _e2350 = phi_2543_;
                                                                                        if (_e2341.y > _e2343.y) {
                                                                                            phi_2552_ = _e2341.y;
                                                                                        } else {
                                                                                            phi_2552_ = _e2343.y;
                                                                                        }
                                                                                        let _e2357 = phi_2552_;
                                                                                        if (_e2341.z > _e2343.z) {
                                                                                            phi_2561_ = _e2341.z;
                                                                                        } else {
                                                                                            phi_2561_ = _e2343.z;
                                                                                        }
                                                                                        let _e2364 = phi_2561_;
                                                                                        let _e2366 = triangles.member[(0u + _e2011)].v2_;
                                                                                        if (_e2350 > _e2366.x) {
                                                                                            phi_2570_ = _e2350;
                                                                                        } else {
                                                                                            phi_2570_ = _e2366.x;
                                                                                        }
                                                                                        let _e2371 = phi_2570_;
                                                                                        if (_e2357 > _e2366.y) {
                                                                                            phi_2577_ = _e2357;
                                                                                        } else {
                                                                                            phi_2577_ = _e2366.y;
                                                                                        }
                                                                                        let _e2376 = phi_2577_;
                                                                                        if (_e2364 > _e2366.z) {
                                                                                            phi_2584_ = _e2364;
                                                                                        } else {
                                                                                            phi_2584_ = _e2366.z;
                                                                                        }
                                                                                        let _e2381 = phi_2584_;
                                                                                        let _e2385 = ((_e2329 - _e1121) * _e1330);
                                                                                        let _e2386 = ((_e2334 - _e1134) * _e1340);
                                                                                        let _e2387 = ((_e2339 - _e1147) * _e1350);
                                                                                        let _e2391 = ((_e2371 - _e1121) * _e1330);
                                                                                        let _e2392 = ((_e2376 - _e1134) * _e1340);
                                                                                        let _e2393 = ((_e2381 - _e1147) * _e1350);
                                                                                        if (_e2385 < _e2391) {
                                                                                            phi_2601_ = _e2385;
                                                                                        } else {
                                                                                            phi_2601_ = _e2391;
                                                                                        }
                                                                                        let _e2396 = phi_2601_;
                                                                                        if (_e2386 < _e2392) {
                                                                                            phi_2606_ = _e2386;
                                                                                        } else {
                                                                                            phi_2606_ = _e2392;
                                                                                        }
                                                                                        let _e2399 = phi_2606_;
                                                                                        if (_e2387 < _e2393) {
                                                                                            phi_2611_ = _e2387;
                                                                                        } else {
                                                                                            phi_2611_ = _e2393;
                                                                                        }
                                                                                        let _e2402 = phi_2611_;
                                                                                        if (_e2385 > _e2391) {
                                                                                            phi_2619_ = _e2385;
                                                                                        } else {
                                                                                            phi_2619_ = _e2391;
                                                                                        }
                                                                                        let _e2408 = phi_2619_;
                                                                                        if (_e2386 > _e2392) {
                                                                                            phi_2624_ = _e2386;
                                                                                        } else {
                                                                                            phi_2624_ = _e2392;
                                                                                        }
                                                                                        let _e2411 = phi_2624_;
                                                                                        if (_e2387 > _e2393) {
                                                                                            phi_2629_ = _e2387;
                                                                                        } else {
                                                                                            phi_2629_ = _e2393;
                                                                                        }
                                                                                        let _e2414 = phi_2629_;
                                                                                        let _e2418 = core_intrinsics_maximum_number_nsz_f32_((_e2396 - _e1385), (_e2399 - _e1386));
                                                                                        let _e2419 = core_intrinsics_maximum_number_nsz_f32_(_e2418, (_e2402 - _e1387));
                                                                                        let _e2420 = core_intrinsics_minimum_number_nsz_f32_((_e2408 + _e1385), (_e2411 + _e1386));
                                                                                        let _e2421 = core_intrinsics_minimum_number_nsz_f32_(_e2420, (_e2414 + _e1387));
                                                                                        if (_e2419 > _e1102) {
                                                                                            phi_2641_ = _e2419;
                                                                                        } else {
                                                                                            phi_2641_ = _e1102;
                                                                                        }
                                                                                        let _e2424 = phi_2641_;
                                                                                        if (_e2421 < _e1104) {
                                                                                            phi_2646_ = _e2421;
                                                                                        } else {
                                                                                            phi_2646_ = _e1104;
                                                                                        }
                                                                                        let _e2427 = phi_2646_;
                                                                                        if (_e2295 < _e2424) {
                                                                                            phi_2651_ = _e2424;
                                                                                        } else {
                                                                                            phi_2651_ = _e2295;
                                                                                        }
                                                                                        let _e2430 = phi_2651_;
                                                                                        if (_e2430 > _e2427) {
                                                                                            phi_2656_ = _e2427;
                                                                                        } else {
                                                                                            phi_2656_ = _e2430;
                                                                                        }
                                                                                        let _e2433 = phi_2656_;
                                                                                        phi_2661_ = lt_bvh_triangle_Intersection(_e2433, (_e2136 / _e2195), (_e2157 / _e2195), (_e2424 <= _e2427));
                                                                                        phi_2662_ = false;
                                                                                    } else {
                                                                                        phi_2661_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2662_ = true;
                                                                                    }
                                                                                    let _e2439 = phi_2661_;
                                                                                    let _e2441 = phi_2662_;
                                                                                    phi_2663_ = _e2439;
                                                                                    phi_2664_ = _e2441;
                                                                                } else {
                                                                                    phi_2663_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2664_ = true;
                                                                                }
                                                                                let _e2443 = phi_2663_;
                                                                                let _e2445 = phi_2664_;
                                                                                if _e2445 {
                                                                                }
                                                                                phi_2668_ = _e2443;
                                                                                phi_2669_ = _e2445;
                                                                            }
                                                                            let _e2447 = phi_2668_;
                                                                            let _e2449 = phi_2669_;
                                                                            phi_2670_ = _e2447;
                                                                            phi_2671_ = _e2198;
                                                                            phi_2672_ = _e2449;
                                                                        } else {
                                                                            phi_2670_ = lt_bvh_triangle_Intersection();
                                                                            phi_2671_ = true;
                                                                            phi_2672_ = false;
                                                                        }
                                                                        let _e2451 = phi_2670_;
                                                                        let _e2453 = phi_2671_;
                                                                        let _e2455 = phi_2672_;
                                                                        if _e2453 {
                                                                            phi_2676_ = true;
                                                                        } else {
                                                                            phi_2676_ = _e2455;
                                                                        }
                                                                        let _e2457 = phi_2676_;
                                                                        if _e2457 {
                                                                            phi_2680_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2680_ = _e2451;
                                                                        }
                                                                        let _e2459 = phi_2680_;
                                                                        if _e2459.is_hit {
                                                                            if (_e2459.t > 0f) {
                                                                                if (_e2459.t < _e251) {
                                                                                    let _e2466 = triangles.member[(0u + _e2011)].i0_;
                                                                                    let _e2468 = ((_e2466 & 2147483648u) == 0u);
                                                                                    if _e2468 {
                                                                                        phi_2706_ = false;
                                                                                        phi_2707_ = false;
                                                                                    } else {
                                                                                        if true {
                                                                                            phi_2705_ = false;
                                                                                        } else {
                                                                                            phi_2705_ = true;
                                                                                        }
                                                                                        let _e2470 = phi_2705_;
                                                                                        phi_2706_ = _e2470;
                                                                                        phi_2707_ = true;
                                                                                    }
                                                                                    let _e2472 = phi_2706_;
                                                                                    let _e2474 = phi_2707_;
                                                                                    phi_2708_ = _e2472;
                                                                                    phi_2709_ = _e2468;
                                                                                    phi_2710_ = _e2474;
                                                                                } else {
                                                                                    phi_2708_ = true;
                                                                                    phi_2709_ = false;
                                                                                    phi_2710_ = false;
                                                                                }
                                                                                let _e2476 = phi_2708_;
                                                                                let _e2478 = phi_2709_;
                                                                                let _e2480 = phi_2710_;
                                                                                phi_2711_ = _e2476;
                                                                                phi_2712_ = _e2478;
                                                                                phi_2713_ = _e2480;
                                                                            } else {
                                                                                phi_2711_ = true;
                                                                                phi_2712_ = false;
                                                                                phi_2713_ = false;
                                                                            }
                                                                            let _e2482 = phi_2711_;
                                                                            let _e2484 = phi_2712_;
                                                                            let _e2486 = phi_2713_;
                                                                            phi_2714_ = _e2482;
                                                                            phi_2715_ = _e2484;
                                                                            phi_2716_ = _e2486;
                                                                        } else {
                                                                            phi_2714_ = true;
                                                                            phi_2715_ = false;
                                                                            phi_2716_ = false;
                                                                        }
                                                                        let _e2488 = phi_2714_;
                                                                        let _e2490 = phi_2715_;
                                                                        let _e2492 = phi_2716_;
                                                                        if _e2488 {
                                                                            phi_2720_ = false;
                                                                            phi_2721_ = false;
                                                                        } else {
                                                                            phi_2720_ = _e2490;
                                                                            phi_2721_ = _e2492;
                                                                        }
                                                                        let _e2494 = phi_2720_;
                                                                        let _e2496 = phi_2721_;
                                                                        phi_2112_ = (_e2002 & (_e2002 - 1u));
                                                                        phi_2722_ = _e2488;
                                                                        phi_2723_ = _e2494;
                                                                        phi_2724_ = _e2496;
                                                                    }
                                                                    let _e2498 = phi_2112_;
                                                                    let _e2500 = phi_2722_;
                                                                    let _e2502 = phi_2723_;
                                                                    let _e2504 = phi_2724_;
                                                                    local_13 = _e2502;
                                                                    local_14 = _e2504;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2111_ = _e2498;
                                                                        break if !(_e2500);
                                                                    }
                                                                }
                                                                let _e2507 = local_9;
                                                                if _e2507 {
                                                                    let _e2509 = local.group_mask;
                                                                    if ((_e2509 & 4278190080u) == 0u) {
                                                                        let _e2513 = local.len;
                                                                        if (_e2513 == 0u) {
                                                                            phi_2766_ = false;
                                                                        } else {
                                                                            let _e2517 = local.len;
                                                                            local.len = (_e2517 - 1u);
                                                                            let _e2520 = local.len;
                                                                            if (_e2520 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2525 = local.first[(0u + _e2520)];
                                                                            local.group = _e2525;
                                                                            let _e2528 = local.len;
                                                                            if (_e2528 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2533 = local.mask[(0u + _e2528)];
                                                                            local.group_mask = _e2533;
                                                                            phi_2766_ = true;
                                                                        }
                                                                        let _e2536 = phi_2766_;
                                                                        phi_2767_ = _e2536;
                                                                    } else {
                                                                        phi_2767_ = true;
                                                                    }
                                                                    let _e2538 = phi_2767_;
                                                                    if _e2538 {
                                                                        let _e2540 = local.group_mask;
                                                                        let _e2546 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2540)), 32u, (_e2540 == 0u)));
                                                                        let _e2550 = local.group_mask;
                                                                        let _e2564 = local.group_mask;
                                                                        local.group_mask = (_e2564 & ~((1u << bitcast<u32>((_e2546 & 31u)))));
                                                                        let _e2567 = local.group;
                                                                        phi_2798_ = (_e2567 + countOneBits(((_e2550 & ~((4294967295u << bitcast<u32>((((_e2546 - 24u) ^ _e1428) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2798_ = 4294967295u;
                                                                    }
                                                                    let _e2570 = phi_2798_;
                                                                    phi_2799_ = _e2570;
                                                                    phi_2800_ = false;
                                                                    phi_2801_ = false;
                                                                } else {
                                                                    phi_2799_ = u32();
                                                                    let _e2963 = local_13;
                                                                    phi_2800_ = _e2963;
                                                                    let _e2966 = local_14;
                                                                    phi_2801_ = _e2966;
                                                                }
                                                                let _e2572 = phi_2799_;
                                                                let _e2574 = phi_2800_;
                                                                let _e2576 = phi_2801_;
                                                                phi_1782_ = _e2572;
                                                                let _e2970 = local_15;
                                                                phi_2802_ = _e2970;
                                                                phi_2803_ = false;
                                                                phi_2804_ = _e2574;
                                                                phi_2805_ = _e2576;
                                                            } else {
                                                                phi_1782_ = u32();
                                                                phi_2802_ = false;
                                                                phi_2803_ = true;
                                                                phi_2804_ = false;
                                                                phi_2805_ = false;
                                                            }
                                                            let _e2578 = phi_1782_;
                                                            let _e2580 = phi_2802_;
                                                            let _e2582 = phi_2803_;
                                                            let _e2584 = phi_2804_;
                                                            let _e2586 = phi_2805_;
                                                            local_10 = _e2582;
                                                            local_16 = _e2584;
                                                            local_17 = _e2586;
                                                            continue;
                                                            continuing {
                                                                phi_1781_ = _e2578;
                                                                break if !(_e2580);
                                                            }
                                                        }
                                                        let _e2589 = local_10;
                                                        if _e2589 {
                                                            phi_2809_ = false;
                                                            phi_2810_ = false;
                                                        } else {
                                                            let _e2977 = local_16;
                                                            phi_2809_ = _e2977;
                                                            let _e2980 = local_17;
                                                            phi_2810_ = _e2980;
                                                        }
                                                        let _e2591 = phi_2809_;
                                                        let _e2593 = phi_2810_;
                                                        if _e2591 {
                                                            phi_2814_ = true;
                                                        } else {
                                                            phi_2814_ = _e2593;
                                                        }
                                                        let _e2595 = phi_2814_;
                                                        if _e2595 {
                                                            phi_2818_ = true;
                                                        } else {
                                                            phi_2818_ = false;
                                                        }
                                                        let _e2597 = phi_2818_;
                                                        phi_2819_ = _e2597;
                                                    }
                                                    let _e2599 = phi_2819_;
                                                    phi_2820_ = _e2599;
                                                    phi_2821_ = _e1254;
                                                } else {
                                                    phi_2820_ = bool();
                                                    phi_2821_ = true;
                                                }
                                                let _e2601 = phi_2820_;
                                                let _e2603 = phi_2821_;
                                                if _e2603 {
                                                    phi_2825_ = false;
                                                } else {
                                                    phi_2825_ = _e2601;
                                                }
                                                let _e2605 = phi_2825_;
                                                if _e2605 {
                                                    phi_2829_ = false;
                                                } else {
                                                    phi_2829_ = true;
                                                }
                                                let _e2607 = phi_2829_;
                                                phi_2830_ = _e2607;
                                            } else {
                                                phi_2830_ = true;
                                            }
                                            let _e2609 = phi_2830_;
                                            phi_2831_ = _e2609;
                                        } else {
                                            phi_2831_ = true;
                                        }
                                        let _e2611 = phi_2831_;
                                        phi_2832_ = _e2611;
                                    } else {
                                        phi_2832_ = true;
                                    }
                                    let _e2613 = phi_2832_;
                                    if _e2613 {
                                    }
                                    phi_1176_ = (_e1041 & (_e1041 - 1u));
                                    phi_2836_ = _e2613;
                                }
                                let _e2615 = phi_1176_;
                                let _e2617 = phi_2836_;
                                continue;
                                continuing {
                                    phi_1175_ = _e2615;
                                    break if !(_e2617);
                                }
                            }
                            let _e2620 = local_11;
                            if _e2620 {
                                let _e2622 = local_1.group_mask;
                                if ((_e2622 & 4278190080u) == 0u) {
                                    let _e2626 = local_1.len;
                                    if (_e2626 == 0u) {
                                        phi_2878_ = false;
                                    } else {
                                        let _e2630 = local_1.len;
                                        local_1.len = (_e2630 - 1u);
                                        let _e2633 = local_1.len;
                                        if (_e2633 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2638 = local_1.first[(0u + _e2633)];
                                        local_1.group = _e2638;
                                        let _e2641 = local_1.len;
                                        if (_e2641 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2646 = local_1.mask[(0u + _e2641)];
                                        local_1.group_mask = _e2646;
                                        phi_2878_ = true;
                                    }
                                    let _e2649 = phi_2878_;
                                    phi_2879_ = _e2649;
                                } else {
                                    phi_2879_ = true;
                                }
                                let _e2651 = phi_2879_;
                                if _e2651 {
                                    let _e2653 = local_1.group_mask;
                                    let _e2659 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2653)), 32u, (_e2653 == 0u)));
                                    let _e2663 = local_1.group_mask;
                                    let _e2677 = local_1.group_mask;
                                    local_1.group_mask = (_e2677 & ~((1u << bitcast<u32>((_e2659 & 31u)))));
                                    let _e2680 = local_1.group;
                                    phi_2910_ = (_e2680 + countOneBits(((_e2663 & ~((4294967295u << bitcast<u32>((((_e2659 - 24u) ^ _e467) & 31u))))) & 255u)));
                                } else {
                                    phi_2910_ = 4294967295u;
                                }
                                let _e2683 = phi_2910_;
                                phi_2911_ = _e2683;
                            } else {
                                phi_2911_ = u32();
                            }
                            let _e2685 = phi_2911_;
                            phi_846_ = _e2685;
                            let _e3001 = local_18;
                            phi_2912_ = _e3001;
                            phi_2913_ = false;
                        } else {
                            phi_846_ = u32();
                            phi_2912_ = false;
                            phi_2913_ = true;
                        }
                        let _e2687 = phi_846_;
                        let _e2689 = phi_2912_;
                        let _e2691 = phi_2913_;
                        local_12 = _e2691;
                        continue;
                        continuing {
                            phi_845_ = _e2687;
                            break if !(_e2689);
                        }
                    }
                    let _e2694 = local_12;
                    if _e2694 {
                        phi_2917_ = false;
                    } else {
                        phi_2917_ = true;
                    }
                    let _e2696 = phi_2917_;
                    if _e2696 {
                        phi_2921_ = true;
                    } else {
                        phi_2921_ = false;
                    }
                    let _e2698 = phi_2921_;
                    phi_2922_ = _e2698;
                }
                let _e2700 = phi_2922_;
                phi_2923_ = _e2700;
                phi_2924_ = _e323;
            } else {
                phi_2923_ = bool();
                phi_2924_ = true;
            }
            let _e2702 = phi_2923_;
            let _e2704 = phi_2924_;
            if _e2704 {
                phi_2928_ = false;
            } else {
                phi_2928_ = _e2702;
            }
            let _e2706 = phi_2928_;
            if _e2706 {
                phi_2932_ = 0f;
            } else {
                phi_2932_ = 1f;
            }
            let _e2708 = phi_2932_;
            phi_2933_ = _e2708;
        }
        let _e2710 = phi_2933_;
        if (_e79.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.first_primitive)] = _e2710;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
