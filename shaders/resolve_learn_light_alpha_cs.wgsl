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

struct type_32 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_62 {
    member: array<vec4<u32>>,
}

struct lt_bvh_LightSpace {
    shear: vec3<f32>,
    axis: u32,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    pad: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_65 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

struct lt_bvh_LightNode {
    frame: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    rest: vec4<u32>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> rows: type_62;
@group(0) @binding(8) 
var<uniform> space: type_65;
@group(0) @binding(9) 
var<storage> vertices: type_45;
@group(0) @binding(10) 
var<storage> materials: type_49;
@group(0) @binding(11) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_231_: bool;
    var phi_235_: f32;

    if (param != param) {
        phi_231_ = true;
    } else {
        let _e83 = (param_1 >= param);
        if _e83 {
        }
        phi_231_ = _e83;
    }
    let _e85 = phi_231_;
    if _e85 {
        phi_235_ = param_1;
    } else {
        phi_235_ = param;
    }
    let _e87 = phi_235_;
    return _e87;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_2 != param_2) {
        phi_247_ = true;
    } else {
        let _e83 = (param_3 <= param_2);
        if _e83 {
        }
        phi_247_ = _e83;
    }
    let _e85 = phi_247_;
    if _e85 {
        phi_251_ = param_3;
    } else {
        phi_251_ = param_2;
    }
    let _e87 = phi_251_;
    return _e87;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_293_: f32;
    var phi_298_: f32;
    var phi_299_: bool;
    var phi_300_: f32;
    var phi_301_: bool;
    var phi_305_: f32;
    var phi_331_: f32;
    var phi_336_: f32;
    var phi_337_: bool;
    var phi_338_: f32;
    var phi_339_: bool;
    var phi_343_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_381_: u32;
    var phi_395_: u32;
    var phi_402_: u32;
    var phi_407_: u32;
    var phi_413_: u32;
    var phi_418_: u32;
    var phi_420_: texture_Axis;
    var phi_448_: f32;
    var phi_453_: f32;
    var phi_454_: bool;
    var phi_455_: f32;
    var phi_456_: bool;
    var phi_460_: f32;
    var phi_486_: f32;
    var phi_491_: f32;
    var phi_492_: bool;
    var phi_493_: f32;
    var phi_494_: bool;
    var phi_498_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_508_: f32;
    var phi_517_: f32;
    var phi_518_: f32;
    var phi_536_: u32;
    var phi_550_: u32;
    var phi_557_: u32;
    var phi_562_: u32;
    var phi_568_: u32;
    var phi_573_: u32;
    var phi_575_: texture_Axis;

    let _e84 = (*param_4).size;
    let _e85 = (_e84 & 65535u);
    let _e87 = (*param_4).size;
    let _e89 = (_e87 >> bitcast<u32>(16i));
    let _e91 = (*param_4).flags;
    let _e93 = ((_e91 & 4u) != 0u);
    let _e95 = (*param_4).flags;
    let _e98 = ((_e95 >> bitcast<u32>(4u)) & 3u);
    if (_e98 == 0u) {
        if (param_5 > -8388608f) {
            let _e111 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e111 > param_5) {
                phi_293_ = 1f;
            } else {
                phi_293_ = 0f;
            }
            let _e114 = phi_293_;
            if (param_5 < 8388608f) {
                phi_298_ = (_e111 - _e114);
                phi_299_ = false;
            } else {
                phi_298_ = f32();
                phi_299_ = true;
            }
            let _e117 = phi_298_;
            let _e119 = phi_299_;
            phi_300_ = _e117;
            phi_301_ = _e119;
        } else {
            phi_300_ = f32();
            phi_301_ = true;
        }
        let _e121 = phi_300_;
        let _e123 = phi_301_;
        if _e123 {
            phi_305_ = param_5;
        } else {
            phi_305_ = _e121;
        }
        let _e125 = phi_305_;
        phi_353_ = (param_5 - _e125);
    } else {
        if (_e98 == 1u) {
            let _e128 = (param_5 * 0.5f);
            if (_e128 > -8388608f) {
                let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
                if (_e140 > _e128) {
                    phi_331_ = 1f;
                } else {
                    phi_331_ = 0f;
                }
                let _e143 = phi_331_;
                if (_e128 < 8388608f) {
                    phi_336_ = (_e140 - _e143);
                    phi_337_ = false;
                } else {
                    phi_336_ = f32();
                    phi_337_ = true;
                }
                let _e146 = phi_336_;
                let _e148 = phi_337_;
                phi_338_ = _e146;
                phi_339_ = _e148;
            } else {
                phi_338_ = f32();
                phi_339_ = true;
            }
            let _e150 = phi_338_;
            let _e152 = phi_339_;
            if _e152 {
                phi_343_ = _e128;
            } else {
                phi_343_ = _e150;
            }
            let _e154 = phi_343_;
            let _e156 = (param_5 - (2f * _e154));
            if (_e156 > 1f) {
                phi_351_ = (2f - _e156);
            } else {
                phi_351_ = _e156;
            }
            let _e160 = phi_351_;
            phi_352_ = _e160;
        } else {
            phi_352_ = param_5;
        }
        let _e162 = phi_352_;
        phi_353_ = _e162;
    }
    let _e164 = phi_353_;
    if (_e164 > 0f) {
        if (_e164 < 1f) {
            phi_362_ = _e164;
        } else {
            phi_362_ = 1f;
        }
        let _e168 = phi_362_;
        phi_363_ = _e168;
    } else {
        phi_363_ = 0f;
    }
    let _e170 = phi_363_;
    let _e171 = (_e85 - 1u);
    let _e173 = (_e170 * f32(_e85));
    if _e93 {
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e171 < _e180) {
            phi_381_ = _e171;
        } else {
            phi_381_ = _e180;
        }
        let _e183 = phi_381_;
        phi_420_ = texture_Axis(_e183, _e183, 0f);
    } else {
        let _e185 = (_e173 + 0.5f);
        let _e192 = select(select(u32(_e185), 0u, (_e185 < bitcast<f32>(0u))), 4294967295u, (_e185 > bitcast<f32>(1333788671u)));
        if (_e85 < _e192) {
            phi_395_ = _e85;
        } else {
            phi_395_ = _e192;
        }
        let _e195 = phi_395_;
        if (_e98 == 0u) {
            phi_402_ = _e171;
        } else {
            phi_402_ = 0u;
        }
        let _e200 = phi_402_;
        if (_e98 == 0u) {
            phi_407_ = 0u;
        } else {
            phi_407_ = _e171;
        }
        let _e203 = phi_407_;
        if (_e195 == 0u) {
            phi_413_ = _e200;
        } else {
            phi_413_ = (_e195 - 1u);
        }
        let _e207 = phi_413_;
        if (_e195 > _e171) {
            phi_418_ = _e203;
        } else {
            phi_418_ = _e195;
        }
        let _e210 = phi_418_;
        phi_420_ = texture_Axis(_e207, _e210, (_e185 - f32(_e195)));
    }
    let _e213 = phi_420_;
    let _e215 = (*param_4).flags;
    let _e218 = ((_e215 >> bitcast<u32>(6u)) & 3u);
    if (_e218 == 0u) {
        if (param_6 > -8388608f) {
            let _e231 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e231 > param_6) {
                phi_448_ = 1f;
            } else {
                phi_448_ = 0f;
            }
            let _e234 = phi_448_;
            if (param_6 < 8388608f) {
                phi_453_ = (_e231 - _e234);
                phi_454_ = false;
            } else {
                phi_453_ = f32();
                phi_454_ = true;
            }
            let _e237 = phi_453_;
            let _e239 = phi_454_;
            phi_455_ = _e237;
            phi_456_ = _e239;
        } else {
            phi_455_ = f32();
            phi_456_ = true;
        }
        let _e241 = phi_455_;
        let _e243 = phi_456_;
        if _e243 {
            phi_460_ = param_6;
        } else {
            phi_460_ = _e241;
        }
        let _e245 = phi_460_;
        phi_508_ = (param_6 - _e245);
    } else {
        if (_e218 == 1u) {
            let _e248 = (param_6 * 0.5f);
            if (_e248 > -8388608f) {
                let _e260 = f32(select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < bitcast<f32>(3472883712u))), 2147483647i, (_e248 > bitcast<f32>(1325400063u))), (_e248 == _e248)));
                if (_e260 > _e248) {
                    phi_486_ = 1f;
                } else {
                    phi_486_ = 0f;
                }
                let _e263 = phi_486_;
                if (_e248 < 8388608f) {
                    phi_491_ = (_e260 - _e263);
                    phi_492_ = false;
                } else {
                    phi_491_ = f32();
                    phi_492_ = true;
                }
                let _e266 = phi_491_;
                let _e268 = phi_492_;
                phi_493_ = _e266;
                phi_494_ = _e268;
            } else {
                phi_493_ = f32();
                phi_494_ = true;
            }
            let _e270 = phi_493_;
            let _e272 = phi_494_;
            if _e272 {
                phi_498_ = _e248;
            } else {
                phi_498_ = _e270;
            }
            let _e274 = phi_498_;
            let _e276 = (param_6 - (2f * _e274));
            if (_e276 > 1f) {
                phi_506_ = (2f - _e276);
            } else {
                phi_506_ = _e276;
            }
            let _e280 = phi_506_;
            phi_507_ = _e280;
        } else {
            phi_507_ = param_6;
        }
        let _e282 = phi_507_;
        phi_508_ = _e282;
    }
    let _e284 = phi_508_;
    if (_e284 > 0f) {
        if (_e284 < 1f) {
            phi_517_ = _e284;
        } else {
            phi_517_ = 1f;
        }
        let _e288 = phi_517_;
        phi_518_ = _e288;
    } else {
        phi_518_ = 0f;
    }
    let _e290 = phi_518_;
    let _e291 = (_e89 - 1u);
    let _e293 = (_e290 * f32(_e89));
    if _e93 {
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e291 < _e300) {
            phi_536_ = _e291;
        } else {
            phi_536_ = _e300;
        }
        let _e303 = phi_536_;
        phi_575_ = texture_Axis(_e303, _e303, 0f);
    } else {
        let _e305 = (_e293 + 0.5f);
        let _e312 = select(select(u32(_e305), 0u, (_e305 < bitcast<f32>(0u))), 4294967295u, (_e305 > bitcast<f32>(1333788671u)));
        if (_e89 < _e312) {
            phi_550_ = _e89;
        } else {
            phi_550_ = _e312;
        }
        let _e315 = phi_550_;
        if (_e218 == 0u) {
            phi_557_ = _e291;
        } else {
            phi_557_ = 0u;
        }
        let _e320 = phi_557_;
        if (_e218 == 0u) {
            phi_562_ = 0u;
        } else {
            phi_562_ = _e291;
        }
        let _e323 = phi_562_;
        if (_e315 == 0u) {
            phi_568_ = _e320;
        } else {
            phi_568_ = (_e315 - 1u);
        }
        let _e327 = phi_568_;
        if (_e315 > _e291) {
            phi_573_ = _e323;
        } else {
            phi_573_ = _e315;
        }
        let _e330 = phi_573_;
        phi_575_ = texture_Axis(_e327, _e330, (_e305 - f32(_e315)));
    }
    let _e333 = phi_575_;
    let _e337 = (*param_4).offset;
    let _e344 = (*param_4).offset;
    let _e351 = (*param_4).offset;
    let _e358 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e337 + (_e333.low * _e85)) + _e213.low), ((_e344 + (_e333.low * _e85)) + _e213.high), ((_e351 + (_e333.high * _e85)) + _e213.low), ((_e358 + (_e333.high * _e85)) + _e213.high)), vec4<f32>(((1f - _e213.fraction) * (1f - _e333.fraction)), (_e213.fraction * (1f - _e333.fraction)), ((1f - _e213.fraction) * _e333.fraction), (_e213.fraction * _e333.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: texture_TextureView;
    var local_3: array<u32, 32>;
    var phi_726_: f32;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_766_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_845_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_920_: u32;
    var phi_921_: f32;
    var phi_922_: u32;
    var phi_923_: f32;
    var phi_928_: f32;
    var phi_939_: u32;
    var phi_949_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_968_: vec3<f32>;
    var phi_969_: vec3<f32>;
    var phi_991_: vec3<f32>;
    var phi_992_: vec3<f32>;
    var phi_1015_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1083_: f32;
    var phi_1090_: f32;
    var phi_1097_: f32;
    var phi_1104_: f32;
    var phi_1111_: f32;
    var phi_1118_: f32;
    var phi_1135_: f32;
    var phi_1140_: f32;
    var phi_1145_: f32;
    var phi_1150_: f32;
    var phi_1155_: f32;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1186_: u32;
    var phi_1187_: u32;
    var phi_1198_: vec3<f32>;
    var phi_1199_: vec3<f32>;
    var phi_1211_: u32;
    var phi_1214_: u32;
    var phi_1283_: f32;
    var phi_1284_: f32;
    var phi_1298_: u32;
    var phi_1321_: f32;
    var phi_1322_: f32;
    var phi_1336_: u32;
    var phi_1359_: f32;
    var phi_1360_: f32;
    var phi_1374_: u32;
    var phi_1501_: u32;
    var phi_1541_: u32;
    var phi_1542_: u32;
    var phi_1548_: u32;
    var phi_1577_: vec3<f32>;
    var phi_1578_: vec3<f32>;
    var phi_1607_: vec3<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1637_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1661_: f32;
    var phi_1662_: f32;
    var phi_1663_: f32;
    var phi_1664_: f32;
    var phi_1672_: f32;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: f32;
    var phi_1688_: f32;
    var phi_1689_: f32;
    var phi_1690_: f32;
    var phi_1698_: f32;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1713_: f32;
    var phi_1714_: f32;
    var phi_1715_: f32;
    var phi_1716_: f32;
    var phi_1724_: f32;
    var phi_1739_: f32;
    var phi_1740_: bool;
    var phi_1741_: f32;
    var phi_1742_: bool;
    var phi_1743_: f32;
    var phi_1744_: bool;
    var phi_1762_: f32;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: f32;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1771_: bool;
    var phi_1772_: f32;
    var phi_1773_: bool;
    var phi_1801_: vec3<f32>;
    var phi_1802_: vec3<f32>;
    var phi_1827_: vec3<f32>;
    var phi_1828_: vec3<f32>;
    var phi_1853_: vec3<f32>;
    var phi_1854_: vec3<f32>;
    var phi_1910_: f32;
    var phi_1919_: f32;
    var phi_1928_: f32;
    var phi_1937_: f32;
    var phi_1944_: f32;
    var phi_1951_: f32;
    var phi_1964_: f32;
    var phi_1973_: f32;
    var phi_1982_: f32;
    var phi_1991_: f32;
    var phi_1998_: f32;
    var phi_2005_: f32;
    var phi_2022_: f32;
    var phi_2027_: f32;
    var phi_2032_: f32;
    var phi_2040_: f32;
    var phi_2045_: f32;
    var phi_2050_: f32;
    var phi_2062_: f32;
    var phi_2067_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2082_: lt_bvh_triangle_Intersection;
    var phi_2083_: bool;
    var phi_2084_: lt_bvh_triangle_Intersection;
    var phi_2085_: bool;
    var phi_2089_: lt_bvh_triangle_Intersection;
    var phi_2090_: bool;
    var phi_2091_: lt_bvh_triangle_Intersection;
    var phi_2092_: bool;
    var phi_2093_: bool;
    var phi_2097_: bool;
    var phi_2101_: lt_bvh_triangle_Intersection;
    var phi_2315_: f32;
    var phi_2318_: bool;
    var phi_2319_: bool;
    var phi_2323_: bool;
    var phi_2324_: bool;
    var phi_2325_: bool;
    var phi_2326_: bool;
    var phi_2327_: bool;
    var phi_2328_: bool;
    var phi_2329_: bool;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2332_: bool;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var phi_2340_: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var phi_2346_: bool;
    var phi_2347_: bool;
    var phi_1502_: u32;
    var phi_2348_: bool;
    var phi_2349_: bool;
    var phi_2350_: bool;
    var local_4: bool;
    var phi_2354_: bool;
    var phi_2355_: bool;
    var phi_2376_: u32;
    var phi_2377_: u32;
    var phi_2381_: u32;
    var phi_2382_: u32;
    var phi_2383_: u32;
    var phi_2384_: u32;
    var phi_2385_: bool;
    var phi_2386_: bool;
    var phi_2387_: bool;
    var phi_2408_: u32;
    var phi_2409_: u32;
    var phi_2410_: u32;
    var phi_2411_: u32;
    var phi_2412_: u32;
    var phi_2413_: u32;
    var phi_2414_: bool;
    var phi_2415_: bool;
    var phi_1212_: u32;
    var phi_1215_: u32;
    var phi_2416_: bool;
    var phi_2417_: bool;
    var phi_2418_: bool;
    var local_5: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2427_: bool;
    var phi_2431_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2440_: bool;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2458_: bool;
    var phi_2459_: bool;
    var phi_2463_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2483_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2510_: bool;
    var phi_2580_: f32;
    var phi_2587_: f32;
    var phi_2594_: f32;
    var phi_2601_: f32;
    var phi_2608_: f32;
    var phi_2615_: f32;
    var phi_2632_: f32;
    var phi_2637_: f32;
    var phi_2642_: f32;
    var phi_2647_: f32;
    var phi_2652_: f32;
    var phi_2678_: bool;
    var phi_2679_: bool;
    var phi_2687_: u32;
    var phi_2688_: u32;
    var phi_2699_: vec3<f32>;
    var phi_2700_: vec3<f32>;
    var phi_2713_: u32;
    var phi_2718_: u32;
    var phi_2723_: u32;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2869_: u32;
    var phi_2871_: u32;
    var phi_2874_: bool;
    var phi_2954_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2981_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3008_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3014_: u32;
    var phi_3017_: u32;
    var phi_3031_: u32;
    var phi_3041_: u32;
    var phi_3051_: u32;
    var phi_3069_: u32;
    var phi_3079_: u32;
    var phi_3089_: u32;
    var phi_3125_: u32;
    var phi_3138_: u32;
    var phi_3143_: u32;
    var phi_3144_: u32;
    var phi_3145_: u32;
    var phi_3015_: u32;
    var phi_3018_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_3203_: u32;
    var phi_3206_: bool;
    var phi_3250_: vec3<f32>;
    var phi_3251_: vec3<f32>;
    var phi_3280_: vec3<f32>;
    var phi_3281_: vec3<f32>;
    var phi_3310_: vec3<f32>;
    var phi_3311_: vec3<f32>;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3334_: f32;
    var phi_3335_: f32;
    var phi_3336_: f32;
    var phi_3337_: f32;
    var phi_3345_: f32;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3360_: f32;
    var phi_3361_: f32;
    var phi_3362_: f32;
    var phi_3363_: f32;
    var phi_3371_: f32;
    var phi_3381_: bool;
    var phi_3382_: bool;
    var phi_3386_: f32;
    var phi_3387_: f32;
    var phi_3388_: f32;
    var phi_3389_: f32;
    var phi_3397_: f32;
    var phi_3412_: f32;
    var phi_3413_: bool;
    var phi_3414_: f32;
    var phi_3415_: bool;
    var phi_3416_: f32;
    var phi_3417_: bool;
    var phi_3435_: f32;
    var phi_3436_: bool;
    var phi_3437_: bool;
    var phi_3438_: f32;
    var phi_3439_: bool;
    var phi_3440_: bool;
    var phi_3444_: bool;
    var phi_3445_: f32;
    var phi_3446_: bool;
    var phi_3474_: vec3<f32>;
    var phi_3475_: vec3<f32>;
    var phi_3500_: vec3<f32>;
    var phi_3501_: vec3<f32>;
    var phi_3526_: vec3<f32>;
    var phi_3527_: vec3<f32>;
    var phi_3583_: f32;
    var phi_3592_: f32;
    var phi_3601_: f32;
    var phi_3610_: f32;
    var phi_3617_: f32;
    var phi_3624_: f32;
    var phi_3637_: f32;
    var phi_3646_: f32;
    var phi_3655_: f32;
    var phi_3664_: f32;
    var phi_3671_: f32;
    var phi_3678_: f32;
    var phi_3695_: f32;
    var phi_3700_: f32;
    var phi_3705_: f32;
    var phi_3713_: f32;
    var phi_3718_: f32;
    var phi_3723_: f32;
    var phi_3735_: f32;
    var phi_3740_: f32;
    var phi_3745_: f32;
    var phi_3750_: f32;
    var phi_3755_: lt_bvh_triangle_Intersection;
    var phi_3756_: bool;
    var phi_3757_: lt_bvh_triangle_Intersection;
    var phi_3758_: bool;
    var phi_3762_: lt_bvh_triangle_Intersection;
    var phi_3763_: bool;
    var phi_3764_: lt_bvh_triangle_Intersection;
    var phi_3765_: bool;
    var phi_3766_: bool;
    var phi_3770_: bool;
    var phi_3774_: lt_bvh_triangle_Intersection;
    var phi_3988_: f32;
    var phi_3991_: bool;
    var phi_3992_: bool;
    var phi_3993_: bool;
    var phi_3997_: bool;
    var phi_3998_: bool;
    var phi_3999_: bool;
    var phi_4000_: bool;
    var phi_4001_: bool;
    var phi_4002_: bool;
    var phi_4003_: bool;
    var phi_4004_: bool;
    var phi_4005_: bool;
    var phi_4006_: bool;
    var phi_3204_: u32;
    var phi_3207_: bool;
    var phi_4010_: bool;
    var phi_4011_: bool;
    var local_9: bool;
    var phi_4053_: bool;
    var phi_4054_: bool;
    var phi_4085_: u32;
    var phi_4086_: u32;
    var phi_2872_: u32;
    var phi_2875_: bool;
    var phi_4087_: bool;
    var phi_4088_: bool;
    var phi_4089_: bool;
    var local_10: bool;
    var phi_4093_: bool;
    var phi_4097_: bool;
    var phi_4098_: bool;
    var phi_4099_: bool;
    var phi_4100_: bool;
    var phi_4104_: bool;
    var phi_4105_: bool;
    var phi_4106_: bool;
    var phi_4110_: f32;
    var phi_4151_: u32;
    var phi_4170_: u32;
    var phi_4178_: u32;
    var phi_4186_: u32;
    var phi_4191_: u32;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;

    let _e84 = id_1;
    let _e91 = arrayLength((&nodes.member));
    let _e94 = arrayLength((&triangles.member));
    let _e97 = arrayLength((&visibility.member));
    let _e100 = arrayLength((&list.member));
    let _e103 = arrayLength((&bits.member));
    let _e106 = arrayLength((&rows.member));
    let _e110 = arrayLength((&vertices.member));
    let _e113 = arrayLength((&materials.member));
    let _e116 = arrayLength((&alpha_texels.member));
    let _e120 = ((_e84.y * 2097152u) + _e84.x);
    if (3u < _e100) {
    } else {
        return;
    }
    let _e123 = list.member[3u];
    if (_e120 < _e123) {
        let _e125 = (_e120 + 4u);
        if (_e125 < _e100) {
        } else {
            return;
        }
        let _e129 = list.member[(0u + _e125)];
        let _e130 = space.member;
        if (_e129 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e136 = samples.member[(0u + _e129)].position;
        let _e138 = samples.member[(0u + _e129)].normal;
        let _e140 = samples.member[(0u + _e129)].magnitude;
        let _e142 = ((8f / 8388608f) * _e140);
        let _e144 = (_e138.x * _e142);
        let _e146 = (_e138.y * _e142);
        let _e148 = (_e138.z * _e142);
        let _e150 = (_e136.x + _e144);
        let _e152 = (_e136.y + _e146);
        let _e154 = (_e136.z + _e148);
        let _e158 = p.member.light.place;
        if (_e158.w == 0f) {
            phi_726_ = 300000000000000000000000000000000000000f;
        } else {
            phi_726_ = 1f;
        }
        let _e162 = phi_726_;
        let _e170 = (_e158.x - (_e150 * _e158.w));
        let _e171 = (_e158.y - (_e152 * _e158.w));
        let _e172 = (_e158.z - (_e154 * _e158.w));
        let _e173 = vec3<f32>(_e170, _e171, _e172);
        let _e174 = abs(_e170);
        let _e175 = abs(_e171);
        let _e176 = abs(_e172);
        if (abs(_e150) < 1000000000000000f) {
            if (abs(_e152) < 1000000000000000f) {
                phi_759_ = (abs(_e154) < 1000000000000000f);
                phi_760_ = false;
            } else {
                phi_759_ = bool();
                phi_760_ = true;
            }
            let _e184 = phi_759_;
            let _e186 = phi_760_;
            phi_761_ = _e184;
            phi_762_ = _e186;
        } else {
            phi_761_ = bool();
            phi_762_ = true;
        }
        let _e188 = phi_761_;
        let _e190 = phi_762_;
        if _e190 {
            phi_766_ = false;
        } else {
            phi_766_ = _e188;
        }
        let _e192 = phi_766_;
        if _e192 {
            if (_e174 < 1000000000000000f) {
                if (_e175 < 1000000000000000f) {
                    phi_779_ = (_e176 < 1000000000000000f);
                    phi_780_ = false;
                } else {
                    phi_779_ = bool();
                    phi_780_ = true;
                }
                let _e197 = phi_779_;
                let _e199 = phi_780_;
                phi_781_ = _e197;
                phi_782_ = _e199;
            } else {
                phi_781_ = bool();
                phi_782_ = true;
            }
            let _e201 = phi_781_;
            let _e203 = phi_782_;
            if _e203 {
                phi_786_ = false;
            } else {
                phi_786_ = _e201;
            }
            let _e205 = phi_786_;
            if _e205 {
                if (_e174 > 0f) {
                    phi_800_ = bool();
                    phi_801_ = true;
                } else {
                    let _e207 = (_e175 > 0f);
                    if _e207 {
                        phi_799_ = bool();
                    } else {
                        phi_799_ = (_e176 > 0f);
                    }
                    let _e210 = phi_799_;
                    phi_800_ = _e210;
                    phi_801_ = _e207;
                }
                let _e212 = phi_800_;
                let _e214 = phi_801_;
                if _e214 {
                    phi_805_ = true;
                } else {
                    phi_805_ = _e212;
                }
                let _e216 = phi_805_;
                phi_806_ = _e216;
                phi_807_ = false;
            } else {
                phi_806_ = bool();
                phi_807_ = true;
            }
            let _e218 = phi_806_;
            let _e220 = phi_807_;
            phi_808_ = _e218;
            phi_809_ = _e220;
        } else {
            phi_808_ = bool();
            phi_809_ = true;
        }
        let _e222 = phi_808_;
        let _e224 = phi_809_;
        if _e224 {
            phi_813_ = false;
        } else {
            phi_813_ = _e222;
        }
        let _e226 = phi_813_;
        if _e226 {
            if (_e130.low.x <= _e150) {
                if (_e150 <= _e130.high.x) {
                    if (_e130.low.y <= _e152) {
                        phi_836_ = (_e152 <= _e130.high.y);
                        phi_837_ = false;
                    } else {
                        phi_836_ = bool();
                        phi_837_ = true;
                    }
                    let _e244 = phi_836_;
                    let _e246 = phi_837_;
                    phi_838_ = _e244;
                    phi_839_ = _e246;
                } else {
                    phi_838_ = bool();
                    phi_839_ = true;
                }
                let _e248 = phi_838_;
                let _e250 = phi_839_;
                phi_840_ = _e248;
                phi_841_ = _e250;
            } else {
                phi_840_ = bool();
                phi_841_ = true;
            }
            let _e252 = phi_840_;
            let _e254 = phi_841_;
            if _e254 {
                phi_845_ = false;
            } else {
                phi_845_ = _e252;
            }
            let _e256 = phi_845_;
            if (abs(_e170) > 0.000000000000000000000000000001f) {
                phi_859_ = bool();
                phi_860_ = true;
            } else {
                let _e261 = (abs(_e171) > 0.000000000000000000000000000001f);
                if _e261 {
                    phi_858_ = bool();
                } else {
                    phi_858_ = (abs(_e172) > 0.000000000000000000000000000001f);
                }
                let _e264 = phi_858_;
                phi_859_ = _e264;
                phi_860_ = _e261;
            }
            let _e266 = phi_859_;
            let _e268 = phi_860_;
            if _e268 {
                phi_864_ = true;
            } else {
                phi_864_ = _e266;
            }
            let _e270 = phi_864_;
            if _e256 {
                if (_e130.low.z <= _e154) {
                    if (_e154 <= _e130.high.z) {
                        if (_e130.is_parallel == 0u) {
                            phi_881_ = _e270;
                        } else {
                            phi_881_ = true;
                        }
                        let _e276 = phi_881_;
                        phi_882_ = _e276;
                        phi_883_ = false;
                    } else {
                        phi_882_ = bool();
                        phi_883_ = true;
                    }
                    let _e278 = phi_882_;
                    let _e280 = phi_883_;
                    phi_884_ = _e278;
                    phi_885_ = _e280;
                } else {
                    phi_884_ = bool();
                    phi_885_ = true;
                }
                let _e282 = phi_884_;
                let _e284 = phi_885_;
                phi_886_ = _e282;
                phi_887_ = _e284;
            } else {
                phi_886_ = bool();
                phi_887_ = true;
            }
            let _e286 = phi_886_;
            let _e288 = phi_887_;
            if _e288 {
                phi_891_ = false;
            } else {
                phi_891_ = _e286;
            }
            let _e290 = phi_891_;
            if _e290 {
                if (_e130.is_parallel == 0u) {
                    let _e293 = abs(_e170);
                    let _e294 = abs(_e171);
                    let _e295 = abs(_e172);
                    if (_e293 >= _e294) {
                        if (_e293 >= _e295) {
                            phi_911_ = false;
                        } else {
                            phi_911_ = true;
                        }
                        let _e299 = phi_911_;
                        phi_912_ = _e299;
                    } else {
                        phi_912_ = true;
                    }
                    let _e301 = phi_912_;
                    if _e301 {
                        if (_e294 >= _e295) {
                            phi_920_ = 1u;
                            phi_921_ = _e171;
                        } else {
                            phi_920_ = 2u;
                            phi_921_ = _e172;
                        }
                        let _e304 = phi_920_;
                        let _e306 = phi_921_;
                        phi_922_ = _e304;
                        phi_923_ = _e306;
                    } else {
                        phi_922_ = 0u;
                        phi_923_ = _e170;
                    }
                    let _e308 = phi_922_;
                    let _e310 = phi_923_;
                    if (_e310 < 0f) {
                        phi_928_ = -1f;
                    } else {
                        phi_928_ = 1f;
                    }
                    let _e313 = phi_928_;
                    let _e314 = (_e313 < 0f);
                    if (_e308 == 0u) {
                        if _e314 {
                            phi_939_ = _e130.roots.y;
                        } else {
                            phi_939_ = _e130.roots.x;
                        }
                        let _e321 = phi_939_;
                        phi_957_ = _e321;
                    } else {
                        if (_e308 == 1u) {
                            if _e314 {
                                phi_949_ = _e130.roots.w;
                            } else {
                                phi_949_ = _e130.roots.z;
                            }
                            let _e328 = phi_949_;
                            phi_956_ = _e328;
                        } else {
                            if _e314 {
                                phi_955_ = _e130.roots_z.y;
                            } else {
                                phi_955_ = _e130.roots_z.x;
                            }
                            let _e334 = phi_955_;
                            phi_956_ = _e334;
                        }
                        let _e336 = phi_956_;
                        phi_957_ = _e336;
                    }
                    let _e338 = phi_957_;
                    if (_e308 == 0u) {
                        phi_969_ = vec3<f32>(_e171, _e172, _e170);
                    } else {
                        if (_e308 == 1u) {
                            phi_968_ = vec3<f32>(_e172, _e170, _e171);
                        } else {
                            phi_968_ = _e173;
                        }
                        let _e344 = phi_968_;
                        phi_969_ = _e344;
                    }
                    let _e346 = phi_969_;
                    phi_1015_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e346.x / _e346.z), (_e346.y / _e346.z), (_e313 / _e346.z)), _e338);
                } else {
                    if (_e130.axis == 0u) {
                        phi_992_ = vec3<f32>(_e152, _e154, _e150);
                    } else {
                        if (_e130.axis == 1u) {
                            phi_991_ = vec3<f32>(_e154, _e150, _e152);
                        } else {
                            phi_991_ = (_e136 + vec3<f32>(_e144, _e146, _e148));
                        }
                        let _e363 = phi_991_;
                        phi_992_ = _e363;
                    }
                    let _e365 = phi_992_;
                    let _e377 = (_e365.z - _e130.middle.z);
                    phi_1015_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e365.x - _e130.middle.x) - (_e130.shear.x * _e377)), ((_e365.y - _e130.middle.y) - (_e130.shear.y * _e377)), (_e130.sign * _e377)), _e130.roots.x);
                }
                let _e390 = phi_1015_;
                if (_e390.unnamed_1 == 4294967295u) {
                    phi_2435_ = false;
                    phi_2436_ = true;
                } else {
                    if (0u < _e91) {
                    } else {
                        return;
                    }
                    let _e398 = nodes.member[0u].frame[0u];
                    let _e402 = nodes.member[0u].frame[1u];
                    let _e406 = nodes.member[0u].frame[2u];
                    let _e410 = nodes.member[0u].frame[0u];
                    let _e414 = nodes.member[0u].frame[1u];
                    let _e418 = nodes.member[0u].frame[2u];
                    let _e422 = nodes.member[0u].frame[3u];
                    let _e456 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170), abs(_e171));
                    let _e457 = core_intrinsics_maximum_number_nsz_f32_(_e456, abs(_e172));
                    let _e458 = (_e457 * 0.0000000000009094947f);
                    if (abs(_e170) < _e458) {
                        phi_1083_ = _e458;
                    } else {
                        phi_1083_ = abs(_e170);
                    }
                    let _e463 = phi_1083_;
                    if (_e170 < 0f) {
                        phi_1090_ = (-1f / _e463);
                    } else {
                        phi_1090_ = (1f / _e463);
                    }
                    let _e468 = phi_1090_;
                    if (abs(_e171) < _e458) {
                        phi_1097_ = _e458;
                    } else {
                        phi_1097_ = abs(_e171);
                    }
                    let _e473 = phi_1097_;
                    if (_e171 < 0f) {
                        phi_1104_ = (-1f / _e473);
                    } else {
                        phi_1104_ = (1f / _e473);
                    }
                    let _e478 = phi_1104_;
                    if (abs(_e172) < _e458) {
                        phi_1111_ = _e458;
                    } else {
                        phi_1111_ = abs(_e172);
                    }
                    let _e483 = phi_1111_;
                    if (_e172 < 0f) {
                        phi_1118_ = (-1f / _e483);
                    } else {
                        phi_1118_ = (1f / _e483);
                    }
                    let _e488 = phi_1118_;
                    let _e492 = abs((bitcast<f32>(_e398) - _e150));
                    let _e493 = abs((bitcast<f32>(_e402) - _e152));
                    let _e494 = abs((bitcast<f32>(_e406) - _e154));
                    let _e498 = abs(((bitcast<f32>(_e410) + (bitcast<f32>((((_e422 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150));
                    let _e499 = abs(((bitcast<f32>(_e414) + (bitcast<f32>((((_e422 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e152));
                    let _e500 = abs(((bitcast<f32>(_e418) + (bitcast<f32>((((_e422 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154));
                    if (_e492 > _e498) {
                        phi_1135_ = _e492;
                    } else {
                        phi_1135_ = _e498;
                    }
                    let _e503 = phi_1135_;
                    if (_e493 > _e499) {
                        phi_1140_ = _e493;
                    } else {
                        phi_1140_ = _e499;
                    }
                    let _e506 = phi_1140_;
                    if (_e494 > _e500) {
                        phi_1145_ = _e494;
                    } else {
                        phi_1145_ = _e500;
                    }
                    let _e509 = phi_1145_;
                    if (_e503 > _e506) {
                        phi_1150_ = _e503;
                    } else {
                        phi_1150_ = _e506;
                    }
                    let _e512 = phi_1150_;
                    if (_e512 > _e509) {
                        phi_1155_ = _e512;
                    } else {
                        phi_1155_ = _e509;
                    }
                    let _e515 = phi_1155_;
                    let _e522 = (_e515 * 0.0000009536743f);
                    let _e523 = (abs(_e468) * _e522);
                    let _e524 = (abs(_e478) * _e522);
                    let _e525 = (abs(_e488) * _e522);
                    let _e526 = abs(_e170);
                    let _e527 = abs(_e171);
                    let _e528 = abs(_e172);
                    if (_e526 >= _e527) {
                        if (_e526 >= _e528) {
                            phi_1177_ = false;
                        } else {
                            phi_1177_ = true;
                        }
                        let _e532 = phi_1177_;
                        phi_1178_ = _e532;
                    } else {
                        phi_1178_ = true;
                    }
                    let _e534 = phi_1178_;
                    if _e534 {
                        if (_e527 >= _e528) {
                            phi_1186_ = 1u;
                        } else {
                            phi_1186_ = 2u;
                        }
                        let _e537 = phi_1186_;
                        phi_1187_ = _e537;
                    } else {
                        phi_1187_ = 0u;
                    }
                    let _e539 = phi_1187_;
                    if (_e539 == 0u) {
                        phi_1199_ = vec3<f32>(_e171, _e172, _e170);
                    } else {
                        if (_e539 == 1u) {
                            phi_1198_ = vec3<f32>(_e172, _e170, _e171);
                        } else {
                            phi_1198_ = _e173;
                        }
                        let _e545 = phi_1198_;
                        phi_1199_ = _e545;
                    }
                    let _e547 = phi_1199_;
                    let _e550 = (_e547.x / _e547.z);
                    let _e553 = (_e547.y / _e547.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1211_ = ((_e390.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1214_ = 0u;
                    loop {
                        let _e560 = phi_1211_;
                        let _e562 = phi_1214_;
                        let _e563 = (_e560 == 0u);
                        local_5 = _e563;
                        if _e563 {
                            phi_1212_ = u32();
                            phi_1215_ = u32();
                            phi_2416_ = false;
                            phi_2417_ = false;
                            phi_2418_ = false;
                        } else {
                            let _e571 = (_e560 & (_e560 - 1u));
                            let _e572 = (((_e560 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e560), 32u, (_e560 == 0u))) * 4u);
                            if (_e572 < _e106) {
                            } else {
                                return;
                            }
                            let _e576 = rows.member[(0u + _e572)];
                            let _e577 = (_e572 + 1u);
                            if (_e577 < _e106) {
                            } else {
                                return;
                            }
                            let _e581 = rows.member[(0u + _e577)];
                            let _e582 = (_e572 + 2u);
                            if (_e582 < _e106) {
                            } else {
                                return;
                            }
                            let _e586 = rows.member[(0u + _e582)];
                            let _e587 = (_e572 + 3u);
                            if (_e587 < _e106) {
                            } else {
                                return;
                            }
                            let _e591 = rows.member[(0u + _e587)];
                            let _e592 = lt_bvh_LightNode(_e576, _e581, _e586, _e591);
                            let _e604 = (_e390.unnamed.positive_exponent - bitcast<f32>(_e592.frame.x));
                            let _e607 = bitcast<f32>((((_e592.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e604 > 0f) {
                                if (_e604 < (255f * _e607)) {
                                    phi_1283_ = (_e604 / _e607);
                                } else {
                                    phi_1283_ = 255f;
                                }
                                let _e613 = phi_1283_;
                                phi_1284_ = _e613;
                            } else {
                                phi_1284_ = 0f;
                            }
                            let _e615 = phi_1284_;
                            let _e622 = select(select(u32(_e615), 0u, (_e615 < bitcast<f32>(0u))), 4294967295u, (_e615 > bitcast<f32>(1333788671u)));
                            if (f32(_e622) < _e615) {
                                phi_1298_ = (_e622 + 1u);
                            } else {
                                phi_1298_ = _e622;
                            }
                            let _e627 = phi_1298_;
                            let _e628 = (_e622 * 16843009u);
                            let _e629 = (_e627 * 16843009u);
                            let _e639 = (_e390.unnamed.negative_exponent - bitcast<f32>(_e592.frame.y));
                            let _e642 = bitcast<f32>((((_e592.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e639 > 0f) {
                                if (_e639 < (255f * _e642)) {
                                    phi_1321_ = (_e639 / _e642);
                                } else {
                                    phi_1321_ = 255f;
                                }
                                let _e648 = phi_1321_;
                                phi_1322_ = _e648;
                            } else {
                                phi_1322_ = 0f;
                            }
                            let _e650 = phi_1322_;
                            let _e657 = select(select(u32(_e650), 0u, (_e650 < bitcast<f32>(0u))), 4294967295u, (_e650 > bitcast<f32>(1333788671u)));
                            if (f32(_e657) < _e650) {
                                phi_1336_ = (_e657 + 1u);
                            } else {
                                phi_1336_ = _e657;
                            }
                            let _e662 = phi_1336_;
                            let _e663 = (_e657 * 16843009u);
                            let _e664 = (_e662 * 16843009u);
                            let _e674 = (_e390.unnamed.min_variance - bitcast<f32>(_e592.frame.z));
                            let _e677 = bitcast<f32>((((_e592.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e674 > 0f) {
                                if (_e674 < (255f * _e677)) {
                                    phi_1359_ = (_e674 / _e677);
                                } else {
                                    phi_1359_ = 255f;
                                }
                                let _e683 = phi_1359_;
                                phi_1360_ = _e683;
                            } else {
                                phi_1360_ = 0f;
                            }
                            let _e685 = phi_1360_;
                            let _e692 = select(select(u32(_e685), 0u, (_e685 < bitcast<f32>(0u))), 4294967295u, (_e685 > bitcast<f32>(1333788671u)));
                            if (f32(_e692) < _e685) {
                                phi_1374_ = (_e692 + 1u);
                            } else {
                                phi_1374_ = _e692;
                            }
                            let _e697 = phi_1374_;
                            let _e698 = (_e697 * 16843009u);
                            let _e831 = (((((((((((_e628 & ~(_e592.x.x)) | (~((_e592.x.x ^ _e628)) & ((_e628 | 2155905152u) - (_e592.x.x & 2139062143u)))) & ((_e592.x.z & ~(_e629)) | (~((_e629 ^ _e592.x.z)) & ((_e592.x.z | 2155905152u) - (_e629 & 2139062143u))))) & ((_e663 & ~(_e592.y.x)) | (~((_e592.y.x ^ _e663)) & ((_e663 | 2155905152u) - (_e592.y.x & 2139062143u))))) & ((_e592.y.z & ~(_e664)) | (~((_e664 ^ _e592.y.z)) & ((_e592.y.z | 2155905152u) - (_e664 & 2139062143u))))) & ((_e592.rest.x & ~(_e698)) | (~((_e698 ^ _e592.rest.x)) & ((_e592.rest.x | 2155905152u) - (_e698 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e628 & ~(_e592.x.y)) | (~((_e592.x.y ^ _e628)) & ((_e628 | 2155905152u) - (_e592.x.y & 2139062143u)))) & ((_e592.x.w & ~(_e629)) | (~((_e629 ^ _e592.x.w)) & ((_e592.x.w | 2155905152u) - (_e629 & 2139062143u))))) & ((_e663 & ~(_e592.y.y)) | (~((_e592.y.y ^ _e663)) & ((_e663 | 2155905152u) - (_e592.y.y & 2139062143u))))) & ((_e592.y.w & ~(_e664)) | (~((_e664 ^ _e592.y.w)) & ((_e592.y.w | 2155905152u) - (_e664 & 2139062143u))))) & ((_e592.rest.y & ~(_e698)) | (~((_e698 ^ _e592.rest.y)) & ((_e592.rest.y | 2155905152u) - (_e698 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e592.frame.w & 16777216u) != 0u) {
                                phi_1501_ = _e831;
                                loop {
                                    let _e837 = phi_1501_;
                                    let _e838 = (_e837 == 0u);
                                    local_4 = _e838;
                                    local_13 = _e838;
                                    if _e838 {
                                        phi_1502_ = u32();
                                        phi_2348_ = false;
                                        phi_2349_ = false;
                                        phi_2350_ = false;
                                    } else {
                                        let _e841 = select(firstTrailingBit(_e837), 32u, (_e837 == 0u));
                                        let _e846 = (_e592.rest.z + (_e841 >> bitcast<u32>(2i)));
                                        if (_e846 < _e106) {
                                        } else {
                                            return;
                                        }
                                        let _e851 = rows.member[(0u + _e846)][0u];
                                        let _e855 = rows.member[(0u + _e846)][1u];
                                        let _e859 = rows.member[(0u + _e846)][2u];
                                        let _e863 = rows.member[(0u + _e846)][3u];
                                        if ((_e841 & 2u) == 0u) {
                                            phi_1541_ = _e855;
                                            phi_1542_ = _e851;
                                        } else {
                                            phi_1541_ = _e863;
                                            phi_1542_ = _e859;
                                        }
                                        let _e867 = phi_1541_;
                                        let _e869 = phi_1542_;
                                        if ((_e841 & 1u) == 0u) {
                                            phi_1548_ = _e869;
                                        } else {
                                            phi_1548_ = _e867;
                                        }
                                        let _e873 = phi_1548_;
                                        if (_e873 < _e94) {
                                        } else {
                                            return;
                                        }
                                        let _e880 = triangles.member[(0u + _e873)].v0_;
                                        let _e882 = (_e880.x - _e150);
                                        let _e884 = (_e880.y - _e152);
                                        let _e886 = (_e880.z - _e154);
                                        if (_e539 == 0u) {
                                            phi_1578_ = vec3<f32>(_e884, _e886, _e882);
                                        } else {
                                            if (_e539 == 1u) {
                                                phi_1577_ = vec3<f32>(_e886, _e882, _e884);
                                            } else {
                                                phi_1577_ = (_e880 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e894 = phi_1577_;
                                            phi_1578_ = _e894;
                                        }
                                        let _e896 = phi_1578_;
                                        let _e900 = (_e896.x - (_e550 * _e896.z));
                                        let _e904 = (_e896.y - (_e553 * _e896.z));
                                        let _e906 = triangles.member[(0u + _e873)].v1_;
                                        let _e908 = (_e906.x - _e150);
                                        let _e910 = (_e906.y - _e152);
                                        let _e912 = (_e906.z - _e154);
                                        if (_e539 == 0u) {
                                            phi_1608_ = vec3<f32>(_e910, _e912, _e908);
                                        } else {
                                            if (_e539 == 1u) {
                                                phi_1607_ = vec3<f32>(_e912, _e908, _e910);
                                            } else {
                                                phi_1607_ = (_e906 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e920 = phi_1607_;
                                            phi_1608_ = _e920;
                                        }
                                        let _e922 = phi_1608_;
                                        let _e926 = (_e922.x - (_e550 * _e922.z));
                                        let _e930 = (_e922.y - (_e553 * _e922.z));
                                        let _e932 = triangles.member[(0u + _e873)].v2_;
                                        let _e934 = (_e932.x - _e150);
                                        let _e936 = (_e932.y - _e152);
                                        let _e938 = (_e932.z - _e154);
                                        if (_e539 == 0u) {
                                            phi_1638_ = vec3<f32>(_e936, _e938, _e934);
                                        } else {
                                            if (_e539 == 1u) {
                                                phi_1637_ = vec3<f32>(_e938, _e934, _e936);
                                            } else {
                                                phi_1637_ = (_e932 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e946 = phi_1637_;
                                            phi_1638_ = _e946;
                                        }
                                        let _e948 = phi_1638_;
                                        let _e952 = (_e948.x - (_e550 * _e948.z));
                                        let _e956 = (_e948.y - (_e553 * _e948.z));
                                        if (_e926 < _e952) {
                                            phi_1657_ = true;
                                        } else {
                                            if (_e926 == _e952) {
                                                phi_1656_ = (_e930 < _e956);
                                            } else {
                                                phi_1656_ = false;
                                            }
                                            let _e961 = phi_1656_;
                                            phi_1657_ = _e961;
                                        }
                                        let _e963 = phi_1657_;
                                        if _e963 {
                                            phi_1661_ = _e956;
                                            phi_1662_ = _e952;
                                            phi_1663_ = _e930;
                                            phi_1664_ = _e926;
                                        } else {
                                            phi_1661_ = _e930;
                                            phi_1662_ = _e926;
                                            phi_1663_ = _e956;
                                            phi_1664_ = _e952;
                                        }
                                        let _e965 = phi_1661_;
                                        let _e967 = phi_1662_;
                                        let _e969 = phi_1663_;
                                        let _e971 = phi_1664_;
                                        let _e974 = ((_e971 * _e965) - (_e969 * _e967));
                                        if _e963 {
                                            phi_1672_ = -(_e974);
                                        } else {
                                            phi_1672_ = _e974;
                                        }
                                        let _e977 = phi_1672_;
                                        if (_e952 < _e900) {
                                            phi_1683_ = true;
                                        } else {
                                            if (_e952 == _e900) {
                                                phi_1682_ = (_e956 < _e904);
                                            } else {
                                                phi_1682_ = false;
                                            }
                                            let _e982 = phi_1682_;
                                            phi_1683_ = _e982;
                                        }
                                        let _e984 = phi_1683_;
                                        if _e984 {
                                            phi_1687_ = _e904;
                                            phi_1688_ = _e900;
                                            phi_1689_ = _e956;
                                            phi_1690_ = _e952;
                                        } else {
                                            phi_1687_ = _e956;
                                            phi_1688_ = _e952;
                                            phi_1689_ = _e904;
                                            phi_1690_ = _e900;
                                        }
                                        let _e986 = phi_1687_;
                                        let _e988 = phi_1688_;
                                        let _e990 = phi_1689_;
                                        let _e992 = phi_1690_;
                                        let _e995 = ((_e992 * _e986) - (_e990 * _e988));
                                        if _e984 {
                                            phi_1698_ = -(_e995);
                                        } else {
                                            phi_1698_ = _e995;
                                        }
                                        let _e998 = phi_1698_;
                                        if (_e900 < _e926) {
                                            phi_1709_ = true;
                                        } else {
                                            if (_e900 == _e926) {
                                                phi_1708_ = (_e904 < _e930);
                                            } else {
                                                phi_1708_ = false;
                                            }
                                            let _e1003 = phi_1708_;
                                            phi_1709_ = _e1003;
                                        }
                                        let _e1005 = phi_1709_;
                                        if _e1005 {
                                            phi_1713_ = _e930;
                                            phi_1714_ = _e926;
                                            phi_1715_ = _e904;
                                            phi_1716_ = _e900;
                                        } else {
                                            phi_1713_ = _e904;
                                            phi_1714_ = _e900;
                                            phi_1715_ = _e930;
                                            phi_1716_ = _e926;
                                        }
                                        let _e1007 = phi_1713_;
                                        let _e1009 = phi_1714_;
                                        let _e1011 = phi_1715_;
                                        let _e1013 = phi_1716_;
                                        let _e1016 = ((_e1013 * _e1007) - (_e1011 * _e1009));
                                        if _e1005 {
                                            phi_1724_ = -(_e1016);
                                        } else {
                                            phi_1724_ = _e1016;
                                        }
                                        let _e1019 = phi_1724_;
                                        if (_e977 >= 0f) {
                                            if (_e998 >= 0f) {
                                                if (_e1019 >= 0f) {
                                                    phi_1739_ = ((_e977 + _e998) + _e1019);
                                                    phi_1740_ = false;
                                                } else {
                                                    phi_1739_ = f32();
                                                    phi_1740_ = true;
                                                }
                                                let _e1026 = phi_1739_;
                                                let _e1028 = phi_1740_;
                                                phi_1741_ = _e1026;
                                                phi_1742_ = _e1028;
                                            } else {
                                                phi_1741_ = f32();
                                                phi_1742_ = true;
                                            }
                                            let _e1030 = phi_1741_;
                                            let _e1032 = phi_1742_;
                                            phi_1743_ = _e1030;
                                            phi_1744_ = _e1032;
                                        } else {
                                            phi_1743_ = f32();
                                            phi_1744_ = true;
                                        }
                                        let _e1034 = phi_1743_;
                                        let _e1036 = phi_1744_;
                                        if _e1036 {
                                            if (_e977 <= 0f) {
                                                if (_e998 <= 0f) {
                                                    let _e1039 = (_e1019 <= 0f);
                                                    if _e1039 {
                                                    }
                                                    phi_1762_ = ((_e977 + _e998) + _e1019);
                                                    phi_1763_ = false;
                                                    phi_1764_ = _e1039;
                                                } else {
                                                    phi_1762_ = f32();
                                                    phi_1763_ = true;
                                                    phi_1764_ = false;
                                                }
                                                let _e1043 = phi_1762_;
                                                let _e1045 = phi_1763_;
                                                let _e1047 = phi_1764_;
                                                phi_1765_ = _e1043;
                                                phi_1766_ = _e1045;
                                                phi_1767_ = _e1047;
                                            } else {
                                                phi_1765_ = f32();
                                                phi_1766_ = true;
                                                phi_1767_ = false;
                                            }
                                            let _e1049 = phi_1765_;
                                            let _e1051 = phi_1766_;
                                            let _e1053 = phi_1767_;
                                            if _e1051 {
                                                phi_1771_ = false;
                                            } else {
                                                phi_1771_ = _e1053;
                                            }
                                            let _e1055 = phi_1771_;
                                            phi_1772_ = _e1049;
                                            phi_1773_ = _e1055;
                                        } else {
                                            phi_1772_ = _e1034;
                                            phi_1773_ = true;
                                        }
                                        let _e1057 = phi_1772_;
                                        let _e1059 = phi_1773_;
                                        if _e1059 {
                                            let _e1060 = (_e1057 == 0f);
                                            if _e1060 {
                                                phi_2089_ = lt_bvh_triangle_Intersection();
                                                phi_2090_ = false;
                                            } else {
                                                let _e1062 = triangles.member[(0u + _e873)].v0_;
                                                let _e1064 = (_e1062.x - _e150);
                                                let _e1066 = (_e1062.y - _e152);
                                                let _e1068 = (_e1062.z - _e154);
                                                if (_e539 == 0u) {
                                                    phi_1802_ = vec3<f32>(_e1066, _e1068, _e1064);
                                                } else {
                                                    if (_e539 == 1u) {
                                                        phi_1801_ = vec3<f32>(_e1068, _e1064, _e1066);
                                                    } else {
                                                        phi_1801_ = (_e1062 - vec3<f32>(_e150, _e152, _e154));
                                                    }
                                                    let _e1076 = phi_1801_;
                                                    phi_1802_ = _e1076;
                                                }
                                                let _e1078 = phi_1802_;
                                                let _e1080 = triangles.member[(0u + _e873)].v1_;
                                                let _e1082 = triangles.member[(0u + _e873)].v0_;
                                                let _e1085 = (_e1080.x - _e1082.x);
                                                let _e1088 = (_e1080.y - _e1082.y);
                                                let _e1091 = (_e1080.z - _e1082.z);
                                                if (_e539 == 0u) {
                                                    phi_1828_ = vec3<f32>(_e1088, _e1091, _e1085);
                                                } else {
                                                    if (_e539 == 1u) {
                                                        phi_1827_ = vec3<f32>(_e1091, _e1085, _e1088);
                                                    } else {
                                                        phi_1827_ = (_e1080 - _e1082);
                                                    }
                                                    let _e1098 = phi_1827_;
                                                    phi_1828_ = _e1098;
                                                }
                                                let _e1100 = phi_1828_;
                                                let _e1102 = triangles.member[(0u + _e873)].v2_;
                                                let _e1104 = triangles.member[(0u + _e873)].v0_;
                                                let _e1107 = (_e1102.x - _e1104.x);
                                                let _e1110 = (_e1102.y - _e1104.y);
                                                let _e1113 = (_e1102.z - _e1104.z);
                                                if (_e539 == 0u) {
                                                    phi_1854_ = vec3<f32>(_e1110, _e1113, _e1107);
                                                } else {
                                                    if (_e539 == 1u) {
                                                        phi_1853_ = vec3<f32>(_e1113, _e1107, _e1110);
                                                    } else {
                                                        phi_1853_ = (_e1102 - _e1104);
                                                    }
                                                    let _e1120 = phi_1853_;
                                                    phi_1854_ = _e1120;
                                                }
                                                let _e1122 = phi_1854_;
                                                let _e1129 = ((_e1100.y * _e1122.z) - (_e1100.z * _e1122.y));
                                                let _e1136 = ((_e1100.z * _e1122.x) - (_e1100.x * _e1122.z));
                                                let _e1143 = ((_e1100.x * _e1122.y) - (_e1100.y * _e1122.x));
                                                let _e1157 = (((1f / _e547.z) * (((_e1129 * _e1078.x) + (_e1136 * _e1078.y)) + (_e1143 * _e1078.z))) / (((_e1129 * _e550) + (_e1136 * _e553)) + _e1143));
                                                if (_e1157 > 0f) {
                                                    if (_e1157 < _e162) {
                                                        let _e1161 = triangles.member[(0u + _e873)].v0_;
                                                        let _e1163 = triangles.member[(0u + _e873)].v1_;
                                                        if (_e1161.x < _e1163.x) {
                                                            phi_1910_ = _e1161.x;
                                                        } else {
                                                            phi_1910_ = _e1163.x;
                                                        }
                                                        let _e1170 = phi_1910_;
                                                        if (_e1161.y < _e1163.y) {
                                                            phi_1919_ = _e1161.y;
                                                        } else {
                                                            phi_1919_ = _e1163.y;
                                                        }
                                                        let _e1177 = phi_1919_;
                                                        if (_e1161.z < _e1163.z) {
                                                            phi_1928_ = _e1161.z;
                                                        } else {
                                                            phi_1928_ = _e1163.z;
                                                        }
                                                        let _e1184 = phi_1928_;
                                                        let _e1186 = triangles.member[(0u + _e873)].v2_;
                                                        if (_e1170 < _e1186.x) {
                                                            phi_1937_ = _e1170;
                                                        } else {
                                                            phi_1937_ = _e1186.x;
                                                        }
                                                        let _e1191 = phi_1937_;
                                                        if (_e1177 < _e1186.y) {
                                                            phi_1944_ = _e1177;
                                                        } else {
                                                            phi_1944_ = _e1186.y;
                                                        }
                                                        let _e1196 = phi_1944_;
                                                        if (_e1184 < _e1186.z) {
                                                            phi_1951_ = _e1184;
                                                        } else {
                                                            phi_1951_ = _e1186.z;
                                                        }
                                                        let _e1201 = phi_1951_;
                                                        let _e1203 = triangles.member[(0u + _e873)].v0_;
                                                        let _e1205 = triangles.member[(0u + _e873)].v1_;
                                                        if (_e1203.x > _e1205.x) {
                                                            phi_1964_ = _e1203.x;
                                                        } else {
                                                            phi_1964_ = _e1205.x;
                                                        }
                                                        let _e1212 = phi_1964_;
                                                        if (_e1203.y > _e1205.y) {
                                                            phi_1973_ = _e1203.y;
                                                        } else {
                                                            phi_1973_ = _e1205.y;
                                                        }
                                                        let _e1219 = phi_1973_;
                                                        if (_e1203.z > _e1205.z) {
                                                            phi_1982_ = _e1203.z;
                                                        } else {
                                                            phi_1982_ = _e1205.z;
                                                        }
                                                        let _e1226 = phi_1982_;
                                                        let _e1228 = triangles.member[(0u + _e873)].v2_;
                                                        if (_e1212 > _e1228.x) {
                                                            phi_1991_ = _e1212;
                                                        } else {
                                                            phi_1991_ = _e1228.x;
                                                        }
                                                        let _e1233 = phi_1991_;
                                                        if (_e1219 > _e1228.y) {
                                                            phi_1998_ = _e1219;
                                                        } else {
                                                            phi_1998_ = _e1228.y;
                                                        }
                                                        let _e1238 = phi_1998_;
                                                        if (_e1226 > _e1228.z) {
                                                            phi_2005_ = _e1226;
                                                        } else {
                                                            phi_2005_ = _e1228.z;
                                                        }
                                                        let _e1243 = phi_2005_;
                                                        let _e1247 = ((_e1191 - _e150) * _e468);
                                                        let _e1248 = ((_e1196 - _e152) * _e478);
                                                        let _e1249 = ((_e1201 - _e154) * _e488);
                                                        let _e1253 = ((_e1233 - _e150) * _e468);
                                                        let _e1254 = ((_e1238 - _e152) * _e478);
                                                        let _e1255 = ((_e1243 - _e154) * _e488);
                                                        if (_e1247 < _e1253) {
                                                            phi_2022_ = _e1247;
                                                        } else {
                                                            phi_2022_ = _e1253;
                                                        }
                                                        let _e1258 = phi_2022_;
                                                        if (_e1248 < _e1254) {
                                                            phi_2027_ = _e1248;
                                                        } else {
                                                            phi_2027_ = _e1254;
                                                        }
                                                        let _e1261 = phi_2027_;
                                                        if (_e1249 < _e1255) {
                                                            phi_2032_ = _e1249;
                                                        } else {
                                                            phi_2032_ = _e1255;
                                                        }
                                                        let _e1264 = phi_2032_;
                                                        if (_e1247 > _e1253) {
                                                            phi_2040_ = _e1247;
                                                        } else {
                                                            phi_2040_ = _e1253;
                                                        }
                                                        let _e1270 = phi_2040_;
                                                        if (_e1248 > _e1254) {
                                                            phi_2045_ = _e1248;
                                                        } else {
                                                            phi_2045_ = _e1254;
                                                        }
                                                        let _e1273 = phi_2045_;
                                                        if (_e1249 > _e1255) {
                                                            phi_2050_ = _e1249;
                                                        } else {
                                                            phi_2050_ = _e1255;
                                                        }
                                                        let _e1276 = phi_2050_;
                                                        let _e1280 = core_intrinsics_maximum_number_nsz_f32_((_e1258 - _e523), (_e1261 - _e524));
                                                        let _e1281 = core_intrinsics_maximum_number_nsz_f32_(_e1280, (_e1264 - _e525));
                                                        let _e1282 = core_intrinsics_minimum_number_nsz_f32_((_e1270 + _e523), (_e1273 + _e524));
                                                        let _e1283 = core_intrinsics_minimum_number_nsz_f32_(_e1282, (_e1276 + _e525));
                                                        if (_e1281 > -300000000000000000000000000000000000000f) {
                                                            phi_2062_ = _e1281;
                                                        } else {
                                                            phi_2062_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1286 = phi_2062_;
                                                        if (_e1283 < 300000000000000000000000000000000000000f) {
                                                            phi_2067_ = _e1283;
                                                        } else {
                                                            phi_2067_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1289 = phi_2067_;
                                                        if (_e1157 < _e1286) {
                                                            phi_2072_ = _e1286;
                                                        } else {
                                                            phi_2072_ = _e1157;
                                                        }
                                                        let _e1292 = phi_2072_;
                                                        if (_e1292 > _e1289) {
                                                            phi_2077_ = _e1289;
                                                        } else {
                                                            phi_2077_ = _e1292;
                                                        }
                                                        let _e1295 = phi_2077_;
                                                        phi_2082_ = lt_bvh_triangle_Intersection(_e1295, (_e998 / _e1057), (_e1019 / _e1057), (_e1286 <= _e1289));
                                                        phi_2083_ = false;
                                                    } else {
                                                        phi_2082_ = lt_bvh_triangle_Intersection();
                                                        phi_2083_ = true;
                                                    }
                                                    let _e1301 = phi_2082_;
                                                    let _e1303 = phi_2083_;
                                                    phi_2084_ = _e1301;
                                                    phi_2085_ = _e1303;
                                                } else {
                                                    phi_2084_ = lt_bvh_triangle_Intersection();
                                                    phi_2085_ = true;
                                                }
                                                let _e1305 = phi_2084_;
                                                let _e1307 = phi_2085_;
                                                if _e1307 {
                                                }
                                                phi_2089_ = _e1305;
                                                phi_2090_ = _e1307;
                                            }
                                            let _e1309 = phi_2089_;
                                            let _e1311 = phi_2090_;
                                            phi_2091_ = _e1309;
                                            phi_2092_ = _e1060;
                                            phi_2093_ = _e1311;
                                        } else {
                                            phi_2091_ = lt_bvh_triangle_Intersection();
                                            phi_2092_ = true;
                                            phi_2093_ = false;
                                        }
                                        let _e1313 = phi_2091_;
                                        let _e1315 = phi_2092_;
                                        let _e1317 = phi_2093_;
                                        if _e1315 {
                                            phi_2097_ = true;
                                        } else {
                                            phi_2097_ = _e1317;
                                        }
                                        let _e1319 = phi_2097_;
                                        if _e1319 {
                                            phi_2101_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_2101_ = _e1313;
                                        }
                                        let _e1321 = phi_2101_;
                                        if _e1321.is_hit {
                                            if (_e1321.t > 0f) {
                                                if (_e1321.t < _e162) {
                                                    let _e1328 = triangles.member[(0u + _e873)].i0_;
                                                    let _e1330 = ((_e1328 & 2147483648u) == 0u);
                                                    if _e1330 {
                                                        phi_2324_ = false;
                                                        phi_2325_ = false;
                                                    } else {
                                                        if (_e873 < _e94) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1337 = triangles.member[(0u + _e873)].i0_;
                                                        let _e1338 = (_e1337 & 2147483647u);
                                                        let _e1340 = triangles.member[(0u + _e873)].i1_;
                                                        let _e1342 = triangles.member[(0u + _e873)].i2_;
                                                        if (_e1338 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1346 = vertices.member[(0u + _e1338)];
                                                        if (_e1340 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1350 = vertices.member[(0u + _e1340)];
                                                        if (_e1342 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1354 = vertices.member[(0u + _e1342)];
                                                        let _e1355 = array<abi_Vertex, 3>(_e1346, _e1350, _e1354);
                                                        if (_e1355[0].material < _e113) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1361 = materials.member[(0u + _e1355[0].material)];
                                                        if ((_e1361.flags & 1u) == 1u) {
                                                            let _e1366 = ((1f - _e1321.u) - _e1321.v);
                                                            if (_e1361.cutoff <= 0f) {
                                                                phi_2318_ = true;
                                                            } else {
                                                                let _e1393 = (_e1361.base_color.w * ((((f32((_e1355[0].color >> bitcast<u32>(24i))) * _e1366) + (f32((_e1355[1].color >> bitcast<u32>(24i))) * _e1321.u)) + (f32((_e1355[2].color >> bitcast<u32>(24i))) * _e1321.v)) * (1f / 255f)));
                                                                if (_e1361.alpha_size == 0u) {
                                                                    phi_2315_ = _e1393;
                                                                } else {
                                                                    local_2.offset = _e1361.alpha_offset;
                                                                    local_2.size = _e1361.alpha_size;
                                                                    local_2.flags = _e1361.flags;
                                                                    let _e1424 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1355[0].u * _e1366) + (_e1355[1].u * _e1321.u)) + (_e1355[2].u * _e1321.v)), (((_e1355[0].v * _e1366) + (_e1355[1].v * _e1321.u)) + (_e1355[2].v * _e1321.v)));
                                                                    let _e1428 = (_e1424.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e1428 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1432 = alpha_texels.member[(0u + _e1428)];
                                                                    let _e1448 = (_e1424.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e1448 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1452 = alpha_texels.member[(0u + _e1448)];
                                                                    let _e1469 = (_e1424.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e1469 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1473 = alpha_texels.member[(0u + _e1469)];
                                                                    let _e1490 = (_e1424.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e1490 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1494 = alpha_texels.member[(0u + _e1490)];
                                                                    phi_2315_ = (_e1393 * (((((f32(((_e1432 >> bitcast<u32>((((_e1424.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1424.weights.x) + ((f32(((_e1452 >> bitcast<u32>((((_e1424.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1424.weights.y)) + ((f32(((_e1473 >> bitcast<u32>((((_e1424.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1424.weights.z)) + ((f32(((_e1494 >> bitcast<u32>((((_e1424.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1424.weights.w)));
                                                                }
                                                                let _e1510 = phi_2315_;
                                                                phi_2318_ = (_e1510 >= _e1361.cutoff);
                                                            }
                                                            let _e1514 = phi_2318_;
                                                            phi_2319_ = _e1514;
                                                        } else {
                                                            phi_2319_ = false;
                                                        }
                                                        let _e1516 = phi_2319_;
                                                        if _e1516 {
                                                            phi_2323_ = false;
                                                        } else {
                                                            phi_2323_ = true;
                                                        }
                                                        let _e1518 = phi_2323_;
                                                        phi_2324_ = _e1518;
                                                        phi_2325_ = _e1516;
                                                    }
                                                    let _e1520 = phi_2324_;
                                                    let _e1522 = phi_2325_;
                                                    phi_2326_ = _e1520;
                                                    phi_2327_ = _e1330;
                                                    phi_2328_ = _e1522;
                                                } else {
                                                    phi_2326_ = true;
                                                    phi_2327_ = false;
                                                    phi_2328_ = false;
                                                }
                                                let _e1524 = phi_2326_;
                                                let _e1526 = phi_2327_;
                                                let _e1528 = phi_2328_;
                                                phi_2329_ = false;
                                                phi_2330_ = _e1524;
                                                phi_2331_ = _e1526;
                                                phi_2332_ = _e1528;
                                            } else {
                                                phi_2329_ = true;
                                                phi_2330_ = false;
                                                phi_2331_ = false;
                                                phi_2332_ = false;
                                            }
                                            let _e1530 = phi_2329_;
                                            let _e1532 = phi_2330_;
                                            let _e1534 = phi_2331_;
                                            let _e1536 = phi_2332_;
                                            phi_2333_ = _e1530;
                                            phi_2334_ = _e1532;
                                            phi_2335_ = _e1534;
                                            phi_2336_ = _e1536;
                                        } else {
                                            phi_2333_ = true;
                                            phi_2334_ = false;
                                            phi_2335_ = false;
                                            phi_2336_ = false;
                                        }
                                        let _e1538 = phi_2333_;
                                        let _e1540 = phi_2334_;
                                        let _e1542 = phi_2335_;
                                        let _e1544 = phi_2336_;
                                        if _e1538 {
                                            phi_2340_ = true;
                                            phi_2341_ = false;
                                            phi_2342_ = false;
                                        } else {
                                            phi_2340_ = _e1540;
                                            phi_2341_ = _e1542;
                                            phi_2342_ = _e1544;
                                        }
                                        let _e1546 = phi_2340_;
                                        let _e1548 = phi_2341_;
                                        let _e1550 = phi_2342_;
                                        if _e1546 {
                                            phi_2346_ = false;
                                            phi_2347_ = false;
                                        } else {
                                            phi_2346_ = _e1548;
                                            phi_2347_ = _e1550;
                                        }
                                        let _e1552 = phi_2346_;
                                        let _e1554 = phi_2347_;
                                        phi_1502_ = (_e837 & (_e837 - 1u));
                                        phi_2348_ = _e1546;
                                        phi_2349_ = _e1552;
                                        phi_2350_ = _e1554;
                                    }
                                    let _e1556 = phi_1502_;
                                    let _e1558 = phi_2348_;
                                    let _e1560 = phi_2349_;
                                    let _e1562 = phi_2350_;
                                    local_11 = _e1560;
                                    local_12 = _e1562;
                                    continue;
                                    continuing {
                                        phi_1501_ = _e1556;
                                        break if !(_e1558);
                                    }
                                }
                                let _e1565 = local_4;
                                if _e1565 {
                                    phi_2354_ = false;
                                    phi_2355_ = false;
                                } else {
                                    let _e3534 = local_11;
                                    phi_2354_ = _e3534;
                                    let _e3537 = local_12;
                                    phi_2355_ = _e3537;
                                }
                                let _e1567 = phi_2354_;
                                let _e1569 = phi_2355_;
                                phi_2383_ = _e571;
                                phi_2384_ = _e562;
                                let _e3546 = local_13;
                                phi_2385_ = _e3546;
                                phi_2386_ = _e1567;
                                phi_2387_ = _e1569;
                            } else {
                                if (_e831 == 0u) {
                                    phi_2381_ = _e571;
                                    phi_2382_ = _e562;
                                } else {
                                    if ((_e571 & 255u) == 0u) {
                                        phi_2377_ = _e562;
                                    } else {
                                        if (_e562 < 32u) {
                                            if (_e562 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_3[(0u + _e562)] = _e571;
                                            phi_2376_ = (_e562 + 1u);
                                        } else {
                                            phi_2376_ = _e562;
                                        }
                                        let _e1579 = phi_2376_;
                                        phi_2377_ = _e1579;
                                    }
                                    let _e1581 = phi_2377_;
                                    phi_2381_ = ((_e592.rest.z << bitcast<u32>(8i)) | _e831);
                                    phi_2382_ = _e1581;
                                }
                                let _e1588 = phi_2381_;
                                let _e1590 = phi_2382_;
                                phi_2383_ = _e1588;
                                phi_2384_ = _e1590;
                                phi_2385_ = true;
                                phi_2386_ = false;
                                phi_2387_ = false;
                            }
                            let _e1592 = phi_2383_;
                            let _e1594 = phi_2384_;
                            let _e1596 = phi_2385_;
                            let _e1598 = phi_2386_;
                            let _e1600 = phi_2387_;
                            if _e1596 {
                                if ((_e1592 & 255u) == 0u) {
                                    if (_e1594 > 0u) {
                                        let _e1604 = (_e1594 - 1u);
                                        if (_e1604 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1608 = local_3[(0u + _e1604)];
                                        phi_2408_ = _e1608;
                                        phi_2409_ = _e1604;
                                    } else {
                                        phi_2408_ = 0u;
                                        phi_2409_ = _e1594;
                                    }
                                    let _e1610 = phi_2408_;
                                    let _e1612 = phi_2409_;
                                    phi_2410_ = _e1610;
                                    phi_2411_ = _e1612;
                                } else {
                                    phi_2410_ = _e1592;
                                    phi_2411_ = _e1594;
                                }
                                let _e1614 = phi_2410_;
                                let _e1616 = phi_2411_;
                                phi_2412_ = _e1614;
                                phi_2413_ = _e1616;
                                phi_2414_ = false;
                                phi_2415_ = false;
                            } else {
                                phi_2412_ = u32();
                                phi_2413_ = u32();
                                phi_2414_ = _e1598;
                                phi_2415_ = _e1600;
                            }
                            let _e1618 = phi_2412_;
                            let _e1620 = phi_2413_;
                            let _e1622 = phi_2414_;
                            let _e1624 = phi_2415_;
                            phi_1212_ = _e1618;
                            phi_1215_ = _e1620;
                            phi_2416_ = _e1596;
                            phi_2417_ = _e1622;
                            phi_2418_ = _e1624;
                        }
                        let _e1626 = phi_1212_;
                        let _e1628 = phi_1215_;
                        let _e1630 = phi_2416_;
                        let _e1632 = phi_2417_;
                        let _e1634 = phi_2418_;
                        local_14 = _e1632;
                        local_15 = _e1634;
                        continue;
                        continuing {
                            phi_1211_ = _e1626;
                            phi_1214_ = _e1628;
                            break if !(_e1630);
                        }
                    }
                    let _e1637 = local_5;
                    if _e1637 {
                        phi_2422_ = false;
                        phi_2423_ = false;
                    } else {
                        let _e3565 = local_14;
                        phi_2422_ = _e3565;
                        let _e3568 = local_15;
                        phi_2423_ = _e3568;
                    }
                    let _e1639 = phi_2422_;
                    let _e1641 = phi_2423_;
                    if _e1639 {
                        phi_2427_ = false;
                    } else {
                        phi_2427_ = _e1641;
                    }
                    let _e1643 = phi_2427_;
                    if _e1643 {
                        phi_2431_ = true;
                    } else {
                        phi_2431_ = _e1639;
                    }
                    let _e1645 = phi_2431_;
                    if _e1645 {
                    }
                    phi_2435_ = true;
                    phi_2436_ = _e1645;
                }
                let _e1647 = phi_2435_;
                let _e1649 = phi_2436_;
                if _e1649 {
                    phi_2440_ = _e1647;
                } else {
                    phi_2440_ = false;
                }
                let _e1651 = phi_2440_;
                phi_4105_ = _e1651;
            } else {
                let _e1652 = abs(_e170);
                let _e1653 = abs(_e171);
                let _e1654 = abs(_e172);
                if (abs(_e150) < 1000000000000000f) {
                    if (abs(_e152) < 1000000000000000f) {
                        phi_2456_ = (abs(_e154) < 1000000000000000f);
                        phi_2457_ = false;
                    } else {
                        phi_2456_ = bool();
                        phi_2457_ = true;
                    }
                    let _e1662 = phi_2456_;
                    let _e1664 = phi_2457_;
                    phi_2458_ = _e1662;
                    phi_2459_ = _e1664;
                } else {
                    phi_2458_ = bool();
                    phi_2459_ = true;
                }
                let _e1666 = phi_2458_;
                let _e1668 = phi_2459_;
                if _e1668 {
                    phi_2463_ = false;
                } else {
                    phi_2463_ = _e1666;
                }
                let _e1670 = phi_2463_;
                if _e1670 {
                    if (_e1652 < 1000000000000000f) {
                        if (_e1653 < 1000000000000000f) {
                            phi_2476_ = (_e1654 < 1000000000000000f);
                            phi_2477_ = false;
                        } else {
                            phi_2476_ = bool();
                            phi_2477_ = true;
                        }
                        let _e1675 = phi_2476_;
                        let _e1677 = phi_2477_;
                        phi_2478_ = _e1675;
                        phi_2479_ = _e1677;
                    } else {
                        phi_2478_ = bool();
                        phi_2479_ = true;
                    }
                    let _e1679 = phi_2478_;
                    let _e1681 = phi_2479_;
                    if _e1681 {
                        phi_2483_ = false;
                    } else {
                        phi_2483_ = _e1679;
                    }
                    let _e1683 = phi_2483_;
                    if _e1683 {
                        if (_e1652 > 0f) {
                            phi_2497_ = bool();
                            phi_2498_ = true;
                        } else {
                            let _e1685 = (_e1653 > 0f);
                            if _e1685 {
                                phi_2496_ = bool();
                            } else {
                                phi_2496_ = (_e1654 > 0f);
                            }
                            let _e1688 = phi_2496_;
                            phi_2497_ = _e1688;
                            phi_2498_ = _e1685;
                        }
                        let _e1690 = phi_2497_;
                        let _e1692 = phi_2498_;
                        if _e1692 {
                            phi_2502_ = true;
                        } else {
                            phi_2502_ = _e1690;
                        }
                        let _e1694 = phi_2502_;
                        phi_2503_ = _e1694;
                        phi_2504_ = false;
                    } else {
                        phi_2503_ = bool();
                        phi_2504_ = true;
                    }
                    let _e1696 = phi_2503_;
                    let _e1698 = phi_2504_;
                    phi_2505_ = _e1696;
                    phi_2506_ = _e1698;
                } else {
                    phi_2505_ = bool();
                    phi_2506_ = true;
                }
                let _e1700 = phi_2505_;
                let _e1702 = phi_2506_;
                if _e1702 {
                    phi_2510_ = false;
                } else {
                    phi_2510_ = _e1700;
                }
                let _e1704 = phi_2510_;
                if _e1704 {
                    let _e1705 = (0u >= _e91);
                    if _e1705 {
                        phi_4098_ = bool();
                    } else {
                        if (0u < _e91) {
                        } else {
                            return;
                        }
                        let _e1711 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1715 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1719 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1723 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1727 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1731 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1735 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1769 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170), abs(_e171));
                        let _e1770 = core_intrinsics_maximum_number_nsz_f32_(_e1769, abs(_e172));
                        let _e1771 = (_e1770 * 0.0000000000009094947f);
                        if (abs(_e170) < _e1771) {
                            phi_2580_ = _e1771;
                        } else {
                            phi_2580_ = abs(_e170);
                        }
                        let _e1776 = phi_2580_;
                        if (_e170 < 0f) {
                            phi_2587_ = (-1f / _e1776);
                        } else {
                            phi_2587_ = (1f / _e1776);
                        }
                        let _e1781 = phi_2587_;
                        if (abs(_e171) < _e1771) {
                            phi_2594_ = _e1771;
                        } else {
                            phi_2594_ = abs(_e171);
                        }
                        let _e1786 = phi_2594_;
                        if (_e171 < 0f) {
                            phi_2601_ = (-1f / _e1786);
                        } else {
                            phi_2601_ = (1f / _e1786);
                        }
                        let _e1791 = phi_2601_;
                        if (abs(_e172) < _e1771) {
                            phi_2608_ = _e1771;
                        } else {
                            phi_2608_ = abs(_e172);
                        }
                        let _e1796 = phi_2608_;
                        if (_e172 < 0f) {
                            phi_2615_ = (-1f / _e1796);
                        } else {
                            phi_2615_ = (1f / _e1796);
                        }
                        let _e1801 = phi_2615_;
                        let _e1805 = abs((bitcast<f32>(_e1711) - _e150));
                        let _e1806 = abs((bitcast<f32>(_e1715) - _e152));
                        let _e1807 = abs((bitcast<f32>(_e1719) - _e154));
                        let _e1811 = abs(((bitcast<f32>(_e1723) + (bitcast<f32>((((_e1735 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150));
                        let _e1812 = abs(((bitcast<f32>(_e1727) + (bitcast<f32>((((_e1735 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e152));
                        let _e1813 = abs(((bitcast<f32>(_e1731) + (bitcast<f32>((((_e1735 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154));
                        if (_e1805 > _e1811) {
                            phi_2632_ = _e1805;
                        } else {
                            phi_2632_ = _e1811;
                        }
                        let _e1816 = phi_2632_;
                        if (_e1806 > _e1812) {
                            phi_2637_ = _e1806;
                        } else {
                            phi_2637_ = _e1812;
                        }
                        let _e1819 = phi_2637_;
                        if (_e1807 > _e1813) {
                            phi_2642_ = _e1807;
                        } else {
                            phi_2642_ = _e1813;
                        }
                        let _e1822 = phi_2642_;
                        if (_e1816 > _e1819) {
                            phi_2647_ = _e1816;
                        } else {
                            phi_2647_ = _e1819;
                        }
                        let _e1825 = phi_2647_;
                        if (_e1825 > _e1822) {
                            phi_2652_ = _e1825;
                        } else {
                            phi_2652_ = _e1822;
                        }
                        let _e1828 = phi_2652_;
                        let _e1832 = (_e1828 * 0.0000019073486f);
                        let _e1833 = (abs(_e1781) * _e1832);
                        let _e1834 = (abs(_e1791) * _e1832);
                        let _e1835 = (abs(_e1801) * _e1832);
                        let _e1839 = (_e1828 * 0.0000009536743f);
                        let _e1840 = (abs(_e1781) * _e1839);
                        let _e1841 = (abs(_e1791) * _e1839);
                        let _e1842 = (abs(_e1801) * _e1839);
                        let _e1843 = abs(_e170);
                        let _e1844 = abs(_e171);
                        let _e1845 = abs(_e172);
                        if (_e1843 >= _e1844) {
                            if (_e1843 >= _e1845) {
                                phi_2678_ = false;
                            } else {
                                phi_2678_ = true;
                            }
                            let _e1849 = phi_2678_;
                            phi_2679_ = _e1849;
                        } else {
                            phi_2679_ = true;
                        }
                        let _e1851 = phi_2679_;
                        if _e1851 {
                            if (_e1844 >= _e1845) {
                                phi_2687_ = 1u;
                            } else {
                                phi_2687_ = 2u;
                            }
                            let _e1854 = phi_2687_;
                            phi_2688_ = _e1854;
                        } else {
                            phi_2688_ = 0u;
                        }
                        let _e1856 = phi_2688_;
                        if (_e1856 == 0u) {
                            phi_2700_ = vec3<f32>(_e171, _e172, _e170);
                        } else {
                            if (_e1856 == 1u) {
                                phi_2699_ = vec3<f32>(_e172, _e170, _e171);
                            } else {
                                phi_2699_ = _e173;
                            }
                            let _e1862 = phi_2699_;
                            phi_2700_ = _e1862;
                        }
                        let _e1864 = phi_2700_;
                        let _e1867 = (_e1864.x / _e1864.z);
                        let _e1870 = (_e1864.y / _e1864.z);
                        if (_e1781 < 0f) {
                            phi_2713_ = 0u;
                        } else {
                            phi_2713_ = 1u;
                        }
                        let _e1875 = phi_2713_;
                        if (_e1791 < 0f) {
                            phi_2718_ = 0u;
                        } else {
                            phi_2718_ = 2u;
                        }
                        let _e1878 = phi_2718_;
                        if (_e1801 < 0f) {
                            phi_2723_ = 0u;
                        } else {
                            phi_2723_ = 4u;
                        }
                        let _e1881 = phi_2723_;
                        let _e1883 = ((_e1875 | _e1878) | _e1881);
                        let _e1884 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1884.first[0], _e1884.first[1], _e1884.first[2], _e1884.first[3], _e1884.first[4], _e1884.first[5], _e1884.first[6], _e1884.first[7], _e1884.first[8], _e1884.first[9], _e1884.first[10], _e1884.first[11], _e1884.first[12], _e1884.first[13], _e1884.first[14], _e1884.first[15], _e1884.first[16], _e1884.first[17], _e1884.first[18], _e1884.first[19], _e1884.first[20], _e1884.first[21], _e1884.first[22], _e1884.first[23], _e1884.first[24], _e1884.first[25], _e1884.first[26], _e1884.first[27], _e1884.first[28], _e1884.first[29], _e1884.first[30], _e1884.first[31]), array<u32, 32>(_e1884.mask[0], _e1884.mask[1], _e1884.mask[2], _e1884.mask[3], _e1884.mask[4], _e1884.mask[5], _e1884.mask[6], _e1884.mask[7], _e1884.mask[8], _e1884.mask[9], _e1884.mask[10], _e1884.mask[11], _e1884.mask[12], _e1884.mask[13], _e1884.mask[14], _e1884.mask[15], _e1884.mask[16], _e1884.mask[17], _e1884.mask[18], _e1884.mask[19], _e1884.mask[20], _e1884.mask[21], _e1884.mask[22], _e1884.mask[23], _e1884.mask[24], _e1884.mask[25], _e1884.mask[26], _e1884.mask[27], _e1884.mask[28], _e1884.mask[29], _e1884.mask[30], _e1884.mask[31]), _e1884.len, _e1884.group, _e1884.group_mask);
                        let _e1958 = local_1.group_mask;
                        if ((_e1958 & 4278190080u) == 0u) {
                            let _e1962 = local_1.len;
                            if (_e1962 == 0u) {
                                phi_2837_ = false;
                            } else {
                                let _e1966 = local_1.len;
                                local_1.len = (_e1966 - 1u);
                                let _e1969 = local_1.len;
                                if (_e1969 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1974 = local_1.first[(0u + _e1969)];
                                local_1.group = _e1974;
                                let _e1977 = local_1.len;
                                if (_e1977 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1982 = local_1.mask[(0u + _e1977)];
                                local_1.group_mask = _e1982;
                                phi_2837_ = true;
                            }
                            let _e1985 = phi_2837_;
                            phi_2838_ = _e1985;
                        } else {
                            phi_2838_ = true;
                        }
                        let _e1987 = phi_2838_;
                        if _e1987 {
                            let _e1989 = local_1.group_mask;
                            let _e1995 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1989)), 32u, (_e1989 == 0u)));
                            let _e1999 = local_1.group_mask;
                            let _e2013 = local_1.group_mask;
                            local_1.group_mask = (_e2013 & ~((1u << bitcast<u32>((_e1995 & 31u)))));
                            let _e2016 = local_1.group;
                            phi_2869_ = (_e2016 + countOneBits(((_e1999 & ~((4294967295u << bitcast<u32>((((_e1995 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2869_ = 4294967295u;
                        }
                        let _e2019 = phi_2869_;
                        phi_2871_ = _e2019;
                        phi_2874_ = false;
                        loop {
                            let _e2021 = phi_2871_;
                            let _e2023 = phi_2874_;
                            local_20 = _e2023;
                            if (_e2021 != 4294967295u) {
                                if (_e2021 < _e91) {
                                } else {
                                    return;
                                }
                                let _e2030 = nodes.member[(0u + _e2021)].frame[3u];
                                let _e2055 = (bitcast<f32>((((_e2030 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1781);
                                let _e2056 = (bitcast<f32>((((_e2030 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1791);
                                let _e2057 = (bitcast<f32>((((_e2030 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1801);
                                let _e2060 = nodes.member[(0u + _e2021)].frame[0u];
                                let _e2064 = nodes.member[(0u + _e2021)].frame[1u];
                                let _e2068 = nodes.member[(0u + _e2021)].frame[2u];
                                let _e2073 = ((bitcast<f32>(_e2060) - _e150) * _e1781);
                                let _e2074 = ((bitcast<f32>(_e2064) - _e152) * _e1791);
                                let _e2075 = ((bitcast<f32>(_e2068) - _e154) * _e1801);
                                let _e2083 = nodes.member[(0u + _e2021)].x;
                                if (_e1781 < 0f) {
                                    let _e2094 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2083.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2100 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2094.unnamed.word, _e2083.w), _e2094.unnamed_1);
                                    let _e2106 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2100.unnamed, lt_mask_LightPlace(_e2083.x, _e2100.unnamed_1.shift));
                                    phi_2954_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2106.unnamed, lt_mask_LightPlace(_e2106.unnamed_1.word, _e2083.y));
                                } else {
                                    let _e2122 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2083.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2128 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2122.unnamed.word, _e2083.y), _e2122.unnamed_1);
                                    let _e2134 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2128.unnamed, lt_mask_LightPlace(_e2083.z, _e2128.unnamed_1.shift));
                                    phi_2954_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2134.unnamed, lt_mask_LightPlace(_e2134.unnamed_1.word, _e2083.w));
                                }
                                let _e2142 = phi_2954_;
                                let _e2152 = nodes.member[(0u + _e2021)].y;
                                if (_e1791 < 0f) {
                                    let _e2163 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2152.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2169 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2163.unnamed.word, _e2152.w), _e2163.unnamed_1);
                                    let _e2175 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2169.unnamed, lt_mask_LightPlace(_e2152.x, _e2169.unnamed_1.shift));
                                    phi_2981_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2175.unnamed, lt_mask_LightPlace(_e2175.unnamed_1.word, _e2152.y));
                                } else {
                                    let _e2191 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2152.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2197 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2191.unnamed.word, _e2152.y), _e2191.unnamed_1);
                                    let _e2203 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2197.unnamed, lt_mask_LightPlace(_e2152.z, _e2197.unnamed_1.shift));
                                    phi_2981_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2203.unnamed, lt_mask_LightPlace(_e2203.unnamed_1.word, _e2152.w));
                                }
                                let _e2211 = phi_2981_;
                                let _e2221 = nodes.member[(0u + _e2021)].z;
                                if (_e1801 < 0f) {
                                    let _e2232 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2221.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2238 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2232.unnamed.word, _e2221.w), _e2232.unnamed_1);
                                    let _e2244 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2238.unnamed, lt_mask_LightPlace(_e2221.x, _e2238.unnamed_1.shift));
                                    phi_3008_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2244.unnamed, lt_mask_LightPlace(_e2244.unnamed_1.word, _e2221.y));
                                } else {
                                    let _e2260 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2221.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2266 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2260.unnamed.word, _e2221.y), _e2260.unnamed_1);
                                    let _e2272 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2266.unnamed, lt_mask_LightPlace(_e2221.z, _e2266.unnamed_1.shift));
                                    phi_3008_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2272.unnamed, lt_mask_LightPlace(_e2272.unnamed_1.word, _e2221.w));
                                }
                                let _e2280 = phi_3008_;
                                phi_3014_ = 0u;
                                phi_3017_ = 0u;
                                loop {
                                    let _e2290 = phi_3014_;
                                    let _e2292 = phi_3017_;
                                    local_6 = _e2292;
                                    local_7 = _e2292;
                                    local_8 = _e2292;
                                    let _e2293 = (_e2290 < 8u);
                                    if _e2293 {
                                        let _e2295 = (_e2290 >> bitcast<u32>(2i));
                                        let _e2296 = (_e2290 & 3u);
                                        if (_e2295 == 0u) {
                                            phi_3031_ = _e2142.unnamed.word;
                                        } else {
                                            phi_3031_ = _e2142.unnamed.shift;
                                        }
                                        let _e2299 = phi_3031_;
                                        if (_e2295 == 0u) {
                                            phi_3041_ = _e2211.unnamed.word;
                                        } else {
                                            phi_3041_ = _e2211.unnamed.shift;
                                        }
                                        let _e2308 = phi_3041_;
                                        if (_e2295 == 0u) {
                                            phi_3051_ = _e2280.unnamed.word;
                                        } else {
                                            phi_3051_ = _e2280.unnamed.shift;
                                        }
                                        let _e2317 = phi_3051_;
                                        let _e2330 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2299 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u)) * _e2055) + (_e2073 - _e1833)), ((f32(((_e2308 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u)) * _e2056) + (_e2074 - _e1834)));
                                        let _e2331 = core_intrinsics_maximum_number_nsz_f32_(_e2330, ((f32(((_e2317 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u)) * _e2057) + (_e2075 - _e1835)));
                                        if (_e2295 == 0u) {
                                            phi_3069_ = _e2142.unnamed_1.word;
                                        } else {
                                            phi_3069_ = _e2142.unnamed_1.shift;
                                        }
                                        let _e2334 = phi_3069_;
                                        if (_e2295 == 0u) {
                                            phi_3079_ = _e2211.unnamed_1.word;
                                        } else {
                                            phi_3079_ = _e2211.unnamed_1.shift;
                                        }
                                        let _e2343 = phi_3079_;
                                        if (_e2295 == 0u) {
                                            phi_3089_ = _e2280.unnamed_1.word;
                                        } else {
                                            phi_3089_ = _e2280.unnamed_1.shift;
                                        }
                                        let _e2352 = phi_3089_;
                                        let _e2365 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2334 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u)) * _e2055) + (_e2073 + _e1833)), ((f32(((_e2343 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u)) * _e2056) + (_e2074 + _e1834)));
                                        let _e2366 = core_intrinsics_minimum_number_nsz_f32_(_e2365, ((f32(((_e2352 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u)) * _e2057) + (_e2075 + _e1835)));
                                        if (_e2331 <= _e2366) {
                                            if (_e2331 <= _e162) {
                                                if (_e2366 >= 0f) {
                                                    if (_e2295 == 0u) {
                                                        let _e2373 = nodes.member[(0u + _e2021)].links[2u];
                                                        phi_3125_ = _e2373;
                                                    } else {
                                                        let _e2376 = nodes.member[(0u + _e2021)].links[3u];
                                                        phi_3125_ = _e2376;
                                                    }
                                                    let _e2378 = phi_3125_;
                                                    let _e2383 = ((_e2378 >> bitcast<u32>(((_e2296 * 8u) & 31u))) & 255u);
                                                    let _e2384 = (_e2383 & 31u);
                                                    if (_e2384 >= 24u) {
                                                        phi_3138_ = (24u + ((_e2384 - 24u) ^ _e1883));
                                                    } else {
                                                        phi_3138_ = _e2384;
                                                    }
                                                    let _e2390 = phi_3138_;
                                                    phi_3143_ = (_e2292 | ((_e2383 >> bitcast<u32>(5i)) << bitcast<u32>((_e2390 & 31u))));
                                                } else {
                                                    phi_3143_ = _e2292;
                                                }
                                                let _e2398 = phi_3143_;
                                                phi_3144_ = _e2398;
                                            } else {
                                                phi_3144_ = _e2292;
                                            }
                                            let _e2400 = phi_3144_;
                                            phi_3145_ = _e2400;
                                        } else {
                                            phi_3145_ = _e2292;
                                        }
                                        let _e2402 = phi_3145_;
                                        phi_3015_ = (_e2290 + 1u);
                                        phi_3018_ = _e2402;
                                    } else {
                                        phi_3015_ = u32();
                                        phi_3018_ = u32();
                                    }
                                    let _e2405 = phi_3015_;
                                    let _e2407 = phi_3018_;
                                    continue;
                                    continuing {
                                        phi_3014_ = _e2405;
                                        phi_3017_ = _e2407;
                                        break if !(_e2293);
                                    }
                                }
                                let _e2411 = nodes.member[(0u + _e2021)].links[0u];
                                let _e2415 = nodes.member[(0u + _e2021)].frame[3u];
                                let _e2419 = local_6;
                                if ((_e2419 & 4278190080u) == 0u) {
                                } else {
                                    let _e2423 = local_1.group_mask;
                                    if ((_e2423 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2427 = local_1.len;
                                        if (_e2427 < 32u) {
                                            let _e2430 = local_1.group;
                                            let _e2432 = local_1.len;
                                            if (_e2432 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2432)] = _e2430;
                                            let _e2438 = local_1.group_mask;
                                            let _e2440 = local_1.len;
                                            if (_e2440 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2440)] = _e2438;
                                            let _e2447 = local_1.len;
                                            local_1.len = (_e2447 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2411);
                                    let _e2451 = local_7;
                                    local_1.group_mask = ((_e2451 & 4278190080u) | (_e2415 >> bitcast<u32>(24i)));
                                }
                                let _e2456 = local_8;
                                phi_3203_ = (_e2456 & 16777215u);
                                phi_3206_ = _e2023;
                                loop {
                                    let _e2459 = phi_3203_;
                                    let _e2461 = phi_3206_;
                                    local_16 = _e2461;
                                    let _e2462 = (_e2459 == 0u);
                                    local_9 = _e2462;
                                    local_18 = _e2462;
                                    if _e2462 {
                                        phi_3204_ = u32();
                                        phi_3207_ = bool();
                                        phi_4010_ = bool();
                                        phi_4011_ = false;
                                    } else {
                                        let _e2465 = nodes.member[(0u + _e2021)].links[1u];
                                        let _e2470 = ((0u + _e2465) + select(firstTrailingBit(_e2459), 32u, (_e2459 == 0u)));
                                        if (_e2470 < _e94) {
                                        } else {
                                            return;
                                        }
                                        let _e2477 = triangles.member[(0u + _e2470)].v0_;
                                        let _e2479 = (_e2477.x - _e150);
                                        let _e2481 = (_e2477.y - _e152);
                                        let _e2483 = (_e2477.z - _e154);
                                        if (_e1856 == 0u) {
                                            phi_3251_ = vec3<f32>(_e2481, _e2483, _e2479);
                                        } else {
                                            if (_e1856 == 1u) {
                                                phi_3250_ = vec3<f32>(_e2483, _e2479, _e2481);
                                            } else {
                                                phi_3250_ = (_e2477 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2491 = phi_3250_;
                                            phi_3251_ = _e2491;
                                        }
                                        let _e2493 = phi_3251_;
                                        let _e2497 = (_e2493.x - (_e1867 * _e2493.z));
                                        let _e2501 = (_e2493.y - (_e1870 * _e2493.z));
                                        let _e2503 = triangles.member[(0u + _e2470)].v1_;
                                        let _e2505 = (_e2503.x - _e150);
                                        let _e2507 = (_e2503.y - _e152);
                                        let _e2509 = (_e2503.z - _e154);
                                        if (_e1856 == 0u) {
                                            phi_3281_ = vec3<f32>(_e2507, _e2509, _e2505);
                                        } else {
                                            if (_e1856 == 1u) {
                                                phi_3280_ = vec3<f32>(_e2509, _e2505, _e2507);
                                            } else {
                                                phi_3280_ = (_e2503 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2517 = phi_3280_;
                                            phi_3281_ = _e2517;
                                        }
                                        let _e2519 = phi_3281_;
                                        let _e2523 = (_e2519.x - (_e1867 * _e2519.z));
                                        let _e2527 = (_e2519.y - (_e1870 * _e2519.z));
                                        let _e2529 = triangles.member[(0u + _e2470)].v2_;
                                        let _e2531 = (_e2529.x - _e150);
                                        let _e2533 = (_e2529.y - _e152);
                                        let _e2535 = (_e2529.z - _e154);
                                        if (_e1856 == 0u) {
                                            phi_3311_ = vec3<f32>(_e2533, _e2535, _e2531);
                                        } else {
                                            if (_e1856 == 1u) {
                                                phi_3310_ = vec3<f32>(_e2535, _e2531, _e2533);
                                            } else {
                                                phi_3310_ = (_e2529 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2543 = phi_3310_;
                                            phi_3311_ = _e2543;
                                        }
                                        let _e2545 = phi_3311_;
                                        let _e2549 = (_e2545.x - (_e1867 * _e2545.z));
                                        let _e2553 = (_e2545.y - (_e1870 * _e2545.z));
                                        if (_e2523 < _e2549) {
                                            phi_3330_ = true;
                                        } else {
                                            if (_e2523 == _e2549) {
                                                phi_3329_ = (_e2527 < _e2553);
                                            } else {
                                                phi_3329_ = false;
                                            }
                                            let _e2558 = phi_3329_;
                                            phi_3330_ = _e2558;
                                        }
                                        let _e2560 = phi_3330_;
                                        if _e2560 {
                                            phi_3334_ = _e2553;
                                            phi_3335_ = _e2549;
                                            phi_3336_ = _e2527;
                                            phi_3337_ = _e2523;
                                        } else {
                                            phi_3334_ = _e2527;
                                            phi_3335_ = _e2523;
                                            phi_3336_ = _e2553;
                                            phi_3337_ = _e2549;
                                        }
                                        let _e2562 = phi_3334_;
                                        let _e2564 = phi_3335_;
                                        let _e2566 = phi_3336_;
                                        let _e2568 = phi_3337_;
                                        let _e2571 = ((_e2568 * _e2562) - (_e2566 * _e2564));
                                        if _e2560 {
                                            phi_3345_ = -(_e2571);
                                        } else {
                                            phi_3345_ = _e2571;
                                        }
                                        let _e2574 = phi_3345_;
                                        if (_e2549 < _e2497) {
                                            phi_3356_ = true;
                                        } else {
                                            if (_e2549 == _e2497) {
                                                phi_3355_ = (_e2553 < _e2501);
                                            } else {
                                                phi_3355_ = false;
                                            }
                                            let _e2579 = phi_3355_;
                                            phi_3356_ = _e2579;
                                        }
                                        let _e2581 = phi_3356_;
                                        if _e2581 {
                                            phi_3360_ = _e2501;
                                            phi_3361_ = _e2497;
                                            phi_3362_ = _e2553;
                                            phi_3363_ = _e2549;
                                        } else {
                                            phi_3360_ = _e2553;
                                            phi_3361_ = _e2549;
                                            phi_3362_ = _e2501;
                                            phi_3363_ = _e2497;
                                        }
                                        let _e2583 = phi_3360_;
                                        let _e2585 = phi_3361_;
                                        let _e2587 = phi_3362_;
                                        let _e2589 = phi_3363_;
                                        let _e2592 = ((_e2589 * _e2583) - (_e2587 * _e2585));
                                        if _e2581 {
                                            phi_3371_ = -(_e2592);
                                        } else {
                                            phi_3371_ = _e2592;
                                        }
                                        let _e2595 = phi_3371_;
                                        if (_e2497 < _e2523) {
                                            phi_3382_ = true;
                                        } else {
                                            if (_e2497 == _e2523) {
                                                phi_3381_ = (_e2501 < _e2527);
                                            } else {
                                                phi_3381_ = false;
                                            }
                                            let _e2600 = phi_3381_;
                                            phi_3382_ = _e2600;
                                        }
                                        let _e2602 = phi_3382_;
                                        if _e2602 {
                                            phi_3386_ = _e2527;
                                            phi_3387_ = _e2523;
                                            phi_3388_ = _e2501;
                                            phi_3389_ = _e2497;
                                        } else {
                                            phi_3386_ = _e2501;
                                            phi_3387_ = _e2497;
                                            phi_3388_ = _e2527;
                                            phi_3389_ = _e2523;
                                        }
                                        let _e2604 = phi_3386_;
                                        let _e2606 = phi_3387_;
                                        let _e2608 = phi_3388_;
                                        let _e2610 = phi_3389_;
                                        let _e2613 = ((_e2610 * _e2604) - (_e2608 * _e2606));
                                        if _e2602 {
                                            phi_3397_ = -(_e2613);
                                        } else {
                                            phi_3397_ = _e2613;
                                        }
                                        let _e2616 = phi_3397_;
                                        if (_e2574 >= 0f) {
                                            if (_e2595 >= 0f) {
                                                if (_e2616 >= 0f) {
                                                    phi_3412_ = ((_e2574 + _e2595) + _e2616);
                                                    phi_3413_ = false;
                                                } else {
                                                    phi_3412_ = f32();
                                                    phi_3413_ = true;
                                                }
                                                let _e2623 = phi_3412_;
                                                let _e2625 = phi_3413_;
                                                phi_3414_ = _e2623;
                                                phi_3415_ = _e2625;
                                            } else {
                                                phi_3414_ = f32();
                                                phi_3415_ = true;
                                            }
                                            let _e2627 = phi_3414_;
                                            let _e2629 = phi_3415_;
                                            phi_3416_ = _e2627;
                                            phi_3417_ = _e2629;
                                        } else {
                                            phi_3416_ = f32();
                                            phi_3417_ = true;
                                        }
                                        let _e2631 = phi_3416_;
                                        let _e2633 = phi_3417_;
                                        if _e2633 {
                                            if (_e2574 <= 0f) {
                                                if (_e2595 <= 0f) {
                                                    let _e2636 = (_e2616 <= 0f);
                                                    if _e2636 {
                                                    }
                                                    phi_3435_ = ((_e2574 + _e2595) + _e2616);
                                                    phi_3436_ = false;
                                                    phi_3437_ = _e2636;
                                                } else {
                                                    phi_3435_ = f32();
                                                    phi_3436_ = true;
                                                    phi_3437_ = false;
                                                }
                                                let _e2640 = phi_3435_;
                                                let _e2642 = phi_3436_;
                                                let _e2644 = phi_3437_;
                                                phi_3438_ = _e2640;
                                                phi_3439_ = _e2642;
                                                phi_3440_ = _e2644;
                                            } else {
                                                phi_3438_ = f32();
                                                phi_3439_ = true;
                                                phi_3440_ = false;
                                            }
                                            let _e2646 = phi_3438_;
                                            let _e2648 = phi_3439_;
                                            let _e2650 = phi_3440_;
                                            if _e2648 {
                                                phi_3444_ = false;
                                            } else {
                                                phi_3444_ = _e2650;
                                            }
                                            let _e2652 = phi_3444_;
                                            phi_3445_ = _e2646;
                                            phi_3446_ = _e2652;
                                        } else {
                                            phi_3445_ = _e2631;
                                            phi_3446_ = true;
                                        }
                                        let _e2654 = phi_3445_;
                                        let _e2656 = phi_3446_;
                                        if _e2656 {
                                            let _e2657 = (_e2654 == 0f);
                                            if _e2657 {
                                                phi_3762_ = lt_bvh_triangle_Intersection();
                                                phi_3763_ = false;
                                            } else {
                                                let _e2659 = triangles.member[(0u + _e2470)].v0_;
                                                let _e2661 = (_e2659.x - _e150);
                                                let _e2663 = (_e2659.y - _e152);
                                                let _e2665 = (_e2659.z - _e154);
                                                if (_e1856 == 0u) {
                                                    phi_3475_ = vec3<f32>(_e2663, _e2665, _e2661);
                                                } else {
                                                    if (_e1856 == 1u) {
                                                        phi_3474_ = vec3<f32>(_e2665, _e2661, _e2663);
                                                    } else {
                                                        phi_3474_ = (_e2659 - vec3<f32>(_e150, _e152, _e154));
                                                    }
                                                    let _e2673 = phi_3474_;
                                                    phi_3475_ = _e2673;
                                                }
                                                let _e2675 = phi_3475_;
                                                let _e2677 = triangles.member[(0u + _e2470)].v1_;
                                                let _e2679 = triangles.member[(0u + _e2470)].v0_;
                                                let _e2682 = (_e2677.x - _e2679.x);
                                                let _e2685 = (_e2677.y - _e2679.y);
                                                let _e2688 = (_e2677.z - _e2679.z);
                                                if (_e1856 == 0u) {
                                                    phi_3501_ = vec3<f32>(_e2685, _e2688, _e2682);
                                                } else {
                                                    if (_e1856 == 1u) {
                                                        phi_3500_ = vec3<f32>(_e2688, _e2682, _e2685);
                                                    } else {
                                                        phi_3500_ = (_e2677 - _e2679);
                                                    }
                                                    let _e2695 = phi_3500_;
                                                    phi_3501_ = _e2695;
                                                }
                                                let _e2697 = phi_3501_;
                                                let _e2699 = triangles.member[(0u + _e2470)].v2_;
                                                let _e2701 = triangles.member[(0u + _e2470)].v0_;
                                                let _e2704 = (_e2699.x - _e2701.x);
                                                let _e2707 = (_e2699.y - _e2701.y);
                                                let _e2710 = (_e2699.z - _e2701.z);
                                                if (_e1856 == 0u) {
                                                    phi_3527_ = vec3<f32>(_e2707, _e2710, _e2704);
                                                } else {
                                                    if (_e1856 == 1u) {
                                                        phi_3526_ = vec3<f32>(_e2710, _e2704, _e2707);
                                                    } else {
                                                        phi_3526_ = (_e2699 - _e2701);
                                                    }
                                                    let _e2717 = phi_3526_;
                                                    phi_3527_ = _e2717;
                                                }
                                                let _e2719 = phi_3527_;
                                                let _e2726 = ((_e2697.y * _e2719.z) - (_e2697.z * _e2719.y));
                                                let _e2733 = ((_e2697.z * _e2719.x) - (_e2697.x * _e2719.z));
                                                let _e2740 = ((_e2697.x * _e2719.y) - (_e2697.y * _e2719.x));
                                                let _e2754 = (((1f / _e1864.z) * (((_e2726 * _e2675.x) + (_e2733 * _e2675.y)) + (_e2740 * _e2675.z))) / (((_e2726 * _e1867) + (_e2733 * _e1870)) + _e2740));
                                                if (_e2754 > 0f) {
                                                    if (_e2754 < _e162) {
                                                        let _e2758 = triangles.member[(0u + _e2470)].v0_;
                                                        let _e2760 = triangles.member[(0u + _e2470)].v1_;
                                                        if (_e2758.x < _e2760.x) {
                                                            phi_3583_ = _e2758.x;
                                                        } else {
                                                            phi_3583_ = _e2760.x;
                                                        }
                                                        let _e2767 = phi_3583_;
                                                        if (_e2758.y < _e2760.y) {
                                                            phi_3592_ = _e2758.y;
                                                        } else {
                                                            phi_3592_ = _e2760.y;
                                                        }
                                                        let _e2774 = phi_3592_;
                                                        if (_e2758.z < _e2760.z) {
                                                            phi_3601_ = _e2758.z;
                                                        } else {
                                                            phi_3601_ = _e2760.z;
                                                        }
                                                        let _e2781 = phi_3601_;
                                                        let _e2783 = triangles.member[(0u + _e2470)].v2_;
                                                        if (_e2767 < _e2783.x) {
                                                            phi_3610_ = _e2767;
                                                        } else {
                                                            phi_3610_ = _e2783.x;
                                                        }
                                                        let _e2788 = phi_3610_;
                                                        if (_e2774 < _e2783.y) {
                                                            phi_3617_ = _e2774;
                                                        } else {
                                                            phi_3617_ = _e2783.y;
                                                        }
                                                        let _e2793 = phi_3617_;
                                                        if (_e2781 < _e2783.z) {
                                                            phi_3624_ = _e2781;
                                                        } else {
                                                            phi_3624_ = _e2783.z;
                                                        }
                                                        let _e2798 = phi_3624_;
                                                        let _e2800 = triangles.member[(0u + _e2470)].v0_;
                                                        let _e2802 = triangles.member[(0u + _e2470)].v1_;
                                                        if (_e2800.x > _e2802.x) {
                                                            phi_3637_ = _e2800.x;
                                                        } else {
                                                            phi_3637_ = _e2802.x;
                                                        }
                                                        let _e2809 = phi_3637_;
                                                        if (_e2800.y > _e2802.y) {
                                                            phi_3646_ = _e2800.y;
                                                        } else {
                                                            phi_3646_ = _e2802.y;
                                                        }
                                                        let _e2816 = phi_3646_;
                                                        if (_e2800.z > _e2802.z) {
                                                            phi_3655_ = _e2800.z;
                                                        } else {
                                                            phi_3655_ = _e2802.z;
                                                        }
                                                        let _e2823 = phi_3655_;
                                                        let _e2825 = triangles.member[(0u + _e2470)].v2_;
                                                        if (_e2809 > _e2825.x) {
                                                            phi_3664_ = _e2809;
                                                        } else {
                                                            phi_3664_ = _e2825.x;
                                                        }
                                                        let _e2830 = phi_3664_;
                                                        if (_e2816 > _e2825.y) {
                                                            phi_3671_ = _e2816;
                                                        } else {
                                                            phi_3671_ = _e2825.y;
                                                        }
                                                        let _e2835 = phi_3671_;
                                                        if (_e2823 > _e2825.z) {
                                                            phi_3678_ = _e2823;
                                                        } else {
                                                            phi_3678_ = _e2825.z;
                                                        }
                                                        let _e2840 = phi_3678_;
                                                        let _e2844 = ((_e2788 - _e150) * _e1781);
                                                        let _e2845 = ((_e2793 - _e152) * _e1791);
                                                        let _e2846 = ((_e2798 - _e154) * _e1801);
                                                        let _e2850 = ((_e2830 - _e150) * _e1781);
                                                        let _e2851 = ((_e2835 - _e152) * _e1791);
                                                        let _e2852 = ((_e2840 - _e154) * _e1801);
                                                        if (_e2844 < _e2850) {
                                                            phi_3695_ = _e2844;
                                                        } else {
                                                            phi_3695_ = _e2850;
                                                        }
                                                        let _e2855 = phi_3695_;
                                                        if (_e2845 < _e2851) {
                                                            phi_3700_ = _e2845;
                                                        } else {
                                                            phi_3700_ = _e2851;
                                                        }
                                                        let _e2858 = phi_3700_;
                                                        if (_e2846 < _e2852) {
                                                            phi_3705_ = _e2846;
                                                        } else {
                                                            phi_3705_ = _e2852;
                                                        }
                                                        let _e2861 = phi_3705_;
                                                        if (_e2844 > _e2850) {
                                                            phi_3713_ = _e2844;
                                                        } else {
                                                            phi_3713_ = _e2850;
                                                        }
                                                        let _e2867 = phi_3713_;
                                                        if (_e2845 > _e2851) {
                                                            phi_3718_ = _e2845;
                                                        } else {
                                                            phi_3718_ = _e2851;
                                                        }
                                                        let _e2870 = phi_3718_;
                                                        if (_e2846 > _e2852) {
                                                            phi_3723_ = _e2846;
                                                        } else {
                                                            phi_3723_ = _e2852;
                                                        }
                                                        let _e2873 = phi_3723_;
                                                        let _e2877 = core_intrinsics_maximum_number_nsz_f32_((_e2855 - _e1840), (_e2858 - _e1841));
                                                        let _e2878 = core_intrinsics_maximum_number_nsz_f32_(_e2877, (_e2861 - _e1842));
                                                        let _e2879 = core_intrinsics_minimum_number_nsz_f32_((_e2867 + _e1840), (_e2870 + _e1841));
                                                        let _e2880 = core_intrinsics_minimum_number_nsz_f32_(_e2879, (_e2873 + _e1842));
                                                        if (_e2878 > -300000000000000000000000000000000000000f) {
                                                            phi_3735_ = _e2878;
                                                        } else {
                                                            phi_3735_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2883 = phi_3735_;
                                                        if (_e2880 < 300000000000000000000000000000000000000f) {
                                                            phi_3740_ = _e2880;
                                                        } else {
                                                            phi_3740_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2886 = phi_3740_;
                                                        if (_e2754 < _e2883) {
                                                            phi_3745_ = _e2883;
                                                        } else {
                                                            phi_3745_ = _e2754;
                                                        }
                                                        let _e2889 = phi_3745_;
                                                        if (_e2889 > _e2886) {
                                                            phi_3750_ = _e2886;
                                                        } else {
                                                            phi_3750_ = _e2889;
                                                        }
                                                        let _e2892 = phi_3750_;
                                                        phi_3755_ = lt_bvh_triangle_Intersection(_e2892, (_e2595 / _e2654), (_e2616 / _e2654), (_e2883 <= _e2886));
                                                        phi_3756_ = false;
                                                    } else {
                                                        phi_3755_ = lt_bvh_triangle_Intersection();
                                                        phi_3756_ = true;
                                                    }
                                                    let _e2898 = phi_3755_;
                                                    let _e2900 = phi_3756_;
                                                    phi_3757_ = _e2898;
                                                    phi_3758_ = _e2900;
                                                } else {
                                                    phi_3757_ = lt_bvh_triangle_Intersection();
                                                    phi_3758_ = true;
                                                }
                                                let _e2902 = phi_3757_;
                                                let _e2904 = phi_3758_;
                                                if _e2904 {
                                                }
                                                phi_3762_ = _e2902;
                                                phi_3763_ = _e2904;
                                            }
                                            let _e2906 = phi_3762_;
                                            let _e2908 = phi_3763_;
                                            phi_3764_ = _e2906;
                                            phi_3765_ = _e2657;
                                            phi_3766_ = _e2908;
                                        } else {
                                            phi_3764_ = lt_bvh_triangle_Intersection();
                                            phi_3765_ = true;
                                            phi_3766_ = false;
                                        }
                                        let _e2910 = phi_3764_;
                                        let _e2912 = phi_3765_;
                                        let _e2914 = phi_3766_;
                                        if _e2912 {
                                            phi_3770_ = true;
                                        } else {
                                            phi_3770_ = _e2914;
                                        }
                                        let _e2916 = phi_3770_;
                                        if _e2916 {
                                            phi_3774_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3774_ = _e2910;
                                        }
                                        let _e2918 = phi_3774_;
                                        if _e2918.is_hit {
                                            if (_e2918.t > 0f) {
                                                if (_e2918.t < _e162) {
                                                    let _e2925 = triangles.member[(0u + _e2470)].i0_;
                                                    if ((_e2925 & 2147483648u) == 0u) {
                                                        phi_3993_ = true;
                                                    } else {
                                                        if (_e2470 < _e94) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2934 = triangles.member[(0u + _e2470)].i0_;
                                                        let _e2935 = (_e2934 & 2147483647u);
                                                        let _e2937 = triangles.member[(0u + _e2470)].i1_;
                                                        let _e2939 = triangles.member[(0u + _e2470)].i2_;
                                                        if (_e2935 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2943 = vertices.member[(0u + _e2935)];
                                                        if (_e2937 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2947 = vertices.member[(0u + _e2937)];
                                                        if (_e2939 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2951 = vertices.member[(0u + _e2939)];
                                                        let _e2952 = array<abi_Vertex, 3>(_e2943, _e2947, _e2951);
                                                        if (_e2952[0].material < _e113) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2958 = materials.member[(0u + _e2952[0].material)];
                                                        if ((_e2958.flags & 1u) == 1u) {
                                                            let _e2963 = ((1f - _e2918.u) - _e2918.v);
                                                            if (_e2958.cutoff <= 0f) {
                                                                phi_3991_ = true;
                                                            } else {
                                                                let _e2990 = (_e2958.base_color.w * ((((f32((_e2952[0].color >> bitcast<u32>(24i))) * _e2963) + (f32((_e2952[1].color >> bitcast<u32>(24i))) * _e2918.u)) + (f32((_e2952[2].color >> bitcast<u32>(24i))) * _e2918.v)) * (1f / 255f)));
                                                                if (_e2958.alpha_size == 0u) {
                                                                    phi_3988_ = _e2990;
                                                                } else {
                                                                    local.offset = _e2958.alpha_offset;
                                                                    local.size = _e2958.alpha_size;
                                                                    local.flags = _e2958.flags;
                                                                    let _e3021 = _lt_shaders_texture_TextureView_quad((&local), (((_e2952[0].u * _e2963) + (_e2952[1].u * _e2918.u)) + (_e2952[2].u * _e2918.v)), (((_e2952[0].v * _e2963) + (_e2952[1].v * _e2918.u)) + (_e2952[2].v * _e2918.v)));
                                                                    let _e3025 = (_e3021.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3025 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3029 = alpha_texels.member[(0u + _e3025)];
                                                                    let _e3045 = (_e3021.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3045 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3049 = alpha_texels.member[(0u + _e3045)];
                                                                    let _e3066 = (_e3021.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3066 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3070 = alpha_texels.member[(0u + _e3066)];
                                                                    let _e3087 = (_e3021.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3087 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3091 = alpha_texels.member[(0u + _e3087)];
                                                                    phi_3988_ = (_e2990 * (((((f32(((_e3029 >> bitcast<u32>((((_e3021.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3021.weights.x) + ((f32(((_e3049 >> bitcast<u32>((((_e3021.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3021.weights.y)) + ((f32(((_e3070 >> bitcast<u32>((((_e3021.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3021.weights.z)) + ((f32(((_e3091 >> bitcast<u32>((((_e3021.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3021.weights.w)));
                                                                }
                                                                let _e3107 = phi_3988_;
                                                                phi_3991_ = (_e3107 >= _e2958.cutoff);
                                                            }
                                                            let _e3111 = phi_3991_;
                                                            phi_3992_ = _e3111;
                                                        } else {
                                                            phi_3992_ = false;
                                                        }
                                                        let _e3113 = phi_3992_;
                                                        phi_3993_ = _e3113;
                                                    }
                                                    let _e3115 = phi_3993_;
                                                    if _e3115 {
                                                        phi_3997_ = false;
                                                    } else {
                                                        phi_3997_ = true;
                                                    }
                                                    let _e3117 = phi_3997_;
                                                    phi_3998_ = _e3115;
                                                    phi_3999_ = _e3115;
                                                    phi_4000_ = _e3117;
                                                } else {
                                                    phi_3998_ = bool();
                                                    phi_3999_ = _e2461;
                                                    phi_4000_ = true;
                                                }
                                                let _e3119 = phi_3998_;
                                                let _e3121 = phi_3999_;
                                                let _e3123 = phi_4000_;
                                                phi_4001_ = _e3119;
                                                phi_4002_ = _e3121;
                                                phi_4003_ = _e3123;
                                            } else {
                                                phi_4001_ = bool();
                                                phi_4002_ = _e2461;
                                                phi_4003_ = true;
                                            }
                                            let _e3125 = phi_4001_;
                                            let _e3127 = phi_4002_;
                                            let _e3129 = phi_4003_;
                                            phi_4004_ = _e3125;
                                            phi_4005_ = _e3127;
                                            phi_4006_ = _e3129;
                                        } else {
                                            phi_4004_ = bool();
                                            phi_4005_ = _e2461;
                                            phi_4006_ = true;
                                        }
                                        let _e3131 = phi_4004_;
                                        let _e3133 = phi_4005_;
                                        let _e3135 = phi_4006_;
                                        if _e3135 {
                                        }
                                        phi_3204_ = (_e2459 & (_e2459 - 1u));
                                        phi_3207_ = _e3133;
                                        phi_4010_ = _e3131;
                                        phi_4011_ = _e3135;
                                    }
                                    let _e3137 = phi_3204_;
                                    let _e3139 = phi_3207_;
                                    let _e3141 = phi_4010_;
                                    let _e3143 = phi_4011_;
                                    local_17 = _e3141;
                                    continue;
                                    continuing {
                                        phi_3203_ = _e3137;
                                        phi_3206_ = _e3139;
                                        break if !(_e3143);
                                    }
                                }
                                let _e3146 = local_9;
                                if _e3146 {
                                    let _e3148 = local_1.group_mask;
                                    if ((_e3148 & 4278190080u) == 0u) {
                                        let _e3152 = local_1.len;
                                        if (_e3152 == 0u) {
                                            phi_4053_ = false;
                                        } else {
                                            let _e3156 = local_1.len;
                                            local_1.len = (_e3156 - 1u);
                                            let _e3159 = local_1.len;
                                            if (_e3159 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3164 = local_1.first[(0u + _e3159)];
                                            local_1.group = _e3164;
                                            let _e3167 = local_1.len;
                                            if (_e3167 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3172 = local_1.mask[(0u + _e3167)];
                                            local_1.group_mask = _e3172;
                                            phi_4053_ = true;
                                        }
                                        let _e3175 = phi_4053_;
                                        phi_4054_ = _e3175;
                                    } else {
                                        phi_4054_ = true;
                                    }
                                    let _e3177 = phi_4054_;
                                    if _e3177 {
                                        let _e3179 = local_1.group_mask;
                                        let _e3185 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3179)), 32u, (_e3179 == 0u)));
                                        let _e3189 = local_1.group_mask;
                                        let _e3203 = local_1.group_mask;
                                        local_1.group_mask = (_e3203 & ~((1u << bitcast<u32>((_e3185 & 31u)))));
                                        let _e3206 = local_1.group;
                                        phi_4085_ = (_e3206 + countOneBits(((_e3189 & ~((4294967295u << bitcast<u32>((((_e3185 - 24u) ^ _e1883) & 31u))))) & 255u)));
                                    } else {
                                        phi_4085_ = 4294967295u;
                                    }
                                    let _e3209 = phi_4085_;
                                    phi_4086_ = _e3209;
                                } else {
                                    phi_4086_ = u32();
                                }
                                let _e3211 = phi_4086_;
                                phi_2872_ = _e3211;
                                let _e3748 = local_16;
                                phi_2875_ = _e3748;
                                let _e3751 = local_17;
                                phi_4087_ = _e3751;
                                let _e3754 = local_18;
                                phi_4088_ = _e3754;
                                phi_4089_ = false;
                            } else {
                                phi_2872_ = u32();
                                phi_2875_ = bool();
                                phi_4087_ = bool();
                                phi_4088_ = false;
                                phi_4089_ = true;
                            }
                            let _e3213 = phi_2872_;
                            let _e3215 = phi_2875_;
                            let _e3217 = phi_4087_;
                            let _e3219 = phi_4088_;
                            let _e3221 = phi_4089_;
                            local_10 = _e3221;
                            local_19 = _e3217;
                            continue;
                            continuing {
                                phi_2871_ = _e3213;
                                phi_2874_ = _e3215;
                                break if !(_e3219);
                            }
                        }
                        let _e3224 = local_10;
                        if _e3224 {
                            phi_4093_ = false;
                        } else {
                            phi_4093_ = true;
                        }
                        let _e3226 = phi_4093_;
                        if _e3226 {
                            let _e3760 = local_19;
                            phi_4097_ = _e3760;
                        } else {
                            let _e3762 = local_20;
                            phi_4097_ = _e3762;
                        }
                        let _e3228 = phi_4097_;
                        phi_4098_ = _e3228;
                    }
                    let _e3230 = phi_4098_;
                    phi_4099_ = _e3230;
                    phi_4100_ = _e1705;
                } else {
                    phi_4099_ = bool();
                    phi_4100_ = true;
                }
                let _e3232 = phi_4099_;
                let _e3234 = phi_4100_;
                if _e3234 {
                    phi_4104_ = false;
                } else {
                    phi_4104_ = _e3232;
                }
                let _e3236 = phi_4104_;
                phi_4105_ = _e3236;
            }
            let _e3238 = phi_4105_;
            phi_4106_ = _e3238;
        } else {
            phi_4106_ = false;
        }
        let _e3240 = phi_4106_;
        if _e3240 {
            phi_4110_ = 0f;
        } else {
            phi_4110_ = 1f;
        }
        let _e3242 = phi_4110_;
        if (_e129 < _e97) {
        } else {
            return;
        }
        visibility.member[(0u + _e129)] = _e3242;
        let _e3248 = p.member.light.number;
        let _e3249 = (_e3248 * 3u);
        let _e3250 = (_e3249 / 32u);
        let _e3251 = (_e3249 % 32u);
        let _e3253 = p.member.light.mask_words;
        if (_e129 < _e97) {
        } else {
            return;
        }
        let _e3257 = visibility.member[(0u + _e129)];
        let _e3259 = ((_e129 * _e3253) + _e3250);
        if (_e3251 > 29u) {
            let _e3261 = (_e3259 + 1u);
            if (_e3261 < _e103) {
            } else {
                return;
            }
            let _e3265 = bits.member[(0u + _e3261)];
            phi_4151_ = _e3265;
        } else {
            phi_4151_ = 0u;
        }
        let _e3267 = phi_4151_;
        if (_e3259 < _e103) {
        } else {
            return;
        }
        let _e3271 = bits.member[(0u + _e3259)];
        let _e3274 = (_e3271 >> bitcast<u32>((_e3251 & 31u)));
        if (_e3251 > 29u) {
            phi_4170_ = (_e3274 | (_e3267 << bitcast<u32>(((32u - _e3251) & 31u))));
        } else {
            phi_4170_ = _e3274;
        }
        let _e3282 = phi_4170_;
        if ((_e3282 & 2u) == 0u) {
            phi_4178_ = (_e3282 & 1u);
        } else {
            phi_4178_ = (_e3282 & 7u);
        }
        let _e3288 = phi_4178_;
        if ((_e3288 & 1u) != 0u) {
            phi_4186_ = (2u | 1u);
        } else {
            phi_4186_ = 2u;
        }
        let _e3294 = phi_4186_;
        if (_e3257 < 0.5f) {
            phi_4191_ = (_e3294 | 4u);
        } else {
            phi_4191_ = _e3294;
        }
        let _e3297 = phi_4191_;
        let _e3299 = ((_e129 * _e3253) + _e3250);
        if (_e3299 < _e103) {
        } else {
            return;
        }
        let _e3303 = bits.member[(0u + _e3299)];
        if (_e3299 < _e103) {
        } else {
            return;
        }
        bits.member[(0u + _e3299)] = ((_e3303 & ~((7u << bitcast<u32>((_e3251 & 31u))))) | (_e3297 << bitcast<u32>((_e3251 & 31u))));
        if (_e3251 > 29u) {
            let _e3317 = (_e3299 + 1u);
            if (_e3317 < _e103) {
            } else {
                return;
            }
            let _e3321 = bits.member[(0u + _e3317)];
            let _e3322 = (32u - _e3251);
            let _e3332 = (_e3299 + 1u);
            if (_e3332 < _e103) {
            } else {
                return;
            }
            bits.member[(0u + _e3332)] = ((_e3321 & ~((7u >> bitcast<u32>((_e3322 & 31u))))) | (_e3297 >> bitcast<u32>((_e3322 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
