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

struct type_29 {
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

struct type_36 {
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

struct type_45 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_53 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(2) 
var<storage> nodes: type_45;
@group(0) @binding(3) 
var<storage> triangles: type_29;
@group(0) @binding(5) 
var<storage> instances: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_183_: lt_bvh_traverse_Tree;
    var phi_184_: bool;
    var phi_185_: lt_bvh_traverse_Tree;
    var phi_186_: bool;
    var phi_191_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_183_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_184_ = false;
        } else {
            phi_183_ = lt_bvh_traverse_Tree();
            phi_184_ = true;
        }
        let _e67 = phi_183_;
        let _e69 = phi_184_;
        phi_185_ = _e67;
        phi_186_ = _e69;
    } else {
        phi_185_ = lt_bvh_traverse_Tree();
        phi_186_ = true;
    }
    let _e71 = phi_185_;
    let _e73 = phi_186_;
    if _e73 {
        phi_191_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_191_ = _e71;
    }
    let _e78 = phi_191_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_206_: bool;
    var phi_210_: f32;

    if (param_3 != param_3) {
        phi_206_ = true;
    } else {
        let _e57 = (param_4 >= param_3);
        if _e57 {
        }
        phi_206_ = _e57;
    }
    let _e59 = phi_206_;
    if _e59 {
        phi_210_ = param_4;
    } else {
        phi_210_ = param_3;
    }
    let _e61 = phi_210_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_222_: bool;
    var phi_226_: f32;

    if (param_5 != param_5) {
        phi_222_ = true;
    } else {
        let _e57 = (param_6 <= param_5);
        if _e57 {
        }
        phi_222_ = _e57;
    }
    let _e59 = phi_222_;
    if _e59 {
        phi_226_ = param_6;
    } else {
        phi_226_ = param_5;
    }
    let _e61 = phi_226_;
    return _e61;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_258_: bool;

    let _e57 = (*param_7).normal[0u];
    let _e59 = global[0u];
    if (_e57 == _e59) {
        let _e62 = (*param_7).normal[1u];
        let _e64 = global[1u];
        if (_e62 == _e64) {
            let _e67 = (*param_7).normal[2u];
            let _e69 = global[2u];
            phi_251_ = (_e67 == _e69);
            phi_252_ = false;
        } else {
            phi_251_ = bool();
            phi_252_ = true;
        }
        let _e72 = phi_251_;
        let _e74 = phi_252_;
        phi_253_ = _e72;
        phi_254_ = _e74;
    } else {
        phi_253_ = bool();
        phi_254_ = true;
    }
    let _e76 = phi_253_;
    let _e78 = phi_254_;
    if _e78 {
        phi_258_ = false;
    } else {
        phi_258_ = _e76;
    }
    let _e80 = phi_258_;
    return !(_e80);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_394_: f32;
    var phi_450_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_458_: bool;
    var phi_459_: bool;
    var phi_460_: bool;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_472_: bool;
    var phi_473_: bool;
    var phi_477_: bool;
    var phi_481_: bool;
    var phi_551_: f32;
    var phi_558_: f32;
    var phi_565_: f32;
    var phi_572_: f32;
    var phi_579_: f32;
    var phi_586_: f32;
    var phi_603_: f32;
    var phi_608_: f32;
    var phi_613_: f32;
    var phi_634_: u32;
    var phi_639_: u32;
    var phi_644_: u32;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_790_: u32;
    var phi_792_: u32;
    var phi_873_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_900_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_927_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_933_: u32;
    var phi_936_: u32;
    var phi_950_: u32;
    var phi_960_: u32;
    var phi_970_: u32;
    var phi_988_: u32;
    var phi_998_: u32;
    var phi_1008_: u32;
    var phi_1044_: u32;
    var phi_1057_: u32;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_1064_: u32;
    var phi_934_: u32;
    var phi_937_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1122_: u32;
    var phi_1172_: f32;
    var phi_1177_: f32;
    var phi_1182_: f32;
    var phi_1190_: f32;
    var phi_1195_: f32;
    var phi_1200_: f32;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1371_: bool;
    var phi_1375_: bool;
    var phi_1445_: f32;
    var phi_1452_: f32;
    var phi_1459_: f32;
    var phi_1466_: f32;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1497_: f32;
    var phi_1502_: f32;
    var phi_1507_: f32;
    var phi_1535_: bool;
    var phi_1536_: bool;
    var phi_1544_: u32;
    var phi_1545_: u32;
    var phi_1556_: vec3<f32>;
    var phi_1557_: vec3<f32>;
    var phi_1570_: u32;
    var phi_1575_: u32;
    var phi_1580_: u32;
    var phi_1694_: bool;
    var phi_1695_: bool;
    var phi_1726_: u32;
    var phi_1728_: u32;
    var phi_1809_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1836_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1863_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1869_: u32;
    var phi_1872_: u32;
    var phi_1886_: u32;
    var phi_1896_: u32;
    var phi_1906_: u32;
    var phi_1924_: u32;
    var phi_1934_: u32;
    var phi_1944_: u32;
    var phi_1980_: u32;
    var phi_1993_: u32;
    var phi_1998_: u32;
    var phi_1999_: u32;
    var phi_2000_: u32;
    var phi_1870_: u32;
    var phi_1873_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2058_: u32;
    var phi_2103_: vec3<f32>;
    var phi_2104_: vec3<f32>;
    var phi_2133_: vec3<f32>;
    var phi_2134_: vec3<f32>;
    var phi_2163_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_2182_: bool;
    var phi_2183_: bool;
    var phi_2187_: f32;
    var phi_2188_: f32;
    var phi_2189_: f32;
    var phi_2190_: f32;
    var phi_2198_: f32;
    var phi_2208_: bool;
    var phi_2209_: bool;
    var phi_2213_: f32;
    var phi_2214_: f32;
    var phi_2215_: f32;
    var phi_2216_: f32;
    var phi_2224_: f32;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2239_: f32;
    var phi_2240_: f32;
    var phi_2241_: f32;
    var phi_2242_: f32;
    var phi_2250_: f32;
    var phi_2265_: f32;
    var phi_2266_: bool;
    var phi_2267_: f32;
    var phi_2268_: bool;
    var phi_2269_: f32;
    var phi_2270_: bool;
    var phi_2288_: f32;
    var phi_2289_: bool;
    var phi_2290_: bool;
    var phi_2291_: f32;
    var phi_2292_: bool;
    var phi_2293_: bool;
    var phi_2297_: bool;
    var phi_2298_: f32;
    var phi_2299_: bool;
    var phi_2327_: vec3<f32>;
    var phi_2328_: vec3<f32>;
    var phi_2353_: vec3<f32>;
    var phi_2354_: vec3<f32>;
    var phi_2379_: vec3<f32>;
    var phi_2380_: vec3<f32>;
    var phi_2436_: f32;
    var phi_2445_: f32;
    var phi_2454_: f32;
    var phi_2463_: f32;
    var phi_2470_: f32;
    var phi_2477_: f32;
    var phi_2490_: f32;
    var phi_2499_: f32;
    var phi_2508_: f32;
    var phi_2517_: f32;
    var phi_2524_: f32;
    var phi_2531_: f32;
    var phi_2548_: f32;
    var phi_2553_: f32;
    var phi_2558_: f32;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2576_: f32;
    var phi_2588_: f32;
    var phi_2593_: f32;
    var phi_2598_: f32;
    var phi_2603_: f32;
    var phi_2608_: lt_bvh_triangle_Intersection;
    var phi_2609_: bool;
    var phi_2610_: lt_bvh_triangle_Intersection;
    var phi_2611_: bool;
    var phi_2615_: lt_bvh_triangle_Intersection;
    var phi_2616_: bool;
    var phi_2617_: lt_bvh_triangle_Intersection;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var phi_2623_: bool;
    var phi_2627_: lt_bvh_triangle_Intersection;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2660_: bool;
    var phi_2661_: bool;
    var phi_2662_: bool;
    var phi_2663_: bool;
    var phi_2667_: bool;
    var phi_2668_: bool;
    var phi_2059_: u32;
    var phi_2669_: bool;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var local_9: bool;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2745_: u32;
    var phi_2746_: u32;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_1729_: u32;
    var phi_2749_: bool;
    var phi_2750_: bool;
    var phi_2751_: bool;
    var phi_2752_: bool;
    var local_10: bool;
    var phi_2756_: bool;
    var phi_2757_: bool;
    var phi_2761_: bool;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2768_: bool;
    var phi_2772_: bool;
    var phi_2776_: bool;
    var phi_2777_: bool;
    var phi_2778_: bool;
    var phi_2779_: bool;
    var phi_1123_: u32;
    var phi_2783_: bool;
    var local_11: bool;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2857_: u32;
    var phi_2858_: u32;
    var phi_793_: u32;
    var phi_2859_: bool;
    var phi_2860_: bool;
    var local_12: bool;
    var phi_2864_: bool;
    var phi_2868_: bool;
    var phi_2869_: bool;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var phi_2875_: bool;
    var phi_2879_: f32;
    var phi_2880_: f32;
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
        let _e96 = p.member.light;
        let _e97 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e97 {
            let _e99 = local_2.normal;
            let _e101 = local_2.position;
            if ((((_e99.x * (_e96.x - (_e101.x * _e96.w))) + (_e99.y * (_e96.y - (_e101.y * _e96.w)))) + (_e99.z * (_e96.z - (_e101.z * _e96.w)))) > 0f) {
                let _e125 = local_2.flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_348_;
            phi_352_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_352_;
        let _e181 = p.member.root;
        if _e176.unnamed_1 {
            phi_2880_ = _e176.unnamed.visibility;
        } else {
            let _e183 = p.member.light;
            let _e185 = local_2.position;
            let _e187 = local_2.normal;
            let _e189 = local_2.magnitude;
            let _e191 = ((8f / 8388608f) * _e189);
            let _e199 = (_e185.x + (_e187.x * _e191));
            let _e201 = (_e185.y + (_e187.y * _e191));
            let _e203 = (_e185.z + (_e187.z * _e191));
            if (_e183.w == 0f) {
                phi_394_ = 300000000000000000000000000000000000000f;
            } else {
                phi_394_ = 1f;
            }
            let _e207 = phi_394_;
            let _e215 = (_e183.x - (_e199 * _e183.w));
            let _e216 = (_e183.y - (_e201 * _e183.w));
            let _e217 = (_e183.z - (_e203 * _e183.w));
            let _e221 = abs(_e215);
            let _e222 = abs(_e216);
            let _e223 = abs(_e217);
            if (abs(_e199) < 1000000000000000f) {
                if (abs(_e201) < 1000000000000000f) {
                    if (abs(_e203) < 1000000000000000f) {
                        if (_e221 < 1000000000000000f) {
                            if (_e222 < 1000000000000000f) {
                                if (_e223 < 1000000000000000f) {
                                    if (_e221 > 0f) {
                                        phi_451_ = bool();
                                        phi_452_ = true;
                                    } else {
                                        let _e231 = (_e222 > 0f);
                                        if _e231 {
                                            phi_450_ = bool();
                                        } else {
                                            phi_450_ = (_e223 > 0f);
                                        }
                                        let _e234 = phi_450_;
                                        phi_451_ = _e234;
                                        phi_452_ = _e231;
                                    }
                                    let _e236 = phi_451_;
                                    let _e238 = phi_452_;
                                    if _e238 {
                                        phi_456_ = true;
                                    } else {
                                        phi_456_ = _e236;
                                    }
                                    let _e240 = phi_456_;
                                    phi_457_ = _e240;
                                    phi_458_ = false;
                                } else {
                                    phi_457_ = bool();
                                    phi_458_ = true;
                                }
                                let _e242 = phi_457_;
                                let _e244 = phi_458_;
                                phi_459_ = _e242;
                                phi_460_ = false;
                                phi_461_ = _e244;
                            } else {
                                phi_459_ = bool();
                                phi_460_ = true;
                                phi_461_ = false;
                            }
                            let _e246 = phi_459_;
                            let _e248 = phi_460_;
                            let _e250 = phi_461_;
                            phi_462_ = _e246;
                            phi_463_ = _e248;
                            phi_464_ = _e250;
                        } else {
                            phi_462_ = bool();
                            phi_463_ = true;
                            phi_464_ = false;
                        }
                        let _e252 = phi_462_;
                        let _e254 = phi_463_;
                        let _e256 = phi_464_;
                        phi_465_ = _e252;
                        phi_466_ = _e254;
                        phi_467_ = _e256;
                    } else {
                        phi_465_ = bool();
                        phi_466_ = true;
                        phi_467_ = false;
                    }
                    let _e258 = phi_465_;
                    let _e260 = phi_466_;
                    let _e262 = phi_467_;
                    phi_468_ = _e258;
                    phi_469_ = _e260;
                    phi_470_ = _e262;
                } else {
                    phi_468_ = bool();
                    phi_469_ = true;
                    phi_470_ = false;
                }
                let _e264 = phi_468_;
                let _e266 = phi_469_;
                let _e268 = phi_470_;
                phi_471_ = _e264;
                phi_472_ = _e266;
                phi_473_ = _e268;
            } else {
                phi_471_ = bool();
                phi_472_ = true;
                phi_473_ = false;
            }
            let _e270 = phi_471_;
            let _e272 = phi_472_;
            let _e274 = phi_473_;
            if _e272 {
                phi_477_ = true;
            } else {
                phi_477_ = _e274;
            }
            let _e276 = phi_477_;
            if _e276 {
                phi_481_ = false;
            } else {
                phi_481_ = _e270;
            }
            let _e278 = phi_481_;
            if _e278 {
                let _e279 = (_e181 >= _e64);
                if _e279 {
                    phi_2869_ = bool();
                } else {
                    if (_e181 < _e64) {
                    } else {
                        return;
                    }
                    let _e285 = nodes.member[(0u + _e181)].frame[0u];
                    let _e289 = nodes.member[(0u + _e181)].frame[1u];
                    let _e293 = nodes.member[(0u + _e181)].frame[2u];
                    let _e297 = nodes.member[(0u + _e181)].frame[0u];
                    let _e301 = nodes.member[(0u + _e181)].frame[1u];
                    let _e305 = nodes.member[(0u + _e181)].frame[2u];
                    let _e309 = nodes.member[(0u + _e181)].frame[3u];
                    let _e343 = core_intrinsics_maximum_number_nsz_f32_(abs(_e215), abs(_e216));
                    let _e344 = core_intrinsics_maximum_number_nsz_f32_(_e343, abs(_e217));
                    let _e345 = (_e344 * 0.0000000000009094947f);
                    if (abs(_e215) < _e345) {
                        phi_551_ = _e345;
                    } else {
                        phi_551_ = abs(_e215);
                    }
                    let _e350 = phi_551_;
                    if (_e215 < 0f) {
                        phi_558_ = (-1f / _e350);
                    } else {
                        phi_558_ = (1f / _e350);
                    }
                    let _e355 = phi_558_;
                    if (abs(_e216) < _e345) {
                        phi_565_ = _e345;
                    } else {
                        phi_565_ = abs(_e216);
                    }
                    let _e360 = phi_565_;
                    if (_e216 < 0f) {
                        phi_572_ = (-1f / _e360);
                    } else {
                        phi_572_ = (1f / _e360);
                    }
                    let _e365 = phi_572_;
                    if (abs(_e217) < _e345) {
                        phi_579_ = _e345;
                    } else {
                        phi_579_ = abs(_e217);
                    }
                    let _e370 = phi_579_;
                    if (_e217 < 0f) {
                        phi_586_ = (-1f / _e370);
                    } else {
                        phi_586_ = (1f / _e370);
                    }
                    let _e375 = phi_586_;
                    let _e379 = abs((bitcast<f32>(_e285) - _e199));
                    let _e380 = abs((bitcast<f32>(_e289) - _e201));
                    let _e381 = abs((bitcast<f32>(_e293) - _e203));
                    let _e385 = abs(((bitcast<f32>(_e297) + (bitcast<f32>((((_e309 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e199));
                    let _e386 = abs(((bitcast<f32>(_e301) + (bitcast<f32>((((_e309 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e201));
                    let _e387 = abs(((bitcast<f32>(_e305) + (bitcast<f32>((((_e309 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e203));
                    if (_e379 > _e385) {
                        phi_603_ = _e379;
                    } else {
                        phi_603_ = _e385;
                    }
                    let _e390 = phi_603_;
                    if (_e380 > _e386) {
                        phi_608_ = _e380;
                    } else {
                        phi_608_ = _e386;
                    }
                    let _e393 = phi_608_;
                    if (_e381 > _e387) {
                        phi_613_ = _e381;
                    } else {
                        phi_613_ = _e387;
                    }
                    let _e396 = phi_613_;
                    let _e397 = core_intrinsics_maximum_number_nsz_f32_(_e390, _e393);
                    let _e398 = core_intrinsics_maximum_number_nsz_f32_(_e397, _e396);
                    let _e402 = (_e398 * 0.0000019073486f);
                    let _e403 = (abs(_e355) * _e402);
                    let _e404 = (abs(_e365) * _e402);
                    let _e405 = (abs(_e375) * _e402);
                    let _e409 = (_e398 * 0.0000009536743f);
                    let _e410 = (abs(_e355) * _e409);
                    let _e411 = (abs(_e365) * _e409);
                    let _e412 = (abs(_e375) * _e409);
                    if (_e355 < 0f) {
                        phi_634_ = 0u;
                    } else {
                        phi_634_ = 1u;
                    }
                    let _e415 = phi_634_;
                    if (_e365 < 0f) {
                        phi_639_ = 0u;
                    } else {
                        phi_639_ = 2u;
                    }
                    let _e418 = phi_639_;
                    if (_e375 < 0f) {
                        phi_644_ = 0u;
                    } else {
                        phi_644_ = 4u;
                    }
                    let _e421 = phi_644_;
                    let _e423 = ((_e415 | _e418) | _e421);
                    let _e424 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e181, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e424.first[0], _e424.first[1], _e424.first[2], _e424.first[3], _e424.first[4], _e424.first[5], _e424.first[6], _e424.first[7], _e424.first[8], _e424.first[9], _e424.first[10], _e424.first[11], _e424.first[12], _e424.first[13], _e424.first[14], _e424.first[15], _e424.first[16], _e424.first[17], _e424.first[18], _e424.first[19], _e424.first[20], _e424.first[21], _e424.first[22], _e424.first[23], _e424.first[24], _e424.first[25], _e424.first[26], _e424.first[27], _e424.first[28], _e424.first[29], _e424.first[30], _e424.first[31]), array<u32, 32>(_e424.mask[0], _e424.mask[1], _e424.mask[2], _e424.mask[3], _e424.mask[4], _e424.mask[5], _e424.mask[6], _e424.mask[7], _e424.mask[8], _e424.mask[9], _e424.mask[10], _e424.mask[11], _e424.mask[12], _e424.mask[13], _e424.mask[14], _e424.mask[15], _e424.mask[16], _e424.mask[17], _e424.mask[18], _e424.mask[19], _e424.mask[20], _e424.mask[21], _e424.mask[22], _e424.mask[23], _e424.mask[24], _e424.mask[25], _e424.mask[26], _e424.mask[27], _e424.mask[28], _e424.mask[29], _e424.mask[30], _e424.mask[31]), _e424.len, _e424.group, _e424.group_mask);
                    let _e498 = local_1.group_mask;
                    if ((_e498 & 4278190080u) == 0u) {
                        let _e502 = local_1.len;
                        if (_e502 == 0u) {
                            phi_758_ = false;
                        } else {
                            let _e506 = local_1.len;
                            local_1.len = (_e506 - 1u);
                            let _e509 = local_1.len;
                            if (_e509 < 32u) {
                            } else {
                                return;
                            }
                            let _e514 = local_1.first[(0u + _e509)];
                            local_1.group = _e514;
                            let _e517 = local_1.len;
                            if (_e517 < 32u) {
                            } else {
                                return;
                            }
                            let _e522 = local_1.mask[(0u + _e517)];
                            local_1.group_mask = _e522;
                            phi_758_ = true;
                        }
                        let _e525 = phi_758_;
                        phi_759_ = _e525;
                    } else {
                        phi_759_ = true;
                    }
                    let _e527 = phi_759_;
                    if _e527 {
                        let _e529 = local_1.group_mask;
                        let _e535 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e529)), 32u, (_e529 == 0u)));
                        let _e539 = local_1.group_mask;
                        let _e553 = local_1.group_mask;
                        local_1.group_mask = (_e553 & ~((1u << bitcast<u32>((_e535 & 31u)))));
                        let _e556 = local_1.group;
                        phi_790_ = (_e556 + countOneBits(((_e539 & ~((4294967295u << bitcast<u32>((((_e535 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_790_ = 4294967295u;
                    }
                    let _e559 = phi_790_;
                    phi_792_ = _e559;
                    loop {
                        let _e561 = phi_792_;
                        if (_e561 != 4294967295u) {
                            if (_e561 < _e64) {
                            } else {
                                return;
                            }
                            let _e568 = nodes.member[(0u + _e561)].frame[3u];
                            let _e593 = (bitcast<f32>((((_e568 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e355);
                            let _e594 = (bitcast<f32>((((_e568 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e365);
                            let _e595 = (bitcast<f32>((((_e568 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e375);
                            let _e598 = nodes.member[(0u + _e561)].frame[0u];
                            let _e602 = nodes.member[(0u + _e561)].frame[1u];
                            let _e606 = nodes.member[(0u + _e561)].frame[2u];
                            let _e611 = ((bitcast<f32>(_e598) - _e199) * _e355);
                            let _e612 = ((bitcast<f32>(_e602) - _e201) * _e365);
                            let _e613 = ((bitcast<f32>(_e606) - _e203) * _e375);
                            let _e621 = nodes.member[(0u + _e561)].x;
                            if (_e355 < 0f) {
                                let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e632.unnamed.root, _e621.w), _e632.unnamed_1);
                                let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e621.x, _e638.unnamed_1.first_primitive));
                                phi_873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e644.unnamed_1.root, _e621.y));
                            } else {
                                let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e660.unnamed.root, _e621.y), _e660.unnamed_1);
                                let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_bvh_traverse_Tree(_e621.z, _e666.unnamed_1.first_primitive));
                                phi_873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e672.unnamed_1.root, _e621.w));
                            }
                            let _e680 = phi_873_;
                            let _e690 = nodes.member[(0u + _e561)].y;
                            if (_e365 < 0f) {
                                let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e701.unnamed.root, _e690.w), _e701.unnamed_1);
                                let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e690.x, _e707.unnamed_1.first_primitive));
                                phi_900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e713.unnamed_1.root, _e690.y));
                            } else {
                                let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e729.unnamed.root, _e690.y), _e729.unnamed_1);
                                let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e690.z, _e735.unnamed_1.first_primitive));
                                phi_900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e741.unnamed_1.root, _e690.w));
                            }
                            let _e749 = phi_900_;
                            let _e759 = nodes.member[(0u + _e561)].z;
                            if (_e375 < 0f) {
                                let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e759.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e770.unnamed.root, _e759.w), _e770.unnamed_1);
                                let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_bvh_traverse_Tree(_e759.x, _e776.unnamed_1.first_primitive));
                                phi_927_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_bvh_traverse_Tree(_e782.unnamed_1.root, _e759.y));
                            } else {
                                let _e798 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e759.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e804 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e798.unnamed.root, _e759.y), _e798.unnamed_1);
                                let _e810 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e804.unnamed, lt_bvh_traverse_Tree(_e759.z, _e804.unnamed_1.first_primitive));
                                phi_927_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e810.unnamed, lt_bvh_traverse_Tree(_e810.unnamed_1.root, _e759.w));
                            }
                            let _e818 = phi_927_;
                            phi_933_ = 0u;
                            phi_936_ = 0u;
                            loop {
                                let _e828 = phi_933_;
                                let _e830 = phi_936_;
                                local_3 = _e830;
                                local_4 = _e830;
                                local_5 = _e830;
                                let _e831 = (_e828 < 8u);
                                if _e831 {
                                    let _e833 = (_e828 >> bitcast<u32>(2i));
                                    let _e834 = (_e828 & 3u);
                                    if (_e833 == 0u) {
                                        phi_950_ = _e680.unnamed.root;
                                    } else {
                                        phi_950_ = _e680.unnamed.first_primitive;
                                    }
                                    let _e837 = phi_950_;
                                    if (_e833 == 0u) {
                                        phi_960_ = _e749.unnamed.root;
                                    } else {
                                        phi_960_ = _e749.unnamed.first_primitive;
                                    }
                                    let _e846 = phi_960_;
                                    if (_e833 == 0u) {
                                        phi_970_ = _e818.unnamed.root;
                                    } else {
                                        phi_970_ = _e818.unnamed.first_primitive;
                                    }
                                    let _e855 = phi_970_;
                                    let _e868 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e837 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u)) * _e593) + (_e611 - _e403)), ((f32(((_e846 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u)) * _e594) + (_e612 - _e404)));
                                    let _e869 = core_intrinsics_maximum_number_nsz_f32_(_e868, ((f32(((_e855 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u)) * _e595) + (_e613 - _e405)));
                                    if (_e833 == 0u) {
                                        phi_988_ = _e680.unnamed_1.root;
                                    } else {
                                        phi_988_ = _e680.unnamed_1.first_primitive;
                                    }
                                    let _e872 = phi_988_;
                                    if (_e833 == 0u) {
                                        phi_998_ = _e749.unnamed_1.root;
                                    } else {
                                        phi_998_ = _e749.unnamed_1.first_primitive;
                                    }
                                    let _e881 = phi_998_;
                                    if (_e833 == 0u) {
                                        phi_1008_ = _e818.unnamed_1.root;
                                    } else {
                                        phi_1008_ = _e818.unnamed_1.first_primitive;
                                    }
                                    let _e890 = phi_1008_;
                                    let _e903 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e872 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u)) * _e593) + (_e611 + _e403)), ((f32(((_e881 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u)) * _e594) + (_e612 + _e404)));
                                    let _e904 = core_intrinsics_minimum_number_nsz_f32_(_e903, ((f32(((_e890 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u)) * _e595) + (_e613 + _e405)));
                                    if (_e869 <= _e904) {
                                        if (_e869 <= _e207) {
                                            if (_e904 >= 0f) {
                                                if (_e833 == 0u) {
                                                    let _e911 = nodes.member[(0u + _e561)].links[2u];
                                                    phi_1044_ = _e911;
                                                } else {
                                                    let _e914 = nodes.member[(0u + _e561)].links[3u];
                                                    phi_1044_ = _e914;
                                                }
                                                let _e916 = phi_1044_;
                                                let _e921 = ((_e916 >> bitcast<u32>(((_e834 * 8u) & 31u))) & 255u);
                                                let _e922 = (_e921 & 31u);
                                                if (_e922 >= 24u) {
                                                    phi_1057_ = (24u + ((_e922 - 24u) ^ _e423));
                                                } else {
                                                    phi_1057_ = _e922;
                                                }
                                                let _e928 = phi_1057_;
                                                phi_1062_ = (_e830 | ((_e921 >> bitcast<u32>(5i)) << bitcast<u32>((_e928 & 31u))));
                                            } else {
                                                phi_1062_ = _e830;
                                            }
                                            let _e936 = phi_1062_;
                                            phi_1063_ = _e936;
                                        } else {
                                            phi_1063_ = _e830;
                                        }
                                        let _e938 = phi_1063_;
                                        phi_1064_ = _e938;
                                    } else {
                                        phi_1064_ = _e830;
                                    }
                                    let _e940 = phi_1064_;
                                    phi_934_ = (_e828 + 1u);
                                    phi_937_ = _e940;
                                } else {
                                    phi_934_ = u32();
                                    phi_937_ = u32();
                                }
                                let _e943 = phi_934_;
                                let _e945 = phi_937_;
                                continue;
                                continuing {
                                    phi_933_ = _e943;
                                    phi_936_ = _e945;
                                    break if !(_e831);
                                }
                            }
                            let _e949 = nodes.member[(0u + _e561)].links[0u];
                            let _e953 = nodes.member[(0u + _e561)].frame[3u];
                            let _e957 = local_3;
                            if ((_e957 & 4278190080u) == 0u) {
                            } else {
                                let _e961 = local_1.group_mask;
                                if ((_e961 & 4278190080u) == 0u) {
                                } else {
                                    let _e965 = local_1.len;
                                    if (_e965 < 32u) {
                                        let _e968 = local_1.group;
                                        let _e970 = local_1.len;
                                        if (_e970 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e970)] = _e968;
                                        let _e976 = local_1.group_mask;
                                        let _e978 = local_1.len;
                                        if (_e978 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e978)] = _e976;
                                        let _e985 = local_1.len;
                                        local_1.len = (_e985 + 1u);
                                    }
                                }
                                local_1.group = (_e181 + _e949);
                                let _e989 = local_4;
                                local_1.group_mask = ((_e989 & 4278190080u) | (_e953 >> bitcast<u32>(24i)));
                            }
                            let _e994 = local_5;
                            phi_1122_ = (_e994 & 16777215u);
                            loop {
                                let _e997 = phi_1122_;
                                let _e998 = (_e997 == 0u);
                                local_11 = _e998;
                                local_18 = _e998;
                                if _e998 {
                                    phi_1123_ = u32();
                                    phi_2783_ = false;
                                } else {
                                    let _e1001 = nodes.member[(0u + _e561)].links[1u];
                                    let _e1005 = (_e1001 + select(firstTrailingBit(_e997), 32u, (_e997 == 0u)));
                                    if (_e1005 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1012 = instances.member[(0u + _e1005)].low_world;
                                    let _e1014 = instances.member[(0u + _e1005)].high_world;
                                    let _e1021 = ((_e1012.x - _e199) * _e355);
                                    let _e1022 = ((_e1012.y - _e201) * _e365);
                                    let _e1023 = ((_e1012.z - _e203) * _e375);
                                    let _e1030 = ((_e1014.x - _e199) * _e355);
                                    let _e1031 = ((_e1014.y - _e201) * _e365);
                                    let _e1032 = ((_e1014.z - _e203) * _e375);
                                    if (_e1021 < _e1030) {
                                        phi_1172_ = _e1021;
                                    } else {
                                        phi_1172_ = _e1030;
                                    }
                                    let _e1035 = phi_1172_;
                                    if (_e1022 < _e1031) {
                                        phi_1177_ = _e1022;
                                    } else {
                                        phi_1177_ = _e1031;
                                    }
                                    let _e1038 = phi_1177_;
                                    if (_e1023 < _e1032) {
                                        phi_1182_ = _e1023;
                                    } else {
                                        phi_1182_ = _e1032;
                                    }
                                    let _e1041 = phi_1182_;
                                    if (_e1021 > _e1030) {
                                        phi_1190_ = _e1021;
                                    } else {
                                        phi_1190_ = _e1030;
                                    }
                                    let _e1047 = phi_1190_;
                                    if (_e1022 > _e1031) {
                                        phi_1195_ = _e1022;
                                    } else {
                                        phi_1195_ = _e1031;
                                    }
                                    let _e1050 = phi_1195_;
                                    if (_e1023 > _e1032) {
                                        phi_1200_ = _e1023;
                                    } else {
                                        phi_1200_ = _e1032;
                                    }
                                    let _e1053 = phi_1200_;
                                    let _e1057 = core_intrinsics_maximum_number_nsz_f32_((_e1035 - _e410), (_e1038 - _e411));
                                    let _e1058 = core_intrinsics_maximum_number_nsz_f32_(_e1057, (_e1041 - _e412));
                                    let _e1059 = core_intrinsics_minimum_number_nsz_f32_((_e1047 + _e410), (_e1050 + _e411));
                                    let _e1060 = core_intrinsics_minimum_number_nsz_f32_(_e1059, (_e1053 + _e412));
                                    if (_e1058 <= _e1060) {
                                        if (_e1058 <= _e207) {
                                            if (_e1060 >= 0f) {
                                                let _e1066 = instances.member[(0u + _e1005)].world_to_object[0u];
                                                let _e1077 = ((((_e1066.x * _e199) + (_e1066.y * _e201)) + (_e1066.z * _e203)) + (_e1066.w * 1f));
                                                let _e1079 = instances.member[(0u + _e1005)].world_to_object[1u];
                                                let _e1090 = ((((_e1079.x * _e199) + (_e1079.y * _e201)) + (_e1079.z * _e203)) + (_e1079.w * 1f));
                                                let _e1092 = instances.member[(0u + _e1005)].world_to_object[2u];
                                                let _e1103 = ((((_e1092.x * _e199) + (_e1092.y * _e201)) + (_e1092.z * _e203)) + (_e1092.w * 1f));
                                                let _e1106 = instances.member[(0u + _e1005)].world_to_object[0u];
                                                let _e1117 = ((((_e1106.x * _e215) + (_e1106.y * _e216)) + (_e1106.z * _e217)) + (_e1106.w * 0f));
                                                let _e1119 = instances.member[(0u + _e1005)].world_to_object[1u];
                                                let _e1130 = ((((_e1119.x * _e215) + (_e1119.y * _e216)) + (_e1119.z * _e217)) + (_e1119.w * 0f));
                                                let _e1132 = instances.member[(0u + _e1005)].world_to_object[2u];
                                                let _e1143 = ((((_e1132.x * _e215) + (_e1132.y * _e216)) + (_e1132.z * _e217)) + (_e1132.w * 0f));
                                                let _e1146 = instances.member[(0u + _e1005)].root;
                                                let _e1148 = instances.member[(0u + _e1005)].first_triangle;
                                                let _e1152 = abs(_e1117);
                                                let _e1153 = abs(_e1130);
                                                let _e1154 = abs(_e1143);
                                                if (abs(_e1077) < 1000000000000000f) {
                                                    if (abs(_e1090) < 1000000000000000f) {
                                                        if (abs(_e1103) < 1000000000000000f) {
                                                            if (_e1152 < 1000000000000000f) {
                                                                if (_e1153 < 1000000000000000f) {
                                                                    if (_e1154 < 1000000000000000f) {
                                                                        if (_e1152 > 0f) {
                                                                            phi_1345_ = bool();
                                                                            phi_1346_ = true;
                                                                        } else {
                                                                            let _e1162 = (_e1153 > 0f);
                                                                            if _e1162 {
                                                                                phi_1344_ = bool();
                                                                            } else {
                                                                                phi_1344_ = (_e1154 > 0f);
                                                                            }
                                                                            let _e1165 = phi_1344_;
                                                                            phi_1345_ = _e1165;
                                                                            phi_1346_ = _e1162;
                                                                        }
                                                                        let _e1167 = phi_1345_;
                                                                        let _e1169 = phi_1346_;
                                                                        if _e1169 {
                                                                            phi_1350_ = true;
                                                                        } else {
                                                                            phi_1350_ = _e1167;
                                                                        }
                                                                        let _e1171 = phi_1350_;
                                                                        phi_1351_ = _e1171;
                                                                        phi_1352_ = false;
                                                                    } else {
                                                                        phi_1351_ = bool();
                                                                        phi_1352_ = true;
                                                                    }
                                                                    let _e1173 = phi_1351_;
                                                                    let _e1175 = phi_1352_;
                                                                    phi_1353_ = _e1173;
                                                                    phi_1354_ = false;
                                                                    phi_1355_ = _e1175;
                                                                } else {
                                                                    phi_1353_ = bool();
                                                                    phi_1354_ = true;
                                                                    phi_1355_ = false;
                                                                }
                                                                let _e1177 = phi_1353_;
                                                                let _e1179 = phi_1354_;
                                                                let _e1181 = phi_1355_;
                                                                phi_1356_ = _e1177;
                                                                phi_1357_ = _e1179;
                                                                phi_1358_ = _e1181;
                                                            } else {
                                                                phi_1356_ = bool();
                                                                phi_1357_ = true;
                                                                phi_1358_ = false;
                                                            }
                                                            let _e1183 = phi_1356_;
                                                            let _e1185 = phi_1357_;
                                                            let _e1187 = phi_1358_;
                                                            phi_1359_ = _e1183;
                                                            phi_1360_ = _e1185;
                                                            phi_1361_ = _e1187;
                                                        } else {
                                                            phi_1359_ = bool();
                                                            phi_1360_ = true;
                                                            phi_1361_ = false;
                                                        }
                                                        let _e1189 = phi_1359_;
                                                        let _e1191 = phi_1360_;
                                                        let _e1193 = phi_1361_;
                                                        phi_1362_ = _e1189;
                                                        phi_1363_ = _e1191;
                                                        phi_1364_ = _e1193;
                                                    } else {
                                                        phi_1362_ = bool();
                                                        phi_1363_ = true;
                                                        phi_1364_ = false;
                                                    }
                                                    let _e1195 = phi_1362_;
                                                    let _e1197 = phi_1363_;
                                                    let _e1199 = phi_1364_;
                                                    phi_1365_ = _e1195;
                                                    phi_1366_ = _e1197;
                                                    phi_1367_ = _e1199;
                                                } else {
                                                    phi_1365_ = bool();
                                                    phi_1366_ = true;
                                                    phi_1367_ = false;
                                                }
                                                let _e1201 = phi_1365_;
                                                let _e1203 = phi_1366_;
                                                let _e1205 = phi_1367_;
                                                if _e1203 {
                                                    phi_1371_ = true;
                                                } else {
                                                    phi_1371_ = _e1205;
                                                }
                                                let _e1207 = phi_1371_;
                                                if _e1207 {
                                                    phi_1375_ = false;
                                                } else {
                                                    phi_1375_ = _e1201;
                                                }
                                                let _e1209 = phi_1375_;
                                                if _e1209 {
                                                    let _e1210 = (_e1146 >= _e64);
                                                    if _e1210 {
                                                        phi_2766_ = bool();
                                                    } else {
                                                        if (_e1146 < _e64) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1216 = nodes.member[(0u + _e1146)].frame[0u];
                                                        let _e1220 = nodes.member[(0u + _e1146)].frame[1u];
                                                        let _e1224 = nodes.member[(0u + _e1146)].frame[2u];
                                                        let _e1228 = nodes.member[(0u + _e1146)].frame[0u];
                                                        let _e1232 = nodes.member[(0u + _e1146)].frame[1u];
                                                        let _e1236 = nodes.member[(0u + _e1146)].frame[2u];
                                                        let _e1240 = nodes.member[(0u + _e1146)].frame[3u];
                                                        let _e1274 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1117), abs(_e1130));
                                                        let _e1275 = core_intrinsics_maximum_number_nsz_f32_(_e1274, abs(_e1143));
                                                        let _e1276 = (_e1275 * 0.0000000000009094947f);
                                                        if (abs(_e1117) < _e1276) {
                                                            phi_1445_ = _e1276;
                                                        } else {
                                                            phi_1445_ = abs(_e1117);
                                                        }
                                                        let _e1281 = phi_1445_;
                                                        if (_e1117 < 0f) {
                                                            phi_1452_ = (-1f / _e1281);
                                                        } else {
                                                            phi_1452_ = (1f / _e1281);
                                                        }
                                                        let _e1286 = phi_1452_;
                                                        if (abs(_e1130) < _e1276) {
                                                            phi_1459_ = _e1276;
                                                        } else {
                                                            phi_1459_ = abs(_e1130);
                                                        }
                                                        let _e1291 = phi_1459_;
                                                        if (_e1130 < 0f) {
                                                            phi_1466_ = (-1f / _e1291);
                                                        } else {
                                                            phi_1466_ = (1f / _e1291);
                                                        }
                                                        let _e1296 = phi_1466_;
                                                        if (abs(_e1143) < _e1276) {
                                                            phi_1473_ = _e1276;
                                                        } else {
                                                            phi_1473_ = abs(_e1143);
                                                        }
                                                        let _e1301 = phi_1473_;
                                                        if (_e1143 < 0f) {
                                                            phi_1480_ = (-1f / _e1301);
                                                        } else {
                                                            phi_1480_ = (1f / _e1301);
                                                        }
                                                        let _e1306 = phi_1480_;
                                                        let _e1310 = abs((bitcast<f32>(_e1216) - _e1077));
                                                        let _e1311 = abs((bitcast<f32>(_e1220) - _e1090));
                                                        let _e1312 = abs((bitcast<f32>(_e1224) - _e1103));
                                                        let _e1316 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1240 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1077));
                                                        let _e1317 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1240 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1090));
                                                        let _e1318 = abs(((bitcast<f32>(_e1236) + (bitcast<f32>((((_e1240 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1103));
                                                        if (_e1310 > _e1316) {
                                                            phi_1497_ = _e1310;
                                                        } else {
                                                            phi_1497_ = _e1316;
                                                        }
                                                        let _e1321 = phi_1497_;
                                                        if (_e1311 > _e1317) {
                                                            phi_1502_ = _e1311;
                                                        } else {
                                                            phi_1502_ = _e1317;
                                                        }
                                                        let _e1324 = phi_1502_;
                                                        if (_e1312 > _e1318) {
                                                            phi_1507_ = _e1312;
                                                        } else {
                                                            phi_1507_ = _e1318;
                                                        }
                                                        let _e1327 = phi_1507_;
                                                        let _e1328 = core_intrinsics_maximum_number_nsz_f32_(_e1321, _e1324);
                                                        let _e1329 = core_intrinsics_maximum_number_nsz_f32_(_e1328, _e1327);
                                                        let _e1333 = (_e1329 * 0.0000019073486f);
                                                        let _e1334 = (abs(_e1286) * _e1333);
                                                        let _e1335 = (abs(_e1296) * _e1333);
                                                        let _e1336 = (abs(_e1306) * _e1333);
                                                        let _e1340 = (_e1329 * 0.0000009536743f);
                                                        let _e1341 = (abs(_e1286) * _e1340);
                                                        let _e1342 = (abs(_e1296) * _e1340);
                                                        let _e1343 = (abs(_e1306) * _e1340);
                                                        let _e1344 = abs(_e1117);
                                                        let _e1345 = abs(_e1130);
                                                        let _e1346 = abs(_e1143);
                                                        if (_e1344 >= _e1345) {
                                                            if (_e1344 >= _e1346) {
                                                                phi_1535_ = false;
                                                            } else {
                                                                phi_1535_ = true;
                                                            }
                                                            let _e1350 = phi_1535_;
                                                            phi_1536_ = _e1350;
                                                        } else {
                                                            phi_1536_ = true;
                                                        }
                                                        let _e1352 = phi_1536_;
                                                        if _e1352 {
                                                            if (_e1345 >= _e1346) {
                                                                phi_1544_ = 1u;
                                                            } else {
                                                                phi_1544_ = 2u;
                                                            }
                                                            let _e1355 = phi_1544_;
                                                            phi_1545_ = _e1355;
                                                        } else {
                                                            phi_1545_ = 0u;
                                                        }
                                                        let _e1357 = phi_1545_;
                                                        if (_e1357 == 0u) {
                                                            phi_1557_ = vec3<f32>(_e1130, _e1143, _e1117);
                                                        } else {
                                                            if (_e1357 == 1u) {
                                                                phi_1556_ = vec3<f32>(_e1143, _e1117, _e1130);
                                                            } else {
                                                                phi_1556_ = vec3<f32>(_e1117, _e1130, _e1143);
                                                            }
                                                            let _e1363 = phi_1556_;
                                                            phi_1557_ = _e1363;
                                                        }
                                                        let _e1365 = phi_1557_;
                                                        let _e1368 = (_e1365.x / _e1365.z);
                                                        let _e1371 = (_e1365.y / _e1365.z);
                                                        if (_e1286 < 0f) {
                                                            phi_1570_ = 0u;
                                                        } else {
                                                            phi_1570_ = 1u;
                                                        }
                                                        let _e1376 = phi_1570_;
                                                        if (_e1296 < 0f) {
                                                            phi_1575_ = 0u;
                                                        } else {
                                                            phi_1575_ = 2u;
                                                        }
                                                        let _e1379 = phi_1575_;
                                                        if (_e1306 < 0f) {
                                                            phi_1580_ = 0u;
                                                        } else {
                                                            phi_1580_ = 4u;
                                                        }
                                                        let _e1382 = phi_1580_;
                                                        let _e1384 = ((_e1376 | _e1379) | _e1382);
                                                        let _e1385 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1146, 2147483648u);
                                                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1385.first[0], _e1385.first[1], _e1385.first[2], _e1385.first[3], _e1385.first[4], _e1385.first[5], _e1385.first[6], _e1385.first[7], _e1385.first[8], _e1385.first[9], _e1385.first[10], _e1385.first[11], _e1385.first[12], _e1385.first[13], _e1385.first[14], _e1385.first[15], _e1385.first[16], _e1385.first[17], _e1385.first[18], _e1385.first[19], _e1385.first[20], _e1385.first[21], _e1385.first[22], _e1385.first[23], _e1385.first[24], _e1385.first[25], _e1385.first[26], _e1385.first[27], _e1385.first[28], _e1385.first[29], _e1385.first[30], _e1385.first[31]), array<u32, 32>(_e1385.mask[0], _e1385.mask[1], _e1385.mask[2], _e1385.mask[3], _e1385.mask[4], _e1385.mask[5], _e1385.mask[6], _e1385.mask[7], _e1385.mask[8], _e1385.mask[9], _e1385.mask[10], _e1385.mask[11], _e1385.mask[12], _e1385.mask[13], _e1385.mask[14], _e1385.mask[15], _e1385.mask[16], _e1385.mask[17], _e1385.mask[18], _e1385.mask[19], _e1385.mask[20], _e1385.mask[21], _e1385.mask[22], _e1385.mask[23], _e1385.mask[24], _e1385.mask[25], _e1385.mask[26], _e1385.mask[27], _e1385.mask[28], _e1385.mask[29], _e1385.mask[30], _e1385.mask[31]), _e1385.len, _e1385.group, _e1385.group_mask);
                                                        let _e1459 = local.group_mask;
                                                        if ((_e1459 & 4278190080u) == 0u) {
                                                            let _e1463 = local.len;
                                                            if (_e1463 == 0u) {
                                                                phi_1694_ = false;
                                                            } else {
                                                                let _e1467 = local.len;
                                                                local.len = (_e1467 - 1u);
                                                                let _e1470 = local.len;
                                                                if (_e1470 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1475 = local.first[(0u + _e1470)];
                                                                local.group = _e1475;
                                                                let _e1478 = local.len;
                                                                if (_e1478 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1483 = local.mask[(0u + _e1478)];
                                                                local.group_mask = _e1483;
                                                                phi_1694_ = true;
                                                            }
                                                            let _e1486 = phi_1694_;
                                                            phi_1695_ = _e1486;
                                                        } else {
                                                            phi_1695_ = true;
                                                        }
                                                        let _e1488 = phi_1695_;
                                                        if _e1488 {
                                                            let _e1490 = local.group_mask;
                                                            let _e1496 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1490)), 32u, (_e1490 == 0u)));
                                                            let _e1500 = local.group_mask;
                                                            let _e1514 = local.group_mask;
                                                            local.group_mask = (_e1514 & ~((1u << bitcast<u32>((_e1496 & 31u)))));
                                                            let _e1517 = local.group;
                                                            phi_1726_ = (_e1517 + countOneBits(((_e1500 & ~((4294967295u << bitcast<u32>((((_e1496 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_1726_ = 4294967295u;
                                                        }
                                                        let _e1520 = phi_1726_;
                                                        phi_1728_ = _e1520;
                                                        loop {
                                                            let _e1522 = phi_1728_;
                                                            if (_e1522 != 4294967295u) {
                                                                if (_e1522 < _e64) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1529 = nodes.member[(0u + _e1522)].frame[3u];
                                                                let _e1554 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1286);
                                                                let _e1555 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1296);
                                                                let _e1556 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1306);
                                                                let _e1559 = nodes.member[(0u + _e1522)].frame[0u];
                                                                let _e1563 = nodes.member[(0u + _e1522)].frame[1u];
                                                                let _e1567 = nodes.member[(0u + _e1522)].frame[2u];
                                                                let _e1572 = ((bitcast<f32>(_e1559) - _e1077) * _e1286);
                                                                let _e1573 = ((bitcast<f32>(_e1563) - _e1090) * _e1296);
                                                                let _e1574 = ((bitcast<f32>(_e1567) - _e1103) * _e1306);
                                                                let _e1582 = nodes.member[(0u + _e1522)].x;
                                                                if (_e1286 < 0f) {
                                                                    let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1593.unnamed.root, _e1582.w), _e1593.unnamed_1);
                                                                    let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_bvh_traverse_Tree(_e1582.x, _e1599.unnamed_1.first_primitive));
                                                                    phi_1809_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1605.unnamed, lt_bvh_traverse_Tree(_e1605.unnamed_1.root, _e1582.y));
                                                                } else {
                                                                    let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1621.unnamed.root, _e1582.y), _e1621.unnamed_1);
                                                                    let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_bvh_traverse_Tree(_e1582.z, _e1627.unnamed_1.first_primitive));
                                                                    phi_1809_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1633.unnamed, lt_bvh_traverse_Tree(_e1633.unnamed_1.root, _e1582.w));
                                                                }
                                                                let _e1641 = phi_1809_;
                                                                let _e1651 = nodes.member[(0u + _e1522)].y;
                                                                if (_e1296 < 0f) {
                                                                    let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1662.unnamed.root, _e1651.w), _e1662.unnamed_1);
                                                                    let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_bvh_traverse_Tree(_e1651.x, _e1668.unnamed_1.first_primitive));
                                                                    phi_1836_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1674.unnamed, lt_bvh_traverse_Tree(_e1674.unnamed_1.root, _e1651.y));
                                                                } else {
                                                                    let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1690.unnamed.root, _e1651.y), _e1690.unnamed_1);
                                                                    let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_bvh_traverse_Tree(_e1651.z, _e1696.unnamed_1.first_primitive));
                                                                    phi_1836_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1702.unnamed, lt_bvh_traverse_Tree(_e1702.unnamed_1.root, _e1651.w));
                                                                }
                                                                let _e1710 = phi_1836_;
                                                                let _e1720 = nodes.member[(0u + _e1522)].z;
                                                                if (_e1306 < 0f) {
                                                                    let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1731.unnamed.root, _e1720.w), _e1731.unnamed_1);
                                                                    let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_bvh_traverse_Tree(_e1720.x, _e1737.unnamed_1.first_primitive));
                                                                    phi_1863_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1743.unnamed, lt_bvh_traverse_Tree(_e1743.unnamed_1.root, _e1720.y));
                                                                } else {
                                                                    let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1759.unnamed.root, _e1720.y), _e1759.unnamed_1);
                                                                    let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_bvh_traverse_Tree(_e1720.z, _e1765.unnamed_1.first_primitive));
                                                                    phi_1863_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1771.unnamed, lt_bvh_traverse_Tree(_e1771.unnamed_1.root, _e1720.w));
                                                                }
                                                                let _e1779 = phi_1863_;
                                                                phi_1869_ = 0u;
                                                                phi_1872_ = 0u;
                                                                loop {
                                                                    let _e1789 = phi_1869_;
                                                                    let _e1791 = phi_1872_;
                                                                    local_6 = _e1791;
                                                                    local_7 = _e1791;
                                                                    local_8 = _e1791;
                                                                    let _e1792 = (_e1789 < 8u);
                                                                    if _e1792 {
                                                                        let _e1794 = (_e1789 >> bitcast<u32>(2i));
                                                                        let _e1795 = (_e1789 & 3u);
                                                                        if (_e1794 == 0u) {
                                                                            phi_1886_ = _e1641.unnamed.root;
                                                                        } else {
                                                                            phi_1886_ = _e1641.unnamed.first_primitive;
                                                                        }
                                                                        let _e1798 = phi_1886_;
                                                                        if (_e1794 == 0u) {
                                                                            phi_1896_ = _e1710.unnamed.root;
                                                                        } else {
                                                                            phi_1896_ = _e1710.unnamed.first_primitive;
                                                                        }
                                                                        let _e1807 = phi_1896_;
                                                                        if (_e1794 == 0u) {
                                                                            phi_1906_ = _e1779.unnamed.root;
                                                                        } else {
                                                                            phi_1906_ = _e1779.unnamed.first_primitive;
                                                                        }
                                                                        let _e1816 = phi_1906_;
                                                                        let _e1829 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1798 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1334)), ((f32(((_e1807 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1335)));
                                                                        let _e1830 = core_intrinsics_maximum_number_nsz_f32_(_e1829, ((f32(((_e1816 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 - _e1336)));
                                                                        if (_e1794 == 0u) {
                                                                            phi_1924_ = _e1641.unnamed_1.root;
                                                                        } else {
                                                                            phi_1924_ = _e1641.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1833 = phi_1924_;
                                                                        if (_e1794 == 0u) {
                                                                            phi_1934_ = _e1710.unnamed_1.root;
                                                                        } else {
                                                                            phi_1934_ = _e1710.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1842 = phi_1934_;
                                                                        if (_e1794 == 0u) {
                                                                            phi_1944_ = _e1779.unnamed_1.root;
                                                                        } else {
                                                                            phi_1944_ = _e1779.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1851 = phi_1944_;
                                                                        let _e1864 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1833 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1334)), ((f32(((_e1842 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1335)));
                                                                        let _e1865 = core_intrinsics_minimum_number_nsz_f32_(_e1864, ((f32(((_e1851 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 + _e1336)));
                                                                        if (_e1830 <= _e1865) {
                                                                            if (_e1830 <= _e207) {
                                                                                if (_e1865 >= 0f) {
                                                                                    if (_e1794 == 0u) {
                                                                                        let _e1872 = nodes.member[(0u + _e1522)].links[2u];
                                                                                        phi_1980_ = _e1872;
                                                                                    } else {
                                                                                        let _e1875 = nodes.member[(0u + _e1522)].links[3u];
                                                                                        phi_1980_ = _e1875;
                                                                                    }
                                                                                    let _e1877 = phi_1980_;
                                                                                    let _e1882 = ((_e1877 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u);
                                                                                    let _e1883 = (_e1882 & 31u);
                                                                                    if (_e1883 >= 24u) {
                                                                                        phi_1993_ = (24u + ((_e1883 - 24u) ^ _e1384));
                                                                                    } else {
                                                                                        phi_1993_ = _e1883;
                                                                                    }
                                                                                    let _e1889 = phi_1993_;
                                                                                    phi_1998_ = (_e1791 | ((_e1882 >> bitcast<u32>(5i)) << bitcast<u32>((_e1889 & 31u))));
                                                                                } else {
                                                                                    phi_1998_ = _e1791;
                                                                                }
                                                                                let _e1897 = phi_1998_;
                                                                                phi_1999_ = _e1897;
                                                                            } else {
                                                                                phi_1999_ = _e1791;
                                                                            }
                                                                            let _e1899 = phi_1999_;
                                                                            phi_2000_ = _e1899;
                                                                        } else {
                                                                            phi_2000_ = _e1791;
                                                                        }
                                                                        let _e1901 = phi_2000_;
                                                                        phi_1870_ = (_e1789 + 1u);
                                                                        phi_1873_ = _e1901;
                                                                    } else {
                                                                        phi_1870_ = u32();
                                                                        phi_1873_ = u32();
                                                                    }
                                                                    let _e1904 = phi_1870_;
                                                                    let _e1906 = phi_1873_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1869_ = _e1904;
                                                                        phi_1872_ = _e1906;
                                                                        break if !(_e1792);
                                                                    }
                                                                }
                                                                let _e1910 = nodes.member[(0u + _e1522)].links[0u];
                                                                let _e1914 = nodes.member[(0u + _e1522)].frame[3u];
                                                                let _e1918 = local_6;
                                                                if ((_e1918 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1922 = local.group_mask;
                                                                    if ((_e1922 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1926 = local.len;
                                                                        if (_e1926 < 32u) {
                                                                            let _e1929 = local.group;
                                                                            let _e1931 = local.len;
                                                                            if (_e1931 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.first[(0u + _e1931)] = _e1929;
                                                                            let _e1937 = local.group_mask;
                                                                            let _e1939 = local.len;
                                                                            if (_e1939 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.mask[(0u + _e1939)] = _e1937;
                                                                            let _e1946 = local.len;
                                                                            local.len = (_e1946 + 1u);
                                                                        }
                                                                    }
                                                                    local.group = (_e1146 + _e1910);
                                                                    let _e1950 = local_7;
                                                                    local.group_mask = ((_e1950 & 4278190080u) | (_e1914 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1955 = local_8;
                                                                phi_2058_ = (_e1955 & 16777215u);
                                                                loop {
                                                                    let _e1958 = phi_2058_;
                                                                    let _e1959 = (_e1958 == 0u);
                                                                    local_9 = _e1959;
                                                                    local_15 = _e1959;
                                                                    if _e1959 {
                                                                        phi_2059_ = u32();
                                                                        phi_2669_ = false;
                                                                        phi_2670_ = false;
                                                                        phi_2671_ = false;
                                                                    } else {
                                                                        let _e1962 = nodes.member[(0u + _e1522)].links[1u];
                                                                        let _e1967 = ((_e1148 + _e1962) + select(firstTrailingBit(_e1958), 32u, (_e1958 == 0u)));
                                                                        if (_e1967 < arrayLength((&triangles.member))) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1974 = triangles.member[(0u + _e1967)].v0_;
                                                                        let _e1976 = (_e1974.x - _e1077);
                                                                        let _e1978 = (_e1974.y - _e1090);
                                                                        let _e1980 = (_e1974.z - _e1103);
                                                                        if (_e1357 == 0u) {
                                                                            phi_2104_ = vec3<f32>(_e1978, _e1980, _e1976);
                                                                        } else {
                                                                            if (_e1357 == 1u) {
                                                                                phi_2103_ = vec3<f32>(_e1980, _e1976, _e1978);
                                                                            } else {
                                                                                phi_2103_ = (_e1974 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                            }
                                                                            let _e1988 = phi_2103_;
                                                                            phi_2104_ = _e1988;
                                                                        }
                                                                        let _e1990 = phi_2104_;
                                                                        let _e1994 = (_e1990.x - (_e1368 * _e1990.z));
                                                                        let _e1998 = (_e1990.y - (_e1371 * _e1990.z));
                                                                        let _e2000 = triangles.member[(0u + _e1967)].v1_;
                                                                        let _e2002 = (_e2000.x - _e1077);
                                                                        let _e2004 = (_e2000.y - _e1090);
                                                                        let _e2006 = (_e2000.z - _e1103);
                                                                        if (_e1357 == 0u) {
                                                                            phi_2134_ = vec3<f32>(_e2004, _e2006, _e2002);
                                                                        } else {
                                                                            if (_e1357 == 1u) {
                                                                                phi_2133_ = vec3<f32>(_e2006, _e2002, _e2004);
                                                                            } else {
                                                                                phi_2133_ = (_e2000 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                            }
                                                                            let _e2014 = phi_2133_;
                                                                            phi_2134_ = _e2014;
                                                                        }
                                                                        let _e2016 = phi_2134_;
                                                                        let _e2020 = (_e2016.x - (_e1368 * _e2016.z));
                                                                        let _e2024 = (_e2016.y - (_e1371 * _e2016.z));
                                                                        let _e2026 = triangles.member[(0u + _e1967)].v2_;
                                                                        let _e2028 = (_e2026.x - _e1077);
                                                                        let _e2030 = (_e2026.y - _e1090);
                                                                        let _e2032 = (_e2026.z - _e1103);
                                                                        if (_e1357 == 0u) {
                                                                            phi_2164_ = vec3<f32>(_e2030, _e2032, _e2028);
                                                                        } else {
                                                                            if (_e1357 == 1u) {
                                                                                phi_2163_ = vec3<f32>(_e2032, _e2028, _e2030);
                                                                            } else {
                                                                                phi_2163_ = (_e2026 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                            }
                                                                            let _e2040 = phi_2163_;
                                                                            phi_2164_ = _e2040;
                                                                        }
                                                                        let _e2042 = phi_2164_;
                                                                        let _e2046 = (_e2042.x - (_e1368 * _e2042.z));
                                                                        let _e2050 = (_e2042.y - (_e1371 * _e2042.z));
                                                                        if (_e2020 < _e2046) {
                                                                            phi_2183_ = true;
                                                                        } else {
                                                                            if (_e2020 == _e2046) {
                                                                                phi_2182_ = (_e2024 < _e2050);
                                                                            } else {
                                                                                phi_2182_ = false;
                                                                            }
                                                                            let _e2055 = phi_2182_;
                                                                            phi_2183_ = _e2055;
                                                                        }
                                                                        let _e2057 = phi_2183_;
                                                                        if _e2057 {
                                                                            phi_2187_ = _e2050;
                                                                            phi_2188_ = _e2046;
                                                                            phi_2189_ = _e2024;
                                                                            phi_2190_ = _e2020;
                                                                        } else {
                                                                            phi_2187_ = _e2024;
                                                                            phi_2188_ = _e2020;
                                                                            phi_2189_ = _e2050;
                                                                            phi_2190_ = _e2046;
                                                                        }
                                                                        let _e2059 = phi_2187_;
                                                                        let _e2061 = phi_2188_;
                                                                        let _e2063 = phi_2189_;
                                                                        let _e2065 = phi_2190_;
                                                                        let _e2068 = ((_e2065 * _e2059) - (_e2063 * _e2061));
                                                                        if _e2057 {
                                                                            phi_2198_ = -(_e2068);
                                                                        } else {
                                                                            phi_2198_ = _e2068;
                                                                        }
                                                                        let _e2071 = phi_2198_;
                                                                        if (_e2046 < _e1994) {
                                                                            phi_2209_ = true;
                                                                        } else {
                                                                            if (_e2046 == _e1994) {
                                                                                phi_2208_ = (_e2050 < _e1998);
                                                                            } else {
                                                                                phi_2208_ = false;
                                                                            }
                                                                            let _e2076 = phi_2208_;
                                                                            phi_2209_ = _e2076;
                                                                        }
                                                                        let _e2078 = phi_2209_;
                                                                        if _e2078 {
                                                                            phi_2213_ = _e1998;
                                                                            phi_2214_ = _e1994;
                                                                            phi_2215_ = _e2050;
                                                                            phi_2216_ = _e2046;
                                                                        } else {
                                                                            phi_2213_ = _e2050;
                                                                            phi_2214_ = _e2046;
                                                                            phi_2215_ = _e1998;
                                                                            phi_2216_ = _e1994;
                                                                        }
                                                                        let _e2080 = phi_2213_;
                                                                        let _e2082 = phi_2214_;
                                                                        let _e2084 = phi_2215_;
                                                                        let _e2086 = phi_2216_;
                                                                        let _e2089 = ((_e2086 * _e2080) - (_e2084 * _e2082));
                                                                        if _e2078 {
                                                                            phi_2224_ = -(_e2089);
                                                                        } else {
                                                                            phi_2224_ = _e2089;
                                                                        }
                                                                        let _e2092 = phi_2224_;
                                                                        if (_e1994 < _e2020) {
                                                                            phi_2235_ = true;
                                                                        } else {
                                                                            if (_e1994 == _e2020) {
                                                                                phi_2234_ = (_e1998 < _e2024);
                                                                            } else {
                                                                                phi_2234_ = false;
                                                                            }
                                                                            let _e2097 = phi_2234_;
                                                                            phi_2235_ = _e2097;
                                                                        }
                                                                        let _e2099 = phi_2235_;
                                                                        if _e2099 {
                                                                            phi_2239_ = _e2024;
                                                                            phi_2240_ = _e2020;
                                                                            phi_2241_ = _e1998;
                                                                            phi_2242_ = _e1994;
                                                                        } else {
                                                                            phi_2239_ = _e1998;
                                                                            phi_2240_ = _e1994;
                                                                            phi_2241_ = _e2024;
                                                                            phi_2242_ = _e2020;
                                                                        }
                                                                        let _e2101 = phi_2239_;
                                                                        let _e2103 = phi_2240_;
                                                                        let _e2105 = phi_2241_;
                                                                        let _e2107 = phi_2242_;
                                                                        let _e2110 = ((_e2107 * _e2101) - (_e2105 * _e2103));
                                                                        if _e2099 {
                                                                            phi_2250_ = -(_e2110);
                                                                        } else {
                                                                            phi_2250_ = _e2110;
                                                                        }
                                                                        let _e2113 = phi_2250_;
                                                                        if (_e2071 >= 0f) {
                                                                            if (_e2092 >= 0f) {
                                                                                if (_e2113 >= 0f) {
                                                                                    phi_2265_ = ((_e2071 + _e2092) + _e2113);
                                                                                    phi_2266_ = false;
                                                                                } else {
                                                                                    phi_2265_ = f32();
                                                                                    phi_2266_ = true;
                                                                                }
                                                                                let _e2120 = phi_2265_;
                                                                                let _e2122 = phi_2266_;
                                                                                phi_2267_ = _e2120;
                                                                                phi_2268_ = _e2122;
                                                                            } else {
                                                                                phi_2267_ = f32();
                                                                                phi_2268_ = true;
                                                                            }
                                                                            let _e2124 = phi_2267_;
                                                                            let _e2126 = phi_2268_;
                                                                            phi_2269_ = _e2124;
                                                                            phi_2270_ = _e2126;
                                                                        } else {
                                                                            phi_2269_ = f32();
                                                                            phi_2270_ = true;
                                                                        }
                                                                        let _e2128 = phi_2269_;
                                                                        let _e2130 = phi_2270_;
                                                                        if _e2130 {
                                                                            if (_e2071 <= 0f) {
                                                                                if (_e2092 <= 0f) {
                                                                                    let _e2133 = (_e2113 <= 0f);
                                                                                    if _e2133 {
                                                                                    }
                                                                                    phi_2288_ = ((_e2071 + _e2092) + _e2113);
                                                                                    phi_2289_ = false;
                                                                                    phi_2290_ = _e2133;
                                                                                } else {
                                                                                    phi_2288_ = f32();
                                                                                    phi_2289_ = true;
                                                                                    phi_2290_ = false;
                                                                                }
                                                                                let _e2137 = phi_2288_;
                                                                                let _e2139 = phi_2289_;
                                                                                let _e2141 = phi_2290_;
                                                                                phi_2291_ = _e2137;
                                                                                phi_2292_ = _e2139;
                                                                                phi_2293_ = _e2141;
                                                                            } else {
                                                                                phi_2291_ = f32();
                                                                                phi_2292_ = true;
                                                                                phi_2293_ = false;
                                                                            }
                                                                            let _e2143 = phi_2291_;
                                                                            let _e2145 = phi_2292_;
                                                                            let _e2147 = phi_2293_;
                                                                            if _e2145 {
                                                                                phi_2297_ = false;
                                                                            } else {
                                                                                phi_2297_ = _e2147;
                                                                            }
                                                                            let _e2149 = phi_2297_;
                                                                            phi_2298_ = _e2143;
                                                                            phi_2299_ = _e2149;
                                                                        } else {
                                                                            phi_2298_ = _e2128;
                                                                            phi_2299_ = true;
                                                                        }
                                                                        let _e2151 = phi_2298_;
                                                                        let _e2153 = phi_2299_;
                                                                        if _e2153 {
                                                                            let _e2154 = (_e2151 == 0f);
                                                                            if _e2154 {
                                                                                phi_2615_ = lt_bvh_triangle_Intersection();
                                                                                phi_2616_ = false;
                                                                            } else {
                                                                                let _e2156 = triangles.member[(0u + _e1967)].v0_;
                                                                                let _e2158 = (_e2156.x - _e1077);
                                                                                let _e2160 = (_e2156.y - _e1090);
                                                                                let _e2162 = (_e2156.z - _e1103);
                                                                                if (_e1357 == 0u) {
                                                                                    phi_2328_ = vec3<f32>(_e2160, _e2162, _e2158);
                                                                                } else {
                                                                                    if (_e1357 == 1u) {
                                                                                        phi_2327_ = vec3<f32>(_e2162, _e2158, _e2160);
                                                                                    } else {
                                                                                        phi_2327_ = (_e2156 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                                    }
                                                                                    let _e2170 = phi_2327_;
                                                                                    phi_2328_ = _e2170;
                                                                                }
                                                                                let _e2172 = phi_2328_;
                                                                                let _e2174 = triangles.member[(0u + _e1967)].v1_;
                                                                                let _e2176 = triangles.member[(0u + _e1967)].v0_;
                                                                                let _e2179 = (_e2174.x - _e2176.x);
                                                                                let _e2182 = (_e2174.y - _e2176.y);
                                                                                let _e2185 = (_e2174.z - _e2176.z);
                                                                                if (_e1357 == 0u) {
                                                                                    phi_2354_ = vec3<f32>(_e2182, _e2185, _e2179);
                                                                                } else {
                                                                                    if (_e1357 == 1u) {
                                                                                        phi_2353_ = vec3<f32>(_e2185, _e2179, _e2182);
                                                                                    } else {
                                                                                        phi_2353_ = (_e2174 - _e2176);
                                                                                    }
                                                                                    let _e2192 = phi_2353_;
                                                                                    phi_2354_ = _e2192;
                                                                                }
                                                                                let _e2194 = phi_2354_;
                                                                                let _e2196 = triangles.member[(0u + _e1967)].v2_;
                                                                                let _e2198 = triangles.member[(0u + _e1967)].v0_;
                                                                                let _e2201 = (_e2196.x - _e2198.x);
                                                                                let _e2204 = (_e2196.y - _e2198.y);
                                                                                let _e2207 = (_e2196.z - _e2198.z);
                                                                                if (_e1357 == 0u) {
                                                                                    phi_2380_ = vec3<f32>(_e2204, _e2207, _e2201);
                                                                                } else {
                                                                                    if (_e1357 == 1u) {
                                                                                        phi_2379_ = vec3<f32>(_e2207, _e2201, _e2204);
                                                                                    } else {
                                                                                        phi_2379_ = (_e2196 - _e2198);
                                                                                    }
                                                                                    let _e2214 = phi_2379_;
                                                                                    phi_2380_ = _e2214;
                                                                                }
                                                                                let _e2216 = phi_2380_;
                                                                                let _e2223 = ((_e2194.y * _e2216.z) - (_e2194.z * _e2216.y));
                                                                                let _e2230 = ((_e2194.z * _e2216.x) - (_e2194.x * _e2216.z));
                                                                                let _e2237 = ((_e2194.x * _e2216.y) - (_e2194.y * _e2216.x));
                                                                                let _e2251 = (((1f / _e1365.z) * (((_e2223 * _e2172.x) + (_e2230 * _e2172.y)) + (_e2237 * _e2172.z))) / (((_e2223 * _e1368) + (_e2230 * _e1371)) + _e2237));
                                                                                if (_e2251 > 0f) {
                                                                                    if (_e2251 < _e207) {
                                                                                        let _e2255 = triangles.member[(0u + _e1967)].v0_;
                                                                                        let _e2257 = triangles.member[(0u + _e1967)].v1_;
                                                                                        if (_e2255.x < _e2257.x) {
                                                                                            phi_2436_ = _e2255.x;
                                                                                        } else {
                                                                                            phi_2436_ = _e2257.x;
                                                                                        }
                                                                                        let _e2264 = phi_2436_;
                                                                                        if (_e2255.y < _e2257.y) {
                                                                                            phi_2445_ = _e2255.y;
                                                                                        } else {
                                                                                            phi_2445_ = _e2257.y;
                                                                                        }
                                                                                        let _e2271 = phi_2445_;
                                                                                        if (_e2255.z < _e2257.z) {
                                                                                            phi_2454_ = _e2255.z;
                                                                                        } else {
                                                                                            phi_2454_ = _e2257.z;
                                                                                        }
                                                                                        let _e2278 = phi_2454_;
                                                                                        let _e2280 = triangles.member[(0u + _e1967)].v2_;
                                                                                        if (_e2264 < _e2280.x) {
                                                                                            phi_2463_ = _e2264;
                                                                                        } else {
                                                                                            phi_2463_ = _e2280.x;
                                                                                        }
                                                                                        let _e2285 = phi_2463_;
                                                                                        if (_e2271 < _e2280.y) {
                                                                                            phi_2470_ = _e2271;
                                                                                        } else {
                                                                                            phi_2470_ = _e2280.y;
                                                                                        }
                                                                                        let _e2290 = phi_2470_;
                                                                                        if (_e2278 < _e2280.z) {
                                                                                            phi_2477_ = _e2278;
                                                                                        } else {
                                                                                            phi_2477_ = _e2280.z;
                                                                                        }
                                                                                        let _e2295 = phi_2477_;
                                                                                        let _e2297 = triangles.member[(0u + _e1967)].v0_;
                                                                                        let _e2299 = triangles.member[(0u + _e1967)].v1_;
                                                                                        if (_e2297.x > _e2299.x) {
                                                                                            phi_2490_ = _e2297.x;
                                                                                        } else {
                                                                                            phi_2490_ = _e2299.x;
                                                                                        }
                                                                                        let _e2306 = phi_2490_;
                                                                                        if (_e2297.y > _e2299.y) {
                                                                                            phi_2499_ = _e2297.y;
                                                                                        } else {
                                                                                            phi_2499_ = _e2299.y;
                                                                                        }
                                                                                        let _e2313 = phi_2499_;
                                                                                        if (_e2297.z > _e2299.z) {
                                                                                            phi_2508_ = _e2297.z;
                                                                                        } else {
                                                                                            phi_2508_ = _e2299.z;
                                                                                        }
                                                                                        let _e2320 = phi_2508_;
                                                                                        let _e2322 = triangles.member[(0u + _e1967)].v2_;
                                                                                        if (_e2306 > _e2322.x) {
                                                                                            phi_2517_ = _e2306;
                                                                                        } else {
                                                                                            phi_2517_ = _e2322.x;
                                                                                        }
                                                                                        let _e2327 = phi_2517_;
                                                                                        if (_e2313 > _e2322.y) {
                                                                                            phi_2524_ = _e2313;
                                                                                        } else {
                                                                                            phi_2524_ = _e2322.y;
                                                                                        }
                                                                                        let _e2332 = phi_2524_;
                                                                                        if (_e2320 > _e2322.z) {
                                                                                            phi_2531_ = _e2320;
                                                                                        } else {
                                                                                            phi_2531_ = _e2322.z;
                                                                                        }
                                                                                        let _e2337 = phi_2531_;
                                                                                        let _e2341 = ((_e2285 - _e1077) * _e1286);
                                                                                        let _e2342 = ((_e2290 - _e1090) * _e1296);
                                                                                        let _e2343 = ((_e2295 - _e1103) * _e1306);
                                                                                        let _e2347 = ((_e2327 - _e1077) * _e1286);
                                                                                        let _e2348 = ((_e2332 - _e1090) * _e1296);
                                                                                        let _e2349 = ((_e2337 - _e1103) * _e1306);
                                                                                        if (_e2341 < _e2347) {
                                                                                            phi_2548_ = _e2341;
                                                                                        } else {
                                                                                            phi_2548_ = _e2347;
                                                                                        }
                                                                                        let _e2352 = phi_2548_;
                                                                                        if (_e2342 < _e2348) {
                                                                                            phi_2553_ = _e2342;
                                                                                        } else {
                                                                                            phi_2553_ = _e2348;
                                                                                        }
                                                                                        let _e2355 = phi_2553_;
                                                                                        if (_e2343 < _e2349) {
                                                                                            phi_2558_ = _e2343;
                                                                                        } else {
                                                                                            phi_2558_ = _e2349;
                                                                                        }
                                                                                        let _e2358 = phi_2558_;
                                                                                        if (_e2341 > _e2347) {
                                                                                            phi_2566_ = _e2341;
                                                                                        } else {
                                                                                            phi_2566_ = _e2347;
                                                                                        }
                                                                                        let _e2364 = phi_2566_;
                                                                                        if (_e2342 > _e2348) {
                                                                                            phi_2571_ = _e2342;
                                                                                        } else {
                                                                                            phi_2571_ = _e2348;
                                                                                        }
                                                                                        let _e2367 = phi_2571_;
                                                                                        if (_e2343 > _e2349) {
                                                                                            phi_2576_ = _e2343;
                                                                                        } else {
                                                                                            phi_2576_ = _e2349;
                                                                                        }
                                                                                        let _e2370 = phi_2576_;
                                                                                        let _e2374 = core_intrinsics_maximum_number_nsz_f32_((_e2352 - _e1341), (_e2355 - _e1342));
                                                                                        let _e2375 = core_intrinsics_maximum_number_nsz_f32_(_e2374, (_e2358 - _e1343));
                                                                                        let _e2376 = core_intrinsics_minimum_number_nsz_f32_((_e2364 + _e1341), (_e2367 + _e1342));
                                                                                        let _e2377 = core_intrinsics_minimum_number_nsz_f32_(_e2376, (_e2370 + _e1343));
                                                                                        if (_e2375 > _e1058) {
                                                                                            phi_2588_ = _e2375;
                                                                                        } else {
                                                                                            phi_2588_ = _e1058;
                                                                                        }
                                                                                        let _e2380 = phi_2588_;
                                                                                        if (_e2377 < _e1060) {
                                                                                            phi_2593_ = _e2377;
                                                                                        } else {
                                                                                            phi_2593_ = _e1060;
                                                                                        }
                                                                                        let _e2383 = phi_2593_;
                                                                                        if (_e2251 < _e2380) {
                                                                                            phi_2598_ = _e2380;
                                                                                        } else {
                                                                                            phi_2598_ = _e2251;
                                                                                        }
                                                                                        let _e2386 = phi_2598_;
                                                                                        if (_e2386 > _e2383) {
                                                                                            phi_2603_ = _e2383;
                                                                                        } else {
                                                                                            phi_2603_ = _e2386;
                                                                                        }
                                                                                        let _e2389 = phi_2603_;
                                                                                        phi_2608_ = lt_bvh_triangle_Intersection(_e2389, (_e2092 / _e2151), (_e2113 / _e2151), (_e2380 <= _e2383));
                                                                                        phi_2609_ = false;
                                                                                    } else {
                                                                                        phi_2608_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2609_ = true;
                                                                                    }
                                                                                    let _e2395 = phi_2608_;
                                                                                    let _e2397 = phi_2609_;
                                                                                    phi_2610_ = _e2395;
                                                                                    phi_2611_ = _e2397;
                                                                                } else {
                                                                                    phi_2610_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2611_ = true;
                                                                                }
                                                                                let _e2399 = phi_2610_;
                                                                                let _e2401 = phi_2611_;
                                                                                if _e2401 {
                                                                                }
                                                                                phi_2615_ = _e2399;
                                                                                phi_2616_ = _e2401;
                                                                            }
                                                                            let _e2403 = phi_2615_;
                                                                            let _e2405 = phi_2616_;
                                                                            phi_2617_ = _e2403;
                                                                            phi_2618_ = _e2154;
                                                                            phi_2619_ = _e2405;
                                                                        } else {
                                                                            phi_2617_ = lt_bvh_triangle_Intersection();
                                                                            phi_2618_ = true;
                                                                            phi_2619_ = false;
                                                                        }
                                                                        let _e2407 = phi_2617_;
                                                                        let _e2409 = phi_2618_;
                                                                        let _e2411 = phi_2619_;
                                                                        if _e2409 {
                                                                            phi_2623_ = true;
                                                                        } else {
                                                                            phi_2623_ = _e2411;
                                                                        }
                                                                        let _e2413 = phi_2623_;
                                                                        if _e2413 {
                                                                            phi_2627_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2627_ = _e2407;
                                                                        }
                                                                        let _e2415 = phi_2627_;
                                                                        if _e2415.is_hit {
                                                                            if (_e2415.t > 0f) {
                                                                                if (_e2415.t < _e207) {
                                                                                    let _e2422 = triangles.member[(0u + _e1967)].i0_;
                                                                                    let _e2424 = ((_e2422 & 2147483648u) == 0u);
                                                                                    if _e2424 {
                                                                                        phi_2653_ = false;
                                                                                        phi_2654_ = false;
                                                                                    } else {
                                                                                        if true {
                                                                                            phi_2652_ = false;
                                                                                        } else {
                                                                                            phi_2652_ = true;
                                                                                        }
                                                                                        let _e2426 = phi_2652_;
                                                                                        phi_2653_ = _e2426;
                                                                                        phi_2654_ = true;
                                                                                    }
                                                                                    let _e2428 = phi_2653_;
                                                                                    let _e2430 = phi_2654_;
                                                                                    phi_2655_ = _e2428;
                                                                                    phi_2656_ = _e2424;
                                                                                    phi_2657_ = _e2430;
                                                                                } else {
                                                                                    phi_2655_ = true;
                                                                                    phi_2656_ = false;
                                                                                    phi_2657_ = false;
                                                                                }
                                                                                let _e2432 = phi_2655_;
                                                                                let _e2434 = phi_2656_;
                                                                                let _e2436 = phi_2657_;
                                                                                phi_2658_ = _e2432;
                                                                                phi_2659_ = _e2434;
                                                                                phi_2660_ = _e2436;
                                                                            } else {
                                                                                phi_2658_ = true;
                                                                                phi_2659_ = false;
                                                                                phi_2660_ = false;
                                                                            }
                                                                            let _e2438 = phi_2658_;
                                                                            let _e2440 = phi_2659_;
                                                                            let _e2442 = phi_2660_;
                                                                            phi_2661_ = _e2438;
                                                                            phi_2662_ = _e2440;
                                                                            phi_2663_ = _e2442;
                                                                        } else {
                                                                            phi_2661_ = true;
                                                                            phi_2662_ = false;
                                                                            phi_2663_ = false;
                                                                        }
                                                                        let _e2444 = phi_2661_;
                                                                        let _e2446 = phi_2662_;
                                                                        let _e2448 = phi_2663_;
                                                                        if _e2444 {
                                                                            phi_2667_ = false;
                                                                            phi_2668_ = false;
                                                                        } else {
                                                                            phi_2667_ = _e2446;
                                                                            phi_2668_ = _e2448;
                                                                        }
                                                                        let _e2450 = phi_2667_;
                                                                        let _e2452 = phi_2668_;
                                                                        phi_2059_ = (_e1958 & (_e1958 - 1u));
                                                                        phi_2669_ = _e2444;
                                                                        phi_2670_ = _e2450;
                                                                        phi_2671_ = _e2452;
                                                                    }
                                                                    let _e2454 = phi_2059_;
                                                                    let _e2456 = phi_2669_;
                                                                    let _e2458 = phi_2670_;
                                                                    let _e2460 = phi_2671_;
                                                                    local_13 = _e2458;
                                                                    local_14 = _e2460;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2058_ = _e2454;
                                                                        break if !(_e2456);
                                                                    }
                                                                }
                                                                let _e2463 = local_9;
                                                                if _e2463 {
                                                                    let _e2465 = local.group_mask;
                                                                    if ((_e2465 & 4278190080u) == 0u) {
                                                                        let _e2469 = local.len;
                                                                        if (_e2469 == 0u) {
                                                                            phi_2713_ = false;
                                                                        } else {
                                                                            let _e2473 = local.len;
                                                                            local.len = (_e2473 - 1u);
                                                                            let _e2476 = local.len;
                                                                            if (_e2476 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2481 = local.first[(0u + _e2476)];
                                                                            local.group = _e2481;
                                                                            let _e2484 = local.len;
                                                                            if (_e2484 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2489 = local.mask[(0u + _e2484)];
                                                                            local.group_mask = _e2489;
                                                                            phi_2713_ = true;
                                                                        }
                                                                        let _e2492 = phi_2713_;
                                                                        phi_2714_ = _e2492;
                                                                    } else {
                                                                        phi_2714_ = true;
                                                                    }
                                                                    let _e2494 = phi_2714_;
                                                                    if _e2494 {
                                                                        let _e2496 = local.group_mask;
                                                                        let _e2502 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2496)), 32u, (_e2496 == 0u)));
                                                                        let _e2506 = local.group_mask;
                                                                        let _e2520 = local.group_mask;
                                                                        local.group_mask = (_e2520 & ~((1u << bitcast<u32>((_e2502 & 31u)))));
                                                                        let _e2523 = local.group;
                                                                        phi_2745_ = (_e2523 + countOneBits(((_e2506 & ~((4294967295u << bitcast<u32>((((_e2502 - 24u) ^ _e1384) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2745_ = 4294967295u;
                                                                    }
                                                                    let _e2526 = phi_2745_;
                                                                    phi_2746_ = _e2526;
                                                                    phi_2747_ = false;
                                                                    phi_2748_ = false;
                                                                } else {
                                                                    phi_2746_ = u32();
                                                                    let _e2913 = local_13;
                                                                    phi_2747_ = _e2913;
                                                                    let _e2916 = local_14;
                                                                    phi_2748_ = _e2916;
                                                                }
                                                                let _e2528 = phi_2746_;
                                                                let _e2530 = phi_2747_;
                                                                let _e2532 = phi_2748_;
                                                                phi_1729_ = _e2528;
                                                                let _e2920 = local_15;
                                                                phi_2749_ = _e2920;
                                                                phi_2750_ = false;
                                                                phi_2751_ = _e2530;
                                                                phi_2752_ = _e2532;
                                                            } else {
                                                                phi_1729_ = u32();
                                                                phi_2749_ = false;
                                                                phi_2750_ = true;
                                                                phi_2751_ = false;
                                                                phi_2752_ = false;
                                                            }
                                                            let _e2534 = phi_1729_;
                                                            let _e2536 = phi_2749_;
                                                            let _e2538 = phi_2750_;
                                                            let _e2540 = phi_2751_;
                                                            let _e2542 = phi_2752_;
                                                            local_10 = _e2538;
                                                            local_16 = _e2540;
                                                            local_17 = _e2542;
                                                            continue;
                                                            continuing {
                                                                phi_1728_ = _e2534;
                                                                break if !(_e2536);
                                                            }
                                                        }
                                                        let _e2545 = local_10;
                                                        if _e2545 {
                                                            phi_2756_ = false;
                                                            phi_2757_ = false;
                                                        } else {
                                                            let _e2927 = local_16;
                                                            phi_2756_ = _e2927;
                                                            let _e2930 = local_17;
                                                            phi_2757_ = _e2930;
                                                        }
                                                        let _e2547 = phi_2756_;
                                                        let _e2549 = phi_2757_;
                                                        if _e2547 {
                                                            phi_2761_ = true;
                                                        } else {
                                                            phi_2761_ = _e2549;
                                                        }
                                                        let _e2551 = phi_2761_;
                                                        if _e2551 {
                                                            phi_2765_ = true;
                                                        } else {
                                                            phi_2765_ = false;
                                                        }
                                                        let _e2553 = phi_2765_;
                                                        phi_2766_ = _e2553;
                                                    }
                                                    let _e2555 = phi_2766_;
                                                    phi_2767_ = _e2555;
                                                    phi_2768_ = _e1210;
                                                } else {
                                                    phi_2767_ = bool();
                                                    phi_2768_ = true;
                                                }
                                                let _e2557 = phi_2767_;
                                                let _e2559 = phi_2768_;
                                                if _e2559 {
                                                    phi_2772_ = false;
                                                } else {
                                                    phi_2772_ = _e2557;
                                                }
                                                let _e2561 = phi_2772_;
                                                if _e2561 {
                                                    phi_2776_ = false;
                                                } else {
                                                    phi_2776_ = true;
                                                }
                                                let _e2563 = phi_2776_;
                                                phi_2777_ = _e2563;
                                            } else {
                                                phi_2777_ = true;
                                            }
                                            let _e2565 = phi_2777_;
                                            phi_2778_ = _e2565;
                                        } else {
                                            phi_2778_ = true;
                                        }
                                        let _e2567 = phi_2778_;
                                        phi_2779_ = _e2567;
                                    } else {
                                        phi_2779_ = true;
                                    }
                                    let _e2569 = phi_2779_;
                                    if _e2569 {
                                    }
                                    phi_1123_ = (_e997 & (_e997 - 1u));
                                    phi_2783_ = _e2569;
                                }
                                let _e2571 = phi_1123_;
                                let _e2573 = phi_2783_;
                                continue;
                                continuing {
                                    phi_1122_ = _e2571;
                                    break if !(_e2573);
                                }
                            }
                            let _e2576 = local_11;
                            if _e2576 {
                                let _e2578 = local_1.group_mask;
                                if ((_e2578 & 4278190080u) == 0u) {
                                    let _e2582 = local_1.len;
                                    if (_e2582 == 0u) {
                                        phi_2825_ = false;
                                    } else {
                                        let _e2586 = local_1.len;
                                        local_1.len = (_e2586 - 1u);
                                        let _e2589 = local_1.len;
                                        if (_e2589 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2594 = local_1.first[(0u + _e2589)];
                                        local_1.group = _e2594;
                                        let _e2597 = local_1.len;
                                        if (_e2597 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2602 = local_1.mask[(0u + _e2597)];
                                        local_1.group_mask = _e2602;
                                        phi_2825_ = true;
                                    }
                                    let _e2605 = phi_2825_;
                                    phi_2826_ = _e2605;
                                } else {
                                    phi_2826_ = true;
                                }
                                let _e2607 = phi_2826_;
                                if _e2607 {
                                    let _e2609 = local_1.group_mask;
                                    let _e2615 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2609)), 32u, (_e2609 == 0u)));
                                    let _e2619 = local_1.group_mask;
                                    let _e2633 = local_1.group_mask;
                                    local_1.group_mask = (_e2633 & ~((1u << bitcast<u32>((_e2615 & 31u)))));
                                    let _e2636 = local_1.group;
                                    phi_2857_ = (_e2636 + countOneBits(((_e2619 & ~((4294967295u << bitcast<u32>((((_e2615 - 24u) ^ _e423) & 31u))))) & 255u)));
                                } else {
                                    phi_2857_ = 4294967295u;
                                }
                                let _e2639 = phi_2857_;
                                phi_2858_ = _e2639;
                            } else {
                                phi_2858_ = u32();
                            }
                            let _e2641 = phi_2858_;
                            phi_793_ = _e2641;
                            let _e2951 = local_18;
                            phi_2859_ = _e2951;
                            phi_2860_ = false;
                        } else {
                            phi_793_ = u32();
                            phi_2859_ = false;
                            phi_2860_ = true;
                        }
                        let _e2643 = phi_793_;
                        let _e2645 = phi_2859_;
                        let _e2647 = phi_2860_;
                        local_12 = _e2647;
                        continue;
                        continuing {
                            phi_792_ = _e2643;
                            break if !(_e2645);
                        }
                    }
                    let _e2650 = local_12;
                    if _e2650 {
                        phi_2864_ = false;
                    } else {
                        phi_2864_ = true;
                    }
                    let _e2652 = phi_2864_;
                    if _e2652 {
                        phi_2868_ = true;
                    } else {
                        phi_2868_ = false;
                    }
                    let _e2654 = phi_2868_;
                    phi_2869_ = _e2654;
                }
                let _e2656 = phi_2869_;
                phi_2870_ = _e2656;
                phi_2871_ = _e279;
            } else {
                phi_2870_ = bool();
                phi_2871_ = true;
            }
            let _e2658 = phi_2870_;
            let _e2660 = phi_2871_;
            if _e2660 {
                phi_2875_ = false;
            } else {
                phi_2875_ = _e2658;
            }
            let _e2662 = phi_2875_;
            if _e2662 {
                phi_2879_ = 0f;
            } else {
                phi_2879_ = 1f;
            }
            let _e2664 = phi_2879_;
            phi_2880_ = _e2664;
        }
        let _e2666 = phi_2880_;
        if (_e79.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.first_primitive)] = _e2666;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
