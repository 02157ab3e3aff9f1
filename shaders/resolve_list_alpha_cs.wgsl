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
var<storage> vertices: type_33;
@group(0) @binding(7) 
var<storage> materials: type_37;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_221_: f32;
    var phi_226_: f32;
    var phi_227_: bool;
    var phi_228_: f32;
    var phi_229_: bool;
    var phi_233_: f32;
    var phi_259_: f32;
    var phi_264_: f32;
    var phi_265_: bool;
    var phi_266_: f32;
    var phi_267_: bool;
    var phi_271_: f32;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_309_: u32;
    var phi_323_: u32;
    var phi_330_: u32;
    var phi_335_: u32;
    var phi_341_: u32;
    var phi_346_: u32;
    var phi_348_: texture_Axis;
    var phi_376_: f32;
    var phi_381_: f32;
    var phi_382_: bool;
    var phi_383_: f32;
    var phi_384_: bool;
    var phi_388_: f32;
    var phi_414_: f32;
    var phi_419_: f32;
    var phi_420_: bool;
    var phi_421_: f32;
    var phi_422_: bool;
    var phi_426_: f32;
    var phi_434_: f32;
    var phi_435_: f32;
    var phi_436_: f32;
    var phi_445_: f32;
    var phi_446_: f32;
    var phi_464_: u32;
    var phi_478_: u32;
    var phi_485_: u32;
    var phi_490_: u32;
    var phi_496_: u32;
    var phi_501_: u32;
    var phi_503_: texture_Axis;

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
                phi_221_ = 1f;
            } else {
                phi_221_ = 0f;
            }
            let _e100 = phi_221_;
            if (param_1 < 8388608f) {
                phi_226_ = (_e97 - _e100);
                phi_227_ = false;
            } else {
                phi_226_ = f32();
                phi_227_ = true;
            }
            let _e103 = phi_226_;
            let _e105 = phi_227_;
            phi_228_ = _e103;
            phi_229_ = _e105;
        } else {
            phi_228_ = f32();
            phi_229_ = true;
        }
        let _e107 = phi_228_;
        let _e109 = phi_229_;
        if _e109 {
            phi_233_ = param_1;
        } else {
            phi_233_ = _e107;
        }
        let _e111 = phi_233_;
        phi_281_ = (param_1 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_1 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_259_ = 1f;
                } else {
                    phi_259_ = 0f;
                }
                let _e129 = phi_259_;
                if (_e114 < 8388608f) {
                    phi_264_ = (_e126 - _e129);
                    phi_265_ = false;
                } else {
                    phi_264_ = f32();
                    phi_265_ = true;
                }
                let _e132 = phi_264_;
                let _e134 = phi_265_;
                phi_266_ = _e132;
                phi_267_ = _e134;
            } else {
                phi_266_ = f32();
                phi_267_ = true;
            }
            let _e136 = phi_266_;
            let _e138 = phi_267_;
            if _e138 {
                phi_271_ = _e114;
            } else {
                phi_271_ = _e136;
            }
            let _e140 = phi_271_;
            let _e142 = (param_1 - (2f * _e140));
            if (_e142 > 1f) {
                phi_279_ = (2f - _e142);
            } else {
                phi_279_ = _e142;
            }
            let _e146 = phi_279_;
            phi_280_ = _e146;
        } else {
            phi_280_ = param_1;
        }
        let _e148 = phi_280_;
        phi_281_ = _e148;
    }
    let _e150 = phi_281_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_290_ = _e150;
        } else {
            phi_290_ = 1f;
        }
        let _e154 = phi_290_;
        phi_291_ = _e154;
    } else {
        phi_291_ = 0f;
    }
    let _e156 = phi_291_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_309_ = _e157;
        } else {
            phi_309_ = _e166;
        }
        let _e169 = phi_309_;
        phi_348_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_323_ = _e71;
        } else {
            phi_323_ = _e178;
        }
        let _e181 = phi_323_;
        if (_e84 == 0u) {
            phi_330_ = _e157;
        } else {
            phi_330_ = 0u;
        }
        let _e186 = phi_330_;
        if (_e84 == 0u) {
            phi_335_ = 0u;
        } else {
            phi_335_ = _e157;
        }
        let _e189 = phi_335_;
        if (_e181 == 0u) {
            phi_341_ = _e186;
        } else {
            phi_341_ = (_e181 - 1u);
        }
        let _e193 = phi_341_;
        if (_e181 > _e157) {
            phi_346_ = _e189;
        } else {
            phi_346_ = _e181;
        }
        let _e196 = phi_346_;
        phi_348_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_348_;
    let _e201 = (*param).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_2 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e217 > param_2) {
                phi_376_ = 1f;
            } else {
                phi_376_ = 0f;
            }
            let _e220 = phi_376_;
            if (param_2 < 8388608f) {
                phi_381_ = (_e217 - _e220);
                phi_382_ = false;
            } else {
                phi_381_ = f32();
                phi_382_ = true;
            }
            let _e223 = phi_381_;
            let _e225 = phi_382_;
            phi_383_ = _e223;
            phi_384_ = _e225;
        } else {
            phi_383_ = f32();
            phi_384_ = true;
        }
        let _e227 = phi_383_;
        let _e229 = phi_384_;
        if _e229 {
            phi_388_ = param_2;
        } else {
            phi_388_ = _e227;
        }
        let _e231 = phi_388_;
        phi_436_ = (param_2 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_2 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_414_ = 1f;
                } else {
                    phi_414_ = 0f;
                }
                let _e249 = phi_414_;
                if (_e234 < 8388608f) {
                    phi_419_ = (_e246 - _e249);
                    phi_420_ = false;
                } else {
                    phi_419_ = f32();
                    phi_420_ = true;
                }
                let _e252 = phi_419_;
                let _e254 = phi_420_;
                phi_421_ = _e252;
                phi_422_ = _e254;
            } else {
                phi_421_ = f32();
                phi_422_ = true;
            }
            let _e256 = phi_421_;
            let _e258 = phi_422_;
            if _e258 {
                phi_426_ = _e234;
            } else {
                phi_426_ = _e256;
            }
            let _e260 = phi_426_;
            let _e262 = (param_2 - (2f * _e260));
            if (_e262 > 1f) {
                phi_434_ = (2f - _e262);
            } else {
                phi_434_ = _e262;
            }
            let _e266 = phi_434_;
            phi_435_ = _e266;
        } else {
            phi_435_ = param_2;
        }
        let _e268 = phi_435_;
        phi_436_ = _e268;
    }
    let _e270 = phi_436_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_445_ = _e270;
        } else {
            phi_445_ = 1f;
        }
        let _e274 = phi_445_;
        phi_446_ = _e274;
    } else {
        phi_446_ = 0f;
    }
    let _e276 = phi_446_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_464_ = _e277;
        } else {
            phi_464_ = _e286;
        }
        let _e289 = phi_464_;
        phi_503_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_478_ = _e75;
        } else {
            phi_478_ = _e298;
        }
        let _e301 = phi_478_;
        if (_e204 == 0u) {
            phi_485_ = _e277;
        } else {
            phi_485_ = 0u;
        }
        let _e306 = phi_485_;
        if (_e204 == 0u) {
            phi_490_ = 0u;
        } else {
            phi_490_ = _e277;
        }
        let _e309 = phi_490_;
        if (_e301 == 0u) {
            phi_496_ = _e306;
        } else {
            phi_496_ = (_e301 - 1u);
        }
        let _e313 = phi_496_;
        if (_e301 > _e277) {
            phi_501_ = _e309;
        } else {
            phi_501_ = _e301;
        }
        let _e316 = phi_501_;
        phi_503_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_503_;
    let _e323 = (*param).offset;
    let _e330 = (*param).offset;
    let _e337 = (*param).offset;
    let _e344 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_562_: bool;
    var phi_566_: f32;

    if (param_3 != param_3) {
        phi_562_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_562_ = _e69;
    }
    let _e71 = phi_562_;
    if _e71 {
        phi_566_ = param_4;
    } else {
        phi_566_ = param_3;
    }
    let _e73 = phi_566_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_578_: bool;
    var phi_582_: f32;

    if (param_5 != param_5) {
        phi_578_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_578_ = _e69;
    }
    let _e71 = phi_578_;
    if _e71 {
        phi_582_ = param_6;
    } else {
        phi_582_ = param_5;
    }
    let _e73 = phi_582_;
    return _e73;
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
    var phi_1192_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1219_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1246_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1252_: u32;
    var phi_1255_: u32;
    var phi_1269_: u32;
    var phi_1279_: u32;
    var phi_1289_: u32;
    var phi_1307_: u32;
    var phi_1317_: u32;
    var phi_1327_: u32;
    var phi_1363_: u32;
    var phi_1376_: u32;
    var phi_1381_: u32;
    var phi_1382_: u32;
    var phi_1383_: u32;
    var phi_1253_: u32;
    var phi_1256_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1441_: u32;
    var phi_1486_: vec3<f32>;
    var phi_1487_: vec3<f32>;
    var phi_1516_: vec3<f32>;
    var phi_1517_: vec3<f32>;
    var phi_1546_: vec3<f32>;
    var phi_1547_: vec3<f32>;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1570_: f32;
    var phi_1571_: f32;
    var phi_1572_: f32;
    var phi_1573_: f32;
    var phi_1581_: f32;
    var phi_1591_: bool;
    var phi_1592_: bool;
    var phi_1596_: f32;
    var phi_1597_: f32;
    var phi_1598_: f32;
    var phi_1599_: f32;
    var phi_1607_: f32;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1622_: f32;
    var phi_1623_: f32;
    var phi_1624_: f32;
    var phi_1625_: f32;
    var phi_1633_: f32;
    var phi_1648_: f32;
    var phi_1649_: bool;
    var phi_1650_: f32;
    var phi_1651_: bool;
    var phi_1652_: f32;
    var phi_1653_: bool;
    var phi_1671_: f32;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1674_: f32;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1680_: bool;
    var phi_1681_: f32;
    var phi_1682_: bool;
    var phi_1710_: vec3<f32>;
    var phi_1711_: vec3<f32>;
    var phi_1736_: vec3<f32>;
    var phi_1737_: vec3<f32>;
    var phi_1762_: vec3<f32>;
    var phi_1763_: vec3<f32>;
    var phi_1819_: f32;
    var phi_1828_: f32;
    var phi_1837_: f32;
    var phi_1846_: f32;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1873_: f32;
    var phi_1882_: f32;
    var phi_1891_: f32;
    var phi_1900_: f32;
    var phi_1907_: f32;
    var phi_1914_: f32;
    var phi_1931_: f32;
    var phi_1936_: f32;
    var phi_1941_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1959_: f32;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1981_: f32;
    var phi_1986_: f32;
    var phi_1991_: lt_bvh_triangle_Intersection;
    var phi_1992_: bool;
    var phi_1993_: lt_bvh_triangle_Intersection;
    var phi_1994_: bool;
    var phi_1998_: lt_bvh_triangle_Intersection;
    var phi_1999_: bool;
    var phi_2000_: lt_bvh_triangle_Intersection;
    var phi_2001_: bool;
    var phi_2002_: bool;
    var phi_2006_: bool;
    var phi_2010_: lt_bvh_triangle_Intersection;
    var phi_2224_: f32;
    var phi_2227_: bool;
    var phi_2228_: bool;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_1442_: u32;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var local_5: bool;
    var phi_2293_: bool;
    var phi_2294_: bool;
    var phi_2325_: u32;
    var phi_2326_: u32;
    var phi_2327_: bool;
    var phi_2328_: bool;
    var phi_1112_: u32;
    var phi_2329_: bool;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2332_: bool;
    var local_6: bool;
    var phi_2336_: bool;
    var phi_2337_: bool;
    var phi_2341_: bool;
    var phi_2345_: bool;
    var phi_2346_: bool;
    var phi_2347_: bool;
    var phi_2348_: bool;
    var phi_2352_: bool;
    var phi_2356_: f32;
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
                phi_2346_ = bool();
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
                loop {
                    let _e520 = phi_1111_;
                    if (_e520 != 4294967295u) {
                        if (_e520 < _e75) {
                        } else {
                            return;
                        }
                        let _e527 = nodes.member[(0u + _e520)].frame[3u];
                        let _e552 = (bitcast<f32>((((_e527 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e553 = (bitcast<f32>((((_e527 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e294);
                        let _e554 = (bitcast<f32>((((_e527 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e557 = nodes.member[(0u + _e520)].frame[0u];
                        let _e561 = nodes.member[(0u + _e520)].frame[1u];
                        let _e565 = nodes.member[(0u + _e520)].frame[2u];
                        let _e570 = ((bitcast<f32>(_e557) - _e127) * _e284);
                        let _e571 = ((bitcast<f32>(_e561) - _e129) * _e294);
                        let _e572 = ((bitcast<f32>(_e565) - _e131) * _e304);
                        let _e580 = nodes.member[(0u + _e520)].x;
                        if (_e284 < 0f) {
                            let _e591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e591.unnamed.root, _e580.w), _e591.unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e597.unnamed, lt_bvh_traverse_Tree(_e580.x, _e597.unnamed_1.first_primitive));
                            phi_1192_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e603.unnamed_1.root, _e580.y));
                        } else {
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e619.unnamed.root, _e580.y), _e619.unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e580.z, _e625.unnamed_1.first_primitive));
                            phi_1192_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_bvh_traverse_Tree(_e631.unnamed_1.root, _e580.w));
                        }
                        let _e639 = phi_1192_;
                        let _e649 = nodes.member[(0u + _e520)].y;
                        if (_e294 < 0f) {
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e660.unnamed.root, _e649.w), _e660.unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_bvh_traverse_Tree(_e649.x, _e666.unnamed_1.first_primitive));
                            phi_1219_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e672.unnamed_1.root, _e649.y));
                        } else {
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.unnamed.root, _e649.y), _e688.unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e649.z, _e694.unnamed_1.first_primitive));
                            phi_1219_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e700.unnamed_1.root, _e649.w));
                        }
                        let _e708 = phi_1219_;
                        let _e718 = nodes.member[(0u + _e520)].z;
                        if (_e304 < 0f) {
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e729.unnamed.root, _e718.w), _e729.unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e718.x, _e735.unnamed_1.first_primitive));
                            phi_1246_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e741.unnamed_1.root, _e718.y));
                        } else {
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.unnamed.root, _e718.y), _e757.unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e718.z, _e763.unnamed_1.first_primitive));
                            phi_1246_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e769.unnamed_1.root, _e718.w));
                        }
                        let _e777 = phi_1246_;
                        phi_1252_ = 0u;
                        phi_1255_ = 0u;
                        loop {
                            let _e787 = phi_1252_;
                            let _e789 = phi_1255_;
                            local_2 = _e789;
                            local_3 = _e789;
                            local_4 = _e789;
                            let _e790 = (_e787 < 8u);
                            if _e790 {
                                let _e792 = (_e787 >> bitcast<u32>(2i));
                                let _e793 = (_e787 & 3u);
                                if (_e792 == 0u) {
                                    phi_1269_ = _e639.unnamed.root;
                                } else {
                                    phi_1269_ = _e639.unnamed.first_primitive;
                                }
                                let _e796 = phi_1269_;
                                if (_e792 == 0u) {
                                    phi_1279_ = _e708.unnamed.root;
                                } else {
                                    phi_1279_ = _e708.unnamed.first_primitive;
                                }
                                let _e805 = phi_1279_;
                                if (_e792 == 0u) {
                                    phi_1289_ = _e777.unnamed.root;
                                } else {
                                    phi_1289_ = _e777.unnamed.first_primitive;
                                }
                                let _e814 = phi_1289_;
                                let _e827 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e796 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e552) + (_e570 - _e332)), ((f32(((_e805 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e553) + (_e571 - _e333)));
                                let _e828 = core_intrinsics_maximum_number_nsz_f32_(_e827, ((f32(((_e814 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e554) + (_e572 - _e334)));
                                if (_e792 == 0u) {
                                    phi_1307_ = _e639.unnamed_1.root;
                                } else {
                                    phi_1307_ = _e639.unnamed_1.first_primitive;
                                }
                                let _e831 = phi_1307_;
                                if (_e792 == 0u) {
                                    phi_1317_ = _e708.unnamed_1.root;
                                } else {
                                    phi_1317_ = _e708.unnamed_1.first_primitive;
                                }
                                let _e840 = phi_1317_;
                                if (_e792 == 0u) {
                                    phi_1327_ = _e777.unnamed_1.root;
                                } else {
                                    phi_1327_ = _e777.unnamed_1.first_primitive;
                                }
                                let _e849 = phi_1327_;
                                let _e862 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e831 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e552) + (_e570 + _e332)), ((f32(((_e840 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e553) + (_e571 + _e333)));
                                let _e863 = core_intrinsics_minimum_number_nsz_f32_(_e862, ((f32(((_e849 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e554) + (_e572 + _e334)));
                                if (_e828 <= _e863) {
                                    if (_e828 <= _e135) {
                                        if (_e863 >= 0f) {
                                            if (_e792 == 0u) {
                                                let _e870 = nodes.member[(0u + _e520)].links[2u];
                                                phi_1363_ = _e870;
                                            } else {
                                                let _e873 = nodes.member[(0u + _e520)].links[3u];
                                                phi_1363_ = _e873;
                                            }
                                            let _e875 = phi_1363_;
                                            let _e880 = ((_e875 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u);
                                            let _e881 = (_e880 & 31u);
                                            if (_e881 >= 24u) {
                                                phi_1376_ = (24u + ((_e881 - 24u) ^ _e382));
                                            } else {
                                                phi_1376_ = _e881;
                                            }
                                            let _e887 = phi_1376_;
                                            phi_1381_ = (_e789 | ((_e880 >> bitcast<u32>(5i)) << bitcast<u32>((_e887 & 31u))));
                                        } else {
                                            phi_1381_ = _e789;
                                        }
                                        let _e895 = phi_1381_;
                                        phi_1382_ = _e895;
                                    } else {
                                        phi_1382_ = _e789;
                                    }
                                    let _e897 = phi_1382_;
                                    phi_1383_ = _e897;
                                } else {
                                    phi_1383_ = _e789;
                                }
                                let _e899 = phi_1383_;
                                phi_1253_ = (_e787 + 1u);
                                phi_1256_ = _e899;
                            } else {
                                phi_1253_ = u32();
                                phi_1256_ = u32();
                            }
                            let _e902 = phi_1253_;
                            let _e904 = phi_1256_;
                            continue;
                            continuing {
                                phi_1252_ = _e902;
                                phi_1255_ = _e904;
                                break if !(_e790);
                            }
                        }
                        let _e908 = nodes.member[(0u + _e520)].links[0u];
                        let _e912 = nodes.member[(0u + _e520)].frame[3u];
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
                        phi_1441_ = (_e953 & 16777215u);
                        loop {
                            let _e956 = phi_1441_;
                            let _e957 = (_e956 == 0u);
                            local_5 = _e957;
                            local_9 = _e957;
                            if _e957 {
                                phi_1442_ = u32();
                                phi_2249_ = false;
                                phi_2250_ = false;
                                phi_2251_ = false;
                            } else {
                                let _e960 = nodes.member[(0u + _e520)].links[1u];
                                let _e965 = ((0u + _e960) + select(firstTrailingBit(_e956), 32u, (_e956 == 0u)));
                                if (_e965 < _e78) {
                                } else {
                                    return;
                                }
                                let _e972 = triangles.member[(0u + _e965)].v0_;
                                let _e974 = (_e972.x - _e127);
                                let _e976 = (_e972.y - _e129);
                                let _e978 = (_e972.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1487_ = vec3<f32>(_e976, _e978, _e974);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1486_ = vec3<f32>(_e978, _e974, _e976);
                                    } else {
                                        phi_1486_ = (_e972 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e986 = phi_1486_;
                                    phi_1487_ = _e986;
                                }
                                let _e988 = phi_1487_;
                                let _e992 = (_e988.x - (_e366 * _e988.z));
                                let _e996 = (_e988.y - (_e369 * _e988.z));
                                let _e998 = triangles.member[(0u + _e965)].v1_;
                                let _e1000 = (_e998.x - _e127);
                                let _e1002 = (_e998.y - _e129);
                                let _e1004 = (_e998.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1517_ = vec3<f32>(_e1002, _e1004, _e1000);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1516_ = vec3<f32>(_e1004, _e1000, _e1002);
                                    } else {
                                        phi_1516_ = (_e998 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1012 = phi_1516_;
                                    phi_1517_ = _e1012;
                                }
                                let _e1014 = phi_1517_;
                                let _e1018 = (_e1014.x - (_e366 * _e1014.z));
                                let _e1022 = (_e1014.y - (_e369 * _e1014.z));
                                let _e1024 = triangles.member[(0u + _e965)].v2_;
                                let _e1026 = (_e1024.x - _e127);
                                let _e1028 = (_e1024.y - _e129);
                                let _e1030 = (_e1024.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1547_ = vec3<f32>(_e1028, _e1030, _e1026);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1546_ = vec3<f32>(_e1030, _e1026, _e1028);
                                    } else {
                                        phi_1546_ = (_e1024 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1038 = phi_1546_;
                                    phi_1547_ = _e1038;
                                }
                                let _e1040 = phi_1547_;
                                let _e1044 = (_e1040.x - (_e366 * _e1040.z));
                                let _e1048 = (_e1040.y - (_e369 * _e1040.z));
                                if (_e1018 < _e1044) {
                                    phi_1566_ = true;
                                } else {
                                    if (_e1018 == _e1044) {
                                        phi_1565_ = (_e1022 < _e1048);
                                    } else {
                                        phi_1565_ = false;
                                    }
                                    let _e1053 = phi_1565_;
                                    phi_1566_ = _e1053;
                                }
                                let _e1055 = phi_1566_;
                                if _e1055 {
                                    phi_1570_ = _e1048;
                                    phi_1571_ = _e1044;
                                    phi_1572_ = _e1022;
                                    phi_1573_ = _e1018;
                                } else {
                                    phi_1570_ = _e1022;
                                    phi_1571_ = _e1018;
                                    phi_1572_ = _e1048;
                                    phi_1573_ = _e1044;
                                }
                                let _e1057 = phi_1570_;
                                let _e1059 = phi_1571_;
                                let _e1061 = phi_1572_;
                                let _e1063 = phi_1573_;
                                let _e1066 = ((_e1063 * _e1057) - (_e1061 * _e1059));
                                if _e1055 {
                                    phi_1581_ = -(_e1066);
                                } else {
                                    phi_1581_ = _e1066;
                                }
                                let _e1069 = phi_1581_;
                                if (_e1044 < _e992) {
                                    phi_1592_ = true;
                                } else {
                                    if (_e1044 == _e992) {
                                        phi_1591_ = (_e1048 < _e996);
                                    } else {
                                        phi_1591_ = false;
                                    }
                                    let _e1074 = phi_1591_;
                                    phi_1592_ = _e1074;
                                }
                                let _e1076 = phi_1592_;
                                if _e1076 {
                                    phi_1596_ = _e996;
                                    phi_1597_ = _e992;
                                    phi_1598_ = _e1048;
                                    phi_1599_ = _e1044;
                                } else {
                                    phi_1596_ = _e1048;
                                    phi_1597_ = _e1044;
                                    phi_1598_ = _e996;
                                    phi_1599_ = _e992;
                                }
                                let _e1078 = phi_1596_;
                                let _e1080 = phi_1597_;
                                let _e1082 = phi_1598_;
                                let _e1084 = phi_1599_;
                                let _e1087 = ((_e1084 * _e1078) - (_e1082 * _e1080));
                                if _e1076 {
                                    phi_1607_ = -(_e1087);
                                } else {
                                    phi_1607_ = _e1087;
                                }
                                let _e1090 = phi_1607_;
                                if (_e992 < _e1018) {
                                    phi_1618_ = true;
                                } else {
                                    if (_e992 == _e1018) {
                                        phi_1617_ = (_e996 < _e1022);
                                    } else {
                                        phi_1617_ = false;
                                    }
                                    let _e1095 = phi_1617_;
                                    phi_1618_ = _e1095;
                                }
                                let _e1097 = phi_1618_;
                                if _e1097 {
                                    phi_1622_ = _e1022;
                                    phi_1623_ = _e1018;
                                    phi_1624_ = _e996;
                                    phi_1625_ = _e992;
                                } else {
                                    phi_1622_ = _e996;
                                    phi_1623_ = _e992;
                                    phi_1624_ = _e1022;
                                    phi_1625_ = _e1018;
                                }
                                let _e1099 = phi_1622_;
                                let _e1101 = phi_1623_;
                                let _e1103 = phi_1624_;
                                let _e1105 = phi_1625_;
                                let _e1108 = ((_e1105 * _e1099) - (_e1103 * _e1101));
                                if _e1097 {
                                    phi_1633_ = -(_e1108);
                                } else {
                                    phi_1633_ = _e1108;
                                }
                                let _e1111 = phi_1633_;
                                if (_e1069 >= 0f) {
                                    if (_e1090 >= 0f) {
                                        if (_e1111 >= 0f) {
                                            phi_1648_ = ((_e1069 + _e1090) + _e1111);
                                            phi_1649_ = false;
                                        } else {
                                            phi_1648_ = f32();
                                            phi_1649_ = true;
                                        }
                                        let _e1118 = phi_1648_;
                                        let _e1120 = phi_1649_;
                                        phi_1650_ = _e1118;
                                        phi_1651_ = _e1120;
                                    } else {
                                        phi_1650_ = f32();
                                        phi_1651_ = true;
                                    }
                                    let _e1122 = phi_1650_;
                                    let _e1124 = phi_1651_;
                                    phi_1652_ = _e1122;
                                    phi_1653_ = _e1124;
                                } else {
                                    phi_1652_ = f32();
                                    phi_1653_ = true;
                                }
                                let _e1126 = phi_1652_;
                                let _e1128 = phi_1653_;
                                if _e1128 {
                                    if (_e1069 <= 0f) {
                                        if (_e1090 <= 0f) {
                                            let _e1131 = (_e1111 <= 0f);
                                            if _e1131 {
                                            }
                                            phi_1671_ = ((_e1069 + _e1090) + _e1111);
                                            phi_1672_ = false;
                                            phi_1673_ = _e1131;
                                        } else {
                                            phi_1671_ = f32();
                                            phi_1672_ = true;
                                            phi_1673_ = false;
                                        }
                                        let _e1135 = phi_1671_;
                                        let _e1137 = phi_1672_;
                                        let _e1139 = phi_1673_;
                                        phi_1674_ = _e1135;
                                        phi_1675_ = _e1137;
                                        phi_1676_ = _e1139;
                                    } else {
                                        phi_1674_ = f32();
                                        phi_1675_ = true;
                                        phi_1676_ = false;
                                    }
                                    let _e1141 = phi_1674_;
                                    let _e1143 = phi_1675_;
                                    let _e1145 = phi_1676_;
                                    if _e1143 {
                                        phi_1680_ = false;
                                    } else {
                                        phi_1680_ = _e1145;
                                    }
                                    let _e1147 = phi_1680_;
                                    phi_1681_ = _e1141;
                                    phi_1682_ = _e1147;
                                } else {
                                    phi_1681_ = _e1126;
                                    phi_1682_ = true;
                                }
                                let _e1149 = phi_1681_;
                                let _e1151 = phi_1682_;
                                if _e1151 {
                                    let _e1152 = (_e1149 == 0f);
                                    if _e1152 {
                                        phi_1998_ = lt_bvh_triangle_Intersection();
                                        phi_1999_ = false;
                                    } else {
                                        let _e1154 = triangles.member[(0u + _e965)].v0_;
                                        let _e1156 = (_e1154.x - _e127);
                                        let _e1158 = (_e1154.y - _e129);
                                        let _e1160 = (_e1154.z - _e131);
                                        if (_e355 == 0u) {
                                            phi_1711_ = vec3<f32>(_e1158, _e1160, _e1156);
                                        } else {
                                            if (_e355 == 1u) {
                                                phi_1710_ = vec3<f32>(_e1160, _e1156, _e1158);
                                            } else {
                                                phi_1710_ = (_e1154 - vec3<f32>(_e127, _e129, _e131));
                                            }
                                            let _e1168 = phi_1710_;
                                            phi_1711_ = _e1168;
                                        }
                                        let _e1170 = phi_1711_;
                                        let _e1172 = triangles.member[(0u + _e965)].v1_;
                                        let _e1174 = triangles.member[(0u + _e965)].v0_;
                                        let _e1177 = (_e1172.x - _e1174.x);
                                        let _e1180 = (_e1172.y - _e1174.y);
                                        let _e1183 = (_e1172.z - _e1174.z);
                                        if (_e355 == 0u) {
                                            phi_1737_ = vec3<f32>(_e1180, _e1183, _e1177);
                                        } else {
                                            if (_e355 == 1u) {
                                                phi_1736_ = vec3<f32>(_e1183, _e1177, _e1180);
                                            } else {
                                                phi_1736_ = (_e1172 - _e1174);
                                            }
                                            let _e1190 = phi_1736_;
                                            phi_1737_ = _e1190;
                                        }
                                        let _e1192 = phi_1737_;
                                        let _e1194 = triangles.member[(0u + _e965)].v2_;
                                        let _e1196 = triangles.member[(0u + _e965)].v0_;
                                        let _e1199 = (_e1194.x - _e1196.x);
                                        let _e1202 = (_e1194.y - _e1196.y);
                                        let _e1205 = (_e1194.z - _e1196.z);
                                        if (_e355 == 0u) {
                                            phi_1763_ = vec3<f32>(_e1202, _e1205, _e1199);
                                        } else {
                                            if (_e355 == 1u) {
                                                phi_1762_ = vec3<f32>(_e1205, _e1199, _e1202);
                                            } else {
                                                phi_1762_ = (_e1194 - _e1196);
                                            }
                                            let _e1212 = phi_1762_;
                                            phi_1763_ = _e1212;
                                        }
                                        let _e1214 = phi_1763_;
                                        let _e1221 = ((_e1192.y * _e1214.z) - (_e1192.z * _e1214.y));
                                        let _e1228 = ((_e1192.z * _e1214.x) - (_e1192.x * _e1214.z));
                                        let _e1235 = ((_e1192.x * _e1214.y) - (_e1192.y * _e1214.x));
                                        let _e1249 = (((1f / _e363.z) * (((_e1221 * _e1170.x) + (_e1228 * _e1170.y)) + (_e1235 * _e1170.z))) / (((_e1221 * _e366) + (_e1228 * _e369)) + _e1235));
                                        if (_e1249 > 0f) {
                                            if (_e1249 < _e135) {
                                                let _e1253 = triangles.member[(0u + _e965)].v0_;
                                                let _e1255 = triangles.member[(0u + _e965)].v1_;
                                                if (_e1253.x < _e1255.x) {
                                                    phi_1819_ = _e1253.x;
                                                } else {
                                                    phi_1819_ = _e1255.x;
                                                }
                                                let _e1262 = phi_1819_;
                                                if (_e1253.y < _e1255.y) {
                                                    phi_1828_ = _e1253.y;
                                                } else {
                                                    phi_1828_ = _e1255.y;
                                                }
                                                let _e1269 = phi_1828_;
                                                if (_e1253.z < _e1255.z) {
                                                    phi_1837_ = _e1253.z;
                                                } else {
                                                    phi_1837_ = _e1255.z;
                                                }
                                                let _e1276 = phi_1837_;
                                                let _e1278 = triangles.member[(0u + _e965)].v2_;
                                                if (_e1262 < _e1278.x) {
                                                    phi_1846_ = _e1262;
                                                } else {
                                                    phi_1846_ = _e1278.x;
                                                }
                                                let _e1283 = phi_1846_;
                                                if (_e1269 < _e1278.y) {
                                                    phi_1853_ = _e1269;
                                                } else {
                                                    phi_1853_ = _e1278.y;
                                                }
                                                let _e1288 = phi_1853_;
                                                if (_e1276 < _e1278.z) {
                                                    phi_1860_ = _e1276;
                                                } else {
                                                    phi_1860_ = _e1278.z;
                                                }
                                                let _e1293 = phi_1860_;
                                                let _e1295 = triangles.member[(0u + _e965)].v0_;
                                                let _e1297 = triangles.member[(0u + _e965)].v1_;
                                                if (_e1295.x > _e1297.x) {
                                                    phi_1873_ = _e1295.x;
                                                } else {
                                                    phi_1873_ = _e1297.x;
                                                }
                                                let _e1304 = phi_1873_;
                                                if (_e1295.y > _e1297.y) {
                                                    phi_1882_ = _e1295.y;
                                                } else {
                                                    phi_1882_ = _e1297.y;
                                                }
                                                let _e1311 = phi_1882_;
                                                if (_e1295.z > _e1297.z) {
                                                    phi_1891_ = _e1295.z;
                                                } else {
                                                    phi_1891_ = _e1297.z;
                                                }
                                                let _e1318 = phi_1891_;
                                                let _e1320 = triangles.member[(0u + _e965)].v2_;
                                                if (_e1304 > _e1320.x) {
                                                    phi_1900_ = _e1304;
                                                } else {
                                                    phi_1900_ = _e1320.x;
                                                }
                                                let _e1325 = phi_1900_;
                                                if (_e1311 > _e1320.y) {
                                                    phi_1907_ = _e1311;
                                                } else {
                                                    phi_1907_ = _e1320.y;
                                                }
                                                let _e1330 = phi_1907_;
                                                if (_e1318 > _e1320.z) {
                                                    phi_1914_ = _e1318;
                                                } else {
                                                    phi_1914_ = _e1320.z;
                                                }
                                                let _e1335 = phi_1914_;
                                                let _e1339 = ((_e1283 - _e127) * _e284);
                                                let _e1340 = ((_e1288 - _e129) * _e294);
                                                let _e1341 = ((_e1293 - _e131) * _e304);
                                                let _e1345 = ((_e1325 - _e127) * _e284);
                                                let _e1346 = ((_e1330 - _e129) * _e294);
                                                let _e1347 = ((_e1335 - _e131) * _e304);
                                                if (_e1339 < _e1345) {
                                                    phi_1931_ = _e1339;
                                                } else {
                                                    phi_1931_ = _e1345;
                                                }
                                                let _e1350 = phi_1931_;
                                                if (_e1340 < _e1346) {
                                                    phi_1936_ = _e1340;
                                                } else {
                                                    phi_1936_ = _e1346;
                                                }
                                                let _e1353 = phi_1936_;
                                                if (_e1341 < _e1347) {
                                                    phi_1941_ = _e1341;
                                                } else {
                                                    phi_1941_ = _e1347;
                                                }
                                                let _e1356 = phi_1941_;
                                                if (_e1339 > _e1345) {
                                                    phi_1949_ = _e1339;
                                                } else {
                                                    phi_1949_ = _e1345;
                                                }
                                                let _e1362 = phi_1949_;
                                                if (_e1340 > _e1346) {
                                                    phi_1954_ = _e1340;
                                                } else {
                                                    phi_1954_ = _e1346;
                                                }
                                                let _e1365 = phi_1954_;
                                                if (_e1341 > _e1347) {
                                                    phi_1959_ = _e1341;
                                                } else {
                                                    phi_1959_ = _e1347;
                                                }
                                                let _e1368 = phi_1959_;
                                                let _e1372 = core_intrinsics_maximum_number_nsz_f32_((_e1350 - _e339), (_e1353 - _e340));
                                                let _e1373 = core_intrinsics_maximum_number_nsz_f32_(_e1372, (_e1356 - _e341));
                                                let _e1374 = core_intrinsics_minimum_number_nsz_f32_((_e1362 + _e339), (_e1365 + _e340));
                                                let _e1375 = core_intrinsics_minimum_number_nsz_f32_(_e1374, (_e1368 + _e341));
                                                if (_e1373 > -300000000000000000000000000000000000000f) {
                                                    phi_1971_ = _e1373;
                                                } else {
                                                    phi_1971_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1378 = phi_1971_;
                                                if (_e1375 < 300000000000000000000000000000000000000f) {
                                                    phi_1976_ = _e1375;
                                                } else {
                                                    phi_1976_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1381 = phi_1976_;
                                                if (_e1249 < _e1378) {
                                                    phi_1981_ = _e1378;
                                                } else {
                                                    phi_1981_ = _e1249;
                                                }
                                                let _e1384 = phi_1981_;
                                                if (_e1384 > _e1381) {
                                                    phi_1986_ = _e1381;
                                                } else {
                                                    phi_1986_ = _e1384;
                                                }
                                                let _e1387 = phi_1986_;
                                                phi_1991_ = lt_bvh_triangle_Intersection(_e1387, (_e1090 / _e1149), (_e1111 / _e1149), (_e1378 <= _e1381));
                                                phi_1992_ = false;
                                            } else {
                                                phi_1991_ = lt_bvh_triangle_Intersection();
                                                phi_1992_ = true;
                                            }
                                            let _e1393 = phi_1991_;
                                            let _e1395 = phi_1992_;
                                            phi_1993_ = _e1393;
                                            phi_1994_ = _e1395;
                                        } else {
                                            phi_1993_ = lt_bvh_triangle_Intersection();
                                            phi_1994_ = true;
                                        }
                                        let _e1397 = phi_1993_;
                                        let _e1399 = phi_1994_;
                                        if _e1399 {
                                        }
                                        phi_1998_ = _e1397;
                                        phi_1999_ = _e1399;
                                    }
                                    let _e1401 = phi_1998_;
                                    let _e1403 = phi_1999_;
                                    phi_2000_ = _e1401;
                                    phi_2001_ = _e1152;
                                    phi_2002_ = _e1403;
                                } else {
                                    phi_2000_ = lt_bvh_triangle_Intersection();
                                    phi_2001_ = true;
                                    phi_2002_ = false;
                                }
                                let _e1405 = phi_2000_;
                                let _e1407 = phi_2001_;
                                let _e1409 = phi_2002_;
                                if _e1407 {
                                    phi_2006_ = true;
                                } else {
                                    phi_2006_ = _e1409;
                                }
                                let _e1411 = phi_2006_;
                                if _e1411 {
                                    phi_2010_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2010_ = _e1405;
                                }
                                let _e1413 = phi_2010_;
                                if _e1413.is_hit {
                                    if (_e1413.t > 0f) {
                                        if (_e1413.t < _e135) {
                                            let _e1420 = triangles.member[(0u + _e965)].i0_;
                                            let _e1422 = ((_e1420 & 2147483648u) == 0u);
                                            if _e1422 {
                                                phi_2233_ = false;
                                                phi_2234_ = false;
                                            } else {
                                                if (_e965 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1429 = triangles.member[(0u + _e965)].i0_;
                                                let _e1430 = (_e1429 & 2147483647u);
                                                let _e1432 = triangles.member[(0u + _e965)].i1_;
                                                let _e1434 = triangles.member[(0u + _e965)].i2_;
                                                if (_e1430 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1438 = vertices.member[(0u + _e1430)];
                                                if (_e1432 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1442 = vertices.member[(0u + _e1432)];
                                                if (_e1434 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1446 = vertices.member[(0u + _e1434)];
                                                let _e1447 = array<abi_Vertex, 3>(_e1438, _e1442, _e1446);
                                                if (_e1447[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1453 = materials.member[(0u + _e1447[0].material)];
                                                if ((_e1453.flags & 1u) == 1u) {
                                                    let _e1458 = ((1f - _e1413.u) - _e1413.v);
                                                    if (_e1453.cutoff <= 0f) {
                                                        phi_2227_ = true;
                                                    } else {
                                                        let _e1485 = (_e1453.base_color.w * ((((f32((_e1447[0].color >> bitcast<u32>(24i))) * _e1458) + (f32((_e1447[1].color >> bitcast<u32>(24i))) * _e1413.u)) + (f32((_e1447[2].color >> bitcast<u32>(24i))) * _e1413.v)) * (1f / 255f)));
                                                        if (_e1453.alpha_size == 0u) {
                                                            phi_2224_ = _e1485;
                                                        } else {
                                                            local.offset = _e1453.alpha_offset;
                                                            local.size = _e1453.alpha_size;
                                                            local.flags = _e1453.flags;
                                                            let _e1516 = _lt_shaders_texture_TextureView_quad((&local), (((_e1447[0].u * _e1458) + (_e1447[1].u * _e1413.u)) + (_e1447[2].u * _e1413.v)), (((_e1447[0].v * _e1458) + (_e1447[1].v * _e1413.u)) + (_e1447[2].v * _e1413.v)));
                                                            let _e1520 = (_e1516.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1520 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1524 = alpha_texels.member[(0u + _e1520)];
                                                            let _e1540 = (_e1516.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1540 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1544 = alpha_texels.member[(0u + _e1540)];
                                                            let _e1561 = (_e1516.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1561 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1565 = alpha_texels.member[(0u + _e1561)];
                                                            let _e1582 = (_e1516.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1582 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1586 = alpha_texels.member[(0u + _e1582)];
                                                            phi_2224_ = (_e1485 * (((((f32(((_e1524 >> bitcast<u32>((((_e1516.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1516.weights.x) + ((f32(((_e1544 >> bitcast<u32>((((_e1516.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1516.weights.y)) + ((f32(((_e1565 >> bitcast<u32>((((_e1516.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1516.weights.z)) + ((f32(((_e1586 >> bitcast<u32>((((_e1516.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1516.weights.w)));
                                                        }
                                                        let _e1602 = phi_2224_;
                                                        phi_2227_ = (_e1602 >= _e1453.cutoff);
                                                    }
                                                    let _e1606 = phi_2227_;
                                                    phi_2228_ = _e1606;
                                                } else {
                                                    phi_2228_ = false;
                                                }
                                                let _e1608 = phi_2228_;
                                                if _e1608 {
                                                    phi_2232_ = false;
                                                } else {
                                                    phi_2232_ = true;
                                                }
                                                let _e1610 = phi_2232_;
                                                phi_2233_ = _e1610;
                                                phi_2234_ = _e1608;
                                            }
                                            let _e1612 = phi_2233_;
                                            let _e1614 = phi_2234_;
                                            phi_2235_ = _e1612;
                                            phi_2236_ = _e1422;
                                            phi_2237_ = _e1614;
                                        } else {
                                            phi_2235_ = true;
                                            phi_2236_ = false;
                                            phi_2237_ = false;
                                        }
                                        let _e1616 = phi_2235_;
                                        let _e1618 = phi_2236_;
                                        let _e1620 = phi_2237_;
                                        phi_2238_ = _e1616;
                                        phi_2239_ = _e1618;
                                        phi_2240_ = _e1620;
                                    } else {
                                        phi_2238_ = true;
                                        phi_2239_ = false;
                                        phi_2240_ = false;
                                    }
                                    let _e1622 = phi_2238_;
                                    let _e1624 = phi_2239_;
                                    let _e1626 = phi_2240_;
                                    phi_2241_ = _e1622;
                                    phi_2242_ = _e1624;
                                    phi_2243_ = _e1626;
                                } else {
                                    phi_2241_ = true;
                                    phi_2242_ = false;
                                    phi_2243_ = false;
                                }
                                let _e1628 = phi_2241_;
                                let _e1630 = phi_2242_;
                                let _e1632 = phi_2243_;
                                if _e1628 {
                                    phi_2247_ = false;
                                    phi_2248_ = false;
                                } else {
                                    phi_2247_ = _e1630;
                                    phi_2248_ = _e1632;
                                }
                                let _e1634 = phi_2247_;
                                let _e1636 = phi_2248_;
                                phi_1442_ = (_e956 & (_e956 - 1u));
                                phi_2249_ = _e1628;
                                phi_2250_ = _e1634;
                                phi_2251_ = _e1636;
                            }
                            let _e1638 = phi_1442_;
                            let _e1640 = phi_2249_;
                            let _e1642 = phi_2250_;
                            let _e1644 = phi_2251_;
                            local_7 = _e1642;
                            local_8 = _e1644;
                            continue;
                            continuing {
                                phi_1441_ = _e1638;
                                break if !(_e1640);
                            }
                        }
                        let _e1647 = local_5;
                        if _e1647 {
                            let _e1649 = local_1.group_mask;
                            if ((_e1649 & 4278190080u) == 0u) {
                                let _e1653 = local_1.len;
                                if (_e1653 == 0u) {
                                    phi_2293_ = false;
                                } else {
                                    let _e1657 = local_1.len;
                                    local_1.len = (_e1657 - 1u);
                                    let _e1660 = local_1.len;
                                    if (_e1660 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1665 = local_1.first[(0u + _e1660)];
                                    local_1.group = _e1665;
                                    let _e1668 = local_1.len;
                                    if (_e1668 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1673 = local_1.mask[(0u + _e1668)];
                                    local_1.group_mask = _e1673;
                                    phi_2293_ = true;
                                }
                                let _e1676 = phi_2293_;
                                phi_2294_ = _e1676;
                            } else {
                                phi_2294_ = true;
                            }
                            let _e1678 = phi_2294_;
                            if _e1678 {
                                let _e1680 = local_1.group_mask;
                                let _e1686 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1680)), 32u, (_e1680 == 0u)));
                                let _e1690 = local_1.group_mask;
                                let _e1704 = local_1.group_mask;
                                local_1.group_mask = (_e1704 & ~((1u << bitcast<u32>((_e1686 & 31u)))));
                                let _e1707 = local_1.group;
                                phi_2325_ = (_e1707 + countOneBits(((_e1690 & ~((4294967295u << bitcast<u32>((((_e1686 - 24u) ^ _e382) & 31u))))) & 255u)));
                            } else {
                                phi_2325_ = 4294967295u;
                            }
                            let _e1710 = phi_2325_;
                            phi_2326_ = _e1710;
                            phi_2327_ = false;
                            phi_2328_ = false;
                        } else {
                            phi_2326_ = u32();
                            let _e1928 = local_7;
                            phi_2327_ = _e1928;
                            let _e1931 = local_8;
                            phi_2328_ = _e1931;
                        }
                        let _e1712 = phi_2326_;
                        let _e1714 = phi_2327_;
                        let _e1716 = phi_2328_;
                        phi_1112_ = _e1712;
                        let _e1935 = local_9;
                        phi_2329_ = _e1935;
                        phi_2330_ = false;
                        phi_2331_ = _e1714;
                        phi_2332_ = _e1716;
                    } else {
                        phi_1112_ = u32();
                        phi_2329_ = false;
                        phi_2330_ = true;
                        phi_2331_ = false;
                        phi_2332_ = false;
                    }
                    let _e1718 = phi_1112_;
                    let _e1720 = phi_2329_;
                    let _e1722 = phi_2330_;
                    let _e1724 = phi_2331_;
                    let _e1726 = phi_2332_;
                    local_6 = _e1722;
                    local_10 = _e1724;
                    local_11 = _e1726;
                    continue;
                    continuing {
                        phi_1111_ = _e1718;
                        break if !(_e1720);
                    }
                }
                let _e1729 = local_6;
                if _e1729 {
                    phi_2336_ = false;
                    phi_2337_ = false;
                } else {
                    let _e1942 = local_10;
                    phi_2336_ = _e1942;
                    let _e1945 = local_11;
                    phi_2337_ = _e1945;
                }
                let _e1731 = phi_2336_;
                let _e1733 = phi_2337_;
                if _e1731 {
                    phi_2341_ = true;
                } else {
                    phi_2341_ = _e1733;
                }
                let _e1735 = phi_2341_;
                if _e1735 {
                    phi_2345_ = true;
                } else {
                    phi_2345_ = false;
                }
                let _e1737 = phi_2345_;
                phi_2346_ = _e1737;
            }
            let _e1739 = phi_2346_;
            phi_2347_ = _e1739;
            phi_2348_ = _e208;
        } else {
            phi_2347_ = bool();
            phi_2348_ = true;
        }
        let _e1741 = phi_2347_;
        let _e1743 = phi_2348_;
        if _e1743 {
            phi_2352_ = false;
        } else {
            phi_2352_ = _e1741;
        }
        let _e1745 = phi_2352_;
        if _e1745 {
            phi_2356_ = 0f;
        } else {
            phi_2356_ = 1f;
        }
        let _e1747 = phi_2356_;
        if (_e106 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e1747;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
