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

struct type_43 {
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

struct type_52 {
    member: array<abi_Sample>,
}

struct type_56 {
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

struct type_67 {
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

struct type_74 {
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
var<storage> samples: type_52;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_74;
@group(0) @binding(2) 
var<storage> nodes: type_67;
@group(0) @binding(3) 
var<storage> triangles: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_56;
@group(0) @binding(6) 
var<storage> vertices: type_13;
@group(0) @binding(7) 
var<storage> materials: type_18;
@group(0) @binding(8) 
var<storage> alpha_texels: type_22;
@group(0) @binding(5) 
var<storage> instances: type_43;

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
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_489_: f32;
    var phi_498_: f32;
    var phi_499_: f32;

    if (param_6 == 0u) {
        phi_489_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e73 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e73 > 1f) {
                phi_487_ = (2f - _e73);
            } else {
                phi_487_ = _e73;
            }
            let _e77 = phi_487_;
            phi_488_ = _e77;
        } else {
            phi_488_ = param_5;
        }
        let _e79 = phi_488_;
        phi_489_ = _e79;
    }
    let _e81 = phi_489_;
    if (_e81 > 0f) {
        if (_e81 < 1f) {
            phi_498_ = _e81;
        } else {
            phi_498_ = 1f;
        }
        let _e85 = phi_498_;
        phi_499_ = _e85;
    } else {
        phi_499_ = 0f;
    }
    let _e87 = phi_499_;
    return _e87;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_425_: u32;
    var phi_439_: u32;
    var phi_446_: u32;
    var phi_451_: u32;
    var phi_457_: u32;
    var phi_462_: u32;
    var phi_464_: texture_Axis;

    let _e68 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e69 = (param_8 - 1u);
    let _e71 = (_e68 * f32(param_8));
    if param_10 {
        let _e78 = select(select(u32(_e71), 0u, (_e71 < bitcast<f32>(0u))), 4294967295u, (_e71 > bitcast<f32>(1333788671u)));
        if (_e69 < _e78) {
            phi_425_ = _e69;
        } else {
            phi_425_ = _e78;
        }
        let _e81 = phi_425_;
        phi_464_ = texture_Axis(_e81, _e81, 0f);
    } else {
        let _e83 = (_e71 + 0.5f);
        let _e90 = select(select(u32(_e83), 0u, (_e83 < bitcast<f32>(0u))), 4294967295u, (_e83 > bitcast<f32>(1333788671u)));
        if (param_8 < _e90) {
            phi_439_ = param_8;
        } else {
            phi_439_ = _e90;
        }
        let _e93 = phi_439_;
        if (param_9 == 0u) {
            phi_446_ = _e69;
        } else {
            phi_446_ = 0u;
        }
        let _e98 = phi_446_;
        if (param_9 == 0u) {
            phi_451_ = 0u;
        } else {
            phi_451_ = _e69;
        }
        let _e101 = phi_451_;
        if (_e93 == 0u) {
            phi_457_ = _e98;
        } else {
            phi_457_ = (_e93 - 1u);
        }
        let _e105 = phi_457_;
        if (_e93 > _e69) {
            phi_462_ = _e101;
        } else {
            phi_462_ = _e93;
        }
        let _e108 = phi_462_;
        phi_464_ = texture_Axis(_e105, _e108, (_e83 - f32(_e93)));
    }
    let _e111 = phi_464_;
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
        let _e77 = phi_519_;
        let _e79 = phi_520_;
        phi_521_ = _e77;
        phi_522_ = _e79;
    } else {
        phi_521_ = lt_bvh_traverse_Tree();
        phi_522_ = true;
    }
    let _e81 = phi_521_;
    let _e83 = phi_522_;
    if _e83 {
        phi_527_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_527_ = _e81;
    }
    let _e88 = phi_527_;
    return lt_bvh_traverse_Tree(_e88.root, _e88.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_17: f32, param_18: f32) -> f32 {
    var phi_542_: bool;
    var phi_546_: f32;

    if (param_17 != param_17) {
        phi_542_ = true;
    } else {
        let _e67 = (param_18 >= param_17);
        if _e67 {
        }
        phi_542_ = _e67;
    }
    let _e69 = phi_542_;
    if _e69 {
        phi_546_ = param_18;
    } else {
        phi_546_ = param_17;
    }
    let _e71 = phi_546_;
    return _e71;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_19: f32, param_20: f32) -> f32 {
    var phi_558_: bool;
    var phi_562_: f32;

    if (param_19 != param_19) {
        phi_558_ = true;
    } else {
        let _e67 = (param_20 <= param_19);
        if _e67 {
        }
        phi_558_ = _e67;
    }
    let _e69 = phi_558_;
    if _e69 {
        phi_562_ = param_20;
    } else {
        phi_562_ = param_19;
    }
    let _e71 = phi_562_;
    return _e71;
}

fn lt_shaders_surface_barycentric_weights(param_21: f32, param_22: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_21) - param_22), param_21, param_22);
}

fn lt_shaders_evaluate_to_light(param_23: vec3<f32>, param_24: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_24.x - (param_23.x * param_24.w)), (param_24.y - (param_23.y * param_24.w)), (param_24.z - (param_23.z * param_24.w)));
}

fn _lt_shaders_abi_Sample_is_valid(param_25: ptr<function, abi_Sample>) -> bool {
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_642_: bool;

    let _e67 = (*param_25).normal[0u];
    let _e69 = global[0u];
    if (_e67 == _e69) {
        let _e72 = (*param_25).normal[1u];
        let _e74 = global[1u];
        if (_e72 == _e74) {
            let _e77 = (*param_25).normal[2u];
            let _e79 = global[2u];
            phi_635_ = (_e77 == _e79);
            phi_636_ = false;
        } else {
            phi_635_ = bool();
            phi_636_ = true;
        }
        let _e82 = phi_635_;
        let _e84 = phi_636_;
        phi_637_ = _e82;
        phi_638_ = _e84;
    } else {
        phi_637_ = bool();
        phi_638_ = true;
    }
    let _e86 = phi_637_;
    let _e88 = phi_638_;
    if _e88 {
        phi_642_ = false;
    } else {
        phi_642_ = _e86;
    }
    let _e90 = phi_642_;
    return !(_e90);
}

fn lt_shaders_evaluate_settle(param_26: ptr<function, abi_Sample>, param_27: vec4<f32>) -> u0028_evaluate_Verdict_u0020_bool_u0029_ {
    var phi_606_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_610_: u0028_evaluate_Verdict_u0020_bool_u0029_;

    let _e66 = _lt_shaders_abi_Sample_is_valid(param_26);
    if _e66 {
        let _e68 = (*param_26).normal;
        let _e70 = (*param_26).position;
        let _e71 = lt_shaders_evaluate_to_light(_e70, param_27);
        if ((((_e68.x * _e71.x) + (_e68.y * _e71.y)) + (_e68.z * _e71.z)) > 0f) {
            let _e85 = (*param_26).flags;
            let _e93 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e99 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e93.unnamed.visibility, false), _e93.unnamed_1);
            phi_606_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e99.unnamed, ((_e85 & 1u) == 0u));
        } else {
            let _e108 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e114 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e108.unnamed.visibility, false), _e108.unnamed_1);
            phi_606_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e114.unnamed, true);
        }
        let _e119 = phi_606_;
        phi_610_ = _e119;
    } else {
        let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
        let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
        phi_610_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
    }
    let _e136 = phi_610_;
    return _e136;
}

fn lt_shaders_resolve_shadow_ray(param_28: ptr<function, abi_Sample>, param_29: vec4<f32>) -> lt_bvh_Ray {
    var phi_685_: f32;

    let _e67 = (*param_28).position;
    let _e69 = (*param_28).normal;
    let _e71 = (*param_28).magnitude;
    let _e73 = ((8f / 8388608f) * _e71);
    let _e81 = (_e67 + vec3<f32>((_e69.x * _e73), (_e69.y * _e73), (_e69.z * _e73)));
    if (param_29.w == 0f) {
        phi_685_ = 300000000000000000000000000000000000000f;
    } else {
        phi_685_ = 1f;
    }
    let _e85 = phi_685_;
    let _e86 = lt_shaders_evaluate_to_light(_e81, param_29);
    return lt_bvh_Ray(_e81, 0f, _e86, _e85);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var local_4: abi_Sample;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_848_: bool;
    var phi_852_: bool;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_957_: f32;
    var phi_964_: f32;
    var phi_989_: f32;
    var phi_994_: f32;
    var phi_999_: f32;
    var phi_1021_: u32;
    var phi_1026_: u32;
    var phi_1031_: u32;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1177_: u32;
    var phi_1179_: u32;
    var phi_1265_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1319_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1325_: u32;
    var phi_1328_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1362_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1400_: u32;
    var phi_1436_: u32;
    var phi_1449_: u32;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1326_: u32;
    var phi_1329_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1514_: u32;
    var phi_1570_: f32;
    var phi_1575_: f32;
    var phi_1580_: f32;
    var phi_1588_: f32;
    var phi_1593_: f32;
    var phi_1598_: f32;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1781_: bool;
    var phi_1785_: bool;
    var phi_1855_: f32;
    var phi_1862_: f32;
    var phi_1869_: f32;
    var phi_1876_: f32;
    var phi_1883_: f32;
    var phi_1890_: f32;
    var phi_1907_: f32;
    var phi_1912_: f32;
    var phi_1917_: f32;
    var phi_1945_: bool;
    var phi_1946_: bool;
    var phi_1954_: u32;
    var phi_1955_: u32;
    var phi_1966_: vec3<f32>;
    var phi_1967_: vec3<f32>;
    var phi_1980_: u32;
    var phi_1985_: u32;
    var phi_1990_: u32;
    var phi_2104_: bool;
    var phi_2105_: bool;
    var phi_2136_: u32;
    var phi_2138_: u32;
    var phi_2219_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2246_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2273_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2279_: u32;
    var phi_2282_: u32;
    var phi_2296_: u32;
    var phi_2306_: u32;
    var phi_2316_: u32;
    var phi_2334_: u32;
    var phi_2344_: u32;
    var phi_2354_: u32;
    var phi_2390_: u32;
    var phi_2403_: u32;
    var phi_2408_: u32;
    var phi_2409_: u32;
    var phi_2410_: u32;
    var phi_2280_: u32;
    var phi_2283_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_2468_: u32;
    var phi_2513_: vec3<f32>;
    var phi_2514_: vec3<f32>;
    var phi_2545_: vec3<f32>;
    var phi_2546_: vec3<f32>;
    var phi_2577_: vec3<f32>;
    var phi_2578_: vec3<f32>;
    var phi_2598_: bool;
    var phi_2599_: bool;
    var phi_2603_: f32;
    var phi_2604_: f32;
    var phi_2605_: f32;
    var phi_2606_: f32;
    var phi_2614_: f32;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2629_: f32;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2632_: f32;
    var phi_2640_: f32;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2655_: f32;
    var phi_2656_: f32;
    var phi_2657_: f32;
    var phi_2658_: f32;
    var phi_2666_: f32;
    var phi_2681_: f32;
    var phi_2682_: bool;
    var phi_2683_: f32;
    var phi_2684_: bool;
    var phi_2685_: f32;
    var phi_2686_: bool;
    var phi_2704_: f32;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2707_: f32;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2713_: bool;
    var phi_2714_: f32;
    var phi_2715_: bool;
    var phi_2741_: f32;
    var phi_2750_: f32;
    var phi_2759_: f32;
    var phi_2768_: f32;
    var phi_2775_: f32;
    var phi_2782_: f32;
    var phi_2795_: f32;
    var phi_2804_: f32;
    var phi_2813_: f32;
    var phi_2822_: f32;
    var phi_2829_: f32;
    var phi_2836_: f32;
    var phi_2853_: f32;
    var phi_2858_: f32;
    var phi_2863_: f32;
    var phi_2871_: f32;
    var phi_2876_: f32;
    var phi_2881_: f32;
    var phi_2893_: f32;
    var phi_2898_: f32;
    var phi_2903_: f32;
    var phi_2908_: f32;
    var phi_2913_: lt_bvh_triangle_Intersection;
    var phi_2914_: lt_bvh_triangle_Intersection;
    var phi_2915_: bool;
    var phi_2919_: lt_bvh_triangle_Intersection;
    var phi_3128_: f32;
    var phi_3131_: bool;
    var phi_3132_: bool;
    var phi_3136_: bool;
    var phi_3137_: bool;
    var phi_3138_: bool;
    var phi_3139_: bool;
    var phi_3140_: bool;
    var phi_3141_: bool;
    var phi_3142_: bool;
    var phi_3143_: bool;
    var phi_3144_: bool;
    var phi_3145_: bool;
    var phi_3146_: bool;
    var phi_3147_: bool;
    var phi_3151_: bool;
    var phi_3152_: bool;
    var phi_2469_: u32;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var local_11: bool;
    var phi_3197_: bool;
    var phi_3198_: bool;
    var phi_3229_: u32;
    var phi_3230_: u32;
    var phi_3231_: bool;
    var phi_3232_: bool;
    var phi_2139_: u32;
    var phi_3233_: bool;
    var phi_3234_: bool;
    var phi_3235_: bool;
    var phi_3236_: bool;
    var local_12: bool;
    var phi_3240_: bool;
    var phi_3241_: bool;
    var phi_3245_: bool;
    var phi_3249_: bool;
    var phi_3250_: bool;
    var phi_3251_: bool;
    var phi_3252_: bool;
    var phi_3256_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_1515_: u32;
    var phi_3267_: bool;
    var local_13: bool;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3341_: u32;
    var phi_3342_: u32;
    var phi_1180_: u32;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var local_14: bool;
    var phi_3348_: bool;
    var phi_3352_: bool;
    var phi_3353_: bool;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var phi_3359_: bool;
    var phi_3363_: f32;
    var phi_3364_: f32;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e88 = arrayLength((&vertices.member));
    let _e94 = arrayLength((&alpha_texels.member));
    let _e97 = p.member.size[0u];
    let _e99 = p.member.size[1u];
    let _e100 = lt_shaders_entry_pixel_index(_e69, _e97, _e99);
    if (bitcast<i32>(_e100.root) != 0i) {
        if (_e100.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e108 = samples.member[(0u + _e100.first_primitive)];
        local_4 = abi_Sample(_e108.position, _e108.magnitude, _e108.normal, _e108.flags, _e108.shading_normal, _e108.albedo);
        let _e117 = p.member.light;
        let _e118 = lt_shaders_evaluate_settle((&local_4), _e117);
        let _e123 = p.member.root;
        if _e118.unnamed_1 {
            phi_3364_ = _e118.unnamed.visibility;
        } else {
            let _e125 = p.member.light;
            let _e126 = lt_shaders_resolve_shadow_ray((&local_4), _e125);
            let _e136 = abs(_e126.direction.x);
            let _e138 = abs(_e126.direction.y);
            let _e140 = abs(_e126.direction.z);
            if (abs(_e126.origin.x) < 1000000000000000f) {
                if (abs(_e126.origin.y) < 1000000000000000f) {
                    if (abs(_e126.origin.z) < 1000000000000000f) {
                        if (_e136 < 1000000000000000f) {
                            if (_e138 < 1000000000000000f) {
                                if (_e140 < 1000000000000000f) {
                                    if (_e136 > 0f) {
                                        phi_822_ = bool();
                                        phi_823_ = true;
                                    } else {
                                        let _e148 = (_e138 > 0f);
                                        if _e148 {
                                            phi_821_ = bool();
                                        } else {
                                            phi_821_ = (_e140 > 0f);
                                        }
                                        let _e151 = phi_821_;
                                        phi_822_ = _e151;
                                        phi_823_ = _e148;
                                    }
                                    let _e153 = phi_822_;
                                    let _e155 = phi_823_;
                                    if _e155 {
                                        phi_827_ = true;
                                    } else {
                                        phi_827_ = _e153;
                                    }
                                    let _e157 = phi_827_;
                                    phi_828_ = _e157;
                                    phi_829_ = false;
                                } else {
                                    phi_828_ = bool();
                                    phi_829_ = true;
                                }
                                let _e159 = phi_828_;
                                let _e161 = phi_829_;
                                phi_830_ = _e159;
                                phi_831_ = false;
                                phi_832_ = _e161;
                            } else {
                                phi_830_ = bool();
                                phi_831_ = true;
                                phi_832_ = false;
                            }
                            let _e163 = phi_830_;
                            let _e165 = phi_831_;
                            let _e167 = phi_832_;
                            phi_833_ = _e163;
                            phi_834_ = _e165;
                            phi_835_ = _e167;
                        } else {
                            phi_833_ = bool();
                            phi_834_ = true;
                            phi_835_ = false;
                        }
                        let _e169 = phi_833_;
                        let _e171 = phi_834_;
                        let _e173 = phi_835_;
                        phi_836_ = _e169;
                        phi_837_ = _e171;
                        phi_838_ = _e173;
                    } else {
                        phi_836_ = bool();
                        phi_837_ = true;
                        phi_838_ = false;
                    }
                    let _e175 = phi_836_;
                    let _e177 = phi_837_;
                    let _e179 = phi_838_;
                    phi_839_ = _e175;
                    phi_840_ = _e177;
                    phi_841_ = _e179;
                } else {
                    phi_839_ = bool();
                    phi_840_ = true;
                    phi_841_ = false;
                }
                let _e181 = phi_839_;
                let _e183 = phi_840_;
                let _e185 = phi_841_;
                phi_842_ = _e181;
                phi_843_ = _e183;
                phi_844_ = _e185;
            } else {
                phi_842_ = bool();
                phi_843_ = true;
                phi_844_ = false;
            }
            let _e187 = phi_842_;
            let _e189 = phi_843_;
            let _e191 = phi_844_;
            if _e189 {
                phi_848_ = true;
            } else {
                phi_848_ = _e191;
            }
            let _e193 = phi_848_;
            if _e193 {
                phi_852_ = false;
            } else {
                phi_852_ = _e187;
            }
            let _e195 = phi_852_;
            if _e195 {
                let _e196 = (_e123 >= _e76);
                if _e196 {
                    phi_3353_ = bool();
                } else {
                    if (_e123 < _e76) {
                    } else {
                        return;
                    }
                    let _e202 = nodes.member[(0u + _e123)].frame[0u];
                    let _e206 = nodes.member[(0u + _e123)].frame[1u];
                    let _e210 = nodes.member[(0u + _e123)].frame[2u];
                    let _e214 = nodes.member[(0u + _e123)].frame[0u];
                    let _e218 = nodes.member[(0u + _e123)].frame[1u];
                    let _e222 = nodes.member[(0u + _e123)].frame[2u];
                    let _e226 = nodes.member[(0u + _e123)].frame[3u];
                    let _e264 = core_intrinsics_maximum_number_nsz_f32_(abs(_e126.direction.x), abs(_e126.direction.y));
                    let _e265 = core_intrinsics_maximum_number_nsz_f32_(_e264, abs(_e126.direction.z));
                    let _e266 = (_e265 * 0.0000000000009094947f);
                    if (abs(_e126.direction.x) < _e266) {
                        phi_927_ = _e266;
                    } else {
                        phi_927_ = abs(_e126.direction.x);
                    }
                    let _e273 = phi_927_;
                    if (_e126.direction.x < 0f) {
                        phi_934_ = (-1f / _e273);
                    } else {
                        phi_934_ = (1f / _e273);
                    }
                    let _e278 = phi_934_;
                    if (abs(_e126.direction.y) < _e266) {
                        phi_942_ = _e266;
                    } else {
                        phi_942_ = abs(_e126.direction.y);
                    }
                    let _e285 = phi_942_;
                    if (_e126.direction.y < 0f) {
                        phi_949_ = (-1f / _e285);
                    } else {
                        phi_949_ = (1f / _e285);
                    }
                    let _e290 = phi_949_;
                    if (abs(_e126.direction.z) < _e266) {
                        phi_957_ = _e266;
                    } else {
                        phi_957_ = abs(_e126.direction.z);
                    }
                    let _e297 = phi_957_;
                    if (_e126.direction.z < 0f) {
                        phi_964_ = (-1f / _e297);
                    } else {
                        phi_964_ = (1f / _e297);
                    }
                    let _e302 = phi_964_;
                    let _e310 = abs((bitcast<f32>(_e202) - _e126.origin.x));
                    let _e311 = abs((bitcast<f32>(_e206) - _e126.origin.y));
                    let _e312 = abs((bitcast<f32>(_e210) - _e126.origin.z));
                    let _e320 = abs(((bitcast<f32>(_e214) + (bitcast<f32>((((_e226 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126.origin.x));
                    let _e321 = abs(((bitcast<f32>(_e218) + (bitcast<f32>((((_e226 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126.origin.y));
                    let _e322 = abs(((bitcast<f32>(_e222) + (bitcast<f32>((((_e226 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126.origin.z));
                    if (_e310 > _e320) {
                        phi_989_ = _e310;
                    } else {
                        phi_989_ = _e320;
                    }
                    let _e325 = phi_989_;
                    if (_e311 > _e321) {
                        phi_994_ = _e311;
                    } else {
                        phi_994_ = _e321;
                    }
                    let _e328 = phi_994_;
                    if (_e312 > _e322) {
                        phi_999_ = _e312;
                    } else {
                        phi_999_ = _e322;
                    }
                    let _e331 = phi_999_;
                    let _e332 = core_intrinsics_maximum_number_nsz_f32_(_e325, _e328);
                    let _e333 = core_intrinsics_maximum_number_nsz_f32_(_e332, _e331);
                    let _e338 = (_e333 * 0.0000019073486f);
                    let _e339 = (abs(_e278) * _e338);
                    let _e340 = (abs(_e290) * _e338);
                    let _e341 = (abs(_e302) * _e338);
                    let _e345 = (_e333 * 0.0000009536743f);
                    let _e346 = (abs(_e278) * _e345);
                    let _e347 = (abs(_e290) * _e345);
                    let _e348 = (abs(_e302) * _e345);
                    if (_e278 < 0f) {
                        phi_1021_ = 0u;
                    } else {
                        phi_1021_ = 1u;
                    }
                    let _e351 = phi_1021_;
                    if (_e290 < 0f) {
                        phi_1026_ = 0u;
                    } else {
                        phi_1026_ = 2u;
                    }
                    let _e354 = phi_1026_;
                    if (_e302 < 0f) {
                        phi_1031_ = 0u;
                    } else {
                        phi_1031_ = 4u;
                    }
                    let _e357 = phi_1031_;
                    let _e359 = ((_e351 | _e354) | _e357);
                    let _e360 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e123, 2147483648u);
                    local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e360.first[0], _e360.first[1], _e360.first[2], _e360.first[3], _e360.first[4], _e360.first[5], _e360.first[6], _e360.first[7], _e360.first[8], _e360.first[9], _e360.first[10], _e360.first[11], _e360.first[12], _e360.first[13], _e360.first[14], _e360.first[15], _e360.first[16], _e360.first[17], _e360.first[18], _e360.first[19], _e360.first[20], _e360.first[21], _e360.first[22], _e360.first[23], _e360.first[24], _e360.first[25], _e360.first[26], _e360.first[27], _e360.first[28], _e360.first[29], _e360.first[30], _e360.first[31]), array<u32, 32>(_e360.mask[0], _e360.mask[1], _e360.mask[2], _e360.mask[3], _e360.mask[4], _e360.mask[5], _e360.mask[6], _e360.mask[7], _e360.mask[8], _e360.mask[9], _e360.mask[10], _e360.mask[11], _e360.mask[12], _e360.mask[13], _e360.mask[14], _e360.mask[15], _e360.mask[16], _e360.mask[17], _e360.mask[18], _e360.mask[19], _e360.mask[20], _e360.mask[21], _e360.mask[22], _e360.mask[23], _e360.mask[24], _e360.mask[25], _e360.mask[26], _e360.mask[27], _e360.mask[28], _e360.mask[29], _e360.mask[30], _e360.mask[31]), _e360.len, _e360.group, _e360.group_mask);
                    let _e434 = local_3.group_mask;
                    if ((_e434 & 4278190080u) == 0u) {
                        let _e438 = local_3.len;
                        if (_e438 == 0u) {
                            phi_1145_ = false;
                        } else {
                            let _e442 = local_3.len;
                            local_3.len = (_e442 - 1u);
                            let _e445 = local_3.len;
                            if (_e445 < 32u) {
                            } else {
                                return;
                            }
                            let _e450 = local_3.first[(0u + _e445)];
                            local_3.group = _e450;
                            let _e453 = local_3.len;
                            if (_e453 < 32u) {
                            } else {
                                return;
                            }
                            let _e458 = local_3.mask[(0u + _e453)];
                            local_3.group_mask = _e458;
                            phi_1145_ = true;
                        }
                        let _e461 = phi_1145_;
                        phi_1146_ = _e461;
                    } else {
                        phi_1146_ = true;
                    }
                    let _e463 = phi_1146_;
                    if _e463 {
                        let _e465 = local_3.group_mask;
                        let _e471 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e465)), 32u, (_e465 == 0u)));
                        let _e475 = local_3.group_mask;
                        let _e489 = local_3.group_mask;
                        local_3.group_mask = (_e489 & ~((1u << bitcast<u32>((_e471 & 31u)))));
                        let _e492 = local_3.group;
                        phi_1177_ = (_e492 + countOneBits(((_e475 & ~((4294967295u << bitcast<u32>((((_e471 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1177_ = 4294967295u;
                    }
                    let _e495 = phi_1177_;
                    phi_1179_ = _e495;
                    loop {
                        let _e497 = phi_1179_;
                        if (_e497 != 4294967295u) {
                            if (_e497 < _e76) {
                            } else {
                                return;
                            }
                            let _e506 = nodes.member[(0u + _e497)].frame[3u];
                            let _e531 = (bitcast<f32>((((_e506 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e278);
                            let _e532 = (bitcast<f32>((((_e506 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                            let _e533 = (bitcast<f32>((((_e506 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                            let _e536 = nodes.member[(0u + _e497)].frame[0u];
                            let _e540 = nodes.member[(0u + _e497)].frame[1u];
                            let _e544 = nodes.member[(0u + _e497)].frame[2u];
                            let _e552 = ((bitcast<f32>(_e536) - _e126.origin.x) * _e278);
                            let _e553 = ((bitcast<f32>(_e540) - _e126.origin.y) * _e290);
                            let _e554 = ((bitcast<f32>(_e544) - _e126.origin.z) * _e302);
                            let _e562 = nodes.member[(0u + _e497)].x;
                            if (_e278 < 0f) {
                                let _e573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e562.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e573.unnamed.root, _e562.w), _e573.unnamed_1);
                                let _e585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e579.unnamed, lt_bvh_traverse_Tree(_e562.x, _e579.unnamed_1.first_primitive));
                                phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e585.unnamed, lt_bvh_traverse_Tree(_e585.unnamed_1.root, _e562.y));
                            } else {
                                let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e562.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e601.unnamed.root, _e562.y), _e601.unnamed_1);
                                let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e562.z, _e607.unnamed_1.first_primitive));
                                phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e613.unnamed, lt_bvh_traverse_Tree(_e613.unnamed_1.root, _e562.w));
                            }
                            let _e621 = phi_1265_;
                            let _e631 = nodes.member[(0u + _e497)].y;
                            if (_e290 < 0f) {
                                let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e642.unnamed.root, _e631.w), _e642.unnamed_1);
                                let _e654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_bvh_traverse_Tree(_e631.x, _e648.unnamed_1.first_primitive));
                                phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e654.unnamed, lt_bvh_traverse_Tree(_e654.unnamed_1.root, _e631.y));
                            } else {
                                let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.unnamed.root, _e631.y), _e670.unnamed_1);
                                let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e631.z, _e676.unnamed_1.first_primitive));
                                phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_bvh_traverse_Tree(_e682.unnamed_1.root, _e631.w));
                            }
                            let _e690 = phi_1292_;
                            let _e700 = nodes.member[(0u + _e497)].z;
                            if (_e302 < 0f) {
                                let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e711.unnamed.root, _e700.w), _e711.unnamed_1);
                                let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_bvh_traverse_Tree(_e700.x, _e717.unnamed_1.first_primitive));
                                phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e723.unnamed, lt_bvh_traverse_Tree(_e723.unnamed_1.root, _e700.y));
                            } else {
                                let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e739.unnamed.root, _e700.y), _e739.unnamed_1);
                                let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e700.z, _e745.unnamed_1.first_primitive));
                                phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_bvh_traverse_Tree(_e751.unnamed_1.root, _e700.w));
                            }
                            let _e759 = phi_1319_;
                            phi_1325_ = 0u;
                            phi_1328_ = 0u;
                            loop {
                                let _e769 = phi_1325_;
                                let _e771 = phi_1328_;
                                local_5 = _e771;
                                local_6 = _e771;
                                local_7 = _e771;
                                let _e772 = (_e769 < 8u);
                                if _e772 {
                                    let _e774 = (_e769 >> bitcast<u32>(2i));
                                    let _e775 = (_e769 & 3u);
                                    if (_e774 == 0u) {
                                        phi_1342_ = _e621.unnamed.root;
                                    } else {
                                        phi_1342_ = _e621.unnamed.first_primitive;
                                    }
                                    let _e778 = phi_1342_;
                                    if (_e774 == 0u) {
                                        phi_1352_ = _e690.unnamed.root;
                                    } else {
                                        phi_1352_ = _e690.unnamed.first_primitive;
                                    }
                                    let _e787 = phi_1352_;
                                    if (_e774 == 0u) {
                                        phi_1362_ = _e759.unnamed.root;
                                    } else {
                                        phi_1362_ = _e759.unnamed.first_primitive;
                                    }
                                    let _e796 = phi_1362_;
                                    let _e809 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e778 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e531) + (_e552 - _e339)), ((f32(((_e787 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e532) + (_e553 - _e340)));
                                    let _e810 = core_intrinsics_maximum_number_nsz_f32_(_e809, ((f32(((_e796 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e533) + (_e554 - _e341)));
                                    if (_e774 == 0u) {
                                        phi_1380_ = _e621.unnamed_1.root;
                                    } else {
                                        phi_1380_ = _e621.unnamed_1.first_primitive;
                                    }
                                    let _e813 = phi_1380_;
                                    if (_e774 == 0u) {
                                        phi_1390_ = _e690.unnamed_1.root;
                                    } else {
                                        phi_1390_ = _e690.unnamed_1.first_primitive;
                                    }
                                    let _e822 = phi_1390_;
                                    if (_e774 == 0u) {
                                        phi_1400_ = _e759.unnamed_1.root;
                                    } else {
                                        phi_1400_ = _e759.unnamed_1.first_primitive;
                                    }
                                    let _e831 = phi_1400_;
                                    let _e844 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e813 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e531) + (_e552 + _e339)), ((f32(((_e822 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e532) + (_e553 + _e340)));
                                    let _e845 = core_intrinsics_minimum_number_nsz_f32_(_e844, ((f32(((_e831 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e533) + (_e554 + _e341)));
                                    if (_e810 <= _e845) {
                                        if (_e810 <= _e126.tmax) {
                                            if (_e845 >= _e126.tmin) {
                                                if (_e774 == 0u) {
                                                    let _e852 = nodes.member[(0u + _e497)].links[2u];
                                                    phi_1436_ = _e852;
                                                } else {
                                                    let _e855 = nodes.member[(0u + _e497)].links[3u];
                                                    phi_1436_ = _e855;
                                                }
                                                let _e857 = phi_1436_;
                                                let _e862 = ((_e857 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u);
                                                let _e863 = (_e862 & 31u);
                                                if (_e863 >= 24u) {
                                                    phi_1449_ = (24u + ((_e863 - 24u) ^ _e359));
                                                } else {
                                                    phi_1449_ = _e863;
                                                }
                                                let _e869 = phi_1449_;
                                                phi_1454_ = (_e771 | ((_e862 >> bitcast<u32>(5i)) << bitcast<u32>((_e869 & 31u))));
                                            } else {
                                                phi_1454_ = _e771;
                                            }
                                            let _e877 = phi_1454_;
                                            phi_1455_ = _e877;
                                        } else {
                                            phi_1455_ = _e771;
                                        }
                                        let _e879 = phi_1455_;
                                        phi_1456_ = _e879;
                                    } else {
                                        phi_1456_ = _e771;
                                    }
                                    let _e881 = phi_1456_;
                                    phi_1326_ = (_e769 + 1u);
                                    phi_1329_ = _e881;
                                } else {
                                    phi_1326_ = u32();
                                    phi_1329_ = u32();
                                }
                                let _e884 = phi_1326_;
                                let _e886 = phi_1329_;
                                continue;
                                continuing {
                                    phi_1325_ = _e884;
                                    phi_1328_ = _e886;
                                    break if !(_e772);
                                }
                            }
                            let _e890 = nodes.member[(0u + _e497)].links[0u];
                            let _e894 = nodes.member[(0u + _e497)].frame[3u];
                            let _e898 = local_5;
                            if ((_e898 & 4278190080u) == 0u) {
                            } else {
                                let _e902 = local_3.group_mask;
                                if ((_e902 & 4278190080u) == 0u) {
                                } else {
                                    let _e906 = local_3.len;
                                    if (_e906 < 32u) {
                                        let _e909 = local_3.group;
                                        let _e911 = local_3.len;
                                        if (_e911 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_3.first[(0u + _e911)] = _e909;
                                        let _e917 = local_3.group_mask;
                                        let _e919 = local_3.len;
                                        if (_e919 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_3.mask[(0u + _e919)] = _e917;
                                        let _e926 = local_3.len;
                                        local_3.len = (_e926 + 1u);
                                    }
                                }
                                local_3.group = (_e123 + _e890);
                                let _e930 = local_6;
                                local_3.group_mask = ((_e930 & 4278190080u) | (_e894 >> bitcast<u32>(24i)));
                            }
                            let _e935 = local_7;
                            phi_1514_ = (_e935 & 16777215u);
                            loop {
                                let _e938 = phi_1514_;
                                let _e939 = (_e938 == 0u);
                                local_13 = _e939;
                                local_20 = _e939;
                                if _e939 {
                                    phi_1515_ = u32();
                                    phi_3267_ = false;
                                } else {
                                    let _e942 = nodes.member[(0u + _e497)].links[1u];
                                    let _e946 = (_e942 + select(firstTrailingBit(_e938), 32u, (_e938 == 0u)));
                                    if (_e946 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e953 = instances.member[(0u + _e946)].low_world;
                                    let _e955 = instances.member[(0u + _e946)].high_world;
                                    let _e965 = ((_e953.x - _e126.origin.x) * _e278);
                                    let _e966 = ((_e953.y - _e126.origin.y) * _e290);
                                    let _e967 = ((_e953.z - _e126.origin.z) * _e302);
                                    let _e977 = ((_e955.x - _e126.origin.x) * _e278);
                                    let _e978 = ((_e955.y - _e126.origin.y) * _e290);
                                    let _e979 = ((_e955.z - _e126.origin.z) * _e302);
                                    if (_e965 < _e977) {
                                        phi_1570_ = _e965;
                                    } else {
                                        phi_1570_ = _e977;
                                    }
                                    let _e982 = phi_1570_;
                                    if (_e966 < _e978) {
                                        phi_1575_ = _e966;
                                    } else {
                                        phi_1575_ = _e978;
                                    }
                                    let _e985 = phi_1575_;
                                    if (_e967 < _e979) {
                                        phi_1580_ = _e967;
                                    } else {
                                        phi_1580_ = _e979;
                                    }
                                    let _e988 = phi_1580_;
                                    if (_e965 > _e977) {
                                        phi_1588_ = _e965;
                                    } else {
                                        phi_1588_ = _e977;
                                    }
                                    let _e994 = phi_1588_;
                                    if (_e966 > _e978) {
                                        phi_1593_ = _e966;
                                    } else {
                                        phi_1593_ = _e978;
                                    }
                                    let _e997 = phi_1593_;
                                    if (_e967 > _e979) {
                                        phi_1598_ = _e967;
                                    } else {
                                        phi_1598_ = _e979;
                                    }
                                    let _e1000 = phi_1598_;
                                    let _e1004 = core_intrinsics_maximum_number_nsz_f32_((_e982 - _e346), (_e985 - _e347));
                                    let _e1005 = core_intrinsics_maximum_number_nsz_f32_(_e1004, (_e988 - _e348));
                                    let _e1006 = core_intrinsics_minimum_number_nsz_f32_((_e994 + _e346), (_e997 + _e347));
                                    let _e1007 = core_intrinsics_minimum_number_nsz_f32_(_e1006, (_e1000 + _e348));
                                    if (_e1005 <= _e1007) {
                                        if (_e1005 <= _e126.tmax) {
                                            if (_e1007 >= _e126.tmin) {
                                                let _e1019 = instances.member[(0u + _e946)].world_to_object[0u];
                                                let _e1030 = ((((_e1019.x * _e126.origin.x) + (_e1019.y * _e126.origin.y)) + (_e1019.z * _e126.origin.z)) + (_e1019.w * 1f));
                                                let _e1032 = instances.member[(0u + _e946)].world_to_object[1u];
                                                let _e1043 = ((((_e1032.x * _e126.origin.x) + (_e1032.y * _e126.origin.y)) + (_e1032.z * _e126.origin.z)) + (_e1032.w * 1f));
                                                let _e1045 = instances.member[(0u + _e946)].world_to_object[2u];
                                                let _e1056 = ((((_e1045.x * _e126.origin.x) + (_e1045.y * _e126.origin.y)) + (_e1045.z * _e126.origin.z)) + (_e1045.w * 1f));
                                                let _e1063 = instances.member[(0u + _e946)].world_to_object[0u];
                                                let _e1074 = ((((_e1063.x * _e126.direction.x) + (_e1063.y * _e126.direction.y)) + (_e1063.z * _e126.direction.z)) + (_e1063.w * 0f));
                                                let _e1076 = instances.member[(0u + _e946)].world_to_object[1u];
                                                let _e1087 = ((((_e1076.x * _e126.direction.x) + (_e1076.y * _e126.direction.y)) + (_e1076.z * _e126.direction.z)) + (_e1076.w * 0f));
                                                let _e1089 = instances.member[(0u + _e946)].world_to_object[2u];
                                                let _e1100 = ((((_e1089.x * _e126.direction.x) + (_e1089.y * _e126.direction.y)) + (_e1089.z * _e126.direction.z)) + (_e1089.w * 0f));
                                                let _e1105 = instances.member[(0u + _e946)].root;
                                                let _e1107 = instances.member[(0u + _e946)].first_triangle;
                                                let _e1111 = abs(_e1074);
                                                let _e1112 = abs(_e1087);
                                                let _e1113 = abs(_e1100);
                                                if (abs(_e1030) < 1000000000000000f) {
                                                    if (abs(_e1043) < 1000000000000000f) {
                                                        if (abs(_e1056) < 1000000000000000f) {
                                                            if (_e1111 < 1000000000000000f) {
                                                                if (_e1112 < 1000000000000000f) {
                                                                    if (_e1113 < 1000000000000000f) {
                                                                        if (_e1111 > 0f) {
                                                                            phi_1755_ = bool();
                                                                            phi_1756_ = true;
                                                                        } else {
                                                                            let _e1121 = (_e1112 > 0f);
                                                                            if _e1121 {
                                                                                phi_1754_ = bool();
                                                                            } else {
                                                                                phi_1754_ = (_e1113 > 0f);
                                                                            }
                                                                            let _e1124 = phi_1754_;
                                                                            phi_1755_ = _e1124;
                                                                            phi_1756_ = _e1121;
                                                                        }
                                                                        let _e1126 = phi_1755_;
                                                                        let _e1128 = phi_1756_;
                                                                        if _e1128 {
                                                                            phi_1760_ = true;
                                                                        } else {
                                                                            phi_1760_ = _e1126;
                                                                        }
                                                                        let _e1130 = phi_1760_;
                                                                        phi_1761_ = _e1130;
                                                                        phi_1762_ = false;
                                                                    } else {
                                                                        phi_1761_ = bool();
                                                                        phi_1762_ = true;
                                                                    }
                                                                    let _e1132 = phi_1761_;
                                                                    let _e1134 = phi_1762_;
                                                                    phi_1763_ = _e1132;
                                                                    phi_1764_ = false;
                                                                    phi_1765_ = _e1134;
                                                                } else {
                                                                    phi_1763_ = bool();
                                                                    phi_1764_ = true;
                                                                    phi_1765_ = false;
                                                                }
                                                                let _e1136 = phi_1763_;
                                                                let _e1138 = phi_1764_;
                                                                let _e1140 = phi_1765_;
                                                                phi_1766_ = _e1136;
                                                                phi_1767_ = _e1138;
                                                                phi_1768_ = _e1140;
                                                            } else {
                                                                phi_1766_ = bool();
                                                                phi_1767_ = true;
                                                                phi_1768_ = false;
                                                            }
                                                            let _e1142 = phi_1766_;
                                                            let _e1144 = phi_1767_;
                                                            let _e1146 = phi_1768_;
                                                            phi_1769_ = _e1142;
                                                            phi_1770_ = _e1144;
                                                            phi_1771_ = _e1146;
                                                        } else {
                                                            phi_1769_ = bool();
                                                            phi_1770_ = true;
                                                            phi_1771_ = false;
                                                        }
                                                        let _e1148 = phi_1769_;
                                                        let _e1150 = phi_1770_;
                                                        let _e1152 = phi_1771_;
                                                        phi_1772_ = _e1148;
                                                        phi_1773_ = _e1150;
                                                        phi_1774_ = _e1152;
                                                    } else {
                                                        phi_1772_ = bool();
                                                        phi_1773_ = true;
                                                        phi_1774_ = false;
                                                    }
                                                    let _e1154 = phi_1772_;
                                                    let _e1156 = phi_1773_;
                                                    let _e1158 = phi_1774_;
                                                    phi_1775_ = _e1154;
                                                    phi_1776_ = _e1156;
                                                    phi_1777_ = _e1158;
                                                } else {
                                                    phi_1775_ = bool();
                                                    phi_1776_ = true;
                                                    phi_1777_ = false;
                                                }
                                                let _e1160 = phi_1775_;
                                                let _e1162 = phi_1776_;
                                                let _e1164 = phi_1777_;
                                                if _e1162 {
                                                    phi_1781_ = true;
                                                } else {
                                                    phi_1781_ = _e1164;
                                                }
                                                let _e1166 = phi_1781_;
                                                if _e1166 {
                                                    phi_1785_ = false;
                                                } else {
                                                    phi_1785_ = _e1160;
                                                }
                                                let _e1168 = phi_1785_;
                                                if _e1168 {
                                                    let _e1169 = (_e1105 >= _e76);
                                                    if _e1169 {
                                                        phi_3250_ = bool();
                                                    } else {
                                                        if (_e1105 < _e76) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1175 = nodes.member[(0u + _e1105)].frame[0u];
                                                        let _e1179 = nodes.member[(0u + _e1105)].frame[1u];
                                                        let _e1183 = nodes.member[(0u + _e1105)].frame[2u];
                                                        let _e1187 = nodes.member[(0u + _e1105)].frame[0u];
                                                        let _e1191 = nodes.member[(0u + _e1105)].frame[1u];
                                                        let _e1195 = nodes.member[(0u + _e1105)].frame[2u];
                                                        let _e1199 = nodes.member[(0u + _e1105)].frame[3u];
                                                        let _e1233 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1074), abs(_e1087));
                                                        let _e1234 = core_intrinsics_maximum_number_nsz_f32_(_e1233, abs(_e1100));
                                                        let _e1235 = (_e1234 * 0.0000000000009094947f);
                                                        if (abs(_e1074) < _e1235) {
                                                            phi_1855_ = _e1235;
                                                        } else {
                                                            phi_1855_ = abs(_e1074);
                                                        }
                                                        let _e1240 = phi_1855_;
                                                        if (_e1074 < 0f) {
                                                            phi_1862_ = (-1f / _e1240);
                                                        } else {
                                                            phi_1862_ = (1f / _e1240);
                                                        }
                                                        let _e1245 = phi_1862_;
                                                        if (abs(_e1087) < _e1235) {
                                                            phi_1869_ = _e1235;
                                                        } else {
                                                            phi_1869_ = abs(_e1087);
                                                        }
                                                        let _e1250 = phi_1869_;
                                                        if (_e1087 < 0f) {
                                                            phi_1876_ = (-1f / _e1250);
                                                        } else {
                                                            phi_1876_ = (1f / _e1250);
                                                        }
                                                        let _e1255 = phi_1876_;
                                                        if (abs(_e1100) < _e1235) {
                                                            phi_1883_ = _e1235;
                                                        } else {
                                                            phi_1883_ = abs(_e1100);
                                                        }
                                                        let _e1260 = phi_1883_;
                                                        if (_e1100 < 0f) {
                                                            phi_1890_ = (-1f / _e1260);
                                                        } else {
                                                            phi_1890_ = (1f / _e1260);
                                                        }
                                                        let _e1265 = phi_1890_;
                                                        let _e1269 = abs((bitcast<f32>(_e1175) - _e1030));
                                                        let _e1270 = abs((bitcast<f32>(_e1179) - _e1043));
                                                        let _e1271 = abs((bitcast<f32>(_e1183) - _e1056));
                                                        let _e1275 = abs(((bitcast<f32>(_e1187) + (bitcast<f32>((((_e1199 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1030));
                                                        let _e1276 = abs(((bitcast<f32>(_e1191) + (bitcast<f32>((((_e1199 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1043));
                                                        let _e1277 = abs(((bitcast<f32>(_e1195) + (bitcast<f32>((((_e1199 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1056));
                                                        if (_e1269 > _e1275) {
                                                            phi_1907_ = _e1269;
                                                        } else {
                                                            phi_1907_ = _e1275;
                                                        }
                                                        let _e1280 = phi_1907_;
                                                        if (_e1270 > _e1276) {
                                                            phi_1912_ = _e1270;
                                                        } else {
                                                            phi_1912_ = _e1276;
                                                        }
                                                        let _e1283 = phi_1912_;
                                                        if (_e1271 > _e1277) {
                                                            phi_1917_ = _e1271;
                                                        } else {
                                                            phi_1917_ = _e1277;
                                                        }
                                                        let _e1286 = phi_1917_;
                                                        let _e1287 = core_intrinsics_maximum_number_nsz_f32_(_e1280, _e1283);
                                                        let _e1288 = core_intrinsics_maximum_number_nsz_f32_(_e1287, _e1286);
                                                        let _e1292 = (_e1288 * 0.0000019073486f);
                                                        let _e1293 = (abs(_e1245) * _e1292);
                                                        let _e1294 = (abs(_e1255) * _e1292);
                                                        let _e1295 = (abs(_e1265) * _e1292);
                                                        let _e1299 = (_e1288 * 0.0000009536743f);
                                                        let _e1300 = (abs(_e1245) * _e1299);
                                                        let _e1301 = (abs(_e1255) * _e1299);
                                                        let _e1302 = (abs(_e1265) * _e1299);
                                                        let _e1303 = abs(_e1074);
                                                        let _e1304 = abs(_e1087);
                                                        let _e1305 = abs(_e1100);
                                                        if (_e1303 >= _e1304) {
                                                            if (_e1303 >= _e1305) {
                                                                phi_1945_ = false;
                                                            } else {
                                                                phi_1945_ = true;
                                                            }
                                                            let _e1309 = phi_1945_;
                                                            phi_1946_ = _e1309;
                                                        } else {
                                                            phi_1946_ = true;
                                                        }
                                                        let _e1311 = phi_1946_;
                                                        if _e1311 {
                                                            if (_e1304 >= _e1305) {
                                                                phi_1954_ = 1u;
                                                            } else {
                                                                phi_1954_ = 2u;
                                                            }
                                                            let _e1314 = phi_1954_;
                                                            phi_1955_ = _e1314;
                                                        } else {
                                                            phi_1955_ = 0u;
                                                        }
                                                        let _e1316 = phi_1955_;
                                                        if (_e1316 == 0u) {
                                                            phi_1967_ = vec3<f32>(_e1087, _e1100, _e1074);
                                                        } else {
                                                            if (_e1316 == 1u) {
                                                                phi_1966_ = vec3<f32>(_e1100, _e1074, _e1087);
                                                            } else {
                                                                phi_1966_ = vec3<f32>(_e1074, _e1087, _e1100);
                                                            }
                                                            let _e1322 = phi_1966_;
                                                            phi_1967_ = _e1322;
                                                        }
                                                        let _e1324 = phi_1967_;
                                                        let _e1327 = (_e1324.x / _e1324.z);
                                                        let _e1330 = (_e1324.y / _e1324.z);
                                                        let _e1332 = (1f / _e1324.z);
                                                        if (_e1245 < 0f) {
                                                            phi_1980_ = 0u;
                                                        } else {
                                                            phi_1980_ = 1u;
                                                        }
                                                        let _e1335 = phi_1980_;
                                                        if (_e1255 < 0f) {
                                                            phi_1985_ = 0u;
                                                        } else {
                                                            phi_1985_ = 2u;
                                                        }
                                                        let _e1338 = phi_1985_;
                                                        if (_e1265 < 0f) {
                                                            phi_1990_ = 0u;
                                                        } else {
                                                            phi_1990_ = 4u;
                                                        }
                                                        let _e1341 = phi_1990_;
                                                        let _e1343 = ((_e1335 | _e1338) | _e1341);
                                                        let _e1344 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1105, 2147483648u);
                                                        local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1344.first[0], _e1344.first[1], _e1344.first[2], _e1344.first[3], _e1344.first[4], _e1344.first[5], _e1344.first[6], _e1344.first[7], _e1344.first[8], _e1344.first[9], _e1344.first[10], _e1344.first[11], _e1344.first[12], _e1344.first[13], _e1344.first[14], _e1344.first[15], _e1344.first[16], _e1344.first[17], _e1344.first[18], _e1344.first[19], _e1344.first[20], _e1344.first[21], _e1344.first[22], _e1344.first[23], _e1344.first[24], _e1344.first[25], _e1344.first[26], _e1344.first[27], _e1344.first[28], _e1344.first[29], _e1344.first[30], _e1344.first[31]), array<u32, 32>(_e1344.mask[0], _e1344.mask[1], _e1344.mask[2], _e1344.mask[3], _e1344.mask[4], _e1344.mask[5], _e1344.mask[6], _e1344.mask[7], _e1344.mask[8], _e1344.mask[9], _e1344.mask[10], _e1344.mask[11], _e1344.mask[12], _e1344.mask[13], _e1344.mask[14], _e1344.mask[15], _e1344.mask[16], _e1344.mask[17], _e1344.mask[18], _e1344.mask[19], _e1344.mask[20], _e1344.mask[21], _e1344.mask[22], _e1344.mask[23], _e1344.mask[24], _e1344.mask[25], _e1344.mask[26], _e1344.mask[27], _e1344.mask[28], _e1344.mask[29], _e1344.mask[30], _e1344.mask[31]), _e1344.len, _e1344.group, _e1344.group_mask);
                                                        let _e1418 = local_2.group_mask;
                                                        if ((_e1418 & 4278190080u) == 0u) {
                                                            let _e1422 = local_2.len;
                                                            if (_e1422 == 0u) {
                                                                phi_2104_ = false;
                                                            } else {
                                                                let _e1426 = local_2.len;
                                                                local_2.len = (_e1426 - 1u);
                                                                let _e1429 = local_2.len;
                                                                if (_e1429 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1434 = local_2.first[(0u + _e1429)];
                                                                local_2.group = _e1434;
                                                                let _e1437 = local_2.len;
                                                                if (_e1437 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1442 = local_2.mask[(0u + _e1437)];
                                                                local_2.group_mask = _e1442;
                                                                phi_2104_ = true;
                                                            }
                                                            let _e1445 = phi_2104_;
                                                            phi_2105_ = _e1445;
                                                        } else {
                                                            phi_2105_ = true;
                                                        }
                                                        let _e1447 = phi_2105_;
                                                        if _e1447 {
                                                            let _e1449 = local_2.group_mask;
                                                            let _e1455 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1449)), 32u, (_e1449 == 0u)));
                                                            let _e1459 = local_2.group_mask;
                                                            let _e1473 = local_2.group_mask;
                                                            local_2.group_mask = (_e1473 & ~((1u << bitcast<u32>((_e1455 & 31u)))));
                                                            let _e1476 = local_2.group;
                                                            phi_2136_ = (_e1476 + countOneBits(((_e1459 & ~((4294967295u << bitcast<u32>((((_e1455 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_2136_ = 4294967295u;
                                                        }
                                                        let _e1479 = phi_2136_;
                                                        phi_2138_ = _e1479;
                                                        loop {
                                                            let _e1481 = phi_2138_;
                                                            if (_e1481 != 4294967295u) {
                                                                if (_e1481 < _e76) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1488 = nodes.member[(0u + _e1481)].frame[3u];
                                                                let _e1513 = (bitcast<f32>((((_e1488 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1245);
                                                                let _e1514 = (bitcast<f32>((((_e1488 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1255);
                                                                let _e1515 = (bitcast<f32>((((_e1488 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1265);
                                                                let _e1518 = nodes.member[(0u + _e1481)].frame[0u];
                                                                let _e1522 = nodes.member[(0u + _e1481)].frame[1u];
                                                                let _e1526 = nodes.member[(0u + _e1481)].frame[2u];
                                                                let _e1531 = ((bitcast<f32>(_e1518) - _e1030) * _e1245);
                                                                let _e1532 = ((bitcast<f32>(_e1522) - _e1043) * _e1255);
                                                                let _e1533 = ((bitcast<f32>(_e1526) - _e1056) * _e1265);
                                                                let _e1541 = nodes.member[(0u + _e1481)].x;
                                                                if (_e1245 < 0f) {
                                                                    let _e1552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1541.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1558 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1552.unnamed.root, _e1541.w), _e1552.unnamed_1);
                                                                    let _e1564 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1558.unnamed, lt_bvh_traverse_Tree(_e1541.x, _e1558.unnamed_1.first_primitive));
                                                                    phi_2219_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1564.unnamed, lt_bvh_traverse_Tree(_e1564.unnamed_1.root, _e1541.y));
                                                                } else {
                                                                    let _e1580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1541.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1580.unnamed.root, _e1541.y), _e1580.unnamed_1);
                                                                    let _e1592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1586.unnamed, lt_bvh_traverse_Tree(_e1541.z, _e1586.unnamed_1.first_primitive));
                                                                    phi_2219_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1592.unnamed, lt_bvh_traverse_Tree(_e1592.unnamed_1.root, _e1541.w));
                                                                }
                                                                let _e1600 = phi_2219_;
                                                                let _e1610 = nodes.member[(0u + _e1481)].y;
                                                                if (_e1255 < 0f) {
                                                                    let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1610.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1621.unnamed.root, _e1610.w), _e1621.unnamed_1);
                                                                    let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_bvh_traverse_Tree(_e1610.x, _e1627.unnamed_1.first_primitive));
                                                                    phi_2246_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1633.unnamed, lt_bvh_traverse_Tree(_e1633.unnamed_1.root, _e1610.y));
                                                                } else {
                                                                    let _e1649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1610.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1649.unnamed.root, _e1610.y), _e1649.unnamed_1);
                                                                    let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1655.unnamed, lt_bvh_traverse_Tree(_e1610.z, _e1655.unnamed_1.first_primitive));
                                                                    phi_2246_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1661.unnamed, lt_bvh_traverse_Tree(_e1661.unnamed_1.root, _e1610.w));
                                                                }
                                                                let _e1669 = phi_2246_;
                                                                let _e1679 = nodes.member[(0u + _e1481)].z;
                                                                if (_e1265 < 0f) {
                                                                    let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1679.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1690.unnamed.root, _e1679.w), _e1690.unnamed_1);
                                                                    let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_bvh_traverse_Tree(_e1679.x, _e1696.unnamed_1.first_primitive));
                                                                    phi_2273_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1702.unnamed, lt_bvh_traverse_Tree(_e1702.unnamed_1.root, _e1679.y));
                                                                } else {
                                                                    let _e1718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1679.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1718.unnamed.root, _e1679.y), _e1718.unnamed_1);
                                                                    let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1724.unnamed, lt_bvh_traverse_Tree(_e1679.z, _e1724.unnamed_1.first_primitive));
                                                                    phi_2273_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1730.unnamed, lt_bvh_traverse_Tree(_e1730.unnamed_1.root, _e1679.w));
                                                                }
                                                                let _e1738 = phi_2273_;
                                                                phi_2279_ = 0u;
                                                                phi_2282_ = 0u;
                                                                loop {
                                                                    let _e1748 = phi_2279_;
                                                                    let _e1750 = phi_2282_;
                                                                    local_8 = _e1750;
                                                                    local_9 = _e1750;
                                                                    local_10 = _e1750;
                                                                    let _e1751 = (_e1748 < 8u);
                                                                    if _e1751 {
                                                                        let _e1753 = (_e1748 >> bitcast<u32>(2i));
                                                                        let _e1754 = (_e1748 & 3u);
                                                                        if (_e1753 == 0u) {
                                                                            phi_2296_ = _e1600.unnamed.root;
                                                                        } else {
                                                                            phi_2296_ = _e1600.unnamed.first_primitive;
                                                                        }
                                                                        let _e1757 = phi_2296_;
                                                                        if (_e1753 == 0u) {
                                                                            phi_2306_ = _e1669.unnamed.root;
                                                                        } else {
                                                                            phi_2306_ = _e1669.unnamed.first_primitive;
                                                                        }
                                                                        let _e1766 = phi_2306_;
                                                                        if (_e1753 == 0u) {
                                                                            phi_2316_ = _e1738.unnamed.root;
                                                                        } else {
                                                                            phi_2316_ = _e1738.unnamed.first_primitive;
                                                                        }
                                                                        let _e1775 = phi_2316_;
                                                                        let _e1788 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1757 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u)) * _e1513) + (_e1531 - _e1293)), ((f32(((_e1766 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u)) * _e1514) + (_e1532 - _e1294)));
                                                                        let _e1789 = core_intrinsics_maximum_number_nsz_f32_(_e1788, ((f32(((_e1775 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u)) * _e1515) + (_e1533 - _e1295)));
                                                                        if (_e1753 == 0u) {
                                                                            phi_2334_ = _e1600.unnamed_1.root;
                                                                        } else {
                                                                            phi_2334_ = _e1600.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1792 = phi_2334_;
                                                                        if (_e1753 == 0u) {
                                                                            phi_2344_ = _e1669.unnamed_1.root;
                                                                        } else {
                                                                            phi_2344_ = _e1669.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1801 = phi_2344_;
                                                                        if (_e1753 == 0u) {
                                                                            phi_2354_ = _e1738.unnamed_1.root;
                                                                        } else {
                                                                            phi_2354_ = _e1738.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1810 = phi_2354_;
                                                                        let _e1823 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1792 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u)) * _e1513) + (_e1531 + _e1293)), ((f32(((_e1801 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u)) * _e1514) + (_e1532 + _e1294)));
                                                                        let _e1824 = core_intrinsics_minimum_number_nsz_f32_(_e1823, ((f32(((_e1810 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u)) * _e1515) + (_e1533 + _e1295)));
                                                                        if (_e1789 <= _e1824) {
                                                                            if (_e1789 <= _e126.tmax) {
                                                                                if (_e1824 >= _e126.tmin) {
                                                                                    if (_e1753 == 0u) {
                                                                                        let _e1831 = nodes.member[(0u + _e1481)].links[2u];
                                                                                        phi_2390_ = _e1831;
                                                                                    } else {
                                                                                        let _e1834 = nodes.member[(0u + _e1481)].links[3u];
                                                                                        phi_2390_ = _e1834;
                                                                                    }
                                                                                    let _e1836 = phi_2390_;
                                                                                    let _e1841 = ((_e1836 >> bitcast<u32>(((_e1754 * 8u) & 31u))) & 255u);
                                                                                    let _e1842 = (_e1841 & 31u);
                                                                                    if (_e1842 >= 24u) {
                                                                                        phi_2403_ = (24u + ((_e1842 - 24u) ^ _e1343));
                                                                                    } else {
                                                                                        phi_2403_ = _e1842;
                                                                                    }
                                                                                    let _e1848 = phi_2403_;
                                                                                    phi_2408_ = (_e1750 | ((_e1841 >> bitcast<u32>(5i)) << bitcast<u32>((_e1848 & 31u))));
                                                                                } else {
                                                                                    phi_2408_ = _e1750;
                                                                                }
                                                                                let _e1856 = phi_2408_;
                                                                                phi_2409_ = _e1856;
                                                                            } else {
                                                                                phi_2409_ = _e1750;
                                                                            }
                                                                            let _e1858 = phi_2409_;
                                                                            phi_2410_ = _e1858;
                                                                        } else {
                                                                            phi_2410_ = _e1750;
                                                                        }
                                                                        let _e1860 = phi_2410_;
                                                                        phi_2280_ = (_e1748 + 1u);
                                                                        phi_2283_ = _e1860;
                                                                    } else {
                                                                        phi_2280_ = u32();
                                                                        phi_2283_ = u32();
                                                                    }
                                                                    let _e1863 = phi_2280_;
                                                                    let _e1865 = phi_2283_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2279_ = _e1863;
                                                                        phi_2282_ = _e1865;
                                                                        break if !(_e1751);
                                                                    }
                                                                }
                                                                let _e1869 = nodes.member[(0u + _e1481)].links[0u];
                                                                let _e1873 = nodes.member[(0u + _e1481)].frame[3u];
                                                                let _e1877 = local_8;
                                                                if ((_e1877 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1881 = local_2.group_mask;
                                                                    if ((_e1881 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1885 = local_2.len;
                                                                        if (_e1885 < 32u) {
                                                                            let _e1888 = local_2.group;
                                                                            let _e1890 = local_2.len;
                                                                            if (_e1890 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_2.first[(0u + _e1890)] = _e1888;
                                                                            let _e1896 = local_2.group_mask;
                                                                            let _e1898 = local_2.len;
                                                                            if (_e1898 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_2.mask[(0u + _e1898)] = _e1896;
                                                                            let _e1905 = local_2.len;
                                                                            local_2.len = (_e1905 + 1u);
                                                                        }
                                                                    }
                                                                    local_2.group = (_e1105 + _e1869);
                                                                    let _e1909 = local_9;
                                                                    local_2.group_mask = ((_e1909 & 4278190080u) | (_e1873 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1914 = local_10;
                                                                phi_2468_ = (_e1914 & 16777215u);
                                                                loop {
                                                                    let _e1917 = phi_2468_;
                                                                    let _e1918 = (_e1917 == 0u);
                                                                    local_11 = _e1918;
                                                                    local_17 = _e1918;
                                                                    if _e1918 {
                                                                        phi_2469_ = u32();
                                                                        phi_3153_ = false;
                                                                        phi_3154_ = false;
                                                                        phi_3155_ = false;
                                                                    } else {
                                                                        let _e1921 = nodes.member[(0u + _e1481)].links[1u];
                                                                        let _e1926 = ((_e1107 + _e1921) + select(firstTrailingBit(_e1917), 32u, (_e1917 == 0u)));
                                                                        if (_e1926 < _e79) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1933 = triangles.member[(0u + _e1926)].v0_;
                                                                        let _e1935 = (_e1933.x - _e1030);
                                                                        let _e1937 = (_e1933.y - _e1043);
                                                                        let _e1939 = (_e1933.z - _e1056);
                                                                        if (_e1316 == 0u) {
                                                                            phi_2514_ = vec3<f32>(_e1937, _e1939, _e1935);
                                                                        } else {
                                                                            if (_e1316 == 1u) {
                                                                                phi_2513_ = vec3<f32>(_e1939, _e1935, _e1937);
                                                                            } else {
                                                                                phi_2513_ = (_e1933 - vec3<f32>(_e1030, _e1043, _e1056));
                                                                            }
                                                                            let _e1947 = phi_2513_;
                                                                            phi_2514_ = _e1947;
                                                                        }
                                                                        let _e1949 = phi_2514_;
                                                                        let _e1953 = (_e1949.x - (_e1327 * _e1949.z));
                                                                        let _e1957 = (_e1949.y - (_e1330 * _e1949.z));
                                                                        let _e1961 = triangles.member[(0u + _e1926)].v1_;
                                                                        let _e1963 = (_e1961.x - _e1030);
                                                                        let _e1965 = (_e1961.y - _e1043);
                                                                        let _e1967 = (_e1961.z - _e1056);
                                                                        if (_e1316 == 0u) {
                                                                            phi_2546_ = vec3<f32>(_e1965, _e1967, _e1963);
                                                                        } else {
                                                                            if (_e1316 == 1u) {
                                                                                phi_2545_ = vec3<f32>(_e1967, _e1963, _e1965);
                                                                            } else {
                                                                                phi_2545_ = (_e1961 - vec3<f32>(_e1030, _e1043, _e1056));
                                                                            }
                                                                            let _e1975 = phi_2545_;
                                                                            phi_2546_ = _e1975;
                                                                        }
                                                                        let _e1977 = phi_2546_;
                                                                        let _e1981 = (_e1977.x - (_e1327 * _e1977.z));
                                                                        let _e1985 = (_e1977.y - (_e1330 * _e1977.z));
                                                                        let _e1989 = triangles.member[(0u + _e1926)].v2_;
                                                                        let _e1991 = (_e1989.x - _e1030);
                                                                        let _e1993 = (_e1989.y - _e1043);
                                                                        let _e1995 = (_e1989.z - _e1056);
                                                                        if (_e1316 == 0u) {
                                                                            phi_2578_ = vec3<f32>(_e1993, _e1995, _e1991);
                                                                        } else {
                                                                            if (_e1316 == 1u) {
                                                                                phi_2577_ = vec3<f32>(_e1995, _e1991, _e1993);
                                                                            } else {
                                                                                phi_2577_ = (_e1989 - vec3<f32>(_e1030, _e1043, _e1056));
                                                                            }
                                                                            let _e2003 = phi_2577_;
                                                                            phi_2578_ = _e2003;
                                                                        }
                                                                        let _e2005 = phi_2578_;
                                                                        let _e2009 = (_e2005.x - (_e1327 * _e2005.z));
                                                                        let _e2013 = (_e2005.y - (_e1330 * _e2005.z));
                                                                        if (_e1981 < _e2009) {
                                                                            phi_2599_ = true;
                                                                        } else {
                                                                            if (_e1981 == _e2009) {
                                                                                phi_2598_ = (_e1985 < _e2013);
                                                                            } else {
                                                                                phi_2598_ = false;
                                                                            }
                                                                            let _e2020 = phi_2598_;
                                                                            phi_2599_ = _e2020;
                                                                        }
                                                                        let _e2022 = phi_2599_;
                                                                        if _e2022 {
                                                                            phi_2603_ = _e2013;
                                                                            phi_2604_ = _e2009;
                                                                            phi_2605_ = _e1985;
                                                                            phi_2606_ = _e1981;
                                                                        } else {
                                                                            phi_2603_ = _e1985;
                                                                            phi_2604_ = _e1981;
                                                                            phi_2605_ = _e2013;
                                                                            phi_2606_ = _e2009;
                                                                        }
                                                                        let _e2024 = phi_2603_;
                                                                        let _e2026 = phi_2604_;
                                                                        let _e2028 = phi_2605_;
                                                                        let _e2030 = phi_2606_;
                                                                        let _e2033 = ((_e2030 * _e2024) - (_e2028 * _e2026));
                                                                        if _e2022 {
                                                                            phi_2614_ = -(_e2033);
                                                                        } else {
                                                                            phi_2614_ = _e2033;
                                                                        }
                                                                        let _e2036 = phi_2614_;
                                                                        if (_e2009 < _e1953) {
                                                                            phi_2625_ = true;
                                                                        } else {
                                                                            if (_e2009 == _e1953) {
                                                                                phi_2624_ = (_e2013 < _e1957);
                                                                            } else {
                                                                                phi_2624_ = false;
                                                                            }
                                                                            let _e2041 = phi_2624_;
                                                                            phi_2625_ = _e2041;
                                                                        }
                                                                        let _e2043 = phi_2625_;
                                                                        if _e2043 {
                                                                            phi_2629_ = _e1957;
                                                                            phi_2630_ = _e1953;
                                                                            phi_2631_ = _e2013;
                                                                            phi_2632_ = _e2009;
                                                                        } else {
                                                                            phi_2629_ = _e2013;
                                                                            phi_2630_ = _e2009;
                                                                            phi_2631_ = _e1957;
                                                                            phi_2632_ = _e1953;
                                                                        }
                                                                        let _e2045 = phi_2629_;
                                                                        let _e2047 = phi_2630_;
                                                                        let _e2049 = phi_2631_;
                                                                        let _e2051 = phi_2632_;
                                                                        let _e2054 = ((_e2051 * _e2045) - (_e2049 * _e2047));
                                                                        if _e2043 {
                                                                            phi_2640_ = -(_e2054);
                                                                        } else {
                                                                            phi_2640_ = _e2054;
                                                                        }
                                                                        let _e2057 = phi_2640_;
                                                                        if (_e1953 < _e1981) {
                                                                            phi_2651_ = true;
                                                                        } else {
                                                                            if (_e1953 == _e1981) {
                                                                                phi_2650_ = (_e1957 < _e1985);
                                                                            } else {
                                                                                phi_2650_ = false;
                                                                            }
                                                                            let _e2062 = phi_2650_;
                                                                            phi_2651_ = _e2062;
                                                                        }
                                                                        let _e2064 = phi_2651_;
                                                                        if _e2064 {
                                                                            phi_2655_ = _e1985;
                                                                            phi_2656_ = _e1981;
                                                                            phi_2657_ = _e1957;
                                                                            phi_2658_ = _e1953;
                                                                        } else {
                                                                            phi_2655_ = _e1957;
                                                                            phi_2656_ = _e1953;
                                                                            phi_2657_ = _e1985;
                                                                            phi_2658_ = _e1981;
                                                                        }
                                                                        let _e2066 = phi_2655_;
                                                                        let _e2068 = phi_2656_;
                                                                        let _e2070 = phi_2657_;
                                                                        let _e2072 = phi_2658_;
                                                                        let _e2075 = ((_e2072 * _e2066) - (_e2070 * _e2068));
                                                                        if _e2064 {
                                                                            phi_2666_ = -(_e2075);
                                                                        } else {
                                                                            phi_2666_ = _e2075;
                                                                        }
                                                                        let _e2078 = phi_2666_;
                                                                        if (_e2036 >= 0f) {
                                                                            if (_e2057 >= 0f) {
                                                                                if (_e2078 >= 0f) {
                                                                                    phi_2681_ = ((_e2036 + _e2057) + _e2078);
                                                                                    phi_2682_ = false;
                                                                                } else {
                                                                                    phi_2681_ = f32();
                                                                                    phi_2682_ = true;
                                                                                }
                                                                                let _e2085 = phi_2681_;
                                                                                let _e2087 = phi_2682_;
                                                                                phi_2683_ = _e2085;
                                                                                phi_2684_ = _e2087;
                                                                            } else {
                                                                                phi_2683_ = f32();
                                                                                phi_2684_ = true;
                                                                            }
                                                                            let _e2089 = phi_2683_;
                                                                            let _e2091 = phi_2684_;
                                                                            phi_2685_ = _e2089;
                                                                            phi_2686_ = _e2091;
                                                                        } else {
                                                                            phi_2685_ = f32();
                                                                            phi_2686_ = true;
                                                                        }
                                                                        let _e2093 = phi_2685_;
                                                                        let _e2095 = phi_2686_;
                                                                        if _e2095 {
                                                                            if (_e2036 <= 0f) {
                                                                                if (_e2057 <= 0f) {
                                                                                    let _e2098 = (_e2078 <= 0f);
                                                                                    if _e2098 {
                                                                                    }
                                                                                    phi_2704_ = ((_e2036 + _e2057) + _e2078);
                                                                                    phi_2705_ = false;
                                                                                    phi_2706_ = _e2098;
                                                                                } else {
                                                                                    phi_2704_ = f32();
                                                                                    phi_2705_ = true;
                                                                                    phi_2706_ = false;
                                                                                }
                                                                                let _e2102 = phi_2704_;
                                                                                let _e2104 = phi_2705_;
                                                                                let _e2106 = phi_2706_;
                                                                                phi_2707_ = _e2102;
                                                                                phi_2708_ = _e2104;
                                                                                phi_2709_ = _e2106;
                                                                            } else {
                                                                                phi_2707_ = f32();
                                                                                phi_2708_ = true;
                                                                                phi_2709_ = false;
                                                                            }
                                                                            let _e2108 = phi_2707_;
                                                                            let _e2110 = phi_2708_;
                                                                            let _e2112 = phi_2709_;
                                                                            if _e2110 {
                                                                                phi_2713_ = false;
                                                                            } else {
                                                                                phi_2713_ = _e2112;
                                                                            }
                                                                            let _e2114 = phi_2713_;
                                                                            phi_2714_ = _e2108;
                                                                            phi_2715_ = _e2114;
                                                                        } else {
                                                                            phi_2714_ = _e2093;
                                                                            phi_2715_ = true;
                                                                        }
                                                                        let _e2116 = phi_2714_;
                                                                        let _e2118 = phi_2715_;
                                                                        if _e2118 {
                                                                            let _e2119 = (_e2116 == 0f);
                                                                            if _e2119 {
                                                                                phi_2913_ = lt_bvh_triangle_Intersection();
                                                                            } else {
                                                                                let _e2125 = ((((_e2036 * (_e1332 * _e1949.z)) + (_e2057 * (_e1332 * _e1977.z))) + (_e2078 * (_e1332 * _e2005.z))) / _e2116);
                                                                                let _e2127 = triangles.member[(0u + _e1926)].v0_;
                                                                                let _e2129 = triangles.member[(0u + _e1926)].v1_;
                                                                                if (_e2127.x < _e2129.x) {
                                                                                    phi_2741_ = _e2127.x;
                                                                                } else {
                                                                                    phi_2741_ = _e2129.x;
                                                                                }
                                                                                let _e2136 = phi_2741_;
                                                                                if (_e2127.y < _e2129.y) {
                                                                                    phi_2750_ = _e2127.y;
                                                                                } else {
                                                                                    phi_2750_ = _e2129.y;
                                                                                }
                                                                                let _e2143 = phi_2750_;
                                                                                if (_e2127.z < _e2129.z) {
                                                                                    phi_2759_ = _e2127.z;
                                                                                } else {
                                                                                    phi_2759_ = _e2129.z;
                                                                                }
                                                                                let _e2150 = phi_2759_;
                                                                                let _e2152 = triangles.member[(0u + _e1926)].v2_;
                                                                                if (_e2136 < _e2152.x) {
                                                                                    phi_2768_ = _e2136;
                                                                                } else {
                                                                                    phi_2768_ = _e2152.x;
                                                                                }
                                                                                let _e2157 = phi_2768_;
                                                                                if (_e2143 < _e2152.y) {
                                                                                    phi_2775_ = _e2143;
                                                                                } else {
                                                                                    phi_2775_ = _e2152.y;
                                                                                }
                                                                                let _e2162 = phi_2775_;
                                                                                if (_e2150 < _e2152.z) {
                                                                                    phi_2782_ = _e2150;
                                                                                } else {
                                                                                    phi_2782_ = _e2152.z;
                                                                                }
                                                                                let _e2167 = phi_2782_;
                                                                                let _e2169 = triangles.member[(0u + _e1926)].v0_;
                                                                                let _e2171 = triangles.member[(0u + _e1926)].v1_;
                                                                                if (_e2169.x > _e2171.x) {
                                                                                    phi_2795_ = _e2169.x;
                                                                                } else {
                                                                                    phi_2795_ = _e2171.x;
                                                                                }
                                                                                let _e2178 = phi_2795_;
                                                                                if (_e2169.y > _e2171.y) {
                                                                                    phi_2804_ = _e2169.y;
                                                                                } else {
                                                                                    phi_2804_ = _e2171.y;
                                                                                }
                                                                                let _e2185 = phi_2804_;
                                                                                if (_e2169.z > _e2171.z) {
                                                                                    phi_2813_ = _e2169.z;
                                                                                } else {
                                                                                    phi_2813_ = _e2171.z;
                                                                                }
                                                                                let _e2192 = phi_2813_;
                                                                                let _e2194 = triangles.member[(0u + _e1926)].v2_;
                                                                                if (_e2178 > _e2194.x) {
                                                                                    phi_2822_ = _e2178;
                                                                                } else {
                                                                                    phi_2822_ = _e2194.x;
                                                                                }
                                                                                let _e2199 = phi_2822_;
                                                                                if (_e2185 > _e2194.y) {
                                                                                    phi_2829_ = _e2185;
                                                                                } else {
                                                                                    phi_2829_ = _e2194.y;
                                                                                }
                                                                                let _e2204 = phi_2829_;
                                                                                if (_e2192 > _e2194.z) {
                                                                                    phi_2836_ = _e2192;
                                                                                } else {
                                                                                    phi_2836_ = _e2194.z;
                                                                                }
                                                                                let _e2209 = phi_2836_;
                                                                                let _e2213 = ((_e2157 - _e1030) * _e1245);
                                                                                let _e2214 = ((_e2162 - _e1043) * _e1255);
                                                                                let _e2215 = ((_e2167 - _e1056) * _e1265);
                                                                                let _e2219 = ((_e2199 - _e1030) * _e1245);
                                                                                let _e2220 = ((_e2204 - _e1043) * _e1255);
                                                                                let _e2221 = ((_e2209 - _e1056) * _e1265);
                                                                                if (_e2213 < _e2219) {
                                                                                    phi_2853_ = _e2213;
                                                                                } else {
                                                                                    phi_2853_ = _e2219;
                                                                                }
                                                                                let _e2224 = phi_2853_;
                                                                                if (_e2214 < _e2220) {
                                                                                    phi_2858_ = _e2214;
                                                                                } else {
                                                                                    phi_2858_ = _e2220;
                                                                                }
                                                                                let _e2227 = phi_2858_;
                                                                                if (_e2215 < _e2221) {
                                                                                    phi_2863_ = _e2215;
                                                                                } else {
                                                                                    phi_2863_ = _e2221;
                                                                                }
                                                                                let _e2230 = phi_2863_;
                                                                                if (_e2213 > _e2219) {
                                                                                    phi_2871_ = _e2213;
                                                                                } else {
                                                                                    phi_2871_ = _e2219;
                                                                                }
                                                                                let _e2236 = phi_2871_;
                                                                                if (_e2214 > _e2220) {
                                                                                    phi_2876_ = _e2214;
                                                                                } else {
                                                                                    phi_2876_ = _e2220;
                                                                                }
                                                                                let _e2239 = phi_2876_;
                                                                                if (_e2215 > _e2221) {
                                                                                    phi_2881_ = _e2215;
                                                                                } else {
                                                                                    phi_2881_ = _e2221;
                                                                                }
                                                                                let _e2242 = phi_2881_;
                                                                                let _e2246 = core_intrinsics_maximum_number_nsz_f32_((_e2224 - _e1300), (_e2227 - _e1301));
                                                                                let _e2247 = core_intrinsics_maximum_number_nsz_f32_(_e2246, (_e2230 - _e1302));
                                                                                let _e2248 = core_intrinsics_minimum_number_nsz_f32_((_e2236 + _e1300), (_e2239 + _e1301));
                                                                                let _e2249 = core_intrinsics_minimum_number_nsz_f32_(_e2248, (_e2242 + _e1302));
                                                                                if (_e2247 > _e1005) {
                                                                                    phi_2893_ = _e2247;
                                                                                } else {
                                                                                    phi_2893_ = _e1005;
                                                                                }
                                                                                let _e2252 = phi_2893_;
                                                                                if (_e2249 < _e1007) {
                                                                                    phi_2898_ = _e2249;
                                                                                } else {
                                                                                    phi_2898_ = _e1007;
                                                                                }
                                                                                let _e2255 = phi_2898_;
                                                                                if (_e2125 < _e2252) {
                                                                                    phi_2903_ = _e2252;
                                                                                } else {
                                                                                    phi_2903_ = _e2125;
                                                                                }
                                                                                let _e2258 = phi_2903_;
                                                                                if (_e2258 > _e2255) {
                                                                                    phi_2908_ = _e2255;
                                                                                } else {
                                                                                    phi_2908_ = _e2258;
                                                                                }
                                                                                let _e2261 = phi_2908_;
                                                                                phi_2913_ = lt_bvh_triangle_Intersection(_e2261, (_e2057 / _e2116), (_e2078 / _e2116), (_e2252 <= _e2255));
                                                                            }
                                                                            let _e2267 = phi_2913_;
                                                                            phi_2914_ = _e2267;
                                                                            phi_2915_ = _e2119;
                                                                        } else {
                                                                            phi_2914_ = lt_bvh_triangle_Intersection();
                                                                            phi_2915_ = true;
                                                                        }
                                                                        let _e2269 = phi_2914_;
                                                                        let _e2271 = phi_2915_;
                                                                        if _e2271 {
                                                                            phi_2919_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2919_ = _e2269;
                                                                        }
                                                                        let _e2273 = phi_2919_;
                                                                        if _e2273.is_hit {
                                                                            if (_e2273.t > _e126.tmin) {
                                                                                if (_e2273.t < _e126.tmax) {
                                                                                    let _e2280 = triangles.member[(0u + _e1926)].i0_;
                                                                                    let _e2282 = ((_e2280 & 2147483648u) == 0u);
                                                                                    if _e2282 {
                                                                                        phi_3137_ = false;
                                                                                        phi_3138_ = false;
                                                                                    } else {
                                                                                        if (_e1926 < _e79) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2289 = triangles.member[(0u + _e1926)].i0_;
                                                                                        let _e2290 = (_e2289 & 2147483647u);
                                                                                        let _e2292 = triangles.member[(0u + _e1926)].i1_;
                                                                                        let _e2294 = triangles.member[(0u + _e1926)].i2_;
                                                                                        if (_e2290 < _e88) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2298 = vertices.member[(0u + _e2290)];
                                                                                        if (_e2292 < _e88) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2302 = vertices.member[(0u + _e2292)];
                                                                                        if (_e2294 < _e88) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2306 = vertices.member[(0u + _e2294)];
                                                                                        let _e2307 = array<abi_Vertex, 3>(_e2298, _e2302, _e2306);
                                                                                        local_1 = array<abi_Vertex, 3>(abi_Vertex(_e2307[0].u, _e2307[0].v, _e2307[0].normal, _e2307[0].color, _e2307[0].material), abi_Vertex(_e2307[1].u, _e2307[1].v, _e2307[1].normal, _e2307[1].color, _e2307[1].material), abi_Vertex(_e2307[2].u, _e2307[2].v, _e2307[2].normal, _e2307[2].color, _e2307[2].material));
                                                                                        let _e2332 = local_1[0u].material;
                                                                                        if (_e2332 < arrayLength((&materials.member))) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2336 = materials.member[(0u + _e2332)];
                                                                                        if ((_e2336.flags & 1u) == 1u) {
                                                                                            let _e2340 = lt_shaders_surface_barycentric_weights(_e2273.u, _e2273.v);
                                                                                            if (_e2336.cutoff <= 0f) {
                                                                                                phi_3131_ = true;
                                                                                            } else {
                                                                                                let _e2345 = lt_shaders_surface_vertex_color((&local_1), _e2340);
                                                                                                let _e2347 = (_e2336.base_color.w * _e2345.w);
                                                                                                if (_e2336.alpha_size == 0u) {
                                                                                                    phi_3128_ = _e2347;
                                                                                                } else {
                                                                                                    local.offset = _e2336.alpha_offset;
                                                                                                    local.size = _e2336.alpha_size;
                                                                                                    local.flags = _e2336.flags;
                                                                                                    let _e2356 = lt_shaders_surface_texture_coordinate((&local_1), _e2340);
                                                                                                    let _e2359 = _lt_shaders_texture_TextureView_quad((&local), _e2356.x, _e2356.y);
                                                                                                    let _e2363 = (_e2359.indices[0] >> bitcast<u32>(2i));
                                                                                                    if (_e2363 < _e94) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2367 = alpha_texels.member[(0u + _e2363)];
                                                                                                    let _e2383 = (_e2359.indices[1] >> bitcast<u32>(2i));
                                                                                                    if (_e2383 < _e94) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2387 = alpha_texels.member[(0u + _e2383)];
                                                                                                    let _e2404 = (_e2359.indices[2] >> bitcast<u32>(2i));
                                                                                                    if (_e2404 < _e94) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2408 = alpha_texels.member[(0u + _e2404)];
                                                                                                    let _e2425 = (_e2359.indices[3] >> bitcast<u32>(2i));
                                                                                                    if (_e2425 < _e94) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2429 = alpha_texels.member[(0u + _e2425)];
                                                                                                    phi_3128_ = (_e2347 * (((((f32(((_e2367 >> bitcast<u32>((((_e2359.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2359.weights.x) + ((f32(((_e2387 >> bitcast<u32>((((_e2359.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2359.weights.y)) + ((f32(((_e2408 >> bitcast<u32>((((_e2359.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2359.weights.z)) + ((f32(((_e2429 >> bitcast<u32>((((_e2359.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2359.weights.w)));
                                                                                                }
                                                                                                let _e2445 = phi_3128_;
                                                                                                phi_3131_ = (_e2445 >= _e2336.cutoff);
                                                                                            }
                                                                                            let _e2449 = phi_3131_;
                                                                                            phi_3132_ = _e2449;
                                                                                        } else {
                                                                                            phi_3132_ = false;
                                                                                        }
                                                                                        let _e2451 = phi_3132_;
                                                                                        if _e2451 {
                                                                                            phi_3136_ = false;
                                                                                        } else {
                                                                                            phi_3136_ = true;
                                                                                        }
                                                                                        let _e2453 = phi_3136_;
                                                                                        phi_3137_ = _e2453;
                                                                                        phi_3138_ = _e2451;
                                                                                    }
                                                                                    let _e2455 = phi_3137_;
                                                                                    let _e2457 = phi_3138_;
                                                                                    phi_3139_ = _e2455;
                                                                                    phi_3140_ = _e2282;
                                                                                    phi_3141_ = _e2457;
                                                                                } else {
                                                                                    phi_3139_ = true;
                                                                                    phi_3140_ = false;
                                                                                    phi_3141_ = false;
                                                                                }
                                                                                let _e2459 = phi_3139_;
                                                                                let _e2461 = phi_3140_;
                                                                                let _e2463 = phi_3141_;
                                                                                phi_3142_ = _e2459;
                                                                                phi_3143_ = _e2461;
                                                                                phi_3144_ = _e2463;
                                                                            } else {
                                                                                phi_3142_ = true;
                                                                                phi_3143_ = false;
                                                                                phi_3144_ = false;
                                                                            }
                                                                            let _e2465 = phi_3142_;
                                                                            let _e2467 = phi_3143_;
                                                                            let _e2469 = phi_3144_;
                                                                            phi_3145_ = _e2465;
                                                                            phi_3146_ = _e2467;
                                                                            phi_3147_ = _e2469;
                                                                        } else {
                                                                            phi_3145_ = true;
                                                                            phi_3146_ = false;
                                                                            phi_3147_ = false;
                                                                        }
                                                                        let _e2471 = phi_3145_;
                                                                        let _e2473 = phi_3146_;
                                                                        let _e2475 = phi_3147_;
                                                                        if _e2471 {
                                                                            phi_3151_ = false;
                                                                            phi_3152_ = false;
                                                                        } else {
                                                                            phi_3151_ = _e2473;
                                                                            phi_3152_ = _e2475;
                                                                        }
                                                                        let _e2477 = phi_3151_;
                                                                        let _e2479 = phi_3152_;
                                                                        phi_2469_ = (_e1917 & (_e1917 - 1u));
                                                                        phi_3153_ = _e2471;
                                                                        phi_3154_ = _e2477;
                                                                        phi_3155_ = _e2479;
                                                                    }
                                                                    let _e2481 = phi_2469_;
                                                                    let _e2483 = phi_3153_;
                                                                    let _e2485 = phi_3154_;
                                                                    let _e2487 = phi_3155_;
                                                                    local_15 = _e2485;
                                                                    local_16 = _e2487;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2468_ = _e2481;
                                                                        break if !(_e2483);
                                                                    }
                                                                }
                                                                let _e2490 = local_11;
                                                                if _e2490 {
                                                                    let _e2492 = local_2.group_mask;
                                                                    if ((_e2492 & 4278190080u) == 0u) {
                                                                        let _e2496 = local_2.len;
                                                                        if (_e2496 == 0u) {
                                                                            phi_3197_ = false;
                                                                        } else {
                                                                            let _e2500 = local_2.len;
                                                                            local_2.len = (_e2500 - 1u);
                                                                            let _e2503 = local_2.len;
                                                                            if (_e2503 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2508 = local_2.first[(0u + _e2503)];
                                                                            local_2.group = _e2508;
                                                                            let _e2511 = local_2.len;
                                                                            if (_e2511 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2516 = local_2.mask[(0u + _e2511)];
                                                                            local_2.group_mask = _e2516;
                                                                            phi_3197_ = true;
                                                                        }
                                                                        let _e2519 = phi_3197_;
                                                                        phi_3198_ = _e2519;
                                                                    } else {
                                                                        phi_3198_ = true;
                                                                    }
                                                                    let _e2521 = phi_3198_;
                                                                    if _e2521 {
                                                                        let _e2523 = local_2.group_mask;
                                                                        let _e2529 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2523)), 32u, (_e2523 == 0u)));
                                                                        let _e2533 = local_2.group_mask;
                                                                        let _e2547 = local_2.group_mask;
                                                                        local_2.group_mask = (_e2547 & ~((1u << bitcast<u32>((_e2529 & 31u)))));
                                                                        let _e2550 = local_2.group;
                                                                        phi_3229_ = (_e2550 + countOneBits(((_e2533 & ~((4294967295u << bitcast<u32>((((_e2529 - 24u) ^ _e1343) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3229_ = 4294967295u;
                                                                    }
                                                                    let _e2553 = phi_3229_;
                                                                    phi_3230_ = _e2553;
                                                                    phi_3231_ = false;
                                                                    phi_3232_ = false;
                                                                } else {
                                                                    phi_3230_ = u32();
                                                                    let _e2927 = local_15;
                                                                    phi_3231_ = _e2927;
                                                                    let _e2930 = local_16;
                                                                    phi_3232_ = _e2930;
                                                                }
                                                                let _e2555 = phi_3230_;
                                                                let _e2557 = phi_3231_;
                                                                let _e2559 = phi_3232_;
                                                                phi_2139_ = _e2555;
                                                                let _e2934 = local_17;
                                                                phi_3233_ = _e2934;
                                                                phi_3234_ = false;
                                                                phi_3235_ = _e2557;
                                                                phi_3236_ = _e2559;
                                                            } else {
                                                                phi_2139_ = u32();
                                                                phi_3233_ = false;
                                                                phi_3234_ = true;
                                                                phi_3235_ = false;
                                                                phi_3236_ = false;
                                                            }
                                                            let _e2561 = phi_2139_;
                                                            let _e2563 = phi_3233_;
                                                            let _e2565 = phi_3234_;
                                                            let _e2567 = phi_3235_;
                                                            let _e2569 = phi_3236_;
                                                            local_12 = _e2565;
                                                            local_18 = _e2567;
                                                            local_19 = _e2569;
                                                            continue;
                                                            continuing {
                                                                phi_2138_ = _e2561;
                                                                break if !(_e2563);
                                                            }
                                                        }
                                                        let _e2572 = local_12;
                                                        if _e2572 {
                                                            phi_3240_ = false;
                                                            phi_3241_ = false;
                                                        } else {
                                                            let _e2941 = local_18;
                                                            phi_3240_ = _e2941;
                                                            let _e2944 = local_19;
                                                            phi_3241_ = _e2944;
                                                        }
                                                        let _e2574 = phi_3240_;
                                                        let _e2576 = phi_3241_;
                                                        if _e2574 {
                                                            phi_3245_ = true;
                                                        } else {
                                                            phi_3245_ = _e2576;
                                                        }
                                                        let _e2578 = phi_3245_;
                                                        if _e2578 {
                                                            phi_3249_ = true;
                                                        } else {
                                                            phi_3249_ = false;
                                                        }
                                                        let _e2580 = phi_3249_;
                                                        phi_3250_ = _e2580;
                                                    }
                                                    let _e2582 = phi_3250_;
                                                    phi_3251_ = _e2582;
                                                    phi_3252_ = _e1169;
                                                } else {
                                                    phi_3251_ = bool();
                                                    phi_3252_ = true;
                                                }
                                                let _e2584 = phi_3251_;
                                                let _e2586 = phi_3252_;
                                                if _e2586 {
                                                    phi_3256_ = false;
                                                } else {
                                                    phi_3256_ = _e2584;
                                                }
                                                let _e2588 = phi_3256_;
                                                if _e2588 {
                                                    phi_3260_ = false;
                                                } else {
                                                    phi_3260_ = true;
                                                }
                                                let _e2590 = phi_3260_;
                                                phi_3261_ = _e2590;
                                            } else {
                                                phi_3261_ = true;
                                            }
                                            let _e2592 = phi_3261_;
                                            phi_3262_ = _e2592;
                                        } else {
                                            phi_3262_ = true;
                                        }
                                        let _e2594 = phi_3262_;
                                        phi_3263_ = _e2594;
                                    } else {
                                        phi_3263_ = true;
                                    }
                                    let _e2596 = phi_3263_;
                                    if _e2596 {
                                    }
                                    phi_1515_ = (_e938 & (_e938 - 1u));
                                    phi_3267_ = _e2596;
                                }
                                let _e2598 = phi_1515_;
                                let _e2600 = phi_3267_;
                                continue;
                                continuing {
                                    phi_1514_ = _e2598;
                                    break if !(_e2600);
                                }
                            }
                            let _e2603 = local_13;
                            if _e2603 {
                                let _e2605 = local_3.group_mask;
                                if ((_e2605 & 4278190080u) == 0u) {
                                    let _e2609 = local_3.len;
                                    if (_e2609 == 0u) {
                                        phi_3309_ = false;
                                    } else {
                                        let _e2613 = local_3.len;
                                        local_3.len = (_e2613 - 1u);
                                        let _e2616 = local_3.len;
                                        if (_e2616 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2621 = local_3.first[(0u + _e2616)];
                                        local_3.group = _e2621;
                                        let _e2624 = local_3.len;
                                        if (_e2624 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2629 = local_3.mask[(0u + _e2624)];
                                        local_3.group_mask = _e2629;
                                        phi_3309_ = true;
                                    }
                                    let _e2632 = phi_3309_;
                                    phi_3310_ = _e2632;
                                } else {
                                    phi_3310_ = true;
                                }
                                let _e2634 = phi_3310_;
                                if _e2634 {
                                    let _e2636 = local_3.group_mask;
                                    let _e2642 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2636)), 32u, (_e2636 == 0u)));
                                    let _e2646 = local_3.group_mask;
                                    let _e2660 = local_3.group_mask;
                                    local_3.group_mask = (_e2660 & ~((1u << bitcast<u32>((_e2642 & 31u)))));
                                    let _e2663 = local_3.group;
                                    phi_3341_ = (_e2663 + countOneBits(((_e2646 & ~((4294967295u << bitcast<u32>((((_e2642 - 24u) ^ _e359) & 31u))))) & 255u)));
                                } else {
                                    phi_3341_ = 4294967295u;
                                }
                                let _e2666 = phi_3341_;
                                phi_3342_ = _e2666;
                            } else {
                                phi_3342_ = u32();
                            }
                            let _e2668 = phi_3342_;
                            phi_1180_ = _e2668;
                            let _e2965 = local_20;
                            phi_3343_ = _e2965;
                            phi_3344_ = false;
                        } else {
                            phi_1180_ = u32();
                            phi_3343_ = false;
                            phi_3344_ = true;
                        }
                        let _e2670 = phi_1180_;
                        let _e2672 = phi_3343_;
                        let _e2674 = phi_3344_;
                        local_14 = _e2674;
                        continue;
                        continuing {
                            phi_1179_ = _e2670;
                            break if !(_e2672);
                        }
                    }
                    let _e2677 = local_14;
                    if _e2677 {
                        phi_3348_ = false;
                    } else {
                        phi_3348_ = true;
                    }
                    let _e2679 = phi_3348_;
                    if _e2679 {
                        phi_3352_ = true;
                    } else {
                        phi_3352_ = false;
                    }
                    let _e2681 = phi_3352_;
                    phi_3353_ = _e2681;
                }
                let _e2683 = phi_3353_;
                phi_3354_ = _e2683;
                phi_3355_ = _e196;
            } else {
                phi_3354_ = bool();
                phi_3355_ = true;
            }
            let _e2685 = phi_3354_;
            let _e2687 = phi_3355_;
            if _e2687 {
                phi_3359_ = false;
            } else {
                phi_3359_ = _e2685;
            }
            let _e2689 = phi_3359_;
            if _e2689 {
                phi_3363_ = 0f;
            } else {
                phi_3363_ = 1f;
            }
            let _e2691 = phi_3363_;
            phi_3364_ = _e2691;
        }
        let _e2693 = phi_3364_;
        if (_e100.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e100.first_primitive)] = _e2693;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
