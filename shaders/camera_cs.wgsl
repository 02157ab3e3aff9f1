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

struct type_33 {
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

struct type_42 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_47 {
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
var<uniform> p: type_42;
@group(0) @binding(1) 
var<storage> nodes: type_47;
@group(0) @binding(2) 
var<storage> triangles: type_8;
@group(0) @binding(5) 
var<storage, read_write> samples: type_33;

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

fn lt_shaders_entry_pixel_index(param_3: vec3<u32>, param_4: u32, param_5: u32) -> lt_bvh_traverse_Tree {
    var phi_278_: lt_bvh_traverse_Tree;
    var phi_279_: bool;
    var phi_280_: lt_bvh_traverse_Tree;
    var phi_281_: bool;
    var phi_286_: lt_bvh_traverse_Tree;

    if (param_3.x < param_4) {
        if (param_3.y < param_5) {
            phi_278_ = lt_bvh_traverse_Tree(1u, ((param_3.y * param_4) + param_3.x));
            phi_279_ = false;
        } else {
            phi_278_ = lt_bvh_traverse_Tree();
            phi_279_ = true;
        }
        let _e73 = phi_278_;
        let _e75 = phi_279_;
        phi_280_ = _e73;
        phi_281_ = _e75;
    } else {
        phi_280_ = lt_bvh_traverse_Tree();
        phi_281_ = true;
    }
    let _e77 = phi_280_;
    let _e79 = phi_281_;
    if _e79 {
        phi_286_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_286_ = _e77;
    }
    let _e84 = phi_286_;
    return lt_bvh_traverse_Tree(_e84.root, _e84.first_primitive);
}

fn lt_shaders_shade_unit(param_6: f32) -> f32 {
    var phi_300_: f32;
    var phi_301_: f32;

    if (param_6 > 0f) {
        if (param_6 < 1f) {
            phi_300_ = param_6;
        } else {
            phi_300_ = 1f;
        }
        let _e64 = phi_300_;
        phi_301_ = _e64;
    } else {
        phi_301_ = 0f;
    }
    let _e66 = phi_301_;
    return _e66;
}

fn lt_shaders_shade_sqrt(param_7: f32) -> f32 {
    return sqrt(param_7);
}

fn lt_shaders_shade_pack_bytes(param_8: vec3<f32>) -> u32 {
    let _e63 = ((param_8.x * 255f) + 0.5f);
    let _e73 = ((param_8.y * 255f) + 0.5f);
    let _e86 = ((param_8.z * 255f) + 0.5f);
    return ((select(select(u32(_e63), 0u, (_e63 < bitcast<f32>(0u))), 4294967295u, (_e63 > bitcast<f32>(1333788671u))) | (select(select(u32(_e73), 0u, (_e73 < bitcast<f32>(0u))), 4294967295u, (_e73 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e86), 0u, (_e86 < bitcast<f32>(0u))), 4294967295u, (_e86 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i)));
}

fn _lt_bvh_ray_Ray_new(param_9: vec3<f32>, param_10: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_9, 0f, param_10, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_11: f32, param_12: f32) -> f32 {
    var phi_356_: bool;
    var phi_360_: f32;

    if (param_11 != param_11) {
        phi_356_ = true;
    } else {
        let _e63 = (param_12 >= param_11);
        if _e63 {
        }
        phi_356_ = _e63;
    }
    let _e65 = phi_356_;
    if _e65 {
        phi_360_ = param_12;
    } else {
        phi_360_ = param_11;
    }
    let _e67 = phi_360_;
    return _e67;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_13: f32, param_14: f32) -> f32 {
    var phi_372_: bool;
    var phi_376_: f32;

    if (param_13 != param_13) {
        phi_372_ = true;
    } else {
        let _e63 = (param_14 <= param_13);
        if _e63 {
        }
        phi_372_ = _e63;
    }
    let _e65 = phi_372_;
    if _e65 {
        phi_376_ = param_14;
    } else {
        phi_376_ = param_13;
    }
    let _e67 = phi_376_;
    return _e67;
}

fn lt_shaders_surface_barycentric_weights(param_15: f32, param_16: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_15) - param_16), param_15, param_16);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_17: f32, param_18: f32) -> f32 {
    var phi_390_: f32;

    if (param_17 > param_18) {
        phi_390_ = param_17;
    } else {
        phi_390_ = param_18;
    }
    let _e64 = phi_390_;
    return _e64;
}

fn lt_shaders_camera_facing(param_19: vec3<f32>, param_20: vec3<f32>) -> vec3<f32> {
    var phi_410_: vec3<f32>;

    if ((((param_19.x * param_20.x) + (param_19.y * param_20.y)) + (param_19.z * param_20.z)) < 0f) {
        phi_410_ = -(param_19);
    } else {
        phi_410_ = param_19;
    }
    let _e76 = phi_410_;
    return _e76;
}

fn lt_shaders_surface_plain_color(param_21: ptr<function, abi_Material>, param_22: ptr<function, array<abi_Vertex, 3>>, param_23: vec3<f32>) -> vec3<f32> {
    let _e64 = (*param_21).base_color;
    let _e68 = lt_shaders_surface_vertex_color(param_22, param_23);
    return vec3<f32>((_e64.x * _e68.x), (_e64.y * _e68.y), (_e64.z * _e68.z));
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_24: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn lt_shaders_surface_octahedral_decode(param_25: u32) -> vec3<f32> {
    var phi_452_: f32;
    var phi_459_: f32;
    var phi_466_: f32;

    let _e68 = (f32((bitcast<i32>((param_25 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e74 = (f32((bitcast<i32>(param_25) >> bitcast<u32>(16i))) * (1f / 32767f));
    let _e78 = ((1f - abs(_e68)) - abs(_e74));
    if (_e78 < 0f) {
        phi_452_ = -(_e78);
    } else {
        phi_452_ = 0f;
    }
    let _e82 = phi_452_;
    if (_e68 < 0f) {
        phi_459_ = (_e68 + _e82);
    } else {
        phi_459_ = (_e68 - _e82);
    }
    let _e87 = phi_459_;
    if (_e74 < 0f) {
        phi_466_ = (_e74 + _e82);
    } else {
        phi_466_ = (_e74 - _e82);
    }
    let _e92 = phi_466_;
    let _e99 = (1f / sqrt((((_e87 * _e87) + (_e92 * _e92)) + (_e78 * _e78))));
    return vec3<f32>((_e87 * _e99), (_e92 * _e99), (_e78 * _e99));
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_26: vec3<f32>) -> vec3<f32> {
    return param_26;
}

fn lt_shaders_shade_pack_albedo(param_27: vec3<f32>) -> u32 {
    let _e62 = lt_shaders_shade_unit(param_27.x);
    let _e63 = lt_shaders_shade_sqrt(_e62);
    let _e65 = lt_shaders_shade_unit(param_27.y);
    let _e66 = lt_shaders_shade_sqrt(_e65);
    let _e68 = lt_shaders_shade_unit(param_27.z);
    let _e69 = lt_shaders_shade_sqrt(_e68);
    let _e71 = lt_shaders_shade_pack_bytes(vec3<f32>(_e63, _e66, _e69));
    return _e71;
}

fn function_() {
    var local: array<abi_Vertex, 3>;
    var local_1: abi_Material;
    var local_2: lt_bvh_traverse_Stack;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_657_: bool;
    var phi_661_: bool;
    var phi_736_: f32;
    var phi_743_: f32;
    var phi_751_: f32;
    var phi_758_: f32;
    var phi_766_: f32;
    var phi_773_: f32;
    var phi_798_: f32;
    var phi_803_: f32;
    var phi_808_: f32;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_850_: u32;
    var phi_851_: u32;
    var phi_869_: vec3<f32>;
    var phi_870_: vec3<f32>;
    var phi_884_: u32;
    var phi_889_: u32;
    var phi_894_: u32;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1040_: u32;
    var phi_1042_: lt_bvh_Hit;
    var phi_1045_: u32;
    var phi_1130_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1157_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1184_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1190_: u32;
    var phi_1193_: u32;
    var phi_1207_: u32;
    var phi_1217_: u32;
    var phi_1227_: u32;
    var phi_1245_: u32;
    var phi_1255_: u32;
    var phi_1265_: u32;
    var phi_1301_: u32;
    var phi_1314_: u32;
    var phi_1319_: u32;
    var phi_1320_: u32;
    var phi_1321_: u32;
    var phi_1191_: u32;
    var phi_1194_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1379_: lt_bvh_Hit;
    var phi_1382_: u32;
    var phi_1428_: vec3<f32>;
    var phi_1429_: vec3<f32>;
    var phi_1462_: vec3<f32>;
    var phi_1463_: vec3<f32>;
    var phi_1496_: vec3<f32>;
    var phi_1497_: vec3<f32>;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1522_: f32;
    var phi_1523_: f32;
    var phi_1524_: f32;
    var phi_1525_: f32;
    var phi_1533_: f32;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1548_: f32;
    var phi_1549_: f32;
    var phi_1550_: f32;
    var phi_1551_: f32;
    var phi_1559_: f32;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1585_: f32;
    var phi_1600_: f32;
    var phi_1601_: bool;
    var phi_1602_: f32;
    var phi_1603_: bool;
    var phi_1604_: f32;
    var phi_1605_: bool;
    var phi_1623_: f32;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: f32;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1632_: bool;
    var phi_1633_: f32;
    var phi_1634_: bool;
    var phi_1660_: f32;
    var phi_1669_: f32;
    var phi_1678_: f32;
    var phi_1687_: f32;
    var phi_1694_: f32;
    var phi_1701_: f32;
    var phi_1714_: f32;
    var phi_1723_: f32;
    var phi_1732_: f32;
    var phi_1741_: f32;
    var phi_1748_: f32;
    var phi_1755_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1788_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1806_: f32;
    var phi_1818_: f32;
    var phi_1823_: f32;
    var phi_1828_: f32;
    var phi_1833_: f32;
    var phi_1838_: lt_bvh_triangle_Intersection;
    var phi_1839_: lt_bvh_triangle_Intersection;
    var phi_1840_: bool;
    var phi_1844_: lt_bvh_triangle_Intersection;
    var phi_1883_: bool;
    var phi_1884_: bool;
    var phi_1885_: bool;
    var phi_1886_: bool;
    var phi_1887_: bool;
    var phi_1888_: bool;
    var phi_1892_: bool;
    var phi_1893_: bool;
    var phi_1907_: bool;
    var phi_1915_: lt_bvh_Hit;
    var phi_1916_: lt_bvh_Hit;
    var phi_1917_: lt_bvh_Hit;
    var phi_1918_: lt_bvh_Hit;
    var phi_1380_: lt_bvh_Hit;
    var phi_1383_: u32;
    var phi_1919_: bool;
    var phi_1958_: bool;
    var phi_1959_: bool;
    var phi_1990_: u32;
    var phi_1043_: lt_bvh_Hit;
    var phi_1046_: u32;
    var phi_1991_: lt_bvh_Hit;
    var phi_1992_: lt_bvh_Hit;
    var phi_1993_: bool;
    var phi_1997_: lt_bvh_Hit;
    var phi_2063_: f32;
    var phi_2068_: f32;
    var phi_2073_: f32;
    var phi_2084_: f32;
    var phi_2089_: f32;
    var phi_2094_: f32;
    var phi_2242_: u32;
    var phi_2308_: vec3<f32>;
    var phi_2309_: vec3<f32>;
    var phi_2313_: abi_Sample;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e63 = id_1;
    let _e67 = arrayLength((&nodes.member));
    let _e70 = arrayLength((&triangles.member));
    let _e73 = arrayLength((&vertices.member));
    let _e82 = p.member.size[0u];
    let _e84 = p.member.size[1u];
    let _e85 = lt_shaders_entry_pixel_index(_e63, _e82, _e84);
    if (bitcast<i32>(_e85.root) != 0i) {
        let _e93 = p.member.eye;
        let _e98 = p.member.size[0u];
        let _e102 = ((((f32(_e63.x) + 0.5f) / f32(_e98)) * 2f) - 1f);
        let _e107 = p.member.size[1u];
        let _e111 = (1f - (((f32(_e63.y) + 0.5f) / f32(_e107)) * 2f));
        let _e113 = p.member.forward;
        let _e115 = p.member.right;
        let _e129 = p.member.up;
        let _e140 = _lt_bvh_ray_Ray_new(_e93, vec3<f32>(((_e113.x + (_e115.x * _e102)) + (_e129.x * _e111)), ((_e113.y + (_e115.y * _e102)) + (_e129.y * _e111)), ((_e113.z + (_e115.z * _e102)) + (_e129.z * _e111))));
        let _e142 = lt_bvh_Hit(_e140.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e152 = abs(_e140.direction.x);
        let _e154 = abs(_e140.direction.y);
        let _e156 = abs(_e140.direction.z);
        if (abs(_e140.origin.x) < 1000000000000000f) {
            if (abs(_e140.origin.y) < 1000000000000000f) {
                if (abs(_e140.origin.z) < 1000000000000000f) {
                    if (_e152 < 1000000000000000f) {
                        if (_e154 < 1000000000000000f) {
                            if (_e156 < 1000000000000000f) {
                                if (_e152 > 0f) {
                                    phi_631_ = bool();
                                    phi_632_ = true;
                                } else {
                                    let _e164 = (_e154 > 0f);
                                    if _e164 {
                                        phi_630_ = bool();
                                    } else {
                                        phi_630_ = (_e156 > 0f);
                                    }
                                    let _e167 = phi_630_;
                                    phi_631_ = _e167;
                                    phi_632_ = _e164;
                                }
                                let _e169 = phi_631_;
                                let _e171 = phi_632_;
                                if _e171 {
                                    phi_636_ = true;
                                } else {
                                    phi_636_ = _e169;
                                }
                                let _e173 = phi_636_;
                                phi_637_ = _e173;
                                phi_638_ = false;
                            } else {
                                phi_637_ = bool();
                                phi_638_ = true;
                            }
                            let _e175 = phi_637_;
                            let _e177 = phi_638_;
                            phi_639_ = _e175;
                            phi_640_ = false;
                            phi_641_ = _e177;
                        } else {
                            phi_639_ = bool();
                            phi_640_ = true;
                            phi_641_ = false;
                        }
                        let _e179 = phi_639_;
                        let _e181 = phi_640_;
                        let _e183 = phi_641_;
                        phi_642_ = _e179;
                        phi_643_ = _e181;
                        phi_644_ = _e183;
                    } else {
                        phi_642_ = bool();
                        phi_643_ = true;
                        phi_644_ = false;
                    }
                    let _e185 = phi_642_;
                    let _e187 = phi_643_;
                    let _e189 = phi_644_;
                    phi_645_ = _e185;
                    phi_646_ = _e187;
                    phi_647_ = _e189;
                } else {
                    phi_645_ = bool();
                    phi_646_ = true;
                    phi_647_ = false;
                }
                let _e191 = phi_645_;
                let _e193 = phi_646_;
                let _e195 = phi_647_;
                phi_648_ = _e191;
                phi_649_ = _e193;
                phi_650_ = _e195;
            } else {
                phi_648_ = bool();
                phi_649_ = true;
                phi_650_ = false;
            }
            let _e197 = phi_648_;
            let _e199 = phi_649_;
            let _e201 = phi_650_;
            phi_651_ = _e197;
            phi_652_ = _e199;
            phi_653_ = _e201;
        } else {
            phi_651_ = bool();
            phi_652_ = true;
            phi_653_ = false;
        }
        let _e203 = phi_651_;
        let _e205 = phi_652_;
        let _e207 = phi_653_;
        if _e205 {
            phi_657_ = true;
        } else {
            phi_657_ = _e207;
        }
        let _e209 = phi_657_;
        if _e209 {
            phi_661_ = false;
        } else {
            phi_661_ = _e203;
        }
        let _e211 = phi_661_;
        if _e211 {
            let _e212 = (0u >= _e67);
            if _e212 {
                phi_1991_ = lt_bvh_Hit();
            } else {
                if (0u < _e67) {
                } else {
                    return;
                }
                let _e218 = nodes.member[(0u + 0u)].frame[0u];
                let _e222 = nodes.member[(0u + 0u)].frame[1u];
                let _e226 = nodes.member[(0u + 0u)].frame[2u];
                let _e230 = nodes.member[(0u + 0u)].frame[0u];
                let _e234 = nodes.member[(0u + 0u)].frame[1u];
                let _e238 = nodes.member[(0u + 0u)].frame[2u];
                let _e242 = nodes.member[(0u + 0u)].frame[3u];
                let _e280 = core_intrinsics_maximum_number_nsz_f32_(abs(_e140.direction.x), abs(_e140.direction.y));
                let _e281 = core_intrinsics_maximum_number_nsz_f32_(_e280, abs(_e140.direction.z));
                let _e282 = (_e281 * 0.0000000000009094947f);
                if (abs(_e140.direction.x) < _e282) {
                    phi_736_ = _e282;
                } else {
                    phi_736_ = abs(_e140.direction.x);
                }
                let _e289 = phi_736_;
                if (_e140.direction.x < 0f) {
                    phi_743_ = (-1f / _e289);
                } else {
                    phi_743_ = (1f / _e289);
                }
                let _e294 = phi_743_;
                if (abs(_e140.direction.y) < _e282) {
                    phi_751_ = _e282;
                } else {
                    phi_751_ = abs(_e140.direction.y);
                }
                let _e301 = phi_751_;
                if (_e140.direction.y < 0f) {
                    phi_758_ = (-1f / _e301);
                } else {
                    phi_758_ = (1f / _e301);
                }
                let _e306 = phi_758_;
                if (abs(_e140.direction.z) < _e282) {
                    phi_766_ = _e282;
                } else {
                    phi_766_ = abs(_e140.direction.z);
                }
                let _e313 = phi_766_;
                if (_e140.direction.z < 0f) {
                    phi_773_ = (-1f / _e313);
                } else {
                    phi_773_ = (1f / _e313);
                }
                let _e318 = phi_773_;
                let _e326 = abs((bitcast<f32>(_e218) - _e140.origin.x));
                let _e327 = abs((bitcast<f32>(_e222) - _e140.origin.y));
                let _e328 = abs((bitcast<f32>(_e226) - _e140.origin.z));
                let _e336 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e140.origin.x));
                let _e337 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e140.origin.y));
                let _e338 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e140.origin.z));
                if (_e326 > _e336) {
                    phi_798_ = _e326;
                } else {
                    phi_798_ = _e336;
                }
                let _e341 = phi_798_;
                if (_e327 > _e337) {
                    phi_803_ = _e327;
                } else {
                    phi_803_ = _e337;
                }
                let _e344 = phi_803_;
                if (_e328 > _e338) {
                    phi_808_ = _e328;
                } else {
                    phi_808_ = _e338;
                }
                let _e347 = phi_808_;
                let _e348 = core_intrinsics_maximum_number_nsz_f32_(_e341, _e344);
                let _e349 = core_intrinsics_maximum_number_nsz_f32_(_e348, _e347);
                let _e354 = (_e349 * 0.0000019073486f);
                let _e355 = (abs(_e294) * _e354);
                let _e356 = (abs(_e306) * _e354);
                let _e357 = (abs(_e318) * _e354);
                let _e361 = (_e349 * 0.0000009536743f);
                let _e362 = (abs(_e294) * _e361);
                let _e363 = (abs(_e306) * _e361);
                let _e364 = (abs(_e318) * _e361);
                let _e367 = abs(_e140.direction.x);
                let _e369 = abs(_e140.direction.y);
                let _e371 = abs(_e140.direction.z);
                if (_e367 >= _e369) {
                    if (_e367 >= _e371) {
                        phi_841_ = false;
                    } else {
                        phi_841_ = true;
                    }
                    let _e375 = phi_841_;
                    phi_842_ = _e375;
                } else {
                    phi_842_ = true;
                }
                let _e377 = phi_842_;
                if _e377 {
                    if (_e369 >= _e371) {
                        phi_850_ = 1u;
                    } else {
                        phi_850_ = 2u;
                    }
                    let _e380 = phi_850_;
                    phi_851_ = _e380;
                } else {
                    phi_851_ = 0u;
                }
                let _e382 = phi_851_;
                if (_e382 == 0u) {
                    phi_870_ = vec3<f32>(_e140.direction.y, _e140.direction.z, _e140.direction.x);
                } else {
                    if (_e382 == 1u) {
                        phi_869_ = vec3<f32>(_e140.direction.z, _e140.direction.x, _e140.direction.y);
                    } else {
                        phi_869_ = _e140.direction;
                    }
                    let _e395 = phi_869_;
                    phi_870_ = _e395;
                }
                let _e397 = phi_870_;
                let _e401 = (_e397.x / _e397.z);
                let _e404 = (_e397.y / _e397.z);
                let _e406 = (1f / _e397.z);
                if (_e294 < 0f) {
                    phi_884_ = 0u;
                } else {
                    phi_884_ = 1u;
                }
                let _e409 = phi_884_;
                if (_e306 < 0f) {
                    phi_889_ = 0u;
                } else {
                    phi_889_ = 2u;
                }
                let _e412 = phi_889_;
                if (_e318 < 0f) {
                    phi_894_ = 0u;
                } else {
                    phi_894_ = 4u;
                }
                let _e415 = phi_894_;
                let _e417 = ((_e409 | _e412) | _e415);
                let _e418 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e418.first[0], _e418.first[1], _e418.first[2], _e418.first[3], _e418.first[4], _e418.first[5], _e418.first[6], _e418.first[7], _e418.first[8], _e418.first[9], _e418.first[10], _e418.first[11], _e418.first[12], _e418.first[13], _e418.first[14], _e418.first[15], _e418.first[16], _e418.first[17], _e418.first[18], _e418.first[19], _e418.first[20], _e418.first[21], _e418.first[22], _e418.first[23], _e418.first[24], _e418.first[25], _e418.first[26], _e418.first[27], _e418.first[28], _e418.first[29], _e418.first[30], _e418.first[31]), array<u32, 32>(_e418.mask[0], _e418.mask[1], _e418.mask[2], _e418.mask[3], _e418.mask[4], _e418.mask[5], _e418.mask[6], _e418.mask[7], _e418.mask[8], _e418.mask[9], _e418.mask[10], _e418.mask[11], _e418.mask[12], _e418.mask[13], _e418.mask[14], _e418.mask[15], _e418.mask[16], _e418.mask[17], _e418.mask[18], _e418.mask[19], _e418.mask[20], _e418.mask[21], _e418.mask[22], _e418.mask[23], _e418.mask[24], _e418.mask[25], _e418.mask[26], _e418.mask[27], _e418.mask[28], _e418.mask[29], _e418.mask[30], _e418.mask[31]), _e418.len, _e418.group, _e418.group_mask);
                let _e492 = local_2.group_mask;
                if ((_e492 & 4278190080u) == 0u) {
                    let _e496 = local_2.len;
                    if (_e496 == 0u) {
                        phi_1008_ = false;
                    } else {
                        let _e500 = local_2.len;
                        local_2.len = (_e500 - 1u);
                        let _e503 = local_2.len;
                        if (_e503 < 32u) {
                        } else {
                            return;
                        }
                        let _e508 = local_2.first[(0u + _e503)];
                        local_2.group = _e508;
                        let _e511 = local_2.len;
                        if (_e511 < 32u) {
                        } else {
                            return;
                        }
                        let _e516 = local_2.mask[(0u + _e511)];
                        local_2.group_mask = _e516;
                        phi_1008_ = true;
                    }
                    let _e519 = phi_1008_;
                    phi_1009_ = _e519;
                } else {
                    phi_1009_ = true;
                }
                let _e521 = phi_1009_;
                if _e521 {
                    let _e523 = local_2.group_mask;
                    let _e529 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e523)), 32u, (_e523 == 0u)));
                    let _e533 = local_2.group_mask;
                    let _e547 = local_2.group_mask;
                    local_2.group_mask = (_e547 & ~((1u << bitcast<u32>((_e529 & 31u)))));
                    let _e550 = local_2.group;
                    phi_1040_ = (_e550 + countOneBits(((_e533 & ~((4294967295u << bitcast<u32>((((_e529 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1040_ = 4294967295u;
                }
                let _e553 = phi_1040_;
                phi_1042_ = _e142;
                phi_1045_ = _e553;
                loop {
                    let _e555 = phi_1042_;
                    let _e557 = phi_1045_;
                    local_7 = _e555;
                    let _e558 = (_e557 != 4294967295u);
                    if _e558 {
                        if (_e557 < _e67) {
                        } else {
                            return;
                        }
                        let _e566 = nodes.member[(0u + _e557)].frame[3u];
                        let _e591 = (bitcast<f32>((((_e566 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e294);
                        let _e592 = (bitcast<f32>((((_e566 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e306);
                        let _e593 = (bitcast<f32>((((_e566 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e318);
                        let _e596 = nodes.member[(0u + _e557)].frame[0u];
                        let _e600 = nodes.member[(0u + _e557)].frame[1u];
                        let _e604 = nodes.member[(0u + _e557)].frame[2u];
                        let _e612 = ((bitcast<f32>(_e596) - _e140.origin.x) * _e294);
                        let _e613 = ((bitcast<f32>(_e600) - _e140.origin.y) * _e306);
                        let _e614 = ((bitcast<f32>(_e604) - _e140.origin.z) * _e318);
                        let _e622 = nodes.member[(0u + _e557)].x;
                        if (_e294 < 0f) {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.unnamed.root, _e622.w), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_bvh_traverse_Tree(_e622.x, _e639.unnamed_1.first_primitive));
                            phi_1130_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e645.unnamed_1.root, _e622.y));
                        } else {
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e661.unnamed.root, _e622.y), _e661.unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_bvh_traverse_Tree(_e622.z, _e667.unnamed_1.first_primitive));
                            phi_1130_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e673.unnamed_1.root, _e622.w));
                        }
                        let _e681 = phi_1130_;
                        let _e691 = nodes.member[(0u + _e557)].y;
                        if (_e306 < 0f) {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.unnamed.root, _e691.w), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_bvh_traverse_Tree(_e691.x, _e708.unnamed_1.first_primitive));
                            phi_1157_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e714.unnamed_1.root, _e691.y));
                        } else {
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e730.unnamed.root, _e691.y), _e730.unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_bvh_traverse_Tree(_e691.z, _e736.unnamed_1.first_primitive));
                            phi_1157_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e742.unnamed_1.root, _e691.w));
                        }
                        let _e750 = phi_1157_;
                        let _e760 = nodes.member[(0u + _e557)].z;
                        if (_e318 < 0f) {
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e760.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e771.unnamed.root, _e760.w), _e771.unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_bvh_traverse_Tree(_e760.x, _e777.unnamed_1.first_primitive));
                            phi_1184_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_bvh_traverse_Tree(_e783.unnamed_1.root, _e760.y));
                        } else {
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e760.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e799.unnamed.root, _e760.y), _e799.unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e805.unnamed, lt_bvh_traverse_Tree(_e760.z, _e805.unnamed_1.first_primitive));
                            phi_1184_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_bvh_traverse_Tree(_e811.unnamed_1.root, _e760.w));
                        }
                        let _e819 = phi_1184_;
                        phi_1190_ = 0u;
                        phi_1193_ = 0u;
                        loop {
                            let _e829 = phi_1190_;
                            let _e831 = phi_1193_;
                            local_3 = _e831;
                            local_4 = _e831;
                            local_5 = _e831;
                            let _e832 = (_e829 < 8u);
                            if _e832 {
                                let _e834 = (_e829 >> bitcast<u32>(2i));
                                let _e835 = (_e829 & 3u);
                                if (_e834 == 0u) {
                                    phi_1207_ = _e681.unnamed.root;
                                } else {
                                    phi_1207_ = _e681.unnamed.first_primitive;
                                }
                                let _e838 = phi_1207_;
                                if (_e834 == 0u) {
                                    phi_1217_ = _e750.unnamed.root;
                                } else {
                                    phi_1217_ = _e750.unnamed.first_primitive;
                                }
                                let _e847 = phi_1217_;
                                if (_e834 == 0u) {
                                    phi_1227_ = _e819.unnamed.root;
                                } else {
                                    phi_1227_ = _e819.unnamed.first_primitive;
                                }
                                let _e856 = phi_1227_;
                                let _e869 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e838 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e591) + (_e612 - _e355)), ((f32(((_e847 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e592) + (_e613 - _e356)));
                                let _e870 = core_intrinsics_maximum_number_nsz_f32_(_e869, ((f32(((_e856 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e593) + (_e614 - _e357)));
                                if (_e834 == 0u) {
                                    phi_1245_ = _e681.unnamed_1.root;
                                } else {
                                    phi_1245_ = _e681.unnamed_1.first_primitive;
                                }
                                let _e873 = phi_1245_;
                                if (_e834 == 0u) {
                                    phi_1255_ = _e750.unnamed_1.root;
                                } else {
                                    phi_1255_ = _e750.unnamed_1.first_primitive;
                                }
                                let _e882 = phi_1255_;
                                if (_e834 == 0u) {
                                    phi_1265_ = _e819.unnamed_1.root;
                                } else {
                                    phi_1265_ = _e819.unnamed_1.first_primitive;
                                }
                                let _e891 = phi_1265_;
                                let _e904 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e873 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e591) + (_e612 + _e355)), ((f32(((_e882 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e592) + (_e613 + _e356)));
                                let _e905 = core_intrinsics_minimum_number_nsz_f32_(_e904, ((f32(((_e891 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e593) + (_e614 + _e357)));
                                if (_e870 <= _e905) {
                                    if (_e870 <= _e555.t) {
                                        if (_e905 >= _e140.tmin) {
                                            if (_e834 == 0u) {
                                                let _e912 = nodes.member[(0u + _e557)].links[2u];
                                                phi_1301_ = _e912;
                                            } else {
                                                let _e915 = nodes.member[(0u + _e557)].links[3u];
                                                phi_1301_ = _e915;
                                            }
                                            let _e917 = phi_1301_;
                                            let _e922 = ((_e917 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u);
                                            let _e923 = (_e922 & 31u);
                                            if (_e923 >= 24u) {
                                                phi_1314_ = (24u + ((_e923 - 24u) ^ _e417));
                                            } else {
                                                phi_1314_ = _e923;
                                            }
                                            let _e929 = phi_1314_;
                                            phi_1319_ = (_e831 | ((_e922 >> bitcast<u32>(5i)) << bitcast<u32>((_e929 & 31u))));
                                        } else {
                                            phi_1319_ = _e831;
                                        }
                                        let _e937 = phi_1319_;
                                        phi_1320_ = _e937;
                                    } else {
                                        phi_1320_ = _e831;
                                    }
                                    let _e939 = phi_1320_;
                                    phi_1321_ = _e939;
                                } else {
                                    phi_1321_ = _e831;
                                }
                                let _e941 = phi_1321_;
                                phi_1191_ = (_e829 + 1u);
                                phi_1194_ = _e941;
                            } else {
                                phi_1191_ = u32();
                                phi_1194_ = u32();
                            }
                            let _e944 = phi_1191_;
                            let _e946 = phi_1194_;
                            continue;
                            continuing {
                                phi_1190_ = _e944;
                                phi_1193_ = _e946;
                                break if !(_e832);
                            }
                        }
                        let _e950 = nodes.member[(0u + _e557)].links[0u];
                        let _e954 = nodes.member[(0u + _e557)].frame[3u];
                        let _e958 = local_3;
                        if ((_e958 & 4278190080u) == 0u) {
                        } else {
                            let _e962 = local_2.group_mask;
                            if ((_e962 & 4278190080u) == 0u) {
                            } else {
                                let _e966 = local_2.len;
                                if (_e966 < 32u) {
                                    let _e969 = local_2.group;
                                    let _e971 = local_2.len;
                                    if (_e971 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e971)] = _e969;
                                    let _e977 = local_2.group_mask;
                                    let _e979 = local_2.len;
                                    if (_e979 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e979)] = _e977;
                                    let _e986 = local_2.len;
                                    local_2.len = (_e986 + 1u);
                                }
                            }
                            local_2.group = (0u + _e950);
                            let _e990 = local_4;
                            local_2.group_mask = ((_e990 & 4278190080u) | (_e954 >> bitcast<u32>(24i)));
                        }
                        let _e995 = local_5;
                        phi_1379_ = _e555;
                        phi_1382_ = (_e995 & 16777215u);
                        loop {
                            let _e998 = phi_1379_;
                            let _e1000 = phi_1382_;
                            local_6 = _e998;
                            if (_e1000 == 0u) {
                                phi_1380_ = lt_bvh_Hit();
                                phi_1383_ = u32();
                                phi_1919_ = false;
                            } else {
                                let _e1004 = nodes.member[(0u + _e557)].links[1u];
                                let _e1009 = ((0u + _e1004) + select(firstTrailingBit(_e1000), 32u, (_e1000 == 0u)));
                                if (_e1009 < _e70) {
                                } else {
                                    return;
                                }
                                let _e1016 = triangles.member[(0u + _e1009)].v0_;
                                let _e1019 = (_e1016.x - _e140.origin.x);
                                let _e1022 = (_e1016.y - _e140.origin.y);
                                let _e1025 = (_e1016.z - _e140.origin.z);
                                if (_e382 == 0u) {
                                    phi_1429_ = vec3<f32>(_e1022, _e1025, _e1019);
                                } else {
                                    if (_e382 == 1u) {
                                        phi_1428_ = vec3<f32>(_e1025, _e1019, _e1022);
                                    } else {
                                        phi_1428_ = (_e1016 - _e140.origin);
                                    }
                                    let _e1032 = phi_1428_;
                                    phi_1429_ = _e1032;
                                }
                                let _e1034 = phi_1429_;
                                let _e1038 = (_e1034.x - (_e401 * _e1034.z));
                                let _e1042 = (_e1034.y - (_e404 * _e1034.z));
                                let _e1046 = triangles.member[(0u + _e1009)].v1_;
                                let _e1049 = (_e1046.x - _e140.origin.x);
                                let _e1052 = (_e1046.y - _e140.origin.y);
                                let _e1055 = (_e1046.z - _e140.origin.z);
                                if (_e382 == 0u) {
                                    phi_1463_ = vec3<f32>(_e1052, _e1055, _e1049);
                                } else {
                                    if (_e382 == 1u) {
                                        phi_1462_ = vec3<f32>(_e1055, _e1049, _e1052);
                                    } else {
                                        phi_1462_ = (_e1046 - _e140.origin);
                                    }
                                    let _e1062 = phi_1462_;
                                    phi_1463_ = _e1062;
                                }
                                let _e1064 = phi_1463_;
                                let _e1068 = (_e1064.x - (_e401 * _e1064.z));
                                let _e1072 = (_e1064.y - (_e404 * _e1064.z));
                                let _e1076 = triangles.member[(0u + _e1009)].v2_;
                                let _e1079 = (_e1076.x - _e140.origin.x);
                                let _e1082 = (_e1076.y - _e140.origin.y);
                                let _e1085 = (_e1076.z - _e140.origin.z);
                                if (_e382 == 0u) {
                                    phi_1497_ = vec3<f32>(_e1082, _e1085, _e1079);
                                } else {
                                    if (_e382 == 1u) {
                                        phi_1496_ = vec3<f32>(_e1085, _e1079, _e1082);
                                    } else {
                                        phi_1496_ = (_e1076 - _e140.origin);
                                    }
                                    let _e1092 = phi_1496_;
                                    phi_1497_ = _e1092;
                                }
                                let _e1094 = phi_1497_;
                                let _e1098 = (_e1094.x - (_e401 * _e1094.z));
                                let _e1102 = (_e1094.y - (_e404 * _e1094.z));
                                if (_e1068 < _e1098) {
                                    phi_1518_ = true;
                                } else {
                                    if (_e1068 == _e1098) {
                                        phi_1517_ = (_e1072 < _e1102);
                                    } else {
                                        phi_1517_ = false;
                                    }
                                    let _e1109 = phi_1517_;
                                    phi_1518_ = _e1109;
                                }
                                let _e1111 = phi_1518_;
                                if _e1111 {
                                    phi_1522_ = _e1102;
                                    phi_1523_ = _e1098;
                                    phi_1524_ = _e1072;
                                    phi_1525_ = _e1068;
                                } else {
                                    phi_1522_ = _e1072;
                                    phi_1523_ = _e1068;
                                    phi_1524_ = _e1102;
                                    phi_1525_ = _e1098;
                                }
                                let _e1113 = phi_1522_;
                                let _e1115 = phi_1523_;
                                let _e1117 = phi_1524_;
                                let _e1119 = phi_1525_;
                                let _e1122 = ((_e1119 * _e1113) - (_e1117 * _e1115));
                                if _e1111 {
                                    phi_1533_ = -(_e1122);
                                } else {
                                    phi_1533_ = _e1122;
                                }
                                let _e1125 = phi_1533_;
                                if (_e1098 < _e1038) {
                                    phi_1544_ = true;
                                } else {
                                    if (_e1098 == _e1038) {
                                        phi_1543_ = (_e1102 < _e1042);
                                    } else {
                                        phi_1543_ = false;
                                    }
                                    let _e1130 = phi_1543_;
                                    phi_1544_ = _e1130;
                                }
                                let _e1132 = phi_1544_;
                                if _e1132 {
                                    phi_1548_ = _e1042;
                                    phi_1549_ = _e1038;
                                    phi_1550_ = _e1102;
                                    phi_1551_ = _e1098;
                                } else {
                                    phi_1548_ = _e1102;
                                    phi_1549_ = _e1098;
                                    phi_1550_ = _e1042;
                                    phi_1551_ = _e1038;
                                }
                                let _e1134 = phi_1548_;
                                let _e1136 = phi_1549_;
                                let _e1138 = phi_1550_;
                                let _e1140 = phi_1551_;
                                let _e1143 = ((_e1140 * _e1134) - (_e1138 * _e1136));
                                if _e1132 {
                                    phi_1559_ = -(_e1143);
                                } else {
                                    phi_1559_ = _e1143;
                                }
                                let _e1146 = phi_1559_;
                                if (_e1038 < _e1068) {
                                    phi_1570_ = true;
                                } else {
                                    if (_e1038 == _e1068) {
                                        phi_1569_ = (_e1042 < _e1072);
                                    } else {
                                        phi_1569_ = false;
                                    }
                                    let _e1151 = phi_1569_;
                                    phi_1570_ = _e1151;
                                }
                                let _e1153 = phi_1570_;
                                if _e1153 {
                                    phi_1574_ = _e1072;
                                    phi_1575_ = _e1068;
                                    phi_1576_ = _e1042;
                                    phi_1577_ = _e1038;
                                } else {
                                    phi_1574_ = _e1042;
                                    phi_1575_ = _e1038;
                                    phi_1576_ = _e1072;
                                    phi_1577_ = _e1068;
                                }
                                let _e1155 = phi_1574_;
                                let _e1157 = phi_1575_;
                                let _e1159 = phi_1576_;
                                let _e1161 = phi_1577_;
                                let _e1164 = ((_e1161 * _e1155) - (_e1159 * _e1157));
                                if _e1153 {
                                    phi_1585_ = -(_e1164);
                                } else {
                                    phi_1585_ = _e1164;
                                }
                                let _e1167 = phi_1585_;
                                if (_e1125 >= 0f) {
                                    if (_e1146 >= 0f) {
                                        if (_e1167 >= 0f) {
                                            phi_1600_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1601_ = false;
                                        } else {
                                            phi_1600_ = f32();
                                            phi_1601_ = true;
                                        }
                                        let _e1174 = phi_1600_;
                                        let _e1176 = phi_1601_;
                                        phi_1602_ = _e1174;
                                        phi_1603_ = _e1176;
                                    } else {
                                        phi_1602_ = f32();
                                        phi_1603_ = true;
                                    }
                                    let _e1178 = phi_1602_;
                                    let _e1180 = phi_1603_;
                                    phi_1604_ = _e1178;
                                    phi_1605_ = _e1180;
                                } else {
                                    phi_1604_ = f32();
                                    phi_1605_ = true;
                                }
                                let _e1182 = phi_1604_;
                                let _e1184 = phi_1605_;
                                if _e1184 {
                                    if (_e1125 <= 0f) {
                                        if (_e1146 <= 0f) {
                                            let _e1187 = (_e1167 <= 0f);
                                            if _e1187 {
                                            }
                                            phi_1623_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1624_ = false;
                                            phi_1625_ = _e1187;
                                        } else {
                                            phi_1623_ = f32();
                                            phi_1624_ = true;
                                            phi_1625_ = false;
                                        }
                                        let _e1191 = phi_1623_;
                                        let _e1193 = phi_1624_;
                                        let _e1195 = phi_1625_;
                                        phi_1626_ = _e1191;
                                        phi_1627_ = _e1193;
                                        phi_1628_ = _e1195;
                                    } else {
                                        phi_1626_ = f32();
                                        phi_1627_ = true;
                                        phi_1628_ = false;
                                    }
                                    let _e1197 = phi_1626_;
                                    let _e1199 = phi_1627_;
                                    let _e1201 = phi_1628_;
                                    if _e1199 {
                                        phi_1632_ = false;
                                    } else {
                                        phi_1632_ = _e1201;
                                    }
                                    let _e1203 = phi_1632_;
                                    phi_1633_ = _e1197;
                                    phi_1634_ = _e1203;
                                } else {
                                    phi_1633_ = _e1182;
                                    phi_1634_ = true;
                                }
                                let _e1205 = phi_1633_;
                                let _e1207 = phi_1634_;
                                if _e1207 {
                                    let _e1208 = (_e1205 == 0f);
                                    if _e1208 {
                                        phi_1838_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1214 = ((((_e1125 * (_e406 * _e1034.z)) + (_e1146 * (_e406 * _e1064.z))) + (_e1167 * (_e406 * _e1094.z))) / _e1205);
                                        let _e1216 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1218 = triangles.member[(0u + _e1009)].v1_;
                                        if (_e1216.x < _e1218.x) {
                                            phi_1660_ = _e1216.x;
                                        } else {
                                            phi_1660_ = _e1218.x;
                                        }
                                        let _e1225 = phi_1660_;
                                        if (_e1216.y < _e1218.y) {
                                            phi_1669_ = _e1216.y;
                                        } else {
                                            phi_1669_ = _e1218.y;
                                        }
                                        let _e1232 = phi_1669_;
                                        if (_e1216.z < _e1218.z) {
                                            phi_1678_ = _e1216.z;
                                        } else {
                                            phi_1678_ = _e1218.z;
                                        }
                                        let _e1239 = phi_1678_;
                                        let _e1241 = triangles.member[(0u + _e1009)].v2_;
                                        if (_e1225 < _e1241.x) {
                                            phi_1687_ = _e1225;
                                        } else {
                                            phi_1687_ = _e1241.x;
                                        }
                                        let _e1246 = phi_1687_;
                                        if (_e1232 < _e1241.y) {
                                            phi_1694_ = _e1232;
                                        } else {
                                            phi_1694_ = _e1241.y;
                                        }
                                        let _e1251 = phi_1694_;
                                        if (_e1239 < _e1241.z) {
                                            phi_1701_ = _e1239;
                                        } else {
                                            phi_1701_ = _e1241.z;
                                        }
                                        let _e1256 = phi_1701_;
                                        let _e1258 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1260 = triangles.member[(0u + _e1009)].v1_;
                                        if (_e1258.x > _e1260.x) {
                                            phi_1714_ = _e1258.x;
                                        } else {
                                            phi_1714_ = _e1260.x;
                                        }
                                        let _e1267 = phi_1714_;
                                        if (_e1258.y > _e1260.y) {
                                            phi_1723_ = _e1258.y;
                                        } else {
                                            phi_1723_ = _e1260.y;
                                        }
                                        let _e1274 = phi_1723_;
                                        if (_e1258.z > _e1260.z) {
                                            phi_1732_ = _e1258.z;
                                        } else {
                                            phi_1732_ = _e1260.z;
                                        }
                                        let _e1281 = phi_1732_;
                                        let _e1283 = triangles.member[(0u + _e1009)].v2_;
                                        if (_e1267 > _e1283.x) {
                                            phi_1741_ = _e1267;
                                        } else {
                                            phi_1741_ = _e1283.x;
                                        }
                                        let _e1288 = phi_1741_;
                                        if (_e1274 > _e1283.y) {
                                            phi_1748_ = _e1274;
                                        } else {
                                            phi_1748_ = _e1283.y;
                                        }
                                        let _e1293 = phi_1748_;
                                        if (_e1281 > _e1283.z) {
                                            phi_1755_ = _e1281;
                                        } else {
                                            phi_1755_ = _e1283.z;
                                        }
                                        let _e1298 = phi_1755_;
                                        let _e1305 = ((_e1246 - _e140.origin.x) * _e294);
                                        let _e1306 = ((_e1251 - _e140.origin.y) * _e306);
                                        let _e1307 = ((_e1256 - _e140.origin.z) * _e318);
                                        let _e1314 = ((_e1288 - _e140.origin.x) * _e294);
                                        let _e1315 = ((_e1293 - _e140.origin.y) * _e306);
                                        let _e1316 = ((_e1298 - _e140.origin.z) * _e318);
                                        if (_e1305 < _e1314) {
                                            phi_1778_ = _e1305;
                                        } else {
                                            phi_1778_ = _e1314;
                                        }
                                        let _e1319 = phi_1778_;
                                        if (_e1306 < _e1315) {
                                            phi_1783_ = _e1306;
                                        } else {
                                            phi_1783_ = _e1315;
                                        }
                                        let _e1322 = phi_1783_;
                                        if (_e1307 < _e1316) {
                                            phi_1788_ = _e1307;
                                        } else {
                                            phi_1788_ = _e1316;
                                        }
                                        let _e1325 = phi_1788_;
                                        if (_e1305 > _e1314) {
                                            phi_1796_ = _e1305;
                                        } else {
                                            phi_1796_ = _e1314;
                                        }
                                        let _e1331 = phi_1796_;
                                        if (_e1306 > _e1315) {
                                            phi_1801_ = _e1306;
                                        } else {
                                            phi_1801_ = _e1315;
                                        }
                                        let _e1334 = phi_1801_;
                                        if (_e1307 > _e1316) {
                                            phi_1806_ = _e1307;
                                        } else {
                                            phi_1806_ = _e1316;
                                        }
                                        let _e1337 = phi_1806_;
                                        let _e1341 = core_intrinsics_maximum_number_nsz_f32_((_e1319 - _e362), (_e1322 - _e363));
                                        let _e1342 = core_intrinsics_maximum_number_nsz_f32_(_e1341, (_e1325 - _e364));
                                        let _e1343 = core_intrinsics_minimum_number_nsz_f32_((_e1331 + _e362), (_e1334 + _e363));
                                        let _e1344 = core_intrinsics_minimum_number_nsz_f32_(_e1343, (_e1337 + _e364));
                                        if (_e1342 > -300000000000000000000000000000000000000f) {
                                            phi_1818_ = _e1342;
                                        } else {
                                            phi_1818_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1347 = phi_1818_;
                                        if (_e1344 < 300000000000000000000000000000000000000f) {
                                            phi_1823_ = _e1344;
                                        } else {
                                            phi_1823_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1350 = phi_1823_;
                                        if (_e1214 < _e1347) {
                                            phi_1828_ = _e1347;
                                        } else {
                                            phi_1828_ = _e1214;
                                        }
                                        let _e1353 = phi_1828_;
                                        if (_e1353 > _e1350) {
                                            phi_1833_ = _e1350;
                                        } else {
                                            phi_1833_ = _e1353;
                                        }
                                        let _e1356 = phi_1833_;
                                        phi_1838_ = lt_bvh_triangle_Intersection(_e1356, (_e1146 / _e1205), (_e1167 / _e1205), (_e1347 <= _e1350));
                                    }
                                    let _e1362 = phi_1838_;
                                    phi_1839_ = _e1362;
                                    phi_1840_ = _e1208;
                                } else {
                                    phi_1839_ = lt_bvh_triangle_Intersection();
                                    phi_1840_ = true;
                                }
                                let _e1364 = phi_1839_;
                                let _e1366 = phi_1840_;
                                if _e1366 {
                                    phi_1844_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1844_ = _e1364;
                                }
                                let _e1368 = phi_1844_;
                                if _e1368.is_hit {
                                    if (_e1368.t > _e140.tmin) {
                                        if (_e1368.t < _e998.t) {
                                            phi_1893_ = true;
                                        } else {
                                            if (_e1368.t == _e998.t) {
                                                if (_e998.triangle != 4294967295u) {
                                                    if (_e1009 < _e998.triangle) {
                                                        phi_1884_ = true;
                                                    } else {
                                                        if (_e1009 == _e998.triangle) {
                                                            phi_1883_ = (4294967295u < _e998.instance);
                                                        } else {
                                                            phi_1883_ = false;
                                                        }
                                                        let _e1387 = phi_1883_;
                                                        phi_1884_ = _e1387;
                                                    }
                                                    let _e1389 = phi_1884_;
                                                    phi_1885_ = _e1389;
                                                    phi_1886_ = false;
                                                } else {
                                                    phi_1885_ = bool();
                                                    phi_1886_ = true;
                                                }
                                                let _e1391 = phi_1885_;
                                                let _e1393 = phi_1886_;
                                                phi_1887_ = _e1391;
                                                phi_1888_ = _e1393;
                                            } else {
                                                phi_1887_ = bool();
                                                phi_1888_ = true;
                                            }
                                            let _e1395 = phi_1887_;
                                            let _e1397 = phi_1888_;
                                            if _e1397 {
                                                phi_1892_ = false;
                                            } else {
                                                phi_1892_ = _e1395;
                                            }
                                            let _e1399 = phi_1892_;
                                            phi_1893_ = _e1399;
                                        }
                                        let _e1401 = phi_1893_;
                                        if _e1401 {
                                            let _e1403 = triangles.member[(0u + _e1009)].i0_;
                                            if ((_e1403 & 2147483648u) == 0u) {
                                                phi_1907_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1907_ = true;
                                            }
                                            let _e1407 = phi_1907_;
                                            if _e1407 {
                                                phi_1915_ = lt_bvh_Hit(_e1368.t, _e1368.u, _e1368.v, _e1009, 4294967295u);
                                            } else {
                                                phi_1915_ = _e998;
                                            }
                                            let _e1413 = phi_1915_;
                                            phi_1916_ = _e1413;
                                        } else {
                                            phi_1916_ = _e998;
                                        }
                                        let _e1415 = phi_1916_;
                                        phi_1917_ = _e1415;
                                    } else {
                                        phi_1917_ = _e998;
                                    }
                                    let _e1417 = phi_1917_;
                                    phi_1918_ = _e1417;
                                } else {
                                    phi_1918_ = _e998;
                                }
                                let _e1419 = phi_1918_;
                                phi_1380_ = _e1419;
                                phi_1383_ = (_e1000 & (_e1000 - 1u));
                                phi_1919_ = true;
                            }
                            let _e1421 = phi_1380_;
                            let _e1423 = phi_1383_;
                            let _e1425 = phi_1919_;
                            continue;
                            continuing {
                                phi_1379_ = _e1421;
                                phi_1382_ = _e1423;
                                break if !(_e1425);
                            }
                        }
                        let _e1428 = local_2.group_mask;
                        if ((_e1428 & 4278190080u) == 0u) {
                            let _e1432 = local_2.len;
                            if (_e1432 == 0u) {
                                phi_1958_ = false;
                            } else {
                                let _e1436 = local_2.len;
                                local_2.len = (_e1436 - 1u);
                                let _e1439 = local_2.len;
                                if (_e1439 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1444 = local_2.first[(0u + _e1439)];
                                local_2.group = _e1444;
                                let _e1447 = local_2.len;
                                if (_e1447 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1452 = local_2.mask[(0u + _e1447)];
                                local_2.group_mask = _e1452;
                                phi_1958_ = true;
                            }
                            let _e1455 = phi_1958_;
                            phi_1959_ = _e1455;
                        } else {
                            phi_1959_ = true;
                        }
                        let _e1457 = phi_1959_;
                        if _e1457 {
                            let _e1459 = local_2.group_mask;
                            let _e1465 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1459)), 32u, (_e1459 == 0u)));
                            let _e1469 = local_2.group_mask;
                            let _e1483 = local_2.group_mask;
                            local_2.group_mask = (_e1483 & ~((1u << bitcast<u32>((_e1465 & 31u)))));
                            let _e1486 = local_2.group;
                            phi_1990_ = (_e1486 + countOneBits(((_e1469 & ~((4294967295u << bitcast<u32>((((_e1465 - 24u) ^ _e417) & 31u))))) & 255u)));
                        } else {
                            phi_1990_ = 4294967295u;
                        }
                        let _e1489 = phi_1990_;
                        let _e1941 = local_6;
                        phi_1043_ = _e1941;
                        phi_1046_ = _e1489;
                    } else {
                        phi_1043_ = lt_bvh_Hit();
                        phi_1046_ = u32();
                    }
                    let _e1491 = phi_1043_;
                    let _e1493 = phi_1046_;
                    continue;
                    continuing {
                        phi_1042_ = _e1491;
                        phi_1045_ = _e1493;
                        break if !(_e558);
                    }
                }
                let _e1945 = local_7;
                phi_1991_ = _e1945;
            }
            let _e1496 = phi_1991_;
            phi_1992_ = _e1496;
            phi_1993_ = _e212;
        } else {
            phi_1992_ = lt_bvh_Hit();
            phi_1993_ = true;
        }
        let _e1498 = phi_1992_;
        let _e1500 = phi_1993_;
        if _e1500 {
            phi_1997_ = _e142;
        } else {
            phi_1997_ = _e1498;
        }
        let _e1502 = phi_1997_;
        if (_e1502.triangle != 4294967295u) {
            let _e1507 = lt_shaders_surface_barycentric_weights(_e1502.u, _e1502.v);
            if (_e1502.triangle < _e70) {
            } else {
                return;
            }
            let _e1512 = triangles.member[(0u + _e1502.triangle)];
            let _e1540 = (((_e1512.v0_.x * _e1507.x) + (_e1512.v1_.x * _e1507.y)) + (_e1512.v2_.x * _e1507.z));
            let _e1541 = (((_e1512.v0_.y * _e1507.x) + (_e1512.v1_.y * _e1507.y)) + (_e1512.v2_.y * _e1507.z));
            let _e1542 = (((_e1512.v0_.z * _e1507.x) + (_e1512.v1_.z * _e1507.y)) + (_e1512.v2_.z * _e1507.z));
            let _e1545 = abs(_e1512.v0_.x);
            let _e1547 = abs(_e1512.v0_.y);
            let _e1549 = abs(_e1512.v0_.z);
            let _e1551 = abs(_e1512.v1_.x);
            let _e1553 = abs(_e1512.v1_.y);
            let _e1555 = abs(_e1512.v1_.z);
            if (_e1545 > _e1551) {
                phi_2063_ = _e1545;
            } else {
                phi_2063_ = _e1551;
            }
            let _e1558 = phi_2063_;
            if (_e1547 > _e1553) {
                phi_2068_ = _e1547;
            } else {
                phi_2068_ = _e1553;
            }
            let _e1561 = phi_2068_;
            if (_e1549 > _e1555) {
                phi_2073_ = _e1549;
            } else {
                phi_2073_ = _e1555;
            }
            let _e1564 = phi_2073_;
            let _e1566 = abs(_e1512.v2_.x);
            let _e1568 = abs(_e1512.v2_.y);
            let _e1570 = abs(_e1512.v2_.z);
            if (_e1558 > _e1566) {
                phi_2084_ = _e1558;
            } else {
                phi_2084_ = _e1566;
            }
            let _e1573 = phi_2084_;
            if (_e1561 > _e1568) {
                phi_2089_ = _e1561;
            } else {
                phi_2089_ = _e1568;
            }
            let _e1576 = phi_2089_;
            if (_e1564 > _e1570) {
                phi_2094_ = _e1564;
            } else {
                phi_2094_ = _e1570;
            }
            let _e1579 = phi_2094_;
            let _e1582 = (_e1512.v1_.x - _e1512.v0_.x);
            let _e1585 = (_e1512.v1_.y - _e1512.v0_.y);
            let _e1588 = (_e1512.v1_.z - _e1512.v0_.z);
            let _e1591 = (_e1512.v2_.x - _e1512.v0_.x);
            let _e1594 = (_e1512.v2_.y - _e1512.v0_.y);
            let _e1597 = (_e1512.v2_.z - _e1512.v0_.z);
            let _e1601 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1585), abs(_e1588));
            let _e1602 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1582), _e1601);
            let _e1603 = (_e1582 / _e1602);
            let _e1604 = (_e1585 / _e1602);
            let _e1605 = (_e1588 / _e1602);
            let _e1609 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1594), abs(_e1597));
            let _e1610 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1591), _e1609);
            let _e1611 = (_e1591 / _e1610);
            let _e1612 = (_e1594 / _e1610);
            let _e1613 = (_e1597 / _e1610);
            let _e1616 = ((_e1604 * _e1613) - (_e1612 * _e1605));
            let _e1619 = ((_e1605 * _e1611) - (_e1613 * _e1603));
            let _e1622 = ((_e1603 * _e1612) - (_e1611 * _e1604));
            let _e1624 = p.member.eye;
            let _e1633 = (1f / sqrt((((_e1616 * _e1616) + (_e1619 * _e1619)) + (_e1622 * _e1622))));
            let _e1638 = lt_shaders_camera_facing(vec3<f32>((_e1616 * _e1633), (_e1619 * _e1633), (_e1622 * _e1633)), (_e1624 - vec3<f32>(_e1540, _e1541, _e1542)));
            if (_e1502.triangle < _e70) {
            } else {
                return;
            }
            let _e1643 = triangles.member[(0u + _e1502.triangle)];
            let _e1645 = (_e1643.i0_ & 2147483647u);
            if (_e1645 < _e73) {
            } else {
                return;
            }
            let _e1651 = vertices.member[(0u + _e1645)];
            if (_e1643.i1_ < _e73) {
            } else {
                return;
            }
            let _e1655 = vertices.member[(0u + _e1643.i1_)];
            if (_e1643.i2_ < _e73) {
            } else {
                return;
            }
            let _e1659 = vertices.member[(0u + _e1643.i2_)];
            let _e1660 = array<abi_Vertex, 3>(_e1651, _e1655, _e1659);
            local = array<abi_Vertex, 3>(abi_Vertex(_e1660[0].u, _e1660[0].v, _e1660[0].normal, _e1660[0].color, _e1660[0].material), abi_Vertex(_e1660[1].u, _e1660[1].v, _e1660[1].normal, _e1660[1].color, _e1660[1].material), abi_Vertex(_e1660[2].u, _e1660[2].v, _e1660[2].normal, _e1660[2].color, _e1660[2].material));
            let _e1685 = local[0u].material;
            if (_e1685 < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1689 = materials.member[(0u + _e1685)];
            local_1 = abi_Material(_e1689.base_color, _e1689.cutoff, _e1689.flags, _e1689.alpha_offset, _e1689.alpha_size, _e1689.color_offset, _e1689.color_size, _e1689.pad);
            let _e1699 = lt_shaders_surface_plain_color((&local_1), (&local), _e1507);
            let _e1700 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(_e1507);
            let _e1702 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1576, _e1579);
            let _e1703 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1573, _e1702);
            let _e1705 = local_1.flags;
            if ((_e1705 & 2u) == 0u) {
                phi_2242_ = 0u;
            } else {
                phi_2242_ = 1u;
            }
            let _e1709 = phi_2242_;
            let _e1712 = local[0u].normal;
            if (_e1712 == 2147516416u) {
                phi_2309_ = _e1638;
            } else {
                let _e1716 = local[0u].normal;
                let _e1717 = lt_shaders_surface_octahedral_decode(_e1716);
                let _e1727 = local[1u].normal;
                let _e1728 = lt_shaders_surface_octahedral_decode(_e1727);
                let _e1741 = local[2u].normal;
                let _e1742 = lt_shaders_surface_octahedral_decode(_e1741);
                let _e1754 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>((((_e1717.x * _e1507.x) + (_e1728.x * _e1507.y)) + (_e1742.x * _e1507.z)), (((_e1717.y * _e1507.x) + (_e1728.y * _e1507.y)) + (_e1742.y * _e1507.z)), (((_e1717.z * _e1507.x) + (_e1728.z * _e1507.y)) + (_e1742.z * _e1507.z))));
                let _e1766 = sqrt((((_e1754.x * _e1754.x) + (_e1754.y * _e1754.y)) + (_e1754.z * _e1754.z)));
                if (_e1766 > 0f) {
                    let _e1770 = lt_shaders_camera_facing((_e1754 / vec3(_e1766)), _e1638);
                    phi_2308_ = _e1770;
                } else {
                    phi_2308_ = _e1638;
                }
                let _e1772 = phi_2308_;
                phi_2309_ = _e1772;
            }
            let _e1774 = phi_2309_;
            let _e1775 = lt_shaders_shade_pack_albedo((_e1699 * _e1700));
            phi_2313_ = abi_Sample(vec3<f32>(_e1540, _e1541, _e1542), _e1703, _e1638, _e1709, _e1774, _e1775);
        } else {
            phi_2313_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e1779 = phi_2313_;
        if (_e85.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e85.first_primitive)] = _e1779;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
