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

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_35 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_39 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_43 {
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
    transmission: f32,
    pad: u32,
}

struct type_47 {
    member: array<abi_Material>,
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

struct texture_TexelQuad {
    indices: array<u32, 4>,
    weights: vec4<f32>,
}

struct texture_Axis {
    low: u32,
    high: u32,
    fraction: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> nodes: type_35;
@group(0) @binding(3) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_43;
@group(0) @binding(8) 
var<storage> materials: type_47;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_195_: bool;
    var phi_199_: f32;

    if (param != param) {
        phi_195_ = true;
    } else {
        let _e70 = (param_1 >= param);
        if _e70 {
        }
        phi_195_ = _e70;
    }
    let _e72 = phi_195_;
    if _e72 {
        phi_199_ = param_1;
    } else {
        phi_199_ = param;
    }
    let _e74 = phi_199_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_211_: bool;
    var phi_215_: f32;

    if (param_2 != param_2) {
        phi_211_ = true;
    } else {
        let _e70 = (param_3 <= param_2);
        if _e70 {
        }
        phi_211_ = _e70;
    }
    let _e72 = phi_211_;
    if _e72 {
        phi_215_ = param_3;
    } else {
        phi_215_ = param_2;
    }
    let _e74 = phi_215_;
    return _e74;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_257_: f32;
    var phi_262_: f32;
    var phi_263_: bool;
    var phi_264_: f32;
    var phi_265_: bool;
    var phi_269_: f32;
    var phi_295_: f32;
    var phi_300_: f32;
    var phi_301_: bool;
    var phi_302_: f32;
    var phi_303_: bool;
    var phi_307_: f32;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_317_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_345_: u32;
    var phi_359_: u32;
    var phi_366_: u32;
    var phi_371_: u32;
    var phi_377_: u32;
    var phi_382_: u32;
    var phi_384_: texture_Axis;
    var phi_412_: f32;
    var phi_417_: f32;
    var phi_418_: bool;
    var phi_419_: f32;
    var phi_420_: bool;
    var phi_424_: f32;
    var phi_450_: f32;
    var phi_455_: f32;
    var phi_456_: bool;
    var phi_457_: f32;
    var phi_458_: bool;
    var phi_462_: f32;
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_472_: f32;
    var phi_481_: f32;
    var phi_482_: f32;
    var phi_500_: u32;
    var phi_514_: u32;
    var phi_521_: u32;
    var phi_526_: u32;
    var phi_532_: u32;
    var phi_537_: u32;
    var phi_539_: texture_Axis;

    let _e71 = (*param_4).size;
    let _e72 = (_e71 & 65535u);
    let _e74 = (*param_4).size;
    let _e76 = (_e74 >> bitcast<u32>(16i));
    let _e78 = (*param_4).flags;
    let _e80 = ((_e78 & 4u) != 0u);
    let _e82 = (*param_4).flags;
    let _e85 = ((_e82 >> bitcast<u32>(4u)) & 3u);
    if (_e85 == 0u) {
        if (param_5 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e98 > param_5) {
                phi_257_ = 1f;
            } else {
                phi_257_ = 0f;
            }
            let _e101 = phi_257_;
            if (param_5 < 8388608f) {
                phi_262_ = (_e98 - _e101);
                phi_263_ = false;
            } else {
                phi_262_ = f32();
                phi_263_ = true;
            }
            let _e104 = phi_262_;
            let _e106 = phi_263_;
            phi_264_ = _e104;
            phi_265_ = _e106;
        } else {
            phi_264_ = f32();
            phi_265_ = true;
        }
        let _e108 = phi_264_;
        let _e110 = phi_265_;
        if _e110 {
            phi_269_ = param_5;
        } else {
            phi_269_ = _e108;
        }
        let _e112 = phi_269_;
        phi_317_ = (param_5 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_5 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_295_ = 1f;
                } else {
                    phi_295_ = 0f;
                }
                let _e130 = phi_295_;
                if (_e115 < 8388608f) {
                    phi_300_ = (_e127 - _e130);
                    phi_301_ = false;
                } else {
                    phi_300_ = f32();
                    phi_301_ = true;
                }
                let _e133 = phi_300_;
                let _e135 = phi_301_;
                phi_302_ = _e133;
                phi_303_ = _e135;
            } else {
                phi_302_ = f32();
                phi_303_ = true;
            }
            let _e137 = phi_302_;
            let _e139 = phi_303_;
            if _e139 {
                phi_307_ = _e115;
            } else {
                phi_307_ = _e137;
            }
            let _e141 = phi_307_;
            let _e143 = (param_5 - (2f * _e141));
            if (_e143 > 1f) {
                phi_315_ = (2f - _e143);
            } else {
                phi_315_ = _e143;
            }
            let _e147 = phi_315_;
            phi_316_ = _e147;
        } else {
            phi_316_ = param_5;
        }
        let _e149 = phi_316_;
        phi_317_ = _e149;
    }
    let _e151 = phi_317_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_326_ = _e151;
        } else {
            phi_326_ = 1f;
        }
        let _e155 = phi_326_;
        phi_327_ = _e155;
    } else {
        phi_327_ = 0f;
    }
    let _e157 = phi_327_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_345_ = _e158;
        } else {
            phi_345_ = _e167;
        }
        let _e170 = phi_345_;
        phi_384_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_359_ = _e72;
        } else {
            phi_359_ = _e179;
        }
        let _e182 = phi_359_;
        if (_e85 == 0u) {
            phi_366_ = _e158;
        } else {
            phi_366_ = 0u;
        }
        let _e187 = phi_366_;
        if (_e85 == 0u) {
            phi_371_ = 0u;
        } else {
            phi_371_ = _e158;
        }
        let _e190 = phi_371_;
        if (_e182 == 0u) {
            phi_377_ = _e187;
        } else {
            phi_377_ = (_e182 - 1u);
        }
        let _e194 = phi_377_;
        if (_e182 > _e158) {
            phi_382_ = _e190;
        } else {
            phi_382_ = _e182;
        }
        let _e197 = phi_382_;
        phi_384_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_384_;
    let _e202 = (*param_4).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_6 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e218 > param_6) {
                phi_412_ = 1f;
            } else {
                phi_412_ = 0f;
            }
            let _e221 = phi_412_;
            if (param_6 < 8388608f) {
                phi_417_ = (_e218 - _e221);
                phi_418_ = false;
            } else {
                phi_417_ = f32();
                phi_418_ = true;
            }
            let _e224 = phi_417_;
            let _e226 = phi_418_;
            phi_419_ = _e224;
            phi_420_ = _e226;
        } else {
            phi_419_ = f32();
            phi_420_ = true;
        }
        let _e228 = phi_419_;
        let _e230 = phi_420_;
        if _e230 {
            phi_424_ = param_6;
        } else {
            phi_424_ = _e228;
        }
        let _e232 = phi_424_;
        phi_472_ = (param_6 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_6 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_450_ = 1f;
                } else {
                    phi_450_ = 0f;
                }
                let _e250 = phi_450_;
                if (_e235 < 8388608f) {
                    phi_455_ = (_e247 - _e250);
                    phi_456_ = false;
                } else {
                    phi_455_ = f32();
                    phi_456_ = true;
                }
                let _e253 = phi_455_;
                let _e255 = phi_456_;
                phi_457_ = _e253;
                phi_458_ = _e255;
            } else {
                phi_457_ = f32();
                phi_458_ = true;
            }
            let _e257 = phi_457_;
            let _e259 = phi_458_;
            if _e259 {
                phi_462_ = _e235;
            } else {
                phi_462_ = _e257;
            }
            let _e261 = phi_462_;
            let _e263 = (param_6 - (2f * _e261));
            if (_e263 > 1f) {
                phi_470_ = (2f - _e263);
            } else {
                phi_470_ = _e263;
            }
            let _e267 = phi_470_;
            phi_471_ = _e267;
        } else {
            phi_471_ = param_6;
        }
        let _e269 = phi_471_;
        phi_472_ = _e269;
    }
    let _e271 = phi_472_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_481_ = _e271;
        } else {
            phi_481_ = 1f;
        }
        let _e275 = phi_481_;
        phi_482_ = _e275;
    } else {
        phi_482_ = 0f;
    }
    let _e277 = phi_482_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_500_ = _e278;
        } else {
            phi_500_ = _e287;
        }
        let _e290 = phi_500_;
        phi_539_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_514_ = _e76;
        } else {
            phi_514_ = _e299;
        }
        let _e302 = phi_514_;
        if (_e205 == 0u) {
            phi_521_ = _e278;
        } else {
            phi_521_ = 0u;
        }
        let _e307 = phi_521_;
        if (_e205 == 0u) {
            phi_526_ = 0u;
        } else {
            phi_526_ = _e278;
        }
        let _e310 = phi_526_;
        if (_e302 == 0u) {
            phi_532_ = _e307;
        } else {
            phi_532_ = (_e302 - 1u);
        }
        let _e314 = phi_532_;
        if (_e302 > _e278) {
            phi_537_ = _e310;
        } else {
            phi_537_ = _e302;
        }
        let _e317 = phi_537_;
        phi_539_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_539_;
    let _e324 = (*param_4).offset;
    let _e331 = (*param_4).offset;
    let _e338 = (*param_4).offset;
    let _e345 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_678_: f32;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
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
    var phi_756_: bool;
    var phi_760_: bool;
    var phi_764_: bool;
    var phi_834_: f32;
    var phi_841_: f32;
    var phi_848_: f32;
    var phi_855_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_886_: f32;
    var phi_891_: f32;
    var phi_896_: f32;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_933_: u32;
    var phi_934_: u32;
    var phi_945_: vec3<f32>;
    var phi_946_: vec3<f32>;
    var phi_959_: u32;
    var phi_964_: u32;
    var phi_969_: u32;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1115_: u32;
    var phi_1117_: u32;
    var phi_1120_: bool;
    var phi_1200_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1227_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1254_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1260_: u32;
    var phi_1263_: u32;
    var phi_1277_: u32;
    var phi_1287_: u32;
    var phi_1297_: u32;
    var phi_1315_: u32;
    var phi_1325_: u32;
    var phi_1335_: u32;
    var phi_1371_: u32;
    var phi_1384_: u32;
    var phi_1389_: u32;
    var phi_1390_: u32;
    var phi_1391_: u32;
    var phi_1261_: u32;
    var phi_1264_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1449_: u32;
    var phi_1452_: bool;
    var phi_1496_: vec3<f32>;
    var phi_1497_: vec3<f32>;
    var phi_1526_: vec3<f32>;
    var phi_1527_: vec3<f32>;
    var phi_1556_: vec3<f32>;
    var phi_1557_: vec3<f32>;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1580_: f32;
    var phi_1581_: f32;
    var phi_1582_: f32;
    var phi_1583_: f32;
    var phi_1591_: f32;
    var phi_1601_: bool;
    var phi_1602_: bool;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1608_: f32;
    var phi_1609_: f32;
    var phi_1617_: f32;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1632_: f32;
    var phi_1633_: f32;
    var phi_1634_: f32;
    var phi_1635_: f32;
    var phi_1643_: f32;
    var phi_1658_: f32;
    var phi_1659_: bool;
    var phi_1660_: f32;
    var phi_1661_: bool;
    var phi_1662_: f32;
    var phi_1663_: bool;
    var phi_1681_: f32;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: f32;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1690_: bool;
    var phi_1691_: f32;
    var phi_1692_: bool;
    var phi_1720_: vec3<f32>;
    var phi_1721_: vec3<f32>;
    var phi_1746_: vec3<f32>;
    var phi_1747_: vec3<f32>;
    var phi_1772_: vec3<f32>;
    var phi_1773_: vec3<f32>;
    var phi_1829_: f32;
    var phi_1838_: f32;
    var phi_1847_: f32;
    var phi_1856_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1883_: f32;
    var phi_1892_: f32;
    var phi_1901_: f32;
    var phi_1910_: f32;
    var phi_1917_: f32;
    var phi_1924_: f32;
    var phi_1941_: f32;
    var phi_1946_: f32;
    var phi_1951_: f32;
    var phi_1959_: f32;
    var phi_1964_: f32;
    var phi_1969_: f32;
    var phi_1981_: f32;
    var phi_1986_: f32;
    var phi_1991_: f32;
    var phi_1996_: f32;
    var phi_2001_: lt_bvh_triangle_Intersection;
    var phi_2002_: bool;
    var phi_2003_: lt_bvh_triangle_Intersection;
    var phi_2004_: bool;
    var phi_2008_: lt_bvh_triangle_Intersection;
    var phi_2009_: bool;
    var phi_2010_: lt_bvh_triangle_Intersection;
    var phi_2011_: bool;
    var phi_2012_: bool;
    var phi_2016_: bool;
    var phi_2020_: lt_bvh_triangle_Intersection;
    var phi_2234_: f32;
    var phi_2237_: bool;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_1450_: u32;
    var phi_1453_: bool;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var local_5: bool;
    var phi_2299_: bool;
    var phi_2300_: bool;
    var phi_2331_: u32;
    var phi_2332_: u32;
    var phi_1118_: u32;
    var phi_1121_: bool;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2335_: bool;
    var local_6: bool;
    var phi_2339_: bool;
    var phi_2343_: bool;
    var phi_2344_: bool;
    var phi_2345_: bool;
    var phi_2346_: bool;
    var phi_2350_: bool;
    var phi_2354_: f32;
    var phi_2375_: u32;
    var phi_2390_: u32;
    var phi_2395_: u32;
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
            phi_678_ = 300000000000000000000000000000000000000f;
        } else {
            phi_678_ = 1f;
        }
        let _e139 = phi_678_;
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
                                    phi_734_ = bool();
                                    phi_735_ = true;
                                } else {
                                    let _e164 = (_e155 > 0f);
                                    if _e164 {
                                        phi_733_ = bool();
                                    } else {
                                        phi_733_ = (_e156 > 0f);
                                    }
                                    let _e167 = phi_733_;
                                    phi_734_ = _e167;
                                    phi_735_ = _e164;
                                }
                                let _e169 = phi_734_;
                                let _e171 = phi_735_;
                                if _e171 {
                                    phi_739_ = true;
                                } else {
                                    phi_739_ = _e169;
                                }
                                let _e173 = phi_739_;
                                phi_740_ = _e173;
                                phi_741_ = false;
                            } else {
                                phi_740_ = bool();
                                phi_741_ = true;
                            }
                            let _e175 = phi_740_;
                            let _e177 = phi_741_;
                            phi_742_ = _e175;
                            phi_743_ = false;
                            phi_744_ = _e177;
                        } else {
                            phi_742_ = bool();
                            phi_743_ = true;
                            phi_744_ = false;
                        }
                        let _e179 = phi_742_;
                        let _e181 = phi_743_;
                        let _e183 = phi_744_;
                        phi_745_ = _e179;
                        phi_746_ = _e181;
                        phi_747_ = _e183;
                    } else {
                        phi_745_ = bool();
                        phi_746_ = true;
                        phi_747_ = false;
                    }
                    let _e185 = phi_745_;
                    let _e187 = phi_746_;
                    let _e189 = phi_747_;
                    phi_748_ = _e185;
                    phi_749_ = _e187;
                    phi_750_ = _e189;
                } else {
                    phi_748_ = bool();
                    phi_749_ = true;
                    phi_750_ = false;
                }
                let _e191 = phi_748_;
                let _e193 = phi_749_;
                let _e195 = phi_750_;
                phi_751_ = _e191;
                phi_752_ = _e193;
                phi_753_ = _e195;
            } else {
                phi_751_ = bool();
                phi_752_ = true;
                phi_753_ = false;
            }
            let _e197 = phi_751_;
            let _e199 = phi_752_;
            let _e201 = phi_753_;
            phi_754_ = _e197;
            phi_755_ = _e199;
            phi_756_ = _e201;
        } else {
            phi_754_ = bool();
            phi_755_ = true;
            phi_756_ = false;
        }
        let _e203 = phi_754_;
        let _e205 = phi_755_;
        let _e207 = phi_756_;
        if _e205 {
            phi_760_ = true;
        } else {
            phi_760_ = _e207;
        }
        let _e209 = phi_760_;
        if _e209 {
            phi_764_ = false;
        } else {
            phi_764_ = _e203;
        }
        let _e211 = phi_764_;
        if _e211 {
            let _e212 = (0u >= _e76);
            if _e212 {
                phi_2344_ = bool();
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
                    phi_834_ = _e278;
                } else {
                    phi_834_ = abs(_e147);
                }
                let _e283 = phi_834_;
                if (_e147 < 0f) {
                    phi_841_ = (-1f / _e283);
                } else {
                    phi_841_ = (1f / _e283);
                }
                let _e288 = phi_841_;
                if (abs(_e148) < _e278) {
                    phi_848_ = _e278;
                } else {
                    phi_848_ = abs(_e148);
                }
                let _e293 = phi_848_;
                if (_e148 < 0f) {
                    phi_855_ = (-1f / _e293);
                } else {
                    phi_855_ = (1f / _e293);
                }
                let _e298 = phi_855_;
                if (abs(_e149) < _e278) {
                    phi_862_ = _e278;
                } else {
                    phi_862_ = abs(_e149);
                }
                let _e303 = phi_862_;
                if (_e149 < 0f) {
                    phi_869_ = (-1f / _e303);
                } else {
                    phi_869_ = (1f / _e303);
                }
                let _e308 = phi_869_;
                let _e312 = abs((bitcast<f32>(_e218) - _e131));
                let _e313 = abs((bitcast<f32>(_e222) - _e133));
                let _e314 = abs((bitcast<f32>(_e226) - _e135));
                let _e318 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                let _e319 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e320 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                if (_e312 > _e318) {
                    phi_886_ = _e312;
                } else {
                    phi_886_ = _e318;
                }
                let _e323 = phi_886_;
                if (_e313 > _e319) {
                    phi_891_ = _e313;
                } else {
                    phi_891_ = _e319;
                }
                let _e326 = phi_891_;
                if (_e314 > _e320) {
                    phi_896_ = _e314;
                } else {
                    phi_896_ = _e320;
                }
                let _e329 = phi_896_;
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
                        phi_924_ = false;
                    } else {
                        phi_924_ = true;
                    }
                    let _e352 = phi_924_;
                    phi_925_ = _e352;
                } else {
                    phi_925_ = true;
                }
                let _e354 = phi_925_;
                if _e354 {
                    if (_e347 >= _e348) {
                        phi_933_ = 1u;
                    } else {
                        phi_933_ = 2u;
                    }
                    let _e357 = phi_933_;
                    phi_934_ = _e357;
                } else {
                    phi_934_ = 0u;
                }
                let _e359 = phi_934_;
                if (_e359 == 0u) {
                    phi_946_ = vec3<f32>(_e148, _e149, _e147);
                } else {
                    if (_e359 == 1u) {
                        phi_945_ = vec3<f32>(_e149, _e147, _e148);
                    } else {
                        phi_945_ = vec3<f32>(_e147, _e148, _e149);
                    }
                    let _e365 = phi_945_;
                    phi_946_ = _e365;
                }
                let _e367 = phi_946_;
                let _e370 = (_e367.x / _e367.z);
                let _e373 = (_e367.y / _e367.z);
                if (_e288 < 0f) {
                    phi_959_ = 0u;
                } else {
                    phi_959_ = 1u;
                }
                let _e378 = phi_959_;
                if (_e298 < 0f) {
                    phi_964_ = 0u;
                } else {
                    phi_964_ = 2u;
                }
                let _e381 = phi_964_;
                if (_e308 < 0f) {
                    phi_969_ = 0u;
                } else {
                    phi_969_ = 4u;
                }
                let _e384 = phi_969_;
                let _e386 = ((_e378 | _e381) | _e384);
                let _e387 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e387.first[0], _e387.first[1], _e387.first[2], _e387.first[3], _e387.first[4], _e387.first[5], _e387.first[6], _e387.first[7], _e387.first[8], _e387.first[9], _e387.first[10], _e387.first[11], _e387.first[12], _e387.first[13], _e387.first[14], _e387.first[15], _e387.first[16], _e387.first[17], _e387.first[18], _e387.first[19], _e387.first[20], _e387.first[21], _e387.first[22], _e387.first[23], _e387.first[24], _e387.first[25], _e387.first[26], _e387.first[27], _e387.first[28], _e387.first[29], _e387.first[30], _e387.first[31]), array<u32, 32>(_e387.mask[0], _e387.mask[1], _e387.mask[2], _e387.mask[3], _e387.mask[4], _e387.mask[5], _e387.mask[6], _e387.mask[7], _e387.mask[8], _e387.mask[9], _e387.mask[10], _e387.mask[11], _e387.mask[12], _e387.mask[13], _e387.mask[14], _e387.mask[15], _e387.mask[16], _e387.mask[17], _e387.mask[18], _e387.mask[19], _e387.mask[20], _e387.mask[21], _e387.mask[22], _e387.mask[23], _e387.mask[24], _e387.mask[25], _e387.mask[26], _e387.mask[27], _e387.mask[28], _e387.mask[29], _e387.mask[30], _e387.mask[31]), _e387.len, _e387.group, _e387.group_mask);
                let _e461 = local_1.group_mask;
                if ((_e461 & 4278190080u) == 0u) {
                    let _e465 = local_1.len;
                    if (_e465 == 0u) {
                        phi_1083_ = false;
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
                        phi_1083_ = true;
                    }
                    let _e488 = phi_1083_;
                    phi_1084_ = _e488;
                } else {
                    phi_1084_ = true;
                }
                let _e490 = phi_1084_;
                if _e490 {
                    let _e492 = local_1.group_mask;
                    let _e498 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e492)), 32u, (_e492 == 0u)));
                    let _e502 = local_1.group_mask;
                    let _e516 = local_1.group_mask;
                    local_1.group_mask = (_e516 & ~((1u << bitcast<u32>((_e498 & 31u)))));
                    let _e519 = local_1.group;
                    phi_1115_ = (_e519 + countOneBits(((_e502 & ~((4294967295u << bitcast<u32>((((_e498 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1115_ = 4294967295u;
                }
                let _e522 = phi_1115_;
                phi_1117_ = _e522;
                phi_1120_ = false;
                loop {
                    let _e524 = phi_1117_;
                    let _e526 = phi_1120_;
                    local_11 = _e526;
                    if (_e524 != 4294967295u) {
                        if (_e524 < _e76) {
                        } else {
                            return;
                        }
                        let _e533 = nodes.member[(0u + _e524)].frame[3u];
                        let _e558 = (bitcast<f32>((((_e533 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e288);
                        let _e559 = (bitcast<f32>((((_e533 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e298);
                        let _e560 = (bitcast<f32>((((_e533 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e563 = nodes.member[(0u + _e524)].frame[0u];
                        let _e567 = nodes.member[(0u + _e524)].frame[1u];
                        let _e571 = nodes.member[(0u + _e524)].frame[2u];
                        let _e576 = ((bitcast<f32>(_e563) - _e131) * _e288);
                        let _e577 = ((bitcast<f32>(_e567) - _e133) * _e298);
                        let _e578 = ((bitcast<f32>(_e571) - _e135) * _e308);
                        let _e586 = nodes.member[(0u + _e524)].x;
                        if (_e288 < 0f) {
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e597.unnamed.root, _e586.w), _e597.unnamed_1);
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e586.x, _e603.unnamed_1.first_primitive));
                            phi_1200_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_bvh_traverse_Tree(_e609.unnamed_1.root, _e586.y));
                        } else {
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e625.unnamed.root, _e586.y), _e625.unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_bvh_traverse_Tree(_e586.z, _e631.unnamed_1.first_primitive));
                            phi_1200_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_bvh_traverse_Tree(_e637.unnamed_1.root, _e586.w));
                        }
                        let _e645 = phi_1200_;
                        let _e655 = nodes.member[(0u + _e524)].y;
                        if (_e298 < 0f) {
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e666.unnamed.root, _e655.w), _e666.unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e655.x, _e672.unnamed_1.first_primitive));
                            phi_1227_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_bvh_traverse_Tree(_e678.unnamed_1.root, _e655.y));
                        } else {
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e694.unnamed.root, _e655.y), _e694.unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e655.z, _e700.unnamed_1.first_primitive));
                            phi_1227_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_bvh_traverse_Tree(_e706.unnamed_1.root, _e655.w));
                        }
                        let _e714 = phi_1227_;
                        let _e724 = nodes.member[(0u + _e524)].z;
                        if (_e308 < 0f) {
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e735.unnamed.root, _e724.w), _e735.unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e724.x, _e741.unnamed_1.first_primitive));
                            phi_1254_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_bvh_traverse_Tree(_e747.unnamed_1.root, _e724.y));
                        } else {
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e763.unnamed.root, _e724.y), _e763.unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e724.z, _e769.unnamed_1.first_primitive));
                            phi_1254_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_bvh_traverse_Tree(_e775.unnamed_1.root, _e724.w));
                        }
                        let _e783 = phi_1254_;
                        phi_1260_ = 0u;
                        phi_1263_ = 0u;
                        loop {
                            let _e793 = phi_1260_;
                            let _e795 = phi_1263_;
                            local_2 = _e795;
                            local_3 = _e795;
                            local_4 = _e795;
                            let _e796 = (_e793 < 8u);
                            if _e796 {
                                let _e798 = (_e793 >> bitcast<u32>(2i));
                                let _e799 = (_e793 & 3u);
                                if (_e798 == 0u) {
                                    phi_1277_ = _e645.unnamed.root;
                                } else {
                                    phi_1277_ = _e645.unnamed.first_primitive;
                                }
                                let _e802 = phi_1277_;
                                if (_e798 == 0u) {
                                    phi_1287_ = _e714.unnamed.root;
                                } else {
                                    phi_1287_ = _e714.unnamed.first_primitive;
                                }
                                let _e811 = phi_1287_;
                                if (_e798 == 0u) {
                                    phi_1297_ = _e783.unnamed.root;
                                } else {
                                    phi_1297_ = _e783.unnamed.first_primitive;
                                }
                                let _e820 = phi_1297_;
                                let _e833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e802 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e336)), ((f32(((_e811 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e337)));
                                let _e834 = core_intrinsics_maximum_number_nsz_f32_(_e833, ((f32(((_e820 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e560) + (_e578 - _e338)));
                                if (_e798 == 0u) {
                                    phi_1315_ = _e645.unnamed_1.root;
                                } else {
                                    phi_1315_ = _e645.unnamed_1.first_primitive;
                                }
                                let _e837 = phi_1315_;
                                if (_e798 == 0u) {
                                    phi_1325_ = _e714.unnamed_1.root;
                                } else {
                                    phi_1325_ = _e714.unnamed_1.first_primitive;
                                }
                                let _e846 = phi_1325_;
                                if (_e798 == 0u) {
                                    phi_1335_ = _e783.unnamed_1.root;
                                } else {
                                    phi_1335_ = _e783.unnamed_1.first_primitive;
                                }
                                let _e855 = phi_1335_;
                                let _e868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e837 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e336)), ((f32(((_e846 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e337)));
                                let _e869 = core_intrinsics_minimum_number_nsz_f32_(_e868, ((f32(((_e855 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e560) + (_e578 + _e338)));
                                if (_e834 <= _e869) {
                                    if (_e834 <= _e139) {
                                        if (_e869 >= 0f) {
                                            if (_e798 == 0u) {
                                                let _e876 = nodes.member[(0u + _e524)].links[2u];
                                                phi_1371_ = _e876;
                                            } else {
                                                let _e879 = nodes.member[(0u + _e524)].links[3u];
                                                phi_1371_ = _e879;
                                            }
                                            let _e881 = phi_1371_;
                                            let _e886 = ((_e881 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u);
                                            let _e887 = (_e886 & 31u);
                                            if (_e887 >= 24u) {
                                                phi_1384_ = (24u + ((_e887 - 24u) ^ _e386));
                                            } else {
                                                phi_1384_ = _e887;
                                            }
                                            let _e893 = phi_1384_;
                                            phi_1389_ = (_e795 | ((_e886 >> bitcast<u32>(5i)) << bitcast<u32>((_e893 & 31u))));
                                        } else {
                                            phi_1389_ = _e795;
                                        }
                                        let _e901 = phi_1389_;
                                        phi_1390_ = _e901;
                                    } else {
                                        phi_1390_ = _e795;
                                    }
                                    let _e903 = phi_1390_;
                                    phi_1391_ = _e903;
                                } else {
                                    phi_1391_ = _e795;
                                }
                                let _e905 = phi_1391_;
                                phi_1261_ = (_e793 + 1u);
                                phi_1264_ = _e905;
                            } else {
                                phi_1261_ = u32();
                                phi_1264_ = u32();
                            }
                            let _e908 = phi_1261_;
                            let _e910 = phi_1264_;
                            continue;
                            continuing {
                                phi_1260_ = _e908;
                                phi_1263_ = _e910;
                                break if !(_e796);
                            }
                        }
                        let _e914 = nodes.member[(0u + _e524)].links[0u];
                        let _e918 = nodes.member[(0u + _e524)].frame[3u];
                        let _e922 = local_2;
                        if ((_e922 & 4278190080u) == 0u) {
                        } else {
                            let _e926 = local_1.group_mask;
                            if ((_e926 & 4278190080u) == 0u) {
                            } else {
                                let _e930 = local_1.len;
                                if (_e930 < 32u) {
                                    let _e933 = local_1.group;
                                    let _e935 = local_1.len;
                                    if (_e935 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e935)] = _e933;
                                    let _e941 = local_1.group_mask;
                                    let _e943 = local_1.len;
                                    if (_e943 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e943)] = _e941;
                                    let _e950 = local_1.len;
                                    local_1.len = (_e950 + 1u);
                                }
                            }
                            local_1.group = (0u + _e914);
                            let _e954 = local_3;
                            local_1.group_mask = ((_e954 & 4278190080u) | (_e918 >> bitcast<u32>(24i)));
                        }
                        let _e959 = local_4;
                        phi_1449_ = (_e959 & 16777215u);
                        phi_1452_ = _e526;
                        loop {
                            let _e962 = phi_1449_;
                            let _e964 = phi_1452_;
                            local_7 = _e964;
                            let _e965 = (_e962 == 0u);
                            local_5 = _e965;
                            local_9 = _e965;
                            if _e965 {
                                phi_1450_ = u32();
                                phi_1453_ = bool();
                                phi_2256_ = bool();
                                phi_2257_ = false;
                            } else {
                                let _e968 = nodes.member[(0u + _e524)].links[1u];
                                let _e973 = ((0u + _e968) + select(firstTrailingBit(_e962), 32u, (_e962 == 0u)));
                                if (_e973 < _e79) {
                                } else {
                                    return;
                                }
                                let _e980 = triangles.member[(0u + _e973)].v0_;
                                let _e982 = (_e980.x - _e131);
                                let _e984 = (_e980.y - _e133);
                                let _e986 = (_e980.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1497_ = vec3<f32>(_e984, _e986, _e982);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1496_ = vec3<f32>(_e986, _e982, _e984);
                                    } else {
                                        phi_1496_ = (_e980 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e994 = phi_1496_;
                                    phi_1497_ = _e994;
                                }
                                let _e996 = phi_1497_;
                                let _e1000 = (_e996.x - (_e370 * _e996.z));
                                let _e1004 = (_e996.y - (_e373 * _e996.z));
                                let _e1006 = triangles.member[(0u + _e973)].v1_;
                                let _e1008 = (_e1006.x - _e131);
                                let _e1010 = (_e1006.y - _e133);
                                let _e1012 = (_e1006.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1527_ = vec3<f32>(_e1010, _e1012, _e1008);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1526_ = vec3<f32>(_e1012, _e1008, _e1010);
                                    } else {
                                        phi_1526_ = (_e1006 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1020 = phi_1526_;
                                    phi_1527_ = _e1020;
                                }
                                let _e1022 = phi_1527_;
                                let _e1026 = (_e1022.x - (_e370 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e373 * _e1022.z));
                                let _e1032 = triangles.member[(0u + _e973)].v2_;
                                let _e1034 = (_e1032.x - _e131);
                                let _e1036 = (_e1032.y - _e133);
                                let _e1038 = (_e1032.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1557_ = vec3<f32>(_e1036, _e1038, _e1034);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1556_ = vec3<f32>(_e1038, _e1034, _e1036);
                                    } else {
                                        phi_1556_ = (_e1032 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1046 = phi_1556_;
                                    phi_1557_ = _e1046;
                                }
                                let _e1048 = phi_1557_;
                                let _e1052 = (_e1048.x - (_e370 * _e1048.z));
                                let _e1056 = (_e1048.y - (_e373 * _e1048.z));
                                if (_e1026 < _e1052) {
                                    phi_1576_ = true;
                                } else {
                                    if (_e1026 == _e1052) {
                                        phi_1575_ = (_e1030 < _e1056);
                                    } else {
                                        phi_1575_ = false;
                                    }
                                    let _e1061 = phi_1575_;
                                    phi_1576_ = _e1061;
                                }
                                let _e1063 = phi_1576_;
                                if _e1063 {
                                    phi_1580_ = _e1056;
                                    phi_1581_ = _e1052;
                                    phi_1582_ = _e1030;
                                    phi_1583_ = _e1026;
                                } else {
                                    phi_1580_ = _e1030;
                                    phi_1581_ = _e1026;
                                    phi_1582_ = _e1056;
                                    phi_1583_ = _e1052;
                                }
                                let _e1065 = phi_1580_;
                                let _e1067 = phi_1581_;
                                let _e1069 = phi_1582_;
                                let _e1071 = phi_1583_;
                                let _e1074 = ((_e1071 * _e1065) - (_e1069 * _e1067));
                                if _e1063 {
                                    phi_1591_ = -(_e1074);
                                } else {
                                    phi_1591_ = _e1074;
                                }
                                let _e1077 = phi_1591_;
                                if (_e1052 < _e1000) {
                                    phi_1602_ = true;
                                } else {
                                    if (_e1052 == _e1000) {
                                        phi_1601_ = (_e1056 < _e1004);
                                    } else {
                                        phi_1601_ = false;
                                    }
                                    let _e1082 = phi_1601_;
                                    phi_1602_ = _e1082;
                                }
                                let _e1084 = phi_1602_;
                                if _e1084 {
                                    phi_1606_ = _e1004;
                                    phi_1607_ = _e1000;
                                    phi_1608_ = _e1056;
                                    phi_1609_ = _e1052;
                                } else {
                                    phi_1606_ = _e1056;
                                    phi_1607_ = _e1052;
                                    phi_1608_ = _e1004;
                                    phi_1609_ = _e1000;
                                }
                                let _e1086 = phi_1606_;
                                let _e1088 = phi_1607_;
                                let _e1090 = phi_1608_;
                                let _e1092 = phi_1609_;
                                let _e1095 = ((_e1092 * _e1086) - (_e1090 * _e1088));
                                if _e1084 {
                                    phi_1617_ = -(_e1095);
                                } else {
                                    phi_1617_ = _e1095;
                                }
                                let _e1098 = phi_1617_;
                                if (_e1000 < _e1026) {
                                    phi_1628_ = true;
                                } else {
                                    if (_e1000 == _e1026) {
                                        phi_1627_ = (_e1004 < _e1030);
                                    } else {
                                        phi_1627_ = false;
                                    }
                                    let _e1103 = phi_1627_;
                                    phi_1628_ = _e1103;
                                }
                                let _e1105 = phi_1628_;
                                if _e1105 {
                                    phi_1632_ = _e1030;
                                    phi_1633_ = _e1026;
                                    phi_1634_ = _e1004;
                                    phi_1635_ = _e1000;
                                } else {
                                    phi_1632_ = _e1004;
                                    phi_1633_ = _e1000;
                                    phi_1634_ = _e1030;
                                    phi_1635_ = _e1026;
                                }
                                let _e1107 = phi_1632_;
                                let _e1109 = phi_1633_;
                                let _e1111 = phi_1634_;
                                let _e1113 = phi_1635_;
                                let _e1116 = ((_e1113 * _e1107) - (_e1111 * _e1109));
                                if _e1105 {
                                    phi_1643_ = -(_e1116);
                                } else {
                                    phi_1643_ = _e1116;
                                }
                                let _e1119 = phi_1643_;
                                if (_e1077 >= 0f) {
                                    if (_e1098 >= 0f) {
                                        if (_e1119 >= 0f) {
                                            phi_1658_ = ((_e1077 + _e1098) + _e1119);
                                            phi_1659_ = false;
                                        } else {
                                            phi_1658_ = f32();
                                            phi_1659_ = true;
                                        }
                                        let _e1126 = phi_1658_;
                                        let _e1128 = phi_1659_;
                                        phi_1660_ = _e1126;
                                        phi_1661_ = _e1128;
                                    } else {
                                        phi_1660_ = f32();
                                        phi_1661_ = true;
                                    }
                                    let _e1130 = phi_1660_;
                                    let _e1132 = phi_1661_;
                                    phi_1662_ = _e1130;
                                    phi_1663_ = _e1132;
                                } else {
                                    phi_1662_ = f32();
                                    phi_1663_ = true;
                                }
                                let _e1134 = phi_1662_;
                                let _e1136 = phi_1663_;
                                if _e1136 {
                                    if (_e1077 <= 0f) {
                                        if (_e1098 <= 0f) {
                                            let _e1139 = (_e1119 <= 0f);
                                            if _e1139 {
                                            }
                                            phi_1681_ = ((_e1077 + _e1098) + _e1119);
                                            phi_1682_ = false;
                                            phi_1683_ = _e1139;
                                        } else {
                                            phi_1681_ = f32();
                                            phi_1682_ = true;
                                            phi_1683_ = false;
                                        }
                                        let _e1143 = phi_1681_;
                                        let _e1145 = phi_1682_;
                                        let _e1147 = phi_1683_;
                                        phi_1684_ = _e1143;
                                        phi_1685_ = _e1145;
                                        phi_1686_ = _e1147;
                                    } else {
                                        phi_1684_ = f32();
                                        phi_1685_ = true;
                                        phi_1686_ = false;
                                    }
                                    let _e1149 = phi_1684_;
                                    let _e1151 = phi_1685_;
                                    let _e1153 = phi_1686_;
                                    if _e1151 {
                                        phi_1690_ = false;
                                    } else {
                                        phi_1690_ = _e1153;
                                    }
                                    let _e1155 = phi_1690_;
                                    phi_1691_ = _e1149;
                                    phi_1692_ = _e1155;
                                } else {
                                    phi_1691_ = _e1134;
                                    phi_1692_ = true;
                                }
                                let _e1157 = phi_1691_;
                                let _e1159 = phi_1692_;
                                if _e1159 {
                                    let _e1160 = (_e1157 == 0f);
                                    if _e1160 {
                                        phi_2008_ = lt_bvh_triangle_Intersection();
                                        phi_2009_ = false;
                                    } else {
                                        let _e1162 = triangles.member[(0u + _e973)].v0_;
                                        let _e1164 = (_e1162.x - _e131);
                                        let _e1166 = (_e1162.y - _e133);
                                        let _e1168 = (_e1162.z - _e135);
                                        if (_e359 == 0u) {
                                            phi_1721_ = vec3<f32>(_e1166, _e1168, _e1164);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1720_ = vec3<f32>(_e1168, _e1164, _e1166);
                                            } else {
                                                phi_1720_ = (_e1162 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1176 = phi_1720_;
                                            phi_1721_ = _e1176;
                                        }
                                        let _e1178 = phi_1721_;
                                        let _e1180 = triangles.member[(0u + _e973)].v1_;
                                        let _e1182 = triangles.member[(0u + _e973)].v0_;
                                        let _e1185 = (_e1180.x - _e1182.x);
                                        let _e1188 = (_e1180.y - _e1182.y);
                                        let _e1191 = (_e1180.z - _e1182.z);
                                        if (_e359 == 0u) {
                                            phi_1747_ = vec3<f32>(_e1188, _e1191, _e1185);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1746_ = vec3<f32>(_e1191, _e1185, _e1188);
                                            } else {
                                                phi_1746_ = (_e1180 - _e1182);
                                            }
                                            let _e1198 = phi_1746_;
                                            phi_1747_ = _e1198;
                                        }
                                        let _e1200 = phi_1747_;
                                        let _e1202 = triangles.member[(0u + _e973)].v2_;
                                        let _e1204 = triangles.member[(0u + _e973)].v0_;
                                        let _e1207 = (_e1202.x - _e1204.x);
                                        let _e1210 = (_e1202.y - _e1204.y);
                                        let _e1213 = (_e1202.z - _e1204.z);
                                        if (_e359 == 0u) {
                                            phi_1773_ = vec3<f32>(_e1210, _e1213, _e1207);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1772_ = vec3<f32>(_e1213, _e1207, _e1210);
                                            } else {
                                                phi_1772_ = (_e1202 - _e1204);
                                            }
                                            let _e1220 = phi_1772_;
                                            phi_1773_ = _e1220;
                                        }
                                        let _e1222 = phi_1773_;
                                        let _e1229 = ((_e1200.y * _e1222.z) - (_e1200.z * _e1222.y));
                                        let _e1236 = ((_e1200.z * _e1222.x) - (_e1200.x * _e1222.z));
                                        let _e1243 = ((_e1200.x * _e1222.y) - (_e1200.y * _e1222.x));
                                        let _e1257 = (((1f / _e367.z) * (((_e1229 * _e1178.x) + (_e1236 * _e1178.y)) + (_e1243 * _e1178.z))) / (((_e1229 * _e370) + (_e1236 * _e373)) + _e1243));
                                        if (_e1257 > 0f) {
                                            if (_e1257 < _e139) {
                                                let _e1261 = triangles.member[(0u + _e973)].v0_;
                                                let _e1263 = triangles.member[(0u + _e973)].v1_;
                                                if (_e1261.x < _e1263.x) {
                                                    phi_1829_ = _e1261.x;
                                                } else {
                                                    phi_1829_ = _e1263.x;
                                                }
                                                let _e1270 = phi_1829_;
                                                if (_e1261.y < _e1263.y) {
                                                    phi_1838_ = _e1261.y;
                                                } else {
                                                    phi_1838_ = _e1263.y;
                                                }
                                                let _e1277 = phi_1838_;
                                                if (_e1261.z < _e1263.z) {
                                                    phi_1847_ = _e1261.z;
                                                } else {
                                                    phi_1847_ = _e1263.z;
                                                }
                                                let _e1284 = phi_1847_;
                                                let _e1286 = triangles.member[(0u + _e973)].v2_;
                                                if (_e1270 < _e1286.x) {
                                                    phi_1856_ = _e1270;
                                                } else {
                                                    phi_1856_ = _e1286.x;
                                                }
                                                let _e1291 = phi_1856_;
                                                if (_e1277 < _e1286.y) {
                                                    phi_1863_ = _e1277;
                                                } else {
                                                    phi_1863_ = _e1286.y;
                                                }
                                                let _e1296 = phi_1863_;
                                                if (_e1284 < _e1286.z) {
                                                    phi_1870_ = _e1284;
                                                } else {
                                                    phi_1870_ = _e1286.z;
                                                }
                                                let _e1301 = phi_1870_;
                                                let _e1303 = triangles.member[(0u + _e973)].v0_;
                                                let _e1305 = triangles.member[(0u + _e973)].v1_;
                                                if (_e1303.x > _e1305.x) {
                                                    phi_1883_ = _e1303.x;
                                                } else {
                                                    phi_1883_ = _e1305.x;
                                                }
                                                let _e1312 = phi_1883_;
                                                if (_e1303.y > _e1305.y) {
                                                    phi_1892_ = _e1303.y;
                                                } else {
                                                    phi_1892_ = _e1305.y;
                                                }
                                                let _e1319 = phi_1892_;
                                                if (_e1303.z > _e1305.z) {
                                                    phi_1901_ = _e1303.z;
                                                } else {
                                                    phi_1901_ = _e1305.z;
                                                }
                                                let _e1326 = phi_1901_;
                                                let _e1328 = triangles.member[(0u + _e973)].v2_;
                                                if (_e1312 > _e1328.x) {
                                                    phi_1910_ = _e1312;
                                                } else {
                                                    phi_1910_ = _e1328.x;
                                                }
                                                let _e1333 = phi_1910_;
                                                if (_e1319 > _e1328.y) {
                                                    phi_1917_ = _e1319;
                                                } else {
                                                    phi_1917_ = _e1328.y;
                                                }
                                                let _e1338 = phi_1917_;
                                                if (_e1326 > _e1328.z) {
                                                    phi_1924_ = _e1326;
                                                } else {
                                                    phi_1924_ = _e1328.z;
                                                }
                                                let _e1343 = phi_1924_;
                                                let _e1347 = ((_e1291 - _e131) * _e288);
                                                let _e1348 = ((_e1296 - _e133) * _e298);
                                                let _e1349 = ((_e1301 - _e135) * _e308);
                                                let _e1353 = ((_e1333 - _e131) * _e288);
                                                let _e1354 = ((_e1338 - _e133) * _e298);
                                                let _e1355 = ((_e1343 - _e135) * _e308);
                                                if (_e1347 < _e1353) {
                                                    phi_1941_ = _e1347;
                                                } else {
                                                    phi_1941_ = _e1353;
                                                }
                                                let _e1358 = phi_1941_;
                                                if (_e1348 < _e1354) {
                                                    phi_1946_ = _e1348;
                                                } else {
                                                    phi_1946_ = _e1354;
                                                }
                                                let _e1361 = phi_1946_;
                                                if (_e1349 < _e1355) {
                                                    phi_1951_ = _e1349;
                                                } else {
                                                    phi_1951_ = _e1355;
                                                }
                                                let _e1364 = phi_1951_;
                                                if (_e1347 > _e1353) {
                                                    phi_1959_ = _e1347;
                                                } else {
                                                    phi_1959_ = _e1353;
                                                }
                                                let _e1370 = phi_1959_;
                                                if (_e1348 > _e1354) {
                                                    phi_1964_ = _e1348;
                                                } else {
                                                    phi_1964_ = _e1354;
                                                }
                                                let _e1373 = phi_1964_;
                                                if (_e1349 > _e1355) {
                                                    phi_1969_ = _e1349;
                                                } else {
                                                    phi_1969_ = _e1355;
                                                }
                                                let _e1376 = phi_1969_;
                                                let _e1380 = core_intrinsics_maximum_number_nsz_f32_((_e1358 - _e343), (_e1361 - _e344));
                                                let _e1381 = core_intrinsics_maximum_number_nsz_f32_(_e1380, (_e1364 - _e345));
                                                let _e1382 = core_intrinsics_minimum_number_nsz_f32_((_e1370 + _e343), (_e1373 + _e344));
                                                let _e1383 = core_intrinsics_minimum_number_nsz_f32_(_e1382, (_e1376 + _e345));
                                                if (_e1381 > -300000000000000000000000000000000000000f) {
                                                    phi_1981_ = _e1381;
                                                } else {
                                                    phi_1981_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1386 = phi_1981_;
                                                if (_e1383 < 300000000000000000000000000000000000000f) {
                                                    phi_1986_ = _e1383;
                                                } else {
                                                    phi_1986_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1389 = phi_1986_;
                                                if (_e1257 < _e1386) {
                                                    phi_1991_ = _e1386;
                                                } else {
                                                    phi_1991_ = _e1257;
                                                }
                                                let _e1392 = phi_1991_;
                                                if (_e1392 > _e1389) {
                                                    phi_1996_ = _e1389;
                                                } else {
                                                    phi_1996_ = _e1392;
                                                }
                                                let _e1395 = phi_1996_;
                                                phi_2001_ = lt_bvh_triangle_Intersection(_e1395, (_e1098 / _e1157), (_e1119 / _e1157), (_e1386 <= _e1389));
                                                phi_2002_ = false;
                                            } else {
                                                phi_2001_ = lt_bvh_triangle_Intersection();
                                                phi_2002_ = true;
                                            }
                                            let _e1401 = phi_2001_;
                                            let _e1403 = phi_2002_;
                                            phi_2003_ = _e1401;
                                            phi_2004_ = _e1403;
                                        } else {
                                            phi_2003_ = lt_bvh_triangle_Intersection();
                                            phi_2004_ = true;
                                        }
                                        let _e1405 = phi_2003_;
                                        let _e1407 = phi_2004_;
                                        if _e1407 {
                                        }
                                        phi_2008_ = _e1405;
                                        phi_2009_ = _e1407;
                                    }
                                    let _e1409 = phi_2008_;
                                    let _e1411 = phi_2009_;
                                    phi_2010_ = _e1409;
                                    phi_2011_ = _e1160;
                                    phi_2012_ = _e1411;
                                } else {
                                    phi_2010_ = lt_bvh_triangle_Intersection();
                                    phi_2011_ = true;
                                    phi_2012_ = false;
                                }
                                let _e1413 = phi_2010_;
                                let _e1415 = phi_2011_;
                                let _e1417 = phi_2012_;
                                if _e1415 {
                                    phi_2016_ = true;
                                } else {
                                    phi_2016_ = _e1417;
                                }
                                let _e1419 = phi_2016_;
                                if _e1419 {
                                    phi_2020_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2020_ = _e1413;
                                }
                                let _e1421 = phi_2020_;
                                if _e1421.is_hit {
                                    if (_e1421.t > 0f) {
                                        if (_e1421.t < _e139) {
                                            let _e1428 = triangles.member[(0u + _e973)].i0_;
                                            if ((_e1428 & 2147483648u) == 0u) {
                                                phi_2239_ = true;
                                            } else {
                                                if (_e973 < _e79) {
                                                } else {
                                                    return;
                                                }
                                                let _e1437 = triangles.member[(0u + _e973)].i0_;
                                                let _e1438 = (_e1437 & 2147483647u);
                                                let _e1440 = triangles.member[(0u + _e973)].i1_;
                                                let _e1442 = triangles.member[(0u + _e973)].i2_;
                                                if (_e1438 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1446 = vertices.member[(0u + _e1438)];
                                                if (_e1440 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1450 = vertices.member[(0u + _e1440)];
                                                if (_e1442 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1454 = vertices.member[(0u + _e1442)];
                                                let _e1455 = array<abi_Vertex, 3>(_e1446, _e1450, _e1454);
                                                if (_e1455[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1461 = materials.member[(0u + _e1455[0].material)];
                                                if ((_e1461.flags & 1u) == 1u) {
                                                    let _e1466 = ((1f - _e1421.u) - _e1421.v);
                                                    if (_e1461.cutoff <= 0f) {
                                                        phi_2237_ = true;
                                                    } else {
                                                        let _e1493 = (_e1461.base_color.w * ((((f32((_e1455[0].color >> bitcast<u32>(24i))) * _e1466) + (f32((_e1455[1].color >> bitcast<u32>(24i))) * _e1421.u)) + (f32((_e1455[2].color >> bitcast<u32>(24i))) * _e1421.v)) * (1f / 255f)));
                                                        if (_e1461.alpha_size == 0u) {
                                                            phi_2234_ = _e1493;
                                                        } else {
                                                            local.offset = _e1461.alpha_offset;
                                                            local.size = _e1461.alpha_size;
                                                            local.flags = _e1461.flags;
                                                            let _e1524 = _lt_shaders_texture_TextureView_quad((&local), (((_e1455[0].u * _e1466) + (_e1455[1].u * _e1421.u)) + (_e1455[2].u * _e1421.v)), (((_e1455[0].v * _e1466) + (_e1455[1].v * _e1421.u)) + (_e1455[2].v * _e1421.v)));
                                                            let _e1528 = (_e1524.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1528 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1532 = alpha_texels.member[(0u + _e1528)];
                                                            let _e1548 = (_e1524.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1548 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1552 = alpha_texels.member[(0u + _e1548)];
                                                            let _e1569 = (_e1524.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1569 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1573 = alpha_texels.member[(0u + _e1569)];
                                                            let _e1590 = (_e1524.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1590 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1594 = alpha_texels.member[(0u + _e1590)];
                                                            phi_2234_ = (_e1493 * (((((f32(((_e1532 >> bitcast<u32>((((_e1524.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.x) + ((f32(((_e1552 >> bitcast<u32>((((_e1524.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.y)) + ((f32(((_e1573 >> bitcast<u32>((((_e1524.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.z)) + ((f32(((_e1594 >> bitcast<u32>((((_e1524.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.w)));
                                                        }
                                                        let _e1610 = phi_2234_;
                                                        phi_2237_ = (_e1610 >= _e1461.cutoff);
                                                    }
                                                    let _e1614 = phi_2237_;
                                                    phi_2238_ = _e1614;
                                                } else {
                                                    phi_2238_ = false;
                                                }
                                                let _e1616 = phi_2238_;
                                                phi_2239_ = _e1616;
                                            }
                                            let _e1618 = phi_2239_;
                                            if _e1618 {
                                                phi_2243_ = false;
                                            } else {
                                                phi_2243_ = true;
                                            }
                                            let _e1620 = phi_2243_;
                                            phi_2244_ = _e1618;
                                            phi_2245_ = _e1618;
                                            phi_2246_ = _e1620;
                                        } else {
                                            phi_2244_ = bool();
                                            phi_2245_ = _e964;
                                            phi_2246_ = true;
                                        }
                                        let _e1622 = phi_2244_;
                                        let _e1624 = phi_2245_;
                                        let _e1626 = phi_2246_;
                                        phi_2247_ = _e1622;
                                        phi_2248_ = _e1624;
                                        phi_2249_ = _e1626;
                                    } else {
                                        phi_2247_ = bool();
                                        phi_2248_ = _e964;
                                        phi_2249_ = true;
                                    }
                                    let _e1628 = phi_2247_;
                                    let _e1630 = phi_2248_;
                                    let _e1632 = phi_2249_;
                                    phi_2250_ = _e1628;
                                    phi_2251_ = _e1630;
                                    phi_2252_ = _e1632;
                                } else {
                                    phi_2250_ = bool();
                                    phi_2251_ = _e964;
                                    phi_2252_ = true;
                                }
                                let _e1634 = phi_2250_;
                                let _e1636 = phi_2251_;
                                let _e1638 = phi_2252_;
                                if _e1638 {
                                }
                                phi_1450_ = (_e962 & (_e962 - 1u));
                                phi_1453_ = _e1636;
                                phi_2256_ = _e1634;
                                phi_2257_ = _e1638;
                            }
                            let _e1640 = phi_1450_;
                            let _e1642 = phi_1453_;
                            let _e1644 = phi_2256_;
                            let _e1646 = phi_2257_;
                            local_8 = _e1644;
                            continue;
                            continuing {
                                phi_1449_ = _e1640;
                                phi_1452_ = _e1642;
                                break if !(_e1646);
                            }
                        }
                        let _e1649 = local_5;
                        if _e1649 {
                            let _e1651 = local_1.group_mask;
                            if ((_e1651 & 4278190080u) == 0u) {
                                let _e1655 = local_1.len;
                                if (_e1655 == 0u) {
                                    phi_2299_ = false;
                                } else {
                                    let _e1659 = local_1.len;
                                    local_1.len = (_e1659 - 1u);
                                    let _e1662 = local_1.len;
                                    if (_e1662 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1667 = local_1.first[(0u + _e1662)];
                                    local_1.group = _e1667;
                                    let _e1670 = local_1.len;
                                    if (_e1670 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1675 = local_1.mask[(0u + _e1670)];
                                    local_1.group_mask = _e1675;
                                    phi_2299_ = true;
                                }
                                let _e1678 = phi_2299_;
                                phi_2300_ = _e1678;
                            } else {
                                phi_2300_ = true;
                            }
                            let _e1680 = phi_2300_;
                            if _e1680 {
                                let _e1682 = local_1.group_mask;
                                let _e1688 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1682)), 32u, (_e1682 == 0u)));
                                let _e1692 = local_1.group_mask;
                                let _e1706 = local_1.group_mask;
                                local_1.group_mask = (_e1706 & ~((1u << bitcast<u32>((_e1688 & 31u)))));
                                let _e1709 = local_1.group;
                                phi_2331_ = (_e1709 + countOneBits(((_e1692 & ~((4294967295u << bitcast<u32>((((_e1688 - 24u) ^ _e386) & 31u))))) & 255u)));
                            } else {
                                phi_2331_ = 4294967295u;
                            }
                            let _e1712 = phi_2331_;
                            phi_2332_ = _e1712;
                        } else {
                            phi_2332_ = u32();
                        }
                        let _e1714 = phi_2332_;
                        phi_1118_ = _e1714;
                        let _e1948 = local_7;
                        phi_1121_ = _e1948;
                        let _e1951 = local_8;
                        phi_2333_ = _e1951;
                        let _e1954 = local_9;
                        phi_2334_ = _e1954;
                        phi_2335_ = false;
                    } else {
                        phi_1118_ = u32();
                        phi_1121_ = bool();
                        phi_2333_ = bool();
                        phi_2334_ = false;
                        phi_2335_ = true;
                    }
                    let _e1716 = phi_1118_;
                    let _e1718 = phi_1121_;
                    let _e1720 = phi_2333_;
                    let _e1722 = phi_2334_;
                    let _e1724 = phi_2335_;
                    local_6 = _e1724;
                    local_10 = _e1720;
                    continue;
                    continuing {
                        phi_1117_ = _e1716;
                        phi_1120_ = _e1718;
                        break if !(_e1722);
                    }
                }
                let _e1727 = local_6;
                if _e1727 {
                    phi_2339_ = false;
                } else {
                    phi_2339_ = true;
                }
                let _e1729 = phi_2339_;
                if _e1729 {
                    let _e1960 = local_10;
                    phi_2343_ = _e1960;
                } else {
                    let _e1962 = local_11;
                    phi_2343_ = _e1962;
                }
                let _e1731 = phi_2343_;
                phi_2344_ = _e1731;
            }
            let _e1733 = phi_2344_;
            phi_2345_ = _e1733;
            phi_2346_ = _e212;
        } else {
            phi_2345_ = bool();
            phi_2346_ = true;
        }
        let _e1735 = phi_2345_;
        let _e1737 = phi_2346_;
        if _e1737 {
            phi_2350_ = false;
        } else {
            phi_2350_ = _e1735;
        }
        let _e1739 = phi_2350_;
        if _e1739 {
            phi_2354_ = 0f;
        } else {
            phi_2354_ = 1f;
        }
        let _e1741 = phi_2354_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e1741;
        if (_e110 < _e88) {
        } else {
            return;
        }
        let _e1748 = bits.member[(0u + _e110)];
        if ((_e1748 & 2u) == 0u) {
            phi_2375_ = (_e1748 & 1u);
        } else {
            phi_2375_ = (_e1748 & 7u);
        }
        let _e1754 = phi_2375_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        let _e1758 = visibility.member[(0u + _e110)];
        if ((_e1754 & 1u) != 0u) {
            phi_2390_ = (2u | 1u);
        } else {
            phi_2390_ = 2u;
        }
        let _e1764 = phi_2390_;
        if (_e1758 < 0.5f) {
            phi_2395_ = (_e1764 | 4u);
        } else {
            phi_2395_ = _e1764;
        }
        let _e1767 = phi_2395_;
        if (_e110 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e110)] = _e1767;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
