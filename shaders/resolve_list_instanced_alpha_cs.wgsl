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
    let _e74 = (1f / 255f);
    return vec4<f32>((f32((param & 255u)) * _e74), (f32(((param >> bitcast<u32>(8i)) & 255u)) * _e74), (f32(((param >> bitcast<u32>(16i)) & 255u)) * _e74), (f32((param >> bitcast<u32>(24i))) * _e74));
}

fn lt_shaders_surface_vertex_color(param_1: ptr<function, array<abi_Vertex, 3>>, param_2: vec3<f32>) -> vec4<f32> {
    let _e64 = (*param_1)[0u].color;
    let _e65 = lt_shaders_texture_unorm_bytes(_e64);
    let _e77 = (*param_1)[1u].color;
    let _e78 = lt_shaders_texture_unorm_bytes(_e77);
    let _e94 = (*param_1)[2u].color;
    let _e95 = lt_shaders_texture_unorm_bytes(_e94);
    return vec4<f32>((((_e65.x * param_2.x) + (_e78.x * param_2.y)) + (_e95.x * param_2.z)), (((_e65.y * param_2.x) + (_e78.y * param_2.y)) + (_e95.y * param_2.z)), (((_e65.z * param_2.x) + (_e78.z * param_2.y)) + (_e95.z * param_2.z)), (((_e65.w * param_2.x) + (_e78.w * param_2.y)) + (_e95.w * param_2.z)));
}

fn lt_shaders_surface_texture_coordinate(param_3: ptr<function, array<abi_Vertex, 3>>, param_4: vec3<f32>) -> vec2<f32> {
    let _e64 = (*param_3)[0u].u;
    let _e67 = (*param_3)[0u].v;
    let _e73 = (*param_3)[1u].u;
    let _e76 = (*param_3)[1u].v;
    let _e84 = (*param_3)[2u].u;
    let _e87 = (*param_3)[2u].v;
    return vec2<f32>((((_e64 * param_4.x) + (_e73 * param_4.y)) + (_e84 * param_4.z)), (((_e67 * param_4.x) + (_e76 * param_4.y)) + (_e87 * param_4.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_5: f32, param_6: u32) -> f32 {
    var phi_465_: f32;
    var phi_466_: f32;
    var phi_467_: f32;
    var phi_476_: f32;
    var phi_477_: f32;

    if (param_6 == 0u) {
        phi_467_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e69 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e69 > 1f) {
                phi_465_ = (2f - _e69);
            } else {
                phi_465_ = _e69;
            }
            let _e73 = phi_465_;
            phi_466_ = _e73;
        } else {
            phi_466_ = param_5;
        }
        let _e75 = phi_466_;
        phi_467_ = _e75;
    }
    let _e77 = phi_467_;
    if (_e77 > 0f) {
        if (_e77 < 1f) {
            phi_476_ = _e77;
        } else {
            phi_476_ = 1f;
        }
        let _e81 = phi_476_;
        phi_477_ = _e81;
    } else {
        phi_477_ = 0f;
    }
    let _e83 = phi_477_;
    return _e83;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_403_: u32;
    var phi_417_: u32;
    var phi_424_: u32;
    var phi_429_: u32;
    var phi_435_: u32;
    var phi_440_: u32;
    var phi_442_: texture_Axis;

    let _e64 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e65 = (param_8 - 1u);
    let _e67 = (_e64 * f32(param_8));
    if param_10 {
        let _e74 = select(select(u32(_e67), 0u, (_e67 < bitcast<f32>(0u))), 4294967295u, (_e67 > bitcast<f32>(1333788671u)));
        if (_e65 < _e74) {
            phi_403_ = _e65;
        } else {
            phi_403_ = _e74;
        }
        let _e77 = phi_403_;
        phi_442_ = texture_Axis(_e77, _e77, 0f);
    } else {
        let _e79 = (_e67 + 0.5f);
        let _e86 = select(select(u32(_e79), 0u, (_e79 < bitcast<f32>(0u))), 4294967295u, (_e79 > bitcast<f32>(1333788671u)));
        if (param_8 < _e86) {
            phi_417_ = param_8;
        } else {
            phi_417_ = _e86;
        }
        let _e89 = phi_417_;
        if (param_9 == 0u) {
            phi_424_ = _e65;
        } else {
            phi_424_ = 0u;
        }
        let _e94 = phi_424_;
        if (param_9 == 0u) {
            phi_429_ = 0u;
        } else {
            phi_429_ = _e65;
        }
        let _e97 = phi_429_;
        if (_e89 == 0u) {
            phi_435_ = _e94;
        } else {
            phi_435_ = (_e89 - 1u);
        }
        let _e101 = phi_435_;
        if (_e89 > _e65) {
            phi_440_ = _e97;
        } else {
            phi_440_ = _e89;
        }
        let _e104 = phi_440_;
        phi_442_ = texture_Axis(_e101, _e104, (_e79 - f32(_e89)));
    }
    let _e107 = phi_442_;
    return _e107;
}

fn _lt_shaders_texture_TextureView_quad(param_11: ptr<function, texture_TextureView>, param_12: f32, param_13: f32) -> texture_TexelQuad {
    let _e64 = (*param_11).size;
    let _e65 = (_e64 & 65535u);
    let _e67 = (*param_11).size;
    let _e71 = (*param_11).flags;
    let _e73 = ((_e71 & 4u) != 0u);
    let _e75 = (*param_11).flags;
    let _e79 = lt_shaders_texture_axis(param_12, _e65, ((_e75 >> bitcast<u32>(4u)) & 3u), _e73);
    let _e81 = (*param_11).flags;
    let _e85 = lt_shaders_texture_axis(param_13, (_e67 >> bitcast<u32>(16i)), ((_e81 >> bitcast<u32>(6u)) & 3u), _e73);
    let _e89 = (*param_11).offset;
    let _e96 = (*param_11).offset;
    let _e103 = (*param_11).offset;
    let _e110 = (*param_11).offset;
    return texture_TexelQuad(array<u32, 4>(((_e89 + (_e85.low * _e65)) + _e79.low), ((_e96 + (_e85.low * _e65)) + _e79.high), ((_e103 + (_e85.high * _e65)) + _e79.low), ((_e110 + (_e85.high * _e65)) + _e79.high)), vec4<f32>(((1f - _e79.fraction) * (1f - _e85.fraction)), (_e79.fraction * (1f - _e85.fraction)), ((1f - _e79.fraction) * _e85.fraction), (_e79.fraction * _e85.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_14: f32, param_15: f32) -> f32 {
    var phi_489_: bool;
    var phi_493_: f32;

    if (param_14 != param_14) {
        phi_489_ = true;
    } else {
        let _e63 = (param_15 >= param_14);
        if _e63 {
        }
        phi_489_ = _e63;
    }
    let _e65 = phi_489_;
    if _e65 {
        phi_493_ = param_15;
    } else {
        phi_493_ = param_14;
    }
    let _e67 = phi_493_;
    return _e67;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_16: f32, param_17: f32) -> f32 {
    var phi_505_: bool;
    var phi_509_: f32;

    if (param_16 != param_16) {
        phi_505_ = true;
    } else {
        let _e63 = (param_17 <= param_16);
        if _e63 {
        }
        phi_505_ = _e63;
    }
    let _e65 = phi_505_;
    if _e65 {
        phi_509_ = param_17;
    } else {
        phi_509_ = param_16;
    }
    let _e67 = phi_509_;
    return _e67;
}

fn lt_shaders_surface_barycentric_weights(param_18: f32, param_19: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_18) - param_19), param_18, param_19);
}

fn lt_shaders_evaluate_to_light(param_20: vec3<f32>, param_21: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_21.x - (param_20.x * param_21.w)), (param_21.y - (param_20.y * param_21.w)), (param_21.z - (param_20.z * param_21.w)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_631_: f32;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_709_: bool;
    var phi_713_: bool;
    var phi_787_: f32;
    var phi_794_: f32;
    var phi_802_: f32;
    var phi_809_: f32;
    var phi_817_: f32;
    var phi_824_: f32;
    var phi_841_: f32;
    var phi_846_: f32;
    var phi_851_: f32;
    var phi_872_: u32;
    var phi_877_: u32;
    var phi_882_: u32;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_1028_: u32;
    var phi_1030_: u32;
    var phi_1111_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1138_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1165_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1171_: u32;
    var phi_1174_: u32;
    var phi_1188_: u32;
    var phi_1198_: u32;
    var phi_1208_: u32;
    var phi_1226_: u32;
    var phi_1236_: u32;
    var phi_1246_: u32;
    var phi_1282_: u32;
    var phi_1295_: u32;
    var phi_1300_: u32;
    var phi_1301_: u32;
    var phi_1302_: u32;
    var phi_1172_: u32;
    var phi_1175_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1360_: u32;
    var phi_1410_: f32;
    var phi_1415_: f32;
    var phi_1420_: f32;
    var phi_1428_: f32;
    var phi_1433_: f32;
    var phi_1438_: f32;
    var phi_1585_: bool;
    var phi_1586_: bool;
    var phi_1587_: bool;
    var phi_1591_: bool;
    var phi_1592_: bool;
    var phi_1593_: bool;
    var phi_1594_: bool;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1597_: bool;
    var phi_1598_: bool;
    var phi_1599_: bool;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1612_: bool;
    var phi_1616_: bool;
    var phi_1686_: f32;
    var phi_1693_: f32;
    var phi_1700_: f32;
    var phi_1707_: f32;
    var phi_1714_: f32;
    var phi_1721_: f32;
    var phi_1738_: f32;
    var phi_1743_: f32;
    var phi_1748_: f32;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1785_: u32;
    var phi_1786_: u32;
    var phi_1797_: vec3<f32>;
    var phi_1798_: vec3<f32>;
    var phi_1811_: u32;
    var phi_1816_: u32;
    var phi_1821_: u32;
    var phi_1935_: bool;
    var phi_1936_: bool;
    var phi_1967_: u32;
    var phi_1969_: u32;
    var phi_2050_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2077_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2104_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2110_: u32;
    var phi_2113_: u32;
    var phi_2127_: u32;
    var phi_2137_: u32;
    var phi_2147_: u32;
    var phi_2165_: u32;
    var phi_2175_: u32;
    var phi_2185_: u32;
    var phi_2221_: u32;
    var phi_2234_: u32;
    var phi_2239_: u32;
    var phi_2240_: u32;
    var phi_2241_: u32;
    var phi_2111_: u32;
    var phi_2114_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2299_: u32;
    var phi_2344_: vec3<f32>;
    var phi_2345_: vec3<f32>;
    var phi_2376_: vec3<f32>;
    var phi_2377_: vec3<f32>;
    var phi_2408_: vec3<f32>;
    var phi_2409_: vec3<f32>;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2434_: f32;
    var phi_2435_: f32;
    var phi_2436_: f32;
    var phi_2437_: f32;
    var phi_2445_: f32;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2460_: f32;
    var phi_2461_: f32;
    var phi_2462_: f32;
    var phi_2463_: f32;
    var phi_2471_: f32;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2486_: f32;
    var phi_2487_: f32;
    var phi_2488_: f32;
    var phi_2489_: f32;
    var phi_2497_: f32;
    var phi_2512_: f32;
    var phi_2513_: bool;
    var phi_2514_: f32;
    var phi_2515_: bool;
    var phi_2516_: f32;
    var phi_2517_: bool;
    var phi_2535_: f32;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: f32;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2544_: bool;
    var phi_2545_: f32;
    var phi_2546_: bool;
    var phi_2572_: f32;
    var phi_2581_: f32;
    var phi_2590_: f32;
    var phi_2599_: f32;
    var phi_2606_: f32;
    var phi_2613_: f32;
    var phi_2626_: f32;
    var phi_2635_: f32;
    var phi_2644_: f32;
    var phi_2653_: f32;
    var phi_2660_: f32;
    var phi_2667_: f32;
    var phi_2684_: f32;
    var phi_2689_: f32;
    var phi_2694_: f32;
    var phi_2702_: f32;
    var phi_2707_: f32;
    var phi_2712_: f32;
    var phi_2724_: f32;
    var phi_2729_: f32;
    var phi_2734_: f32;
    var phi_2739_: f32;
    var phi_2744_: lt_bvh_triangle_Intersection;
    var phi_2745_: lt_bvh_triangle_Intersection;
    var phi_2746_: bool;
    var phi_2750_: lt_bvh_triangle_Intersection;
    var phi_2959_: f32;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2967_: bool;
    var phi_2968_: bool;
    var phi_2969_: bool;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var phi_2975_: bool;
    var phi_2976_: bool;
    var phi_2977_: bool;
    var phi_2978_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2300_: u32;
    var phi_2984_: bool;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var local_10: bool;
    var phi_3028_: bool;
    var phi_3029_: bool;
    var phi_3060_: u32;
    var phi_3061_: u32;
    var phi_3062_: bool;
    var phi_3063_: bool;
    var phi_1970_: u32;
    var phi_3064_: bool;
    var phi_3065_: bool;
    var phi_3066_: bool;
    var phi_3067_: bool;
    var local_11: bool;
    var phi_3071_: bool;
    var phi_3072_: bool;
    var phi_3076_: bool;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var phi_3082_: bool;
    var phi_3083_: bool;
    var phi_3087_: bool;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3093_: bool;
    var phi_3094_: bool;
    var phi_1361_: u32;
    var phi_3098_: bool;
    var local_12: bool;
    var phi_3140_: bool;
    var phi_3141_: bool;
    var phi_3172_: u32;
    var phi_3173_: u32;
    var phi_1031_: u32;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var local_13: bool;
    var phi_3179_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_3185_: bool;
    var phi_3186_: bool;
    var phi_3190_: bool;
    var phi_3194_: f32;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

    let _e64 = id_1;
    let _e71 = arrayLength((&nodes.member));
    let _e74 = arrayLength((&triangles.member));
    let _e80 = arrayLength((&list.member));
    let _e86 = arrayLength((&vertices.member));
    let _e92 = arrayLength((&alpha_texels.member));
    if (3u < _e80) {
    } else {
        return;
    }
    let _e96 = list.member[3u];
    if (_e64.x < _e96) {
        let _e99 = (_e64.x + 4u);
        if (_e99 < _e80) {
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
            phi_631_ = 300000000000000000000000000000000000000f;
        } else {
            phi_631_ = 1f;
        }
        let _e136 = phi_631_;
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
                                    phi_683_ = bool();
                                    phi_684_ = true;
                                } else {
                                    let _e155 = (_e145 > 0f);
                                    if _e155 {
                                        phi_682_ = bool();
                                    } else {
                                        phi_682_ = (_e147 > 0f);
                                    }
                                    let _e158 = phi_682_;
                                    phi_683_ = _e158;
                                    phi_684_ = _e155;
                                }
                                let _e160 = phi_683_;
                                let _e162 = phi_684_;
                                if _e162 {
                                    phi_688_ = true;
                                } else {
                                    phi_688_ = _e160;
                                }
                                let _e164 = phi_688_;
                                phi_689_ = _e164;
                                phi_690_ = false;
                            } else {
                                phi_689_ = bool();
                                phi_690_ = true;
                            }
                            let _e166 = phi_689_;
                            let _e168 = phi_690_;
                            phi_691_ = _e166;
                            phi_692_ = false;
                            phi_693_ = _e168;
                        } else {
                            phi_691_ = bool();
                            phi_692_ = true;
                            phi_693_ = false;
                        }
                        let _e170 = phi_691_;
                        let _e172 = phi_692_;
                        let _e174 = phi_693_;
                        phi_694_ = _e170;
                        phi_695_ = _e172;
                        phi_696_ = _e174;
                    } else {
                        phi_694_ = bool();
                        phi_695_ = true;
                        phi_696_ = false;
                    }
                    let _e176 = phi_694_;
                    let _e178 = phi_695_;
                    let _e180 = phi_696_;
                    phi_697_ = _e176;
                    phi_698_ = _e178;
                    phi_699_ = _e180;
                } else {
                    phi_697_ = bool();
                    phi_698_ = true;
                    phi_699_ = false;
                }
                let _e182 = phi_697_;
                let _e184 = phi_698_;
                let _e186 = phi_699_;
                phi_700_ = _e182;
                phi_701_ = _e184;
                phi_702_ = _e186;
            } else {
                phi_700_ = bool();
                phi_701_ = true;
                phi_702_ = false;
            }
            let _e188 = phi_700_;
            let _e190 = phi_701_;
            let _e192 = phi_702_;
            phi_703_ = _e188;
            phi_704_ = _e190;
            phi_705_ = _e192;
        } else {
            phi_703_ = bool();
            phi_704_ = true;
            phi_705_ = false;
        }
        let _e194 = phi_703_;
        let _e196 = phi_704_;
        let _e198 = phi_705_;
        if _e196 {
            phi_709_ = true;
        } else {
            phi_709_ = _e198;
        }
        let _e200 = phi_709_;
        if _e200 {
            phi_713_ = false;
        } else {
            phi_713_ = _e194;
        }
        let _e202 = phi_713_;
        if _e202 {
            let _e203 = (_e105 >= _e71);
            if _e203 {
                phi_3184_ = bool();
            } else {
                if (_e105 < _e71) {
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
                    phi_787_ = _e272;
                } else {
                    phi_787_ = abs(_e138.direction.x);
                }
                let _e279 = phi_787_;
                if (_e138.direction.x < 0f) {
                    phi_794_ = (-1f / _e279);
                } else {
                    phi_794_ = (1f / _e279);
                }
                let _e284 = phi_794_;
                if (abs(_e138.direction.y) < _e272) {
                    phi_802_ = _e272;
                } else {
                    phi_802_ = abs(_e138.direction.y);
                }
                let _e291 = phi_802_;
                if (_e138.direction.y < 0f) {
                    phi_809_ = (-1f / _e291);
                } else {
                    phi_809_ = (1f / _e291);
                }
                let _e296 = phi_809_;
                if (abs(_e138.direction.z) < _e272) {
                    phi_817_ = _e272;
                } else {
                    phi_817_ = abs(_e138.direction.z);
                }
                let _e303 = phi_817_;
                if (_e138.direction.z < 0f) {
                    phi_824_ = (-1f / _e303);
                } else {
                    phi_824_ = (1f / _e303);
                }
                let _e308 = phi_824_;
                let _e312 = abs((bitcast<f32>(_e209) - _e126));
                let _e313 = abs((bitcast<f32>(_e213) - _e128));
                let _e314 = abs((bitcast<f32>(_e217) - _e130));
                let _e318 = abs(((bitcast<f32>(_e221) + (bitcast<f32>((((_e233 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                let _e319 = abs(((bitcast<f32>(_e225) + (bitcast<f32>((((_e233 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                let _e320 = abs(((bitcast<f32>(_e229) + (bitcast<f32>((((_e233 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                if (_e312 > _e318) {
                    phi_841_ = _e312;
                } else {
                    phi_841_ = _e318;
                }
                let _e323 = phi_841_;
                if (_e313 > _e319) {
                    phi_846_ = _e313;
                } else {
                    phi_846_ = _e319;
                }
                let _e326 = phi_846_;
                if (_e314 > _e320) {
                    phi_851_ = _e314;
                } else {
                    phi_851_ = _e320;
                }
                let _e329 = phi_851_;
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
                    phi_872_ = 0u;
                } else {
                    phi_872_ = 1u;
                }
                let _e348 = phi_872_;
                if (_e296 < 0f) {
                    phi_877_ = 0u;
                } else {
                    phi_877_ = 2u;
                }
                let _e351 = phi_877_;
                if (_e308 < 0f) {
                    phi_882_ = 0u;
                } else {
                    phi_882_ = 4u;
                }
                let _e354 = phi_882_;
                let _e356 = ((_e348 | _e351) | _e354);
                let _e357 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e105, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e357.first[0], _e357.first[1], _e357.first[2], _e357.first[3], _e357.first[4], _e357.first[5], _e357.first[6], _e357.first[7], _e357.first[8], _e357.first[9], _e357.first[10], _e357.first[11], _e357.first[12], _e357.first[13], _e357.first[14], _e357.first[15], _e357.first[16], _e357.first[17], _e357.first[18], _e357.first[19], _e357.first[20], _e357.first[21], _e357.first[22], _e357.first[23], _e357.first[24], _e357.first[25], _e357.first[26], _e357.first[27], _e357.first[28], _e357.first[29], _e357.first[30], _e357.first[31]), array<u32, 32>(_e357.mask[0], _e357.mask[1], _e357.mask[2], _e357.mask[3], _e357.mask[4], _e357.mask[5], _e357.mask[6], _e357.mask[7], _e357.mask[8], _e357.mask[9], _e357.mask[10], _e357.mask[11], _e357.mask[12], _e357.mask[13], _e357.mask[14], _e357.mask[15], _e357.mask[16], _e357.mask[17], _e357.mask[18], _e357.mask[19], _e357.mask[20], _e357.mask[21], _e357.mask[22], _e357.mask[23], _e357.mask[24], _e357.mask[25], _e357.mask[26], _e357.mask[27], _e357.mask[28], _e357.mask[29], _e357.mask[30], _e357.mask[31]), _e357.len, _e357.group, _e357.group_mask);
                let _e431 = local_3.group_mask;
                if ((_e431 & 4278190080u) == 0u) {
                    let _e435 = local_3.len;
                    if (_e435 == 0u) {
                        phi_996_ = false;
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
                        phi_996_ = true;
                    }
                    let _e458 = phi_996_;
                    phi_997_ = _e458;
                } else {
                    phi_997_ = true;
                }
                let _e460 = phi_997_;
                if _e460 {
                    let _e462 = local_3.group_mask;
                    let _e468 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, (_e462 == 0u)));
                    let _e472 = local_3.group_mask;
                    let _e486 = local_3.group_mask;
                    local_3.group_mask = (_e486 & ~((1u << bitcast<u32>((_e468 & 31u)))));
                    let _e489 = local_3.group;
                    phi_1028_ = (_e489 + countOneBits(((_e472 & ~((4294967295u << bitcast<u32>((((_e468 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1028_ = 4294967295u;
                }
                let _e492 = phi_1028_;
                phi_1030_ = _e492;
                loop {
                    let _e494 = phi_1030_;
                    if (_e494 != 4294967295u) {
                        if (_e494 < _e71) {
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
                            phi_1111_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e577.unnamed_1.root, _e554.y));
                        } else {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.unnamed.root, _e554.y), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_bvh_traverse_Tree(_e554.z, _e599.unnamed_1.first_primitive));
                            phi_1111_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e605.unnamed_1.root, _e554.w));
                        }
                        let _e613 = phi_1111_;
                        let _e623 = nodes.member[(0u + _e494)].y;
                        if (_e296 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e634.unnamed.root, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_bvh_traverse_Tree(_e623.x, _e640.unnamed_1.first_primitive));
                            phi_1138_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e646.unnamed_1.root, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e623.z, _e668.unnamed_1.first_primitive));
                            phi_1138_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e623.w));
                        }
                        let _e682 = phi_1138_;
                        let _e692 = nodes.member[(0u + _e494)].z;
                        if (_e308 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e703.unnamed.root, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e692.x, _e709.unnamed_1.first_primitive));
                            phi_1165_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e715.unnamed_1.root, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e692.z, _e737.unnamed_1.first_primitive));
                            phi_1165_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e692.w));
                        }
                        let _e751 = phi_1165_;
                        phi_1171_ = 0u;
                        phi_1174_ = 0u;
                        loop {
                            let _e761 = phi_1171_;
                            let _e763 = phi_1174_;
                            local_4 = _e763;
                            local_5 = _e763;
                            local_6 = _e763;
                            let _e764 = (_e761 < 8u);
                            if _e764 {
                                let _e766 = (_e761 >> bitcast<u32>(2i));
                                let _e767 = (_e761 & 3u);
                                if (_e766 == 0u) {
                                    phi_1188_ = _e613.unnamed.root;
                                } else {
                                    phi_1188_ = _e613.unnamed.first_primitive;
                                }
                                let _e770 = phi_1188_;
                                if (_e766 == 0u) {
                                    phi_1198_ = _e682.unnamed.root;
                                } else {
                                    phi_1198_ = _e682.unnamed.first_primitive;
                                }
                                let _e779 = phi_1198_;
                                if (_e766 == 0u) {
                                    phi_1208_ = _e751.unnamed.root;
                                } else {
                                    phi_1208_ = _e751.unnamed.first_primitive;
                                }
                                let _e788 = phi_1208_;
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e770 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e336)), ((f32(((_e779 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e337)));
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(_e801, ((f32(((_e788 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e338)));
                                if (_e766 == 0u) {
                                    phi_1226_ = _e613.unnamed_1.root;
                                } else {
                                    phi_1226_ = _e613.unnamed_1.first_primitive;
                                }
                                let _e805 = phi_1226_;
                                if (_e766 == 0u) {
                                    phi_1236_ = _e682.unnamed_1.root;
                                } else {
                                    phi_1236_ = _e682.unnamed_1.first_primitive;
                                }
                                let _e814 = phi_1236_;
                                if (_e766 == 0u) {
                                    phi_1246_ = _e751.unnamed_1.root;
                                } else {
                                    phi_1246_ = _e751.unnamed_1.first_primitive;
                                }
                                let _e823 = phi_1246_;
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e805 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e336)), ((f32(((_e814 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e337)));
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(_e836, ((f32(((_e823 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e338)));
                                if (_e802 <= _e837) {
                                    if (_e802 <= _e136) {
                                        if (_e837 >= 0f) {
                                            if (_e766 == 0u) {
                                                let _e844 = nodes.member[(0u + _e494)].links[2u];
                                                phi_1282_ = _e844;
                                            } else {
                                                let _e847 = nodes.member[(0u + _e494)].links[3u];
                                                phi_1282_ = _e847;
                                            }
                                            let _e849 = phi_1282_;
                                            let _e854 = ((_e849 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u);
                                            let _e855 = (_e854 & 31u);
                                            if (_e855 >= 24u) {
                                                phi_1295_ = (24u + ((_e855 - 24u) ^ _e356));
                                            } else {
                                                phi_1295_ = _e855;
                                            }
                                            let _e861 = phi_1295_;
                                            phi_1300_ = (_e763 | ((_e854 >> bitcast<u32>(5i)) << bitcast<u32>((_e861 & 31u))));
                                        } else {
                                            phi_1300_ = _e763;
                                        }
                                        let _e869 = phi_1300_;
                                        phi_1301_ = _e869;
                                    } else {
                                        phi_1301_ = _e763;
                                    }
                                    let _e871 = phi_1301_;
                                    phi_1302_ = _e871;
                                } else {
                                    phi_1302_ = _e763;
                                }
                                let _e873 = phi_1302_;
                                phi_1172_ = (_e761 + 1u);
                                phi_1175_ = _e873;
                            } else {
                                phi_1172_ = u32();
                                phi_1175_ = u32();
                            }
                            let _e876 = phi_1172_;
                            let _e878 = phi_1175_;
                            continue;
                            continuing {
                                phi_1171_ = _e876;
                                phi_1174_ = _e878;
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
                        phi_1360_ = (_e927 & 16777215u);
                        loop {
                            let _e930 = phi_1360_;
                            let _e931 = (_e930 == 0u);
                            local_12 = _e931;
                            local_19 = _e931;
                            if _e931 {
                                phi_1361_ = u32();
                                phi_3098_ = false;
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
                                    phi_1410_ = _e954;
                                } else {
                                    phi_1410_ = _e963;
                                }
                                let _e968 = phi_1410_;
                                if (_e955 < _e964) {
                                    phi_1415_ = _e955;
                                } else {
                                    phi_1415_ = _e964;
                                }
                                let _e971 = phi_1415_;
                                if (_e956 < _e965) {
                                    phi_1420_ = _e956;
                                } else {
                                    phi_1420_ = _e965;
                                }
                                let _e974 = phi_1420_;
                                if (_e954 > _e963) {
                                    phi_1428_ = _e954;
                                } else {
                                    phi_1428_ = _e963;
                                }
                                let _e980 = phi_1428_;
                                if (_e955 > _e964) {
                                    phi_1433_ = _e955;
                                } else {
                                    phi_1433_ = _e964;
                                }
                                let _e983 = phi_1433_;
                                if (_e956 > _e965) {
                                    phi_1438_ = _e956;
                                } else {
                                    phi_1438_ = _e965;
                                }
                                let _e986 = phi_1438_;
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
                                                                        phi_1586_ = bool();
                                                                        phi_1587_ = true;
                                                                    } else {
                                                                        let _e1098 = (_e1089 > 0f);
                                                                        if _e1098 {
                                                                            phi_1585_ = bool();
                                                                        } else {
                                                                            phi_1585_ = (_e1090 > 0f);
                                                                        }
                                                                        let _e1101 = phi_1585_;
                                                                        phi_1586_ = _e1101;
                                                                        phi_1587_ = _e1098;
                                                                    }
                                                                    let _e1103 = phi_1586_;
                                                                    let _e1105 = phi_1587_;
                                                                    if _e1105 {
                                                                        phi_1591_ = true;
                                                                    } else {
                                                                        phi_1591_ = _e1103;
                                                                    }
                                                                    let _e1107 = phi_1591_;
                                                                    phi_1592_ = _e1107;
                                                                    phi_1593_ = false;
                                                                } else {
                                                                    phi_1592_ = bool();
                                                                    phi_1593_ = true;
                                                                }
                                                                let _e1109 = phi_1592_;
                                                                let _e1111 = phi_1593_;
                                                                phi_1594_ = _e1109;
                                                                phi_1595_ = false;
                                                                phi_1596_ = _e1111;
                                                            } else {
                                                                phi_1594_ = bool();
                                                                phi_1595_ = true;
                                                                phi_1596_ = false;
                                                            }
                                                            let _e1113 = phi_1594_;
                                                            let _e1115 = phi_1595_;
                                                            let _e1117 = phi_1596_;
                                                            phi_1597_ = _e1113;
                                                            phi_1598_ = _e1115;
                                                            phi_1599_ = _e1117;
                                                        } else {
                                                            phi_1597_ = bool();
                                                            phi_1598_ = true;
                                                            phi_1599_ = false;
                                                        }
                                                        let _e1119 = phi_1597_;
                                                        let _e1121 = phi_1598_;
                                                        let _e1123 = phi_1599_;
                                                        phi_1600_ = _e1119;
                                                        phi_1601_ = _e1121;
                                                        phi_1602_ = _e1123;
                                                    } else {
                                                        phi_1600_ = bool();
                                                        phi_1601_ = true;
                                                        phi_1602_ = false;
                                                    }
                                                    let _e1125 = phi_1600_;
                                                    let _e1127 = phi_1601_;
                                                    let _e1129 = phi_1602_;
                                                    phi_1603_ = _e1125;
                                                    phi_1604_ = _e1127;
                                                    phi_1605_ = _e1129;
                                                } else {
                                                    phi_1603_ = bool();
                                                    phi_1604_ = true;
                                                    phi_1605_ = false;
                                                }
                                                let _e1131 = phi_1603_;
                                                let _e1133 = phi_1604_;
                                                let _e1135 = phi_1605_;
                                                phi_1606_ = _e1131;
                                                phi_1607_ = _e1133;
                                                phi_1608_ = _e1135;
                                            } else {
                                                phi_1606_ = bool();
                                                phi_1607_ = true;
                                                phi_1608_ = false;
                                            }
                                            let _e1137 = phi_1606_;
                                            let _e1139 = phi_1607_;
                                            let _e1141 = phi_1608_;
                                            if _e1139 {
                                                phi_1612_ = true;
                                            } else {
                                                phi_1612_ = _e1141;
                                            }
                                            let _e1143 = phi_1612_;
                                            if _e1143 {
                                                phi_1616_ = false;
                                            } else {
                                                phi_1616_ = _e1137;
                                            }
                                            let _e1145 = phi_1616_;
                                            if _e1145 {
                                                let _e1146 = (_e1082 >= _e71);
                                                if _e1146 {
                                                    phi_3081_ = bool();
                                                } else {
                                                    if (_e1082 < _e71) {
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
                                                        phi_1686_ = _e1212;
                                                    } else {
                                                        phi_1686_ = abs(_e1053);
                                                    }
                                                    let _e1217 = phi_1686_;
                                                    if (_e1053 < 0f) {
                                                        phi_1693_ = (-1f / _e1217);
                                                    } else {
                                                        phi_1693_ = (1f / _e1217);
                                                    }
                                                    let _e1222 = phi_1693_;
                                                    if (abs(_e1066) < _e1212) {
                                                        phi_1700_ = _e1212;
                                                    } else {
                                                        phi_1700_ = abs(_e1066);
                                                    }
                                                    let _e1227 = phi_1700_;
                                                    if (_e1066 < 0f) {
                                                        phi_1707_ = (-1f / _e1227);
                                                    } else {
                                                        phi_1707_ = (1f / _e1227);
                                                    }
                                                    let _e1232 = phi_1707_;
                                                    if (abs(_e1079) < _e1212) {
                                                        phi_1714_ = _e1212;
                                                    } else {
                                                        phi_1714_ = abs(_e1079);
                                                    }
                                                    let _e1237 = phi_1714_;
                                                    if (_e1079 < 0f) {
                                                        phi_1721_ = (-1f / _e1237);
                                                    } else {
                                                        phi_1721_ = (1f / _e1237);
                                                    }
                                                    let _e1242 = phi_1721_;
                                                    let _e1246 = abs((bitcast<f32>(_e1152) - _e1010));
                                                    let _e1247 = abs((bitcast<f32>(_e1156) - _e1023));
                                                    let _e1248 = abs((bitcast<f32>(_e1160) - _e1036));
                                                    let _e1252 = abs(((bitcast<f32>(_e1164) + (bitcast<f32>((((_e1176 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1010));
                                                    let _e1253 = abs(((bitcast<f32>(_e1168) + (bitcast<f32>((((_e1176 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1023));
                                                    let _e1254 = abs(((bitcast<f32>(_e1172) + (bitcast<f32>((((_e1176 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1036));
                                                    if (_e1246 > _e1252) {
                                                        phi_1738_ = _e1246;
                                                    } else {
                                                        phi_1738_ = _e1252;
                                                    }
                                                    let _e1257 = phi_1738_;
                                                    if (_e1247 > _e1253) {
                                                        phi_1743_ = _e1247;
                                                    } else {
                                                        phi_1743_ = _e1253;
                                                    }
                                                    let _e1260 = phi_1743_;
                                                    if (_e1248 > _e1254) {
                                                        phi_1748_ = _e1248;
                                                    } else {
                                                        phi_1748_ = _e1254;
                                                    }
                                                    let _e1263 = phi_1748_;
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
                                                            phi_1776_ = false;
                                                        } else {
                                                            phi_1776_ = true;
                                                        }
                                                        let _e1286 = phi_1776_;
                                                        phi_1777_ = _e1286;
                                                    } else {
                                                        phi_1777_ = true;
                                                    }
                                                    let _e1288 = phi_1777_;
                                                    if _e1288 {
                                                        if (_e1281 >= _e1282) {
                                                            phi_1785_ = 1u;
                                                        } else {
                                                            phi_1785_ = 2u;
                                                        }
                                                        let _e1291 = phi_1785_;
                                                        phi_1786_ = _e1291;
                                                    } else {
                                                        phi_1786_ = 0u;
                                                    }
                                                    let _e1293 = phi_1786_;
                                                    if (_e1293 == 0u) {
                                                        phi_1798_ = vec3<f32>(_e1066, _e1079, _e1053);
                                                    } else {
                                                        if (_e1293 == 1u) {
                                                            phi_1797_ = vec3<f32>(_e1079, _e1053, _e1066);
                                                        } else {
                                                            phi_1797_ = vec3<f32>(_e1053, _e1066, _e1079);
                                                        }
                                                        let _e1299 = phi_1797_;
                                                        phi_1798_ = _e1299;
                                                    }
                                                    let _e1301 = phi_1798_;
                                                    let _e1304 = (_e1301.x / _e1301.z);
                                                    let _e1307 = (_e1301.y / _e1301.z);
                                                    let _e1309 = (1f / _e1301.z);
                                                    if (_e1222 < 0f) {
                                                        phi_1811_ = 0u;
                                                    } else {
                                                        phi_1811_ = 1u;
                                                    }
                                                    let _e1312 = phi_1811_;
                                                    if (_e1232 < 0f) {
                                                        phi_1816_ = 0u;
                                                    } else {
                                                        phi_1816_ = 2u;
                                                    }
                                                    let _e1315 = phi_1816_;
                                                    if (_e1242 < 0f) {
                                                        phi_1821_ = 0u;
                                                    } else {
                                                        phi_1821_ = 4u;
                                                    }
                                                    let _e1318 = phi_1821_;
                                                    let _e1320 = ((_e1312 | _e1315) | _e1318);
                                                    let _e1321 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1082, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1321.first[0], _e1321.first[1], _e1321.first[2], _e1321.first[3], _e1321.first[4], _e1321.first[5], _e1321.first[6], _e1321.first[7], _e1321.first[8], _e1321.first[9], _e1321.first[10], _e1321.first[11], _e1321.first[12], _e1321.first[13], _e1321.first[14], _e1321.first[15], _e1321.first[16], _e1321.first[17], _e1321.first[18], _e1321.first[19], _e1321.first[20], _e1321.first[21], _e1321.first[22], _e1321.first[23], _e1321.first[24], _e1321.first[25], _e1321.first[26], _e1321.first[27], _e1321.first[28], _e1321.first[29], _e1321.first[30], _e1321.first[31]), array<u32, 32>(_e1321.mask[0], _e1321.mask[1], _e1321.mask[2], _e1321.mask[3], _e1321.mask[4], _e1321.mask[5], _e1321.mask[6], _e1321.mask[7], _e1321.mask[8], _e1321.mask[9], _e1321.mask[10], _e1321.mask[11], _e1321.mask[12], _e1321.mask[13], _e1321.mask[14], _e1321.mask[15], _e1321.mask[16], _e1321.mask[17], _e1321.mask[18], _e1321.mask[19], _e1321.mask[20], _e1321.mask[21], _e1321.mask[22], _e1321.mask[23], _e1321.mask[24], _e1321.mask[25], _e1321.mask[26], _e1321.mask[27], _e1321.mask[28], _e1321.mask[29], _e1321.mask[30], _e1321.mask[31]), _e1321.len, _e1321.group, _e1321.group_mask);
                                                    let _e1395 = local_2.group_mask;
                                                    if ((_e1395 & 4278190080u) == 0u) {
                                                        let _e1399 = local_2.len;
                                                        if (_e1399 == 0u) {
                                                            phi_1935_ = false;
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
                                                            phi_1935_ = true;
                                                        }
                                                        let _e1422 = phi_1935_;
                                                        phi_1936_ = _e1422;
                                                    } else {
                                                        phi_1936_ = true;
                                                    }
                                                    let _e1424 = phi_1936_;
                                                    if _e1424 {
                                                        let _e1426 = local_2.group_mask;
                                                        let _e1432 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1426)), 32u, (_e1426 == 0u)));
                                                        let _e1436 = local_2.group_mask;
                                                        let _e1450 = local_2.group_mask;
                                                        local_2.group_mask = (_e1450 & ~((1u << bitcast<u32>((_e1432 & 31u)))));
                                                        let _e1453 = local_2.group;
                                                        phi_1967_ = (_e1453 + countOneBits(((_e1436 & ~((4294967295u << bitcast<u32>((((_e1432 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1967_ = 4294967295u;
                                                    }
                                                    let _e1456 = phi_1967_;
                                                    phi_1969_ = _e1456;
                                                    loop {
                                                        let _e1458 = phi_1969_;
                                                        if (_e1458 != 4294967295u) {
                                                            if (_e1458 < _e71) {
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
                                                                phi_2050_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_bvh_traverse_Tree(_e1541.unnamed_1.root, _e1518.y));
                                                            } else {
                                                                let _e1557 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1518.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1563 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1557.unnamed.root, _e1518.y), _e1557.unnamed_1);
                                                                let _e1569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1563.unnamed, lt_bvh_traverse_Tree(_e1518.z, _e1563.unnamed_1.first_primitive));
                                                                phi_2050_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1569.unnamed, lt_bvh_traverse_Tree(_e1569.unnamed_1.root, _e1518.w));
                                                            }
                                                            let _e1577 = phi_2050_;
                                                            let _e1587 = nodes.member[(0u + _e1458)].y;
                                                            if (_e1232 < 0f) {
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1587.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1598.unnamed.root, _e1587.w), _e1598.unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_bvh_traverse_Tree(_e1587.x, _e1604.unnamed_1.first_primitive));
                                                                phi_2077_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_bvh_traverse_Tree(_e1610.unnamed_1.root, _e1587.y));
                                                            } else {
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1587.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1626.unnamed.root, _e1587.y), _e1626.unnamed_1);
                                                                let _e1638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_bvh_traverse_Tree(_e1587.z, _e1632.unnamed_1.first_primitive));
                                                                phi_2077_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1638.unnamed, lt_bvh_traverse_Tree(_e1638.unnamed_1.root, _e1587.w));
                                                            }
                                                            let _e1646 = phi_2077_;
                                                            let _e1656 = nodes.member[(0u + _e1458)].z;
                                                            if (_e1242 < 0f) {
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1667.unnamed.root, _e1656.w), _e1667.unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_bvh_traverse_Tree(_e1656.x, _e1673.unnamed_1.first_primitive));
                                                                phi_2104_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_bvh_traverse_Tree(_e1679.unnamed_1.root, _e1656.y));
                                                            } else {
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1695.unnamed.root, _e1656.y), _e1695.unnamed_1);
                                                                let _e1707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_bvh_traverse_Tree(_e1656.z, _e1701.unnamed_1.first_primitive));
                                                                phi_2104_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1707.unnamed, lt_bvh_traverse_Tree(_e1707.unnamed_1.root, _e1656.w));
                                                            }
                                                            let _e1715 = phi_2104_;
                                                            phi_2110_ = 0u;
                                                            phi_2113_ = 0u;
                                                            loop {
                                                                let _e1725 = phi_2110_;
                                                                let _e1727 = phi_2113_;
                                                                local_7 = _e1727;
                                                                local_8 = _e1727;
                                                                local_9 = _e1727;
                                                                let _e1728 = (_e1725 < 8u);
                                                                if _e1728 {
                                                                    let _e1730 = (_e1725 >> bitcast<u32>(2i));
                                                                    let _e1731 = (_e1725 & 3u);
                                                                    if (_e1730 == 0u) {
                                                                        phi_2127_ = _e1577.unnamed.root;
                                                                    } else {
                                                                        phi_2127_ = _e1577.unnamed.first_primitive;
                                                                    }
                                                                    let _e1734 = phi_2127_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2137_ = _e1646.unnamed.root;
                                                                    } else {
                                                                        phi_2137_ = _e1646.unnamed.first_primitive;
                                                                    }
                                                                    let _e1743 = phi_2137_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2147_ = _e1715.unnamed.root;
                                                                    } else {
                                                                        phi_2147_ = _e1715.unnamed.first_primitive;
                                                                    }
                                                                    let _e1752 = phi_2147_;
                                                                    let _e1765 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1734 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 - _e1270)), ((f32(((_e1743 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1491) + (_e1509 - _e1271)));
                                                                    let _e1766 = core_intrinsics_maximum_number_nsz_f32_(_e1765, ((f32(((_e1752 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 - _e1272)));
                                                                    if (_e1730 == 0u) {
                                                                        phi_2165_ = _e1577.unnamed_1.root;
                                                                    } else {
                                                                        phi_2165_ = _e1577.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1769 = phi_2165_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2175_ = _e1646.unnamed_1.root;
                                                                    } else {
                                                                        phi_2175_ = _e1646.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1778 = phi_2175_;
                                                                    if (_e1730 == 0u) {
                                                                        phi_2185_ = _e1715.unnamed_1.root;
                                                                    } else {
                                                                        phi_2185_ = _e1715.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1787 = phi_2185_;
                                                                    let _e1800 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1769 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 + _e1270)), ((f32(((_e1778 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1491) + (_e1509 + _e1271)));
                                                                    let _e1801 = core_intrinsics_minimum_number_nsz_f32_(_e1800, ((f32(((_e1787 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 + _e1272)));
                                                                    if (_e1766 <= _e1801) {
                                                                        if (_e1766 <= _e136) {
                                                                            if (_e1801 >= 0f) {
                                                                                if (_e1730 == 0u) {
                                                                                    let _e1808 = nodes.member[(0u + _e1458)].links[2u];
                                                                                    phi_2221_ = _e1808;
                                                                                } else {
                                                                                    let _e1811 = nodes.member[(0u + _e1458)].links[3u];
                                                                                    phi_2221_ = _e1811;
                                                                                }
                                                                                let _e1813 = phi_2221_;
                                                                                let _e1818 = ((_e1813 >> bitcast<u32>(((_e1731 * 8u) & 31u))) & 255u);
                                                                                let _e1819 = (_e1818 & 31u);
                                                                                if (_e1819 >= 24u) {
                                                                                    phi_2234_ = (24u + ((_e1819 - 24u) ^ _e1320));
                                                                                } else {
                                                                                    phi_2234_ = _e1819;
                                                                                }
                                                                                let _e1825 = phi_2234_;
                                                                                phi_2239_ = (_e1727 | ((_e1818 >> bitcast<u32>(5i)) << bitcast<u32>((_e1825 & 31u))));
                                                                            } else {
                                                                                phi_2239_ = _e1727;
                                                                            }
                                                                            let _e1833 = phi_2239_;
                                                                            phi_2240_ = _e1833;
                                                                        } else {
                                                                            phi_2240_ = _e1727;
                                                                        }
                                                                        let _e1835 = phi_2240_;
                                                                        phi_2241_ = _e1835;
                                                                    } else {
                                                                        phi_2241_ = _e1727;
                                                                    }
                                                                    let _e1837 = phi_2241_;
                                                                    phi_2111_ = (_e1725 + 1u);
                                                                    phi_2114_ = _e1837;
                                                                } else {
                                                                    phi_2111_ = u32();
                                                                    phi_2114_ = u32();
                                                                }
                                                                let _e1840 = phi_2111_;
                                                                let _e1842 = phi_2114_;
                                                                continue;
                                                                continuing {
                                                                    phi_2110_ = _e1840;
                                                                    phi_2113_ = _e1842;
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
                                                            phi_2299_ = (_e1891 & 16777215u);
                                                            loop {
                                                                let _e1894 = phi_2299_;
                                                                let _e1895 = (_e1894 == 0u);
                                                                local_10 = _e1895;
                                                                local_16 = _e1895;
                                                                if _e1895 {
                                                                    phi_2300_ = u32();
                                                                    phi_2984_ = false;
                                                                    phi_2985_ = false;
                                                                    phi_2986_ = false;
                                                                } else {
                                                                    let _e1898 = nodes.member[(0u + _e1458)].links[1u];
                                                                    let _e1903 = ((_e1084 + _e1898) + select(firstTrailingBit(_e1894), 32u, (_e1894 == 0u)));
                                                                    if (_e1903 < _e74) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1910 = triangles.member[(0u + _e1903)].v0_;
                                                                    let _e1912 = (_e1910.x - _e1010);
                                                                    let _e1914 = (_e1910.y - _e1023);
                                                                    let _e1916 = (_e1910.z - _e1036);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2345_ = vec3<f32>(_e1914, _e1916, _e1912);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2344_ = vec3<f32>(_e1916, _e1912, _e1914);
                                                                        } else {
                                                                            phi_2344_ = (_e1910 - vec3<f32>(_e1010, _e1023, _e1036));
                                                                        }
                                                                        let _e1924 = phi_2344_;
                                                                        phi_2345_ = _e1924;
                                                                    }
                                                                    let _e1926 = phi_2345_;
                                                                    let _e1930 = (_e1926.x - (_e1304 * _e1926.z));
                                                                    let _e1934 = (_e1926.y - (_e1307 * _e1926.z));
                                                                    let _e1938 = triangles.member[(0u + _e1903)].v1_;
                                                                    let _e1940 = (_e1938.x - _e1010);
                                                                    let _e1942 = (_e1938.y - _e1023);
                                                                    let _e1944 = (_e1938.z - _e1036);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2377_ = vec3<f32>(_e1942, _e1944, _e1940);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2376_ = vec3<f32>(_e1944, _e1940, _e1942);
                                                                        } else {
                                                                            phi_2376_ = (_e1938 - vec3<f32>(_e1010, _e1023, _e1036));
                                                                        }
                                                                        let _e1952 = phi_2376_;
                                                                        phi_2377_ = _e1952;
                                                                    }
                                                                    let _e1954 = phi_2377_;
                                                                    let _e1958 = (_e1954.x - (_e1304 * _e1954.z));
                                                                    let _e1962 = (_e1954.y - (_e1307 * _e1954.z));
                                                                    let _e1966 = triangles.member[(0u + _e1903)].v2_;
                                                                    let _e1968 = (_e1966.x - _e1010);
                                                                    let _e1970 = (_e1966.y - _e1023);
                                                                    let _e1972 = (_e1966.z - _e1036);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2409_ = vec3<f32>(_e1970, _e1972, _e1968);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2408_ = vec3<f32>(_e1972, _e1968, _e1970);
                                                                        } else {
                                                                            phi_2408_ = (_e1966 - vec3<f32>(_e1010, _e1023, _e1036));
                                                                        }
                                                                        let _e1980 = phi_2408_;
                                                                        phi_2409_ = _e1980;
                                                                    }
                                                                    let _e1982 = phi_2409_;
                                                                    let _e1986 = (_e1982.x - (_e1304 * _e1982.z));
                                                                    let _e1990 = (_e1982.y - (_e1307 * _e1982.z));
                                                                    if (_e1958 < _e1986) {
                                                                        phi_2430_ = true;
                                                                    } else {
                                                                        if (_e1958 == _e1986) {
                                                                            phi_2429_ = (_e1962 < _e1990);
                                                                        } else {
                                                                            phi_2429_ = false;
                                                                        }
                                                                        let _e1997 = phi_2429_;
                                                                        phi_2430_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2430_;
                                                                    if _e1999 {
                                                                        phi_2434_ = _e1990;
                                                                        phi_2435_ = _e1986;
                                                                        phi_2436_ = _e1962;
                                                                        phi_2437_ = _e1958;
                                                                    } else {
                                                                        phi_2434_ = _e1962;
                                                                        phi_2435_ = _e1958;
                                                                        phi_2436_ = _e1990;
                                                                        phi_2437_ = _e1986;
                                                                    }
                                                                    let _e2001 = phi_2434_;
                                                                    let _e2003 = phi_2435_;
                                                                    let _e2005 = phi_2436_;
                                                                    let _e2007 = phi_2437_;
                                                                    let _e2010 = ((_e2007 * _e2001) - (_e2005 * _e2003));
                                                                    if _e1999 {
                                                                        phi_2445_ = -(_e2010);
                                                                    } else {
                                                                        phi_2445_ = _e2010;
                                                                    }
                                                                    let _e2013 = phi_2445_;
                                                                    if (_e1986 < _e1930) {
                                                                        phi_2456_ = true;
                                                                    } else {
                                                                        if (_e1986 == _e1930) {
                                                                            phi_2455_ = (_e1990 < _e1934);
                                                                        } else {
                                                                            phi_2455_ = false;
                                                                        }
                                                                        let _e2018 = phi_2455_;
                                                                        phi_2456_ = _e2018;
                                                                    }
                                                                    let _e2020 = phi_2456_;
                                                                    if _e2020 {
                                                                        phi_2460_ = _e1934;
                                                                        phi_2461_ = _e1930;
                                                                        phi_2462_ = _e1990;
                                                                        phi_2463_ = _e1986;
                                                                    } else {
                                                                        phi_2460_ = _e1990;
                                                                        phi_2461_ = _e1986;
                                                                        phi_2462_ = _e1934;
                                                                        phi_2463_ = _e1930;
                                                                    }
                                                                    let _e2022 = phi_2460_;
                                                                    let _e2024 = phi_2461_;
                                                                    let _e2026 = phi_2462_;
                                                                    let _e2028 = phi_2463_;
                                                                    let _e2031 = ((_e2028 * _e2022) - (_e2026 * _e2024));
                                                                    if _e2020 {
                                                                        phi_2471_ = -(_e2031);
                                                                    } else {
                                                                        phi_2471_ = _e2031;
                                                                    }
                                                                    let _e2034 = phi_2471_;
                                                                    if (_e1930 < _e1958) {
                                                                        phi_2482_ = true;
                                                                    } else {
                                                                        if (_e1930 == _e1958) {
                                                                            phi_2481_ = (_e1934 < _e1962);
                                                                        } else {
                                                                            phi_2481_ = false;
                                                                        }
                                                                        let _e2039 = phi_2481_;
                                                                        phi_2482_ = _e2039;
                                                                    }
                                                                    let _e2041 = phi_2482_;
                                                                    if _e2041 {
                                                                        phi_2486_ = _e1962;
                                                                        phi_2487_ = _e1958;
                                                                        phi_2488_ = _e1934;
                                                                        phi_2489_ = _e1930;
                                                                    } else {
                                                                        phi_2486_ = _e1934;
                                                                        phi_2487_ = _e1930;
                                                                        phi_2488_ = _e1962;
                                                                        phi_2489_ = _e1958;
                                                                    }
                                                                    let _e2043 = phi_2486_;
                                                                    let _e2045 = phi_2487_;
                                                                    let _e2047 = phi_2488_;
                                                                    let _e2049 = phi_2489_;
                                                                    let _e2052 = ((_e2049 * _e2043) - (_e2047 * _e2045));
                                                                    if _e2041 {
                                                                        phi_2497_ = -(_e2052);
                                                                    } else {
                                                                        phi_2497_ = _e2052;
                                                                    }
                                                                    let _e2055 = phi_2497_;
                                                                    if (_e2013 >= 0f) {
                                                                        if (_e2034 >= 0f) {
                                                                            if (_e2055 >= 0f) {
                                                                                phi_2512_ = ((_e2013 + _e2034) + _e2055);
                                                                                phi_2513_ = false;
                                                                            } else {
                                                                                phi_2512_ = f32();
                                                                                phi_2513_ = true;
                                                                            }
                                                                            let _e2062 = phi_2512_;
                                                                            let _e2064 = phi_2513_;
                                                                            phi_2514_ = _e2062;
                                                                            phi_2515_ = _e2064;
                                                                        } else {
                                                                            phi_2514_ = f32();
                                                                            phi_2515_ = true;
                                                                        }
                                                                        let _e2066 = phi_2514_;
                                                                        let _e2068 = phi_2515_;
                                                                        phi_2516_ = _e2066;
                                                                        phi_2517_ = _e2068;
                                                                    } else {
                                                                        phi_2516_ = f32();
                                                                        phi_2517_ = true;
                                                                    }
                                                                    let _e2070 = phi_2516_;
                                                                    let _e2072 = phi_2517_;
                                                                    if _e2072 {
                                                                        if (_e2013 <= 0f) {
                                                                            if (_e2034 <= 0f) {
                                                                                let _e2075 = (_e2055 <= 0f);
                                                                                if _e2075 {
                                                                                }
                                                                                phi_2535_ = ((_e2013 + _e2034) + _e2055);
                                                                                phi_2536_ = false;
                                                                                phi_2537_ = _e2075;
                                                                            } else {
                                                                                phi_2535_ = f32();
                                                                                phi_2536_ = true;
                                                                                phi_2537_ = false;
                                                                            }
                                                                            let _e2079 = phi_2535_;
                                                                            let _e2081 = phi_2536_;
                                                                            let _e2083 = phi_2537_;
                                                                            phi_2538_ = _e2079;
                                                                            phi_2539_ = _e2081;
                                                                            phi_2540_ = _e2083;
                                                                        } else {
                                                                            phi_2538_ = f32();
                                                                            phi_2539_ = true;
                                                                            phi_2540_ = false;
                                                                        }
                                                                        let _e2085 = phi_2538_;
                                                                        let _e2087 = phi_2539_;
                                                                        let _e2089 = phi_2540_;
                                                                        if _e2087 {
                                                                            phi_2544_ = false;
                                                                        } else {
                                                                            phi_2544_ = _e2089;
                                                                        }
                                                                        let _e2091 = phi_2544_;
                                                                        phi_2545_ = _e2085;
                                                                        phi_2546_ = _e2091;
                                                                    } else {
                                                                        phi_2545_ = _e2070;
                                                                        phi_2546_ = true;
                                                                    }
                                                                    let _e2093 = phi_2545_;
                                                                    let _e2095 = phi_2546_;
                                                                    if _e2095 {
                                                                        let _e2096 = (_e2093 == 0f);
                                                                        if _e2096 {
                                                                            phi_2744_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2102 = ((((_e2013 * (_e1309 * _e1926.z)) + (_e2034 * (_e1309 * _e1954.z))) + (_e2055 * (_e1309 * _e1982.z))) / _e2093);
                                                                            let _e2104 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2106 = triangles.member[(0u + _e1903)].v1_;
                                                                            if (_e2104.x < _e2106.x) {
                                                                                phi_2572_ = _e2104.x;
                                                                            } else {
                                                                                phi_2572_ = _e2106.x;
                                                                            }
                                                                            let _e2113 = phi_2572_;
                                                                            if (_e2104.y < _e2106.y) {
                                                                                phi_2581_ = _e2104.y;
                                                                            } else {
                                                                                phi_2581_ = _e2106.y;
                                                                            }
                                                                            let _e2120 = phi_2581_;
                                                                            if (_e2104.z < _e2106.z) {
                                                                                phi_2590_ = _e2104.z;
                                                                            } else {
                                                                                phi_2590_ = _e2106.z;
                                                                            }
                                                                            let _e2127 = phi_2590_;
                                                                            let _e2129 = triangles.member[(0u + _e1903)].v2_;
                                                                            if (_e2113 < _e2129.x) {
                                                                                phi_2599_ = _e2113;
                                                                            } else {
                                                                                phi_2599_ = _e2129.x;
                                                                            }
                                                                            let _e2134 = phi_2599_;
                                                                            if (_e2120 < _e2129.y) {
                                                                                phi_2606_ = _e2120;
                                                                            } else {
                                                                                phi_2606_ = _e2129.y;
                                                                            }
                                                                            let _e2139 = phi_2606_;
                                                                            if (_e2127 < _e2129.z) {
                                                                                phi_2613_ = _e2127;
                                                                            } else {
                                                                                phi_2613_ = _e2129.z;
                                                                            }
                                                                            let _e2144 = phi_2613_;
                                                                            let _e2146 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2148 = triangles.member[(0u + _e1903)].v1_;
                                                                            if (_e2146.x > _e2148.x) {
                                                                                phi_2626_ = _e2146.x;
                                                                            } else {
                                                                                phi_2626_ = _e2148.x;
                                                                            }
                                                                            let _e2155 = phi_2626_;
                                                                            if (_e2146.y > _e2148.y) {
                                                                                phi_2635_ = _e2146.y;
                                                                            } else {
                                                                                phi_2635_ = _e2148.y;
                                                                            }
                                                                            let _e2162 = phi_2635_;
                                                                            if (_e2146.z > _e2148.z) {
                                                                                phi_2644_ = _e2146.z;
                                                                            } else {
                                                                                phi_2644_ = _e2148.z;
                                                                            }
                                                                            let _e2169 = phi_2644_;
                                                                            let _e2171 = triangles.member[(0u + _e1903)].v2_;
                                                                            if (_e2155 > _e2171.x) {
                                                                                phi_2653_ = _e2155;
                                                                            } else {
                                                                                phi_2653_ = _e2171.x;
                                                                            }
                                                                            let _e2176 = phi_2653_;
                                                                            if (_e2162 > _e2171.y) {
                                                                                phi_2660_ = _e2162;
                                                                            } else {
                                                                                phi_2660_ = _e2171.y;
                                                                            }
                                                                            let _e2181 = phi_2660_;
                                                                            if (_e2169 > _e2171.z) {
                                                                                phi_2667_ = _e2169;
                                                                            } else {
                                                                                phi_2667_ = _e2171.z;
                                                                            }
                                                                            let _e2186 = phi_2667_;
                                                                            let _e2190 = ((_e2134 - _e1010) * _e1222);
                                                                            let _e2191 = ((_e2139 - _e1023) * _e1232);
                                                                            let _e2192 = ((_e2144 - _e1036) * _e1242);
                                                                            let _e2196 = ((_e2176 - _e1010) * _e1222);
                                                                            let _e2197 = ((_e2181 - _e1023) * _e1232);
                                                                            let _e2198 = ((_e2186 - _e1036) * _e1242);
                                                                            if (_e2190 < _e2196) {
                                                                                phi_2684_ = _e2190;
                                                                            } else {
                                                                                phi_2684_ = _e2196;
                                                                            }
                                                                            let _e2201 = phi_2684_;
                                                                            if (_e2191 < _e2197) {
                                                                                phi_2689_ = _e2191;
                                                                            } else {
                                                                                phi_2689_ = _e2197;
                                                                            }
                                                                            let _e2204 = phi_2689_;
                                                                            if (_e2192 < _e2198) {
                                                                                phi_2694_ = _e2192;
                                                                            } else {
                                                                                phi_2694_ = _e2198;
                                                                            }
                                                                            let _e2207 = phi_2694_;
                                                                            if (_e2190 > _e2196) {
                                                                                phi_2702_ = _e2190;
                                                                            } else {
                                                                                phi_2702_ = _e2196;
                                                                            }
                                                                            let _e2213 = phi_2702_;
                                                                            if (_e2191 > _e2197) {
                                                                                phi_2707_ = _e2191;
                                                                            } else {
                                                                                phi_2707_ = _e2197;
                                                                            }
                                                                            let _e2216 = phi_2707_;
                                                                            if (_e2192 > _e2198) {
                                                                                phi_2712_ = _e2192;
                                                                            } else {
                                                                                phi_2712_ = _e2198;
                                                                            }
                                                                            let _e2219 = phi_2712_;
                                                                            let _e2223 = core_intrinsics_maximum_number_nsz_f32_((_e2201 - _e1277), (_e2204 - _e1278));
                                                                            let _e2224 = core_intrinsics_maximum_number_nsz_f32_(_e2223, (_e2207 - _e1279));
                                                                            let _e2225 = core_intrinsics_minimum_number_nsz_f32_((_e2213 + _e1277), (_e2216 + _e1278));
                                                                            let _e2226 = core_intrinsics_minimum_number_nsz_f32_(_e2225, (_e2219 + _e1279));
                                                                            if (_e2224 > _e991) {
                                                                                phi_2724_ = _e2224;
                                                                            } else {
                                                                                phi_2724_ = _e991;
                                                                            }
                                                                            let _e2229 = phi_2724_;
                                                                            if (_e2226 < _e993) {
                                                                                phi_2729_ = _e2226;
                                                                            } else {
                                                                                phi_2729_ = _e993;
                                                                            }
                                                                            let _e2232 = phi_2729_;
                                                                            if (_e2102 < _e2229) {
                                                                                phi_2734_ = _e2229;
                                                                            } else {
                                                                                phi_2734_ = _e2102;
                                                                            }
                                                                            let _e2235 = phi_2734_;
                                                                            if (_e2235 > _e2232) {
                                                                                phi_2739_ = _e2232;
                                                                            } else {
                                                                                phi_2739_ = _e2235;
                                                                            }
                                                                            let _e2238 = phi_2739_;
                                                                            phi_2744_ = lt_bvh_triangle_Intersection(_e2238, (_e2034 / _e2093), (_e2055 / _e2093), (_e2229 <= _e2232));
                                                                        }
                                                                        let _e2244 = phi_2744_;
                                                                        phi_2745_ = _e2244;
                                                                        phi_2746_ = _e2096;
                                                                    } else {
                                                                        phi_2745_ = lt_bvh_triangle_Intersection();
                                                                        phi_2746_ = true;
                                                                    }
                                                                    let _e2246 = phi_2745_;
                                                                    let _e2248 = phi_2746_;
                                                                    if _e2248 {
                                                                        phi_2750_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2750_ = _e2246;
                                                                    }
                                                                    let _e2250 = phi_2750_;
                                                                    if _e2250.is_hit {
                                                                        if (_e2250.t > 0f) {
                                                                            if (_e2250.t < _e136) {
                                                                                let _e2257 = triangles.member[(0u + _e1903)].i0_;
                                                                                let _e2259 = ((_e2257 & 2147483648u) == 0u);
                                                                                if _e2259 {
                                                                                    phi_2968_ = false;
                                                                                    phi_2969_ = false;
                                                                                } else {
                                                                                    if (_e1903 < _e74) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2266 = triangles.member[(0u + _e1903)].i0_;
                                                                                    let _e2267 = (_e2266 & 2147483647u);
                                                                                    let _e2269 = triangles.member[(0u + _e1903)].i1_;
                                                                                    let _e2271 = triangles.member[(0u + _e1903)].i2_;
                                                                                    if (_e2267 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2275 = vertices.member[(0u + _e2267)];
                                                                                    if (_e2269 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2279 = vertices.member[(0u + _e2269)];
                                                                                    if (_e2271 < _e86) {
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
                                                                                            phi_2962_ = true;
                                                                                        } else {
                                                                                            let _e2322 = lt_shaders_surface_vertex_color((&local_1), _e2317);
                                                                                            let _e2324 = (_e2313.base_color.w * _e2322.w);
                                                                                            if (_e2313.alpha_size == 0u) {
                                                                                                phi_2959_ = _e2324;
                                                                                            } else {
                                                                                                local.offset = _e2313.alpha_offset;
                                                                                                local.size = _e2313.alpha_size;
                                                                                                local.flags = _e2313.flags;
                                                                                                let _e2333 = lt_shaders_surface_texture_coordinate((&local_1), _e2317);
                                                                                                let _e2336 = _lt_shaders_texture_TextureView_quad((&local), _e2333.x, _e2333.y);
                                                                                                let _e2340 = (_e2336.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2340 < _e92) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2344 = alpha_texels.member[(0u + _e2340)];
                                                                                                let _e2360 = (_e2336.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2360 < _e92) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2364 = alpha_texels.member[(0u + _e2360)];
                                                                                                let _e2381 = (_e2336.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2381 < _e92) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2385 = alpha_texels.member[(0u + _e2381)];
                                                                                                let _e2402 = (_e2336.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2402 < _e92) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2406 = alpha_texels.member[(0u + _e2402)];
                                                                                                phi_2959_ = (_e2324 * (((((f32(((_e2344 >> bitcast<u32>((((_e2336.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.x) + ((f32(((_e2364 >> bitcast<u32>((((_e2336.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.y)) + ((f32(((_e2385 >> bitcast<u32>((((_e2336.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.z)) + ((f32(((_e2406 >> bitcast<u32>((((_e2336.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2336.weights.w)));
                                                                                            }
                                                                                            let _e2422 = phi_2959_;
                                                                                            phi_2962_ = (_e2422 >= _e2313.cutoff);
                                                                                        }
                                                                                        let _e2426 = phi_2962_;
                                                                                        phi_2963_ = _e2426;
                                                                                    } else {
                                                                                        phi_2963_ = false;
                                                                                    }
                                                                                    let _e2428 = phi_2963_;
                                                                                    if _e2428 {
                                                                                        phi_2967_ = false;
                                                                                    } else {
                                                                                        phi_2967_ = true;
                                                                                    }
                                                                                    let _e2430 = phi_2967_;
                                                                                    phi_2968_ = _e2430;
                                                                                    phi_2969_ = _e2428;
                                                                                }
                                                                                let _e2432 = phi_2968_;
                                                                                let _e2434 = phi_2969_;
                                                                                phi_2970_ = _e2432;
                                                                                phi_2971_ = _e2259;
                                                                                phi_2972_ = _e2434;
                                                                            } else {
                                                                                phi_2970_ = true;
                                                                                phi_2971_ = false;
                                                                                phi_2972_ = false;
                                                                            }
                                                                            let _e2436 = phi_2970_;
                                                                            let _e2438 = phi_2971_;
                                                                            let _e2440 = phi_2972_;
                                                                            phi_2973_ = _e2436;
                                                                            phi_2974_ = _e2438;
                                                                            phi_2975_ = _e2440;
                                                                        } else {
                                                                            phi_2973_ = true;
                                                                            phi_2974_ = false;
                                                                            phi_2975_ = false;
                                                                        }
                                                                        let _e2442 = phi_2973_;
                                                                        let _e2444 = phi_2974_;
                                                                        let _e2446 = phi_2975_;
                                                                        phi_2976_ = _e2442;
                                                                        phi_2977_ = _e2444;
                                                                        phi_2978_ = _e2446;
                                                                    } else {
                                                                        phi_2976_ = true;
                                                                        phi_2977_ = false;
                                                                        phi_2978_ = false;
                                                                    }
                                                                    let _e2448 = phi_2976_;
                                                                    let _e2450 = phi_2977_;
                                                                    let _e2452 = phi_2978_;
                                                                    if _e2448 {
                                                                        phi_2982_ = false;
                                                                        phi_2983_ = false;
                                                                    } else {
                                                                        phi_2982_ = _e2450;
                                                                        phi_2983_ = _e2452;
                                                                    }
                                                                    let _e2454 = phi_2982_;
                                                                    let _e2456 = phi_2983_;
                                                                    phi_2300_ = (_e1894 & (_e1894 - 1u));
                                                                    phi_2984_ = _e2448;
                                                                    phi_2985_ = _e2454;
                                                                    phi_2986_ = _e2456;
                                                                }
                                                                let _e2458 = phi_2300_;
                                                                let _e2460 = phi_2984_;
                                                                let _e2462 = phi_2985_;
                                                                let _e2464 = phi_2986_;
                                                                local_14 = _e2462;
                                                                local_15 = _e2464;
                                                                continue;
                                                                continuing {
                                                                    phi_2299_ = _e2458;
                                                                    break if !(_e2460);
                                                                }
                                                            }
                                                            let _e2467 = local_10;
                                                            if _e2467 {
                                                                let _e2469 = local_2.group_mask;
                                                                if ((_e2469 & 4278190080u) == 0u) {
                                                                    let _e2473 = local_2.len;
                                                                    if (_e2473 == 0u) {
                                                                        phi_3028_ = false;
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
                                                                        phi_3028_ = true;
                                                                    }
                                                                    let _e2496 = phi_3028_;
                                                                    phi_3029_ = _e2496;
                                                                } else {
                                                                    phi_3029_ = true;
                                                                }
                                                                let _e2498 = phi_3029_;
                                                                if _e2498 {
                                                                    let _e2500 = local_2.group_mask;
                                                                    let _e2506 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2500)), 32u, (_e2500 == 0u)));
                                                                    let _e2510 = local_2.group_mask;
                                                                    let _e2524 = local_2.group_mask;
                                                                    local_2.group_mask = (_e2524 & ~((1u << bitcast<u32>((_e2506 & 31u)))));
                                                                    let _e2527 = local_2.group;
                                                                    phi_3060_ = (_e2527 + countOneBits(((_e2510 & ~((4294967295u << bitcast<u32>((((_e2506 - 24u) ^ _e1320) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3060_ = 4294967295u;
                                                                }
                                                                let _e2530 = phi_3060_;
                                                                phi_3061_ = _e2530;
                                                                phi_3062_ = false;
                                                                phi_3063_ = false;
                                                            } else {
                                                                phi_3061_ = u32();
                                                                let _e2903 = local_14;
                                                                phi_3062_ = _e2903;
                                                                let _e2906 = local_15;
                                                                phi_3063_ = _e2906;
                                                            }
                                                            let _e2532 = phi_3061_;
                                                            let _e2534 = phi_3062_;
                                                            let _e2536 = phi_3063_;
                                                            phi_1970_ = _e2532;
                                                            let _e2910 = local_16;
                                                            phi_3064_ = _e2910;
                                                            phi_3065_ = false;
                                                            phi_3066_ = _e2534;
                                                            phi_3067_ = _e2536;
                                                        } else {
                                                            phi_1970_ = u32();
                                                            phi_3064_ = false;
                                                            phi_3065_ = true;
                                                            phi_3066_ = false;
                                                            phi_3067_ = false;
                                                        }
                                                        let _e2538 = phi_1970_;
                                                        let _e2540 = phi_3064_;
                                                        let _e2542 = phi_3065_;
                                                        let _e2544 = phi_3066_;
                                                        let _e2546 = phi_3067_;
                                                        local_11 = _e2542;
                                                        local_17 = _e2544;
                                                        local_18 = _e2546;
                                                        continue;
                                                        continuing {
                                                            phi_1969_ = _e2538;
                                                            break if !(_e2540);
                                                        }
                                                    }
                                                    let _e2549 = local_11;
                                                    if _e2549 {
                                                        phi_3071_ = false;
                                                        phi_3072_ = false;
                                                    } else {
                                                        let _e2917 = local_17;
                                                        phi_3071_ = _e2917;
                                                        let _e2920 = local_18;
                                                        phi_3072_ = _e2920;
                                                    }
                                                    let _e2551 = phi_3071_;
                                                    let _e2553 = phi_3072_;
                                                    if _e2551 {
                                                        phi_3076_ = true;
                                                    } else {
                                                        phi_3076_ = _e2553;
                                                    }
                                                    let _e2555 = phi_3076_;
                                                    if _e2555 {
                                                        phi_3080_ = true;
                                                    } else {
                                                        phi_3080_ = false;
                                                    }
                                                    let _e2557 = phi_3080_;
                                                    phi_3081_ = _e2557;
                                                }
                                                let _e2559 = phi_3081_;
                                                phi_3082_ = _e2559;
                                                phi_3083_ = _e1146;
                                            } else {
                                                phi_3082_ = bool();
                                                phi_3083_ = true;
                                            }
                                            let _e2561 = phi_3082_;
                                            let _e2563 = phi_3083_;
                                            if _e2563 {
                                                phi_3087_ = false;
                                            } else {
                                                phi_3087_ = _e2561;
                                            }
                                            let _e2565 = phi_3087_;
                                            if _e2565 {
                                                phi_3091_ = false;
                                            } else {
                                                phi_3091_ = true;
                                            }
                                            let _e2567 = phi_3091_;
                                            phi_3092_ = _e2567;
                                        } else {
                                            phi_3092_ = true;
                                        }
                                        let _e2569 = phi_3092_;
                                        phi_3093_ = _e2569;
                                    } else {
                                        phi_3093_ = true;
                                    }
                                    let _e2571 = phi_3093_;
                                    phi_3094_ = _e2571;
                                } else {
                                    phi_3094_ = true;
                                }
                                let _e2573 = phi_3094_;
                                if _e2573 {
                                }
                                phi_1361_ = (_e930 & (_e930 - 1u));
                                phi_3098_ = _e2573;
                            }
                            let _e2575 = phi_1361_;
                            let _e2577 = phi_3098_;
                            continue;
                            continuing {
                                phi_1360_ = _e2575;
                                break if !(_e2577);
                            }
                        }
                        let _e2580 = local_12;
                        if _e2580 {
                            let _e2582 = local_3.group_mask;
                            if ((_e2582 & 4278190080u) == 0u) {
                                let _e2586 = local_3.len;
                                if (_e2586 == 0u) {
                                    phi_3140_ = false;
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
                                    phi_3140_ = true;
                                }
                                let _e2609 = phi_3140_;
                                phi_3141_ = _e2609;
                            } else {
                                phi_3141_ = true;
                            }
                            let _e2611 = phi_3141_;
                            if _e2611 {
                                let _e2613 = local_3.group_mask;
                                let _e2619 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2613)), 32u, (_e2613 == 0u)));
                                let _e2623 = local_3.group_mask;
                                let _e2637 = local_3.group_mask;
                                local_3.group_mask = (_e2637 & ~((1u << bitcast<u32>((_e2619 & 31u)))));
                                let _e2640 = local_3.group;
                                phi_3172_ = (_e2640 + countOneBits(((_e2623 & ~((4294967295u << bitcast<u32>((((_e2619 - 24u) ^ _e356) & 31u))))) & 255u)));
                            } else {
                                phi_3172_ = 4294967295u;
                            }
                            let _e2643 = phi_3172_;
                            phi_3173_ = _e2643;
                        } else {
                            phi_3173_ = u32();
                        }
                        let _e2645 = phi_3173_;
                        phi_1031_ = _e2645;
                        let _e2941 = local_19;
                        phi_3174_ = _e2941;
                        phi_3175_ = false;
                    } else {
                        phi_1031_ = u32();
                        phi_3174_ = false;
                        phi_3175_ = true;
                    }
                    let _e2647 = phi_1031_;
                    let _e2649 = phi_3174_;
                    let _e2651 = phi_3175_;
                    local_13 = _e2651;
                    continue;
                    continuing {
                        phi_1030_ = _e2647;
                        break if !(_e2649);
                    }
                }
                let _e2654 = local_13;
                if _e2654 {
                    phi_3179_ = false;
                } else {
                    phi_3179_ = true;
                }
                let _e2656 = phi_3179_;
                if _e2656 {
                    phi_3183_ = true;
                } else {
                    phi_3183_ = false;
                }
                let _e2658 = phi_3183_;
                phi_3184_ = _e2658;
            }
            let _e2660 = phi_3184_;
            phi_3185_ = _e2660;
            phi_3186_ = _e203;
        } else {
            phi_3185_ = bool();
            phi_3186_ = true;
        }
        let _e2662 = phi_3185_;
        let _e2664 = phi_3186_;
        if _e2664 {
            phi_3190_ = false;
        } else {
            phi_3190_ = _e2662;
        }
        let _e2666 = phi_3190_;
        if _e2666 {
            phi_3194_ = 0f;
        } else {
            phi_3194_ = 1f;
        }
        let _e2668 = phi_3194_;
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
