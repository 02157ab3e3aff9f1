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
    var phi_1117_: bool;
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
    var phi_1449_: bool;
    var phi_1493_: vec3<f32>;
    var phi_1494_: vec3<f32>;
    var phi_1523_: vec3<f32>;
    var phi_1524_: vec3<f32>;
    var phi_1553_: vec3<f32>;
    var phi_1554_: vec3<f32>;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1580_: f32;
    var phi_1588_: f32;
    var phi_1598_: bool;
    var phi_1599_: bool;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1614_: f32;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1629_: f32;
    var phi_1630_: f32;
    var phi_1631_: f32;
    var phi_1632_: f32;
    var phi_1640_: f32;
    var phi_1655_: f32;
    var phi_1656_: bool;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1659_: f32;
    var phi_1660_: bool;
    var phi_1678_: f32;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: f32;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: bool;
    var phi_1688_: f32;
    var phi_1689_: bool;
    var phi_1717_: vec3<f32>;
    var phi_1718_: vec3<f32>;
    var phi_1743_: vec3<f32>;
    var phi_1744_: vec3<f32>;
    var phi_1769_: vec3<f32>;
    var phi_1770_: vec3<f32>;
    var phi_1826_: f32;
    var phi_1835_: f32;
    var phi_1844_: f32;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1867_: f32;
    var phi_1880_: f32;
    var phi_1889_: f32;
    var phi_1898_: f32;
    var phi_1907_: f32;
    var phi_1914_: f32;
    var phi_1921_: f32;
    var phi_1938_: f32;
    var phi_1943_: f32;
    var phi_1948_: f32;
    var phi_1956_: f32;
    var phi_1961_: f32;
    var phi_1966_: f32;
    var phi_1978_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_1998_: lt_bvh_triangle_Intersection;
    var phi_1999_: bool;
    var phi_2000_: lt_bvh_triangle_Intersection;
    var phi_2001_: bool;
    var phi_2005_: lt_bvh_triangle_Intersection;
    var phi_2006_: bool;
    var phi_2007_: lt_bvh_triangle_Intersection;
    var phi_2008_: bool;
    var phi_2009_: bool;
    var phi_2013_: bool;
    var phi_2017_: lt_bvh_triangle_Intersection;
    var phi_2231_: f32;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_1447_: u32;
    var phi_1450_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var local_5: bool;
    var phi_2296_: bool;
    var phi_2297_: bool;
    var phi_2328_: u32;
    var phi_2329_: u32;
    var phi_1115_: u32;
    var phi_1118_: bool;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2332_: bool;
    var local_6: bool;
    var phi_2336_: bool;
    var phi_2340_: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var phi_2343_: bool;
    var phi_2347_: bool;
    var phi_2351_: f32;
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
                phi_2341_ = bool();
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
                phi_1117_ = false;
                loop {
                    let _e521 = phi_1114_;
                    let _e523 = phi_1117_;
                    local_11 = _e523;
                    if (_e521 != 4294967295u) {
                        if (_e521 < _e75) {
                        } else {
                            return;
                        }
                        let _e530 = nodes.member[(0u + _e521)].frame[3u];
                        let _e555 = (bitcast<f32>((((_e530 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e285);
                        let _e556 = (bitcast<f32>((((_e530 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e295);
                        let _e557 = (bitcast<f32>((((_e530 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e305);
                        let _e560 = nodes.member[(0u + _e521)].frame[0u];
                        let _e564 = nodes.member[(0u + _e521)].frame[1u];
                        let _e568 = nodes.member[(0u + _e521)].frame[2u];
                        let _e573 = ((bitcast<f32>(_e560) - _e126) * _e285);
                        let _e574 = ((bitcast<f32>(_e564) - _e128) * _e295);
                        let _e575 = ((bitcast<f32>(_e568) - _e130) * _e305);
                        let _e583 = nodes.member[(0u + _e521)].x;
                        if (_e285 < 0f) {
                            let _e594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e583.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e594.unnamed.word, _e583.w), _e594.unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e600.unnamed, lt_mask_LightPlace(_e583.x, _e600.unnamed_1.shift));
                            phi_1197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_mask_LightPlace(_e606.unnamed_1.word, _e583.y));
                        } else {
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e583.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e622.unnamed.word, _e583.y), _e622.unnamed_1);
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e628.unnamed, lt_mask_LightPlace(_e583.z, _e628.unnamed_1.shift));
                            phi_1197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e634.unnamed, lt_mask_LightPlace(_e634.unnamed_1.word, _e583.w));
                        }
                        let _e642 = phi_1197_;
                        let _e652 = nodes.member[(0u + _e521)].y;
                        if (_e295 < 0f) {
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e652.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e663.unnamed.word, _e652.w), _e663.unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_mask_LightPlace(_e652.x, _e669.unnamed_1.shift));
                            phi_1224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_mask_LightPlace(_e675.unnamed_1.word, _e652.y));
                        } else {
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e652.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e691.unnamed.word, _e652.y), _e691.unnamed_1);
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_mask_LightPlace(_e652.z, _e697.unnamed_1.shift));
                            phi_1224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e703.unnamed, lt_mask_LightPlace(_e703.unnamed_1.word, _e652.w));
                        }
                        let _e711 = phi_1224_;
                        let _e721 = nodes.member[(0u + _e521)].z;
                        if (_e305 < 0f) {
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e721.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e732.unnamed.word, _e721.w), _e732.unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_mask_LightPlace(_e721.x, _e738.unnamed_1.shift));
                            phi_1251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_mask_LightPlace(_e744.unnamed_1.word, _e721.y));
                        } else {
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e721.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e760.unnamed.word, _e721.y), _e760.unnamed_1);
                            let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_mask_LightPlace(_e721.z, _e766.unnamed_1.shift));
                            phi_1251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e772.unnamed, lt_mask_LightPlace(_e772.unnamed_1.word, _e721.w));
                        }
                        let _e780 = phi_1251_;
                        phi_1257_ = 0u;
                        phi_1260_ = 0u;
                        loop {
                            let _e790 = phi_1257_;
                            let _e792 = phi_1260_;
                            local_2 = _e792;
                            local_3 = _e792;
                            local_4 = _e792;
                            let _e793 = (_e790 < 8u);
                            if _e793 {
                                let _e795 = (_e790 >> bitcast<u32>(2i));
                                let _e796 = (_e790 & 3u);
                                if (_e795 == 0u) {
                                    phi_1274_ = _e642.unnamed.word;
                                } else {
                                    phi_1274_ = _e642.unnamed.shift;
                                }
                                let _e799 = phi_1274_;
                                if (_e795 == 0u) {
                                    phi_1284_ = _e711.unnamed.word;
                                } else {
                                    phi_1284_ = _e711.unnamed.shift;
                                }
                                let _e808 = phi_1284_;
                                if (_e795 == 0u) {
                                    phi_1294_ = _e780.unnamed.word;
                                } else {
                                    phi_1294_ = _e780.unnamed.shift;
                                }
                                let _e817 = phi_1294_;
                                let _e830 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e799 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u)) * _e555) + (_e573 - _e333)), ((f32(((_e808 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u)) * _e556) + (_e574 - _e334)));
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(_e830, ((f32(((_e817 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e335)));
                                if (_e795 == 0u) {
                                    phi_1312_ = _e642.unnamed_1.word;
                                } else {
                                    phi_1312_ = _e642.unnamed_1.shift;
                                }
                                let _e834 = phi_1312_;
                                if (_e795 == 0u) {
                                    phi_1322_ = _e711.unnamed_1.word;
                                } else {
                                    phi_1322_ = _e711.unnamed_1.shift;
                                }
                                let _e843 = phi_1322_;
                                if (_e795 == 0u) {
                                    phi_1332_ = _e780.unnamed_1.word;
                                } else {
                                    phi_1332_ = _e780.unnamed_1.shift;
                                }
                                let _e852 = phi_1332_;
                                let _e865 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e834 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u)) * _e555) + (_e573 + _e333)), ((f32(((_e843 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u)) * _e556) + (_e574 + _e334)));
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(_e865, ((f32(((_e852 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e335)));
                                if (_e831 <= _e866) {
                                    if (_e831 <= _e136) {
                                        if (_e866 >= 0f) {
                                            if (_e795 == 0u) {
                                                let _e873 = nodes.member[(0u + _e521)].links[2u];
                                                phi_1368_ = _e873;
                                            } else {
                                                let _e876 = nodes.member[(0u + _e521)].links[3u];
                                                phi_1368_ = _e876;
                                            }
                                            let _e878 = phi_1368_;
                                            let _e883 = ((_e878 >> bitcast<u32>(((_e796 * 8u) & 31u))) & 255u);
                                            let _e884 = (_e883 & 31u);
                                            if (_e884 >= 24u) {
                                                phi_1381_ = (24u + ((_e884 - 24u) ^ _e383));
                                            } else {
                                                phi_1381_ = _e884;
                                            }
                                            let _e890 = phi_1381_;
                                            phi_1386_ = (_e792 | ((_e883 >> bitcast<u32>(5i)) << bitcast<u32>((_e890 & 31u))));
                                        } else {
                                            phi_1386_ = _e792;
                                        }
                                        let _e898 = phi_1386_;
                                        phi_1387_ = _e898;
                                    } else {
                                        phi_1387_ = _e792;
                                    }
                                    let _e900 = phi_1387_;
                                    phi_1388_ = _e900;
                                } else {
                                    phi_1388_ = _e792;
                                }
                                let _e902 = phi_1388_;
                                phi_1258_ = (_e790 + 1u);
                                phi_1261_ = _e902;
                            } else {
                                phi_1258_ = u32();
                                phi_1261_ = u32();
                            }
                            let _e905 = phi_1258_;
                            let _e907 = phi_1261_;
                            continue;
                            continuing {
                                phi_1257_ = _e905;
                                phi_1260_ = _e907;
                                break if !(_e793);
                            }
                        }
                        let _e911 = nodes.member[(0u + _e521)].links[0u];
                        let _e915 = nodes.member[(0u + _e521)].frame[3u];
                        let _e919 = local_2;
                        if ((_e919 & 4278190080u) == 0u) {
                        } else {
                            let _e923 = local_1.group_mask;
                            if ((_e923 & 4278190080u) == 0u) {
                            } else {
                                let _e927 = local_1.len;
                                if (_e927 < 32u) {
                                    let _e930 = local_1.group;
                                    let _e932 = local_1.len;
                                    if (_e932 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e932)] = _e930;
                                    let _e938 = local_1.group_mask;
                                    let _e940 = local_1.len;
                                    if (_e940 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e940)] = _e938;
                                    let _e947 = local_1.len;
                                    local_1.len = (_e947 + 1u);
                                }
                            }
                            local_1.group = (0u + _e911);
                            let _e951 = local_3;
                            local_1.group_mask = ((_e951 & 4278190080u) | (_e915 >> bitcast<u32>(24i)));
                        }
                        let _e956 = local_4;
                        phi_1446_ = (_e956 & 16777215u);
                        phi_1449_ = _e523;
                        loop {
                            let _e959 = phi_1446_;
                            let _e961 = phi_1449_;
                            local_7 = _e961;
                            let _e962 = (_e959 == 0u);
                            local_5 = _e962;
                            local_9 = _e962;
                            if _e962 {
                                phi_1447_ = u32();
                                phi_1450_ = bool();
                                phi_2253_ = bool();
                                phi_2254_ = false;
                            } else {
                                let _e965 = nodes.member[(0u + _e521)].links[1u];
                                let _e970 = ((0u + _e965) + select(firstTrailingBit(_e959), 32u, (_e959 == 0u)));
                                if (_e970 < _e78) {
                                } else {
                                    return;
                                }
                                let _e977 = triangles.member[(0u + _e970)].v0_;
                                let _e979 = (_e977.x - _e126);
                                let _e981 = (_e977.y - _e128);
                                let _e983 = (_e977.z - _e130);
                                if (_e356 == 0u) {
                                    phi_1494_ = vec3<f32>(_e981, _e983, _e979);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1493_ = vec3<f32>(_e983, _e979, _e981);
                                    } else {
                                        phi_1493_ = (_e977 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e991 = phi_1493_;
                                    phi_1494_ = _e991;
                                }
                                let _e993 = phi_1494_;
                                let _e997 = (_e993.x - (_e367 * _e993.z));
                                let _e1001 = (_e993.y - (_e370 * _e993.z));
                                let _e1003 = triangles.member[(0u + _e970)].v1_;
                                let _e1005 = (_e1003.x - _e126);
                                let _e1007 = (_e1003.y - _e128);
                                let _e1009 = (_e1003.z - _e130);
                                if (_e356 == 0u) {
                                    phi_1524_ = vec3<f32>(_e1007, _e1009, _e1005);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1523_ = vec3<f32>(_e1009, _e1005, _e1007);
                                    } else {
                                        phi_1523_ = (_e1003 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1017 = phi_1523_;
                                    phi_1524_ = _e1017;
                                }
                                let _e1019 = phi_1524_;
                                let _e1023 = (_e1019.x - (_e367 * _e1019.z));
                                let _e1027 = (_e1019.y - (_e370 * _e1019.z));
                                let _e1029 = triangles.member[(0u + _e970)].v2_;
                                let _e1031 = (_e1029.x - _e126);
                                let _e1033 = (_e1029.y - _e128);
                                let _e1035 = (_e1029.z - _e130);
                                if (_e356 == 0u) {
                                    phi_1554_ = vec3<f32>(_e1033, _e1035, _e1031);
                                } else {
                                    if (_e356 == 1u) {
                                        phi_1553_ = vec3<f32>(_e1035, _e1031, _e1033);
                                    } else {
                                        phi_1553_ = (_e1029 - vec3<f32>(_e126, _e128, _e130));
                                    }
                                    let _e1043 = phi_1553_;
                                    phi_1554_ = _e1043;
                                }
                                let _e1045 = phi_1554_;
                                let _e1049 = (_e1045.x - (_e367 * _e1045.z));
                                let _e1053 = (_e1045.y - (_e370 * _e1045.z));
                                if (_e1023 < _e1049) {
                                    phi_1573_ = true;
                                } else {
                                    if (_e1023 == _e1049) {
                                        phi_1572_ = (_e1027 < _e1053);
                                    } else {
                                        phi_1572_ = false;
                                    }
                                    let _e1058 = phi_1572_;
                                    phi_1573_ = _e1058;
                                }
                                let _e1060 = phi_1573_;
                                if _e1060 {
                                    phi_1577_ = _e1053;
                                    phi_1578_ = _e1049;
                                    phi_1579_ = _e1027;
                                    phi_1580_ = _e1023;
                                } else {
                                    phi_1577_ = _e1027;
                                    phi_1578_ = _e1023;
                                    phi_1579_ = _e1053;
                                    phi_1580_ = _e1049;
                                }
                                let _e1062 = phi_1577_;
                                let _e1064 = phi_1578_;
                                let _e1066 = phi_1579_;
                                let _e1068 = phi_1580_;
                                let _e1071 = ((_e1068 * _e1062) - (_e1066 * _e1064));
                                if _e1060 {
                                    phi_1588_ = -(_e1071);
                                } else {
                                    phi_1588_ = _e1071;
                                }
                                let _e1074 = phi_1588_;
                                if (_e1049 < _e997) {
                                    phi_1599_ = true;
                                } else {
                                    if (_e1049 == _e997) {
                                        phi_1598_ = (_e1053 < _e1001);
                                    } else {
                                        phi_1598_ = false;
                                    }
                                    let _e1079 = phi_1598_;
                                    phi_1599_ = _e1079;
                                }
                                let _e1081 = phi_1599_;
                                if _e1081 {
                                    phi_1603_ = _e1001;
                                    phi_1604_ = _e997;
                                    phi_1605_ = _e1053;
                                    phi_1606_ = _e1049;
                                } else {
                                    phi_1603_ = _e1053;
                                    phi_1604_ = _e1049;
                                    phi_1605_ = _e1001;
                                    phi_1606_ = _e997;
                                }
                                let _e1083 = phi_1603_;
                                let _e1085 = phi_1604_;
                                let _e1087 = phi_1605_;
                                let _e1089 = phi_1606_;
                                let _e1092 = ((_e1089 * _e1083) - (_e1087 * _e1085));
                                if _e1081 {
                                    phi_1614_ = -(_e1092);
                                } else {
                                    phi_1614_ = _e1092;
                                }
                                let _e1095 = phi_1614_;
                                if (_e997 < _e1023) {
                                    phi_1625_ = true;
                                } else {
                                    if (_e997 == _e1023) {
                                        phi_1624_ = (_e1001 < _e1027);
                                    } else {
                                        phi_1624_ = false;
                                    }
                                    let _e1100 = phi_1624_;
                                    phi_1625_ = _e1100;
                                }
                                let _e1102 = phi_1625_;
                                if _e1102 {
                                    phi_1629_ = _e1027;
                                    phi_1630_ = _e1023;
                                    phi_1631_ = _e1001;
                                    phi_1632_ = _e997;
                                } else {
                                    phi_1629_ = _e1001;
                                    phi_1630_ = _e997;
                                    phi_1631_ = _e1027;
                                    phi_1632_ = _e1023;
                                }
                                let _e1104 = phi_1629_;
                                let _e1106 = phi_1630_;
                                let _e1108 = phi_1631_;
                                let _e1110 = phi_1632_;
                                let _e1113 = ((_e1110 * _e1104) - (_e1108 * _e1106));
                                if _e1102 {
                                    phi_1640_ = -(_e1113);
                                } else {
                                    phi_1640_ = _e1113;
                                }
                                let _e1116 = phi_1640_;
                                if (_e1074 >= 0f) {
                                    if (_e1095 >= 0f) {
                                        if (_e1116 >= 0f) {
                                            phi_1655_ = ((_e1074 + _e1095) + _e1116);
                                            phi_1656_ = false;
                                        } else {
                                            phi_1655_ = f32();
                                            phi_1656_ = true;
                                        }
                                        let _e1123 = phi_1655_;
                                        let _e1125 = phi_1656_;
                                        phi_1657_ = _e1123;
                                        phi_1658_ = _e1125;
                                    } else {
                                        phi_1657_ = f32();
                                        phi_1658_ = true;
                                    }
                                    let _e1127 = phi_1657_;
                                    let _e1129 = phi_1658_;
                                    phi_1659_ = _e1127;
                                    phi_1660_ = _e1129;
                                } else {
                                    phi_1659_ = f32();
                                    phi_1660_ = true;
                                }
                                let _e1131 = phi_1659_;
                                let _e1133 = phi_1660_;
                                if _e1133 {
                                    if (_e1074 <= 0f) {
                                        if (_e1095 <= 0f) {
                                            let _e1136 = (_e1116 <= 0f);
                                            if _e1136 {
                                            }
                                            phi_1678_ = ((_e1074 + _e1095) + _e1116);
                                            phi_1679_ = false;
                                            phi_1680_ = _e1136;
                                        } else {
                                            phi_1678_ = f32();
                                            phi_1679_ = true;
                                            phi_1680_ = false;
                                        }
                                        let _e1140 = phi_1678_;
                                        let _e1142 = phi_1679_;
                                        let _e1144 = phi_1680_;
                                        phi_1681_ = _e1140;
                                        phi_1682_ = _e1142;
                                        phi_1683_ = _e1144;
                                    } else {
                                        phi_1681_ = f32();
                                        phi_1682_ = true;
                                        phi_1683_ = false;
                                    }
                                    let _e1146 = phi_1681_;
                                    let _e1148 = phi_1682_;
                                    let _e1150 = phi_1683_;
                                    if _e1148 {
                                        phi_1687_ = false;
                                    } else {
                                        phi_1687_ = _e1150;
                                    }
                                    let _e1152 = phi_1687_;
                                    phi_1688_ = _e1146;
                                    phi_1689_ = _e1152;
                                } else {
                                    phi_1688_ = _e1131;
                                    phi_1689_ = true;
                                }
                                let _e1154 = phi_1688_;
                                let _e1156 = phi_1689_;
                                if _e1156 {
                                    let _e1157 = (_e1154 == 0f);
                                    if _e1157 {
                                        phi_2005_ = lt_bvh_triangle_Intersection();
                                        phi_2006_ = false;
                                    } else {
                                        let _e1159 = triangles.member[(0u + _e970)].v0_;
                                        let _e1161 = (_e1159.x - _e126);
                                        let _e1163 = (_e1159.y - _e128);
                                        let _e1165 = (_e1159.z - _e130);
                                        if (_e356 == 0u) {
                                            phi_1718_ = vec3<f32>(_e1163, _e1165, _e1161);
                                        } else {
                                            if (_e356 == 1u) {
                                                phi_1717_ = vec3<f32>(_e1165, _e1161, _e1163);
                                            } else {
                                                phi_1717_ = (_e1159 - vec3<f32>(_e126, _e128, _e130));
                                            }
                                            let _e1173 = phi_1717_;
                                            phi_1718_ = _e1173;
                                        }
                                        let _e1175 = phi_1718_;
                                        let _e1177 = triangles.member[(0u + _e970)].v1_;
                                        let _e1179 = triangles.member[(0u + _e970)].v0_;
                                        let _e1182 = (_e1177.x - _e1179.x);
                                        let _e1185 = (_e1177.y - _e1179.y);
                                        let _e1188 = (_e1177.z - _e1179.z);
                                        if (_e356 == 0u) {
                                            phi_1744_ = vec3<f32>(_e1185, _e1188, _e1182);
                                        } else {
                                            if (_e356 == 1u) {
                                                phi_1743_ = vec3<f32>(_e1188, _e1182, _e1185);
                                            } else {
                                                phi_1743_ = (_e1177 - _e1179);
                                            }
                                            let _e1195 = phi_1743_;
                                            phi_1744_ = _e1195;
                                        }
                                        let _e1197 = phi_1744_;
                                        let _e1199 = triangles.member[(0u + _e970)].v2_;
                                        let _e1201 = triangles.member[(0u + _e970)].v0_;
                                        let _e1204 = (_e1199.x - _e1201.x);
                                        let _e1207 = (_e1199.y - _e1201.y);
                                        let _e1210 = (_e1199.z - _e1201.z);
                                        if (_e356 == 0u) {
                                            phi_1770_ = vec3<f32>(_e1207, _e1210, _e1204);
                                        } else {
                                            if (_e356 == 1u) {
                                                phi_1769_ = vec3<f32>(_e1210, _e1204, _e1207);
                                            } else {
                                                phi_1769_ = (_e1199 - _e1201);
                                            }
                                            let _e1217 = phi_1769_;
                                            phi_1770_ = _e1217;
                                        }
                                        let _e1219 = phi_1770_;
                                        let _e1226 = ((_e1197.y * _e1219.z) - (_e1197.z * _e1219.y));
                                        let _e1233 = ((_e1197.z * _e1219.x) - (_e1197.x * _e1219.z));
                                        let _e1240 = ((_e1197.x * _e1219.y) - (_e1197.y * _e1219.x));
                                        let _e1254 = (((1f / _e364.z) * (((_e1226 * _e1175.x) + (_e1233 * _e1175.y)) + (_e1240 * _e1175.z))) / (((_e1226 * _e367) + (_e1233 * _e370)) + _e1240));
                                        if (_e1254 > 0f) {
                                            if (_e1254 < _e136) {
                                                let _e1258 = triangles.member[(0u + _e970)].v0_;
                                                let _e1260 = triangles.member[(0u + _e970)].v1_;
                                                if (_e1258.x < _e1260.x) {
                                                    phi_1826_ = _e1258.x;
                                                } else {
                                                    phi_1826_ = _e1260.x;
                                                }
                                                let _e1267 = phi_1826_;
                                                if (_e1258.y < _e1260.y) {
                                                    phi_1835_ = _e1258.y;
                                                } else {
                                                    phi_1835_ = _e1260.y;
                                                }
                                                let _e1274 = phi_1835_;
                                                if (_e1258.z < _e1260.z) {
                                                    phi_1844_ = _e1258.z;
                                                } else {
                                                    phi_1844_ = _e1260.z;
                                                }
                                                let _e1281 = phi_1844_;
                                                let _e1283 = triangles.member[(0u + _e970)].v2_;
                                                if (_e1267 < _e1283.x) {
                                                    phi_1853_ = _e1267;
                                                } else {
                                                    phi_1853_ = _e1283.x;
                                                }
                                                let _e1288 = phi_1853_;
                                                if (_e1274 < _e1283.y) {
                                                    phi_1860_ = _e1274;
                                                } else {
                                                    phi_1860_ = _e1283.y;
                                                }
                                                let _e1293 = phi_1860_;
                                                if (_e1281 < _e1283.z) {
                                                    phi_1867_ = _e1281;
                                                } else {
                                                    phi_1867_ = _e1283.z;
                                                }
                                                let _e1298 = phi_1867_;
                                                let _e1300 = triangles.member[(0u + _e970)].v0_;
                                                let _e1302 = triangles.member[(0u + _e970)].v1_;
                                                if (_e1300.x > _e1302.x) {
                                                    phi_1880_ = _e1300.x;
                                                } else {
                                                    phi_1880_ = _e1302.x;
                                                }
                                                let _e1309 = phi_1880_;
                                                if (_e1300.y > _e1302.y) {
                                                    phi_1889_ = _e1300.y;
                                                } else {
                                                    phi_1889_ = _e1302.y;
                                                }
                                                let _e1316 = phi_1889_;
                                                if (_e1300.z > _e1302.z) {
                                                    phi_1898_ = _e1300.z;
                                                } else {
                                                    phi_1898_ = _e1302.z;
                                                }
                                                let _e1323 = phi_1898_;
                                                let _e1325 = triangles.member[(0u + _e970)].v2_;
                                                if (_e1309 > _e1325.x) {
                                                    phi_1907_ = _e1309;
                                                } else {
                                                    phi_1907_ = _e1325.x;
                                                }
                                                let _e1330 = phi_1907_;
                                                if (_e1316 > _e1325.y) {
                                                    phi_1914_ = _e1316;
                                                } else {
                                                    phi_1914_ = _e1325.y;
                                                }
                                                let _e1335 = phi_1914_;
                                                if (_e1323 > _e1325.z) {
                                                    phi_1921_ = _e1323;
                                                } else {
                                                    phi_1921_ = _e1325.z;
                                                }
                                                let _e1340 = phi_1921_;
                                                let _e1344 = ((_e1288 - _e126) * _e285);
                                                let _e1345 = ((_e1293 - _e128) * _e295);
                                                let _e1346 = ((_e1298 - _e130) * _e305);
                                                let _e1350 = ((_e1330 - _e126) * _e285);
                                                let _e1351 = ((_e1335 - _e128) * _e295);
                                                let _e1352 = ((_e1340 - _e130) * _e305);
                                                if (_e1344 < _e1350) {
                                                    phi_1938_ = _e1344;
                                                } else {
                                                    phi_1938_ = _e1350;
                                                }
                                                let _e1355 = phi_1938_;
                                                if (_e1345 < _e1351) {
                                                    phi_1943_ = _e1345;
                                                } else {
                                                    phi_1943_ = _e1351;
                                                }
                                                let _e1358 = phi_1943_;
                                                if (_e1346 < _e1352) {
                                                    phi_1948_ = _e1346;
                                                } else {
                                                    phi_1948_ = _e1352;
                                                }
                                                let _e1361 = phi_1948_;
                                                if (_e1344 > _e1350) {
                                                    phi_1956_ = _e1344;
                                                } else {
                                                    phi_1956_ = _e1350;
                                                }
                                                let _e1367 = phi_1956_;
                                                if (_e1345 > _e1351) {
                                                    phi_1961_ = _e1345;
                                                } else {
                                                    phi_1961_ = _e1351;
                                                }
                                                let _e1370 = phi_1961_;
                                                if (_e1346 > _e1352) {
                                                    phi_1966_ = _e1346;
                                                } else {
                                                    phi_1966_ = _e1352;
                                                }
                                                let _e1373 = phi_1966_;
                                                let _e1377 = core_intrinsics_maximum_number_nsz_f32_((_e1355 - _e340), (_e1358 - _e341));
                                                let _e1378 = core_intrinsics_maximum_number_nsz_f32_(_e1377, (_e1361 - _e342));
                                                let _e1379 = core_intrinsics_minimum_number_nsz_f32_((_e1367 + _e340), (_e1370 + _e341));
                                                let _e1380 = core_intrinsics_minimum_number_nsz_f32_(_e1379, (_e1373 + _e342));
                                                if (_e1378 > -300000000000000000000000000000000000000f) {
                                                    phi_1978_ = _e1378;
                                                } else {
                                                    phi_1978_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1383 = phi_1978_;
                                                if (_e1380 < 300000000000000000000000000000000000000f) {
                                                    phi_1983_ = _e1380;
                                                } else {
                                                    phi_1983_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1386 = phi_1983_;
                                                if (_e1254 < _e1383) {
                                                    phi_1988_ = _e1383;
                                                } else {
                                                    phi_1988_ = _e1254;
                                                }
                                                let _e1389 = phi_1988_;
                                                if (_e1389 > _e1386) {
                                                    phi_1993_ = _e1386;
                                                } else {
                                                    phi_1993_ = _e1389;
                                                }
                                                let _e1392 = phi_1993_;
                                                phi_1998_ = lt_bvh_triangle_Intersection(_e1392, (_e1095 / _e1154), (_e1116 / _e1154), (_e1383 <= _e1386));
                                                phi_1999_ = false;
                                            } else {
                                                phi_1998_ = lt_bvh_triangle_Intersection();
                                                phi_1999_ = true;
                                            }
                                            let _e1398 = phi_1998_;
                                            let _e1400 = phi_1999_;
                                            phi_2000_ = _e1398;
                                            phi_2001_ = _e1400;
                                        } else {
                                            phi_2000_ = lt_bvh_triangle_Intersection();
                                            phi_2001_ = true;
                                        }
                                        let _e1402 = phi_2000_;
                                        let _e1404 = phi_2001_;
                                        if _e1404 {
                                        }
                                        phi_2005_ = _e1402;
                                        phi_2006_ = _e1404;
                                    }
                                    let _e1406 = phi_2005_;
                                    let _e1408 = phi_2006_;
                                    phi_2007_ = _e1406;
                                    phi_2008_ = _e1157;
                                    phi_2009_ = _e1408;
                                } else {
                                    phi_2007_ = lt_bvh_triangle_Intersection();
                                    phi_2008_ = true;
                                    phi_2009_ = false;
                                }
                                let _e1410 = phi_2007_;
                                let _e1412 = phi_2008_;
                                let _e1414 = phi_2009_;
                                if _e1412 {
                                    phi_2013_ = true;
                                } else {
                                    phi_2013_ = _e1414;
                                }
                                let _e1416 = phi_2013_;
                                if _e1416 {
                                    phi_2017_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2017_ = _e1410;
                                }
                                let _e1418 = phi_2017_;
                                if _e1418.is_hit {
                                    if (_e1418.t > 0f) {
                                        if (_e1418.t < _e136) {
                                            let _e1425 = triangles.member[(0u + _e970)].i0_;
                                            if ((_e1425 & 2147483648u) == 0u) {
                                                phi_2236_ = true;
                                            } else {
                                                if (_e970 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1434 = triangles.member[(0u + _e970)].i0_;
                                                let _e1435 = (_e1434 & 2147483647u);
                                                let _e1437 = triangles.member[(0u + _e970)].i1_;
                                                let _e1439 = triangles.member[(0u + _e970)].i2_;
                                                if (_e1435 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1443 = vertices.member[(0u + _e1435)];
                                                if (_e1437 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1447 = vertices.member[(0u + _e1437)];
                                                if (_e1439 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1451 = vertices.member[(0u + _e1439)];
                                                let _e1452 = array<abi_Vertex, 3>(_e1443, _e1447, _e1451);
                                                if (_e1452[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1458 = materials.member[(0u + _e1452[0].material)];
                                                if ((_e1458.flags & 1u) == 1u) {
                                                    let _e1463 = ((1f - _e1418.u) - _e1418.v);
                                                    if (_e1458.cutoff <= 0f) {
                                                        phi_2234_ = true;
                                                    } else {
                                                        let _e1490 = (_e1458.base_color.w * ((((f32((_e1452[0].color >> bitcast<u32>(24i))) * _e1463) + (f32((_e1452[1].color >> bitcast<u32>(24i))) * _e1418.u)) + (f32((_e1452[2].color >> bitcast<u32>(24i))) * _e1418.v)) * (1f / 255f)));
                                                        if (_e1458.alpha_size == 0u) {
                                                            phi_2231_ = _e1490;
                                                        } else {
                                                            local.offset = _e1458.alpha_offset;
                                                            local.size = _e1458.alpha_size;
                                                            local.flags = _e1458.flags;
                                                            let _e1521 = _lt_shaders_texture_TextureView_quad((&local), (((_e1452[0].u * _e1463) + (_e1452[1].u * _e1418.u)) + (_e1452[2].u * _e1418.v)), (((_e1452[0].v * _e1463) + (_e1452[1].v * _e1418.u)) + (_e1452[2].v * _e1418.v)));
                                                            let _e1525 = (_e1521.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1525 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1529 = alpha_texels.member[(0u + _e1525)];
                                                            let _e1545 = (_e1521.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1545 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1549 = alpha_texels.member[(0u + _e1545)];
                                                            let _e1566 = (_e1521.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1566 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1570 = alpha_texels.member[(0u + _e1566)];
                                                            let _e1587 = (_e1521.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1587 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1591 = alpha_texels.member[(0u + _e1587)];
                                                            phi_2231_ = (_e1490 * (((((f32(((_e1529 >> bitcast<u32>((((_e1521.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.x) + ((f32(((_e1549 >> bitcast<u32>((((_e1521.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.y)) + ((f32(((_e1570 >> bitcast<u32>((((_e1521.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.z)) + ((f32(((_e1591 >> bitcast<u32>((((_e1521.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.w)));
                                                        }
                                                        let _e1607 = phi_2231_;
                                                        phi_2234_ = (_e1607 >= _e1458.cutoff);
                                                    }
                                                    let _e1611 = phi_2234_;
                                                    phi_2235_ = _e1611;
                                                } else {
                                                    phi_2235_ = false;
                                                }
                                                let _e1613 = phi_2235_;
                                                phi_2236_ = _e1613;
                                            }
                                            let _e1615 = phi_2236_;
                                            if _e1615 {
                                                phi_2240_ = false;
                                            } else {
                                                phi_2240_ = true;
                                            }
                                            let _e1617 = phi_2240_;
                                            phi_2241_ = _e1615;
                                            phi_2242_ = _e1615;
                                            phi_2243_ = _e1617;
                                        } else {
                                            phi_2241_ = bool();
                                            phi_2242_ = _e961;
                                            phi_2243_ = true;
                                        }
                                        let _e1619 = phi_2241_;
                                        let _e1621 = phi_2242_;
                                        let _e1623 = phi_2243_;
                                        phi_2244_ = _e1619;
                                        phi_2245_ = _e1621;
                                        phi_2246_ = _e1623;
                                    } else {
                                        phi_2244_ = bool();
                                        phi_2245_ = _e961;
                                        phi_2246_ = true;
                                    }
                                    let _e1625 = phi_2244_;
                                    let _e1627 = phi_2245_;
                                    let _e1629 = phi_2246_;
                                    phi_2247_ = _e1625;
                                    phi_2248_ = _e1627;
                                    phi_2249_ = _e1629;
                                } else {
                                    phi_2247_ = bool();
                                    phi_2248_ = _e961;
                                    phi_2249_ = true;
                                }
                                let _e1631 = phi_2247_;
                                let _e1633 = phi_2248_;
                                let _e1635 = phi_2249_;
                                if _e1635 {
                                }
                                phi_1447_ = (_e959 & (_e959 - 1u));
                                phi_1450_ = _e1633;
                                phi_2253_ = _e1631;
                                phi_2254_ = _e1635;
                            }
                            let _e1637 = phi_1447_;
                            let _e1639 = phi_1450_;
                            let _e1641 = phi_2253_;
                            let _e1643 = phi_2254_;
                            local_8 = _e1641;
                            continue;
                            continuing {
                                phi_1446_ = _e1637;
                                phi_1449_ = _e1639;
                                break if !(_e1643);
                            }
                        }
                        let _e1646 = local_5;
                        if _e1646 {
                            let _e1648 = local_1.group_mask;
                            if ((_e1648 & 4278190080u) == 0u) {
                                let _e1652 = local_1.len;
                                if (_e1652 == 0u) {
                                    phi_2296_ = false;
                                } else {
                                    let _e1656 = local_1.len;
                                    local_1.len = (_e1656 - 1u);
                                    let _e1659 = local_1.len;
                                    if (_e1659 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1664 = local_1.first[(0u + _e1659)];
                                    local_1.group = _e1664;
                                    let _e1667 = local_1.len;
                                    if (_e1667 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1672 = local_1.mask[(0u + _e1667)];
                                    local_1.group_mask = _e1672;
                                    phi_2296_ = true;
                                }
                                let _e1675 = phi_2296_;
                                phi_2297_ = _e1675;
                            } else {
                                phi_2297_ = true;
                            }
                            let _e1677 = phi_2297_;
                            if _e1677 {
                                let _e1679 = local_1.group_mask;
                                let _e1685 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1679)), 32u, (_e1679 == 0u)));
                                let _e1689 = local_1.group_mask;
                                let _e1703 = local_1.group_mask;
                                local_1.group_mask = (_e1703 & ~((1u << bitcast<u32>((_e1685 & 31u)))));
                                let _e1706 = local_1.group;
                                phi_2328_ = (_e1706 + countOneBits(((_e1689 & ~((4294967295u << bitcast<u32>((((_e1685 - 24u) ^ _e383) & 31u))))) & 255u)));
                            } else {
                                phi_2328_ = 4294967295u;
                            }
                            let _e1709 = phi_2328_;
                            phi_2329_ = _e1709;
                        } else {
                            phi_2329_ = u32();
                        }
                        let _e1711 = phi_2329_;
                        phi_1115_ = _e1711;
                        let _e1919 = local_7;
                        phi_1118_ = _e1919;
                        let _e1922 = local_8;
                        phi_2330_ = _e1922;
                        let _e1925 = local_9;
                        phi_2331_ = _e1925;
                        phi_2332_ = false;
                    } else {
                        phi_1115_ = u32();
                        phi_1118_ = bool();
                        phi_2330_ = bool();
                        phi_2331_ = false;
                        phi_2332_ = true;
                    }
                    let _e1713 = phi_1115_;
                    let _e1715 = phi_1118_;
                    let _e1717 = phi_2330_;
                    let _e1719 = phi_2331_;
                    let _e1721 = phi_2332_;
                    local_6 = _e1721;
                    local_10 = _e1717;
                    continue;
                    continuing {
                        phi_1114_ = _e1713;
                        phi_1117_ = _e1715;
                        break if !(_e1719);
                    }
                }
                let _e1724 = local_6;
                if _e1724 {
                    phi_2336_ = false;
                } else {
                    phi_2336_ = true;
                }
                let _e1726 = phi_2336_;
                if _e1726 {
                    let _e1931 = local_10;
                    phi_2340_ = _e1931;
                } else {
                    let _e1933 = local_11;
                    phi_2340_ = _e1933;
                }
                let _e1728 = phi_2340_;
                phi_2341_ = _e1728;
            }
            let _e1730 = phi_2341_;
            phi_2342_ = _e1730;
            phi_2343_ = _e209;
        } else {
            phi_2342_ = bool();
            phi_2343_ = true;
        }
        let _e1732 = phi_2342_;
        let _e1734 = phi_2343_;
        if _e1734 {
            phi_2347_ = false;
        } else {
            phi_2347_ = _e1732;
        }
        let _e1736 = phi_2347_;
        if _e1736 {
            phi_2351_ = 0f;
        } else {
            phi_2351_ = 1f;
        }
        let _e1738 = phi_2351_;
        if (_e106 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e1738;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
