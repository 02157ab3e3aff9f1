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

struct type_42 {
    member: array<abi_Sample>,
}

struct type_46 {
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

struct type_54 {
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

struct type_60 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_42;
@group(0) @binding(0) 
var<uniform> p: type_60;
@group(0) @binding(2) 
var<storage> nodes: type_54;
@group(0) @binding(3) 
var<storage> triangles: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_46;
@group(0) @binding(5) 
var<storage> list: type_22;
@group(0) @binding(6) 
var<storage> vertices: type_13;
@group(0) @binding(7) 
var<storage> materials: type_18;
@group(0) @binding(8) 
var<storage> alpha_texels: type_22;

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

fn lt_shaders_surface_texture_coordinate(param_3: ptr<function, array<abi_Vertex, 3>>, param_4: vec3<f32>) -> vec2<f32> {
    let _e64 = (*param_3)[0u].u;
    let _e67 = (*param_3)[0u].v;
    let _e73 = (*param_3)[1u].u;
    let _e76 = (*param_3)[1u].v;
    let _e84 = (*param_3)[2u].u;
    let _e87 = (*param_3)[2u].v;
    return vec2<f32>((((_e64 * param_4.x) + (_e73 * param_4.y)) + (_e84 * param_4.z)), (((_e67 * param_4.x) + (_e76 * param_4.y)) + (_e87 * param_4.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_5: f32, param_6: u32) -> f32 {
    var phi_452_: f32;
    var phi_453_: f32;
    var phi_454_: f32;
    var phi_463_: f32;
    var phi_464_: f32;

    if (param_6 == 0u) {
        phi_454_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e69 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e69 > 1f) {
                phi_452_ = (2f - _e69);
            } else {
                phi_452_ = _e69;
            }
            let _e73 = phi_452_;
            phi_453_ = _e73;
        } else {
            phi_453_ = param_5;
        }
        let _e75 = phi_453_;
        phi_454_ = _e75;
    }
    let _e77 = phi_454_;
    if (_e77 > 0f) {
        if (_e77 < 1f) {
            phi_463_ = _e77;
        } else {
            phi_463_ = 1f;
        }
        let _e81 = phi_463_;
        phi_464_ = _e81;
    } else {
        phi_464_ = 0f;
    }
    let _e83 = phi_464_;
    return _e83;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_390_: u32;
    var phi_404_: u32;
    var phi_411_: u32;
    var phi_416_: u32;
    var phi_422_: u32;
    var phi_427_: u32;
    var phi_429_: texture_Axis;

    let _e64 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e65 = (param_8 - 1u);
    let _e67 = (_e64 * f32(param_8));
    if param_10 {
        let _e74 = select(select(u32(_e67), 0u, (_e67 < bitcast<f32>(0u))), 4294967295u, (_e67 > bitcast<f32>(1333788671u)));
        if (_e65 < _e74) {
            phi_390_ = _e65;
        } else {
            phi_390_ = _e74;
        }
        let _e77 = phi_390_;
        phi_429_ = texture_Axis(_e77, _e77, 0f);
    } else {
        let _e79 = (_e67 + 0.5f);
        let _e86 = select(select(u32(_e79), 0u, (_e79 < bitcast<f32>(0u))), 4294967295u, (_e79 > bitcast<f32>(1333788671u)));
        if (param_8 < _e86) {
            phi_404_ = param_8;
        } else {
            phi_404_ = _e86;
        }
        let _e89 = phi_404_;
        if (param_9 == 0u) {
            phi_411_ = _e65;
        } else {
            phi_411_ = 0u;
        }
        let _e94 = phi_411_;
        if (param_9 == 0u) {
            phi_416_ = 0u;
        } else {
            phi_416_ = _e65;
        }
        let _e97 = phi_416_;
        if (_e89 == 0u) {
            phi_422_ = _e94;
        } else {
            phi_422_ = (_e89 - 1u);
        }
        let _e101 = phi_422_;
        if (_e89 > _e65) {
            phi_427_ = _e97;
        } else {
            phi_427_ = _e89;
        }
        let _e104 = phi_427_;
        phi_429_ = texture_Axis(_e101, _e104, (_e79 - f32(_e89)));
    }
    let _e107 = phi_429_;
    return _e107;
}

fn _lt_shaders_texture_TextureView_quad(param_11: ptr<function, texture_TextureView>, param_12: f32, param_13: f32) -> texture_TexelQuad {
    let _e64 = (*param_11).size;
    let _e65 = (_e64 & 65535u);
    let _e67 = (*param_11).size;
    let _e71 = (*param_11).flags;
    let _e73 = ((_e71 & 4u) != 0u);
    let _e75 = (*param_11).flags;
    let _e79 = lt_shaders_texture_axis(param_12, _e65, ((_e75 >> bitcast<u32>(4u)) & 3u), _e73);
    let _e81 = (*param_11).flags;
    let _e85 = lt_shaders_texture_axis(param_13, (_e67 >> bitcast<u32>(16i)), ((_e81 >> bitcast<u32>(6u)) & 3u), _e73);
    let _e89 = (*param_11).offset;
    let _e96 = (*param_11).offset;
    let _e103 = (*param_11).offset;
    let _e110 = (*param_11).offset;
    return texture_TexelQuad(array<u32, 4>(((_e89 + (_e85.low * _e65)) + _e79.low), ((_e96 + (_e85.low * _e65)) + _e79.high), ((_e103 + (_e85.high * _e65)) + _e79.low), ((_e110 + (_e85.high * _e65)) + _e79.high)), vec4<f32>(((1f - _e79.fraction) * (1f - _e85.fraction)), (_e79.fraction * (1f - _e85.fraction)), ((1f - _e79.fraction) * _e85.fraction), (_e79.fraction * _e85.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_14: f32, param_15: f32) -> f32 {
    var phi_476_: bool;
    var phi_480_: f32;

    if (param_14 != param_14) {
        phi_476_ = true;
    } else {
        let _e63 = (param_15 >= param_14);
        if _e63 {
        }
        phi_476_ = _e63;
    }
    let _e65 = phi_476_;
    if _e65 {
        phi_480_ = param_15;
    } else {
        phi_480_ = param_14;
    }
    let _e67 = phi_480_;
    return _e67;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_16: f32, param_17: f32) -> f32 {
    var phi_492_: bool;
    var phi_496_: f32;

    if (param_16 != param_16) {
        phi_492_ = true;
    } else {
        let _e63 = (param_17 <= param_16);
        if _e63 {
        }
        phi_492_ = _e63;
    }
    let _e65 = phi_492_;
    if _e65 {
        phi_496_ = param_17;
    } else {
        phi_496_ = param_16;
    }
    let _e67 = phi_496_;
    return _e67;
}

fn lt_shaders_surface_barycentric_weights(param_18: f32, param_19: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_18) - param_19), param_18, param_19);
}

fn lt_shaders_evaluate_to_light(param_20: vec3<f32>, param_21: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_21.x - (param_20.x * param_21.w)), (param_21.y - (param_20.y * param_21.w)), (param_21.z - (param_20.z * param_21.w)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: lt_bvh_traverse_Stack;
    var phi_610_: f32;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_686_: bool;
    var phi_690_: bool;
    var phi_764_: f32;
    var phi_771_: f32;
    var phi_779_: f32;
    var phi_786_: f32;
    var phi_794_: f32;
    var phi_801_: f32;
    var phi_818_: f32;
    var phi_823_: f32;
    var phi_828_: f32;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_868_: u32;
    var phi_869_: u32;
    var phi_886_: vec3<f32>;
    var phi_887_: vec3<f32>;
    var phi_900_: u32;
    var phi_905_: u32;
    var phi_910_: u32;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1056_: u32;
    var phi_1058_: u32;
    var phi_1139_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1166_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1193_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1199_: u32;
    var phi_1202_: u32;
    var phi_1216_: u32;
    var phi_1226_: u32;
    var phi_1236_: u32;
    var phi_1254_: u32;
    var phi_1264_: u32;
    var phi_1274_: u32;
    var phi_1310_: u32;
    var phi_1323_: u32;
    var phi_1328_: u32;
    var phi_1329_: u32;
    var phi_1330_: u32;
    var phi_1200_: u32;
    var phi_1203_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1388_: u32;
    var phi_1433_: vec3<f32>;
    var phi_1434_: vec3<f32>;
    var phi_1465_: vec3<f32>;
    var phi_1466_: vec3<f32>;
    var phi_1497_: vec3<f32>;
    var phi_1498_: vec3<f32>;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1523_: f32;
    var phi_1524_: f32;
    var phi_1525_: f32;
    var phi_1526_: f32;
    var phi_1534_: f32;
    var phi_1544_: bool;
    var phi_1545_: bool;
    var phi_1549_: f32;
    var phi_1550_: f32;
    var phi_1551_: f32;
    var phi_1552_: f32;
    var phi_1560_: f32;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1586_: f32;
    var phi_1601_: f32;
    var phi_1602_: bool;
    var phi_1603_: f32;
    var phi_1604_: bool;
    var phi_1605_: f32;
    var phi_1606_: bool;
    var phi_1624_: f32;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1627_: f32;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1633_: bool;
    var phi_1634_: f32;
    var phi_1635_: bool;
    var phi_1661_: f32;
    var phi_1670_: f32;
    var phi_1679_: f32;
    var phi_1688_: f32;
    var phi_1695_: f32;
    var phi_1702_: f32;
    var phi_1715_: f32;
    var phi_1724_: f32;
    var phi_1733_: f32;
    var phi_1742_: f32;
    var phi_1749_: f32;
    var phi_1756_: f32;
    var phi_1773_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1791_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1813_: f32;
    var phi_1818_: f32;
    var phi_1823_: f32;
    var phi_1828_: f32;
    var phi_1833_: lt_bvh_triangle_Intersection;
    var phi_1834_: lt_bvh_triangle_Intersection;
    var phi_1835_: bool;
    var phi_1839_: lt_bvh_triangle_Intersection;
    var phi_2048_: f32;
    var phi_2051_: bool;
    var phi_2052_: bool;
    var phi_2056_: bool;
    var phi_2057_: bool;
    var phi_2058_: bool;
    var phi_2059_: bool;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2067_: bool;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_1389_: u32;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2075_: bool;
    var local_6: bool;
    var phi_2117_: bool;
    var phi_2118_: bool;
    var phi_2149_: u32;
    var phi_2150_: u32;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_1059_: u32;
    var phi_2153_: bool;
    var phi_2154_: bool;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var local_7: bool;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2165_: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2176_: bool;
    var phi_2180_: f32;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;

    let _e63 = id_1;
    let _e70 = arrayLength((&nodes.member));
    let _e73 = arrayLength((&triangles.member));
    let _e79 = arrayLength((&list.member));
    let _e82 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&alpha_texels.member));
    if (3u < _e79) {
    } else {
        return;
    }
    let _e92 = list.member[3u];
    if (_e63.x < _e92) {
        let _e95 = (_e63.x + 4u);
        if (_e95 < _e79) {
        } else {
            return;
        }
        let _e99 = list.member[(0u + _e95)];
        if (_e99 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e104 = p.member.light;
        let _e106 = samples.member[(0u + _e99)].position;
        let _e108 = samples.member[(0u + _e99)].normal;
        let _e110 = samples.member[(0u + _e99)].magnitude;
        let _e112 = ((8f / 8388608f) * _e110);
        let _e114 = (_e108.x * _e112);
        let _e116 = (_e108.y * _e112);
        let _e118 = (_e108.z * _e112);
        let _e120 = (_e106.x + _e114);
        let _e122 = (_e106.y + _e116);
        let _e124 = (_e106.z + _e118);
        let _e126 = (_e106 + vec3<f32>(_e114, _e116, _e118));
        if (_e104.w == 0f) {
            phi_610_ = 300000000000000000000000000000000000000f;
        } else {
            phi_610_ = 1f;
        }
        let _e130 = phi_610_;
        let _e131 = lt_shaders_evaluate_to_light(_e126, _e104);
        let _e132 = lt_bvh_Ray(_e126, 0f, _e131, _e130);
        let _e137 = abs(_e131.x);
        let _e139 = abs(_e131.y);
        let _e141 = abs(_e131.z);
        if (abs(_e120) < 1000000000000000f) {
            if (abs(_e122) < 1000000000000000f) {
                if (abs(_e124) < 1000000000000000f) {
                    if (_e137 < 1000000000000000f) {
                        if (_e139 < 1000000000000000f) {
                            if (_e141 < 1000000000000000f) {
                                if (_e137 > 0f) {
                                    phi_660_ = bool();
                                    phi_661_ = true;
                                } else {
                                    let _e149 = (_e139 > 0f);
                                    if _e149 {
                                        phi_659_ = bool();
                                    } else {
                                        phi_659_ = (_e141 > 0f);
                                    }
                                    let _e152 = phi_659_;
                                    phi_660_ = _e152;
                                    phi_661_ = _e149;
                                }
                                let _e154 = phi_660_;
                                let _e156 = phi_661_;
                                if _e156 {
                                    phi_665_ = true;
                                } else {
                                    phi_665_ = _e154;
                                }
                                let _e158 = phi_665_;
                                phi_666_ = _e158;
                                phi_667_ = false;
                            } else {
                                phi_666_ = bool();
                                phi_667_ = true;
                            }
                            let _e160 = phi_666_;
                            let _e162 = phi_667_;
                            phi_668_ = _e160;
                            phi_669_ = false;
                            phi_670_ = _e162;
                        } else {
                            phi_668_ = bool();
                            phi_669_ = true;
                            phi_670_ = false;
                        }
                        let _e164 = phi_668_;
                        let _e166 = phi_669_;
                        let _e168 = phi_670_;
                        phi_671_ = _e164;
                        phi_672_ = _e166;
                        phi_673_ = _e168;
                    } else {
                        phi_671_ = bool();
                        phi_672_ = true;
                        phi_673_ = false;
                    }
                    let _e170 = phi_671_;
                    let _e172 = phi_672_;
                    let _e174 = phi_673_;
                    phi_674_ = _e170;
                    phi_675_ = _e172;
                    phi_676_ = _e174;
                } else {
                    phi_674_ = bool();
                    phi_675_ = true;
                    phi_676_ = false;
                }
                let _e176 = phi_674_;
                let _e178 = phi_675_;
                let _e180 = phi_676_;
                phi_677_ = _e176;
                phi_678_ = _e178;
                phi_679_ = _e180;
            } else {
                phi_677_ = bool();
                phi_678_ = true;
                phi_679_ = false;
            }
            let _e182 = phi_677_;
            let _e184 = phi_678_;
            let _e186 = phi_679_;
            phi_680_ = _e182;
            phi_681_ = _e184;
            phi_682_ = _e186;
        } else {
            phi_680_ = bool();
            phi_681_ = true;
            phi_682_ = false;
        }
        let _e188 = phi_680_;
        let _e190 = phi_681_;
        let _e192 = phi_682_;
        if _e190 {
            phi_686_ = true;
        } else {
            phi_686_ = _e192;
        }
        let _e194 = phi_686_;
        if _e194 {
            phi_690_ = false;
        } else {
            phi_690_ = _e188;
        }
        let _e196 = phi_690_;
        if _e196 {
            let _e197 = (0u >= _e70);
            if _e197 {
                phi_2170_ = bool();
            } else {
                if (0u < _e70) {
                } else {
                    return;
                }
                let _e203 = nodes.member[(0u + 0u)].frame[0u];
                let _e207 = nodes.member[(0u + 0u)].frame[1u];
                let _e211 = nodes.member[(0u + 0u)].frame[2u];
                let _e215 = nodes.member[(0u + 0u)].frame[0u];
                let _e219 = nodes.member[(0u + 0u)].frame[1u];
                let _e223 = nodes.member[(0u + 0u)].frame[2u];
                let _e227 = nodes.member[(0u + 0u)].frame[3u];
                let _e264 = core_intrinsics_maximum_number_nsz_f32_(abs(_e131.x), abs(_e131.y));
                let _e265 = core_intrinsics_maximum_number_nsz_f32_(_e264, abs(_e131.z));
                let _e266 = (_e265 * 0.0000000000009094947f);
                if (abs(_e132.direction.x) < _e266) {
                    phi_764_ = _e266;
                } else {
                    phi_764_ = abs(_e132.direction.x);
                }
                let _e273 = phi_764_;
                if (_e132.direction.x < 0f) {
                    phi_771_ = (-1f / _e273);
                } else {
                    phi_771_ = (1f / _e273);
                }
                let _e278 = phi_771_;
                if (abs(_e132.direction.y) < _e266) {
                    phi_779_ = _e266;
                } else {
                    phi_779_ = abs(_e132.direction.y);
                }
                let _e285 = phi_779_;
                if (_e132.direction.y < 0f) {
                    phi_786_ = (-1f / _e285);
                } else {
                    phi_786_ = (1f / _e285);
                }
                let _e290 = phi_786_;
                if (abs(_e132.direction.z) < _e266) {
                    phi_794_ = _e266;
                } else {
                    phi_794_ = abs(_e132.direction.z);
                }
                let _e297 = phi_794_;
                if (_e132.direction.z < 0f) {
                    phi_801_ = (-1f / _e297);
                } else {
                    phi_801_ = (1f / _e297);
                }
                let _e302 = phi_801_;
                let _e306 = abs((bitcast<f32>(_e203) - _e120));
                let _e307 = abs((bitcast<f32>(_e207) - _e122));
                let _e308 = abs((bitcast<f32>(_e211) - _e124));
                let _e312 = abs(((bitcast<f32>(_e215) + (bitcast<f32>((((_e227 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                let _e313 = abs(((bitcast<f32>(_e219) + (bitcast<f32>((((_e227 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                let _e314 = abs(((bitcast<f32>(_e223) + (bitcast<f32>((((_e227 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e124));
                if (_e306 > _e312) {
                    phi_818_ = _e306;
                } else {
                    phi_818_ = _e312;
                }
                let _e317 = phi_818_;
                if (_e307 > _e313) {
                    phi_823_ = _e307;
                } else {
                    phi_823_ = _e313;
                }
                let _e320 = phi_823_;
                if (_e308 > _e314) {
                    phi_828_ = _e308;
                } else {
                    phi_828_ = _e314;
                }
                let _e323 = phi_828_;
                let _e324 = core_intrinsics_maximum_number_nsz_f32_(_e317, _e320);
                let _e325 = core_intrinsics_maximum_number_nsz_f32_(_e324, _e323);
                let _e329 = (_e325 * 0.0000019073486f);
                let _e330 = (abs(_e278) * _e329);
                let _e331 = (abs(_e290) * _e329);
                let _e332 = (abs(_e302) * _e329);
                let _e336 = (_e325 * 0.0000009536743f);
                let _e337 = (abs(_e278) * _e336);
                let _e338 = (abs(_e290) * _e336);
                let _e339 = (abs(_e302) * _e336);
                let _e341 = abs(_e131.x);
                let _e343 = abs(_e131.y);
                let _e345 = abs(_e131.z);
                if (_e341 >= _e343) {
                    if (_e341 >= _e345) {
                        phi_859_ = false;
                    } else {
                        phi_859_ = true;
                    }
                    let _e349 = phi_859_;
                    phi_860_ = _e349;
                } else {
                    phi_860_ = true;
                }
                let _e351 = phi_860_;
                if _e351 {
                    if (_e343 >= _e345) {
                        phi_868_ = 1u;
                    } else {
                        phi_868_ = 2u;
                    }
                    let _e354 = phi_868_;
                    phi_869_ = _e354;
                } else {
                    phi_869_ = 0u;
                }
                let _e356 = phi_869_;
                if (_e356 == 0u) {
                    phi_887_ = vec3<f32>(_e131.y, _e131.z, _e131.x);
                } else {
                    if (_e356 == 1u) {
                        phi_886_ = vec3<f32>(_e131.z, _e131.x, _e131.y);
                    } else {
                        phi_886_ = _e131;
                    }
                    let _e368 = phi_886_;
                    phi_887_ = _e368;
                }
                let _e370 = phi_887_;
                let _e373 = (_e370.x / _e370.z);
                let _e376 = (_e370.y / _e370.z);
                let _e378 = (1f / _e370.z);
                if (_e278 < 0f) {
                    phi_900_ = 0u;
                } else {
                    phi_900_ = 1u;
                }
                let _e381 = phi_900_;
                if (_e290 < 0f) {
                    phi_905_ = 0u;
                } else {
                    phi_905_ = 2u;
                }
                let _e384 = phi_905_;
                if (_e302 < 0f) {
                    phi_910_ = 0u;
                } else {
                    phi_910_ = 4u;
                }
                let _e387 = phi_910_;
                let _e389 = ((_e381 | _e384) | _e387);
                let _e390 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e390.first[0], _e390.first[1], _e390.first[2], _e390.first[3], _e390.first[4], _e390.first[5], _e390.first[6], _e390.first[7], _e390.first[8], _e390.first[9], _e390.first[10], _e390.first[11], _e390.first[12], _e390.first[13], _e390.first[14], _e390.first[15], _e390.first[16], _e390.first[17], _e390.first[18], _e390.first[19], _e390.first[20], _e390.first[21], _e390.first[22], _e390.first[23], _e390.first[24], _e390.first[25], _e390.first[26], _e390.first[27], _e390.first[28], _e390.first[29], _e390.first[30], _e390.first[31]), array<u32, 32>(_e390.mask[0], _e390.mask[1], _e390.mask[2], _e390.mask[3], _e390.mask[4], _e390.mask[5], _e390.mask[6], _e390.mask[7], _e390.mask[8], _e390.mask[9], _e390.mask[10], _e390.mask[11], _e390.mask[12], _e390.mask[13], _e390.mask[14], _e390.mask[15], _e390.mask[16], _e390.mask[17], _e390.mask[18], _e390.mask[19], _e390.mask[20], _e390.mask[21], _e390.mask[22], _e390.mask[23], _e390.mask[24], _e390.mask[25], _e390.mask[26], _e390.mask[27], _e390.mask[28], _e390.mask[29], _e390.mask[30], _e390.mask[31]), _e390.len, _e390.group, _e390.group_mask);
                let _e464 = local_2.group_mask;
                if ((_e464 & 4278190080u) == 0u) {
                    let _e468 = local_2.len;
                    if (_e468 == 0u) {
                        phi_1024_ = false;
                    } else {
                        let _e472 = local_2.len;
                        local_2.len = (_e472 - 1u);
                        let _e475 = local_2.len;
                        if (_e475 < 32u) {
                        } else {
                            return;
                        }
                        let _e480 = local_2.first[(0u + _e475)];
                        local_2.group = _e480;
                        let _e483 = local_2.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_2.mask[(0u + _e483)];
                        local_2.group_mask = _e488;
                        phi_1024_ = true;
                    }
                    let _e491 = phi_1024_;
                    phi_1025_ = _e491;
                } else {
                    phi_1025_ = true;
                }
                let _e493 = phi_1025_;
                if _e493 {
                    let _e495 = local_2.group_mask;
                    let _e501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e495)), 32u, (_e495 == 0u)));
                    let _e505 = local_2.group_mask;
                    let _e519 = local_2.group_mask;
                    local_2.group_mask = (_e519 & ~((1u << bitcast<u32>((_e501 & 31u)))));
                    let _e522 = local_2.group;
                    phi_1056_ = (_e522 + countOneBits(((_e505 & ~((4294967295u << bitcast<u32>((((_e501 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1056_ = 4294967295u;
                }
                let _e525 = phi_1056_;
                phi_1058_ = _e525;
                loop {
                    let _e527 = phi_1058_;
                    if (_e527 != 4294967295u) {
                        if (_e527 < _e70) {
                        } else {
                            return;
                        }
                        let _e534 = nodes.member[(0u + _e527)].frame[3u];
                        let _e559 = (bitcast<f32>((((_e534 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e278);
                        let _e560 = (bitcast<f32>((((_e534 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                        let _e561 = (bitcast<f32>((((_e534 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e564 = nodes.member[(0u + _e527)].frame[0u];
                        let _e568 = nodes.member[(0u + _e527)].frame[1u];
                        let _e572 = nodes.member[(0u + _e527)].frame[2u];
                        let _e577 = ((bitcast<f32>(_e564) - _e120) * _e278);
                        let _e578 = ((bitcast<f32>(_e568) - _e122) * _e290);
                        let _e579 = ((bitcast<f32>(_e572) - _e124) * _e302);
                        let _e587 = nodes.member[(0u + _e527)].x;
                        if (_e278 < 0f) {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e587.w), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e587.x, _e604.unnamed_1.first_primitive));
                            phi_1139_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e587.y));
                        } else {
                            let _e626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e626.unnamed.root, _e587.y), _e626.unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e632.unnamed, lt_bvh_traverse_Tree(_e587.z, _e632.unnamed_1.first_primitive));
                            phi_1139_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e638.unnamed_1.root, _e587.w));
                        }
                        let _e646 = phi_1139_;
                        let _e656 = nodes.member[(0u + _e527)].y;
                        if (_e290 < 0f) {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e656.w), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e656.x, _e673.unnamed_1.first_primitive));
                            phi_1166_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e656.y));
                        } else {
                            let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e695.unnamed.root, _e656.y), _e695.unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e701.unnamed, lt_bvh_traverse_Tree(_e656.z, _e701.unnamed_1.first_primitive));
                            phi_1166_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e707.unnamed_1.root, _e656.w));
                        }
                        let _e715 = phi_1166_;
                        let _e725 = nodes.member[(0u + _e527)].z;
                        if (_e302 < 0f) {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e725.w), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e725.x, _e742.unnamed_1.first_primitive));
                            phi_1193_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e725.y));
                        } else {
                            let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e764.unnamed.root, _e725.y), _e764.unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e770.unnamed, lt_bvh_traverse_Tree(_e725.z, _e770.unnamed_1.first_primitive));
                            phi_1193_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_bvh_traverse_Tree(_e776.unnamed_1.root, _e725.w));
                        }
                        let _e784 = phi_1193_;
                        phi_1199_ = 0u;
                        phi_1202_ = 0u;
                        loop {
                            let _e794 = phi_1199_;
                            let _e796 = phi_1202_;
                            local_3 = _e796;
                            local_4 = _e796;
                            local_5 = _e796;
                            let _e797 = (_e794 < 8u);
                            if _e797 {
                                let _e799 = (_e794 >> bitcast<u32>(2i));
                                let _e800 = (_e794 & 3u);
                                if (_e799 == 0u) {
                                    phi_1216_ = _e646.unnamed.root;
                                } else {
                                    phi_1216_ = _e646.unnamed.first_primitive;
                                }
                                let _e803 = phi_1216_;
                                if (_e799 == 0u) {
                                    phi_1226_ = _e715.unnamed.root;
                                } else {
                                    phi_1226_ = _e715.unnamed.first_primitive;
                                }
                                let _e812 = phi_1226_;
                                if (_e799 == 0u) {
                                    phi_1236_ = _e784.unnamed.root;
                                } else {
                                    phi_1236_ = _e784.unnamed.first_primitive;
                                }
                                let _e821 = phi_1236_;
                                let _e834 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e803 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e330)), ((f32(((_e812 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e560) + (_e578 - _e331)));
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(_e834, ((f32(((_e821 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e561) + (_e579 - _e332)));
                                if (_e799 == 0u) {
                                    phi_1254_ = _e646.unnamed_1.root;
                                } else {
                                    phi_1254_ = _e646.unnamed_1.first_primitive;
                                }
                                let _e838 = phi_1254_;
                                if (_e799 == 0u) {
                                    phi_1264_ = _e715.unnamed_1.root;
                                } else {
                                    phi_1264_ = _e715.unnamed_1.first_primitive;
                                }
                                let _e847 = phi_1264_;
                                if (_e799 == 0u) {
                                    phi_1274_ = _e784.unnamed_1.root;
                                } else {
                                    phi_1274_ = _e784.unnamed_1.first_primitive;
                                }
                                let _e856 = phi_1274_;
                                let _e869 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e838 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e330)), ((f32(((_e847 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e560) + (_e578 + _e331)));
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(_e869, ((f32(((_e856 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e561) + (_e579 + _e332)));
                                if (_e835 <= _e870) {
                                    if (_e835 <= _e130) {
                                        if (_e870 >= 0f) {
                                            if (_e799 == 0u) {
                                                let _e877 = nodes.member[(0u + _e527)].links[2u];
                                                phi_1310_ = _e877;
                                            } else {
                                                let _e880 = nodes.member[(0u + _e527)].links[3u];
                                                phi_1310_ = _e880;
                                            }
                                            let _e882 = phi_1310_;
                                            let _e887 = ((_e882 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u);
                                            let _e888 = (_e887 & 31u);
                                            if (_e888 >= 24u) {
                                                phi_1323_ = (24u + ((_e888 - 24u) ^ _e389));
                                            } else {
                                                phi_1323_ = _e888;
                                            }
                                            let _e894 = phi_1323_;
                                            phi_1328_ = (_e796 | ((_e887 >> bitcast<u32>(5i)) << bitcast<u32>((_e894 & 31u))));
                                        } else {
                                            phi_1328_ = _e796;
                                        }
                                        let _e902 = phi_1328_;
                                        phi_1329_ = _e902;
                                    } else {
                                        phi_1329_ = _e796;
                                    }
                                    let _e904 = phi_1329_;
                                    phi_1330_ = _e904;
                                } else {
                                    phi_1330_ = _e796;
                                }
                                let _e906 = phi_1330_;
                                phi_1200_ = (_e794 + 1u);
                                phi_1203_ = _e906;
                            } else {
                                phi_1200_ = u32();
                                phi_1203_ = u32();
                            }
                            let _e909 = phi_1200_;
                            let _e911 = phi_1203_;
                            continue;
                            continuing {
                                phi_1199_ = _e909;
                                phi_1202_ = _e911;
                                break if !(_e797);
                            }
                        }
                        let _e915 = nodes.member[(0u + _e527)].links[0u];
                        let _e919 = nodes.member[(0u + _e527)].frame[3u];
                        let _e923 = local_3;
                        if ((_e923 & 4278190080u) == 0u) {
                        } else {
                            let _e927 = local_2.group_mask;
                            if ((_e927 & 4278190080u) == 0u) {
                            } else {
                                let _e931 = local_2.len;
                                if (_e931 < 32u) {
                                    let _e934 = local_2.group;
                                    let _e936 = local_2.len;
                                    if (_e936 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e936)] = _e934;
                                    let _e942 = local_2.group_mask;
                                    let _e944 = local_2.len;
                                    if (_e944 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e944)] = _e942;
                                    let _e951 = local_2.len;
                                    local_2.len = (_e951 + 1u);
                                }
                            }
                            local_2.group = (0u + _e915);
                            let _e955 = local_4;
                            local_2.group_mask = ((_e955 & 4278190080u) | (_e919 >> bitcast<u32>(24i)));
                        }
                        let _e960 = local_5;
                        phi_1388_ = (_e960 & 16777215u);
                        loop {
                            let _e963 = phi_1388_;
                            let _e964 = (_e963 == 0u);
                            local_6 = _e964;
                            local_10 = _e964;
                            if _e964 {
                                phi_1389_ = u32();
                                phi_2073_ = false;
                                phi_2074_ = false;
                                phi_2075_ = false;
                            } else {
                                let _e967 = nodes.member[(0u + _e527)].links[1u];
                                let _e972 = ((0u + _e967) + select(firstTrailingBit(_e963), 32u, (_e963 == 0u)));
                                if (_e972 < _e73) {
                                } else {
                                    return;
                                }
                                let _e979 = triangles.member[(0u + _e972)].v0_;
                                let _e981 = (_e979.x - _e120);
                                let _e983 = (_e979.y - _e122);
                                let _e985 = (_e979.z - _e124);
                                if (_e356 == 0u) {
                                    phi_1434_ = vec3<f32>(_e983, _e985, _e981);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1433_ = vec3<f32>(_e985, _e981, _e983);
                                    } else {
                                        phi_1433_ = (_e979 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e993 = phi_1433_;
                                    phi_1434_ = _e993;
                                }
                                let _e995 = phi_1434_;
                                let _e999 = (_e995.x - (_e373 * _e995.z));
                                let _e1003 = (_e995.y - (_e376 * _e995.z));
                                let _e1007 = triangles.member[(0u + _e972)].v1_;
                                let _e1009 = (_e1007.x - _e120);
                                let _e1011 = (_e1007.y - _e122);
                                let _e1013 = (_e1007.z - _e124);
                                if (_e356 == 0u) {
                                    phi_1466_ = vec3<f32>(_e1011, _e1013, _e1009);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1465_ = vec3<f32>(_e1013, _e1009, _e1011);
                                    } else {
                                        phi_1465_ = (_e1007 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1021 = phi_1465_;
                                    phi_1466_ = _e1021;
                                }
                                let _e1023 = phi_1466_;
                                let _e1027 = (_e1023.x - (_e373 * _e1023.z));
                                let _e1031 = (_e1023.y - (_e376 * _e1023.z));
                                let _e1035 = triangles.member[(0u + _e972)].v2_;
                                let _e1037 = (_e1035.x - _e120);
                                let _e1039 = (_e1035.y - _e122);
                                let _e1041 = (_e1035.z - _e124);
                                if (_e356 == 0u) {
                                    phi_1498_ = vec3<f32>(_e1039, _e1041, _e1037);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1497_ = vec3<f32>(_e1041, _e1037, _e1039);
                                    } else {
                                        phi_1497_ = (_e1035 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1049 = phi_1497_;
                                    phi_1498_ = _e1049;
                                }
                                let _e1051 = phi_1498_;
                                let _e1055 = (_e1051.x - (_e373 * _e1051.z));
                                let _e1059 = (_e1051.y - (_e376 * _e1051.z));
                                if (_e1027 < _e1055) {
                                    phi_1519_ = true;
                                } else {
                                    if (_e1027 == _e1055) {
                                        phi_1518_ = (_e1031 < _e1059);
                                    } else {
                                        phi_1518_ = false;
                                    }
                                    let _e1066 = phi_1518_;
                                    phi_1519_ = _e1066;
                                }
                                let _e1068 = phi_1519_;
                                if _e1068 {
                                    phi_1523_ = _e1059;
                                    phi_1524_ = _e1055;
                                    phi_1525_ = _e1031;
                                    phi_1526_ = _e1027;
                                } else {
                                    phi_1523_ = _e1031;
                                    phi_1524_ = _e1027;
                                    phi_1525_ = _e1059;
                                    phi_1526_ = _e1055;
                                }
                                let _e1070 = phi_1523_;
                                let _e1072 = phi_1524_;
                                let _e1074 = phi_1525_;
                                let _e1076 = phi_1526_;
                                let _e1079 = ((_e1076 * _e1070) - (_e1074 * _e1072));
                                if _e1068 {
                                    phi_1534_ = -(_e1079);
                                } else {
                                    phi_1534_ = _e1079;
                                }
                                let _e1082 = phi_1534_;
                                if (_e1055 < _e999) {
                                    phi_1545_ = true;
                                } else {
                                    if (_e1055 == _e999) {
                                        phi_1544_ = (_e1059 < _e1003);
                                    } else {
                                        phi_1544_ = false;
                                    }
                                    let _e1087 = phi_1544_;
                                    phi_1545_ = _e1087;
                                }
                                let _e1089 = phi_1545_;
                                if _e1089 {
                                    phi_1549_ = _e1003;
                                    phi_1550_ = _e999;
                                    phi_1551_ = _e1059;
                                    phi_1552_ = _e1055;
                                } else {
                                    phi_1549_ = _e1059;
                                    phi_1550_ = _e1055;
                                    phi_1551_ = _e1003;
                                    phi_1552_ = _e999;
                                }
                                let _e1091 = phi_1549_;
                                let _e1093 = phi_1550_;
                                let _e1095 = phi_1551_;
                                let _e1097 = phi_1552_;
                                let _e1100 = ((_e1097 * _e1091) - (_e1095 * _e1093));
                                if _e1089 {
                                    phi_1560_ = -(_e1100);
                                } else {
                                    phi_1560_ = _e1100;
                                }
                                let _e1103 = phi_1560_;
                                if (_e999 < _e1027) {
                                    phi_1571_ = true;
                                } else {
                                    if (_e999 == _e1027) {
                                        phi_1570_ = (_e1003 < _e1031);
                                    } else {
                                        phi_1570_ = false;
                                    }
                                    let _e1108 = phi_1570_;
                                    phi_1571_ = _e1108;
                                }
                                let _e1110 = phi_1571_;
                                if _e1110 {
                                    phi_1575_ = _e1031;
                                    phi_1576_ = _e1027;
                                    phi_1577_ = _e1003;
                                    phi_1578_ = _e999;
                                } else {
                                    phi_1575_ = _e1003;
                                    phi_1576_ = _e999;
                                    phi_1577_ = _e1031;
                                    phi_1578_ = _e1027;
                                }
                                let _e1112 = phi_1575_;
                                let _e1114 = phi_1576_;
                                let _e1116 = phi_1577_;
                                let _e1118 = phi_1578_;
                                let _e1121 = ((_e1118 * _e1112) - (_e1116 * _e1114));
                                if _e1110 {
                                    phi_1586_ = -(_e1121);
                                } else {
                                    phi_1586_ = _e1121;
                                }
                                let _e1124 = phi_1586_;
                                if (_e1082 >= 0f) {
                                    if (_e1103 >= 0f) {
                                        if (_e1124 >= 0f) {
                                            phi_1601_ = ((_e1082 + _e1103) + _e1124);
                                            phi_1602_ = false;
                                        } else {
                                            phi_1601_ = f32();
                                            phi_1602_ = true;
                                        }
                                        let _e1131 = phi_1601_;
                                        let _e1133 = phi_1602_;
                                        phi_1603_ = _e1131;
                                        phi_1604_ = _e1133;
                                    } else {
                                        phi_1603_ = f32();
                                        phi_1604_ = true;
                                    }
                                    let _e1135 = phi_1603_;
                                    let _e1137 = phi_1604_;
                                    phi_1605_ = _e1135;
                                    phi_1606_ = _e1137;
                                } else {
                                    phi_1605_ = f32();
                                    phi_1606_ = true;
                                }
                                let _e1139 = phi_1605_;
                                let _e1141 = phi_1606_;
                                if _e1141 {
                                    if (_e1082 <= 0f) {
                                        if (_e1103 <= 0f) {
                                            let _e1144 = (_e1124 <= 0f);
                                            if _e1144 {
                                            }
                                            phi_1624_ = ((_e1082 + _e1103) + _e1124);
                                            phi_1625_ = false;
                                            phi_1626_ = _e1144;
                                        } else {
                                            phi_1624_ = f32();
                                            phi_1625_ = true;
                                            phi_1626_ = false;
                                        }
                                        let _e1148 = phi_1624_;
                                        let _e1150 = phi_1625_;
                                        let _e1152 = phi_1626_;
                                        phi_1627_ = _e1148;
                                        phi_1628_ = _e1150;
                                        phi_1629_ = _e1152;
                                    } else {
                                        phi_1627_ = f32();
                                        phi_1628_ = true;
                                        phi_1629_ = false;
                                    }
                                    let _e1154 = phi_1627_;
                                    let _e1156 = phi_1628_;
                                    let _e1158 = phi_1629_;
                                    if _e1156 {
                                        phi_1633_ = false;
                                    } else {
                                        phi_1633_ = _e1158;
                                    }
                                    let _e1160 = phi_1633_;
                                    phi_1634_ = _e1154;
                                    phi_1635_ = _e1160;
                                } else {
                                    phi_1634_ = _e1139;
                                    phi_1635_ = true;
                                }
                                let _e1162 = phi_1634_;
                                let _e1164 = phi_1635_;
                                if _e1164 {
                                    let _e1165 = (_e1162 == 0f);
                                    if _e1165 {
                                        phi_1833_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1171 = ((((_e1082 * (_e378 * _e995.z)) + (_e1103 * (_e378 * _e1023.z))) + (_e1124 * (_e378 * _e1051.z))) / _e1162);
                                        let _e1173 = triangles.member[(0u + _e972)].v0_;
                                        let _e1175 = triangles.member[(0u + _e972)].v1_;
                                        if (_e1173.x < _e1175.x) {
                                            phi_1661_ = _e1173.x;
                                        } else {
                                            phi_1661_ = _e1175.x;
                                        }
                                        let _e1182 = phi_1661_;
                                        if (_e1173.y < _e1175.y) {
                                            phi_1670_ = _e1173.y;
                                        } else {
                                            phi_1670_ = _e1175.y;
                                        }
                                        let _e1189 = phi_1670_;
                                        if (_e1173.z < _e1175.z) {
                                            phi_1679_ = _e1173.z;
                                        } else {
                                            phi_1679_ = _e1175.z;
                                        }
                                        let _e1196 = phi_1679_;
                                        let _e1198 = triangles.member[(0u + _e972)].v2_;
                                        if (_e1182 < _e1198.x) {
                                            phi_1688_ = _e1182;
                                        } else {
                                            phi_1688_ = _e1198.x;
                                        }
                                        let _e1203 = phi_1688_;
                                        if (_e1189 < _e1198.y) {
                                            phi_1695_ = _e1189;
                                        } else {
                                            phi_1695_ = _e1198.y;
                                        }
                                        let _e1208 = phi_1695_;
                                        if (_e1196 < _e1198.z) {
                                            phi_1702_ = _e1196;
                                        } else {
                                            phi_1702_ = _e1198.z;
                                        }
                                        let _e1213 = phi_1702_;
                                        let _e1215 = triangles.member[(0u + _e972)].v0_;
                                        let _e1217 = triangles.member[(0u + _e972)].v1_;
                                        if (_e1215.x > _e1217.x) {
                                            phi_1715_ = _e1215.x;
                                        } else {
                                            phi_1715_ = _e1217.x;
                                        }
                                        let _e1224 = phi_1715_;
                                        if (_e1215.y > _e1217.y) {
                                            phi_1724_ = _e1215.y;
                                        } else {
                                            phi_1724_ = _e1217.y;
                                        }
                                        let _e1231 = phi_1724_;
                                        if (_e1215.z > _e1217.z) {
                                            phi_1733_ = _e1215.z;
                                        } else {
                                            phi_1733_ = _e1217.z;
                                        }
                                        let _e1238 = phi_1733_;
                                        let _e1240 = triangles.member[(0u + _e972)].v2_;
                                        if (_e1224 > _e1240.x) {
                                            phi_1742_ = _e1224;
                                        } else {
                                            phi_1742_ = _e1240.x;
                                        }
                                        let _e1245 = phi_1742_;
                                        if (_e1231 > _e1240.y) {
                                            phi_1749_ = _e1231;
                                        } else {
                                            phi_1749_ = _e1240.y;
                                        }
                                        let _e1250 = phi_1749_;
                                        if (_e1238 > _e1240.z) {
                                            phi_1756_ = _e1238;
                                        } else {
                                            phi_1756_ = _e1240.z;
                                        }
                                        let _e1255 = phi_1756_;
                                        let _e1259 = ((_e1203 - _e120) * _e278);
                                        let _e1260 = ((_e1208 - _e122) * _e290);
                                        let _e1261 = ((_e1213 - _e124) * _e302);
                                        let _e1265 = ((_e1245 - _e120) * _e278);
                                        let _e1266 = ((_e1250 - _e122) * _e290);
                                        let _e1267 = ((_e1255 - _e124) * _e302);
                                        if (_e1259 < _e1265) {
                                            phi_1773_ = _e1259;
                                        } else {
                                            phi_1773_ = _e1265;
                                        }
                                        let _e1270 = phi_1773_;
                                        if (_e1260 < _e1266) {
                                            phi_1778_ = _e1260;
                                        } else {
                                            phi_1778_ = _e1266;
                                        }
                                        let _e1273 = phi_1778_;
                                        if (_e1261 < _e1267) {
                                            phi_1783_ = _e1261;
                                        } else {
                                            phi_1783_ = _e1267;
                                        }
                                        let _e1276 = phi_1783_;
                                        if (_e1259 > _e1265) {
                                            phi_1791_ = _e1259;
                                        } else {
                                            phi_1791_ = _e1265;
                                        }
                                        let _e1282 = phi_1791_;
                                        if (_e1260 > _e1266) {
                                            phi_1796_ = _e1260;
                                        } else {
                                            phi_1796_ = _e1266;
                                        }
                                        let _e1285 = phi_1796_;
                                        if (_e1261 > _e1267) {
                                            phi_1801_ = _e1261;
                                        } else {
                                            phi_1801_ = _e1267;
                                        }
                                        let _e1288 = phi_1801_;
                                        let _e1292 = core_intrinsics_maximum_number_nsz_f32_((_e1270 - _e337), (_e1273 - _e338));
                                        let _e1293 = core_intrinsics_maximum_number_nsz_f32_(_e1292, (_e1276 - _e339));
                                        let _e1294 = core_intrinsics_minimum_number_nsz_f32_((_e1282 + _e337), (_e1285 + _e338));
                                        let _e1295 = core_intrinsics_minimum_number_nsz_f32_(_e1294, (_e1288 + _e339));
                                        if (_e1293 > -300000000000000000000000000000000000000f) {
                                            phi_1813_ = _e1293;
                                        } else {
                                            phi_1813_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1298 = phi_1813_;
                                        if (_e1295 < 300000000000000000000000000000000000000f) {
                                            phi_1818_ = _e1295;
                                        } else {
                                            phi_1818_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1301 = phi_1818_;
                                        if (_e1171 < _e1298) {
                                            phi_1823_ = _e1298;
                                        } else {
                                            phi_1823_ = _e1171;
                                        }
                                        let _e1304 = phi_1823_;
                                        if (_e1304 > _e1301) {
                                            phi_1828_ = _e1301;
                                        } else {
                                            phi_1828_ = _e1304;
                                        }
                                        let _e1307 = phi_1828_;
                                        phi_1833_ = lt_bvh_triangle_Intersection(_e1307, (_e1103 / _e1162), (_e1124 / _e1162), (_e1298 <= _e1301));
                                    }
                                    let _e1313 = phi_1833_;
                                    phi_1834_ = _e1313;
                                    phi_1835_ = _e1165;
                                } else {
                                    phi_1834_ = lt_bvh_triangle_Intersection();
                                    phi_1835_ = true;
                                }
                                let _e1315 = phi_1834_;
                                let _e1317 = phi_1835_;
                                if _e1317 {
                                    phi_1839_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1839_ = _e1315;
                                }
                                let _e1319 = phi_1839_;
                                if _e1319.is_hit {
                                    if (_e1319.t > 0f) {
                                        if (_e1319.t < _e130) {
                                            let _e1326 = triangles.member[(0u + _e972)].i0_;
                                            let _e1328 = ((_e1326 & 2147483648u) == 0u);
                                            if _e1328 {
                                                phi_2057_ = false;
                                                phi_2058_ = false;
                                            } else {
                                                if (_e972 < _e73) {
                                                } else {
                                                    return;
                                                }
                                                let _e1335 = triangles.member[(0u + _e972)].i0_;
                                                let _e1336 = (_e1335 & 2147483647u);
                                                let _e1338 = triangles.member[(0u + _e972)].i1_;
                                                let _e1340 = triangles.member[(0u + _e972)].i2_;
                                                if (_e1336 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1344 = vertices.member[(0u + _e1336)];
                                                if (_e1338 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1348 = vertices.member[(0u + _e1338)];
                                                if (_e1340 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1352 = vertices.member[(0u + _e1340)];
                                                let _e1353 = array<abi_Vertex, 3>(_e1344, _e1348, _e1352);
                                                local_1 = array<abi_Vertex, 3>(abi_Vertex(_e1353[0].u, _e1353[0].v, _e1353[0].normal, _e1353[0].color, _e1353[0].material), abi_Vertex(_e1353[1].u, _e1353[1].v, _e1353[1].normal, _e1353[1].color, _e1353[1].material), abi_Vertex(_e1353[2].u, _e1353[2].v, _e1353[2].normal, _e1353[2].color, _e1353[2].material));
                                                let _e1378 = local_1[0u].material;
                                                if (_e1378 < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1382 = materials.member[(0u + _e1378)];
                                                if ((_e1382.flags & 1u) == 1u) {
                                                    let _e1386 = lt_shaders_surface_barycentric_weights(_e1319.u, _e1319.v);
                                                    if (_e1382.cutoff <= 0f) {
                                                        phi_2051_ = true;
                                                    } else {
                                                        let _e1391 = lt_shaders_surface_vertex_color((&local_1), _e1386);
                                                        let _e1393 = (_e1382.base_color.w * _e1391.w);
                                                        if (_e1382.alpha_size == 0u) {
                                                            phi_2048_ = _e1393;
                                                        } else {
                                                            local.offset = _e1382.alpha_offset;
                                                            local.size = _e1382.alpha_size;
                                                            local.flags = _e1382.flags;
                                                            let _e1402 = lt_shaders_surface_texture_coordinate((&local_1), _e1386);
                                                            let _e1405 = _lt_shaders_texture_TextureView_quad((&local), _e1402.x, _e1402.y);
                                                            let _e1409 = (_e1405.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1409 < _e88) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1413 = alpha_texels.member[(0u + _e1409)];
                                                            let _e1429 = (_e1405.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1429 < _e88) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1433 = alpha_texels.member[(0u + _e1429)];
                                                            let _e1450 = (_e1405.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1450 < _e88) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1454 = alpha_texels.member[(0u + _e1450)];
                                                            let _e1471 = (_e1405.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1471 < _e88) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1475 = alpha_texels.member[(0u + _e1471)];
                                                            phi_2048_ = (_e1393 * (((((f32(((_e1413 >> bitcast<u32>((((_e1405.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.x) + ((f32(((_e1433 >> bitcast<u32>((((_e1405.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.y)) + ((f32(((_e1454 >> bitcast<u32>((((_e1405.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.z)) + ((f32(((_e1475 >> bitcast<u32>((((_e1405.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.w)));
                                                        }
                                                        let _e1491 = phi_2048_;
                                                        phi_2051_ = (_e1491 >= _e1382.cutoff);
                                                    }
                                                    let _e1495 = phi_2051_;
                                                    phi_2052_ = _e1495;
                                                } else {
                                                    phi_2052_ = false;
                                                }
                                                let _e1497 = phi_2052_;
                                                if _e1497 {
                                                    phi_2056_ = false;
                                                } else {
                                                    phi_2056_ = true;
                                                }
                                                let _e1499 = phi_2056_;
                                                phi_2057_ = _e1499;
                                                phi_2058_ = _e1497;
                                            }
                                            let _e1501 = phi_2057_;
                                            let _e1503 = phi_2058_;
                                            phi_2059_ = _e1501;
                                            phi_2060_ = _e1328;
                                            phi_2061_ = _e1503;
                                        } else {
                                            phi_2059_ = true;
                                            phi_2060_ = false;
                                            phi_2061_ = false;
                                        }
                                        let _e1505 = phi_2059_;
                                        let _e1507 = phi_2060_;
                                        let _e1509 = phi_2061_;
                                        phi_2062_ = _e1505;
                                        phi_2063_ = _e1507;
                                        phi_2064_ = _e1509;
                                    } else {
                                        phi_2062_ = true;
                                        phi_2063_ = false;
                                        phi_2064_ = false;
                                    }
                                    let _e1511 = phi_2062_;
                                    let _e1513 = phi_2063_;
                                    let _e1515 = phi_2064_;
                                    phi_2065_ = _e1511;
                                    phi_2066_ = _e1513;
                                    phi_2067_ = _e1515;
                                } else {
                                    phi_2065_ = true;
                                    phi_2066_ = false;
                                    phi_2067_ = false;
                                }
                                let _e1517 = phi_2065_;
                                let _e1519 = phi_2066_;
                                let _e1521 = phi_2067_;
                                if _e1517 {
                                    phi_2071_ = false;
                                    phi_2072_ = false;
                                } else {
                                    phi_2071_ = _e1519;
                                    phi_2072_ = _e1521;
                                }
                                let _e1523 = phi_2071_;
                                let _e1525 = phi_2072_;
                                phi_1389_ = (_e963 & (_e963 - 1u));
                                phi_2073_ = _e1517;
                                phi_2074_ = _e1523;
                                phi_2075_ = _e1525;
                            }
                            let _e1527 = phi_1389_;
                            let _e1529 = phi_2073_;
                            let _e1531 = phi_2074_;
                            let _e1533 = phi_2075_;
                            local_8 = _e1531;
                            local_9 = _e1533;
                            continue;
                            continuing {
                                phi_1388_ = _e1527;
                                break if !(_e1529);
                            }
                        }
                        let _e1536 = local_6;
                        if _e1536 {
                            let _e1538 = local_2.group_mask;
                            if ((_e1538 & 4278190080u) == 0u) {
                                let _e1542 = local_2.len;
                                if (_e1542 == 0u) {
                                    phi_2117_ = false;
                                } else {
                                    let _e1546 = local_2.len;
                                    local_2.len = (_e1546 - 1u);
                                    let _e1549 = local_2.len;
                                    if (_e1549 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1554 = local_2.first[(0u + _e1549)];
                                    local_2.group = _e1554;
                                    let _e1557 = local_2.len;
                                    if (_e1557 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1562 = local_2.mask[(0u + _e1557)];
                                    local_2.group_mask = _e1562;
                                    phi_2117_ = true;
                                }
                                let _e1565 = phi_2117_;
                                phi_2118_ = _e1565;
                            } else {
                                phi_2118_ = true;
                            }
                            let _e1567 = phi_2118_;
                            if _e1567 {
                                let _e1569 = local_2.group_mask;
                                let _e1575 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1569)), 32u, (_e1569 == 0u)));
                                let _e1579 = local_2.group_mask;
                                let _e1593 = local_2.group_mask;
                                local_2.group_mask = (_e1593 & ~((1u << bitcast<u32>((_e1575 & 31u)))));
                                let _e1596 = local_2.group;
                                phi_2149_ = (_e1596 + countOneBits(((_e1579 & ~((4294967295u << bitcast<u32>((((_e1575 - 24u) ^ _e389) & 31u))))) & 255u)));
                            } else {
                                phi_2149_ = 4294967295u;
                            }
                            let _e1599 = phi_2149_;
                            phi_2150_ = _e1599;
                            phi_2151_ = false;
                            phi_2152_ = false;
                        } else {
                            phi_2150_ = u32();
                            let _e1804 = local_8;
                            phi_2151_ = _e1804;
                            let _e1807 = local_9;
                            phi_2152_ = _e1807;
                        }
                        let _e1601 = phi_2150_;
                        let _e1603 = phi_2151_;
                        let _e1605 = phi_2152_;
                        phi_1059_ = _e1601;
                        let _e1811 = local_10;
                        phi_2153_ = _e1811;
                        phi_2154_ = false;
                        phi_2155_ = _e1603;
                        phi_2156_ = _e1605;
                    } else {
                        phi_1059_ = u32();
                        phi_2153_ = false;
                        phi_2154_ = true;
                        phi_2155_ = false;
                        phi_2156_ = false;
                    }
                    let _e1607 = phi_1059_;
                    let _e1609 = phi_2153_;
                    let _e1611 = phi_2154_;
                    let _e1613 = phi_2155_;
                    let _e1615 = phi_2156_;
                    local_7 = _e1611;
                    local_11 = _e1613;
                    local_12 = _e1615;
                    continue;
                    continuing {
                        phi_1058_ = _e1607;
                        break if !(_e1609);
                    }
                }
                let _e1618 = local_7;
                if _e1618 {
                    phi_2160_ = false;
                    phi_2161_ = false;
                } else {
                    let _e1818 = local_11;
                    phi_2160_ = _e1818;
                    let _e1821 = local_12;
                    phi_2161_ = _e1821;
                }
                let _e1620 = phi_2160_;
                let _e1622 = phi_2161_;
                if _e1620 {
                    phi_2165_ = true;
                } else {
                    phi_2165_ = _e1622;
                }
                let _e1624 = phi_2165_;
                if _e1624 {
                    phi_2169_ = true;
                } else {
                    phi_2169_ = false;
                }
                let _e1626 = phi_2169_;
                phi_2170_ = _e1626;
            }
            let _e1628 = phi_2170_;
            phi_2171_ = _e1628;
            phi_2172_ = _e197;
        } else {
            phi_2171_ = bool();
            phi_2172_ = true;
        }
        let _e1630 = phi_2171_;
        let _e1632 = phi_2172_;
        if _e1632 {
            phi_2176_ = false;
        } else {
            phi_2176_ = _e1630;
        }
        let _e1634 = phi_2176_;
        if _e1634 {
            phi_2180_ = 0f;
        } else {
            phi_2180_ = 1f;
        }
        let _e1636 = phi_2180_;
        if (_e99 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99)] = _e1636;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
