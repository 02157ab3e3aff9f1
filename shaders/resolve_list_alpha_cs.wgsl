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
    let _e75 = (1f / 255f);
    return vec4<f32>((f32((param & 255u)) * _e75), (f32(((param >> bitcast<u32>(8i)) & 255u)) * _e75), (f32(((param >> bitcast<u32>(16i)) & 255u)) * _e75), (f32((param >> bitcast<u32>(24i))) * _e75));
}

fn lt_shaders_surface_vertex_color(param_1: ptr<function, array<abi_Vertex, 3>>, param_2: vec3<f32>) -> vec4<f32> {
    let _e65 = (*param_1)[0u].color;
    let _e66 = lt_shaders_texture_unorm_bytes(_e65);
    let _e78 = (*param_1)[1u].color;
    let _e79 = lt_shaders_texture_unorm_bytes(_e78);
    let _e95 = (*param_1)[2u].color;
    let _e96 = lt_shaders_texture_unorm_bytes(_e95);
    return vec4<f32>((((_e66.x * param_2.x) + (_e79.x * param_2.y)) + (_e96.x * param_2.z)), (((_e66.y * param_2.x) + (_e79.y * param_2.y)) + (_e96.y * param_2.z)), (((_e66.z * param_2.x) + (_e79.z * param_2.y)) + (_e96.z * param_2.z)), (((_e66.w * param_2.x) + (_e79.w * param_2.y)) + (_e96.w * param_2.z)));
}

fn lt_shaders_surface_texture_coordinate(param_3: ptr<function, array<abi_Vertex, 3>>, param_4: vec3<f32>) -> vec2<f32> {
    let _e65 = (*param_3)[0u].u;
    let _e68 = (*param_3)[0u].v;
    let _e74 = (*param_3)[1u].u;
    let _e77 = (*param_3)[1u].v;
    let _e85 = (*param_3)[2u].u;
    let _e88 = (*param_3)[2u].v;
    return vec2<f32>((((_e65 * param_4.x) + (_e74 * param_4.y)) + (_e85 * param_4.z)), (((_e68 * param_4.x) + (_e77 * param_4.y)) + (_e88 * param_4.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_5: f32, param_6: u32) -> f32 {
    var phi_456_: f32;
    var phi_457_: f32;
    var phi_458_: f32;
    var phi_467_: f32;
    var phi_468_: f32;

    if (param_6 == 0u) {
        phi_458_ = (param_5 - floor(param_5));
    } else {
        if (param_6 == 1u) {
            let _e70 = (param_5 - (2f * floor((param_5 * 0.5f))));
            if (_e70 > 1f) {
                phi_456_ = (2f - _e70);
            } else {
                phi_456_ = _e70;
            }
            let _e74 = phi_456_;
            phi_457_ = _e74;
        } else {
            phi_457_ = param_5;
        }
        let _e76 = phi_457_;
        phi_458_ = _e76;
    }
    let _e78 = phi_458_;
    if (_e78 > 0f) {
        if (_e78 < 1f) {
            phi_467_ = _e78;
        } else {
            phi_467_ = 1f;
        }
        let _e82 = phi_467_;
        phi_468_ = _e82;
    } else {
        phi_468_ = 0f;
    }
    let _e84 = phi_468_;
    return _e84;
}

fn lt_shaders_texture_axis(param_7: f32, param_8: u32, param_9: u32, param_10: bool) -> texture_Axis {
    var phi_394_: u32;
    var phi_408_: u32;
    var phi_415_: u32;
    var phi_420_: u32;
    var phi_426_: u32;
    var phi_431_: u32;
    var phi_433_: texture_Axis;

    let _e65 = lt_shaders_texture_wrap_to_unit(param_7, param_9);
    let _e66 = (param_8 - 1u);
    let _e68 = (_e65 * f32(param_8));
    if param_10 {
        let _e75 = select(select(u32(_e68), 0u, (_e68 < bitcast<f32>(0u))), 4294967295u, (_e68 > bitcast<f32>(1333788671u)));
        if (_e66 < _e75) {
            phi_394_ = _e66;
        } else {
            phi_394_ = _e75;
        }
        let _e78 = phi_394_;
        phi_433_ = texture_Axis(_e78, _e78, 0f);
    } else {
        let _e80 = (_e68 + 0.5f);
        let _e87 = select(select(u32(_e80), 0u, (_e80 < bitcast<f32>(0u))), 4294967295u, (_e80 > bitcast<f32>(1333788671u)));
        if (param_8 < _e87) {
            phi_408_ = param_8;
        } else {
            phi_408_ = _e87;
        }
        let _e90 = phi_408_;
        if (param_9 == 0u) {
            phi_415_ = _e66;
        } else {
            phi_415_ = 0u;
        }
        let _e95 = phi_415_;
        if (param_9 == 0u) {
            phi_420_ = 0u;
        } else {
            phi_420_ = _e66;
        }
        let _e98 = phi_420_;
        if (_e90 == 0u) {
            phi_426_ = _e95;
        } else {
            phi_426_ = (_e90 - 1u);
        }
        let _e102 = phi_426_;
        if (_e90 > _e66) {
            phi_431_ = _e98;
        } else {
            phi_431_ = _e90;
        }
        let _e105 = phi_431_;
        phi_433_ = texture_Axis(_e102, _e105, (_e80 - f32(_e90)));
    }
    let _e108 = phi_433_;
    return _e108;
}

fn _lt_shaders_texture_TextureView_quad(param_11: ptr<function, texture_TextureView>, param_12: f32, param_13: f32) -> texture_TexelQuad {
    let _e65 = (*param_11).size;
    let _e66 = (_e65 & 65535u);
    let _e68 = (*param_11).size;
    let _e72 = (*param_11).flags;
    let _e74 = ((_e72 & 4u) != 0u);
    let _e76 = (*param_11).flags;
    let _e80 = lt_shaders_texture_axis(param_12, _e66, ((_e76 >> bitcast<u32>(4u)) & 3u), _e74);
    let _e82 = (*param_11).flags;
    let _e86 = lt_shaders_texture_axis(param_13, (_e68 >> bitcast<u32>(16i)), ((_e82 >> bitcast<u32>(6u)) & 3u), _e74);
    let _e90 = (*param_11).offset;
    let _e97 = (*param_11).offset;
    let _e104 = (*param_11).offset;
    let _e111 = (*param_11).offset;
    return texture_TexelQuad(array<u32, 4>(((_e90 + (_e86.low * _e66)) + _e80.low), ((_e97 + (_e86.low * _e66)) + _e80.high), ((_e104 + (_e86.high * _e66)) + _e80.low), ((_e111 + (_e86.high * _e66)) + _e80.high)), vec4<f32>(((1f - _e80.fraction) * (1f - _e86.fraction)), (_e80.fraction * (1f - _e86.fraction)), ((1f - _e80.fraction) * _e86.fraction), (_e80.fraction * _e86.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_14: f32, param_15: f32) -> f32 {
    var phi_480_: bool;
    var phi_484_: f32;

    if (param_14 != param_14) {
        phi_480_ = true;
    } else {
        let _e64 = (param_15 >= param_14);
        if _e64 {
        }
        phi_480_ = _e64;
    }
    let _e66 = phi_480_;
    if _e66 {
        phi_484_ = param_15;
    } else {
        phi_484_ = param_14;
    }
    let _e68 = phi_484_;
    return _e68;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_16: f32, param_17: f32) -> f32 {
    var phi_496_: bool;
    var phi_500_: f32;

    if (param_16 != param_16) {
        phi_496_ = true;
    } else {
        let _e64 = (param_17 <= param_16);
        if _e64 {
        }
        phi_496_ = _e64;
    }
    let _e66 = phi_496_;
    if _e66 {
        phi_500_ = param_17;
    } else {
        phi_500_ = param_16;
    }
    let _e68 = phi_500_;
    return _e68;
}

fn lt_shaders_surface_barycentric_weights(param_18: f32, param_19: f32) -> vec3<f32> {
    return vec3<f32>(((1f - param_18) - param_19), param_18, param_19);
}

fn lt_shaders_evaluate_to_light(param_20: vec3<f32>, param_21: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_21.x - (param_20.x * param_21.w)), (param_21.y - (param_20.y * param_21.w)), (param_21.z - (param_20.z * param_21.w)));
}

fn lt_shaders_doubt_slot_of(param_22: vec3<u32>) -> u32 {
    return ((param_22.y * 2097152u) + param_22.x);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<abi_Vertex, 3>;
    var local_2: lt_bvh_traverse_Stack;
    var phi_619_: f32;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_695_: bool;
    var phi_699_: bool;
    var phi_773_: f32;
    var phi_780_: f32;
    var phi_788_: f32;
    var phi_795_: f32;
    var phi_803_: f32;
    var phi_810_: f32;
    var phi_827_: f32;
    var phi_832_: f32;
    var phi_837_: f32;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_877_: u32;
    var phi_878_: u32;
    var phi_895_: vec3<f32>;
    var phi_896_: vec3<f32>;
    var phi_909_: u32;
    var phi_914_: u32;
    var phi_919_: u32;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1065_: u32;
    var phi_1067_: u32;
    var phi_1148_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1175_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1202_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1208_: u32;
    var phi_1211_: u32;
    var phi_1225_: u32;
    var phi_1235_: u32;
    var phi_1245_: u32;
    var phi_1263_: u32;
    var phi_1273_: u32;
    var phi_1283_: u32;
    var phi_1319_: u32;
    var phi_1332_: u32;
    var phi_1337_: u32;
    var phi_1338_: u32;
    var phi_1339_: u32;
    var phi_1209_: u32;
    var phi_1212_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1397_: u32;
    var phi_1442_: vec3<f32>;
    var phi_1443_: vec3<f32>;
    var phi_1474_: vec3<f32>;
    var phi_1475_: vec3<f32>;
    var phi_1506_: vec3<f32>;
    var phi_1507_: vec3<f32>;
    var phi_1527_: bool;
    var phi_1528_: bool;
    var phi_1532_: f32;
    var phi_1533_: f32;
    var phi_1534_: f32;
    var phi_1535_: f32;
    var phi_1543_: f32;
    var phi_1553_: bool;
    var phi_1554_: bool;
    var phi_1558_: f32;
    var phi_1559_: f32;
    var phi_1560_: f32;
    var phi_1561_: f32;
    var phi_1569_: f32;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1584_: f32;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1595_: f32;
    var phi_1610_: f32;
    var phi_1611_: bool;
    var phi_1612_: f32;
    var phi_1613_: bool;
    var phi_1614_: f32;
    var phi_1615_: bool;
    var phi_1633_: f32;
    var phi_1634_: bool;
    var phi_1635_: bool;
    var phi_1636_: f32;
    var phi_1637_: bool;
    var phi_1638_: bool;
    var phi_1642_: bool;
    var phi_1643_: f32;
    var phi_1644_: bool;
    var phi_1670_: f32;
    var phi_1679_: f32;
    var phi_1688_: f32;
    var phi_1697_: f32;
    var phi_1704_: f32;
    var phi_1711_: f32;
    var phi_1724_: f32;
    var phi_1733_: f32;
    var phi_1742_: f32;
    var phi_1751_: f32;
    var phi_1758_: f32;
    var phi_1765_: f32;
    var phi_1782_: f32;
    var phi_1787_: f32;
    var phi_1792_: f32;
    var phi_1800_: f32;
    var phi_1805_: f32;
    var phi_1810_: f32;
    var phi_1822_: f32;
    var phi_1827_: f32;
    var phi_1832_: f32;
    var phi_1837_: f32;
    var phi_1842_: lt_bvh_triangle_Intersection;
    var phi_1843_: lt_bvh_triangle_Intersection;
    var phi_1844_: bool;
    var phi_1848_: lt_bvh_triangle_Intersection;
    var phi_2057_: f32;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2067_: bool;
    var phi_2068_: bool;
    var phi_2069_: bool;
    var phi_2070_: bool;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2075_: bool;
    var phi_2076_: bool;
    var phi_2080_: bool;
    var phi_2081_: bool;
    var phi_1398_: u32;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2084_: bool;
    var local_6: bool;
    var phi_2126_: bool;
    var phi_2127_: bool;
    var phi_2158_: u32;
    var phi_2159_: u32;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_1068_: u32;
    var phi_2162_: bool;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2165_: bool;
    var local_7: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2174_: bool;
    var phi_2178_: bool;
    var phi_2179_: bool;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2185_: bool;
    var phi_2189_: f32;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;

    let _e64 = id_1;
    let _e71 = arrayLength((&nodes.member));
    let _e74 = arrayLength((&triangles.member));
    let _e80 = arrayLength((&list.member));
    let _e83 = arrayLength((&vertices.member));
    let _e89 = arrayLength((&alpha_texels.member));
    let _e90 = lt_shaders_doubt_slot_of(_e64);
    if (3u < _e80) {
    } else {
        return;
    }
    let _e93 = list.member[3u];
    if (_e90 < _e93) {
        let _e95 = (_e90 + 4u);
        if (_e95 < _e80) {
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
            phi_619_ = 300000000000000000000000000000000000000f;
        } else {
            phi_619_ = 1f;
        }
        let _e130 = phi_619_;
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
                                    phi_669_ = bool();
                                    phi_670_ = true;
                                } else {
                                    let _e149 = (_e139 > 0f);
                                    if _e149 {
                                        phi_668_ = bool();
                                    } else {
                                        phi_668_ = (_e141 > 0f);
                                    }
                                    let _e152 = phi_668_;
                                    phi_669_ = _e152;
                                    phi_670_ = _e149;
                                }
                                let _e154 = phi_669_;
                                let _e156 = phi_670_;
                                if _e156 {
                                    phi_674_ = true;
                                } else {
                                    phi_674_ = _e154;
                                }
                                let _e158 = phi_674_;
                                phi_675_ = _e158;
                                phi_676_ = false;
                            } else {
                                phi_675_ = bool();
                                phi_676_ = true;
                            }
                            let _e160 = phi_675_;
                            let _e162 = phi_676_;
                            phi_677_ = _e160;
                            phi_678_ = false;
                            phi_679_ = _e162;
                        } else {
                            phi_677_ = bool();
                            phi_678_ = true;
                            phi_679_ = false;
                        }
                        let _e164 = phi_677_;
                        let _e166 = phi_678_;
                        let _e168 = phi_679_;
                        phi_680_ = _e164;
                        phi_681_ = _e166;
                        phi_682_ = _e168;
                    } else {
                        phi_680_ = bool();
                        phi_681_ = true;
                        phi_682_ = false;
                    }
                    let _e170 = phi_680_;
                    let _e172 = phi_681_;
                    let _e174 = phi_682_;
                    phi_683_ = _e170;
                    phi_684_ = _e172;
                    phi_685_ = _e174;
                } else {
                    phi_683_ = bool();
                    phi_684_ = true;
                    phi_685_ = false;
                }
                let _e176 = phi_683_;
                let _e178 = phi_684_;
                let _e180 = phi_685_;
                phi_686_ = _e176;
                phi_687_ = _e178;
                phi_688_ = _e180;
            } else {
                phi_686_ = bool();
                phi_687_ = true;
                phi_688_ = false;
            }
            let _e182 = phi_686_;
            let _e184 = phi_687_;
            let _e186 = phi_688_;
            phi_689_ = _e182;
            phi_690_ = _e184;
            phi_691_ = _e186;
        } else {
            phi_689_ = bool();
            phi_690_ = true;
            phi_691_ = false;
        }
        let _e188 = phi_689_;
        let _e190 = phi_690_;
        let _e192 = phi_691_;
        if _e190 {
            phi_695_ = true;
        } else {
            phi_695_ = _e192;
        }
        let _e194 = phi_695_;
        if _e194 {
            phi_699_ = false;
        } else {
            phi_699_ = _e188;
        }
        let _e196 = phi_699_;
        if _e196 {
            let _e197 = (0u >= _e71);
            if _e197 {
                phi_2179_ = bool();
            } else {
                if (0u < _e71) {
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
                    phi_773_ = _e266;
                } else {
                    phi_773_ = abs(_e132.direction.x);
                }
                let _e273 = phi_773_;
                if (_e132.direction.x < 0f) {
                    phi_780_ = (-1f / _e273);
                } else {
                    phi_780_ = (1f / _e273);
                }
                let _e278 = phi_780_;
                if (abs(_e132.direction.y) < _e266) {
                    phi_788_ = _e266;
                } else {
                    phi_788_ = abs(_e132.direction.y);
                }
                let _e285 = phi_788_;
                if (_e132.direction.y < 0f) {
                    phi_795_ = (-1f / _e285);
                } else {
                    phi_795_ = (1f / _e285);
                }
                let _e290 = phi_795_;
                if (abs(_e132.direction.z) < _e266) {
                    phi_803_ = _e266;
                } else {
                    phi_803_ = abs(_e132.direction.z);
                }
                let _e297 = phi_803_;
                if (_e132.direction.z < 0f) {
                    phi_810_ = (-1f / _e297);
                } else {
                    phi_810_ = (1f / _e297);
                }
                let _e302 = phi_810_;
                let _e306 = abs((bitcast<f32>(_e203) - _e120));
                let _e307 = abs((bitcast<f32>(_e207) - _e122));
                let _e308 = abs((bitcast<f32>(_e211) - _e124));
                let _e312 = abs(((bitcast<f32>(_e215) + (bitcast<f32>((((_e227 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e120));
                let _e313 = abs(((bitcast<f32>(_e219) + (bitcast<f32>((((_e227 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e122));
                let _e314 = abs(((bitcast<f32>(_e223) + (bitcast<f32>((((_e227 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e124));
                if (_e306 > _e312) {
                    phi_827_ = _e306;
                } else {
                    phi_827_ = _e312;
                }
                let _e317 = phi_827_;
                if (_e307 > _e313) {
                    phi_832_ = _e307;
                } else {
                    phi_832_ = _e313;
                }
                let _e320 = phi_832_;
                if (_e308 > _e314) {
                    phi_837_ = _e308;
                } else {
                    phi_837_ = _e314;
                }
                let _e323 = phi_837_;
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
                        phi_868_ = false;
                    } else {
                        phi_868_ = true;
                    }
                    let _e349 = phi_868_;
                    phi_869_ = _e349;
                } else {
                    phi_869_ = true;
                }
                let _e351 = phi_869_;
                if _e351 {
                    if (_e343 >= _e345) {
                        phi_877_ = 1u;
                    } else {
                        phi_877_ = 2u;
                    }
                    let _e354 = phi_877_;
                    phi_878_ = _e354;
                } else {
                    phi_878_ = 0u;
                }
                let _e356 = phi_878_;
                if (_e356 == 0u) {
                    phi_896_ = vec3<f32>(_e131.y, _e131.z, _e131.x);
                } else {
                    if (_e356 == 1u) {
                        phi_895_ = vec3<f32>(_e131.z, _e131.x, _e131.y);
                    } else {
                        phi_895_ = _e131;
                    }
                    let _e368 = phi_895_;
                    phi_896_ = _e368;
                }
                let _e370 = phi_896_;
                let _e373 = (_e370.x / _e370.z);
                let _e376 = (_e370.y / _e370.z);
                let _e378 = (1f / _e370.z);
                if (_e278 < 0f) {
                    phi_909_ = 0u;
                } else {
                    phi_909_ = 1u;
                }
                let _e381 = phi_909_;
                if (_e290 < 0f) {
                    phi_914_ = 0u;
                } else {
                    phi_914_ = 2u;
                }
                let _e384 = phi_914_;
                if (_e302 < 0f) {
                    phi_919_ = 0u;
                } else {
                    phi_919_ = 4u;
                }
                let _e387 = phi_919_;
                let _e389 = ((_e381 | _e384) | _e387);
                let _e390 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e390.first[0], _e390.first[1], _e390.first[2], _e390.first[3], _e390.first[4], _e390.first[5], _e390.first[6], _e390.first[7], _e390.first[8], _e390.first[9], _e390.first[10], _e390.first[11], _e390.first[12], _e390.first[13], _e390.first[14], _e390.first[15], _e390.first[16], _e390.first[17], _e390.first[18], _e390.first[19], _e390.first[20], _e390.first[21], _e390.first[22], _e390.first[23], _e390.first[24], _e390.first[25], _e390.first[26], _e390.first[27], _e390.first[28], _e390.first[29], _e390.first[30], _e390.first[31]), array<u32, 32>(_e390.mask[0], _e390.mask[1], _e390.mask[2], _e390.mask[3], _e390.mask[4], _e390.mask[5], _e390.mask[6], _e390.mask[7], _e390.mask[8], _e390.mask[9], _e390.mask[10], _e390.mask[11], _e390.mask[12], _e390.mask[13], _e390.mask[14], _e390.mask[15], _e390.mask[16], _e390.mask[17], _e390.mask[18], _e390.mask[19], _e390.mask[20], _e390.mask[21], _e390.mask[22], _e390.mask[23], _e390.mask[24], _e390.mask[25], _e390.mask[26], _e390.mask[27], _e390.mask[28], _e390.mask[29], _e390.mask[30], _e390.mask[31]), _e390.len, _e390.group, _e390.group_mask);
                let _e464 = local_2.group_mask;
                if ((_e464 & 4278190080u) == 0u) {
                    let _e468 = local_2.len;
                    if (_e468 == 0u) {
                        phi_1033_ = false;
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
                        phi_1033_ = true;
                    }
                    let _e491 = phi_1033_;
                    phi_1034_ = _e491;
                } else {
                    phi_1034_ = true;
                }
                let _e493 = phi_1034_;
                if _e493 {
                    let _e495 = local_2.group_mask;
                    let _e501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e495)), 32u, (_e495 == 0u)));
                    let _e505 = local_2.group_mask;
                    let _e519 = local_2.group_mask;
                    local_2.group_mask = (_e519 & ~((1u << bitcast<u32>((_e501 & 31u)))));
                    let _e522 = local_2.group;
                    phi_1065_ = (_e522 + countOneBits(((_e505 & ~((4294967295u << bitcast<u32>((((_e501 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1065_ = 4294967295u;
                }
                let _e525 = phi_1065_;
                phi_1067_ = _e525;
                loop {
                    let _e527 = phi_1067_;
                    if (_e527 != 4294967295u) {
                        if (_e527 < _e71) {
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
                            phi_1148_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e587.y));
                        } else {
                            let _e626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e626.unnamed.root, _e587.y), _e626.unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e632.unnamed, lt_bvh_traverse_Tree(_e587.z, _e632.unnamed_1.first_primitive));
                            phi_1148_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e638.unnamed_1.root, _e587.w));
                        }
                        let _e646 = phi_1148_;
                        let _e656 = nodes.member[(0u + _e527)].y;
                        if (_e290 < 0f) {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e656.w), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e656.x, _e673.unnamed_1.first_primitive));
                            phi_1175_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e656.y));
                        } else {
                            let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e695.unnamed.root, _e656.y), _e695.unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e701.unnamed, lt_bvh_traverse_Tree(_e656.z, _e701.unnamed_1.first_primitive));
                            phi_1175_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e707.unnamed_1.root, _e656.w));
                        }
                        let _e715 = phi_1175_;
                        let _e725 = nodes.member[(0u + _e527)].z;
                        if (_e302 < 0f) {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e725.w), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e725.x, _e742.unnamed_1.first_primitive));
                            phi_1202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e725.y));
                        } else {
                            let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e764.unnamed.root, _e725.y), _e764.unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e770.unnamed, lt_bvh_traverse_Tree(_e725.z, _e770.unnamed_1.first_primitive));
                            phi_1202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_bvh_traverse_Tree(_e776.unnamed_1.root, _e725.w));
                        }
                        let _e784 = phi_1202_;
                        phi_1208_ = 0u;
                        phi_1211_ = 0u;
                        loop {
                            let _e794 = phi_1208_;
                            let _e796 = phi_1211_;
                            local_3 = _e796;
                            local_4 = _e796;
                            local_5 = _e796;
                            let _e797 = (_e794 < 8u);
                            if _e797 {
                                let _e799 = (_e794 >> bitcast<u32>(2i));
                                let _e800 = (_e794 & 3u);
                                if (_e799 == 0u) {
                                    phi_1225_ = _e646.unnamed.root;
                                } else {
                                    phi_1225_ = _e646.unnamed.first_primitive;
                                }
                                let _e803 = phi_1225_;
                                if (_e799 == 0u) {
                                    phi_1235_ = _e715.unnamed.root;
                                } else {
                                    phi_1235_ = _e715.unnamed.first_primitive;
                                }
                                let _e812 = phi_1235_;
                                if (_e799 == 0u) {
                                    phi_1245_ = _e784.unnamed.root;
                                } else {
                                    phi_1245_ = _e784.unnamed.first_primitive;
                                }
                                let _e821 = phi_1245_;
                                let _e834 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e803 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e330)), ((f32(((_e812 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e560) + (_e578 - _e331)));
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(_e834, ((f32(((_e821 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e561) + (_e579 - _e332)));
                                if (_e799 == 0u) {
                                    phi_1263_ = _e646.unnamed_1.root;
                                } else {
                                    phi_1263_ = _e646.unnamed_1.first_primitive;
                                }
                                let _e838 = phi_1263_;
                                if (_e799 == 0u) {
                                    phi_1273_ = _e715.unnamed_1.root;
                                } else {
                                    phi_1273_ = _e715.unnamed_1.first_primitive;
                                }
                                let _e847 = phi_1273_;
                                if (_e799 == 0u) {
                                    phi_1283_ = _e784.unnamed_1.root;
                                } else {
                                    phi_1283_ = _e784.unnamed_1.first_primitive;
                                }
                                let _e856 = phi_1283_;
                                let _e869 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e838 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e330)), ((f32(((_e847 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e560) + (_e578 + _e331)));
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(_e869, ((f32(((_e856 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e561) + (_e579 + _e332)));
                                if (_e835 <= _e870) {
                                    if (_e835 <= _e130) {
                                        if (_e870 >= 0f) {
                                            if (_e799 == 0u) {
                                                let _e877 = nodes.member[(0u + _e527)].links[2u];
                                                phi_1319_ = _e877;
                                            } else {
                                                let _e880 = nodes.member[(0u + _e527)].links[3u];
                                                phi_1319_ = _e880;
                                            }
                                            let _e882 = phi_1319_;
                                            let _e887 = ((_e882 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u);
                                            let _e888 = (_e887 & 31u);
                                            if (_e888 >= 24u) {
                                                phi_1332_ = (24u + ((_e888 - 24u) ^ _e389));
                                            } else {
                                                phi_1332_ = _e888;
                                            }
                                            let _e894 = phi_1332_;
                                            phi_1337_ = (_e796 | ((_e887 >> bitcast<u32>(5i)) << bitcast<u32>((_e894 & 31u))));
                                        } else {
                                            phi_1337_ = _e796;
                                        }
                                        let _e902 = phi_1337_;
                                        phi_1338_ = _e902;
                                    } else {
                                        phi_1338_ = _e796;
                                    }
                                    let _e904 = phi_1338_;
                                    phi_1339_ = _e904;
                                } else {
                                    phi_1339_ = _e796;
                                }
                                let _e906 = phi_1339_;
                                phi_1209_ = (_e794 + 1u);
                                phi_1212_ = _e906;
                            } else {
                                phi_1209_ = u32();
                                phi_1212_ = u32();
                            }
                            let _e909 = phi_1209_;
                            let _e911 = phi_1212_;
                            continue;
                            continuing {
                                phi_1208_ = _e909;
                                phi_1211_ = _e911;
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
                        phi_1397_ = (_e960 & 16777215u);
                        loop {
                            let _e963 = phi_1397_;
                            let _e964 = (_e963 == 0u);
                            local_6 = _e964;
                            local_10 = _e964;
                            if _e964 {
                                phi_1398_ = u32();
                                phi_2082_ = false;
                                phi_2083_ = false;
                                phi_2084_ = false;
                            } else {
                                let _e967 = nodes.member[(0u + _e527)].links[1u];
                                let _e972 = ((0u + _e967) + select(firstTrailingBit(_e963), 32u, (_e963 == 0u)));
                                if (_e972 < _e74) {
                                } else {
                                    return;
                                }
                                let _e979 = triangles.member[(0u + _e972)].v0_;
                                let _e981 = (_e979.x - _e120);
                                let _e983 = (_e979.y - _e122);
                                let _e985 = (_e979.z - _e124);
                                if (_e356 == 0u) {
                                    phi_1443_ = vec3<f32>(_e983, _e985, _e981);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1442_ = vec3<f32>(_e985, _e981, _e983);
                                    } else {
                                        phi_1442_ = (_e979 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e993 = phi_1442_;
                                    phi_1443_ = _e993;
                                }
                                let _e995 = phi_1443_;
                                let _e999 = (_e995.x - (_e373 * _e995.z));
                                let _e1003 = (_e995.y - (_e376 * _e995.z));
                                let _e1007 = triangles.member[(0u + _e972)].v1_;
                                let _e1009 = (_e1007.x - _e120);
                                let _e1011 = (_e1007.y - _e122);
                                let _e1013 = (_e1007.z - _e124);
                                if (_e356 == 0u) {
                                    phi_1475_ = vec3<f32>(_e1011, _e1013, _e1009);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1474_ = vec3<f32>(_e1013, _e1009, _e1011);
                                    } else {
                                        phi_1474_ = (_e1007 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1021 = phi_1474_;
                                    phi_1475_ = _e1021;
                                }
                                let _e1023 = phi_1475_;
                                let _e1027 = (_e1023.x - (_e373 * _e1023.z));
                                let _e1031 = (_e1023.y - (_e376 * _e1023.z));
                                let _e1035 = triangles.member[(0u + _e972)].v2_;
                                let _e1037 = (_e1035.x - _e120);
                                let _e1039 = (_e1035.y - _e122);
                                let _e1041 = (_e1035.z - _e124);
                                if (_e356 == 0u) {
                                    phi_1507_ = vec3<f32>(_e1039, _e1041, _e1037);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1506_ = vec3<f32>(_e1041, _e1037, _e1039);
                                    } else {
                                        phi_1506_ = (_e1035 - vec3<f32>(_e120, _e122, _e124));
                                    }
                                    let _e1049 = phi_1506_;
                                    phi_1507_ = _e1049;
                                }
                                let _e1051 = phi_1507_;
                                let _e1055 = (_e1051.x - (_e373 * _e1051.z));
                                let _e1059 = (_e1051.y - (_e376 * _e1051.z));
                                if (_e1027 < _e1055) {
                                    phi_1528_ = true;
                                } else {
                                    if (_e1027 == _e1055) {
                                        phi_1527_ = (_e1031 < _e1059);
                                    } else {
                                        phi_1527_ = false;
                                    }
                                    let _e1066 = phi_1527_;
                                    phi_1528_ = _e1066;
                                }
                                let _e1068 = phi_1528_;
                                if _e1068 {
                                    phi_1532_ = _e1059;
                                    phi_1533_ = _e1055;
                                    phi_1534_ = _e1031;
                                    phi_1535_ = _e1027;
                                } else {
                                    phi_1532_ = _e1031;
                                    phi_1533_ = _e1027;
                                    phi_1534_ = _e1059;
                                    phi_1535_ = _e1055;
                                }
                                let _e1070 = phi_1532_;
                                let _e1072 = phi_1533_;
                                let _e1074 = phi_1534_;
                                let _e1076 = phi_1535_;
                                let _e1079 = ((_e1076 * _e1070) - (_e1074 * _e1072));
                                if _e1068 {
                                    phi_1543_ = -(_e1079);
                                } else {
                                    phi_1543_ = _e1079;
                                }
                                let _e1082 = phi_1543_;
                                if (_e1055 < _e999) {
                                    phi_1554_ = true;
                                } else {
                                    if (_e1055 == _e999) {
                                        phi_1553_ = (_e1059 < _e1003);
                                    } else {
                                        phi_1553_ = false;
                                    }
                                    let _e1087 = phi_1553_;
                                    phi_1554_ = _e1087;
                                }
                                let _e1089 = phi_1554_;
                                if _e1089 {
                                    phi_1558_ = _e1003;
                                    phi_1559_ = _e999;
                                    phi_1560_ = _e1059;
                                    phi_1561_ = _e1055;
                                } else {
                                    phi_1558_ = _e1059;
                                    phi_1559_ = _e1055;
                                    phi_1560_ = _e1003;
                                    phi_1561_ = _e999;
                                }
                                let _e1091 = phi_1558_;
                                let _e1093 = phi_1559_;
                                let _e1095 = phi_1560_;
                                let _e1097 = phi_1561_;
                                let _e1100 = ((_e1097 * _e1091) - (_e1095 * _e1093));
                                if _e1089 {
                                    phi_1569_ = -(_e1100);
                                } else {
                                    phi_1569_ = _e1100;
                                }
                                let _e1103 = phi_1569_;
                                if (_e999 < _e1027) {
                                    phi_1580_ = true;
                                } else {
                                    if (_e999 == _e1027) {
                                        phi_1579_ = (_e1003 < _e1031);
                                    } else {
                                        phi_1579_ = false;
                                    }
                                    let _e1108 = phi_1579_;
                                    phi_1580_ = _e1108;
                                }
                                let _e1110 = phi_1580_;
                                if _e1110 {
                                    phi_1584_ = _e1031;
                                    phi_1585_ = _e1027;
                                    phi_1586_ = _e1003;
                                    phi_1587_ = _e999;
                                } else {
                                    phi_1584_ = _e1003;
                                    phi_1585_ = _e999;
                                    phi_1586_ = _e1031;
                                    phi_1587_ = _e1027;
                                }
                                let _e1112 = phi_1584_;
                                let _e1114 = phi_1585_;
                                let _e1116 = phi_1586_;
                                let _e1118 = phi_1587_;
                                let _e1121 = ((_e1118 * _e1112) - (_e1116 * _e1114));
                                if _e1110 {
                                    phi_1595_ = -(_e1121);
                                } else {
                                    phi_1595_ = _e1121;
                                }
                                let _e1124 = phi_1595_;
                                if (_e1082 >= 0f) {
                                    if (_e1103 >= 0f) {
                                        if (_e1124 >= 0f) {
                                            phi_1610_ = ((_e1082 + _e1103) + _e1124);
                                            phi_1611_ = false;
                                        } else {
                                            phi_1610_ = f32();
                                            phi_1611_ = true;
                                        }
                                        let _e1131 = phi_1610_;
                                        let _e1133 = phi_1611_;
                                        phi_1612_ = _e1131;
                                        phi_1613_ = _e1133;
                                    } else {
                                        phi_1612_ = f32();
                                        phi_1613_ = true;
                                    }
                                    let _e1135 = phi_1612_;
                                    let _e1137 = phi_1613_;
                                    phi_1614_ = _e1135;
                                    phi_1615_ = _e1137;
                                } else {
                                    phi_1614_ = f32();
                                    phi_1615_ = true;
                                }
                                let _e1139 = phi_1614_;
                                let _e1141 = phi_1615_;
                                if _e1141 {
                                    if (_e1082 <= 0f) {
                                        if (_e1103 <= 0f) {
                                            let _e1144 = (_e1124 <= 0f);
                                            if _e1144 {
                                            }
                                            phi_1633_ = ((_e1082 + _e1103) + _e1124);
                                            phi_1634_ = false;
                                            phi_1635_ = _e1144;
                                        } else {
                                            phi_1633_ = f32();
                                            phi_1634_ = true;
                                            phi_1635_ = false;
                                        }
                                        let _e1148 = phi_1633_;
                                        let _e1150 = phi_1634_;
                                        let _e1152 = phi_1635_;
                                        phi_1636_ = _e1148;
                                        phi_1637_ = _e1150;
                                        phi_1638_ = _e1152;
                                    } else {
                                        phi_1636_ = f32();
                                        phi_1637_ = true;
                                        phi_1638_ = false;
                                    }
                                    let _e1154 = phi_1636_;
                                    let _e1156 = phi_1637_;
                                    let _e1158 = phi_1638_;
                                    if _e1156 {
                                        phi_1642_ = false;
                                    } else {
                                        phi_1642_ = _e1158;
                                    }
                                    let _e1160 = phi_1642_;
                                    phi_1643_ = _e1154;
                                    phi_1644_ = _e1160;
                                } else {
                                    phi_1643_ = _e1139;
                                    phi_1644_ = true;
                                }
                                let _e1162 = phi_1643_;
                                let _e1164 = phi_1644_;
                                if _e1164 {
                                    let _e1165 = (_e1162 == 0f);
                                    if _e1165 {
                                        phi_1842_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1171 = ((((_e1082 * (_e378 * _e995.z)) + (_e1103 * (_e378 * _e1023.z))) + (_e1124 * (_e378 * _e1051.z))) / _e1162);
                                        let _e1173 = triangles.member[(0u + _e972)].v0_;
                                        let _e1175 = triangles.member[(0u + _e972)].v1_;
                                        if (_e1173.x < _e1175.x) {
                                            phi_1670_ = _e1173.x;
                                        } else {
                                            phi_1670_ = _e1175.x;
                                        }
                                        let _e1182 = phi_1670_;
                                        if (_e1173.y < _e1175.y) {
                                            phi_1679_ = _e1173.y;
                                        } else {
                                            phi_1679_ = _e1175.y;
                                        }
                                        let _e1189 = phi_1679_;
                                        if (_e1173.z < _e1175.z) {
                                            phi_1688_ = _e1173.z;
                                        } else {
                                            phi_1688_ = _e1175.z;
                                        }
                                        let _e1196 = phi_1688_;
                                        let _e1198 = triangles.member[(0u + _e972)].v2_;
                                        if (_e1182 < _e1198.x) {
                                            phi_1697_ = _e1182;
                                        } else {
                                            phi_1697_ = _e1198.x;
                                        }
                                        let _e1203 = phi_1697_;
                                        if (_e1189 < _e1198.y) {
                                            phi_1704_ = _e1189;
                                        } else {
                                            phi_1704_ = _e1198.y;
                                        }
                                        let _e1208 = phi_1704_;
                                        if (_e1196 < _e1198.z) {
                                            phi_1711_ = _e1196;
                                        } else {
                                            phi_1711_ = _e1198.z;
                                        }
                                        let _e1213 = phi_1711_;
                                        let _e1215 = triangles.member[(0u + _e972)].v0_;
                                        let _e1217 = triangles.member[(0u + _e972)].v1_;
                                        if (_e1215.x > _e1217.x) {
                                            phi_1724_ = _e1215.x;
                                        } else {
                                            phi_1724_ = _e1217.x;
                                        }
                                        let _e1224 = phi_1724_;
                                        if (_e1215.y > _e1217.y) {
                                            phi_1733_ = _e1215.y;
                                        } else {
                                            phi_1733_ = _e1217.y;
                                        }
                                        let _e1231 = phi_1733_;
                                        if (_e1215.z > _e1217.z) {
                                            phi_1742_ = _e1215.z;
                                        } else {
                                            phi_1742_ = _e1217.z;
                                        }
                                        let _e1238 = phi_1742_;
                                        let _e1240 = triangles.member[(0u + _e972)].v2_;
                                        if (_e1224 > _e1240.x) {
                                            phi_1751_ = _e1224;
                                        } else {
                                            phi_1751_ = _e1240.x;
                                        }
                                        let _e1245 = phi_1751_;
                                        if (_e1231 > _e1240.y) {
                                            phi_1758_ = _e1231;
                                        } else {
                                            phi_1758_ = _e1240.y;
                                        }
                                        let _e1250 = phi_1758_;
                                        if (_e1238 > _e1240.z) {
                                            phi_1765_ = _e1238;
                                        } else {
                                            phi_1765_ = _e1240.z;
                                        }
                                        let _e1255 = phi_1765_;
                                        let _e1259 = ((_e1203 - _e120) * _e278);
                                        let _e1260 = ((_e1208 - _e122) * _e290);
                                        let _e1261 = ((_e1213 - _e124) * _e302);
                                        let _e1265 = ((_e1245 - _e120) * _e278);
                                        let _e1266 = ((_e1250 - _e122) * _e290);
                                        let _e1267 = ((_e1255 - _e124) * _e302);
                                        if (_e1259 < _e1265) {
                                            phi_1782_ = _e1259;
                                        } else {
                                            phi_1782_ = _e1265;
                                        }
                                        let _e1270 = phi_1782_;
                                        if (_e1260 < _e1266) {
                                            phi_1787_ = _e1260;
                                        } else {
                                            phi_1787_ = _e1266;
                                        }
                                        let _e1273 = phi_1787_;
                                        if (_e1261 < _e1267) {
                                            phi_1792_ = _e1261;
                                        } else {
                                            phi_1792_ = _e1267;
                                        }
                                        let _e1276 = phi_1792_;
                                        if (_e1259 > _e1265) {
                                            phi_1800_ = _e1259;
                                        } else {
                                            phi_1800_ = _e1265;
                                        }
                                        let _e1282 = phi_1800_;
                                        if (_e1260 > _e1266) {
                                            phi_1805_ = _e1260;
                                        } else {
                                            phi_1805_ = _e1266;
                                        }
                                        let _e1285 = phi_1805_;
                                        if (_e1261 > _e1267) {
                                            phi_1810_ = _e1261;
                                        } else {
                                            phi_1810_ = _e1267;
                                        }
                                        let _e1288 = phi_1810_;
                                        let _e1292 = core_intrinsics_maximum_number_nsz_f32_((_e1270 - _e337), (_e1273 - _e338));
                                        let _e1293 = core_intrinsics_maximum_number_nsz_f32_(_e1292, (_e1276 - _e339));
                                        let _e1294 = core_intrinsics_minimum_number_nsz_f32_((_e1282 + _e337), (_e1285 + _e338));
                                        let _e1295 = core_intrinsics_minimum_number_nsz_f32_(_e1294, (_e1288 + _e339));
                                        if (_e1293 > -300000000000000000000000000000000000000f) {
                                            phi_1822_ = _e1293;
                                        } else {
                                            phi_1822_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1298 = phi_1822_;
                                        if (_e1295 < 300000000000000000000000000000000000000f) {
                                            phi_1827_ = _e1295;
                                        } else {
                                            phi_1827_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1301 = phi_1827_;
                                        if (_e1171 < _e1298) {
                                            phi_1832_ = _e1298;
                                        } else {
                                            phi_1832_ = _e1171;
                                        }
                                        let _e1304 = phi_1832_;
                                        if (_e1304 > _e1301) {
                                            phi_1837_ = _e1301;
                                        } else {
                                            phi_1837_ = _e1304;
                                        }
                                        let _e1307 = phi_1837_;
                                        phi_1842_ = lt_bvh_triangle_Intersection(_e1307, (_e1103 / _e1162), (_e1124 / _e1162), (_e1298 <= _e1301));
                                    }
                                    let _e1313 = phi_1842_;
                                    phi_1843_ = _e1313;
                                    phi_1844_ = _e1165;
                                } else {
                                    phi_1843_ = lt_bvh_triangle_Intersection();
                                    phi_1844_ = true;
                                }
                                let _e1315 = phi_1843_;
                                let _e1317 = phi_1844_;
                                if _e1317 {
                                    phi_1848_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1848_ = _e1315;
                                }
                                let _e1319 = phi_1848_;
                                if _e1319.is_hit {
                                    if (_e1319.t > 0f) {
                                        if (_e1319.t < _e130) {
                                            let _e1326 = triangles.member[(0u + _e972)].i0_;
                                            let _e1328 = ((_e1326 & 2147483648u) == 0u);
                                            if _e1328 {
                                                phi_2066_ = false;
                                                phi_2067_ = false;
                                            } else {
                                                if (_e972 < _e74) {
                                                } else {
                                                    return;
                                                }
                                                let _e1335 = triangles.member[(0u + _e972)].i0_;
                                                let _e1336 = (_e1335 & 2147483647u);
                                                let _e1338 = triangles.member[(0u + _e972)].i1_;
                                                let _e1340 = triangles.member[(0u + _e972)].i2_;
                                                if (_e1336 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1344 = vertices.member[(0u + _e1336)];
                                                if (_e1338 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1348 = vertices.member[(0u + _e1338)];
                                                if (_e1340 < _e83) {
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
                                                        phi_2060_ = true;
                                                    } else {
                                                        let _e1391 = lt_shaders_surface_vertex_color((&local_1), _e1386);
                                                        let _e1393 = (_e1382.base_color.w * _e1391.w);
                                                        if (_e1382.alpha_size == 0u) {
                                                            phi_2057_ = _e1393;
                                                        } else {
                                                            local.offset = _e1382.alpha_offset;
                                                            local.size = _e1382.alpha_size;
                                                            local.flags = _e1382.flags;
                                                            let _e1402 = lt_shaders_surface_texture_coordinate((&local_1), _e1386);
                                                            let _e1405 = _lt_shaders_texture_TextureView_quad((&local), _e1402.x, _e1402.y);
                                                            let _e1409 = (_e1405.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1409 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1413 = alpha_texels.member[(0u + _e1409)];
                                                            let _e1429 = (_e1405.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1429 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1433 = alpha_texels.member[(0u + _e1429)];
                                                            let _e1450 = (_e1405.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1450 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1454 = alpha_texels.member[(0u + _e1450)];
                                                            let _e1471 = (_e1405.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1471 < _e89) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1475 = alpha_texels.member[(0u + _e1471)];
                                                            phi_2057_ = (_e1393 * (((((f32(((_e1413 >> bitcast<u32>((((_e1405.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.x) + ((f32(((_e1433 >> bitcast<u32>((((_e1405.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.y)) + ((f32(((_e1454 >> bitcast<u32>((((_e1405.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.z)) + ((f32(((_e1475 >> bitcast<u32>((((_e1405.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1405.weights.w)));
                                                        }
                                                        let _e1491 = phi_2057_;
                                                        phi_2060_ = (_e1491 >= _e1382.cutoff);
                                                    }
                                                    let _e1495 = phi_2060_;
                                                    phi_2061_ = _e1495;
                                                } else {
                                                    phi_2061_ = false;
                                                }
                                                let _e1497 = phi_2061_;
                                                if _e1497 {
                                                    phi_2065_ = false;
                                                } else {
                                                    phi_2065_ = true;
                                                }
                                                let _e1499 = phi_2065_;
                                                phi_2066_ = _e1499;
                                                phi_2067_ = _e1497;
                                            }
                                            let _e1501 = phi_2066_;
                                            let _e1503 = phi_2067_;
                                            phi_2068_ = _e1501;
                                            phi_2069_ = _e1328;
                                            phi_2070_ = _e1503;
                                        } else {
                                            phi_2068_ = true;
                                            phi_2069_ = false;
                                            phi_2070_ = false;
                                        }
                                        let _e1505 = phi_2068_;
                                        let _e1507 = phi_2069_;
                                        let _e1509 = phi_2070_;
                                        phi_2071_ = _e1505;
                                        phi_2072_ = _e1507;
                                        phi_2073_ = _e1509;
                                    } else {
                                        phi_2071_ = true;
                                        phi_2072_ = false;
                                        phi_2073_ = false;
                                    }
                                    let _e1511 = phi_2071_;
                                    let _e1513 = phi_2072_;
                                    let _e1515 = phi_2073_;
                                    phi_2074_ = _e1511;
                                    phi_2075_ = _e1513;
                                    phi_2076_ = _e1515;
                                } else {
                                    phi_2074_ = true;
                                    phi_2075_ = false;
                                    phi_2076_ = false;
                                }
                                let _e1517 = phi_2074_;
                                let _e1519 = phi_2075_;
                                let _e1521 = phi_2076_;
                                if _e1517 {
                                    phi_2080_ = false;
                                    phi_2081_ = false;
                                } else {
                                    phi_2080_ = _e1519;
                                    phi_2081_ = _e1521;
                                }
                                let _e1523 = phi_2080_;
                                let _e1525 = phi_2081_;
                                phi_1398_ = (_e963 & (_e963 - 1u));
                                phi_2082_ = _e1517;
                                phi_2083_ = _e1523;
                                phi_2084_ = _e1525;
                            }
                            let _e1527 = phi_1398_;
                            let _e1529 = phi_2082_;
                            let _e1531 = phi_2083_;
                            let _e1533 = phi_2084_;
                            local_8 = _e1531;
                            local_9 = _e1533;
                            continue;
                            continuing {
                                phi_1397_ = _e1527;
                                break if !(_e1529);
                            }
                        }
                        let _e1536 = local_6;
                        if _e1536 {
                            let _e1538 = local_2.group_mask;
                            if ((_e1538 & 4278190080u) == 0u) {
                                let _e1542 = local_2.len;
                                if (_e1542 == 0u) {
                                    phi_2126_ = false;
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
                                    phi_2126_ = true;
                                }
                                let _e1565 = phi_2126_;
                                phi_2127_ = _e1565;
                            } else {
                                phi_2127_ = true;
                            }
                            let _e1567 = phi_2127_;
                            if _e1567 {
                                let _e1569 = local_2.group_mask;
                                let _e1575 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1569)), 32u, (_e1569 == 0u)));
                                let _e1579 = local_2.group_mask;
                                let _e1593 = local_2.group_mask;
                                local_2.group_mask = (_e1593 & ~((1u << bitcast<u32>((_e1575 & 31u)))));
                                let _e1596 = local_2.group;
                                phi_2158_ = (_e1596 + countOneBits(((_e1579 & ~((4294967295u << bitcast<u32>((((_e1575 - 24u) ^ _e389) & 31u))))) & 255u)));
                            } else {
                                phi_2158_ = 4294967295u;
                            }
                            let _e1599 = phi_2158_;
                            phi_2159_ = _e1599;
                            phi_2160_ = false;
                            phi_2161_ = false;
                        } else {
                            phi_2159_ = u32();
                            let _e1804 = local_8;
                            phi_2160_ = _e1804;
                            let _e1807 = local_9;
                            phi_2161_ = _e1807;
                        }
                        let _e1601 = phi_2159_;
                        let _e1603 = phi_2160_;
                        let _e1605 = phi_2161_;
                        phi_1068_ = _e1601;
                        let _e1811 = local_10;
                        phi_2162_ = _e1811;
                        phi_2163_ = false;
                        phi_2164_ = _e1603;
                        phi_2165_ = _e1605;
                    } else {
                        phi_1068_ = u32();
                        phi_2162_ = false;
                        phi_2163_ = true;
                        phi_2164_ = false;
                        phi_2165_ = false;
                    }
                    let _e1607 = phi_1068_;
                    let _e1609 = phi_2162_;
                    let _e1611 = phi_2163_;
                    let _e1613 = phi_2164_;
                    let _e1615 = phi_2165_;
                    local_7 = _e1611;
                    local_11 = _e1613;
                    local_12 = _e1615;
                    continue;
                    continuing {
                        phi_1067_ = _e1607;
                        break if !(_e1609);
                    }
                }
                let _e1618 = local_7;
                if _e1618 {
                    phi_2169_ = false;
                    phi_2170_ = false;
                } else {
                    let _e1818 = local_11;
                    phi_2169_ = _e1818;
                    let _e1821 = local_12;
                    phi_2170_ = _e1821;
                }
                let _e1620 = phi_2169_;
                let _e1622 = phi_2170_;
                if _e1620 {
                    phi_2174_ = true;
                } else {
                    phi_2174_ = _e1622;
                }
                let _e1624 = phi_2174_;
                if _e1624 {
                    phi_2178_ = true;
                } else {
                    phi_2178_ = false;
                }
                let _e1626 = phi_2178_;
                phi_2179_ = _e1626;
            }
            let _e1628 = phi_2179_;
            phi_2180_ = _e1628;
            phi_2181_ = _e197;
        } else {
            phi_2180_ = bool();
            phi_2181_ = true;
        }
        let _e1630 = phi_2180_;
        let _e1632 = phi_2181_;
        if _e1632 {
            phi_2185_ = false;
        } else {
            phi_2185_ = _e1630;
        }
        let _e1634 = phi_2185_;
        if _e1634 {
            phi_2189_ = 0f;
        } else {
            phi_2189_ = 1f;
        }
        let _e1636 = phi_2189_;
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
