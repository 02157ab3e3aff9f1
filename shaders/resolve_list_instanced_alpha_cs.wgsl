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

struct type_38 {
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

struct type_42 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_46 {
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

struct type_50 {
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

struct type_64 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(6) 
var<storage> instances: type_64;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_46;
@group(0) @binding(8) 
var<storage> materials: type_50;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_206_: bool;
    var phi_210_: f32;

    if (param != param) {
        phi_206_ = true;
    } else {
        let _e69 = (param_1 >= param);
        if _e69 {
        }
        phi_206_ = _e69;
    }
    let _e71 = phi_206_;
    if _e71 {
        phi_210_ = param_1;
    } else {
        phi_210_ = param;
    }
    let _e73 = phi_210_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_222_: bool;
    var phi_226_: f32;

    if (param_2 != param_2) {
        phi_222_ = true;
    } else {
        let _e69 = (param_3 <= param_2);
        if _e69 {
        }
        phi_222_ = _e69;
    }
    let _e71 = phi_222_;
    if _e71 {
        phi_226_ = param_3;
    } else {
        phi_226_ = param_2;
    }
    let _e73 = phi_226_;
    return _e73;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_268_: f32;
    var phi_273_: f32;
    var phi_274_: bool;
    var phi_275_: f32;
    var phi_276_: bool;
    var phi_280_: f32;
    var phi_306_: f32;
    var phi_311_: f32;
    var phi_312_: bool;
    var phi_313_: f32;
    var phi_314_: bool;
    var phi_318_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_356_: u32;
    var phi_370_: u32;
    var phi_377_: u32;
    var phi_382_: u32;
    var phi_388_: u32;
    var phi_393_: u32;
    var phi_395_: texture_Axis;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_435_: f32;
    var phi_461_: f32;
    var phi_466_: f32;
    var phi_467_: bool;
    var phi_468_: f32;
    var phi_469_: bool;
    var phi_473_: f32;
    var phi_481_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_492_: f32;
    var phi_493_: f32;
    var phi_511_: u32;
    var phi_525_: u32;
    var phi_532_: u32;
    var phi_537_: u32;
    var phi_543_: u32;
    var phi_548_: u32;
    var phi_550_: texture_Axis;

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
                phi_268_ = 1f;
            } else {
                phi_268_ = 0f;
            }
            let _e100 = phi_268_;
            if (param_5 < 8388608f) {
                phi_273_ = (_e97 - _e100);
                phi_274_ = false;
            } else {
                phi_273_ = f32();
                phi_274_ = true;
            }
            let _e103 = phi_273_;
            let _e105 = phi_274_;
            phi_275_ = _e103;
            phi_276_ = _e105;
        } else {
            phi_275_ = f32();
            phi_276_ = true;
        }
        let _e107 = phi_275_;
        let _e109 = phi_276_;
        if _e109 {
            phi_280_ = param_5;
        } else {
            phi_280_ = _e107;
        }
        let _e111 = phi_280_;
        phi_328_ = (param_5 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_5 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_306_ = 1f;
                } else {
                    phi_306_ = 0f;
                }
                let _e129 = phi_306_;
                if (_e114 < 8388608f) {
                    phi_311_ = (_e126 - _e129);
                    phi_312_ = false;
                } else {
                    phi_311_ = f32();
                    phi_312_ = true;
                }
                let _e132 = phi_311_;
                let _e134 = phi_312_;
                phi_313_ = _e132;
                phi_314_ = _e134;
            } else {
                phi_313_ = f32();
                phi_314_ = true;
            }
            let _e136 = phi_313_;
            let _e138 = phi_314_;
            if _e138 {
                phi_318_ = _e114;
            } else {
                phi_318_ = _e136;
            }
            let _e140 = phi_318_;
            let _e142 = (param_5 - (2f * _e140));
            if (_e142 > 1f) {
                phi_326_ = (2f - _e142);
            } else {
                phi_326_ = _e142;
            }
            let _e146 = phi_326_;
            phi_327_ = _e146;
        } else {
            phi_327_ = param_5;
        }
        let _e148 = phi_327_;
        phi_328_ = _e148;
    }
    let _e150 = phi_328_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_337_ = _e150;
        } else {
            phi_337_ = 1f;
        }
        let _e154 = phi_337_;
        phi_338_ = _e154;
    } else {
        phi_338_ = 0f;
    }
    let _e156 = phi_338_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_356_ = _e157;
        } else {
            phi_356_ = _e166;
        }
        let _e169 = phi_356_;
        phi_395_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_370_ = _e71;
        } else {
            phi_370_ = _e178;
        }
        let _e181 = phi_370_;
        if (_e84 == 0u) {
            phi_377_ = _e157;
        } else {
            phi_377_ = 0u;
        }
        let _e186 = phi_377_;
        if (_e84 == 0u) {
            phi_382_ = 0u;
        } else {
            phi_382_ = _e157;
        }
        let _e189 = phi_382_;
        if (_e181 == 0u) {
            phi_388_ = _e186;
        } else {
            phi_388_ = (_e181 - 1u);
        }
        let _e193 = phi_388_;
        if (_e181 > _e157) {
            phi_393_ = _e189;
        } else {
            phi_393_ = _e181;
        }
        let _e196 = phi_393_;
        phi_395_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_395_;
    let _e201 = (*param_4).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_6 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e217 > param_6) {
                phi_423_ = 1f;
            } else {
                phi_423_ = 0f;
            }
            let _e220 = phi_423_;
            if (param_6 < 8388608f) {
                phi_428_ = (_e217 - _e220);
                phi_429_ = false;
            } else {
                phi_428_ = f32();
                phi_429_ = true;
            }
            let _e223 = phi_428_;
            let _e225 = phi_429_;
            phi_430_ = _e223;
            phi_431_ = _e225;
        } else {
            phi_430_ = f32();
            phi_431_ = true;
        }
        let _e227 = phi_430_;
        let _e229 = phi_431_;
        if _e229 {
            phi_435_ = param_6;
        } else {
            phi_435_ = _e227;
        }
        let _e231 = phi_435_;
        phi_483_ = (param_6 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_6 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_461_ = 1f;
                } else {
                    phi_461_ = 0f;
                }
                let _e249 = phi_461_;
                if (_e234 < 8388608f) {
                    phi_466_ = (_e246 - _e249);
                    phi_467_ = false;
                } else {
                    phi_466_ = f32();
                    phi_467_ = true;
                }
                let _e252 = phi_466_;
                let _e254 = phi_467_;
                phi_468_ = _e252;
                phi_469_ = _e254;
            } else {
                phi_468_ = f32();
                phi_469_ = true;
            }
            let _e256 = phi_468_;
            let _e258 = phi_469_;
            if _e258 {
                phi_473_ = _e234;
            } else {
                phi_473_ = _e256;
            }
            let _e260 = phi_473_;
            let _e262 = (param_6 - (2f * _e260));
            if (_e262 > 1f) {
                phi_481_ = (2f - _e262);
            } else {
                phi_481_ = _e262;
            }
            let _e266 = phi_481_;
            phi_482_ = _e266;
        } else {
            phi_482_ = param_6;
        }
        let _e268 = phi_482_;
        phi_483_ = _e268;
    }
    let _e270 = phi_483_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_492_ = _e270;
        } else {
            phi_492_ = 1f;
        }
        let _e274 = phi_492_;
        phi_493_ = _e274;
    } else {
        phi_493_ = 0f;
    }
    let _e276 = phi_493_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_511_ = _e277;
        } else {
            phi_511_ = _e286;
        }
        let _e289 = phi_511_;
        phi_550_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_525_ = _e75;
        } else {
            phi_525_ = _e298;
        }
        let _e301 = phi_525_;
        if (_e204 == 0u) {
            phi_532_ = _e277;
        } else {
            phi_532_ = 0u;
        }
        let _e306 = phi_532_;
        if (_e204 == 0u) {
            phi_537_ = 0u;
        } else {
            phi_537_ = _e277;
        }
        let _e309 = phi_537_;
        if (_e301 == 0u) {
            phi_543_ = _e306;
        } else {
            phi_543_ = (_e301 - 1u);
        }
        let _e313 = phi_543_;
        if (_e301 > _e277) {
            phi_548_ = _e309;
        } else {
            phi_548_ = _e301;
        }
        let _e316 = phi_548_;
        phi_550_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_550_;
    let _e323 = (*param_4).offset;
    let _e330 = (*param_4).offset;
    let _e337 = (*param_4).offset;
    let _e344 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_696_: f32;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
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
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_779_: bool;
    var phi_783_: bool;
    var phi_853_: f32;
    var phi_860_: f32;
    var phi_867_: f32;
    var phi_874_: f32;
    var phi_881_: f32;
    var phi_888_: f32;
    var phi_905_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_936_: u32;
    var phi_941_: u32;
    var phi_946_: u32;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1092_: u32;
    var phi_1094_: u32;
    var phi_1097_: bool;
    var phi_1177_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1204_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1231_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1237_: u32;
    var phi_1240_: u32;
    var phi_1254_: u32;
    var phi_1264_: u32;
    var phi_1274_: u32;
    var phi_1292_: u32;
    var phi_1302_: u32;
    var phi_1312_: u32;
    var phi_1348_: u32;
    var phi_1361_: u32;
    var phi_1366_: u32;
    var phi_1367_: u32;
    var phi_1368_: u32;
    var phi_1238_: u32;
    var phi_1241_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1426_: u32;
    var phi_1429_: bool;
    var phi_1478_: f32;
    var phi_1483_: f32;
    var phi_1488_: f32;
    var phi_1496_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_1652_: bool;
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
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1677_: bool;
    var phi_1681_: bool;
    var phi_1751_: f32;
    var phi_1758_: f32;
    var phi_1765_: f32;
    var phi_1772_: f32;
    var phi_1779_: f32;
    var phi_1786_: f32;
    var phi_1803_: f32;
    var phi_1808_: f32;
    var phi_1813_: f32;
    var phi_1841_: bool;
    var phi_1842_: bool;
    var phi_1850_: u32;
    var phi_1851_: u32;
    var phi_1862_: vec3<f32>;
    var phi_1863_: vec3<f32>;
    var phi_1876_: u32;
    var phi_1881_: u32;
    var phi_1886_: u32;
    var phi_2000_: bool;
    var phi_2001_: bool;
    var phi_2032_: u32;
    var phi_2034_: u32;
    var phi_2037_: bool;
    var phi_2117_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2144_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2171_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2177_: u32;
    var phi_2180_: u32;
    var phi_2194_: u32;
    var phi_2204_: u32;
    var phi_2214_: u32;
    var phi_2232_: u32;
    var phi_2242_: u32;
    var phi_2252_: u32;
    var phi_2288_: u32;
    var phi_2301_: u32;
    var phi_2306_: u32;
    var phi_2307_: u32;
    var phi_2308_: u32;
    var phi_2178_: u32;
    var phi_2181_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2366_: u32;
    var phi_2369_: bool;
    var phi_2413_: vec3<f32>;
    var phi_2414_: vec3<f32>;
    var phi_2443_: vec3<f32>;
    var phi_2444_: vec3<f32>;
    var phi_2473_: vec3<f32>;
    var phi_2474_: vec3<f32>;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2497_: f32;
    var phi_2498_: f32;
    var phi_2499_: f32;
    var phi_2500_: f32;
    var phi_2508_: f32;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2523_: f32;
    var phi_2524_: f32;
    var phi_2525_: f32;
    var phi_2526_: f32;
    var phi_2534_: f32;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2549_: f32;
    var phi_2550_: f32;
    var phi_2551_: f32;
    var phi_2552_: f32;
    var phi_2560_: f32;
    var phi_2575_: f32;
    var phi_2576_: bool;
    var phi_2577_: f32;
    var phi_2578_: bool;
    var phi_2579_: f32;
    var phi_2580_: bool;
    var phi_2598_: f32;
    var phi_2599_: bool;
    var phi_2600_: bool;
    var phi_2601_: f32;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2607_: bool;
    var phi_2608_: f32;
    var phi_2609_: bool;
    var phi_2637_: vec3<f32>;
    var phi_2638_: vec3<f32>;
    var phi_2663_: vec3<f32>;
    var phi_2664_: vec3<f32>;
    var phi_2689_: vec3<f32>;
    var phi_2690_: vec3<f32>;
    var phi_2746_: f32;
    var phi_2755_: f32;
    var phi_2764_: f32;
    var phi_2773_: f32;
    var phi_2780_: f32;
    var phi_2787_: f32;
    var phi_2800_: f32;
    var phi_2809_: f32;
    var phi_2818_: f32;
    var phi_2827_: f32;
    var phi_2834_: f32;
    var phi_2841_: f32;
    var phi_2858_: f32;
    var phi_2863_: f32;
    var phi_2868_: f32;
    var phi_2876_: f32;
    var phi_2881_: f32;
    var phi_2886_: f32;
    var phi_2898_: f32;
    var phi_2903_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2918_: lt_bvh_triangle_Intersection;
    var phi_2919_: bool;
    var phi_2920_: lt_bvh_triangle_Intersection;
    var phi_2921_: bool;
    var phi_2925_: lt_bvh_triangle_Intersection;
    var phi_2926_: bool;
    var phi_2927_: lt_bvh_triangle_Intersection;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2933_: bool;
    var phi_2937_: lt_bvh_triangle_Intersection;
    var phi_3151_: f32;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3160_: bool;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3163_: bool;
    var phi_3164_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_2367_: u32;
    var phi_2370_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var local_9: bool;
    var phi_3216_: bool;
    var phi_3217_: bool;
    var phi_3248_: u32;
    var phi_3249_: u32;
    var phi_2035_: u32;
    var phi_2038_: bool;
    var phi_3250_: bool;
    var phi_3251_: bool;
    var phi_3252_: bool;
    var local_10: bool;
    var phi_3256_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3267_: bool;
    var phi_3271_: bool;
    var phi_3272_: bool;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_1427_: u32;
    var phi_1430_: bool;
    var phi_3281_: bool;
    var local_11: bool;
    var phi_3323_: bool;
    var phi_3324_: bool;
    var phi_3355_: u32;
    var phi_3356_: u32;
    var phi_1095_: u32;
    var phi_1098_: bool;
    var phi_3357_: bool;
    var phi_3358_: bool;
    var local_12: bool;
    var phi_3362_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3368_: bool;
    var phi_3372_: bool;
    var phi_3373_: bool;
    var phi_3377_: bool;
    var phi_3381_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

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
        let _e118 = samples.member[(0u + _e110)].position;
        let _e120 = samples.member[(0u + _e110)].normal;
        let _e122 = samples.member[(0u + _e110)].magnitude;
        let _e124 = ((8f / 8388608f) * _e122);
        let _e132 = (_e118.x + (_e120.x * _e124));
        let _e134 = (_e118.y + (_e120.y * _e124));
        let _e136 = (_e118.z + (_e120.z * _e124));
        let _e138 = p.member.light.place;
        if (_e138.w == 0f) {
            phi_696_ = 300000000000000000000000000000000000000f;
        } else {
            phi_696_ = 1f;
        }
        let _e142 = phi_696_;
        let _e150 = (_e138.x - (_e132 * _e138.w));
        let _e151 = (_e138.y - (_e134 * _e138.w));
        let _e152 = (_e138.z - (_e136 * _e138.w));
        let _e156 = abs(_e150);
        let _e157 = abs(_e151);
        let _e158 = abs(_e152);
        if (abs(_e132) < 1000000000000000f) {
            if (abs(_e134) < 1000000000000000f) {
                if (abs(_e136) < 1000000000000000f) {
                    if (_e156 < 1000000000000000f) {
                        if (_e157 < 1000000000000000f) {
                            if (_e158 < 1000000000000000f) {
                                if (_e156 > 0f) {
                                    phi_753_ = bool();
                                    phi_754_ = true;
                                } else {
                                    let _e166 = (_e157 > 0f);
                                    if _e166 {
                                        phi_752_ = bool();
                                    } else {
                                        phi_752_ = (_e158 > 0f);
                                    }
                                    let _e169 = phi_752_;
                                    phi_753_ = _e169;
                                    phi_754_ = _e166;
                                }
                                let _e171 = phi_753_;
                                let _e173 = phi_754_;
                                if _e173 {
                                    phi_758_ = true;
                                } else {
                                    phi_758_ = _e171;
                                }
                                let _e175 = phi_758_;
                                phi_759_ = _e175;
                                phi_760_ = false;
                            } else {
                                phi_759_ = bool();
                                phi_760_ = true;
                            }
                            let _e177 = phi_759_;
                            let _e179 = phi_760_;
                            phi_761_ = _e177;
                            phi_762_ = false;
                            phi_763_ = _e179;
                        } else {
                            phi_761_ = bool();
                            phi_762_ = true;
                            phi_763_ = false;
                        }
                        let _e181 = phi_761_;
                        let _e183 = phi_762_;
                        let _e185 = phi_763_;
                        phi_764_ = _e181;
                        phi_765_ = _e183;
                        phi_766_ = _e185;
                    } else {
                        phi_764_ = bool();
                        phi_765_ = true;
                        phi_766_ = false;
                    }
                    let _e187 = phi_764_;
                    let _e189 = phi_765_;
                    let _e191 = phi_766_;
                    phi_767_ = _e187;
                    phi_768_ = _e189;
                    phi_769_ = _e191;
                } else {
                    phi_767_ = bool();
                    phi_768_ = true;
                    phi_769_ = false;
                }
                let _e193 = phi_767_;
                let _e195 = phi_768_;
                let _e197 = phi_769_;
                phi_770_ = _e193;
                phi_771_ = _e195;
                phi_772_ = _e197;
            } else {
                phi_770_ = bool();
                phi_771_ = true;
                phi_772_ = false;
            }
            let _e199 = phi_770_;
            let _e201 = phi_771_;
            let _e203 = phi_772_;
            phi_773_ = _e199;
            phi_774_ = _e201;
            phi_775_ = _e203;
        } else {
            phi_773_ = bool();
            phi_774_ = true;
            phi_775_ = false;
        }
        let _e205 = phi_773_;
        let _e207 = phi_774_;
        let _e209 = phi_775_;
        if _e207 {
            phi_779_ = true;
        } else {
            phi_779_ = _e209;
        }
        let _e211 = phi_779_;
        if _e211 {
            phi_783_ = false;
        } else {
            phi_783_ = _e205;
        }
        let _e213 = phi_783_;
        if _e213 {
            let _e214 = (_e112 >= _e76);
            if _e214 {
                phi_3366_ = false;
            } else {
                if (_e112 < _e76) {
                } else {
                    return;
                }
                let _e220 = nodes.member[(0u + _e112)].frame[0u];
                let _e224 = nodes.member[(0u + _e112)].frame[1u];
                let _e228 = nodes.member[(0u + _e112)].frame[2u];
                let _e232 = nodes.member[(0u + _e112)].frame[0u];
                let _e236 = nodes.member[(0u + _e112)].frame[1u];
                let _e240 = nodes.member[(0u + _e112)].frame[2u];
                let _e244 = nodes.member[(0u + _e112)].frame[3u];
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150), abs(_e151));
                let _e279 = core_intrinsics_maximum_number_nsz_f32_(_e278, abs(_e152));
                let _e280 = (_e279 * 0.0000000000009094947f);
                if (abs(_e150) < _e280) {
                    phi_853_ = _e280;
                } else {
                    phi_853_ = abs(_e150);
                }
                let _e285 = phi_853_;
                if (_e150 < 0f) {
                    phi_860_ = (-1f / _e285);
                } else {
                    phi_860_ = (1f / _e285);
                }
                let _e290 = phi_860_;
                if (abs(_e151) < _e280) {
                    phi_867_ = _e280;
                } else {
                    phi_867_ = abs(_e151);
                }
                let _e295 = phi_867_;
                if (_e151 < 0f) {
                    phi_874_ = (-1f / _e295);
                } else {
                    phi_874_ = (1f / _e295);
                }
                let _e300 = phi_874_;
                if (abs(_e152) < _e280) {
                    phi_881_ = _e280;
                } else {
                    phi_881_ = abs(_e152);
                }
                let _e305 = phi_881_;
                if (_e152 < 0f) {
                    phi_888_ = (-1f / _e305);
                } else {
                    phi_888_ = (1f / _e305);
                }
                let _e310 = phi_888_;
                let _e314 = abs((bitcast<f32>(_e220) - _e132));
                let _e315 = abs((bitcast<f32>(_e224) - _e134));
                let _e316 = abs((bitcast<f32>(_e228) - _e136));
                let _e320 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e132));
                let _e321 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e134));
                let _e322 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e136));
                if (_e314 > _e320) {
                    phi_905_ = _e314;
                } else {
                    phi_905_ = _e320;
                }
                let _e325 = phi_905_;
                if (_e315 > _e321) {
                    phi_910_ = _e315;
                } else {
                    phi_910_ = _e321;
                }
                let _e328 = phi_910_;
                if (_e316 > _e322) {
                    phi_915_ = _e316;
                } else {
                    phi_915_ = _e322;
                }
                let _e331 = phi_915_;
                let _e332 = core_intrinsics_maximum_number_nsz_f32_(_e325, _e328);
                let _e333 = core_intrinsics_maximum_number_nsz_f32_(_e332, _e331);
                let _e337 = (_e333 * 0.0000019073486f);
                let _e338 = (abs(_e290) * _e337);
                let _e339 = (abs(_e300) * _e337);
                let _e340 = (abs(_e310) * _e337);
                let _e344 = (_e333 * 0.0000009536743f);
                let _e345 = (abs(_e290) * _e344);
                let _e346 = (abs(_e300) * _e344);
                let _e347 = (abs(_e310) * _e344);
                if (_e290 < 0f) {
                    phi_936_ = 0u;
                } else {
                    phi_936_ = 1u;
                }
                let _e350 = phi_936_;
                if (_e300 < 0f) {
                    phi_941_ = 0u;
                } else {
                    phi_941_ = 2u;
                }
                let _e353 = phi_941_;
                if (_e310 < 0f) {
                    phi_946_ = 0u;
                } else {
                    phi_946_ = 4u;
                }
                let _e356 = phi_946_;
                let _e358 = ((_e350 | _e353) | _e356);
                let _e359 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e359.first[0], _e359.first[1], _e359.first[2], _e359.first[3], _e359.first[4], _e359.first[5], _e359.first[6], _e359.first[7], _e359.first[8], _e359.first[9], _e359.first[10], _e359.first[11], _e359.first[12], _e359.first[13], _e359.first[14], _e359.first[15], _e359.first[16], _e359.first[17], _e359.first[18], _e359.first[19], _e359.first[20], _e359.first[21], _e359.first[22], _e359.first[23], _e359.first[24], _e359.first[25], _e359.first[26], _e359.first[27], _e359.first[28], _e359.first[29], _e359.first[30], _e359.first[31]), array<u32, 32>(_e359.mask[0], _e359.mask[1], _e359.mask[2], _e359.mask[3], _e359.mask[4], _e359.mask[5], _e359.mask[6], _e359.mask[7], _e359.mask[8], _e359.mask[9], _e359.mask[10], _e359.mask[11], _e359.mask[12], _e359.mask[13], _e359.mask[14], _e359.mask[15], _e359.mask[16], _e359.mask[17], _e359.mask[18], _e359.mask[19], _e359.mask[20], _e359.mask[21], _e359.mask[22], _e359.mask[23], _e359.mask[24], _e359.mask[25], _e359.mask[26], _e359.mask[27], _e359.mask[28], _e359.mask[29], _e359.mask[30], _e359.mask[31]), _e359.len, _e359.group, _e359.group_mask);
                let _e433 = local_2.group_mask;
                if ((_e433 & 4278190080u) == 0u) {
                    let _e437 = local_2.len;
                    if (_e437 == 0u) {
                        phi_1060_ = false;
                    } else {
                        let _e441 = local_2.len;
                        local_2.len = (_e441 - 1u);
                        let _e444 = local_2.len;
                        if (_e444 < 32u) {
                        } else {
                            return;
                        }
                        let _e449 = local_2.first[(0u + _e444)];
                        local_2.group = _e449;
                        let _e452 = local_2.len;
                        if (_e452 < 32u) {
                        } else {
                            return;
                        }
                        let _e457 = local_2.mask[(0u + _e452)];
                        local_2.group_mask = _e457;
                        phi_1060_ = true;
                    }
                    let _e460 = phi_1060_;
                    phi_1061_ = _e460;
                } else {
                    phi_1061_ = true;
                }
                let _e462 = phi_1061_;
                if _e462 {
                    let _e464 = local_2.group_mask;
                    let _e470 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e464)), 32u, (_e464 == 0u)));
                    let _e474 = local_2.group_mask;
                    let _e488 = local_2.group_mask;
                    local_2.group_mask = (_e488 & ~((1u << bitcast<u32>((_e470 & 31u)))));
                    let _e491 = local_2.group;
                    phi_1092_ = (_e491 + countOneBits(((_e474 & ~((4294967295u << bitcast<u32>((((_e470 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1092_ = 4294967295u;
                }
                let _e494 = phi_1092_;
                phi_1094_ = _e494;
                phi_1097_ = false;
                loop {
                    let _e496 = phi_1094_;
                    let _e498 = phi_1097_;
                    if (_e496 != 4294967295u) {
                        if (_e496 < _e76) {
                        } else {
                            return;
                        }
                        let _e505 = nodes.member[(0u + _e496)].frame[3u];
                        let _e530 = (bitcast<f32>((((_e505 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                        let _e531 = (bitcast<f32>((((_e505 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e300);
                        let _e532 = (bitcast<f32>((((_e505 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e535 = nodes.member[(0u + _e496)].frame[0u];
                        let _e539 = nodes.member[(0u + _e496)].frame[1u];
                        let _e543 = nodes.member[(0u + _e496)].frame[2u];
                        let _e548 = ((bitcast<f32>(_e535) - _e132) * _e290);
                        let _e549 = ((bitcast<f32>(_e539) - _e134) * _e300);
                        let _e550 = ((bitcast<f32>(_e543) - _e136) * _e310);
                        let _e558 = nodes.member[(0u + _e496)].x;
                        if (_e290 < 0f) {
                            let _e569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e558.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e569.unnamed.word, _e558.w), _e569.unnamed_1);
                            let _e581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e575.unnamed, lt_mask_LightPlace(_e558.x, _e575.unnamed_1.shift));
                            phi_1177_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_mask_LightPlace(_e581.unnamed_1.word, _e558.y));
                        } else {
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e558.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e597.unnamed.word, _e558.y), _e597.unnamed_1);
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_mask_LightPlace(_e558.z, _e603.unnamed_1.shift));
                            phi_1177_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_mask_LightPlace(_e609.unnamed_1.word, _e558.w));
                        }
                        let _e617 = phi_1177_;
                        let _e627 = nodes.member[(0u + _e496)].y;
                        if (_e300 < 0f) {
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e627.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e638.unnamed.word, _e627.w), _e638.unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_mask_LightPlace(_e627.x, _e644.unnamed_1.shift));
                            phi_1204_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_mask_LightPlace(_e650.unnamed_1.word, _e627.y));
                        } else {
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e627.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e666.unnamed.word, _e627.y), _e666.unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_mask_LightPlace(_e627.z, _e672.unnamed_1.shift));
                            phi_1204_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_mask_LightPlace(_e678.unnamed_1.word, _e627.w));
                        }
                        let _e686 = phi_1204_;
                        let _e696 = nodes.member[(0u + _e496)].z;
                        if (_e310 < 0f) {
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e696.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e707.unnamed.word, _e696.w), _e707.unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_mask_LightPlace(_e696.x, _e713.unnamed_1.shift));
                            phi_1231_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_mask_LightPlace(_e719.unnamed_1.word, _e696.y));
                        } else {
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e696.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e735.unnamed.word, _e696.y), _e735.unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_mask_LightPlace(_e696.z, _e741.unnamed_1.shift));
                            phi_1231_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_mask_LightPlace(_e747.unnamed_1.word, _e696.w));
                        }
                        let _e755 = phi_1231_;
                        phi_1237_ = 0u;
                        phi_1240_ = 0u;
                        loop {
                            let _e765 = phi_1237_;
                            let _e767 = phi_1240_;
                            local_3 = _e767;
                            local_4 = _e767;
                            local_5 = _e767;
                            let _e768 = (_e765 < 8u);
                            if _e768 {
                                let _e770 = (_e765 >> bitcast<u32>(2i));
                                let _e771 = (_e765 & 3u);
                                if (_e770 == 0u) {
                                    phi_1254_ = _e617.unnamed.word;
                                } else {
                                    phi_1254_ = _e617.unnamed.shift;
                                }
                                let _e774 = phi_1254_;
                                if (_e770 == 0u) {
                                    phi_1264_ = _e686.unnamed.word;
                                } else {
                                    phi_1264_ = _e686.unnamed.shift;
                                }
                                let _e783 = phi_1264_;
                                if (_e770 == 0u) {
                                    phi_1274_ = _e755.unnamed.word;
                                } else {
                                    phi_1274_ = _e755.unnamed.shift;
                                }
                                let _e792 = phi_1274_;
                                let _e805 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e774 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e530) + (_e548 - _e338)), ((f32(((_e783 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e339)));
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(_e805, ((f32(((_e792 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e340)));
                                if (_e770 == 0u) {
                                    phi_1292_ = _e617.unnamed_1.word;
                                } else {
                                    phi_1292_ = _e617.unnamed_1.shift;
                                }
                                let _e809 = phi_1292_;
                                if (_e770 == 0u) {
                                    phi_1302_ = _e686.unnamed_1.word;
                                } else {
                                    phi_1302_ = _e686.unnamed_1.shift;
                                }
                                let _e818 = phi_1302_;
                                if (_e770 == 0u) {
                                    phi_1312_ = _e755.unnamed_1.word;
                                } else {
                                    phi_1312_ = _e755.unnamed_1.shift;
                                }
                                let _e827 = phi_1312_;
                                let _e840 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e809 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e530) + (_e548 + _e338)), ((f32(((_e818 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e339)));
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(_e840, ((f32(((_e827 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e340)));
                                if (_e806 <= _e841) {
                                    if (_e806 <= _e142) {
                                        if (_e841 >= 0f) {
                                            if (_e770 == 0u) {
                                                let _e848 = nodes.member[(0u + _e496)].links[2u];
                                                phi_1348_ = _e848;
                                            } else {
                                                let _e851 = nodes.member[(0u + _e496)].links[3u];
                                                phi_1348_ = _e851;
                                            }
                                            let _e853 = phi_1348_;
                                            let _e858 = ((_e853 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u);
                                            let _e859 = (_e858 & 31u);
                                            if (_e859 >= 24u) {
                                                phi_1361_ = (24u + ((_e859 - 24u) ^ _e358));
                                            } else {
                                                phi_1361_ = _e859;
                                            }
                                            let _e865 = phi_1361_;
                                            phi_1366_ = (_e767 | ((_e858 >> bitcast<u32>(5i)) << bitcast<u32>((_e865 & 31u))));
                                        } else {
                                            phi_1366_ = _e767;
                                        }
                                        let _e873 = phi_1366_;
                                        phi_1367_ = _e873;
                                    } else {
                                        phi_1367_ = _e767;
                                    }
                                    let _e875 = phi_1367_;
                                    phi_1368_ = _e875;
                                } else {
                                    phi_1368_ = _e767;
                                }
                                let _e877 = phi_1368_;
                                phi_1238_ = (_e765 + 1u);
                                phi_1241_ = _e877;
                            } else {
                                phi_1238_ = u32();
                                phi_1241_ = u32();
                            }
                            let _e880 = phi_1238_;
                            let _e882 = phi_1241_;
                            continue;
                            continuing {
                                phi_1237_ = _e880;
                                phi_1240_ = _e882;
                                break if !(_e768);
                            }
                        }
                        let _e886 = nodes.member[(0u + _e496)].links[0u];
                        let _e890 = nodes.member[(0u + _e496)].frame[3u];
                        let _e894 = local_3;
                        if ((_e894 & 4278190080u) == 0u) {
                        } else {
                            let _e898 = local_2.group_mask;
                            if ((_e898 & 4278190080u) == 0u) {
                            } else {
                                let _e902 = local_2.len;
                                if (_e902 < 32u) {
                                    let _e905 = local_2.group;
                                    let _e907 = local_2.len;
                                    if (_e907 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e907)] = _e905;
                                    let _e913 = local_2.group_mask;
                                    let _e915 = local_2.len;
                                    if (_e915 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e915)] = _e913;
                                    let _e922 = local_2.len;
                                    local_2.len = (_e922 + 1u);
                                }
                            }
                            local_2.group = (_e112 + _e886);
                            let _e926 = local_4;
                            local_2.group_mask = ((_e926 & 4278190080u) | (_e890 >> bitcast<u32>(24i)));
                        }
                        let _e931 = local_5;
                        phi_1426_ = (_e931 & 16777215u);
                        phi_1429_ = _e498;
                        loop {
                            let _e934 = phi_1426_;
                            let _e936 = phi_1429_;
                            local_18 = _e936;
                            let _e937 = (_e934 == 0u);
                            local_11 = _e937;
                            local_19 = _e937;
                            if _e937 {
                                phi_1427_ = u32();
                                phi_1430_ = bool();
                                phi_3281_ = false;
                            } else {
                                let _e940 = nodes.member[(0u + _e496)].links[1u];
                                let _e944 = (_e940 + select(firstTrailingBit(_e934), 32u, (_e934 == 0u)));
                                if (_e944 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e951 = instances.member[(0u + _e944)].low_world;
                                let _e953 = instances.member[(0u + _e944)].high_world;
                                let _e960 = ((_e951.x - _e132) * _e290);
                                let _e961 = ((_e951.y - _e134) * _e300);
                                let _e962 = ((_e951.z - _e136) * _e310);
                                let _e969 = ((_e953.x - _e132) * _e290);
                                let _e970 = ((_e953.y - _e134) * _e300);
                                let _e971 = ((_e953.z - _e136) * _e310);
                                if (_e960 < _e969) {
                                    phi_1478_ = _e960;
                                } else {
                                    phi_1478_ = _e969;
                                }
                                let _e974 = phi_1478_;
                                if (_e961 < _e970) {
                                    phi_1483_ = _e961;
                                } else {
                                    phi_1483_ = _e970;
                                }
                                let _e977 = phi_1483_;
                                if (_e962 < _e971) {
                                    phi_1488_ = _e962;
                                } else {
                                    phi_1488_ = _e971;
                                }
                                let _e980 = phi_1488_;
                                if (_e960 > _e969) {
                                    phi_1496_ = _e960;
                                } else {
                                    phi_1496_ = _e969;
                                }
                                let _e986 = phi_1496_;
                                if (_e961 > _e970) {
                                    phi_1501_ = _e961;
                                } else {
                                    phi_1501_ = _e970;
                                }
                                let _e989 = phi_1501_;
                                if (_e962 > _e971) {
                                    phi_1506_ = _e962;
                                } else {
                                    phi_1506_ = _e971;
                                }
                                let _e992 = phi_1506_;
                                let _e996 = core_intrinsics_maximum_number_nsz_f32_((_e974 - _e345), (_e977 - _e346));
                                let _e997 = core_intrinsics_maximum_number_nsz_f32_(_e996, (_e980 - _e347));
                                let _e998 = core_intrinsics_minimum_number_nsz_f32_((_e986 + _e345), (_e989 + _e346));
                                let _e999 = core_intrinsics_minimum_number_nsz_f32_(_e998, (_e992 + _e347));
                                if (_e997 <= _e999) {
                                    if (_e997 <= _e142) {
                                        if (_e999 >= 0f) {
                                            let _e1005 = instances.member[(0u + _e944)].world_to_object[0u];
                                            let _e1016 = ((((_e1005.x * _e132) + (_e1005.y * _e134)) + (_e1005.z * _e136)) + (_e1005.w * 1f));
                                            let _e1018 = instances.member[(0u + _e944)].world_to_object[1u];
                                            let _e1029 = ((((_e1018.x * _e132) + (_e1018.y * _e134)) + (_e1018.z * _e136)) + (_e1018.w * 1f));
                                            let _e1031 = instances.member[(0u + _e944)].world_to_object[2u];
                                            let _e1042 = ((((_e1031.x * _e132) + (_e1031.y * _e134)) + (_e1031.z * _e136)) + (_e1031.w * 1f));
                                            let _e1045 = instances.member[(0u + _e944)].world_to_object[0u];
                                            let _e1056 = ((((_e1045.x * _e150) + (_e1045.y * _e151)) + (_e1045.z * _e152)) + (_e1045.w * 0f));
                                            let _e1058 = instances.member[(0u + _e944)].world_to_object[1u];
                                            let _e1069 = ((((_e1058.x * _e150) + (_e1058.y * _e151)) + (_e1058.z * _e152)) + (_e1058.w * 0f));
                                            let _e1071 = instances.member[(0u + _e944)].world_to_object[2u];
                                            let _e1082 = ((((_e1071.x * _e150) + (_e1071.y * _e151)) + (_e1071.z * _e152)) + (_e1071.w * 0f));
                                            let _e1085 = instances.member[(0u + _e944)].root;
                                            let _e1087 = instances.member[(0u + _e944)].first_triangle;
                                            let _e1091 = abs(_e1056);
                                            let _e1092 = abs(_e1069);
                                            let _e1093 = abs(_e1082);
                                            if (abs(_e1016) < 1000000000000000f) {
                                                if (abs(_e1029) < 1000000000000000f) {
                                                    if (abs(_e1042) < 1000000000000000f) {
                                                        if (_e1091 < 1000000000000000f) {
                                                            if (_e1092 < 1000000000000000f) {
                                                                if (_e1093 < 1000000000000000f) {
                                                                    if (_e1091 > 0f) {
                                                                        phi_1651_ = bool();
                                                                        phi_1652_ = true;
                                                                    } else {
                                                                        let _e1101 = (_e1092 > 0f);
                                                                        if _e1101 {
                                                                            phi_1650_ = bool();
                                                                        } else {
                                                                            phi_1650_ = (_e1093 > 0f);
                                                                        }
                                                                        let _e1104 = phi_1650_;
                                                                        phi_1651_ = _e1104;
                                                                        phi_1652_ = _e1101;
                                                                    }
                                                                    let _e1106 = phi_1651_;
                                                                    let _e1108 = phi_1652_;
                                                                    if _e1108 {
                                                                        phi_1656_ = true;
                                                                    } else {
                                                                        phi_1656_ = _e1106;
                                                                    }
                                                                    let _e1110 = phi_1656_;
                                                                    phi_1657_ = _e1110;
                                                                    phi_1658_ = false;
                                                                } else {
                                                                    phi_1657_ = bool();
                                                                    phi_1658_ = true;
                                                                }
                                                                let _e1112 = phi_1657_;
                                                                let _e1114 = phi_1658_;
                                                                phi_1659_ = _e1112;
                                                                phi_1660_ = false;
                                                                phi_1661_ = _e1114;
                                                            } else {
                                                                phi_1659_ = bool();
                                                                phi_1660_ = true;
                                                                phi_1661_ = false;
                                                            }
                                                            let _e1116 = phi_1659_;
                                                            let _e1118 = phi_1660_;
                                                            let _e1120 = phi_1661_;
                                                            phi_1662_ = _e1116;
                                                            phi_1663_ = _e1118;
                                                            phi_1664_ = _e1120;
                                                        } else {
                                                            phi_1662_ = bool();
                                                            phi_1663_ = true;
                                                            phi_1664_ = false;
                                                        }
                                                        let _e1122 = phi_1662_;
                                                        let _e1124 = phi_1663_;
                                                        let _e1126 = phi_1664_;
                                                        phi_1665_ = _e1122;
                                                        phi_1666_ = _e1124;
                                                        phi_1667_ = _e1126;
                                                    } else {
                                                        phi_1665_ = bool();
                                                        phi_1666_ = true;
                                                        phi_1667_ = false;
                                                    }
                                                    let _e1128 = phi_1665_;
                                                    let _e1130 = phi_1666_;
                                                    let _e1132 = phi_1667_;
                                                    phi_1668_ = _e1128;
                                                    phi_1669_ = _e1130;
                                                    phi_1670_ = _e1132;
                                                } else {
                                                    phi_1668_ = bool();
                                                    phi_1669_ = true;
                                                    phi_1670_ = false;
                                                }
                                                let _e1134 = phi_1668_;
                                                let _e1136 = phi_1669_;
                                                let _e1138 = phi_1670_;
                                                phi_1671_ = _e1134;
                                                phi_1672_ = _e1136;
                                                phi_1673_ = _e1138;
                                            } else {
                                                phi_1671_ = bool();
                                                phi_1672_ = true;
                                                phi_1673_ = false;
                                            }
                                            let _e1140 = phi_1671_;
                                            let _e1142 = phi_1672_;
                                            let _e1144 = phi_1673_;
                                            if _e1142 {
                                                phi_1677_ = true;
                                            } else {
                                                phi_1677_ = _e1144;
                                            }
                                            let _e1146 = phi_1677_;
                                            if _e1146 {
                                                phi_1681_ = false;
                                            } else {
                                                phi_1681_ = _e1140;
                                            }
                                            let _e1148 = phi_1681_;
                                            if _e1148 {
                                                let _e1149 = (_e1085 >= _e76);
                                                if _e1149 {
                                                    phi_3261_ = bool();
                                                } else {
                                                    if (_e1085 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1155 = nodes.member[(0u + _e1085)].frame[0u];
                                                    let _e1159 = nodes.member[(0u + _e1085)].frame[1u];
                                                    let _e1163 = nodes.member[(0u + _e1085)].frame[2u];
                                                    let _e1167 = nodes.member[(0u + _e1085)].frame[0u];
                                                    let _e1171 = nodes.member[(0u + _e1085)].frame[1u];
                                                    let _e1175 = nodes.member[(0u + _e1085)].frame[2u];
                                                    let _e1179 = nodes.member[(0u + _e1085)].frame[3u];
                                                    let _e1213 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1056), abs(_e1069));
                                                    let _e1214 = core_intrinsics_maximum_number_nsz_f32_(_e1213, abs(_e1082));
                                                    let _e1215 = (_e1214 * 0.0000000000009094947f);
                                                    if (abs(_e1056) < _e1215) {
                                                        phi_1751_ = _e1215;
                                                    } else {
                                                        phi_1751_ = abs(_e1056);
                                                    }
                                                    let _e1220 = phi_1751_;
                                                    if (_e1056 < 0f) {
                                                        phi_1758_ = (-1f / _e1220);
                                                    } else {
                                                        phi_1758_ = (1f / _e1220);
                                                    }
                                                    let _e1225 = phi_1758_;
                                                    if (abs(_e1069) < _e1215) {
                                                        phi_1765_ = _e1215;
                                                    } else {
                                                        phi_1765_ = abs(_e1069);
                                                    }
                                                    let _e1230 = phi_1765_;
                                                    if (_e1069 < 0f) {
                                                        phi_1772_ = (-1f / _e1230);
                                                    } else {
                                                        phi_1772_ = (1f / _e1230);
                                                    }
                                                    let _e1235 = phi_1772_;
                                                    if (abs(_e1082) < _e1215) {
                                                        phi_1779_ = _e1215;
                                                    } else {
                                                        phi_1779_ = abs(_e1082);
                                                    }
                                                    let _e1240 = phi_1779_;
                                                    if (_e1082 < 0f) {
                                                        phi_1786_ = (-1f / _e1240);
                                                    } else {
                                                        phi_1786_ = (1f / _e1240);
                                                    }
                                                    let _e1245 = phi_1786_;
                                                    let _e1249 = abs((bitcast<f32>(_e1155) - _e1016));
                                                    let _e1250 = abs((bitcast<f32>(_e1159) - _e1029));
                                                    let _e1251 = abs((bitcast<f32>(_e1163) - _e1042));
                                                    let _e1255 = abs(((bitcast<f32>(_e1167) + (bitcast<f32>((((_e1179 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1016));
                                                    let _e1256 = abs(((bitcast<f32>(_e1171) + (bitcast<f32>((((_e1179 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1029));
                                                    let _e1257 = abs(((bitcast<f32>(_e1175) + (bitcast<f32>((((_e1179 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1042));
                                                    if (_e1249 > _e1255) {
                                                        phi_1803_ = _e1249;
                                                    } else {
                                                        phi_1803_ = _e1255;
                                                    }
                                                    let _e1260 = phi_1803_;
                                                    if (_e1250 > _e1256) {
                                                        phi_1808_ = _e1250;
                                                    } else {
                                                        phi_1808_ = _e1256;
                                                    }
                                                    let _e1263 = phi_1808_;
                                                    if (_e1251 > _e1257) {
                                                        phi_1813_ = _e1251;
                                                    } else {
                                                        phi_1813_ = _e1257;
                                                    }
                                                    let _e1266 = phi_1813_;
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1260, _e1263);
                                                    let _e1268 = core_intrinsics_maximum_number_nsz_f32_(_e1267, _e1266);
                                                    let _e1272 = (_e1268 * 0.0000019073486f);
                                                    let _e1273 = (abs(_e1225) * _e1272);
                                                    let _e1274 = (abs(_e1235) * _e1272);
                                                    let _e1275 = (abs(_e1245) * _e1272);
                                                    let _e1279 = (_e1268 * 0.0000009536743f);
                                                    let _e1280 = (abs(_e1225) * _e1279);
                                                    let _e1281 = (abs(_e1235) * _e1279);
                                                    let _e1282 = (abs(_e1245) * _e1279);
                                                    let _e1283 = abs(_e1056);
                                                    let _e1284 = abs(_e1069);
                                                    let _e1285 = abs(_e1082);
                                                    if (_e1283 >= _e1284) {
                                                        if (_e1283 >= _e1285) {
                                                            phi_1841_ = false;
                                                        } else {
                                                            phi_1841_ = true;
                                                        }
                                                        let _e1289 = phi_1841_;
                                                        phi_1842_ = _e1289;
                                                    } else {
                                                        phi_1842_ = true;
                                                    }
                                                    let _e1291 = phi_1842_;
                                                    if _e1291 {
                                                        if (_e1284 >= _e1285) {
                                                            phi_1850_ = 1u;
                                                        } else {
                                                            phi_1850_ = 2u;
                                                        }
                                                        let _e1294 = phi_1850_;
                                                        phi_1851_ = _e1294;
                                                    } else {
                                                        phi_1851_ = 0u;
                                                    }
                                                    let _e1296 = phi_1851_;
                                                    if (_e1296 == 0u) {
                                                        phi_1863_ = vec3<f32>(_e1069, _e1082, _e1056);
                                                    } else {
                                                        if (_e1296 == 1u) {
                                                            phi_1862_ = vec3<f32>(_e1082, _e1056, _e1069);
                                                        } else {
                                                            phi_1862_ = vec3<f32>(_e1056, _e1069, _e1082);
                                                        }
                                                        let _e1302 = phi_1862_;
                                                        phi_1863_ = _e1302;
                                                    }
                                                    let _e1304 = phi_1863_;
                                                    let _e1307 = (_e1304.x / _e1304.z);
                                                    let _e1310 = (_e1304.y / _e1304.z);
                                                    if (_e1225 < 0f) {
                                                        phi_1876_ = 0u;
                                                    } else {
                                                        phi_1876_ = 1u;
                                                    }
                                                    let _e1315 = phi_1876_;
                                                    if (_e1235 < 0f) {
                                                        phi_1881_ = 0u;
                                                    } else {
                                                        phi_1881_ = 2u;
                                                    }
                                                    let _e1318 = phi_1881_;
                                                    if (_e1245 < 0f) {
                                                        phi_1886_ = 0u;
                                                    } else {
                                                        phi_1886_ = 4u;
                                                    }
                                                    let _e1321 = phi_1886_;
                                                    let _e1323 = ((_e1315 | _e1318) | _e1321);
                                                    let _e1324 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1085, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1324.first[0], _e1324.first[1], _e1324.first[2], _e1324.first[3], _e1324.first[4], _e1324.first[5], _e1324.first[6], _e1324.first[7], _e1324.first[8], _e1324.first[9], _e1324.first[10], _e1324.first[11], _e1324.first[12], _e1324.first[13], _e1324.first[14], _e1324.first[15], _e1324.first[16], _e1324.first[17], _e1324.first[18], _e1324.first[19], _e1324.first[20], _e1324.first[21], _e1324.first[22], _e1324.first[23], _e1324.first[24], _e1324.first[25], _e1324.first[26], _e1324.first[27], _e1324.first[28], _e1324.first[29], _e1324.first[30], _e1324.first[31]), array<u32, 32>(_e1324.mask[0], _e1324.mask[1], _e1324.mask[2], _e1324.mask[3], _e1324.mask[4], _e1324.mask[5], _e1324.mask[6], _e1324.mask[7], _e1324.mask[8], _e1324.mask[9], _e1324.mask[10], _e1324.mask[11], _e1324.mask[12], _e1324.mask[13], _e1324.mask[14], _e1324.mask[15], _e1324.mask[16], _e1324.mask[17], _e1324.mask[18], _e1324.mask[19], _e1324.mask[20], _e1324.mask[21], _e1324.mask[22], _e1324.mask[23], _e1324.mask[24], _e1324.mask[25], _e1324.mask[26], _e1324.mask[27], _e1324.mask[28], _e1324.mask[29], _e1324.mask[30], _e1324.mask[31]), _e1324.len, _e1324.group, _e1324.group_mask);
                                                    let _e1398 = local_1.group_mask;
                                                    if ((_e1398 & 4278190080u) == 0u) {
                                                        let _e1402 = local_1.len;
                                                        if (_e1402 == 0u) {
                                                            phi_2000_ = false;
                                                        } else {
                                                            let _e1406 = local_1.len;
                                                            local_1.len = (_e1406 - 1u);
                                                            let _e1409 = local_1.len;
                                                            if (_e1409 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1414 = local_1.first[(0u + _e1409)];
                                                            local_1.group = _e1414;
                                                            let _e1417 = local_1.len;
                                                            if (_e1417 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1422 = local_1.mask[(0u + _e1417)];
                                                            local_1.group_mask = _e1422;
                                                            phi_2000_ = true;
                                                        }
                                                        let _e1425 = phi_2000_;
                                                        phi_2001_ = _e1425;
                                                    } else {
                                                        phi_2001_ = true;
                                                    }
                                                    let _e1427 = phi_2001_;
                                                    if _e1427 {
                                                        let _e1429 = local_1.group_mask;
                                                        let _e1435 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1429)), 32u, (_e1429 == 0u)));
                                                        let _e1439 = local_1.group_mask;
                                                        let _e1453 = local_1.group_mask;
                                                        local_1.group_mask = (_e1453 & ~((1u << bitcast<u32>((_e1435 & 31u)))));
                                                        let _e1456 = local_1.group;
                                                        phi_2032_ = (_e1456 + countOneBits(((_e1439 & ~((4294967295u << bitcast<u32>((((_e1435 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2032_ = 4294967295u;
                                                    }
                                                    let _e1459 = phi_2032_;
                                                    phi_2034_ = _e1459;
                                                    phi_2037_ = _e936;
                                                    loop {
                                                        let _e1461 = phi_2034_;
                                                        let _e1463 = phi_2037_;
                                                        local_17 = _e1463;
                                                        if (_e1461 != 4294967295u) {
                                                            if (_e1461 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1470 = nodes.member[(0u + _e1461)].frame[3u];
                                                            let _e1495 = (bitcast<f32>((((_e1470 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1225);
                                                            let _e1496 = (bitcast<f32>((((_e1470 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1235);
                                                            let _e1497 = (bitcast<f32>((((_e1470 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1245);
                                                            let _e1500 = nodes.member[(0u + _e1461)].frame[0u];
                                                            let _e1504 = nodes.member[(0u + _e1461)].frame[1u];
                                                            let _e1508 = nodes.member[(0u + _e1461)].frame[2u];
                                                            let _e1513 = ((bitcast<f32>(_e1500) - _e1016) * _e1225);
                                                            let _e1514 = ((bitcast<f32>(_e1504) - _e1029) * _e1235);
                                                            let _e1515 = ((bitcast<f32>(_e1508) - _e1042) * _e1245);
                                                            let _e1523 = nodes.member[(0u + _e1461)].x;
                                                            if (_e1225 < 0f) {
                                                                let _e1534 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1523.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1540 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1534.unnamed.word, _e1523.w), _e1534.unnamed_1);
                                                                let _e1546 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1540.unnamed, lt_mask_LightPlace(_e1523.x, _e1540.unnamed_1.shift));
                                                                phi_2117_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1546.unnamed, lt_mask_LightPlace(_e1546.unnamed_1.word, _e1523.y));
                                                            } else {
                                                                let _e1562 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1523.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1568 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1562.unnamed.word, _e1523.y), _e1562.unnamed_1);
                                                                let _e1574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1568.unnamed, lt_mask_LightPlace(_e1523.z, _e1568.unnamed_1.shift));
                                                                phi_2117_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1574.unnamed, lt_mask_LightPlace(_e1574.unnamed_1.word, _e1523.w));
                                                            }
                                                            let _e1582 = phi_2117_;
                                                            let _e1592 = nodes.member[(0u + _e1461)].y;
                                                            if (_e1235 < 0f) {
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1592.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1603.unnamed.word, _e1592.w), _e1603.unnamed_1);
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1592.x, _e1609.unnamed_1.shift));
                                                                phi_2144_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1615.unnamed, lt_mask_LightPlace(_e1615.unnamed_1.word, _e1592.y));
                                                            } else {
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1592.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1631.unnamed.word, _e1592.y), _e1631.unnamed_1);
                                                                let _e1643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_mask_LightPlace(_e1592.z, _e1637.unnamed_1.shift));
                                                                phi_2144_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1643.unnamed, lt_mask_LightPlace(_e1643.unnamed_1.word, _e1592.w));
                                                            }
                                                            let _e1651 = phi_2144_;
                                                            let _e1661 = nodes.member[(0u + _e1461)].z;
                                                            if (_e1245 < 0f) {
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1661.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1672.unnamed.word, _e1661.w), _e1672.unnamed_1);
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1661.x, _e1678.unnamed_1.shift));
                                                                phi_2171_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1684.unnamed, lt_mask_LightPlace(_e1684.unnamed_1.word, _e1661.y));
                                                            } else {
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1661.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1700.unnamed.word, _e1661.y), _e1700.unnamed_1);
                                                                let _e1712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_mask_LightPlace(_e1661.z, _e1706.unnamed_1.shift));
                                                                phi_2171_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1712.unnamed, lt_mask_LightPlace(_e1712.unnamed_1.word, _e1661.w));
                                                            }
                                                            let _e1720 = phi_2171_;
                                                            phi_2177_ = 0u;
                                                            phi_2180_ = 0u;
                                                            loop {
                                                                let _e1730 = phi_2177_;
                                                                let _e1732 = phi_2180_;
                                                                local_6 = _e1732;
                                                                local_7 = _e1732;
                                                                local_8 = _e1732;
                                                                let _e1733 = (_e1730 < 8u);
                                                                if _e1733 {
                                                                    let _e1735 = (_e1730 >> bitcast<u32>(2i));
                                                                    let _e1736 = (_e1730 & 3u);
                                                                    if (_e1735 == 0u) {
                                                                        phi_2194_ = _e1582.unnamed.word;
                                                                    } else {
                                                                        phi_2194_ = _e1582.unnamed.shift;
                                                                    }
                                                                    let _e1739 = phi_2194_;
                                                                    if (_e1735 == 0u) {
                                                                        phi_2204_ = _e1651.unnamed.word;
                                                                    } else {
                                                                        phi_2204_ = _e1651.unnamed.shift;
                                                                    }
                                                                    let _e1748 = phi_2204_;
                                                                    if (_e1735 == 0u) {
                                                                        phi_2214_ = _e1720.unnamed.word;
                                                                    } else {
                                                                        phi_2214_ = _e1720.unnamed.shift;
                                                                    }
                                                                    let _e1757 = phi_2214_;
                                                                    let _e1770 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1739 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 - _e1273)), ((f32(((_e1748 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u)) * _e1496) + (_e1514 - _e1274)));
                                                                    let _e1771 = core_intrinsics_maximum_number_nsz_f32_(_e1770, ((f32(((_e1757 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u)) * _e1497) + (_e1515 - _e1275)));
                                                                    if (_e1735 == 0u) {
                                                                        phi_2232_ = _e1582.unnamed_1.word;
                                                                    } else {
                                                                        phi_2232_ = _e1582.unnamed_1.shift;
                                                                    }
                                                                    let _e1774 = phi_2232_;
                                                                    if (_e1735 == 0u) {
                                                                        phi_2242_ = _e1651.unnamed_1.word;
                                                                    } else {
                                                                        phi_2242_ = _e1651.unnamed_1.shift;
                                                                    }
                                                                    let _e1783 = phi_2242_;
                                                                    if (_e1735 == 0u) {
                                                                        phi_2252_ = _e1720.unnamed_1.word;
                                                                    } else {
                                                                        phi_2252_ = _e1720.unnamed_1.shift;
                                                                    }
                                                                    let _e1792 = phi_2252_;
                                                                    let _e1805 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1774 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 + _e1273)), ((f32(((_e1783 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u)) * _e1496) + (_e1514 + _e1274)));
                                                                    let _e1806 = core_intrinsics_minimum_number_nsz_f32_(_e1805, ((f32(((_e1792 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u)) * _e1497) + (_e1515 + _e1275)));
                                                                    if (_e1771 <= _e1806) {
                                                                        if (_e1771 <= _e142) {
                                                                            if (_e1806 >= 0f) {
                                                                                if (_e1735 == 0u) {
                                                                                    let _e1813 = nodes.member[(0u + _e1461)].links[2u];
                                                                                    phi_2288_ = _e1813;
                                                                                } else {
                                                                                    let _e1816 = nodes.member[(0u + _e1461)].links[3u];
                                                                                    phi_2288_ = _e1816;
                                                                                }
                                                                                let _e1818 = phi_2288_;
                                                                                let _e1823 = ((_e1818 >> bitcast<u32>(((_e1736 * 8u) & 31u))) & 255u);
                                                                                let _e1824 = (_e1823 & 31u);
                                                                                if (_e1824 >= 24u) {
                                                                                    phi_2301_ = (24u + ((_e1824 - 24u) ^ _e1323));
                                                                                } else {
                                                                                    phi_2301_ = _e1824;
                                                                                }
                                                                                let _e1830 = phi_2301_;
                                                                                phi_2306_ = (_e1732 | ((_e1823 >> bitcast<u32>(5i)) << bitcast<u32>((_e1830 & 31u))));
                                                                            } else {
                                                                                phi_2306_ = _e1732;
                                                                            }
                                                                            let _e1838 = phi_2306_;
                                                                            phi_2307_ = _e1838;
                                                                        } else {
                                                                            phi_2307_ = _e1732;
                                                                        }
                                                                        let _e1840 = phi_2307_;
                                                                        phi_2308_ = _e1840;
                                                                    } else {
                                                                        phi_2308_ = _e1732;
                                                                    }
                                                                    let _e1842 = phi_2308_;
                                                                    phi_2178_ = (_e1730 + 1u);
                                                                    phi_2181_ = _e1842;
                                                                } else {
                                                                    phi_2178_ = u32();
                                                                    phi_2181_ = u32();
                                                                }
                                                                let _e1845 = phi_2178_;
                                                                let _e1847 = phi_2181_;
                                                                continue;
                                                                continuing {
                                                                    phi_2177_ = _e1845;
                                                                    phi_2180_ = _e1847;
                                                                    break if !(_e1733);
                                                                }
                                                            }
                                                            let _e1851 = nodes.member[(0u + _e1461)].links[0u];
                                                            let _e1855 = nodes.member[(0u + _e1461)].frame[3u];
                                                            let _e1859 = local_6;
                                                            if ((_e1859 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1863 = local_1.group_mask;
                                                                if ((_e1863 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1867 = local_1.len;
                                                                    if (_e1867 < 32u) {
                                                                        let _e1870 = local_1.group;
                                                                        let _e1872 = local_1.len;
                                                                        if (_e1872 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1872)] = _e1870;
                                                                        let _e1878 = local_1.group_mask;
                                                                        let _e1880 = local_1.len;
                                                                        if (_e1880 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1880)] = _e1878;
                                                                        let _e1887 = local_1.len;
                                                                        local_1.len = (_e1887 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1085 + _e1851);
                                                                let _e1891 = local_7;
                                                                local_1.group_mask = ((_e1891 & 4278190080u) | (_e1855 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1896 = local_8;
                                                            phi_2366_ = (_e1896 & 16777215u);
                                                            phi_2369_ = _e1463;
                                                            loop {
                                                                let _e1899 = phi_2366_;
                                                                let _e1901 = phi_2369_;
                                                                local_13 = _e1901;
                                                                let _e1902 = (_e1899 == 0u);
                                                                local_9 = _e1902;
                                                                local_15 = _e1902;
                                                                if _e1902 {
                                                                    phi_2367_ = u32();
                                                                    phi_2370_ = bool();
                                                                    phi_3173_ = bool();
                                                                    phi_3174_ = false;
                                                                } else {
                                                                    let _e1905 = nodes.member[(0u + _e1461)].links[1u];
                                                                    let _e1910 = ((_e1087 + _e1905) + select(firstTrailingBit(_e1899), 32u, (_e1899 == 0u)));
                                                                    if (_e1910 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1917 = triangles.member[(0u + _e1910)].v0_;
                                                                    let _e1919 = (_e1917.x - _e1016);
                                                                    let _e1921 = (_e1917.y - _e1029);
                                                                    let _e1923 = (_e1917.z - _e1042);
                                                                    if (_e1296 == 0u) {
                                                                        phi_2414_ = vec3<f32>(_e1921, _e1923, _e1919);
                                                                    } else {
                                                                        if (_e1296 == 1u) {
                                                                            phi_2413_ = vec3<f32>(_e1923, _e1919, _e1921);
                                                                        } else {
                                                                            phi_2413_ = (_e1917 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                        }
                                                                        let _e1931 = phi_2413_;
                                                                        phi_2414_ = _e1931;
                                                                    }
                                                                    let _e1933 = phi_2414_;
                                                                    let _e1937 = (_e1933.x - (_e1307 * _e1933.z));
                                                                    let _e1941 = (_e1933.y - (_e1310 * _e1933.z));
                                                                    let _e1943 = triangles.member[(0u + _e1910)].v1_;
                                                                    let _e1945 = (_e1943.x - _e1016);
                                                                    let _e1947 = (_e1943.y - _e1029);
                                                                    let _e1949 = (_e1943.z - _e1042);
                                                                    if (_e1296 == 0u) {
                                                                        phi_2444_ = vec3<f32>(_e1947, _e1949, _e1945);
                                                                    } else {
                                                                        if (_e1296 == 1u) {
                                                                            phi_2443_ = vec3<f32>(_e1949, _e1945, _e1947);
                                                                        } else {
                                                                            phi_2443_ = (_e1943 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                        }
                                                                        let _e1957 = phi_2443_;
                                                                        phi_2444_ = _e1957;
                                                                    }
                                                                    let _e1959 = phi_2444_;
                                                                    let _e1963 = (_e1959.x - (_e1307 * _e1959.z));
                                                                    let _e1967 = (_e1959.y - (_e1310 * _e1959.z));
                                                                    let _e1969 = triangles.member[(0u + _e1910)].v2_;
                                                                    let _e1971 = (_e1969.x - _e1016);
                                                                    let _e1973 = (_e1969.y - _e1029);
                                                                    let _e1975 = (_e1969.z - _e1042);
                                                                    if (_e1296 == 0u) {
                                                                        phi_2474_ = vec3<f32>(_e1973, _e1975, _e1971);
                                                                    } else {
                                                                        if (_e1296 == 1u) {
                                                                            phi_2473_ = vec3<f32>(_e1975, _e1971, _e1973);
                                                                        } else {
                                                                            phi_2473_ = (_e1969 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                        }
                                                                        let _e1983 = phi_2473_;
                                                                        phi_2474_ = _e1983;
                                                                    }
                                                                    let _e1985 = phi_2474_;
                                                                    let _e1989 = (_e1985.x - (_e1307 * _e1985.z));
                                                                    let _e1993 = (_e1985.y - (_e1310 * _e1985.z));
                                                                    if (_e1963 < _e1989) {
                                                                        phi_2493_ = true;
                                                                    } else {
                                                                        if (_e1963 == _e1989) {
                                                                            phi_2492_ = (_e1967 < _e1993);
                                                                        } else {
                                                                            phi_2492_ = false;
                                                                        }
                                                                        let _e1998 = phi_2492_;
                                                                        phi_2493_ = _e1998;
                                                                    }
                                                                    let _e2000 = phi_2493_;
                                                                    if _e2000 {
                                                                        phi_2497_ = _e1993;
                                                                        phi_2498_ = _e1989;
                                                                        phi_2499_ = _e1967;
                                                                        phi_2500_ = _e1963;
                                                                    } else {
                                                                        phi_2497_ = _e1967;
                                                                        phi_2498_ = _e1963;
                                                                        phi_2499_ = _e1993;
                                                                        phi_2500_ = _e1989;
                                                                    }
                                                                    let _e2002 = phi_2497_;
                                                                    let _e2004 = phi_2498_;
                                                                    let _e2006 = phi_2499_;
                                                                    let _e2008 = phi_2500_;
                                                                    let _e2011 = ((_e2008 * _e2002) - (_e2006 * _e2004));
                                                                    if _e2000 {
                                                                        phi_2508_ = -(_e2011);
                                                                    } else {
                                                                        phi_2508_ = _e2011;
                                                                    }
                                                                    let _e2014 = phi_2508_;
                                                                    if (_e1989 < _e1937) {
                                                                        phi_2519_ = true;
                                                                    } else {
                                                                        if (_e1989 == _e1937) {
                                                                            phi_2518_ = (_e1993 < _e1941);
                                                                        } else {
                                                                            phi_2518_ = false;
                                                                        }
                                                                        let _e2019 = phi_2518_;
                                                                        phi_2519_ = _e2019;
                                                                    }
                                                                    let _e2021 = phi_2519_;
                                                                    if _e2021 {
                                                                        phi_2523_ = _e1941;
                                                                        phi_2524_ = _e1937;
                                                                        phi_2525_ = _e1993;
                                                                        phi_2526_ = _e1989;
                                                                    } else {
                                                                        phi_2523_ = _e1993;
                                                                        phi_2524_ = _e1989;
                                                                        phi_2525_ = _e1941;
                                                                        phi_2526_ = _e1937;
                                                                    }
                                                                    let _e2023 = phi_2523_;
                                                                    let _e2025 = phi_2524_;
                                                                    let _e2027 = phi_2525_;
                                                                    let _e2029 = phi_2526_;
                                                                    let _e2032 = ((_e2029 * _e2023) - (_e2027 * _e2025));
                                                                    if _e2021 {
                                                                        phi_2534_ = -(_e2032);
                                                                    } else {
                                                                        phi_2534_ = _e2032;
                                                                    }
                                                                    let _e2035 = phi_2534_;
                                                                    if (_e1937 < _e1963) {
                                                                        phi_2545_ = true;
                                                                    } else {
                                                                        if (_e1937 == _e1963) {
                                                                            phi_2544_ = (_e1941 < _e1967);
                                                                        } else {
                                                                            phi_2544_ = false;
                                                                        }
                                                                        let _e2040 = phi_2544_;
                                                                        phi_2545_ = _e2040;
                                                                    }
                                                                    let _e2042 = phi_2545_;
                                                                    if _e2042 {
                                                                        phi_2549_ = _e1967;
                                                                        phi_2550_ = _e1963;
                                                                        phi_2551_ = _e1941;
                                                                        phi_2552_ = _e1937;
                                                                    } else {
                                                                        phi_2549_ = _e1941;
                                                                        phi_2550_ = _e1937;
                                                                        phi_2551_ = _e1967;
                                                                        phi_2552_ = _e1963;
                                                                    }
                                                                    let _e2044 = phi_2549_;
                                                                    let _e2046 = phi_2550_;
                                                                    let _e2048 = phi_2551_;
                                                                    let _e2050 = phi_2552_;
                                                                    let _e2053 = ((_e2050 * _e2044) - (_e2048 * _e2046));
                                                                    if _e2042 {
                                                                        phi_2560_ = -(_e2053);
                                                                    } else {
                                                                        phi_2560_ = _e2053;
                                                                    }
                                                                    let _e2056 = phi_2560_;
                                                                    if (_e2014 >= 0f) {
                                                                        if (_e2035 >= 0f) {
                                                                            if (_e2056 >= 0f) {
                                                                                phi_2575_ = ((_e2014 + _e2035) + _e2056);
                                                                                phi_2576_ = false;
                                                                            } else {
                                                                                phi_2575_ = f32();
                                                                                phi_2576_ = true;
                                                                            }
                                                                            let _e2063 = phi_2575_;
                                                                            let _e2065 = phi_2576_;
                                                                            phi_2577_ = _e2063;
                                                                            phi_2578_ = _e2065;
                                                                        } else {
                                                                            phi_2577_ = f32();
                                                                            phi_2578_ = true;
                                                                        }
                                                                        let _e2067 = phi_2577_;
                                                                        let _e2069 = phi_2578_;
                                                                        phi_2579_ = _e2067;
                                                                        phi_2580_ = _e2069;
                                                                    } else {
                                                                        phi_2579_ = f32();
                                                                        phi_2580_ = true;
                                                                    }
                                                                    let _e2071 = phi_2579_;
                                                                    let _e2073 = phi_2580_;
                                                                    if _e2073 {
                                                                        if (_e2014 <= 0f) {
                                                                            if (_e2035 <= 0f) {
                                                                                let _e2076 = (_e2056 <= 0f);
                                                                                if _e2076 {
                                                                                }
                                                                                phi_2598_ = ((_e2014 + _e2035) + _e2056);
                                                                                phi_2599_ = false;
                                                                                phi_2600_ = _e2076;
                                                                            } else {
                                                                                phi_2598_ = f32();
                                                                                phi_2599_ = true;
                                                                                phi_2600_ = false;
                                                                            }
                                                                            let _e2080 = phi_2598_;
                                                                            let _e2082 = phi_2599_;
                                                                            let _e2084 = phi_2600_;
                                                                            phi_2601_ = _e2080;
                                                                            phi_2602_ = _e2082;
                                                                            phi_2603_ = _e2084;
                                                                        } else {
                                                                            phi_2601_ = f32();
                                                                            phi_2602_ = true;
                                                                            phi_2603_ = false;
                                                                        }
                                                                        let _e2086 = phi_2601_;
                                                                        let _e2088 = phi_2602_;
                                                                        let _e2090 = phi_2603_;
                                                                        if _e2088 {
                                                                            phi_2607_ = false;
                                                                        } else {
                                                                            phi_2607_ = _e2090;
                                                                        }
                                                                        let _e2092 = phi_2607_;
                                                                        phi_2608_ = _e2086;
                                                                        phi_2609_ = _e2092;
                                                                    } else {
                                                                        phi_2608_ = _e2071;
                                                                        phi_2609_ = true;
                                                                    }
                                                                    let _e2094 = phi_2608_;
                                                                    let _e2096 = phi_2609_;
                                                                    if _e2096 {
                                                                        let _e2097 = (_e2094 == 0f);
                                                                        if _e2097 {
                                                                            phi_2925_ = lt_bvh_triangle_Intersection();
                                                                            phi_2926_ = false;
                                                                        } else {
                                                                            let _e2099 = triangles.member[(0u + _e1910)].v0_;
                                                                            let _e2101 = (_e2099.x - _e1016);
                                                                            let _e2103 = (_e2099.y - _e1029);
                                                                            let _e2105 = (_e2099.z - _e1042);
                                                                            if (_e1296 == 0u) {
                                                                                phi_2638_ = vec3<f32>(_e2103, _e2105, _e2101);
                                                                            } else {
                                                                                if (_e1296 == 1u) {
                                                                                    phi_2637_ = vec3<f32>(_e2105, _e2101, _e2103);
                                                                                } else {
                                                                                    phi_2637_ = (_e2099 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                                }
                                                                                let _e2113 = phi_2637_;
                                                                                phi_2638_ = _e2113;
                                                                            }
                                                                            let _e2115 = phi_2638_;
                                                                            let _e2117 = triangles.member[(0u + _e1910)].v1_;
                                                                            let _e2119 = triangles.member[(0u + _e1910)].v0_;
                                                                            let _e2122 = (_e2117.x - _e2119.x);
                                                                            let _e2125 = (_e2117.y - _e2119.y);
                                                                            let _e2128 = (_e2117.z - _e2119.z);
                                                                            if (_e1296 == 0u) {
                                                                                phi_2664_ = vec3<f32>(_e2125, _e2128, _e2122);
                                                                            } else {
                                                                                if (_e1296 == 1u) {
                                                                                    phi_2663_ = vec3<f32>(_e2128, _e2122, _e2125);
                                                                                } else {
                                                                                    phi_2663_ = (_e2117 - _e2119);
                                                                                }
                                                                                let _e2135 = phi_2663_;
                                                                                phi_2664_ = _e2135;
                                                                            }
                                                                            let _e2137 = phi_2664_;
                                                                            let _e2139 = triangles.member[(0u + _e1910)].v2_;
                                                                            let _e2141 = triangles.member[(0u + _e1910)].v0_;
                                                                            let _e2144 = (_e2139.x - _e2141.x);
                                                                            let _e2147 = (_e2139.y - _e2141.y);
                                                                            let _e2150 = (_e2139.z - _e2141.z);
                                                                            if (_e1296 == 0u) {
                                                                                phi_2690_ = vec3<f32>(_e2147, _e2150, _e2144);
                                                                            } else {
                                                                                if (_e1296 == 1u) {
                                                                                    phi_2689_ = vec3<f32>(_e2150, _e2144, _e2147);
                                                                                } else {
                                                                                    phi_2689_ = (_e2139 - _e2141);
                                                                                }
                                                                                let _e2157 = phi_2689_;
                                                                                phi_2690_ = _e2157;
                                                                            }
                                                                            let _e2159 = phi_2690_;
                                                                            let _e2166 = ((_e2137.y * _e2159.z) - (_e2137.z * _e2159.y));
                                                                            let _e2173 = ((_e2137.z * _e2159.x) - (_e2137.x * _e2159.z));
                                                                            let _e2180 = ((_e2137.x * _e2159.y) - (_e2137.y * _e2159.x));
                                                                            let _e2194 = (((1f / _e1304.z) * (((_e2166 * _e2115.x) + (_e2173 * _e2115.y)) + (_e2180 * _e2115.z))) / (((_e2166 * _e1307) + (_e2173 * _e1310)) + _e2180));
                                                                            if (_e2194 > 0f) {
                                                                                if (_e2194 < _e142) {
                                                                                    let _e2198 = triangles.member[(0u + _e1910)].v0_;
                                                                                    let _e2200 = triangles.member[(0u + _e1910)].v1_;
                                                                                    if (_e2198.x < _e2200.x) {
                                                                                        phi_2746_ = _e2198.x;
                                                                                    } else {
                                                                                        phi_2746_ = _e2200.x;
                                                                                    }
                                                                                    let _e2207 = phi_2746_;
                                                                                    if (_e2198.y < _e2200.y) {
                                                                                        phi_2755_ = _e2198.y;
                                                                                    } else {
                                                                                        phi_2755_ = _e2200.y;
                                                                                    }
                                                                                    let _e2214 = phi_2755_;
                                                                                    if (_e2198.z < _e2200.z) {
                                                                                        phi_2764_ = _e2198.z;
                                                                                    } else {
                                                                                        phi_2764_ = _e2200.z;
                                                                                    }
                                                                                    let _e2221 = phi_2764_;
                                                                                    let _e2223 = triangles.member[(0u + _e1910)].v2_;
                                                                                    if (_e2207 < _e2223.x) {
                                                                                        phi_2773_ = _e2207;
                                                                                    } else {
                                                                                        phi_2773_ = _e2223.x;
                                                                                    }
                                                                                    let _e2228 = phi_2773_;
                                                                                    if (_e2214 < _e2223.y) {
                                                                                        phi_2780_ = _e2214;
                                                                                    } else {
                                                                                        phi_2780_ = _e2223.y;
                                                                                    }
                                                                                    let _e2233 = phi_2780_;
                                                                                    if (_e2221 < _e2223.z) {
                                                                                        phi_2787_ = _e2221;
                                                                                    } else {
                                                                                        phi_2787_ = _e2223.z;
                                                                                    }
                                                                                    let _e2238 = phi_2787_;
                                                                                    let _e2240 = triangles.member[(0u + _e1910)].v0_;
                                                                                    let _e2242 = triangles.member[(0u + _e1910)].v1_;
                                                                                    if (_e2240.x > _e2242.x) {
                                                                                        phi_2800_ = _e2240.x;
                                                                                    } else {
                                                                                        phi_2800_ = _e2242.x;
                                                                                    }
                                                                                    let _e2249 = phi_2800_;
                                                                                    if (_e2240.y > _e2242.y) {
                                                                                        phi_2809_ = _e2240.y;
                                                                                    } else {
                                                                                        phi_2809_ = _e2242.y;
                                                                                    }
                                                                                    let _e2256 = phi_2809_;
                                                                                    if (_e2240.z > _e2242.z) {
                                                                                        phi_2818_ = _e2240.z;
                                                                                    } else {
                                                                                        phi_2818_ = _e2242.z;
                                                                                    }
                                                                                    let _e2263 = phi_2818_;
                                                                                    let _e2265 = triangles.member[(0u + _e1910)].v2_;
                                                                                    if (_e2249 > _e2265.x) {
                                                                                        phi_2827_ = _e2249;
                                                                                    } else {
                                                                                        phi_2827_ = _e2265.x;
                                                                                    }
                                                                                    let _e2270 = phi_2827_;
                                                                                    if (_e2256 > _e2265.y) {
                                                                                        phi_2834_ = _e2256;
                                                                                    } else {
                                                                                        phi_2834_ = _e2265.y;
                                                                                    }
                                                                                    let _e2275 = phi_2834_;
                                                                                    if (_e2263 > _e2265.z) {
                                                                                        phi_2841_ = _e2263;
                                                                                    } else {
                                                                                        phi_2841_ = _e2265.z;
                                                                                    }
                                                                                    let _e2280 = phi_2841_;
                                                                                    let _e2284 = ((_e2228 - _e1016) * _e1225);
                                                                                    let _e2285 = ((_e2233 - _e1029) * _e1235);
                                                                                    let _e2286 = ((_e2238 - _e1042) * _e1245);
                                                                                    let _e2290 = ((_e2270 - _e1016) * _e1225);
                                                                                    let _e2291 = ((_e2275 - _e1029) * _e1235);
                                                                                    let _e2292 = ((_e2280 - _e1042) * _e1245);
                                                                                    if (_e2284 < _e2290) {
                                                                                        phi_2858_ = _e2284;
                                                                                    } else {
                                                                                        phi_2858_ = _e2290;
                                                                                    }
                                                                                    let _e2295 = phi_2858_;
                                                                                    if (_e2285 < _e2291) {
                                                                                        phi_2863_ = _e2285;
                                                                                    } else {
                                                                                        phi_2863_ = _e2291;
                                                                                    }
                                                                                    let _e2298 = phi_2863_;
                                                                                    if (_e2286 < _e2292) {
                                                                                        phi_2868_ = _e2286;
                                                                                    } else {
                                                                                        phi_2868_ = _e2292;
                                                                                    }
                                                                                    let _e2301 = phi_2868_;
                                                                                    if (_e2284 > _e2290) {
                                                                                        phi_2876_ = _e2284;
                                                                                    } else {
                                                                                        phi_2876_ = _e2290;
                                                                                    }
                                                                                    let _e2307 = phi_2876_;
                                                                                    if (_e2285 > _e2291) {
                                                                                        phi_2881_ = _e2285;
                                                                                    } else {
                                                                                        phi_2881_ = _e2291;
                                                                                    }
                                                                                    let _e2310 = phi_2881_;
                                                                                    if (_e2286 > _e2292) {
                                                                                        phi_2886_ = _e2286;
                                                                                    } else {
                                                                                        phi_2886_ = _e2292;
                                                                                    }
                                                                                    let _e2313 = phi_2886_;
                                                                                    let _e2317 = core_intrinsics_maximum_number_nsz_f32_((_e2295 - _e1280), (_e2298 - _e1281));
                                                                                    let _e2318 = core_intrinsics_maximum_number_nsz_f32_(_e2317, (_e2301 - _e1282));
                                                                                    let _e2319 = core_intrinsics_minimum_number_nsz_f32_((_e2307 + _e1280), (_e2310 + _e1281));
                                                                                    let _e2320 = core_intrinsics_minimum_number_nsz_f32_(_e2319, (_e2313 + _e1282));
                                                                                    if (_e2318 > _e997) {
                                                                                        phi_2898_ = _e2318;
                                                                                    } else {
                                                                                        phi_2898_ = _e997;
                                                                                    }
                                                                                    let _e2323 = phi_2898_;
                                                                                    if (_e2320 < _e999) {
                                                                                        phi_2903_ = _e2320;
                                                                                    } else {
                                                                                        phi_2903_ = _e999;
                                                                                    }
                                                                                    let _e2326 = phi_2903_;
                                                                                    if (_e2194 < _e2323) {
                                                                                        phi_2908_ = _e2323;
                                                                                    } else {
                                                                                        phi_2908_ = _e2194;
                                                                                    }
                                                                                    let _e2329 = phi_2908_;
                                                                                    if (_e2329 > _e2326) {
                                                                                        phi_2913_ = _e2326;
                                                                                    } else {
                                                                                        phi_2913_ = _e2329;
                                                                                    }
                                                                                    let _e2332 = phi_2913_;
                                                                                    phi_2918_ = lt_bvh_triangle_Intersection(_e2332, (_e2035 / _e2094), (_e2056 / _e2094), (_e2323 <= _e2326));
                                                                                    phi_2919_ = false;
                                                                                } else {
                                                                                    phi_2918_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2919_ = true;
                                                                                }
                                                                                let _e2338 = phi_2918_;
                                                                                let _e2340 = phi_2919_;
                                                                                phi_2920_ = _e2338;
                                                                                phi_2921_ = _e2340;
                                                                            } else {
                                                                                phi_2920_ = lt_bvh_triangle_Intersection();
                                                                                phi_2921_ = true;
                                                                            }
                                                                            let _e2342 = phi_2920_;
                                                                            let _e2344 = phi_2921_;
                                                                            if _e2344 {
                                                                            }
                                                                            phi_2925_ = _e2342;
                                                                            phi_2926_ = _e2344;
                                                                        }
                                                                        let _e2346 = phi_2925_;
                                                                        let _e2348 = phi_2926_;
                                                                        phi_2927_ = _e2346;
                                                                        phi_2928_ = _e2097;
                                                                        phi_2929_ = _e2348;
                                                                    } else {
                                                                        phi_2927_ = lt_bvh_triangle_Intersection();
                                                                        phi_2928_ = true;
                                                                        phi_2929_ = false;
                                                                    }
                                                                    let _e2350 = phi_2927_;
                                                                    let _e2352 = phi_2928_;
                                                                    let _e2354 = phi_2929_;
                                                                    if _e2352 {
                                                                        phi_2933_ = true;
                                                                    } else {
                                                                        phi_2933_ = _e2354;
                                                                    }
                                                                    let _e2356 = phi_2933_;
                                                                    if _e2356 {
                                                                        phi_2937_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2937_ = _e2350;
                                                                    }
                                                                    let _e2358 = phi_2937_;
                                                                    if _e2358.is_hit {
                                                                        if (_e2358.t > 0f) {
                                                                            if (_e2358.t < _e142) {
                                                                                let _e2365 = triangles.member[(0u + _e1910)].i0_;
                                                                                if ((_e2365 & 2147483648u) == 0u) {
                                                                                    phi_3156_ = true;
                                                                                } else {
                                                                                    if (_e1910 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2374 = triangles.member[(0u + _e1910)].i0_;
                                                                                    let _e2375 = (_e2374 & 2147483647u);
                                                                                    let _e2377 = triangles.member[(0u + _e1910)].i1_;
                                                                                    let _e2379 = triangles.member[(0u + _e1910)].i2_;
                                                                                    if (_e2375 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2383 = vertices.member[(0u + _e2375)];
                                                                                    if (_e2377 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2387 = vertices.member[(0u + _e2377)];
                                                                                    if (_e2379 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2391 = vertices.member[(0u + _e2379)];
                                                                                    let _e2392 = array<abi_Vertex, 3>(_e2383, _e2387, _e2391);
                                                                                    if (_e2392[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2398 = materials.member[(0u + _e2392[0].material)];
                                                                                    if ((_e2398.flags & 1u) == 1u) {
                                                                                        let _e2403 = ((1f - _e2358.u) - _e2358.v);
                                                                                        if (_e2398.cutoff <= 0f) {
                                                                                            phi_3154_ = true;
                                                                                        } else {
                                                                                            let _e2430 = (_e2398.base_color.w * ((((f32((_e2392[0].color >> bitcast<u32>(24i))) * _e2403) + (f32((_e2392[1].color >> bitcast<u32>(24i))) * _e2358.u)) + (f32((_e2392[2].color >> bitcast<u32>(24i))) * _e2358.v)) * (1f / 255f)));
                                                                                            if (_e2398.alpha_size == 0u) {
                                                                                                phi_3151_ = _e2430;
                                                                                            } else {
                                                                                                local.offset = _e2398.alpha_offset;
                                                                                                local.size = _e2398.alpha_size;
                                                                                                local.flags = _e2398.flags;
                                                                                                let _e2461 = _lt_shaders_texture_TextureView_quad((&local), (((_e2392[0].u * _e2403) + (_e2392[1].u * _e2358.u)) + (_e2392[2].u * _e2358.v)), (((_e2392[0].v * _e2403) + (_e2392[1].v * _e2358.u)) + (_e2392[2].v * _e2358.v)));
                                                                                                let _e2465 = (_e2461.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2465 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2469 = alpha_texels.member[(0u + _e2465)];
                                                                                                let _e2485 = (_e2461.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2485 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2489 = alpha_texels.member[(0u + _e2485)];
                                                                                                let _e2506 = (_e2461.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2506 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2510 = alpha_texels.member[(0u + _e2506)];
                                                                                                let _e2527 = (_e2461.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2527 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2531 = alpha_texels.member[(0u + _e2527)];
                                                                                                phi_3151_ = (_e2430 * (((((f32(((_e2469 >> bitcast<u32>((((_e2461.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2461.weights.x) + ((f32(((_e2489 >> bitcast<u32>((((_e2461.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2461.weights.y)) + ((f32(((_e2510 >> bitcast<u32>((((_e2461.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2461.weights.z)) + ((f32(((_e2531 >> bitcast<u32>((((_e2461.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2461.weights.w)));
                                                                                            }
                                                                                            let _e2547 = phi_3151_;
                                                                                            phi_3154_ = (_e2547 >= _e2398.cutoff);
                                                                                        }
                                                                                        let _e2551 = phi_3154_;
                                                                                        phi_3155_ = _e2551;
                                                                                    } else {
                                                                                        phi_3155_ = false;
                                                                                    }
                                                                                    let _e2553 = phi_3155_;
                                                                                    phi_3156_ = _e2553;
                                                                                }
                                                                                let _e2555 = phi_3156_;
                                                                                if _e2555 {
                                                                                    phi_3160_ = false;
                                                                                } else {
                                                                                    phi_3160_ = true;
                                                                                }
                                                                                let _e2557 = phi_3160_;
                                                                                phi_3161_ = _e2555;
                                                                                phi_3162_ = _e2555;
                                                                                phi_3163_ = _e2557;
                                                                            } else {
                                                                                phi_3161_ = bool();
                                                                                phi_3162_ = _e1901;
                                                                                phi_3163_ = true;
                                                                            }
                                                                            let _e2559 = phi_3161_;
                                                                            let _e2561 = phi_3162_;
                                                                            let _e2563 = phi_3163_;
                                                                            phi_3164_ = _e2559;
                                                                            phi_3165_ = _e2561;
                                                                            phi_3166_ = _e2563;
                                                                        } else {
                                                                            phi_3164_ = bool();
                                                                            phi_3165_ = _e1901;
                                                                            phi_3166_ = true;
                                                                        }
                                                                        let _e2565 = phi_3164_;
                                                                        let _e2567 = phi_3165_;
                                                                        let _e2569 = phi_3166_;
                                                                        phi_3167_ = _e2565;
                                                                        phi_3168_ = _e2567;
                                                                        phi_3169_ = _e2569;
                                                                    } else {
                                                                        phi_3167_ = bool();
                                                                        phi_3168_ = _e1901;
                                                                        phi_3169_ = true;
                                                                    }
                                                                    let _e2571 = phi_3167_;
                                                                    let _e2573 = phi_3168_;
                                                                    let _e2575 = phi_3169_;
                                                                    if _e2575 {
                                                                    }
                                                                    phi_2367_ = (_e1899 & (_e1899 - 1u));
                                                                    phi_2370_ = _e2573;
                                                                    phi_3173_ = _e2571;
                                                                    phi_3174_ = _e2575;
                                                                }
                                                                let _e2577 = phi_2367_;
                                                                let _e2579 = phi_2370_;
                                                                let _e2581 = phi_3173_;
                                                                let _e2583 = phi_3174_;
                                                                local_14 = _e2581;
                                                                continue;
                                                                continuing {
                                                                    phi_2366_ = _e2577;
                                                                    phi_2369_ = _e2579;
                                                                    break if !(_e2583);
                                                                }
                                                            }
                                                            let _e2586 = local_9;
                                                            if _e2586 {
                                                                let _e2588 = local_1.group_mask;
                                                                if ((_e2588 & 4278190080u) == 0u) {
                                                                    let _e2592 = local_1.len;
                                                                    if (_e2592 == 0u) {
                                                                        phi_3216_ = false;
                                                                    } else {
                                                                        let _e2596 = local_1.len;
                                                                        local_1.len = (_e2596 - 1u);
                                                                        let _e2599 = local_1.len;
                                                                        if (_e2599 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2604 = local_1.first[(0u + _e2599)];
                                                                        local_1.group = _e2604;
                                                                        let _e2607 = local_1.len;
                                                                        if (_e2607 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2612 = local_1.mask[(0u + _e2607)];
                                                                        local_1.group_mask = _e2612;
                                                                        phi_3216_ = true;
                                                                    }
                                                                    let _e2615 = phi_3216_;
                                                                    phi_3217_ = _e2615;
                                                                } else {
                                                                    phi_3217_ = true;
                                                                }
                                                                let _e2617 = phi_3217_;
                                                                if _e2617 {
                                                                    let _e2619 = local_1.group_mask;
                                                                    let _e2625 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2619)), 32u, (_e2619 == 0u)));
                                                                    let _e2629 = local_1.group_mask;
                                                                    let _e2643 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2643 & ~((1u << bitcast<u32>((_e2625 & 31u)))));
                                                                    let _e2646 = local_1.group;
                                                                    phi_3248_ = (_e2646 + countOneBits(((_e2629 & ~((4294967295u << bitcast<u32>((((_e2625 - 24u) ^ _e1323) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3248_ = 4294967295u;
                                                                }
                                                                let _e2649 = phi_3248_;
                                                                phi_3249_ = _e2649;
                                                            } else {
                                                                phi_3249_ = u32();
                                                            }
                                                            let _e2651 = phi_3249_;
                                                            phi_2035_ = _e2651;
                                                            let _e3041 = local_13;
                                                            phi_2038_ = _e3041;
                                                            let _e3044 = local_14;
                                                            phi_3250_ = _e3044;
                                                            let _e3047 = local_15;
                                                            phi_3251_ = _e3047;
                                                            phi_3252_ = false;
                                                        } else {
                                                            phi_2035_ = u32();
                                                            phi_2038_ = bool();
                                                            phi_3250_ = bool();
                                                            phi_3251_ = false;
                                                            phi_3252_ = true;
                                                        }
                                                        let _e2653 = phi_2035_;
                                                        let _e2655 = phi_2038_;
                                                        let _e2657 = phi_3250_;
                                                        let _e2659 = phi_3251_;
                                                        let _e2661 = phi_3252_;
                                                        local_10 = _e2661;
                                                        local_16 = _e2657;
                                                        continue;
                                                        continuing {
                                                            phi_2034_ = _e2653;
                                                            phi_2037_ = _e2655;
                                                            break if !(_e2659);
                                                        }
                                                    }
                                                    let _e2664 = local_10;
                                                    if _e2664 {
                                                        phi_3256_ = false;
                                                    } else {
                                                        phi_3256_ = true;
                                                    }
                                                    let _e2666 = phi_3256_;
                                                    if _e2666 {
                                                        let _e3053 = local_16;
                                                        phi_3260_ = _e3053;
                                                    } else {
                                                        let _e3055 = local_17;
                                                        phi_3260_ = _e3055;
                                                    }
                                                    let _e2668 = phi_3260_;
                                                    phi_3261_ = _e2668;
                                                }
                                                let _e2670 = phi_3261_;
                                                phi_3262_ = _e2670;
                                                phi_3263_ = _e1149;
                                            } else {
                                                phi_3262_ = bool();
                                                phi_3263_ = true;
                                            }
                                            let _e2672 = phi_3262_;
                                            let _e2674 = phi_3263_;
                                            if _e2674 {
                                                phi_3267_ = _e936;
                                            } else {
                                                phi_3267_ = _e2672;
                                            }
                                            let _e2676 = phi_3267_;
                                            if _e2676 {
                                                phi_3271_ = false;
                                            } else {
                                                phi_3271_ = true;
                                            }
                                            let _e2678 = phi_3271_;
                                            phi_3272_ = _e2676;
                                            phi_3273_ = _e2678;
                                        } else {
                                            phi_3272_ = _e936;
                                            phi_3273_ = true;
                                        }
                                        let _e2680 = phi_3272_;
                                        let _e2682 = phi_3273_;
                                        phi_3274_ = _e2680;
                                        phi_3275_ = _e2682;
                                    } else {
                                        phi_3274_ = _e936;
                                        phi_3275_ = true;
                                    }
                                    let _e2684 = phi_3274_;
                                    let _e2686 = phi_3275_;
                                    phi_3276_ = _e2684;
                                    phi_3277_ = _e2686;
                                } else {
                                    phi_3276_ = _e936;
                                    phi_3277_ = true;
                                }
                                let _e2688 = phi_3276_;
                                let _e2690 = phi_3277_;
                                if _e2690 {
                                }
                                phi_1427_ = (_e934 & (_e934 - 1u));
                                phi_1430_ = _e2688;
                                phi_3281_ = _e2690;
                            }
                            let _e2692 = phi_1427_;
                            let _e2694 = phi_1430_;
                            let _e2696 = phi_3281_;
                            continue;
                            continuing {
                                phi_1426_ = _e2692;
                                phi_1429_ = _e2694;
                                break if !(_e2696);
                            }
                        }
                        let _e2699 = local_11;
                        if _e2699 {
                            let _e2701 = local_2.group_mask;
                            if ((_e2701 & 4278190080u) == 0u) {
                                let _e2705 = local_2.len;
                                if (_e2705 == 0u) {
                                    phi_3323_ = false;
                                } else {
                                    let _e2709 = local_2.len;
                                    local_2.len = (_e2709 - 1u);
                                    let _e2712 = local_2.len;
                                    if (_e2712 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2717 = local_2.first[(0u + _e2712)];
                                    local_2.group = _e2717;
                                    let _e2720 = local_2.len;
                                    if (_e2720 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2725 = local_2.mask[(0u + _e2720)];
                                    local_2.group_mask = _e2725;
                                    phi_3323_ = true;
                                }
                                let _e2728 = phi_3323_;
                                phi_3324_ = _e2728;
                            } else {
                                phi_3324_ = true;
                            }
                            let _e2730 = phi_3324_;
                            if _e2730 {
                                let _e2732 = local_2.group_mask;
                                let _e2738 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2732)), 32u, (_e2732 == 0u)));
                                let _e2742 = local_2.group_mask;
                                let _e2756 = local_2.group_mask;
                                local_2.group_mask = (_e2756 & ~((1u << bitcast<u32>((_e2738 & 31u)))));
                                let _e2759 = local_2.group;
                                phi_3355_ = (_e2759 + countOneBits(((_e2742 & ~((4294967295u << bitcast<u32>((((_e2738 - 24u) ^ _e358) & 31u))))) & 255u)));
                            } else {
                                phi_3355_ = 4294967295u;
                            }
                            let _e2762 = phi_3355_;
                            phi_3356_ = _e2762;
                        } else {
                            phi_3356_ = u32();
                        }
                        let _e2764 = phi_3356_;
                        phi_1095_ = _e2764;
                        let _e3078 = local_18;
                        phi_1098_ = _e3078;
                        let _e3081 = local_19;
                        phi_3357_ = _e3081;
                        phi_3358_ = false;
                    } else {
                        phi_1095_ = u32();
                        phi_1098_ = bool();
                        phi_3357_ = false;
                        phi_3358_ = true;
                    }
                    let _e2766 = phi_1095_;
                    let _e2768 = phi_1098_;
                    let _e2770 = phi_3357_;
                    let _e2772 = phi_3358_;
                    local_12 = _e2772;
                    continue;
                    continuing {
                        phi_1094_ = _e2766;
                        phi_1097_ = _e2768;
                        break if !(_e2770);
                    }
                }
                let _e2775 = local_12;
                if _e2775 {
                    phi_3362_ = false;
                } else {
                    phi_3362_ = true;
                }
                let _e2777 = phi_3362_;
                if _e2777 {
                }
                phi_3366_ = _e2777;
            }
            let _e2779 = phi_3366_;
            phi_3367_ = _e214;
            phi_3368_ = _e2779;
        } else {
            phi_3367_ = true;
            phi_3368_ = false;
        }
        let _e2781 = phi_3367_;
        let _e2783 = phi_3368_;
        if _e2781 {
            phi_3372_ = false;
            phi_3373_ = true;
        } else {
            phi_3372_ = true;
            phi_3373_ = _e2783;
        }
        let _e2785 = phi_3372_;
        let _e2787 = phi_3373_;
        if _e2787 {
            phi_3377_ = _e2785;
        } else {
            phi_3377_ = false;
        }
        let _e2789 = phi_3377_;
        if _e2789 {
            phi_3381_ = 0f;
        } else {
            phi_3381_ = 1f;
        }
        let _e2791 = phi_3381_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2791;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
