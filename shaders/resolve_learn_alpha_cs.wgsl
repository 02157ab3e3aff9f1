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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_44;
@group(0) @binding(8) 
var<storage> materials: type_48;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_196_: bool;
    var phi_200_: f32;

    if (param != param) {
        phi_196_ = true;
    } else {
        let _e70 = (param_1 >= param);
        if _e70 {
        }
        phi_196_ = _e70;
    }
    let _e72 = phi_196_;
    if _e72 {
        phi_200_ = param_1;
    } else {
        phi_200_ = param;
    }
    let _e74 = phi_200_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_212_: bool;
    var phi_216_: f32;

    if (param_2 != param_2) {
        phi_212_ = true;
    } else {
        let _e70 = (param_3 <= param_2);
        if _e70 {
        }
        phi_212_ = _e70;
    }
    let _e72 = phi_212_;
    if _e72 {
        phi_216_ = param_3;
    } else {
        phi_216_ = param_2;
    }
    let _e74 = phi_216_;
    return _e74;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_258_: f32;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_270_: f32;
    var phi_296_: f32;
    var phi_301_: f32;
    var phi_302_: bool;
    var phi_303_: f32;
    var phi_304_: bool;
    var phi_308_: f32;
    var phi_316_: f32;
    var phi_317_: f32;
    var phi_318_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_346_: u32;
    var phi_360_: u32;
    var phi_367_: u32;
    var phi_372_: u32;
    var phi_378_: u32;
    var phi_383_: u32;
    var phi_385_: texture_Axis;
    var phi_413_: f32;
    var phi_418_: f32;
    var phi_419_: bool;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_425_: f32;
    var phi_451_: f32;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_458_: f32;
    var phi_459_: bool;
    var phi_463_: f32;
    var phi_471_: f32;
    var phi_472_: f32;
    var phi_473_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_501_: u32;
    var phi_515_: u32;
    var phi_522_: u32;
    var phi_527_: u32;
    var phi_533_: u32;
    var phi_538_: u32;
    var phi_540_: texture_Axis;

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
                phi_258_ = 1f;
            } else {
                phi_258_ = 0f;
            }
            let _e101 = phi_258_;
            if (param_5 < 8388608f) {
                phi_263_ = (_e98 - _e101);
                phi_264_ = false;
            } else {
                phi_263_ = f32();
                phi_264_ = true;
            }
            let _e104 = phi_263_;
            let _e106 = phi_264_;
            phi_265_ = _e104;
            phi_266_ = _e106;
        } else {
            phi_265_ = f32();
            phi_266_ = true;
        }
        let _e108 = phi_265_;
        let _e110 = phi_266_;
        if _e110 {
            phi_270_ = param_5;
        } else {
            phi_270_ = _e108;
        }
        let _e112 = phi_270_;
        phi_318_ = (param_5 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_5 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_296_ = 1f;
                } else {
                    phi_296_ = 0f;
                }
                let _e130 = phi_296_;
                if (_e115 < 8388608f) {
                    phi_301_ = (_e127 - _e130);
                    phi_302_ = false;
                } else {
                    phi_301_ = f32();
                    phi_302_ = true;
                }
                let _e133 = phi_301_;
                let _e135 = phi_302_;
                phi_303_ = _e133;
                phi_304_ = _e135;
            } else {
                phi_303_ = f32();
                phi_304_ = true;
            }
            let _e137 = phi_303_;
            let _e139 = phi_304_;
            if _e139 {
                phi_308_ = _e115;
            } else {
                phi_308_ = _e137;
            }
            let _e141 = phi_308_;
            let _e143 = (param_5 - (2f * _e141));
            if (_e143 > 1f) {
                phi_316_ = (2f - _e143);
            } else {
                phi_316_ = _e143;
            }
            let _e147 = phi_316_;
            phi_317_ = _e147;
        } else {
            phi_317_ = param_5;
        }
        let _e149 = phi_317_;
        phi_318_ = _e149;
    }
    let _e151 = phi_318_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_327_ = _e151;
        } else {
            phi_327_ = 1f;
        }
        let _e155 = phi_327_;
        phi_328_ = _e155;
    } else {
        phi_328_ = 0f;
    }
    let _e157 = phi_328_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_346_ = _e158;
        } else {
            phi_346_ = _e167;
        }
        let _e170 = phi_346_;
        phi_385_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_360_ = _e72;
        } else {
            phi_360_ = _e179;
        }
        let _e182 = phi_360_;
        if (_e85 == 0u) {
            phi_367_ = _e158;
        } else {
            phi_367_ = 0u;
        }
        let _e187 = phi_367_;
        if (_e85 == 0u) {
            phi_372_ = 0u;
        } else {
            phi_372_ = _e158;
        }
        let _e190 = phi_372_;
        if (_e182 == 0u) {
            phi_378_ = _e187;
        } else {
            phi_378_ = (_e182 - 1u);
        }
        let _e194 = phi_378_;
        if (_e182 > _e158) {
            phi_383_ = _e190;
        } else {
            phi_383_ = _e182;
        }
        let _e197 = phi_383_;
        phi_385_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_385_;
    let _e202 = (*param_4).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_6 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e218 > param_6) {
                phi_413_ = 1f;
            } else {
                phi_413_ = 0f;
            }
            let _e221 = phi_413_;
            if (param_6 < 8388608f) {
                phi_418_ = (_e218 - _e221);
                phi_419_ = false;
            } else {
                phi_418_ = f32();
                phi_419_ = true;
            }
            let _e224 = phi_418_;
            let _e226 = phi_419_;
            phi_420_ = _e224;
            phi_421_ = _e226;
        } else {
            phi_420_ = f32();
            phi_421_ = true;
        }
        let _e228 = phi_420_;
        let _e230 = phi_421_;
        if _e230 {
            phi_425_ = param_6;
        } else {
            phi_425_ = _e228;
        }
        let _e232 = phi_425_;
        phi_473_ = (param_6 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_6 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_451_ = 1f;
                } else {
                    phi_451_ = 0f;
                }
                let _e250 = phi_451_;
                if (_e235 < 8388608f) {
                    phi_456_ = (_e247 - _e250);
                    phi_457_ = false;
                } else {
                    phi_456_ = f32();
                    phi_457_ = true;
                }
                let _e253 = phi_456_;
                let _e255 = phi_457_;
                phi_458_ = _e253;
                phi_459_ = _e255;
            } else {
                phi_458_ = f32();
                phi_459_ = true;
            }
            let _e257 = phi_458_;
            let _e259 = phi_459_;
            if _e259 {
                phi_463_ = _e235;
            } else {
                phi_463_ = _e257;
            }
            let _e261 = phi_463_;
            let _e263 = (param_6 - (2f * _e261));
            if (_e263 > 1f) {
                phi_471_ = (2f - _e263);
            } else {
                phi_471_ = _e263;
            }
            let _e267 = phi_471_;
            phi_472_ = _e267;
        } else {
            phi_472_ = param_6;
        }
        let _e269 = phi_472_;
        phi_473_ = _e269;
    }
    let _e271 = phi_473_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_482_ = _e271;
        } else {
            phi_482_ = 1f;
        }
        let _e275 = phi_482_;
        phi_483_ = _e275;
    } else {
        phi_483_ = 0f;
    }
    let _e277 = phi_483_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_501_ = _e278;
        } else {
            phi_501_ = _e287;
        }
        let _e290 = phi_501_;
        phi_540_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_515_ = _e76;
        } else {
            phi_515_ = _e299;
        }
        let _e302 = phi_515_;
        if (_e205 == 0u) {
            phi_522_ = _e278;
        } else {
            phi_522_ = 0u;
        }
        let _e307 = phi_522_;
        if (_e205 == 0u) {
            phi_527_ = 0u;
        } else {
            phi_527_ = _e278;
        }
        let _e310 = phi_527_;
        if (_e302 == 0u) {
            phi_533_ = _e307;
        } else {
            phi_533_ = (_e302 - 1u);
        }
        let _e314 = phi_533_;
        if (_e302 > _e278) {
            phi_538_ = _e310;
        } else {
            phi_538_ = _e302;
        }
        let _e317 = phi_538_;
        phi_540_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_540_;
    let _e324 = (*param_4).offset;
    let _e331 = (*param_4).offset;
    let _e338 = (*param_4).offset;
    let _e345 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_680_: f32;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
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
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_762_: bool;
    var phi_766_: bool;
    var phi_836_: f32;
    var phi_843_: f32;
    var phi_850_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_871_: f32;
    var phi_888_: f32;
    var phi_893_: f32;
    var phi_898_: f32;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_935_: u32;
    var phi_936_: u32;
    var phi_947_: vec3<f32>;
    var phi_948_: vec3<f32>;
    var phi_961_: u32;
    var phi_966_: u32;
    var phi_971_: u32;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1117_: u32;
    var phi_1119_: u32;
    var phi_1122_: bool;
    var phi_1202_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1229_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1256_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1262_: u32;
    var phi_1265_: u32;
    var phi_1279_: u32;
    var phi_1289_: u32;
    var phi_1299_: u32;
    var phi_1317_: u32;
    var phi_1327_: u32;
    var phi_1337_: u32;
    var phi_1373_: u32;
    var phi_1386_: u32;
    var phi_1391_: u32;
    var phi_1392_: u32;
    var phi_1393_: u32;
    var phi_1263_: u32;
    var phi_1266_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1451_: u32;
    var phi_1454_: bool;
    var phi_1498_: vec3<f32>;
    var phi_1499_: vec3<f32>;
    var phi_1528_: vec3<f32>;
    var phi_1529_: vec3<f32>;
    var phi_1558_: vec3<f32>;
    var phi_1559_: vec3<f32>;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1582_: f32;
    var phi_1583_: f32;
    var phi_1584_: f32;
    var phi_1585_: f32;
    var phi_1593_: f32;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1608_: f32;
    var phi_1609_: f32;
    var phi_1610_: f32;
    var phi_1611_: f32;
    var phi_1619_: f32;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1634_: f32;
    var phi_1635_: f32;
    var phi_1636_: f32;
    var phi_1637_: f32;
    var phi_1645_: f32;
    var phi_1660_: f32;
    var phi_1661_: bool;
    var phi_1662_: f32;
    var phi_1663_: bool;
    var phi_1664_: f32;
    var phi_1665_: bool;
    var phi_1683_: f32;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1686_: f32;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1692_: bool;
    var phi_1693_: f32;
    var phi_1694_: bool;
    var phi_1722_: vec3<f32>;
    var phi_1723_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1749_: vec3<f32>;
    var phi_1774_: vec3<f32>;
    var phi_1775_: vec3<f32>;
    var phi_1831_: f32;
    var phi_1840_: f32;
    var phi_1849_: f32;
    var phi_1858_: f32;
    var phi_1865_: f32;
    var phi_1872_: f32;
    var phi_1885_: f32;
    var phi_1894_: f32;
    var phi_1903_: f32;
    var phi_1912_: f32;
    var phi_1919_: f32;
    var phi_1926_: f32;
    var phi_1943_: f32;
    var phi_1948_: f32;
    var phi_1953_: f32;
    var phi_1961_: f32;
    var phi_1966_: f32;
    var phi_1971_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_1998_: f32;
    var phi_2003_: lt_bvh_triangle_Intersection;
    var phi_2004_: bool;
    var phi_2005_: lt_bvh_triangle_Intersection;
    var phi_2006_: bool;
    var phi_2010_: lt_bvh_triangle_Intersection;
    var phi_2011_: bool;
    var phi_2012_: lt_bvh_triangle_Intersection;
    var phi_2013_: bool;
    var phi_2014_: bool;
    var phi_2018_: bool;
    var phi_2022_: lt_bvh_triangle_Intersection;
    var phi_2236_: f32;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_1452_: u32;
    var phi_1455_: bool;
    var phi_2258_: bool;
    var phi_2259_: bool;
    var local_5: bool;
    var phi_2301_: bool;
    var phi_2302_: bool;
    var phi_2333_: u32;
    var phi_2334_: u32;
    var phi_1120_: u32;
    var phi_1123_: bool;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var phi_2337_: bool;
    var local_6: bool;
    var phi_2341_: bool;
    var phi_2345_: bool;
    var phi_2346_: bool;
    var phi_2347_: bool;
    var phi_2348_: bool;
    var phi_2352_: bool;
    var phi_2356_: f32;
    var phi_2377_: u32;
    var phi_2392_: u32;
    var phi_2397_: u32;
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
        let _e116 = samples.member[(0u + _e110)].position;
        let _e118 = samples.member[(0u + _e110)].normal;
        let _e120 = samples.member[(0u + _e110)].magnitude;
        let _e122 = ((8f / 8388608f) * _e120);
        let _e130 = (_e116.x + (_e118.x * _e122));
        let _e132 = (_e116.y + (_e118.y * _e122));
        let _e134 = (_e116.z + (_e118.z * _e122));
        let _e136 = p.member.light.place;
        if (_e136.w == 0f) {
            phi_680_ = 300000000000000000000000000000000000000f;
        } else {
            phi_680_ = 1f;
        }
        let _e140 = phi_680_;
        let _e148 = (_e136.x - (_e130 * _e136.w));
        let _e149 = (_e136.y - (_e132 * _e136.w));
        let _e150 = (_e136.z - (_e134 * _e136.w));
        let _e155 = abs(_e148);
        let _e156 = abs(_e149);
        let _e157 = abs(_e150);
        if (abs(_e130) < 1000000000000000f) {
            if (abs(_e132) < 1000000000000000f) {
                if (abs(_e134) < 1000000000000000f) {
                    if (_e155 < 1000000000000000f) {
                        if (_e156 < 1000000000000000f) {
                            if (_e157 < 1000000000000000f) {
                                if (_e155 > 0f) {
                                    phi_736_ = bool();
                                    phi_737_ = true;
                                } else {
                                    let _e165 = (_e156 > 0f);
                                    if _e165 {
                                        phi_735_ = bool();
                                    } else {
                                        phi_735_ = (_e157 > 0f);
                                    }
                                    let _e168 = phi_735_;
                                    phi_736_ = _e168;
                                    phi_737_ = _e165;
                                }
                                let _e170 = phi_736_;
                                let _e172 = phi_737_;
                                if _e172 {
                                    phi_741_ = true;
                                } else {
                                    phi_741_ = _e170;
                                }
                                let _e174 = phi_741_;
                                phi_742_ = _e174;
                                phi_743_ = false;
                            } else {
                                phi_742_ = bool();
                                phi_743_ = true;
                            }
                            let _e176 = phi_742_;
                            let _e178 = phi_743_;
                            phi_744_ = _e176;
                            phi_745_ = false;
                            phi_746_ = _e178;
                        } else {
                            phi_744_ = bool();
                            phi_745_ = true;
                            phi_746_ = false;
                        }
                        let _e180 = phi_744_;
                        let _e182 = phi_745_;
                        let _e184 = phi_746_;
                        phi_747_ = _e180;
                        phi_748_ = _e182;
                        phi_749_ = _e184;
                    } else {
                        phi_747_ = bool();
                        phi_748_ = true;
                        phi_749_ = false;
                    }
                    let _e186 = phi_747_;
                    let _e188 = phi_748_;
                    let _e190 = phi_749_;
                    phi_750_ = _e186;
                    phi_751_ = _e188;
                    phi_752_ = _e190;
                } else {
                    phi_750_ = bool();
                    phi_751_ = true;
                    phi_752_ = false;
                }
                let _e192 = phi_750_;
                let _e194 = phi_751_;
                let _e196 = phi_752_;
                phi_753_ = _e192;
                phi_754_ = _e194;
                phi_755_ = _e196;
            } else {
                phi_753_ = bool();
                phi_754_ = true;
                phi_755_ = false;
            }
            let _e198 = phi_753_;
            let _e200 = phi_754_;
            let _e202 = phi_755_;
            phi_756_ = _e198;
            phi_757_ = _e200;
            phi_758_ = _e202;
        } else {
            phi_756_ = bool();
            phi_757_ = true;
            phi_758_ = false;
        }
        let _e204 = phi_756_;
        let _e206 = phi_757_;
        let _e208 = phi_758_;
        if _e206 {
            phi_762_ = true;
        } else {
            phi_762_ = _e208;
        }
        let _e210 = phi_762_;
        if _e210 {
            phi_766_ = false;
        } else {
            phi_766_ = _e204;
        }
        let _e212 = phi_766_;
        if _e212 {
            let _e213 = (0u >= _e76);
            if _e213 {
                phi_2346_ = bool();
            } else {
                if (0u < _e76) {
                } else {
                    return;
                }
                let _e219 = nodes.member[(0u + 0u)].frame[0u];
                let _e223 = nodes.member[(0u + 0u)].frame[1u];
                let _e227 = nodes.member[(0u + 0u)].frame[2u];
                let _e231 = nodes.member[(0u + 0u)].frame[0u];
                let _e235 = nodes.member[(0u + 0u)].frame[1u];
                let _e239 = nodes.member[(0u + 0u)].frame[2u];
                let _e243 = nodes.member[(0u + 0u)].frame[3u];
                let _e277 = core_intrinsics_maximum_number_nsz_f32_(abs(_e148), abs(_e149));
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(_e277, abs(_e150));
                let _e279 = (_e278 * 0.0000000000009094947f);
                if (abs(_e148) < _e279) {
                    phi_836_ = _e279;
                } else {
                    phi_836_ = abs(_e148);
                }
                let _e284 = phi_836_;
                if (_e148 < 0f) {
                    phi_843_ = (-1f / _e284);
                } else {
                    phi_843_ = (1f / _e284);
                }
                let _e289 = phi_843_;
                if (abs(_e149) < _e279) {
                    phi_850_ = _e279;
                } else {
                    phi_850_ = abs(_e149);
                }
                let _e294 = phi_850_;
                if (_e149 < 0f) {
                    phi_857_ = (-1f / _e294);
                } else {
                    phi_857_ = (1f / _e294);
                }
                let _e299 = phi_857_;
                if (abs(_e150) < _e279) {
                    phi_864_ = _e279;
                } else {
                    phi_864_ = abs(_e150);
                }
                let _e304 = phi_864_;
                if (_e150 < 0f) {
                    phi_871_ = (-1f / _e304);
                } else {
                    phi_871_ = (1f / _e304);
                }
                let _e309 = phi_871_;
                let _e313 = abs((bitcast<f32>(_e219) - _e130));
                let _e314 = abs((bitcast<f32>(_e223) - _e132));
                let _e315 = abs((bitcast<f32>(_e227) - _e134));
                let _e319 = abs(((bitcast<f32>(_e231) + (bitcast<f32>((((_e243 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e130));
                let _e320 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e243 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e132));
                let _e321 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e243 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e134));
                if (_e313 > _e319) {
                    phi_888_ = _e313;
                } else {
                    phi_888_ = _e319;
                }
                let _e324 = phi_888_;
                if (_e314 > _e320) {
                    phi_893_ = _e314;
                } else {
                    phi_893_ = _e320;
                }
                let _e327 = phi_893_;
                if (_e315 > _e321) {
                    phi_898_ = _e315;
                } else {
                    phi_898_ = _e321;
                }
                let _e330 = phi_898_;
                let _e331 = core_intrinsics_maximum_number_nsz_f32_(_e324, _e327);
                let _e332 = core_intrinsics_maximum_number_nsz_f32_(_e331, _e330);
                let _e336 = (_e332 * 0.0000019073486f);
                let _e337 = (abs(_e289) * _e336);
                let _e338 = (abs(_e299) * _e336);
                let _e339 = (abs(_e309) * _e336);
                let _e343 = (_e332 * 0.0000009536743f);
                let _e344 = (abs(_e289) * _e343);
                let _e345 = (abs(_e299) * _e343);
                let _e346 = (abs(_e309) * _e343);
                let _e347 = abs(_e148);
                let _e348 = abs(_e149);
                let _e349 = abs(_e150);
                if (_e347 >= _e348) {
                    if (_e347 >= _e349) {
                        phi_926_ = false;
                    } else {
                        phi_926_ = true;
                    }
                    let _e353 = phi_926_;
                    phi_927_ = _e353;
                } else {
                    phi_927_ = true;
                }
                let _e355 = phi_927_;
                if _e355 {
                    if (_e348 >= _e349) {
                        phi_935_ = 1u;
                    } else {
                        phi_935_ = 2u;
                    }
                    let _e358 = phi_935_;
                    phi_936_ = _e358;
                } else {
                    phi_936_ = 0u;
                }
                let _e360 = phi_936_;
                if (_e360 == 0u) {
                    phi_948_ = vec3<f32>(_e149, _e150, _e148);
                } else {
                    if (_e360 == 1u) {
                        phi_947_ = vec3<f32>(_e150, _e148, _e149);
                    } else {
                        phi_947_ = vec3<f32>(_e148, _e149, _e150);
                    }
                    let _e366 = phi_947_;
                    phi_948_ = _e366;
                }
                let _e368 = phi_948_;
                let _e371 = (_e368.x / _e368.z);
                let _e374 = (_e368.y / _e368.z);
                if (_e289 < 0f) {
                    phi_961_ = 0u;
                } else {
                    phi_961_ = 1u;
                }
                let _e379 = phi_961_;
                if (_e299 < 0f) {
                    phi_966_ = 0u;
                } else {
                    phi_966_ = 2u;
                }
                let _e382 = phi_966_;
                if (_e309 < 0f) {
                    phi_971_ = 0u;
                } else {
                    phi_971_ = 4u;
                }
                let _e385 = phi_971_;
                let _e387 = ((_e379 | _e382) | _e385);
                let _e388 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e388.first[0], _e388.first[1], _e388.first[2], _e388.first[3], _e388.first[4], _e388.first[5], _e388.first[6], _e388.first[7], _e388.first[8], _e388.first[9], _e388.first[10], _e388.first[11], _e388.first[12], _e388.first[13], _e388.first[14], _e388.first[15], _e388.first[16], _e388.first[17], _e388.first[18], _e388.first[19], _e388.first[20], _e388.first[21], _e388.first[22], _e388.first[23], _e388.first[24], _e388.first[25], _e388.first[26], _e388.first[27], _e388.first[28], _e388.first[29], _e388.first[30], _e388.first[31]), array<u32, 32>(_e388.mask[0], _e388.mask[1], _e388.mask[2], _e388.mask[3], _e388.mask[4], _e388.mask[5], _e388.mask[6], _e388.mask[7], _e388.mask[8], _e388.mask[9], _e388.mask[10], _e388.mask[11], _e388.mask[12], _e388.mask[13], _e388.mask[14], _e388.mask[15], _e388.mask[16], _e388.mask[17], _e388.mask[18], _e388.mask[19], _e388.mask[20], _e388.mask[21], _e388.mask[22], _e388.mask[23], _e388.mask[24], _e388.mask[25], _e388.mask[26], _e388.mask[27], _e388.mask[28], _e388.mask[29], _e388.mask[30], _e388.mask[31]), _e388.len, _e388.group, _e388.group_mask);
                let _e462 = local_1.group_mask;
                if ((_e462 & 4278190080u) == 0u) {
                    let _e466 = local_1.len;
                    if (_e466 == 0u) {
                        phi_1085_ = false;
                    } else {
                        let _e470 = local_1.len;
                        local_1.len = (_e470 - 1u);
                        let _e473 = local_1.len;
                        if (_e473 < 32u) {
                        } else {
                            return;
                        }
                        let _e478 = local_1.first[(0u + _e473)];
                        local_1.group = _e478;
                        let _e481 = local_1.len;
                        if (_e481 < 32u) {
                        } else {
                            return;
                        }
                        let _e486 = local_1.mask[(0u + _e481)];
                        local_1.group_mask = _e486;
                        phi_1085_ = true;
                    }
                    let _e489 = phi_1085_;
                    phi_1086_ = _e489;
                } else {
                    phi_1086_ = true;
                }
                let _e491 = phi_1086_;
                if _e491 {
                    let _e493 = local_1.group_mask;
                    let _e499 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e493)), 32u, (_e493 == 0u)));
                    let _e503 = local_1.group_mask;
                    let _e517 = local_1.group_mask;
                    local_1.group_mask = (_e517 & ~((1u << bitcast<u32>((_e499 & 31u)))));
                    let _e520 = local_1.group;
                    phi_1117_ = (_e520 + countOneBits(((_e503 & ~((4294967295u << bitcast<u32>((((_e499 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1117_ = 4294967295u;
                }
                let _e523 = phi_1117_;
                phi_1119_ = _e523;
                phi_1122_ = false;
                loop {
                    let _e525 = phi_1119_;
                    let _e527 = phi_1122_;
                    local_11 = _e527;
                    if (_e525 != 4294967295u) {
                        if (_e525 < _e76) {
                        } else {
                            return;
                        }
                        let _e534 = nodes.member[(0u + _e525)].frame[3u];
                        let _e559 = (bitcast<f32>((((_e534 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e560 = (bitcast<f32>((((_e534 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e561 = (bitcast<f32>((((_e534 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e564 = nodes.member[(0u + _e525)].frame[0u];
                        let _e568 = nodes.member[(0u + _e525)].frame[1u];
                        let _e572 = nodes.member[(0u + _e525)].frame[2u];
                        let _e577 = ((bitcast<f32>(_e564) - _e130) * _e289);
                        let _e578 = ((bitcast<f32>(_e568) - _e132) * _e299);
                        let _e579 = ((bitcast<f32>(_e572) - _e134) * _e309);
                        let _e587 = nodes.member[(0u + _e525)].x;
                        if (_e289 < 0f) {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e587.w), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e587.x, _e604.unnamed_1.first_primitive));
                            phi_1202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e587.y));
                        } else {
                            let _e626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e587.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e626.unnamed.root, _e587.y), _e626.unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e632.unnamed, lt_bvh_traverse_Tree(_e587.z, _e632.unnamed_1.first_primitive));
                            phi_1202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e638.unnamed_1.root, _e587.w));
                        }
                        let _e646 = phi_1202_;
                        let _e656 = nodes.member[(0u + _e525)].y;
                        if (_e299 < 0f) {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e656.w), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e656.x, _e673.unnamed_1.first_primitive));
                            phi_1229_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e656.y));
                        } else {
                            let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e695.unnamed.root, _e656.y), _e695.unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e701.unnamed, lt_bvh_traverse_Tree(_e656.z, _e701.unnamed_1.first_primitive));
                            phi_1229_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e707.unnamed_1.root, _e656.w));
                        }
                        let _e715 = phi_1229_;
                        let _e725 = nodes.member[(0u + _e525)].z;
                        if (_e309 < 0f) {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e725.w), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e725.x, _e742.unnamed_1.first_primitive));
                            phi_1256_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e725.y));
                        } else {
                            let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e764.unnamed.root, _e725.y), _e764.unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e770.unnamed, lt_bvh_traverse_Tree(_e725.z, _e770.unnamed_1.first_primitive));
                            phi_1256_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_bvh_traverse_Tree(_e776.unnamed_1.root, _e725.w));
                        }
                        let _e784 = phi_1256_;
                        phi_1262_ = 0u;
                        phi_1265_ = 0u;
                        loop {
                            let _e794 = phi_1262_;
                            let _e796 = phi_1265_;
                            local_2 = _e796;
                            local_3 = _e796;
                            local_4 = _e796;
                            let _e797 = (_e794 < 8u);
                            if _e797 {
                                let _e799 = (_e794 >> bitcast<u32>(2i));
                                let _e800 = (_e794 & 3u);
                                if (_e799 == 0u) {
                                    phi_1279_ = _e646.unnamed.root;
                                } else {
                                    phi_1279_ = _e646.unnamed.first_primitive;
                                }
                                let _e803 = phi_1279_;
                                if (_e799 == 0u) {
                                    phi_1289_ = _e715.unnamed.root;
                                } else {
                                    phi_1289_ = _e715.unnamed.first_primitive;
                                }
                                let _e812 = phi_1289_;
                                if (_e799 == 0u) {
                                    phi_1299_ = _e784.unnamed.root;
                                } else {
                                    phi_1299_ = _e784.unnamed.first_primitive;
                                }
                                let _e821 = phi_1299_;
                                let _e834 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e803 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e337)), ((f32(((_e812 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e560) + (_e578 - _e338)));
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(_e834, ((f32(((_e821 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e561) + (_e579 - _e339)));
                                if (_e799 == 0u) {
                                    phi_1317_ = _e646.unnamed_1.root;
                                } else {
                                    phi_1317_ = _e646.unnamed_1.first_primitive;
                                }
                                let _e838 = phi_1317_;
                                if (_e799 == 0u) {
                                    phi_1327_ = _e715.unnamed_1.root;
                                } else {
                                    phi_1327_ = _e715.unnamed_1.first_primitive;
                                }
                                let _e847 = phi_1327_;
                                if (_e799 == 0u) {
                                    phi_1337_ = _e784.unnamed_1.root;
                                } else {
                                    phi_1337_ = _e784.unnamed_1.first_primitive;
                                }
                                let _e856 = phi_1337_;
                                let _e869 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e838 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e337)), ((f32(((_e847 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e560) + (_e578 + _e338)));
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(_e869, ((f32(((_e856 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u)) * _e561) + (_e579 + _e339)));
                                if (_e835 <= _e870) {
                                    if (_e835 <= _e140) {
                                        if (_e870 >= 0f) {
                                            if (_e799 == 0u) {
                                                let _e877 = nodes.member[(0u + _e525)].links[2u];
                                                phi_1373_ = _e877;
                                            } else {
                                                let _e880 = nodes.member[(0u + _e525)].links[3u];
                                                phi_1373_ = _e880;
                                            }
                                            let _e882 = phi_1373_;
                                            let _e887 = ((_e882 >> bitcast<u32>(((_e800 * 8u) & 31u))) & 255u);
                                            let _e888 = (_e887 & 31u);
                                            if (_e888 >= 24u) {
                                                phi_1386_ = (24u + ((_e888 - 24u) ^ _e387));
                                            } else {
                                                phi_1386_ = _e888;
                                            }
                                            let _e894 = phi_1386_;
                                            phi_1391_ = (_e796 | ((_e887 >> bitcast<u32>(5i)) << bitcast<u32>((_e894 & 31u))));
                                        } else {
                                            phi_1391_ = _e796;
                                        }
                                        let _e902 = phi_1391_;
                                        phi_1392_ = _e902;
                                    } else {
                                        phi_1392_ = _e796;
                                    }
                                    let _e904 = phi_1392_;
                                    phi_1393_ = _e904;
                                } else {
                                    phi_1393_ = _e796;
                                }
                                let _e906 = phi_1393_;
                                phi_1263_ = (_e794 + 1u);
                                phi_1266_ = _e906;
                            } else {
                                phi_1263_ = u32();
                                phi_1266_ = u32();
                            }
                            let _e909 = phi_1263_;
                            let _e911 = phi_1266_;
                            continue;
                            continuing {
                                phi_1262_ = _e909;
                                phi_1265_ = _e911;
                                break if !(_e797);
                            }
                        }
                        let _e915 = nodes.member[(0u + _e525)].links[0u];
                        let _e919 = nodes.member[(0u + _e525)].frame[3u];
                        let _e923 = local_2;
                        if ((_e923 & 4278190080u) == 0u) {
                        } else {
                            let _e927 = local_1.group_mask;
                            if ((_e927 & 4278190080u) == 0u) {
                            } else {
                                let _e931 = local_1.len;
                                if (_e931 < 32u) {
                                    let _e934 = local_1.group;
                                    let _e936 = local_1.len;
                                    if (_e936 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e936)] = _e934;
                                    let _e942 = local_1.group_mask;
                                    let _e944 = local_1.len;
                                    if (_e944 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e944)] = _e942;
                                    let _e951 = local_1.len;
                                    local_1.len = (_e951 + 1u);
                                }
                            }
                            local_1.group = (0u + _e915);
                            let _e955 = local_3;
                            local_1.group_mask = ((_e955 & 4278190080u) | (_e919 >> bitcast<u32>(24i)));
                        }
                        let _e960 = local_4;
                        phi_1451_ = (_e960 & 16777215u);
                        phi_1454_ = _e527;
                        loop {
                            let _e963 = phi_1451_;
                            let _e965 = phi_1454_;
                            local_7 = _e965;
                            let _e966 = (_e963 == 0u);
                            local_5 = _e966;
                            local_9 = _e966;
                            if _e966 {
                                phi_1452_ = u32();
                                phi_1455_ = bool();
                                phi_2258_ = bool();
                                phi_2259_ = false;
                            } else {
                                let _e969 = nodes.member[(0u + _e525)].links[1u];
                                let _e974 = ((0u + _e969) + select(firstTrailingBit(_e963), 32u, (_e963 == 0u)));
                                if (_e974 < _e79) {
                                } else {
                                    return;
                                }
                                let _e981 = triangles.member[(0u + _e974)].v0_;
                                let _e983 = (_e981.x - _e130);
                                let _e985 = (_e981.y - _e132);
                                let _e987 = (_e981.z - _e134);
                                if (_e360 == 0u) {
                                    phi_1499_ = vec3<f32>(_e985, _e987, _e983);
                                } else {
                                    if (_e360 == 1u) {
                                        phi_1498_ = vec3<f32>(_e987, _e983, _e985);
                                    } else {
                                        phi_1498_ = (_e981 - vec3<f32>(_e130, _e132, _e134));
                                    }
                                    let _e995 = phi_1498_;
                                    phi_1499_ = _e995;
                                }
                                let _e997 = phi_1499_;
                                let _e1001 = (_e997.x - (_e371 * _e997.z));
                                let _e1005 = (_e997.y - (_e374 * _e997.z));
                                let _e1007 = triangles.member[(0u + _e974)].v1_;
                                let _e1009 = (_e1007.x - _e130);
                                let _e1011 = (_e1007.y - _e132);
                                let _e1013 = (_e1007.z - _e134);
                                if (_e360 == 0u) {
                                    phi_1529_ = vec3<f32>(_e1011, _e1013, _e1009);
                                } else {
                                    if (_e360 == 1u) {
                                        phi_1528_ = vec3<f32>(_e1013, _e1009, _e1011);
                                    } else {
                                        phi_1528_ = (_e1007 - vec3<f32>(_e130, _e132, _e134));
                                    }
                                    let _e1021 = phi_1528_;
                                    phi_1529_ = _e1021;
                                }
                                let _e1023 = phi_1529_;
                                let _e1027 = (_e1023.x - (_e371 * _e1023.z));
                                let _e1031 = (_e1023.y - (_e374 * _e1023.z));
                                let _e1033 = triangles.member[(0u + _e974)].v2_;
                                let _e1035 = (_e1033.x - _e130);
                                let _e1037 = (_e1033.y - _e132);
                                let _e1039 = (_e1033.z - _e134);
                                if (_e360 == 0u) {
                                    phi_1559_ = vec3<f32>(_e1037, _e1039, _e1035);
                                } else {
                                    if (_e360 == 1u) {
                                        phi_1558_ = vec3<f32>(_e1039, _e1035, _e1037);
                                    } else {
                                        phi_1558_ = (_e1033 - vec3<f32>(_e130, _e132, _e134));
                                    }
                                    let _e1047 = phi_1558_;
                                    phi_1559_ = _e1047;
                                }
                                let _e1049 = phi_1559_;
                                let _e1053 = (_e1049.x - (_e371 * _e1049.z));
                                let _e1057 = (_e1049.y - (_e374 * _e1049.z));
                                if (_e1027 < _e1053) {
                                    phi_1578_ = true;
                                } else {
                                    if (_e1027 == _e1053) {
                                        phi_1577_ = (_e1031 < _e1057);
                                    } else {
                                        phi_1577_ = false;
                                    }
                                    let _e1062 = phi_1577_;
                                    phi_1578_ = _e1062;
                                }
                                let _e1064 = phi_1578_;
                                if _e1064 {
                                    phi_1582_ = _e1057;
                                    phi_1583_ = _e1053;
                                    phi_1584_ = _e1031;
                                    phi_1585_ = _e1027;
                                } else {
                                    phi_1582_ = _e1031;
                                    phi_1583_ = _e1027;
                                    phi_1584_ = _e1057;
                                    phi_1585_ = _e1053;
                                }
                                let _e1066 = phi_1582_;
                                let _e1068 = phi_1583_;
                                let _e1070 = phi_1584_;
                                let _e1072 = phi_1585_;
                                let _e1075 = ((_e1072 * _e1066) - (_e1070 * _e1068));
                                if _e1064 {
                                    phi_1593_ = -(_e1075);
                                } else {
                                    phi_1593_ = _e1075;
                                }
                                let _e1078 = phi_1593_;
                                if (_e1053 < _e1001) {
                                    phi_1604_ = true;
                                } else {
                                    if (_e1053 == _e1001) {
                                        phi_1603_ = (_e1057 < _e1005);
                                    } else {
                                        phi_1603_ = false;
                                    }
                                    let _e1083 = phi_1603_;
                                    phi_1604_ = _e1083;
                                }
                                let _e1085 = phi_1604_;
                                if _e1085 {
                                    phi_1608_ = _e1005;
                                    phi_1609_ = _e1001;
                                    phi_1610_ = _e1057;
                                    phi_1611_ = _e1053;
                                } else {
                                    phi_1608_ = _e1057;
                                    phi_1609_ = _e1053;
                                    phi_1610_ = _e1005;
                                    phi_1611_ = _e1001;
                                }
                                let _e1087 = phi_1608_;
                                let _e1089 = phi_1609_;
                                let _e1091 = phi_1610_;
                                let _e1093 = phi_1611_;
                                let _e1096 = ((_e1093 * _e1087) - (_e1091 * _e1089));
                                if _e1085 {
                                    phi_1619_ = -(_e1096);
                                } else {
                                    phi_1619_ = _e1096;
                                }
                                let _e1099 = phi_1619_;
                                if (_e1001 < _e1027) {
                                    phi_1630_ = true;
                                } else {
                                    if (_e1001 == _e1027) {
                                        phi_1629_ = (_e1005 < _e1031);
                                    } else {
                                        phi_1629_ = false;
                                    }
                                    let _e1104 = phi_1629_;
                                    phi_1630_ = _e1104;
                                }
                                let _e1106 = phi_1630_;
                                if _e1106 {
                                    phi_1634_ = _e1031;
                                    phi_1635_ = _e1027;
                                    phi_1636_ = _e1005;
                                    phi_1637_ = _e1001;
                                } else {
                                    phi_1634_ = _e1005;
                                    phi_1635_ = _e1001;
                                    phi_1636_ = _e1031;
                                    phi_1637_ = _e1027;
                                }
                                let _e1108 = phi_1634_;
                                let _e1110 = phi_1635_;
                                let _e1112 = phi_1636_;
                                let _e1114 = phi_1637_;
                                let _e1117 = ((_e1114 * _e1108) - (_e1112 * _e1110));
                                if _e1106 {
                                    phi_1645_ = -(_e1117);
                                } else {
                                    phi_1645_ = _e1117;
                                }
                                let _e1120 = phi_1645_;
                                if (_e1078 >= 0f) {
                                    if (_e1099 >= 0f) {
                                        if (_e1120 >= 0f) {
                                            phi_1660_ = ((_e1078 + _e1099) + _e1120);
                                            phi_1661_ = false;
                                        } else {
                                            phi_1660_ = f32();
                                            phi_1661_ = true;
                                        }
                                        let _e1127 = phi_1660_;
                                        let _e1129 = phi_1661_;
                                        phi_1662_ = _e1127;
                                        phi_1663_ = _e1129;
                                    } else {
                                        phi_1662_ = f32();
                                        phi_1663_ = true;
                                    }
                                    let _e1131 = phi_1662_;
                                    let _e1133 = phi_1663_;
                                    phi_1664_ = _e1131;
                                    phi_1665_ = _e1133;
                                } else {
                                    phi_1664_ = f32();
                                    phi_1665_ = true;
                                }
                                let _e1135 = phi_1664_;
                                let _e1137 = phi_1665_;
                                if _e1137 {
                                    if (_e1078 <= 0f) {
                                        if (_e1099 <= 0f) {
                                            let _e1140 = (_e1120 <= 0f);
                                            if _e1140 {
                                            }
                                            phi_1683_ = ((_e1078 + _e1099) + _e1120);
                                            phi_1684_ = false;
                                            phi_1685_ = _e1140;
                                        } else {
                                            phi_1683_ = f32();
                                            phi_1684_ = true;
                                            phi_1685_ = false;
                                        }
                                        let _e1144 = phi_1683_;
                                        let _e1146 = phi_1684_;
                                        let _e1148 = phi_1685_;
                                        phi_1686_ = _e1144;
                                        phi_1687_ = _e1146;
                                        phi_1688_ = _e1148;
                                    } else {
                                        phi_1686_ = f32();
                                        phi_1687_ = true;
                                        phi_1688_ = false;
                                    }
                                    let _e1150 = phi_1686_;
                                    let _e1152 = phi_1687_;
                                    let _e1154 = phi_1688_;
                                    if _e1152 {
                                        phi_1692_ = false;
                                    } else {
                                        phi_1692_ = _e1154;
                                    }
                                    let _e1156 = phi_1692_;
                                    phi_1693_ = _e1150;
                                    phi_1694_ = _e1156;
                                } else {
                                    phi_1693_ = _e1135;
                                    phi_1694_ = true;
                                }
                                let _e1158 = phi_1693_;
                                let _e1160 = phi_1694_;
                                if _e1160 {
                                    let _e1161 = (_e1158 == 0f);
                                    if _e1161 {
                                        phi_2010_ = lt_bvh_triangle_Intersection();
                                        phi_2011_ = false;
                                    } else {
                                        let _e1163 = triangles.member[(0u + _e974)].v0_;
                                        let _e1165 = (_e1163.x - _e130);
                                        let _e1167 = (_e1163.y - _e132);
                                        let _e1169 = (_e1163.z - _e134);
                                        if (_e360 == 0u) {
                                            phi_1723_ = vec3<f32>(_e1167, _e1169, _e1165);
                                        } else {
                                            if (_e360 == 1u) {
                                                phi_1722_ = vec3<f32>(_e1169, _e1165, _e1167);
                                            } else {
                                                phi_1722_ = (_e1163 - vec3<f32>(_e130, _e132, _e134));
                                            }
                                            let _e1177 = phi_1722_;
                                            phi_1723_ = _e1177;
                                        }
                                        let _e1179 = phi_1723_;
                                        let _e1181 = triangles.member[(0u + _e974)].v1_;
                                        let _e1183 = triangles.member[(0u + _e974)].v0_;
                                        let _e1186 = (_e1181.x - _e1183.x);
                                        let _e1189 = (_e1181.y - _e1183.y);
                                        let _e1192 = (_e1181.z - _e1183.z);
                                        if (_e360 == 0u) {
                                            phi_1749_ = vec3<f32>(_e1189, _e1192, _e1186);
                                        } else {
                                            if (_e360 == 1u) {
                                                phi_1748_ = vec3<f32>(_e1192, _e1186, _e1189);
                                            } else {
                                                phi_1748_ = (_e1181 - _e1183);
                                            }
                                            let _e1199 = phi_1748_;
                                            phi_1749_ = _e1199;
                                        }
                                        let _e1201 = phi_1749_;
                                        let _e1203 = triangles.member[(0u + _e974)].v2_;
                                        let _e1205 = triangles.member[(0u + _e974)].v0_;
                                        let _e1208 = (_e1203.x - _e1205.x);
                                        let _e1211 = (_e1203.y - _e1205.y);
                                        let _e1214 = (_e1203.z - _e1205.z);
                                        if (_e360 == 0u) {
                                            phi_1775_ = vec3<f32>(_e1211, _e1214, _e1208);
                                        } else {
                                            if (_e360 == 1u) {
                                                phi_1774_ = vec3<f32>(_e1214, _e1208, _e1211);
                                            } else {
                                                phi_1774_ = (_e1203 - _e1205);
                                            }
                                            let _e1221 = phi_1774_;
                                            phi_1775_ = _e1221;
                                        }
                                        let _e1223 = phi_1775_;
                                        let _e1230 = ((_e1201.y * _e1223.z) - (_e1201.z * _e1223.y));
                                        let _e1237 = ((_e1201.z * _e1223.x) - (_e1201.x * _e1223.z));
                                        let _e1244 = ((_e1201.x * _e1223.y) - (_e1201.y * _e1223.x));
                                        let _e1258 = (((1f / _e368.z) * (((_e1230 * _e1179.x) + (_e1237 * _e1179.y)) + (_e1244 * _e1179.z))) / (((_e1230 * _e371) + (_e1237 * _e374)) + _e1244));
                                        if (_e1258 > 0f) {
                                            if (_e1258 < _e140) {
                                                let _e1262 = triangles.member[(0u + _e974)].v0_;
                                                let _e1264 = triangles.member[(0u + _e974)].v1_;
                                                if (_e1262.x < _e1264.x) {
                                                    phi_1831_ = _e1262.x;
                                                } else {
                                                    phi_1831_ = _e1264.x;
                                                }
                                                let _e1271 = phi_1831_;
                                                if (_e1262.y < _e1264.y) {
                                                    phi_1840_ = _e1262.y;
                                                } else {
                                                    phi_1840_ = _e1264.y;
                                                }
                                                let _e1278 = phi_1840_;
                                                if (_e1262.z < _e1264.z) {
                                                    phi_1849_ = _e1262.z;
                                                } else {
                                                    phi_1849_ = _e1264.z;
                                                }
                                                let _e1285 = phi_1849_;
                                                let _e1287 = triangles.member[(0u + _e974)].v2_;
                                                if (_e1271 < _e1287.x) {
                                                    phi_1858_ = _e1271;
                                                } else {
                                                    phi_1858_ = _e1287.x;
                                                }
                                                let _e1292 = phi_1858_;
                                                if (_e1278 < _e1287.y) {
                                                    phi_1865_ = _e1278;
                                                } else {
                                                    phi_1865_ = _e1287.y;
                                                }
                                                let _e1297 = phi_1865_;
                                                if (_e1285 < _e1287.z) {
                                                    phi_1872_ = _e1285;
                                                } else {
                                                    phi_1872_ = _e1287.z;
                                                }
                                                let _e1302 = phi_1872_;
                                                let _e1304 = triangles.member[(0u + _e974)].v0_;
                                                let _e1306 = triangles.member[(0u + _e974)].v1_;
                                                if (_e1304.x > _e1306.x) {
                                                    phi_1885_ = _e1304.x;
                                                } else {
                                                    phi_1885_ = _e1306.x;
                                                }
                                                let _e1313 = phi_1885_;
                                                if (_e1304.y > _e1306.y) {
                                                    phi_1894_ = _e1304.y;
                                                } else {
                                                    phi_1894_ = _e1306.y;
                                                }
                                                let _e1320 = phi_1894_;
                                                if (_e1304.z > _e1306.z) {
                                                    phi_1903_ = _e1304.z;
                                                } else {
                                                    phi_1903_ = _e1306.z;
                                                }
                                                let _e1327 = phi_1903_;
                                                let _e1329 = triangles.member[(0u + _e974)].v2_;
                                                if (_e1313 > _e1329.x) {
                                                    phi_1912_ = _e1313;
                                                } else {
                                                    phi_1912_ = _e1329.x;
                                                }
                                                let _e1334 = phi_1912_;
                                                if (_e1320 > _e1329.y) {
                                                    phi_1919_ = _e1320;
                                                } else {
                                                    phi_1919_ = _e1329.y;
                                                }
                                                let _e1339 = phi_1919_;
                                                if (_e1327 > _e1329.z) {
                                                    phi_1926_ = _e1327;
                                                } else {
                                                    phi_1926_ = _e1329.z;
                                                }
                                                let _e1344 = phi_1926_;
                                                let _e1348 = ((_e1292 - _e130) * _e289);
                                                let _e1349 = ((_e1297 - _e132) * _e299);
                                                let _e1350 = ((_e1302 - _e134) * _e309);
                                                let _e1354 = ((_e1334 - _e130) * _e289);
                                                let _e1355 = ((_e1339 - _e132) * _e299);
                                                let _e1356 = ((_e1344 - _e134) * _e309);
                                                if (_e1348 < _e1354) {
                                                    phi_1943_ = _e1348;
                                                } else {
                                                    phi_1943_ = _e1354;
                                                }
                                                let _e1359 = phi_1943_;
                                                if (_e1349 < _e1355) {
                                                    phi_1948_ = _e1349;
                                                } else {
                                                    phi_1948_ = _e1355;
                                                }
                                                let _e1362 = phi_1948_;
                                                if (_e1350 < _e1356) {
                                                    phi_1953_ = _e1350;
                                                } else {
                                                    phi_1953_ = _e1356;
                                                }
                                                let _e1365 = phi_1953_;
                                                if (_e1348 > _e1354) {
                                                    phi_1961_ = _e1348;
                                                } else {
                                                    phi_1961_ = _e1354;
                                                }
                                                let _e1371 = phi_1961_;
                                                if (_e1349 > _e1355) {
                                                    phi_1966_ = _e1349;
                                                } else {
                                                    phi_1966_ = _e1355;
                                                }
                                                let _e1374 = phi_1966_;
                                                if (_e1350 > _e1356) {
                                                    phi_1971_ = _e1350;
                                                } else {
                                                    phi_1971_ = _e1356;
                                                }
                                                let _e1377 = phi_1971_;
                                                let _e1381 = core_intrinsics_maximum_number_nsz_f32_((_e1359 - _e344), (_e1362 - _e345));
                                                let _e1382 = core_intrinsics_maximum_number_nsz_f32_(_e1381, (_e1365 - _e346));
                                                let _e1383 = core_intrinsics_minimum_number_nsz_f32_((_e1371 + _e344), (_e1374 + _e345));
                                                let _e1384 = core_intrinsics_minimum_number_nsz_f32_(_e1383, (_e1377 + _e346));
                                                if (_e1382 > -300000000000000000000000000000000000000f) {
                                                    phi_1983_ = _e1382;
                                                } else {
                                                    phi_1983_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1387 = phi_1983_;
                                                if (_e1384 < 300000000000000000000000000000000000000f) {
                                                    phi_1988_ = _e1384;
                                                } else {
                                                    phi_1988_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1390 = phi_1988_;
                                                if (_e1258 < _e1387) {
                                                    phi_1993_ = _e1387;
                                                } else {
                                                    phi_1993_ = _e1258;
                                                }
                                                let _e1393 = phi_1993_;
                                                if (_e1393 > _e1390) {
                                                    phi_1998_ = _e1390;
                                                } else {
                                                    phi_1998_ = _e1393;
                                                }
                                                let _e1396 = phi_1998_;
                                                phi_2003_ = lt_bvh_triangle_Intersection(_e1396, (_e1099 / _e1158), (_e1120 / _e1158), (_e1387 <= _e1390));
                                                phi_2004_ = false;
                                            } else {
                                                phi_2003_ = lt_bvh_triangle_Intersection();
                                                phi_2004_ = true;
                                            }
                                            let _e1402 = phi_2003_;
                                            let _e1404 = phi_2004_;
                                            phi_2005_ = _e1402;
                                            phi_2006_ = _e1404;
                                        } else {
                                            phi_2005_ = lt_bvh_triangle_Intersection();
                                            phi_2006_ = true;
                                        }
                                        let _e1406 = phi_2005_;
                                        let _e1408 = phi_2006_;
                                        if _e1408 {
                                        }
                                        phi_2010_ = _e1406;
                                        phi_2011_ = _e1408;
                                    }
                                    let _e1410 = phi_2010_;
                                    let _e1412 = phi_2011_;
                                    phi_2012_ = _e1410;
                                    phi_2013_ = _e1161;
                                    phi_2014_ = _e1412;
                                } else {
                                    phi_2012_ = lt_bvh_triangle_Intersection();
                                    phi_2013_ = true;
                                    phi_2014_ = false;
                                }
                                let _e1414 = phi_2012_;
                                let _e1416 = phi_2013_;
                                let _e1418 = phi_2014_;
                                if _e1416 {
                                    phi_2018_ = true;
                                } else {
                                    phi_2018_ = _e1418;
                                }
                                let _e1420 = phi_2018_;
                                if _e1420 {
                                    phi_2022_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2022_ = _e1414;
                                }
                                let _e1422 = phi_2022_;
                                if _e1422.is_hit {
                                    if (_e1422.t > 0f) {
                                        if (_e1422.t < _e140) {
                                            let _e1429 = triangles.member[(0u + _e974)].i0_;
                                            if ((_e1429 & 2147483648u) == 0u) {
                                                phi_2241_ = true;
                                            } else {
                                                if (_e974 < _e79) {
                                                } else {
                                                    return;
                                                }
                                                let _e1438 = triangles.member[(0u + _e974)].i0_;
                                                let _e1439 = (_e1438 & 2147483647u);
                                                let _e1441 = triangles.member[(0u + _e974)].i1_;
                                                let _e1443 = triangles.member[(0u + _e974)].i2_;
                                                if (_e1439 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1447 = vertices.member[(0u + _e1439)];
                                                if (_e1441 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1451 = vertices.member[(0u + _e1441)];
                                                if (_e1443 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1455 = vertices.member[(0u + _e1443)];
                                                let _e1456 = array<abi_Vertex, 3>(_e1447, _e1451, _e1455);
                                                if (_e1456[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1462 = materials.member[(0u + _e1456[0].material)];
                                                if ((_e1462.flags & 1u) == 1u) {
                                                    let _e1467 = ((1f - _e1422.u) - _e1422.v);
                                                    if (_e1462.cutoff <= 0f) {
                                                        phi_2239_ = true;
                                                    } else {
                                                        let _e1494 = (_e1462.base_color.w * ((((f32((_e1456[0].color >> bitcast<u32>(24i))) * _e1467) + (f32((_e1456[1].color >> bitcast<u32>(24i))) * _e1422.u)) + (f32((_e1456[2].color >> bitcast<u32>(24i))) * _e1422.v)) * (1f / 255f)));
                                                        if (_e1462.alpha_size == 0u) {
                                                            phi_2236_ = _e1494;
                                                        } else {
                                                            local.offset = _e1462.alpha_offset;
                                                            local.size = _e1462.alpha_size;
                                                            local.flags = _e1462.flags;
                                                            let _e1525 = _lt_shaders_texture_TextureView_quad((&local), (((_e1456[0].u * _e1467) + (_e1456[1].u * _e1422.u)) + (_e1456[2].u * _e1422.v)), (((_e1456[0].v * _e1467) + (_e1456[1].v * _e1422.u)) + (_e1456[2].v * _e1422.v)));
                                                            let _e1529 = (_e1525.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1529 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1533 = alpha_texels.member[(0u + _e1529)];
                                                            let _e1549 = (_e1525.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1549 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1553 = alpha_texels.member[(0u + _e1549)];
                                                            let _e1570 = (_e1525.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1570 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1574 = alpha_texels.member[(0u + _e1570)];
                                                            let _e1591 = (_e1525.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1591 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1595 = alpha_texels.member[(0u + _e1591)];
                                                            phi_2236_ = (_e1494 * (((((f32(((_e1533 >> bitcast<u32>((((_e1525.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1525.weights.x) + ((f32(((_e1553 >> bitcast<u32>((((_e1525.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1525.weights.y)) + ((f32(((_e1574 >> bitcast<u32>((((_e1525.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1525.weights.z)) + ((f32(((_e1595 >> bitcast<u32>((((_e1525.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1525.weights.w)));
                                                        }
                                                        let _e1611 = phi_2236_;
                                                        phi_2239_ = (_e1611 >= _e1462.cutoff);
                                                    }
                                                    let _e1615 = phi_2239_;
                                                    phi_2240_ = _e1615;
                                                } else {
                                                    phi_2240_ = false;
                                                }
                                                let _e1617 = phi_2240_;
                                                phi_2241_ = _e1617;
                                            }
                                            let _e1619 = phi_2241_;
                                            if _e1619 {
                                                phi_2245_ = false;
                                            } else {
                                                phi_2245_ = true;
                                            }
                                            let _e1621 = phi_2245_;
                                            phi_2246_ = _e1619;
                                            phi_2247_ = _e1619;
                                            phi_2248_ = _e1621;
                                        } else {
                                            phi_2246_ = bool();
                                            phi_2247_ = _e965;
                                            phi_2248_ = true;
                                        }
                                        let _e1623 = phi_2246_;
                                        let _e1625 = phi_2247_;
                                        let _e1627 = phi_2248_;
                                        phi_2249_ = _e1623;
                                        phi_2250_ = _e1625;
                                        phi_2251_ = _e1627;
                                    } else {
                                        phi_2249_ = bool();
                                        phi_2250_ = _e965;
                                        phi_2251_ = true;
                                    }
                                    let _e1629 = phi_2249_;
                                    let _e1631 = phi_2250_;
                                    let _e1633 = phi_2251_;
                                    phi_2252_ = _e1629;
                                    phi_2253_ = _e1631;
                                    phi_2254_ = _e1633;
                                } else {
                                    phi_2252_ = bool();
                                    phi_2253_ = _e965;
                                    phi_2254_ = true;
                                }
                                let _e1635 = phi_2252_;
                                let _e1637 = phi_2253_;
                                let _e1639 = phi_2254_;
                                if _e1639 {
                                }
                                phi_1452_ = (_e963 & (_e963 - 1u));
                                phi_1455_ = _e1637;
                                phi_2258_ = _e1635;
                                phi_2259_ = _e1639;
                            }
                            let _e1641 = phi_1452_;
                            let _e1643 = phi_1455_;
                            let _e1645 = phi_2258_;
                            let _e1647 = phi_2259_;
                            local_8 = _e1645;
                            continue;
                            continuing {
                                phi_1451_ = _e1641;
                                phi_1454_ = _e1643;
                                break if !(_e1647);
                            }
                        }
                        let _e1650 = local_5;
                        if _e1650 {
                            let _e1652 = local_1.group_mask;
                            if ((_e1652 & 4278190080u) == 0u) {
                                let _e1656 = local_1.len;
                                if (_e1656 == 0u) {
                                    phi_2301_ = false;
                                } else {
                                    let _e1660 = local_1.len;
                                    local_1.len = (_e1660 - 1u);
                                    let _e1663 = local_1.len;
                                    if (_e1663 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1668 = local_1.first[(0u + _e1663)];
                                    local_1.group = _e1668;
                                    let _e1671 = local_1.len;
                                    if (_e1671 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1676 = local_1.mask[(0u + _e1671)];
                                    local_1.group_mask = _e1676;
                                    phi_2301_ = true;
                                }
                                let _e1679 = phi_2301_;
                                phi_2302_ = _e1679;
                            } else {
                                phi_2302_ = true;
                            }
                            let _e1681 = phi_2302_;
                            if _e1681 {
                                let _e1683 = local_1.group_mask;
                                let _e1689 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1683)), 32u, (_e1683 == 0u)));
                                let _e1693 = local_1.group_mask;
                                let _e1707 = local_1.group_mask;
                                local_1.group_mask = (_e1707 & ~((1u << bitcast<u32>((_e1689 & 31u)))));
                                let _e1710 = local_1.group;
                                phi_2333_ = (_e1710 + countOneBits(((_e1693 & ~((4294967295u << bitcast<u32>((((_e1689 - 24u) ^ _e387) & 31u))))) & 255u)));
                            } else {
                                phi_2333_ = 4294967295u;
                            }
                            let _e1713 = phi_2333_;
                            phi_2334_ = _e1713;
                        } else {
                            phi_2334_ = u32();
                        }
                        let _e1715 = phi_2334_;
                        phi_1120_ = _e1715;
                        let _e1949 = local_7;
                        phi_1123_ = _e1949;
                        let _e1952 = local_8;
                        phi_2335_ = _e1952;
                        let _e1955 = local_9;
                        phi_2336_ = _e1955;
                        phi_2337_ = false;
                    } else {
                        phi_1120_ = u32();
                        phi_1123_ = bool();
                        phi_2335_ = bool();
                        phi_2336_ = false;
                        phi_2337_ = true;
                    }
                    let _e1717 = phi_1120_;
                    let _e1719 = phi_1123_;
                    let _e1721 = phi_2335_;
                    let _e1723 = phi_2336_;
                    let _e1725 = phi_2337_;
                    local_6 = _e1725;
                    local_10 = _e1721;
                    continue;
                    continuing {
                        phi_1119_ = _e1717;
                        phi_1122_ = _e1719;
                        break if !(_e1723);
                    }
                }
                let _e1728 = local_6;
                if _e1728 {
                    phi_2341_ = false;
                } else {
                    phi_2341_ = true;
                }
                let _e1730 = phi_2341_;
                if _e1730 {
                    let _e1961 = local_10;
                    phi_2345_ = _e1961;
                } else {
                    let _e1963 = local_11;
                    phi_2345_ = _e1963;
                }
                let _e1732 = phi_2345_;
                phi_2346_ = _e1732;
            }
            let _e1734 = phi_2346_;
            phi_2347_ = _e1734;
            phi_2348_ = _e213;
        } else {
            phi_2347_ = bool();
            phi_2348_ = true;
        }
        let _e1736 = phi_2347_;
        let _e1738 = phi_2348_;
        if _e1738 {
            phi_2352_ = false;
        } else {
            phi_2352_ = _e1736;
        }
        let _e1740 = phi_2352_;
        if _e1740 {
            phi_2356_ = 0f;
        } else {
            phi_2356_ = 1f;
        }
        let _e1742 = phi_2356_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e1742;
        if (_e110 < _e88) {
        } else {
            return;
        }
        let _e1749 = bits.member[(0u + _e110)];
        if ((_e1749 & 2u) == 0u) {
            phi_2377_ = (_e1749 & 1u);
        } else {
            phi_2377_ = (_e1749 & 7u);
        }
        let _e1755 = phi_2377_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        let _e1759 = visibility.member[(0u + _e110)];
        if ((_e1755 & 1u) != 0u) {
            phi_2392_ = (2u | 1u);
        } else {
            phi_2392_ = 2u;
        }
        let _e1765 = phi_2392_;
        if (_e1759 < 0.5f) {
            phi_2397_ = (_e1765 | 4u);
        } else {
            phi_2397_ = _e1765;
        }
        let _e1768 = phi_2397_;
        if (_e110 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e110)] = _e1768;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
