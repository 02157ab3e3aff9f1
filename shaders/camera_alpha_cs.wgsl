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
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_478_: f32;
    var phi_487_: f32;
    var phi_488_: f32;

    if (param_6 == 0u) {
        phi_478_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e72 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e72 > 1f) {
                phi_476_ = (2f - _e72);
            } else {
                phi_476_ = _e72;
            }
            let _e76 = phi_476_;
            phi_477_ = _e76;
        } else {
            phi_477_ = param_5;
        }
        let _e78 = phi_477_;
        phi_478_ = _e78;
    }
    let _e80 = phi_478_;
    if (_e80 > 0f) {
        if (_e80 < 1f) {
            phi_487_ = _e80;
        } else {
            phi_487_ = 1f;
        }
        let _e84 = phi_487_;
        phi_488_ = _e84;
    } else {
        phi_488_ = 0f;
    }
    let _e86 = phi_488_;
    return _e86;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_414_: u32;
    var phi_428_: u32;
    var phi_435_: u32;
    var phi_440_: u32;
    var phi_446_: u32;
    var phi_451_: u32;
    var phi_453_: texture_Axis;

    let _e67 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e68 = (param_8 - 1u);
    let _e70 = (_e67 * f32(param_8));
    if param_10 {
        let _e77 = select(select(u32(_e70), 0u, (_e70 < bitcast<f32>(0u))), 4294967295u, (_e70 > bitcast<f32>(1333788671u)));
        if (_e68 < _e77) {
            phi_414_ = _e68;
        } else {
            phi_414_ = _e77;
        }
        let _e80 = phi_414_;
        phi_453_ = texture_Axis(_e80, _e80, 0f);
    } else {
        let _e82 = (_e70 + 0.5f);
        let _e89 = select(select(u32(_e82), 0u, (_e82 < bitcast<f32>(0u))), 4294967295u, (_e82 > bitcast<f32>(1333788671u)));
        if (param_8 < _e89) {
            phi_428_ = param_8;
        } else {
            phi_428_ = _e89;
        }
        let _e92 = phi_428_;
        if (param_9 == 0u) {
            phi_435_ = _e68;
        } else {
            phi_435_ = 0u;
        }
        let _e97 = phi_435_;
        if (param_9 == 0u) {
            phi_440_ = 0u;
        } else {
            phi_440_ = _e68;
        }
        let _e100 = phi_440_;
        if (_e92 == 0u) {
            phi_446_ = _e97;
        } else {
            phi_446_ = (_e92 - 1u);
        }
        let _e104 = phi_446_;
        if (_e92 > _e68) {
            phi_451_ = _e100;
        } else {
            phi_451_ = _e92;
        }
        let _e107 = phi_451_;
        phi_453_ = texture_Axis(_e104, _e107, (_e82 - f32(_e92)));
    }
    let _e110 = phi_453_;
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
        let _e76 = phi_508_;
        let _e78 = phi_509_;
        phi_510_ = _e76;
        phi_511_ = _e78;
    } else {
        phi_510_ = lt_bvh_traverse_Tree();
        phi_511_ = true;
    }
    let _e80 = phi_510_;
    let _e82 = phi_511_;
    if _e82 {
        phi_516_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_516_ = _e80;
    }
    let _e87 = phi_516_;
    return lt_bvh_traverse_Tree(_e87.root, _e87.first_primitive);
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
        let _e67 = phi_530_;
        phi_531_ = _e67;
    } else {
        phi_531_ = 0f;
    }
    let _e69 = phi_531_;
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

fn lt_shaders_shade_pack_albedo(param_20: vec3<f32>) -> u32 {
    let _e65 = lt_shaders_shade_unit(param_20.x);
    let _e66 = lt_shaders_shade_sqrt(_e65);
    let _e68 = lt_shaders_shade_unit(param_20.y);
    let _e69 = lt_shaders_shade_sqrt(_e68);
    let _e71 = lt_shaders_shade_unit(param_20.z);
    let _e72 = lt_shaders_shade_sqrt(_e71);
    let _e74 = lt_shaders_shade_pack_bytes(vec3<f32>(_e66, _e69, _e72));
    return _e74;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_21: vec3<f32>) -> vec3<f32> {
    return param_21;
}

fn lt_shaders_surface_octahedral_decode(param_22: u32) -> vec3<f32> {
    var phi_2714_: f32;
    var phi_2721_: f32;
    var phi_2728_: f32;

    let _e71 = (f32((bitcast<i32>((param_22 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e77 = (f32((bitcast<i32>(param_22) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e81 = ((1f - abs(_e71)) - abs(_e77));
    if (_e81 < 0f) {
        phi_2714_ = -(_e81);
    } else {
        phi_2714_ = 0f;
    }
    let _e85 = phi_2714_;
    if (_e71 < 0f) {
        phi_2721_ = (_e71 + _e85);
    } else {
        phi_2721_ = (_e71 - _e85);
    }
    let _e90 = phi_2721_;
    if (_e77 < 0f) {
        phi_2728_ = (_e77 + _e85);
    } else {
        phi_2728_ = (_e77 - _e85);
    }
    let _e95 = phi_2728_;
    let _e102 = (1f / sqrt((((_e90 * _e90) + (_e95 * _e95)) + (_e81 * _e81))));
    return vec3<f32>((_e90 * _e102), (_e95 * _e102), (_e81 * _e102));
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_23: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn lt_shaders_surface_plain_color(param_24: ptr<function, abi_Material>, param_25: ptr<function, array<abi_Vertex, 3>>, param_26: vec3<f32>) -> vec3<f32> {
    let _e67 = (*param_24).base_color;
    let _e71 = lt_shaders_surface_vertex_color(param_25, param_26);
    return vec3<f32>((_e67.x * _e71.x), (_e67.y * _e71.y), (_e67.z * _e71.z));
}

fn lt_shaders_camera_facing(param_27: vec3<f32>, param_28: vec3<f32>) -> vec3<f32> {
    var phi_2672_: vec3<f32>;

    if ((((param_27.x * param_28.x) + (param_27.y * param_28.y)) + (param_27.z * param_28.z)) < 0f) {
        phi_2672_ = -(param_27);
    } else {
        phi_2672_ = param_27;
    }
    let _e79 = phi_2672_;
    return _e79;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_29: f32, param_30: f32) -> f32 {
    var phi_2652_: f32;

    if (param_29 > param_30) {
        phi_2652_ = param_29;
    } else {
        phi_2652_ = param_30;
    }
    let _e67 = phi_2652_;
    return _e67;
}

fn lt_shaders_surface_barycentric_weights(param_31: f32, param_32: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_31) - param_32), param_31, param_32);
}

fn core_intrinsics_minimum_number_nsz_f32_(param_33: f32, param_34: f32) -> f32 {
    var phi_2634_: bool;
    var phi_2638_: f32;

    if (param_33 != param_33) {
        phi_2634_ = true;
    } else {
        let _e66 = (param_34 <= param_33);
        if _e66 {
        }
        phi_2634_ = _e66;
    }
    let _e68 = phi_2634_;
    if _e68 {
        phi_2638_ = param_34;
    } else {
        phi_2638_ = param_33;
    }
    let _e70 = phi_2638_;
    return _e70;
}

fn core_intrinsics_maximum_number_nsz_f32_(param_35: f32, param_36: f32) -> f32 {
    var phi_2618_: bool;
    var phi_2622_: f32;

    if (param_35 != param_35) {
        phi_2618_ = true;
    } else {
        let _e66 = (param_36 >= param_35);
        if _e66 {
        }
        phi_2618_ = _e66;
    }
    let _e68 = phi_2618_;
    if _e68 {
        phi_2622_ = param_36;
    } else {
        phi_2622_ = param_35;
    }
    let _e70 = phi_2622_;
    return _e70;
}

fn _lt_bvh_ray_Ray_new(param_37: vec3<f32>, param_38: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_37, 0f, param_38, 300000000000000000000000000000000000000f);
}

fn function_() {
    var local: array<abi_Vertex, 3>;
    var local_1: abi_Material;
    var local_2: texture_TextureView;
    var local_3: array<abi_Vertex, 3>;
    var local_4: lt_bvh_traverse_Stack;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_748_: bool;
    var phi_752_: bool;
    var phi_827_: f32;
    var phi_834_: f32;
    var phi_842_: f32;
    var phi_849_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_889_: f32;
    var phi_894_: f32;
    var phi_899_: f32;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_941_: u32;
    var phi_942_: u32;
    var phi_960_: vec3<f32>;
    var phi_961_: vec3<f32>;
    var phi_975_: u32;
    var phi_980_: u32;
    var phi_985_: u32;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1131_: u32;
    var phi_1133_: lt_bvh_Hit;
    var phi_1136_: u32;
    var phi_1221_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1248_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1275_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1281_: u32;
    var phi_1284_: u32;
    var phi_1298_: u32;
    var phi_1308_: u32;
    var phi_1318_: u32;
    var phi_1336_: u32;
    var phi_1346_: u32;
    var phi_1356_: u32;
    var phi_1392_: u32;
    var phi_1405_: u32;
    var phi_1410_: u32;
    var phi_1411_: u32;
    var phi_1412_: u32;
    var phi_1282_: u32;
    var phi_1285_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1470_: lt_bvh_Hit;
    var phi_1473_: u32;
    var phi_1519_: vec3<f32>;
    var phi_1520_: vec3<f32>;
    var phi_1553_: vec3<f32>;
    var phi_1554_: vec3<f32>;
    var phi_1587_: vec3<f32>;
    var phi_1588_: vec3<f32>;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1613_: f32;
    var phi_1614_: f32;
    var phi_1615_: f32;
    var phi_1616_: f32;
    var phi_1624_: f32;
    var phi_1634_: bool;
    var phi_1635_: bool;
    var phi_1639_: f32;
    var phi_1640_: f32;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1650_: f32;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1665_: f32;
    var phi_1666_: f32;
    var phi_1667_: f32;
    var phi_1668_: f32;
    var phi_1676_: f32;
    var phi_1691_: f32;
    var phi_1692_: bool;
    var phi_1693_: f32;
    var phi_1694_: bool;
    var phi_1695_: f32;
    var phi_1696_: bool;
    var phi_1714_: f32;
    var phi_1715_: bool;
    var phi_1716_: bool;
    var phi_1717_: f32;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1723_: bool;
    var phi_1724_: f32;
    var phi_1725_: bool;
    var phi_1751_: f32;
    var phi_1760_: f32;
    var phi_1769_: f32;
    var phi_1778_: f32;
    var phi_1785_: f32;
    var phi_1792_: f32;
    var phi_1805_: f32;
    var phi_1814_: f32;
    var phi_1823_: f32;
    var phi_1832_: f32;
    var phi_1839_: f32;
    var phi_1846_: f32;
    var phi_1869_: f32;
    var phi_1874_: f32;
    var phi_1879_: f32;
    var phi_1887_: f32;
    var phi_1892_: f32;
    var phi_1897_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1924_: f32;
    var phi_1929_: lt_bvh_triangle_Intersection;
    var phi_1930_: lt_bvh_triangle_Intersection;
    var phi_1931_: bool;
    var phi_1935_: lt_bvh_triangle_Intersection;
    var phi_1974_: bool;
    var phi_1975_: bool;
    var phi_1976_: bool;
    var phi_1977_: bool;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var phi_1983_: bool;
    var phi_1984_: bool;
    var phi_2182_: f32;
    var phi_2185_: bool;
    var phi_2186_: bool;
    var phi_2190_: bool;
    var phi_2198_: lt_bvh_Hit;
    var phi_2199_: lt_bvh_Hit;
    var phi_2200_: lt_bvh_Hit;
    var phi_2201_: lt_bvh_Hit;
    var phi_1471_: lt_bvh_Hit;
    var phi_1474_: u32;
    var phi_2202_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2273_: u32;
    var phi_1134_: lt_bvh_Hit;
    var phi_1137_: u32;
    var phi_2274_: lt_bvh_Hit;
    var phi_2275_: lt_bvh_Hit;
    var phi_2276_: bool;
    var phi_2280_: lt_bvh_Hit;
    var phi_2346_: f32;
    var phi_2351_: f32;
    var phi_2356_: f32;
    var phi_2367_: f32;
    var phi_2372_: f32;
    var phi_2377_: f32;
    var phi_2525_: u32;
    var phi_2591_: vec3<f32>;
    var phi_2592_: vec3<f32>;
    var phi_2596_: abi_Sample;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;

    let _e68 = id_1;
    let _e72 = arrayLength((&nodes.member));
    let _e75 = arrayLength((&triangles.member));
    let _e78 = arrayLength((&vertices.member));
    let _e81 = arrayLength((&materials.member));
    let _e87 = arrayLength((&alpha_texels.member));
    let _e90 = p.member.size[0u];
    let _e92 = p.member.size[1u];
    let _e93 = lt_shaders_entry_pixel_index(_e68, _e90, _e92);
    if (bitcast<i32>(_e93.root) != 0i) {
        let _e101 = p.member.eye;
        let _e106 = p.member.size[0u];
        let _e110 = ((((f32(_e68.x) + 0.5f) / f32(_e106)) * 2f) - 1f);
        let _e115 = p.member.size[1u];
        let _e119 = (1f - (((f32(_e68.y) + 0.5f) / f32(_e115)) * 2f));
        let _e121 = p.member.forward;
        let _e123 = p.member.right;
        let _e137 = p.member.up;
        let _e148 = _lt_bvh_ray_Ray_new(_e101, vec3<f32>(((_e121.x + (_e123.x * _e110)) + (_e137.x * _e119)), ((_e121.y + (_e123.y * _e110)) + (_e137.y * _e119)), ((_e121.z + (_e123.z * _e110)) + (_e137.z * _e119))));
        let _e150 = lt_bvh_Hit(_e148.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e160 = abs(_e148.direction.x);
        let _e162 = abs(_e148.direction.y);
        let _e164 = abs(_e148.direction.z);
        if (abs(_e148.origin.x) < 1000000000000000f) {
            if (abs(_e148.origin.y) < 1000000000000000f) {
                if (abs(_e148.origin.z) < 1000000000000000f) {
                    if (_e160 < 1000000000000000f) {
                        if (_e162 < 1000000000000000f) {
                            if (_e164 < 1000000000000000f) {
                                if (_e160 > 0f) {
                                    phi_722_ = bool();
                                    phi_723_ = true;
                                } else {
                                    let _e172 = (_e162 > 0f);
                                    if _e172 {
                                        phi_721_ = bool();
                                    } else {
                                        phi_721_ = (_e164 > 0f);
                                    }
                                    let _e175 = phi_721_;
                                    phi_722_ = _e175;
                                    phi_723_ = _e172;
                                }
                                let _e177 = phi_722_;
                                let _e179 = phi_723_;
                                if _e179 {
                                    phi_727_ = true;
                                } else {
                                    phi_727_ = _e177;
                                }
                                let _e181 = phi_727_;
                                phi_728_ = _e181;
                                phi_729_ = false;
                            } else {
                                phi_728_ = bool();
                                phi_729_ = true;
                            }
                            let _e183 = phi_728_;
                            let _e185 = phi_729_;
                            phi_730_ = _e183;
                            phi_731_ = false;
                            phi_732_ = _e185;
                        } else {
                            phi_730_ = bool();
                            phi_731_ = true;
                            phi_732_ = false;
                        }
                        let _e187 = phi_730_;
                        let _e189 = phi_731_;
                        let _e191 = phi_732_;
                        phi_733_ = _e187;
                        phi_734_ = _e189;
                        phi_735_ = _e191;
                    } else {
                        phi_733_ = bool();
                        phi_734_ = true;
                        phi_735_ = false;
                    }
                    let _e193 = phi_733_;
                    let _e195 = phi_734_;
                    let _e197 = phi_735_;
                    phi_736_ = _e193;
                    phi_737_ = _e195;
                    phi_738_ = _e197;
                } else {
                    phi_736_ = bool();
                    phi_737_ = true;
                    phi_738_ = false;
                }
                let _e199 = phi_736_;
                let _e201 = phi_737_;
                let _e203 = phi_738_;
                phi_739_ = _e199;
                phi_740_ = _e201;
                phi_741_ = _e203;
            } else {
                phi_739_ = bool();
                phi_740_ = true;
                phi_741_ = false;
            }
            let _e205 = phi_739_;
            let _e207 = phi_740_;
            let _e209 = phi_741_;
            phi_742_ = _e205;
            phi_743_ = _e207;
            phi_744_ = _e209;
        } else {
            phi_742_ = bool();
            phi_743_ = true;
            phi_744_ = false;
        }
        let _e211 = phi_742_;
        let _e213 = phi_743_;
        let _e215 = phi_744_;
        if _e213 {
            phi_748_ = true;
        } else {
            phi_748_ = _e215;
        }
        let _e217 = phi_748_;
        if _e217 {
            phi_752_ = false;
        } else {
            phi_752_ = _e211;
        }
        let _e219 = phi_752_;
        if _e219 {
            let _e220 = (0u >= _e72);
            if _e220 {
                phi_2274_ = lt_bvh_Hit();
            } else {
                if (0u < _e72) {
                } else {
                    return;
                }
                let _e226 = nodes.member[(0u + 0u)].frame[0u];
                let _e230 = nodes.member[(0u + 0u)].frame[1u];
                let _e234 = nodes.member[(0u + 0u)].frame[2u];
                let _e238 = nodes.member[(0u + 0u)].frame[0u];
                let _e242 = nodes.member[(0u + 0u)].frame[1u];
                let _e246 = nodes.member[(0u + 0u)].frame[2u];
                let _e250 = nodes.member[(0u + 0u)].frame[3u];
                let _e288 = core_intrinsics_maximum_number_nsz_f32_(abs(_e148.direction.x), abs(_e148.direction.y));
                let _e289 = core_intrinsics_maximum_number_nsz_f32_(_e288, abs(_e148.direction.z));
                let _e290 = (_e289 * 0.0000000000009094947f);
                if (abs(_e148.direction.x) < _e290) {
                    phi_827_ = _e290;
                } else {
                    phi_827_ = abs(_e148.direction.x);
                }
                let _e297 = phi_827_;
                if (_e148.direction.x < 0f) {
                    phi_834_ = (-1f / _e297);
                } else {
                    phi_834_ = (1f / _e297);
                }
                let _e302 = phi_834_;
                if (abs(_e148.direction.y) < _e290) {
                    phi_842_ = _e290;
                } else {
                    phi_842_ = abs(_e148.direction.y);
                }
                let _e309 = phi_842_;
                if (_e148.direction.y < 0f) {
                    phi_849_ = (-1f / _e309);
                } else {
                    phi_849_ = (1f / _e309);
                }
                let _e314 = phi_849_;
                if (abs(_e148.direction.z) < _e290) {
                    phi_857_ = _e290;
                } else {
                    phi_857_ = abs(_e148.direction.z);
                }
                let _e321 = phi_857_;
                if (_e148.direction.z < 0f) {
                    phi_864_ = (-1f / _e321);
                } else {
                    phi_864_ = (1f / _e321);
                }
                let _e326 = phi_864_;
                let _e334 = abs((bitcast<f32>(_e226) - _e148.origin.x));
                let _e335 = abs((bitcast<f32>(_e230) - _e148.origin.y));
                let _e336 = abs((bitcast<f32>(_e234) - _e148.origin.z));
                let _e344 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e250 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e148.origin.x));
                let _e345 = abs(((bitcast<f32>(_e242) + (bitcast<f32>((((_e250 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e148.origin.y));
                let _e346 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e250 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e148.origin.z));
                if (_e334 > _e344) {
                    phi_889_ = _e334;
                } else {
                    phi_889_ = _e344;
                }
                let _e349 = phi_889_;
                if (_e335 > _e345) {
                    phi_894_ = _e335;
                } else {
                    phi_894_ = _e345;
                }
                let _e352 = phi_894_;
                if (_e336 > _e346) {
                    phi_899_ = _e336;
                } else {
                    phi_899_ = _e346;
                }
                let _e355 = phi_899_;
                let _e356 = core_intrinsics_maximum_number_nsz_f32_(_e349, _e352);
                let _e357 = core_intrinsics_maximum_number_nsz_f32_(_e356, _e355);
                let _e362 = (_e357 * 0.0000019073486f);
                let _e363 = (abs(_e302) * _e362);
                let _e364 = (abs(_e314) * _e362);
                let _e365 = (abs(_e326) * _e362);
                let _e369 = (_e357 * 0.0000009536743f);
                let _e370 = (abs(_e302) * _e369);
                let _e371 = (abs(_e314) * _e369);
                let _e372 = (abs(_e326) * _e369);
                let _e375 = abs(_e148.direction.x);
                let _e377 = abs(_e148.direction.y);
                let _e379 = abs(_e148.direction.z);
                if (_e375 >= _e377) {
                    if (_e375 >= _e379) {
                        phi_932_ = false;
                    } else {
                        phi_932_ = true;
                    }
                    let _e383 = phi_932_;
                    phi_933_ = _e383;
                } else {
                    phi_933_ = true;
                }
                let _e385 = phi_933_;
                if _e385 {
                    if (_e377 >= _e379) {
                        phi_941_ = 1u;
                    } else {
                        phi_941_ = 2u;
                    }
                    let _e388 = phi_941_;
                    phi_942_ = _e388;
                } else {
                    phi_942_ = 0u;
                }
                let _e390 = phi_942_;
                if (_e390 == 0u) {
                    phi_961_ = vec3<f32>(_e148.direction.y, _e148.direction.z, _e148.direction.x);
                } else {
                    if (_e390 == 1u) {
                        phi_960_ = vec3<f32>(_e148.direction.z, _e148.direction.x, _e148.direction.y);
                    } else {
                        phi_960_ = _e148.direction;
                    }
                    let _e403 = phi_960_;
                    phi_961_ = _e403;
                }
                let _e405 = phi_961_;
                let _e409 = (_e405.x / _e405.z);
                let _e412 = (_e405.y / _e405.z);
                let _e414 = (1f / _e405.z);
                if (_e302 < 0f) {
                    phi_975_ = 0u;
                } else {
                    phi_975_ = 1u;
                }
                let _e417 = phi_975_;
                if (_e314 < 0f) {
                    phi_980_ = 0u;
                } else {
                    phi_980_ = 2u;
                }
                let _e420 = phi_980_;
                if (_e326 < 0f) {
                    phi_985_ = 0u;
                } else {
                    phi_985_ = 4u;
                }
                let _e423 = phi_985_;
                let _e425 = ((_e417 | _e420) | _e423);
                let _e426 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_4 = lt_bvh_traverse_Stack(array<u32, 32>(_e426.first[0], _e426.first[1], _e426.first[2], _e426.first[3], _e426.first[4], _e426.first[5], _e426.first[6], _e426.first[7], _e426.first[8], _e426.first[9], _e426.first[10], _e426.first[11], _e426.first[12], _e426.first[13], _e426.first[14], _e426.first[15], _e426.first[16], _e426.first[17], _e426.first[18], _e426.first[19], _e426.first[20], _e426.first[21], _e426.first[22], _e426.first[23], _e426.first[24], _e426.first[25], _e426.first[26], _e426.first[27], _e426.first[28], _e426.first[29], _e426.first[30], _e426.first[31]), array<u32, 32>(_e426.mask[0], _e426.mask[1], _e426.mask[2], _e426.mask[3], _e426.mask[4], _e426.mask[5], _e426.mask[6], _e426.mask[7], _e426.mask[8], _e426.mask[9], _e426.mask[10], _e426.mask[11], _e426.mask[12], _e426.mask[13], _e426.mask[14], _e426.mask[15], _e426.mask[16], _e426.mask[17], _e426.mask[18], _e426.mask[19], _e426.mask[20], _e426.mask[21], _e426.mask[22], _e426.mask[23], _e426.mask[24], _e426.mask[25], _e426.mask[26], _e426.mask[27], _e426.mask[28], _e426.mask[29], _e426.mask[30], _e426.mask[31]), _e426.len, _e426.group, _e426.group_mask);
                let _e500 = local_4.group_mask;
                if ((_e500 & 4278190080u) == 0u) {
                    let _e504 = local_4.len;
                    if (_e504 == 0u) {
                        phi_1099_ = false;
                    } else {
                        let _e508 = local_4.len;
                        local_4.len = (_e508 - 1u);
                        let _e511 = local_4.len;
                        if (_e511 < 32u) {
                        } else {
                            return;
                        }
                        let _e516 = local_4.first[(0u + _e511)];
                        local_4.group = _e516;
                        let _e519 = local_4.len;
                        if (_e519 < 32u) {
                        } else {
                            return;
                        }
                        let _e524 = local_4.mask[(0u + _e519)];
                        local_4.group_mask = _e524;
                        phi_1099_ = true;
                    }
                    let _e527 = phi_1099_;
                    phi_1100_ = _e527;
                } else {
                    phi_1100_ = true;
                }
                let _e529 = phi_1100_;
                if _e529 {
                    let _e531 = local_4.group_mask;
                    let _e537 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, (_e531 == 0u)));
                    let _e541 = local_4.group_mask;
                    let _e555 = local_4.group_mask;
                    local_4.group_mask = (_e555 & ~((1u << bitcast<u32>((_e537 & 31u)))));
                    let _e558 = local_4.group;
                    phi_1131_ = (_e558 + countOneBits(((_e541 & ~((4294967295u << bitcast<u32>((((_e537 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1131_ = 4294967295u;
                }
                let _e561 = phi_1131_;
                phi_1133_ = _e150;
                phi_1136_ = _e561;
                loop {
                    let _e563 = phi_1133_;
                    let _e565 = phi_1136_;
                    local_9 = _e563;
                    let _e566 = (_e565 != 4294967295u);
                    if _e566 {
                        if (_e565 < _e72) {
                        } else {
                            return;
                        }
                        let _e574 = nodes.member[(0u + _e565)].frame[3u];
                        let _e599 = (bitcast<f32>((((_e574 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e600 = (bitcast<f32>((((_e574 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e601 = (bitcast<f32>((((_e574 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e604 = nodes.member[(0u + _e565)].frame[0u];
                        let _e608 = nodes.member[(0u + _e565)].frame[1u];
                        let _e612 = nodes.member[(0u + _e565)].frame[2u];
                        let _e620 = ((bitcast<f32>(_e604) - _e148.origin.x) * _e302);
                        let _e621 = ((bitcast<f32>(_e608) - _e148.origin.y) * _e314);
                        let _e622 = ((bitcast<f32>(_e612) - _e148.origin.z) * _e326);
                        let _e630 = nodes.member[(0u + _e565)].x;
                        if (_e302 < 0f) {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e630.w), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e630.x, _e647.unnamed_1.first_primitive));
                            phi_1221_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e630.y));
                        } else {
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.unnamed.root, _e630.y), _e669.unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e630.z, _e675.unnamed_1.first_primitive));
                            phi_1221_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_bvh_traverse_Tree(_e681.unnamed_1.root, _e630.w));
                        }
                        let _e689 = phi_1221_;
                        let _e699 = nodes.member[(0u + _e565)].y;
                        if (_e314 < 0f) {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e699.w), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e699.x, _e716.unnamed_1.first_primitive));
                            phi_1248_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e699.y));
                        } else {
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e738.unnamed.root, _e699.y), _e738.unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e699.z, _e744.unnamed_1.first_primitive));
                            phi_1248_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_bvh_traverse_Tree(_e750.unnamed_1.root, _e699.w));
                        }
                        let _e758 = phi_1248_;
                        let _e768 = nodes.member[(0u + _e565)].z;
                        if (_e326 < 0f) {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e768.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.unnamed.root, _e768.w), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_bvh_traverse_Tree(_e768.x, _e785.unnamed_1.first_primitive));
                            phi_1275_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_bvh_traverse_Tree(_e791.unnamed_1.root, _e768.y));
                        } else {
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e768.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e807.unnamed.root, _e768.y), _e807.unnamed_1);
                            let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e813.unnamed, lt_bvh_traverse_Tree(_e768.z, _e813.unnamed_1.first_primitive));
                            phi_1275_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_bvh_traverse_Tree(_e819.unnamed_1.root, _e768.w));
                        }
                        let _e827 = phi_1275_;
                        phi_1281_ = 0u;
                        phi_1284_ = 0u;
                        loop {
                            let _e837 = phi_1281_;
                            let _e839 = phi_1284_;
                            local_5 = _e839;
                            local_6 = _e839;
                            local_7 = _e839;
                            let _e840 = (_e837 < 8u);
                            if _e840 {
                                let _e842 = (_e837 >> bitcast<u32>(2i));
                                let _e843 = (_e837 & 3u);
                                if (_e842 == 0u) {
                                    phi_1298_ = _e689.unnamed.root;
                                } else {
                                    phi_1298_ = _e689.unnamed.first_primitive;
                                }
                                let _e846 = phi_1298_;
                                if (_e842 == 0u) {
                                    phi_1308_ = _e758.unnamed.root;
                                } else {
                                    phi_1308_ = _e758.unnamed.first_primitive;
                                }
                                let _e855 = phi_1308_;
                                if (_e842 == 0u) {
                                    phi_1318_ = _e827.unnamed.root;
                                } else {
                                    phi_1318_ = _e827.unnamed.first_primitive;
                                }
                                let _e864 = phi_1318_;
                                let _e877 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e846 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e363)), ((f32(((_e855 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e364)));
                                let _e878 = core_intrinsics_maximum_number_nsz_f32_(_e877, ((f32(((_e864 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e365)));
                                if (_e842 == 0u) {
                                    phi_1336_ = _e689.unnamed_1.root;
                                } else {
                                    phi_1336_ = _e689.unnamed_1.first_primitive;
                                }
                                let _e881 = phi_1336_;
                                if (_e842 == 0u) {
                                    phi_1346_ = _e758.unnamed_1.root;
                                } else {
                                    phi_1346_ = _e758.unnamed_1.first_primitive;
                                }
                                let _e890 = phi_1346_;
                                if (_e842 == 0u) {
                                    phi_1356_ = _e827.unnamed_1.root;
                                } else {
                                    phi_1356_ = _e827.unnamed_1.first_primitive;
                                }
                                let _e899 = phi_1356_;
                                let _e912 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e881 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e363)), ((f32(((_e890 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e364)));
                                let _e913 = core_intrinsics_minimum_number_nsz_f32_(_e912, ((f32(((_e899 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 + _e365)));
                                if (_e878 <= _e913) {
                                    if (_e878 <= _e563.t) {
                                        if (_e913 >= _e148.tmin) {
                                            if (_e842 == 0u) {
                                                let _e920 = nodes.member[(0u + _e565)].links[2u];
                                                phi_1392_ = _e920;
                                            } else {
                                                let _e923 = nodes.member[(0u + _e565)].links[3u];
                                                phi_1392_ = _e923;
                                            }
                                            let _e925 = phi_1392_;
                                            let _e930 = ((_e925 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u);
                                            let _e931 = (_e930 & 31u);
                                            if (_e931 >= 24u) {
                                                phi_1405_ = (24u + ((_e931 - 24u) ^ _e425));
                                            } else {
                                                phi_1405_ = _e931;
                                            }
                                            let _e937 = phi_1405_;
                                            phi_1410_ = (_e839 | ((_e930 >> bitcast<u32>(5i)) << bitcast<u32>((_e937 & 31u))));
                                        } else {
                                            phi_1410_ = _e839;
                                        }
                                        let _e945 = phi_1410_;
                                        phi_1411_ = _e945;
                                    } else {
                                        phi_1411_ = _e839;
                                    }
                                    let _e947 = phi_1411_;
                                    phi_1412_ = _e947;
                                } else {
                                    phi_1412_ = _e839;
                                }
                                let _e949 = phi_1412_;
                                phi_1282_ = (_e837 + 1u);
                                phi_1285_ = _e949;
                            } else {
                                phi_1282_ = u32();
                                phi_1285_ = u32();
                            }
                            let _e952 = phi_1282_;
                            let _e954 = phi_1285_;
                            continue;
                            continuing {
                                phi_1281_ = _e952;
                                phi_1284_ = _e954;
                                break if !(_e840);
                            }
                        }
                        let _e958 = nodes.member[(0u + _e565)].links[0u];
                        let _e962 = nodes.member[(0u + _e565)].frame[3u];
                        let _e966 = local_5;
                        if ((_e966 & 4278190080u) == 0u) {
                        } else {
                            let _e970 = local_4.group_mask;
                            if ((_e970 & 4278190080u) == 0u) {
                            } else {
                                let _e974 = local_4.len;
                                if (_e974 < 32u) {
                                    let _e977 = local_4.group;
                                    let _e979 = local_4.len;
                                    if (_e979 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_4.first[(0u + _e979)] = _e977;
                                    let _e985 = local_4.group_mask;
                                    let _e987 = local_4.len;
                                    if (_e987 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_4.mask[(0u + _e987)] = _e985;
                                    let _e994 = local_4.len;
                                    local_4.len = (_e994 + 1u);
                                }
                            }
                            local_4.group = (0u + _e958);
                            let _e998 = local_6;
                            local_4.group_mask = ((_e998 & 4278190080u) | (_e962 >> bitcast<u32>(24i)));
                        }
                        let _e1003 = local_7;
                        phi_1470_ = _e563;
                        phi_1473_ = (_e1003 & 16777215u);
                        loop {
                            let _e1006 = phi_1470_;
                            let _e1008 = phi_1473_;
                            local_8 = _e1006;
                            if (_e1008 == 0u) {
                                phi_1471_ = lt_bvh_Hit();
                                phi_1474_ = u32();
                                phi_2202_ = false;
                            } else {
                                let _e1012 = nodes.member[(0u + _e565)].links[1u];
                                let _e1017 = ((0u + _e1012) + select(firstTrailingBit(_e1008), 32u, (_e1008 == 0u)));
                                if (_e1017 < _e75) {
                                } else {
                                    return;
                                }
                                let _e1024 = triangles.member[(0u + _e1017)].v0_;
                                let _e1027 = (_e1024.x - _e148.origin.x);
                                let _e1030 = (_e1024.y - _e148.origin.y);
                                let _e1033 = (_e1024.z - _e148.origin.z);
                                if (_e390 == 0u) {
                                    phi_1520_ = vec3<f32>(_e1030, _e1033, _e1027);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1519_ = vec3<f32>(_e1033, _e1027, _e1030);
                                    } else {
                                        phi_1519_ = (_e1024 - _e148.origin);
                                    }
                                    let _e1040 = phi_1519_;
                                    phi_1520_ = _e1040;
                                }
                                let _e1042 = phi_1520_;
                                let _e1046 = (_e1042.x - (_e409 * _e1042.z));
                                let _e1050 = (_e1042.y - (_e412 * _e1042.z));
                                let _e1054 = triangles.member[(0u + _e1017)].v1_;
                                let _e1057 = (_e1054.x - _e148.origin.x);
                                let _e1060 = (_e1054.y - _e148.origin.y);
                                let _e1063 = (_e1054.z - _e148.origin.z);
                                if (_e390 == 0u) {
                                    phi_1554_ = vec3<f32>(_e1060, _e1063, _e1057);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1553_ = vec3<f32>(_e1063, _e1057, _e1060);
                                    } else {
                                        phi_1553_ = (_e1054 - _e148.origin);
                                    }
                                    let _e1070 = phi_1553_;
                                    phi_1554_ = _e1070;
                                }
                                let _e1072 = phi_1554_;
                                let _e1076 = (_e1072.x - (_e409 * _e1072.z));
                                let _e1080 = (_e1072.y - (_e412 * _e1072.z));
                                let _e1084 = triangles.member[(0u + _e1017)].v2_;
                                let _e1087 = (_e1084.x - _e148.origin.x);
                                let _e1090 = (_e1084.y - _e148.origin.y);
                                let _e1093 = (_e1084.z - _e148.origin.z);
                                if (_e390 == 0u) {
                                    phi_1588_ = vec3<f32>(_e1090, _e1093, _e1087);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1587_ = vec3<f32>(_e1093, _e1087, _e1090);
                                    } else {
                                        phi_1587_ = (_e1084 - _e148.origin);
                                    }
                                    let _e1100 = phi_1587_;
                                    phi_1588_ = _e1100;
                                }
                                let _e1102 = phi_1588_;
                                let _e1106 = (_e1102.x - (_e409 * _e1102.z));
                                let _e1110 = (_e1102.y - (_e412 * _e1102.z));
                                if (_e1076 < _e1106) {
                                    phi_1609_ = true;
                                } else {
                                    if (_e1076 == _e1106) {
                                        phi_1608_ = (_e1080 < _e1110);
                                    } else {
                                        phi_1608_ = false;
                                    }
                                    let _e1117 = phi_1608_;
                                    phi_1609_ = _e1117;
                                }
                                let _e1119 = phi_1609_;
                                if _e1119 {
                                    phi_1613_ = _e1110;
                                    phi_1614_ = _e1106;
                                    phi_1615_ = _e1080;
                                    phi_1616_ = _e1076;
                                } else {
                                    phi_1613_ = _e1080;
                                    phi_1614_ = _e1076;
                                    phi_1615_ = _e1110;
                                    phi_1616_ = _e1106;
                                }
                                let _e1121 = phi_1613_;
                                let _e1123 = phi_1614_;
                                let _e1125 = phi_1615_;
                                let _e1127 = phi_1616_;
                                let _e1130 = ((_e1127 * _e1121) - (_e1125 * _e1123));
                                if _e1119 {
                                    phi_1624_ = -(_e1130);
                                } else {
                                    phi_1624_ = _e1130;
                                }
                                let _e1133 = phi_1624_;
                                if (_e1106 < _e1046) {
                                    phi_1635_ = true;
                                } else {
                                    if (_e1106 == _e1046) {
                                        phi_1634_ = (_e1110 < _e1050);
                                    } else {
                                        phi_1634_ = false;
                                    }
                                    let _e1138 = phi_1634_;
                                    phi_1635_ = _e1138;
                                }
                                let _e1140 = phi_1635_;
                                if _e1140 {
                                    phi_1639_ = _e1050;
                                    phi_1640_ = _e1046;
                                    phi_1641_ = _e1110;
                                    phi_1642_ = _e1106;
                                } else {
                                    phi_1639_ = _e1110;
                                    phi_1640_ = _e1106;
                                    phi_1641_ = _e1050;
                                    phi_1642_ = _e1046;
                                }
                                let _e1142 = phi_1639_;
                                let _e1144 = phi_1640_;
                                let _e1146 = phi_1641_;
                                let _e1148 = phi_1642_;
                                let _e1151 = ((_e1148 * _e1142) - (_e1146 * _e1144));
                                if _e1140 {
                                    phi_1650_ = -(_e1151);
                                } else {
                                    phi_1650_ = _e1151;
                                }
                                let _e1154 = phi_1650_;
                                if (_e1046 < _e1076) {
                                    phi_1661_ = true;
                                } else {
                                    if (_e1046 == _e1076) {
                                        phi_1660_ = (_e1050 < _e1080);
                                    } else {
                                        phi_1660_ = false;
                                    }
                                    let _e1159 = phi_1660_;
                                    phi_1661_ = _e1159;
                                }
                                let _e1161 = phi_1661_;
                                if _e1161 {
                                    phi_1665_ = _e1080;
                                    phi_1666_ = _e1076;
                                    phi_1667_ = _e1050;
                                    phi_1668_ = _e1046;
                                } else {
                                    phi_1665_ = _e1050;
                                    phi_1666_ = _e1046;
                                    phi_1667_ = _e1080;
                                    phi_1668_ = _e1076;
                                }
                                let _e1163 = phi_1665_;
                                let _e1165 = phi_1666_;
                                let _e1167 = phi_1667_;
                                let _e1169 = phi_1668_;
                                let _e1172 = ((_e1169 * _e1163) - (_e1167 * _e1165));
                                if _e1161 {
                                    phi_1676_ = -(_e1172);
                                } else {
                                    phi_1676_ = _e1172;
                                }
                                let _e1175 = phi_1676_;
                                if (_e1133 >= 0f) {
                                    if (_e1154 >= 0f) {
                                        if (_e1175 >= 0f) {
                                            phi_1691_ = ((_e1133 + _e1154) + _e1175);
                                            phi_1692_ = false;
                                        } else {
                                            phi_1691_ = f32();
                                            phi_1692_ = true;
                                        }
                                        let _e1182 = phi_1691_;
                                        let _e1184 = phi_1692_;
                                        phi_1693_ = _e1182;
                                        phi_1694_ = _e1184;
                                    } else {
                                        phi_1693_ = f32();
                                        phi_1694_ = true;
                                    }
                                    let _e1186 = phi_1693_;
                                    let _e1188 = phi_1694_;
                                    phi_1695_ = _e1186;
                                    phi_1696_ = _e1188;
                                } else {
                                    phi_1695_ = f32();
                                    phi_1696_ = true;
                                }
                                let _e1190 = phi_1695_;
                                let _e1192 = phi_1696_;
                                if _e1192 {
                                    if (_e1133 <= 0f) {
                                        if (_e1154 <= 0f) {
                                            let _e1195 = (_e1175 <= 0f);
                                            if _e1195 {
                                            }
                                            phi_1714_ = ((_e1133 + _e1154) + _e1175);
                                            phi_1715_ = false;
                                            phi_1716_ = _e1195;
                                        } else {
                                            phi_1714_ = f32();
                                            phi_1715_ = true;
                                            phi_1716_ = false;
                                        }
                                        let _e1199 = phi_1714_;
                                        let _e1201 = phi_1715_;
                                        let _e1203 = phi_1716_;
                                        phi_1717_ = _e1199;
                                        phi_1718_ = _e1201;
                                        phi_1719_ = _e1203;
                                    } else {
                                        phi_1717_ = f32();
                                        phi_1718_ = true;
                                        phi_1719_ = false;
                                    }
                                    let _e1205 = phi_1717_;
                                    let _e1207 = phi_1718_;
                                    let _e1209 = phi_1719_;
                                    if _e1207 {
                                        phi_1723_ = false;
                                    } else {
                                        phi_1723_ = _e1209;
                                    }
                                    let _e1211 = phi_1723_;
                                    phi_1724_ = _e1205;
                                    phi_1725_ = _e1211;
                                } else {
                                    phi_1724_ = _e1190;
                                    phi_1725_ = true;
                                }
                                let _e1213 = phi_1724_;
                                let _e1215 = phi_1725_;
                                if _e1215 {
                                    let _e1216 = (_e1213 == 0f);
                                    if _e1216 {
                                        phi_1929_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1222 = ((((_e1133 * (_e414 * _e1042.z)) + (_e1154 * (_e414 * _e1072.z))) + (_e1175 * (_e414 * _e1102.z))) / _e1213);
                                        let _e1224 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1226 = triangles.member[(0u + _e1017)].v1_;
                                        if (_e1224.x < _e1226.x) {
                                            phi_1751_ = _e1224.x;
                                        } else {
                                            phi_1751_ = _e1226.x;
                                        }
                                        let _e1233 = phi_1751_;
                                        if (_e1224.y < _e1226.y) {
                                            phi_1760_ = _e1224.y;
                                        } else {
                                            phi_1760_ = _e1226.y;
                                        }
                                        let _e1240 = phi_1760_;
                                        if (_e1224.z < _e1226.z) {
                                            phi_1769_ = _e1224.z;
                                        } else {
                                            phi_1769_ = _e1226.z;
                                        }
                                        let _e1247 = phi_1769_;
                                        let _e1249 = triangles.member[(0u + _e1017)].v2_;
                                        if (_e1233 < _e1249.x) {
                                            phi_1778_ = _e1233;
                                        } else {
                                            phi_1778_ = _e1249.x;
                                        }
                                        let _e1254 = phi_1778_;
                                        if (_e1240 < _e1249.y) {
                                            phi_1785_ = _e1240;
                                        } else {
                                            phi_1785_ = _e1249.y;
                                        }
                                        let _e1259 = phi_1785_;
                                        if (_e1247 < _e1249.z) {
                                            phi_1792_ = _e1247;
                                        } else {
                                            phi_1792_ = _e1249.z;
                                        }
                                        let _e1264 = phi_1792_;
                                        let _e1266 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1268 = triangles.member[(0u + _e1017)].v1_;
                                        if (_e1266.x > _e1268.x) {
                                            phi_1805_ = _e1266.x;
                                        } else {
                                            phi_1805_ = _e1268.x;
                                        }
                                        let _e1275 = phi_1805_;
                                        if (_e1266.y > _e1268.y) {
                                            phi_1814_ = _e1266.y;
                                        } else {
                                            phi_1814_ = _e1268.y;
                                        }
                                        let _e1282 = phi_1814_;
                                        if (_e1266.z > _e1268.z) {
                                            phi_1823_ = _e1266.z;
                                        } else {
                                            phi_1823_ = _e1268.z;
                                        }
                                        let _e1289 = phi_1823_;
                                        let _e1291 = triangles.member[(0u + _e1017)].v2_;
                                        if (_e1275 > _e1291.x) {
                                            phi_1832_ = _e1275;
                                        } else {
                                            phi_1832_ = _e1291.x;
                                        }
                                        let _e1296 = phi_1832_;
                                        if (_e1282 > _e1291.y) {
                                            phi_1839_ = _e1282;
                                        } else {
                                            phi_1839_ = _e1291.y;
                                        }
                                        let _e1301 = phi_1839_;
                                        if (_e1289 > _e1291.z) {
                                            phi_1846_ = _e1289;
                                        } else {
                                            phi_1846_ = _e1291.z;
                                        }
                                        let _e1306 = phi_1846_;
                                        let _e1313 = ((_e1254 - _e148.origin.x) * _e302);
                                        let _e1314 = ((_e1259 - _e148.origin.y) * _e314);
                                        let _e1315 = ((_e1264 - _e148.origin.z) * _e326);
                                        let _e1322 = ((_e1296 - _e148.origin.x) * _e302);
                                        let _e1323 = ((_e1301 - _e148.origin.y) * _e314);
                                        let _e1324 = ((_e1306 - _e148.origin.z) * _e326);
                                        if (_e1313 < _e1322) {
                                            phi_1869_ = _e1313;
                                        } else {
                                            phi_1869_ = _e1322;
                                        }
                                        let _e1327 = phi_1869_;
                                        if (_e1314 < _e1323) {
                                            phi_1874_ = _e1314;
                                        } else {
                                            phi_1874_ = _e1323;
                                        }
                                        let _e1330 = phi_1874_;
                                        if (_e1315 < _e1324) {
                                            phi_1879_ = _e1315;
                                        } else {
                                            phi_1879_ = _e1324;
                                        }
                                        let _e1333 = phi_1879_;
                                        if (_e1313 > _e1322) {
                                            phi_1887_ = _e1313;
                                        } else {
                                            phi_1887_ = _e1322;
                                        }
                                        let _e1339 = phi_1887_;
                                        if (_e1314 > _e1323) {
                                            phi_1892_ = _e1314;
                                        } else {
                                            phi_1892_ = _e1323;
                                        }
                                        let _e1342 = phi_1892_;
                                        if (_e1315 > _e1324) {
                                            phi_1897_ = _e1315;
                                        } else {
                                            phi_1897_ = _e1324;
                                        }
                                        let _e1345 = phi_1897_;
                                        let _e1349 = core_intrinsics_maximum_number_nsz_f32_((_e1327 - _e370), (_e1330 - _e371));
                                        let _e1350 = core_intrinsics_maximum_number_nsz_f32_(_e1349, (_e1333 - _e372));
                                        let _e1351 = core_intrinsics_minimum_number_nsz_f32_((_e1339 + _e370), (_e1342 + _e371));
                                        let _e1352 = core_intrinsics_minimum_number_nsz_f32_(_e1351, (_e1345 + _e372));
                                        if (_e1350 > -300000000000000000000000000000000000000f) {
                                            phi_1909_ = _e1350;
                                        } else {
                                            phi_1909_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1355 = phi_1909_;
                                        if (_e1352 < 300000000000000000000000000000000000000f) {
                                            phi_1914_ = _e1352;
                                        } else {
                                            phi_1914_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1358 = phi_1914_;
                                        if (_e1222 < _e1355) {
                                            phi_1919_ = _e1355;
                                        } else {
                                            phi_1919_ = _e1222;
                                        }
                                        let _e1361 = phi_1919_;
                                        if (_e1361 > _e1358) {
                                            phi_1924_ = _e1358;
                                        } else {
                                            phi_1924_ = _e1361;
                                        }
                                        let _e1364 = phi_1924_;
                                        phi_1929_ = lt_bvh_triangle_Intersection(_e1364, (_e1154 / _e1213), (_e1175 / _e1213), (_e1355 <= _e1358));
                                    }
                                    let _e1370 = phi_1929_;
                                    phi_1930_ = _e1370;
                                    phi_1931_ = _e1216;
                                } else {
                                    phi_1930_ = lt_bvh_triangle_Intersection();
                                    phi_1931_ = true;
                                }
                                let _e1372 = phi_1930_;
                                let _e1374 = phi_1931_;
                                if _e1374 {
                                    phi_1935_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1935_ = _e1372;
                                }
                                let _e1376 = phi_1935_;
                                if _e1376.is_hit {
                                    if (_e1376.t > _e148.tmin) {
                                        if (_e1376.t < _e1006.t) {
                                            phi_1984_ = true;
                                        } else {
                                            if (_e1376.t == _e1006.t) {
                                                if (_e1006.triangle != 4294967295u) {
                                                    if (_e1017 < _e1006.triangle) {
                                                        phi_1975_ = true;
                                                    } else {
                                                        if (_e1017 == _e1006.triangle) {
                                                            phi_1974_ = (4294967295u < _e1006.instance);
                                                        } else {
                                                            phi_1974_ = false;
                                                        }
                                                        let _e1395 = phi_1974_;
                                                        phi_1975_ = _e1395;
                                                    }
                                                    let _e1397 = phi_1975_;
                                                    phi_1976_ = _e1397;
                                                    phi_1977_ = false;
                                                } else {
                                                    phi_1976_ = bool();
                                                    phi_1977_ = true;
                                                }
                                                let _e1399 = phi_1976_;
                                                let _e1401 = phi_1977_;
                                                phi_1978_ = _e1399;
                                                phi_1979_ = _e1401;
                                            } else {
                                                phi_1978_ = bool();
                                                phi_1979_ = true;
                                            }
                                            let _e1403 = phi_1978_;
                                            let _e1405 = phi_1979_;
                                            if _e1405 {
                                                phi_1983_ = false;
                                            } else {
                                                phi_1983_ = _e1403;
                                            }
                                            let _e1407 = phi_1983_;
                                            phi_1984_ = _e1407;
                                        }
                                        let _e1409 = phi_1984_;
                                        if _e1409 {
                                            let _e1411 = triangles.member[(0u + _e1017)].i0_;
                                            if ((_e1411 & 2147483648u) == 0u) {
                                                phi_2190_ = true;
                                            } else {
                                                if (_e1017 < _e75) {
                                                } else {
                                                    return;
                                                }
                                                let _e1420 = triangles.member[(0u + _e1017)].i0_;
                                                let _e1421 = (_e1420 & 2147483647u);
                                                let _e1423 = triangles.member[(0u + _e1017)].i1_;
                                                let _e1425 = triangles.member[(0u + _e1017)].i2_;
                                                if (_e1421 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1429 = vertices.member[(0u + _e1421)];
                                                if (_e1423 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1433 = vertices.member[(0u + _e1423)];
                                                if (_e1425 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1437 = vertices.member[(0u + _e1425)];
                                                let _e1438 = array<abi_Vertex, 3>(_e1429, _e1433, _e1437);
                                                local_3 = array<abi_Vertex, 3>(abi_Vertex(_e1438[0].u, _e1438[0].v, _e1438[0].normal, _e1438[0].color, _e1438[0].material), abi_Vertex(_e1438[1].u, _e1438[1].v, _e1438[1].normal, _e1438[1].color, _e1438[1].material), abi_Vertex(_e1438[2].u, _e1438[2].v, _e1438[2].normal, _e1438[2].color, _e1438[2].material));
                                                let _e1463 = local_3[0u].material;
                                                if (_e1463 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1467 = materials.member[(0u + _e1463)];
                                                if ((_e1467.flags & 0u) == 0u) {
                                                    let _e1471 = lt_shaders_surface_barycentric_weights(_e1376.u, _e1376.v);
                                                    if (_e1467.cutoff <= 0f) {
                                                        phi_2185_ = true;
                                                    } else {
                                                        let _e1476 = lt_shaders_surface_vertex_color((&local_3), _e1471);
                                                        let _e1478 = (_e1467.base_color.w * _e1476.w);
                                                        if (_e1467.alpha_size == 0u) {
                                                            phi_2182_ = _e1478;
                                                        } else {
                                                            local_2.offset = _e1467.alpha_offset;
                                                            local_2.size = _e1467.alpha_size;
                                                            local_2.flags = _e1467.flags;
                                                            let _e1487 = lt_shaders_surface_texture_coordinate((&local_3), _e1471);
                                                            let _e1490 = _lt_shaders_texture_TextureView_quad((&local_2), _e1487.x, _e1487.y);
                                                            let _e1494 = (_e1490.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1494 < _e87) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1498 = alpha_texels.member[(0u + _e1494)];
                                                            let _e1514 = (_e1490.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1514 < _e87) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1518 = alpha_texels.member[(0u + _e1514)];
                                                            let _e1535 = (_e1490.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1535 < _e87) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1539 = alpha_texels.member[(0u + _e1535)];
                                                            let _e1556 = (_e1490.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1556 < _e87) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1560 = alpha_texels.member[(0u + _e1556)];
                                                            phi_2182_ = (_e1478 * (((((f32(((_e1498 >> bitcast<u32>((((_e1490.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1490.weights.x) + ((f32(((_e1518 >> bitcast<u32>((((_e1490.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1490.weights.y)) + ((f32(((_e1539 >> bitcast<u32>((((_e1490.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1490.weights.z)) + ((f32(((_e1560 >> bitcast<u32>((((_e1490.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1490.weights.w)));
                                                        }
                                                        let _e1576 = phi_2182_;
                                                        phi_2185_ = (_e1576 >= _e1467.cutoff);
                                                    }
                                                    let _e1580 = phi_2185_;
                                                    phi_2186_ = _e1580;
                                                } else {
                                                    phi_2186_ = false;
                                                }
                                                let _e1582 = phi_2186_;
                                                if _e1582 {
                                                }
                                                phi_2190_ = _e1582;
                                            }
                                            let _e1584 = phi_2190_;
                                            if _e1584 {
                                                phi_2198_ = lt_bvh_Hit(_e1376.t, _e1376.u, _e1376.v, _e1017, 4294967295u);
                                            } else {
                                                phi_2198_ = _e1006;
                                            }
                                            let _e1590 = phi_2198_;
                                            phi_2199_ = _e1590;
                                        } else {
                                            phi_2199_ = _e1006;
                                        }
                                        let _e1592 = phi_2199_;
                                        phi_2200_ = _e1592;
                                    } else {
                                        phi_2200_ = _e1006;
                                    }
                                    let _e1594 = phi_2200_;
                                    phi_2201_ = _e1594;
                                } else {
                                    phi_2201_ = _e1006;
                                }
                                let _e1596 = phi_2201_;
                                phi_1471_ = _e1596;
                                phi_1474_ = (_e1008 & (_e1008 - 1u));
                                phi_2202_ = true;
                            }
                            let _e1598 = phi_1471_;
                            let _e1600 = phi_1474_;
                            let _e1602 = phi_2202_;
                            continue;
                            continuing {
                                phi_1470_ = _e1598;
                                phi_1473_ = _e1600;
                                break if !(_e1602);
                            }
                        }
                        let _e1605 = local_4.group_mask;
                        if ((_e1605 & 4278190080u) == 0u) {
                            let _e1609 = local_4.len;
                            if (_e1609 == 0u) {
                                phi_2241_ = false;
                            } else {
                                let _e1613 = local_4.len;
                                local_4.len = (_e1613 - 1u);
                                let _e1616 = local_4.len;
                                if (_e1616 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1621 = local_4.first[(0u + _e1616)];
                                local_4.group = _e1621;
                                let _e1624 = local_4.len;
                                if (_e1624 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1629 = local_4.mask[(0u + _e1624)];
                                local_4.group_mask = _e1629;
                                phi_2241_ = true;
                            }
                            let _e1632 = phi_2241_;
                            phi_2242_ = _e1632;
                        } else {
                            phi_2242_ = true;
                        }
                        let _e1634 = phi_2242_;
                        if _e1634 {
                            let _e1636 = local_4.group_mask;
                            let _e1642 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1636)), 32u, (_e1636 == 0u)));
                            let _e1646 = local_4.group_mask;
                            let _e1660 = local_4.group_mask;
                            local_4.group_mask = (_e1660 & ~((1u << bitcast<u32>((_e1642 & 31u)))));
                            let _e1663 = local_4.group;
                            phi_2273_ = (_e1663 + countOneBits(((_e1646 & ~((4294967295u << bitcast<u32>((((_e1642 - 24u) ^ _e425) & 31u))))) & 255u)));
                        } else {
                            phi_2273_ = 4294967295u;
                        }
                        let _e1666 = phi_2273_;
                        let _e2121 = local_8;
                        phi_1134_ = _e2121;
                        phi_1137_ = _e1666;
                    } else {
                        phi_1134_ = lt_bvh_Hit();
                        phi_1137_ = u32();
                    }
                    let _e1668 = phi_1134_;
                    let _e1670 = phi_1137_;
                    continue;
                    continuing {
                        phi_1133_ = _e1668;
                        phi_1136_ = _e1670;
                        break if !(_e566);
                    }
                }
                let _e2125 = local_9;
                phi_2274_ = _e2125;
            }
            let _e1673 = phi_2274_;
            phi_2275_ = _e1673;
            phi_2276_ = _e220;
        } else {
            phi_2275_ = lt_bvh_Hit();
            phi_2276_ = true;
        }
        let _e1675 = phi_2275_;
        let _e1677 = phi_2276_;
        if _e1677 {
            phi_2280_ = _e150;
        } else {
            phi_2280_ = _e1675;
        }
        let _e1679 = phi_2280_;
        if (_e1679.triangle != 4294967295u) {
            let _e1684 = lt_shaders_surface_barycentric_weights(_e1679.u, _e1679.v);
            if (_e1679.triangle < _e75) {
            } else {
                return;
            }
            let _e1689 = triangles.member[(0u + _e1679.triangle)];
            let _e1717 = (((_e1689.v0_.x * _e1684.x) + (_e1689.v1_.x * _e1684.y)) + (_e1689.v2_.x * _e1684.z));
            let _e1718 = (((_e1689.v0_.y * _e1684.x) + (_e1689.v1_.y * _e1684.y)) + (_e1689.v2_.y * _e1684.z));
            let _e1719 = (((_e1689.v0_.z * _e1684.x) + (_e1689.v1_.z * _e1684.y)) + (_e1689.v2_.z * _e1684.z));
            let _e1722 = abs(_e1689.v0_.x);
            let _e1724 = abs(_e1689.v0_.y);
            let _e1726 = abs(_e1689.v0_.z);
            let _e1728 = abs(_e1689.v1_.x);
            let _e1730 = abs(_e1689.v1_.y);
            let _e1732 = abs(_e1689.v1_.z);
            if (_e1722 > _e1728) {
                phi_2346_ = _e1722;
            } else {
                phi_2346_ = _e1728;
            }
            let _e1735 = phi_2346_;
            if (_e1724 > _e1730) {
                phi_2351_ = _e1724;
            } else {
                phi_2351_ = _e1730;
            }
            let _e1738 = phi_2351_;
            if (_e1726 > _e1732) {
                phi_2356_ = _e1726;
            } else {
                phi_2356_ = _e1732;
            }
            let _e1741 = phi_2356_;
            let _e1743 = abs(_e1689.v2_.x);
            let _e1745 = abs(_e1689.v2_.y);
            let _e1747 = abs(_e1689.v2_.z);
            if (_e1735 > _e1743) {
                phi_2367_ = _e1735;
            } else {
                phi_2367_ = _e1743;
            }
            let _e1750 = phi_2367_;
            if (_e1738 > _e1745) {
                phi_2372_ = _e1738;
            } else {
                phi_2372_ = _e1745;
            }
            let _e1753 = phi_2372_;
            if (_e1741 > _e1747) {
                phi_2377_ = _e1741;
            } else {
                phi_2377_ = _e1747;
            }
            let _e1756 = phi_2377_;
            let _e1759 = (_e1689.v1_.x - _e1689.v0_.x);
            let _e1762 = (_e1689.v1_.y - _e1689.v0_.y);
            let _e1765 = (_e1689.v1_.z - _e1689.v0_.z);
            let _e1768 = (_e1689.v2_.x - _e1689.v0_.x);
            let _e1771 = (_e1689.v2_.y - _e1689.v0_.y);
            let _e1774 = (_e1689.v2_.z - _e1689.v0_.z);
            let _e1778 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1762), abs(_e1765));
            let _e1779 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1759), _e1778);
            let _e1780 = (_e1759 / _e1779);
            let _e1781 = (_e1762 / _e1779);
            let _e1782 = (_e1765 / _e1779);
            let _e1786 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1771), abs(_e1774));
            let _e1787 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1768), _e1786);
            let _e1788 = (_e1768 / _e1787);
            let _e1789 = (_e1771 / _e1787);
            let _e1790 = (_e1774 / _e1787);
            let _e1793 = ((_e1781 * _e1790) - (_e1789 * _e1782));
            let _e1796 = ((_e1782 * _e1788) - (_e1790 * _e1780));
            let _e1799 = ((_e1780 * _e1789) - (_e1788 * _e1781));
            let _e1801 = p.member.eye;
            let _e1810 = (1f / sqrt((((_e1793 * _e1793) + (_e1796 * _e1796)) + (_e1799 * _e1799))));
            let _e1815 = lt_shaders_camera_facing(vec3<f32>((_e1793 * _e1810), (_e1796 * _e1810), (_e1799 * _e1810)), (_e1801 - vec3<f32>(_e1717, _e1718, _e1719)));
            if (_e1679.triangle < _e75) {
            } else {
                return;
            }
            let _e1820 = triangles.member[(0u + _e1679.triangle)];
            let _e1822 = (_e1820.i0_ & 2147483647u);
            if (_e1822 < _e78) {
            } else {
                return;
            }
            let _e1828 = vertices.member[(0u + _e1822)];
            if (_e1820.i1_ < _e78) {
            } else {
                return;
            }
            let _e1832 = vertices.member[(0u + _e1820.i1_)];
            if (_e1820.i2_ < _e78) {
            } else {
                return;
            }
            let _e1836 = vertices.member[(0u + _e1820.i2_)];
            let _e1837 = array<abi_Vertex, 3>(_e1828, _e1832, _e1836);
            local = array<abi_Vertex, 3>(abi_Vertex(_e1837[0].u, _e1837[0].v, _e1837[0].normal, _e1837[0].color, _e1837[0].material), abi_Vertex(_e1837[1].u, _e1837[1].v, _e1837[1].normal, _e1837[1].color, _e1837[1].material), abi_Vertex(_e1837[2].u, _e1837[2].v, _e1837[2].normal, _e1837[2].color, _e1837[2].material));
            let _e1862 = local[0u].material;
            if (_e1862 < _e81) {
            } else {
                return;
            }
            let _e1866 = materials.member[(0u + _e1862)];
            local_1 = abi_Material(_e1866.base_color, _e1866.cutoff, _e1866.flags, _e1866.alpha_offset, _e1866.alpha_size, _e1866.color_offset, _e1866.color_size, _e1866.pad);
            let _e1876 = lt_shaders_surface_plain_color((&local_1), (&local), _e1684);
            let _e1877 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(_e1684);
            let _e1879 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1753, _e1756);
            let _e1880 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1750, _e1879);
            let _e1882 = local_1.flags;
            if ((_e1882 & 2u) == 0u) {
                phi_2525_ = 0u;
            } else {
                phi_2525_ = 1u;
            }
            let _e1886 = phi_2525_;
            let _e1889 = local[0u].normal;
            if (_e1889 == 2147516416u) {
                phi_2592_ = _e1815;
            } else {
                let _e1893 = local[0u].normal;
                let _e1894 = lt_shaders_surface_octahedral_decode(_e1893);
                let _e1904 = local[1u].normal;
                let _e1905 = lt_shaders_surface_octahedral_decode(_e1904);
                let _e1918 = local[2u].normal;
                let _e1919 = lt_shaders_surface_octahedral_decode(_e1918);
                let _e1931 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>((((_e1894.x * _e1684.x) + (_e1905.x * _e1684.y)) + (_e1919.x * _e1684.z)), (((_e1894.y * _e1684.x) + (_e1905.y * _e1684.y)) + (_e1919.y * _e1684.z)), (((_e1894.z * _e1684.x) + (_e1905.z * _e1684.y)) + (_e1919.z * _e1684.z))));
                let _e1943 = sqrt((((_e1931.x * _e1931.x) + (_e1931.y * _e1931.y)) + (_e1931.z * _e1931.z)));
                if (_e1943 > 0f) {
                    let _e1947 = lt_shaders_camera_facing((_e1931 / vec3(_e1943)), _e1815);
                    phi_2591_ = _e1947;
                } else {
                    phi_2591_ = _e1815;
                }
                let _e1949 = phi_2591_;
                phi_2592_ = _e1949;
            }
            let _e1951 = phi_2592_;
            let _e1952 = lt_shaders_shade_pack_albedo((_e1876 * _e1877));
            phi_2596_ = abi_Sample(vec3<f32>(_e1717, _e1718, _e1719), _e1880, _e1815, _e1886, _e1951, _e1952);
        } else {
            phi_2596_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e1956 = phi_2596_;
        if (_e93.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e93.first_primitive)] = _e1956;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
