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
@group(0) @binding(6) 
var<storage> vertices: type_43;
@group(0) @binding(7) 
var<storage> materials: type_47;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_191_: bool;
    var phi_195_: f32;

    if (param != param) {
        phi_191_ = true;
    } else {
        let _e69 = (param_1 >= param);
        if _e69 {
        }
        phi_191_ = _e69;
    }
    let _e71 = phi_191_;
    if _e71 {
        phi_195_ = param_1;
    } else {
        phi_195_ = param;
    }
    let _e73 = phi_195_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_207_: bool;
    var phi_211_: f32;

    if (param_2 != param_2) {
        phi_207_ = true;
    } else {
        let _e69 = (param_3 <= param_2);
        if _e69 {
        }
        phi_207_ = _e69;
    }
    let _e71 = phi_207_;
    if _e71 {
        phi_211_ = param_3;
    } else {
        phi_211_ = param_2;
    }
    let _e73 = phi_211_;
    return _e73;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_253_: f32;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_265_: f32;
    var phi_291_: f32;
    var phi_296_: f32;
    var phi_297_: bool;
    var phi_298_: f32;
    var phi_299_: bool;
    var phi_303_: f32;
    var phi_311_: f32;
    var phi_312_: f32;
    var phi_313_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_341_: u32;
    var phi_355_: u32;
    var phi_362_: u32;
    var phi_367_: u32;
    var phi_373_: u32;
    var phi_378_: u32;
    var phi_380_: texture_Axis;
    var phi_408_: f32;
    var phi_413_: f32;
    var phi_414_: bool;
    var phi_415_: f32;
    var phi_416_: bool;
    var phi_420_: f32;
    var phi_446_: f32;
    var phi_451_: f32;
    var phi_452_: bool;
    var phi_453_: f32;
    var phi_454_: bool;
    var phi_458_: f32;
    var phi_466_: f32;
    var phi_467_: f32;
    var phi_468_: f32;
    var phi_477_: f32;
    var phi_478_: f32;
    var phi_496_: u32;
    var phi_510_: u32;
    var phi_517_: u32;
    var phi_522_: u32;
    var phi_528_: u32;
    var phi_533_: u32;
    var phi_535_: texture_Axis;

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
                phi_253_ = 1f;
            } else {
                phi_253_ = 0f;
            }
            let _e100 = phi_253_;
            if (param_5 < 8388608f) {
                phi_258_ = (_e97 - _e100);
                phi_259_ = false;
            } else {
                phi_258_ = f32();
                phi_259_ = true;
            }
            let _e103 = phi_258_;
            let _e105 = phi_259_;
            phi_260_ = _e103;
            phi_261_ = _e105;
        } else {
            phi_260_ = f32();
            phi_261_ = true;
        }
        let _e107 = phi_260_;
        let _e109 = phi_261_;
        if _e109 {
            phi_265_ = param_5;
        } else {
            phi_265_ = _e107;
        }
        let _e111 = phi_265_;
        phi_313_ = (param_5 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_5 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_291_ = 1f;
                } else {
                    phi_291_ = 0f;
                }
                let _e129 = phi_291_;
                if (_e114 < 8388608f) {
                    phi_296_ = (_e126 - _e129);
                    phi_297_ = false;
                } else {
                    phi_296_ = f32();
                    phi_297_ = true;
                }
                let _e132 = phi_296_;
                let _e134 = phi_297_;
                phi_298_ = _e132;
                phi_299_ = _e134;
            } else {
                phi_298_ = f32();
                phi_299_ = true;
            }
            let _e136 = phi_298_;
            let _e138 = phi_299_;
            if _e138 {
                phi_303_ = _e114;
            } else {
                phi_303_ = _e136;
            }
            let _e140 = phi_303_;
            let _e142 = (param_5 - (2f * _e140));
            if (_e142 > 1f) {
                phi_311_ = (2f - _e142);
            } else {
                phi_311_ = _e142;
            }
            let _e146 = phi_311_;
            phi_312_ = _e146;
        } else {
            phi_312_ = param_5;
        }
        let _e148 = phi_312_;
        phi_313_ = _e148;
    }
    let _e150 = phi_313_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_322_ = _e150;
        } else {
            phi_322_ = 1f;
        }
        let _e154 = phi_322_;
        phi_323_ = _e154;
    } else {
        phi_323_ = 0f;
    }
    let _e156 = phi_323_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_341_ = _e157;
        } else {
            phi_341_ = _e166;
        }
        let _e169 = phi_341_;
        phi_380_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_355_ = _e71;
        } else {
            phi_355_ = _e178;
        }
        let _e181 = phi_355_;
        if (_e84 == 0u) {
            phi_362_ = _e157;
        } else {
            phi_362_ = 0u;
        }
        let _e186 = phi_362_;
        if (_e84 == 0u) {
            phi_367_ = 0u;
        } else {
            phi_367_ = _e157;
        }
        let _e189 = phi_367_;
        if (_e181 == 0u) {
            phi_373_ = _e186;
        } else {
            phi_373_ = (_e181 - 1u);
        }
        let _e193 = phi_373_;
        if (_e181 > _e157) {
            phi_378_ = _e189;
        } else {
            phi_378_ = _e181;
        }
        let _e196 = phi_378_;
        phi_380_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_380_;
    let _e201 = (*param_4).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_6 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e217 > param_6) {
                phi_408_ = 1f;
            } else {
                phi_408_ = 0f;
            }
            let _e220 = phi_408_;
            if (param_6 < 8388608f) {
                phi_413_ = (_e217 - _e220);
                phi_414_ = false;
            } else {
                phi_413_ = f32();
                phi_414_ = true;
            }
            let _e223 = phi_413_;
            let _e225 = phi_414_;
            phi_415_ = _e223;
            phi_416_ = _e225;
        } else {
            phi_415_ = f32();
            phi_416_ = true;
        }
        let _e227 = phi_415_;
        let _e229 = phi_416_;
        if _e229 {
            phi_420_ = param_6;
        } else {
            phi_420_ = _e227;
        }
        let _e231 = phi_420_;
        phi_468_ = (param_6 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_6 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_446_ = 1f;
                } else {
                    phi_446_ = 0f;
                }
                let _e249 = phi_446_;
                if (_e234 < 8388608f) {
                    phi_451_ = (_e246 - _e249);
                    phi_452_ = false;
                } else {
                    phi_451_ = f32();
                    phi_452_ = true;
                }
                let _e252 = phi_451_;
                let _e254 = phi_452_;
                phi_453_ = _e252;
                phi_454_ = _e254;
            } else {
                phi_453_ = f32();
                phi_454_ = true;
            }
            let _e256 = phi_453_;
            let _e258 = phi_454_;
            if _e258 {
                phi_458_ = _e234;
            } else {
                phi_458_ = _e256;
            }
            let _e260 = phi_458_;
            let _e262 = (param_6 - (2f * _e260));
            if (_e262 > 1f) {
                phi_466_ = (2f - _e262);
            } else {
                phi_466_ = _e262;
            }
            let _e266 = phi_466_;
            phi_467_ = _e266;
        } else {
            phi_467_ = param_6;
        }
        let _e268 = phi_467_;
        phi_468_ = _e268;
    }
    let _e270 = phi_468_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_477_ = _e270;
        } else {
            phi_477_ = 1f;
        }
        let _e274 = phi_477_;
        phi_478_ = _e274;
    } else {
        phi_478_ = 0f;
    }
    let _e276 = phi_478_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_496_ = _e277;
        } else {
            phi_496_ = _e286;
        }
        let _e289 = phi_496_;
        phi_535_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_510_ = _e75;
        } else {
            phi_510_ = _e298;
        }
        let _e301 = phi_510_;
        if (_e204 == 0u) {
            phi_517_ = _e277;
        } else {
            phi_517_ = 0u;
        }
        let _e306 = phi_517_;
        if (_e204 == 0u) {
            phi_522_ = 0u;
        } else {
            phi_522_ = _e277;
        }
        let _e309 = phi_522_;
        if (_e301 == 0u) {
            phi_528_ = _e306;
        } else {
            phi_528_ = (_e301 - 1u);
        }
        let _e313 = phi_528_;
        if (_e301 > _e277) {
            phi_533_ = _e309;
        } else {
            phi_533_ = _e301;
        }
        let _e316 = phi_533_;
        phi_535_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_535_;
    let _e323 = (*param_4).offset;
    let _e330 = (*param_4).offset;
    let _e337 = (*param_4).offset;
    let _e344 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_672_: f32;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
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
    var phi_754_: bool;
    var phi_758_: bool;
    var phi_828_: f32;
    var phi_835_: f32;
    var phi_842_: f32;
    var phi_849_: f32;
    var phi_856_: f32;
    var phi_863_: f32;
    var phi_880_: f32;
    var phi_885_: f32;
    var phi_890_: f32;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_927_: u32;
    var phi_928_: u32;
    var phi_939_: vec3<f32>;
    var phi_940_: vec3<f32>;
    var phi_953_: u32;
    var phi_958_: u32;
    var phi_963_: u32;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1109_: u32;
    var phi_1111_: u32;
    var phi_1114_: bool;
    var phi_1194_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1221_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1248_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1254_: u32;
    var phi_1257_: u32;
    var phi_1271_: u32;
    var phi_1281_: u32;
    var phi_1291_: u32;
    var phi_1309_: u32;
    var phi_1319_: u32;
    var phi_1329_: u32;
    var phi_1365_: u32;
    var phi_1378_: u32;
    var phi_1383_: u32;
    var phi_1384_: u32;
    var phi_1385_: u32;
    var phi_1255_: u32;
    var phi_1258_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1443_: u32;
    var phi_1446_: bool;
    var phi_1490_: vec3<f32>;
    var phi_1491_: vec3<f32>;
    var phi_1520_: vec3<f32>;
    var phi_1521_: vec3<f32>;
    var phi_1550_: vec3<f32>;
    var phi_1551_: vec3<f32>;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1585_: f32;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1600_: f32;
    var phi_1601_: f32;
    var phi_1602_: f32;
    var phi_1603_: f32;
    var phi_1611_: f32;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1626_: f32;
    var phi_1627_: f32;
    var phi_1628_: f32;
    var phi_1629_: f32;
    var phi_1637_: f32;
    var phi_1652_: f32;
    var phi_1653_: bool;
    var phi_1654_: f32;
    var phi_1655_: bool;
    var phi_1656_: f32;
    var phi_1657_: bool;
    var phi_1675_: f32;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1678_: f32;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1684_: bool;
    var phi_1685_: f32;
    var phi_1686_: bool;
    var phi_1714_: vec3<f32>;
    var phi_1715_: vec3<f32>;
    var phi_1740_: vec3<f32>;
    var phi_1741_: vec3<f32>;
    var phi_1766_: vec3<f32>;
    var phi_1767_: vec3<f32>;
    var phi_1823_: f32;
    var phi_1832_: f32;
    var phi_1841_: f32;
    var phi_1850_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1877_: f32;
    var phi_1886_: f32;
    var phi_1895_: f32;
    var phi_1904_: f32;
    var phi_1911_: f32;
    var phi_1918_: f32;
    var phi_1935_: f32;
    var phi_1940_: f32;
    var phi_1945_: f32;
    var phi_1953_: f32;
    var phi_1958_: f32;
    var phi_1963_: f32;
    var phi_1975_: f32;
    var phi_1980_: f32;
    var phi_1985_: f32;
    var phi_1990_: f32;
    var phi_1995_: lt_bvh_triangle_Intersection;
    var phi_1996_: bool;
    var phi_1997_: lt_bvh_triangle_Intersection;
    var phi_1998_: bool;
    var phi_2002_: lt_bvh_triangle_Intersection;
    var phi_2003_: bool;
    var phi_2004_: lt_bvh_triangle_Intersection;
    var phi_2005_: bool;
    var phi_2006_: bool;
    var phi_2010_: bool;
    var phi_2014_: lt_bvh_triangle_Intersection;
    var phi_2228_: f32;
    var phi_2231_: bool;
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
    var phi_1444_: u32;
    var phi_1447_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var local_5: bool;
    var phi_2293_: bool;
    var phi_2294_: bool;
    var phi_2325_: u32;
    var phi_2326_: u32;
    var phi_1112_: u32;
    var phi_1115_: bool;
    var phi_2327_: bool;
    var phi_2328_: bool;
    var phi_2329_: bool;
    var local_6: bool;
    var phi_2333_: bool;
    var phi_2337_: bool;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var phi_2340_: bool;
    var phi_2344_: bool;
    var phi_2348_: f32;
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
        let _e111 = p.member.light;
        let _e113 = samples.member[(0u + _e106)].position;
        let _e115 = samples.member[(0u + _e106)].normal;
        let _e117 = samples.member[(0u + _e106)].magnitude;
        let _e119 = ((8f / 8388608f) * _e117);
        let _e127 = (_e113.x + (_e115.x * _e119));
        let _e129 = (_e113.y + (_e115.y * _e119));
        let _e131 = (_e113.z + (_e115.z * _e119));
        if (_e111.w == 0f) {
            phi_672_ = 300000000000000000000000000000000000000f;
        } else {
            phi_672_ = 1f;
        }
        let _e135 = phi_672_;
        let _e143 = (_e111.x - (_e127 * _e111.w));
        let _e144 = (_e111.y - (_e129 * _e111.w));
        let _e145 = (_e111.z - (_e131 * _e111.w));
        let _e150 = abs(_e143);
        let _e151 = abs(_e144);
        let _e152 = abs(_e145);
        if (abs(_e127) < 1000000000000000f) {
            if (abs(_e129) < 1000000000000000f) {
                if (abs(_e131) < 1000000000000000f) {
                    if (_e150 < 1000000000000000f) {
                        if (_e151 < 1000000000000000f) {
                            if (_e152 < 1000000000000000f) {
                                if (_e150 > 0f) {
                                    phi_728_ = bool();
                                    phi_729_ = true;
                                } else {
                                    let _e160 = (_e151 > 0f);
                                    if _e160 {
                                        phi_727_ = bool();
                                    } else {
                                        phi_727_ = (_e152 > 0f);
                                    }
                                    let _e163 = phi_727_;
                                    phi_728_ = _e163;
                                    phi_729_ = _e160;
                                }
                                let _e165 = phi_728_;
                                let _e167 = phi_729_;
                                if _e167 {
                                    phi_733_ = true;
                                } else {
                                    phi_733_ = _e165;
                                }
                                let _e169 = phi_733_;
                                phi_734_ = _e169;
                                phi_735_ = false;
                            } else {
                                phi_734_ = bool();
                                phi_735_ = true;
                            }
                            let _e171 = phi_734_;
                            let _e173 = phi_735_;
                            phi_736_ = _e171;
                            phi_737_ = false;
                            phi_738_ = _e173;
                        } else {
                            phi_736_ = bool();
                            phi_737_ = true;
                            phi_738_ = false;
                        }
                        let _e175 = phi_736_;
                        let _e177 = phi_737_;
                        let _e179 = phi_738_;
                        phi_739_ = _e175;
                        phi_740_ = _e177;
                        phi_741_ = _e179;
                    } else {
                        phi_739_ = bool();
                        phi_740_ = true;
                        phi_741_ = false;
                    }
                    let _e181 = phi_739_;
                    let _e183 = phi_740_;
                    let _e185 = phi_741_;
                    phi_742_ = _e181;
                    phi_743_ = _e183;
                    phi_744_ = _e185;
                } else {
                    phi_742_ = bool();
                    phi_743_ = true;
                    phi_744_ = false;
                }
                let _e187 = phi_742_;
                let _e189 = phi_743_;
                let _e191 = phi_744_;
                phi_745_ = _e187;
                phi_746_ = _e189;
                phi_747_ = _e191;
            } else {
                phi_745_ = bool();
                phi_746_ = true;
                phi_747_ = false;
            }
            let _e193 = phi_745_;
            let _e195 = phi_746_;
            let _e197 = phi_747_;
            phi_748_ = _e193;
            phi_749_ = _e195;
            phi_750_ = _e197;
        } else {
            phi_748_ = bool();
            phi_749_ = true;
            phi_750_ = false;
        }
        let _e199 = phi_748_;
        let _e201 = phi_749_;
        let _e203 = phi_750_;
        if _e201 {
            phi_754_ = true;
        } else {
            phi_754_ = _e203;
        }
        let _e205 = phi_754_;
        if _e205 {
            phi_758_ = false;
        } else {
            phi_758_ = _e199;
        }
        let _e207 = phi_758_;
        if _e207 {
            let _e208 = (0u >= _e75);
            if _e208 {
                phi_2338_ = bool();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e214 = nodes.member[(0u + 0u)].frame[0u];
                let _e218 = nodes.member[(0u + 0u)].frame[1u];
                let _e222 = nodes.member[(0u + 0u)].frame[2u];
                let _e226 = nodes.member[(0u + 0u)].frame[0u];
                let _e230 = nodes.member[(0u + 0u)].frame[1u];
                let _e234 = nodes.member[(0u + 0u)].frame[2u];
                let _e238 = nodes.member[(0u + 0u)].frame[3u];
                let _e272 = core_intrinsics_maximum_number_nsz_f32_(abs(_e143), abs(_e144));
                let _e273 = core_intrinsics_maximum_number_nsz_f32_(_e272, abs(_e145));
                let _e274 = (_e273 * 0.0000000000009094947f);
                if (abs(_e143) < _e274) {
                    phi_828_ = _e274;
                } else {
                    phi_828_ = abs(_e143);
                }
                let _e279 = phi_828_;
                if (_e143 < 0f) {
                    phi_835_ = (-1f / _e279);
                } else {
                    phi_835_ = (1f / _e279);
                }
                let _e284 = phi_835_;
                if (abs(_e144) < _e274) {
                    phi_842_ = _e274;
                } else {
                    phi_842_ = abs(_e144);
                }
                let _e289 = phi_842_;
                if (_e144 < 0f) {
                    phi_849_ = (-1f / _e289);
                } else {
                    phi_849_ = (1f / _e289);
                }
                let _e294 = phi_849_;
                if (abs(_e145) < _e274) {
                    phi_856_ = _e274;
                } else {
                    phi_856_ = abs(_e145);
                }
                let _e299 = phi_856_;
                if (_e145 < 0f) {
                    phi_863_ = (-1f / _e299);
                } else {
                    phi_863_ = (1f / _e299);
                }
                let _e304 = phi_863_;
                let _e308 = abs((bitcast<f32>(_e214) - _e127));
                let _e309 = abs((bitcast<f32>(_e218) - _e129));
                let _e310 = abs((bitcast<f32>(_e222) - _e131));
                let _e314 = abs(((bitcast<f32>(_e226) + (bitcast<f32>((((_e238 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e127));
                let _e315 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e238 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e129));
                let _e316 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e238 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                if (_e308 > _e314) {
                    phi_880_ = _e308;
                } else {
                    phi_880_ = _e314;
                }
                let _e319 = phi_880_;
                if (_e309 > _e315) {
                    phi_885_ = _e309;
                } else {
                    phi_885_ = _e315;
                }
                let _e322 = phi_885_;
                if (_e310 > _e316) {
                    phi_890_ = _e310;
                } else {
                    phi_890_ = _e316;
                }
                let _e325 = phi_890_;
                let _e326 = core_intrinsics_maximum_number_nsz_f32_(_e319, _e322);
                let _e327 = core_intrinsics_maximum_number_nsz_f32_(_e326, _e325);
                let _e331 = (_e327 * 0.0000019073486f);
                let _e332 = (abs(_e284) * _e331);
                let _e333 = (abs(_e294) * _e331);
                let _e334 = (abs(_e304) * _e331);
                let _e338 = (_e327 * 0.0000009536743f);
                let _e339 = (abs(_e284) * _e338);
                let _e340 = (abs(_e294) * _e338);
                let _e341 = (abs(_e304) * _e338);
                let _e342 = abs(_e143);
                let _e343 = abs(_e144);
                let _e344 = abs(_e145);
                if (_e342 >= _e343) {
                    if (_e342 >= _e344) {
                        phi_918_ = false;
                    } else {
                        phi_918_ = true;
                    }
                    let _e348 = phi_918_;
                    phi_919_ = _e348;
                } else {
                    phi_919_ = true;
                }
                let _e350 = phi_919_;
                if _e350 {
                    if (_e343 >= _e344) {
                        phi_927_ = 1u;
                    } else {
                        phi_927_ = 2u;
                    }
                    let _e353 = phi_927_;
                    phi_928_ = _e353;
                } else {
                    phi_928_ = 0u;
                }
                let _e355 = phi_928_;
                if (_e355 == 0u) {
                    phi_940_ = vec3<f32>(_e144, _e145, _e143);
                } else {
                    if (_e355 == 1u) {
                        phi_939_ = vec3<f32>(_e145, _e143, _e144);
                    } else {
                        phi_939_ = vec3<f32>(_e143, _e144, _e145);
                    }
                    let _e361 = phi_939_;
                    phi_940_ = _e361;
                }
                let _e363 = phi_940_;
                let _e366 = (_e363.x / _e363.z);
                let _e369 = (_e363.y / _e363.z);
                if (_e284 < 0f) {
                    phi_953_ = 0u;
                } else {
                    phi_953_ = 1u;
                }
                let _e374 = phi_953_;
                if (_e294 < 0f) {
                    phi_958_ = 0u;
                } else {
                    phi_958_ = 2u;
                }
                let _e377 = phi_958_;
                if (_e304 < 0f) {
                    phi_963_ = 0u;
                } else {
                    phi_963_ = 4u;
                }
                let _e380 = phi_963_;
                let _e382 = ((_e374 | _e377) | _e380);
                let _e383 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e383.first[0], _e383.first[1], _e383.first[2], _e383.first[3], _e383.first[4], _e383.first[5], _e383.first[6], _e383.first[7], _e383.first[8], _e383.first[9], _e383.first[10], _e383.first[11], _e383.first[12], _e383.first[13], _e383.first[14], _e383.first[15], _e383.first[16], _e383.first[17], _e383.first[18], _e383.first[19], _e383.first[20], _e383.first[21], _e383.first[22], _e383.first[23], _e383.first[24], _e383.first[25], _e383.first[26], _e383.first[27], _e383.first[28], _e383.first[29], _e383.first[30], _e383.first[31]), array<u32, 32>(_e383.mask[0], _e383.mask[1], _e383.mask[2], _e383.mask[3], _e383.mask[4], _e383.mask[5], _e383.mask[6], _e383.mask[7], _e383.mask[8], _e383.mask[9], _e383.mask[10], _e383.mask[11], _e383.mask[12], _e383.mask[13], _e383.mask[14], _e383.mask[15], _e383.mask[16], _e383.mask[17], _e383.mask[18], _e383.mask[19], _e383.mask[20], _e383.mask[21], _e383.mask[22], _e383.mask[23], _e383.mask[24], _e383.mask[25], _e383.mask[26], _e383.mask[27], _e383.mask[28], _e383.mask[29], _e383.mask[30], _e383.mask[31]), _e383.len, _e383.group, _e383.group_mask);
                let _e457 = local_1.group_mask;
                if ((_e457 & 4278190080u) == 0u) {
                    let _e461 = local_1.len;
                    if (_e461 == 0u) {
                        phi_1077_ = false;
                    } else {
                        let _e465 = local_1.len;
                        local_1.len = (_e465 - 1u);
                        let _e468 = local_1.len;
                        if (_e468 < 32u) {
                        } else {
                            return;
                        }
                        let _e473 = local_1.first[(0u + _e468)];
                        local_1.group = _e473;
                        let _e476 = local_1.len;
                        if (_e476 < 32u) {
                        } else {
                            return;
                        }
                        let _e481 = local_1.mask[(0u + _e476)];
                        local_1.group_mask = _e481;
                        phi_1077_ = true;
                    }
                    let _e484 = phi_1077_;
                    phi_1078_ = _e484;
                } else {
                    phi_1078_ = true;
                }
                let _e486 = phi_1078_;
                if _e486 {
                    let _e488 = local_1.group_mask;
                    let _e494 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e488)), 32u, (_e488 == 0u)));
                    let _e498 = local_1.group_mask;
                    let _e512 = local_1.group_mask;
                    local_1.group_mask = (_e512 & ~((1u << bitcast<u32>((_e494 & 31u)))));
                    let _e515 = local_1.group;
                    phi_1109_ = (_e515 + countOneBits(((_e498 & ~((4294967295u << bitcast<u32>((((_e494 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1109_ = 4294967295u;
                }
                let _e518 = phi_1109_;
                phi_1111_ = _e518;
                phi_1114_ = false;
                loop {
                    let _e520 = phi_1111_;
                    let _e522 = phi_1114_;
                    local_11 = _e522;
                    if (_e520 != 4294967295u) {
                        if (_e520 < _e75) {
                        } else {
                            return;
                        }
                        let _e529 = nodes.member[(0u + _e520)].frame[3u];
                        let _e554 = (bitcast<f32>((((_e529 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e555 = (bitcast<f32>((((_e529 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e294);
                        let _e556 = (bitcast<f32>((((_e529 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e559 = nodes.member[(0u + _e520)].frame[0u];
                        let _e563 = nodes.member[(0u + _e520)].frame[1u];
                        let _e567 = nodes.member[(0u + _e520)].frame[2u];
                        let _e572 = ((bitcast<f32>(_e559) - _e127) * _e284);
                        let _e573 = ((bitcast<f32>(_e563) - _e129) * _e294);
                        let _e574 = ((bitcast<f32>(_e567) - _e131) * _e304);
                        let _e582 = nodes.member[(0u + _e520)].x;
                        if (_e284 < 0f) {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e582.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.unnamed.root, _e582.w), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_bvh_traverse_Tree(_e582.x, _e599.unnamed_1.first_primitive));
                            phi_1194_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e605.unnamed_1.root, _e582.y));
                        } else {
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e582.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.unnamed.root, _e582.y), _e621.unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_bvh_traverse_Tree(_e582.z, _e627.unnamed_1.first_primitive));
                            phi_1194_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_bvh_traverse_Tree(_e633.unnamed_1.root, _e582.w));
                        }
                        let _e641 = phi_1194_;
                        let _e651 = nodes.member[(0u + _e520)].y;
                        if (_e294 < 0f) {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e651.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e651.w), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e651.x, _e668.unnamed_1.first_primitive));
                            phi_1221_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e651.y));
                        } else {
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e651.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.unnamed.root, _e651.y), _e690.unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e651.z, _e696.unnamed_1.first_primitive));
                            phi_1221_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_bvh_traverse_Tree(_e702.unnamed_1.root, _e651.w));
                        }
                        let _e710 = phi_1221_;
                        let _e720 = nodes.member[(0u + _e520)].z;
                        if (_e304 < 0f) {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e720.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e720.w), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e720.x, _e737.unnamed_1.first_primitive));
                            phi_1248_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e720.y));
                        } else {
                            let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e720.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e759.unnamed.root, _e720.y), _e759.unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_bvh_traverse_Tree(_e720.z, _e765.unnamed_1.first_primitive));
                            phi_1248_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_bvh_traverse_Tree(_e771.unnamed_1.root, _e720.w));
                        }
                        let _e779 = phi_1248_;
                        phi_1254_ = 0u;
                        phi_1257_ = 0u;
                        loop {
                            let _e789 = phi_1254_;
                            let _e791 = phi_1257_;
                            local_2 = _e791;
                            local_3 = _e791;
                            local_4 = _e791;
                            let _e792 = (_e789 < 8u);
                            if _e792 {
                                let _e794 = (_e789 >> bitcast<u32>(2i));
                                let _e795 = (_e789 & 3u);
                                if (_e794 == 0u) {
                                    phi_1271_ = _e641.unnamed.root;
                                } else {
                                    phi_1271_ = _e641.unnamed.first_primitive;
                                }
                                let _e798 = phi_1271_;
                                if (_e794 == 0u) {
                                    phi_1281_ = _e710.unnamed.root;
                                } else {
                                    phi_1281_ = _e710.unnamed.first_primitive;
                                }
                                let _e807 = phi_1281_;
                                if (_e794 == 0u) {
                                    phi_1291_ = _e779.unnamed.root;
                                } else {
                                    phi_1291_ = _e779.unnamed.first_primitive;
                                }
                                let _e816 = phi_1291_;
                                let _e829 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e798 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e554) + (_e572 - _e332)), ((f32(((_e807 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e555) + (_e573 - _e333)));
                                let _e830 = core_intrinsics_maximum_number_nsz_f32_(_e829, ((f32(((_e816 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e556) + (_e574 - _e334)));
                                if (_e794 == 0u) {
                                    phi_1309_ = _e641.unnamed_1.root;
                                } else {
                                    phi_1309_ = _e641.unnamed_1.first_primitive;
                                }
                                let _e833 = phi_1309_;
                                if (_e794 == 0u) {
                                    phi_1319_ = _e710.unnamed_1.root;
                                } else {
                                    phi_1319_ = _e710.unnamed_1.first_primitive;
                                }
                                let _e842 = phi_1319_;
                                if (_e794 == 0u) {
                                    phi_1329_ = _e779.unnamed_1.root;
                                } else {
                                    phi_1329_ = _e779.unnamed_1.first_primitive;
                                }
                                let _e851 = phi_1329_;
                                let _e864 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e833 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e554) + (_e572 + _e332)), ((f32(((_e842 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e555) + (_e573 + _e333)));
                                let _e865 = core_intrinsics_minimum_number_nsz_f32_(_e864, ((f32(((_e851 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e556) + (_e574 + _e334)));
                                if (_e830 <= _e865) {
                                    if (_e830 <= _e135) {
                                        if (_e865 >= 0f) {
                                            if (_e794 == 0u) {
                                                let _e872 = nodes.member[(0u + _e520)].links[2u];
                                                phi_1365_ = _e872;
                                            } else {
                                                let _e875 = nodes.member[(0u + _e520)].links[3u];
                                                phi_1365_ = _e875;
                                            }
                                            let _e877 = phi_1365_;
                                            let _e882 = ((_e877 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u);
                                            let _e883 = (_e882 & 31u);
                                            if (_e883 >= 24u) {
                                                phi_1378_ = (24u + ((_e883 - 24u) ^ _e382));
                                            } else {
                                                phi_1378_ = _e883;
                                            }
                                            let _e889 = phi_1378_;
                                            phi_1383_ = (_e791 | ((_e882 >> bitcast<u32>(5i)) << bitcast<u32>((_e889 & 31u))));
                                        } else {
                                            phi_1383_ = _e791;
                                        }
                                        let _e897 = phi_1383_;
                                        phi_1384_ = _e897;
                                    } else {
                                        phi_1384_ = _e791;
                                    }
                                    let _e899 = phi_1384_;
                                    phi_1385_ = _e899;
                                } else {
                                    phi_1385_ = _e791;
                                }
                                let _e901 = phi_1385_;
                                phi_1255_ = (_e789 + 1u);
                                phi_1258_ = _e901;
                            } else {
                                phi_1255_ = u32();
                                phi_1258_ = u32();
                            }
                            let _e904 = phi_1255_;
                            let _e906 = phi_1258_;
                            continue;
                            continuing {
                                phi_1254_ = _e904;
                                phi_1257_ = _e906;
                                break if !(_e792);
                            }
                        }
                        let _e910 = nodes.member[(0u + _e520)].links[0u];
                        let _e914 = nodes.member[(0u + _e520)].frame[3u];
                        let _e918 = local_2;
                        if ((_e918 & 4278190080u) == 0u) {
                        } else {
                            let _e922 = local_1.group_mask;
                            if ((_e922 & 4278190080u) == 0u) {
                            } else {
                                let _e926 = local_1.len;
                                if (_e926 < 32u) {
                                    let _e929 = local_1.group;
                                    let _e931 = local_1.len;
                                    if (_e931 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e931)] = _e929;
                                    let _e937 = local_1.group_mask;
                                    let _e939 = local_1.len;
                                    if (_e939 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e939)] = _e937;
                                    let _e946 = local_1.len;
                                    local_1.len = (_e946 + 1u);
                                }
                            }
                            local_1.group = (0u + _e910);
                            let _e950 = local_3;
                            local_1.group_mask = ((_e950 & 4278190080u) | (_e914 >> bitcast<u32>(24i)));
                        }
                        let _e955 = local_4;
                        phi_1443_ = (_e955 & 16777215u);
                        phi_1446_ = _e522;
                        loop {
                            let _e958 = phi_1443_;
                            let _e960 = phi_1446_;
                            local_7 = _e960;
                            let _e961 = (_e958 == 0u);
                            local_5 = _e961;
                            local_9 = _e961;
                            if _e961 {
                                phi_1444_ = u32();
                                phi_1447_ = bool();
                                phi_2250_ = bool();
                                phi_2251_ = false;
                            } else {
                                let _e964 = nodes.member[(0u + _e520)].links[1u];
                                let _e969 = ((0u + _e964) + select(firstTrailingBit(_e958), 32u, (_e958 == 0u)));
                                if (_e969 < _e78) {
                                } else {
                                    return;
                                }
                                let _e976 = triangles.member[(0u + _e969)].v0_;
                                let _e978 = (_e976.x - _e127);
                                let _e980 = (_e976.y - _e129);
                                let _e982 = (_e976.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1491_ = vec3<f32>(_e980, _e982, _e978);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1490_ = vec3<f32>(_e982, _e978, _e980);
                                    } else {
                                        phi_1490_ = (_e976 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e990 = phi_1490_;
                                    phi_1491_ = _e990;
                                }
                                let _e992 = phi_1491_;
                                let _e996 = (_e992.x - (_e366 * _e992.z));
                                let _e1000 = (_e992.y - (_e369 * _e992.z));
                                let _e1002 = triangles.member[(0u + _e969)].v1_;
                                let _e1004 = (_e1002.x - _e127);
                                let _e1006 = (_e1002.y - _e129);
                                let _e1008 = (_e1002.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1521_ = vec3<f32>(_e1006, _e1008, _e1004);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1520_ = vec3<f32>(_e1008, _e1004, _e1006);
                                    } else {
                                        phi_1520_ = (_e1002 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1016 = phi_1520_;
                                    phi_1521_ = _e1016;
                                }
                                let _e1018 = phi_1521_;
                                let _e1022 = (_e1018.x - (_e366 * _e1018.z));
                                let _e1026 = (_e1018.y - (_e369 * _e1018.z));
                                let _e1028 = triangles.member[(0u + _e969)].v2_;
                                let _e1030 = (_e1028.x - _e127);
                                let _e1032 = (_e1028.y - _e129);
                                let _e1034 = (_e1028.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1551_ = vec3<f32>(_e1032, _e1034, _e1030);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1550_ = vec3<f32>(_e1034, _e1030, _e1032);
                                    } else {
                                        phi_1550_ = (_e1028 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1042 = phi_1550_;
                                    phi_1551_ = _e1042;
                                }
                                let _e1044 = phi_1551_;
                                let _e1048 = (_e1044.x - (_e366 * _e1044.z));
                                let _e1052 = (_e1044.y - (_e369 * _e1044.z));
                                if (_e1022 < _e1048) {
                                    phi_1570_ = true;
                                } else {
                                    if (_e1022 == _e1048) {
                                        phi_1569_ = (_e1026 < _e1052);
                                    } else {
                                        phi_1569_ = false;
                                    }
                                    let _e1057 = phi_1569_;
                                    phi_1570_ = _e1057;
                                }
                                let _e1059 = phi_1570_;
                                if _e1059 {
                                    phi_1574_ = _e1052;
                                    phi_1575_ = _e1048;
                                    phi_1576_ = _e1026;
                                    phi_1577_ = _e1022;
                                } else {
                                    phi_1574_ = _e1026;
                                    phi_1575_ = _e1022;
                                    phi_1576_ = _e1052;
                                    phi_1577_ = _e1048;
                                }
                                let _e1061 = phi_1574_;
                                let _e1063 = phi_1575_;
                                let _e1065 = phi_1576_;
                                let _e1067 = phi_1577_;
                                let _e1070 = ((_e1067 * _e1061) - (_e1065 * _e1063));
                                if _e1059 {
                                    phi_1585_ = -(_e1070);
                                } else {
                                    phi_1585_ = _e1070;
                                }
                                let _e1073 = phi_1585_;
                                if (_e1048 < _e996) {
                                    phi_1596_ = true;
                                } else {
                                    if (_e1048 == _e996) {
                                        phi_1595_ = (_e1052 < _e1000);
                                    } else {
                                        phi_1595_ = false;
                                    }
                                    let _e1078 = phi_1595_;
                                    phi_1596_ = _e1078;
                                }
                                let _e1080 = phi_1596_;
                                if _e1080 {
                                    phi_1600_ = _e1000;
                                    phi_1601_ = _e996;
                                    phi_1602_ = _e1052;
                                    phi_1603_ = _e1048;
                                } else {
                                    phi_1600_ = _e1052;
                                    phi_1601_ = _e1048;
                                    phi_1602_ = _e1000;
                                    phi_1603_ = _e996;
                                }
                                let _e1082 = phi_1600_;
                                let _e1084 = phi_1601_;
                                let _e1086 = phi_1602_;
                                let _e1088 = phi_1603_;
                                let _e1091 = ((_e1088 * _e1082) - (_e1086 * _e1084));
                                if _e1080 {
                                    phi_1611_ = -(_e1091);
                                } else {
                                    phi_1611_ = _e1091;
                                }
                                let _e1094 = phi_1611_;
                                if (_e996 < _e1022) {
                                    phi_1622_ = true;
                                } else {
                                    if (_e996 == _e1022) {
                                        phi_1621_ = (_e1000 < _e1026);
                                    } else {
                                        phi_1621_ = false;
                                    }
                                    let _e1099 = phi_1621_;
                                    phi_1622_ = _e1099;
                                }
                                let _e1101 = phi_1622_;
                                if _e1101 {
                                    phi_1626_ = _e1026;
                                    phi_1627_ = _e1022;
                                    phi_1628_ = _e1000;
                                    phi_1629_ = _e996;
                                } else {
                                    phi_1626_ = _e1000;
                                    phi_1627_ = _e996;
                                    phi_1628_ = _e1026;
                                    phi_1629_ = _e1022;
                                }
                                let _e1103 = phi_1626_;
                                let _e1105 = phi_1627_;
                                let _e1107 = phi_1628_;
                                let _e1109 = phi_1629_;
                                let _e1112 = ((_e1109 * _e1103) - (_e1107 * _e1105));
                                if _e1101 {
                                    phi_1637_ = -(_e1112);
                                } else {
                                    phi_1637_ = _e1112;
                                }
                                let _e1115 = phi_1637_;
                                if (_e1073 >= 0f) {
                                    if (_e1094 >= 0f) {
                                        if (_e1115 >= 0f) {
                                            phi_1652_ = ((_e1073 + _e1094) + _e1115);
                                            phi_1653_ = false;
                                        } else {
                                            phi_1652_ = f32();
                                            phi_1653_ = true;
                                        }
                                        let _e1122 = phi_1652_;
                                        let _e1124 = phi_1653_;
                                        phi_1654_ = _e1122;
                                        phi_1655_ = _e1124;
                                    } else {
                                        phi_1654_ = f32();
                                        phi_1655_ = true;
                                    }
                                    let _e1126 = phi_1654_;
                                    let _e1128 = phi_1655_;
                                    phi_1656_ = _e1126;
                                    phi_1657_ = _e1128;
                                } else {
                                    phi_1656_ = f32();
                                    phi_1657_ = true;
                                }
                                let _e1130 = phi_1656_;
                                let _e1132 = phi_1657_;
                                if _e1132 {
                                    if (_e1073 <= 0f) {
                                        if (_e1094 <= 0f) {
                                            let _e1135 = (_e1115 <= 0f);
                                            if _e1135 {
                                            }
                                            phi_1675_ = ((_e1073 + _e1094) + _e1115);
                                            phi_1676_ = false;
                                            phi_1677_ = _e1135;
                                        } else {
                                            phi_1675_ = f32();
                                            phi_1676_ = true;
                                            phi_1677_ = false;
                                        }
                                        let _e1139 = phi_1675_;
                                        let _e1141 = phi_1676_;
                                        let _e1143 = phi_1677_;
                                        phi_1678_ = _e1139;
                                        phi_1679_ = _e1141;
                                        phi_1680_ = _e1143;
                                    } else {
                                        phi_1678_ = f32();
                                        phi_1679_ = true;
                                        phi_1680_ = false;
                                    }
                                    let _e1145 = phi_1678_;
                                    let _e1147 = phi_1679_;
                                    let _e1149 = phi_1680_;
                                    if _e1147 {
                                        phi_1684_ = false;
                                    } else {
                                        phi_1684_ = _e1149;
                                    }
                                    let _e1151 = phi_1684_;
                                    phi_1685_ = _e1145;
                                    phi_1686_ = _e1151;
                                } else {
                                    phi_1685_ = _e1130;
                                    phi_1686_ = true;
                                }
                                let _e1153 = phi_1685_;
                                let _e1155 = phi_1686_;
                                if _e1155 {
                                    let _e1156 = (_e1153 == 0f);
                                    if _e1156 {
                                        phi_2002_ = lt_bvh_triangle_Intersection();
                                        phi_2003_ = false;
                                    } else {
                                        let _e1158 = triangles.member[(0u + _e969)].v0_;
                                        let _e1160 = (_e1158.x - _e127);
                                        let _e1162 = (_e1158.y - _e129);
                                        let _e1164 = (_e1158.z - _e131);
                                        if (_e355 == 0u) {
                                            phi_1715_ = vec3<f32>(_e1162, _e1164, _e1160);
                                        } else {
                                            if (_e355 == 1u) {
                                                phi_1714_ = vec3<f32>(_e1164, _e1160, _e1162);
                                            } else {
                                                phi_1714_ = (_e1158 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e1172 = phi_1714_;
                                            phi_1715_ = _e1172;
                                        }
                                        let _e1174 = phi_1715_;
                                        let _e1176 = triangles.member[(0u + _e969)].v1_;
                                        let _e1178 = triangles.member[(0u + _e969)].v0_;
                                        let _e1181 = (_e1176.x - _e1178.x);
                                        let _e1184 = (_e1176.y - _e1178.y);
                                        let _e1187 = (_e1176.z - _e1178.z);
                                        if (_e355 == 0u) {
                                            phi_1741_ = vec3<f32>(_e1184, _e1187, _e1181);
                                        } else {
                                            if (_e355 == 1u) {
                                                phi_1740_ = vec3<f32>(_e1187, _e1181, _e1184);
                                            } else {
                                                phi_1740_ = (_e1176 - _e1178);
                                            }
                                            let _e1194 = phi_1740_;
                                            phi_1741_ = _e1194;
                                        }
                                        let _e1196 = phi_1741_;
                                        let _e1198 = triangles.member[(0u + _e969)].v2_;
                                        let _e1200 = triangles.member[(0u + _e969)].v0_;
                                        let _e1203 = (_e1198.x - _e1200.x);
                                        let _e1206 = (_e1198.y - _e1200.y);
                                        let _e1209 = (_e1198.z - _e1200.z);
                                        if (_e355 == 0u) {
                                            phi_1767_ = vec3<f32>(_e1206, _e1209, _e1203);
                                        } else {
                                            if (_e355 == 1u) {
                                                phi_1766_ = vec3<f32>(_e1209, _e1203, _e1206);
                                            } else {
                                                phi_1766_ = (_e1198 - _e1200);
                                            }
                                            let _e1216 = phi_1766_;
                                            phi_1767_ = _e1216;
                                        }
                                        let _e1218 = phi_1767_;
                                        let _e1225 = ((_e1196.y * _e1218.z) - (_e1196.z * _e1218.y));
                                        let _e1232 = ((_e1196.z * _e1218.x) - (_e1196.x * _e1218.z));
                                        let _e1239 = ((_e1196.x * _e1218.y) - (_e1196.y * _e1218.x));
                                        let _e1253 = (((1f / _e363.z) * (((_e1225 * _e1174.x) + (_e1232 * _e1174.y)) + (_e1239 * _e1174.z))) / (((_e1225 * _e366) + (_e1232 * _e369)) + _e1239));
                                        if (_e1253 > 0f) {
                                            if (_e1253 < _e135) {
                                                let _e1257 = triangles.member[(0u + _e969)].v0_;
                                                let _e1259 = triangles.member[(0u + _e969)].v1_;
                                                if (_e1257.x < _e1259.x) {
                                                    phi_1823_ = _e1257.x;
                                                } else {
                                                    phi_1823_ = _e1259.x;
                                                }
                                                let _e1266 = phi_1823_;
                                                if (_e1257.y < _e1259.y) {
                                                    phi_1832_ = _e1257.y;
                                                } else {
                                                    phi_1832_ = _e1259.y;
                                                }
                                                let _e1273 = phi_1832_;
                                                if (_e1257.z < _e1259.z) {
                                                    phi_1841_ = _e1257.z;
                                                } else {
                                                    phi_1841_ = _e1259.z;
                                                }
                                                let _e1280 = phi_1841_;
                                                let _e1282 = triangles.member[(0u + _e969)].v2_;
                                                if (_e1266 < _e1282.x) {
                                                    phi_1850_ = _e1266;
                                                } else {
                                                    phi_1850_ = _e1282.x;
                                                }
                                                let _e1287 = phi_1850_;
                                                if (_e1273 < _e1282.y) {
                                                    phi_1857_ = _e1273;
                                                } else {
                                                    phi_1857_ = _e1282.y;
                                                }
                                                let _e1292 = phi_1857_;
                                                if (_e1280 < _e1282.z) {
                                                    phi_1864_ = _e1280;
                                                } else {
                                                    phi_1864_ = _e1282.z;
                                                }
                                                let _e1297 = phi_1864_;
                                                let _e1299 = triangles.member[(0u + _e969)].v0_;
                                                let _e1301 = triangles.member[(0u + _e969)].v1_;
                                                if (_e1299.x > _e1301.x) {
                                                    phi_1877_ = _e1299.x;
                                                } else {
                                                    phi_1877_ = _e1301.x;
                                                }
                                                let _e1308 = phi_1877_;
                                                if (_e1299.y > _e1301.y) {
                                                    phi_1886_ = _e1299.y;
                                                } else {
                                                    phi_1886_ = _e1301.y;
                                                }
                                                let _e1315 = phi_1886_;
                                                if (_e1299.z > _e1301.z) {
                                                    phi_1895_ = _e1299.z;
                                                } else {
                                                    phi_1895_ = _e1301.z;
                                                }
                                                let _e1322 = phi_1895_;
                                                let _e1324 = triangles.member[(0u + _e969)].v2_;
                                                if (_e1308 > _e1324.x) {
                                                    phi_1904_ = _e1308;
                                                } else {
                                                    phi_1904_ = _e1324.x;
                                                }
                                                let _e1329 = phi_1904_;
                                                if (_e1315 > _e1324.y) {
                                                    phi_1911_ = _e1315;
                                                } else {
                                                    phi_1911_ = _e1324.y;
                                                }
                                                let _e1334 = phi_1911_;
                                                if (_e1322 > _e1324.z) {
                                                    phi_1918_ = _e1322;
                                                } else {
                                                    phi_1918_ = _e1324.z;
                                                }
                                                let _e1339 = phi_1918_;
                                                let _e1343 = ((_e1287 - _e127) * _e284);
                                                let _e1344 = ((_e1292 - _e129) * _e294);
                                                let _e1345 = ((_e1297 - _e131) * _e304);
                                                let _e1349 = ((_e1329 - _e127) * _e284);
                                                let _e1350 = ((_e1334 - _e129) * _e294);
                                                let _e1351 = ((_e1339 - _e131) * _e304);
                                                if (_e1343 < _e1349) {
                                                    phi_1935_ = _e1343;
                                                } else {
                                                    phi_1935_ = _e1349;
                                                }
                                                let _e1354 = phi_1935_;
                                                if (_e1344 < _e1350) {
                                                    phi_1940_ = _e1344;
                                                } else {
                                                    phi_1940_ = _e1350;
                                                }
                                                let _e1357 = phi_1940_;
                                                if (_e1345 < _e1351) {
                                                    phi_1945_ = _e1345;
                                                } else {
                                                    phi_1945_ = _e1351;
                                                }
                                                let _e1360 = phi_1945_;
                                                if (_e1343 > _e1349) {
                                                    phi_1953_ = _e1343;
                                                } else {
                                                    phi_1953_ = _e1349;
                                                }
                                                let _e1366 = phi_1953_;
                                                if (_e1344 > _e1350) {
                                                    phi_1958_ = _e1344;
                                                } else {
                                                    phi_1958_ = _e1350;
                                                }
                                                let _e1369 = phi_1958_;
                                                if (_e1345 > _e1351) {
                                                    phi_1963_ = _e1345;
                                                } else {
                                                    phi_1963_ = _e1351;
                                                }
                                                let _e1372 = phi_1963_;
                                                let _e1376 = core_intrinsics_maximum_number_nsz_f32_((_e1354 - _e339), (_e1357 - _e340));
                                                let _e1377 = core_intrinsics_maximum_number_nsz_f32_(_e1376, (_e1360 - _e341));
                                                let _e1378 = core_intrinsics_minimum_number_nsz_f32_((_e1366 + _e339), (_e1369 + _e340));
                                                let _e1379 = core_intrinsics_minimum_number_nsz_f32_(_e1378, (_e1372 + _e341));
                                                if (_e1377 > -300000000000000000000000000000000000000f) {
                                                    phi_1975_ = _e1377;
                                                } else {
                                                    phi_1975_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1382 = phi_1975_;
                                                if (_e1379 < 300000000000000000000000000000000000000f) {
                                                    phi_1980_ = _e1379;
                                                } else {
                                                    phi_1980_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1385 = phi_1980_;
                                                if (_e1253 < _e1382) {
                                                    phi_1985_ = _e1382;
                                                } else {
                                                    phi_1985_ = _e1253;
                                                }
                                                let _e1388 = phi_1985_;
                                                if (_e1388 > _e1385) {
                                                    phi_1990_ = _e1385;
                                                } else {
                                                    phi_1990_ = _e1388;
                                                }
                                                let _e1391 = phi_1990_;
                                                phi_1995_ = lt_bvh_triangle_Intersection(_e1391, (_e1094 / _e1153), (_e1115 / _e1153), (_e1382 <= _e1385));
                                                phi_1996_ = false;
                                            } else {
                                                phi_1995_ = lt_bvh_triangle_Intersection();
                                                phi_1996_ = true;
                                            }
                                            let _e1397 = phi_1995_;
                                            let _e1399 = phi_1996_;
                                            phi_1997_ = _e1397;
                                            phi_1998_ = _e1399;
                                        } else {
                                            phi_1997_ = lt_bvh_triangle_Intersection();
                                            phi_1998_ = true;
                                        }
                                        let _e1401 = phi_1997_;
                                        let _e1403 = phi_1998_;
                                        if _e1403 {
                                        }
                                        phi_2002_ = _e1401;
                                        phi_2003_ = _e1403;
                                    }
                                    let _e1405 = phi_2002_;
                                    let _e1407 = phi_2003_;
                                    phi_2004_ = _e1405;
                                    phi_2005_ = _e1156;
                                    phi_2006_ = _e1407;
                                } else {
                                    phi_2004_ = lt_bvh_triangle_Intersection();
                                    phi_2005_ = true;
                                    phi_2006_ = false;
                                }
                                let _e1409 = phi_2004_;
                                let _e1411 = phi_2005_;
                                let _e1413 = phi_2006_;
                                if _e1411 {
                                    phi_2010_ = true;
                                } else {
                                    phi_2010_ = _e1413;
                                }
                                let _e1415 = phi_2010_;
                                if _e1415 {
                                    phi_2014_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2014_ = _e1409;
                                }
                                let _e1417 = phi_2014_;
                                if _e1417.is_hit {
                                    if (_e1417.t > 0f) {
                                        if (_e1417.t < _e135) {
                                            let _e1424 = triangles.member[(0u + _e969)].i0_;
                                            if ((_e1424 & 2147483648u) == 0u) {
                                                phi_2233_ = true;
                                            } else {
                                                if (_e969 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1433 = triangles.member[(0u + _e969)].i0_;
                                                let _e1434 = (_e1433 & 2147483647u);
                                                let _e1436 = triangles.member[(0u + _e969)].i1_;
                                                let _e1438 = triangles.member[(0u + _e969)].i2_;
                                                if (_e1434 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1442 = vertices.member[(0u + _e1434)];
                                                if (_e1436 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1446 = vertices.member[(0u + _e1436)];
                                                if (_e1438 < _e87) {
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
                                                        phi_2231_ = true;
                                                    } else {
                                                        let _e1489 = (_e1457.base_color.w * ((((f32((_e1451[0].color >> bitcast<u32>(24i))) * _e1462) + (f32((_e1451[1].color >> bitcast<u32>(24i))) * _e1417.u)) + (f32((_e1451[2].color >> bitcast<u32>(24i))) * _e1417.v)) * (1f / 255f)));
                                                        if (_e1457.alpha_size == 0u) {
                                                            phi_2228_ = _e1489;
                                                        } else {
                                                            local.offset = _e1457.alpha_offset;
                                                            local.size = _e1457.alpha_size;
                                                            local.flags = _e1457.flags;
                                                            let _e1520 = _lt_shaders_texture_TextureView_quad((&local), (((_e1451[0].u * _e1462) + (_e1451[1].u * _e1417.u)) + (_e1451[2].u * _e1417.v)), (((_e1451[0].v * _e1462) + (_e1451[1].v * _e1417.u)) + (_e1451[2].v * _e1417.v)));
                                                            let _e1524 = (_e1520.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1524 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = alpha_texels.member[(0u + _e1524)];
                                                            let _e1544 = (_e1520.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1544 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1548 = alpha_texels.member[(0u + _e1544)];
                                                            let _e1565 = (_e1520.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1565 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1569 = alpha_texels.member[(0u + _e1565)];
                                                            let _e1586 = (_e1520.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1586 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1590 = alpha_texels.member[(0u + _e1586)];
                                                            phi_2228_ = (_e1489 * (((((f32(((_e1528 >> bitcast<u32>((((_e1520.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.x) + ((f32(((_e1548 >> bitcast<u32>((((_e1520.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.y)) + ((f32(((_e1569 >> bitcast<u32>((((_e1520.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.z)) + ((f32(((_e1590 >> bitcast<u32>((((_e1520.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.w)));
                                                        }
                                                        let _e1606 = phi_2228_;
                                                        phi_2231_ = (_e1606 >= _e1457.cutoff);
                                                    }
                                                    let _e1610 = phi_2231_;
                                                    phi_2232_ = _e1610;
                                                } else {
                                                    phi_2232_ = false;
                                                }
                                                let _e1612 = phi_2232_;
                                                phi_2233_ = _e1612;
                                            }
                                            let _e1614 = phi_2233_;
                                            if _e1614 {
                                                phi_2237_ = false;
                                            } else {
                                                phi_2237_ = true;
                                            }
                                            let _e1616 = phi_2237_;
                                            phi_2238_ = _e1614;
                                            phi_2239_ = _e1614;
                                            phi_2240_ = _e1616;
                                        } else {
                                            phi_2238_ = bool();
                                            phi_2239_ = _e960;
                                            phi_2240_ = true;
                                        }
                                        let _e1618 = phi_2238_;
                                        let _e1620 = phi_2239_;
                                        let _e1622 = phi_2240_;
                                        phi_2241_ = _e1618;
                                        phi_2242_ = _e1620;
                                        phi_2243_ = _e1622;
                                    } else {
                                        phi_2241_ = bool();
                                        phi_2242_ = _e960;
                                        phi_2243_ = true;
                                    }
                                    let _e1624 = phi_2241_;
                                    let _e1626 = phi_2242_;
                                    let _e1628 = phi_2243_;
                                    phi_2244_ = _e1624;
                                    phi_2245_ = _e1626;
                                    phi_2246_ = _e1628;
                                } else {
                                    phi_2244_ = bool();
                                    phi_2245_ = _e960;
                                    phi_2246_ = true;
                                }
                                let _e1630 = phi_2244_;
                                let _e1632 = phi_2245_;
                                let _e1634 = phi_2246_;
                                if _e1634 {
                                }
                                phi_1444_ = (_e958 & (_e958 - 1u));
                                phi_1447_ = _e1632;
                                phi_2250_ = _e1630;
                                phi_2251_ = _e1634;
                            }
                            let _e1636 = phi_1444_;
                            let _e1638 = phi_1447_;
                            let _e1640 = phi_2250_;
                            let _e1642 = phi_2251_;
                            local_8 = _e1640;
                            continue;
                            continuing {
                                phi_1443_ = _e1636;
                                phi_1446_ = _e1638;
                                break if !(_e1642);
                            }
                        }
                        let _e1645 = local_5;
                        if _e1645 {
                            let _e1647 = local_1.group_mask;
                            if ((_e1647 & 4278190080u) == 0u) {
                                let _e1651 = local_1.len;
                                if (_e1651 == 0u) {
                                    phi_2293_ = false;
                                } else {
                                    let _e1655 = local_1.len;
                                    local_1.len = (_e1655 - 1u);
                                    let _e1658 = local_1.len;
                                    if (_e1658 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1663 = local_1.first[(0u + _e1658)];
                                    local_1.group = _e1663;
                                    let _e1666 = local_1.len;
                                    if (_e1666 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1671 = local_1.mask[(0u + _e1666)];
                                    local_1.group_mask = _e1671;
                                    phi_2293_ = true;
                                }
                                let _e1674 = phi_2293_;
                                phi_2294_ = _e1674;
                            } else {
                                phi_2294_ = true;
                            }
                            let _e1676 = phi_2294_;
                            if _e1676 {
                                let _e1678 = local_1.group_mask;
                                let _e1684 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1678)), 32u, (_e1678 == 0u)));
                                let _e1688 = local_1.group_mask;
                                let _e1702 = local_1.group_mask;
                                local_1.group_mask = (_e1702 & ~((1u << bitcast<u32>((_e1684 & 31u)))));
                                let _e1705 = local_1.group;
                                phi_2325_ = (_e1705 + countOneBits(((_e1688 & ~((4294967295u << bitcast<u32>((((_e1684 - 24u) ^ _e382) & 31u))))) & 255u)));
                            } else {
                                phi_2325_ = 4294967295u;
                            }
                            let _e1708 = phi_2325_;
                            phi_2326_ = _e1708;
                        } else {
                            phi_2326_ = u32();
                        }
                        let _e1710 = phi_2326_;
                        phi_1112_ = _e1710;
                        let _e1918 = local_7;
                        phi_1115_ = _e1918;
                        let _e1921 = local_8;
                        phi_2327_ = _e1921;
                        let _e1924 = local_9;
                        phi_2328_ = _e1924;
                        phi_2329_ = false;
                    } else {
                        phi_1112_ = u32();
                        phi_1115_ = bool();
                        phi_2327_ = bool();
                        phi_2328_ = false;
                        phi_2329_ = true;
                    }
                    let _e1712 = phi_1112_;
                    let _e1714 = phi_1115_;
                    let _e1716 = phi_2327_;
                    let _e1718 = phi_2328_;
                    let _e1720 = phi_2329_;
                    local_6 = _e1720;
                    local_10 = _e1716;
                    continue;
                    continuing {
                        phi_1111_ = _e1712;
                        phi_1114_ = _e1714;
                        break if !(_e1718);
                    }
                }
                let _e1723 = local_6;
                if _e1723 {
                    phi_2333_ = false;
                } else {
                    phi_2333_ = true;
                }
                let _e1725 = phi_2333_;
                if _e1725 {
                    let _e1930 = local_10;
                    phi_2337_ = _e1930;
                } else {
                    let _e1932 = local_11;
                    phi_2337_ = _e1932;
                }
                let _e1727 = phi_2337_;
                phi_2338_ = _e1727;
            }
            let _e1729 = phi_2338_;
            phi_2339_ = _e1729;
            phi_2340_ = _e208;
        } else {
            phi_2339_ = bool();
            phi_2340_ = true;
        }
        let _e1731 = phi_2339_;
        let _e1733 = phi_2340_;
        if _e1733 {
            phi_2344_ = false;
        } else {
            phi_2344_ = _e1731;
        }
        let _e1735 = phi_2344_;
        if _e1735 {
            phi_2348_ = 0f;
        } else {
            phi_2348_ = 1f;
        }
        let _e1737 = phi_2348_;
        if (_e106 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e1737;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
