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
var<storage> color_texels: type_22;

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
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_472_: f32;
    var phi_481_: f32;
    var phi_482_: f32;

    if (param_6 == 0u) {
        phi_472_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e72 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e72 > 1f) {
                phi_470_ = (2f - _e72);
            } else {
                phi_470_ = _e72;
            }
            let _e76 = phi_470_;
            phi_471_ = _e76;
        } else {
            phi_471_ = param_5;
        }
        let _e78 = phi_471_;
        phi_472_ = _e78;
    }
    let _e80 = phi_472_;
    if (_e80 > 0f) {
        if (_e80 < 1f) {
            phi_481_ = _e80;
        } else {
            phi_481_ = 1f;
        }
        let _e84 = phi_481_;
        phi_482_ = _e84;
    } else {
        phi_482_ = 0f;
    }
    let _e86 = phi_482_;
    return _e86;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_408_: u32;
    var phi_422_: u32;
    var phi_429_: u32;
    var phi_434_: u32;
    var phi_440_: u32;
    var phi_445_: u32;
    var phi_447_: texture_Axis;

    let _e67 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e68 = (param_8 - 1u);
    let _e70 = (_e67 * f32(param_8));
    if param_10 {
        let _e77 = select(select(u32(_e70), 0u, (_e70 < bitcast<f32>(0u))), 4294967295u, (_e70 > bitcast<f32>(1333788671u)));
        if (_e68 < _e77) {
            phi_408_ = _e68;
        } else {
            phi_408_ = _e77;
        }
        let _e80 = phi_408_;
        phi_447_ = texture_Axis(_e80, _e80, 0f);
    } else {
        let _e82 = (_e70 + 0.5f);
        let _e89 = select(select(u32(_e82), 0u, (_e82 < bitcast<f32>(0u))), 4294967295u, (_e82 > bitcast<f32>(1333788671u)));
        if (param_8 < _e89) {
            phi_422_ = param_8;
        } else {
            phi_422_ = _e89;
        }
        let _e92 = phi_422_;
        if (param_9 == 0u) {
            phi_429_ = _e68;
        } else {
            phi_429_ = 0u;
        }
        let _e97 = phi_429_;
        if (param_9 == 0u) {
            phi_434_ = 0u;
        } else {
            phi_434_ = _e68;
        }
        let _e100 = phi_434_;
        if (_e92 == 0u) {
            phi_440_ = _e97;
        } else {
            phi_440_ = (_e92 - 1u);
        }
        let _e104 = phi_440_;
        if (_e92 > _e68) {
            phi_445_ = _e100;
        } else {
            phi_445_ = _e92;
        }
        let _e107 = phi_445_;
        phi_447_ = texture_Axis(_e104, _e107, (_e82 - f32(_e92)));
    }
    let _e110 = phi_447_;
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
    var phi_502_: lt_bvh_traverse_Tree;
    var phi_503_: bool;
    var phi_504_: lt_bvh_traverse_Tree;
    var phi_505_: bool;
    var phi_510_: lt_bvh_traverse_Tree;

    if (param_14.x < param_15) {
        if (param_14.y < param_16) {
            phi_502_ = lt_bvh_traverse_Tree(1u, ((param_14.y * param_15) + param_14.x));
            phi_503_ = false;
        } else {
            phi_502_ = lt_bvh_traverse_Tree();
            phi_503_ = true;
        }
        let _e76 = phi_502_;
        let _e78 = phi_503_;
        phi_504_ = _e76;
        phi_505_ = _e78;
    } else {
        phi_504_ = lt_bvh_traverse_Tree();
        phi_505_ = true;
    }
    let _e80 = phi_504_;
    let _e82 = phi_505_;
    if _e82 {
        phi_510_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_510_ = _e80;
    }
    let _e87 = phi_510_;
    return lt_bvh_traverse_Tree(_e87.root, _e87.first_primitive);
}

fn lt_shaders_shade_unit(param_17: f32) -> f32 {
    var phi_524_: f32;
    var phi_525_: f32;

    if (param_17 > 0f) {
        if (param_17 < 1f) {
            phi_524_ = param_17;
        } else {
            phi_524_ = 1f;
        }
        let _e67 = phi_524_;
        phi_525_ = _e67;
    } else {
        phi_525_ = 0f;
    }
    let _e69 = phi_525_;
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
    var phi_580_: bool;
    var phi_584_: f32;

    if (param_22 != param_22) {
        phi_580_ = true;
    } else {
        let _e66 = (param_23 >= param_22);
        if _e66 {
        }
        phi_580_ = _e66;
    }
    let _e68 = phi_580_;
    if _e68 {
        phi_584_ = param_23;
    } else {
        phi_584_ = param_22;
    }
    let _e70 = phi_584_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_24: f32, param_25: f32) -> f32 {
    var phi_596_: bool;
    var phi_600_: f32;

    if (param_24 != param_24) {
        phi_596_ = true;
    } else {
        let _e66 = (param_25 <= param_24);
        if _e66 {
        }
        phi_596_ = _e66;
    }
    let _e68 = phi_596_;
    if _e68 {
        phi_600_ = param_25;
    } else {
        phi_600_ = param_24;
    }
    let _e70 = phi_600_;
    return _e70;
}

fn lt_shaders_surface_barycentric_weights(param_26: f32, param_27: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_26) - param_27), param_26, param_27);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_28: f32, param_29: f32) -> f32 {
    var phi_614_: f32;

    if (param_28 > param_29) {
        phi_614_ = param_28;
    } else {
        phi_614_ = param_29;
    }
    let _e67 = phi_614_;
    return _e67;
}

fn lt_shaders_camera_facing(param_30: vec3<f32>, param_31: vec3<f32>) -> vec3<f32> {
    var phi_634_: vec3<f32>;

    if ((((param_30.x * param_31.x) + (param_30.y * param_31.y)) + (param_30.z * param_31.z)) < 0f) {
        phi_634_ = -(param_30);
    } else {
        phi_634_ = param_30;
    }
    let _e79 = phi_634_;
    return _e79;
}

fn lt_shaders_surface_plain_color(param_32: ptr<function, abi_Material>, param_33: ptr<function, array<abi_Vertex, 3>>, param_34: vec3<f32>) -> vec3<f32> {
    let _e67 = (*param_32).base_color;
    let _e71 = lt_shaders_surface_vertex_color(param_33, param_34);
    return vec3<f32>((_e67.x * _e71.x), (_e67.y * _e71.y), (_e67.z * _e71.z));
}

fn lt_shaders_surface_octahedral_decode(param_35: u32) -> vec3<f32> {
    var phi_674_: f32;
    var phi_681_: f32;
    var phi_688_: f32;

    let _e71 = (f32((bitcast<i32>((param_35 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e77 = (f32((bitcast<i32>(param_35) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e81 = ((1f - abs(_e71)) - abs(_e77));
    if (_e81 < 0f) {
        phi_674_ = -(_e81);
    } else {
        phi_674_ = 0f;
    }
    let _e85 = phi_674_;
    if (_e71 < 0f) {
        phi_681_ = (_e71 + _e85);
    } else {
        phi_681_ = (_e71 - _e85);
    }
    let _e90 = phi_681_;
    if (_e77 < 0f) {
        phi_688_ = (_e77 + _e85);
    } else {
        phi_688_ = (_e77 - _e85);
    }
    let _e95 = phi_688_;
    let _e102 = (1f / sqrt((((_e90 * _e90) + (_e95 * _e95)) + (_e81 * _e81))));
    return vec3<f32>((_e90 * _e102), (_e95 * _e102), (_e81 * _e102));
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_36: vec3<f32>) -> vec3<f32> {
    return param_36;
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
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: abi_Material;
    var local_3: lt_bvh_traverse_Stack;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_882_: bool;
    var phi_886_: bool;
    var phi_961_: f32;
    var phi_968_: f32;
    var phi_976_: f32;
    var phi_983_: f32;
    var phi_991_: f32;
    var phi_998_: f32;
    var phi_1023_: f32;
    var phi_1028_: f32;
    var phi_1033_: f32;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_1094_: vec3<f32>;
    var phi_1095_: vec3<f32>;
    var phi_1109_: u32;
    var phi_1114_: u32;
    var phi_1119_: u32;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1265_: u32;
    var phi_1267_: lt_bvh_Hit;
    var phi_1270_: u32;
    var phi_1355_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1382_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1409_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1415_: u32;
    var phi_1418_: u32;
    var phi_1432_: u32;
    var phi_1442_: u32;
    var phi_1452_: u32;
    var phi_1470_: u32;
    var phi_1480_: u32;
    var phi_1490_: u32;
    var phi_1526_: u32;
    var phi_1539_: u32;
    var phi_1544_: u32;
    var phi_1545_: u32;
    var phi_1546_: u32;
    var phi_1416_: u32;
    var phi_1419_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1604_: lt_bvh_Hit;
    var phi_1607_: u32;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1687_: vec3<f32>;
    var phi_1688_: vec3<f32>;
    var phi_1721_: vec3<f32>;
    var phi_1722_: vec3<f32>;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1747_: f32;
    var phi_1748_: f32;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1758_: f32;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: f32;
    var phi_1774_: f32;
    var phi_1775_: f32;
    var phi_1776_: f32;
    var phi_1784_: f32;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1799_: f32;
    var phi_1800_: f32;
    var phi_1801_: f32;
    var phi_1802_: f32;
    var phi_1810_: f32;
    var phi_1825_: f32;
    var phi_1826_: bool;
    var phi_1827_: f32;
    var phi_1828_: bool;
    var phi_1829_: f32;
    var phi_1830_: bool;
    var phi_1848_: f32;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: f32;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1857_: bool;
    var phi_1858_: f32;
    var phi_1859_: bool;
    var phi_1885_: f32;
    var phi_1894_: f32;
    var phi_1903_: f32;
    var phi_1912_: f32;
    var phi_1919_: f32;
    var phi_1926_: f32;
    var phi_1939_: f32;
    var phi_1948_: f32;
    var phi_1957_: f32;
    var phi_1966_: f32;
    var phi_1973_: f32;
    var phi_1980_: f32;
    var phi_2003_: f32;
    var phi_2008_: f32;
    var phi_2013_: f32;
    var phi_2021_: f32;
    var phi_2026_: f32;
    var phi_2031_: f32;
    var phi_2043_: f32;
    var phi_2048_: f32;
    var phi_2053_: f32;
    var phi_2058_: f32;
    var phi_2063_: lt_bvh_triangle_Intersection;
    var phi_2064_: lt_bvh_triangle_Intersection;
    var phi_2065_: bool;
    var phi_2069_: lt_bvh_triangle_Intersection;
    var phi_2108_: bool;
    var phi_2109_: bool;
    var phi_2110_: bool;
    var phi_2111_: bool;
    var phi_2112_: bool;
    var phi_2113_: bool;
    var phi_2117_: bool;
    var phi_2118_: bool;
    var phi_2132_: bool;
    var phi_2140_: lt_bvh_Hit;
    var phi_2141_: lt_bvh_Hit;
    var phi_2142_: lt_bvh_Hit;
    var phi_2143_: lt_bvh_Hit;
    var phi_1605_: lt_bvh_Hit;
    var phi_1608_: u32;
    var phi_2144_: bool;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2215_: u32;
    var phi_1268_: lt_bvh_Hit;
    var phi_1271_: u32;
    var phi_2216_: lt_bvh_Hit;
    var phi_2217_: lt_bvh_Hit;
    var phi_2218_: bool;
    var phi_2222_: lt_bvh_Hit;
    var phi_2288_: f32;
    var phi_2293_: f32;
    var phi_2298_: f32;
    var phi_2309_: f32;
    var phi_2314_: f32;
    var phi_2319_: f32;
    var phi_2552_: vec3<f32>;
    var phi_2563_: u32;
    var phi_2629_: vec3<f32>;
    var phi_2630_: vec3<f32>;
    var phi_2634_: abi_Sample;
    var local_7: lt_bvh_Hit;
    var local_8: lt_bvh_Hit;

    let _e67 = id_1;
    let _e71 = arrayLength((&nodes.member));
    let _e74 = arrayLength((&triangles.member));
    let _e77 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&color_texels.member));
    let _e89 = p.member.size[0u];
    let _e91 = p.member.size[1u];
    let _e92 = lt_shaders_entry_pixel_index(_e67, _e89, _e91);
    if (bitcast<i32>(_e92.root) != 0i) {
        let _e100 = p.member.eye;
        let _e105 = p.member.size[0u];
        let _e109 = ((((f32(_e67.x) + 0.5f) / f32(_e105)) * 2f) - 1f);
        let _e114 = p.member.size[1u];
        let _e118 = (1f - (((f32(_e67.y) + 0.5f) / f32(_e114)) * 2f));
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
                                    phi_856_ = bool();
                                    phi_857_ = true;
                                } else {
                                    let _e171 = (_e161 > 0f);
                                    if _e171 {
                                        phi_855_ = bool();
                                    } else {
                                        phi_855_ = (_e163 > 0f);
                                    }
                                    let _e174 = phi_855_;
                                    phi_856_ = _e174;
                                    phi_857_ = _e171;
                                }
                                let _e176 = phi_856_;
                                let _e178 = phi_857_;
                                if _e178 {
                                    phi_861_ = true;
                                } else {
                                    phi_861_ = _e176;
                                }
                                let _e180 = phi_861_;
                                phi_862_ = _e180;
                                phi_863_ = false;
                            } else {
                                phi_862_ = bool();
                                phi_863_ = true;
                            }
                            let _e182 = phi_862_;
                            let _e184 = phi_863_;
                            phi_864_ = _e182;
                            phi_865_ = false;
                            phi_866_ = _e184;
                        } else {
                            phi_864_ = bool();
                            phi_865_ = true;
                            phi_866_ = false;
                        }
                        let _e186 = phi_864_;
                        let _e188 = phi_865_;
                        let _e190 = phi_866_;
                        phi_867_ = _e186;
                        phi_868_ = _e188;
                        phi_869_ = _e190;
                    } else {
                        phi_867_ = bool();
                        phi_868_ = true;
                        phi_869_ = false;
                    }
                    let _e192 = phi_867_;
                    let _e194 = phi_868_;
                    let _e196 = phi_869_;
                    phi_870_ = _e192;
                    phi_871_ = _e194;
                    phi_872_ = _e196;
                } else {
                    phi_870_ = bool();
                    phi_871_ = true;
                    phi_872_ = false;
                }
                let _e198 = phi_870_;
                let _e200 = phi_871_;
                let _e202 = phi_872_;
                phi_873_ = _e198;
                phi_874_ = _e200;
                phi_875_ = _e202;
            } else {
                phi_873_ = bool();
                phi_874_ = true;
                phi_875_ = false;
            }
            let _e204 = phi_873_;
            let _e206 = phi_874_;
            let _e208 = phi_875_;
            phi_876_ = _e204;
            phi_877_ = _e206;
            phi_878_ = _e208;
        } else {
            phi_876_ = bool();
            phi_877_ = true;
            phi_878_ = false;
        }
        let _e210 = phi_876_;
        let _e212 = phi_877_;
        let _e214 = phi_878_;
        if _e212 {
            phi_882_ = true;
        } else {
            phi_882_ = _e214;
        }
        let _e216 = phi_882_;
        if _e216 {
            phi_886_ = false;
        } else {
            phi_886_ = _e210;
        }
        let _e218 = phi_886_;
        if _e218 {
            let _e219 = (0u >= _e71);
            if _e219 {
                phi_2216_ = lt_bvh_Hit();
            } else {
                if (0u < _e71) {
                } else {
                    return;
                }
                let _e225 = nodes.member[(0u + 0u)].frame[0u];
                let _e229 = nodes.member[(0u + 0u)].frame[1u];
                let _e233 = nodes.member[(0u + 0u)].frame[2u];
                let _e237 = nodes.member[(0u + 0u)].frame[0u];
                let _e241 = nodes.member[(0u + 0u)].frame[1u];
                let _e245 = nodes.member[(0u + 0u)].frame[2u];
                let _e249 = nodes.member[(0u + 0u)].frame[3u];
                let _e287 = core_intrinsics_maximum_number_nsz_f32_(abs(_e147.direction.x), abs(_e147.direction.y));
                let _e288 = core_intrinsics_maximum_number_nsz_f32_(_e287, abs(_e147.direction.z));
                let _e289 = (_e288 * 0.0000000000009094947f);
                if (abs(_e147.direction.x) < _e289) {
                    phi_961_ = _e289;
                } else {
                    phi_961_ = abs(_e147.direction.x);
                }
                let _e296 = phi_961_;
                if (_e147.direction.x < 0f) {
                    phi_968_ = (-1f / _e296);
                } else {
                    phi_968_ = (1f / _e296);
                }
                let _e301 = phi_968_;
                if (abs(_e147.direction.y) < _e289) {
                    phi_976_ = _e289;
                } else {
                    phi_976_ = abs(_e147.direction.y);
                }
                let _e308 = phi_976_;
                if (_e147.direction.y < 0f) {
                    phi_983_ = (-1f / _e308);
                } else {
                    phi_983_ = (1f / _e308);
                }
                let _e313 = phi_983_;
                if (abs(_e147.direction.z) < _e289) {
                    phi_991_ = _e289;
                } else {
                    phi_991_ = abs(_e147.direction.z);
                }
                let _e320 = phi_991_;
                if (_e147.direction.z < 0f) {
                    phi_998_ = (-1f / _e320);
                } else {
                    phi_998_ = (1f / _e320);
                }
                let _e325 = phi_998_;
                let _e333 = abs((bitcast<f32>(_e225) - _e147.origin.x));
                let _e334 = abs((bitcast<f32>(_e229) - _e147.origin.y));
                let _e335 = abs((bitcast<f32>(_e233) - _e147.origin.z));
                let _e343 = abs(((bitcast<f32>(_e237) + (bitcast<f32>((((_e249 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147.origin.x));
                let _e344 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e249 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147.origin.y));
                let _e345 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e249 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147.origin.z));
                if (_e333 > _e343) {
                    phi_1023_ = _e333;
                } else {
                    phi_1023_ = _e343;
                }
                let _e348 = phi_1023_;
                if (_e334 > _e344) {
                    phi_1028_ = _e334;
                } else {
                    phi_1028_ = _e344;
                }
                let _e351 = phi_1028_;
                if (_e335 > _e345) {
                    phi_1033_ = _e335;
                } else {
                    phi_1033_ = _e345;
                }
                let _e354 = phi_1033_;
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
                let _e374 = abs(_e147.direction.x);
                let _e376 = abs(_e147.direction.y);
                let _e378 = abs(_e147.direction.z);
                if (_e374 >= _e376) {
                    if (_e374 >= _e378) {
                        phi_1066_ = false;
                    } else {
                        phi_1066_ = true;
                    }
                    let _e382 = phi_1066_;
                    phi_1067_ = _e382;
                } else {
                    phi_1067_ = true;
                }
                let _e384 = phi_1067_;
                if _e384 {
                    if (_e376 >= _e378) {
                        phi_1075_ = 1u;
                    } else {
                        phi_1075_ = 2u;
                    }
                    let _e387 = phi_1075_;
                    phi_1076_ = _e387;
                } else {
                    phi_1076_ = 0u;
                }
                let _e389 = phi_1076_;
                if (_e389 == 0u) {
                    phi_1095_ = vec3<f32>(_e147.direction.y, _e147.direction.z, _e147.direction.x);
                } else {
                    if (_e389 == 1u) {
                        phi_1094_ = vec3<f32>(_e147.direction.z, _e147.direction.x, _e147.direction.y);
                    } else {
                        phi_1094_ = _e147.direction;
                    }
                    let _e402 = phi_1094_;
                    phi_1095_ = _e402;
                }
                let _e404 = phi_1095_;
                let _e408 = (_e404.x / _e404.z);
                let _e411 = (_e404.y / _e404.z);
                let _e413 = (1f / _e404.z);
                if (_e301 < 0f) {
                    phi_1109_ = 0u;
                } else {
                    phi_1109_ = 1u;
                }
                let _e416 = phi_1109_;
                if (_e313 < 0f) {
                    phi_1114_ = 0u;
                } else {
                    phi_1114_ = 2u;
                }
                let _e419 = phi_1114_;
                if (_e325 < 0f) {
                    phi_1119_ = 0u;
                } else {
                    phi_1119_ = 4u;
                }
                let _e422 = phi_1119_;
                let _e424 = ((_e416 | _e419) | _e422);
                let _e425 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e425.first[0], _e425.first[1], _e425.first[2], _e425.first[3], _e425.first[4], _e425.first[5], _e425.first[6], _e425.first[7], _e425.first[8], _e425.first[9], _e425.first[10], _e425.first[11], _e425.first[12], _e425.first[13], _e425.first[14], _e425.first[15], _e425.first[16], _e425.first[17], _e425.first[18], _e425.first[19], _e425.first[20], _e425.first[21], _e425.first[22], _e425.first[23], _e425.first[24], _e425.first[25], _e425.first[26], _e425.first[27], _e425.first[28], _e425.first[29], _e425.first[30], _e425.first[31]), array<u32, 32>(_e425.mask[0], _e425.mask[1], _e425.mask[2], _e425.mask[3], _e425.mask[4], _e425.mask[5], _e425.mask[6], _e425.mask[7], _e425.mask[8], _e425.mask[9], _e425.mask[10], _e425.mask[11], _e425.mask[12], _e425.mask[13], _e425.mask[14], _e425.mask[15], _e425.mask[16], _e425.mask[17], _e425.mask[18], _e425.mask[19], _e425.mask[20], _e425.mask[21], _e425.mask[22], _e425.mask[23], _e425.mask[24], _e425.mask[25], _e425.mask[26], _e425.mask[27], _e425.mask[28], _e425.mask[29], _e425.mask[30], _e425.mask[31]), _e425.len, _e425.group, _e425.group_mask);
                let _e499 = local_3.group_mask;
                if ((_e499 & 4278190080u) == 0u) {
                    let _e503 = local_3.len;
                    if (_e503 == 0u) {
                        phi_1233_ = false;
                    } else {
                        let _e507 = local_3.len;
                        local_3.len = (_e507 - 1u);
                        let _e510 = local_3.len;
                        if (_e510 < 32u) {
                        } else {
                            return;
                        }
                        let _e515 = local_3.first[(0u + _e510)];
                        local_3.group = _e515;
                        let _e518 = local_3.len;
                        if (_e518 < 32u) {
                        } else {
                            return;
                        }
                        let _e523 = local_3.mask[(0u + _e518)];
                        local_3.group_mask = _e523;
                        phi_1233_ = true;
                    }
                    let _e526 = phi_1233_;
                    phi_1234_ = _e526;
                } else {
                    phi_1234_ = true;
                }
                let _e528 = phi_1234_;
                if _e528 {
                    let _e530 = local_3.group_mask;
                    let _e536 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e530)), 32u, (_e530 == 0u)));
                    let _e540 = local_3.group_mask;
                    let _e554 = local_3.group_mask;
                    local_3.group_mask = (_e554 & ~((1u << bitcast<u32>((_e536 & 31u)))));
                    let _e557 = local_3.group;
                    phi_1265_ = (_e557 + countOneBits(((_e540 & ~((4294967295u << bitcast<u32>((((_e536 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1265_ = 4294967295u;
                }
                let _e560 = phi_1265_;
                phi_1267_ = _e149;
                phi_1270_ = _e560;
                loop {
                    let _e562 = phi_1267_;
                    let _e564 = phi_1270_;
                    local_8 = _e562;
                    let _e565 = (_e564 != 4294967295u);
                    if _e565 {
                        if (_e564 < _e71) {
                        } else {
                            return;
                        }
                        let _e573 = nodes.member[(0u + _e564)].frame[3u];
                        let _e598 = (bitcast<f32>((((_e573 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e301);
                        let _e599 = (bitcast<f32>((((_e573 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e600 = (bitcast<f32>((((_e573 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e603 = nodes.member[(0u + _e564)].frame[0u];
                        let _e607 = nodes.member[(0u + _e564)].frame[1u];
                        let _e611 = nodes.member[(0u + _e564)].frame[2u];
                        let _e619 = ((bitcast<f32>(_e603) - _e147.origin.x) * _e301);
                        let _e620 = ((bitcast<f32>(_e607) - _e147.origin.y) * _e313);
                        let _e621 = ((bitcast<f32>(_e611) - _e147.origin.z) * _e325);
                        let _e629 = nodes.member[(0u + _e564)].x;
                        if (_e301 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.unnamed.root, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e629.x, _e646.unnamed_1.first_primitive));
                            phi_1355_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e652.unnamed_1.root, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.unnamed.root, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e629.z, _e674.unnamed_1.first_primitive));
                            phi_1355_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e680.unnamed_1.root, _e629.w));
                        }
                        let _e688 = phi_1355_;
                        let _e698 = nodes.member[(0u + _e564)].y;
                        if (_e313 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e698.x, _e715.unnamed_1.first_primitive));
                            phi_1382_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.unnamed.root, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e698.z, _e743.unnamed_1.first_primitive));
                            phi_1382_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e749.unnamed_1.root, _e698.w));
                        }
                        let _e757 = phi_1382_;
                        let _e767 = nodes.member[(0u + _e564)].z;
                        if (_e325 < 0f) {
                            let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e767.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e778.unnamed.root, _e767.w), _e778.unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_bvh_traverse_Tree(_e767.x, _e784.unnamed_1.first_primitive));
                            phi_1409_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_bvh_traverse_Tree(_e790.unnamed_1.root, _e767.y));
                        } else {
                            let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e767.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e806.unnamed.root, _e767.y), _e806.unnamed_1);
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e812.unnamed, lt_bvh_traverse_Tree(_e767.z, _e812.unnamed_1.first_primitive));
                            phi_1409_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e818.unnamed, lt_bvh_traverse_Tree(_e818.unnamed_1.root, _e767.w));
                        }
                        let _e826 = phi_1409_;
                        phi_1415_ = 0u;
                        phi_1418_ = 0u;
                        loop {
                            let _e836 = phi_1415_;
                            let _e838 = phi_1418_;
                            local_4 = _e838;
                            local_5 = _e838;
                            local_6 = _e838;
                            let _e839 = (_e836 < 8u);
                            if _e839 {
                                let _e841 = (_e836 >> bitcast<u32>(2i));
                                let _e842 = (_e836 & 3u);
                                if (_e841 == 0u) {
                                    phi_1432_ = _e688.unnamed.root;
                                } else {
                                    phi_1432_ = _e688.unnamed.first_primitive;
                                }
                                let _e845 = phi_1432_;
                                if (_e841 == 0u) {
                                    phi_1442_ = _e757.unnamed.root;
                                } else {
                                    phi_1442_ = _e757.unnamed.first_primitive;
                                }
                                let _e854 = phi_1442_;
                                if (_e841 == 0u) {
                                    phi_1452_ = _e826.unnamed.root;
                                } else {
                                    phi_1452_ = _e826.unnamed.first_primitive;
                                }
                                let _e863 = phi_1452_;
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e845 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e362)), ((f32(((_e854 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e363)));
                                let _e877 = core_intrinsics_maximum_number_nsz_f32_(_e876, ((f32(((_e863 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e364)));
                                if (_e841 == 0u) {
                                    phi_1470_ = _e688.unnamed_1.root;
                                } else {
                                    phi_1470_ = _e688.unnamed_1.first_primitive;
                                }
                                let _e880 = phi_1470_;
                                if (_e841 == 0u) {
                                    phi_1480_ = _e757.unnamed_1.root;
                                } else {
                                    phi_1480_ = _e757.unnamed_1.first_primitive;
                                }
                                let _e889 = phi_1480_;
                                if (_e841 == 0u) {
                                    phi_1490_ = _e826.unnamed_1.root;
                                } else {
                                    phi_1490_ = _e826.unnamed_1.first_primitive;
                                }
                                let _e898 = phi_1490_;
                                let _e911 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e880 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e598) + (_e619 + _e362)), ((f32(((_e889 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e363)));
                                let _e912 = core_intrinsics_minimum_number_nsz_f32_(_e911, ((f32(((_e898 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e364)));
                                if (_e877 <= _e912) {
                                    if (_e877 <= _e562.t) {
                                        if (_e912 >= _e147.tmin) {
                                            if (_e841 == 0u) {
                                                let _e919 = nodes.member[(0u + _e564)].links[2u];
                                                phi_1526_ = _e919;
                                            } else {
                                                let _e922 = nodes.member[(0u + _e564)].links[3u];
                                                phi_1526_ = _e922;
                                            }
                                            let _e924 = phi_1526_;
                                            let _e929 = ((_e924 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u);
                                            let _e930 = (_e929 & 31u);
                                            if (_e930 >= 24u) {
                                                phi_1539_ = (24u + ((_e930 - 24u) ^ _e424));
                                            } else {
                                                phi_1539_ = _e930;
                                            }
                                            let _e936 = phi_1539_;
                                            phi_1544_ = (_e838 | ((_e929 >> bitcast<u32>(5i)) << bitcast<u32>((_e936 & 31u))));
                                        } else {
                                            phi_1544_ = _e838;
                                        }
                                        let _e944 = phi_1544_;
                                        phi_1545_ = _e944;
                                    } else {
                                        phi_1545_ = _e838;
                                    }
                                    let _e946 = phi_1545_;
                                    phi_1546_ = _e946;
                                } else {
                                    phi_1546_ = _e838;
                                }
                                let _e948 = phi_1546_;
                                phi_1416_ = (_e836 + 1u);
                                phi_1419_ = _e948;
                            } else {
                                phi_1416_ = u32();
                                phi_1419_ = u32();
                            }
                            let _e951 = phi_1416_;
                            let _e953 = phi_1419_;
                            continue;
                            continuing {
                                phi_1415_ = _e951;
                                phi_1418_ = _e953;
                                break if !(_e839);
                            }
                        }
                        let _e957 = nodes.member[(0u + _e564)].links[0u];
                        let _e961 = nodes.member[(0u + _e564)].frame[3u];
                        let _e965 = local_4;
                        if ((_e965 & 4278190080u) == 0u) {
                        } else {
                            let _e969 = local_3.group_mask;
                            if ((_e969 & 4278190080u) == 0u) {
                            } else {
                                let _e973 = local_3.len;
                                if (_e973 < 32u) {
                                    let _e976 = local_3.group;
                                    let _e978 = local_3.len;
                                    if (_e978 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e978)] = _e976;
                                    let _e984 = local_3.group_mask;
                                    let _e986 = local_3.len;
                                    if (_e986 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e986)] = _e984;
                                    let _e993 = local_3.len;
                                    local_3.len = (_e993 + 1u);
                                }
                            }
                            local_3.group = (0u + _e957);
                            let _e997 = local_5;
                            local_3.group_mask = ((_e997 & 4278190080u) | (_e961 >> bitcast<u32>(24i)));
                        }
                        let _e1002 = local_6;
                        phi_1604_ = _e562;
                        phi_1607_ = (_e1002 & 16777215u);
                        loop {
                            let _e1005 = phi_1604_;
                            let _e1007 = phi_1607_;
                            local_7 = _e1005;
                            if (_e1007 == 0u) {
                                phi_1605_ = lt_bvh_Hit();
                                phi_1608_ = u32();
                                phi_2144_ = false;
                            } else {
                                let _e1011 = nodes.member[(0u + _e564)].links[1u];
                                let _e1016 = ((0u + _e1011) + select(firstTrailingBit(_e1007), 32u, (_e1007 == 0u)));
                                if (_e1016 < _e74) {
                                } else {
                                    return;
                                }
                                let _e1023 = triangles.member[(0u + _e1016)].v0_;
                                let _e1026 = (_e1023.x - _e147.origin.x);
                                let _e1029 = (_e1023.y - _e147.origin.y);
                                let _e1032 = (_e1023.z - _e147.origin.z);
                                if (_e389 == 0u) {
                                    phi_1654_ = vec3<f32>(_e1029, _e1032, _e1026);
                                } else {
                                    if (_e389 == 1u) {
                                        phi_1653_ = vec3<f32>(_e1032, _e1026, _e1029);
                                    } else {
                                        phi_1653_ = (_e1023 - _e147.origin);
                                    }
                                    let _e1039 = phi_1653_;
                                    phi_1654_ = _e1039;
                                }
                                let _e1041 = phi_1654_;
                                let _e1045 = (_e1041.x - (_e408 * _e1041.z));
                                let _e1049 = (_e1041.y - (_e411 * _e1041.z));
                                let _e1053 = triangles.member[(0u + _e1016)].v1_;
                                let _e1056 = (_e1053.x - _e147.origin.x);
                                let _e1059 = (_e1053.y - _e147.origin.y);
                                let _e1062 = (_e1053.z - _e147.origin.z);
                                if (_e389 == 0u) {
                                    phi_1688_ = vec3<f32>(_e1059, _e1062, _e1056);
                                } else {
                                    if (_e389 == 1u) {
                                        phi_1687_ = vec3<f32>(_e1062, _e1056, _e1059);
                                    } else {
                                        phi_1687_ = (_e1053 - _e147.origin);
                                    }
                                    let _e1069 = phi_1687_;
                                    phi_1688_ = _e1069;
                                }
                                let _e1071 = phi_1688_;
                                let _e1075 = (_e1071.x - (_e408 * _e1071.z));
                                let _e1079 = (_e1071.y - (_e411 * _e1071.z));
                                let _e1083 = triangles.member[(0u + _e1016)].v2_;
                                let _e1086 = (_e1083.x - _e147.origin.x);
                                let _e1089 = (_e1083.y - _e147.origin.y);
                                let _e1092 = (_e1083.z - _e147.origin.z);
                                if (_e389 == 0u) {
                                    phi_1722_ = vec3<f32>(_e1089, _e1092, _e1086);
                                } else {
                                    if (_e389 == 1u) {
                                        phi_1721_ = vec3<f32>(_e1092, _e1086, _e1089);
                                    } else {
                                        phi_1721_ = (_e1083 - _e147.origin);
                                    }
                                    let _e1099 = phi_1721_;
                                    phi_1722_ = _e1099;
                                }
                                let _e1101 = phi_1722_;
                                let _e1105 = (_e1101.x - (_e408 * _e1101.z));
                                let _e1109 = (_e1101.y - (_e411 * _e1101.z));
                                if (_e1075 < _e1105) {
                                    phi_1743_ = true;
                                } else {
                                    if (_e1075 == _e1105) {
                                        phi_1742_ = (_e1079 < _e1109);
                                    } else {
                                        phi_1742_ = false;
                                    }
                                    let _e1116 = phi_1742_;
                                    phi_1743_ = _e1116;
                                }
                                let _e1118 = phi_1743_;
                                if _e1118 {
                                    phi_1747_ = _e1109;
                                    phi_1748_ = _e1105;
                                    phi_1749_ = _e1079;
                                    phi_1750_ = _e1075;
                                } else {
                                    phi_1747_ = _e1079;
                                    phi_1748_ = _e1075;
                                    phi_1749_ = _e1109;
                                    phi_1750_ = _e1105;
                                }
                                let _e1120 = phi_1747_;
                                let _e1122 = phi_1748_;
                                let _e1124 = phi_1749_;
                                let _e1126 = phi_1750_;
                                let _e1129 = ((_e1126 * _e1120) - (_e1124 * _e1122));
                                if _e1118 {
                                    phi_1758_ = -(_e1129);
                                } else {
                                    phi_1758_ = _e1129;
                                }
                                let _e1132 = phi_1758_;
                                if (_e1105 < _e1045) {
                                    phi_1769_ = true;
                                } else {
                                    if (_e1105 == _e1045) {
                                        phi_1768_ = (_e1109 < _e1049);
                                    } else {
                                        phi_1768_ = false;
                                    }
                                    let _e1137 = phi_1768_;
                                    phi_1769_ = _e1137;
                                }
                                let _e1139 = phi_1769_;
                                if _e1139 {
                                    phi_1773_ = _e1049;
                                    phi_1774_ = _e1045;
                                    phi_1775_ = _e1109;
                                    phi_1776_ = _e1105;
                                } else {
                                    phi_1773_ = _e1109;
                                    phi_1774_ = _e1105;
                                    phi_1775_ = _e1049;
                                    phi_1776_ = _e1045;
                                }
                                let _e1141 = phi_1773_;
                                let _e1143 = phi_1774_;
                                let _e1145 = phi_1775_;
                                let _e1147 = phi_1776_;
                                let _e1150 = ((_e1147 * _e1141) - (_e1145 * _e1143));
                                if _e1139 {
                                    phi_1784_ = -(_e1150);
                                } else {
                                    phi_1784_ = _e1150;
                                }
                                let _e1153 = phi_1784_;
                                if (_e1045 < _e1075) {
                                    phi_1795_ = true;
                                } else {
                                    if (_e1045 == _e1075) {
                                        phi_1794_ = (_e1049 < _e1079);
                                    } else {
                                        phi_1794_ = false;
                                    }
                                    let _e1158 = phi_1794_;
                                    phi_1795_ = _e1158;
                                }
                                let _e1160 = phi_1795_;
                                if _e1160 {
                                    phi_1799_ = _e1079;
                                    phi_1800_ = _e1075;
                                    phi_1801_ = _e1049;
                                    phi_1802_ = _e1045;
                                } else {
                                    phi_1799_ = _e1049;
                                    phi_1800_ = _e1045;
                                    phi_1801_ = _e1079;
                                    phi_1802_ = _e1075;
                                }
                                let _e1162 = phi_1799_;
                                let _e1164 = phi_1800_;
                                let _e1166 = phi_1801_;
                                let _e1168 = phi_1802_;
                                let _e1171 = ((_e1168 * _e1162) - (_e1166 * _e1164));
                                if _e1160 {
                                    phi_1810_ = -(_e1171);
                                } else {
                                    phi_1810_ = _e1171;
                                }
                                let _e1174 = phi_1810_;
                                if (_e1132 >= 0f) {
                                    if (_e1153 >= 0f) {
                                        if (_e1174 >= 0f) {
                                            phi_1825_ = ((_e1132 + _e1153) + _e1174);
                                            phi_1826_ = false;
                                        } else {
                                            phi_1825_ = f32();
                                            phi_1826_ = true;
                                        }
                                        let _e1181 = phi_1825_;
                                        let _e1183 = phi_1826_;
                                        phi_1827_ = _e1181;
                                        phi_1828_ = _e1183;
                                    } else {
                                        phi_1827_ = f32();
                                        phi_1828_ = true;
                                    }
                                    let _e1185 = phi_1827_;
                                    let _e1187 = phi_1828_;
                                    phi_1829_ = _e1185;
                                    phi_1830_ = _e1187;
                                } else {
                                    phi_1829_ = f32();
                                    phi_1830_ = true;
                                }
                                let _e1189 = phi_1829_;
                                let _e1191 = phi_1830_;
                                if _e1191 {
                                    if (_e1132 <= 0f) {
                                        if (_e1153 <= 0f) {
                                            let _e1194 = (_e1174 <= 0f);
                                            if _e1194 {
                                            }
                                            phi_1848_ = ((_e1132 + _e1153) + _e1174);
                                            phi_1849_ = false;
                                            phi_1850_ = _e1194;
                                        } else {
                                            phi_1848_ = f32();
                                            phi_1849_ = true;
                                            phi_1850_ = false;
                                        }
                                        let _e1198 = phi_1848_;
                                        let _e1200 = phi_1849_;
                                        let _e1202 = phi_1850_;
                                        phi_1851_ = _e1198;
                                        phi_1852_ = _e1200;
                                        phi_1853_ = _e1202;
                                    } else {
                                        phi_1851_ = f32();
                                        phi_1852_ = true;
                                        phi_1853_ = false;
                                    }
                                    let _e1204 = phi_1851_;
                                    let _e1206 = phi_1852_;
                                    let _e1208 = phi_1853_;
                                    if _e1206 {
                                        phi_1857_ = false;
                                    } else {
                                        phi_1857_ = _e1208;
                                    }
                                    let _e1210 = phi_1857_;
                                    phi_1858_ = _e1204;
                                    phi_1859_ = _e1210;
                                } else {
                                    phi_1858_ = _e1189;
                                    phi_1859_ = true;
                                }
                                let _e1212 = phi_1858_;
                                let _e1214 = phi_1859_;
                                if _e1214 {
                                    let _e1215 = (_e1212 == 0f);
                                    if _e1215 {
                                        phi_2063_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1221 = ((((_e1132 * (_e413 * _e1041.z)) + (_e1153 * (_e413 * _e1071.z))) + (_e1174 * (_e413 * _e1101.z))) / _e1212);
                                        let _e1223 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1225 = triangles.member[(0u + _e1016)].v1_;
                                        if (_e1223.x < _e1225.x) {
                                            phi_1885_ = _e1223.x;
                                        } else {
                                            phi_1885_ = _e1225.x;
                                        }
                                        let _e1232 = phi_1885_;
                                        if (_e1223.y < _e1225.y) {
                                            phi_1894_ = _e1223.y;
                                        } else {
                                            phi_1894_ = _e1225.y;
                                        }
                                        let _e1239 = phi_1894_;
                                        if (_e1223.z < _e1225.z) {
                                            phi_1903_ = _e1223.z;
                                        } else {
                                            phi_1903_ = _e1225.z;
                                        }
                                        let _e1246 = phi_1903_;
                                        let _e1248 = triangles.member[(0u + _e1016)].v2_;
                                        if (_e1232 < _e1248.x) {
                                            phi_1912_ = _e1232;
                                        } else {
                                            phi_1912_ = _e1248.x;
                                        }
                                        let _e1253 = phi_1912_;
                                        if (_e1239 < _e1248.y) {
                                            phi_1919_ = _e1239;
                                        } else {
                                            phi_1919_ = _e1248.y;
                                        }
                                        let _e1258 = phi_1919_;
                                        if (_e1246 < _e1248.z) {
                                            phi_1926_ = _e1246;
                                        } else {
                                            phi_1926_ = _e1248.z;
                                        }
                                        let _e1263 = phi_1926_;
                                        let _e1265 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1267 = triangles.member[(0u + _e1016)].v1_;
                                        if (_e1265.x > _e1267.x) {
                                            phi_1939_ = _e1265.x;
                                        } else {
                                            phi_1939_ = _e1267.x;
                                        }
                                        let _e1274 = phi_1939_;
                                        if (_e1265.y > _e1267.y) {
                                            phi_1948_ = _e1265.y;
                                        } else {
                                            phi_1948_ = _e1267.y;
                                        }
                                        let _e1281 = phi_1948_;
                                        if (_e1265.z > _e1267.z) {
                                            phi_1957_ = _e1265.z;
                                        } else {
                                            phi_1957_ = _e1267.z;
                                        }
                                        let _e1288 = phi_1957_;
                                        let _e1290 = triangles.member[(0u + _e1016)].v2_;
                                        if (_e1274 > _e1290.x) {
                                            phi_1966_ = _e1274;
                                        } else {
                                            phi_1966_ = _e1290.x;
                                        }
                                        let _e1295 = phi_1966_;
                                        if (_e1281 > _e1290.y) {
                                            phi_1973_ = _e1281;
                                        } else {
                                            phi_1973_ = _e1290.y;
                                        }
                                        let _e1300 = phi_1973_;
                                        if (_e1288 > _e1290.z) {
                                            phi_1980_ = _e1288;
                                        } else {
                                            phi_1980_ = _e1290.z;
                                        }
                                        let _e1305 = phi_1980_;
                                        let _e1312 = ((_e1253 - _e147.origin.x) * _e301);
                                        let _e1313 = ((_e1258 - _e147.origin.y) * _e313);
                                        let _e1314 = ((_e1263 - _e147.origin.z) * _e325);
                                        let _e1321 = ((_e1295 - _e147.origin.x) * _e301);
                                        let _e1322 = ((_e1300 - _e147.origin.y) * _e313);
                                        let _e1323 = ((_e1305 - _e147.origin.z) * _e325);
                                        if (_e1312 < _e1321) {
                                            phi_2003_ = _e1312;
                                        } else {
                                            phi_2003_ = _e1321;
                                        }
                                        let _e1326 = phi_2003_;
                                        if (_e1313 < _e1322) {
                                            phi_2008_ = _e1313;
                                        } else {
                                            phi_2008_ = _e1322;
                                        }
                                        let _e1329 = phi_2008_;
                                        if (_e1314 < _e1323) {
                                            phi_2013_ = _e1314;
                                        } else {
                                            phi_2013_ = _e1323;
                                        }
                                        let _e1332 = phi_2013_;
                                        if (_e1312 > _e1321) {
                                            phi_2021_ = _e1312;
                                        } else {
                                            phi_2021_ = _e1321;
                                        }
                                        let _e1338 = phi_2021_;
                                        if (_e1313 > _e1322) {
                                            phi_2026_ = _e1313;
                                        } else {
                                            phi_2026_ = _e1322;
                                        }
                                        let _e1341 = phi_2026_;
                                        if (_e1314 > _e1323) {
                                            phi_2031_ = _e1314;
                                        } else {
                                            phi_2031_ = _e1323;
                                        }
                                        let _e1344 = phi_2031_;
                                        let _e1348 = core_intrinsics_maximum_number_nsz_f32_((_e1326 - _e369), (_e1329 - _e370));
                                        let _e1349 = core_intrinsics_maximum_number_nsz_f32_(_e1348, (_e1332 - _e371));
                                        let _e1350 = core_intrinsics_minimum_number_nsz_f32_((_e1338 + _e369), (_e1341 + _e370));
                                        let _e1351 = core_intrinsics_minimum_number_nsz_f32_(_e1350, (_e1344 + _e371));
                                        if (_e1349 > -300000000000000000000000000000000000000f) {
                                            phi_2043_ = _e1349;
                                        } else {
                                            phi_2043_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1354 = phi_2043_;
                                        if (_e1351 < 300000000000000000000000000000000000000f) {
                                            phi_2048_ = _e1351;
                                        } else {
                                            phi_2048_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1357 = phi_2048_;
                                        if (_e1221 < _e1354) {
                                            phi_2053_ = _e1354;
                                        } else {
                                            phi_2053_ = _e1221;
                                        }
                                        let _e1360 = phi_2053_;
                                        if (_e1360 > _e1357) {
                                            phi_2058_ = _e1357;
                                        } else {
                                            phi_2058_ = _e1360;
                                        }
                                        let _e1363 = phi_2058_;
                                        phi_2063_ = lt_bvh_triangle_Intersection(_e1363, (_e1153 / _e1212), (_e1174 / _e1212), (_e1354 <= _e1357));
                                    }
                                    let _e1369 = phi_2063_;
                                    phi_2064_ = _e1369;
                                    phi_2065_ = _e1215;
                                } else {
                                    phi_2064_ = lt_bvh_triangle_Intersection();
                                    phi_2065_ = true;
                                }
                                let _e1371 = phi_2064_;
                                let _e1373 = phi_2065_;
                                if _e1373 {
                                    phi_2069_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2069_ = _e1371;
                                }
                                let _e1375 = phi_2069_;
                                if _e1375.is_hit {
                                    if (_e1375.t > _e147.tmin) {
                                        if (_e1375.t < _e1005.t) {
                                            phi_2118_ = true;
                                        } else {
                                            if (_e1375.t == _e1005.t) {
                                                if (_e1005.triangle != 4294967295u) {
                                                    if (_e1016 < _e1005.triangle) {
                                                        phi_2109_ = true;
                                                    } else {
                                                        if (_e1016 == _e1005.triangle) {
                                                            phi_2108_ = (4294967295u < _e1005.instance);
                                                        } else {
                                                            phi_2108_ = false;
                                                        }
                                                        let _e1394 = phi_2108_;
                                                        phi_2109_ = _e1394;
                                                    }
                                                    let _e1396 = phi_2109_;
                                                    phi_2110_ = _e1396;
                                                    phi_2111_ = false;
                                                } else {
                                                    phi_2110_ = bool();
                                                    phi_2111_ = true;
                                                }
                                                let _e1398 = phi_2110_;
                                                let _e1400 = phi_2111_;
                                                phi_2112_ = _e1398;
                                                phi_2113_ = _e1400;
                                            } else {
                                                phi_2112_ = bool();
                                                phi_2113_ = true;
                                            }
                                            let _e1402 = phi_2112_;
                                            let _e1404 = phi_2113_;
                                            if _e1404 {
                                                phi_2117_ = false;
                                            } else {
                                                phi_2117_ = _e1402;
                                            }
                                            let _e1406 = phi_2117_;
                                            phi_2118_ = _e1406;
                                        }
                                        let _e1408 = phi_2118_;
                                        if _e1408 {
                                            let _e1410 = triangles.member[(0u + _e1016)].i0_;
                                            if ((_e1410 & 2147483648u) == 0u) {
                                                phi_2132_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2132_ = true;
                                            }
                                            let _e1414 = phi_2132_;
                                            if _e1414 {
                                                phi_2140_ = lt_bvh_Hit(_e1375.t, _e1375.u, _e1375.v, _e1016, 4294967295u);
                                            } else {
                                                phi_2140_ = _e1005;
                                            }
                                            let _e1420 = phi_2140_;
                                            phi_2141_ = _e1420;
                                        } else {
                                            phi_2141_ = _e1005;
                                        }
                                        let _e1422 = phi_2141_;
                                        phi_2142_ = _e1422;
                                    } else {
                                        phi_2142_ = _e1005;
                                    }
                                    let _e1424 = phi_2142_;
                                    phi_2143_ = _e1424;
                                } else {
                                    phi_2143_ = _e1005;
                                }
                                let _e1426 = phi_2143_;
                                phi_1605_ = _e1426;
                                phi_1608_ = (_e1007 & (_e1007 - 1u));
                                phi_2144_ = true;
                            }
                            let _e1428 = phi_1605_;
                            let _e1430 = phi_1608_;
                            let _e1432 = phi_2144_;
                            continue;
                            continuing {
                                phi_1604_ = _e1428;
                                phi_1607_ = _e1430;
                                break if !(_e1432);
                            }
                        }
                        let _e1435 = local_3.group_mask;
                        if ((_e1435 & 4278190080u) == 0u) {
                            let _e1439 = local_3.len;
                            if (_e1439 == 0u) {
                                phi_2183_ = false;
                            } else {
                                let _e1443 = local_3.len;
                                local_3.len = (_e1443 - 1u);
                                let _e1446 = local_3.len;
                                if (_e1446 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1451 = local_3.first[(0u + _e1446)];
                                local_3.group = _e1451;
                                let _e1454 = local_3.len;
                                if (_e1454 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1459 = local_3.mask[(0u + _e1454)];
                                local_3.group_mask = _e1459;
                                phi_2183_ = true;
                            }
                            let _e1462 = phi_2183_;
                            phi_2184_ = _e1462;
                        } else {
                            phi_2184_ = true;
                        }
                        let _e1464 = phi_2184_;
                        if _e1464 {
                            let _e1466 = local_3.group_mask;
                            let _e1472 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1466)), 32u, (_e1466 == 0u)));
                            let _e1476 = local_3.group_mask;
                            let _e1490 = local_3.group_mask;
                            local_3.group_mask = (_e1490 & ~((1u << bitcast<u32>((_e1472 & 31u)))));
                            let _e1493 = local_3.group;
                            phi_2215_ = (_e1493 + countOneBits(((_e1476 & ~((4294967295u << bitcast<u32>((((_e1472 - 24u) ^ _e424) & 31u))))) & 255u)));
                        } else {
                            phi_2215_ = 4294967295u;
                        }
                        let _e1496 = phi_2215_;
                        let _e2038 = local_7;
                        phi_1268_ = _e2038;
                        phi_1271_ = _e1496;
                    } else {
                        phi_1268_ = lt_bvh_Hit();
                        phi_1271_ = u32();
                    }
                    let _e1498 = phi_1268_;
                    let _e1500 = phi_1271_;
                    continue;
                    continuing {
                        phi_1267_ = _e1498;
                        phi_1270_ = _e1500;
                        break if !(_e565);
                    }
                }
                let _e2042 = local_8;
                phi_2216_ = _e2042;
            }
            let _e1503 = phi_2216_;
            phi_2217_ = _e1503;
            phi_2218_ = _e219;
        } else {
            phi_2217_ = lt_bvh_Hit();
            phi_2218_ = true;
        }
        let _e1505 = phi_2217_;
        let _e1507 = phi_2218_;
        if _e1507 {
            phi_2222_ = _e149;
        } else {
            phi_2222_ = _e1505;
        }
        let _e1509 = phi_2222_;
        if (_e1509.triangle != 4294967295u) {
            let _e1514 = lt_shaders_surface_barycentric_weights(_e1509.u, _e1509.v);
            if (_e1509.triangle < _e74) {
            } else {
                return;
            }
            let _e1519 = triangles.member[(0u + _e1509.triangle)];
            let _e1547 = (((_e1519.v0_.x * _e1514.x) + (_e1519.v1_.x * _e1514.y)) + (_e1519.v2_.x * _e1514.z));
            let _e1548 = (((_e1519.v0_.y * _e1514.x) + (_e1519.v1_.y * _e1514.y)) + (_e1519.v2_.y * _e1514.z));
            let _e1549 = (((_e1519.v0_.z * _e1514.x) + (_e1519.v1_.z * _e1514.y)) + (_e1519.v2_.z * _e1514.z));
            let _e1552 = abs(_e1519.v0_.x);
            let _e1554 = abs(_e1519.v0_.y);
            let _e1556 = abs(_e1519.v0_.z);
            let _e1558 = abs(_e1519.v1_.x);
            let _e1560 = abs(_e1519.v1_.y);
            let _e1562 = abs(_e1519.v1_.z);
            if (_e1552 > _e1558) {
                phi_2288_ = _e1552;
            } else {
                phi_2288_ = _e1558;
            }
            let _e1565 = phi_2288_;
            if (_e1554 > _e1560) {
                phi_2293_ = _e1554;
            } else {
                phi_2293_ = _e1560;
            }
            let _e1568 = phi_2293_;
            if (_e1556 > _e1562) {
                phi_2298_ = _e1556;
            } else {
                phi_2298_ = _e1562;
            }
            let _e1571 = phi_2298_;
            let _e1573 = abs(_e1519.v2_.x);
            let _e1575 = abs(_e1519.v2_.y);
            let _e1577 = abs(_e1519.v2_.z);
            if (_e1565 > _e1573) {
                phi_2309_ = _e1565;
            } else {
                phi_2309_ = _e1573;
            }
            let _e1580 = phi_2309_;
            if (_e1568 > _e1575) {
                phi_2314_ = _e1568;
            } else {
                phi_2314_ = _e1575;
            }
            let _e1583 = phi_2314_;
            if (_e1571 > _e1577) {
                phi_2319_ = _e1571;
            } else {
                phi_2319_ = _e1577;
            }
            let _e1586 = phi_2319_;
            let _e1589 = (_e1519.v1_.x - _e1519.v0_.x);
            let _e1592 = (_e1519.v1_.y - _e1519.v0_.y);
            let _e1595 = (_e1519.v1_.z - _e1519.v0_.z);
            let _e1598 = (_e1519.v2_.x - _e1519.v0_.x);
            let _e1601 = (_e1519.v2_.y - _e1519.v0_.y);
            let _e1604 = (_e1519.v2_.z - _e1519.v0_.z);
            let _e1608 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1592), abs(_e1595));
            let _e1609 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1589), _e1608);
            let _e1610 = (_e1589 / _e1609);
            let _e1611 = (_e1592 / _e1609);
            let _e1612 = (_e1595 / _e1609);
            let _e1616 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1601), abs(_e1604));
            let _e1617 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1598), _e1616);
            let _e1618 = (_e1598 / _e1617);
            let _e1619 = (_e1601 / _e1617);
            let _e1620 = (_e1604 / _e1617);
            let _e1623 = ((_e1611 * _e1620) - (_e1619 * _e1612));
            let _e1626 = ((_e1612 * _e1618) - (_e1620 * _e1610));
            let _e1629 = ((_e1610 * _e1619) - (_e1618 * _e1611));
            let _e1631 = p.member.eye;
            let _e1640 = (1f / sqrt((((_e1623 * _e1623) + (_e1626 * _e1626)) + (_e1629 * _e1629))));
            let _e1645 = lt_shaders_camera_facing(vec3<f32>((_e1623 * _e1640), (_e1626 * _e1640), (_e1629 * _e1640)), (_e1631 - vec3<f32>(_e1547, _e1548, _e1549)));
            if (_e1509.triangle < _e74) {
            } else {
                return;
            }
            let _e1650 = triangles.member[(0u + _e1509.triangle)];
            let _e1652 = (_e1650.i0_ & 2147483647u);
            if (_e1652 < _e77) {
            } else {
                return;
            }
            let _e1658 = vertices.member[(0u + _e1652)];
            if (_e1650.i1_ < _e77) {
            } else {
                return;
            }
            let _e1662 = vertices.member[(0u + _e1650.i1_)];
            if (_e1650.i2_ < _e77) {
            } else {
                return;
            }
            let _e1666 = vertices.member[(0u + _e1650.i2_)];
            let _e1667 = array<abi_Vertex, 3>(_e1658, _e1662, _e1666);
            local_1 = array<abi_Vertex, 3>(abi_Vertex(_e1667[0].u, _e1667[0].v, _e1667[0].normal, _e1667[0].color, _e1667[0].material), abi_Vertex(_e1667[1].u, _e1667[1].v, _e1667[1].normal, _e1667[1].color, _e1667[1].material), abi_Vertex(_e1667[2].u, _e1667[2].v, _e1667[2].normal, _e1667[2].color, _e1667[2].material));
            let _e1692 = local_1[0u].material;
            if (_e1692 < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1696 = materials.member[(0u + _e1692)];
            local_2 = abi_Material(_e1696.base_color, _e1696.cutoff, _e1696.flags, _e1696.alpha_offset, _e1696.alpha_size, _e1696.color_offset, _e1696.color_size, _e1696.pad);
            let _e1706 = lt_shaders_surface_plain_color((&local_2), (&local_1), _e1514);
            let _e1708 = local_2.color_size;
            if (_e1708 == 0u) {
                phi_2552_ = vec3<f32>(1f, 1f, 1f);
            } else {
                let _e1711 = local_2.color_offset;
                let _e1713 = local_2.color_size;
                let _e1715 = local_2.flags;
                local.offset = _e1711;
                local.size = _e1713;
                local.flags = _e1715;
                let _e1719 = lt_shaders_surface_texture_coordinate((&local_1), _e1514);
                let _e1722 = _lt_shaders_texture_TextureView_quad((&local), _e1719.x, _e1719.y);
                if (_e1722.indices[0] < _e86) {
                } else {
                    return;
                }
                let _e1728 = color_texels.member[(0u + _e1722.indices[0])];
                let _e1729 = lt_shaders_texture_unorm_bytes(_e1728);
                if (_e1722.indices[1] < _e86) {
                } else {
                    return;
                }
                let _e1743 = color_texels.member[(0u + _e1722.indices[1])];
                let _e1744 = lt_shaders_texture_unorm_bytes(_e1743);
                if (_e1722.indices[2] < _e86) {
                } else {
                    return;
                }
                let _e1761 = color_texels.member[(0u + _e1722.indices[2])];
                let _e1762 = lt_shaders_texture_unorm_bytes(_e1761);
                if (_e1722.indices[3] < _e86) {
                } else {
                    return;
                }
                let _e1779 = color_texels.member[(0u + _e1722.indices[3])];
                let _e1780 = lt_shaders_texture_unorm_bytes(_e1779);
                let _e1789 = ((((_e1729.x * _e1722.weights.x) + (_e1744.x * _e1722.weights.y)) + (_e1762.x * _e1722.weights.z)) + (_e1780.x * _e1722.weights.w));
                let _e1790 = ((((_e1729.y * _e1722.weights.x) + (_e1744.y * _e1722.weights.y)) + (_e1762.y * _e1722.weights.z)) + (_e1780.y * _e1722.weights.w));
                let _e1791 = ((((_e1729.z * _e1722.weights.x) + (_e1744.z * _e1722.weights.y)) + (_e1762.z * _e1722.weights.z)) + (_e1780.z * _e1722.weights.w));
                phi_2552_ = vec3<f32>((_e1789 * _e1789), (_e1790 * _e1790), (_e1791 * _e1791));
            }
            let _e1797 = phi_2552_;
            let _e1799 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1583, _e1586);
            let _e1800 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1580, _e1799);
            let _e1802 = local_2.flags;
            if ((_e1802 & 2u) == 0u) {
                phi_2563_ = 0u;
            } else {
                phi_2563_ = 1u;
            }
            let _e1806 = phi_2563_;
            let _e1809 = local_1[0u].normal;
            if (_e1809 == 2147516416u) {
                phi_2630_ = _e1645;
            } else {
                let _e1813 = local_1[0u].normal;
                let _e1814 = lt_shaders_surface_octahedral_decode(_e1813);
                let _e1824 = local_1[1u].normal;
                let _e1825 = lt_shaders_surface_octahedral_decode(_e1824);
                let _e1838 = local_1[2u].normal;
                let _e1839 = lt_shaders_surface_octahedral_decode(_e1838);
                let _e1851 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>((((_e1814.x * _e1514.x) + (_e1825.x * _e1514.y)) + (_e1839.x * _e1514.z)), (((_e1814.y * _e1514.x) + (_e1825.y * _e1514.y)) + (_e1839.y * _e1514.z)), (((_e1814.z * _e1514.x) + (_e1825.z * _e1514.y)) + (_e1839.z * _e1514.z))));
                let _e1863 = sqrt((((_e1851.x * _e1851.x) + (_e1851.y * _e1851.y)) + (_e1851.z * _e1851.z)));
                if (_e1863 > 0f) {
                    let _e1867 = lt_shaders_camera_facing((_e1851 / vec3(_e1863)), _e1645);
                    phi_2629_ = _e1867;
                } else {
                    phi_2629_ = _e1645;
                }
                let _e1869 = phi_2629_;
                phi_2630_ = _e1869;
            }
            let _e1871 = phi_2630_;
            let _e1872 = lt_shaders_shade_pack_albedo((_e1706 * _e1797));
            phi_2634_ = abi_Sample(vec3<f32>(_e1547, _e1548, _e1549), _e1800, _e1645, _e1806, _e1871, _e1872);
        } else {
            phi_2634_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e1876 = phi_2634_;
        if (_e92.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e92.first_primitive)] = _e1876;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
