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
    var phi_1223_: u32;
    var phi_1226_: u32;
    var phi_1228_: u32;
    var phi_1230_: u32;
    var phi_1303_: f32;
    var phi_1304_: f32;
    var phi_1318_: u32;
    var phi_1341_: f32;
    var phi_1342_: f32;
    var phi_1356_: u32;
    var phi_1379_: f32;
    var phi_1380_: f32;
    var phi_1394_: u32;
    var phi_1541_: u32;
    var phi_1542_: u32;
    var phi_1546_: u32;
    var phi_1547_: u32;
    var phi_1548_: u32;
    var phi_1549_: u32;
    var phi_1550_: u32;
    var phi_1551_: u32;
    var phi_1569_: u32;
    var phi_1570_: u32;
    var phi_1571_: u32;
    var phi_1572_: u32;
    var phi_1573_: u32;
    var phi_1574_: u32;
    var phi_1575_: u32;
    var phi_1576_: u32;
    var phi_1224_: u32;
    var phi_1227_: u32;
    var phi_1229_: u32;
    var phi_1231_: u32;
    var phi_1577_: bool;
    var local_4: bool;
    var phi_1582_: u32;
    var local_5: u32;
    var phi_1621_: u32;
    var phi_1622_: u32;
    var phi_1628_: u32;
    var phi_1657_: vec3<f32>;
    var phi_1658_: vec3<f32>;
    var phi_1687_: vec3<f32>;
    var phi_1688_: vec3<f32>;
    var phi_1717_: vec3<f32>;
    var phi_1718_: vec3<f32>;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1741_: f32;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1752_: f32;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: f32;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1770_: f32;
    var phi_1778_: f32;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1793_: f32;
    var phi_1794_: f32;
    var phi_1795_: f32;
    var phi_1796_: f32;
    var phi_1804_: f32;
    var phi_1819_: f32;
    var phi_1820_: bool;
    var phi_1821_: f32;
    var phi_1822_: bool;
    var phi_1823_: f32;
    var phi_1824_: bool;
    var phi_1842_: f32;
    var phi_1843_: bool;
    var phi_1844_: bool;
    var phi_1845_: f32;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1851_: bool;
    var phi_1852_: f32;
    var phi_1853_: bool;
    var phi_1881_: vec3<f32>;
    var phi_1882_: vec3<f32>;
    var phi_1907_: vec3<f32>;
    var phi_1908_: vec3<f32>;
    var phi_1933_: vec3<f32>;
    var phi_1934_: vec3<f32>;
    var phi_1990_: f32;
    var phi_1999_: f32;
    var phi_2008_: f32;
    var phi_2017_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2044_: f32;
    var phi_2053_: f32;
    var phi_2062_: f32;
    var phi_2071_: f32;
    var phi_2078_: f32;
    var phi_2085_: f32;
    var phi_2102_: f32;
    var phi_2107_: f32;
    var phi_2112_: f32;
    var phi_2120_: f32;
    var phi_2125_: f32;
    var phi_2130_: f32;
    var phi_2142_: f32;
    var phi_2147_: f32;
    var phi_2152_: f32;
    var phi_2157_: f32;
    var phi_2162_: lt_bvh_triangle_Intersection;
    var phi_2163_: bool;
    var phi_2164_: lt_bvh_triangle_Intersection;
    var phi_2165_: bool;
    var phi_2169_: lt_bvh_triangle_Intersection;
    var phi_2170_: bool;
    var phi_2171_: lt_bvh_triangle_Intersection;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2177_: bool;
    var phi_2181_: lt_bvh_triangle_Intersection;
    var phi_2395_: f32;
    var phi_2398_: bool;
    var phi_2399_: bool;
    var phi_2403_: bool;
    var phi_2404_: bool;
    var phi_2405_: bool;
    var phi_2406_: bool;
    var phi_2407_: bool;
    var phi_2408_: bool;
    var phi_2409_: bool;
    var phi_2410_: bool;
    var phi_2411_: bool;
    var phi_2412_: bool;
    var phi_2413_: bool;
    var phi_2414_: bool;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_1583_: u32;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var local_6: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_1212_: u32;
    var phi_1215_: u32;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var local_7: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2447_: bool;
    var phi_2451_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2460_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2483_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2503_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2530_: bool;
    var phi_2600_: f32;
    var phi_2607_: f32;
    var phi_2614_: f32;
    var phi_2621_: f32;
    var phi_2628_: f32;
    var phi_2635_: f32;
    var phi_2652_: f32;
    var phi_2657_: f32;
    var phi_2662_: f32;
    var phi_2667_: f32;
    var phi_2672_: f32;
    var phi_2698_: bool;
    var phi_2699_: bool;
    var phi_2707_: u32;
    var phi_2708_: u32;
    var phi_2719_: vec3<f32>;
    var phi_2720_: vec3<f32>;
    var phi_2733_: u32;
    var phi_2738_: u32;
    var phi_2743_: u32;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var phi_2889_: u32;
    var phi_2891_: u32;
    var phi_2894_: bool;
    var phi_2974_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3001_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3028_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3034_: u32;
    var phi_3037_: u32;
    var phi_3051_: u32;
    var phi_3061_: u32;
    var phi_3071_: u32;
    var phi_3089_: u32;
    var phi_3099_: u32;
    var phi_3109_: u32;
    var phi_3145_: u32;
    var phi_3158_: u32;
    var phi_3163_: u32;
    var phi_3164_: u32;
    var phi_3165_: u32;
    var phi_3035_: u32;
    var phi_3038_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_3223_: u32;
    var phi_3226_: bool;
    var phi_3270_: vec3<f32>;
    var phi_3271_: vec3<f32>;
    var phi_3300_: vec3<f32>;
    var phi_3301_: vec3<f32>;
    var phi_3330_: vec3<f32>;
    var phi_3331_: vec3<f32>;
    var phi_3349_: bool;
    var phi_3350_: bool;
    var phi_3354_: f32;
    var phi_3355_: f32;
    var phi_3356_: f32;
    var phi_3357_: f32;
    var phi_3365_: f32;
    var phi_3375_: bool;
    var phi_3376_: bool;
    var phi_3380_: f32;
    var phi_3381_: f32;
    var phi_3382_: f32;
    var phi_3383_: f32;
    var phi_3391_: f32;
    var phi_3401_: bool;
    var phi_3402_: bool;
    var phi_3406_: f32;
    var phi_3407_: f32;
    var phi_3408_: f32;
    var phi_3409_: f32;
    var phi_3417_: f32;
    var phi_3432_: f32;
    var phi_3433_: bool;
    var phi_3434_: f32;
    var phi_3435_: bool;
    var phi_3436_: f32;
    var phi_3437_: bool;
    var phi_3455_: f32;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_3458_: f32;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3464_: bool;
    var phi_3465_: f32;
    var phi_3466_: bool;
    var phi_3494_: vec3<f32>;
    var phi_3495_: vec3<f32>;
    var phi_3520_: vec3<f32>;
    var phi_3521_: vec3<f32>;
    var phi_3546_: vec3<f32>;
    var phi_3547_: vec3<f32>;
    var phi_3603_: f32;
    var phi_3612_: f32;
    var phi_3621_: f32;
    var phi_3630_: f32;
    var phi_3637_: f32;
    var phi_3644_: f32;
    var phi_3657_: f32;
    var phi_3666_: f32;
    var phi_3675_: f32;
    var phi_3684_: f32;
    var phi_3691_: f32;
    var phi_3698_: f32;
    var phi_3715_: f32;
    var phi_3720_: f32;
    var phi_3725_: f32;
    var phi_3733_: f32;
    var phi_3738_: f32;
    var phi_3743_: f32;
    var phi_3755_: f32;
    var phi_3760_: f32;
    var phi_3765_: f32;
    var phi_3770_: f32;
    var phi_3775_: lt_bvh_triangle_Intersection;
    var phi_3776_: bool;
    var phi_3777_: lt_bvh_triangle_Intersection;
    var phi_3778_: bool;
    var phi_3782_: lt_bvh_triangle_Intersection;
    var phi_3783_: bool;
    var phi_3784_: lt_bvh_triangle_Intersection;
    var phi_3785_: bool;
    var phi_3786_: bool;
    var phi_3790_: bool;
    var phi_3794_: lt_bvh_triangle_Intersection;
    var phi_4008_: f32;
    var phi_4011_: bool;
    var phi_4012_: bool;
    var phi_4013_: bool;
    var phi_4017_: bool;
    var phi_4018_: bool;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var phi_4021_: bool;
    var phi_4022_: bool;
    var phi_4023_: bool;
    var phi_4024_: bool;
    var phi_4025_: bool;
    var phi_4026_: bool;
    var phi_3224_: u32;
    var phi_3227_: bool;
    var phi_4030_: bool;
    var phi_4031_: bool;
    var local_11: bool;
    var phi_4073_: bool;
    var phi_4074_: bool;
    var phi_4105_: u32;
    var phi_4106_: u32;
    var phi_2892_: u32;
    var phi_2895_: bool;
    var phi_4107_: bool;
    var phi_4108_: bool;
    var phi_4109_: bool;
    var local_12: bool;
    var phi_4113_: bool;
    var phi_4117_: bool;
    var phi_4118_: bool;
    var phi_4119_: bool;
    var phi_4120_: bool;
    var phi_4124_: bool;
    var phi_4125_: bool;
    var phi_4126_: bool;
    var phi_4130_: f32;
    var phi_4171_: u32;
    var phi_4190_: u32;
    var phi_4198_: u32;
    var phi_4206_: u32;
    var phi_4211_: u32;
    var local_13: u32;
    var local_14: bool;
    var local_15: bool;
    var local_16: u32;
    var local_17: u32;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;

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
                    phi_2455_ = false;
                    phi_2456_ = true;
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
                        local_7 = _e563;
                        if _e563 {
                            phi_1212_ = u32();
                            phi_1215_ = u32();
                            phi_2436_ = false;
                            phi_2437_ = false;
                            phi_2438_ = false;
                        } else {
                            phi_1223_ = _e560;
                            phi_1226_ = 0u;
                            phi_1228_ = 0u;
                            phi_1230_ = _e562;
                            loop {
                                let _e565 = phi_1223_;
                                let _e567 = phi_1226_;
                                let _e569 = phi_1228_;
                                let _e571 = phi_1230_;
                                local_13 = _e569;
                                local_5 = _e567;
                                local_16 = _e565;
                                local_17 = _e571;
                                let _e572 = (_e565 == 0u);
                                local_4 = _e572;
                                if _e572 {
                                    phi_1224_ = u32();
                                    phi_1227_ = u32();
                                    phi_1229_ = u32();
                                    phi_1231_ = u32();
                                    phi_1577_ = false;
                                } else {
                                    let _e573 = (_e569 == 0u);
                                    if _e573 {
                                        let _e580 = (((_e565 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e565), 32u, (_e565 == 0u))) * 4u);
                                        if (_e580 < _e106) {
                                        } else {
                                            return;
                                        }
                                        let _e584 = rows.member[(0u + _e580)];
                                        let _e585 = (_e580 + 1u);
                                        if (_e585 < _e106) {
                                        } else {
                                            return;
                                        }
                                        let _e589 = rows.member[(0u + _e585)];
                                        let _e590 = (_e580 + 2u);
                                        if (_e590 < _e106) {
                                        } else {
                                            return;
                                        }
                                        let _e594 = rows.member[(0u + _e590)];
                                        let _e595 = (_e580 + 3u);
                                        if (_e595 < _e106) {
                                        } else {
                                            return;
                                        }
                                        let _e599 = rows.member[(0u + _e595)];
                                        let _e600 = lt_bvh_LightNode(_e584, _e589, _e594, _e599);
                                        let _e602 = (_e565 & (_e565 - 1u));
                                        let _e614 = (_e390.unnamed.positive_exponent - bitcast<f32>(_e600.frame.x));
                                        let _e617 = bitcast<f32>((((_e600.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e614 > 0f) {
                                            if (_e614 < (255f * _e617)) {
                                                phi_1303_ = (_e614 / _e617);
                                            } else {
                                                phi_1303_ = 255f;
                                            }
                                            let _e623 = phi_1303_;
                                            phi_1304_ = _e623;
                                        } else {
                                            phi_1304_ = 0f;
                                        }
                                        let _e625 = phi_1304_;
                                        let _e632 = select(select(u32(_e625), 0u, (_e625 < bitcast<f32>(0u))), 4294967295u, (_e625 > bitcast<f32>(1333788671u)));
                                        if (f32(_e632) < _e625) {
                                            phi_1318_ = (_e632 + 1u);
                                        } else {
                                            phi_1318_ = _e632;
                                        }
                                        let _e637 = phi_1318_;
                                        let _e638 = (_e632 * 16843009u);
                                        let _e639 = (_e637 * 16843009u);
                                        let _e649 = (_e390.unnamed.negative_exponent - bitcast<f32>(_e600.frame.y));
                                        let _e652 = bitcast<f32>((((_e600.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e649 > 0f) {
                                            if (_e649 < (255f * _e652)) {
                                                phi_1341_ = (_e649 / _e652);
                                            } else {
                                                phi_1341_ = 255f;
                                            }
                                            let _e658 = phi_1341_;
                                            phi_1342_ = _e658;
                                        } else {
                                            phi_1342_ = 0f;
                                        }
                                        let _e660 = phi_1342_;
                                        let _e667 = select(select(u32(_e660), 0u, (_e660 < bitcast<f32>(0u))), 4294967295u, (_e660 > bitcast<f32>(1333788671u)));
                                        if (f32(_e667) < _e660) {
                                            phi_1356_ = (_e667 + 1u);
                                        } else {
                                            phi_1356_ = _e667;
                                        }
                                        let _e672 = phi_1356_;
                                        let _e673 = (_e667 * 16843009u);
                                        let _e674 = (_e672 * 16843009u);
                                        let _e684 = (_e390.unnamed.min_variance - bitcast<f32>(_e600.frame.z));
                                        let _e687 = bitcast<f32>((((_e600.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e684 > 0f) {
                                            if (_e684 < (255f * _e687)) {
                                                phi_1379_ = (_e684 / _e687);
                                            } else {
                                                phi_1379_ = 255f;
                                            }
                                            let _e693 = phi_1379_;
                                            phi_1380_ = _e693;
                                        } else {
                                            phi_1380_ = 0f;
                                        }
                                        let _e695 = phi_1380_;
                                        let _e702 = select(select(u32(_e695), 0u, (_e695 < bitcast<f32>(0u))), 4294967295u, (_e695 > bitcast<f32>(1333788671u)));
                                        if (f32(_e702) < _e695) {
                                            phi_1394_ = (_e702 + 1u);
                                        } else {
                                            phi_1394_ = _e702;
                                        }
                                        let _e707 = phi_1394_;
                                        let _e708 = (_e707 * 16843009u);
                                        let _e841 = (((((((((((_e638 & ~(_e600.x.x)) | (~((_e600.x.x ^ _e638)) & ((_e638 | 2155905152u) - (_e600.x.x & 2139062143u)))) & ((_e600.x.z & ~(_e639)) | (~((_e639 ^ _e600.x.z)) & ((_e600.x.z | 2155905152u) - (_e639 & 2139062143u))))) & ((_e673 & ~(_e600.y.x)) | (~((_e600.y.x ^ _e673)) & ((_e673 | 2155905152u) - (_e600.y.x & 2139062143u))))) & ((_e600.y.z & ~(_e674)) | (~((_e674 ^ _e600.y.z)) & ((_e600.y.z | 2155905152u) - (_e674 & 2139062143u))))) & ((_e600.rest.x & ~(_e708)) | (~((_e708 ^ _e600.rest.x)) & ((_e600.rest.x | 2155905152u) - (_e708 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e638 & ~(_e600.x.y)) | (~((_e600.x.y ^ _e638)) & ((_e638 | 2155905152u) - (_e600.x.y & 2139062143u)))) & ((_e600.x.w & ~(_e639)) | (~((_e639 ^ _e600.x.w)) & ((_e600.x.w | 2155905152u) - (_e639 & 2139062143u))))) & ((_e673 & ~(_e600.y.y)) | (~((_e600.y.y ^ _e673)) & ((_e673 | 2155905152u) - (_e600.y.y & 2139062143u))))) & ((_e600.y.w & ~(_e674)) | (~((_e674 ^ _e600.y.w)) & ((_e600.y.w | 2155905152u) - (_e674 & 2139062143u))))) & ((_e600.rest.y & ~(_e708)) | (~((_e708 ^ _e600.rest.y)) & ((_e600.rest.y | 2155905152u) - (_e708 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                        if ((_e600.frame.w & 16777216u) != 0u) {
                                            phi_1548_ = _e602;
                                            phi_1549_ = _e600.rest.z;
                                            phi_1550_ = _e841;
                                            phi_1551_ = _e571;
                                        } else {
                                            if (_e841 == 0u) {
                                                phi_1546_ = _e602;
                                                phi_1547_ = _e571;
                                            } else {
                                                if ((_e602 & 255u) == 0u) {
                                                    phi_1542_ = _e571;
                                                } else {
                                                    if (_e571 < 32u) {
                                                        if (_e571 < 32u) {
                                                        } else {
                                                            return;
                                                        }
                                                        local_3[(0u + _e571)] = _e602;
                                                        phi_1541_ = (_e571 + 1u);
                                                    } else {
                                                        phi_1541_ = _e571;
                                                    }
                                                    let _e857 = phi_1541_;
                                                    phi_1542_ = _e857;
                                                }
                                                let _e859 = phi_1542_;
                                                phi_1546_ = ((_e600.rest.z << bitcast<u32>(8i)) | _e841);
                                                phi_1547_ = _e859;
                                            }
                                            let _e866 = phi_1546_;
                                            let _e868 = phi_1547_;
                                            phi_1548_ = _e866;
                                            phi_1549_ = _e567;
                                            phi_1550_ = _e569;
                                            phi_1551_ = _e868;
                                        }
                                        let _e870 = phi_1548_;
                                        let _e872 = phi_1549_;
                                        let _e874 = phi_1550_;
                                        let _e876 = phi_1551_;
                                        if ((_e870 & 255u) == 0u) {
                                            if (_e876 > 0u) {
                                                let _e880 = (_e876 - 1u);
                                                if (_e880 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e884 = local_3[(0u + _e880)];
                                                phi_1569_ = _e884;
                                                phi_1570_ = _e880;
                                            } else {
                                                phi_1569_ = 0u;
                                                phi_1570_ = _e876;
                                            }
                                            let _e886 = phi_1569_;
                                            let _e888 = phi_1570_;
                                            phi_1571_ = _e886;
                                            phi_1572_ = _e888;
                                        } else {
                                            phi_1571_ = _e870;
                                            phi_1572_ = _e876;
                                        }
                                        let _e890 = phi_1571_;
                                        let _e892 = phi_1572_;
                                        phi_1573_ = _e890;
                                        phi_1574_ = _e872;
                                        phi_1575_ = _e874;
                                        phi_1576_ = _e892;
                                    } else {
                                        phi_1573_ = u32();
                                        phi_1574_ = u32();
                                        phi_1575_ = u32();
                                        phi_1576_ = u32();
                                    }
                                    let _e894 = phi_1573_;
                                    let _e896 = phi_1574_;
                                    let _e898 = phi_1575_;
                                    let _e900 = phi_1576_;
                                    phi_1224_ = _e894;
                                    phi_1227_ = _e896;
                                    phi_1229_ = _e898;
                                    phi_1231_ = _e900;
                                    phi_1577_ = _e573;
                                }
                                let _e902 = phi_1224_;
                                let _e904 = phi_1227_;
                                let _e906 = phi_1229_;
                                let _e908 = phi_1231_;
                                let _e910 = phi_1577_;
                                continue;
                                continuing {
                                    phi_1223_ = _e902;
                                    phi_1226_ = _e904;
                                    phi_1228_ = _e906;
                                    phi_1230_ = _e908;
                                    break if !(_e910);
                                }
                            }
                            let _e913 = local_4;
                            if _e913 {
                            }
                            let _e3471 = local_13;
                            phi_1582_ = _e3471;
                            loop {
                                let _e915 = phi_1582_;
                                let _e916 = (_e915 == 0u);
                                local_6 = _e916;
                                local_18 = _e916;
                                if _e916 {
                                    phi_1583_ = u32();
                                    phi_2428_ = false;
                                    phi_2429_ = false;
                                    phi_2430_ = false;
                                } else {
                                    let _e919 = select(firstTrailingBit(_e915), 32u, (_e915 == 0u));
                                    let _e923 = local_5;
                                    let _e924 = (_e923 + (_e919 >> bitcast<u32>(2i)));
                                    if (_e924 < _e106) {
                                    } else {
                                        return;
                                    }
                                    let _e929 = rows.member[(0u + _e924)][0u];
                                    let _e933 = rows.member[(0u + _e924)][1u];
                                    let _e937 = rows.member[(0u + _e924)][2u];
                                    let _e941 = rows.member[(0u + _e924)][3u];
                                    if ((_e919 & 2u) == 0u) {
                                        phi_1621_ = _e933;
                                        phi_1622_ = _e929;
                                    } else {
                                        phi_1621_ = _e941;
                                        phi_1622_ = _e937;
                                    }
                                    let _e945 = phi_1621_;
                                    let _e947 = phi_1622_;
                                    if ((_e919 & 1u) == 0u) {
                                        phi_1628_ = _e947;
                                    } else {
                                        phi_1628_ = _e945;
                                    }
                                    let _e951 = phi_1628_;
                                    if (_e951 < _e94) {
                                    } else {
                                        return;
                                    }
                                    let _e958 = triangles.member[(0u + _e951)].v0_;
                                    let _e960 = (_e958.x - _e150);
                                    let _e962 = (_e958.y - _e152);
                                    let _e964 = (_e958.z - _e154);
                                    if (_e539 == 0u) {
                                        phi_1658_ = vec3<f32>(_e962, _e964, _e960);
                                    } else {
                                        if (_e539 == 1u) {
                                            phi_1657_ = vec3<f32>(_e964, _e960, _e962);
                                        } else {
                                            phi_1657_ = (_e958 - vec3<f32>(_e150, _e152, _e154));
                                        }
                                        let _e972 = phi_1657_;
                                        phi_1658_ = _e972;
                                    }
                                    let _e974 = phi_1658_;
                                    let _e978 = (_e974.x - (_e550 * _e974.z));
                                    let _e982 = (_e974.y - (_e553 * _e974.z));
                                    let _e984 = triangles.member[(0u + _e951)].v1_;
                                    let _e986 = (_e984.x - _e150);
                                    let _e988 = (_e984.y - _e152);
                                    let _e990 = (_e984.z - _e154);
                                    if (_e539 == 0u) {
                                        phi_1688_ = vec3<f32>(_e988, _e990, _e986);
                                    } else {
                                        if (_e539 == 1u) {
                                            phi_1687_ = vec3<f32>(_e990, _e986, _e988);
                                        } else {
                                            phi_1687_ = (_e984 - vec3<f32>(_e150, _e152, _e154));
                                        }
                                        let _e998 = phi_1687_;
                                        phi_1688_ = _e998;
                                    }
                                    let _e1000 = phi_1688_;
                                    let _e1004 = (_e1000.x - (_e550 * _e1000.z));
                                    let _e1008 = (_e1000.y - (_e553 * _e1000.z));
                                    let _e1010 = triangles.member[(0u + _e951)].v2_;
                                    let _e1012 = (_e1010.x - _e150);
                                    let _e1014 = (_e1010.y - _e152);
                                    let _e1016 = (_e1010.z - _e154);
                                    if (_e539 == 0u) {
                                        phi_1718_ = vec3<f32>(_e1014, _e1016, _e1012);
                                    } else {
                                        if (_e539 == 1u) {
                                            phi_1717_ = vec3<f32>(_e1016, _e1012, _e1014);
                                        } else {
                                            phi_1717_ = (_e1010 - vec3<f32>(_e150, _e152, _e154));
                                        }
                                        let _e1024 = phi_1717_;
                                        phi_1718_ = _e1024;
                                    }
                                    let _e1026 = phi_1718_;
                                    let _e1030 = (_e1026.x - (_e550 * _e1026.z));
                                    let _e1034 = (_e1026.y - (_e553 * _e1026.z));
                                    if (_e1004 < _e1030) {
                                        phi_1737_ = true;
                                    } else {
                                        if (_e1004 == _e1030) {
                                            phi_1736_ = (_e1008 < _e1034);
                                        } else {
                                            phi_1736_ = false;
                                        }
                                        let _e1039 = phi_1736_;
                                        phi_1737_ = _e1039;
                                    }
                                    let _e1041 = phi_1737_;
                                    if _e1041 {
                                        phi_1741_ = _e1034;
                                        phi_1742_ = _e1030;
                                        phi_1743_ = _e1008;
                                        phi_1744_ = _e1004;
                                    } else {
                                        phi_1741_ = _e1008;
                                        phi_1742_ = _e1004;
                                        phi_1743_ = _e1034;
                                        phi_1744_ = _e1030;
                                    }
                                    let _e1043 = phi_1741_;
                                    let _e1045 = phi_1742_;
                                    let _e1047 = phi_1743_;
                                    let _e1049 = phi_1744_;
                                    let _e1052 = ((_e1049 * _e1043) - (_e1047 * _e1045));
                                    if _e1041 {
                                        phi_1752_ = -(_e1052);
                                    } else {
                                        phi_1752_ = _e1052;
                                    }
                                    let _e1055 = phi_1752_;
                                    if (_e1030 < _e978) {
                                        phi_1763_ = true;
                                    } else {
                                        if (_e1030 == _e978) {
                                            phi_1762_ = (_e1034 < _e982);
                                        } else {
                                            phi_1762_ = false;
                                        }
                                        let _e1060 = phi_1762_;
                                        phi_1763_ = _e1060;
                                    }
                                    let _e1062 = phi_1763_;
                                    if _e1062 {
                                        phi_1767_ = _e982;
                                        phi_1768_ = _e978;
                                        phi_1769_ = _e1034;
                                        phi_1770_ = _e1030;
                                    } else {
                                        phi_1767_ = _e1034;
                                        phi_1768_ = _e1030;
                                        phi_1769_ = _e982;
                                        phi_1770_ = _e978;
                                    }
                                    let _e1064 = phi_1767_;
                                    let _e1066 = phi_1768_;
                                    let _e1068 = phi_1769_;
                                    let _e1070 = phi_1770_;
                                    let _e1073 = ((_e1070 * _e1064) - (_e1068 * _e1066));
                                    if _e1062 {
                                        phi_1778_ = -(_e1073);
                                    } else {
                                        phi_1778_ = _e1073;
                                    }
                                    let _e1076 = phi_1778_;
                                    if (_e978 < _e1004) {
                                        phi_1789_ = true;
                                    } else {
                                        if (_e978 == _e1004) {
                                            phi_1788_ = (_e982 < _e1008);
                                        } else {
                                            phi_1788_ = false;
                                        }
                                        let _e1081 = phi_1788_;
                                        phi_1789_ = _e1081;
                                    }
                                    let _e1083 = phi_1789_;
                                    if _e1083 {
                                        phi_1793_ = _e1008;
                                        phi_1794_ = _e1004;
                                        phi_1795_ = _e982;
                                        phi_1796_ = _e978;
                                    } else {
                                        phi_1793_ = _e982;
                                        phi_1794_ = _e978;
                                        phi_1795_ = _e1008;
                                        phi_1796_ = _e1004;
                                    }
                                    let _e1085 = phi_1793_;
                                    let _e1087 = phi_1794_;
                                    let _e1089 = phi_1795_;
                                    let _e1091 = phi_1796_;
                                    let _e1094 = ((_e1091 * _e1085) - (_e1089 * _e1087));
                                    if _e1083 {
                                        phi_1804_ = -(_e1094);
                                    } else {
                                        phi_1804_ = _e1094;
                                    }
                                    let _e1097 = phi_1804_;
                                    if (_e1055 >= 0f) {
                                        if (_e1076 >= 0f) {
                                            if (_e1097 >= 0f) {
                                                phi_1819_ = ((_e1055 + _e1076) + _e1097);
                                                phi_1820_ = false;
                                            } else {
                                                phi_1819_ = f32();
                                                phi_1820_ = true;
                                            }
                                            let _e1104 = phi_1819_;
                                            let _e1106 = phi_1820_;
                                            phi_1821_ = _e1104;
                                            phi_1822_ = _e1106;
                                        } else {
                                            phi_1821_ = f32();
                                            phi_1822_ = true;
                                        }
                                        let _e1108 = phi_1821_;
                                        let _e1110 = phi_1822_;
                                        phi_1823_ = _e1108;
                                        phi_1824_ = _e1110;
                                    } else {
                                        phi_1823_ = f32();
                                        phi_1824_ = true;
                                    }
                                    let _e1112 = phi_1823_;
                                    let _e1114 = phi_1824_;
                                    if _e1114 {
                                        if (_e1055 <= 0f) {
                                            if (_e1076 <= 0f) {
                                                let _e1117 = (_e1097 <= 0f);
                                                if _e1117 {
                                                }
                                                phi_1842_ = ((_e1055 + _e1076) + _e1097);
                                                phi_1843_ = false;
                                                phi_1844_ = _e1117;
                                            } else {
                                                phi_1842_ = f32();
                                                phi_1843_ = true;
                                                phi_1844_ = false;
                                            }
                                            let _e1121 = phi_1842_;
                                            let _e1123 = phi_1843_;
                                            let _e1125 = phi_1844_;
                                            phi_1845_ = _e1121;
                                            phi_1846_ = _e1123;
                                            phi_1847_ = _e1125;
                                        } else {
                                            phi_1845_ = f32();
                                            phi_1846_ = true;
                                            phi_1847_ = false;
                                        }
                                        let _e1127 = phi_1845_;
                                        let _e1129 = phi_1846_;
                                        let _e1131 = phi_1847_;
                                        if _e1129 {
                                            phi_1851_ = false;
                                        } else {
                                            phi_1851_ = _e1131;
                                        }
                                        let _e1133 = phi_1851_;
                                        phi_1852_ = _e1127;
                                        phi_1853_ = _e1133;
                                    } else {
                                        phi_1852_ = _e1112;
                                        phi_1853_ = true;
                                    }
                                    let _e1135 = phi_1852_;
                                    let _e1137 = phi_1853_;
                                    if _e1137 {
                                        let _e1138 = (_e1135 == 0f);
                                        if _e1138 {
                                            phi_2169_ = lt_bvh_triangle_Intersection();
                                            phi_2170_ = false;
                                        } else {
                                            let _e1140 = triangles.member[(0u + _e951)].v0_;
                                            let _e1142 = (_e1140.x - _e150);
                                            let _e1144 = (_e1140.y - _e152);
                                            let _e1146 = (_e1140.z - _e154);
                                            if (_e539 == 0u) {
                                                phi_1882_ = vec3<f32>(_e1144, _e1146, _e1142);
                                            } else {
                                                if (_e539 == 1u) {
                                                    phi_1881_ = vec3<f32>(_e1146, _e1142, _e1144);
                                                } else {
                                                    phi_1881_ = (_e1140 - vec3<f32>(_e150, _e152, _e154));
                                                }
                                                let _e1154 = phi_1881_;
                                                phi_1882_ = _e1154;
                                            }
                                            let _e1156 = phi_1882_;
                                            let _e1158 = triangles.member[(0u + _e951)].v1_;
                                            let _e1160 = triangles.member[(0u + _e951)].v0_;
                                            let _e1163 = (_e1158.x - _e1160.x);
                                            let _e1166 = (_e1158.y - _e1160.y);
                                            let _e1169 = (_e1158.z - _e1160.z);
                                            if (_e539 == 0u) {
                                                phi_1908_ = vec3<f32>(_e1166, _e1169, _e1163);
                                            } else {
                                                if (_e539 == 1u) {
                                                    phi_1907_ = vec3<f32>(_e1169, _e1163, _e1166);
                                                } else {
                                                    phi_1907_ = (_e1158 - _e1160);
                                                }
                                                let _e1176 = phi_1907_;
                                                phi_1908_ = _e1176;
                                            }
                                            let _e1178 = phi_1908_;
                                            let _e1180 = triangles.member[(0u + _e951)].v2_;
                                            let _e1182 = triangles.member[(0u + _e951)].v0_;
                                            let _e1185 = (_e1180.x - _e1182.x);
                                            let _e1188 = (_e1180.y - _e1182.y);
                                            let _e1191 = (_e1180.z - _e1182.z);
                                            if (_e539 == 0u) {
                                                phi_1934_ = vec3<f32>(_e1188, _e1191, _e1185);
                                            } else {
                                                if (_e539 == 1u) {
                                                    phi_1933_ = vec3<f32>(_e1191, _e1185, _e1188);
                                                } else {
                                                    phi_1933_ = (_e1180 - _e1182);
                                                }
                                                let _e1198 = phi_1933_;
                                                phi_1934_ = _e1198;
                                            }
                                            let _e1200 = phi_1934_;
                                            let _e1207 = ((_e1178.y * _e1200.z) - (_e1178.z * _e1200.y));
                                            let _e1214 = ((_e1178.z * _e1200.x) - (_e1178.x * _e1200.z));
                                            let _e1221 = ((_e1178.x * _e1200.y) - (_e1178.y * _e1200.x));
                                            let _e1235 = (((1f / _e547.z) * (((_e1207 * _e1156.x) + (_e1214 * _e1156.y)) + (_e1221 * _e1156.z))) / (((_e1207 * _e550) + (_e1214 * _e553)) + _e1221));
                                            if (_e1235 > 0f) {
                                                if (_e1235 < _e162) {
                                                    let _e1239 = triangles.member[(0u + _e951)].v0_;
                                                    let _e1241 = triangles.member[(0u + _e951)].v1_;
                                                    if (_e1239.x < _e1241.x) {
                                                        phi_1990_ = _e1239.x;
                                                    } else {
                                                        phi_1990_ = _e1241.x;
                                                    }
                                                    let _e1248 = phi_1990_;
                                                    if (_e1239.y < _e1241.y) {
                                                        phi_1999_ = _e1239.y;
                                                    } else {
                                                        phi_1999_ = _e1241.y;
                                                    }
                                                    let _e1255 = phi_1999_;
                                                    if (_e1239.z < _e1241.z) {
                                                        phi_2008_ = _e1239.z;
                                                    } else {
                                                        phi_2008_ = _e1241.z;
                                                    }
                                                    let _e1262 = phi_2008_;
                                                    let _e1264 = triangles.member[(0u + _e951)].v2_;
                                                    if (_e1248 < _e1264.x) {
                                                        phi_2017_ = _e1248;
                                                    } else {
                                                        phi_2017_ = _e1264.x;
                                                    }
                                                    let _e1269 = phi_2017_;
                                                    if (_e1255 < _e1264.y) {
                                                        phi_2024_ = _e1255;
                                                    } else {
                                                        phi_2024_ = _e1264.y;
                                                    }
                                                    let _e1274 = phi_2024_;
                                                    if (_e1262 < _e1264.z) {
                                                        phi_2031_ = _e1262;
                                                    } else {
                                                        phi_2031_ = _e1264.z;
                                                    }
                                                    let _e1279 = phi_2031_;
                                                    let _e1281 = triangles.member[(0u + _e951)].v0_;
                                                    let _e1283 = triangles.member[(0u + _e951)].v1_;
                                                    if (_e1281.x > _e1283.x) {
                                                        phi_2044_ = _e1281.x;
                                                    } else {
                                                        phi_2044_ = _e1283.x;
                                                    }
                                                    let _e1290 = phi_2044_;
                                                    if (_e1281.y > _e1283.y) {
                                                        phi_2053_ = _e1281.y;
                                                    } else {
                                                        phi_2053_ = _e1283.y;
                                                    }
                                                    let _e1297 = phi_2053_;
                                                    if (_e1281.z > _e1283.z) {
                                                        phi_2062_ = _e1281.z;
                                                    } else {
                                                        phi_2062_ = _e1283.z;
                                                    }
                                                    let _e1304 = phi_2062_;
                                                    let _e1306 = triangles.member[(0u + _e951)].v2_;
                                                    if (_e1290 > _e1306.x) {
                                                        phi_2071_ = _e1290;
                                                    } else {
                                                        phi_2071_ = _e1306.x;
                                                    }
                                                    let _e1311 = phi_2071_;
                                                    if (_e1297 > _e1306.y) {
                                                        phi_2078_ = _e1297;
                                                    } else {
                                                        phi_2078_ = _e1306.y;
                                                    }
                                                    let _e1316 = phi_2078_;
                                                    if (_e1304 > _e1306.z) {
                                                        phi_2085_ = _e1304;
                                                    } else {
                                                        phi_2085_ = _e1306.z;
                                                    }
                                                    let _e1321 = phi_2085_;
                                                    let _e1325 = ((_e1269 - _e150) * _e468);
                                                    let _e1326 = ((_e1274 - _e152) * _e478);
                                                    let _e1327 = ((_e1279 - _e154) * _e488);
                                                    let _e1331 = ((_e1311 - _e150) * _e468);
                                                    let _e1332 = ((_e1316 - _e152) * _e478);
                                                    let _e1333 = ((_e1321 - _e154) * _e488);
                                                    if (_e1325 < _e1331) {
                                                        phi_2102_ = _e1325;
                                                    } else {
                                                        phi_2102_ = _e1331;
                                                    }
                                                    let _e1336 = phi_2102_;
                                                    if (_e1326 < _e1332) {
                                                        phi_2107_ = _e1326;
                                                    } else {
                                                        phi_2107_ = _e1332;
                                                    }
                                                    let _e1339 = phi_2107_;
                                                    if (_e1327 < _e1333) {
                                                        phi_2112_ = _e1327;
                                                    } else {
                                                        phi_2112_ = _e1333;
                                                    }
                                                    let _e1342 = phi_2112_;
                                                    if (_e1325 > _e1331) {
                                                        phi_2120_ = _e1325;
                                                    } else {
                                                        phi_2120_ = _e1331;
                                                    }
                                                    let _e1348 = phi_2120_;
                                                    if (_e1326 > _e1332) {
                                                        phi_2125_ = _e1326;
                                                    } else {
                                                        phi_2125_ = _e1332;
                                                    }
                                                    let _e1351 = phi_2125_;
                                                    if (_e1327 > _e1333) {
                                                        phi_2130_ = _e1327;
                                                    } else {
                                                        phi_2130_ = _e1333;
                                                    }
                                                    let _e1354 = phi_2130_;
                                                    let _e1358 = core_intrinsics_maximum_number_nsz_f32_((_e1336 - _e523), (_e1339 - _e524));
                                                    let _e1359 = core_intrinsics_maximum_number_nsz_f32_(_e1358, (_e1342 - _e525));
                                                    let _e1360 = core_intrinsics_minimum_number_nsz_f32_((_e1348 + _e523), (_e1351 + _e524));
                                                    let _e1361 = core_intrinsics_minimum_number_nsz_f32_(_e1360, (_e1354 + _e525));
                                                    if (_e1359 > -300000000000000000000000000000000000000f) {
                                                        phi_2142_ = _e1359;
                                                    } else {
                                                        phi_2142_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1364 = phi_2142_;
                                                    if (_e1361 < 300000000000000000000000000000000000000f) {
                                                        phi_2147_ = _e1361;
                                                    } else {
                                                        phi_2147_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1367 = phi_2147_;
                                                    if (_e1235 < _e1364) {
                                                        phi_2152_ = _e1364;
                                                    } else {
                                                        phi_2152_ = _e1235;
                                                    }
                                                    let _e1370 = phi_2152_;
                                                    if (_e1370 > _e1367) {
                                                        phi_2157_ = _e1367;
                                                    } else {
                                                        phi_2157_ = _e1370;
                                                    }
                                                    let _e1373 = phi_2157_;
                                                    phi_2162_ = lt_bvh_triangle_Intersection(_e1373, (_e1076 / _e1135), (_e1097 / _e1135), (_e1364 <= _e1367));
                                                    phi_2163_ = false;
                                                } else {
                                                    phi_2162_ = lt_bvh_triangle_Intersection();
                                                    phi_2163_ = true;
                                                }
                                                let _e1379 = phi_2162_;
                                                let _e1381 = phi_2163_;
                                                phi_2164_ = _e1379;
                                                phi_2165_ = _e1381;
                                            } else {
                                                phi_2164_ = lt_bvh_triangle_Intersection();
                                                phi_2165_ = true;
                                            }
                                            let _e1383 = phi_2164_;
                                            let _e1385 = phi_2165_;
                                            if _e1385 {
                                            }
                                            phi_2169_ = _e1383;
                                            phi_2170_ = _e1385;
                                        }
                                        let _e1387 = phi_2169_;
                                        let _e1389 = phi_2170_;
                                        phi_2171_ = _e1387;
                                        phi_2172_ = _e1138;
                                        phi_2173_ = _e1389;
                                    } else {
                                        phi_2171_ = lt_bvh_triangle_Intersection();
                                        phi_2172_ = true;
                                        phi_2173_ = false;
                                    }
                                    let _e1391 = phi_2171_;
                                    let _e1393 = phi_2172_;
                                    let _e1395 = phi_2173_;
                                    if _e1393 {
                                        phi_2177_ = true;
                                    } else {
                                        phi_2177_ = _e1395;
                                    }
                                    let _e1397 = phi_2177_;
                                    if _e1397 {
                                        phi_2181_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2181_ = _e1391;
                                    }
                                    let _e1399 = phi_2181_;
                                    if _e1399.is_hit {
                                        if (_e1399.t > 0f) {
                                            if (_e1399.t < _e162) {
                                                let _e1406 = triangles.member[(0u + _e951)].i0_;
                                                let _e1408 = ((_e1406 & 2147483648u) == 0u);
                                                if _e1408 {
                                                    phi_2404_ = false;
                                                    phi_2405_ = false;
                                                } else {
                                                    if (_e951 < _e94) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1415 = triangles.member[(0u + _e951)].i0_;
                                                    let _e1416 = (_e1415 & 2147483647u);
                                                    let _e1418 = triangles.member[(0u + _e951)].i1_;
                                                    let _e1420 = triangles.member[(0u + _e951)].i2_;
                                                    if (_e1416 < _e110) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1424 = vertices.member[(0u + _e1416)];
                                                    if (_e1418 < _e110) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1428 = vertices.member[(0u + _e1418)];
                                                    if (_e1420 < _e110) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1432 = vertices.member[(0u + _e1420)];
                                                    let _e1433 = array<abi_Vertex, 3>(_e1424, _e1428, _e1432);
                                                    if (_e1433[0].material < _e113) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1439 = materials.member[(0u + _e1433[0].material)];
                                                    if ((_e1439.flags & 1u) == 1u) {
                                                        let _e1444 = ((1f - _e1399.u) - _e1399.v);
                                                        if (_e1439.cutoff <= 0f) {
                                                            phi_2398_ = true;
                                                        } else {
                                                            let _e1471 = (_e1439.base_color.w * ((((f32((_e1433[0].color >> bitcast<u32>(24i))) * _e1444) + (f32((_e1433[1].color >> bitcast<u32>(24i))) * _e1399.u)) + (f32((_e1433[2].color >> bitcast<u32>(24i))) * _e1399.v)) * (1f / 255f)));
                                                            if (_e1439.alpha_size == 0u) {
                                                                phi_2395_ = _e1471;
                                                            } else {
                                                                local_2.offset = _e1439.alpha_offset;
                                                                local_2.size = _e1439.alpha_size;
                                                                local_2.flags = _e1439.flags;
                                                                let _e1502 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1433[0].u * _e1444) + (_e1433[1].u * _e1399.u)) + (_e1433[2].u * _e1399.v)), (((_e1433[0].v * _e1444) + (_e1433[1].v * _e1399.u)) + (_e1433[2].v * _e1399.v)));
                                                                let _e1506 = (_e1502.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1506 < _e116) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1510 = alpha_texels.member[(0u + _e1506)];
                                                                let _e1526 = (_e1502.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1526 < _e116) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1530 = alpha_texels.member[(0u + _e1526)];
                                                                let _e1547 = (_e1502.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1547 < _e116) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1551 = alpha_texels.member[(0u + _e1547)];
                                                                let _e1568 = (_e1502.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1568 < _e116) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1572 = alpha_texels.member[(0u + _e1568)];
                                                                phi_2395_ = (_e1471 * (((((f32(((_e1510 >> bitcast<u32>((((_e1502.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1502.weights.x) + ((f32(((_e1530 >> bitcast<u32>((((_e1502.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1502.weights.y)) + ((f32(((_e1551 >> bitcast<u32>((((_e1502.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1502.weights.z)) + ((f32(((_e1572 >> bitcast<u32>((((_e1502.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1502.weights.w)));
                                                            }
                                                            let _e1588 = phi_2395_;
                                                            phi_2398_ = (_e1588 >= _e1439.cutoff);
                                                        }
                                                        let _e1592 = phi_2398_;
                                                        phi_2399_ = _e1592;
                                                    } else {
                                                        phi_2399_ = false;
                                                    }
                                                    let _e1594 = phi_2399_;
                                                    if _e1594 {
                                                        phi_2403_ = false;
                                                    } else {
                                                        phi_2403_ = true;
                                                    }
                                                    let _e1596 = phi_2403_;
                                                    phi_2404_ = _e1596;
                                                    phi_2405_ = _e1594;
                                                }
                                                let _e1598 = phi_2404_;
                                                let _e1600 = phi_2405_;
                                                phi_2406_ = _e1598;
                                                phi_2407_ = _e1408;
                                                phi_2408_ = _e1600;
                                            } else {
                                                phi_2406_ = true;
                                                phi_2407_ = false;
                                                phi_2408_ = false;
                                            }
                                            let _e1602 = phi_2406_;
                                            let _e1604 = phi_2407_;
                                            let _e1606 = phi_2408_;
                                            phi_2409_ = false;
                                            phi_2410_ = _e1602;
                                            phi_2411_ = _e1604;
                                            phi_2412_ = _e1606;
                                        } else {
                                            phi_2409_ = true;
                                            phi_2410_ = false;
                                            phi_2411_ = false;
                                            phi_2412_ = false;
                                        }
                                        let _e1608 = phi_2409_;
                                        let _e1610 = phi_2410_;
                                        let _e1612 = phi_2411_;
                                        let _e1614 = phi_2412_;
                                        phi_2413_ = _e1608;
                                        phi_2414_ = _e1610;
                                        phi_2415_ = _e1612;
                                        phi_2416_ = _e1614;
                                    } else {
                                        phi_2413_ = true;
                                        phi_2414_ = false;
                                        phi_2415_ = false;
                                        phi_2416_ = false;
                                    }
                                    let _e1616 = phi_2413_;
                                    let _e1618 = phi_2414_;
                                    let _e1620 = phi_2415_;
                                    let _e1622 = phi_2416_;
                                    if _e1616 {
                                        phi_2420_ = true;
                                        phi_2421_ = false;
                                        phi_2422_ = false;
                                    } else {
                                        phi_2420_ = _e1618;
                                        phi_2421_ = _e1620;
                                        phi_2422_ = _e1622;
                                    }
                                    let _e1624 = phi_2420_;
                                    let _e1626 = phi_2421_;
                                    let _e1628 = phi_2422_;
                                    if _e1624 {
                                        phi_2426_ = false;
                                        phi_2427_ = false;
                                    } else {
                                        phi_2426_ = _e1626;
                                        phi_2427_ = _e1628;
                                    }
                                    let _e1630 = phi_2426_;
                                    let _e1632 = phi_2427_;
                                    phi_1583_ = (_e915 & (_e915 - 1u));
                                    phi_2428_ = _e1624;
                                    phi_2429_ = _e1630;
                                    phi_2430_ = _e1632;
                                }
                                let _e1634 = phi_1583_;
                                let _e1636 = phi_2428_;
                                let _e1638 = phi_2429_;
                                let _e1640 = phi_2430_;
                                local_14 = _e1638;
                                local_15 = _e1640;
                                continue;
                                continuing {
                                    phi_1582_ = _e1634;
                                    break if !(_e1636);
                                }
                            }
                            let _e1643 = local_6;
                            if _e1643 {
                                phi_2434_ = false;
                                phi_2435_ = false;
                            } else {
                                let _e3586 = local_14;
                                phi_2434_ = _e3586;
                                let _e3589 = local_15;
                                phi_2435_ = _e3589;
                            }
                            let _e1645 = phi_2434_;
                            let _e1647 = phi_2435_;
                            let _e3592 = local_16;
                            phi_1212_ = _e3592;
                            let _e3595 = local_17;
                            phi_1215_ = _e3595;
                            let _e3598 = local_18;
                            phi_2436_ = _e3598;
                            phi_2437_ = _e1645;
                            phi_2438_ = _e1647;
                        }
                        let _e1649 = phi_1212_;
                        let _e1651 = phi_1215_;
                        let _e1653 = phi_2436_;
                        let _e1655 = phi_2437_;
                        let _e1657 = phi_2438_;
                        local_19 = _e1655;
                        local_20 = _e1657;
                        continue;
                        continuing {
                            phi_1211_ = _e1649;
                            phi_1214_ = _e1651;
                            break if !(_e1653);
                        }
                    }
                    let _e1660 = local_7;
                    if _e1660 {
                        phi_2442_ = false;
                        phi_2443_ = false;
                    } else {
                        let _e3604 = local_19;
                        phi_2442_ = _e3604;
                        let _e3607 = local_20;
                        phi_2443_ = _e3607;
                    }
                    let _e1662 = phi_2442_;
                    let _e1664 = phi_2443_;
                    if _e1662 {
                        phi_2447_ = false;
                    } else {
                        phi_2447_ = _e1664;
                    }
                    let _e1666 = phi_2447_;
                    if _e1666 {
                        phi_2451_ = true;
                    } else {
                        phi_2451_ = _e1662;
                    }
                    let _e1668 = phi_2451_;
                    if _e1668 {
                    }
                    phi_2455_ = true;
                    phi_2456_ = _e1668;
                }
                let _e1670 = phi_2455_;
                let _e1672 = phi_2456_;
                if _e1672 {
                    phi_2460_ = _e1670;
                } else {
                    phi_2460_ = false;
                }
                let _e1674 = phi_2460_;
                phi_4125_ = _e1674;
            } else {
                let _e1675 = abs(_e170);
                let _e1676 = abs(_e171);
                let _e1677 = abs(_e172);
                if (abs(_e150) < 1000000000000000f) {
                    if (abs(_e152) < 1000000000000000f) {
                        phi_2476_ = (abs(_e154) < 1000000000000000f);
                        phi_2477_ = false;
                    } else {
                        phi_2476_ = bool();
                        phi_2477_ = true;
                    }
                    let _e1685 = phi_2476_;
                    let _e1687 = phi_2477_;
                    phi_2478_ = _e1685;
                    phi_2479_ = _e1687;
                } else {
                    phi_2478_ = bool();
                    phi_2479_ = true;
                }
                let _e1689 = phi_2478_;
                let _e1691 = phi_2479_;
                if _e1691 {
                    phi_2483_ = false;
                } else {
                    phi_2483_ = _e1689;
                }
                let _e1693 = phi_2483_;
                if _e1693 {
                    if (_e1675 < 1000000000000000f) {
                        if (_e1676 < 1000000000000000f) {
                            phi_2496_ = (_e1677 < 1000000000000000f);
                            phi_2497_ = false;
                        } else {
                            phi_2496_ = bool();
                            phi_2497_ = true;
                        }
                        let _e1698 = phi_2496_;
                        let _e1700 = phi_2497_;
                        phi_2498_ = _e1698;
                        phi_2499_ = _e1700;
                    } else {
                        phi_2498_ = bool();
                        phi_2499_ = true;
                    }
                    let _e1702 = phi_2498_;
                    let _e1704 = phi_2499_;
                    if _e1704 {
                        phi_2503_ = false;
                    } else {
                        phi_2503_ = _e1702;
                    }
                    let _e1706 = phi_2503_;
                    if _e1706 {
                        if (_e1675 > 0f) {
                            phi_2517_ = bool();
                            phi_2518_ = true;
                        } else {
                            let _e1708 = (_e1676 > 0f);
                            if _e1708 {
                                phi_2516_ = bool();
                            } else {
                                phi_2516_ = (_e1677 > 0f);
                            }
                            let _e1711 = phi_2516_;
                            phi_2517_ = _e1711;
                            phi_2518_ = _e1708;
                        }
                        let _e1713 = phi_2517_;
                        let _e1715 = phi_2518_;
                        if _e1715 {
                            phi_2522_ = true;
                        } else {
                            phi_2522_ = _e1713;
                        }
                        let _e1717 = phi_2522_;
                        phi_2523_ = _e1717;
                        phi_2524_ = false;
                    } else {
                        phi_2523_ = bool();
                        phi_2524_ = true;
                    }
                    let _e1719 = phi_2523_;
                    let _e1721 = phi_2524_;
                    phi_2525_ = _e1719;
                    phi_2526_ = _e1721;
                } else {
                    phi_2525_ = bool();
                    phi_2526_ = true;
                }
                let _e1723 = phi_2525_;
                let _e1725 = phi_2526_;
                if _e1725 {
                    phi_2530_ = false;
                } else {
                    phi_2530_ = _e1723;
                }
                let _e1727 = phi_2530_;
                if _e1727 {
                    let _e1728 = (0u >= _e91);
                    if _e1728 {
                        phi_4118_ = bool();
                    } else {
                        if (0u < _e91) {
                        } else {
                            return;
                        }
                        let _e1734 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1738 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1742 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1746 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1750 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1754 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1758 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1792 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170), abs(_e171));
                        let _e1793 = core_intrinsics_maximum_number_nsz_f32_(_e1792, abs(_e172));
                        let _e1794 = (_e1793 * 0.0000000000009094947f);
                        if (abs(_e170) < _e1794) {
                            phi_2600_ = _e1794;
                        } else {
                            phi_2600_ = abs(_e170);
                        }
                        let _e1799 = phi_2600_;
                        if (_e170 < 0f) {
                            phi_2607_ = (-1f / _e1799);
                        } else {
                            phi_2607_ = (1f / _e1799);
                        }
                        let _e1804 = phi_2607_;
                        if (abs(_e171) < _e1794) {
                            phi_2614_ = _e1794;
                        } else {
                            phi_2614_ = abs(_e171);
                        }
                        let _e1809 = phi_2614_;
                        if (_e171 < 0f) {
                            phi_2621_ = (-1f / _e1809);
                        } else {
                            phi_2621_ = (1f / _e1809);
                        }
                        let _e1814 = phi_2621_;
                        if (abs(_e172) < _e1794) {
                            phi_2628_ = _e1794;
                        } else {
                            phi_2628_ = abs(_e172);
                        }
                        let _e1819 = phi_2628_;
                        if (_e172 < 0f) {
                            phi_2635_ = (-1f / _e1819);
                        } else {
                            phi_2635_ = (1f / _e1819);
                        }
                        let _e1824 = phi_2635_;
                        let _e1828 = abs((bitcast<f32>(_e1734) - _e150));
                        let _e1829 = abs((bitcast<f32>(_e1738) - _e152));
                        let _e1830 = abs((bitcast<f32>(_e1742) - _e154));
                        let _e1834 = abs(((bitcast<f32>(_e1746) + (bitcast<f32>((((_e1758 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150));
                        let _e1835 = abs(((bitcast<f32>(_e1750) + (bitcast<f32>((((_e1758 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e152));
                        let _e1836 = abs(((bitcast<f32>(_e1754) + (bitcast<f32>((((_e1758 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154));
                        if (_e1828 > _e1834) {
                            phi_2652_ = _e1828;
                        } else {
                            phi_2652_ = _e1834;
                        }
                        let _e1839 = phi_2652_;
                        if (_e1829 > _e1835) {
                            phi_2657_ = _e1829;
                        } else {
                            phi_2657_ = _e1835;
                        }
                        let _e1842 = phi_2657_;
                        if (_e1830 > _e1836) {
                            phi_2662_ = _e1830;
                        } else {
                            phi_2662_ = _e1836;
                        }
                        let _e1845 = phi_2662_;
                        if (_e1839 > _e1842) {
                            phi_2667_ = _e1839;
                        } else {
                            phi_2667_ = _e1842;
                        }
                        let _e1848 = phi_2667_;
                        if (_e1848 > _e1845) {
                            phi_2672_ = _e1848;
                        } else {
                            phi_2672_ = _e1845;
                        }
                        let _e1851 = phi_2672_;
                        let _e1855 = (_e1851 * 0.0000019073486f);
                        let _e1856 = (abs(_e1804) * _e1855);
                        let _e1857 = (abs(_e1814) * _e1855);
                        let _e1858 = (abs(_e1824) * _e1855);
                        let _e1862 = (_e1851 * 0.0000009536743f);
                        let _e1863 = (abs(_e1804) * _e1862);
                        let _e1864 = (abs(_e1814) * _e1862);
                        let _e1865 = (abs(_e1824) * _e1862);
                        let _e1866 = abs(_e170);
                        let _e1867 = abs(_e171);
                        let _e1868 = abs(_e172);
                        if (_e1866 >= _e1867) {
                            if (_e1866 >= _e1868) {
                                phi_2698_ = false;
                            } else {
                                phi_2698_ = true;
                            }
                            let _e1872 = phi_2698_;
                            phi_2699_ = _e1872;
                        } else {
                            phi_2699_ = true;
                        }
                        let _e1874 = phi_2699_;
                        if _e1874 {
                            if (_e1867 >= _e1868) {
                                phi_2707_ = 1u;
                            } else {
                                phi_2707_ = 2u;
                            }
                            let _e1877 = phi_2707_;
                            phi_2708_ = _e1877;
                        } else {
                            phi_2708_ = 0u;
                        }
                        let _e1879 = phi_2708_;
                        if (_e1879 == 0u) {
                            phi_2720_ = vec3<f32>(_e171, _e172, _e170);
                        } else {
                            if (_e1879 == 1u) {
                                phi_2719_ = vec3<f32>(_e172, _e170, _e171);
                            } else {
                                phi_2719_ = _e173;
                            }
                            let _e1885 = phi_2719_;
                            phi_2720_ = _e1885;
                        }
                        let _e1887 = phi_2720_;
                        let _e1890 = (_e1887.x / _e1887.z);
                        let _e1893 = (_e1887.y / _e1887.z);
                        if (_e1804 < 0f) {
                            phi_2733_ = 0u;
                        } else {
                            phi_2733_ = 1u;
                        }
                        let _e1898 = phi_2733_;
                        if (_e1814 < 0f) {
                            phi_2738_ = 0u;
                        } else {
                            phi_2738_ = 2u;
                        }
                        let _e1901 = phi_2738_;
                        if (_e1824 < 0f) {
                            phi_2743_ = 0u;
                        } else {
                            phi_2743_ = 4u;
                        }
                        let _e1904 = phi_2743_;
                        let _e1906 = ((_e1898 | _e1901) | _e1904);
                        let _e1907 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1907.first[0], _e1907.first[1], _e1907.first[2], _e1907.first[3], _e1907.first[4], _e1907.first[5], _e1907.first[6], _e1907.first[7], _e1907.first[8], _e1907.first[9], _e1907.first[10], _e1907.first[11], _e1907.first[12], _e1907.first[13], _e1907.first[14], _e1907.first[15], _e1907.first[16], _e1907.first[17], _e1907.first[18], _e1907.first[19], _e1907.first[20], _e1907.first[21], _e1907.first[22], _e1907.first[23], _e1907.first[24], _e1907.first[25], _e1907.first[26], _e1907.first[27], _e1907.first[28], _e1907.first[29], _e1907.first[30], _e1907.first[31]), array<u32, 32>(_e1907.mask[0], _e1907.mask[1], _e1907.mask[2], _e1907.mask[3], _e1907.mask[4], _e1907.mask[5], _e1907.mask[6], _e1907.mask[7], _e1907.mask[8], _e1907.mask[9], _e1907.mask[10], _e1907.mask[11], _e1907.mask[12], _e1907.mask[13], _e1907.mask[14], _e1907.mask[15], _e1907.mask[16], _e1907.mask[17], _e1907.mask[18], _e1907.mask[19], _e1907.mask[20], _e1907.mask[21], _e1907.mask[22], _e1907.mask[23], _e1907.mask[24], _e1907.mask[25], _e1907.mask[26], _e1907.mask[27], _e1907.mask[28], _e1907.mask[29], _e1907.mask[30], _e1907.mask[31]), _e1907.len, _e1907.group, _e1907.group_mask);
                        let _e1981 = local_1.group_mask;
                        if ((_e1981 & 4278190080u) == 0u) {
                            let _e1985 = local_1.len;
                            if (_e1985 == 0u) {
                                phi_2857_ = false;
                            } else {
                                let _e1989 = local_1.len;
                                local_1.len = (_e1989 - 1u);
                                let _e1992 = local_1.len;
                                if (_e1992 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1997 = local_1.first[(0u + _e1992)];
                                local_1.group = _e1997;
                                let _e2000 = local_1.len;
                                if (_e2000 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2005 = local_1.mask[(0u + _e2000)];
                                local_1.group_mask = _e2005;
                                phi_2857_ = true;
                            }
                            let _e2008 = phi_2857_;
                            phi_2858_ = _e2008;
                        } else {
                            phi_2858_ = true;
                        }
                        let _e2010 = phi_2858_;
                        if _e2010 {
                            let _e2012 = local_1.group_mask;
                            let _e2018 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2012)), 32u, (_e2012 == 0u)));
                            let _e2022 = local_1.group_mask;
                            let _e2036 = local_1.group_mask;
                            local_1.group_mask = (_e2036 & ~((1u << bitcast<u32>((_e2018 & 31u)))));
                            let _e2039 = local_1.group;
                            phi_2889_ = (_e2039 + countOneBits(((_e2022 & ~((4294967295u << bitcast<u32>((((_e2018 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2889_ = 4294967295u;
                        }
                        let _e2042 = phi_2889_;
                        phi_2891_ = _e2042;
                        phi_2894_ = false;
                        loop {
                            let _e2044 = phi_2891_;
                            let _e2046 = phi_2894_;
                            local_25 = _e2046;
                            if (_e2044 != 4294967295u) {
                                if (_e2044 < _e91) {
                                } else {
                                    return;
                                }
                                let _e2053 = nodes.member[(0u + _e2044)].frame[3u];
                                let _e2078 = (bitcast<f32>((((_e2053 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1804);
                                let _e2079 = (bitcast<f32>((((_e2053 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1814);
                                let _e2080 = (bitcast<f32>((((_e2053 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1824);
                                let _e2083 = nodes.member[(0u + _e2044)].frame[0u];
                                let _e2087 = nodes.member[(0u + _e2044)].frame[1u];
                                let _e2091 = nodes.member[(0u + _e2044)].frame[2u];
                                let _e2096 = ((bitcast<f32>(_e2083) - _e150) * _e1804);
                                let _e2097 = ((bitcast<f32>(_e2087) - _e152) * _e1814);
                                let _e2098 = ((bitcast<f32>(_e2091) - _e154) * _e1824);
                                let _e2106 = nodes.member[(0u + _e2044)].x;
                                if (_e1804 < 0f) {
                                    let _e2117 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2106.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2123 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2117.unnamed.word, _e2106.w), _e2117.unnamed_1);
                                    let _e2129 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2123.unnamed, lt_mask_LightPlace(_e2106.x, _e2123.unnamed_1.shift));
                                    phi_2974_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2129.unnamed, lt_mask_LightPlace(_e2129.unnamed_1.word, _e2106.y));
                                } else {
                                    let _e2145 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2106.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2151 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2145.unnamed.word, _e2106.y), _e2145.unnamed_1);
                                    let _e2157 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2151.unnamed, lt_mask_LightPlace(_e2106.z, _e2151.unnamed_1.shift));
                                    phi_2974_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2157.unnamed, lt_mask_LightPlace(_e2157.unnamed_1.word, _e2106.w));
                                }
                                let _e2165 = phi_2974_;
                                let _e2175 = nodes.member[(0u + _e2044)].y;
                                if (_e1814 < 0f) {
                                    let _e2186 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2175.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2192 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2186.unnamed.word, _e2175.w), _e2186.unnamed_1);
                                    let _e2198 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2192.unnamed, lt_mask_LightPlace(_e2175.x, _e2192.unnamed_1.shift));
                                    phi_3001_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2198.unnamed, lt_mask_LightPlace(_e2198.unnamed_1.word, _e2175.y));
                                } else {
                                    let _e2214 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2175.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2220 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2214.unnamed.word, _e2175.y), _e2214.unnamed_1);
                                    let _e2226 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2220.unnamed, lt_mask_LightPlace(_e2175.z, _e2220.unnamed_1.shift));
                                    phi_3001_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2226.unnamed, lt_mask_LightPlace(_e2226.unnamed_1.word, _e2175.w));
                                }
                                let _e2234 = phi_3001_;
                                let _e2244 = nodes.member[(0u + _e2044)].z;
                                if (_e1824 < 0f) {
                                    let _e2255 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2244.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2261 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2255.unnamed.word, _e2244.w), _e2255.unnamed_1);
                                    let _e2267 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2261.unnamed, lt_mask_LightPlace(_e2244.x, _e2261.unnamed_1.shift));
                                    phi_3028_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2267.unnamed, lt_mask_LightPlace(_e2267.unnamed_1.word, _e2244.y));
                                } else {
                                    let _e2283 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2244.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2289 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2283.unnamed.word, _e2244.y), _e2283.unnamed_1);
                                    let _e2295 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2289.unnamed, lt_mask_LightPlace(_e2244.z, _e2289.unnamed_1.shift));
                                    phi_3028_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2295.unnamed, lt_mask_LightPlace(_e2295.unnamed_1.word, _e2244.w));
                                }
                                let _e2303 = phi_3028_;
                                phi_3034_ = 0u;
                                phi_3037_ = 0u;
                                loop {
                                    let _e2313 = phi_3034_;
                                    let _e2315 = phi_3037_;
                                    local_8 = _e2315;
                                    local_9 = _e2315;
                                    local_10 = _e2315;
                                    let _e2316 = (_e2313 < 8u);
                                    if _e2316 {
                                        let _e2318 = (_e2313 >> bitcast<u32>(2i));
                                        let _e2319 = (_e2313 & 3u);
                                        if (_e2318 == 0u) {
                                            phi_3051_ = _e2165.unnamed.word;
                                        } else {
                                            phi_3051_ = _e2165.unnamed.shift;
                                        }
                                        let _e2322 = phi_3051_;
                                        if (_e2318 == 0u) {
                                            phi_3061_ = _e2234.unnamed.word;
                                        } else {
                                            phi_3061_ = _e2234.unnamed.shift;
                                        }
                                        let _e2331 = phi_3061_;
                                        if (_e2318 == 0u) {
                                            phi_3071_ = _e2303.unnamed.word;
                                        } else {
                                            phi_3071_ = _e2303.unnamed.shift;
                                        }
                                        let _e2340 = phi_3071_;
                                        let _e2353 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2322 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u)) * _e2078) + (_e2096 - _e1856)), ((f32(((_e2331 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u)) * _e2079) + (_e2097 - _e1857)));
                                        let _e2354 = core_intrinsics_maximum_number_nsz_f32_(_e2353, ((f32(((_e2340 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u)) * _e2080) + (_e2098 - _e1858)));
                                        if (_e2318 == 0u) {
                                            phi_3089_ = _e2165.unnamed_1.word;
                                        } else {
                                            phi_3089_ = _e2165.unnamed_1.shift;
                                        }
                                        let _e2357 = phi_3089_;
                                        if (_e2318 == 0u) {
                                            phi_3099_ = _e2234.unnamed_1.word;
                                        } else {
                                            phi_3099_ = _e2234.unnamed_1.shift;
                                        }
                                        let _e2366 = phi_3099_;
                                        if (_e2318 == 0u) {
                                            phi_3109_ = _e2303.unnamed_1.word;
                                        } else {
                                            phi_3109_ = _e2303.unnamed_1.shift;
                                        }
                                        let _e2375 = phi_3109_;
                                        let _e2388 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2357 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u)) * _e2078) + (_e2096 + _e1856)), ((f32(((_e2366 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u)) * _e2079) + (_e2097 + _e1857)));
                                        let _e2389 = core_intrinsics_minimum_number_nsz_f32_(_e2388, ((f32(((_e2375 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u)) * _e2080) + (_e2098 + _e1858)));
                                        if (_e2354 <= _e2389) {
                                            if (_e2354 <= _e162) {
                                                if (_e2389 >= 0f) {
                                                    if (_e2318 == 0u) {
                                                        let _e2396 = nodes.member[(0u + _e2044)].links[2u];
                                                        phi_3145_ = _e2396;
                                                    } else {
                                                        let _e2399 = nodes.member[(0u + _e2044)].links[3u];
                                                        phi_3145_ = _e2399;
                                                    }
                                                    let _e2401 = phi_3145_;
                                                    let _e2406 = ((_e2401 >> bitcast<u32>(((_e2319 * 8u) & 31u))) & 255u);
                                                    let _e2407 = (_e2406 & 31u);
                                                    if (_e2407 >= 24u) {
                                                        phi_3158_ = (24u + ((_e2407 - 24u) ^ _e1906));
                                                    } else {
                                                        phi_3158_ = _e2407;
                                                    }
                                                    let _e2413 = phi_3158_;
                                                    phi_3163_ = (_e2315 | ((_e2406 >> bitcast<u32>(5i)) << bitcast<u32>((_e2413 & 31u))));
                                                } else {
                                                    phi_3163_ = _e2315;
                                                }
                                                let _e2421 = phi_3163_;
                                                phi_3164_ = _e2421;
                                            } else {
                                                phi_3164_ = _e2315;
                                            }
                                            let _e2423 = phi_3164_;
                                            phi_3165_ = _e2423;
                                        } else {
                                            phi_3165_ = _e2315;
                                        }
                                        let _e2425 = phi_3165_;
                                        phi_3035_ = (_e2313 + 1u);
                                        phi_3038_ = _e2425;
                                    } else {
                                        phi_3035_ = u32();
                                        phi_3038_ = u32();
                                    }
                                    let _e2428 = phi_3035_;
                                    let _e2430 = phi_3038_;
                                    continue;
                                    continuing {
                                        phi_3034_ = _e2428;
                                        phi_3037_ = _e2430;
                                        break if !(_e2316);
                                    }
                                }
                                let _e2434 = nodes.member[(0u + _e2044)].links[0u];
                                let _e2438 = nodes.member[(0u + _e2044)].frame[3u];
                                let _e2442 = local_8;
                                if ((_e2442 & 4278190080u) == 0u) {
                                } else {
                                    let _e2446 = local_1.group_mask;
                                    if ((_e2446 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2450 = local_1.len;
                                        if (_e2450 < 32u) {
                                            let _e2453 = local_1.group;
                                            let _e2455 = local_1.len;
                                            if (_e2455 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2455)] = _e2453;
                                            let _e2461 = local_1.group_mask;
                                            let _e2463 = local_1.len;
                                            if (_e2463 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2463)] = _e2461;
                                            let _e2470 = local_1.len;
                                            local_1.len = (_e2470 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2434);
                                    let _e2474 = local_9;
                                    local_1.group_mask = ((_e2474 & 4278190080u) | (_e2438 >> bitcast<u32>(24i)));
                                }
                                let _e2479 = local_10;
                                phi_3223_ = (_e2479 & 16777215u);
                                phi_3226_ = _e2046;
                                loop {
                                    let _e2482 = phi_3223_;
                                    let _e2484 = phi_3226_;
                                    local_21 = _e2484;
                                    let _e2485 = (_e2482 == 0u);
                                    local_11 = _e2485;
                                    local_23 = _e2485;
                                    if _e2485 {
                                        phi_3224_ = u32();
                                        phi_3227_ = bool();
                                        phi_4030_ = bool();
                                        phi_4031_ = false;
                                    } else {
                                        let _e2488 = nodes.member[(0u + _e2044)].links[1u];
                                        let _e2493 = ((0u + _e2488) + select(firstTrailingBit(_e2482), 32u, (_e2482 == 0u)));
                                        if (_e2493 < _e94) {
                                        } else {
                                            return;
                                        }
                                        let _e2500 = triangles.member[(0u + _e2493)].v0_;
                                        let _e2502 = (_e2500.x - _e150);
                                        let _e2504 = (_e2500.y - _e152);
                                        let _e2506 = (_e2500.z - _e154);
                                        if (_e1879 == 0u) {
                                            phi_3271_ = vec3<f32>(_e2504, _e2506, _e2502);
                                        } else {
                                            if (_e1879 == 1u) {
                                                phi_3270_ = vec3<f32>(_e2506, _e2502, _e2504);
                                            } else {
                                                phi_3270_ = (_e2500 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2514 = phi_3270_;
                                            phi_3271_ = _e2514;
                                        }
                                        let _e2516 = phi_3271_;
                                        let _e2520 = (_e2516.x - (_e1890 * _e2516.z));
                                        let _e2524 = (_e2516.y - (_e1893 * _e2516.z));
                                        let _e2526 = triangles.member[(0u + _e2493)].v1_;
                                        let _e2528 = (_e2526.x - _e150);
                                        let _e2530 = (_e2526.y - _e152);
                                        let _e2532 = (_e2526.z - _e154);
                                        if (_e1879 == 0u) {
                                            phi_3301_ = vec3<f32>(_e2530, _e2532, _e2528);
                                        } else {
                                            if (_e1879 == 1u) {
                                                phi_3300_ = vec3<f32>(_e2532, _e2528, _e2530);
                                            } else {
                                                phi_3300_ = (_e2526 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2540 = phi_3300_;
                                            phi_3301_ = _e2540;
                                        }
                                        let _e2542 = phi_3301_;
                                        let _e2546 = (_e2542.x - (_e1890 * _e2542.z));
                                        let _e2550 = (_e2542.y - (_e1893 * _e2542.z));
                                        let _e2552 = triangles.member[(0u + _e2493)].v2_;
                                        let _e2554 = (_e2552.x - _e150);
                                        let _e2556 = (_e2552.y - _e152);
                                        let _e2558 = (_e2552.z - _e154);
                                        if (_e1879 == 0u) {
                                            phi_3331_ = vec3<f32>(_e2556, _e2558, _e2554);
                                        } else {
                                            if (_e1879 == 1u) {
                                                phi_3330_ = vec3<f32>(_e2558, _e2554, _e2556);
                                            } else {
                                                phi_3330_ = (_e2552 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2566 = phi_3330_;
                                            phi_3331_ = _e2566;
                                        }
                                        let _e2568 = phi_3331_;
                                        let _e2572 = (_e2568.x - (_e1890 * _e2568.z));
                                        let _e2576 = (_e2568.y - (_e1893 * _e2568.z));
                                        if (_e2546 < _e2572) {
                                            phi_3350_ = true;
                                        } else {
                                            if (_e2546 == _e2572) {
                                                phi_3349_ = (_e2550 < _e2576);
                                            } else {
                                                phi_3349_ = false;
                                            }
                                            let _e2581 = phi_3349_;
                                            phi_3350_ = _e2581;
                                        }
                                        let _e2583 = phi_3350_;
                                        if _e2583 {
                                            phi_3354_ = _e2576;
                                            phi_3355_ = _e2572;
                                            phi_3356_ = _e2550;
                                            phi_3357_ = _e2546;
                                        } else {
                                            phi_3354_ = _e2550;
                                            phi_3355_ = _e2546;
                                            phi_3356_ = _e2576;
                                            phi_3357_ = _e2572;
                                        }
                                        let _e2585 = phi_3354_;
                                        let _e2587 = phi_3355_;
                                        let _e2589 = phi_3356_;
                                        let _e2591 = phi_3357_;
                                        let _e2594 = ((_e2591 * _e2585) - (_e2589 * _e2587));
                                        if _e2583 {
                                            phi_3365_ = -(_e2594);
                                        } else {
                                            phi_3365_ = _e2594;
                                        }
                                        let _e2597 = phi_3365_;
                                        if (_e2572 < _e2520) {
                                            phi_3376_ = true;
                                        } else {
                                            if (_e2572 == _e2520) {
                                                phi_3375_ = (_e2576 < _e2524);
                                            } else {
                                                phi_3375_ = false;
                                            }
                                            let _e2602 = phi_3375_;
                                            phi_3376_ = _e2602;
                                        }
                                        let _e2604 = phi_3376_;
                                        if _e2604 {
                                            phi_3380_ = _e2524;
                                            phi_3381_ = _e2520;
                                            phi_3382_ = _e2576;
                                            phi_3383_ = _e2572;
                                        } else {
                                            phi_3380_ = _e2576;
                                            phi_3381_ = _e2572;
                                            phi_3382_ = _e2524;
                                            phi_3383_ = _e2520;
                                        }
                                        let _e2606 = phi_3380_;
                                        let _e2608 = phi_3381_;
                                        let _e2610 = phi_3382_;
                                        let _e2612 = phi_3383_;
                                        let _e2615 = ((_e2612 * _e2606) - (_e2610 * _e2608));
                                        if _e2604 {
                                            phi_3391_ = -(_e2615);
                                        } else {
                                            phi_3391_ = _e2615;
                                        }
                                        let _e2618 = phi_3391_;
                                        if (_e2520 < _e2546) {
                                            phi_3402_ = true;
                                        } else {
                                            if (_e2520 == _e2546) {
                                                phi_3401_ = (_e2524 < _e2550);
                                            } else {
                                                phi_3401_ = false;
                                            }
                                            let _e2623 = phi_3401_;
                                            phi_3402_ = _e2623;
                                        }
                                        let _e2625 = phi_3402_;
                                        if _e2625 {
                                            phi_3406_ = _e2550;
                                            phi_3407_ = _e2546;
                                            phi_3408_ = _e2524;
                                            phi_3409_ = _e2520;
                                        } else {
                                            phi_3406_ = _e2524;
                                            phi_3407_ = _e2520;
                                            phi_3408_ = _e2550;
                                            phi_3409_ = _e2546;
                                        }
                                        let _e2627 = phi_3406_;
                                        let _e2629 = phi_3407_;
                                        let _e2631 = phi_3408_;
                                        let _e2633 = phi_3409_;
                                        let _e2636 = ((_e2633 * _e2627) - (_e2631 * _e2629));
                                        if _e2625 {
                                            phi_3417_ = -(_e2636);
                                        } else {
                                            phi_3417_ = _e2636;
                                        }
                                        let _e2639 = phi_3417_;
                                        if (_e2597 >= 0f) {
                                            if (_e2618 >= 0f) {
                                                if (_e2639 >= 0f) {
                                                    phi_3432_ = ((_e2597 + _e2618) + _e2639);
                                                    phi_3433_ = false;
                                                } else {
                                                    phi_3432_ = f32();
                                                    phi_3433_ = true;
                                                }
                                                let _e2646 = phi_3432_;
                                                let _e2648 = phi_3433_;
                                                phi_3434_ = _e2646;
                                                phi_3435_ = _e2648;
                                            } else {
                                                phi_3434_ = f32();
                                                phi_3435_ = true;
                                            }
                                            let _e2650 = phi_3434_;
                                            let _e2652 = phi_3435_;
                                            phi_3436_ = _e2650;
                                            phi_3437_ = _e2652;
                                        } else {
                                            phi_3436_ = f32();
                                            phi_3437_ = true;
                                        }
                                        let _e2654 = phi_3436_;
                                        let _e2656 = phi_3437_;
                                        if _e2656 {
                                            if (_e2597 <= 0f) {
                                                if (_e2618 <= 0f) {
                                                    let _e2659 = (_e2639 <= 0f);
                                                    if _e2659 {
                                                    }
                                                    phi_3455_ = ((_e2597 + _e2618) + _e2639);
                                                    phi_3456_ = false;
                                                    phi_3457_ = _e2659;
                                                } else {
                                                    phi_3455_ = f32();
                                                    phi_3456_ = true;
                                                    phi_3457_ = false;
                                                }
                                                let _e2663 = phi_3455_;
                                                let _e2665 = phi_3456_;
                                                let _e2667 = phi_3457_;
                                                phi_3458_ = _e2663;
                                                phi_3459_ = _e2665;
                                                phi_3460_ = _e2667;
                                            } else {
                                                phi_3458_ = f32();
                                                phi_3459_ = true;
                                                phi_3460_ = false;
                                            }
                                            let _e2669 = phi_3458_;
                                            let _e2671 = phi_3459_;
                                            let _e2673 = phi_3460_;
                                            if _e2671 {
                                                phi_3464_ = false;
                                            } else {
                                                phi_3464_ = _e2673;
                                            }
                                            let _e2675 = phi_3464_;
                                            phi_3465_ = _e2669;
                                            phi_3466_ = _e2675;
                                        } else {
                                            phi_3465_ = _e2654;
                                            phi_3466_ = true;
                                        }
                                        let _e2677 = phi_3465_;
                                        let _e2679 = phi_3466_;
                                        if _e2679 {
                                            let _e2680 = (_e2677 == 0f);
                                            if _e2680 {
                                                phi_3782_ = lt_bvh_triangle_Intersection();
                                                phi_3783_ = false;
                                            } else {
                                                let _e2682 = triangles.member[(0u + _e2493)].v0_;
                                                let _e2684 = (_e2682.x - _e150);
                                                let _e2686 = (_e2682.y - _e152);
                                                let _e2688 = (_e2682.z - _e154);
                                                if (_e1879 == 0u) {
                                                    phi_3495_ = vec3<f32>(_e2686, _e2688, _e2684);
                                                } else {
                                                    if (_e1879 == 1u) {
                                                        phi_3494_ = vec3<f32>(_e2688, _e2684, _e2686);
                                                    } else {
                                                        phi_3494_ = (_e2682 - vec3<f32>(_e150, _e152, _e154));
                                                    }
                                                    let _e2696 = phi_3494_;
                                                    phi_3495_ = _e2696;
                                                }
                                                let _e2698 = phi_3495_;
                                                let _e2700 = triangles.member[(0u + _e2493)].v1_;
                                                let _e2702 = triangles.member[(0u + _e2493)].v0_;
                                                let _e2705 = (_e2700.x - _e2702.x);
                                                let _e2708 = (_e2700.y - _e2702.y);
                                                let _e2711 = (_e2700.z - _e2702.z);
                                                if (_e1879 == 0u) {
                                                    phi_3521_ = vec3<f32>(_e2708, _e2711, _e2705);
                                                } else {
                                                    if (_e1879 == 1u) {
                                                        phi_3520_ = vec3<f32>(_e2711, _e2705, _e2708);
                                                    } else {
                                                        phi_3520_ = (_e2700 - _e2702);
                                                    }
                                                    let _e2718 = phi_3520_;
                                                    phi_3521_ = _e2718;
                                                }
                                                let _e2720 = phi_3521_;
                                                let _e2722 = triangles.member[(0u + _e2493)].v2_;
                                                let _e2724 = triangles.member[(0u + _e2493)].v0_;
                                                let _e2727 = (_e2722.x - _e2724.x);
                                                let _e2730 = (_e2722.y - _e2724.y);
                                                let _e2733 = (_e2722.z - _e2724.z);
                                                if (_e1879 == 0u) {
                                                    phi_3547_ = vec3<f32>(_e2730, _e2733, _e2727);
                                                } else {
                                                    if (_e1879 == 1u) {
                                                        phi_3546_ = vec3<f32>(_e2733, _e2727, _e2730);
                                                    } else {
                                                        phi_3546_ = (_e2722 - _e2724);
                                                    }
                                                    let _e2740 = phi_3546_;
                                                    phi_3547_ = _e2740;
                                                }
                                                let _e2742 = phi_3547_;
                                                let _e2749 = ((_e2720.y * _e2742.z) - (_e2720.z * _e2742.y));
                                                let _e2756 = ((_e2720.z * _e2742.x) - (_e2720.x * _e2742.z));
                                                let _e2763 = ((_e2720.x * _e2742.y) - (_e2720.y * _e2742.x));
                                                let _e2777 = (((1f / _e1887.z) * (((_e2749 * _e2698.x) + (_e2756 * _e2698.y)) + (_e2763 * _e2698.z))) / (((_e2749 * _e1890) + (_e2756 * _e1893)) + _e2763));
                                                if (_e2777 > 0f) {
                                                    if (_e2777 < _e162) {
                                                        let _e2781 = triangles.member[(0u + _e2493)].v0_;
                                                        let _e2783 = triangles.member[(0u + _e2493)].v1_;
                                                        if (_e2781.x < _e2783.x) {
                                                            phi_3603_ = _e2781.x;
                                                        } else {
                                                            phi_3603_ = _e2783.x;
                                                        }
                                                        let _e2790 = phi_3603_;
                                                        if (_e2781.y < _e2783.y) {
                                                            phi_3612_ = _e2781.y;
                                                        } else {
                                                            phi_3612_ = _e2783.y;
                                                        }
                                                        let _e2797 = phi_3612_;
                                                        if (_e2781.z < _e2783.z) {
                                                            phi_3621_ = _e2781.z;
                                                        } else {
                                                            phi_3621_ = _e2783.z;
                                                        }
                                                        let _e2804 = phi_3621_;
                                                        let _e2806 = triangles.member[(0u + _e2493)].v2_;
                                                        if (_e2790 < _e2806.x) {
                                                            phi_3630_ = _e2790;
                                                        } else {
                                                            phi_3630_ = _e2806.x;
                                                        }
                                                        let _e2811 = phi_3630_;
                                                        if (_e2797 < _e2806.y) {
                                                            phi_3637_ = _e2797;
                                                        } else {
                                                            phi_3637_ = _e2806.y;
                                                        }
                                                        let _e2816 = phi_3637_;
                                                        if (_e2804 < _e2806.z) {
                                                            phi_3644_ = _e2804;
                                                        } else {
                                                            phi_3644_ = _e2806.z;
                                                        }
                                                        let _e2821 = phi_3644_;
                                                        let _e2823 = triangles.member[(0u + _e2493)].v0_;
                                                        let _e2825 = triangles.member[(0u + _e2493)].v1_;
                                                        if (_e2823.x > _e2825.x) {
                                                            phi_3657_ = _e2823.x;
                                                        } else {
                                                            phi_3657_ = _e2825.x;
                                                        }
                                                        let _e2832 = phi_3657_;
                                                        if (_e2823.y > _e2825.y) {
                                                            phi_3666_ = _e2823.y;
                                                        } else {
                                                            phi_3666_ = _e2825.y;
                                                        }
                                                        let _e2839 = phi_3666_;
                                                        if (_e2823.z > _e2825.z) {
                                                            phi_3675_ = _e2823.z;
                                                        } else {
                                                            phi_3675_ = _e2825.z;
                                                        }
                                                        let _e2846 = phi_3675_;
                                                        let _e2848 = triangles.member[(0u + _e2493)].v2_;
                                                        if (_e2832 > _e2848.x) {
                                                            phi_3684_ = _e2832;
                                                        } else {
                                                            phi_3684_ = _e2848.x;
                                                        }
                                                        let _e2853 = phi_3684_;
                                                        if (_e2839 > _e2848.y) {
                                                            phi_3691_ = _e2839;
                                                        } else {
                                                            phi_3691_ = _e2848.y;
                                                        }
                                                        let _e2858 = phi_3691_;
                                                        if (_e2846 > _e2848.z) {
                                                            phi_3698_ = _e2846;
                                                        } else {
                                                            phi_3698_ = _e2848.z;
                                                        }
                                                        let _e2863 = phi_3698_;
                                                        let _e2867 = ((_e2811 - _e150) * _e1804);
                                                        let _e2868 = ((_e2816 - _e152) * _e1814);
                                                        let _e2869 = ((_e2821 - _e154) * _e1824);
                                                        let _e2873 = ((_e2853 - _e150) * _e1804);
                                                        let _e2874 = ((_e2858 - _e152) * _e1814);
                                                        let _e2875 = ((_e2863 - _e154) * _e1824);
                                                        if (_e2867 < _e2873) {
                                                            phi_3715_ = _e2867;
                                                        } else {
                                                            phi_3715_ = _e2873;
                                                        }
                                                        let _e2878 = phi_3715_;
                                                        if (_e2868 < _e2874) {
                                                            phi_3720_ = _e2868;
                                                        } else {
                                                            phi_3720_ = _e2874;
                                                        }
                                                        let _e2881 = phi_3720_;
                                                        if (_e2869 < _e2875) {
                                                            phi_3725_ = _e2869;
                                                        } else {
                                                            phi_3725_ = _e2875;
                                                        }
                                                        let _e2884 = phi_3725_;
                                                        if (_e2867 > _e2873) {
                                                            phi_3733_ = _e2867;
                                                        } else {
                                                            phi_3733_ = _e2873;
                                                        }
                                                        let _e2890 = phi_3733_;
                                                        if (_e2868 > _e2874) {
                                                            phi_3738_ = _e2868;
                                                        } else {
                                                            phi_3738_ = _e2874;
                                                        }
                                                        let _e2893 = phi_3738_;
                                                        if (_e2869 > _e2875) {
                                                            phi_3743_ = _e2869;
                                                        } else {
                                                            phi_3743_ = _e2875;
                                                        }
                                                        let _e2896 = phi_3743_;
                                                        let _e2900 = core_intrinsics_maximum_number_nsz_f32_((_e2878 - _e1863), (_e2881 - _e1864));
                                                        let _e2901 = core_intrinsics_maximum_number_nsz_f32_(_e2900, (_e2884 - _e1865));
                                                        let _e2902 = core_intrinsics_minimum_number_nsz_f32_((_e2890 + _e1863), (_e2893 + _e1864));
                                                        let _e2903 = core_intrinsics_minimum_number_nsz_f32_(_e2902, (_e2896 + _e1865));
                                                        if (_e2901 > -300000000000000000000000000000000000000f) {
                                                            phi_3755_ = _e2901;
                                                        } else {
                                                            phi_3755_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2906 = phi_3755_;
                                                        if (_e2903 < 300000000000000000000000000000000000000f) {
                                                            phi_3760_ = _e2903;
                                                        } else {
                                                            phi_3760_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2909 = phi_3760_;
                                                        if (_e2777 < _e2906) {
                                                            phi_3765_ = _e2906;
                                                        } else {
                                                            phi_3765_ = _e2777;
                                                        }
                                                        let _e2912 = phi_3765_;
                                                        if (_e2912 > _e2909) {
                                                            phi_3770_ = _e2909;
                                                        } else {
                                                            phi_3770_ = _e2912;
                                                        }
                                                        let _e2915 = phi_3770_;
                                                        phi_3775_ = lt_bvh_triangle_Intersection(_e2915, (_e2618 / _e2677), (_e2639 / _e2677), (_e2906 <= _e2909));
                                                        phi_3776_ = false;
                                                    } else {
                                                        phi_3775_ = lt_bvh_triangle_Intersection();
                                                        phi_3776_ = true;
                                                    }
                                                    let _e2921 = phi_3775_;
                                                    let _e2923 = phi_3776_;
                                                    phi_3777_ = _e2921;
                                                    phi_3778_ = _e2923;
                                                } else {
                                                    phi_3777_ = lt_bvh_triangle_Intersection();
                                                    phi_3778_ = true;
                                                }
                                                let _e2925 = phi_3777_;
                                                let _e2927 = phi_3778_;
                                                if _e2927 {
                                                }
                                                phi_3782_ = _e2925;
                                                phi_3783_ = _e2927;
                                            }
                                            let _e2929 = phi_3782_;
                                            let _e2931 = phi_3783_;
                                            phi_3784_ = _e2929;
                                            phi_3785_ = _e2680;
                                            phi_3786_ = _e2931;
                                        } else {
                                            phi_3784_ = lt_bvh_triangle_Intersection();
                                            phi_3785_ = true;
                                            phi_3786_ = false;
                                        }
                                        let _e2933 = phi_3784_;
                                        let _e2935 = phi_3785_;
                                        let _e2937 = phi_3786_;
                                        if _e2935 {
                                            phi_3790_ = true;
                                        } else {
                                            phi_3790_ = _e2937;
                                        }
                                        let _e2939 = phi_3790_;
                                        if _e2939 {
                                            phi_3794_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3794_ = _e2933;
                                        }
                                        let _e2941 = phi_3794_;
                                        if _e2941.is_hit {
                                            if (_e2941.t > 0f) {
                                                if (_e2941.t < _e162) {
                                                    let _e2948 = triangles.member[(0u + _e2493)].i0_;
                                                    if ((_e2948 & 2147483648u) == 0u) {
                                                        phi_4013_ = true;
                                                    } else {
                                                        if (_e2493 < _e94) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2957 = triangles.member[(0u + _e2493)].i0_;
                                                        let _e2958 = (_e2957 & 2147483647u);
                                                        let _e2960 = triangles.member[(0u + _e2493)].i1_;
                                                        let _e2962 = triangles.member[(0u + _e2493)].i2_;
                                                        if (_e2958 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2966 = vertices.member[(0u + _e2958)];
                                                        if (_e2960 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2970 = vertices.member[(0u + _e2960)];
                                                        if (_e2962 < _e110) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2974 = vertices.member[(0u + _e2962)];
                                                        let _e2975 = array<abi_Vertex, 3>(_e2966, _e2970, _e2974);
                                                        if (_e2975[0].material < _e113) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2981 = materials.member[(0u + _e2975[0].material)];
                                                        if ((_e2981.flags & 1u) == 1u) {
                                                            let _e2986 = ((1f - _e2941.u) - _e2941.v);
                                                            if (_e2981.cutoff <= 0f) {
                                                                phi_4011_ = true;
                                                            } else {
                                                                let _e3013 = (_e2981.base_color.w * ((((f32((_e2975[0].color >> bitcast<u32>(24i))) * _e2986) + (f32((_e2975[1].color >> bitcast<u32>(24i))) * _e2941.u)) + (f32((_e2975[2].color >> bitcast<u32>(24i))) * _e2941.v)) * (1f / 255f)));
                                                                if (_e2981.alpha_size == 0u) {
                                                                    phi_4008_ = _e3013;
                                                                } else {
                                                                    local.offset = _e2981.alpha_offset;
                                                                    local.size = _e2981.alpha_size;
                                                                    local.flags = _e2981.flags;
                                                                    let _e3044 = _lt_shaders_texture_TextureView_quad((&local), (((_e2975[0].u * _e2986) + (_e2975[1].u * _e2941.u)) + (_e2975[2].u * _e2941.v)), (((_e2975[0].v * _e2986) + (_e2975[1].v * _e2941.u)) + (_e2975[2].v * _e2941.v)));
                                                                    let _e3048 = (_e3044.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3048 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3052 = alpha_texels.member[(0u + _e3048)];
                                                                    let _e3068 = (_e3044.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3068 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3072 = alpha_texels.member[(0u + _e3068)];
                                                                    let _e3089 = (_e3044.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3089 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3093 = alpha_texels.member[(0u + _e3089)];
                                                                    let _e3110 = (_e3044.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3110 < _e116) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3114 = alpha_texels.member[(0u + _e3110)];
                                                                    phi_4008_ = (_e3013 * (((((f32(((_e3052 >> bitcast<u32>((((_e3044.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3044.weights.x) + ((f32(((_e3072 >> bitcast<u32>((((_e3044.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3044.weights.y)) + ((f32(((_e3093 >> bitcast<u32>((((_e3044.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3044.weights.z)) + ((f32(((_e3114 >> bitcast<u32>((((_e3044.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3044.weights.w)));
                                                                }
                                                                let _e3130 = phi_4008_;
                                                                phi_4011_ = (_e3130 >= _e2981.cutoff);
                                                            }
                                                            let _e3134 = phi_4011_;
                                                            phi_4012_ = _e3134;
                                                        } else {
                                                            phi_4012_ = false;
                                                        }
                                                        let _e3136 = phi_4012_;
                                                        phi_4013_ = _e3136;
                                                    }
                                                    let _e3138 = phi_4013_;
                                                    if _e3138 {
                                                        phi_4017_ = false;
                                                    } else {
                                                        phi_4017_ = true;
                                                    }
                                                    let _e3140 = phi_4017_;
                                                    phi_4018_ = _e3138;
                                                    phi_4019_ = _e3138;
                                                    phi_4020_ = _e3140;
                                                } else {
                                                    phi_4018_ = bool();
                                                    phi_4019_ = _e2484;
                                                    phi_4020_ = true;
                                                }
                                                let _e3142 = phi_4018_;
                                                let _e3144 = phi_4019_;
                                                let _e3146 = phi_4020_;
                                                phi_4021_ = _e3142;
                                                phi_4022_ = _e3144;
                                                phi_4023_ = _e3146;
                                            } else {
                                                phi_4021_ = bool();
                                                phi_4022_ = _e2484;
                                                phi_4023_ = true;
                                            }
                                            let _e3148 = phi_4021_;
                                            let _e3150 = phi_4022_;
                                            let _e3152 = phi_4023_;
                                            phi_4024_ = _e3148;
                                            phi_4025_ = _e3150;
                                            phi_4026_ = _e3152;
                                        } else {
                                            phi_4024_ = bool();
                                            phi_4025_ = _e2484;
                                            phi_4026_ = true;
                                        }
                                        let _e3154 = phi_4024_;
                                        let _e3156 = phi_4025_;
                                        let _e3158 = phi_4026_;
                                        if _e3158 {
                                        }
                                        phi_3224_ = (_e2482 & (_e2482 - 1u));
                                        phi_3227_ = _e3156;
                                        phi_4030_ = _e3154;
                                        phi_4031_ = _e3158;
                                    }
                                    let _e3160 = phi_3224_;
                                    let _e3162 = phi_3227_;
                                    let _e3164 = phi_4030_;
                                    let _e3166 = phi_4031_;
                                    local_22 = _e3164;
                                    continue;
                                    continuing {
                                        phi_3223_ = _e3160;
                                        phi_3226_ = _e3162;
                                        break if !(_e3166);
                                    }
                                }
                                let _e3169 = local_11;
                                if _e3169 {
                                    let _e3171 = local_1.group_mask;
                                    if ((_e3171 & 4278190080u) == 0u) {
                                        let _e3175 = local_1.len;
                                        if (_e3175 == 0u) {
                                            phi_4073_ = false;
                                        } else {
                                            let _e3179 = local_1.len;
                                            local_1.len = (_e3179 - 1u);
                                            let _e3182 = local_1.len;
                                            if (_e3182 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3187 = local_1.first[(0u + _e3182)];
                                            local_1.group = _e3187;
                                            let _e3190 = local_1.len;
                                            if (_e3190 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3195 = local_1.mask[(0u + _e3190)];
                                            local_1.group_mask = _e3195;
                                            phi_4073_ = true;
                                        }
                                        let _e3198 = phi_4073_;
                                        phi_4074_ = _e3198;
                                    } else {
                                        phi_4074_ = true;
                                    }
                                    let _e3200 = phi_4074_;
                                    if _e3200 {
                                        let _e3202 = local_1.group_mask;
                                        let _e3208 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3202)), 32u, (_e3202 == 0u)));
                                        let _e3212 = local_1.group_mask;
                                        let _e3226 = local_1.group_mask;
                                        local_1.group_mask = (_e3226 & ~((1u << bitcast<u32>((_e3208 & 31u)))));
                                        let _e3229 = local_1.group;
                                        phi_4105_ = (_e3229 + countOneBits(((_e3212 & ~((4294967295u << bitcast<u32>((((_e3208 - 24u) ^ _e1906) & 31u))))) & 255u)));
                                    } else {
                                        phi_4105_ = 4294967295u;
                                    }
                                    let _e3232 = phi_4105_;
                                    phi_4106_ = _e3232;
                                } else {
                                    phi_4106_ = u32();
                                }
                                let _e3234 = phi_4106_;
                                phi_2892_ = _e3234;
                                let _e3787 = local_21;
                                phi_2895_ = _e3787;
                                let _e3790 = local_22;
                                phi_4107_ = _e3790;
                                let _e3793 = local_23;
                                phi_4108_ = _e3793;
                                phi_4109_ = false;
                            } else {
                                phi_2892_ = u32();
                                phi_2895_ = bool();
                                phi_4107_ = bool();
                                phi_4108_ = false;
                                phi_4109_ = true;
                            }
                            let _e3236 = phi_2892_;
                            let _e3238 = phi_2895_;
                            let _e3240 = phi_4107_;
                            let _e3242 = phi_4108_;
                            let _e3244 = phi_4109_;
                            local_12 = _e3244;
                            local_24 = _e3240;
                            continue;
                            continuing {
                                phi_2891_ = _e3236;
                                phi_2894_ = _e3238;
                                break if !(_e3242);
                            }
                        }
                        let _e3247 = local_12;
                        if _e3247 {
                            phi_4113_ = false;
                        } else {
                            phi_4113_ = true;
                        }
                        let _e3249 = phi_4113_;
                        if _e3249 {
                            let _e3799 = local_24;
                            phi_4117_ = _e3799;
                        } else {
                            let _e3801 = local_25;
                            phi_4117_ = _e3801;
                        }
                        let _e3251 = phi_4117_;
                        phi_4118_ = _e3251;
                    }
                    let _e3253 = phi_4118_;
                    phi_4119_ = _e3253;
                    phi_4120_ = _e1728;
                } else {
                    phi_4119_ = bool();
                    phi_4120_ = true;
                }
                let _e3255 = phi_4119_;
                let _e3257 = phi_4120_;
                if _e3257 {
                    phi_4124_ = false;
                } else {
                    phi_4124_ = _e3255;
                }
                let _e3259 = phi_4124_;
                phi_4125_ = _e3259;
            }
            let _e3261 = phi_4125_;
            phi_4126_ = _e3261;
        } else {
            phi_4126_ = false;
        }
        let _e3263 = phi_4126_;
        if _e3263 {
            phi_4130_ = 0f;
        } else {
            phi_4130_ = 1f;
        }
        let _e3265 = phi_4130_;
        if (_e129 < _e97) {
        } else {
            return;
        }
        visibility.member[(0u + _e129)] = _e3265;
        let _e3271 = p.member.light.number;
        let _e3272 = (_e3271 * 3u);
        let _e3273 = (_e3272 / 32u);
        let _e3274 = (_e3272 % 32u);
        let _e3276 = p.member.light.mask_words;
        if (_e129 < _e97) {
        } else {
            return;
        }
        let _e3280 = visibility.member[(0u + _e129)];
        let _e3282 = ((_e129 * _e3276) + _e3273);
        if (_e3274 > 29u) {
            let _e3284 = (_e3282 + 1u);
            if (_e3284 < _e103) {
            } else {
                return;
            }
            let _e3288 = bits.member[(0u + _e3284)];
            phi_4171_ = _e3288;
        } else {
            phi_4171_ = 0u;
        }
        let _e3290 = phi_4171_;
        if (_e3282 < _e103) {
        } else {
            return;
        }
        let _e3294 = bits.member[(0u + _e3282)];
        let _e3297 = (_e3294 >> bitcast<u32>((_e3274 & 31u)));
        if (_e3274 > 29u) {
            phi_4190_ = (_e3297 | (_e3290 << bitcast<u32>(((32u - _e3274) & 31u))));
        } else {
            phi_4190_ = _e3297;
        }
        let _e3305 = phi_4190_;
        if ((_e3305 & 2u) == 0u) {
            phi_4198_ = (_e3305 & 1u);
        } else {
            phi_4198_ = (_e3305 & 7u);
        }
        let _e3311 = phi_4198_;
        if ((_e3311 & 1u) != 0u) {
            phi_4206_ = (2u | 1u);
        } else {
            phi_4206_ = 2u;
        }
        let _e3317 = phi_4206_;
        if (_e3280 < 0.5f) {
            phi_4211_ = (_e3317 | 4u);
        } else {
            phi_4211_ = _e3317;
        }
        let _e3320 = phi_4211_;
        let _e3322 = ((_e129 * _e3276) + _e3273);
        if (_e3322 < _e103) {
        } else {
            return;
        }
        let _e3326 = bits.member[(0u + _e3322)];
        if (_e3322 < _e103) {
        } else {
            return;
        }
        bits.member[(0u + _e3322)] = ((_e3326 & ~((7u << bitcast<u32>((_e3274 & 31u))))) | (_e3320 << bitcast<u32>((_e3274 & 31u))));
        if (_e3274 > 29u) {
            let _e3340 = (_e3322 + 1u);
            if (_e3340 < _e103) {
            } else {
                return;
            }
            let _e3344 = bits.member[(0u + _e3340)];
            let _e3345 = (32u - _e3274);
            let _e3355 = (_e3322 + 1u);
            if (_e3355 < _e103) {
            } else {
                return;
            }
            bits.member[(0u + _e3355)] = ((_e3344 & ~((7u >> bitcast<u32>((_e3345 & 31u))))) | (_e3320 >> bitcast<u32>((_e3345 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
