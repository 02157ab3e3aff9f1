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

fn lt_shaders_texture_unorm_bytes(param: u32) -> vec4<f32> {
    let _e77 = (1f / 255f);
    return vec4<f32>((f32((param & 255u)) * _e77), (f32(((param >> bitcast<u32>(8i)) & 255u)) * _e77), (f32(((param >> bitcast<u32>(16i)) & 255u)) * _e77), (f32((param >> bitcast<u32>(24i))) * _e77));
}

fn lt_shaders_surface_vertex_color(param_1: ptr<function, array<abi_Vertex, 3>>, param_2: vec3<f32>) -> vec4<f32> {
    let _e67 = (*param_1)[0u].color;
    let _e68 = lt_shaders_texture_unorm_bytes(_e67);
    let _e80 = (*param_1)[1u].color;
    let _e81 = lt_shaders_texture_unorm_bytes(_e80);
    let _e97 = (*param_1)[2u].color;
    let _e98 = lt_shaders_texture_unorm_bytes(_e97);
    return vec4<f32>((((_e68.x * param_2.x) + (_e81.x * param_2.y)) + (_e98.x * param_2.z)), (((_e68.y * param_2.x) + (_e81.y * param_2.y)) + (_e98.y * param_2.z)), (((_e68.z * param_2.x) + (_e81.z * param_2.y)) + (_e98.z * param_2.z)), (((_e68.w * param_2.x) + (_e81.w * param_2.y)) + (_e98.w * param_2.z)));
}

fn lt_shaders_surface_texture_coordinate(param_3: ptr<function, array<abi_Vertex, 3>>, param_4: vec3<f32>) -> vec2<f32> {
    let _e67 = (*param_3)[0u].u;
    let _e70 = (*param_3)[0u].v;
    let _e76 = (*param_3)[1u].u;
    let _e79 = (*param_3)[1u].v;
    let _e87 = (*param_3)[2u].u;
    let _e90 = (*param_3)[2u].v;
    return vec2<f32>((((_e67 * param_4.x) + (_e76 * param_4.y)) + (_e87 * param_4.z)), (((_e70 * param_4.x) + (_e79 * param_4.y)) + (_e90 * param_4.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_5: f32, param_6: u32) -> f32 {
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_489_: f32;
    var phi_498_: f32;
    var phi_499_: f32;

    if (param_6 == 0u) {
        phi_489_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e72 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e72 > 1f) {
                phi_487_ = (2f - _e72);
            } else {
                phi_487_ = _e72;
            }
            let _e76 = phi_487_;
            phi_488_ = _e76;
        } else {
            phi_488_ = param_5;
        }
        let _e78 = phi_488_;
        phi_489_ = _e78;
    }
    let _e80 = phi_489_;
    if (_e80 > 0f) {
        if (_e80 < 1f) {
            phi_498_ = _e80;
        } else {
            phi_498_ = 1f;
        }
        let _e84 = phi_498_;
        phi_499_ = _e84;
    } else {
        phi_499_ = 0f;
    }
    let _e86 = phi_499_;
    return _e86;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_425_: u32;
    var phi_439_: u32;
    var phi_446_: u32;
    var phi_451_: u32;
    var phi_457_: u32;
    var phi_462_: u32;
    var phi_464_: texture_Axis;

    let _e67 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e68 = (param_8 - 1u);
    let _e70 = (_e67 * f32(param_8));
    if param_10 {
        let _e77 = select(select(u32(_e70), 0u, (_e70 < bitcast<f32>(0u))), 4294967295u, (_e70 > bitcast<f32>(1333788671u)));
        if (_e68 < _e77) {
            phi_425_ = _e68;
        } else {
            phi_425_ = _e77;
        }
        let _e80 = phi_425_;
        phi_464_ = texture_Axis(_e80, _e80, 0f);
    } else {
        let _e82 = (_e70 + 0.5f);
        let _e89 = select(select(u32(_e82), 0u, (_e82 < bitcast<f32>(0u))), 4294967295u, (_e82 > bitcast<f32>(1333788671u)));
        if (param_8 < _e89) {
            phi_439_ = param_8;
        } else {
            phi_439_ = _e89;
        }
        let _e92 = phi_439_;
        if (param_9 == 0u) {
            phi_446_ = _e68;
        } else {
            phi_446_ = 0u;
        }
        let _e97 = phi_446_;
        if (param_9 == 0u) {
            phi_451_ = 0u;
        } else {
            phi_451_ = _e68;
        }
        let _e100 = phi_451_;
        if (_e92 == 0u) {
            phi_457_ = _e97;
        } else {
            phi_457_ = (_e92 - 1u);
        }
        let _e104 = phi_457_;
        if (_e92 > _e68) {
            phi_462_ = _e100;
        } else {
            phi_462_ = _e92;
        }
        let _e107 = phi_462_;
        phi_464_ = texture_Axis(_e104, _e107, (_e82 - f32(_e92)));
    }
    let _e110 = phi_464_;
    return _e110;
}

fn _lt_shaders_texture_TextureView_quad(param_11: ptr<function, texture_TextureView>, param_12: f32, param_13: f32) -> texture_TexelQuad {
    let _e67 = (*param_11).size;
    let _e68 = (_e67 & 65535u);
    let _e70 = (*param_11).size;
    let _e74 = (*param_11).flags;
    let _e76 = ((_e74 & 4u) != 0u);
    let _e78 = (*param_11).flags;
    let _e82 = lt_shaders_texture_axis(param_12, _e68, ((_e78 >> bitcast<u32>(4u)) & 3u), _e76);
    let _e84 = (*param_11).flags;
    let _e88 = lt_shaders_texture_axis(param_13, (_e70 >> bitcast<u32>(16i)), ((_e84 >> bitcast<u32>(6u)) & 3u), _e76);
    let _e92 = (*param_11).offset;
    let _e99 = (*param_11).offset;
    let _e106 = (*param_11).offset;
    let _e113 = (*param_11).offset;
    return texture_TexelQuad(array<u32, 4>(((_e92 + (_e88.low * _e68)) + _e82.low), ((_e99 + (_e88.low * _e68)) + _e82.high), ((_e106 + (_e88.high * _e68)) + _e82.low), ((_e113 + (_e88.high * _e68)) + _e82.high)), vec4<f32>(((1f - _e82.fraction) * (1f - _e88.fraction)), (_e82.fraction * (1f - _e88.fraction)), ((1f - _e82.fraction) * _e88.fraction), (_e82.fraction * _e88.fraction)));
}

fn lt_shaders_entry_pixel_index(param_14: vec3<u32>, param_15: u32, param_16: u32) -> lt_bvh_traverse_Tree {
    var phi_519_: lt_bvh_traverse_Tree;
    var phi_520_: bool;
    var phi_521_: lt_bvh_traverse_Tree;
    var phi_522_: bool;
    var phi_527_: lt_bvh_traverse_Tree;

    if (param_14.x < param_15) {
        if (param_14.y < param_16) {
            phi_519_ = lt_bvh_traverse_Tree(1u, ((param_14.y * param_15) + param_14.x));
            phi_520_ = false;
        } else {
            phi_519_ = lt_bvh_traverse_Tree();
            phi_520_ = true;
        }
        let _e76 = phi_519_;
        let _e78 = phi_520_;
        phi_521_ = _e76;
        phi_522_ = _e78;
    } else {
        phi_521_ = lt_bvh_traverse_Tree();
        phi_522_ = true;
    }
    let _e80 = phi_521_;
    let _e82 = phi_522_;
    if _e82 {
        phi_527_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_527_ = _e80;
    }
    let _e87 = phi_527_;
    return lt_bvh_traverse_Tree(_e87.root, _e87.first_primitive);
}

fn lt_shaders_shade_unit(param_17: f32) -> f32 {
    var phi_541_: f32;
    var phi_542_: f32;

    if (param_17 > 0f) {
        if (param_17 < 1f) {
            phi_541_ = param_17;
        } else {
            phi_541_ = 1f;
        }
        let _e67 = phi_541_;
        phi_542_ = _e67;
    } else {
        phi_542_ = 0f;
    }
    let _e69 = phi_542_;
    return _e69;
}

fn lt_shaders_shade_sqrt(param_18: f32) -> f32 {
    return sqrt(param_18);
}

fn lt_shaders_shade_pack_bytes(param_19: vec3<f32>) -> u32 {
    let _e66 = ((param_19.x * 255f) + 0.5f);
    let _e76 = ((param_19.y * 255f) + 0.5f);
    let _e89 = ((param_19.z * 255f) + 0.5f);
    return ((select(select(u32(_e66), 0u, (_e66 < bitcast<f32>(0u))), 4294967295u, (_e66 > bitcast<f32>(1333788671u))) | (select(select(u32(_e76), 0u, (_e76 < bitcast<f32>(0u))), 4294967295u, (_e76 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e89), 0u, (_e89 < bitcast<f32>(0u))), 4294967295u, (_e89 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i)));
}

fn _lt_bvh_ray_Ray_new(param_20: vec3<f32>, param_21: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_20, 0f, param_21, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_22: f32, param_23: f32) -> f32 {
    var phi_597_: bool;
    var phi_601_: f32;

    if (param_22 != param_22) {
        phi_597_ = true;
    } else {
        let _e66 = (param_23 >= param_22);
        if _e66 {
        }
        phi_597_ = _e66;
    }
    let _e68 = phi_597_;
    if _e68 {
        phi_601_ = param_23;
    } else {
        phi_601_ = param_22;
    }
    let _e70 = phi_601_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_24: f32, param_25: f32) -> f32 {
    var phi_613_: bool;
    var phi_617_: f32;

    if (param_24 != param_24) {
        phi_613_ = true;
    } else {
        let _e66 = (param_25 <= param_24);
        if _e66 {
        }
        phi_613_ = _e66;
    }
    let _e68 = phi_613_;
    if _e68 {
        phi_617_ = param_25;
    } else {
        phi_617_ = param_24;
    }
    let _e70 = phi_617_;
    return _e70;
}

fn lt_shaders_surface_barycentric_weights(param_26: f32, param_27: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_26) - param_27), param_26, param_27);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_28: f32, param_29: f32) -> f32 {
    var phi_631_: f32;

    if (param_28 > param_29) {
        phi_631_ = param_28;
    } else {
        phi_631_ = param_29;
    }
    let _e67 = phi_631_;
    return _e67;
}

fn lt_shaders_camera_facing(param_30: vec3<f32>, param_31: vec3<f32>) -> vec3<f32> {
    var phi_651_: vec3<f32>;

    if ((((param_30.x * param_31.x) + (param_30.y * param_31.y)) + (param_30.z * param_31.z)) < 0f) {
        phi_651_ = -(param_30);
    } else {
        phi_651_ = param_30;
    }
    let _e79 = phi_651_;
    return _e79;
}

fn lt_shaders_surface_plain_color(param_32: ptr<function, abi_Material>, param_33: ptr<function, array<abi_Vertex, 3>>, param_34: vec3<f32>) -> vec3<f32> {
    let _e67 = (*param_32).base_color;
    let _e71 = lt_shaders_surface_vertex_color(param_33, param_34);
    return vec3<f32>((_e67.x * _e71.x), (_e67.y * _e71.y), (_e67.z * _e71.z));
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_35: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn lt_shaders_surface_octahedral_decode(param_36: u32) -> vec3<f32> {
    var phi_693_: f32;
    var phi_700_: f32;
    var phi_707_: f32;

    let _e71 = (f32((bitcast<i32>((param_36 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e77 = (f32((bitcast<i32>(param_36) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e81 = ((1f - abs(_e71)) - abs(_e77));
    if (_e81 < 0f) {
        phi_693_ = -(_e81);
    } else {
        phi_693_ = 0f;
    }
    let _e85 = phi_693_;
    if (_e71 < 0f) {
        phi_700_ = (_e71 + _e85);
    } else {
        phi_700_ = (_e71 - _e85);
    }
    let _e90 = phi_700_;
    if (_e77 < 0f) {
        phi_707_ = (_e77 + _e85);
    } else {
        phi_707_ = (_e77 - _e85);
    }
    let _e95 = phi_707_;
    let _e102 = (1f / sqrt((((_e90 * _e90) + (_e95 * _e95)) + (_e81 * _e81))));
    return vec3<f32>((_e90 * _e102), (_e95 * _e102), (_e81 * _e102));
}

fn lt_shaders_shade_pack_albedo(param_37: vec3<f32>) -> u32 {
    let _e65 = lt_shaders_shade_unit(param_37.x);
    let _e66 = lt_shaders_shade_sqrt(_e65);
    let _e68 = lt_shaders_shade_unit(param_37.y);
    let _e69 = lt_shaders_shade_sqrt(_e68);
    let _e71 = lt_shaders_shade_unit(param_37.z);
    let _e72 = lt_shaders_shade_sqrt(_e71);
    let _e74 = lt_shaders_shade_pack_bytes(vec3<f32>(_e66, _e69, _e72));
    return _e74;
}

fn function_() {
    var local: array<abi_Vertex, 3>;
    var local_1: abi_Material;
    var local_2: texture_TextureView;
    var local_3: array<abi_Vertex, 3>;
    var local_4: lt_bvh_traverse_Stack;
    var local_5: lt_bvh_traverse_Stack;
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
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
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
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
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
    var phi_3777_: u32;
    var phi_3876_: vec3<f32>;
    var phi_3877_: vec3<f32>;
    var phi_3881_: abi_Sample;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;
    var local_14: lt_bvh_Hit;
    var local_15: lt_bvh_Hit;

    let _e69 = id_1;
    let _e73 = arrayLength((&nodes.member));
    let _e76 = arrayLength((&triangles.member));
    let _e79 = arrayLength((&vertices.member));
    let _e82 = arrayLength((&materials.member));
    let _e88 = arrayLength((&instances.member));
    let _e91 = arrayLength((&alpha_texels.member));
    let _e94 = p.member.size[0u];
    let _e96 = p.member.size[1u];
    let _e97 = lt_shaders_entry_pixel_index(_e69, _e94, _e96);
    if (bitcast<i32>(_e97.root) != 0i) {
        let _e103 = p.member.root;
        let _e107 = p.member.eye;
        let _e112 = p.member.size[0u];
        let _e116 = ((((f32(_e69.x) + 0.5f) / f32(_e112)) * 2f) - 1f);
        let _e121 = p.member.size[1u];
        let _e125 = (1f - (((f32(_e69.y) + 0.5f) / f32(_e121)) * 2f));
        let _e127 = p.member.forward;
        let _e129 = p.member.right;
        let _e143 = p.member.up;
        let _e154 = _lt_bvh_ray_Ray_new(_e107, vec3<f32>(((_e127.x + (_e129.x * _e116)) + (_e143.x * _e125)), ((_e127.y + (_e129.y * _e116)) + (_e143.y * _e125)), ((_e127.z + (_e129.z * _e116)) + (_e143.z * _e125))));
        let _e156 = lt_bvh_Hit(_e154.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e166 = abs(_e154.direction.x);
        let _e168 = abs(_e154.direction.y);
        let _e170 = abs(_e154.direction.z);
        if (abs(_e154.origin.x) < 1000000000000000f) {
            if (abs(_e154.origin.y) < 1000000000000000f) {
                if (abs(_e154.origin.z) < 1000000000000000f) {
                    if (_e166 < 1000000000000000f) {
                        if (_e168 < 1000000000000000f) {
                            if (_e170 < 1000000000000000f) {
                                if (_e166 > 0f) {
                                    phi_893_ = bool();
                                    phi_894_ = true;
                                } else {
                                    let _e178 = (_e168 > 0f);
                                    if _e178 {
                                        phi_892_ = bool();
                                    } else {
                                        phi_892_ = (_e170 > 0f);
                                    }
                                    let _e181 = phi_892_;
                                    phi_893_ = _e181;
                                    phi_894_ = _e178;
                                }
                                let _e183 = phi_893_;
                                let _e185 = phi_894_;
                                if _e185 {
                                    phi_898_ = true;
                                } else {
                                    phi_898_ = _e183;
                                }
                                let _e187 = phi_898_;
                                phi_899_ = _e187;
                                phi_900_ = false;
                            } else {
                                phi_899_ = bool();
                                phi_900_ = true;
                            }
                            let _e189 = phi_899_;
                            let _e191 = phi_900_;
                            phi_901_ = _e189;
                            phi_902_ = false;
                            phi_903_ = _e191;
                        } else {
                            phi_901_ = bool();
                            phi_902_ = true;
                            phi_903_ = false;
                        }
                        let _e193 = phi_901_;
                        let _e195 = phi_902_;
                        let _e197 = phi_903_;
                        phi_904_ = _e193;
                        phi_905_ = _e195;
                        phi_906_ = _e197;
                    } else {
                        phi_904_ = bool();
                        phi_905_ = true;
                        phi_906_ = false;
                    }
                    let _e199 = phi_904_;
                    let _e201 = phi_905_;
                    let _e203 = phi_906_;
                    phi_907_ = _e199;
                    phi_908_ = _e201;
                    phi_909_ = _e203;
                } else {
                    phi_907_ = bool();
                    phi_908_ = true;
                    phi_909_ = false;
                }
                let _e205 = phi_907_;
                let _e207 = phi_908_;
                let _e209 = phi_909_;
                phi_910_ = _e205;
                phi_911_ = _e207;
                phi_912_ = _e209;
            } else {
                phi_910_ = bool();
                phi_911_ = true;
                phi_912_ = false;
            }
            let _e211 = phi_910_;
            let _e213 = phi_911_;
            let _e215 = phi_912_;
            phi_913_ = _e211;
            phi_914_ = _e213;
            phi_915_ = _e215;
        } else {
            phi_913_ = bool();
            phi_914_ = true;
            phi_915_ = false;
        }
        let _e217 = phi_913_;
        let _e219 = phi_914_;
        let _e221 = phi_915_;
        if _e219 {
            phi_919_ = true;
        } else {
            phi_919_ = _e221;
        }
        let _e223 = phi_919_;
        if _e223 {
            phi_923_ = false;
        } else {
            phi_923_ = _e217;
        }
        let _e225 = phi_923_;
        if _e225 {
            let _e226 = (_e103 >= _e73);
            if _e226 {
                phi_3418_ = lt_bvh_Hit();
            } else {
                if (_e103 < _e73) {
                } else {
                    return;
                }
                let _e232 = nodes.member[(0u + _e103)].frame[0u];
                let _e236 = nodes.member[(0u + _e103)].frame[1u];
                let _e240 = nodes.member[(0u + _e103)].frame[2u];
                let _e244 = nodes.member[(0u + _e103)].frame[0u];
                let _e248 = nodes.member[(0u + _e103)].frame[1u];
                let _e252 = nodes.member[(0u + _e103)].frame[2u];
                let _e256 = nodes.member[(0u + _e103)].frame[3u];
                let _e294 = core_intrinsics_maximum_number_nsz_f32_(abs(_e154.direction.x), abs(_e154.direction.y));
                let _e295 = core_intrinsics_maximum_number_nsz_f32_(_e294, abs(_e154.direction.z));
                let _e296 = (_e295 * 0.0000000000009094947f);
                if (abs(_e154.direction.x) < _e296) {
                    phi_998_ = _e296;
                } else {
                    phi_998_ = abs(_e154.direction.x);
                }
                let _e303 = phi_998_;
                if (_e154.direction.x < 0f) {
                    phi_1005_ = (-1f / _e303);
                } else {
                    phi_1005_ = (1f / _e303);
                }
                let _e308 = phi_1005_;
                if (abs(_e154.direction.y) < _e296) {
                    phi_1013_ = _e296;
                } else {
                    phi_1013_ = abs(_e154.direction.y);
                }
                let _e315 = phi_1013_;
                if (_e154.direction.y < 0f) {
                    phi_1020_ = (-1f / _e315);
                } else {
                    phi_1020_ = (1f / _e315);
                }
                let _e320 = phi_1020_;
                if (abs(_e154.direction.z) < _e296) {
                    phi_1028_ = _e296;
                } else {
                    phi_1028_ = abs(_e154.direction.z);
                }
                let _e327 = phi_1028_;
                if (_e154.direction.z < 0f) {
                    phi_1035_ = (-1f / _e327);
                } else {
                    phi_1035_ = (1f / _e327);
                }
                let _e332 = phi_1035_;
                let _e340 = abs((bitcast<f32>(_e232) - _e154.origin.x));
                let _e341 = abs((bitcast<f32>(_e236) - _e154.origin.y));
                let _e342 = abs((bitcast<f32>(_e240) - _e154.origin.z));
                let _e350 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e256 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154.origin.x));
                let _e351 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e256 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154.origin.y));
                let _e352 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e256 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154.origin.z));
                if (_e340 > _e350) {
                    phi_1060_ = _e340;
                } else {
                    phi_1060_ = _e350;
                }
                let _e355 = phi_1060_;
                if (_e341 > _e351) {
                    phi_1065_ = _e341;
                } else {
                    phi_1065_ = _e351;
                }
                let _e358 = phi_1065_;
                if (_e342 > _e352) {
                    phi_1070_ = _e342;
                } else {
                    phi_1070_ = _e352;
                }
                let _e361 = phi_1070_;
                let _e362 = core_intrinsics_maximum_number_nsz_f32_(_e355, _e358);
                let _e363 = core_intrinsics_maximum_number_nsz_f32_(_e362, _e361);
                let _e368 = (_e363 * 0.0000019073486f);
                let _e369 = (abs(_e308) * _e368);
                let _e370 = (abs(_e320) * _e368);
                let _e371 = (abs(_e332) * _e368);
                let _e375 = (_e363 * 0.0000009536743f);
                let _e376 = (abs(_e308) * _e375);
                let _e377 = (abs(_e320) * _e375);
                let _e378 = (abs(_e332) * _e375);
                if (_e308 < 0f) {
                    phi_1092_ = 0u;
                } else {
                    phi_1092_ = 1u;
                }
                let _e381 = phi_1092_;
                if (_e320 < 0f) {
                    phi_1097_ = 0u;
                } else {
                    phi_1097_ = 2u;
                }
                let _e384 = phi_1097_;
                if (_e332 < 0f) {
                    phi_1102_ = 0u;
                } else {
                    phi_1102_ = 4u;
                }
                let _e387 = phi_1102_;
                let _e389 = ((_e381 | _e384) | _e387);
                let _e390 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e103, 2147483648u);
                local_5 = lt_bvh_traverse_Stack(array<u32, 32>(_e390.first[0], _e390.first[1], _e390.first[2], _e390.first[3], _e390.first[4], _e390.first[5], _e390.first[6], _e390.first[7], _e390.first[8], _e390.first[9], _e390.first[10], _e390.first[11], _e390.first[12], _e390.first[13], _e390.first[14], _e390.first[15], _e390.first[16], _e390.first[17], _e390.first[18], _e390.first[19], _e390.first[20], _e390.first[21], _e390.first[22], _e390.first[23], _e390.first[24], _e390.first[25], _e390.first[26], _e390.first[27], _e390.first[28], _e390.first[29], _e390.first[30], _e390.first[31]), array<u32, 32>(_e390.mask[0], _e390.mask[1], _e390.mask[2], _e390.mask[3], _e390.mask[4], _e390.mask[5], _e390.mask[6], _e390.mask[7], _e390.mask[8], _e390.mask[9], _e390.mask[10], _e390.mask[11], _e390.mask[12], _e390.mask[13], _e390.mask[14], _e390.mask[15], _e390.mask[16], _e390.mask[17], _e390.mask[18], _e390.mask[19], _e390.mask[20], _e390.mask[21], _e390.mask[22], _e390.mask[23], _e390.mask[24], _e390.mask[25], _e390.mask[26], _e390.mask[27], _e390.mask[28], _e390.mask[29], _e390.mask[30], _e390.mask[31]), _e390.len, _e390.group, _e390.group_mask);
                let _e464 = local_5.group_mask;
                if ((_e464 & 4278190080u) == 0u) {
                    let _e468 = local_5.len;
                    if (_e468 == 0u) {
                        phi_1216_ = false;
                    } else {
                        let _e472 = local_5.len;
                        local_5.len = (_e472 - 1u);
                        let _e475 = local_5.len;
                        if (_e475 < 32u) {
                        } else {
                            return;
                        }
                        let _e480 = local_5.first[(0u + _e475)];
                        local_5.group = _e480;
                        let _e483 = local_5.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_5.mask[(0u + _e483)];
                        local_5.group_mask = _e488;
                        phi_1216_ = true;
                    }
                    let _e491 = phi_1216_;
                    phi_1217_ = _e491;
                } else {
                    phi_1217_ = true;
                }
                let _e493 = phi_1217_;
                if _e493 {
                    let _e495 = local_5.group_mask;
                    let _e501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e495)), 32u, (_e495 == 0u)));
                    let _e505 = local_5.group_mask;
                    let _e519 = local_5.group_mask;
                    local_5.group_mask = (_e519 & ~((1u << bitcast<u32>((_e501 & 31u)))));
                    let _e522 = local_5.group;
                    phi_1248_ = (_e522 + countOneBits(((_e505 & ~((4294967295u << bitcast<u32>((((_e501 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1248_ = 4294967295u;
                }
                let _e525 = phi_1248_;
                phi_1250_ = _e525;
                phi_1253_ = _e156;
                loop {
                    let _e527 = phi_1250_;
                    let _e529 = phi_1253_;
                    local_15 = _e529;
                    let _e530 = (_e527 != 4294967295u);
                    if _e530 {
                        if (_e527 < _e73) {
                        } else {
                            return;
                        }
                        let _e538 = nodes.member[(0u + _e527)].frame[3u];
                        let _e563 = (bitcast<f32>((((_e538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e564 = (bitcast<f32>((((_e538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e320);
                        let _e565 = (bitcast<f32>((((_e538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e568 = nodes.member[(0u + _e527)].frame[0u];
                        let _e572 = nodes.member[(0u + _e527)].frame[1u];
                        let _e576 = nodes.member[(0u + _e527)].frame[2u];
                        let _e584 = ((bitcast<f32>(_e568) - _e154.origin.x) * _e308);
                        let _e585 = ((bitcast<f32>(_e572) - _e154.origin.y) * _e320);
                        let _e586 = ((bitcast<f32>(_e576) - _e154.origin.z) * _e332);
                        let _e594 = nodes.member[(0u + _e527)].x;
                        if (_e308 < 0f) {
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e605.unnamed.root, _e594.w), _e605.unnamed_1);
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_bvh_traverse_Tree(_e594.x, _e611.unnamed_1.first_primitive));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e617.unnamed, lt_bvh_traverse_Tree(_e617.unnamed_1.root, _e594.y));
                        } else {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.unnamed.root, _e594.y), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_bvh_traverse_Tree(_e594.z, _e639.unnamed_1.first_primitive));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e645.unnamed_1.root, _e594.w));
                        }
                        let _e653 = phi_1338_;
                        let _e663 = nodes.member[(0u + _e527)].y;
                        if (_e320 < 0f) {
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e674.unnamed.root, _e663.w), _e674.unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e663.x, _e680.unnamed_1.first_primitive));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e686.unnamed_1.root, _e663.y));
                        } else {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.unnamed.root, _e663.y), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_bvh_traverse_Tree(_e663.z, _e708.unnamed_1.first_primitive));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e714.unnamed_1.root, _e663.w));
                        }
                        let _e722 = phi_1365_;
                        let _e732 = nodes.member[(0u + _e527)].z;
                        if (_e332 < 0f) {
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e743.unnamed.root, _e732.w), _e743.unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e732.x, _e749.unnamed_1.first_primitive));
                            phi_1392_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_bvh_traverse_Tree(_e755.unnamed_1.root, _e732.y));
                        } else {
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e771.unnamed.root, _e732.y), _e771.unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_bvh_traverse_Tree(_e732.z, _e777.unnamed_1.first_primitive));
                            phi_1392_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_bvh_traverse_Tree(_e783.unnamed_1.root, _e732.w));
                        }
                        let _e791 = phi_1392_;
                        phi_1398_ = 0u;
                        phi_1401_ = 0u;
                        loop {
                            let _e801 = phi_1398_;
                            let _e803 = phi_1401_;
                            local_6 = _e803;
                            local_7 = _e803;
                            local_8 = _e803;
                            let _e804 = (_e801 < 8u);
                            if _e804 {
                                let _e806 = (_e801 >> bitcast<u32>(2i));
                                let _e807 = (_e801 & 3u);
                                if (_e806 == 0u) {
                                    phi_1415_ = _e653.unnamed.root;
                                } else {
                                    phi_1415_ = _e653.unnamed.first_primitive;
                                }
                                let _e810 = phi_1415_;
                                if (_e806 == 0u) {
                                    phi_1425_ = _e722.unnamed.root;
                                } else {
                                    phi_1425_ = _e722.unnamed.first_primitive;
                                }
                                let _e819 = phi_1425_;
                                if (_e806 == 0u) {
                                    phi_1435_ = _e791.unnamed.root;
                                } else {
                                    phi_1435_ = _e791.unnamed.first_primitive;
                                }
                                let _e828 = phi_1435_;
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)), ((f32(((_e819 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                let _e842 = core_intrinsics_maximum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 - _e371)));
                                if (_e806 == 0u) {
                                    phi_1453_ = _e653.unnamed_1.root;
                                } else {
                                    phi_1453_ = _e653.unnamed_1.first_primitive;
                                }
                                let _e845 = phi_1453_;
                                if (_e806 == 0u) {
                                    phi_1463_ = _e722.unnamed_1.root;
                                } else {
                                    phi_1463_ = _e722.unnamed_1.first_primitive;
                                }
                                let _e854 = phi_1463_;
                                if (_e806 == 0u) {
                                    phi_1473_ = _e791.unnamed_1.root;
                                } else {
                                    phi_1473_ = _e791.unnamed_1.first_primitive;
                                }
                                let _e863 = phi_1473_;
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e845 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)), ((f32(((_e854 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                let _e877 = core_intrinsics_minimum_number_nsz_f32_(_e876, ((f32(((_e863 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 + _e371)));
                                if (_e842 <= _e877) {
                                    if (_e842 <= _e529.t) {
                                        if (_e877 >= _e154.tmin) {
                                            if (_e806 == 0u) {
                                                let _e884 = nodes.member[(0u + _e527)].links[2u];
                                                phi_1509_ = _e884;
                                            } else {
                                                let _e887 = nodes.member[(0u + _e527)].links[3u];
                                                phi_1509_ = _e887;
                                            }
                                            let _e889 = phi_1509_;
                                            let _e894 = ((_e889 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u);
                                            let _e895 = (_e894 & 31u);
                                            if (_e895 >= 24u) {
                                                phi_1522_ = (24u + ((_e895 - 24u) ^ _e389));
                                            } else {
                                                phi_1522_ = _e895;
                                            }
                                            let _e901 = phi_1522_;
                                            phi_1527_ = (_e803 | ((_e894 >> bitcast<u32>(5i)) << bitcast<u32>((_e901 & 31u))));
                                        } else {
                                            phi_1527_ = _e803;
                                        }
                                        let _e909 = phi_1527_;
                                        phi_1528_ = _e909;
                                    } else {
                                        phi_1528_ = _e803;
                                    }
                                    let _e911 = phi_1528_;
                                    phi_1529_ = _e911;
                                } else {
                                    phi_1529_ = _e803;
                                }
                                let _e913 = phi_1529_;
                                phi_1399_ = (_e801 + 1u);
                                phi_1402_ = _e913;
                            } else {
                                phi_1399_ = u32();
                                phi_1402_ = u32();
                            }
                            let _e916 = phi_1399_;
                            let _e918 = phi_1402_;
                            continue;
                            continuing {
                                phi_1398_ = _e916;
                                phi_1401_ = _e918;
                                break if !(_e804);
                            }
                        }
                        let _e922 = nodes.member[(0u + _e527)].links[0u];
                        let _e926 = nodes.member[(0u + _e527)].frame[3u];
                        let _e930 = local_6;
                        if ((_e930 & 4278190080u) == 0u) {
                        } else {
                            let _e934 = local_5.group_mask;
                            if ((_e934 & 4278190080u) == 0u) {
                            } else {
                                let _e938 = local_5.len;
                                if (_e938 < 32u) {
                                    let _e941 = local_5.group;
                                    let _e943 = local_5.len;
                                    if (_e943 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_5.first[(0u + _e943)] = _e941;
                                    let _e949 = local_5.group_mask;
                                    let _e951 = local_5.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_5.mask[(0u + _e951)] = _e949;
                                    let _e958 = local_5.len;
                                    local_5.len = (_e958 + 1u);
                                }
                            }
                            local_5.group = (_e103 + _e922);
                            let _e962 = local_7;
                            local_5.group_mask = ((_e962 & 4278190080u) | (_e926 >> bitcast<u32>(24i)));
                        }
                        let _e967 = local_8;
                        phi_1587_ = (_e967 & 16777215u);
                        phi_1590_ = _e529;
                        loop {
                            let _e970 = phi_1587_;
                            let _e972 = phi_1590_;
                            local_14 = _e972;
                            if (_e970 == 0u) {
                                phi_1588_ = u32();
                                phi_1591_ = lt_bvh_Hit();
                                phi_3346_ = false;
                            } else {
                                let _e976 = nodes.member[(0u + _e527)].links[1u];
                                let _e980 = (_e976 + select(firstTrailingBit(_e970), 32u, (_e970 == 0u)));
                                if (_e980 < _e88) {
                                } else {
                                    return;
                                }
                                let _e987 = instances.member[(0u + _e980)].low_world;
                                let _e989 = instances.member[(0u + _e980)].high_world;
                                let _e999 = ((_e987.x - _e154.origin.x) * _e308);
                                let _e1000 = ((_e987.y - _e154.origin.y) * _e320);
                                let _e1001 = ((_e987.z - _e154.origin.z) * _e332);
                                let _e1011 = ((_e989.x - _e154.origin.x) * _e308);
                                let _e1012 = ((_e989.y - _e154.origin.y) * _e320);
                                let _e1013 = ((_e989.z - _e154.origin.z) * _e332);
                                if (_e999 < _e1011) {
                                    phi_1645_ = _e999;
                                } else {
                                    phi_1645_ = _e1011;
                                }
                                let _e1016 = phi_1645_;
                                if (_e1000 < _e1012) {
                                    phi_1650_ = _e1000;
                                } else {
                                    phi_1650_ = _e1012;
                                }
                                let _e1019 = phi_1650_;
                                if (_e1001 < _e1013) {
                                    phi_1655_ = _e1001;
                                } else {
                                    phi_1655_ = _e1013;
                                }
                                let _e1022 = phi_1655_;
                                if (_e999 > _e1011) {
                                    phi_1663_ = _e999;
                                } else {
                                    phi_1663_ = _e1011;
                                }
                                let _e1028 = phi_1663_;
                                if (_e1000 > _e1012) {
                                    phi_1668_ = _e1000;
                                } else {
                                    phi_1668_ = _e1012;
                                }
                                let _e1031 = phi_1668_;
                                if (_e1001 > _e1013) {
                                    phi_1673_ = _e1001;
                                } else {
                                    phi_1673_ = _e1013;
                                }
                                let _e1034 = phi_1673_;
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_((_e1016 - _e376), (_e1019 - _e377));
                                let _e1039 = core_intrinsics_maximum_number_nsz_f32_(_e1038, (_e1022 - _e378));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_((_e1028 + _e376), (_e1031 + _e377));
                                let _e1041 = core_intrinsics_minimum_number_nsz_f32_(_e1040, (_e1034 + _e378));
                                if (_e1039 <= _e1041) {
                                    if (_e1039 <= _e972.t) {
                                        if (_e1041 >= _e154.tmin) {
                                            let _e1053 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1064 = ((((_e1053.x * _e154.origin.x) + (_e1053.y * _e154.origin.y)) + (_e1053.z * _e154.origin.z)) + (_e1053.w * 1f));
                                            let _e1066 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1077 = ((((_e1066.x * _e154.origin.x) + (_e1066.y * _e154.origin.y)) + (_e1066.z * _e154.origin.z)) + (_e1066.w * 1f));
                                            let _e1079 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1090 = ((((_e1079.x * _e154.origin.x) + (_e1079.y * _e154.origin.y)) + (_e1079.z * _e154.origin.z)) + (_e1079.w * 1f));
                                            let _e1097 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1108 = ((((_e1097.x * _e154.direction.x) + (_e1097.y * _e154.direction.y)) + (_e1097.z * _e154.direction.z)) + (_e1097.w * 0f));
                                            let _e1110 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1121 = ((((_e1110.x * _e154.direction.x) + (_e1110.y * _e154.direction.y)) + (_e1110.z * _e154.direction.z)) + (_e1110.w * 0f));
                                            let _e1123 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1134 = ((((_e1123.x * _e154.direction.x) + (_e1123.y * _e154.direction.y)) + (_e1123.z * _e154.direction.z)) + (_e1123.w * 0f));
                                            let _e1138 = instances.member[(0u + _e980)].root;
                                            let _e1140 = instances.member[(0u + _e980)].first_triangle;
                                            let _e1144 = abs(_e1108);
                                            let _e1145 = abs(_e1121);
                                            let _e1146 = abs(_e1134);
                                            if (abs(_e1064) < 1000000000000000f) {
                                                if (abs(_e1077) < 1000000000000000f) {
                                                    if (abs(_e1090) < 1000000000000000f) {
                                                        if (_e1144 < 1000000000000000f) {
                                                            if (_e1145 < 1000000000000000f) {
                                                                if (_e1146 < 1000000000000000f) {
                                                                    if (_e1144 > 0f) {
                                                                        phi_1829_ = bool();
                                                                        phi_1830_ = true;
                                                                    } else {
                                                                        let _e1154 = (_e1145 > 0f);
                                                                        if _e1154 {
                                                                            phi_1828_ = bool();
                                                                        } else {
                                                                            phi_1828_ = (_e1146 > 0f);
                                                                        }
                                                                        let _e1157 = phi_1828_;
                                                                        phi_1829_ = _e1157;
                                                                        phi_1830_ = _e1154;
                                                                    }
                                                                    let _e1159 = phi_1829_;
                                                                    let _e1161 = phi_1830_;
                                                                    if _e1161 {
                                                                        phi_1834_ = true;
                                                                    } else {
                                                                        phi_1834_ = _e1159;
                                                                    }
                                                                    let _e1163 = phi_1834_;
                                                                    phi_1835_ = _e1163;
                                                                    phi_1836_ = false;
                                                                } else {
                                                                    phi_1835_ = bool();
                                                                    phi_1836_ = true;
                                                                }
                                                                let _e1165 = phi_1835_;
                                                                let _e1167 = phi_1836_;
                                                                phi_1837_ = _e1165;
                                                                phi_1838_ = false;
                                                                phi_1839_ = _e1167;
                                                            } else {
                                                                phi_1837_ = bool();
                                                                phi_1838_ = true;
                                                                phi_1839_ = false;
                                                            }
                                                            let _e1169 = phi_1837_;
                                                            let _e1171 = phi_1838_;
                                                            let _e1173 = phi_1839_;
                                                            phi_1840_ = _e1169;
                                                            phi_1841_ = _e1171;
                                                            phi_1842_ = _e1173;
                                                        } else {
                                                            phi_1840_ = bool();
                                                            phi_1841_ = true;
                                                            phi_1842_ = false;
                                                        }
                                                        let _e1175 = phi_1840_;
                                                        let _e1177 = phi_1841_;
                                                        let _e1179 = phi_1842_;
                                                        phi_1843_ = _e1175;
                                                        phi_1844_ = _e1177;
                                                        phi_1845_ = _e1179;
                                                    } else {
                                                        phi_1843_ = bool();
                                                        phi_1844_ = true;
                                                        phi_1845_ = false;
                                                    }
                                                    let _e1181 = phi_1843_;
                                                    let _e1183 = phi_1844_;
                                                    let _e1185 = phi_1845_;
                                                    phi_1846_ = _e1181;
                                                    phi_1847_ = _e1183;
                                                    phi_1848_ = _e1185;
                                                } else {
                                                    phi_1846_ = bool();
                                                    phi_1847_ = true;
                                                    phi_1848_ = false;
                                                }
                                                let _e1187 = phi_1846_;
                                                let _e1189 = phi_1847_;
                                                let _e1191 = phi_1848_;
                                                phi_1849_ = _e1187;
                                                phi_1850_ = _e1189;
                                                phi_1851_ = _e1191;
                                            } else {
                                                phi_1849_ = bool();
                                                phi_1850_ = true;
                                                phi_1851_ = false;
                                            }
                                            let _e1193 = phi_1849_;
                                            let _e1195 = phi_1850_;
                                            let _e1197 = phi_1851_;
                                            if _e1195 {
                                                phi_1855_ = true;
                                            } else {
                                                phi_1855_ = _e1197;
                                            }
                                            let _e1199 = phi_1855_;
                                            if _e1199 {
                                                phi_1859_ = false;
                                            } else {
                                                phi_1859_ = _e1193;
                                            }
                                            let _e1201 = phi_1859_;
                                            if _e1201 {
                                                let _e1202 = (_e1138 >= _e73);
                                                if _e1202 {
                                                    phi_3336_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1138 < _e73) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1208 = nodes.member[(0u + _e1138)].frame[0u];
                                                    let _e1212 = nodes.member[(0u + _e1138)].frame[1u];
                                                    let _e1216 = nodes.member[(0u + _e1138)].frame[2u];
                                                    let _e1220 = nodes.member[(0u + _e1138)].frame[0u];
                                                    let _e1224 = nodes.member[(0u + _e1138)].frame[1u];
                                                    let _e1228 = nodes.member[(0u + _e1138)].frame[2u];
                                                    let _e1232 = nodes.member[(0u + _e1138)].frame[3u];
                                                    let _e1266 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1108), abs(_e1121));
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1266, abs(_e1134));
                                                    let _e1268 = (_e1267 * 0.0000000000009094947f);
                                                    if (abs(_e1108) < _e1268) {
                                                        phi_1929_ = _e1268;
                                                    } else {
                                                        phi_1929_ = abs(_e1108);
                                                    }
                                                    let _e1273 = phi_1929_;
                                                    if (_e1108 < 0f) {
                                                        phi_1936_ = (-1f / _e1273);
                                                    } else {
                                                        phi_1936_ = (1f / _e1273);
                                                    }
                                                    let _e1278 = phi_1936_;
                                                    if (abs(_e1121) < _e1268) {
                                                        phi_1943_ = _e1268;
                                                    } else {
                                                        phi_1943_ = abs(_e1121);
                                                    }
                                                    let _e1283 = phi_1943_;
                                                    if (_e1121 < 0f) {
                                                        phi_1950_ = (-1f / _e1283);
                                                    } else {
                                                        phi_1950_ = (1f / _e1283);
                                                    }
                                                    let _e1288 = phi_1950_;
                                                    if (abs(_e1134) < _e1268) {
                                                        phi_1957_ = _e1268;
                                                    } else {
                                                        phi_1957_ = abs(_e1134);
                                                    }
                                                    let _e1293 = phi_1957_;
                                                    if (_e1134 < 0f) {
                                                        phi_1964_ = (-1f / _e1293);
                                                    } else {
                                                        phi_1964_ = (1f / _e1293);
                                                    }
                                                    let _e1298 = phi_1964_;
                                                    let _e1302 = abs((bitcast<f32>(_e1208) - _e1064));
                                                    let _e1303 = abs((bitcast<f32>(_e1212) - _e1077));
                                                    let _e1304 = abs((bitcast<f32>(_e1216) - _e1090));
                                                    let _e1308 = abs(((bitcast<f32>(_e1220) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1064));
                                                    let _e1309 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1077));
                                                    let _e1310 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1090));
                                                    if (_e1302 > _e1308) {
                                                        phi_1981_ = _e1302;
                                                    } else {
                                                        phi_1981_ = _e1308;
                                                    }
                                                    let _e1313 = phi_1981_;
                                                    if (_e1303 > _e1309) {
                                                        phi_1986_ = _e1303;
                                                    } else {
                                                        phi_1986_ = _e1309;
                                                    }
                                                    let _e1316 = phi_1986_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1991_ = _e1304;
                                                    } else {
                                                        phi_1991_ = _e1310;
                                                    }
                                                    let _e1319 = phi_1991_;
                                                    let _e1320 = core_intrinsics_maximum_number_nsz_f32_(_e1313, _e1316);
                                                    let _e1321 = core_intrinsics_maximum_number_nsz_f32_(_e1320, _e1319);
                                                    let _e1325 = (_e1321 * 0.0000019073486f);
                                                    let _e1326 = (abs(_e1278) * _e1325);
                                                    let _e1327 = (abs(_e1288) * _e1325);
                                                    let _e1328 = (abs(_e1298) * _e1325);
                                                    let _e1332 = (_e1321 * 0.0000009536743f);
                                                    let _e1333 = (abs(_e1278) * _e1332);
                                                    let _e1334 = (abs(_e1288) * _e1332);
                                                    let _e1335 = (abs(_e1298) * _e1332);
                                                    let _e1336 = abs(_e1108);
                                                    let _e1337 = abs(_e1121);
                                                    let _e1338 = abs(_e1134);
                                                    if (_e1336 >= _e1337) {
                                                        if (_e1336 >= _e1338) {
                                                            phi_2019_ = false;
                                                        } else {
                                                            phi_2019_ = true;
                                                        }
                                                        let _e1342 = phi_2019_;
                                                        phi_2020_ = _e1342;
                                                    } else {
                                                        phi_2020_ = true;
                                                    }
                                                    let _e1344 = phi_2020_;
                                                    if _e1344 {
                                                        if (_e1337 >= _e1338) {
                                                            phi_2028_ = 1u;
                                                        } else {
                                                            phi_2028_ = 2u;
                                                        }
                                                        let _e1347 = phi_2028_;
                                                        phi_2029_ = _e1347;
                                                    } else {
                                                        phi_2029_ = 0u;
                                                    }
                                                    let _e1349 = phi_2029_;
                                                    if (_e1349 == 0u) {
                                                        phi_2041_ = vec3<f32>(_e1121, _e1134, _e1108);
                                                    } else {
                                                        if (_e1349 == 1u) {
                                                            phi_2040_ = vec3<f32>(_e1134, _e1108, _e1121);
                                                        } else {
                                                            phi_2040_ = vec3<f32>(_e1108, _e1121, _e1134);
                                                        }
                                                        let _e1355 = phi_2040_;
                                                        phi_2041_ = _e1355;
                                                    }
                                                    let _e1357 = phi_2041_;
                                                    let _e1360 = (_e1357.x / _e1357.z);
                                                    let _e1363 = (_e1357.y / _e1357.z);
                                                    let _e1365 = (1f / _e1357.z);
                                                    if (_e1278 < 0f) {
                                                        phi_2054_ = 0u;
                                                    } else {
                                                        phi_2054_ = 1u;
                                                    }
                                                    let _e1368 = phi_2054_;
                                                    if (_e1288 < 0f) {
                                                        phi_2059_ = 0u;
                                                    } else {
                                                        phi_2059_ = 2u;
                                                    }
                                                    let _e1371 = phi_2059_;
                                                    if (_e1298 < 0f) {
                                                        phi_2064_ = 0u;
                                                    } else {
                                                        phi_2064_ = 4u;
                                                    }
                                                    let _e1374 = phi_2064_;
                                                    let _e1376 = ((_e1368 | _e1371) | _e1374);
                                                    let _e1377 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1138, 2147483648u);
                                                    local_4 = lt_bvh_traverse_Stack(array<u32, 32>(_e1377.first[0], _e1377.first[1], _e1377.first[2], _e1377.first[3], _e1377.first[4], _e1377.first[5], _e1377.first[6], _e1377.first[7], _e1377.first[8], _e1377.first[9], _e1377.first[10], _e1377.first[11], _e1377.first[12], _e1377.first[13], _e1377.first[14], _e1377.first[15], _e1377.first[16], _e1377.first[17], _e1377.first[18], _e1377.first[19], _e1377.first[20], _e1377.first[21], _e1377.first[22], _e1377.first[23], _e1377.first[24], _e1377.first[25], _e1377.first[26], _e1377.first[27], _e1377.first[28], _e1377.first[29], _e1377.first[30], _e1377.first[31]), array<u32, 32>(_e1377.mask[0], _e1377.mask[1], _e1377.mask[2], _e1377.mask[3], _e1377.mask[4], _e1377.mask[5], _e1377.mask[6], _e1377.mask[7], _e1377.mask[8], _e1377.mask[9], _e1377.mask[10], _e1377.mask[11], _e1377.mask[12], _e1377.mask[13], _e1377.mask[14], _e1377.mask[15], _e1377.mask[16], _e1377.mask[17], _e1377.mask[18], _e1377.mask[19], _e1377.mask[20], _e1377.mask[21], _e1377.mask[22], _e1377.mask[23], _e1377.mask[24], _e1377.mask[25], _e1377.mask[26], _e1377.mask[27], _e1377.mask[28], _e1377.mask[29], _e1377.mask[30], _e1377.mask[31]), _e1377.len, _e1377.group, _e1377.group_mask);
                                                    let _e1451 = local_4.group_mask;
                                                    if ((_e1451 & 4278190080u) == 0u) {
                                                        let _e1455 = local_4.len;
                                                        if (_e1455 == 0u) {
                                                            phi_2178_ = false;
                                                        } else {
                                                            let _e1459 = local_4.len;
                                                            local_4.len = (_e1459 - 1u);
                                                            let _e1462 = local_4.len;
                                                            if (_e1462 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1467 = local_4.first[(0u + _e1462)];
                                                            local_4.group = _e1467;
                                                            let _e1470 = local_4.len;
                                                            if (_e1470 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1475 = local_4.mask[(0u + _e1470)];
                                                            local_4.group_mask = _e1475;
                                                            phi_2178_ = true;
                                                        }
                                                        let _e1478 = phi_2178_;
                                                        phi_2179_ = _e1478;
                                                    } else {
                                                        phi_2179_ = true;
                                                    }
                                                    let _e1480 = phi_2179_;
                                                    if _e1480 {
                                                        let _e1482 = local_4.group_mask;
                                                        let _e1488 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1482)), 32u, (_e1482 == 0u)));
                                                        let _e1492 = local_4.group_mask;
                                                        let _e1506 = local_4.group_mask;
                                                        local_4.group_mask = (_e1506 & ~((1u << bitcast<u32>((_e1488 & 31u)))));
                                                        let _e1509 = local_4.group;
                                                        phi_2210_ = (_e1509 + countOneBits(((_e1492 & ~((4294967295u << bitcast<u32>((((_e1488 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2210_ = 4294967295u;
                                                    }
                                                    let _e1512 = phi_2210_;
                                                    phi_2212_ = _e972;
                                                    phi_2215_ = _e1512;
                                                    loop {
                                                        let _e1514 = phi_2212_;
                                                        let _e1516 = phi_2215_;
                                                        local_13 = _e1514;
                                                        let _e1517 = (_e1516 != 4294967295u);
                                                        if _e1517 {
                                                            if (_e1516 < _e73) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1524 = nodes.member[(0u + _e1516)].frame[3u];
                                                            let _e1549 = (bitcast<f32>((((_e1524 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1278);
                                                            let _e1550 = (bitcast<f32>((((_e1524 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1288);
                                                            let _e1551 = (bitcast<f32>((((_e1524 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1298);
                                                            let _e1554 = nodes.member[(0u + _e1516)].frame[0u];
                                                            let _e1558 = nodes.member[(0u + _e1516)].frame[1u];
                                                            let _e1562 = nodes.member[(0u + _e1516)].frame[2u];
                                                            let _e1567 = ((bitcast<f32>(_e1554) - _e1064) * _e1278);
                                                            let _e1568 = ((bitcast<f32>(_e1558) - _e1077) * _e1288);
                                                            let _e1569 = ((bitcast<f32>(_e1562) - _e1090) * _e1298);
                                                            let _e1577 = nodes.member[(0u + _e1516)].x;
                                                            if (_e1278 < 0f) {
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1577.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1588.unnamed.root, _e1577.w), _e1588.unnamed_1);
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1594.unnamed, lt_bvh_traverse_Tree(_e1577.x, _e1594.unnamed_1.first_primitive));
                                                                phi_2296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1600.unnamed, lt_bvh_traverse_Tree(_e1600.unnamed_1.root, _e1577.y));
                                                            } else {
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1577.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1616.unnamed.root, _e1577.y), _e1616.unnamed_1);
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1622.unnamed, lt_bvh_traverse_Tree(_e1577.z, _e1622.unnamed_1.first_primitive));
                                                                phi_2296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1628.unnamed, lt_bvh_traverse_Tree(_e1628.unnamed_1.root, _e1577.w));
                                                            }
                                                            let _e1636 = phi_2296_;
                                                            let _e1646 = nodes.member[(0u + _e1516)].y;
                                                            if (_e1288 < 0f) {
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1646.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1657.unnamed.root, _e1646.w), _e1657.unnamed_1);
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1663.unnamed, lt_bvh_traverse_Tree(_e1646.x, _e1663.unnamed_1.first_primitive));
                                                                phi_2323_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1669.unnamed, lt_bvh_traverse_Tree(_e1669.unnamed_1.root, _e1646.y));
                                                            } else {
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1646.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1685.unnamed.root, _e1646.y), _e1685.unnamed_1);
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1691.unnamed, lt_bvh_traverse_Tree(_e1646.z, _e1691.unnamed_1.first_primitive));
                                                                phi_2323_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1697.unnamed, lt_bvh_traverse_Tree(_e1697.unnamed_1.root, _e1646.w));
                                                            }
                                                            let _e1705 = phi_2323_;
                                                            let _e1715 = nodes.member[(0u + _e1516)].z;
                                                            if (_e1298 < 0f) {
                                                                let _e1726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1715.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1726.unnamed.root, _e1715.w), _e1726.unnamed_1);
                                                                let _e1738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1732.unnamed, lt_bvh_traverse_Tree(_e1715.x, _e1732.unnamed_1.first_primitive));
                                                                phi_2350_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1738.unnamed, lt_bvh_traverse_Tree(_e1738.unnamed_1.root, _e1715.y));
                                                            } else {
                                                                let _e1754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1715.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1754.unnamed.root, _e1715.y), _e1754.unnamed_1);
                                                                let _e1766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1760.unnamed, lt_bvh_traverse_Tree(_e1715.z, _e1760.unnamed_1.first_primitive));
                                                                phi_2350_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1766.unnamed, lt_bvh_traverse_Tree(_e1766.unnamed_1.root, _e1715.w));
                                                            }
                                                            let _e1774 = phi_2350_;
                                                            phi_2356_ = 0u;
                                                            phi_2359_ = 0u;
                                                            loop {
                                                                let _e1784 = phi_2356_;
                                                                let _e1786 = phi_2359_;
                                                                local_9 = _e1786;
                                                                local_10 = _e1786;
                                                                local_11 = _e1786;
                                                                let _e1787 = (_e1784 < 8u);
                                                                if _e1787 {
                                                                    let _e1789 = (_e1784 >> bitcast<u32>(2i));
                                                                    let _e1790 = (_e1784 & 3u);
                                                                    if (_e1789 == 0u) {
                                                                        phi_2373_ = _e1636.unnamed.root;
                                                                    } else {
                                                                        phi_2373_ = _e1636.unnamed.first_primitive;
                                                                    }
                                                                    let _e1793 = phi_2373_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_2383_ = _e1705.unnamed.root;
                                                                    } else {
                                                                        phi_2383_ = _e1705.unnamed.first_primitive;
                                                                    }
                                                                    let _e1802 = phi_2383_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_2393_ = _e1774.unnamed.root;
                                                                    } else {
                                                                        phi_2393_ = _e1774.unnamed.first_primitive;
                                                                    }
                                                                    let _e1811 = phi_2393_;
                                                                    let _e1824 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1793 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 - _e1326)), ((f32(((_e1802 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)));
                                                                    let _e1825 = core_intrinsics_maximum_number_nsz_f32_(_e1824, ((f32(((_e1811 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 - _e1328)));
                                                                    if (_e1789 == 0u) {
                                                                        phi_2411_ = _e1636.unnamed_1.root;
                                                                    } else {
                                                                        phi_2411_ = _e1636.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1828 = phi_2411_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_2421_ = _e1705.unnamed_1.root;
                                                                    } else {
                                                                        phi_2421_ = _e1705.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1837 = phi_2421_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_2431_ = _e1774.unnamed_1.root;
                                                                    } else {
                                                                        phi_2431_ = _e1774.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1846 = phi_2431_;
                                                                    let _e1859 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1828 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 + _e1326)), ((f32(((_e1837 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)));
                                                                    let _e1860 = core_intrinsics_minimum_number_nsz_f32_(_e1859, ((f32(((_e1846 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 + _e1328)));
                                                                    if (_e1825 <= _e1860) {
                                                                        if (_e1825 <= _e1514.t) {
                                                                            if (_e1860 >= _e154.tmin) {
                                                                                if (_e1789 == 0u) {
                                                                                    let _e1867 = nodes.member[(0u + _e1516)].links[2u];
                                                                                    phi_2467_ = _e1867;
                                                                                } else {
                                                                                    let _e1870 = nodes.member[(0u + _e1516)].links[3u];
                                                                                    phi_2467_ = _e1870;
                                                                                }
                                                                                let _e1872 = phi_2467_;
                                                                                let _e1877 = ((_e1872 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u);
                                                                                let _e1878 = (_e1877 & 31u);
                                                                                if (_e1878 >= 24u) {
                                                                                    phi_2480_ = (24u + ((_e1878 - 24u) ^ _e1376));
                                                                                } else {
                                                                                    phi_2480_ = _e1878;
                                                                                }
                                                                                let _e1884 = phi_2480_;
                                                                                phi_2485_ = (_e1786 | ((_e1877 >> bitcast<u32>(5i)) << bitcast<u32>((_e1884 & 31u))));
                                                                            } else {
                                                                                phi_2485_ = _e1786;
                                                                            }
                                                                            let _e1892 = phi_2485_;
                                                                            phi_2486_ = _e1892;
                                                                        } else {
                                                                            phi_2486_ = _e1786;
                                                                        }
                                                                        let _e1894 = phi_2486_;
                                                                        phi_2487_ = _e1894;
                                                                    } else {
                                                                        phi_2487_ = _e1786;
                                                                    }
                                                                    let _e1896 = phi_2487_;
                                                                    phi_2357_ = (_e1784 + 1u);
                                                                    phi_2360_ = _e1896;
                                                                } else {
                                                                    phi_2357_ = u32();
                                                                    phi_2360_ = u32();
                                                                }
                                                                let _e1899 = phi_2357_;
                                                                let _e1901 = phi_2360_;
                                                                continue;
                                                                continuing {
                                                                    phi_2356_ = _e1899;
                                                                    phi_2359_ = _e1901;
                                                                    break if !(_e1787);
                                                                }
                                                            }
                                                            let _e1905 = nodes.member[(0u + _e1516)].links[0u];
                                                            let _e1909 = nodes.member[(0u + _e1516)].frame[3u];
                                                            let _e1913 = local_9;
                                                            if ((_e1913 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1917 = local_4.group_mask;
                                                                if ((_e1917 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1921 = local_4.len;
                                                                    if (_e1921 < 32u) {
                                                                        let _e1924 = local_4.group;
                                                                        let _e1926 = local_4.len;
                                                                        if (_e1926 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_4.first[(0u + _e1926)] = _e1924;
                                                                        let _e1932 = local_4.group_mask;
                                                                        let _e1934 = local_4.len;
                                                                        if (_e1934 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_4.mask[(0u + _e1934)] = _e1932;
                                                                        let _e1941 = local_4.len;
                                                                        local_4.len = (_e1941 + 1u);
                                                                    }
                                                                }
                                                                local_4.group = (_e1138 + _e1905);
                                                                let _e1945 = local_10;
                                                                local_4.group_mask = ((_e1945 & 4278190080u) | (_e1909 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1950 = local_11;
                                                            phi_2545_ = _e1514;
                                                            phi_2548_ = (_e1950 & 16777215u);
                                                            loop {
                                                                let _e1953 = phi_2545_;
                                                                let _e1955 = phi_2548_;
                                                                local_12 = _e1953;
                                                                if (_e1955 == 0u) {
                                                                    phi_2546_ = lt_bvh_Hit();
                                                                    phi_2549_ = u32();
                                                                    phi_3264_ = false;
                                                                } else {
                                                                    let _e1959 = nodes.member[(0u + _e1516)].links[1u];
                                                                    let _e1964 = ((_e1140 + _e1959) + select(firstTrailingBit(_e1955), 32u, (_e1955 == 0u)));
                                                                    if (_e1964 < _e76) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1971 = triangles.member[(0u + _e1964)].v0_;
                                                                    let _e1973 = (_e1971.x - _e1064);
                                                                    let _e1975 = (_e1971.y - _e1077);
                                                                    let _e1977 = (_e1971.z - _e1090);
                                                                    if (_e1349 == 0u) {
                                                                        phi_2593_ = vec3<f32>(_e1975, _e1977, _e1973);
                                                                    } else {
                                                                        if (_e1349 == 1u) {
                                                                            phi_2592_ = vec3<f32>(_e1977, _e1973, _e1975);
                                                                        } else {
                                                                            phi_2592_ = (_e1971 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e1985 = phi_2592_;
                                                                        phi_2593_ = _e1985;
                                                                    }
                                                                    let _e1987 = phi_2593_;
                                                                    let _e1991 = (_e1987.x - (_e1360 * _e1987.z));
                                                                    let _e1995 = (_e1987.y - (_e1363 * _e1987.z));
                                                                    let _e1999 = triangles.member[(0u + _e1964)].v1_;
                                                                    let _e2001 = (_e1999.x - _e1064);
                                                                    let _e2003 = (_e1999.y - _e1077);
                                                                    let _e2005 = (_e1999.z - _e1090);
                                                                    if (_e1349 == 0u) {
                                                                        phi_2625_ = vec3<f32>(_e2003, _e2005, _e2001);
                                                                    } else {
                                                                        if (_e1349 == 1u) {
                                                                            phi_2624_ = vec3<f32>(_e2005, _e2001, _e2003);
                                                                        } else {
                                                                            phi_2624_ = (_e1999 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2013 = phi_2624_;
                                                                        phi_2625_ = _e2013;
                                                                    }
                                                                    let _e2015 = phi_2625_;
                                                                    let _e2019 = (_e2015.x - (_e1360 * _e2015.z));
                                                                    let _e2023 = (_e2015.y - (_e1363 * _e2015.z));
                                                                    let _e2027 = triangles.member[(0u + _e1964)].v2_;
                                                                    let _e2029 = (_e2027.x - _e1064);
                                                                    let _e2031 = (_e2027.y - _e1077);
                                                                    let _e2033 = (_e2027.z - _e1090);
                                                                    if (_e1349 == 0u) {
                                                                        phi_2657_ = vec3<f32>(_e2031, _e2033, _e2029);
                                                                    } else {
                                                                        if (_e1349 == 1u) {
                                                                            phi_2656_ = vec3<f32>(_e2033, _e2029, _e2031);
                                                                        } else {
                                                                            phi_2656_ = (_e2027 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2041 = phi_2656_;
                                                                        phi_2657_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2657_;
                                                                    let _e2047 = (_e2043.x - (_e1360 * _e2043.z));
                                                                    let _e2051 = (_e2043.y - (_e1363 * _e2043.z));
                                                                    if (_e2019 < _e2047) {
                                                                        phi_2678_ = true;
                                                                    } else {
                                                                        if (_e2019 == _e2047) {
                                                                            phi_2677_ = (_e2023 < _e2051);
                                                                        } else {
                                                                            phi_2677_ = false;
                                                                        }
                                                                        let _e2058 = phi_2677_;
                                                                        phi_2678_ = _e2058;
                                                                    }
                                                                    let _e2060 = phi_2678_;
                                                                    if _e2060 {
                                                                        phi_2682_ = _e2051;
                                                                        phi_2683_ = _e2047;
                                                                        phi_2684_ = _e2023;
                                                                        phi_2685_ = _e2019;
                                                                    } else {
                                                                        phi_2682_ = _e2023;
                                                                        phi_2683_ = _e2019;
                                                                        phi_2684_ = _e2051;
                                                                        phi_2685_ = _e2047;
                                                                    }
                                                                    let _e2062 = phi_2682_;
                                                                    let _e2064 = phi_2683_;
                                                                    let _e2066 = phi_2684_;
                                                                    let _e2068 = phi_2685_;
                                                                    let _e2071 = ((_e2068 * _e2062) - (_e2066 * _e2064));
                                                                    if _e2060 {
                                                                        phi_2693_ = -(_e2071);
                                                                    } else {
                                                                        phi_2693_ = _e2071;
                                                                    }
                                                                    let _e2074 = phi_2693_;
                                                                    if (_e2047 < _e1991) {
                                                                        phi_2704_ = true;
                                                                    } else {
                                                                        if (_e2047 == _e1991) {
                                                                            phi_2703_ = (_e2051 < _e1995);
                                                                        } else {
                                                                            phi_2703_ = false;
                                                                        }
                                                                        let _e2079 = phi_2703_;
                                                                        phi_2704_ = _e2079;
                                                                    }
                                                                    let _e2081 = phi_2704_;
                                                                    if _e2081 {
                                                                        phi_2708_ = _e1995;
                                                                        phi_2709_ = _e1991;
                                                                        phi_2710_ = _e2051;
                                                                        phi_2711_ = _e2047;
                                                                    } else {
                                                                        phi_2708_ = _e2051;
                                                                        phi_2709_ = _e2047;
                                                                        phi_2710_ = _e1995;
                                                                        phi_2711_ = _e1991;
                                                                    }
                                                                    let _e2083 = phi_2708_;
                                                                    let _e2085 = phi_2709_;
                                                                    let _e2087 = phi_2710_;
                                                                    let _e2089 = phi_2711_;
                                                                    let _e2092 = ((_e2089 * _e2083) - (_e2087 * _e2085));
                                                                    if _e2081 {
                                                                        phi_2719_ = -(_e2092);
                                                                    } else {
                                                                        phi_2719_ = _e2092;
                                                                    }
                                                                    let _e2095 = phi_2719_;
                                                                    if (_e1991 < _e2019) {
                                                                        phi_2730_ = true;
                                                                    } else {
                                                                        if (_e1991 == _e2019) {
                                                                            phi_2729_ = (_e1995 < _e2023);
                                                                        } else {
                                                                            phi_2729_ = false;
                                                                        }
                                                                        let _e2100 = phi_2729_;
                                                                        phi_2730_ = _e2100;
                                                                    }
                                                                    let _e2102 = phi_2730_;
                                                                    if _e2102 {
                                                                        phi_2734_ = _e2023;
                                                                        phi_2735_ = _e2019;
                                                                        phi_2736_ = _e1995;
                                                                        phi_2737_ = _e1991;
                                                                    } else {
                                                                        phi_2734_ = _e1995;
                                                                        phi_2735_ = _e1991;
                                                                        phi_2736_ = _e2023;
                                                                        phi_2737_ = _e2019;
                                                                    }
                                                                    let _e2104 = phi_2734_;
                                                                    let _e2106 = phi_2735_;
                                                                    let _e2108 = phi_2736_;
                                                                    let _e2110 = phi_2737_;
                                                                    let _e2113 = ((_e2110 * _e2104) - (_e2108 * _e2106));
                                                                    if _e2102 {
                                                                        phi_2745_ = -(_e2113);
                                                                    } else {
                                                                        phi_2745_ = _e2113;
                                                                    }
                                                                    let _e2116 = phi_2745_;
                                                                    if (_e2074 >= 0f) {
                                                                        if (_e2095 >= 0f) {
                                                                            if (_e2116 >= 0f) {
                                                                                phi_2760_ = ((_e2074 + _e2095) + _e2116);
                                                                                phi_2761_ = false;
                                                                            } else {
                                                                                phi_2760_ = f32();
                                                                                phi_2761_ = true;
                                                                            }
                                                                            let _e2123 = phi_2760_;
                                                                            let _e2125 = phi_2761_;
                                                                            phi_2762_ = _e2123;
                                                                            phi_2763_ = _e2125;
                                                                        } else {
                                                                            phi_2762_ = f32();
                                                                            phi_2763_ = true;
                                                                        }
                                                                        let _e2127 = phi_2762_;
                                                                        let _e2129 = phi_2763_;
                                                                        phi_2764_ = _e2127;
                                                                        phi_2765_ = _e2129;
                                                                    } else {
                                                                        phi_2764_ = f32();
                                                                        phi_2765_ = true;
                                                                    }
                                                                    let _e2131 = phi_2764_;
                                                                    let _e2133 = phi_2765_;
                                                                    if _e2133 {
                                                                        if (_e2074 <= 0f) {
                                                                            if (_e2095 <= 0f) {
                                                                                let _e2136 = (_e2116 <= 0f);
                                                                                if _e2136 {
                                                                                }
                                                                                phi_2783_ = ((_e2074 + _e2095) + _e2116);
                                                                                phi_2784_ = false;
                                                                                phi_2785_ = _e2136;
                                                                            } else {
                                                                                phi_2783_ = f32();
                                                                                phi_2784_ = true;
                                                                                phi_2785_ = false;
                                                                            }
                                                                            let _e2140 = phi_2783_;
                                                                            let _e2142 = phi_2784_;
                                                                            let _e2144 = phi_2785_;
                                                                            phi_2786_ = _e2140;
                                                                            phi_2787_ = _e2142;
                                                                            phi_2788_ = _e2144;
                                                                        } else {
                                                                            phi_2786_ = f32();
                                                                            phi_2787_ = true;
                                                                            phi_2788_ = false;
                                                                        }
                                                                        let _e2146 = phi_2786_;
                                                                        let _e2148 = phi_2787_;
                                                                        let _e2150 = phi_2788_;
                                                                        if _e2148 {
                                                                            phi_2792_ = false;
                                                                        } else {
                                                                            phi_2792_ = _e2150;
                                                                        }
                                                                        let _e2152 = phi_2792_;
                                                                        phi_2793_ = _e2146;
                                                                        phi_2794_ = _e2152;
                                                                    } else {
                                                                        phi_2793_ = _e2131;
                                                                        phi_2794_ = true;
                                                                    }
                                                                    let _e2154 = phi_2793_;
                                                                    let _e2156 = phi_2794_;
                                                                    if _e2156 {
                                                                        let _e2157 = (_e2154 == 0f);
                                                                        if _e2157 {
                                                                            phi_2992_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2163 = ((((_e2074 * (_e1365 * _e1987.z)) + (_e2095 * (_e1365 * _e2015.z))) + (_e2116 * (_e1365 * _e2043.z))) / _e2154);
                                                                            let _e2165 = triangles.member[(0u + _e1964)].v0_;
                                                                            let _e2167 = triangles.member[(0u + _e1964)].v1_;
                                                                            if (_e2165.x < _e2167.x) {
                                                                                phi_2820_ = _e2165.x;
                                                                            } else {
                                                                                phi_2820_ = _e2167.x;
                                                                            }
                                                                            let _e2174 = phi_2820_;
                                                                            if (_e2165.y < _e2167.y) {
                                                                                phi_2829_ = _e2165.y;
                                                                            } else {
                                                                                phi_2829_ = _e2167.y;
                                                                            }
                                                                            let _e2181 = phi_2829_;
                                                                            if (_e2165.z < _e2167.z) {
                                                                                phi_2838_ = _e2165.z;
                                                                            } else {
                                                                                phi_2838_ = _e2167.z;
                                                                            }
                                                                            let _e2188 = phi_2838_;
                                                                            let _e2190 = triangles.member[(0u + _e1964)].v2_;
                                                                            if (_e2174 < _e2190.x) {
                                                                                phi_2847_ = _e2174;
                                                                            } else {
                                                                                phi_2847_ = _e2190.x;
                                                                            }
                                                                            let _e2195 = phi_2847_;
                                                                            if (_e2181 < _e2190.y) {
                                                                                phi_2854_ = _e2181;
                                                                            } else {
                                                                                phi_2854_ = _e2190.y;
                                                                            }
                                                                            let _e2200 = phi_2854_;
                                                                            if (_e2188 < _e2190.z) {
                                                                                phi_2861_ = _e2188;
                                                                            } else {
                                                                                phi_2861_ = _e2190.z;
                                                                            }
                                                                            let _e2205 = phi_2861_;
                                                                            let _e2207 = triangles.member[(0u + _e1964)].v0_;
                                                                            let _e2209 = triangles.member[(0u + _e1964)].v1_;
                                                                            if (_e2207.x > _e2209.x) {
                                                                                phi_2874_ = _e2207.x;
                                                                            } else {
                                                                                phi_2874_ = _e2209.x;
                                                                            }
                                                                            let _e2216 = phi_2874_;
                                                                            if (_e2207.y > _e2209.y) {
                                                                                phi_2883_ = _e2207.y;
                                                                            } else {
                                                                                phi_2883_ = _e2209.y;
                                                                            }
                                                                            let _e2223 = phi_2883_;
                                                                            if (_e2207.z > _e2209.z) {
                                                                                phi_2892_ = _e2207.z;
                                                                            } else {
                                                                                phi_2892_ = _e2209.z;
                                                                            }
                                                                            let _e2230 = phi_2892_;
                                                                            let _e2232 = triangles.member[(0u + _e1964)].v2_;
                                                                            if (_e2216 > _e2232.x) {
                                                                                phi_2901_ = _e2216;
                                                                            } else {
                                                                                phi_2901_ = _e2232.x;
                                                                            }
                                                                            let _e2237 = phi_2901_;
                                                                            if (_e2223 > _e2232.y) {
                                                                                phi_2908_ = _e2223;
                                                                            } else {
                                                                                phi_2908_ = _e2232.y;
                                                                            }
                                                                            let _e2242 = phi_2908_;
                                                                            if (_e2230 > _e2232.z) {
                                                                                phi_2915_ = _e2230;
                                                                            } else {
                                                                                phi_2915_ = _e2232.z;
                                                                            }
                                                                            let _e2247 = phi_2915_;
                                                                            let _e2251 = ((_e2195 - _e1064) * _e1278);
                                                                            let _e2252 = ((_e2200 - _e1077) * _e1288);
                                                                            let _e2253 = ((_e2205 - _e1090) * _e1298);
                                                                            let _e2257 = ((_e2237 - _e1064) * _e1278);
                                                                            let _e2258 = ((_e2242 - _e1077) * _e1288);
                                                                            let _e2259 = ((_e2247 - _e1090) * _e1298);
                                                                            if (_e2251 < _e2257) {
                                                                                phi_2932_ = _e2251;
                                                                            } else {
                                                                                phi_2932_ = _e2257;
                                                                            }
                                                                            let _e2262 = phi_2932_;
                                                                            if (_e2252 < _e2258) {
                                                                                phi_2937_ = _e2252;
                                                                            } else {
                                                                                phi_2937_ = _e2258;
                                                                            }
                                                                            let _e2265 = phi_2937_;
                                                                            if (_e2253 < _e2259) {
                                                                                phi_2942_ = _e2253;
                                                                            } else {
                                                                                phi_2942_ = _e2259;
                                                                            }
                                                                            let _e2268 = phi_2942_;
                                                                            if (_e2251 > _e2257) {
                                                                                phi_2950_ = _e2251;
                                                                            } else {
                                                                                phi_2950_ = _e2257;
                                                                            }
                                                                            let _e2274 = phi_2950_;
                                                                            if (_e2252 > _e2258) {
                                                                                phi_2955_ = _e2252;
                                                                            } else {
                                                                                phi_2955_ = _e2258;
                                                                            }
                                                                            let _e2277 = phi_2955_;
                                                                            if (_e2253 > _e2259) {
                                                                                phi_2960_ = _e2253;
                                                                            } else {
                                                                                phi_2960_ = _e2259;
                                                                            }
                                                                            let _e2280 = phi_2960_;
                                                                            let _e2284 = core_intrinsics_maximum_number_nsz_f32_((_e2262 - _e1333), (_e2265 - _e1334));
                                                                            let _e2285 = core_intrinsics_maximum_number_nsz_f32_(_e2284, (_e2268 - _e1335));
                                                                            let _e2286 = core_intrinsics_minimum_number_nsz_f32_((_e2274 + _e1333), (_e2277 + _e1334));
                                                                            let _e2287 = core_intrinsics_minimum_number_nsz_f32_(_e2286, (_e2280 + _e1335));
                                                                            if (_e2285 > _e1039) {
                                                                                phi_2972_ = _e2285;
                                                                            } else {
                                                                                phi_2972_ = _e1039;
                                                                            }
                                                                            let _e2290 = phi_2972_;
                                                                            if (_e2287 < _e1041) {
                                                                                phi_2977_ = _e2287;
                                                                            } else {
                                                                                phi_2977_ = _e1041;
                                                                            }
                                                                            let _e2293 = phi_2977_;
                                                                            if (_e2163 < _e2290) {
                                                                                phi_2982_ = _e2290;
                                                                            } else {
                                                                                phi_2982_ = _e2163;
                                                                            }
                                                                            let _e2296 = phi_2982_;
                                                                            if (_e2296 > _e2293) {
                                                                                phi_2987_ = _e2293;
                                                                            } else {
                                                                                phi_2987_ = _e2296;
                                                                            }
                                                                            let _e2299 = phi_2987_;
                                                                            phi_2992_ = lt_bvh_triangle_Intersection(_e2299, (_e2095 / _e2154), (_e2116 / _e2154), (_e2290 <= _e2293));
                                                                        }
                                                                        let _e2305 = phi_2992_;
                                                                        phi_2993_ = _e2305;
                                                                        phi_2994_ = _e2157;
                                                                    } else {
                                                                        phi_2993_ = lt_bvh_triangle_Intersection();
                                                                        phi_2994_ = true;
                                                                    }
                                                                    let _e2307 = phi_2993_;
                                                                    let _e2309 = phi_2994_;
                                                                    if _e2309 {
                                                                        phi_2998_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2998_ = _e2307;
                                                                    }
                                                                    let _e2311 = phi_2998_;
                                                                    if _e2311.is_hit {
                                                                        if (_e2311.t > _e154.tmin) {
                                                                            if (_e2311.t < _e1953.t) {
                                                                                phi_3046_ = true;
                                                                            } else {
                                                                                if (_e2311.t == _e1953.t) {
                                                                                    if (_e1953.triangle != 4294967295u) {
                                                                                        if (_e1964 < _e1953.triangle) {
                                                                                            phi_3037_ = true;
                                                                                        } else {
                                                                                            if (_e1964 == _e1953.triangle) {
                                                                                                phi_3036_ = (_e980 < _e1953.instance);
                                                                                            } else {
                                                                                                phi_3036_ = false;
                                                                                            }
                                                                                            let _e2329 = phi_3036_;
                                                                                            phi_3037_ = _e2329;
                                                                                        }
                                                                                        let _e2331 = phi_3037_;
                                                                                        phi_3038_ = _e2331;
                                                                                        phi_3039_ = false;
                                                                                    } else {
                                                                                        phi_3038_ = bool();
                                                                                        phi_3039_ = true;
                                                                                    }
                                                                                    let _e2333 = phi_3038_;
                                                                                    let _e2335 = phi_3039_;
                                                                                    phi_3040_ = _e2333;
                                                                                    phi_3041_ = _e2335;
                                                                                } else {
                                                                                    phi_3040_ = bool();
                                                                                    phi_3041_ = true;
                                                                                }
                                                                                let _e2337 = phi_3040_;
                                                                                let _e2339 = phi_3041_;
                                                                                if _e2339 {
                                                                                    phi_3045_ = false;
                                                                                } else {
                                                                                    phi_3045_ = _e2337;
                                                                                }
                                                                                let _e2341 = phi_3045_;
                                                                                phi_3046_ = _e2341;
                                                                            }
                                                                            let _e2343 = phi_3046_;
                                                                            if _e2343 {
                                                                                let _e2345 = triangles.member[(0u + _e1964)].i0_;
                                                                                if ((_e2345 & 2147483648u) == 0u) {
                                                                                    phi_3252_ = true;
                                                                                } else {
                                                                                    if (_e1964 < _e76) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2354 = triangles.member[(0u + _e1964)].i0_;
                                                                                    let _e2355 = (_e2354 & 2147483647u);
                                                                                    let _e2357 = triangles.member[(0u + _e1964)].i1_;
                                                                                    let _e2359 = triangles.member[(0u + _e1964)].i2_;
                                                                                    if (_e2355 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2363 = vertices.member[(0u + _e2355)];
                                                                                    if (_e2357 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2367 = vertices.member[(0u + _e2357)];
                                                                                    if (_e2359 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2371 = vertices.member[(0u + _e2359)];
                                                                                    let _e2372 = array<abi_Vertex, 3>(_e2363, _e2367, _e2371);
                                                                                    local_3 = array<abi_Vertex, 3>(abi_Vertex(_e2372[0].u, _e2372[0].v, _e2372[0].normal, _e2372[0].color, _e2372[0].material), abi_Vertex(_e2372[1].u, _e2372[1].v, _e2372[1].normal, _e2372[1].color, _e2372[1].material), abi_Vertex(_e2372[2].u, _e2372[2].v, _e2372[2].normal, _e2372[2].color, _e2372[2].material));
                                                                                    let _e2397 = local_3[0u].material;
                                                                                    if (_e2397 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2401 = materials.member[(0u + _e2397)];
                                                                                    if ((_e2401.flags & 0u) == 0u) {
                                                                                        let _e2405 = lt_shaders_surface_barycentric_weights(_e2311.u, _e2311.v);
                                                                                        if (_e2401.cutoff <= 0f) {
                                                                                            phi_3247_ = true;
                                                                                        } else {
                                                                                            let _e2410 = lt_shaders_surface_vertex_color((&local_3), _e2405);
                                                                                            let _e2412 = (_e2401.base_color.w * _e2410.w);
                                                                                            if (_e2401.alpha_size == 0u) {
                                                                                                phi_3244_ = _e2412;
                                                                                            } else {
                                                                                                local_2.offset = _e2401.alpha_offset;
                                                                                                local_2.size = _e2401.alpha_size;
                                                                                                local_2.flags = _e2401.flags;
                                                                                                let _e2421 = lt_shaders_surface_texture_coordinate((&local_3), _e2405);
                                                                                                let _e2424 = _lt_shaders_texture_TextureView_quad((&local_2), _e2421.x, _e2421.y);
                                                                                                let _e2428 = (_e2424.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2428 < _e91) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2432 = alpha_texels.member[(0u + _e2428)];
                                                                                                let _e2448 = (_e2424.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2448 < _e91) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2452 = alpha_texels.member[(0u + _e2448)];
                                                                                                let _e2469 = (_e2424.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2469 < _e91) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2473 = alpha_texels.member[(0u + _e2469)];
                                                                                                let _e2490 = (_e2424.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2490 < _e91) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2494 = alpha_texels.member[(0u + _e2490)];
                                                                                                phi_3244_ = (_e2412 * (((((f32(((_e2432 >> bitcast<u32>((((_e2424.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2424.weights.x) + ((f32(((_e2452 >> bitcast<u32>((((_e2424.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2424.weights.y)) + ((f32(((_e2473 >> bitcast<u32>((((_e2424.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2424.weights.z)) + ((f32(((_e2494 >> bitcast<u32>((((_e2424.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2424.weights.w)));
                                                                                            }
                                                                                            let _e2510 = phi_3244_;
                                                                                            phi_3247_ = (_e2510 >= _e2401.cutoff);
                                                                                        }
                                                                                        let _e2514 = phi_3247_;
                                                                                        phi_3248_ = _e2514;
                                                                                    } else {
                                                                                        phi_3248_ = false;
                                                                                    }
                                                                                    let _e2516 = phi_3248_;
                                                                                    if _e2516 {
                                                                                    }
                                                                                    phi_3252_ = _e2516;
                                                                                }
                                                                                let _e2518 = phi_3252_;
                                                                                if _e2518 {
                                                                                    phi_3260_ = lt_bvh_Hit(_e2311.t, _e2311.u, _e2311.v, _e1964, _e980);
                                                                                } else {
                                                                                    phi_3260_ = _e1953;
                                                                                }
                                                                                let _e2524 = phi_3260_;
                                                                                phi_3261_ = _e2524;
                                                                            } else {
                                                                                phi_3261_ = _e1953;
                                                                            }
                                                                            let _e2526 = phi_3261_;
                                                                            phi_3262_ = _e2526;
                                                                        } else {
                                                                            phi_3262_ = _e1953;
                                                                        }
                                                                        let _e2528 = phi_3262_;
                                                                        phi_3263_ = _e2528;
                                                                    } else {
                                                                        phi_3263_ = _e1953;
                                                                    }
                                                                    let _e2530 = phi_3263_;
                                                                    phi_2546_ = _e2530;
                                                                    phi_2549_ = (_e1955 & (_e1955 - 1u));
                                                                    phi_3264_ = true;
                                                                }
                                                                let _e2532 = phi_2546_;
                                                                let _e2534 = phi_2549_;
                                                                let _e2536 = phi_3264_;
                                                                continue;
                                                                continuing {
                                                                    phi_2545_ = _e2532;
                                                                    phi_2548_ = _e2534;
                                                                    break if !(_e2536);
                                                                }
                                                            }
                                                            let _e2539 = local_4.group_mask;
                                                            if ((_e2539 & 4278190080u) == 0u) {
                                                                let _e2543 = local_4.len;
                                                                if (_e2543 == 0u) {
                                                                    phi_3303_ = false;
                                                                } else {
                                                                    let _e2547 = local_4.len;
                                                                    local_4.len = (_e2547 - 1u);
                                                                    let _e2550 = local_4.len;
                                                                    if (_e2550 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2555 = local_4.first[(0u + _e2550)];
                                                                    local_4.group = _e2555;
                                                                    let _e2558 = local_4.len;
                                                                    if (_e2558 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2563 = local_4.mask[(0u + _e2558)];
                                                                    local_4.group_mask = _e2563;
                                                                    phi_3303_ = true;
                                                                }
                                                                let _e2566 = phi_3303_;
                                                                phi_3304_ = _e2566;
                                                            } else {
                                                                phi_3304_ = true;
                                                            }
                                                            let _e2568 = phi_3304_;
                                                            if _e2568 {
                                                                let _e2570 = local_4.group_mask;
                                                                let _e2576 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2570)), 32u, (_e2570 == 0u)));
                                                                let _e2580 = local_4.group_mask;
                                                                let _e2594 = local_4.group_mask;
                                                                local_4.group_mask = (_e2594 & ~((1u << bitcast<u32>((_e2576 & 31u)))));
                                                                let _e2597 = local_4.group;
                                                                phi_3335_ = (_e2597 + countOneBits(((_e2580 & ~((4294967295u << bitcast<u32>((((_e2576 - 24u) ^ _e1376) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3335_ = 4294967295u;
                                                            }
                                                            let _e2600 = phi_3335_;
                                                            let _e3347 = local_12;
                                                            phi_2213_ = _e3347;
                                                            phi_2216_ = _e2600;
                                                        } else {
                                                            phi_2213_ = lt_bvh_Hit();
                                                            phi_2216_ = u32();
                                                        }
                                                        let _e2602 = phi_2213_;
                                                        let _e2604 = phi_2216_;
                                                        continue;
                                                        continuing {
                                                            phi_2212_ = _e2602;
                                                            phi_2215_ = _e2604;
                                                            break if !(_e1517);
                                                        }
                                                    }
                                                    let _e3351 = local_13;
                                                    phi_3336_ = _e3351;
                                                }
                                                let _e2607 = phi_3336_;
                                                phi_3337_ = _e2607;
                                                phi_3338_ = _e1202;
                                            } else {
                                                phi_3337_ = lt_bvh_Hit();
                                                phi_3338_ = true;
                                            }
                                            let _e2609 = phi_3337_;
                                            let _e2611 = phi_3338_;
                                            if _e2611 {
                                                phi_3342_ = _e972;
                                            } else {
                                                phi_3342_ = _e2609;
                                            }
                                            let _e2613 = phi_3342_;
                                            phi_3343_ = _e2613;
                                        } else {
                                            phi_3343_ = _e972;
                                        }
                                        let _e2615 = phi_3343_;
                                        phi_3344_ = _e2615;
                                    } else {
                                        phi_3344_ = _e972;
                                    }
                                    let _e2617 = phi_3344_;
                                    phi_3345_ = _e2617;
                                } else {
                                    phi_3345_ = _e972;
                                }
                                let _e2619 = phi_3345_;
                                phi_1588_ = (_e970 & (_e970 - 1u));
                                phi_1591_ = _e2619;
                                phi_3346_ = true;
                            }
                            let _e2621 = phi_1588_;
                            let _e2623 = phi_1591_;
                            let _e2625 = phi_3346_;
                            continue;
                            continuing {
                                phi_1587_ = _e2621;
                                phi_1590_ = _e2623;
                                break if !(_e2625);
                            }
                        }
                        let _e2628 = local_5.group_mask;
                        if ((_e2628 & 4278190080u) == 0u) {
                            let _e2632 = local_5.len;
                            if (_e2632 == 0u) {
                                phi_3385_ = false;
                            } else {
                                let _e2636 = local_5.len;
                                local_5.len = (_e2636 - 1u);
                                let _e2639 = local_5.len;
                                if (_e2639 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2644 = local_5.first[(0u + _e2639)];
                                local_5.group = _e2644;
                                let _e2647 = local_5.len;
                                if (_e2647 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2652 = local_5.mask[(0u + _e2647)];
                                local_5.group_mask = _e2652;
                                phi_3385_ = true;
                            }
                            let _e2655 = phi_3385_;
                            phi_3386_ = _e2655;
                        } else {
                            phi_3386_ = true;
                        }
                        let _e2657 = phi_3386_;
                        if _e2657 {
                            let _e2659 = local_5.group_mask;
                            let _e2665 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2659)), 32u, (_e2659 == 0u)));
                            let _e2669 = local_5.group_mask;
                            let _e2683 = local_5.group_mask;
                            local_5.group_mask = (_e2683 & ~((1u << bitcast<u32>((_e2665 & 31u)))));
                            let _e2686 = local_5.group;
                            phi_3417_ = (_e2686 + countOneBits(((_e2669 & ~((4294967295u << bitcast<u32>((((_e2665 - 24u) ^ _e389) & 31u))))) & 255u)));
                        } else {
                            phi_3417_ = 4294967295u;
                        }
                        let _e2689 = phi_3417_;
                        phi_1251_ = _e2689;
                        let _e3367 = local_14;
                        phi_1254_ = _e3367;
                    } else {
                        phi_1251_ = u32();
                        phi_1254_ = lt_bvh_Hit();
                    }
                    let _e2691 = phi_1251_;
                    let _e2693 = phi_1254_;
                    continue;
                    continuing {
                        phi_1250_ = _e2691;
                        phi_1253_ = _e2693;
                        break if !(_e530);
                    }
                }
                let _e3370 = local_15;
                phi_3418_ = _e3370;
            }
            let _e2696 = phi_3418_;
            phi_3419_ = _e2696;
            phi_3420_ = _e226;
        } else {
            phi_3419_ = lt_bvh_Hit();
            phi_3420_ = true;
        }
        let _e2698 = phi_3419_;
        let _e2700 = phi_3420_;
        if _e2700 {
            phi_3424_ = _e156;
        } else {
            phi_3424_ = _e2698;
        }
        let _e2702 = phi_3424_;
        if (_e2702.triangle != 4294967295u) {
            let _e2707 = lt_shaders_surface_barycentric_weights(_e2702.u, _e2702.v);
            if (_e2702.triangle < _e76) {
            } else {
                return;
            }
            let _e2712 = triangles.member[(0u + _e2702.triangle)];
            if (_e2702.instance < _e88) {
            } else {
                return;
            }
            let _e2723 = instances.member[(0u + _e2702.instance)].object_to_world[0u];
            let _e2734 = ((((_e2723.x * _e2712.v0_.x) + (_e2723.y * _e2712.v0_.y)) + (_e2723.z * _e2712.v0_.z)) + (_e2723.w * 1f));
            let _e2736 = instances.member[(0u + _e2702.instance)].object_to_world[1u];
            let _e2747 = ((((_e2736.x * _e2712.v0_.x) + (_e2736.y * _e2712.v0_.y)) + (_e2736.z * _e2712.v0_.z)) + (_e2736.w * 1f));
            let _e2749 = instances.member[(0u + _e2702.instance)].object_to_world[2u];
            let _e2760 = ((((_e2749.x * _e2712.v0_.x) + (_e2749.y * _e2712.v0_.y)) + (_e2749.z * _e2712.v0_.z)) + (_e2749.w * 1f));
            let _e2767 = instances.member[(0u + _e2702.instance)].object_to_world[0u];
            let _e2778 = ((((_e2767.x * _e2712.v1_.x) + (_e2767.y * _e2712.v1_.y)) + (_e2767.z * _e2712.v1_.z)) + (_e2767.w * 1f));
            let _e2780 = instances.member[(0u + _e2702.instance)].object_to_world[1u];
            let _e2791 = ((((_e2780.x * _e2712.v1_.x) + (_e2780.y * _e2712.v1_.y)) + (_e2780.z * _e2712.v1_.z)) + (_e2780.w * 1f));
            let _e2793 = instances.member[(0u + _e2702.instance)].object_to_world[2u];
            let _e2804 = ((((_e2793.x * _e2712.v1_.x) + (_e2793.y * _e2712.v1_.y)) + (_e2793.z * _e2712.v1_.z)) + (_e2793.w * 1f));
            let _e2811 = instances.member[(0u + _e2702.instance)].object_to_world[0u];
            let _e2822 = ((((_e2811.x * _e2712.v2_.x) + (_e2811.y * _e2712.v2_.y)) + (_e2811.z * _e2712.v2_.z)) + (_e2811.w * 1f));
            let _e2824 = instances.member[(0u + _e2702.instance)].object_to_world[1u];
            let _e2835 = ((((_e2824.x * _e2712.v2_.x) + (_e2824.y * _e2712.v2_.y)) + (_e2824.z * _e2712.v2_.z)) + (_e2824.w * 1f));
            let _e2837 = instances.member[(0u + _e2702.instance)].object_to_world[2u];
            let _e2848 = ((((_e2837.x * _e2712.v2_.x) + (_e2837.y * _e2712.v2_.y)) + (_e2837.z * _e2712.v2_.z)) + (_e2837.w * 1f));
            let _e2864 = (((_e2734 * _e2707.x) + (_e2778 * _e2707.y)) + (_e2822 * _e2707.z));
            let _e2865 = (((_e2747 * _e2707.x) + (_e2791 * _e2707.y)) + (_e2835 * _e2707.z));
            let _e2866 = (((_e2760 * _e2707.x) + (_e2804 * _e2707.y)) + (_e2848 * _e2707.z));
            let _e2868 = abs(_e2734);
            let _e2869 = abs(_e2747);
            let _e2870 = abs(_e2760);
            let _e2871 = abs(_e2778);
            let _e2872 = abs(_e2791);
            let _e2873 = abs(_e2804);
            if (_e2868 > _e2871) {
                phi_3613_ = _e2868;
            } else {
                phi_3613_ = _e2871;
            }
            let _e2876 = phi_3613_;
            if (_e2869 > _e2872) {
                phi_3618_ = _e2869;
            } else {
                phi_3618_ = _e2872;
            }
            let _e2879 = phi_3618_;
            if (_e2870 > _e2873) {
                phi_3623_ = _e2870;
            } else {
                phi_3623_ = _e2873;
            }
            let _e2882 = phi_3623_;
            let _e2883 = abs(_e2822);
            let _e2884 = abs(_e2835);
            let _e2885 = abs(_e2848);
            if (_e2876 > _e2883) {
                phi_3631_ = _e2876;
            } else {
                phi_3631_ = _e2883;
            }
            let _e2888 = phi_3631_;
            if (_e2879 > _e2884) {
                phi_3636_ = _e2879;
            } else {
                phi_3636_ = _e2884;
            }
            let _e2891 = phi_3636_;
            if (_e2882 > _e2885) {
                phi_3641_ = _e2882;
            } else {
                phi_3641_ = _e2885;
            }
            let _e2894 = phi_3641_;
            let _e2895 = (_e2778 - _e2734);
            let _e2896 = (_e2791 - _e2747);
            let _e2897 = (_e2804 - _e2760);
            let _e2898 = (_e2822 - _e2734);
            let _e2899 = (_e2835 - _e2747);
            let _e2900 = (_e2848 - _e2760);
            let _e2904 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2896), abs(_e2897));
            let _e2905 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2895), _e2904);
            let _e2906 = (_e2895 / _e2905);
            let _e2907 = (_e2896 / _e2905);
            let _e2908 = (_e2897 / _e2905);
            let _e2912 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2899), abs(_e2900));
            let _e2913 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2898), _e2912);
            let _e2914 = (_e2898 / _e2913);
            let _e2915 = (_e2899 / _e2913);
            let _e2916 = (_e2900 / _e2913);
            let _e2919 = ((_e2907 * _e2916) - (_e2915 * _e2908));
            let _e2922 = ((_e2908 * _e2914) - (_e2916 * _e2906));
            let _e2925 = ((_e2906 * _e2915) - (_e2914 * _e2907));
            let _e2927 = p.member.eye;
            let _e2936 = (1f / sqrt((((_e2919 * _e2919) + (_e2922 * _e2922)) + (_e2925 * _e2925))));
            let _e2941 = lt_shaders_camera_facing(vec3<f32>((_e2919 * _e2936), (_e2922 * _e2936), (_e2925 * _e2936)), (_e2927 - vec3<f32>(_e2864, _e2865, _e2866)));
            if (_e2702.triangle < _e76) {
            } else {
                return;
            }
            let _e2946 = triangles.member[(0u + _e2702.triangle)];
            let _e2948 = (_e2946.i0_ & 2147483647u);
            if (_e2948 < _e79) {
            } else {
                return;
            }
            let _e2954 = vertices.member[(0u + _e2948)];
            if (_e2946.i1_ < _e79) {
            } else {
                return;
            }
            let _e2958 = vertices.member[(0u + _e2946.i1_)];
            if (_e2946.i2_ < _e79) {
            } else {
                return;
            }
            let _e2962 = vertices.member[(0u + _e2946.i2_)];
            let _e2963 = array<abi_Vertex, 3>(_e2954, _e2958, _e2962);
            local = array<abi_Vertex, 3>(abi_Vertex(_e2963[0].u, _e2963[0].v, _e2963[0].normal, _e2963[0].color, _e2963[0].material), abi_Vertex(_e2963[1].u, _e2963[1].v, _e2963[1].normal, _e2963[1].color, _e2963[1].material), abi_Vertex(_e2963[2].u, _e2963[2].v, _e2963[2].normal, _e2963[2].color, _e2963[2].material));
            let _e2988 = local[0u].material;
            if (_e2988 < _e82) {
            } else {
                return;
            }
            let _e2992 = materials.member[(0u + _e2988)];
            local_1 = abi_Material(_e2992.base_color, _e2992.cutoff, _e2992.flags, _e2992.alpha_offset, _e2992.alpha_size, _e2992.color_offset, _e2992.color_size, _e2992.pad);
            let _e3002 = lt_shaders_surface_plain_color((&local_1), (&local), _e2707);
            let _e3003 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(_e2707);
            let _e3005 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2891, _e2894);
            let _e3006 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2888, _e3005);
            let _e3008 = local_1.flags;
            if ((_e3008 & 2u) == 0u) {
                phi_3777_ = 0u;
            } else {
                phi_3777_ = 1u;
            }
            let _e3012 = phi_3777_;
            let _e3015 = local[0u].normal;
            if (_e3015 == 2147516416u) {
                phi_3877_ = _e2941;
            } else {
                let _e3019 = local[0u].normal;
                let _e3020 = lt_shaders_surface_octahedral_decode(_e3019);
                let _e3030 = local[1u].normal;
                let _e3031 = lt_shaders_surface_octahedral_decode(_e3030);
                let _e3044 = local[2u].normal;
                let _e3045 = lt_shaders_surface_octahedral_decode(_e3044);
                let _e3053 = (((_e3020.x * _e2707.x) + (_e3031.x * _e2707.y)) + (_e3045.x * _e2707.z));
                let _e3054 = (((_e3020.y * _e2707.x) + (_e3031.y * _e2707.y)) + (_e3045.y * _e2707.z));
                let _e3055 = (((_e3020.z * _e2707.x) + (_e3031.z * _e2707.y)) + (_e3045.z * _e2707.z));
                if (_e2702.instance < _e88) {
                } else {
                    return;
                }
                let _e3062 = instances.member[(0u + _e2702.instance)].world_to_object[0u];
                let _e3071 = instances.member[(0u + _e2702.instance)].world_to_object[1u];
                let _e3083 = instances.member[(0u + _e2702.instance)].world_to_object[2u];
                let _e3090 = (((_e3062.x * _e3053) + (_e3071.x * _e3054)) + (_e3083.x * _e3055));
                let _e3091 = (((_e3062.y * _e3053) + (_e3071.y * _e3054)) + (_e3083.y * _e3055));
                let _e3092 = (((_e3062.z * _e3053) + (_e3071.z * _e3054)) + (_e3083.z * _e3055));
                let _e3098 = sqrt((((_e3090 * _e3090) + (_e3091 * _e3091)) + (_e3092 * _e3092)));
                if (_e3098 > 0f) {
                    let _e3104 = lt_shaders_camera_facing(vec3<f32>((_e3090 / _e3098), (_e3091 / _e3098), (_e3092 / _e3098)), _e2941);
                    phi_3876_ = _e3104;
                } else {
                    phi_3876_ = _e2941;
                }
                let _e3106 = phi_3876_;
                phi_3877_ = _e3106;
            }
            let _e3108 = phi_3877_;
            let _e3109 = lt_shaders_shade_pack_albedo((_e3002 * _e3003));
            phi_3881_ = abi_Sample(vec3<f32>(_e2864, _e2865, _e2866), _e3006, _e2941, _e3012, _e3108, _e3109);
        } else {
            phi_3881_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3113 = phi_3881_;
        if (_e97.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e97.first_primitive)] = _e3113;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
