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
    var phi_688_: f32;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_726_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_746_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_773_: bool;
    var phi_843_: f32;
    var phi_850_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_871_: f32;
    var phi_878_: f32;
    var phi_895_: f32;
    var phi_900_: f32;
    var phi_905_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_962_: vec3<f32>;
    var phi_963_: vec3<f32>;
    var phi_976_: u32;
    var phi_981_: u32;
    var phi_986_: u32;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1132_: u32;
    var phi_1134_: u32;
    var phi_1137_: bool;
    var phi_1217_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1244_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1271_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1277_: u32;
    var phi_1280_: u32;
    var phi_1294_: u32;
    var phi_1304_: u32;
    var phi_1314_: u32;
    var phi_1332_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1388_: u32;
    var phi_1401_: u32;
    var phi_1406_: u32;
    var phi_1407_: u32;
    var phi_1408_: u32;
    var phi_1278_: u32;
    var phi_1281_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1466_: u32;
    var phi_1469_: bool;
    var phi_1513_: vec3<f32>;
    var phi_1514_: vec3<f32>;
    var phi_1543_: vec3<f32>;
    var phi_1544_: vec3<f32>;
    var phi_1573_: vec3<f32>;
    var phi_1574_: vec3<f32>;
    var phi_1592_: bool;
    var phi_1593_: bool;
    var phi_1597_: f32;
    var phi_1598_: f32;
    var phi_1599_: f32;
    var phi_1600_: f32;
    var phi_1608_: f32;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1623_: f32;
    var phi_1624_: f32;
    var phi_1625_: f32;
    var phi_1626_: f32;
    var phi_1634_: f32;
    var phi_1644_: bool;
    var phi_1645_: bool;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1652_: f32;
    var phi_1660_: f32;
    var phi_1675_: f32;
    var phi_1676_: bool;
    var phi_1677_: f32;
    var phi_1678_: bool;
    var phi_1679_: f32;
    var phi_1680_: bool;
    var phi_1698_: f32;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1701_: f32;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1707_: bool;
    var phi_1708_: f32;
    var phi_1709_: bool;
    var phi_1737_: vec3<f32>;
    var phi_1738_: vec3<f32>;
    var phi_1763_: vec3<f32>;
    var phi_1764_: vec3<f32>;
    var phi_1789_: vec3<f32>;
    var phi_1790_: vec3<f32>;
    var phi_1846_: f32;
    var phi_1855_: f32;
    var phi_1864_: f32;
    var phi_1873_: f32;
    var phi_1880_: f32;
    var phi_1887_: f32;
    var phi_1900_: f32;
    var phi_1909_: f32;
    var phi_1918_: f32;
    var phi_1927_: f32;
    var phi_1934_: f32;
    var phi_1941_: f32;
    var phi_1958_: f32;
    var phi_1963_: f32;
    var phi_1968_: f32;
    var phi_1976_: f32;
    var phi_1981_: f32;
    var phi_1986_: f32;
    var phi_1998_: f32;
    var phi_2003_: f32;
    var phi_2008_: f32;
    var phi_2013_: f32;
    var phi_2018_: lt_bvh_triangle_Intersection;
    var phi_2019_: bool;
    var phi_2020_: lt_bvh_triangle_Intersection;
    var phi_2021_: bool;
    var phi_2025_: lt_bvh_triangle_Intersection;
    var phi_2026_: bool;
    var phi_2027_: lt_bvh_triangle_Intersection;
    var phi_2028_: bool;
    var phi_2029_: bool;
    var phi_2033_: bool;
    var phi_2037_: lt_bvh_triangle_Intersection;
    var phi_2251_: f32;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2260_: bool;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2263_: bool;
    var phi_2264_: bool;
    var phi_2265_: bool;
    var phi_2266_: bool;
    var phi_2267_: bool;
    var phi_2268_: bool;
    var phi_2269_: bool;
    var phi_1467_: u32;
    var phi_1470_: bool;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var local_5: bool;
    var phi_2316_: bool;
    var phi_2317_: bool;
    var phi_2348_: u32;
    var phi_2349_: u32;
    var phi_1135_: u32;
    var phi_1138_: bool;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var local_6: bool;
    var phi_2356_: bool;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var phi_2362_: bool;
    var phi_2363_: bool;
    var phi_2367_: bool;
    var phi_2371_: f32;
    var phi_2412_: u32;
    var phi_2431_: u32;
    var phi_2439_: u32;
    var phi_2447_: u32;
    var phi_2452_: u32;
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
        if (_e111 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e117 = samples.member[(0u + _e111)].position;
        let _e119 = samples.member[(0u + _e111)].normal;
        let _e121 = samples.member[(0u + _e111)].magnitude;
        let _e123 = ((8f / 8388608f) * _e121);
        let _e131 = (_e117.x + (_e119.x * _e123));
        let _e133 = (_e117.y + (_e119.y * _e123));
        let _e135 = (_e117.z + (_e119.z * _e123));
        let _e137 = p.member.light.place;
        if (_e137.w == 0f) {
            phi_688_ = 300000000000000000000000000000000000000f;
        } else {
            phi_688_ = 1f;
        }
        let _e141 = phi_688_;
        let _e149 = (_e137.x - (_e131 * _e137.w));
        let _e150 = (_e137.y - (_e133 * _e137.w));
        let _e151 = (_e137.z - (_e135 * _e137.w));
        let _e153 = abs(_e149);
        let _e154 = abs(_e150);
        let _e155 = abs(_e151);
        if (abs(_e131) < 1000000000000000f) {
            if (abs(_e133) < 1000000000000000f) {
                phi_719_ = (abs(_e135) < 1000000000000000f);
                phi_720_ = false;
            } else {
                phi_719_ = bool();
                phi_720_ = true;
            }
            let _e163 = phi_719_;
            let _e165 = phi_720_;
            phi_721_ = _e163;
            phi_722_ = _e165;
        } else {
            phi_721_ = bool();
            phi_722_ = true;
        }
        let _e167 = phi_721_;
        let _e169 = phi_722_;
        if _e169 {
            phi_726_ = false;
        } else {
            phi_726_ = _e167;
        }
        let _e171 = phi_726_;
        if _e171 {
            if (_e153 < 1000000000000000f) {
                if (_e154 < 1000000000000000f) {
                    phi_739_ = (_e155 < 1000000000000000f);
                    phi_740_ = false;
                } else {
                    phi_739_ = bool();
                    phi_740_ = true;
                }
                let _e176 = phi_739_;
                let _e178 = phi_740_;
                phi_741_ = _e176;
                phi_742_ = _e178;
            } else {
                phi_741_ = bool();
                phi_742_ = true;
            }
            let _e180 = phi_741_;
            let _e182 = phi_742_;
            if _e182 {
                phi_746_ = false;
            } else {
                phi_746_ = _e180;
            }
            let _e184 = phi_746_;
            if _e184 {
                if (_e153 > 0f) {
                    phi_760_ = bool();
                    phi_761_ = true;
                } else {
                    let _e186 = (_e154 > 0f);
                    if _e186 {
                        phi_759_ = bool();
                    } else {
                        phi_759_ = (_e155 > 0f);
                    }
                    let _e189 = phi_759_;
                    phi_760_ = _e189;
                    phi_761_ = _e186;
                }
                let _e191 = phi_760_;
                let _e193 = phi_761_;
                if _e193 {
                    phi_765_ = true;
                } else {
                    phi_765_ = _e191;
                }
                let _e195 = phi_765_;
                phi_766_ = _e195;
                phi_767_ = false;
            } else {
                phi_766_ = bool();
                phi_767_ = true;
            }
            let _e197 = phi_766_;
            let _e199 = phi_767_;
            phi_768_ = _e197;
            phi_769_ = _e199;
        } else {
            phi_768_ = bool();
            phi_769_ = true;
        }
        let _e201 = phi_768_;
        let _e203 = phi_769_;
        if _e203 {
            phi_773_ = false;
        } else {
            phi_773_ = _e201;
        }
        let _e205 = phi_773_;
        if _e205 {
            let _e206 = (0u >= _e77);
            if _e206 {
                phi_2361_ = bool();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e212 = nodes.member[(0u + 0u)].frame[0u];
                let _e216 = nodes.member[(0u + 0u)].frame[1u];
                let _e220 = nodes.member[(0u + 0u)].frame[2u];
                let _e224 = nodes.member[(0u + 0u)].frame[0u];
                let _e228 = nodes.member[(0u + 0u)].frame[1u];
                let _e232 = nodes.member[(0u + 0u)].frame[2u];
                let _e236 = nodes.member[(0u + 0u)].frame[3u];
                let _e270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e149), abs(_e150));
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(_e270, abs(_e151));
                let _e272 = (_e271 * 0.0000000000009094947f);
                if (abs(_e149) < _e272) {
                    phi_843_ = _e272;
                } else {
                    phi_843_ = abs(_e149);
                }
                let _e277 = phi_843_;
                if (_e149 < 0f) {
                    phi_850_ = (-1f / _e277);
                } else {
                    phi_850_ = (1f / _e277);
                }
                let _e282 = phi_850_;
                if (abs(_e150) < _e272) {
                    phi_857_ = _e272;
                } else {
                    phi_857_ = abs(_e150);
                }
                let _e287 = phi_857_;
                if (_e150 < 0f) {
                    phi_864_ = (-1f / _e287);
                } else {
                    phi_864_ = (1f / _e287);
                }
                let _e292 = phi_864_;
                if (abs(_e151) < _e272) {
                    phi_871_ = _e272;
                } else {
                    phi_871_ = abs(_e151);
                }
                let _e297 = phi_871_;
                if (_e151 < 0f) {
                    phi_878_ = (-1f / _e297);
                } else {
                    phi_878_ = (1f / _e297);
                }
                let _e302 = phi_878_;
                let _e306 = abs((bitcast<f32>(_e212) - _e131));
                let _e307 = abs((bitcast<f32>(_e216) - _e133));
                let _e308 = abs((bitcast<f32>(_e220) - _e135));
                let _e312 = abs(((bitcast<f32>(_e224) + (bitcast<f32>((((_e236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                let _e313 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e314 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                if (_e306 > _e312) {
                    phi_895_ = _e306;
                } else {
                    phi_895_ = _e312;
                }
                let _e317 = phi_895_;
                if (_e307 > _e313) {
                    phi_900_ = _e307;
                } else {
                    phi_900_ = _e313;
                }
                let _e320 = phi_900_;
                if (_e308 > _e314) {
                    phi_905_ = _e308;
                } else {
                    phi_905_ = _e314;
                }
                let _e323 = phi_905_;
                if (_e317 > _e320) {
                    phi_910_ = _e317;
                } else {
                    phi_910_ = _e320;
                }
                let _e326 = phi_910_;
                if (_e326 > _e323) {
                    phi_915_ = _e326;
                } else {
                    phi_915_ = _e323;
                }
                let _e329 = phi_915_;
                let _e333 = (_e329 * 0.0000019073486f);
                let _e334 = (abs(_e282) * _e333);
                let _e335 = (abs(_e292) * _e333);
                let _e336 = (abs(_e302) * _e333);
                let _e340 = (_e329 * 0.0000009536743f);
                let _e341 = (abs(_e282) * _e340);
                let _e342 = (abs(_e292) * _e340);
                let _e343 = (abs(_e302) * _e340);
                let _e344 = abs(_e149);
                let _e345 = abs(_e150);
                let _e346 = abs(_e151);
                if (_e344 >= _e345) {
                    if (_e344 >= _e346) {
                        phi_941_ = false;
                    } else {
                        phi_941_ = true;
                    }
                    let _e350 = phi_941_;
                    phi_942_ = _e350;
                } else {
                    phi_942_ = true;
                }
                let _e352 = phi_942_;
                if _e352 {
                    if (_e345 >= _e346) {
                        phi_950_ = 1u;
                    } else {
                        phi_950_ = 2u;
                    }
                    let _e355 = phi_950_;
                    phi_951_ = _e355;
                } else {
                    phi_951_ = 0u;
                }
                let _e357 = phi_951_;
                if (_e357 == 0u) {
                    phi_963_ = vec3<f32>(_e150, _e151, _e149);
                } else {
                    if (_e357 == 1u) {
                        phi_962_ = vec3<f32>(_e151, _e149, _e150);
                    } else {
                        phi_962_ = vec3<f32>(_e149, _e150, _e151);
                    }
                    let _e363 = phi_962_;
                    phi_963_ = _e363;
                }
                let _e365 = phi_963_;
                let _e368 = (_e365.x / _e365.z);
                let _e371 = (_e365.y / _e365.z);
                if (_e282 < 0f) {
                    phi_976_ = 0u;
                } else {
                    phi_976_ = 1u;
                }
                let _e376 = phi_976_;
                if (_e292 < 0f) {
                    phi_981_ = 0u;
                } else {
                    phi_981_ = 2u;
                }
                let _e379 = phi_981_;
                if (_e302 < 0f) {
                    phi_986_ = 0u;
                } else {
                    phi_986_ = 4u;
                }
                let _e382 = phi_986_;
                let _e384 = ((_e376 | _e379) | _e382);
                let _e385 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e385.first[0], _e385.first[1], _e385.first[2], _e385.first[3], _e385.first[4], _e385.first[5], _e385.first[6], _e385.first[7], _e385.first[8], _e385.first[9], _e385.first[10], _e385.first[11], _e385.first[12], _e385.first[13], _e385.first[14], _e385.first[15], _e385.first[16], _e385.first[17], _e385.first[18], _e385.first[19], _e385.first[20], _e385.first[21], _e385.first[22], _e385.first[23], _e385.first[24], _e385.first[25], _e385.first[26], _e385.first[27], _e385.first[28], _e385.first[29], _e385.first[30], _e385.first[31]), array<u32, 32>(_e385.mask[0], _e385.mask[1], _e385.mask[2], _e385.mask[3], _e385.mask[4], _e385.mask[5], _e385.mask[6], _e385.mask[7], _e385.mask[8], _e385.mask[9], _e385.mask[10], _e385.mask[11], _e385.mask[12], _e385.mask[13], _e385.mask[14], _e385.mask[15], _e385.mask[16], _e385.mask[17], _e385.mask[18], _e385.mask[19], _e385.mask[20], _e385.mask[21], _e385.mask[22], _e385.mask[23], _e385.mask[24], _e385.mask[25], _e385.mask[26], _e385.mask[27], _e385.mask[28], _e385.mask[29], _e385.mask[30], _e385.mask[31]), _e385.len, _e385.group, _e385.group_mask);
                let _e459 = local_1.group_mask;
                if ((_e459 & 4278190080u) == 0u) {
                    let _e463 = local_1.len;
                    if (_e463 == 0u) {
                        phi_1100_ = false;
                    } else {
                        let _e467 = local_1.len;
                        local_1.len = (_e467 - 1u);
                        let _e470 = local_1.len;
                        if (_e470 < 32u) {
                        } else {
                            return;
                        }
                        let _e475 = local_1.first[(0u + _e470)];
                        local_1.group = _e475;
                        let _e478 = local_1.len;
                        if (_e478 < 32u) {
                        } else {
                            return;
                        }
                        let _e483 = local_1.mask[(0u + _e478)];
                        local_1.group_mask = _e483;
                        phi_1100_ = true;
                    }
                    let _e486 = phi_1100_;
                    phi_1101_ = _e486;
                } else {
                    phi_1101_ = true;
                }
                let _e488 = phi_1101_;
                if _e488 {
                    let _e490 = local_1.group_mask;
                    let _e496 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e490)), 32u, (_e490 == 0u)));
                    let _e500 = local_1.group_mask;
                    let _e514 = local_1.group_mask;
                    local_1.group_mask = (_e514 & ~((1u << bitcast<u32>((_e496 & 31u)))));
                    let _e517 = local_1.group;
                    phi_1132_ = (_e517 + countOneBits(((_e500 & ~((4294967295u << bitcast<u32>((((_e496 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1132_ = 4294967295u;
                }
                let _e520 = phi_1132_;
                phi_1134_ = _e520;
                phi_1137_ = false;
                loop {
                    let _e522 = phi_1134_;
                    let _e524 = phi_1137_;
                    local_11 = _e524;
                    if (_e522 != 4294967295u) {
                        if (_e522 < _e77) {
                        } else {
                            return;
                        }
                        let _e531 = nodes.member[(0u + _e522)].frame[3u];
                        let _e556 = (bitcast<f32>((((_e531 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e282);
                        let _e557 = (bitcast<f32>((((_e531 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e292);
                        let _e558 = (bitcast<f32>((((_e531 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e561 = nodes.member[(0u + _e522)].frame[0u];
                        let _e565 = nodes.member[(0u + _e522)].frame[1u];
                        let _e569 = nodes.member[(0u + _e522)].frame[2u];
                        let _e574 = ((bitcast<f32>(_e561) - _e131) * _e282);
                        let _e575 = ((bitcast<f32>(_e565) - _e133) * _e292);
                        let _e576 = ((bitcast<f32>(_e569) - _e135) * _e302);
                        let _e584 = nodes.member[(0u + _e522)].x;
                        if (_e282 < 0f) {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e595.unnamed.root, _e584.w), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_bvh_traverse_Tree(_e584.x, _e601.unnamed_1.first_primitive));
                            phi_1217_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e607.unnamed_1.root, _e584.y));
                        } else {
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.unnamed.root, _e584.y), _e623.unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e584.z, _e629.unnamed_1.first_primitive));
                            phi_1217_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_bvh_traverse_Tree(_e635.unnamed_1.root, _e584.w));
                        }
                        let _e643 = phi_1217_;
                        let _e653 = nodes.member[(0u + _e522)].y;
                        if (_e292 < 0f) {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e664.unnamed.root, _e653.w), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_bvh_traverse_Tree(_e653.x, _e670.unnamed_1.first_primitive));
                            phi_1244_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e676.unnamed_1.root, _e653.y));
                        } else {
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.unnamed.root, _e653.y), _e692.unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e653.z, _e698.unnamed_1.first_primitive));
                            phi_1244_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_bvh_traverse_Tree(_e704.unnamed_1.root, _e653.w));
                        }
                        let _e712 = phi_1244_;
                        let _e722 = nodes.member[(0u + _e522)].z;
                        if (_e302 < 0f) {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e733.unnamed.root, _e722.w), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e722.x, _e739.unnamed_1.first_primitive));
                            phi_1271_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e745.unnamed_1.root, _e722.y));
                        } else {
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e761.unnamed.root, _e722.y), _e761.unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e722.z, _e767.unnamed_1.first_primitive));
                            phi_1271_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_bvh_traverse_Tree(_e773.unnamed_1.root, _e722.w));
                        }
                        let _e781 = phi_1271_;
                        phi_1277_ = 0u;
                        phi_1280_ = 0u;
                        loop {
                            let _e791 = phi_1277_;
                            let _e793 = phi_1280_;
                            local_2 = _e793;
                            local_3 = _e793;
                            local_4 = _e793;
                            let _e794 = (_e791 < 8u);
                            if _e794 {
                                let _e796 = (_e791 >> bitcast<u32>(2i));
                                let _e797 = (_e791 & 3u);
                                if (_e796 == 0u) {
                                    phi_1294_ = _e643.unnamed.root;
                                } else {
                                    phi_1294_ = _e643.unnamed.first_primitive;
                                }
                                let _e800 = phi_1294_;
                                if (_e796 == 0u) {
                                    phi_1304_ = _e712.unnamed.root;
                                } else {
                                    phi_1304_ = _e712.unnamed.first_primitive;
                                }
                                let _e809 = phi_1304_;
                                if (_e796 == 0u) {
                                    phi_1314_ = _e781.unnamed.root;
                                } else {
                                    phi_1314_ = _e781.unnamed.first_primitive;
                                }
                                let _e818 = phi_1314_;
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e800 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 - _e334)), ((f32(((_e809 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e335)));
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(_e831, ((f32(((_e818 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e336)));
                                if (_e796 == 0u) {
                                    phi_1332_ = _e643.unnamed_1.root;
                                } else {
                                    phi_1332_ = _e643.unnamed_1.first_primitive;
                                }
                                let _e835 = phi_1332_;
                                if (_e796 == 0u) {
                                    phi_1342_ = _e712.unnamed_1.root;
                                } else {
                                    phi_1342_ = _e712.unnamed_1.first_primitive;
                                }
                                let _e844 = phi_1342_;
                                if (_e796 == 0u) {
                                    phi_1352_ = _e781.unnamed_1.root;
                                } else {
                                    phi_1352_ = _e781.unnamed_1.first_primitive;
                                }
                                let _e853 = phi_1352_;
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 + _e334)), ((f32(((_e844 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e335)));
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e336)));
                                if (_e832 <= _e867) {
                                    if (_e832 <= _e141) {
                                        if (_e867 >= 0f) {
                                            if (_e796 == 0u) {
                                                let _e874 = nodes.member[(0u + _e522)].links[2u];
                                                phi_1388_ = _e874;
                                            } else {
                                                let _e877 = nodes.member[(0u + _e522)].links[3u];
                                                phi_1388_ = _e877;
                                            }
                                            let _e879 = phi_1388_;
                                            let _e884 = ((_e879 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u);
                                            let _e885 = (_e884 & 31u);
                                            if (_e885 >= 24u) {
                                                phi_1401_ = (24u + ((_e885 - 24u) ^ _e384));
                                            } else {
                                                phi_1401_ = _e885;
                                            }
                                            let _e891 = phi_1401_;
                                            phi_1406_ = (_e793 | ((_e884 >> bitcast<u32>(5i)) << bitcast<u32>((_e891 & 31u))));
                                        } else {
                                            phi_1406_ = _e793;
                                        }
                                        let _e899 = phi_1406_;
                                        phi_1407_ = _e899;
                                    } else {
                                        phi_1407_ = _e793;
                                    }
                                    let _e901 = phi_1407_;
                                    phi_1408_ = _e901;
                                } else {
                                    phi_1408_ = _e793;
                                }
                                let _e903 = phi_1408_;
                                phi_1278_ = (_e791 + 1u);
                                phi_1281_ = _e903;
                            } else {
                                phi_1278_ = u32();
                                phi_1281_ = u32();
                            }
                            let _e906 = phi_1278_;
                            let _e908 = phi_1281_;
                            continue;
                            continuing {
                                phi_1277_ = _e906;
                                phi_1280_ = _e908;
                                break if !(_e794);
                            }
                        }
                        let _e912 = nodes.member[(0u + _e522)].links[0u];
                        let _e916 = nodes.member[(0u + _e522)].frame[3u];
                        let _e920 = local_2;
                        if ((_e920 & 4278190080u) == 0u) {
                        } else {
                            let _e924 = local_1.group_mask;
                            if ((_e924 & 4278190080u) == 0u) {
                            } else {
                                let _e928 = local_1.len;
                                if (_e928 < 32u) {
                                    let _e931 = local_1.group;
                                    let _e933 = local_1.len;
                                    if (_e933 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e933)] = _e931;
                                    let _e939 = local_1.group_mask;
                                    let _e941 = local_1.len;
                                    if (_e941 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e941)] = _e939;
                                    let _e948 = local_1.len;
                                    local_1.len = (_e948 + 1u);
                                }
                            }
                            local_1.group = (0u + _e912);
                            let _e952 = local_3;
                            local_1.group_mask = ((_e952 & 4278190080u) | (_e916 >> bitcast<u32>(24i)));
                        }
                        let _e957 = local_4;
                        phi_1466_ = (_e957 & 16777215u);
                        phi_1469_ = _e524;
                        loop {
                            let _e960 = phi_1466_;
                            let _e962 = phi_1469_;
                            local_7 = _e962;
                            let _e963 = (_e960 == 0u);
                            local_5 = _e963;
                            local_9 = _e963;
                            if _e963 {
                                phi_1467_ = u32();
                                phi_1470_ = bool();
                                phi_2273_ = bool();
                                phi_2274_ = false;
                            } else {
                                let _e966 = nodes.member[(0u + _e522)].links[1u];
                                let _e971 = ((0u + _e966) + select(firstTrailingBit(_e960), 32u, (_e960 == 0u)));
                                if (_e971 < _e80) {
                                } else {
                                    return;
                                }
                                let _e978 = triangles.member[(0u + _e971)].v0_;
                                let _e980 = (_e978.x - _e131);
                                let _e982 = (_e978.y - _e133);
                                let _e984 = (_e978.z - _e135);
                                if (_e357 == 0u) {
                                    phi_1514_ = vec3<f32>(_e982, _e984, _e980);
                                } else {
                                    if (_e357 == 1u) {
                                        phi_1513_ = vec3<f32>(_e984, _e980, _e982);
                                    } else {
                                        phi_1513_ = (_e978 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e992 = phi_1513_;
                                    phi_1514_ = _e992;
                                }
                                let _e994 = phi_1514_;
                                let _e998 = (_e994.x - (_e368 * _e994.z));
                                let _e1002 = (_e994.y - (_e371 * _e994.z));
                                let _e1004 = triangles.member[(0u + _e971)].v1_;
                                let _e1006 = (_e1004.x - _e131);
                                let _e1008 = (_e1004.y - _e133);
                                let _e1010 = (_e1004.z - _e135);
                                if (_e357 == 0u) {
                                    phi_1544_ = vec3<f32>(_e1008, _e1010, _e1006);
                                } else {
                                    if (_e357 == 1u) {
                                        phi_1543_ = vec3<f32>(_e1010, _e1006, _e1008);
                                    } else {
                                        phi_1543_ = (_e1004 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1018 = phi_1543_;
                                    phi_1544_ = _e1018;
                                }
                                let _e1020 = phi_1544_;
                                let _e1024 = (_e1020.x - (_e368 * _e1020.z));
                                let _e1028 = (_e1020.y - (_e371 * _e1020.z));
                                let _e1030 = triangles.member[(0u + _e971)].v2_;
                                let _e1032 = (_e1030.x - _e131);
                                let _e1034 = (_e1030.y - _e133);
                                let _e1036 = (_e1030.z - _e135);
                                if (_e357 == 0u) {
                                    phi_1574_ = vec3<f32>(_e1034, _e1036, _e1032);
                                } else {
                                    if (_e357 == 1u) {
                                        phi_1573_ = vec3<f32>(_e1036, _e1032, _e1034);
                                    } else {
                                        phi_1573_ = (_e1030 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1044 = phi_1573_;
                                    phi_1574_ = _e1044;
                                }
                                let _e1046 = phi_1574_;
                                let _e1050 = (_e1046.x - (_e368 * _e1046.z));
                                let _e1054 = (_e1046.y - (_e371 * _e1046.z));
                                if (_e1024 < _e1050) {
                                    phi_1593_ = true;
                                } else {
                                    if (_e1024 == _e1050) {
                                        phi_1592_ = (_e1028 < _e1054);
                                    } else {
                                        phi_1592_ = false;
                                    }
                                    let _e1059 = phi_1592_;
                                    phi_1593_ = _e1059;
                                }
                                let _e1061 = phi_1593_;
                                if _e1061 {
                                    phi_1597_ = _e1054;
                                    phi_1598_ = _e1050;
                                    phi_1599_ = _e1028;
                                    phi_1600_ = _e1024;
                                } else {
                                    phi_1597_ = _e1028;
                                    phi_1598_ = _e1024;
                                    phi_1599_ = _e1054;
                                    phi_1600_ = _e1050;
                                }
                                let _e1063 = phi_1597_;
                                let _e1065 = phi_1598_;
                                let _e1067 = phi_1599_;
                                let _e1069 = phi_1600_;
                                let _e1072 = ((_e1069 * _e1063) - (_e1067 * _e1065));
                                if _e1061 {
                                    phi_1608_ = -(_e1072);
                                } else {
                                    phi_1608_ = _e1072;
                                }
                                let _e1075 = phi_1608_;
                                if (_e1050 < _e998) {
                                    phi_1619_ = true;
                                } else {
                                    if (_e1050 == _e998) {
                                        phi_1618_ = (_e1054 < _e1002);
                                    } else {
                                        phi_1618_ = false;
                                    }
                                    let _e1080 = phi_1618_;
                                    phi_1619_ = _e1080;
                                }
                                let _e1082 = phi_1619_;
                                if _e1082 {
                                    phi_1623_ = _e1002;
                                    phi_1624_ = _e998;
                                    phi_1625_ = _e1054;
                                    phi_1626_ = _e1050;
                                } else {
                                    phi_1623_ = _e1054;
                                    phi_1624_ = _e1050;
                                    phi_1625_ = _e1002;
                                    phi_1626_ = _e998;
                                }
                                let _e1084 = phi_1623_;
                                let _e1086 = phi_1624_;
                                let _e1088 = phi_1625_;
                                let _e1090 = phi_1626_;
                                let _e1093 = ((_e1090 * _e1084) - (_e1088 * _e1086));
                                if _e1082 {
                                    phi_1634_ = -(_e1093);
                                } else {
                                    phi_1634_ = _e1093;
                                }
                                let _e1096 = phi_1634_;
                                if (_e998 < _e1024) {
                                    phi_1645_ = true;
                                } else {
                                    if (_e998 == _e1024) {
                                        phi_1644_ = (_e1002 < _e1028);
                                    } else {
                                        phi_1644_ = false;
                                    }
                                    let _e1101 = phi_1644_;
                                    phi_1645_ = _e1101;
                                }
                                let _e1103 = phi_1645_;
                                if _e1103 {
                                    phi_1649_ = _e1028;
                                    phi_1650_ = _e1024;
                                    phi_1651_ = _e1002;
                                    phi_1652_ = _e998;
                                } else {
                                    phi_1649_ = _e1002;
                                    phi_1650_ = _e998;
                                    phi_1651_ = _e1028;
                                    phi_1652_ = _e1024;
                                }
                                let _e1105 = phi_1649_;
                                let _e1107 = phi_1650_;
                                let _e1109 = phi_1651_;
                                let _e1111 = phi_1652_;
                                let _e1114 = ((_e1111 * _e1105) - (_e1109 * _e1107));
                                if _e1103 {
                                    phi_1660_ = -(_e1114);
                                } else {
                                    phi_1660_ = _e1114;
                                }
                                let _e1117 = phi_1660_;
                                if (_e1075 >= 0f) {
                                    if (_e1096 >= 0f) {
                                        if (_e1117 >= 0f) {
                                            phi_1675_ = ((_e1075 + _e1096) + _e1117);
                                            phi_1676_ = false;
                                        } else {
                                            phi_1675_ = f32();
                                            phi_1676_ = true;
                                        }
                                        let _e1124 = phi_1675_;
                                        let _e1126 = phi_1676_;
                                        phi_1677_ = _e1124;
                                        phi_1678_ = _e1126;
                                    } else {
                                        phi_1677_ = f32();
                                        phi_1678_ = true;
                                    }
                                    let _e1128 = phi_1677_;
                                    let _e1130 = phi_1678_;
                                    phi_1679_ = _e1128;
                                    phi_1680_ = _e1130;
                                } else {
                                    phi_1679_ = f32();
                                    phi_1680_ = true;
                                }
                                let _e1132 = phi_1679_;
                                let _e1134 = phi_1680_;
                                if _e1134 {
                                    if (_e1075 <= 0f) {
                                        if (_e1096 <= 0f) {
                                            let _e1137 = (_e1117 <= 0f);
                                            if _e1137 {
                                            }
                                            phi_1698_ = ((_e1075 + _e1096) + _e1117);
                                            phi_1699_ = false;
                                            phi_1700_ = _e1137;
                                        } else {
                                            phi_1698_ = f32();
                                            phi_1699_ = true;
                                            phi_1700_ = false;
                                        }
                                        let _e1141 = phi_1698_;
                                        let _e1143 = phi_1699_;
                                        let _e1145 = phi_1700_;
                                        phi_1701_ = _e1141;
                                        phi_1702_ = _e1143;
                                        phi_1703_ = _e1145;
                                    } else {
                                        phi_1701_ = f32();
                                        phi_1702_ = true;
                                        phi_1703_ = false;
                                    }
                                    let _e1147 = phi_1701_;
                                    let _e1149 = phi_1702_;
                                    let _e1151 = phi_1703_;
                                    if _e1149 {
                                        phi_1707_ = false;
                                    } else {
                                        phi_1707_ = _e1151;
                                    }
                                    let _e1153 = phi_1707_;
                                    phi_1708_ = _e1147;
                                    phi_1709_ = _e1153;
                                } else {
                                    phi_1708_ = _e1132;
                                    phi_1709_ = true;
                                }
                                let _e1155 = phi_1708_;
                                let _e1157 = phi_1709_;
                                if _e1157 {
                                    let _e1158 = (_e1155 == 0f);
                                    if _e1158 {
                                        phi_2025_ = lt_bvh_triangle_Intersection();
                                        phi_2026_ = false;
                                    } else {
                                        let _e1160 = triangles.member[(0u + _e971)].v0_;
                                        let _e1162 = (_e1160.x - _e131);
                                        let _e1164 = (_e1160.y - _e133);
                                        let _e1166 = (_e1160.z - _e135);
                                        if (_e357 == 0u) {
                                            phi_1738_ = vec3<f32>(_e1164, _e1166, _e1162);
                                        } else {
                                            if (_e357 == 1u) {
                                                phi_1737_ = vec3<f32>(_e1166, _e1162, _e1164);
                                            } else {
                                                phi_1737_ = (_e1160 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1174 = phi_1737_;
                                            phi_1738_ = _e1174;
                                        }
                                        let _e1176 = phi_1738_;
                                        let _e1178 = triangles.member[(0u + _e971)].v1_;
                                        let _e1180 = triangles.member[(0u + _e971)].v0_;
                                        let _e1183 = (_e1178.x - _e1180.x);
                                        let _e1186 = (_e1178.y - _e1180.y);
                                        let _e1189 = (_e1178.z - _e1180.z);
                                        if (_e357 == 0u) {
                                            phi_1764_ = vec3<f32>(_e1186, _e1189, _e1183);
                                        } else {
                                            if (_e357 == 1u) {
                                                phi_1763_ = vec3<f32>(_e1189, _e1183, _e1186);
                                            } else {
                                                phi_1763_ = (_e1178 - _e1180);
                                            }
                                            let _e1196 = phi_1763_;
                                            phi_1764_ = _e1196;
                                        }
                                        let _e1198 = phi_1764_;
                                        let _e1200 = triangles.member[(0u + _e971)].v2_;
                                        let _e1202 = triangles.member[(0u + _e971)].v0_;
                                        let _e1205 = (_e1200.x - _e1202.x);
                                        let _e1208 = (_e1200.y - _e1202.y);
                                        let _e1211 = (_e1200.z - _e1202.z);
                                        if (_e357 == 0u) {
                                            phi_1790_ = vec3<f32>(_e1208, _e1211, _e1205);
                                        } else {
                                            if (_e357 == 1u) {
                                                phi_1789_ = vec3<f32>(_e1211, _e1205, _e1208);
                                            } else {
                                                phi_1789_ = (_e1200 - _e1202);
                                            }
                                            let _e1218 = phi_1789_;
                                            phi_1790_ = _e1218;
                                        }
                                        let _e1220 = phi_1790_;
                                        let _e1227 = ((_e1198.y * _e1220.z) - (_e1198.z * _e1220.y));
                                        let _e1234 = ((_e1198.z * _e1220.x) - (_e1198.x * _e1220.z));
                                        let _e1241 = ((_e1198.x * _e1220.y) - (_e1198.y * _e1220.x));
                                        let _e1255 = (((1f / _e365.z) * (((_e1227 * _e1176.x) + (_e1234 * _e1176.y)) + (_e1241 * _e1176.z))) / (((_e1227 * _e368) + (_e1234 * _e371)) + _e1241));
                                        if (_e1255 > 0f) {
                                            if (_e1255 < _e141) {
                                                let _e1259 = triangles.member[(0u + _e971)].v0_;
                                                let _e1261 = triangles.member[(0u + _e971)].v1_;
                                                if (_e1259.x < _e1261.x) {
                                                    phi_1846_ = _e1259.x;
                                                } else {
                                                    phi_1846_ = _e1261.x;
                                                }
                                                let _e1268 = phi_1846_;
                                                if (_e1259.y < _e1261.y) {
                                                    phi_1855_ = _e1259.y;
                                                } else {
                                                    phi_1855_ = _e1261.y;
                                                }
                                                let _e1275 = phi_1855_;
                                                if (_e1259.z < _e1261.z) {
                                                    phi_1864_ = _e1259.z;
                                                } else {
                                                    phi_1864_ = _e1261.z;
                                                }
                                                let _e1282 = phi_1864_;
                                                let _e1284 = triangles.member[(0u + _e971)].v2_;
                                                if (_e1268 < _e1284.x) {
                                                    phi_1873_ = _e1268;
                                                } else {
                                                    phi_1873_ = _e1284.x;
                                                }
                                                let _e1289 = phi_1873_;
                                                if (_e1275 < _e1284.y) {
                                                    phi_1880_ = _e1275;
                                                } else {
                                                    phi_1880_ = _e1284.y;
                                                }
                                                let _e1294 = phi_1880_;
                                                if (_e1282 < _e1284.z) {
                                                    phi_1887_ = _e1282;
                                                } else {
                                                    phi_1887_ = _e1284.z;
                                                }
                                                let _e1299 = phi_1887_;
                                                let _e1301 = triangles.member[(0u + _e971)].v0_;
                                                let _e1303 = triangles.member[(0u + _e971)].v1_;
                                                if (_e1301.x > _e1303.x) {
                                                    phi_1900_ = _e1301.x;
                                                } else {
                                                    phi_1900_ = _e1303.x;
                                                }
                                                let _e1310 = phi_1900_;
                                                if (_e1301.y > _e1303.y) {
                                                    phi_1909_ = _e1301.y;
                                                } else {
                                                    phi_1909_ = _e1303.y;
                                                }
                                                let _e1317 = phi_1909_;
                                                if (_e1301.z > _e1303.z) {
                                                    phi_1918_ = _e1301.z;
                                                } else {
                                                    phi_1918_ = _e1303.z;
                                                }
                                                let _e1324 = phi_1918_;
                                                let _e1326 = triangles.member[(0u + _e971)].v2_;
                                                if (_e1310 > _e1326.x) {
                                                    phi_1927_ = _e1310;
                                                } else {
                                                    phi_1927_ = _e1326.x;
                                                }
                                                let _e1331 = phi_1927_;
                                                if (_e1317 > _e1326.y) {
                                                    phi_1934_ = _e1317;
                                                } else {
                                                    phi_1934_ = _e1326.y;
                                                }
                                                let _e1336 = phi_1934_;
                                                if (_e1324 > _e1326.z) {
                                                    phi_1941_ = _e1324;
                                                } else {
                                                    phi_1941_ = _e1326.z;
                                                }
                                                let _e1341 = phi_1941_;
                                                let _e1345 = ((_e1289 - _e131) * _e282);
                                                let _e1346 = ((_e1294 - _e133) * _e292);
                                                let _e1347 = ((_e1299 - _e135) * _e302);
                                                let _e1351 = ((_e1331 - _e131) * _e282);
                                                let _e1352 = ((_e1336 - _e133) * _e292);
                                                let _e1353 = ((_e1341 - _e135) * _e302);
                                                if (_e1345 < _e1351) {
                                                    phi_1958_ = _e1345;
                                                } else {
                                                    phi_1958_ = _e1351;
                                                }
                                                let _e1356 = phi_1958_;
                                                if (_e1346 < _e1352) {
                                                    phi_1963_ = _e1346;
                                                } else {
                                                    phi_1963_ = _e1352;
                                                }
                                                let _e1359 = phi_1963_;
                                                if (_e1347 < _e1353) {
                                                    phi_1968_ = _e1347;
                                                } else {
                                                    phi_1968_ = _e1353;
                                                }
                                                let _e1362 = phi_1968_;
                                                if (_e1345 > _e1351) {
                                                    phi_1976_ = _e1345;
                                                } else {
                                                    phi_1976_ = _e1351;
                                                }
                                                let _e1368 = phi_1976_;
                                                if (_e1346 > _e1352) {
                                                    phi_1981_ = _e1346;
                                                } else {
                                                    phi_1981_ = _e1352;
                                                }
                                                let _e1371 = phi_1981_;
                                                if (_e1347 > _e1353) {
                                                    phi_1986_ = _e1347;
                                                } else {
                                                    phi_1986_ = _e1353;
                                                }
                                                let _e1374 = phi_1986_;
                                                let _e1378 = core_intrinsics_maximum_number_nsz_f32_((_e1356 - _e341), (_e1359 - _e342));
                                                let _e1379 = core_intrinsics_maximum_number_nsz_f32_(_e1378, (_e1362 - _e343));
                                                let _e1380 = core_intrinsics_minimum_number_nsz_f32_((_e1368 + _e341), (_e1371 + _e342));
                                                let _e1381 = core_intrinsics_minimum_number_nsz_f32_(_e1380, (_e1374 + _e343));
                                                if (_e1379 > -300000000000000000000000000000000000000f) {
                                                    phi_1998_ = _e1379;
                                                } else {
                                                    phi_1998_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1384 = phi_1998_;
                                                if (_e1381 < 300000000000000000000000000000000000000f) {
                                                    phi_2003_ = _e1381;
                                                } else {
                                                    phi_2003_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1387 = phi_2003_;
                                                if (_e1255 < _e1384) {
                                                    phi_2008_ = _e1384;
                                                } else {
                                                    phi_2008_ = _e1255;
                                                }
                                                let _e1390 = phi_2008_;
                                                if (_e1390 > _e1387) {
                                                    phi_2013_ = _e1387;
                                                } else {
                                                    phi_2013_ = _e1390;
                                                }
                                                let _e1393 = phi_2013_;
                                                phi_2018_ = lt_bvh_triangle_Intersection(_e1393, (_e1096 / _e1155), (_e1117 / _e1155), (_e1384 <= _e1387));
                                                phi_2019_ = false;
                                            } else {
                                                phi_2018_ = lt_bvh_triangle_Intersection();
                                                phi_2019_ = true;
                                            }
                                            let _e1399 = phi_2018_;
                                            let _e1401 = phi_2019_;
                                            phi_2020_ = _e1399;
                                            phi_2021_ = _e1401;
                                        } else {
                                            phi_2020_ = lt_bvh_triangle_Intersection();
                                            phi_2021_ = true;
                                        }
                                        let _e1403 = phi_2020_;
                                        let _e1405 = phi_2021_;
                                        if _e1405 {
                                        }
                                        phi_2025_ = _e1403;
                                        phi_2026_ = _e1405;
                                    }
                                    let _e1407 = phi_2025_;
                                    let _e1409 = phi_2026_;
                                    phi_2027_ = _e1407;
                                    phi_2028_ = _e1158;
                                    phi_2029_ = _e1409;
                                } else {
                                    phi_2027_ = lt_bvh_triangle_Intersection();
                                    phi_2028_ = true;
                                    phi_2029_ = false;
                                }
                                let _e1411 = phi_2027_;
                                let _e1413 = phi_2028_;
                                let _e1415 = phi_2029_;
                                if _e1413 {
                                    phi_2033_ = true;
                                } else {
                                    phi_2033_ = _e1415;
                                }
                                let _e1417 = phi_2033_;
                                if _e1417 {
                                    phi_2037_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2037_ = _e1411;
                                }
                                let _e1419 = phi_2037_;
                                if _e1419.is_hit {
                                    if (_e1419.t > 0f) {
                                        if (_e1419.t < _e141) {
                                            let _e1426 = triangles.member[(0u + _e971)].i0_;
                                            if ((_e1426 & 2147483648u) == 0u) {
                                                phi_2256_ = true;
                                            } else {
                                                if (_e971 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1435 = triangles.member[(0u + _e971)].i0_;
                                                let _e1436 = (_e1435 & 2147483647u);
                                                let _e1438 = triangles.member[(0u + _e971)].i1_;
                                                let _e1440 = triangles.member[(0u + _e971)].i2_;
                                                if (_e1436 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1444 = vertices.member[(0u + _e1436)];
                                                if (_e1438 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1448 = vertices.member[(0u + _e1438)];
                                                if (_e1440 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1452 = vertices.member[(0u + _e1440)];
                                                let _e1453 = array<abi_Vertex, 3>(_e1444, _e1448, _e1452);
                                                if (_e1453[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1459 = materials.member[(0u + _e1453[0].material)];
                                                if ((_e1459.flags & 1u) == 1u) {
                                                    let _e1464 = ((1f - _e1419.u) - _e1419.v);
                                                    if (_e1459.cutoff <= 0f) {
                                                        phi_2254_ = true;
                                                    } else {
                                                        let _e1491 = (_e1459.base_color.w * ((((f32((_e1453[0].color >> bitcast<u32>(24i))) * _e1464) + (f32((_e1453[1].color >> bitcast<u32>(24i))) * _e1419.u)) + (f32((_e1453[2].color >> bitcast<u32>(24i))) * _e1419.v)) * (1f / 255f)));
                                                        if (_e1459.alpha_size == 0u) {
                                                            phi_2251_ = _e1491;
                                                        } else {
                                                            local.offset = _e1459.alpha_offset;
                                                            local.size = _e1459.alpha_size;
                                                            local.flags = _e1459.flags;
                                                            let _e1522 = _lt_shaders_texture_TextureView_quad((&local), (((_e1453[0].u * _e1464) + (_e1453[1].u * _e1419.u)) + (_e1453[2].u * _e1419.v)), (((_e1453[0].v * _e1464) + (_e1453[1].v * _e1419.u)) + (_e1453[2].v * _e1419.v)));
                                                            let _e1526 = (_e1522.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1526 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1530 = alpha_texels.member[(0u + _e1526)];
                                                            let _e1546 = (_e1522.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1546 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1550 = alpha_texels.member[(0u + _e1546)];
                                                            let _e1567 = (_e1522.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1567 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1571 = alpha_texels.member[(0u + _e1567)];
                                                            let _e1588 = (_e1522.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1588 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1592 = alpha_texels.member[(0u + _e1588)];
                                                            phi_2251_ = (_e1491 * (((((f32(((_e1530 >> bitcast<u32>((((_e1522.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.x) + ((f32(((_e1550 >> bitcast<u32>((((_e1522.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.y)) + ((f32(((_e1571 >> bitcast<u32>((((_e1522.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.z)) + ((f32(((_e1592 >> bitcast<u32>((((_e1522.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.w)));
                                                        }
                                                        let _e1608 = phi_2251_;
                                                        phi_2254_ = (_e1608 >= _e1459.cutoff);
                                                    }
                                                    let _e1612 = phi_2254_;
                                                    phi_2255_ = _e1612;
                                                } else {
                                                    phi_2255_ = false;
                                                }
                                                let _e1614 = phi_2255_;
                                                phi_2256_ = _e1614;
                                            }
                                            let _e1616 = phi_2256_;
                                            if _e1616 {
                                                phi_2260_ = false;
                                            } else {
                                                phi_2260_ = true;
                                            }
                                            let _e1618 = phi_2260_;
                                            phi_2261_ = _e1616;
                                            phi_2262_ = _e1616;
                                            phi_2263_ = _e1618;
                                        } else {
                                            phi_2261_ = bool();
                                            phi_2262_ = _e962;
                                            phi_2263_ = true;
                                        }
                                        let _e1620 = phi_2261_;
                                        let _e1622 = phi_2262_;
                                        let _e1624 = phi_2263_;
                                        phi_2264_ = _e1620;
                                        phi_2265_ = _e1622;
                                        phi_2266_ = _e1624;
                                    } else {
                                        phi_2264_ = bool();
                                        phi_2265_ = _e962;
                                        phi_2266_ = true;
                                    }
                                    let _e1626 = phi_2264_;
                                    let _e1628 = phi_2265_;
                                    let _e1630 = phi_2266_;
                                    phi_2267_ = _e1626;
                                    phi_2268_ = _e1628;
                                    phi_2269_ = _e1630;
                                } else {
                                    phi_2267_ = bool();
                                    phi_2268_ = _e962;
                                    phi_2269_ = true;
                                }
                                let _e1632 = phi_2267_;
                                let _e1634 = phi_2268_;
                                let _e1636 = phi_2269_;
                                if _e1636 {
                                }
                                phi_1467_ = (_e960 & (_e960 - 1u));
                                phi_1470_ = _e1634;
                                phi_2273_ = _e1632;
                                phi_2274_ = _e1636;
                            }
                            let _e1638 = phi_1467_;
                            let _e1640 = phi_1470_;
                            let _e1642 = phi_2273_;
                            let _e1644 = phi_2274_;
                            local_8 = _e1642;
                            continue;
                            continuing {
                                phi_1466_ = _e1638;
                                phi_1469_ = _e1640;
                                break if !(_e1644);
                            }
                        }
                        let _e1647 = local_5;
                        if _e1647 {
                            let _e1649 = local_1.group_mask;
                            if ((_e1649 & 4278190080u) == 0u) {
                                let _e1653 = local_1.len;
                                if (_e1653 == 0u) {
                                    phi_2316_ = false;
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
                                    phi_2316_ = true;
                                }
                                let _e1676 = phi_2316_;
                                phi_2317_ = _e1676;
                            } else {
                                phi_2317_ = true;
                            }
                            let _e1678 = phi_2317_;
                            if _e1678 {
                                let _e1680 = local_1.group_mask;
                                let _e1686 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1680)), 32u, (_e1680 == 0u)));
                                let _e1690 = local_1.group_mask;
                                let _e1704 = local_1.group_mask;
                                local_1.group_mask = (_e1704 & ~((1u << bitcast<u32>((_e1686 & 31u)))));
                                let _e1707 = local_1.group;
                                phi_2348_ = (_e1707 + countOneBits(((_e1690 & ~((4294967295u << bitcast<u32>((((_e1686 - 24u) ^ _e384) & 31u))))) & 255u)));
                            } else {
                                phi_2348_ = 4294967295u;
                            }
                            let _e1710 = phi_2348_;
                            phi_2349_ = _e1710;
                        } else {
                            phi_2349_ = u32();
                        }
                        let _e1712 = phi_2349_;
                        phi_1135_ = _e1712;
                        let _e2008 = local_7;
                        phi_1138_ = _e2008;
                        let _e2011 = local_8;
                        phi_2350_ = _e2011;
                        let _e2014 = local_9;
                        phi_2351_ = _e2014;
                        phi_2352_ = false;
                    } else {
                        phi_1135_ = u32();
                        phi_1138_ = bool();
                        phi_2350_ = bool();
                        phi_2351_ = false;
                        phi_2352_ = true;
                    }
                    let _e1714 = phi_1135_;
                    let _e1716 = phi_1138_;
                    let _e1718 = phi_2350_;
                    let _e1720 = phi_2351_;
                    let _e1722 = phi_2352_;
                    local_6 = _e1722;
                    local_10 = _e1718;
                    continue;
                    continuing {
                        phi_1134_ = _e1714;
                        phi_1137_ = _e1716;
                        break if !(_e1720);
                    }
                }
                let _e1725 = local_6;
                if _e1725 {
                    phi_2356_ = false;
                } else {
                    phi_2356_ = true;
                }
                let _e1727 = phi_2356_;
                if _e1727 {
                    let _e2020 = local_10;
                    phi_2360_ = _e2020;
                } else {
                    let _e2022 = local_11;
                    phi_2360_ = _e2022;
                }
                let _e1729 = phi_2360_;
                phi_2361_ = _e1729;
            }
            let _e1731 = phi_2361_;
            phi_2362_ = _e1731;
            phi_2363_ = _e206;
        } else {
            phi_2362_ = bool();
            phi_2363_ = true;
        }
        let _e1733 = phi_2362_;
        let _e1735 = phi_2363_;
        if _e1735 {
            phi_2367_ = false;
        } else {
            phi_2367_ = _e1733;
        }
        let _e1737 = phi_2367_;
        if _e1737 {
            phi_2371_ = 0f;
        } else {
            phi_2371_ = 1f;
        }
        let _e1739 = phi_2371_;
        if (_e111 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e111)] = _e1739;
        let _e1745 = p.member.light.number;
        let _e1746 = (_e1745 * 3u);
        let _e1747 = (_e1746 / 32u);
        let _e1748 = (_e1746 % 32u);
        let _e1750 = p.member.light.mask_words;
        if (_e111 < _e83) {
        } else {
            return;
        }
        let _e1754 = visibility.member[(0u + _e111)];
        let _e1756 = ((_e111 * _e1750) + _e1747);
        if (_e1748 > 29u) {
            let _e1758 = (_e1756 + 1u);
            if (_e1758 < _e89) {
            } else {
                return;
            }
            let _e1762 = bits.member[(0u + _e1758)];
            phi_2412_ = _e1762;
        } else {
            phi_2412_ = 0u;
        }
        let _e1764 = phi_2412_;
        if (_e1756 < _e89) {
        } else {
            return;
        }
        let _e1768 = bits.member[(0u + _e1756)];
        let _e1771 = (_e1768 >> bitcast<u32>((_e1748 & 31u)));
        if (_e1748 > 29u) {
            phi_2431_ = (_e1771 | (_e1764 << bitcast<u32>(((32u - _e1748) & 31u))));
        } else {
            phi_2431_ = _e1771;
        }
        let _e1779 = phi_2431_;
        if ((_e1779 & 2u) == 0u) {
            phi_2439_ = (_e1779 & 1u);
        } else {
            phi_2439_ = (_e1779 & 7u);
        }
        let _e1785 = phi_2439_;
        if ((_e1785 & 1u) != 0u) {
            phi_2447_ = (2u | 1u);
        } else {
            phi_2447_ = 2u;
        }
        let _e1791 = phi_2447_;
        if (_e1754 < 0.5f) {
            phi_2452_ = (_e1791 | 4u);
        } else {
            phi_2452_ = _e1791;
        }
        let _e1794 = phi_2452_;
        let _e1796 = ((_e111 * _e1750) + _e1747);
        if (_e1796 < _e89) {
        } else {
            return;
        }
        let _e1800 = bits.member[(0u + _e1796)];
        if (_e1796 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e1796)] = ((_e1800 & ~((7u << bitcast<u32>((_e1748 & 31u))))) | (_e1794 << bitcast<u32>((_e1748 & 31u))));
        if (_e1748 > 29u) {
            let _e1814 = (_e1796 + 1u);
            if (_e1814 < _e89) {
            } else {
                return;
            }
            let _e1818 = bits.member[(0u + _e1814)];
            let _e1819 = (32u - _e1748);
            let _e1829 = (_e1796 + 1u);
            if (_e1829 < _e89) {
            } else {
                return;
            }
            bits.member[(0u + _e1829)] = ((_e1818 & ~((7u >> bitcast<u32>((_e1819 & 31u))))) | (_e1794 >> bitcast<u32>((_e1819 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
