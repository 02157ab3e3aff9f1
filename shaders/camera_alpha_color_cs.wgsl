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
var<storage> vertices: type_13;
@group(0) @binding(4) 
var<storage> materials: type_18;
var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_50;
@group(0) @binding(1) 
var<storage> nodes: type_55;
@group(0) @binding(2) 
var<storage> triangles: type_9;
@group(0) @binding(5) 
var<storage, read_write> samples: type_41;
@group(0) @binding(6) 
var<storage> alpha_texels: type_22;
@group(0) @binding(7) 
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
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_478_: f32;
    var phi_487_: f32;
    var phi_488_: f32;

    if (param_6 == 0u) {
        phi_478_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e73 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e73 > 1f) {
                phi_476_ = (2f - _e73);
            } else {
                phi_476_ = _e73;
            }
            let _e77 = phi_476_;
            phi_477_ = _e77;
        } else {
            phi_477_ = param_5;
        }
        let _e79 = phi_477_;
        phi_478_ = _e79;
    }
    let _e81 = phi_478_;
    if (_e81 > 0f) {
        if (_e81 < 1f) {
            phi_487_ = _e81;
        } else {
            phi_487_ = 1f;
        }
        let _e85 = phi_487_;
        phi_488_ = _e85;
    } else {
        phi_488_ = 0f;
    }
    let _e87 = phi_488_;
    return _e87;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_414_: u32;
    var phi_428_: u32;
    var phi_435_: u32;
    var phi_440_: u32;
    var phi_446_: u32;
    var phi_451_: u32;
    var phi_453_: texture_Axis;

    let _e68 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e69 = (param_8 - 1u);
    let _e71 = (_e68 * f32(param_8));
    if param_10 {
        let _e78 = select(select(u32(_e71), 0u, (_e71 < bitcast<f32>(0u))), 4294967295u, (_e71 > bitcast<f32>(1333788671u)));
        if (_e69 < _e78) {
            phi_414_ = _e69;
        } else {
            phi_414_ = _e78;
        }
        let _e81 = phi_414_;
        phi_453_ = texture_Axis(_e81, _e81, 0f);
    } else {
        let _e83 = (_e71 + 0.5f);
        let _e90 = select(select(u32(_e83), 0u, (_e83 < bitcast<f32>(0u))), 4294967295u, (_e83 > bitcast<f32>(1333788671u)));
        if (param_8 < _e90) {
            phi_428_ = param_8;
        } else {
            phi_428_ = _e90;
        }
        let _e93 = phi_428_;
        if (param_9 == 0u) {
            phi_435_ = _e69;
        } else {
            phi_435_ = 0u;
        }
        let _e98 = phi_435_;
        if (param_9 == 0u) {
            phi_440_ = 0u;
        } else {
            phi_440_ = _e69;
        }
        let _e101 = phi_440_;
        if (_e93 == 0u) {
            phi_446_ = _e98;
        } else {
            phi_446_ = (_e93 - 1u);
        }
        let _e105 = phi_446_;
        if (_e93 > _e69) {
            phi_451_ = _e101;
        } else {
            phi_451_ = _e93;
        }
        let _e108 = phi_451_;
        phi_453_ = texture_Axis(_e105, _e108, (_e83 - f32(_e93)));
    }
    let _e111 = phi_453_;
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
    var phi_508_: lt_bvh_traverse_Tree;
    var phi_509_: bool;
    var phi_510_: lt_bvh_traverse_Tree;
    var phi_511_: bool;
    var phi_516_: lt_bvh_traverse_Tree;

    if (param_14.x < param_15) {
        if (param_14.y < param_16) {
            phi_508_ = lt_bvh_traverse_Tree(1u, ((param_14.y * param_15) + param_14.x));
            phi_509_ = false;
        } else {
            phi_508_ = lt_bvh_traverse_Tree();
            phi_509_ = true;
        }
        let _e77 = phi_508_;
        let _e79 = phi_509_;
        phi_510_ = _e77;
        phi_511_ = _e79;
    } else {
        phi_510_ = lt_bvh_traverse_Tree();
        phi_511_ = true;
    }
    let _e81 = phi_510_;
    let _e83 = phi_511_;
    if _e83 {
        phi_516_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_516_ = _e81;
    }
    let _e88 = phi_516_;
    return lt_bvh_traverse_Tree(_e88.root, _e88.first_primitive);
}

fn lt_shaders_shade_unit(param_17: f32) -> f32 {
    var phi_530_: f32;
    var phi_531_: f32;

    if (param_17 > 0f) {
        if (param_17 < 1f) {
            phi_530_ = param_17;
        } else {
            phi_530_ = 1f;
        }
        let _e68 = phi_530_;
        phi_531_ = _e68;
    } else {
        phi_531_ = 0f;
    }
    let _e70 = phi_531_;
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
    var phi_586_: bool;
    var phi_590_: f32;

    if (param_22 != param_22) {
        phi_586_ = true;
    } else {
        let _e67 = (param_23 >= param_22);
        if _e67 {
        }
        phi_586_ = _e67;
    }
    let _e69 = phi_586_;
    if _e69 {
        phi_590_ = param_23;
    } else {
        phi_590_ = param_22;
    }
    let _e71 = phi_590_;
    return _e71;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_24: f32, param_25: f32) -> f32 {
    var phi_602_: bool;
    var phi_606_: f32;

    if (param_24 != param_24) {
        phi_602_ = true;
    } else {
        let _e67 = (param_25 <= param_24);
        if _e67 {
        }
        phi_602_ = _e67;
    }
    let _e69 = phi_602_;
    if _e69 {
        phi_606_ = param_25;
    } else {
        phi_606_ = param_24;
    }
    let _e71 = phi_606_;
    return _e71;
}

fn lt_shaders_surface_barycentric_weights(param_26: f32, param_27: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_26) - param_27), param_26, param_27);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_28: f32, param_29: f32) -> f32 {
    var phi_620_: f32;

    if (param_28 > param_29) {
        phi_620_ = param_28;
    } else {
        phi_620_ = param_29;
    }
    let _e68 = phi_620_;
    return _e68;
}

fn lt_shaders_camera_facing(param_30: vec3<f32>, param_31: vec3<f32>) -> vec3<f32> {
    var phi_640_: vec3<f32>;

    if ((((param_30.x * param_31.x) + (param_30.y * param_31.y)) + (param_30.z * param_31.z)) < 0f) {
        phi_640_ = -(param_30);
    } else {
        phi_640_ = param_30;
    }
    let _e80 = phi_640_;
    return _e80;
}

fn lt_shaders_surface_plain_color(param_32: ptr<function, abi_Material>, param_33: ptr<function, array<abi_Vertex, 3>>, param_34: vec3<f32>) -> vec3<f32> {
    let _e68 = (*param_32).base_color;
    let _e72 = lt_shaders_surface_vertex_color(param_33, param_34);
    return vec3<f32>((_e68.x * _e72.x), (_e68.y * _e72.y), (_e68.z * _e72.z));
}

fn lt_shaders_surface_octahedral_decode(param_35: u32) -> vec3<f32> {
    var phi_680_: f32;
    var phi_687_: f32;
    var phi_694_: f32;

    let _e72 = (f32((bitcast<i32>((param_35 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e78 = (f32((bitcast<i32>(param_35) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e82 = ((1f - abs(_e72)) - abs(_e78));
    if (_e82 < 0f) {
        phi_680_ = -(_e82);
    } else {
        phi_680_ = 0f;
    }
    let _e86 = phi_680_;
    if (_e72 < 0f) {
        phi_687_ = (_e72 + _e86);
    } else {
        phi_687_ = (_e72 - _e86);
    }
    let _e91 = phi_687_;
    if (_e78 < 0f) {
        phi_694_ = (_e78 + _e86);
    } else {
        phi_694_ = (_e78 - _e86);
    }
    let _e96 = phi_694_;
    let _e103 = (1f / sqrt((((_e91 * _e91) + (_e96 * _e96)) + (_e82 * _e82))));
    return vec3<f32>((_e91 * _e103), (_e96 * _e103), (_e82 * _e103));
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_36: vec3<f32>) -> vec3<f32> {
    return param_36;
}

fn lt_shaders_shade_pack_albedo(param_37: vec3<f32>) -> u32 {
    let _e66 = lt_shaders_shade_unit(param_37.x);
    let _e67 = lt_shaders_shade_sqrt(_e66);
    let _e69 = lt_shaders_shade_unit(param_37.y);
    let _e70 = lt_shaders_shade_sqrt(_e69);
    let _e72 = lt_shaders_shade_unit(param_37.z);
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
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_980_: f32;
    var phi_987_: f32;
    var phi_995_: f32;
    var phi_1002_: f32;
    var phi_1010_: f32;
    var phi_1017_: f32;
    var phi_1042_: f32;
    var phi_1047_: f32;
    var phi_1052_: f32;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_1113_: vec3<f32>;
    var phi_1114_: vec3<f32>;
    var phi_1128_: u32;
    var phi_1133_: u32;
    var phi_1138_: u32;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1284_: u32;
    var phi_1286_: lt_bvh_Hit;
    var phi_1289_: u32;
    var phi_1374_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1401_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1428_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1434_: u32;
    var phi_1437_: u32;
    var phi_1451_: u32;
    var phi_1461_: u32;
    var phi_1471_: u32;
    var phi_1489_: u32;
    var phi_1499_: u32;
    var phi_1509_: u32;
    var phi_1545_: u32;
    var phi_1558_: u32;
    var phi_1563_: u32;
    var phi_1564_: u32;
    var phi_1565_: u32;
    var phi_1435_: u32;
    var phi_1438_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1623_: lt_bvh_Hit;
    var phi_1626_: u32;
    var phi_1672_: vec3<f32>;
    var phi_1673_: vec3<f32>;
    var phi_1706_: vec3<f32>;
    var phi_1707_: vec3<f32>;
    var phi_1740_: vec3<f32>;
    var phi_1741_: vec3<f32>;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1766_: f32;
    var phi_1767_: f32;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1777_: f32;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1792_: f32;
    var phi_1793_: f32;
    var phi_1794_: f32;
    var phi_1795_: f32;
    var phi_1803_: f32;
    var phi_1813_: bool;
    var phi_1814_: bool;
    var phi_1818_: f32;
    var phi_1819_: f32;
    var phi_1820_: f32;
    var phi_1821_: f32;
    var phi_1829_: f32;
    var phi_1844_: f32;
    var phi_1845_: bool;
    var phi_1846_: f32;
    var phi_1847_: bool;
    var phi_1848_: f32;
    var phi_1849_: bool;
    var phi_1867_: f32;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1870_: f32;
    var phi_1871_: bool;
    var phi_1872_: bool;
    var phi_1876_: bool;
    var phi_1877_: f32;
    var phi_1878_: bool;
    var phi_1904_: f32;
    var phi_1913_: f32;
    var phi_1922_: f32;
    var phi_1931_: f32;
    var phi_1938_: f32;
    var phi_1945_: f32;
    var phi_1958_: f32;
    var phi_1967_: f32;
    var phi_1976_: f32;
    var phi_1985_: f32;
    var phi_1992_: f32;
    var phi_1999_: f32;
    var phi_2022_: f32;
    var phi_2027_: f32;
    var phi_2032_: f32;
    var phi_2040_: f32;
    var phi_2045_: f32;
    var phi_2050_: f32;
    var phi_2062_: f32;
    var phi_2067_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2082_: lt_bvh_triangle_Intersection;
    var phi_2083_: lt_bvh_triangle_Intersection;
    var phi_2084_: bool;
    var phi_2088_: lt_bvh_triangle_Intersection;
    var phi_2127_: bool;
    var phi_2128_: bool;
    var phi_2129_: bool;
    var phi_2130_: bool;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2335_: f32;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var phi_2343_: bool;
    var phi_2351_: lt_bvh_Hit;
    var phi_2352_: lt_bvh_Hit;
    var phi_2353_: lt_bvh_Hit;
    var phi_2354_: lt_bvh_Hit;
    var phi_1624_: lt_bvh_Hit;
    var phi_1627_: u32;
    var phi_2355_: bool;
    var phi_2394_: bool;
    var phi_2395_: bool;
    var phi_2426_: u32;
    var phi_1287_: lt_bvh_Hit;
    var phi_1290_: u32;
    var phi_2427_: lt_bvh_Hit;
    var phi_2428_: lt_bvh_Hit;
    var phi_2429_: bool;
    var phi_2433_: lt_bvh_Hit;
    var phi_2499_: f32;
    var phi_2504_: f32;
    var phi_2509_: f32;
    var phi_2520_: f32;
    var phi_2525_: f32;
    var phi_2530_: f32;
    var phi_2763_: vec3<f32>;
    var phi_2774_: u32;
    var phi_2840_: vec3<f32>;
    var phi_2841_: vec3<f32>;
    var phi_2845_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;

    let _e70 = id_1;
    let _e74 = arrayLength((&nodes.member));
    let _e77 = arrayLength((&triangles.member));
    let _e80 = arrayLength((&vertices.member));
    let _e83 = arrayLength((&materials.member));
    let _e89 = arrayLength((&alpha_texels.member));
    let _e92 = arrayLength((&color_texels.member));
    let _e95 = p.member.size[0u];
    let _e97 = p.member.size[1u];
    let _e98 = lt_shaders_entry_pixel_index(_e70, _e95, _e97);
    if (bitcast<i32>(_e98.root) != 0i) {
        let _e106 = p.member.eye;
        let _e111 = p.member.size[0u];
        let _e115 = ((((f32(_e70.x) + 0.5f) / f32(_e111)) * 2f) - 1f);
        let _e120 = p.member.size[1u];
        let _e124 = (1f - (((f32(_e70.y) + 0.5f) / f32(_e120)) * 2f));
        let _e126 = p.member.forward;
        let _e128 = p.member.right;
        let _e142 = p.member.up;
        let _e153 = _lt_bvh_ray_Ray_new(_e106, vec3<f32>(((_e126.x + (_e128.x * _e115)) + (_e142.x * _e124)), ((_e126.y + (_e128.y * _e115)) + (_e142.y * _e124)), ((_e126.z + (_e128.z * _e115)) + (_e142.z * _e124))));
        let _e155 = lt_bvh_Hit(_e153.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e165 = abs(_e153.direction.x);
        let _e167 = abs(_e153.direction.y);
        let _e169 = abs(_e153.direction.z);
        if (abs(_e153.origin.x) < 1000000000000000f) {
            if (abs(_e153.origin.y) < 1000000000000000f) {
                if (abs(_e153.origin.z) < 1000000000000000f) {
                    if (_e165 < 1000000000000000f) {
                        if (_e167 < 1000000000000000f) {
                            if (_e169 < 1000000000000000f) {
                                if (_e165 > 0f) {
                                    phi_875_ = bool();
                                    phi_876_ = true;
                                } else {
                                    let _e177 = (_e167 > 0f);
                                    if _e177 {
                                        phi_874_ = bool();
                                    } else {
                                        phi_874_ = (_e169 > 0f);
                                    }
                                    let _e180 = phi_874_;
                                    phi_875_ = _e180;
                                    phi_876_ = _e177;
                                }
                                let _e182 = phi_875_;
                                let _e184 = phi_876_;
                                if _e184 {
                                    phi_880_ = true;
                                } else {
                                    phi_880_ = _e182;
                                }
                                let _e186 = phi_880_;
                                phi_881_ = _e186;
                                phi_882_ = false;
                            } else {
                                phi_881_ = bool();
                                phi_882_ = true;
                            }
                            let _e188 = phi_881_;
                            let _e190 = phi_882_;
                            phi_883_ = _e188;
                            phi_884_ = false;
                            phi_885_ = _e190;
                        } else {
                            phi_883_ = bool();
                            phi_884_ = true;
                            phi_885_ = false;
                        }
                        let _e192 = phi_883_;
                        let _e194 = phi_884_;
                        let _e196 = phi_885_;
                        phi_886_ = _e192;
                        phi_887_ = _e194;
                        phi_888_ = _e196;
                    } else {
                        phi_886_ = bool();
                        phi_887_ = true;
                        phi_888_ = false;
                    }
                    let _e198 = phi_886_;
                    let _e200 = phi_887_;
                    let _e202 = phi_888_;
                    phi_889_ = _e198;
                    phi_890_ = _e200;
                    phi_891_ = _e202;
                } else {
                    phi_889_ = bool();
                    phi_890_ = true;
                    phi_891_ = false;
                }
                let _e204 = phi_889_;
                let _e206 = phi_890_;
                let _e208 = phi_891_;
                phi_892_ = _e204;
                phi_893_ = _e206;
                phi_894_ = _e208;
            } else {
                phi_892_ = bool();
                phi_893_ = true;
                phi_894_ = false;
            }
            let _e210 = phi_892_;
            let _e212 = phi_893_;
            let _e214 = phi_894_;
            phi_895_ = _e210;
            phi_896_ = _e212;
            phi_897_ = _e214;
        } else {
            phi_895_ = bool();
            phi_896_ = true;
            phi_897_ = false;
        }
        let _e216 = phi_895_;
        let _e218 = phi_896_;
        let _e220 = phi_897_;
        if _e218 {
            phi_901_ = true;
        } else {
            phi_901_ = _e220;
        }
        let _e222 = phi_901_;
        if _e222 {
            phi_905_ = false;
        } else {
            phi_905_ = _e216;
        }
        let _e224 = phi_905_;
        if _e224 {
            let _e225 = (0u >= _e74);
            if _e225 {
                phi_2427_ = lt_bvh_Hit();
            } else {
                if (0u < _e74) {
                } else {
                    return;
                }
                let _e231 = nodes.member[(0u + 0u)].frame[0u];
                let _e235 = nodes.member[(0u + 0u)].frame[1u];
                let _e239 = nodes.member[(0u + 0u)].frame[2u];
                let _e243 = nodes.member[(0u + 0u)].frame[0u];
                let _e247 = nodes.member[(0u + 0u)].frame[1u];
                let _e251 = nodes.member[(0u + 0u)].frame[2u];
                let _e255 = nodes.member[(0u + 0u)].frame[3u];
                let _e293 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153.direction.x), abs(_e153.direction.y));
                let _e294 = core_intrinsics_maximum_number_nsz_f32_(_e293, abs(_e153.direction.z));
                let _e295 = (_e294 * 0.0000000000009094947f);
                if (abs(_e153.direction.x) < _e295) {
                    phi_980_ = _e295;
                } else {
                    phi_980_ = abs(_e153.direction.x);
                }
                let _e302 = phi_980_;
                if (_e153.direction.x < 0f) {
                    phi_987_ = (-1f / _e302);
                } else {
                    phi_987_ = (1f / _e302);
                }
                let _e307 = phi_987_;
                if (abs(_e153.direction.y) < _e295) {
                    phi_995_ = _e295;
                } else {
                    phi_995_ = abs(_e153.direction.y);
                }
                let _e314 = phi_995_;
                if (_e153.direction.y < 0f) {
                    phi_1002_ = (-1f / _e314);
                } else {
                    phi_1002_ = (1f / _e314);
                }
                let _e319 = phi_1002_;
                if (abs(_e153.direction.z) < _e295) {
                    phi_1010_ = _e295;
                } else {
                    phi_1010_ = abs(_e153.direction.z);
                }
                let _e326 = phi_1010_;
                if (_e153.direction.z < 0f) {
                    phi_1017_ = (-1f / _e326);
                } else {
                    phi_1017_ = (1f / _e326);
                }
                let _e331 = phi_1017_;
                let _e339 = abs((bitcast<f32>(_e231) - _e153.origin.x));
                let _e340 = abs((bitcast<f32>(_e235) - _e153.origin.y));
                let _e341 = abs((bitcast<f32>(_e239) - _e153.origin.z));
                let _e349 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e255 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.x));
                let _e350 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e255 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.y));
                let _e351 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e255 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.z));
                if (_e339 > _e349) {
                    phi_1042_ = _e339;
                } else {
                    phi_1042_ = _e349;
                }
                let _e354 = phi_1042_;
                if (_e340 > _e350) {
                    phi_1047_ = _e340;
                } else {
                    phi_1047_ = _e350;
                }
                let _e357 = phi_1047_;
                if (_e341 > _e351) {
                    phi_1052_ = _e341;
                } else {
                    phi_1052_ = _e351;
                }
                let _e360 = phi_1052_;
                let _e361 = core_intrinsics_maximum_number_nsz_f32_(_e354, _e357);
                let _e362 = core_intrinsics_maximum_number_nsz_f32_(_e361, _e360);
                let _e367 = (_e362 * 0.0000019073486f);
                let _e368 = (abs(_e307) * _e367);
                let _e369 = (abs(_e319) * _e367);
                let _e370 = (abs(_e331) * _e367);
                let _e374 = (_e362 * 0.0000009536743f);
                let _e375 = (abs(_e307) * _e374);
                let _e376 = (abs(_e319) * _e374);
                let _e377 = (abs(_e331) * _e374);
                let _e380 = abs(_e153.direction.x);
                let _e382 = abs(_e153.direction.y);
                let _e384 = abs(_e153.direction.z);
                if (_e380 >= _e382) {
                    if (_e380 >= _e384) {
                        phi_1085_ = false;
                    } else {
                        phi_1085_ = true;
                    }
                    let _e388 = phi_1085_;
                    phi_1086_ = _e388;
                } else {
                    phi_1086_ = true;
                }
                let _e390 = phi_1086_;
                if _e390 {
                    if (_e382 >= _e384) {
                        phi_1094_ = 1u;
                    } else {
                        phi_1094_ = 2u;
                    }
                    let _e393 = phi_1094_;
                    phi_1095_ = _e393;
                } else {
                    phi_1095_ = 0u;
                }
                let _e395 = phi_1095_;
                if (_e395 == 0u) {
                    phi_1114_ = vec3<f32>(_e153.direction.y, _e153.direction.z, _e153.direction.x);
                } else {
                    if (_e395 == 1u) {
                        phi_1113_ = vec3<f32>(_e153.direction.z, _e153.direction.x, _e153.direction.y);
                    } else {
                        phi_1113_ = _e153.direction;
                    }
                    let _e408 = phi_1113_;
                    phi_1114_ = _e408;
                }
                let _e410 = phi_1114_;
                let _e414 = (_e410.x / _e410.z);
                let _e417 = (_e410.y / _e410.z);
                let _e419 = (1f / _e410.z);
                if (_e307 < 0f) {
                    phi_1128_ = 0u;
                } else {
                    phi_1128_ = 1u;
                }
                let _e422 = phi_1128_;
                if (_e319 < 0f) {
                    phi_1133_ = 0u;
                } else {
                    phi_1133_ = 2u;
                }
                let _e425 = phi_1133_;
                if (_e331 < 0f) {
                    phi_1138_ = 0u;
                } else {
                    phi_1138_ = 4u;
                }
                let _e428 = phi_1138_;
                let _e430 = ((_e422 | _e425) | _e428);
                let _e431 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_5 = lt_bvh_traverse_Stack(array<u32, 32>(_e431.first[0], _e431.first[1], _e431.first[2], _e431.first[3], _e431.first[4], _e431.first[5], _e431.first[6], _e431.first[7], _e431.first[8], _e431.first[9], _e431.first[10], _e431.first[11], _e431.first[12], _e431.first[13], _e431.first[14], _e431.first[15], _e431.first[16], _e431.first[17], _e431.first[18], _e431.first[19], _e431.first[20], _e431.first[21], _e431.first[22], _e431.first[23], _e431.first[24], _e431.first[25], _e431.first[26], _e431.first[27], _e431.first[28], _e431.first[29], _e431.first[30], _e431.first[31]), array<u32, 32>(_e431.mask[0], _e431.mask[1], _e431.mask[2], _e431.mask[3], _e431.mask[4], _e431.mask[5], _e431.mask[6], _e431.mask[7], _e431.mask[8], _e431.mask[9], _e431.mask[10], _e431.mask[11], _e431.mask[12], _e431.mask[13], _e431.mask[14], _e431.mask[15], _e431.mask[16], _e431.mask[17], _e431.mask[18], _e431.mask[19], _e431.mask[20], _e431.mask[21], _e431.mask[22], _e431.mask[23], _e431.mask[24], _e431.mask[25], _e431.mask[26], _e431.mask[27], _e431.mask[28], _e431.mask[29], _e431.mask[30], _e431.mask[31]), _e431.len, _e431.group, _e431.group_mask);
                let _e505 = local_5.group_mask;
                if ((_e505 & 4278190080u) == 0u) {
                    let _e509 = local_5.len;
                    if (_e509 == 0u) {
                        phi_1252_ = false;
                    } else {
                        let _e513 = local_5.len;
                        local_5.len = (_e513 - 1u);
                        let _e516 = local_5.len;
                        if (_e516 < 32u) {
                        } else {
                            return;
                        }
                        let _e521 = local_5.first[(0u + _e516)];
                        local_5.group = _e521;
                        let _e524 = local_5.len;
                        if (_e524 < 32u) {
                        } else {
                            return;
                        }
                        let _e529 = local_5.mask[(0u + _e524)];
                        local_5.group_mask = _e529;
                        phi_1252_ = true;
                    }
                    let _e532 = phi_1252_;
                    phi_1253_ = _e532;
                } else {
                    phi_1253_ = true;
                }
                let _e534 = phi_1253_;
                if _e534 {
                    let _e536 = local_5.group_mask;
                    let _e542 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e536)), 32u, (_e536 == 0u)));
                    let _e546 = local_5.group_mask;
                    let _e560 = local_5.group_mask;
                    local_5.group_mask = (_e560 & ~((1u << bitcast<u32>((_e542 & 31u)))));
                    let _e563 = local_5.group;
                    phi_1284_ = (_e563 + countOneBits(((_e546 & ~((4294967295u << bitcast<u32>((((_e542 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1284_ = 4294967295u;
                }
                let _e566 = phi_1284_;
                phi_1286_ = _e155;
                phi_1289_ = _e566;
                loop {
                    let _e568 = phi_1286_;
                    let _e570 = phi_1289_;
                    local_10 = _e568;
                    let _e571 = (_e570 != 4294967295u);
                    if _e571 {
                        if (_e570 < _e74) {
                        } else {
                            return;
                        }
                        let _e579 = nodes.member[(0u + _e570)].frame[3u];
                        let _e604 = (bitcast<f32>((((_e579 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e307);
                        let _e605 = (bitcast<f32>((((_e579 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e319);
                        let _e606 = (bitcast<f32>((((_e579 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e609 = nodes.member[(0u + _e570)].frame[0u];
                        let _e613 = nodes.member[(0u + _e570)].frame[1u];
                        let _e617 = nodes.member[(0u + _e570)].frame[2u];
                        let _e625 = ((bitcast<f32>(_e609) - _e153.origin.x) * _e307);
                        let _e626 = ((bitcast<f32>(_e613) - _e153.origin.y) * _e319);
                        let _e627 = ((bitcast<f32>(_e617) - _e153.origin.z) * _e331);
                        let _e635 = nodes.member[(0u + _e570)].x;
                        if (_e307 < 0f) {
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.unnamed.root, _e635.w), _e646.unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e635.x, _e652.unnamed_1.first_primitive));
                            phi_1374_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_bvh_traverse_Tree(_e658.unnamed_1.root, _e635.y));
                        } else {
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e674.unnamed.root, _e635.y), _e674.unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e635.z, _e680.unnamed_1.first_primitive));
                            phi_1374_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e686.unnamed_1.root, _e635.w));
                        }
                        let _e694 = phi_1374_;
                        let _e704 = nodes.member[(0u + _e570)].y;
                        if (_e319 < 0f) {
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.unnamed.root, _e704.w), _e715.unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e704.x, _e721.unnamed_1.first_primitive));
                            phi_1401_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_bvh_traverse_Tree(_e727.unnamed_1.root, _e704.y));
                        } else {
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e743.unnamed.root, _e704.y), _e743.unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e704.z, _e749.unnamed_1.first_primitive));
                            phi_1401_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_bvh_traverse_Tree(_e755.unnamed_1.root, _e704.w));
                        }
                        let _e763 = phi_1401_;
                        let _e773 = nodes.member[(0u + _e570)].z;
                        if (_e331 < 0f) {
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e773.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.unnamed.root, _e773.w), _e784.unnamed_1);
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_bvh_traverse_Tree(_e773.x, _e790.unnamed_1.first_primitive));
                            phi_1428_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e796.unnamed, lt_bvh_traverse_Tree(_e796.unnamed_1.root, _e773.y));
                        } else {
                            let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e773.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e812.unnamed.root, _e773.y), _e812.unnamed_1);
                            let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e818.unnamed, lt_bvh_traverse_Tree(_e773.z, _e818.unnamed_1.first_primitive));
                            phi_1428_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e824.unnamed, lt_bvh_traverse_Tree(_e824.unnamed_1.root, _e773.w));
                        }
                        let _e832 = phi_1428_;
                        phi_1434_ = 0u;
                        phi_1437_ = 0u;
                        loop {
                            let _e842 = phi_1434_;
                            let _e844 = phi_1437_;
                            local_6 = _e844;
                            local_7 = _e844;
                            local_8 = _e844;
                            let _e845 = (_e842 < 8u);
                            if _e845 {
                                let _e847 = (_e842 >> bitcast<u32>(2i));
                                let _e848 = (_e842 & 3u);
                                if (_e847 == 0u) {
                                    phi_1451_ = _e694.unnamed.root;
                                } else {
                                    phi_1451_ = _e694.unnamed.first_primitive;
                                }
                                let _e851 = phi_1451_;
                                if (_e847 == 0u) {
                                    phi_1461_ = _e763.unnamed.root;
                                } else {
                                    phi_1461_ = _e763.unnamed.first_primitive;
                                }
                                let _e860 = phi_1461_;
                                if (_e847 == 0u) {
                                    phi_1471_ = _e832.unnamed.root;
                                } else {
                                    phi_1471_ = _e832.unnamed.first_primitive;
                                }
                                let _e869 = phi_1471_;
                                let _e882 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e851 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e604) + (_e625 - _e368)), ((f32(((_e860 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e605) + (_e626 - _e369)));
                                let _e883 = core_intrinsics_maximum_number_nsz_f32_(_e882, ((f32(((_e869 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e606) + (_e627 - _e370)));
                                if (_e847 == 0u) {
                                    phi_1489_ = _e694.unnamed_1.root;
                                } else {
                                    phi_1489_ = _e694.unnamed_1.first_primitive;
                                }
                                let _e886 = phi_1489_;
                                if (_e847 == 0u) {
                                    phi_1499_ = _e763.unnamed_1.root;
                                } else {
                                    phi_1499_ = _e763.unnamed_1.first_primitive;
                                }
                                let _e895 = phi_1499_;
                                if (_e847 == 0u) {
                                    phi_1509_ = _e832.unnamed_1.root;
                                } else {
                                    phi_1509_ = _e832.unnamed_1.first_primitive;
                                }
                                let _e904 = phi_1509_;
                                let _e917 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e886 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e604) + (_e625 + _e368)), ((f32(((_e895 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e605) + (_e626 + _e369)));
                                let _e918 = core_intrinsics_minimum_number_nsz_f32_(_e917, ((f32(((_e904 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e606) + (_e627 + _e370)));
                                if (_e883 <= _e918) {
                                    if (_e883 <= _e568.t) {
                                        if (_e918 >= _e153.tmin) {
                                            if (_e847 == 0u) {
                                                let _e925 = nodes.member[(0u + _e570)].links[2u];
                                                phi_1545_ = _e925;
                                            } else {
                                                let _e928 = nodes.member[(0u + _e570)].links[3u];
                                                phi_1545_ = _e928;
                                            }
                                            let _e930 = phi_1545_;
                                            let _e935 = ((_e930 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u);
                                            let _e936 = (_e935 & 31u);
                                            if (_e936 >= 24u) {
                                                phi_1558_ = (24u + ((_e936 - 24u) ^ _e430));
                                            } else {
                                                phi_1558_ = _e936;
                                            }
                                            let _e942 = phi_1558_;
                                            phi_1563_ = (_e844 | ((_e935 >> bitcast<u32>(5i)) << bitcast<u32>((_e942 & 31u))));
                                        } else {
                                            phi_1563_ = _e844;
                                        }
                                        let _e950 = phi_1563_;
                                        phi_1564_ = _e950;
                                    } else {
                                        phi_1564_ = _e844;
                                    }
                                    let _e952 = phi_1564_;
                                    phi_1565_ = _e952;
                                } else {
                                    phi_1565_ = _e844;
                                }
                                let _e954 = phi_1565_;
                                phi_1435_ = (_e842 + 1u);
                                phi_1438_ = _e954;
                            } else {
                                phi_1435_ = u32();
                                phi_1438_ = u32();
                            }
                            let _e957 = phi_1435_;
                            let _e959 = phi_1438_;
                            continue;
                            continuing {
                                phi_1434_ = _e957;
                                phi_1437_ = _e959;
                                break if !(_e845);
                            }
                        }
                        let _e963 = nodes.member[(0u + _e570)].links[0u];
                        let _e967 = nodes.member[(0u + _e570)].frame[3u];
                        let _e971 = local_6;
                        if ((_e971 & 4278190080u) == 0u) {
                        } else {
                            let _e975 = local_5.group_mask;
                            if ((_e975 & 4278190080u) == 0u) {
                            } else {
                                let _e979 = local_5.len;
                                if (_e979 < 32u) {
                                    let _e982 = local_5.group;
                                    let _e984 = local_5.len;
                                    if (_e984 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_5.first[(0u + _e984)] = _e982;
                                    let _e990 = local_5.group_mask;
                                    let _e992 = local_5.len;
                                    if (_e992 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_5.mask[(0u + _e992)] = _e990;
                                    let _e999 = local_5.len;
                                    local_5.len = (_e999 + 1u);
                                }
                            }
                            local_5.group = (0u + _e963);
                            let _e1003 = local_7;
                            local_5.group_mask = ((_e1003 & 4278190080u) | (_e967 >> bitcast<u32>(24i)));
                        }
                        let _e1008 = local_8;
                        phi_1623_ = _e568;
                        phi_1626_ = (_e1008 & 16777215u);
                        loop {
                            let _e1011 = phi_1623_;
                            let _e1013 = phi_1626_;
                            local_9 = _e1011;
                            if (_e1013 == 0u) {
                                phi_1624_ = lt_bvh_Hit();
                                phi_1627_ = u32();
                                phi_2355_ = false;
                            } else {
                                let _e1017 = nodes.member[(0u + _e570)].links[1u];
                                let _e1022 = ((0u + _e1017) + select(firstTrailingBit(_e1013), 32u, (_e1013 == 0u)));
                                if (_e1022 < _e77) {
                                } else {
                                    return;
                                }
                                let _e1029 = triangles.member[(0u + _e1022)].v0_;
                                let _e1032 = (_e1029.x - _e153.origin.x);
                                let _e1035 = (_e1029.y - _e153.origin.y);
                                let _e1038 = (_e1029.z - _e153.origin.z);
                                if (_e395 == 0u) {
                                    phi_1673_ = vec3<f32>(_e1035, _e1038, _e1032);
                                } else {
                                    if (_e395 == 1u) {
                                        phi_1672_ = vec3<f32>(_e1038, _e1032, _e1035);
                                    } else {
                                        phi_1672_ = (_e1029 - _e153.origin);
                                    }
                                    let _e1045 = phi_1672_;
                                    phi_1673_ = _e1045;
                                }
                                let _e1047 = phi_1673_;
                                let _e1051 = (_e1047.x - (_e414 * _e1047.z));
                                let _e1055 = (_e1047.y - (_e417 * _e1047.z));
                                let _e1059 = triangles.member[(0u + _e1022)].v1_;
                                let _e1062 = (_e1059.x - _e153.origin.x);
                                let _e1065 = (_e1059.y - _e153.origin.y);
                                let _e1068 = (_e1059.z - _e153.origin.z);
                                if (_e395 == 0u) {
                                    phi_1707_ = vec3<f32>(_e1065, _e1068, _e1062);
                                } else {
                                    if (_e395 == 1u) {
                                        phi_1706_ = vec3<f32>(_e1068, _e1062, _e1065);
                                    } else {
                                        phi_1706_ = (_e1059 - _e153.origin);
                                    }
                                    let _e1075 = phi_1706_;
                                    phi_1707_ = _e1075;
                                }
                                let _e1077 = phi_1707_;
                                let _e1081 = (_e1077.x - (_e414 * _e1077.z));
                                let _e1085 = (_e1077.y - (_e417 * _e1077.z));
                                let _e1089 = triangles.member[(0u + _e1022)].v2_;
                                let _e1092 = (_e1089.x - _e153.origin.x);
                                let _e1095 = (_e1089.y - _e153.origin.y);
                                let _e1098 = (_e1089.z - _e153.origin.z);
                                if (_e395 == 0u) {
                                    phi_1741_ = vec3<f32>(_e1095, _e1098, _e1092);
                                } else {
                                    if (_e395 == 1u) {
                                        phi_1740_ = vec3<f32>(_e1098, _e1092, _e1095);
                                    } else {
                                        phi_1740_ = (_e1089 - _e153.origin);
                                    }
                                    let _e1105 = phi_1740_;
                                    phi_1741_ = _e1105;
                                }
                                let _e1107 = phi_1741_;
                                let _e1111 = (_e1107.x - (_e414 * _e1107.z));
                                let _e1115 = (_e1107.y - (_e417 * _e1107.z));
                                if (_e1081 < _e1111) {
                                    phi_1762_ = true;
                                } else {
                                    if (_e1081 == _e1111) {
                                        phi_1761_ = (_e1085 < _e1115);
                                    } else {
                                        phi_1761_ = false;
                                    }
                                    let _e1122 = phi_1761_;
                                    phi_1762_ = _e1122;
                                }
                                let _e1124 = phi_1762_;
                                if _e1124 {
                                    phi_1766_ = _e1115;
                                    phi_1767_ = _e1111;
                                    phi_1768_ = _e1085;
                                    phi_1769_ = _e1081;
                                } else {
                                    phi_1766_ = _e1085;
                                    phi_1767_ = _e1081;
                                    phi_1768_ = _e1115;
                                    phi_1769_ = _e1111;
                                }
                                let _e1126 = phi_1766_;
                                let _e1128 = phi_1767_;
                                let _e1130 = phi_1768_;
                                let _e1132 = phi_1769_;
                                let _e1135 = ((_e1132 * _e1126) - (_e1130 * _e1128));
                                if _e1124 {
                                    phi_1777_ = -(_e1135);
                                } else {
                                    phi_1777_ = _e1135;
                                }
                                let _e1138 = phi_1777_;
                                if (_e1111 < _e1051) {
                                    phi_1788_ = true;
                                } else {
                                    if (_e1111 == _e1051) {
                                        phi_1787_ = (_e1115 < _e1055);
                                    } else {
                                        phi_1787_ = false;
                                    }
                                    let _e1143 = phi_1787_;
                                    phi_1788_ = _e1143;
                                }
                                let _e1145 = phi_1788_;
                                if _e1145 {
                                    phi_1792_ = _e1055;
                                    phi_1793_ = _e1051;
                                    phi_1794_ = _e1115;
                                    phi_1795_ = _e1111;
                                } else {
                                    phi_1792_ = _e1115;
                                    phi_1793_ = _e1111;
                                    phi_1794_ = _e1055;
                                    phi_1795_ = _e1051;
                                }
                                let _e1147 = phi_1792_;
                                let _e1149 = phi_1793_;
                                let _e1151 = phi_1794_;
                                let _e1153 = phi_1795_;
                                let _e1156 = ((_e1153 * _e1147) - (_e1151 * _e1149));
                                if _e1145 {
                                    phi_1803_ = -(_e1156);
                                } else {
                                    phi_1803_ = _e1156;
                                }
                                let _e1159 = phi_1803_;
                                if (_e1051 < _e1081) {
                                    phi_1814_ = true;
                                } else {
                                    if (_e1051 == _e1081) {
                                        phi_1813_ = (_e1055 < _e1085);
                                    } else {
                                        phi_1813_ = false;
                                    }
                                    let _e1164 = phi_1813_;
                                    phi_1814_ = _e1164;
                                }
                                let _e1166 = phi_1814_;
                                if _e1166 {
                                    phi_1818_ = _e1085;
                                    phi_1819_ = _e1081;
                                    phi_1820_ = _e1055;
                                    phi_1821_ = _e1051;
                                } else {
                                    phi_1818_ = _e1055;
                                    phi_1819_ = _e1051;
                                    phi_1820_ = _e1085;
                                    phi_1821_ = _e1081;
                                }
                                let _e1168 = phi_1818_;
                                let _e1170 = phi_1819_;
                                let _e1172 = phi_1820_;
                                let _e1174 = phi_1821_;
                                let _e1177 = ((_e1174 * _e1168) - (_e1172 * _e1170));
                                if _e1166 {
                                    phi_1829_ = -(_e1177);
                                } else {
                                    phi_1829_ = _e1177;
                                }
                                let _e1180 = phi_1829_;
                                if (_e1138 >= 0f) {
                                    if (_e1159 >= 0f) {
                                        if (_e1180 >= 0f) {
                                            phi_1844_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1845_ = false;
                                        } else {
                                            phi_1844_ = f32();
                                            phi_1845_ = true;
                                        }
                                        let _e1187 = phi_1844_;
                                        let _e1189 = phi_1845_;
                                        phi_1846_ = _e1187;
                                        phi_1847_ = _e1189;
                                    } else {
                                        phi_1846_ = f32();
                                        phi_1847_ = true;
                                    }
                                    let _e1191 = phi_1846_;
                                    let _e1193 = phi_1847_;
                                    phi_1848_ = _e1191;
                                    phi_1849_ = _e1193;
                                } else {
                                    phi_1848_ = f32();
                                    phi_1849_ = true;
                                }
                                let _e1195 = phi_1848_;
                                let _e1197 = phi_1849_;
                                if _e1197 {
                                    if (_e1138 <= 0f) {
                                        if (_e1159 <= 0f) {
                                            let _e1200 = (_e1180 <= 0f);
                                            if _e1200 {
                                            }
                                            phi_1867_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1868_ = false;
                                            phi_1869_ = _e1200;
                                        } else {
                                            phi_1867_ = f32();
                                            phi_1868_ = true;
                                            phi_1869_ = false;
                                        }
                                        let _e1204 = phi_1867_;
                                        let _e1206 = phi_1868_;
                                        let _e1208 = phi_1869_;
                                        phi_1870_ = _e1204;
                                        phi_1871_ = _e1206;
                                        phi_1872_ = _e1208;
                                    } else {
                                        phi_1870_ = f32();
                                        phi_1871_ = true;
                                        phi_1872_ = false;
                                    }
                                    let _e1210 = phi_1870_;
                                    let _e1212 = phi_1871_;
                                    let _e1214 = phi_1872_;
                                    if _e1212 {
                                        phi_1876_ = false;
                                    } else {
                                        phi_1876_ = _e1214;
                                    }
                                    let _e1216 = phi_1876_;
                                    phi_1877_ = _e1210;
                                    phi_1878_ = _e1216;
                                } else {
                                    phi_1877_ = _e1195;
                                    phi_1878_ = true;
                                }
                                let _e1218 = phi_1877_;
                                let _e1220 = phi_1878_;
                                if _e1220 {
                                    let _e1221 = (_e1218 == 0f);
                                    if _e1221 {
                                        phi_2082_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1227 = ((((_e1138 * (_e419 * _e1047.z)) + (_e1159 * (_e419 * _e1077.z))) + (_e1180 * (_e419 * _e1107.z))) / _e1218);
                                        let _e1229 = triangles.member[(0u + _e1022)].v0_;
                                        let _e1231 = triangles.member[(0u + _e1022)].v1_;
                                        if (_e1229.x < _e1231.x) {
                                            phi_1904_ = _e1229.x;
                                        } else {
                                            phi_1904_ = _e1231.x;
                                        }
                                        let _e1238 = phi_1904_;
                                        if (_e1229.y < _e1231.y) {
                                            phi_1913_ = _e1229.y;
                                        } else {
                                            phi_1913_ = _e1231.y;
                                        }
                                        let _e1245 = phi_1913_;
                                        if (_e1229.z < _e1231.z) {
                                            phi_1922_ = _e1229.z;
                                        } else {
                                            phi_1922_ = _e1231.z;
                                        }
                                        let _e1252 = phi_1922_;
                                        let _e1254 = triangles.member[(0u + _e1022)].v2_;
                                        if (_e1238 < _e1254.x) {
                                            phi_1931_ = _e1238;
                                        } else {
                                            phi_1931_ = _e1254.x;
                                        }
                                        let _e1259 = phi_1931_;
                                        if (_e1245 < _e1254.y) {
                                            phi_1938_ = _e1245;
                                        } else {
                                            phi_1938_ = _e1254.y;
                                        }
                                        let _e1264 = phi_1938_;
                                        if (_e1252 < _e1254.z) {
                                            phi_1945_ = _e1252;
                                        } else {
                                            phi_1945_ = _e1254.z;
                                        }
                                        let _e1269 = phi_1945_;
                                        let _e1271 = triangles.member[(0u + _e1022)].v0_;
                                        let _e1273 = triangles.member[(0u + _e1022)].v1_;
                                        if (_e1271.x > _e1273.x) {
                                            phi_1958_ = _e1271.x;
                                        } else {
                                            phi_1958_ = _e1273.x;
                                        }
                                        let _e1280 = phi_1958_;
                                        if (_e1271.y > _e1273.y) {
                                            phi_1967_ = _e1271.y;
                                        } else {
                                            phi_1967_ = _e1273.y;
                                        }
                                        let _e1287 = phi_1967_;
                                        if (_e1271.z > _e1273.z) {
                                            phi_1976_ = _e1271.z;
                                        } else {
                                            phi_1976_ = _e1273.z;
                                        }
                                        let _e1294 = phi_1976_;
                                        let _e1296 = triangles.member[(0u + _e1022)].v2_;
                                        if (_e1280 > _e1296.x) {
                                            phi_1985_ = _e1280;
                                        } else {
                                            phi_1985_ = _e1296.x;
                                        }
                                        let _e1301 = phi_1985_;
                                        if (_e1287 > _e1296.y) {
                                            phi_1992_ = _e1287;
                                        } else {
                                            phi_1992_ = _e1296.y;
                                        }
                                        let _e1306 = phi_1992_;
                                        if (_e1294 > _e1296.z) {
                                            phi_1999_ = _e1294;
                                        } else {
                                            phi_1999_ = _e1296.z;
                                        }
                                        let _e1311 = phi_1999_;
                                        let _e1318 = ((_e1259 - _e153.origin.x) * _e307);
                                        let _e1319 = ((_e1264 - _e153.origin.y) * _e319);
                                        let _e1320 = ((_e1269 - _e153.origin.z) * _e331);
                                        let _e1327 = ((_e1301 - _e153.origin.x) * _e307);
                                        let _e1328 = ((_e1306 - _e153.origin.y) * _e319);
                                        let _e1329 = ((_e1311 - _e153.origin.z) * _e331);
                                        if (_e1318 < _e1327) {
                                            phi_2022_ = _e1318;
                                        } else {
                                            phi_2022_ = _e1327;
                                        }
                                        let _e1332 = phi_2022_;
                                        if (_e1319 < _e1328) {
                                            phi_2027_ = _e1319;
                                        } else {
                                            phi_2027_ = _e1328;
                                        }
                                        let _e1335 = phi_2027_;
                                        if (_e1320 < _e1329) {
                                            phi_2032_ = _e1320;
                                        } else {
                                            phi_2032_ = _e1329;
                                        }
                                        let _e1338 = phi_2032_;
                                        if (_e1318 > _e1327) {
                                            phi_2040_ = _e1318;
                                        } else {
                                            phi_2040_ = _e1327;
                                        }
                                        let _e1344 = phi_2040_;
                                        if (_e1319 > _e1328) {
                                            phi_2045_ = _e1319;
                                        } else {
                                            phi_2045_ = _e1328;
                                        }
                                        let _e1347 = phi_2045_;
                                        if (_e1320 > _e1329) {
                                            phi_2050_ = _e1320;
                                        } else {
                                            phi_2050_ = _e1329;
                                        }
                                        let _e1350 = phi_2050_;
                                        let _e1354 = core_intrinsics_maximum_number_nsz_f32_((_e1332 - _e375), (_e1335 - _e376));
                                        let _e1355 = core_intrinsics_maximum_number_nsz_f32_(_e1354, (_e1338 - _e377));
                                        let _e1356 = core_intrinsics_minimum_number_nsz_f32_((_e1344 + _e375), (_e1347 + _e376));
                                        let _e1357 = core_intrinsics_minimum_number_nsz_f32_(_e1356, (_e1350 + _e377));
                                        if (_e1355 > -300000000000000000000000000000000000000f) {
                                            phi_2062_ = _e1355;
                                        } else {
                                            phi_2062_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1360 = phi_2062_;
                                        if (_e1357 < 300000000000000000000000000000000000000f) {
                                            phi_2067_ = _e1357;
                                        } else {
                                            phi_2067_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1363 = phi_2067_;
                                        if (_e1227 < _e1360) {
                                            phi_2072_ = _e1360;
                                        } else {
                                            phi_2072_ = _e1227;
                                        }
                                        let _e1366 = phi_2072_;
                                        if (_e1366 > _e1363) {
                                            phi_2077_ = _e1363;
                                        } else {
                                            phi_2077_ = _e1366;
                                        }
                                        let _e1369 = phi_2077_;
                                        phi_2082_ = lt_bvh_triangle_Intersection(_e1369, (_e1159 / _e1218), (_e1180 / _e1218), (_e1360 <= _e1363));
                                    }
                                    let _e1375 = phi_2082_;
                                    phi_2083_ = _e1375;
                                    phi_2084_ = _e1221;
                                } else {
                                    phi_2083_ = lt_bvh_triangle_Intersection();
                                    phi_2084_ = true;
                                }
                                let _e1377 = phi_2083_;
                                let _e1379 = phi_2084_;
                                if _e1379 {
                                    phi_2088_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2088_ = _e1377;
                                }
                                let _e1381 = phi_2088_;
                                if _e1381.is_hit {
                                    if (_e1381.t > _e153.tmin) {
                                        if (_e1381.t < _e1011.t) {
                                            phi_2137_ = true;
                                        } else {
                                            if (_e1381.t == _e1011.t) {
                                                if (_e1011.triangle != 4294967295u) {
                                                    if (_e1022 < _e1011.triangle) {
                                                        phi_2128_ = true;
                                                    } else {
                                                        if (_e1022 == _e1011.triangle) {
                                                            phi_2127_ = (4294967295u < _e1011.instance);
                                                        } else {
                                                            phi_2127_ = false;
                                                        }
                                                        let _e1400 = phi_2127_;
                                                        phi_2128_ = _e1400;
                                                    }
                                                    let _e1402 = phi_2128_;
                                                    phi_2129_ = _e1402;
                                                    phi_2130_ = false;
                                                } else {
                                                    phi_2129_ = bool();
                                                    phi_2130_ = true;
                                                }
                                                let _e1404 = phi_2129_;
                                                let _e1406 = phi_2130_;
                                                phi_2131_ = _e1404;
                                                phi_2132_ = _e1406;
                                            } else {
                                                phi_2131_ = bool();
                                                phi_2132_ = true;
                                            }
                                            let _e1408 = phi_2131_;
                                            let _e1410 = phi_2132_;
                                            if _e1410 {
                                                phi_2136_ = false;
                                            } else {
                                                phi_2136_ = _e1408;
                                            }
                                            let _e1412 = phi_2136_;
                                            phi_2137_ = _e1412;
                                        }
                                        let _e1414 = phi_2137_;
                                        if _e1414 {
                                            let _e1416 = triangles.member[(0u + _e1022)].i0_;
                                            if ((_e1416 & 2147483648u) == 0u) {
                                                phi_2343_ = true;
                                            } else {
                                                if (_e1022 < _e77) {
                                                } else {
                                                    return;
                                                }
                                                let _e1425 = triangles.member[(0u + _e1022)].i0_;
                                                let _e1426 = (_e1425 & 2147483647u);
                                                let _e1428 = triangles.member[(0u + _e1022)].i1_;
                                                let _e1430 = triangles.member[(0u + _e1022)].i2_;
                                                if (_e1426 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1434 = vertices.member[(0u + _e1426)];
                                                if (_e1428 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1438 = vertices.member[(0u + _e1428)];
                                                if (_e1430 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1442 = vertices.member[(0u + _e1430)];
                                                let _e1443 = array<abi_Vertex, 3>(_e1434, _e1438, _e1442);
                                                local_4 = array<abi_Vertex, 3>(abi_Vertex(_e1443[0].u, _e1443[0].v, _e1443[0].normal, _e1443[0].color, _e1443[0].material), abi_Vertex(_e1443[1].u, _e1443[1].v, _e1443[1].normal, _e1443[1].color, _e1443[1].material), abi_Vertex(_e1443[2].u, _e1443[2].v, _e1443[2].normal, _e1443[2].color, _e1443[2].material));
                                                let _e1468 = local_4[0u].material;
                                                if (_e1468 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1472 = materials.member[(0u + _e1468)];
                                                if ((_e1472.flags & 0u) == 0u) {
                                                    let _e1476 = lt_shaders_surface_barycentric_weights(_e1381.u, _e1381.v);
                                                    if (_e1472.cutoff <= 0f) {
                                                        phi_2338_ = true;
                                                    } else {
                                                        let _e1481 = lt_shaders_surface_vertex_color((&local_4), _e1476);
                                                        let _e1483 = (_e1472.base_color.w * _e1481.w);
                                                        if (_e1472.alpha_size == 0u) {
                                                            phi_2335_ = _e1483;
                                                        } else {
                                                            local_3.offset = _e1472.alpha_offset;
                                                            local_3.size = _e1472.alpha_size;
                                                            local_3.flags = _e1472.flags;
                                                            let _e1492 = lt_shaders_surface_texture_coordinate((&local_4), _e1476);
                                                            let _e1495 = _lt_shaders_texture_TextureView_quad((&local_3), _e1492.x, _e1492.y);
                                                            let _e1499 = (_e1495.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1499 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1503 = alpha_texels.member[(0u + _e1499)];
                                                            let _e1519 = (_e1495.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1519 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1523 = alpha_texels.member[(0u + _e1519)];
                                                            let _e1540 = (_e1495.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1540 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1544 = alpha_texels.member[(0u + _e1540)];
                                                            let _e1561 = (_e1495.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1561 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1565 = alpha_texels.member[(0u + _e1561)];
                                                            phi_2335_ = (_e1483 * (((((f32(((_e1503 >> bitcast<u32>((((_e1495.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1495.weights.x) + ((f32(((_e1523 >> bitcast<u32>((((_e1495.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1495.weights.y)) + ((f32(((_e1544 >> bitcast<u32>((((_e1495.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1495.weights.z)) + ((f32(((_e1565 >> bitcast<u32>((((_e1495.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1495.weights.w)));
                                                        }
                                                        let _e1581 = phi_2335_;
                                                        phi_2338_ = (_e1581 >= _e1472.cutoff);
                                                    }
                                                    let _e1585 = phi_2338_;
                                                    phi_2339_ = _e1585;
                                                } else {
                                                    phi_2339_ = false;
                                                }
                                                let _e1587 = phi_2339_;
                                                if _e1587 {
                                                }
                                                phi_2343_ = _e1587;
                                            }
                                            let _e1589 = phi_2343_;
                                            if _e1589 {
                                                phi_2351_ = lt_bvh_Hit(_e1381.t, _e1381.u, _e1381.v, _e1022, 4294967295u);
                                            } else {
                                                phi_2351_ = _e1011;
                                            }
                                            let _e1595 = phi_2351_;
                                            phi_2352_ = _e1595;
                                        } else {
                                            phi_2352_ = _e1011;
                                        }
                                        let _e1597 = phi_2352_;
                                        phi_2353_ = _e1597;
                                    } else {
                                        phi_2353_ = _e1011;
                                    }
                                    let _e1599 = phi_2353_;
                                    phi_2354_ = _e1599;
                                } else {
                                    phi_2354_ = _e1011;
                                }
                                let _e1601 = phi_2354_;
                                phi_1624_ = _e1601;
                                phi_1627_ = (_e1013 & (_e1013 - 1u));
                                phi_2355_ = true;
                            }
                            let _e1603 = phi_1624_;
                            let _e1605 = phi_1627_;
                            let _e1607 = phi_2355_;
                            continue;
                            continuing {
                                phi_1623_ = _e1603;
                                phi_1626_ = _e1605;
                                break if !(_e1607);
                            }
                        }
                        let _e1610 = local_5.group_mask;
                        if ((_e1610 & 4278190080u) == 0u) {
                            let _e1614 = local_5.len;
                            if (_e1614 == 0u) {
                                phi_2394_ = false;
                            } else {
                                let _e1618 = local_5.len;
                                local_5.len = (_e1618 - 1u);
                                let _e1621 = local_5.len;
                                if (_e1621 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1626 = local_5.first[(0u + _e1621)];
                                local_5.group = _e1626;
                                let _e1629 = local_5.len;
                                if (_e1629 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1634 = local_5.mask[(0u + _e1629)];
                                local_5.group_mask = _e1634;
                                phi_2394_ = true;
                            }
                            let _e1637 = phi_2394_;
                            phi_2395_ = _e1637;
                        } else {
                            phi_2395_ = true;
                        }
                        let _e1639 = phi_2395_;
                        if _e1639 {
                            let _e1641 = local_5.group_mask;
                            let _e1647 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1641)), 32u, (_e1641 == 0u)));
                            let _e1651 = local_5.group_mask;
                            let _e1665 = local_5.group_mask;
                            local_5.group_mask = (_e1665 & ~((1u << bitcast<u32>((_e1647 & 31u)))));
                            let _e1668 = local_5.group;
                            phi_2426_ = (_e1668 + countOneBits(((_e1651 & ~((4294967295u << bitcast<u32>((((_e1647 - 24u) ^ _e430) & 31u))))) & 255u)));
                        } else {
                            phi_2426_ = 4294967295u;
                        }
                        let _e1671 = phi_2426_;
                        let _e2216 = local_9;
                        phi_1287_ = _e2216;
                        phi_1290_ = _e1671;
                    } else {
                        phi_1287_ = lt_bvh_Hit();
                        phi_1290_ = u32();
                    }
                    let _e1673 = phi_1287_;
                    let _e1675 = phi_1290_;
                    continue;
                    continuing {
                        phi_1286_ = _e1673;
                        phi_1289_ = _e1675;
                        break if !(_e571);
                    }
                }
                let _e2220 = local_10;
                phi_2427_ = _e2220;
            }
            let _e1678 = phi_2427_;
            phi_2428_ = _e1678;
            phi_2429_ = _e225;
        } else {
            phi_2428_ = lt_bvh_Hit();
            phi_2429_ = true;
        }
        let _e1680 = phi_2428_;
        let _e1682 = phi_2429_;
        if _e1682 {
            phi_2433_ = _e155;
        } else {
            phi_2433_ = _e1680;
        }
        let _e1684 = phi_2433_;
        if (_e1684.triangle != 4294967295u) {
            let _e1689 = lt_shaders_surface_barycentric_weights(_e1684.u, _e1684.v);
            if (_e1684.triangle < _e77) {
            } else {
                return;
            }
            let _e1694 = triangles.member[(0u + _e1684.triangle)];
            let _e1722 = (((_e1694.v0_.x * _e1689.x) + (_e1694.v1_.x * _e1689.y)) + (_e1694.v2_.x * _e1689.z));
            let _e1723 = (((_e1694.v0_.y * _e1689.x) + (_e1694.v1_.y * _e1689.y)) + (_e1694.v2_.y * _e1689.z));
            let _e1724 = (((_e1694.v0_.z * _e1689.x) + (_e1694.v1_.z * _e1689.y)) + (_e1694.v2_.z * _e1689.z));
            let _e1727 = abs(_e1694.v0_.x);
            let _e1729 = abs(_e1694.v0_.y);
            let _e1731 = abs(_e1694.v0_.z);
            let _e1733 = abs(_e1694.v1_.x);
            let _e1735 = abs(_e1694.v1_.y);
            let _e1737 = abs(_e1694.v1_.z);
            if (_e1727 > _e1733) {
                phi_2499_ = _e1727;
            } else {
                phi_2499_ = _e1733;
            }
            let _e1740 = phi_2499_;
            if (_e1729 > _e1735) {
                phi_2504_ = _e1729;
            } else {
                phi_2504_ = _e1735;
            }
            let _e1743 = phi_2504_;
            if (_e1731 > _e1737) {
                phi_2509_ = _e1731;
            } else {
                phi_2509_ = _e1737;
            }
            let _e1746 = phi_2509_;
            let _e1748 = abs(_e1694.v2_.x);
            let _e1750 = abs(_e1694.v2_.y);
            let _e1752 = abs(_e1694.v2_.z);
            if (_e1740 > _e1748) {
                phi_2520_ = _e1740;
            } else {
                phi_2520_ = _e1748;
            }
            let _e1755 = phi_2520_;
            if (_e1743 > _e1750) {
                phi_2525_ = _e1743;
            } else {
                phi_2525_ = _e1750;
            }
            let _e1758 = phi_2525_;
            if (_e1746 > _e1752) {
                phi_2530_ = _e1746;
            } else {
                phi_2530_ = _e1752;
            }
            let _e1761 = phi_2530_;
            let _e1764 = (_e1694.v1_.x - _e1694.v0_.x);
            let _e1767 = (_e1694.v1_.y - _e1694.v0_.y);
            let _e1770 = (_e1694.v1_.z - _e1694.v0_.z);
            let _e1773 = (_e1694.v2_.x - _e1694.v0_.x);
            let _e1776 = (_e1694.v2_.y - _e1694.v0_.y);
            let _e1779 = (_e1694.v2_.z - _e1694.v0_.z);
            let _e1783 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1767), abs(_e1770));
            let _e1784 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1764), _e1783);
            let _e1785 = (_e1764 / _e1784);
            let _e1786 = (_e1767 / _e1784);
            let _e1787 = (_e1770 / _e1784);
            let _e1791 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1776), abs(_e1779));
            let _e1792 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1773), _e1791);
            let _e1793 = (_e1773 / _e1792);
            let _e1794 = (_e1776 / _e1792);
            let _e1795 = (_e1779 / _e1792);
            let _e1798 = ((_e1786 * _e1795) - (_e1794 * _e1787));
            let _e1801 = ((_e1787 * _e1793) - (_e1795 * _e1785));
            let _e1804 = ((_e1785 * _e1794) - (_e1793 * _e1786));
            let _e1806 = p.member.eye;
            let _e1815 = (1f / sqrt((((_e1798 * _e1798) + (_e1801 * _e1801)) + (_e1804 * _e1804))));
            let _e1820 = lt_shaders_camera_facing(vec3<f32>((_e1798 * _e1815), (_e1801 * _e1815), (_e1804 * _e1815)), (_e1806 - vec3<f32>(_e1722, _e1723, _e1724)));
            if (_e1684.triangle < _e77) {
            } else {
                return;
            }
            let _e1825 = triangles.member[(0u + _e1684.triangle)];
            let _e1827 = (_e1825.i0_ & 2147483647u);
            if (_e1827 < _e80) {
            } else {
                return;
            }
            let _e1833 = vertices.member[(0u + _e1827)];
            if (_e1825.i1_ < _e80) {
            } else {
                return;
            }
            let _e1837 = vertices.member[(0u + _e1825.i1_)];
            if (_e1825.i2_ < _e80) {
            } else {
                return;
            }
            let _e1841 = vertices.member[(0u + _e1825.i2_)];
            let _e1842 = array<abi_Vertex, 3>(_e1833, _e1837, _e1841);
            local_1 = array<abi_Vertex, 3>(abi_Vertex(_e1842[0].u, _e1842[0].v, _e1842[0].normal, _e1842[0].color, _e1842[0].material), abi_Vertex(_e1842[1].u, _e1842[1].v, _e1842[1].normal, _e1842[1].color, _e1842[1].material), abi_Vertex(_e1842[2].u, _e1842[2].v, _e1842[2].normal, _e1842[2].color, _e1842[2].material));
            let _e1867 = local_1[0u].material;
            if (_e1867 < _e83) {
            } else {
                return;
            }
            let _e1871 = materials.member[(0u + _e1867)];
            local_2 = abi_Material(_e1871.base_color, _e1871.cutoff, _e1871.flags, _e1871.alpha_offset, _e1871.alpha_size, _e1871.color_offset, _e1871.color_size, _e1871.pad);
            let _e1881 = lt_shaders_surface_plain_color((&local_2), (&local_1), _e1689);
            let _e1883 = local_2.color_size;
            if (_e1883 == 0u) {
                phi_2763_ = vec3<f32>(1f, 1f, 1f);
            } else {
                let _e1886 = local_2.color_offset;
                let _e1888 = local_2.color_size;
                let _e1890 = local_2.flags;
                local.offset = _e1886;
                local.size = _e1888;
                local.flags = _e1890;
                let _e1894 = lt_shaders_surface_texture_coordinate((&local_1), _e1689);
                let _e1897 = _lt_shaders_texture_TextureView_quad((&local), _e1894.x, _e1894.y);
                if (_e1897.indices[0] < _e92) {
                } else {
                    return;
                }
                let _e1903 = color_texels.member[(0u + _e1897.indices[0])];
                let _e1904 = lt_shaders_texture_unorm_bytes(_e1903);
                if (_e1897.indices[1] < _e92) {
                } else {
                    return;
                }
                let _e1918 = color_texels.member[(0u + _e1897.indices[1])];
                let _e1919 = lt_shaders_texture_unorm_bytes(_e1918);
                if (_e1897.indices[2] < _e92) {
                } else {
                    return;
                }
                let _e1936 = color_texels.member[(0u + _e1897.indices[2])];
                let _e1937 = lt_shaders_texture_unorm_bytes(_e1936);
                if (_e1897.indices[3] < _e92) {
                } else {
                    return;
                }
                let _e1954 = color_texels.member[(0u + _e1897.indices[3])];
                let _e1955 = lt_shaders_texture_unorm_bytes(_e1954);
                let _e1964 = ((((_e1904.x * _e1897.weights.x) + (_e1919.x * _e1897.weights.y)) + (_e1937.x * _e1897.weights.z)) + (_e1955.x * _e1897.weights.w));
                let _e1965 = ((((_e1904.y * _e1897.weights.x) + (_e1919.y * _e1897.weights.y)) + (_e1937.y * _e1897.weights.z)) + (_e1955.y * _e1897.weights.w));
                let _e1966 = ((((_e1904.z * _e1897.weights.x) + (_e1919.z * _e1897.weights.y)) + (_e1937.z * _e1897.weights.z)) + (_e1955.z * _e1897.weights.w));
                phi_2763_ = vec3<f32>((_e1964 * _e1964), (_e1965 * _e1965), (_e1966 * _e1966));
            }
            let _e1972 = phi_2763_;
            let _e1974 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1758, _e1761);
            let _e1975 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1755, _e1974);
            let _e1977 = local_2.flags;
            if ((_e1977 & 2u) == 0u) {
                phi_2774_ = 0u;
            } else {
                phi_2774_ = 1u;
            }
            let _e1981 = phi_2774_;
            let _e1984 = local_1[0u].normal;
            if (_e1984 == 2147516416u) {
                phi_2841_ = _e1820;
            } else {
                let _e1988 = local_1[0u].normal;
                let _e1989 = lt_shaders_surface_octahedral_decode(_e1988);
                let _e1999 = local_1[1u].normal;
                let _e2000 = lt_shaders_surface_octahedral_decode(_e1999);
                let _e2013 = local_1[2u].normal;
                let _e2014 = lt_shaders_surface_octahedral_decode(_e2013);
                let _e2026 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>((((_e1989.x * _e1689.x) + (_e2000.x * _e1689.y)) + (_e2014.x * _e1689.z)), (((_e1989.y * _e1689.x) + (_e2000.y * _e1689.y)) + (_e2014.y * _e1689.z)), (((_e1989.z * _e1689.x) + (_e2000.z * _e1689.y)) + (_e2014.z * _e1689.z))));
                let _e2038 = sqrt((((_e2026.x * _e2026.x) + (_e2026.y * _e2026.y)) + (_e2026.z * _e2026.z)));
                if (_e2038 > 0f) {
                    let _e2042 = lt_shaders_camera_facing((_e2026 / vec3(_e2038)), _e1820);
                    phi_2840_ = _e2042;
                } else {
                    phi_2840_ = _e1820;
                }
                let _e2044 = phi_2840_;
                phi_2841_ = _e2044;
            }
            let _e2046 = phi_2841_;
            let _e2047 = lt_shaders_shade_pack_albedo((_e1881 * _e1972));
            phi_2845_ = abi_Sample(vec3<f32>(_e1722, _e1723, _e1724), _e1975, _e1820, _e1981, _e2046, _e2047);
        } else {
            phi_2845_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2051 = phi_2845_;
        if (_e98.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e98.first_primitive)] = _e2051;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
