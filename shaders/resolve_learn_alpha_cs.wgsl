struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<f32>,
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

struct type_34 {
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
var<storage> samples: type_20;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;
@group(0) @binding(7) 
var<storage> vertices: type_46;
@group(0) @binding(8) 
var<storage> materials: type_50;
@group(0) @binding(9) 
var<storage> alpha_texels: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_204_: bool;
    var phi_208_: f32;

    if (param != param) {
        phi_204_ = true;
    } else {
        let _e71 = (param_1 >= param);
        if _e71 {
        }
        phi_204_ = _e71;
    }
    let _e73 = phi_204_;
    if _e73 {
        phi_208_ = param_1;
    } else {
        phi_208_ = param;
    }
    let _e75 = phi_208_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_220_: bool;
    var phi_224_: f32;

    if (param_2 != param_2) {
        phi_220_ = true;
    } else {
        let _e71 = (param_3 <= param_2);
        if _e71 {
        }
        phi_220_ = _e71;
    }
    let _e73 = phi_220_;
    if _e73 {
        phi_224_ = param_3;
    } else {
        phi_224_ = param_2;
    }
    let _e75 = phi_224_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_266_: f32;
    var phi_271_: f32;
    var phi_272_: bool;
    var phi_273_: f32;
    var phi_274_: bool;
    var phi_278_: f32;
    var phi_304_: f32;
    var phi_309_: f32;
    var phi_310_: bool;
    var phi_311_: f32;
    var phi_312_: bool;
    var phi_316_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_354_: u32;
    var phi_368_: u32;
    var phi_375_: u32;
    var phi_380_: u32;
    var phi_386_: u32;
    var phi_391_: u32;
    var phi_393_: texture_Axis;
    var phi_421_: f32;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_433_: f32;
    var phi_459_: f32;
    var phi_464_: f32;
    var phi_465_: bool;
    var phi_466_: f32;
    var phi_467_: bool;
    var phi_471_: f32;
    var phi_479_: f32;
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_490_: f32;
    var phi_491_: f32;
    var phi_509_: u32;
    var phi_523_: u32;
    var phi_530_: u32;
    var phi_535_: u32;
    var phi_541_: u32;
    var phi_546_: u32;
    var phi_548_: texture_Axis;

    let _e72 = (*param_4).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_4).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_4).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_4).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_5 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e99 > param_5) {
                phi_266_ = 1f;
            } else {
                phi_266_ = 0f;
            }
            let _e102 = phi_266_;
            if (param_5 < 8388608f) {
                phi_271_ = (_e99 - _e102);
                phi_272_ = false;
            } else {
                phi_271_ = f32();
                phi_272_ = true;
            }
            let _e105 = phi_271_;
            let _e107 = phi_272_;
            phi_273_ = _e105;
            phi_274_ = _e107;
        } else {
            phi_273_ = f32();
            phi_274_ = true;
        }
        let _e109 = phi_273_;
        let _e111 = phi_274_;
        if _e111 {
            phi_278_ = param_5;
        } else {
            phi_278_ = _e109;
        }
        let _e113 = phi_278_;
        phi_326_ = (param_5 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_5 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_304_ = 1f;
                } else {
                    phi_304_ = 0f;
                }
                let _e131 = phi_304_;
                if (_e116 < 8388608f) {
                    phi_309_ = (_e128 - _e131);
                    phi_310_ = false;
                } else {
                    phi_309_ = f32();
                    phi_310_ = true;
                }
                let _e134 = phi_309_;
                let _e136 = phi_310_;
                phi_311_ = _e134;
                phi_312_ = _e136;
            } else {
                phi_311_ = f32();
                phi_312_ = true;
            }
            let _e138 = phi_311_;
            let _e140 = phi_312_;
            if _e140 {
                phi_316_ = _e116;
            } else {
                phi_316_ = _e138;
            }
            let _e142 = phi_316_;
            let _e144 = (param_5 - (2f * _e142));
            if (_e144 > 1f) {
                phi_324_ = (2f - _e144);
            } else {
                phi_324_ = _e144;
            }
            let _e148 = phi_324_;
            phi_325_ = _e148;
        } else {
            phi_325_ = param_5;
        }
        let _e150 = phi_325_;
        phi_326_ = _e150;
    }
    let _e152 = phi_326_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_335_ = _e152;
        } else {
            phi_335_ = 1f;
        }
        let _e156 = phi_335_;
        phi_336_ = _e156;
    } else {
        phi_336_ = 0f;
    }
    let _e158 = phi_336_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_354_ = _e159;
        } else {
            phi_354_ = _e168;
        }
        let _e171 = phi_354_;
        phi_393_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_368_ = _e73;
        } else {
            phi_368_ = _e180;
        }
        let _e183 = phi_368_;
        if (_e86 == 0u) {
            phi_375_ = _e159;
        } else {
            phi_375_ = 0u;
        }
        let _e188 = phi_375_;
        if (_e86 == 0u) {
            phi_380_ = 0u;
        } else {
            phi_380_ = _e159;
        }
        let _e191 = phi_380_;
        if (_e183 == 0u) {
            phi_386_ = _e188;
        } else {
            phi_386_ = (_e183 - 1u);
        }
        let _e195 = phi_386_;
        if (_e183 > _e159) {
            phi_391_ = _e191;
        } else {
            phi_391_ = _e183;
        }
        let _e198 = phi_391_;
        phi_393_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_393_;
    let _e203 = (*param_4).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_6 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e219 > param_6) {
                phi_421_ = 1f;
            } else {
                phi_421_ = 0f;
            }
            let _e222 = phi_421_;
            if (param_6 < 8388608f) {
                phi_426_ = (_e219 - _e222);
                phi_427_ = false;
            } else {
                phi_426_ = f32();
                phi_427_ = true;
            }
            let _e225 = phi_426_;
            let _e227 = phi_427_;
            phi_428_ = _e225;
            phi_429_ = _e227;
        } else {
            phi_428_ = f32();
            phi_429_ = true;
        }
        let _e229 = phi_428_;
        let _e231 = phi_429_;
        if _e231 {
            phi_433_ = param_6;
        } else {
            phi_433_ = _e229;
        }
        let _e233 = phi_433_;
        phi_481_ = (param_6 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_6 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_459_ = 1f;
                } else {
                    phi_459_ = 0f;
                }
                let _e251 = phi_459_;
                if (_e236 < 8388608f) {
                    phi_464_ = (_e248 - _e251);
                    phi_465_ = false;
                } else {
                    phi_464_ = f32();
                    phi_465_ = true;
                }
                let _e254 = phi_464_;
                let _e256 = phi_465_;
                phi_466_ = _e254;
                phi_467_ = _e256;
            } else {
                phi_466_ = f32();
                phi_467_ = true;
            }
            let _e258 = phi_466_;
            let _e260 = phi_467_;
            if _e260 {
                phi_471_ = _e236;
            } else {
                phi_471_ = _e258;
            }
            let _e262 = phi_471_;
            let _e264 = (param_6 - (2f * _e262));
            if (_e264 > 1f) {
                phi_479_ = (2f - _e264);
            } else {
                phi_479_ = _e264;
            }
            let _e268 = phi_479_;
            phi_480_ = _e268;
        } else {
            phi_480_ = param_6;
        }
        let _e270 = phi_480_;
        phi_481_ = _e270;
    }
    let _e272 = phi_481_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_490_ = _e272;
        } else {
            phi_490_ = 1f;
        }
        let _e276 = phi_490_;
        phi_491_ = _e276;
    } else {
        phi_491_ = 0f;
    }
    let _e278 = phi_491_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_509_ = _e279;
        } else {
            phi_509_ = _e288;
        }
        let _e291 = phi_509_;
        phi_548_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_523_ = _e77;
        } else {
            phi_523_ = _e300;
        }
        let _e303 = phi_523_;
        if (_e206 == 0u) {
            phi_530_ = _e279;
        } else {
            phi_530_ = 0u;
        }
        let _e308 = phi_530_;
        if (_e206 == 0u) {
            phi_535_ = 0u;
        } else {
            phi_535_ = _e279;
        }
        let _e311 = phi_535_;
        if (_e303 == 0u) {
            phi_541_ = _e308;
        } else {
            phi_541_ = (_e303 - 1u);
        }
        let _e315 = phi_541_;
        if (_e303 > _e279) {
            phi_546_ = _e311;
        } else {
            phi_546_ = _e303;
        }
        let _e318 = phi_546_;
        phi_548_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_548_;
    let _e325 = (*param_4).offset;
    let _e332 = (*param_4).offset;
    let _e339 = (*param_4).offset;
    let _e346 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_689_: f32;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_727_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_747_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_774_: bool;
    var phi_844_: f32;
    var phi_851_: f32;
    var phi_858_: f32;
    var phi_865_: f32;
    var phi_872_: f32;
    var phi_879_: f32;
    var phi_896_: f32;
    var phi_901_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_916_: f32;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_963_: vec3<f32>;
    var phi_964_: vec3<f32>;
    var phi_977_: u32;
    var phi_982_: u32;
    var phi_987_: u32;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1133_: u32;
    var phi_1135_: u32;
    var phi_1138_: bool;
    var phi_1218_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1245_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1272_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1278_: u32;
    var phi_1281_: u32;
    var phi_1295_: u32;
    var phi_1305_: u32;
    var phi_1315_: u32;
    var phi_1333_: u32;
    var phi_1343_: u32;
    var phi_1353_: u32;
    var phi_1389_: u32;
    var phi_1402_: u32;
    var phi_1407_: u32;
    var phi_1408_: u32;
    var phi_1409_: u32;
    var phi_1279_: u32;
    var phi_1282_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1467_: u32;
    var phi_1470_: bool;
    var phi_1514_: vec3<f32>;
    var phi_1515_: vec3<f32>;
    var phi_1544_: vec3<f32>;
    var phi_1545_: vec3<f32>;
    var phi_1574_: vec3<f32>;
    var phi_1575_: vec3<f32>;
    var phi_1593_: bool;
    var phi_1594_: bool;
    var phi_1598_: f32;
    var phi_1599_: f32;
    var phi_1600_: f32;
    var phi_1601_: f32;
    var phi_1609_: f32;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1624_: f32;
    var phi_1625_: f32;
    var phi_1626_: f32;
    var phi_1627_: f32;
    var phi_1635_: f32;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1652_: f32;
    var phi_1653_: f32;
    var phi_1661_: f32;
    var phi_1676_: f32;
    var phi_1677_: bool;
    var phi_1678_: f32;
    var phi_1679_: bool;
    var phi_1680_: f32;
    var phi_1681_: bool;
    var phi_1699_: f32;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1702_: f32;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_1708_: bool;
    var phi_1709_: f32;
    var phi_1710_: bool;
    var phi_1738_: vec3<f32>;
    var phi_1739_: vec3<f32>;
    var phi_1764_: vec3<f32>;
    var phi_1765_: vec3<f32>;
    var phi_1790_: vec3<f32>;
    var phi_1791_: vec3<f32>;
    var phi_1847_: f32;
    var phi_1856_: f32;
    var phi_1865_: f32;
    var phi_1874_: f32;
    var phi_1881_: f32;
    var phi_1888_: f32;
    var phi_1901_: f32;
    var phi_1910_: f32;
    var phi_1919_: f32;
    var phi_1928_: f32;
    var phi_1935_: f32;
    var phi_1942_: f32;
    var phi_1959_: f32;
    var phi_1964_: f32;
    var phi_1969_: f32;
    var phi_1977_: f32;
    var phi_1982_: f32;
    var phi_1987_: f32;
    var phi_1999_: f32;
    var phi_2004_: f32;
    var phi_2009_: f32;
    var phi_2014_: f32;
    var phi_2019_: lt_bvh_triangle_Intersection;
    var phi_2020_: bool;
    var phi_2021_: lt_bvh_triangle_Intersection;
    var phi_2022_: bool;
    var phi_2026_: lt_bvh_triangle_Intersection;
    var phi_2027_: bool;
    var phi_2028_: lt_bvh_triangle_Intersection;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2034_: bool;
    var phi_2038_: lt_bvh_triangle_Intersection;
    var phi_2252_: f32;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2263_: bool;
    var phi_2264_: bool;
    var phi_2265_: bool;
    var phi_2266_: bool;
    var phi_2267_: bool;
    var phi_2268_: bool;
    var phi_2269_: bool;
    var phi_2270_: bool;
    var phi_1468_: u32;
    var phi_1471_: bool;
    var phi_2274_: bool;
    var phi_2275_: bool;
    var local_5: bool;
    var phi_2317_: bool;
    var phi_2318_: bool;
    var phi_2349_: u32;
    var phi_2350_: u32;
    var phi_1136_: u32;
    var phi_1139_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var local_6: bool;
    var phi_2357_: bool;
    var phi_2361_: bool;
    var phi_2362_: bool;
    var phi_2363_: bool;
    var phi_2364_: bool;
    var phi_2368_: bool;
    var phi_2372_: f32;
    var phi_2413_: u32;
    var phi_2432_: u32;
    var phi_2440_: u32;
    var phi_2448_: u32;
    var phi_2453_: u32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e70 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&visibility.member));
    let _e86 = arrayLength((&list.member));
    let _e89 = arrayLength((&bits.member));
    let _e92 = arrayLength((&vertices.member));
    let _e98 = arrayLength((&alpha_texels.member));
    let _e102 = ((_e70.y * 2097152u) + _e70.x);
    if (3u < _e86) {
    } else {
        return;
    }
    let _e105 = list.member[3u];
    if (_e102 < _e105) {
        let _e107 = (_e102 + 4u);
        if (_e107 < _e86) {
        } else {
            return;
        }
        let _e111 = list.member[(0u + _e107)];
        let _e112 = (_e111 & 2147483647u);
        if (_e112 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e118 = samples.member[(0u + _e112)].position;
        let _e120 = samples.member[(0u + _e112)].normal;
        let _e122 = samples.member[(0u + _e112)].magnitude;
        let _e124 = ((8f / 8388608f) * _e122);
        let _e132 = (_e118.x + (_e120.x * _e124));
        let _e134 = (_e118.y + (_e120.y * _e124));
        let _e136 = (_e118.z + (_e120.z * _e124));
        let _e138 = p.member.light.place;
        if (_e138.w == 0f) {
            phi_689_ = 300000000000000000000000000000000000000f;
        } else {
            phi_689_ = 1f;
        }
        let _e142 = phi_689_;
        let _e150 = (_e138.x - (_e132 * _e138.w));
        let _e151 = (_e138.y - (_e134 * _e138.w));
        let _e152 = (_e138.z - (_e136 * _e138.w));
        let _e154 = abs(_e150);
        let _e155 = abs(_e151);
        let _e156 = abs(_e152);
        if (abs(_e132) < 1000000000000000f) {
            if (abs(_e134) < 1000000000000000f) {
                phi_720_ = (abs(_e136) < 1000000000000000f);
                phi_721_ = false;
            } else {
                phi_720_ = bool();
                phi_721_ = true;
            }
            let _e164 = phi_720_;
            let _e166 = phi_721_;
            phi_722_ = _e164;
            phi_723_ = _e166;
        } else {
            phi_722_ = bool();
            phi_723_ = true;
        }
        let _e168 = phi_722_;
        let _e170 = phi_723_;
        if _e170 {
            phi_727_ = false;
        } else {
            phi_727_ = _e168;
        }
        let _e172 = phi_727_;
        if _e172 {
            if (_e154 < 1000000000000000f) {
                if (_e155 < 1000000000000000f) {
                    phi_740_ = (_e156 < 1000000000000000f);
                    phi_741_ = false;
                } else {
                    phi_740_ = bool();
                    phi_741_ = true;
                }
                let _e177 = phi_740_;
                let _e179 = phi_741_;
                phi_742_ = _e177;
                phi_743_ = _e179;
            } else {
                phi_742_ = bool();
                phi_743_ = true;
            }
            let _e181 = phi_742_;
            let _e183 = phi_743_;
            if _e183 {
                phi_747_ = false;
            } else {
                phi_747_ = _e181;
            }
            let _e185 = phi_747_;
            if _e185 {
                if (_e154 > 0f) {
                    phi_761_ = bool();
                    phi_762_ = true;
                } else {
                    let _e187 = (_e155 > 0f);
                    if _e187 {
                        phi_760_ = bool();
                    } else {
                        phi_760_ = (_e156 > 0f);
                    }
                    let _e190 = phi_760_;
                    phi_761_ = _e190;
                    phi_762_ = _e187;
                }
                let _e192 = phi_761_;
                let _e194 = phi_762_;
                if _e194 {
                    phi_766_ = true;
                } else {
                    phi_766_ = _e192;
                }
                let _e196 = phi_766_;
                phi_767_ = _e196;
                phi_768_ = false;
            } else {
                phi_767_ = bool();
                phi_768_ = true;
            }
            let _e198 = phi_767_;
            let _e200 = phi_768_;
            phi_769_ = _e198;
            phi_770_ = _e200;
        } else {
            phi_769_ = bool();
            phi_770_ = true;
        }
        let _e202 = phi_769_;
        let _e204 = phi_770_;
        if _e204 {
            phi_774_ = false;
        } else {
            phi_774_ = _e202;
        }
        let _e206 = phi_774_;
        if _e206 {
            let _e207 = (0u >= _e77);
            if _e207 {
                phi_2362_ = bool();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e213 = nodes.member[(0u + 0u)].frame[0u];
                let _e217 = nodes.member[(0u + 0u)].frame[1u];
                let _e221 = nodes.member[(0u + 0u)].frame[2u];
                let _e225 = nodes.member[(0u + 0u)].frame[0u];
                let _e229 = nodes.member[(0u + 0u)].frame[1u];
                let _e233 = nodes.member[(0u + 0u)].frame[2u];
                let _e237 = nodes.member[(0u + 0u)].frame[3u];
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150), abs(_e151));
                let _e272 = core_intrinsics_maximum_number_nsz_f32_(_e271, abs(_e152));
                let _e273 = (_e272 * 0.0000000000009094947f);
                if (abs(_e150) < _e273) {
                    phi_844_ = _e273;
                } else {
                    phi_844_ = abs(_e150);
                }
                let _e278 = phi_844_;
                if (_e150 < 0f) {
                    phi_851_ = (-1f / _e278);
                } else {
                    phi_851_ = (1f / _e278);
                }
                let _e283 = phi_851_;
                if (abs(_e151) < _e273) {
                    phi_858_ = _e273;
                } else {
                    phi_858_ = abs(_e151);
                }
                let _e288 = phi_858_;
                if (_e151 < 0f) {
                    phi_865_ = (-1f / _e288);
                } else {
                    phi_865_ = (1f / _e288);
                }
                let _e293 = phi_865_;
                if (abs(_e152) < _e273) {
                    phi_872_ = _e273;
                } else {
                    phi_872_ = abs(_e152);
                }
                let _e298 = phi_872_;
                if (_e152 < 0f) {
                    phi_879_ = (-1f / _e298);
                } else {
                    phi_879_ = (1f / _e298);
                }
                let _e303 = phi_879_;
                let _e307 = abs((bitcast<f32>(_e213) - _e132));
                let _e308 = abs((bitcast<f32>(_e217) - _e134));
                let _e309 = abs((bitcast<f32>(_e221) - _e136));
                let _e313 = abs(((bitcast<f32>(_e225) + (bitcast<f32>((((_e237 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e132));
                let _e314 = abs(((bitcast<f32>(_e229) + (bitcast<f32>((((_e237 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e134));
                let _e315 = abs(((bitcast<f32>(_e233) + (bitcast<f32>((((_e237 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e136));
                if (_e307 > _e313) {
                    phi_896_ = _e307;
                } else {
                    phi_896_ = _e313;
                }
                let _e318 = phi_896_;
                if (_e308 > _e314) {
                    phi_901_ = _e308;
                } else {
                    phi_901_ = _e314;
                }
                let _e321 = phi_901_;
                if (_e309 > _e315) {
                    phi_906_ = _e309;
                } else {
                    phi_906_ = _e315;
                }
                let _e324 = phi_906_;
                if (_e318 > _e321) {
                    phi_911_ = _e318;
                } else {
                    phi_911_ = _e321;
                }
                let _e327 = phi_911_;
                if (_e327 > _e324) {
                    phi_916_ = _e327;
                } else {
                    phi_916_ = _e324;
                }
                let _e330 = phi_916_;
                let _e334 = (_e330 * 0.0000019073486f);
                let _e335 = (abs(_e283) * _e334);
                let _e336 = (abs(_e293) * _e334);
                let _e337 = (abs(_e303) * _e334);
                let _e341 = (_e330 * 0.0000009536743f);
                let _e342 = (abs(_e283) * _e341);
                let _e343 = (abs(_e293) * _e341);
                let _e344 = (abs(_e303) * _e341);
                let _e345 = abs(_e150);
                let _e346 = abs(_e151);
                let _e347 = abs(_e152);
                if (_e345 >= _e346) {
                    if (_e345 >= _e347) {
                        phi_942_ = false;
                    } else {
                        phi_942_ = true;
                    }
                    let _e351 = phi_942_;
                    phi_943_ = _e351;
                } else {
                    phi_943_ = true;
                }
                let _e353 = phi_943_;
                if _e353 {
                    if (_e346 >= _e347) {
                        phi_951_ = 1u;
                    } else {
                        phi_951_ = 2u;
                    }
                    let _e356 = phi_951_;
                    phi_952_ = _e356;
                } else {
                    phi_952_ = 0u;
                }
                let _e358 = phi_952_;
                if (_e358 == 0u) {
                    phi_964_ = vec3<f32>(_e151, _e152, _e150);
                } else {
                    if (_e358 == 1u) {
                        phi_963_ = vec3<f32>(_e152, _e150, _e151);
                    } else {
                        phi_963_ = vec3<f32>(_e150, _e151, _e152);
                    }
                    let _e364 = phi_963_;
                    phi_964_ = _e364;
                }
                let _e366 = phi_964_;
                let _e369 = (_e366.x / _e366.z);
                let _e372 = (_e366.y / _e366.z);
                if (_e283 < 0f) {
                    phi_977_ = 0u;
                } else {
                    phi_977_ = 1u;
                }
                let _e377 = phi_977_;
                if (_e293 < 0f) {
                    phi_982_ = 0u;
                } else {
                    phi_982_ = 2u;
                }
                let _e380 = phi_982_;
                if (_e303 < 0f) {
                    phi_987_ = 0u;
                } else {
                    phi_987_ = 4u;
                }
                let _e383 = phi_987_;
                let _e385 = ((_e377 | _e380) | _e383);
                let _e386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e386.first[0], _e386.first[1], _e386.first[2], _e386.first[3], _e386.first[4], _e386.first[5], _e386.first[6], _e386.first[7], _e386.first[8], _e386.first[9], _e386.first[10], _e386.first[11], _e386.first[12], _e386.first[13], _e386.first[14], _e386.first[15], _e386.first[16], _e386.first[17], _e386.first[18], _e386.first[19], _e386.first[20], _e386.first[21], _e386.first[22], _e386.first[23], _e386.first[24], _e386.first[25], _e386.first[26], _e386.first[27], _e386.first[28], _e386.first[29], _e386.first[30], _e386.first[31]), array<u32, 32>(_e386.mask[0], _e386.mask[1], _e386.mask[2], _e386.mask[3], _e386.mask[4], _e386.mask[5], _e386.mask[6], _e386.mask[7], _e386.mask[8], _e386.mask[9], _e386.mask[10], _e386.mask[11], _e386.mask[12], _e386.mask[13], _e386.mask[14], _e386.mask[15], _e386.mask[16], _e386.mask[17], _e386.mask[18], _e386.mask[19], _e386.mask[20], _e386.mask[21], _e386.mask[22], _e386.mask[23], _e386.mask[24], _e386.mask[25], _e386.mask[26], _e386.mask[27], _e386.mask[28], _e386.mask[29], _e386.mask[30], _e386.mask[31]), _e386.len, _e386.group, _e386.group_mask);
                let _e460 = local_1.group_mask;
                if ((_e460 & 4278190080u) == 0u) {
                    let _e464 = local_1.len;
                    if (_e464 == 0u) {
                        phi_1101_ = false;
                    } else {
                        let _e468 = local_1.len;
                        local_1.len = (_e468 - 1u);
                        let _e471 = local_1.len;
                        if (_e471 < 32u) {
                        } else {
                            return;
                        }
                        let _e476 = local_1.first[(0u + _e471)];
                        local_1.group = _e476;
                        let _e479 = local_1.len;
                        if (_e479 < 32u) {
                        } else {
                            return;
                        }
                        let _e484 = local_1.mask[(0u + _e479)];
                        local_1.group_mask = _e484;
                        phi_1101_ = true;
                    }
                    let _e487 = phi_1101_;
                    phi_1102_ = _e487;
                } else {
                    phi_1102_ = true;
                }
                let _e489 = phi_1102_;
                if _e489 {
                    let _e491 = local_1.group_mask;
                    let _e497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e491)), 32u, (_e491 == 0u)));
                    let _e501 = local_1.group_mask;
                    let _e515 = local_1.group_mask;
                    local_1.group_mask = (_e515 & ~((1u << bitcast<u32>((_e497 & 31u)))));
                    let _e518 = local_1.group;
                    phi_1133_ = (_e518 + countOneBits(((_e501 & ~((4294967295u << bitcast<u32>((((_e497 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1133_ = 4294967295u;
                }
                let _e521 = phi_1133_;
                phi_1135_ = _e521;
                phi_1138_ = false;
                loop {
                    let _e523 = phi_1135_;
                    let _e525 = phi_1138_;
                    local_11 = _e525;
                    if (_e523 != 4294967295u) {
                        if (_e523 < _e77) {
                        } else {
                            return;
                        }
                        let _e532 = nodes.member[(0u + _e523)].frame[3u];
                        let _e557 = (bitcast<f32>((((_e532 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e283);
                        let _e558 = (bitcast<f32>((((_e532 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e293);
                        let _e559 = (bitcast<f32>((((_e532 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e562 = nodes.member[(0u + _e523)].frame[0u];
                        let _e566 = nodes.member[(0u + _e523)].frame[1u];
                        let _e570 = nodes.member[(0u + _e523)].frame[2u];
                        let _e575 = ((bitcast<f32>(_e562) - _e132) * _e283);
                        let _e576 = ((bitcast<f32>(_e566) - _e134) * _e293);
                        let _e577 = ((bitcast<f32>(_e570) - _e136) * _e303);
                        let _e585 = nodes.member[(0u + _e523)].x;
                        if (_e283 < 0f) {
                            let _e596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e585.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e596.unnamed.root, _e585.w), _e596.unnamed_1);
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e602.unnamed, lt_bvh_traverse_Tree(_e585.x, _e602.unnamed_1.first_primitive));
                            phi_1218_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e608.unnamed, lt_bvh_traverse_Tree(_e608.unnamed_1.root, _e585.y));
                        } else {
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e585.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.unnamed.root, _e585.y), _e624.unnamed_1);
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_bvh_traverse_Tree(_e585.z, _e630.unnamed_1.first_primitive));
                            phi_1218_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e636.unnamed, lt_bvh_traverse_Tree(_e636.unnamed_1.root, _e585.w));
                        }
                        let _e644 = phi_1218_;
                        let _e654 = nodes.member[(0u + _e523)].y;
                        if (_e293 < 0f) {
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e665.unnamed.root, _e654.w), _e665.unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e654.x, _e671.unnamed_1.first_primitive));
                            phi_1245_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_bvh_traverse_Tree(_e677.unnamed_1.root, _e654.y));
                        } else {
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.unnamed.root, _e654.y), _e693.unnamed_1);
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_bvh_traverse_Tree(_e654.z, _e699.unnamed_1.first_primitive));
                            phi_1245_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_bvh_traverse_Tree(_e705.unnamed_1.root, _e654.w));
                        }
                        let _e713 = phi_1245_;
                        let _e723 = nodes.member[(0u + _e523)].z;
                        if (_e303 < 0f) {
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e734.unnamed.root, _e723.w), _e734.unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e723.x, _e740.unnamed_1.first_primitive));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_bvh_traverse_Tree(_e746.unnamed_1.root, _e723.y));
                        } else {
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e762.unnamed.root, _e723.y), _e762.unnamed_1);
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_bvh_traverse_Tree(_e723.z, _e768.unnamed_1.first_primitive));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_bvh_traverse_Tree(_e774.unnamed_1.root, _e723.w));
                        }
                        let _e782 = phi_1272_;
                        phi_1278_ = 0u;
                        phi_1281_ = 0u;
                        loop {
                            let _e792 = phi_1278_;
                            let _e794 = phi_1281_;
                            local_2 = _e794;
                            local_3 = _e794;
                            local_4 = _e794;
                            let _e795 = (_e792 < 8u);
                            if _e795 {
                                let _e797 = (_e792 >> bitcast<u32>(2i));
                                let _e798 = (_e792 & 3u);
                                if (_e797 == 0u) {
                                    phi_1295_ = _e644.unnamed.root;
                                } else {
                                    phi_1295_ = _e644.unnamed.first_primitive;
                                }
                                let _e801 = phi_1295_;
                                if (_e797 == 0u) {
                                    phi_1305_ = _e713.unnamed.root;
                                } else {
                                    phi_1305_ = _e713.unnamed.first_primitive;
                                }
                                let _e810 = phi_1305_;
                                if (_e797 == 0u) {
                                    phi_1315_ = _e782.unnamed.root;
                                } else {
                                    phi_1315_ = _e782.unnamed.first_primitive;
                                }
                                let _e819 = phi_1315_;
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e801 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e335)), ((f32(((_e810 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e336)));
                                let _e833 = core_intrinsics_maximum_number_nsz_f32_(_e832, ((f32(((_e819 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e559) + (_e577 - _e337)));
                                if (_e797 == 0u) {
                                    phi_1333_ = _e644.unnamed_1.root;
                                } else {
                                    phi_1333_ = _e644.unnamed_1.first_primitive;
                                }
                                let _e836 = phi_1333_;
                                if (_e797 == 0u) {
                                    phi_1343_ = _e713.unnamed_1.root;
                                } else {
                                    phi_1343_ = _e713.unnamed_1.first_primitive;
                                }
                                let _e845 = phi_1343_;
                                if (_e797 == 0u) {
                                    phi_1353_ = _e782.unnamed_1.root;
                                } else {
                                    phi_1353_ = _e782.unnamed_1.first_primitive;
                                }
                                let _e854 = phi_1353_;
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e836 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e335)), ((f32(((_e845 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e336)));
                                let _e868 = core_intrinsics_minimum_number_nsz_f32_(_e867, ((f32(((_e854 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e559) + (_e577 + _e337)));
                                if (_e833 <= _e868) {
                                    if (_e833 <= _e142) {
                                        if (_e868 >= 0f) {
                                            if (_e797 == 0u) {
                                                let _e875 = nodes.member[(0u + _e523)].links[2u];
                                                phi_1389_ = _e875;
                                            } else {
                                                let _e878 = nodes.member[(0u + _e523)].links[3u];
                                                phi_1389_ = _e878;
                                            }
                                            let _e880 = phi_1389_;
                                            let _e885 = ((_e880 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u);
                                            let _e886 = (_e885 & 31u);
                                            if (_e886 >= 24u) {
                                                phi_1402_ = (24u + ((_e886 - 24u) ^ _e385));
                                            } else {
                                                phi_1402_ = _e886;
                                            }
                                            let _e892 = phi_1402_;
                                            phi_1407_ = (_e794 | ((_e885 >> bitcast<u32>(5i)) << bitcast<u32>((_e892 & 31u))));
                                        } else {
                                            phi_1407_ = _e794;
                                        }
                                        let _e900 = phi_1407_;
                                        phi_1408_ = _e900;
                                    } else {
                                        phi_1408_ = _e794;
                                    }
                                    let _e902 = phi_1408_;
                                    phi_1409_ = _e902;
                                } else {
                                    phi_1409_ = _e794;
                                }
                                let _e904 = phi_1409_;
                                phi_1279_ = (_e792 + 1u);
                                phi_1282_ = _e904;
                            } else {
                                phi_1279_ = u32();
                                phi_1282_ = u32();
                            }
                            let _e907 = phi_1279_;
                            let _e909 = phi_1282_;
                            continue;
                            continuing {
                                phi_1278_ = _e907;
                                phi_1281_ = _e909;
                                break if !(_e795);
                            }
                        }
                        let _e913 = nodes.member[(0u + _e523)].links[0u];
                        let _e917 = nodes.member[(0u + _e523)].frame[3u];
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
                        phi_1467_ = (_e958 & 16777215u);
                        phi_1470_ = _e525;
                        loop {
                            let _e961 = phi_1467_;
                            let _e963 = phi_1470_;
                            local_7 = _e963;
                            let _e964 = (_e961 == 0u);
                            local_5 = _e964;
                            local_9 = _e964;
                            if _e964 {
                                phi_1468_ = u32();
                                phi_1471_ = bool();
                                phi_2274_ = bool();
                                phi_2275_ = false;
                            } else {
                                let _e967 = nodes.member[(0u + _e523)].links[1u];
                                let _e972 = ((0u + _e967) + select(firstTrailingBit(_e961), 32u, (_e961 == 0u)));
                                if (_e972 < _e80) {
                                } else {
                                    return;
                                }
                                let _e979 = triangles.member[(0u + _e972)].v0_;
                                let _e981 = (_e979.x - _e132);
                                let _e983 = (_e979.y - _e134);
                                let _e985 = (_e979.z - _e136);
                                if (_e358 == 0u) {
                                    phi_1515_ = vec3<f32>(_e983, _e985, _e981);
                                } else {
                                    if (_e358 == 1u) {
                                        phi_1514_ = vec3<f32>(_e985, _e981, _e983);
                                    } else {
                                        phi_1514_ = (_e979 - vec3<f32>(_e132, _e134, _e136));
                                    }
                                    let _e993 = phi_1514_;
                                    phi_1515_ = _e993;
                                }
                                let _e995 = phi_1515_;
                                let _e999 = (_e995.x - (_e369 * _e995.z));
                                let _e1003 = (_e995.y - (_e372 * _e995.z));
                                let _e1005 = triangles.member[(0u + _e972)].v1_;
                                let _e1007 = (_e1005.x - _e132);
                                let _e1009 = (_e1005.y - _e134);
                                let _e1011 = (_e1005.z - _e136);
                                if (_e358 == 0u) {
                                    phi_1545_ = vec3<f32>(_e1009, _e1011, _e1007);
                                } else {
                                    if (_e358 == 1u) {
                                        phi_1544_ = vec3<f32>(_e1011, _e1007, _e1009);
                                    } else {
                                        phi_1544_ = (_e1005 - vec3<f32>(_e132, _e134, _e136));
                                    }
                                    let _e1019 = phi_1544_;
                                    phi_1545_ = _e1019;
                                }
                                let _e1021 = phi_1545_;
                                let _e1025 = (_e1021.x - (_e369 * _e1021.z));
                                let _e1029 = (_e1021.y - (_e372 * _e1021.z));
                                let _e1031 = triangles.member[(0u + _e972)].v2_;
                                let _e1033 = (_e1031.x - _e132);
                                let _e1035 = (_e1031.y - _e134);
                                let _e1037 = (_e1031.z - _e136);
                                if (_e358 == 0u) {
                                    phi_1575_ = vec3<f32>(_e1035, _e1037, _e1033);
                                } else {
                                    if (_e358 == 1u) {
                                        phi_1574_ = vec3<f32>(_e1037, _e1033, _e1035);
                                    } else {
                                        phi_1574_ = (_e1031 - vec3<f32>(_e132, _e134, _e136));
                                    }
                                    let _e1045 = phi_1574_;
                                    phi_1575_ = _e1045;
                                }
                                let _e1047 = phi_1575_;
                                let _e1051 = (_e1047.x - (_e369 * _e1047.z));
                                let _e1055 = (_e1047.y - (_e372 * _e1047.z));
                                if (_e1025 < _e1051) {
                                    phi_1594_ = true;
                                } else {
                                    if (_e1025 == _e1051) {
                                        phi_1593_ = (_e1029 < _e1055);
                                    } else {
                                        phi_1593_ = false;
                                    }
                                    let _e1060 = phi_1593_;
                                    phi_1594_ = _e1060;
                                }
                                let _e1062 = phi_1594_;
                                if _e1062 {
                                    phi_1598_ = _e1055;
                                    phi_1599_ = _e1051;
                                    phi_1600_ = _e1029;
                                    phi_1601_ = _e1025;
                                } else {
                                    phi_1598_ = _e1029;
                                    phi_1599_ = _e1025;
                                    phi_1600_ = _e1055;
                                    phi_1601_ = _e1051;
                                }
                                let _e1064 = phi_1598_;
                                let _e1066 = phi_1599_;
                                let _e1068 = phi_1600_;
                                let _e1070 = phi_1601_;
                                let _e1073 = ((_e1070 * _e1064) - (_e1068 * _e1066));
                                if _e1062 {
                                    phi_1609_ = -(_e1073);
                                } else {
                                    phi_1609_ = _e1073;
                                }
                                let _e1076 = phi_1609_;
                                if (_e1051 < _e999) {
                                    phi_1620_ = true;
                                } else {
                                    if (_e1051 == _e999) {
                                        phi_1619_ = (_e1055 < _e1003);
                                    } else {
                                        phi_1619_ = false;
                                    }
                                    let _e1081 = phi_1619_;
                                    phi_1620_ = _e1081;
                                }
                                let _e1083 = phi_1620_;
                                if _e1083 {
                                    phi_1624_ = _e1003;
                                    phi_1625_ = _e999;
                                    phi_1626_ = _e1055;
                                    phi_1627_ = _e1051;
                                } else {
                                    phi_1624_ = _e1055;
                                    phi_1625_ = _e1051;
                                    phi_1626_ = _e1003;
                                    phi_1627_ = _e999;
                                }
                                let _e1085 = phi_1624_;
                                let _e1087 = phi_1625_;
                                let _e1089 = phi_1626_;
                                let _e1091 = phi_1627_;
                                let _e1094 = ((_e1091 * _e1085) - (_e1089 * _e1087));
                                if _e1083 {
                                    phi_1635_ = -(_e1094);
                                } else {
                                    phi_1635_ = _e1094;
                                }
                                let _e1097 = phi_1635_;
                                if (_e999 < _e1025) {
                                    phi_1646_ = true;
                                } else {
                                    if (_e999 == _e1025) {
                                        phi_1645_ = (_e1003 < _e1029);
                                    } else {
                                        phi_1645_ = false;
                                    }
                                    let _e1102 = phi_1645_;
                                    phi_1646_ = _e1102;
                                }
                                let _e1104 = phi_1646_;
                                if _e1104 {
                                    phi_1650_ = _e1029;
                                    phi_1651_ = _e1025;
                                    phi_1652_ = _e1003;
                                    phi_1653_ = _e999;
                                } else {
                                    phi_1650_ = _e1003;
                                    phi_1651_ = _e999;
                                    phi_1652_ = _e1029;
                                    phi_1653_ = _e1025;
                                }
                                let _e1106 = phi_1650_;
                                let _e1108 = phi_1651_;
                                let _e1110 = phi_1652_;
                                let _e1112 = phi_1653_;
                                let _e1115 = ((_e1112 * _e1106) - (_e1110 * _e1108));
                                if _e1104 {
                                    phi_1661_ = -(_e1115);
                                } else {
                                    phi_1661_ = _e1115;
                                }
                                let _e1118 = phi_1661_;
                                if (_e1076 >= 0f) {
                                    if (_e1097 >= 0f) {
                                        if (_e1118 >= 0f) {
                                            phi_1676_ = ((_e1076 + _e1097) + _e1118);
                                            phi_1677_ = false;
                                        } else {
                                            phi_1676_ = f32();
                                            phi_1677_ = true;
                                        }
                                        let _e1125 = phi_1676_;
                                        let _e1127 = phi_1677_;
                                        phi_1678_ = _e1125;
                                        phi_1679_ = _e1127;
                                    } else {
                                        phi_1678_ = f32();
                                        phi_1679_ = true;
                                    }
                                    let _e1129 = phi_1678_;
                                    let _e1131 = phi_1679_;
                                    phi_1680_ = _e1129;
                                    phi_1681_ = _e1131;
                                } else {
                                    phi_1680_ = f32();
                                    phi_1681_ = true;
                                }
                                let _e1133 = phi_1680_;
                                let _e1135 = phi_1681_;
                                if _e1135 {
                                    if (_e1076 <= 0f) {
                                        if (_e1097 <= 0f) {
                                            let _e1138 = (_e1118 <= 0f);
                                            if _e1138 {
                                            }
                                            phi_1699_ = ((_e1076 + _e1097) + _e1118);
                                            phi_1700_ = false;
                                            phi_1701_ = _e1138;
                                        } else {
                                            phi_1699_ = f32();
                                            phi_1700_ = true;
                                            phi_1701_ = false;
                                        }
                                        let _e1142 = phi_1699_;
                                        let _e1144 = phi_1700_;
                                        let _e1146 = phi_1701_;
                                        phi_1702_ = _e1142;
                                        phi_1703_ = _e1144;
                                        phi_1704_ = _e1146;
                                    } else {
                                        phi_1702_ = f32();
                                        phi_1703_ = true;
                                        phi_1704_ = false;
                                    }
                                    let _e1148 = phi_1702_;
                                    let _e1150 = phi_1703_;
                                    let _e1152 = phi_1704_;
                                    if _e1150 {
                                        phi_1708_ = false;
                                    } else {
                                        phi_1708_ = _e1152;
                                    }
                                    let _e1154 = phi_1708_;
                                    phi_1709_ = _e1148;
                                    phi_1710_ = _e1154;
                                } else {
                                    phi_1709_ = _e1133;
                                    phi_1710_ = true;
                                }
                                let _e1156 = phi_1709_;
                                let _e1158 = phi_1710_;
                                if _e1158 {
                                    let _e1159 = (_e1156 == 0f);
                                    if _e1159 {
                                        phi_2026_ = lt_bvh_triangle_Intersection();
                                        phi_2027_ = false;
                                    } else {
                                        let _e1161 = triangles.member[(0u + _e972)].v0_;
                                        let _e1163 = (_e1161.x - _e132);
                                        let _e1165 = (_e1161.y - _e134);
                                        let _e1167 = (_e1161.z - _e136);
                                        if (_e358 == 0u) {
                                            phi_1739_ = vec3<f32>(_e1165, _e1167, _e1163);
                                        } else {
                                            if (_e358 == 1u) {
                                                phi_1738_ = vec3<f32>(_e1167, _e1163, _e1165);
                                            } else {
                                                phi_1738_ = (_e1161 - vec3<f32>(_e132, _e134, _e136));
                                            }
                                            let _e1175 = phi_1738_;
                                            phi_1739_ = _e1175;
                                        }
                                        let _e1177 = phi_1739_;
                                        let _e1179 = triangles.member[(0u + _e972)].v1_;
                                        let _e1181 = triangles.member[(0u + _e972)].v0_;
                                        let _e1184 = (_e1179.x - _e1181.x);
                                        let _e1187 = (_e1179.y - _e1181.y);
                                        let _e1190 = (_e1179.z - _e1181.z);
                                        if (_e358 == 0u) {
                                            phi_1765_ = vec3<f32>(_e1187, _e1190, _e1184);
                                        } else {
                                            if (_e358 == 1u) {
                                                phi_1764_ = vec3<f32>(_e1190, _e1184, _e1187);
                                            } else {
                                                phi_1764_ = (_e1179 - _e1181);
                                            }
                                            let _e1197 = phi_1764_;
                                            phi_1765_ = _e1197;
                                        }
                                        let _e1199 = phi_1765_;
                                        let _e1201 = triangles.member[(0u + _e972)].v2_;
                                        let _e1203 = triangles.member[(0u + _e972)].v0_;
                                        let _e1206 = (_e1201.x - _e1203.x);
                                        let _e1209 = (_e1201.y - _e1203.y);
                                        let _e1212 = (_e1201.z - _e1203.z);
                                        if (_e358 == 0u) {
                                            phi_1791_ = vec3<f32>(_e1209, _e1212, _e1206);
                                        } else {
                                            if (_e358 == 1u) {
                                                phi_1790_ = vec3<f32>(_e1212, _e1206, _e1209);
                                            } else {
                                                phi_1790_ = (_e1201 - _e1203);
                                            }
                                            let _e1219 = phi_1790_;
                                            phi_1791_ = _e1219;
                                        }
                                        let _e1221 = phi_1791_;
                                        let _e1228 = ((_e1199.y * _e1221.z) - (_e1199.z * _e1221.y));
                                        let _e1235 = ((_e1199.z * _e1221.x) - (_e1199.x * _e1221.z));
                                        let _e1242 = ((_e1199.x * _e1221.y) - (_e1199.y * _e1221.x));
                                        let _e1256 = (((1f / _e366.z) * (((_e1228 * _e1177.x) + (_e1235 * _e1177.y)) + (_e1242 * _e1177.z))) / (((_e1228 * _e369) + (_e1235 * _e372)) + _e1242));
                                        if (_e1256 > 0f) {
                                            if (_e1256 < _e142) {
                                                let _e1260 = triangles.member[(0u + _e972)].v0_;
                                                let _e1262 = triangles.member[(0u + _e972)].v1_;
                                                if (_e1260.x < _e1262.x) {
                                                    phi_1847_ = _e1260.x;
                                                } else {
                                                    phi_1847_ = _e1262.x;
                                                }
                                                let _e1269 = phi_1847_;
                                                if (_e1260.y < _e1262.y) {
                                                    phi_1856_ = _e1260.y;
                                                } else {
                                                    phi_1856_ = _e1262.y;
                                                }
                                                let _e1276 = phi_1856_;
                                                if (_e1260.z < _e1262.z) {
                                                    phi_1865_ = _e1260.z;
                                                } else {
                                                    phi_1865_ = _e1262.z;
                                                }
                                                let _e1283 = phi_1865_;
                                                let _e1285 = triangles.member[(0u + _e972)].v2_;
                                                if (_e1269 < _e1285.x) {
                                                    phi_1874_ = _e1269;
                                                } else {
                                                    phi_1874_ = _e1285.x;
                                                }
                                                let _e1290 = phi_1874_;
                                                if (_e1276 < _e1285.y) {
                                                    phi_1881_ = _e1276;
                                                } else {
                                                    phi_1881_ = _e1285.y;
                                                }
                                                let _e1295 = phi_1881_;
                                                if (_e1283 < _e1285.z) {
                                                    phi_1888_ = _e1283;
                                                } else {
                                                    phi_1888_ = _e1285.z;
                                                }
                                                let _e1300 = phi_1888_;
                                                let _e1302 = triangles.member[(0u + _e972)].v0_;
                                                let _e1304 = triangles.member[(0u + _e972)].v1_;
                                                if (_e1302.x > _e1304.x) {
                                                    phi_1901_ = _e1302.x;
                                                } else {
                                                    phi_1901_ = _e1304.x;
                                                }
                                                let _e1311 = phi_1901_;
                                                if (_e1302.y > _e1304.y) {
                                                    phi_1910_ = _e1302.y;
                                                } else {
                                                    phi_1910_ = _e1304.y;
                                                }
                                                let _e1318 = phi_1910_;
                                                if (_e1302.z > _e1304.z) {
                                                    phi_1919_ = _e1302.z;
                                                } else {
                                                    phi_1919_ = _e1304.z;
                                                }
                                                let _e1325 = phi_1919_;
                                                let _e1327 = triangles.member[(0u + _e972)].v2_;
                                                if (_e1311 > _e1327.x) {
                                                    phi_1928_ = _e1311;
                                                } else {
                                                    phi_1928_ = _e1327.x;
                                                }
                                                let _e1332 = phi_1928_;
                                                if (_e1318 > _e1327.y) {
                                                    phi_1935_ = _e1318;
                                                } else {
                                                    phi_1935_ = _e1327.y;
                                                }
                                                let _e1337 = phi_1935_;
                                                if (_e1325 > _e1327.z) {
                                                    phi_1942_ = _e1325;
                                                } else {
                                                    phi_1942_ = _e1327.z;
                                                }
                                                let _e1342 = phi_1942_;
                                                let _e1346 = ((_e1290 - _e132) * _e283);
                                                let _e1347 = ((_e1295 - _e134) * _e293);
                                                let _e1348 = ((_e1300 - _e136) * _e303);
                                                let _e1352 = ((_e1332 - _e132) * _e283);
                                                let _e1353 = ((_e1337 - _e134) * _e293);
                                                let _e1354 = ((_e1342 - _e136) * _e303);
                                                if (_e1346 < _e1352) {
                                                    phi_1959_ = _e1346;
                                                } else {
                                                    phi_1959_ = _e1352;
                                                }
                                                let _e1357 = phi_1959_;
                                                if (_e1347 < _e1353) {
                                                    phi_1964_ = _e1347;
                                                } else {
                                                    phi_1964_ = _e1353;
                                                }
                                                let _e1360 = phi_1964_;
                                                if (_e1348 < _e1354) {
                                                    phi_1969_ = _e1348;
                                                } else {
                                                    phi_1969_ = _e1354;
                                                }
                                                let _e1363 = phi_1969_;
                                                if (_e1346 > _e1352) {
                                                    phi_1977_ = _e1346;
                                                } else {
                                                    phi_1977_ = _e1352;
                                                }
                                                let _e1369 = phi_1977_;
                                                if (_e1347 > _e1353) {
                                                    phi_1982_ = _e1347;
                                                } else {
                                                    phi_1982_ = _e1353;
                                                }
                                                let _e1372 = phi_1982_;
                                                if (_e1348 > _e1354) {
                                                    phi_1987_ = _e1348;
                                                } else {
                                                    phi_1987_ = _e1354;
                                                }
                                                let _e1375 = phi_1987_;
                                                let _e1379 = core_intrinsics_maximum_number_nsz_f32_((_e1357 - _e342), (_e1360 - _e343));
                                                let _e1380 = core_intrinsics_maximum_number_nsz_f32_(_e1379, (_e1363 - _e344));
                                                let _e1381 = core_intrinsics_minimum_number_nsz_f32_((_e1369 + _e342), (_e1372 + _e343));
                                                let _e1382 = core_intrinsics_minimum_number_nsz_f32_(_e1381, (_e1375 + _e344));
                                                if (_e1380 > -300000000000000000000000000000000000000f) {
                                                    phi_1999_ = _e1380;
                                                } else {
                                                    phi_1999_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1385 = phi_1999_;
                                                if (_e1382 < 300000000000000000000000000000000000000f) {
                                                    phi_2004_ = _e1382;
                                                } else {
                                                    phi_2004_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1388 = phi_2004_;
                                                if (_e1256 < _e1385) {
                                                    phi_2009_ = _e1385;
                                                } else {
                                                    phi_2009_ = _e1256;
                                                }
                                                let _e1391 = phi_2009_;
                                                if (_e1391 > _e1388) {
                                                    phi_2014_ = _e1388;
                                                } else {
                                                    phi_2014_ = _e1391;
                                                }
                                                let _e1394 = phi_2014_;
                                                phi_2019_ = lt_bvh_triangle_Intersection(_e1394, (_e1097 / _e1156), (_e1118 / _e1156), (_e1385 <= _e1388));
                                                phi_2020_ = false;
                                            } else {
                                                phi_2019_ = lt_bvh_triangle_Intersection();
                                                phi_2020_ = true;
                                            }
                                            let _e1400 = phi_2019_;
                                            let _e1402 = phi_2020_;
                                            phi_2021_ = _e1400;
                                            phi_2022_ = _e1402;
                                        } else {
                                            phi_2021_ = lt_bvh_triangle_Intersection();
                                            phi_2022_ = true;
                                        }
                                        let _e1404 = phi_2021_;
                                        let _e1406 = phi_2022_;
                                        if _e1406 {
                                        }
                                        phi_2026_ = _e1404;
                                        phi_2027_ = _e1406;
                                    }
                                    let _e1408 = phi_2026_;
                                    let _e1410 = phi_2027_;
                                    phi_2028_ = _e1408;
                                    phi_2029_ = _e1159;
                                    phi_2030_ = _e1410;
                                } else {
                                    phi_2028_ = lt_bvh_triangle_Intersection();
                                    phi_2029_ = true;
                                    phi_2030_ = false;
                                }
                                let _e1412 = phi_2028_;
                                let _e1414 = phi_2029_;
                                let _e1416 = phi_2030_;
                                if _e1414 {
                                    phi_2034_ = true;
                                } else {
                                    phi_2034_ = _e1416;
                                }
                                let _e1418 = phi_2034_;
                                if _e1418 {
                                    phi_2038_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2038_ = _e1412;
                                }
                                let _e1420 = phi_2038_;
                                if _e1420.is_hit {
                                    if (_e1420.t > 0f) {
                                        if (_e1420.t < _e142) {
                                            let _e1427 = triangles.member[(0u + _e972)].i0_;
                                            if ((_e1427 & 2147483648u) == 0u) {
                                                phi_2257_ = true;
                                            } else {
                                                if (_e972 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1436 = triangles.member[(0u + _e972)].i0_;
                                                let _e1437 = (_e1436 & 2147483647u);
                                                let _e1439 = triangles.member[(0u + _e972)].i1_;
                                                let _e1441 = triangles.member[(0u + _e972)].i2_;
                                                if (_e1437 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1445 = vertices.member[(0u + _e1437)];
                                                if (_e1439 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1449 = vertices.member[(0u + _e1439)];
                                                if (_e1441 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1453 = vertices.member[(0u + _e1441)];
                                                let _e1454 = array<abi_Vertex, 3>(_e1445, _e1449, _e1453);
                                                if (_e1454[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1460 = materials.member[(0u + _e1454[0].material)];
                                                if ((_e1460.flags & 1u) == 1u) {
                                                    let _e1465 = ((1f - _e1420.u) - _e1420.v);
                                                    if (_e1460.cutoff <= 0f) {
                                                        phi_2255_ = true;
                                                    } else {
                                                        let _e1492 = (_e1460.base_color.w * ((((f32((_e1454[0].color >> bitcast<u32>(24i))) * _e1465) + (f32((_e1454[1].color >> bitcast<u32>(24i))) * _e1420.u)) + (f32((_e1454[2].color >> bitcast<u32>(24i))) * _e1420.v)) * (1f / 255f)));
                                                        if (_e1460.alpha_size == 0u) {
                                                            phi_2252_ = _e1492;
                                                        } else {
                                                            local.offset = _e1460.alpha_offset;
                                                            local.size = _e1460.alpha_size;
                                                            local.flags = _e1460.flags;
                                                            let _e1523 = _lt_shaders_texture_TextureView_quad((&local), (((_e1454[0].u * _e1465) + (_e1454[1].u * _e1420.u)) + (_e1454[2].u * _e1420.v)), (((_e1454[0].v * _e1465) + (_e1454[1].v * _e1420.u)) + (_e1454[2].v * _e1420.v)));
                                                            let _e1527 = (_e1523.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1527 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1531 = alpha_texels.member[(0u + _e1527)];
                                                            let _e1547 = (_e1523.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1547 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1551 = alpha_texels.member[(0u + _e1547)];
                                                            let _e1568 = (_e1523.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1568 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1572 = alpha_texels.member[(0u + _e1568)];
                                                            let _e1589 = (_e1523.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1589 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1593 = alpha_texels.member[(0u + _e1589)];
                                                            phi_2252_ = (_e1492 * (((((f32(((_e1531 >> bitcast<u32>((((_e1523.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1523.weights.x) + ((f32(((_e1551 >> bitcast<u32>((((_e1523.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1523.weights.y)) + ((f32(((_e1572 >> bitcast<u32>((((_e1523.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1523.weights.z)) + ((f32(((_e1593 >> bitcast<u32>((((_e1523.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1523.weights.w)));
                                                        }
                                                        let _e1609 = phi_2252_;
                                                        phi_2255_ = (_e1609 >= _e1460.cutoff);
                                                    }
                                                    let _e1613 = phi_2255_;
                                                    phi_2256_ = _e1613;
                                                } else {
                                                    phi_2256_ = false;
                                                }
                                                let _e1615 = phi_2256_;
                                                phi_2257_ = _e1615;
                                            }
                                            let _e1617 = phi_2257_;
                                            if _e1617 {
                                                phi_2261_ = false;
                                            } else {
                                                phi_2261_ = true;
                                            }
                                            let _e1619 = phi_2261_;
                                            phi_2262_ = _e1617;
                                            phi_2263_ = _e1617;
                                            phi_2264_ = _e1619;
                                        } else {
                                            phi_2262_ = bool();
                                            phi_2263_ = _e963;
                                            phi_2264_ = true;
                                        }
                                        let _e1621 = phi_2262_;
                                        let _e1623 = phi_2263_;
                                        let _e1625 = phi_2264_;
                                        phi_2265_ = _e1621;
                                        phi_2266_ = _e1623;
                                        phi_2267_ = _e1625;
                                    } else {
                                        phi_2265_ = bool();
                                        phi_2266_ = _e963;
                                        phi_2267_ = true;
                                    }
                                    let _e1627 = phi_2265_;
                                    let _e1629 = phi_2266_;
                                    let _e1631 = phi_2267_;
                                    phi_2268_ = _e1627;
                                    phi_2269_ = _e1629;
                                    phi_2270_ = _e1631;
                                } else {
                                    phi_2268_ = bool();
                                    phi_2269_ = _e963;
                                    phi_2270_ = true;
                                }
                                let _e1633 = phi_2268_;
                                let _e1635 = phi_2269_;
                                let _e1637 = phi_2270_;
                                if _e1637 {
                                }
                                phi_1468_ = (_e961 & (_e961 - 1u));
                                phi_1471_ = _e1635;
                                phi_2274_ = _e1633;
                                phi_2275_ = _e1637;
                            }
                            let _e1639 = phi_1468_;
                            let _e1641 = phi_1471_;
                            let _e1643 = phi_2274_;
                            let _e1645 = phi_2275_;
                            local_8 = _e1643;
                            continue;
                            continuing {
                                phi_1467_ = _e1639;
                                phi_1470_ = _e1641;
                                break if !(_e1645);
                            }
                        }
                        let _e1648 = local_5;
                        if _e1648 {
                            let _e1650 = local_1.group_mask;
                            if ((_e1650 & 4278190080u) == 0u) {
                                let _e1654 = local_1.len;
                                if (_e1654 == 0u) {
                                    phi_2317_ = false;
                                } else {
                                    let _e1658 = local_1.len;
                                    local_1.len = (_e1658 - 1u);
                                    let _e1661 = local_1.len;
                                    if (_e1661 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1666 = local_1.first[(0u + _e1661)];
                                    local_1.group = _e1666;
                                    let _e1669 = local_1.len;
                                    if (_e1669 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1674 = local_1.mask[(0u + _e1669)];
                                    local_1.group_mask = _e1674;
                                    phi_2317_ = true;
                                }
                                let _e1677 = phi_2317_;
                                phi_2318_ = _e1677;
                            } else {
                                phi_2318_ = true;
                            }
                            let _e1679 = phi_2318_;
                            if _e1679 {
                                let _e1681 = local_1.group_mask;
                                let _e1687 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1681)), 32u, (_e1681 == 0u)));
                                let _e1691 = local_1.group_mask;
                                let _e1705 = local_1.group_mask;
                                local_1.group_mask = (_e1705 & ~((1u << bitcast<u32>((_e1687 & 31u)))));
                                let _e1708 = local_1.group;
                                phi_2349_ = (_e1708 + countOneBits(((_e1691 & ~((4294967295u << bitcast<u32>((((_e1687 - 24u) ^ _e385) & 31u))))) & 255u)));
                            } else {
                                phi_2349_ = 4294967295u;
                            }
                            let _e1711 = phi_2349_;
                            phi_2350_ = _e1711;
                        } else {
                            phi_2350_ = u32();
                        }
                        let _e1713 = phi_2350_;
                        phi_1136_ = _e1713;
                        let _e2009 = local_7;
                        phi_1139_ = _e2009;
                        let _e2012 = local_8;
                        phi_2351_ = _e2012;
                        let _e2015 = local_9;
                        phi_2352_ = _e2015;
                        phi_2353_ = false;
                    } else {
                        phi_1136_ = u32();
                        phi_1139_ = bool();
                        phi_2351_ = bool();
                        phi_2352_ = false;
                        phi_2353_ = true;
                    }
                    let _e1715 = phi_1136_;
                    let _e1717 = phi_1139_;
                    let _e1719 = phi_2351_;
                    let _e1721 = phi_2352_;
                    let _e1723 = phi_2353_;
                    local_6 = _e1723;
                    local_10 = _e1719;
                    continue;
                    continuing {
                        phi_1135_ = _e1715;
                        phi_1138_ = _e1717;
                        break if !(_e1721);
                    }
                }
                let _e1726 = local_6;
                if _e1726 {
                    phi_2357_ = false;
                } else {
                    phi_2357_ = true;
                }
                let _e1728 = phi_2357_;
                if _e1728 {
                    let _e2021 = local_10;
                    phi_2361_ = _e2021;
                } else {
                    let _e2023 = local_11;
                    phi_2361_ = _e2023;
                }
                let _e1730 = phi_2361_;
                phi_2362_ = _e1730;
            }
            let _e1732 = phi_2362_;
            phi_2363_ = _e1732;
            phi_2364_ = _e207;
        } else {
            phi_2363_ = bool();
            phi_2364_ = true;
        }
        let _e1734 = phi_2363_;
        let _e1736 = phi_2364_;
        if _e1736 {
            phi_2368_ = false;
        } else {
            phi_2368_ = _e1734;
        }
        let _e1738 = phi_2368_;
        if _e1738 {
            phi_2372_ = 0f;
        } else {
            phi_2372_ = 1f;
        }
        let _e1740 = phi_2372_;
        if (_e112 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e112)] = _e1740;
        let _e1746 = p.member.light.number;
        let _e1747 = (_e1746 * 3u);
        let _e1748 = (_e1747 / 32u);
        let _e1749 = (_e1747 % 32u);
        let _e1751 = p.member.light.mask_words;
        if (_e112 < _e83) {
        } else {
            return;
        }
        let _e1755 = visibility.member[(0u + _e112)];
        let _e1757 = ((_e112 * _e1751) + _e1748);
        if (_e1749 > 29u) {
            let _e1759 = (_e1757 + 1u);
            if (_e1759 < _e89) {
            } else {
                return;
            }
            let _e1763 = bits.member[(0u + _e1759)];
            phi_2413_ = _e1763;
        } else {
            phi_2413_ = 0u;
        }
        let _e1765 = phi_2413_;
        if (_e1757 < _e89) {
        } else {
            return;
        }
        let _e1769 = bits.member[(0u + _e1757)];
        let _e1772 = (_e1769 >> bitcast<u32>((_e1749 & 31u)));
        if (_e1749 > 29u) {
            phi_2432_ = (_e1772 | (_e1765 << bitcast<u32>(((32u - _e1749) & 31u))));
        } else {
            phi_2432_ = _e1772;
        }
        let _e1780 = phi_2432_;
        if ((_e1780 & 2u) == 0u) {
            phi_2440_ = (_e1780 & 1u);
        } else {
            phi_2440_ = (_e1780 & 7u);
        }
        let _e1786 = phi_2440_;
        if ((_e1786 & 1u) != 0u) {
            phi_2448_ = (2u | 1u);
        } else {
            phi_2448_ = 2u;
        }
        let _e1792 = phi_2448_;
        if (_e1755 < 0.5f) {
            phi_2453_ = (_e1792 | 4u);
        } else {
            phi_2453_ = _e1792;
        }
        let _e1795 = phi_2453_;
        let _e1797 = ((_e112 * _e1751) + _e1748);
        if (_e1797 < _e89) {
        } else {
            return;
        }
        let _e1801 = bits.member[(0u + _e1797)];
        if (_e1797 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e1797)] = ((_e1801 & ~((7u << bitcast<u32>((_e1749 & 31u))))) | (_e1795 << bitcast<u32>((_e1749 & 31u))));
        if (_e1749 > 29u) {
            let _e1815 = (_e1797 + 1u);
            if (_e1815 < _e89) {
            } else {
                return;
            }
            let _e1819 = bits.member[(0u + _e1815)];
            let _e1820 = (32u - _e1749);
            let _e1830 = (_e1797 + 1u);
            if (_e1830 < _e89) {
            } else {
                return;
            }
            bits.member[(0u + _e1830)] = ((_e1819 & ~((7u >> bitcast<u32>((_e1820 & 31u))))) | (_e1795 >> bitcast<u32>((_e1820 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
