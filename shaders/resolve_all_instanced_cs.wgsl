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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
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
    var phi_2135_: vec3<f32>;
    var phi_2136_: vec3<f32>;
    var phi_2167_: vec3<f32>;
    var phi_2168_: vec3<f32>;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2193_: f32;
    var phi_2194_: f32;
    var phi_2195_: f32;
    var phi_2196_: f32;
    var phi_2204_: f32;
    var phi_2214_: bool;
    var phi_2215_: bool;
    var phi_2219_: f32;
    var phi_2220_: f32;
    var phi_2221_: f32;
    var phi_2222_: f32;
    var phi_2230_: f32;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2245_: f32;
    var phi_2246_: f32;
    var phi_2247_: f32;
    var phi_2248_: f32;
    var phi_2256_: f32;
    var phi_2271_: f32;
    var phi_2272_: bool;
    var phi_2273_: f32;
    var phi_2274_: bool;
    var phi_2275_: f32;
    var phi_2276_: bool;
    var phi_2294_: f32;
    var phi_2295_: bool;
    var phi_2296_: bool;
    var phi_2297_: f32;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var phi_2303_: bool;
    var phi_2304_: f32;
    var phi_2305_: bool;
    var phi_2339_: f32;
    var phi_2348_: f32;
    var phi_2357_: f32;
    var phi_2366_: f32;
    var phi_2373_: f32;
    var phi_2380_: f32;
    var phi_2393_: f32;
    var phi_2402_: f32;
    var phi_2411_: f32;
    var phi_2420_: f32;
    var phi_2427_: f32;
    var phi_2434_: f32;
    var phi_2451_: f32;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2469_: f32;
    var phi_2474_: f32;
    var phi_2479_: f32;
    var phi_2491_: f32;
    var phi_2496_: f32;
    var phi_2501_: f32;
    var phi_2506_: f32;
    var phi_2511_: lt_bvh_triangle_Intersection;
    var phi_2512_: bool;
    var phi_2513_: lt_bvh_triangle_Intersection;
    var phi_2514_: bool;
    var phi_2518_: lt_bvh_triangle_Intersection;
    var phi_2519_: bool;
    var phi_2520_: lt_bvh_triangle_Intersection;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2526_: bool;
    var phi_2530_: lt_bvh_triangle_Intersection;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2564_: bool;
    var phi_2565_: bool;
    var phi_2566_: bool;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2059_: u32;
    var phi_2572_: bool;
    var phi_2573_: bool;
    var phi_2574_: bool;
    var local_9: bool;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2648_: u32;
    var phi_2649_: u32;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_1729_: u32;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var local_10: bool;
    var phi_2659_: bool;
    var phi_2660_: bool;
    var phi_2664_: bool;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2675_: bool;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_1123_: u32;
    var phi_2686_: bool;
    var local_11: bool;
    var phi_2728_: bool;
    var phi_2729_: bool;
    var phi_2760_: u32;
    var phi_2761_: u32;
    var phi_793_: u32;
    var phi_2762_: bool;
    var phi_2763_: bool;
    var local_12: bool;
    var phi_2767_: bool;
    var phi_2771_: bool;
    var phi_2772_: bool;
    var phi_2773_: bool;
    var phi_2774_: bool;
    var phi_2778_: bool;
    var phi_2782_: f32;
    var phi_2783_: f32;
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
            phi_2783_ = _e176.unnamed.visibility;
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
                    phi_2772_ = bool();
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
                                    phi_2686_ = false;
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
                                                        phi_2669_ = bool();
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
                                                        let _e1373 = (1f / _e1365.z);
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
                                                                        phi_2572_ = false;
                                                                        phi_2573_ = false;
                                                                        phi_2574_ = false;
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
                                                                        let _e2002 = triangles.member[(0u + _e1967)].v1_;
                                                                        let _e2004 = (_e2002.x - _e1077);
                                                                        let _e2006 = (_e2002.y - _e1090);
                                                                        let _e2008 = (_e2002.z - _e1103);
                                                                        if (_e1357 == 0u) {
                                                                            phi_2136_ = vec3<f32>(_e2006, _e2008, _e2004);
                                                                        } else {
                                                                            if (_e1357 == 1u) {
                                                                                phi_2135_ = vec3<f32>(_e2008, _e2004, _e2006);
                                                                            } else {
                                                                                phi_2135_ = (_e2002 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                            }
                                                                            let _e2016 = phi_2135_;
                                                                            phi_2136_ = _e2016;
                                                                        }
                                                                        let _e2018 = phi_2136_;
                                                                        let _e2022 = (_e2018.x - (_e1368 * _e2018.z));
                                                                        let _e2026 = (_e2018.y - (_e1371 * _e2018.z));
                                                                        let _e2030 = triangles.member[(0u + _e1967)].v2_;
                                                                        let _e2032 = (_e2030.x - _e1077);
                                                                        let _e2034 = (_e2030.y - _e1090);
                                                                        let _e2036 = (_e2030.z - _e1103);
                                                                        if (_e1357 == 0u) {
                                                                            phi_2168_ = vec3<f32>(_e2034, _e2036, _e2032);
                                                                        } else {
                                                                            if (_e1357 == 1u) {
                                                                                phi_2167_ = vec3<f32>(_e2036, _e2032, _e2034);
                                                                            } else {
                                                                                phi_2167_ = (_e2030 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                            }
                                                                            let _e2044 = phi_2167_;
                                                                            phi_2168_ = _e2044;
                                                                        }
                                                                        let _e2046 = phi_2168_;
                                                                        let _e2050 = (_e2046.x - (_e1368 * _e2046.z));
                                                                        let _e2054 = (_e2046.y - (_e1371 * _e2046.z));
                                                                        if (_e2022 < _e2050) {
                                                                            phi_2189_ = true;
                                                                        } else {
                                                                            if (_e2022 == _e2050) {
                                                                                phi_2188_ = (_e2026 < _e2054);
                                                                            } else {
                                                                                phi_2188_ = false;
                                                                            }
                                                                            let _e2061 = phi_2188_;
                                                                            phi_2189_ = _e2061;
                                                                        }
                                                                        let _e2063 = phi_2189_;
                                                                        if _e2063 {
                                                                            phi_2193_ = _e2054;
                                                                            phi_2194_ = _e2050;
                                                                            phi_2195_ = _e2026;
                                                                            phi_2196_ = _e2022;
                                                                        } else {
                                                                            phi_2193_ = _e2026;
                                                                            phi_2194_ = _e2022;
                                                                            phi_2195_ = _e2054;
                                                                            phi_2196_ = _e2050;
                                                                        }
                                                                        let _e2065 = phi_2193_;
                                                                        let _e2067 = phi_2194_;
                                                                        let _e2069 = phi_2195_;
                                                                        let _e2071 = phi_2196_;
                                                                        let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                        if _e2063 {
                                                                            phi_2204_ = -(_e2074);
                                                                        } else {
                                                                            phi_2204_ = _e2074;
                                                                        }
                                                                        let _e2077 = phi_2204_;
                                                                        if (_e2050 < _e1994) {
                                                                            phi_2215_ = true;
                                                                        } else {
                                                                            if (_e2050 == _e1994) {
                                                                                phi_2214_ = (_e2054 < _e1998);
                                                                            } else {
                                                                                phi_2214_ = false;
                                                                            }
                                                                            let _e2082 = phi_2214_;
                                                                            phi_2215_ = _e2082;
                                                                        }
                                                                        let _e2084 = phi_2215_;
                                                                        if _e2084 {
                                                                            phi_2219_ = _e1998;
                                                                            phi_2220_ = _e1994;
                                                                            phi_2221_ = _e2054;
                                                                            phi_2222_ = _e2050;
                                                                        } else {
                                                                            phi_2219_ = _e2054;
                                                                            phi_2220_ = _e2050;
                                                                            phi_2221_ = _e1998;
                                                                            phi_2222_ = _e1994;
                                                                        }
                                                                        let _e2086 = phi_2219_;
                                                                        let _e2088 = phi_2220_;
                                                                        let _e2090 = phi_2221_;
                                                                        let _e2092 = phi_2222_;
                                                                        let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                        if _e2084 {
                                                                            phi_2230_ = -(_e2095);
                                                                        } else {
                                                                            phi_2230_ = _e2095;
                                                                        }
                                                                        let _e2098 = phi_2230_;
                                                                        if (_e1994 < _e2022) {
                                                                            phi_2241_ = true;
                                                                        } else {
                                                                            if (_e1994 == _e2022) {
                                                                                phi_2240_ = (_e1998 < _e2026);
                                                                            } else {
                                                                                phi_2240_ = false;
                                                                            }
                                                                            let _e2103 = phi_2240_;
                                                                            phi_2241_ = _e2103;
                                                                        }
                                                                        let _e2105 = phi_2241_;
                                                                        if _e2105 {
                                                                            phi_2245_ = _e2026;
                                                                            phi_2246_ = _e2022;
                                                                            phi_2247_ = _e1998;
                                                                            phi_2248_ = _e1994;
                                                                        } else {
                                                                            phi_2245_ = _e1998;
                                                                            phi_2246_ = _e1994;
                                                                            phi_2247_ = _e2026;
                                                                            phi_2248_ = _e2022;
                                                                        }
                                                                        let _e2107 = phi_2245_;
                                                                        let _e2109 = phi_2246_;
                                                                        let _e2111 = phi_2247_;
                                                                        let _e2113 = phi_2248_;
                                                                        let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                        if _e2105 {
                                                                            phi_2256_ = -(_e2116);
                                                                        } else {
                                                                            phi_2256_ = _e2116;
                                                                        }
                                                                        let _e2119 = phi_2256_;
                                                                        if (_e2077 >= 0f) {
                                                                            if (_e2098 >= 0f) {
                                                                                if (_e2119 >= 0f) {
                                                                                    phi_2271_ = ((_e2077 + _e2098) + _e2119);
                                                                                    phi_2272_ = false;
                                                                                } else {
                                                                                    phi_2271_ = f32();
                                                                                    phi_2272_ = true;
                                                                                }
                                                                                let _e2126 = phi_2271_;
                                                                                let _e2128 = phi_2272_;
                                                                                phi_2273_ = _e2126;
                                                                                phi_2274_ = _e2128;
                                                                            } else {
                                                                                phi_2273_ = f32();
                                                                                phi_2274_ = true;
                                                                            }
                                                                            let _e2130 = phi_2273_;
                                                                            let _e2132 = phi_2274_;
                                                                            phi_2275_ = _e2130;
                                                                            phi_2276_ = _e2132;
                                                                        } else {
                                                                            phi_2275_ = f32();
                                                                            phi_2276_ = true;
                                                                        }
                                                                        let _e2134 = phi_2275_;
                                                                        let _e2136 = phi_2276_;
                                                                        if _e2136 {
                                                                            if (_e2077 <= 0f) {
                                                                                if (_e2098 <= 0f) {
                                                                                    let _e2139 = (_e2119 <= 0f);
                                                                                    if _e2139 {
                                                                                    }
                                                                                    phi_2294_ = ((_e2077 + _e2098) + _e2119);
                                                                                    phi_2295_ = false;
                                                                                    phi_2296_ = _e2139;
                                                                                } else {
                                                                                    phi_2294_ = f32();
                                                                                    phi_2295_ = true;
                                                                                    phi_2296_ = false;
                                                                                }
                                                                                let _e2143 = phi_2294_;
                                                                                let _e2145 = phi_2295_;
                                                                                let _e2147 = phi_2296_;
                                                                                phi_2297_ = _e2143;
                                                                                phi_2298_ = _e2145;
                                                                                phi_2299_ = _e2147;
                                                                            } else {
                                                                                phi_2297_ = f32();
                                                                                phi_2298_ = true;
                                                                                phi_2299_ = false;
                                                                            }
                                                                            let _e2149 = phi_2297_;
                                                                            let _e2151 = phi_2298_;
                                                                            let _e2153 = phi_2299_;
                                                                            if _e2151 {
                                                                                phi_2303_ = false;
                                                                            } else {
                                                                                phi_2303_ = _e2153;
                                                                            }
                                                                            let _e2155 = phi_2303_;
                                                                            phi_2304_ = _e2149;
                                                                            phi_2305_ = _e2155;
                                                                        } else {
                                                                            phi_2304_ = _e2134;
                                                                            phi_2305_ = true;
                                                                        }
                                                                        let _e2157 = phi_2304_;
                                                                        let _e2159 = phi_2305_;
                                                                        if _e2159 {
                                                                            let _e2160 = (_e2157 == 0f);
                                                                            if _e2160 {
                                                                                phi_2518_ = lt_bvh_triangle_Intersection();
                                                                                phi_2519_ = false;
                                                                            } else {
                                                                                let _e2166 = ((((_e2077 * (_e1373 * _e1990.z)) + (_e2098 * (_e1373 * _e2018.z))) + (_e2119 * (_e1373 * _e2046.z))) / _e2157);
                                                                                if (_e2166 > 0f) {
                                                                                    if (_e2166 < _e207) {
                                                                                        let _e2170 = triangles.member[(0u + _e1967)].v0_;
                                                                                        let _e2172 = triangles.member[(0u + _e1967)].v1_;
                                                                                        if (_e2170.x < _e2172.x) {
                                                                                            phi_2339_ = _e2170.x;
                                                                                        } else {
                                                                                            phi_2339_ = _e2172.x;
                                                                                        }
                                                                                        let _e2179 = phi_2339_;
                                                                                        if (_e2170.y < _e2172.y) {
                                                                                            phi_2348_ = _e2170.y;
                                                                                        } else {
                                                                                            phi_2348_ = _e2172.y;
                                                                                        }
                                                                                        let _e2186 = phi_2348_;
                                                                                        if (_e2170.z < _e2172.z) {
                                                                                            phi_2357_ = _e2170.z;
                                                                                        } else {
                                                                                            phi_2357_ = _e2172.z;
                                                                                        }
                                                                                        let _e2193 = phi_2357_;
                                                                                        let _e2195 = triangles.member[(0u + _e1967)].v2_;
                                                                                        if (_e2179 < _e2195.x) {
                                                                                            phi_2366_ = _e2179;
                                                                                        } else {
                                                                                            phi_2366_ = _e2195.x;
                                                                                        }
                                                                                        let _e2200 = phi_2366_;
                                                                                        if (_e2186 < _e2195.y) {
                                                                                            phi_2373_ = _e2186;
                                                                                        } else {
                                                                                            phi_2373_ = _e2195.y;
                                                                                        }
                                                                                        let _e2205 = phi_2373_;
                                                                                        if (_e2193 < _e2195.z) {
                                                                                            phi_2380_ = _e2193;
                                                                                        } else {
                                                                                            phi_2380_ = _e2195.z;
                                                                                        }
                                                                                        let _e2210 = phi_2380_;
                                                                                        let _e2212 = triangles.member[(0u + _e1967)].v0_;
                                                                                        let _e2214 = triangles.member[(0u + _e1967)].v1_;
                                                                                        if (_e2212.x > _e2214.x) {
                                                                                            phi_2393_ = _e2212.x;
                                                                                        } else {
                                                                                            phi_2393_ = _e2214.x;
                                                                                        }
                                                                                        let _e2221 = phi_2393_;
                                                                                        if (_e2212.y > _e2214.y) {
                                                                                            phi_2402_ = _e2212.y;
                                                                                        } else {
                                                                                            phi_2402_ = _e2214.y;
                                                                                        }
                                                                                        let _e2228 = phi_2402_;
                                                                                        if (_e2212.z > _e2214.z) {
                                                                                            phi_2411_ = _e2212.z;
                                                                                        } else {
                                                                                            phi_2411_ = _e2214.z;
                                                                                        }
                                                                                        let _e2235 = phi_2411_;
                                                                                        let _e2237 = triangles.member[(0u + _e1967)].v2_;
                                                                                        if (_e2221 > _e2237.x) {
                                                                                            phi_2420_ = _e2221;
                                                                                        } else {
                                                                                            phi_2420_ = _e2237.x;
                                                                                        }
                                                                                        let _e2242 = phi_2420_;
                                                                                        if (_e2228 > _e2237.y) {
                                                                                            phi_2427_ = _e2228;
                                                                                        } else {
                                                                                            phi_2427_ = _e2237.y;
                                                                                        }
                                                                                        let _e2247 = phi_2427_;
                                                                                        if (_e2235 > _e2237.z) {
                                                                                            phi_2434_ = _e2235;
                                                                                        } else {
                                                                                            phi_2434_ = _e2237.z;
                                                                                        }
                                                                                        let _e2252 = phi_2434_;
                                                                                        let _e2256 = ((_e2200 - _e1077) * _e1286);
                                                                                        let _e2257 = ((_e2205 - _e1090) * _e1296);
                                                                                        let _e2258 = ((_e2210 - _e1103) * _e1306);
                                                                                        let _e2262 = ((_e2242 - _e1077) * _e1286);
                                                                                        let _e2263 = ((_e2247 - _e1090) * _e1296);
                                                                                        let _e2264 = ((_e2252 - _e1103) * _e1306);
                                                                                        if (_e2256 < _e2262) {
                                                                                            phi_2451_ = _e2256;
                                                                                        } else {
                                                                                            phi_2451_ = _e2262;
                                                                                        }
                                                                                        let _e2267 = phi_2451_;
                                                                                        if (_e2257 < _e2263) {
                                                                                            phi_2456_ = _e2257;
                                                                                        } else {
                                                                                            phi_2456_ = _e2263;
                                                                                        }
                                                                                        let _e2270 = phi_2456_;
                                                                                        if (_e2258 < _e2264) {
                                                                                            phi_2461_ = _e2258;
                                                                                        } else {
                                                                                            phi_2461_ = _e2264;
                                                                                        }
                                                                                        let _e2273 = phi_2461_;
                                                                                        if (_e2256 > _e2262) {
                                                                                            phi_2469_ = _e2256;
                                                                                        } else {
                                                                                            phi_2469_ = _e2262;
                                                                                        }
                                                                                        let _e2279 = phi_2469_;
                                                                                        if (_e2257 > _e2263) {
                                                                                            phi_2474_ = _e2257;
                                                                                        } else {
                                                                                            phi_2474_ = _e2263;
                                                                                        }
                                                                                        let _e2282 = phi_2474_;
                                                                                        if (_e2258 > _e2264) {
                                                                                            phi_2479_ = _e2258;
                                                                                        } else {
                                                                                            phi_2479_ = _e2264;
                                                                                        }
                                                                                        let _e2285 = phi_2479_;
                                                                                        let _e2289 = core_intrinsics_maximum_number_nsz_f32_((_e2267 - _e1341), (_e2270 - _e1342));
                                                                                        let _e2290 = core_intrinsics_maximum_number_nsz_f32_(_e2289, (_e2273 - _e1343));
                                                                                        let _e2291 = core_intrinsics_minimum_number_nsz_f32_((_e2279 + _e1341), (_e2282 + _e1342));
                                                                                        let _e2292 = core_intrinsics_minimum_number_nsz_f32_(_e2291, (_e2285 + _e1343));
                                                                                        if (_e2290 > _e1058) {
                                                                                            phi_2491_ = _e2290;
                                                                                        } else {
                                                                                            phi_2491_ = _e1058;
                                                                                        }
                                                                                        let _e2295 = phi_2491_;
                                                                                        if (_e2292 < _e1060) {
                                                                                            phi_2496_ = _e2292;
                                                                                        } else {
                                                                                            phi_2496_ = _e1060;
                                                                                        }
                                                                                        let _e2298 = phi_2496_;
                                                                                        if (_e2166 < _e2295) {
                                                                                            phi_2501_ = _e2295;
                                                                                        } else {
                                                                                            phi_2501_ = _e2166;
                                                                                        }
                                                                                        let _e2301 = phi_2501_;
                                                                                        if (_e2301 > _e2298) {
                                                                                            phi_2506_ = _e2298;
                                                                                        } else {
                                                                                            phi_2506_ = _e2301;
                                                                                        }
                                                                                        let _e2304 = phi_2506_;
                                                                                        phi_2511_ = lt_bvh_triangle_Intersection(_e2304, (_e2098 / _e2157), (_e2119 / _e2157), (_e2295 <= _e2298));
                                                                                        phi_2512_ = false;
                                                                                    } else {
                                                                                        phi_2511_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2512_ = true;
                                                                                    }
                                                                                    let _e2310 = phi_2511_;
                                                                                    let _e2312 = phi_2512_;
                                                                                    phi_2513_ = _e2310;
                                                                                    phi_2514_ = _e2312;
                                                                                } else {
                                                                                    phi_2513_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2514_ = true;
                                                                                }
                                                                                let _e2314 = phi_2513_;
                                                                                let _e2316 = phi_2514_;
                                                                                if _e2316 {
                                                                                }
                                                                                phi_2518_ = _e2314;
                                                                                phi_2519_ = _e2316;
                                                                            }
                                                                            let _e2318 = phi_2518_;
                                                                            let _e2320 = phi_2519_;
                                                                            phi_2520_ = _e2318;
                                                                            phi_2521_ = _e2160;
                                                                            phi_2522_ = _e2320;
                                                                        } else {
                                                                            phi_2520_ = lt_bvh_triangle_Intersection();
                                                                            phi_2521_ = true;
                                                                            phi_2522_ = false;
                                                                        }
                                                                        let _e2322 = phi_2520_;
                                                                        let _e2324 = phi_2521_;
                                                                        let _e2326 = phi_2522_;
                                                                        if _e2324 {
                                                                            phi_2526_ = true;
                                                                        } else {
                                                                            phi_2526_ = _e2326;
                                                                        }
                                                                        let _e2328 = phi_2526_;
                                                                        if _e2328 {
                                                                            phi_2530_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2530_ = _e2322;
                                                                        }
                                                                        let _e2330 = phi_2530_;
                                                                        if _e2330.is_hit {
                                                                            if (_e2330.t > 0f) {
                                                                                if (_e2330.t < _e207) {
                                                                                    let _e2337 = triangles.member[(0u + _e1967)].i0_;
                                                                                    let _e2339 = ((_e2337 & 2147483648u) == 0u);
                                                                                    if _e2339 {
                                                                                        phi_2556_ = false;
                                                                                        phi_2557_ = false;
                                                                                    } else {
                                                                                        if true {
                                                                                            phi_2555_ = false;
                                                                                        } else {
                                                                                            phi_2555_ = true;
                                                                                        }
                                                                                        let _e2341 = phi_2555_;
                                                                                        phi_2556_ = _e2341;
                                                                                        phi_2557_ = true;
                                                                                    }
                                                                                    let _e2343 = phi_2556_;
                                                                                    let _e2345 = phi_2557_;
                                                                                    phi_2558_ = _e2343;
                                                                                    phi_2559_ = _e2339;
                                                                                    phi_2560_ = _e2345;
                                                                                } else {
                                                                                    phi_2558_ = true;
                                                                                    phi_2559_ = false;
                                                                                    phi_2560_ = false;
                                                                                }
                                                                                let _e2347 = phi_2558_;
                                                                                let _e2349 = phi_2559_;
                                                                                let _e2351 = phi_2560_;
                                                                                phi_2561_ = _e2347;
                                                                                phi_2562_ = _e2349;
                                                                                phi_2563_ = _e2351;
                                                                            } else {
                                                                                phi_2561_ = true;
                                                                                phi_2562_ = false;
                                                                                phi_2563_ = false;
                                                                            }
                                                                            let _e2353 = phi_2561_;
                                                                            let _e2355 = phi_2562_;
                                                                            let _e2357 = phi_2563_;
                                                                            phi_2564_ = _e2353;
                                                                            phi_2565_ = _e2355;
                                                                            phi_2566_ = _e2357;
                                                                        } else {
                                                                            phi_2564_ = true;
                                                                            phi_2565_ = false;
                                                                            phi_2566_ = false;
                                                                        }
                                                                        let _e2359 = phi_2564_;
                                                                        let _e2361 = phi_2565_;
                                                                        let _e2363 = phi_2566_;
                                                                        if _e2359 {
                                                                            phi_2570_ = false;
                                                                            phi_2571_ = false;
                                                                        } else {
                                                                            phi_2570_ = _e2361;
                                                                            phi_2571_ = _e2363;
                                                                        }
                                                                        let _e2365 = phi_2570_;
                                                                        let _e2367 = phi_2571_;
                                                                        phi_2059_ = (_e1958 & (_e1958 - 1u));
                                                                        phi_2572_ = _e2359;
                                                                        phi_2573_ = _e2365;
                                                                        phi_2574_ = _e2367;
                                                                    }
                                                                    let _e2369 = phi_2059_;
                                                                    let _e2371 = phi_2572_;
                                                                    let _e2373 = phi_2573_;
                                                                    let _e2375 = phi_2574_;
                                                                    local_13 = _e2373;
                                                                    local_14 = _e2375;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2058_ = _e2369;
                                                                        break if !(_e2371);
                                                                    }
                                                                }
                                                                let _e2378 = local_9;
                                                                if _e2378 {
                                                                    let _e2380 = local.group_mask;
                                                                    if ((_e2380 & 4278190080u) == 0u) {
                                                                        let _e2384 = local.len;
                                                                        if (_e2384 == 0u) {
                                                                            phi_2616_ = false;
                                                                        } else {
                                                                            let _e2388 = local.len;
                                                                            local.len = (_e2388 - 1u);
                                                                            let _e2391 = local.len;
                                                                            if (_e2391 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2396 = local.first[(0u + _e2391)];
                                                                            local.group = _e2396;
                                                                            let _e2399 = local.len;
                                                                            if (_e2399 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2404 = local.mask[(0u + _e2399)];
                                                                            local.group_mask = _e2404;
                                                                            phi_2616_ = true;
                                                                        }
                                                                        let _e2407 = phi_2616_;
                                                                        phi_2617_ = _e2407;
                                                                    } else {
                                                                        phi_2617_ = true;
                                                                    }
                                                                    let _e2409 = phi_2617_;
                                                                    if _e2409 {
                                                                        let _e2411 = local.group_mask;
                                                                        let _e2417 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2411)), 32u, (_e2411 == 0u)));
                                                                        let _e2421 = local.group_mask;
                                                                        let _e2435 = local.group_mask;
                                                                        local.group_mask = (_e2435 & ~((1u << bitcast<u32>((_e2417 & 31u)))));
                                                                        let _e2438 = local.group;
                                                                        phi_2648_ = (_e2438 + countOneBits(((_e2421 & ~((4294967295u << bitcast<u32>((((_e2417 - 24u) ^ _e1384) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2648_ = 4294967295u;
                                                                    }
                                                                    let _e2441 = phi_2648_;
                                                                    phi_2649_ = _e2441;
                                                                    phi_2650_ = false;
                                                                    phi_2651_ = false;
                                                                } else {
                                                                    phi_2649_ = u32();
                                                                    let _e2822 = local_13;
                                                                    phi_2650_ = _e2822;
                                                                    let _e2825 = local_14;
                                                                    phi_2651_ = _e2825;
                                                                }
                                                                let _e2443 = phi_2649_;
                                                                let _e2445 = phi_2650_;
                                                                let _e2447 = phi_2651_;
                                                                phi_1729_ = _e2443;
                                                                let _e2829 = local_15;
                                                                phi_2652_ = _e2829;
                                                                phi_2653_ = false;
                                                                phi_2654_ = _e2445;
                                                                phi_2655_ = _e2447;
                                                            } else {
                                                                phi_1729_ = u32();
                                                                phi_2652_ = false;
                                                                phi_2653_ = true;
                                                                phi_2654_ = false;
                                                                phi_2655_ = false;
                                                            }
                                                            let _e2449 = phi_1729_;
                                                            let _e2451 = phi_2652_;
                                                            let _e2453 = phi_2653_;
                                                            let _e2455 = phi_2654_;
                                                            let _e2457 = phi_2655_;
                                                            local_10 = _e2453;
                                                            local_16 = _e2455;
                                                            local_17 = _e2457;
                                                            continue;
                                                            continuing {
                                                                phi_1728_ = _e2449;
                                                                break if !(_e2451);
                                                            }
                                                        }
                                                        let _e2460 = local_10;
                                                        if _e2460 {
                                                            phi_2659_ = false;
                                                            phi_2660_ = false;
                                                        } else {
                                                            let _e2836 = local_16;
                                                            phi_2659_ = _e2836;
                                                            let _e2839 = local_17;
                                                            phi_2660_ = _e2839;
                                                        }
                                                        let _e2462 = phi_2659_;
                                                        let _e2464 = phi_2660_;
                                                        if _e2462 {
                                                            phi_2664_ = true;
                                                        } else {
                                                            phi_2664_ = _e2464;
                                                        }
                                                        let _e2466 = phi_2664_;
                                                        if _e2466 {
                                                            phi_2668_ = true;
                                                        } else {
                                                            phi_2668_ = false;
                                                        }
                                                        let _e2468 = phi_2668_;
                                                        phi_2669_ = _e2468;
                                                    }
                                                    let _e2470 = phi_2669_;
                                                    phi_2670_ = _e2470;
                                                    phi_2671_ = _e1210;
                                                } else {
                                                    phi_2670_ = bool();
                                                    phi_2671_ = true;
                                                }
                                                let _e2472 = phi_2670_;
                                                let _e2474 = phi_2671_;
                                                if _e2474 {
                                                    phi_2675_ = false;
                                                } else {
                                                    phi_2675_ = _e2472;
                                                }
                                                let _e2476 = phi_2675_;
                                                if _e2476 {
                                                    phi_2679_ = false;
                                                } else {
                                                    phi_2679_ = true;
                                                }
                                                let _e2478 = phi_2679_;
                                                phi_2680_ = _e2478;
                                            } else {
                                                phi_2680_ = true;
                                            }
                                            let _e2480 = phi_2680_;
                                            phi_2681_ = _e2480;
                                        } else {
                                            phi_2681_ = true;
                                        }
                                        let _e2482 = phi_2681_;
                                        phi_2682_ = _e2482;
                                    } else {
                                        phi_2682_ = true;
                                    }
                                    let _e2484 = phi_2682_;
                                    if _e2484 {
                                    }
                                    phi_1123_ = (_e997 & (_e997 - 1u));
                                    phi_2686_ = _e2484;
                                }
                                let _e2486 = phi_1123_;
                                let _e2488 = phi_2686_;
                                continue;
                                continuing {
                                    phi_1122_ = _e2486;
                                    break if !(_e2488);
                                }
                            }
                            let _e2491 = local_11;
                            if _e2491 {
                                let _e2493 = local_1.group_mask;
                                if ((_e2493 & 4278190080u) == 0u) {
                                    let _e2497 = local_1.len;
                                    if (_e2497 == 0u) {
                                        phi_2728_ = false;
                                    } else {
                                        let _e2501 = local_1.len;
                                        local_1.len = (_e2501 - 1u);
                                        let _e2504 = local_1.len;
                                        if (_e2504 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2509 = local_1.first[(0u + _e2504)];
                                        local_1.group = _e2509;
                                        let _e2512 = local_1.len;
                                        if (_e2512 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2517 = local_1.mask[(0u + _e2512)];
                                        local_1.group_mask = _e2517;
                                        phi_2728_ = true;
                                    }
                                    let _e2520 = phi_2728_;
                                    phi_2729_ = _e2520;
                                } else {
                                    phi_2729_ = true;
                                }
                                let _e2522 = phi_2729_;
                                if _e2522 {
                                    let _e2524 = local_1.group_mask;
                                    let _e2530 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2524)), 32u, (_e2524 == 0u)));
                                    let _e2534 = local_1.group_mask;
                                    let _e2548 = local_1.group_mask;
                                    local_1.group_mask = (_e2548 & ~((1u << bitcast<u32>((_e2530 & 31u)))));
                                    let _e2551 = local_1.group;
                                    phi_2760_ = (_e2551 + countOneBits(((_e2534 & ~((4294967295u << bitcast<u32>((((_e2530 - 24u) ^ _e423) & 31u))))) & 255u)));
                                } else {
                                    phi_2760_ = 4294967295u;
                                }
                                let _e2554 = phi_2760_;
                                phi_2761_ = _e2554;
                            } else {
                                phi_2761_ = u32();
                            }
                            let _e2556 = phi_2761_;
                            phi_793_ = _e2556;
                            let _e2860 = local_18;
                            phi_2762_ = _e2860;
                            phi_2763_ = false;
                        } else {
                            phi_793_ = u32();
                            phi_2762_ = false;
                            phi_2763_ = true;
                        }
                        let _e2558 = phi_793_;
                        let _e2560 = phi_2762_;
                        let _e2562 = phi_2763_;
                        local_12 = _e2562;
                        continue;
                        continuing {
                            phi_792_ = _e2558;
                            break if !(_e2560);
                        }
                    }
                    let _e2565 = local_12;
                    if _e2565 {
                        phi_2767_ = false;
                    } else {
                        phi_2767_ = true;
                    }
                    let _e2567 = phi_2767_;
                    if _e2567 {
                        phi_2771_ = true;
                    } else {
                        phi_2771_ = false;
                    }
                    let _e2569 = phi_2771_;
                    phi_2772_ = _e2569;
                }
                let _e2571 = phi_2772_;
                phi_2773_ = _e2571;
                phi_2774_ = _e279;
            } else {
                phi_2773_ = bool();
                phi_2774_ = true;
            }
            let _e2573 = phi_2773_;
            let _e2575 = phi_2774_;
            if _e2575 {
                phi_2778_ = false;
            } else {
                phi_2778_ = _e2573;
            }
            let _e2577 = phi_2778_;
            if _e2577 {
                phi_2782_ = 0f;
            } else {
                phi_2782_ = 1f;
            }
            let _e2579 = phi_2782_;
            phi_2783_ = _e2579;
        }
        let _e2581 = phi_2783_;
        if (_e79.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.first_primitive)] = _e2581;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
