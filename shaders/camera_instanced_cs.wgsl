struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_8 {
    member: array<lt_bvh_Triangle>,
}

struct type_12 {
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

struct type_17 {
    member: array<abi_Material>,
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

struct type_32 {
    member: array<lt_bvh_Instance>,
}

struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_41 {
    member: array<abi_Sample>,
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

struct type_50 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_55 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
}

struct lt_bvh_Hit {
    t: f32,
    u: f32,
    v: f32,
    triangle: u32,
    instance: u32,
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

@group(0) @binding(3) 
var<storage> vertices: type_12;
@group(0) @binding(4) 
var<storage> materials: type_17;
var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_50;
@group(0) @binding(1) 
var<storage> nodes: type_55;
@group(0) @binding(2) 
var<storage> triangles: type_8;
@group(0) @binding(5) 
var<storage, read_write> samples: type_41;
@group(0) @binding(6) 
var<storage> instances: type_32;

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

fn lt_shaders_entry_pixel_index(param_3: vec3<u32>, param_4: u32, param_5: u32) -> lt_bvh_traverse_Tree {
    var phi_290_: lt_bvh_traverse_Tree;
    var phi_291_: bool;
    var phi_292_: lt_bvh_traverse_Tree;
    var phi_293_: bool;
    var phi_298_: lt_bvh_traverse_Tree;

    if (param_3.x < param_4) {
        if (param_3.y < param_5) {
            phi_290_ = lt_bvh_traverse_Tree(1u, ((param_3.y * param_4) + param_3.x));
            phi_291_ = false;
        } else {
            phi_290_ = lt_bvh_traverse_Tree();
            phi_291_ = true;
        }
        let _e74 = phi_290_;
        let _e76 = phi_291_;
        phi_292_ = _e74;
        phi_293_ = _e76;
    } else {
        phi_292_ = lt_bvh_traverse_Tree();
        phi_293_ = true;
    }
    let _e78 = phi_292_;
    let _e80 = phi_293_;
    if _e80 {
        phi_298_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_298_ = _e78;
    }
    let _e85 = phi_298_;
    return lt_bvh_traverse_Tree(_e85.root, _e85.first_primitive);
}

fn lt_shaders_shade_unit(param_6: f32) -> f32 {
    var phi_312_: f32;
    var phi_313_: f32;

    if (param_6 > 0f) {
        if (param_6 < 1f) {
            phi_312_ = param_6;
        } else {
            phi_312_ = 1f;
        }
        let _e65 = phi_312_;
        phi_313_ = _e65;
    } else {
        phi_313_ = 0f;
    }
    let _e67 = phi_313_;
    return _e67;
}

fn lt_shaders_shade_sqrt(param_7: f32) -> f32 {
    return sqrt(param_7);
}

fn lt_shaders_shade_pack_bytes(param_8: vec3<f32>) -> u32 {
    let _e64 = ((param_8.x * 255f) + 0.5f);
    let _e74 = ((param_8.y * 255f) + 0.5f);
    let _e87 = ((param_8.z * 255f) + 0.5f);
    return ((select(select(u32(_e64), 0u, (_e64 < bitcast<f32>(0u))), 4294967295u, (_e64 > bitcast<f32>(1333788671u))) | (select(select(u32(_e74), 0u, (_e74 < bitcast<f32>(0u))), 4294967295u, (_e74 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e87), 0u, (_e87 < bitcast<f32>(0u))), 4294967295u, (_e87 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i)));
}

fn _lt_bvh_ray_Ray_new(param_9: vec3<f32>, param_10: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_9, 0f, param_10, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_11: f32, param_12: f32) -> f32 {
    var phi_368_: bool;
    var phi_372_: f32;

    if (param_11 != param_11) {
        phi_368_ = true;
    } else {
        let _e64 = (param_12 >= param_11);
        if _e64 {
        }
        phi_368_ = _e64;
    }
    let _e66 = phi_368_;
    if _e66 {
        phi_372_ = param_12;
    } else {
        phi_372_ = param_11;
    }
    let _e68 = phi_372_;
    return _e68;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_13: f32, param_14: f32) -> f32 {
    var phi_384_: bool;
    var phi_388_: f32;

    if (param_13 != param_13) {
        phi_384_ = true;
    } else {
        let _e64 = (param_14 <= param_13);
        if _e64 {
        }
        phi_384_ = _e64;
    }
    let _e66 = phi_384_;
    if _e66 {
        phi_388_ = param_14;
    } else {
        phi_388_ = param_13;
    }
    let _e68 = phi_388_;
    return _e68;
}

fn lt_shaders_surface_barycentric_weights(param_15: f32, param_16: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_15) - param_16), param_15, param_16);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_17: f32, param_18: f32) -> f32 {
    var phi_402_: f32;

    if (param_17 > param_18) {
        phi_402_ = param_17;
    } else {
        phi_402_ = param_18;
    }
    let _e65 = phi_402_;
    return _e65;
}

fn lt_shaders_camera_facing(param_19: vec3<f32>, param_20: vec3<f32>) -> vec3<f32> {
    var phi_422_: vec3<f32>;

    if ((((param_19.x * param_20.x) + (param_19.y * param_20.y)) + (param_19.z * param_20.z)) < 0f) {
        phi_422_ = -(param_19);
    } else {
        phi_422_ = param_19;
    }
    let _e77 = phi_422_;
    return _e77;
}

fn lt_shaders_surface_plain_color(param_21: ptr<function, abi_Material>, param_22: ptr<function, array<abi_Vertex, 3>>, param_23: vec3<f32>) -> vec3<f32> {
    let _e65 = (*param_21).base_color;
    let _e69 = lt_shaders_surface_vertex_color(param_22, param_23);
    return vec3<f32>((_e65.x * _e69.x), (_e65.y * _e69.y), (_e65.z * _e69.z));
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_24: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn lt_shaders_surface_octahedral_decode(param_25: u32) -> vec3<f32> {
    var phi_464_: f32;
    var phi_471_: f32;
    var phi_478_: f32;

    let _e69 = (f32((bitcast<i32>((param_25 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e75 = (f32((bitcast<i32>(param_25) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e79 = ((1f - abs(_e69)) - abs(_e75));
    if (_e79 < 0f) {
        phi_464_ = -(_e79);
    } else {
        phi_464_ = 0f;
    }
    let _e83 = phi_464_;
    if (_e69 < 0f) {
        phi_471_ = (_e69 + _e83);
    } else {
        phi_471_ = (_e69 - _e83);
    }
    let _e88 = phi_471_;
    if (_e75 < 0f) {
        phi_478_ = (_e75 + _e83);
    } else {
        phi_478_ = (_e75 - _e83);
    }
    let _e93 = phi_478_;
    let _e100 = (1f / sqrt((((_e88 * _e88) + (_e93 * _e93)) + (_e79 * _e79))));
    return vec3<f32>((_e88 * _e100), (_e93 * _e100), (_e79 * _e100));
}

fn lt_shaders_shade_pack_albedo(param_26: vec3<f32>) -> u32 {
    let _e63 = lt_shaders_shade_unit(param_26.x);
    let _e64 = lt_shaders_shade_sqrt(_e63);
    let _e66 = lt_shaders_shade_unit(param_26.y);
    let _e67 = lt_shaders_shade_sqrt(_e66);
    let _e69 = lt_shaders_shade_unit(param_26.z);
    let _e70 = lt_shaders_shade_sqrt(_e69);
    let _e72 = lt_shaders_shade_pack_bytes(vec3<f32>(_e64, _e67, _e70));
    return _e72;
}

fn function_() {
    var local: array<abi_Vertex, 3>;
    var local_1: abi_Material;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_677_: bool;
    var phi_681_: bool;
    var phi_756_: f32;
    var phi_763_: f32;
    var phi_771_: f32;
    var phi_778_: f32;
    var phi_786_: f32;
    var phi_793_: f32;
    var phi_818_: f32;
    var phi_823_: f32;
    var phi_828_: f32;
    var phi_850_: u32;
    var phi_855_: u32;
    var phi_860_: u32;
    var phi_974_: bool;
    var phi_975_: bool;
    var phi_1006_: u32;
    var phi_1008_: u32;
    var phi_1011_: lt_bvh_Hit;
    var phi_1096_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1123_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1150_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1156_: u32;
    var phi_1159_: u32;
    var phi_1173_: u32;
    var phi_1183_: u32;
    var phi_1193_: u32;
    var phi_1211_: u32;
    var phi_1221_: u32;
    var phi_1231_: u32;
    var phi_1267_: u32;
    var phi_1280_: u32;
    var phi_1285_: u32;
    var phi_1286_: u32;
    var phi_1287_: u32;
    var phi_1157_: u32;
    var phi_1160_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1345_: u32;
    var phi_1348_: lt_bvh_Hit;
    var phi_1403_: f32;
    var phi_1408_: f32;
    var phi_1413_: f32;
    var phi_1421_: f32;
    var phi_1426_: f32;
    var phi_1431_: f32;
    var phi_1586_: bool;
    var phi_1587_: bool;
    var phi_1588_: bool;
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
    var phi_1609_: bool;
    var phi_1613_: bool;
    var phi_1617_: bool;
    var phi_1687_: f32;
    var phi_1694_: f32;
    var phi_1701_: f32;
    var phi_1708_: f32;
    var phi_1715_: f32;
    var phi_1722_: f32;
    var phi_1739_: f32;
    var phi_1744_: f32;
    var phi_1749_: f32;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1786_: u32;
    var phi_1787_: u32;
    var phi_1798_: vec3<f32>;
    var phi_1799_: vec3<f32>;
    var phi_1812_: u32;
    var phi_1817_: u32;
    var phi_1822_: u32;
    var phi_1936_: bool;
    var phi_1937_: bool;
    var phi_1968_: u32;
    var phi_1970_: lt_bvh_Hit;
    var phi_1973_: u32;
    var phi_2054_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2081_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2108_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2114_: u32;
    var phi_2117_: u32;
    var phi_2131_: u32;
    var phi_2141_: u32;
    var phi_2151_: u32;
    var phi_2169_: u32;
    var phi_2179_: u32;
    var phi_2189_: u32;
    var phi_2225_: u32;
    var phi_2238_: u32;
    var phi_2243_: u32;
    var phi_2244_: u32;
    var phi_2245_: u32;
    var phi_2115_: u32;
    var phi_2118_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2303_: lt_bvh_Hit;
    var phi_2306_: u32;
    var phi_2350_: vec3<f32>;
    var phi_2351_: vec3<f32>;
    var phi_2382_: vec3<f32>;
    var phi_2383_: vec3<f32>;
    var phi_2414_: vec3<f32>;
    var phi_2415_: vec3<f32>;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2440_: f32;
    var phi_2441_: f32;
    var phi_2442_: f32;
    var phi_2443_: f32;
    var phi_2451_: f32;
    var phi_2461_: bool;
    var phi_2462_: bool;
    var phi_2466_: f32;
    var phi_2467_: f32;
    var phi_2468_: f32;
    var phi_2469_: f32;
    var phi_2477_: f32;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2492_: f32;
    var phi_2493_: f32;
    var phi_2494_: f32;
    var phi_2495_: f32;
    var phi_2503_: f32;
    var phi_2518_: f32;
    var phi_2519_: bool;
    var phi_2520_: f32;
    var phi_2521_: bool;
    var phi_2522_: f32;
    var phi_2523_: bool;
    var phi_2541_: f32;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: f32;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2550_: bool;
    var phi_2551_: f32;
    var phi_2552_: bool;
    var phi_2578_: f32;
    var phi_2587_: f32;
    var phi_2596_: f32;
    var phi_2605_: f32;
    var phi_2612_: f32;
    var phi_2619_: f32;
    var phi_2632_: f32;
    var phi_2641_: f32;
    var phi_2650_: f32;
    var phi_2659_: f32;
    var phi_2666_: f32;
    var phi_2673_: f32;
    var phi_2690_: f32;
    var phi_2695_: f32;
    var phi_2700_: f32;
    var phi_2708_: f32;
    var phi_2713_: f32;
    var phi_2718_: f32;
    var phi_2730_: f32;
    var phi_2735_: f32;
    var phi_2740_: f32;
    var phi_2745_: f32;
    var phi_2750_: lt_bvh_triangle_Intersection;
    var phi_2751_: lt_bvh_triangle_Intersection;
    var phi_2752_: bool;
    var phi_2756_: lt_bvh_triangle_Intersection;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var phi_2796_: bool;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2799_: bool;
    var phi_2803_: bool;
    var phi_2804_: bool;
    var phi_2818_: bool;
    var phi_2826_: lt_bvh_Hit;
    var phi_2827_: lt_bvh_Hit;
    var phi_2828_: lt_bvh_Hit;
    var phi_2829_: lt_bvh_Hit;
    var phi_2304_: lt_bvh_Hit;
    var phi_2307_: u32;
    var phi_2830_: bool;
    var phi_2869_: bool;
    var phi_2870_: bool;
    var phi_2901_: u32;
    var phi_1971_: lt_bvh_Hit;
    var phi_1974_: u32;
    var phi_2902_: lt_bvh_Hit;
    var phi_2903_: lt_bvh_Hit;
    var phi_2904_: bool;
    var phi_2908_: lt_bvh_Hit;
    var phi_2909_: lt_bvh_Hit;
    var phi_2910_: lt_bvh_Hit;
    var phi_2911_: lt_bvh_Hit;
    var phi_1346_: u32;
    var phi_1349_: lt_bvh_Hit;
    var phi_2912_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2983_: u32;
    var phi_1009_: u32;
    var phi_1012_: lt_bvh_Hit;
    var phi_2984_: lt_bvh_Hit;
    var phi_2985_: lt_bvh_Hit;
    var phi_2986_: bool;
    var phi_2990_: lt_bvh_Hit;
    var phi_3179_: f32;
    var phi_3184_: f32;
    var phi_3189_: f32;
    var phi_3197_: f32;
    var phi_3202_: f32;
    var phi_3207_: f32;
    var phi_3343_: u32;
    var phi_3442_: vec3<f32>;
    var phi_3443_: vec3<f32>;
    var phi_3447_: abi_Sample;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e65 = id_1;
    let _e69 = arrayLength((&nodes.member));
    let _e72 = arrayLength((&triangles.member));
    let _e75 = arrayLength((&vertices.member));
    let _e84 = arrayLength((&instances.member));
    let _e87 = p.member.size[0u];
    let _e89 = p.member.size[1u];
    let _e90 = lt_shaders_entry_pixel_index(_e65, _e87, _e89);
    if (bitcast<i32>(_e90.root) != 0i) {
        let _e96 = p.member.root;
        let _e100 = p.member.eye;
        let _e105 = p.member.size[0u];
        let _e109 = ((((f32(_e65.x) + 0.5f) / f32(_e105)) * 2f) - 1f);
        let _e114 = p.member.size[1u];
        let _e118 = (1f - (((f32(_e65.y) + 0.5f) / f32(_e114)) * 2f));
        let _e120 = p.member.forward;
        let _e122 = p.member.right;
        let _e136 = p.member.up;
        let _e147 = _lt_bvh_ray_Ray_new(_e100, vec3<f32>(((_e120.x + (_e122.x * _e109)) + (_e136.x * _e118)), ((_e120.y + (_e122.y * _e109)) + (_e136.y * _e118)), ((_e120.z + (_e122.z * _e109)) + (_e136.z * _e118))));
        let _e149 = lt_bvh_Hit(_e147.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e159 = abs(_e147.direction.x);
        let _e161 = abs(_e147.direction.y);
        let _e163 = abs(_e147.direction.z);
        if (abs(_e147.origin.x) < 1000000000000000f) {
            if (abs(_e147.origin.y) < 1000000000000000f) {
                if (abs(_e147.origin.z) < 1000000000000000f) {
                    if (_e159 < 1000000000000000f) {
                        if (_e161 < 1000000000000000f) {
                            if (_e163 < 1000000000000000f) {
                                if (_e159 > 0f) {
                                    phi_651_ = bool();
                                    phi_652_ = true;
                                } else {
                                    let _e171 = (_e161 > 0f);
                                    if _e171 {
                                        phi_650_ = bool();
                                    } else {
                                        phi_650_ = (_e163 > 0f);
                                    }
                                    let _e174 = phi_650_;
                                    phi_651_ = _e174;
                                    phi_652_ = _e171;
                                }
                                let _e176 = phi_651_;
                                let _e178 = phi_652_;
                                if _e178 {
                                    phi_656_ = true;
                                } else {
                                    phi_656_ = _e176;
                                }
                                let _e180 = phi_656_;
                                phi_657_ = _e180;
                                phi_658_ = false;
                            } else {
                                phi_657_ = bool();
                                phi_658_ = true;
                            }
                            let _e182 = phi_657_;
                            let _e184 = phi_658_;
                            phi_659_ = _e182;
                            phi_660_ = false;
                            phi_661_ = _e184;
                        } else {
                            phi_659_ = bool();
                            phi_660_ = true;
                            phi_661_ = false;
                        }
                        let _e186 = phi_659_;
                        let _e188 = phi_660_;
                        let _e190 = phi_661_;
                        phi_662_ = _e186;
                        phi_663_ = _e188;
                        phi_664_ = _e190;
                    } else {
                        phi_662_ = bool();
                        phi_663_ = true;
                        phi_664_ = false;
                    }
                    let _e192 = phi_662_;
                    let _e194 = phi_663_;
                    let _e196 = phi_664_;
                    phi_665_ = _e192;
                    phi_666_ = _e194;
                    phi_667_ = _e196;
                } else {
                    phi_665_ = bool();
                    phi_666_ = true;
                    phi_667_ = false;
                }
                let _e198 = phi_665_;
                let _e200 = phi_666_;
                let _e202 = phi_667_;
                phi_668_ = _e198;
                phi_669_ = _e200;
                phi_670_ = _e202;
            } else {
                phi_668_ = bool();
                phi_669_ = true;
                phi_670_ = false;
            }
            let _e204 = phi_668_;
            let _e206 = phi_669_;
            let _e208 = phi_670_;
            phi_671_ = _e204;
            phi_672_ = _e206;
            phi_673_ = _e208;
        } else {
            phi_671_ = bool();
            phi_672_ = true;
            phi_673_ = false;
        }
        let _e210 = phi_671_;
        let _e212 = phi_672_;
        let _e214 = phi_673_;
        if _e212 {
            phi_677_ = true;
        } else {
            phi_677_ = _e214;
        }
        let _e216 = phi_677_;
        if _e216 {
            phi_681_ = false;
        } else {
            phi_681_ = _e210;
        }
        let _e218 = phi_681_;
        if _e218 {
            let _e219 = (_e96 >= _e69);
            if _e219 {
                phi_2984_ = lt_bvh_Hit();
            } else {
                if (_e96 < _e69) {
                } else {
                    return;
                }
                let _e225 = nodes.member[(0u + _e96)].frame[0u];
                let _e229 = nodes.member[(0u + _e96)].frame[1u];
                let _e233 = nodes.member[(0u + _e96)].frame[2u];
                let _e237 = nodes.member[(0u + _e96)].frame[0u];
                let _e241 = nodes.member[(0u + _e96)].frame[1u];
                let _e245 = nodes.member[(0u + _e96)].frame[2u];
                let _e249 = nodes.member[(0u + _e96)].frame[3u];
                let _e287 = core_intrinsics_maximum_number_nsz_f32_(abs(_e147.direction.x), abs(_e147.direction.y));
                let _e288 = core_intrinsics_maximum_number_nsz_f32_(_e287, abs(_e147.direction.z));
                let _e289 = (_e288 * 0.0000000000009094947f);
                if (abs(_e147.direction.x) < _e289) {
                    phi_756_ = _e289;
                } else {
                    phi_756_ = abs(_e147.direction.x);
                }
                let _e296 = phi_756_;
                if (_e147.direction.x < 0f) {
                    phi_763_ = (-1f / _e296);
                } else {
                    phi_763_ = (1f / _e296);
                }
                let _e301 = phi_763_;
                if (abs(_e147.direction.y) < _e289) {
                    phi_771_ = _e289;
                } else {
                    phi_771_ = abs(_e147.direction.y);
                }
                let _e308 = phi_771_;
                if (_e147.direction.y < 0f) {
                    phi_778_ = (-1f / _e308);
                } else {
                    phi_778_ = (1f / _e308);
                }
                let _e313 = phi_778_;
                if (abs(_e147.direction.z) < _e289) {
                    phi_786_ = _e289;
                } else {
                    phi_786_ = abs(_e147.direction.z);
                }
                let _e320 = phi_786_;
                if (_e147.direction.z < 0f) {
                    phi_793_ = (-1f / _e320);
                } else {
                    phi_793_ = (1f / _e320);
                }
                let _e325 = phi_793_;
                let _e333 = abs((bitcast<f32>(_e225) - _e147.origin.x));
                let _e334 = abs((bitcast<f32>(_e229) - _e147.origin.y));
                let _e335 = abs((bitcast<f32>(_e233) - _e147.origin.z));
                let _e343 = abs(((bitcast<f32>(_e237) + (bitcast<f32>((((_e249 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147.origin.x));
                let _e344 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e249 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147.origin.y));
                let _e345 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e249 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147.origin.z));
                if (_e333 > _e343) {
                    phi_818_ = _e333;
                } else {
                    phi_818_ = _e343;
                }
                let _e348 = phi_818_;
                if (_e334 > _e344) {
                    phi_823_ = _e334;
                } else {
                    phi_823_ = _e344;
                }
                let _e351 = phi_823_;
                if (_e335 > _e345) {
                    phi_828_ = _e335;
                } else {
                    phi_828_ = _e345;
                }
                let _e354 = phi_828_;
                let _e355 = core_intrinsics_maximum_number_nsz_f32_(_e348, _e351);
                let _e356 = core_intrinsics_maximum_number_nsz_f32_(_e355, _e354);
                let _e361 = (_e356 * 0.0000019073486f);
                let _e362 = (abs(_e301) * _e361);
                let _e363 = (abs(_e313) * _e361);
                let _e364 = (abs(_e325) * _e361);
                let _e368 = (_e356 * 0.0000009536743f);
                let _e369 = (abs(_e301) * _e368);
                let _e370 = (abs(_e313) * _e368);
                let _e371 = (abs(_e325) * _e368);
                if (_e301 < 0f) {
                    phi_850_ = 0u;
                } else {
                    phi_850_ = 1u;
                }
                let _e374 = phi_850_;
                if (_e313 < 0f) {
                    phi_855_ = 0u;
                } else {
                    phi_855_ = 2u;
                }
                let _e377 = phi_855_;
                if (_e325 < 0f) {
                    phi_860_ = 0u;
                } else {
                    phi_860_ = 4u;
                }
                let _e380 = phi_860_;
                let _e382 = ((_e374 | _e377) | _e380);
                let _e383 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e96, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e383.first[0], _e383.first[1], _e383.first[2], _e383.first[3], _e383.first[4], _e383.first[5], _e383.first[6], _e383.first[7], _e383.first[8], _e383.first[9], _e383.first[10], _e383.first[11], _e383.first[12], _e383.first[13], _e383.first[14], _e383.first[15], _e383.first[16], _e383.first[17], _e383.first[18], _e383.first[19], _e383.first[20], _e383.first[21], _e383.first[22], _e383.first[23], _e383.first[24], _e383.first[25], _e383.first[26], _e383.first[27], _e383.first[28], _e383.first[29], _e383.first[30], _e383.first[31]), array<u32, 32>(_e383.mask[0], _e383.mask[1], _e383.mask[2], _e383.mask[3], _e383.mask[4], _e383.mask[5], _e383.mask[6], _e383.mask[7], _e383.mask[8], _e383.mask[9], _e383.mask[10], _e383.mask[11], _e383.mask[12], _e383.mask[13], _e383.mask[14], _e383.mask[15], _e383.mask[16], _e383.mask[17], _e383.mask[18], _e383.mask[19], _e383.mask[20], _e383.mask[21], _e383.mask[22], _e383.mask[23], _e383.mask[24], _e383.mask[25], _e383.mask[26], _e383.mask[27], _e383.mask[28], _e383.mask[29], _e383.mask[30], _e383.mask[31]), _e383.len, _e383.group, _e383.group_mask);
                let _e457 = local_3.group_mask;
                if ((_e457 & 4278190080u) == 0u) {
                    let _e461 = local_3.len;
                    if (_e461 == 0u) {
                        phi_974_ = false;
                    } else {
                        let _e465 = local_3.len;
                        local_3.len = (_e465 - 1u);
                        let _e468 = local_3.len;
                        if (_e468 < 32u) {
                        } else {
                            return;
                        }
                        let _e473 = local_3.first[(0u + _e468)];
                        local_3.group = _e473;
                        let _e476 = local_3.len;
                        if (_e476 < 32u) {
                        } else {
                            return;
                        }
                        let _e481 = local_3.mask[(0u + _e476)];
                        local_3.group_mask = _e481;
                        phi_974_ = true;
                    }
                    let _e484 = phi_974_;
                    phi_975_ = _e484;
                } else {
                    phi_975_ = true;
                }
                let _e486 = phi_975_;
                if _e486 {
                    let _e488 = local_3.group_mask;
                    let _e494 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e488)), 32u, (_e488 == 0u)));
                    let _e498 = local_3.group_mask;
                    let _e512 = local_3.group_mask;
                    local_3.group_mask = (_e512 & ~((1u << bitcast<u32>((_e494 & 31u)))));
                    let _e515 = local_3.group;
                    phi_1006_ = (_e515 + countOneBits(((_e498 & ~((4294967295u << bitcast<u32>((((_e494 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1006_ = 4294967295u;
                }
                let _e518 = phi_1006_;
                phi_1008_ = _e518;
                phi_1011_ = _e149;
                loop {
                    let _e520 = phi_1008_;
                    let _e522 = phi_1011_;
                    local_13 = _e522;
                    let _e523 = (_e520 != 4294967295u);
                    if _e523 {
                        if (_e520 < _e69) {
                        } else {
                            return;
                        }
                        let _e531 = nodes.member[(0u + _e520)].frame[3u];
                        let _e556 = (bitcast<f32>((((_e531 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e301);
                        let _e557 = (bitcast<f32>((((_e531 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e558 = (bitcast<f32>((((_e531 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e561 = nodes.member[(0u + _e520)].frame[0u];
                        let _e565 = nodes.member[(0u + _e520)].frame[1u];
                        let _e569 = nodes.member[(0u + _e520)].frame[2u];
                        let _e577 = ((bitcast<f32>(_e561) - _e147.origin.x) * _e301);
                        let _e578 = ((bitcast<f32>(_e565) - _e147.origin.y) * _e313);
                        let _e579 = ((bitcast<f32>(_e569) - _e147.origin.z) * _e325);
                        let _e587 = nodes.member[(0u + _e520)].x;
                        if (_e301 < 0f) {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e587.w), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e587.x, _e604.unnamed_1.first_primitive));
                            phi_1096_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e587.y));
                        } else {
                            let _e626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e626.unnamed.root, _e587.y), _e626.unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e632.unnamed, lt_bvh_traverse_Tree(_e587.z, _e632.unnamed_1.first_primitive));
                            phi_1096_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e638.unnamed_1.root, _e587.w));
                        }
                        let _e646 = phi_1096_;
                        let _e656 = nodes.member[(0u + _e520)].y;
                        if (_e313 < 0f) {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e656.w), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e656.x, _e673.unnamed_1.first_primitive));
                            phi_1123_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e656.y));
                        } else {
                            let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e695.unnamed.root, _e656.y), _e695.unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e701.unnamed, lt_bvh_traverse_Tree(_e656.z, _e701.unnamed_1.first_primitive));
                            phi_1123_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e707.unnamed_1.root, _e656.w));
                        }
                        let _e715 = phi_1123_;
                        let _e725 = nodes.member[(0u + _e520)].z;
                        if (_e325 < 0f) {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e725.w), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e725.x, _e742.unnamed_1.first_primitive));
                            phi_1150_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e725.y));
                        } else {
                            let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e764.unnamed.root, _e725.y), _e764.unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e770.unnamed, lt_bvh_traverse_Tree(_e725.z, _e770.unnamed_1.first_primitive));
                            phi_1150_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_bvh_traverse_Tree(_e776.unnamed_1.root, _e725.w));
                        }
                        let _e784 = phi_1150_;
                        phi_1156_ = 0u;
                        phi_1159_ = 0u;
                        loop {
                            let _e794 = phi_1156_;
                            let _e796 = phi_1159_;
                            local_4 = _e796;
                            local_5 = _e796;
                            local_6 = _e796;
                            let _e797 = (_e794 < 8u);
                            if _e797 {
                                let _e799 = (_e794 >> bitcast<u32>(2i));
                                let _e800 = (_e794 & 3u);
                                if (_e799 == 0u) {
                                    phi_1173_ = _e646.unnamed.root;
                                } else {
                                    phi_1173_ = _e646.unnamed.first_primitive;
                                }
                                let _e803 = phi_1173_;
                                if (_e799 == 0u) {
                                    phi_1183_ = _e715.unnamed.root;
                                } else {
                                    phi_1183_ = _e715.unnamed.first_primitive;
                                }
                                let _e812 = phi_1183_;
                                if (_e799 == 0u) {
                                    phi_1193_ = _e784.unnamed.root;
                                } else {
                                    phi_1193_ = _e784.unnamed.first_primitive;
                                }
                                let _e821 = phi_1193_;
                                let _e834 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e803 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e556) + (_e577 - _e362)), ((f32(((_e812 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e557) + (_e578 - _e363)));
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(_e834, ((f32(((_e821 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e558) + (_e579 - _e364)));
                                if (_e799 == 0u) {
                                    phi_1211_ = _e646.unnamed_1.root;
                                } else {
                                    phi_1211_ = _e646.unnamed_1.first_primitive;
                                }
                                let _e838 = phi_1211_;
                                if (_e799 == 0u) {
                                    phi_1221_ = _e715.unnamed_1.root;
                                } else {
                                    phi_1221_ = _e715.unnamed_1.first_primitive;
                                }
                                let _e847 = phi_1221_;
                                if (_e799 == 0u) {
                                    phi_1231_ = _e784.unnamed_1.root;
                                } else {
                                    phi_1231_ = _e784.unnamed_1.first_primitive;
                                }
                                let _e856 = phi_1231_;
                                let _e869 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e838 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e556) + (_e577 + _e362)), ((f32(((_e847 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e557) + (_e578 + _e363)));
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(_e869, ((f32(((_e856 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e558) + (_e579 + _e364)));
                                if (_e835 <= _e870) {
                                    if (_e835 <= _e522.t) {
                                        if (_e870 >= _e147.tmin) {
                                            if (_e799 == 0u) {
                                                let _e877 = nodes.member[(0u + _e520)].links[2u];
                                                phi_1267_ = _e877;
                                            } else {
                                                let _e880 = nodes.member[(0u + _e520)].links[3u];
                                                phi_1267_ = _e880;
                                            }
                                            let _e882 = phi_1267_;
                                            let _e887 = ((_e882 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u);
                                            let _e888 = (_e887 & 31u);
                                            if (_e888 >= 24u) {
                                                phi_1280_ = (24u + ((_e888 - 24u) ^ _e382));
                                            } else {
                                                phi_1280_ = _e888;
                                            }
                                            let _e894 = phi_1280_;
                                            phi_1285_ = (_e796 | ((_e887 >> bitcast<u32>(5i)) << bitcast<u32>((_e894 & 31u))));
                                        } else {
                                            phi_1285_ = _e796;
                                        }
                                        let _e902 = phi_1285_;
                                        phi_1286_ = _e902;
                                    } else {
                                        phi_1286_ = _e796;
                                    }
                                    let _e904 = phi_1286_;
                                    phi_1287_ = _e904;
                                } else {
                                    phi_1287_ = _e796;
                                }
                                let _e906 = phi_1287_;
                                phi_1157_ = (_e794 + 1u);
                                phi_1160_ = _e906;
                            } else {
                                phi_1157_ = u32();
                                phi_1160_ = u32();
                            }
                            let _e909 = phi_1157_;
                            let _e911 = phi_1160_;
                            continue;
                            continuing {
                                phi_1156_ = _e909;
                                phi_1159_ = _e911;
                                break if !(_e797);
                            }
                        }
                        let _e915 = nodes.member[(0u + _e520)].links[0u];
                        let _e919 = nodes.member[(0u + _e520)].frame[3u];
                        let _e923 = local_4;
                        if ((_e923 & 4278190080u) == 0u) {
                        } else {
                            let _e927 = local_3.group_mask;
                            if ((_e927 & 4278190080u) == 0u) {
                            } else {
                                let _e931 = local_3.len;
                                if (_e931 < 32u) {
                                    let _e934 = local_3.group;
                                    let _e936 = local_3.len;
                                    if (_e936 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e936)] = _e934;
                                    let _e942 = local_3.group_mask;
                                    let _e944 = local_3.len;
                                    if (_e944 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e944)] = _e942;
                                    let _e951 = local_3.len;
                                    local_3.len = (_e951 + 1u);
                                }
                            }
                            local_3.group = (_e96 + _e915);
                            let _e955 = local_5;
                            local_3.group_mask = ((_e955 & 4278190080u) | (_e919 >> bitcast<u32>(24i)));
                        }
                        let _e960 = local_6;
                        phi_1345_ = (_e960 & 16777215u);
                        phi_1348_ = _e522;
                        loop {
                            let _e963 = phi_1345_;
                            let _e965 = phi_1348_;
                            local_12 = _e965;
                            if (_e963 == 0u) {
                                phi_1346_ = u32();
                                phi_1349_ = lt_bvh_Hit();
                                phi_2912_ = false;
                            } else {
                                let _e969 = nodes.member[(0u + _e520)].links[1u];
                                let _e973 = (_e969 + select(firstTrailingBit(_e963), 32u, (_e963 == 0u)));
                                if (_e973 < _e84) {
                                } else {
                                    return;
                                }
                                let _e980 = instances.member[(0u + _e973)].low_world;
                                let _e982 = instances.member[(0u + _e973)].high_world;
                                let _e992 = ((_e980.x - _e147.origin.x) * _e301);
                                let _e993 = ((_e980.y - _e147.origin.y) * _e313);
                                let _e994 = ((_e980.z - _e147.origin.z) * _e325);
                                let _e1004 = ((_e982.x - _e147.origin.x) * _e301);
                                let _e1005 = ((_e982.y - _e147.origin.y) * _e313);
                                let _e1006 = ((_e982.z - _e147.origin.z) * _e325);
                                if (_e992 < _e1004) {
                                    phi_1403_ = _e992;
                                } else {
                                    phi_1403_ = _e1004;
                                }
                                let _e1009 = phi_1403_;
                                if (_e993 < _e1005) {
                                    phi_1408_ = _e993;
                                } else {
                                    phi_1408_ = _e1005;
                                }
                                let _e1012 = phi_1408_;
                                if (_e994 < _e1006) {
                                    phi_1413_ = _e994;
                                } else {
                                    phi_1413_ = _e1006;
                                }
                                let _e1015 = phi_1413_;
                                if (_e992 > _e1004) {
                                    phi_1421_ = _e992;
                                } else {
                                    phi_1421_ = _e1004;
                                }
                                let _e1021 = phi_1421_;
                                if (_e993 > _e1005) {
                                    phi_1426_ = _e993;
                                } else {
                                    phi_1426_ = _e1005;
                                }
                                let _e1024 = phi_1426_;
                                if (_e994 > _e1006) {
                                    phi_1431_ = _e994;
                                } else {
                                    phi_1431_ = _e1006;
                                }
                                let _e1027 = phi_1431_;
                                let _e1031 = core_intrinsics_maximum_number_nsz_f32_((_e1009 - _e369), (_e1012 - _e370));
                                let _e1032 = core_intrinsics_maximum_number_nsz_f32_(_e1031, (_e1015 - _e371));
                                let _e1033 = core_intrinsics_minimum_number_nsz_f32_((_e1021 + _e369), (_e1024 + _e370));
                                let _e1034 = core_intrinsics_minimum_number_nsz_f32_(_e1033, (_e1027 + _e371));
                                if (_e1032 <= _e1034) {
                                    if (_e1032 <= _e965.t) {
                                        if (_e1034 >= _e147.tmin) {
                                            let _e1046 = instances.member[(0u + _e973)].world_to_object[0u];
                                            let _e1057 = ((((_e1046.x * _e147.origin.x) + (_e1046.y * _e147.origin.y)) + (_e1046.z * _e147.origin.z)) + (_e1046.w * 1f));
                                            let _e1059 = instances.member[(0u + _e973)].world_to_object[1u];
                                            let _e1070 = ((((_e1059.x * _e147.origin.x) + (_e1059.y * _e147.origin.y)) + (_e1059.z * _e147.origin.z)) + (_e1059.w * 1f));
                                            let _e1072 = instances.member[(0u + _e973)].world_to_object[2u];
                                            let _e1083 = ((((_e1072.x * _e147.origin.x) + (_e1072.y * _e147.origin.y)) + (_e1072.z * _e147.origin.z)) + (_e1072.w * 1f));
                                            let _e1090 = instances.member[(0u + _e973)].world_to_object[0u];
                                            let _e1101 = ((((_e1090.x * _e147.direction.x) + (_e1090.y * _e147.direction.y)) + (_e1090.z * _e147.direction.z)) + (_e1090.w * 0f));
                                            let _e1103 = instances.member[(0u + _e973)].world_to_object[1u];
                                            let _e1114 = ((((_e1103.x * _e147.direction.x) + (_e1103.y * _e147.direction.y)) + (_e1103.z * _e147.direction.z)) + (_e1103.w * 0f));
                                            let _e1116 = instances.member[(0u + _e973)].world_to_object[2u];
                                            let _e1127 = ((((_e1116.x * _e147.direction.x) + (_e1116.y * _e147.direction.y)) + (_e1116.z * _e147.direction.z)) + (_e1116.w * 0f));
                                            let _e1131 = instances.member[(0u + _e973)].root;
                                            let _e1133 = instances.member[(0u + _e973)].first_triangle;
                                            let _e1137 = abs(_e1101);
                                            let _e1138 = abs(_e1114);
                                            let _e1139 = abs(_e1127);
                                            if (abs(_e1057) < 1000000000000000f) {
                                                if (abs(_e1070) < 1000000000000000f) {
                                                    if (abs(_e1083) < 1000000000000000f) {
                                                        if (_e1137 < 1000000000000000f) {
                                                            if (_e1138 < 1000000000000000f) {
                                                                if (_e1139 < 1000000000000000f) {
                                                                    if (_e1137 > 0f) {
                                                                        phi_1587_ = bool();
                                                                        phi_1588_ = true;
                                                                    } else {
                                                                        let _e1147 = (_e1138 > 0f);
                                                                        if _e1147 {
                                                                            phi_1586_ = bool();
                                                                        } else {
                                                                            phi_1586_ = (_e1139 > 0f);
                                                                        }
                                                                        let _e1150 = phi_1586_;
                                                                        phi_1587_ = _e1150;
                                                                        phi_1588_ = _e1147;
                                                                    }
                                                                    let _e1152 = phi_1587_;
                                                                    let _e1154 = phi_1588_;
                                                                    if _e1154 {
                                                                        phi_1592_ = true;
                                                                    } else {
                                                                        phi_1592_ = _e1152;
                                                                    }
                                                                    let _e1156 = phi_1592_;
                                                                    phi_1593_ = _e1156;
                                                                    phi_1594_ = false;
                                                                } else {
                                                                    phi_1593_ = bool();
                                                                    phi_1594_ = true;
                                                                }
                                                                let _e1158 = phi_1593_;
                                                                let _e1160 = phi_1594_;
                                                                phi_1595_ = _e1158;
                                                                phi_1596_ = false;
                                                                phi_1597_ = _e1160;
                                                            } else {
                                                                phi_1595_ = bool();
                                                                phi_1596_ = true;
                                                                phi_1597_ = false;
                                                            }
                                                            let _e1162 = phi_1595_;
                                                            let _e1164 = phi_1596_;
                                                            let _e1166 = phi_1597_;
                                                            phi_1598_ = _e1162;
                                                            phi_1599_ = _e1164;
                                                            phi_1600_ = _e1166;
                                                        } else {
                                                            phi_1598_ = bool();
                                                            phi_1599_ = true;
                                                            phi_1600_ = false;
                                                        }
                                                        let _e1168 = phi_1598_;
                                                        let _e1170 = phi_1599_;
                                                        let _e1172 = phi_1600_;
                                                        phi_1601_ = _e1168;
                                                        phi_1602_ = _e1170;
                                                        phi_1603_ = _e1172;
                                                    } else {
                                                        phi_1601_ = bool();
                                                        phi_1602_ = true;
                                                        phi_1603_ = false;
                                                    }
                                                    let _e1174 = phi_1601_;
                                                    let _e1176 = phi_1602_;
                                                    let _e1178 = phi_1603_;
                                                    phi_1604_ = _e1174;
                                                    phi_1605_ = _e1176;
                                                    phi_1606_ = _e1178;
                                                } else {
                                                    phi_1604_ = bool();
                                                    phi_1605_ = true;
                                                    phi_1606_ = false;
                                                }
                                                let _e1180 = phi_1604_;
                                                let _e1182 = phi_1605_;
                                                let _e1184 = phi_1606_;
                                                phi_1607_ = _e1180;
                                                phi_1608_ = _e1182;
                                                phi_1609_ = _e1184;
                                            } else {
                                                phi_1607_ = bool();
                                                phi_1608_ = true;
                                                phi_1609_ = false;
                                            }
                                            let _e1186 = phi_1607_;
                                            let _e1188 = phi_1608_;
                                            let _e1190 = phi_1609_;
                                            if _e1188 {
                                                phi_1613_ = true;
                                            } else {
                                                phi_1613_ = _e1190;
                                            }
                                            let _e1192 = phi_1613_;
                                            if _e1192 {
                                                phi_1617_ = false;
                                            } else {
                                                phi_1617_ = _e1186;
                                            }
                                            let _e1194 = phi_1617_;
                                            if _e1194 {
                                                let _e1195 = (_e1131 >= _e69);
                                                if _e1195 {
                                                    phi_2902_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1131 < _e69) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1201 = nodes.member[(0u + _e1131)].frame[0u];
                                                    let _e1205 = nodes.member[(0u + _e1131)].frame[1u];
                                                    let _e1209 = nodes.member[(0u + _e1131)].frame[2u];
                                                    let _e1213 = nodes.member[(0u + _e1131)].frame[0u];
                                                    let _e1217 = nodes.member[(0u + _e1131)].frame[1u];
                                                    let _e1221 = nodes.member[(0u + _e1131)].frame[2u];
                                                    let _e1225 = nodes.member[(0u + _e1131)].frame[3u];
                                                    let _e1259 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1101), abs(_e1114));
                                                    let _e1260 = core_intrinsics_maximum_number_nsz_f32_(_e1259, abs(_e1127));
                                                    let _e1261 = (_e1260 * 0.0000000000009094947f);
                                                    if (abs(_e1101) < _e1261) {
                                                        phi_1687_ = _e1261;
                                                    } else {
                                                        phi_1687_ = abs(_e1101);
                                                    }
                                                    let _e1266 = phi_1687_;
                                                    if (_e1101 < 0f) {
                                                        phi_1694_ = (-1f / _e1266);
                                                    } else {
                                                        phi_1694_ = (1f / _e1266);
                                                    }
                                                    let _e1271 = phi_1694_;
                                                    if (abs(_e1114) < _e1261) {
                                                        phi_1701_ = _e1261;
                                                    } else {
                                                        phi_1701_ = abs(_e1114);
                                                    }
                                                    let _e1276 = phi_1701_;
                                                    if (_e1114 < 0f) {
                                                        phi_1708_ = (-1f / _e1276);
                                                    } else {
                                                        phi_1708_ = (1f / _e1276);
                                                    }
                                                    let _e1281 = phi_1708_;
                                                    if (abs(_e1127) < _e1261) {
                                                        phi_1715_ = _e1261;
                                                    } else {
                                                        phi_1715_ = abs(_e1127);
                                                    }
                                                    let _e1286 = phi_1715_;
                                                    if (_e1127 < 0f) {
                                                        phi_1722_ = (-1f / _e1286);
                                                    } else {
                                                        phi_1722_ = (1f / _e1286);
                                                    }
                                                    let _e1291 = phi_1722_;
                                                    let _e1295 = abs((bitcast<f32>(_e1201) - _e1057));
                                                    let _e1296 = abs((bitcast<f32>(_e1205) - _e1070));
                                                    let _e1297 = abs((bitcast<f32>(_e1209) - _e1083));
                                                    let _e1301 = abs(((bitcast<f32>(_e1213) + (bitcast<f32>((((_e1225 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1057));
                                                    let _e1302 = abs(((bitcast<f32>(_e1217) + (bitcast<f32>((((_e1225 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1070));
                                                    let _e1303 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1225 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1083));
                                                    if (_e1295 > _e1301) {
                                                        phi_1739_ = _e1295;
                                                    } else {
                                                        phi_1739_ = _e1301;
                                                    }
                                                    let _e1306 = phi_1739_;
                                                    if (_e1296 > _e1302) {
                                                        phi_1744_ = _e1296;
                                                    } else {
                                                        phi_1744_ = _e1302;
                                                    }
                                                    let _e1309 = phi_1744_;
                                                    if (_e1297 > _e1303) {
                                                        phi_1749_ = _e1297;
                                                    } else {
                                                        phi_1749_ = _e1303;
                                                    }
                                                    let _e1312 = phi_1749_;
                                                    let _e1313 = core_intrinsics_maximum_number_nsz_f32_(_e1306, _e1309);
                                                    let _e1314 = core_intrinsics_maximum_number_nsz_f32_(_e1313, _e1312);
                                                    let _e1318 = (_e1314 * 0.0000019073486f);
                                                    let _e1319 = (abs(_e1271) * _e1318);
                                                    let _e1320 = (abs(_e1281) * _e1318);
                                                    let _e1321 = (abs(_e1291) * _e1318);
                                                    let _e1325 = (_e1314 * 0.0000009536743f);
                                                    let _e1326 = (abs(_e1271) * _e1325);
                                                    let _e1327 = (abs(_e1281) * _e1325);
                                                    let _e1328 = (abs(_e1291) * _e1325);
                                                    let _e1329 = abs(_e1101);
                                                    let _e1330 = abs(_e1114);
                                                    let _e1331 = abs(_e1127);
                                                    if (_e1329 >= _e1330) {
                                                        if (_e1329 >= _e1331) {
                                                            phi_1777_ = false;
                                                        } else {
                                                            phi_1777_ = true;
                                                        }
                                                        let _e1335 = phi_1777_;
                                                        phi_1778_ = _e1335;
                                                    } else {
                                                        phi_1778_ = true;
                                                    }
                                                    let _e1337 = phi_1778_;
                                                    if _e1337 {
                                                        if (_e1330 >= _e1331) {
                                                            phi_1786_ = 1u;
                                                        } else {
                                                            phi_1786_ = 2u;
                                                        }
                                                        let _e1340 = phi_1786_;
                                                        phi_1787_ = _e1340;
                                                    } else {
                                                        phi_1787_ = 0u;
                                                    }
                                                    let _e1342 = phi_1787_;
                                                    if (_e1342 == 0u) {
                                                        phi_1799_ = vec3<f32>(_e1114, _e1127, _e1101);
                                                    } else {
                                                        if (_e1342 == 1u) {
                                                            phi_1798_ = vec3<f32>(_e1127, _e1101, _e1114);
                                                        } else {
                                                            phi_1798_ = vec3<f32>(_e1101, _e1114, _e1127);
                                                        }
                                                        let _e1348 = phi_1798_;
                                                        phi_1799_ = _e1348;
                                                    }
                                                    let _e1350 = phi_1799_;
                                                    let _e1353 = (_e1350.x / _e1350.z);
                                                    let _e1356 = (_e1350.y / _e1350.z);
                                                    let _e1358 = (1f / _e1350.z);
                                                    if (_e1271 < 0f) {
                                                        phi_1812_ = 0u;
                                                    } else {
                                                        phi_1812_ = 1u;
                                                    }
                                                    let _e1361 = phi_1812_;
                                                    if (_e1281 < 0f) {
                                                        phi_1817_ = 0u;
                                                    } else {
                                                        phi_1817_ = 2u;
                                                    }
                                                    let _e1364 = phi_1817_;
                                                    if (_e1291 < 0f) {
                                                        phi_1822_ = 0u;
                                                    } else {
                                                        phi_1822_ = 4u;
                                                    }
                                                    let _e1367 = phi_1822_;
                                                    let _e1369 = ((_e1361 | _e1364) | _e1367);
                                                    let _e1370 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1131, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1370.first[0], _e1370.first[1], _e1370.first[2], _e1370.first[3], _e1370.first[4], _e1370.first[5], _e1370.first[6], _e1370.first[7], _e1370.first[8], _e1370.first[9], _e1370.first[10], _e1370.first[11], _e1370.first[12], _e1370.first[13], _e1370.first[14], _e1370.first[15], _e1370.first[16], _e1370.first[17], _e1370.first[18], _e1370.first[19], _e1370.first[20], _e1370.first[21], _e1370.first[22], _e1370.first[23], _e1370.first[24], _e1370.first[25], _e1370.first[26], _e1370.first[27], _e1370.first[28], _e1370.first[29], _e1370.first[30], _e1370.first[31]), array<u32, 32>(_e1370.mask[0], _e1370.mask[1], _e1370.mask[2], _e1370.mask[3], _e1370.mask[4], _e1370.mask[5], _e1370.mask[6], _e1370.mask[7], _e1370.mask[8], _e1370.mask[9], _e1370.mask[10], _e1370.mask[11], _e1370.mask[12], _e1370.mask[13], _e1370.mask[14], _e1370.mask[15], _e1370.mask[16], _e1370.mask[17], _e1370.mask[18], _e1370.mask[19], _e1370.mask[20], _e1370.mask[21], _e1370.mask[22], _e1370.mask[23], _e1370.mask[24], _e1370.mask[25], _e1370.mask[26], _e1370.mask[27], _e1370.mask[28], _e1370.mask[29], _e1370.mask[30], _e1370.mask[31]), _e1370.len, _e1370.group, _e1370.group_mask);
                                                    let _e1444 = local_2.group_mask;
                                                    if ((_e1444 & 4278190080u) == 0u) {
                                                        let _e1448 = local_2.len;
                                                        if (_e1448 == 0u) {
                                                            phi_1936_ = false;
                                                        } else {
                                                            let _e1452 = local_2.len;
                                                            local_2.len = (_e1452 - 1u);
                                                            let _e1455 = local_2.len;
                                                            if (_e1455 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1460 = local_2.first[(0u + _e1455)];
                                                            local_2.group = _e1460;
                                                            let _e1463 = local_2.len;
                                                            if (_e1463 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1468 = local_2.mask[(0u + _e1463)];
                                                            local_2.group_mask = _e1468;
                                                            phi_1936_ = true;
                                                        }
                                                        let _e1471 = phi_1936_;
                                                        phi_1937_ = _e1471;
                                                    } else {
                                                        phi_1937_ = true;
                                                    }
                                                    let _e1473 = phi_1937_;
                                                    if _e1473 {
                                                        let _e1475 = local_2.group_mask;
                                                        let _e1481 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1475)), 32u, (_e1475 == 0u)));
                                                        let _e1485 = local_2.group_mask;
                                                        let _e1499 = local_2.group_mask;
                                                        local_2.group_mask = (_e1499 & ~((1u << bitcast<u32>((_e1481 & 31u)))));
                                                        let _e1502 = local_2.group;
                                                        phi_1968_ = (_e1502 + countOneBits(((_e1485 & ~((4294967295u << bitcast<u32>((((_e1481 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1968_ = 4294967295u;
                                                    }
                                                    let _e1505 = phi_1968_;
                                                    phi_1970_ = _e965;
                                                    phi_1973_ = _e1505;
                                                    loop {
                                                        let _e1507 = phi_1970_;
                                                        let _e1509 = phi_1973_;
                                                        local_11 = _e1507;
                                                        let _e1510 = (_e1509 != 4294967295u);
                                                        if _e1510 {
                                                            if (_e1509 < _e69) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1517 = nodes.member[(0u + _e1509)].frame[3u];
                                                            let _e1542 = (bitcast<f32>((((_e1517 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1271);
                                                            let _e1543 = (bitcast<f32>((((_e1517 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1281);
                                                            let _e1544 = (bitcast<f32>((((_e1517 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1291);
                                                            let _e1547 = nodes.member[(0u + _e1509)].frame[0u];
                                                            let _e1551 = nodes.member[(0u + _e1509)].frame[1u];
                                                            let _e1555 = nodes.member[(0u + _e1509)].frame[2u];
                                                            let _e1560 = ((bitcast<f32>(_e1547) - _e1057) * _e1271);
                                                            let _e1561 = ((bitcast<f32>(_e1551) - _e1070) * _e1281);
                                                            let _e1562 = ((bitcast<f32>(_e1555) - _e1083) * _e1291);
                                                            let _e1570 = nodes.member[(0u + _e1509)].x;
                                                            if (_e1271 < 0f) {
                                                                let _e1581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1570.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1581.unnamed.root, _e1570.w), _e1581.unnamed_1);
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1587.unnamed, lt_bvh_traverse_Tree(_e1570.x, _e1587.unnamed_1.first_primitive));
                                                                phi_2054_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1593.unnamed, lt_bvh_traverse_Tree(_e1593.unnamed_1.root, _e1570.y));
                                                            } else {
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1570.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1609.unnamed.root, _e1570.y), _e1609.unnamed_1);
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1615.unnamed, lt_bvh_traverse_Tree(_e1570.z, _e1615.unnamed_1.first_primitive));
                                                                phi_2054_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1621.unnamed, lt_bvh_traverse_Tree(_e1621.unnamed_1.root, _e1570.w));
                                                            }
                                                            let _e1629 = phi_2054_;
                                                            let _e1639 = nodes.member[(0u + _e1509)].y;
                                                            if (_e1281 < 0f) {
                                                                let _e1650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1639.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1650.unnamed.root, _e1639.w), _e1650.unnamed_1);
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1656.unnamed, lt_bvh_traverse_Tree(_e1639.x, _e1656.unnamed_1.first_primitive));
                                                                phi_2081_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1662.unnamed, lt_bvh_traverse_Tree(_e1662.unnamed_1.root, _e1639.y));
                                                            } else {
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1639.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1678.unnamed.root, _e1639.y), _e1678.unnamed_1);
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1684.unnamed, lt_bvh_traverse_Tree(_e1639.z, _e1684.unnamed_1.first_primitive));
                                                                phi_2081_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1690.unnamed, lt_bvh_traverse_Tree(_e1690.unnamed_1.root, _e1639.w));
                                                            }
                                                            let _e1698 = phi_2081_;
                                                            let _e1708 = nodes.member[(0u + _e1509)].z;
                                                            if (_e1291 < 0f) {
                                                                let _e1719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1708.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1719.unnamed.root, _e1708.w), _e1719.unnamed_1);
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1725.unnamed, lt_bvh_traverse_Tree(_e1708.x, _e1725.unnamed_1.first_primitive));
                                                                phi_2108_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1731.unnamed, lt_bvh_traverse_Tree(_e1731.unnamed_1.root, _e1708.y));
                                                            } else {
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1708.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1747.unnamed.root, _e1708.y), _e1747.unnamed_1);
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1753.unnamed, lt_bvh_traverse_Tree(_e1708.z, _e1753.unnamed_1.first_primitive));
                                                                phi_2108_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1759.unnamed, lt_bvh_traverse_Tree(_e1759.unnamed_1.root, _e1708.w));
                                                            }
                                                            let _e1767 = phi_2108_;
                                                            phi_2114_ = 0u;
                                                            phi_2117_ = 0u;
                                                            loop {
                                                                let _e1777 = phi_2114_;
                                                                let _e1779 = phi_2117_;
                                                                local_7 = _e1779;
                                                                local_8 = _e1779;
                                                                local_9 = _e1779;
                                                                let _e1780 = (_e1777 < 8u);
                                                                if _e1780 {
                                                                    let _e1782 = (_e1777 >> bitcast<u32>(2i));
                                                                    let _e1783 = (_e1777 & 3u);
                                                                    if (_e1782 == 0u) {
                                                                        phi_2131_ = _e1629.unnamed.root;
                                                                    } else {
                                                                        phi_2131_ = _e1629.unnamed.first_primitive;
                                                                    }
                                                                    let _e1786 = phi_2131_;
                                                                    if (_e1782 == 0u) {
                                                                        phi_2141_ = _e1698.unnamed.root;
                                                                    } else {
                                                                        phi_2141_ = _e1698.unnamed.first_primitive;
                                                                    }
                                                                    let _e1795 = phi_2141_;
                                                                    if (_e1782 == 0u) {
                                                                        phi_2151_ = _e1767.unnamed.root;
                                                                    } else {
                                                                        phi_2151_ = _e1767.unnamed.first_primitive;
                                                                    }
                                                                    let _e1804 = phi_2151_;
                                                                    let _e1817 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1786 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 - _e1319)), ((f32(((_e1795 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u)) * _e1543) + (_e1561 - _e1320)));
                                                                    let _e1818 = core_intrinsics_maximum_number_nsz_f32_(_e1817, ((f32(((_e1804 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u)) * _e1544) + (_e1562 - _e1321)));
                                                                    if (_e1782 == 0u) {
                                                                        phi_2169_ = _e1629.unnamed_1.root;
                                                                    } else {
                                                                        phi_2169_ = _e1629.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1821 = phi_2169_;
                                                                    if (_e1782 == 0u) {
                                                                        phi_2179_ = _e1698.unnamed_1.root;
                                                                    } else {
                                                                        phi_2179_ = _e1698.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1830 = phi_2179_;
                                                                    if (_e1782 == 0u) {
                                                                        phi_2189_ = _e1767.unnamed_1.root;
                                                                    } else {
                                                                        phi_2189_ = _e1767.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1839 = phi_2189_;
                                                                    let _e1852 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1821 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 + _e1319)), ((f32(((_e1830 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u)) * _e1543) + (_e1561 + _e1320)));
                                                                    let _e1853 = core_intrinsics_minimum_number_nsz_f32_(_e1852, ((f32(((_e1839 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u)) * _e1544) + (_e1562 + _e1321)));
                                                                    if (_e1818 <= _e1853) {
                                                                        if (_e1818 <= _e1507.t) {
                                                                            if (_e1853 >= _e147.tmin) {
                                                                                if (_e1782 == 0u) {
                                                                                    let _e1860 = nodes.member[(0u + _e1509)].links[2u];
                                                                                    phi_2225_ = _e1860;
                                                                                } else {
                                                                                    let _e1863 = nodes.member[(0u + _e1509)].links[3u];
                                                                                    phi_2225_ = _e1863;
                                                                                }
                                                                                let _e1865 = phi_2225_;
                                                                                let _e1870 = ((_e1865 >> bitcast<u32>(((_e1783 * 8u) & 31u))) & 255u);
                                                                                let _e1871 = (_e1870 & 31u);
                                                                                if (_e1871 >= 24u) {
                                                                                    phi_2238_ = (24u + ((_e1871 - 24u) ^ _e1369));
                                                                                } else {
                                                                                    phi_2238_ = _e1871;
                                                                                }
                                                                                let _e1877 = phi_2238_;
                                                                                phi_2243_ = (_e1779 | ((_e1870 >> bitcast<u32>(5i)) << bitcast<u32>((_e1877 & 31u))));
                                                                            } else {
                                                                                phi_2243_ = _e1779;
                                                                            }
                                                                            let _e1885 = phi_2243_;
                                                                            phi_2244_ = _e1885;
                                                                        } else {
                                                                            phi_2244_ = _e1779;
                                                                        }
                                                                        let _e1887 = phi_2244_;
                                                                        phi_2245_ = _e1887;
                                                                    } else {
                                                                        phi_2245_ = _e1779;
                                                                    }
                                                                    let _e1889 = phi_2245_;
                                                                    phi_2115_ = (_e1777 + 1u);
                                                                    phi_2118_ = _e1889;
                                                                } else {
                                                                    phi_2115_ = u32();
                                                                    phi_2118_ = u32();
                                                                }
                                                                let _e1892 = phi_2115_;
                                                                let _e1894 = phi_2118_;
                                                                continue;
                                                                continuing {
                                                                    phi_2114_ = _e1892;
                                                                    phi_2117_ = _e1894;
                                                                    break if !(_e1780);
                                                                }
                                                            }
                                                            let _e1898 = nodes.member[(0u + _e1509)].links[0u];
                                                            let _e1902 = nodes.member[(0u + _e1509)].frame[3u];
                                                            let _e1906 = local_7;
                                                            if ((_e1906 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1910 = local_2.group_mask;
                                                                if ((_e1910 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1914 = local_2.len;
                                                                    if (_e1914 < 32u) {
                                                                        let _e1917 = local_2.group;
                                                                        let _e1919 = local_2.len;
                                                                        if (_e1919 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1919)] = _e1917;
                                                                        let _e1925 = local_2.group_mask;
                                                                        let _e1927 = local_2.len;
                                                                        if (_e1927 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1927)] = _e1925;
                                                                        let _e1934 = local_2.len;
                                                                        local_2.len = (_e1934 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1131 + _e1898);
                                                                let _e1938 = local_8;
                                                                local_2.group_mask = ((_e1938 & 4278190080u) | (_e1902 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1943 = local_9;
                                                            phi_2303_ = _e1507;
                                                            phi_2306_ = (_e1943 & 16777215u);
                                                            loop {
                                                                let _e1946 = phi_2303_;
                                                                let _e1948 = phi_2306_;
                                                                local_10 = _e1946;
                                                                if (_e1948 == 0u) {
                                                                    phi_2304_ = lt_bvh_Hit();
                                                                    phi_2307_ = u32();
                                                                    phi_2830_ = false;
                                                                } else {
                                                                    let _e1952 = nodes.member[(0u + _e1509)].links[1u];
                                                                    let _e1957 = ((_e1133 + _e1952) + select(firstTrailingBit(_e1948), 32u, (_e1948 == 0u)));
                                                                    if (_e1957 < _e72) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1964 = triangles.member[(0u + _e1957)].v0_;
                                                                    let _e1966 = (_e1964.x - _e1057);
                                                                    let _e1968 = (_e1964.y - _e1070);
                                                                    let _e1970 = (_e1964.z - _e1083);
                                                                    if (_e1342 == 0u) {
                                                                        phi_2351_ = vec3<f32>(_e1968, _e1970, _e1966);
                                                                    } else {
                                                                        if (_e1342 == 1u) {
                                                                            phi_2350_ = vec3<f32>(_e1970, _e1966, _e1968);
                                                                        } else {
                                                                            phi_2350_ = (_e1964 - vec3<f32>(_e1057, _e1070, _e1083));
                                                                        }
                                                                        let _e1978 = phi_2350_;
                                                                        phi_2351_ = _e1978;
                                                                    }
                                                                    let _e1980 = phi_2351_;
                                                                    let _e1984 = (_e1980.x - (_e1353 * _e1980.z));
                                                                    let _e1988 = (_e1980.y - (_e1356 * _e1980.z));
                                                                    let _e1992 = triangles.member[(0u + _e1957)].v1_;
                                                                    let _e1994 = (_e1992.x - _e1057);
                                                                    let _e1996 = (_e1992.y - _e1070);
                                                                    let _e1998 = (_e1992.z - _e1083);
                                                                    if (_e1342 == 0u) {
                                                                        phi_2383_ = vec3<f32>(_e1996, _e1998, _e1994);
                                                                    } else {
                                                                        if (_e1342 == 1u) {
                                                                            phi_2382_ = vec3<f32>(_e1998, _e1994, _e1996);
                                                                        } else {
                                                                            phi_2382_ = (_e1992 - vec3<f32>(_e1057, _e1070, _e1083));
                                                                        }
                                                                        let _e2006 = phi_2382_;
                                                                        phi_2383_ = _e2006;
                                                                    }
                                                                    let _e2008 = phi_2383_;
                                                                    let _e2012 = (_e2008.x - (_e1353 * _e2008.z));
                                                                    let _e2016 = (_e2008.y - (_e1356 * _e2008.z));
                                                                    let _e2020 = triangles.member[(0u + _e1957)].v2_;
                                                                    let _e2022 = (_e2020.x - _e1057);
                                                                    let _e2024 = (_e2020.y - _e1070);
                                                                    let _e2026 = (_e2020.z - _e1083);
                                                                    if (_e1342 == 0u) {
                                                                        phi_2415_ = vec3<f32>(_e2024, _e2026, _e2022);
                                                                    } else {
                                                                        if (_e1342 == 1u) {
                                                                            phi_2414_ = vec3<f32>(_e2026, _e2022, _e2024);
                                                                        } else {
                                                                            phi_2414_ = (_e2020 - vec3<f32>(_e1057, _e1070, _e1083));
                                                                        }
                                                                        let _e2034 = phi_2414_;
                                                                        phi_2415_ = _e2034;
                                                                    }
                                                                    let _e2036 = phi_2415_;
                                                                    let _e2040 = (_e2036.x - (_e1353 * _e2036.z));
                                                                    let _e2044 = (_e2036.y - (_e1356 * _e2036.z));
                                                                    if (_e2012 < _e2040) {
                                                                        phi_2436_ = true;
                                                                    } else {
                                                                        if (_e2012 == _e2040) {
                                                                            phi_2435_ = (_e2016 < _e2044);
                                                                        } else {
                                                                            phi_2435_ = false;
                                                                        }
                                                                        let _e2051 = phi_2435_;
                                                                        phi_2436_ = _e2051;
                                                                    }
                                                                    let _e2053 = phi_2436_;
                                                                    if _e2053 {
                                                                        phi_2440_ = _e2044;
                                                                        phi_2441_ = _e2040;
                                                                        phi_2442_ = _e2016;
                                                                        phi_2443_ = _e2012;
                                                                    } else {
                                                                        phi_2440_ = _e2016;
                                                                        phi_2441_ = _e2012;
                                                                        phi_2442_ = _e2044;
                                                                        phi_2443_ = _e2040;
                                                                    }
                                                                    let _e2055 = phi_2440_;
                                                                    let _e2057 = phi_2441_;
                                                                    let _e2059 = phi_2442_;
                                                                    let _e2061 = phi_2443_;
                                                                    let _e2064 = ((_e2061 * _e2055) - (_e2059 * _e2057));
                                                                    if _e2053 {
                                                                        phi_2451_ = -(_e2064);
                                                                    } else {
                                                                        phi_2451_ = _e2064;
                                                                    }
                                                                    let _e2067 = phi_2451_;
                                                                    if (_e2040 < _e1984) {
                                                                        phi_2462_ = true;
                                                                    } else {
                                                                        if (_e2040 == _e1984) {
                                                                            phi_2461_ = (_e2044 < _e1988);
                                                                        } else {
                                                                            phi_2461_ = false;
                                                                        }
                                                                        let _e2072 = phi_2461_;
                                                                        phi_2462_ = _e2072;
                                                                    }
                                                                    let _e2074 = phi_2462_;
                                                                    if _e2074 {
                                                                        phi_2466_ = _e1988;
                                                                        phi_2467_ = _e1984;
                                                                        phi_2468_ = _e2044;
                                                                        phi_2469_ = _e2040;
                                                                    } else {
                                                                        phi_2466_ = _e2044;
                                                                        phi_2467_ = _e2040;
                                                                        phi_2468_ = _e1988;
                                                                        phi_2469_ = _e1984;
                                                                    }
                                                                    let _e2076 = phi_2466_;
                                                                    let _e2078 = phi_2467_;
                                                                    let _e2080 = phi_2468_;
                                                                    let _e2082 = phi_2469_;
                                                                    let _e2085 = ((_e2082 * _e2076) - (_e2080 * _e2078));
                                                                    if _e2074 {
                                                                        phi_2477_ = -(_e2085);
                                                                    } else {
                                                                        phi_2477_ = _e2085;
                                                                    }
                                                                    let _e2088 = phi_2477_;
                                                                    if (_e1984 < _e2012) {
                                                                        phi_2488_ = true;
                                                                    } else {
                                                                        if (_e1984 == _e2012) {
                                                                            phi_2487_ = (_e1988 < _e2016);
                                                                        } else {
                                                                            phi_2487_ = false;
                                                                        }
                                                                        let _e2093 = phi_2487_;
                                                                        phi_2488_ = _e2093;
                                                                    }
                                                                    let _e2095 = phi_2488_;
                                                                    if _e2095 {
                                                                        phi_2492_ = _e2016;
                                                                        phi_2493_ = _e2012;
                                                                        phi_2494_ = _e1988;
                                                                        phi_2495_ = _e1984;
                                                                    } else {
                                                                        phi_2492_ = _e1988;
                                                                        phi_2493_ = _e1984;
                                                                        phi_2494_ = _e2016;
                                                                        phi_2495_ = _e2012;
                                                                    }
                                                                    let _e2097 = phi_2492_;
                                                                    let _e2099 = phi_2493_;
                                                                    let _e2101 = phi_2494_;
                                                                    let _e2103 = phi_2495_;
                                                                    let _e2106 = ((_e2103 * _e2097) - (_e2101 * _e2099));
                                                                    if _e2095 {
                                                                        phi_2503_ = -(_e2106);
                                                                    } else {
                                                                        phi_2503_ = _e2106;
                                                                    }
                                                                    let _e2109 = phi_2503_;
                                                                    if (_e2067 >= 0f) {
                                                                        if (_e2088 >= 0f) {
                                                                            if (_e2109 >= 0f) {
                                                                                phi_2518_ = ((_e2067 + _e2088) + _e2109);
                                                                                phi_2519_ = false;
                                                                            } else {
                                                                                phi_2518_ = f32();
                                                                                phi_2519_ = true;
                                                                            }
                                                                            let _e2116 = phi_2518_;
                                                                            let _e2118 = phi_2519_;
                                                                            phi_2520_ = _e2116;
                                                                            phi_2521_ = _e2118;
                                                                        } else {
                                                                            phi_2520_ = f32();
                                                                            phi_2521_ = true;
                                                                        }
                                                                        let _e2120 = phi_2520_;
                                                                        let _e2122 = phi_2521_;
                                                                        phi_2522_ = _e2120;
                                                                        phi_2523_ = _e2122;
                                                                    } else {
                                                                        phi_2522_ = f32();
                                                                        phi_2523_ = true;
                                                                    }
                                                                    let _e2124 = phi_2522_;
                                                                    let _e2126 = phi_2523_;
                                                                    if _e2126 {
                                                                        if (_e2067 <= 0f) {
                                                                            if (_e2088 <= 0f) {
                                                                                let _e2129 = (_e2109 <= 0f);
                                                                                if _e2129 {
                                                                                }
                                                                                phi_2541_ = ((_e2067 + _e2088) + _e2109);
                                                                                phi_2542_ = false;
                                                                                phi_2543_ = _e2129;
                                                                            } else {
                                                                                phi_2541_ = f32();
                                                                                phi_2542_ = true;
                                                                                phi_2543_ = false;
                                                                            }
                                                                            let _e2133 = phi_2541_;
                                                                            let _e2135 = phi_2542_;
                                                                            let _e2137 = phi_2543_;
                                                                            phi_2544_ = _e2133;
                                                                            phi_2545_ = _e2135;
                                                                            phi_2546_ = _e2137;
                                                                        } else {
                                                                            phi_2544_ = f32();
                                                                            phi_2545_ = true;
                                                                            phi_2546_ = false;
                                                                        }
                                                                        let _e2139 = phi_2544_;
                                                                        let _e2141 = phi_2545_;
                                                                        let _e2143 = phi_2546_;
                                                                        if _e2141 {
                                                                            phi_2550_ = false;
                                                                        } else {
                                                                            phi_2550_ = _e2143;
                                                                        }
                                                                        let _e2145 = phi_2550_;
                                                                        phi_2551_ = _e2139;
                                                                        phi_2552_ = _e2145;
                                                                    } else {
                                                                        phi_2551_ = _e2124;
                                                                        phi_2552_ = true;
                                                                    }
                                                                    let _e2147 = phi_2551_;
                                                                    let _e2149 = phi_2552_;
                                                                    if _e2149 {
                                                                        let _e2150 = (_e2147 == 0f);
                                                                        if _e2150 {
                                                                            phi_2750_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2156 = ((((_e2067 * (_e1358 * _e1980.z)) + (_e2088 * (_e1358 * _e2008.z))) + (_e2109 * (_e1358 * _e2036.z))) / _e2147);
                                                                            let _e2158 = triangles.member[(0u + _e1957)].v0_;
                                                                            let _e2160 = triangles.member[(0u + _e1957)].v1_;
                                                                            if (_e2158.x < _e2160.x) {
                                                                                phi_2578_ = _e2158.x;
                                                                            } else {
                                                                                phi_2578_ = _e2160.x;
                                                                            }
                                                                            let _e2167 = phi_2578_;
                                                                            if (_e2158.y < _e2160.y) {
                                                                                phi_2587_ = _e2158.y;
                                                                            } else {
                                                                                phi_2587_ = _e2160.y;
                                                                            }
                                                                            let _e2174 = phi_2587_;
                                                                            if (_e2158.z < _e2160.z) {
                                                                                phi_2596_ = _e2158.z;
                                                                            } else {
                                                                                phi_2596_ = _e2160.z;
                                                                            }
                                                                            let _e2181 = phi_2596_;
                                                                            let _e2183 = triangles.member[(0u + _e1957)].v2_;
                                                                            if (_e2167 < _e2183.x) {
                                                                                phi_2605_ = _e2167;
                                                                            } else {
                                                                                phi_2605_ = _e2183.x;
                                                                            }
                                                                            let _e2188 = phi_2605_;
                                                                            if (_e2174 < _e2183.y) {
                                                                                phi_2612_ = _e2174;
                                                                            } else {
                                                                                phi_2612_ = _e2183.y;
                                                                            }
                                                                            let _e2193 = phi_2612_;
                                                                            if (_e2181 < _e2183.z) {
                                                                                phi_2619_ = _e2181;
                                                                            } else {
                                                                                phi_2619_ = _e2183.z;
                                                                            }
                                                                            let _e2198 = phi_2619_;
                                                                            let _e2200 = triangles.member[(0u + _e1957)].v0_;
                                                                            let _e2202 = triangles.member[(0u + _e1957)].v1_;
                                                                            if (_e2200.x > _e2202.x) {
                                                                                phi_2632_ = _e2200.x;
                                                                            } else {
                                                                                phi_2632_ = _e2202.x;
                                                                            }
                                                                            let _e2209 = phi_2632_;
                                                                            if (_e2200.y > _e2202.y) {
                                                                                phi_2641_ = _e2200.y;
                                                                            } else {
                                                                                phi_2641_ = _e2202.y;
                                                                            }
                                                                            let _e2216 = phi_2641_;
                                                                            if (_e2200.z > _e2202.z) {
                                                                                phi_2650_ = _e2200.z;
                                                                            } else {
                                                                                phi_2650_ = _e2202.z;
                                                                            }
                                                                            let _e2223 = phi_2650_;
                                                                            let _e2225 = triangles.member[(0u + _e1957)].v2_;
                                                                            if (_e2209 > _e2225.x) {
                                                                                phi_2659_ = _e2209;
                                                                            } else {
                                                                                phi_2659_ = _e2225.x;
                                                                            }
                                                                            let _e2230 = phi_2659_;
                                                                            if (_e2216 > _e2225.y) {
                                                                                phi_2666_ = _e2216;
                                                                            } else {
                                                                                phi_2666_ = _e2225.y;
                                                                            }
                                                                            let _e2235 = phi_2666_;
                                                                            if (_e2223 > _e2225.z) {
                                                                                phi_2673_ = _e2223;
                                                                            } else {
                                                                                phi_2673_ = _e2225.z;
                                                                            }
                                                                            let _e2240 = phi_2673_;
                                                                            let _e2244 = ((_e2188 - _e1057) * _e1271);
                                                                            let _e2245 = ((_e2193 - _e1070) * _e1281);
                                                                            let _e2246 = ((_e2198 - _e1083) * _e1291);
                                                                            let _e2250 = ((_e2230 - _e1057) * _e1271);
                                                                            let _e2251 = ((_e2235 - _e1070) * _e1281);
                                                                            let _e2252 = ((_e2240 - _e1083) * _e1291);
                                                                            if (_e2244 < _e2250) {
                                                                                phi_2690_ = _e2244;
                                                                            } else {
                                                                                phi_2690_ = _e2250;
                                                                            }
                                                                            let _e2255 = phi_2690_;
                                                                            if (_e2245 < _e2251) {
                                                                                phi_2695_ = _e2245;
                                                                            } else {
                                                                                phi_2695_ = _e2251;
                                                                            }
                                                                            let _e2258 = phi_2695_;
                                                                            if (_e2246 < _e2252) {
                                                                                phi_2700_ = _e2246;
                                                                            } else {
                                                                                phi_2700_ = _e2252;
                                                                            }
                                                                            let _e2261 = phi_2700_;
                                                                            if (_e2244 > _e2250) {
                                                                                phi_2708_ = _e2244;
                                                                            } else {
                                                                                phi_2708_ = _e2250;
                                                                            }
                                                                            let _e2267 = phi_2708_;
                                                                            if (_e2245 > _e2251) {
                                                                                phi_2713_ = _e2245;
                                                                            } else {
                                                                                phi_2713_ = _e2251;
                                                                            }
                                                                            let _e2270 = phi_2713_;
                                                                            if (_e2246 > _e2252) {
                                                                                phi_2718_ = _e2246;
                                                                            } else {
                                                                                phi_2718_ = _e2252;
                                                                            }
                                                                            let _e2273 = phi_2718_;
                                                                            let _e2277 = core_intrinsics_maximum_number_nsz_f32_((_e2255 - _e1326), (_e2258 - _e1327));
                                                                            let _e2278 = core_intrinsics_maximum_number_nsz_f32_(_e2277, (_e2261 - _e1328));
                                                                            let _e2279 = core_intrinsics_minimum_number_nsz_f32_((_e2267 + _e1326), (_e2270 + _e1327));
                                                                            let _e2280 = core_intrinsics_minimum_number_nsz_f32_(_e2279, (_e2273 + _e1328));
                                                                            if (_e2278 > _e1032) {
                                                                                phi_2730_ = _e2278;
                                                                            } else {
                                                                                phi_2730_ = _e1032;
                                                                            }
                                                                            let _e2283 = phi_2730_;
                                                                            if (_e2280 < _e1034) {
                                                                                phi_2735_ = _e2280;
                                                                            } else {
                                                                                phi_2735_ = _e1034;
                                                                            }
                                                                            let _e2286 = phi_2735_;
                                                                            if (_e2156 < _e2283) {
                                                                                phi_2740_ = _e2283;
                                                                            } else {
                                                                                phi_2740_ = _e2156;
                                                                            }
                                                                            let _e2289 = phi_2740_;
                                                                            if (_e2289 > _e2286) {
                                                                                phi_2745_ = _e2286;
                                                                            } else {
                                                                                phi_2745_ = _e2289;
                                                                            }
                                                                            let _e2292 = phi_2745_;
                                                                            phi_2750_ = lt_bvh_triangle_Intersection(_e2292, (_e2088 / _e2147), (_e2109 / _e2147), (_e2283 <= _e2286));
                                                                        }
                                                                        let _e2298 = phi_2750_;
                                                                        phi_2751_ = _e2298;
                                                                        phi_2752_ = _e2150;
                                                                    } else {
                                                                        phi_2751_ = lt_bvh_triangle_Intersection();
                                                                        phi_2752_ = true;
                                                                    }
                                                                    let _e2300 = phi_2751_;
                                                                    let _e2302 = phi_2752_;
                                                                    if _e2302 {
                                                                        phi_2756_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2756_ = _e2300;
                                                                    }
                                                                    let _e2304 = phi_2756_;
                                                                    if _e2304.is_hit {
                                                                        if (_e2304.t > _e147.tmin) {
                                                                            if (_e2304.t < _e1946.t) {
                                                                                phi_2804_ = true;
                                                                            } else {
                                                                                if (_e2304.t == _e1946.t) {
                                                                                    if (_e1946.triangle != 4294967295u) {
                                                                                        if (_e1957 < _e1946.triangle) {
                                                                                            phi_2795_ = true;
                                                                                        } else {
                                                                                            if (_e1957 == _e1946.triangle) {
                                                                                                phi_2794_ = (_e973 < _e1946.instance);
                                                                                            } else {
                                                                                                phi_2794_ = false;
                                                                                            }
                                                                                            let _e2322 = phi_2794_;
                                                                                            phi_2795_ = _e2322;
                                                                                        }
                                                                                        let _e2324 = phi_2795_;
                                                                                        phi_2796_ = _e2324;
                                                                                        phi_2797_ = false;
                                                                                    } else {
                                                                                        phi_2796_ = bool();
                                                                                        phi_2797_ = true;
                                                                                    }
                                                                                    let _e2326 = phi_2796_;
                                                                                    let _e2328 = phi_2797_;
                                                                                    phi_2798_ = _e2326;
                                                                                    phi_2799_ = _e2328;
                                                                                } else {
                                                                                    phi_2798_ = bool();
                                                                                    phi_2799_ = true;
                                                                                }
                                                                                let _e2330 = phi_2798_;
                                                                                let _e2332 = phi_2799_;
                                                                                if _e2332 {
                                                                                    phi_2803_ = false;
                                                                                } else {
                                                                                    phi_2803_ = _e2330;
                                                                                }
                                                                                let _e2334 = phi_2803_;
                                                                                phi_2804_ = _e2334;
                                                                            }
                                                                            let _e2336 = phi_2804_;
                                                                            if _e2336 {
                                                                                let _e2338 = triangles.member[(0u + _e1957)].i0_;
                                                                                if ((_e2338 & 2147483648u) == 0u) {
                                                                                    phi_2818_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2818_ = true;
                                                                                }
                                                                                let _e2342 = phi_2818_;
                                                                                if _e2342 {
                                                                                    phi_2826_ = lt_bvh_Hit(_e2304.t, _e2304.u, _e2304.v, _e1957, _e973);
                                                                                } else {
                                                                                    phi_2826_ = _e1946;
                                                                                }
                                                                                let _e2348 = phi_2826_;
                                                                                phi_2827_ = _e2348;
                                                                            } else {
                                                                                phi_2827_ = _e1946;
                                                                            }
                                                                            let _e2350 = phi_2827_;
                                                                            phi_2828_ = _e2350;
                                                                        } else {
                                                                            phi_2828_ = _e1946;
                                                                        }
                                                                        let _e2352 = phi_2828_;
                                                                        phi_2829_ = _e2352;
                                                                    } else {
                                                                        phi_2829_ = _e1946;
                                                                    }
                                                                    let _e2354 = phi_2829_;
                                                                    phi_2304_ = _e2354;
                                                                    phi_2307_ = (_e1948 & (_e1948 - 1u));
                                                                    phi_2830_ = true;
                                                                }
                                                                let _e2356 = phi_2304_;
                                                                let _e2358 = phi_2307_;
                                                                let _e2360 = phi_2830_;
                                                                continue;
                                                                continuing {
                                                                    phi_2303_ = _e2356;
                                                                    phi_2306_ = _e2358;
                                                                    break if !(_e2360);
                                                                }
                                                            }
                                                            let _e2363 = local_2.group_mask;
                                                            if ((_e2363 & 4278190080u) == 0u) {
                                                                let _e2367 = local_2.len;
                                                                if (_e2367 == 0u) {
                                                                    phi_2869_ = false;
                                                                } else {
                                                                    let _e2371 = local_2.len;
                                                                    local_2.len = (_e2371 - 1u);
                                                                    let _e2374 = local_2.len;
                                                                    if (_e2374 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2379 = local_2.first[(0u + _e2374)];
                                                                    local_2.group = _e2379;
                                                                    let _e2382 = local_2.len;
                                                                    if (_e2382 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2387 = local_2.mask[(0u + _e2382)];
                                                                    local_2.group_mask = _e2387;
                                                                    phi_2869_ = true;
                                                                }
                                                                let _e2390 = phi_2869_;
                                                                phi_2870_ = _e2390;
                                                            } else {
                                                                phi_2870_ = true;
                                                            }
                                                            let _e2392 = phi_2870_;
                                                            if _e2392 {
                                                                let _e2394 = local_2.group_mask;
                                                                let _e2400 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2394)), 32u, (_e2394 == 0u)));
                                                                let _e2404 = local_2.group_mask;
                                                                let _e2418 = local_2.group_mask;
                                                                local_2.group_mask = (_e2418 & ~((1u << bitcast<u32>((_e2400 & 31u)))));
                                                                let _e2421 = local_2.group;
                                                                phi_2901_ = (_e2421 + countOneBits(((_e2404 & ~((4294967295u << bitcast<u32>((((_e2400 - 24u) ^ _e1369) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2901_ = 4294967295u;
                                                            }
                                                            let _e2424 = phi_2901_;
                                                            let _e3168 = local_10;
                                                            phi_1971_ = _e3168;
                                                            phi_1974_ = _e2424;
                                                        } else {
                                                            phi_1971_ = lt_bvh_Hit();
                                                            phi_1974_ = u32();
                                                        }
                                                        let _e2426 = phi_1971_;
                                                        let _e2428 = phi_1974_;
                                                        continue;
                                                        continuing {
                                                            phi_1970_ = _e2426;
                                                            phi_1973_ = _e2428;
                                                            break if !(_e1510);
                                                        }
                                                    }
                                                    let _e3172 = local_11;
                                                    phi_2902_ = _e3172;
                                                }
                                                let _e2431 = phi_2902_;
                                                phi_2903_ = _e2431;
                                                phi_2904_ = _e1195;
                                            } else {
                                                phi_2903_ = lt_bvh_Hit();
                                                phi_2904_ = true;
                                            }
                                            let _e2433 = phi_2903_;
                                            let _e2435 = phi_2904_;
                                            if _e2435 {
                                                phi_2908_ = _e965;
                                            } else {
                                                phi_2908_ = _e2433;
                                            }
                                            let _e2437 = phi_2908_;
                                            phi_2909_ = _e2437;
                                        } else {
                                            phi_2909_ = _e965;
                                        }
                                        let _e2439 = phi_2909_;
                                        phi_2910_ = _e2439;
                                    } else {
                                        phi_2910_ = _e965;
                                    }
                                    let _e2441 = phi_2910_;
                                    phi_2911_ = _e2441;
                                } else {
                                    phi_2911_ = _e965;
                                }
                                let _e2443 = phi_2911_;
                                phi_1346_ = (_e963 & (_e963 - 1u));
                                phi_1349_ = _e2443;
                                phi_2912_ = true;
                            }
                            let _e2445 = phi_1346_;
                            let _e2447 = phi_1349_;
                            let _e2449 = phi_2912_;
                            continue;
                            continuing {
                                phi_1345_ = _e2445;
                                phi_1348_ = _e2447;
                                break if !(_e2449);
                            }
                        }
                        let _e2452 = local_3.group_mask;
                        if ((_e2452 & 4278190080u) == 0u) {
                            let _e2456 = local_3.len;
                            if (_e2456 == 0u) {
                                phi_2951_ = false;
                            } else {
                                let _e2460 = local_3.len;
                                local_3.len = (_e2460 - 1u);
                                let _e2463 = local_3.len;
                                if (_e2463 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2468 = local_3.first[(0u + _e2463)];
                                local_3.group = _e2468;
                                let _e2471 = local_3.len;
                                if (_e2471 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2476 = local_3.mask[(0u + _e2471)];
                                local_3.group_mask = _e2476;
                                phi_2951_ = true;
                            }
                            let _e2479 = phi_2951_;
                            phi_2952_ = _e2479;
                        } else {
                            phi_2952_ = true;
                        }
                        let _e2481 = phi_2952_;
                        if _e2481 {
                            let _e2483 = local_3.group_mask;
                            let _e2489 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2483)), 32u, (_e2483 == 0u)));
                            let _e2493 = local_3.group_mask;
                            let _e2507 = local_3.group_mask;
                            local_3.group_mask = (_e2507 & ~((1u << bitcast<u32>((_e2489 & 31u)))));
                            let _e2510 = local_3.group;
                            phi_2983_ = (_e2510 + countOneBits(((_e2493 & ~((4294967295u << bitcast<u32>((((_e2489 - 24u) ^ _e382) & 31u))))) & 255u)));
                        } else {
                            phi_2983_ = 4294967295u;
                        }
                        let _e2513 = phi_2983_;
                        phi_1009_ = _e2513;
                        let _e3188 = local_12;
                        phi_1012_ = _e3188;
                    } else {
                        phi_1009_ = u32();
                        phi_1012_ = lt_bvh_Hit();
                    }
                    let _e2515 = phi_1009_;
                    let _e2517 = phi_1012_;
                    continue;
                    continuing {
                        phi_1008_ = _e2515;
                        phi_1011_ = _e2517;
                        break if !(_e523);
                    }
                }
                let _e3191 = local_13;
                phi_2984_ = _e3191;
            }
            let _e2520 = phi_2984_;
            phi_2985_ = _e2520;
            phi_2986_ = _e219;
        } else {
            phi_2985_ = lt_bvh_Hit();
            phi_2986_ = true;
        }
        let _e2522 = phi_2985_;
        let _e2524 = phi_2986_;
        if _e2524 {
            phi_2990_ = _e149;
        } else {
            phi_2990_ = _e2522;
        }
        let _e2526 = phi_2990_;
        if (_e2526.triangle != 4294967295u) {
            let _e2531 = lt_shaders_surface_barycentric_weights(_e2526.u, _e2526.v);
            if (_e2526.triangle < _e72) {
            } else {
                return;
            }
            let _e2536 = triangles.member[(0u + _e2526.triangle)];
            if (_e2526.instance < _e84) {
            } else {
                return;
            }
            let _e2547 = instances.member[(0u + _e2526.instance)].object_to_world[0u];
            let _e2558 = ((((_e2547.x * _e2536.v0_.x) + (_e2547.y * _e2536.v0_.y)) + (_e2547.z * _e2536.v0_.z)) + (_e2547.w * 1f));
            let _e2560 = instances.member[(0u + _e2526.instance)].object_to_world[1u];
            let _e2571 = ((((_e2560.x * _e2536.v0_.x) + (_e2560.y * _e2536.v0_.y)) + (_e2560.z * _e2536.v0_.z)) + (_e2560.w * 1f));
            let _e2573 = instances.member[(0u + _e2526.instance)].object_to_world[2u];
            let _e2584 = ((((_e2573.x * _e2536.v0_.x) + (_e2573.y * _e2536.v0_.y)) + (_e2573.z * _e2536.v0_.z)) + (_e2573.w * 1f));
            let _e2591 = instances.member[(0u + _e2526.instance)].object_to_world[0u];
            let _e2602 = ((((_e2591.x * _e2536.v1_.x) + (_e2591.y * _e2536.v1_.y)) + (_e2591.z * _e2536.v1_.z)) + (_e2591.w * 1f));
            let _e2604 = instances.member[(0u + _e2526.instance)].object_to_world[1u];
            let _e2615 = ((((_e2604.x * _e2536.v1_.x) + (_e2604.y * _e2536.v1_.y)) + (_e2604.z * _e2536.v1_.z)) + (_e2604.w * 1f));
            let _e2617 = instances.member[(0u + _e2526.instance)].object_to_world[2u];
            let _e2628 = ((((_e2617.x * _e2536.v1_.x) + (_e2617.y * _e2536.v1_.y)) + (_e2617.z * _e2536.v1_.z)) + (_e2617.w * 1f));
            let _e2635 = instances.member[(0u + _e2526.instance)].object_to_world[0u];
            let _e2646 = ((((_e2635.x * _e2536.v2_.x) + (_e2635.y * _e2536.v2_.y)) + (_e2635.z * _e2536.v2_.z)) + (_e2635.w * 1f));
            let _e2648 = instances.member[(0u + _e2526.instance)].object_to_world[1u];
            let _e2659 = ((((_e2648.x * _e2536.v2_.x) + (_e2648.y * _e2536.v2_.y)) + (_e2648.z * _e2536.v2_.z)) + (_e2648.w * 1f));
            let _e2661 = instances.member[(0u + _e2526.instance)].object_to_world[2u];
            let _e2672 = ((((_e2661.x * _e2536.v2_.x) + (_e2661.y * _e2536.v2_.y)) + (_e2661.z * _e2536.v2_.z)) + (_e2661.w * 1f));
            let _e2688 = (((_e2558 * _e2531.x) + (_e2602 * _e2531.y)) + (_e2646 * _e2531.z));
            let _e2689 = (((_e2571 * _e2531.x) + (_e2615 * _e2531.y)) + (_e2659 * _e2531.z));
            let _e2690 = (((_e2584 * _e2531.x) + (_e2628 * _e2531.y)) + (_e2672 * _e2531.z));
            let _e2692 = abs(_e2558);
            let _e2693 = abs(_e2571);
            let _e2694 = abs(_e2584);
            let _e2695 = abs(_e2602);
            let _e2696 = abs(_e2615);
            let _e2697 = abs(_e2628);
            if (_e2692 > _e2695) {
                phi_3179_ = _e2692;
            } else {
                phi_3179_ = _e2695;
            }
            let _e2700 = phi_3179_;
            if (_e2693 > _e2696) {
                phi_3184_ = _e2693;
            } else {
                phi_3184_ = _e2696;
            }
            let _e2703 = phi_3184_;
            if (_e2694 > _e2697) {
                phi_3189_ = _e2694;
            } else {
                phi_3189_ = _e2697;
            }
            let _e2706 = phi_3189_;
            let _e2707 = abs(_e2646);
            let _e2708 = abs(_e2659);
            let _e2709 = abs(_e2672);
            if (_e2700 > _e2707) {
                phi_3197_ = _e2700;
            } else {
                phi_3197_ = _e2707;
            }
            let _e2712 = phi_3197_;
            if (_e2703 > _e2708) {
                phi_3202_ = _e2703;
            } else {
                phi_3202_ = _e2708;
            }
            let _e2715 = phi_3202_;
            if (_e2706 > _e2709) {
                phi_3207_ = _e2706;
            } else {
                phi_3207_ = _e2709;
            }
            let _e2718 = phi_3207_;
            let _e2719 = (_e2602 - _e2558);
            let _e2720 = (_e2615 - _e2571);
            let _e2721 = (_e2628 - _e2584);
            let _e2722 = (_e2646 - _e2558);
            let _e2723 = (_e2659 - _e2571);
            let _e2724 = (_e2672 - _e2584);
            let _e2728 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2720), abs(_e2721));
            let _e2729 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2719), _e2728);
            let _e2730 = (_e2719 / _e2729);
            let _e2731 = (_e2720 / _e2729);
            let _e2732 = (_e2721 / _e2729);
            let _e2736 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2723), abs(_e2724));
            let _e2737 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2722), _e2736);
            let _e2738 = (_e2722 / _e2737);
            let _e2739 = (_e2723 / _e2737);
            let _e2740 = (_e2724 / _e2737);
            let _e2743 = ((_e2731 * _e2740) - (_e2739 * _e2732));
            let _e2746 = ((_e2732 * _e2738) - (_e2740 * _e2730));
            let _e2749 = ((_e2730 * _e2739) - (_e2738 * _e2731));
            let _e2751 = p.member.eye;
            let _e2760 = (1f / sqrt((((_e2743 * _e2743) + (_e2746 * _e2746)) + (_e2749 * _e2749))));
            let _e2765 = lt_shaders_camera_facing(vec3<f32>((_e2743 * _e2760), (_e2746 * _e2760), (_e2749 * _e2760)), (_e2751 - vec3<f32>(_e2688, _e2689, _e2690)));
            if (_e2526.triangle < _e72) {
            } else {
                return;
            }
            let _e2770 = triangles.member[(0u + _e2526.triangle)];
            let _e2772 = (_e2770.i0_ & 2147483647u);
            if (_e2772 < _e75) {
            } else {
                return;
            }
            let _e2778 = vertices.member[(0u + _e2772)];
            if (_e2770.i1_ < _e75) {
            } else {
                return;
            }
            let _e2782 = vertices.member[(0u + _e2770.i1_)];
            if (_e2770.i2_ < _e75) {
            } else {
                return;
            }
            let _e2786 = vertices.member[(0u + _e2770.i2_)];
            let _e2787 = array<abi_Vertex, 3>(_e2778, _e2782, _e2786);
            local = array<abi_Vertex, 3>(abi_Vertex(_e2787[0].u, _e2787[0].v, _e2787[0].normal, _e2787[0].color, _e2787[0].material), abi_Vertex(_e2787[1].u, _e2787[1].v, _e2787[1].normal, _e2787[1].color, _e2787[1].material), abi_Vertex(_e2787[2].u, _e2787[2].v, _e2787[2].normal, _e2787[2].color, _e2787[2].material));
            let _e2812 = local[0u].material;
            if (_e2812 < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2816 = materials.member[(0u + _e2812)];
            local_1 = abi_Material(_e2816.base_color, _e2816.cutoff, _e2816.flags, _e2816.alpha_offset, _e2816.alpha_size, _e2816.color_offset, _e2816.color_size, _e2816.pad);
            let _e2826 = lt_shaders_surface_plain_color((&local_1), (&local), _e2531);
            let _e2827 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(_e2531);
            let _e2829 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2715, _e2718);
            let _e2830 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2712, _e2829);
            let _e2832 = local_1.flags;
            if ((_e2832 & 2u) == 0u) {
                phi_3343_ = 0u;
            } else {
                phi_3343_ = 1u;
            }
            let _e2836 = phi_3343_;
            let _e2839 = local[0u].normal;
            if (_e2839 == 2147516416u) {
                phi_3443_ = _e2765;
            } else {
                let _e2843 = local[0u].normal;
                let _e2844 = lt_shaders_surface_octahedral_decode(_e2843);
                let _e2854 = local[1u].normal;
                let _e2855 = lt_shaders_surface_octahedral_decode(_e2854);
                let _e2868 = local[2u].normal;
                let _e2869 = lt_shaders_surface_octahedral_decode(_e2868);
                let _e2877 = (((_e2844.x * _e2531.x) + (_e2855.x * _e2531.y)) + (_e2869.x * _e2531.z));
                let _e2878 = (((_e2844.y * _e2531.x) + (_e2855.y * _e2531.y)) + (_e2869.y * _e2531.z));
                let _e2879 = (((_e2844.z * _e2531.x) + (_e2855.z * _e2531.y)) + (_e2869.z * _e2531.z));
                if (_e2526.instance < _e84) {
                } else {
                    return;
                }
                let _e2886 = instances.member[(0u + _e2526.instance)].world_to_object[0u];
                let _e2895 = instances.member[(0u + _e2526.instance)].world_to_object[1u];
                let _e2907 = instances.member[(0u + _e2526.instance)].world_to_object[2u];
                let _e2914 = (((_e2886.x * _e2877) + (_e2895.x * _e2878)) + (_e2907.x * _e2879));
                let _e2915 = (((_e2886.y * _e2877) + (_e2895.y * _e2878)) + (_e2907.y * _e2879));
                let _e2916 = (((_e2886.z * _e2877) + (_e2895.z * _e2878)) + (_e2907.z * _e2879));
                let _e2922 = sqrt((((_e2914 * _e2914) + (_e2915 * _e2915)) + (_e2916 * _e2916)));
                if (_e2922 > 0f) {
                    let _e2928 = lt_shaders_camera_facing(vec3<f32>((_e2914 / _e2922), (_e2915 / _e2922), (_e2916 / _e2922)), _e2765);
                    phi_3442_ = _e2928;
                } else {
                    phi_3442_ = _e2765;
                }
                let _e2930 = phi_3442_;
                phi_3443_ = _e2930;
            }
            let _e2932 = phi_3443_;
            let _e2933 = lt_shaders_shade_pack_albedo((_e2826 * _e2827));
            phi_3447_ = abi_Sample(vec3<f32>(_e2688, _e2689, _e2690), _e2830, _e2765, _e2836, _e2932, _e2933);
        } else {
            phi_3447_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2937 = phi_3447_;
        if (_e90.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e90.first_primitive)] = _e2937;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
