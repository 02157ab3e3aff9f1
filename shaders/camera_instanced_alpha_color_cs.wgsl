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

struct type_40 {
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

struct type_49 {
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

struct type_58 {
    member: abi_CameraParams,
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
var<storage> vertices: type_13;
@group(0) @binding(4) 
var<storage> materials: type_18;
var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_58;
@group(0) @binding(1) 
var<storage> nodes: type_63;
@group(0) @binding(2) 
var<storage> triangles: type_9;
@group(0) @binding(5) 
var<storage, read_write> samples: type_49;
@group(0) @binding(6) 
var<storage> instances: type_40;
@group(0) @binding(7) 
var<storage> alpha_texels: type_22;
@group(0) @binding(8) 
var<storage> color_texels: type_22;

fn lt_shaders_texture_unorm_bytes(param: u32) -> vec4<f32> {
    let _e78 = (1f / 255f);
    return vec4<f32>((f32((param & 255u)) * _e78), (f32(((param >> bitcast<u32>(8i)) & 255u)) * _e78), (f32(((param >> bitcast<u32>(16i)) & 255u)) * _e78), (f32((param >> bitcast<u32>(24i))) * _e78));
}

fn lt_shaders_surface_vertex_color(param_1: ptr<function, array<abi_Vertex, 3>>, param_2: vec3<f32>) -> vec4<f32> {
    let _e68 = (*param_1)[0u].color;
    let _e69 = lt_shaders_texture_unorm_bytes(_e68);
    let _e81 = (*param_1)[1u].color;
    let _e82 = lt_shaders_texture_unorm_bytes(_e81);
    let _e98 = (*param_1)[2u].color;
    let _e99 = lt_shaders_texture_unorm_bytes(_e98);
    return vec4<f32>((((_e69.x * param_2.x) + (_e82.x * param_2.y)) + (_e99.x * param_2.z)), (((_e69.y * param_2.x) + (_e82.y * param_2.y)) + (_e99.y * param_2.z)), (((_e69.z * param_2.x) + (_e82.z * param_2.y)) + (_e99.z * param_2.z)), (((_e69.w * param_2.x) + (_e82.w * param_2.y)) + (_e99.w * param_2.z)));
}

fn lt_shaders_surface_texture_coordinate(param_3: ptr<function, array<abi_Vertex, 3>>, param_4: vec3<f32>) -> vec2<f32> {
    let _e68 = (*param_3)[0u].u;
    let _e71 = (*param_3)[0u].v;
    let _e77 = (*param_3)[1u].u;
    let _e80 = (*param_3)[1u].v;
    let _e88 = (*param_3)[2u].u;
    let _e91 = (*param_3)[2u].v;
    return vec2<f32>((((_e68 * param_4.x) + (_e77 * param_4.y)) + (_e88 * param_4.z)), (((_e71 * param_4.x) + (_e80 * param_4.y)) + (_e91 * param_4.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_5: f32, param_6: u32) -> f32 {
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_497_: f32;
    var phi_498_: f32;

    if (param_6 == 0u) {
        phi_488_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e73 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e73 > 1f) {
                phi_486_ = (2f - _e73);
            } else {
                phi_486_ = _e73;
            }
            let _e77 = phi_486_;
            phi_487_ = _e77;
        } else {
            phi_487_ = param_5;
        }
        let _e79 = phi_487_;
        phi_488_ = _e79;
    }
    let _e81 = phi_488_;
    if (_e81 > 0f) {
        if (_e81 < 1f) {
            phi_497_ = _e81;
        } else {
            phi_497_ = 1f;
        }
        let _e85 = phi_497_;
        phi_498_ = _e85;
    } else {
        phi_498_ = 0f;
    }
    let _e87 = phi_498_;
    return _e87;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_424_: u32;
    var phi_438_: u32;
    var phi_445_: u32;
    var phi_450_: u32;
    var phi_456_: u32;
    var phi_461_: u32;
    var phi_463_: texture_Axis;

    let _e68 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e69 = (param_8 - 1u);
    let _e71 = (_e68 * f32(param_8));
    if param_10 {
        let _e78 = select(select(u32(_e71), 0u, (_e71 < bitcast<f32>(0u))), 4294967295u, (_e71 > bitcast<f32>(1333788671u)));
        if (_e69 < _e78) {
            phi_424_ = _e69;
        } else {
            phi_424_ = _e78;
        }
        let _e81 = phi_424_;
        phi_463_ = texture_Axis(_e81, _e81, 0f);
    } else {
        let _e83 = (_e71 + 0.5f);
        let _e90 = select(select(u32(_e83), 0u, (_e83 < bitcast<f32>(0u))), 4294967295u, (_e83 > bitcast<f32>(1333788671u)));
        if (param_8 < _e90) {
            phi_438_ = param_8;
        } else {
            phi_438_ = _e90;
        }
        let _e93 = phi_438_;
        if (param_9 == 0u) {
            phi_445_ = _e69;
        } else {
            phi_445_ = 0u;
        }
        let _e98 = phi_445_;
        if (param_9 == 0u) {
            phi_450_ = 0u;
        } else {
            phi_450_ = _e69;
        }
        let _e101 = phi_450_;
        if (_e93 == 0u) {
            phi_456_ = _e98;
        } else {
            phi_456_ = (_e93 - 1u);
        }
        let _e105 = phi_456_;
        if (_e93 > _e69) {
            phi_461_ = _e101;
        } else {
            phi_461_ = _e93;
        }
        let _e108 = phi_461_;
        phi_463_ = texture_Axis(_e105, _e108, (_e83 - f32(_e93)));
    }
    let _e111 = phi_463_;
    return _e111;
}

fn _lt_shaders_texture_TextureView_quad(param_11: ptr<function, texture_TextureView>, param_12: f32, param_13: f32) -> texture_TexelQuad {
    let _e68 = (*param_11).size;
    let _e69 = (_e68 & 65535u);
    let _e71 = (*param_11).size;
    let _e75 = (*param_11).flags;
    let _e77 = ((_e75 & 4u) != 0u);
    let _e79 = (*param_11).flags;
    let _e83 = lt_shaders_texture_axis(param_12, _e69, ((_e79 >> bitcast<u32>(4u)) & 3u), _e77);
    let _e85 = (*param_11).flags;
    let _e89 = lt_shaders_texture_axis(param_13, (_e71 >> bitcast<u32>(16i)), ((_e85 >> bitcast<u32>(6u)) & 3u), _e77);
    let _e93 = (*param_11).offset;
    let _e100 = (*param_11).offset;
    let _e107 = (*param_11).offset;
    let _e114 = (*param_11).offset;
    return texture_TexelQuad(array<u32, 4>(((_e93 + (_e89.low * _e69)) + _e83.low), ((_e100 + (_e89.low * _e69)) + _e83.high), ((_e107 + (_e89.high * _e69)) + _e83.low), ((_e114 + (_e89.high * _e69)) + _e83.high)), vec4<f32>(((1f - _e83.fraction) * (1f - _e89.fraction)), (_e83.fraction * (1f - _e89.fraction)), ((1f - _e83.fraction) * _e89.fraction), (_e83.fraction * _e89.fraction)));
}

fn lt_shaders_entry_pixel_index(param_14: vec3<u32>, param_15: u32, param_16: u32) -> lt_bvh_traverse_Tree {
    var phi_518_: lt_bvh_traverse_Tree;
    var phi_519_: bool;
    var phi_520_: lt_bvh_traverse_Tree;
    var phi_521_: bool;
    var phi_526_: lt_bvh_traverse_Tree;

    if (param_14.x < param_15) {
        if (param_14.y < param_16) {
            phi_518_ = lt_bvh_traverse_Tree(1u, ((param_14.y * param_15) + param_14.x));
            phi_519_ = false;
        } else {
            phi_518_ = lt_bvh_traverse_Tree();
            phi_519_ = true;
        }
        let _e77 = phi_518_;
        let _e79 = phi_519_;
        phi_520_ = _e77;
        phi_521_ = _e79;
    } else {
        phi_520_ = lt_bvh_traverse_Tree();
        phi_521_ = true;
    }
    let _e81 = phi_520_;
    let _e83 = phi_521_;
    if _e83 {
        phi_526_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_526_ = _e81;
    }
    let _e88 = phi_526_;
    return lt_bvh_traverse_Tree(_e88.root, _e88.first_primitive);
}

fn lt_shaders_shade_unit(param_17: f32) -> f32 {
    var phi_540_: f32;
    var phi_541_: f32;

    if (param_17 > 0f) {
        if (param_17 < 1f) {
            phi_540_ = param_17;
        } else {
            phi_540_ = 1f;
        }
        let _e68 = phi_540_;
        phi_541_ = _e68;
    } else {
        phi_541_ = 0f;
    }
    let _e70 = phi_541_;
    return _e70;
}

fn lt_shaders_shade_sqrt(param_18: f32) -> f32 {
    return sqrt(param_18);
}

fn lt_shaders_shade_pack_bytes(param_19: vec3<f32>) -> u32 {
    let _e67 = ((param_19.x * 255f) + 0.5f);
    let _e77 = ((param_19.y * 255f) + 0.5f);
    let _e90 = ((param_19.z * 255f) + 0.5f);
    return ((select(select(u32(_e67), 0u, (_e67 < bitcast<f32>(0u))), 4294967295u, (_e67 > bitcast<f32>(1333788671u))) | (select(select(u32(_e77), 0u, (_e77 < bitcast<f32>(0u))), 4294967295u, (_e77 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e90), 0u, (_e90 < bitcast<f32>(0u))), 4294967295u, (_e90 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i)));
}

fn _lt_bvh_ray_Ray_new(param_20: vec3<f32>, param_21: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_20, 0f, param_21, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_22: f32, param_23: f32) -> f32 {
    var phi_596_: bool;
    var phi_600_: f32;

    if (param_22 != param_22) {
        phi_596_ = true;
    } else {
        let _e67 = (param_23 >= param_22);
        if _e67 {
        }
        phi_596_ = _e67;
    }
    let _e69 = phi_596_;
    if _e69 {
        phi_600_ = param_23;
    } else {
        phi_600_ = param_22;
    }
    let _e71 = phi_600_;
    return _e71;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_24: f32, param_25: f32) -> f32 {
    var phi_612_: bool;
    var phi_616_: f32;

    if (param_24 != param_24) {
        phi_612_ = true;
    } else {
        let _e67 = (param_25 <= param_24);
        if _e67 {
        }
        phi_612_ = _e67;
    }
    let _e69 = phi_612_;
    if _e69 {
        phi_616_ = param_25;
    } else {
        phi_616_ = param_24;
    }
    let _e71 = phi_616_;
    return _e71;
}

fn lt_shaders_surface_barycentric_weights(param_26: f32, param_27: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_26) - param_27), param_26, param_27);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_28: f32, param_29: f32) -> f32 {
    var phi_630_: f32;

    if (param_28 > param_29) {
        phi_630_ = param_28;
    } else {
        phi_630_ = param_29;
    }
    let _e68 = phi_630_;
    return _e68;
}

fn lt_shaders_camera_facing(param_30: vec3<f32>, param_31: vec3<f32>) -> vec3<f32> {
    var phi_650_: vec3<f32>;

    if ((((param_30.x * param_31.x) + (param_30.y * param_31.y)) + (param_30.z * param_31.z)) < 0f) {
        phi_650_ = -(param_30);
    } else {
        phi_650_ = param_30;
    }
    let _e80 = phi_650_;
    return _e80;
}

fn lt_shaders_surface_plain_color(param_32: ptr<function, abi_Material>, param_33: ptr<function, array<abi_Vertex, 3>>, param_34: vec3<f32>) -> vec3<f32> {
    let _e68 = (*param_32).base_color;
    let _e72 = lt_shaders_surface_vertex_color(param_33, param_34);
    return vec3<f32>((_e68.x * _e72.x), (_e68.y * _e72.y), (_e68.z * _e72.z));
}

fn lt_shaders_surface_octahedral_decode(param_35: u32) -> vec3<f32> {
    var phi_690_: f32;
    var phi_697_: f32;
    var phi_704_: f32;

    let _e72 = (f32((bitcast<i32>((param_35 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e78 = (f32((bitcast<i32>(param_35) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e82 = ((1f - abs(_e72)) - abs(_e78));
    if (_e82 < 0f) {
        phi_690_ = -(_e82);
    } else {
        phi_690_ = 0f;
    }
    let _e86 = phi_690_;
    if (_e72 < 0f) {
        phi_697_ = (_e72 + _e86);
    } else {
        phi_697_ = (_e72 - _e86);
    }
    let _e91 = phi_697_;
    if (_e78 < 0f) {
        phi_704_ = (_e78 + _e86);
    } else {
        phi_704_ = (_e78 - _e86);
    }
    let _e96 = phi_704_;
    let _e103 = (1f / sqrt((((_e91 * _e91) + (_e96 * _e96)) + (_e82 * _e82))));
    return vec3<f32>((_e91 * _e103), (_e96 * _e103), (_e82 * _e103));
}

fn lt_shaders_shade_pack_albedo(param_36: vec3<f32>) -> u32 {
    let _e66 = lt_shaders_shade_unit(param_36.x);
    let _e67 = lt_shaders_shade_sqrt(_e66);
    let _e69 = lt_shaders_shade_unit(param_36.y);
    let _e70 = lt_shaders_shade_sqrt(_e69);
    let _e72 = lt_shaders_shade_unit(param_36.z);
    let _e73 = lt_shaders_shade_sqrt(_e72);
    let _e75 = lt_shaders_shade_pack_bytes(vec3<f32>(_e67, _e70, _e73));
    return _e75;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: abi_Material;
    var local_3: texture_TextureView;
    var local_4: array<abi_Vertex, 3>;
    var local_5: lt_bvh_traverse_Stack;
    var local_6: lt_bvh_traverse_Stack;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_919_: bool;
    var phi_923_: bool;
    var phi_998_: f32;
    var phi_1005_: f32;
    var phi_1013_: f32;
    var phi_1020_: f32;
    var phi_1028_: f32;
    var phi_1035_: f32;
    var phi_1060_: f32;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1092_: u32;
    var phi_1097_: u32;
    var phi_1102_: u32;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1248_: u32;
    var phi_1250_: u32;
    var phi_1253_: lt_bvh_Hit;
    var phi_1338_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1365_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1392_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1398_: u32;
    var phi_1401_: u32;
    var phi_1415_: u32;
    var phi_1425_: u32;
    var phi_1435_: u32;
    var phi_1453_: u32;
    var phi_1463_: u32;
    var phi_1473_: u32;
    var phi_1509_: u32;
    var phi_1522_: u32;
    var phi_1527_: u32;
    var phi_1528_: u32;
    var phi_1529_: u32;
    var phi_1399_: u32;
    var phi_1402_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_1587_: u32;
    var phi_1590_: lt_bvh_Hit;
    var phi_1645_: f32;
    var phi_1650_: f32;
    var phi_1655_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1673_: f32;
    var phi_1828_: bool;
    var phi_1829_: bool;
    var phi_1830_: bool;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1837_: bool;
    var phi_1838_: bool;
    var phi_1839_: bool;
    var phi_1840_: bool;
    var phi_1841_: bool;
    var phi_1842_: bool;
    var phi_1843_: bool;
    var phi_1844_: bool;
    var phi_1845_: bool;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1855_: bool;
    var phi_1859_: bool;
    var phi_1929_: f32;
    var phi_1936_: f32;
    var phi_1943_: f32;
    var phi_1950_: f32;
    var phi_1957_: f32;
    var phi_1964_: f32;
    var phi_1981_: f32;
    var phi_1986_: f32;
    var phi_1991_: f32;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2028_: u32;
    var phi_2029_: u32;
    var phi_2040_: vec3<f32>;
    var phi_2041_: vec3<f32>;
    var phi_2054_: u32;
    var phi_2059_: u32;
    var phi_2064_: u32;
    var phi_2178_: bool;
    var phi_2179_: bool;
    var phi_2210_: u32;
    var phi_2212_: lt_bvh_Hit;
    var phi_2215_: u32;
    var phi_2296_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2323_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2350_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2356_: u32;
    var phi_2359_: u32;
    var phi_2373_: u32;
    var phi_2383_: u32;
    var phi_2393_: u32;
    var phi_2411_: u32;
    var phi_2421_: u32;
    var phi_2431_: u32;
    var phi_2467_: u32;
    var phi_2480_: u32;
    var phi_2485_: u32;
    var phi_2486_: u32;
    var phi_2487_: u32;
    var phi_2357_: u32;
    var phi_2360_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_2545_: lt_bvh_Hit;
    var phi_2548_: u32;
    var phi_2592_: vec3<f32>;
    var phi_2593_: vec3<f32>;
    var phi_2624_: vec3<f32>;
    var phi_2625_: vec3<f32>;
    var phi_2656_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2677_: bool;
    var phi_2678_: bool;
    var phi_2682_: f32;
    var phi_2683_: f32;
    var phi_2684_: f32;
    var phi_2685_: f32;
    var phi_2693_: f32;
    var phi_2703_: bool;
    var phi_2704_: bool;
    var phi_2708_: f32;
    var phi_2709_: f32;
    var phi_2710_: f32;
    var phi_2711_: f32;
    var phi_2719_: f32;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var phi_2734_: f32;
    var phi_2735_: f32;
    var phi_2736_: f32;
    var phi_2737_: f32;
    var phi_2745_: f32;
    var phi_2760_: f32;
    var phi_2761_: bool;
    var phi_2762_: f32;
    var phi_2763_: bool;
    var phi_2764_: f32;
    var phi_2765_: bool;
    var phi_2783_: f32;
    var phi_2784_: bool;
    var phi_2785_: bool;
    var phi_2786_: f32;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2792_: bool;
    var phi_2793_: f32;
    var phi_2794_: bool;
    var phi_2820_: f32;
    var phi_2829_: f32;
    var phi_2838_: f32;
    var phi_2847_: f32;
    var phi_2854_: f32;
    var phi_2861_: f32;
    var phi_2874_: f32;
    var phi_2883_: f32;
    var phi_2892_: f32;
    var phi_2901_: f32;
    var phi_2908_: f32;
    var phi_2915_: f32;
    var phi_2932_: f32;
    var phi_2937_: f32;
    var phi_2942_: f32;
    var phi_2950_: f32;
    var phi_2955_: f32;
    var phi_2960_: f32;
    var phi_2972_: f32;
    var phi_2977_: f32;
    var phi_2982_: f32;
    var phi_2987_: f32;
    var phi_2992_: lt_bvh_triangle_Intersection;
    var phi_2993_: lt_bvh_triangle_Intersection;
    var phi_2994_: bool;
    var phi_2998_: lt_bvh_triangle_Intersection;
    var phi_3036_: bool;
    var phi_3037_: bool;
    var phi_3038_: bool;
    var phi_3039_: bool;
    var phi_3040_: bool;
    var phi_3041_: bool;
    var phi_3045_: bool;
    var phi_3046_: bool;
    var phi_3244_: f32;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3252_: bool;
    var phi_3260_: lt_bvh_Hit;
    var phi_3261_: lt_bvh_Hit;
    var phi_3262_: lt_bvh_Hit;
    var phi_3263_: lt_bvh_Hit;
    var phi_2546_: lt_bvh_Hit;
    var phi_2549_: u32;
    var phi_3264_: bool;
    var phi_3303_: bool;
    var phi_3304_: bool;
    var phi_3335_: u32;
    var phi_2213_: lt_bvh_Hit;
    var phi_2216_: u32;
    var phi_3336_: lt_bvh_Hit;
    var phi_3337_: lt_bvh_Hit;
    var phi_3338_: bool;
    var phi_3342_: lt_bvh_Hit;
    var phi_3343_: lt_bvh_Hit;
    var phi_3344_: lt_bvh_Hit;
    var phi_3345_: lt_bvh_Hit;
    var phi_1588_: u32;
    var phi_1591_: lt_bvh_Hit;
    var phi_3346_: bool;
    var phi_3385_: bool;
    var phi_3386_: bool;
    var phi_3417_: u32;
    var phi_1251_: u32;
    var phi_1254_: lt_bvh_Hit;
    var phi_3418_: lt_bvh_Hit;
    var phi_3419_: lt_bvh_Hit;
    var phi_3420_: bool;
    var phi_3424_: lt_bvh_Hit;
    var phi_3613_: f32;
    var phi_3618_: f32;
    var phi_3623_: f32;
    var phi_3631_: f32;
    var phi_3636_: f32;
    var phi_3641_: f32;
    var phi_3862_: vec3<f32>;
    var phi_3873_: u32;
    var phi_3972_: vec3<f32>;
    var phi_3973_: vec3<f32>;
    var phi_3977_: abi_Sample;
    var local_13: lt_bvh_Hit;
    var local_14: lt_bvh_Hit;
    var local_15: lt_bvh_Hit;
    var local_16: lt_bvh_Hit;

    let _e71 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e81 = arrayLength((&vertices.member));
    let _e84 = arrayLength((&materials.member));
    let _e90 = arrayLength((&instances.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e96 = arrayLength((&color_texels.member));
    let _e99 = p.member.size[0u];
    let _e101 = p.member.size[1u];
    let _e102 = lt_shaders_entry_pixel_index(_e71, _e99, _e101);
    if (bitcast<i32>(_e102.root) != 0i) {
        let _e108 = p.member.root;
        let _e112 = p.member.eye;
        let _e117 = p.member.size[0u];
        let _e121 = ((((f32(_e71.x) + 0.5f) / f32(_e117)) * 2f) - 1f);
        let _e126 = p.member.size[1u];
        let _e130 = (1f - (((f32(_e71.y) + 0.5f) / f32(_e126)) * 2f));
        let _e132 = p.member.forward;
        let _e134 = p.member.right;
        let _e148 = p.member.up;
        let _e159 = _lt_bvh_ray_Ray_new(_e112, vec3<f32>(((_e132.x + (_e134.x * _e121)) + (_e148.x * _e130)), ((_e132.y + (_e134.y * _e121)) + (_e148.y * _e130)), ((_e132.z + (_e134.z * _e121)) + (_e148.z * _e130))));
        let _e161 = lt_bvh_Hit(_e159.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e171 = abs(_e159.direction.x);
        let _e173 = abs(_e159.direction.y);
        let _e175 = abs(_e159.direction.z);
        if (abs(_e159.origin.x) < 1000000000000000f) {
            if (abs(_e159.origin.y) < 1000000000000000f) {
                if (abs(_e159.origin.z) < 1000000000000000f) {
                    if (_e171 < 1000000000000000f) {
                        if (_e173 < 1000000000000000f) {
                            if (_e175 < 1000000000000000f) {
                                if (_e171 > 0f) {
                                    phi_893_ = bool();
                                    phi_894_ = true;
                                } else {
                                    let _e183 = (_e173 > 0f);
                                    if _e183 {
                                        phi_892_ = bool();
                                    } else {
                                        phi_892_ = (_e175 > 0f);
                                    }
                                    let _e186 = phi_892_;
                                    phi_893_ = _e186;
                                    phi_894_ = _e183;
                                }
                                let _e188 = phi_893_;
                                let _e190 = phi_894_;
                                if _e190 {
                                    phi_898_ = true;
                                } else {
                                    phi_898_ = _e188;
                                }
                                let _e192 = phi_898_;
                                phi_899_ = _e192;
                                phi_900_ = false;
                            } else {
                                phi_899_ = bool();
                                phi_900_ = true;
                            }
                            let _e194 = phi_899_;
                            let _e196 = phi_900_;
                            phi_901_ = _e194;
                            phi_902_ = false;
                            phi_903_ = _e196;
                        } else {
                            phi_901_ = bool();
                            phi_902_ = true;
                            phi_903_ = false;
                        }
                        let _e198 = phi_901_;
                        let _e200 = phi_902_;
                        let _e202 = phi_903_;
                        phi_904_ = _e198;
                        phi_905_ = _e200;
                        phi_906_ = _e202;
                    } else {
                        phi_904_ = bool();
                        phi_905_ = true;
                        phi_906_ = false;
                    }
                    let _e204 = phi_904_;
                    let _e206 = phi_905_;
                    let _e208 = phi_906_;
                    phi_907_ = _e204;
                    phi_908_ = _e206;
                    phi_909_ = _e208;
                } else {
                    phi_907_ = bool();
                    phi_908_ = true;
                    phi_909_ = false;
                }
                let _e210 = phi_907_;
                let _e212 = phi_908_;
                let _e214 = phi_909_;
                phi_910_ = _e210;
                phi_911_ = _e212;
                phi_912_ = _e214;
            } else {
                phi_910_ = bool();
                phi_911_ = true;
                phi_912_ = false;
            }
            let _e216 = phi_910_;
            let _e218 = phi_911_;
            let _e220 = phi_912_;
            phi_913_ = _e216;
            phi_914_ = _e218;
            phi_915_ = _e220;
        } else {
            phi_913_ = bool();
            phi_914_ = true;
            phi_915_ = false;
        }
        let _e222 = phi_913_;
        let _e224 = phi_914_;
        let _e226 = phi_915_;
        if _e224 {
            phi_919_ = true;
        } else {
            phi_919_ = _e226;
        }
        let _e228 = phi_919_;
        if _e228 {
            phi_923_ = false;
        } else {
            phi_923_ = _e222;
        }
        let _e230 = phi_923_;
        if _e230 {
            let _e231 = (_e108 >= _e75);
            if _e231 {
                phi_3418_ = lt_bvh_Hit();
            } else {
                if (_e108 < _e75) {
                } else {
                    return;
                }
                let _e237 = nodes.member[(0u + _e108)].frame[0u];
                let _e241 = nodes.member[(0u + _e108)].frame[1u];
                let _e245 = nodes.member[(0u + _e108)].frame[2u];
                let _e249 = nodes.member[(0u + _e108)].frame[0u];
                let _e253 = nodes.member[(0u + _e108)].frame[1u];
                let _e257 = nodes.member[(0u + _e108)].frame[2u];
                let _e261 = nodes.member[(0u + _e108)].frame[3u];
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(abs(_e159.direction.x), abs(_e159.direction.y));
                let _e300 = core_intrinsics_maximum_number_nsz_f32_(_e299, abs(_e159.direction.z));
                let _e301 = (_e300 * 0.0000000000009094947f);
                if (abs(_e159.direction.x) < _e301) {
                    phi_998_ = _e301;
                } else {
                    phi_998_ = abs(_e159.direction.x);
                }
                let _e308 = phi_998_;
                if (_e159.direction.x < 0f) {
                    phi_1005_ = (-1f / _e308);
                } else {
                    phi_1005_ = (1f / _e308);
                }
                let _e313 = phi_1005_;
                if (abs(_e159.direction.y) < _e301) {
                    phi_1013_ = _e301;
                } else {
                    phi_1013_ = abs(_e159.direction.y);
                }
                let _e320 = phi_1013_;
                if (_e159.direction.y < 0f) {
                    phi_1020_ = (-1f / _e320);
                } else {
                    phi_1020_ = (1f / _e320);
                }
                let _e325 = phi_1020_;
                if (abs(_e159.direction.z) < _e301) {
                    phi_1028_ = _e301;
                } else {
                    phi_1028_ = abs(_e159.direction.z);
                }
                let _e332 = phi_1028_;
                if (_e159.direction.z < 0f) {
                    phi_1035_ = (-1f / _e332);
                } else {
                    phi_1035_ = (1f / _e332);
                }
                let _e337 = phi_1035_;
                let _e345 = abs((bitcast<f32>(_e237) - _e159.origin.x));
                let _e346 = abs((bitcast<f32>(_e241) - _e159.origin.y));
                let _e347 = abs((bitcast<f32>(_e245) - _e159.origin.z));
                let _e355 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e261 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.x));
                let _e356 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e261 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.y));
                let _e357 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e261 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.z));
                if (_e345 > _e355) {
                    phi_1060_ = _e345;
                } else {
                    phi_1060_ = _e355;
                }
                let _e360 = phi_1060_;
                if (_e346 > _e356) {
                    phi_1065_ = _e346;
                } else {
                    phi_1065_ = _e356;
                }
                let _e363 = phi_1065_;
                if (_e347 > _e357) {
                    phi_1070_ = _e347;
                } else {
                    phi_1070_ = _e357;
                }
                let _e366 = phi_1070_;
                let _e367 = core_intrinsics_maximum_number_nsz_f32_(_e360, _e363);
                let _e368 = core_intrinsics_maximum_number_nsz_f32_(_e367, _e366);
                let _e373 = (_e368 * 0.0000019073486f);
                let _e374 = (abs(_e313) * _e373);
                let _e375 = (abs(_e325) * _e373);
                let _e376 = (abs(_e337) * _e373);
                let _e380 = (_e368 * 0.0000009536743f);
                let _e381 = (abs(_e313) * _e380);
                let _e382 = (abs(_e325) * _e380);
                let _e383 = (abs(_e337) * _e380);
                if (_e313 < 0f) {
                    phi_1092_ = 0u;
                } else {
                    phi_1092_ = 1u;
                }
                let _e386 = phi_1092_;
                if (_e325 < 0f) {
                    phi_1097_ = 0u;
                } else {
                    phi_1097_ = 2u;
                }
                let _e389 = phi_1097_;
                if (_e337 < 0f) {
                    phi_1102_ = 0u;
                } else {
                    phi_1102_ = 4u;
                }
                let _e392 = phi_1102_;
                let _e394 = ((_e386 | _e389) | _e392);
                let _e395 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e108, 2147483648u);
                local_6 = lt_bvh_traverse_Stack(array<u32, 32>(_e395.first[0], _e395.first[1], _e395.first[2], _e395.first[3], _e395.first[4], _e395.first[5], _e395.first[6], _e395.first[7], _e395.first[8], _e395.first[9], _e395.first[10], _e395.first[11], _e395.first[12], _e395.first[13], _e395.first[14], _e395.first[15], _e395.first[16], _e395.first[17], _e395.first[18], _e395.first[19], _e395.first[20], _e395.first[21], _e395.first[22], _e395.first[23], _e395.first[24], _e395.first[25], _e395.first[26], _e395.first[27], _e395.first[28], _e395.first[29], _e395.first[30], _e395.first[31]), array<u32, 32>(_e395.mask[0], _e395.mask[1], _e395.mask[2], _e395.mask[3], _e395.mask[4], _e395.mask[5], _e395.mask[6], _e395.mask[7], _e395.mask[8], _e395.mask[9], _e395.mask[10], _e395.mask[11], _e395.mask[12], _e395.mask[13], _e395.mask[14], _e395.mask[15], _e395.mask[16], _e395.mask[17], _e395.mask[18], _e395.mask[19], _e395.mask[20], _e395.mask[21], _e395.mask[22], _e395.mask[23], _e395.mask[24], _e395.mask[25], _e395.mask[26], _e395.mask[27], _e395.mask[28], _e395.mask[29], _e395.mask[30], _e395.mask[31]), _e395.len, _e395.group, _e395.group_mask);
                let _e469 = local_6.group_mask;
                if ((_e469 & 4278190080u) == 0u) {
                    let _e473 = local_6.len;
                    if (_e473 == 0u) {
                        phi_1216_ = false;
                    } else {
                        let _e477 = local_6.len;
                        local_6.len = (_e477 - 1u);
                        let _e480 = local_6.len;
                        if (_e480 < 32u) {
                        } else {
                            return;
                        }
                        let _e485 = local_6.first[(0u + _e480)];
                        local_6.group = _e485;
                        let _e488 = local_6.len;
                        if (_e488 < 32u) {
                        } else {
                            return;
                        }
                        let _e493 = local_6.mask[(0u + _e488)];
                        local_6.group_mask = _e493;
                        phi_1216_ = true;
                    }
                    let _e496 = phi_1216_;
                    phi_1217_ = _e496;
                } else {
                    phi_1217_ = true;
                }
                let _e498 = phi_1217_;
                if _e498 {
                    let _e500 = local_6.group_mask;
                    let _e506 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e500)), 32u, (_e500 == 0u)));
                    let _e510 = local_6.group_mask;
                    let _e524 = local_6.group_mask;
                    local_6.group_mask = (_e524 & ~((1u << bitcast<u32>((_e506 & 31u)))));
                    let _e527 = local_6.group;
                    phi_1248_ = (_e527 + countOneBits(((_e510 & ~((4294967295u << bitcast<u32>((((_e506 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1248_ = 4294967295u;
                }
                let _e530 = phi_1248_;
                phi_1250_ = _e530;
                phi_1253_ = _e161;
                loop {
                    let _e532 = phi_1250_;
                    let _e534 = phi_1253_;
                    local_16 = _e534;
                    let _e535 = (_e532 != 4294967295u);
                    if _e535 {
                        if (_e532 < _e75) {
                        } else {
                            return;
                        }
                        let _e543 = nodes.member[(0u + _e532)].frame[3u];
                        let _e568 = (bitcast<f32>((((_e543 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e569 = (bitcast<f32>((((_e543 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e570 = (bitcast<f32>((((_e543 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e573 = nodes.member[(0u + _e532)].frame[0u];
                        let _e577 = nodes.member[(0u + _e532)].frame[1u];
                        let _e581 = nodes.member[(0u + _e532)].frame[2u];
                        let _e589 = ((bitcast<f32>(_e573) - _e159.origin.x) * _e313);
                        let _e590 = ((bitcast<f32>(_e577) - _e159.origin.y) * _e325);
                        let _e591 = ((bitcast<f32>(_e581) - _e159.origin.z) * _e337);
                        let _e599 = nodes.member[(0u + _e532)].x;
                        if (_e313 < 0f) {
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e610.unnamed.root, _e599.w), _e610.unnamed_1);
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e616.unnamed, lt_bvh_traverse_Tree(_e599.x, _e616.unnamed_1.first_primitive));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e622.unnamed, lt_bvh_traverse_Tree(_e622.unnamed_1.root, _e599.y));
                        } else {
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e638.unnamed.root, _e599.y), _e638.unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e599.z, _e644.unnamed_1.first_primitive));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e650.unnamed_1.root, _e599.w));
                        }
                        let _e658 = phi_1338_;
                        let _e668 = nodes.member[(0u + _e532)].y;
                        if (_e325 < 0f) {
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.unnamed.root, _e668.w), _e679.unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_bvh_traverse_Tree(_e668.x, _e685.unnamed_1.first_primitive));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e691.unnamed_1.root, _e668.y));
                        } else {
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e707.unnamed.root, _e668.y), _e707.unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e668.z, _e713.unnamed_1.first_primitive));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e719.unnamed_1.root, _e668.w));
                        }
                        let _e727 = phi_1365_;
                        let _e737 = nodes.member[(0u + _e532)].z;
                        if (_e337 < 0f) {
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e748.unnamed.root, _e737.w), _e748.unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_bvh_traverse_Tree(_e737.x, _e754.unnamed_1.first_primitive));
                            phi_1392_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_bvh_traverse_Tree(_e760.unnamed_1.root, _e737.y));
                        } else {
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e776.unnamed.root, _e737.y), _e776.unnamed_1);
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_bvh_traverse_Tree(_e737.z, _e782.unnamed_1.first_primitive));
                            phi_1392_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e788.unnamed, lt_bvh_traverse_Tree(_e788.unnamed_1.root, _e737.w));
                        }
                        let _e796 = phi_1392_;
                        phi_1398_ = 0u;
                        phi_1401_ = 0u;
                        loop {
                            let _e806 = phi_1398_;
                            let _e808 = phi_1401_;
                            local_7 = _e808;
                            local_8 = _e808;
                            local_9 = _e808;
                            let _e809 = (_e806 < 8u);
                            if _e809 {
                                let _e811 = (_e806 >> bitcast<u32>(2i));
                                let _e812 = (_e806 & 3u);
                                if (_e811 == 0u) {
                                    phi_1415_ = _e658.unnamed.root;
                                } else {
                                    phi_1415_ = _e658.unnamed.first_primitive;
                                }
                                let _e815 = phi_1415_;
                                if (_e811 == 0u) {
                                    phi_1425_ = _e727.unnamed.root;
                                } else {
                                    phi_1425_ = _e727.unnamed.first_primitive;
                                }
                                let _e824 = phi_1425_;
                                if (_e811 == 0u) {
                                    phi_1435_ = _e796.unnamed.root;
                                } else {
                                    phi_1435_ = _e796.unnamed.first_primitive;
                                }
                                let _e833 = phi_1435_;
                                let _e846 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e815 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e568) + (_e589 - _e374)), ((f32(((_e824 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e569) + (_e590 - _e375)));
                                let _e847 = core_intrinsics_maximum_number_nsz_f32_(_e846, ((f32(((_e833 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e570) + (_e591 - _e376)));
                                if (_e811 == 0u) {
                                    phi_1453_ = _e658.unnamed_1.root;
                                } else {
                                    phi_1453_ = _e658.unnamed_1.first_primitive;
                                }
                                let _e850 = phi_1453_;
                                if (_e811 == 0u) {
                                    phi_1463_ = _e727.unnamed_1.root;
                                } else {
                                    phi_1463_ = _e727.unnamed_1.first_primitive;
                                }
                                let _e859 = phi_1463_;
                                if (_e811 == 0u) {
                                    phi_1473_ = _e796.unnamed_1.root;
                                } else {
                                    phi_1473_ = _e796.unnamed_1.first_primitive;
                                }
                                let _e868 = phi_1473_;
                                let _e881 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e850 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e568) + (_e589 + _e374)), ((f32(((_e859 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e569) + (_e590 + _e375)));
                                let _e882 = core_intrinsics_minimum_number_nsz_f32_(_e881, ((f32(((_e868 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e570) + (_e591 + _e376)));
                                if (_e847 <= _e882) {
                                    if (_e847 <= _e534.t) {
                                        if (_e882 >= _e159.tmin) {
                                            if (_e811 == 0u) {
                                                let _e889 = nodes.member[(0u + _e532)].links[2u];
                                                phi_1509_ = _e889;
                                            } else {
                                                let _e892 = nodes.member[(0u + _e532)].links[3u];
                                                phi_1509_ = _e892;
                                            }
                                            let _e894 = phi_1509_;
                                            let _e899 = ((_e894 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u);
                                            let _e900 = (_e899 & 31u);
                                            if (_e900 >= 24u) {
                                                phi_1522_ = (24u + ((_e900 - 24u) ^ _e394));
                                            } else {
                                                phi_1522_ = _e900;
                                            }
                                            let _e906 = phi_1522_;
                                            phi_1527_ = (_e808 | ((_e899 >> bitcast<u32>(5i)) << bitcast<u32>((_e906 & 31u))));
                                        } else {
                                            phi_1527_ = _e808;
                                        }
                                        let _e914 = phi_1527_;
                                        phi_1528_ = _e914;
                                    } else {
                                        phi_1528_ = _e808;
                                    }
                                    let _e916 = phi_1528_;
                                    phi_1529_ = _e916;
                                } else {
                                    phi_1529_ = _e808;
                                }
                                let _e918 = phi_1529_;
                                phi_1399_ = (_e806 + 1u);
                                phi_1402_ = _e918;
                            } else {
                                phi_1399_ = u32();
                                phi_1402_ = u32();
                            }
                            let _e921 = phi_1399_;
                            let _e923 = phi_1402_;
                            continue;
                            continuing {
                                phi_1398_ = _e921;
                                phi_1401_ = _e923;
                                break if !(_e809);
                            }
                        }
                        let _e927 = nodes.member[(0u + _e532)].links[0u];
                        let _e931 = nodes.member[(0u + _e532)].frame[3u];
                        let _e935 = local_7;
                        if ((_e935 & 4278190080u) == 0u) {
                        } else {
                            let _e939 = local_6.group_mask;
                            if ((_e939 & 4278190080u) == 0u) {
                            } else {
                                let _e943 = local_6.len;
                                if (_e943 < 32u) {
                                    let _e946 = local_6.group;
                                    let _e948 = local_6.len;
                                    if (_e948 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_6.first[(0u + _e948)] = _e946;
                                    let _e954 = local_6.group_mask;
                                    let _e956 = local_6.len;
                                    if (_e956 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_6.mask[(0u + _e956)] = _e954;
                                    let _e963 = local_6.len;
                                    local_6.len = (_e963 + 1u);
                                }
                            }
                            local_6.group = (_e108 + _e927);
                            let _e967 = local_8;
                            local_6.group_mask = ((_e967 & 4278190080u) | (_e931 >> bitcast<u32>(24i)));
                        }
                        let _e972 = local_9;
                        phi_1587_ = (_e972 & 16777215u);
                        phi_1590_ = _e534;
                        loop {
                            let _e975 = phi_1587_;
                            let _e977 = phi_1590_;
                            local_15 = _e977;
                            if (_e975 == 0u) {
                                phi_1588_ = u32();
                                phi_1591_ = lt_bvh_Hit();
                                phi_3346_ = false;
                            } else {
                                let _e981 = nodes.member[(0u + _e532)].links[1u];
                                let _e985 = (_e981 + select(firstTrailingBit(_e975), 32u, (_e975 == 0u)));
                                if (_e985 < _e90) {
                                } else {
                                    return;
                                }
                                let _e992 = instances.member[(0u + _e985)].low_world;
                                let _e994 = instances.member[(0u + _e985)].high_world;
                                let _e1004 = ((_e992.x - _e159.origin.x) * _e313);
                                let _e1005 = ((_e992.y - _e159.origin.y) * _e325);
                                let _e1006 = ((_e992.z - _e159.origin.z) * _e337);
                                let _e1016 = ((_e994.x - _e159.origin.x) * _e313);
                                let _e1017 = ((_e994.y - _e159.origin.y) * _e325);
                                let _e1018 = ((_e994.z - _e159.origin.z) * _e337);
                                if (_e1004 < _e1016) {
                                    phi_1645_ = _e1004;
                                } else {
                                    phi_1645_ = _e1016;
                                }
                                let _e1021 = phi_1645_;
                                if (_e1005 < _e1017) {
                                    phi_1650_ = _e1005;
                                } else {
                                    phi_1650_ = _e1017;
                                }
                                let _e1024 = phi_1650_;
                                if (_e1006 < _e1018) {
                                    phi_1655_ = _e1006;
                                } else {
                                    phi_1655_ = _e1018;
                                }
                                let _e1027 = phi_1655_;
                                if (_e1004 > _e1016) {
                                    phi_1663_ = _e1004;
                                } else {
                                    phi_1663_ = _e1016;
                                }
                                let _e1033 = phi_1663_;
                                if (_e1005 > _e1017) {
                                    phi_1668_ = _e1005;
                                } else {
                                    phi_1668_ = _e1017;
                                }
                                let _e1036 = phi_1668_;
                                if (_e1006 > _e1018) {
                                    phi_1673_ = _e1006;
                                } else {
                                    phi_1673_ = _e1018;
                                }
                                let _e1039 = phi_1673_;
                                let _e1043 = core_intrinsics_maximum_number_nsz_f32_((_e1021 - _e381), (_e1024 - _e382));
                                let _e1044 = core_intrinsics_maximum_number_nsz_f32_(_e1043, (_e1027 - _e383));
                                let _e1045 = core_intrinsics_minimum_number_nsz_f32_((_e1033 + _e381), (_e1036 + _e382));
                                let _e1046 = core_intrinsics_minimum_number_nsz_f32_(_e1045, (_e1039 + _e383));
                                if (_e1044 <= _e1046) {
                                    if (_e1044 <= _e977.t) {
                                        if (_e1046 >= _e159.tmin) {
                                            let _e1058 = instances.member[(0u + _e985)].world_to_object[0u];
                                            let _e1069 = ((((_e1058.x * _e159.origin.x) + (_e1058.y * _e159.origin.y)) + (_e1058.z * _e159.origin.z)) + (_e1058.w * 1f));
                                            let _e1071 = instances.member[(0u + _e985)].world_to_object[1u];
                                            let _e1082 = ((((_e1071.x * _e159.origin.x) + (_e1071.y * _e159.origin.y)) + (_e1071.z * _e159.origin.z)) + (_e1071.w * 1f));
                                            let _e1084 = instances.member[(0u + _e985)].world_to_object[2u];
                                            let _e1095 = ((((_e1084.x * _e159.origin.x) + (_e1084.y * _e159.origin.y)) + (_e1084.z * _e159.origin.z)) + (_e1084.w * 1f));
                                            let _e1102 = instances.member[(0u + _e985)].world_to_object[0u];
                                            let _e1113 = ((((_e1102.x * _e159.direction.x) + (_e1102.y * _e159.direction.y)) + (_e1102.z * _e159.direction.z)) + (_e1102.w * 0f));
                                            let _e1115 = instances.member[(0u + _e985)].world_to_object[1u];
                                            let _e1126 = ((((_e1115.x * _e159.direction.x) + (_e1115.y * _e159.direction.y)) + (_e1115.z * _e159.direction.z)) + (_e1115.w * 0f));
                                            let _e1128 = instances.member[(0u + _e985)].world_to_object[2u];
                                            let _e1139 = ((((_e1128.x * _e159.direction.x) + (_e1128.y * _e159.direction.y)) + (_e1128.z * _e159.direction.z)) + (_e1128.w * 0f));
                                            let _e1143 = instances.member[(0u + _e985)].root;
                                            let _e1145 = instances.member[(0u + _e985)].first_triangle;
                                            let _e1149 = abs(_e1113);
                                            let _e1150 = abs(_e1126);
                                            let _e1151 = abs(_e1139);
                                            if (abs(_e1069) < 1000000000000000f) {
                                                if (abs(_e1082) < 1000000000000000f) {
                                                    if (abs(_e1095) < 1000000000000000f) {
                                                        if (_e1149 < 1000000000000000f) {
                                                            if (_e1150 < 1000000000000000f) {
                                                                if (_e1151 < 1000000000000000f) {
                                                                    if (_e1149 > 0f) {
                                                                        phi_1829_ = bool();
                                                                        phi_1830_ = true;
                                                                    } else {
                                                                        let _e1159 = (_e1150 > 0f);
                                                                        if _e1159 {
                                                                            phi_1828_ = bool();
                                                                        } else {
                                                                            phi_1828_ = (_e1151 > 0f);
                                                                        }
                                                                        let _e1162 = phi_1828_;
                                                                        phi_1829_ = _e1162;
                                                                        phi_1830_ = _e1159;
                                                                    }
                                                                    let _e1164 = phi_1829_;
                                                                    let _e1166 = phi_1830_;
                                                                    if _e1166 {
                                                                        phi_1834_ = true;
                                                                    } else {
                                                                        phi_1834_ = _e1164;
                                                                    }
                                                                    let _e1168 = phi_1834_;
                                                                    phi_1835_ = _e1168;
                                                                    phi_1836_ = false;
                                                                } else {
                                                                    phi_1835_ = bool();
                                                                    phi_1836_ = true;
                                                                }
                                                                let _e1170 = phi_1835_;
                                                                let _e1172 = phi_1836_;
                                                                phi_1837_ = _e1170;
                                                                phi_1838_ = false;
                                                                phi_1839_ = _e1172;
                                                            } else {
                                                                phi_1837_ = bool();
                                                                phi_1838_ = true;
                                                                phi_1839_ = false;
                                                            }
                                                            let _e1174 = phi_1837_;
                                                            let _e1176 = phi_1838_;
                                                            let _e1178 = phi_1839_;
                                                            phi_1840_ = _e1174;
                                                            phi_1841_ = _e1176;
                                                            phi_1842_ = _e1178;
                                                        } else {
                                                            phi_1840_ = bool();
                                                            phi_1841_ = true;
                                                            phi_1842_ = false;
                                                        }
                                                        let _e1180 = phi_1840_;
                                                        let _e1182 = phi_1841_;
                                                        let _e1184 = phi_1842_;
                                                        phi_1843_ = _e1180;
                                                        phi_1844_ = _e1182;
                                                        phi_1845_ = _e1184;
                                                    } else {
                                                        phi_1843_ = bool();
                                                        phi_1844_ = true;
                                                        phi_1845_ = false;
                                                    }
                                                    let _e1186 = phi_1843_;
                                                    let _e1188 = phi_1844_;
                                                    let _e1190 = phi_1845_;
                                                    phi_1846_ = _e1186;
                                                    phi_1847_ = _e1188;
                                                    phi_1848_ = _e1190;
                                                } else {
                                                    phi_1846_ = bool();
                                                    phi_1847_ = true;
                                                    phi_1848_ = false;
                                                }
                                                let _e1192 = phi_1846_;
                                                let _e1194 = phi_1847_;
                                                let _e1196 = phi_1848_;
                                                phi_1849_ = _e1192;
                                                phi_1850_ = _e1194;
                                                phi_1851_ = _e1196;
                                            } else {
                                                phi_1849_ = bool();
                                                phi_1850_ = true;
                                                phi_1851_ = false;
                                            }
                                            let _e1198 = phi_1849_;
                                            let _e1200 = phi_1850_;
                                            let _e1202 = phi_1851_;
                                            if _e1200 {
                                                phi_1855_ = true;
                                            } else {
                                                phi_1855_ = _e1202;
                                            }
                                            let _e1204 = phi_1855_;
                                            if _e1204 {
                                                phi_1859_ = false;
                                            } else {
                                                phi_1859_ = _e1198;
                                            }
                                            let _e1206 = phi_1859_;
                                            if _e1206 {
                                                let _e1207 = (_e1143 >= _e75);
                                                if _e1207 {
                                                    phi_3336_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1143 < _e75) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1213 = nodes.member[(0u + _e1143)].frame[0u];
                                                    let _e1217 = nodes.member[(0u + _e1143)].frame[1u];
                                                    let _e1221 = nodes.member[(0u + _e1143)].frame[2u];
                                                    let _e1225 = nodes.member[(0u + _e1143)].frame[0u];
                                                    let _e1229 = nodes.member[(0u + _e1143)].frame[1u];
                                                    let _e1233 = nodes.member[(0u + _e1143)].frame[2u];
                                                    let _e1237 = nodes.member[(0u + _e1143)].frame[3u];
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1113), abs(_e1126));
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(_e1271, abs(_e1139));
                                                    let _e1273 = (_e1272 * 0.0000000000009094947f);
                                                    if (abs(_e1113) < _e1273) {
                                                        phi_1929_ = _e1273;
                                                    } else {
                                                        phi_1929_ = abs(_e1113);
                                                    }
                                                    let _e1278 = phi_1929_;
                                                    if (_e1113 < 0f) {
                                                        phi_1936_ = (-1f / _e1278);
                                                    } else {
                                                        phi_1936_ = (1f / _e1278);
                                                    }
                                                    let _e1283 = phi_1936_;
                                                    if (abs(_e1126) < _e1273) {
                                                        phi_1943_ = _e1273;
                                                    } else {
                                                        phi_1943_ = abs(_e1126);
                                                    }
                                                    let _e1288 = phi_1943_;
                                                    if (_e1126 < 0f) {
                                                        phi_1950_ = (-1f / _e1288);
                                                    } else {
                                                        phi_1950_ = (1f / _e1288);
                                                    }
                                                    let _e1293 = phi_1950_;
                                                    if (abs(_e1139) < _e1273) {
                                                        phi_1957_ = _e1273;
                                                    } else {
                                                        phi_1957_ = abs(_e1139);
                                                    }
                                                    let _e1298 = phi_1957_;
                                                    if (_e1139 < 0f) {
                                                        phi_1964_ = (-1f / _e1298);
                                                    } else {
                                                        phi_1964_ = (1f / _e1298);
                                                    }
                                                    let _e1303 = phi_1964_;
                                                    let _e1307 = abs((bitcast<f32>(_e1213) - _e1069));
                                                    let _e1308 = abs((bitcast<f32>(_e1217) - _e1082));
                                                    let _e1309 = abs((bitcast<f32>(_e1221) - _e1095));
                                                    let _e1313 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1069));
                                                    let _e1314 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1082));
                                                    let _e1315 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1095));
                                                    if (_e1307 > _e1313) {
                                                        phi_1981_ = _e1307;
                                                    } else {
                                                        phi_1981_ = _e1313;
                                                    }
                                                    let _e1318 = phi_1981_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1986_ = _e1308;
                                                    } else {
                                                        phi_1986_ = _e1314;
                                                    }
                                                    let _e1321 = phi_1986_;
                                                    if (_e1309 > _e1315) {
                                                        phi_1991_ = _e1309;
                                                    } else {
                                                        phi_1991_ = _e1315;
                                                    }
                                                    let _e1324 = phi_1991_;
                                                    let _e1325 = core_intrinsics_maximum_number_nsz_f32_(_e1318, _e1321);
                                                    let _e1326 = core_intrinsics_maximum_number_nsz_f32_(_e1325, _e1324);
                                                    let _e1330 = (_e1326 * 0.0000019073486f);
                                                    let _e1331 = (abs(_e1283) * _e1330);
                                                    let _e1332 = (abs(_e1293) * _e1330);
                                                    let _e1333 = (abs(_e1303) * _e1330);
                                                    let _e1337 = (_e1326 * 0.0000009536743f);
                                                    let _e1338 = (abs(_e1283) * _e1337);
                                                    let _e1339 = (abs(_e1293) * _e1337);
                                                    let _e1340 = (abs(_e1303) * _e1337);
                                                    let _e1341 = abs(_e1113);
                                                    let _e1342 = abs(_e1126);
                                                    let _e1343 = abs(_e1139);
                                                    if (_e1341 >= _e1342) {
                                                        if (_e1341 >= _e1343) {
                                                            phi_2019_ = false;
                                                        } else {
                                                            phi_2019_ = true;
                                                        }
                                                        let _e1347 = phi_2019_;
                                                        phi_2020_ = _e1347;
                                                    } else {
                                                        phi_2020_ = true;
                                                    }
                                                    let _e1349 = phi_2020_;
                                                    if _e1349 {
                                                        if (_e1342 >= _e1343) {
                                                            phi_2028_ = 1u;
                                                        } else {
                                                            phi_2028_ = 2u;
                                                        }
                                                        let _e1352 = phi_2028_;
                                                        phi_2029_ = _e1352;
                                                    } else {
                                                        phi_2029_ = 0u;
                                                    }
                                                    let _e1354 = phi_2029_;
                                                    if (_e1354 == 0u) {
                                                        phi_2041_ = vec3<f32>(_e1126, _e1139, _e1113);
                                                    } else {
                                                        if (_e1354 == 1u) {
                                                            phi_2040_ = vec3<f32>(_e1139, _e1113, _e1126);
                                                        } else {
                                                            phi_2040_ = vec3<f32>(_e1113, _e1126, _e1139);
                                                        }
                                                        let _e1360 = phi_2040_;
                                                        phi_2041_ = _e1360;
                                                    }
                                                    let _e1362 = phi_2041_;
                                                    let _e1365 = (_e1362.x / _e1362.z);
                                                    let _e1368 = (_e1362.y / _e1362.z);
                                                    let _e1370 = (1f / _e1362.z);
                                                    if (_e1283 < 0f) {
                                                        phi_2054_ = 0u;
                                                    } else {
                                                        phi_2054_ = 1u;
                                                    }
                                                    let _e1373 = phi_2054_;
                                                    if (_e1293 < 0f) {
                                                        phi_2059_ = 0u;
                                                    } else {
                                                        phi_2059_ = 2u;
                                                    }
                                                    let _e1376 = phi_2059_;
                                                    if (_e1303 < 0f) {
                                                        phi_2064_ = 0u;
                                                    } else {
                                                        phi_2064_ = 4u;
                                                    }
                                                    let _e1379 = phi_2064_;
                                                    let _e1381 = ((_e1373 | _e1376) | _e1379);
                                                    let _e1382 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1143, 2147483648u);
                                                    local_5 = lt_bvh_traverse_Stack(array<u32, 32>(_e1382.first[0], _e1382.first[1], _e1382.first[2], _e1382.first[3], _e1382.first[4], _e1382.first[5], _e1382.first[6], _e1382.first[7], _e1382.first[8], _e1382.first[9], _e1382.first[10], _e1382.first[11], _e1382.first[12], _e1382.first[13], _e1382.first[14], _e1382.first[15], _e1382.first[16], _e1382.first[17], _e1382.first[18], _e1382.first[19], _e1382.first[20], _e1382.first[21], _e1382.first[22], _e1382.first[23], _e1382.first[24], _e1382.first[25], _e1382.first[26], _e1382.first[27], _e1382.first[28], _e1382.first[29], _e1382.first[30], _e1382.first[31]), array<u32, 32>(_e1382.mask[0], _e1382.mask[1], _e1382.mask[2], _e1382.mask[3], _e1382.mask[4], _e1382.mask[5], _e1382.mask[6], _e1382.mask[7], _e1382.mask[8], _e1382.mask[9], _e1382.mask[10], _e1382.mask[11], _e1382.mask[12], _e1382.mask[13], _e1382.mask[14], _e1382.mask[15], _e1382.mask[16], _e1382.mask[17], _e1382.mask[18], _e1382.mask[19], _e1382.mask[20], _e1382.mask[21], _e1382.mask[22], _e1382.mask[23], _e1382.mask[24], _e1382.mask[25], _e1382.mask[26], _e1382.mask[27], _e1382.mask[28], _e1382.mask[29], _e1382.mask[30], _e1382.mask[31]), _e1382.len, _e1382.group, _e1382.group_mask);
                                                    let _e1456 = local_5.group_mask;
                                                    if ((_e1456 & 4278190080u) == 0u) {
                                                        let _e1460 = local_5.len;
                                                        if (_e1460 == 0u) {
                                                            phi_2178_ = false;
                                                        } else {
                                                            let _e1464 = local_5.len;
                                                            local_5.len = (_e1464 - 1u);
                                                            let _e1467 = local_5.len;
                                                            if (_e1467 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1472 = local_5.first[(0u + _e1467)];
                                                            local_5.group = _e1472;
                                                            let _e1475 = local_5.len;
                                                            if (_e1475 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1480 = local_5.mask[(0u + _e1475)];
                                                            local_5.group_mask = _e1480;
                                                            phi_2178_ = true;
                                                        }
                                                        let _e1483 = phi_2178_;
                                                        phi_2179_ = _e1483;
                                                    } else {
                                                        phi_2179_ = true;
                                                    }
                                                    let _e1485 = phi_2179_;
                                                    if _e1485 {
                                                        let _e1487 = local_5.group_mask;
                                                        let _e1493 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1487)), 32u, (_e1487 == 0u)));
                                                        let _e1497 = local_5.group_mask;
                                                        let _e1511 = local_5.group_mask;
                                                        local_5.group_mask = (_e1511 & ~((1u << bitcast<u32>((_e1493 & 31u)))));
                                                        let _e1514 = local_5.group;
                                                        phi_2210_ = (_e1514 + countOneBits(((_e1497 & ~((4294967295u << bitcast<u32>((((_e1493 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2210_ = 4294967295u;
                                                    }
                                                    let _e1517 = phi_2210_;
                                                    phi_2212_ = _e977;
                                                    phi_2215_ = _e1517;
                                                    loop {
                                                        let _e1519 = phi_2212_;
                                                        let _e1521 = phi_2215_;
                                                        local_14 = _e1519;
                                                        let _e1522 = (_e1521 != 4294967295u);
                                                        if _e1522 {
                                                            if (_e1521 < _e75) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1529 = nodes.member[(0u + _e1521)].frame[3u];
                                                            let _e1554 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1283);
                                                            let _e1555 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1293);
                                                            let _e1556 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1303);
                                                            let _e1559 = nodes.member[(0u + _e1521)].frame[0u];
                                                            let _e1563 = nodes.member[(0u + _e1521)].frame[1u];
                                                            let _e1567 = nodes.member[(0u + _e1521)].frame[2u];
                                                            let _e1572 = ((bitcast<f32>(_e1559) - _e1069) * _e1283);
                                                            let _e1573 = ((bitcast<f32>(_e1563) - _e1082) * _e1293);
                                                            let _e1574 = ((bitcast<f32>(_e1567) - _e1095) * _e1303);
                                                            let _e1582 = nodes.member[(0u + _e1521)].x;
                                                            if (_e1283 < 0f) {
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1593.unnamed.root, _e1582.w), _e1593.unnamed_1);
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_bvh_traverse_Tree(_e1582.x, _e1599.unnamed_1.first_primitive));
                                                                phi_2296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1605.unnamed, lt_bvh_traverse_Tree(_e1605.unnamed_1.root, _e1582.y));
                                                            } else {
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1621.unnamed.root, _e1582.y), _e1621.unnamed_1);
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_bvh_traverse_Tree(_e1582.z, _e1627.unnamed_1.first_primitive));
                                                                phi_2296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1633.unnamed, lt_bvh_traverse_Tree(_e1633.unnamed_1.root, _e1582.w));
                                                            }
                                                            let _e1641 = phi_2296_;
                                                            let _e1651 = nodes.member[(0u + _e1521)].y;
                                                            if (_e1293 < 0f) {
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1662.unnamed.root, _e1651.w), _e1662.unnamed_1);
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_bvh_traverse_Tree(_e1651.x, _e1668.unnamed_1.first_primitive));
                                                                phi_2323_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1674.unnamed, lt_bvh_traverse_Tree(_e1674.unnamed_1.root, _e1651.y));
                                                            } else {
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1690.unnamed.root, _e1651.y), _e1690.unnamed_1);
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_bvh_traverse_Tree(_e1651.z, _e1696.unnamed_1.first_primitive));
                                                                phi_2323_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1702.unnamed, lt_bvh_traverse_Tree(_e1702.unnamed_1.root, _e1651.w));
                                                            }
                                                            let _e1710 = phi_2323_;
                                                            let _e1720 = nodes.member[(0u + _e1521)].z;
                                                            if (_e1303 < 0f) {
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1731.unnamed.root, _e1720.w), _e1731.unnamed_1);
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_bvh_traverse_Tree(_e1720.x, _e1737.unnamed_1.first_primitive));
                                                                phi_2350_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1743.unnamed, lt_bvh_traverse_Tree(_e1743.unnamed_1.root, _e1720.y));
                                                            } else {
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1759.unnamed.root, _e1720.y), _e1759.unnamed_1);
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_bvh_traverse_Tree(_e1720.z, _e1765.unnamed_1.first_primitive));
                                                                phi_2350_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1771.unnamed, lt_bvh_traverse_Tree(_e1771.unnamed_1.root, _e1720.w));
                                                            }
                                                            let _e1779 = phi_2350_;
                                                            phi_2356_ = 0u;
                                                            phi_2359_ = 0u;
                                                            loop {
                                                                let _e1789 = phi_2356_;
                                                                let _e1791 = phi_2359_;
                                                                local_10 = _e1791;
                                                                local_11 = _e1791;
                                                                local_12 = _e1791;
                                                                let _e1792 = (_e1789 < 8u);
                                                                if _e1792 {
                                                                    let _e1794 = (_e1789 >> bitcast<u32>(2i));
                                                                    let _e1795 = (_e1789 & 3u);
                                                                    if (_e1794 == 0u) {
                                                                        phi_2373_ = _e1641.unnamed.root;
                                                                    } else {
                                                                        phi_2373_ = _e1641.unnamed.first_primitive;
                                                                    }
                                                                    let _e1798 = phi_2373_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_2383_ = _e1710.unnamed.root;
                                                                    } else {
                                                                        phi_2383_ = _e1710.unnamed.first_primitive;
                                                                    }
                                                                    let _e1807 = phi_2383_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_2393_ = _e1779.unnamed.root;
                                                                    } else {
                                                                        phi_2393_ = _e1779.unnamed.first_primitive;
                                                                    }
                                                                    let _e1816 = phi_2393_;
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1798 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)), ((f32(((_e1807 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    let _e1830 = core_intrinsics_maximum_number_nsz_f32_(_e1829, ((f32(((_e1816 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 - _e1333)));
                                                                    if (_e1794 == 0u) {
                                                                        phi_2411_ = _e1641.unnamed_1.root;
                                                                    } else {
                                                                        phi_2411_ = _e1641.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1833 = phi_2411_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_2421_ = _e1710.unnamed_1.root;
                                                                    } else {
                                                                        phi_2421_ = _e1710.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1842 = phi_2421_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_2431_ = _e1779.unnamed_1.root;
                                                                    } else {
                                                                        phi_2431_ = _e1779.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1851 = phi_2431_;
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1833 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)), ((f32(((_e1842 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    let _e1865 = core_intrinsics_minimum_number_nsz_f32_(_e1864, ((f32(((_e1851 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 + _e1333)));
                                                                    if (_e1830 <= _e1865) {
                                                                        if (_e1830 <= _e1519.t) {
                                                                            if (_e1865 >= _e159.tmin) {
                                                                                if (_e1794 == 0u) {
                                                                                    let _e1872 = nodes.member[(0u + _e1521)].links[2u];
                                                                                    phi_2467_ = _e1872;
                                                                                } else {
                                                                                    let _e1875 = nodes.member[(0u + _e1521)].links[3u];
                                                                                    phi_2467_ = _e1875;
                                                                                }
                                                                                let _e1877 = phi_2467_;
                                                                                let _e1882 = ((_e1877 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u);
                                                                                let _e1883 = (_e1882 & 31u);
                                                                                if (_e1883 >= 24u) {
                                                                                    phi_2480_ = (24u + ((_e1883 - 24u) ^ _e1381));
                                                                                } else {
                                                                                    phi_2480_ = _e1883;
                                                                                }
                                                                                let _e1889 = phi_2480_;
                                                                                phi_2485_ = (_e1791 | ((_e1882 >> bitcast<u32>(5i)) << bitcast<u32>((_e1889 & 31u))));
                                                                            } else {
                                                                                phi_2485_ = _e1791;
                                                                            }
                                                                            let _e1897 = phi_2485_;
                                                                            phi_2486_ = _e1897;
                                                                        } else {
                                                                            phi_2486_ = _e1791;
                                                                        }
                                                                        let _e1899 = phi_2486_;
                                                                        phi_2487_ = _e1899;
                                                                    } else {
                                                                        phi_2487_ = _e1791;
                                                                    }
                                                                    let _e1901 = phi_2487_;
                                                                    phi_2357_ = (_e1789 + 1u);
                                                                    phi_2360_ = _e1901;
                                                                } else {
                                                                    phi_2357_ = u32();
                                                                    phi_2360_ = u32();
                                                                }
                                                                let _e1904 = phi_2357_;
                                                                let _e1906 = phi_2360_;
                                                                continue;
                                                                continuing {
                                                                    phi_2356_ = _e1904;
                                                                    phi_2359_ = _e1906;
                                                                    break if !(_e1792);
                                                                }
                                                            }
                                                            let _e1910 = nodes.member[(0u + _e1521)].links[0u];
                                                            let _e1914 = nodes.member[(0u + _e1521)].frame[3u];
                                                            let _e1918 = local_10;
                                                            if ((_e1918 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1922 = local_5.group_mask;
                                                                if ((_e1922 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1926 = local_5.len;
                                                                    if (_e1926 < 32u) {
                                                                        let _e1929 = local_5.group;
                                                                        let _e1931 = local_5.len;
                                                                        if (_e1931 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_5.first[(0u + _e1931)] = _e1929;
                                                                        let _e1937 = local_5.group_mask;
                                                                        let _e1939 = local_5.len;
                                                                        if (_e1939 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_5.mask[(0u + _e1939)] = _e1937;
                                                                        let _e1946 = local_5.len;
                                                                        local_5.len = (_e1946 + 1u);
                                                                    }
                                                                }
                                                                local_5.group = (_e1143 + _e1910);
                                                                let _e1950 = local_11;
                                                                local_5.group_mask = ((_e1950 & 4278190080u) | (_e1914 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1955 = local_12;
                                                            phi_2545_ = _e1519;
                                                            phi_2548_ = (_e1955 & 16777215u);
                                                            loop {
                                                                let _e1958 = phi_2545_;
                                                                let _e1960 = phi_2548_;
                                                                local_13 = _e1958;
                                                                if (_e1960 == 0u) {
                                                                    phi_2546_ = lt_bvh_Hit();
                                                                    phi_2549_ = u32();
                                                                    phi_3264_ = false;
                                                                } else {
                                                                    let _e1964 = nodes.member[(0u + _e1521)].links[1u];
                                                                    let _e1969 = ((_e1145 + _e1964) + select(firstTrailingBit(_e1960), 32u, (_e1960 == 0u)));
                                                                    if (_e1969 < _e78) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1976 = triangles.member[(0u + _e1969)].v0_;
                                                                    let _e1978 = (_e1976.x - _e1069);
                                                                    let _e1980 = (_e1976.y - _e1082);
                                                                    let _e1982 = (_e1976.z - _e1095);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2593_ = vec3<f32>(_e1980, _e1982, _e1978);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2592_ = vec3<f32>(_e1982, _e1978, _e1980);
                                                                        } else {
                                                                            phi_2592_ = (_e1976 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                        }
                                                                        let _e1990 = phi_2592_;
                                                                        phi_2593_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2593_;
                                                                    let _e1996 = (_e1992.x - (_e1365 * _e1992.z));
                                                                    let _e2000 = (_e1992.y - (_e1368 * _e1992.z));
                                                                    let _e2004 = triangles.member[(0u + _e1969)].v1_;
                                                                    let _e2006 = (_e2004.x - _e1069);
                                                                    let _e2008 = (_e2004.y - _e1082);
                                                                    let _e2010 = (_e2004.z - _e1095);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2625_ = vec3<f32>(_e2008, _e2010, _e2006);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2624_ = vec3<f32>(_e2010, _e2006, _e2008);
                                                                        } else {
                                                                            phi_2624_ = (_e2004 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                        }
                                                                        let _e2018 = phi_2624_;
                                                                        phi_2625_ = _e2018;
                                                                    }
                                                                    let _e2020 = phi_2625_;
                                                                    let _e2024 = (_e2020.x - (_e1365 * _e2020.z));
                                                                    let _e2028 = (_e2020.y - (_e1368 * _e2020.z));
                                                                    let _e2032 = triangles.member[(0u + _e1969)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1069);
                                                                    let _e2036 = (_e2032.y - _e1082);
                                                                    let _e2038 = (_e2032.z - _e1095);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2657_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2656_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2656_ = (_e2032 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                        }
                                                                        let _e2046 = phi_2656_;
                                                                        phi_2657_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2657_;
                                                                    let _e2052 = (_e2048.x - (_e1365 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1368 * _e2048.z));
                                                                    if (_e2024 < _e2052) {
                                                                        phi_2678_ = true;
                                                                    } else {
                                                                        if (_e2024 == _e2052) {
                                                                            phi_2677_ = (_e2028 < _e2056);
                                                                        } else {
                                                                            phi_2677_ = false;
                                                                        }
                                                                        let _e2063 = phi_2677_;
                                                                        phi_2678_ = _e2063;
                                                                    }
                                                                    let _e2065 = phi_2678_;
                                                                    if _e2065 {
                                                                        phi_2682_ = _e2056;
                                                                        phi_2683_ = _e2052;
                                                                        phi_2684_ = _e2028;
                                                                        phi_2685_ = _e2024;
                                                                    } else {
                                                                        phi_2682_ = _e2028;
                                                                        phi_2683_ = _e2024;
                                                                        phi_2684_ = _e2056;
                                                                        phi_2685_ = _e2052;
                                                                    }
                                                                    let _e2067 = phi_2682_;
                                                                    let _e2069 = phi_2683_;
                                                                    let _e2071 = phi_2684_;
                                                                    let _e2073 = phi_2685_;
                                                                    let _e2076 = ((_e2073 * _e2067) - (_e2071 * _e2069));
                                                                    if _e2065 {
                                                                        phi_2693_ = -(_e2076);
                                                                    } else {
                                                                        phi_2693_ = _e2076;
                                                                    }
                                                                    let _e2079 = phi_2693_;
                                                                    if (_e2052 < _e1996) {
                                                                        phi_2704_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e1996) {
                                                                            phi_2703_ = (_e2056 < _e2000);
                                                                        } else {
                                                                            phi_2703_ = false;
                                                                        }
                                                                        let _e2084 = phi_2703_;
                                                                        phi_2704_ = _e2084;
                                                                    }
                                                                    let _e2086 = phi_2704_;
                                                                    if _e2086 {
                                                                        phi_2708_ = _e2000;
                                                                        phi_2709_ = _e1996;
                                                                        phi_2710_ = _e2056;
                                                                        phi_2711_ = _e2052;
                                                                    } else {
                                                                        phi_2708_ = _e2056;
                                                                        phi_2709_ = _e2052;
                                                                        phi_2710_ = _e2000;
                                                                        phi_2711_ = _e1996;
                                                                    }
                                                                    let _e2088 = phi_2708_;
                                                                    let _e2090 = phi_2709_;
                                                                    let _e2092 = phi_2710_;
                                                                    let _e2094 = phi_2711_;
                                                                    let _e2097 = ((_e2094 * _e2088) - (_e2092 * _e2090));
                                                                    if _e2086 {
                                                                        phi_2719_ = -(_e2097);
                                                                    } else {
                                                                        phi_2719_ = _e2097;
                                                                    }
                                                                    let _e2100 = phi_2719_;
                                                                    if (_e1996 < _e2024) {
                                                                        phi_2730_ = true;
                                                                    } else {
                                                                        if (_e1996 == _e2024) {
                                                                            phi_2729_ = (_e2000 < _e2028);
                                                                        } else {
                                                                            phi_2729_ = false;
                                                                        }
                                                                        let _e2105 = phi_2729_;
                                                                        phi_2730_ = _e2105;
                                                                    }
                                                                    let _e2107 = phi_2730_;
                                                                    if _e2107 {
                                                                        phi_2734_ = _e2028;
                                                                        phi_2735_ = _e2024;
                                                                        phi_2736_ = _e2000;
                                                                        phi_2737_ = _e1996;
                                                                    } else {
                                                                        phi_2734_ = _e2000;
                                                                        phi_2735_ = _e1996;
                                                                        phi_2736_ = _e2028;
                                                                        phi_2737_ = _e2024;
                                                                    }
                                                                    let _e2109 = phi_2734_;
                                                                    let _e2111 = phi_2735_;
                                                                    let _e2113 = phi_2736_;
                                                                    let _e2115 = phi_2737_;
                                                                    let _e2118 = ((_e2115 * _e2109) - (_e2113 * _e2111));
                                                                    if _e2107 {
                                                                        phi_2745_ = -(_e2118);
                                                                    } else {
                                                                        phi_2745_ = _e2118;
                                                                    }
                                                                    let _e2121 = phi_2745_;
                                                                    if (_e2079 >= 0f) {
                                                                        if (_e2100 >= 0f) {
                                                                            if (_e2121 >= 0f) {
                                                                                phi_2760_ = ((_e2079 + _e2100) + _e2121);
                                                                                phi_2761_ = false;
                                                                            } else {
                                                                                phi_2760_ = f32();
                                                                                phi_2761_ = true;
                                                                            }
                                                                            let _e2128 = phi_2760_;
                                                                            let _e2130 = phi_2761_;
                                                                            phi_2762_ = _e2128;
                                                                            phi_2763_ = _e2130;
                                                                        } else {
                                                                            phi_2762_ = f32();
                                                                            phi_2763_ = true;
                                                                        }
                                                                        let _e2132 = phi_2762_;
                                                                        let _e2134 = phi_2763_;
                                                                        phi_2764_ = _e2132;
                                                                        phi_2765_ = _e2134;
                                                                    } else {
                                                                        phi_2764_ = f32();
                                                                        phi_2765_ = true;
                                                                    }
                                                                    let _e2136 = phi_2764_;
                                                                    let _e2138 = phi_2765_;
                                                                    if _e2138 {
                                                                        if (_e2079 <= 0f) {
                                                                            if (_e2100 <= 0f) {
                                                                                let _e2141 = (_e2121 <= 0f);
                                                                                if _e2141 {
                                                                                }
                                                                                phi_2783_ = ((_e2079 + _e2100) + _e2121);
                                                                                phi_2784_ = false;
                                                                                phi_2785_ = _e2141;
                                                                            } else {
                                                                                phi_2783_ = f32();
                                                                                phi_2784_ = true;
                                                                                phi_2785_ = false;
                                                                            }
                                                                            let _e2145 = phi_2783_;
                                                                            let _e2147 = phi_2784_;
                                                                            let _e2149 = phi_2785_;
                                                                            phi_2786_ = _e2145;
                                                                            phi_2787_ = _e2147;
                                                                            phi_2788_ = _e2149;
                                                                        } else {
                                                                            phi_2786_ = f32();
                                                                            phi_2787_ = true;
                                                                            phi_2788_ = false;
                                                                        }
                                                                        let _e2151 = phi_2786_;
                                                                        let _e2153 = phi_2787_;
                                                                        let _e2155 = phi_2788_;
                                                                        if _e2153 {
                                                                            phi_2792_ = false;
                                                                        } else {
                                                                            phi_2792_ = _e2155;
                                                                        }
                                                                        let _e2157 = phi_2792_;
                                                                        phi_2793_ = _e2151;
                                                                        phi_2794_ = _e2157;
                                                                    } else {
                                                                        phi_2793_ = _e2136;
                                                                        phi_2794_ = true;
                                                                    }
                                                                    let _e2159 = phi_2793_;
                                                                    let _e2161 = phi_2794_;
                                                                    if _e2161 {
                                                                        let _e2162 = (_e2159 == 0f);
                                                                        if _e2162 {
                                                                            phi_2992_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2168 = ((((_e2079 * (_e1370 * _e1992.z)) + (_e2100 * (_e1370 * _e2020.z))) + (_e2121 * (_e1370 * _e2048.z))) / _e2159);
                                                                            let _e2170 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2172 = triangles.member[(0u + _e1969)].v1_;
                                                                            if (_e2170.x < _e2172.x) {
                                                                                phi_2820_ = _e2170.x;
                                                                            } else {
                                                                                phi_2820_ = _e2172.x;
                                                                            }
                                                                            let _e2179 = phi_2820_;
                                                                            if (_e2170.y < _e2172.y) {
                                                                                phi_2829_ = _e2170.y;
                                                                            } else {
                                                                                phi_2829_ = _e2172.y;
                                                                            }
                                                                            let _e2186 = phi_2829_;
                                                                            if (_e2170.z < _e2172.z) {
                                                                                phi_2838_ = _e2170.z;
                                                                            } else {
                                                                                phi_2838_ = _e2172.z;
                                                                            }
                                                                            let _e2193 = phi_2838_;
                                                                            let _e2195 = triangles.member[(0u + _e1969)].v2_;
                                                                            if (_e2179 < _e2195.x) {
                                                                                phi_2847_ = _e2179;
                                                                            } else {
                                                                                phi_2847_ = _e2195.x;
                                                                            }
                                                                            let _e2200 = phi_2847_;
                                                                            if (_e2186 < _e2195.y) {
                                                                                phi_2854_ = _e2186;
                                                                            } else {
                                                                                phi_2854_ = _e2195.y;
                                                                            }
                                                                            let _e2205 = phi_2854_;
                                                                            if (_e2193 < _e2195.z) {
                                                                                phi_2861_ = _e2193;
                                                                            } else {
                                                                                phi_2861_ = _e2195.z;
                                                                            }
                                                                            let _e2210 = phi_2861_;
                                                                            let _e2212 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2214 = triangles.member[(0u + _e1969)].v1_;
                                                                            if (_e2212.x > _e2214.x) {
                                                                                phi_2874_ = _e2212.x;
                                                                            } else {
                                                                                phi_2874_ = _e2214.x;
                                                                            }
                                                                            let _e2221 = phi_2874_;
                                                                            if (_e2212.y > _e2214.y) {
                                                                                phi_2883_ = _e2212.y;
                                                                            } else {
                                                                                phi_2883_ = _e2214.y;
                                                                            }
                                                                            let _e2228 = phi_2883_;
                                                                            if (_e2212.z > _e2214.z) {
                                                                                phi_2892_ = _e2212.z;
                                                                            } else {
                                                                                phi_2892_ = _e2214.z;
                                                                            }
                                                                            let _e2235 = phi_2892_;
                                                                            let _e2237 = triangles.member[(0u + _e1969)].v2_;
                                                                            if (_e2221 > _e2237.x) {
                                                                                phi_2901_ = _e2221;
                                                                            } else {
                                                                                phi_2901_ = _e2237.x;
                                                                            }
                                                                            let _e2242 = phi_2901_;
                                                                            if (_e2228 > _e2237.y) {
                                                                                phi_2908_ = _e2228;
                                                                            } else {
                                                                                phi_2908_ = _e2237.y;
                                                                            }
                                                                            let _e2247 = phi_2908_;
                                                                            if (_e2235 > _e2237.z) {
                                                                                phi_2915_ = _e2235;
                                                                            } else {
                                                                                phi_2915_ = _e2237.z;
                                                                            }
                                                                            let _e2252 = phi_2915_;
                                                                            let _e2256 = ((_e2200 - _e1069) * _e1283);
                                                                            let _e2257 = ((_e2205 - _e1082) * _e1293);
                                                                            let _e2258 = ((_e2210 - _e1095) * _e1303);
                                                                            let _e2262 = ((_e2242 - _e1069) * _e1283);
                                                                            let _e2263 = ((_e2247 - _e1082) * _e1293);
                                                                            let _e2264 = ((_e2252 - _e1095) * _e1303);
                                                                            if (_e2256 < _e2262) {
                                                                                phi_2932_ = _e2256;
                                                                            } else {
                                                                                phi_2932_ = _e2262;
                                                                            }
                                                                            let _e2267 = phi_2932_;
                                                                            if (_e2257 < _e2263) {
                                                                                phi_2937_ = _e2257;
                                                                            } else {
                                                                                phi_2937_ = _e2263;
                                                                            }
                                                                            let _e2270 = phi_2937_;
                                                                            if (_e2258 < _e2264) {
                                                                                phi_2942_ = _e2258;
                                                                            } else {
                                                                                phi_2942_ = _e2264;
                                                                            }
                                                                            let _e2273 = phi_2942_;
                                                                            if (_e2256 > _e2262) {
                                                                                phi_2950_ = _e2256;
                                                                            } else {
                                                                                phi_2950_ = _e2262;
                                                                            }
                                                                            let _e2279 = phi_2950_;
                                                                            if (_e2257 > _e2263) {
                                                                                phi_2955_ = _e2257;
                                                                            } else {
                                                                                phi_2955_ = _e2263;
                                                                            }
                                                                            let _e2282 = phi_2955_;
                                                                            if (_e2258 > _e2264) {
                                                                                phi_2960_ = _e2258;
                                                                            } else {
                                                                                phi_2960_ = _e2264;
                                                                            }
                                                                            let _e2285 = phi_2960_;
                                                                            let _e2289 = core_intrinsics_maximum_number_nsz_f32_((_e2267 - _e1338), (_e2270 - _e1339));
                                                                            let _e2290 = core_intrinsics_maximum_number_nsz_f32_(_e2289, (_e2273 - _e1340));
                                                                            let _e2291 = core_intrinsics_minimum_number_nsz_f32_((_e2279 + _e1338), (_e2282 + _e1339));
                                                                            let _e2292 = core_intrinsics_minimum_number_nsz_f32_(_e2291, (_e2285 + _e1340));
                                                                            if (_e2290 > _e1044) {
                                                                                phi_2972_ = _e2290;
                                                                            } else {
                                                                                phi_2972_ = _e1044;
                                                                            }
                                                                            let _e2295 = phi_2972_;
                                                                            if (_e2292 < _e1046) {
                                                                                phi_2977_ = _e2292;
                                                                            } else {
                                                                                phi_2977_ = _e1046;
                                                                            }
                                                                            let _e2298 = phi_2977_;
                                                                            if (_e2168 < _e2295) {
                                                                                phi_2982_ = _e2295;
                                                                            } else {
                                                                                phi_2982_ = _e2168;
                                                                            }
                                                                            let _e2301 = phi_2982_;
                                                                            if (_e2301 > _e2298) {
                                                                                phi_2987_ = _e2298;
                                                                            } else {
                                                                                phi_2987_ = _e2301;
                                                                            }
                                                                            let _e2304 = phi_2987_;
                                                                            phi_2992_ = lt_bvh_triangle_Intersection(_e2304, (_e2100 / _e2159), (_e2121 / _e2159), (_e2295 <= _e2298));
                                                                        }
                                                                        let _e2310 = phi_2992_;
                                                                        phi_2993_ = _e2310;
                                                                        phi_2994_ = _e2162;
                                                                    } else {
                                                                        phi_2993_ = lt_bvh_triangle_Intersection();
                                                                        phi_2994_ = true;
                                                                    }
                                                                    let _e2312 = phi_2993_;
                                                                    let _e2314 = phi_2994_;
                                                                    if _e2314 {
                                                                        phi_2998_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2998_ = _e2312;
                                                                    }
                                                                    let _e2316 = phi_2998_;
                                                                    if _e2316.is_hit {
                                                                        if (_e2316.t > _e159.tmin) {
                                                                            if (_e2316.t < _e1958.t) {
                                                                                phi_3046_ = true;
                                                                            } else {
                                                                                if (_e2316.t == _e1958.t) {
                                                                                    if (_e1958.triangle != 4294967295u) {
                                                                                        if (_e1969 < _e1958.triangle) {
                                                                                            phi_3037_ = true;
                                                                                        } else {
                                                                                            if (_e1969 == _e1958.triangle) {
                                                                                                phi_3036_ = (_e985 < _e1958.instance);
                                                                                            } else {
                                                                                                phi_3036_ = false;
                                                                                            }
                                                                                            let _e2334 = phi_3036_;
                                                                                            phi_3037_ = _e2334;
                                                                                        }
                                                                                        let _e2336 = phi_3037_;
                                                                                        phi_3038_ = _e2336;
                                                                                        phi_3039_ = false;
                                                                                    } else {
                                                                                        phi_3038_ = bool();
                                                                                        phi_3039_ = true;
                                                                                    }
                                                                                    let _e2338 = phi_3038_;
                                                                                    let _e2340 = phi_3039_;
                                                                                    phi_3040_ = _e2338;
                                                                                    phi_3041_ = _e2340;
                                                                                } else {
                                                                                    phi_3040_ = bool();
                                                                                    phi_3041_ = true;
                                                                                }
                                                                                let _e2342 = phi_3040_;
                                                                                let _e2344 = phi_3041_;
                                                                                if _e2344 {
                                                                                    phi_3045_ = false;
                                                                                } else {
                                                                                    phi_3045_ = _e2342;
                                                                                }
                                                                                let _e2346 = phi_3045_;
                                                                                phi_3046_ = _e2346;
                                                                            }
                                                                            let _e2348 = phi_3046_;
                                                                            if _e2348 {
                                                                                let _e2350 = triangles.member[(0u + _e1969)].i0_;
                                                                                if ((_e2350 & 2147483648u) == 0u) {
                                                                                    phi_3252_ = true;
                                                                                } else {
                                                                                    if (_e1969 < _e78) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2359 = triangles.member[(0u + _e1969)].i0_;
                                                                                    let _e2360 = (_e2359 & 2147483647u);
                                                                                    let _e2362 = triangles.member[(0u + _e1969)].i1_;
                                                                                    let _e2364 = triangles.member[(0u + _e1969)].i2_;
                                                                                    if (_e2360 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2368 = vertices.member[(0u + _e2360)];
                                                                                    if (_e2362 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2372 = vertices.member[(0u + _e2362)];
                                                                                    if (_e2364 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2376 = vertices.member[(0u + _e2364)];
                                                                                    let _e2377 = array<abi_Vertex, 3>(_e2368, _e2372, _e2376);
                                                                                    local_4 = array<abi_Vertex, 3>(abi_Vertex(_e2377[0].u, _e2377[0].v, _e2377[0].normal, _e2377[0].color, _e2377[0].material), abi_Vertex(_e2377[1].u, _e2377[1].v, _e2377[1].normal, _e2377[1].color, _e2377[1].material), abi_Vertex(_e2377[2].u, _e2377[2].v, _e2377[2].normal, _e2377[2].color, _e2377[2].material));
                                                                                    let _e2402 = local_4[0u].material;
                                                                                    if (_e2402 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2406 = materials.member[(0u + _e2402)];
                                                                                    if ((_e2406.flags & 0u) == 0u) {
                                                                                        let _e2410 = lt_shaders_surface_barycentric_weights(_e2316.u, _e2316.v);
                                                                                        if (_e2406.cutoff <= 0f) {
                                                                                            phi_3247_ = true;
                                                                                        } else {
                                                                                            let _e2415 = lt_shaders_surface_vertex_color((&local_4), _e2410);
                                                                                            let _e2417 = (_e2406.base_color.w * _e2415.w);
                                                                                            if (_e2406.alpha_size == 0u) {
                                                                                                phi_3244_ = _e2417;
                                                                                            } else {
                                                                                                local_3.offset = _e2406.alpha_offset;
                                                                                                local_3.size = _e2406.alpha_size;
                                                                                                local_3.flags = _e2406.flags;
                                                                                                let _e2426 = lt_shaders_surface_texture_coordinate((&local_4), _e2410);
                                                                                                let _e2429 = _lt_shaders_texture_TextureView_quad((&local_3), _e2426.x, _e2426.y);
                                                                                                let _e2433 = (_e2429.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2433 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2437 = alpha_texels.member[(0u + _e2433)];
                                                                                                let _e2453 = (_e2429.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2453 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2457 = alpha_texels.member[(0u + _e2453)];
                                                                                                let _e2474 = (_e2429.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2474 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2478 = alpha_texels.member[(0u + _e2474)];
                                                                                                let _e2495 = (_e2429.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2495 < _e93) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2499 = alpha_texels.member[(0u + _e2495)];
                                                                                                phi_3244_ = (_e2417 * (((((f32(((_e2437 >> bitcast<u32>((((_e2429.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2429.weights.x) + ((f32(((_e2457 >> bitcast<u32>((((_e2429.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2429.weights.y)) + ((f32(((_e2478 >> bitcast<u32>((((_e2429.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2429.weights.z)) + ((f32(((_e2499 >> bitcast<u32>((((_e2429.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2429.weights.w)));
                                                                                            }
                                                                                            let _e2515 = phi_3244_;
                                                                                            phi_3247_ = (_e2515 >= _e2406.cutoff);
                                                                                        }
                                                                                        let _e2519 = phi_3247_;
                                                                                        phi_3248_ = _e2519;
                                                                                    } else {
                                                                                        phi_3248_ = false;
                                                                                    }
                                                                                    let _e2521 = phi_3248_;
                                                                                    if _e2521 {
                                                                                    }
                                                                                    phi_3252_ = _e2521;
                                                                                }
                                                                                let _e2523 = phi_3252_;
                                                                                if _e2523 {
                                                                                    phi_3260_ = lt_bvh_Hit(_e2316.t, _e2316.u, _e2316.v, _e1969, _e985);
                                                                                } else {
                                                                                    phi_3260_ = _e1958;
                                                                                }
                                                                                let _e2529 = phi_3260_;
                                                                                phi_3261_ = _e2529;
                                                                            } else {
                                                                                phi_3261_ = _e1958;
                                                                            }
                                                                            let _e2531 = phi_3261_;
                                                                            phi_3262_ = _e2531;
                                                                        } else {
                                                                            phi_3262_ = _e1958;
                                                                        }
                                                                        let _e2533 = phi_3262_;
                                                                        phi_3263_ = _e2533;
                                                                    } else {
                                                                        phi_3263_ = _e1958;
                                                                    }
                                                                    let _e2535 = phi_3263_;
                                                                    phi_2546_ = _e2535;
                                                                    phi_2549_ = (_e1960 & (_e1960 - 1u));
                                                                    phi_3264_ = true;
                                                                }
                                                                let _e2537 = phi_2546_;
                                                                let _e2539 = phi_2549_;
                                                                let _e2541 = phi_3264_;
                                                                continue;
                                                                continuing {
                                                                    phi_2545_ = _e2537;
                                                                    phi_2548_ = _e2539;
                                                                    break if !(_e2541);
                                                                }
                                                            }
                                                            let _e2544 = local_5.group_mask;
                                                            if ((_e2544 & 4278190080u) == 0u) {
                                                                let _e2548 = local_5.len;
                                                                if (_e2548 == 0u) {
                                                                    phi_3303_ = false;
                                                                } else {
                                                                    let _e2552 = local_5.len;
                                                                    local_5.len = (_e2552 - 1u);
                                                                    let _e2555 = local_5.len;
                                                                    if (_e2555 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2560 = local_5.first[(0u + _e2555)];
                                                                    local_5.group = _e2560;
                                                                    let _e2563 = local_5.len;
                                                                    if (_e2563 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2568 = local_5.mask[(0u + _e2563)];
                                                                    local_5.group_mask = _e2568;
                                                                    phi_3303_ = true;
                                                                }
                                                                let _e2571 = phi_3303_;
                                                                phi_3304_ = _e2571;
                                                            } else {
                                                                phi_3304_ = true;
                                                            }
                                                            let _e2573 = phi_3304_;
                                                            if _e2573 {
                                                                let _e2575 = local_5.group_mask;
                                                                let _e2581 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2575)), 32u, (_e2575 == 0u)));
                                                                let _e2585 = local_5.group_mask;
                                                                let _e2599 = local_5.group_mask;
                                                                local_5.group_mask = (_e2599 & ~((1u << bitcast<u32>((_e2581 & 31u)))));
                                                                let _e2602 = local_5.group;
                                                                phi_3335_ = (_e2602 + countOneBits(((_e2585 & ~((4294967295u << bitcast<u32>((((_e2581 - 24u) ^ _e1381) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3335_ = 4294967295u;
                                                            }
                                                            let _e2605 = phi_3335_;
                                                            let _e3442 = local_13;
                                                            phi_2213_ = _e3442;
                                                            phi_2216_ = _e2605;
                                                        } else {
                                                            phi_2213_ = lt_bvh_Hit();
                                                            phi_2216_ = u32();
                                                        }
                                                        let _e2607 = phi_2213_;
                                                        let _e2609 = phi_2216_;
                                                        continue;
                                                        continuing {
                                                            phi_2212_ = _e2607;
                                                            phi_2215_ = _e2609;
                                                            break if !(_e1522);
                                                        }
                                                    }
                                                    let _e3446 = local_14;
                                                    phi_3336_ = _e3446;
                                                }
                                                let _e2612 = phi_3336_;
                                                phi_3337_ = _e2612;
                                                phi_3338_ = _e1207;
                                            } else {
                                                phi_3337_ = lt_bvh_Hit();
                                                phi_3338_ = true;
                                            }
                                            let _e2614 = phi_3337_;
                                            let _e2616 = phi_3338_;
                                            if _e2616 {
                                                phi_3342_ = _e977;
                                            } else {
                                                phi_3342_ = _e2614;
                                            }
                                            let _e2618 = phi_3342_;
                                            phi_3343_ = _e2618;
                                        } else {
                                            phi_3343_ = _e977;
                                        }
                                        let _e2620 = phi_3343_;
                                        phi_3344_ = _e2620;
                                    } else {
                                        phi_3344_ = _e977;
                                    }
                                    let _e2622 = phi_3344_;
                                    phi_3345_ = _e2622;
                                } else {
                                    phi_3345_ = _e977;
                                }
                                let _e2624 = phi_3345_;
                                phi_1588_ = (_e975 & (_e975 - 1u));
                                phi_1591_ = _e2624;
                                phi_3346_ = true;
                            }
                            let _e2626 = phi_1588_;
                            let _e2628 = phi_1591_;
                            let _e2630 = phi_3346_;
                            continue;
                            continuing {
                                phi_1587_ = _e2626;
                                phi_1590_ = _e2628;
                                break if !(_e2630);
                            }
                        }
                        let _e2633 = local_6.group_mask;
                        if ((_e2633 & 4278190080u) == 0u) {
                            let _e2637 = local_6.len;
                            if (_e2637 == 0u) {
                                phi_3385_ = false;
                            } else {
                                let _e2641 = local_6.len;
                                local_6.len = (_e2641 - 1u);
                                let _e2644 = local_6.len;
                                if (_e2644 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2649 = local_6.first[(0u + _e2644)];
                                local_6.group = _e2649;
                                let _e2652 = local_6.len;
                                if (_e2652 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2657 = local_6.mask[(0u + _e2652)];
                                local_6.group_mask = _e2657;
                                phi_3385_ = true;
                            }
                            let _e2660 = phi_3385_;
                            phi_3386_ = _e2660;
                        } else {
                            phi_3386_ = true;
                        }
                        let _e2662 = phi_3386_;
                        if _e2662 {
                            let _e2664 = local_6.group_mask;
                            let _e2670 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2664)), 32u, (_e2664 == 0u)));
                            let _e2674 = local_6.group_mask;
                            let _e2688 = local_6.group_mask;
                            local_6.group_mask = (_e2688 & ~((1u << bitcast<u32>((_e2670 & 31u)))));
                            let _e2691 = local_6.group;
                            phi_3417_ = (_e2691 + countOneBits(((_e2674 & ~((4294967295u << bitcast<u32>((((_e2670 - 24u) ^ _e394) & 31u))))) & 255u)));
                        } else {
                            phi_3417_ = 4294967295u;
                        }
                        let _e2694 = phi_3417_;
                        phi_1251_ = _e2694;
                        let _e3462 = local_15;
                        phi_1254_ = _e3462;
                    } else {
                        phi_1251_ = u32();
                        phi_1254_ = lt_bvh_Hit();
                    }
                    let _e2696 = phi_1251_;
                    let _e2698 = phi_1254_;
                    continue;
                    continuing {
                        phi_1250_ = _e2696;
                        phi_1253_ = _e2698;
                        break if !(_e535);
                    }
                }
                let _e3465 = local_16;
                phi_3418_ = _e3465;
            }
            let _e2701 = phi_3418_;
            phi_3419_ = _e2701;
            phi_3420_ = _e231;
        } else {
            phi_3419_ = lt_bvh_Hit();
            phi_3420_ = true;
        }
        let _e2703 = phi_3419_;
        let _e2705 = phi_3420_;
        if _e2705 {
            phi_3424_ = _e161;
        } else {
            phi_3424_ = _e2703;
        }
        let _e2707 = phi_3424_;
        if (_e2707.triangle != 4294967295u) {
            let _e2712 = lt_shaders_surface_barycentric_weights(_e2707.u, _e2707.v);
            if (_e2707.triangle < _e78) {
            } else {
                return;
            }
            let _e2717 = triangles.member[(0u + _e2707.triangle)];
            if (_e2707.instance < _e90) {
            } else {
                return;
            }
            let _e2728 = instances.member[(0u + _e2707.instance)].object_to_world[0u];
            let _e2739 = ((((_e2728.x * _e2717.v0_.x) + (_e2728.y * _e2717.v0_.y)) + (_e2728.z * _e2717.v0_.z)) + (_e2728.w * 1f));
            let _e2741 = instances.member[(0u + _e2707.instance)].object_to_world[1u];
            let _e2752 = ((((_e2741.x * _e2717.v0_.x) + (_e2741.y * _e2717.v0_.y)) + (_e2741.z * _e2717.v0_.z)) + (_e2741.w * 1f));
            let _e2754 = instances.member[(0u + _e2707.instance)].object_to_world[2u];
            let _e2765 = ((((_e2754.x * _e2717.v0_.x) + (_e2754.y * _e2717.v0_.y)) + (_e2754.z * _e2717.v0_.z)) + (_e2754.w * 1f));
            let _e2772 = instances.member[(0u + _e2707.instance)].object_to_world[0u];
            let _e2783 = ((((_e2772.x * _e2717.v1_.x) + (_e2772.y * _e2717.v1_.y)) + (_e2772.z * _e2717.v1_.z)) + (_e2772.w * 1f));
            let _e2785 = instances.member[(0u + _e2707.instance)].object_to_world[1u];
            let _e2796 = ((((_e2785.x * _e2717.v1_.x) + (_e2785.y * _e2717.v1_.y)) + (_e2785.z * _e2717.v1_.z)) + (_e2785.w * 1f));
            let _e2798 = instances.member[(0u + _e2707.instance)].object_to_world[2u];
            let _e2809 = ((((_e2798.x * _e2717.v1_.x) + (_e2798.y * _e2717.v1_.y)) + (_e2798.z * _e2717.v1_.z)) + (_e2798.w * 1f));
            let _e2816 = instances.member[(0u + _e2707.instance)].object_to_world[0u];
            let _e2827 = ((((_e2816.x * _e2717.v2_.x) + (_e2816.y * _e2717.v2_.y)) + (_e2816.z * _e2717.v2_.z)) + (_e2816.w * 1f));
            let _e2829 = instances.member[(0u + _e2707.instance)].object_to_world[1u];
            let _e2840 = ((((_e2829.x * _e2717.v2_.x) + (_e2829.y * _e2717.v2_.y)) + (_e2829.z * _e2717.v2_.z)) + (_e2829.w * 1f));
            let _e2842 = instances.member[(0u + _e2707.instance)].object_to_world[2u];
            let _e2853 = ((((_e2842.x * _e2717.v2_.x) + (_e2842.y * _e2717.v2_.y)) + (_e2842.z * _e2717.v2_.z)) + (_e2842.w * 1f));
            let _e2869 = (((_e2739 * _e2712.x) + (_e2783 * _e2712.y)) + (_e2827 * _e2712.z));
            let _e2870 = (((_e2752 * _e2712.x) + (_e2796 * _e2712.y)) + (_e2840 * _e2712.z));
            let _e2871 = (((_e2765 * _e2712.x) + (_e2809 * _e2712.y)) + (_e2853 * _e2712.z));
            let _e2873 = abs(_e2739);
            let _e2874 = abs(_e2752);
            let _e2875 = abs(_e2765);
            let _e2876 = abs(_e2783);
            let _e2877 = abs(_e2796);
            let _e2878 = abs(_e2809);
            if (_e2873 > _e2876) {
                phi_3613_ = _e2873;
            } else {
                phi_3613_ = _e2876;
            }
            let _e2881 = phi_3613_;
            if (_e2874 > _e2877) {
                phi_3618_ = _e2874;
            } else {
                phi_3618_ = _e2877;
            }
            let _e2884 = phi_3618_;
            if (_e2875 > _e2878) {
                phi_3623_ = _e2875;
            } else {
                phi_3623_ = _e2878;
            }
            let _e2887 = phi_3623_;
            let _e2888 = abs(_e2827);
            let _e2889 = abs(_e2840);
            let _e2890 = abs(_e2853);
            if (_e2881 > _e2888) {
                phi_3631_ = _e2881;
            } else {
                phi_3631_ = _e2888;
            }
            let _e2893 = phi_3631_;
            if (_e2884 > _e2889) {
                phi_3636_ = _e2884;
            } else {
                phi_3636_ = _e2889;
            }
            let _e2896 = phi_3636_;
            if (_e2887 > _e2890) {
                phi_3641_ = _e2887;
            } else {
                phi_3641_ = _e2890;
            }
            let _e2899 = phi_3641_;
            let _e2900 = (_e2783 - _e2739);
            let _e2901 = (_e2796 - _e2752);
            let _e2902 = (_e2809 - _e2765);
            let _e2903 = (_e2827 - _e2739);
            let _e2904 = (_e2840 - _e2752);
            let _e2905 = (_e2853 - _e2765);
            let _e2909 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2901), abs(_e2902));
            let _e2910 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2900), _e2909);
            let _e2911 = (_e2900 / _e2910);
            let _e2912 = (_e2901 / _e2910);
            let _e2913 = (_e2902 / _e2910);
            let _e2917 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2904), abs(_e2905));
            let _e2918 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2903), _e2917);
            let _e2919 = (_e2903 / _e2918);
            let _e2920 = (_e2904 / _e2918);
            let _e2921 = (_e2905 / _e2918);
            let _e2924 = ((_e2912 * _e2921) - (_e2920 * _e2913));
            let _e2927 = ((_e2913 * _e2919) - (_e2921 * _e2911));
            let _e2930 = ((_e2911 * _e2920) - (_e2919 * _e2912));
            let _e2932 = p.member.eye;
            let _e2941 = (1f / sqrt((((_e2924 * _e2924) + (_e2927 * _e2927)) + (_e2930 * _e2930))));
            let _e2946 = lt_shaders_camera_facing(vec3<f32>((_e2924 * _e2941), (_e2927 * _e2941), (_e2930 * _e2941)), (_e2932 - vec3<f32>(_e2869, _e2870, _e2871)));
            if (_e2707.triangle < _e78) {
            } else {
                return;
            }
            let _e2951 = triangles.member[(0u + _e2707.triangle)];
            let _e2953 = (_e2951.i0_ & 2147483647u);
            if (_e2953 < _e81) {
            } else {
                return;
            }
            let _e2959 = vertices.member[(0u + _e2953)];
            if (_e2951.i1_ < _e81) {
            } else {
                return;
            }
            let _e2963 = vertices.member[(0u + _e2951.i1_)];
            if (_e2951.i2_ < _e81) {
            } else {
                return;
            }
            let _e2967 = vertices.member[(0u + _e2951.i2_)];
            let _e2968 = array<abi_Vertex, 3>(_e2959, _e2963, _e2967);
            local_1 = array<abi_Vertex, 3>(abi_Vertex(_e2968[0].u, _e2968[0].v, _e2968[0].normal, _e2968[0].color, _e2968[0].material), abi_Vertex(_e2968[1].u, _e2968[1].v, _e2968[1].normal, _e2968[1].color, _e2968[1].material), abi_Vertex(_e2968[2].u, _e2968[2].v, _e2968[2].normal, _e2968[2].color, _e2968[2].material));
            let _e2993 = local_1[0u].material;
            if (_e2993 < _e84) {
            } else {
                return;
            }
            let _e2997 = materials.member[(0u + _e2993)];
            local_2 = abi_Material(_e2997.base_color, _e2997.cutoff, _e2997.flags, _e2997.alpha_offset, _e2997.alpha_size, _e2997.color_offset, _e2997.color_size, _e2997.pad);
            let _e3007 = lt_shaders_surface_plain_color((&local_2), (&local_1), _e2712);
            let _e3009 = local_2.color_size;
            if (_e3009 == 0u) {
                phi_3862_ = vec3<f32>(1f, 1f, 1f);
            } else {
                let _e3012 = local_2.color_offset;
                let _e3014 = local_2.color_size;
                let _e3016 = local_2.flags;
                local.offset = _e3012;
                local.size = _e3014;
                local.flags = _e3016;
                let _e3020 = lt_shaders_surface_texture_coordinate((&local_1), _e2712);
                let _e3023 = _lt_shaders_texture_TextureView_quad((&local), _e3020.x, _e3020.y);
                if (_e3023.indices[0] < _e96) {
                } else {
                    return;
                }
                let _e3029 = color_texels.member[(0u + _e3023.indices[0])];
                let _e3030 = lt_shaders_texture_unorm_bytes(_e3029);
                if (_e3023.indices[1] < _e96) {
                } else {
                    return;
                }
                let _e3044 = color_texels.member[(0u + _e3023.indices[1])];
                let _e3045 = lt_shaders_texture_unorm_bytes(_e3044);
                if (_e3023.indices[2] < _e96) {
                } else {
                    return;
                }
                let _e3062 = color_texels.member[(0u + _e3023.indices[2])];
                let _e3063 = lt_shaders_texture_unorm_bytes(_e3062);
                if (_e3023.indices[3] < _e96) {
                } else {
                    return;
                }
                let _e3080 = color_texels.member[(0u + _e3023.indices[3])];
                let _e3081 = lt_shaders_texture_unorm_bytes(_e3080);
                let _e3090 = ((((_e3030.x * _e3023.weights.x) + (_e3045.x * _e3023.weights.y)) + (_e3063.x * _e3023.weights.z)) + (_e3081.x * _e3023.weights.w));
                let _e3091 = ((((_e3030.y * _e3023.weights.x) + (_e3045.y * _e3023.weights.y)) + (_e3063.y * _e3023.weights.z)) + (_e3081.y * _e3023.weights.w));
                let _e3092 = ((((_e3030.z * _e3023.weights.x) + (_e3045.z * _e3023.weights.y)) + (_e3063.z * _e3023.weights.z)) + (_e3081.z * _e3023.weights.w));
                phi_3862_ = vec3<f32>((_e3090 * _e3090), (_e3091 * _e3091), (_e3092 * _e3092));
            }
            let _e3098 = phi_3862_;
            let _e3100 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2896, _e2899);
            let _e3101 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2893, _e3100);
            let _e3103 = local_2.flags;
            if ((_e3103 & 2u) == 0u) {
                phi_3873_ = 0u;
            } else {
                phi_3873_ = 1u;
            }
            let _e3107 = phi_3873_;
            let _e3110 = local_1[0u].normal;
            if (_e3110 == 2147516416u) {
                phi_3973_ = _e2946;
            } else {
                let _e3114 = local_1[0u].normal;
                let _e3115 = lt_shaders_surface_octahedral_decode(_e3114);
                let _e3125 = local_1[1u].normal;
                let _e3126 = lt_shaders_surface_octahedral_decode(_e3125);
                let _e3139 = local_1[2u].normal;
                let _e3140 = lt_shaders_surface_octahedral_decode(_e3139);
                let _e3148 = (((_e3115.x * _e2712.x) + (_e3126.x * _e2712.y)) + (_e3140.x * _e2712.z));
                let _e3149 = (((_e3115.y * _e2712.x) + (_e3126.y * _e2712.y)) + (_e3140.y * _e2712.z));
                let _e3150 = (((_e3115.z * _e2712.x) + (_e3126.z * _e2712.y)) + (_e3140.z * _e2712.z));
                if (_e2707.instance < _e90) {
                } else {
                    return;
                }
                let _e3157 = instances.member[(0u + _e2707.instance)].world_to_object[0u];
                let _e3166 = instances.member[(0u + _e2707.instance)].world_to_object[1u];
                let _e3178 = instances.member[(0u + _e2707.instance)].world_to_object[2u];
                let _e3185 = (((_e3157.x * _e3148) + (_e3166.x * _e3149)) + (_e3178.x * _e3150));
                let _e3186 = (((_e3157.y * _e3148) + (_e3166.y * _e3149)) + (_e3178.y * _e3150));
                let _e3187 = (((_e3157.z * _e3148) + (_e3166.z * _e3149)) + (_e3178.z * _e3150));
                let _e3193 = sqrt((((_e3185 * _e3185) + (_e3186 * _e3186)) + (_e3187 * _e3187)));
                if (_e3193 > 0f) {
                    let _e3199 = lt_shaders_camera_facing(vec3<f32>((_e3185 / _e3193), (_e3186 / _e3193), (_e3187 / _e3193)), _e2946);
                    phi_3972_ = _e3199;
                } else {
                    phi_3972_ = _e2946;
                }
                let _e3201 = phi_3972_;
                phi_3973_ = _e3201;
            }
            let _e3203 = phi_3973_;
            let _e3204 = lt_shaders_shade_pack_albedo((_e3007 * _e3098));
            phi_3977_ = abi_Sample(vec3<f32>(_e2869, _e2870, _e2871), _e3101, _e2946, _e3107, _e3203, _e3204);
        } else {
            phi_3977_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3208 = phi_3977_;
        if (_e102.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e102.first_primitive)] = _e3208;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
