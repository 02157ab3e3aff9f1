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

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_44 {
    member: array<abi_Sample>,
}

struct type_48 {
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

struct type_59 {
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

struct type_66 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_44;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(7) 
var<storage> alpha_texels: type_22;
@group(0) @binding(0) 
var<uniform> p: type_66;
@group(0) @binding(2) 
var<storage> nodes: type_59;
@group(0) @binding(3) 
var<storage> triangles: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_48;
@group(0) @binding(5) 
var<storage> vertices: type_13;
@group(0) @binding(6) 
var<storage> materials: type_18;

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
    var phi_475_: f32;
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_486_: f32;
    var phi_487_: f32;

    if (param_6 == 0u) {
        phi_477_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e73 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e73 > 1f) {
                phi_475_ = (2f - _e73);
            } else {
                phi_475_ = _e73;
            }
            let _e77 = phi_475_;
            phi_476_ = _e77;
        } else {
            phi_476_ = param_5;
        }
        let _e79 = phi_476_;
        phi_477_ = _e79;
    }
    let _e81 = phi_477_;
    if (_e81 > 0f) {
        if (_e81 < 1f) {
            phi_486_ = _e81;
        } else {
            phi_486_ = 1f;
        }
        let _e85 = phi_486_;
        phi_487_ = _e85;
    } else {
        phi_487_ = 0f;
    }
    let _e87 = phi_487_;
    return _e87;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_413_: u32;
    var phi_427_: u32;
    var phi_434_: u32;
    var phi_439_: u32;
    var phi_445_: u32;
    var phi_450_: u32;
    var phi_452_: texture_Axis;

    let _e68 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e69 = (param_8 - 1u);
    let _e71 = (_e68 * f32(param_8));
    if param_10 {
        let _e78 = select(select(u32(_e71), 0u, (_e71 < bitcast<f32>(0u))), 4294967295u, (_e71 > bitcast<f32>(1333788671u)));
        if (_e69 < _e78) {
            phi_413_ = _e69;
        } else {
            phi_413_ = _e78;
        }
        let _e81 = phi_413_;
        phi_452_ = texture_Axis(_e81, _e81, 0f);
    } else {
        let _e83 = (_e71 + 0.5f);
        let _e90 = select(select(u32(_e83), 0u, (_e83 < bitcast<f32>(0u))), 4294967295u, (_e83 > bitcast<f32>(1333788671u)));
        if (param_8 < _e90) {
            phi_427_ = param_8;
        } else {
            phi_427_ = _e90;
        }
        let _e93 = phi_427_;
        if (param_9 == 0u) {
            phi_434_ = _e69;
        } else {
            phi_434_ = 0u;
        }
        let _e98 = phi_434_;
        if (param_9 == 0u) {
            phi_439_ = 0u;
        } else {
            phi_439_ = _e69;
        }
        let _e101 = phi_439_;
        if (_e93 == 0u) {
            phi_445_ = _e98;
        } else {
            phi_445_ = (_e93 - 1u);
        }
        let _e105 = phi_445_;
        if (_e93 > _e69) {
            phi_450_ = _e101;
        } else {
            phi_450_ = _e93;
        }
        let _e108 = phi_450_;
        phi_452_ = texture_Axis(_e105, _e108, (_e83 - f32(_e93)));
    }
    let _e111 = phi_452_;
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
    var phi_507_: lt_bvh_traverse_Tree;
    var phi_508_: bool;
    var phi_509_: lt_bvh_traverse_Tree;
    var phi_510_: bool;
    var phi_515_: lt_bvh_traverse_Tree;

    if (param_14.x < param_15) {
        if (param_14.y < param_16) {
            phi_507_ = lt_bvh_traverse_Tree(1u, ((param_14.y * param_15) + param_14.x));
            phi_508_ = false;
        } else {
            phi_507_ = lt_bvh_traverse_Tree();
            phi_508_ = true;
        }
        let _e77 = phi_507_;
        let _e79 = phi_508_;
        phi_509_ = _e77;
        phi_510_ = _e79;
    } else {
        phi_509_ = lt_bvh_traverse_Tree();
        phi_510_ = true;
    }
    let _e81 = phi_509_;
    let _e83 = phi_510_;
    if _e83 {
        phi_515_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_515_ = _e81;
    }
    let _e88 = phi_515_;
    return lt_bvh_traverse_Tree(_e88.root, _e88.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_17: f32, param_18: f32) -> f32 {
    var phi_530_: bool;
    var phi_534_: f32;

    if (param_17 != param_17) {
        phi_530_ = true;
    } else {
        let _e67 = (param_18 >= param_17);
        if _e67 {
        }
        phi_530_ = _e67;
    }
    let _e69 = phi_530_;
    if _e69 {
        phi_534_ = param_18;
    } else {
        phi_534_ = param_17;
    }
    let _e71 = phi_534_;
    return _e71;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_19: f32, param_20: f32) -> f32 {
    var phi_546_: bool;
    var phi_550_: f32;

    if (param_19 != param_19) {
        phi_546_ = true;
    } else {
        let _e67 = (param_20 <= param_19);
        if _e67 {
        }
        phi_546_ = _e67;
    }
    let _e69 = phi_546_;
    if _e69 {
        phi_550_ = param_20;
    } else {
        phi_550_ = param_19;
    }
    let _e71 = phi_550_;
    return _e71;
}

fn lt_shaders_surface_barycentric_weights(param_21: f32, param_22: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_21) - param_22), param_21, param_22);
}

fn lt_shaders_evaluate_to_light(param_23: vec3<f32>, param_24: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_24.x - (param_23.x * param_24.w)), (param_24.y - (param_23.y * param_24.w)), (param_24.z - (param_23.z * param_24.w)));
}

fn _lt_shaders_abi_Sample_is_valid(param_25: ptr<function, abi_Sample>) -> bool {
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_630_: bool;

    let _e67 = (*param_25).normal[0u];
    let _e69 = global[0u];
    if (_e67 == _e69) {
        let _e72 = (*param_25).normal[1u];
        let _e74 = global[1u];
        if (_e72 == _e74) {
            let _e77 = (*param_25).normal[2u];
            let _e79 = global[2u];
            phi_623_ = (_e77 == _e79);
            phi_624_ = false;
        } else {
            phi_623_ = bool();
            phi_624_ = true;
        }
        let _e82 = phi_623_;
        let _e84 = phi_624_;
        phi_625_ = _e82;
        phi_626_ = _e84;
    } else {
        phi_625_ = bool();
        phi_626_ = true;
    }
    let _e86 = phi_625_;
    let _e88 = phi_626_;
    if _e88 {
        phi_630_ = false;
    } else {
        phi_630_ = _e86;
    }
    let _e90 = phi_630_;
    return !(_e90);
}

fn lt_shaders_evaluate_settle(param_26: ptr<function, abi_Sample>, param_27: vec4<f32>) -> u0028_evaluate_Verdict_u0020_bool_u0029_ {
    var phi_594_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_598_: u0028_evaluate_Verdict_u0020_bool_u0029_;

    let _e66 = _lt_shaders_abi_Sample_is_valid(param_26);
    if _e66 {
        let _e68 = (*param_26).normal;
        let _e70 = (*param_26).position;
        let _e71 = lt_shaders_evaluate_to_light(_e70, param_27);
        if ((((_e68.x * _e71.x) + (_e68.y * _e71.y)) + (_e68.z * _e71.z)) > 0f) {
            let _e85 = (*param_26).flags;
            let _e93 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e99 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e93.unnamed.visibility, false), _e93.unnamed_1);
            phi_594_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e99.unnamed, ((_e85 & 1u) == 0u));
        } else {
            let _e108 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e114 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e108.unnamed.visibility, false), _e108.unnamed_1);
            phi_594_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e114.unnamed, true);
        }
        let _e119 = phi_594_;
        phi_598_ = _e119;
    } else {
        let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
        let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
        phi_598_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
    }
    let _e136 = phi_598_;
    return _e136;
}

fn lt_shaders_resolve_shadow_ray(param_28: ptr<function, abi_Sample>, param_29: vec4<f32>) -> lt_bvh_Ray {
    var phi_673_: f32;

    let _e67 = (*param_28).position;
    let _e69 = (*param_28).normal;
    let _e71 = (*param_28).magnitude;
    let _e73 = ((8f / 8388608f) * _e71);
    let _e81 = (_e67 + vec3<f32>((_e69.x * _e73), (_e69.y * _e73), (_e69.z * _e73)));
    if (param_29.w == 0f) {
        phi_673_ = 300000000000000000000000000000000000000f;
    } else {
        phi_673_ = 1f;
    }
    let _e85 = phi_673_;
    let _e86 = lt_shaders_evaluate_to_light(_e81, param_29);
    return lt_bvh_Ray(_e81, 0f, _e86, _e85);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: abi_Sample;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_826_: bool;
    var phi_830_: bool;
    var phi_905_: f32;
    var phi_912_: f32;
    var phi_920_: f32;
    var phi_927_: f32;
    var phi_935_: f32;
    var phi_942_: f32;
    var phi_967_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1019_: u32;
    var phi_1020_: u32;
    var phi_1038_: vec3<f32>;
    var phi_1039_: vec3<f32>;
    var phi_1053_: u32;
    var phi_1058_: u32;
    var phi_1063_: u32;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1209_: u32;
    var phi_1211_: u32;
    var phi_1297_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1324_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1351_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1357_: u32;
    var phi_1360_: u32;
    var phi_1374_: u32;
    var phi_1384_: u32;
    var phi_1394_: u32;
    var phi_1412_: u32;
    var phi_1422_: u32;
    var phi_1432_: u32;
    var phi_1468_: u32;
    var phi_1481_: u32;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1358_: u32;
    var phi_1361_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1546_: u32;
    var phi_1593_: vec3<f32>;
    var phi_1594_: vec3<f32>;
    var phi_1627_: vec3<f32>;
    var phi_1628_: vec3<f32>;
    var phi_1661_: vec3<f32>;
    var phi_1662_: vec3<f32>;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: f32;
    var phi_1688_: f32;
    var phi_1689_: f32;
    var phi_1690_: f32;
    var phi_1698_: f32;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1713_: f32;
    var phi_1714_: f32;
    var phi_1715_: f32;
    var phi_1716_: f32;
    var phi_1724_: f32;
    var phi_1734_: bool;
    var phi_1735_: bool;
    var phi_1739_: f32;
    var phi_1740_: f32;
    var phi_1741_: f32;
    var phi_1742_: f32;
    var phi_1750_: f32;
    var phi_1765_: f32;
    var phi_1766_: bool;
    var phi_1767_: f32;
    var phi_1768_: bool;
    var phi_1769_: f32;
    var phi_1770_: bool;
    var phi_1788_: f32;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var phi_1791_: f32;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1797_: bool;
    var phi_1798_: f32;
    var phi_1799_: bool;
    var phi_1825_: f32;
    var phi_1834_: f32;
    var phi_1843_: f32;
    var phi_1852_: f32;
    var phi_1859_: f32;
    var phi_1866_: f32;
    var phi_1879_: f32;
    var phi_1888_: f32;
    var phi_1897_: f32;
    var phi_1906_: f32;
    var phi_1913_: f32;
    var phi_1920_: f32;
    var phi_1943_: f32;
    var phi_1948_: f32;
    var phi_1953_: f32;
    var phi_1961_: f32;
    var phi_1966_: f32;
    var phi_1971_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_1998_: f32;
    var phi_2003_: lt_bvh_triangle_Intersection;
    var phi_2004_: lt_bvh_triangle_Intersection;
    var phi_2005_: bool;
    var phi_2009_: lt_bvh_triangle_Intersection;
    var phi_2220_: f32;
    var phi_2223_: bool;
    var phi_2224_: bool;
    var phi_2228_: bool;
    var phi_2229_: bool;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_1547_: u32;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var local_7: bool;
    var phi_2289_: bool;
    var phi_2290_: bool;
    var phi_2321_: u32;
    var phi_2322_: u32;
    var phi_2323_: bool;
    var phi_2324_: bool;
    var phi_1212_: u32;
    var phi_2325_: bool;
    var phi_2326_: bool;
    var phi_2327_: bool;
    var phi_2328_: bool;
    var local_8: bool;
    var phi_2332_: bool;
    var phi_2333_: bool;
    var phi_2337_: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var phi_2343_: bool;
    var phi_2344_: bool;
    var phi_2348_: bool;
    var phi_2352_: f32;
    var phi_2353_: f32;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;

    let _e68 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e90 = arrayLength((&alpha_texels.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e68, _e93, _e95);
    if (bitcast<i32>(_e96.root) != 0i) {
        if (_e96.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e104 = samples.member[(0u + _e96.first_primitive)];
        local_3 = abi_Sample(_e104.position, _e104.magnitude, _e104.normal, _e104.flags, _e104.shading_normal, _e104.albedo);
        let _e113 = p.member.light;
        let _e114 = lt_shaders_evaluate_settle((&local_3), _e113);
        if _e114.unnamed_1 {
            phi_2353_ = _e114.unnamed.visibility;
        } else {
            let _e119 = p.member.light;
            let _e120 = lt_shaders_resolve_shadow_ray((&local_3), _e119);
            let _e130 = abs(_e120.direction.x);
            let _e132 = abs(_e120.direction.y);
            let _e134 = abs(_e120.direction.z);
            if (abs(_e120.origin.x) < 1000000000000000f) {
                if (abs(_e120.origin.y) < 1000000000000000f) {
                    if (abs(_e120.origin.z) < 1000000000000000f) {
                        if (_e130 < 1000000000000000f) {
                            if (_e132 < 1000000000000000f) {
                                if (_e134 < 1000000000000000f) {
                                    if (_e130 > 0f) {
                                        phi_800_ = bool();
                                        phi_801_ = true;
                                    } else {
                                        let _e142 = (_e132 > 0f);
                                        if _e142 {
                                            phi_799_ = bool();
                                        } else {
                                            phi_799_ = (_e134 > 0f);
                                        }
                                        let _e145 = phi_799_;
                                        phi_800_ = _e145;
                                        phi_801_ = _e142;
                                    }
                                    let _e147 = phi_800_;
                                    let _e149 = phi_801_;
                                    if _e149 {
                                        phi_805_ = true;
                                    } else {
                                        phi_805_ = _e147;
                                    }
                                    let _e151 = phi_805_;
                                    phi_806_ = _e151;
                                    phi_807_ = false;
                                } else {
                                    phi_806_ = bool();
                                    phi_807_ = true;
                                }
                                let _e153 = phi_806_;
                                let _e155 = phi_807_;
                                phi_808_ = _e153;
                                phi_809_ = false;
                                phi_810_ = _e155;
                            } else {
                                phi_808_ = bool();
                                phi_809_ = true;
                                phi_810_ = false;
                            }
                            let _e157 = phi_808_;
                            let _e159 = phi_809_;
                            let _e161 = phi_810_;
                            phi_811_ = _e157;
                            phi_812_ = _e159;
                            phi_813_ = _e161;
                        } else {
                            phi_811_ = bool();
                            phi_812_ = true;
                            phi_813_ = false;
                        }
                        let _e163 = phi_811_;
                        let _e165 = phi_812_;
                        let _e167 = phi_813_;
                        phi_814_ = _e163;
                        phi_815_ = _e165;
                        phi_816_ = _e167;
                    } else {
                        phi_814_ = bool();
                        phi_815_ = true;
                        phi_816_ = false;
                    }
                    let _e169 = phi_814_;
                    let _e171 = phi_815_;
                    let _e173 = phi_816_;
                    phi_817_ = _e169;
                    phi_818_ = _e171;
                    phi_819_ = _e173;
                } else {
                    phi_817_ = bool();
                    phi_818_ = true;
                    phi_819_ = false;
                }
                let _e175 = phi_817_;
                let _e177 = phi_818_;
                let _e179 = phi_819_;
                phi_820_ = _e175;
                phi_821_ = _e177;
                phi_822_ = _e179;
            } else {
                phi_820_ = bool();
                phi_821_ = true;
                phi_822_ = false;
            }
            let _e181 = phi_820_;
            let _e183 = phi_821_;
            let _e185 = phi_822_;
            if _e183 {
                phi_826_ = true;
            } else {
                phi_826_ = _e185;
            }
            let _e187 = phi_826_;
            if _e187 {
                phi_830_ = false;
            } else {
                phi_830_ = _e181;
            }
            let _e189 = phi_830_;
            if _e189 {
                let _e190 = (0u >= _e75);
                if _e190 {
                    phi_2342_ = bool();
                } else {
                    if (0u < _e75) {
                    } else {
                        return;
                    }
                    let _e196 = nodes.member[(0u + 0u)].frame[0u];
                    let _e200 = nodes.member[(0u + 0u)].frame[1u];
                    let _e204 = nodes.member[(0u + 0u)].frame[2u];
                    let _e208 = nodes.member[(0u + 0u)].frame[0u];
                    let _e212 = nodes.member[(0u + 0u)].frame[1u];
                    let _e216 = nodes.member[(0u + 0u)].frame[2u];
                    let _e220 = nodes.member[(0u + 0u)].frame[3u];
                    let _e258 = core_intrinsics_maximum_number_nsz_f32_(abs(_e120.direction.x), abs(_e120.direction.y));
                    let _e259 = core_intrinsics_maximum_number_nsz_f32_(_e258, abs(_e120.direction.z));
                    let _e260 = (_e259 * 0.0000000000009094947f);
                    if (abs(_e120.direction.x) < _e260) {
                        phi_905_ = _e260;
                    } else {
                        phi_905_ = abs(_e120.direction.x);
                    }
                    let _e267 = phi_905_;
                    if (_e120.direction.x < 0f) {
                        phi_912_ = (-1f / _e267);
                    } else {
                        phi_912_ = (1f / _e267);
                    }
                    let _e272 = phi_912_;
                    if (abs(_e120.direction.y) < _e260) {
                        phi_920_ = _e260;
                    } else {
                        phi_920_ = abs(_e120.direction.y);
                    }
                    let _e279 = phi_920_;
                    if (_e120.direction.y < 0f) {
                        phi_927_ = (-1f / _e279);
                    } else {
                        phi_927_ = (1f / _e279);
                    }
                    let _e284 = phi_927_;
                    if (abs(_e120.direction.z) < _e260) {
                        phi_935_ = _e260;
                    } else {
                        phi_935_ = abs(_e120.direction.z);
                    }
                    let _e291 = phi_935_;
                    if (_e120.direction.z < 0f) {
                        phi_942_ = (-1f / _e291);
                    } else {
                        phi_942_ = (1f / _e291);
                    }
                    let _e296 = phi_942_;
                    let _e304 = abs((bitcast<f32>(_e196) - _e120.origin.x));
                    let _e305 = abs((bitcast<f32>(_e200) - _e120.origin.y));
                    let _e306 = abs((bitcast<f32>(_e204) - _e120.origin.z));
                    let _e314 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e220 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120.origin.x));
                    let _e315 = abs(((bitcast<f32>(_e212) + (bitcast<f32>((((_e220 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120.origin.y));
                    let _e316 = abs(((bitcast<f32>(_e216) + (bitcast<f32>((((_e220 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120.origin.z));
                    if (_e304 > _e314) {
                        phi_967_ = _e304;
                    } else {
                        phi_967_ = _e314;
                    }
                    let _e319 = phi_967_;
                    if (_e305 > _e315) {
                        phi_972_ = _e305;
                    } else {
                        phi_972_ = _e315;
                    }
                    let _e322 = phi_972_;
                    if (_e306 > _e316) {
                        phi_977_ = _e306;
                    } else {
                        phi_977_ = _e316;
                    }
                    let _e325 = phi_977_;
                    let _e326 = core_intrinsics_maximum_number_nsz_f32_(_e319, _e322);
                    let _e327 = core_intrinsics_maximum_number_nsz_f32_(_e326, _e325);
                    let _e332 = (_e327 * 0.0000019073486f);
                    let _e333 = (abs(_e272) * _e332);
                    let _e334 = (abs(_e284) * _e332);
                    let _e335 = (abs(_e296) * _e332);
                    let _e339 = (_e327 * 0.0000009536743f);
                    let _e340 = (abs(_e272) * _e339);
                    let _e341 = (abs(_e284) * _e339);
                    let _e342 = (abs(_e296) * _e339);
                    let _e345 = abs(_e120.direction.x);
                    let _e347 = abs(_e120.direction.y);
                    let _e349 = abs(_e120.direction.z);
                    if (_e345 >= _e347) {
                        if (_e345 >= _e349) {
                            phi_1010_ = false;
                        } else {
                            phi_1010_ = true;
                        }
                        let _e353 = phi_1010_;
                        phi_1011_ = _e353;
                    } else {
                        phi_1011_ = true;
                    }
                    let _e355 = phi_1011_;
                    if _e355 {
                        if (_e347 >= _e349) {
                            phi_1019_ = 1u;
                        } else {
                            phi_1019_ = 2u;
                        }
                        let _e358 = phi_1019_;
                        phi_1020_ = _e358;
                    } else {
                        phi_1020_ = 0u;
                    }
                    let _e360 = phi_1020_;
                    if (_e360 == 0u) {
                        phi_1039_ = vec3<f32>(_e120.direction.y, _e120.direction.z, _e120.direction.x);
                    } else {
                        if (_e360 == 1u) {
                            phi_1038_ = vec3<f32>(_e120.direction.z, _e120.direction.x, _e120.direction.y);
                        } else {
                            phi_1038_ = _e120.direction;
                        }
                        let _e373 = phi_1038_;
                        phi_1039_ = _e373;
                    }
                    let _e375 = phi_1039_;
                    let _e379 = (_e375.x / _e375.z);
                    let _e382 = (_e375.y / _e375.z);
                    let _e384 = (1f / _e375.z);
                    if (_e272 < 0f) {
                        phi_1053_ = 0u;
                    } else {
                        phi_1053_ = 1u;
                    }
                    let _e387 = phi_1053_;
                    if (_e284 < 0f) {
                        phi_1058_ = 0u;
                    } else {
                        phi_1058_ = 2u;
                    }
                    let _e390 = phi_1058_;
                    if (_e296 < 0f) {
                        phi_1063_ = 0u;
                    } else {
                        phi_1063_ = 4u;
                    }
                    let _e393 = phi_1063_;
                    let _e395 = ((_e387 | _e390) | _e393);
                    let _e396 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e396.first[0], _e396.first[1], _e396.first[2], _e396.first[3], _e396.first[4], _e396.first[5], _e396.first[6], _e396.first[7], _e396.first[8], _e396.first[9], _e396.first[10], _e396.first[11], _e396.first[12], _e396.first[13], _e396.first[14], _e396.first[15], _e396.first[16], _e396.first[17], _e396.first[18], _e396.first[19], _e396.first[20], _e396.first[21], _e396.first[22], _e396.first[23], _e396.first[24], _e396.first[25], _e396.first[26], _e396.first[27], _e396.first[28], _e396.first[29], _e396.first[30], _e396.first[31]), array<u32, 32>(_e396.mask[0], _e396.mask[1], _e396.mask[2], _e396.mask[3], _e396.mask[4], _e396.mask[5], _e396.mask[6], _e396.mask[7], _e396.mask[8], _e396.mask[9], _e396.mask[10], _e396.mask[11], _e396.mask[12], _e396.mask[13], _e396.mask[14], _e396.mask[15], _e396.mask[16], _e396.mask[17], _e396.mask[18], _e396.mask[19], _e396.mask[20], _e396.mask[21], _e396.mask[22], _e396.mask[23], _e396.mask[24], _e396.mask[25], _e396.mask[26], _e396.mask[27], _e396.mask[28], _e396.mask[29], _e396.mask[30], _e396.mask[31]), _e396.len, _e396.group, _e396.group_mask);
                    let _e470 = local_2.group_mask;
                    if ((_e470 & 4278190080u) == 0u) {
                        let _e474 = local_2.len;
                        if (_e474 == 0u) {
                            phi_1177_ = false;
                        } else {
                            let _e478 = local_2.len;
                            local_2.len = (_e478 - 1u);
                            let _e481 = local_2.len;
                            if (_e481 < 32u) {
                            } else {
                                return;
                            }
                            let _e486 = local_2.first[(0u + _e481)];
                            local_2.group = _e486;
                            let _e489 = local_2.len;
                            if (_e489 < 32u) {
                            } else {
                                return;
                            }
                            let _e494 = local_2.mask[(0u + _e489)];
                            local_2.group_mask = _e494;
                            phi_1177_ = true;
                        }
                        let _e497 = phi_1177_;
                        phi_1178_ = _e497;
                    } else {
                        phi_1178_ = true;
                    }
                    let _e499 = phi_1178_;
                    if _e499 {
                        let _e501 = local_2.group_mask;
                        let _e507 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, (_e501 == 0u)));
                        let _e511 = local_2.group_mask;
                        let _e525 = local_2.group_mask;
                        local_2.group_mask = (_e525 & ~((1u << bitcast<u32>((_e507 & 31u)))));
                        let _e528 = local_2.group;
                        phi_1209_ = (_e528 + countOneBits(((_e511 & ~((4294967295u << bitcast<u32>((((_e507 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1209_ = 4294967295u;
                    }
                    let _e531 = phi_1209_;
                    phi_1211_ = _e531;
                    loop {
                        let _e533 = phi_1211_;
                        if (_e533 != 4294967295u) {
                            if (_e533 < _e75) {
                            } else {
                                return;
                            }
                            let _e542 = nodes.member[(0u + _e533)].frame[3u];
                            let _e567 = (bitcast<f32>((((_e542 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e272);
                            let _e568 = (bitcast<f32>((((_e542 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                            let _e569 = (bitcast<f32>((((_e542 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e296);
                            let _e572 = nodes.member[(0u + _e533)].frame[0u];
                            let _e576 = nodes.member[(0u + _e533)].frame[1u];
                            let _e580 = nodes.member[(0u + _e533)].frame[2u];
                            let _e588 = ((bitcast<f32>(_e572) - _e120.origin.x) * _e272);
                            let _e589 = ((bitcast<f32>(_e576) - _e120.origin.y) * _e284);
                            let _e590 = ((bitcast<f32>(_e580) - _e120.origin.z) * _e296);
                            let _e598 = nodes.member[(0u + _e533)].x;
                            if (_e272 < 0f) {
                                let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e609.unnamed.root, _e598.w), _e609.unnamed_1);
                                let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e615.unnamed, lt_bvh_traverse_Tree(_e598.x, _e615.unnamed_1.first_primitive));
                                phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_bvh_traverse_Tree(_e621.unnamed_1.root, _e598.y));
                            } else {
                                let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e637.unnamed.root, _e598.y), _e637.unnamed_1);
                                let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e643.unnamed, lt_bvh_traverse_Tree(_e598.z, _e643.unnamed_1.first_primitive));
                                phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e649.unnamed_1.root, _e598.w));
                            }
                            let _e657 = phi_1297_;
                            let _e667 = nodes.member[(0u + _e533)].y;
                            if (_e284 < 0f) {
                                let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e678.unnamed.root, _e667.w), _e678.unnamed_1);
                                let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_bvh_traverse_Tree(_e667.x, _e684.unnamed_1.first_primitive));
                                phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e690.unnamed_1.root, _e667.y));
                            } else {
                                let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e706.unnamed.root, _e667.y), _e706.unnamed_1);
                                let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_bvh_traverse_Tree(_e667.z, _e712.unnamed_1.first_primitive));
                                phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e718.unnamed_1.root, _e667.w));
                            }
                            let _e726 = phi_1324_;
                            let _e736 = nodes.member[(0u + _e533)].z;
                            if (_e296 < 0f) {
                                let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e747.unnamed.root, _e736.w), _e747.unnamed_1);
                                let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e753.unnamed, lt_bvh_traverse_Tree(_e736.x, _e753.unnamed_1.first_primitive));
                                phi_1351_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_bvh_traverse_Tree(_e759.unnamed_1.root, _e736.y));
                            } else {
                                let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e775.unnamed.root, _e736.y), _e775.unnamed_1);
                                let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e781.unnamed, lt_bvh_traverse_Tree(_e736.z, _e781.unnamed_1.first_primitive));
                                phi_1351_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e787.unnamed, lt_bvh_traverse_Tree(_e787.unnamed_1.root, _e736.w));
                            }
                            let _e795 = phi_1351_;
                            phi_1357_ = 0u;
                            phi_1360_ = 0u;
                            loop {
                                let _e805 = phi_1357_;
                                let _e807 = phi_1360_;
                                local_4 = _e807;
                                local_5 = _e807;
                                local_6 = _e807;
                                let _e808 = (_e805 < 8u);
                                if _e808 {
                                    let _e810 = (_e805 >> bitcast<u32>(2i));
                                    let _e811 = (_e805 & 3u);
                                    if (_e810 == 0u) {
                                        phi_1374_ = _e657.unnamed.root;
                                    } else {
                                        phi_1374_ = _e657.unnamed.first_primitive;
                                    }
                                    let _e814 = phi_1374_;
                                    if (_e810 == 0u) {
                                        phi_1384_ = _e726.unnamed.root;
                                    } else {
                                        phi_1384_ = _e726.unnamed.first_primitive;
                                    }
                                    let _e823 = phi_1384_;
                                    if (_e810 == 0u) {
                                        phi_1394_ = _e795.unnamed.root;
                                    } else {
                                        phi_1394_ = _e795.unnamed.first_primitive;
                                    }
                                    let _e832 = phi_1394_;
                                    let _e845 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e814 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u)) * _e567) + (_e588 - _e333)), ((f32(((_e823 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u)) * _e568) + (_e589 - _e334)));
                                    let _e846 = core_intrinsics_maximum_number_nsz_f32_(_e845, ((f32(((_e832 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u)) * _e569) + (_e590 - _e335)));
                                    if (_e810 == 0u) {
                                        phi_1412_ = _e657.unnamed_1.root;
                                    } else {
                                        phi_1412_ = _e657.unnamed_1.first_primitive;
                                    }
                                    let _e849 = phi_1412_;
                                    if (_e810 == 0u) {
                                        phi_1422_ = _e726.unnamed_1.root;
                                    } else {
                                        phi_1422_ = _e726.unnamed_1.first_primitive;
                                    }
                                    let _e858 = phi_1422_;
                                    if (_e810 == 0u) {
                                        phi_1432_ = _e795.unnamed_1.root;
                                    } else {
                                        phi_1432_ = _e795.unnamed_1.first_primitive;
                                    }
                                    let _e867 = phi_1432_;
                                    let _e880 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e849 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u)) * _e567) + (_e588 + _e333)), ((f32(((_e858 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u)) * _e568) + (_e589 + _e334)));
                                    let _e881 = core_intrinsics_minimum_number_nsz_f32_(_e880, ((f32(((_e867 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u)) * _e569) + (_e590 + _e335)));
                                    if (_e846 <= _e881) {
                                        if (_e846 <= _e120.tmax) {
                                            if (_e881 >= _e120.tmin) {
                                                if (_e810 == 0u) {
                                                    let _e888 = nodes.member[(0u + _e533)].links[2u];
                                                    phi_1468_ = _e888;
                                                } else {
                                                    let _e891 = nodes.member[(0u + _e533)].links[3u];
                                                    phi_1468_ = _e891;
                                                }
                                                let _e893 = phi_1468_;
                                                let _e898 = ((_e893 >> bitcast<u32>(((_e811 * 8u) & 31u))) & 255u);
                                                let _e899 = (_e898 & 31u);
                                                if (_e899 >= 24u) {
                                                    phi_1481_ = (24u + ((_e899 - 24u) ^ _e395));
                                                } else {
                                                    phi_1481_ = _e899;
                                                }
                                                let _e905 = phi_1481_;
                                                phi_1486_ = (_e807 | ((_e898 >> bitcast<u32>(5i)) << bitcast<u32>((_e905 & 31u))));
                                            } else {
                                                phi_1486_ = _e807;
                                            }
                                            let _e913 = phi_1486_;
                                            phi_1487_ = _e913;
                                        } else {
                                            phi_1487_ = _e807;
                                        }
                                        let _e915 = phi_1487_;
                                        phi_1488_ = _e915;
                                    } else {
                                        phi_1488_ = _e807;
                                    }
                                    let _e917 = phi_1488_;
                                    phi_1358_ = (_e805 + 1u);
                                    phi_1361_ = _e917;
                                } else {
                                    phi_1358_ = u32();
                                    phi_1361_ = u32();
                                }
                                let _e920 = phi_1358_;
                                let _e922 = phi_1361_;
                                continue;
                                continuing {
                                    phi_1357_ = _e920;
                                    phi_1360_ = _e922;
                                    break if !(_e808);
                                }
                            }
                            let _e926 = nodes.member[(0u + _e533)].links[0u];
                            let _e930 = nodes.member[(0u + _e533)].frame[3u];
                            let _e934 = local_4;
                            if ((_e934 & 4278190080u) == 0u) {
                            } else {
                                let _e938 = local_2.group_mask;
                                if ((_e938 & 4278190080u) == 0u) {
                                } else {
                                    let _e942 = local_2.len;
                                    if (_e942 < 32u) {
                                        let _e945 = local_2.group;
                                        let _e947 = local_2.len;
                                        if (_e947 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e947)] = _e945;
                                        let _e953 = local_2.group_mask;
                                        let _e955 = local_2.len;
                                        if (_e955 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e955)] = _e953;
                                        let _e962 = local_2.len;
                                        local_2.len = (_e962 + 1u);
                                    }
                                }
                                local_2.group = (0u + _e926);
                                let _e966 = local_5;
                                local_2.group_mask = ((_e966 & 4278190080u) | (_e930 >> bitcast<u32>(24i)));
                            }
                            let _e971 = local_6;
                            phi_1546_ = (_e971 & 16777215u);
                            loop {
                                let _e974 = phi_1546_;
                                let _e975 = (_e974 == 0u);
                                local_7 = _e975;
                                local_11 = _e975;
                                if _e975 {
                                    phi_1547_ = u32();
                                    phi_2245_ = false;
                                    phi_2246_ = false;
                                    phi_2247_ = false;
                                } else {
                                    let _e978 = nodes.member[(0u + _e533)].links[1u];
                                    let _e983 = ((0u + _e978) + select(firstTrailingBit(_e974), 32u, (_e974 == 0u)));
                                    if (_e983 < _e78) {
                                    } else {
                                        return;
                                    }
                                    let _e990 = triangles.member[(0u + _e983)].v0_;
                                    let _e993 = (_e990.x - _e120.origin.x);
                                    let _e996 = (_e990.y - _e120.origin.y);
                                    let _e999 = (_e990.z - _e120.origin.z);
                                    if (_e360 == 0u) {
                                        phi_1594_ = vec3<f32>(_e996, _e999, _e993);
                                    } else {
                                        if (_e360 == 1u) {
                                            phi_1593_ = vec3<f32>(_e999, _e993, _e996);
                                        } else {
                                            phi_1593_ = (_e990 - _e120.origin);
                                        }
                                        let _e1006 = phi_1593_;
                                        phi_1594_ = _e1006;
                                    }
                                    let _e1008 = phi_1594_;
                                    let _e1012 = (_e1008.x - (_e379 * _e1008.z));
                                    let _e1016 = (_e1008.y - (_e382 * _e1008.z));
                                    let _e1020 = triangles.member[(0u + _e983)].v1_;
                                    let _e1023 = (_e1020.x - _e120.origin.x);
                                    let _e1026 = (_e1020.y - _e120.origin.y);
                                    let _e1029 = (_e1020.z - _e120.origin.z);
                                    if (_e360 == 0u) {
                                        phi_1628_ = vec3<f32>(_e1026, _e1029, _e1023);
                                    } else {
                                        if (_e360 == 1u) {
                                            phi_1627_ = vec3<f32>(_e1029, _e1023, _e1026);
                                        } else {
                                            phi_1627_ = (_e1020 - _e120.origin);
                                        }
                                        let _e1036 = phi_1627_;
                                        phi_1628_ = _e1036;
                                    }
                                    let _e1038 = phi_1628_;
                                    let _e1042 = (_e1038.x - (_e379 * _e1038.z));
                                    let _e1046 = (_e1038.y - (_e382 * _e1038.z));
                                    let _e1050 = triangles.member[(0u + _e983)].v2_;
                                    let _e1053 = (_e1050.x - _e120.origin.x);
                                    let _e1056 = (_e1050.y - _e120.origin.y);
                                    let _e1059 = (_e1050.z - _e120.origin.z);
                                    if (_e360 == 0u) {
                                        phi_1662_ = vec3<f32>(_e1056, _e1059, _e1053);
                                    } else {
                                        if (_e360 == 1u) {
                                            phi_1661_ = vec3<f32>(_e1059, _e1053, _e1056);
                                        } else {
                                            phi_1661_ = (_e1050 - _e120.origin);
                                        }
                                        let _e1066 = phi_1661_;
                                        phi_1662_ = _e1066;
                                    }
                                    let _e1068 = phi_1662_;
                                    let _e1072 = (_e1068.x - (_e379 * _e1068.z));
                                    let _e1076 = (_e1068.y - (_e382 * _e1068.z));
                                    if (_e1042 < _e1072) {
                                        phi_1683_ = true;
                                    } else {
                                        if (_e1042 == _e1072) {
                                            phi_1682_ = (_e1046 < _e1076);
                                        } else {
                                            phi_1682_ = false;
                                        }
                                        let _e1083 = phi_1682_;
                                        phi_1683_ = _e1083;
                                    }
                                    let _e1085 = phi_1683_;
                                    if _e1085 {
                                        phi_1687_ = _e1076;
                                        phi_1688_ = _e1072;
                                        phi_1689_ = _e1046;
                                        phi_1690_ = _e1042;
                                    } else {
                                        phi_1687_ = _e1046;
                                        phi_1688_ = _e1042;
                                        phi_1689_ = _e1076;
                                        phi_1690_ = _e1072;
                                    }
                                    let _e1087 = phi_1687_;
                                    let _e1089 = phi_1688_;
                                    let _e1091 = phi_1689_;
                                    let _e1093 = phi_1690_;
                                    let _e1096 = ((_e1093 * _e1087) - (_e1091 * _e1089));
                                    if _e1085 {
                                        phi_1698_ = -(_e1096);
                                    } else {
                                        phi_1698_ = _e1096;
                                    }
                                    let _e1099 = phi_1698_;
                                    if (_e1072 < _e1012) {
                                        phi_1709_ = true;
                                    } else {
                                        if (_e1072 == _e1012) {
                                            phi_1708_ = (_e1076 < _e1016);
                                        } else {
                                            phi_1708_ = false;
                                        }
                                        let _e1104 = phi_1708_;
                                        phi_1709_ = _e1104;
                                    }
                                    let _e1106 = phi_1709_;
                                    if _e1106 {
                                        phi_1713_ = _e1016;
                                        phi_1714_ = _e1012;
                                        phi_1715_ = _e1076;
                                        phi_1716_ = _e1072;
                                    } else {
                                        phi_1713_ = _e1076;
                                        phi_1714_ = _e1072;
                                        phi_1715_ = _e1016;
                                        phi_1716_ = _e1012;
                                    }
                                    let _e1108 = phi_1713_;
                                    let _e1110 = phi_1714_;
                                    let _e1112 = phi_1715_;
                                    let _e1114 = phi_1716_;
                                    let _e1117 = ((_e1114 * _e1108) - (_e1112 * _e1110));
                                    if _e1106 {
                                        phi_1724_ = -(_e1117);
                                    } else {
                                        phi_1724_ = _e1117;
                                    }
                                    let _e1120 = phi_1724_;
                                    if (_e1012 < _e1042) {
                                        phi_1735_ = true;
                                    } else {
                                        if (_e1012 == _e1042) {
                                            phi_1734_ = (_e1016 < _e1046);
                                        } else {
                                            phi_1734_ = false;
                                        }
                                        let _e1125 = phi_1734_;
                                        phi_1735_ = _e1125;
                                    }
                                    let _e1127 = phi_1735_;
                                    if _e1127 {
                                        phi_1739_ = _e1046;
                                        phi_1740_ = _e1042;
                                        phi_1741_ = _e1016;
                                        phi_1742_ = _e1012;
                                    } else {
                                        phi_1739_ = _e1016;
                                        phi_1740_ = _e1012;
                                        phi_1741_ = _e1046;
                                        phi_1742_ = _e1042;
                                    }
                                    let _e1129 = phi_1739_;
                                    let _e1131 = phi_1740_;
                                    let _e1133 = phi_1741_;
                                    let _e1135 = phi_1742_;
                                    let _e1138 = ((_e1135 * _e1129) - (_e1133 * _e1131));
                                    if _e1127 {
                                        phi_1750_ = -(_e1138);
                                    } else {
                                        phi_1750_ = _e1138;
                                    }
                                    let _e1141 = phi_1750_;
                                    if (_e1099 >= 0f) {
                                        if (_e1120 >= 0f) {
                                            if (_e1141 >= 0f) {
                                                phi_1765_ = ((_e1099 + _e1120) + _e1141);
                                                phi_1766_ = false;
                                            } else {
                                                phi_1765_ = f32();
                                                phi_1766_ = true;
                                            }
                                            let _e1148 = phi_1765_;
                                            let _e1150 = phi_1766_;
                                            phi_1767_ = _e1148;
                                            phi_1768_ = _e1150;
                                        } else {
                                            phi_1767_ = f32();
                                            phi_1768_ = true;
                                        }
                                        let _e1152 = phi_1767_;
                                        let _e1154 = phi_1768_;
                                        phi_1769_ = _e1152;
                                        phi_1770_ = _e1154;
                                    } else {
                                        phi_1769_ = f32();
                                        phi_1770_ = true;
                                    }
                                    let _e1156 = phi_1769_;
                                    let _e1158 = phi_1770_;
                                    if _e1158 {
                                        if (_e1099 <= 0f) {
                                            if (_e1120 <= 0f) {
                                                let _e1161 = (_e1141 <= 0f);
                                                if _e1161 {
                                                }
                                                phi_1788_ = ((_e1099 + _e1120) + _e1141);
                                                phi_1789_ = false;
                                                phi_1790_ = _e1161;
                                            } else {
                                                phi_1788_ = f32();
                                                phi_1789_ = true;
                                                phi_1790_ = false;
                                            }
                                            let _e1165 = phi_1788_;
                                            let _e1167 = phi_1789_;
                                            let _e1169 = phi_1790_;
                                            phi_1791_ = _e1165;
                                            phi_1792_ = _e1167;
                                            phi_1793_ = _e1169;
                                        } else {
                                            phi_1791_ = f32();
                                            phi_1792_ = true;
                                            phi_1793_ = false;
                                        }
                                        let _e1171 = phi_1791_;
                                        let _e1173 = phi_1792_;
                                        let _e1175 = phi_1793_;
                                        if _e1173 {
                                            phi_1797_ = false;
                                        } else {
                                            phi_1797_ = _e1175;
                                        }
                                        let _e1177 = phi_1797_;
                                        phi_1798_ = _e1171;
                                        phi_1799_ = _e1177;
                                    } else {
                                        phi_1798_ = _e1156;
                                        phi_1799_ = true;
                                    }
                                    let _e1179 = phi_1798_;
                                    let _e1181 = phi_1799_;
                                    if _e1181 {
                                        let _e1182 = (_e1179 == 0f);
                                        if _e1182 {
                                            phi_2003_ = lt_bvh_triangle_Intersection();
                                        } else {
                                            let _e1188 = ((((_e1099 * (_e384 * _e1008.z)) + (_e1120 * (_e384 * _e1038.z))) + (_e1141 * (_e384 * _e1068.z))) / _e1179);
                                            let _e1190 = triangles.member[(0u + _e983)].v0_;
                                            let _e1192 = triangles.member[(0u + _e983)].v1_;
                                            if (_e1190.x < _e1192.x) {
                                                phi_1825_ = _e1190.x;
                                            } else {
                                                phi_1825_ = _e1192.x;
                                            }
                                            let _e1199 = phi_1825_;
                                            if (_e1190.y < _e1192.y) {
                                                phi_1834_ = _e1190.y;
                                            } else {
                                                phi_1834_ = _e1192.y;
                                            }
                                            let _e1206 = phi_1834_;
                                            if (_e1190.z < _e1192.z) {
                                                phi_1843_ = _e1190.z;
                                            } else {
                                                phi_1843_ = _e1192.z;
                                            }
                                            let _e1213 = phi_1843_;
                                            let _e1215 = triangles.member[(0u + _e983)].v2_;
                                            if (_e1199 < _e1215.x) {
                                                phi_1852_ = _e1199;
                                            } else {
                                                phi_1852_ = _e1215.x;
                                            }
                                            let _e1220 = phi_1852_;
                                            if (_e1206 < _e1215.y) {
                                                phi_1859_ = _e1206;
                                            } else {
                                                phi_1859_ = _e1215.y;
                                            }
                                            let _e1225 = phi_1859_;
                                            if (_e1213 < _e1215.z) {
                                                phi_1866_ = _e1213;
                                            } else {
                                                phi_1866_ = _e1215.z;
                                            }
                                            let _e1230 = phi_1866_;
                                            let _e1232 = triangles.member[(0u + _e983)].v0_;
                                            let _e1234 = triangles.member[(0u + _e983)].v1_;
                                            if (_e1232.x > _e1234.x) {
                                                phi_1879_ = _e1232.x;
                                            } else {
                                                phi_1879_ = _e1234.x;
                                            }
                                            let _e1241 = phi_1879_;
                                            if (_e1232.y > _e1234.y) {
                                                phi_1888_ = _e1232.y;
                                            } else {
                                                phi_1888_ = _e1234.y;
                                            }
                                            let _e1248 = phi_1888_;
                                            if (_e1232.z > _e1234.z) {
                                                phi_1897_ = _e1232.z;
                                            } else {
                                                phi_1897_ = _e1234.z;
                                            }
                                            let _e1255 = phi_1897_;
                                            let _e1257 = triangles.member[(0u + _e983)].v2_;
                                            if (_e1241 > _e1257.x) {
                                                phi_1906_ = _e1241;
                                            } else {
                                                phi_1906_ = _e1257.x;
                                            }
                                            let _e1262 = phi_1906_;
                                            if (_e1248 > _e1257.y) {
                                                phi_1913_ = _e1248;
                                            } else {
                                                phi_1913_ = _e1257.y;
                                            }
                                            let _e1267 = phi_1913_;
                                            if (_e1255 > _e1257.z) {
                                                phi_1920_ = _e1255;
                                            } else {
                                                phi_1920_ = _e1257.z;
                                            }
                                            let _e1272 = phi_1920_;
                                            let _e1279 = ((_e1220 - _e120.origin.x) * _e272);
                                            let _e1280 = ((_e1225 - _e120.origin.y) * _e284);
                                            let _e1281 = ((_e1230 - _e120.origin.z) * _e296);
                                            let _e1288 = ((_e1262 - _e120.origin.x) * _e272);
                                            let _e1289 = ((_e1267 - _e120.origin.y) * _e284);
                                            let _e1290 = ((_e1272 - _e120.origin.z) * _e296);
                                            if (_e1279 < _e1288) {
                                                phi_1943_ = _e1279;
                                            } else {
                                                phi_1943_ = _e1288;
                                            }
                                            let _e1293 = phi_1943_;
                                            if (_e1280 < _e1289) {
                                                phi_1948_ = _e1280;
                                            } else {
                                                phi_1948_ = _e1289;
                                            }
                                            let _e1296 = phi_1948_;
                                            if (_e1281 < _e1290) {
                                                phi_1953_ = _e1281;
                                            } else {
                                                phi_1953_ = _e1290;
                                            }
                                            let _e1299 = phi_1953_;
                                            if (_e1279 > _e1288) {
                                                phi_1961_ = _e1279;
                                            } else {
                                                phi_1961_ = _e1288;
                                            }
                                            let _e1305 = phi_1961_;
                                            if (_e1280 > _e1289) {
                                                phi_1966_ = _e1280;
                                            } else {
                                                phi_1966_ = _e1289;
                                            }
                                            let _e1308 = phi_1966_;
                                            if (_e1281 > _e1290) {
                                                phi_1971_ = _e1281;
                                            } else {
                                                phi_1971_ = _e1290;
                                            }
                                            let _e1311 = phi_1971_;
                                            let _e1315 = core_intrinsics_maximum_number_nsz_f32_((_e1293 - _e340), (_e1296 - _e341));
                                            let _e1316 = core_intrinsics_maximum_number_nsz_f32_(_e1315, (_e1299 - _e342));
                                            let _e1317 = core_intrinsics_minimum_number_nsz_f32_((_e1305 + _e340), (_e1308 + _e341));
                                            let _e1318 = core_intrinsics_minimum_number_nsz_f32_(_e1317, (_e1311 + _e342));
                                            if (_e1316 > -300000000000000000000000000000000000000f) {
                                                phi_1983_ = _e1316;
                                            } else {
                                                phi_1983_ = -300000000000000000000000000000000000000f;
                                            }
                                            let _e1321 = phi_1983_;
                                            if (_e1318 < 300000000000000000000000000000000000000f) {
                                                phi_1988_ = _e1318;
                                            } else {
                                                phi_1988_ = 300000000000000000000000000000000000000f;
                                            }
                                            let _e1324 = phi_1988_;
                                            if (_e1188 < _e1321) {
                                                phi_1993_ = _e1321;
                                            } else {
                                                phi_1993_ = _e1188;
                                            }
                                            let _e1327 = phi_1993_;
                                            if (_e1327 > _e1324) {
                                                phi_1998_ = _e1324;
                                            } else {
                                                phi_1998_ = _e1327;
                                            }
                                            let _e1330 = phi_1998_;
                                            phi_2003_ = lt_bvh_triangle_Intersection(_e1330, (_e1120 / _e1179), (_e1141 / _e1179), (_e1321 <= _e1324));
                                        }
                                        let _e1336 = phi_2003_;
                                        phi_2004_ = _e1336;
                                        phi_2005_ = _e1182;
                                    } else {
                                        phi_2004_ = lt_bvh_triangle_Intersection();
                                        phi_2005_ = true;
                                    }
                                    let _e1338 = phi_2004_;
                                    let _e1340 = phi_2005_;
                                    if _e1340 {
                                        phi_2009_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2009_ = _e1338;
                                    }
                                    let _e1342 = phi_2009_;
                                    if _e1342.is_hit {
                                        if (_e1342.t > _e120.tmin) {
                                            if (_e1342.t < _e120.tmax) {
                                                let _e1351 = triangles.member[(0u + _e983)].i0_;
                                                let _e1353 = ((_e1351 & 2147483648u) == 0u);
                                                if _e1353 {
                                                    phi_2229_ = false;
                                                    phi_2230_ = false;
                                                } else {
                                                    if (_e983 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1360 = triangles.member[(0u + _e983)].i0_;
                                                    let _e1361 = (_e1360 & 2147483647u);
                                                    let _e1363 = triangles.member[(0u + _e983)].i1_;
                                                    let _e1365 = triangles.member[(0u + _e983)].i2_;
                                                    if (_e1361 < _e84) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1369 = vertices.member[(0u + _e1361)];
                                                    if (_e1363 < _e84) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1373 = vertices.member[(0u + _e1363)];
                                                    if (_e1365 < _e84) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1377 = vertices.member[(0u + _e1365)];
                                                    let _e1378 = array<abi_Vertex, 3>(_e1369, _e1373, _e1377);
                                                    local_1 = array<abi_Vertex, 3>(abi_Vertex(_e1378[0].u, _e1378[0].v, _e1378[0].normal, _e1378[0].color, _e1378[0].material), abi_Vertex(_e1378[1].u, _e1378[1].v, _e1378[1].normal, _e1378[1].color, _e1378[1].material), abi_Vertex(_e1378[2].u, _e1378[2].v, _e1378[2].normal, _e1378[2].color, _e1378[2].material));
                                                    let _e1403 = local_1[0u].material;
                                                    if (_e1403 < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1407 = materials.member[(0u + _e1403)];
                                                    if ((_e1407.flags & 1u) == 1u) {
                                                        let _e1411 = lt_shaders_surface_barycentric_weights(_e1342.u, _e1342.v);
                                                        if (_e1407.cutoff <= 0f) {
                                                            phi_2223_ = true;
                                                        } else {
                                                            let _e1416 = lt_shaders_surface_vertex_color((&local_1), _e1411);
                                                            let _e1418 = (_e1407.base_color.w * _e1416.w);
                                                            if (_e1407.alpha_size == 0u) {
                                                                phi_2220_ = _e1418;
                                                            } else {
                                                                local.offset = _e1407.alpha_offset;
                                                                local.size = _e1407.alpha_size;
                                                                local.flags = _e1407.flags;
                                                                let _e1427 = lt_shaders_surface_texture_coordinate((&local_1), _e1411);
                                                                let _e1430 = _lt_shaders_texture_TextureView_quad((&local), _e1427.x, _e1427.y);
                                                                let _e1434 = (_e1430.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1434 < _e90) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1438 = alpha_texels.member[(0u + _e1434)];
                                                                let _e1454 = (_e1430.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1454 < _e90) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1458 = alpha_texels.member[(0u + _e1454)];
                                                                let _e1475 = (_e1430.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1475 < _e90) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1479 = alpha_texels.member[(0u + _e1475)];
                                                                let _e1496 = (_e1430.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1496 < _e90) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1500 = alpha_texels.member[(0u + _e1496)];
                                                                phi_2220_ = (_e1418 * (((((f32(((_e1438 >> bitcast<u32>((((_e1430.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1430.weights.x) + ((f32(((_e1458 >> bitcast<u32>((((_e1430.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1430.weights.y)) + ((f32(((_e1479 >> bitcast<u32>((((_e1430.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1430.weights.z)) + ((f32(((_e1500 >> bitcast<u32>((((_e1430.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1430.weights.w)));
                                                            }
                                                            let _e1516 = phi_2220_;
                                                            phi_2223_ = (_e1516 >= _e1407.cutoff);
                                                        }
                                                        let _e1520 = phi_2223_;
                                                        phi_2224_ = _e1520;
                                                    } else {
                                                        phi_2224_ = false;
                                                    }
                                                    let _e1522 = phi_2224_;
                                                    if _e1522 {
                                                        phi_2228_ = false;
                                                    } else {
                                                        phi_2228_ = true;
                                                    }
                                                    let _e1524 = phi_2228_;
                                                    phi_2229_ = _e1524;
                                                    phi_2230_ = _e1522;
                                                }
                                                let _e1526 = phi_2229_;
                                                let _e1528 = phi_2230_;
                                                phi_2231_ = _e1526;
                                                phi_2232_ = _e1353;
                                                phi_2233_ = _e1528;
                                            } else {
                                                phi_2231_ = true;
                                                phi_2232_ = false;
                                                phi_2233_ = false;
                                            }
                                            let _e1530 = phi_2231_;
                                            let _e1532 = phi_2232_;
                                            let _e1534 = phi_2233_;
                                            phi_2234_ = _e1530;
                                            phi_2235_ = _e1532;
                                            phi_2236_ = _e1534;
                                        } else {
                                            phi_2234_ = true;
                                            phi_2235_ = false;
                                            phi_2236_ = false;
                                        }
                                        let _e1536 = phi_2234_;
                                        let _e1538 = phi_2235_;
                                        let _e1540 = phi_2236_;
                                        phi_2237_ = _e1536;
                                        phi_2238_ = _e1538;
                                        phi_2239_ = _e1540;
                                    } else {
                                        phi_2237_ = true;
                                        phi_2238_ = false;
                                        phi_2239_ = false;
                                    }
                                    let _e1542 = phi_2237_;
                                    let _e1544 = phi_2238_;
                                    let _e1546 = phi_2239_;
                                    if _e1542 {
                                        phi_2243_ = false;
                                        phi_2244_ = false;
                                    } else {
                                        phi_2243_ = _e1544;
                                        phi_2244_ = _e1546;
                                    }
                                    let _e1548 = phi_2243_;
                                    let _e1550 = phi_2244_;
                                    phi_1547_ = (_e974 & (_e974 - 1u));
                                    phi_2245_ = _e1542;
                                    phi_2246_ = _e1548;
                                    phi_2247_ = _e1550;
                                }
                                let _e1552 = phi_1547_;
                                let _e1554 = phi_2245_;
                                let _e1556 = phi_2246_;
                                let _e1558 = phi_2247_;
                                local_9 = _e1556;
                                local_10 = _e1558;
                                continue;
                                continuing {
                                    phi_1546_ = _e1552;
                                    break if !(_e1554);
                                }
                            }
                            let _e1561 = local_7;
                            if _e1561 {
                                let _e1563 = local_2.group_mask;
                                if ((_e1563 & 4278190080u) == 0u) {
                                    let _e1567 = local_2.len;
                                    if (_e1567 == 0u) {
                                        phi_2289_ = false;
                                    } else {
                                        let _e1571 = local_2.len;
                                        local_2.len = (_e1571 - 1u);
                                        let _e1574 = local_2.len;
                                        if (_e1574 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1579 = local_2.first[(0u + _e1574)];
                                        local_2.group = _e1579;
                                        let _e1582 = local_2.len;
                                        if (_e1582 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1587 = local_2.mask[(0u + _e1582)];
                                        local_2.group_mask = _e1587;
                                        phi_2289_ = true;
                                    }
                                    let _e1590 = phi_2289_;
                                    phi_2290_ = _e1590;
                                } else {
                                    phi_2290_ = true;
                                }
                                let _e1592 = phi_2290_;
                                if _e1592 {
                                    let _e1594 = local_2.group_mask;
                                    let _e1600 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1594)), 32u, (_e1594 == 0u)));
                                    let _e1604 = local_2.group_mask;
                                    let _e1618 = local_2.group_mask;
                                    local_2.group_mask = (_e1618 & ~((1u << bitcast<u32>((_e1600 & 31u)))));
                                    let _e1621 = local_2.group;
                                    phi_2321_ = (_e1621 + countOneBits(((_e1604 & ~((4294967295u << bitcast<u32>((((_e1600 - 24u) ^ _e395) & 31u))))) & 255u)));
                                } else {
                                    phi_2321_ = 4294967295u;
                                }
                                let _e1624 = phi_2321_;
                                phi_2322_ = _e1624;
                                phi_2323_ = false;
                                phi_2324_ = false;
                            } else {
                                phi_2322_ = u32();
                                let _e1830 = local_9;
                                phi_2323_ = _e1830;
                                let _e1833 = local_10;
                                phi_2324_ = _e1833;
                            }
                            let _e1626 = phi_2322_;
                            let _e1628 = phi_2323_;
                            let _e1630 = phi_2324_;
                            phi_1212_ = _e1626;
                            let _e1837 = local_11;
                            phi_2325_ = _e1837;
                            phi_2326_ = false;
                            phi_2327_ = _e1628;
                            phi_2328_ = _e1630;
                        } else {
                            phi_1212_ = u32();
                            phi_2325_ = false;
                            phi_2326_ = true;
                            phi_2327_ = false;
                            phi_2328_ = false;
                        }
                        let _e1632 = phi_1212_;
                        let _e1634 = phi_2325_;
                        let _e1636 = phi_2326_;
                        let _e1638 = phi_2327_;
                        let _e1640 = phi_2328_;
                        local_8 = _e1636;
                        local_12 = _e1638;
                        local_13 = _e1640;
                        continue;
                        continuing {
                            phi_1211_ = _e1632;
                            break if !(_e1634);
                        }
                    }
                    let _e1643 = local_8;
                    if _e1643 {
                        phi_2332_ = false;
                        phi_2333_ = false;
                    } else {
                        let _e1844 = local_12;
                        phi_2332_ = _e1844;
                        let _e1847 = local_13;
                        phi_2333_ = _e1847;
                    }
                    let _e1645 = phi_2332_;
                    let _e1647 = phi_2333_;
                    if _e1645 {
                        phi_2337_ = true;
                    } else {
                        phi_2337_ = _e1647;
                    }
                    let _e1649 = phi_2337_;
                    if _e1649 {
                        phi_2341_ = true;
                    } else {
                        phi_2341_ = false;
                    }
                    let _e1651 = phi_2341_;
                    phi_2342_ = _e1651;
                }
                let _e1653 = phi_2342_;
                phi_2343_ = _e1653;
                phi_2344_ = _e190;
            } else {
                phi_2343_ = bool();
                phi_2344_ = true;
            }
            let _e1655 = phi_2343_;
            let _e1657 = phi_2344_;
            if _e1657 {
                phi_2348_ = false;
            } else {
                phi_2348_ = _e1655;
            }
            let _e1659 = phi_2348_;
            if _e1659 {
                phi_2352_ = 0f;
            } else {
                phi_2352_ = 1f;
            }
            let _e1661 = phi_2352_;
            phi_2353_ = _e1661;
        }
        let _e1663 = phi_2353_;
        if (_e96.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e96.first_primitive)] = _e1663;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
