struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_36 {
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

struct type_40 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_44 {
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

struct type_48 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_mask_LightPlace,
    unnamed_1: lt_mask_LightPlace,
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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(6) 
var<storage> vertices: type_44;
@group(0) @binding(7) 
var<storage> materials: type_48;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_193_: bool;
    var phi_197_: f32;

    if (param != param) {
        phi_193_ = true;
    } else {
        let _e69 = (param_1 >= param);
        if _e69 {
        }
        phi_193_ = _e69;
    }
    let _e71 = phi_193_;
    if _e71 {
        phi_197_ = param_1;
    } else {
        phi_197_ = param;
    }
    let _e73 = phi_197_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_209_: bool;
    var phi_213_: f32;

    if (param_2 != param_2) {
        phi_209_ = true;
    } else {
        let _e69 = (param_3 <= param_2);
        if _e69 {
        }
        phi_209_ = _e69;
    }
    let _e71 = phi_209_;
    if _e71 {
        phi_213_ = param_3;
    } else {
        phi_213_ = param_2;
    }
    let _e73 = phi_213_;
    return _e73;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_255_: f32;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_262_: f32;
    var phi_263_: bool;
    var phi_267_: f32;
    var phi_293_: f32;
    var phi_298_: f32;
    var phi_299_: bool;
    var phi_300_: f32;
    var phi_301_: bool;
    var phi_305_: f32;
    var phi_313_: f32;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_343_: u32;
    var phi_357_: u32;
    var phi_364_: u32;
    var phi_369_: u32;
    var phi_375_: u32;
    var phi_380_: u32;
    var phi_382_: texture_Axis;
    var phi_410_: f32;
    var phi_415_: f32;
    var phi_416_: bool;
    var phi_417_: f32;
    var phi_418_: bool;
    var phi_422_: f32;
    var phi_448_: f32;
    var phi_453_: f32;
    var phi_454_: bool;
    var phi_455_: f32;
    var phi_456_: bool;
    var phi_460_: f32;
    var phi_468_: f32;
    var phi_469_: f32;
    var phi_470_: f32;
    var phi_479_: f32;
    var phi_480_: f32;
    var phi_498_: u32;
    var phi_512_: u32;
    var phi_519_: u32;
    var phi_524_: u32;
    var phi_530_: u32;
    var phi_535_: u32;
    var phi_537_: texture_Axis;

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
                phi_255_ = 1f;
            } else {
                phi_255_ = 0f;
            }
            let _e100 = phi_255_;
            if (param_5 < 8388608f) {
                phi_260_ = (_e97 - _e100);
                phi_261_ = false;
            } else {
                phi_260_ = f32();
                phi_261_ = true;
            }
            let _e103 = phi_260_;
            let _e105 = phi_261_;
            phi_262_ = _e103;
            phi_263_ = _e105;
        } else {
            phi_262_ = f32();
            phi_263_ = true;
        }
        let _e107 = phi_262_;
        let _e109 = phi_263_;
        if _e109 {
            phi_267_ = param_5;
        } else {
            phi_267_ = _e107;
        }
        let _e111 = phi_267_;
        phi_315_ = (param_5 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_5 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_293_ = 1f;
                } else {
                    phi_293_ = 0f;
                }
                let _e129 = phi_293_;
                if (_e114 < 8388608f) {
                    phi_298_ = (_e126 - _e129);
                    phi_299_ = false;
                } else {
                    phi_298_ = f32();
                    phi_299_ = true;
                }
                let _e132 = phi_298_;
                let _e134 = phi_299_;
                phi_300_ = _e132;
                phi_301_ = _e134;
            } else {
                phi_300_ = f32();
                phi_301_ = true;
            }
            let _e136 = phi_300_;
            let _e138 = phi_301_;
            if _e138 {
                phi_305_ = _e114;
            } else {
                phi_305_ = _e136;
            }
            let _e140 = phi_305_;
            let _e142 = (param_5 - (2f * _e140));
            if (_e142 > 1f) {
                phi_313_ = (2f - _e142);
            } else {
                phi_313_ = _e142;
            }
            let _e146 = phi_313_;
            phi_314_ = _e146;
        } else {
            phi_314_ = param_5;
        }
        let _e148 = phi_314_;
        phi_315_ = _e148;
    }
    let _e150 = phi_315_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_324_ = _e150;
        } else {
            phi_324_ = 1f;
        }
        let _e154 = phi_324_;
        phi_325_ = _e154;
    } else {
        phi_325_ = 0f;
    }
    let _e156 = phi_325_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_343_ = _e157;
        } else {
            phi_343_ = _e166;
        }
        let _e169 = phi_343_;
        phi_382_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_357_ = _e71;
        } else {
            phi_357_ = _e178;
        }
        let _e181 = phi_357_;
        if (_e84 == 0u) {
            phi_364_ = _e157;
        } else {
            phi_364_ = 0u;
        }
        let _e186 = phi_364_;
        if (_e84 == 0u) {
            phi_369_ = 0u;
        } else {
            phi_369_ = _e157;
        }
        let _e189 = phi_369_;
        if (_e181 == 0u) {
            phi_375_ = _e186;
        } else {
            phi_375_ = (_e181 - 1u);
        }
        let _e193 = phi_375_;
        if (_e181 > _e157) {
            phi_380_ = _e189;
        } else {
            phi_380_ = _e181;
        }
        let _e196 = phi_380_;
        phi_382_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_382_;
    let _e201 = (*param_4).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_6 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e217 > param_6) {
                phi_410_ = 1f;
            } else {
                phi_410_ = 0f;
            }
            let _e220 = phi_410_;
            if (param_6 < 8388608f) {
                phi_415_ = (_e217 - _e220);
                phi_416_ = false;
            } else {
                phi_415_ = f32();
                phi_416_ = true;
            }
            let _e223 = phi_415_;
            let _e225 = phi_416_;
            phi_417_ = _e223;
            phi_418_ = _e225;
        } else {
            phi_417_ = f32();
            phi_418_ = true;
        }
        let _e227 = phi_417_;
        let _e229 = phi_418_;
        if _e229 {
            phi_422_ = param_6;
        } else {
            phi_422_ = _e227;
        }
        let _e231 = phi_422_;
        phi_470_ = (param_6 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_6 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_448_ = 1f;
                } else {
                    phi_448_ = 0f;
                }
                let _e249 = phi_448_;
                if (_e234 < 8388608f) {
                    phi_453_ = (_e246 - _e249);
                    phi_454_ = false;
                } else {
                    phi_453_ = f32();
                    phi_454_ = true;
                }
                let _e252 = phi_453_;
                let _e254 = phi_454_;
                phi_455_ = _e252;
                phi_456_ = _e254;
            } else {
                phi_455_ = f32();
                phi_456_ = true;
            }
            let _e256 = phi_455_;
            let _e258 = phi_456_;
            if _e258 {
                phi_460_ = _e234;
            } else {
                phi_460_ = _e256;
            }
            let _e260 = phi_460_;
            let _e262 = (param_6 - (2f * _e260));
            if (_e262 > 1f) {
                phi_468_ = (2f - _e262);
            } else {
                phi_468_ = _e262;
            }
            let _e266 = phi_468_;
            phi_469_ = _e266;
        } else {
            phi_469_ = param_6;
        }
        let _e268 = phi_469_;
        phi_470_ = _e268;
    }
    let _e270 = phi_470_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_479_ = _e270;
        } else {
            phi_479_ = 1f;
        }
        let _e274 = phi_479_;
        phi_480_ = _e274;
    } else {
        phi_480_ = 0f;
    }
    let _e276 = phi_480_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_498_ = _e277;
        } else {
            phi_498_ = _e286;
        }
        let _e289 = phi_498_;
        phi_537_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_512_ = _e75;
        } else {
            phi_512_ = _e298;
        }
        let _e301 = phi_512_;
        if (_e204 == 0u) {
            phi_519_ = _e277;
        } else {
            phi_519_ = 0u;
        }
        let _e306 = phi_519_;
        if (_e204 == 0u) {
            phi_524_ = 0u;
        } else {
            phi_524_ = _e277;
        }
        let _e309 = phi_524_;
        if (_e301 == 0u) {
            phi_530_ = _e306;
        } else {
            phi_530_ = (_e301 - 1u);
        }
        let _e313 = phi_530_;
        if (_e301 > _e277) {
            phi_535_ = _e309;
        } else {
            phi_535_ = _e301;
        }
        let _e316 = phi_535_;
        phi_537_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_537_;
    let _e323 = (*param_4).offset;
    let _e330 = (*param_4).offset;
    let _e337 = (*param_4).offset;
    let _e344 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_675_: f32;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_713_: bool;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_733_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_760_: bool;
    var phi_830_: f32;
    var phi_837_: f32;
    var phi_844_: f32;
    var phi_851_: f32;
    var phi_858_: f32;
    var phi_865_: f32;
    var phi_882_: f32;
    var phi_887_: f32;
    var phi_892_: f32;
    var phi_897_: f32;
    var phi_902_: f32;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_937_: u32;
    var phi_938_: u32;
    var phi_949_: vec3<f32>;
    var phi_950_: vec3<f32>;
    var phi_963_: u32;
    var phi_968_: u32;
    var phi_973_: u32;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1119_: u32;
    var phi_1121_: u32;
    var phi_1124_: bool;
    var phi_1204_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1231_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1258_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1264_: u32;
    var phi_1267_: u32;
    var phi_1281_: u32;
    var phi_1291_: u32;
    var phi_1301_: u32;
    var phi_1319_: u32;
    var phi_1329_: u32;
    var phi_1339_: u32;
    var phi_1375_: u32;
    var phi_1388_: u32;
    var phi_1393_: u32;
    var phi_1394_: u32;
    var phi_1395_: u32;
    var phi_1265_: u32;
    var phi_1268_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1453_: u32;
    var phi_1456_: bool;
    var phi_1500_: vec3<f32>;
    var phi_1501_: vec3<f32>;
    var phi_1530_: vec3<f32>;
    var phi_1531_: vec3<f32>;
    var phi_1560_: vec3<f32>;
    var phi_1561_: vec3<f32>;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1584_: f32;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1595_: f32;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1610_: f32;
    var phi_1611_: f32;
    var phi_1612_: f32;
    var phi_1613_: f32;
    var phi_1621_: f32;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1636_: f32;
    var phi_1637_: f32;
    var phi_1638_: f32;
    var phi_1639_: f32;
    var phi_1647_: f32;
    var phi_1662_: f32;
    var phi_1663_: bool;
    var phi_1664_: f32;
    var phi_1665_: bool;
    var phi_1666_: f32;
    var phi_1667_: bool;
    var phi_1685_: f32;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1688_: f32;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1694_: bool;
    var phi_1695_: f32;
    var phi_1696_: bool;
    var phi_1724_: vec3<f32>;
    var phi_1725_: vec3<f32>;
    var phi_1750_: vec3<f32>;
    var phi_1751_: vec3<f32>;
    var phi_1776_: vec3<f32>;
    var phi_1777_: vec3<f32>;
    var phi_1833_: f32;
    var phi_1842_: f32;
    var phi_1851_: f32;
    var phi_1860_: f32;
    var phi_1867_: f32;
    var phi_1874_: f32;
    var phi_1887_: f32;
    var phi_1896_: f32;
    var phi_1905_: f32;
    var phi_1914_: f32;
    var phi_1921_: f32;
    var phi_1928_: f32;
    var phi_1945_: f32;
    var phi_1950_: f32;
    var phi_1955_: f32;
    var phi_1963_: f32;
    var phi_1968_: f32;
    var phi_1973_: f32;
    var phi_1985_: f32;
    var phi_1990_: f32;
    var phi_1995_: f32;
    var phi_2000_: f32;
    var phi_2005_: lt_bvh_triangle_Intersection;
    var phi_2006_: bool;
    var phi_2007_: lt_bvh_triangle_Intersection;
    var phi_2008_: bool;
    var phi_2012_: lt_bvh_triangle_Intersection;
    var phi_2013_: bool;
    var phi_2014_: lt_bvh_triangle_Intersection;
    var phi_2015_: bool;
    var phi_2016_: bool;
    var phi_2020_: bool;
    var phi_2024_: lt_bvh_triangle_Intersection;
    var phi_2238_: f32;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_1454_: u32;
    var phi_1457_: bool;
    var phi_2260_: bool;
    var phi_2261_: bool;
    var local_5: bool;
    var phi_2303_: bool;
    var phi_2304_: bool;
    var phi_2335_: u32;
    var phi_2336_: u32;
    var phi_1122_: u32;
    var phi_1125_: bool;
    var phi_2337_: bool;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var local_6: bool;
    var phi_2343_: bool;
    var phi_2347_: bool;
    var phi_2348_: bool;
    var phi_2349_: bool;
    var phi_2350_: bool;
    var phi_2354_: bool;
    var phi_2358_: f32;
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
        let _e148 = abs(_e144);
        let _e149 = abs(_e145);
        let _e150 = abs(_e146);
        if (abs(_e126) < 1000000000000000f) {
            if (abs(_e128) < 1000000000000000f) {
                phi_706_ = (abs(_e130) < 1000000000000000f);
                phi_707_ = false;
            } else {
                phi_706_ = bool();
                phi_707_ = true;
            }
            let _e158 = phi_706_;
            let _e160 = phi_707_;
            phi_708_ = _e158;
            phi_709_ = _e160;
        } else {
            phi_708_ = bool();
            phi_709_ = true;
        }
        let _e162 = phi_708_;
        let _e164 = phi_709_;
        if _e164 {
            phi_713_ = false;
        } else {
            phi_713_ = _e162;
        }
        let _e166 = phi_713_;
        if _e166 {
            if (_e148 < 1000000000000000f) {
                if (_e149 < 1000000000000000f) {
                    phi_726_ = (_e150 < 1000000000000000f);
                    phi_727_ = false;
                } else {
                    phi_726_ = bool();
                    phi_727_ = true;
                }
                let _e171 = phi_726_;
                let _e173 = phi_727_;
                phi_728_ = _e171;
                phi_729_ = _e173;
            } else {
                phi_728_ = bool();
                phi_729_ = true;
            }
            let _e175 = phi_728_;
            let _e177 = phi_729_;
            if _e177 {
                phi_733_ = false;
            } else {
                phi_733_ = _e175;
            }
            let _e179 = phi_733_;
            if _e179 {
                if (_e148 > 0f) {
                    phi_747_ = bool();
                    phi_748_ = true;
                } else {
                    let _e181 = (_e149 > 0f);
                    if _e181 {
                        phi_746_ = bool();
                    } else {
                        phi_746_ = (_e150 > 0f);
                    }
                    let _e184 = phi_746_;
                    phi_747_ = _e184;
                    phi_748_ = _e181;
                }
                let _e186 = phi_747_;
                let _e188 = phi_748_;
                if _e188 {
                    phi_752_ = true;
                } else {
                    phi_752_ = _e186;
                }
                let _e190 = phi_752_;
                phi_753_ = _e190;
                phi_754_ = false;
            } else {
                phi_753_ = bool();
                phi_754_ = true;
            }
            let _e192 = phi_753_;
            let _e194 = phi_754_;
            phi_755_ = _e192;
            phi_756_ = _e194;
        } else {
            phi_755_ = bool();
            phi_756_ = true;
        }
        let _e196 = phi_755_;
        let _e198 = phi_756_;
        if _e198 {
            phi_760_ = false;
        } else {
            phi_760_ = _e196;
        }
        let _e200 = phi_760_;
        if _e200 {
            let _e201 = (0u >= _e75);
            if _e201 {
                phi_2348_ = bool();
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
                    phi_830_ = _e267;
                } else {
                    phi_830_ = abs(_e144);
                }
                let _e272 = phi_830_;
                if (_e144 < 0f) {
                    phi_837_ = (-1f / _e272);
                } else {
                    phi_837_ = (1f / _e272);
                }
                let _e277 = phi_837_;
                if (abs(_e145) < _e267) {
                    phi_844_ = _e267;
                } else {
                    phi_844_ = abs(_e145);
                }
                let _e282 = phi_844_;
                if (_e145 < 0f) {
                    phi_851_ = (-1f / _e282);
                } else {
                    phi_851_ = (1f / _e282);
                }
                let _e287 = phi_851_;
                if (abs(_e146) < _e267) {
                    phi_858_ = _e267;
                } else {
                    phi_858_ = abs(_e146);
                }
                let _e292 = phi_858_;
                if (_e146 < 0f) {
                    phi_865_ = (-1f / _e292);
                } else {
                    phi_865_ = (1f / _e292);
                }
                let _e297 = phi_865_;
                let _e301 = abs((bitcast<f32>(_e207) - _e126));
                let _e302 = abs((bitcast<f32>(_e211) - _e128));
                let _e303 = abs((bitcast<f32>(_e215) - _e130));
                let _e307 = abs(((bitcast<f32>(_e219) + (bitcast<f32>((((_e231 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e126));
                let _e308 = abs(((bitcast<f32>(_e223) + (bitcast<f32>((((_e231 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e128));
                let _e309 = abs(((bitcast<f32>(_e227) + (bitcast<f32>((((_e231 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                if (_e301 > _e307) {
                    phi_882_ = _e301;
                } else {
                    phi_882_ = _e307;
                }
                let _e312 = phi_882_;
                if (_e302 > _e308) {
                    phi_887_ = _e302;
                } else {
                    phi_887_ = _e308;
                }
                let _e315 = phi_887_;
                if (_e303 > _e309) {
                    phi_892_ = _e303;
                } else {
                    phi_892_ = _e309;
                }
                let _e318 = phi_892_;
                if (_e312 > _e315) {
                    phi_897_ = _e312;
                } else {
                    phi_897_ = _e315;
                }
                let _e321 = phi_897_;
                if (_e321 > _e318) {
                    phi_902_ = _e321;
                } else {
                    phi_902_ = _e318;
                }
                let _e324 = phi_902_;
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
                        phi_928_ = false;
                    } else {
                        phi_928_ = true;
                    }
                    let _e345 = phi_928_;
                    phi_929_ = _e345;
                } else {
                    phi_929_ = true;
                }
                let _e347 = phi_929_;
                if _e347 {
                    if (_e340 >= _e341) {
                        phi_937_ = 1u;
                    } else {
                        phi_937_ = 2u;
                    }
                    let _e350 = phi_937_;
                    phi_938_ = _e350;
                } else {
                    phi_938_ = 0u;
                }
                let _e352 = phi_938_;
                if (_e352 == 0u) {
                    phi_950_ = vec3<f32>(_e145, _e146, _e144);
                } else {
                    if (_e352 == 1u) {
                        phi_949_ = vec3<f32>(_e146, _e144, _e145);
                    } else {
                        phi_949_ = vec3<f32>(_e144, _e145, _e146);
                    }
                    let _e358 = phi_949_;
                    phi_950_ = _e358;
                }
                let _e360 = phi_950_;
                let _e363 = (_e360.x / _e360.z);
                let _e366 = (_e360.y / _e360.z);
                if (_e277 < 0f) {
                    phi_963_ = 0u;
                } else {
                    phi_963_ = 1u;
                }
                let _e371 = phi_963_;
                if (_e287 < 0f) {
                    phi_968_ = 0u;
                } else {
                    phi_968_ = 2u;
                }
                let _e374 = phi_968_;
                if (_e297 < 0f) {
                    phi_973_ = 0u;
                } else {
                    phi_973_ = 4u;
                }
                let _e377 = phi_973_;
                let _e379 = ((_e371 | _e374) | _e377);
                let _e380 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e380.first[0], _e380.first[1], _e380.first[2], _e380.first[3], _e380.first[4], _e380.first[5], _e380.first[6], _e380.first[7], _e380.first[8], _e380.first[9], _e380.first[10], _e380.first[11], _e380.first[12], _e380.first[13], _e380.first[14], _e380.first[15], _e380.first[16], _e380.first[17], _e380.first[18], _e380.first[19], _e380.first[20], _e380.first[21], _e380.first[22], _e380.first[23], _e380.first[24], _e380.first[25], _e380.first[26], _e380.first[27], _e380.first[28], _e380.first[29], _e380.first[30], _e380.first[31]), array<u32, 32>(_e380.mask[0], _e380.mask[1], _e380.mask[2], _e380.mask[3], _e380.mask[4], _e380.mask[5], _e380.mask[6], _e380.mask[7], _e380.mask[8], _e380.mask[9], _e380.mask[10], _e380.mask[11], _e380.mask[12], _e380.mask[13], _e380.mask[14], _e380.mask[15], _e380.mask[16], _e380.mask[17], _e380.mask[18], _e380.mask[19], _e380.mask[20], _e380.mask[21], _e380.mask[22], _e380.mask[23], _e380.mask[24], _e380.mask[25], _e380.mask[26], _e380.mask[27], _e380.mask[28], _e380.mask[29], _e380.mask[30], _e380.mask[31]), _e380.len, _e380.group, _e380.group_mask);
                let _e454 = local_1.group_mask;
                if ((_e454 & 4278190080u) == 0u) {
                    let _e458 = local_1.len;
                    if (_e458 == 0u) {
                        phi_1087_ = false;
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
                        phi_1087_ = true;
                    }
                    let _e481 = phi_1087_;
                    phi_1088_ = _e481;
                } else {
                    phi_1088_ = true;
                }
                let _e483 = phi_1088_;
                if _e483 {
                    let _e485 = local_1.group_mask;
                    let _e491 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e485)), 32u, (_e485 == 0u)));
                    let _e495 = local_1.group_mask;
                    let _e509 = local_1.group_mask;
                    local_1.group_mask = (_e509 & ~((1u << bitcast<u32>((_e491 & 31u)))));
                    let _e512 = local_1.group;
                    phi_1119_ = (_e512 + countOneBits(((_e495 & ~((4294967295u << bitcast<u32>((((_e491 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1119_ = 4294967295u;
                }
                let _e515 = phi_1119_;
                phi_1121_ = _e515;
                phi_1124_ = false;
                loop {
                    let _e517 = phi_1121_;
                    let _e519 = phi_1124_;
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
                            let _e590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e579.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e590.unnamed.word, _e579.w), _e590.unnamed_1);
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e596.unnamed, lt_mask_LightPlace(_e579.x, _e596.unnamed_1.shift));
                            phi_1204_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e602.unnamed, lt_mask_LightPlace(_e602.unnamed_1.word, _e579.y));
                        } else {
                            let _e618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e579.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e618.unnamed.word, _e579.y), _e618.unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_mask_LightPlace(_e579.z, _e624.unnamed_1.shift));
                            phi_1204_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_mask_LightPlace(_e630.unnamed_1.word, _e579.w));
                        }
                        let _e638 = phi_1204_;
                        let _e648 = nodes.member[(0u + _e517)].y;
                        if (_e287 < 0f) {
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e648.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e659.unnamed.word, _e648.w), _e659.unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_mask_LightPlace(_e648.x, _e665.unnamed_1.shift));
                            phi_1231_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_mask_LightPlace(_e671.unnamed_1.word, _e648.y));
                        } else {
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e648.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e687.unnamed.word, _e648.y), _e687.unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_mask_LightPlace(_e648.z, _e693.unnamed_1.shift));
                            phi_1231_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_mask_LightPlace(_e699.unnamed_1.word, _e648.w));
                        }
                        let _e707 = phi_1231_;
                        let _e717 = nodes.member[(0u + _e517)].z;
                        if (_e297 < 0f) {
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e717.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e728.unnamed.word, _e717.w), _e728.unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_mask_LightPlace(_e717.x, _e734.unnamed_1.shift));
                            phi_1258_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_mask_LightPlace(_e740.unnamed_1.word, _e717.y));
                        } else {
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e717.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e756.unnamed.word, _e717.y), _e756.unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_mask_LightPlace(_e717.z, _e762.unnamed_1.shift));
                            phi_1258_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_mask_LightPlace(_e768.unnamed_1.word, _e717.w));
                        }
                        let _e776 = phi_1258_;
                        phi_1264_ = 0u;
                        phi_1267_ = 0u;
                        loop {
                            let _e786 = phi_1264_;
                            let _e788 = phi_1267_;
                            local_2 = _e788;
                            local_3 = _e788;
                            local_4 = _e788;
                            let _e789 = (_e786 < 8u);
                            if _e789 {
                                let _e791 = (_e786 >> bitcast<u32>(2i));
                                let _e792 = (_e786 & 3u);
                                if (_e791 == 0u) {
                                    phi_1281_ = _e638.unnamed.word;
                                } else {
                                    phi_1281_ = _e638.unnamed.shift;
                                }
                                let _e795 = phi_1281_;
                                if (_e791 == 0u) {
                                    phi_1291_ = _e707.unnamed.word;
                                } else {
                                    phi_1291_ = _e707.unnamed.shift;
                                }
                                let _e804 = phi_1291_;
                                if (_e791 == 0u) {
                                    phi_1301_ = _e776.unnamed.word;
                                } else {
                                    phi_1301_ = _e776.unnamed.shift;
                                }
                                let _e813 = phi_1301_;
                                let _e826 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e795 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e551) + (_e569 - _e329)), ((f32(((_e804 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e552) + (_e570 - _e330)));
                                let _e827 = core_intrinsics_maximum_number_nsz_f32_(_e826, ((f32(((_e813 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e553) + (_e571 - _e331)));
                                if (_e791 == 0u) {
                                    phi_1319_ = _e638.unnamed_1.word;
                                } else {
                                    phi_1319_ = _e638.unnamed_1.shift;
                                }
                                let _e830 = phi_1319_;
                                if (_e791 == 0u) {
                                    phi_1329_ = _e707.unnamed_1.word;
                                } else {
                                    phi_1329_ = _e707.unnamed_1.shift;
                                }
                                let _e839 = phi_1329_;
                                if (_e791 == 0u) {
                                    phi_1339_ = _e776.unnamed_1.word;
                                } else {
                                    phi_1339_ = _e776.unnamed_1.shift;
                                }
                                let _e848 = phi_1339_;
                                let _e861 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e830 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e551) + (_e569 + _e329)), ((f32(((_e839 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e552) + (_e570 + _e330)));
                                let _e862 = core_intrinsics_minimum_number_nsz_f32_(_e861, ((f32(((_e848 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u)) * _e553) + (_e571 + _e331)));
                                if (_e827 <= _e862) {
                                    if (_e827 <= _e136) {
                                        if (_e862 >= 0f) {
                                            if (_e791 == 0u) {
                                                let _e869 = nodes.member[(0u + _e517)].links[2u];
                                                phi_1375_ = _e869;
                                            } else {
                                                let _e872 = nodes.member[(0u + _e517)].links[3u];
                                                phi_1375_ = _e872;
                                            }
                                            let _e874 = phi_1375_;
                                            let _e879 = ((_e874 >> bitcast<u32>(((_e792 * 8u) & 31u))) & 255u);
                                            let _e880 = (_e879 & 31u);
                                            if (_e880 >= 24u) {
                                                phi_1388_ = (24u + ((_e880 - 24u) ^ _e379));
                                            } else {
                                                phi_1388_ = _e880;
                                            }
                                            let _e886 = phi_1388_;
                                            phi_1393_ = (_e788 | ((_e879 >> bitcast<u32>(5i)) << bitcast<u32>((_e886 & 31u))));
                                        } else {
                                            phi_1393_ = _e788;
                                        }
                                        let _e894 = phi_1393_;
                                        phi_1394_ = _e894;
                                    } else {
                                        phi_1394_ = _e788;
                                    }
                                    let _e896 = phi_1394_;
                                    phi_1395_ = _e896;
                                } else {
                                    phi_1395_ = _e788;
                                }
                                let _e898 = phi_1395_;
                                phi_1265_ = (_e786 + 1u);
                                phi_1268_ = _e898;
                            } else {
                                phi_1265_ = u32();
                                phi_1268_ = u32();
                            }
                            let _e901 = phi_1265_;
                            let _e903 = phi_1268_;
                            continue;
                            continuing {
                                phi_1264_ = _e901;
                                phi_1267_ = _e903;
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
                        phi_1453_ = (_e952 & 16777215u);
                        phi_1456_ = _e519;
                        loop {
                            let _e955 = phi_1453_;
                            let _e957 = phi_1456_;
                            local_7 = _e957;
                            let _e958 = (_e955 == 0u);
                            local_5 = _e958;
                            local_9 = _e958;
                            if _e958 {
                                phi_1454_ = u32();
                                phi_1457_ = bool();
                                phi_2260_ = bool();
                                phi_2261_ = false;
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
                                    phi_1501_ = vec3<f32>(_e977, _e979, _e975);
                                } else {
                                    if (_e352 == 1u) {
                                        phi_1500_ = vec3<f32>(_e979, _e975, _e977);
                                    } else {
                                        phi_1500_ = (_e973 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e987 = phi_1500_;
                                    phi_1501_ = _e987;
                                }
                                let _e989 = phi_1501_;
                                let _e993 = (_e989.x - (_e363 * _e989.z));
                                let _e997 = (_e989.y - (_e366 * _e989.z));
                                let _e999 = triangles.member[(0u + _e966)].v1_;
                                let _e1001 = (_e999.x - _e126);
                                let _e1003 = (_e999.y - _e128);
                                let _e1005 = (_e999.z - _e130);
                                if (_e352 == 0u) {
                                    phi_1531_ = vec3<f32>(_e1003, _e1005, _e1001);
                                } else {
                                    if (_e352 == 1u) {
                                        phi_1530_ = vec3<f32>(_e1005, _e1001, _e1003);
                                    } else {
                                        phi_1530_ = (_e999 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1013 = phi_1530_;
                                    phi_1531_ = _e1013;
                                }
                                let _e1015 = phi_1531_;
                                let _e1019 = (_e1015.x - (_e363 * _e1015.z));
                                let _e1023 = (_e1015.y - (_e366 * _e1015.z));
                                let _e1025 = triangles.member[(0u + _e966)].v2_;
                                let _e1027 = (_e1025.x - _e126);
                                let _e1029 = (_e1025.y - _e128);
                                let _e1031 = (_e1025.z - _e130);
                                if (_e352 == 0u) {
                                    phi_1561_ = vec3<f32>(_e1029, _e1031, _e1027);
                                } else {
                                    if (_e352 == 1u) {
                                        phi_1560_ = vec3<f32>(_e1031, _e1027, _e1029);
                                    } else {
                                        phi_1560_ = (_e1025 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1039 = phi_1560_;
                                    phi_1561_ = _e1039;
                                }
                                let _e1041 = phi_1561_;
                                let _e1045 = (_e1041.x - (_e363 * _e1041.z));
                                let _e1049 = (_e1041.y - (_e366 * _e1041.z));
                                if (_e1019 < _e1045) {
                                    phi_1580_ = true;
                                } else {
                                    if (_e1019 == _e1045) {
                                        phi_1579_ = (_e1023 < _e1049);
                                    } else {
                                        phi_1579_ = false;
                                    }
                                    let _e1054 = phi_1579_;
                                    phi_1580_ = _e1054;
                                }
                                let _e1056 = phi_1580_;
                                if _e1056 {
                                    phi_1584_ = _e1049;
                                    phi_1585_ = _e1045;
                                    phi_1586_ = _e1023;
                                    phi_1587_ = _e1019;
                                } else {
                                    phi_1584_ = _e1023;
                                    phi_1585_ = _e1019;
                                    phi_1586_ = _e1049;
                                    phi_1587_ = _e1045;
                                }
                                let _e1058 = phi_1584_;
                                let _e1060 = phi_1585_;
                                let _e1062 = phi_1586_;
                                let _e1064 = phi_1587_;
                                let _e1067 = ((_e1064 * _e1058) - (_e1062 * _e1060));
                                if _e1056 {
                                    phi_1595_ = -(_e1067);
                                } else {
                                    phi_1595_ = _e1067;
                                }
                                let _e1070 = phi_1595_;
                                if (_e1045 < _e993) {
                                    phi_1606_ = true;
                                } else {
                                    if (_e1045 == _e993) {
                                        phi_1605_ = (_e1049 < _e997);
                                    } else {
                                        phi_1605_ = false;
                                    }
                                    let _e1075 = phi_1605_;
                                    phi_1606_ = _e1075;
                                }
                                let _e1077 = phi_1606_;
                                if _e1077 {
                                    phi_1610_ = _e997;
                                    phi_1611_ = _e993;
                                    phi_1612_ = _e1049;
                                    phi_1613_ = _e1045;
                                } else {
                                    phi_1610_ = _e1049;
                                    phi_1611_ = _e1045;
                                    phi_1612_ = _e997;
                                    phi_1613_ = _e993;
                                }
                                let _e1079 = phi_1610_;
                                let _e1081 = phi_1611_;
                                let _e1083 = phi_1612_;
                                let _e1085 = phi_1613_;
                                let _e1088 = ((_e1085 * _e1079) - (_e1083 * _e1081));
                                if _e1077 {
                                    phi_1621_ = -(_e1088);
                                } else {
                                    phi_1621_ = _e1088;
                                }
                                let _e1091 = phi_1621_;
                                if (_e993 < _e1019) {
                                    phi_1632_ = true;
                                } else {
                                    if (_e993 == _e1019) {
                                        phi_1631_ = (_e997 < _e1023);
                                    } else {
                                        phi_1631_ = false;
                                    }
                                    let _e1096 = phi_1631_;
                                    phi_1632_ = _e1096;
                                }
                                let _e1098 = phi_1632_;
                                if _e1098 {
                                    phi_1636_ = _e1023;
                                    phi_1637_ = _e1019;
                                    phi_1638_ = _e997;
                                    phi_1639_ = _e993;
                                } else {
                                    phi_1636_ = _e997;
                                    phi_1637_ = _e993;
                                    phi_1638_ = _e1023;
                                    phi_1639_ = _e1019;
                                }
                                let _e1100 = phi_1636_;
                                let _e1102 = phi_1637_;
                                let _e1104 = phi_1638_;
                                let _e1106 = phi_1639_;
                                let _e1109 = ((_e1106 * _e1100) - (_e1104 * _e1102));
                                if _e1098 {
                                    phi_1647_ = -(_e1109);
                                } else {
                                    phi_1647_ = _e1109;
                                }
                                let _e1112 = phi_1647_;
                                if (_e1070 >= 0f) {
                                    if (_e1091 >= 0f) {
                                        if (_e1112 >= 0f) {
                                            phi_1662_ = ((_e1070 + _e1091) + _e1112);
                                            phi_1663_ = false;
                                        } else {
                                            phi_1662_ = f32();
                                            phi_1663_ = true;
                                        }
                                        let _e1119 = phi_1662_;
                                        let _e1121 = phi_1663_;
                                        phi_1664_ = _e1119;
                                        phi_1665_ = _e1121;
                                    } else {
                                        phi_1664_ = f32();
                                        phi_1665_ = true;
                                    }
                                    let _e1123 = phi_1664_;
                                    let _e1125 = phi_1665_;
                                    phi_1666_ = _e1123;
                                    phi_1667_ = _e1125;
                                } else {
                                    phi_1666_ = f32();
                                    phi_1667_ = true;
                                }
                                let _e1127 = phi_1666_;
                                let _e1129 = phi_1667_;
                                if _e1129 {
                                    if (_e1070 <= 0f) {
                                        if (_e1091 <= 0f) {
                                            let _e1132 = (_e1112 <= 0f);
                                            if _e1132 {
                                            }
                                            phi_1685_ = ((_e1070 + _e1091) + _e1112);
                                            phi_1686_ = false;
                                            phi_1687_ = _e1132;
                                        } else {
                                            phi_1685_ = f32();
                                            phi_1686_ = true;
                                            phi_1687_ = false;
                                        }
                                        let _e1136 = phi_1685_;
                                        let _e1138 = phi_1686_;
                                        let _e1140 = phi_1687_;
                                        phi_1688_ = _e1136;
                                        phi_1689_ = _e1138;
                                        phi_1690_ = _e1140;
                                    } else {
                                        phi_1688_ = f32();
                                        phi_1689_ = true;
                                        phi_1690_ = false;
                                    }
                                    let _e1142 = phi_1688_;
                                    let _e1144 = phi_1689_;
                                    let _e1146 = phi_1690_;
                                    if _e1144 {
                                        phi_1694_ = false;
                                    } else {
                                        phi_1694_ = _e1146;
                                    }
                                    let _e1148 = phi_1694_;
                                    phi_1695_ = _e1142;
                                    phi_1696_ = _e1148;
                                } else {
                                    phi_1695_ = _e1127;
                                    phi_1696_ = true;
                                }
                                let _e1150 = phi_1695_;
                                let _e1152 = phi_1696_;
                                if _e1152 {
                                    let _e1153 = (_e1150 == 0f);
                                    if _e1153 {
                                        phi_2012_ = lt_bvh_triangle_Intersection();
                                        phi_2013_ = false;
                                    } else {
                                        let _e1155 = triangles.member[(0u + _e966)].v0_;
                                        let _e1157 = (_e1155.x - _e126);
                                        let _e1159 = (_e1155.y - _e128);
                                        let _e1161 = (_e1155.z - _e130);
                                        if (_e352 == 0u) {
                                            phi_1725_ = vec3<f32>(_e1159, _e1161, _e1157);
                                        } else {
                                            if (_e352 == 1u) {
                                                phi_1724_ = vec3<f32>(_e1161, _e1157, _e1159);
                                            } else {
                                                phi_1724_ = (_e1155 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e1169 = phi_1724_;
                                            phi_1725_ = _e1169;
                                        }
                                        let _e1171 = phi_1725_;
                                        let _e1173 = triangles.member[(0u + _e966)].v1_;
                                        let _e1175 = triangles.member[(0u + _e966)].v0_;
                                        let _e1178 = (_e1173.x - _e1175.x);
                                        let _e1181 = (_e1173.y - _e1175.y);
                                        let _e1184 = (_e1173.z - _e1175.z);
                                        if (_e352 == 0u) {
                                            phi_1751_ = vec3<f32>(_e1181, _e1184, _e1178);
                                        } else {
                                            if (_e352 == 1u) {
                                                phi_1750_ = vec3<f32>(_e1184, _e1178, _e1181);
                                            } else {
                                                phi_1750_ = (_e1173 - _e1175);
                                            }
                                            let _e1191 = phi_1750_;
                                            phi_1751_ = _e1191;
                                        }
                                        let _e1193 = phi_1751_;
                                        let _e1195 = triangles.member[(0u + _e966)].v2_;
                                        let _e1197 = triangles.member[(0u + _e966)].v0_;
                                        let _e1200 = (_e1195.x - _e1197.x);
                                        let _e1203 = (_e1195.y - _e1197.y);
                                        let _e1206 = (_e1195.z - _e1197.z);
                                        if (_e352 == 0u) {
                                            phi_1777_ = vec3<f32>(_e1203, _e1206, _e1200);
                                        } else {
                                            if (_e352 == 1u) {
                                                phi_1776_ = vec3<f32>(_e1206, _e1200, _e1203);
                                            } else {
                                                phi_1776_ = (_e1195 - _e1197);
                                            }
                                            let _e1213 = phi_1776_;
                                            phi_1777_ = _e1213;
                                        }
                                        let _e1215 = phi_1777_;
                                        let _e1222 = ((_e1193.y * _e1215.z) - (_e1193.z * _e1215.y));
                                        let _e1229 = ((_e1193.z * _e1215.x) - (_e1193.x * _e1215.z));
                                        let _e1236 = ((_e1193.x * _e1215.y) - (_e1193.y * _e1215.x));
                                        let _e1250 = (((1f / _e360.z) * (((_e1222 * _e1171.x) + (_e1229 * _e1171.y)) + (_e1236 * _e1171.z))) / (((_e1222 * _e363) + (_e1229 * _e366)) + _e1236));
                                        if (_e1250 > 0f) {
                                            if (_e1250 < _e136) {
                                                let _e1254 = triangles.member[(0u + _e966)].v0_;
                                                let _e1256 = triangles.member[(0u + _e966)].v1_;
                                                if (_e1254.x < _e1256.x) {
                                                    phi_1833_ = _e1254.x;
                                                } else {
                                                    phi_1833_ = _e1256.x;
                                                }
                                                let _e1263 = phi_1833_;
                                                if (_e1254.y < _e1256.y) {
                                                    phi_1842_ = _e1254.y;
                                                } else {
                                                    phi_1842_ = _e1256.y;
                                                }
                                                let _e1270 = phi_1842_;
                                                if (_e1254.z < _e1256.z) {
                                                    phi_1851_ = _e1254.z;
                                                } else {
                                                    phi_1851_ = _e1256.z;
                                                }
                                                let _e1277 = phi_1851_;
                                                let _e1279 = triangles.member[(0u + _e966)].v2_;
                                                if (_e1263 < _e1279.x) {
                                                    phi_1860_ = _e1263;
                                                } else {
                                                    phi_1860_ = _e1279.x;
                                                }
                                                let _e1284 = phi_1860_;
                                                if (_e1270 < _e1279.y) {
                                                    phi_1867_ = _e1270;
                                                } else {
                                                    phi_1867_ = _e1279.y;
                                                }
                                                let _e1289 = phi_1867_;
                                                if (_e1277 < _e1279.z) {
                                                    phi_1874_ = _e1277;
                                                } else {
                                                    phi_1874_ = _e1279.z;
                                                }
                                                let _e1294 = phi_1874_;
                                                let _e1296 = triangles.member[(0u + _e966)].v0_;
                                                let _e1298 = triangles.member[(0u + _e966)].v1_;
                                                if (_e1296.x > _e1298.x) {
                                                    phi_1887_ = _e1296.x;
                                                } else {
                                                    phi_1887_ = _e1298.x;
                                                }
                                                let _e1305 = phi_1887_;
                                                if (_e1296.y > _e1298.y) {
                                                    phi_1896_ = _e1296.y;
                                                } else {
                                                    phi_1896_ = _e1298.y;
                                                }
                                                let _e1312 = phi_1896_;
                                                if (_e1296.z > _e1298.z) {
                                                    phi_1905_ = _e1296.z;
                                                } else {
                                                    phi_1905_ = _e1298.z;
                                                }
                                                let _e1319 = phi_1905_;
                                                let _e1321 = triangles.member[(0u + _e966)].v2_;
                                                if (_e1305 > _e1321.x) {
                                                    phi_1914_ = _e1305;
                                                } else {
                                                    phi_1914_ = _e1321.x;
                                                }
                                                let _e1326 = phi_1914_;
                                                if (_e1312 > _e1321.y) {
                                                    phi_1921_ = _e1312;
                                                } else {
                                                    phi_1921_ = _e1321.y;
                                                }
                                                let _e1331 = phi_1921_;
                                                if (_e1319 > _e1321.z) {
                                                    phi_1928_ = _e1319;
                                                } else {
                                                    phi_1928_ = _e1321.z;
                                                }
                                                let _e1336 = phi_1928_;
                                                let _e1340 = ((_e1284 - _e126) * _e277);
                                                let _e1341 = ((_e1289 - _e128) * _e287);
                                                let _e1342 = ((_e1294 - _e130) * _e297);
                                                let _e1346 = ((_e1326 - _e126) * _e277);
                                                let _e1347 = ((_e1331 - _e128) * _e287);
                                                let _e1348 = ((_e1336 - _e130) * _e297);
                                                if (_e1340 < _e1346) {
                                                    phi_1945_ = _e1340;
                                                } else {
                                                    phi_1945_ = _e1346;
                                                }
                                                let _e1351 = phi_1945_;
                                                if (_e1341 < _e1347) {
                                                    phi_1950_ = _e1341;
                                                } else {
                                                    phi_1950_ = _e1347;
                                                }
                                                let _e1354 = phi_1950_;
                                                if (_e1342 < _e1348) {
                                                    phi_1955_ = _e1342;
                                                } else {
                                                    phi_1955_ = _e1348;
                                                }
                                                let _e1357 = phi_1955_;
                                                if (_e1340 > _e1346) {
                                                    phi_1963_ = _e1340;
                                                } else {
                                                    phi_1963_ = _e1346;
                                                }
                                                let _e1363 = phi_1963_;
                                                if (_e1341 > _e1347) {
                                                    phi_1968_ = _e1341;
                                                } else {
                                                    phi_1968_ = _e1347;
                                                }
                                                let _e1366 = phi_1968_;
                                                if (_e1342 > _e1348) {
                                                    phi_1973_ = _e1342;
                                                } else {
                                                    phi_1973_ = _e1348;
                                                }
                                                let _e1369 = phi_1973_;
                                                let _e1373 = core_intrinsics_maximum_number_nsz_f32_((_e1351 - _e336), (_e1354 - _e337));
                                                let _e1374 = core_intrinsics_maximum_number_nsz_f32_(_e1373, (_e1357 - _e338));
                                                let _e1375 = core_intrinsics_minimum_number_nsz_f32_((_e1363 + _e336), (_e1366 + _e337));
                                                let _e1376 = core_intrinsics_minimum_number_nsz_f32_(_e1375, (_e1369 + _e338));
                                                if (_e1374 > -300000000000000000000000000000000000000f) {
                                                    phi_1985_ = _e1374;
                                                } else {
                                                    phi_1985_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1379 = phi_1985_;
                                                if (_e1376 < 300000000000000000000000000000000000000f) {
                                                    phi_1990_ = _e1376;
                                                } else {
                                                    phi_1990_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1382 = phi_1990_;
                                                if (_e1250 < _e1379) {
                                                    phi_1995_ = _e1379;
                                                } else {
                                                    phi_1995_ = _e1250;
                                                }
                                                let _e1385 = phi_1995_;
                                                if (_e1385 > _e1382) {
                                                    phi_2000_ = _e1382;
                                                } else {
                                                    phi_2000_ = _e1385;
                                                }
                                                let _e1388 = phi_2000_;
                                                phi_2005_ = lt_bvh_triangle_Intersection(_e1388, (_e1091 / _e1150), (_e1112 / _e1150), (_e1379 <= _e1382));
                                                phi_2006_ = false;
                                            } else {
                                                phi_2005_ = lt_bvh_triangle_Intersection();
                                                phi_2006_ = true;
                                            }
                                            let _e1394 = phi_2005_;
                                            let _e1396 = phi_2006_;
                                            phi_2007_ = _e1394;
                                            phi_2008_ = _e1396;
                                        } else {
                                            phi_2007_ = lt_bvh_triangle_Intersection();
                                            phi_2008_ = true;
                                        }
                                        let _e1398 = phi_2007_;
                                        let _e1400 = phi_2008_;
                                        if _e1400 {
                                        }
                                        phi_2012_ = _e1398;
                                        phi_2013_ = _e1400;
                                    }
                                    let _e1402 = phi_2012_;
                                    let _e1404 = phi_2013_;
                                    phi_2014_ = _e1402;
                                    phi_2015_ = _e1153;
                                    phi_2016_ = _e1404;
                                } else {
                                    phi_2014_ = lt_bvh_triangle_Intersection();
                                    phi_2015_ = true;
                                    phi_2016_ = false;
                                }
                                let _e1406 = phi_2014_;
                                let _e1408 = phi_2015_;
                                let _e1410 = phi_2016_;
                                if _e1408 {
                                    phi_2020_ = true;
                                } else {
                                    phi_2020_ = _e1410;
                                }
                                let _e1412 = phi_2020_;
                                if _e1412 {
                                    phi_2024_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2024_ = _e1406;
                                }
                                let _e1414 = phi_2024_;
                                if _e1414.is_hit {
                                    if (_e1414.t > 0f) {
                                        if (_e1414.t < _e136) {
                                            let _e1421 = triangles.member[(0u + _e966)].i0_;
                                            if ((_e1421 & 2147483648u) == 0u) {
                                                phi_2243_ = true;
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
                                                        phi_2241_ = true;
                                                    } else {
                                                        let _e1486 = (_e1454.base_color.w * ((((f32((_e1448[0].color >> bitcast<u32>(24i))) * _e1459) + (f32((_e1448[1].color >> bitcast<u32>(24i))) * _e1414.u)) + (f32((_e1448[2].color >> bitcast<u32>(24i))) * _e1414.v)) * (1f / 255f)));
                                                        if (_e1454.alpha_size == 0u) {
                                                            phi_2238_ = _e1486;
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
                                                            phi_2238_ = (_e1486 * (((((f32(((_e1525 >> bitcast<u32>((((_e1517.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.x) + ((f32(((_e1545 >> bitcast<u32>((((_e1517.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.y)) + ((f32(((_e1566 >> bitcast<u32>((((_e1517.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.z)) + ((f32(((_e1587 >> bitcast<u32>((((_e1517.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1517.weights.w)));
                                                        }
                                                        let _e1603 = phi_2238_;
                                                        phi_2241_ = (_e1603 >= _e1454.cutoff);
                                                    }
                                                    let _e1607 = phi_2241_;
                                                    phi_2242_ = _e1607;
                                                } else {
                                                    phi_2242_ = false;
                                                }
                                                let _e1609 = phi_2242_;
                                                phi_2243_ = _e1609;
                                            }
                                            let _e1611 = phi_2243_;
                                            if _e1611 {
                                                phi_2247_ = false;
                                            } else {
                                                phi_2247_ = true;
                                            }
                                            let _e1613 = phi_2247_;
                                            phi_2248_ = _e1611;
                                            phi_2249_ = _e1611;
                                            phi_2250_ = _e1613;
                                        } else {
                                            phi_2248_ = bool();
                                            phi_2249_ = _e957;
                                            phi_2250_ = true;
                                        }
                                        let _e1615 = phi_2248_;
                                        let _e1617 = phi_2249_;
                                        let _e1619 = phi_2250_;
                                        phi_2251_ = _e1615;
                                        phi_2252_ = _e1617;
                                        phi_2253_ = _e1619;
                                    } else {
                                        phi_2251_ = bool();
                                        phi_2252_ = _e957;
                                        phi_2253_ = true;
                                    }
                                    let _e1621 = phi_2251_;
                                    let _e1623 = phi_2252_;
                                    let _e1625 = phi_2253_;
                                    phi_2254_ = _e1621;
                                    phi_2255_ = _e1623;
                                    phi_2256_ = _e1625;
                                } else {
                                    phi_2254_ = bool();
                                    phi_2255_ = _e957;
                                    phi_2256_ = true;
                                }
                                let _e1627 = phi_2254_;
                                let _e1629 = phi_2255_;
                                let _e1631 = phi_2256_;
                                if _e1631 {
                                }
                                phi_1454_ = (_e955 & (_e955 - 1u));
                                phi_1457_ = _e1629;
                                phi_2260_ = _e1627;
                                phi_2261_ = _e1631;
                            }
                            let _e1633 = phi_1454_;
                            let _e1635 = phi_1457_;
                            let _e1637 = phi_2260_;
                            let _e1639 = phi_2261_;
                            local_8 = _e1637;
                            continue;
                            continuing {
                                phi_1453_ = _e1633;
                                phi_1456_ = _e1635;
                                break if !(_e1639);
                            }
                        }
                        let _e1642 = local_5;
                        if _e1642 {
                            let _e1644 = local_1.group_mask;
                            if ((_e1644 & 4278190080u) == 0u) {
                                let _e1648 = local_1.len;
                                if (_e1648 == 0u) {
                                    phi_2303_ = false;
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
                                    phi_2303_ = true;
                                }
                                let _e1671 = phi_2303_;
                                phi_2304_ = _e1671;
                            } else {
                                phi_2304_ = true;
                            }
                            let _e1673 = phi_2304_;
                            if _e1673 {
                                let _e1675 = local_1.group_mask;
                                let _e1681 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1675)), 32u, (_e1675 == 0u)));
                                let _e1685 = local_1.group_mask;
                                let _e1699 = local_1.group_mask;
                                local_1.group_mask = (_e1699 & ~((1u << bitcast<u32>((_e1681 & 31u)))));
                                let _e1702 = local_1.group;
                                phi_2335_ = (_e1702 + countOneBits(((_e1685 & ~((4294967295u << bitcast<u32>((((_e1681 - 24u) ^ _e379) & 31u))))) & 255u)));
                            } else {
                                phi_2335_ = 4294967295u;
                            }
                            let _e1705 = phi_2335_;
                            phi_2336_ = _e1705;
                        } else {
                            phi_2336_ = u32();
                        }
                        let _e1707 = phi_2336_;
                        phi_1122_ = _e1707;
                        let _e1913 = local_7;
                        phi_1125_ = _e1913;
                        let _e1916 = local_8;
                        phi_2337_ = _e1916;
                        let _e1919 = local_9;
                        phi_2338_ = _e1919;
                        phi_2339_ = false;
                    } else {
                        phi_1122_ = u32();
                        phi_1125_ = bool();
                        phi_2337_ = bool();
                        phi_2338_ = false;
                        phi_2339_ = true;
                    }
                    let _e1709 = phi_1122_;
                    let _e1711 = phi_1125_;
                    let _e1713 = phi_2337_;
                    let _e1715 = phi_2338_;
                    let _e1717 = phi_2339_;
                    local_6 = _e1717;
                    local_10 = _e1713;
                    continue;
                    continuing {
                        phi_1121_ = _e1709;
                        phi_1124_ = _e1711;
                        break if !(_e1715);
                    }
                }
                let _e1720 = local_6;
                if _e1720 {
                    phi_2343_ = false;
                } else {
                    phi_2343_ = true;
                }
                let _e1722 = phi_2343_;
                if _e1722 {
                    let _e1925 = local_10;
                    phi_2347_ = _e1925;
                } else {
                    let _e1927 = local_11;
                    phi_2347_ = _e1927;
                }
                let _e1724 = phi_2347_;
                phi_2348_ = _e1724;
            }
            let _e1726 = phi_2348_;
            phi_2349_ = _e1726;
            phi_2350_ = _e201;
        } else {
            phi_2349_ = bool();
            phi_2350_ = true;
        }
        let _e1728 = phi_2349_;
        let _e1730 = phi_2350_;
        if _e1730 {
            phi_2354_ = false;
        } else {
            phi_2354_ = _e1728;
        }
        let _e1732 = phi_2354_;
        if _e1732 {
            phi_2358_ = 0f;
        } else {
            phi_2358_ = 1f;
        }
        let _e1734 = phi_2358_;
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
