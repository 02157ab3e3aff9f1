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

struct type_29 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_33 {
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

struct type_37 {
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

struct type_50 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_56 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(2) 
var<storage> nodes: type_50;
@group(0) @binding(3) 
var<storage> triangles: type_29;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_33;
@group(0) @binding(8) 
var<storage> materials: type_37;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_224_: f32;
    var phi_229_: f32;
    var phi_230_: bool;
    var phi_231_: f32;
    var phi_232_: bool;
    var phi_236_: f32;
    var phi_262_: f32;
    var phi_267_: f32;
    var phi_268_: bool;
    var phi_269_: f32;
    var phi_270_: bool;
    var phi_274_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_312_: u32;
    var phi_326_: u32;
    var phi_333_: u32;
    var phi_338_: u32;
    var phi_344_: u32;
    var phi_349_: u32;
    var phi_351_: texture_Axis;
    var phi_379_: f32;
    var phi_384_: f32;
    var phi_385_: bool;
    var phi_386_: f32;
    var phi_387_: bool;
    var phi_391_: f32;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_437_: f32;
    var phi_438_: f32;
    var phi_439_: f32;
    var phi_448_: f32;
    var phi_449_: f32;
    var phi_467_: u32;
    var phi_481_: u32;
    var phi_488_: u32;
    var phi_493_: u32;
    var phi_499_: u32;
    var phi_504_: u32;
    var phi_506_: texture_Axis;

    let _e71 = (*param).size;
    let _e72 = (_e71 & 65535u);
    let _e74 = (*param).size;
    let _e76 = (_e74 >> bitcast<u32>(16i));
    let _e78 = (*param).flags;
    let _e80 = ((_e78 & 4u) != 0u);
    let _e82 = (*param).flags;
    let _e85 = ((_e82 >> bitcast<u32>(4u)) & 3u);
    if (_e85 == 0u) {
        if (param_1 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e98 > param_1) {
                phi_224_ = 1f;
            } else {
                phi_224_ = 0f;
            }
            let _e101 = phi_224_;
            if (param_1 < 8388608f) {
                phi_229_ = (_e98 - _e101);
                phi_230_ = false;
            } else {
                phi_229_ = f32();
                phi_230_ = true;
            }
            let _e104 = phi_229_;
            let _e106 = phi_230_;
            phi_231_ = _e104;
            phi_232_ = _e106;
        } else {
            phi_231_ = f32();
            phi_232_ = true;
        }
        let _e108 = phi_231_;
        let _e110 = phi_232_;
        if _e110 {
            phi_236_ = param_1;
        } else {
            phi_236_ = _e108;
        }
        let _e112 = phi_236_;
        phi_284_ = (param_1 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_1 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_262_ = 1f;
                } else {
                    phi_262_ = 0f;
                }
                let _e130 = phi_262_;
                if (_e115 < 8388608f) {
                    phi_267_ = (_e127 - _e130);
                    phi_268_ = false;
                } else {
                    phi_267_ = f32();
                    phi_268_ = true;
                }
                let _e133 = phi_267_;
                let _e135 = phi_268_;
                phi_269_ = _e133;
                phi_270_ = _e135;
            } else {
                phi_269_ = f32();
                phi_270_ = true;
            }
            let _e137 = phi_269_;
            let _e139 = phi_270_;
            if _e139 {
                phi_274_ = _e115;
            } else {
                phi_274_ = _e137;
            }
            let _e141 = phi_274_;
            let _e143 = (param_1 - (2f * _e141));
            if (_e143 > 1f) {
                phi_282_ = (2f - _e143);
            } else {
                phi_282_ = _e143;
            }
            let _e147 = phi_282_;
            phi_283_ = _e147;
        } else {
            phi_283_ = param_1;
        }
        let _e149 = phi_283_;
        phi_284_ = _e149;
    }
    let _e151 = phi_284_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_293_ = _e151;
        } else {
            phi_293_ = 1f;
        }
        let _e155 = phi_293_;
        phi_294_ = _e155;
    } else {
        phi_294_ = 0f;
    }
    let _e157 = phi_294_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_312_ = _e158;
        } else {
            phi_312_ = _e167;
        }
        let _e170 = phi_312_;
        phi_351_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_326_ = _e72;
        } else {
            phi_326_ = _e179;
        }
        let _e182 = phi_326_;
        if (_e85 == 0u) {
            phi_333_ = _e158;
        } else {
            phi_333_ = 0u;
        }
        let _e187 = phi_333_;
        if (_e85 == 0u) {
            phi_338_ = 0u;
        } else {
            phi_338_ = _e158;
        }
        let _e190 = phi_338_;
        if (_e182 == 0u) {
            phi_344_ = _e187;
        } else {
            phi_344_ = (_e182 - 1u);
        }
        let _e194 = phi_344_;
        if (_e182 > _e158) {
            phi_349_ = _e190;
        } else {
            phi_349_ = _e182;
        }
        let _e197 = phi_349_;
        phi_351_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_351_;
    let _e202 = (*param).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_2 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e218 > param_2) {
                phi_379_ = 1f;
            } else {
                phi_379_ = 0f;
            }
            let _e221 = phi_379_;
            if (param_2 < 8388608f) {
                phi_384_ = (_e218 - _e221);
                phi_385_ = false;
            } else {
                phi_384_ = f32();
                phi_385_ = true;
            }
            let _e224 = phi_384_;
            let _e226 = phi_385_;
            phi_386_ = _e224;
            phi_387_ = _e226;
        } else {
            phi_386_ = f32();
            phi_387_ = true;
        }
        let _e228 = phi_386_;
        let _e230 = phi_387_;
        if _e230 {
            phi_391_ = param_2;
        } else {
            phi_391_ = _e228;
        }
        let _e232 = phi_391_;
        phi_439_ = (param_2 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_2 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_417_ = 1f;
                } else {
                    phi_417_ = 0f;
                }
                let _e250 = phi_417_;
                if (_e235 < 8388608f) {
                    phi_422_ = (_e247 - _e250);
                    phi_423_ = false;
                } else {
                    phi_422_ = f32();
                    phi_423_ = true;
                }
                let _e253 = phi_422_;
                let _e255 = phi_423_;
                phi_424_ = _e253;
                phi_425_ = _e255;
            } else {
                phi_424_ = f32();
                phi_425_ = true;
            }
            let _e257 = phi_424_;
            let _e259 = phi_425_;
            if _e259 {
                phi_429_ = _e235;
            } else {
                phi_429_ = _e257;
            }
            let _e261 = phi_429_;
            let _e263 = (param_2 - (2f * _e261));
            if (_e263 > 1f) {
                phi_437_ = (2f - _e263);
            } else {
                phi_437_ = _e263;
            }
            let _e267 = phi_437_;
            phi_438_ = _e267;
        } else {
            phi_438_ = param_2;
        }
        let _e269 = phi_438_;
        phi_439_ = _e269;
    }
    let _e271 = phi_439_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_448_ = _e271;
        } else {
            phi_448_ = 1f;
        }
        let _e275 = phi_448_;
        phi_449_ = _e275;
    } else {
        phi_449_ = 0f;
    }
    let _e277 = phi_449_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_467_ = _e278;
        } else {
            phi_467_ = _e287;
        }
        let _e290 = phi_467_;
        phi_506_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_481_ = _e76;
        } else {
            phi_481_ = _e299;
        }
        let _e302 = phi_481_;
        if (_e205 == 0u) {
            phi_488_ = _e278;
        } else {
            phi_488_ = 0u;
        }
        let _e307 = phi_488_;
        if (_e205 == 0u) {
            phi_493_ = 0u;
        } else {
            phi_493_ = _e278;
        }
        let _e310 = phi_493_;
        if (_e302 == 0u) {
            phi_499_ = _e307;
        } else {
            phi_499_ = (_e302 - 1u);
        }
        let _e314 = phi_499_;
        if (_e302 > _e278) {
            phi_504_ = _e310;
        } else {
            phi_504_ = _e302;
        }
        let _e317 = phi_504_;
        phi_506_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_506_;
    let _e324 = (*param).offset;
    let _e331 = (*param).offset;
    let _e338 = (*param).offset;
    let _e345 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_565_: bool;
    var phi_569_: f32;

    if (param_3 != param_3) {
        phi_565_ = true;
    } else {
        let _e70 = (param_4 >= param_3);
        if _e70 {
        }
        phi_565_ = _e70;
    }
    let _e72 = phi_565_;
    if _e72 {
        phi_569_ = param_4;
    } else {
        phi_569_ = param_3;
    }
    let _e74 = phi_569_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_581_: bool;
    var phi_585_: f32;

    if (param_5 != param_5) {
        phi_581_ = true;
    } else {
        let _e70 = (param_6 <= param_5);
        if _e70 {
        }
        phi_581_ = _e70;
    }
    let _e72 = phi_581_;
    if _e72 {
        phi_585_ = param_6;
    } else {
        phi_585_ = param_5;
    }
    let _e74 = phi_585_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_677_: f32;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
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
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_759_: bool;
    var phi_763_: bool;
    var phi_833_: f32;
    var phi_840_: f32;
    var phi_847_: f32;
    var phi_854_: f32;
    var phi_861_: f32;
    var phi_868_: f32;
    var phi_885_: f32;
    var phi_890_: f32;
    var phi_895_: f32;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_932_: u32;
    var phi_933_: u32;
    var phi_944_: vec3<f32>;
    var phi_945_: vec3<f32>;
    var phi_958_: u32;
    var phi_963_: u32;
    var phi_968_: u32;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1114_: u32;
    var phi_1116_: u32;
    var phi_1197_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1224_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1251_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1257_: u32;
    var phi_1260_: u32;
    var phi_1274_: u32;
    var phi_1284_: u32;
    var phi_1294_: u32;
    var phi_1312_: u32;
    var phi_1322_: u32;
    var phi_1332_: u32;
    var phi_1368_: u32;
    var phi_1381_: u32;
    var phi_1386_: u32;
    var phi_1387_: u32;
    var phi_1388_: u32;
    var phi_1258_: u32;
    var phi_1261_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1446_: u32;
    var phi_1491_: vec3<f32>;
    var phi_1492_: vec3<f32>;
    var phi_1521_: vec3<f32>;
    var phi_1522_: vec3<f32>;
    var phi_1551_: vec3<f32>;
    var phi_1552_: vec3<f32>;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1586_: f32;
    var phi_1596_: bool;
    var phi_1597_: bool;
    var phi_1601_: f32;
    var phi_1602_: f32;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1612_: f32;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var phi_1627_: f32;
    var phi_1628_: f32;
    var phi_1629_: f32;
    var phi_1630_: f32;
    var phi_1638_: f32;
    var phi_1653_: f32;
    var phi_1654_: bool;
    var phi_1655_: f32;
    var phi_1656_: bool;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1676_: f32;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1679_: f32;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1685_: bool;
    var phi_1686_: f32;
    var phi_1687_: bool;
    var phi_1715_: vec3<f32>;
    var phi_1716_: vec3<f32>;
    var phi_1741_: vec3<f32>;
    var phi_1742_: vec3<f32>;
    var phi_1767_: vec3<f32>;
    var phi_1768_: vec3<f32>;
    var phi_1824_: f32;
    var phi_1833_: f32;
    var phi_1842_: f32;
    var phi_1851_: f32;
    var phi_1858_: f32;
    var phi_1865_: f32;
    var phi_1878_: f32;
    var phi_1887_: f32;
    var phi_1896_: f32;
    var phi_1905_: f32;
    var phi_1912_: f32;
    var phi_1919_: f32;
    var phi_1936_: f32;
    var phi_1941_: f32;
    var phi_1946_: f32;
    var phi_1954_: f32;
    var phi_1959_: f32;
    var phi_1964_: f32;
    var phi_1976_: f32;
    var phi_1981_: f32;
    var phi_1986_: f32;
    var phi_1991_: f32;
    var phi_1996_: lt_bvh_triangle_Intersection;
    var phi_1997_: bool;
    var phi_1998_: lt_bvh_triangle_Intersection;
    var phi_1999_: bool;
    var phi_2003_: lt_bvh_triangle_Intersection;
    var phi_2004_: bool;
    var phi_2005_: lt_bvh_triangle_Intersection;
    var phi_2006_: bool;
    var phi_2007_: bool;
    var phi_2011_: bool;
    var phi_2015_: lt_bvh_triangle_Intersection;
    var phi_2229_: f32;
    var phi_2232_: bool;
    var phi_2233_: bool;
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
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_1447_: u32;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var local_5: bool;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var phi_2330_: u32;
    var phi_2331_: u32;
    var phi_2332_: bool;
    var phi_2333_: bool;
    var phi_1117_: u32;
    var phi_2334_: bool;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var phi_2337_: bool;
    var local_6: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var phi_2346_: bool;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2357_: bool;
    var phi_2361_: f32;
    var phi_2382_: u32;
    var phi_2397_: u32;
    var phi_2402_: u32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&visibility.member));
    let _e85 = arrayLength((&list.member));
    let _e88 = arrayLength((&bits.member));
    let _e91 = arrayLength((&vertices.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e101 = ((_e69.y * 2097152u) + _e69.x);
    if (3u < _e85) {
    } else {
        return;
    }
    let _e104 = list.member[3u];
    if (_e101 < _e104) {
        let _e106 = (_e101 + 4u);
        if (_e106 < _e85) {
        } else {
            return;
        }
        let _e110 = list.member[(0u + _e106)];
        if (_e110 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e115 = p.member.light;
        let _e117 = samples.member[(0u + _e110)].position;
        let _e119 = samples.member[(0u + _e110)].normal;
        let _e121 = samples.member[(0u + _e110)].magnitude;
        let _e123 = ((8f / 8388608f) * _e121);
        let _e131 = (_e117.x + (_e119.x * _e123));
        let _e133 = (_e117.y + (_e119.y * _e123));
        let _e135 = (_e117.z + (_e119.z * _e123));
        if (_e115.w == 0f) {
            phi_677_ = 300000000000000000000000000000000000000f;
        } else {
            phi_677_ = 1f;
        }
        let _e139 = phi_677_;
        let _e147 = (_e115.x - (_e131 * _e115.w));
        let _e148 = (_e115.y - (_e133 * _e115.w));
        let _e149 = (_e115.z - (_e135 * _e115.w));
        let _e154 = abs(_e147);
        let _e155 = abs(_e148);
        let _e156 = abs(_e149);
        if (abs(_e131) < 1000000000000000f) {
            if (abs(_e133) < 1000000000000000f) {
                if (abs(_e135) < 1000000000000000f) {
                    if (_e154 < 1000000000000000f) {
                        if (_e155 < 1000000000000000f) {
                            if (_e156 < 1000000000000000f) {
                                if (_e154 > 0f) {
                                    phi_733_ = bool();
                                    phi_734_ = true;
                                } else {
                                    let _e164 = (_e155 > 0f);
                                    if _e164 {
                                        phi_732_ = bool();
                                    } else {
                                        phi_732_ = (_e156 > 0f);
                                    }
                                    let _e167 = phi_732_;
                                    phi_733_ = _e167;
                                    phi_734_ = _e164;
                                }
                                let _e169 = phi_733_;
                                let _e171 = phi_734_;
                                if _e171 {
                                    phi_738_ = true;
                                } else {
                                    phi_738_ = _e169;
                                }
                                let _e173 = phi_738_;
                                phi_739_ = _e173;
                                phi_740_ = false;
                            } else {
                                phi_739_ = bool();
                                phi_740_ = true;
                            }
                            let _e175 = phi_739_;
                            let _e177 = phi_740_;
                            phi_741_ = _e175;
                            phi_742_ = false;
                            phi_743_ = _e177;
                        } else {
                            phi_741_ = bool();
                            phi_742_ = true;
                            phi_743_ = false;
                        }
                        let _e179 = phi_741_;
                        let _e181 = phi_742_;
                        let _e183 = phi_743_;
                        phi_744_ = _e179;
                        phi_745_ = _e181;
                        phi_746_ = _e183;
                    } else {
                        phi_744_ = bool();
                        phi_745_ = true;
                        phi_746_ = false;
                    }
                    let _e185 = phi_744_;
                    let _e187 = phi_745_;
                    let _e189 = phi_746_;
                    phi_747_ = _e185;
                    phi_748_ = _e187;
                    phi_749_ = _e189;
                } else {
                    phi_747_ = bool();
                    phi_748_ = true;
                    phi_749_ = false;
                }
                let _e191 = phi_747_;
                let _e193 = phi_748_;
                let _e195 = phi_749_;
                phi_750_ = _e191;
                phi_751_ = _e193;
                phi_752_ = _e195;
            } else {
                phi_750_ = bool();
                phi_751_ = true;
                phi_752_ = false;
            }
            let _e197 = phi_750_;
            let _e199 = phi_751_;
            let _e201 = phi_752_;
            phi_753_ = _e197;
            phi_754_ = _e199;
            phi_755_ = _e201;
        } else {
            phi_753_ = bool();
            phi_754_ = true;
            phi_755_ = false;
        }
        let _e203 = phi_753_;
        let _e205 = phi_754_;
        let _e207 = phi_755_;
        if _e205 {
            phi_759_ = true;
        } else {
            phi_759_ = _e207;
        }
        let _e209 = phi_759_;
        if _e209 {
            phi_763_ = false;
        } else {
            phi_763_ = _e203;
        }
        let _e211 = phi_763_;
        if _e211 {
            let _e212 = (0u >= _e76);
            if _e212 {
                phi_2351_ = bool();
            } else {
                if (0u < _e76) {
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
                let _e276 = core_intrinsics_maximum_number_nsz_f32_(abs(_e147), abs(_e148));
                let _e277 = core_intrinsics_maximum_number_nsz_f32_(_e276, abs(_e149));
                let _e278 = (_e277 * 0.0000000000009094947f);
                if (abs(_e147) < _e278) {
                    phi_833_ = _e278;
                } else {
                    phi_833_ = abs(_e147);
                }
                let _e283 = phi_833_;
                if (_e147 < 0f) {
                    phi_840_ = (-1f / _e283);
                } else {
                    phi_840_ = (1f / _e283);
                }
                let _e288 = phi_840_;
                if (abs(_e148) < _e278) {
                    phi_847_ = _e278;
                } else {
                    phi_847_ = abs(_e148);
                }
                let _e293 = phi_847_;
                if (_e148 < 0f) {
                    phi_854_ = (-1f / _e293);
                } else {
                    phi_854_ = (1f / _e293);
                }
                let _e298 = phi_854_;
                if (abs(_e149) < _e278) {
                    phi_861_ = _e278;
                } else {
                    phi_861_ = abs(_e149);
                }
                let _e303 = phi_861_;
                if (_e149 < 0f) {
                    phi_868_ = (-1f / _e303);
                } else {
                    phi_868_ = (1f / _e303);
                }
                let _e308 = phi_868_;
                let _e312 = abs((bitcast<f32>(_e218) - _e131));
                let _e313 = abs((bitcast<f32>(_e222) - _e133));
                let _e314 = abs((bitcast<f32>(_e226) - _e135));
                let _e318 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                let _e319 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e320 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                if (_e312 > _e318) {
                    phi_885_ = _e312;
                } else {
                    phi_885_ = _e318;
                }
                let _e323 = phi_885_;
                if (_e313 > _e319) {
                    phi_890_ = _e313;
                } else {
                    phi_890_ = _e319;
                }
                let _e326 = phi_890_;
                if (_e314 > _e320) {
                    phi_895_ = _e314;
                } else {
                    phi_895_ = _e320;
                }
                let _e329 = phi_895_;
                let _e330 = core_intrinsics_maximum_number_nsz_f32_(_e323, _e326);
                let _e331 = core_intrinsics_maximum_number_nsz_f32_(_e330, _e329);
                let _e335 = (_e331 * 0.0000019073486f);
                let _e336 = (abs(_e288) * _e335);
                let _e337 = (abs(_e298) * _e335);
                let _e338 = (abs(_e308) * _e335);
                let _e342 = (_e331 * 0.0000009536743f);
                let _e343 = (abs(_e288) * _e342);
                let _e344 = (abs(_e298) * _e342);
                let _e345 = (abs(_e308) * _e342);
                let _e346 = abs(_e147);
                let _e347 = abs(_e148);
                let _e348 = abs(_e149);
                if (_e346 >= _e347) {
                    if (_e346 >= _e348) {
                        phi_923_ = false;
                    } else {
                        phi_923_ = true;
                    }
                    let _e352 = phi_923_;
                    phi_924_ = _e352;
                } else {
                    phi_924_ = true;
                }
                let _e354 = phi_924_;
                if _e354 {
                    if (_e347 >= _e348) {
                        phi_932_ = 1u;
                    } else {
                        phi_932_ = 2u;
                    }
                    let _e357 = phi_932_;
                    phi_933_ = _e357;
                } else {
                    phi_933_ = 0u;
                }
                let _e359 = phi_933_;
                if (_e359 == 0u) {
                    phi_945_ = vec3<f32>(_e148, _e149, _e147);
                } else {
                    if (_e359 == 1u) {
                        phi_944_ = vec3<f32>(_e149, _e147, _e148);
                    } else {
                        phi_944_ = vec3<f32>(_e147, _e148, _e149);
                    }
                    let _e365 = phi_944_;
                    phi_945_ = _e365;
                }
                let _e367 = phi_945_;
                let _e370 = (_e367.x / _e367.z);
                let _e373 = (_e367.y / _e367.z);
                if (_e288 < 0f) {
                    phi_958_ = 0u;
                } else {
                    phi_958_ = 1u;
                }
                let _e378 = phi_958_;
                if (_e298 < 0f) {
                    phi_963_ = 0u;
                } else {
                    phi_963_ = 2u;
                }
                let _e381 = phi_963_;
                if (_e308 < 0f) {
                    phi_968_ = 0u;
                } else {
                    phi_968_ = 4u;
                }
                let _e384 = phi_968_;
                let _e386 = ((_e378 | _e381) | _e384);
                let _e387 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e387.first[0], _e387.first[1], _e387.first[2], _e387.first[3], _e387.first[4], _e387.first[5], _e387.first[6], _e387.first[7], _e387.first[8], _e387.first[9], _e387.first[10], _e387.first[11], _e387.first[12], _e387.first[13], _e387.first[14], _e387.first[15], _e387.first[16], _e387.first[17], _e387.first[18], _e387.first[19], _e387.first[20], _e387.first[21], _e387.first[22], _e387.first[23], _e387.first[24], _e387.first[25], _e387.first[26], _e387.first[27], _e387.first[28], _e387.first[29], _e387.first[30], _e387.first[31]), array<u32, 32>(_e387.mask[0], _e387.mask[1], _e387.mask[2], _e387.mask[3], _e387.mask[4], _e387.mask[5], _e387.mask[6], _e387.mask[7], _e387.mask[8], _e387.mask[9], _e387.mask[10], _e387.mask[11], _e387.mask[12], _e387.mask[13], _e387.mask[14], _e387.mask[15], _e387.mask[16], _e387.mask[17], _e387.mask[18], _e387.mask[19], _e387.mask[20], _e387.mask[21], _e387.mask[22], _e387.mask[23], _e387.mask[24], _e387.mask[25], _e387.mask[26], _e387.mask[27], _e387.mask[28], _e387.mask[29], _e387.mask[30], _e387.mask[31]), _e387.len, _e387.group, _e387.group_mask);
                let _e461 = local_1.group_mask;
                if ((_e461 & 4278190080u) == 0u) {
                    let _e465 = local_1.len;
                    if (_e465 == 0u) {
                        phi_1082_ = false;
                    } else {
                        let _e469 = local_1.len;
                        local_1.len = (_e469 - 1u);
                        let _e472 = local_1.len;
                        if (_e472 < 32u) {
                        } else {
                            return;
                        }
                        let _e477 = local_1.first[(0u + _e472)];
                        local_1.group = _e477;
                        let _e480 = local_1.len;
                        if (_e480 < 32u) {
                        } else {
                            return;
                        }
                        let _e485 = local_1.mask[(0u + _e480)];
                        local_1.group_mask = _e485;
                        phi_1082_ = true;
                    }
                    let _e488 = phi_1082_;
                    phi_1083_ = _e488;
                } else {
                    phi_1083_ = true;
                }
                let _e490 = phi_1083_;
                if _e490 {
                    let _e492 = local_1.group_mask;
                    let _e498 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e492)), 32u, (_e492 == 0u)));
                    let _e502 = local_1.group_mask;
                    let _e516 = local_1.group_mask;
                    local_1.group_mask = (_e516 & ~((1u << bitcast<u32>((_e498 & 31u)))));
                    let _e519 = local_1.group;
                    phi_1114_ = (_e519 + countOneBits(((_e502 & ~((4294967295u << bitcast<u32>((((_e498 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1114_ = 4294967295u;
                }
                let _e522 = phi_1114_;
                phi_1116_ = _e522;
                loop {
                    let _e524 = phi_1116_;
                    if (_e524 != 4294967295u) {
                        if (_e524 < _e76) {
                        } else {
                            return;
                        }
                        let _e531 = nodes.member[(0u + _e524)].frame[3u];
                        let _e556 = (bitcast<f32>((((_e531 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e288);
                        let _e557 = (bitcast<f32>((((_e531 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e298);
                        let _e558 = (bitcast<f32>((((_e531 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e561 = nodes.member[(0u + _e524)].frame[0u];
                        let _e565 = nodes.member[(0u + _e524)].frame[1u];
                        let _e569 = nodes.member[(0u + _e524)].frame[2u];
                        let _e574 = ((bitcast<f32>(_e561) - _e131) * _e288);
                        let _e575 = ((bitcast<f32>(_e565) - _e133) * _e298);
                        let _e576 = ((bitcast<f32>(_e569) - _e135) * _e308);
                        let _e584 = nodes.member[(0u + _e524)].x;
                        if (_e288 < 0f) {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e595.unnamed.root, _e584.w), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_bvh_traverse_Tree(_e584.x, _e601.unnamed_1.first_primitive));
                            phi_1197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e607.unnamed_1.root, _e584.y));
                        } else {
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.unnamed.root, _e584.y), _e623.unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e584.z, _e629.unnamed_1.first_primitive));
                            phi_1197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_bvh_traverse_Tree(_e635.unnamed_1.root, _e584.w));
                        }
                        let _e643 = phi_1197_;
                        let _e653 = nodes.member[(0u + _e524)].y;
                        if (_e298 < 0f) {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e664.unnamed.root, _e653.w), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_bvh_traverse_Tree(_e653.x, _e670.unnamed_1.first_primitive));
                            phi_1224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e676.unnamed_1.root, _e653.y));
                        } else {
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.unnamed.root, _e653.y), _e692.unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e653.z, _e698.unnamed_1.first_primitive));
                            phi_1224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_bvh_traverse_Tree(_e704.unnamed_1.root, _e653.w));
                        }
                        let _e712 = phi_1224_;
                        let _e722 = nodes.member[(0u + _e524)].z;
                        if (_e308 < 0f) {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e733.unnamed.root, _e722.w), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e722.x, _e739.unnamed_1.first_primitive));
                            phi_1251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e745.unnamed_1.root, _e722.y));
                        } else {
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e761.unnamed.root, _e722.y), _e761.unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e722.z, _e767.unnamed_1.first_primitive));
                            phi_1251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_bvh_traverse_Tree(_e773.unnamed_1.root, _e722.w));
                        }
                        let _e781 = phi_1251_;
                        phi_1257_ = 0u;
                        phi_1260_ = 0u;
                        loop {
                            let _e791 = phi_1257_;
                            let _e793 = phi_1260_;
                            local_2 = _e793;
                            local_3 = _e793;
                            local_4 = _e793;
                            let _e794 = (_e791 < 8u);
                            if _e794 {
                                let _e796 = (_e791 >> bitcast<u32>(2i));
                                let _e797 = (_e791 & 3u);
                                if (_e796 == 0u) {
                                    phi_1274_ = _e643.unnamed.root;
                                } else {
                                    phi_1274_ = _e643.unnamed.first_primitive;
                                }
                                let _e800 = phi_1274_;
                                if (_e796 == 0u) {
                                    phi_1284_ = _e712.unnamed.root;
                                } else {
                                    phi_1284_ = _e712.unnamed.first_primitive;
                                }
                                let _e809 = phi_1284_;
                                if (_e796 == 0u) {
                                    phi_1294_ = _e781.unnamed.root;
                                } else {
                                    phi_1294_ = _e781.unnamed.first_primitive;
                                }
                                let _e818 = phi_1294_;
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e800 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 - _e336)), ((f32(((_e809 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e337)));
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(_e831, ((f32(((_e818 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e338)));
                                if (_e796 == 0u) {
                                    phi_1312_ = _e643.unnamed_1.root;
                                } else {
                                    phi_1312_ = _e643.unnamed_1.first_primitive;
                                }
                                let _e835 = phi_1312_;
                                if (_e796 == 0u) {
                                    phi_1322_ = _e712.unnamed_1.root;
                                } else {
                                    phi_1322_ = _e712.unnamed_1.first_primitive;
                                }
                                let _e844 = phi_1322_;
                                if (_e796 == 0u) {
                                    phi_1332_ = _e781.unnamed_1.root;
                                } else {
                                    phi_1332_ = _e781.unnamed_1.first_primitive;
                                }
                                let _e853 = phi_1332_;
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 + _e336)), ((f32(((_e844 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e337)));
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e338)));
                                if (_e832 <= _e867) {
                                    if (_e832 <= _e139) {
                                        if (_e867 >= 0f) {
                                            if (_e796 == 0u) {
                                                let _e874 = nodes.member[(0u + _e524)].links[2u];
                                                phi_1368_ = _e874;
                                            } else {
                                                let _e877 = nodes.member[(0u + _e524)].links[3u];
                                                phi_1368_ = _e877;
                                            }
                                            let _e879 = phi_1368_;
                                            let _e884 = ((_e879 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u);
                                            let _e885 = (_e884 & 31u);
                                            if (_e885 >= 24u) {
                                                phi_1381_ = (24u + ((_e885 - 24u) ^ _e386));
                                            } else {
                                                phi_1381_ = _e885;
                                            }
                                            let _e891 = phi_1381_;
                                            phi_1386_ = (_e793 | ((_e884 >> bitcast<u32>(5i)) << bitcast<u32>((_e891 & 31u))));
                                        } else {
                                            phi_1386_ = _e793;
                                        }
                                        let _e899 = phi_1386_;
                                        phi_1387_ = _e899;
                                    } else {
                                        phi_1387_ = _e793;
                                    }
                                    let _e901 = phi_1387_;
                                    phi_1388_ = _e901;
                                } else {
                                    phi_1388_ = _e793;
                                }
                                let _e903 = phi_1388_;
                                phi_1258_ = (_e791 + 1u);
                                phi_1261_ = _e903;
                            } else {
                                phi_1258_ = u32();
                                phi_1261_ = u32();
                            }
                            let _e906 = phi_1258_;
                            let _e908 = phi_1261_;
                            continue;
                            continuing {
                                phi_1257_ = _e906;
                                phi_1260_ = _e908;
                                break if !(_e794);
                            }
                        }
                        let _e912 = nodes.member[(0u + _e524)].links[0u];
                        let _e916 = nodes.member[(0u + _e524)].frame[3u];
                        let _e920 = local_2;
                        if ((_e920 & 4278190080u) == 0u) {
                        } else {
                            let _e924 = local_1.group_mask;
                            if ((_e924 & 4278190080u) == 0u) {
                            } else {
                                let _e928 = local_1.len;
                                if (_e928 < 32u) {
                                    let _e931 = local_1.group;
                                    let _e933 = local_1.len;
                                    if (_e933 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e933)] = _e931;
                                    let _e939 = local_1.group_mask;
                                    let _e941 = local_1.len;
                                    if (_e941 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e941)] = _e939;
                                    let _e948 = local_1.len;
                                    local_1.len = (_e948 + 1u);
                                }
                            }
                            local_1.group = (0u + _e912);
                            let _e952 = local_3;
                            local_1.group_mask = ((_e952 & 4278190080u) | (_e916 >> bitcast<u32>(24i)));
                        }
                        let _e957 = local_4;
                        phi_1446_ = (_e957 & 16777215u);
                        loop {
                            let _e960 = phi_1446_;
                            let _e961 = (_e960 == 0u);
                            local_5 = _e961;
                            local_9 = _e961;
                            if _e961 {
                                phi_1447_ = u32();
                                phi_2254_ = false;
                                phi_2255_ = false;
                                phi_2256_ = false;
                            } else {
                                let _e964 = nodes.member[(0u + _e524)].links[1u];
                                let _e969 = ((0u + _e964) + select(firstTrailingBit(_e960), 32u, (_e960 == 0u)));
                                if (_e969 < _e79) {
                                } else {
                                    return;
                                }
                                let _e976 = triangles.member[(0u + _e969)].v0_;
                                let _e978 = (_e976.x - _e131);
                                let _e980 = (_e976.y - _e133);
                                let _e982 = (_e976.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1492_ = vec3<f32>(_e980, _e982, _e978);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1491_ = vec3<f32>(_e982, _e978, _e980);
                                    } else {
                                        phi_1491_ = (_e976 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e990 = phi_1491_;
                                    phi_1492_ = _e990;
                                }
                                let _e992 = phi_1492_;
                                let _e996 = (_e992.x - (_e370 * _e992.z));
                                let _e1000 = (_e992.y - (_e373 * _e992.z));
                                let _e1002 = triangles.member[(0u + _e969)].v1_;
                                let _e1004 = (_e1002.x - _e131);
                                let _e1006 = (_e1002.y - _e133);
                                let _e1008 = (_e1002.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1522_ = vec3<f32>(_e1006, _e1008, _e1004);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1521_ = vec3<f32>(_e1008, _e1004, _e1006);
                                    } else {
                                        phi_1521_ = (_e1002 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1016 = phi_1521_;
                                    phi_1522_ = _e1016;
                                }
                                let _e1018 = phi_1522_;
                                let _e1022 = (_e1018.x - (_e370 * _e1018.z));
                                let _e1026 = (_e1018.y - (_e373 * _e1018.z));
                                let _e1028 = triangles.member[(0u + _e969)].v2_;
                                let _e1030 = (_e1028.x - _e131);
                                let _e1032 = (_e1028.y - _e133);
                                let _e1034 = (_e1028.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1552_ = vec3<f32>(_e1032, _e1034, _e1030);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1551_ = vec3<f32>(_e1034, _e1030, _e1032);
                                    } else {
                                        phi_1551_ = (_e1028 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1042 = phi_1551_;
                                    phi_1552_ = _e1042;
                                }
                                let _e1044 = phi_1552_;
                                let _e1048 = (_e1044.x - (_e370 * _e1044.z));
                                let _e1052 = (_e1044.y - (_e373 * _e1044.z));
                                if (_e1022 < _e1048) {
                                    phi_1571_ = true;
                                } else {
                                    if (_e1022 == _e1048) {
                                        phi_1570_ = (_e1026 < _e1052);
                                    } else {
                                        phi_1570_ = false;
                                    }
                                    let _e1057 = phi_1570_;
                                    phi_1571_ = _e1057;
                                }
                                let _e1059 = phi_1571_;
                                if _e1059 {
                                    phi_1575_ = _e1052;
                                    phi_1576_ = _e1048;
                                    phi_1577_ = _e1026;
                                    phi_1578_ = _e1022;
                                } else {
                                    phi_1575_ = _e1026;
                                    phi_1576_ = _e1022;
                                    phi_1577_ = _e1052;
                                    phi_1578_ = _e1048;
                                }
                                let _e1061 = phi_1575_;
                                let _e1063 = phi_1576_;
                                let _e1065 = phi_1577_;
                                let _e1067 = phi_1578_;
                                let _e1070 = ((_e1067 * _e1061) - (_e1065 * _e1063));
                                if _e1059 {
                                    phi_1586_ = -(_e1070);
                                } else {
                                    phi_1586_ = _e1070;
                                }
                                let _e1073 = phi_1586_;
                                if (_e1048 < _e996) {
                                    phi_1597_ = true;
                                } else {
                                    if (_e1048 == _e996) {
                                        phi_1596_ = (_e1052 < _e1000);
                                    } else {
                                        phi_1596_ = false;
                                    }
                                    let _e1078 = phi_1596_;
                                    phi_1597_ = _e1078;
                                }
                                let _e1080 = phi_1597_;
                                if _e1080 {
                                    phi_1601_ = _e1000;
                                    phi_1602_ = _e996;
                                    phi_1603_ = _e1052;
                                    phi_1604_ = _e1048;
                                } else {
                                    phi_1601_ = _e1052;
                                    phi_1602_ = _e1048;
                                    phi_1603_ = _e1000;
                                    phi_1604_ = _e996;
                                }
                                let _e1082 = phi_1601_;
                                let _e1084 = phi_1602_;
                                let _e1086 = phi_1603_;
                                let _e1088 = phi_1604_;
                                let _e1091 = ((_e1088 * _e1082) - (_e1086 * _e1084));
                                if _e1080 {
                                    phi_1612_ = -(_e1091);
                                } else {
                                    phi_1612_ = _e1091;
                                }
                                let _e1094 = phi_1612_;
                                if (_e996 < _e1022) {
                                    phi_1623_ = true;
                                } else {
                                    if (_e996 == _e1022) {
                                        phi_1622_ = (_e1000 < _e1026);
                                    } else {
                                        phi_1622_ = false;
                                    }
                                    let _e1099 = phi_1622_;
                                    phi_1623_ = _e1099;
                                }
                                let _e1101 = phi_1623_;
                                if _e1101 {
                                    phi_1627_ = _e1026;
                                    phi_1628_ = _e1022;
                                    phi_1629_ = _e1000;
                                    phi_1630_ = _e996;
                                } else {
                                    phi_1627_ = _e1000;
                                    phi_1628_ = _e996;
                                    phi_1629_ = _e1026;
                                    phi_1630_ = _e1022;
                                }
                                let _e1103 = phi_1627_;
                                let _e1105 = phi_1628_;
                                let _e1107 = phi_1629_;
                                let _e1109 = phi_1630_;
                                let _e1112 = ((_e1109 * _e1103) - (_e1107 * _e1105));
                                if _e1101 {
                                    phi_1638_ = -(_e1112);
                                } else {
                                    phi_1638_ = _e1112;
                                }
                                let _e1115 = phi_1638_;
                                if (_e1073 >= 0f) {
                                    if (_e1094 >= 0f) {
                                        if (_e1115 >= 0f) {
                                            phi_1653_ = ((_e1073 + _e1094) + _e1115);
                                            phi_1654_ = false;
                                        } else {
                                            phi_1653_ = f32();
                                            phi_1654_ = true;
                                        }
                                        let _e1122 = phi_1653_;
                                        let _e1124 = phi_1654_;
                                        phi_1655_ = _e1122;
                                        phi_1656_ = _e1124;
                                    } else {
                                        phi_1655_ = f32();
                                        phi_1656_ = true;
                                    }
                                    let _e1126 = phi_1655_;
                                    let _e1128 = phi_1656_;
                                    phi_1657_ = _e1126;
                                    phi_1658_ = _e1128;
                                } else {
                                    phi_1657_ = f32();
                                    phi_1658_ = true;
                                }
                                let _e1130 = phi_1657_;
                                let _e1132 = phi_1658_;
                                if _e1132 {
                                    if (_e1073 <= 0f) {
                                        if (_e1094 <= 0f) {
                                            let _e1135 = (_e1115 <= 0f);
                                            if _e1135 {
                                            }
                                            phi_1676_ = ((_e1073 + _e1094) + _e1115);
                                            phi_1677_ = false;
                                            phi_1678_ = _e1135;
                                        } else {
                                            phi_1676_ = f32();
                                            phi_1677_ = true;
                                            phi_1678_ = false;
                                        }
                                        let _e1139 = phi_1676_;
                                        let _e1141 = phi_1677_;
                                        let _e1143 = phi_1678_;
                                        phi_1679_ = _e1139;
                                        phi_1680_ = _e1141;
                                        phi_1681_ = _e1143;
                                    } else {
                                        phi_1679_ = f32();
                                        phi_1680_ = true;
                                        phi_1681_ = false;
                                    }
                                    let _e1145 = phi_1679_;
                                    let _e1147 = phi_1680_;
                                    let _e1149 = phi_1681_;
                                    if _e1147 {
                                        phi_1685_ = false;
                                    } else {
                                        phi_1685_ = _e1149;
                                    }
                                    let _e1151 = phi_1685_;
                                    phi_1686_ = _e1145;
                                    phi_1687_ = _e1151;
                                } else {
                                    phi_1686_ = _e1130;
                                    phi_1687_ = true;
                                }
                                let _e1153 = phi_1686_;
                                let _e1155 = phi_1687_;
                                if _e1155 {
                                    let _e1156 = (_e1153 == 0f);
                                    if _e1156 {
                                        phi_2003_ = lt_bvh_triangle_Intersection();
                                        phi_2004_ = false;
                                    } else {
                                        let _e1158 = triangles.member[(0u + _e969)].v0_;
                                        let _e1160 = (_e1158.x - _e131);
                                        let _e1162 = (_e1158.y - _e133);
                                        let _e1164 = (_e1158.z - _e135);
                                        if (_e359 == 0u) {
                                            phi_1716_ = vec3<f32>(_e1162, _e1164, _e1160);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1715_ = vec3<f32>(_e1164, _e1160, _e1162);
                                            } else {
                                                phi_1715_ = (_e1158 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1172 = phi_1715_;
                                            phi_1716_ = _e1172;
                                        }
                                        let _e1174 = phi_1716_;
                                        let _e1176 = triangles.member[(0u + _e969)].v1_;
                                        let _e1178 = triangles.member[(0u + _e969)].v0_;
                                        let _e1181 = (_e1176.x - _e1178.x);
                                        let _e1184 = (_e1176.y - _e1178.y);
                                        let _e1187 = (_e1176.z - _e1178.z);
                                        if (_e359 == 0u) {
                                            phi_1742_ = vec3<f32>(_e1184, _e1187, _e1181);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1741_ = vec3<f32>(_e1187, _e1181, _e1184);
                                            } else {
                                                phi_1741_ = (_e1176 - _e1178);
                                            }
                                            let _e1194 = phi_1741_;
                                            phi_1742_ = _e1194;
                                        }
                                        let _e1196 = phi_1742_;
                                        let _e1198 = triangles.member[(0u + _e969)].v2_;
                                        let _e1200 = triangles.member[(0u + _e969)].v0_;
                                        let _e1203 = (_e1198.x - _e1200.x);
                                        let _e1206 = (_e1198.y - _e1200.y);
                                        let _e1209 = (_e1198.z - _e1200.z);
                                        if (_e359 == 0u) {
                                            phi_1768_ = vec3<f32>(_e1206, _e1209, _e1203);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1767_ = vec3<f32>(_e1209, _e1203, _e1206);
                                            } else {
                                                phi_1767_ = (_e1198 - _e1200);
                                            }
                                            let _e1216 = phi_1767_;
                                            phi_1768_ = _e1216;
                                        }
                                        let _e1218 = phi_1768_;
                                        let _e1225 = ((_e1196.y * _e1218.z) - (_e1196.z * _e1218.y));
                                        let _e1232 = ((_e1196.z * _e1218.x) - (_e1196.x * _e1218.z));
                                        let _e1239 = ((_e1196.x * _e1218.y) - (_e1196.y * _e1218.x));
                                        let _e1253 = (((1f / _e367.z) * (((_e1225 * _e1174.x) + (_e1232 * _e1174.y)) + (_e1239 * _e1174.z))) / (((_e1225 * _e370) + (_e1232 * _e373)) + _e1239));
                                        if (_e1253 > 0f) {
                                            if (_e1253 < _e139) {
                                                let _e1257 = triangles.member[(0u + _e969)].v0_;
                                                let _e1259 = triangles.member[(0u + _e969)].v1_;
                                                if (_e1257.x < _e1259.x) {
                                                    phi_1824_ = _e1257.x;
                                                } else {
                                                    phi_1824_ = _e1259.x;
                                                }
                                                let _e1266 = phi_1824_;
                                                if (_e1257.y < _e1259.y) {
                                                    phi_1833_ = _e1257.y;
                                                } else {
                                                    phi_1833_ = _e1259.y;
                                                }
                                                let _e1273 = phi_1833_;
                                                if (_e1257.z < _e1259.z) {
                                                    phi_1842_ = _e1257.z;
                                                } else {
                                                    phi_1842_ = _e1259.z;
                                                }
                                                let _e1280 = phi_1842_;
                                                let _e1282 = triangles.member[(0u + _e969)].v2_;
                                                if (_e1266 < _e1282.x) {
                                                    phi_1851_ = _e1266;
                                                } else {
                                                    phi_1851_ = _e1282.x;
                                                }
                                                let _e1287 = phi_1851_;
                                                if (_e1273 < _e1282.y) {
                                                    phi_1858_ = _e1273;
                                                } else {
                                                    phi_1858_ = _e1282.y;
                                                }
                                                let _e1292 = phi_1858_;
                                                if (_e1280 < _e1282.z) {
                                                    phi_1865_ = _e1280;
                                                } else {
                                                    phi_1865_ = _e1282.z;
                                                }
                                                let _e1297 = phi_1865_;
                                                let _e1299 = triangles.member[(0u + _e969)].v0_;
                                                let _e1301 = triangles.member[(0u + _e969)].v1_;
                                                if (_e1299.x > _e1301.x) {
                                                    phi_1878_ = _e1299.x;
                                                } else {
                                                    phi_1878_ = _e1301.x;
                                                }
                                                let _e1308 = phi_1878_;
                                                if (_e1299.y > _e1301.y) {
                                                    phi_1887_ = _e1299.y;
                                                } else {
                                                    phi_1887_ = _e1301.y;
                                                }
                                                let _e1315 = phi_1887_;
                                                if (_e1299.z > _e1301.z) {
                                                    phi_1896_ = _e1299.z;
                                                } else {
                                                    phi_1896_ = _e1301.z;
                                                }
                                                let _e1322 = phi_1896_;
                                                let _e1324 = triangles.member[(0u + _e969)].v2_;
                                                if (_e1308 > _e1324.x) {
                                                    phi_1905_ = _e1308;
                                                } else {
                                                    phi_1905_ = _e1324.x;
                                                }
                                                let _e1329 = phi_1905_;
                                                if (_e1315 > _e1324.y) {
                                                    phi_1912_ = _e1315;
                                                } else {
                                                    phi_1912_ = _e1324.y;
                                                }
                                                let _e1334 = phi_1912_;
                                                if (_e1322 > _e1324.z) {
                                                    phi_1919_ = _e1322;
                                                } else {
                                                    phi_1919_ = _e1324.z;
                                                }
                                                let _e1339 = phi_1919_;
                                                let _e1343 = ((_e1287 - _e131) * _e288);
                                                let _e1344 = ((_e1292 - _e133) * _e298);
                                                let _e1345 = ((_e1297 - _e135) * _e308);
                                                let _e1349 = ((_e1329 - _e131) * _e288);
                                                let _e1350 = ((_e1334 - _e133) * _e298);
                                                let _e1351 = ((_e1339 - _e135) * _e308);
                                                if (_e1343 < _e1349) {
                                                    phi_1936_ = _e1343;
                                                } else {
                                                    phi_1936_ = _e1349;
                                                }
                                                let _e1354 = phi_1936_;
                                                if (_e1344 < _e1350) {
                                                    phi_1941_ = _e1344;
                                                } else {
                                                    phi_1941_ = _e1350;
                                                }
                                                let _e1357 = phi_1941_;
                                                if (_e1345 < _e1351) {
                                                    phi_1946_ = _e1345;
                                                } else {
                                                    phi_1946_ = _e1351;
                                                }
                                                let _e1360 = phi_1946_;
                                                if (_e1343 > _e1349) {
                                                    phi_1954_ = _e1343;
                                                } else {
                                                    phi_1954_ = _e1349;
                                                }
                                                let _e1366 = phi_1954_;
                                                if (_e1344 > _e1350) {
                                                    phi_1959_ = _e1344;
                                                } else {
                                                    phi_1959_ = _e1350;
                                                }
                                                let _e1369 = phi_1959_;
                                                if (_e1345 > _e1351) {
                                                    phi_1964_ = _e1345;
                                                } else {
                                                    phi_1964_ = _e1351;
                                                }
                                                let _e1372 = phi_1964_;
                                                let _e1376 = core_intrinsics_maximum_number_nsz_f32_((_e1354 - _e343), (_e1357 - _e344));
                                                let _e1377 = core_intrinsics_maximum_number_nsz_f32_(_e1376, (_e1360 - _e345));
                                                let _e1378 = core_intrinsics_minimum_number_nsz_f32_((_e1366 + _e343), (_e1369 + _e344));
                                                let _e1379 = core_intrinsics_minimum_number_nsz_f32_(_e1378, (_e1372 + _e345));
                                                if (_e1377 > -300000000000000000000000000000000000000f) {
                                                    phi_1976_ = _e1377;
                                                } else {
                                                    phi_1976_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1382 = phi_1976_;
                                                if (_e1379 < 300000000000000000000000000000000000000f) {
                                                    phi_1981_ = _e1379;
                                                } else {
                                                    phi_1981_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1385 = phi_1981_;
                                                if (_e1253 < _e1382) {
                                                    phi_1986_ = _e1382;
                                                } else {
                                                    phi_1986_ = _e1253;
                                                }
                                                let _e1388 = phi_1986_;
                                                if (_e1388 > _e1385) {
                                                    phi_1991_ = _e1385;
                                                } else {
                                                    phi_1991_ = _e1388;
                                                }
                                                let _e1391 = phi_1991_;
                                                phi_1996_ = lt_bvh_triangle_Intersection(_e1391, (_e1094 / _e1153), (_e1115 / _e1153), (_e1382 <= _e1385));
                                                phi_1997_ = false;
                                            } else {
                                                phi_1996_ = lt_bvh_triangle_Intersection();
                                                phi_1997_ = true;
                                            }
                                            let _e1397 = phi_1996_;
                                            let _e1399 = phi_1997_;
                                            phi_1998_ = _e1397;
                                            phi_1999_ = _e1399;
                                        } else {
                                            phi_1998_ = lt_bvh_triangle_Intersection();
                                            phi_1999_ = true;
                                        }
                                        let _e1401 = phi_1998_;
                                        let _e1403 = phi_1999_;
                                        if _e1403 {
                                        }
                                        phi_2003_ = _e1401;
                                        phi_2004_ = _e1403;
                                    }
                                    let _e1405 = phi_2003_;
                                    let _e1407 = phi_2004_;
                                    phi_2005_ = _e1405;
                                    phi_2006_ = _e1156;
                                    phi_2007_ = _e1407;
                                } else {
                                    phi_2005_ = lt_bvh_triangle_Intersection();
                                    phi_2006_ = true;
                                    phi_2007_ = false;
                                }
                                let _e1409 = phi_2005_;
                                let _e1411 = phi_2006_;
                                let _e1413 = phi_2007_;
                                if _e1411 {
                                    phi_2011_ = true;
                                } else {
                                    phi_2011_ = _e1413;
                                }
                                let _e1415 = phi_2011_;
                                if _e1415 {
                                    phi_2015_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2015_ = _e1409;
                                }
                                let _e1417 = phi_2015_;
                                if _e1417.is_hit {
                                    if (_e1417.t > 0f) {
                                        if (_e1417.t < _e139) {
                                            let _e1424 = triangles.member[(0u + _e969)].i0_;
                                            let _e1426 = ((_e1424 & 2147483648u) == 0u);
                                            if _e1426 {
                                                phi_2238_ = false;
                                                phi_2239_ = false;
                                            } else {
                                                if (_e969 < _e79) {
                                                } else {
                                                    return;
                                                }
                                                let _e1433 = triangles.member[(0u + _e969)].i0_;
                                                let _e1434 = (_e1433 & 2147483647u);
                                                let _e1436 = triangles.member[(0u + _e969)].i1_;
                                                let _e1438 = triangles.member[(0u + _e969)].i2_;
                                                if (_e1434 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1442 = vertices.member[(0u + _e1434)];
                                                if (_e1436 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1446 = vertices.member[(0u + _e1436)];
                                                if (_e1438 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1450 = vertices.member[(0u + _e1438)];
                                                let _e1451 = array<abi_Vertex, 3>(_e1442, _e1446, _e1450);
                                                if (_e1451[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1457 = materials.member[(0u + _e1451[0].material)];
                                                if ((_e1457.flags & 1u) == 1u) {
                                                    let _e1462 = ((1f - _e1417.u) - _e1417.v);
                                                    if (_e1457.cutoff <= 0f) {
                                                        phi_2232_ = true;
                                                    } else {
                                                        let _e1489 = (_e1457.base_color.w * ((((f32((_e1451[0].color >> bitcast<u32>(24i))) * _e1462) + (f32((_e1451[1].color >> bitcast<u32>(24i))) * _e1417.u)) + (f32((_e1451[2].color >> bitcast<u32>(24i))) * _e1417.v)) * (1f / 255f)));
                                                        if (_e1457.alpha_size == 0u) {
                                                            phi_2229_ = _e1489;
                                                        } else {
                                                            local.offset = _e1457.alpha_offset;
                                                            local.size = _e1457.alpha_size;
                                                            local.flags = _e1457.flags;
                                                            let _e1520 = _lt_shaders_texture_TextureView_quad((&local), (((_e1451[0].u * _e1462) + (_e1451[1].u * _e1417.u)) + (_e1451[2].u * _e1417.v)), (((_e1451[0].v * _e1462) + (_e1451[1].v * _e1417.u)) + (_e1451[2].v * _e1417.v)));
                                                            let _e1524 = (_e1520.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1524 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = alpha_texels.member[(0u + _e1524)];
                                                            let _e1544 = (_e1520.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1544 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1548 = alpha_texels.member[(0u + _e1544)];
                                                            let _e1565 = (_e1520.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1565 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1569 = alpha_texels.member[(0u + _e1565)];
                                                            let _e1586 = (_e1520.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1586 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1590 = alpha_texels.member[(0u + _e1586)];
                                                            phi_2229_ = (_e1489 * (((((f32(((_e1528 >> bitcast<u32>((((_e1520.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.x) + ((f32(((_e1548 >> bitcast<u32>((((_e1520.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.y)) + ((f32(((_e1569 >> bitcast<u32>((((_e1520.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.z)) + ((f32(((_e1590 >> bitcast<u32>((((_e1520.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.w)));
                                                        }
                                                        let _e1606 = phi_2229_;
                                                        phi_2232_ = (_e1606 >= _e1457.cutoff);
                                                    }
                                                    let _e1610 = phi_2232_;
                                                    phi_2233_ = _e1610;
                                                } else {
                                                    phi_2233_ = false;
                                                }
                                                let _e1612 = phi_2233_;
                                                if _e1612 {
                                                    phi_2237_ = false;
                                                } else {
                                                    phi_2237_ = true;
                                                }
                                                let _e1614 = phi_2237_;
                                                phi_2238_ = _e1614;
                                                phi_2239_ = _e1612;
                                            }
                                            let _e1616 = phi_2238_;
                                            let _e1618 = phi_2239_;
                                            phi_2240_ = _e1616;
                                            phi_2241_ = _e1426;
                                            phi_2242_ = _e1618;
                                        } else {
                                            phi_2240_ = true;
                                            phi_2241_ = false;
                                            phi_2242_ = false;
                                        }
                                        let _e1620 = phi_2240_;
                                        let _e1622 = phi_2241_;
                                        let _e1624 = phi_2242_;
                                        phi_2243_ = _e1620;
                                        phi_2244_ = _e1622;
                                        phi_2245_ = _e1624;
                                    } else {
                                        phi_2243_ = true;
                                        phi_2244_ = false;
                                        phi_2245_ = false;
                                    }
                                    let _e1626 = phi_2243_;
                                    let _e1628 = phi_2244_;
                                    let _e1630 = phi_2245_;
                                    phi_2246_ = _e1626;
                                    phi_2247_ = _e1628;
                                    phi_2248_ = _e1630;
                                } else {
                                    phi_2246_ = true;
                                    phi_2247_ = false;
                                    phi_2248_ = false;
                                }
                                let _e1632 = phi_2246_;
                                let _e1634 = phi_2247_;
                                let _e1636 = phi_2248_;
                                if _e1632 {
                                    phi_2252_ = false;
                                    phi_2253_ = false;
                                } else {
                                    phi_2252_ = _e1634;
                                    phi_2253_ = _e1636;
                                }
                                let _e1638 = phi_2252_;
                                let _e1640 = phi_2253_;
                                phi_1447_ = (_e960 & (_e960 - 1u));
                                phi_2254_ = _e1632;
                                phi_2255_ = _e1638;
                                phi_2256_ = _e1640;
                            }
                            let _e1642 = phi_1447_;
                            let _e1644 = phi_2254_;
                            let _e1646 = phi_2255_;
                            let _e1648 = phi_2256_;
                            local_7 = _e1646;
                            local_8 = _e1648;
                            continue;
                            continuing {
                                phi_1446_ = _e1642;
                                break if !(_e1644);
                            }
                        }
                        let _e1651 = local_5;
                        if _e1651 {
                            let _e1653 = local_1.group_mask;
                            if ((_e1653 & 4278190080u) == 0u) {
                                let _e1657 = local_1.len;
                                if (_e1657 == 0u) {
                                    phi_2298_ = false;
                                } else {
                                    let _e1661 = local_1.len;
                                    local_1.len = (_e1661 - 1u);
                                    let _e1664 = local_1.len;
                                    if (_e1664 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1669 = local_1.first[(0u + _e1664)];
                                    local_1.group = _e1669;
                                    let _e1672 = local_1.len;
                                    if (_e1672 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1677 = local_1.mask[(0u + _e1672)];
                                    local_1.group_mask = _e1677;
                                    phi_2298_ = true;
                                }
                                let _e1680 = phi_2298_;
                                phi_2299_ = _e1680;
                            } else {
                                phi_2299_ = true;
                            }
                            let _e1682 = phi_2299_;
                            if _e1682 {
                                let _e1684 = local_1.group_mask;
                                let _e1690 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1684)), 32u, (_e1684 == 0u)));
                                let _e1694 = local_1.group_mask;
                                let _e1708 = local_1.group_mask;
                                local_1.group_mask = (_e1708 & ~((1u << bitcast<u32>((_e1690 & 31u)))));
                                let _e1711 = local_1.group;
                                phi_2330_ = (_e1711 + countOneBits(((_e1694 & ~((4294967295u << bitcast<u32>((((_e1690 - 24u) ^ _e386) & 31u))))) & 255u)));
                            } else {
                                phi_2330_ = 4294967295u;
                            }
                            let _e1714 = phi_2330_;
                            phi_2331_ = _e1714;
                            phi_2332_ = false;
                            phi_2333_ = false;
                        } else {
                            phi_2331_ = u32();
                            let _e1958 = local_7;
                            phi_2332_ = _e1958;
                            let _e1961 = local_8;
                            phi_2333_ = _e1961;
                        }
                        let _e1716 = phi_2331_;
                        let _e1718 = phi_2332_;
                        let _e1720 = phi_2333_;
                        phi_1117_ = _e1716;
                        let _e1965 = local_9;
                        phi_2334_ = _e1965;
                        phi_2335_ = false;
                        phi_2336_ = _e1718;
                        phi_2337_ = _e1720;
                    } else {
                        phi_1117_ = u32();
                        phi_2334_ = false;
                        phi_2335_ = true;
                        phi_2336_ = false;
                        phi_2337_ = false;
                    }
                    let _e1722 = phi_1117_;
                    let _e1724 = phi_2334_;
                    let _e1726 = phi_2335_;
                    let _e1728 = phi_2336_;
                    let _e1730 = phi_2337_;
                    local_6 = _e1726;
                    local_10 = _e1728;
                    local_11 = _e1730;
                    continue;
                    continuing {
                        phi_1116_ = _e1722;
                        break if !(_e1724);
                    }
                }
                let _e1733 = local_6;
                if _e1733 {
                    phi_2341_ = false;
                    phi_2342_ = false;
                } else {
                    let _e1972 = local_10;
                    phi_2341_ = _e1972;
                    let _e1975 = local_11;
                    phi_2342_ = _e1975;
                }
                let _e1735 = phi_2341_;
                let _e1737 = phi_2342_;
                if _e1735 {
                    phi_2346_ = true;
                } else {
                    phi_2346_ = _e1737;
                }
                let _e1739 = phi_2346_;
                if _e1739 {
                    phi_2350_ = true;
                } else {
                    phi_2350_ = false;
                }
                let _e1741 = phi_2350_;
                phi_2351_ = _e1741;
            }
            let _e1743 = phi_2351_;
            phi_2352_ = _e1743;
            phi_2353_ = _e212;
        } else {
            phi_2352_ = bool();
            phi_2353_ = true;
        }
        let _e1745 = phi_2352_;
        let _e1747 = phi_2353_;
        if _e1747 {
            phi_2357_ = false;
        } else {
            phi_2357_ = _e1745;
        }
        let _e1749 = phi_2357_;
        if _e1749 {
            phi_2361_ = 0f;
        } else {
            phi_2361_ = 1f;
        }
        let _e1751 = phi_2361_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e1751;
        if (_e110 < _e88) {
        } else {
            return;
        }
        let _e1758 = bits.member[(0u + _e110)];
        if ((_e1758 & 2u) == 0u) {
            phi_2382_ = (_e1758 & 1u);
        } else {
            phi_2382_ = (_e1758 & 7u);
        }
        let _e1764 = phi_2382_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        let _e1768 = visibility.member[(0u + _e110)];
        if ((_e1764 & 1u) != 0u) {
            phi_2397_ = (2u | 1u);
        } else {
            phi_2397_ = 2u;
        }
        let _e1774 = phi_2397_;
        if (_e1768 < 0.5f) {
            phi_2402_ = (_e1774 | 4u);
        } else {
            phi_2402_ = _e1774;
        }
        let _e1777 = phi_2402_;
        if (_e110 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e110)] = _e1777;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
