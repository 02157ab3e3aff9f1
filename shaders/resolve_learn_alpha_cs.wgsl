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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
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
    var phi_194_: bool;
    var phi_198_: f32;

    if (param != param) {
        phi_194_ = true;
    } else {
        let _e70 = (param_1 >= param);
        if _e70 {
        }
        phi_194_ = _e70;
    }
    let _e72 = phi_194_;
    if _e72 {
        phi_198_ = param_1;
    } else {
        phi_198_ = param;
    }
    let _e74 = phi_198_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_210_: bool;
    var phi_214_: f32;

    if (param_2 != param_2) {
        phi_210_ = true;
    } else {
        let _e70 = (param_3 <= param_2);
        if _e70 {
        }
        phi_210_ = _e70;
    }
    let _e72 = phi_210_;
    if _e72 {
        phi_214_ = param_3;
    } else {
        phi_214_ = param_2;
    }
    let _e74 = phi_214_;
    return _e74;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_256_: f32;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_268_: f32;
    var phi_294_: f32;
    var phi_299_: f32;
    var phi_300_: bool;
    var phi_301_: f32;
    var phi_302_: bool;
    var phi_306_: f32;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_344_: u32;
    var phi_358_: u32;
    var phi_365_: u32;
    var phi_370_: u32;
    var phi_376_: u32;
    var phi_381_: u32;
    var phi_383_: texture_Axis;
    var phi_411_: f32;
    var phi_416_: f32;
    var phi_417_: bool;
    var phi_418_: f32;
    var phi_419_: bool;
    var phi_423_: f32;
    var phi_449_: f32;
    var phi_454_: f32;
    var phi_455_: bool;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_461_: f32;
    var phi_469_: f32;
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_499_: u32;
    var phi_513_: u32;
    var phi_520_: u32;
    var phi_525_: u32;
    var phi_531_: u32;
    var phi_536_: u32;
    var phi_538_: texture_Axis;

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
                phi_256_ = 1f;
            } else {
                phi_256_ = 0f;
            }
            let _e101 = phi_256_;
            if (param_5 < 8388608f) {
                phi_261_ = (_e98 - _e101);
                phi_262_ = false;
            } else {
                phi_261_ = f32();
                phi_262_ = true;
            }
            let _e104 = phi_261_;
            let _e106 = phi_262_;
            phi_263_ = _e104;
            phi_264_ = _e106;
        } else {
            phi_263_ = f32();
            phi_264_ = true;
        }
        let _e108 = phi_263_;
        let _e110 = phi_264_;
        if _e110 {
            phi_268_ = param_5;
        } else {
            phi_268_ = _e108;
        }
        let _e112 = phi_268_;
        phi_316_ = (param_5 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_5 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_294_ = 1f;
                } else {
                    phi_294_ = 0f;
                }
                let _e130 = phi_294_;
                if (_e115 < 8388608f) {
                    phi_299_ = (_e127 - _e130);
                    phi_300_ = false;
                } else {
                    phi_299_ = f32();
                    phi_300_ = true;
                }
                let _e133 = phi_299_;
                let _e135 = phi_300_;
                phi_301_ = _e133;
                phi_302_ = _e135;
            } else {
                phi_301_ = f32();
                phi_302_ = true;
            }
            let _e137 = phi_301_;
            let _e139 = phi_302_;
            if _e139 {
                phi_306_ = _e115;
            } else {
                phi_306_ = _e137;
            }
            let _e141 = phi_306_;
            let _e143 = (param_5 - (2f * _e141));
            if (_e143 > 1f) {
                phi_314_ = (2f - _e143);
            } else {
                phi_314_ = _e143;
            }
            let _e147 = phi_314_;
            phi_315_ = _e147;
        } else {
            phi_315_ = param_5;
        }
        let _e149 = phi_315_;
        phi_316_ = _e149;
    }
    let _e151 = phi_316_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_325_ = _e151;
        } else {
            phi_325_ = 1f;
        }
        let _e155 = phi_325_;
        phi_326_ = _e155;
    } else {
        phi_326_ = 0f;
    }
    let _e157 = phi_326_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_344_ = _e158;
        } else {
            phi_344_ = _e167;
        }
        let _e170 = phi_344_;
        phi_383_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_358_ = _e72;
        } else {
            phi_358_ = _e179;
        }
        let _e182 = phi_358_;
        if (_e85 == 0u) {
            phi_365_ = _e158;
        } else {
            phi_365_ = 0u;
        }
        let _e187 = phi_365_;
        if (_e85 == 0u) {
            phi_370_ = 0u;
        } else {
            phi_370_ = _e158;
        }
        let _e190 = phi_370_;
        if (_e182 == 0u) {
            phi_376_ = _e187;
        } else {
            phi_376_ = (_e182 - 1u);
        }
        let _e194 = phi_376_;
        if (_e182 > _e158) {
            phi_381_ = _e190;
        } else {
            phi_381_ = _e182;
        }
        let _e197 = phi_381_;
        phi_383_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_383_;
    let _e202 = (*param_4).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_6 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e218 > param_6) {
                phi_411_ = 1f;
            } else {
                phi_411_ = 0f;
            }
            let _e221 = phi_411_;
            if (param_6 < 8388608f) {
                phi_416_ = (_e218 - _e221);
                phi_417_ = false;
            } else {
                phi_416_ = f32();
                phi_417_ = true;
            }
            let _e224 = phi_416_;
            let _e226 = phi_417_;
            phi_418_ = _e224;
            phi_419_ = _e226;
        } else {
            phi_418_ = f32();
            phi_419_ = true;
        }
        let _e228 = phi_418_;
        let _e230 = phi_419_;
        if _e230 {
            phi_423_ = param_6;
        } else {
            phi_423_ = _e228;
        }
        let _e232 = phi_423_;
        phi_471_ = (param_6 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_6 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_449_ = 1f;
                } else {
                    phi_449_ = 0f;
                }
                let _e250 = phi_449_;
                if (_e235 < 8388608f) {
                    phi_454_ = (_e247 - _e250);
                    phi_455_ = false;
                } else {
                    phi_454_ = f32();
                    phi_455_ = true;
                }
                let _e253 = phi_454_;
                let _e255 = phi_455_;
                phi_456_ = _e253;
                phi_457_ = _e255;
            } else {
                phi_456_ = f32();
                phi_457_ = true;
            }
            let _e257 = phi_456_;
            let _e259 = phi_457_;
            if _e259 {
                phi_461_ = _e235;
            } else {
                phi_461_ = _e257;
            }
            let _e261 = phi_461_;
            let _e263 = (param_6 - (2f * _e261));
            if (_e263 > 1f) {
                phi_469_ = (2f - _e263);
            } else {
                phi_469_ = _e263;
            }
            let _e267 = phi_469_;
            phi_470_ = _e267;
        } else {
            phi_470_ = param_6;
        }
        let _e269 = phi_470_;
        phi_471_ = _e269;
    }
    let _e271 = phi_471_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_480_ = _e271;
        } else {
            phi_480_ = 1f;
        }
        let _e275 = phi_480_;
        phi_481_ = _e275;
    } else {
        phi_481_ = 0f;
    }
    let _e277 = phi_481_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_499_ = _e278;
        } else {
            phi_499_ = _e287;
        }
        let _e290 = phi_499_;
        phi_538_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_513_ = _e76;
        } else {
            phi_513_ = _e299;
        }
        let _e302 = phi_513_;
        if (_e205 == 0u) {
            phi_520_ = _e278;
        } else {
            phi_520_ = 0u;
        }
        let _e307 = phi_520_;
        if (_e205 == 0u) {
            phi_525_ = 0u;
        } else {
            phi_525_ = _e278;
        }
        let _e310 = phi_525_;
        if (_e302 == 0u) {
            phi_531_ = _e307;
        } else {
            phi_531_ = (_e302 - 1u);
        }
        let _e314 = phi_531_;
        if (_e302 > _e278) {
            phi_536_ = _e310;
        } else {
            phi_536_ = _e302;
        }
        let _e317 = phi_536_;
        phi_538_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_538_;
    let _e324 = (*param_4).offset;
    let _e331 = (*param_4).offset;
    let _e338 = (*param_4).offset;
    let _e345 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
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
    var phi_1119_: bool;
    var phi_1199_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1226_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1253_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1259_: u32;
    var phi_1262_: u32;
    var phi_1276_: u32;
    var phi_1286_: u32;
    var phi_1296_: u32;
    var phi_1314_: u32;
    var phi_1324_: u32;
    var phi_1334_: u32;
    var phi_1370_: u32;
    var phi_1383_: u32;
    var phi_1388_: u32;
    var phi_1389_: u32;
    var phi_1390_: u32;
    var phi_1260_: u32;
    var phi_1263_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1448_: u32;
    var phi_1451_: bool;
    var phi_1495_: vec3<f32>;
    var phi_1496_: vec3<f32>;
    var phi_1525_: vec3<f32>;
    var phi_1526_: vec3<f32>;
    var phi_1555_: vec3<f32>;
    var phi_1556_: vec3<f32>;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1579_: f32;
    var phi_1580_: f32;
    var phi_1581_: f32;
    var phi_1582_: f32;
    var phi_1590_: f32;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1608_: f32;
    var phi_1616_: f32;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1631_: f32;
    var phi_1632_: f32;
    var phi_1633_: f32;
    var phi_1634_: f32;
    var phi_1642_: f32;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1659_: f32;
    var phi_1660_: bool;
    var phi_1661_: f32;
    var phi_1662_: bool;
    var phi_1680_: f32;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: f32;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1689_: bool;
    var phi_1690_: f32;
    var phi_1691_: bool;
    var phi_1719_: vec3<f32>;
    var phi_1720_: vec3<f32>;
    var phi_1745_: vec3<f32>;
    var phi_1746_: vec3<f32>;
    var phi_1771_: vec3<f32>;
    var phi_1772_: vec3<f32>;
    var phi_1828_: f32;
    var phi_1837_: f32;
    var phi_1846_: f32;
    var phi_1855_: f32;
    var phi_1862_: f32;
    var phi_1869_: f32;
    var phi_1882_: f32;
    var phi_1891_: f32;
    var phi_1900_: f32;
    var phi_1909_: f32;
    var phi_1916_: f32;
    var phi_1923_: f32;
    var phi_1940_: f32;
    var phi_1945_: f32;
    var phi_1950_: f32;
    var phi_1958_: f32;
    var phi_1963_: f32;
    var phi_1968_: f32;
    var phi_1980_: f32;
    var phi_1985_: f32;
    var phi_1990_: f32;
    var phi_1995_: f32;
    var phi_2000_: lt_bvh_triangle_Intersection;
    var phi_2001_: bool;
    var phi_2002_: lt_bvh_triangle_Intersection;
    var phi_2003_: bool;
    var phi_2007_: lt_bvh_triangle_Intersection;
    var phi_2008_: bool;
    var phi_2009_: lt_bvh_triangle_Intersection;
    var phi_2010_: bool;
    var phi_2011_: bool;
    var phi_2015_: bool;
    var phi_2019_: lt_bvh_triangle_Intersection;
    var phi_2233_: f32;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2238_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_1449_: u32;
    var phi_1452_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var local_5: bool;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var phi_2330_: u32;
    var phi_2331_: u32;
    var phi_1117_: u32;
    var phi_1120_: bool;
    var phi_2332_: bool;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var local_6: bool;
    var phi_2338_: bool;
    var phi_2342_: bool;
    var phi_2343_: bool;
    var phi_2344_: bool;
    var phi_2345_: bool;
    var phi_2349_: bool;
    var phi_2353_: f32;
    var phi_2374_: u32;
    var phi_2389_: u32;
    var phi_2394_: u32;
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
                phi_2343_ = bool();
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
                phi_1119_ = false;
                loop {
                    let _e524 = phi_1116_;
                    let _e526 = phi_1119_;
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
                            phi_1199_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_bvh_traverse_Tree(_e609.unnamed_1.root, _e586.y));
                        } else {
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e625.unnamed.root, _e586.y), _e625.unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_bvh_traverse_Tree(_e586.z, _e631.unnamed_1.first_primitive));
                            phi_1199_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_bvh_traverse_Tree(_e637.unnamed_1.root, _e586.w));
                        }
                        let _e645 = phi_1199_;
                        let _e655 = nodes.member[(0u + _e524)].y;
                        if (_e298 < 0f) {
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e666.unnamed.root, _e655.w), _e666.unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e655.x, _e672.unnamed_1.first_primitive));
                            phi_1226_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_bvh_traverse_Tree(_e678.unnamed_1.root, _e655.y));
                        } else {
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e694.unnamed.root, _e655.y), _e694.unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e655.z, _e700.unnamed_1.first_primitive));
                            phi_1226_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_bvh_traverse_Tree(_e706.unnamed_1.root, _e655.w));
                        }
                        let _e714 = phi_1226_;
                        let _e724 = nodes.member[(0u + _e524)].z;
                        if (_e308 < 0f) {
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e735.unnamed.root, _e724.w), _e735.unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e724.x, _e741.unnamed_1.first_primitive));
                            phi_1253_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_bvh_traverse_Tree(_e747.unnamed_1.root, _e724.y));
                        } else {
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e763.unnamed.root, _e724.y), _e763.unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e724.z, _e769.unnamed_1.first_primitive));
                            phi_1253_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_bvh_traverse_Tree(_e775.unnamed_1.root, _e724.w));
                        }
                        let _e783 = phi_1253_;
                        phi_1259_ = 0u;
                        phi_1262_ = 0u;
                        loop {
                            let _e793 = phi_1259_;
                            let _e795 = phi_1262_;
                            local_2 = _e795;
                            local_3 = _e795;
                            local_4 = _e795;
                            let _e796 = (_e793 < 8u);
                            if _e796 {
                                let _e798 = (_e793 >> bitcast<u32>(2i));
                                let _e799 = (_e793 & 3u);
                                if (_e798 == 0u) {
                                    phi_1276_ = _e645.unnamed.root;
                                } else {
                                    phi_1276_ = _e645.unnamed.first_primitive;
                                }
                                let _e802 = phi_1276_;
                                if (_e798 == 0u) {
                                    phi_1286_ = _e714.unnamed.root;
                                } else {
                                    phi_1286_ = _e714.unnamed.first_primitive;
                                }
                                let _e811 = phi_1286_;
                                if (_e798 == 0u) {
                                    phi_1296_ = _e783.unnamed.root;
                                } else {
                                    phi_1296_ = _e783.unnamed.first_primitive;
                                }
                                let _e820 = phi_1296_;
                                let _e833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e802 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e336)), ((f32(((_e811 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e337)));
                                let _e834 = core_intrinsics_maximum_number_nsz_f32_(_e833, ((f32(((_e820 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e560) + (_e578 - _e338)));
                                if (_e798 == 0u) {
                                    phi_1314_ = _e645.unnamed_1.root;
                                } else {
                                    phi_1314_ = _e645.unnamed_1.first_primitive;
                                }
                                let _e837 = phi_1314_;
                                if (_e798 == 0u) {
                                    phi_1324_ = _e714.unnamed_1.root;
                                } else {
                                    phi_1324_ = _e714.unnamed_1.first_primitive;
                                }
                                let _e846 = phi_1324_;
                                if (_e798 == 0u) {
                                    phi_1334_ = _e783.unnamed_1.root;
                                } else {
                                    phi_1334_ = _e783.unnamed_1.first_primitive;
                                }
                                let _e855 = phi_1334_;
                                let _e868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e837 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e336)), ((f32(((_e846 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e337)));
                                let _e869 = core_intrinsics_minimum_number_nsz_f32_(_e868, ((f32(((_e855 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u)) * _e560) + (_e578 + _e338)));
                                if (_e834 <= _e869) {
                                    if (_e834 <= _e139) {
                                        if (_e869 >= 0f) {
                                            if (_e798 == 0u) {
                                                let _e876 = nodes.member[(0u + _e524)].links[2u];
                                                phi_1370_ = _e876;
                                            } else {
                                                let _e879 = nodes.member[(0u + _e524)].links[3u];
                                                phi_1370_ = _e879;
                                            }
                                            let _e881 = phi_1370_;
                                            let _e886 = ((_e881 >> bitcast<u32>(((_e799 * 8u) & 31u))) & 255u);
                                            let _e887 = (_e886 & 31u);
                                            if (_e887 >= 24u) {
                                                phi_1383_ = (24u + ((_e887 - 24u) ^ _e386));
                                            } else {
                                                phi_1383_ = _e887;
                                            }
                                            let _e893 = phi_1383_;
                                            phi_1388_ = (_e795 | ((_e886 >> bitcast<u32>(5i)) << bitcast<u32>((_e893 & 31u))));
                                        } else {
                                            phi_1388_ = _e795;
                                        }
                                        let _e901 = phi_1388_;
                                        phi_1389_ = _e901;
                                    } else {
                                        phi_1389_ = _e795;
                                    }
                                    let _e903 = phi_1389_;
                                    phi_1390_ = _e903;
                                } else {
                                    phi_1390_ = _e795;
                                }
                                let _e905 = phi_1390_;
                                phi_1260_ = (_e793 + 1u);
                                phi_1263_ = _e905;
                            } else {
                                phi_1260_ = u32();
                                phi_1263_ = u32();
                            }
                            let _e908 = phi_1260_;
                            let _e910 = phi_1263_;
                            continue;
                            continuing {
                                phi_1259_ = _e908;
                                phi_1262_ = _e910;
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
                        phi_1448_ = (_e959 & 16777215u);
                        phi_1451_ = _e526;
                        loop {
                            let _e962 = phi_1448_;
                            let _e964 = phi_1451_;
                            local_7 = _e964;
                            let _e965 = (_e962 == 0u);
                            local_5 = _e965;
                            local_9 = _e965;
                            if _e965 {
                                phi_1449_ = u32();
                                phi_1452_ = bool();
                                phi_2255_ = bool();
                                phi_2256_ = false;
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
                                    phi_1496_ = vec3<f32>(_e984, _e986, _e982);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1495_ = vec3<f32>(_e986, _e982, _e984);
                                    } else {
                                        phi_1495_ = (_e980 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e994 = phi_1495_;
                                    phi_1496_ = _e994;
                                }
                                let _e996 = phi_1496_;
                                let _e1000 = (_e996.x - (_e370 * _e996.z));
                                let _e1004 = (_e996.y - (_e373 * _e996.z));
                                let _e1006 = triangles.member[(0u + _e973)].v1_;
                                let _e1008 = (_e1006.x - _e131);
                                let _e1010 = (_e1006.y - _e133);
                                let _e1012 = (_e1006.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1526_ = vec3<f32>(_e1010, _e1012, _e1008);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1525_ = vec3<f32>(_e1012, _e1008, _e1010);
                                    } else {
                                        phi_1525_ = (_e1006 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1020 = phi_1525_;
                                    phi_1526_ = _e1020;
                                }
                                let _e1022 = phi_1526_;
                                let _e1026 = (_e1022.x - (_e370 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e373 * _e1022.z));
                                let _e1032 = triangles.member[(0u + _e973)].v2_;
                                let _e1034 = (_e1032.x - _e131);
                                let _e1036 = (_e1032.y - _e133);
                                let _e1038 = (_e1032.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1556_ = vec3<f32>(_e1036, _e1038, _e1034);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1555_ = vec3<f32>(_e1038, _e1034, _e1036);
                                    } else {
                                        phi_1555_ = (_e1032 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1046 = phi_1555_;
                                    phi_1556_ = _e1046;
                                }
                                let _e1048 = phi_1556_;
                                let _e1052 = (_e1048.x - (_e370 * _e1048.z));
                                let _e1056 = (_e1048.y - (_e373 * _e1048.z));
                                if (_e1026 < _e1052) {
                                    phi_1575_ = true;
                                } else {
                                    if (_e1026 == _e1052) {
                                        phi_1574_ = (_e1030 < _e1056);
                                    } else {
                                        phi_1574_ = false;
                                    }
                                    let _e1061 = phi_1574_;
                                    phi_1575_ = _e1061;
                                }
                                let _e1063 = phi_1575_;
                                if _e1063 {
                                    phi_1579_ = _e1056;
                                    phi_1580_ = _e1052;
                                    phi_1581_ = _e1030;
                                    phi_1582_ = _e1026;
                                } else {
                                    phi_1579_ = _e1030;
                                    phi_1580_ = _e1026;
                                    phi_1581_ = _e1056;
                                    phi_1582_ = _e1052;
                                }
                                let _e1065 = phi_1579_;
                                let _e1067 = phi_1580_;
                                let _e1069 = phi_1581_;
                                let _e1071 = phi_1582_;
                                let _e1074 = ((_e1071 * _e1065) - (_e1069 * _e1067));
                                if _e1063 {
                                    phi_1590_ = -(_e1074);
                                } else {
                                    phi_1590_ = _e1074;
                                }
                                let _e1077 = phi_1590_;
                                if (_e1052 < _e1000) {
                                    phi_1601_ = true;
                                } else {
                                    if (_e1052 == _e1000) {
                                        phi_1600_ = (_e1056 < _e1004);
                                    } else {
                                        phi_1600_ = false;
                                    }
                                    let _e1082 = phi_1600_;
                                    phi_1601_ = _e1082;
                                }
                                let _e1084 = phi_1601_;
                                if _e1084 {
                                    phi_1605_ = _e1004;
                                    phi_1606_ = _e1000;
                                    phi_1607_ = _e1056;
                                    phi_1608_ = _e1052;
                                } else {
                                    phi_1605_ = _e1056;
                                    phi_1606_ = _e1052;
                                    phi_1607_ = _e1004;
                                    phi_1608_ = _e1000;
                                }
                                let _e1086 = phi_1605_;
                                let _e1088 = phi_1606_;
                                let _e1090 = phi_1607_;
                                let _e1092 = phi_1608_;
                                let _e1095 = ((_e1092 * _e1086) - (_e1090 * _e1088));
                                if _e1084 {
                                    phi_1616_ = -(_e1095);
                                } else {
                                    phi_1616_ = _e1095;
                                }
                                let _e1098 = phi_1616_;
                                if (_e1000 < _e1026) {
                                    phi_1627_ = true;
                                } else {
                                    if (_e1000 == _e1026) {
                                        phi_1626_ = (_e1004 < _e1030);
                                    } else {
                                        phi_1626_ = false;
                                    }
                                    let _e1103 = phi_1626_;
                                    phi_1627_ = _e1103;
                                }
                                let _e1105 = phi_1627_;
                                if _e1105 {
                                    phi_1631_ = _e1030;
                                    phi_1632_ = _e1026;
                                    phi_1633_ = _e1004;
                                    phi_1634_ = _e1000;
                                } else {
                                    phi_1631_ = _e1004;
                                    phi_1632_ = _e1000;
                                    phi_1633_ = _e1030;
                                    phi_1634_ = _e1026;
                                }
                                let _e1107 = phi_1631_;
                                let _e1109 = phi_1632_;
                                let _e1111 = phi_1633_;
                                let _e1113 = phi_1634_;
                                let _e1116 = ((_e1113 * _e1107) - (_e1111 * _e1109));
                                if _e1105 {
                                    phi_1642_ = -(_e1116);
                                } else {
                                    phi_1642_ = _e1116;
                                }
                                let _e1119 = phi_1642_;
                                if (_e1077 >= 0f) {
                                    if (_e1098 >= 0f) {
                                        if (_e1119 >= 0f) {
                                            phi_1657_ = ((_e1077 + _e1098) + _e1119);
                                            phi_1658_ = false;
                                        } else {
                                            phi_1657_ = f32();
                                            phi_1658_ = true;
                                        }
                                        let _e1126 = phi_1657_;
                                        let _e1128 = phi_1658_;
                                        phi_1659_ = _e1126;
                                        phi_1660_ = _e1128;
                                    } else {
                                        phi_1659_ = f32();
                                        phi_1660_ = true;
                                    }
                                    let _e1130 = phi_1659_;
                                    let _e1132 = phi_1660_;
                                    phi_1661_ = _e1130;
                                    phi_1662_ = _e1132;
                                } else {
                                    phi_1661_ = f32();
                                    phi_1662_ = true;
                                }
                                let _e1134 = phi_1661_;
                                let _e1136 = phi_1662_;
                                if _e1136 {
                                    if (_e1077 <= 0f) {
                                        if (_e1098 <= 0f) {
                                            let _e1139 = (_e1119 <= 0f);
                                            if _e1139 {
                                            }
                                            phi_1680_ = ((_e1077 + _e1098) + _e1119);
                                            phi_1681_ = false;
                                            phi_1682_ = _e1139;
                                        } else {
                                            phi_1680_ = f32();
                                            phi_1681_ = true;
                                            phi_1682_ = false;
                                        }
                                        let _e1143 = phi_1680_;
                                        let _e1145 = phi_1681_;
                                        let _e1147 = phi_1682_;
                                        phi_1683_ = _e1143;
                                        phi_1684_ = _e1145;
                                        phi_1685_ = _e1147;
                                    } else {
                                        phi_1683_ = f32();
                                        phi_1684_ = true;
                                        phi_1685_ = false;
                                    }
                                    let _e1149 = phi_1683_;
                                    let _e1151 = phi_1684_;
                                    let _e1153 = phi_1685_;
                                    if _e1151 {
                                        phi_1689_ = false;
                                    } else {
                                        phi_1689_ = _e1153;
                                    }
                                    let _e1155 = phi_1689_;
                                    phi_1690_ = _e1149;
                                    phi_1691_ = _e1155;
                                } else {
                                    phi_1690_ = _e1134;
                                    phi_1691_ = true;
                                }
                                let _e1157 = phi_1690_;
                                let _e1159 = phi_1691_;
                                if _e1159 {
                                    let _e1160 = (_e1157 == 0f);
                                    if _e1160 {
                                        phi_2007_ = lt_bvh_triangle_Intersection();
                                        phi_2008_ = false;
                                    } else {
                                        let _e1162 = triangles.member[(0u + _e973)].v0_;
                                        let _e1164 = (_e1162.x - _e131);
                                        let _e1166 = (_e1162.y - _e133);
                                        let _e1168 = (_e1162.z - _e135);
                                        if (_e359 == 0u) {
                                            phi_1720_ = vec3<f32>(_e1166, _e1168, _e1164);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1719_ = vec3<f32>(_e1168, _e1164, _e1166);
                                            } else {
                                                phi_1719_ = (_e1162 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1176 = phi_1719_;
                                            phi_1720_ = _e1176;
                                        }
                                        let _e1178 = phi_1720_;
                                        let _e1180 = triangles.member[(0u + _e973)].v1_;
                                        let _e1182 = triangles.member[(0u + _e973)].v0_;
                                        let _e1185 = (_e1180.x - _e1182.x);
                                        let _e1188 = (_e1180.y - _e1182.y);
                                        let _e1191 = (_e1180.z - _e1182.z);
                                        if (_e359 == 0u) {
                                            phi_1746_ = vec3<f32>(_e1188, _e1191, _e1185);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1745_ = vec3<f32>(_e1191, _e1185, _e1188);
                                            } else {
                                                phi_1745_ = (_e1180 - _e1182);
                                            }
                                            let _e1198 = phi_1745_;
                                            phi_1746_ = _e1198;
                                        }
                                        let _e1200 = phi_1746_;
                                        let _e1202 = triangles.member[(0u + _e973)].v2_;
                                        let _e1204 = triangles.member[(0u + _e973)].v0_;
                                        let _e1207 = (_e1202.x - _e1204.x);
                                        let _e1210 = (_e1202.y - _e1204.y);
                                        let _e1213 = (_e1202.z - _e1204.z);
                                        if (_e359 == 0u) {
                                            phi_1772_ = vec3<f32>(_e1210, _e1213, _e1207);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1771_ = vec3<f32>(_e1213, _e1207, _e1210);
                                            } else {
                                                phi_1771_ = (_e1202 - _e1204);
                                            }
                                            let _e1220 = phi_1771_;
                                            phi_1772_ = _e1220;
                                        }
                                        let _e1222 = phi_1772_;
                                        let _e1229 = ((_e1200.y * _e1222.z) - (_e1200.z * _e1222.y));
                                        let _e1236 = ((_e1200.z * _e1222.x) - (_e1200.x * _e1222.z));
                                        let _e1243 = ((_e1200.x * _e1222.y) - (_e1200.y * _e1222.x));
                                        let _e1257 = (((1f / _e367.z) * (((_e1229 * _e1178.x) + (_e1236 * _e1178.y)) + (_e1243 * _e1178.z))) / (((_e1229 * _e370) + (_e1236 * _e373)) + _e1243));
                                        if (_e1257 > 0f) {
                                            if (_e1257 < _e139) {
                                                let _e1261 = triangles.member[(0u + _e973)].v0_;
                                                let _e1263 = triangles.member[(0u + _e973)].v1_;
                                                if (_e1261.x < _e1263.x) {
                                                    phi_1828_ = _e1261.x;
                                                } else {
                                                    phi_1828_ = _e1263.x;
                                                }
                                                let _e1270 = phi_1828_;
                                                if (_e1261.y < _e1263.y) {
                                                    phi_1837_ = _e1261.y;
                                                } else {
                                                    phi_1837_ = _e1263.y;
                                                }
                                                let _e1277 = phi_1837_;
                                                if (_e1261.z < _e1263.z) {
                                                    phi_1846_ = _e1261.z;
                                                } else {
                                                    phi_1846_ = _e1263.z;
                                                }
                                                let _e1284 = phi_1846_;
                                                let _e1286 = triangles.member[(0u + _e973)].v2_;
                                                if (_e1270 < _e1286.x) {
                                                    phi_1855_ = _e1270;
                                                } else {
                                                    phi_1855_ = _e1286.x;
                                                }
                                                let _e1291 = phi_1855_;
                                                if (_e1277 < _e1286.y) {
                                                    phi_1862_ = _e1277;
                                                } else {
                                                    phi_1862_ = _e1286.y;
                                                }
                                                let _e1296 = phi_1862_;
                                                if (_e1284 < _e1286.z) {
                                                    phi_1869_ = _e1284;
                                                } else {
                                                    phi_1869_ = _e1286.z;
                                                }
                                                let _e1301 = phi_1869_;
                                                let _e1303 = triangles.member[(0u + _e973)].v0_;
                                                let _e1305 = triangles.member[(0u + _e973)].v1_;
                                                if (_e1303.x > _e1305.x) {
                                                    phi_1882_ = _e1303.x;
                                                } else {
                                                    phi_1882_ = _e1305.x;
                                                }
                                                let _e1312 = phi_1882_;
                                                if (_e1303.y > _e1305.y) {
                                                    phi_1891_ = _e1303.y;
                                                } else {
                                                    phi_1891_ = _e1305.y;
                                                }
                                                let _e1319 = phi_1891_;
                                                if (_e1303.z > _e1305.z) {
                                                    phi_1900_ = _e1303.z;
                                                } else {
                                                    phi_1900_ = _e1305.z;
                                                }
                                                let _e1326 = phi_1900_;
                                                let _e1328 = triangles.member[(0u + _e973)].v2_;
                                                if (_e1312 > _e1328.x) {
                                                    phi_1909_ = _e1312;
                                                } else {
                                                    phi_1909_ = _e1328.x;
                                                }
                                                let _e1333 = phi_1909_;
                                                if (_e1319 > _e1328.y) {
                                                    phi_1916_ = _e1319;
                                                } else {
                                                    phi_1916_ = _e1328.y;
                                                }
                                                let _e1338 = phi_1916_;
                                                if (_e1326 > _e1328.z) {
                                                    phi_1923_ = _e1326;
                                                } else {
                                                    phi_1923_ = _e1328.z;
                                                }
                                                let _e1343 = phi_1923_;
                                                let _e1347 = ((_e1291 - _e131) * _e288);
                                                let _e1348 = ((_e1296 - _e133) * _e298);
                                                let _e1349 = ((_e1301 - _e135) * _e308);
                                                let _e1353 = ((_e1333 - _e131) * _e288);
                                                let _e1354 = ((_e1338 - _e133) * _e298);
                                                let _e1355 = ((_e1343 - _e135) * _e308);
                                                if (_e1347 < _e1353) {
                                                    phi_1940_ = _e1347;
                                                } else {
                                                    phi_1940_ = _e1353;
                                                }
                                                let _e1358 = phi_1940_;
                                                if (_e1348 < _e1354) {
                                                    phi_1945_ = _e1348;
                                                } else {
                                                    phi_1945_ = _e1354;
                                                }
                                                let _e1361 = phi_1945_;
                                                if (_e1349 < _e1355) {
                                                    phi_1950_ = _e1349;
                                                } else {
                                                    phi_1950_ = _e1355;
                                                }
                                                let _e1364 = phi_1950_;
                                                if (_e1347 > _e1353) {
                                                    phi_1958_ = _e1347;
                                                } else {
                                                    phi_1958_ = _e1353;
                                                }
                                                let _e1370 = phi_1958_;
                                                if (_e1348 > _e1354) {
                                                    phi_1963_ = _e1348;
                                                } else {
                                                    phi_1963_ = _e1354;
                                                }
                                                let _e1373 = phi_1963_;
                                                if (_e1349 > _e1355) {
                                                    phi_1968_ = _e1349;
                                                } else {
                                                    phi_1968_ = _e1355;
                                                }
                                                let _e1376 = phi_1968_;
                                                let _e1380 = core_intrinsics_maximum_number_nsz_f32_((_e1358 - _e343), (_e1361 - _e344));
                                                let _e1381 = core_intrinsics_maximum_number_nsz_f32_(_e1380, (_e1364 - _e345));
                                                let _e1382 = core_intrinsics_minimum_number_nsz_f32_((_e1370 + _e343), (_e1373 + _e344));
                                                let _e1383 = core_intrinsics_minimum_number_nsz_f32_(_e1382, (_e1376 + _e345));
                                                if (_e1381 > -300000000000000000000000000000000000000f) {
                                                    phi_1980_ = _e1381;
                                                } else {
                                                    phi_1980_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1386 = phi_1980_;
                                                if (_e1383 < 300000000000000000000000000000000000000f) {
                                                    phi_1985_ = _e1383;
                                                } else {
                                                    phi_1985_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1389 = phi_1985_;
                                                if (_e1257 < _e1386) {
                                                    phi_1990_ = _e1386;
                                                } else {
                                                    phi_1990_ = _e1257;
                                                }
                                                let _e1392 = phi_1990_;
                                                if (_e1392 > _e1389) {
                                                    phi_1995_ = _e1389;
                                                } else {
                                                    phi_1995_ = _e1392;
                                                }
                                                let _e1395 = phi_1995_;
                                                phi_2000_ = lt_bvh_triangle_Intersection(_e1395, (_e1098 / _e1157), (_e1119 / _e1157), (_e1386 <= _e1389));
                                                phi_2001_ = false;
                                            } else {
                                                phi_2000_ = lt_bvh_triangle_Intersection();
                                                phi_2001_ = true;
                                            }
                                            let _e1401 = phi_2000_;
                                            let _e1403 = phi_2001_;
                                            phi_2002_ = _e1401;
                                            phi_2003_ = _e1403;
                                        } else {
                                            phi_2002_ = lt_bvh_triangle_Intersection();
                                            phi_2003_ = true;
                                        }
                                        let _e1405 = phi_2002_;
                                        let _e1407 = phi_2003_;
                                        if _e1407 {
                                        }
                                        phi_2007_ = _e1405;
                                        phi_2008_ = _e1407;
                                    }
                                    let _e1409 = phi_2007_;
                                    let _e1411 = phi_2008_;
                                    phi_2009_ = _e1409;
                                    phi_2010_ = _e1160;
                                    phi_2011_ = _e1411;
                                } else {
                                    phi_2009_ = lt_bvh_triangle_Intersection();
                                    phi_2010_ = true;
                                    phi_2011_ = false;
                                }
                                let _e1413 = phi_2009_;
                                let _e1415 = phi_2010_;
                                let _e1417 = phi_2011_;
                                if _e1415 {
                                    phi_2015_ = true;
                                } else {
                                    phi_2015_ = _e1417;
                                }
                                let _e1419 = phi_2015_;
                                if _e1419 {
                                    phi_2019_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2019_ = _e1413;
                                }
                                let _e1421 = phi_2019_;
                                if _e1421.is_hit {
                                    if (_e1421.t > 0f) {
                                        if (_e1421.t < _e139) {
                                            let _e1428 = triangles.member[(0u + _e973)].i0_;
                                            if ((_e1428 & 2147483648u) == 0u) {
                                                phi_2238_ = true;
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
                                                        phi_2236_ = true;
                                                    } else {
                                                        let _e1493 = (_e1461.base_color.w * ((((f32((_e1455[0].color >> bitcast<u32>(24i))) * _e1466) + (f32((_e1455[1].color >> bitcast<u32>(24i))) * _e1421.u)) + (f32((_e1455[2].color >> bitcast<u32>(24i))) * _e1421.v)) * (1f / 255f)));
                                                        if (_e1461.alpha_size == 0u) {
                                                            phi_2233_ = _e1493;
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
                                                            phi_2233_ = (_e1493 * (((((f32(((_e1532 >> bitcast<u32>((((_e1524.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.x) + ((f32(((_e1552 >> bitcast<u32>((((_e1524.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.y)) + ((f32(((_e1573 >> bitcast<u32>((((_e1524.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.z)) + ((f32(((_e1594 >> bitcast<u32>((((_e1524.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1524.weights.w)));
                                                        }
                                                        let _e1610 = phi_2233_;
                                                        phi_2236_ = (_e1610 >= _e1461.cutoff);
                                                    }
                                                    let _e1614 = phi_2236_;
                                                    phi_2237_ = _e1614;
                                                } else {
                                                    phi_2237_ = false;
                                                }
                                                let _e1616 = phi_2237_;
                                                phi_2238_ = _e1616;
                                            }
                                            let _e1618 = phi_2238_;
                                            if _e1618 {
                                                phi_2242_ = false;
                                            } else {
                                                phi_2242_ = true;
                                            }
                                            let _e1620 = phi_2242_;
                                            phi_2243_ = _e1618;
                                            phi_2244_ = _e1618;
                                            phi_2245_ = _e1620;
                                        } else {
                                            phi_2243_ = bool();
                                            phi_2244_ = _e964;
                                            phi_2245_ = true;
                                        }
                                        let _e1622 = phi_2243_;
                                        let _e1624 = phi_2244_;
                                        let _e1626 = phi_2245_;
                                        phi_2246_ = _e1622;
                                        phi_2247_ = _e1624;
                                        phi_2248_ = _e1626;
                                    } else {
                                        phi_2246_ = bool();
                                        phi_2247_ = _e964;
                                        phi_2248_ = true;
                                    }
                                    let _e1628 = phi_2246_;
                                    let _e1630 = phi_2247_;
                                    let _e1632 = phi_2248_;
                                    phi_2249_ = _e1628;
                                    phi_2250_ = _e1630;
                                    phi_2251_ = _e1632;
                                } else {
                                    phi_2249_ = bool();
                                    phi_2250_ = _e964;
                                    phi_2251_ = true;
                                }
                                let _e1634 = phi_2249_;
                                let _e1636 = phi_2250_;
                                let _e1638 = phi_2251_;
                                if _e1638 {
                                }
                                phi_1449_ = (_e962 & (_e962 - 1u));
                                phi_1452_ = _e1636;
                                phi_2255_ = _e1634;
                                phi_2256_ = _e1638;
                            }
                            let _e1640 = phi_1449_;
                            let _e1642 = phi_1452_;
                            let _e1644 = phi_2255_;
                            let _e1646 = phi_2256_;
                            local_8 = _e1644;
                            continue;
                            continuing {
                                phi_1448_ = _e1640;
                                phi_1451_ = _e1642;
                                break if !(_e1646);
                            }
                        }
                        let _e1649 = local_5;
                        if _e1649 {
                            let _e1651 = local_1.group_mask;
                            if ((_e1651 & 4278190080u) == 0u) {
                                let _e1655 = local_1.len;
                                if (_e1655 == 0u) {
                                    phi_2298_ = false;
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
                                    phi_2298_ = true;
                                }
                                let _e1678 = phi_2298_;
                                phi_2299_ = _e1678;
                            } else {
                                phi_2299_ = true;
                            }
                            let _e1680 = phi_2299_;
                            if _e1680 {
                                let _e1682 = local_1.group_mask;
                                let _e1688 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1682)), 32u, (_e1682 == 0u)));
                                let _e1692 = local_1.group_mask;
                                let _e1706 = local_1.group_mask;
                                local_1.group_mask = (_e1706 & ~((1u << bitcast<u32>((_e1688 & 31u)))));
                                let _e1709 = local_1.group;
                                phi_2330_ = (_e1709 + countOneBits(((_e1692 & ~((4294967295u << bitcast<u32>((((_e1688 - 24u) ^ _e386) & 31u))))) & 255u)));
                            } else {
                                phi_2330_ = 4294967295u;
                            }
                            let _e1712 = phi_2330_;
                            phi_2331_ = _e1712;
                        } else {
                            phi_2331_ = u32();
                        }
                        let _e1714 = phi_2331_;
                        phi_1117_ = _e1714;
                        let _e1948 = local_7;
                        phi_1120_ = _e1948;
                        let _e1951 = local_8;
                        phi_2332_ = _e1951;
                        let _e1954 = local_9;
                        phi_2333_ = _e1954;
                        phi_2334_ = false;
                    } else {
                        phi_1117_ = u32();
                        phi_1120_ = bool();
                        phi_2332_ = bool();
                        phi_2333_ = false;
                        phi_2334_ = true;
                    }
                    let _e1716 = phi_1117_;
                    let _e1718 = phi_1120_;
                    let _e1720 = phi_2332_;
                    let _e1722 = phi_2333_;
                    let _e1724 = phi_2334_;
                    local_6 = _e1724;
                    local_10 = _e1720;
                    continue;
                    continuing {
                        phi_1116_ = _e1716;
                        phi_1119_ = _e1718;
                        break if !(_e1722);
                    }
                }
                let _e1727 = local_6;
                if _e1727 {
                    phi_2338_ = false;
                } else {
                    phi_2338_ = true;
                }
                let _e1729 = phi_2338_;
                if _e1729 {
                    let _e1960 = local_10;
                    phi_2342_ = _e1960;
                } else {
                    let _e1962 = local_11;
                    phi_2342_ = _e1962;
                }
                let _e1731 = phi_2342_;
                phi_2343_ = _e1731;
            }
            let _e1733 = phi_2343_;
            phi_2344_ = _e1733;
            phi_2345_ = _e212;
        } else {
            phi_2344_ = bool();
            phi_2345_ = true;
        }
        let _e1735 = phi_2344_;
        let _e1737 = phi_2345_;
        if _e1737 {
            phi_2349_ = false;
        } else {
            phi_2349_ = _e1735;
        }
        let _e1739 = phi_2349_;
        if _e1739 {
            phi_2353_ = 0f;
        } else {
            phi_2353_ = 1f;
        }
        let _e1741 = phi_2353_;
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
            phi_2374_ = (_e1748 & 1u);
        } else {
            phi_2374_ = (_e1748 & 7u);
        }
        let _e1754 = phi_2374_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        let _e1758 = visibility.member[(0u + _e110)];
        if ((_e1754 & 1u) != 0u) {
            phi_2389_ = (2u | 1u);
        } else {
            phi_2389_ = 2u;
        }
        let _e1764 = phi_2389_;
        if (_e1758 < 0.5f) {
            phi_2394_ = (_e1764 | 4u);
        } else {
            phi_2394_ = _e1764;
        }
        let _e1767 = phi_2394_;
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
