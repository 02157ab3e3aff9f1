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

struct type_30 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_34 {
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

struct type_38 {
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

struct type_51 {
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_57 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_57;
@group(0) @binding(2) 
var<storage> nodes: type_51;
@group(0) @binding(3) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_34;
@group(0) @binding(8) 
var<storage> materials: type_38;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_226_: f32;
    var phi_231_: f32;
    var phi_232_: bool;
    var phi_233_: f32;
    var phi_234_: bool;
    var phi_238_: f32;
    var phi_264_: f32;
    var phi_269_: f32;
    var phi_270_: bool;
    var phi_271_: f32;
    var phi_272_: bool;
    var phi_276_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_314_: u32;
    var phi_328_: u32;
    var phi_335_: u32;
    var phi_340_: u32;
    var phi_346_: u32;
    var phi_351_: u32;
    var phi_353_: texture_Axis;
    var phi_381_: f32;
    var phi_386_: f32;
    var phi_387_: bool;
    var phi_388_: f32;
    var phi_389_: bool;
    var phi_393_: f32;
    var phi_419_: f32;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_431_: f32;
    var phi_439_: f32;
    var phi_440_: f32;
    var phi_441_: f32;
    var phi_450_: f32;
    var phi_451_: f32;
    var phi_469_: u32;
    var phi_483_: u32;
    var phi_490_: u32;
    var phi_495_: u32;
    var phi_501_: u32;
    var phi_506_: u32;
    var phi_508_: texture_Axis;

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
                phi_226_ = 1f;
            } else {
                phi_226_ = 0f;
            }
            let _e101 = phi_226_;
            if (param_1 < 8388608f) {
                phi_231_ = (_e98 - _e101);
                phi_232_ = false;
            } else {
                phi_231_ = f32();
                phi_232_ = true;
            }
            let _e104 = phi_231_;
            let _e106 = phi_232_;
            phi_233_ = _e104;
            phi_234_ = _e106;
        } else {
            phi_233_ = f32();
            phi_234_ = true;
        }
        let _e108 = phi_233_;
        let _e110 = phi_234_;
        if _e110 {
            phi_238_ = param_1;
        } else {
            phi_238_ = _e108;
        }
        let _e112 = phi_238_;
        phi_286_ = (param_1 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_1 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_264_ = 1f;
                } else {
                    phi_264_ = 0f;
                }
                let _e130 = phi_264_;
                if (_e115 < 8388608f) {
                    phi_269_ = (_e127 - _e130);
                    phi_270_ = false;
                } else {
                    phi_269_ = f32();
                    phi_270_ = true;
                }
                let _e133 = phi_269_;
                let _e135 = phi_270_;
                phi_271_ = _e133;
                phi_272_ = _e135;
            } else {
                phi_271_ = f32();
                phi_272_ = true;
            }
            let _e137 = phi_271_;
            let _e139 = phi_272_;
            if _e139 {
                phi_276_ = _e115;
            } else {
                phi_276_ = _e137;
            }
            let _e141 = phi_276_;
            let _e143 = (param_1 - (2f * _e141));
            if (_e143 > 1f) {
                phi_284_ = (2f - _e143);
            } else {
                phi_284_ = _e143;
            }
            let _e147 = phi_284_;
            phi_285_ = _e147;
        } else {
            phi_285_ = param_1;
        }
        let _e149 = phi_285_;
        phi_286_ = _e149;
    }
    let _e151 = phi_286_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_295_ = _e151;
        } else {
            phi_295_ = 1f;
        }
        let _e155 = phi_295_;
        phi_296_ = _e155;
    } else {
        phi_296_ = 0f;
    }
    let _e157 = phi_296_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_314_ = _e158;
        } else {
            phi_314_ = _e167;
        }
        let _e170 = phi_314_;
        phi_353_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_328_ = _e72;
        } else {
            phi_328_ = _e179;
        }
        let _e182 = phi_328_;
        if (_e85 == 0u) {
            phi_335_ = _e158;
        } else {
            phi_335_ = 0u;
        }
        let _e187 = phi_335_;
        if (_e85 == 0u) {
            phi_340_ = 0u;
        } else {
            phi_340_ = _e158;
        }
        let _e190 = phi_340_;
        if (_e182 == 0u) {
            phi_346_ = _e187;
        } else {
            phi_346_ = (_e182 - 1u);
        }
        let _e194 = phi_346_;
        if (_e182 > _e158) {
            phi_351_ = _e190;
        } else {
            phi_351_ = _e182;
        }
        let _e197 = phi_351_;
        phi_353_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_353_;
    let _e202 = (*param).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_2 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e218 > param_2) {
                phi_381_ = 1f;
            } else {
                phi_381_ = 0f;
            }
            let _e221 = phi_381_;
            if (param_2 < 8388608f) {
                phi_386_ = (_e218 - _e221);
                phi_387_ = false;
            } else {
                phi_386_ = f32();
                phi_387_ = true;
            }
            let _e224 = phi_386_;
            let _e226 = phi_387_;
            phi_388_ = _e224;
            phi_389_ = _e226;
        } else {
            phi_388_ = f32();
            phi_389_ = true;
        }
        let _e228 = phi_388_;
        let _e230 = phi_389_;
        if _e230 {
            phi_393_ = param_2;
        } else {
            phi_393_ = _e228;
        }
        let _e232 = phi_393_;
        phi_441_ = (param_2 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_2 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_419_ = 1f;
                } else {
                    phi_419_ = 0f;
                }
                let _e250 = phi_419_;
                if (_e235 < 8388608f) {
                    phi_424_ = (_e247 - _e250);
                    phi_425_ = false;
                } else {
                    phi_424_ = f32();
                    phi_425_ = true;
                }
                let _e253 = phi_424_;
                let _e255 = phi_425_;
                phi_426_ = _e253;
                phi_427_ = _e255;
            } else {
                phi_426_ = f32();
                phi_427_ = true;
            }
            let _e257 = phi_426_;
            let _e259 = phi_427_;
            if _e259 {
                phi_431_ = _e235;
            } else {
                phi_431_ = _e257;
            }
            let _e261 = phi_431_;
            let _e263 = (param_2 - (2f * _e261));
            if (_e263 > 1f) {
                phi_439_ = (2f - _e263);
            } else {
                phi_439_ = _e263;
            }
            let _e267 = phi_439_;
            phi_440_ = _e267;
        } else {
            phi_440_ = param_2;
        }
        let _e269 = phi_440_;
        phi_441_ = _e269;
    }
    let _e271 = phi_441_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_450_ = _e271;
        } else {
            phi_450_ = 1f;
        }
        let _e275 = phi_450_;
        phi_451_ = _e275;
    } else {
        phi_451_ = 0f;
    }
    let _e277 = phi_451_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_469_ = _e278;
        } else {
            phi_469_ = _e287;
        }
        let _e290 = phi_469_;
        phi_508_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_483_ = _e76;
        } else {
            phi_483_ = _e299;
        }
        let _e302 = phi_483_;
        if (_e205 == 0u) {
            phi_490_ = _e278;
        } else {
            phi_490_ = 0u;
        }
        let _e307 = phi_490_;
        if (_e205 == 0u) {
            phi_495_ = 0u;
        } else {
            phi_495_ = _e278;
        }
        let _e310 = phi_495_;
        if (_e302 == 0u) {
            phi_501_ = _e307;
        } else {
            phi_501_ = (_e302 - 1u);
        }
        let _e314 = phi_501_;
        if (_e302 > _e278) {
            phi_506_ = _e310;
        } else {
            phi_506_ = _e302;
        }
        let _e317 = phi_506_;
        phi_508_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_508_;
    let _e324 = (*param).offset;
    let _e331 = (*param).offset;
    let _e338 = (*param).offset;
    let _e345 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_567_: bool;
    var phi_571_: f32;

    if (param_3 != param_3) {
        phi_567_ = true;
    } else {
        let _e70 = (param_4 >= param_3);
        if _e70 {
        }
        phi_567_ = _e70;
    }
    let _e72 = phi_567_;
    if _e72 {
        phi_571_ = param_4;
    } else {
        phi_571_ = param_3;
    }
    let _e74 = phi_571_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_583_: bool;
    var phi_587_: f32;

    if (param_5 != param_5) {
        phi_583_ = true;
    } else {
        let _e70 = (param_6 <= param_5);
        if _e70 {
        }
        phi_583_ = _e70;
    }
    let _e72 = phi_583_;
    if _e72 {
        phi_587_ = param_6;
    } else {
        phi_587_ = param_5;
    }
    let _e74 = phi_587_;
    return _e74;
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
    var phi_1494_: vec3<f32>;
    var phi_1495_: vec3<f32>;
    var phi_1524_: vec3<f32>;
    var phi_1525_: vec3<f32>;
    var phi_1554_: vec3<f32>;
    var phi_1555_: vec3<f32>;
    var phi_1573_: bool;
    var phi_1574_: bool;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1580_: f32;
    var phi_1581_: f32;
    var phi_1589_: f32;
    var phi_1599_: bool;
    var phi_1600_: bool;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1615_: f32;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1630_: f32;
    var phi_1631_: f32;
    var phi_1632_: f32;
    var phi_1633_: f32;
    var phi_1641_: f32;
    var phi_1656_: f32;
    var phi_1657_: bool;
    var phi_1658_: f32;
    var phi_1659_: bool;
    var phi_1660_: f32;
    var phi_1661_: bool;
    var phi_1679_: f32;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: f32;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1688_: bool;
    var phi_1689_: f32;
    var phi_1690_: bool;
    var phi_1718_: vec3<f32>;
    var phi_1719_: vec3<f32>;
    var phi_1744_: vec3<f32>;
    var phi_1745_: vec3<f32>;
    var phi_1770_: vec3<f32>;
    var phi_1771_: vec3<f32>;
    var phi_1827_: f32;
    var phi_1836_: f32;
    var phi_1845_: f32;
    var phi_1854_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1881_: f32;
    var phi_1890_: f32;
    var phi_1899_: f32;
    var phi_1908_: f32;
    var phi_1915_: f32;
    var phi_1922_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1949_: f32;
    var phi_1957_: f32;
    var phi_1962_: f32;
    var phi_1967_: f32;
    var phi_1979_: f32;
    var phi_1984_: f32;
    var phi_1989_: f32;
    var phi_1994_: f32;
    var phi_1999_: lt_bvh_triangle_Intersection;
    var phi_2000_: bool;
    var phi_2001_: lt_bvh_triangle_Intersection;
    var phi_2002_: bool;
    var phi_2006_: lt_bvh_triangle_Intersection;
    var phi_2007_: bool;
    var phi_2008_: lt_bvh_triangle_Intersection;
    var phi_2009_: bool;
    var phi_2010_: bool;
    var phi_2014_: bool;
    var phi_2018_: lt_bvh_triangle_Intersection;
    var phi_2232_: f32;
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
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_1450_: u32;
    var phi_2257_: bool;
    var phi_2258_: bool;
    var phi_2259_: bool;
    var local_5: bool;
    var phi_2301_: bool;
    var phi_2302_: bool;
    var phi_2333_: u32;
    var phi_2334_: u32;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var phi_1120_: u32;
    var phi_2337_: bool;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var phi_2340_: bool;
    var local_6: bool;
    var phi_2344_: bool;
    var phi_2345_: bool;
    var phi_2349_: bool;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2355_: bool;
    var phi_2356_: bool;
    var phi_2360_: bool;
    var phi_2364_: f32;
    var phi_2385_: u32;
    var phi_2400_: u32;
    var phi_2405_: u32;
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
                phi_2354_ = bool();
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
                loop {
                    let _e525 = phi_1119_;
                    if (_e525 != 4294967295u) {
                        if (_e525 < _e76) {
                        } else {
                            return;
                        }
                        let _e532 = nodes.member[(0u + _e525)].frame[3u];
                        let _e557 = (bitcast<f32>((((_e532 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e558 = (bitcast<f32>((((_e532 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e559 = (bitcast<f32>((((_e532 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e562 = nodes.member[(0u + _e525)].frame[0u];
                        let _e566 = nodes.member[(0u + _e525)].frame[1u];
                        let _e570 = nodes.member[(0u + _e525)].frame[2u];
                        let _e575 = ((bitcast<f32>(_e562) - _e130) * _e289);
                        let _e576 = ((bitcast<f32>(_e566) - _e132) * _e299);
                        let _e577 = ((bitcast<f32>(_e570) - _e134) * _e309);
                        let _e585 = nodes.member[(0u + _e525)].x;
                        if (_e289 < 0f) {
                            let _e596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e585.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e596.unnamed.root, _e585.w), _e596.unnamed_1);
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e602.unnamed, lt_bvh_traverse_Tree(_e585.x, _e602.unnamed_1.first_primitive));
                            phi_1200_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e608.unnamed, lt_bvh_traverse_Tree(_e608.unnamed_1.root, _e585.y));
                        } else {
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e585.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.unnamed.root, _e585.y), _e624.unnamed_1);
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_bvh_traverse_Tree(_e585.z, _e630.unnamed_1.first_primitive));
                            phi_1200_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e636.unnamed, lt_bvh_traverse_Tree(_e636.unnamed_1.root, _e585.w));
                        }
                        let _e644 = phi_1200_;
                        let _e654 = nodes.member[(0u + _e525)].y;
                        if (_e299 < 0f) {
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e665.unnamed.root, _e654.w), _e665.unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e654.x, _e671.unnamed_1.first_primitive));
                            phi_1227_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_bvh_traverse_Tree(_e677.unnamed_1.root, _e654.y));
                        } else {
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.unnamed.root, _e654.y), _e693.unnamed_1);
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_bvh_traverse_Tree(_e654.z, _e699.unnamed_1.first_primitive));
                            phi_1227_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_bvh_traverse_Tree(_e705.unnamed_1.root, _e654.w));
                        }
                        let _e713 = phi_1227_;
                        let _e723 = nodes.member[(0u + _e525)].z;
                        if (_e309 < 0f) {
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e734.unnamed.root, _e723.w), _e734.unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e723.x, _e740.unnamed_1.first_primitive));
                            phi_1254_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_bvh_traverse_Tree(_e746.unnamed_1.root, _e723.y));
                        } else {
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e762.unnamed.root, _e723.y), _e762.unnamed_1);
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_bvh_traverse_Tree(_e723.z, _e768.unnamed_1.first_primitive));
                            phi_1254_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_bvh_traverse_Tree(_e774.unnamed_1.root, _e723.w));
                        }
                        let _e782 = phi_1254_;
                        phi_1260_ = 0u;
                        phi_1263_ = 0u;
                        loop {
                            let _e792 = phi_1260_;
                            let _e794 = phi_1263_;
                            local_2 = _e794;
                            local_3 = _e794;
                            local_4 = _e794;
                            let _e795 = (_e792 < 8u);
                            if _e795 {
                                let _e797 = (_e792 >> bitcast<u32>(2i));
                                let _e798 = (_e792 & 3u);
                                if (_e797 == 0u) {
                                    phi_1277_ = _e644.unnamed.root;
                                } else {
                                    phi_1277_ = _e644.unnamed.first_primitive;
                                }
                                let _e801 = phi_1277_;
                                if (_e797 == 0u) {
                                    phi_1287_ = _e713.unnamed.root;
                                } else {
                                    phi_1287_ = _e713.unnamed.first_primitive;
                                }
                                let _e810 = phi_1287_;
                                if (_e797 == 0u) {
                                    phi_1297_ = _e782.unnamed.root;
                                } else {
                                    phi_1297_ = _e782.unnamed.first_primitive;
                                }
                                let _e819 = phi_1297_;
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e801 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e337)), ((f32(((_e810 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e338)));
                                let _e833 = core_intrinsics_maximum_number_nsz_f32_(_e832, ((f32(((_e819 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e339)));
                                if (_e797 == 0u) {
                                    phi_1315_ = _e644.unnamed_1.root;
                                } else {
                                    phi_1315_ = _e644.unnamed_1.first_primitive;
                                }
                                let _e836 = phi_1315_;
                                if (_e797 == 0u) {
                                    phi_1325_ = _e713.unnamed_1.root;
                                } else {
                                    phi_1325_ = _e713.unnamed_1.first_primitive;
                                }
                                let _e845 = phi_1325_;
                                if (_e797 == 0u) {
                                    phi_1335_ = _e782.unnamed_1.root;
                                } else {
                                    phi_1335_ = _e782.unnamed_1.first_primitive;
                                }
                                let _e854 = phi_1335_;
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e836 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e337)), ((f32(((_e845 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e338)));
                                let _e868 = core_intrinsics_minimum_number_nsz_f32_(_e867, ((f32(((_e854 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e339)));
                                if (_e833 <= _e868) {
                                    if (_e833 <= _e140) {
                                        if (_e868 >= 0f) {
                                            if (_e797 == 0u) {
                                                let _e875 = nodes.member[(0u + _e525)].links[2u];
                                                phi_1371_ = _e875;
                                            } else {
                                                let _e878 = nodes.member[(0u + _e525)].links[3u];
                                                phi_1371_ = _e878;
                                            }
                                            let _e880 = phi_1371_;
                                            let _e885 = ((_e880 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u);
                                            let _e886 = (_e885 & 31u);
                                            if (_e886 >= 24u) {
                                                phi_1384_ = (24u + ((_e886 - 24u) ^ _e387));
                                            } else {
                                                phi_1384_ = _e886;
                                            }
                                            let _e892 = phi_1384_;
                                            phi_1389_ = (_e794 | ((_e885 >> bitcast<u32>(5i)) << bitcast<u32>((_e892 & 31u))));
                                        } else {
                                            phi_1389_ = _e794;
                                        }
                                        let _e900 = phi_1389_;
                                        phi_1390_ = _e900;
                                    } else {
                                        phi_1390_ = _e794;
                                    }
                                    let _e902 = phi_1390_;
                                    phi_1391_ = _e902;
                                } else {
                                    phi_1391_ = _e794;
                                }
                                let _e904 = phi_1391_;
                                phi_1261_ = (_e792 + 1u);
                                phi_1264_ = _e904;
                            } else {
                                phi_1261_ = u32();
                                phi_1264_ = u32();
                            }
                            let _e907 = phi_1261_;
                            let _e909 = phi_1264_;
                            continue;
                            continuing {
                                phi_1260_ = _e907;
                                phi_1263_ = _e909;
                                break if !(_e795);
                            }
                        }
                        let _e913 = nodes.member[(0u + _e525)].links[0u];
                        let _e917 = nodes.member[(0u + _e525)].frame[3u];
                        let _e921 = local_2;
                        if ((_e921 & 4278190080u) == 0u) {
                        } else {
                            let _e925 = local_1.group_mask;
                            if ((_e925 & 4278190080u) == 0u) {
                            } else {
                                let _e929 = local_1.len;
                                if (_e929 < 32u) {
                                    let _e932 = local_1.group;
                                    let _e934 = local_1.len;
                                    if (_e934 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e934)] = _e932;
                                    let _e940 = local_1.group_mask;
                                    let _e942 = local_1.len;
                                    if (_e942 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e942)] = _e940;
                                    let _e949 = local_1.len;
                                    local_1.len = (_e949 + 1u);
                                }
                            }
                            local_1.group = (0u + _e913);
                            let _e953 = local_3;
                            local_1.group_mask = ((_e953 & 4278190080u) | (_e917 >> bitcast<u32>(24i)));
                        }
                        let _e958 = local_4;
                        phi_1449_ = (_e958 & 16777215u);
                        loop {
                            let _e961 = phi_1449_;
                            let _e962 = (_e961 == 0u);
                            local_5 = _e962;
                            local_9 = _e962;
                            if _e962 {
                                phi_1450_ = u32();
                                phi_2257_ = false;
                                phi_2258_ = false;
                                phi_2259_ = false;
                            } else {
                                let _e965 = nodes.member[(0u + _e525)].links[1u];
                                let _e970 = ((0u + _e965) + select(firstTrailingBit(_e961), 32u, (_e961 == 0u)));
                                if (_e970 < _e79) {
                                } else {
                                    return;
                                }
                                let _e977 = triangles.member[(0u + _e970)].v0_;
                                let _e979 = (_e977.x - _e130);
                                let _e981 = (_e977.y - _e132);
                                let _e983 = (_e977.z - _e134);
                                if (_e360 == 0u) {
                                    phi_1495_ = vec3<f32>(_e981, _e983, _e979);
                                } else {
                                    if (_e360 == 1u) {
                                        phi_1494_ = vec3<f32>(_e983, _e979, _e981);
                                    } else {
                                        phi_1494_ = (_e977 - vec3<f32>(_e130, _e132, _e134));
                                    }
                                    let _e991 = phi_1494_;
                                    phi_1495_ = _e991;
                                }
                                let _e993 = phi_1495_;
                                let _e997 = (_e993.x - (_e371 * _e993.z));
                                let _e1001 = (_e993.y - (_e374 * _e993.z));
                                let _e1003 = triangles.member[(0u + _e970)].v1_;
                                let _e1005 = (_e1003.x - _e130);
                                let _e1007 = (_e1003.y - _e132);
                                let _e1009 = (_e1003.z - _e134);
                                if (_e360 == 0u) {
                                    phi_1525_ = vec3<f32>(_e1007, _e1009, _e1005);
                                } else {
                                    if (_e360 == 1u) {
                                        phi_1524_ = vec3<f32>(_e1009, _e1005, _e1007);
                                    } else {
                                        phi_1524_ = (_e1003 - vec3<f32>(_e130, _e132, _e134));
                                    }
                                    let _e1017 = phi_1524_;
                                    phi_1525_ = _e1017;
                                }
                                let _e1019 = phi_1525_;
                                let _e1023 = (_e1019.x - (_e371 * _e1019.z));
                                let _e1027 = (_e1019.y - (_e374 * _e1019.z));
                                let _e1029 = triangles.member[(0u + _e970)].v2_;
                                let _e1031 = (_e1029.x - _e130);
                                let _e1033 = (_e1029.y - _e132);
                                let _e1035 = (_e1029.z - _e134);
                                if (_e360 == 0u) {
                                    phi_1555_ = vec3<f32>(_e1033, _e1035, _e1031);
                                } else {
                                    if (_e360 == 1u) {
                                        phi_1554_ = vec3<f32>(_e1035, _e1031, _e1033);
                                    } else {
                                        phi_1554_ = (_e1029 - vec3<f32>(_e130, _e132, _e134));
                                    }
                                    let _e1043 = phi_1554_;
                                    phi_1555_ = _e1043;
                                }
                                let _e1045 = phi_1555_;
                                let _e1049 = (_e1045.x - (_e371 * _e1045.z));
                                let _e1053 = (_e1045.y - (_e374 * _e1045.z));
                                if (_e1023 < _e1049) {
                                    phi_1574_ = true;
                                } else {
                                    if (_e1023 == _e1049) {
                                        phi_1573_ = (_e1027 < _e1053);
                                    } else {
                                        phi_1573_ = false;
                                    }
                                    let _e1058 = phi_1573_;
                                    phi_1574_ = _e1058;
                                }
                                let _e1060 = phi_1574_;
                                if _e1060 {
                                    phi_1578_ = _e1053;
                                    phi_1579_ = _e1049;
                                    phi_1580_ = _e1027;
                                    phi_1581_ = _e1023;
                                } else {
                                    phi_1578_ = _e1027;
                                    phi_1579_ = _e1023;
                                    phi_1580_ = _e1053;
                                    phi_1581_ = _e1049;
                                }
                                let _e1062 = phi_1578_;
                                let _e1064 = phi_1579_;
                                let _e1066 = phi_1580_;
                                let _e1068 = phi_1581_;
                                let _e1071 = ((_e1068 * _e1062) - (_e1066 * _e1064));
                                if _e1060 {
                                    phi_1589_ = -(_e1071);
                                } else {
                                    phi_1589_ = _e1071;
                                }
                                let _e1074 = phi_1589_;
                                if (_e1049 < _e997) {
                                    phi_1600_ = true;
                                } else {
                                    if (_e1049 == _e997) {
                                        phi_1599_ = (_e1053 < _e1001);
                                    } else {
                                        phi_1599_ = false;
                                    }
                                    let _e1079 = phi_1599_;
                                    phi_1600_ = _e1079;
                                }
                                let _e1081 = phi_1600_;
                                if _e1081 {
                                    phi_1604_ = _e1001;
                                    phi_1605_ = _e997;
                                    phi_1606_ = _e1053;
                                    phi_1607_ = _e1049;
                                } else {
                                    phi_1604_ = _e1053;
                                    phi_1605_ = _e1049;
                                    phi_1606_ = _e1001;
                                    phi_1607_ = _e997;
                                }
                                let _e1083 = phi_1604_;
                                let _e1085 = phi_1605_;
                                let _e1087 = phi_1606_;
                                let _e1089 = phi_1607_;
                                let _e1092 = ((_e1089 * _e1083) - (_e1087 * _e1085));
                                if _e1081 {
                                    phi_1615_ = -(_e1092);
                                } else {
                                    phi_1615_ = _e1092;
                                }
                                let _e1095 = phi_1615_;
                                if (_e997 < _e1023) {
                                    phi_1626_ = true;
                                } else {
                                    if (_e997 == _e1023) {
                                        phi_1625_ = (_e1001 < _e1027);
                                    } else {
                                        phi_1625_ = false;
                                    }
                                    let _e1100 = phi_1625_;
                                    phi_1626_ = _e1100;
                                }
                                let _e1102 = phi_1626_;
                                if _e1102 {
                                    phi_1630_ = _e1027;
                                    phi_1631_ = _e1023;
                                    phi_1632_ = _e1001;
                                    phi_1633_ = _e997;
                                } else {
                                    phi_1630_ = _e1001;
                                    phi_1631_ = _e997;
                                    phi_1632_ = _e1027;
                                    phi_1633_ = _e1023;
                                }
                                let _e1104 = phi_1630_;
                                let _e1106 = phi_1631_;
                                let _e1108 = phi_1632_;
                                let _e1110 = phi_1633_;
                                let _e1113 = ((_e1110 * _e1104) - (_e1108 * _e1106));
                                if _e1102 {
                                    phi_1641_ = -(_e1113);
                                } else {
                                    phi_1641_ = _e1113;
                                }
                                let _e1116 = phi_1641_;
                                if (_e1074 >= 0f) {
                                    if (_e1095 >= 0f) {
                                        if (_e1116 >= 0f) {
                                            phi_1656_ = ((_e1074 + _e1095) + _e1116);
                                            phi_1657_ = false;
                                        } else {
                                            phi_1656_ = f32();
                                            phi_1657_ = true;
                                        }
                                        let _e1123 = phi_1656_;
                                        let _e1125 = phi_1657_;
                                        phi_1658_ = _e1123;
                                        phi_1659_ = _e1125;
                                    } else {
                                        phi_1658_ = f32();
                                        phi_1659_ = true;
                                    }
                                    let _e1127 = phi_1658_;
                                    let _e1129 = phi_1659_;
                                    phi_1660_ = _e1127;
                                    phi_1661_ = _e1129;
                                } else {
                                    phi_1660_ = f32();
                                    phi_1661_ = true;
                                }
                                let _e1131 = phi_1660_;
                                let _e1133 = phi_1661_;
                                if _e1133 {
                                    if (_e1074 <= 0f) {
                                        if (_e1095 <= 0f) {
                                            let _e1136 = (_e1116 <= 0f);
                                            if _e1136 {
                                            }
                                            phi_1679_ = ((_e1074 + _e1095) + _e1116);
                                            phi_1680_ = false;
                                            phi_1681_ = _e1136;
                                        } else {
                                            phi_1679_ = f32();
                                            phi_1680_ = true;
                                            phi_1681_ = false;
                                        }
                                        let _e1140 = phi_1679_;
                                        let _e1142 = phi_1680_;
                                        let _e1144 = phi_1681_;
                                        phi_1682_ = _e1140;
                                        phi_1683_ = _e1142;
                                        phi_1684_ = _e1144;
                                    } else {
                                        phi_1682_ = f32();
                                        phi_1683_ = true;
                                        phi_1684_ = false;
                                    }
                                    let _e1146 = phi_1682_;
                                    let _e1148 = phi_1683_;
                                    let _e1150 = phi_1684_;
                                    if _e1148 {
                                        phi_1688_ = false;
                                    } else {
                                        phi_1688_ = _e1150;
                                    }
                                    let _e1152 = phi_1688_;
                                    phi_1689_ = _e1146;
                                    phi_1690_ = _e1152;
                                } else {
                                    phi_1689_ = _e1131;
                                    phi_1690_ = true;
                                }
                                let _e1154 = phi_1689_;
                                let _e1156 = phi_1690_;
                                if _e1156 {
                                    let _e1157 = (_e1154 == 0f);
                                    if _e1157 {
                                        phi_2006_ = lt_bvh_triangle_Intersection();
                                        phi_2007_ = false;
                                    } else {
                                        let _e1159 = triangles.member[(0u + _e970)].v0_;
                                        let _e1161 = (_e1159.x - _e130);
                                        let _e1163 = (_e1159.y - _e132);
                                        let _e1165 = (_e1159.z - _e134);
                                        if (_e360 == 0u) {
                                            phi_1719_ = vec3<f32>(_e1163, _e1165, _e1161);
                                        } else {
                                            if (_e360 == 1u) {
                                                phi_1718_ = vec3<f32>(_e1165, _e1161, _e1163);
                                            } else {
                                                phi_1718_ = (_e1159 - vec3<f32>(_e130, _e132, _e134));
                                            }
                                            let _e1173 = phi_1718_;
                                            phi_1719_ = _e1173;
                                        }
                                        let _e1175 = phi_1719_;
                                        let _e1177 = triangles.member[(0u + _e970)].v1_;
                                        let _e1179 = triangles.member[(0u + _e970)].v0_;
                                        let _e1182 = (_e1177.x - _e1179.x);
                                        let _e1185 = (_e1177.y - _e1179.y);
                                        let _e1188 = (_e1177.z - _e1179.z);
                                        if (_e360 == 0u) {
                                            phi_1745_ = vec3<f32>(_e1185, _e1188, _e1182);
                                        } else {
                                            if (_e360 == 1u) {
                                                phi_1744_ = vec3<f32>(_e1188, _e1182, _e1185);
                                            } else {
                                                phi_1744_ = (_e1177 - _e1179);
                                            }
                                            let _e1195 = phi_1744_;
                                            phi_1745_ = _e1195;
                                        }
                                        let _e1197 = phi_1745_;
                                        let _e1199 = triangles.member[(0u + _e970)].v2_;
                                        let _e1201 = triangles.member[(0u + _e970)].v0_;
                                        let _e1204 = (_e1199.x - _e1201.x);
                                        let _e1207 = (_e1199.y - _e1201.y);
                                        let _e1210 = (_e1199.z - _e1201.z);
                                        if (_e360 == 0u) {
                                            phi_1771_ = vec3<f32>(_e1207, _e1210, _e1204);
                                        } else {
                                            if (_e360 == 1u) {
                                                phi_1770_ = vec3<f32>(_e1210, _e1204, _e1207);
                                            } else {
                                                phi_1770_ = (_e1199 - _e1201);
                                            }
                                            let _e1217 = phi_1770_;
                                            phi_1771_ = _e1217;
                                        }
                                        let _e1219 = phi_1771_;
                                        let _e1226 = ((_e1197.y * _e1219.z) - (_e1197.z * _e1219.y));
                                        let _e1233 = ((_e1197.z * _e1219.x) - (_e1197.x * _e1219.z));
                                        let _e1240 = ((_e1197.x * _e1219.y) - (_e1197.y * _e1219.x));
                                        let _e1254 = (((1f / _e368.z) * (((_e1226 * _e1175.x) + (_e1233 * _e1175.y)) + (_e1240 * _e1175.z))) / (((_e1226 * _e371) + (_e1233 * _e374)) + _e1240));
                                        if (_e1254 > 0f) {
                                            if (_e1254 < _e140) {
                                                let _e1258 = triangles.member[(0u + _e970)].v0_;
                                                let _e1260 = triangles.member[(0u + _e970)].v1_;
                                                if (_e1258.x < _e1260.x) {
                                                    phi_1827_ = _e1258.x;
                                                } else {
                                                    phi_1827_ = _e1260.x;
                                                }
                                                let _e1267 = phi_1827_;
                                                if (_e1258.y < _e1260.y) {
                                                    phi_1836_ = _e1258.y;
                                                } else {
                                                    phi_1836_ = _e1260.y;
                                                }
                                                let _e1274 = phi_1836_;
                                                if (_e1258.z < _e1260.z) {
                                                    phi_1845_ = _e1258.z;
                                                } else {
                                                    phi_1845_ = _e1260.z;
                                                }
                                                let _e1281 = phi_1845_;
                                                let _e1283 = triangles.member[(0u + _e970)].v2_;
                                                if (_e1267 < _e1283.x) {
                                                    phi_1854_ = _e1267;
                                                } else {
                                                    phi_1854_ = _e1283.x;
                                                }
                                                let _e1288 = phi_1854_;
                                                if (_e1274 < _e1283.y) {
                                                    phi_1861_ = _e1274;
                                                } else {
                                                    phi_1861_ = _e1283.y;
                                                }
                                                let _e1293 = phi_1861_;
                                                if (_e1281 < _e1283.z) {
                                                    phi_1868_ = _e1281;
                                                } else {
                                                    phi_1868_ = _e1283.z;
                                                }
                                                let _e1298 = phi_1868_;
                                                let _e1300 = triangles.member[(0u + _e970)].v0_;
                                                let _e1302 = triangles.member[(0u + _e970)].v1_;
                                                if (_e1300.x > _e1302.x) {
                                                    phi_1881_ = _e1300.x;
                                                } else {
                                                    phi_1881_ = _e1302.x;
                                                }
                                                let _e1309 = phi_1881_;
                                                if (_e1300.y > _e1302.y) {
                                                    phi_1890_ = _e1300.y;
                                                } else {
                                                    phi_1890_ = _e1302.y;
                                                }
                                                let _e1316 = phi_1890_;
                                                if (_e1300.z > _e1302.z) {
                                                    phi_1899_ = _e1300.z;
                                                } else {
                                                    phi_1899_ = _e1302.z;
                                                }
                                                let _e1323 = phi_1899_;
                                                let _e1325 = triangles.member[(0u + _e970)].v2_;
                                                if (_e1309 > _e1325.x) {
                                                    phi_1908_ = _e1309;
                                                } else {
                                                    phi_1908_ = _e1325.x;
                                                }
                                                let _e1330 = phi_1908_;
                                                if (_e1316 > _e1325.y) {
                                                    phi_1915_ = _e1316;
                                                } else {
                                                    phi_1915_ = _e1325.y;
                                                }
                                                let _e1335 = phi_1915_;
                                                if (_e1323 > _e1325.z) {
                                                    phi_1922_ = _e1323;
                                                } else {
                                                    phi_1922_ = _e1325.z;
                                                }
                                                let _e1340 = phi_1922_;
                                                let _e1344 = ((_e1288 - _e130) * _e289);
                                                let _e1345 = ((_e1293 - _e132) * _e299);
                                                let _e1346 = ((_e1298 - _e134) * _e309);
                                                let _e1350 = ((_e1330 - _e130) * _e289);
                                                let _e1351 = ((_e1335 - _e132) * _e299);
                                                let _e1352 = ((_e1340 - _e134) * _e309);
                                                if (_e1344 < _e1350) {
                                                    phi_1939_ = _e1344;
                                                } else {
                                                    phi_1939_ = _e1350;
                                                }
                                                let _e1355 = phi_1939_;
                                                if (_e1345 < _e1351) {
                                                    phi_1944_ = _e1345;
                                                } else {
                                                    phi_1944_ = _e1351;
                                                }
                                                let _e1358 = phi_1944_;
                                                if (_e1346 < _e1352) {
                                                    phi_1949_ = _e1346;
                                                } else {
                                                    phi_1949_ = _e1352;
                                                }
                                                let _e1361 = phi_1949_;
                                                if (_e1344 > _e1350) {
                                                    phi_1957_ = _e1344;
                                                } else {
                                                    phi_1957_ = _e1350;
                                                }
                                                let _e1367 = phi_1957_;
                                                if (_e1345 > _e1351) {
                                                    phi_1962_ = _e1345;
                                                } else {
                                                    phi_1962_ = _e1351;
                                                }
                                                let _e1370 = phi_1962_;
                                                if (_e1346 > _e1352) {
                                                    phi_1967_ = _e1346;
                                                } else {
                                                    phi_1967_ = _e1352;
                                                }
                                                let _e1373 = phi_1967_;
                                                let _e1377 = core_intrinsics_maximum_number_nsz_f32_((_e1355 - _e344), (_e1358 - _e345));
                                                let _e1378 = core_intrinsics_maximum_number_nsz_f32_(_e1377, (_e1361 - _e346));
                                                let _e1379 = core_intrinsics_minimum_number_nsz_f32_((_e1367 + _e344), (_e1370 + _e345));
                                                let _e1380 = core_intrinsics_minimum_number_nsz_f32_(_e1379, (_e1373 + _e346));
                                                if (_e1378 > -300000000000000000000000000000000000000f) {
                                                    phi_1979_ = _e1378;
                                                } else {
                                                    phi_1979_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1383 = phi_1979_;
                                                if (_e1380 < 300000000000000000000000000000000000000f) {
                                                    phi_1984_ = _e1380;
                                                } else {
                                                    phi_1984_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1386 = phi_1984_;
                                                if (_e1254 < _e1383) {
                                                    phi_1989_ = _e1383;
                                                } else {
                                                    phi_1989_ = _e1254;
                                                }
                                                let _e1389 = phi_1989_;
                                                if (_e1389 > _e1386) {
                                                    phi_1994_ = _e1386;
                                                } else {
                                                    phi_1994_ = _e1389;
                                                }
                                                let _e1392 = phi_1994_;
                                                phi_1999_ = lt_bvh_triangle_Intersection(_e1392, (_e1095 / _e1154), (_e1116 / _e1154), (_e1383 <= _e1386));
                                                phi_2000_ = false;
                                            } else {
                                                phi_1999_ = lt_bvh_triangle_Intersection();
                                                phi_2000_ = true;
                                            }
                                            let _e1398 = phi_1999_;
                                            let _e1400 = phi_2000_;
                                            phi_2001_ = _e1398;
                                            phi_2002_ = _e1400;
                                        } else {
                                            phi_2001_ = lt_bvh_triangle_Intersection();
                                            phi_2002_ = true;
                                        }
                                        let _e1402 = phi_2001_;
                                        let _e1404 = phi_2002_;
                                        if _e1404 {
                                        }
                                        phi_2006_ = _e1402;
                                        phi_2007_ = _e1404;
                                    }
                                    let _e1406 = phi_2006_;
                                    let _e1408 = phi_2007_;
                                    phi_2008_ = _e1406;
                                    phi_2009_ = _e1157;
                                    phi_2010_ = _e1408;
                                } else {
                                    phi_2008_ = lt_bvh_triangle_Intersection();
                                    phi_2009_ = true;
                                    phi_2010_ = false;
                                }
                                let _e1410 = phi_2008_;
                                let _e1412 = phi_2009_;
                                let _e1414 = phi_2010_;
                                if _e1412 {
                                    phi_2014_ = true;
                                } else {
                                    phi_2014_ = _e1414;
                                }
                                let _e1416 = phi_2014_;
                                if _e1416 {
                                    phi_2018_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2018_ = _e1410;
                                }
                                let _e1418 = phi_2018_;
                                if _e1418.is_hit {
                                    if (_e1418.t > 0f) {
                                        if (_e1418.t < _e140) {
                                            let _e1425 = triangles.member[(0u + _e970)].i0_;
                                            let _e1427 = ((_e1425 & 2147483648u) == 0u);
                                            if _e1427 {
                                                phi_2241_ = false;
                                                phi_2242_ = false;
                                            } else {
                                                if (_e970 < _e79) {
                                                } else {
                                                    return;
                                                }
                                                let _e1434 = triangles.member[(0u + _e970)].i0_;
                                                let _e1435 = (_e1434 & 2147483647u);
                                                let _e1437 = triangles.member[(0u + _e970)].i1_;
                                                let _e1439 = triangles.member[(0u + _e970)].i2_;
                                                if (_e1435 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1443 = vertices.member[(0u + _e1435)];
                                                if (_e1437 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1447 = vertices.member[(0u + _e1437)];
                                                if (_e1439 < _e91) {
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
                                                        phi_2235_ = true;
                                                    } else {
                                                        let _e1490 = (_e1458.base_color.w * ((((f32((_e1452[0].color >> bitcast<u32>(24i))) * _e1463) + (f32((_e1452[1].color >> bitcast<u32>(24i))) * _e1418.u)) + (f32((_e1452[2].color >> bitcast<u32>(24i))) * _e1418.v)) * (1f / 255f)));
                                                        if (_e1458.alpha_size == 0u) {
                                                            phi_2232_ = _e1490;
                                                        } else {
                                                            local.offset = _e1458.alpha_offset;
                                                            local.size = _e1458.alpha_size;
                                                            local.flags = _e1458.flags;
                                                            let _e1521 = _lt_shaders_texture_TextureView_quad((&local), (((_e1452[0].u * _e1463) + (_e1452[1].u * _e1418.u)) + (_e1452[2].u * _e1418.v)), (((_e1452[0].v * _e1463) + (_e1452[1].v * _e1418.u)) + (_e1452[2].v * _e1418.v)));
                                                            let _e1525 = (_e1521.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1525 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1529 = alpha_texels.member[(0u + _e1525)];
                                                            let _e1545 = (_e1521.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1545 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1549 = alpha_texels.member[(0u + _e1545)];
                                                            let _e1566 = (_e1521.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1566 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1570 = alpha_texels.member[(0u + _e1566)];
                                                            let _e1587 = (_e1521.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1587 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1591 = alpha_texels.member[(0u + _e1587)];
                                                            phi_2232_ = (_e1490 * (((((f32(((_e1529 >> bitcast<u32>((((_e1521.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.x) + ((f32(((_e1549 >> bitcast<u32>((((_e1521.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.y)) + ((f32(((_e1570 >> bitcast<u32>((((_e1521.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.z)) + ((f32(((_e1591 >> bitcast<u32>((((_e1521.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.w)));
                                                        }
                                                        let _e1607 = phi_2232_;
                                                        phi_2235_ = (_e1607 >= _e1458.cutoff);
                                                    }
                                                    let _e1611 = phi_2235_;
                                                    phi_2236_ = _e1611;
                                                } else {
                                                    phi_2236_ = false;
                                                }
                                                let _e1613 = phi_2236_;
                                                if _e1613 {
                                                    phi_2240_ = false;
                                                } else {
                                                    phi_2240_ = true;
                                                }
                                                let _e1615 = phi_2240_;
                                                phi_2241_ = _e1615;
                                                phi_2242_ = _e1613;
                                            }
                                            let _e1617 = phi_2241_;
                                            let _e1619 = phi_2242_;
                                            phi_2243_ = _e1617;
                                            phi_2244_ = _e1427;
                                            phi_2245_ = _e1619;
                                        } else {
                                            phi_2243_ = true;
                                            phi_2244_ = false;
                                            phi_2245_ = false;
                                        }
                                        let _e1621 = phi_2243_;
                                        let _e1623 = phi_2244_;
                                        let _e1625 = phi_2245_;
                                        phi_2246_ = _e1621;
                                        phi_2247_ = _e1623;
                                        phi_2248_ = _e1625;
                                    } else {
                                        phi_2246_ = true;
                                        phi_2247_ = false;
                                        phi_2248_ = false;
                                    }
                                    let _e1627 = phi_2246_;
                                    let _e1629 = phi_2247_;
                                    let _e1631 = phi_2248_;
                                    phi_2249_ = _e1627;
                                    phi_2250_ = _e1629;
                                    phi_2251_ = _e1631;
                                } else {
                                    phi_2249_ = true;
                                    phi_2250_ = false;
                                    phi_2251_ = false;
                                }
                                let _e1633 = phi_2249_;
                                let _e1635 = phi_2250_;
                                let _e1637 = phi_2251_;
                                if _e1633 {
                                    phi_2255_ = false;
                                    phi_2256_ = false;
                                } else {
                                    phi_2255_ = _e1635;
                                    phi_2256_ = _e1637;
                                }
                                let _e1639 = phi_2255_;
                                let _e1641 = phi_2256_;
                                phi_1450_ = (_e961 & (_e961 - 1u));
                                phi_2257_ = _e1633;
                                phi_2258_ = _e1639;
                                phi_2259_ = _e1641;
                            }
                            let _e1643 = phi_1450_;
                            let _e1645 = phi_2257_;
                            let _e1647 = phi_2258_;
                            let _e1649 = phi_2259_;
                            local_7 = _e1647;
                            local_8 = _e1649;
                            continue;
                            continuing {
                                phi_1449_ = _e1643;
                                break if !(_e1645);
                            }
                        }
                        let _e1652 = local_5;
                        if _e1652 {
                            let _e1654 = local_1.group_mask;
                            if ((_e1654 & 4278190080u) == 0u) {
                                let _e1658 = local_1.len;
                                if (_e1658 == 0u) {
                                    phi_2301_ = false;
                                } else {
                                    let _e1662 = local_1.len;
                                    local_1.len = (_e1662 - 1u);
                                    let _e1665 = local_1.len;
                                    if (_e1665 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1670 = local_1.first[(0u + _e1665)];
                                    local_1.group = _e1670;
                                    let _e1673 = local_1.len;
                                    if (_e1673 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1678 = local_1.mask[(0u + _e1673)];
                                    local_1.group_mask = _e1678;
                                    phi_2301_ = true;
                                }
                                let _e1681 = phi_2301_;
                                phi_2302_ = _e1681;
                            } else {
                                phi_2302_ = true;
                            }
                            let _e1683 = phi_2302_;
                            if _e1683 {
                                let _e1685 = local_1.group_mask;
                                let _e1691 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1685)), 32u, (_e1685 == 0u)));
                                let _e1695 = local_1.group_mask;
                                let _e1709 = local_1.group_mask;
                                local_1.group_mask = (_e1709 & ~((1u << bitcast<u32>((_e1691 & 31u)))));
                                let _e1712 = local_1.group;
                                phi_2333_ = (_e1712 + countOneBits(((_e1695 & ~((4294967295u << bitcast<u32>((((_e1691 - 24u) ^ _e387) & 31u))))) & 255u)));
                            } else {
                                phi_2333_ = 4294967295u;
                            }
                            let _e1715 = phi_2333_;
                            phi_2334_ = _e1715;
                            phi_2335_ = false;
                            phi_2336_ = false;
                        } else {
                            phi_2334_ = u32();
                            let _e1959 = local_7;
                            phi_2335_ = _e1959;
                            let _e1962 = local_8;
                            phi_2336_ = _e1962;
                        }
                        let _e1717 = phi_2334_;
                        let _e1719 = phi_2335_;
                        let _e1721 = phi_2336_;
                        phi_1120_ = _e1717;
                        let _e1966 = local_9;
                        phi_2337_ = _e1966;
                        phi_2338_ = false;
                        phi_2339_ = _e1719;
                        phi_2340_ = _e1721;
                    } else {
                        phi_1120_ = u32();
                        phi_2337_ = false;
                        phi_2338_ = true;
                        phi_2339_ = false;
                        phi_2340_ = false;
                    }
                    let _e1723 = phi_1120_;
                    let _e1725 = phi_2337_;
                    let _e1727 = phi_2338_;
                    let _e1729 = phi_2339_;
                    let _e1731 = phi_2340_;
                    local_6 = _e1727;
                    local_10 = _e1729;
                    local_11 = _e1731;
                    continue;
                    continuing {
                        phi_1119_ = _e1723;
                        break if !(_e1725);
                    }
                }
                let _e1734 = local_6;
                if _e1734 {
                    phi_2344_ = false;
                    phi_2345_ = false;
                } else {
                    let _e1973 = local_10;
                    phi_2344_ = _e1973;
                    let _e1976 = local_11;
                    phi_2345_ = _e1976;
                }
                let _e1736 = phi_2344_;
                let _e1738 = phi_2345_;
                if _e1736 {
                    phi_2349_ = true;
                } else {
                    phi_2349_ = _e1738;
                }
                let _e1740 = phi_2349_;
                if _e1740 {
                    phi_2353_ = true;
                } else {
                    phi_2353_ = false;
                }
                let _e1742 = phi_2353_;
                phi_2354_ = _e1742;
            }
            let _e1744 = phi_2354_;
            phi_2355_ = _e1744;
            phi_2356_ = _e213;
        } else {
            phi_2355_ = bool();
            phi_2356_ = true;
        }
        let _e1746 = phi_2355_;
        let _e1748 = phi_2356_;
        if _e1748 {
            phi_2360_ = false;
        } else {
            phi_2360_ = _e1746;
        }
        let _e1750 = phi_2360_;
        if _e1750 {
            phi_2364_ = 0f;
        } else {
            phi_2364_ = 1f;
        }
        let _e1752 = phi_2364_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e1752;
        if (_e110 < _e88) {
        } else {
            return;
        }
        let _e1759 = bits.member[(0u + _e110)];
        if ((_e1759 & 2u) == 0u) {
            phi_2385_ = (_e1759 & 1u);
        } else {
            phi_2385_ = (_e1759 & 7u);
        }
        let _e1765 = phi_2385_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        let _e1769 = visibility.member[(0u + _e110)];
        if ((_e1765 & 1u) != 0u) {
            phi_2400_ = (2u | 1u);
        } else {
            phi_2400_ = 2u;
        }
        let _e1775 = phi_2400_;
        if (_e1769 < 0.5f) {
            phi_2405_ = (_e1775 | 4u);
        } else {
            phi_2405_ = _e1775;
        }
        let _e1778 = phi_2405_;
        if (_e110 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e110)] = _e1778;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
