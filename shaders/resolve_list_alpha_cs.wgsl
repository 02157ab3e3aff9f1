struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
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

struct type_30 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_34 {
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

struct type_38 {
    member: array<abi_Material>,
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

struct type_51 {
    member: array<lt_bvh_Node>,
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_57 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_57;
@group(0) @binding(2) 
var<storage> nodes: type_51;
@group(0) @binding(3) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage> vertices: type_34;
@group(0) @binding(7) 
var<storage> materials: type_38;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_223_: f32;
    var phi_228_: f32;
    var phi_229_: bool;
    var phi_230_: f32;
    var phi_231_: bool;
    var phi_235_: f32;
    var phi_261_: f32;
    var phi_266_: f32;
    var phi_267_: bool;
    var phi_268_: f32;
    var phi_269_: bool;
    var phi_273_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_311_: u32;
    var phi_325_: u32;
    var phi_332_: u32;
    var phi_337_: u32;
    var phi_343_: u32;
    var phi_348_: u32;
    var phi_350_: texture_Axis;
    var phi_378_: f32;
    var phi_383_: f32;
    var phi_384_: bool;
    var phi_385_: f32;
    var phi_386_: bool;
    var phi_390_: f32;
    var phi_416_: f32;
    var phi_421_: f32;
    var phi_422_: bool;
    var phi_423_: f32;
    var phi_424_: bool;
    var phi_428_: f32;
    var phi_436_: f32;
    var phi_437_: f32;
    var phi_438_: f32;
    var phi_447_: f32;
    var phi_448_: f32;
    var phi_466_: u32;
    var phi_480_: u32;
    var phi_487_: u32;
    var phi_492_: u32;
    var phi_498_: u32;
    var phi_503_: u32;
    var phi_505_: texture_Axis;

    let _e70 = (*param).size;
    let _e71 = (_e70 & 65535u);
    let _e73 = (*param).size;
    let _e75 = (_e73 >> bitcast<u32>(16i));
    let _e77 = (*param).flags;
    let _e79 = ((_e77 & 4u) != 0u);
    let _e81 = (*param).flags;
    let _e84 = ((_e81 >> bitcast<u32>(4u)) & 3u);
    if (_e84 == 0u) {
        if (param_1 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e97 > param_1) {
                phi_223_ = 1f;
            } else {
                phi_223_ = 0f;
            }
            let _e100 = phi_223_;
            if (param_1 < 8388608f) {
                phi_228_ = (_e97 - _e100);
                phi_229_ = false;
            } else {
                phi_228_ = f32();
                phi_229_ = true;
            }
            let _e103 = phi_228_;
            let _e105 = phi_229_;
            phi_230_ = _e103;
            phi_231_ = _e105;
        } else {
            phi_230_ = f32();
            phi_231_ = true;
        }
        let _e107 = phi_230_;
        let _e109 = phi_231_;
        if _e109 {
            phi_235_ = param_1;
        } else {
            phi_235_ = _e107;
        }
        let _e111 = phi_235_;
        phi_283_ = (param_1 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_1 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_261_ = 1f;
                } else {
                    phi_261_ = 0f;
                }
                let _e129 = phi_261_;
                if (_e114 < 8388608f) {
                    phi_266_ = (_e126 - _e129);
                    phi_267_ = false;
                } else {
                    phi_266_ = f32();
                    phi_267_ = true;
                }
                let _e132 = phi_266_;
                let _e134 = phi_267_;
                phi_268_ = _e132;
                phi_269_ = _e134;
            } else {
                phi_268_ = f32();
                phi_269_ = true;
            }
            let _e136 = phi_268_;
            let _e138 = phi_269_;
            if _e138 {
                phi_273_ = _e114;
            } else {
                phi_273_ = _e136;
            }
            let _e140 = phi_273_;
            let _e142 = (param_1 - (2f * _e140));
            if (_e142 > 1f) {
                phi_281_ = (2f - _e142);
            } else {
                phi_281_ = _e142;
            }
            let _e146 = phi_281_;
            phi_282_ = _e146;
        } else {
            phi_282_ = param_1;
        }
        let _e148 = phi_282_;
        phi_283_ = _e148;
    }
    let _e150 = phi_283_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_292_ = _e150;
        } else {
            phi_292_ = 1f;
        }
        let _e154 = phi_292_;
        phi_293_ = _e154;
    } else {
        phi_293_ = 0f;
    }
    let _e156 = phi_293_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_311_ = _e157;
        } else {
            phi_311_ = _e166;
        }
        let _e169 = phi_311_;
        phi_350_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_325_ = _e71;
        } else {
            phi_325_ = _e178;
        }
        let _e181 = phi_325_;
        if (_e84 == 0u) {
            phi_332_ = _e157;
        } else {
            phi_332_ = 0u;
        }
        let _e186 = phi_332_;
        if (_e84 == 0u) {
            phi_337_ = 0u;
        } else {
            phi_337_ = _e157;
        }
        let _e189 = phi_337_;
        if (_e181 == 0u) {
            phi_343_ = _e186;
        } else {
            phi_343_ = (_e181 - 1u);
        }
        let _e193 = phi_343_;
        if (_e181 > _e157) {
            phi_348_ = _e189;
        } else {
            phi_348_ = _e181;
        }
        let _e196 = phi_348_;
        phi_350_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_350_;
    let _e201 = (*param).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_2 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e217 > param_2) {
                phi_378_ = 1f;
            } else {
                phi_378_ = 0f;
            }
            let _e220 = phi_378_;
            if (param_2 < 8388608f) {
                phi_383_ = (_e217 - _e220);
                phi_384_ = false;
            } else {
                phi_383_ = f32();
                phi_384_ = true;
            }
            let _e223 = phi_383_;
            let _e225 = phi_384_;
            phi_385_ = _e223;
            phi_386_ = _e225;
        } else {
            phi_385_ = f32();
            phi_386_ = true;
        }
        let _e227 = phi_385_;
        let _e229 = phi_386_;
        if _e229 {
            phi_390_ = param_2;
        } else {
            phi_390_ = _e227;
        }
        let _e231 = phi_390_;
        phi_438_ = (param_2 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_2 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_416_ = 1f;
                } else {
                    phi_416_ = 0f;
                }
                let _e249 = phi_416_;
                if (_e234 < 8388608f) {
                    phi_421_ = (_e246 - _e249);
                    phi_422_ = false;
                } else {
                    phi_421_ = f32();
                    phi_422_ = true;
                }
                let _e252 = phi_421_;
                let _e254 = phi_422_;
                phi_423_ = _e252;
                phi_424_ = _e254;
            } else {
                phi_423_ = f32();
                phi_424_ = true;
            }
            let _e256 = phi_423_;
            let _e258 = phi_424_;
            if _e258 {
                phi_428_ = _e234;
            } else {
                phi_428_ = _e256;
            }
            let _e260 = phi_428_;
            let _e262 = (param_2 - (2f * _e260));
            if (_e262 > 1f) {
                phi_436_ = (2f - _e262);
            } else {
                phi_436_ = _e262;
            }
            let _e266 = phi_436_;
            phi_437_ = _e266;
        } else {
            phi_437_ = param_2;
        }
        let _e268 = phi_437_;
        phi_438_ = _e268;
    }
    let _e270 = phi_438_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_447_ = _e270;
        } else {
            phi_447_ = 1f;
        }
        let _e274 = phi_447_;
        phi_448_ = _e274;
    } else {
        phi_448_ = 0f;
    }
    let _e276 = phi_448_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_466_ = _e277;
        } else {
            phi_466_ = _e286;
        }
        let _e289 = phi_466_;
        phi_505_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_480_ = _e75;
        } else {
            phi_480_ = _e298;
        }
        let _e301 = phi_480_;
        if (_e204 == 0u) {
            phi_487_ = _e277;
        } else {
            phi_487_ = 0u;
        }
        let _e306 = phi_487_;
        if (_e204 == 0u) {
            phi_492_ = 0u;
        } else {
            phi_492_ = _e277;
        }
        let _e309 = phi_492_;
        if (_e301 == 0u) {
            phi_498_ = _e306;
        } else {
            phi_498_ = (_e301 - 1u);
        }
        let _e313 = phi_498_;
        if (_e301 > _e277) {
            phi_503_ = _e309;
        } else {
            phi_503_ = _e301;
        }
        let _e316 = phi_503_;
        phi_505_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_505_;
    let _e323 = (*param).offset;
    let _e330 = (*param).offset;
    let _e337 = (*param).offset;
    let _e344 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_564_: bool;
    var phi_568_: f32;

    if (param_3 != param_3) {
        phi_564_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_564_ = _e69;
    }
    let _e71 = phi_564_;
    if _e71 {
        phi_568_ = param_4;
    } else {
        phi_568_ = param_3;
    }
    let _e73 = phi_568_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_580_: bool;
    var phi_584_: f32;

    if (param_5 != param_5) {
        phi_580_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_580_ = _e69;
    }
    let _e71 = phi_580_;
    if _e71 {
        phi_584_ = param_6;
    } else {
        phi_584_ = param_5;
    }
    let _e73 = phi_584_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_675_: f32;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_757_: bool;
    var phi_761_: bool;
    var phi_831_: f32;
    var phi_838_: f32;
    var phi_845_: f32;
    var phi_852_: f32;
    var phi_859_: f32;
    var phi_866_: f32;
    var phi_883_: f32;
    var phi_888_: f32;
    var phi_893_: f32;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_930_: u32;
    var phi_931_: u32;
    var phi_942_: vec3<f32>;
    var phi_943_: vec3<f32>;
    var phi_956_: u32;
    var phi_961_: u32;
    var phi_966_: u32;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1112_: u32;
    var phi_1114_: u32;
    var phi_1195_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1222_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1249_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1255_: u32;
    var phi_1258_: u32;
    var phi_1272_: u32;
    var phi_1282_: u32;
    var phi_1292_: u32;
    var phi_1310_: u32;
    var phi_1320_: u32;
    var phi_1330_: u32;
    var phi_1366_: u32;
    var phi_1379_: u32;
    var phi_1384_: u32;
    var phi_1385_: u32;
    var phi_1386_: u32;
    var phi_1256_: u32;
    var phi_1259_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1444_: u32;
    var phi_1489_: vec3<f32>;
    var phi_1490_: vec3<f32>;
    var phi_1519_: vec3<f32>;
    var phi_1520_: vec3<f32>;
    var phi_1549_: vec3<f32>;
    var phi_1550_: vec3<f32>;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1573_: f32;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1584_: f32;
    var phi_1594_: bool;
    var phi_1595_: bool;
    var phi_1599_: f32;
    var phi_1600_: f32;
    var phi_1601_: f32;
    var phi_1602_: f32;
    var phi_1610_: f32;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1625_: f32;
    var phi_1626_: f32;
    var phi_1627_: f32;
    var phi_1628_: f32;
    var phi_1636_: f32;
    var phi_1651_: f32;
    var phi_1652_: bool;
    var phi_1653_: f32;
    var phi_1654_: bool;
    var phi_1655_: f32;
    var phi_1656_: bool;
    var phi_1674_: f32;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1677_: f32;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1683_: bool;
    var phi_1684_: f32;
    var phi_1685_: bool;
    var phi_1713_: vec3<f32>;
    var phi_1714_: vec3<f32>;
    var phi_1739_: vec3<f32>;
    var phi_1740_: vec3<f32>;
    var phi_1765_: vec3<f32>;
    var phi_1766_: vec3<f32>;
    var phi_1822_: f32;
    var phi_1831_: f32;
    var phi_1840_: f32;
    var phi_1849_: f32;
    var phi_1856_: f32;
    var phi_1863_: f32;
    var phi_1876_: f32;
    var phi_1885_: f32;
    var phi_1894_: f32;
    var phi_1903_: f32;
    var phi_1910_: f32;
    var phi_1917_: f32;
    var phi_1934_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1952_: f32;
    var phi_1957_: f32;
    var phi_1962_: f32;
    var phi_1974_: f32;
    var phi_1979_: f32;
    var phi_1984_: f32;
    var phi_1989_: f32;
    var phi_1994_: lt_bvh_triangle_Intersection;
    var phi_1995_: bool;
    var phi_1996_: lt_bvh_triangle_Intersection;
    var phi_1997_: bool;
    var phi_2001_: lt_bvh_triangle_Intersection;
    var phi_2002_: bool;
    var phi_2003_: lt_bvh_triangle_Intersection;
    var phi_2004_: bool;
    var phi_2005_: bool;
    var phi_2009_: bool;
    var phi_2013_: lt_bvh_triangle_Intersection;
    var phi_2227_: f32;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_1445_: u32;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var local_5: bool;
    var phi_2296_: bool;
    var phi_2297_: bool;
    var phi_2328_: u32;
    var phi_2329_: u32;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_1115_: u32;
    var phi_2332_: bool;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2335_: bool;
    var local_6: bool;
    var phi_2339_: bool;
    var phi_2340_: bool;
    var phi_2344_: bool;
    var phi_2348_: bool;
    var phi_2349_: bool;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2355_: bool;
    var phi_2359_: f32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e68 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&list.member));
    let _e87 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e97 = ((_e68.y * 2097152u) + _e68.x);
    if (3u < _e84) {
    } else {
        return;
    }
    let _e100 = list.member[3u];
    if (_e97 < _e100) {
        let _e102 = (_e97 + 4u);
        if (_e102 < _e84) {
        } else {
            return;
        }
        let _e106 = list.member[(0u + _e102)];
        if (_e106 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e112 = samples.member[(0u + _e106)].position;
        let _e114 = samples.member[(0u + _e106)].normal;
        let _e116 = samples.member[(0u + _e106)].magnitude;
        let _e118 = ((8f / 8388608f) * _e116);
        let _e126 = (_e112.x + (_e114.x * _e118));
        let _e128 = (_e112.y + (_e114.y * _e118));
        let _e130 = (_e112.z + (_e114.z * _e118));
        let _e132 = p.member.light.place;
        if (_e132.w == 0f) {
            phi_675_ = 300000000000000000000000000000000000000f;
        } else {
            phi_675_ = 1f;
        }
        let _e136 = phi_675_;
        let _e144 = (_e132.x - (_e126 * _e132.w));
        let _e145 = (_e132.y - (_e128 * _e132.w));
        let _e146 = (_e132.z - (_e130 * _e132.w));
        let _e151 = abs(_e144);
        let _e152 = abs(_e145);
        let _e153 = abs(_e146);
        if (abs(_e126) < 1000000000000000f) {
            if (abs(_e128) < 1000000000000000f) {
                if (abs(_e130) < 1000000000000000f) {
                    if (_e151 < 1000000000000000f) {
                        if (_e152 < 1000000000000000f) {
                            if (_e153 < 1000000000000000f) {
                                if (_e151 > 0f) {
                                    phi_731_ = bool();
                                    phi_732_ = true;
                                } else {
                                    let _e161 = (_e152 > 0f);
                                    if _e161 {
                                        phi_730_ = bool();
                                    } else {
                                        phi_730_ = (_e153 > 0f);
                                    }
                                    let _e164 = phi_730_;
                                    phi_731_ = _e164;
                                    phi_732_ = _e161;
                                }
                                let _e166 = phi_731_;
                                let _e168 = phi_732_;
                                if _e168 {
                                    phi_736_ = true;
                                } else {
                                    phi_736_ = _e166;
                                }
                                let _e170 = phi_736_;
                                phi_737_ = _e170;
                                phi_738_ = false;
                            } else {
                                phi_737_ = bool();
                                phi_738_ = true;
                            }
                            let _e172 = phi_737_;
                            let _e174 = phi_738_;
                            phi_739_ = _e172;
                            phi_740_ = false;
                            phi_741_ = _e174;
                        } else {
                            phi_739_ = bool();
                            phi_740_ = true;
                            phi_741_ = false;
                        }
                        let _e176 = phi_739_;
                        let _e178 = phi_740_;
                        let _e180 = phi_741_;
                        phi_742_ = _e176;
                        phi_743_ = _e178;
                        phi_744_ = _e180;
                    } else {
                        phi_742_ = bool();
                        phi_743_ = true;
                        phi_744_ = false;
                    }
                    let _e182 = phi_742_;
                    let _e184 = phi_743_;
                    let _e186 = phi_744_;
                    phi_745_ = _e182;
                    phi_746_ = _e184;
                    phi_747_ = _e186;
                } else {
                    phi_745_ = bool();
                    phi_746_ = true;
                    phi_747_ = false;
                }
                let _e188 = phi_745_;
                let _e190 = phi_746_;
                let _e192 = phi_747_;
                phi_748_ = _e188;
                phi_749_ = _e190;
                phi_750_ = _e192;
            } else {
                phi_748_ = bool();
                phi_749_ = true;
                phi_750_ = false;
            }
            let _e194 = phi_748_;
            let _e196 = phi_749_;
            let _e198 = phi_750_;
            phi_751_ = _e194;
            phi_752_ = _e196;
            phi_753_ = _e198;
        } else {
            phi_751_ = bool();
            phi_752_ = true;
            phi_753_ = false;
        }
        let _e200 = phi_751_;
        let _e202 = phi_752_;
        let _e204 = phi_753_;
        if _e202 {
            phi_757_ = true;
        } else {
            phi_757_ = _e204;
        }
        let _e206 = phi_757_;
        if _e206 {
            phi_761_ = false;
        } else {
            phi_761_ = _e200;
        }
        let _e208 = phi_761_;
        if _e208 {
            let _e209 = (0u >= _e75);
            if _e209 {
                phi_2349_ = bool();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e215 = nodes.member[(0u + 0u)].frame[0u];
                let _e219 = nodes.member[(0u + 0u)].frame[1u];
                let _e223 = nodes.member[(0u + 0u)].frame[2u];
                let _e227 = nodes.member[(0u + 0u)].frame[0u];
                let _e231 = nodes.member[(0u + 0u)].frame[1u];
                let _e235 = nodes.member[(0u + 0u)].frame[2u];
                let _e239 = nodes.member[(0u + 0u)].frame[3u];
                let _e273 = core_intrinsics_maximum_number_nsz_f32_(abs(_e144), abs(_e145));
                let _e274 = core_intrinsics_maximum_number_nsz_f32_(_e273, abs(_e146));
                let _e275 = (_e274 * 0.0000000000009094947f);
                if (abs(_e144) < _e275) {
                    phi_831_ = _e275;
                } else {
                    phi_831_ = abs(_e144);
                }
                let _e280 = phi_831_;
                if (_e144 < 0f) {
                    phi_838_ = (-1f / _e280);
                } else {
                    phi_838_ = (1f / _e280);
                }
                let _e285 = phi_838_;
                if (abs(_e145) < _e275) {
                    phi_845_ = _e275;
                } else {
                    phi_845_ = abs(_e145);
                }
                let _e290 = phi_845_;
                if (_e145 < 0f) {
                    phi_852_ = (-1f / _e290);
                } else {
                    phi_852_ = (1f / _e290);
                }
                let _e295 = phi_852_;
                if (abs(_e146) < _e275) {
                    phi_859_ = _e275;
                } else {
                    phi_859_ = abs(_e146);
                }
                let _e300 = phi_859_;
                if (_e146 < 0f) {
                    phi_866_ = (-1f / _e300);
                } else {
                    phi_866_ = (1f / _e300);
                }
                let _e305 = phi_866_;
                let _e309 = abs((bitcast<f32>(_e215) - _e126));
                let _e310 = abs((bitcast<f32>(_e219) - _e128));
                let _e311 = abs((bitcast<f32>(_e223) - _e130));
                let _e315 = abs(((bitcast<f32>(_e227) + (bitcast<f32>((((_e239 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                let _e316 = abs(((bitcast<f32>(_e231) + (bitcast<f32>((((_e239 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                let _e317 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e239 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                if (_e309 > _e315) {
                    phi_883_ = _e309;
                } else {
                    phi_883_ = _e315;
                }
                let _e320 = phi_883_;
                if (_e310 > _e316) {
                    phi_888_ = _e310;
                } else {
                    phi_888_ = _e316;
                }
                let _e323 = phi_888_;
                if (_e311 > _e317) {
                    phi_893_ = _e311;
                } else {
                    phi_893_ = _e317;
                }
                let _e326 = phi_893_;
                let _e327 = core_intrinsics_maximum_number_nsz_f32_(_e320, _e323);
                let _e328 = core_intrinsics_maximum_number_nsz_f32_(_e327, _e326);
                let _e332 = (_e328 * 0.0000019073486f);
                let _e333 = (abs(_e285) * _e332);
                let _e334 = (abs(_e295) * _e332);
                let _e335 = (abs(_e305) * _e332);
                let _e339 = (_e328 * 0.0000009536743f);
                let _e340 = (abs(_e285) * _e339);
                let _e341 = (abs(_e295) * _e339);
                let _e342 = (abs(_e305) * _e339);
                let _e343 = abs(_e144);
                let _e344 = abs(_e145);
                let _e345 = abs(_e146);
                if (_e343 >= _e344) {
                    if (_e343 >= _e345) {
                        phi_921_ = false;
                    } else {
                        phi_921_ = true;
                    }
                    let _e349 = phi_921_;
                    phi_922_ = _e349;
                } else {
                    phi_922_ = true;
                }
                let _e351 = phi_922_;
                if _e351 {
                    if (_e344 >= _e345) {
                        phi_930_ = 1u;
                    } else {
                        phi_930_ = 2u;
                    }
                    let _e354 = phi_930_;
                    phi_931_ = _e354;
                } else {
                    phi_931_ = 0u;
                }
                let _e356 = phi_931_;
                if (_e356 == 0u) {
                    phi_943_ = vec3<f32>(_e145, _e146, _e144);
                } else {
                    if (_e356 == 1u) {
                        phi_942_ = vec3<f32>(_e146, _e144, _e145);
                    } else {
                        phi_942_ = vec3<f32>(_e144, _e145, _e146);
                    }
                    let _e362 = phi_942_;
                    phi_943_ = _e362;
                }
                let _e364 = phi_943_;
                let _e367 = (_e364.x / _e364.z);
                let _e370 = (_e364.y / _e364.z);
                if (_e285 < 0f) {
                    phi_956_ = 0u;
                } else {
                    phi_956_ = 1u;
                }
                let _e375 = phi_956_;
                if (_e295 < 0f) {
                    phi_961_ = 0u;
                } else {
                    phi_961_ = 2u;
                }
                let _e378 = phi_961_;
                if (_e305 < 0f) {
                    phi_966_ = 0u;
                } else {
                    phi_966_ = 4u;
                }
                let _e381 = phi_966_;
                let _e383 = ((_e375 | _e378) | _e381);
                let _e384 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e384.first[0], _e384.first[1], _e384.first[2], _e384.first[3], _e384.first[4], _e384.first[5], _e384.first[6], _e384.first[7], _e384.first[8], _e384.first[9], _e384.first[10], _e384.first[11], _e384.first[12], _e384.first[13], _e384.first[14], _e384.first[15], _e384.first[16], _e384.first[17], _e384.first[18], _e384.first[19], _e384.first[20], _e384.first[21], _e384.first[22], _e384.first[23], _e384.first[24], _e384.first[25], _e384.first[26], _e384.first[27], _e384.first[28], _e384.first[29], _e384.first[30], _e384.first[31]), array<u32, 32>(_e384.mask[0], _e384.mask[1], _e384.mask[2], _e384.mask[3], _e384.mask[4], _e384.mask[5], _e384.mask[6], _e384.mask[7], _e384.mask[8], _e384.mask[9], _e384.mask[10], _e384.mask[11], _e384.mask[12], _e384.mask[13], _e384.mask[14], _e384.mask[15], _e384.mask[16], _e384.mask[17], _e384.mask[18], _e384.mask[19], _e384.mask[20], _e384.mask[21], _e384.mask[22], _e384.mask[23], _e384.mask[24], _e384.mask[25], _e384.mask[26], _e384.mask[27], _e384.mask[28], _e384.mask[29], _e384.mask[30], _e384.mask[31]), _e384.len, _e384.group, _e384.group_mask);
                let _e458 = local_1.group_mask;
                if ((_e458 & 4278190080u) == 0u) {
                    let _e462 = local_1.len;
                    if (_e462 == 0u) {
                        phi_1080_ = false;
                    } else {
                        let _e466 = local_1.len;
                        local_1.len = (_e466 - 1u);
                        let _e469 = local_1.len;
                        if (_e469 < 32u) {
                        } else {
                            return;
                        }
                        let _e474 = local_1.first[(0u + _e469)];
                        local_1.group = _e474;
                        let _e477 = local_1.len;
                        if (_e477 < 32u) {
                        } else {
                            return;
                        }
                        let _e482 = local_1.mask[(0u + _e477)];
                        local_1.group_mask = _e482;
                        phi_1080_ = true;
                    }
                    let _e485 = phi_1080_;
                    phi_1081_ = _e485;
                } else {
                    phi_1081_ = true;
                }
                let _e487 = phi_1081_;
                if _e487 {
                    let _e489 = local_1.group_mask;
                    let _e495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e489)), 32u, (_e489 == 0u)));
                    let _e499 = local_1.group_mask;
                    let _e513 = local_1.group_mask;
                    local_1.group_mask = (_e513 & ~((1u << bitcast<u32>((_e495 & 31u)))));
                    let _e516 = local_1.group;
                    phi_1112_ = (_e516 + countOneBits(((_e499 & ~((4294967295u << bitcast<u32>((((_e495 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1112_ = 4294967295u;
                }
                let _e519 = phi_1112_;
                phi_1114_ = _e519;
                loop {
                    let _e521 = phi_1114_;
                    if (_e521 != 4294967295u) {
                        if (_e521 < _e75) {
                        } else {
                            return;
                        }
                        let _e528 = nodes.member[(0u + _e521)].frame[3u];
                        let _e553 = (bitcast<f32>((((_e528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e285);
                        let _e554 = (bitcast<f32>((((_e528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e295);
                        let _e555 = (bitcast<f32>((((_e528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e305);
                        let _e558 = nodes.member[(0u + _e521)].frame[0u];
                        let _e562 = nodes.member[(0u + _e521)].frame[1u];
                        let _e566 = nodes.member[(0u + _e521)].frame[2u];
                        let _e571 = ((bitcast<f32>(_e558) - _e126) * _e285);
                        let _e572 = ((bitcast<f32>(_e562) - _e128) * _e295);
                        let _e573 = ((bitcast<f32>(_e566) - _e130) * _e305);
                        let _e581 = nodes.member[(0u + _e521)].x;
                        if (_e285 < 0f) {
                            let _e592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e581.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e592.unnamed.root, _e581.w), _e592.unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e598.unnamed, lt_bvh_traverse_Tree(_e581.x, _e598.unnamed_1.first_primitive));
                            phi_1195_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e604.unnamed_1.root, _e581.y));
                        } else {
                            let _e620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e581.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e620.unnamed.root, _e581.y), _e620.unnamed_1);
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e626.unnamed, lt_bvh_traverse_Tree(_e581.z, _e626.unnamed_1.first_primitive));
                            phi_1195_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e632.unnamed, lt_bvh_traverse_Tree(_e632.unnamed_1.root, _e581.w));
                        }
                        let _e640 = phi_1195_;
                        let _e650 = nodes.member[(0u + _e521)].y;
                        if (_e295 < 0f) {
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e661.unnamed.root, _e650.w), _e661.unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_bvh_traverse_Tree(_e650.x, _e667.unnamed_1.first_primitive));
                            phi_1222_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e673.unnamed_1.root, _e650.y));
                        } else {
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e689.unnamed.root, _e650.y), _e689.unnamed_1);
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e695.unnamed, lt_bvh_traverse_Tree(_e650.z, _e695.unnamed_1.first_primitive));
                            phi_1222_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e701.unnamed, lt_bvh_traverse_Tree(_e701.unnamed_1.root, _e650.w));
                        }
                        let _e709 = phi_1222_;
                        let _e719 = nodes.member[(0u + _e521)].z;
                        if (_e305 < 0f) {
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e730.unnamed.root, _e719.w), _e730.unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_bvh_traverse_Tree(_e719.x, _e736.unnamed_1.first_primitive));
                            phi_1249_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e742.unnamed_1.root, _e719.y));
                        } else {
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e758.unnamed.root, _e719.y), _e758.unnamed_1);
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e764.unnamed, lt_bvh_traverse_Tree(_e719.z, _e764.unnamed_1.first_primitive));
                            phi_1249_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e770.unnamed, lt_bvh_traverse_Tree(_e770.unnamed_1.root, _e719.w));
                        }
                        let _e778 = phi_1249_;
                        phi_1255_ = 0u;
                        phi_1258_ = 0u;
                        loop {
                            let _e788 = phi_1255_;
                            let _e790 = phi_1258_;
                            local_2 = _e790;
                            local_3 = _e790;
                            local_4 = _e790;
                            let _e791 = (_e788 < 8u);
                            if _e791 {
                                let _e793 = (_e788 >> bitcast<u32>(2i));
                                let _e794 = (_e788 & 3u);
                                if (_e793 == 0u) {
                                    phi_1272_ = _e640.unnamed.root;
                                } else {
                                    phi_1272_ = _e640.unnamed.first_primitive;
                                }
                                let _e797 = phi_1272_;
                                if (_e793 == 0u) {
                                    phi_1282_ = _e709.unnamed.root;
                                } else {
                                    phi_1282_ = _e709.unnamed.first_primitive;
                                }
                                let _e806 = phi_1282_;
                                if (_e793 == 0u) {
                                    phi_1292_ = _e778.unnamed.root;
                                } else {
                                    phi_1292_ = _e778.unnamed.first_primitive;
                                }
                                let _e815 = phi_1292_;
                                let _e828 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e797 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u)) * _e553) + (_e571 - _e333)), ((f32(((_e806 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u)) * _e554) + (_e572 - _e334)));
                                let _e829 = core_intrinsics_maximum_number_nsz_f32_(_e828, ((f32(((_e815 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u)) * _e555) + (_e573 - _e335)));
                                if (_e793 == 0u) {
                                    phi_1310_ = _e640.unnamed_1.root;
                                } else {
                                    phi_1310_ = _e640.unnamed_1.first_primitive;
                                }
                                let _e832 = phi_1310_;
                                if (_e793 == 0u) {
                                    phi_1320_ = _e709.unnamed_1.root;
                                } else {
                                    phi_1320_ = _e709.unnamed_1.first_primitive;
                                }
                                let _e841 = phi_1320_;
                                if (_e793 == 0u) {
                                    phi_1330_ = _e778.unnamed_1.root;
                                } else {
                                    phi_1330_ = _e778.unnamed_1.first_primitive;
                                }
                                let _e850 = phi_1330_;
                                let _e863 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e832 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u)) * _e553) + (_e571 + _e333)), ((f32(((_e841 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u)) * _e554) + (_e572 + _e334)));
                                let _e864 = core_intrinsics_minimum_number_nsz_f32_(_e863, ((f32(((_e850 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u)) * _e555) + (_e573 + _e335)));
                                if (_e829 <= _e864) {
                                    if (_e829 <= _e136) {
                                        if (_e864 >= 0f) {
                                            if (_e793 == 0u) {
                                                let _e871 = nodes.member[(0u + _e521)].links[2u];
                                                phi_1366_ = _e871;
                                            } else {
                                                let _e874 = nodes.member[(0u + _e521)].links[3u];
                                                phi_1366_ = _e874;
                                            }
                                            let _e876 = phi_1366_;
                                            let _e881 = ((_e876 >> bitcast<u32>(((_e794 * 8u) & 31u))) & 255u);
                                            let _e882 = (_e881 & 31u);
                                            if (_e882 >= 24u) {
                                                phi_1379_ = (24u + ((_e882 - 24u) ^ _e383));
                                            } else {
                                                phi_1379_ = _e882;
                                            }
                                            let _e888 = phi_1379_;
                                            phi_1384_ = (_e790 | ((_e881 >> bitcast<u32>(5i)) << bitcast<u32>((_e888 & 31u))));
                                        } else {
                                            phi_1384_ = _e790;
                                        }
                                        let _e896 = phi_1384_;
                                        phi_1385_ = _e896;
                                    } else {
                                        phi_1385_ = _e790;
                                    }
                                    let _e898 = phi_1385_;
                                    phi_1386_ = _e898;
                                } else {
                                    phi_1386_ = _e790;
                                }
                                let _e900 = phi_1386_;
                                phi_1256_ = (_e788 + 1u);
                                phi_1259_ = _e900;
                            } else {
                                phi_1256_ = u32();
                                phi_1259_ = u32();
                            }
                            let _e903 = phi_1256_;
                            let _e905 = phi_1259_;
                            continue;
                            continuing {
                                phi_1255_ = _e903;
                                phi_1258_ = _e905;
                                break if !(_e791);
                            }
                        }
                        let _e909 = nodes.member[(0u + _e521)].links[0u];
                        let _e913 = nodes.member[(0u + _e521)].frame[3u];
                        let _e917 = local_2;
                        if ((_e917 & 4278190080u) == 0u) {
                        } else {
                            let _e921 = local_1.group_mask;
                            if ((_e921 & 4278190080u) == 0u) {
                            } else {
                                let _e925 = local_1.len;
                                if (_e925 < 32u) {
                                    let _e928 = local_1.group;
                                    let _e930 = local_1.len;
                                    if (_e930 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e930)] = _e928;
                                    let _e936 = local_1.group_mask;
                                    let _e938 = local_1.len;
                                    if (_e938 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e938)] = _e936;
                                    let _e945 = local_1.len;
                                    local_1.len = (_e945 + 1u);
                                }
                            }
                            local_1.group = (0u + _e909);
                            let _e949 = local_3;
                            local_1.group_mask = ((_e949 & 4278190080u) | (_e913 >> bitcast<u32>(24i)));
                        }
                        let _e954 = local_4;
                        phi_1444_ = (_e954 & 16777215u);
                        loop {
                            let _e957 = phi_1444_;
                            let _e958 = (_e957 == 0u);
                            local_5 = _e958;
                            local_9 = _e958;
                            if _e958 {
                                phi_1445_ = u32();
                                phi_2252_ = false;
                                phi_2253_ = false;
                                phi_2254_ = false;
                            } else {
                                let _e961 = nodes.member[(0u + _e521)].links[1u];
                                let _e966 = ((0u + _e961) + select(firstTrailingBit(_e957), 32u, (_e957 == 0u)));
                                if (_e966 < _e78) {
                                } else {
                                    return;
                                }
                                let _e973 = triangles.member[(0u + _e966)].v0_;
                                let _e975 = (_e973.x - _e126);
                                let _e977 = (_e973.y - _e128);
                                let _e979 = (_e973.z - _e130);
                                if (_e356 == 0u) {
                                    phi_1490_ = vec3<f32>(_e977, _e979, _e975);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1489_ = vec3<f32>(_e979, _e975, _e977);
                                    } else {
                                        phi_1489_ = (_e973 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e987 = phi_1489_;
                                    phi_1490_ = _e987;
                                }
                                let _e989 = phi_1490_;
                                let _e993 = (_e989.x - (_e367 * _e989.z));
                                let _e997 = (_e989.y - (_e370 * _e989.z));
                                let _e999 = triangles.member[(0u + _e966)].v1_;
                                let _e1001 = (_e999.x - _e126);
                                let _e1003 = (_e999.y - _e128);
                                let _e1005 = (_e999.z - _e130);
                                if (_e356 == 0u) {
                                    phi_1520_ = vec3<f32>(_e1003, _e1005, _e1001);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1519_ = vec3<f32>(_e1005, _e1001, _e1003);
                                    } else {
                                        phi_1519_ = (_e999 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1013 = phi_1519_;
                                    phi_1520_ = _e1013;
                                }
                                let _e1015 = phi_1520_;
                                let _e1019 = (_e1015.x - (_e367 * _e1015.z));
                                let _e1023 = (_e1015.y - (_e370 * _e1015.z));
                                let _e1025 = triangles.member[(0u + _e966)].v2_;
                                let _e1027 = (_e1025.x - _e126);
                                let _e1029 = (_e1025.y - _e128);
                                let _e1031 = (_e1025.z - _e130);
                                if (_e356 == 0u) {
                                    phi_1550_ = vec3<f32>(_e1029, _e1031, _e1027);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1549_ = vec3<f32>(_e1031, _e1027, _e1029);
                                    } else {
                                        phi_1549_ = (_e1025 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1039 = phi_1549_;
                                    phi_1550_ = _e1039;
                                }
                                let _e1041 = phi_1550_;
                                let _e1045 = (_e1041.x - (_e367 * _e1041.z));
                                let _e1049 = (_e1041.y - (_e370 * _e1041.z));
                                if (_e1019 < _e1045) {
                                    phi_1569_ = true;
                                } else {
                                    if (_e1019 == _e1045) {
                                        phi_1568_ = (_e1023 < _e1049);
                                    } else {
                                        phi_1568_ = false;
                                    }
                                    let _e1054 = phi_1568_;
                                    phi_1569_ = _e1054;
                                }
                                let _e1056 = phi_1569_;
                                if _e1056 {
                                    phi_1573_ = _e1049;
                                    phi_1574_ = _e1045;
                                    phi_1575_ = _e1023;
                                    phi_1576_ = _e1019;
                                } else {
                                    phi_1573_ = _e1023;
                                    phi_1574_ = _e1019;
                                    phi_1575_ = _e1049;
                                    phi_1576_ = _e1045;
                                }
                                let _e1058 = phi_1573_;
                                let _e1060 = phi_1574_;
                                let _e1062 = phi_1575_;
                                let _e1064 = phi_1576_;
                                let _e1067 = ((_e1064 * _e1058) - (_e1062 * _e1060));
                                if _e1056 {
                                    phi_1584_ = -(_e1067);
                                } else {
                                    phi_1584_ = _e1067;
                                }
                                let _e1070 = phi_1584_;
                                if (_e1045 < _e993) {
                                    phi_1595_ = true;
                                } else {
                                    if (_e1045 == _e993) {
                                        phi_1594_ = (_e1049 < _e997);
                                    } else {
                                        phi_1594_ = false;
                                    }
                                    let _e1075 = phi_1594_;
                                    phi_1595_ = _e1075;
                                }
                                let _e1077 = phi_1595_;
                                if _e1077 {
                                    phi_1599_ = _e997;
                                    phi_1600_ = _e993;
                                    phi_1601_ = _e1049;
                                    phi_1602_ = _e1045;
                                } else {
                                    phi_1599_ = _e1049;
                                    phi_1600_ = _e1045;
                                    phi_1601_ = _e997;
                                    phi_1602_ = _e993;
                                }
                                let _e1079 = phi_1599_;
                                let _e1081 = phi_1600_;
                                let _e1083 = phi_1601_;
                                let _e1085 = phi_1602_;
                                let _e1088 = ((_e1085 * _e1079) - (_e1083 * _e1081));
                                if _e1077 {
                                    phi_1610_ = -(_e1088);
                                } else {
                                    phi_1610_ = _e1088;
                                }
                                let _e1091 = phi_1610_;
                                if (_e993 < _e1019) {
                                    phi_1621_ = true;
                                } else {
                                    if (_e993 == _e1019) {
                                        phi_1620_ = (_e997 < _e1023);
                                    } else {
                                        phi_1620_ = false;
                                    }
                                    let _e1096 = phi_1620_;
                                    phi_1621_ = _e1096;
                                }
                                let _e1098 = phi_1621_;
                                if _e1098 {
                                    phi_1625_ = _e1023;
                                    phi_1626_ = _e1019;
                                    phi_1627_ = _e997;
                                    phi_1628_ = _e993;
                                } else {
                                    phi_1625_ = _e997;
                                    phi_1626_ = _e993;
                                    phi_1627_ = _e1023;
                                    phi_1628_ = _e1019;
                                }
                                let _e1100 = phi_1625_;
                                let _e1102 = phi_1626_;
                                let _e1104 = phi_1627_;
                                let _e1106 = phi_1628_;
                                let _e1109 = ((_e1106 * _e1100) - (_e1104 * _e1102));
                                if _e1098 {
                                    phi_1636_ = -(_e1109);
                                } else {
                                    phi_1636_ = _e1109;
                                }
                                let _e1112 = phi_1636_;
                                if (_e1070 >= 0f) {
                                    if (_e1091 >= 0f) {
                                        if (_e1112 >= 0f) {
                                            phi_1651_ = ((_e1070 + _e1091) + _e1112);
                                            phi_1652_ = false;
                                        } else {
                                            phi_1651_ = f32();
                                            phi_1652_ = true;
                                        }
                                        let _e1119 = phi_1651_;
                                        let _e1121 = phi_1652_;
                                        phi_1653_ = _e1119;
                                        phi_1654_ = _e1121;
                                    } else {
                                        phi_1653_ = f32();
                                        phi_1654_ = true;
                                    }
                                    let _e1123 = phi_1653_;
                                    let _e1125 = phi_1654_;
                                    phi_1655_ = _e1123;
                                    phi_1656_ = _e1125;
                                } else {
                                    phi_1655_ = f32();
                                    phi_1656_ = true;
                                }
                                let _e1127 = phi_1655_;
                                let _e1129 = phi_1656_;
                                if _e1129 {
                                    if (_e1070 <= 0f) {
                                        if (_e1091 <= 0f) {
                                            let _e1132 = (_e1112 <= 0f);
                                            if _e1132 {
                                            }
                                            phi_1674_ = ((_e1070 + _e1091) + _e1112);
                                            phi_1675_ = false;
                                            phi_1676_ = _e1132;
                                        } else {
                                            phi_1674_ = f32();
                                            phi_1675_ = true;
                                            phi_1676_ = false;
                                        }
                                        let _e1136 = phi_1674_;
                                        let _e1138 = phi_1675_;
                                        let _e1140 = phi_1676_;
                                        phi_1677_ = _e1136;
                                        phi_1678_ = _e1138;
                                        phi_1679_ = _e1140;
                                    } else {
                                        phi_1677_ = f32();
                                        phi_1678_ = true;
                                        phi_1679_ = false;
                                    }
                                    let _e1142 = phi_1677_;
                                    let _e1144 = phi_1678_;
                                    let _e1146 = phi_1679_;
                                    if _e1144 {
                                        phi_1683_ = false;
                                    } else {
                                        phi_1683_ = _e1146;
                                    }
                                    let _e1148 = phi_1683_;
                                    phi_1684_ = _e1142;
                                    phi_1685_ = _e1148;
                                } else {
                                    phi_1684_ = _e1127;
                                    phi_1685_ = true;
                                }
                                let _e1150 = phi_1684_;
                                let _e1152 = phi_1685_;
                                if _e1152 {
                                    let _e1153 = (_e1150 == 0f);
                                    if _e1153 {
                                        phi_2001_ = lt_bvh_triangle_Intersection();
                                        phi_2002_ = false;
                                    } else {
                                        let _e1155 = triangles.member[(0u + _e966)].v0_;
                                        let _e1157 = (_e1155.x - _e126);
                                        let _e1159 = (_e1155.y - _e128);
                                        let _e1161 = (_e1155.z - _e130);
                                        if (_e356 == 0u) {
                                            phi_1714_ = vec3<f32>(_e1159, _e1161, _e1157);
                                        } else {
                                            if (_e356 == 1u) {
                                                phi_1713_ = vec3<f32>(_e1161, _e1157, _e1159);
                                            } else {
                                                phi_1713_ = (_e1155 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e1169 = phi_1713_;
                                            phi_1714_ = _e1169;
                                        }
                                        let _e1171 = phi_1714_;
                                        let _e1173 = triangles.member[(0u + _e966)].v1_;
                                        let _e1175 = triangles.member[(0u + _e966)].v0_;
                                        let _e1178 = (_e1173.x - _e1175.x);
                                        let _e1181 = (_e1173.y - _e1175.y);
                                        let _e1184 = (_e1173.z - _e1175.z);
                                        if (_e356 == 0u) {
                                            phi_1740_ = vec3<f32>(_e1181, _e1184, _e1178);
                                        } else {
                                            if (_e356 == 1u) {
                                                phi_1739_ = vec3<f32>(_e1184, _e1178, _e1181);
                                            } else {
                                                phi_1739_ = (_e1173 - _e1175);
                                            }
                                            let _e1191 = phi_1739_;
                                            phi_1740_ = _e1191;
                                        }
                                        let _e1193 = phi_1740_;
                                        let _e1195 = triangles.member[(0u + _e966)].v2_;
                                        let _e1197 = triangles.member[(0u + _e966)].v0_;
                                        let _e1200 = (_e1195.x - _e1197.x);
                                        let _e1203 = (_e1195.y - _e1197.y);
                                        let _e1206 = (_e1195.z - _e1197.z);
                                        if (_e356 == 0u) {
                                            phi_1766_ = vec3<f32>(_e1203, _e1206, _e1200);
                                        } else {
                                            if (_e356 == 1u) {
                                                phi_1765_ = vec3<f32>(_e1206, _e1200, _e1203);
                                            } else {
                                                phi_1765_ = (_e1195 - _e1197);
                                            }
                                            let _e1213 = phi_1765_;
                                            phi_1766_ = _e1213;
                                        }
                                        let _e1215 = phi_1766_;
                                        let _e1222 = ((_e1193.y * _e1215.z) - (_e1193.z * _e1215.y));
                                        let _e1229 = ((_e1193.z * _e1215.x) - (_e1193.x * _e1215.z));
                                        let _e1236 = ((_e1193.x * _e1215.y) - (_e1193.y * _e1215.x));
                                        let _e1250 = (((1f / _e364.z) * (((_e1222 * _e1171.x) + (_e1229 * _e1171.y)) + (_e1236 * _e1171.z))) / (((_e1222 * _e367) + (_e1229 * _e370)) + _e1236));
                                        if (_e1250 > 0f) {
                                            if (_e1250 < _e136) {
                                                let _e1254 = triangles.member[(0u + _e966)].v0_;
                                                let _e1256 = triangles.member[(0u + _e966)].v1_;
                                                if (_e1254.x < _e1256.x) {
                                                    phi_1822_ = _e1254.x;
                                                } else {
                                                    phi_1822_ = _e1256.x;
                                                }
                                                let _e1263 = phi_1822_;
                                                if (_e1254.y < _e1256.y) {
                                                    phi_1831_ = _e1254.y;
                                                } else {
                                                    phi_1831_ = _e1256.y;
                                                }
                                                let _e1270 = phi_1831_;
                                                if (_e1254.z < _e1256.z) {
                                                    phi_1840_ = _e1254.z;
                                                } else {
                                                    phi_1840_ = _e1256.z;
                                                }
                                                let _e1277 = phi_1840_;
                                                let _e1279 = triangles.member[(0u + _e966)].v2_;
                                                if (_e1263 < _e1279.x) {
                                                    phi_1849_ = _e1263;
                                                } else {
                                                    phi_1849_ = _e1279.x;
                                                }
                                                let _e1284 = phi_1849_;
                                                if (_e1270 < _e1279.y) {
                                                    phi_1856_ = _e1270;
                                                } else {
                                                    phi_1856_ = _e1279.y;
                                                }
                                                let _e1289 = phi_1856_;
                                                if (_e1277 < _e1279.z) {
                                                    phi_1863_ = _e1277;
                                                } else {
                                                    phi_1863_ = _e1279.z;
                                                }
                                                let _e1294 = phi_1863_;
                                                let _e1296 = triangles.member[(0u + _e966)].v0_;
                                                let _e1298 = triangles.member[(0u + _e966)].v1_;
                                                if (_e1296.x > _e1298.x) {
                                                    phi_1876_ = _e1296.x;
                                                } else {
                                                    phi_1876_ = _e1298.x;
                                                }
                                                let _e1305 = phi_1876_;
                                                if (_e1296.y > _e1298.y) {
                                                    phi_1885_ = _e1296.y;
                                                } else {
                                                    phi_1885_ = _e1298.y;
                                                }
                                                let _e1312 = phi_1885_;
                                                if (_e1296.z > _e1298.z) {
                                                    phi_1894_ = _e1296.z;
                                                } else {
                                                    phi_1894_ = _e1298.z;
                                                }
                                                let _e1319 = phi_1894_;
                                                let _e1321 = triangles.member[(0u + _e966)].v2_;
                                                if (_e1305 > _e1321.x) {
                                                    phi_1903_ = _e1305;
                                                } else {
                                                    phi_1903_ = _e1321.x;
                                                }
                                                let _e1326 = phi_1903_;
                                                if (_e1312 > _e1321.y) {
                                                    phi_1910_ = _e1312;
                                                } else {
                                                    phi_1910_ = _e1321.y;
                                                }
                                                let _e1331 = phi_1910_;
                                                if (_e1319 > _e1321.z) {
                                                    phi_1917_ = _e1319;
                                                } else {
                                                    phi_1917_ = _e1321.z;
                                                }
                                                let _e1336 = phi_1917_;
                                                let _e1340 = ((_e1284 - _e126) * _e285);
                                                let _e1341 = ((_e1289 - _e128) * _e295);
                                                let _e1342 = ((_e1294 - _e130) * _e305);
                                                let _e1346 = ((_e1326 - _e126) * _e285);
                                                let _e1347 = ((_e1331 - _e128) * _e295);
                                                let _e1348 = ((_e1336 - _e130) * _e305);
                                                if (_e1340 < _e1346) {
                                                    phi_1934_ = _e1340;
                                                } else {
                                                    phi_1934_ = _e1346;
                                                }
                                                let _e1351 = phi_1934_;
                                                if (_e1341 < _e1347) {
                                                    phi_1939_ = _e1341;
                                                } else {
                                                    phi_1939_ = _e1347;
                                                }
                                                let _e1354 = phi_1939_;
                                                if (_e1342 < _e1348) {
                                                    phi_1944_ = _e1342;
                                                } else {
                                                    phi_1944_ = _e1348;
                                                }
                                                let _e1357 = phi_1944_;
                                                if (_e1340 > _e1346) {
                                                    phi_1952_ = _e1340;
                                                } else {
                                                    phi_1952_ = _e1346;
                                                }
                                                let _e1363 = phi_1952_;
                                                if (_e1341 > _e1347) {
                                                    phi_1957_ = _e1341;
                                                } else {
                                                    phi_1957_ = _e1347;
                                                }
                                                let _e1366 = phi_1957_;
                                                if (_e1342 > _e1348) {
                                                    phi_1962_ = _e1342;
                                                } else {
                                                    phi_1962_ = _e1348;
                                                }
                                                let _e1369 = phi_1962_;
                                                let _e1373 = core_intrinsics_maximum_number_nsz_f32_((_e1351 - _e340), (_e1354 - _e341));
                                                let _e1374 = core_intrinsics_maximum_number_nsz_f32_(_e1373, (_e1357 - _e342));
                                                let _e1375 = core_intrinsics_minimum_number_nsz_f32_((_e1363 + _e340), (_e1366 + _e341));
                                                let _e1376 = core_intrinsics_minimum_number_nsz_f32_(_e1375, (_e1369 + _e342));
                                                if (_e1374 > -300000000000000000000000000000000000000f) {
                                                    phi_1974_ = _e1374;
                                                } else {
                                                    phi_1974_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1379 = phi_1974_;
                                                if (_e1376 < 300000000000000000000000000000000000000f) {
                                                    phi_1979_ = _e1376;
                                                } else {
                                                    phi_1979_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1382 = phi_1979_;
                                                if (_e1250 < _e1379) {
                                                    phi_1984_ = _e1379;
                                                } else {
                                                    phi_1984_ = _e1250;
                                                }
                                                let _e1385 = phi_1984_;
                                                if (_e1385 > _e1382) {
                                                    phi_1989_ = _e1382;
                                                } else {
                                                    phi_1989_ = _e1385;
                                                }
                                                let _e1388 = phi_1989_;
                                                phi_1994_ = lt_bvh_triangle_Intersection(_e1388, (_e1091 / _e1150), (_e1112 / _e1150), (_e1379 <= _e1382));
                                                phi_1995_ = false;
                                            } else {
                                                phi_1994_ = lt_bvh_triangle_Intersection();
                                                phi_1995_ = true;
                                            }
                                            let _e1394 = phi_1994_;
                                            let _e1396 = phi_1995_;
                                            phi_1996_ = _e1394;
                                            phi_1997_ = _e1396;
                                        } else {
                                            phi_1996_ = lt_bvh_triangle_Intersection();
                                            phi_1997_ = true;
                                        }
                                        let _e1398 = phi_1996_;
                                        let _e1400 = phi_1997_;
                                        if _e1400 {
                                        }
                                        phi_2001_ = _e1398;
                                        phi_2002_ = _e1400;
                                    }
                                    let _e1402 = phi_2001_;
                                    let _e1404 = phi_2002_;
                                    phi_2003_ = _e1402;
                                    phi_2004_ = _e1153;
                                    phi_2005_ = _e1404;
                                } else {
                                    phi_2003_ = lt_bvh_triangle_Intersection();
                                    phi_2004_ = true;
                                    phi_2005_ = false;
                                }
                                let _e1406 = phi_2003_;
                                let _e1408 = phi_2004_;
                                let _e1410 = phi_2005_;
                                if _e1408 {
                                    phi_2009_ = true;
                                } else {
                                    phi_2009_ = _e1410;
                                }
                                let _e1412 = phi_2009_;
                                if _e1412 {
                                    phi_2013_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2013_ = _e1406;
                                }
                                let _e1414 = phi_2013_;
                                if _e1414.is_hit {
                                    if (_e1414.t > 0f) {
                                        if (_e1414.t < _e136) {
                                            let _e1421 = triangles.member[(0u + _e966)].i0_;
                                            let _e1423 = ((_e1421 & 2147483648u) == 0u);
                                            if _e1423 {
                                                phi_2236_ = false;
                                                phi_2237_ = false;
                                            } else {
                                                if (_e966 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1430 = triangles.member[(0u + _e966)].i0_;
                                                let _e1431 = (_e1430 & 2147483647u);
                                                let _e1433 = triangles.member[(0u + _e966)].i1_;
                                                let _e1435 = triangles.member[(0u + _e966)].i2_;
                                                if (_e1431 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1439 = vertices.member[(0u + _e1431)];
                                                if (_e1433 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1443 = vertices.member[(0u + _e1433)];
                                                if (_e1435 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1447 = vertices.member[(0u + _e1435)];
                                                let _e1448 = array<abi_Vertex, 3>(_e1439, _e1443, _e1447);
                                                if (_e1448[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1454 = materials.member[(0u + _e1448[0].material)];
                                                if ((_e1454.flags & 1u) == 1u) {
                                                    let _e1459 = ((1f - _e1414.u) - _e1414.v);
                                                    if (_e1454.cutoff <= 0f) {
                                                        phi_2230_ = true;
                                                    } else {
                                                        let _e1486 = (_e1454.base_color.w * ((((f32((_e1448[0].color >> bitcast<u32>(24i))) * _e1459) + (f32((_e1448[1].color >> bitcast<u32>(24i))) * _e1414.u)) + (f32((_e1448[2].color >> bitcast<u32>(24i))) * _e1414.v)) * (1f / 255f)));
                                                        if (_e1454.alpha_size == 0u) {
                                                            phi_2227_ = _e1486;
                                                        } else {
                                                            local.offset = _e1454.alpha_offset;
                                                            local.size = _e1454.alpha_size;
                                                            local.flags = _e1454.flags;
                                                            let _e1517 = _lt_shaders_texture_TextureView_quad((&local), (((_e1448[0].u * _e1459) + (_e1448[1].u * _e1414.u)) + (_e1448[2].u * _e1414.v)), (((_e1448[0].v * _e1459) + (_e1448[1].v * _e1414.u)) + (_e1448[2].v * _e1414.v)));
                                                            let _e1521 = (_e1517.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1521 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1525 = alpha_texels.member[(0u + _e1521)];
                                                            let _e1541 = (_e1517.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1541 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1545 = alpha_texels.member[(0u + _e1541)];
                                                            let _e1562 = (_e1517.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1562 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1566 = alpha_texels.member[(0u + _e1562)];
                                                            let _e1583 = (_e1517.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1583 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1587 = alpha_texels.member[(0u + _e1583)];
                                                            phi_2227_ = (_e1486 * (((((f32(((_e1525 >> bitcast<u32>((((_e1517.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.x) + ((f32(((_e1545 >> bitcast<u32>((((_e1517.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.y)) + ((f32(((_e1566 >> bitcast<u32>((((_e1517.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.z)) + ((f32(((_e1587 >> bitcast<u32>((((_e1517.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.w)));
                                                        }
                                                        let _e1603 = phi_2227_;
                                                        phi_2230_ = (_e1603 >= _e1454.cutoff);
                                                    }
                                                    let _e1607 = phi_2230_;
                                                    phi_2231_ = _e1607;
                                                } else {
                                                    phi_2231_ = false;
                                                }
                                                let _e1609 = phi_2231_;
                                                if _e1609 {
                                                    phi_2235_ = false;
                                                } else {
                                                    phi_2235_ = true;
                                                }
                                                let _e1611 = phi_2235_;
                                                phi_2236_ = _e1611;
                                                phi_2237_ = _e1609;
                                            }
                                            let _e1613 = phi_2236_;
                                            let _e1615 = phi_2237_;
                                            phi_2238_ = _e1613;
                                            phi_2239_ = _e1423;
                                            phi_2240_ = _e1615;
                                        } else {
                                            phi_2238_ = true;
                                            phi_2239_ = false;
                                            phi_2240_ = false;
                                        }
                                        let _e1617 = phi_2238_;
                                        let _e1619 = phi_2239_;
                                        let _e1621 = phi_2240_;
                                        phi_2241_ = _e1617;
                                        phi_2242_ = _e1619;
                                        phi_2243_ = _e1621;
                                    } else {
                                        phi_2241_ = true;
                                        phi_2242_ = false;
                                        phi_2243_ = false;
                                    }
                                    let _e1623 = phi_2241_;
                                    let _e1625 = phi_2242_;
                                    let _e1627 = phi_2243_;
                                    phi_2244_ = _e1623;
                                    phi_2245_ = _e1625;
                                    phi_2246_ = _e1627;
                                } else {
                                    phi_2244_ = true;
                                    phi_2245_ = false;
                                    phi_2246_ = false;
                                }
                                let _e1629 = phi_2244_;
                                let _e1631 = phi_2245_;
                                let _e1633 = phi_2246_;
                                if _e1629 {
                                    phi_2250_ = false;
                                    phi_2251_ = false;
                                } else {
                                    phi_2250_ = _e1631;
                                    phi_2251_ = _e1633;
                                }
                                let _e1635 = phi_2250_;
                                let _e1637 = phi_2251_;
                                phi_1445_ = (_e957 & (_e957 - 1u));
                                phi_2252_ = _e1629;
                                phi_2253_ = _e1635;
                                phi_2254_ = _e1637;
                            }
                            let _e1639 = phi_1445_;
                            let _e1641 = phi_2252_;
                            let _e1643 = phi_2253_;
                            let _e1645 = phi_2254_;
                            local_7 = _e1643;
                            local_8 = _e1645;
                            continue;
                            continuing {
                                phi_1444_ = _e1639;
                                break if !(_e1641);
                            }
                        }
                        let _e1648 = local_5;
                        if _e1648 {
                            let _e1650 = local_1.group_mask;
                            if ((_e1650 & 4278190080u) == 0u) {
                                let _e1654 = local_1.len;
                                if (_e1654 == 0u) {
                                    phi_2296_ = false;
                                } else {
                                    let _e1658 = local_1.len;
                                    local_1.len = (_e1658 - 1u);
                                    let _e1661 = local_1.len;
                                    if (_e1661 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1666 = local_1.first[(0u + _e1661)];
                                    local_1.group = _e1666;
                                    let _e1669 = local_1.len;
                                    if (_e1669 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1674 = local_1.mask[(0u + _e1669)];
                                    local_1.group_mask = _e1674;
                                    phi_2296_ = true;
                                }
                                let _e1677 = phi_2296_;
                                phi_2297_ = _e1677;
                            } else {
                                phi_2297_ = true;
                            }
                            let _e1679 = phi_2297_;
                            if _e1679 {
                                let _e1681 = local_1.group_mask;
                                let _e1687 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1681)), 32u, (_e1681 == 0u)));
                                let _e1691 = local_1.group_mask;
                                let _e1705 = local_1.group_mask;
                                local_1.group_mask = (_e1705 & ~((1u << bitcast<u32>((_e1687 & 31u)))));
                                let _e1708 = local_1.group;
                                phi_2328_ = (_e1708 + countOneBits(((_e1691 & ~((4294967295u << bitcast<u32>((((_e1687 - 24u) ^ _e383) & 31u))))) & 255u)));
                            } else {
                                phi_2328_ = 4294967295u;
                            }
                            let _e1711 = phi_2328_;
                            phi_2329_ = _e1711;
                            phi_2330_ = false;
                            phi_2331_ = false;
                        } else {
                            phi_2329_ = u32();
                            let _e1929 = local_7;
                            phi_2330_ = _e1929;
                            let _e1932 = local_8;
                            phi_2331_ = _e1932;
                        }
                        let _e1713 = phi_2329_;
                        let _e1715 = phi_2330_;
                        let _e1717 = phi_2331_;
                        phi_1115_ = _e1713;
                        let _e1936 = local_9;
                        phi_2332_ = _e1936;
                        phi_2333_ = false;
                        phi_2334_ = _e1715;
                        phi_2335_ = _e1717;
                    } else {
                        phi_1115_ = u32();
                        phi_2332_ = false;
                        phi_2333_ = true;
                        phi_2334_ = false;
                        phi_2335_ = false;
                    }
                    let _e1719 = phi_1115_;
                    let _e1721 = phi_2332_;
                    let _e1723 = phi_2333_;
                    let _e1725 = phi_2334_;
                    let _e1727 = phi_2335_;
                    local_6 = _e1723;
                    local_10 = _e1725;
                    local_11 = _e1727;
                    continue;
                    continuing {
                        phi_1114_ = _e1719;
                        break if !(_e1721);
                    }
                }
                let _e1730 = local_6;
                if _e1730 {
                    phi_2339_ = false;
                    phi_2340_ = false;
                } else {
                    let _e1943 = local_10;
                    phi_2339_ = _e1943;
                    let _e1946 = local_11;
                    phi_2340_ = _e1946;
                }
                let _e1732 = phi_2339_;
                let _e1734 = phi_2340_;
                if _e1732 {
                    phi_2344_ = true;
                } else {
                    phi_2344_ = _e1734;
                }
                let _e1736 = phi_2344_;
                if _e1736 {
                    phi_2348_ = true;
                } else {
                    phi_2348_ = false;
                }
                let _e1738 = phi_2348_;
                phi_2349_ = _e1738;
            }
            let _e1740 = phi_2349_;
            phi_2350_ = _e1740;
            phi_2351_ = _e209;
        } else {
            phi_2350_ = bool();
            phi_2351_ = true;
        }
        let _e1742 = phi_2350_;
        let _e1744 = phi_2351_;
        if _e1744 {
            phi_2355_ = false;
        } else {
            phi_2355_ = _e1742;
        }
        let _e1746 = phi_2355_;
        if _e1746 {
            phi_2359_ = 0f;
        } else {
            phi_2359_ = 1f;
        }
        let _e1748 = phi_2359_;
        if (_e106 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e1748;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
