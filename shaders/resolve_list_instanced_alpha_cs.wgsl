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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
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
    var phi_235_: f32;
    var phi_240_: f32;
    var phi_241_: bool;
    var phi_242_: f32;
    var phi_243_: bool;
    var phi_247_: f32;
    var phi_273_: f32;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_285_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_323_: u32;
    var phi_337_: u32;
    var phi_344_: u32;
    var phi_349_: u32;
    var phi_355_: u32;
    var phi_360_: u32;
    var phi_362_: texture_Axis;
    var phi_390_: f32;
    var phi_395_: f32;
    var phi_396_: bool;
    var phi_397_: f32;
    var phi_398_: bool;
    var phi_402_: f32;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_440_: f32;
    var phi_448_: f32;
    var phi_449_: f32;
    var phi_450_: f32;
    var phi_459_: f32;
    var phi_460_: f32;
    var phi_478_: u32;
    var phi_492_: u32;
    var phi_499_: u32;
    var phi_504_: u32;
    var phi_510_: u32;
    var phi_515_: u32;
    var phi_517_: texture_Axis;

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
                phi_235_ = 1f;
            } else {
                phi_235_ = 0f;
            }
            let _e100 = phi_235_;
            if (param_1 < 8388608f) {
                phi_240_ = (_e97 - _e100);
                phi_241_ = false;
            } else {
                phi_240_ = f32();
                phi_241_ = true;
            }
            let _e103 = phi_240_;
            let _e105 = phi_241_;
            phi_242_ = _e103;
            phi_243_ = _e105;
        } else {
            phi_242_ = f32();
            phi_243_ = true;
        }
        let _e107 = phi_242_;
        let _e109 = phi_243_;
        if _e109 {
            phi_247_ = param_1;
        } else {
            phi_247_ = _e107;
        }
        let _e111 = phi_247_;
        phi_295_ = (param_1 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_1 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_273_ = 1f;
                } else {
                    phi_273_ = 0f;
                }
                let _e129 = phi_273_;
                if (_e114 < 8388608f) {
                    phi_278_ = (_e126 - _e129);
                    phi_279_ = false;
                } else {
                    phi_278_ = f32();
                    phi_279_ = true;
                }
                let _e132 = phi_278_;
                let _e134 = phi_279_;
                phi_280_ = _e132;
                phi_281_ = _e134;
            } else {
                phi_280_ = f32();
                phi_281_ = true;
            }
            let _e136 = phi_280_;
            let _e138 = phi_281_;
            if _e138 {
                phi_285_ = _e114;
            } else {
                phi_285_ = _e136;
            }
            let _e140 = phi_285_;
            let _e142 = (param_1 - (2f * _e140));
            if (_e142 > 1f) {
                phi_293_ = (2f - _e142);
            } else {
                phi_293_ = _e142;
            }
            let _e146 = phi_293_;
            phi_294_ = _e146;
        } else {
            phi_294_ = param_1;
        }
        let _e148 = phi_294_;
        phi_295_ = _e148;
    }
    let _e150 = phi_295_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_304_ = _e150;
        } else {
            phi_304_ = 1f;
        }
        let _e154 = phi_304_;
        phi_305_ = _e154;
    } else {
        phi_305_ = 0f;
    }
    let _e156 = phi_305_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_323_ = _e157;
        } else {
            phi_323_ = _e166;
        }
        let _e169 = phi_323_;
        phi_362_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_337_ = _e71;
        } else {
            phi_337_ = _e178;
        }
        let _e181 = phi_337_;
        if (_e84 == 0u) {
            phi_344_ = _e157;
        } else {
            phi_344_ = 0u;
        }
        let _e186 = phi_344_;
        if (_e84 == 0u) {
            phi_349_ = 0u;
        } else {
            phi_349_ = _e157;
        }
        let _e189 = phi_349_;
        if (_e181 == 0u) {
            phi_355_ = _e186;
        } else {
            phi_355_ = (_e181 - 1u);
        }
        let _e193 = phi_355_;
        if (_e181 > _e157) {
            phi_360_ = _e189;
        } else {
            phi_360_ = _e181;
        }
        let _e196 = phi_360_;
        phi_362_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_362_;
    let _e201 = (*param).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_2 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e217 > param_2) {
                phi_390_ = 1f;
            } else {
                phi_390_ = 0f;
            }
            let _e220 = phi_390_;
            if (param_2 < 8388608f) {
                phi_395_ = (_e217 - _e220);
                phi_396_ = false;
            } else {
                phi_395_ = f32();
                phi_396_ = true;
            }
            let _e223 = phi_395_;
            let _e225 = phi_396_;
            phi_397_ = _e223;
            phi_398_ = _e225;
        } else {
            phi_397_ = f32();
            phi_398_ = true;
        }
        let _e227 = phi_397_;
        let _e229 = phi_398_;
        if _e229 {
            phi_402_ = param_2;
        } else {
            phi_402_ = _e227;
        }
        let _e231 = phi_402_;
        phi_450_ = (param_2 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_2 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_428_ = 1f;
                } else {
                    phi_428_ = 0f;
                }
                let _e249 = phi_428_;
                if (_e234 < 8388608f) {
                    phi_433_ = (_e246 - _e249);
                    phi_434_ = false;
                } else {
                    phi_433_ = f32();
                    phi_434_ = true;
                }
                let _e252 = phi_433_;
                let _e254 = phi_434_;
                phi_435_ = _e252;
                phi_436_ = _e254;
            } else {
                phi_435_ = f32();
                phi_436_ = true;
            }
            let _e256 = phi_435_;
            let _e258 = phi_436_;
            if _e258 {
                phi_440_ = _e234;
            } else {
                phi_440_ = _e256;
            }
            let _e260 = phi_440_;
            let _e262 = (param_2 - (2f * _e260));
            if (_e262 > 1f) {
                phi_448_ = (2f - _e262);
            } else {
                phi_448_ = _e262;
            }
            let _e266 = phi_448_;
            phi_449_ = _e266;
        } else {
            phi_449_ = param_2;
        }
        let _e268 = phi_449_;
        phi_450_ = _e268;
    }
    let _e270 = phi_450_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_459_ = _e270;
        } else {
            phi_459_ = 1f;
        }
        let _e274 = phi_459_;
        phi_460_ = _e274;
    } else {
        phi_460_ = 0f;
    }
    let _e276 = phi_460_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_478_ = _e277;
        } else {
            phi_478_ = _e286;
        }
        let _e289 = phi_478_;
        phi_517_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_492_ = _e75;
        } else {
            phi_492_ = _e298;
        }
        let _e301 = phi_492_;
        if (_e204 == 0u) {
            phi_499_ = _e277;
        } else {
            phi_499_ = 0u;
        }
        let _e306 = phi_499_;
        if (_e204 == 0u) {
            phi_504_ = 0u;
        } else {
            phi_504_ = _e277;
        }
        let _e309 = phi_504_;
        if (_e301 == 0u) {
            phi_510_ = _e306;
        } else {
            phi_510_ = (_e301 - 1u);
        }
        let _e313 = phi_510_;
        if (_e301 > _e277) {
            phi_515_ = _e309;
        } else {
            phi_515_ = _e301;
        }
        let _e316 = phi_515_;
        phi_517_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_517_;
    let _e323 = (*param).offset;
    let _e330 = (*param).offset;
    let _e337 = (*param).offset;
    let _e344 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_576_: bool;
    var phi_580_: f32;

    if (param_3 != param_3) {
        phi_576_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_576_ = _e69;
    }
    let _e71 = phi_576_;
    if _e71 {
        phi_580_ = param_4;
    } else {
        phi_580_ = param_3;
    }
    let _e73 = phi_580_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_592_: bool;
    var phi_596_: f32;

    if (param_5 != param_5) {
        phi_592_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_592_ = _e69;
    }
    let _e71 = phi_592_;
    if _e71 {
        phi_596_ = param_6;
    } else {
        phi_596_ = param_5;
    }
    let _e73 = phi_596_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_694_: f32;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
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
    var phi_773_: bool;
    var phi_777_: bool;
    var phi_781_: bool;
    var phi_851_: f32;
    var phi_858_: f32;
    var phi_865_: f32;
    var phi_872_: f32;
    var phi_879_: f32;
    var phi_886_: f32;
    var phi_903_: f32;
    var phi_908_: f32;
    var phi_913_: f32;
    var phi_934_: u32;
    var phi_939_: u32;
    var phi_944_: u32;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1090_: u32;
    var phi_1092_: u32;
    var phi_1173_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1200_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1227_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1233_: u32;
    var phi_1236_: u32;
    var phi_1250_: u32;
    var phi_1260_: u32;
    var phi_1270_: u32;
    var phi_1288_: u32;
    var phi_1298_: u32;
    var phi_1308_: u32;
    var phi_1344_: u32;
    var phi_1357_: u32;
    var phi_1362_: u32;
    var phi_1363_: u32;
    var phi_1364_: u32;
    var phi_1234_: u32;
    var phi_1237_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1422_: u32;
    var phi_1472_: f32;
    var phi_1477_: f32;
    var phi_1482_: f32;
    var phi_1490_: f32;
    var phi_1495_: f32;
    var phi_1500_: f32;
    var phi_1644_: bool;
    var phi_1645_: bool;
    var phi_1646_: bool;
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
    var phi_1667_: bool;
    var phi_1671_: bool;
    var phi_1675_: bool;
    var phi_1745_: f32;
    var phi_1752_: f32;
    var phi_1759_: f32;
    var phi_1766_: f32;
    var phi_1773_: f32;
    var phi_1780_: f32;
    var phi_1797_: f32;
    var phi_1802_: f32;
    var phi_1807_: f32;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1844_: u32;
    var phi_1845_: u32;
    var phi_1856_: vec3<f32>;
    var phi_1857_: vec3<f32>;
    var phi_1870_: u32;
    var phi_1875_: u32;
    var phi_1880_: u32;
    var phi_1994_: bool;
    var phi_1995_: bool;
    var phi_2026_: u32;
    var phi_2028_: u32;
    var phi_2109_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2136_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2163_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2169_: u32;
    var phi_2172_: u32;
    var phi_2186_: u32;
    var phi_2196_: u32;
    var phi_2206_: u32;
    var phi_2224_: u32;
    var phi_2234_: u32;
    var phi_2244_: u32;
    var phi_2280_: u32;
    var phi_2293_: u32;
    var phi_2298_: u32;
    var phi_2299_: u32;
    var phi_2300_: u32;
    var phi_2170_: u32;
    var phi_2173_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2358_: u32;
    var phi_2403_: vec3<f32>;
    var phi_2404_: vec3<f32>;
    var phi_2435_: vec3<f32>;
    var phi_2436_: vec3<f32>;
    var phi_2467_: vec3<f32>;
    var phi_2468_: vec3<f32>;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2493_: f32;
    var phi_2494_: f32;
    var phi_2495_: f32;
    var phi_2496_: f32;
    var phi_2504_: f32;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2519_: f32;
    var phi_2520_: f32;
    var phi_2521_: f32;
    var phi_2522_: f32;
    var phi_2530_: f32;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2545_: f32;
    var phi_2546_: f32;
    var phi_2547_: f32;
    var phi_2548_: f32;
    var phi_2556_: f32;
    var phi_2571_: f32;
    var phi_2572_: bool;
    var phi_2573_: f32;
    var phi_2574_: bool;
    var phi_2575_: f32;
    var phi_2576_: bool;
    var phi_2594_: f32;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2597_: f32;
    var phi_2598_: bool;
    var phi_2599_: bool;
    var phi_2603_: bool;
    var phi_2604_: f32;
    var phi_2605_: bool;
    var phi_2639_: f32;
    var phi_2648_: f32;
    var phi_2657_: f32;
    var phi_2666_: f32;
    var phi_2673_: f32;
    var phi_2680_: f32;
    var phi_2693_: f32;
    var phi_2702_: f32;
    var phi_2711_: f32;
    var phi_2720_: f32;
    var phi_2727_: f32;
    var phi_2734_: f32;
    var phi_2751_: f32;
    var phi_2756_: f32;
    var phi_2761_: f32;
    var phi_2769_: f32;
    var phi_2774_: f32;
    var phi_2779_: f32;
    var phi_2791_: f32;
    var phi_2796_: f32;
    var phi_2801_: f32;
    var phi_2806_: f32;
    var phi_2811_: lt_bvh_triangle_Intersection;
    var phi_2812_: bool;
    var phi_2813_: lt_bvh_triangle_Intersection;
    var phi_2814_: bool;
    var phi_2818_: lt_bvh_triangle_Intersection;
    var phi_2819_: bool;
    var phi_2820_: lt_bvh_triangle_Intersection;
    var phi_2821_: bool;
    var phi_2822_: bool;
    var phi_2826_: bool;
    var phi_2830_: lt_bvh_triangle_Intersection;
    var phi_3044_: f32;
    var phi_3047_: bool;
    var phi_3048_: bool;
    var phi_3052_: bool;
    var phi_3053_: bool;
    var phi_3054_: bool;
    var phi_3055_: bool;
    var phi_3056_: bool;
    var phi_3057_: bool;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var phi_3060_: bool;
    var phi_3061_: bool;
    var phi_3062_: bool;
    var phi_3063_: bool;
    var phi_3067_: bool;
    var phi_3068_: bool;
    var phi_2359_: u32;
    var phi_3069_: bool;
    var phi_3070_: bool;
    var phi_3071_: bool;
    var local_9: bool;
    var phi_3113_: bool;
    var phi_3114_: bool;
    var phi_3145_: u32;
    var phi_3146_: u32;
    var phi_3147_: bool;
    var phi_3148_: bool;
    var phi_2029_: u32;
    var phi_3149_: bool;
    var phi_3150_: bool;
    var phi_3151_: bool;
    var phi_3152_: bool;
    var local_10: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3161_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3168_: bool;
    var phi_3172_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var phi_1423_: u32;
    var phi_3183_: bool;
    var local_11: bool;
    var phi_3225_: bool;
    var phi_3226_: bool;
    var phi_3257_: u32;
    var phi_3258_: u32;
    var phi_1093_: u32;
    var phi_3259_: bool;
    var phi_3260_: bool;
    var local_12: bool;
    var phi_3264_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_3271_: bool;
    var phi_3275_: bool;
    var phi_3279_: f32;
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
            phi_694_ = 300000000000000000000000000000000000000f;
        } else {
            phi_694_ = 1f;
        }
        let _e141 = phi_694_;
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
                                    phi_751_ = bool();
                                    phi_752_ = true;
                                } else {
                                    let _e165 = (_e156 > 0f);
                                    if _e165 {
                                        phi_750_ = bool();
                                    } else {
                                        phi_750_ = (_e157 > 0f);
                                    }
                                    let _e168 = phi_750_;
                                    phi_751_ = _e168;
                                    phi_752_ = _e165;
                                }
                                let _e170 = phi_751_;
                                let _e172 = phi_752_;
                                if _e172 {
                                    phi_756_ = true;
                                } else {
                                    phi_756_ = _e170;
                                }
                                let _e174 = phi_756_;
                                phi_757_ = _e174;
                                phi_758_ = false;
                            } else {
                                phi_757_ = bool();
                                phi_758_ = true;
                            }
                            let _e176 = phi_757_;
                            let _e178 = phi_758_;
                            phi_759_ = _e176;
                            phi_760_ = false;
                            phi_761_ = _e178;
                        } else {
                            phi_759_ = bool();
                            phi_760_ = true;
                            phi_761_ = false;
                        }
                        let _e180 = phi_759_;
                        let _e182 = phi_760_;
                        let _e184 = phi_761_;
                        phi_762_ = _e180;
                        phi_763_ = _e182;
                        phi_764_ = _e184;
                    } else {
                        phi_762_ = bool();
                        phi_763_ = true;
                        phi_764_ = false;
                    }
                    let _e186 = phi_762_;
                    let _e188 = phi_763_;
                    let _e190 = phi_764_;
                    phi_765_ = _e186;
                    phi_766_ = _e188;
                    phi_767_ = _e190;
                } else {
                    phi_765_ = bool();
                    phi_766_ = true;
                    phi_767_ = false;
                }
                let _e192 = phi_765_;
                let _e194 = phi_766_;
                let _e196 = phi_767_;
                phi_768_ = _e192;
                phi_769_ = _e194;
                phi_770_ = _e196;
            } else {
                phi_768_ = bool();
                phi_769_ = true;
                phi_770_ = false;
            }
            let _e198 = phi_768_;
            let _e200 = phi_769_;
            let _e202 = phi_770_;
            phi_771_ = _e198;
            phi_772_ = _e200;
            phi_773_ = _e202;
        } else {
            phi_771_ = bool();
            phi_772_ = true;
            phi_773_ = false;
        }
        let _e204 = phi_771_;
        let _e206 = phi_772_;
        let _e208 = phi_773_;
        if _e206 {
            phi_777_ = true;
        } else {
            phi_777_ = _e208;
        }
        let _e210 = phi_777_;
        if _e210 {
            phi_781_ = false;
        } else {
            phi_781_ = _e204;
        }
        let _e212 = phi_781_;
        if _e212 {
            let _e213 = (_e112 >= _e76);
            if _e213 {
                phi_3269_ = bool();
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
                    phi_851_ = _e279;
                } else {
                    phi_851_ = abs(_e149);
                }
                let _e284 = phi_851_;
                if (_e149 < 0f) {
                    phi_858_ = (-1f / _e284);
                } else {
                    phi_858_ = (1f / _e284);
                }
                let _e289 = phi_858_;
                if (abs(_e150) < _e279) {
                    phi_865_ = _e279;
                } else {
                    phi_865_ = abs(_e150);
                }
                let _e294 = phi_865_;
                if (_e150 < 0f) {
                    phi_872_ = (-1f / _e294);
                } else {
                    phi_872_ = (1f / _e294);
                }
                let _e299 = phi_872_;
                if (abs(_e151) < _e279) {
                    phi_879_ = _e279;
                } else {
                    phi_879_ = abs(_e151);
                }
                let _e304 = phi_879_;
                if (_e151 < 0f) {
                    phi_886_ = (-1f / _e304);
                } else {
                    phi_886_ = (1f / _e304);
                }
                let _e309 = phi_886_;
                let _e313 = abs((bitcast<f32>(_e219) - _e133));
                let _e314 = abs((bitcast<f32>(_e223) - _e135));
                let _e315 = abs((bitcast<f32>(_e227) - _e137));
                let _e319 = abs(((bitcast<f32>(_e231) + (bitcast<f32>((((_e243 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e320 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e243 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                let _e321 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e243 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                if (_e313 > _e319) {
                    phi_903_ = _e313;
                } else {
                    phi_903_ = _e319;
                }
                let _e324 = phi_903_;
                if (_e314 > _e320) {
                    phi_908_ = _e314;
                } else {
                    phi_908_ = _e320;
                }
                let _e327 = phi_908_;
                if (_e315 > _e321) {
                    phi_913_ = _e315;
                } else {
                    phi_913_ = _e321;
                }
                let _e330 = phi_913_;
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
                    phi_934_ = 0u;
                } else {
                    phi_934_ = 1u;
                }
                let _e349 = phi_934_;
                if (_e299 < 0f) {
                    phi_939_ = 0u;
                } else {
                    phi_939_ = 2u;
                }
                let _e352 = phi_939_;
                if (_e309 < 0f) {
                    phi_944_ = 0u;
                } else {
                    phi_944_ = 4u;
                }
                let _e355 = phi_944_;
                let _e357 = ((_e349 | _e352) | _e355);
                let _e358 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e358.first[0], _e358.first[1], _e358.first[2], _e358.first[3], _e358.first[4], _e358.first[5], _e358.first[6], _e358.first[7], _e358.first[8], _e358.first[9], _e358.first[10], _e358.first[11], _e358.first[12], _e358.first[13], _e358.first[14], _e358.first[15], _e358.first[16], _e358.first[17], _e358.first[18], _e358.first[19], _e358.first[20], _e358.first[21], _e358.first[22], _e358.first[23], _e358.first[24], _e358.first[25], _e358.first[26], _e358.first[27], _e358.first[28], _e358.first[29], _e358.first[30], _e358.first[31]), array<u32, 32>(_e358.mask[0], _e358.mask[1], _e358.mask[2], _e358.mask[3], _e358.mask[4], _e358.mask[5], _e358.mask[6], _e358.mask[7], _e358.mask[8], _e358.mask[9], _e358.mask[10], _e358.mask[11], _e358.mask[12], _e358.mask[13], _e358.mask[14], _e358.mask[15], _e358.mask[16], _e358.mask[17], _e358.mask[18], _e358.mask[19], _e358.mask[20], _e358.mask[21], _e358.mask[22], _e358.mask[23], _e358.mask[24], _e358.mask[25], _e358.mask[26], _e358.mask[27], _e358.mask[28], _e358.mask[29], _e358.mask[30], _e358.mask[31]), _e358.len, _e358.group, _e358.group_mask);
                let _e432 = local_2.group_mask;
                if ((_e432 & 4278190080u) == 0u) {
                    let _e436 = local_2.len;
                    if (_e436 == 0u) {
                        phi_1058_ = false;
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
                        phi_1058_ = true;
                    }
                    let _e459 = phi_1058_;
                    phi_1059_ = _e459;
                } else {
                    phi_1059_ = true;
                }
                let _e461 = phi_1059_;
                if _e461 {
                    let _e463 = local_2.group_mask;
                    let _e469 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e463)), 32u, (_e463 == 0u)));
                    let _e473 = local_2.group_mask;
                    let _e487 = local_2.group_mask;
                    local_2.group_mask = (_e487 & ~((1u << bitcast<u32>((_e469 & 31u)))));
                    let _e490 = local_2.group;
                    phi_1090_ = (_e490 + countOneBits(((_e473 & ~((4294967295u << bitcast<u32>((((_e469 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1090_ = 4294967295u;
                }
                let _e493 = phi_1090_;
                phi_1092_ = _e493;
                loop {
                    let _e495 = phi_1092_;
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
                            phi_1173_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e578.unnamed_1.root, _e555.y));
                        } else {
                            let _e594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.unnamed.root, _e555.y), _e594.unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e600.unnamed, lt_bvh_traverse_Tree(_e555.z, _e600.unnamed_1.first_primitive));
                            phi_1173_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_bvh_traverse_Tree(_e606.unnamed_1.root, _e555.w));
                        }
                        let _e614 = phi_1173_;
                        let _e624 = nodes.member[(0u + _e495)].y;
                        if (_e299 < 0f) {
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e635.unnamed.root, _e624.w), _e635.unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_bvh_traverse_Tree(_e624.x, _e641.unnamed_1.first_primitive));
                            phi_1200_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e647.unnamed_1.root, _e624.y));
                        } else {
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.unnamed.root, _e624.y), _e663.unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e624.z, _e669.unnamed_1.first_primitive));
                            phi_1200_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e675.unnamed_1.root, _e624.w));
                        }
                        let _e683 = phi_1200_;
                        let _e693 = nodes.member[(0u + _e495)].z;
                        if (_e309 < 0f) {
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.unnamed.root, _e693.w), _e704.unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_bvh_traverse_Tree(_e693.x, _e710.unnamed_1.first_primitive));
                            phi_1227_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e716.unnamed_1.root, _e693.y));
                        } else {
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.unnamed.root, _e693.y), _e732.unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e693.z, _e738.unnamed_1.first_primitive));
                            phi_1227_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e744.unnamed_1.root, _e693.w));
                        }
                        let _e752 = phi_1227_;
                        phi_1233_ = 0u;
                        phi_1236_ = 0u;
                        loop {
                            let _e762 = phi_1233_;
                            let _e764 = phi_1236_;
                            local_3 = _e764;
                            local_4 = _e764;
                            local_5 = _e764;
                            let _e765 = (_e762 < 8u);
                            if _e765 {
                                let _e767 = (_e762 >> bitcast<u32>(2i));
                                let _e768 = (_e762 & 3u);
                                if (_e767 == 0u) {
                                    phi_1250_ = _e614.unnamed.root;
                                } else {
                                    phi_1250_ = _e614.unnamed.first_primitive;
                                }
                                let _e771 = phi_1250_;
                                if (_e767 == 0u) {
                                    phi_1260_ = _e683.unnamed.root;
                                } else {
                                    phi_1260_ = _e683.unnamed.first_primitive;
                                }
                                let _e780 = phi_1260_;
                                if (_e767 == 0u) {
                                    phi_1270_ = _e752.unnamed.root;
                                } else {
                                    phi_1270_ = _e752.unnamed.first_primitive;
                                }
                                let _e789 = phi_1270_;
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e771 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e337)), ((f32(((_e780 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e338)));
                                let _e803 = core_intrinsics_maximum_number_nsz_f32_(_e802, ((f32(((_e789 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e339)));
                                if (_e767 == 0u) {
                                    phi_1288_ = _e614.unnamed_1.root;
                                } else {
                                    phi_1288_ = _e614.unnamed_1.first_primitive;
                                }
                                let _e806 = phi_1288_;
                                if (_e767 == 0u) {
                                    phi_1298_ = _e683.unnamed_1.root;
                                } else {
                                    phi_1298_ = _e683.unnamed_1.first_primitive;
                                }
                                let _e815 = phi_1298_;
                                if (_e767 == 0u) {
                                    phi_1308_ = _e752.unnamed_1.root;
                                } else {
                                    phi_1308_ = _e752.unnamed_1.first_primitive;
                                }
                                let _e824 = phi_1308_;
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e806 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e337)), ((f32(((_e815 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e338)));
                                let _e838 = core_intrinsics_minimum_number_nsz_f32_(_e837, ((f32(((_e824 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e339)));
                                if (_e803 <= _e838) {
                                    if (_e803 <= _e141) {
                                        if (_e838 >= 0f) {
                                            if (_e767 == 0u) {
                                                let _e845 = nodes.member[(0u + _e495)].links[2u];
                                                phi_1344_ = _e845;
                                            } else {
                                                let _e848 = nodes.member[(0u + _e495)].links[3u];
                                                phi_1344_ = _e848;
                                            }
                                            let _e850 = phi_1344_;
                                            let _e855 = ((_e850 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u);
                                            let _e856 = (_e855 & 31u);
                                            if (_e856 >= 24u) {
                                                phi_1357_ = (24u + ((_e856 - 24u) ^ _e357));
                                            } else {
                                                phi_1357_ = _e856;
                                            }
                                            let _e862 = phi_1357_;
                                            phi_1362_ = (_e764 | ((_e855 >> bitcast<u32>(5i)) << bitcast<u32>((_e862 & 31u))));
                                        } else {
                                            phi_1362_ = _e764;
                                        }
                                        let _e870 = phi_1362_;
                                        phi_1363_ = _e870;
                                    } else {
                                        phi_1363_ = _e764;
                                    }
                                    let _e872 = phi_1363_;
                                    phi_1364_ = _e872;
                                } else {
                                    phi_1364_ = _e764;
                                }
                                let _e874 = phi_1364_;
                                phi_1234_ = (_e762 + 1u);
                                phi_1237_ = _e874;
                            } else {
                                phi_1234_ = u32();
                                phi_1237_ = u32();
                            }
                            let _e877 = phi_1234_;
                            let _e879 = phi_1237_;
                            continue;
                            continuing {
                                phi_1233_ = _e877;
                                phi_1236_ = _e879;
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
                        phi_1422_ = (_e928 & 16777215u);
                        loop {
                            let _e931 = phi_1422_;
                            let _e932 = (_e931 == 0u);
                            local_11 = _e932;
                            local_18 = _e932;
                            if _e932 {
                                phi_1423_ = u32();
                                phi_3183_ = false;
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
                                    phi_1472_ = _e955;
                                } else {
                                    phi_1472_ = _e964;
                                }
                                let _e969 = phi_1472_;
                                if (_e956 < _e965) {
                                    phi_1477_ = _e956;
                                } else {
                                    phi_1477_ = _e965;
                                }
                                let _e972 = phi_1477_;
                                if (_e957 < _e966) {
                                    phi_1482_ = _e957;
                                } else {
                                    phi_1482_ = _e966;
                                }
                                let _e975 = phi_1482_;
                                if (_e955 > _e964) {
                                    phi_1490_ = _e955;
                                } else {
                                    phi_1490_ = _e964;
                                }
                                let _e981 = phi_1490_;
                                if (_e956 > _e965) {
                                    phi_1495_ = _e956;
                                } else {
                                    phi_1495_ = _e965;
                                }
                                let _e984 = phi_1495_;
                                if (_e957 > _e966) {
                                    phi_1500_ = _e957;
                                } else {
                                    phi_1500_ = _e966;
                                }
                                let _e987 = phi_1500_;
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
                                                                        phi_1645_ = bool();
                                                                        phi_1646_ = true;
                                                                    } else {
                                                                        let _e1096 = (_e1087 > 0f);
                                                                        if _e1096 {
                                                                            phi_1644_ = bool();
                                                                        } else {
                                                                            phi_1644_ = (_e1088 > 0f);
                                                                        }
                                                                        let _e1099 = phi_1644_;
                                                                        phi_1645_ = _e1099;
                                                                        phi_1646_ = _e1096;
                                                                    }
                                                                    let _e1101 = phi_1645_;
                                                                    let _e1103 = phi_1646_;
                                                                    if _e1103 {
                                                                        phi_1650_ = true;
                                                                    } else {
                                                                        phi_1650_ = _e1101;
                                                                    }
                                                                    let _e1105 = phi_1650_;
                                                                    phi_1651_ = _e1105;
                                                                    phi_1652_ = false;
                                                                } else {
                                                                    phi_1651_ = bool();
                                                                    phi_1652_ = true;
                                                                }
                                                                let _e1107 = phi_1651_;
                                                                let _e1109 = phi_1652_;
                                                                phi_1653_ = _e1107;
                                                                phi_1654_ = false;
                                                                phi_1655_ = _e1109;
                                                            } else {
                                                                phi_1653_ = bool();
                                                                phi_1654_ = true;
                                                                phi_1655_ = false;
                                                            }
                                                            let _e1111 = phi_1653_;
                                                            let _e1113 = phi_1654_;
                                                            let _e1115 = phi_1655_;
                                                            phi_1656_ = _e1111;
                                                            phi_1657_ = _e1113;
                                                            phi_1658_ = _e1115;
                                                        } else {
                                                            phi_1656_ = bool();
                                                            phi_1657_ = true;
                                                            phi_1658_ = false;
                                                        }
                                                        let _e1117 = phi_1656_;
                                                        let _e1119 = phi_1657_;
                                                        let _e1121 = phi_1658_;
                                                        phi_1659_ = _e1117;
                                                        phi_1660_ = _e1119;
                                                        phi_1661_ = _e1121;
                                                    } else {
                                                        phi_1659_ = bool();
                                                        phi_1660_ = true;
                                                        phi_1661_ = false;
                                                    }
                                                    let _e1123 = phi_1659_;
                                                    let _e1125 = phi_1660_;
                                                    let _e1127 = phi_1661_;
                                                    phi_1662_ = _e1123;
                                                    phi_1663_ = _e1125;
                                                    phi_1664_ = _e1127;
                                                } else {
                                                    phi_1662_ = bool();
                                                    phi_1663_ = true;
                                                    phi_1664_ = false;
                                                }
                                                let _e1129 = phi_1662_;
                                                let _e1131 = phi_1663_;
                                                let _e1133 = phi_1664_;
                                                phi_1665_ = _e1129;
                                                phi_1666_ = _e1131;
                                                phi_1667_ = _e1133;
                                            } else {
                                                phi_1665_ = bool();
                                                phi_1666_ = true;
                                                phi_1667_ = false;
                                            }
                                            let _e1135 = phi_1665_;
                                            let _e1137 = phi_1666_;
                                            let _e1139 = phi_1667_;
                                            if _e1137 {
                                                phi_1671_ = true;
                                            } else {
                                                phi_1671_ = _e1139;
                                            }
                                            let _e1141 = phi_1671_;
                                            if _e1141 {
                                                phi_1675_ = false;
                                            } else {
                                                phi_1675_ = _e1135;
                                            }
                                            let _e1143 = phi_1675_;
                                            if _e1143 {
                                                let _e1144 = (_e1080 >= _e76);
                                                if _e1144 {
                                                    phi_3166_ = bool();
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
                                                        phi_1745_ = _e1210;
                                                    } else {
                                                        phi_1745_ = abs(_e1051);
                                                    }
                                                    let _e1215 = phi_1745_;
                                                    if (_e1051 < 0f) {
                                                        phi_1752_ = (-1f / _e1215);
                                                    } else {
                                                        phi_1752_ = (1f / _e1215);
                                                    }
                                                    let _e1220 = phi_1752_;
                                                    if (abs(_e1064) < _e1210) {
                                                        phi_1759_ = _e1210;
                                                    } else {
                                                        phi_1759_ = abs(_e1064);
                                                    }
                                                    let _e1225 = phi_1759_;
                                                    if (_e1064 < 0f) {
                                                        phi_1766_ = (-1f / _e1225);
                                                    } else {
                                                        phi_1766_ = (1f / _e1225);
                                                    }
                                                    let _e1230 = phi_1766_;
                                                    if (abs(_e1077) < _e1210) {
                                                        phi_1773_ = _e1210;
                                                    } else {
                                                        phi_1773_ = abs(_e1077);
                                                    }
                                                    let _e1235 = phi_1773_;
                                                    if (_e1077 < 0f) {
                                                        phi_1780_ = (-1f / _e1235);
                                                    } else {
                                                        phi_1780_ = (1f / _e1235);
                                                    }
                                                    let _e1240 = phi_1780_;
                                                    let _e1244 = abs((bitcast<f32>(_e1150) - _e1011));
                                                    let _e1245 = abs((bitcast<f32>(_e1154) - _e1024));
                                                    let _e1246 = abs((bitcast<f32>(_e1158) - _e1037));
                                                    let _e1250 = abs(((bitcast<f32>(_e1162) + (bitcast<f32>((((_e1174 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1011));
                                                    let _e1251 = abs(((bitcast<f32>(_e1166) + (bitcast<f32>((((_e1174 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1024));
                                                    let _e1252 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1174 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1037));
                                                    if (_e1244 > _e1250) {
                                                        phi_1797_ = _e1244;
                                                    } else {
                                                        phi_1797_ = _e1250;
                                                    }
                                                    let _e1255 = phi_1797_;
                                                    if (_e1245 > _e1251) {
                                                        phi_1802_ = _e1245;
                                                    } else {
                                                        phi_1802_ = _e1251;
                                                    }
                                                    let _e1258 = phi_1802_;
                                                    if (_e1246 > _e1252) {
                                                        phi_1807_ = _e1246;
                                                    } else {
                                                        phi_1807_ = _e1252;
                                                    }
                                                    let _e1261 = phi_1807_;
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
                                                            phi_1835_ = false;
                                                        } else {
                                                            phi_1835_ = true;
                                                        }
                                                        let _e1284 = phi_1835_;
                                                        phi_1836_ = _e1284;
                                                    } else {
                                                        phi_1836_ = true;
                                                    }
                                                    let _e1286 = phi_1836_;
                                                    if _e1286 {
                                                        if (_e1279 >= _e1280) {
                                                            phi_1844_ = 1u;
                                                        } else {
                                                            phi_1844_ = 2u;
                                                        }
                                                        let _e1289 = phi_1844_;
                                                        phi_1845_ = _e1289;
                                                    } else {
                                                        phi_1845_ = 0u;
                                                    }
                                                    let _e1291 = phi_1845_;
                                                    if (_e1291 == 0u) {
                                                        phi_1857_ = vec3<f32>(_e1064, _e1077, _e1051);
                                                    } else {
                                                        if (_e1291 == 1u) {
                                                            phi_1856_ = vec3<f32>(_e1077, _e1051, _e1064);
                                                        } else {
                                                            phi_1856_ = vec3<f32>(_e1051, _e1064, _e1077);
                                                        }
                                                        let _e1297 = phi_1856_;
                                                        phi_1857_ = _e1297;
                                                    }
                                                    let _e1299 = phi_1857_;
                                                    let _e1302 = (_e1299.x / _e1299.z);
                                                    let _e1305 = (_e1299.y / _e1299.z);
                                                    let _e1307 = (1f / _e1299.z);
                                                    if (_e1220 < 0f) {
                                                        phi_1870_ = 0u;
                                                    } else {
                                                        phi_1870_ = 1u;
                                                    }
                                                    let _e1310 = phi_1870_;
                                                    if (_e1230 < 0f) {
                                                        phi_1875_ = 0u;
                                                    } else {
                                                        phi_1875_ = 2u;
                                                    }
                                                    let _e1313 = phi_1875_;
                                                    if (_e1240 < 0f) {
                                                        phi_1880_ = 0u;
                                                    } else {
                                                        phi_1880_ = 4u;
                                                    }
                                                    let _e1316 = phi_1880_;
                                                    let _e1318 = ((_e1310 | _e1313) | _e1316);
                                                    let _e1319 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1080, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1319.first[0], _e1319.first[1], _e1319.first[2], _e1319.first[3], _e1319.first[4], _e1319.first[5], _e1319.first[6], _e1319.first[7], _e1319.first[8], _e1319.first[9], _e1319.first[10], _e1319.first[11], _e1319.first[12], _e1319.first[13], _e1319.first[14], _e1319.first[15], _e1319.first[16], _e1319.first[17], _e1319.first[18], _e1319.first[19], _e1319.first[20], _e1319.first[21], _e1319.first[22], _e1319.first[23], _e1319.first[24], _e1319.first[25], _e1319.first[26], _e1319.first[27], _e1319.first[28], _e1319.first[29], _e1319.first[30], _e1319.first[31]), array<u32, 32>(_e1319.mask[0], _e1319.mask[1], _e1319.mask[2], _e1319.mask[3], _e1319.mask[4], _e1319.mask[5], _e1319.mask[6], _e1319.mask[7], _e1319.mask[8], _e1319.mask[9], _e1319.mask[10], _e1319.mask[11], _e1319.mask[12], _e1319.mask[13], _e1319.mask[14], _e1319.mask[15], _e1319.mask[16], _e1319.mask[17], _e1319.mask[18], _e1319.mask[19], _e1319.mask[20], _e1319.mask[21], _e1319.mask[22], _e1319.mask[23], _e1319.mask[24], _e1319.mask[25], _e1319.mask[26], _e1319.mask[27], _e1319.mask[28], _e1319.mask[29], _e1319.mask[30], _e1319.mask[31]), _e1319.len, _e1319.group, _e1319.group_mask);
                                                    let _e1393 = local_1.group_mask;
                                                    if ((_e1393 & 4278190080u) == 0u) {
                                                        let _e1397 = local_1.len;
                                                        if (_e1397 == 0u) {
                                                            phi_1994_ = false;
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
                                                            phi_1994_ = true;
                                                        }
                                                        let _e1420 = phi_1994_;
                                                        phi_1995_ = _e1420;
                                                    } else {
                                                        phi_1995_ = true;
                                                    }
                                                    let _e1422 = phi_1995_;
                                                    if _e1422 {
                                                        let _e1424 = local_1.group_mask;
                                                        let _e1430 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1424)), 32u, (_e1424 == 0u)));
                                                        let _e1434 = local_1.group_mask;
                                                        let _e1448 = local_1.group_mask;
                                                        local_1.group_mask = (_e1448 & ~((1u << bitcast<u32>((_e1430 & 31u)))));
                                                        let _e1451 = local_1.group;
                                                        phi_2026_ = (_e1451 + countOneBits(((_e1434 & ~((4294967295u << bitcast<u32>((((_e1430 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2026_ = 4294967295u;
                                                    }
                                                    let _e1454 = phi_2026_;
                                                    phi_2028_ = _e1454;
                                                    loop {
                                                        let _e1456 = phi_2028_;
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
                                                                phi_2109_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1539.unnamed, lt_bvh_traverse_Tree(_e1539.unnamed_1.root, _e1516.y));
                                                            } else {
                                                                let _e1555 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1516.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1561 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1555.unnamed.root, _e1516.y), _e1555.unnamed_1);
                                                                let _e1567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1561.unnamed, lt_bvh_traverse_Tree(_e1516.z, _e1561.unnamed_1.first_primitive));
                                                                phi_2109_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1567.unnamed, lt_bvh_traverse_Tree(_e1567.unnamed_1.root, _e1516.w));
                                                            }
                                                            let _e1575 = phi_2109_;
                                                            let _e1585 = nodes.member[(0u + _e1456)].y;
                                                            if (_e1230 < 0f) {
                                                                let _e1596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1596.unnamed.root, _e1585.w), _e1596.unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1602.unnamed, lt_bvh_traverse_Tree(_e1585.x, _e1602.unnamed_1.first_primitive));
                                                                phi_2136_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_bvh_traverse_Tree(_e1608.unnamed_1.root, _e1585.y));
                                                            } else {
                                                                let _e1624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1624.unnamed.root, _e1585.y), _e1624.unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1630.unnamed, lt_bvh_traverse_Tree(_e1585.z, _e1630.unnamed_1.first_primitive));
                                                                phi_2136_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_bvh_traverse_Tree(_e1636.unnamed_1.root, _e1585.w));
                                                            }
                                                            let _e1644 = phi_2136_;
                                                            let _e1654 = nodes.member[(0u + _e1456)].z;
                                                            if (_e1240 < 0f) {
                                                                let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1665.unnamed.root, _e1654.w), _e1665.unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1671.unnamed, lt_bvh_traverse_Tree(_e1654.x, _e1671.unnamed_1.first_primitive));
                                                                phi_2163_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_bvh_traverse_Tree(_e1677.unnamed_1.root, _e1654.y));
                                                            } else {
                                                                let _e1693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1693.unnamed.root, _e1654.y), _e1693.unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1699.unnamed, lt_bvh_traverse_Tree(_e1654.z, _e1699.unnamed_1.first_primitive));
                                                                phi_2163_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_bvh_traverse_Tree(_e1705.unnamed_1.root, _e1654.w));
                                                            }
                                                            let _e1713 = phi_2163_;
                                                            phi_2169_ = 0u;
                                                            phi_2172_ = 0u;
                                                            loop {
                                                                let _e1723 = phi_2169_;
                                                                let _e1725 = phi_2172_;
                                                                local_6 = _e1725;
                                                                local_7 = _e1725;
                                                                local_8 = _e1725;
                                                                let _e1726 = (_e1723 < 8u);
                                                                if _e1726 {
                                                                    let _e1728 = (_e1723 >> bitcast<u32>(2i));
                                                                    let _e1729 = (_e1723 & 3u);
                                                                    if (_e1728 == 0u) {
                                                                        phi_2186_ = _e1575.unnamed.root;
                                                                    } else {
                                                                        phi_2186_ = _e1575.unnamed.first_primitive;
                                                                    }
                                                                    let _e1732 = phi_2186_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2196_ = _e1644.unnamed.root;
                                                                    } else {
                                                                        phi_2196_ = _e1644.unnamed.first_primitive;
                                                                    }
                                                                    let _e1741 = phi_2196_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2206_ = _e1713.unnamed.root;
                                                                    } else {
                                                                        phi_2206_ = _e1713.unnamed.first_primitive;
                                                                    }
                                                                    let _e1750 = phi_2206_;
                                                                    let _e1763 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1732 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 - _e1268)), ((f32(((_e1741 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 - _e1269)));
                                                                    let _e1764 = core_intrinsics_maximum_number_nsz_f32_(_e1763, ((f32(((_e1750 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 - _e1270)));
                                                                    if (_e1728 == 0u) {
                                                                        phi_2224_ = _e1575.unnamed_1.root;
                                                                    } else {
                                                                        phi_2224_ = _e1575.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1767 = phi_2224_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2234_ = _e1644.unnamed_1.root;
                                                                    } else {
                                                                        phi_2234_ = _e1644.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1776 = phi_2234_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2244_ = _e1713.unnamed_1.root;
                                                                    } else {
                                                                        phi_2244_ = _e1713.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1785 = phi_2244_;
                                                                    let _e1798 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1767 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 + _e1268)), ((f32(((_e1776 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 + _e1269)));
                                                                    let _e1799 = core_intrinsics_minimum_number_nsz_f32_(_e1798, ((f32(((_e1785 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 + _e1270)));
                                                                    if (_e1764 <= _e1799) {
                                                                        if (_e1764 <= _e141) {
                                                                            if (_e1799 >= 0f) {
                                                                                if (_e1728 == 0u) {
                                                                                    let _e1806 = nodes.member[(0u + _e1456)].links[2u];
                                                                                    phi_2280_ = _e1806;
                                                                                } else {
                                                                                    let _e1809 = nodes.member[(0u + _e1456)].links[3u];
                                                                                    phi_2280_ = _e1809;
                                                                                }
                                                                                let _e1811 = phi_2280_;
                                                                                let _e1816 = ((_e1811 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u);
                                                                                let _e1817 = (_e1816 & 31u);
                                                                                if (_e1817 >= 24u) {
                                                                                    phi_2293_ = (24u + ((_e1817 - 24u) ^ _e1318));
                                                                                } else {
                                                                                    phi_2293_ = _e1817;
                                                                                }
                                                                                let _e1823 = phi_2293_;
                                                                                phi_2298_ = (_e1725 | ((_e1816 >> bitcast<u32>(5i)) << bitcast<u32>((_e1823 & 31u))));
                                                                            } else {
                                                                                phi_2298_ = _e1725;
                                                                            }
                                                                            let _e1831 = phi_2298_;
                                                                            phi_2299_ = _e1831;
                                                                        } else {
                                                                            phi_2299_ = _e1725;
                                                                        }
                                                                        let _e1833 = phi_2299_;
                                                                        phi_2300_ = _e1833;
                                                                    } else {
                                                                        phi_2300_ = _e1725;
                                                                    }
                                                                    let _e1835 = phi_2300_;
                                                                    phi_2170_ = (_e1723 + 1u);
                                                                    phi_2173_ = _e1835;
                                                                } else {
                                                                    phi_2170_ = u32();
                                                                    phi_2173_ = u32();
                                                                }
                                                                let _e1838 = phi_2170_;
                                                                let _e1840 = phi_2173_;
                                                                continue;
                                                                continuing {
                                                                    phi_2169_ = _e1838;
                                                                    phi_2172_ = _e1840;
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
                                                            phi_2358_ = (_e1889 & 16777215u);
                                                            loop {
                                                                let _e1892 = phi_2358_;
                                                                let _e1893 = (_e1892 == 0u);
                                                                local_9 = _e1893;
                                                                local_15 = _e1893;
                                                                if _e1893 {
                                                                    phi_2359_ = u32();
                                                                    phi_3069_ = false;
                                                                    phi_3070_ = false;
                                                                    phi_3071_ = false;
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
                                                                        phi_2404_ = vec3<f32>(_e1912, _e1914, _e1910);
                                                                    } else {
                                                                        if (_e1291 == 1u) {
                                                                            phi_2403_ = vec3<f32>(_e1914, _e1910, _e1912);
                                                                        } else {
                                                                            phi_2403_ = (_e1908 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                        }
                                                                        let _e1922 = phi_2403_;
                                                                        phi_2404_ = _e1922;
                                                                    }
                                                                    let _e1924 = phi_2404_;
                                                                    let _e1928 = (_e1924.x - (_e1302 * _e1924.z));
                                                                    let _e1932 = (_e1924.y - (_e1305 * _e1924.z));
                                                                    let _e1936 = triangles.member[(0u + _e1901)].v1_;
                                                                    let _e1938 = (_e1936.x - _e1011);
                                                                    let _e1940 = (_e1936.y - _e1024);
                                                                    let _e1942 = (_e1936.z - _e1037);
                                                                    if (_e1291 == 0u) {
                                                                        phi_2436_ = vec3<f32>(_e1940, _e1942, _e1938);
                                                                    } else {
                                                                        if (_e1291 == 1u) {
                                                                            phi_2435_ = vec3<f32>(_e1942, _e1938, _e1940);
                                                                        } else {
                                                                            phi_2435_ = (_e1936 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                        }
                                                                        let _e1950 = phi_2435_;
                                                                        phi_2436_ = _e1950;
                                                                    }
                                                                    let _e1952 = phi_2436_;
                                                                    let _e1956 = (_e1952.x - (_e1302 * _e1952.z));
                                                                    let _e1960 = (_e1952.y - (_e1305 * _e1952.z));
                                                                    let _e1964 = triangles.member[(0u + _e1901)].v2_;
                                                                    let _e1966 = (_e1964.x - _e1011);
                                                                    let _e1968 = (_e1964.y - _e1024);
                                                                    let _e1970 = (_e1964.z - _e1037);
                                                                    if (_e1291 == 0u) {
                                                                        phi_2468_ = vec3<f32>(_e1968, _e1970, _e1966);
                                                                    } else {
                                                                        if (_e1291 == 1u) {
                                                                            phi_2467_ = vec3<f32>(_e1970, _e1966, _e1968);
                                                                        } else {
                                                                            phi_2467_ = (_e1964 - vec3<f32>(_e1011, _e1024, _e1037));
                                                                        }
                                                                        let _e1978 = phi_2467_;
                                                                        phi_2468_ = _e1978;
                                                                    }
                                                                    let _e1980 = phi_2468_;
                                                                    let _e1984 = (_e1980.x - (_e1302 * _e1980.z));
                                                                    let _e1988 = (_e1980.y - (_e1305 * _e1980.z));
                                                                    if (_e1956 < _e1984) {
                                                                        phi_2489_ = true;
                                                                    } else {
                                                                        if (_e1956 == _e1984) {
                                                                            phi_2488_ = (_e1960 < _e1988);
                                                                        } else {
                                                                            phi_2488_ = false;
                                                                        }
                                                                        let _e1995 = phi_2488_;
                                                                        phi_2489_ = _e1995;
                                                                    }
                                                                    let _e1997 = phi_2489_;
                                                                    if _e1997 {
                                                                        phi_2493_ = _e1988;
                                                                        phi_2494_ = _e1984;
                                                                        phi_2495_ = _e1960;
                                                                        phi_2496_ = _e1956;
                                                                    } else {
                                                                        phi_2493_ = _e1960;
                                                                        phi_2494_ = _e1956;
                                                                        phi_2495_ = _e1988;
                                                                        phi_2496_ = _e1984;
                                                                    }
                                                                    let _e1999 = phi_2493_;
                                                                    let _e2001 = phi_2494_;
                                                                    let _e2003 = phi_2495_;
                                                                    let _e2005 = phi_2496_;
                                                                    let _e2008 = ((_e2005 * _e1999) - (_e2003 * _e2001));
                                                                    if _e1997 {
                                                                        phi_2504_ = -(_e2008);
                                                                    } else {
                                                                        phi_2504_ = _e2008;
                                                                    }
                                                                    let _e2011 = phi_2504_;
                                                                    if (_e1984 < _e1928) {
                                                                        phi_2515_ = true;
                                                                    } else {
                                                                        if (_e1984 == _e1928) {
                                                                            phi_2514_ = (_e1988 < _e1932);
                                                                        } else {
                                                                            phi_2514_ = false;
                                                                        }
                                                                        let _e2016 = phi_2514_;
                                                                        phi_2515_ = _e2016;
                                                                    }
                                                                    let _e2018 = phi_2515_;
                                                                    if _e2018 {
                                                                        phi_2519_ = _e1932;
                                                                        phi_2520_ = _e1928;
                                                                        phi_2521_ = _e1988;
                                                                        phi_2522_ = _e1984;
                                                                    } else {
                                                                        phi_2519_ = _e1988;
                                                                        phi_2520_ = _e1984;
                                                                        phi_2521_ = _e1932;
                                                                        phi_2522_ = _e1928;
                                                                    }
                                                                    let _e2020 = phi_2519_;
                                                                    let _e2022 = phi_2520_;
                                                                    let _e2024 = phi_2521_;
                                                                    let _e2026 = phi_2522_;
                                                                    let _e2029 = ((_e2026 * _e2020) - (_e2024 * _e2022));
                                                                    if _e2018 {
                                                                        phi_2530_ = -(_e2029);
                                                                    } else {
                                                                        phi_2530_ = _e2029;
                                                                    }
                                                                    let _e2032 = phi_2530_;
                                                                    if (_e1928 < _e1956) {
                                                                        phi_2541_ = true;
                                                                    } else {
                                                                        if (_e1928 == _e1956) {
                                                                            phi_2540_ = (_e1932 < _e1960);
                                                                        } else {
                                                                            phi_2540_ = false;
                                                                        }
                                                                        let _e2037 = phi_2540_;
                                                                        phi_2541_ = _e2037;
                                                                    }
                                                                    let _e2039 = phi_2541_;
                                                                    if _e2039 {
                                                                        phi_2545_ = _e1960;
                                                                        phi_2546_ = _e1956;
                                                                        phi_2547_ = _e1932;
                                                                        phi_2548_ = _e1928;
                                                                    } else {
                                                                        phi_2545_ = _e1932;
                                                                        phi_2546_ = _e1928;
                                                                        phi_2547_ = _e1960;
                                                                        phi_2548_ = _e1956;
                                                                    }
                                                                    let _e2041 = phi_2545_;
                                                                    let _e2043 = phi_2546_;
                                                                    let _e2045 = phi_2547_;
                                                                    let _e2047 = phi_2548_;
                                                                    let _e2050 = ((_e2047 * _e2041) - (_e2045 * _e2043));
                                                                    if _e2039 {
                                                                        phi_2556_ = -(_e2050);
                                                                    } else {
                                                                        phi_2556_ = _e2050;
                                                                    }
                                                                    let _e2053 = phi_2556_;
                                                                    if (_e2011 >= 0f) {
                                                                        if (_e2032 >= 0f) {
                                                                            if (_e2053 >= 0f) {
                                                                                phi_2571_ = ((_e2011 + _e2032) + _e2053);
                                                                                phi_2572_ = false;
                                                                            } else {
                                                                                phi_2571_ = f32();
                                                                                phi_2572_ = true;
                                                                            }
                                                                            let _e2060 = phi_2571_;
                                                                            let _e2062 = phi_2572_;
                                                                            phi_2573_ = _e2060;
                                                                            phi_2574_ = _e2062;
                                                                        } else {
                                                                            phi_2573_ = f32();
                                                                            phi_2574_ = true;
                                                                        }
                                                                        let _e2064 = phi_2573_;
                                                                        let _e2066 = phi_2574_;
                                                                        phi_2575_ = _e2064;
                                                                        phi_2576_ = _e2066;
                                                                    } else {
                                                                        phi_2575_ = f32();
                                                                        phi_2576_ = true;
                                                                    }
                                                                    let _e2068 = phi_2575_;
                                                                    let _e2070 = phi_2576_;
                                                                    if _e2070 {
                                                                        if (_e2011 <= 0f) {
                                                                            if (_e2032 <= 0f) {
                                                                                let _e2073 = (_e2053 <= 0f);
                                                                                if _e2073 {
                                                                                }
                                                                                phi_2594_ = ((_e2011 + _e2032) + _e2053);
                                                                                phi_2595_ = false;
                                                                                phi_2596_ = _e2073;
                                                                            } else {
                                                                                phi_2594_ = f32();
                                                                                phi_2595_ = true;
                                                                                phi_2596_ = false;
                                                                            }
                                                                            let _e2077 = phi_2594_;
                                                                            let _e2079 = phi_2595_;
                                                                            let _e2081 = phi_2596_;
                                                                            phi_2597_ = _e2077;
                                                                            phi_2598_ = _e2079;
                                                                            phi_2599_ = _e2081;
                                                                        } else {
                                                                            phi_2597_ = f32();
                                                                            phi_2598_ = true;
                                                                            phi_2599_ = false;
                                                                        }
                                                                        let _e2083 = phi_2597_;
                                                                        let _e2085 = phi_2598_;
                                                                        let _e2087 = phi_2599_;
                                                                        if _e2085 {
                                                                            phi_2603_ = false;
                                                                        } else {
                                                                            phi_2603_ = _e2087;
                                                                        }
                                                                        let _e2089 = phi_2603_;
                                                                        phi_2604_ = _e2083;
                                                                        phi_2605_ = _e2089;
                                                                    } else {
                                                                        phi_2604_ = _e2068;
                                                                        phi_2605_ = true;
                                                                    }
                                                                    let _e2091 = phi_2604_;
                                                                    let _e2093 = phi_2605_;
                                                                    if _e2093 {
                                                                        let _e2094 = (_e2091 == 0f);
                                                                        if _e2094 {
                                                                            phi_2818_ = lt_bvh_triangle_Intersection();
                                                                            phi_2819_ = false;
                                                                        } else {
                                                                            let _e2100 = ((((_e2011 * (_e1307 * _e1924.z)) + (_e2032 * (_e1307 * _e1952.z))) + (_e2053 * (_e1307 * _e1980.z))) / _e2091);
                                                                            if (_e2100 > 0f) {
                                                                                if (_e2100 < _e141) {
                                                                                    let _e2104 = triangles.member[(0u + _e1901)].v0_;
                                                                                    let _e2106 = triangles.member[(0u + _e1901)].v1_;
                                                                                    if (_e2104.x < _e2106.x) {
                                                                                        phi_2639_ = _e2104.x;
                                                                                    } else {
                                                                                        phi_2639_ = _e2106.x;
                                                                                    }
                                                                                    let _e2113 = phi_2639_;
                                                                                    if (_e2104.y < _e2106.y) {
                                                                                        phi_2648_ = _e2104.y;
                                                                                    } else {
                                                                                        phi_2648_ = _e2106.y;
                                                                                    }
                                                                                    let _e2120 = phi_2648_;
                                                                                    if (_e2104.z < _e2106.z) {
                                                                                        phi_2657_ = _e2104.z;
                                                                                    } else {
                                                                                        phi_2657_ = _e2106.z;
                                                                                    }
                                                                                    let _e2127 = phi_2657_;
                                                                                    let _e2129 = triangles.member[(0u + _e1901)].v2_;
                                                                                    if (_e2113 < _e2129.x) {
                                                                                        phi_2666_ = _e2113;
                                                                                    } else {
                                                                                        phi_2666_ = _e2129.x;
                                                                                    }
                                                                                    let _e2134 = phi_2666_;
                                                                                    if (_e2120 < _e2129.y) {
                                                                                        phi_2673_ = _e2120;
                                                                                    } else {
                                                                                        phi_2673_ = _e2129.y;
                                                                                    }
                                                                                    let _e2139 = phi_2673_;
                                                                                    if (_e2127 < _e2129.z) {
                                                                                        phi_2680_ = _e2127;
                                                                                    } else {
                                                                                        phi_2680_ = _e2129.z;
                                                                                    }
                                                                                    let _e2144 = phi_2680_;
                                                                                    let _e2146 = triangles.member[(0u + _e1901)].v0_;
                                                                                    let _e2148 = triangles.member[(0u + _e1901)].v1_;
                                                                                    if (_e2146.x > _e2148.x) {
                                                                                        phi_2693_ = _e2146.x;
                                                                                    } else {
                                                                                        phi_2693_ = _e2148.x;
                                                                                    }
                                                                                    let _e2155 = phi_2693_;
                                                                                    if (_e2146.y > _e2148.y) {
                                                                                        phi_2702_ = _e2146.y;
                                                                                    } else {
                                                                                        phi_2702_ = _e2148.y;
                                                                                    }
                                                                                    let _e2162 = phi_2702_;
                                                                                    if (_e2146.z > _e2148.z) {
                                                                                        phi_2711_ = _e2146.z;
                                                                                    } else {
                                                                                        phi_2711_ = _e2148.z;
                                                                                    }
                                                                                    let _e2169 = phi_2711_;
                                                                                    let _e2171 = triangles.member[(0u + _e1901)].v2_;
                                                                                    if (_e2155 > _e2171.x) {
                                                                                        phi_2720_ = _e2155;
                                                                                    } else {
                                                                                        phi_2720_ = _e2171.x;
                                                                                    }
                                                                                    let _e2176 = phi_2720_;
                                                                                    if (_e2162 > _e2171.y) {
                                                                                        phi_2727_ = _e2162;
                                                                                    } else {
                                                                                        phi_2727_ = _e2171.y;
                                                                                    }
                                                                                    let _e2181 = phi_2727_;
                                                                                    if (_e2169 > _e2171.z) {
                                                                                        phi_2734_ = _e2169;
                                                                                    } else {
                                                                                        phi_2734_ = _e2171.z;
                                                                                    }
                                                                                    let _e2186 = phi_2734_;
                                                                                    let _e2190 = ((_e2134 - _e1011) * _e1220);
                                                                                    let _e2191 = ((_e2139 - _e1024) * _e1230);
                                                                                    let _e2192 = ((_e2144 - _e1037) * _e1240);
                                                                                    let _e2196 = ((_e2176 - _e1011) * _e1220);
                                                                                    let _e2197 = ((_e2181 - _e1024) * _e1230);
                                                                                    let _e2198 = ((_e2186 - _e1037) * _e1240);
                                                                                    if (_e2190 < _e2196) {
                                                                                        phi_2751_ = _e2190;
                                                                                    } else {
                                                                                        phi_2751_ = _e2196;
                                                                                    }
                                                                                    let _e2201 = phi_2751_;
                                                                                    if (_e2191 < _e2197) {
                                                                                        phi_2756_ = _e2191;
                                                                                    } else {
                                                                                        phi_2756_ = _e2197;
                                                                                    }
                                                                                    let _e2204 = phi_2756_;
                                                                                    if (_e2192 < _e2198) {
                                                                                        phi_2761_ = _e2192;
                                                                                    } else {
                                                                                        phi_2761_ = _e2198;
                                                                                    }
                                                                                    let _e2207 = phi_2761_;
                                                                                    if (_e2190 > _e2196) {
                                                                                        phi_2769_ = _e2190;
                                                                                    } else {
                                                                                        phi_2769_ = _e2196;
                                                                                    }
                                                                                    let _e2213 = phi_2769_;
                                                                                    if (_e2191 > _e2197) {
                                                                                        phi_2774_ = _e2191;
                                                                                    } else {
                                                                                        phi_2774_ = _e2197;
                                                                                    }
                                                                                    let _e2216 = phi_2774_;
                                                                                    if (_e2192 > _e2198) {
                                                                                        phi_2779_ = _e2192;
                                                                                    } else {
                                                                                        phi_2779_ = _e2198;
                                                                                    }
                                                                                    let _e2219 = phi_2779_;
                                                                                    let _e2223 = core_intrinsics_maximum_number_nsz_f32_((_e2201 - _e1275), (_e2204 - _e1276));
                                                                                    let _e2224 = core_intrinsics_maximum_number_nsz_f32_(_e2223, (_e2207 - _e1277));
                                                                                    let _e2225 = core_intrinsics_minimum_number_nsz_f32_((_e2213 + _e1275), (_e2216 + _e1276));
                                                                                    let _e2226 = core_intrinsics_minimum_number_nsz_f32_(_e2225, (_e2219 + _e1277));
                                                                                    if (_e2224 > _e992) {
                                                                                        phi_2791_ = _e2224;
                                                                                    } else {
                                                                                        phi_2791_ = _e992;
                                                                                    }
                                                                                    let _e2229 = phi_2791_;
                                                                                    if (_e2226 < _e994) {
                                                                                        phi_2796_ = _e2226;
                                                                                    } else {
                                                                                        phi_2796_ = _e994;
                                                                                    }
                                                                                    let _e2232 = phi_2796_;
                                                                                    if (_e2100 < _e2229) {
                                                                                        phi_2801_ = _e2229;
                                                                                    } else {
                                                                                        phi_2801_ = _e2100;
                                                                                    }
                                                                                    let _e2235 = phi_2801_;
                                                                                    if (_e2235 > _e2232) {
                                                                                        phi_2806_ = _e2232;
                                                                                    } else {
                                                                                        phi_2806_ = _e2235;
                                                                                    }
                                                                                    let _e2238 = phi_2806_;
                                                                                    phi_2811_ = lt_bvh_triangle_Intersection(_e2238, (_e2032 / _e2091), (_e2053 / _e2091), (_e2229 <= _e2232));
                                                                                    phi_2812_ = false;
                                                                                } else {
                                                                                    phi_2811_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2812_ = true;
                                                                                }
                                                                                let _e2244 = phi_2811_;
                                                                                let _e2246 = phi_2812_;
                                                                                phi_2813_ = _e2244;
                                                                                phi_2814_ = _e2246;
                                                                            } else {
                                                                                phi_2813_ = lt_bvh_triangle_Intersection();
                                                                                phi_2814_ = true;
                                                                            }
                                                                            let _e2248 = phi_2813_;
                                                                            let _e2250 = phi_2814_;
                                                                            if _e2250 {
                                                                            }
                                                                            phi_2818_ = _e2248;
                                                                            phi_2819_ = _e2250;
                                                                        }
                                                                        let _e2252 = phi_2818_;
                                                                        let _e2254 = phi_2819_;
                                                                        phi_2820_ = _e2252;
                                                                        phi_2821_ = _e2094;
                                                                        phi_2822_ = _e2254;
                                                                    } else {
                                                                        phi_2820_ = lt_bvh_triangle_Intersection();
                                                                        phi_2821_ = true;
                                                                        phi_2822_ = false;
                                                                    }
                                                                    let _e2256 = phi_2820_;
                                                                    let _e2258 = phi_2821_;
                                                                    let _e2260 = phi_2822_;
                                                                    if _e2258 {
                                                                        phi_2826_ = true;
                                                                    } else {
                                                                        phi_2826_ = _e2260;
                                                                    }
                                                                    let _e2262 = phi_2826_;
                                                                    if _e2262 {
                                                                        phi_2830_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2830_ = _e2256;
                                                                    }
                                                                    let _e2264 = phi_2830_;
                                                                    if _e2264.is_hit {
                                                                        if (_e2264.t > 0f) {
                                                                            if (_e2264.t < _e141) {
                                                                                let _e2271 = triangles.member[(0u + _e1901)].i0_;
                                                                                let _e2273 = ((_e2271 & 2147483648u) == 0u);
                                                                                if _e2273 {
                                                                                    phi_3053_ = false;
                                                                                    phi_3054_ = false;
                                                                                } else {
                                                                                    if (_e1901 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2280 = triangles.member[(0u + _e1901)].i0_;
                                                                                    let _e2281 = (_e2280 & 2147483647u);
                                                                                    let _e2283 = triangles.member[(0u + _e1901)].i1_;
                                                                                    let _e2285 = triangles.member[(0u + _e1901)].i2_;
                                                                                    if (_e2281 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2289 = vertices.member[(0u + _e2281)];
                                                                                    if (_e2283 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2293 = vertices.member[(0u + _e2283)];
                                                                                    if (_e2285 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2297 = vertices.member[(0u + _e2285)];
                                                                                    let _e2298 = array<abi_Vertex, 3>(_e2289, _e2293, _e2297);
                                                                                    if (_e2298[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2304 = materials.member[(0u + _e2298[0].material)];
                                                                                    if ((_e2304.flags & 1u) == 1u) {
                                                                                        let _e2309 = ((1f - _e2264.u) - _e2264.v);
                                                                                        if (_e2304.cutoff <= 0f) {
                                                                                            phi_3047_ = true;
                                                                                        } else {
                                                                                            let _e2336 = (_e2304.base_color.w * ((((f32((_e2298[0].color >> bitcast<u32>(24i))) * _e2309) + (f32((_e2298[1].color >> bitcast<u32>(24i))) * _e2264.u)) + (f32((_e2298[2].color >> bitcast<u32>(24i))) * _e2264.v)) * (1f / 255f)));
                                                                                            if (_e2304.alpha_size == 0u) {
                                                                                                phi_3044_ = _e2336;
                                                                                            } else {
                                                                                                local.offset = _e2304.alpha_offset;
                                                                                                local.size = _e2304.alpha_size;
                                                                                                local.flags = _e2304.flags;
                                                                                                let _e2367 = _lt_shaders_texture_TextureView_quad((&local), (((_e2298[0].u * _e2309) + (_e2298[1].u * _e2264.u)) + (_e2298[2].u * _e2264.v)), (((_e2298[0].v * _e2309) + (_e2298[1].v * _e2264.u)) + (_e2298[2].v * _e2264.v)));
                                                                                                let _e2371 = (_e2367.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2371 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2375 = alpha_texels.member[(0u + _e2371)];
                                                                                                let _e2391 = (_e2367.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2391 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2395 = alpha_texels.member[(0u + _e2391)];
                                                                                                let _e2412 = (_e2367.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2412 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2416 = alpha_texels.member[(0u + _e2412)];
                                                                                                let _e2433 = (_e2367.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2433 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2437 = alpha_texels.member[(0u + _e2433)];
                                                                                                phi_3044_ = (_e2336 * (((((f32(((_e2375 >> bitcast<u32>((((_e2367.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2367.weights.x) + ((f32(((_e2395 >> bitcast<u32>((((_e2367.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2367.weights.y)) + ((f32(((_e2416 >> bitcast<u32>((((_e2367.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2367.weights.z)) + ((f32(((_e2437 >> bitcast<u32>((((_e2367.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2367.weights.w)));
                                                                                            }
                                                                                            let _e2453 = phi_3044_;
                                                                                            phi_3047_ = (_e2453 >= _e2304.cutoff);
                                                                                        }
                                                                                        let _e2457 = phi_3047_;
                                                                                        phi_3048_ = _e2457;
                                                                                    } else {
                                                                                        phi_3048_ = false;
                                                                                    }
                                                                                    let _e2459 = phi_3048_;
                                                                                    if _e2459 {
                                                                                        phi_3052_ = false;
                                                                                    } else {
                                                                                        phi_3052_ = true;
                                                                                    }
                                                                                    let _e2461 = phi_3052_;
                                                                                    phi_3053_ = _e2461;
                                                                                    phi_3054_ = _e2459;
                                                                                }
                                                                                let _e2463 = phi_3053_;
                                                                                let _e2465 = phi_3054_;
                                                                                phi_3055_ = _e2463;
                                                                                phi_3056_ = _e2273;
                                                                                phi_3057_ = _e2465;
                                                                            } else {
                                                                                phi_3055_ = true;
                                                                                phi_3056_ = false;
                                                                                phi_3057_ = false;
                                                                            }
                                                                            let _e2467 = phi_3055_;
                                                                            let _e2469 = phi_3056_;
                                                                            let _e2471 = phi_3057_;
                                                                            phi_3058_ = _e2467;
                                                                            phi_3059_ = _e2469;
                                                                            phi_3060_ = _e2471;
                                                                        } else {
                                                                            phi_3058_ = true;
                                                                            phi_3059_ = false;
                                                                            phi_3060_ = false;
                                                                        }
                                                                        let _e2473 = phi_3058_;
                                                                        let _e2475 = phi_3059_;
                                                                        let _e2477 = phi_3060_;
                                                                        phi_3061_ = _e2473;
                                                                        phi_3062_ = _e2475;
                                                                        phi_3063_ = _e2477;
                                                                    } else {
                                                                        phi_3061_ = true;
                                                                        phi_3062_ = false;
                                                                        phi_3063_ = false;
                                                                    }
                                                                    let _e2479 = phi_3061_;
                                                                    let _e2481 = phi_3062_;
                                                                    let _e2483 = phi_3063_;
                                                                    if _e2479 {
                                                                        phi_3067_ = false;
                                                                        phi_3068_ = false;
                                                                    } else {
                                                                        phi_3067_ = _e2481;
                                                                        phi_3068_ = _e2483;
                                                                    }
                                                                    let _e2485 = phi_3067_;
                                                                    let _e2487 = phi_3068_;
                                                                    phi_2359_ = (_e1892 & (_e1892 - 1u));
                                                                    phi_3069_ = _e2479;
                                                                    phi_3070_ = _e2485;
                                                                    phi_3071_ = _e2487;
                                                                }
                                                                let _e2489 = phi_2359_;
                                                                let _e2491 = phi_3069_;
                                                                let _e2493 = phi_3070_;
                                                                let _e2495 = phi_3071_;
                                                                local_13 = _e2493;
                                                                local_14 = _e2495;
                                                                continue;
                                                                continuing {
                                                                    phi_2358_ = _e2489;
                                                                    break if !(_e2491);
                                                                }
                                                            }
                                                            let _e2498 = local_9;
                                                            if _e2498 {
                                                                let _e2500 = local_1.group_mask;
                                                                if ((_e2500 & 4278190080u) == 0u) {
                                                                    let _e2504 = local_1.len;
                                                                    if (_e2504 == 0u) {
                                                                        phi_3113_ = false;
                                                                    } else {
                                                                        let _e2508 = local_1.len;
                                                                        local_1.len = (_e2508 - 1u);
                                                                        let _e2511 = local_1.len;
                                                                        if (_e2511 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2516 = local_1.first[(0u + _e2511)];
                                                                        local_1.group = _e2516;
                                                                        let _e2519 = local_1.len;
                                                                        if (_e2519 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2524 = local_1.mask[(0u + _e2519)];
                                                                        local_1.group_mask = _e2524;
                                                                        phi_3113_ = true;
                                                                    }
                                                                    let _e2527 = phi_3113_;
                                                                    phi_3114_ = _e2527;
                                                                } else {
                                                                    phi_3114_ = true;
                                                                }
                                                                let _e2529 = phi_3114_;
                                                                if _e2529 {
                                                                    let _e2531 = local_1.group_mask;
                                                                    let _e2537 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2531)), 32u, (_e2531 == 0u)));
                                                                    let _e2541 = local_1.group_mask;
                                                                    let _e2555 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2555 & ~((1u << bitcast<u32>((_e2537 & 31u)))));
                                                                    let _e2558 = local_1.group;
                                                                    phi_3145_ = (_e2558 + countOneBits(((_e2541 & ~((4294967295u << bitcast<u32>((((_e2537 - 24u) ^ _e1318) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3145_ = 4294967295u;
                                                                }
                                                                let _e2561 = phi_3145_;
                                                                phi_3146_ = _e2561;
                                                                phi_3147_ = false;
                                                                phi_3148_ = false;
                                                            } else {
                                                                phi_3146_ = u32();
                                                                let _e2941 = local_13;
                                                                phi_3147_ = _e2941;
                                                                let _e2944 = local_14;
                                                                phi_3148_ = _e2944;
                                                            }
                                                            let _e2563 = phi_3146_;
                                                            let _e2565 = phi_3147_;
                                                            let _e2567 = phi_3148_;
                                                            phi_2029_ = _e2563;
                                                            let _e2948 = local_15;
                                                            phi_3149_ = _e2948;
                                                            phi_3150_ = false;
                                                            phi_3151_ = _e2565;
                                                            phi_3152_ = _e2567;
                                                        } else {
                                                            phi_2029_ = u32();
                                                            phi_3149_ = false;
                                                            phi_3150_ = true;
                                                            phi_3151_ = false;
                                                            phi_3152_ = false;
                                                        }
                                                        let _e2569 = phi_2029_;
                                                        let _e2571 = phi_3149_;
                                                        let _e2573 = phi_3150_;
                                                        let _e2575 = phi_3151_;
                                                        let _e2577 = phi_3152_;
                                                        local_10 = _e2573;
                                                        local_16 = _e2575;
                                                        local_17 = _e2577;
                                                        continue;
                                                        continuing {
                                                            phi_2028_ = _e2569;
                                                            break if !(_e2571);
                                                        }
                                                    }
                                                    let _e2580 = local_10;
                                                    if _e2580 {
                                                        phi_3156_ = false;
                                                        phi_3157_ = false;
                                                    } else {
                                                        let _e2955 = local_16;
                                                        phi_3156_ = _e2955;
                                                        let _e2958 = local_17;
                                                        phi_3157_ = _e2958;
                                                    }
                                                    let _e2582 = phi_3156_;
                                                    let _e2584 = phi_3157_;
                                                    if _e2582 {
                                                        phi_3161_ = true;
                                                    } else {
                                                        phi_3161_ = _e2584;
                                                    }
                                                    let _e2586 = phi_3161_;
                                                    if _e2586 {
                                                        phi_3165_ = true;
                                                    } else {
                                                        phi_3165_ = false;
                                                    }
                                                    let _e2588 = phi_3165_;
                                                    phi_3166_ = _e2588;
                                                }
                                                let _e2590 = phi_3166_;
                                                phi_3167_ = _e2590;
                                                phi_3168_ = _e1144;
                                            } else {
                                                phi_3167_ = bool();
                                                phi_3168_ = true;
                                            }
                                            let _e2592 = phi_3167_;
                                            let _e2594 = phi_3168_;
                                            if _e2594 {
                                                phi_3172_ = false;
                                            } else {
                                                phi_3172_ = _e2592;
                                            }
                                            let _e2596 = phi_3172_;
                                            if _e2596 {
                                                phi_3176_ = false;
                                            } else {
                                                phi_3176_ = true;
                                            }
                                            let _e2598 = phi_3176_;
                                            phi_3177_ = _e2598;
                                        } else {
                                            phi_3177_ = true;
                                        }
                                        let _e2600 = phi_3177_;
                                        phi_3178_ = _e2600;
                                    } else {
                                        phi_3178_ = true;
                                    }
                                    let _e2602 = phi_3178_;
                                    phi_3179_ = _e2602;
                                } else {
                                    phi_3179_ = true;
                                }
                                let _e2604 = phi_3179_;
                                if _e2604 {
                                }
                                phi_1423_ = (_e931 & (_e931 - 1u));
                                phi_3183_ = _e2604;
                            }
                            let _e2606 = phi_1423_;
                            let _e2608 = phi_3183_;
                            continue;
                            continuing {
                                phi_1422_ = _e2606;
                                break if !(_e2608);
                            }
                        }
                        let _e2611 = local_11;
                        if _e2611 {
                            let _e2613 = local_2.group_mask;
                            if ((_e2613 & 4278190080u) == 0u) {
                                let _e2617 = local_2.len;
                                if (_e2617 == 0u) {
                                    phi_3225_ = false;
                                } else {
                                    let _e2621 = local_2.len;
                                    local_2.len = (_e2621 - 1u);
                                    let _e2624 = local_2.len;
                                    if (_e2624 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2629 = local_2.first[(0u + _e2624)];
                                    local_2.group = _e2629;
                                    let _e2632 = local_2.len;
                                    if (_e2632 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2637 = local_2.mask[(0u + _e2632)];
                                    local_2.group_mask = _e2637;
                                    phi_3225_ = true;
                                }
                                let _e2640 = phi_3225_;
                                phi_3226_ = _e2640;
                            } else {
                                phi_3226_ = true;
                            }
                            let _e2642 = phi_3226_;
                            if _e2642 {
                                let _e2644 = local_2.group_mask;
                                let _e2650 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2644)), 32u, (_e2644 == 0u)));
                                let _e2654 = local_2.group_mask;
                                let _e2668 = local_2.group_mask;
                                local_2.group_mask = (_e2668 & ~((1u << bitcast<u32>((_e2650 & 31u)))));
                                let _e2671 = local_2.group;
                                phi_3257_ = (_e2671 + countOneBits(((_e2654 & ~((4294967295u << bitcast<u32>((((_e2650 - 24u) ^ _e357) & 31u))))) & 255u)));
                            } else {
                                phi_3257_ = 4294967295u;
                            }
                            let _e2674 = phi_3257_;
                            phi_3258_ = _e2674;
                        } else {
                            phi_3258_ = u32();
                        }
                        let _e2676 = phi_3258_;
                        phi_1093_ = _e2676;
                        let _e2979 = local_18;
                        phi_3259_ = _e2979;
                        phi_3260_ = false;
                    } else {
                        phi_1093_ = u32();
                        phi_3259_ = false;
                        phi_3260_ = true;
                    }
                    let _e2678 = phi_1093_;
                    let _e2680 = phi_3259_;
                    let _e2682 = phi_3260_;
                    local_12 = _e2682;
                    continue;
                    continuing {
                        phi_1092_ = _e2678;
                        break if !(_e2680);
                    }
                }
                let _e2685 = local_12;
                if _e2685 {
                    phi_3264_ = false;
                } else {
                    phi_3264_ = true;
                }
                let _e2687 = phi_3264_;
                if _e2687 {
                    phi_3268_ = true;
                } else {
                    phi_3268_ = false;
                }
                let _e2689 = phi_3268_;
                phi_3269_ = _e2689;
            }
            let _e2691 = phi_3269_;
            phi_3270_ = _e2691;
            phi_3271_ = _e213;
        } else {
            phi_3270_ = bool();
            phi_3271_ = true;
        }
        let _e2693 = phi_3270_;
        let _e2695 = phi_3271_;
        if _e2695 {
            phi_3275_ = false;
        } else {
            phi_3275_ = _e2693;
        }
        let _e2697 = phi_3275_;
        if _e2697 {
            phi_3279_ = 0f;
        } else {
            phi_3279_ = 1f;
        }
        let _e2699 = phi_3279_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2699;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
