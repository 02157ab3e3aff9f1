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
    var phi_678_: f32;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_716_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_736_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
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
    var phi_900_: f32;
    var phi_905_: f32;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_940_: u32;
    var phi_941_: u32;
    var phi_952_: vec3<f32>;
    var phi_953_: vec3<f32>;
    var phi_966_: u32;
    var phi_971_: u32;
    var phi_976_: u32;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1122_: u32;
    var phi_1124_: u32;
    var phi_1127_: bool;
    var phi_1207_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1234_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1261_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1267_: u32;
    var phi_1270_: u32;
    var phi_1284_: u32;
    var phi_1294_: u32;
    var phi_1304_: u32;
    var phi_1322_: u32;
    var phi_1332_: u32;
    var phi_1342_: u32;
    var phi_1378_: u32;
    var phi_1391_: u32;
    var phi_1396_: u32;
    var phi_1397_: u32;
    var phi_1398_: u32;
    var phi_1268_: u32;
    var phi_1271_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1456_: u32;
    var phi_1459_: bool;
    var phi_1503_: vec3<f32>;
    var phi_1504_: vec3<f32>;
    var phi_1533_: vec3<f32>;
    var phi_1534_: vec3<f32>;
    var phi_1563_: vec3<f32>;
    var phi_1564_: vec3<f32>;
    var phi_1582_: bool;
    var phi_1583_: bool;
    var phi_1587_: f32;
    var phi_1588_: f32;
    var phi_1589_: f32;
    var phi_1590_: f32;
    var phi_1598_: f32;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1613_: f32;
    var phi_1614_: f32;
    var phi_1615_: f32;
    var phi_1616_: f32;
    var phi_1624_: f32;
    var phi_1634_: bool;
    var phi_1635_: bool;
    var phi_1639_: f32;
    var phi_1640_: f32;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1650_: f32;
    var phi_1665_: f32;
    var phi_1666_: bool;
    var phi_1667_: f32;
    var phi_1668_: bool;
    var phi_1669_: f32;
    var phi_1670_: bool;
    var phi_1688_: f32;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1691_: f32;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1697_: bool;
    var phi_1698_: f32;
    var phi_1699_: bool;
    var phi_1727_: vec3<f32>;
    var phi_1728_: vec3<f32>;
    var phi_1753_: vec3<f32>;
    var phi_1754_: vec3<f32>;
    var phi_1779_: vec3<f32>;
    var phi_1780_: vec3<f32>;
    var phi_1836_: f32;
    var phi_1845_: f32;
    var phi_1854_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1877_: f32;
    var phi_1890_: f32;
    var phi_1899_: f32;
    var phi_1908_: f32;
    var phi_1917_: f32;
    var phi_1924_: f32;
    var phi_1931_: f32;
    var phi_1948_: f32;
    var phi_1953_: f32;
    var phi_1958_: f32;
    var phi_1966_: f32;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_1998_: f32;
    var phi_2003_: f32;
    var phi_2008_: lt_bvh_triangle_Intersection;
    var phi_2009_: bool;
    var phi_2010_: lt_bvh_triangle_Intersection;
    var phi_2011_: bool;
    var phi_2015_: lt_bvh_triangle_Intersection;
    var phi_2016_: bool;
    var phi_2017_: lt_bvh_triangle_Intersection;
    var phi_2018_: bool;
    var phi_2019_: bool;
    var phi_2023_: bool;
    var phi_2027_: lt_bvh_triangle_Intersection;
    var phi_2241_: f32;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2258_: bool;
    var phi_2259_: bool;
    var phi_1457_: u32;
    var phi_1460_: bool;
    var phi_2263_: bool;
    var phi_2264_: bool;
    var local_5: bool;
    var phi_2306_: bool;
    var phi_2307_: bool;
    var phi_2338_: u32;
    var phi_2339_: u32;
    var phi_1125_: u32;
    var phi_1128_: bool;
    var phi_2340_: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var local_6: bool;
    var phi_2346_: bool;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2357_: bool;
    var phi_2361_: f32;
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
        let _e107 = (_e106 & 2147483647u);
        if (_e107 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e113 = samples.member[(0u + _e107)].position;
        let _e115 = samples.member[(0u + _e107)].normal;
        let _e117 = samples.member[(0u + _e107)].magnitude;
        let _e119 = ((8f / 8388608f) * _e117);
        let _e127 = (_e113.x + (_e115.x * _e119));
        let _e129 = (_e113.y + (_e115.y * _e119));
        let _e131 = (_e113.z + (_e115.z * _e119));
        let _e133 = p.member.light.place;
        if (_e133.w == 0f) {
            phi_678_ = 300000000000000000000000000000000000000f;
        } else {
            phi_678_ = 1f;
        }
        let _e137 = phi_678_;
        let _e145 = (_e133.x - (_e127 * _e133.w));
        let _e146 = (_e133.y - (_e129 * _e133.w));
        let _e147 = (_e133.z - (_e131 * _e133.w));
        let _e149 = abs(_e145);
        let _e150 = abs(_e146);
        let _e151 = abs(_e147);
        if (abs(_e127) < 1000000000000000f) {
            if (abs(_e129) < 1000000000000000f) {
                phi_709_ = (abs(_e131) < 1000000000000000f);
                phi_710_ = false;
            } else {
                phi_709_ = bool();
                phi_710_ = true;
            }
            let _e159 = phi_709_;
            let _e161 = phi_710_;
            phi_711_ = _e159;
            phi_712_ = _e161;
        } else {
            phi_711_ = bool();
            phi_712_ = true;
        }
        let _e163 = phi_711_;
        let _e165 = phi_712_;
        if _e165 {
            phi_716_ = false;
        } else {
            phi_716_ = _e163;
        }
        let _e167 = phi_716_;
        if _e167 {
            if (_e149 < 1000000000000000f) {
                if (_e150 < 1000000000000000f) {
                    phi_729_ = (_e151 < 1000000000000000f);
                    phi_730_ = false;
                } else {
                    phi_729_ = bool();
                    phi_730_ = true;
                }
                let _e172 = phi_729_;
                let _e174 = phi_730_;
                phi_731_ = _e172;
                phi_732_ = _e174;
            } else {
                phi_731_ = bool();
                phi_732_ = true;
            }
            let _e176 = phi_731_;
            let _e178 = phi_732_;
            if _e178 {
                phi_736_ = false;
            } else {
                phi_736_ = _e176;
            }
            let _e180 = phi_736_;
            if _e180 {
                if (_e149 > 0f) {
                    phi_750_ = bool();
                    phi_751_ = true;
                } else {
                    let _e182 = (_e150 > 0f);
                    if _e182 {
                        phi_749_ = bool();
                    } else {
                        phi_749_ = (_e151 > 0f);
                    }
                    let _e185 = phi_749_;
                    phi_750_ = _e185;
                    phi_751_ = _e182;
                }
                let _e187 = phi_750_;
                let _e189 = phi_751_;
                if _e189 {
                    phi_755_ = true;
                } else {
                    phi_755_ = _e187;
                }
                let _e191 = phi_755_;
                phi_756_ = _e191;
                phi_757_ = false;
            } else {
                phi_756_ = bool();
                phi_757_ = true;
            }
            let _e193 = phi_756_;
            let _e195 = phi_757_;
            phi_758_ = _e193;
            phi_759_ = _e195;
        } else {
            phi_758_ = bool();
            phi_759_ = true;
        }
        let _e197 = phi_758_;
        let _e199 = phi_759_;
        if _e199 {
            phi_763_ = false;
        } else {
            phi_763_ = _e197;
        }
        let _e201 = phi_763_;
        if _e201 {
            let _e202 = (0u >= _e75);
            if _e202 {
                phi_2351_ = bool();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e208 = nodes.member[(0u + 0u)].frame[0u];
                let _e212 = nodes.member[(0u + 0u)].frame[1u];
                let _e216 = nodes.member[(0u + 0u)].frame[2u];
                let _e220 = nodes.member[(0u + 0u)].frame[0u];
                let _e224 = nodes.member[(0u + 0u)].frame[1u];
                let _e228 = nodes.member[(0u + 0u)].frame[2u];
                let _e232 = nodes.member[(0u + 0u)].frame[3u];
                let _e266 = core_intrinsics_maximum_number_nsz_f32_(abs(_e145), abs(_e146));
                let _e267 = core_intrinsics_maximum_number_nsz_f32_(_e266, abs(_e147));
                let _e268 = (_e267 * 0.0000000000009094947f);
                if (abs(_e145) < _e268) {
                    phi_833_ = _e268;
                } else {
                    phi_833_ = abs(_e145);
                }
                let _e273 = phi_833_;
                if (_e145 < 0f) {
                    phi_840_ = (-1f / _e273);
                } else {
                    phi_840_ = (1f / _e273);
                }
                let _e278 = phi_840_;
                if (abs(_e146) < _e268) {
                    phi_847_ = _e268;
                } else {
                    phi_847_ = abs(_e146);
                }
                let _e283 = phi_847_;
                if (_e146 < 0f) {
                    phi_854_ = (-1f / _e283);
                } else {
                    phi_854_ = (1f / _e283);
                }
                let _e288 = phi_854_;
                if (abs(_e147) < _e268) {
                    phi_861_ = _e268;
                } else {
                    phi_861_ = abs(_e147);
                }
                let _e293 = phi_861_;
                if (_e147 < 0f) {
                    phi_868_ = (-1f / _e293);
                } else {
                    phi_868_ = (1f / _e293);
                }
                let _e298 = phi_868_;
                let _e302 = abs((bitcast<f32>(_e208) - _e127));
                let _e303 = abs((bitcast<f32>(_e212) - _e129));
                let _e304 = abs((bitcast<f32>(_e216) - _e131));
                let _e308 = abs(((bitcast<f32>(_e220) + (bitcast<f32>((((_e232 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e127));
                let _e309 = abs(((bitcast<f32>(_e224) + (bitcast<f32>((((_e232 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e129));
                let _e310 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e232 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                if (_e302 > _e308) {
                    phi_885_ = _e302;
                } else {
                    phi_885_ = _e308;
                }
                let _e313 = phi_885_;
                if (_e303 > _e309) {
                    phi_890_ = _e303;
                } else {
                    phi_890_ = _e309;
                }
                let _e316 = phi_890_;
                if (_e304 > _e310) {
                    phi_895_ = _e304;
                } else {
                    phi_895_ = _e310;
                }
                let _e319 = phi_895_;
                if (_e313 > _e316) {
                    phi_900_ = _e313;
                } else {
                    phi_900_ = _e316;
                }
                let _e322 = phi_900_;
                if (_e322 > _e319) {
                    phi_905_ = _e322;
                } else {
                    phi_905_ = _e319;
                }
                let _e325 = phi_905_;
                let _e329 = (_e325 * 0.0000019073486f);
                let _e330 = (abs(_e278) * _e329);
                let _e331 = (abs(_e288) * _e329);
                let _e332 = (abs(_e298) * _e329);
                let _e336 = (_e325 * 0.0000009536743f);
                let _e337 = (abs(_e278) * _e336);
                let _e338 = (abs(_e288) * _e336);
                let _e339 = (abs(_e298) * _e336);
                let _e340 = abs(_e145);
                let _e341 = abs(_e146);
                let _e342 = abs(_e147);
                if (_e340 >= _e341) {
                    if (_e340 >= _e342) {
                        phi_931_ = false;
                    } else {
                        phi_931_ = true;
                    }
                    let _e346 = phi_931_;
                    phi_932_ = _e346;
                } else {
                    phi_932_ = true;
                }
                let _e348 = phi_932_;
                if _e348 {
                    if (_e341 >= _e342) {
                        phi_940_ = 1u;
                    } else {
                        phi_940_ = 2u;
                    }
                    let _e351 = phi_940_;
                    phi_941_ = _e351;
                } else {
                    phi_941_ = 0u;
                }
                let _e353 = phi_941_;
                if (_e353 == 0u) {
                    phi_953_ = vec3<f32>(_e146, _e147, _e145);
                } else {
                    if (_e353 == 1u) {
                        phi_952_ = vec3<f32>(_e147, _e145, _e146);
                    } else {
                        phi_952_ = vec3<f32>(_e145, _e146, _e147);
                    }
                    let _e359 = phi_952_;
                    phi_953_ = _e359;
                }
                let _e361 = phi_953_;
                let _e364 = (_e361.x / _e361.z);
                let _e367 = (_e361.y / _e361.z);
                if (_e278 < 0f) {
                    phi_966_ = 0u;
                } else {
                    phi_966_ = 1u;
                }
                let _e372 = phi_966_;
                if (_e288 < 0f) {
                    phi_971_ = 0u;
                } else {
                    phi_971_ = 2u;
                }
                let _e375 = phi_971_;
                if (_e298 < 0f) {
                    phi_976_ = 0u;
                } else {
                    phi_976_ = 4u;
                }
                let _e378 = phi_976_;
                let _e380 = ((_e372 | _e375) | _e378);
                let _e381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e381.first[0], _e381.first[1], _e381.first[2], _e381.first[3], _e381.first[4], _e381.first[5], _e381.first[6], _e381.first[7], _e381.first[8], _e381.first[9], _e381.first[10], _e381.first[11], _e381.first[12], _e381.first[13], _e381.first[14], _e381.first[15], _e381.first[16], _e381.first[17], _e381.first[18], _e381.first[19], _e381.first[20], _e381.first[21], _e381.first[22], _e381.first[23], _e381.first[24], _e381.first[25], _e381.first[26], _e381.first[27], _e381.first[28], _e381.first[29], _e381.first[30], _e381.first[31]), array<u32, 32>(_e381.mask[0], _e381.mask[1], _e381.mask[2], _e381.mask[3], _e381.mask[4], _e381.mask[5], _e381.mask[6], _e381.mask[7], _e381.mask[8], _e381.mask[9], _e381.mask[10], _e381.mask[11], _e381.mask[12], _e381.mask[13], _e381.mask[14], _e381.mask[15], _e381.mask[16], _e381.mask[17], _e381.mask[18], _e381.mask[19], _e381.mask[20], _e381.mask[21], _e381.mask[22], _e381.mask[23], _e381.mask[24], _e381.mask[25], _e381.mask[26], _e381.mask[27], _e381.mask[28], _e381.mask[29], _e381.mask[30], _e381.mask[31]), _e381.len, _e381.group, _e381.group_mask);
                let _e455 = local_1.group_mask;
                if ((_e455 & 4278190080u) == 0u) {
                    let _e459 = local_1.len;
                    if (_e459 == 0u) {
                        phi_1090_ = false;
                    } else {
                        let _e463 = local_1.len;
                        local_1.len = (_e463 - 1u);
                        let _e466 = local_1.len;
                        if (_e466 < 32u) {
                        } else {
                            return;
                        }
                        let _e471 = local_1.first[(0u + _e466)];
                        local_1.group = _e471;
                        let _e474 = local_1.len;
                        if (_e474 < 32u) {
                        } else {
                            return;
                        }
                        let _e479 = local_1.mask[(0u + _e474)];
                        local_1.group_mask = _e479;
                        phi_1090_ = true;
                    }
                    let _e482 = phi_1090_;
                    phi_1091_ = _e482;
                } else {
                    phi_1091_ = true;
                }
                let _e484 = phi_1091_;
                if _e484 {
                    let _e486 = local_1.group_mask;
                    let _e492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e486)), 32u, (_e486 == 0u)));
                    let _e496 = local_1.group_mask;
                    let _e510 = local_1.group_mask;
                    local_1.group_mask = (_e510 & ~((1u << bitcast<u32>((_e492 & 31u)))));
                    let _e513 = local_1.group;
                    phi_1122_ = (_e513 + countOneBits(((_e496 & ~((4294967295u << bitcast<u32>((((_e492 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1122_ = 4294967295u;
                }
                let _e516 = phi_1122_;
                phi_1124_ = _e516;
                phi_1127_ = false;
                loop {
                    let _e518 = phi_1124_;
                    let _e520 = phi_1127_;
                    local_11 = _e520;
                    if (_e518 != 4294967295u) {
                        if (_e518 < _e75) {
                        } else {
                            return;
                        }
                        let _e527 = nodes.member[(0u + _e518)].frame[3u];
                        let _e552 = (bitcast<f32>((((_e527 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e278);
                        let _e553 = (bitcast<f32>((((_e527 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e288);
                        let _e554 = (bitcast<f32>((((_e527 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e298);
                        let _e557 = nodes.member[(0u + _e518)].frame[0u];
                        let _e561 = nodes.member[(0u + _e518)].frame[1u];
                        let _e565 = nodes.member[(0u + _e518)].frame[2u];
                        let _e570 = ((bitcast<f32>(_e557) - _e127) * _e278);
                        let _e571 = ((bitcast<f32>(_e561) - _e129) * _e288);
                        let _e572 = ((bitcast<f32>(_e565) - _e131) * _e298);
                        let _e580 = nodes.member[(0u + _e518)].x;
                        if (_e278 < 0f) {
                            let _e591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e591.unnamed.root, _e580.w), _e591.unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e597.unnamed, lt_bvh_traverse_Tree(_e580.x, _e597.unnamed_1.first_primitive));
                            phi_1207_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e603.unnamed_1.root, _e580.y));
                        } else {
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e619.unnamed.root, _e580.y), _e619.unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e580.z, _e625.unnamed_1.first_primitive));
                            phi_1207_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_bvh_traverse_Tree(_e631.unnamed_1.root, _e580.w));
                        }
                        let _e639 = phi_1207_;
                        let _e649 = nodes.member[(0u + _e518)].y;
                        if (_e288 < 0f) {
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e660.unnamed.root, _e649.w), _e660.unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_bvh_traverse_Tree(_e649.x, _e666.unnamed_1.first_primitive));
                            phi_1234_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e672.unnamed_1.root, _e649.y));
                        } else {
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.unnamed.root, _e649.y), _e688.unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e649.z, _e694.unnamed_1.first_primitive));
                            phi_1234_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e700.unnamed_1.root, _e649.w));
                        }
                        let _e708 = phi_1234_;
                        let _e718 = nodes.member[(0u + _e518)].z;
                        if (_e298 < 0f) {
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e729.unnamed.root, _e718.w), _e729.unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e718.x, _e735.unnamed_1.first_primitive));
                            phi_1261_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e741.unnamed_1.root, _e718.y));
                        } else {
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.unnamed.root, _e718.y), _e757.unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e718.z, _e763.unnamed_1.first_primitive));
                            phi_1261_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e769.unnamed_1.root, _e718.w));
                        }
                        let _e777 = phi_1261_;
                        phi_1267_ = 0u;
                        phi_1270_ = 0u;
                        loop {
                            let _e787 = phi_1267_;
                            let _e789 = phi_1270_;
                            local_2 = _e789;
                            local_3 = _e789;
                            local_4 = _e789;
                            let _e790 = (_e787 < 8u);
                            if _e790 {
                                let _e792 = (_e787 >> bitcast<u32>(2i));
                                let _e793 = (_e787 & 3u);
                                if (_e792 == 0u) {
                                    phi_1284_ = _e639.unnamed.root;
                                } else {
                                    phi_1284_ = _e639.unnamed.first_primitive;
                                }
                                let _e796 = phi_1284_;
                                if (_e792 == 0u) {
                                    phi_1294_ = _e708.unnamed.root;
                                } else {
                                    phi_1294_ = _e708.unnamed.first_primitive;
                                }
                                let _e805 = phi_1294_;
                                if (_e792 == 0u) {
                                    phi_1304_ = _e777.unnamed.root;
                                } else {
                                    phi_1304_ = _e777.unnamed.first_primitive;
                                }
                                let _e814 = phi_1304_;
                                let _e827 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e796 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e552) + (_e570 - _e330)), ((f32(((_e805 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e553) + (_e571 - _e331)));
                                let _e828 = core_intrinsics_maximum_number_nsz_f32_(_e827, ((f32(((_e814 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e554) + (_e572 - _e332)));
                                if (_e792 == 0u) {
                                    phi_1322_ = _e639.unnamed_1.root;
                                } else {
                                    phi_1322_ = _e639.unnamed_1.first_primitive;
                                }
                                let _e831 = phi_1322_;
                                if (_e792 == 0u) {
                                    phi_1332_ = _e708.unnamed_1.root;
                                } else {
                                    phi_1332_ = _e708.unnamed_1.first_primitive;
                                }
                                let _e840 = phi_1332_;
                                if (_e792 == 0u) {
                                    phi_1342_ = _e777.unnamed_1.root;
                                } else {
                                    phi_1342_ = _e777.unnamed_1.first_primitive;
                                }
                                let _e849 = phi_1342_;
                                let _e862 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e831 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e552) + (_e570 + _e330)), ((f32(((_e840 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e553) + (_e571 + _e331)));
                                let _e863 = core_intrinsics_minimum_number_nsz_f32_(_e862, ((f32(((_e849 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e554) + (_e572 + _e332)));
                                if (_e828 <= _e863) {
                                    if (_e828 <= _e137) {
                                        if (_e863 >= 0f) {
                                            if (_e792 == 0u) {
                                                let _e870 = nodes.member[(0u + _e518)].links[2u];
                                                phi_1378_ = _e870;
                                            } else {
                                                let _e873 = nodes.member[(0u + _e518)].links[3u];
                                                phi_1378_ = _e873;
                                            }
                                            let _e875 = phi_1378_;
                                            let _e880 = ((_e875 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u);
                                            let _e881 = (_e880 & 31u);
                                            if (_e881 >= 24u) {
                                                phi_1391_ = (24u + ((_e881 - 24u) ^ _e380));
                                            } else {
                                                phi_1391_ = _e881;
                                            }
                                            let _e887 = phi_1391_;
                                            phi_1396_ = (_e789 | ((_e880 >> bitcast<u32>(5i)) << bitcast<u32>((_e887 & 31u))));
                                        } else {
                                            phi_1396_ = _e789;
                                        }
                                        let _e895 = phi_1396_;
                                        phi_1397_ = _e895;
                                    } else {
                                        phi_1397_ = _e789;
                                    }
                                    let _e897 = phi_1397_;
                                    phi_1398_ = _e897;
                                } else {
                                    phi_1398_ = _e789;
                                }
                                let _e899 = phi_1398_;
                                phi_1268_ = (_e787 + 1u);
                                phi_1271_ = _e899;
                            } else {
                                phi_1268_ = u32();
                                phi_1271_ = u32();
                            }
                            let _e902 = phi_1268_;
                            let _e904 = phi_1271_;
                            continue;
                            continuing {
                                phi_1267_ = _e902;
                                phi_1270_ = _e904;
                                break if !(_e790);
                            }
                        }
                        let _e908 = nodes.member[(0u + _e518)].links[0u];
                        let _e912 = nodes.member[(0u + _e518)].frame[3u];
                        let _e916 = local_2;
                        if ((_e916 & 4278190080u) == 0u) {
                        } else {
                            let _e920 = local_1.group_mask;
                            if ((_e920 & 4278190080u) == 0u) {
                            } else {
                                let _e924 = local_1.len;
                                if (_e924 < 32u) {
                                    let _e927 = local_1.group;
                                    let _e929 = local_1.len;
                                    if (_e929 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e929)] = _e927;
                                    let _e935 = local_1.group_mask;
                                    let _e937 = local_1.len;
                                    if (_e937 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e937)] = _e935;
                                    let _e944 = local_1.len;
                                    local_1.len = (_e944 + 1u);
                                }
                            }
                            local_1.group = (0u + _e908);
                            let _e948 = local_3;
                            local_1.group_mask = ((_e948 & 4278190080u) | (_e912 >> bitcast<u32>(24i)));
                        }
                        let _e953 = local_4;
                        phi_1456_ = (_e953 & 16777215u);
                        phi_1459_ = _e520;
                        loop {
                            let _e956 = phi_1456_;
                            let _e958 = phi_1459_;
                            local_7 = _e958;
                            let _e959 = (_e956 == 0u);
                            local_5 = _e959;
                            local_9 = _e959;
                            if _e959 {
                                phi_1457_ = u32();
                                phi_1460_ = bool();
                                phi_2263_ = bool();
                                phi_2264_ = false;
                            } else {
                                let _e962 = nodes.member[(0u + _e518)].links[1u];
                                let _e967 = ((0u + _e962) + select(firstTrailingBit(_e956), 32u, (_e956 == 0u)));
                                if (_e967 < _e78) {
                                } else {
                                    return;
                                }
                                let _e974 = triangles.member[(0u + _e967)].v0_;
                                let _e976 = (_e974.x - _e127);
                                let _e978 = (_e974.y - _e129);
                                let _e980 = (_e974.z - _e131);
                                if (_e353 == 0u) {
                                    phi_1504_ = vec3<f32>(_e978, _e980, _e976);
                                } else {
                                    if (_e353 == 1u) {
                                        phi_1503_ = vec3<f32>(_e980, _e976, _e978);
                                    } else {
                                        phi_1503_ = (_e974 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e988 = phi_1503_;
                                    phi_1504_ = _e988;
                                }
                                let _e990 = phi_1504_;
                                let _e994 = (_e990.x - (_e364 * _e990.z));
                                let _e998 = (_e990.y - (_e367 * _e990.z));
                                let _e1000 = triangles.member[(0u + _e967)].v1_;
                                let _e1002 = (_e1000.x - _e127);
                                let _e1004 = (_e1000.y - _e129);
                                let _e1006 = (_e1000.z - _e131);
                                if (_e353 == 0u) {
                                    phi_1534_ = vec3<f32>(_e1004, _e1006, _e1002);
                                } else {
                                    if (_e353 == 1u) {
                                        phi_1533_ = vec3<f32>(_e1006, _e1002, _e1004);
                                    } else {
                                        phi_1533_ = (_e1000 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1014 = phi_1533_;
                                    phi_1534_ = _e1014;
                                }
                                let _e1016 = phi_1534_;
                                let _e1020 = (_e1016.x - (_e364 * _e1016.z));
                                let _e1024 = (_e1016.y - (_e367 * _e1016.z));
                                let _e1026 = triangles.member[(0u + _e967)].v2_;
                                let _e1028 = (_e1026.x - _e127);
                                let _e1030 = (_e1026.y - _e129);
                                let _e1032 = (_e1026.z - _e131);
                                if (_e353 == 0u) {
                                    phi_1564_ = vec3<f32>(_e1030, _e1032, _e1028);
                                } else {
                                    if (_e353 == 1u) {
                                        phi_1563_ = vec3<f32>(_e1032, _e1028, _e1030);
                                    } else {
                                        phi_1563_ = (_e1026 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1040 = phi_1563_;
                                    phi_1564_ = _e1040;
                                }
                                let _e1042 = phi_1564_;
                                let _e1046 = (_e1042.x - (_e364 * _e1042.z));
                                let _e1050 = (_e1042.y - (_e367 * _e1042.z));
                                if (_e1020 < _e1046) {
                                    phi_1583_ = true;
                                } else {
                                    if (_e1020 == _e1046) {
                                        phi_1582_ = (_e1024 < _e1050);
                                    } else {
                                        phi_1582_ = false;
                                    }
                                    let _e1055 = phi_1582_;
                                    phi_1583_ = _e1055;
                                }
                                let _e1057 = phi_1583_;
                                if _e1057 {
                                    phi_1587_ = _e1050;
                                    phi_1588_ = _e1046;
                                    phi_1589_ = _e1024;
                                    phi_1590_ = _e1020;
                                } else {
                                    phi_1587_ = _e1024;
                                    phi_1588_ = _e1020;
                                    phi_1589_ = _e1050;
                                    phi_1590_ = _e1046;
                                }
                                let _e1059 = phi_1587_;
                                let _e1061 = phi_1588_;
                                let _e1063 = phi_1589_;
                                let _e1065 = phi_1590_;
                                let _e1068 = ((_e1065 * _e1059) - (_e1063 * _e1061));
                                if _e1057 {
                                    phi_1598_ = -(_e1068);
                                } else {
                                    phi_1598_ = _e1068;
                                }
                                let _e1071 = phi_1598_;
                                if (_e1046 < _e994) {
                                    phi_1609_ = true;
                                } else {
                                    if (_e1046 == _e994) {
                                        phi_1608_ = (_e1050 < _e998);
                                    } else {
                                        phi_1608_ = false;
                                    }
                                    let _e1076 = phi_1608_;
                                    phi_1609_ = _e1076;
                                }
                                let _e1078 = phi_1609_;
                                if _e1078 {
                                    phi_1613_ = _e998;
                                    phi_1614_ = _e994;
                                    phi_1615_ = _e1050;
                                    phi_1616_ = _e1046;
                                } else {
                                    phi_1613_ = _e1050;
                                    phi_1614_ = _e1046;
                                    phi_1615_ = _e998;
                                    phi_1616_ = _e994;
                                }
                                let _e1080 = phi_1613_;
                                let _e1082 = phi_1614_;
                                let _e1084 = phi_1615_;
                                let _e1086 = phi_1616_;
                                let _e1089 = ((_e1086 * _e1080) - (_e1084 * _e1082));
                                if _e1078 {
                                    phi_1624_ = -(_e1089);
                                } else {
                                    phi_1624_ = _e1089;
                                }
                                let _e1092 = phi_1624_;
                                if (_e994 < _e1020) {
                                    phi_1635_ = true;
                                } else {
                                    if (_e994 == _e1020) {
                                        phi_1634_ = (_e998 < _e1024);
                                    } else {
                                        phi_1634_ = false;
                                    }
                                    let _e1097 = phi_1634_;
                                    phi_1635_ = _e1097;
                                }
                                let _e1099 = phi_1635_;
                                if _e1099 {
                                    phi_1639_ = _e1024;
                                    phi_1640_ = _e1020;
                                    phi_1641_ = _e998;
                                    phi_1642_ = _e994;
                                } else {
                                    phi_1639_ = _e998;
                                    phi_1640_ = _e994;
                                    phi_1641_ = _e1024;
                                    phi_1642_ = _e1020;
                                }
                                let _e1101 = phi_1639_;
                                let _e1103 = phi_1640_;
                                let _e1105 = phi_1641_;
                                let _e1107 = phi_1642_;
                                let _e1110 = ((_e1107 * _e1101) - (_e1105 * _e1103));
                                if _e1099 {
                                    phi_1650_ = -(_e1110);
                                } else {
                                    phi_1650_ = _e1110;
                                }
                                let _e1113 = phi_1650_;
                                if (_e1071 >= 0f) {
                                    if (_e1092 >= 0f) {
                                        if (_e1113 >= 0f) {
                                            phi_1665_ = ((_e1071 + _e1092) + _e1113);
                                            phi_1666_ = false;
                                        } else {
                                            phi_1665_ = f32();
                                            phi_1666_ = true;
                                        }
                                        let _e1120 = phi_1665_;
                                        let _e1122 = phi_1666_;
                                        phi_1667_ = _e1120;
                                        phi_1668_ = _e1122;
                                    } else {
                                        phi_1667_ = f32();
                                        phi_1668_ = true;
                                    }
                                    let _e1124 = phi_1667_;
                                    let _e1126 = phi_1668_;
                                    phi_1669_ = _e1124;
                                    phi_1670_ = _e1126;
                                } else {
                                    phi_1669_ = f32();
                                    phi_1670_ = true;
                                }
                                let _e1128 = phi_1669_;
                                let _e1130 = phi_1670_;
                                if _e1130 {
                                    if (_e1071 <= 0f) {
                                        if (_e1092 <= 0f) {
                                            let _e1133 = (_e1113 <= 0f);
                                            if _e1133 {
                                            }
                                            phi_1688_ = ((_e1071 + _e1092) + _e1113);
                                            phi_1689_ = false;
                                            phi_1690_ = _e1133;
                                        } else {
                                            phi_1688_ = f32();
                                            phi_1689_ = true;
                                            phi_1690_ = false;
                                        }
                                        let _e1137 = phi_1688_;
                                        let _e1139 = phi_1689_;
                                        let _e1141 = phi_1690_;
                                        phi_1691_ = _e1137;
                                        phi_1692_ = _e1139;
                                        phi_1693_ = _e1141;
                                    } else {
                                        phi_1691_ = f32();
                                        phi_1692_ = true;
                                        phi_1693_ = false;
                                    }
                                    let _e1143 = phi_1691_;
                                    let _e1145 = phi_1692_;
                                    let _e1147 = phi_1693_;
                                    if _e1145 {
                                        phi_1697_ = false;
                                    } else {
                                        phi_1697_ = _e1147;
                                    }
                                    let _e1149 = phi_1697_;
                                    phi_1698_ = _e1143;
                                    phi_1699_ = _e1149;
                                } else {
                                    phi_1698_ = _e1128;
                                    phi_1699_ = true;
                                }
                                let _e1151 = phi_1698_;
                                let _e1153 = phi_1699_;
                                if _e1153 {
                                    let _e1154 = (_e1151 == 0f);
                                    if _e1154 {
                                        phi_2015_ = lt_bvh_triangle_Intersection();
                                        phi_2016_ = false;
                                    } else {
                                        let _e1156 = triangles.member[(0u + _e967)].v0_;
                                        let _e1158 = (_e1156.x - _e127);
                                        let _e1160 = (_e1156.y - _e129);
                                        let _e1162 = (_e1156.z - _e131);
                                        if (_e353 == 0u) {
                                            phi_1728_ = vec3<f32>(_e1160, _e1162, _e1158);
                                        } else {
                                            if (_e353 == 1u) {
                                                phi_1727_ = vec3<f32>(_e1162, _e1158, _e1160);
                                            } else {
                                                phi_1727_ = (_e1156 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e1170 = phi_1727_;
                                            phi_1728_ = _e1170;
                                        }
                                        let _e1172 = phi_1728_;
                                        let _e1174 = triangles.member[(0u + _e967)].v1_;
                                        let _e1176 = triangles.member[(0u + _e967)].v0_;
                                        let _e1179 = (_e1174.x - _e1176.x);
                                        let _e1182 = (_e1174.y - _e1176.y);
                                        let _e1185 = (_e1174.z - _e1176.z);
                                        if (_e353 == 0u) {
                                            phi_1754_ = vec3<f32>(_e1182, _e1185, _e1179);
                                        } else {
                                            if (_e353 == 1u) {
                                                phi_1753_ = vec3<f32>(_e1185, _e1179, _e1182);
                                            } else {
                                                phi_1753_ = (_e1174 - _e1176);
                                            }
                                            let _e1192 = phi_1753_;
                                            phi_1754_ = _e1192;
                                        }
                                        let _e1194 = phi_1754_;
                                        let _e1196 = triangles.member[(0u + _e967)].v2_;
                                        let _e1198 = triangles.member[(0u + _e967)].v0_;
                                        let _e1201 = (_e1196.x - _e1198.x);
                                        let _e1204 = (_e1196.y - _e1198.y);
                                        let _e1207 = (_e1196.z - _e1198.z);
                                        if (_e353 == 0u) {
                                            phi_1780_ = vec3<f32>(_e1204, _e1207, _e1201);
                                        } else {
                                            if (_e353 == 1u) {
                                                phi_1779_ = vec3<f32>(_e1207, _e1201, _e1204);
                                            } else {
                                                phi_1779_ = (_e1196 - _e1198);
                                            }
                                            let _e1214 = phi_1779_;
                                            phi_1780_ = _e1214;
                                        }
                                        let _e1216 = phi_1780_;
                                        let _e1223 = ((_e1194.y * _e1216.z) - (_e1194.z * _e1216.y));
                                        let _e1230 = ((_e1194.z * _e1216.x) - (_e1194.x * _e1216.z));
                                        let _e1237 = ((_e1194.x * _e1216.y) - (_e1194.y * _e1216.x));
                                        let _e1251 = (((1f / _e361.z) * (((_e1223 * _e1172.x) + (_e1230 * _e1172.y)) + (_e1237 * _e1172.z))) / (((_e1223 * _e364) + (_e1230 * _e367)) + _e1237));
                                        if (_e1251 > 0f) {
                                            if (_e1251 < _e137) {
                                                let _e1255 = triangles.member[(0u + _e967)].v0_;
                                                let _e1257 = triangles.member[(0u + _e967)].v1_;
                                                if (_e1255.x < _e1257.x) {
                                                    phi_1836_ = _e1255.x;
                                                } else {
                                                    phi_1836_ = _e1257.x;
                                                }
                                                let _e1264 = phi_1836_;
                                                if (_e1255.y < _e1257.y) {
                                                    phi_1845_ = _e1255.y;
                                                } else {
                                                    phi_1845_ = _e1257.y;
                                                }
                                                let _e1271 = phi_1845_;
                                                if (_e1255.z < _e1257.z) {
                                                    phi_1854_ = _e1255.z;
                                                } else {
                                                    phi_1854_ = _e1257.z;
                                                }
                                                let _e1278 = phi_1854_;
                                                let _e1280 = triangles.member[(0u + _e967)].v2_;
                                                if (_e1264 < _e1280.x) {
                                                    phi_1863_ = _e1264;
                                                } else {
                                                    phi_1863_ = _e1280.x;
                                                }
                                                let _e1285 = phi_1863_;
                                                if (_e1271 < _e1280.y) {
                                                    phi_1870_ = _e1271;
                                                } else {
                                                    phi_1870_ = _e1280.y;
                                                }
                                                let _e1290 = phi_1870_;
                                                if (_e1278 < _e1280.z) {
                                                    phi_1877_ = _e1278;
                                                } else {
                                                    phi_1877_ = _e1280.z;
                                                }
                                                let _e1295 = phi_1877_;
                                                let _e1297 = triangles.member[(0u + _e967)].v0_;
                                                let _e1299 = triangles.member[(0u + _e967)].v1_;
                                                if (_e1297.x > _e1299.x) {
                                                    phi_1890_ = _e1297.x;
                                                } else {
                                                    phi_1890_ = _e1299.x;
                                                }
                                                let _e1306 = phi_1890_;
                                                if (_e1297.y > _e1299.y) {
                                                    phi_1899_ = _e1297.y;
                                                } else {
                                                    phi_1899_ = _e1299.y;
                                                }
                                                let _e1313 = phi_1899_;
                                                if (_e1297.z > _e1299.z) {
                                                    phi_1908_ = _e1297.z;
                                                } else {
                                                    phi_1908_ = _e1299.z;
                                                }
                                                let _e1320 = phi_1908_;
                                                let _e1322 = triangles.member[(0u + _e967)].v2_;
                                                if (_e1306 > _e1322.x) {
                                                    phi_1917_ = _e1306;
                                                } else {
                                                    phi_1917_ = _e1322.x;
                                                }
                                                let _e1327 = phi_1917_;
                                                if (_e1313 > _e1322.y) {
                                                    phi_1924_ = _e1313;
                                                } else {
                                                    phi_1924_ = _e1322.y;
                                                }
                                                let _e1332 = phi_1924_;
                                                if (_e1320 > _e1322.z) {
                                                    phi_1931_ = _e1320;
                                                } else {
                                                    phi_1931_ = _e1322.z;
                                                }
                                                let _e1337 = phi_1931_;
                                                let _e1341 = ((_e1285 - _e127) * _e278);
                                                let _e1342 = ((_e1290 - _e129) * _e288);
                                                let _e1343 = ((_e1295 - _e131) * _e298);
                                                let _e1347 = ((_e1327 - _e127) * _e278);
                                                let _e1348 = ((_e1332 - _e129) * _e288);
                                                let _e1349 = ((_e1337 - _e131) * _e298);
                                                if (_e1341 < _e1347) {
                                                    phi_1948_ = _e1341;
                                                } else {
                                                    phi_1948_ = _e1347;
                                                }
                                                let _e1352 = phi_1948_;
                                                if (_e1342 < _e1348) {
                                                    phi_1953_ = _e1342;
                                                } else {
                                                    phi_1953_ = _e1348;
                                                }
                                                let _e1355 = phi_1953_;
                                                if (_e1343 < _e1349) {
                                                    phi_1958_ = _e1343;
                                                } else {
                                                    phi_1958_ = _e1349;
                                                }
                                                let _e1358 = phi_1958_;
                                                if (_e1341 > _e1347) {
                                                    phi_1966_ = _e1341;
                                                } else {
                                                    phi_1966_ = _e1347;
                                                }
                                                let _e1364 = phi_1966_;
                                                if (_e1342 > _e1348) {
                                                    phi_1971_ = _e1342;
                                                } else {
                                                    phi_1971_ = _e1348;
                                                }
                                                let _e1367 = phi_1971_;
                                                if (_e1343 > _e1349) {
                                                    phi_1976_ = _e1343;
                                                } else {
                                                    phi_1976_ = _e1349;
                                                }
                                                let _e1370 = phi_1976_;
                                                let _e1374 = core_intrinsics_maximum_number_nsz_f32_((_e1352 - _e337), (_e1355 - _e338));
                                                let _e1375 = core_intrinsics_maximum_number_nsz_f32_(_e1374, (_e1358 - _e339));
                                                let _e1376 = core_intrinsics_minimum_number_nsz_f32_((_e1364 + _e337), (_e1367 + _e338));
                                                let _e1377 = core_intrinsics_minimum_number_nsz_f32_(_e1376, (_e1370 + _e339));
                                                if (_e1375 > -300000000000000000000000000000000000000f) {
                                                    phi_1988_ = _e1375;
                                                } else {
                                                    phi_1988_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1380 = phi_1988_;
                                                if (_e1377 < 300000000000000000000000000000000000000f) {
                                                    phi_1993_ = _e1377;
                                                } else {
                                                    phi_1993_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1383 = phi_1993_;
                                                if (_e1251 < _e1380) {
                                                    phi_1998_ = _e1380;
                                                } else {
                                                    phi_1998_ = _e1251;
                                                }
                                                let _e1386 = phi_1998_;
                                                if (_e1386 > _e1383) {
                                                    phi_2003_ = _e1383;
                                                } else {
                                                    phi_2003_ = _e1386;
                                                }
                                                let _e1389 = phi_2003_;
                                                phi_2008_ = lt_bvh_triangle_Intersection(_e1389, (_e1092 / _e1151), (_e1113 / _e1151), (_e1380 <= _e1383));
                                                phi_2009_ = false;
                                            } else {
                                                phi_2008_ = lt_bvh_triangle_Intersection();
                                                phi_2009_ = true;
                                            }
                                            let _e1395 = phi_2008_;
                                            let _e1397 = phi_2009_;
                                            phi_2010_ = _e1395;
                                            phi_2011_ = _e1397;
                                        } else {
                                            phi_2010_ = lt_bvh_triangle_Intersection();
                                            phi_2011_ = true;
                                        }
                                        let _e1399 = phi_2010_;
                                        let _e1401 = phi_2011_;
                                        if _e1401 {
                                        }
                                        phi_2015_ = _e1399;
                                        phi_2016_ = _e1401;
                                    }
                                    let _e1403 = phi_2015_;
                                    let _e1405 = phi_2016_;
                                    phi_2017_ = _e1403;
                                    phi_2018_ = _e1154;
                                    phi_2019_ = _e1405;
                                } else {
                                    phi_2017_ = lt_bvh_triangle_Intersection();
                                    phi_2018_ = true;
                                    phi_2019_ = false;
                                }
                                let _e1407 = phi_2017_;
                                let _e1409 = phi_2018_;
                                let _e1411 = phi_2019_;
                                if _e1409 {
                                    phi_2023_ = true;
                                } else {
                                    phi_2023_ = _e1411;
                                }
                                let _e1413 = phi_2023_;
                                if _e1413 {
                                    phi_2027_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2027_ = _e1407;
                                }
                                let _e1415 = phi_2027_;
                                if _e1415.is_hit {
                                    if (_e1415.t > 0f) {
                                        if (_e1415.t < _e137) {
                                            let _e1422 = triangles.member[(0u + _e967)].i0_;
                                            if ((_e1422 & 2147483648u) == 0u) {
                                                phi_2246_ = true;
                                            } else {
                                                if (_e967 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1431 = triangles.member[(0u + _e967)].i0_;
                                                let _e1432 = (_e1431 & 2147483647u);
                                                let _e1434 = triangles.member[(0u + _e967)].i1_;
                                                let _e1436 = triangles.member[(0u + _e967)].i2_;
                                                if (_e1432 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1440 = vertices.member[(0u + _e1432)];
                                                if (_e1434 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1444 = vertices.member[(0u + _e1434)];
                                                if (_e1436 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1448 = vertices.member[(0u + _e1436)];
                                                let _e1449 = array<abi_Vertex, 3>(_e1440, _e1444, _e1448);
                                                if (_e1449[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1455 = materials.member[(0u + _e1449[0].material)];
                                                if ((_e1455.flags & 1u) == 1u) {
                                                    let _e1460 = ((1f - _e1415.u) - _e1415.v);
                                                    if (_e1455.cutoff <= 0f) {
                                                        phi_2244_ = true;
                                                    } else {
                                                        let _e1487 = (_e1455.base_color.w * ((((f32((_e1449[0].color >> bitcast<u32>(24i))) * _e1460) + (f32((_e1449[1].color >> bitcast<u32>(24i))) * _e1415.u)) + (f32((_e1449[2].color >> bitcast<u32>(24i))) * _e1415.v)) * (1f / 255f)));
                                                        if (_e1455.alpha_size == 0u) {
                                                            phi_2241_ = _e1487;
                                                        } else {
                                                            local.offset = _e1455.alpha_offset;
                                                            local.size = _e1455.alpha_size;
                                                            local.flags = _e1455.flags;
                                                            let _e1518 = _lt_shaders_texture_TextureView_quad((&local), (((_e1449[0].u * _e1460) + (_e1449[1].u * _e1415.u)) + (_e1449[2].u * _e1415.v)), (((_e1449[0].v * _e1460) + (_e1449[1].v * _e1415.u)) + (_e1449[2].v * _e1415.v)));
                                                            let _e1522 = (_e1518.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1522 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1526 = alpha_texels.member[(0u + _e1522)];
                                                            let _e1542 = (_e1518.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1542 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1546 = alpha_texels.member[(0u + _e1542)];
                                                            let _e1563 = (_e1518.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1563 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1567 = alpha_texels.member[(0u + _e1563)];
                                                            let _e1584 = (_e1518.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1584 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1588 = alpha_texels.member[(0u + _e1584)];
                                                            phi_2241_ = (_e1487 * (((((f32(((_e1526 >> bitcast<u32>((((_e1518.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1518.weights.x) + ((f32(((_e1546 >> bitcast<u32>((((_e1518.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1518.weights.y)) + ((f32(((_e1567 >> bitcast<u32>((((_e1518.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1518.weights.z)) + ((f32(((_e1588 >> bitcast<u32>((((_e1518.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1518.weights.w)));
                                                        }
                                                        let _e1604 = phi_2241_;
                                                        phi_2244_ = (_e1604 >= _e1455.cutoff);
                                                    }
                                                    let _e1608 = phi_2244_;
                                                    phi_2245_ = _e1608;
                                                } else {
                                                    phi_2245_ = false;
                                                }
                                                let _e1610 = phi_2245_;
                                                phi_2246_ = _e1610;
                                            }
                                            let _e1612 = phi_2246_;
                                            if _e1612 {
                                                phi_2250_ = false;
                                            } else {
                                                phi_2250_ = true;
                                            }
                                            let _e1614 = phi_2250_;
                                            phi_2251_ = _e1612;
                                            phi_2252_ = _e1612;
                                            phi_2253_ = _e1614;
                                        } else {
                                            phi_2251_ = bool();
                                            phi_2252_ = _e958;
                                            phi_2253_ = true;
                                        }
                                        let _e1616 = phi_2251_;
                                        let _e1618 = phi_2252_;
                                        let _e1620 = phi_2253_;
                                        phi_2254_ = _e1616;
                                        phi_2255_ = _e1618;
                                        phi_2256_ = _e1620;
                                    } else {
                                        phi_2254_ = bool();
                                        phi_2255_ = _e958;
                                        phi_2256_ = true;
                                    }
                                    let _e1622 = phi_2254_;
                                    let _e1624 = phi_2255_;
                                    let _e1626 = phi_2256_;
                                    phi_2257_ = _e1622;
                                    phi_2258_ = _e1624;
                                    phi_2259_ = _e1626;
                                } else {
                                    phi_2257_ = bool();
                                    phi_2258_ = _e958;
                                    phi_2259_ = true;
                                }
                                let _e1628 = phi_2257_;
                                let _e1630 = phi_2258_;
                                let _e1632 = phi_2259_;
                                if _e1632 {
                                }
                                phi_1457_ = (_e956 & (_e956 - 1u));
                                phi_1460_ = _e1630;
                                phi_2263_ = _e1628;
                                phi_2264_ = _e1632;
                            }
                            let _e1634 = phi_1457_;
                            let _e1636 = phi_1460_;
                            let _e1638 = phi_2263_;
                            let _e1640 = phi_2264_;
                            local_8 = _e1638;
                            continue;
                            continuing {
                                phi_1456_ = _e1634;
                                phi_1459_ = _e1636;
                                break if !(_e1640);
                            }
                        }
                        let _e1643 = local_5;
                        if _e1643 {
                            let _e1645 = local_1.group_mask;
                            if ((_e1645 & 4278190080u) == 0u) {
                                let _e1649 = local_1.len;
                                if (_e1649 == 0u) {
                                    phi_2306_ = false;
                                } else {
                                    let _e1653 = local_1.len;
                                    local_1.len = (_e1653 - 1u);
                                    let _e1656 = local_1.len;
                                    if (_e1656 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1661 = local_1.first[(0u + _e1656)];
                                    local_1.group = _e1661;
                                    let _e1664 = local_1.len;
                                    if (_e1664 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1669 = local_1.mask[(0u + _e1664)];
                                    local_1.group_mask = _e1669;
                                    phi_2306_ = true;
                                }
                                let _e1672 = phi_2306_;
                                phi_2307_ = _e1672;
                            } else {
                                phi_2307_ = true;
                            }
                            let _e1674 = phi_2307_;
                            if _e1674 {
                                let _e1676 = local_1.group_mask;
                                let _e1682 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1676)), 32u, (_e1676 == 0u)));
                                let _e1686 = local_1.group_mask;
                                let _e1700 = local_1.group_mask;
                                local_1.group_mask = (_e1700 & ~((1u << bitcast<u32>((_e1682 & 31u)))));
                                let _e1703 = local_1.group;
                                phi_2338_ = (_e1703 + countOneBits(((_e1686 & ~((4294967295u << bitcast<u32>((((_e1682 - 24u) ^ _e380) & 31u))))) & 255u)));
                            } else {
                                phi_2338_ = 4294967295u;
                            }
                            let _e1706 = phi_2338_;
                            phi_2339_ = _e1706;
                        } else {
                            phi_2339_ = u32();
                        }
                        let _e1708 = phi_2339_;
                        phi_1125_ = _e1708;
                        let _e1914 = local_7;
                        phi_1128_ = _e1914;
                        let _e1917 = local_8;
                        phi_2340_ = _e1917;
                        let _e1920 = local_9;
                        phi_2341_ = _e1920;
                        phi_2342_ = false;
                    } else {
                        phi_1125_ = u32();
                        phi_1128_ = bool();
                        phi_2340_ = bool();
                        phi_2341_ = false;
                        phi_2342_ = true;
                    }
                    let _e1710 = phi_1125_;
                    let _e1712 = phi_1128_;
                    let _e1714 = phi_2340_;
                    let _e1716 = phi_2341_;
                    let _e1718 = phi_2342_;
                    local_6 = _e1718;
                    local_10 = _e1714;
                    continue;
                    continuing {
                        phi_1124_ = _e1710;
                        phi_1127_ = _e1712;
                        break if !(_e1716);
                    }
                }
                let _e1721 = local_6;
                if _e1721 {
                    phi_2346_ = false;
                } else {
                    phi_2346_ = true;
                }
                let _e1723 = phi_2346_;
                if _e1723 {
                    let _e1926 = local_10;
                    phi_2350_ = _e1926;
                } else {
                    let _e1928 = local_11;
                    phi_2350_ = _e1928;
                }
                let _e1725 = phi_2350_;
                phi_2351_ = _e1725;
            }
            let _e1727 = phi_2351_;
            phi_2352_ = _e1727;
            phi_2353_ = _e202;
        } else {
            phi_2352_ = bool();
            phi_2353_ = true;
        }
        let _e1729 = phi_2352_;
        let _e1731 = phi_2353_;
        if _e1731 {
            phi_2357_ = false;
        } else {
            phi_2357_ = _e1729;
        }
        let _e1733 = phi_2357_;
        if _e1733 {
            phi_2361_ = 0f;
        } else {
            phi_2361_ = 1f;
        }
        let _e1735 = phi_2361_;
        if (_e107 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e107)] = _e1735;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
