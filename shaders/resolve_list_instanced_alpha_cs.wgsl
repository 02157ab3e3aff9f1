struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
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

struct type_9 {
    member: array<lt_bvh_Triangle>,
}

struct type_13 {
    member: array<abi_Vertex>,
}

struct abi_Material {
    base_color: vec4<f32>,
    cutoff: f32,
    flags: u32,
    alpha_offset: u32,
    alpha_size: u32,
    color_offset: u32,
    color_size: u32,
    pad: vec2<u32>,
}

struct type_18 {
    member: array<abi_Material>,
}

struct type_22 {
    member: array<u32>,
}

struct texture_TexelQuad {
    indices: array<u32, 4>,
    weights: vec4<f32>,
}

struct texture_Axis {
    low: u32,
    high: u32,
    fraction: f32,
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

struct type_42 {
    member: array<lt_bvh_Instance>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_51 {
    member: array<abi_Sample>,
}

struct type_55 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_63 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
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

struct type_69 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_51;
@group(0) @binding(6) 
var<storage> instances: type_42;
@group(0) @binding(0) 
var<uniform> p: type_69;
@group(0) @binding(2) 
var<storage> nodes: type_63;
@group(0) @binding(3) 
var<storage> triangles: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_55;
@group(0) @binding(5) 
var<storage> list: type_22;
@group(0) @binding(7) 
var<storage> vertices: type_13;
@group(0) @binding(8) 
var<storage> materials: type_18;
@group(0) @binding(9) 
var<storage> alpha_texels: type_22;

fn lt_shaders_texture_unorm_bytes(param: u32) -> vec4<f32> {
    let _e75 = (1f / 255f);
    return vec4<f32>((f32((param & 255u)) * _e75), (f32(((param >> bitcast<u32>(8i)) & 255u)) * _e75), (f32(((param >> bitcast<u32>(16i)) & 255u)) * _e75), (f32((param >> bitcast<u32>(24i))) * _e75));
}

fn lt_shaders_surface_vertex_color(param_1: ptr<function, array<abi_Vertex, 3>>, param_2: vec3<f32>) -> vec4<f32> {
    let _e65 = (*param_1)[0u].color;
    let _e66 = lt_shaders_texture_unorm_bytes(_e65);
    let _e78 = (*param_1)[1u].color;
    let _e79 = lt_shaders_texture_unorm_bytes(_e78);
    let _e95 = (*param_1)[2u].color;
    let _e96 = lt_shaders_texture_unorm_bytes(_e95);
    return vec4<f32>((((_e66.x * param_2.x) + (_e79.x * param_2.y)) + (_e96.x * param_2.z)), (((_e66.y * param_2.x) + (_e79.y * param_2.y)) + (_e96.y * param_2.z)), (((_e66.z * param_2.x) + (_e79.z * param_2.y)) + (_e96.z * param_2.z)), (((_e66.w * param_2.x) + (_e79.w * param_2.y)) + (_e96.w * param_2.z)));
}

fn lt_shaders_surface_texture_coordinate(param_3: ptr<function, array<abi_Vertex, 3>>, param_4: vec3<f32>) -> vec2<f32> {
    let _e65 = (*param_3)[0u].u;
    let _e68 = (*param_3)[0u].v;
    let _e74 = (*param_3)[1u].u;
    let _e77 = (*param_3)[1u].v;
    let _e85 = (*param_3)[2u].u;
    let _e88 = (*param_3)[2u].v;
    return vec2<f32>((((_e65 * param_4.x) + (_e74 * param_4.y)) + (_e85 * param_4.z)), (((_e68 * param_4.x) + (_e77 * param_4.y)) + (_e88 * param_4.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_5: f32, param_6: u32) -> f32 {
    var phi_469_: f32;
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_481_: f32;

    if (param_6 == 0u) {
        phi_471_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e70 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e70 > 1f) {
                phi_469_ = (2f - _e70);
            } else {
                phi_469_ = _e70;
            }
            let _e74 = phi_469_;
            phi_470_ = _e74;
        } else {
            phi_470_ = param_5;
        }
        let _e76 = phi_470_;
        phi_471_ = _e76;
    }
    let _e78 = phi_471_;
    if (_e78 > 0f) {
        if (_e78 < 1f) {
            phi_480_ = _e78;
        } else {
            phi_480_ = 1f;
        }
        let _e82 = phi_480_;
        phi_481_ = _e82;
    } else {
        phi_481_ = 0f;
    }
    let _e84 = phi_481_;
    return _e84;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_407_: u32;
    var phi_421_: u32;
    var phi_428_: u32;
    var phi_433_: u32;
    var phi_439_: u32;
    var phi_444_: u32;
    var phi_446_: texture_Axis;

    let _e65 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e66 = (param_8 - 1u);
    let _e68 = (_e65 * f32(param_8));
    if param_10 {
        let _e75 = select(select(u32(_e68), 0u, (_e68 < bitcast<f32>(0u))), 4294967295u, (_e68 > bitcast<f32>(1333788671u)));
        if (_e66 < _e75) {
            phi_407_ = _e66;
        } else {
            phi_407_ = _e75;
        }
        let _e78 = phi_407_;
        phi_446_ = texture_Axis(_e78, _e78, 0f);
    } else {
        let _e80 = (_e68 + 0.5f);
        let _e87 = select(select(u32(_e80), 0u, (_e80 < bitcast<f32>(0u))), 4294967295u, (_e80 > bitcast<f32>(1333788671u)));
        if (param_8 < _e87) {
            phi_421_ = param_8;
        } else {
            phi_421_ = _e87;
        }
        let _e90 = phi_421_;
        if (param_9 == 0u) {
            phi_428_ = _e66;
        } else {
            phi_428_ = 0u;
        }
        let _e95 = phi_428_;
        if (param_9 == 0u) {
            phi_433_ = 0u;
        } else {
            phi_433_ = _e66;
        }
        let _e98 = phi_433_;
        if (_e90 == 0u) {
            phi_439_ = _e95;
        } else {
            phi_439_ = (_e90 - 1u);
        }
        let _e102 = phi_439_;
        if (_e90 > _e66) {
            phi_444_ = _e98;
        } else {
            phi_444_ = _e90;
        }
        let _e105 = phi_444_;
        phi_446_ = texture_Axis(_e102, _e105, (_e80 - f32(_e90)));
    }
    let _e108 = phi_446_;
    return _e108;
}

fn _lt_shaders_texture_TextureView_quad(param_11: ptr<function, texture_TextureView>, param_12: f32, param_13: f32) -> texture_TexelQuad {
    let _e65 = (*param_11).size;
    let _e66 = (_e65 & 65535u);
    let _e68 = (*param_11).size;
    let _e72 = (*param_11).flags;
    let _e74 = ((_e72 & 4u) != 0u);
    let _e76 = (*param_11).flags;
    let _e80 = lt_shaders_texture_axis(param_12, _e66, ((_e76 >> bitcast<u32>(4u)) & 3u), _e74);
    let _e82 = (*param_11).flags;
    let _e86 = lt_shaders_texture_axis(param_13, (_e68 >> bitcast<u32>(16i)), ((_e82 >> bitcast<u32>(6u)) & 3u), _e74);
    let _e90 = (*param_11).offset;
    let _e97 = (*param_11).offset;
    let _e104 = (*param_11).offset;
    let _e111 = (*param_11).offset;
    return texture_TexelQuad(array<u32, 4>(((_e90 + (_e86.low * _e66)) + _e80.low), ((_e97 + (_e86.low * _e66)) + _e80.high), ((_e104 + (_e86.high * _e66)) + _e80.low), ((_e111 + (_e86.high * _e66)) + _e80.high)), vec4<f32>(((1f - _e80.fraction) * (1f - _e86.fraction)), (_e80.fraction * (1f - _e86.fraction)), ((1f - _e80.fraction) * _e86.fraction), (_e80.fraction * _e86.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_14: f32, param_15: f32) -> f32 {
    var phi_493_: bool;
    var phi_497_: f32;

    if (param_14 != param_14) {
        phi_493_ = true;
    } else {
        let _e64 = (param_15 >= param_14);
        if _e64 {
        }
        phi_493_ = _e64;
    }
    let _e66 = phi_493_;
    if _e66 {
        phi_497_ = param_15;
    } else {
        phi_497_ = param_14;
    }
    let _e68 = phi_497_;
    return _e68;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_16: f32, param_17: f32) -> f32 {
    var phi_509_: bool;
    var phi_513_: f32;

    if (param_16 != param_16) {
        phi_509_ = true;
    } else {
        let _e64 = (param_17 <= param_16);
        if _e64 {
        }
        phi_509_ = _e64;
    }
    let _e66 = phi_509_;
    if _e66 {
        phi_513_ = param_17;
    } else {
        phi_513_ = param_16;
    }
    let _e68 = phi_513_;
    return _e68;
}

fn lt_shaders_surface_barycentric_weights(param_18: f32, param_19: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_18) - param_19), param_18, param_19);
}

fn lt_shaders_evaluate_to_light(param_20: vec3<f32>, param_21: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_21.x - (param_20.x * param_21.w)), (param_21.y - (param_20.y * param_21.w)), (param_21.z - (param_20.z * param_21.w)));
}

fn lt_shaders_doubt_slot_of(param_22: vec3<u32>) -> u32 {
    return ((param_22.y * 2097152u) + param_22.x);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_640_: f32;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_718_: bool;
    var phi_722_: bool;
    var phi_796_: f32;
    var phi_803_: f32;
    var phi_811_: f32;
    var phi_818_: f32;
    var phi_826_: f32;
    var phi_833_: f32;
    var phi_850_: f32;
    var phi_855_: f32;
    var phi_860_: f32;
    var phi_881_: u32;
    var phi_886_: u32;
    var phi_891_: u32;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1037_: u32;
    var phi_1039_: u32;
    var phi_1120_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1147_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1174_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1180_: u32;
    var phi_1183_: u32;
    var phi_1197_: u32;
    var phi_1207_: u32;
    var phi_1217_: u32;
    var phi_1235_: u32;
    var phi_1245_: u32;
    var phi_1255_: u32;
    var phi_1291_: u32;
    var phi_1304_: u32;
    var phi_1309_: u32;
    var phi_1310_: u32;
    var phi_1311_: u32;
    var phi_1181_: u32;
    var phi_1184_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1369_: u32;
    var phi_1419_: f32;
    var phi_1424_: f32;
    var phi_1429_: f32;
    var phi_1437_: f32;
    var phi_1442_: f32;
    var phi_1447_: f32;
    var phi_1594_: bool;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1621_: bool;
    var phi_1625_: bool;
    var phi_1695_: f32;
    var phi_1702_: f32;
    var phi_1709_: f32;
    var phi_1716_: f32;
    var phi_1723_: f32;
    var phi_1730_: f32;
    var phi_1747_: f32;
    var phi_1752_: f32;
    var phi_1757_: f32;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1794_: u32;
    var phi_1795_: u32;
    var phi_1806_: vec3<f32>;
    var phi_1807_: vec3<f32>;
    var phi_1820_: u32;
    var phi_1825_: u32;
    var phi_1830_: u32;
    var phi_1944_: bool;
    var phi_1945_: bool;
    var phi_1976_: u32;
    var phi_1978_: u32;
    var phi_2059_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2086_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2113_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2119_: u32;
    var phi_2122_: u32;
    var phi_2136_: u32;
    var phi_2146_: u32;
    var phi_2156_: u32;
    var phi_2174_: u32;
    var phi_2184_: u32;
    var phi_2194_: u32;
    var phi_2230_: u32;
    var phi_2243_: u32;
    var phi_2248_: u32;
    var phi_2249_: u32;
    var phi_2250_: u32;
    var phi_2120_: u32;
    var phi_2123_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2308_: u32;
    var phi_2353_: vec3<f32>;
    var phi_2354_: vec3<f32>;
    var phi_2385_: vec3<f32>;
    var phi_2386_: vec3<f32>;
    var phi_2417_: vec3<f32>;
    var phi_2418_: vec3<f32>;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2443_: f32;
    var phi_2444_: f32;
    var phi_2445_: f32;
    var phi_2446_: f32;
    var phi_2454_: f32;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2469_: f32;
    var phi_2470_: f32;
    var phi_2471_: f32;
    var phi_2472_: f32;
    var phi_2480_: f32;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2495_: f32;
    var phi_2496_: f32;
    var phi_2497_: f32;
    var phi_2498_: f32;
    var phi_2506_: f32;
    var phi_2521_: f32;
    var phi_2522_: bool;
    var phi_2523_: f32;
    var phi_2524_: bool;
    var phi_2525_: f32;
    var phi_2526_: bool;
    var phi_2544_: f32;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: f32;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2553_: bool;
    var phi_2554_: f32;
    var phi_2555_: bool;
    var phi_2581_: f32;
    var phi_2590_: f32;
    var phi_2599_: f32;
    var phi_2608_: f32;
    var phi_2615_: f32;
    var phi_2622_: f32;
    var phi_2635_: f32;
    var phi_2644_: f32;
    var phi_2653_: f32;
    var phi_2662_: f32;
    var phi_2669_: f32;
    var phi_2676_: f32;
    var phi_2693_: f32;
    var phi_2698_: f32;
    var phi_2703_: f32;
    var phi_2711_: f32;
    var phi_2716_: f32;
    var phi_2721_: f32;
    var phi_2733_: f32;
    var phi_2738_: f32;
    var phi_2743_: f32;
    var phi_2748_: f32;
    var phi_2753_: lt_bvh_triangle_Intersection;
    var phi_2754_: lt_bvh_triangle_Intersection;
    var phi_2755_: bool;
    var phi_2759_: lt_bvh_triangle_Intersection;
    var phi_2968_: f32;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2976_: bool;
    var phi_2977_: bool;
    var phi_2978_: bool;
    var phi_2979_: bool;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var phi_2987_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var phi_2309_: u32;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var phi_2995_: bool;
    var local_10: bool;
    var phi_3037_: bool;
    var phi_3038_: bool;
    var phi_3069_: u32;
    var phi_3070_: u32;
    var phi_3071_: bool;
    var phi_3072_: bool;
    var phi_1979_: u32;
    var phi_3073_: bool;
    var phi_3074_: bool;
    var phi_3075_: bool;
    var phi_3076_: bool;
    var local_11: bool;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var phi_3085_: bool;
    var phi_3089_: bool;
    var phi_3090_: bool;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3096_: bool;
    var phi_3100_: bool;
    var phi_3101_: bool;
    var phi_3102_: bool;
    var phi_3103_: bool;
    var phi_1370_: u32;
    var phi_3107_: bool;
    var local_12: bool;
    var phi_3149_: bool;
    var phi_3150_: bool;
    var phi_3181_: u32;
    var phi_3182_: u32;
    var phi_1040_: u32;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var local_13: bool;
    var phi_3188_: bool;
    var phi_3192_: bool;
    var phi_3193_: bool;
    var phi_3194_: bool;
    var phi_3195_: bool;
    var phi_3199_: bool;
    var phi_3203_: f32;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

    let _e65 = id_1;
    let _e72 = arrayLength((&nodes.member));
    let _e75 = arrayLength((&triangles.member));
    let _e81 = arrayLength((&list.member));
    let _e87 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e94 = lt_shaders_doubt_slot_of(_e65);
    if (3u < _e81) {
    } else {
        return;
    }
    let _e97 = list.member[3u];
    if (_e94 < _e97) {
        let _e99 = (_e94 + 4u);
        if (_e99 < _e81) {
        } else {
            return;
        }
        let _e103 = list.member[(0u + _e99)];
        let _e105 = p.member.root;
        if (_e103 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e110 = p.member.light;
        let _e112 = samples.member[(0u + _e103)].position;
        let _e114 = samples.member[(0u + _e103)].normal;
        let _e116 = samples.member[(0u + _e103)].magnitude;
        let _e118 = ((8f / 8388608f) * _e116);
        let _e120 = (_e114.x * _e118);
        let _e122 = (_e114.y * _e118);
        let _e124 = (_e114.z * _e118);
        let _e126 = (_e112.x + _e120);
        let _e128 = (_e112.y + _e122);
        let _e130 = (_e112.z + _e124);
        let _e132 = (_e112 + vec3<f32>(_e120, _e122, _e124));
        if (_e110.w == 0f) {
            phi_640_ = 300000000000000000000000000000000000000f;
        } else {
            phi_640_ = 1f;
        }
        let _e136 = phi_640_;
        let _e137 = lt_shaders_evaluate_to_light(_e132, _e110);
        let _e138 = lt_bvh_Ray(_e132, 0f, _e137, _e136);
        let _e143 = abs(_e137.x);
        let _e145 = abs(_e137.y);
        let _e147 = abs(_e137.z);
        if (abs(_e126) < 1000000000000000f) {
            if (abs(_e128) < 1000000000000000f) {
                if (abs(_e130) < 1000000000000000f) {
                    if (_e143 < 1000000000000000f) {
                        if (_e145 < 1000000000000000f) {
                            if (_e147 < 1000000000000000f) {
                                if (_e143 > 0f) {
                                    phi_692_ = bool();
                                    phi_693_ = true;
                                } else {
                                    let _e155 = (_e145 > 0f);
                                    if _e155 {
                                        phi_691_ = bool();
                                    } else {
                                        phi_691_ = (_e147 > 0f);
                                    }
                                    let _e158 = phi_691_;
                                    phi_692_ = _e158;
                                    phi_693_ = _e155;
                                }
                                let _e160 = phi_692_;
                                let _e162 = phi_693_;
                                if _e162 {
                                    phi_697_ = true;
                                } else {
                                    phi_697_ = _e160;
                                }
                                let _e164 = phi_697_;
                                phi_698_ = _e164;
                                phi_699_ = false;
                            } else {
                                phi_698_ = bool();
                                phi_699_ = true;
                            }
                            let _e166 = phi_698_;
                            let _e168 = phi_699_;
                            phi_700_ = _e166;
                            phi_701_ = false;
                            phi_702_ = _e168;
                        } else {
                            phi_700_ = bool();
                            phi_701_ = true;
                            phi_702_ = false;
                        }
                        let _e170 = phi_700_;
                        let _e172 = phi_701_;
                        let _e174 = phi_702_;
                        phi_703_ = _e170;
                        phi_704_ = _e172;
                        phi_705_ = _e174;
                    } else {
                        phi_703_ = bool();
                        phi_704_ = true;
                        phi_705_ = false;
                    }
                    let _e176 = phi_703_;
                    let _e178 = phi_704_;
                    let _e180 = phi_705_;
                    phi_706_ = _e176;
                    phi_707_ = _e178;
                    phi_708_ = _e180;
                } else {
                    phi_706_ = bool();
                    phi_707_ = true;
                    phi_708_ = false;
                }
                let _e182 = phi_706_;
                let _e184 = phi_707_;
                let _e186 = phi_708_;
                phi_709_ = _e182;
                phi_710_ = _e184;
                phi_711_ = _e186;
            } else {
                phi_709_ = bool();
                phi_710_ = true;
                phi_711_ = false;
            }
            let _e188 = phi_709_;
            let _e190 = phi_710_;
            let _e192 = phi_711_;
            phi_712_ = _e188;
            phi_713_ = _e190;
            phi_714_ = _e192;
        } else {
            phi_712_ = bool();
            phi_713_ = true;
            phi_714_ = false;
        }
        let _e194 = phi_712_;
        let _e196 = phi_713_;
        let _e198 = phi_714_;
        if _e196 {
            phi_718_ = true;
        } else {
            phi_718_ = _e198;
        }
        let _e200 = phi_718_;
        if _e200 {
            phi_722_ = false;
        } else {
            phi_722_ = _e194;
        }
        let _e202 = phi_722_;
        if _e202 {
            let _e203 = (_e105 >= _e72);
            if _e203 {
                phi_3193_ = bool();
            } else {
                if (_e105 < _e72) {
                } else {
                    return;
                }
                let _e209 = nodes.member[(0u + _e105)].frame[0u];
                let _e213 = nodes.member[(0u + _e105)].frame[1u];
                let _e217 = nodes.member[(0u + _e105)].frame[2u];
                let _e221 = nodes.member[(0u + _e105)].frame[0u];
                let _e225 = nodes.member[(0u + _e105)].frame[1u];
                let _e229 = nodes.member[(0u + _e105)].frame[2u];
                let _e233 = nodes.member[(0u + _e105)].frame[3u];
                let _e270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e137.x), abs(_e137.y));
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(_e270, abs(_e137.z));
                let _e272 = (_e271 * 0.0000000000009094947f);
                if (abs(_e138.direction.x) < _e272) {
                    phi_796_ = _e272;
                } else {
                    phi_796_ = abs(_e138.direction.x);
                }
                let _e279 = phi_796_;
                if (_e138.direction.x < 0f) {
                    phi_803_ = (-1f / _e279);
                } else {
                    phi_803_ = (1f / _e279);
                }
                let _e284 = phi_803_;
                if (abs(_e138.direction.y) < _e272) {
                    phi_811_ = _e272;
                } else {
                    phi_811_ = abs(_e138.direction.y);
                }
                let _e291 = phi_811_;
                if (_e138.direction.y < 0f) {
                    phi_818_ = (-1f / _e291);
                } else {
                    phi_818_ = (1f / _e291);
                }
                let _e296 = phi_818_;
                if (abs(_e138.direction.z) < _e272) {
                    phi_826_ = _e272;
                } else {
                    phi_826_ = abs(_e138.direction.z);
                }
                let _e303 = phi_826_;
                if (_e138.direction.z < 0f) {
                    phi_833_ = (-1f / _e303);
                } else {
                    phi_833_ = (1f / _e303);
                }
                let _e308 = phi_833_;
                let _e312 = abs((bitcast<f32>(_e209) - _e126));
                let _e313 = abs((bitcast<f32>(_e213) - _e128));
                let _e314 = abs((bitcast<f32>(_e217) - _e130));
                let _e318 = abs(((bitcast<f32>(_e221) + (bitcast<f32>((((_e233 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                let _e319 = abs(((bitcast<f32>(_e225) + (bitcast<f32>((((_e233 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                let _e320 = abs(((bitcast<f32>(_e229) + (bitcast<f32>((((_e233 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                if (_e312 > _e318) {
                    phi_850_ = _e312;
                } else {
                    phi_850_ = _e318;
                }
                let _e323 = phi_850_;
                if (_e313 > _e319) {
                    phi_855_ = _e313;
                } else {
                    phi_855_ = _e319;
                }
                let _e326 = phi_855_;
                if (_e314 > _e320) {
                    phi_860_ = _e314;
                } else {
                    phi_860_ = _e320;
                }
                let _e329 = phi_860_;
                let _e330 = core_intrinsics_maximum_number_nsz_f32_(_e323, _e326);
                let _e331 = core_intrinsics_maximum_number_nsz_f32_(_e330, _e329);
                let _e335 = (_e331 * 0.0000019073486f);
                let _e336 = (abs(_e284) * _e335);
                let _e337 = (abs(_e296) * _e335);
                let _e338 = (abs(_e308) * _e335);
                let _e342 = (_e331 * 0.0000009536743f);
                let _e343 = (abs(_e284) * _e342);
                let _e344 = (abs(_e296) * _e342);
                let _e345 = (abs(_e308) * _e342);
                if (_e284 < 0f) {
                    phi_881_ = 0u;
                } else {
                    phi_881_ = 1u;
                }
                let _e348 = phi_881_;
                if (_e296 < 0f) {
                    phi_886_ = 0u;
                } else {
                    phi_886_ = 2u;
                }
                let _e351 = phi_886_;
                if (_e308 < 0f) {
                    phi_891_ = 0u;
                } else {
                    phi_891_ = 4u;
                }
                let _e354 = phi_891_;
                let _e356 = ((_e348 | _e351) | _e354);
                let _e357 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e105, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e357.first[0], _e357.first[1], _e357.first[2], _e357.first[3], _e357.first[4], _e357.first[5], _e357.first[6], _e357.first[7], _e357.first[8], _e357.first[9], _e357.first[10], _e357.first[11], _e357.first[12], _e357.first[13], _e357.first[14], _e357.first[15], _e357.first[16], _e357.first[17], _e357.first[18], _e357.first[19], _e357.first[20], _e357.first[21], _e357.first[22], _e357.first[23], _e357.first[24], _e357.first[25], _e357.first[26], _e357.first[27], _e357.first[28], _e357.first[29], _e357.first[30], _e357.first[31]), array<u32, 32>(_e357.mask[0], _e357.mask[1], _e357.mask[2], _e357.mask[3], _e357.mask[4], _e357.mask[5], _e357.mask[6], _e357.mask[7], _e357.mask[8], _e357.mask[9], _e357.mask[10], _e357.mask[11], _e357.mask[12], _e357.mask[13], _e357.mask[14], _e357.mask[15], _e357.mask[16], _e357.mask[17], _e357.mask[18], _e357.mask[19], _e357.mask[20], _e357.mask[21], _e357.mask[22], _e357.mask[23], _e357.mask[24], _e357.mask[25], _e357.mask[26], _e357.mask[27], _e357.mask[28], _e357.mask[29], _e357.mask[30], _e357.mask[31]), _e357.len, _e357.group, _e357.group_mask);
                let _e431 = local_3.group_mask;
                if ((_e431 & 4278190080u) == 0u) {
                    let _e435 = local_3.len;
                    if (_e435 == 0u) {
                        phi_1005_ = false;
                    } else {
                        let _e439 = local_3.len;
                        local_3.len = (_e439 - 1u);
                        let _e442 = local_3.len;
                        if (_e442 < 32u) {
                        } else {
                            return;
                        }
                        let _e447 = local_3.first[(0u + _e442)];
                        local_3.group = _e447;
                        let _e450 = local_3.len;
                        if (_e450 < 32u) {
                        } else {
                            return;
                        }
                        let _e455 = local_3.mask[(0u + _e450)];
                        local_3.group_mask = _e455;
                        phi_1005_ = true;
                    }
                    let _e458 = phi_1005_;
                    phi_1006_ = _e458;
                } else {
                    phi_1006_ = true;
                }
                let _e460 = phi_1006_;
                if _e460 {
                    let _e462 = local_3.group_mask;
                    let _e468 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, (_e462 == 0u)));
                    let _e472 = local_3.group_mask;
                    let _e486 = local_3.group_mask;
                    local_3.group_mask = (_e486 & ~((1u << bitcast<u32>((_e468 & 31u)))));
                    let _e489 = local_3.group;
                    phi_1037_ = (_e489 + countOneBits(((_e472 & ~((4294967295u << bitcast<u32>((((_e468 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1037_ = 4294967295u;
                }
                let _e492 = phi_1037_;
                phi_1039_ = _e492;
                loop {
                    let _e494 = phi_1039_;
                    if (_e494 != 4294967295u) {
                        if (_e494 < _e72) {
                        } else {
                            return;
                        }
                        let _e501 = nodes.member[(0u + _e494)].frame[3u];
                        let _e526 = (bitcast<f32>((((_e501 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e527 = (bitcast<f32>((((_e501 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e296);
                        let _e528 = (bitcast<f32>((((_e501 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e531 = nodes.member[(0u + _e494)].frame[0u];
                        let _e535 = nodes.member[(0u + _e494)].frame[1u];
                        let _e539 = nodes.member[(0u + _e494)].frame[2u];
                        let _e544 = ((bitcast<f32>(_e531) - _e126) * _e284);
                        let _e545 = ((bitcast<f32>(_e535) - _e128) * _e296);
                        let _e546 = ((bitcast<f32>(_e539) - _e130) * _e308);
                        let _e554 = nodes.member[(0u + _e494)].x;
                        if (_e284 < 0f) {
                            let _e565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e565.unnamed.root, _e554.w), _e565.unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e571.unnamed, lt_bvh_traverse_Tree(_e554.x, _e571.unnamed_1.first_primitive));
                            phi_1120_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e577.unnamed_1.root, _e554.y));
                        } else {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.unnamed.root, _e554.y), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_bvh_traverse_Tree(_e554.z, _e599.unnamed_1.first_primitive));
                            phi_1120_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e605.unnamed_1.root, _e554.w));
                        }
                        let _e613 = phi_1120_;
                        let _e623 = nodes.member[(0u + _e494)].y;
                        if (_e296 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e634.unnamed.root, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_bvh_traverse_Tree(_e623.x, _e640.unnamed_1.first_primitive));
                            phi_1147_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e646.unnamed_1.root, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e623.z, _e668.unnamed_1.first_primitive));
                            phi_1147_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e623.w));
                        }
                        let _e682 = phi_1147_;
                        let _e692 = nodes.member[(0u + _e494)].z;
                        if (_e308 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e703.unnamed.root, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e692.x, _e709.unnamed_1.first_primitive));
                            phi_1174_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e715.unnamed_1.root, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e692.z, _e737.unnamed_1.first_primitive));
                            phi_1174_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e692.w));
                        }
                        let _e751 = phi_1174_;
                        phi_1180_ = 0u;
                        phi_1183_ = 0u;
                        loop {
                            let _e761 = phi_1180_;
                            let _e763 = phi_1183_;
                            local_4 = _e763;
                            local_5 = _e763;
                            local_6 = _e763;
                            let _e764 = (_e761 < 8u);
                            if _e764 {
                                let _e766 = (_e761 >> bitcast<u32>(2i));
                                let _e767 = (_e761 & 3u);
                                if (_e766 == 0u) {
                                    phi_1197_ = _e613.unnamed.root;
                                } else {
                                    phi_1197_ = _e613.unnamed.first_primitive;
                                }
                                let _e770 = phi_1197_;
                                if (_e766 == 0u) {
                                    phi_1207_ = _e682.unnamed.root;
                                } else {
                                    phi_1207_ = _e682.unnamed.first_primitive;
                                }
                                let _e779 = phi_1207_;
                                if (_e766 == 0u) {
                                    phi_1217_ = _e751.unnamed.root;
                                } else {
                                    phi_1217_ = _e751.unnamed.first_primitive;
                                }
                                let _e788 = phi_1217_;
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e770 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e336)), ((f32(((_e779 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e337)));
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(_e801, ((f32(((_e788 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e338)));
                                if (_e766 == 0u) {
                                    phi_1235_ = _e613.unnamed_1.root;
                                } else {
                                    phi_1235_ = _e613.unnamed_1.first_primitive;
                                }
                                let _e805 = phi_1235_;
                                if (_e766 == 0u) {
                                    phi_1245_ = _e682.unnamed_1.root;
                                } else {
                                    phi_1245_ = _e682.unnamed_1.first_primitive;
                                }
                                let _e814 = phi_1245_;
                                if (_e766 == 0u) {
                                    phi_1255_ = _e751.unnamed_1.root;
                                } else {
                                    phi_1255_ = _e751.unnamed_1.first_primitive;
                                }
                                let _e823 = phi_1255_;
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e805 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e336)), ((f32(((_e814 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e337)));
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(_e836, ((f32(((_e823 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e338)));
                                if (_e802 <= _e837) {
                                    if (_e802 <= _e136) {
                                        if (_e837 >= 0f) {
                                            if (_e766 == 0u) {
                                                let _e844 = nodes.member[(0u + _e494)].links[2u];
                                                phi_1291_ = _e844;
                                            } else {
                                                let _e847 = nodes.member[(0u + _e494)].links[3u];
                                                phi_1291_ = _e847;
                                            }
                                            let _e849 = phi_1291_;
                                            let _e854 = ((_e849 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u);
                                            let _e855 = (_e854 & 31u);
                                            if (_e855 >= 24u) {
                                                phi_1304_ = (24u + ((_e855 - 24u) ^ _e356));
                                            } else {
                                                phi_1304_ = _e855;
                                            }
                                            let _e861 = phi_1304_;
                                            phi_1309_ = (_e763 | ((_e854 >> bitcast<u32>(5i)) << bitcast<u32>((_e861 & 31u))));
                                        } else {
                                            phi_1309_ = _e763;
                                        }
                                        let _e869 = phi_1309_;
                                        phi_1310_ = _e869;
                                    } else {
                                        phi_1310_ = _e763;
                                    }
                                    let _e871 = phi_1310_;
                                    phi_1311_ = _e871;
                                } else {
                                    phi_1311_ = _e763;
                                }
                                let _e873 = phi_1311_;
                                phi_1181_ = (_e761 + 1u);
                                phi_1184_ = _e873;
                            } else {
                                phi_1181_ = u32();
                                phi_1184_ = u32();
                            }
                            let _e876 = phi_1181_;
                            let _e878 = phi_1184_;
                            continue;
                            continuing {
                                phi_1180_ = _e876;
                                phi_1183_ = _e878;
                                break if !(_e764);
                            }
                        }
                        let _e882 = nodes.member[(0u + _e494)].links[0u];
                        let _e886 = nodes.member[(0u + _e494)].frame[3u];
                        let _e890 = local_4;
                        if ((_e890 & 4278190080u) == 0u) {
                        } else {
                            let _e894 = local_3.group_mask;
                            if ((_e894 & 4278190080u) == 0u) {
                            } else {
                                let _e898 = local_3.len;
                                if (_e898 < 32u) {
                                    let _e901 = local_3.group;
                                    let _e903 = local_3.len;
                                    if (_e903 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e903)] = _e901;
                                    let _e909 = local_3.group_mask;
                                    let _e911 = local_3.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e911)] = _e909;
                                    let _e918 = local_3.len;
                                    local_3.len = (_e918 + 1u);
                                }
                            }
                            local_3.group = (_e105 + _e882);
                            let _e922 = local_5;
                            local_3.group_mask = ((_e922 & 4278190080u) | (_e886 >> bitcast<u32>(24i)));
                        }
                        let _e927 = local_6;
                        phi_1369_ = (_e927 & 16777215u);
                        loop {
                            let _e930 = phi_1369_;
                            let _e931 = (_e930 == 0u);
                            local_12 = _e931;
                            local_19 = _e931;
                            if _e931 {
                                phi_1370_ = u32();
                                phi_3107_ = false;
                            } else {
                                let _e934 = nodes.member[(0u + _e494)].links[1u];
                                let _e938 = (_e934 + select(firstTrailingBit(_e930), 32u, (_e930 == 0u)));
                                if (_e938 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e945 = instances.member[(0u + _e938)].low_world;
                                let _e947 = instances.member[(0u + _e938)].high_world;
                                let _e954 = ((_e945.x - _e126) * _e284);
                                let _e955 = ((_e945.y - _e128) * _e296);
                                let _e956 = ((_e945.z - _e130) * _e308);
                                let _e963 = ((_e947.x - _e126) * _e284);
                                let _e964 = ((_e947.y - _e128) * _e296);
                                let _e965 = ((_e947.z - _e130) * _e308);
                                if (_e954 < _e963) {
                                    phi_1419_ = _e954;
                                } else {
                                    phi_1419_ = _e963;
                                }
                                let _e968 = phi_1419_;
                                if (_e955 < _e964) {
                                    phi_1424_ = _e955;
                                } else {
                                    phi_1424_ = _e964;
                                }
                                let _e971 = phi_1424_;
                                if (_e956 < _e965) {
                                    phi_1429_ = _e956;
                                } else {
                                    phi_1429_ = _e965;
                                }
                                let _e974 = phi_1429_;
                                if (_e954 > _e963) {
                                    phi_1437_ = _e954;
                                } else {
                                    phi_1437_ = _e963;
                                }
                                let _e980 = phi_1437_;
                                if (_e955 > _e964) {
                                    phi_1442_ = _e955;
                                } else {
                                    phi_1442_ = _e964;
                                }
                                let _e983 = phi_1442_;
                                if (_e956 > _e965) {
                                    phi_1447_ = _e956;
                                } else {
                                    phi_1447_ = _e965;
                                }
                                let _e986 = phi_1447_;
                                let _e990 = core_intrinsics_maximum_number_nsz_f32_((_e968 - _e343), (_e971 - _e344));
                                let _e991 = core_intrinsics_maximum_number_nsz_f32_(_e990, (_e974 - _e345));
                                let _e992 = core_intrinsics_minimum_number_nsz_f32_((_e980 + _e343), (_e983 + _e344));
                                let _e993 = core_intrinsics_minimum_number_nsz_f32_(_e992, (_e986 + _e345));
                                if (_e991 <= _e993) {
                                    if (_e991 <= _e136) {
                                        if (_e993 >= 0f) {
                                            let _e999 = instances.member[(0u + _e938)].world_to_object[0u];
                                            let _e1010 = ((((_e999.x * _e126) + (_e999.y * _e128)) + (_e999.z * _e130)) + (_e999.w * 1f));
                                            let _e1012 = instances.member[(0u + _e938)].world_to_object[1u];
                                            let _e1023 = ((((_e1012.x * _e126) + (_e1012.y * _e128)) + (_e1012.z * _e130)) + (_e1012.w * 1f));
                                            let _e1025 = instances.member[(0u + _e938)].world_to_object[2u];
                                            let _e1036 = ((((_e1025.x * _e126) + (_e1025.y * _e128)) + (_e1025.z * _e130)) + (_e1025.w * 1f));
                                            let _e1042 = instances.member[(0u + _e938)].world_to_object[0u];
                                            let _e1053 = ((((_e1042.x * _e137.x) + (_e1042.y * _e137.y)) + (_e1042.z * _e137.z)) + (_e1042.w * 0f));
                                            let _e1055 = instances.member[(0u + _e938)].world_to_object[1u];
                                            let _e1066 = ((((_e1055.x * _e137.x) + (_e1055.y * _e137.y)) + (_e1055.z * _e137.z)) + (_e1055.w * 0f));
                                            let _e1068 = instances.member[(0u + _e938)].world_to_object[2u];
                                            let _e1079 = ((((_e1068.x * _e137.x) + (_e1068.y * _e137.y)) + (_e1068.z * _e137.z)) + (_e1068.w * 0f));
                                            let _e1082 = instances.member[(0u + _e938)].root;
                                            let _e1084 = instances.member[(0u + _e938)].first_triangle;
                                            let _e1088 = abs(_e1053);
                                            let _e1089 = abs(_e1066);
                                            let _e1090 = abs(_e1079);
                                            if (abs(_e1010) < 1000000000000000f) {
                                                if (abs(_e1023) < 1000000000000000f) {
                                                    if (abs(_e1036) < 1000000000000000f) {
                                                        if (_e1088 < 1000000000000000f) {
                                                            if (_e1089 < 1000000000000000f) {
                                                                if (_e1090 < 1000000000000000f) {
                                                                    if (_e1088 > 0f) {
                                                                        phi_1595_ = bool();
                                                                        phi_1596_ = true;
                                                                    } else {
                                                                        let _e1098 = (_e1089 > 0f);
                                                                        if _e1098 {
                                                                            phi_1594_ = bool();
                                                                        } else {
                                                                            phi_1594_ = (_e1090 > 0f);
                                                                        }
                                                                        let _e1101 = phi_1594_;
                                                                        phi_1595_ = _e1101;
                                                                        phi_1596_ = _e1098;
                                                                    }
                                                                    let _e1103 = phi_1595_;
                                                                    let _e1105 = phi_1596_;
                                                                    if _e1105 {
                                                                        phi_1600_ = true;
                                                                    } else {
                                                                        phi_1600_ = _e1103;
                                                                    }
                                                                    let _e1107 = phi_1600_;
                                                                    phi_1601_ = _e1107;
                                                                    phi_1602_ = false;
                                                                } else {
                                                                    phi_1601_ = bool();
                                                                    phi_1602_ = true;
                                                                }
                                                                let _e1109 = phi_1601_;
                                                                let _e1111 = phi_1602_;
                                                                phi_1603_ = _e1109;
                                                                phi_1604_ = false;
                                                                phi_1605_ = _e1111;
                                                            } else {
                                                                phi_1603_ = bool();
                                                                phi_1604_ = true;
                                                                phi_1605_ = false;
                                                            }
                                                            let _e1113 = phi_1603_;
                                                            let _e1115 = phi_1604_;
                                                            let _e1117 = phi_1605_;
                                                            phi_1606_ = _e1113;
                                                            phi_1607_ = _e1115;
                                                            phi_1608_ = _e1117;
                                                        } else {
                                                            phi_1606_ = bool();
                                                            phi_1607_ = true;
                                                            phi_1608_ = false;
                                                        }
                                                        let _e1119 = phi_1606_;
                                                        let _e1121 = phi_1607_;
                                                        let _e1123 = phi_1608_;
                                                        phi_1609_ = _e1119;
                                                        phi_1610_ = _e1121;
                                                        phi_1611_ = _e1123;
                                                    } else {
                                                        phi_1609_ = bool();
                                                        phi_1610_ = true;
                                                        phi_1611_ = false;
                                                    }
                                                    let _e1125 = phi_1609_;
                                                    let _e1127 = phi_1610_;
                                                    let _e1129 = phi_1611_;
                                                    phi_1612_ = _e1125;
                                                    phi_1613_ = _e1127;
                                                    phi_1614_ = _e1129;
                                                } else {
                                                    phi_1612_ = bool();
                                                    phi_1613_ = true;
                                                    phi_1614_ = false;
                                                }
                                                let _e1131 = phi_1612_;
                                                let _e1133 = phi_1613_;
                                                let _e1135 = phi_1614_;
                                                phi_1615_ = _e1131;
                                                phi_1616_ = _e1133;
                                                phi_1617_ = _e1135;
                                            } else {
                                                phi_1615_ = bool();
                                                phi_1616_ = true;
                                                phi_1617_ = false;
                                            }
                                            let _e1137 = phi_1615_;
                                            let _e1139 = phi_1616_;
                                            let _e1141 = phi_1617_;
                                            if _e1139 {
                                                phi_1621_ = true;
                                            } else {
                                                phi_1621_ = _e1141;
                                            }
                                            let _e1143 = phi_1621_;
                                            if _e1143 {
                                                phi_1625_ = false;
                                            } else {
                                                phi_1625_ = _e1137;
                                            }
                                            let _e1145 = phi_1625_;
                                            if _e1145 {
                                                let _e1146 = (_e1082 >= _e72);
                                                if _e1146 {
                                                    phi_3090_ = bool();
                                                } else {
                                                    if (_e1082 < _e72) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1152 = nodes.member[(0u + _e1082)].frame[0u];
                                                    let _e1156 = nodes.member[(0u + _e1082)].frame[1u];
                                                    let _e1160 = nodes.member[(0u + _e1082)].frame[2u];
                                                    let _e1164 = nodes.member[(0u + _e1082)].frame[0u];
                                                    let _e1168 = nodes.member[(0u + _e1082)].frame[1u];
                                                    let _e1172 = nodes.member[(0u + _e1082)].frame[2u];
                                                    let _e1176 = nodes.member[(0u + _e1082)].frame[3u];
                                                    let _e1210 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1053), abs(_e1066));
                                                    let _e1211 = core_intrinsics_maximum_number_nsz_f32_(_e1210, abs(_e1079));
                                                    let _e1212 = (_e1211 * 0.0000000000009094947f);
                                                    if (abs(_e1053) < _e1212) {
                                                        phi_1695_ = _e1212;
                                                    } else {
                                                        phi_1695_ = abs(_e1053);
                                                    }
                                                    let _e1217 = phi_1695_;
                                                    if (_e1053 < 0f) {
                                                        phi_1702_ = (-1f / _e1217);
                                                    } else {
                                                        phi_1702_ = (1f / _e1217);
                                                    }
                                                    let _e1222 = phi_1702_;
                                                    if (abs(_e1066) < _e1212) {
                                                        phi_1709_ = _e1212;
                                                    } else {
                                                        phi_1709_ = abs(_e1066);
                                                    }
                                                    let _e1227 = phi_1709_;
                                                    if (_e1066 < 0f) {
                                                        phi_1716_ = (-1f / _e1227);
                                                    } else {
                                                        phi_1716_ = (1f / _e1227);
                                                    }
                                                    let _e1232 = phi_1716_;
                                                    if (abs(_e1079) < _e1212) {
                                                        phi_1723_ = _e1212;
                                                    } else {
                                                        phi_1723_ = abs(_e1079);
                                                    }
                                                    let _e1237 = phi_1723_;
                                                    if (_e1079 < 0f) {
                                                        phi_1730_ = (-1f / _e1237);
                                                    } else {
                                                        phi_1730_ = (1f / _e1237);
                                                    }
                                                    let _e1242 = phi_1730_;
                                                    let _e1246 = abs((bitcast<f32>(_e1152) - _e1010));
                                                    let _e1247 = abs((bitcast<f32>(_e1156) - _e1023));
                                                    let _e1248 = abs((bitcast<f32>(_e1160) - _e1036));
                                                    let _e1252 = abs(((bitcast<f32>(_e1164) + (bitcast<f32>((((_e1176 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1010));
                                                    let _e1253 = abs(((bitcast<f32>(_e1168) + (bitcast<f32>((((_e1176 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1023));
                                                    let _e1254 = abs(((bitcast<f32>(_e1172) + (bitcast<f32>((((_e1176 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1036));
                                                    if (_e1246 > _e1252) {
                                                        phi_1747_ = _e1246;
                                                    } else {
                                                        phi_1747_ = _e1252;
                                                    }
                                                    let _e1257 = phi_1747_;
                                                    if (_e1247 > _e1253) {
                                                        phi_1752_ = _e1247;
                                                    } else {
                                                        phi_1752_ = _e1253;
                                                    }
                                                    let _e1260 = phi_1752_;
                                                    if (_e1248 > _e1254) {
                                                        phi_1757_ = _e1248;
                                                    } else {
                                                        phi_1757_ = _e1254;
                                                    }
                                                    let _e1263 = phi_1757_;
                                                    let _e1264 = core_intrinsics_maximum_number_nsz_f32_(_e1257, _e1260);
                                                    let _e1265 = core_intrinsics_maximum_number_nsz_f32_(_e1264, _e1263);
                                                    let _e1269 = (_e1265 * 0.0000019073486f);
                                                    let _e1270 = (abs(_e1222) * _e1269);
                                                    let _e1271 = (abs(_e1232) * _e1269);
                                                    let _e1272 = (abs(_e1242) * _e1269);
                                                    let _e1276 = (_e1265 * 0.0000009536743f);
                                                    let _e1277 = (abs(_e1222) * _e1276);
                                                    let _e1278 = (abs(_e1232) * _e1276);
                                                    let _e1279 = (abs(_e1242) * _e1276);
                                                    let _e1280 = abs(_e1053);
                                                    let _e1281 = abs(_e1066);
                                                    let _e1282 = abs(_e1079);
                                                    if (_e1280 >= _e1281) {
                                                        if (_e1280 >= _e1282) {
                                                            phi_1785_ = false;
                                                        } else {
                                                            phi_1785_ = true;
                                                        }
                                                        let _e1286 = phi_1785_;
                                                        phi_1786_ = _e1286;
                                                    } else {
                                                        phi_1786_ = true;
                                                    }
                                                    let _e1288 = phi_1786_;
                                                    if _e1288 {
                                                        if (_e1281 >= _e1282) {
                                                            phi_1794_ = 1u;
                                                        } else {
                                                            phi_1794_ = 2u;
                                                        }
                                                        let _e1291 = phi_1794_;
                                                        phi_1795_ = _e1291;
                                                    } else {
                                                        phi_1795_ = 0u;
                                                    }
                                                    let _e1293 = phi_1795_;
                                                    if (_e1293 == 0u) {
                                                        phi_1807_ = vec3<f32>(_e1066, _e1079, _e1053);
                                                    } else {
                                                        if (_e1293 == 1u) {
                                                            phi_1806_ = vec3<f32>(_e1079, _e1053, _e1066);
                                                        } else {
                                                            phi_1806_ = vec3<f32>(_e1053, _e1066, _e1079);
                                                        }
                                                        let _e1299 = phi_1806_;
                                                        phi_1807_ = _e1299;
                                                    }
                                                    let _e1301 = phi_1807_;
                                                    let _e1304 = (_e1301.x / _e1301.z);
                                                    let _e1307 = (_e1301.y / _e1301.z);
                                                    let _e1309 = (1f / _e1301.z);
                                                    if (_e1222 < 0f) {
                                                        phi_1820_ = 0u;
                                                    } else {
                                                        phi_1820_ = 1u;
                                                    }
                                                    let _e1312 = phi_1820_;
                                                    if (_e1232 < 0f) {
                                                        phi_1825_ = 0u;
                                                    } else {
                                                        phi_1825_ = 2u;
                                                    }
                                                    let _e1315 = phi_1825_;
                                                    if (_e1242 < 0f) {
                                                        phi_1830_ = 0u;
                                                    } else {
                                                        phi_1830_ = 4u;
                                                    }
                                                    let _e1318 = phi_1830_;
                                                    let _e1320 = ((_e1312 | _e1315) | _e1318);
                                                    let _e1321 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1082, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1321.first[0], _e1321.first[1], _e1321.first[2], _e1321.first[3], _e1321.first[4], _e1321.first[5], _e1321.first[6], _e1321.first[7], _e1321.first[8], _e1321.first[9], _e1321.first[10], _e1321.first[11], _e1321.first[12], _e1321.first[13], _e1321.first[14], _e1321.first[15], _e1321.first[16], _e1321.first[17], _e1321.first[18], _e1321.first[19], _e1321.first[20], _e1321.first[21], _e1321.first[22], _e1321.first[23], _e1321.first[24], _e1321.first[25], _e1321.first[26], _e1321.first[27], _e1321.first[28], _e1321.first[29], _e1321.first[30], _e1321.first[31]), array<u32, 32>(_e1321.mask[0], _e1321.mask[1], _e1321.mask[2], _e1321.mask[3], _e1321.mask[4], _e1321.mask[5], _e1321.mask[6], _e1321.mask[7], _e1321.mask[8], _e1321.mask[9], _e1321.mask[10], _e1321.mask[11], _e1321.mask[12], _e1321.mask[13], _e1321.mask[14], _e1321.mask[15], _e1321.mask[16], _e1321.mask[17], _e1321.mask[18], _e1321.mask[19], _e1321.mask[20], _e1321.mask[21], _e1321.mask[22], _e1321.mask[23], _e1321.mask[24], _e1321.mask[25], _e1321.mask[26], _e1321.mask[27], _e1321.mask[28], _e1321.mask[29], _e1321.mask[30], _e1321.mask[31]), _e1321.len, _e1321.group, _e1321.group_mask);
                                                    let _e1395 = local_2.group_mask;
                                                    if ((_e1395 & 4278190080u) == 0u) {
                                                        let _e1399 = local_2.len;
                                                        if (_e1399 == 0u) {
                                                            phi_1944_ = false;
                                                        } else {
                                                            let _e1403 = local_2.len;
                                                            local_2.len = (_e1403 - 1u);
                                                            let _e1406 = local_2.len;
                                                            if (_e1406 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1411 = local_2.first[(0u + _e1406)];
                                                            local_2.group = _e1411;
                                                            let _e1414 = local_2.len;
                                                            if (_e1414 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1419 = local_2.mask[(0u + _e1414)];
                                                            local_2.group_mask = _e1419;
                                                            phi_1944_ = true;
                                                        }
                                                        let _e1422 = phi_1944_;
                                                        phi_1945_ = _e1422;
                                                    } else {
                                                        phi_1945_ = true;
                                                    }
                                                    let _e1424 = phi_1945_;
                                                    if _e1424 {
                                                        let _e1426 = local_2.group_mask;
                                                        let _e1432 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1426)), 32u, (_e1426 == 0u)));
                                                        let _e1436 = local_2.group_mask;
                                                        let _e1450 = local_2.group_mask;
                                                        local_2.group_mask = (_e1450 & ~((1u << bitcast<u32>((_e1432 & 31u)))));
                                                        let _e1453 = local_2.group;
                                                        phi_1976_ = (_e1453 + countOneBits(((_e1436 & ~((4294967295u << bitcast<u32>((((_e1432 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1976_ = 4294967295u;
                                                    }
                                                    let _e1456 = phi_1976_;
                                                    phi_1978_ = _e1456;
                                                    loop {
                                                        let _e1458 = phi_1978_;
                                                        if (_e1458 != 4294967295u) {
                                                            if (_e1458 < _e72) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1465 = nodes.member[(0u + _e1458)].frame[3u];
                                                            let _e1490 = (bitcast<f32>((((_e1465 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1222);
                                                            let _e1491 = (bitcast<f32>((((_e1465 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1232);
                                                            let _e1492 = (bitcast<f32>((((_e1465 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1242);
                                                            let _e1495 = nodes.member[(0u + _e1458)].frame[0u];
                                                            let _e1499 = nodes.member[(0u + _e1458)].frame[1u];
                                                            let _e1503 = nodes.member[(0u + _e1458)].frame[2u];
                                                            let _e1508 = ((bitcast<f32>(_e1495) - _e1010) * _e1222);
                                                            let _e1509 = ((bitcast<f32>(_e1499) - _e1023) * _e1232);
                                                            let _e1510 = ((bitcast<f32>(_e1503) - _e1036) * _e1242);
                                                            let _e1518 = nodes.member[(0u + _e1458)].x;
                                                            if (_e1222 < 0f) {
                                                                let _e1529 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1518.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1535 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1529.unnamed.root, _e1518.w), _e1529.unnamed_1);
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1535.unnamed, lt_bvh_traverse_Tree(_e1518.x, _e1535.unnamed_1.first_primitive));
                                                                phi_2059_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_bvh_traverse_Tree(_e1541.unnamed_1.root, _e1518.y));
                                                            } else {
                                                                let _e1557 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1518.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1563 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1557.unnamed.root, _e1518.y), _e1557.unnamed_1);
                                                                let _e1569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1563.unnamed, lt_bvh_traverse_Tree(_e1518.z, _e1563.unnamed_1.first_primitive));
                                                                phi_2059_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1569.unnamed, lt_bvh_traverse_Tree(_e1569.unnamed_1.root, _e1518.w));
                                                            }
                                                            let _e1577 = phi_2059_;
                                                            let _e1587 = nodes.member[(0u + _e1458)].y;
                                                            if (_e1232 < 0f) {
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1587.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1598.unnamed.root, _e1587.w), _e1598.unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_bvh_traverse_Tree(_e1587.x, _e1604.unnamed_1.first_primitive));
                                                                phi_2086_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_bvh_traverse_Tree(_e1610.unnamed_1.root, _e1587.y));
                                                            } else {
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1587.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1626.unnamed.root, _e1587.y), _e1626.unnamed_1);
                                                                let _e1638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_bvh_traverse_Tree(_e1587.z, _e1632.unnamed_1.first_primitive));
                                                                phi_2086_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1638.unnamed, lt_bvh_traverse_Tree(_e1638.unnamed_1.root, _e1587.w));
                                                            }
                                                            let _e1646 = phi_2086_;
                                                            let _e1656 = nodes.member[(0u + _e1458)].z;
                                                            if (_e1242 < 0f) {
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1667.unnamed.root, _e1656.w), _e1667.unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_bvh_traverse_Tree(_e1656.x, _e1673.unnamed_1.first_primitive));
                                                                phi_2113_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_bvh_traverse_Tree(_e1679.unnamed_1.root, _e1656.y));
                                                            } else {
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1695.unnamed.root, _e1656.y), _e1695.unnamed_1);
                                                                let _e1707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_bvh_traverse_Tree(_e1656.z, _e1701.unnamed_1.first_primitive));
                                                                phi_2113_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1707.unnamed, lt_bvh_traverse_Tree(_e1707.unnamed_1.root, _e1656.w));
                                                            }
                                                            let _e1715 = phi_2113_;
                                                            phi_2119_ = 0u;
                                                            phi_2122_ = 0u;
                                                            loop {
                                                                let _e1725 = phi_2119_;
                                                                let _e1727 = phi_2122_;
                                                                local_7 = _e1727;
                                                                local_8 = _e1727;
                                                                local_9 = _e1727;
                                                                let _e1728 = (_e1725 < 8u);
                                                                if _e1728 {
                                                                    let _e1730 = (_e1725 >> bitcast<u32>(2i));
                                                                    let _e1731 = (_e1725 & 3u);
                                                                    if (_e1730 == 0u) {
                                                                        phi_2136_ = _e1577.unnamed.root;
                                                                    } else {
                                                                        phi_2136_ = _e1577.unnamed.first_primitive;
                                                                    }
                                                                    let _e1734 = phi_2136_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2146_ = _e1646.unnamed.root;
                                                                    } else {
                                                                        phi_2146_ = _e1646.unnamed.first_primitive;
                                                                    }
                                                                    let _e1743 = phi_2146_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2156_ = _e1715.unnamed.root;
                                                                    } else {
                                                                        phi_2156_ = _e1715.unnamed.first_primitive;
                                                                    }
                                                                    let _e1752 = phi_2156_;
                                                                    let _e1765 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1734 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 - _e1270)), ((f32(((_e1743 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1491) + (_e1509 - _e1271)));
                                                                    let _e1766 = core_intrinsics_maximum_number_nsz_f32_(_e1765, ((f32(((_e1752 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 - _e1272)));
                                                                    if (_e1730 == 0u) {
                                                                        phi_2174_ = _e1577.unnamed_1.root;
                                                                    } else {
                                                                        phi_2174_ = _e1577.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1769 = phi_2174_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2184_ = _e1646.unnamed_1.root;
                                                                    } else {
                                                                        phi_2184_ = _e1646.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1778 = phi_2184_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2194_ = _e1715.unnamed_1.root;
                                                                    } else {
                                                                        phi_2194_ = _e1715.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1787 = phi_2194_;
                                                                    let _e1800 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1769 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 + _e1270)), ((f32(((_e1778 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1491) + (_e1509 + _e1271)));
                                                                    let _e1801 = core_intrinsics_minimum_number_nsz_f32_(_e1800, ((f32(((_e1787 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 + _e1272)));
                                                                    if (_e1766 <= _e1801) {
                                                                        if (_e1766 <= _e136) {
                                                                            if (_e1801 >= 0f) {
                                                                                if (_e1730 == 0u) {
                                                                                    let _e1808 = nodes.member[(0u + _e1458)].links[2u];
                                                                                    phi_2230_ = _e1808;
                                                                                } else {
                                                                                    let _e1811 = nodes.member[(0u + _e1458)].links[3u];
                                                                                    phi_2230_ = _e1811;
                                                                                }
                                                                                let _e1813 = phi_2230_;
                                                                                let _e1818 = ((_e1813 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u);
                                                                                let _e1819 = (_e1818 & 31u);
                                                                                if (_e1819 >= 24u) {
                                                                                    phi_2243_ = (24u + ((_e1819 - 24u) ^ _e1320));
                                                                                } else {
                                                                                    phi_2243_ = _e1819;
                                                                                }
                                                                                let _e1825 = phi_2243_;
                                                                                phi_2248_ = (_e1727 | ((_e1818 >> bitcast<u32>(5i)) << bitcast<u32>((_e1825 & 31u))));
                                                                            } else {
                                                                                phi_2248_ = _e1727;
                                                                            }
                                                                            let _e1833 = phi_2248_;
                                                                            phi_2249_ = _e1833;
                                                                        } else {
                                                                            phi_2249_ = _e1727;
                                                                        }
                                                                        let _e1835 = phi_2249_;
                                                                        phi_2250_ = _e1835;
                                                                    } else {
                                                                        phi_2250_ = _e1727;
                                                                    }
                                                                    let _e1837 = phi_2250_;
                                                                    phi_2120_ = (_e1725 + 1u);
                                                                    phi_2123_ = _e1837;
                                                                } else {
                                                                    phi_2120_ = u32();
                                                                    phi_2123_ = u32();
                                                                }
                                                                let _e1840 = phi_2120_;
                                                                let _e1842 = phi_2123_;
                                                                continue;
                                                                continuing {
                                                                    phi_2119_ = _e1840;
                                                                    phi_2122_ = _e1842;
                                                                    break if !(_e1728);
                                                                }
                                                            }
                                                            let _e1846 = nodes.member[(0u + _e1458)].links[0u];
                                                            let _e1850 = nodes.member[(0u + _e1458)].frame[3u];
                                                            let _e1854 = local_7;
                                                            if ((_e1854 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1858 = local_2.group_mask;
                                                                if ((_e1858 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1862 = local_2.len;
                                                                    if (_e1862 < 32u) {
                                                                        let _e1865 = local_2.group;
                                                                        let _e1867 = local_2.len;
                                                                        if (_e1867 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1867)] = _e1865;
                                                                        let _e1873 = local_2.group_mask;
                                                                        let _e1875 = local_2.len;
                                                                        if (_e1875 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1875)] = _e1873;
                                                                        let _e1882 = local_2.len;
                                                                        local_2.len = (_e1882 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1082 + _e1846);
                                                                let _e1886 = local_8;
                                                                local_2.group_mask = ((_e1886 & 4278190080u) | (_e1850 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1891 = local_9;
                                                            phi_2308_ = (_e1891 & 16777215u);
                                                            loop {
                                                                let _e1894 = phi_2308_;
                                                                let _e1895 = (_e1894 == 0u);
                                                                local_10 = _e1895;
                                                                local_16 = _e1895;
                                                                if _e1895 {
                                                                    phi_2309_ = u32();
                                                                    phi_2993_ = false;
                                                                    phi_2994_ = false;
                                                                    phi_2995_ = false;
                                                                } else {
                                                                    let _e1898 = nodes.member[(0u + _e1458)].links[1u];
                                                                    let _e1903 = ((_e1084 + _e1898) + select(firstTrailingBit(_e1894), 32u, (_e1894 == 0u)));
                                                                    if (_e1903 < _e75) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1910 = triangles.member[(0u + _e1903)].v0_;
                                                                    let _e1912 = (_e1910.x - _e1010);
                                                                    let _e1914 = (_e1910.y - _e1023);
                                                                    let _e1916 = (_e1910.z - _e1036);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2354_ = vec3<f32>(_e1914, _e1916, _e1912);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2353_ = vec3<f32>(_e1916, _e1912, _e1914);
                                                                        } else {
                                                                            phi_2353_ = (_e1910 - vec3<f32>(_e1010, _e1023, _e1036));
                                                                        }
                                                                        let _e1924 = phi_2353_;
                                                                        phi_2354_ = _e1924;
                                                                    }
                                                                    let _e1926 = phi_2354_;
                                                                    let _e1930 = (_e1926.x - (_e1304 * _e1926.z));
                                                                    let _e1934 = (_e1926.y - (_e1307 * _e1926.z));
                                                                    let _e1938 = triangles.member[(0u + _e1903)].v1_;
                                                                    let _e1940 = (_e1938.x - _e1010);
                                                                    let _e1942 = (_e1938.y - _e1023);
                                                                    let _e1944 = (_e1938.z - _e1036);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2386_ = vec3<f32>(_e1942, _e1944, _e1940);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2385_ = vec3<f32>(_e1944, _e1940, _e1942);
                                                                        } else {
                                                                            phi_2385_ = (_e1938 - vec3<f32>(_e1010, _e1023, _e1036));
                                                                        }
                                                                        let _e1952 = phi_2385_;
                                                                        phi_2386_ = _e1952;
                                                                    }
                                                                    let _e1954 = phi_2386_;
                                                                    let _e1958 = (_e1954.x - (_e1304 * _e1954.z));
                                                                    let _e1962 = (_e1954.y - (_e1307 * _e1954.z));
                                                                    let _e1966 = triangles.member[(0u + _e1903)].v2_;
                                                                    let _e1968 = (_e1966.x - _e1010);
                                                                    let _e1970 = (_e1966.y - _e1023);
                                                                    let _e1972 = (_e1966.z - _e1036);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2418_ = vec3<f32>(_e1970, _e1972, _e1968);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2417_ = vec3<f32>(_e1972, _e1968, _e1970);
                                                                        } else {
                                                                            phi_2417_ = (_e1966 - vec3<f32>(_e1010, _e1023, _e1036));
                                                                        }
                                                                        let _e1980 = phi_2417_;
                                                                        phi_2418_ = _e1980;
                                                                    }
                                                                    let _e1982 = phi_2418_;
                                                                    let _e1986 = (_e1982.x - (_e1304 * _e1982.z));
                                                                    let _e1990 = (_e1982.y - (_e1307 * _e1982.z));
                                                                    if (_e1958 < _e1986) {
                                                                        phi_2439_ = true;
                                                                    } else {
                                                                        if (_e1958 == _e1986) {
                                                                            phi_2438_ = (_e1962 < _e1990);
                                                                        } else {
                                                                            phi_2438_ = false;
                                                                        }
                                                                        let _e1997 = phi_2438_;
                                                                        phi_2439_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2439_;
                                                                    if _e1999 {
                                                                        phi_2443_ = _e1990;
                                                                        phi_2444_ = _e1986;
                                                                        phi_2445_ = _e1962;
                                                                        phi_2446_ = _e1958;
                                                                    } else {
                                                                        phi_2443_ = _e1962;
                                                                        phi_2444_ = _e1958;
                                                                        phi_2445_ = _e1990;
                                                                        phi_2446_ = _e1986;
                                                                    }
                                                                    let _e2001 = phi_2443_;
                                                                    let _e2003 = phi_2444_;
                                                                    let _e2005 = phi_2445_;
                                                                    let _e2007 = phi_2446_;
                                                                    let _e2010 = ((_e2007 * _e2001) - (_e2005 * _e2003));
                                                                    if _e1999 {
                                                                        phi_2454_ = -(_e2010);
                                                                    } else {
                                                                        phi_2454_ = _e2010;
                                                                    }
                                                                    let _e2013 = phi_2454_;
                                                                    if (_e1986 < _e1930) {
                                                                        phi_2465_ = true;
                                                                    } else {
                                                                        if (_e1986 == _e1930) {
                                                                            phi_2464_ = (_e1990 < _e1934);
                                                                        } else {
                                                                            phi_2464_ = false;
                                                                        }
                                                                        let _e2018 = phi_2464_;
                                                                        phi_2465_ = _e2018;
                                                                    }
                                                                    let _e2020 = phi_2465_;
                                                                    if _e2020 {
                                                                        phi_2469_ = _e1934;
                                                                        phi_2470_ = _e1930;
                                                                        phi_2471_ = _e1990;
                                                                        phi_2472_ = _e1986;
                                                                    } else {
                                                                        phi_2469_ = _e1990;
                                                                        phi_2470_ = _e1986;
                                                                        phi_2471_ = _e1934;
                                                                        phi_2472_ = _e1930;
                                                                    }
                                                                    let _e2022 = phi_2469_;
                                                                    let _e2024 = phi_2470_;
                                                                    let _e2026 = phi_2471_;
                                                                    let _e2028 = phi_2472_;
                                                                    let _e2031 = ((_e2028 * _e2022) - (_e2026 * _e2024));
                                                                    if _e2020 {
                                                                        phi_2480_ = -(_e2031);
                                                                    } else {
                                                                        phi_2480_ = _e2031;
                                                                    }
                                                                    let _e2034 = phi_2480_;
                                                                    if (_e1930 < _e1958) {
                                                                        phi_2491_ = true;
                                                                    } else {
                                                                        if (_e1930 == _e1958) {
                                                                            phi_2490_ = (_e1934 < _e1962);
                                                                        } else {
                                                                            phi_2490_ = false;
                                                                        }
                                                                        let _e2039 = phi_2490_;
                                                                        phi_2491_ = _e2039;
                                                                    }
                                                                    let _e2041 = phi_2491_;
                                                                    if _e2041 {
                                                                        phi_2495_ = _e1962;
                                                                        phi_2496_ = _e1958;
                                                                        phi_2497_ = _e1934;
                                                                        phi_2498_ = _e1930;
                                                                    } else {
                                                                        phi_2495_ = _e1934;
                                                                        phi_2496_ = _e1930;
                                                                        phi_2497_ = _e1962;
                                                                        phi_2498_ = _e1958;
                                                                    }
                                                                    let _e2043 = phi_2495_;
                                                                    let _e2045 = phi_2496_;
                                                                    let _e2047 = phi_2497_;
                                                                    let _e2049 = phi_2498_;
                                                                    let _e2052 = ((_e2049 * _e2043) - (_e2047 * _e2045));
                                                                    if _e2041 {
                                                                        phi_2506_ = -(_e2052);
                                                                    } else {
                                                                        phi_2506_ = _e2052;
                                                                    }
                                                                    let _e2055 = phi_2506_;
                                                                    if (_e2013 >= 0f) {
                                                                        if (_e2034 >= 0f) {
                                                                            if (_e2055 >= 0f) {
                                                                                phi_2521_ = ((_e2013 + _e2034) + _e2055);
                                                                                phi_2522_ = false;
                                                                            } else {
                                                                                phi_2521_ = f32();
                                                                                phi_2522_ = true;
                                                                            }
                                                                            let _e2062 = phi_2521_;
                                                                            let _e2064 = phi_2522_;
                                                                            phi_2523_ = _e2062;
                                                                            phi_2524_ = _e2064;
                                                                        } else {
                                                                            phi_2523_ = f32();
                                                                            phi_2524_ = true;
                                                                        }
                                                                        let _e2066 = phi_2523_;
                                                                        let _e2068 = phi_2524_;
                                                                        phi_2525_ = _e2066;
                                                                        phi_2526_ = _e2068;
                                                                    } else {
                                                                        phi_2525_ = f32();
                                                                        phi_2526_ = true;
                                                                    }
                                                                    let _e2070 = phi_2525_;
                                                                    let _e2072 = phi_2526_;
                                                                    if _e2072 {
                                                                        if (_e2013 <= 0f) {
                                                                            if (_e2034 <= 0f) {
                                                                                let _e2075 = (_e2055 <= 0f);
                                                                                if _e2075 {
                                                                                }
                                                                                phi_2544_ = ((_e2013 + _e2034) + _e2055);
                                                                                phi_2545_ = false;
                                                                                phi_2546_ = _e2075;
                                                                            } else {
                                                                                phi_2544_ = f32();
                                                                                phi_2545_ = true;
                                                                                phi_2546_ = false;
                                                                            }
                                                                            let _e2079 = phi_2544_;
                                                                            let _e2081 = phi_2545_;
                                                                            let _e2083 = phi_2546_;
                                                                            phi_2547_ = _e2079;
                                                                            phi_2548_ = _e2081;
                                                                            phi_2549_ = _e2083;
                                                                        } else {
                                                                            phi_2547_ = f32();
                                                                            phi_2548_ = true;
                                                                            phi_2549_ = false;
                                                                        }
                                                                        let _e2085 = phi_2547_;
                                                                        let _e2087 = phi_2548_;
                                                                        let _e2089 = phi_2549_;
                                                                        if _e2087 {
                                                                            phi_2553_ = false;
                                                                        } else {
                                                                            phi_2553_ = _e2089;
                                                                        }
                                                                        let _e2091 = phi_2553_;
                                                                        phi_2554_ = _e2085;
                                                                        phi_2555_ = _e2091;
                                                                    } else {
                                                                        phi_2554_ = _e2070;
                                                                        phi_2555_ = true;
                                                                    }
                                                                    let _e2093 = phi_2554_;
                                                                    let _e2095 = phi_2555_;
                                                                    if _e2095 {
                                                                        let _e2096 = (_e2093 == 0f);
                                                                        if _e2096 {
                                                                            phi_2753_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2102 = ((((_e2013 * (_e1309 * _e1926.z)) + (_e2034 * (_e1309 * _e1954.z))) + (_e2055 * (_e1309 * _e1982.z))) / _e2093);
                                                                            let _e2104 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2106 = triangles.member[(0u + _e1903)].v1_;
                                                                            if (_e2104.x < _e2106.x) {
                                                                                phi_2581_ = _e2104.x;
                                                                            } else {
                                                                                phi_2581_ = _e2106.x;
                                                                            }
                                                                            let _e2113 = phi_2581_;
                                                                            if (_e2104.y < _e2106.y) {
                                                                                phi_2590_ = _e2104.y;
                                                                            } else {
                                                                                phi_2590_ = _e2106.y;
                                                                            }
                                                                            let _e2120 = phi_2590_;
                                                                            if (_e2104.z < _e2106.z) {
                                                                                phi_2599_ = _e2104.z;
                                                                            } else {
                                                                                phi_2599_ = _e2106.z;
                                                                            }
                                                                            let _e2127 = phi_2599_;
                                                                            let _e2129 = triangles.member[(0u + _e1903)].v2_;
                                                                            if (_e2113 < _e2129.x) {
                                                                                phi_2608_ = _e2113;
                                                                            } else {
                                                                                phi_2608_ = _e2129.x;
                                                                            }
                                                                            let _e2134 = phi_2608_;
                                                                            if (_e2120 < _e2129.y) {
                                                                                phi_2615_ = _e2120;
                                                                            } else {
                                                                                phi_2615_ = _e2129.y;
                                                                            }
                                                                            let _e2139 = phi_2615_;
                                                                            if (_e2127 < _e2129.z) {
                                                                                phi_2622_ = _e2127;
                                                                            } else {
                                                                                phi_2622_ = _e2129.z;
                                                                            }
                                                                            let _e2144 = phi_2622_;
                                                                            let _e2146 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2148 = triangles.member[(0u + _e1903)].v1_;
                                                                            if (_e2146.x > _e2148.x) {
                                                                                phi_2635_ = _e2146.x;
                                                                            } else {
                                                                                phi_2635_ = _e2148.x;
                                                                            }
                                                                            let _e2155 = phi_2635_;
                                                                            if (_e2146.y > _e2148.y) {
                                                                                phi_2644_ = _e2146.y;
                                                                            } else {
                                                                                phi_2644_ = _e2148.y;
                                                                            }
                                                                            let _e2162 = phi_2644_;
                                                                            if (_e2146.z > _e2148.z) {
                                                                                phi_2653_ = _e2146.z;
                                                                            } else {
                                                                                phi_2653_ = _e2148.z;
                                                                            }
                                                                            let _e2169 = phi_2653_;
                                                                            let _e2171 = triangles.member[(0u + _e1903)].v2_;
                                                                            if (_e2155 > _e2171.x) {
                                                                                phi_2662_ = _e2155;
                                                                            } else {
                                                                                phi_2662_ = _e2171.x;
                                                                            }
                                                                            let _e2176 = phi_2662_;
                                                                            if (_e2162 > _e2171.y) {
                                                                                phi_2669_ = _e2162;
                                                                            } else {
                                                                                phi_2669_ = _e2171.y;
                                                                            }
                                                                            let _e2181 = phi_2669_;
                                                                            if (_e2169 > _e2171.z) {
                                                                                phi_2676_ = _e2169;
                                                                            } else {
                                                                                phi_2676_ = _e2171.z;
                                                                            }
                                                                            let _e2186 = phi_2676_;
                                                                            let _e2190 = ((_e2134 - _e1010) * _e1222);
                                                                            let _e2191 = ((_e2139 - _e1023) * _e1232);
                                                                            let _e2192 = ((_e2144 - _e1036) * _e1242);
                                                                            let _e2196 = ((_e2176 - _e1010) * _e1222);
                                                                            let _e2197 = ((_e2181 - _e1023) * _e1232);
                                                                            let _e2198 = ((_e2186 - _e1036) * _e1242);
                                                                            if (_e2190 < _e2196) {
                                                                                phi_2693_ = _e2190;
                                                                            } else {
                                                                                phi_2693_ = _e2196;
                                                                            }
                                                                            let _e2201 = phi_2693_;
                                                                            if (_e2191 < _e2197) {
                                                                                phi_2698_ = _e2191;
                                                                            } else {
                                                                                phi_2698_ = _e2197;
                                                                            }
                                                                            let _e2204 = phi_2698_;
                                                                            if (_e2192 < _e2198) {
                                                                                phi_2703_ = _e2192;
                                                                            } else {
                                                                                phi_2703_ = _e2198;
                                                                            }
                                                                            let _e2207 = phi_2703_;
                                                                            if (_e2190 > _e2196) {
                                                                                phi_2711_ = _e2190;
                                                                            } else {
                                                                                phi_2711_ = _e2196;
                                                                            }
                                                                            let _e2213 = phi_2711_;
                                                                            if (_e2191 > _e2197) {
                                                                                phi_2716_ = _e2191;
                                                                            } else {
                                                                                phi_2716_ = _e2197;
                                                                            }
                                                                            let _e2216 = phi_2716_;
                                                                            if (_e2192 > _e2198) {
                                                                                phi_2721_ = _e2192;
                                                                            } else {
                                                                                phi_2721_ = _e2198;
                                                                            }
                                                                            let _e2219 = phi_2721_;
                                                                            let _e2223 = core_intrinsics_maximum_number_nsz_f32_((_e2201 - _e1277), (_e2204 - _e1278));
                                                                            let _e2224 = core_intrinsics_maximum_number_nsz_f32_(_e2223, (_e2207 - _e1279));
                                                                            let _e2225 = core_intrinsics_minimum_number_nsz_f32_((_e2213 + _e1277), (_e2216 + _e1278));
                                                                            let _e2226 = core_intrinsics_minimum_number_nsz_f32_(_e2225, (_e2219 + _e1279));
                                                                            if (_e2224 > _e991) {
                                                                                phi_2733_ = _e2224;
                                                                            } else {
                                                                                phi_2733_ = _e991;
                                                                            }
                                                                            let _e2229 = phi_2733_;
                                                                            if (_e2226 < _e993) {
                                                                                phi_2738_ = _e2226;
                                                                            } else {
                                                                                phi_2738_ = _e993;
                                                                            }
                                                                            let _e2232 = phi_2738_;
                                                                            if (_e2102 < _e2229) {
                                                                                phi_2743_ = _e2229;
                                                                            } else {
                                                                                phi_2743_ = _e2102;
                                                                            }
                                                                            let _e2235 = phi_2743_;
                                                                            if (_e2235 > _e2232) {
                                                                                phi_2748_ = _e2232;
                                                                            } else {
                                                                                phi_2748_ = _e2235;
                                                                            }
                                                                            let _e2238 = phi_2748_;
                                                                            phi_2753_ = lt_bvh_triangle_Intersection(_e2238, (_e2034 / _e2093), (_e2055 / _e2093), (_e2229 <= _e2232));
                                                                        }
                                                                        let _e2244 = phi_2753_;
                                                                        phi_2754_ = _e2244;
                                                                        phi_2755_ = _e2096;
                                                                    } else {
                                                                        phi_2754_ = lt_bvh_triangle_Intersection();
                                                                        phi_2755_ = true;
                                                                    }
                                                                    let _e2246 = phi_2754_;
                                                                    let _e2248 = phi_2755_;
                                                                    if _e2248 {
                                                                        phi_2759_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2759_ = _e2246;
                                                                    }
                                                                    let _e2250 = phi_2759_;
                                                                    if _e2250.is_hit {
                                                                        if (_e2250.t > 0f) {
                                                                            if (_e2250.t < _e136) {
                                                                                let _e2257 = triangles.member[(0u + _e1903)].i0_;
                                                                                let _e2259 = ((_e2257 & 2147483648u) == 0u);
                                                                                if _e2259 {
                                                                                    phi_2977_ = false;
                                                                                    phi_2978_ = false;
                                                                                } else {
                                                                                    if (_e1903 < _e75) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2266 = triangles.member[(0u + _e1903)].i0_;
                                                                                    let _e2267 = (_e2266 & 2147483647u);
                                                                                    let _e2269 = triangles.member[(0u + _e1903)].i1_;
                                                                                    let _e2271 = triangles.member[(0u + _e1903)].i2_;
                                                                                    if (_e2267 < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2275 = vertices.member[(0u + _e2267)];
                                                                                    if (_e2269 < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2279 = vertices.member[(0u + _e2269)];
                                                                                    if (_e2271 < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2283 = vertices.member[(0u + _e2271)];
                                                                                    let _e2284 = array<abi_Vertex, 3>(_e2275, _e2279, _e2283);
                                                                                    local_1 = array<abi_Vertex, 3>(abi_Vertex(_e2284[0].u, _e2284[0].v, _e2284[0].normal, _e2284[0].color, _e2284[0].material), abi_Vertex(_e2284[1].u, _e2284[1].v, _e2284[1].normal, _e2284[1].color, _e2284[1].material), abi_Vertex(_e2284[2].u, _e2284[2].v, _e2284[2].normal, _e2284[2].color, _e2284[2].material));
                                                                                    let _e2309 = local_1[0u].material;
                                                                                    if (_e2309 < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2313 = materials.member[(0u + _e2309)];
                                                                                    if ((_e2313.flags & 1u) == 1u) {
                                                                                        let _e2317 = lt_shaders_surface_barycentric_weights(_e2250.u, _e2250.v);
                                                                                        if (_e2313.cutoff <= 0f) {
                                                                                            phi_2971_ = true;
                                                                                        } else {
                                                                                            let _e2322 = lt_shaders_surface_vertex_color((&local_1), _e2317);
                                                                                            let _e2324 = (_e2313.base_color.w * _e2322.w);
                                                                                            if (_e2313.alpha_size == 0u) {
                                                                                                phi_2968_ = _e2324;
                                                                                            } else {
                                                                                                local.offset = _e2313.alpha_offset;
                                                                                                local.size = _e2313.alpha_size;
                                                                                                local.flags = _e2313.flags;
                                                                                                let _e2333 = lt_shaders_surface_texture_coordinate((&local_1), _e2317);
                                                                                                let _e2336 = _lt_shaders_texture_TextureView_quad((&local), _e2333.x, _e2333.y);
                                                                                                let _e2340 = (_e2336.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2340 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2344 = alpha_texels.member[(0u + _e2340)];
                                                                                                let _e2360 = (_e2336.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2360 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2364 = alpha_texels.member[(0u + _e2360)];
                                                                                                let _e2381 = (_e2336.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2381 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2385 = alpha_texels.member[(0u + _e2381)];
                                                                                                let _e2402 = (_e2336.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2402 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2406 = alpha_texels.member[(0u + _e2402)];
                                                                                                phi_2968_ = (_e2324 * (((((f32(((_e2344 >> bitcast<u32>((((_e2336.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.x) + ((f32(((_e2364 >> bitcast<u32>((((_e2336.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.y)) + ((f32(((_e2385 >> bitcast<u32>((((_e2336.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.z)) + ((f32(((_e2406 >> bitcast<u32>((((_e2336.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.w)));
                                                                                            }
                                                                                            let _e2422 = phi_2968_;
                                                                                            phi_2971_ = (_e2422 >= _e2313.cutoff);
                                                                                        }
                                                                                        let _e2426 = phi_2971_;
                                                                                        phi_2972_ = _e2426;
                                                                                    } else {
                                                                                        phi_2972_ = false;
                                                                                    }
                                                                                    let _e2428 = phi_2972_;
                                                                                    if _e2428 {
                                                                                        phi_2976_ = false;
                                                                                    } else {
                                                                                        phi_2976_ = true;
                                                                                    }
                                                                                    let _e2430 = phi_2976_;
                                                                                    phi_2977_ = _e2430;
                                                                                    phi_2978_ = _e2428;
                                                                                }
                                                                                let _e2432 = phi_2977_;
                                                                                let _e2434 = phi_2978_;
                                                                                phi_2979_ = _e2432;
                                                                                phi_2980_ = _e2259;
                                                                                phi_2981_ = _e2434;
                                                                            } else {
                                                                                phi_2979_ = true;
                                                                                phi_2980_ = false;
                                                                                phi_2981_ = false;
                                                                            }
                                                                            let _e2436 = phi_2979_;
                                                                            let _e2438 = phi_2980_;
                                                                            let _e2440 = phi_2981_;
                                                                            phi_2982_ = _e2436;
                                                                            phi_2983_ = _e2438;
                                                                            phi_2984_ = _e2440;
                                                                        } else {
                                                                            phi_2982_ = true;
                                                                            phi_2983_ = false;
                                                                            phi_2984_ = false;
                                                                        }
                                                                        let _e2442 = phi_2982_;
                                                                        let _e2444 = phi_2983_;
                                                                        let _e2446 = phi_2984_;
                                                                        phi_2985_ = _e2442;
                                                                        phi_2986_ = _e2444;
                                                                        phi_2987_ = _e2446;
                                                                    } else {
                                                                        phi_2985_ = true;
                                                                        phi_2986_ = false;
                                                                        phi_2987_ = false;
                                                                    }
                                                                    let _e2448 = phi_2985_;
                                                                    let _e2450 = phi_2986_;
                                                                    let _e2452 = phi_2987_;
                                                                    if _e2448 {
                                                                        phi_2991_ = false;
                                                                        phi_2992_ = false;
                                                                    } else {
                                                                        phi_2991_ = _e2450;
                                                                        phi_2992_ = _e2452;
                                                                    }
                                                                    let _e2454 = phi_2991_;
                                                                    let _e2456 = phi_2992_;
                                                                    phi_2309_ = (_e1894 & (_e1894 - 1u));
                                                                    phi_2993_ = _e2448;
                                                                    phi_2994_ = _e2454;
                                                                    phi_2995_ = _e2456;
                                                                }
                                                                let _e2458 = phi_2309_;
                                                                let _e2460 = phi_2993_;
                                                                let _e2462 = phi_2994_;
                                                                let _e2464 = phi_2995_;
                                                                local_14 = _e2462;
                                                                local_15 = _e2464;
                                                                continue;
                                                                continuing {
                                                                    phi_2308_ = _e2458;
                                                                    break if !(_e2460);
                                                                }
                                                            }
                                                            let _e2467 = local_10;
                                                            if _e2467 {
                                                                let _e2469 = local_2.group_mask;
                                                                if ((_e2469 & 4278190080u) == 0u) {
                                                                    let _e2473 = local_2.len;
                                                                    if (_e2473 == 0u) {
                                                                        phi_3037_ = false;
                                                                    } else {
                                                                        let _e2477 = local_2.len;
                                                                        local_2.len = (_e2477 - 1u);
                                                                        let _e2480 = local_2.len;
                                                                        if (_e2480 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2485 = local_2.first[(0u + _e2480)];
                                                                        local_2.group = _e2485;
                                                                        let _e2488 = local_2.len;
                                                                        if (_e2488 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2493 = local_2.mask[(0u + _e2488)];
                                                                        local_2.group_mask = _e2493;
                                                                        phi_3037_ = true;
                                                                    }
                                                                    let _e2496 = phi_3037_;
                                                                    phi_3038_ = _e2496;
                                                                } else {
                                                                    phi_3038_ = true;
                                                                }
                                                                let _e2498 = phi_3038_;
                                                                if _e2498 {
                                                                    let _e2500 = local_2.group_mask;
                                                                    let _e2506 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2500)), 32u, (_e2500 == 0u)));
                                                                    let _e2510 = local_2.group_mask;
                                                                    let _e2524 = local_2.group_mask;
                                                                    local_2.group_mask = (_e2524 & ~((1u << bitcast<u32>((_e2506 & 31u)))));
                                                                    let _e2527 = local_2.group;
                                                                    phi_3069_ = (_e2527 + countOneBits(((_e2510 & ~((4294967295u << bitcast<u32>((((_e2506 - 24u) ^ _e1320) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3069_ = 4294967295u;
                                                                }
                                                                let _e2530 = phi_3069_;
                                                                phi_3070_ = _e2530;
                                                                phi_3071_ = false;
                                                                phi_3072_ = false;
                                                            } else {
                                                                phi_3070_ = u32();
                                                                let _e2903 = local_14;
                                                                phi_3071_ = _e2903;
                                                                let _e2906 = local_15;
                                                                phi_3072_ = _e2906;
                                                            }
                                                            let _e2532 = phi_3070_;
                                                            let _e2534 = phi_3071_;
                                                            let _e2536 = phi_3072_;
                                                            phi_1979_ = _e2532;
                                                            let _e2910 = local_16;
                                                            phi_3073_ = _e2910;
                                                            phi_3074_ = false;
                                                            phi_3075_ = _e2534;
                                                            phi_3076_ = _e2536;
                                                        } else {
                                                            phi_1979_ = u32();
                                                            phi_3073_ = false;
                                                            phi_3074_ = true;
                                                            phi_3075_ = false;
                                                            phi_3076_ = false;
                                                        }
                                                        let _e2538 = phi_1979_;
                                                        let _e2540 = phi_3073_;
                                                        let _e2542 = phi_3074_;
                                                        let _e2544 = phi_3075_;
                                                        let _e2546 = phi_3076_;
                                                        local_11 = _e2542;
                                                        local_17 = _e2544;
                                                        local_18 = _e2546;
                                                        continue;
                                                        continuing {
                                                            phi_1978_ = _e2538;
                                                            break if !(_e2540);
                                                        }
                                                    }
                                                    let _e2549 = local_11;
                                                    if _e2549 {
                                                        phi_3080_ = false;
                                                        phi_3081_ = false;
                                                    } else {
                                                        let _e2917 = local_17;
                                                        phi_3080_ = _e2917;
                                                        let _e2920 = local_18;
                                                        phi_3081_ = _e2920;
                                                    }
                                                    let _e2551 = phi_3080_;
                                                    let _e2553 = phi_3081_;
                                                    if _e2551 {
                                                        phi_3085_ = true;
                                                    } else {
                                                        phi_3085_ = _e2553;
                                                    }
                                                    let _e2555 = phi_3085_;
                                                    if _e2555 {
                                                        phi_3089_ = true;
                                                    } else {
                                                        phi_3089_ = false;
                                                    }
                                                    let _e2557 = phi_3089_;
                                                    phi_3090_ = _e2557;
                                                }
                                                let _e2559 = phi_3090_;
                                                phi_3091_ = _e2559;
                                                phi_3092_ = _e1146;
                                            } else {
                                                phi_3091_ = bool();
                                                phi_3092_ = true;
                                            }
                                            let _e2561 = phi_3091_;
                                            let _e2563 = phi_3092_;
                                            if _e2563 {
                                                phi_3096_ = false;
                                            } else {
                                                phi_3096_ = _e2561;
                                            }
                                            let _e2565 = phi_3096_;
                                            if _e2565 {
                                                phi_3100_ = false;
                                            } else {
                                                phi_3100_ = true;
                                            }
                                            let _e2567 = phi_3100_;
                                            phi_3101_ = _e2567;
                                        } else {
                                            phi_3101_ = true;
                                        }
                                        let _e2569 = phi_3101_;
                                        phi_3102_ = _e2569;
                                    } else {
                                        phi_3102_ = true;
                                    }
                                    let _e2571 = phi_3102_;
                                    phi_3103_ = _e2571;
                                } else {
                                    phi_3103_ = true;
                                }
                                let _e2573 = phi_3103_;
                                if _e2573 {
                                }
                                phi_1370_ = (_e930 & (_e930 - 1u));
                                phi_3107_ = _e2573;
                            }
                            let _e2575 = phi_1370_;
                            let _e2577 = phi_3107_;
                            continue;
                            continuing {
                                phi_1369_ = _e2575;
                                break if !(_e2577);
                            }
                        }
                        let _e2580 = local_12;
                        if _e2580 {
                            let _e2582 = local_3.group_mask;
                            if ((_e2582 & 4278190080u) == 0u) {
                                let _e2586 = local_3.len;
                                if (_e2586 == 0u) {
                                    phi_3149_ = false;
                                } else {
                                    let _e2590 = local_3.len;
                                    local_3.len = (_e2590 - 1u);
                                    let _e2593 = local_3.len;
                                    if (_e2593 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2598 = local_3.first[(0u + _e2593)];
                                    local_3.group = _e2598;
                                    let _e2601 = local_3.len;
                                    if (_e2601 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2606 = local_3.mask[(0u + _e2601)];
                                    local_3.group_mask = _e2606;
                                    phi_3149_ = true;
                                }
                                let _e2609 = phi_3149_;
                                phi_3150_ = _e2609;
                            } else {
                                phi_3150_ = true;
                            }
                            let _e2611 = phi_3150_;
                            if _e2611 {
                                let _e2613 = local_3.group_mask;
                                let _e2619 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2613)), 32u, (_e2613 == 0u)));
                                let _e2623 = local_3.group_mask;
                                let _e2637 = local_3.group_mask;
                                local_3.group_mask = (_e2637 & ~((1u << bitcast<u32>((_e2619 & 31u)))));
                                let _e2640 = local_3.group;
                                phi_3181_ = (_e2640 + countOneBits(((_e2623 & ~((4294967295u << bitcast<u32>((((_e2619 - 24u) ^ _e356) & 31u))))) & 255u)));
                            } else {
                                phi_3181_ = 4294967295u;
                            }
                            let _e2643 = phi_3181_;
                            phi_3182_ = _e2643;
                        } else {
                            phi_3182_ = u32();
                        }
                        let _e2645 = phi_3182_;
                        phi_1040_ = _e2645;
                        let _e2941 = local_19;
                        phi_3183_ = _e2941;
                        phi_3184_ = false;
                    } else {
                        phi_1040_ = u32();
                        phi_3183_ = false;
                        phi_3184_ = true;
                    }
                    let _e2647 = phi_1040_;
                    let _e2649 = phi_3183_;
                    let _e2651 = phi_3184_;
                    local_13 = _e2651;
                    continue;
                    continuing {
                        phi_1039_ = _e2647;
                        break if !(_e2649);
                    }
                }
                let _e2654 = local_13;
                if _e2654 {
                    phi_3188_ = false;
                } else {
                    phi_3188_ = true;
                }
                let _e2656 = phi_3188_;
                if _e2656 {
                    phi_3192_ = true;
                } else {
                    phi_3192_ = false;
                }
                let _e2658 = phi_3192_;
                phi_3193_ = _e2658;
            }
            let _e2660 = phi_3193_;
            phi_3194_ = _e2660;
            phi_3195_ = _e203;
        } else {
            phi_3194_ = bool();
            phi_3195_ = true;
        }
        let _e2662 = phi_3194_;
        let _e2664 = phi_3195_;
        if _e2664 {
            phi_3199_ = false;
        } else {
            phi_3199_ = _e2662;
        }
        let _e2666 = phi_3199_;
        if _e2666 {
            phi_3203_ = 0f;
        } else {
            phi_3203_ = 1f;
        }
        let _e2668 = phi_3203_;
        if (_e103 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103)] = _e2668;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
