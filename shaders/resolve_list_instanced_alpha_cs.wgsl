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

struct type_31 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_35 {
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

struct type_39 {
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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_50 {
    member: array<lt_bvh_Instance>,
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

struct type_59 {
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

struct type_65 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(6) 
var<storage> instances: type_50;
@group(0) @binding(0) 
var<uniform> p: type_65;
@group(0) @binding(2) 
var<storage> nodes: type_59;
@group(0) @binding(3) 
var<storage> triangles: type_31;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_35;
@group(0) @binding(8) 
var<storage> materials: type_39;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_234_: f32;
    var phi_239_: f32;
    var phi_240_: bool;
    var phi_241_: f32;
    var phi_242_: bool;
    var phi_246_: f32;
    var phi_272_: f32;
    var phi_277_: f32;
    var phi_278_: bool;
    var phi_279_: f32;
    var phi_280_: bool;
    var phi_284_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_303_: f32;
    var phi_304_: f32;
    var phi_322_: u32;
    var phi_336_: u32;
    var phi_343_: u32;
    var phi_348_: u32;
    var phi_354_: u32;
    var phi_359_: u32;
    var phi_361_: texture_Axis;
    var phi_389_: f32;
    var phi_394_: f32;
    var phi_395_: bool;
    var phi_396_: f32;
    var phi_397_: bool;
    var phi_401_: f32;
    var phi_427_: f32;
    var phi_432_: f32;
    var phi_433_: bool;
    var phi_434_: f32;
    var phi_435_: bool;
    var phi_439_: f32;
    var phi_447_: f32;
    var phi_448_: f32;
    var phi_449_: f32;
    var phi_458_: f32;
    var phi_459_: f32;
    var phi_477_: u32;
    var phi_491_: u32;
    var phi_498_: u32;
    var phi_503_: u32;
    var phi_509_: u32;
    var phi_514_: u32;
    var phi_516_: texture_Axis;

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
                phi_234_ = 1f;
            } else {
                phi_234_ = 0f;
            }
            let _e100 = phi_234_;
            if (param_1 < 8388608f) {
                phi_239_ = (_e97 - _e100);
                phi_240_ = false;
            } else {
                phi_239_ = f32();
                phi_240_ = true;
            }
            let _e103 = phi_239_;
            let _e105 = phi_240_;
            phi_241_ = _e103;
            phi_242_ = _e105;
        } else {
            phi_241_ = f32();
            phi_242_ = true;
        }
        let _e107 = phi_241_;
        let _e109 = phi_242_;
        if _e109 {
            phi_246_ = param_1;
        } else {
            phi_246_ = _e107;
        }
        let _e111 = phi_246_;
        phi_294_ = (param_1 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_1 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_272_ = 1f;
                } else {
                    phi_272_ = 0f;
                }
                let _e129 = phi_272_;
                if (_e114 < 8388608f) {
                    phi_277_ = (_e126 - _e129);
                    phi_278_ = false;
                } else {
                    phi_277_ = f32();
                    phi_278_ = true;
                }
                let _e132 = phi_277_;
                let _e134 = phi_278_;
                phi_279_ = _e132;
                phi_280_ = _e134;
            } else {
                phi_279_ = f32();
                phi_280_ = true;
            }
            let _e136 = phi_279_;
            let _e138 = phi_280_;
            if _e138 {
                phi_284_ = _e114;
            } else {
                phi_284_ = _e136;
            }
            let _e140 = phi_284_;
            let _e142 = (param_1 - (2f * _e140));
            if (_e142 > 1f) {
                phi_292_ = (2f - _e142);
            } else {
                phi_292_ = _e142;
            }
            let _e146 = phi_292_;
            phi_293_ = _e146;
        } else {
            phi_293_ = param_1;
        }
        let _e148 = phi_293_;
        phi_294_ = _e148;
    }
    let _e150 = phi_294_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_303_ = _e150;
        } else {
            phi_303_ = 1f;
        }
        let _e154 = phi_303_;
        phi_304_ = _e154;
    } else {
        phi_304_ = 0f;
    }
    let _e156 = phi_304_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_322_ = _e157;
        } else {
            phi_322_ = _e166;
        }
        let _e169 = phi_322_;
        phi_361_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_336_ = _e71;
        } else {
            phi_336_ = _e178;
        }
        let _e181 = phi_336_;
        if (_e84 == 0u) {
            phi_343_ = _e157;
        } else {
            phi_343_ = 0u;
        }
        let _e186 = phi_343_;
        if (_e84 == 0u) {
            phi_348_ = 0u;
        } else {
            phi_348_ = _e157;
        }
        let _e189 = phi_348_;
        if (_e181 == 0u) {
            phi_354_ = _e186;
        } else {
            phi_354_ = (_e181 - 1u);
        }
        let _e193 = phi_354_;
        if (_e181 > _e157) {
            phi_359_ = _e189;
        } else {
            phi_359_ = _e181;
        }
        let _e196 = phi_359_;
        phi_361_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_361_;
    let _e201 = (*param).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_2 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e217 > param_2) {
                phi_389_ = 1f;
            } else {
                phi_389_ = 0f;
            }
            let _e220 = phi_389_;
            if (param_2 < 8388608f) {
                phi_394_ = (_e217 - _e220);
                phi_395_ = false;
            } else {
                phi_394_ = f32();
                phi_395_ = true;
            }
            let _e223 = phi_394_;
            let _e225 = phi_395_;
            phi_396_ = _e223;
            phi_397_ = _e225;
        } else {
            phi_396_ = f32();
            phi_397_ = true;
        }
        let _e227 = phi_396_;
        let _e229 = phi_397_;
        if _e229 {
            phi_401_ = param_2;
        } else {
            phi_401_ = _e227;
        }
        let _e231 = phi_401_;
        phi_449_ = (param_2 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_2 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_427_ = 1f;
                } else {
                    phi_427_ = 0f;
                }
                let _e249 = phi_427_;
                if (_e234 < 8388608f) {
                    phi_432_ = (_e246 - _e249);
                    phi_433_ = false;
                } else {
                    phi_432_ = f32();
                    phi_433_ = true;
                }
                let _e252 = phi_432_;
                let _e254 = phi_433_;
                phi_434_ = _e252;
                phi_435_ = _e254;
            } else {
                phi_434_ = f32();
                phi_435_ = true;
            }
            let _e256 = phi_434_;
            let _e258 = phi_435_;
            if _e258 {
                phi_439_ = _e234;
            } else {
                phi_439_ = _e256;
            }
            let _e260 = phi_439_;
            let _e262 = (param_2 - (2f * _e260));
            if (_e262 > 1f) {
                phi_447_ = (2f - _e262);
            } else {
                phi_447_ = _e262;
            }
            let _e266 = phi_447_;
            phi_448_ = _e266;
        } else {
            phi_448_ = param_2;
        }
        let _e268 = phi_448_;
        phi_449_ = _e268;
    }
    let _e270 = phi_449_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_458_ = _e270;
        } else {
            phi_458_ = 1f;
        }
        let _e274 = phi_458_;
        phi_459_ = _e274;
    } else {
        phi_459_ = 0f;
    }
    let _e276 = phi_459_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_477_ = _e277;
        } else {
            phi_477_ = _e286;
        }
        let _e289 = phi_477_;
        phi_516_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_491_ = _e75;
        } else {
            phi_491_ = _e298;
        }
        let _e301 = phi_491_;
        if (_e204 == 0u) {
            phi_498_ = _e277;
        } else {
            phi_498_ = 0u;
        }
        let _e306 = phi_498_;
        if (_e204 == 0u) {
            phi_503_ = 0u;
        } else {
            phi_503_ = _e277;
        }
        let _e309 = phi_503_;
        if (_e301 == 0u) {
            phi_509_ = _e306;
        } else {
            phi_509_ = (_e301 - 1u);
        }
        let _e313 = phi_509_;
        if (_e301 > _e277) {
            phi_514_ = _e309;
        } else {
            phi_514_ = _e301;
        }
        let _e316 = phi_514_;
        phi_516_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_516_;
    let _e323 = (*param).offset;
    let _e330 = (*param).offset;
    let _e337 = (*param).offset;
    let _e344 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_575_: bool;
    var phi_579_: f32;

    if (param_3 != param_3) {
        phi_575_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_575_ = _e69;
    }
    let _e71 = phi_575_;
    if _e71 {
        phi_579_ = param_4;
    } else {
        phi_579_ = param_3;
    }
    let _e73 = phi_579_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_591_: bool;
    var phi_595_: f32;

    if (param_5 != param_5) {
        phi_591_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_591_ = _e69;
    }
    let _e71 = phi_591_;
    if _e71 {
        phi_595_ = param_6;
    } else {
        phi_595_ = param_5;
    }
    let _e73 = phi_595_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_693_: f32;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_776_: bool;
    var phi_780_: bool;
    var phi_850_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_871_: f32;
    var phi_878_: f32;
    var phi_885_: f32;
    var phi_902_: f32;
    var phi_907_: f32;
    var phi_912_: f32;
    var phi_933_: u32;
    var phi_938_: u32;
    var phi_943_: u32;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1089_: u32;
    var phi_1091_: u32;
    var phi_1172_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1199_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1226_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1232_: u32;
    var phi_1235_: u32;
    var phi_1249_: u32;
    var phi_1259_: u32;
    var phi_1269_: u32;
    var phi_1287_: u32;
    var phi_1297_: u32;
    var phi_1307_: u32;
    var phi_1343_: u32;
    var phi_1356_: u32;
    var phi_1361_: u32;
    var phi_1362_: u32;
    var phi_1363_: u32;
    var phi_1233_: u32;
    var phi_1236_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1421_: u32;
    var phi_1471_: f32;
    var phi_1476_: f32;
    var phi_1481_: f32;
    var phi_1489_: f32;
    var phi_1494_: f32;
    var phi_1499_: f32;
    var phi_1643_: bool;
    var phi_1644_: bool;
    var phi_1645_: bool;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1670_: bool;
    var phi_1674_: bool;
    var phi_1744_: f32;
    var phi_1751_: f32;
    var phi_1758_: f32;
    var phi_1765_: f32;
    var phi_1772_: f32;
    var phi_1779_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1806_: f32;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1843_: u32;
    var phi_1844_: u32;
    var phi_1855_: vec3<f32>;
    var phi_1856_: vec3<f32>;
    var phi_1869_: u32;
    var phi_1874_: u32;
    var phi_1879_: u32;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_2025_: u32;
    var phi_2027_: u32;
    var phi_2108_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2135_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2162_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2168_: u32;
    var phi_2171_: u32;
    var phi_2185_: u32;
    var phi_2195_: u32;
    var phi_2205_: u32;
    var phi_2223_: u32;
    var phi_2233_: u32;
    var phi_2243_: u32;
    var phi_2279_: u32;
    var phi_2292_: u32;
    var phi_2297_: u32;
    var phi_2298_: u32;
    var phi_2299_: u32;
    var phi_2169_: u32;
    var phi_2172_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2357_: u32;
    var phi_2402_: vec3<f32>;
    var phi_2403_: vec3<f32>;
    var phi_2432_: vec3<f32>;
    var phi_2433_: vec3<f32>;
    var phi_2462_: vec3<f32>;
    var phi_2463_: vec3<f32>;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2486_: f32;
    var phi_2487_: f32;
    var phi_2488_: f32;
    var phi_2489_: f32;
    var phi_2497_: f32;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2512_: f32;
    var phi_2513_: f32;
    var phi_2514_: f32;
    var phi_2515_: f32;
    var phi_2523_: f32;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2538_: f32;
    var phi_2539_: f32;
    var phi_2540_: f32;
    var phi_2541_: f32;
    var phi_2549_: f32;
    var phi_2564_: f32;
    var phi_2565_: bool;
    var phi_2566_: f32;
    var phi_2567_: bool;
    var phi_2568_: f32;
    var phi_2569_: bool;
    var phi_2587_: f32;
    var phi_2588_: bool;
    var phi_2589_: bool;
    var phi_2590_: f32;
    var phi_2591_: bool;
    var phi_2592_: bool;
    var phi_2596_: bool;
    var phi_2597_: f32;
    var phi_2598_: bool;
    var phi_2626_: vec3<f32>;
    var phi_2627_: vec3<f32>;
    var phi_2652_: vec3<f32>;
    var phi_2653_: vec3<f32>;
    var phi_2678_: vec3<f32>;
    var phi_2679_: vec3<f32>;
    var phi_2735_: f32;
    var phi_2744_: f32;
    var phi_2753_: f32;
    var phi_2762_: f32;
    var phi_2769_: f32;
    var phi_2776_: f32;
    var phi_2789_: f32;
    var phi_2798_: f32;
    var phi_2807_: f32;
    var phi_2816_: f32;
    var phi_2823_: f32;
    var phi_2830_: f32;
    var phi_2847_: f32;
    var phi_2852_: f32;
    var phi_2857_: f32;
    var phi_2865_: f32;
    var phi_2870_: f32;
    var phi_2875_: f32;
    var phi_2887_: f32;
    var phi_2892_: f32;
    var phi_2897_: f32;
    var phi_2902_: f32;
    var phi_2907_: lt_bvh_triangle_Intersection;
    var phi_2908_: bool;
    var phi_2909_: lt_bvh_triangle_Intersection;
    var phi_2910_: bool;
    var phi_2914_: lt_bvh_triangle_Intersection;
    var phi_2915_: bool;
    var phi_2916_: lt_bvh_triangle_Intersection;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2922_: bool;
    var phi_2926_: lt_bvh_triangle_Intersection;
    var phi_3140_: f32;
    var phi_3143_: bool;
    var phi_3144_: bool;
    var phi_3148_: bool;
    var phi_3149_: bool;
    var phi_3150_: bool;
    var phi_3151_: bool;
    var phi_3152_: bool;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3159_: bool;
    var phi_3163_: bool;
    var phi_3164_: bool;
    var phi_2358_: u32;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var local_9: bool;
    var phi_3209_: bool;
    var phi_3210_: bool;
    var phi_3241_: u32;
    var phi_3242_: u32;
    var phi_3243_: bool;
    var phi_3244_: bool;
    var phi_2028_: u32;
    var phi_3245_: bool;
    var phi_3246_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var local_10: bool;
    var phi_3252_: bool;
    var phi_3253_: bool;
    var phi_3257_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3268_: bool;
    var phi_3272_: bool;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_1422_: u32;
    var phi_3279_: bool;
    var local_11: bool;
    var phi_3321_: bool;
    var phi_3322_: bool;
    var phi_3353_: u32;
    var phi_3354_: u32;
    var phi_1092_: u32;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var local_12: bool;
    var phi_3360_: bool;
    var phi_3364_: bool;
    var phi_3365_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3371_: bool;
    var phi_3375_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&list.member));
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
        let _e112 = p.member.root;
        if (_e110 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e117 = p.member.light;
        let _e119 = samples.member[(0u + _e110)].position;
        let _e121 = samples.member[(0u + _e110)].normal;
        let _e123 = samples.member[(0u + _e110)].magnitude;
        let _e125 = ((8f / 8388608f) * _e123);
        let _e133 = (_e119.x + (_e121.x * _e125));
        let _e135 = (_e119.y + (_e121.y * _e125));
        let _e137 = (_e119.z + (_e121.z * _e125));
        if (_e117.w == 0f) {
            phi_693_ = 300000000000000000000000000000000000000f;
        } else {
            phi_693_ = 1f;
        }
        let _e141 = phi_693_;
        let _e149 = (_e117.x - (_e133 * _e117.w));
        let _e150 = (_e117.y - (_e135 * _e117.w));
        let _e151 = (_e117.z - (_e137 * _e117.w));
        let _e155 = abs(_e149);
        let _e156 = abs(_e150);
        let _e157 = abs(_e151);
        if (abs(_e133) < 1000000000000000f) {
            if (abs(_e135) < 1000000000000000f) {
                if (abs(_e137) < 1000000000000000f) {
                    if (_e155 < 1000000000000000f) {
                        if (_e156 < 1000000000000000f) {
                            if (_e157 < 1000000000000000f) {
                                if (_e155 > 0f) {
                                    phi_750_ = bool();
                                    phi_751_ = true;
                                } else {
                                    let _e165 = (_e156 > 0f);
                                    if _e165 {
                                        phi_749_ = bool();
                                    } else {
                                        phi_749_ = (_e157 > 0f);
                                    }
                                    let _e168 = phi_749_;
                                    phi_750_ = _e168;
                                    phi_751_ = _e165;
                                }
                                let _e170 = phi_750_;
                                let _e172 = phi_751_;
                                if _e172 {
                                    phi_755_ = true;
                                } else {
                                    phi_755_ = _e170;
                                }
                                let _e174 = phi_755_;
                                phi_756_ = _e174;
                                phi_757_ = false;
                            } else {
                                phi_756_ = bool();
                                phi_757_ = true;
                            }
                            let _e176 = phi_756_;
                            let _e178 = phi_757_;
                            phi_758_ = _e176;
                            phi_759_ = false;
                            phi_760_ = _e178;
                        } else {
                            phi_758_ = bool();
                            phi_759_ = true;
                            phi_760_ = false;
                        }
                        let _e180 = phi_758_;
                        let _e182 = phi_759_;
                        let _e184 = phi_760_;
                        phi_761_ = _e180;
                        phi_762_ = _e182;
                        phi_763_ = _e184;
                    } else {
                        phi_761_ = bool();
                        phi_762_ = true;
                        phi_763_ = false;
                    }
                    let _e186 = phi_761_;
                    let _e188 = phi_762_;
                    let _e190 = phi_763_;
                    phi_764_ = _e186;
                    phi_765_ = _e188;
                    phi_766_ = _e190;
                } else {
                    phi_764_ = bool();
                    phi_765_ = true;
                    phi_766_ = false;
                }
                let _e192 = phi_764_;
                let _e194 = phi_765_;
                let _e196 = phi_766_;
                phi_767_ = _e192;
                phi_768_ = _e194;
                phi_769_ = _e196;
            } else {
                phi_767_ = bool();
                phi_768_ = true;
                phi_769_ = false;
            }
            let _e198 = phi_767_;
            let _e200 = phi_768_;
            let _e202 = phi_769_;
            phi_770_ = _e198;
            phi_771_ = _e200;
            phi_772_ = _e202;
        } else {
            phi_770_ = bool();
            phi_771_ = true;
            phi_772_ = false;
        }
        let _e204 = phi_770_;
        let _e206 = phi_771_;
        let _e208 = phi_772_;
        if _e206 {
            phi_776_ = true;
        } else {
            phi_776_ = _e208;
        }
        let _e210 = phi_776_;
        if _e210 {
            phi_780_ = false;
        } else {
            phi_780_ = _e204;
        }
        let _e212 = phi_780_;
        if _e212 {
            let _e213 = (_e112 >= _e76);
            if _e213 {
                phi_3365_ = bool();
            } else {
                if (_e112 < _e76) {
                } else {
                    return;
                }
                let _e219 = nodes.member[(0u + _e112)].frame[0u];
                let _e223 = nodes.member[(0u + _e112)].frame[1u];
                let _e227 = nodes.member[(0u + _e112)].frame[2u];
                let _e231 = nodes.member[(0u + _e112)].frame[0u];
                let _e235 = nodes.member[(0u + _e112)].frame[1u];
                let _e239 = nodes.member[(0u + _e112)].frame[2u];
                let _e243 = nodes.member[(0u + _e112)].frame[3u];
                let _e277 = core_intrinsics_maximum_number_nsz_f32_(abs(_e149), abs(_e150));
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(_e277, abs(_e151));
                let _e279 = (_e278 * 0.0000000000009094947f);
                if (abs(_e149) < _e279) {
                    phi_850_ = _e279;
                } else {
                    phi_850_ = abs(_e149);
                }
                let _e284 = phi_850_;
                if (_e149 < 0f) {
                    phi_857_ = (-1f / _e284);
                } else {
                    phi_857_ = (1f / _e284);
                }
                let _e289 = phi_857_;
                if (abs(_e150) < _e279) {
                    phi_864_ = _e279;
                } else {
                    phi_864_ = abs(_e150);
                }
                let _e294 = phi_864_;
                if (_e150 < 0f) {
                    phi_871_ = (-1f / _e294);
                } else {
                    phi_871_ = (1f / _e294);
                }
                let _e299 = phi_871_;
                if (abs(_e151) < _e279) {
                    phi_878_ = _e279;
                } else {
                    phi_878_ = abs(_e151);
                }
                let _e304 = phi_878_;
                if (_e151 < 0f) {
                    phi_885_ = (-1f / _e304);
                } else {
                    phi_885_ = (1f / _e304);
                }
                let _e309 = phi_885_;
                let _e313 = abs((bitcast<f32>(_e219) - _e133));
                let _e314 = abs((bitcast<f32>(_e223) - _e135));
                let _e315 = abs((bitcast<f32>(_e227) - _e137));
                let _e319 = abs(((bitcast<f32>(_e231) + (bitcast<f32>((((_e243 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e320 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e243 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                let _e321 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e243 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                if (_e313 > _e319) {
                    phi_902_ = _e313;
                } else {
                    phi_902_ = _e319;
                }
                let _e324 = phi_902_;
                if (_e314 > _e320) {
                    phi_907_ = _e314;
                } else {
                    phi_907_ = _e320;
                }
                let _e327 = phi_907_;
                if (_e315 > _e321) {
                    phi_912_ = _e315;
                } else {
                    phi_912_ = _e321;
                }
                let _e330 = phi_912_;
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
                if (_e289 < 0f) {
                    phi_933_ = 0u;
                } else {
                    phi_933_ = 1u;
                }
                let _e349 = phi_933_;
                if (_e299 < 0f) {
                    phi_938_ = 0u;
                } else {
                    phi_938_ = 2u;
                }
                let _e352 = phi_938_;
                if (_e309 < 0f) {
                    phi_943_ = 0u;
                } else {
                    phi_943_ = 4u;
                }
                let _e355 = phi_943_;
                let _e357 = ((_e349 | _e352) | _e355);
                let _e358 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e358.first[0], _e358.first[1], _e358.first[2], _e358.first[3], _e358.first[4], _e358.first[5], _e358.first[6], _e358.first[7], _e358.first[8], _e358.first[9], _e358.first[10], _e358.first[11], _e358.first[12], _e358.first[13], _e358.first[14], _e358.first[15], _e358.first[16], _e358.first[17], _e358.first[18], _e358.first[19], _e358.first[20], _e358.first[21], _e358.first[22], _e358.first[23], _e358.first[24], _e358.first[25], _e358.first[26], _e358.first[27], _e358.first[28], _e358.first[29], _e358.first[30], _e358.first[31]), array<u32, 32>(_e358.mask[0], _e358.mask[1], _e358.mask[2], _e358.mask[3], _e358.mask[4], _e358.mask[5], _e358.mask[6], _e358.mask[7], _e358.mask[8], _e358.mask[9], _e358.mask[10], _e358.mask[11], _e358.mask[12], _e358.mask[13], _e358.mask[14], _e358.mask[15], _e358.mask[16], _e358.mask[17], _e358.mask[18], _e358.mask[19], _e358.mask[20], _e358.mask[21], _e358.mask[22], _e358.mask[23], _e358.mask[24], _e358.mask[25], _e358.mask[26], _e358.mask[27], _e358.mask[28], _e358.mask[29], _e358.mask[30], _e358.mask[31]), _e358.len, _e358.group, _e358.group_mask);
                let _e432 = local_2.group_mask;
                if ((_e432 & 4278190080u) == 0u) {
                    let _e436 = local_2.len;
                    if (_e436 == 0u) {
                        phi_1057_ = false;
                    } else {
                        let _e440 = local_2.len;
                        local_2.len = (_e440 - 1u);
                        let _e443 = local_2.len;
                        if (_e443 < 32u) {
                        } else {
                            return;
                        }
                        let _e448 = local_2.first[(0u + _e443)];
                        local_2.group = _e448;
                        let _e451 = local_2.len;
                        if (_e451 < 32u) {
                        } else {
                            return;
                        }
                        let _e456 = local_2.mask[(0u + _e451)];
                        local_2.group_mask = _e456;
                        phi_1057_ = true;
                    }
                    let _e459 = phi_1057_;
                    phi_1058_ = _e459;
                } else {
                    phi_1058_ = true;
                }
                let _e461 = phi_1058_;
                if _e461 {
                    let _e463 = local_2.group_mask;
                    let _e469 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e463)), 32u, (_e463 == 0u)));
                    let _e473 = local_2.group_mask;
                    let _e487 = local_2.group_mask;
                    local_2.group_mask = (_e487 & ~((1u << bitcast<u32>((_e469 & 31u)))));
                    let _e490 = local_2.group;
                    phi_1089_ = (_e490 + countOneBits(((_e473 & ~((4294967295u << bitcast<u32>((((_e469 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1089_ = 4294967295u;
                }
                let _e493 = phi_1089_;
                phi_1091_ = _e493;
                loop {
                    let _e495 = phi_1091_;
                    if (_e495 != 4294967295u) {
                        if (_e495 < _e76) {
                        } else {
                            return;
                        }
                        let _e502 = nodes.member[(0u + _e495)].frame[3u];
                        let _e527 = (bitcast<f32>((((_e502 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e528 = (bitcast<f32>((((_e502 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e529 = (bitcast<f32>((((_e502 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e532 = nodes.member[(0u + _e495)].frame[0u];
                        let _e536 = nodes.member[(0u + _e495)].frame[1u];
                        let _e540 = nodes.member[(0u + _e495)].frame[2u];
                        let _e545 = ((bitcast<f32>(_e532) - _e133) * _e289);
                        let _e546 = ((bitcast<f32>(_e536) - _e135) * _e299);
                        let _e547 = ((bitcast<f32>(_e540) - _e137) * _e309);
                        let _e555 = nodes.member[(0u + _e495)].x;
                        if (_e289 < 0f) {
                            let _e566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e566.unnamed.root, _e555.w), _e566.unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e572.unnamed, lt_bvh_traverse_Tree(_e555.x, _e572.unnamed_1.first_primitive));
                            phi_1172_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e578.unnamed_1.root, _e555.y));
                        } else {
                            let _e594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.unnamed.root, _e555.y), _e594.unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e600.unnamed, lt_bvh_traverse_Tree(_e555.z, _e600.unnamed_1.first_primitive));
                            phi_1172_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_bvh_traverse_Tree(_e606.unnamed_1.root, _e555.w));
                        }
                        let _e614 = phi_1172_;
                        let _e624 = nodes.member[(0u + _e495)].y;
                        if (_e299 < 0f) {
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e635.unnamed.root, _e624.w), _e635.unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_bvh_traverse_Tree(_e624.x, _e641.unnamed_1.first_primitive));
                            phi_1199_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e647.unnamed_1.root, _e624.y));
                        } else {
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.unnamed.root, _e624.y), _e663.unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e624.z, _e669.unnamed_1.first_primitive));
                            phi_1199_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e675.unnamed_1.root, _e624.w));
                        }
                        let _e683 = phi_1199_;
                        let _e693 = nodes.member[(0u + _e495)].z;
                        if (_e309 < 0f) {
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.unnamed.root, _e693.w), _e704.unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_bvh_traverse_Tree(_e693.x, _e710.unnamed_1.first_primitive));
                            phi_1226_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e716.unnamed_1.root, _e693.y));
                        } else {
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.unnamed.root, _e693.y), _e732.unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e693.z, _e738.unnamed_1.first_primitive));
                            phi_1226_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e744.unnamed_1.root, _e693.w));
                        }
                        let _e752 = phi_1226_;
                        phi_1232_ = 0u;
                        phi_1235_ = 0u;
                        loop {
                            let _e762 = phi_1232_;
                            let _e764 = phi_1235_;
                            local_3 = _e764;
                            local_4 = _e764;
                            local_5 = _e764;
                            let _e765 = (_e762 < 8u);
                            if _e765 {
                                let _e767 = (_e762 >> bitcast<u32>(2i));
                                let _e768 = (_e762 & 3u);
                                if (_e767 == 0u) {
                                    phi_1249_ = _e614.unnamed.root;
                                } else {
                                    phi_1249_ = _e614.unnamed.first_primitive;
                                }
                                let _e771 = phi_1249_;
                                if (_e767 == 0u) {
                                    phi_1259_ = _e683.unnamed.root;
                                } else {
                                    phi_1259_ = _e683.unnamed.first_primitive;
                                }
                                let _e780 = phi_1259_;
                                if (_e767 == 0u) {
                                    phi_1269_ = _e752.unnamed.root;
                                } else {
                                    phi_1269_ = _e752.unnamed.first_primitive;
                                }
                                let _e789 = phi_1269_;
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e771 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e337)), ((f32(((_e780 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e338)));
                                let _e803 = core_intrinsics_maximum_number_nsz_f32_(_e802, ((f32(((_e789 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e339)));
                                if (_e767 == 0u) {
                                    phi_1287_ = _e614.unnamed_1.root;
                                } else {
                                    phi_1287_ = _e614.unnamed_1.first_primitive;
                                }
                                let _e806 = phi_1287_;
                                if (_e767 == 0u) {
                                    phi_1297_ = _e683.unnamed_1.root;
                                } else {
                                    phi_1297_ = _e683.unnamed_1.first_primitive;
                                }
                                let _e815 = phi_1297_;
                                if (_e767 == 0u) {
                                    phi_1307_ = _e752.unnamed_1.root;
                                } else {
                                    phi_1307_ = _e752.unnamed_1.first_primitive;
                                }
                                let _e824 = phi_1307_;
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e806 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e337)), ((f32(((_e815 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e338)));
                                let _e838 = core_intrinsics_minimum_number_nsz_f32_(_e837, ((f32(((_e824 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e339)));
                                if (_e803 <= _e838) {
                                    if (_e803 <= _e141) {
                                        if (_e838 >= 0f) {
                                            if (_e767 == 0u) {
                                                let _e845 = nodes.member[(0u + _e495)].links[2u];
                                                phi_1343_ = _e845;
                                            } else {
                                                let _e848 = nodes.member[(0u + _e495)].links[3u];
                                                phi_1343_ = _e848;
                                            }
                                            let _e850 = phi_1343_;
                                            let _e855 = ((_e850 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u);
                                            let _e856 = (_e855 & 31u);
                                            if (_e856 >= 24u) {
                                                phi_1356_ = (24u + ((_e856 - 24u) ^ _e357));
                                            } else {
                                                phi_1356_ = _e856;
                                            }
                                            let _e862 = phi_1356_;
                                            phi_1361_ = (_e764 | ((_e855 >> bitcast<u32>(5i)) << bitcast<u32>((_e862 & 31u))));
                                        } else {
                                            phi_1361_ = _e764;
                                        }
                                        let _e870 = phi_1361_;
                                        phi_1362_ = _e870;
                                    } else {
                                        phi_1362_ = _e764;
                                    }
                                    let _e872 = phi_1362_;
                                    phi_1363_ = _e872;
                                } else {
                                    phi_1363_ = _e764;
                                }
                                let _e874 = phi_1363_;
                                phi_1233_ = (_e762 + 1u);
                                phi_1236_ = _e874;
                            } else {
                                phi_1233_ = u32();
                                phi_1236_ = u32();
                            }
                            let _e877 = phi_1233_;
                            let _e879 = phi_1236_;
                            continue;
                            continuing {
                                phi_1232_ = _e877;
                                phi_1235_ = _e879;
                                break if !(_e765);
                            }
                        }
                        let _e883 = nodes.member[(0u + _e495)].links[0u];
                        let _e887 = nodes.member[(0u + _e495)].frame[3u];
                        let _e891 = local_3;
                        if ((_e891 & 4278190080u) == 0u) {
                        } else {
                            let _e895 = local_2.group_mask;
                            if ((_e895 & 4278190080u) == 0u) {
                            } else {
                                let _e899 = local_2.len;
                                if (_e899 < 32u) {
                                    let _e902 = local_2.group;
                                    let _e904 = local_2.len;
                                    if (_e904 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e904)] = _e902;
                                    let _e910 = local_2.group_mask;
                                    let _e912 = local_2.len;
                                    if (_e912 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e912)] = _e910;
                                    let _e919 = local_2.len;
                                    local_2.len = (_e919 + 1u);
                                }
                            }
                            local_2.group = (_e112 + _e883);
                            let _e923 = local_4;
                            local_2.group_mask = ((_e923 & 4278190080u) | (_e887 >> bitcast<u32>(24i)));
                        }
                        let _e928 = local_5;
                        phi_1421_ = (_e928 & 16777215u);
                        loop {
                            let _e931 = phi_1421_;
                            let _e932 = (_e931 == 0u);
                            local_11 = _e932;
                            local_18 = _e932;
                            if _e932 {
                                phi_1422_ = u32();
                                phi_3279_ = false;
                            } else {
                                let _e935 = nodes.member[(0u + _e495)].links[1u];
                                let _e939 = (_e935 + select(firstTrailingBit(_e931), 32u, (_e931 == 0u)));
                                if (_e939 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e946 = instances.member[(0u + _e939)].low_world;
                                let _e948 = instances.member[(0u + _e939)].high_world;
                                let _e955 = ((_e946.x - _e133) * _e289);
                                let _e956 = ((_e946.y - _e135) * _e299);
                                let _e957 = ((_e946.z - _e137) * _e309);
                                let _e964 = ((_e948.x - _e133) * _e289);
                                let _e965 = ((_e948.y - _e135) * _e299);
                                let _e966 = ((_e948.z - _e137) * _e309);
                                if (_e955 < _e964) {
                                    phi_1471_ = _e955;
                                } else {
                                    phi_1471_ = _e964;
                                }
                                let _e969 = phi_1471_;
                                if (_e956 < _e965) {
                                    phi_1476_ = _e956;
                                } else {
                                    phi_1476_ = _e965;
                                }
                                let _e972 = phi_1476_;
                                if (_e957 < _e966) {
                                    phi_1481_ = _e957;
                                } else {
                                    phi_1481_ = _e966;
                                }
                                let _e975 = phi_1481_;
                                if (_e955 > _e964) {
                                    phi_1489_ = _e955;
                                } else {
                                    phi_1489_ = _e964;
                                }
                                let _e981 = phi_1489_;
                                if (_e956 > _e965) {
                                    phi_1494_ = _e956;
                                } else {
                                    phi_1494_ = _e965;
                                }
                                let _e984 = phi_1494_;
                                if (_e957 > _e966) {
                                    phi_1499_ = _e957;
                                } else {
                                    phi_1499_ = _e966;
                                }
                                let _e987 = phi_1499_;
                                let _e991 = core_intrinsics_maximum_number_nsz_f32_((_e969 - _e344), (_e972 - _e345));
                                let _e992 = core_intrinsics_maximum_number_nsz_f32_(_e991, (_e975 - _e346));
                                let _e993 = core_intrinsics_minimum_number_nsz_f32_((_e981 + _e344), (_e984 + _e345));
                                let _e994 = core_intrinsics_minimum_number_nsz_f32_(_e993, (_e987 + _e346));
                                if (_e992 <= _e994) {
                                    if (_e992 <= _e141) {
                                        if (_e994 >= 0f) {
                                            let _e1000 = instances.member[(0u + _e939)].world_to_object[0u];
                                            let _e1011 = ((((_e1000.x * _e133) + (_e1000.y * _e135)) + (_e1000.z * _e137)) + (_e1000.w * 1f));
                                            let _e1013 = instances.member[(0u + _e939)].world_to_object[1u];
                                            let _e1024 = ((((_e1013.x * _e133) + (_e1013.y * _e135)) + (_e1013.z * _e137)) + (_e1013.w * 1f));
                                            let _e1026 = instances.member[(0u + _e939)].world_to_object[2u];
                                            let _e1037 = ((((_e1026.x * _e133) + (_e1026.y * _e135)) + (_e1026.z * _e137)) + (_e1026.w * 1f));
                                            let _e1040 = instances.member[(0u + _e939)].world_to_object[0u];
                                            let _e1051 = ((((_e1040.x * _e149) + (_e1040.y * _e150)) + (_e1040.z * _e151)) + (_e1040.w * 0f));
                                            let _e1053 = instances.member[(0u + _e939)].world_to_object[1u];
                                            let _e1064 = ((((_e1053.x * _e149) + (_e1053.y * _e150)) + (_e1053.z * _e151)) + (_e1053.w * 0f));
                                            let _e1066 = instances.member[(0u + _e939)].world_to_object[2u];
                                            let _e1077 = ((((_e1066.x * _e149) + (_e1066.y * _e150)) + (_e1066.z * _e151)) + (_e1066.w * 0f));
                                            let _e1080 = instances.member[(0u + _e939)].root;
                                            let _e1082 = instances.member[(0u + _e939)].first_triangle;
                                            let _e1086 = abs(_e1051);
                                            let _e1087 = abs(_e1064);
                                            let _e1088 = abs(_e1077);
                                            if (abs(_e1011) < 1000000000000000f) {
                                                if (abs(_e1024) < 1000000000000000f) {
                                                    if (abs(_e1037) < 1000000000000000f) {
                                                        if (_e1086 < 1000000000000000f) {
                                                            if (_e1087 < 1000000000000000f) {
                                                                if (_e1088 < 1000000000000000f) {
                                                                    if (_e1086 > 0f) {
                                                                        phi_1644_ = bool();
                                                                        phi_1645_ = true;
                                                                    } else {
                                                                        let _e1096 = (_e1087 > 0f);
                                                                        if _e1096 {
                                                                            phi_1643_ = bool();
                                                                        } else {
                                                                            phi_1643_ = (_e1088 > 0f);
                                                                        }
                                                                        let _e1099 = phi_1643_;
                                                                        phi_1644_ = _e1099;
                                                                        phi_1645_ = _e1096;
                                                                    }
                                                                    let _e1101 = phi_1644_;
                                                                    let _e1103 = phi_1645_;
                                                                    if _e1103 {
                                                                        phi_1649_ = true;
                                                                    } else {
                                                                        phi_1649_ = _e1101;
                                                                    }
                                                                    let _e1105 = phi_1649_;
                                                                    phi_1650_ = _e1105;
                                                                    phi_1651_ = false;
                                                                } else {
                                                                    phi_1650_ = bool();
                                                                    phi_1651_ = true;
                                                                }
                                                                let _e1107 = phi_1650_;
                                                                let _e1109 = phi_1651_;
                                                                phi_1652_ = _e1107;
                                                                phi_1653_ = false;
                                                                phi_1654_ = _e1109;
                                                            } else {
                                                                phi_1652_ = bool();
                                                                phi_1653_ = true;
                                                                phi_1654_ = false;
                                                            }
                                                            let _e1111 = phi_1652_;
                                                            let _e1113 = phi_1653_;
                                                            let _e1115 = phi_1654_;
                                                            phi_1655_ = _e1111;
                                                            phi_1656_ = _e1113;
                                                            phi_1657_ = _e1115;
                                                        } else {
                                                            phi_1655_ = bool();
                                                            phi_1656_ = true;
                                                            phi_1657_ = false;
                                                        }
                                                        let _e1117 = phi_1655_;
                                                        let _e1119 = phi_1656_;
                                                        let _e1121 = phi_1657_;
                                                        phi_1658_ = _e1117;
                                                        phi_1659_ = _e1119;
                                                        phi_1660_ = _e1121;
                                                    } else {
                                                        phi_1658_ = bool();
                                                        phi_1659_ = true;
                                                        phi_1660_ = false;
                                                    }
                                                    let _e1123 = phi_1658_;
                                                    let _e1125 = phi_1659_;
                                                    let _e1127 = phi_1660_;
                                                    phi_1661_ = _e1123;
                                                    phi_1662_ = _e1125;
                                                    phi_1663_ = _e1127;
                                                } else {
                                                    phi_1661_ = bool();
                                                    phi_1662_ = true;
                                                    phi_1663_ = false;
                                                }
                                                let _e1129 = phi_1661_;
                                                let _e1131 = phi_1662_;
                                                let _e1133 = phi_1663_;
                                                phi_1664_ = _e1129;
                                                phi_1665_ = _e1131;
                                                phi_1666_ = _e1133;
                                            } else {
                                                phi_1664_ = bool();
                                                phi_1665_ = true;
                                                phi_1666_ = false;
                                            }
                                            let _e1135 = phi_1664_;
                                            let _e1137 = phi_1665_;
                                            let _e1139 = phi_1666_;
                                            if _e1137 {
                                                phi_1670_ = true;
                                            } else {
                                                phi_1670_ = _e1139;
                                            }
                                            let _e1141 = phi_1670_;
                                            if _e1141 {
                                                phi_1674_ = false;
                                            } else {
                                                phi_1674_ = _e1135;
                                            }
                                            let _e1143 = phi_1674_;
                                            if _e1143 {
                                                let _e1144 = (_e1080 >= _e76);
                                                if _e1144 {
                                                    phi_3262_ = bool();
                                                } else {
                                                    if (_e1080 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1150 = nodes.member[(0u + _e1080)].frame[0u];
                                                    let _e1154 = nodes.member[(0u + _e1080)].frame[1u];
                                                    let _e1158 = nodes.member[(0u + _e1080)].frame[2u];
                                                    let _e1162 = nodes.member[(0u + _e1080)].frame[0u];
                                                    let _e1166 = nodes.member[(0u + _e1080)].frame[1u];
                                                    let _e1170 = nodes.member[(0u + _e1080)].frame[2u];
                                                    let _e1174 = nodes.member[(0u + _e1080)].frame[3u];
                                                    let _e1208 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1051), abs(_e1064));
                                                    let _e1209 = core_intrinsics_maximum_number_nsz_f32_(_e1208, abs(_e1077));
                                                    let _e1210 = (_e1209 * 0.0000000000009094947f);
                                                    if (abs(_e1051) < _e1210) {
                                                        phi_1744_ = _e1210;
                                                    } else {
                                                        phi_1744_ = abs(_e1051);
                                                    }
                                                    let _e1215 = phi_1744_;
                                                    if (_e1051 < 0f) {
                                                        phi_1751_ = (-1f / _e1215);
                                                    } else {
                                                        phi_1751_ = (1f / _e1215);
                                                    }
                                                    let _e1220 = phi_1751_;
                                                    if (abs(_e1064) < _e1210) {
                                                        phi_1758_ = _e1210;
                                                    } else {
                                                        phi_1758_ = abs(_e1064);
                                                    }
                                                    let _e1225 = phi_1758_;
                                                    if (_e1064 < 0f) {
                                                        phi_1765_ = (-1f / _e1225);
                                                    } else {
                                                        phi_1765_ = (1f / _e1225);
                                                    }
                                                    let _e1230 = phi_1765_;
                                                    if (abs(_e1077) < _e1210) {
                                                        phi_1772_ = _e1210;
                                                    } else {
                                                        phi_1772_ = abs(_e1077);
                                                    }
                                                    let _e1235 = phi_1772_;
                                                    if (_e1077 < 0f) {
                                                        phi_1779_ = (-1f / _e1235);
                                                    } else {
                                                        phi_1779_ = (1f / _e1235);
                                                    }
                                                    let _e1240 = phi_1779_;
                                                    let _e1244 = abs((bitcast<f32>(_e1150) - _e1011));
                                                    let _e1245 = abs((bitcast<f32>(_e1154) - _e1024));
                                                    let _e1246 = abs((bitcast<f32>(_e1158) - _e1037));
                                                    let _e1250 = abs(((bitcast<f32>(_e1162) + (bitcast<f32>((((_e1174 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1011));
                                                    let _e1251 = abs(((bitcast<f32>(_e1166) + (bitcast<f32>((((_e1174 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1024));
                                                    let _e1252 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1174 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1037));
                                                    if (_e1244 > _e1250) {
                                                        phi_1796_ = _e1244;
                                                    } else {
                                                        phi_1796_ = _e1250;
                                                    }
                                                    let _e1255 = phi_1796_;
                                                    if (_e1245 > _e1251) {
                                                        phi_1801_ = _e1245;
                                                    } else {
                                                        phi_1801_ = _e1251;
                                                    }
                                                    let _e1258 = phi_1801_;
                                                    if (_e1246 > _e1252) {
                                                        phi_1806_ = _e1246;
                                                    } else {
                                                        phi_1806_ = _e1252;
                                                    }
                                                    let _e1261 = phi_1806_;
                                                    let _e1262 = core_intrinsics_maximum_number_nsz_f32_(_e1255, _e1258);
                                                    let _e1263 = core_intrinsics_maximum_number_nsz_f32_(_e1262, _e1261);
                                                    let _e1267 = (_e1263 * 0.0000019073486f);
                                                    let _e1268 = (abs(_e1220) * _e1267);
                                                    let _e1269 = (abs(_e1230) * _e1267);
                                                    let _e1270 = (abs(_e1240) * _e1267);
                                                    let _e1274 = (_e1263 * 0.0000009536743f);
                                                    let _e1275 = (abs(_e1220) * _e1274);
                                                    let _e1276 = (abs(_e1230) * _e1274);
                                                    let _e1277 = (abs(_e1240) * _e1274);
                                                    let _e1278 = abs(_e1051);
                                                    let _e1279 = abs(_e1064);
                                                    let _e1280 = abs(_e1077);
                                                    if (_e1278 >= _e1279) {
                                                        if (_e1278 >= _e1280) {
                                                            phi_1834_ = false;
                                                        } else {
                                                            phi_1834_ = true;
                                                        }
                                                        let _e1284 = phi_1834_;
                                                        phi_1835_ = _e1284;
                                                    } else {
                                                        phi_1835_ = true;
                                                    }
                                                    let _e1286 = phi_1835_;
                                                    if _e1286 {
                                                        if (_e1279 >= _e1280) {
                                                            phi_1843_ = 1u;
                                                        } else {
                                                            phi_1843_ = 2u;
                                                        }
                                                        let _e1289 = phi_1843_;
                                                        phi_1844_ = _e1289;
                                                    } else {
                                                        phi_1844_ = 0u;
                                                    }
                                                    let _e1291 = phi_1844_;
                                                    if (_e1291 == 0u) {
                                                        phi_1856_ = vec3<f32>(_e1064, _e1077, _e1051);
                                                    } else {
                                                        if (_e1291 == 1u) {
                                                            phi_1855_ = vec3<f32>(_e1077, _e1051, _e1064);
                                                        } else {
                                                            phi_1855_ = vec3<f32>(_e1051, _e1064, _e1077);
                                                        }
                                                        let _e1297 = phi_1855_;
                                                        phi_1856_ = _e1297;
                                                    }
                                                    let _e1299 = phi_1856_;
                                                    let _e1302 = (_e1299.x / _e1299.z);
                                                    let _e1305 = (_e1299.y / _e1299.z);
                                                    if (_e1220 < 0f) {
                                                        phi_1869_ = 0u;
                                                    } else {
                                                        phi_1869_ = 1u;
                                                    }
                                                    let _e1310 = phi_1869_;
                                                    if (_e1230 < 0f) {
                                                        phi_1874_ = 0u;
                                                    } else {
                                                        phi_1874_ = 2u;
                                                    }
                                                    let _e1313 = phi_1874_;
                                                    if (_e1240 < 0f) {
                                                        phi_1879_ = 0u;
                                                    } else {
                                                        phi_1879_ = 4u;
                                                    }
                                                    let _e1316 = phi_1879_;
                                                    let _e1318 = ((_e1310 | _e1313) | _e1316);
                                                    let _e1319 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1080, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1319.first[0], _e1319.first[1], _e1319.first[2], _e1319.first[3], _e1319.first[4], _e1319.first[5], _e1319.first[6], _e1319.first[7], _e1319.first[8], _e1319.first[9], _e1319.first[10], _e1319.first[11], _e1319.first[12], _e1319.first[13], _e1319.first[14], _e1319.first[15], _e1319.first[16], _e1319.first[17], _e1319.first[18], _e1319.first[19], _e1319.first[20], _e1319.first[21], _e1319.first[22], _e1319.first[23], _e1319.first[24], _e1319.first[25], _e1319.first[26], _e1319.first[27], _e1319.first[28], _e1319.first[29], _e1319.first[30], _e1319.first[31]), array<u32, 32>(_e1319.mask[0], _e1319.mask[1], _e1319.mask[2], _e1319.mask[3], _e1319.mask[4], _e1319.mask[5], _e1319.mask[6], _e1319.mask[7], _e1319.mask[8], _e1319.mask[9], _e1319.mask[10], _e1319.mask[11], _e1319.mask[12], _e1319.mask[13], _e1319.mask[14], _e1319.mask[15], _e1319.mask[16], _e1319.mask[17], _e1319.mask[18], _e1319.mask[19], _e1319.mask[20], _e1319.mask[21], _e1319.mask[22], _e1319.mask[23], _e1319.mask[24], _e1319.mask[25], _e1319.mask[26], _e1319.mask[27], _e1319.mask[28], _e1319.mask[29], _e1319.mask[30], _e1319.mask[31]), _e1319.len, _e1319.group, _e1319.group_mask);
                                                    let _e1393 = local_1.group_mask;
                                                    if ((_e1393 & 4278190080u) == 0u) {
                                                        let _e1397 = local_1.len;
                                                        if (_e1397 == 0u) {
                                                            phi_1993_ = false;
                                                        } else {
                                                            let _e1401 = local_1.len;
                                                            local_1.len = (_e1401 - 1u);
                                                            let _e1404 = local_1.len;
                                                            if (_e1404 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1409 = local_1.first[(0u + _e1404)];
                                                            local_1.group = _e1409;
                                                            let _e1412 = local_1.len;
                                                            if (_e1412 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1417 = local_1.mask[(0u + _e1412)];
                                                            local_1.group_mask = _e1417;
                                                            phi_1993_ = true;
                                                        }
                                                        let _e1420 = phi_1993_;
                                                        phi_1994_ = _e1420;
                                                    } else {
                                                        phi_1994_ = true;
                                                    }
                                                    let _e1422 = phi_1994_;
                                                    if _e1422 {
                                                        let _e1424 = local_1.group_mask;
                                                        let _e1430 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1424)), 32u, (_e1424 == 0u)));
                                                        let _e1434 = local_1.group_mask;
                                                        let _e1448 = local_1.group_mask;
                                                        local_1.group_mask = (_e1448 & ~((1u << bitcast<u32>((_e1430 & 31u)))));
                                                        let _e1451 = local_1.group;
                                                        phi_2025_ = (_e1451 + countOneBits(((_e1434 & ~((4294967295u << bitcast<u32>((((_e1430 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2025_ = 4294967295u;
                                                    }
                                                    let _e1454 = phi_2025_;
                                                    phi_2027_ = _e1454;
                                                    loop {
                                                        let _e1456 = phi_2027_;
                                                        if (_e1456 != 4294967295u) {
                                                            if (_e1456 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1463 = nodes.member[(0u + _e1456)].frame[3u];
                                                            let _e1488 = (bitcast<f32>((((_e1463 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1220);
                                                            let _e1489 = (bitcast<f32>((((_e1463 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1230);
                                                            let _e1490 = (bitcast<f32>((((_e1463 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1240);
                                                            let _e1493 = nodes.member[(0u + _e1456)].frame[0u];
                                                            let _e1497 = nodes.member[(0u + _e1456)].frame[1u];
                                                            let _e1501 = nodes.member[(0u + _e1456)].frame[2u];
                                                            let _e1506 = ((bitcast<f32>(_e1493) - _e1011) * _e1220);
                                                            let _e1507 = ((bitcast<f32>(_e1497) - _e1024) * _e1230);
                                                            let _e1508 = ((bitcast<f32>(_e1501) - _e1037) * _e1240);
                                                            let _e1516 = nodes.member[(0u + _e1456)].x;
                                                            if (_e1220 < 0f) {
                                                                let _e1527 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1516.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1533 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1527.unnamed.root, _e1516.w), _e1527.unnamed_1);
                                                                let _e1539 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1533.unnamed, lt_bvh_traverse_Tree(_e1516.x, _e1533.unnamed_1.first_primitive));
                                                                phi_2108_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1539.unnamed, lt_bvh_traverse_Tree(_e1539.unnamed_1.root, _e1516.y));
                                                            } else {
                                                                let _e1555 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1516.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1561 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1555.unnamed.root, _e1516.y), _e1555.unnamed_1);
                                                                let _e1567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1561.unnamed, lt_bvh_traverse_Tree(_e1516.z, _e1561.unnamed_1.first_primitive));
                                                                phi_2108_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1567.unnamed, lt_bvh_traverse_Tree(_e1567.unnamed_1.root, _e1516.w));
                                                            }
                                                            let _e1575 = phi_2108_;
                                                            let _e1585 = nodes.member[(0u + _e1456)].y;
                                                            if (_e1230 < 0f) {
                                                                let _e1596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1596.unnamed.root, _e1585.w), _e1596.unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1602.unnamed, lt_bvh_traverse_Tree(_e1585.x, _e1602.unnamed_1.first_primitive));
                                                                phi_2135_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_bvh_traverse_Tree(_e1608.unnamed_1.root, _e1585.y));
                                                            } else {
                                                                let _e1624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1624.unnamed.root, _e1585.y), _e1624.unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1630.unnamed, lt_bvh_traverse_Tree(_e1585.z, _e1630.unnamed_1.first_primitive));
                                                                phi_2135_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_bvh_traverse_Tree(_e1636.unnamed_1.root, _e1585.w));
                                                            }
                                                            let _e1644 = phi_2135_;
                                                            let _e1654 = nodes.member[(0u + _e1456)].z;
                                                            if (_e1240 < 0f) {
                                                                let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1665.unnamed.root, _e1654.w), _e1665.unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1671.unnamed, lt_bvh_traverse_Tree(_e1654.x, _e1671.unnamed_1.first_primitive));
                                                                phi_2162_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_bvh_traverse_Tree(_e1677.unnamed_1.root, _e1654.y));
                                                            } else {
                                                                let _e1693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1693.unnamed.root, _e1654.y), _e1693.unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1699.unnamed, lt_bvh_traverse_Tree(_e1654.z, _e1699.unnamed_1.first_primitive));
                                                                phi_2162_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_bvh_traverse_Tree(_e1705.unnamed_1.root, _e1654.w));
                                                            }
                                                            let _e1713 = phi_2162_;
                                                            phi_2168_ = 0u;
                                                            phi_2171_ = 0u;
                                                            loop {
                                                                let _e1723 = phi_2168_;
                                                                let _e1725 = phi_2171_;
                                                                local_6 = _e1725;
                                                                local_7 = _e1725;
                                                                local_8 = _e1725;
                                                                let _e1726 = (_e1723 < 8u);
                                                                if _e1726 {
                                                                    let _e1728 = (_e1723 >> bitcast<u32>(2i));
                                                                    let _e1729 = (_e1723 & 3u);
                                                                    if (_e1728 == 0u) {
                                                                        phi_2185_ = _e1575.unnamed.root;
                                                                    } else {
                                                                        phi_2185_ = _e1575.unnamed.first_primitive;
                                                                    }
                                                                    let _e1732 = phi_2185_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2195_ = _e1644.unnamed.root;
                                                                    } else {
                                                                        phi_2195_ = _e1644.unnamed.first_primitive;
                                                                    }
                                                                    let _e1741 = phi_2195_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2205_ = _e1713.unnamed.root;
                                                                    } else {
                                                                        phi_2205_ = _e1713.unnamed.first_primitive;
                                                                    }
                                                                    let _e1750 = phi_2205_;
                                                                    let _e1763 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1732 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 - _e1268)), ((f32(((_e1741 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 - _e1269)));
                                                                    let _e1764 = core_intrinsics_maximum_number_nsz_f32_(_e1763, ((f32(((_e1750 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 - _e1270)));
                                                                    if (_e1728 == 0u) {
                                                                        phi_2223_ = _e1575.unnamed_1.root;
                                                                    } else {
                                                                        phi_2223_ = _e1575.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1767 = phi_2223_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2233_ = _e1644.unnamed_1.root;
                                                                    } else {
                                                                        phi_2233_ = _e1644.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1776 = phi_2233_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2243_ = _e1713.unnamed_1.root;
                                                                    } else {
                                                                        phi_2243_ = _e1713.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1785 = phi_2243_;
                                                                    let _e1798 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1767 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 + _e1268)), ((f32(((_e1776 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 + _e1269)));
                                                                    let _e1799 = core_intrinsics_minimum_number_nsz_f32_(_e1798, ((f32(((_e1785 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 + _e1270)));
                                                                    if (_e1764 <= _e1799) {
                                                                        if (_e1764 <= _e141) {
                                                                            if (_e1799 >= 0f) {
                                                                                if (_e1728 == 0u) {
                                                                                    let _e1806 = nodes.member[(0u + _e1456)].links[2u];
                                                                                    phi_2279_ = _e1806;
                                                                                } else {
                                                                                    let _e1809 = nodes.member[(0u + _e1456)].links[3u];
                                                                                    phi_2279_ = _e1809;
                                                                                }
                                                                                let _e1811 = phi_2279_;
                                                                                let _e1816 = ((_e1811 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u);
                                                                                let _e1817 = (_e1816 & 31u);
                                                                                if (_e1817 >= 24u) {
                                                                                    phi_2292_ = (24u + ((_e1817 - 24u) ^ _e1318));
                                                                                } else {
                                                                                    phi_2292_ = _e1817;
                                                                                }
                                                                                let _e1823 = phi_2292_;
                                                                                phi_2297_ = (_e1725 | ((_e1816 >> bitcast<u32>(5i)) << bitcast<u32>((_e1823 & 31u))));
                                                                            } else {
                                                                                phi_2297_ = _e1725;
                                                                            }
                                                                            let _e1831 = phi_2297_;
                                                                            phi_2298_ = _e1831;
                                                                        } else {
                                                                            phi_2298_ = _e1725;
                                                                        }
                                                                        let _e1833 = phi_2298_;
                                                                        phi_2299_ = _e1833;
                                                                    } else {
                                                                        phi_2299_ = _e1725;
                                                                    }
                                                                    let _e1835 = phi_2299_;
                                                                    phi_2169_ = (_e1723 + 1u);
                                                                    phi_2172_ = _e1835;
                                                                } else {
                                                                    phi_2169_ = u32();
                                                                    phi_2172_ = u32();
                                                                }
                                                                let _e1838 = phi_2169_;
                                                                let _e1840 = phi_2172_;
                                                                continue;
                                                                continuing {
                                                                    phi_2168_ = _e1838;
                                                                    phi_2171_ = _e1840;
                                                                    break if !(_e1726);
                                                                }
                                                            }
                                                            let _e1844 = nodes.member[(0u + _e1456)].links[0u];
                                                            let _e1848 = nodes.member[(0u + _e1456)].frame[3u];
                                                            let _e1852 = local_6;
                                                            if ((_e1852 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1856 = local_1.group_mask;
                                                                if ((_e1856 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1860 = local_1.len;
                                                                    if (_e1860 < 32u) {
                                                                        let _e1863 = local_1.group;
                                                                        let _e1865 = local_1.len;
                                                                        if (_e1865 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1865)] = _e1863;
                                                                        let _e1871 = local_1.group_mask;
                                                                        let _e1873 = local_1.len;
                                                                        if (_e1873 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1873)] = _e1871;
                                                                        let _e1880 = local_1.len;
                                                                        local_1.len = (_e1880 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1080 + _e1844);
                                                                let _e1884 = local_7;
                                                                local_1.group_mask = ((_e1884 & 4278190080u) | (_e1848 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1889 = local_8;
                                                            phi_2357_ = (_e1889 & 16777215u);
                                                            loop {
                                                                let _e1892 = phi_2357_;
                                                                let _e1893 = (_e1892 == 0u);
                                                                local_9 = _e1893;
                                                                local_15 = _e1893;
                                                                if _e1893 {
                                                                    phi_2358_ = u32();
                                                                    phi_3165_ = false;
                                                                    phi_3166_ = false;
                                                                    phi_3167_ = false;
                                                                } else {
                                                                    let _e1896 = nodes.member[(0u + _e1456)].links[1u];
                                                                    let _e1901 = ((_e1082 + _e1896) + select(firstTrailingBit(_e1892), 32u, (_e1892 == 0u)));
                                                                    if (_e1901 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1908 = triangles.member[(0u + _e1901)].v0_;
                                                                    let _e1910 = (_e1908.x - _e1011);
                                                                    let _e1912 = (_e1908.y - _e1024);
                                                                    let _e1914 = (_e1908.z - _e1037);
                                                                    if (_e1291 == 0u) {
                                                                        phi_2403_ = vec3<f32>(_e1912, _e1914, _e1910);
                                                                    } else {
                                                                        if (_e1291 == 1u) {
                                                                            phi_2402_ = vec3<f32>(_e1914, _e1910, _e1912);
                                                                        } else {
                                                                            phi_2402_ = (_e1908 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                        }
                                                                        let _e1922 = phi_2402_;
                                                                        phi_2403_ = _e1922;
                                                                    }
                                                                    let _e1924 = phi_2403_;
                                                                    let _e1928 = (_e1924.x - (_e1302 * _e1924.z));
                                                                    let _e1932 = (_e1924.y - (_e1305 * _e1924.z));
                                                                    let _e1934 = triangles.member[(0u + _e1901)].v1_;
                                                                    let _e1936 = (_e1934.x - _e1011);
                                                                    let _e1938 = (_e1934.y - _e1024);
                                                                    let _e1940 = (_e1934.z - _e1037);
                                                                    if (_e1291 == 0u) {
                                                                        phi_2433_ = vec3<f32>(_e1938, _e1940, _e1936);
                                                                    } else {
                                                                        if (_e1291 == 1u) {
                                                                            phi_2432_ = vec3<f32>(_e1940, _e1936, _e1938);
                                                                        } else {
                                                                            phi_2432_ = (_e1934 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                        }
                                                                        let _e1948 = phi_2432_;
                                                                        phi_2433_ = _e1948;
                                                                    }
                                                                    let _e1950 = phi_2433_;
                                                                    let _e1954 = (_e1950.x - (_e1302 * _e1950.z));
                                                                    let _e1958 = (_e1950.y - (_e1305 * _e1950.z));
                                                                    let _e1960 = triangles.member[(0u + _e1901)].v2_;
                                                                    let _e1962 = (_e1960.x - _e1011);
                                                                    let _e1964 = (_e1960.y - _e1024);
                                                                    let _e1966 = (_e1960.z - _e1037);
                                                                    if (_e1291 == 0u) {
                                                                        phi_2463_ = vec3<f32>(_e1964, _e1966, _e1962);
                                                                    } else {
                                                                        if (_e1291 == 1u) {
                                                                            phi_2462_ = vec3<f32>(_e1966, _e1962, _e1964);
                                                                        } else {
                                                                            phi_2462_ = (_e1960 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                        }
                                                                        let _e1974 = phi_2462_;
                                                                        phi_2463_ = _e1974;
                                                                    }
                                                                    let _e1976 = phi_2463_;
                                                                    let _e1980 = (_e1976.x - (_e1302 * _e1976.z));
                                                                    let _e1984 = (_e1976.y - (_e1305 * _e1976.z));
                                                                    if (_e1954 < _e1980) {
                                                                        phi_2482_ = true;
                                                                    } else {
                                                                        if (_e1954 == _e1980) {
                                                                            phi_2481_ = (_e1958 < _e1984);
                                                                        } else {
                                                                            phi_2481_ = false;
                                                                        }
                                                                        let _e1989 = phi_2481_;
                                                                        phi_2482_ = _e1989;
                                                                    }
                                                                    let _e1991 = phi_2482_;
                                                                    if _e1991 {
                                                                        phi_2486_ = _e1984;
                                                                        phi_2487_ = _e1980;
                                                                        phi_2488_ = _e1958;
                                                                        phi_2489_ = _e1954;
                                                                    } else {
                                                                        phi_2486_ = _e1958;
                                                                        phi_2487_ = _e1954;
                                                                        phi_2488_ = _e1984;
                                                                        phi_2489_ = _e1980;
                                                                    }
                                                                    let _e1993 = phi_2486_;
                                                                    let _e1995 = phi_2487_;
                                                                    let _e1997 = phi_2488_;
                                                                    let _e1999 = phi_2489_;
                                                                    let _e2002 = ((_e1999 * _e1993) - (_e1997 * _e1995));
                                                                    if _e1991 {
                                                                        phi_2497_ = -(_e2002);
                                                                    } else {
                                                                        phi_2497_ = _e2002;
                                                                    }
                                                                    let _e2005 = phi_2497_;
                                                                    if (_e1980 < _e1928) {
                                                                        phi_2508_ = true;
                                                                    } else {
                                                                        if (_e1980 == _e1928) {
                                                                            phi_2507_ = (_e1984 < _e1932);
                                                                        } else {
                                                                            phi_2507_ = false;
                                                                        }
                                                                        let _e2010 = phi_2507_;
                                                                        phi_2508_ = _e2010;
                                                                    }
                                                                    let _e2012 = phi_2508_;
                                                                    if _e2012 {
                                                                        phi_2512_ = _e1932;
                                                                        phi_2513_ = _e1928;
                                                                        phi_2514_ = _e1984;
                                                                        phi_2515_ = _e1980;
                                                                    } else {
                                                                        phi_2512_ = _e1984;
                                                                        phi_2513_ = _e1980;
                                                                        phi_2514_ = _e1932;
                                                                        phi_2515_ = _e1928;
                                                                    }
                                                                    let _e2014 = phi_2512_;
                                                                    let _e2016 = phi_2513_;
                                                                    let _e2018 = phi_2514_;
                                                                    let _e2020 = phi_2515_;
                                                                    let _e2023 = ((_e2020 * _e2014) - (_e2018 * _e2016));
                                                                    if _e2012 {
                                                                        phi_2523_ = -(_e2023);
                                                                    } else {
                                                                        phi_2523_ = _e2023;
                                                                    }
                                                                    let _e2026 = phi_2523_;
                                                                    if (_e1928 < _e1954) {
                                                                        phi_2534_ = true;
                                                                    } else {
                                                                        if (_e1928 == _e1954) {
                                                                            phi_2533_ = (_e1932 < _e1958);
                                                                        } else {
                                                                            phi_2533_ = false;
                                                                        }
                                                                        let _e2031 = phi_2533_;
                                                                        phi_2534_ = _e2031;
                                                                    }
                                                                    let _e2033 = phi_2534_;
                                                                    if _e2033 {
                                                                        phi_2538_ = _e1958;
                                                                        phi_2539_ = _e1954;
                                                                        phi_2540_ = _e1932;
                                                                        phi_2541_ = _e1928;
                                                                    } else {
                                                                        phi_2538_ = _e1932;
                                                                        phi_2539_ = _e1928;
                                                                        phi_2540_ = _e1958;
                                                                        phi_2541_ = _e1954;
                                                                    }
                                                                    let _e2035 = phi_2538_;
                                                                    let _e2037 = phi_2539_;
                                                                    let _e2039 = phi_2540_;
                                                                    let _e2041 = phi_2541_;
                                                                    let _e2044 = ((_e2041 * _e2035) - (_e2039 * _e2037));
                                                                    if _e2033 {
                                                                        phi_2549_ = -(_e2044);
                                                                    } else {
                                                                        phi_2549_ = _e2044;
                                                                    }
                                                                    let _e2047 = phi_2549_;
                                                                    if (_e2005 >= 0f) {
                                                                        if (_e2026 >= 0f) {
                                                                            if (_e2047 >= 0f) {
                                                                                phi_2564_ = ((_e2005 + _e2026) + _e2047);
                                                                                phi_2565_ = false;
                                                                            } else {
                                                                                phi_2564_ = f32();
                                                                                phi_2565_ = true;
                                                                            }
                                                                            let _e2054 = phi_2564_;
                                                                            let _e2056 = phi_2565_;
                                                                            phi_2566_ = _e2054;
                                                                            phi_2567_ = _e2056;
                                                                        } else {
                                                                            phi_2566_ = f32();
                                                                            phi_2567_ = true;
                                                                        }
                                                                        let _e2058 = phi_2566_;
                                                                        let _e2060 = phi_2567_;
                                                                        phi_2568_ = _e2058;
                                                                        phi_2569_ = _e2060;
                                                                    } else {
                                                                        phi_2568_ = f32();
                                                                        phi_2569_ = true;
                                                                    }
                                                                    let _e2062 = phi_2568_;
                                                                    let _e2064 = phi_2569_;
                                                                    if _e2064 {
                                                                        if (_e2005 <= 0f) {
                                                                            if (_e2026 <= 0f) {
                                                                                let _e2067 = (_e2047 <= 0f);
                                                                                if _e2067 {
                                                                                }
                                                                                phi_2587_ = ((_e2005 + _e2026) + _e2047);
                                                                                phi_2588_ = false;
                                                                                phi_2589_ = _e2067;
                                                                            } else {
                                                                                phi_2587_ = f32();
                                                                                phi_2588_ = true;
                                                                                phi_2589_ = false;
                                                                            }
                                                                            let _e2071 = phi_2587_;
                                                                            let _e2073 = phi_2588_;
                                                                            let _e2075 = phi_2589_;
                                                                            phi_2590_ = _e2071;
                                                                            phi_2591_ = _e2073;
                                                                            phi_2592_ = _e2075;
                                                                        } else {
                                                                            phi_2590_ = f32();
                                                                            phi_2591_ = true;
                                                                            phi_2592_ = false;
                                                                        }
                                                                        let _e2077 = phi_2590_;
                                                                        let _e2079 = phi_2591_;
                                                                        let _e2081 = phi_2592_;
                                                                        if _e2079 {
                                                                            phi_2596_ = false;
                                                                        } else {
                                                                            phi_2596_ = _e2081;
                                                                        }
                                                                        let _e2083 = phi_2596_;
                                                                        phi_2597_ = _e2077;
                                                                        phi_2598_ = _e2083;
                                                                    } else {
                                                                        phi_2597_ = _e2062;
                                                                        phi_2598_ = true;
                                                                    }
                                                                    let _e2085 = phi_2597_;
                                                                    let _e2087 = phi_2598_;
                                                                    if _e2087 {
                                                                        let _e2088 = (_e2085 == 0f);
                                                                        if _e2088 {
                                                                            phi_2914_ = lt_bvh_triangle_Intersection();
                                                                            phi_2915_ = false;
                                                                        } else {
                                                                            let _e2090 = triangles.member[(0u + _e1901)].v0_;
                                                                            let _e2092 = (_e2090.x - _e1011);
                                                                            let _e2094 = (_e2090.y - _e1024);
                                                                            let _e2096 = (_e2090.z - _e1037);
                                                                            if (_e1291 == 0u) {
                                                                                phi_2627_ = vec3<f32>(_e2094, _e2096, _e2092);
                                                                            } else {
                                                                                if (_e1291 == 1u) {
                                                                                    phi_2626_ = vec3<f32>(_e2096, _e2092, _e2094);
                                                                                } else {
                                                                                    phi_2626_ = (_e2090 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                                }
                                                                                let _e2104 = phi_2626_;
                                                                                phi_2627_ = _e2104;
                                                                            }
                                                                            let _e2106 = phi_2627_;
                                                                            let _e2108 = triangles.member[(0u + _e1901)].v1_;
                                                                            let _e2110 = triangles.member[(0u + _e1901)].v0_;
                                                                            let _e2113 = (_e2108.x - _e2110.x);
                                                                            let _e2116 = (_e2108.y - _e2110.y);
                                                                            let _e2119 = (_e2108.z - _e2110.z);
                                                                            if (_e1291 == 0u) {
                                                                                phi_2653_ = vec3<f32>(_e2116, _e2119, _e2113);
                                                                            } else {
                                                                                if (_e1291 == 1u) {
                                                                                    phi_2652_ = vec3<f32>(_e2119, _e2113, _e2116);
                                                                                } else {
                                                                                    phi_2652_ = (_e2108 - _e2110);
                                                                                }
                                                                                let _e2126 = phi_2652_;
                                                                                phi_2653_ = _e2126;
                                                                            }
                                                                            let _e2128 = phi_2653_;
                                                                            let _e2130 = triangles.member[(0u + _e1901)].v2_;
                                                                            let _e2132 = triangles.member[(0u + _e1901)].v0_;
                                                                            let _e2135 = (_e2130.x - _e2132.x);
                                                                            let _e2138 = (_e2130.y - _e2132.y);
                                                                            let _e2141 = (_e2130.z - _e2132.z);
                                                                            if (_e1291 == 0u) {
                                                                                phi_2679_ = vec3<f32>(_e2138, _e2141, _e2135);
                                                                            } else {
                                                                                if (_e1291 == 1u) {
                                                                                    phi_2678_ = vec3<f32>(_e2141, _e2135, _e2138);
                                                                                } else {
                                                                                    phi_2678_ = (_e2130 - _e2132);
                                                                                }
                                                                                let _e2148 = phi_2678_;
                                                                                phi_2679_ = _e2148;
                                                                            }
                                                                            let _e2150 = phi_2679_;
                                                                            let _e2157 = ((_e2128.y * _e2150.z) - (_e2128.z * _e2150.y));
                                                                            let _e2164 = ((_e2128.z * _e2150.x) - (_e2128.x * _e2150.z));
                                                                            let _e2171 = ((_e2128.x * _e2150.y) - (_e2128.y * _e2150.x));
                                                                            let _e2185 = (((1f / _e1299.z) * (((_e2157 * _e2106.x) + (_e2164 * _e2106.y)) + (_e2171 * _e2106.z))) / (((_e2157 * _e1302) + (_e2164 * _e1305)) + _e2171));
                                                                            if (_e2185 > 0f) {
                                                                                if (_e2185 < _e141) {
                                                                                    let _e2189 = triangles.member[(0u + _e1901)].v0_;
                                                                                    let _e2191 = triangles.member[(0u + _e1901)].v1_;
                                                                                    if (_e2189.x < _e2191.x) {
                                                                                        phi_2735_ = _e2189.x;
                                                                                    } else {
                                                                                        phi_2735_ = _e2191.x;
                                                                                    }
                                                                                    let _e2198 = phi_2735_;
                                                                                    if (_e2189.y < _e2191.y) {
                                                                                        phi_2744_ = _e2189.y;
                                                                                    } else {
                                                                                        phi_2744_ = _e2191.y;
                                                                                    }
                                                                                    let _e2205 = phi_2744_;
                                                                                    if (_e2189.z < _e2191.z) {
                                                                                        phi_2753_ = _e2189.z;
                                                                                    } else {
                                                                                        phi_2753_ = _e2191.z;
                                                                                    }
                                                                                    let _e2212 = phi_2753_;
                                                                                    let _e2214 = triangles.member[(0u + _e1901)].v2_;
                                                                                    if (_e2198 < _e2214.x) {
                                                                                        phi_2762_ = _e2198;
                                                                                    } else {
                                                                                        phi_2762_ = _e2214.x;
                                                                                    }
                                                                                    let _e2219 = phi_2762_;
                                                                                    if (_e2205 < _e2214.y) {
                                                                                        phi_2769_ = _e2205;
                                                                                    } else {
                                                                                        phi_2769_ = _e2214.y;
                                                                                    }
                                                                                    let _e2224 = phi_2769_;
                                                                                    if (_e2212 < _e2214.z) {
                                                                                        phi_2776_ = _e2212;
                                                                                    } else {
                                                                                        phi_2776_ = _e2214.z;
                                                                                    }
                                                                                    let _e2229 = phi_2776_;
                                                                                    let _e2231 = triangles.member[(0u + _e1901)].v0_;
                                                                                    let _e2233 = triangles.member[(0u + _e1901)].v1_;
                                                                                    if (_e2231.x > _e2233.x) {
                                                                                        phi_2789_ = _e2231.x;
                                                                                    } else {
                                                                                        phi_2789_ = _e2233.x;
                                                                                    }
                                                                                    let _e2240 = phi_2789_;
                                                                                    if (_e2231.y > _e2233.y) {
                                                                                        phi_2798_ = _e2231.y;
                                                                                    } else {
                                                                                        phi_2798_ = _e2233.y;
                                                                                    }
                                                                                    let _e2247 = phi_2798_;
                                                                                    if (_e2231.z > _e2233.z) {
                                                                                        phi_2807_ = _e2231.z;
                                                                                    } else {
                                                                                        phi_2807_ = _e2233.z;
                                                                                    }
                                                                                    let _e2254 = phi_2807_;
                                                                                    let _e2256 = triangles.member[(0u + _e1901)].v2_;
                                                                                    if (_e2240 > _e2256.x) {
                                                                                        phi_2816_ = _e2240;
                                                                                    } else {
                                                                                        phi_2816_ = _e2256.x;
                                                                                    }
                                                                                    let _e2261 = phi_2816_;
                                                                                    if (_e2247 > _e2256.y) {
                                                                                        phi_2823_ = _e2247;
                                                                                    } else {
                                                                                        phi_2823_ = _e2256.y;
                                                                                    }
                                                                                    let _e2266 = phi_2823_;
                                                                                    if (_e2254 > _e2256.z) {
                                                                                        phi_2830_ = _e2254;
                                                                                    } else {
                                                                                        phi_2830_ = _e2256.z;
                                                                                    }
                                                                                    let _e2271 = phi_2830_;
                                                                                    let _e2275 = ((_e2219 - _e1011) * _e1220);
                                                                                    let _e2276 = ((_e2224 - _e1024) * _e1230);
                                                                                    let _e2277 = ((_e2229 - _e1037) * _e1240);
                                                                                    let _e2281 = ((_e2261 - _e1011) * _e1220);
                                                                                    let _e2282 = ((_e2266 - _e1024) * _e1230);
                                                                                    let _e2283 = ((_e2271 - _e1037) * _e1240);
                                                                                    if (_e2275 < _e2281) {
                                                                                        phi_2847_ = _e2275;
                                                                                    } else {
                                                                                        phi_2847_ = _e2281;
                                                                                    }
                                                                                    let _e2286 = phi_2847_;
                                                                                    if (_e2276 < _e2282) {
                                                                                        phi_2852_ = _e2276;
                                                                                    } else {
                                                                                        phi_2852_ = _e2282;
                                                                                    }
                                                                                    let _e2289 = phi_2852_;
                                                                                    if (_e2277 < _e2283) {
                                                                                        phi_2857_ = _e2277;
                                                                                    } else {
                                                                                        phi_2857_ = _e2283;
                                                                                    }
                                                                                    let _e2292 = phi_2857_;
                                                                                    if (_e2275 > _e2281) {
                                                                                        phi_2865_ = _e2275;
                                                                                    } else {
                                                                                        phi_2865_ = _e2281;
                                                                                    }
                                                                                    let _e2298 = phi_2865_;
                                                                                    if (_e2276 > _e2282) {
                                                                                        phi_2870_ = _e2276;
                                                                                    } else {
                                                                                        phi_2870_ = _e2282;
                                                                                    }
                                                                                    let _e2301 = phi_2870_;
                                                                                    if (_e2277 > _e2283) {
                                                                                        phi_2875_ = _e2277;
                                                                                    } else {
                                                                                        phi_2875_ = _e2283;
                                                                                    }
                                                                                    let _e2304 = phi_2875_;
                                                                                    let _e2308 = core_intrinsics_maximum_number_nsz_f32_((_e2286 - _e1275), (_e2289 - _e1276));
                                                                                    let _e2309 = core_intrinsics_maximum_number_nsz_f32_(_e2308, (_e2292 - _e1277));
                                                                                    let _e2310 = core_intrinsics_minimum_number_nsz_f32_((_e2298 + _e1275), (_e2301 + _e1276));
                                                                                    let _e2311 = core_intrinsics_minimum_number_nsz_f32_(_e2310, (_e2304 + _e1277));
                                                                                    if (_e2309 > _e992) {
                                                                                        phi_2887_ = _e2309;
                                                                                    } else {
                                                                                        phi_2887_ = _e992;
                                                                                    }
                                                                                    let _e2314 = phi_2887_;
                                                                                    if (_e2311 < _e994) {
                                                                                        phi_2892_ = _e2311;
                                                                                    } else {
                                                                                        phi_2892_ = _e994;
                                                                                    }
                                                                                    let _e2317 = phi_2892_;
                                                                                    if (_e2185 < _e2314) {
                                                                                        phi_2897_ = _e2314;
                                                                                    } else {
                                                                                        phi_2897_ = _e2185;
                                                                                    }
                                                                                    let _e2320 = phi_2897_;
                                                                                    if (_e2320 > _e2317) {
                                                                                        phi_2902_ = _e2317;
                                                                                    } else {
                                                                                        phi_2902_ = _e2320;
                                                                                    }
                                                                                    let _e2323 = phi_2902_;
                                                                                    phi_2907_ = lt_bvh_triangle_Intersection(_e2323, (_e2026 / _e2085), (_e2047 / _e2085), (_e2314 <= _e2317));
                                                                                    phi_2908_ = false;
                                                                                } else {
                                                                                    phi_2907_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2908_ = true;
                                                                                }
                                                                                let _e2329 = phi_2907_;
                                                                                let _e2331 = phi_2908_;
                                                                                phi_2909_ = _e2329;
                                                                                phi_2910_ = _e2331;
                                                                            } else {
                                                                                phi_2909_ = lt_bvh_triangle_Intersection();
                                                                                phi_2910_ = true;
                                                                            }
                                                                            let _e2333 = phi_2909_;
                                                                            let _e2335 = phi_2910_;
                                                                            if _e2335 {
                                                                            }
                                                                            phi_2914_ = _e2333;
                                                                            phi_2915_ = _e2335;
                                                                        }
                                                                        let _e2337 = phi_2914_;
                                                                        let _e2339 = phi_2915_;
                                                                        phi_2916_ = _e2337;
                                                                        phi_2917_ = _e2088;
                                                                        phi_2918_ = _e2339;
                                                                    } else {
                                                                        phi_2916_ = lt_bvh_triangle_Intersection();
                                                                        phi_2917_ = true;
                                                                        phi_2918_ = false;
                                                                    }
                                                                    let _e2341 = phi_2916_;
                                                                    let _e2343 = phi_2917_;
                                                                    let _e2345 = phi_2918_;
                                                                    if _e2343 {
                                                                        phi_2922_ = true;
                                                                    } else {
                                                                        phi_2922_ = _e2345;
                                                                    }
                                                                    let _e2347 = phi_2922_;
                                                                    if _e2347 {
                                                                        phi_2926_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2926_ = _e2341;
                                                                    }
                                                                    let _e2349 = phi_2926_;
                                                                    if _e2349.is_hit {
                                                                        if (_e2349.t > 0f) {
                                                                            if (_e2349.t < _e141) {
                                                                                let _e2356 = triangles.member[(0u + _e1901)].i0_;
                                                                                let _e2358 = ((_e2356 & 2147483648u) == 0u);
                                                                                if _e2358 {
                                                                                    phi_3149_ = false;
                                                                                    phi_3150_ = false;
                                                                                } else {
                                                                                    if (_e1901 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2365 = triangles.member[(0u + _e1901)].i0_;
                                                                                    let _e2366 = (_e2365 & 2147483647u);
                                                                                    let _e2368 = triangles.member[(0u + _e1901)].i1_;
                                                                                    let _e2370 = triangles.member[(0u + _e1901)].i2_;
                                                                                    if (_e2366 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2374 = vertices.member[(0u + _e2366)];
                                                                                    if (_e2368 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2378 = vertices.member[(0u + _e2368)];
                                                                                    if (_e2370 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2382 = vertices.member[(0u + _e2370)];
                                                                                    let _e2383 = array<abi_Vertex, 3>(_e2374, _e2378, _e2382);
                                                                                    if (_e2383[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2389 = materials.member[(0u + _e2383[0].material)];
                                                                                    if ((_e2389.flags & 1u) == 1u) {
                                                                                        let _e2394 = ((1f - _e2349.u) - _e2349.v);
                                                                                        if (_e2389.cutoff <= 0f) {
                                                                                            phi_3143_ = true;
                                                                                        } else {
                                                                                            let _e2421 = (_e2389.base_color.w * ((((f32((_e2383[0].color >> bitcast<u32>(24i))) * _e2394) + (f32((_e2383[1].color >> bitcast<u32>(24i))) * _e2349.u)) + (f32((_e2383[2].color >> bitcast<u32>(24i))) * _e2349.v)) * (1f / 255f)));
                                                                                            if (_e2389.alpha_size == 0u) {
                                                                                                phi_3140_ = _e2421;
                                                                                            } else {
                                                                                                local.offset = _e2389.alpha_offset;
                                                                                                local.size = _e2389.alpha_size;
                                                                                                local.flags = _e2389.flags;
                                                                                                let _e2452 = _lt_shaders_texture_TextureView_quad((&local), (((_e2383[0].u * _e2394) + (_e2383[1].u * _e2349.u)) + (_e2383[2].u * _e2349.v)), (((_e2383[0].v * _e2394) + (_e2383[1].v * _e2349.u)) + (_e2383[2].v * _e2349.v)));
                                                                                                let _e2456 = (_e2452.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2456 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2460 = alpha_texels.member[(0u + _e2456)];
                                                                                                let _e2476 = (_e2452.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2476 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2480 = alpha_texels.member[(0u + _e2476)];
                                                                                                let _e2497 = (_e2452.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2497 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2501 = alpha_texels.member[(0u + _e2497)];
                                                                                                let _e2518 = (_e2452.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2518 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2522 = alpha_texels.member[(0u + _e2518)];
                                                                                                phi_3140_ = (_e2421 * (((((f32(((_e2460 >> bitcast<u32>((((_e2452.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2452.weights.x) + ((f32(((_e2480 >> bitcast<u32>((((_e2452.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2452.weights.y)) + ((f32(((_e2501 >> bitcast<u32>((((_e2452.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2452.weights.z)) + ((f32(((_e2522 >> bitcast<u32>((((_e2452.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2452.weights.w)));
                                                                                            }
                                                                                            let _e2538 = phi_3140_;
                                                                                            phi_3143_ = (_e2538 >= _e2389.cutoff);
                                                                                        }
                                                                                        let _e2542 = phi_3143_;
                                                                                        phi_3144_ = _e2542;
                                                                                    } else {
                                                                                        phi_3144_ = false;
                                                                                    }
                                                                                    let _e2544 = phi_3144_;
                                                                                    if _e2544 {
                                                                                        phi_3148_ = false;
                                                                                    } else {
                                                                                        phi_3148_ = true;
                                                                                    }
                                                                                    let _e2546 = phi_3148_;
                                                                                    phi_3149_ = _e2546;
                                                                                    phi_3150_ = _e2544;
                                                                                }
                                                                                let _e2548 = phi_3149_;
                                                                                let _e2550 = phi_3150_;
                                                                                phi_3151_ = _e2548;
                                                                                phi_3152_ = _e2358;
                                                                                phi_3153_ = _e2550;
                                                                            } else {
                                                                                phi_3151_ = true;
                                                                                phi_3152_ = false;
                                                                                phi_3153_ = false;
                                                                            }
                                                                            let _e2552 = phi_3151_;
                                                                            let _e2554 = phi_3152_;
                                                                            let _e2556 = phi_3153_;
                                                                            phi_3154_ = _e2552;
                                                                            phi_3155_ = _e2554;
                                                                            phi_3156_ = _e2556;
                                                                        } else {
                                                                            phi_3154_ = true;
                                                                            phi_3155_ = false;
                                                                            phi_3156_ = false;
                                                                        }
                                                                        let _e2558 = phi_3154_;
                                                                        let _e2560 = phi_3155_;
                                                                        let _e2562 = phi_3156_;
                                                                        phi_3157_ = _e2558;
                                                                        phi_3158_ = _e2560;
                                                                        phi_3159_ = _e2562;
                                                                    } else {
                                                                        phi_3157_ = true;
                                                                        phi_3158_ = false;
                                                                        phi_3159_ = false;
                                                                    }
                                                                    let _e2564 = phi_3157_;
                                                                    let _e2566 = phi_3158_;
                                                                    let _e2568 = phi_3159_;
                                                                    if _e2564 {
                                                                        phi_3163_ = false;
                                                                        phi_3164_ = false;
                                                                    } else {
                                                                        phi_3163_ = _e2566;
                                                                        phi_3164_ = _e2568;
                                                                    }
                                                                    let _e2570 = phi_3163_;
                                                                    let _e2572 = phi_3164_;
                                                                    phi_2358_ = (_e1892 & (_e1892 - 1u));
                                                                    phi_3165_ = _e2564;
                                                                    phi_3166_ = _e2570;
                                                                    phi_3167_ = _e2572;
                                                                }
                                                                let _e2574 = phi_2358_;
                                                                let _e2576 = phi_3165_;
                                                                let _e2578 = phi_3166_;
                                                                let _e2580 = phi_3167_;
                                                                local_13 = _e2578;
                                                                local_14 = _e2580;
                                                                continue;
                                                                continuing {
                                                                    phi_2357_ = _e2574;
                                                                    break if !(_e2576);
                                                                }
                                                            }
                                                            let _e2583 = local_9;
                                                            if _e2583 {
                                                                let _e2585 = local_1.group_mask;
                                                                if ((_e2585 & 4278190080u) == 0u) {
                                                                    let _e2589 = local_1.len;
                                                                    if (_e2589 == 0u) {
                                                                        phi_3209_ = false;
                                                                    } else {
                                                                        let _e2593 = local_1.len;
                                                                        local_1.len = (_e2593 - 1u);
                                                                        let _e2596 = local_1.len;
                                                                        if (_e2596 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2601 = local_1.first[(0u + _e2596)];
                                                                        local_1.group = _e2601;
                                                                        let _e2604 = local_1.len;
                                                                        if (_e2604 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2609 = local_1.mask[(0u + _e2604)];
                                                                        local_1.group_mask = _e2609;
                                                                        phi_3209_ = true;
                                                                    }
                                                                    let _e2612 = phi_3209_;
                                                                    phi_3210_ = _e2612;
                                                                } else {
                                                                    phi_3210_ = true;
                                                                }
                                                                let _e2614 = phi_3210_;
                                                                if _e2614 {
                                                                    let _e2616 = local_1.group_mask;
                                                                    let _e2622 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2616)), 32u, (_e2616 == 0u)));
                                                                    let _e2626 = local_1.group_mask;
                                                                    let _e2640 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2640 & ~((1u << bitcast<u32>((_e2622 & 31u)))));
                                                                    let _e2643 = local_1.group;
                                                                    phi_3241_ = (_e2643 + countOneBits(((_e2626 & ~((4294967295u << bitcast<u32>((((_e2622 - 24u) ^ _e1318) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3241_ = 4294967295u;
                                                                }
                                                                let _e2646 = phi_3241_;
                                                                phi_3242_ = _e2646;
                                                                phi_3243_ = false;
                                                                phi_3244_ = false;
                                                            } else {
                                                                phi_3242_ = u32();
                                                                let _e3032 = local_13;
                                                                phi_3243_ = _e3032;
                                                                let _e3035 = local_14;
                                                                phi_3244_ = _e3035;
                                                            }
                                                            let _e2648 = phi_3242_;
                                                            let _e2650 = phi_3243_;
                                                            let _e2652 = phi_3244_;
                                                            phi_2028_ = _e2648;
                                                            let _e3039 = local_15;
                                                            phi_3245_ = _e3039;
                                                            phi_3246_ = false;
                                                            phi_3247_ = _e2650;
                                                            phi_3248_ = _e2652;
                                                        } else {
                                                            phi_2028_ = u32();
                                                            phi_3245_ = false;
                                                            phi_3246_ = true;
                                                            phi_3247_ = false;
                                                            phi_3248_ = false;
                                                        }
                                                        let _e2654 = phi_2028_;
                                                        let _e2656 = phi_3245_;
                                                        let _e2658 = phi_3246_;
                                                        let _e2660 = phi_3247_;
                                                        let _e2662 = phi_3248_;
                                                        local_10 = _e2658;
                                                        local_16 = _e2660;
                                                        local_17 = _e2662;
                                                        continue;
                                                        continuing {
                                                            phi_2027_ = _e2654;
                                                            break if !(_e2656);
                                                        }
                                                    }
                                                    let _e2665 = local_10;
                                                    if _e2665 {
                                                        phi_3252_ = false;
                                                        phi_3253_ = false;
                                                    } else {
                                                        let _e3046 = local_16;
                                                        phi_3252_ = _e3046;
                                                        let _e3049 = local_17;
                                                        phi_3253_ = _e3049;
                                                    }
                                                    let _e2667 = phi_3252_;
                                                    let _e2669 = phi_3253_;
                                                    if _e2667 {
                                                        phi_3257_ = true;
                                                    } else {
                                                        phi_3257_ = _e2669;
                                                    }
                                                    let _e2671 = phi_3257_;
                                                    if _e2671 {
                                                        phi_3261_ = true;
                                                    } else {
                                                        phi_3261_ = false;
                                                    }
                                                    let _e2673 = phi_3261_;
                                                    phi_3262_ = _e2673;
                                                }
                                                let _e2675 = phi_3262_;
                                                phi_3263_ = _e2675;
                                                phi_3264_ = _e1144;
                                            } else {
                                                phi_3263_ = bool();
                                                phi_3264_ = true;
                                            }
                                            let _e2677 = phi_3263_;
                                            let _e2679 = phi_3264_;
                                            if _e2679 {
                                                phi_3268_ = false;
                                            } else {
                                                phi_3268_ = _e2677;
                                            }
                                            let _e2681 = phi_3268_;
                                            if _e2681 {
                                                phi_3272_ = false;
                                            } else {
                                                phi_3272_ = true;
                                            }
                                            let _e2683 = phi_3272_;
                                            phi_3273_ = _e2683;
                                        } else {
                                            phi_3273_ = true;
                                        }
                                        let _e2685 = phi_3273_;
                                        phi_3274_ = _e2685;
                                    } else {
                                        phi_3274_ = true;
                                    }
                                    let _e2687 = phi_3274_;
                                    phi_3275_ = _e2687;
                                } else {
                                    phi_3275_ = true;
                                }
                                let _e2689 = phi_3275_;
                                if _e2689 {
                                }
                                phi_1422_ = (_e931 & (_e931 - 1u));
                                phi_3279_ = _e2689;
                            }
                            let _e2691 = phi_1422_;
                            let _e2693 = phi_3279_;
                            continue;
                            continuing {
                                phi_1421_ = _e2691;
                                break if !(_e2693);
                            }
                        }
                        let _e2696 = local_11;
                        if _e2696 {
                            let _e2698 = local_2.group_mask;
                            if ((_e2698 & 4278190080u) == 0u) {
                                let _e2702 = local_2.len;
                                if (_e2702 == 0u) {
                                    phi_3321_ = false;
                                } else {
                                    let _e2706 = local_2.len;
                                    local_2.len = (_e2706 - 1u);
                                    let _e2709 = local_2.len;
                                    if (_e2709 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2714 = local_2.first[(0u + _e2709)];
                                    local_2.group = _e2714;
                                    let _e2717 = local_2.len;
                                    if (_e2717 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2722 = local_2.mask[(0u + _e2717)];
                                    local_2.group_mask = _e2722;
                                    phi_3321_ = true;
                                }
                                let _e2725 = phi_3321_;
                                phi_3322_ = _e2725;
                            } else {
                                phi_3322_ = true;
                            }
                            let _e2727 = phi_3322_;
                            if _e2727 {
                                let _e2729 = local_2.group_mask;
                                let _e2735 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2729)), 32u, (_e2729 == 0u)));
                                let _e2739 = local_2.group_mask;
                                let _e2753 = local_2.group_mask;
                                local_2.group_mask = (_e2753 & ~((1u << bitcast<u32>((_e2735 & 31u)))));
                                let _e2756 = local_2.group;
                                phi_3353_ = (_e2756 + countOneBits(((_e2739 & ~((4294967295u << bitcast<u32>((((_e2735 - 24u) ^ _e357) & 31u))))) & 255u)));
                            } else {
                                phi_3353_ = 4294967295u;
                            }
                            let _e2759 = phi_3353_;
                            phi_3354_ = _e2759;
                        } else {
                            phi_3354_ = u32();
                        }
                        let _e2761 = phi_3354_;
                        phi_1092_ = _e2761;
                        let _e3070 = local_18;
                        phi_3355_ = _e3070;
                        phi_3356_ = false;
                    } else {
                        phi_1092_ = u32();
                        phi_3355_ = false;
                        phi_3356_ = true;
                    }
                    let _e2763 = phi_1092_;
                    let _e2765 = phi_3355_;
                    let _e2767 = phi_3356_;
                    local_12 = _e2767;
                    continue;
                    continuing {
                        phi_1091_ = _e2763;
                        break if !(_e2765);
                    }
                }
                let _e2770 = local_12;
                if _e2770 {
                    phi_3360_ = false;
                } else {
                    phi_3360_ = true;
                }
                let _e2772 = phi_3360_;
                if _e2772 {
                    phi_3364_ = true;
                } else {
                    phi_3364_ = false;
                }
                let _e2774 = phi_3364_;
                phi_3365_ = _e2774;
            }
            let _e2776 = phi_3365_;
            phi_3366_ = _e2776;
            phi_3367_ = _e213;
        } else {
            phi_3366_ = bool();
            phi_3367_ = true;
        }
        let _e2778 = phi_3366_;
        let _e2780 = phi_3367_;
        if _e2780 {
            phi_3371_ = false;
        } else {
            phi_3371_ = _e2778;
        }
        let _e2782 = phi_3371_;
        if _e2782 {
            phi_3375_ = 0f;
        } else {
            phi_3375_ = 1f;
        }
        let _e2784 = phi_3375_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2784;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
