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
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_482_: f32;
    var phi_491_: f32;
    var phi_492_: f32;

    if (param_6 == 0u) {
        phi_482_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e72 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e72 > 1f) {
                phi_480_ = (2f - _e72);
            } else {
                phi_480_ = _e72;
            }
            let _e76 = phi_480_;
            phi_481_ = _e76;
        } else {
            phi_481_ = param_5;
        }
        let _e78 = phi_481_;
        phi_482_ = _e78;
    }
    let _e80 = phi_482_;
    if (_e80 > 0f) {
        if (_e80 < 1f) {
            phi_491_ = _e80;
        } else {
            phi_491_ = 1f;
        }
        let _e84 = phi_491_;
        phi_492_ = _e84;
    } else {
        phi_492_ = 0f;
    }
    let _e86 = phi_492_;
    return _e86;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_418_: u32;
    var phi_432_: u32;
    var phi_439_: u32;
    var phi_444_: u32;
    var phi_450_: u32;
    var phi_455_: u32;
    var phi_457_: texture_Axis;

    let _e67 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e68 = (param_8 - 1u);
    let _e70 = (_e67 * f32(param_8));
    if param_10 {
        let _e77 = select(select(u32(_e70), 0u, (_e70 < bitcast<f32>(0u))), 4294967295u, (_e70 > bitcast<f32>(1333788671u)));
        if (_e68 < _e77) {
            phi_418_ = _e68;
        } else {
            phi_418_ = _e77;
        }
        let _e80 = phi_418_;
        phi_457_ = texture_Axis(_e80, _e80, 0f);
    } else {
        let _e82 = (_e70 + 0.5f);
        let _e89 = select(select(u32(_e82), 0u, (_e82 < bitcast<f32>(0u))), 4294967295u, (_e82 > bitcast<f32>(1333788671u)));
        if (param_8 < _e89) {
            phi_432_ = param_8;
        } else {
            phi_432_ = _e89;
        }
        let _e92 = phi_432_;
        if (param_9 == 0u) {
            phi_439_ = _e68;
        } else {
            phi_439_ = 0u;
        }
        let _e97 = phi_439_;
        if (param_9 == 0u) {
            phi_444_ = 0u;
        } else {
            phi_444_ = _e68;
        }
        let _e100 = phi_444_;
        if (_e92 == 0u) {
            phi_450_ = _e97;
        } else {
            phi_450_ = (_e92 - 1u);
        }
        let _e104 = phi_450_;
        if (_e92 > _e68) {
            phi_455_ = _e100;
        } else {
            phi_455_ = _e92;
        }
        let _e107 = phi_455_;
        phi_457_ = texture_Axis(_e104, _e107, (_e82 - f32(_e92)));
    }
    let _e110 = phi_457_;
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
    var phi_512_: lt_bvh_traverse_Tree;
    var phi_513_: bool;
    var phi_514_: lt_bvh_traverse_Tree;
    var phi_515_: bool;
    var phi_520_: lt_bvh_traverse_Tree;

    if (param_14.x < param_15) {
        if (param_14.y < param_16) {
            phi_512_ = lt_bvh_traverse_Tree(1u, ((param_14.y * param_15) + param_14.x));
            phi_513_ = false;
        } else {
            phi_512_ = lt_bvh_traverse_Tree();
            phi_513_ = true;
        }
        let _e76 = phi_512_;
        let _e78 = phi_513_;
        phi_514_ = _e76;
        phi_515_ = _e78;
    } else {
        phi_514_ = lt_bvh_traverse_Tree();
        phi_515_ = true;
    }
    let _e80 = phi_514_;
    let _e82 = phi_515_;
    if _e82 {
        phi_520_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_520_ = _e80;
    }
    let _e87 = phi_520_;
    return lt_bvh_traverse_Tree(_e87.root, _e87.first_primitive);
}

fn lt_shaders_shade_unit(param_17: f32) -> f32 {
    var phi_534_: f32;
    var phi_535_: f32;

    if (param_17 > 0f) {
        if (param_17 < 1f) {
            phi_534_ = param_17;
        } else {
            phi_534_ = 1f;
        }
        let _e67 = phi_534_;
        phi_535_ = _e67;
    } else {
        phi_535_ = 0f;
    }
    let _e69 = phi_535_;
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
    var phi_590_: bool;
    var phi_594_: f32;

    if (param_22 != param_22) {
        phi_590_ = true;
    } else {
        let _e66 = (param_23 >= param_22);
        if _e66 {
        }
        phi_590_ = _e66;
    }
    let _e68 = phi_590_;
    if _e68 {
        phi_594_ = param_23;
    } else {
        phi_594_ = param_22;
    }
    let _e70 = phi_594_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_24: f32, param_25: f32) -> f32 {
    var phi_606_: bool;
    var phi_610_: f32;

    if (param_24 != param_24) {
        phi_606_ = true;
    } else {
        let _e66 = (param_25 <= param_24);
        if _e66 {
        }
        phi_606_ = _e66;
    }
    let _e68 = phi_606_;
    if _e68 {
        phi_610_ = param_25;
    } else {
        phi_610_ = param_24;
    }
    let _e70 = phi_610_;
    return _e70;
}

fn lt_shaders_surface_barycentric_weights(param_26: f32, param_27: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_26) - param_27), param_26, param_27);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_28: f32, param_29: f32) -> f32 {
    var phi_624_: f32;

    if (param_28 > param_29) {
        phi_624_ = param_28;
    } else {
        phi_624_ = param_29;
    }
    let _e67 = phi_624_;
    return _e67;
}

fn lt_shaders_camera_facing(param_30: vec3<f32>, param_31: vec3<f32>) -> vec3<f32> {
    var phi_644_: vec3<f32>;

    if ((((param_30.x * param_31.x) + (param_30.y * param_31.y)) + (param_30.z * param_31.z)) < 0f) {
        phi_644_ = -(param_30);
    } else {
        phi_644_ = param_30;
    }
    let _e79 = phi_644_;
    return _e79;
}

fn lt_shaders_surface_plain_color(param_32: ptr<function, abi_Material>, param_33: ptr<function, array<abi_Vertex, 3>>, param_34: vec3<f32>) -> vec3<f32> {
    let _e67 = (*param_32).base_color;
    let _e71 = lt_shaders_surface_vertex_color(param_33, param_34);
    return vec3<f32>((_e67.x * _e71.x), (_e67.y * _e71.y), (_e67.z * _e71.z));
}

fn lt_shaders_surface_octahedral_decode(param_35: u32) -> vec3<f32> {
    var phi_684_: f32;
    var phi_691_: f32;
    var phi_698_: f32;

    let _e71 = (f32((bitcast<i32>((param_35 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e77 = (f32((bitcast<i32>(param_35) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e81 = ((1f - abs(_e71)) - abs(_e77));
    if (_e81 < 0f) {
        phi_684_ = -(_e81);
    } else {
        phi_684_ = 0f;
    }
    let _e85 = phi_684_;
    if (_e71 < 0f) {
        phi_691_ = (_e71 + _e85);
    } else {
        phi_691_ = (_e71 - _e85);
    }
    let _e90 = phi_691_;
    if (_e77 < 0f) {
        phi_698_ = (_e77 + _e85);
    } else {
        phi_698_ = (_e77 - _e85);
    }
    let _e95 = phi_698_;
    let _e102 = (1f / sqrt((((_e90 * _e90) + (_e95 * _e95)) + (_e81 * _e81))));
    return vec3<f32>((_e90 * _e102), (_e95 * _e102), (_e81 * _e102));
}

fn lt_shaders_shade_pack_albedo(param_36: vec3<f32>) -> u32 {
    let _e65 = lt_shaders_shade_unit(param_36.x);
    let _e66 = lt_shaders_shade_sqrt(_e65);
    let _e68 = lt_shaders_shade_unit(param_36.y);
    let _e69 = lt_shaders_shade_sqrt(_e68);
    let _e71 = lt_shaders_shade_unit(param_36.z);
    let _e72 = lt_shaders_shade_sqrt(_e71);
    let _e74 = lt_shaders_shade_pack_bytes(vec3<f32>(_e66, _e69, _e72));
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: abi_Material;
    var local_3: lt_bvh_traverse_Stack;
    var local_4: lt_bvh_traverse_Stack;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_879_: bool;
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
    var phi_900_: bool;
    var phi_904_: bool;
    var phi_979_: f32;
    var phi_986_: f32;
    var phi_994_: f32;
    var phi_1001_: f32;
    var phi_1009_: f32;
    var phi_1016_: f32;
    var phi_1041_: f32;
    var phi_1046_: f32;
    var phi_1051_: f32;
    var phi_1073_: u32;
    var phi_1078_: u32;
    var phi_1083_: u32;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1229_: u32;
    var phi_1231_: u32;
    var phi_1234_: lt_bvh_Hit;
    var phi_1319_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1346_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1373_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1379_: u32;
    var phi_1382_: u32;
    var phi_1396_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1434_: u32;
    var phi_1444_: u32;
    var phi_1454_: u32;
    var phi_1490_: u32;
    var phi_1503_: u32;
    var phi_1508_: u32;
    var phi_1509_: u32;
    var phi_1510_: u32;
    var phi_1380_: u32;
    var phi_1383_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1568_: u32;
    var phi_1571_: lt_bvh_Hit;
    var phi_1626_: f32;
    var phi_1631_: f32;
    var phi_1636_: f32;
    var phi_1644_: f32;
    var phi_1649_: f32;
    var phi_1654_: f32;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var phi_1811_: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1818_: bool;
    var phi_1819_: bool;
    var phi_1820_: bool;
    var phi_1821_: bool;
    var phi_1822_: bool;
    var phi_1823_: bool;
    var phi_1824_: bool;
    var phi_1825_: bool;
    var phi_1826_: bool;
    var phi_1827_: bool;
    var phi_1828_: bool;
    var phi_1829_: bool;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1832_: bool;
    var phi_1836_: bool;
    var phi_1840_: bool;
    var phi_1910_: f32;
    var phi_1917_: f32;
    var phi_1924_: f32;
    var phi_1931_: f32;
    var phi_1938_: f32;
    var phi_1945_: f32;
    var phi_1962_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_2000_: bool;
    var phi_2001_: bool;
    var phi_2009_: u32;
    var phi_2010_: u32;
    var phi_2021_: vec3<f32>;
    var phi_2022_: vec3<f32>;
    var phi_2035_: u32;
    var phi_2040_: u32;
    var phi_2045_: u32;
    var phi_2159_: bool;
    var phi_2160_: bool;
    var phi_2191_: u32;
    var phi_2193_: lt_bvh_Hit;
    var phi_2196_: u32;
    var phi_2277_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2304_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2331_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2337_: u32;
    var phi_2340_: u32;
    var phi_2354_: u32;
    var phi_2364_: u32;
    var phi_2374_: u32;
    var phi_2392_: u32;
    var phi_2402_: u32;
    var phi_2412_: u32;
    var phi_2448_: u32;
    var phi_2461_: u32;
    var phi_2466_: u32;
    var phi_2467_: u32;
    var phi_2468_: u32;
    var phi_2338_: u32;
    var phi_2341_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_2526_: lt_bvh_Hit;
    var phi_2529_: u32;
    var phi_2573_: vec3<f32>;
    var phi_2574_: vec3<f32>;
    var phi_2605_: vec3<f32>;
    var phi_2606_: vec3<f32>;
    var phi_2637_: vec3<f32>;
    var phi_2638_: vec3<f32>;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2663_: f32;
    var phi_2664_: f32;
    var phi_2665_: f32;
    var phi_2666_: f32;
    var phi_2674_: f32;
    var phi_2684_: bool;
    var phi_2685_: bool;
    var phi_2689_: f32;
    var phi_2690_: f32;
    var phi_2691_: f32;
    var phi_2692_: f32;
    var phi_2700_: f32;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2715_: f32;
    var phi_2716_: f32;
    var phi_2717_: f32;
    var phi_2718_: f32;
    var phi_2726_: f32;
    var phi_2741_: f32;
    var phi_2742_: bool;
    var phi_2743_: f32;
    var phi_2744_: bool;
    var phi_2745_: f32;
    var phi_2746_: bool;
    var phi_2764_: f32;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2767_: f32;
    var phi_2768_: bool;
    var phi_2769_: bool;
    var phi_2773_: bool;
    var phi_2774_: f32;
    var phi_2775_: bool;
    var phi_2801_: f32;
    var phi_2810_: f32;
    var phi_2819_: f32;
    var phi_2828_: f32;
    var phi_2835_: f32;
    var phi_2842_: f32;
    var phi_2855_: f32;
    var phi_2864_: f32;
    var phi_2873_: f32;
    var phi_2882_: f32;
    var phi_2889_: f32;
    var phi_2896_: f32;
    var phi_2913_: f32;
    var phi_2918_: f32;
    var phi_2923_: f32;
    var phi_2931_: f32;
    var phi_2936_: f32;
    var phi_2941_: f32;
    var phi_2953_: f32;
    var phi_2958_: f32;
    var phi_2963_: f32;
    var phi_2968_: f32;
    var phi_2973_: lt_bvh_triangle_Intersection;
    var phi_2974_: lt_bvh_triangle_Intersection;
    var phi_2975_: bool;
    var phi_2979_: lt_bvh_triangle_Intersection;
    var phi_3017_: bool;
    var phi_3018_: bool;
    var phi_3019_: bool;
    var phi_3020_: bool;
    var phi_3021_: bool;
    var phi_3022_: bool;
    var phi_3026_: bool;
    var phi_3027_: bool;
    var phi_3041_: bool;
    var phi_3049_: lt_bvh_Hit;
    var phi_3050_: lt_bvh_Hit;
    var phi_3051_: lt_bvh_Hit;
    var phi_3052_: lt_bvh_Hit;
    var phi_2527_: lt_bvh_Hit;
    var phi_2530_: u32;
    var phi_3053_: bool;
    var phi_3092_: bool;
    var phi_3093_: bool;
    var phi_3124_: u32;
    var phi_2194_: lt_bvh_Hit;
    var phi_2197_: u32;
    var phi_3125_: lt_bvh_Hit;
    var phi_3126_: lt_bvh_Hit;
    var phi_3127_: bool;
    var phi_3131_: lt_bvh_Hit;
    var phi_3132_: lt_bvh_Hit;
    var phi_3133_: lt_bvh_Hit;
    var phi_3134_: lt_bvh_Hit;
    var phi_1569_: u32;
    var phi_1572_: lt_bvh_Hit;
    var phi_3135_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3206_: u32;
    var phi_1232_: u32;
    var phi_1235_: lt_bvh_Hit;
    var phi_3207_: lt_bvh_Hit;
    var phi_3208_: lt_bvh_Hit;
    var phi_3209_: bool;
    var phi_3213_: lt_bvh_Hit;
    var phi_3402_: f32;
    var phi_3407_: f32;
    var phi_3412_: f32;
    var phi_3420_: f32;
    var phi_3425_: f32;
    var phi_3430_: f32;
    var phi_3651_: vec3<f32>;
    var phi_3662_: u32;
    var phi_3761_: vec3<f32>;
    var phi_3762_: vec3<f32>;
    var phi_3766_: abi_Sample;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;
    var local_14: lt_bvh_Hit;

    let _e68 = id_1;
    let _e72 = arrayLength((&nodes.member));
    let _e75 = arrayLength((&triangles.member));
    let _e78 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&instances.member));
    let _e90 = arrayLength((&color_texels.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e68, _e93, _e95);
    if (bitcast<i32>(_e96.root) != 0i) {
        let _e102 = p.member.root;
        let _e106 = p.member.eye;
        let _e111 = p.member.size[0u];
        let _e115 = ((((f32(_e68.x) + 0.5f) / f32(_e111)) * 2f) - 1f);
        let _e120 = p.member.size[1u];
        let _e124 = (1f - (((f32(_e68.y) + 0.5f) / f32(_e120)) * 2f));
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
                                    phi_874_ = bool();
                                    phi_875_ = true;
                                } else {
                                    let _e177 = (_e167 > 0f);
                                    if _e177 {
                                        phi_873_ = bool();
                                    } else {
                                        phi_873_ = (_e169 > 0f);
                                    }
                                    let _e180 = phi_873_;
                                    phi_874_ = _e180;
                                    phi_875_ = _e177;
                                }
                                let _e182 = phi_874_;
                                let _e184 = phi_875_;
                                if _e184 {
                                    phi_879_ = true;
                                } else {
                                    phi_879_ = _e182;
                                }
                                let _e186 = phi_879_;
                                phi_880_ = _e186;
                                phi_881_ = false;
                            } else {
                                phi_880_ = bool();
                                phi_881_ = true;
                            }
                            let _e188 = phi_880_;
                            let _e190 = phi_881_;
                            phi_882_ = _e188;
                            phi_883_ = false;
                            phi_884_ = _e190;
                        } else {
                            phi_882_ = bool();
                            phi_883_ = true;
                            phi_884_ = false;
                        }
                        let _e192 = phi_882_;
                        let _e194 = phi_883_;
                        let _e196 = phi_884_;
                        phi_885_ = _e192;
                        phi_886_ = _e194;
                        phi_887_ = _e196;
                    } else {
                        phi_885_ = bool();
                        phi_886_ = true;
                        phi_887_ = false;
                    }
                    let _e198 = phi_885_;
                    let _e200 = phi_886_;
                    let _e202 = phi_887_;
                    phi_888_ = _e198;
                    phi_889_ = _e200;
                    phi_890_ = _e202;
                } else {
                    phi_888_ = bool();
                    phi_889_ = true;
                    phi_890_ = false;
                }
                let _e204 = phi_888_;
                let _e206 = phi_889_;
                let _e208 = phi_890_;
                phi_891_ = _e204;
                phi_892_ = _e206;
                phi_893_ = _e208;
            } else {
                phi_891_ = bool();
                phi_892_ = true;
                phi_893_ = false;
            }
            let _e210 = phi_891_;
            let _e212 = phi_892_;
            let _e214 = phi_893_;
            phi_894_ = _e210;
            phi_895_ = _e212;
            phi_896_ = _e214;
        } else {
            phi_894_ = bool();
            phi_895_ = true;
            phi_896_ = false;
        }
        let _e216 = phi_894_;
        let _e218 = phi_895_;
        let _e220 = phi_896_;
        if _e218 {
            phi_900_ = true;
        } else {
            phi_900_ = _e220;
        }
        let _e222 = phi_900_;
        if _e222 {
            phi_904_ = false;
        } else {
            phi_904_ = _e216;
        }
        let _e224 = phi_904_;
        if _e224 {
            let _e225 = (_e102 >= _e72);
            if _e225 {
                phi_3207_ = lt_bvh_Hit();
            } else {
                if (_e102 < _e72) {
                } else {
                    return;
                }
                let _e231 = nodes.member[(0u + _e102)].frame[0u];
                let _e235 = nodes.member[(0u + _e102)].frame[1u];
                let _e239 = nodes.member[(0u + _e102)].frame[2u];
                let _e243 = nodes.member[(0u + _e102)].frame[0u];
                let _e247 = nodes.member[(0u + _e102)].frame[1u];
                let _e251 = nodes.member[(0u + _e102)].frame[2u];
                let _e255 = nodes.member[(0u + _e102)].frame[3u];
                let _e293 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153.direction.x), abs(_e153.direction.y));
                let _e294 = core_intrinsics_maximum_number_nsz_f32_(_e293, abs(_e153.direction.z));
                let _e295 = (_e294 * 0.0000000000009094947f);
                if (abs(_e153.direction.x) < _e295) {
                    phi_979_ = _e295;
                } else {
                    phi_979_ = abs(_e153.direction.x);
                }
                let _e302 = phi_979_;
                if (_e153.direction.x < 0f) {
                    phi_986_ = (-1f / _e302);
                } else {
                    phi_986_ = (1f / _e302);
                }
                let _e307 = phi_986_;
                if (abs(_e153.direction.y) < _e295) {
                    phi_994_ = _e295;
                } else {
                    phi_994_ = abs(_e153.direction.y);
                }
                let _e314 = phi_994_;
                if (_e153.direction.y < 0f) {
                    phi_1001_ = (-1f / _e314);
                } else {
                    phi_1001_ = (1f / _e314);
                }
                let _e319 = phi_1001_;
                if (abs(_e153.direction.z) < _e295) {
                    phi_1009_ = _e295;
                } else {
                    phi_1009_ = abs(_e153.direction.z);
                }
                let _e326 = phi_1009_;
                if (_e153.direction.z < 0f) {
                    phi_1016_ = (-1f / _e326);
                } else {
                    phi_1016_ = (1f / _e326);
                }
                let _e331 = phi_1016_;
                let _e339 = abs((bitcast<f32>(_e231) - _e153.origin.x));
                let _e340 = abs((bitcast<f32>(_e235) - _e153.origin.y));
                let _e341 = abs((bitcast<f32>(_e239) - _e153.origin.z));
                let _e349 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e255 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.x));
                let _e350 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e255 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.y));
                let _e351 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e255 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.z));
                if (_e339 > _e349) {
                    phi_1041_ = _e339;
                } else {
                    phi_1041_ = _e349;
                }
                let _e354 = phi_1041_;
                if (_e340 > _e350) {
                    phi_1046_ = _e340;
                } else {
                    phi_1046_ = _e350;
                }
                let _e357 = phi_1046_;
                if (_e341 > _e351) {
                    phi_1051_ = _e341;
                } else {
                    phi_1051_ = _e351;
                }
                let _e360 = phi_1051_;
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
                if (_e307 < 0f) {
                    phi_1073_ = 0u;
                } else {
                    phi_1073_ = 1u;
                }
                let _e380 = phi_1073_;
                if (_e319 < 0f) {
                    phi_1078_ = 0u;
                } else {
                    phi_1078_ = 2u;
                }
                let _e383 = phi_1078_;
                if (_e331 < 0f) {
                    phi_1083_ = 0u;
                } else {
                    phi_1083_ = 4u;
                }
                let _e386 = phi_1083_;
                let _e388 = ((_e380 | _e383) | _e386);
                let _e389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e102, 2147483648u);
                local_4 = lt_bvh_traverse_Stack(array<u32, 32>(_e389.first[0], _e389.first[1], _e389.first[2], _e389.first[3], _e389.first[4], _e389.first[5], _e389.first[6], _e389.first[7], _e389.first[8], _e389.first[9], _e389.first[10], _e389.first[11], _e389.first[12], _e389.first[13], _e389.first[14], _e389.first[15], _e389.first[16], _e389.first[17], _e389.first[18], _e389.first[19], _e389.first[20], _e389.first[21], _e389.first[22], _e389.first[23], _e389.first[24], _e389.first[25], _e389.first[26], _e389.first[27], _e389.first[28], _e389.first[29], _e389.first[30], _e389.first[31]), array<u32, 32>(_e389.mask[0], _e389.mask[1], _e389.mask[2], _e389.mask[3], _e389.mask[4], _e389.mask[5], _e389.mask[6], _e389.mask[7], _e389.mask[8], _e389.mask[9], _e389.mask[10], _e389.mask[11], _e389.mask[12], _e389.mask[13], _e389.mask[14], _e389.mask[15], _e389.mask[16], _e389.mask[17], _e389.mask[18], _e389.mask[19], _e389.mask[20], _e389.mask[21], _e389.mask[22], _e389.mask[23], _e389.mask[24], _e389.mask[25], _e389.mask[26], _e389.mask[27], _e389.mask[28], _e389.mask[29], _e389.mask[30], _e389.mask[31]), _e389.len, _e389.group, _e389.group_mask);
                let _e463 = local_4.group_mask;
                if ((_e463 & 4278190080u) == 0u) {
                    let _e467 = local_4.len;
                    if (_e467 == 0u) {
                        phi_1197_ = false;
                    } else {
                        let _e471 = local_4.len;
                        local_4.len = (_e471 - 1u);
                        let _e474 = local_4.len;
                        if (_e474 < 32u) {
                        } else {
                            return;
                        }
                        let _e479 = local_4.first[(0u + _e474)];
                        local_4.group = _e479;
                        let _e482 = local_4.len;
                        if (_e482 < 32u) {
                        } else {
                            return;
                        }
                        let _e487 = local_4.mask[(0u + _e482)];
                        local_4.group_mask = _e487;
                        phi_1197_ = true;
                    }
                    let _e490 = phi_1197_;
                    phi_1198_ = _e490;
                } else {
                    phi_1198_ = true;
                }
                let _e492 = phi_1198_;
                if _e492 {
                    let _e494 = local_4.group_mask;
                    let _e500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u)));
                    let _e504 = local_4.group_mask;
                    let _e518 = local_4.group_mask;
                    local_4.group_mask = (_e518 & ~((1u << bitcast<u32>((_e500 & 31u)))));
                    let _e521 = local_4.group;
                    phi_1229_ = (_e521 + countOneBits(((_e504 & ~((4294967295u << bitcast<u32>((((_e500 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1229_ = 4294967295u;
                }
                let _e524 = phi_1229_;
                phi_1231_ = _e524;
                phi_1234_ = _e155;
                loop {
                    let _e526 = phi_1231_;
                    let _e528 = phi_1234_;
                    local_14 = _e528;
                    let _e529 = (_e526 != 4294967295u);
                    if _e529 {
                        if (_e526 < _e72) {
                        } else {
                            return;
                        }
                        let _e537 = nodes.member[(0u + _e526)].frame[3u];
                        let _e562 = (bitcast<f32>((((_e537 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e307);
                        let _e563 = (bitcast<f32>((((_e537 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e319);
                        let _e564 = (bitcast<f32>((((_e537 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e567 = nodes.member[(0u + _e526)].frame[0u];
                        let _e571 = nodes.member[(0u + _e526)].frame[1u];
                        let _e575 = nodes.member[(0u + _e526)].frame[2u];
                        let _e583 = ((bitcast<f32>(_e567) - _e153.origin.x) * _e307);
                        let _e584 = ((bitcast<f32>(_e571) - _e153.origin.y) * _e319);
                        let _e585 = ((bitcast<f32>(_e575) - _e153.origin.z) * _e331);
                        let _e593 = nodes.member[(0u + _e526)].x;
                        if (_e307 < 0f) {
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.unnamed.root, _e593.w), _e604.unnamed_1);
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e593.x, _e610.unnamed_1.first_primitive));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e616.unnamed, lt_bvh_traverse_Tree(_e616.unnamed_1.root, _e593.y));
                        } else {
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e632.unnamed.root, _e593.y), _e632.unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e593.z, _e638.unnamed_1.first_primitive));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e644.unnamed_1.root, _e593.w));
                        }
                        let _e652 = phi_1319_;
                        let _e662 = nodes.member[(0u + _e526)].y;
                        if (_e319 < 0f) {
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.unnamed.root, _e662.w), _e673.unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e662.x, _e679.unnamed_1.first_primitive));
                            phi_1346_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_bvh_traverse_Tree(_e685.unnamed_1.root, _e662.y));
                        } else {
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e701.unnamed.root, _e662.y), _e701.unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e662.z, _e707.unnamed_1.first_primitive));
                            phi_1346_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e713.unnamed_1.root, _e662.w));
                        }
                        let _e721 = phi_1346_;
                        let _e731 = nodes.member[(0u + _e526)].z;
                        if (_e331 < 0f) {
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e742.unnamed.root, _e731.w), _e742.unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e731.x, _e748.unnamed_1.first_primitive));
                            phi_1373_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_bvh_traverse_Tree(_e754.unnamed_1.root, _e731.y));
                        } else {
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e770.unnamed.root, _e731.y), _e770.unnamed_1);
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_bvh_traverse_Tree(_e731.z, _e776.unnamed_1.first_primitive));
                            phi_1373_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_bvh_traverse_Tree(_e782.unnamed_1.root, _e731.w));
                        }
                        let _e790 = phi_1373_;
                        phi_1379_ = 0u;
                        phi_1382_ = 0u;
                        loop {
                            let _e800 = phi_1379_;
                            let _e802 = phi_1382_;
                            local_5 = _e802;
                            local_6 = _e802;
                            local_7 = _e802;
                            let _e803 = (_e800 < 8u);
                            if _e803 {
                                let _e805 = (_e800 >> bitcast<u32>(2i));
                                let _e806 = (_e800 & 3u);
                                if (_e805 == 0u) {
                                    phi_1396_ = _e652.unnamed.root;
                                } else {
                                    phi_1396_ = _e652.unnamed.first_primitive;
                                }
                                let _e809 = phi_1396_;
                                if (_e805 == 0u) {
                                    phi_1406_ = _e721.unnamed.root;
                                } else {
                                    phi_1406_ = _e721.unnamed.first_primitive;
                                }
                                let _e818 = phi_1406_;
                                if (_e805 == 0u) {
                                    phi_1416_ = _e790.unnamed.root;
                                } else {
                                    phi_1416_ = _e790.unnamed.first_primitive;
                                }
                                let _e827 = phi_1416_;
                                let _e840 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e809 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e562) + (_e583 - _e368)), ((f32(((_e818 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)));
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(_e840, ((f32(((_e827 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                if (_e805 == 0u) {
                                    phi_1434_ = _e652.unnamed_1.root;
                                } else {
                                    phi_1434_ = _e652.unnamed_1.first_primitive;
                                }
                                let _e844 = phi_1434_;
                                if (_e805 == 0u) {
                                    phi_1444_ = _e721.unnamed_1.root;
                                } else {
                                    phi_1444_ = _e721.unnamed_1.first_primitive;
                                }
                                let _e853 = phi_1444_;
                                if (_e805 == 0u) {
                                    phi_1454_ = _e790.unnamed_1.root;
                                } else {
                                    phi_1454_ = _e790.unnamed_1.first_primitive;
                                }
                                let _e862 = phi_1454_;
                                let _e875 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e562) + (_e583 + _e368)), ((f32(((_e853 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)));
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                if (_e841 <= _e876) {
                                    if (_e841 <= _e528.t) {
                                        if (_e876 >= _e153.tmin) {
                                            if (_e805 == 0u) {
                                                let _e883 = nodes.member[(0u + _e526)].links[2u];
                                                phi_1490_ = _e883;
                                            } else {
                                                let _e886 = nodes.member[(0u + _e526)].links[3u];
                                                phi_1490_ = _e886;
                                            }
                                            let _e888 = phi_1490_;
                                            let _e893 = ((_e888 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u);
                                            let _e894 = (_e893 & 31u);
                                            if (_e894 >= 24u) {
                                                phi_1503_ = (24u + ((_e894 - 24u) ^ _e388));
                                            } else {
                                                phi_1503_ = _e894;
                                            }
                                            let _e900 = phi_1503_;
                                            phi_1508_ = (_e802 | ((_e893 >> bitcast<u32>(5i)) << bitcast<u32>((_e900 & 31u))));
                                        } else {
                                            phi_1508_ = _e802;
                                        }
                                        let _e908 = phi_1508_;
                                        phi_1509_ = _e908;
                                    } else {
                                        phi_1509_ = _e802;
                                    }
                                    let _e910 = phi_1509_;
                                    phi_1510_ = _e910;
                                } else {
                                    phi_1510_ = _e802;
                                }
                                let _e912 = phi_1510_;
                                phi_1380_ = (_e800 + 1u);
                                phi_1383_ = _e912;
                            } else {
                                phi_1380_ = u32();
                                phi_1383_ = u32();
                            }
                            let _e915 = phi_1380_;
                            let _e917 = phi_1383_;
                            continue;
                            continuing {
                                phi_1379_ = _e915;
                                phi_1382_ = _e917;
                                break if !(_e803);
                            }
                        }
                        let _e921 = nodes.member[(0u + _e526)].links[0u];
                        let _e925 = nodes.member[(0u + _e526)].frame[3u];
                        let _e929 = local_5;
                        if ((_e929 & 4278190080u) == 0u) {
                        } else {
                            let _e933 = local_4.group_mask;
                            if ((_e933 & 4278190080u) == 0u) {
                            } else {
                                let _e937 = local_4.len;
                                if (_e937 < 32u) {
                                    let _e940 = local_4.group;
                                    let _e942 = local_4.len;
                                    if (_e942 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_4.first[(0u + _e942)] = _e940;
                                    let _e948 = local_4.group_mask;
                                    let _e950 = local_4.len;
                                    if (_e950 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_4.mask[(0u + _e950)] = _e948;
                                    let _e957 = local_4.len;
                                    local_4.len = (_e957 + 1u);
                                }
                            }
                            local_4.group = (_e102 + _e921);
                            let _e961 = local_6;
                            local_4.group_mask = ((_e961 & 4278190080u) | (_e925 >> bitcast<u32>(24i)));
                        }
                        let _e966 = local_7;
                        phi_1568_ = (_e966 & 16777215u);
                        phi_1571_ = _e528;
                        loop {
                            let _e969 = phi_1568_;
                            let _e971 = phi_1571_;
                            local_13 = _e971;
                            if (_e969 == 0u) {
                                phi_1569_ = u32();
                                phi_1572_ = lt_bvh_Hit();
                                phi_3135_ = false;
                            } else {
                                let _e975 = nodes.member[(0u + _e526)].links[1u];
                                let _e979 = (_e975 + select(firstTrailingBit(_e969), 32u, (_e969 == 0u)));
                                if (_e979 < _e87) {
                                } else {
                                    return;
                                }
                                let _e986 = instances.member[(0u + _e979)].low_world;
                                let _e988 = instances.member[(0u + _e979)].high_world;
                                let _e998 = ((_e986.x - _e153.origin.x) * _e307);
                                let _e999 = ((_e986.y - _e153.origin.y) * _e319);
                                let _e1000 = ((_e986.z - _e153.origin.z) * _e331);
                                let _e1010 = ((_e988.x - _e153.origin.x) * _e307);
                                let _e1011 = ((_e988.y - _e153.origin.y) * _e319);
                                let _e1012 = ((_e988.z - _e153.origin.z) * _e331);
                                if (_e998 < _e1010) {
                                    phi_1626_ = _e998;
                                } else {
                                    phi_1626_ = _e1010;
                                }
                                let _e1015 = phi_1626_;
                                if (_e999 < _e1011) {
                                    phi_1631_ = _e999;
                                } else {
                                    phi_1631_ = _e1011;
                                }
                                let _e1018 = phi_1631_;
                                if (_e1000 < _e1012) {
                                    phi_1636_ = _e1000;
                                } else {
                                    phi_1636_ = _e1012;
                                }
                                let _e1021 = phi_1636_;
                                if (_e998 > _e1010) {
                                    phi_1644_ = _e998;
                                } else {
                                    phi_1644_ = _e1010;
                                }
                                let _e1027 = phi_1644_;
                                if (_e999 > _e1011) {
                                    phi_1649_ = _e999;
                                } else {
                                    phi_1649_ = _e1011;
                                }
                                let _e1030 = phi_1649_;
                                if (_e1000 > _e1012) {
                                    phi_1654_ = _e1000;
                                } else {
                                    phi_1654_ = _e1012;
                                }
                                let _e1033 = phi_1654_;
                                let _e1037 = core_intrinsics_maximum_number_nsz_f32_((_e1015 - _e375), (_e1018 - _e376));
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_(_e1037, (_e1021 - _e377));
                                let _e1039 = core_intrinsics_minimum_number_nsz_f32_((_e1027 + _e375), (_e1030 + _e376));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_(_e1039, (_e1033 + _e377));
                                if (_e1038 <= _e1040) {
                                    if (_e1038 <= _e971.t) {
                                        if (_e1040 >= _e153.tmin) {
                                            let _e1052 = instances.member[(0u + _e979)].world_to_object[0u];
                                            let _e1063 = ((((_e1052.x * _e153.origin.x) + (_e1052.y * _e153.origin.y)) + (_e1052.z * _e153.origin.z)) + (_e1052.w * 1f));
                                            let _e1065 = instances.member[(0u + _e979)].world_to_object[1u];
                                            let _e1076 = ((((_e1065.x * _e153.origin.x) + (_e1065.y * _e153.origin.y)) + (_e1065.z * _e153.origin.z)) + (_e1065.w * 1f));
                                            let _e1078 = instances.member[(0u + _e979)].world_to_object[2u];
                                            let _e1089 = ((((_e1078.x * _e153.origin.x) + (_e1078.y * _e153.origin.y)) + (_e1078.z * _e153.origin.z)) + (_e1078.w * 1f));
                                            let _e1096 = instances.member[(0u + _e979)].world_to_object[0u];
                                            let _e1107 = ((((_e1096.x * _e153.direction.x) + (_e1096.y * _e153.direction.y)) + (_e1096.z * _e153.direction.z)) + (_e1096.w * 0f));
                                            let _e1109 = instances.member[(0u + _e979)].world_to_object[1u];
                                            let _e1120 = ((((_e1109.x * _e153.direction.x) + (_e1109.y * _e153.direction.y)) + (_e1109.z * _e153.direction.z)) + (_e1109.w * 0f));
                                            let _e1122 = instances.member[(0u + _e979)].world_to_object[2u];
                                            let _e1133 = ((((_e1122.x * _e153.direction.x) + (_e1122.y * _e153.direction.y)) + (_e1122.z * _e153.direction.z)) + (_e1122.w * 0f));
                                            let _e1137 = instances.member[(0u + _e979)].root;
                                            let _e1139 = instances.member[(0u + _e979)].first_triangle;
                                            let _e1143 = abs(_e1107);
                                            let _e1144 = abs(_e1120);
                                            let _e1145 = abs(_e1133);
                                            if (abs(_e1063) < 1000000000000000f) {
                                                if (abs(_e1076) < 1000000000000000f) {
                                                    if (abs(_e1089) < 1000000000000000f) {
                                                        if (_e1143 < 1000000000000000f) {
                                                            if (_e1144 < 1000000000000000f) {
                                                                if (_e1145 < 1000000000000000f) {
                                                                    if (_e1143 > 0f) {
                                                                        phi_1810_ = bool();
                                                                        phi_1811_ = true;
                                                                    } else {
                                                                        let _e1153 = (_e1144 > 0f);
                                                                        if _e1153 {
                                                                            phi_1809_ = bool();
                                                                        } else {
                                                                            phi_1809_ = (_e1145 > 0f);
                                                                        }
                                                                        let _e1156 = phi_1809_;
                                                                        phi_1810_ = _e1156;
                                                                        phi_1811_ = _e1153;
                                                                    }
                                                                    let _e1158 = phi_1810_;
                                                                    let _e1160 = phi_1811_;
                                                                    if _e1160 {
                                                                        phi_1815_ = true;
                                                                    } else {
                                                                        phi_1815_ = _e1158;
                                                                    }
                                                                    let _e1162 = phi_1815_;
                                                                    phi_1816_ = _e1162;
                                                                    phi_1817_ = false;
                                                                } else {
                                                                    phi_1816_ = bool();
                                                                    phi_1817_ = true;
                                                                }
                                                                let _e1164 = phi_1816_;
                                                                let _e1166 = phi_1817_;
                                                                phi_1818_ = _e1164;
                                                                phi_1819_ = false;
                                                                phi_1820_ = _e1166;
                                                            } else {
                                                                phi_1818_ = bool();
                                                                phi_1819_ = true;
                                                                phi_1820_ = false;
                                                            }
                                                            let _e1168 = phi_1818_;
                                                            let _e1170 = phi_1819_;
                                                            let _e1172 = phi_1820_;
                                                            phi_1821_ = _e1168;
                                                            phi_1822_ = _e1170;
                                                            phi_1823_ = _e1172;
                                                        } else {
                                                            phi_1821_ = bool();
                                                            phi_1822_ = true;
                                                            phi_1823_ = false;
                                                        }
                                                        let _e1174 = phi_1821_;
                                                        let _e1176 = phi_1822_;
                                                        let _e1178 = phi_1823_;
                                                        phi_1824_ = _e1174;
                                                        phi_1825_ = _e1176;
                                                        phi_1826_ = _e1178;
                                                    } else {
                                                        phi_1824_ = bool();
                                                        phi_1825_ = true;
                                                        phi_1826_ = false;
                                                    }
                                                    let _e1180 = phi_1824_;
                                                    let _e1182 = phi_1825_;
                                                    let _e1184 = phi_1826_;
                                                    phi_1827_ = _e1180;
                                                    phi_1828_ = _e1182;
                                                    phi_1829_ = _e1184;
                                                } else {
                                                    phi_1827_ = bool();
                                                    phi_1828_ = true;
                                                    phi_1829_ = false;
                                                }
                                                let _e1186 = phi_1827_;
                                                let _e1188 = phi_1828_;
                                                let _e1190 = phi_1829_;
                                                phi_1830_ = _e1186;
                                                phi_1831_ = _e1188;
                                                phi_1832_ = _e1190;
                                            } else {
                                                phi_1830_ = bool();
                                                phi_1831_ = true;
                                                phi_1832_ = false;
                                            }
                                            let _e1192 = phi_1830_;
                                            let _e1194 = phi_1831_;
                                            let _e1196 = phi_1832_;
                                            if _e1194 {
                                                phi_1836_ = true;
                                            } else {
                                                phi_1836_ = _e1196;
                                            }
                                            let _e1198 = phi_1836_;
                                            if _e1198 {
                                                phi_1840_ = false;
                                            } else {
                                                phi_1840_ = _e1192;
                                            }
                                            let _e1200 = phi_1840_;
                                            if _e1200 {
                                                let _e1201 = (_e1137 >= _e72);
                                                if _e1201 {
                                                    phi_3125_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1137 < _e72) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1207 = nodes.member[(0u + _e1137)].frame[0u];
                                                    let _e1211 = nodes.member[(0u + _e1137)].frame[1u];
                                                    let _e1215 = nodes.member[(0u + _e1137)].frame[2u];
                                                    let _e1219 = nodes.member[(0u + _e1137)].frame[0u];
                                                    let _e1223 = nodes.member[(0u + _e1137)].frame[1u];
                                                    let _e1227 = nodes.member[(0u + _e1137)].frame[2u];
                                                    let _e1231 = nodes.member[(0u + _e1137)].frame[3u];
                                                    let _e1265 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1107), abs(_e1120));
                                                    let _e1266 = core_intrinsics_maximum_number_nsz_f32_(_e1265, abs(_e1133));
                                                    let _e1267 = (_e1266 * 0.0000000000009094947f);
                                                    if (abs(_e1107) < _e1267) {
                                                        phi_1910_ = _e1267;
                                                    } else {
                                                        phi_1910_ = abs(_e1107);
                                                    }
                                                    let _e1272 = phi_1910_;
                                                    if (_e1107 < 0f) {
                                                        phi_1917_ = (-1f / _e1272);
                                                    } else {
                                                        phi_1917_ = (1f / _e1272);
                                                    }
                                                    let _e1277 = phi_1917_;
                                                    if (abs(_e1120) < _e1267) {
                                                        phi_1924_ = _e1267;
                                                    } else {
                                                        phi_1924_ = abs(_e1120);
                                                    }
                                                    let _e1282 = phi_1924_;
                                                    if (_e1120 < 0f) {
                                                        phi_1931_ = (-1f / _e1282);
                                                    } else {
                                                        phi_1931_ = (1f / _e1282);
                                                    }
                                                    let _e1287 = phi_1931_;
                                                    if (abs(_e1133) < _e1267) {
                                                        phi_1938_ = _e1267;
                                                    } else {
                                                        phi_1938_ = abs(_e1133);
                                                    }
                                                    let _e1292 = phi_1938_;
                                                    if (_e1133 < 0f) {
                                                        phi_1945_ = (-1f / _e1292);
                                                    } else {
                                                        phi_1945_ = (1f / _e1292);
                                                    }
                                                    let _e1297 = phi_1945_;
                                                    let _e1301 = abs((bitcast<f32>(_e1207) - _e1063));
                                                    let _e1302 = abs((bitcast<f32>(_e1211) - _e1076));
                                                    let _e1303 = abs((bitcast<f32>(_e1215) - _e1089));
                                                    let _e1307 = abs(((bitcast<f32>(_e1219) + (bitcast<f32>((((_e1231 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1063));
                                                    let _e1308 = abs(((bitcast<f32>(_e1223) + (bitcast<f32>((((_e1231 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1076));
                                                    let _e1309 = abs(((bitcast<f32>(_e1227) + (bitcast<f32>((((_e1231 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    if (_e1301 > _e1307) {
                                                        phi_1962_ = _e1301;
                                                    } else {
                                                        phi_1962_ = _e1307;
                                                    }
                                                    let _e1312 = phi_1962_;
                                                    if (_e1302 > _e1308) {
                                                        phi_1967_ = _e1302;
                                                    } else {
                                                        phi_1967_ = _e1308;
                                                    }
                                                    let _e1315 = phi_1967_;
                                                    if (_e1303 > _e1309) {
                                                        phi_1972_ = _e1303;
                                                    } else {
                                                        phi_1972_ = _e1309;
                                                    }
                                                    let _e1318 = phi_1972_;
                                                    let _e1319 = core_intrinsics_maximum_number_nsz_f32_(_e1312, _e1315);
                                                    let _e1320 = core_intrinsics_maximum_number_nsz_f32_(_e1319, _e1318);
                                                    let _e1324 = (_e1320 * 0.0000019073486f);
                                                    let _e1325 = (abs(_e1277) * _e1324);
                                                    let _e1326 = (abs(_e1287) * _e1324);
                                                    let _e1327 = (abs(_e1297) * _e1324);
                                                    let _e1331 = (_e1320 * 0.0000009536743f);
                                                    let _e1332 = (abs(_e1277) * _e1331);
                                                    let _e1333 = (abs(_e1287) * _e1331);
                                                    let _e1334 = (abs(_e1297) * _e1331);
                                                    let _e1335 = abs(_e1107);
                                                    let _e1336 = abs(_e1120);
                                                    let _e1337 = abs(_e1133);
                                                    if (_e1335 >= _e1336) {
                                                        if (_e1335 >= _e1337) {
                                                            phi_2000_ = false;
                                                        } else {
                                                            phi_2000_ = true;
                                                        }
                                                        let _e1341 = phi_2000_;
                                                        phi_2001_ = _e1341;
                                                    } else {
                                                        phi_2001_ = true;
                                                    }
                                                    let _e1343 = phi_2001_;
                                                    if _e1343 {
                                                        if (_e1336 >= _e1337) {
                                                            phi_2009_ = 1u;
                                                        } else {
                                                            phi_2009_ = 2u;
                                                        }
                                                        let _e1346 = phi_2009_;
                                                        phi_2010_ = _e1346;
                                                    } else {
                                                        phi_2010_ = 0u;
                                                    }
                                                    let _e1348 = phi_2010_;
                                                    if (_e1348 == 0u) {
                                                        phi_2022_ = vec3<f32>(_e1120, _e1133, _e1107);
                                                    } else {
                                                        if (_e1348 == 1u) {
                                                            phi_2021_ = vec3<f32>(_e1133, _e1107, _e1120);
                                                        } else {
                                                            phi_2021_ = vec3<f32>(_e1107, _e1120, _e1133);
                                                        }
                                                        let _e1354 = phi_2021_;
                                                        phi_2022_ = _e1354;
                                                    }
                                                    let _e1356 = phi_2022_;
                                                    let _e1359 = (_e1356.x / _e1356.z);
                                                    let _e1362 = (_e1356.y / _e1356.z);
                                                    let _e1364 = (1f / _e1356.z);
                                                    if (_e1277 < 0f) {
                                                        phi_2035_ = 0u;
                                                    } else {
                                                        phi_2035_ = 1u;
                                                    }
                                                    let _e1367 = phi_2035_;
                                                    if (_e1287 < 0f) {
                                                        phi_2040_ = 0u;
                                                    } else {
                                                        phi_2040_ = 2u;
                                                    }
                                                    let _e1370 = phi_2040_;
                                                    if (_e1297 < 0f) {
                                                        phi_2045_ = 0u;
                                                    } else {
                                                        phi_2045_ = 4u;
                                                    }
                                                    let _e1373 = phi_2045_;
                                                    let _e1375 = ((_e1367 | _e1370) | _e1373);
                                                    let _e1376 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1137, 2147483648u);
                                                    local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e1376.first[0], _e1376.first[1], _e1376.first[2], _e1376.first[3], _e1376.first[4], _e1376.first[5], _e1376.first[6], _e1376.first[7], _e1376.first[8], _e1376.first[9], _e1376.first[10], _e1376.first[11], _e1376.first[12], _e1376.first[13], _e1376.first[14], _e1376.first[15], _e1376.first[16], _e1376.first[17], _e1376.first[18], _e1376.first[19], _e1376.first[20], _e1376.first[21], _e1376.first[22], _e1376.first[23], _e1376.first[24], _e1376.first[25], _e1376.first[26], _e1376.first[27], _e1376.first[28], _e1376.first[29], _e1376.first[30], _e1376.first[31]), array<u32, 32>(_e1376.mask[0], _e1376.mask[1], _e1376.mask[2], _e1376.mask[3], _e1376.mask[4], _e1376.mask[5], _e1376.mask[6], _e1376.mask[7], _e1376.mask[8], _e1376.mask[9], _e1376.mask[10], _e1376.mask[11], _e1376.mask[12], _e1376.mask[13], _e1376.mask[14], _e1376.mask[15], _e1376.mask[16], _e1376.mask[17], _e1376.mask[18], _e1376.mask[19], _e1376.mask[20], _e1376.mask[21], _e1376.mask[22], _e1376.mask[23], _e1376.mask[24], _e1376.mask[25], _e1376.mask[26], _e1376.mask[27], _e1376.mask[28], _e1376.mask[29], _e1376.mask[30], _e1376.mask[31]), _e1376.len, _e1376.group, _e1376.group_mask);
                                                    let _e1450 = local_3.group_mask;
                                                    if ((_e1450 & 4278190080u) == 0u) {
                                                        let _e1454 = local_3.len;
                                                        if (_e1454 == 0u) {
                                                            phi_2159_ = false;
                                                        } else {
                                                            let _e1458 = local_3.len;
                                                            local_3.len = (_e1458 - 1u);
                                                            let _e1461 = local_3.len;
                                                            if (_e1461 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1466 = local_3.first[(0u + _e1461)];
                                                            local_3.group = _e1466;
                                                            let _e1469 = local_3.len;
                                                            if (_e1469 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1474 = local_3.mask[(0u + _e1469)];
                                                            local_3.group_mask = _e1474;
                                                            phi_2159_ = true;
                                                        }
                                                        let _e1477 = phi_2159_;
                                                        phi_2160_ = _e1477;
                                                    } else {
                                                        phi_2160_ = true;
                                                    }
                                                    let _e1479 = phi_2160_;
                                                    if _e1479 {
                                                        let _e1481 = local_3.group_mask;
                                                        let _e1487 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1481)), 32u, (_e1481 == 0u)));
                                                        let _e1491 = local_3.group_mask;
                                                        let _e1505 = local_3.group_mask;
                                                        local_3.group_mask = (_e1505 & ~((1u << bitcast<u32>((_e1487 & 31u)))));
                                                        let _e1508 = local_3.group;
                                                        phi_2191_ = (_e1508 + countOneBits(((_e1491 & ~((4294967295u << bitcast<u32>((((_e1487 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2191_ = 4294967295u;
                                                    }
                                                    let _e1511 = phi_2191_;
                                                    phi_2193_ = _e971;
                                                    phi_2196_ = _e1511;
                                                    loop {
                                                        let _e1513 = phi_2193_;
                                                        let _e1515 = phi_2196_;
                                                        local_12 = _e1513;
                                                        let _e1516 = (_e1515 != 4294967295u);
                                                        if _e1516 {
                                                            if (_e1515 < _e72) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1523 = nodes.member[(0u + _e1515)].frame[3u];
                                                            let _e1548 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1277);
                                                            let _e1549 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1287);
                                                            let _e1550 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1297);
                                                            let _e1553 = nodes.member[(0u + _e1515)].frame[0u];
                                                            let _e1557 = nodes.member[(0u + _e1515)].frame[1u];
                                                            let _e1561 = nodes.member[(0u + _e1515)].frame[2u];
                                                            let _e1566 = ((bitcast<f32>(_e1553) - _e1063) * _e1277);
                                                            let _e1567 = ((bitcast<f32>(_e1557) - _e1076) * _e1287);
                                                            let _e1568 = ((bitcast<f32>(_e1561) - _e1089) * _e1297);
                                                            let _e1576 = nodes.member[(0u + _e1515)].x;
                                                            if (_e1277 < 0f) {
                                                                let _e1587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1576.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1587.unnamed.root, _e1576.w), _e1587.unnamed_1);
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1593.unnamed, lt_bvh_traverse_Tree(_e1576.x, _e1593.unnamed_1.first_primitive));
                                                                phi_2277_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_bvh_traverse_Tree(_e1599.unnamed_1.root, _e1576.y));
                                                            } else {
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1576.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1615.unnamed.root, _e1576.y), _e1615.unnamed_1);
                                                                let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1621.unnamed, lt_bvh_traverse_Tree(_e1576.z, _e1621.unnamed_1.first_primitive));
                                                                phi_2277_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_bvh_traverse_Tree(_e1627.unnamed_1.root, _e1576.w));
                                                            }
                                                            let _e1635 = phi_2277_;
                                                            let _e1645 = nodes.member[(0u + _e1515)].y;
                                                            if (_e1287 < 0f) {
                                                                let _e1656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1645.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1656.unnamed.root, _e1645.w), _e1656.unnamed_1);
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1662.unnamed, lt_bvh_traverse_Tree(_e1645.x, _e1662.unnamed_1.first_primitive));
                                                                phi_2304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_bvh_traverse_Tree(_e1668.unnamed_1.root, _e1645.y));
                                                            } else {
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1645.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1684.unnamed.root, _e1645.y), _e1684.unnamed_1);
                                                                let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1690.unnamed, lt_bvh_traverse_Tree(_e1645.z, _e1690.unnamed_1.first_primitive));
                                                                phi_2304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_bvh_traverse_Tree(_e1696.unnamed_1.root, _e1645.w));
                                                            }
                                                            let _e1704 = phi_2304_;
                                                            let _e1714 = nodes.member[(0u + _e1515)].z;
                                                            if (_e1297 < 0f) {
                                                                let _e1725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1714.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1725.unnamed.root, _e1714.w), _e1725.unnamed_1);
                                                                let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1731.unnamed, lt_bvh_traverse_Tree(_e1714.x, _e1731.unnamed_1.first_primitive));
                                                                phi_2331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_bvh_traverse_Tree(_e1737.unnamed_1.root, _e1714.y));
                                                            } else {
                                                                let _e1753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1714.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1753.unnamed.root, _e1714.y), _e1753.unnamed_1);
                                                                let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1759.unnamed, lt_bvh_traverse_Tree(_e1714.z, _e1759.unnamed_1.first_primitive));
                                                                phi_2331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_bvh_traverse_Tree(_e1765.unnamed_1.root, _e1714.w));
                                                            }
                                                            let _e1773 = phi_2331_;
                                                            phi_2337_ = 0u;
                                                            phi_2340_ = 0u;
                                                            loop {
                                                                let _e1783 = phi_2337_;
                                                                let _e1785 = phi_2340_;
                                                                local_8 = _e1785;
                                                                local_9 = _e1785;
                                                                local_10 = _e1785;
                                                                let _e1786 = (_e1783 < 8u);
                                                                if _e1786 {
                                                                    let _e1788 = (_e1783 >> bitcast<u32>(2i));
                                                                    let _e1789 = (_e1783 & 3u);
                                                                    if (_e1788 == 0u) {
                                                                        phi_2354_ = _e1635.unnamed.root;
                                                                    } else {
                                                                        phi_2354_ = _e1635.unnamed.first_primitive;
                                                                    }
                                                                    let _e1792 = phi_2354_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2364_ = _e1704.unnamed.root;
                                                                    } else {
                                                                        phi_2364_ = _e1704.unnamed.first_primitive;
                                                                    }
                                                                    let _e1801 = phi_2364_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2374_ = _e1773.unnamed.root;
                                                                    } else {
                                                                        phi_2374_ = _e1773.unnamed.first_primitive;
                                                                    }
                                                                    let _e1810 = phi_2374_;
                                                                    let _e1823 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1792 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 - _e1325)), ((f32(((_e1801 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 - _e1326)));
                                                                    let _e1824 = core_intrinsics_maximum_number_nsz_f32_(_e1823, ((f32(((_e1810 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)));
                                                                    if (_e1788 == 0u) {
                                                                        phi_2392_ = _e1635.unnamed_1.root;
                                                                    } else {
                                                                        phi_2392_ = _e1635.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1827 = phi_2392_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2402_ = _e1704.unnamed_1.root;
                                                                    } else {
                                                                        phi_2402_ = _e1704.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1836 = phi_2402_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2412_ = _e1773.unnamed_1.root;
                                                                    } else {
                                                                        phi_2412_ = _e1773.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1845 = phi_2412_;
                                                                    let _e1858 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1827 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 + _e1325)), ((f32(((_e1836 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 + _e1326)));
                                                                    let _e1859 = core_intrinsics_minimum_number_nsz_f32_(_e1858, ((f32(((_e1845 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)));
                                                                    if (_e1824 <= _e1859) {
                                                                        if (_e1824 <= _e1513.t) {
                                                                            if (_e1859 >= _e153.tmin) {
                                                                                if (_e1788 == 0u) {
                                                                                    let _e1866 = nodes.member[(0u + _e1515)].links[2u];
                                                                                    phi_2448_ = _e1866;
                                                                                } else {
                                                                                    let _e1869 = nodes.member[(0u + _e1515)].links[3u];
                                                                                    phi_2448_ = _e1869;
                                                                                }
                                                                                let _e1871 = phi_2448_;
                                                                                let _e1876 = ((_e1871 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u);
                                                                                let _e1877 = (_e1876 & 31u);
                                                                                if (_e1877 >= 24u) {
                                                                                    phi_2461_ = (24u + ((_e1877 - 24u) ^ _e1375));
                                                                                } else {
                                                                                    phi_2461_ = _e1877;
                                                                                }
                                                                                let _e1883 = phi_2461_;
                                                                                phi_2466_ = (_e1785 | ((_e1876 >> bitcast<u32>(5i)) << bitcast<u32>((_e1883 & 31u))));
                                                                            } else {
                                                                                phi_2466_ = _e1785;
                                                                            }
                                                                            let _e1891 = phi_2466_;
                                                                            phi_2467_ = _e1891;
                                                                        } else {
                                                                            phi_2467_ = _e1785;
                                                                        }
                                                                        let _e1893 = phi_2467_;
                                                                        phi_2468_ = _e1893;
                                                                    } else {
                                                                        phi_2468_ = _e1785;
                                                                    }
                                                                    let _e1895 = phi_2468_;
                                                                    phi_2338_ = (_e1783 + 1u);
                                                                    phi_2341_ = _e1895;
                                                                } else {
                                                                    phi_2338_ = u32();
                                                                    phi_2341_ = u32();
                                                                }
                                                                let _e1898 = phi_2338_;
                                                                let _e1900 = phi_2341_;
                                                                continue;
                                                                continuing {
                                                                    phi_2337_ = _e1898;
                                                                    phi_2340_ = _e1900;
                                                                    break if !(_e1786);
                                                                }
                                                            }
                                                            let _e1904 = nodes.member[(0u + _e1515)].links[0u];
                                                            let _e1908 = nodes.member[(0u + _e1515)].frame[3u];
                                                            let _e1912 = local_8;
                                                            if ((_e1912 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1916 = local_3.group_mask;
                                                                if ((_e1916 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1920 = local_3.len;
                                                                    if (_e1920 < 32u) {
                                                                        let _e1923 = local_3.group;
                                                                        let _e1925 = local_3.len;
                                                                        if (_e1925 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_3.first[(0u + _e1925)] = _e1923;
                                                                        let _e1931 = local_3.group_mask;
                                                                        let _e1933 = local_3.len;
                                                                        if (_e1933 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_3.mask[(0u + _e1933)] = _e1931;
                                                                        let _e1940 = local_3.len;
                                                                        local_3.len = (_e1940 + 1u);
                                                                    }
                                                                }
                                                                local_3.group = (_e1137 + _e1904);
                                                                let _e1944 = local_9;
                                                                local_3.group_mask = ((_e1944 & 4278190080u) | (_e1908 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1949 = local_10;
                                                            phi_2526_ = _e1513;
                                                            phi_2529_ = (_e1949 & 16777215u);
                                                            loop {
                                                                let _e1952 = phi_2526_;
                                                                let _e1954 = phi_2529_;
                                                                local_11 = _e1952;
                                                                if (_e1954 == 0u) {
                                                                    phi_2527_ = lt_bvh_Hit();
                                                                    phi_2530_ = u32();
                                                                    phi_3053_ = false;
                                                                } else {
                                                                    let _e1958 = nodes.member[(0u + _e1515)].links[1u];
                                                                    let _e1963 = ((_e1139 + _e1958) + select(firstTrailingBit(_e1954), 32u, (_e1954 == 0u)));
                                                                    if (_e1963 < _e75) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1970 = triangles.member[(0u + _e1963)].v0_;
                                                                    let _e1972 = (_e1970.x - _e1063);
                                                                    let _e1974 = (_e1970.y - _e1076);
                                                                    let _e1976 = (_e1970.z - _e1089);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2574_ = vec3<f32>(_e1974, _e1976, _e1972);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2573_ = vec3<f32>(_e1976, _e1972, _e1974);
                                                                        } else {
                                                                            phi_2573_ = (_e1970 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e1984 = phi_2573_;
                                                                        phi_2574_ = _e1984;
                                                                    }
                                                                    let _e1986 = phi_2574_;
                                                                    let _e1990 = (_e1986.x - (_e1359 * _e1986.z));
                                                                    let _e1994 = (_e1986.y - (_e1362 * _e1986.z));
                                                                    let _e1998 = triangles.member[(0u + _e1963)].v1_;
                                                                    let _e2000 = (_e1998.x - _e1063);
                                                                    let _e2002 = (_e1998.y - _e1076);
                                                                    let _e2004 = (_e1998.z - _e1089);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2606_ = vec3<f32>(_e2002, _e2004, _e2000);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2605_ = vec3<f32>(_e2004, _e2000, _e2002);
                                                                        } else {
                                                                            phi_2605_ = (_e1998 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e2012 = phi_2605_;
                                                                        phi_2606_ = _e2012;
                                                                    }
                                                                    let _e2014 = phi_2606_;
                                                                    let _e2018 = (_e2014.x - (_e1359 * _e2014.z));
                                                                    let _e2022 = (_e2014.y - (_e1362 * _e2014.z));
                                                                    let _e2026 = triangles.member[(0u + _e1963)].v2_;
                                                                    let _e2028 = (_e2026.x - _e1063);
                                                                    let _e2030 = (_e2026.y - _e1076);
                                                                    let _e2032 = (_e2026.z - _e1089);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2638_ = vec3<f32>(_e2030, _e2032, _e2028);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2637_ = vec3<f32>(_e2032, _e2028, _e2030);
                                                                        } else {
                                                                            phi_2637_ = (_e2026 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e2040 = phi_2637_;
                                                                        phi_2638_ = _e2040;
                                                                    }
                                                                    let _e2042 = phi_2638_;
                                                                    let _e2046 = (_e2042.x - (_e1359 * _e2042.z));
                                                                    let _e2050 = (_e2042.y - (_e1362 * _e2042.z));
                                                                    if (_e2018 < _e2046) {
                                                                        phi_2659_ = true;
                                                                    } else {
                                                                        if (_e2018 == _e2046) {
                                                                            phi_2658_ = (_e2022 < _e2050);
                                                                        } else {
                                                                            phi_2658_ = false;
                                                                        }
                                                                        let _e2057 = phi_2658_;
                                                                        phi_2659_ = _e2057;
                                                                    }
                                                                    let _e2059 = phi_2659_;
                                                                    if _e2059 {
                                                                        phi_2663_ = _e2050;
                                                                        phi_2664_ = _e2046;
                                                                        phi_2665_ = _e2022;
                                                                        phi_2666_ = _e2018;
                                                                    } else {
                                                                        phi_2663_ = _e2022;
                                                                        phi_2664_ = _e2018;
                                                                        phi_2665_ = _e2050;
                                                                        phi_2666_ = _e2046;
                                                                    }
                                                                    let _e2061 = phi_2663_;
                                                                    let _e2063 = phi_2664_;
                                                                    let _e2065 = phi_2665_;
                                                                    let _e2067 = phi_2666_;
                                                                    let _e2070 = ((_e2067 * _e2061) - (_e2065 * _e2063));
                                                                    if _e2059 {
                                                                        phi_2674_ = -(_e2070);
                                                                    } else {
                                                                        phi_2674_ = _e2070;
                                                                    }
                                                                    let _e2073 = phi_2674_;
                                                                    if (_e2046 < _e1990) {
                                                                        phi_2685_ = true;
                                                                    } else {
                                                                        if (_e2046 == _e1990) {
                                                                            phi_2684_ = (_e2050 < _e1994);
                                                                        } else {
                                                                            phi_2684_ = false;
                                                                        }
                                                                        let _e2078 = phi_2684_;
                                                                        phi_2685_ = _e2078;
                                                                    }
                                                                    let _e2080 = phi_2685_;
                                                                    if _e2080 {
                                                                        phi_2689_ = _e1994;
                                                                        phi_2690_ = _e1990;
                                                                        phi_2691_ = _e2050;
                                                                        phi_2692_ = _e2046;
                                                                    } else {
                                                                        phi_2689_ = _e2050;
                                                                        phi_2690_ = _e2046;
                                                                        phi_2691_ = _e1994;
                                                                        phi_2692_ = _e1990;
                                                                    }
                                                                    let _e2082 = phi_2689_;
                                                                    let _e2084 = phi_2690_;
                                                                    let _e2086 = phi_2691_;
                                                                    let _e2088 = phi_2692_;
                                                                    let _e2091 = ((_e2088 * _e2082) - (_e2086 * _e2084));
                                                                    if _e2080 {
                                                                        phi_2700_ = -(_e2091);
                                                                    } else {
                                                                        phi_2700_ = _e2091;
                                                                    }
                                                                    let _e2094 = phi_2700_;
                                                                    if (_e1990 < _e2018) {
                                                                        phi_2711_ = true;
                                                                    } else {
                                                                        if (_e1990 == _e2018) {
                                                                            phi_2710_ = (_e1994 < _e2022);
                                                                        } else {
                                                                            phi_2710_ = false;
                                                                        }
                                                                        let _e2099 = phi_2710_;
                                                                        phi_2711_ = _e2099;
                                                                    }
                                                                    let _e2101 = phi_2711_;
                                                                    if _e2101 {
                                                                        phi_2715_ = _e2022;
                                                                        phi_2716_ = _e2018;
                                                                        phi_2717_ = _e1994;
                                                                        phi_2718_ = _e1990;
                                                                    } else {
                                                                        phi_2715_ = _e1994;
                                                                        phi_2716_ = _e1990;
                                                                        phi_2717_ = _e2022;
                                                                        phi_2718_ = _e2018;
                                                                    }
                                                                    let _e2103 = phi_2715_;
                                                                    let _e2105 = phi_2716_;
                                                                    let _e2107 = phi_2717_;
                                                                    let _e2109 = phi_2718_;
                                                                    let _e2112 = ((_e2109 * _e2103) - (_e2107 * _e2105));
                                                                    if _e2101 {
                                                                        phi_2726_ = -(_e2112);
                                                                    } else {
                                                                        phi_2726_ = _e2112;
                                                                    }
                                                                    let _e2115 = phi_2726_;
                                                                    if (_e2073 >= 0f) {
                                                                        if (_e2094 >= 0f) {
                                                                            if (_e2115 >= 0f) {
                                                                                phi_2741_ = ((_e2073 + _e2094) + _e2115);
                                                                                phi_2742_ = false;
                                                                            } else {
                                                                                phi_2741_ = f32();
                                                                                phi_2742_ = true;
                                                                            }
                                                                            let _e2122 = phi_2741_;
                                                                            let _e2124 = phi_2742_;
                                                                            phi_2743_ = _e2122;
                                                                            phi_2744_ = _e2124;
                                                                        } else {
                                                                            phi_2743_ = f32();
                                                                            phi_2744_ = true;
                                                                        }
                                                                        let _e2126 = phi_2743_;
                                                                        let _e2128 = phi_2744_;
                                                                        phi_2745_ = _e2126;
                                                                        phi_2746_ = _e2128;
                                                                    } else {
                                                                        phi_2745_ = f32();
                                                                        phi_2746_ = true;
                                                                    }
                                                                    let _e2130 = phi_2745_;
                                                                    let _e2132 = phi_2746_;
                                                                    if _e2132 {
                                                                        if (_e2073 <= 0f) {
                                                                            if (_e2094 <= 0f) {
                                                                                let _e2135 = (_e2115 <= 0f);
                                                                                if _e2135 {
                                                                                }
                                                                                phi_2764_ = ((_e2073 + _e2094) + _e2115);
                                                                                phi_2765_ = false;
                                                                                phi_2766_ = _e2135;
                                                                            } else {
                                                                                phi_2764_ = f32();
                                                                                phi_2765_ = true;
                                                                                phi_2766_ = false;
                                                                            }
                                                                            let _e2139 = phi_2764_;
                                                                            let _e2141 = phi_2765_;
                                                                            let _e2143 = phi_2766_;
                                                                            phi_2767_ = _e2139;
                                                                            phi_2768_ = _e2141;
                                                                            phi_2769_ = _e2143;
                                                                        } else {
                                                                            phi_2767_ = f32();
                                                                            phi_2768_ = true;
                                                                            phi_2769_ = false;
                                                                        }
                                                                        let _e2145 = phi_2767_;
                                                                        let _e2147 = phi_2768_;
                                                                        let _e2149 = phi_2769_;
                                                                        if _e2147 {
                                                                            phi_2773_ = false;
                                                                        } else {
                                                                            phi_2773_ = _e2149;
                                                                        }
                                                                        let _e2151 = phi_2773_;
                                                                        phi_2774_ = _e2145;
                                                                        phi_2775_ = _e2151;
                                                                    } else {
                                                                        phi_2774_ = _e2130;
                                                                        phi_2775_ = true;
                                                                    }
                                                                    let _e2153 = phi_2774_;
                                                                    let _e2155 = phi_2775_;
                                                                    if _e2155 {
                                                                        let _e2156 = (_e2153 == 0f);
                                                                        if _e2156 {
                                                                            phi_2973_ = lt_bvh_triangle_Intersection();
                                                                        } else {
                                                                            let _e2162 = ((((_e2073 * (_e1364 * _e1986.z)) + (_e2094 * (_e1364 * _e2014.z))) + (_e2115 * (_e1364 * _e2042.z))) / _e2153);
                                                                            let _e2164 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2166 = triangles.member[(0u + _e1963)].v1_;
                                                                            if (_e2164.x < _e2166.x) {
                                                                                phi_2801_ = _e2164.x;
                                                                            } else {
                                                                                phi_2801_ = _e2166.x;
                                                                            }
                                                                            let _e2173 = phi_2801_;
                                                                            if (_e2164.y < _e2166.y) {
                                                                                phi_2810_ = _e2164.y;
                                                                            } else {
                                                                                phi_2810_ = _e2166.y;
                                                                            }
                                                                            let _e2180 = phi_2810_;
                                                                            if (_e2164.z < _e2166.z) {
                                                                                phi_2819_ = _e2164.z;
                                                                            } else {
                                                                                phi_2819_ = _e2166.z;
                                                                            }
                                                                            let _e2187 = phi_2819_;
                                                                            let _e2189 = triangles.member[(0u + _e1963)].v2_;
                                                                            if (_e2173 < _e2189.x) {
                                                                                phi_2828_ = _e2173;
                                                                            } else {
                                                                                phi_2828_ = _e2189.x;
                                                                            }
                                                                            let _e2194 = phi_2828_;
                                                                            if (_e2180 < _e2189.y) {
                                                                                phi_2835_ = _e2180;
                                                                            } else {
                                                                                phi_2835_ = _e2189.y;
                                                                            }
                                                                            let _e2199 = phi_2835_;
                                                                            if (_e2187 < _e2189.z) {
                                                                                phi_2842_ = _e2187;
                                                                            } else {
                                                                                phi_2842_ = _e2189.z;
                                                                            }
                                                                            let _e2204 = phi_2842_;
                                                                            let _e2206 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2208 = triangles.member[(0u + _e1963)].v1_;
                                                                            if (_e2206.x > _e2208.x) {
                                                                                phi_2855_ = _e2206.x;
                                                                            } else {
                                                                                phi_2855_ = _e2208.x;
                                                                            }
                                                                            let _e2215 = phi_2855_;
                                                                            if (_e2206.y > _e2208.y) {
                                                                                phi_2864_ = _e2206.y;
                                                                            } else {
                                                                                phi_2864_ = _e2208.y;
                                                                            }
                                                                            let _e2222 = phi_2864_;
                                                                            if (_e2206.z > _e2208.z) {
                                                                                phi_2873_ = _e2206.z;
                                                                            } else {
                                                                                phi_2873_ = _e2208.z;
                                                                            }
                                                                            let _e2229 = phi_2873_;
                                                                            let _e2231 = triangles.member[(0u + _e1963)].v2_;
                                                                            if (_e2215 > _e2231.x) {
                                                                                phi_2882_ = _e2215;
                                                                            } else {
                                                                                phi_2882_ = _e2231.x;
                                                                            }
                                                                            let _e2236 = phi_2882_;
                                                                            if (_e2222 > _e2231.y) {
                                                                                phi_2889_ = _e2222;
                                                                            } else {
                                                                                phi_2889_ = _e2231.y;
                                                                            }
                                                                            let _e2241 = phi_2889_;
                                                                            if (_e2229 > _e2231.z) {
                                                                                phi_2896_ = _e2229;
                                                                            } else {
                                                                                phi_2896_ = _e2231.z;
                                                                            }
                                                                            let _e2246 = phi_2896_;
                                                                            let _e2250 = ((_e2194 - _e1063) * _e1277);
                                                                            let _e2251 = ((_e2199 - _e1076) * _e1287);
                                                                            let _e2252 = ((_e2204 - _e1089) * _e1297);
                                                                            let _e2256 = ((_e2236 - _e1063) * _e1277);
                                                                            let _e2257 = ((_e2241 - _e1076) * _e1287);
                                                                            let _e2258 = ((_e2246 - _e1089) * _e1297);
                                                                            if (_e2250 < _e2256) {
                                                                                phi_2913_ = _e2250;
                                                                            } else {
                                                                                phi_2913_ = _e2256;
                                                                            }
                                                                            let _e2261 = phi_2913_;
                                                                            if (_e2251 < _e2257) {
                                                                                phi_2918_ = _e2251;
                                                                            } else {
                                                                                phi_2918_ = _e2257;
                                                                            }
                                                                            let _e2264 = phi_2918_;
                                                                            if (_e2252 < _e2258) {
                                                                                phi_2923_ = _e2252;
                                                                            } else {
                                                                                phi_2923_ = _e2258;
                                                                            }
                                                                            let _e2267 = phi_2923_;
                                                                            if (_e2250 > _e2256) {
                                                                                phi_2931_ = _e2250;
                                                                            } else {
                                                                                phi_2931_ = _e2256;
                                                                            }
                                                                            let _e2273 = phi_2931_;
                                                                            if (_e2251 > _e2257) {
                                                                                phi_2936_ = _e2251;
                                                                            } else {
                                                                                phi_2936_ = _e2257;
                                                                            }
                                                                            let _e2276 = phi_2936_;
                                                                            if (_e2252 > _e2258) {
                                                                                phi_2941_ = _e2252;
                                                                            } else {
                                                                                phi_2941_ = _e2258;
                                                                            }
                                                                            let _e2279 = phi_2941_;
                                                                            let _e2283 = core_intrinsics_maximum_number_nsz_f32_((_e2261 - _e1332), (_e2264 - _e1333));
                                                                            let _e2284 = core_intrinsics_maximum_number_nsz_f32_(_e2283, (_e2267 - _e1334));
                                                                            let _e2285 = core_intrinsics_minimum_number_nsz_f32_((_e2273 + _e1332), (_e2276 + _e1333));
                                                                            let _e2286 = core_intrinsics_minimum_number_nsz_f32_(_e2285, (_e2279 + _e1334));
                                                                            if (_e2284 > _e1038) {
                                                                                phi_2953_ = _e2284;
                                                                            } else {
                                                                                phi_2953_ = _e1038;
                                                                            }
                                                                            let _e2289 = phi_2953_;
                                                                            if (_e2286 < _e1040) {
                                                                                phi_2958_ = _e2286;
                                                                            } else {
                                                                                phi_2958_ = _e1040;
                                                                            }
                                                                            let _e2292 = phi_2958_;
                                                                            if (_e2162 < _e2289) {
                                                                                phi_2963_ = _e2289;
                                                                            } else {
                                                                                phi_2963_ = _e2162;
                                                                            }
                                                                            let _e2295 = phi_2963_;
                                                                            if (_e2295 > _e2292) {
                                                                                phi_2968_ = _e2292;
                                                                            } else {
                                                                                phi_2968_ = _e2295;
                                                                            }
                                                                            let _e2298 = phi_2968_;
                                                                            phi_2973_ = lt_bvh_triangle_Intersection(_e2298, (_e2094 / _e2153), (_e2115 / _e2153), (_e2289 <= _e2292));
                                                                        }
                                                                        let _e2304 = phi_2973_;
                                                                        phi_2974_ = _e2304;
                                                                        phi_2975_ = _e2156;
                                                                    } else {
                                                                        phi_2974_ = lt_bvh_triangle_Intersection();
                                                                        phi_2975_ = true;
                                                                    }
                                                                    let _e2306 = phi_2974_;
                                                                    let _e2308 = phi_2975_;
                                                                    if _e2308 {
                                                                        phi_2979_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2979_ = _e2306;
                                                                    }
                                                                    let _e2310 = phi_2979_;
                                                                    if _e2310.is_hit {
                                                                        if (_e2310.t > _e153.tmin) {
                                                                            if (_e2310.t < _e1952.t) {
                                                                                phi_3027_ = true;
                                                                            } else {
                                                                                if (_e2310.t == _e1952.t) {
                                                                                    if (_e1952.triangle != 4294967295u) {
                                                                                        if (_e1963 < _e1952.triangle) {
                                                                                            phi_3018_ = true;
                                                                                        } else {
                                                                                            if (_e1963 == _e1952.triangle) {
                                                                                                phi_3017_ = (_e979 < _e1952.instance);
                                                                                            } else {
                                                                                                phi_3017_ = false;
                                                                                            }
                                                                                            let _e2328 = phi_3017_;
                                                                                            phi_3018_ = _e2328;
                                                                                        }
                                                                                        let _e2330 = phi_3018_;
                                                                                        phi_3019_ = _e2330;
                                                                                        phi_3020_ = false;
                                                                                    } else {
                                                                                        phi_3019_ = bool();
                                                                                        phi_3020_ = true;
                                                                                    }
                                                                                    let _e2332 = phi_3019_;
                                                                                    let _e2334 = phi_3020_;
                                                                                    phi_3021_ = _e2332;
                                                                                    phi_3022_ = _e2334;
                                                                                } else {
                                                                                    phi_3021_ = bool();
                                                                                    phi_3022_ = true;
                                                                                }
                                                                                let _e2336 = phi_3021_;
                                                                                let _e2338 = phi_3022_;
                                                                                if _e2338 {
                                                                                    phi_3026_ = false;
                                                                                } else {
                                                                                    phi_3026_ = _e2336;
                                                                                }
                                                                                let _e2340 = phi_3026_;
                                                                                phi_3027_ = _e2340;
                                                                            }
                                                                            let _e2342 = phi_3027_;
                                                                            if _e2342 {
                                                                                let _e2344 = triangles.member[(0u + _e1963)].i0_;
                                                                                if ((_e2344 & 2147483648u) == 0u) {
                                                                                    phi_3041_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3041_ = true;
                                                                                }
                                                                                let _e2348 = phi_3041_;
                                                                                if _e2348 {
                                                                                    phi_3049_ = lt_bvh_Hit(_e2310.t, _e2310.u, _e2310.v, _e1963, _e979);
                                                                                } else {
                                                                                    phi_3049_ = _e1952;
                                                                                }
                                                                                let _e2354 = phi_3049_;
                                                                                phi_3050_ = _e2354;
                                                                            } else {
                                                                                phi_3050_ = _e1952;
                                                                            }
                                                                            let _e2356 = phi_3050_;
                                                                            phi_3051_ = _e2356;
                                                                        } else {
                                                                            phi_3051_ = _e1952;
                                                                        }
                                                                        let _e2358 = phi_3051_;
                                                                        phi_3052_ = _e2358;
                                                                    } else {
                                                                        phi_3052_ = _e1952;
                                                                    }
                                                                    let _e2360 = phi_3052_;
                                                                    phi_2527_ = _e2360;
                                                                    phi_2530_ = (_e1954 & (_e1954 - 1u));
                                                                    phi_3053_ = true;
                                                                }
                                                                let _e2362 = phi_2527_;
                                                                let _e2364 = phi_2530_;
                                                                let _e2366 = phi_3053_;
                                                                continue;
                                                                continuing {
                                                                    phi_2526_ = _e2362;
                                                                    phi_2529_ = _e2364;
                                                                    break if !(_e2366);
                                                                }
                                                            }
                                                            let _e2369 = local_3.group_mask;
                                                            if ((_e2369 & 4278190080u) == 0u) {
                                                                let _e2373 = local_3.len;
                                                                if (_e2373 == 0u) {
                                                                    phi_3092_ = false;
                                                                } else {
                                                                    let _e2377 = local_3.len;
                                                                    local_3.len = (_e2377 - 1u);
                                                                    let _e2380 = local_3.len;
                                                                    if (_e2380 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2385 = local_3.first[(0u + _e2380)];
                                                                    local_3.group = _e2385;
                                                                    let _e2388 = local_3.len;
                                                                    if (_e2388 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2393 = local_3.mask[(0u + _e2388)];
                                                                    local_3.group_mask = _e2393;
                                                                    phi_3092_ = true;
                                                                }
                                                                let _e2396 = phi_3092_;
                                                                phi_3093_ = _e2396;
                                                            } else {
                                                                phi_3093_ = true;
                                                            }
                                                            let _e2398 = phi_3093_;
                                                            if _e2398 {
                                                                let _e2400 = local_3.group_mask;
                                                                let _e2406 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2400)), 32u, (_e2400 == 0u)));
                                                                let _e2410 = local_3.group_mask;
                                                                let _e2424 = local_3.group_mask;
                                                                local_3.group_mask = (_e2424 & ~((1u << bitcast<u32>((_e2406 & 31u)))));
                                                                let _e2427 = local_3.group;
                                                                phi_3124_ = (_e2427 + countOneBits(((_e2410 & ~((4294967295u << bitcast<u32>((((_e2406 - 24u) ^ _e1375) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3124_ = 4294967295u;
                                                            }
                                                            let _e2430 = phi_3124_;
                                                            let _e3264 = local_11;
                                                            phi_2194_ = _e3264;
                                                            phi_2197_ = _e2430;
                                                        } else {
                                                            phi_2194_ = lt_bvh_Hit();
                                                            phi_2197_ = u32();
                                                        }
                                                        let _e2432 = phi_2194_;
                                                        let _e2434 = phi_2197_;
                                                        continue;
                                                        continuing {
                                                            phi_2193_ = _e2432;
                                                            phi_2196_ = _e2434;
                                                            break if !(_e1516);
                                                        }
                                                    }
                                                    let _e3268 = local_12;
                                                    phi_3125_ = _e3268;
                                                }
                                                let _e2437 = phi_3125_;
                                                phi_3126_ = _e2437;
                                                phi_3127_ = _e1201;
                                            } else {
                                                phi_3126_ = lt_bvh_Hit();
                                                phi_3127_ = true;
                                            }
                                            let _e2439 = phi_3126_;
                                            let _e2441 = phi_3127_;
                                            if _e2441 {
                                                phi_3131_ = _e971;
                                            } else {
                                                phi_3131_ = _e2439;
                                            }
                                            let _e2443 = phi_3131_;
                                            phi_3132_ = _e2443;
                                        } else {
                                            phi_3132_ = _e971;
                                        }
                                        let _e2445 = phi_3132_;
                                        phi_3133_ = _e2445;
                                    } else {
                                        phi_3133_ = _e971;
                                    }
                                    let _e2447 = phi_3133_;
                                    phi_3134_ = _e2447;
                                } else {
                                    phi_3134_ = _e971;
                                }
                                let _e2449 = phi_3134_;
                                phi_1569_ = (_e969 & (_e969 - 1u));
                                phi_1572_ = _e2449;
                                phi_3135_ = true;
                            }
                            let _e2451 = phi_1569_;
                            let _e2453 = phi_1572_;
                            let _e2455 = phi_3135_;
                            continue;
                            continuing {
                                phi_1568_ = _e2451;
                                phi_1571_ = _e2453;
                                break if !(_e2455);
                            }
                        }
                        let _e2458 = local_4.group_mask;
                        if ((_e2458 & 4278190080u) == 0u) {
                            let _e2462 = local_4.len;
                            if (_e2462 == 0u) {
                                phi_3174_ = false;
                            } else {
                                let _e2466 = local_4.len;
                                local_4.len = (_e2466 - 1u);
                                let _e2469 = local_4.len;
                                if (_e2469 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2474 = local_4.first[(0u + _e2469)];
                                local_4.group = _e2474;
                                let _e2477 = local_4.len;
                                if (_e2477 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2482 = local_4.mask[(0u + _e2477)];
                                local_4.group_mask = _e2482;
                                phi_3174_ = true;
                            }
                            let _e2485 = phi_3174_;
                            phi_3175_ = _e2485;
                        } else {
                            phi_3175_ = true;
                        }
                        let _e2487 = phi_3175_;
                        if _e2487 {
                            let _e2489 = local_4.group_mask;
                            let _e2495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2489)), 32u, (_e2489 == 0u)));
                            let _e2499 = local_4.group_mask;
                            let _e2513 = local_4.group_mask;
                            local_4.group_mask = (_e2513 & ~((1u << bitcast<u32>((_e2495 & 31u)))));
                            let _e2516 = local_4.group;
                            phi_3206_ = (_e2516 + countOneBits(((_e2499 & ~((4294967295u << bitcast<u32>((((_e2495 - 24u) ^ _e388) & 31u))))) & 255u)));
                        } else {
                            phi_3206_ = 4294967295u;
                        }
                        let _e2519 = phi_3206_;
                        phi_1232_ = _e2519;
                        let _e3284 = local_13;
                        phi_1235_ = _e3284;
                    } else {
                        phi_1232_ = u32();
                        phi_1235_ = lt_bvh_Hit();
                    }
                    let _e2521 = phi_1232_;
                    let _e2523 = phi_1235_;
                    continue;
                    continuing {
                        phi_1231_ = _e2521;
                        phi_1234_ = _e2523;
                        break if !(_e529);
                    }
                }
                let _e3287 = local_14;
                phi_3207_ = _e3287;
            }
            let _e2526 = phi_3207_;
            phi_3208_ = _e2526;
            phi_3209_ = _e225;
        } else {
            phi_3208_ = lt_bvh_Hit();
            phi_3209_ = true;
        }
        let _e2528 = phi_3208_;
        let _e2530 = phi_3209_;
        if _e2530 {
            phi_3213_ = _e155;
        } else {
            phi_3213_ = _e2528;
        }
        let _e2532 = phi_3213_;
        if (_e2532.triangle != 4294967295u) {
            let _e2537 = lt_shaders_surface_barycentric_weights(_e2532.u, _e2532.v);
            if (_e2532.triangle < _e75) {
            } else {
                return;
            }
            let _e2542 = triangles.member[(0u + _e2532.triangle)];
            if (_e2532.instance < _e87) {
            } else {
                return;
            }
            let _e2553 = instances.member[(0u + _e2532.instance)].object_to_world[0u];
            let _e2564 = ((((_e2553.x * _e2542.v0_.x) + (_e2553.y * _e2542.v0_.y)) + (_e2553.z * _e2542.v0_.z)) + (_e2553.w * 1f));
            let _e2566 = instances.member[(0u + _e2532.instance)].object_to_world[1u];
            let _e2577 = ((((_e2566.x * _e2542.v0_.x) + (_e2566.y * _e2542.v0_.y)) + (_e2566.z * _e2542.v0_.z)) + (_e2566.w * 1f));
            let _e2579 = instances.member[(0u + _e2532.instance)].object_to_world[2u];
            let _e2590 = ((((_e2579.x * _e2542.v0_.x) + (_e2579.y * _e2542.v0_.y)) + (_e2579.z * _e2542.v0_.z)) + (_e2579.w * 1f));
            let _e2597 = instances.member[(0u + _e2532.instance)].object_to_world[0u];
            let _e2608 = ((((_e2597.x * _e2542.v1_.x) + (_e2597.y * _e2542.v1_.y)) + (_e2597.z * _e2542.v1_.z)) + (_e2597.w * 1f));
            let _e2610 = instances.member[(0u + _e2532.instance)].object_to_world[1u];
            let _e2621 = ((((_e2610.x * _e2542.v1_.x) + (_e2610.y * _e2542.v1_.y)) + (_e2610.z * _e2542.v1_.z)) + (_e2610.w * 1f));
            let _e2623 = instances.member[(0u + _e2532.instance)].object_to_world[2u];
            let _e2634 = ((((_e2623.x * _e2542.v1_.x) + (_e2623.y * _e2542.v1_.y)) + (_e2623.z * _e2542.v1_.z)) + (_e2623.w * 1f));
            let _e2641 = instances.member[(0u + _e2532.instance)].object_to_world[0u];
            let _e2652 = ((((_e2641.x * _e2542.v2_.x) + (_e2641.y * _e2542.v2_.y)) + (_e2641.z * _e2542.v2_.z)) + (_e2641.w * 1f));
            let _e2654 = instances.member[(0u + _e2532.instance)].object_to_world[1u];
            let _e2665 = ((((_e2654.x * _e2542.v2_.x) + (_e2654.y * _e2542.v2_.y)) + (_e2654.z * _e2542.v2_.z)) + (_e2654.w * 1f));
            let _e2667 = instances.member[(0u + _e2532.instance)].object_to_world[2u];
            let _e2678 = ((((_e2667.x * _e2542.v2_.x) + (_e2667.y * _e2542.v2_.y)) + (_e2667.z * _e2542.v2_.z)) + (_e2667.w * 1f));
            let _e2694 = (((_e2564 * _e2537.x) + (_e2608 * _e2537.y)) + (_e2652 * _e2537.z));
            let _e2695 = (((_e2577 * _e2537.x) + (_e2621 * _e2537.y)) + (_e2665 * _e2537.z));
            let _e2696 = (((_e2590 * _e2537.x) + (_e2634 * _e2537.y)) + (_e2678 * _e2537.z));
            let _e2698 = abs(_e2564);
            let _e2699 = abs(_e2577);
            let _e2700 = abs(_e2590);
            let _e2701 = abs(_e2608);
            let _e2702 = abs(_e2621);
            let _e2703 = abs(_e2634);
            if (_e2698 > _e2701) {
                phi_3402_ = _e2698;
            } else {
                phi_3402_ = _e2701;
            }
            let _e2706 = phi_3402_;
            if (_e2699 > _e2702) {
                phi_3407_ = _e2699;
            } else {
                phi_3407_ = _e2702;
            }
            let _e2709 = phi_3407_;
            if (_e2700 > _e2703) {
                phi_3412_ = _e2700;
            } else {
                phi_3412_ = _e2703;
            }
            let _e2712 = phi_3412_;
            let _e2713 = abs(_e2652);
            let _e2714 = abs(_e2665);
            let _e2715 = abs(_e2678);
            if (_e2706 > _e2713) {
                phi_3420_ = _e2706;
            } else {
                phi_3420_ = _e2713;
            }
            let _e2718 = phi_3420_;
            if (_e2709 > _e2714) {
                phi_3425_ = _e2709;
            } else {
                phi_3425_ = _e2714;
            }
            let _e2721 = phi_3425_;
            if (_e2712 > _e2715) {
                phi_3430_ = _e2712;
            } else {
                phi_3430_ = _e2715;
            }
            let _e2724 = phi_3430_;
            let _e2725 = (_e2608 - _e2564);
            let _e2726 = (_e2621 - _e2577);
            let _e2727 = (_e2634 - _e2590);
            let _e2728 = (_e2652 - _e2564);
            let _e2729 = (_e2665 - _e2577);
            let _e2730 = (_e2678 - _e2590);
            let _e2734 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2726), abs(_e2727));
            let _e2735 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2725), _e2734);
            let _e2736 = (_e2725 / _e2735);
            let _e2737 = (_e2726 / _e2735);
            let _e2738 = (_e2727 / _e2735);
            let _e2742 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2729), abs(_e2730));
            let _e2743 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2728), _e2742);
            let _e2744 = (_e2728 / _e2743);
            let _e2745 = (_e2729 / _e2743);
            let _e2746 = (_e2730 / _e2743);
            let _e2749 = ((_e2737 * _e2746) - (_e2745 * _e2738));
            let _e2752 = ((_e2738 * _e2744) - (_e2746 * _e2736));
            let _e2755 = ((_e2736 * _e2745) - (_e2744 * _e2737));
            let _e2757 = p.member.eye;
            let _e2766 = (1f / sqrt((((_e2749 * _e2749) + (_e2752 * _e2752)) + (_e2755 * _e2755))));
            let _e2771 = lt_shaders_camera_facing(vec3<f32>((_e2749 * _e2766), (_e2752 * _e2766), (_e2755 * _e2766)), (_e2757 - vec3<f32>(_e2694, _e2695, _e2696)));
            if (_e2532.triangle < _e75) {
            } else {
                return;
            }
            let _e2776 = triangles.member[(0u + _e2532.triangle)];
            let _e2778 = (_e2776.i0_ & 2147483647u);
            if (_e2778 < _e78) {
            } else {
                return;
            }
            let _e2784 = vertices.member[(0u + _e2778)];
            if (_e2776.i1_ < _e78) {
            } else {
                return;
            }
            let _e2788 = vertices.member[(0u + _e2776.i1_)];
            if (_e2776.i2_ < _e78) {
            } else {
                return;
            }
            let _e2792 = vertices.member[(0u + _e2776.i2_)];
            let _e2793 = array<abi_Vertex, 3>(_e2784, _e2788, _e2792);
            local_1 = array<abi_Vertex, 3>(abi_Vertex(_e2793[0].u, _e2793[0].v, _e2793[0].normal, _e2793[0].color, _e2793[0].material), abi_Vertex(_e2793[1].u, _e2793[1].v, _e2793[1].normal, _e2793[1].color, _e2793[1].material), abi_Vertex(_e2793[2].u, _e2793[2].v, _e2793[2].normal, _e2793[2].color, _e2793[2].material));
            let _e2818 = local_1[0u].material;
            if (_e2818 < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2822 = materials.member[(0u + _e2818)];
            local_2 = abi_Material(_e2822.base_color, _e2822.cutoff, _e2822.flags, _e2822.alpha_offset, _e2822.alpha_size, _e2822.color_offset, _e2822.color_size, _e2822.pad);
            let _e2832 = lt_shaders_surface_plain_color((&local_2), (&local_1), _e2537);
            let _e2834 = local_2.color_size;
            if (_e2834 == 0u) {
                phi_3651_ = vec3<f32>(1f, 1f, 1f);
            } else {
                let _e2837 = local_2.color_offset;
                let _e2839 = local_2.color_size;
                let _e2841 = local_2.flags;
                local.offset = _e2837;
                local.size = _e2839;
                local.flags = _e2841;
                let _e2845 = lt_shaders_surface_texture_coordinate((&local_1), _e2537);
                let _e2848 = _lt_shaders_texture_TextureView_quad((&local), _e2845.x, _e2845.y);
                if (_e2848.indices[0] < _e90) {
                } else {
                    return;
                }
                let _e2854 = color_texels.member[(0u + _e2848.indices[0])];
                let _e2855 = lt_shaders_texture_unorm_bytes(_e2854);
                if (_e2848.indices[1] < _e90) {
                } else {
                    return;
                }
                let _e2869 = color_texels.member[(0u + _e2848.indices[1])];
                let _e2870 = lt_shaders_texture_unorm_bytes(_e2869);
                if (_e2848.indices[2] < _e90) {
                } else {
                    return;
                }
                let _e2887 = color_texels.member[(0u + _e2848.indices[2])];
                let _e2888 = lt_shaders_texture_unorm_bytes(_e2887);
                if (_e2848.indices[3] < _e90) {
                } else {
                    return;
                }
                let _e2905 = color_texels.member[(0u + _e2848.indices[3])];
                let _e2906 = lt_shaders_texture_unorm_bytes(_e2905);
                let _e2915 = ((((_e2855.x * _e2848.weights.x) + (_e2870.x * _e2848.weights.y)) + (_e2888.x * _e2848.weights.z)) + (_e2906.x * _e2848.weights.w));
                let _e2916 = ((((_e2855.y * _e2848.weights.x) + (_e2870.y * _e2848.weights.y)) + (_e2888.y * _e2848.weights.z)) + (_e2906.y * _e2848.weights.w));
                let _e2917 = ((((_e2855.z * _e2848.weights.x) + (_e2870.z * _e2848.weights.y)) + (_e2888.z * _e2848.weights.z)) + (_e2906.z * _e2848.weights.w));
                phi_3651_ = vec3<f32>((_e2915 * _e2915), (_e2916 * _e2916), (_e2917 * _e2917));
            }
            let _e2923 = phi_3651_;
            let _e2925 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2721, _e2724);
            let _e2926 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2718, _e2925);
            let _e2928 = local_2.flags;
            if ((_e2928 & 2u) == 0u) {
                phi_3662_ = 0u;
            } else {
                phi_3662_ = 1u;
            }
            let _e2932 = phi_3662_;
            let _e2935 = local_1[0u].normal;
            if (_e2935 == 2147516416u) {
                phi_3762_ = _e2771;
            } else {
                let _e2939 = local_1[0u].normal;
                let _e2940 = lt_shaders_surface_octahedral_decode(_e2939);
                let _e2950 = local_1[1u].normal;
                let _e2951 = lt_shaders_surface_octahedral_decode(_e2950);
                let _e2964 = local_1[2u].normal;
                let _e2965 = lt_shaders_surface_octahedral_decode(_e2964);
                let _e2973 = (((_e2940.x * _e2537.x) + (_e2951.x * _e2537.y)) + (_e2965.x * _e2537.z));
                let _e2974 = (((_e2940.y * _e2537.x) + (_e2951.y * _e2537.y)) + (_e2965.y * _e2537.z));
                let _e2975 = (((_e2940.z * _e2537.x) + (_e2951.z * _e2537.y)) + (_e2965.z * _e2537.z));
                if (_e2532.instance < _e87) {
                } else {
                    return;
                }
                let _e2982 = instances.member[(0u + _e2532.instance)].world_to_object[0u];
                let _e2991 = instances.member[(0u + _e2532.instance)].world_to_object[1u];
                let _e3003 = instances.member[(0u + _e2532.instance)].world_to_object[2u];
                let _e3010 = (((_e2982.x * _e2973) + (_e2991.x * _e2974)) + (_e3003.x * _e2975));
                let _e3011 = (((_e2982.y * _e2973) + (_e2991.y * _e2974)) + (_e3003.y * _e2975));
                let _e3012 = (((_e2982.z * _e2973) + (_e2991.z * _e2974)) + (_e3003.z * _e2975));
                let _e3018 = sqrt((((_e3010 * _e3010) + (_e3011 * _e3011)) + (_e3012 * _e3012)));
                if (_e3018 > 0f) {
                    let _e3024 = lt_shaders_camera_facing(vec3<f32>((_e3010 / _e3018), (_e3011 / _e3018), (_e3012 / _e3018)), _e2771);
                    phi_3761_ = _e3024;
                } else {
                    phi_3761_ = _e2771;
                }
                let _e3026 = phi_3761_;
                phi_3762_ = _e3026;
            }
            let _e3028 = phi_3762_;
            let _e3029 = lt_shaders_shade_pack_albedo((_e2832 * _e2923));
            phi_3766_ = abi_Sample(vec3<f32>(_e2694, _e2695, _e2696), _e2926, _e2771, _e2932, _e3028, _e3029);
        } else {
            phi_3766_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3033 = phi_3766_;
        if (_e96.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.first_primitive)] = _e3033;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
