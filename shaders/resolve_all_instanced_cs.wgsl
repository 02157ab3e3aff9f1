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
    unnamed: lt_bvh_traverse_Tree,
    unnamed_1: lt_bvh_traverse_Tree,
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

struct type_49 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> nodes: type_35;
@group(0) @binding(3) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage> instances: type_49;

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
    var phi_795_: bool;
    var phi_875_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_902_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_929_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_935_: u32;
    var phi_938_: u32;
    var phi_952_: u32;
    var phi_962_: u32;
    var phi_972_: u32;
    var phi_990_: u32;
    var phi_1000_: u32;
    var phi_1010_: u32;
    var phi_1046_: u32;
    var phi_1059_: u32;
    var phi_1064_: u32;
    var phi_1065_: u32;
    var phi_1066_: u32;
    var phi_936_: u32;
    var phi_939_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1124_: u32;
    var phi_1127_: bool;
    var phi_1176_: f32;
    var phi_1181_: f32;
    var phi_1186_: f32;
    var phi_1194_: f32;
    var phi_1199_: f32;
    var phi_1204_: f32;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
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
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1371_: bool;
    var phi_1375_: bool;
    var phi_1379_: bool;
    var phi_1449_: f32;
    var phi_1456_: f32;
    var phi_1463_: f32;
    var phi_1470_: f32;
    var phi_1477_: f32;
    var phi_1484_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1539_: bool;
    var phi_1540_: bool;
    var phi_1548_: u32;
    var phi_1549_: u32;
    var phi_1560_: vec3<f32>;
    var phi_1561_: vec3<f32>;
    var phi_1574_: u32;
    var phi_1579_: u32;
    var phi_1584_: u32;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var phi_1730_: u32;
    var phi_1732_: u32;
    var phi_1735_: bool;
    var phi_1815_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1842_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1869_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1875_: u32;
    var phi_1878_: u32;
    var phi_1892_: u32;
    var phi_1902_: u32;
    var phi_1912_: u32;
    var phi_1930_: u32;
    var phi_1940_: u32;
    var phi_1950_: u32;
    var phi_1986_: u32;
    var phi_1999_: u32;
    var phi_2004_: u32;
    var phi_2005_: u32;
    var phi_2006_: u32;
    var phi_1876_: u32;
    var phi_1879_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2064_: u32;
    var phi_2067_: bool;
    var phi_2111_: vec3<f32>;
    var phi_2112_: vec3<f32>;
    var phi_2141_: vec3<f32>;
    var phi_2142_: vec3<f32>;
    var phi_2171_: vec3<f32>;
    var phi_2172_: vec3<f32>;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2195_: f32;
    var phi_2196_: f32;
    var phi_2197_: f32;
    var phi_2198_: f32;
    var phi_2206_: f32;
    var phi_2216_: bool;
    var phi_2217_: bool;
    var phi_2221_: f32;
    var phi_2222_: f32;
    var phi_2223_: f32;
    var phi_2224_: f32;
    var phi_2232_: f32;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2247_: f32;
    var phi_2248_: f32;
    var phi_2249_: f32;
    var phi_2250_: f32;
    var phi_2258_: f32;
    var phi_2273_: f32;
    var phi_2274_: bool;
    var phi_2275_: f32;
    var phi_2276_: bool;
    var phi_2277_: f32;
    var phi_2278_: bool;
    var phi_2296_: f32;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2299_: f32;
    var phi_2300_: bool;
    var phi_2301_: bool;
    var phi_2305_: bool;
    var phi_2306_: f32;
    var phi_2307_: bool;
    var phi_2335_: vec3<f32>;
    var phi_2336_: vec3<f32>;
    var phi_2361_: vec3<f32>;
    var phi_2362_: vec3<f32>;
    var phi_2387_: vec3<f32>;
    var phi_2388_: vec3<f32>;
    var phi_2444_: f32;
    var phi_2453_: f32;
    var phi_2462_: f32;
    var phi_2471_: f32;
    var phi_2478_: f32;
    var phi_2485_: f32;
    var phi_2498_: f32;
    var phi_2507_: f32;
    var phi_2516_: f32;
    var phi_2525_: f32;
    var phi_2532_: f32;
    var phi_2539_: f32;
    var phi_2556_: f32;
    var phi_2561_: f32;
    var phi_2566_: f32;
    var phi_2574_: f32;
    var phi_2579_: f32;
    var phi_2584_: f32;
    var phi_2596_: f32;
    var phi_2601_: f32;
    var phi_2606_: f32;
    var phi_2611_: f32;
    var phi_2616_: lt_bvh_triangle_Intersection;
    var phi_2617_: bool;
    var phi_2618_: lt_bvh_triangle_Intersection;
    var phi_2619_: bool;
    var phi_2623_: lt_bvh_triangle_Intersection;
    var phi_2624_: bool;
    var phi_2625_: lt_bvh_triangle_Intersection;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2631_: bool;
    var phi_2635_: lt_bvh_triangle_Intersection;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2660_: bool;
    var phi_2661_: bool;
    var phi_2065_: u32;
    var phi_2068_: bool;
    var phi_2665_: bool;
    var local_9: bool;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2739_: u32;
    var phi_2740_: u32;
    var phi_1733_: u32;
    var phi_1736_: bool;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var local_10: bool;
    var phi_2746_: bool;
    var phi_2750_: bool;
    var phi_2751_: bool;
    var phi_2752_: bool;
    var phi_2753_: bool;
    var phi_2757_: bool;
    var phi_2761_: bool;
    var phi_2762_: bool;
    var phi_2763_: bool;
    var phi_2764_: bool;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_1125_: u32;
    var phi_1128_: bool;
    var phi_2771_: bool;
    var local_11: bool;
    var phi_2813_: bool;
    var phi_2814_: bool;
    var phi_2845_: u32;
    var phi_2846_: u32;
    var phi_793_: u32;
    var phi_796_: bool;
    var phi_2847_: bool;
    var phi_2848_: bool;
    var local_12: bool;
    var phi_2852_: bool;
    var phi_2856_: bool;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var phi_2862_: bool;
    var phi_2863_: bool;
    var phi_2867_: bool;
    var phi_2871_: f32;
    var phi_2872_: f32;
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
            phi_2872_ = _e176.unnamed.visibility;
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
                    phi_2856_ = false;
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
                    phi_795_ = false;
                    loop {
                        let _e561 = phi_792_;
                        let _e563 = phi_795_;
                        if (_e561 != 4294967295u) {
                            if (_e561 < _e64) {
                            } else {
                                return;
                            }
                            let _e570 = nodes.member[(0u + _e561)].frame[3u];
                            let _e595 = (bitcast<f32>((((_e570 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e355);
                            let _e596 = (bitcast<f32>((((_e570 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e365);
                            let _e597 = (bitcast<f32>((((_e570 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e375);
                            let _e600 = nodes.member[(0u + _e561)].frame[0u];
                            let _e604 = nodes.member[(0u + _e561)].frame[1u];
                            let _e608 = nodes.member[(0u + _e561)].frame[2u];
                            let _e613 = ((bitcast<f32>(_e600) - _e199) * _e355);
                            let _e614 = ((bitcast<f32>(_e604) - _e201) * _e365);
                            let _e615 = ((bitcast<f32>(_e608) - _e203) * _e375);
                            let _e623 = nodes.member[(0u + _e561)].x;
                            if (_e355 < 0f) {
                                let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e634.unnamed.root, _e623.w), _e634.unnamed_1);
                                let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_bvh_traverse_Tree(_e623.x, _e640.unnamed_1.first_primitive));
                                phi_875_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e646.unnamed_1.root, _e623.y));
                            } else {
                                let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e623.y), _e662.unnamed_1);
                                let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e623.z, _e668.unnamed_1.first_primitive));
                                phi_875_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e623.w));
                            }
                            let _e682 = phi_875_;
                            let _e692 = nodes.member[(0u + _e561)].y;
                            if (_e365 < 0f) {
                                let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e703.unnamed.root, _e692.w), _e703.unnamed_1);
                                let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e692.x, _e709.unnamed_1.first_primitive));
                                phi_902_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e715.unnamed_1.root, _e692.y));
                            } else {
                                let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e692.y), _e731.unnamed_1);
                                let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e692.z, _e737.unnamed_1.first_primitive));
                                phi_902_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e692.w));
                            }
                            let _e751 = phi_902_;
                            let _e761 = nodes.member[(0u + _e561)].z;
                            if (_e375 < 0f) {
                                let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e761.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e772.unnamed.root, _e761.w), _e772.unnamed_1);
                                let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e778.unnamed, lt_bvh_traverse_Tree(_e761.x, _e778.unnamed_1.first_primitive));
                                phi_929_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_bvh_traverse_Tree(_e784.unnamed_1.root, _e761.y));
                            } else {
                                let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e761.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e800.unnamed.root, _e761.y), _e800.unnamed_1);
                                let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_bvh_traverse_Tree(_e761.z, _e806.unnamed_1.first_primitive));
                                phi_929_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e812.unnamed, lt_bvh_traverse_Tree(_e812.unnamed_1.root, _e761.w));
                            }
                            let _e820 = phi_929_;
                            phi_935_ = 0u;
                            phi_938_ = 0u;
                            loop {
                                let _e830 = phi_935_;
                                let _e832 = phi_938_;
                                local_3 = _e832;
                                local_4 = _e832;
                                local_5 = _e832;
                                let _e833 = (_e830 < 8u);
                                if _e833 {
                                    let _e835 = (_e830 >> bitcast<u32>(2i));
                                    let _e836 = (_e830 & 3u);
                                    if (_e835 == 0u) {
                                        phi_952_ = _e682.unnamed.root;
                                    } else {
                                        phi_952_ = _e682.unnamed.first_primitive;
                                    }
                                    let _e839 = phi_952_;
                                    if (_e835 == 0u) {
                                        phi_962_ = _e751.unnamed.root;
                                    } else {
                                        phi_962_ = _e751.unnamed.first_primitive;
                                    }
                                    let _e848 = phi_962_;
                                    if (_e835 == 0u) {
                                        phi_972_ = _e820.unnamed.root;
                                    } else {
                                        phi_972_ = _e820.unnamed.first_primitive;
                                    }
                                    let _e857 = phi_972_;
                                    let _e870 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e839 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e595) + (_e613 - _e403)), ((f32(((_e848 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e596) + (_e614 - _e404)));
                                    let _e871 = core_intrinsics_maximum_number_nsz_f32_(_e870, ((f32(((_e857 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e597) + (_e615 - _e405)));
                                    if (_e835 == 0u) {
                                        phi_990_ = _e682.unnamed_1.root;
                                    } else {
                                        phi_990_ = _e682.unnamed_1.first_primitive;
                                    }
                                    let _e874 = phi_990_;
                                    if (_e835 == 0u) {
                                        phi_1000_ = _e751.unnamed_1.root;
                                    } else {
                                        phi_1000_ = _e751.unnamed_1.first_primitive;
                                    }
                                    let _e883 = phi_1000_;
                                    if (_e835 == 0u) {
                                        phi_1010_ = _e820.unnamed_1.root;
                                    } else {
                                        phi_1010_ = _e820.unnamed_1.first_primitive;
                                    }
                                    let _e892 = phi_1010_;
                                    let _e905 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e874 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e595) + (_e613 + _e403)), ((f32(((_e883 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e596) + (_e614 + _e404)));
                                    let _e906 = core_intrinsics_minimum_number_nsz_f32_(_e905, ((f32(((_e892 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e597) + (_e615 + _e405)));
                                    if (_e871 <= _e906) {
                                        if (_e871 <= _e207) {
                                            if (_e906 >= 0f) {
                                                if (_e835 == 0u) {
                                                    let _e913 = nodes.member[(0u + _e561)].links[2u];
                                                    phi_1046_ = _e913;
                                                } else {
                                                    let _e916 = nodes.member[(0u + _e561)].links[3u];
                                                    phi_1046_ = _e916;
                                                }
                                                let _e918 = phi_1046_;
                                                let _e923 = ((_e918 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u);
                                                let _e924 = (_e923 & 31u);
                                                if (_e924 >= 24u) {
                                                    phi_1059_ = (24u + ((_e924 - 24u) ^ _e423));
                                                } else {
                                                    phi_1059_ = _e924;
                                                }
                                                let _e930 = phi_1059_;
                                                phi_1064_ = (_e832 | ((_e923 >> bitcast<u32>(5i)) << bitcast<u32>((_e930 & 31u))));
                                            } else {
                                                phi_1064_ = _e832;
                                            }
                                            let _e938 = phi_1064_;
                                            phi_1065_ = _e938;
                                        } else {
                                            phi_1065_ = _e832;
                                        }
                                        let _e940 = phi_1065_;
                                        phi_1066_ = _e940;
                                    } else {
                                        phi_1066_ = _e832;
                                    }
                                    let _e942 = phi_1066_;
                                    phi_936_ = (_e830 + 1u);
                                    phi_939_ = _e942;
                                } else {
                                    phi_936_ = u32();
                                    phi_939_ = u32();
                                }
                                let _e945 = phi_936_;
                                let _e947 = phi_939_;
                                continue;
                                continuing {
                                    phi_935_ = _e945;
                                    phi_938_ = _e947;
                                    break if !(_e833);
                                }
                            }
                            let _e951 = nodes.member[(0u + _e561)].links[0u];
                            let _e955 = nodes.member[(0u + _e561)].frame[3u];
                            let _e959 = local_3;
                            if ((_e959 & 4278190080u) == 0u) {
                            } else {
                                let _e963 = local_1.group_mask;
                                if ((_e963 & 4278190080u) == 0u) {
                                } else {
                                    let _e967 = local_1.len;
                                    if (_e967 < 32u) {
                                        let _e970 = local_1.group;
                                        let _e972 = local_1.len;
                                        if (_e972 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e972)] = _e970;
                                        let _e978 = local_1.group_mask;
                                        let _e980 = local_1.len;
                                        if (_e980 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e980)] = _e978;
                                        let _e987 = local_1.len;
                                        local_1.len = (_e987 + 1u);
                                    }
                                }
                                local_1.group = (_e181 + _e951);
                                let _e991 = local_4;
                                local_1.group_mask = ((_e991 & 4278190080u) | (_e955 >> bitcast<u32>(24i)));
                            }
                            let _e996 = local_5;
                            phi_1124_ = (_e996 & 16777215u);
                            phi_1127_ = _e563;
                            loop {
                                let _e999 = phi_1124_;
                                let _e1001 = phi_1127_;
                                local_16 = _e1001;
                                let _e1002 = (_e999 == 0u);
                                local_11 = _e1002;
                                local_17 = _e1002;
                                if _e1002 {
                                    phi_1125_ = u32();
                                    phi_1128_ = bool();
                                    phi_2771_ = false;
                                } else {
                                    let _e1005 = nodes.member[(0u + _e561)].links[1u];
                                    let _e1009 = (_e1005 + select(firstTrailingBit(_e999), 32u, (_e999 == 0u)));
                                    if (_e1009 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1016 = instances.member[(0u + _e1009)].low_world;
                                    let _e1018 = instances.member[(0u + _e1009)].high_world;
                                    let _e1025 = ((_e1016.x - _e199) * _e355);
                                    let _e1026 = ((_e1016.y - _e201) * _e365);
                                    let _e1027 = ((_e1016.z - _e203) * _e375);
                                    let _e1034 = ((_e1018.x - _e199) * _e355);
                                    let _e1035 = ((_e1018.y - _e201) * _e365);
                                    let _e1036 = ((_e1018.z - _e203) * _e375);
                                    if (_e1025 < _e1034) {
                                        phi_1176_ = _e1025;
                                    } else {
                                        phi_1176_ = _e1034;
                                    }
                                    let _e1039 = phi_1176_;
                                    if (_e1026 < _e1035) {
                                        phi_1181_ = _e1026;
                                    } else {
                                        phi_1181_ = _e1035;
                                    }
                                    let _e1042 = phi_1181_;
                                    if (_e1027 < _e1036) {
                                        phi_1186_ = _e1027;
                                    } else {
                                        phi_1186_ = _e1036;
                                    }
                                    let _e1045 = phi_1186_;
                                    if (_e1025 > _e1034) {
                                        phi_1194_ = _e1025;
                                    } else {
                                        phi_1194_ = _e1034;
                                    }
                                    let _e1051 = phi_1194_;
                                    if (_e1026 > _e1035) {
                                        phi_1199_ = _e1026;
                                    } else {
                                        phi_1199_ = _e1035;
                                    }
                                    let _e1054 = phi_1199_;
                                    if (_e1027 > _e1036) {
                                        phi_1204_ = _e1027;
                                    } else {
                                        phi_1204_ = _e1036;
                                    }
                                    let _e1057 = phi_1204_;
                                    let _e1061 = core_intrinsics_maximum_number_nsz_f32_((_e1039 - _e410), (_e1042 - _e411));
                                    let _e1062 = core_intrinsics_maximum_number_nsz_f32_(_e1061, (_e1045 - _e412));
                                    let _e1063 = core_intrinsics_minimum_number_nsz_f32_((_e1051 + _e410), (_e1054 + _e411));
                                    let _e1064 = core_intrinsics_minimum_number_nsz_f32_(_e1063, (_e1057 + _e412));
                                    if (_e1062 <= _e1064) {
                                        if (_e1062 <= _e207) {
                                            if (_e1064 >= 0f) {
                                                let _e1070 = instances.member[(0u + _e1009)].world_to_object[0u];
                                                let _e1081 = ((((_e1070.x * _e199) + (_e1070.y * _e201)) + (_e1070.z * _e203)) + (_e1070.w * 1f));
                                                let _e1083 = instances.member[(0u + _e1009)].world_to_object[1u];
                                                let _e1094 = ((((_e1083.x * _e199) + (_e1083.y * _e201)) + (_e1083.z * _e203)) + (_e1083.w * 1f));
                                                let _e1096 = instances.member[(0u + _e1009)].world_to_object[2u];
                                                let _e1107 = ((((_e1096.x * _e199) + (_e1096.y * _e201)) + (_e1096.z * _e203)) + (_e1096.w * 1f));
                                                let _e1110 = instances.member[(0u + _e1009)].world_to_object[0u];
                                                let _e1121 = ((((_e1110.x * _e215) + (_e1110.y * _e216)) + (_e1110.z * _e217)) + (_e1110.w * 0f));
                                                let _e1123 = instances.member[(0u + _e1009)].world_to_object[1u];
                                                let _e1134 = ((((_e1123.x * _e215) + (_e1123.y * _e216)) + (_e1123.z * _e217)) + (_e1123.w * 0f));
                                                let _e1136 = instances.member[(0u + _e1009)].world_to_object[2u];
                                                let _e1147 = ((((_e1136.x * _e215) + (_e1136.y * _e216)) + (_e1136.z * _e217)) + (_e1136.w * 0f));
                                                let _e1150 = instances.member[(0u + _e1009)].root;
                                                let _e1152 = instances.member[(0u + _e1009)].first_triangle;
                                                let _e1156 = abs(_e1121);
                                                let _e1157 = abs(_e1134);
                                                let _e1158 = abs(_e1147);
                                                if (abs(_e1081) < 1000000000000000f) {
                                                    if (abs(_e1094) < 1000000000000000f) {
                                                        if (abs(_e1107) < 1000000000000000f) {
                                                            if (_e1156 < 1000000000000000f) {
                                                                if (_e1157 < 1000000000000000f) {
                                                                    if (_e1158 < 1000000000000000f) {
                                                                        if (_e1156 > 0f) {
                                                                            phi_1349_ = bool();
                                                                            phi_1350_ = true;
                                                                        } else {
                                                                            let _e1166 = (_e1157 > 0f);
                                                                            if _e1166 {
                                                                                phi_1348_ = bool();
                                                                            } else {
                                                                                phi_1348_ = (_e1158 > 0f);
                                                                            }
                                                                            let _e1169 = phi_1348_;
                                                                            phi_1349_ = _e1169;
                                                                            phi_1350_ = _e1166;
                                                                        }
                                                                        let _e1171 = phi_1349_;
                                                                        let _e1173 = phi_1350_;
                                                                        if _e1173 {
                                                                            phi_1354_ = true;
                                                                        } else {
                                                                            phi_1354_ = _e1171;
                                                                        }
                                                                        let _e1175 = phi_1354_;
                                                                        phi_1355_ = _e1175;
                                                                        phi_1356_ = false;
                                                                    } else {
                                                                        phi_1355_ = bool();
                                                                        phi_1356_ = true;
                                                                    }
                                                                    let _e1177 = phi_1355_;
                                                                    let _e1179 = phi_1356_;
                                                                    phi_1357_ = _e1177;
                                                                    phi_1358_ = false;
                                                                    phi_1359_ = _e1179;
                                                                } else {
                                                                    phi_1357_ = bool();
                                                                    phi_1358_ = true;
                                                                    phi_1359_ = false;
                                                                }
                                                                let _e1181 = phi_1357_;
                                                                let _e1183 = phi_1358_;
                                                                let _e1185 = phi_1359_;
                                                                phi_1360_ = _e1181;
                                                                phi_1361_ = _e1183;
                                                                phi_1362_ = _e1185;
                                                            } else {
                                                                phi_1360_ = bool();
                                                                phi_1361_ = true;
                                                                phi_1362_ = false;
                                                            }
                                                            let _e1187 = phi_1360_;
                                                            let _e1189 = phi_1361_;
                                                            let _e1191 = phi_1362_;
                                                            phi_1363_ = _e1187;
                                                            phi_1364_ = _e1189;
                                                            phi_1365_ = _e1191;
                                                        } else {
                                                            phi_1363_ = bool();
                                                            phi_1364_ = true;
                                                            phi_1365_ = false;
                                                        }
                                                        let _e1193 = phi_1363_;
                                                        let _e1195 = phi_1364_;
                                                        let _e1197 = phi_1365_;
                                                        phi_1366_ = _e1193;
                                                        phi_1367_ = _e1195;
                                                        phi_1368_ = _e1197;
                                                    } else {
                                                        phi_1366_ = bool();
                                                        phi_1367_ = true;
                                                        phi_1368_ = false;
                                                    }
                                                    let _e1199 = phi_1366_;
                                                    let _e1201 = phi_1367_;
                                                    let _e1203 = phi_1368_;
                                                    phi_1369_ = _e1199;
                                                    phi_1370_ = _e1201;
                                                    phi_1371_ = _e1203;
                                                } else {
                                                    phi_1369_ = bool();
                                                    phi_1370_ = true;
                                                    phi_1371_ = false;
                                                }
                                                let _e1205 = phi_1369_;
                                                let _e1207 = phi_1370_;
                                                let _e1209 = phi_1371_;
                                                if _e1207 {
                                                    phi_1375_ = true;
                                                } else {
                                                    phi_1375_ = _e1209;
                                                }
                                                let _e1211 = phi_1375_;
                                                if _e1211 {
                                                    phi_1379_ = false;
                                                } else {
                                                    phi_1379_ = _e1205;
                                                }
                                                let _e1213 = phi_1379_;
                                                if _e1213 {
                                                    let _e1214 = (_e1150 >= _e64);
                                                    if _e1214 {
                                                        phi_2751_ = bool();
                                                    } else {
                                                        if (_e1150 < _e64) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1220 = nodes.member[(0u + _e1150)].frame[0u];
                                                        let _e1224 = nodes.member[(0u + _e1150)].frame[1u];
                                                        let _e1228 = nodes.member[(0u + _e1150)].frame[2u];
                                                        let _e1232 = nodes.member[(0u + _e1150)].frame[0u];
                                                        let _e1236 = nodes.member[(0u + _e1150)].frame[1u];
                                                        let _e1240 = nodes.member[(0u + _e1150)].frame[2u];
                                                        let _e1244 = nodes.member[(0u + _e1150)].frame[3u];
                                                        let _e1278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1121), abs(_e1134));
                                                        let _e1279 = core_intrinsics_maximum_number_nsz_f32_(_e1278, abs(_e1147));
                                                        let _e1280 = (_e1279 * 0.0000000000009094947f);
                                                        if (abs(_e1121) < _e1280) {
                                                            phi_1449_ = _e1280;
                                                        } else {
                                                            phi_1449_ = abs(_e1121);
                                                        }
                                                        let _e1285 = phi_1449_;
                                                        if (_e1121 < 0f) {
                                                            phi_1456_ = (-1f / _e1285);
                                                        } else {
                                                            phi_1456_ = (1f / _e1285);
                                                        }
                                                        let _e1290 = phi_1456_;
                                                        if (abs(_e1134) < _e1280) {
                                                            phi_1463_ = _e1280;
                                                        } else {
                                                            phi_1463_ = abs(_e1134);
                                                        }
                                                        let _e1295 = phi_1463_;
                                                        if (_e1134 < 0f) {
                                                            phi_1470_ = (-1f / _e1295);
                                                        } else {
                                                            phi_1470_ = (1f / _e1295);
                                                        }
                                                        let _e1300 = phi_1470_;
                                                        if (abs(_e1147) < _e1280) {
                                                            phi_1477_ = _e1280;
                                                        } else {
                                                            phi_1477_ = abs(_e1147);
                                                        }
                                                        let _e1305 = phi_1477_;
                                                        if (_e1147 < 0f) {
                                                            phi_1484_ = (-1f / _e1305);
                                                        } else {
                                                            phi_1484_ = (1f / _e1305);
                                                        }
                                                        let _e1310 = phi_1484_;
                                                        let _e1314 = abs((bitcast<f32>(_e1220) - _e1081));
                                                        let _e1315 = abs((bitcast<f32>(_e1224) - _e1094));
                                                        let _e1316 = abs((bitcast<f32>(_e1228) - _e1107));
                                                        let _e1320 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1081));
                                                        let _e1321 = abs(((bitcast<f32>(_e1236) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1094));
                                                        let _e1322 = abs(((bitcast<f32>(_e1240) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1107));
                                                        if (_e1314 > _e1320) {
                                                            phi_1501_ = _e1314;
                                                        } else {
                                                            phi_1501_ = _e1320;
                                                        }
                                                        let _e1325 = phi_1501_;
                                                        if (_e1315 > _e1321) {
                                                            phi_1506_ = _e1315;
                                                        } else {
                                                            phi_1506_ = _e1321;
                                                        }
                                                        let _e1328 = phi_1506_;
                                                        if (_e1316 > _e1322) {
                                                            phi_1511_ = _e1316;
                                                        } else {
                                                            phi_1511_ = _e1322;
                                                        }
                                                        let _e1331 = phi_1511_;
                                                        let _e1332 = core_intrinsics_maximum_number_nsz_f32_(_e1325, _e1328);
                                                        let _e1333 = core_intrinsics_maximum_number_nsz_f32_(_e1332, _e1331);
                                                        let _e1337 = (_e1333 * 0.0000019073486f);
                                                        let _e1338 = (abs(_e1290) * _e1337);
                                                        let _e1339 = (abs(_e1300) * _e1337);
                                                        let _e1340 = (abs(_e1310) * _e1337);
                                                        let _e1344 = (_e1333 * 0.0000009536743f);
                                                        let _e1345 = (abs(_e1290) * _e1344);
                                                        let _e1346 = (abs(_e1300) * _e1344);
                                                        let _e1347 = (abs(_e1310) * _e1344);
                                                        let _e1348 = abs(_e1121);
                                                        let _e1349 = abs(_e1134);
                                                        let _e1350 = abs(_e1147);
                                                        if (_e1348 >= _e1349) {
                                                            if (_e1348 >= _e1350) {
                                                                phi_1539_ = false;
                                                            } else {
                                                                phi_1539_ = true;
                                                            }
                                                            let _e1354 = phi_1539_;
                                                            phi_1540_ = _e1354;
                                                        } else {
                                                            phi_1540_ = true;
                                                        }
                                                        let _e1356 = phi_1540_;
                                                        if _e1356 {
                                                            if (_e1349 >= _e1350) {
                                                                phi_1548_ = 1u;
                                                            } else {
                                                                phi_1548_ = 2u;
                                                            }
                                                            let _e1359 = phi_1548_;
                                                            phi_1549_ = _e1359;
                                                        } else {
                                                            phi_1549_ = 0u;
                                                        }
                                                        let _e1361 = phi_1549_;
                                                        if (_e1361 == 0u) {
                                                            phi_1561_ = vec3<f32>(_e1134, _e1147, _e1121);
                                                        } else {
                                                            if (_e1361 == 1u) {
                                                                phi_1560_ = vec3<f32>(_e1147, _e1121, _e1134);
                                                            } else {
                                                                phi_1560_ = vec3<f32>(_e1121, _e1134, _e1147);
                                                            }
                                                            let _e1367 = phi_1560_;
                                                            phi_1561_ = _e1367;
                                                        }
                                                        let _e1369 = phi_1561_;
                                                        let _e1372 = (_e1369.x / _e1369.z);
                                                        let _e1375 = (_e1369.y / _e1369.z);
                                                        if (_e1290 < 0f) {
                                                            phi_1574_ = 0u;
                                                        } else {
                                                            phi_1574_ = 1u;
                                                        }
                                                        let _e1380 = phi_1574_;
                                                        if (_e1300 < 0f) {
                                                            phi_1579_ = 0u;
                                                        } else {
                                                            phi_1579_ = 2u;
                                                        }
                                                        let _e1383 = phi_1579_;
                                                        if (_e1310 < 0f) {
                                                            phi_1584_ = 0u;
                                                        } else {
                                                            phi_1584_ = 4u;
                                                        }
                                                        let _e1386 = phi_1584_;
                                                        let _e1388 = ((_e1380 | _e1383) | _e1386);
                                                        let _e1389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1150, 2147483648u);
                                                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1389.first[0], _e1389.first[1], _e1389.first[2], _e1389.first[3], _e1389.first[4], _e1389.first[5], _e1389.first[6], _e1389.first[7], _e1389.first[8], _e1389.first[9], _e1389.first[10], _e1389.first[11], _e1389.first[12], _e1389.first[13], _e1389.first[14], _e1389.first[15], _e1389.first[16], _e1389.first[17], _e1389.first[18], _e1389.first[19], _e1389.first[20], _e1389.first[21], _e1389.first[22], _e1389.first[23], _e1389.first[24], _e1389.first[25], _e1389.first[26], _e1389.first[27], _e1389.first[28], _e1389.first[29], _e1389.first[30], _e1389.first[31]), array<u32, 32>(_e1389.mask[0], _e1389.mask[1], _e1389.mask[2], _e1389.mask[3], _e1389.mask[4], _e1389.mask[5], _e1389.mask[6], _e1389.mask[7], _e1389.mask[8], _e1389.mask[9], _e1389.mask[10], _e1389.mask[11], _e1389.mask[12], _e1389.mask[13], _e1389.mask[14], _e1389.mask[15], _e1389.mask[16], _e1389.mask[17], _e1389.mask[18], _e1389.mask[19], _e1389.mask[20], _e1389.mask[21], _e1389.mask[22], _e1389.mask[23], _e1389.mask[24], _e1389.mask[25], _e1389.mask[26], _e1389.mask[27], _e1389.mask[28], _e1389.mask[29], _e1389.mask[30], _e1389.mask[31]), _e1389.len, _e1389.group, _e1389.group_mask);
                                                        let _e1463 = local.group_mask;
                                                        if ((_e1463 & 4278190080u) == 0u) {
                                                            let _e1467 = local.len;
                                                            if (_e1467 == 0u) {
                                                                phi_1698_ = false;
                                                            } else {
                                                                let _e1471 = local.len;
                                                                local.len = (_e1471 - 1u);
                                                                let _e1474 = local.len;
                                                                if (_e1474 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1479 = local.first[(0u + _e1474)];
                                                                local.group = _e1479;
                                                                let _e1482 = local.len;
                                                                if (_e1482 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1487 = local.mask[(0u + _e1482)];
                                                                local.group_mask = _e1487;
                                                                phi_1698_ = true;
                                                            }
                                                            let _e1490 = phi_1698_;
                                                            phi_1699_ = _e1490;
                                                        } else {
                                                            phi_1699_ = true;
                                                        }
                                                        let _e1492 = phi_1699_;
                                                        if _e1492 {
                                                            let _e1494 = local.group_mask;
                                                            let _e1500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1494)), 32u, (_e1494 == 0u)));
                                                            let _e1504 = local.group_mask;
                                                            let _e1518 = local.group_mask;
                                                            local.group_mask = (_e1518 & ~((1u << bitcast<u32>((_e1500 & 31u)))));
                                                            let _e1521 = local.group;
                                                            phi_1730_ = (_e1521 + countOneBits(((_e1504 & ~((4294967295u << bitcast<u32>((((_e1500 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_1730_ = 4294967295u;
                                                        }
                                                        let _e1524 = phi_1730_;
                                                        phi_1732_ = _e1524;
                                                        phi_1735_ = _e1001;
                                                        loop {
                                                            let _e1526 = phi_1732_;
                                                            let _e1528 = phi_1735_;
                                                            local_15 = _e1528;
                                                            if (_e1526 != 4294967295u) {
                                                                if (_e1526 < _e64) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1535 = nodes.member[(0u + _e1526)].frame[3u];
                                                                let _e1560 = (bitcast<f32>((((_e1535 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1290);
                                                                let _e1561 = (bitcast<f32>((((_e1535 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1300);
                                                                let _e1562 = (bitcast<f32>((((_e1535 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1310);
                                                                let _e1565 = nodes.member[(0u + _e1526)].frame[0u];
                                                                let _e1569 = nodes.member[(0u + _e1526)].frame[1u];
                                                                let _e1573 = nodes.member[(0u + _e1526)].frame[2u];
                                                                let _e1578 = ((bitcast<f32>(_e1565) - _e1081) * _e1290);
                                                                let _e1579 = ((bitcast<f32>(_e1569) - _e1094) * _e1300);
                                                                let _e1580 = ((bitcast<f32>(_e1573) - _e1107) * _e1310);
                                                                let _e1588 = nodes.member[(0u + _e1526)].x;
                                                                if (_e1290 < 0f) {
                                                                    let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1588.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1599.unnamed.root, _e1588.w), _e1599.unnamed_1);
                                                                    let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1605.unnamed, lt_bvh_traverse_Tree(_e1588.x, _e1605.unnamed_1.first_primitive));
                                                                    phi_1815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1611.unnamed_1.root, _e1588.y));
                                                                } else {
                                                                    let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1588.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1627.unnamed.root, _e1588.y), _e1627.unnamed_1);
                                                                    let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1633.unnamed, lt_bvh_traverse_Tree(_e1588.z, _e1633.unnamed_1.first_primitive));
                                                                    phi_1815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_bvh_traverse_Tree(_e1639.unnamed_1.root, _e1588.w));
                                                                }
                                                                let _e1647 = phi_1815_;
                                                                let _e1657 = nodes.member[(0u + _e1526)].y;
                                                                if (_e1300 < 0f) {
                                                                    let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1657.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1668.unnamed.root, _e1657.w), _e1668.unnamed_1);
                                                                    let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1674.unnamed, lt_bvh_traverse_Tree(_e1657.x, _e1674.unnamed_1.first_primitive));
                                                                    phi_1842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1680.unnamed_1.root, _e1657.y));
                                                                } else {
                                                                    let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1657.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1696.unnamed.root, _e1657.y), _e1696.unnamed_1);
                                                                    let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1702.unnamed, lt_bvh_traverse_Tree(_e1657.z, _e1702.unnamed_1.first_primitive));
                                                                    phi_1842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_bvh_traverse_Tree(_e1708.unnamed_1.root, _e1657.w));
                                                                }
                                                                let _e1716 = phi_1842_;
                                                                let _e1726 = nodes.member[(0u + _e1526)].z;
                                                                if (_e1310 < 0f) {
                                                                    let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1726.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1737.unnamed.root, _e1726.w), _e1737.unnamed_1);
                                                                    let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1743.unnamed, lt_bvh_traverse_Tree(_e1726.x, _e1743.unnamed_1.first_primitive));
                                                                    phi_1869_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_bvh_traverse_Tree(_e1749.unnamed_1.root, _e1726.y));
                                                                } else {
                                                                    let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1726.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1765.unnamed.root, _e1726.y), _e1765.unnamed_1);
                                                                    let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1771.unnamed, lt_bvh_traverse_Tree(_e1726.z, _e1771.unnamed_1.first_primitive));
                                                                    phi_1869_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_bvh_traverse_Tree(_e1777.unnamed_1.root, _e1726.w));
                                                                }
                                                                let _e1785 = phi_1869_;
                                                                phi_1875_ = 0u;
                                                                phi_1878_ = 0u;
                                                                loop {
                                                                    let _e1795 = phi_1875_;
                                                                    let _e1797 = phi_1878_;
                                                                    local_6 = _e1797;
                                                                    local_7 = _e1797;
                                                                    local_8 = _e1797;
                                                                    let _e1798 = (_e1795 < 8u);
                                                                    if _e1798 {
                                                                        let _e1800 = (_e1795 >> bitcast<u32>(2i));
                                                                        let _e1801 = (_e1795 & 3u);
                                                                        if (_e1800 == 0u) {
                                                                            phi_1892_ = _e1647.unnamed.root;
                                                                        } else {
                                                                            phi_1892_ = _e1647.unnamed.first_primitive;
                                                                        }
                                                                        let _e1804 = phi_1892_;
                                                                        if (_e1800 == 0u) {
                                                                            phi_1902_ = _e1716.unnamed.root;
                                                                        } else {
                                                                            phi_1902_ = _e1716.unnamed.first_primitive;
                                                                        }
                                                                        let _e1813 = phi_1902_;
                                                                        if (_e1800 == 0u) {
                                                                            phi_1912_ = _e1785.unnamed.root;
                                                                        } else {
                                                                            phi_1912_ = _e1785.unnamed.first_primitive;
                                                                        }
                                                                        let _e1822 = phi_1912_;
                                                                        let _e1835 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1804 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1338)), ((f32(((_e1813 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u)) * _e1561) + (_e1579 - _e1339)));
                                                                        let _e1836 = core_intrinsics_maximum_number_nsz_f32_(_e1835, ((f32(((_e1822 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u)) * _e1562) + (_e1580 - _e1340)));
                                                                        if (_e1800 == 0u) {
                                                                            phi_1930_ = _e1647.unnamed_1.root;
                                                                        } else {
                                                                            phi_1930_ = _e1647.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1839 = phi_1930_;
                                                                        if (_e1800 == 0u) {
                                                                            phi_1940_ = _e1716.unnamed_1.root;
                                                                        } else {
                                                                            phi_1940_ = _e1716.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1848 = phi_1940_;
                                                                        if (_e1800 == 0u) {
                                                                            phi_1950_ = _e1785.unnamed_1.root;
                                                                        } else {
                                                                            phi_1950_ = _e1785.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1857 = phi_1950_;
                                                                        let _e1870 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1839 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1338)), ((f32(((_e1848 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u)) * _e1561) + (_e1579 + _e1339)));
                                                                        let _e1871 = core_intrinsics_minimum_number_nsz_f32_(_e1870, ((f32(((_e1857 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u)) * _e1562) + (_e1580 + _e1340)));
                                                                        if (_e1836 <= _e1871) {
                                                                            if (_e1836 <= _e207) {
                                                                                if (_e1871 >= 0f) {
                                                                                    if (_e1800 == 0u) {
                                                                                        let _e1878 = nodes.member[(0u + _e1526)].links[2u];
                                                                                        phi_1986_ = _e1878;
                                                                                    } else {
                                                                                        let _e1881 = nodes.member[(0u + _e1526)].links[3u];
                                                                                        phi_1986_ = _e1881;
                                                                                    }
                                                                                    let _e1883 = phi_1986_;
                                                                                    let _e1888 = ((_e1883 >> bitcast<u32>(((_e1801 * 8u) & 31u))) & 255u);
                                                                                    let _e1889 = (_e1888 & 31u);
                                                                                    if (_e1889 >= 24u) {
                                                                                        phi_1999_ = (24u + ((_e1889 - 24u) ^ _e1388));
                                                                                    } else {
                                                                                        phi_1999_ = _e1889;
                                                                                    }
                                                                                    let _e1895 = phi_1999_;
                                                                                    phi_2004_ = (_e1797 | ((_e1888 >> bitcast<u32>(5i)) << bitcast<u32>((_e1895 & 31u))));
                                                                                } else {
                                                                                    phi_2004_ = _e1797;
                                                                                }
                                                                                let _e1903 = phi_2004_;
                                                                                phi_2005_ = _e1903;
                                                                            } else {
                                                                                phi_2005_ = _e1797;
                                                                            }
                                                                            let _e1905 = phi_2005_;
                                                                            phi_2006_ = _e1905;
                                                                        } else {
                                                                            phi_2006_ = _e1797;
                                                                        }
                                                                        let _e1907 = phi_2006_;
                                                                        phi_1876_ = (_e1795 + 1u);
                                                                        phi_1879_ = _e1907;
                                                                    } else {
                                                                        phi_1876_ = u32();
                                                                        phi_1879_ = u32();
                                                                    }
                                                                    let _e1910 = phi_1876_;
                                                                    let _e1912 = phi_1879_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1875_ = _e1910;
                                                                        phi_1878_ = _e1912;
                                                                        break if !(_e1798);
                                                                    }
                                                                }
                                                                let _e1916 = nodes.member[(0u + _e1526)].links[0u];
                                                                let _e1920 = nodes.member[(0u + _e1526)].frame[3u];
                                                                let _e1924 = local_6;
                                                                if ((_e1924 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1928 = local.group_mask;
                                                                    if ((_e1928 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1932 = local.len;
                                                                        if (_e1932 < 32u) {
                                                                            let _e1935 = local.group;
                                                                            let _e1937 = local.len;
                                                                            if (_e1937 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.first[(0u + _e1937)] = _e1935;
                                                                            let _e1943 = local.group_mask;
                                                                            let _e1945 = local.len;
                                                                            if (_e1945 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.mask[(0u + _e1945)] = _e1943;
                                                                            let _e1952 = local.len;
                                                                            local.len = (_e1952 + 1u);
                                                                        }
                                                                    }
                                                                    local.group = (_e1150 + _e1916);
                                                                    let _e1956 = local_7;
                                                                    local.group_mask = ((_e1956 & 4278190080u) | (_e1920 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1961 = local_8;
                                                                phi_2064_ = (_e1961 & 16777215u);
                                                                phi_2067_ = _e1528;
                                                                loop {
                                                                    let _e1964 = phi_2064_;
                                                                    let _e1966 = phi_2067_;
                                                                    local_13 = _e1966;
                                                                    let _e1967 = (_e1964 == 0u);
                                                                    local_9 = _e1967;
                                                                    local_14 = _e1967;
                                                                    if _e1967 {
                                                                        phi_2065_ = u32();
                                                                        phi_2068_ = bool();
                                                                        phi_2665_ = false;
                                                                    } else {
                                                                        let _e1970 = nodes.member[(0u + _e1526)].links[1u];
                                                                        let _e1975 = ((_e1152 + _e1970) + select(firstTrailingBit(_e1964), 32u, (_e1964 == 0u)));
                                                                        if (_e1975 < arrayLength((&triangles.member))) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1982 = triangles.member[(0u + _e1975)].v0_;
                                                                        let _e1984 = (_e1982.x - _e1081);
                                                                        let _e1986 = (_e1982.y - _e1094);
                                                                        let _e1988 = (_e1982.z - _e1107);
                                                                        if (_e1361 == 0u) {
                                                                            phi_2112_ = vec3<f32>(_e1986, _e1988, _e1984);
                                                                        } else {
                                                                            if (_e1361 == 1u) {
                                                                                phi_2111_ = vec3<f32>(_e1988, _e1984, _e1986);
                                                                            } else {
                                                                                phi_2111_ = (_e1982 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                            }
                                                                            let _e1996 = phi_2111_;
                                                                            phi_2112_ = _e1996;
                                                                        }
                                                                        let _e1998 = phi_2112_;
                                                                        let _e2002 = (_e1998.x - (_e1372 * _e1998.z));
                                                                        let _e2006 = (_e1998.y - (_e1375 * _e1998.z));
                                                                        let _e2008 = triangles.member[(0u + _e1975)].v1_;
                                                                        let _e2010 = (_e2008.x - _e1081);
                                                                        let _e2012 = (_e2008.y - _e1094);
                                                                        let _e2014 = (_e2008.z - _e1107);
                                                                        if (_e1361 == 0u) {
                                                                            phi_2142_ = vec3<f32>(_e2012, _e2014, _e2010);
                                                                        } else {
                                                                            if (_e1361 == 1u) {
                                                                                phi_2141_ = vec3<f32>(_e2014, _e2010, _e2012);
                                                                            } else {
                                                                                phi_2141_ = (_e2008 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                            }
                                                                            let _e2022 = phi_2141_;
                                                                            phi_2142_ = _e2022;
                                                                        }
                                                                        let _e2024 = phi_2142_;
                                                                        let _e2028 = (_e2024.x - (_e1372 * _e2024.z));
                                                                        let _e2032 = (_e2024.y - (_e1375 * _e2024.z));
                                                                        let _e2034 = triangles.member[(0u + _e1975)].v2_;
                                                                        let _e2036 = (_e2034.x - _e1081);
                                                                        let _e2038 = (_e2034.y - _e1094);
                                                                        let _e2040 = (_e2034.z - _e1107);
                                                                        if (_e1361 == 0u) {
                                                                            phi_2172_ = vec3<f32>(_e2038, _e2040, _e2036);
                                                                        } else {
                                                                            if (_e1361 == 1u) {
                                                                                phi_2171_ = vec3<f32>(_e2040, _e2036, _e2038);
                                                                            } else {
                                                                                phi_2171_ = (_e2034 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                            }
                                                                            let _e2048 = phi_2171_;
                                                                            phi_2172_ = _e2048;
                                                                        }
                                                                        let _e2050 = phi_2172_;
                                                                        let _e2054 = (_e2050.x - (_e1372 * _e2050.z));
                                                                        let _e2058 = (_e2050.y - (_e1375 * _e2050.z));
                                                                        if (_e2028 < _e2054) {
                                                                            phi_2191_ = true;
                                                                        } else {
                                                                            if (_e2028 == _e2054) {
                                                                                phi_2190_ = (_e2032 < _e2058);
                                                                            } else {
                                                                                phi_2190_ = false;
                                                                            }
                                                                            let _e2063 = phi_2190_;
                                                                            phi_2191_ = _e2063;
                                                                        }
                                                                        let _e2065 = phi_2191_;
                                                                        if _e2065 {
                                                                            phi_2195_ = _e2058;
                                                                            phi_2196_ = _e2054;
                                                                            phi_2197_ = _e2032;
                                                                            phi_2198_ = _e2028;
                                                                        } else {
                                                                            phi_2195_ = _e2032;
                                                                            phi_2196_ = _e2028;
                                                                            phi_2197_ = _e2058;
                                                                            phi_2198_ = _e2054;
                                                                        }
                                                                        let _e2067 = phi_2195_;
                                                                        let _e2069 = phi_2196_;
                                                                        let _e2071 = phi_2197_;
                                                                        let _e2073 = phi_2198_;
                                                                        let _e2076 = ((_e2073 * _e2067) - (_e2071 * _e2069));
                                                                        if _e2065 {
                                                                            phi_2206_ = -(_e2076);
                                                                        } else {
                                                                            phi_2206_ = _e2076;
                                                                        }
                                                                        let _e2079 = phi_2206_;
                                                                        if (_e2054 < _e2002) {
                                                                            phi_2217_ = true;
                                                                        } else {
                                                                            if (_e2054 == _e2002) {
                                                                                phi_2216_ = (_e2058 < _e2006);
                                                                            } else {
                                                                                phi_2216_ = false;
                                                                            }
                                                                            let _e2084 = phi_2216_;
                                                                            phi_2217_ = _e2084;
                                                                        }
                                                                        let _e2086 = phi_2217_;
                                                                        if _e2086 {
                                                                            phi_2221_ = _e2006;
                                                                            phi_2222_ = _e2002;
                                                                            phi_2223_ = _e2058;
                                                                            phi_2224_ = _e2054;
                                                                        } else {
                                                                            phi_2221_ = _e2058;
                                                                            phi_2222_ = _e2054;
                                                                            phi_2223_ = _e2006;
                                                                            phi_2224_ = _e2002;
                                                                        }
                                                                        let _e2088 = phi_2221_;
                                                                        let _e2090 = phi_2222_;
                                                                        let _e2092 = phi_2223_;
                                                                        let _e2094 = phi_2224_;
                                                                        let _e2097 = ((_e2094 * _e2088) - (_e2092 * _e2090));
                                                                        if _e2086 {
                                                                            phi_2232_ = -(_e2097);
                                                                        } else {
                                                                            phi_2232_ = _e2097;
                                                                        }
                                                                        let _e2100 = phi_2232_;
                                                                        if (_e2002 < _e2028) {
                                                                            phi_2243_ = true;
                                                                        } else {
                                                                            if (_e2002 == _e2028) {
                                                                                phi_2242_ = (_e2006 < _e2032);
                                                                            } else {
                                                                                phi_2242_ = false;
                                                                            }
                                                                            let _e2105 = phi_2242_;
                                                                            phi_2243_ = _e2105;
                                                                        }
                                                                        let _e2107 = phi_2243_;
                                                                        if _e2107 {
                                                                            phi_2247_ = _e2032;
                                                                            phi_2248_ = _e2028;
                                                                            phi_2249_ = _e2006;
                                                                            phi_2250_ = _e2002;
                                                                        } else {
                                                                            phi_2247_ = _e2006;
                                                                            phi_2248_ = _e2002;
                                                                            phi_2249_ = _e2032;
                                                                            phi_2250_ = _e2028;
                                                                        }
                                                                        let _e2109 = phi_2247_;
                                                                        let _e2111 = phi_2248_;
                                                                        let _e2113 = phi_2249_;
                                                                        let _e2115 = phi_2250_;
                                                                        let _e2118 = ((_e2115 * _e2109) - (_e2113 * _e2111));
                                                                        if _e2107 {
                                                                            phi_2258_ = -(_e2118);
                                                                        } else {
                                                                            phi_2258_ = _e2118;
                                                                        }
                                                                        let _e2121 = phi_2258_;
                                                                        if (_e2079 >= 0f) {
                                                                            if (_e2100 >= 0f) {
                                                                                if (_e2121 >= 0f) {
                                                                                    phi_2273_ = ((_e2079 + _e2100) + _e2121);
                                                                                    phi_2274_ = false;
                                                                                } else {
                                                                                    phi_2273_ = f32();
                                                                                    phi_2274_ = true;
                                                                                }
                                                                                let _e2128 = phi_2273_;
                                                                                let _e2130 = phi_2274_;
                                                                                phi_2275_ = _e2128;
                                                                                phi_2276_ = _e2130;
                                                                            } else {
                                                                                phi_2275_ = f32();
                                                                                phi_2276_ = true;
                                                                            }
                                                                            let _e2132 = phi_2275_;
                                                                            let _e2134 = phi_2276_;
                                                                            phi_2277_ = _e2132;
                                                                            phi_2278_ = _e2134;
                                                                        } else {
                                                                            phi_2277_ = f32();
                                                                            phi_2278_ = true;
                                                                        }
                                                                        let _e2136 = phi_2277_;
                                                                        let _e2138 = phi_2278_;
                                                                        if _e2138 {
                                                                            if (_e2079 <= 0f) {
                                                                                if (_e2100 <= 0f) {
                                                                                    let _e2141 = (_e2121 <= 0f);
                                                                                    if _e2141 {
                                                                                    }
                                                                                    phi_2296_ = ((_e2079 + _e2100) + _e2121);
                                                                                    phi_2297_ = false;
                                                                                    phi_2298_ = _e2141;
                                                                                } else {
                                                                                    phi_2296_ = f32();
                                                                                    phi_2297_ = true;
                                                                                    phi_2298_ = false;
                                                                                }
                                                                                let _e2145 = phi_2296_;
                                                                                let _e2147 = phi_2297_;
                                                                                let _e2149 = phi_2298_;
                                                                                phi_2299_ = _e2145;
                                                                                phi_2300_ = _e2147;
                                                                                phi_2301_ = _e2149;
                                                                            } else {
                                                                                phi_2299_ = f32();
                                                                                phi_2300_ = true;
                                                                                phi_2301_ = false;
                                                                            }
                                                                            let _e2151 = phi_2299_;
                                                                            let _e2153 = phi_2300_;
                                                                            let _e2155 = phi_2301_;
                                                                            if _e2153 {
                                                                                phi_2305_ = false;
                                                                            } else {
                                                                                phi_2305_ = _e2155;
                                                                            }
                                                                            let _e2157 = phi_2305_;
                                                                            phi_2306_ = _e2151;
                                                                            phi_2307_ = _e2157;
                                                                        } else {
                                                                            phi_2306_ = _e2136;
                                                                            phi_2307_ = true;
                                                                        }
                                                                        let _e2159 = phi_2306_;
                                                                        let _e2161 = phi_2307_;
                                                                        if _e2161 {
                                                                            let _e2162 = (_e2159 == 0f);
                                                                            if _e2162 {
                                                                                phi_2623_ = lt_bvh_triangle_Intersection();
                                                                                phi_2624_ = false;
                                                                            } else {
                                                                                let _e2164 = triangles.member[(0u + _e1975)].v0_;
                                                                                let _e2166 = (_e2164.x - _e1081);
                                                                                let _e2168 = (_e2164.y - _e1094);
                                                                                let _e2170 = (_e2164.z - _e1107);
                                                                                if (_e1361 == 0u) {
                                                                                    phi_2336_ = vec3<f32>(_e2168, _e2170, _e2166);
                                                                                } else {
                                                                                    if (_e1361 == 1u) {
                                                                                        phi_2335_ = vec3<f32>(_e2170, _e2166, _e2168);
                                                                                    } else {
                                                                                        phi_2335_ = (_e2164 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                                    }
                                                                                    let _e2178 = phi_2335_;
                                                                                    phi_2336_ = _e2178;
                                                                                }
                                                                                let _e2180 = phi_2336_;
                                                                                let _e2182 = triangles.member[(0u + _e1975)].v1_;
                                                                                let _e2184 = triangles.member[(0u + _e1975)].v0_;
                                                                                let _e2187 = (_e2182.x - _e2184.x);
                                                                                let _e2190 = (_e2182.y - _e2184.y);
                                                                                let _e2193 = (_e2182.z - _e2184.z);
                                                                                if (_e1361 == 0u) {
                                                                                    phi_2362_ = vec3<f32>(_e2190, _e2193, _e2187);
                                                                                } else {
                                                                                    if (_e1361 == 1u) {
                                                                                        phi_2361_ = vec3<f32>(_e2193, _e2187, _e2190);
                                                                                    } else {
                                                                                        phi_2361_ = (_e2182 - _e2184);
                                                                                    }
                                                                                    let _e2200 = phi_2361_;
                                                                                    phi_2362_ = _e2200;
                                                                                }
                                                                                let _e2202 = phi_2362_;
                                                                                let _e2204 = triangles.member[(0u + _e1975)].v2_;
                                                                                let _e2206 = triangles.member[(0u + _e1975)].v0_;
                                                                                let _e2209 = (_e2204.x - _e2206.x);
                                                                                let _e2212 = (_e2204.y - _e2206.y);
                                                                                let _e2215 = (_e2204.z - _e2206.z);
                                                                                if (_e1361 == 0u) {
                                                                                    phi_2388_ = vec3<f32>(_e2212, _e2215, _e2209);
                                                                                } else {
                                                                                    if (_e1361 == 1u) {
                                                                                        phi_2387_ = vec3<f32>(_e2215, _e2209, _e2212);
                                                                                    } else {
                                                                                        phi_2387_ = (_e2204 - _e2206);
                                                                                    }
                                                                                    let _e2222 = phi_2387_;
                                                                                    phi_2388_ = _e2222;
                                                                                }
                                                                                let _e2224 = phi_2388_;
                                                                                let _e2231 = ((_e2202.y * _e2224.z) - (_e2202.z * _e2224.y));
                                                                                let _e2238 = ((_e2202.z * _e2224.x) - (_e2202.x * _e2224.z));
                                                                                let _e2245 = ((_e2202.x * _e2224.y) - (_e2202.y * _e2224.x));
                                                                                let _e2259 = (((1f / _e1369.z) * (((_e2231 * _e2180.x) + (_e2238 * _e2180.y)) + (_e2245 * _e2180.z))) / (((_e2231 * _e1372) + (_e2238 * _e1375)) + _e2245));
                                                                                if (_e2259 > 0f) {
                                                                                    if (_e2259 < _e207) {
                                                                                        let _e2263 = triangles.member[(0u + _e1975)].v0_;
                                                                                        let _e2265 = triangles.member[(0u + _e1975)].v1_;
                                                                                        if (_e2263.x < _e2265.x) {
                                                                                            phi_2444_ = _e2263.x;
                                                                                        } else {
                                                                                            phi_2444_ = _e2265.x;
                                                                                        }
                                                                                        let _e2272 = phi_2444_;
                                                                                        if (_e2263.y < _e2265.y) {
                                                                                            phi_2453_ = _e2263.y;
                                                                                        } else {
                                                                                            phi_2453_ = _e2265.y;
                                                                                        }
                                                                                        let _e2279 = phi_2453_;
                                                                                        if (_e2263.z < _e2265.z) {
                                                                                            phi_2462_ = _e2263.z;
                                                                                        } else {
                                                                                            phi_2462_ = _e2265.z;
                                                                                        }
                                                                                        let _e2286 = phi_2462_;
                                                                                        let _e2288 = triangles.member[(0u + _e1975)].v2_;
                                                                                        if (_e2272 < _e2288.x) {
                                                                                            phi_2471_ = _e2272;
                                                                                        } else {
                                                                                            phi_2471_ = _e2288.x;
                                                                                        }
                                                                                        let _e2293 = phi_2471_;
                                                                                        if (_e2279 < _e2288.y) {
                                                                                            phi_2478_ = _e2279;
                                                                                        } else {
                                                                                            phi_2478_ = _e2288.y;
                                                                                        }
                                                                                        let _e2298 = phi_2478_;
                                                                                        if (_e2286 < _e2288.z) {
                                                                                            phi_2485_ = _e2286;
                                                                                        } else {
                                                                                            phi_2485_ = _e2288.z;
                                                                                        }
                                                                                        let _e2303 = phi_2485_;
                                                                                        let _e2305 = triangles.member[(0u + _e1975)].v0_;
                                                                                        let _e2307 = triangles.member[(0u + _e1975)].v1_;
                                                                                        if (_e2305.x > _e2307.x) {
                                                                                            phi_2498_ = _e2305.x;
                                                                                        } else {
                                                                                            phi_2498_ = _e2307.x;
                                                                                        }
                                                                                        let _e2314 = phi_2498_;
                                                                                        if (_e2305.y > _e2307.y) {
                                                                                            phi_2507_ = _e2305.y;
                                                                                        } else {
                                                                                            phi_2507_ = _e2307.y;
                                                                                        }
                                                                                        let _e2321 = phi_2507_;
                                                                                        if (_e2305.z > _e2307.z) {
                                                                                            phi_2516_ = _e2305.z;
                                                                                        } else {
                                                                                            phi_2516_ = _e2307.z;
                                                                                        }
                                                                                        let _e2328 = phi_2516_;
                                                                                        let _e2330 = triangles.member[(0u + _e1975)].v2_;
                                                                                        if (_e2314 > _e2330.x) {
                                                                                            phi_2525_ = _e2314;
                                                                                        } else {
                                                                                            phi_2525_ = _e2330.x;
                                                                                        }
                                                                                        let _e2335 = phi_2525_;
                                                                                        if (_e2321 > _e2330.y) {
                                                                                            phi_2532_ = _e2321;
                                                                                        } else {
                                                                                            phi_2532_ = _e2330.y;
                                                                                        }
                                                                                        let _e2340 = phi_2532_;
                                                                                        if (_e2328 > _e2330.z) {
                                                                                            phi_2539_ = _e2328;
                                                                                        } else {
                                                                                            phi_2539_ = _e2330.z;
                                                                                        }
                                                                                        let _e2345 = phi_2539_;
                                                                                        let _e2349 = ((_e2293 - _e1081) * _e1290);
                                                                                        let _e2350 = ((_e2298 - _e1094) * _e1300);
                                                                                        let _e2351 = ((_e2303 - _e1107) * _e1310);
                                                                                        let _e2355 = ((_e2335 - _e1081) * _e1290);
                                                                                        let _e2356 = ((_e2340 - _e1094) * _e1300);
                                                                                        let _e2357 = ((_e2345 - _e1107) * _e1310);
                                                                                        if (_e2349 < _e2355) {
                                                                                            phi_2556_ = _e2349;
                                                                                        } else {
                                                                                            phi_2556_ = _e2355;
                                                                                        }
                                                                                        let _e2360 = phi_2556_;
                                                                                        if (_e2350 < _e2356) {
                                                                                            phi_2561_ = _e2350;
                                                                                        } else {
                                                                                            phi_2561_ = _e2356;
                                                                                        }
                                                                                        let _e2363 = phi_2561_;
                                                                                        if (_e2351 < _e2357) {
                                                                                            phi_2566_ = _e2351;
                                                                                        } else {
                                                                                            phi_2566_ = _e2357;
                                                                                        }
                                                                                        let _e2366 = phi_2566_;
                                                                                        if (_e2349 > _e2355) {
                                                                                            phi_2574_ = _e2349;
                                                                                        } else {
                                                                                            phi_2574_ = _e2355;
                                                                                        }
                                                                                        let _e2372 = phi_2574_;
                                                                                        if (_e2350 > _e2356) {
                                                                                            phi_2579_ = _e2350;
                                                                                        } else {
                                                                                            phi_2579_ = _e2356;
                                                                                        }
                                                                                        let _e2375 = phi_2579_;
                                                                                        if (_e2351 > _e2357) {
                                                                                            phi_2584_ = _e2351;
                                                                                        } else {
                                                                                            phi_2584_ = _e2357;
                                                                                        }
                                                                                        let _e2378 = phi_2584_;
                                                                                        let _e2382 = core_intrinsics_maximum_number_nsz_f32_((_e2360 - _e1345), (_e2363 - _e1346));
                                                                                        let _e2383 = core_intrinsics_maximum_number_nsz_f32_(_e2382, (_e2366 - _e1347));
                                                                                        let _e2384 = core_intrinsics_minimum_number_nsz_f32_((_e2372 + _e1345), (_e2375 + _e1346));
                                                                                        let _e2385 = core_intrinsics_minimum_number_nsz_f32_(_e2384, (_e2378 + _e1347));
                                                                                        if (_e2383 > _e1062) {
                                                                                            phi_2596_ = _e2383;
                                                                                        } else {
                                                                                            phi_2596_ = _e1062;
                                                                                        }
                                                                                        let _e2388 = phi_2596_;
                                                                                        if (_e2385 < _e1064) {
                                                                                            phi_2601_ = _e2385;
                                                                                        } else {
                                                                                            phi_2601_ = _e1064;
                                                                                        }
                                                                                        let _e2391 = phi_2601_;
                                                                                        if (_e2259 < _e2388) {
                                                                                            phi_2606_ = _e2388;
                                                                                        } else {
                                                                                            phi_2606_ = _e2259;
                                                                                        }
                                                                                        let _e2394 = phi_2606_;
                                                                                        if (_e2394 > _e2391) {
                                                                                            phi_2611_ = _e2391;
                                                                                        } else {
                                                                                            phi_2611_ = _e2394;
                                                                                        }
                                                                                        let _e2397 = phi_2611_;
                                                                                        phi_2616_ = lt_bvh_triangle_Intersection(_e2397, (_e2100 / _e2159), (_e2121 / _e2159), (_e2388 <= _e2391));
                                                                                        phi_2617_ = false;
                                                                                    } else {
                                                                                        phi_2616_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2617_ = true;
                                                                                    }
                                                                                    let _e2403 = phi_2616_;
                                                                                    let _e2405 = phi_2617_;
                                                                                    phi_2618_ = _e2403;
                                                                                    phi_2619_ = _e2405;
                                                                                } else {
                                                                                    phi_2618_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2619_ = true;
                                                                                }
                                                                                let _e2407 = phi_2618_;
                                                                                let _e2409 = phi_2619_;
                                                                                if _e2409 {
                                                                                }
                                                                                phi_2623_ = _e2407;
                                                                                phi_2624_ = _e2409;
                                                                            }
                                                                            let _e2411 = phi_2623_;
                                                                            let _e2413 = phi_2624_;
                                                                            phi_2625_ = _e2411;
                                                                            phi_2626_ = _e2162;
                                                                            phi_2627_ = _e2413;
                                                                        } else {
                                                                            phi_2625_ = lt_bvh_triangle_Intersection();
                                                                            phi_2626_ = true;
                                                                            phi_2627_ = false;
                                                                        }
                                                                        let _e2415 = phi_2625_;
                                                                        let _e2417 = phi_2626_;
                                                                        let _e2419 = phi_2627_;
                                                                        if _e2417 {
                                                                            phi_2631_ = true;
                                                                        } else {
                                                                            phi_2631_ = _e2419;
                                                                        }
                                                                        let _e2421 = phi_2631_;
                                                                        if _e2421 {
                                                                            phi_2635_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2635_ = _e2415;
                                                                        }
                                                                        let _e2423 = phi_2635_;
                                                                        if _e2423.is_hit {
                                                                            if (_e2423.t > 0f) {
                                                                                if (_e2423.t < _e207) {
                                                                                    if true {
                                                                                        phi_2655_ = false;
                                                                                    } else {
                                                                                        phi_2655_ = true;
                                                                                    }
                                                                                    let _e2432 = phi_2655_;
                                                                                    phi_2656_ = true;
                                                                                    phi_2657_ = _e2432;
                                                                                } else {
                                                                                    phi_2656_ = _e1966;
                                                                                    phi_2657_ = true;
                                                                                }
                                                                                let _e2434 = phi_2656_;
                                                                                let _e2436 = phi_2657_;
                                                                                phi_2658_ = _e2434;
                                                                                phi_2659_ = _e2436;
                                                                            } else {
                                                                                phi_2658_ = _e1966;
                                                                                phi_2659_ = true;
                                                                            }
                                                                            let _e2438 = phi_2658_;
                                                                            let _e2440 = phi_2659_;
                                                                            phi_2660_ = _e2438;
                                                                            phi_2661_ = _e2440;
                                                                        } else {
                                                                            phi_2660_ = _e1966;
                                                                            phi_2661_ = true;
                                                                        }
                                                                        let _e2442 = phi_2660_;
                                                                        let _e2444 = phi_2661_;
                                                                        if _e2444 {
                                                                        }
                                                                        phi_2065_ = (_e1964 & (_e1964 - 1u));
                                                                        phi_2068_ = _e2442;
                                                                        phi_2665_ = _e2444;
                                                                    }
                                                                    let _e2446 = phi_2065_;
                                                                    let _e2448 = phi_2068_;
                                                                    let _e2450 = phi_2665_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2064_ = _e2446;
                                                                        phi_2067_ = _e2448;
                                                                        break if !(_e2450);
                                                                    }
                                                                }
                                                                let _e2453 = local_9;
                                                                if _e2453 {
                                                                    let _e2455 = local.group_mask;
                                                                    if ((_e2455 & 4278190080u) == 0u) {
                                                                        let _e2459 = local.len;
                                                                        if (_e2459 == 0u) {
                                                                            phi_2707_ = false;
                                                                        } else {
                                                                            let _e2463 = local.len;
                                                                            local.len = (_e2463 - 1u);
                                                                            let _e2466 = local.len;
                                                                            if (_e2466 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2471 = local.first[(0u + _e2466)];
                                                                            local.group = _e2471;
                                                                            let _e2474 = local.len;
                                                                            if (_e2474 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2479 = local.mask[(0u + _e2474)];
                                                                            local.group_mask = _e2479;
                                                                            phi_2707_ = true;
                                                                        }
                                                                        let _e2482 = phi_2707_;
                                                                        phi_2708_ = _e2482;
                                                                    } else {
                                                                        phi_2708_ = true;
                                                                    }
                                                                    let _e2484 = phi_2708_;
                                                                    if _e2484 {
                                                                        let _e2486 = local.group_mask;
                                                                        let _e2492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2486)), 32u, (_e2486 == 0u)));
                                                                        let _e2496 = local.group_mask;
                                                                        let _e2510 = local.group_mask;
                                                                        local.group_mask = (_e2510 & ~((1u << bitcast<u32>((_e2492 & 31u)))));
                                                                        let _e2513 = local.group;
                                                                        phi_2739_ = (_e2513 + countOneBits(((_e2496 & ~((4294967295u << bitcast<u32>((((_e2492 - 24u) ^ _e1388) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2739_ = 4294967295u;
                                                                    }
                                                                    let _e2516 = phi_2739_;
                                                                    phi_2740_ = _e2516;
                                                                } else {
                                                                    phi_2740_ = u32();
                                                                }
                                                                let _e2518 = phi_2740_;
                                                                phi_1733_ = _e2518;
                                                                let _e2902 = local_13;
                                                                phi_1736_ = _e2902;
                                                                let _e2905 = local_14;
                                                                phi_2741_ = _e2905;
                                                                phi_2742_ = false;
                                                            } else {
                                                                phi_1733_ = u32();
                                                                phi_1736_ = bool();
                                                                phi_2741_ = false;
                                                                phi_2742_ = true;
                                                            }
                                                            let _e2520 = phi_1733_;
                                                            let _e2522 = phi_1736_;
                                                            let _e2524 = phi_2741_;
                                                            let _e2526 = phi_2742_;
                                                            local_10 = _e2526;
                                                            continue;
                                                            continuing {
                                                                phi_1732_ = _e2520;
                                                                phi_1735_ = _e2522;
                                                                break if !(_e2524);
                                                            }
                                                        }
                                                        let _e2529 = local_10;
                                                        if _e2529 {
                                                            phi_2746_ = false;
                                                        } else {
                                                            phi_2746_ = true;
                                                        }
                                                        let _e2531 = phi_2746_;
                                                        if _e2531 {
                                                            phi_2750_ = true;
                                                        } else {
                                                            let _e2911 = local_15;
                                                            phi_2750_ = _e2911;
                                                        }
                                                        let _e2533 = phi_2750_;
                                                        phi_2751_ = _e2533;
                                                    }
                                                    let _e2535 = phi_2751_;
                                                    phi_2752_ = _e2535;
                                                    phi_2753_ = _e1214;
                                                } else {
                                                    phi_2752_ = bool();
                                                    phi_2753_ = true;
                                                }
                                                let _e2537 = phi_2752_;
                                                let _e2539 = phi_2753_;
                                                if _e2539 {
                                                    phi_2757_ = _e1001;
                                                } else {
                                                    phi_2757_ = _e2537;
                                                }
                                                let _e2541 = phi_2757_;
                                                if _e2541 {
                                                    phi_2761_ = false;
                                                } else {
                                                    phi_2761_ = true;
                                                }
                                                let _e2543 = phi_2761_;
                                                phi_2762_ = _e2541;
                                                phi_2763_ = _e2543;
                                            } else {
                                                phi_2762_ = _e1001;
                                                phi_2763_ = true;
                                            }
                                            let _e2545 = phi_2762_;
                                            let _e2547 = phi_2763_;
                                            phi_2764_ = _e2545;
                                            phi_2765_ = _e2547;
                                        } else {
                                            phi_2764_ = _e1001;
                                            phi_2765_ = true;
                                        }
                                        let _e2549 = phi_2764_;
                                        let _e2551 = phi_2765_;
                                        phi_2766_ = _e2549;
                                        phi_2767_ = _e2551;
                                    } else {
                                        phi_2766_ = _e1001;
                                        phi_2767_ = true;
                                    }
                                    let _e2553 = phi_2766_;
                                    let _e2555 = phi_2767_;
                                    if _e2555 {
                                    }
                                    phi_1125_ = (_e999 & (_e999 - 1u));
                                    phi_1128_ = _e2553;
                                    phi_2771_ = _e2555;
                                }
                                let _e2557 = phi_1125_;
                                let _e2559 = phi_1128_;
                                let _e2561 = phi_2771_;
                                continue;
                                continuing {
                                    phi_1124_ = _e2557;
                                    phi_1127_ = _e2559;
                                    break if !(_e2561);
                                }
                            }
                            let _e2564 = local_11;
                            if _e2564 {
                                let _e2566 = local_1.group_mask;
                                if ((_e2566 & 4278190080u) == 0u) {
                                    let _e2570 = local_1.len;
                                    if (_e2570 == 0u) {
                                        phi_2813_ = false;
                                    } else {
                                        let _e2574 = local_1.len;
                                        local_1.len = (_e2574 - 1u);
                                        let _e2577 = local_1.len;
                                        if (_e2577 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2582 = local_1.first[(0u + _e2577)];
                                        local_1.group = _e2582;
                                        let _e2585 = local_1.len;
                                        if (_e2585 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2590 = local_1.mask[(0u + _e2585)];
                                        local_1.group_mask = _e2590;
                                        phi_2813_ = true;
                                    }
                                    let _e2593 = phi_2813_;
                                    phi_2814_ = _e2593;
                                } else {
                                    phi_2814_ = true;
                                }
                                let _e2595 = phi_2814_;
                                if _e2595 {
                                    let _e2597 = local_1.group_mask;
                                    let _e2603 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2597)), 32u, (_e2597 == 0u)));
                                    let _e2607 = local_1.group_mask;
                                    let _e2621 = local_1.group_mask;
                                    local_1.group_mask = (_e2621 & ~((1u << bitcast<u32>((_e2603 & 31u)))));
                                    let _e2624 = local_1.group;
                                    phi_2845_ = (_e2624 + countOneBits(((_e2607 & ~((4294967295u << bitcast<u32>((((_e2603 - 24u) ^ _e423) & 31u))))) & 255u)));
                                } else {
                                    phi_2845_ = 4294967295u;
                                }
                                let _e2627 = phi_2845_;
                                phi_2846_ = _e2627;
                            } else {
                                phi_2846_ = u32();
                            }
                            let _e2629 = phi_2846_;
                            phi_793_ = _e2629;
                            let _e2934 = local_16;
                            phi_796_ = _e2934;
                            let _e2937 = local_17;
                            phi_2847_ = _e2937;
                            phi_2848_ = false;
                        } else {
                            phi_793_ = u32();
                            phi_796_ = bool();
                            phi_2847_ = false;
                            phi_2848_ = true;
                        }
                        let _e2631 = phi_793_;
                        let _e2633 = phi_796_;
                        let _e2635 = phi_2847_;
                        let _e2637 = phi_2848_;
                        local_12 = _e2637;
                        continue;
                        continuing {
                            phi_792_ = _e2631;
                            phi_795_ = _e2633;
                            break if !(_e2635);
                        }
                    }
                    let _e2640 = local_12;
                    if _e2640 {
                        phi_2852_ = false;
                    } else {
                        phi_2852_ = true;
                    }
                    let _e2642 = phi_2852_;
                    if _e2642 {
                    }
                    phi_2856_ = _e2642;
                }
                let _e2644 = phi_2856_;
                phi_2857_ = _e279;
                phi_2858_ = _e2644;
            } else {
                phi_2857_ = true;
                phi_2858_ = false;
            }
            let _e2646 = phi_2857_;
            let _e2648 = phi_2858_;
            if _e2646 {
                phi_2862_ = false;
                phi_2863_ = true;
            } else {
                phi_2862_ = true;
                phi_2863_ = _e2648;
            }
            let _e2650 = phi_2862_;
            let _e2652 = phi_2863_;
            if _e2652 {
                phi_2867_ = _e2650;
            } else {
                phi_2867_ = false;
            }
            let _e2654 = phi_2867_;
            if _e2654 {
                phi_2871_ = 0f;
            } else {
                phi_2871_ = 1f;
            }
            let _e2656 = phi_2871_;
            phi_2872_ = _e2656;
        }
        let _e2658 = phi_2872_;
        if (_e79.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.first_primitive)] = _e2658;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
