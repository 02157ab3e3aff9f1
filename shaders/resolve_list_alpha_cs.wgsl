struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
    member: array<f32>,
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_37 {
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

struct type_41 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_45 {
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

struct type_49 {
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
var<storage> samples: type_19;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(6) 
var<storage> vertices: type_45;
@group(0) @binding(7) 
var<storage> materials: type_49;
@group(0) @binding(8) 
var<storage> alpha_texels: type_9;
@group(0) @binding(5) 
var<storage> list: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_195_: bool;
    var phi_199_: f32;

    if (param != param) {
        phi_195_ = true;
    } else {
        let _e69 = (param_1 >= param);
        if _e69 {
        }
        phi_195_ = _e69;
    }
    let _e71 = phi_195_;
    if _e71 {
        phi_199_ = param_1;
    } else {
        phi_199_ = param;
    }
    let _e73 = phi_199_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_211_: bool;
    var phi_215_: f32;

    if (param_2 != param_2) {
        phi_211_ = true;
    } else {
        let _e69 = (param_3 <= param_2);
        if _e69 {
        }
        phi_211_ = _e69;
    }
    let _e71 = phi_211_;
    if _e71 {
        phi_215_ = param_3;
    } else {
        phi_215_ = param_2;
    }
    let _e73 = phi_215_;
    return _e73;
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

    let _e70 = (*param_4).size;
    let _e71 = (_e70 & 65535u);
    let _e73 = (*param_4).size;
    let _e75 = (_e73 >> bitcast<u32>(16i));
    let _e77 = (*param_4).flags;
    let _e79 = ((_e77 & 4u) != 0u);
    let _e81 = (*param_4).flags;
    let _e84 = ((_e81 >> bitcast<u32>(4u)) & 3u);
    if (_e84 == 0u) {
        if (param_5 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e97 > param_5) {
                phi_257_ = 1f;
            } else {
                phi_257_ = 0f;
            }
            let _e100 = phi_257_;
            if (param_5 < 8388608f) {
                phi_262_ = (_e97 - _e100);
                phi_263_ = false;
            } else {
                phi_262_ = f32();
                phi_263_ = true;
            }
            let _e103 = phi_262_;
            let _e105 = phi_263_;
            phi_264_ = _e103;
            phi_265_ = _e105;
        } else {
            phi_264_ = f32();
            phi_265_ = true;
        }
        let _e107 = phi_264_;
        let _e109 = phi_265_;
        if _e109 {
            phi_269_ = param_5;
        } else {
            phi_269_ = _e107;
        }
        let _e111 = phi_269_;
        phi_317_ = (param_5 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_5 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_295_ = 1f;
                } else {
                    phi_295_ = 0f;
                }
                let _e129 = phi_295_;
                if (_e114 < 8388608f) {
                    phi_300_ = (_e126 - _e129);
                    phi_301_ = false;
                } else {
                    phi_300_ = f32();
                    phi_301_ = true;
                }
                let _e132 = phi_300_;
                let _e134 = phi_301_;
                phi_302_ = _e132;
                phi_303_ = _e134;
            } else {
                phi_302_ = f32();
                phi_303_ = true;
            }
            let _e136 = phi_302_;
            let _e138 = phi_303_;
            if _e138 {
                phi_307_ = _e114;
            } else {
                phi_307_ = _e136;
            }
            let _e140 = phi_307_;
            let _e142 = (param_5 - (2f * _e140));
            if (_e142 > 1f) {
                phi_315_ = (2f - _e142);
            } else {
                phi_315_ = _e142;
            }
            let _e146 = phi_315_;
            phi_316_ = _e146;
        } else {
            phi_316_ = param_5;
        }
        let _e148 = phi_316_;
        phi_317_ = _e148;
    }
    let _e150 = phi_317_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_326_ = _e150;
        } else {
            phi_326_ = 1f;
        }
        let _e154 = phi_326_;
        phi_327_ = _e154;
    } else {
        phi_327_ = 0f;
    }
    let _e156 = phi_327_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_345_ = _e157;
        } else {
            phi_345_ = _e166;
        }
        let _e169 = phi_345_;
        phi_384_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_359_ = _e71;
        } else {
            phi_359_ = _e178;
        }
        let _e181 = phi_359_;
        if (_e84 == 0u) {
            phi_366_ = _e157;
        } else {
            phi_366_ = 0u;
        }
        let _e186 = phi_366_;
        if (_e84 == 0u) {
            phi_371_ = 0u;
        } else {
            phi_371_ = _e157;
        }
        let _e189 = phi_371_;
        if (_e181 == 0u) {
            phi_377_ = _e186;
        } else {
            phi_377_ = (_e181 - 1u);
        }
        let _e193 = phi_377_;
        if (_e181 > _e157) {
            phi_382_ = _e189;
        } else {
            phi_382_ = _e181;
        }
        let _e196 = phi_382_;
        phi_384_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_384_;
    let _e201 = (*param_4).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_6 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e217 > param_6) {
                phi_412_ = 1f;
            } else {
                phi_412_ = 0f;
            }
            let _e220 = phi_412_;
            if (param_6 < 8388608f) {
                phi_417_ = (_e217 - _e220);
                phi_418_ = false;
            } else {
                phi_417_ = f32();
                phi_418_ = true;
            }
            let _e223 = phi_417_;
            let _e225 = phi_418_;
            phi_419_ = _e223;
            phi_420_ = _e225;
        } else {
            phi_419_ = f32();
            phi_420_ = true;
        }
        let _e227 = phi_419_;
        let _e229 = phi_420_;
        if _e229 {
            phi_424_ = param_6;
        } else {
            phi_424_ = _e227;
        }
        let _e231 = phi_424_;
        phi_472_ = (param_6 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_6 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_450_ = 1f;
                } else {
                    phi_450_ = 0f;
                }
                let _e249 = phi_450_;
                if (_e234 < 8388608f) {
                    phi_455_ = (_e246 - _e249);
                    phi_456_ = false;
                } else {
                    phi_455_ = f32();
                    phi_456_ = true;
                }
                let _e252 = phi_455_;
                let _e254 = phi_456_;
                phi_457_ = _e252;
                phi_458_ = _e254;
            } else {
                phi_457_ = f32();
                phi_458_ = true;
            }
            let _e256 = phi_457_;
            let _e258 = phi_458_;
            if _e258 {
                phi_462_ = _e234;
            } else {
                phi_462_ = _e256;
            }
            let _e260 = phi_462_;
            let _e262 = (param_6 - (2f * _e260));
            if (_e262 > 1f) {
                phi_470_ = (2f - _e262);
            } else {
                phi_470_ = _e262;
            }
            let _e266 = phi_470_;
            phi_471_ = _e266;
        } else {
            phi_471_ = param_6;
        }
        let _e268 = phi_471_;
        phi_472_ = _e268;
    }
    let _e270 = phi_472_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_481_ = _e270;
        } else {
            phi_481_ = 1f;
        }
        let _e274 = phi_481_;
        phi_482_ = _e274;
    } else {
        phi_482_ = 0f;
    }
    let _e276 = phi_482_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_500_ = _e277;
        } else {
            phi_500_ = _e286;
        }
        let _e289 = phi_500_;
        phi_539_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_514_ = _e75;
        } else {
            phi_514_ = _e298;
        }
        let _e301 = phi_514_;
        if (_e204 == 0u) {
            phi_521_ = _e277;
        } else {
            phi_521_ = 0u;
        }
        let _e306 = phi_521_;
        if (_e204 == 0u) {
            phi_526_ = 0u;
        } else {
            phi_526_ = _e277;
        }
        let _e309 = phi_526_;
        if (_e301 == 0u) {
            phi_532_ = _e306;
        } else {
            phi_532_ = (_e301 - 1u);
        }
        let _e313 = phi_532_;
        if (_e301 > _e277) {
            phi_537_ = _e309;
        } else {
            phi_537_ = _e301;
        }
        let _e316 = phi_537_;
        phi_539_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_539_;
    let _e323 = (*param_4).offset;
    let _e330 = (*param_4).offset;
    let _e337 = (*param_4).offset;
    let _e344 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_677_: f32;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_735_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_762_: bool;
    var phi_832_: f32;
    var phi_839_: f32;
    var phi_846_: f32;
    var phi_853_: f32;
    var phi_860_: f32;
    var phi_867_: f32;
    var phi_884_: f32;
    var phi_889_: f32;
    var phi_894_: f32;
    var phi_899_: f32;
    var phi_904_: f32;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_939_: u32;
    var phi_940_: u32;
    var phi_951_: vec3<f32>;
    var phi_952_: vec3<f32>;
    var phi_965_: u32;
    var phi_970_: u32;
    var phi_975_: u32;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1121_: u32;
    var phi_1123_: u32;
    var phi_1126_: bool;
    var phi_1206_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1233_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1260_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1266_: u32;
    var phi_1269_: u32;
    var phi_1283_: u32;
    var phi_1293_: u32;
    var phi_1303_: u32;
    var phi_1321_: u32;
    var phi_1331_: u32;
    var phi_1341_: u32;
    var phi_1377_: u32;
    var phi_1390_: u32;
    var phi_1395_: u32;
    var phi_1396_: u32;
    var phi_1397_: u32;
    var phi_1267_: u32;
    var phi_1270_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1455_: u32;
    var phi_1458_: bool;
    var phi_1502_: vec3<f32>;
    var phi_1503_: vec3<f32>;
    var phi_1532_: vec3<f32>;
    var phi_1533_: vec3<f32>;
    var phi_1562_: vec3<f32>;
    var phi_1563_: vec3<f32>;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1588_: f32;
    var phi_1589_: f32;
    var phi_1597_: f32;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1612_: f32;
    var phi_1613_: f32;
    var phi_1614_: f32;
    var phi_1615_: f32;
    var phi_1623_: f32;
    var phi_1633_: bool;
    var phi_1634_: bool;
    var phi_1638_: f32;
    var phi_1639_: f32;
    var phi_1640_: f32;
    var phi_1641_: f32;
    var phi_1649_: f32;
    var phi_1664_: f32;
    var phi_1665_: bool;
    var phi_1666_: f32;
    var phi_1667_: bool;
    var phi_1668_: f32;
    var phi_1669_: bool;
    var phi_1687_: f32;
    var phi_1688_: bool;
    var phi_1689_: bool;
    var phi_1690_: f32;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1696_: bool;
    var phi_1697_: f32;
    var phi_1698_: bool;
    var phi_1726_: vec3<f32>;
    var phi_1727_: vec3<f32>;
    var phi_1752_: vec3<f32>;
    var phi_1753_: vec3<f32>;
    var phi_1778_: vec3<f32>;
    var phi_1779_: vec3<f32>;
    var phi_1835_: f32;
    var phi_1844_: f32;
    var phi_1853_: f32;
    var phi_1862_: f32;
    var phi_1869_: f32;
    var phi_1876_: f32;
    var phi_1889_: f32;
    var phi_1898_: f32;
    var phi_1907_: f32;
    var phi_1916_: f32;
    var phi_1923_: f32;
    var phi_1930_: f32;
    var phi_1947_: f32;
    var phi_1952_: f32;
    var phi_1957_: f32;
    var phi_1965_: f32;
    var phi_1970_: f32;
    var phi_1975_: f32;
    var phi_1987_: f32;
    var phi_1992_: f32;
    var phi_1997_: f32;
    var phi_2002_: f32;
    var phi_2007_: lt_bvh_triangle_Intersection;
    var phi_2008_: bool;
    var phi_2009_: lt_bvh_triangle_Intersection;
    var phi_2010_: bool;
    var phi_2014_: lt_bvh_triangle_Intersection;
    var phi_2015_: bool;
    var phi_2016_: lt_bvh_triangle_Intersection;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2022_: bool;
    var phi_2026_: lt_bvh_triangle_Intersection;
    var phi_2240_: f32;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2258_: bool;
    var phi_1456_: u32;
    var phi_1459_: bool;
    var phi_2262_: bool;
    var phi_2263_: bool;
    var local_5: bool;
    var phi_2305_: bool;
    var phi_2306_: bool;
    var phi_2337_: u32;
    var phi_2338_: u32;
    var phi_1124_: u32;
    var phi_1127_: bool;
    var phi_2339_: bool;
    var phi_2340_: bool;
    var phi_2341_: bool;
    var local_6: bool;
    var phi_2345_: bool;
    var phi_2349_: bool;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2356_: bool;
    var phi_2360_: f32;
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
            phi_677_ = 300000000000000000000000000000000000000f;
        } else {
            phi_677_ = 1f;
        }
        let _e136 = phi_677_;
        let _e144 = (_e132.x - (_e126 * _e132.w));
        let _e145 = (_e132.y - (_e128 * _e132.w));
        let _e146 = (_e132.z - (_e130 * _e132.w));
        let _e148 = abs(_e144);
        let _e149 = abs(_e145);
        let _e150 = abs(_e146);
        if (abs(_e126) < 1000000000000000f) {
            if (abs(_e128) < 1000000000000000f) {
                phi_708_ = (abs(_e130) < 1000000000000000f);
                phi_709_ = false;
            } else {
                phi_708_ = bool();
                phi_709_ = true;
            }
            let _e158 = phi_708_;
            let _e160 = phi_709_;
            phi_710_ = _e158;
            phi_711_ = _e160;
        } else {
            phi_710_ = bool();
            phi_711_ = true;
        }
        let _e162 = phi_710_;
        let _e164 = phi_711_;
        if _e164 {
            phi_715_ = false;
        } else {
            phi_715_ = _e162;
        }
        let _e166 = phi_715_;
        if _e166 {
            if (_e148 < 1000000000000000f) {
                if (_e149 < 1000000000000000f) {
                    phi_728_ = (_e150 < 1000000000000000f);
                    phi_729_ = false;
                } else {
                    phi_728_ = bool();
                    phi_729_ = true;
                }
                let _e171 = phi_728_;
                let _e173 = phi_729_;
                phi_730_ = _e171;
                phi_731_ = _e173;
            } else {
                phi_730_ = bool();
                phi_731_ = true;
            }
            let _e175 = phi_730_;
            let _e177 = phi_731_;
            if _e177 {
                phi_735_ = false;
            } else {
                phi_735_ = _e175;
            }
            let _e179 = phi_735_;
            if _e179 {
                if (_e148 > 0f) {
                    phi_749_ = bool();
                    phi_750_ = true;
                } else {
                    let _e181 = (_e149 > 0f);
                    if _e181 {
                        phi_748_ = bool();
                    } else {
                        phi_748_ = (_e150 > 0f);
                    }
                    let _e184 = phi_748_;
                    phi_749_ = _e184;
                    phi_750_ = _e181;
                }
                let _e186 = phi_749_;
                let _e188 = phi_750_;
                if _e188 {
                    phi_754_ = true;
                } else {
                    phi_754_ = _e186;
                }
                let _e190 = phi_754_;
                phi_755_ = _e190;
                phi_756_ = false;
            } else {
                phi_755_ = bool();
                phi_756_ = true;
            }
            let _e192 = phi_755_;
            let _e194 = phi_756_;
            phi_757_ = _e192;
            phi_758_ = _e194;
        } else {
            phi_757_ = bool();
            phi_758_ = true;
        }
        let _e196 = phi_757_;
        let _e198 = phi_758_;
        if _e198 {
            phi_762_ = false;
        } else {
            phi_762_ = _e196;
        }
        let _e200 = phi_762_;
        if _e200 {
            let _e201 = (0u >= _e75);
            if _e201 {
                phi_2350_ = bool();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e207 = nodes.member[(0u + 0u)].frame[0u];
                let _e211 = nodes.member[(0u + 0u)].frame[1u];
                let _e215 = nodes.member[(0u + 0u)].frame[2u];
                let _e219 = nodes.member[(0u + 0u)].frame[0u];
                let _e223 = nodes.member[(0u + 0u)].frame[1u];
                let _e227 = nodes.member[(0u + 0u)].frame[2u];
                let _e231 = nodes.member[(0u + 0u)].frame[3u];
                let _e265 = core_intrinsics_maximum_number_nsz_f32_(abs(_e144), abs(_e145));
                let _e266 = core_intrinsics_maximum_number_nsz_f32_(_e265, abs(_e146));
                let _e267 = (_e266 * 0.0000000000009094947f);
                if (abs(_e144) < _e267) {
                    phi_832_ = _e267;
                } else {
                    phi_832_ = abs(_e144);
                }
                let _e272 = phi_832_;
                if (_e144 < 0f) {
                    phi_839_ = (-1f / _e272);
                } else {
                    phi_839_ = (1f / _e272);
                }
                let _e277 = phi_839_;
                if (abs(_e145) < _e267) {
                    phi_846_ = _e267;
                } else {
                    phi_846_ = abs(_e145);
                }
                let _e282 = phi_846_;
                if (_e145 < 0f) {
                    phi_853_ = (-1f / _e282);
                } else {
                    phi_853_ = (1f / _e282);
                }
                let _e287 = phi_853_;
                if (abs(_e146) < _e267) {
                    phi_860_ = _e267;
                } else {
                    phi_860_ = abs(_e146);
                }
                let _e292 = phi_860_;
                if (_e146 < 0f) {
                    phi_867_ = (-1f / _e292);
                } else {
                    phi_867_ = (1f / _e292);
                }
                let _e297 = phi_867_;
                let _e301 = abs((bitcast<f32>(_e207) - _e126));
                let _e302 = abs((bitcast<f32>(_e211) - _e128));
                let _e303 = abs((bitcast<f32>(_e215) - _e130));
                let _e307 = abs(((bitcast<f32>(_e219) + (bitcast<f32>((((_e231 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                let _e308 = abs(((bitcast<f32>(_e223) + (bitcast<f32>((((_e231 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                let _e309 = abs(((bitcast<f32>(_e227) + (bitcast<f32>((((_e231 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                if (_e301 > _e307) {
                    phi_884_ = _e301;
                } else {
                    phi_884_ = _e307;
                }
                let _e312 = phi_884_;
                if (_e302 > _e308) {
                    phi_889_ = _e302;
                } else {
                    phi_889_ = _e308;
                }
                let _e315 = phi_889_;
                if (_e303 > _e309) {
                    phi_894_ = _e303;
                } else {
                    phi_894_ = _e309;
                }
                let _e318 = phi_894_;
                if (_e312 > _e315) {
                    phi_899_ = _e312;
                } else {
                    phi_899_ = _e315;
                }
                let _e321 = phi_899_;
                if (_e321 > _e318) {
                    phi_904_ = _e321;
                } else {
                    phi_904_ = _e318;
                }
                let _e324 = phi_904_;
                let _e328 = (_e324 * 0.0000019073486f);
                let _e329 = (abs(_e277) * _e328);
                let _e330 = (abs(_e287) * _e328);
                let _e331 = (abs(_e297) * _e328);
                let _e335 = (_e324 * 0.0000009536743f);
                let _e336 = (abs(_e277) * _e335);
                let _e337 = (abs(_e287) * _e335);
                let _e338 = (abs(_e297) * _e335);
                let _e339 = abs(_e144);
                let _e340 = abs(_e145);
                let _e341 = abs(_e146);
                if (_e339 >= _e340) {
                    if (_e339 >= _e341) {
                        phi_930_ = false;
                    } else {
                        phi_930_ = true;
                    }
                    let _e345 = phi_930_;
                    phi_931_ = _e345;
                } else {
                    phi_931_ = true;
                }
                let _e347 = phi_931_;
                if _e347 {
                    if (_e340 >= _e341) {
                        phi_939_ = 1u;
                    } else {
                        phi_939_ = 2u;
                    }
                    let _e350 = phi_939_;
                    phi_940_ = _e350;
                } else {
                    phi_940_ = 0u;
                }
                let _e352 = phi_940_;
                if (_e352 == 0u) {
                    phi_952_ = vec3<f32>(_e145, _e146, _e144);
                } else {
                    if (_e352 == 1u) {
                        phi_951_ = vec3<f32>(_e146, _e144, _e145);
                    } else {
                        phi_951_ = vec3<f32>(_e144, _e145, _e146);
                    }
                    let _e358 = phi_951_;
                    phi_952_ = _e358;
                }
                let _e360 = phi_952_;
                let _e363 = (_e360.x / _e360.z);
                let _e366 = (_e360.y / _e360.z);
                if (_e277 < 0f) {
                    phi_965_ = 0u;
                } else {
                    phi_965_ = 1u;
                }
                let _e371 = phi_965_;
                if (_e287 < 0f) {
                    phi_970_ = 0u;
                } else {
                    phi_970_ = 2u;
                }
                let _e374 = phi_970_;
                if (_e297 < 0f) {
                    phi_975_ = 0u;
                } else {
                    phi_975_ = 4u;
                }
                let _e377 = phi_975_;
                let _e379 = ((_e371 | _e374) | _e377);
                let _e380 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e380.first[0], _e380.first[1], _e380.first[2], _e380.first[3], _e380.first[4], _e380.first[5], _e380.first[6], _e380.first[7], _e380.first[8], _e380.first[9], _e380.first[10], _e380.first[11], _e380.first[12], _e380.first[13], _e380.first[14], _e380.first[15], _e380.first[16], _e380.first[17], _e380.first[18], _e380.first[19], _e380.first[20], _e380.first[21], _e380.first[22], _e380.first[23], _e380.first[24], _e380.first[25], _e380.first[26], _e380.first[27], _e380.first[28], _e380.first[29], _e380.first[30], _e380.first[31]), array<u32, 32>(_e380.mask[0], _e380.mask[1], _e380.mask[2], _e380.mask[3], _e380.mask[4], _e380.mask[5], _e380.mask[6], _e380.mask[7], _e380.mask[8], _e380.mask[9], _e380.mask[10], _e380.mask[11], _e380.mask[12], _e380.mask[13], _e380.mask[14], _e380.mask[15], _e380.mask[16], _e380.mask[17], _e380.mask[18], _e380.mask[19], _e380.mask[20], _e380.mask[21], _e380.mask[22], _e380.mask[23], _e380.mask[24], _e380.mask[25], _e380.mask[26], _e380.mask[27], _e380.mask[28], _e380.mask[29], _e380.mask[30], _e380.mask[31]), _e380.len, _e380.group, _e380.group_mask);
                let _e454 = local_1.group_mask;
                if ((_e454 & 4278190080u) == 0u) {
                    let _e458 = local_1.len;
                    if (_e458 == 0u) {
                        phi_1089_ = false;
                    } else {
                        let _e462 = local_1.len;
                        local_1.len = (_e462 - 1u);
                        let _e465 = local_1.len;
                        if (_e465 < 32u) {
                        } else {
                            return;
                        }
                        let _e470 = local_1.first[(0u + _e465)];
                        local_1.group = _e470;
                        let _e473 = local_1.len;
                        if (_e473 < 32u) {
                        } else {
                            return;
                        }
                        let _e478 = local_1.mask[(0u + _e473)];
                        local_1.group_mask = _e478;
                        phi_1089_ = true;
                    }
                    let _e481 = phi_1089_;
                    phi_1090_ = _e481;
                } else {
                    phi_1090_ = true;
                }
                let _e483 = phi_1090_;
                if _e483 {
                    let _e485 = local_1.group_mask;
                    let _e491 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e485)), 32u, (_e485 == 0u)));
                    let _e495 = local_1.group_mask;
                    let _e509 = local_1.group_mask;
                    local_1.group_mask = (_e509 & ~((1u << bitcast<u32>((_e491 & 31u)))));
                    let _e512 = local_1.group;
                    phi_1121_ = (_e512 + countOneBits(((_e495 & ~((4294967295u << bitcast<u32>((((_e491 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1121_ = 4294967295u;
                }
                let _e515 = phi_1121_;
                phi_1123_ = _e515;
                phi_1126_ = false;
                loop {
                    let _e517 = phi_1123_;
                    let _e519 = phi_1126_;
                    local_11 = _e519;
                    if (_e517 != 4294967295u) {
                        if (_e517 < _e75) {
                        } else {
                            return;
                        }
                        let _e526 = nodes.member[(0u + _e517)].frame[3u];
                        let _e551 = (bitcast<f32>((((_e526 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e277);
                        let _e552 = (bitcast<f32>((((_e526 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e287);
                        let _e553 = (bitcast<f32>((((_e526 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e297);
                        let _e556 = nodes.member[(0u + _e517)].frame[0u];
                        let _e560 = nodes.member[(0u + _e517)].frame[1u];
                        let _e564 = nodes.member[(0u + _e517)].frame[2u];
                        let _e569 = ((bitcast<f32>(_e556) - _e126) * _e277);
                        let _e570 = ((bitcast<f32>(_e560) - _e128) * _e287);
                        let _e571 = ((bitcast<f32>(_e564) - _e130) * _e297);
                        let _e579 = nodes.member[(0u + _e517)].x;
                        if (_e277 < 0f) {
                            let _e590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e579.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e590.unnamed.root, _e579.w), _e590.unnamed_1);
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e596.unnamed, lt_bvh_traverse_Tree(_e579.x, _e596.unnamed_1.first_primitive));
                            phi_1206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e602.unnamed, lt_bvh_traverse_Tree(_e602.unnamed_1.root, _e579.y));
                        } else {
                            let _e618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e579.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e618.unnamed.root, _e579.y), _e618.unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_bvh_traverse_Tree(_e579.z, _e624.unnamed_1.first_primitive));
                            phi_1206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_bvh_traverse_Tree(_e630.unnamed_1.root, _e579.w));
                        }
                        let _e638 = phi_1206_;
                        let _e648 = nodes.member[(0u + _e517)].y;
                        if (_e287 < 0f) {
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e648.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e659.unnamed.root, _e648.w), _e659.unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_bvh_traverse_Tree(_e648.x, _e665.unnamed_1.first_primitive));
                            phi_1233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e671.unnamed_1.root, _e648.y));
                        } else {
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e648.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e687.unnamed.root, _e648.y), _e687.unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_bvh_traverse_Tree(_e648.z, _e693.unnamed_1.first_primitive));
                            phi_1233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_bvh_traverse_Tree(_e699.unnamed_1.root, _e648.w));
                        }
                        let _e707 = phi_1233_;
                        let _e717 = nodes.member[(0u + _e517)].z;
                        if (_e297 < 0f) {
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e717.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e728.unnamed.root, _e717.w), _e728.unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_bvh_traverse_Tree(_e717.x, _e734.unnamed_1.first_primitive));
                            phi_1260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e740.unnamed_1.root, _e717.y));
                        } else {
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e717.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e756.unnamed.root, _e717.y), _e756.unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_bvh_traverse_Tree(_e717.z, _e762.unnamed_1.first_primitive));
                            phi_1260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_bvh_traverse_Tree(_e768.unnamed_1.root, _e717.w));
                        }
                        let _e776 = phi_1260_;
                        phi_1266_ = 0u;
                        phi_1269_ = 0u;
                        loop {
                            let _e786 = phi_1266_;
                            let _e788 = phi_1269_;
                            local_2 = _e788;
                            local_3 = _e788;
                            local_4 = _e788;
                            let _e789 = (_e786 < 8u);
                            if _e789 {
                                let _e791 = (_e786 >> bitcast<u32>(2i));
                                let _e792 = (_e786 & 3u);
                                if (_e791 == 0u) {
                                    phi_1283_ = _e638.unnamed.root;
                                } else {
                                    phi_1283_ = _e638.unnamed.first_primitive;
                                }
                                let _e795 = phi_1283_;
                                if (_e791 == 0u) {
                                    phi_1293_ = _e707.unnamed.root;
                                } else {
                                    phi_1293_ = _e707.unnamed.first_primitive;
                                }
                                let _e804 = phi_1293_;
                                if (_e791 == 0u) {
                                    phi_1303_ = _e776.unnamed.root;
                                } else {
                                    phi_1303_ = _e776.unnamed.first_primitive;
                                }
                                let _e813 = phi_1303_;
                                let _e826 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e795 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e551) + (_e569 - _e329)), ((f32(((_e804 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e552) + (_e570 - _e330)));
                                let _e827 = core_intrinsics_maximum_number_nsz_f32_(_e826, ((f32(((_e813 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e553) + (_e571 - _e331)));
                                if (_e791 == 0u) {
                                    phi_1321_ = _e638.unnamed_1.root;
                                } else {
                                    phi_1321_ = _e638.unnamed_1.first_primitive;
                                }
                                let _e830 = phi_1321_;
                                if (_e791 == 0u) {
                                    phi_1331_ = _e707.unnamed_1.root;
                                } else {
                                    phi_1331_ = _e707.unnamed_1.first_primitive;
                                }
                                let _e839 = phi_1331_;
                                if (_e791 == 0u) {
                                    phi_1341_ = _e776.unnamed_1.root;
                                } else {
                                    phi_1341_ = _e776.unnamed_1.first_primitive;
                                }
                                let _e848 = phi_1341_;
                                let _e861 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e830 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e551) + (_e569 + _e329)), ((f32(((_e839 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e552) + (_e570 + _e330)));
                                let _e862 = core_intrinsics_minimum_number_nsz_f32_(_e861, ((f32(((_e848 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e553) + (_e571 + _e331)));
                                if (_e827 <= _e862) {
                                    if (_e827 <= _e136) {
                                        if (_e862 >= 0f) {
                                            if (_e791 == 0u) {
                                                let _e869 = nodes.member[(0u + _e517)].links[2u];
                                                phi_1377_ = _e869;
                                            } else {
                                                let _e872 = nodes.member[(0u + _e517)].links[3u];
                                                phi_1377_ = _e872;
                                            }
                                            let _e874 = phi_1377_;
                                            let _e879 = ((_e874 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u);
                                            let _e880 = (_e879 & 31u);
                                            if (_e880 >= 24u) {
                                                phi_1390_ = (24u + ((_e880 - 24u) ^ _e379));
                                            } else {
                                                phi_1390_ = _e880;
                                            }
                                            let _e886 = phi_1390_;
                                            phi_1395_ = (_e788 | ((_e879 >> bitcast<u32>(5i)) << bitcast<u32>((_e886 & 31u))));
                                        } else {
                                            phi_1395_ = _e788;
                                        }
                                        let _e894 = phi_1395_;
                                        phi_1396_ = _e894;
                                    } else {
                                        phi_1396_ = _e788;
                                    }
                                    let _e896 = phi_1396_;
                                    phi_1397_ = _e896;
                                } else {
                                    phi_1397_ = _e788;
                                }
                                let _e898 = phi_1397_;
                                phi_1267_ = (_e786 + 1u);
                                phi_1270_ = _e898;
                            } else {
                                phi_1267_ = u32();
                                phi_1270_ = u32();
                            }
                            let _e901 = phi_1267_;
                            let _e903 = phi_1270_;
                            continue;
                            continuing {
                                phi_1266_ = _e901;
                                phi_1269_ = _e903;
                                break if !(_e789);
                            }
                        }
                        let _e907 = nodes.member[(0u + _e517)].links[0u];
                        let _e911 = nodes.member[(0u + _e517)].frame[3u];
                        let _e915 = local_2;
                        if ((_e915 & 4278190080u) == 0u) {
                        } else {
                            let _e919 = local_1.group_mask;
                            if ((_e919 & 4278190080u) == 0u) {
                            } else {
                                let _e923 = local_1.len;
                                if (_e923 < 32u) {
                                    let _e926 = local_1.group;
                                    let _e928 = local_1.len;
                                    if (_e928 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e928)] = _e926;
                                    let _e934 = local_1.group_mask;
                                    let _e936 = local_1.len;
                                    if (_e936 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e936)] = _e934;
                                    let _e943 = local_1.len;
                                    local_1.len = (_e943 + 1u);
                                }
                            }
                            local_1.group = (0u + _e907);
                            let _e947 = local_3;
                            local_1.group_mask = ((_e947 & 4278190080u) | (_e911 >> bitcast<u32>(24i)));
                        }
                        let _e952 = local_4;
                        phi_1455_ = (_e952 & 16777215u);
                        phi_1458_ = _e519;
                        loop {
                            let _e955 = phi_1455_;
                            let _e957 = phi_1458_;
                            local_7 = _e957;
                            let _e958 = (_e955 == 0u);
                            local_5 = _e958;
                            local_9 = _e958;
                            if _e958 {
                                phi_1456_ = u32();
                                phi_1459_ = bool();
                                phi_2262_ = bool();
                                phi_2263_ = false;
                            } else {
                                let _e961 = nodes.member[(0u + _e517)].links[1u];
                                let _e966 = ((0u + _e961) + select(firstTrailingBit(_e955), 32u, (_e955 == 0u)));
                                if (_e966 < _e78) {
                                } else {
                                    return;
                                }
                                let _e973 = triangles.member[(0u + _e966)].v0_;
                                let _e975 = (_e973.x - _e126);
                                let _e977 = (_e973.y - _e128);
                                let _e979 = (_e973.z - _e130);
                                if (_e352 == 0u) {
                                    phi_1503_ = vec3<f32>(_e977, _e979, _e975);
                                } else {
                                    if (_e352 == 1u) {
                                        phi_1502_ = vec3<f32>(_e979, _e975, _e977);
                                    } else {
                                        phi_1502_ = (_e973 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e987 = phi_1502_;
                                    phi_1503_ = _e987;
                                }
                                let _e989 = phi_1503_;
                                let _e993 = (_e989.x - (_e363 * _e989.z));
                                let _e997 = (_e989.y - (_e366 * _e989.z));
                                let _e999 = triangles.member[(0u + _e966)].v1_;
                                let _e1001 = (_e999.x - _e126);
                                let _e1003 = (_e999.y - _e128);
                                let _e1005 = (_e999.z - _e130);
                                if (_e352 == 0u) {
                                    phi_1533_ = vec3<f32>(_e1003, _e1005, _e1001);
                                } else {
                                    if (_e352 == 1u) {
                                        phi_1532_ = vec3<f32>(_e1005, _e1001, _e1003);
                                    } else {
                                        phi_1532_ = (_e999 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1013 = phi_1532_;
                                    phi_1533_ = _e1013;
                                }
                                let _e1015 = phi_1533_;
                                let _e1019 = (_e1015.x - (_e363 * _e1015.z));
                                let _e1023 = (_e1015.y - (_e366 * _e1015.z));
                                let _e1025 = triangles.member[(0u + _e966)].v2_;
                                let _e1027 = (_e1025.x - _e126);
                                let _e1029 = (_e1025.y - _e128);
                                let _e1031 = (_e1025.z - _e130);
                                if (_e352 == 0u) {
                                    phi_1563_ = vec3<f32>(_e1029, _e1031, _e1027);
                                } else {
                                    if (_e352 == 1u) {
                                        phi_1562_ = vec3<f32>(_e1031, _e1027, _e1029);
                                    } else {
                                        phi_1562_ = (_e1025 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1039 = phi_1562_;
                                    phi_1563_ = _e1039;
                                }
                                let _e1041 = phi_1563_;
                                let _e1045 = (_e1041.x - (_e363 * _e1041.z));
                                let _e1049 = (_e1041.y - (_e366 * _e1041.z));
                                if (_e1019 < _e1045) {
                                    phi_1582_ = true;
                                } else {
                                    if (_e1019 == _e1045) {
                                        phi_1581_ = (_e1023 < _e1049);
                                    } else {
                                        phi_1581_ = false;
                                    }
                                    let _e1054 = phi_1581_;
                                    phi_1582_ = _e1054;
                                }
                                let _e1056 = phi_1582_;
                                if _e1056 {
                                    phi_1586_ = _e1049;
                                    phi_1587_ = _e1045;
                                    phi_1588_ = _e1023;
                                    phi_1589_ = _e1019;
                                } else {
                                    phi_1586_ = _e1023;
                                    phi_1587_ = _e1019;
                                    phi_1588_ = _e1049;
                                    phi_1589_ = _e1045;
                                }
                                let _e1058 = phi_1586_;
                                let _e1060 = phi_1587_;
                                let _e1062 = phi_1588_;
                                let _e1064 = phi_1589_;
                                let _e1067 = ((_e1064 * _e1058) - (_e1062 * _e1060));
                                if _e1056 {
                                    phi_1597_ = -(_e1067);
                                } else {
                                    phi_1597_ = _e1067;
                                }
                                let _e1070 = phi_1597_;
                                if (_e1045 < _e993) {
                                    phi_1608_ = true;
                                } else {
                                    if (_e1045 == _e993) {
                                        phi_1607_ = (_e1049 < _e997);
                                    } else {
                                        phi_1607_ = false;
                                    }
                                    let _e1075 = phi_1607_;
                                    phi_1608_ = _e1075;
                                }
                                let _e1077 = phi_1608_;
                                if _e1077 {
                                    phi_1612_ = _e997;
                                    phi_1613_ = _e993;
                                    phi_1614_ = _e1049;
                                    phi_1615_ = _e1045;
                                } else {
                                    phi_1612_ = _e1049;
                                    phi_1613_ = _e1045;
                                    phi_1614_ = _e997;
                                    phi_1615_ = _e993;
                                }
                                let _e1079 = phi_1612_;
                                let _e1081 = phi_1613_;
                                let _e1083 = phi_1614_;
                                let _e1085 = phi_1615_;
                                let _e1088 = ((_e1085 * _e1079) - (_e1083 * _e1081));
                                if _e1077 {
                                    phi_1623_ = -(_e1088);
                                } else {
                                    phi_1623_ = _e1088;
                                }
                                let _e1091 = phi_1623_;
                                if (_e993 < _e1019) {
                                    phi_1634_ = true;
                                } else {
                                    if (_e993 == _e1019) {
                                        phi_1633_ = (_e997 < _e1023);
                                    } else {
                                        phi_1633_ = false;
                                    }
                                    let _e1096 = phi_1633_;
                                    phi_1634_ = _e1096;
                                }
                                let _e1098 = phi_1634_;
                                if _e1098 {
                                    phi_1638_ = _e1023;
                                    phi_1639_ = _e1019;
                                    phi_1640_ = _e997;
                                    phi_1641_ = _e993;
                                } else {
                                    phi_1638_ = _e997;
                                    phi_1639_ = _e993;
                                    phi_1640_ = _e1023;
                                    phi_1641_ = _e1019;
                                }
                                let _e1100 = phi_1638_;
                                let _e1102 = phi_1639_;
                                let _e1104 = phi_1640_;
                                let _e1106 = phi_1641_;
                                let _e1109 = ((_e1106 * _e1100) - (_e1104 * _e1102));
                                if _e1098 {
                                    phi_1649_ = -(_e1109);
                                } else {
                                    phi_1649_ = _e1109;
                                }
                                let _e1112 = phi_1649_;
                                if (_e1070 >= 0f) {
                                    if (_e1091 >= 0f) {
                                        if (_e1112 >= 0f) {
                                            phi_1664_ = ((_e1070 + _e1091) + _e1112);
                                            phi_1665_ = false;
                                        } else {
                                            phi_1664_ = f32();
                                            phi_1665_ = true;
                                        }
                                        let _e1119 = phi_1664_;
                                        let _e1121 = phi_1665_;
                                        phi_1666_ = _e1119;
                                        phi_1667_ = _e1121;
                                    } else {
                                        phi_1666_ = f32();
                                        phi_1667_ = true;
                                    }
                                    let _e1123 = phi_1666_;
                                    let _e1125 = phi_1667_;
                                    phi_1668_ = _e1123;
                                    phi_1669_ = _e1125;
                                } else {
                                    phi_1668_ = f32();
                                    phi_1669_ = true;
                                }
                                let _e1127 = phi_1668_;
                                let _e1129 = phi_1669_;
                                if _e1129 {
                                    if (_e1070 <= 0f) {
                                        if (_e1091 <= 0f) {
                                            let _e1132 = (_e1112 <= 0f);
                                            if _e1132 {
                                            }
                                            phi_1687_ = ((_e1070 + _e1091) + _e1112);
                                            phi_1688_ = false;
                                            phi_1689_ = _e1132;
                                        } else {
                                            phi_1687_ = f32();
                                            phi_1688_ = true;
                                            phi_1689_ = false;
                                        }
                                        let _e1136 = phi_1687_;
                                        let _e1138 = phi_1688_;
                                        let _e1140 = phi_1689_;
                                        phi_1690_ = _e1136;
                                        phi_1691_ = _e1138;
                                        phi_1692_ = _e1140;
                                    } else {
                                        phi_1690_ = f32();
                                        phi_1691_ = true;
                                        phi_1692_ = false;
                                    }
                                    let _e1142 = phi_1690_;
                                    let _e1144 = phi_1691_;
                                    let _e1146 = phi_1692_;
                                    if _e1144 {
                                        phi_1696_ = false;
                                    } else {
                                        phi_1696_ = _e1146;
                                    }
                                    let _e1148 = phi_1696_;
                                    phi_1697_ = _e1142;
                                    phi_1698_ = _e1148;
                                } else {
                                    phi_1697_ = _e1127;
                                    phi_1698_ = true;
                                }
                                let _e1150 = phi_1697_;
                                let _e1152 = phi_1698_;
                                if _e1152 {
                                    let _e1153 = (_e1150 == 0f);
                                    if _e1153 {
                                        phi_2014_ = lt_bvh_triangle_Intersection();
                                        phi_2015_ = false;
                                    } else {
                                        let _e1155 = triangles.member[(0u + _e966)].v0_;
                                        let _e1157 = (_e1155.x - _e126);
                                        let _e1159 = (_e1155.y - _e128);
                                        let _e1161 = (_e1155.z - _e130);
                                        if (_e352 == 0u) {
                                            phi_1727_ = vec3<f32>(_e1159, _e1161, _e1157);
                                        } else {
                                            if (_e352 == 1u) {
                                                phi_1726_ = vec3<f32>(_e1161, _e1157, _e1159);
                                            } else {
                                                phi_1726_ = (_e1155 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e1169 = phi_1726_;
                                            phi_1727_ = _e1169;
                                        }
                                        let _e1171 = phi_1727_;
                                        let _e1173 = triangles.member[(0u + _e966)].v1_;
                                        let _e1175 = triangles.member[(0u + _e966)].v0_;
                                        let _e1178 = (_e1173.x - _e1175.x);
                                        let _e1181 = (_e1173.y - _e1175.y);
                                        let _e1184 = (_e1173.z - _e1175.z);
                                        if (_e352 == 0u) {
                                            phi_1753_ = vec3<f32>(_e1181, _e1184, _e1178);
                                        } else {
                                            if (_e352 == 1u) {
                                                phi_1752_ = vec3<f32>(_e1184, _e1178, _e1181);
                                            } else {
                                                phi_1752_ = (_e1173 - _e1175);
                                            }
                                            let _e1191 = phi_1752_;
                                            phi_1753_ = _e1191;
                                        }
                                        let _e1193 = phi_1753_;
                                        let _e1195 = triangles.member[(0u + _e966)].v2_;
                                        let _e1197 = triangles.member[(0u + _e966)].v0_;
                                        let _e1200 = (_e1195.x - _e1197.x);
                                        let _e1203 = (_e1195.y - _e1197.y);
                                        let _e1206 = (_e1195.z - _e1197.z);
                                        if (_e352 == 0u) {
                                            phi_1779_ = vec3<f32>(_e1203, _e1206, _e1200);
                                        } else {
                                            if (_e352 == 1u) {
                                                phi_1778_ = vec3<f32>(_e1206, _e1200, _e1203);
                                            } else {
                                                phi_1778_ = (_e1195 - _e1197);
                                            }
                                            let _e1213 = phi_1778_;
                                            phi_1779_ = _e1213;
                                        }
                                        let _e1215 = phi_1779_;
                                        let _e1222 = ((_e1193.y * _e1215.z) - (_e1193.z * _e1215.y));
                                        let _e1229 = ((_e1193.z * _e1215.x) - (_e1193.x * _e1215.z));
                                        let _e1236 = ((_e1193.x * _e1215.y) - (_e1193.y * _e1215.x));
                                        let _e1250 = (((1f / _e360.z) * (((_e1222 * _e1171.x) + (_e1229 * _e1171.y)) + (_e1236 * _e1171.z))) / (((_e1222 * _e363) + (_e1229 * _e366)) + _e1236));
                                        if (_e1250 > 0f) {
                                            if (_e1250 < _e136) {
                                                let _e1254 = triangles.member[(0u + _e966)].v0_;
                                                let _e1256 = triangles.member[(0u + _e966)].v1_;
                                                if (_e1254.x < _e1256.x) {
                                                    phi_1835_ = _e1254.x;
                                                } else {
                                                    phi_1835_ = _e1256.x;
                                                }
                                                let _e1263 = phi_1835_;
                                                if (_e1254.y < _e1256.y) {
                                                    phi_1844_ = _e1254.y;
                                                } else {
                                                    phi_1844_ = _e1256.y;
                                                }
                                                let _e1270 = phi_1844_;
                                                if (_e1254.z < _e1256.z) {
                                                    phi_1853_ = _e1254.z;
                                                } else {
                                                    phi_1853_ = _e1256.z;
                                                }
                                                let _e1277 = phi_1853_;
                                                let _e1279 = triangles.member[(0u + _e966)].v2_;
                                                if (_e1263 < _e1279.x) {
                                                    phi_1862_ = _e1263;
                                                } else {
                                                    phi_1862_ = _e1279.x;
                                                }
                                                let _e1284 = phi_1862_;
                                                if (_e1270 < _e1279.y) {
                                                    phi_1869_ = _e1270;
                                                } else {
                                                    phi_1869_ = _e1279.y;
                                                }
                                                let _e1289 = phi_1869_;
                                                if (_e1277 < _e1279.z) {
                                                    phi_1876_ = _e1277;
                                                } else {
                                                    phi_1876_ = _e1279.z;
                                                }
                                                let _e1294 = phi_1876_;
                                                let _e1296 = triangles.member[(0u + _e966)].v0_;
                                                let _e1298 = triangles.member[(0u + _e966)].v1_;
                                                if (_e1296.x > _e1298.x) {
                                                    phi_1889_ = _e1296.x;
                                                } else {
                                                    phi_1889_ = _e1298.x;
                                                }
                                                let _e1305 = phi_1889_;
                                                if (_e1296.y > _e1298.y) {
                                                    phi_1898_ = _e1296.y;
                                                } else {
                                                    phi_1898_ = _e1298.y;
                                                }
                                                let _e1312 = phi_1898_;
                                                if (_e1296.z > _e1298.z) {
                                                    phi_1907_ = _e1296.z;
                                                } else {
                                                    phi_1907_ = _e1298.z;
                                                }
                                                let _e1319 = phi_1907_;
                                                let _e1321 = triangles.member[(0u + _e966)].v2_;
                                                if (_e1305 > _e1321.x) {
                                                    phi_1916_ = _e1305;
                                                } else {
                                                    phi_1916_ = _e1321.x;
                                                }
                                                let _e1326 = phi_1916_;
                                                if (_e1312 > _e1321.y) {
                                                    phi_1923_ = _e1312;
                                                } else {
                                                    phi_1923_ = _e1321.y;
                                                }
                                                let _e1331 = phi_1923_;
                                                if (_e1319 > _e1321.z) {
                                                    phi_1930_ = _e1319;
                                                } else {
                                                    phi_1930_ = _e1321.z;
                                                }
                                                let _e1336 = phi_1930_;
                                                let _e1340 = ((_e1284 - _e126) * _e277);
                                                let _e1341 = ((_e1289 - _e128) * _e287);
                                                let _e1342 = ((_e1294 - _e130) * _e297);
                                                let _e1346 = ((_e1326 - _e126) * _e277);
                                                let _e1347 = ((_e1331 - _e128) * _e287);
                                                let _e1348 = ((_e1336 - _e130) * _e297);
                                                if (_e1340 < _e1346) {
                                                    phi_1947_ = _e1340;
                                                } else {
                                                    phi_1947_ = _e1346;
                                                }
                                                let _e1351 = phi_1947_;
                                                if (_e1341 < _e1347) {
                                                    phi_1952_ = _e1341;
                                                } else {
                                                    phi_1952_ = _e1347;
                                                }
                                                let _e1354 = phi_1952_;
                                                if (_e1342 < _e1348) {
                                                    phi_1957_ = _e1342;
                                                } else {
                                                    phi_1957_ = _e1348;
                                                }
                                                let _e1357 = phi_1957_;
                                                if (_e1340 > _e1346) {
                                                    phi_1965_ = _e1340;
                                                } else {
                                                    phi_1965_ = _e1346;
                                                }
                                                let _e1363 = phi_1965_;
                                                if (_e1341 > _e1347) {
                                                    phi_1970_ = _e1341;
                                                } else {
                                                    phi_1970_ = _e1347;
                                                }
                                                let _e1366 = phi_1970_;
                                                if (_e1342 > _e1348) {
                                                    phi_1975_ = _e1342;
                                                } else {
                                                    phi_1975_ = _e1348;
                                                }
                                                let _e1369 = phi_1975_;
                                                let _e1373 = core_intrinsics_maximum_number_nsz_f32_((_e1351 - _e336), (_e1354 - _e337));
                                                let _e1374 = core_intrinsics_maximum_number_nsz_f32_(_e1373, (_e1357 - _e338));
                                                let _e1375 = core_intrinsics_minimum_number_nsz_f32_((_e1363 + _e336), (_e1366 + _e337));
                                                let _e1376 = core_intrinsics_minimum_number_nsz_f32_(_e1375, (_e1369 + _e338));
                                                if (_e1374 > -300000000000000000000000000000000000000f) {
                                                    phi_1987_ = _e1374;
                                                } else {
                                                    phi_1987_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1379 = phi_1987_;
                                                if (_e1376 < 300000000000000000000000000000000000000f) {
                                                    phi_1992_ = _e1376;
                                                } else {
                                                    phi_1992_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1382 = phi_1992_;
                                                if (_e1250 < _e1379) {
                                                    phi_1997_ = _e1379;
                                                } else {
                                                    phi_1997_ = _e1250;
                                                }
                                                let _e1385 = phi_1997_;
                                                if (_e1385 > _e1382) {
                                                    phi_2002_ = _e1382;
                                                } else {
                                                    phi_2002_ = _e1385;
                                                }
                                                let _e1388 = phi_2002_;
                                                phi_2007_ = lt_bvh_triangle_Intersection(_e1388, (_e1091 / _e1150), (_e1112 / _e1150), (_e1379 <= _e1382));
                                                phi_2008_ = false;
                                            } else {
                                                phi_2007_ = lt_bvh_triangle_Intersection();
                                                phi_2008_ = true;
                                            }
                                            let _e1394 = phi_2007_;
                                            let _e1396 = phi_2008_;
                                            phi_2009_ = _e1394;
                                            phi_2010_ = _e1396;
                                        } else {
                                            phi_2009_ = lt_bvh_triangle_Intersection();
                                            phi_2010_ = true;
                                        }
                                        let _e1398 = phi_2009_;
                                        let _e1400 = phi_2010_;
                                        if _e1400 {
                                        }
                                        phi_2014_ = _e1398;
                                        phi_2015_ = _e1400;
                                    }
                                    let _e1402 = phi_2014_;
                                    let _e1404 = phi_2015_;
                                    phi_2016_ = _e1402;
                                    phi_2017_ = _e1153;
                                    phi_2018_ = _e1404;
                                } else {
                                    phi_2016_ = lt_bvh_triangle_Intersection();
                                    phi_2017_ = true;
                                    phi_2018_ = false;
                                }
                                let _e1406 = phi_2016_;
                                let _e1408 = phi_2017_;
                                let _e1410 = phi_2018_;
                                if _e1408 {
                                    phi_2022_ = true;
                                } else {
                                    phi_2022_ = _e1410;
                                }
                                let _e1412 = phi_2022_;
                                if _e1412 {
                                    phi_2026_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2026_ = _e1406;
                                }
                                let _e1414 = phi_2026_;
                                if _e1414.is_hit {
                                    if (_e1414.t > 0f) {
                                        if (_e1414.t < _e136) {
                                            let _e1421 = triangles.member[(0u + _e966)].i0_;
                                            if ((_e1421 & 2147483648u) == 0u) {
                                                phi_2245_ = true;
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
                                                        phi_2243_ = true;
                                                    } else {
                                                        let _e1486 = (_e1454.base_color.w * ((((f32((_e1448[0].color >> bitcast<u32>(24i))) * _e1459) + (f32((_e1448[1].color >> bitcast<u32>(24i))) * _e1414.u)) + (f32((_e1448[2].color >> bitcast<u32>(24i))) * _e1414.v)) * (1f / 255f)));
                                                        if (_e1454.alpha_size == 0u) {
                                                            phi_2240_ = _e1486;
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
                                                            phi_2240_ = (_e1486 * (((((f32(((_e1525 >> bitcast<u32>((((_e1517.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.x) + ((f32(((_e1545 >> bitcast<u32>((((_e1517.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.y)) + ((f32(((_e1566 >> bitcast<u32>((((_e1517.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.z)) + ((f32(((_e1587 >> bitcast<u32>((((_e1517.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.w)));
                                                        }
                                                        let _e1603 = phi_2240_;
                                                        phi_2243_ = (_e1603 >= _e1454.cutoff);
                                                    }
                                                    let _e1607 = phi_2243_;
                                                    phi_2244_ = _e1607;
                                                } else {
                                                    phi_2244_ = false;
                                                }
                                                let _e1609 = phi_2244_;
                                                phi_2245_ = _e1609;
                                            }
                                            let _e1611 = phi_2245_;
                                            if _e1611 {
                                                phi_2249_ = false;
                                            } else {
                                                phi_2249_ = true;
                                            }
                                            let _e1613 = phi_2249_;
                                            phi_2250_ = _e1611;
                                            phi_2251_ = _e1611;
                                            phi_2252_ = _e1613;
                                        } else {
                                            phi_2250_ = bool();
                                            phi_2251_ = _e957;
                                            phi_2252_ = true;
                                        }
                                        let _e1615 = phi_2250_;
                                        let _e1617 = phi_2251_;
                                        let _e1619 = phi_2252_;
                                        phi_2253_ = _e1615;
                                        phi_2254_ = _e1617;
                                        phi_2255_ = _e1619;
                                    } else {
                                        phi_2253_ = bool();
                                        phi_2254_ = _e957;
                                        phi_2255_ = true;
                                    }
                                    let _e1621 = phi_2253_;
                                    let _e1623 = phi_2254_;
                                    let _e1625 = phi_2255_;
                                    phi_2256_ = _e1621;
                                    phi_2257_ = _e1623;
                                    phi_2258_ = _e1625;
                                } else {
                                    phi_2256_ = bool();
                                    phi_2257_ = _e957;
                                    phi_2258_ = true;
                                }
                                let _e1627 = phi_2256_;
                                let _e1629 = phi_2257_;
                                let _e1631 = phi_2258_;
                                if _e1631 {
                                }
                                phi_1456_ = (_e955 & (_e955 - 1u));
                                phi_1459_ = _e1629;
                                phi_2262_ = _e1627;
                                phi_2263_ = _e1631;
                            }
                            let _e1633 = phi_1456_;
                            let _e1635 = phi_1459_;
                            let _e1637 = phi_2262_;
                            let _e1639 = phi_2263_;
                            local_8 = _e1637;
                            continue;
                            continuing {
                                phi_1455_ = _e1633;
                                phi_1458_ = _e1635;
                                break if !(_e1639);
                            }
                        }
                        let _e1642 = local_5;
                        if _e1642 {
                            let _e1644 = local_1.group_mask;
                            if ((_e1644 & 4278190080u) == 0u) {
                                let _e1648 = local_1.len;
                                if (_e1648 == 0u) {
                                    phi_2305_ = false;
                                } else {
                                    let _e1652 = local_1.len;
                                    local_1.len = (_e1652 - 1u);
                                    let _e1655 = local_1.len;
                                    if (_e1655 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1660 = local_1.first[(0u + _e1655)];
                                    local_1.group = _e1660;
                                    let _e1663 = local_1.len;
                                    if (_e1663 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1668 = local_1.mask[(0u + _e1663)];
                                    local_1.group_mask = _e1668;
                                    phi_2305_ = true;
                                }
                                let _e1671 = phi_2305_;
                                phi_2306_ = _e1671;
                            } else {
                                phi_2306_ = true;
                            }
                            let _e1673 = phi_2306_;
                            if _e1673 {
                                let _e1675 = local_1.group_mask;
                                let _e1681 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1675)), 32u, (_e1675 == 0u)));
                                let _e1685 = local_1.group_mask;
                                let _e1699 = local_1.group_mask;
                                local_1.group_mask = (_e1699 & ~((1u << bitcast<u32>((_e1681 & 31u)))));
                                let _e1702 = local_1.group;
                                phi_2337_ = (_e1702 + countOneBits(((_e1685 & ~((4294967295u << bitcast<u32>((((_e1681 - 24u) ^ _e379) & 31u))))) & 255u)));
                            } else {
                                phi_2337_ = 4294967295u;
                            }
                            let _e1705 = phi_2337_;
                            phi_2338_ = _e1705;
                        } else {
                            phi_2338_ = u32();
                        }
                        let _e1707 = phi_2338_;
                        phi_1124_ = _e1707;
                        let _e1913 = local_7;
                        phi_1127_ = _e1913;
                        let _e1916 = local_8;
                        phi_2339_ = _e1916;
                        let _e1919 = local_9;
                        phi_2340_ = _e1919;
                        phi_2341_ = false;
                    } else {
                        phi_1124_ = u32();
                        phi_1127_ = bool();
                        phi_2339_ = bool();
                        phi_2340_ = false;
                        phi_2341_ = true;
                    }
                    let _e1709 = phi_1124_;
                    let _e1711 = phi_1127_;
                    let _e1713 = phi_2339_;
                    let _e1715 = phi_2340_;
                    let _e1717 = phi_2341_;
                    local_6 = _e1717;
                    local_10 = _e1713;
                    continue;
                    continuing {
                        phi_1123_ = _e1709;
                        phi_1126_ = _e1711;
                        break if !(_e1715);
                    }
                }
                let _e1720 = local_6;
                if _e1720 {
                    phi_2345_ = false;
                } else {
                    phi_2345_ = true;
                }
                let _e1722 = phi_2345_;
                if _e1722 {
                    let _e1925 = local_10;
                    phi_2349_ = _e1925;
                } else {
                    let _e1927 = local_11;
                    phi_2349_ = _e1927;
                }
                let _e1724 = phi_2349_;
                phi_2350_ = _e1724;
            }
            let _e1726 = phi_2350_;
            phi_2351_ = _e1726;
            phi_2352_ = _e201;
        } else {
            phi_2351_ = bool();
            phi_2352_ = true;
        }
        let _e1728 = phi_2351_;
        let _e1730 = phi_2352_;
        if _e1730 {
            phi_2356_ = false;
        } else {
            phi_2356_ = _e1728;
        }
        let _e1732 = phi_2356_;
        if _e1732 {
            phi_2360_ = 0f;
        } else {
            phi_2360_ = 1f;
        }
        let _e1734 = phi_2360_;
        if (_e106 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e1734;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
