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
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_735_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_852_: f32;
    var phi_859_: f32;
    var phi_866_: f32;
    var phi_873_: f32;
    var phi_880_: f32;
    var phi_887_: f32;
    var phi_904_: f32;
    var phi_909_: f32;
    var phi_914_: f32;
    var phi_919_: f32;
    var phi_924_: f32;
    var phi_943_: u32;
    var phi_948_: u32;
    var phi_953_: u32;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1099_: u32;
    var phi_1101_: u32;
    var phi_1104_: bool;
    var phi_1184_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1211_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1238_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1244_: u32;
    var phi_1247_: u32;
    var phi_1261_: u32;
    var phi_1271_: u32;
    var phi_1281_: u32;
    var phi_1299_: u32;
    var phi_1309_: u32;
    var phi_1319_: u32;
    var phi_1355_: u32;
    var phi_1368_: u32;
    var phi_1373_: u32;
    var phi_1374_: u32;
    var phi_1375_: u32;
    var phi_1245_: u32;
    var phi_1248_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1433_: u32;
    var phi_1436_: bool;
    var phi_1485_: f32;
    var phi_1490_: f32;
    var phi_1495_: f32;
    var phi_1503_: f32;
    var phi_1508_: f32;
    var phi_1513_: f32;
    var phi_1633_: bool;
    var phi_1634_: bool;
    var phi_1635_: bool;
    var phi_1636_: bool;
    var phi_1640_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1660_: bool;
    var phi_1673_: bool;
    var phi_1674_: bool;
    var phi_1675_: bool;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: bool;
    var phi_1757_: f32;
    var phi_1764_: f32;
    var phi_1771_: f32;
    var phi_1778_: f32;
    var phi_1785_: f32;
    var phi_1792_: f32;
    var phi_1809_: f32;
    var phi_1814_: f32;
    var phi_1819_: f32;
    var phi_1824_: f32;
    var phi_1829_: f32;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1864_: u32;
    var phi_1865_: u32;
    var phi_1876_: vec3<f32>;
    var phi_1877_: vec3<f32>;
    var phi_1890_: u32;
    var phi_1895_: u32;
    var phi_1900_: u32;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2046_: u32;
    var phi_2048_: u32;
    var phi_2051_: bool;
    var phi_2131_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2158_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2185_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2191_: u32;
    var phi_2194_: u32;
    var phi_2208_: u32;
    var phi_2218_: u32;
    var phi_2228_: u32;
    var phi_2246_: u32;
    var phi_2256_: u32;
    var phi_2266_: u32;
    var phi_2302_: u32;
    var phi_2315_: u32;
    var phi_2320_: u32;
    var phi_2321_: u32;
    var phi_2322_: u32;
    var phi_2192_: u32;
    var phi_2195_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2380_: u32;
    var phi_2383_: bool;
    var phi_2427_: vec3<f32>;
    var phi_2428_: vec3<f32>;
    var phi_2457_: vec3<f32>;
    var phi_2458_: vec3<f32>;
    var phi_2487_: vec3<f32>;
    var phi_2488_: vec3<f32>;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2511_: f32;
    var phi_2512_: f32;
    var phi_2513_: f32;
    var phi_2514_: f32;
    var phi_2522_: f32;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2537_: f32;
    var phi_2538_: f32;
    var phi_2539_: f32;
    var phi_2540_: f32;
    var phi_2548_: f32;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2563_: f32;
    var phi_2564_: f32;
    var phi_2565_: f32;
    var phi_2566_: f32;
    var phi_2574_: f32;
    var phi_2589_: f32;
    var phi_2590_: bool;
    var phi_2591_: f32;
    var phi_2592_: bool;
    var phi_2593_: f32;
    var phi_2594_: bool;
    var phi_2612_: f32;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2615_: f32;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2621_: bool;
    var phi_2622_: f32;
    var phi_2623_: bool;
    var phi_2651_: vec3<f32>;
    var phi_2652_: vec3<f32>;
    var phi_2677_: vec3<f32>;
    var phi_2678_: vec3<f32>;
    var phi_2703_: vec3<f32>;
    var phi_2704_: vec3<f32>;
    var phi_2760_: f32;
    var phi_2769_: f32;
    var phi_2778_: f32;
    var phi_2787_: f32;
    var phi_2794_: f32;
    var phi_2801_: f32;
    var phi_2814_: f32;
    var phi_2823_: f32;
    var phi_2832_: f32;
    var phi_2841_: f32;
    var phi_2848_: f32;
    var phi_2855_: f32;
    var phi_2872_: f32;
    var phi_2877_: f32;
    var phi_2882_: f32;
    var phi_2890_: f32;
    var phi_2895_: f32;
    var phi_2900_: f32;
    var phi_2912_: f32;
    var phi_2917_: f32;
    var phi_2922_: f32;
    var phi_2927_: f32;
    var phi_2932_: lt_bvh_triangle_Intersection;
    var phi_2933_: bool;
    var phi_2934_: lt_bvh_triangle_Intersection;
    var phi_2935_: bool;
    var phi_2939_: lt_bvh_triangle_Intersection;
    var phi_2940_: bool;
    var phi_2941_: lt_bvh_triangle_Intersection;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2947_: bool;
    var phi_2951_: lt_bvh_triangle_Intersection;
    var phi_3165_: f32;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_2381_: u32;
    var phi_2384_: bool;
    var phi_3187_: bool;
    var phi_3188_: bool;
    var local_9: bool;
    var phi_3230_: bool;
    var phi_3231_: bool;
    var phi_3262_: u32;
    var phi_3263_: u32;
    var phi_2049_: u32;
    var phi_2052_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var local_10: bool;
    var phi_3270_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3281_: bool;
    var phi_3285_: bool;
    var phi_3286_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3291_: bool;
    var phi_1434_: u32;
    var phi_1437_: bool;
    var phi_3295_: bool;
    var local_11: bool;
    var phi_3337_: bool;
    var phi_3338_: bool;
    var phi_3369_: u32;
    var phi_3370_: u32;
    var phi_1102_: u32;
    var phi_1105_: bool;
    var phi_3371_: bool;
    var phi_3372_: bool;
    var local_12: bool;
    var phi_3376_: bool;
    var phi_3380_: bool;
    var phi_3381_: bool;
    var phi_3382_: bool;
    var phi_3386_: bool;
    var phi_3387_: bool;
    var phi_3391_: bool;
    var phi_3395_: f32;
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
        let _e153 = abs(_e150);
        let _e154 = abs(_e151);
        let _e155 = abs(_e152);
        if (abs(_e132) < 1000000000000000f) {
            if (abs(_e134) < 1000000000000000f) {
                phi_728_ = (abs(_e136) < 1000000000000000f);
                phi_729_ = false;
            } else {
                phi_728_ = bool();
                phi_729_ = true;
            }
            let _e163 = phi_728_;
            let _e165 = phi_729_;
            phi_730_ = _e163;
            phi_731_ = _e165;
        } else {
            phi_730_ = bool();
            phi_731_ = true;
        }
        let _e167 = phi_730_;
        let _e169 = phi_731_;
        if _e169 {
            phi_735_ = false;
        } else {
            phi_735_ = _e167;
        }
        let _e171 = phi_735_;
        if _e171 {
            if (_e153 < 1000000000000000f) {
                if (_e154 < 1000000000000000f) {
                    phi_748_ = (_e155 < 1000000000000000f);
                    phi_749_ = false;
                } else {
                    phi_748_ = bool();
                    phi_749_ = true;
                }
                let _e176 = phi_748_;
                let _e178 = phi_749_;
                phi_750_ = _e176;
                phi_751_ = _e178;
            } else {
                phi_750_ = bool();
                phi_751_ = true;
            }
            let _e180 = phi_750_;
            let _e182 = phi_751_;
            if _e182 {
                phi_755_ = false;
            } else {
                phi_755_ = _e180;
            }
            let _e184 = phi_755_;
            if _e184 {
                if (_e153 > 0f) {
                    phi_769_ = bool();
                    phi_770_ = true;
                } else {
                    let _e186 = (_e154 > 0f);
                    if _e186 {
                        phi_768_ = bool();
                    } else {
                        phi_768_ = (_e155 > 0f);
                    }
                    let _e189 = phi_768_;
                    phi_769_ = _e189;
                    phi_770_ = _e186;
                }
                let _e191 = phi_769_;
                let _e193 = phi_770_;
                if _e193 {
                    phi_774_ = true;
                } else {
                    phi_774_ = _e191;
                }
                let _e195 = phi_774_;
                phi_775_ = _e195;
                phi_776_ = false;
            } else {
                phi_775_ = bool();
                phi_776_ = true;
            }
            let _e197 = phi_775_;
            let _e199 = phi_776_;
            phi_777_ = _e197;
            phi_778_ = _e199;
        } else {
            phi_777_ = bool();
            phi_778_ = true;
        }
        let _e201 = phi_777_;
        let _e203 = phi_778_;
        if _e203 {
            phi_782_ = false;
        } else {
            phi_782_ = _e201;
        }
        let _e205 = phi_782_;
        if _e205 {
            let _e206 = (_e112 >= _e76);
            if _e206 {
                phi_3380_ = false;
            } else {
                if (_e112 < _e76) {
                } else {
                    return;
                }
                let _e212 = nodes.member[(0u + _e112)].frame[0u];
                let _e216 = nodes.member[(0u + _e112)].frame[1u];
                let _e220 = nodes.member[(0u + _e112)].frame[2u];
                let _e224 = nodes.member[(0u + _e112)].frame[0u];
                let _e228 = nodes.member[(0u + _e112)].frame[1u];
                let _e232 = nodes.member[(0u + _e112)].frame[2u];
                let _e236 = nodes.member[(0u + _e112)].frame[3u];
                let _e270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150), abs(_e151));
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(_e270, abs(_e152));
                let _e272 = (_e271 * 0.0000000000009094947f);
                if (abs(_e150) < _e272) {
                    phi_852_ = _e272;
                } else {
                    phi_852_ = abs(_e150);
                }
                let _e277 = phi_852_;
                if (_e150 < 0f) {
                    phi_859_ = (-1f / _e277);
                } else {
                    phi_859_ = (1f / _e277);
                }
                let _e282 = phi_859_;
                if (abs(_e151) < _e272) {
                    phi_866_ = _e272;
                } else {
                    phi_866_ = abs(_e151);
                }
                let _e287 = phi_866_;
                if (_e151 < 0f) {
                    phi_873_ = (-1f / _e287);
                } else {
                    phi_873_ = (1f / _e287);
                }
                let _e292 = phi_873_;
                if (abs(_e152) < _e272) {
                    phi_880_ = _e272;
                } else {
                    phi_880_ = abs(_e152);
                }
                let _e297 = phi_880_;
                if (_e152 < 0f) {
                    phi_887_ = (-1f / _e297);
                } else {
                    phi_887_ = (1f / _e297);
                }
                let _e302 = phi_887_;
                let _e306 = abs((bitcast<f32>(_e212) - _e132));
                let _e307 = abs((bitcast<f32>(_e216) - _e134));
                let _e308 = abs((bitcast<f32>(_e220) - _e136));
                let _e312 = abs(((bitcast<f32>(_e224) + (bitcast<f32>((((_e236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e132));
                let _e313 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e134));
                let _e314 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e136));
                if (_e306 > _e312) {
                    phi_904_ = _e306;
                } else {
                    phi_904_ = _e312;
                }
                let _e317 = phi_904_;
                if (_e307 > _e313) {
                    phi_909_ = _e307;
                } else {
                    phi_909_ = _e313;
                }
                let _e320 = phi_909_;
                if (_e308 > _e314) {
                    phi_914_ = _e308;
                } else {
                    phi_914_ = _e314;
                }
                let _e323 = phi_914_;
                if (_e317 > _e320) {
                    phi_919_ = _e317;
                } else {
                    phi_919_ = _e320;
                }
                let _e326 = phi_919_;
                if (_e326 > _e323) {
                    phi_924_ = _e326;
                } else {
                    phi_924_ = _e323;
                }
                let _e329 = phi_924_;
                let _e333 = (_e329 * 0.0000019073486f);
                let _e334 = (abs(_e282) * _e333);
                let _e335 = (abs(_e292) * _e333);
                let _e336 = (abs(_e302) * _e333);
                let _e340 = (_e329 * 0.0000009536743f);
                let _e341 = (abs(_e282) * _e340);
                let _e342 = (abs(_e292) * _e340);
                let _e343 = (abs(_e302) * _e340);
                if (_e282 < 0f) {
                    phi_943_ = 0u;
                } else {
                    phi_943_ = 1u;
                }
                let _e346 = phi_943_;
                if (_e292 < 0f) {
                    phi_948_ = 0u;
                } else {
                    phi_948_ = 2u;
                }
                let _e349 = phi_948_;
                if (_e302 < 0f) {
                    phi_953_ = 0u;
                } else {
                    phi_953_ = 4u;
                }
                let _e352 = phi_953_;
                let _e354 = ((_e346 | _e349) | _e352);
                let _e355 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e355.first[0], _e355.first[1], _e355.first[2], _e355.first[3], _e355.first[4], _e355.first[5], _e355.first[6], _e355.first[7], _e355.first[8], _e355.first[9], _e355.first[10], _e355.first[11], _e355.first[12], _e355.first[13], _e355.first[14], _e355.first[15], _e355.first[16], _e355.first[17], _e355.first[18], _e355.first[19], _e355.first[20], _e355.first[21], _e355.first[22], _e355.first[23], _e355.first[24], _e355.first[25], _e355.first[26], _e355.first[27], _e355.first[28], _e355.first[29], _e355.first[30], _e355.first[31]), array<u32, 32>(_e355.mask[0], _e355.mask[1], _e355.mask[2], _e355.mask[3], _e355.mask[4], _e355.mask[5], _e355.mask[6], _e355.mask[7], _e355.mask[8], _e355.mask[9], _e355.mask[10], _e355.mask[11], _e355.mask[12], _e355.mask[13], _e355.mask[14], _e355.mask[15], _e355.mask[16], _e355.mask[17], _e355.mask[18], _e355.mask[19], _e355.mask[20], _e355.mask[21], _e355.mask[22], _e355.mask[23], _e355.mask[24], _e355.mask[25], _e355.mask[26], _e355.mask[27], _e355.mask[28], _e355.mask[29], _e355.mask[30], _e355.mask[31]), _e355.len, _e355.group, _e355.group_mask);
                let _e429 = local_2.group_mask;
                if ((_e429 & 4278190080u) == 0u) {
                    let _e433 = local_2.len;
                    if (_e433 == 0u) {
                        phi_1067_ = false;
                    } else {
                        let _e437 = local_2.len;
                        local_2.len = (_e437 - 1u);
                        let _e440 = local_2.len;
                        if (_e440 < 32u) {
                        } else {
                            return;
                        }
                        let _e445 = local_2.first[(0u + _e440)];
                        local_2.group = _e445;
                        let _e448 = local_2.len;
                        if (_e448 < 32u) {
                        } else {
                            return;
                        }
                        let _e453 = local_2.mask[(0u + _e448)];
                        local_2.group_mask = _e453;
                        phi_1067_ = true;
                    }
                    let _e456 = phi_1067_;
                    phi_1068_ = _e456;
                } else {
                    phi_1068_ = true;
                }
                let _e458 = phi_1068_;
                if _e458 {
                    let _e460 = local_2.group_mask;
                    let _e466 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, (_e460 == 0u)));
                    let _e470 = local_2.group_mask;
                    let _e484 = local_2.group_mask;
                    local_2.group_mask = (_e484 & ~((1u << bitcast<u32>((_e466 & 31u)))));
                    let _e487 = local_2.group;
                    phi_1099_ = (_e487 + countOneBits(((_e470 & ~((4294967295u << bitcast<u32>((((_e466 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1099_ = 4294967295u;
                }
                let _e490 = phi_1099_;
                phi_1101_ = _e490;
                phi_1104_ = false;
                loop {
                    let _e492 = phi_1101_;
                    let _e494 = phi_1104_;
                    if (_e492 != 4294967295u) {
                        if (_e492 < _e76) {
                        } else {
                            return;
                        }
                        let _e501 = nodes.member[(0u + _e492)].frame[3u];
                        let _e526 = (bitcast<f32>((((_e501 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e282);
                        let _e527 = (bitcast<f32>((((_e501 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e292);
                        let _e528 = (bitcast<f32>((((_e501 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e531 = nodes.member[(0u + _e492)].frame[0u];
                        let _e535 = nodes.member[(0u + _e492)].frame[1u];
                        let _e539 = nodes.member[(0u + _e492)].frame[2u];
                        let _e544 = ((bitcast<f32>(_e531) - _e132) * _e282);
                        let _e545 = ((bitcast<f32>(_e535) - _e134) * _e292);
                        let _e546 = ((bitcast<f32>(_e539) - _e136) * _e302);
                        let _e554 = nodes.member[(0u + _e492)].x;
                        if (_e282 < 0f) {
                            let _e565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e554.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e565.unnamed.word, _e554.w), _e565.unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e571.unnamed, lt_mask_LightPlace(_e554.x, _e571.unnamed_1.shift));
                            phi_1184_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_mask_LightPlace(_e577.unnamed_1.word, _e554.y));
                        } else {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e554.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e593.unnamed.word, _e554.y), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_mask_LightPlace(_e554.z, _e599.unnamed_1.shift));
                            phi_1184_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_mask_LightPlace(_e605.unnamed_1.word, _e554.w));
                        }
                        let _e613 = phi_1184_;
                        let _e623 = nodes.member[(0u + _e492)].y;
                        if (_e292 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e634.unnamed.word, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_mask_LightPlace(_e623.x, _e640.unnamed_1.shift));
                            phi_1211_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_mask_LightPlace(_e646.unnamed_1.word, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.unnamed.word, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_mask_LightPlace(_e623.z, _e668.unnamed_1.shift));
                            phi_1211_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e674.unnamed_1.word, _e623.w));
                        }
                        let _e682 = phi_1211_;
                        let _e692 = nodes.member[(0u + _e492)].z;
                        if (_e302 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e703.unnamed.word, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_mask_LightPlace(_e692.x, _e709.unnamed_1.shift));
                            phi_1238_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_mask_LightPlace(_e715.unnamed_1.word, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.unnamed.word, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_mask_LightPlace(_e692.z, _e737.unnamed_1.shift));
                            phi_1238_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e743.unnamed_1.word, _e692.w));
                        }
                        let _e751 = phi_1238_;
                        phi_1244_ = 0u;
                        phi_1247_ = 0u;
                        loop {
                            let _e761 = phi_1244_;
                            let _e763 = phi_1247_;
                            local_3 = _e763;
                            local_4 = _e763;
                            local_5 = _e763;
                            let _e764 = (_e761 < 8u);
                            if _e764 {
                                let _e766 = (_e761 >> bitcast<u32>(2i));
                                let _e767 = (_e761 & 3u);
                                if (_e766 == 0u) {
                                    phi_1261_ = _e613.unnamed.word;
                                } else {
                                    phi_1261_ = _e613.unnamed.shift;
                                }
                                let _e770 = phi_1261_;
                                if (_e766 == 0u) {
                                    phi_1271_ = _e682.unnamed.word;
                                } else {
                                    phi_1271_ = _e682.unnamed.shift;
                                }
                                let _e779 = phi_1271_;
                                if (_e766 == 0u) {
                                    phi_1281_ = _e751.unnamed.word;
                                } else {
                                    phi_1281_ = _e751.unnamed.shift;
                                }
                                let _e788 = phi_1281_;
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e770 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e334)), ((f32(((_e779 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e335)));
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(_e801, ((f32(((_e788 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e336)));
                                if (_e766 == 0u) {
                                    phi_1299_ = _e613.unnamed_1.word;
                                } else {
                                    phi_1299_ = _e613.unnamed_1.shift;
                                }
                                let _e805 = phi_1299_;
                                if (_e766 == 0u) {
                                    phi_1309_ = _e682.unnamed_1.word;
                                } else {
                                    phi_1309_ = _e682.unnamed_1.shift;
                                }
                                let _e814 = phi_1309_;
                                if (_e766 == 0u) {
                                    phi_1319_ = _e751.unnamed_1.word;
                                } else {
                                    phi_1319_ = _e751.unnamed_1.shift;
                                }
                                let _e823 = phi_1319_;
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e805 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e334)), ((f32(((_e814 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e335)));
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(_e836, ((f32(((_e823 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e336)));
                                if (_e802 <= _e837) {
                                    if (_e802 <= _e142) {
                                        if (_e837 >= 0f) {
                                            if (_e766 == 0u) {
                                                let _e844 = nodes.member[(0u + _e492)].links[2u];
                                                phi_1355_ = _e844;
                                            } else {
                                                let _e847 = nodes.member[(0u + _e492)].links[3u];
                                                phi_1355_ = _e847;
                                            }
                                            let _e849 = phi_1355_;
                                            let _e854 = ((_e849 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u);
                                            let _e855 = (_e854 & 31u);
                                            if (_e855 >= 24u) {
                                                phi_1368_ = (24u + ((_e855 - 24u) ^ _e354));
                                            } else {
                                                phi_1368_ = _e855;
                                            }
                                            let _e861 = phi_1368_;
                                            phi_1373_ = (_e763 | ((_e854 >> bitcast<u32>(5i)) << bitcast<u32>((_e861 & 31u))));
                                        } else {
                                            phi_1373_ = _e763;
                                        }
                                        let _e869 = phi_1373_;
                                        phi_1374_ = _e869;
                                    } else {
                                        phi_1374_ = _e763;
                                    }
                                    let _e871 = phi_1374_;
                                    phi_1375_ = _e871;
                                } else {
                                    phi_1375_ = _e763;
                                }
                                let _e873 = phi_1375_;
                                phi_1245_ = (_e761 + 1u);
                                phi_1248_ = _e873;
                            } else {
                                phi_1245_ = u32();
                                phi_1248_ = u32();
                            }
                            let _e876 = phi_1245_;
                            let _e878 = phi_1248_;
                            continue;
                            continuing {
                                phi_1244_ = _e876;
                                phi_1247_ = _e878;
                                break if !(_e764);
                            }
                        }
                        let _e882 = nodes.member[(0u + _e492)].links[0u];
                        let _e886 = nodes.member[(0u + _e492)].frame[3u];
                        let _e890 = local_3;
                        if ((_e890 & 4278190080u) == 0u) {
                        } else {
                            let _e894 = local_2.group_mask;
                            if ((_e894 & 4278190080u) == 0u) {
                            } else {
                                let _e898 = local_2.len;
                                if (_e898 < 32u) {
                                    let _e901 = local_2.group;
                                    let _e903 = local_2.len;
                                    if (_e903 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e903)] = _e901;
                                    let _e909 = local_2.group_mask;
                                    let _e911 = local_2.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e911)] = _e909;
                                    let _e918 = local_2.len;
                                    local_2.len = (_e918 + 1u);
                                }
                            }
                            local_2.group = (_e112 + _e882);
                            let _e922 = local_4;
                            local_2.group_mask = ((_e922 & 4278190080u) | (_e886 >> bitcast<u32>(24i)));
                        }
                        let _e927 = local_5;
                        phi_1433_ = (_e927 & 16777215u);
                        phi_1436_ = _e494;
                        loop {
                            let _e930 = phi_1433_;
                            let _e932 = phi_1436_;
                            local_18 = _e932;
                            let _e933 = (_e930 == 0u);
                            local_11 = _e933;
                            local_19 = _e933;
                            if _e933 {
                                phi_1434_ = u32();
                                phi_1437_ = bool();
                                phi_3295_ = false;
                            } else {
                                let _e936 = nodes.member[(0u + _e492)].links[1u];
                                let _e940 = (_e936 + select(firstTrailingBit(_e930), 32u, (_e930 == 0u)));
                                if (_e940 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e947 = instances.member[(0u + _e940)].low_world;
                                let _e949 = instances.member[(0u + _e940)].high_world;
                                let _e956 = ((_e947.x - _e132) * _e282);
                                let _e957 = ((_e947.y - _e134) * _e292);
                                let _e958 = ((_e947.z - _e136) * _e302);
                                let _e965 = ((_e949.x - _e132) * _e282);
                                let _e966 = ((_e949.y - _e134) * _e292);
                                let _e967 = ((_e949.z - _e136) * _e302);
                                if (_e956 < _e965) {
                                    phi_1485_ = _e956;
                                } else {
                                    phi_1485_ = _e965;
                                }
                                let _e970 = phi_1485_;
                                if (_e957 < _e966) {
                                    phi_1490_ = _e957;
                                } else {
                                    phi_1490_ = _e966;
                                }
                                let _e973 = phi_1490_;
                                if (_e958 < _e967) {
                                    phi_1495_ = _e958;
                                } else {
                                    phi_1495_ = _e967;
                                }
                                let _e976 = phi_1495_;
                                if (_e956 > _e965) {
                                    phi_1503_ = _e956;
                                } else {
                                    phi_1503_ = _e965;
                                }
                                let _e982 = phi_1503_;
                                if (_e957 > _e966) {
                                    phi_1508_ = _e957;
                                } else {
                                    phi_1508_ = _e966;
                                }
                                let _e985 = phi_1508_;
                                if (_e958 > _e967) {
                                    phi_1513_ = _e958;
                                } else {
                                    phi_1513_ = _e967;
                                }
                                let _e988 = phi_1513_;
                                let _e992 = core_intrinsics_maximum_number_nsz_f32_((_e970 - _e341), (_e973 - _e342));
                                let _e993 = core_intrinsics_maximum_number_nsz_f32_(_e992, (_e976 - _e343));
                                let _e994 = core_intrinsics_minimum_number_nsz_f32_((_e982 + _e341), (_e985 + _e342));
                                let _e995 = core_intrinsics_minimum_number_nsz_f32_(_e994, (_e988 + _e343));
                                if (_e993 <= _e995) {
                                    if (_e993 <= _e142) {
                                        if (_e995 >= 0f) {
                                            let _e1001 = instances.member[(0u + _e940)].world_to_object[0u];
                                            let _e1012 = ((((_e1001.x * _e132) + (_e1001.y * _e134)) + (_e1001.z * _e136)) + (_e1001.w * 1f));
                                            let _e1014 = instances.member[(0u + _e940)].world_to_object[1u];
                                            let _e1025 = ((((_e1014.x * _e132) + (_e1014.y * _e134)) + (_e1014.z * _e136)) + (_e1014.w * 1f));
                                            let _e1027 = instances.member[(0u + _e940)].world_to_object[2u];
                                            let _e1038 = ((((_e1027.x * _e132) + (_e1027.y * _e134)) + (_e1027.z * _e136)) + (_e1027.w * 1f));
                                            let _e1041 = instances.member[(0u + _e940)].world_to_object[0u];
                                            let _e1052 = ((((_e1041.x * _e150) + (_e1041.y * _e151)) + (_e1041.z * _e152)) + (_e1041.w * 0f));
                                            let _e1054 = instances.member[(0u + _e940)].world_to_object[1u];
                                            let _e1065 = ((((_e1054.x * _e150) + (_e1054.y * _e151)) + (_e1054.z * _e152)) + (_e1054.w * 0f));
                                            let _e1067 = instances.member[(0u + _e940)].world_to_object[2u];
                                            let _e1078 = ((((_e1067.x * _e150) + (_e1067.y * _e151)) + (_e1067.z * _e152)) + (_e1067.w * 0f));
                                            let _e1081 = instances.member[(0u + _e940)].root;
                                            let _e1083 = instances.member[(0u + _e940)].first_triangle;
                                            let _e1084 = abs(_e1052);
                                            let _e1085 = abs(_e1065);
                                            let _e1086 = abs(_e1078);
                                            if (abs(_e1012) < 1000000000000000f) {
                                                if (abs(_e1025) < 1000000000000000f) {
                                                    phi_1633_ = (abs(_e1038) < 1000000000000000f);
                                                    phi_1634_ = false;
                                                } else {
                                                    phi_1633_ = bool();
                                                    phi_1634_ = true;
                                                }
                                                let _e1094 = phi_1633_;
                                                let _e1096 = phi_1634_;
                                                phi_1635_ = _e1094;
                                                phi_1636_ = _e1096;
                                            } else {
                                                phi_1635_ = bool();
                                                phi_1636_ = true;
                                            }
                                            let _e1098 = phi_1635_;
                                            let _e1100 = phi_1636_;
                                            if _e1100 {
                                                phi_1640_ = false;
                                            } else {
                                                phi_1640_ = _e1098;
                                            }
                                            let _e1102 = phi_1640_;
                                            if _e1102 {
                                                if (_e1084 < 1000000000000000f) {
                                                    if (_e1085 < 1000000000000000f) {
                                                        phi_1653_ = (_e1086 < 1000000000000000f);
                                                        phi_1654_ = false;
                                                    } else {
                                                        phi_1653_ = bool();
                                                        phi_1654_ = true;
                                                    }
                                                    let _e1107 = phi_1653_;
                                                    let _e1109 = phi_1654_;
                                                    phi_1655_ = _e1107;
                                                    phi_1656_ = _e1109;
                                                } else {
                                                    phi_1655_ = bool();
                                                    phi_1656_ = true;
                                                }
                                                let _e1111 = phi_1655_;
                                                let _e1113 = phi_1656_;
                                                if _e1113 {
                                                    phi_1660_ = false;
                                                } else {
                                                    phi_1660_ = _e1111;
                                                }
                                                let _e1115 = phi_1660_;
                                                if _e1115 {
                                                    if (_e1084 > 0f) {
                                                        phi_1674_ = bool();
                                                        phi_1675_ = true;
                                                    } else {
                                                        let _e1117 = (_e1085 > 0f);
                                                        if _e1117 {
                                                            phi_1673_ = bool();
                                                        } else {
                                                            phi_1673_ = (_e1086 > 0f);
                                                        }
                                                        let _e1120 = phi_1673_;
                                                        phi_1674_ = _e1120;
                                                        phi_1675_ = _e1117;
                                                    }
                                                    let _e1122 = phi_1674_;
                                                    let _e1124 = phi_1675_;
                                                    if _e1124 {
                                                        phi_1679_ = true;
                                                    } else {
                                                        phi_1679_ = _e1122;
                                                    }
                                                    let _e1126 = phi_1679_;
                                                    phi_1680_ = _e1126;
                                                    phi_1681_ = false;
                                                } else {
                                                    phi_1680_ = bool();
                                                    phi_1681_ = true;
                                                }
                                                let _e1128 = phi_1680_;
                                                let _e1130 = phi_1681_;
                                                phi_1682_ = _e1128;
                                                phi_1683_ = _e1130;
                                            } else {
                                                phi_1682_ = bool();
                                                phi_1683_ = true;
                                            }
                                            let _e1132 = phi_1682_;
                                            let _e1134 = phi_1683_;
                                            if _e1134 {
                                                phi_1687_ = false;
                                            } else {
                                                phi_1687_ = _e1132;
                                            }
                                            let _e1136 = phi_1687_;
                                            if _e1136 {
                                                let _e1137 = (_e1081 >= _e76);
                                                if _e1137 {
                                                    phi_3275_ = bool();
                                                } else {
                                                    if (_e1081 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1143 = nodes.member[(0u + _e1081)].frame[0u];
                                                    let _e1147 = nodes.member[(0u + _e1081)].frame[1u];
                                                    let _e1151 = nodes.member[(0u + _e1081)].frame[2u];
                                                    let _e1155 = nodes.member[(0u + _e1081)].frame[0u];
                                                    let _e1159 = nodes.member[(0u + _e1081)].frame[1u];
                                                    let _e1163 = nodes.member[(0u + _e1081)].frame[2u];
                                                    let _e1167 = nodes.member[(0u + _e1081)].frame[3u];
                                                    let _e1201 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1052), abs(_e1065));
                                                    let _e1202 = core_intrinsics_maximum_number_nsz_f32_(_e1201, abs(_e1078));
                                                    let _e1203 = (_e1202 * 0.0000000000009094947f);
                                                    if (abs(_e1052) < _e1203) {
                                                        phi_1757_ = _e1203;
                                                    } else {
                                                        phi_1757_ = abs(_e1052);
                                                    }
                                                    let _e1208 = phi_1757_;
                                                    if (_e1052 < 0f) {
                                                        phi_1764_ = (-1f / _e1208);
                                                    } else {
                                                        phi_1764_ = (1f / _e1208);
                                                    }
                                                    let _e1213 = phi_1764_;
                                                    if (abs(_e1065) < _e1203) {
                                                        phi_1771_ = _e1203;
                                                    } else {
                                                        phi_1771_ = abs(_e1065);
                                                    }
                                                    let _e1218 = phi_1771_;
                                                    if (_e1065 < 0f) {
                                                        phi_1778_ = (-1f / _e1218);
                                                    } else {
                                                        phi_1778_ = (1f / _e1218);
                                                    }
                                                    let _e1223 = phi_1778_;
                                                    if (abs(_e1078) < _e1203) {
                                                        phi_1785_ = _e1203;
                                                    } else {
                                                        phi_1785_ = abs(_e1078);
                                                    }
                                                    let _e1228 = phi_1785_;
                                                    if (_e1078 < 0f) {
                                                        phi_1792_ = (-1f / _e1228);
                                                    } else {
                                                        phi_1792_ = (1f / _e1228);
                                                    }
                                                    let _e1233 = phi_1792_;
                                                    let _e1237 = abs((bitcast<f32>(_e1143) - _e1012));
                                                    let _e1238 = abs((bitcast<f32>(_e1147) - _e1025));
                                                    let _e1239 = abs((bitcast<f32>(_e1151) - _e1038));
                                                    let _e1243 = abs(((bitcast<f32>(_e1155) + (bitcast<f32>((((_e1167 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1012));
                                                    let _e1244 = abs(((bitcast<f32>(_e1159) + (bitcast<f32>((((_e1167 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1025));
                                                    let _e1245 = abs(((bitcast<f32>(_e1163) + (bitcast<f32>((((_e1167 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1038));
                                                    if (_e1237 > _e1243) {
                                                        phi_1809_ = _e1237;
                                                    } else {
                                                        phi_1809_ = _e1243;
                                                    }
                                                    let _e1248 = phi_1809_;
                                                    if (_e1238 > _e1244) {
                                                        phi_1814_ = _e1238;
                                                    } else {
                                                        phi_1814_ = _e1244;
                                                    }
                                                    let _e1251 = phi_1814_;
                                                    if (_e1239 > _e1245) {
                                                        phi_1819_ = _e1239;
                                                    } else {
                                                        phi_1819_ = _e1245;
                                                    }
                                                    let _e1254 = phi_1819_;
                                                    if (_e1248 > _e1251) {
                                                        phi_1824_ = _e1248;
                                                    } else {
                                                        phi_1824_ = _e1251;
                                                    }
                                                    let _e1257 = phi_1824_;
                                                    if (_e1257 > _e1254) {
                                                        phi_1829_ = _e1257;
                                                    } else {
                                                        phi_1829_ = _e1254;
                                                    }
                                                    let _e1260 = phi_1829_;
                                                    let _e1264 = (_e1260 * 0.0000019073486f);
                                                    let _e1265 = (abs(_e1213) * _e1264);
                                                    let _e1266 = (abs(_e1223) * _e1264);
                                                    let _e1267 = (abs(_e1233) * _e1264);
                                                    let _e1271 = (_e1260 * 0.0000009536743f);
                                                    let _e1272 = (abs(_e1213) * _e1271);
                                                    let _e1273 = (abs(_e1223) * _e1271);
                                                    let _e1274 = (abs(_e1233) * _e1271);
                                                    let _e1275 = abs(_e1052);
                                                    let _e1276 = abs(_e1065);
                                                    let _e1277 = abs(_e1078);
                                                    if (_e1275 >= _e1276) {
                                                        if (_e1275 >= _e1277) {
                                                            phi_1855_ = false;
                                                        } else {
                                                            phi_1855_ = true;
                                                        }
                                                        let _e1281 = phi_1855_;
                                                        phi_1856_ = _e1281;
                                                    } else {
                                                        phi_1856_ = true;
                                                    }
                                                    let _e1283 = phi_1856_;
                                                    if _e1283 {
                                                        if (_e1276 >= _e1277) {
                                                            phi_1864_ = 1u;
                                                        } else {
                                                            phi_1864_ = 2u;
                                                        }
                                                        let _e1286 = phi_1864_;
                                                        phi_1865_ = _e1286;
                                                    } else {
                                                        phi_1865_ = 0u;
                                                    }
                                                    let _e1288 = phi_1865_;
                                                    if (_e1288 == 0u) {
                                                        phi_1877_ = vec3<f32>(_e1065, _e1078, _e1052);
                                                    } else {
                                                        if (_e1288 == 1u) {
                                                            phi_1876_ = vec3<f32>(_e1078, _e1052, _e1065);
                                                        } else {
                                                            phi_1876_ = vec3<f32>(_e1052, _e1065, _e1078);
                                                        }
                                                        let _e1294 = phi_1876_;
                                                        phi_1877_ = _e1294;
                                                    }
                                                    let _e1296 = phi_1877_;
                                                    let _e1299 = (_e1296.x / _e1296.z);
                                                    let _e1302 = (_e1296.y / _e1296.z);
                                                    if (_e1213 < 0f) {
                                                        phi_1890_ = 0u;
                                                    } else {
                                                        phi_1890_ = 1u;
                                                    }
                                                    let _e1307 = phi_1890_;
                                                    if (_e1223 < 0f) {
                                                        phi_1895_ = 0u;
                                                    } else {
                                                        phi_1895_ = 2u;
                                                    }
                                                    let _e1310 = phi_1895_;
                                                    if (_e1233 < 0f) {
                                                        phi_1900_ = 0u;
                                                    } else {
                                                        phi_1900_ = 4u;
                                                    }
                                                    let _e1313 = phi_1900_;
                                                    let _e1315 = ((_e1307 | _e1310) | _e1313);
                                                    let _e1316 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1081, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1316.first[0], _e1316.first[1], _e1316.first[2], _e1316.first[3], _e1316.first[4], _e1316.first[5], _e1316.first[6], _e1316.first[7], _e1316.first[8], _e1316.first[9], _e1316.first[10], _e1316.first[11], _e1316.first[12], _e1316.first[13], _e1316.first[14], _e1316.first[15], _e1316.first[16], _e1316.first[17], _e1316.first[18], _e1316.first[19], _e1316.first[20], _e1316.first[21], _e1316.first[22], _e1316.first[23], _e1316.first[24], _e1316.first[25], _e1316.first[26], _e1316.first[27], _e1316.first[28], _e1316.first[29], _e1316.first[30], _e1316.first[31]), array<u32, 32>(_e1316.mask[0], _e1316.mask[1], _e1316.mask[2], _e1316.mask[3], _e1316.mask[4], _e1316.mask[5], _e1316.mask[6], _e1316.mask[7], _e1316.mask[8], _e1316.mask[9], _e1316.mask[10], _e1316.mask[11], _e1316.mask[12], _e1316.mask[13], _e1316.mask[14], _e1316.mask[15], _e1316.mask[16], _e1316.mask[17], _e1316.mask[18], _e1316.mask[19], _e1316.mask[20], _e1316.mask[21], _e1316.mask[22], _e1316.mask[23], _e1316.mask[24], _e1316.mask[25], _e1316.mask[26], _e1316.mask[27], _e1316.mask[28], _e1316.mask[29], _e1316.mask[30], _e1316.mask[31]), _e1316.len, _e1316.group, _e1316.group_mask);
                                                    let _e1390 = local_1.group_mask;
                                                    if ((_e1390 & 4278190080u) == 0u) {
                                                        let _e1394 = local_1.len;
                                                        if (_e1394 == 0u) {
                                                            phi_2014_ = false;
                                                        } else {
                                                            let _e1398 = local_1.len;
                                                            local_1.len = (_e1398 - 1u);
                                                            let _e1401 = local_1.len;
                                                            if (_e1401 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1406 = local_1.first[(0u + _e1401)];
                                                            local_1.group = _e1406;
                                                            let _e1409 = local_1.len;
                                                            if (_e1409 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1414 = local_1.mask[(0u + _e1409)];
                                                            local_1.group_mask = _e1414;
                                                            phi_2014_ = true;
                                                        }
                                                        let _e1417 = phi_2014_;
                                                        phi_2015_ = _e1417;
                                                    } else {
                                                        phi_2015_ = true;
                                                    }
                                                    let _e1419 = phi_2015_;
                                                    if _e1419 {
                                                        let _e1421 = local_1.group_mask;
                                                        let _e1427 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1421)), 32u, (_e1421 == 0u)));
                                                        let _e1431 = local_1.group_mask;
                                                        let _e1445 = local_1.group_mask;
                                                        local_1.group_mask = (_e1445 & ~((1u << bitcast<u32>((_e1427 & 31u)))));
                                                        let _e1448 = local_1.group;
                                                        phi_2046_ = (_e1448 + countOneBits(((_e1431 & ~((4294967295u << bitcast<u32>((((_e1427 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2046_ = 4294967295u;
                                                    }
                                                    let _e1451 = phi_2046_;
                                                    phi_2048_ = _e1451;
                                                    phi_2051_ = _e932;
                                                    loop {
                                                        let _e1453 = phi_2048_;
                                                        let _e1455 = phi_2051_;
                                                        local_17 = _e1455;
                                                        if (_e1453 != 4294967295u) {
                                                            if (_e1453 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1462 = nodes.member[(0u + _e1453)].frame[3u];
                                                            let _e1487 = (bitcast<f32>((((_e1462 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1213);
                                                            let _e1488 = (bitcast<f32>((((_e1462 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1223);
                                                            let _e1489 = (bitcast<f32>((((_e1462 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1233);
                                                            let _e1492 = nodes.member[(0u + _e1453)].frame[0u];
                                                            let _e1496 = nodes.member[(0u + _e1453)].frame[1u];
                                                            let _e1500 = nodes.member[(0u + _e1453)].frame[2u];
                                                            let _e1505 = ((bitcast<f32>(_e1492) - _e1012) * _e1213);
                                                            let _e1506 = ((bitcast<f32>(_e1496) - _e1025) * _e1223);
                                                            let _e1507 = ((bitcast<f32>(_e1500) - _e1038) * _e1233);
                                                            let _e1515 = nodes.member[(0u + _e1453)].x;
                                                            if (_e1213 < 0f) {
                                                                let _e1526 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1515.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1532 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1526.unnamed.word, _e1515.w), _e1526.unnamed_1);
                                                                let _e1538 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1532.unnamed, lt_mask_LightPlace(_e1515.x, _e1532.unnamed_1.shift));
                                                                phi_2131_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1538.unnamed, lt_mask_LightPlace(_e1538.unnamed_1.word, _e1515.y));
                                                            } else {
                                                                let _e1554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1515.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1560 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1554.unnamed.word, _e1515.y), _e1554.unnamed_1);
                                                                let _e1566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1560.unnamed, lt_mask_LightPlace(_e1515.z, _e1560.unnamed_1.shift));
                                                                phi_2131_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1566.unnamed, lt_mask_LightPlace(_e1566.unnamed_1.word, _e1515.w));
                                                            }
                                                            let _e1574 = phi_2131_;
                                                            let _e1584 = nodes.member[(0u + _e1453)].y;
                                                            if (_e1223 < 0f) {
                                                                let _e1595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1595.unnamed.word, _e1584.w), _e1595.unnamed_1);
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1601.unnamed, lt_mask_LightPlace(_e1584.x, _e1601.unnamed_1.shift));
                                                                phi_2158_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1607.unnamed, lt_mask_LightPlace(_e1607.unnamed_1.word, _e1584.y));
                                                            } else {
                                                                let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1623.unnamed.word, _e1584.y), _e1623.unnamed_1);
                                                                let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1629.unnamed, lt_mask_LightPlace(_e1584.z, _e1629.unnamed_1.shift));
                                                                phi_2158_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1635.unnamed, lt_mask_LightPlace(_e1635.unnamed_1.word, _e1584.w));
                                                            }
                                                            let _e1643 = phi_2158_;
                                                            let _e1653 = nodes.member[(0u + _e1453)].z;
                                                            if (_e1233 < 0f) {
                                                                let _e1664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1664.unnamed.word, _e1653.w), _e1664.unnamed_1);
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1670.unnamed, lt_mask_LightPlace(_e1653.x, _e1670.unnamed_1.shift));
                                                                phi_2185_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1676.unnamed, lt_mask_LightPlace(_e1676.unnamed_1.word, _e1653.y));
                                                            } else {
                                                                let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1692.unnamed.word, _e1653.y), _e1692.unnamed_1);
                                                                let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1698.unnamed, lt_mask_LightPlace(_e1653.z, _e1698.unnamed_1.shift));
                                                                phi_2185_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1704.unnamed, lt_mask_LightPlace(_e1704.unnamed_1.word, _e1653.w));
                                                            }
                                                            let _e1712 = phi_2185_;
                                                            phi_2191_ = 0u;
                                                            phi_2194_ = 0u;
                                                            loop {
                                                                let _e1722 = phi_2191_;
                                                                let _e1724 = phi_2194_;
                                                                local_6 = _e1724;
                                                                local_7 = _e1724;
                                                                local_8 = _e1724;
                                                                let _e1725 = (_e1722 < 8u);
                                                                if _e1725 {
                                                                    let _e1727 = (_e1722 >> bitcast<u32>(2i));
                                                                    let _e1728 = (_e1722 & 3u);
                                                                    if (_e1727 == 0u) {
                                                                        phi_2208_ = _e1574.unnamed.word;
                                                                    } else {
                                                                        phi_2208_ = _e1574.unnamed.shift;
                                                                    }
                                                                    let _e1731 = phi_2208_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2218_ = _e1643.unnamed.word;
                                                                    } else {
                                                                        phi_2218_ = _e1643.unnamed.shift;
                                                                    }
                                                                    let _e1740 = phi_2218_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2228_ = _e1712.unnamed.word;
                                                                    } else {
                                                                        phi_2228_ = _e1712.unnamed.shift;
                                                                    }
                                                                    let _e1749 = phi_2228_;
                                                                    let _e1762 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1731 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1487) + (_e1505 - _e1265)), ((f32(((_e1740 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 - _e1266)));
                                                                    let _e1763 = core_intrinsics_maximum_number_nsz_f32_(_e1762, ((f32(((_e1749 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 - _e1267)));
                                                                    if (_e1727 == 0u) {
                                                                        phi_2246_ = _e1574.unnamed_1.word;
                                                                    } else {
                                                                        phi_2246_ = _e1574.unnamed_1.shift;
                                                                    }
                                                                    let _e1766 = phi_2246_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2256_ = _e1643.unnamed_1.word;
                                                                    } else {
                                                                        phi_2256_ = _e1643.unnamed_1.shift;
                                                                    }
                                                                    let _e1775 = phi_2256_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2266_ = _e1712.unnamed_1.word;
                                                                    } else {
                                                                        phi_2266_ = _e1712.unnamed_1.shift;
                                                                    }
                                                                    let _e1784 = phi_2266_;
                                                                    let _e1797 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1766 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1487) + (_e1505 + _e1265)), ((f32(((_e1775 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 + _e1266)));
                                                                    let _e1798 = core_intrinsics_minimum_number_nsz_f32_(_e1797, ((f32(((_e1784 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 + _e1267)));
                                                                    if (_e1763 <= _e1798) {
                                                                        if (_e1763 <= _e142) {
                                                                            if (_e1798 >= 0f) {
                                                                                if (_e1727 == 0u) {
                                                                                    let _e1805 = nodes.member[(0u + _e1453)].links[2u];
                                                                                    phi_2302_ = _e1805;
                                                                                } else {
                                                                                    let _e1808 = nodes.member[(0u + _e1453)].links[3u];
                                                                                    phi_2302_ = _e1808;
                                                                                }
                                                                                let _e1810 = phi_2302_;
                                                                                let _e1815 = ((_e1810 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u);
                                                                                let _e1816 = (_e1815 & 31u);
                                                                                if (_e1816 >= 24u) {
                                                                                    phi_2315_ = (24u + ((_e1816 - 24u) ^ _e1315));
                                                                                } else {
                                                                                    phi_2315_ = _e1816;
                                                                                }
                                                                                let _e1822 = phi_2315_;
                                                                                phi_2320_ = (_e1724 | ((_e1815 >> bitcast<u32>(5i)) << bitcast<u32>((_e1822 & 31u))));
                                                                            } else {
                                                                                phi_2320_ = _e1724;
                                                                            }
                                                                            let _e1830 = phi_2320_;
                                                                            phi_2321_ = _e1830;
                                                                        } else {
                                                                            phi_2321_ = _e1724;
                                                                        }
                                                                        let _e1832 = phi_2321_;
                                                                        phi_2322_ = _e1832;
                                                                    } else {
                                                                        phi_2322_ = _e1724;
                                                                    }
                                                                    let _e1834 = phi_2322_;
                                                                    phi_2192_ = (_e1722 + 1u);
                                                                    phi_2195_ = _e1834;
                                                                } else {
                                                                    phi_2192_ = u32();
                                                                    phi_2195_ = u32();
                                                                }
                                                                let _e1837 = phi_2192_;
                                                                let _e1839 = phi_2195_;
                                                                continue;
                                                                continuing {
                                                                    phi_2191_ = _e1837;
                                                                    phi_2194_ = _e1839;
                                                                    break if !(_e1725);
                                                                }
                                                            }
                                                            let _e1843 = nodes.member[(0u + _e1453)].links[0u];
                                                            let _e1847 = nodes.member[(0u + _e1453)].frame[3u];
                                                            let _e1851 = local_6;
                                                            if ((_e1851 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1855 = local_1.group_mask;
                                                                if ((_e1855 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1859 = local_1.len;
                                                                    if (_e1859 < 32u) {
                                                                        let _e1862 = local_1.group;
                                                                        let _e1864 = local_1.len;
                                                                        if (_e1864 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1864)] = _e1862;
                                                                        let _e1870 = local_1.group_mask;
                                                                        let _e1872 = local_1.len;
                                                                        if (_e1872 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1872)] = _e1870;
                                                                        let _e1879 = local_1.len;
                                                                        local_1.len = (_e1879 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1081 + _e1843);
                                                                let _e1883 = local_7;
                                                                local_1.group_mask = ((_e1883 & 4278190080u) | (_e1847 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1888 = local_8;
                                                            phi_2380_ = (_e1888 & 16777215u);
                                                            phi_2383_ = _e1455;
                                                            loop {
                                                                let _e1891 = phi_2380_;
                                                                let _e1893 = phi_2383_;
                                                                local_13 = _e1893;
                                                                let _e1894 = (_e1891 == 0u);
                                                                local_9 = _e1894;
                                                                local_15 = _e1894;
                                                                if _e1894 {
                                                                    phi_2381_ = u32();
                                                                    phi_2384_ = bool();
                                                                    phi_3187_ = bool();
                                                                    phi_3188_ = false;
                                                                } else {
                                                                    let _e1897 = nodes.member[(0u + _e1453)].links[1u];
                                                                    let _e1902 = ((_e1083 + _e1897) + select(firstTrailingBit(_e1891), 32u, (_e1891 == 0u)));
                                                                    if (_e1902 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1909 = triangles.member[(0u + _e1902)].v0_;
                                                                    let _e1911 = (_e1909.x - _e1012);
                                                                    let _e1913 = (_e1909.y - _e1025);
                                                                    let _e1915 = (_e1909.z - _e1038);
                                                                    if (_e1288 == 0u) {
                                                                        phi_2428_ = vec3<f32>(_e1913, _e1915, _e1911);
                                                                    } else {
                                                                        if (_e1288 == 1u) {
                                                                            phi_2427_ = vec3<f32>(_e1915, _e1911, _e1913);
                                                                        } else {
                                                                            phi_2427_ = (_e1909 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1923 = phi_2427_;
                                                                        phi_2428_ = _e1923;
                                                                    }
                                                                    let _e1925 = phi_2428_;
                                                                    let _e1929 = (_e1925.x - (_e1299 * _e1925.z));
                                                                    let _e1933 = (_e1925.y - (_e1302 * _e1925.z));
                                                                    let _e1935 = triangles.member[(0u + _e1902)].v1_;
                                                                    let _e1937 = (_e1935.x - _e1012);
                                                                    let _e1939 = (_e1935.y - _e1025);
                                                                    let _e1941 = (_e1935.z - _e1038);
                                                                    if (_e1288 == 0u) {
                                                                        phi_2458_ = vec3<f32>(_e1939, _e1941, _e1937);
                                                                    } else {
                                                                        if (_e1288 == 1u) {
                                                                            phi_2457_ = vec3<f32>(_e1941, _e1937, _e1939);
                                                                        } else {
                                                                            phi_2457_ = (_e1935 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1949 = phi_2457_;
                                                                        phi_2458_ = _e1949;
                                                                    }
                                                                    let _e1951 = phi_2458_;
                                                                    let _e1955 = (_e1951.x - (_e1299 * _e1951.z));
                                                                    let _e1959 = (_e1951.y - (_e1302 * _e1951.z));
                                                                    let _e1961 = triangles.member[(0u + _e1902)].v2_;
                                                                    let _e1963 = (_e1961.x - _e1012);
                                                                    let _e1965 = (_e1961.y - _e1025);
                                                                    let _e1967 = (_e1961.z - _e1038);
                                                                    if (_e1288 == 0u) {
                                                                        phi_2488_ = vec3<f32>(_e1965, _e1967, _e1963);
                                                                    } else {
                                                                        if (_e1288 == 1u) {
                                                                            phi_2487_ = vec3<f32>(_e1967, _e1963, _e1965);
                                                                        } else {
                                                                            phi_2487_ = (_e1961 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1975 = phi_2487_;
                                                                        phi_2488_ = _e1975;
                                                                    }
                                                                    let _e1977 = phi_2488_;
                                                                    let _e1981 = (_e1977.x - (_e1299 * _e1977.z));
                                                                    let _e1985 = (_e1977.y - (_e1302 * _e1977.z));
                                                                    if (_e1955 < _e1981) {
                                                                        phi_2507_ = true;
                                                                    } else {
                                                                        if (_e1955 == _e1981) {
                                                                            phi_2506_ = (_e1959 < _e1985);
                                                                        } else {
                                                                            phi_2506_ = false;
                                                                        }
                                                                        let _e1990 = phi_2506_;
                                                                        phi_2507_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2507_;
                                                                    if _e1992 {
                                                                        phi_2511_ = _e1985;
                                                                        phi_2512_ = _e1981;
                                                                        phi_2513_ = _e1959;
                                                                        phi_2514_ = _e1955;
                                                                    } else {
                                                                        phi_2511_ = _e1959;
                                                                        phi_2512_ = _e1955;
                                                                        phi_2513_ = _e1985;
                                                                        phi_2514_ = _e1981;
                                                                    }
                                                                    let _e1994 = phi_2511_;
                                                                    let _e1996 = phi_2512_;
                                                                    let _e1998 = phi_2513_;
                                                                    let _e2000 = phi_2514_;
                                                                    let _e2003 = ((_e2000 * _e1994) - (_e1998 * _e1996));
                                                                    if _e1992 {
                                                                        phi_2522_ = -(_e2003);
                                                                    } else {
                                                                        phi_2522_ = _e2003;
                                                                    }
                                                                    let _e2006 = phi_2522_;
                                                                    if (_e1981 < _e1929) {
                                                                        phi_2533_ = true;
                                                                    } else {
                                                                        if (_e1981 == _e1929) {
                                                                            phi_2532_ = (_e1985 < _e1933);
                                                                        } else {
                                                                            phi_2532_ = false;
                                                                        }
                                                                        let _e2011 = phi_2532_;
                                                                        phi_2533_ = _e2011;
                                                                    }
                                                                    let _e2013 = phi_2533_;
                                                                    if _e2013 {
                                                                        phi_2537_ = _e1933;
                                                                        phi_2538_ = _e1929;
                                                                        phi_2539_ = _e1985;
                                                                        phi_2540_ = _e1981;
                                                                    } else {
                                                                        phi_2537_ = _e1985;
                                                                        phi_2538_ = _e1981;
                                                                        phi_2539_ = _e1933;
                                                                        phi_2540_ = _e1929;
                                                                    }
                                                                    let _e2015 = phi_2537_;
                                                                    let _e2017 = phi_2538_;
                                                                    let _e2019 = phi_2539_;
                                                                    let _e2021 = phi_2540_;
                                                                    let _e2024 = ((_e2021 * _e2015) - (_e2019 * _e2017));
                                                                    if _e2013 {
                                                                        phi_2548_ = -(_e2024);
                                                                    } else {
                                                                        phi_2548_ = _e2024;
                                                                    }
                                                                    let _e2027 = phi_2548_;
                                                                    if (_e1929 < _e1955) {
                                                                        phi_2559_ = true;
                                                                    } else {
                                                                        if (_e1929 == _e1955) {
                                                                            phi_2558_ = (_e1933 < _e1959);
                                                                        } else {
                                                                            phi_2558_ = false;
                                                                        }
                                                                        let _e2032 = phi_2558_;
                                                                        phi_2559_ = _e2032;
                                                                    }
                                                                    let _e2034 = phi_2559_;
                                                                    if _e2034 {
                                                                        phi_2563_ = _e1959;
                                                                        phi_2564_ = _e1955;
                                                                        phi_2565_ = _e1933;
                                                                        phi_2566_ = _e1929;
                                                                    } else {
                                                                        phi_2563_ = _e1933;
                                                                        phi_2564_ = _e1929;
                                                                        phi_2565_ = _e1959;
                                                                        phi_2566_ = _e1955;
                                                                    }
                                                                    let _e2036 = phi_2563_;
                                                                    let _e2038 = phi_2564_;
                                                                    let _e2040 = phi_2565_;
                                                                    let _e2042 = phi_2566_;
                                                                    let _e2045 = ((_e2042 * _e2036) - (_e2040 * _e2038));
                                                                    if _e2034 {
                                                                        phi_2574_ = -(_e2045);
                                                                    } else {
                                                                        phi_2574_ = _e2045;
                                                                    }
                                                                    let _e2048 = phi_2574_;
                                                                    if (_e2006 >= 0f) {
                                                                        if (_e2027 >= 0f) {
                                                                            if (_e2048 >= 0f) {
                                                                                phi_2589_ = ((_e2006 + _e2027) + _e2048);
                                                                                phi_2590_ = false;
                                                                            } else {
                                                                                phi_2589_ = f32();
                                                                                phi_2590_ = true;
                                                                            }
                                                                            let _e2055 = phi_2589_;
                                                                            let _e2057 = phi_2590_;
                                                                            phi_2591_ = _e2055;
                                                                            phi_2592_ = _e2057;
                                                                        } else {
                                                                            phi_2591_ = f32();
                                                                            phi_2592_ = true;
                                                                        }
                                                                        let _e2059 = phi_2591_;
                                                                        let _e2061 = phi_2592_;
                                                                        phi_2593_ = _e2059;
                                                                        phi_2594_ = _e2061;
                                                                    } else {
                                                                        phi_2593_ = f32();
                                                                        phi_2594_ = true;
                                                                    }
                                                                    let _e2063 = phi_2593_;
                                                                    let _e2065 = phi_2594_;
                                                                    if _e2065 {
                                                                        if (_e2006 <= 0f) {
                                                                            if (_e2027 <= 0f) {
                                                                                let _e2068 = (_e2048 <= 0f);
                                                                                if _e2068 {
                                                                                }
                                                                                phi_2612_ = ((_e2006 + _e2027) + _e2048);
                                                                                phi_2613_ = false;
                                                                                phi_2614_ = _e2068;
                                                                            } else {
                                                                                phi_2612_ = f32();
                                                                                phi_2613_ = true;
                                                                                phi_2614_ = false;
                                                                            }
                                                                            let _e2072 = phi_2612_;
                                                                            let _e2074 = phi_2613_;
                                                                            let _e2076 = phi_2614_;
                                                                            phi_2615_ = _e2072;
                                                                            phi_2616_ = _e2074;
                                                                            phi_2617_ = _e2076;
                                                                        } else {
                                                                            phi_2615_ = f32();
                                                                            phi_2616_ = true;
                                                                            phi_2617_ = false;
                                                                        }
                                                                        let _e2078 = phi_2615_;
                                                                        let _e2080 = phi_2616_;
                                                                        let _e2082 = phi_2617_;
                                                                        if _e2080 {
                                                                            phi_2621_ = false;
                                                                        } else {
                                                                            phi_2621_ = _e2082;
                                                                        }
                                                                        let _e2084 = phi_2621_;
                                                                        phi_2622_ = _e2078;
                                                                        phi_2623_ = _e2084;
                                                                    } else {
                                                                        phi_2622_ = _e2063;
                                                                        phi_2623_ = true;
                                                                    }
                                                                    let _e2086 = phi_2622_;
                                                                    let _e2088 = phi_2623_;
                                                                    if _e2088 {
                                                                        let _e2089 = (_e2086 == 0f);
                                                                        if _e2089 {
                                                                            phi_2939_ = lt_bvh_triangle_Intersection();
                                                                            phi_2940_ = false;
                                                                        } else {
                                                                            let _e2091 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2093 = (_e2091.x - _e1012);
                                                                            let _e2095 = (_e2091.y - _e1025);
                                                                            let _e2097 = (_e2091.z - _e1038);
                                                                            if (_e1288 == 0u) {
                                                                                phi_2652_ = vec3<f32>(_e2095, _e2097, _e2093);
                                                                            } else {
                                                                                if (_e1288 == 1u) {
                                                                                    phi_2651_ = vec3<f32>(_e2097, _e2093, _e2095);
                                                                                } else {
                                                                                    phi_2651_ = (_e2091 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                                }
                                                                                let _e2105 = phi_2651_;
                                                                                phi_2652_ = _e2105;
                                                                            }
                                                                            let _e2107 = phi_2652_;
                                                                            let _e2109 = triangles.member[(0u + _e1902)].v1_;
                                                                            let _e2111 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2114 = (_e2109.x - _e2111.x);
                                                                            let _e2117 = (_e2109.y - _e2111.y);
                                                                            let _e2120 = (_e2109.z - _e2111.z);
                                                                            if (_e1288 == 0u) {
                                                                                phi_2678_ = vec3<f32>(_e2117, _e2120, _e2114);
                                                                            } else {
                                                                                if (_e1288 == 1u) {
                                                                                    phi_2677_ = vec3<f32>(_e2120, _e2114, _e2117);
                                                                                } else {
                                                                                    phi_2677_ = (_e2109 - _e2111);
                                                                                }
                                                                                let _e2127 = phi_2677_;
                                                                                phi_2678_ = _e2127;
                                                                            }
                                                                            let _e2129 = phi_2678_;
                                                                            let _e2131 = triangles.member[(0u + _e1902)].v2_;
                                                                            let _e2133 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2136 = (_e2131.x - _e2133.x);
                                                                            let _e2139 = (_e2131.y - _e2133.y);
                                                                            let _e2142 = (_e2131.z - _e2133.z);
                                                                            if (_e1288 == 0u) {
                                                                                phi_2704_ = vec3<f32>(_e2139, _e2142, _e2136);
                                                                            } else {
                                                                                if (_e1288 == 1u) {
                                                                                    phi_2703_ = vec3<f32>(_e2142, _e2136, _e2139);
                                                                                } else {
                                                                                    phi_2703_ = (_e2131 - _e2133);
                                                                                }
                                                                                let _e2149 = phi_2703_;
                                                                                phi_2704_ = _e2149;
                                                                            }
                                                                            let _e2151 = phi_2704_;
                                                                            let _e2158 = ((_e2129.y * _e2151.z) - (_e2129.z * _e2151.y));
                                                                            let _e2165 = ((_e2129.z * _e2151.x) - (_e2129.x * _e2151.z));
                                                                            let _e2172 = ((_e2129.x * _e2151.y) - (_e2129.y * _e2151.x));
                                                                            let _e2186 = (((1f / _e1296.z) * (((_e2158 * _e2107.x) + (_e2165 * _e2107.y)) + (_e2172 * _e2107.z))) / (((_e2158 * _e1299) + (_e2165 * _e1302)) + _e2172));
                                                                            if (_e2186 > 0f) {
                                                                                if (_e2186 < _e142) {
                                                                                    let _e2190 = triangles.member[(0u + _e1902)].v0_;
                                                                                    let _e2192 = triangles.member[(0u + _e1902)].v1_;
                                                                                    if (_e2190.x < _e2192.x) {
                                                                                        phi_2760_ = _e2190.x;
                                                                                    } else {
                                                                                        phi_2760_ = _e2192.x;
                                                                                    }
                                                                                    let _e2199 = phi_2760_;
                                                                                    if (_e2190.y < _e2192.y) {
                                                                                        phi_2769_ = _e2190.y;
                                                                                    } else {
                                                                                        phi_2769_ = _e2192.y;
                                                                                    }
                                                                                    let _e2206 = phi_2769_;
                                                                                    if (_e2190.z < _e2192.z) {
                                                                                        phi_2778_ = _e2190.z;
                                                                                    } else {
                                                                                        phi_2778_ = _e2192.z;
                                                                                    }
                                                                                    let _e2213 = phi_2778_;
                                                                                    let _e2215 = triangles.member[(0u + _e1902)].v2_;
                                                                                    if (_e2199 < _e2215.x) {
                                                                                        phi_2787_ = _e2199;
                                                                                    } else {
                                                                                        phi_2787_ = _e2215.x;
                                                                                    }
                                                                                    let _e2220 = phi_2787_;
                                                                                    if (_e2206 < _e2215.y) {
                                                                                        phi_2794_ = _e2206;
                                                                                    } else {
                                                                                        phi_2794_ = _e2215.y;
                                                                                    }
                                                                                    let _e2225 = phi_2794_;
                                                                                    if (_e2213 < _e2215.z) {
                                                                                        phi_2801_ = _e2213;
                                                                                    } else {
                                                                                        phi_2801_ = _e2215.z;
                                                                                    }
                                                                                    let _e2230 = phi_2801_;
                                                                                    let _e2232 = triangles.member[(0u + _e1902)].v0_;
                                                                                    let _e2234 = triangles.member[(0u + _e1902)].v1_;
                                                                                    if (_e2232.x > _e2234.x) {
                                                                                        phi_2814_ = _e2232.x;
                                                                                    } else {
                                                                                        phi_2814_ = _e2234.x;
                                                                                    }
                                                                                    let _e2241 = phi_2814_;
                                                                                    if (_e2232.y > _e2234.y) {
                                                                                        phi_2823_ = _e2232.y;
                                                                                    } else {
                                                                                        phi_2823_ = _e2234.y;
                                                                                    }
                                                                                    let _e2248 = phi_2823_;
                                                                                    if (_e2232.z > _e2234.z) {
                                                                                        phi_2832_ = _e2232.z;
                                                                                    } else {
                                                                                        phi_2832_ = _e2234.z;
                                                                                    }
                                                                                    let _e2255 = phi_2832_;
                                                                                    let _e2257 = triangles.member[(0u + _e1902)].v2_;
                                                                                    if (_e2241 > _e2257.x) {
                                                                                        phi_2841_ = _e2241;
                                                                                    } else {
                                                                                        phi_2841_ = _e2257.x;
                                                                                    }
                                                                                    let _e2262 = phi_2841_;
                                                                                    if (_e2248 > _e2257.y) {
                                                                                        phi_2848_ = _e2248;
                                                                                    } else {
                                                                                        phi_2848_ = _e2257.y;
                                                                                    }
                                                                                    let _e2267 = phi_2848_;
                                                                                    if (_e2255 > _e2257.z) {
                                                                                        phi_2855_ = _e2255;
                                                                                    } else {
                                                                                        phi_2855_ = _e2257.z;
                                                                                    }
                                                                                    let _e2272 = phi_2855_;
                                                                                    let _e2276 = ((_e2220 - _e1012) * _e1213);
                                                                                    let _e2277 = ((_e2225 - _e1025) * _e1223);
                                                                                    let _e2278 = ((_e2230 - _e1038) * _e1233);
                                                                                    let _e2282 = ((_e2262 - _e1012) * _e1213);
                                                                                    let _e2283 = ((_e2267 - _e1025) * _e1223);
                                                                                    let _e2284 = ((_e2272 - _e1038) * _e1233);
                                                                                    if (_e2276 < _e2282) {
                                                                                        phi_2872_ = _e2276;
                                                                                    } else {
                                                                                        phi_2872_ = _e2282;
                                                                                    }
                                                                                    let _e2287 = phi_2872_;
                                                                                    if (_e2277 < _e2283) {
                                                                                        phi_2877_ = _e2277;
                                                                                    } else {
                                                                                        phi_2877_ = _e2283;
                                                                                    }
                                                                                    let _e2290 = phi_2877_;
                                                                                    if (_e2278 < _e2284) {
                                                                                        phi_2882_ = _e2278;
                                                                                    } else {
                                                                                        phi_2882_ = _e2284;
                                                                                    }
                                                                                    let _e2293 = phi_2882_;
                                                                                    if (_e2276 > _e2282) {
                                                                                        phi_2890_ = _e2276;
                                                                                    } else {
                                                                                        phi_2890_ = _e2282;
                                                                                    }
                                                                                    let _e2299 = phi_2890_;
                                                                                    if (_e2277 > _e2283) {
                                                                                        phi_2895_ = _e2277;
                                                                                    } else {
                                                                                        phi_2895_ = _e2283;
                                                                                    }
                                                                                    let _e2302 = phi_2895_;
                                                                                    if (_e2278 > _e2284) {
                                                                                        phi_2900_ = _e2278;
                                                                                    } else {
                                                                                        phi_2900_ = _e2284;
                                                                                    }
                                                                                    let _e2305 = phi_2900_;
                                                                                    let _e2309 = core_intrinsics_maximum_number_nsz_f32_((_e2287 - _e1272), (_e2290 - _e1273));
                                                                                    let _e2310 = core_intrinsics_maximum_number_nsz_f32_(_e2309, (_e2293 - _e1274));
                                                                                    let _e2311 = core_intrinsics_minimum_number_nsz_f32_((_e2299 + _e1272), (_e2302 + _e1273));
                                                                                    let _e2312 = core_intrinsics_minimum_number_nsz_f32_(_e2311, (_e2305 + _e1274));
                                                                                    if (_e2310 > _e993) {
                                                                                        phi_2912_ = _e2310;
                                                                                    } else {
                                                                                        phi_2912_ = _e993;
                                                                                    }
                                                                                    let _e2315 = phi_2912_;
                                                                                    if (_e2312 < _e995) {
                                                                                        phi_2917_ = _e2312;
                                                                                    } else {
                                                                                        phi_2917_ = _e995;
                                                                                    }
                                                                                    let _e2318 = phi_2917_;
                                                                                    if (_e2186 < _e2315) {
                                                                                        phi_2922_ = _e2315;
                                                                                    } else {
                                                                                        phi_2922_ = _e2186;
                                                                                    }
                                                                                    let _e2321 = phi_2922_;
                                                                                    if (_e2321 > _e2318) {
                                                                                        phi_2927_ = _e2318;
                                                                                    } else {
                                                                                        phi_2927_ = _e2321;
                                                                                    }
                                                                                    let _e2324 = phi_2927_;
                                                                                    phi_2932_ = lt_bvh_triangle_Intersection(_e2324, (_e2027 / _e2086), (_e2048 / _e2086), (_e2315 <= _e2318));
                                                                                    phi_2933_ = false;
                                                                                } else {
                                                                                    phi_2932_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2933_ = true;
                                                                                }
                                                                                let _e2330 = phi_2932_;
                                                                                let _e2332 = phi_2933_;
                                                                                phi_2934_ = _e2330;
                                                                                phi_2935_ = _e2332;
                                                                            } else {
                                                                                phi_2934_ = lt_bvh_triangle_Intersection();
                                                                                phi_2935_ = true;
                                                                            }
                                                                            let _e2334 = phi_2934_;
                                                                            let _e2336 = phi_2935_;
                                                                            if _e2336 {
                                                                            }
                                                                            phi_2939_ = _e2334;
                                                                            phi_2940_ = _e2336;
                                                                        }
                                                                        let _e2338 = phi_2939_;
                                                                        let _e2340 = phi_2940_;
                                                                        phi_2941_ = _e2338;
                                                                        phi_2942_ = _e2089;
                                                                        phi_2943_ = _e2340;
                                                                    } else {
                                                                        phi_2941_ = lt_bvh_triangle_Intersection();
                                                                        phi_2942_ = true;
                                                                        phi_2943_ = false;
                                                                    }
                                                                    let _e2342 = phi_2941_;
                                                                    let _e2344 = phi_2942_;
                                                                    let _e2346 = phi_2943_;
                                                                    if _e2344 {
                                                                        phi_2947_ = true;
                                                                    } else {
                                                                        phi_2947_ = _e2346;
                                                                    }
                                                                    let _e2348 = phi_2947_;
                                                                    if _e2348 {
                                                                        phi_2951_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2951_ = _e2342;
                                                                    }
                                                                    let _e2350 = phi_2951_;
                                                                    if _e2350.is_hit {
                                                                        if (_e2350.t > 0f) {
                                                                            if (_e2350.t < _e142) {
                                                                                let _e2357 = triangles.member[(0u + _e1902)].i0_;
                                                                                if ((_e2357 & 2147483648u) == 0u) {
                                                                                    phi_3170_ = true;
                                                                                } else {
                                                                                    if (_e1902 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2366 = triangles.member[(0u + _e1902)].i0_;
                                                                                    let _e2367 = (_e2366 & 2147483647u);
                                                                                    let _e2369 = triangles.member[(0u + _e1902)].i1_;
                                                                                    let _e2371 = triangles.member[(0u + _e1902)].i2_;
                                                                                    if (_e2367 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2375 = vertices.member[(0u + _e2367)];
                                                                                    if (_e2369 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2379 = vertices.member[(0u + _e2369)];
                                                                                    if (_e2371 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2383 = vertices.member[(0u + _e2371)];
                                                                                    let _e2384 = array<abi_Vertex, 3>(_e2375, _e2379, _e2383);
                                                                                    if (_e2384[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2390 = materials.member[(0u + _e2384[0].material)];
                                                                                    if ((_e2390.flags & 1u) == 1u) {
                                                                                        let _e2395 = ((1f - _e2350.u) - _e2350.v);
                                                                                        if (_e2390.cutoff <= 0f) {
                                                                                            phi_3168_ = true;
                                                                                        } else {
                                                                                            let _e2422 = (_e2390.base_color.w * ((((f32((_e2384[0].color >> bitcast<u32>(24i))) * _e2395) + (f32((_e2384[1].color >> bitcast<u32>(24i))) * _e2350.u)) + (f32((_e2384[2].color >> bitcast<u32>(24i))) * _e2350.v)) * (1f / 255f)));
                                                                                            if (_e2390.alpha_size == 0u) {
                                                                                                phi_3165_ = _e2422;
                                                                                            } else {
                                                                                                local.offset = _e2390.alpha_offset;
                                                                                                local.size = _e2390.alpha_size;
                                                                                                local.flags = _e2390.flags;
                                                                                                let _e2453 = _lt_shaders_texture_TextureView_quad((&local), (((_e2384[0].u * _e2395) + (_e2384[1].u * _e2350.u)) + (_e2384[2].u * _e2350.v)), (((_e2384[0].v * _e2395) + (_e2384[1].v * _e2350.u)) + (_e2384[2].v * _e2350.v)));
                                                                                                let _e2457 = (_e2453.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2457 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2461 = alpha_texels.member[(0u + _e2457)];
                                                                                                let _e2477 = (_e2453.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2477 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2481 = alpha_texels.member[(0u + _e2477)];
                                                                                                let _e2498 = (_e2453.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2498 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2502 = alpha_texels.member[(0u + _e2498)];
                                                                                                let _e2519 = (_e2453.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2519 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2523 = alpha_texels.member[(0u + _e2519)];
                                                                                                phi_3165_ = (_e2422 * (((((f32(((_e2461 >> bitcast<u32>((((_e2453.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.x) + ((f32(((_e2481 >> bitcast<u32>((((_e2453.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.y)) + ((f32(((_e2502 >> bitcast<u32>((((_e2453.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.z)) + ((f32(((_e2523 >> bitcast<u32>((((_e2453.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.w)));
                                                                                            }
                                                                                            let _e2539 = phi_3165_;
                                                                                            phi_3168_ = (_e2539 >= _e2390.cutoff);
                                                                                        }
                                                                                        let _e2543 = phi_3168_;
                                                                                        phi_3169_ = _e2543;
                                                                                    } else {
                                                                                        phi_3169_ = false;
                                                                                    }
                                                                                    let _e2545 = phi_3169_;
                                                                                    phi_3170_ = _e2545;
                                                                                }
                                                                                let _e2547 = phi_3170_;
                                                                                if _e2547 {
                                                                                    phi_3174_ = false;
                                                                                } else {
                                                                                    phi_3174_ = true;
                                                                                }
                                                                                let _e2549 = phi_3174_;
                                                                                phi_3175_ = _e2547;
                                                                                phi_3176_ = _e2547;
                                                                                phi_3177_ = _e2549;
                                                                            } else {
                                                                                phi_3175_ = bool();
                                                                                phi_3176_ = _e1893;
                                                                                phi_3177_ = true;
                                                                            }
                                                                            let _e2551 = phi_3175_;
                                                                            let _e2553 = phi_3176_;
                                                                            let _e2555 = phi_3177_;
                                                                            phi_3178_ = _e2551;
                                                                            phi_3179_ = _e2553;
                                                                            phi_3180_ = _e2555;
                                                                        } else {
                                                                            phi_3178_ = bool();
                                                                            phi_3179_ = _e1893;
                                                                            phi_3180_ = true;
                                                                        }
                                                                        let _e2557 = phi_3178_;
                                                                        let _e2559 = phi_3179_;
                                                                        let _e2561 = phi_3180_;
                                                                        phi_3181_ = _e2557;
                                                                        phi_3182_ = _e2559;
                                                                        phi_3183_ = _e2561;
                                                                    } else {
                                                                        phi_3181_ = bool();
                                                                        phi_3182_ = _e1893;
                                                                        phi_3183_ = true;
                                                                    }
                                                                    let _e2563 = phi_3181_;
                                                                    let _e2565 = phi_3182_;
                                                                    let _e2567 = phi_3183_;
                                                                    if _e2567 {
                                                                    }
                                                                    phi_2381_ = (_e1891 & (_e1891 - 1u));
                                                                    phi_2384_ = _e2565;
                                                                    phi_3187_ = _e2563;
                                                                    phi_3188_ = _e2567;
                                                                }
                                                                let _e2569 = phi_2381_;
                                                                let _e2571 = phi_2384_;
                                                                let _e2573 = phi_3187_;
                                                                let _e2575 = phi_3188_;
                                                                local_14 = _e2573;
                                                                continue;
                                                                continuing {
                                                                    phi_2380_ = _e2569;
                                                                    phi_2383_ = _e2571;
                                                                    break if !(_e2575);
                                                                }
                                                            }
                                                            let _e2578 = local_9;
                                                            if _e2578 {
                                                                let _e2580 = local_1.group_mask;
                                                                if ((_e2580 & 4278190080u) == 0u) {
                                                                    let _e2584 = local_1.len;
                                                                    if (_e2584 == 0u) {
                                                                        phi_3230_ = false;
                                                                    } else {
                                                                        let _e2588 = local_1.len;
                                                                        local_1.len = (_e2588 - 1u);
                                                                        let _e2591 = local_1.len;
                                                                        if (_e2591 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2596 = local_1.first[(0u + _e2591)];
                                                                        local_1.group = _e2596;
                                                                        let _e2599 = local_1.len;
                                                                        if (_e2599 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2604 = local_1.mask[(0u + _e2599)];
                                                                        local_1.group_mask = _e2604;
                                                                        phi_3230_ = true;
                                                                    }
                                                                    let _e2607 = phi_3230_;
                                                                    phi_3231_ = _e2607;
                                                                } else {
                                                                    phi_3231_ = true;
                                                                }
                                                                let _e2609 = phi_3231_;
                                                                if _e2609 {
                                                                    let _e2611 = local_1.group_mask;
                                                                    let _e2617 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2611)), 32u, (_e2611 == 0u)));
                                                                    let _e2621 = local_1.group_mask;
                                                                    let _e2635 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2635 & ~((1u << bitcast<u32>((_e2617 & 31u)))));
                                                                    let _e2638 = local_1.group;
                                                                    phi_3262_ = (_e2638 + countOneBits(((_e2621 & ~((4294967295u << bitcast<u32>((((_e2617 - 24u) ^ _e1315) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3262_ = 4294967295u;
                                                                }
                                                                let _e2641 = phi_3262_;
                                                                phi_3263_ = _e2641;
                                                            } else {
                                                                phi_3263_ = u32();
                                                            }
                                                            let _e2643 = phi_3263_;
                                                            phi_2049_ = _e2643;
                                                            let _e3029 = local_13;
                                                            phi_2052_ = _e3029;
                                                            let _e3032 = local_14;
                                                            phi_3264_ = _e3032;
                                                            let _e3035 = local_15;
                                                            phi_3265_ = _e3035;
                                                            phi_3266_ = false;
                                                        } else {
                                                            phi_2049_ = u32();
                                                            phi_2052_ = bool();
                                                            phi_3264_ = bool();
                                                            phi_3265_ = false;
                                                            phi_3266_ = true;
                                                        }
                                                        let _e2645 = phi_2049_;
                                                        let _e2647 = phi_2052_;
                                                        let _e2649 = phi_3264_;
                                                        let _e2651 = phi_3265_;
                                                        let _e2653 = phi_3266_;
                                                        local_10 = _e2653;
                                                        local_16 = _e2649;
                                                        continue;
                                                        continuing {
                                                            phi_2048_ = _e2645;
                                                            phi_2051_ = _e2647;
                                                            break if !(_e2651);
                                                        }
                                                    }
                                                    let _e2656 = local_10;
                                                    if _e2656 {
                                                        phi_3270_ = false;
                                                    } else {
                                                        phi_3270_ = true;
                                                    }
                                                    let _e2658 = phi_3270_;
                                                    if _e2658 {
                                                        let _e3041 = local_16;
                                                        phi_3274_ = _e3041;
                                                    } else {
                                                        let _e3043 = local_17;
                                                        phi_3274_ = _e3043;
                                                    }
                                                    let _e2660 = phi_3274_;
                                                    phi_3275_ = _e2660;
                                                }
                                                let _e2662 = phi_3275_;
                                                phi_3276_ = _e2662;
                                                phi_3277_ = _e1137;
                                            } else {
                                                phi_3276_ = bool();
                                                phi_3277_ = true;
                                            }
                                            let _e2664 = phi_3276_;
                                            let _e2666 = phi_3277_;
                                            if _e2666 {
                                                phi_3281_ = _e932;
                                            } else {
                                                phi_3281_ = _e2664;
                                            }
                                            let _e2668 = phi_3281_;
                                            if _e2668 {
                                                phi_3285_ = false;
                                            } else {
                                                phi_3285_ = true;
                                            }
                                            let _e2670 = phi_3285_;
                                            phi_3286_ = _e2668;
                                            phi_3287_ = _e2670;
                                        } else {
                                            phi_3286_ = _e932;
                                            phi_3287_ = true;
                                        }
                                        let _e2672 = phi_3286_;
                                        let _e2674 = phi_3287_;
                                        phi_3288_ = _e2672;
                                        phi_3289_ = _e2674;
                                    } else {
                                        phi_3288_ = _e932;
                                        phi_3289_ = true;
                                    }
                                    let _e2676 = phi_3288_;
                                    let _e2678 = phi_3289_;
                                    phi_3290_ = _e2676;
                                    phi_3291_ = _e2678;
                                } else {
                                    phi_3290_ = _e932;
                                    phi_3291_ = true;
                                }
                                let _e2680 = phi_3290_;
                                let _e2682 = phi_3291_;
                                if _e2682 {
                                }
                                phi_1434_ = (_e930 & (_e930 - 1u));
                                phi_1437_ = _e2680;
                                phi_3295_ = _e2682;
                            }
                            let _e2684 = phi_1434_;
                            let _e2686 = phi_1437_;
                            let _e2688 = phi_3295_;
                            continue;
                            continuing {
                                phi_1433_ = _e2684;
                                phi_1436_ = _e2686;
                                break if !(_e2688);
                            }
                        }
                        let _e2691 = local_11;
                        if _e2691 {
                            let _e2693 = local_2.group_mask;
                            if ((_e2693 & 4278190080u) == 0u) {
                                let _e2697 = local_2.len;
                                if (_e2697 == 0u) {
                                    phi_3337_ = false;
                                } else {
                                    let _e2701 = local_2.len;
                                    local_2.len = (_e2701 - 1u);
                                    let _e2704 = local_2.len;
                                    if (_e2704 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2709 = local_2.first[(0u + _e2704)];
                                    local_2.group = _e2709;
                                    let _e2712 = local_2.len;
                                    if (_e2712 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2717 = local_2.mask[(0u + _e2712)];
                                    local_2.group_mask = _e2717;
                                    phi_3337_ = true;
                                }
                                let _e2720 = phi_3337_;
                                phi_3338_ = _e2720;
                            } else {
                                phi_3338_ = true;
                            }
                            let _e2722 = phi_3338_;
                            if _e2722 {
                                let _e2724 = local_2.group_mask;
                                let _e2730 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2724)), 32u, (_e2724 == 0u)));
                                let _e2734 = local_2.group_mask;
                                let _e2748 = local_2.group_mask;
                                local_2.group_mask = (_e2748 & ~((1u << bitcast<u32>((_e2730 & 31u)))));
                                let _e2751 = local_2.group;
                                phi_3369_ = (_e2751 + countOneBits(((_e2734 & ~((4294967295u << bitcast<u32>((((_e2730 - 24u) ^ _e354) & 31u))))) & 255u)));
                            } else {
                                phi_3369_ = 4294967295u;
                            }
                            let _e2754 = phi_3369_;
                            phi_3370_ = _e2754;
                        } else {
                            phi_3370_ = u32();
                        }
                        let _e2756 = phi_3370_;
                        phi_1102_ = _e2756;
                        let _e3066 = local_18;
                        phi_1105_ = _e3066;
                        let _e3069 = local_19;
                        phi_3371_ = _e3069;
                        phi_3372_ = false;
                    } else {
                        phi_1102_ = u32();
                        phi_1105_ = bool();
                        phi_3371_ = false;
                        phi_3372_ = true;
                    }
                    let _e2758 = phi_1102_;
                    let _e2760 = phi_1105_;
                    let _e2762 = phi_3371_;
                    let _e2764 = phi_3372_;
                    local_12 = _e2764;
                    continue;
                    continuing {
                        phi_1101_ = _e2758;
                        phi_1104_ = _e2760;
                        break if !(_e2762);
                    }
                }
                let _e2767 = local_12;
                if _e2767 {
                    phi_3376_ = false;
                } else {
                    phi_3376_ = true;
                }
                let _e2769 = phi_3376_;
                if _e2769 {
                }
                phi_3380_ = _e2769;
            }
            let _e2771 = phi_3380_;
            phi_3381_ = _e206;
            phi_3382_ = _e2771;
        } else {
            phi_3381_ = true;
            phi_3382_ = false;
        }
        let _e2773 = phi_3381_;
        let _e2775 = phi_3382_;
        if _e2773 {
            phi_3386_ = false;
            phi_3387_ = true;
        } else {
            phi_3386_ = true;
            phi_3387_ = _e2775;
        }
        let _e2777 = phi_3386_;
        let _e2779 = phi_3387_;
        if _e2779 {
            phi_3391_ = _e2777;
        } else {
            phi_3391_ = false;
        }
        let _e2781 = phi_3391_;
        if _e2781 {
            phi_3395_ = 0f;
        } else {
            phi_3395_ = 1f;
        }
        let _e2783 = phi_3395_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2783;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
