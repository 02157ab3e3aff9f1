struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_39 {
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

struct type_43 {
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

struct type_51 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_21;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> nodes: type_39;
@group(0) @binding(3) 
var<storage> triangles: type_43;
@group(0) @binding(5) 
var<storage> instances: type_51;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_190_: lt_bvh_traverse_Tree;
    var phi_191_: bool;
    var phi_192_: lt_bvh_traverse_Tree;
    var phi_193_: bool;
    var phi_198_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_190_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_191_ = false;
        } else {
            phi_190_ = lt_bvh_traverse_Tree();
            phi_191_ = true;
        }
        let _e67 = phi_190_;
        let _e69 = phi_191_;
        phi_192_ = _e67;
        phi_193_ = _e69;
    } else {
        phi_192_ = lt_bvh_traverse_Tree();
        phi_193_ = true;
    }
    let _e71 = phi_192_;
    let _e73 = phi_193_;
    if _e73 {
        phi_198_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_198_ = _e71;
    }
    let _e78 = phi_198_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_213_: bool;
    var phi_217_: f32;

    if (param_3 != param_3) {
        phi_213_ = true;
    } else {
        let _e57 = (param_4 >= param_3);
        if _e57 {
        }
        phi_213_ = _e57;
    }
    let _e59 = phi_213_;
    if _e59 {
        phi_217_ = param_4;
    } else {
        phi_217_ = param_3;
    }
    let _e61 = phi_217_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_229_: bool;
    var phi_233_: f32;

    if (param_5 != param_5) {
        phi_229_ = true;
    } else {
        let _e57 = (param_6 <= param_5);
        if _e57 {
        }
        phi_229_ = _e57;
    }
    let _e59 = phi_229_;
    if _e59 {
        phi_233_ = param_6;
    } else {
        phi_233_ = param_5;
    }
    let _e61 = phi_233_;
    return _e61;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_265_: bool;

    let _e57 = (*param_7).normal[0u];
    let _e59 = global[0u];
    if (_e57 == _e59) {
        let _e62 = (*param_7).normal[1u];
        let _e64 = global[1u];
        if (_e62 == _e64) {
            let _e67 = (*param_7).normal[2u];
            let _e69 = global[2u];
            phi_258_ = (_e67 == _e69);
            phi_259_ = false;
        } else {
            phi_258_ = bool();
            phi_259_ = true;
        }
        let _e72 = phi_258_;
        let _e74 = phi_259_;
        phi_260_ = _e72;
        phi_261_ = _e74;
    } else {
        phi_260_ = bool();
        phi_261_ = true;
    }
    let _e76 = phi_260_;
    let _e78 = phi_261_;
    if _e78 {
        phi_265_ = false;
    } else {
        phi_265_ = _e76;
    }
    let _e80 = phi_265_;
    return !(_e80);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_392_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_393_: bool;
    var phi_394_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_395_: bool;
    var phi_402_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_406_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_449_: f32;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;
    var phi_484_: bool;
    var phi_488_: bool;
    var phi_501_: bool;
    var phi_502_: bool;
    var phi_503_: bool;
    var phi_504_: bool;
    var phi_508_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_535_: bool;
    var phi_605_: f32;
    var phi_612_: f32;
    var phi_619_: f32;
    var phi_626_: f32;
    var phi_633_: f32;
    var phi_640_: f32;
    var phi_657_: f32;
    var phi_662_: f32;
    var phi_667_: f32;
    var phi_672_: f32;
    var phi_677_: f32;
    var phi_696_: u32;
    var phi_701_: u32;
    var phi_706_: u32;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_852_: u32;
    var phi_854_: u32;
    var phi_857_: bool;
    var phi_937_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_964_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_991_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_997_: u32;
    var phi_1000_: u32;
    var phi_1014_: u32;
    var phi_1024_: u32;
    var phi_1034_: u32;
    var phi_1052_: u32;
    var phi_1062_: u32;
    var phi_1072_: u32;
    var phi_1108_: u32;
    var phi_1121_: u32;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1128_: u32;
    var phi_998_: u32;
    var phi_1001_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1186_: u32;
    var phi_1189_: bool;
    var phi_1238_: f32;
    var phi_1243_: f32;
    var phi_1248_: f32;
    var phi_1256_: f32;
    var phi_1261_: f32;
    var phi_1266_: f32;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1393_: bool;
    var phi_1406_: bool;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1413_: bool;
    var phi_1426_: bool;
    var phi_1427_: bool;
    var phi_1428_: bool;
    var phi_1432_: bool;
    var phi_1433_: bool;
    var phi_1434_: bool;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1440_: bool;
    var phi_1510_: f32;
    var phi_1517_: f32;
    var phi_1524_: f32;
    var phi_1531_: f32;
    var phi_1538_: f32;
    var phi_1545_: f32;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1617_: u32;
    var phi_1618_: u32;
    var phi_1629_: vec3<f32>;
    var phi_1630_: vec3<f32>;
    var phi_1643_: u32;
    var phi_1648_: u32;
    var phi_1653_: u32;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1799_: u32;
    var phi_1801_: u32;
    var phi_1804_: bool;
    var phi_1884_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1911_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1938_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1944_: u32;
    var phi_1947_: u32;
    var phi_1961_: u32;
    var phi_1971_: u32;
    var phi_1981_: u32;
    var phi_1999_: u32;
    var phi_2009_: u32;
    var phi_2019_: u32;
    var phi_2055_: u32;
    var phi_2068_: u32;
    var phi_2073_: u32;
    var phi_2074_: u32;
    var phi_2075_: u32;
    var phi_1945_: u32;
    var phi_1948_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2133_: u32;
    var phi_2136_: bool;
    var phi_2180_: vec3<f32>;
    var phi_2181_: vec3<f32>;
    var phi_2210_: vec3<f32>;
    var phi_2211_: vec3<f32>;
    var phi_2240_: vec3<f32>;
    var phi_2241_: vec3<f32>;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_2264_: f32;
    var phi_2265_: f32;
    var phi_2266_: f32;
    var phi_2267_: f32;
    var phi_2275_: f32;
    var phi_2285_: bool;
    var phi_2286_: bool;
    var phi_2290_: f32;
    var phi_2291_: f32;
    var phi_2292_: f32;
    var phi_2293_: f32;
    var phi_2301_: f32;
    var phi_2311_: bool;
    var phi_2312_: bool;
    var phi_2316_: f32;
    var phi_2317_: f32;
    var phi_2318_: f32;
    var phi_2319_: f32;
    var phi_2327_: f32;
    var phi_2342_: f32;
    var phi_2343_: bool;
    var phi_2344_: f32;
    var phi_2345_: bool;
    var phi_2346_: f32;
    var phi_2347_: bool;
    var phi_2365_: f32;
    var phi_2366_: bool;
    var phi_2367_: bool;
    var phi_2368_: f32;
    var phi_2369_: bool;
    var phi_2370_: bool;
    var phi_2374_: bool;
    var phi_2375_: f32;
    var phi_2376_: bool;
    var phi_2404_: vec3<f32>;
    var phi_2405_: vec3<f32>;
    var phi_2430_: vec3<f32>;
    var phi_2431_: vec3<f32>;
    var phi_2456_: vec3<f32>;
    var phi_2457_: vec3<f32>;
    var phi_2513_: f32;
    var phi_2522_: f32;
    var phi_2531_: f32;
    var phi_2540_: f32;
    var phi_2547_: f32;
    var phi_2554_: f32;
    var phi_2567_: f32;
    var phi_2576_: f32;
    var phi_2585_: f32;
    var phi_2594_: f32;
    var phi_2601_: f32;
    var phi_2608_: f32;
    var phi_2625_: f32;
    var phi_2630_: f32;
    var phi_2635_: f32;
    var phi_2643_: f32;
    var phi_2648_: f32;
    var phi_2653_: f32;
    var phi_2665_: f32;
    var phi_2670_: f32;
    var phi_2675_: f32;
    var phi_2680_: f32;
    var phi_2685_: lt_bvh_triangle_Intersection;
    var phi_2686_: bool;
    var phi_2687_: lt_bvh_triangle_Intersection;
    var phi_2688_: bool;
    var phi_2692_: lt_bvh_triangle_Intersection;
    var phi_2693_: bool;
    var phi_2694_: lt_bvh_triangle_Intersection;
    var phi_2695_: bool;
    var phi_2696_: bool;
    var phi_2700_: bool;
    var phi_2704_: lt_bvh_triangle_Intersection;
    var phi_2724_: bool;
    var phi_2725_: bool;
    var phi_2726_: bool;
    var phi_2727_: bool;
    var phi_2728_: bool;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var phi_2134_: u32;
    var phi_2137_: bool;
    var phi_2734_: bool;
    var local_9: bool;
    var phi_2776_: bool;
    var phi_2777_: bool;
    var phi_2808_: u32;
    var phi_2809_: u32;
    var phi_1802_: u32;
    var phi_1805_: bool;
    var phi_2810_: bool;
    var phi_2811_: bool;
    var local_10: bool;
    var phi_2815_: bool;
    var phi_2819_: bool;
    var phi_2820_: bool;
    var phi_2821_: bool;
    var phi_2822_: bool;
    var phi_2826_: bool;
    var phi_2830_: bool;
    var phi_2831_: bool;
    var phi_2832_: bool;
    var phi_2833_: bool;
    var phi_2834_: bool;
    var phi_2835_: bool;
    var phi_2836_: bool;
    var phi_1187_: u32;
    var phi_1190_: bool;
    var phi_2840_: bool;
    var local_11: bool;
    var phi_2882_: bool;
    var phi_2883_: bool;
    var phi_2914_: u32;
    var phi_2915_: u32;
    var phi_855_: u32;
    var phi_858_: bool;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var local_12: bool;
    var phi_2921_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2936_: bool;
    var phi_2940_: f32;
    var phi_2941_: f32;
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
                    phi_381_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_380_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_380_ = false;
                    }
                    let _e156 = phi_380_;
                    phi_381_ = _e156;
                }
                let _e158 = phi_381_;
                if _e158 {
                    let _e160 = local_2.flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_392_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_393_ = false;
                } else {
                    phi_392_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_393_ = true;
                }
                let _e179 = phi_392_;
                let _e181 = phi_393_;
                phi_394_ = _e179;
                phi_395_ = _e181;
            } else {
                phi_394_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_395_ = true;
            }
            let _e183 = phi_394_;
            let _e185 = phi_395_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_402_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_402_ = _e183;
            }
            let _e202 = phi_402_;
            phi_406_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_406_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_406_;
        let _e224 = p.member.root;
        if _e219.unnamed_1 {
            phi_2941_ = _e219.unnamed.visibility;
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
                phi_449_ = 300000000000000000000000000000000000000f;
            } else {
                phi_449_ = 1f;
            }
            let _e251 = phi_449_;
            let _e259 = (_e247.x - (_e241 * _e247.w));
            let _e260 = (_e247.y - (_e243 * _e247.w));
            let _e261 = (_e247.z - (_e245 * _e247.w));
            let _e262 = abs(_e259);
            let _e263 = abs(_e260);
            let _e264 = abs(_e261);
            if (abs(_e241) < 1000000000000000f) {
                if (abs(_e243) < 1000000000000000f) {
                    phi_481_ = (abs(_e245) < 1000000000000000f);
                    phi_482_ = false;
                } else {
                    phi_481_ = bool();
                    phi_482_ = true;
                }
                let _e272 = phi_481_;
                let _e274 = phi_482_;
                phi_483_ = _e272;
                phi_484_ = _e274;
            } else {
                phi_483_ = bool();
                phi_484_ = true;
            }
            let _e276 = phi_483_;
            let _e278 = phi_484_;
            if _e278 {
                phi_488_ = false;
            } else {
                phi_488_ = _e276;
            }
            let _e280 = phi_488_;
            if _e280 {
                if (_e262 < 1000000000000000f) {
                    if (_e263 < 1000000000000000f) {
                        phi_501_ = (_e264 < 1000000000000000f);
                        phi_502_ = false;
                    } else {
                        phi_501_ = bool();
                        phi_502_ = true;
                    }
                    let _e285 = phi_501_;
                    let _e287 = phi_502_;
                    phi_503_ = _e285;
                    phi_504_ = _e287;
                } else {
                    phi_503_ = bool();
                    phi_504_ = true;
                }
                let _e289 = phi_503_;
                let _e291 = phi_504_;
                if _e291 {
                    phi_508_ = false;
                } else {
                    phi_508_ = _e289;
                }
                let _e293 = phi_508_;
                if _e293 {
                    if (_e262 > 0f) {
                        phi_522_ = bool();
                        phi_523_ = true;
                    } else {
                        let _e295 = (_e263 > 0f);
                        if _e295 {
                            phi_521_ = bool();
                        } else {
                            phi_521_ = (_e264 > 0f);
                        }
                        let _e298 = phi_521_;
                        phi_522_ = _e298;
                        phi_523_ = _e295;
                    }
                    let _e300 = phi_522_;
                    let _e302 = phi_523_;
                    if _e302 {
                        phi_527_ = true;
                    } else {
                        phi_527_ = _e300;
                    }
                    let _e304 = phi_527_;
                    phi_528_ = _e304;
                    phi_529_ = false;
                } else {
                    phi_528_ = bool();
                    phi_529_ = true;
                }
                let _e306 = phi_528_;
                let _e308 = phi_529_;
                phi_530_ = _e306;
                phi_531_ = _e308;
            } else {
                phi_530_ = bool();
                phi_531_ = true;
            }
            let _e310 = phi_530_;
            let _e312 = phi_531_;
            if _e312 {
                phi_535_ = false;
            } else {
                phi_535_ = _e310;
            }
            let _e314 = phi_535_;
            if _e314 {
                let _e315 = (_e224 >= _e64);
                if _e315 {
                    phi_2925_ = false;
                } else {
                    if (_e224 < _e64) {
                    } else {
                        return;
                    }
                    let _e321 = nodes.member[(0u + _e224)].frame[0u];
                    let _e325 = nodes.member[(0u + _e224)].frame[1u];
                    let _e329 = nodes.member[(0u + _e224)].frame[2u];
                    let _e333 = nodes.member[(0u + _e224)].frame[0u];
                    let _e337 = nodes.member[(0u + _e224)].frame[1u];
                    let _e341 = nodes.member[(0u + _e224)].frame[2u];
                    let _e345 = nodes.member[(0u + _e224)].frame[3u];
                    let _e379 = core_intrinsics_maximum_number_nsz_f32_(abs(_e259), abs(_e260));
                    let _e380 = core_intrinsics_maximum_number_nsz_f32_(_e379, abs(_e261));
                    let _e381 = (_e380 * 0.0000000000009094947f);
                    if (abs(_e259) < _e381) {
                        phi_605_ = _e381;
                    } else {
                        phi_605_ = abs(_e259);
                    }
                    let _e386 = phi_605_;
                    if (_e259 < 0f) {
                        phi_612_ = (-1f / _e386);
                    } else {
                        phi_612_ = (1f / _e386);
                    }
                    let _e391 = phi_612_;
                    if (abs(_e260) < _e381) {
                        phi_619_ = _e381;
                    } else {
                        phi_619_ = abs(_e260);
                    }
                    let _e396 = phi_619_;
                    if (_e260 < 0f) {
                        phi_626_ = (-1f / _e396);
                    } else {
                        phi_626_ = (1f / _e396);
                    }
                    let _e401 = phi_626_;
                    if (abs(_e261) < _e381) {
                        phi_633_ = _e381;
                    } else {
                        phi_633_ = abs(_e261);
                    }
                    let _e406 = phi_633_;
                    if (_e261 < 0f) {
                        phi_640_ = (-1f / _e406);
                    } else {
                        phi_640_ = (1f / _e406);
                    }
                    let _e411 = phi_640_;
                    let _e415 = abs((bitcast<f32>(_e321) - _e241));
                    let _e416 = abs((bitcast<f32>(_e325) - _e243));
                    let _e417 = abs((bitcast<f32>(_e329) - _e245));
                    let _e421 = abs(((bitcast<f32>(_e333) + (bitcast<f32>((((_e345 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e241));
                    let _e422 = abs(((bitcast<f32>(_e337) + (bitcast<f32>((((_e345 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e243));
                    let _e423 = abs(((bitcast<f32>(_e341) + (bitcast<f32>((((_e345 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e245));
                    if (_e415 > _e421) {
                        phi_657_ = _e415;
                    } else {
                        phi_657_ = _e421;
                    }
                    let _e426 = phi_657_;
                    if (_e416 > _e422) {
                        phi_662_ = _e416;
                    } else {
                        phi_662_ = _e422;
                    }
                    let _e429 = phi_662_;
                    if (_e417 > _e423) {
                        phi_667_ = _e417;
                    } else {
                        phi_667_ = _e423;
                    }
                    let _e432 = phi_667_;
                    if (_e426 > _e429) {
                        phi_672_ = _e426;
                    } else {
                        phi_672_ = _e429;
                    }
                    let _e435 = phi_672_;
                    if (_e435 > _e432) {
                        phi_677_ = _e435;
                    } else {
                        phi_677_ = _e432;
                    }
                    let _e438 = phi_677_;
                    let _e442 = (_e438 * 0.0000019073486f);
                    let _e443 = (abs(_e391) * _e442);
                    let _e444 = (abs(_e401) * _e442);
                    let _e445 = (abs(_e411) * _e442);
                    let _e449 = (_e438 * 0.0000009536743f);
                    let _e450 = (abs(_e391) * _e449);
                    let _e451 = (abs(_e401) * _e449);
                    let _e452 = (abs(_e411) * _e449);
                    if (_e391 < 0f) {
                        phi_696_ = 0u;
                    } else {
                        phi_696_ = 1u;
                    }
                    let _e455 = phi_696_;
                    if (_e401 < 0f) {
                        phi_701_ = 0u;
                    } else {
                        phi_701_ = 2u;
                    }
                    let _e458 = phi_701_;
                    if (_e411 < 0f) {
                        phi_706_ = 0u;
                    } else {
                        phi_706_ = 4u;
                    }
                    let _e461 = phi_706_;
                    let _e463 = ((_e455 | _e458) | _e461);
                    let _e464 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e224, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e464.first[0], _e464.first[1], _e464.first[2], _e464.first[3], _e464.first[4], _e464.first[5], _e464.first[6], _e464.first[7], _e464.first[8], _e464.first[9], _e464.first[10], _e464.first[11], _e464.first[12], _e464.first[13], _e464.first[14], _e464.first[15], _e464.first[16], _e464.first[17], _e464.first[18], _e464.first[19], _e464.first[20], _e464.first[21], _e464.first[22], _e464.first[23], _e464.first[24], _e464.first[25], _e464.first[26], _e464.first[27], _e464.first[28], _e464.first[29], _e464.first[30], _e464.first[31]), array<u32, 32>(_e464.mask[0], _e464.mask[1], _e464.mask[2], _e464.mask[3], _e464.mask[4], _e464.mask[5], _e464.mask[6], _e464.mask[7], _e464.mask[8], _e464.mask[9], _e464.mask[10], _e464.mask[11], _e464.mask[12], _e464.mask[13], _e464.mask[14], _e464.mask[15], _e464.mask[16], _e464.mask[17], _e464.mask[18], _e464.mask[19], _e464.mask[20], _e464.mask[21], _e464.mask[22], _e464.mask[23], _e464.mask[24], _e464.mask[25], _e464.mask[26], _e464.mask[27], _e464.mask[28], _e464.mask[29], _e464.mask[30], _e464.mask[31]), _e464.len, _e464.group, _e464.group_mask);
                    let _e538 = local_1.group_mask;
                    if ((_e538 & 4278190080u) == 0u) {
                        let _e542 = local_1.len;
                        if (_e542 == 0u) {
                            phi_820_ = false;
                        } else {
                            let _e546 = local_1.len;
                            local_1.len = (_e546 - 1u);
                            let _e549 = local_1.len;
                            if (_e549 < 32u) {
                            } else {
                                return;
                            }
                            let _e554 = local_1.first[(0u + _e549)];
                            local_1.group = _e554;
                            let _e557 = local_1.len;
                            if (_e557 < 32u) {
                            } else {
                                return;
                            }
                            let _e562 = local_1.mask[(0u + _e557)];
                            local_1.group_mask = _e562;
                            phi_820_ = true;
                        }
                        let _e565 = phi_820_;
                        phi_821_ = _e565;
                    } else {
                        phi_821_ = true;
                    }
                    let _e567 = phi_821_;
                    if _e567 {
                        let _e569 = local_1.group_mask;
                        let _e575 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e569)), 32u, (_e569 == 0u)));
                        let _e579 = local_1.group_mask;
                        let _e593 = local_1.group_mask;
                        local_1.group_mask = (_e593 & ~((1u << bitcast<u32>((_e575 & 31u)))));
                        let _e596 = local_1.group;
                        phi_852_ = (_e596 + countOneBits(((_e579 & ~((4294967295u << bitcast<u32>((((_e575 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_852_ = 4294967295u;
                    }
                    let _e599 = phi_852_;
                    phi_854_ = _e599;
                    phi_857_ = false;
                    loop {
                        let _e601 = phi_854_;
                        let _e603 = phi_857_;
                        if (_e601 != 4294967295u) {
                            if (_e601 < _e64) {
                            } else {
                                return;
                            }
                            let _e610 = nodes.member[(0u + _e601)].frame[3u];
                            let _e635 = (bitcast<f32>((((_e610 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e391);
                            let _e636 = (bitcast<f32>((((_e610 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e401);
                            let _e637 = (bitcast<f32>((((_e610 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e411);
                            let _e640 = nodes.member[(0u + _e601)].frame[0u];
                            let _e644 = nodes.member[(0u + _e601)].frame[1u];
                            let _e648 = nodes.member[(0u + _e601)].frame[2u];
                            let _e653 = ((bitcast<f32>(_e640) - _e241) * _e391);
                            let _e654 = ((bitcast<f32>(_e644) - _e243) * _e401);
                            let _e655 = ((bitcast<f32>(_e648) - _e245) * _e411);
                            let _e663 = nodes.member[(0u + _e601)].x;
                            if (_e391 < 0f) {
                                let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e674.unnamed.root, _e663.w), _e674.unnamed_1);
                                let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e663.x, _e680.unnamed_1.first_primitive));
                                phi_937_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e686.unnamed_1.root, _e663.y));
                            } else {
                                let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.unnamed.root, _e663.y), _e702.unnamed_1);
                                let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_bvh_traverse_Tree(_e663.z, _e708.unnamed_1.first_primitive));
                                phi_937_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e714.unnamed_1.root, _e663.w));
                            }
                            let _e722 = phi_937_;
                            let _e732 = nodes.member[(0u + _e601)].y;
                            if (_e401 < 0f) {
                                let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e743.unnamed.root, _e732.w), _e743.unnamed_1);
                                let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e732.x, _e749.unnamed_1.first_primitive));
                                phi_964_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_bvh_traverse_Tree(_e755.unnamed_1.root, _e732.y));
                            } else {
                                let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e771.unnamed.root, _e732.y), _e771.unnamed_1);
                                let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_bvh_traverse_Tree(_e732.z, _e777.unnamed_1.first_primitive));
                                phi_964_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_bvh_traverse_Tree(_e783.unnamed_1.root, _e732.w));
                            }
                            let _e791 = phi_964_;
                            let _e801 = nodes.member[(0u + _e601)].z;
                            if (_e411 < 0f) {
                                let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e801.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e812.unnamed.root, _e801.w), _e812.unnamed_1);
                                let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e818.unnamed, lt_bvh_traverse_Tree(_e801.x, _e818.unnamed_1.first_primitive));
                                phi_991_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e824.unnamed, lt_bvh_traverse_Tree(_e824.unnamed_1.root, _e801.y));
                            } else {
                                let _e840 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e801.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e846 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e840.unnamed.root, _e801.y), _e840.unnamed_1);
                                let _e852 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e846.unnamed, lt_bvh_traverse_Tree(_e801.z, _e846.unnamed_1.first_primitive));
                                phi_991_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e852.unnamed, lt_bvh_traverse_Tree(_e852.unnamed_1.root, _e801.w));
                            }
                            let _e860 = phi_991_;
                            phi_997_ = 0u;
                            phi_1000_ = 0u;
                            loop {
                                let _e870 = phi_997_;
                                let _e872 = phi_1000_;
                                local_3 = _e872;
                                local_4 = _e872;
                                local_5 = _e872;
                                let _e873 = (_e870 < 8u);
                                if _e873 {
                                    let _e875 = (_e870 >> bitcast<u32>(2i));
                                    let _e876 = (_e870 & 3u);
                                    if (_e875 == 0u) {
                                        phi_1014_ = _e722.unnamed.root;
                                    } else {
                                        phi_1014_ = _e722.unnamed.first_primitive;
                                    }
                                    let _e879 = phi_1014_;
                                    if (_e875 == 0u) {
                                        phi_1024_ = _e791.unnamed.root;
                                    } else {
                                        phi_1024_ = _e791.unnamed.first_primitive;
                                    }
                                    let _e888 = phi_1024_;
                                    if (_e875 == 0u) {
                                        phi_1034_ = _e860.unnamed.root;
                                    } else {
                                        phi_1034_ = _e860.unnamed.first_primitive;
                                    }
                                    let _e897 = phi_1034_;
                                    let _e910 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e879 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u)) * _e635) + (_e653 - _e443)), ((f32(((_e888 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u)) * _e636) + (_e654 - _e444)));
                                    let _e911 = core_intrinsics_maximum_number_nsz_f32_(_e910, ((f32(((_e897 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u)) * _e637) + (_e655 - _e445)));
                                    if (_e875 == 0u) {
                                        phi_1052_ = _e722.unnamed_1.root;
                                    } else {
                                        phi_1052_ = _e722.unnamed_1.first_primitive;
                                    }
                                    let _e914 = phi_1052_;
                                    if (_e875 == 0u) {
                                        phi_1062_ = _e791.unnamed_1.root;
                                    } else {
                                        phi_1062_ = _e791.unnamed_1.first_primitive;
                                    }
                                    let _e923 = phi_1062_;
                                    if (_e875 == 0u) {
                                        phi_1072_ = _e860.unnamed_1.root;
                                    } else {
                                        phi_1072_ = _e860.unnamed_1.first_primitive;
                                    }
                                    let _e932 = phi_1072_;
                                    let _e945 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e914 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u)) * _e635) + (_e653 + _e443)), ((f32(((_e923 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u)) * _e636) + (_e654 + _e444)));
                                    let _e946 = core_intrinsics_minimum_number_nsz_f32_(_e945, ((f32(((_e932 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u)) * _e637) + (_e655 + _e445)));
                                    if (_e911 <= _e946) {
                                        if (_e911 <= _e251) {
                                            if (_e946 >= 0f) {
                                                if (_e875 == 0u) {
                                                    let _e953 = nodes.member[(0u + _e601)].links[2u];
                                                    phi_1108_ = _e953;
                                                } else {
                                                    let _e956 = nodes.member[(0u + _e601)].links[3u];
                                                    phi_1108_ = _e956;
                                                }
                                                let _e958 = phi_1108_;
                                                let _e963 = ((_e958 >> bitcast<u32>(((_e876 * 8u) & 31u))) & 255u);
                                                let _e964 = (_e963 & 31u);
                                                if (_e964 >= 24u) {
                                                    phi_1121_ = (24u + ((_e964 - 24u) ^ _e463));
                                                } else {
                                                    phi_1121_ = _e964;
                                                }
                                                let _e970 = phi_1121_;
                                                phi_1126_ = (_e872 | ((_e963 >> bitcast<u32>(5i)) << bitcast<u32>((_e970 & 31u))));
                                            } else {
                                                phi_1126_ = _e872;
                                            }
                                            let _e978 = phi_1126_;
                                            phi_1127_ = _e978;
                                        } else {
                                            phi_1127_ = _e872;
                                        }
                                        let _e980 = phi_1127_;
                                        phi_1128_ = _e980;
                                    } else {
                                        phi_1128_ = _e872;
                                    }
                                    let _e982 = phi_1128_;
                                    phi_998_ = (_e870 + 1u);
                                    phi_1001_ = _e982;
                                } else {
                                    phi_998_ = u32();
                                    phi_1001_ = u32();
                                }
                                let _e985 = phi_998_;
                                let _e987 = phi_1001_;
                                continue;
                                continuing {
                                    phi_997_ = _e985;
                                    phi_1000_ = _e987;
                                    break if !(_e873);
                                }
                            }
                            let _e991 = nodes.member[(0u + _e601)].links[0u];
                            let _e995 = nodes.member[(0u + _e601)].frame[3u];
                            let _e999 = local_3;
                            if ((_e999 & 4278190080u) == 0u) {
                            } else {
                                let _e1003 = local_1.group_mask;
                                if ((_e1003 & 4278190080u) == 0u) {
                                } else {
                                    let _e1007 = local_1.len;
                                    if (_e1007 < 32u) {
                                        let _e1010 = local_1.group;
                                        let _e1012 = local_1.len;
                                        if (_e1012 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1012)] = _e1010;
                                        let _e1018 = local_1.group_mask;
                                        let _e1020 = local_1.len;
                                        if (_e1020 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1020)] = _e1018;
                                        let _e1027 = local_1.len;
                                        local_1.len = (_e1027 + 1u);
                                    }
                                }
                                local_1.group = (_e224 + _e991);
                                let _e1031 = local_4;
                                local_1.group_mask = ((_e1031 & 4278190080u) | (_e995 >> bitcast<u32>(24i)));
                            }
                            let _e1036 = local_5;
                            phi_1186_ = (_e1036 & 16777215u);
                            phi_1189_ = _e603;
                            loop {
                                let _e1039 = phi_1186_;
                                let _e1041 = phi_1189_;
                                local_16 = _e1041;
                                let _e1042 = (_e1039 == 0u);
                                local_11 = _e1042;
                                local_17 = _e1042;
                                if _e1042 {
                                    phi_1187_ = u32();
                                    phi_1190_ = bool();
                                    phi_2840_ = false;
                                } else {
                                    let _e1045 = nodes.member[(0u + _e601)].links[1u];
                                    let _e1049 = (_e1045 + select(firstTrailingBit(_e1039), 32u, (_e1039 == 0u)));
                                    if (_e1049 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1056 = instances.member[(0u + _e1049)].low_world;
                                    let _e1058 = instances.member[(0u + _e1049)].high_world;
                                    let _e1065 = ((_e1056.x - _e241) * _e391);
                                    let _e1066 = ((_e1056.y - _e243) * _e401);
                                    let _e1067 = ((_e1056.z - _e245) * _e411);
                                    let _e1074 = ((_e1058.x - _e241) * _e391);
                                    let _e1075 = ((_e1058.y - _e243) * _e401);
                                    let _e1076 = ((_e1058.z - _e245) * _e411);
                                    if (_e1065 < _e1074) {
                                        phi_1238_ = _e1065;
                                    } else {
                                        phi_1238_ = _e1074;
                                    }
                                    let _e1079 = phi_1238_;
                                    if (_e1066 < _e1075) {
                                        phi_1243_ = _e1066;
                                    } else {
                                        phi_1243_ = _e1075;
                                    }
                                    let _e1082 = phi_1243_;
                                    if (_e1067 < _e1076) {
                                        phi_1248_ = _e1067;
                                    } else {
                                        phi_1248_ = _e1076;
                                    }
                                    let _e1085 = phi_1248_;
                                    if (_e1065 > _e1074) {
                                        phi_1256_ = _e1065;
                                    } else {
                                        phi_1256_ = _e1074;
                                    }
                                    let _e1091 = phi_1256_;
                                    if (_e1066 > _e1075) {
                                        phi_1261_ = _e1066;
                                    } else {
                                        phi_1261_ = _e1075;
                                    }
                                    let _e1094 = phi_1261_;
                                    if (_e1067 > _e1076) {
                                        phi_1266_ = _e1067;
                                    } else {
                                        phi_1266_ = _e1076;
                                    }
                                    let _e1097 = phi_1266_;
                                    let _e1101 = core_intrinsics_maximum_number_nsz_f32_((_e1079 - _e450), (_e1082 - _e451));
                                    let _e1102 = core_intrinsics_maximum_number_nsz_f32_(_e1101, (_e1085 - _e452));
                                    let _e1103 = core_intrinsics_minimum_number_nsz_f32_((_e1091 + _e450), (_e1094 + _e451));
                                    let _e1104 = core_intrinsics_minimum_number_nsz_f32_(_e1103, (_e1097 + _e452));
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
                                                let _e1193 = abs(_e1161);
                                                let _e1194 = abs(_e1174);
                                                let _e1195 = abs(_e1187);
                                                if (abs(_e1121) < 1000000000000000f) {
                                                    if (abs(_e1134) < 1000000000000000f) {
                                                        phi_1386_ = (abs(_e1147) < 1000000000000000f);
                                                        phi_1387_ = false;
                                                    } else {
                                                        phi_1386_ = bool();
                                                        phi_1387_ = true;
                                                    }
                                                    let _e1203 = phi_1386_;
                                                    let _e1205 = phi_1387_;
                                                    phi_1388_ = _e1203;
                                                    phi_1389_ = _e1205;
                                                } else {
                                                    phi_1388_ = bool();
                                                    phi_1389_ = true;
                                                }
                                                let _e1207 = phi_1388_;
                                                let _e1209 = phi_1389_;
                                                if _e1209 {
                                                    phi_1393_ = false;
                                                } else {
                                                    phi_1393_ = _e1207;
                                                }
                                                let _e1211 = phi_1393_;
                                                if _e1211 {
                                                    if (_e1193 < 1000000000000000f) {
                                                        if (_e1194 < 1000000000000000f) {
                                                            phi_1406_ = (_e1195 < 1000000000000000f);
                                                            phi_1407_ = false;
                                                        } else {
                                                            phi_1406_ = bool();
                                                            phi_1407_ = true;
                                                        }
                                                        let _e1216 = phi_1406_;
                                                        let _e1218 = phi_1407_;
                                                        phi_1408_ = _e1216;
                                                        phi_1409_ = _e1218;
                                                    } else {
                                                        phi_1408_ = bool();
                                                        phi_1409_ = true;
                                                    }
                                                    let _e1220 = phi_1408_;
                                                    let _e1222 = phi_1409_;
                                                    if _e1222 {
                                                        phi_1413_ = false;
                                                    } else {
                                                        phi_1413_ = _e1220;
                                                    }
                                                    let _e1224 = phi_1413_;
                                                    if _e1224 {
                                                        if (_e1193 > 0f) {
                                                            phi_1427_ = bool();
                                                            phi_1428_ = true;
                                                        } else {
                                                            let _e1226 = (_e1194 > 0f);
                                                            if _e1226 {
                                                                phi_1426_ = bool();
                                                            } else {
                                                                phi_1426_ = (_e1195 > 0f);
                                                            }
                                                            let _e1229 = phi_1426_;
                                                            phi_1427_ = _e1229;
                                                            phi_1428_ = _e1226;
                                                        }
                                                        let _e1231 = phi_1427_;
                                                        let _e1233 = phi_1428_;
                                                        if _e1233 {
                                                            phi_1432_ = true;
                                                        } else {
                                                            phi_1432_ = _e1231;
                                                        }
                                                        let _e1235 = phi_1432_;
                                                        phi_1433_ = _e1235;
                                                        phi_1434_ = false;
                                                    } else {
                                                        phi_1433_ = bool();
                                                        phi_1434_ = true;
                                                    }
                                                    let _e1237 = phi_1433_;
                                                    let _e1239 = phi_1434_;
                                                    phi_1435_ = _e1237;
                                                    phi_1436_ = _e1239;
                                                } else {
                                                    phi_1435_ = bool();
                                                    phi_1436_ = true;
                                                }
                                                let _e1241 = phi_1435_;
                                                let _e1243 = phi_1436_;
                                                if _e1243 {
                                                    phi_1440_ = false;
                                                } else {
                                                    phi_1440_ = _e1241;
                                                }
                                                let _e1245 = phi_1440_;
                                                if _e1245 {
                                                    let _e1246 = (_e1190 >= _e64);
                                                    if _e1246 {
                                                        phi_2820_ = bool();
                                                    } else {
                                                        if (_e1190 < _e64) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1252 = nodes.member[(0u + _e1190)].frame[0u];
                                                        let _e1256 = nodes.member[(0u + _e1190)].frame[1u];
                                                        let _e1260 = nodes.member[(0u + _e1190)].frame[2u];
                                                        let _e1264 = nodes.member[(0u + _e1190)].frame[0u];
                                                        let _e1268 = nodes.member[(0u + _e1190)].frame[1u];
                                                        let _e1272 = nodes.member[(0u + _e1190)].frame[2u];
                                                        let _e1276 = nodes.member[(0u + _e1190)].frame[3u];
                                                        let _e1310 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1161), abs(_e1174));
                                                        let _e1311 = core_intrinsics_maximum_number_nsz_f32_(_e1310, abs(_e1187));
                                                        let _e1312 = (_e1311 * 0.0000000000009094947f);
                                                        if (abs(_e1161) < _e1312) {
                                                            phi_1510_ = _e1312;
                                                        } else {
                                                            phi_1510_ = abs(_e1161);
                                                        }
                                                        let _e1317 = phi_1510_;
                                                        if (_e1161 < 0f) {
                                                            phi_1517_ = (-1f / _e1317);
                                                        } else {
                                                            phi_1517_ = (1f / _e1317);
                                                        }
                                                        let _e1322 = phi_1517_;
                                                        if (abs(_e1174) < _e1312) {
                                                            phi_1524_ = _e1312;
                                                        } else {
                                                            phi_1524_ = abs(_e1174);
                                                        }
                                                        let _e1327 = phi_1524_;
                                                        if (_e1174 < 0f) {
                                                            phi_1531_ = (-1f / _e1327);
                                                        } else {
                                                            phi_1531_ = (1f / _e1327);
                                                        }
                                                        let _e1332 = phi_1531_;
                                                        if (abs(_e1187) < _e1312) {
                                                            phi_1538_ = _e1312;
                                                        } else {
                                                            phi_1538_ = abs(_e1187);
                                                        }
                                                        let _e1337 = phi_1538_;
                                                        if (_e1187 < 0f) {
                                                            phi_1545_ = (-1f / _e1337);
                                                        } else {
                                                            phi_1545_ = (1f / _e1337);
                                                        }
                                                        let _e1342 = phi_1545_;
                                                        let _e1346 = abs((bitcast<f32>(_e1252) - _e1121));
                                                        let _e1347 = abs((bitcast<f32>(_e1256) - _e1134));
                                                        let _e1348 = abs((bitcast<f32>(_e1260) - _e1147));
                                                        let _e1352 = abs(((bitcast<f32>(_e1264) + (bitcast<f32>((((_e1276 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1121));
                                                        let _e1353 = abs(((bitcast<f32>(_e1268) + (bitcast<f32>((((_e1276 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1134));
                                                        let _e1354 = abs(((bitcast<f32>(_e1272) + (bitcast<f32>((((_e1276 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1147));
                                                        if (_e1346 > _e1352) {
                                                            phi_1562_ = _e1346;
                                                        } else {
                                                            phi_1562_ = _e1352;
                                                        }
                                                        let _e1357 = phi_1562_;
                                                        if (_e1347 > _e1353) {
                                                            phi_1567_ = _e1347;
                                                        } else {
                                                            phi_1567_ = _e1353;
                                                        }
                                                        let _e1360 = phi_1567_;
                                                        if (_e1348 > _e1354) {
                                                            phi_1572_ = _e1348;
                                                        } else {
                                                            phi_1572_ = _e1354;
                                                        }
                                                        let _e1363 = phi_1572_;
                                                        if (_e1357 > _e1360) {
                                                            phi_1577_ = _e1357;
                                                        } else {
                                                            phi_1577_ = _e1360;
                                                        }
                                                        let _e1366 = phi_1577_;
                                                        if (_e1366 > _e1363) {
                                                            phi_1582_ = _e1366;
                                                        } else {
                                                            phi_1582_ = _e1363;
                                                        }
                                                        let _e1369 = phi_1582_;
                                                        let _e1373 = (_e1369 * 0.0000019073486f);
                                                        let _e1374 = (abs(_e1322) * _e1373);
                                                        let _e1375 = (abs(_e1332) * _e1373);
                                                        let _e1376 = (abs(_e1342) * _e1373);
                                                        let _e1380 = (_e1369 * 0.0000009536743f);
                                                        let _e1381 = (abs(_e1322) * _e1380);
                                                        let _e1382 = (abs(_e1332) * _e1380);
                                                        let _e1383 = (abs(_e1342) * _e1380);
                                                        let _e1384 = abs(_e1161);
                                                        let _e1385 = abs(_e1174);
                                                        let _e1386 = abs(_e1187);
                                                        if (_e1384 >= _e1385) {
                                                            if (_e1384 >= _e1386) {
                                                                phi_1608_ = false;
                                                            } else {
                                                                phi_1608_ = true;
                                                            }
                                                            let _e1390 = phi_1608_;
                                                            phi_1609_ = _e1390;
                                                        } else {
                                                            phi_1609_ = true;
                                                        }
                                                        let _e1392 = phi_1609_;
                                                        if _e1392 {
                                                            if (_e1385 >= _e1386) {
                                                                phi_1617_ = 1u;
                                                            } else {
                                                                phi_1617_ = 2u;
                                                            }
                                                            let _e1395 = phi_1617_;
                                                            phi_1618_ = _e1395;
                                                        } else {
                                                            phi_1618_ = 0u;
                                                        }
                                                        let _e1397 = phi_1618_;
                                                        if (_e1397 == 0u) {
                                                            phi_1630_ = vec3<f32>(_e1174, _e1187, _e1161);
                                                        } else {
                                                            if (_e1397 == 1u) {
                                                                phi_1629_ = vec3<f32>(_e1187, _e1161, _e1174);
                                                            } else {
                                                                phi_1629_ = vec3<f32>(_e1161, _e1174, _e1187);
                                                            }
                                                            let _e1403 = phi_1629_;
                                                            phi_1630_ = _e1403;
                                                        }
                                                        let _e1405 = phi_1630_;
                                                        let _e1408 = (_e1405.x / _e1405.z);
                                                        let _e1411 = (_e1405.y / _e1405.z);
                                                        if (_e1322 < 0f) {
                                                            phi_1643_ = 0u;
                                                        } else {
                                                            phi_1643_ = 1u;
                                                        }
                                                        let _e1416 = phi_1643_;
                                                        if (_e1332 < 0f) {
                                                            phi_1648_ = 0u;
                                                        } else {
                                                            phi_1648_ = 2u;
                                                        }
                                                        let _e1419 = phi_1648_;
                                                        if (_e1342 < 0f) {
                                                            phi_1653_ = 0u;
                                                        } else {
                                                            phi_1653_ = 4u;
                                                        }
                                                        let _e1422 = phi_1653_;
                                                        let _e1424 = ((_e1416 | _e1419) | _e1422);
                                                        let _e1425 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1190, 2147483648u);
                                                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1425.first[0], _e1425.first[1], _e1425.first[2], _e1425.first[3], _e1425.first[4], _e1425.first[5], _e1425.first[6], _e1425.first[7], _e1425.first[8], _e1425.first[9], _e1425.first[10], _e1425.first[11], _e1425.first[12], _e1425.first[13], _e1425.first[14], _e1425.first[15], _e1425.first[16], _e1425.first[17], _e1425.first[18], _e1425.first[19], _e1425.first[20], _e1425.first[21], _e1425.first[22], _e1425.first[23], _e1425.first[24], _e1425.first[25], _e1425.first[26], _e1425.first[27], _e1425.first[28], _e1425.first[29], _e1425.first[30], _e1425.first[31]), array<u32, 32>(_e1425.mask[0], _e1425.mask[1], _e1425.mask[2], _e1425.mask[3], _e1425.mask[4], _e1425.mask[5], _e1425.mask[6], _e1425.mask[7], _e1425.mask[8], _e1425.mask[9], _e1425.mask[10], _e1425.mask[11], _e1425.mask[12], _e1425.mask[13], _e1425.mask[14], _e1425.mask[15], _e1425.mask[16], _e1425.mask[17], _e1425.mask[18], _e1425.mask[19], _e1425.mask[20], _e1425.mask[21], _e1425.mask[22], _e1425.mask[23], _e1425.mask[24], _e1425.mask[25], _e1425.mask[26], _e1425.mask[27], _e1425.mask[28], _e1425.mask[29], _e1425.mask[30], _e1425.mask[31]), _e1425.len, _e1425.group, _e1425.group_mask);
                                                        let _e1499 = local.group_mask;
                                                        if ((_e1499 & 4278190080u) == 0u) {
                                                            let _e1503 = local.len;
                                                            if (_e1503 == 0u) {
                                                                phi_1767_ = false;
                                                            } else {
                                                                let _e1507 = local.len;
                                                                local.len = (_e1507 - 1u);
                                                                let _e1510 = local.len;
                                                                if (_e1510 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1515 = local.first[(0u + _e1510)];
                                                                local.group = _e1515;
                                                                let _e1518 = local.len;
                                                                if (_e1518 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1523 = local.mask[(0u + _e1518)];
                                                                local.group_mask = _e1523;
                                                                phi_1767_ = true;
                                                            }
                                                            let _e1526 = phi_1767_;
                                                            phi_1768_ = _e1526;
                                                        } else {
                                                            phi_1768_ = true;
                                                        }
                                                        let _e1528 = phi_1768_;
                                                        if _e1528 {
                                                            let _e1530 = local.group_mask;
                                                            let _e1536 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1530)), 32u, (_e1530 == 0u)));
                                                            let _e1540 = local.group_mask;
                                                            let _e1554 = local.group_mask;
                                                            local.group_mask = (_e1554 & ~((1u << bitcast<u32>((_e1536 & 31u)))));
                                                            let _e1557 = local.group;
                                                            phi_1799_ = (_e1557 + countOneBits(((_e1540 & ~((4294967295u << bitcast<u32>((((_e1536 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_1799_ = 4294967295u;
                                                        }
                                                        let _e1560 = phi_1799_;
                                                        phi_1801_ = _e1560;
                                                        phi_1804_ = _e1041;
                                                        loop {
                                                            let _e1562 = phi_1801_;
                                                            let _e1564 = phi_1804_;
                                                            local_15 = _e1564;
                                                            if (_e1562 != 4294967295u) {
                                                                if (_e1562 < _e64) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1571 = nodes.member[(0u + _e1562)].frame[3u];
                                                                let _e1596 = (bitcast<f32>((((_e1571 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1322);
                                                                let _e1597 = (bitcast<f32>((((_e1571 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1332);
                                                                let _e1598 = (bitcast<f32>((((_e1571 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1342);
                                                                let _e1601 = nodes.member[(0u + _e1562)].frame[0u];
                                                                let _e1605 = nodes.member[(0u + _e1562)].frame[1u];
                                                                let _e1609 = nodes.member[(0u + _e1562)].frame[2u];
                                                                let _e1614 = ((bitcast<f32>(_e1601) - _e1121) * _e1322);
                                                                let _e1615 = ((bitcast<f32>(_e1605) - _e1134) * _e1332);
                                                                let _e1616 = ((bitcast<f32>(_e1609) - _e1147) * _e1342);
                                                                let _e1624 = nodes.member[(0u + _e1562)].x;
                                                                if (_e1322 < 0f) {
                                                                    let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1624.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.unnamed.root, _e1624.w), _e1635.unnamed_1);
                                                                    let _e1647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1641.unnamed, lt_bvh_traverse_Tree(_e1624.x, _e1641.unnamed_1.first_primitive));
                                                                    phi_1884_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1647.unnamed, lt_bvh_traverse_Tree(_e1647.unnamed_1.root, _e1624.y));
                                                                } else {
                                                                    let _e1663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1624.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.unnamed.root, _e1624.y), _e1663.unnamed_1);
                                                                    let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1669.unnamed, lt_bvh_traverse_Tree(_e1624.z, _e1669.unnamed_1.first_primitive));
                                                                    phi_1884_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1675.unnamed_1.root, _e1624.w));
                                                                }
                                                                let _e1683 = phi_1884_;
                                                                let _e1693 = nodes.member[(0u + _e1562)].y;
                                                                if (_e1332 < 0f) {
                                                                    let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1693.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1704.unnamed.root, _e1693.w), _e1704.unnamed_1);
                                                                    let _e1716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1710.unnamed, lt_bvh_traverse_Tree(_e1693.x, _e1710.unnamed_1.first_primitive));
                                                                    phi_1911_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1716.unnamed, lt_bvh_traverse_Tree(_e1716.unnamed_1.root, _e1693.y));
                                                                } else {
                                                                    let _e1732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1693.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.unnamed.root, _e1693.y), _e1732.unnamed_1);
                                                                    let _e1744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1738.unnamed, lt_bvh_traverse_Tree(_e1693.z, _e1738.unnamed_1.first_primitive));
                                                                    phi_1911_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1744.unnamed, lt_bvh_traverse_Tree(_e1744.unnamed_1.root, _e1693.w));
                                                                }
                                                                let _e1752 = phi_1911_;
                                                                let _e1762 = nodes.member[(0u + _e1562)].z;
                                                                if (_e1342 < 0f) {
                                                                    let _e1773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1762.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1773.unnamed.root, _e1762.w), _e1773.unnamed_1);
                                                                    let _e1785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1779.unnamed, lt_bvh_traverse_Tree(_e1762.x, _e1779.unnamed_1.first_primitive));
                                                                    phi_1938_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1785.unnamed, lt_bvh_traverse_Tree(_e1785.unnamed_1.root, _e1762.y));
                                                                } else {
                                                                    let _e1801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1762.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1801.unnamed.root, _e1762.y), _e1801.unnamed_1);
                                                                    let _e1813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1807.unnamed, lt_bvh_traverse_Tree(_e1762.z, _e1807.unnamed_1.first_primitive));
                                                                    phi_1938_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1813.unnamed, lt_bvh_traverse_Tree(_e1813.unnamed_1.root, _e1762.w));
                                                                }
                                                                let _e1821 = phi_1938_;
                                                                phi_1944_ = 0u;
                                                                phi_1947_ = 0u;
                                                                loop {
                                                                    let _e1831 = phi_1944_;
                                                                    let _e1833 = phi_1947_;
                                                                    local_6 = _e1833;
                                                                    local_7 = _e1833;
                                                                    local_8 = _e1833;
                                                                    let _e1834 = (_e1831 < 8u);
                                                                    if _e1834 {
                                                                        let _e1836 = (_e1831 >> bitcast<u32>(2i));
                                                                        let _e1837 = (_e1831 & 3u);
                                                                        if (_e1836 == 0u) {
                                                                            phi_1961_ = _e1683.unnamed.root;
                                                                        } else {
                                                                            phi_1961_ = _e1683.unnamed.first_primitive;
                                                                        }
                                                                        let _e1840 = phi_1961_;
                                                                        if (_e1836 == 0u) {
                                                                            phi_1971_ = _e1752.unnamed.root;
                                                                        } else {
                                                                            phi_1971_ = _e1752.unnamed.first_primitive;
                                                                        }
                                                                        let _e1849 = phi_1971_;
                                                                        if (_e1836 == 0u) {
                                                                            phi_1981_ = _e1821.unnamed.root;
                                                                        } else {
                                                                            phi_1981_ = _e1821.unnamed.first_primitive;
                                                                        }
                                                                        let _e1858 = phi_1981_;
                                                                        let _e1871 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1840 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u)) * _e1596) + (_e1614 - _e1374)), ((f32(((_e1849 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u)) * _e1597) + (_e1615 - _e1375)));
                                                                        let _e1872 = core_intrinsics_maximum_number_nsz_f32_(_e1871, ((f32(((_e1858 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u)) * _e1598) + (_e1616 - _e1376)));
                                                                        if (_e1836 == 0u) {
                                                                            phi_1999_ = _e1683.unnamed_1.root;
                                                                        } else {
                                                                            phi_1999_ = _e1683.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1875 = phi_1999_;
                                                                        if (_e1836 == 0u) {
                                                                            phi_2009_ = _e1752.unnamed_1.root;
                                                                        } else {
                                                                            phi_2009_ = _e1752.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1884 = phi_2009_;
                                                                        if (_e1836 == 0u) {
                                                                            phi_2019_ = _e1821.unnamed_1.root;
                                                                        } else {
                                                                            phi_2019_ = _e1821.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1893 = phi_2019_;
                                                                        let _e1906 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1875 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u)) * _e1596) + (_e1614 + _e1374)), ((f32(((_e1884 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u)) * _e1597) + (_e1615 + _e1375)));
                                                                        let _e1907 = core_intrinsics_minimum_number_nsz_f32_(_e1906, ((f32(((_e1893 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u)) * _e1598) + (_e1616 + _e1376)));
                                                                        if (_e1872 <= _e1907) {
                                                                            if (_e1872 <= _e251) {
                                                                                if (_e1907 >= 0f) {
                                                                                    if (_e1836 == 0u) {
                                                                                        let _e1914 = nodes.member[(0u + _e1562)].links[2u];
                                                                                        phi_2055_ = _e1914;
                                                                                    } else {
                                                                                        let _e1917 = nodes.member[(0u + _e1562)].links[3u];
                                                                                        phi_2055_ = _e1917;
                                                                                    }
                                                                                    let _e1919 = phi_2055_;
                                                                                    let _e1924 = ((_e1919 >> bitcast<u32>(((_e1837 * 8u) & 31u))) & 255u);
                                                                                    let _e1925 = (_e1924 & 31u);
                                                                                    if (_e1925 >= 24u) {
                                                                                        phi_2068_ = (24u + ((_e1925 - 24u) ^ _e1424));
                                                                                    } else {
                                                                                        phi_2068_ = _e1925;
                                                                                    }
                                                                                    let _e1931 = phi_2068_;
                                                                                    phi_2073_ = (_e1833 | ((_e1924 >> bitcast<u32>(5i)) << bitcast<u32>((_e1931 & 31u))));
                                                                                } else {
                                                                                    phi_2073_ = _e1833;
                                                                                }
                                                                                let _e1939 = phi_2073_;
                                                                                phi_2074_ = _e1939;
                                                                            } else {
                                                                                phi_2074_ = _e1833;
                                                                            }
                                                                            let _e1941 = phi_2074_;
                                                                            phi_2075_ = _e1941;
                                                                        } else {
                                                                            phi_2075_ = _e1833;
                                                                        }
                                                                        let _e1943 = phi_2075_;
                                                                        phi_1945_ = (_e1831 + 1u);
                                                                        phi_1948_ = _e1943;
                                                                    } else {
                                                                        phi_1945_ = u32();
                                                                        phi_1948_ = u32();
                                                                    }
                                                                    let _e1946 = phi_1945_;
                                                                    let _e1948 = phi_1948_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1944_ = _e1946;
                                                                        phi_1947_ = _e1948;
                                                                        break if !(_e1834);
                                                                    }
                                                                }
                                                                let _e1952 = nodes.member[(0u + _e1562)].links[0u];
                                                                let _e1956 = nodes.member[(0u + _e1562)].frame[3u];
                                                                let _e1960 = local_6;
                                                                if ((_e1960 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1964 = local.group_mask;
                                                                    if ((_e1964 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1968 = local.len;
                                                                        if (_e1968 < 32u) {
                                                                            let _e1971 = local.group;
                                                                            let _e1973 = local.len;
                                                                            if (_e1973 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.first[(0u + _e1973)] = _e1971;
                                                                            let _e1979 = local.group_mask;
                                                                            let _e1981 = local.len;
                                                                            if (_e1981 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.mask[(0u + _e1981)] = _e1979;
                                                                            let _e1988 = local.len;
                                                                            local.len = (_e1988 + 1u);
                                                                        }
                                                                    }
                                                                    local.group = (_e1190 + _e1952);
                                                                    let _e1992 = local_7;
                                                                    local.group_mask = ((_e1992 & 4278190080u) | (_e1956 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1997 = local_8;
                                                                phi_2133_ = (_e1997 & 16777215u);
                                                                phi_2136_ = _e1564;
                                                                loop {
                                                                    let _e2000 = phi_2133_;
                                                                    let _e2002 = phi_2136_;
                                                                    local_13 = _e2002;
                                                                    let _e2003 = (_e2000 == 0u);
                                                                    local_9 = _e2003;
                                                                    local_14 = _e2003;
                                                                    if _e2003 {
                                                                        phi_2134_ = u32();
                                                                        phi_2137_ = bool();
                                                                        phi_2734_ = false;
                                                                    } else {
                                                                        let _e2006 = nodes.member[(0u + _e1562)].links[1u];
                                                                        let _e2011 = ((_e1192 + _e2006) + select(firstTrailingBit(_e2000), 32u, (_e2000 == 0u)));
                                                                        if (_e2011 < arrayLength((&triangles.member))) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2018 = triangles.member[(0u + _e2011)].v0_;
                                                                        let _e2020 = (_e2018.x - _e1121);
                                                                        let _e2022 = (_e2018.y - _e1134);
                                                                        let _e2024 = (_e2018.z - _e1147);
                                                                        if (_e1397 == 0u) {
                                                                            phi_2181_ = vec3<f32>(_e2022, _e2024, _e2020);
                                                                        } else {
                                                                            if (_e1397 == 1u) {
                                                                                phi_2180_ = vec3<f32>(_e2024, _e2020, _e2022);
                                                                            } else {
                                                                                phi_2180_ = (_e2018 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                            }
                                                                            let _e2032 = phi_2180_;
                                                                            phi_2181_ = _e2032;
                                                                        }
                                                                        let _e2034 = phi_2181_;
                                                                        let _e2038 = (_e2034.x - (_e1408 * _e2034.z));
                                                                        let _e2042 = (_e2034.y - (_e1411 * _e2034.z));
                                                                        let _e2044 = triangles.member[(0u + _e2011)].v1_;
                                                                        let _e2046 = (_e2044.x - _e1121);
                                                                        let _e2048 = (_e2044.y - _e1134);
                                                                        let _e2050 = (_e2044.z - _e1147);
                                                                        if (_e1397 == 0u) {
                                                                            phi_2211_ = vec3<f32>(_e2048, _e2050, _e2046);
                                                                        } else {
                                                                            if (_e1397 == 1u) {
                                                                                phi_2210_ = vec3<f32>(_e2050, _e2046, _e2048);
                                                                            } else {
                                                                                phi_2210_ = (_e2044 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                            }
                                                                            let _e2058 = phi_2210_;
                                                                            phi_2211_ = _e2058;
                                                                        }
                                                                        let _e2060 = phi_2211_;
                                                                        let _e2064 = (_e2060.x - (_e1408 * _e2060.z));
                                                                        let _e2068 = (_e2060.y - (_e1411 * _e2060.z));
                                                                        let _e2070 = triangles.member[(0u + _e2011)].v2_;
                                                                        let _e2072 = (_e2070.x - _e1121);
                                                                        let _e2074 = (_e2070.y - _e1134);
                                                                        let _e2076 = (_e2070.z - _e1147);
                                                                        if (_e1397 == 0u) {
                                                                            phi_2241_ = vec3<f32>(_e2074, _e2076, _e2072);
                                                                        } else {
                                                                            if (_e1397 == 1u) {
                                                                                phi_2240_ = vec3<f32>(_e2076, _e2072, _e2074);
                                                                            } else {
                                                                                phi_2240_ = (_e2070 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                            }
                                                                            let _e2084 = phi_2240_;
                                                                            phi_2241_ = _e2084;
                                                                        }
                                                                        let _e2086 = phi_2241_;
                                                                        let _e2090 = (_e2086.x - (_e1408 * _e2086.z));
                                                                        let _e2094 = (_e2086.y - (_e1411 * _e2086.z));
                                                                        if (_e2064 < _e2090) {
                                                                            phi_2260_ = true;
                                                                        } else {
                                                                            if (_e2064 == _e2090) {
                                                                                phi_2259_ = (_e2068 < _e2094);
                                                                            } else {
                                                                                phi_2259_ = false;
                                                                            }
                                                                            let _e2099 = phi_2259_;
                                                                            phi_2260_ = _e2099;
                                                                        }
                                                                        let _e2101 = phi_2260_;
                                                                        if _e2101 {
                                                                            phi_2264_ = _e2094;
                                                                            phi_2265_ = _e2090;
                                                                            phi_2266_ = _e2068;
                                                                            phi_2267_ = _e2064;
                                                                        } else {
                                                                            phi_2264_ = _e2068;
                                                                            phi_2265_ = _e2064;
                                                                            phi_2266_ = _e2094;
                                                                            phi_2267_ = _e2090;
                                                                        }
                                                                        let _e2103 = phi_2264_;
                                                                        let _e2105 = phi_2265_;
                                                                        let _e2107 = phi_2266_;
                                                                        let _e2109 = phi_2267_;
                                                                        let _e2112 = ((_e2109 * _e2103) - (_e2107 * _e2105));
                                                                        if _e2101 {
                                                                            phi_2275_ = -(_e2112);
                                                                        } else {
                                                                            phi_2275_ = _e2112;
                                                                        }
                                                                        let _e2115 = phi_2275_;
                                                                        if (_e2090 < _e2038) {
                                                                            phi_2286_ = true;
                                                                        } else {
                                                                            if (_e2090 == _e2038) {
                                                                                phi_2285_ = (_e2094 < _e2042);
                                                                            } else {
                                                                                phi_2285_ = false;
                                                                            }
                                                                            let _e2120 = phi_2285_;
                                                                            phi_2286_ = _e2120;
                                                                        }
                                                                        let _e2122 = phi_2286_;
                                                                        if _e2122 {
                                                                            phi_2290_ = _e2042;
                                                                            phi_2291_ = _e2038;
                                                                            phi_2292_ = _e2094;
                                                                            phi_2293_ = _e2090;
                                                                        } else {
                                                                            phi_2290_ = _e2094;
                                                                            phi_2291_ = _e2090;
                                                                            phi_2292_ = _e2042;
                                                                            phi_2293_ = _e2038;
                                                                        }
                                                                        let _e2124 = phi_2290_;
                                                                        let _e2126 = phi_2291_;
                                                                        let _e2128 = phi_2292_;
                                                                        let _e2130 = phi_2293_;
                                                                        let _e2133 = ((_e2130 * _e2124) - (_e2128 * _e2126));
                                                                        if _e2122 {
                                                                            phi_2301_ = -(_e2133);
                                                                        } else {
                                                                            phi_2301_ = _e2133;
                                                                        }
                                                                        let _e2136 = phi_2301_;
                                                                        if (_e2038 < _e2064) {
                                                                            phi_2312_ = true;
                                                                        } else {
                                                                            if (_e2038 == _e2064) {
                                                                                phi_2311_ = (_e2042 < _e2068);
                                                                            } else {
                                                                                phi_2311_ = false;
                                                                            }
                                                                            let _e2141 = phi_2311_;
                                                                            phi_2312_ = _e2141;
                                                                        }
                                                                        let _e2143 = phi_2312_;
                                                                        if _e2143 {
                                                                            phi_2316_ = _e2068;
                                                                            phi_2317_ = _e2064;
                                                                            phi_2318_ = _e2042;
                                                                            phi_2319_ = _e2038;
                                                                        } else {
                                                                            phi_2316_ = _e2042;
                                                                            phi_2317_ = _e2038;
                                                                            phi_2318_ = _e2068;
                                                                            phi_2319_ = _e2064;
                                                                        }
                                                                        let _e2145 = phi_2316_;
                                                                        let _e2147 = phi_2317_;
                                                                        let _e2149 = phi_2318_;
                                                                        let _e2151 = phi_2319_;
                                                                        let _e2154 = ((_e2151 * _e2145) - (_e2149 * _e2147));
                                                                        if _e2143 {
                                                                            phi_2327_ = -(_e2154);
                                                                        } else {
                                                                            phi_2327_ = _e2154;
                                                                        }
                                                                        let _e2157 = phi_2327_;
                                                                        if (_e2115 >= 0f) {
                                                                            if (_e2136 >= 0f) {
                                                                                if (_e2157 >= 0f) {
                                                                                    phi_2342_ = ((_e2115 + _e2136) + _e2157);
                                                                                    phi_2343_ = false;
                                                                                } else {
                                                                                    phi_2342_ = f32();
                                                                                    phi_2343_ = true;
                                                                                }
                                                                                let _e2164 = phi_2342_;
                                                                                let _e2166 = phi_2343_;
                                                                                phi_2344_ = _e2164;
                                                                                phi_2345_ = _e2166;
                                                                            } else {
                                                                                phi_2344_ = f32();
                                                                                phi_2345_ = true;
                                                                            }
                                                                            let _e2168 = phi_2344_;
                                                                            let _e2170 = phi_2345_;
                                                                            phi_2346_ = _e2168;
                                                                            phi_2347_ = _e2170;
                                                                        } else {
                                                                            phi_2346_ = f32();
                                                                            phi_2347_ = true;
                                                                        }
                                                                        let _e2172 = phi_2346_;
                                                                        let _e2174 = phi_2347_;
                                                                        if _e2174 {
                                                                            if (_e2115 <= 0f) {
                                                                                if (_e2136 <= 0f) {
                                                                                    let _e2177 = (_e2157 <= 0f);
                                                                                    if _e2177 {
                                                                                    }
                                                                                    phi_2365_ = ((_e2115 + _e2136) + _e2157);
                                                                                    phi_2366_ = false;
                                                                                    phi_2367_ = _e2177;
                                                                                } else {
                                                                                    phi_2365_ = f32();
                                                                                    phi_2366_ = true;
                                                                                    phi_2367_ = false;
                                                                                }
                                                                                let _e2181 = phi_2365_;
                                                                                let _e2183 = phi_2366_;
                                                                                let _e2185 = phi_2367_;
                                                                                phi_2368_ = _e2181;
                                                                                phi_2369_ = _e2183;
                                                                                phi_2370_ = _e2185;
                                                                            } else {
                                                                                phi_2368_ = f32();
                                                                                phi_2369_ = true;
                                                                                phi_2370_ = false;
                                                                            }
                                                                            let _e2187 = phi_2368_;
                                                                            let _e2189 = phi_2369_;
                                                                            let _e2191 = phi_2370_;
                                                                            if _e2189 {
                                                                                phi_2374_ = false;
                                                                            } else {
                                                                                phi_2374_ = _e2191;
                                                                            }
                                                                            let _e2193 = phi_2374_;
                                                                            phi_2375_ = _e2187;
                                                                            phi_2376_ = _e2193;
                                                                        } else {
                                                                            phi_2375_ = _e2172;
                                                                            phi_2376_ = true;
                                                                        }
                                                                        let _e2195 = phi_2375_;
                                                                        let _e2197 = phi_2376_;
                                                                        if _e2197 {
                                                                            let _e2198 = (_e2195 == 0f);
                                                                            if _e2198 {
                                                                                phi_2692_ = lt_bvh_triangle_Intersection();
                                                                                phi_2693_ = false;
                                                                            } else {
                                                                                let _e2200 = triangles.member[(0u + _e2011)].v0_;
                                                                                let _e2202 = (_e2200.x - _e1121);
                                                                                let _e2204 = (_e2200.y - _e1134);
                                                                                let _e2206 = (_e2200.z - _e1147);
                                                                                if (_e1397 == 0u) {
                                                                                    phi_2405_ = vec3<f32>(_e2204, _e2206, _e2202);
                                                                                } else {
                                                                                    if (_e1397 == 1u) {
                                                                                        phi_2404_ = vec3<f32>(_e2206, _e2202, _e2204);
                                                                                    } else {
                                                                                        phi_2404_ = (_e2200 - vec3<f32>(_e1121, _e1134, _e1147));
                                                                                    }
                                                                                    let _e2214 = phi_2404_;
                                                                                    phi_2405_ = _e2214;
                                                                                }
                                                                                let _e2216 = phi_2405_;
                                                                                let _e2218 = triangles.member[(0u + _e2011)].v1_;
                                                                                let _e2220 = triangles.member[(0u + _e2011)].v0_;
                                                                                let _e2223 = (_e2218.x - _e2220.x);
                                                                                let _e2226 = (_e2218.y - _e2220.y);
                                                                                let _e2229 = (_e2218.z - _e2220.z);
                                                                                if (_e1397 == 0u) {
                                                                                    phi_2431_ = vec3<f32>(_e2226, _e2229, _e2223);
                                                                                } else {
                                                                                    if (_e1397 == 1u) {
                                                                                        phi_2430_ = vec3<f32>(_e2229, _e2223, _e2226);
                                                                                    } else {
                                                                                        phi_2430_ = (_e2218 - _e2220);
                                                                                    }
                                                                                    let _e2236 = phi_2430_;
                                                                                    phi_2431_ = _e2236;
                                                                                }
                                                                                let _e2238 = phi_2431_;
                                                                                let _e2240 = triangles.member[(0u + _e2011)].v2_;
                                                                                let _e2242 = triangles.member[(0u + _e2011)].v0_;
                                                                                let _e2245 = (_e2240.x - _e2242.x);
                                                                                let _e2248 = (_e2240.y - _e2242.y);
                                                                                let _e2251 = (_e2240.z - _e2242.z);
                                                                                if (_e1397 == 0u) {
                                                                                    phi_2457_ = vec3<f32>(_e2248, _e2251, _e2245);
                                                                                } else {
                                                                                    if (_e1397 == 1u) {
                                                                                        phi_2456_ = vec3<f32>(_e2251, _e2245, _e2248);
                                                                                    } else {
                                                                                        phi_2456_ = (_e2240 - _e2242);
                                                                                    }
                                                                                    let _e2258 = phi_2456_;
                                                                                    phi_2457_ = _e2258;
                                                                                }
                                                                                let _e2260 = phi_2457_;
                                                                                let _e2267 = ((_e2238.y * _e2260.z) - (_e2238.z * _e2260.y));
                                                                                let _e2274 = ((_e2238.z * _e2260.x) - (_e2238.x * _e2260.z));
                                                                                let _e2281 = ((_e2238.x * _e2260.y) - (_e2238.y * _e2260.x));
                                                                                let _e2295 = (((1f / _e1405.z) * (((_e2267 * _e2216.x) + (_e2274 * _e2216.y)) + (_e2281 * _e2216.z))) / (((_e2267 * _e1408) + (_e2274 * _e1411)) + _e2281));
                                                                                if (_e2295 > 0f) {
                                                                                    if (_e2295 < _e251) {
                                                                                        let _e2299 = triangles.member[(0u + _e2011)].v0_;
                                                                                        let _e2301 = triangles.member[(0u + _e2011)].v1_;
                                                                                        if (_e2299.x < _e2301.x) {
                                                                                            phi_2513_ = _e2299.x;
                                                                                        } else {
                                                                                            phi_2513_ = _e2301.x;
                                                                                        }
                                                                                        let _e2308 = phi_2513_;
                                                                                        if (_e2299.y < _e2301.y) {
                                                                                            phi_2522_ = _e2299.y;
                                                                                        } else {
                                                                                            phi_2522_ = _e2301.y;
                                                                                        }
                                                                                        let _e2315 = phi_2522_;
                                                                                        if (_e2299.z < _e2301.z) {
                                                                                            phi_2531_ = _e2299.z;
                                                                                        } else {
                                                                                            phi_2531_ = _e2301.z;
                                                                                        }
                                                                                        let _e2322 = phi_2531_;
                                                                                        let _e2324 = triangles.member[(0u + _e2011)].v2_;
                                                                                        if (_e2308 < _e2324.x) {
                                                                                            phi_2540_ = _e2308;
                                                                                        } else {
                                                                                            phi_2540_ = _e2324.x;
                                                                                        }
                                                                                        let _e2329 = phi_2540_;
                                                                                        if (_e2315 < _e2324.y) {
                                                                                            phi_2547_ = _e2315;
                                                                                        } else {
                                                                                            phi_2547_ = _e2324.y;
                                                                                        }
                                                                                        let _e2334 = phi_2547_;
                                                                                        if (_e2322 < _e2324.z) {
                                                                                            phi_2554_ = _e2322;
                                                                                        } else {
                                                                                            phi_2554_ = _e2324.z;
                                                                                        }
                                                                                        let _e2339 = phi_2554_;
                                                                                        let _e2341 = triangles.member[(0u + _e2011)].v0_;
                                                                                        let _e2343 = triangles.member[(0u + _e2011)].v1_;
                                                                                        if (_e2341.x > _e2343.x) {
                                                                                            phi_2567_ = _e2341.x;
                                                                                        } else {
                                                                                            phi_2567_ = _e2343.x;
                                                                                        }
                                                                                        let _e2350 = phi_2567_;
                                                                                        if (_e2341.y > _e2343.y) {
                                                                                            phi_2576_ = _e2341.y;
                                                                                        } else {
                                                                                            phi_2576_ = _e2343.y;
                                                                                        }
                                                                                        let _e2357 = phi_2576_;
                                                                                        if (_e2341.z > _e2343.z) {
                                                                                            phi_2585_ = _e2341.z;
                                                                                        } else {
                                                                                            phi_2585_ = _e2343.z;
                                                                                        }
                                                                                        let _e2364 = phi_2585_;
                                                                                        let _e2366 = triangles.member[(0u + _e2011)].v2_;
                                                                                        if (_e2350 > _e2366.x) {
                                                                                            phi_2594_ = _e2350;
                                                                                        } else {
                                                                                            phi_2594_ = _e2366.x;
                                                                                        }
                                                                                        let _e2371 = phi_2594_;
                                                                                        if (_e2357 > _e2366.y) {
                                                                                            phi_2601_ = _e2357;
                                                                                        } else {
                                                                                            phi_2601_ = _e2366.y;
                                                                                        }
                                                                                        let _e2376 = phi_2601_;
                                                                                        if (_e2364 > _e2366.z) {
                                                                                            phi_2608_ = _e2364;
                                                                                        } else {
                                                                                            phi_2608_ = _e2366.z;
                                                                                        }
                                                                                        let _e2381 = phi_2608_;
                                                                                        let _e2385 = ((_e2329 - _e1121) * _e1322);
                                                                                        let _e2386 = ((_e2334 - _e1134) * _e1332);
                                                                                        let _e2387 = ((_e2339 - _e1147) * _e1342);
                                                                                        let _e2391 = ((_e2371 - _e1121) * _e1322);
                                                                                        let _e2392 = ((_e2376 - _e1134) * _e1332);
                                                                                        let _e2393 = ((_e2381 - _e1147) * _e1342);
                                                                                        if (_e2385 < _e2391) {
                                                                                            phi_2625_ = _e2385;
                                                                                        } else {
                                                                                            phi_2625_ = _e2391;
                                                                                        }
                                                                                        let _e2396 = phi_2625_;
                                                                                        if (_e2386 < _e2392) {
                                                                                            phi_2630_ = _e2386;
                                                                                        } else {
                                                                                            phi_2630_ = _e2392;
                                                                                        }
                                                                                        let _e2399 = phi_2630_;
                                                                                        if (_e2387 < _e2393) {
                                                                                            phi_2635_ = _e2387;
                                                                                        } else {
                                                                                            phi_2635_ = _e2393;
                                                                                        }
                                                                                        let _e2402 = phi_2635_;
                                                                                        if (_e2385 > _e2391) {
                                                                                            phi_2643_ = _e2385;
                                                                                        } else {
                                                                                            phi_2643_ = _e2391;
                                                                                        }
                                                                                        let _e2408 = phi_2643_;
                                                                                        if (_e2386 > _e2392) {
                                                                                            phi_2648_ = _e2386;
                                                                                        } else {
                                                                                            phi_2648_ = _e2392;
                                                                                        }
                                                                                        let _e2411 = phi_2648_;
                                                                                        if (_e2387 > _e2393) {
                                                                                            phi_2653_ = _e2387;
                                                                                        } else {
                                                                                            phi_2653_ = _e2393;
                                                                                        }
                                                                                        let _e2414 = phi_2653_;
                                                                                        let _e2418 = core_intrinsics_maximum_number_nsz_f32_((_e2396 - _e1381), (_e2399 - _e1382));
                                                                                        let _e2419 = core_intrinsics_maximum_number_nsz_f32_(_e2418, (_e2402 - _e1383));
                                                                                        let _e2420 = core_intrinsics_minimum_number_nsz_f32_((_e2408 + _e1381), (_e2411 + _e1382));
                                                                                        let _e2421 = core_intrinsics_minimum_number_nsz_f32_(_e2420, (_e2414 + _e1383));
                                                                                        if (_e2419 > _e1102) {
                                                                                            phi_2665_ = _e2419;
                                                                                        } else {
                                                                                            phi_2665_ = _e1102;
                                                                                        }
                                                                                        let _e2424 = phi_2665_;
                                                                                        if (_e2421 < _e1104) {
                                                                                            phi_2670_ = _e2421;
                                                                                        } else {
                                                                                            phi_2670_ = _e1104;
                                                                                        }
                                                                                        let _e2427 = phi_2670_;
                                                                                        if (_e2295 < _e2424) {
                                                                                            phi_2675_ = _e2424;
                                                                                        } else {
                                                                                            phi_2675_ = _e2295;
                                                                                        }
                                                                                        let _e2430 = phi_2675_;
                                                                                        if (_e2430 > _e2427) {
                                                                                            phi_2680_ = _e2427;
                                                                                        } else {
                                                                                            phi_2680_ = _e2430;
                                                                                        }
                                                                                        let _e2433 = phi_2680_;
                                                                                        phi_2685_ = lt_bvh_triangle_Intersection(_e2433, (_e2136 / _e2195), (_e2157 / _e2195), (_e2424 <= _e2427));
                                                                                        phi_2686_ = false;
                                                                                    } else {
                                                                                        phi_2685_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2686_ = true;
                                                                                    }
                                                                                    let _e2439 = phi_2685_;
                                                                                    let _e2441 = phi_2686_;
                                                                                    phi_2687_ = _e2439;
                                                                                    phi_2688_ = _e2441;
                                                                                } else {
                                                                                    phi_2687_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2688_ = true;
                                                                                }
                                                                                let _e2443 = phi_2687_;
                                                                                let _e2445 = phi_2688_;
                                                                                if _e2445 {
                                                                                }
                                                                                phi_2692_ = _e2443;
                                                                                phi_2693_ = _e2445;
                                                                            }
                                                                            let _e2447 = phi_2692_;
                                                                            let _e2449 = phi_2693_;
                                                                            phi_2694_ = _e2447;
                                                                            phi_2695_ = _e2198;
                                                                            phi_2696_ = _e2449;
                                                                        } else {
                                                                            phi_2694_ = lt_bvh_triangle_Intersection();
                                                                            phi_2695_ = true;
                                                                            phi_2696_ = false;
                                                                        }
                                                                        let _e2451 = phi_2694_;
                                                                        let _e2453 = phi_2695_;
                                                                        let _e2455 = phi_2696_;
                                                                        if _e2453 {
                                                                            phi_2700_ = true;
                                                                        } else {
                                                                            phi_2700_ = _e2455;
                                                                        }
                                                                        let _e2457 = phi_2700_;
                                                                        if _e2457 {
                                                                            phi_2704_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2704_ = _e2451;
                                                                        }
                                                                        let _e2459 = phi_2704_;
                                                                        if _e2459.is_hit {
                                                                            if (_e2459.t > 0f) {
                                                                                if (_e2459.t < _e251) {
                                                                                    if true {
                                                                                        phi_2724_ = false;
                                                                                    } else {
                                                                                        phi_2724_ = true;
                                                                                    }
                                                                                    let _e2468 = phi_2724_;
                                                                                    phi_2725_ = true;
                                                                                    phi_2726_ = _e2468;
                                                                                } else {
                                                                                    phi_2725_ = _e2002;
                                                                                    phi_2726_ = true;
                                                                                }
                                                                                let _e2470 = phi_2725_;
                                                                                let _e2472 = phi_2726_;
                                                                                phi_2727_ = _e2470;
                                                                                phi_2728_ = _e2472;
                                                                            } else {
                                                                                phi_2727_ = _e2002;
                                                                                phi_2728_ = true;
                                                                            }
                                                                            let _e2474 = phi_2727_;
                                                                            let _e2476 = phi_2728_;
                                                                            phi_2729_ = _e2474;
                                                                            phi_2730_ = _e2476;
                                                                        } else {
                                                                            phi_2729_ = _e2002;
                                                                            phi_2730_ = true;
                                                                        }
                                                                        let _e2478 = phi_2729_;
                                                                        let _e2480 = phi_2730_;
                                                                        if _e2480 {
                                                                        }
                                                                        phi_2134_ = (_e2000 & (_e2000 - 1u));
                                                                        phi_2137_ = _e2478;
                                                                        phi_2734_ = _e2480;
                                                                    }
                                                                    let _e2482 = phi_2134_;
                                                                    let _e2484 = phi_2137_;
                                                                    let _e2486 = phi_2734_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2133_ = _e2482;
                                                                        phi_2136_ = _e2484;
                                                                        break if !(_e2486);
                                                                    }
                                                                }
                                                                let _e2489 = local_9;
                                                                if _e2489 {
                                                                    let _e2491 = local.group_mask;
                                                                    if ((_e2491 & 4278190080u) == 0u) {
                                                                        let _e2495 = local.len;
                                                                        if (_e2495 == 0u) {
                                                                            phi_2776_ = false;
                                                                        } else {
                                                                            let _e2499 = local.len;
                                                                            local.len = (_e2499 - 1u);
                                                                            let _e2502 = local.len;
                                                                            if (_e2502 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2507 = local.first[(0u + _e2502)];
                                                                            local.group = _e2507;
                                                                            let _e2510 = local.len;
                                                                            if (_e2510 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2515 = local.mask[(0u + _e2510)];
                                                                            local.group_mask = _e2515;
                                                                            phi_2776_ = true;
                                                                        }
                                                                        let _e2518 = phi_2776_;
                                                                        phi_2777_ = _e2518;
                                                                    } else {
                                                                        phi_2777_ = true;
                                                                    }
                                                                    let _e2520 = phi_2777_;
                                                                    if _e2520 {
                                                                        let _e2522 = local.group_mask;
                                                                        let _e2528 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2522)), 32u, (_e2522 == 0u)));
                                                                        let _e2532 = local.group_mask;
                                                                        let _e2546 = local.group_mask;
                                                                        local.group_mask = (_e2546 & ~((1u << bitcast<u32>((_e2528 & 31u)))));
                                                                        let _e2549 = local.group;
                                                                        phi_2808_ = (_e2549 + countOneBits(((_e2532 & ~((4294967295u << bitcast<u32>((((_e2528 - 24u) ^ _e1424) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2808_ = 4294967295u;
                                                                    }
                                                                    let _e2552 = phi_2808_;
                                                                    phi_2809_ = _e2552;
                                                                } else {
                                                                    phi_2809_ = u32();
                                                                }
                                                                let _e2554 = phi_2809_;
                                                                phi_1802_ = _e2554;
                                                                let _e2940 = local_13;
                                                                phi_1805_ = _e2940;
                                                                let _e2943 = local_14;
                                                                phi_2810_ = _e2943;
                                                                phi_2811_ = false;
                                                            } else {
                                                                phi_1802_ = u32();
                                                                phi_1805_ = bool();
                                                                phi_2810_ = false;
                                                                phi_2811_ = true;
                                                            }
                                                            let _e2556 = phi_1802_;
                                                            let _e2558 = phi_1805_;
                                                            let _e2560 = phi_2810_;
                                                            let _e2562 = phi_2811_;
                                                            local_10 = _e2562;
                                                            continue;
                                                            continuing {
                                                                phi_1801_ = _e2556;
                                                                phi_1804_ = _e2558;
                                                                break if !(_e2560);
                                                            }
                                                        }
                                                        let _e2565 = local_10;
                                                        if _e2565 {
                                                            phi_2815_ = false;
                                                        } else {
                                                            phi_2815_ = true;
                                                        }
                                                        let _e2567 = phi_2815_;
                                                        if _e2567 {
                                                            phi_2819_ = true;
                                                        } else {
                                                            let _e2949 = local_15;
                                                            phi_2819_ = _e2949;
                                                        }
                                                        let _e2569 = phi_2819_;
                                                        phi_2820_ = _e2569;
                                                    }
                                                    let _e2571 = phi_2820_;
                                                    phi_2821_ = _e2571;
                                                    phi_2822_ = _e1246;
                                                } else {
                                                    phi_2821_ = bool();
                                                    phi_2822_ = true;
                                                }
                                                let _e2573 = phi_2821_;
                                                let _e2575 = phi_2822_;
                                                if _e2575 {
                                                    phi_2826_ = _e1041;
                                                } else {
                                                    phi_2826_ = _e2573;
                                                }
                                                let _e2577 = phi_2826_;
                                                if _e2577 {
                                                    phi_2830_ = false;
                                                } else {
                                                    phi_2830_ = true;
                                                }
                                                let _e2579 = phi_2830_;
                                                phi_2831_ = _e2577;
                                                phi_2832_ = _e2579;
                                            } else {
                                                phi_2831_ = _e1041;
                                                phi_2832_ = true;
                                            }
                                            let _e2581 = phi_2831_;
                                            let _e2583 = phi_2832_;
                                            phi_2833_ = _e2581;
                                            phi_2834_ = _e2583;
                                        } else {
                                            phi_2833_ = _e1041;
                                            phi_2834_ = true;
                                        }
                                        let _e2585 = phi_2833_;
                                        let _e2587 = phi_2834_;
                                        phi_2835_ = _e2585;
                                        phi_2836_ = _e2587;
                                    } else {
                                        phi_2835_ = _e1041;
                                        phi_2836_ = true;
                                    }
                                    let _e2589 = phi_2835_;
                                    let _e2591 = phi_2836_;
                                    if _e2591 {
                                    }
                                    phi_1187_ = (_e1039 & (_e1039 - 1u));
                                    phi_1190_ = _e2589;
                                    phi_2840_ = _e2591;
                                }
                                let _e2593 = phi_1187_;
                                let _e2595 = phi_1190_;
                                let _e2597 = phi_2840_;
                                continue;
                                continuing {
                                    phi_1186_ = _e2593;
                                    phi_1189_ = _e2595;
                                    break if !(_e2597);
                                }
                            }
                            let _e2600 = local_11;
                            if _e2600 {
                                let _e2602 = local_1.group_mask;
                                if ((_e2602 & 4278190080u) == 0u) {
                                    let _e2606 = local_1.len;
                                    if (_e2606 == 0u) {
                                        phi_2882_ = false;
                                    } else {
                                        let _e2610 = local_1.len;
                                        local_1.len = (_e2610 - 1u);
                                        let _e2613 = local_1.len;
                                        if (_e2613 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2618 = local_1.first[(0u + _e2613)];
                                        local_1.group = _e2618;
                                        let _e2621 = local_1.len;
                                        if (_e2621 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2626 = local_1.mask[(0u + _e2621)];
                                        local_1.group_mask = _e2626;
                                        phi_2882_ = true;
                                    }
                                    let _e2629 = phi_2882_;
                                    phi_2883_ = _e2629;
                                } else {
                                    phi_2883_ = true;
                                }
                                let _e2631 = phi_2883_;
                                if _e2631 {
                                    let _e2633 = local_1.group_mask;
                                    let _e2639 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2633)), 32u, (_e2633 == 0u)));
                                    let _e2643 = local_1.group_mask;
                                    let _e2657 = local_1.group_mask;
                                    local_1.group_mask = (_e2657 & ~((1u << bitcast<u32>((_e2639 & 31u)))));
                                    let _e2660 = local_1.group;
                                    phi_2914_ = (_e2660 + countOneBits(((_e2643 & ~((4294967295u << bitcast<u32>((((_e2639 - 24u) ^ _e463) & 31u))))) & 255u)));
                                } else {
                                    phi_2914_ = 4294967295u;
                                }
                                let _e2663 = phi_2914_;
                                phi_2915_ = _e2663;
                            } else {
                                phi_2915_ = u32();
                            }
                            let _e2665 = phi_2915_;
                            phi_855_ = _e2665;
                            let _e2972 = local_16;
                            phi_858_ = _e2972;
                            let _e2975 = local_17;
                            phi_2916_ = _e2975;
                            phi_2917_ = false;
                        } else {
                            phi_855_ = u32();
                            phi_858_ = bool();
                            phi_2916_ = false;
                            phi_2917_ = true;
                        }
                        let _e2667 = phi_855_;
                        let _e2669 = phi_858_;
                        let _e2671 = phi_2916_;
                        let _e2673 = phi_2917_;
                        local_12 = _e2673;
                        continue;
                        continuing {
                            phi_854_ = _e2667;
                            phi_857_ = _e2669;
                            break if !(_e2671);
                        }
                    }
                    let _e2676 = local_12;
                    if _e2676 {
                        phi_2921_ = false;
                    } else {
                        phi_2921_ = true;
                    }
                    let _e2678 = phi_2921_;
                    if _e2678 {
                    }
                    phi_2925_ = _e2678;
                }
                let _e2680 = phi_2925_;
                phi_2926_ = _e315;
                phi_2927_ = _e2680;
            } else {
                phi_2926_ = true;
                phi_2927_ = false;
            }
            let _e2682 = phi_2926_;
            let _e2684 = phi_2927_;
            if _e2682 {
                phi_2931_ = false;
                phi_2932_ = true;
            } else {
                phi_2931_ = true;
                phi_2932_ = _e2684;
            }
            let _e2686 = phi_2931_;
            let _e2688 = phi_2932_;
            if _e2688 {
                phi_2936_ = _e2686;
            } else {
                phi_2936_ = false;
            }
            let _e2690 = phi_2936_;
            if _e2690 {
                phi_2940_ = 0f;
            } else {
                phi_2940_ = 1f;
            }
            let _e2692 = phi_2940_;
            phi_2941_ = _e2692;
        }
        let _e2694 = phi_2941_;
        if (_e79.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.first_primitive)] = _e2694;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
