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

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_39 {
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

struct type_43 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_47 {
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

struct type_51 {
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

struct type_62 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_20;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> nodes: type_39;
@group(0) @binding(3) 
var<storage> triangles: type_43;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;
@group(0) @binding(7) 
var<storage> instances: type_62;
@group(0) @binding(8) 
var<storage> vertices: type_47;
@group(0) @binding(9) 
var<storage> materials: type_51;
@group(0) @binding(10) 
var<storage> alpha_texels: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_216_: bool;
    var phi_220_: f32;

    if (param != param) {
        phi_216_ = true;
    } else {
        let _e71 = (param_1 >= param);
        if _e71 {
        }
        phi_216_ = _e71;
    }
    let _e73 = phi_216_;
    if _e73 {
        phi_220_ = param_1;
    } else {
        phi_220_ = param;
    }
    let _e75 = phi_220_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_232_: bool;
    var phi_236_: f32;

    if (param_2 != param_2) {
        phi_232_ = true;
    } else {
        let _e71 = (param_3 <= param_2);
        if _e71 {
        }
        phi_232_ = _e71;
    }
    let _e73 = phi_232_;
    if _e73 {
        phi_236_ = param_3;
    } else {
        phi_236_ = param_2;
    }
    let _e75 = phi_236_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_278_: f32;
    var phi_283_: f32;
    var phi_284_: bool;
    var phi_285_: f32;
    var phi_286_: bool;
    var phi_290_: f32;
    var phi_316_: f32;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_323_: f32;
    var phi_324_: bool;
    var phi_328_: f32;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_366_: u32;
    var phi_380_: u32;
    var phi_387_: u32;
    var phi_392_: u32;
    var phi_398_: u32;
    var phi_403_: u32;
    var phi_405_: texture_Axis;
    var phi_433_: f32;
    var phi_438_: f32;
    var phi_439_: bool;
    var phi_440_: f32;
    var phi_441_: bool;
    var phi_445_: f32;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_483_: f32;
    var phi_491_: f32;
    var phi_492_: f32;
    var phi_493_: f32;
    var phi_502_: f32;
    var phi_503_: f32;
    var phi_521_: u32;
    var phi_535_: u32;
    var phi_542_: u32;
    var phi_547_: u32;
    var phi_553_: u32;
    var phi_558_: u32;
    var phi_560_: texture_Axis;

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
                phi_278_ = 1f;
            } else {
                phi_278_ = 0f;
            }
            let _e102 = phi_278_;
            if (param_5 < 8388608f) {
                phi_283_ = (_e99 - _e102);
                phi_284_ = false;
            } else {
                phi_283_ = f32();
                phi_284_ = true;
            }
            let _e105 = phi_283_;
            let _e107 = phi_284_;
            phi_285_ = _e105;
            phi_286_ = _e107;
        } else {
            phi_285_ = f32();
            phi_286_ = true;
        }
        let _e109 = phi_285_;
        let _e111 = phi_286_;
        if _e111 {
            phi_290_ = param_5;
        } else {
            phi_290_ = _e109;
        }
        let _e113 = phi_290_;
        phi_338_ = (param_5 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_5 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_316_ = 1f;
                } else {
                    phi_316_ = 0f;
                }
                let _e131 = phi_316_;
                if (_e116 < 8388608f) {
                    phi_321_ = (_e128 - _e131);
                    phi_322_ = false;
                } else {
                    phi_321_ = f32();
                    phi_322_ = true;
                }
                let _e134 = phi_321_;
                let _e136 = phi_322_;
                phi_323_ = _e134;
                phi_324_ = _e136;
            } else {
                phi_323_ = f32();
                phi_324_ = true;
            }
            let _e138 = phi_323_;
            let _e140 = phi_324_;
            if _e140 {
                phi_328_ = _e116;
            } else {
                phi_328_ = _e138;
            }
            let _e142 = phi_328_;
            let _e144 = (param_5 - (2f * _e142));
            if (_e144 > 1f) {
                phi_336_ = (2f - _e144);
            } else {
                phi_336_ = _e144;
            }
            let _e148 = phi_336_;
            phi_337_ = _e148;
        } else {
            phi_337_ = param_5;
        }
        let _e150 = phi_337_;
        phi_338_ = _e150;
    }
    let _e152 = phi_338_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_347_ = _e152;
        } else {
            phi_347_ = 1f;
        }
        let _e156 = phi_347_;
        phi_348_ = _e156;
    } else {
        phi_348_ = 0f;
    }
    let _e158 = phi_348_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_366_ = _e159;
        } else {
            phi_366_ = _e168;
        }
        let _e171 = phi_366_;
        phi_405_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_380_ = _e73;
        } else {
            phi_380_ = _e180;
        }
        let _e183 = phi_380_;
        if (_e86 == 0u) {
            phi_387_ = _e159;
        } else {
            phi_387_ = 0u;
        }
        let _e188 = phi_387_;
        if (_e86 == 0u) {
            phi_392_ = 0u;
        } else {
            phi_392_ = _e159;
        }
        let _e191 = phi_392_;
        if (_e183 == 0u) {
            phi_398_ = _e188;
        } else {
            phi_398_ = (_e183 - 1u);
        }
        let _e195 = phi_398_;
        if (_e183 > _e159) {
            phi_403_ = _e191;
        } else {
            phi_403_ = _e183;
        }
        let _e198 = phi_403_;
        phi_405_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_405_;
    let _e203 = (*param_4).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_6 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e219 > param_6) {
                phi_433_ = 1f;
            } else {
                phi_433_ = 0f;
            }
            let _e222 = phi_433_;
            if (param_6 < 8388608f) {
                phi_438_ = (_e219 - _e222);
                phi_439_ = false;
            } else {
                phi_438_ = f32();
                phi_439_ = true;
            }
            let _e225 = phi_438_;
            let _e227 = phi_439_;
            phi_440_ = _e225;
            phi_441_ = _e227;
        } else {
            phi_440_ = f32();
            phi_441_ = true;
        }
        let _e229 = phi_440_;
        let _e231 = phi_441_;
        if _e231 {
            phi_445_ = param_6;
        } else {
            phi_445_ = _e229;
        }
        let _e233 = phi_445_;
        phi_493_ = (param_6 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_6 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_471_ = 1f;
                } else {
                    phi_471_ = 0f;
                }
                let _e251 = phi_471_;
                if (_e236 < 8388608f) {
                    phi_476_ = (_e248 - _e251);
                    phi_477_ = false;
                } else {
                    phi_476_ = f32();
                    phi_477_ = true;
                }
                let _e254 = phi_476_;
                let _e256 = phi_477_;
                phi_478_ = _e254;
                phi_479_ = _e256;
            } else {
                phi_478_ = f32();
                phi_479_ = true;
            }
            let _e258 = phi_478_;
            let _e260 = phi_479_;
            if _e260 {
                phi_483_ = _e236;
            } else {
                phi_483_ = _e258;
            }
            let _e262 = phi_483_;
            let _e264 = (param_6 - (2f * _e262));
            if (_e264 > 1f) {
                phi_491_ = (2f - _e264);
            } else {
                phi_491_ = _e264;
            }
            let _e268 = phi_491_;
            phi_492_ = _e268;
        } else {
            phi_492_ = param_6;
        }
        let _e270 = phi_492_;
        phi_493_ = _e270;
    }
    let _e272 = phi_493_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_502_ = _e272;
        } else {
            phi_502_ = 1f;
        }
        let _e276 = phi_502_;
        phi_503_ = _e276;
    } else {
        phi_503_ = 0f;
    }
    let _e278 = phi_503_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_521_ = _e279;
        } else {
            phi_521_ = _e288;
        }
        let _e291 = phi_521_;
        phi_560_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_535_ = _e77;
        } else {
            phi_535_ = _e300;
        }
        let _e303 = phi_535_;
        if (_e206 == 0u) {
            phi_542_ = _e279;
        } else {
            phi_542_ = 0u;
        }
        let _e308 = phi_542_;
        if (_e206 == 0u) {
            phi_547_ = 0u;
        } else {
            phi_547_ = _e279;
        }
        let _e311 = phi_547_;
        if (_e303 == 0u) {
            phi_553_ = _e308;
        } else {
            phi_553_ = (_e303 - 1u);
        }
        let _e315 = phi_553_;
        if (_e303 > _e279) {
            phi_558_ = _e311;
        } else {
            phi_558_ = _e303;
        }
        let _e318 = phi_558_;
        phi_560_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_560_;
    let _e325 = (*param_4).offset;
    let _e332 = (*param_4).offset;
    let _e339 = (*param_4).offset;
    let _e346 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_708_: f32;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_747_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_767_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_794_: bool;
    var phi_864_: f32;
    var phi_871_: f32;
    var phi_878_: f32;
    var phi_885_: f32;
    var phi_892_: f32;
    var phi_899_: f32;
    var phi_916_: f32;
    var phi_921_: f32;
    var phi_926_: f32;
    var phi_931_: f32;
    var phi_936_: f32;
    var phi_955_: u32;
    var phi_960_: u32;
    var phi_965_: u32;
    var phi_1079_: bool;
    var phi_1080_: bool;
    var phi_1111_: u32;
    var phi_1113_: u32;
    var phi_1116_: bool;
    var phi_1196_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1223_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1250_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1256_: u32;
    var phi_1259_: u32;
    var phi_1273_: u32;
    var phi_1283_: u32;
    var phi_1293_: u32;
    var phi_1311_: u32;
    var phi_1321_: u32;
    var phi_1331_: u32;
    var phi_1367_: u32;
    var phi_1380_: u32;
    var phi_1385_: u32;
    var phi_1386_: u32;
    var phi_1387_: u32;
    var phi_1257_: u32;
    var phi_1260_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1445_: u32;
    var phi_1448_: bool;
    var phi_1497_: f32;
    var phi_1502_: f32;
    var phi_1507_: f32;
    var phi_1515_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1647_: bool;
    var phi_1648_: bool;
    var phi_1652_: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1672_: bool;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1695_: bool;
    var phi_1699_: bool;
    var phi_1769_: f32;
    var phi_1776_: f32;
    var phi_1783_: f32;
    var phi_1790_: f32;
    var phi_1797_: f32;
    var phi_1804_: f32;
    var phi_1821_: f32;
    var phi_1826_: f32;
    var phi_1831_: f32;
    var phi_1836_: f32;
    var phi_1841_: f32;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1876_: u32;
    var phi_1877_: u32;
    var phi_1888_: vec3<f32>;
    var phi_1889_: vec3<f32>;
    var phi_1902_: u32;
    var phi_1907_: u32;
    var phi_1912_: u32;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2058_: u32;
    var phi_2060_: u32;
    var phi_2063_: bool;
    var phi_2143_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2170_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2197_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2203_: u32;
    var phi_2206_: u32;
    var phi_2220_: u32;
    var phi_2230_: u32;
    var phi_2240_: u32;
    var phi_2258_: u32;
    var phi_2268_: u32;
    var phi_2278_: u32;
    var phi_2314_: u32;
    var phi_2327_: u32;
    var phi_2332_: u32;
    var phi_2333_: u32;
    var phi_2334_: u32;
    var phi_2204_: u32;
    var phi_2207_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2392_: u32;
    var phi_2395_: bool;
    var phi_2439_: vec3<f32>;
    var phi_2440_: vec3<f32>;
    var phi_2469_: vec3<f32>;
    var phi_2470_: vec3<f32>;
    var phi_2499_: vec3<f32>;
    var phi_2500_: vec3<f32>;
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
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2575_: f32;
    var phi_2576_: f32;
    var phi_2577_: f32;
    var phi_2578_: f32;
    var phi_2586_: f32;
    var phi_2601_: f32;
    var phi_2602_: bool;
    var phi_2603_: f32;
    var phi_2604_: bool;
    var phi_2605_: f32;
    var phi_2606_: bool;
    var phi_2624_: f32;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var phi_2627_: f32;
    var phi_2628_: bool;
    var phi_2629_: bool;
    var phi_2633_: bool;
    var phi_2634_: f32;
    var phi_2635_: bool;
    var phi_2663_: vec3<f32>;
    var phi_2664_: vec3<f32>;
    var phi_2689_: vec3<f32>;
    var phi_2690_: vec3<f32>;
    var phi_2715_: vec3<f32>;
    var phi_2716_: vec3<f32>;
    var phi_2772_: f32;
    var phi_2781_: f32;
    var phi_2790_: f32;
    var phi_2799_: f32;
    var phi_2806_: f32;
    var phi_2813_: f32;
    var phi_2826_: f32;
    var phi_2835_: f32;
    var phi_2844_: f32;
    var phi_2853_: f32;
    var phi_2860_: f32;
    var phi_2867_: f32;
    var phi_2884_: f32;
    var phi_2889_: f32;
    var phi_2894_: f32;
    var phi_2902_: f32;
    var phi_2907_: f32;
    var phi_2912_: f32;
    var phi_2924_: f32;
    var phi_2929_: f32;
    var phi_2934_: f32;
    var phi_2939_: f32;
    var phi_2944_: lt_bvh_triangle_Intersection;
    var phi_2945_: bool;
    var phi_2946_: lt_bvh_triangle_Intersection;
    var phi_2947_: bool;
    var phi_2951_: lt_bvh_triangle_Intersection;
    var phi_2952_: bool;
    var phi_2953_: lt_bvh_triangle_Intersection;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var phi_2959_: bool;
    var phi_2963_: lt_bvh_triangle_Intersection;
    var phi_3177_: f32;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3186_: bool;
    var phi_3187_: bool;
    var phi_3188_: bool;
    var phi_3189_: bool;
    var phi_3190_: bool;
    var phi_3191_: bool;
    var phi_3192_: bool;
    var phi_3193_: bool;
    var phi_3194_: bool;
    var phi_3195_: bool;
    var phi_2393_: u32;
    var phi_2396_: bool;
    var phi_3199_: bool;
    var phi_3200_: bool;
    var local_9: bool;
    var phi_3242_: bool;
    var phi_3243_: bool;
    var phi_3274_: u32;
    var phi_3275_: u32;
    var phi_2061_: u32;
    var phi_2064_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var local_10: bool;
    var phi_3282_: bool;
    var phi_3286_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3293_: bool;
    var phi_3297_: bool;
    var phi_3298_: bool;
    var phi_3299_: bool;
    var phi_3300_: bool;
    var phi_3301_: bool;
    var phi_3302_: bool;
    var phi_3303_: bool;
    var phi_1446_: u32;
    var phi_1449_: bool;
    var phi_3307_: bool;
    var local_11: bool;
    var phi_3349_: bool;
    var phi_3350_: bool;
    var phi_3381_: u32;
    var phi_3382_: u32;
    var phi_1114_: u32;
    var phi_1117_: bool;
    var phi_3383_: bool;
    var phi_3384_: bool;
    var local_12: bool;
    var phi_3388_: bool;
    var phi_3392_: bool;
    var phi_3393_: bool;
    var phi_3394_: bool;
    var phi_3398_: bool;
    var phi_3399_: bool;
    var phi_3403_: bool;
    var phi_3407_: f32;
    var phi_3448_: u32;
    var phi_3467_: u32;
    var phi_3475_: u32;
    var phi_3483_: u32;
    var phi_3488_: u32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

    let _e71 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&visibility.member));
    let _e87 = arrayLength((&list.member));
    let _e90 = arrayLength((&bits.member));
    let _e96 = arrayLength((&vertices.member));
    let _e102 = arrayLength((&alpha_texels.member));
    let _e106 = ((_e71.y * 2097152u) + _e71.x);
    if (3u < _e87) {
    } else {
        return;
    }
    let _e109 = list.member[3u];
    if (_e106 < _e109) {
        let _e111 = (_e106 + 4u);
        if (_e111 < _e87) {
        } else {
            return;
        }
        let _e115 = list.member[(0u + _e111)];
        let _e117 = p.member.root;
        if (_e115 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e123 = samples.member[(0u + _e115)].position;
        let _e125 = samples.member[(0u + _e115)].normal;
        let _e127 = samples.member[(0u + _e115)].magnitude;
        let _e129 = ((8f / 8388608f) * _e127);
        let _e137 = (_e123.x + (_e125.x * _e129));
        let _e139 = (_e123.y + (_e125.y * _e129));
        let _e141 = (_e123.z + (_e125.z * _e129));
        let _e143 = p.member.light.place;
        if (_e143.w == 0f) {
            phi_708_ = 300000000000000000000000000000000000000f;
        } else {
            phi_708_ = 1f;
        }
        let _e147 = phi_708_;
        let _e155 = (_e143.x - (_e137 * _e143.w));
        let _e156 = (_e143.y - (_e139 * _e143.w));
        let _e157 = (_e143.z - (_e141 * _e143.w));
        let _e158 = abs(_e155);
        let _e159 = abs(_e156);
        let _e160 = abs(_e157);
        if (abs(_e137) < 1000000000000000f) {
            if (abs(_e139) < 1000000000000000f) {
                phi_740_ = (abs(_e141) < 1000000000000000f);
                phi_741_ = false;
            } else {
                phi_740_ = bool();
                phi_741_ = true;
            }
            let _e168 = phi_740_;
            let _e170 = phi_741_;
            phi_742_ = _e168;
            phi_743_ = _e170;
        } else {
            phi_742_ = bool();
            phi_743_ = true;
        }
        let _e172 = phi_742_;
        let _e174 = phi_743_;
        if _e174 {
            phi_747_ = false;
        } else {
            phi_747_ = _e172;
        }
        let _e176 = phi_747_;
        if _e176 {
            if (_e158 < 1000000000000000f) {
                if (_e159 < 1000000000000000f) {
                    phi_760_ = (_e160 < 1000000000000000f);
                    phi_761_ = false;
                } else {
                    phi_760_ = bool();
                    phi_761_ = true;
                }
                let _e181 = phi_760_;
                let _e183 = phi_761_;
                phi_762_ = _e181;
                phi_763_ = _e183;
            } else {
                phi_762_ = bool();
                phi_763_ = true;
            }
            let _e185 = phi_762_;
            let _e187 = phi_763_;
            if _e187 {
                phi_767_ = false;
            } else {
                phi_767_ = _e185;
            }
            let _e189 = phi_767_;
            if _e189 {
                if (_e158 > 0f) {
                    phi_781_ = bool();
                    phi_782_ = true;
                } else {
                    let _e191 = (_e159 > 0f);
                    if _e191 {
                        phi_780_ = bool();
                    } else {
                        phi_780_ = (_e160 > 0f);
                    }
                    let _e194 = phi_780_;
                    phi_781_ = _e194;
                    phi_782_ = _e191;
                }
                let _e196 = phi_781_;
                let _e198 = phi_782_;
                if _e198 {
                    phi_786_ = true;
                } else {
                    phi_786_ = _e196;
                }
                let _e200 = phi_786_;
                phi_787_ = _e200;
                phi_788_ = false;
            } else {
                phi_787_ = bool();
                phi_788_ = true;
            }
            let _e202 = phi_787_;
            let _e204 = phi_788_;
            phi_789_ = _e202;
            phi_790_ = _e204;
        } else {
            phi_789_ = bool();
            phi_790_ = true;
        }
        let _e206 = phi_789_;
        let _e208 = phi_790_;
        if _e208 {
            phi_794_ = false;
        } else {
            phi_794_ = _e206;
        }
        let _e210 = phi_794_;
        if _e210 {
            let _e211 = (_e117 >= _e78);
            if _e211 {
                phi_3392_ = false;
            } else {
                if (_e117 < _e78) {
                } else {
                    return;
                }
                let _e217 = nodes.member[(0u + _e117)].frame[0u];
                let _e221 = nodes.member[(0u + _e117)].frame[1u];
                let _e225 = nodes.member[(0u + _e117)].frame[2u];
                let _e229 = nodes.member[(0u + _e117)].frame[0u];
                let _e233 = nodes.member[(0u + _e117)].frame[1u];
                let _e237 = nodes.member[(0u + _e117)].frame[2u];
                let _e241 = nodes.member[(0u + _e117)].frame[3u];
                let _e275 = core_intrinsics_maximum_number_nsz_f32_(abs(_e155), abs(_e156));
                let _e276 = core_intrinsics_maximum_number_nsz_f32_(_e275, abs(_e157));
                let _e277 = (_e276 * 0.0000000000009094947f);
                if (abs(_e155) < _e277) {
                    phi_864_ = _e277;
                } else {
                    phi_864_ = abs(_e155);
                }
                let _e282 = phi_864_;
                if (_e155 < 0f) {
                    phi_871_ = (-1f / _e282);
                } else {
                    phi_871_ = (1f / _e282);
                }
                let _e287 = phi_871_;
                if (abs(_e156) < _e277) {
                    phi_878_ = _e277;
                } else {
                    phi_878_ = abs(_e156);
                }
                let _e292 = phi_878_;
                if (_e156 < 0f) {
                    phi_885_ = (-1f / _e292);
                } else {
                    phi_885_ = (1f / _e292);
                }
                let _e297 = phi_885_;
                if (abs(_e157) < _e277) {
                    phi_892_ = _e277;
                } else {
                    phi_892_ = abs(_e157);
                }
                let _e302 = phi_892_;
                if (_e157 < 0f) {
                    phi_899_ = (-1f / _e302);
                } else {
                    phi_899_ = (1f / _e302);
                }
                let _e307 = phi_899_;
                let _e311 = abs((bitcast<f32>(_e217) - _e137));
                let _e312 = abs((bitcast<f32>(_e221) - _e139));
                let _e313 = abs((bitcast<f32>(_e225) - _e141));
                let _e317 = abs(((bitcast<f32>(_e229) + (bitcast<f32>((((_e241 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                let _e318 = abs(((bitcast<f32>(_e233) + (bitcast<f32>((((_e241 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e139));
                let _e319 = abs(((bitcast<f32>(_e237) + (bitcast<f32>((((_e241 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e141));
                if (_e311 > _e317) {
                    phi_916_ = _e311;
                } else {
                    phi_916_ = _e317;
                }
                let _e322 = phi_916_;
                if (_e312 > _e318) {
                    phi_921_ = _e312;
                } else {
                    phi_921_ = _e318;
                }
                let _e325 = phi_921_;
                if (_e313 > _e319) {
                    phi_926_ = _e313;
                } else {
                    phi_926_ = _e319;
                }
                let _e328 = phi_926_;
                if (_e322 > _e325) {
                    phi_931_ = _e322;
                } else {
                    phi_931_ = _e325;
                }
                let _e331 = phi_931_;
                if (_e331 > _e328) {
                    phi_936_ = _e331;
                } else {
                    phi_936_ = _e328;
                }
                let _e334 = phi_936_;
                let _e338 = (_e334 * 0.0000019073486f);
                let _e339 = (abs(_e287) * _e338);
                let _e340 = (abs(_e297) * _e338);
                let _e341 = (abs(_e307) * _e338);
                let _e345 = (_e334 * 0.0000009536743f);
                let _e346 = (abs(_e287) * _e345);
                let _e347 = (abs(_e297) * _e345);
                let _e348 = (abs(_e307) * _e345);
                if (_e287 < 0f) {
                    phi_955_ = 0u;
                } else {
                    phi_955_ = 1u;
                }
                let _e351 = phi_955_;
                if (_e297 < 0f) {
                    phi_960_ = 0u;
                } else {
                    phi_960_ = 2u;
                }
                let _e354 = phi_960_;
                if (_e307 < 0f) {
                    phi_965_ = 0u;
                } else {
                    phi_965_ = 4u;
                }
                let _e357 = phi_965_;
                let _e359 = ((_e351 | _e354) | _e357);
                let _e360 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e117, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e360.first[0], _e360.first[1], _e360.first[2], _e360.first[3], _e360.first[4], _e360.first[5], _e360.first[6], _e360.first[7], _e360.first[8], _e360.first[9], _e360.first[10], _e360.first[11], _e360.first[12], _e360.first[13], _e360.first[14], _e360.first[15], _e360.first[16], _e360.first[17], _e360.first[18], _e360.first[19], _e360.first[20], _e360.first[21], _e360.first[22], _e360.first[23], _e360.first[24], _e360.first[25], _e360.first[26], _e360.first[27], _e360.first[28], _e360.first[29], _e360.first[30], _e360.first[31]), array<u32, 32>(_e360.mask[0], _e360.mask[1], _e360.mask[2], _e360.mask[3], _e360.mask[4], _e360.mask[5], _e360.mask[6], _e360.mask[7], _e360.mask[8], _e360.mask[9], _e360.mask[10], _e360.mask[11], _e360.mask[12], _e360.mask[13], _e360.mask[14], _e360.mask[15], _e360.mask[16], _e360.mask[17], _e360.mask[18], _e360.mask[19], _e360.mask[20], _e360.mask[21], _e360.mask[22], _e360.mask[23], _e360.mask[24], _e360.mask[25], _e360.mask[26], _e360.mask[27], _e360.mask[28], _e360.mask[29], _e360.mask[30], _e360.mask[31]), _e360.len, _e360.group, _e360.group_mask);
                let _e434 = local_2.group_mask;
                if ((_e434 & 4278190080u) == 0u) {
                    let _e438 = local_2.len;
                    if (_e438 == 0u) {
                        phi_1079_ = false;
                    } else {
                        let _e442 = local_2.len;
                        local_2.len = (_e442 - 1u);
                        let _e445 = local_2.len;
                        if (_e445 < 32u) {
                        } else {
                            return;
                        }
                        let _e450 = local_2.first[(0u + _e445)];
                        local_2.group = _e450;
                        let _e453 = local_2.len;
                        if (_e453 < 32u) {
                        } else {
                            return;
                        }
                        let _e458 = local_2.mask[(0u + _e453)];
                        local_2.group_mask = _e458;
                        phi_1079_ = true;
                    }
                    let _e461 = phi_1079_;
                    phi_1080_ = _e461;
                } else {
                    phi_1080_ = true;
                }
                let _e463 = phi_1080_;
                if _e463 {
                    let _e465 = local_2.group_mask;
                    let _e471 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e465)), 32u, (_e465 == 0u)));
                    let _e475 = local_2.group_mask;
                    let _e489 = local_2.group_mask;
                    local_2.group_mask = (_e489 & ~((1u << bitcast<u32>((_e471 & 31u)))));
                    let _e492 = local_2.group;
                    phi_1111_ = (_e492 + countOneBits(((_e475 & ~((4294967295u << bitcast<u32>((((_e471 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1111_ = 4294967295u;
                }
                let _e495 = phi_1111_;
                phi_1113_ = _e495;
                phi_1116_ = false;
                loop {
                    let _e497 = phi_1113_;
                    let _e499 = phi_1116_;
                    if (_e497 != 4294967295u) {
                        if (_e497 < _e78) {
                        } else {
                            return;
                        }
                        let _e506 = nodes.member[(0u + _e497)].frame[3u];
                        let _e531 = (bitcast<f32>((((_e506 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e287);
                        let _e532 = (bitcast<f32>((((_e506 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e297);
                        let _e533 = (bitcast<f32>((((_e506 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e307);
                        let _e536 = nodes.member[(0u + _e497)].frame[0u];
                        let _e540 = nodes.member[(0u + _e497)].frame[1u];
                        let _e544 = nodes.member[(0u + _e497)].frame[2u];
                        let _e549 = ((bitcast<f32>(_e536) - _e137) * _e287);
                        let _e550 = ((bitcast<f32>(_e540) - _e139) * _e297);
                        let _e551 = ((bitcast<f32>(_e544) - _e141) * _e307);
                        let _e559 = nodes.member[(0u + _e497)].x;
                        if (_e287 < 0f) {
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e570.unnamed.root, _e559.w), _e570.unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e559.x, _e576.unnamed_1.first_primitive));
                            phi_1196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e582.unnamed_1.root, _e559.y));
                        } else {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e559.y), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e559.z, _e604.unnamed_1.first_primitive));
                            phi_1196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e559.w));
                        }
                        let _e618 = phi_1196_;
                        let _e628 = nodes.member[(0u + _e497)].y;
                        if (_e297 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e628.x, _e645.unnamed_1.first_primitive));
                            phi_1223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e628.z, _e673.unnamed_1.first_primitive));
                            phi_1223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e628.w));
                        }
                        let _e687 = phi_1223_;
                        let _e697 = nodes.member[(0u + _e497)].z;
                        if (_e307 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e697.x, _e714.unnamed_1.first_primitive));
                            phi_1250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e697.z, _e742.unnamed_1.first_primitive));
                            phi_1250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e697.w));
                        }
                        let _e756 = phi_1250_;
                        phi_1256_ = 0u;
                        phi_1259_ = 0u;
                        loop {
                            let _e766 = phi_1256_;
                            let _e768 = phi_1259_;
                            local_3 = _e768;
                            local_4 = _e768;
                            local_5 = _e768;
                            let _e769 = (_e766 < 8u);
                            if _e769 {
                                let _e771 = (_e766 >> bitcast<u32>(2i));
                                let _e772 = (_e766 & 3u);
                                if (_e771 == 0u) {
                                    phi_1273_ = _e618.unnamed.root;
                                } else {
                                    phi_1273_ = _e618.unnamed.first_primitive;
                                }
                                let _e775 = phi_1273_;
                                if (_e771 == 0u) {
                                    phi_1283_ = _e687.unnamed.root;
                                } else {
                                    phi_1283_ = _e687.unnamed.first_primitive;
                                }
                                let _e784 = phi_1283_;
                                if (_e771 == 0u) {
                                    phi_1293_ = _e756.unnamed.root;
                                } else {
                                    phi_1293_ = _e756.unnamed.first_primitive;
                                }
                                let _e793 = phi_1293_;
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e775 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e339)), ((f32(((_e784 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e340)));
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(_e806, ((f32(((_e793 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e341)));
                                if (_e771 == 0u) {
                                    phi_1311_ = _e618.unnamed_1.root;
                                } else {
                                    phi_1311_ = _e618.unnamed_1.first_primitive;
                                }
                                let _e810 = phi_1311_;
                                if (_e771 == 0u) {
                                    phi_1321_ = _e687.unnamed_1.root;
                                } else {
                                    phi_1321_ = _e687.unnamed_1.first_primitive;
                                }
                                let _e819 = phi_1321_;
                                if (_e771 == 0u) {
                                    phi_1331_ = _e756.unnamed_1.root;
                                } else {
                                    phi_1331_ = _e756.unnamed_1.first_primitive;
                                }
                                let _e828 = phi_1331_;
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e339)), ((f32(((_e819 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e340)));
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e341)));
                                if (_e807 <= _e842) {
                                    if (_e807 <= _e147) {
                                        if (_e842 >= 0f) {
                                            if (_e771 == 0u) {
                                                let _e849 = nodes.member[(0u + _e497)].links[2u];
                                                phi_1367_ = _e849;
                                            } else {
                                                let _e852 = nodes.member[(0u + _e497)].links[3u];
                                                phi_1367_ = _e852;
                                            }
                                            let _e854 = phi_1367_;
                                            let _e859 = ((_e854 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u);
                                            let _e860 = (_e859 & 31u);
                                            if (_e860 >= 24u) {
                                                phi_1380_ = (24u + ((_e860 - 24u) ^ _e359));
                                            } else {
                                                phi_1380_ = _e860;
                                            }
                                            let _e866 = phi_1380_;
                                            phi_1385_ = (_e768 | ((_e859 >> bitcast<u32>(5i)) << bitcast<u32>((_e866 & 31u))));
                                        } else {
                                            phi_1385_ = _e768;
                                        }
                                        let _e874 = phi_1385_;
                                        phi_1386_ = _e874;
                                    } else {
                                        phi_1386_ = _e768;
                                    }
                                    let _e876 = phi_1386_;
                                    phi_1387_ = _e876;
                                } else {
                                    phi_1387_ = _e768;
                                }
                                let _e878 = phi_1387_;
                                phi_1257_ = (_e766 + 1u);
                                phi_1260_ = _e878;
                            } else {
                                phi_1257_ = u32();
                                phi_1260_ = u32();
                            }
                            let _e881 = phi_1257_;
                            let _e883 = phi_1260_;
                            continue;
                            continuing {
                                phi_1256_ = _e881;
                                phi_1259_ = _e883;
                                break if !(_e769);
                            }
                        }
                        let _e887 = nodes.member[(0u + _e497)].links[0u];
                        let _e891 = nodes.member[(0u + _e497)].frame[3u];
                        let _e895 = local_3;
                        if ((_e895 & 4278190080u) == 0u) {
                        } else {
                            let _e899 = local_2.group_mask;
                            if ((_e899 & 4278190080u) == 0u) {
                            } else {
                                let _e903 = local_2.len;
                                if (_e903 < 32u) {
                                    let _e906 = local_2.group;
                                    let _e908 = local_2.len;
                                    if (_e908 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e908)] = _e906;
                                    let _e914 = local_2.group_mask;
                                    let _e916 = local_2.len;
                                    if (_e916 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e916)] = _e914;
                                    let _e923 = local_2.len;
                                    local_2.len = (_e923 + 1u);
                                }
                            }
                            local_2.group = (_e117 + _e887);
                            let _e927 = local_4;
                            local_2.group_mask = ((_e927 & 4278190080u) | (_e891 >> bitcast<u32>(24i)));
                        }
                        let _e932 = local_5;
                        phi_1445_ = (_e932 & 16777215u);
                        phi_1448_ = _e499;
                        loop {
                            let _e935 = phi_1445_;
                            let _e937 = phi_1448_;
                            local_18 = _e937;
                            let _e938 = (_e935 == 0u);
                            local_11 = _e938;
                            local_19 = _e938;
                            if _e938 {
                                phi_1446_ = u32();
                                phi_1449_ = bool();
                                phi_3307_ = false;
                            } else {
                                let _e941 = nodes.member[(0u + _e497)].links[1u];
                                let _e945 = (_e941 + select(firstTrailingBit(_e935), 32u, (_e935 == 0u)));
                                if (_e945 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e952 = instances.member[(0u + _e945)].low_world;
                                let _e954 = instances.member[(0u + _e945)].high_world;
                                let _e961 = ((_e952.x - _e137) * _e287);
                                let _e962 = ((_e952.y - _e139) * _e297);
                                let _e963 = ((_e952.z - _e141) * _e307);
                                let _e970 = ((_e954.x - _e137) * _e287);
                                let _e971 = ((_e954.y - _e139) * _e297);
                                let _e972 = ((_e954.z - _e141) * _e307);
                                if (_e961 < _e970) {
                                    phi_1497_ = _e961;
                                } else {
                                    phi_1497_ = _e970;
                                }
                                let _e975 = phi_1497_;
                                if (_e962 < _e971) {
                                    phi_1502_ = _e962;
                                } else {
                                    phi_1502_ = _e971;
                                }
                                let _e978 = phi_1502_;
                                if (_e963 < _e972) {
                                    phi_1507_ = _e963;
                                } else {
                                    phi_1507_ = _e972;
                                }
                                let _e981 = phi_1507_;
                                if (_e961 > _e970) {
                                    phi_1515_ = _e961;
                                } else {
                                    phi_1515_ = _e970;
                                }
                                let _e987 = phi_1515_;
                                if (_e962 > _e971) {
                                    phi_1520_ = _e962;
                                } else {
                                    phi_1520_ = _e971;
                                }
                                let _e990 = phi_1520_;
                                if (_e963 > _e972) {
                                    phi_1525_ = _e963;
                                } else {
                                    phi_1525_ = _e972;
                                }
                                let _e993 = phi_1525_;
                                let _e997 = core_intrinsics_maximum_number_nsz_f32_((_e975 - _e346), (_e978 - _e347));
                                let _e998 = core_intrinsics_maximum_number_nsz_f32_(_e997, (_e981 - _e348));
                                let _e999 = core_intrinsics_minimum_number_nsz_f32_((_e987 + _e346), (_e990 + _e347));
                                let _e1000 = core_intrinsics_minimum_number_nsz_f32_(_e999, (_e993 + _e348));
                                if (_e998 <= _e1000) {
                                    if (_e998 <= _e147) {
                                        if (_e1000 >= 0f) {
                                            let _e1006 = instances.member[(0u + _e945)].world_to_object[0u];
                                            let _e1017 = ((((_e1006.x * _e137) + (_e1006.y * _e139)) + (_e1006.z * _e141)) + (_e1006.w * 1f));
                                            let _e1019 = instances.member[(0u + _e945)].world_to_object[1u];
                                            let _e1030 = ((((_e1019.x * _e137) + (_e1019.y * _e139)) + (_e1019.z * _e141)) + (_e1019.w * 1f));
                                            let _e1032 = instances.member[(0u + _e945)].world_to_object[2u];
                                            let _e1043 = ((((_e1032.x * _e137) + (_e1032.y * _e139)) + (_e1032.z * _e141)) + (_e1032.w * 1f));
                                            let _e1046 = instances.member[(0u + _e945)].world_to_object[0u];
                                            let _e1057 = ((((_e1046.x * _e155) + (_e1046.y * _e156)) + (_e1046.z * _e157)) + (_e1046.w * 0f));
                                            let _e1059 = instances.member[(0u + _e945)].world_to_object[1u];
                                            let _e1070 = ((((_e1059.x * _e155) + (_e1059.y * _e156)) + (_e1059.z * _e157)) + (_e1059.w * 0f));
                                            let _e1072 = instances.member[(0u + _e945)].world_to_object[2u];
                                            let _e1083 = ((((_e1072.x * _e155) + (_e1072.y * _e156)) + (_e1072.z * _e157)) + (_e1072.w * 0f));
                                            let _e1086 = instances.member[(0u + _e945)].root;
                                            let _e1088 = instances.member[(0u + _e945)].first_triangle;
                                            let _e1089 = abs(_e1057);
                                            let _e1090 = abs(_e1070);
                                            let _e1091 = abs(_e1083);
                                            if (abs(_e1017) < 1000000000000000f) {
                                                if (abs(_e1030) < 1000000000000000f) {
                                                    phi_1645_ = (abs(_e1043) < 1000000000000000f);
                                                    phi_1646_ = false;
                                                } else {
                                                    phi_1645_ = bool();
                                                    phi_1646_ = true;
                                                }
                                                let _e1099 = phi_1645_;
                                                let _e1101 = phi_1646_;
                                                phi_1647_ = _e1099;
                                                phi_1648_ = _e1101;
                                            } else {
                                                phi_1647_ = bool();
                                                phi_1648_ = true;
                                            }
                                            let _e1103 = phi_1647_;
                                            let _e1105 = phi_1648_;
                                            if _e1105 {
                                                phi_1652_ = false;
                                            } else {
                                                phi_1652_ = _e1103;
                                            }
                                            let _e1107 = phi_1652_;
                                            if _e1107 {
                                                if (_e1089 < 1000000000000000f) {
                                                    if (_e1090 < 1000000000000000f) {
                                                        phi_1665_ = (_e1091 < 1000000000000000f);
                                                        phi_1666_ = false;
                                                    } else {
                                                        phi_1665_ = bool();
                                                        phi_1666_ = true;
                                                    }
                                                    let _e1112 = phi_1665_;
                                                    let _e1114 = phi_1666_;
                                                    phi_1667_ = _e1112;
                                                    phi_1668_ = _e1114;
                                                } else {
                                                    phi_1667_ = bool();
                                                    phi_1668_ = true;
                                                }
                                                let _e1116 = phi_1667_;
                                                let _e1118 = phi_1668_;
                                                if _e1118 {
                                                    phi_1672_ = false;
                                                } else {
                                                    phi_1672_ = _e1116;
                                                }
                                                let _e1120 = phi_1672_;
                                                if _e1120 {
                                                    if (_e1089 > 0f) {
                                                        phi_1686_ = bool();
                                                        phi_1687_ = true;
                                                    } else {
                                                        let _e1122 = (_e1090 > 0f);
                                                        if _e1122 {
                                                            phi_1685_ = bool();
                                                        } else {
                                                            phi_1685_ = (_e1091 > 0f);
                                                        }
                                                        let _e1125 = phi_1685_;
                                                        phi_1686_ = _e1125;
                                                        phi_1687_ = _e1122;
                                                    }
                                                    let _e1127 = phi_1686_;
                                                    let _e1129 = phi_1687_;
                                                    if _e1129 {
                                                        phi_1691_ = true;
                                                    } else {
                                                        phi_1691_ = _e1127;
                                                    }
                                                    let _e1131 = phi_1691_;
                                                    phi_1692_ = _e1131;
                                                    phi_1693_ = false;
                                                } else {
                                                    phi_1692_ = bool();
                                                    phi_1693_ = true;
                                                }
                                                let _e1133 = phi_1692_;
                                                let _e1135 = phi_1693_;
                                                phi_1694_ = _e1133;
                                                phi_1695_ = _e1135;
                                            } else {
                                                phi_1694_ = bool();
                                                phi_1695_ = true;
                                            }
                                            let _e1137 = phi_1694_;
                                            let _e1139 = phi_1695_;
                                            if _e1139 {
                                                phi_1699_ = false;
                                            } else {
                                                phi_1699_ = _e1137;
                                            }
                                            let _e1141 = phi_1699_;
                                            if _e1141 {
                                                let _e1142 = (_e1086 >= _e78);
                                                if _e1142 {
                                                    phi_3287_ = bool();
                                                } else {
                                                    if (_e1086 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1148 = nodes.member[(0u + _e1086)].frame[0u];
                                                    let _e1152 = nodes.member[(0u + _e1086)].frame[1u];
                                                    let _e1156 = nodes.member[(0u + _e1086)].frame[2u];
                                                    let _e1160 = nodes.member[(0u + _e1086)].frame[0u];
                                                    let _e1164 = nodes.member[(0u + _e1086)].frame[1u];
                                                    let _e1168 = nodes.member[(0u + _e1086)].frame[2u];
                                                    let _e1172 = nodes.member[(0u + _e1086)].frame[3u];
                                                    let _e1206 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1057), abs(_e1070));
                                                    let _e1207 = core_intrinsics_maximum_number_nsz_f32_(_e1206, abs(_e1083));
                                                    let _e1208 = (_e1207 * 0.0000000000009094947f);
                                                    if (abs(_e1057) < _e1208) {
                                                        phi_1769_ = _e1208;
                                                    } else {
                                                        phi_1769_ = abs(_e1057);
                                                    }
                                                    let _e1213 = phi_1769_;
                                                    if (_e1057 < 0f) {
                                                        phi_1776_ = (-1f / _e1213);
                                                    } else {
                                                        phi_1776_ = (1f / _e1213);
                                                    }
                                                    let _e1218 = phi_1776_;
                                                    if (abs(_e1070) < _e1208) {
                                                        phi_1783_ = _e1208;
                                                    } else {
                                                        phi_1783_ = abs(_e1070);
                                                    }
                                                    let _e1223 = phi_1783_;
                                                    if (_e1070 < 0f) {
                                                        phi_1790_ = (-1f / _e1223);
                                                    } else {
                                                        phi_1790_ = (1f / _e1223);
                                                    }
                                                    let _e1228 = phi_1790_;
                                                    if (abs(_e1083) < _e1208) {
                                                        phi_1797_ = _e1208;
                                                    } else {
                                                        phi_1797_ = abs(_e1083);
                                                    }
                                                    let _e1233 = phi_1797_;
                                                    if (_e1083 < 0f) {
                                                        phi_1804_ = (-1f / _e1233);
                                                    } else {
                                                        phi_1804_ = (1f / _e1233);
                                                    }
                                                    let _e1238 = phi_1804_;
                                                    let _e1242 = abs((bitcast<f32>(_e1148) - _e1017));
                                                    let _e1243 = abs((bitcast<f32>(_e1152) - _e1030));
                                                    let _e1244 = abs((bitcast<f32>(_e1156) - _e1043));
                                                    let _e1248 = abs(((bitcast<f32>(_e1160) + (bitcast<f32>((((_e1172 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1017));
                                                    let _e1249 = abs(((bitcast<f32>(_e1164) + (bitcast<f32>((((_e1172 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1030));
                                                    let _e1250 = abs(((bitcast<f32>(_e1168) + (bitcast<f32>((((_e1172 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1043));
                                                    if (_e1242 > _e1248) {
                                                        phi_1821_ = _e1242;
                                                    } else {
                                                        phi_1821_ = _e1248;
                                                    }
                                                    let _e1253 = phi_1821_;
                                                    if (_e1243 > _e1249) {
                                                        phi_1826_ = _e1243;
                                                    } else {
                                                        phi_1826_ = _e1249;
                                                    }
                                                    let _e1256 = phi_1826_;
                                                    if (_e1244 > _e1250) {
                                                        phi_1831_ = _e1244;
                                                    } else {
                                                        phi_1831_ = _e1250;
                                                    }
                                                    let _e1259 = phi_1831_;
                                                    if (_e1253 > _e1256) {
                                                        phi_1836_ = _e1253;
                                                    } else {
                                                        phi_1836_ = _e1256;
                                                    }
                                                    let _e1262 = phi_1836_;
                                                    if (_e1262 > _e1259) {
                                                        phi_1841_ = _e1262;
                                                    } else {
                                                        phi_1841_ = _e1259;
                                                    }
                                                    let _e1265 = phi_1841_;
                                                    let _e1269 = (_e1265 * 0.0000019073486f);
                                                    let _e1270 = (abs(_e1218) * _e1269);
                                                    let _e1271 = (abs(_e1228) * _e1269);
                                                    let _e1272 = (abs(_e1238) * _e1269);
                                                    let _e1276 = (_e1265 * 0.0000009536743f);
                                                    let _e1277 = (abs(_e1218) * _e1276);
                                                    let _e1278 = (abs(_e1228) * _e1276);
                                                    let _e1279 = (abs(_e1238) * _e1276);
                                                    let _e1280 = abs(_e1057);
                                                    let _e1281 = abs(_e1070);
                                                    let _e1282 = abs(_e1083);
                                                    if (_e1280 >= _e1281) {
                                                        if (_e1280 >= _e1282) {
                                                            phi_1867_ = false;
                                                        } else {
                                                            phi_1867_ = true;
                                                        }
                                                        let _e1286 = phi_1867_;
                                                        phi_1868_ = _e1286;
                                                    } else {
                                                        phi_1868_ = true;
                                                    }
                                                    let _e1288 = phi_1868_;
                                                    if _e1288 {
                                                        if (_e1281 >= _e1282) {
                                                            phi_1876_ = 1u;
                                                        } else {
                                                            phi_1876_ = 2u;
                                                        }
                                                        let _e1291 = phi_1876_;
                                                        phi_1877_ = _e1291;
                                                    } else {
                                                        phi_1877_ = 0u;
                                                    }
                                                    let _e1293 = phi_1877_;
                                                    if (_e1293 == 0u) {
                                                        phi_1889_ = vec3<f32>(_e1070, _e1083, _e1057);
                                                    } else {
                                                        if (_e1293 == 1u) {
                                                            phi_1888_ = vec3<f32>(_e1083, _e1057, _e1070);
                                                        } else {
                                                            phi_1888_ = vec3<f32>(_e1057, _e1070, _e1083);
                                                        }
                                                        let _e1299 = phi_1888_;
                                                        phi_1889_ = _e1299;
                                                    }
                                                    let _e1301 = phi_1889_;
                                                    let _e1304 = (_e1301.x / _e1301.z);
                                                    let _e1307 = (_e1301.y / _e1301.z);
                                                    if (_e1218 < 0f) {
                                                        phi_1902_ = 0u;
                                                    } else {
                                                        phi_1902_ = 1u;
                                                    }
                                                    let _e1312 = phi_1902_;
                                                    if (_e1228 < 0f) {
                                                        phi_1907_ = 0u;
                                                    } else {
                                                        phi_1907_ = 2u;
                                                    }
                                                    let _e1315 = phi_1907_;
                                                    if (_e1238 < 0f) {
                                                        phi_1912_ = 0u;
                                                    } else {
                                                        phi_1912_ = 4u;
                                                    }
                                                    let _e1318 = phi_1912_;
                                                    let _e1320 = ((_e1312 | _e1315) | _e1318);
                                                    let _e1321 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1086, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1321.first[0], _e1321.first[1], _e1321.first[2], _e1321.first[3], _e1321.first[4], _e1321.first[5], _e1321.first[6], _e1321.first[7], _e1321.first[8], _e1321.first[9], _e1321.first[10], _e1321.first[11], _e1321.first[12], _e1321.first[13], _e1321.first[14], _e1321.first[15], _e1321.first[16], _e1321.first[17], _e1321.first[18], _e1321.first[19], _e1321.first[20], _e1321.first[21], _e1321.first[22], _e1321.first[23], _e1321.first[24], _e1321.first[25], _e1321.first[26], _e1321.first[27], _e1321.first[28], _e1321.first[29], _e1321.first[30], _e1321.first[31]), array<u32, 32>(_e1321.mask[0], _e1321.mask[1], _e1321.mask[2], _e1321.mask[3], _e1321.mask[4], _e1321.mask[5], _e1321.mask[6], _e1321.mask[7], _e1321.mask[8], _e1321.mask[9], _e1321.mask[10], _e1321.mask[11], _e1321.mask[12], _e1321.mask[13], _e1321.mask[14], _e1321.mask[15], _e1321.mask[16], _e1321.mask[17], _e1321.mask[18], _e1321.mask[19], _e1321.mask[20], _e1321.mask[21], _e1321.mask[22], _e1321.mask[23], _e1321.mask[24], _e1321.mask[25], _e1321.mask[26], _e1321.mask[27], _e1321.mask[28], _e1321.mask[29], _e1321.mask[30], _e1321.mask[31]), _e1321.len, _e1321.group, _e1321.group_mask);
                                                    let _e1395 = local_1.group_mask;
                                                    if ((_e1395 & 4278190080u) == 0u) {
                                                        let _e1399 = local_1.len;
                                                        if (_e1399 == 0u) {
                                                            phi_2026_ = false;
                                                        } else {
                                                            let _e1403 = local_1.len;
                                                            local_1.len = (_e1403 - 1u);
                                                            let _e1406 = local_1.len;
                                                            if (_e1406 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1411 = local_1.first[(0u + _e1406)];
                                                            local_1.group = _e1411;
                                                            let _e1414 = local_1.len;
                                                            if (_e1414 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1419 = local_1.mask[(0u + _e1414)];
                                                            local_1.group_mask = _e1419;
                                                            phi_2026_ = true;
                                                        }
                                                        let _e1422 = phi_2026_;
                                                        phi_2027_ = _e1422;
                                                    } else {
                                                        phi_2027_ = true;
                                                    }
                                                    let _e1424 = phi_2027_;
                                                    if _e1424 {
                                                        let _e1426 = local_1.group_mask;
                                                        let _e1432 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1426)), 32u, (_e1426 == 0u)));
                                                        let _e1436 = local_1.group_mask;
                                                        let _e1450 = local_1.group_mask;
                                                        local_1.group_mask = (_e1450 & ~((1u << bitcast<u32>((_e1432 & 31u)))));
                                                        let _e1453 = local_1.group;
                                                        phi_2058_ = (_e1453 + countOneBits(((_e1436 & ~((4294967295u << bitcast<u32>((((_e1432 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2058_ = 4294967295u;
                                                    }
                                                    let _e1456 = phi_2058_;
                                                    phi_2060_ = _e1456;
                                                    phi_2063_ = _e937;
                                                    loop {
                                                        let _e1458 = phi_2060_;
                                                        let _e1460 = phi_2063_;
                                                        local_17 = _e1460;
                                                        if (_e1458 != 4294967295u) {
                                                            if (_e1458 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1467 = nodes.member[(0u + _e1458)].frame[3u];
                                                            let _e1492 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1218);
                                                            let _e1493 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1228);
                                                            let _e1494 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1238);
                                                            let _e1497 = nodes.member[(0u + _e1458)].frame[0u];
                                                            let _e1501 = nodes.member[(0u + _e1458)].frame[1u];
                                                            let _e1505 = nodes.member[(0u + _e1458)].frame[2u];
                                                            let _e1510 = ((bitcast<f32>(_e1497) - _e1017) * _e1218);
                                                            let _e1511 = ((bitcast<f32>(_e1501) - _e1030) * _e1228);
                                                            let _e1512 = ((bitcast<f32>(_e1505) - _e1043) * _e1238);
                                                            let _e1520 = nodes.member[(0u + _e1458)].x;
                                                            if (_e1218 < 0f) {
                                                                let _e1531 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1531.unnamed.root, _e1520.w), _e1531.unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1537.unnamed, lt_bvh_traverse_Tree(_e1520.x, _e1537.unnamed_1.first_primitive));
                                                                phi_2143_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1543.unnamed_1.root, _e1520.y));
                                                            } else {
                                                                let _e1559 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1559.unnamed.root, _e1520.y), _e1559.unnamed_1);
                                                                let _e1571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1565.unnamed, lt_bvh_traverse_Tree(_e1520.z, _e1565.unnamed_1.first_primitive));
                                                                phi_2143_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1571.unnamed, lt_bvh_traverse_Tree(_e1571.unnamed_1.root, _e1520.w));
                                                            }
                                                            let _e1579 = phi_2143_;
                                                            let _e1589 = nodes.member[(0u + _e1458)].y;
                                                            if (_e1228 < 0f) {
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1600.unnamed.root, _e1589.w), _e1600.unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_bvh_traverse_Tree(_e1589.x, _e1606.unnamed_1.first_primitive));
                                                                phi_2170_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1612.unnamed_1.root, _e1589.y));
                                                            } else {
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1628.unnamed.root, _e1589.y), _e1628.unnamed_1);
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_bvh_traverse_Tree(_e1589.z, _e1634.unnamed_1.first_primitive));
                                                                phi_2170_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_bvh_traverse_Tree(_e1640.unnamed_1.root, _e1589.w));
                                                            }
                                                            let _e1648 = phi_2170_;
                                                            let _e1658 = nodes.member[(0u + _e1458)].z;
                                                            if (_e1238 < 0f) {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1669.unnamed.root, _e1658.w), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1658.x, _e1675.unnamed_1.first_primitive));
                                                                phi_2197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1681.unnamed_1.root, _e1658.y));
                                                            } else {
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1697.unnamed.root, _e1658.y), _e1697.unnamed_1);
                                                                let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_bvh_traverse_Tree(_e1658.z, _e1703.unnamed_1.first_primitive));
                                                                phi_2197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_bvh_traverse_Tree(_e1709.unnamed_1.root, _e1658.w));
                                                            }
                                                            let _e1717 = phi_2197_;
                                                            phi_2203_ = 0u;
                                                            phi_2206_ = 0u;
                                                            loop {
                                                                let _e1727 = phi_2203_;
                                                                let _e1729 = phi_2206_;
                                                                local_6 = _e1729;
                                                                local_7 = _e1729;
                                                                local_8 = _e1729;
                                                                let _e1730 = (_e1727 < 8u);
                                                                if _e1730 {
                                                                    let _e1732 = (_e1727 >> bitcast<u32>(2i));
                                                                    let _e1733 = (_e1727 & 3u);
                                                                    if (_e1732 == 0u) {
                                                                        phi_2220_ = _e1579.unnamed.root;
                                                                    } else {
                                                                        phi_2220_ = _e1579.unnamed.first_primitive;
                                                                    }
                                                                    let _e1736 = phi_2220_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2230_ = _e1648.unnamed.root;
                                                                    } else {
                                                                        phi_2230_ = _e1648.unnamed.first_primitive;
                                                                    }
                                                                    let _e1745 = phi_2230_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2240_ = _e1717.unnamed.root;
                                                                    } else {
                                                                        phi_2240_ = _e1717.unnamed.first_primitive;
                                                                    }
                                                                    let _e1754 = phi_2240_;
                                                                    let _e1767 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1736 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 - _e1270)), ((f32(((_e1745 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 - _e1271)));
                                                                    let _e1768 = core_intrinsics_maximum_number_nsz_f32_(_e1767, ((f32(((_e1754 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1272)));
                                                                    if (_e1732 == 0u) {
                                                                        phi_2258_ = _e1579.unnamed_1.root;
                                                                    } else {
                                                                        phi_2258_ = _e1579.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1771 = phi_2258_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2268_ = _e1648.unnamed_1.root;
                                                                    } else {
                                                                        phi_2268_ = _e1648.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1780 = phi_2268_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2278_ = _e1717.unnamed_1.root;
                                                                    } else {
                                                                        phi_2278_ = _e1717.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1789 = phi_2278_;
                                                                    let _e1802 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1771 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 + _e1270)), ((f32(((_e1780 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 + _e1271)));
                                                                    let _e1803 = core_intrinsics_minimum_number_nsz_f32_(_e1802, ((f32(((_e1789 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1272)));
                                                                    if (_e1768 <= _e1803) {
                                                                        if (_e1768 <= _e147) {
                                                                            if (_e1803 >= 0f) {
                                                                                if (_e1732 == 0u) {
                                                                                    let _e1810 = nodes.member[(0u + _e1458)].links[2u];
                                                                                    phi_2314_ = _e1810;
                                                                                } else {
                                                                                    let _e1813 = nodes.member[(0u + _e1458)].links[3u];
                                                                                    phi_2314_ = _e1813;
                                                                                }
                                                                                let _e1815 = phi_2314_;
                                                                                let _e1820 = ((_e1815 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u);
                                                                                let _e1821 = (_e1820 & 31u);
                                                                                if (_e1821 >= 24u) {
                                                                                    phi_2327_ = (24u + ((_e1821 - 24u) ^ _e1320));
                                                                                } else {
                                                                                    phi_2327_ = _e1821;
                                                                                }
                                                                                let _e1827 = phi_2327_;
                                                                                phi_2332_ = (_e1729 | ((_e1820 >> bitcast<u32>(5i)) << bitcast<u32>((_e1827 & 31u))));
                                                                            } else {
                                                                                phi_2332_ = _e1729;
                                                                            }
                                                                            let _e1835 = phi_2332_;
                                                                            phi_2333_ = _e1835;
                                                                        } else {
                                                                            phi_2333_ = _e1729;
                                                                        }
                                                                        let _e1837 = phi_2333_;
                                                                        phi_2334_ = _e1837;
                                                                    } else {
                                                                        phi_2334_ = _e1729;
                                                                    }
                                                                    let _e1839 = phi_2334_;
                                                                    phi_2204_ = (_e1727 + 1u);
                                                                    phi_2207_ = _e1839;
                                                                } else {
                                                                    phi_2204_ = u32();
                                                                    phi_2207_ = u32();
                                                                }
                                                                let _e1842 = phi_2204_;
                                                                let _e1844 = phi_2207_;
                                                                continue;
                                                                continuing {
                                                                    phi_2203_ = _e1842;
                                                                    phi_2206_ = _e1844;
                                                                    break if !(_e1730);
                                                                }
                                                            }
                                                            let _e1848 = nodes.member[(0u + _e1458)].links[0u];
                                                            let _e1852 = nodes.member[(0u + _e1458)].frame[3u];
                                                            let _e1856 = local_6;
                                                            if ((_e1856 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1860 = local_1.group_mask;
                                                                if ((_e1860 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1864 = local_1.len;
                                                                    if (_e1864 < 32u) {
                                                                        let _e1867 = local_1.group;
                                                                        let _e1869 = local_1.len;
                                                                        if (_e1869 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1869)] = _e1867;
                                                                        let _e1875 = local_1.group_mask;
                                                                        let _e1877 = local_1.len;
                                                                        if (_e1877 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1877)] = _e1875;
                                                                        let _e1884 = local_1.len;
                                                                        local_1.len = (_e1884 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1086 + _e1848);
                                                                let _e1888 = local_7;
                                                                local_1.group_mask = ((_e1888 & 4278190080u) | (_e1852 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1893 = local_8;
                                                            phi_2392_ = (_e1893 & 16777215u);
                                                            phi_2395_ = _e1460;
                                                            loop {
                                                                let _e1896 = phi_2392_;
                                                                let _e1898 = phi_2395_;
                                                                local_13 = _e1898;
                                                                let _e1899 = (_e1896 == 0u);
                                                                local_9 = _e1899;
                                                                local_15 = _e1899;
                                                                if _e1899 {
                                                                    phi_2393_ = u32();
                                                                    phi_2396_ = bool();
                                                                    phi_3199_ = bool();
                                                                    phi_3200_ = false;
                                                                } else {
                                                                    let _e1902 = nodes.member[(0u + _e1458)].links[1u];
                                                                    let _e1907 = ((_e1088 + _e1902) + select(firstTrailingBit(_e1896), 32u, (_e1896 == 0u)));
                                                                    if (_e1907 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1914 = triangles.member[(0u + _e1907)].v0_;
                                                                    let _e1916 = (_e1914.x - _e1017);
                                                                    let _e1918 = (_e1914.y - _e1030);
                                                                    let _e1920 = (_e1914.z - _e1043);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2440_ = vec3<f32>(_e1918, _e1920, _e1916);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2439_ = vec3<f32>(_e1920, _e1916, _e1918);
                                                                        } else {
                                                                            phi_2439_ = (_e1914 - vec3<f32>(_e1017, _e1030, _e1043));
                                                                        }
                                                                        let _e1928 = phi_2439_;
                                                                        phi_2440_ = _e1928;
                                                                    }
                                                                    let _e1930 = phi_2440_;
                                                                    let _e1934 = (_e1930.x - (_e1304 * _e1930.z));
                                                                    let _e1938 = (_e1930.y - (_e1307 * _e1930.z));
                                                                    let _e1940 = triangles.member[(0u + _e1907)].v1_;
                                                                    let _e1942 = (_e1940.x - _e1017);
                                                                    let _e1944 = (_e1940.y - _e1030);
                                                                    let _e1946 = (_e1940.z - _e1043);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2470_ = vec3<f32>(_e1944, _e1946, _e1942);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2469_ = vec3<f32>(_e1946, _e1942, _e1944);
                                                                        } else {
                                                                            phi_2469_ = (_e1940 - vec3<f32>(_e1017, _e1030, _e1043));
                                                                        }
                                                                        let _e1954 = phi_2469_;
                                                                        phi_2470_ = _e1954;
                                                                    }
                                                                    let _e1956 = phi_2470_;
                                                                    let _e1960 = (_e1956.x - (_e1304 * _e1956.z));
                                                                    let _e1964 = (_e1956.y - (_e1307 * _e1956.z));
                                                                    let _e1966 = triangles.member[(0u + _e1907)].v2_;
                                                                    let _e1968 = (_e1966.x - _e1017);
                                                                    let _e1970 = (_e1966.y - _e1030);
                                                                    let _e1972 = (_e1966.z - _e1043);
                                                                    if (_e1293 == 0u) {
                                                                        phi_2500_ = vec3<f32>(_e1970, _e1972, _e1968);
                                                                    } else {
                                                                        if (_e1293 == 1u) {
                                                                            phi_2499_ = vec3<f32>(_e1972, _e1968, _e1970);
                                                                        } else {
                                                                            phi_2499_ = (_e1966 - vec3<f32>(_e1017, _e1030, _e1043));
                                                                        }
                                                                        let _e1980 = phi_2499_;
                                                                        phi_2500_ = _e1980;
                                                                    }
                                                                    let _e1982 = phi_2500_;
                                                                    let _e1986 = (_e1982.x - (_e1304 * _e1982.z));
                                                                    let _e1990 = (_e1982.y - (_e1307 * _e1982.z));
                                                                    if (_e1960 < _e1986) {
                                                                        phi_2519_ = true;
                                                                    } else {
                                                                        if (_e1960 == _e1986) {
                                                                            phi_2518_ = (_e1964 < _e1990);
                                                                        } else {
                                                                            phi_2518_ = false;
                                                                        }
                                                                        let _e1995 = phi_2518_;
                                                                        phi_2519_ = _e1995;
                                                                    }
                                                                    let _e1997 = phi_2519_;
                                                                    if _e1997 {
                                                                        phi_2523_ = _e1990;
                                                                        phi_2524_ = _e1986;
                                                                        phi_2525_ = _e1964;
                                                                        phi_2526_ = _e1960;
                                                                    } else {
                                                                        phi_2523_ = _e1964;
                                                                        phi_2524_ = _e1960;
                                                                        phi_2525_ = _e1990;
                                                                        phi_2526_ = _e1986;
                                                                    }
                                                                    let _e1999 = phi_2523_;
                                                                    let _e2001 = phi_2524_;
                                                                    let _e2003 = phi_2525_;
                                                                    let _e2005 = phi_2526_;
                                                                    let _e2008 = ((_e2005 * _e1999) - (_e2003 * _e2001));
                                                                    if _e1997 {
                                                                        phi_2534_ = -(_e2008);
                                                                    } else {
                                                                        phi_2534_ = _e2008;
                                                                    }
                                                                    let _e2011 = phi_2534_;
                                                                    if (_e1986 < _e1934) {
                                                                        phi_2545_ = true;
                                                                    } else {
                                                                        if (_e1986 == _e1934) {
                                                                            phi_2544_ = (_e1990 < _e1938);
                                                                        } else {
                                                                            phi_2544_ = false;
                                                                        }
                                                                        let _e2016 = phi_2544_;
                                                                        phi_2545_ = _e2016;
                                                                    }
                                                                    let _e2018 = phi_2545_;
                                                                    if _e2018 {
                                                                        phi_2549_ = _e1938;
                                                                        phi_2550_ = _e1934;
                                                                        phi_2551_ = _e1990;
                                                                        phi_2552_ = _e1986;
                                                                    } else {
                                                                        phi_2549_ = _e1990;
                                                                        phi_2550_ = _e1986;
                                                                        phi_2551_ = _e1938;
                                                                        phi_2552_ = _e1934;
                                                                    }
                                                                    let _e2020 = phi_2549_;
                                                                    let _e2022 = phi_2550_;
                                                                    let _e2024 = phi_2551_;
                                                                    let _e2026 = phi_2552_;
                                                                    let _e2029 = ((_e2026 * _e2020) - (_e2024 * _e2022));
                                                                    if _e2018 {
                                                                        phi_2560_ = -(_e2029);
                                                                    } else {
                                                                        phi_2560_ = _e2029;
                                                                    }
                                                                    let _e2032 = phi_2560_;
                                                                    if (_e1934 < _e1960) {
                                                                        phi_2571_ = true;
                                                                    } else {
                                                                        if (_e1934 == _e1960) {
                                                                            phi_2570_ = (_e1938 < _e1964);
                                                                        } else {
                                                                            phi_2570_ = false;
                                                                        }
                                                                        let _e2037 = phi_2570_;
                                                                        phi_2571_ = _e2037;
                                                                    }
                                                                    let _e2039 = phi_2571_;
                                                                    if _e2039 {
                                                                        phi_2575_ = _e1964;
                                                                        phi_2576_ = _e1960;
                                                                        phi_2577_ = _e1938;
                                                                        phi_2578_ = _e1934;
                                                                    } else {
                                                                        phi_2575_ = _e1938;
                                                                        phi_2576_ = _e1934;
                                                                        phi_2577_ = _e1964;
                                                                        phi_2578_ = _e1960;
                                                                    }
                                                                    let _e2041 = phi_2575_;
                                                                    let _e2043 = phi_2576_;
                                                                    let _e2045 = phi_2577_;
                                                                    let _e2047 = phi_2578_;
                                                                    let _e2050 = ((_e2047 * _e2041) - (_e2045 * _e2043));
                                                                    if _e2039 {
                                                                        phi_2586_ = -(_e2050);
                                                                    } else {
                                                                        phi_2586_ = _e2050;
                                                                    }
                                                                    let _e2053 = phi_2586_;
                                                                    if (_e2011 >= 0f) {
                                                                        if (_e2032 >= 0f) {
                                                                            if (_e2053 >= 0f) {
                                                                                phi_2601_ = ((_e2011 + _e2032) + _e2053);
                                                                                phi_2602_ = false;
                                                                            } else {
                                                                                phi_2601_ = f32();
                                                                                phi_2602_ = true;
                                                                            }
                                                                            let _e2060 = phi_2601_;
                                                                            let _e2062 = phi_2602_;
                                                                            phi_2603_ = _e2060;
                                                                            phi_2604_ = _e2062;
                                                                        } else {
                                                                            phi_2603_ = f32();
                                                                            phi_2604_ = true;
                                                                        }
                                                                        let _e2064 = phi_2603_;
                                                                        let _e2066 = phi_2604_;
                                                                        phi_2605_ = _e2064;
                                                                        phi_2606_ = _e2066;
                                                                    } else {
                                                                        phi_2605_ = f32();
                                                                        phi_2606_ = true;
                                                                    }
                                                                    let _e2068 = phi_2605_;
                                                                    let _e2070 = phi_2606_;
                                                                    if _e2070 {
                                                                        if (_e2011 <= 0f) {
                                                                            if (_e2032 <= 0f) {
                                                                                let _e2073 = (_e2053 <= 0f);
                                                                                if _e2073 {
                                                                                }
                                                                                phi_2624_ = ((_e2011 + _e2032) + _e2053);
                                                                                phi_2625_ = false;
                                                                                phi_2626_ = _e2073;
                                                                            } else {
                                                                                phi_2624_ = f32();
                                                                                phi_2625_ = true;
                                                                                phi_2626_ = false;
                                                                            }
                                                                            let _e2077 = phi_2624_;
                                                                            let _e2079 = phi_2625_;
                                                                            let _e2081 = phi_2626_;
                                                                            phi_2627_ = _e2077;
                                                                            phi_2628_ = _e2079;
                                                                            phi_2629_ = _e2081;
                                                                        } else {
                                                                            phi_2627_ = f32();
                                                                            phi_2628_ = true;
                                                                            phi_2629_ = false;
                                                                        }
                                                                        let _e2083 = phi_2627_;
                                                                        let _e2085 = phi_2628_;
                                                                        let _e2087 = phi_2629_;
                                                                        if _e2085 {
                                                                            phi_2633_ = false;
                                                                        } else {
                                                                            phi_2633_ = _e2087;
                                                                        }
                                                                        let _e2089 = phi_2633_;
                                                                        phi_2634_ = _e2083;
                                                                        phi_2635_ = _e2089;
                                                                    } else {
                                                                        phi_2634_ = _e2068;
                                                                        phi_2635_ = true;
                                                                    }
                                                                    let _e2091 = phi_2634_;
                                                                    let _e2093 = phi_2635_;
                                                                    if _e2093 {
                                                                        let _e2094 = (_e2091 == 0f);
                                                                        if _e2094 {
                                                                            phi_2951_ = lt_bvh_triangle_Intersection();
                                                                            phi_2952_ = false;
                                                                        } else {
                                                                            let _e2096 = triangles.member[(0u + _e1907)].v0_;
                                                                            let _e2098 = (_e2096.x - _e1017);
                                                                            let _e2100 = (_e2096.y - _e1030);
                                                                            let _e2102 = (_e2096.z - _e1043);
                                                                            if (_e1293 == 0u) {
                                                                                phi_2664_ = vec3<f32>(_e2100, _e2102, _e2098);
                                                                            } else {
                                                                                if (_e1293 == 1u) {
                                                                                    phi_2663_ = vec3<f32>(_e2102, _e2098, _e2100);
                                                                                } else {
                                                                                    phi_2663_ = (_e2096 - vec3<f32>(_e1017, _e1030, _e1043));
                                                                                }
                                                                                let _e2110 = phi_2663_;
                                                                                phi_2664_ = _e2110;
                                                                            }
                                                                            let _e2112 = phi_2664_;
                                                                            let _e2114 = triangles.member[(0u + _e1907)].v1_;
                                                                            let _e2116 = triangles.member[(0u + _e1907)].v0_;
                                                                            let _e2119 = (_e2114.x - _e2116.x);
                                                                            let _e2122 = (_e2114.y - _e2116.y);
                                                                            let _e2125 = (_e2114.z - _e2116.z);
                                                                            if (_e1293 == 0u) {
                                                                                phi_2690_ = vec3<f32>(_e2122, _e2125, _e2119);
                                                                            } else {
                                                                                if (_e1293 == 1u) {
                                                                                    phi_2689_ = vec3<f32>(_e2125, _e2119, _e2122);
                                                                                } else {
                                                                                    phi_2689_ = (_e2114 - _e2116);
                                                                                }
                                                                                let _e2132 = phi_2689_;
                                                                                phi_2690_ = _e2132;
                                                                            }
                                                                            let _e2134 = phi_2690_;
                                                                            let _e2136 = triangles.member[(0u + _e1907)].v2_;
                                                                            let _e2138 = triangles.member[(0u + _e1907)].v0_;
                                                                            let _e2141 = (_e2136.x - _e2138.x);
                                                                            let _e2144 = (_e2136.y - _e2138.y);
                                                                            let _e2147 = (_e2136.z - _e2138.z);
                                                                            if (_e1293 == 0u) {
                                                                                phi_2716_ = vec3<f32>(_e2144, _e2147, _e2141);
                                                                            } else {
                                                                                if (_e1293 == 1u) {
                                                                                    phi_2715_ = vec3<f32>(_e2147, _e2141, _e2144);
                                                                                } else {
                                                                                    phi_2715_ = (_e2136 - _e2138);
                                                                                }
                                                                                let _e2154 = phi_2715_;
                                                                                phi_2716_ = _e2154;
                                                                            }
                                                                            let _e2156 = phi_2716_;
                                                                            let _e2163 = ((_e2134.y * _e2156.z) - (_e2134.z * _e2156.y));
                                                                            let _e2170 = ((_e2134.z * _e2156.x) - (_e2134.x * _e2156.z));
                                                                            let _e2177 = ((_e2134.x * _e2156.y) - (_e2134.y * _e2156.x));
                                                                            let _e2191 = (((1f / _e1301.z) * (((_e2163 * _e2112.x) + (_e2170 * _e2112.y)) + (_e2177 * _e2112.z))) / (((_e2163 * _e1304) + (_e2170 * _e1307)) + _e2177));
                                                                            if (_e2191 > 0f) {
                                                                                if (_e2191 < _e147) {
                                                                                    let _e2195 = triangles.member[(0u + _e1907)].v0_;
                                                                                    let _e2197 = triangles.member[(0u + _e1907)].v1_;
                                                                                    if (_e2195.x < _e2197.x) {
                                                                                        phi_2772_ = _e2195.x;
                                                                                    } else {
                                                                                        phi_2772_ = _e2197.x;
                                                                                    }
                                                                                    let _e2204 = phi_2772_;
                                                                                    if (_e2195.y < _e2197.y) {
                                                                                        phi_2781_ = _e2195.y;
                                                                                    } else {
                                                                                        phi_2781_ = _e2197.y;
                                                                                    }
                                                                                    let _e2211 = phi_2781_;
                                                                                    if (_e2195.z < _e2197.z) {
                                                                                        phi_2790_ = _e2195.z;
                                                                                    } else {
                                                                                        phi_2790_ = _e2197.z;
                                                                                    }
                                                                                    let _e2218 = phi_2790_;
                                                                                    let _e2220 = triangles.member[(0u + _e1907)].v2_;
                                                                                    if (_e2204 < _e2220.x) {
                                                                                        phi_2799_ = _e2204;
                                                                                    } else {
                                                                                        phi_2799_ = _e2220.x;
                                                                                    }
                                                                                    let _e2225 = phi_2799_;
                                                                                    if (_e2211 < _e2220.y) {
                                                                                        phi_2806_ = _e2211;
                                                                                    } else {
                                                                                        phi_2806_ = _e2220.y;
                                                                                    }
                                                                                    let _e2230 = phi_2806_;
                                                                                    if (_e2218 < _e2220.z) {
                                                                                        phi_2813_ = _e2218;
                                                                                    } else {
                                                                                        phi_2813_ = _e2220.z;
                                                                                    }
                                                                                    let _e2235 = phi_2813_;
                                                                                    let _e2237 = triangles.member[(0u + _e1907)].v0_;
                                                                                    let _e2239 = triangles.member[(0u + _e1907)].v1_;
                                                                                    if (_e2237.x > _e2239.x) {
                                                                                        phi_2826_ = _e2237.x;
                                                                                    } else {
                                                                                        phi_2826_ = _e2239.x;
                                                                                    }
                                                                                    let _e2246 = phi_2826_;
                                                                                    if (_e2237.y > _e2239.y) {
                                                                                        phi_2835_ = _e2237.y;
                                                                                    } else {
                                                                                        phi_2835_ = _e2239.y;
                                                                                    }
                                                                                    let _e2253 = phi_2835_;
                                                                                    if (_e2237.z > _e2239.z) {
                                                                                        phi_2844_ = _e2237.z;
                                                                                    } else {
                                                                                        phi_2844_ = _e2239.z;
                                                                                    }
                                                                                    let _e2260 = phi_2844_;
                                                                                    let _e2262 = triangles.member[(0u + _e1907)].v2_;
                                                                                    if (_e2246 > _e2262.x) {
                                                                                        phi_2853_ = _e2246;
                                                                                    } else {
                                                                                        phi_2853_ = _e2262.x;
                                                                                    }
                                                                                    let _e2267 = phi_2853_;
                                                                                    if (_e2253 > _e2262.y) {
                                                                                        phi_2860_ = _e2253;
                                                                                    } else {
                                                                                        phi_2860_ = _e2262.y;
                                                                                    }
                                                                                    let _e2272 = phi_2860_;
                                                                                    if (_e2260 > _e2262.z) {
                                                                                        phi_2867_ = _e2260;
                                                                                    } else {
                                                                                        phi_2867_ = _e2262.z;
                                                                                    }
                                                                                    let _e2277 = phi_2867_;
                                                                                    let _e2281 = ((_e2225 - _e1017) * _e1218);
                                                                                    let _e2282 = ((_e2230 - _e1030) * _e1228);
                                                                                    let _e2283 = ((_e2235 - _e1043) * _e1238);
                                                                                    let _e2287 = ((_e2267 - _e1017) * _e1218);
                                                                                    let _e2288 = ((_e2272 - _e1030) * _e1228);
                                                                                    let _e2289 = ((_e2277 - _e1043) * _e1238);
                                                                                    if (_e2281 < _e2287) {
                                                                                        phi_2884_ = _e2281;
                                                                                    } else {
                                                                                        phi_2884_ = _e2287;
                                                                                    }
                                                                                    let _e2292 = phi_2884_;
                                                                                    if (_e2282 < _e2288) {
                                                                                        phi_2889_ = _e2282;
                                                                                    } else {
                                                                                        phi_2889_ = _e2288;
                                                                                    }
                                                                                    let _e2295 = phi_2889_;
                                                                                    if (_e2283 < _e2289) {
                                                                                        phi_2894_ = _e2283;
                                                                                    } else {
                                                                                        phi_2894_ = _e2289;
                                                                                    }
                                                                                    let _e2298 = phi_2894_;
                                                                                    if (_e2281 > _e2287) {
                                                                                        phi_2902_ = _e2281;
                                                                                    } else {
                                                                                        phi_2902_ = _e2287;
                                                                                    }
                                                                                    let _e2304 = phi_2902_;
                                                                                    if (_e2282 > _e2288) {
                                                                                        phi_2907_ = _e2282;
                                                                                    } else {
                                                                                        phi_2907_ = _e2288;
                                                                                    }
                                                                                    let _e2307 = phi_2907_;
                                                                                    if (_e2283 > _e2289) {
                                                                                        phi_2912_ = _e2283;
                                                                                    } else {
                                                                                        phi_2912_ = _e2289;
                                                                                    }
                                                                                    let _e2310 = phi_2912_;
                                                                                    let _e2314 = core_intrinsics_maximum_number_nsz_f32_((_e2292 - _e1277), (_e2295 - _e1278));
                                                                                    let _e2315 = core_intrinsics_maximum_number_nsz_f32_(_e2314, (_e2298 - _e1279));
                                                                                    let _e2316 = core_intrinsics_minimum_number_nsz_f32_((_e2304 + _e1277), (_e2307 + _e1278));
                                                                                    let _e2317 = core_intrinsics_minimum_number_nsz_f32_(_e2316, (_e2310 + _e1279));
                                                                                    if (_e2315 > _e998) {
                                                                                        phi_2924_ = _e2315;
                                                                                    } else {
                                                                                        phi_2924_ = _e998;
                                                                                    }
                                                                                    let _e2320 = phi_2924_;
                                                                                    if (_e2317 < _e1000) {
                                                                                        phi_2929_ = _e2317;
                                                                                    } else {
                                                                                        phi_2929_ = _e1000;
                                                                                    }
                                                                                    let _e2323 = phi_2929_;
                                                                                    if (_e2191 < _e2320) {
                                                                                        phi_2934_ = _e2320;
                                                                                    } else {
                                                                                        phi_2934_ = _e2191;
                                                                                    }
                                                                                    let _e2326 = phi_2934_;
                                                                                    if (_e2326 > _e2323) {
                                                                                        phi_2939_ = _e2323;
                                                                                    } else {
                                                                                        phi_2939_ = _e2326;
                                                                                    }
                                                                                    let _e2329 = phi_2939_;
                                                                                    phi_2944_ = lt_bvh_triangle_Intersection(_e2329, (_e2032 / _e2091), (_e2053 / _e2091), (_e2320 <= _e2323));
                                                                                    phi_2945_ = false;
                                                                                } else {
                                                                                    phi_2944_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2945_ = true;
                                                                                }
                                                                                let _e2335 = phi_2944_;
                                                                                let _e2337 = phi_2945_;
                                                                                phi_2946_ = _e2335;
                                                                                phi_2947_ = _e2337;
                                                                            } else {
                                                                                phi_2946_ = lt_bvh_triangle_Intersection();
                                                                                phi_2947_ = true;
                                                                            }
                                                                            let _e2339 = phi_2946_;
                                                                            let _e2341 = phi_2947_;
                                                                            if _e2341 {
                                                                            }
                                                                            phi_2951_ = _e2339;
                                                                            phi_2952_ = _e2341;
                                                                        }
                                                                        let _e2343 = phi_2951_;
                                                                        let _e2345 = phi_2952_;
                                                                        phi_2953_ = _e2343;
                                                                        phi_2954_ = _e2094;
                                                                        phi_2955_ = _e2345;
                                                                    } else {
                                                                        phi_2953_ = lt_bvh_triangle_Intersection();
                                                                        phi_2954_ = true;
                                                                        phi_2955_ = false;
                                                                    }
                                                                    let _e2347 = phi_2953_;
                                                                    let _e2349 = phi_2954_;
                                                                    let _e2351 = phi_2955_;
                                                                    if _e2349 {
                                                                        phi_2959_ = true;
                                                                    } else {
                                                                        phi_2959_ = _e2351;
                                                                    }
                                                                    let _e2353 = phi_2959_;
                                                                    if _e2353 {
                                                                        phi_2963_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2963_ = _e2347;
                                                                    }
                                                                    let _e2355 = phi_2963_;
                                                                    if _e2355.is_hit {
                                                                        if (_e2355.t > 0f) {
                                                                            if (_e2355.t < _e147) {
                                                                                let _e2362 = triangles.member[(0u + _e1907)].i0_;
                                                                                if ((_e2362 & 2147483648u) == 0u) {
                                                                                    phi_3182_ = true;
                                                                                } else {
                                                                                    if (_e1907 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2371 = triangles.member[(0u + _e1907)].i0_;
                                                                                    let _e2372 = (_e2371 & 2147483647u);
                                                                                    let _e2374 = triangles.member[(0u + _e1907)].i1_;
                                                                                    let _e2376 = triangles.member[(0u + _e1907)].i2_;
                                                                                    if (_e2372 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2380 = vertices.member[(0u + _e2372)];
                                                                                    if (_e2374 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2384 = vertices.member[(0u + _e2374)];
                                                                                    if (_e2376 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2388 = vertices.member[(0u + _e2376)];
                                                                                    let _e2389 = array<abi_Vertex, 3>(_e2380, _e2384, _e2388);
                                                                                    if (_e2389[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2395 = materials.member[(0u + _e2389[0].material)];
                                                                                    if ((_e2395.flags & 1u) == 1u) {
                                                                                        let _e2400 = ((1f - _e2355.u) - _e2355.v);
                                                                                        if (_e2395.cutoff <= 0f) {
                                                                                            phi_3180_ = true;
                                                                                        } else {
                                                                                            let _e2427 = (_e2395.base_color.w * ((((f32((_e2389[0].color >> bitcast<u32>(24i))) * _e2400) + (f32((_e2389[1].color >> bitcast<u32>(24i))) * _e2355.u)) + (f32((_e2389[2].color >> bitcast<u32>(24i))) * _e2355.v)) * (1f / 255f)));
                                                                                            if (_e2395.alpha_size == 0u) {
                                                                                                phi_3177_ = _e2427;
                                                                                            } else {
                                                                                                local.offset = _e2395.alpha_offset;
                                                                                                local.size = _e2395.alpha_size;
                                                                                                local.flags = _e2395.flags;
                                                                                                let _e2458 = _lt_shaders_texture_TextureView_quad((&local), (((_e2389[0].u * _e2400) + (_e2389[1].u * _e2355.u)) + (_e2389[2].u * _e2355.v)), (((_e2389[0].v * _e2400) + (_e2389[1].v * _e2355.u)) + (_e2389[2].v * _e2355.v)));
                                                                                                let _e2462 = (_e2458.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2462 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2466 = alpha_texels.member[(0u + _e2462)];
                                                                                                let _e2482 = (_e2458.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2482 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2486 = alpha_texels.member[(0u + _e2482)];
                                                                                                let _e2503 = (_e2458.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2503 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2507 = alpha_texels.member[(0u + _e2503)];
                                                                                                let _e2524 = (_e2458.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2524 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2528 = alpha_texels.member[(0u + _e2524)];
                                                                                                phi_3177_ = (_e2427 * (((((f32(((_e2466 >> bitcast<u32>((((_e2458.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2458.weights.x) + ((f32(((_e2486 >> bitcast<u32>((((_e2458.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2458.weights.y)) + ((f32(((_e2507 >> bitcast<u32>((((_e2458.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2458.weights.z)) + ((f32(((_e2528 >> bitcast<u32>((((_e2458.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2458.weights.w)));
                                                                                            }
                                                                                            let _e2544 = phi_3177_;
                                                                                            phi_3180_ = (_e2544 >= _e2395.cutoff);
                                                                                        }
                                                                                        let _e2548 = phi_3180_;
                                                                                        phi_3181_ = _e2548;
                                                                                    } else {
                                                                                        phi_3181_ = false;
                                                                                    }
                                                                                    let _e2550 = phi_3181_;
                                                                                    phi_3182_ = _e2550;
                                                                                }
                                                                                let _e2552 = phi_3182_;
                                                                                if _e2552 {
                                                                                    phi_3186_ = false;
                                                                                } else {
                                                                                    phi_3186_ = true;
                                                                                }
                                                                                let _e2554 = phi_3186_;
                                                                                phi_3187_ = _e2552;
                                                                                phi_3188_ = _e2552;
                                                                                phi_3189_ = _e2554;
                                                                            } else {
                                                                                phi_3187_ = bool();
                                                                                phi_3188_ = _e1898;
                                                                                phi_3189_ = true;
                                                                            }
                                                                            let _e2556 = phi_3187_;
                                                                            let _e2558 = phi_3188_;
                                                                            let _e2560 = phi_3189_;
                                                                            phi_3190_ = _e2556;
                                                                            phi_3191_ = _e2558;
                                                                            phi_3192_ = _e2560;
                                                                        } else {
                                                                            phi_3190_ = bool();
                                                                            phi_3191_ = _e1898;
                                                                            phi_3192_ = true;
                                                                        }
                                                                        let _e2562 = phi_3190_;
                                                                        let _e2564 = phi_3191_;
                                                                        let _e2566 = phi_3192_;
                                                                        phi_3193_ = _e2562;
                                                                        phi_3194_ = _e2564;
                                                                        phi_3195_ = _e2566;
                                                                    } else {
                                                                        phi_3193_ = bool();
                                                                        phi_3194_ = _e1898;
                                                                        phi_3195_ = true;
                                                                    }
                                                                    let _e2568 = phi_3193_;
                                                                    let _e2570 = phi_3194_;
                                                                    let _e2572 = phi_3195_;
                                                                    if _e2572 {
                                                                    }
                                                                    phi_2393_ = (_e1896 & (_e1896 - 1u));
                                                                    phi_2396_ = _e2570;
                                                                    phi_3199_ = _e2568;
                                                                    phi_3200_ = _e2572;
                                                                }
                                                                let _e2574 = phi_2393_;
                                                                let _e2576 = phi_2396_;
                                                                let _e2578 = phi_3199_;
                                                                let _e2580 = phi_3200_;
                                                                local_14 = _e2578;
                                                                continue;
                                                                continuing {
                                                                    phi_2392_ = _e2574;
                                                                    phi_2395_ = _e2576;
                                                                    break if !(_e2580);
                                                                }
                                                            }
                                                            let _e2583 = local_9;
                                                            if _e2583 {
                                                                let _e2585 = local_1.group_mask;
                                                                if ((_e2585 & 4278190080u) == 0u) {
                                                                    let _e2589 = local_1.len;
                                                                    if (_e2589 == 0u) {
                                                                        phi_3242_ = false;
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
                                                                        phi_3242_ = true;
                                                                    }
                                                                    let _e2612 = phi_3242_;
                                                                    phi_3243_ = _e2612;
                                                                } else {
                                                                    phi_3243_ = true;
                                                                }
                                                                let _e2614 = phi_3243_;
                                                                if _e2614 {
                                                                    let _e2616 = local_1.group_mask;
                                                                    let _e2622 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2616)), 32u, (_e2616 == 0u)));
                                                                    let _e2626 = local_1.group_mask;
                                                                    let _e2640 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2640 & ~((1u << bitcast<u32>((_e2622 & 31u)))));
                                                                    let _e2643 = local_1.group;
                                                                    phi_3274_ = (_e2643 + countOneBits(((_e2626 & ~((4294967295u << bitcast<u32>((((_e2622 - 24u) ^ _e1320) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3274_ = 4294967295u;
                                                                }
                                                                let _e2646 = phi_3274_;
                                                                phi_3275_ = _e2646;
                                                            } else {
                                                                phi_3275_ = u32();
                                                            }
                                                            let _e2648 = phi_3275_;
                                                            phi_2061_ = _e2648;
                                                            let _e3124 = local_13;
                                                            phi_2064_ = _e3124;
                                                            let _e3127 = local_14;
                                                            phi_3276_ = _e3127;
                                                            let _e3130 = local_15;
                                                            phi_3277_ = _e3130;
                                                            phi_3278_ = false;
                                                        } else {
                                                            phi_2061_ = u32();
                                                            phi_2064_ = bool();
                                                            phi_3276_ = bool();
                                                            phi_3277_ = false;
                                                            phi_3278_ = true;
                                                        }
                                                        let _e2650 = phi_2061_;
                                                        let _e2652 = phi_2064_;
                                                        let _e2654 = phi_3276_;
                                                        let _e2656 = phi_3277_;
                                                        let _e2658 = phi_3278_;
                                                        local_10 = _e2658;
                                                        local_16 = _e2654;
                                                        continue;
                                                        continuing {
                                                            phi_2060_ = _e2650;
                                                            phi_2063_ = _e2652;
                                                            break if !(_e2656);
                                                        }
                                                    }
                                                    let _e2661 = local_10;
                                                    if _e2661 {
                                                        phi_3282_ = false;
                                                    } else {
                                                        phi_3282_ = true;
                                                    }
                                                    let _e2663 = phi_3282_;
                                                    if _e2663 {
                                                        let _e3136 = local_16;
                                                        phi_3286_ = _e3136;
                                                    } else {
                                                        let _e3138 = local_17;
                                                        phi_3286_ = _e3138;
                                                    }
                                                    let _e2665 = phi_3286_;
                                                    phi_3287_ = _e2665;
                                                }
                                                let _e2667 = phi_3287_;
                                                phi_3288_ = _e2667;
                                                phi_3289_ = _e1142;
                                            } else {
                                                phi_3288_ = bool();
                                                phi_3289_ = true;
                                            }
                                            let _e2669 = phi_3288_;
                                            let _e2671 = phi_3289_;
                                            if _e2671 {
                                                phi_3293_ = _e937;
                                            } else {
                                                phi_3293_ = _e2669;
                                            }
                                            let _e2673 = phi_3293_;
                                            if _e2673 {
                                                phi_3297_ = false;
                                            } else {
                                                phi_3297_ = true;
                                            }
                                            let _e2675 = phi_3297_;
                                            phi_3298_ = _e2673;
                                            phi_3299_ = _e2675;
                                        } else {
                                            phi_3298_ = _e937;
                                            phi_3299_ = true;
                                        }
                                        let _e2677 = phi_3298_;
                                        let _e2679 = phi_3299_;
                                        phi_3300_ = _e2677;
                                        phi_3301_ = _e2679;
                                    } else {
                                        phi_3300_ = _e937;
                                        phi_3301_ = true;
                                    }
                                    let _e2681 = phi_3300_;
                                    let _e2683 = phi_3301_;
                                    phi_3302_ = _e2681;
                                    phi_3303_ = _e2683;
                                } else {
                                    phi_3302_ = _e937;
                                    phi_3303_ = true;
                                }
                                let _e2685 = phi_3302_;
                                let _e2687 = phi_3303_;
                                if _e2687 {
                                }
                                phi_1446_ = (_e935 & (_e935 - 1u));
                                phi_1449_ = _e2685;
                                phi_3307_ = _e2687;
                            }
                            let _e2689 = phi_1446_;
                            let _e2691 = phi_1449_;
                            let _e2693 = phi_3307_;
                            continue;
                            continuing {
                                phi_1445_ = _e2689;
                                phi_1448_ = _e2691;
                                break if !(_e2693);
                            }
                        }
                        let _e2696 = local_11;
                        if _e2696 {
                            let _e2698 = local_2.group_mask;
                            if ((_e2698 & 4278190080u) == 0u) {
                                let _e2702 = local_2.len;
                                if (_e2702 == 0u) {
                                    phi_3349_ = false;
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
                                    phi_3349_ = true;
                                }
                                let _e2725 = phi_3349_;
                                phi_3350_ = _e2725;
                            } else {
                                phi_3350_ = true;
                            }
                            let _e2727 = phi_3350_;
                            if _e2727 {
                                let _e2729 = local_2.group_mask;
                                let _e2735 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2729)), 32u, (_e2729 == 0u)));
                                let _e2739 = local_2.group_mask;
                                let _e2753 = local_2.group_mask;
                                local_2.group_mask = (_e2753 & ~((1u << bitcast<u32>((_e2735 & 31u)))));
                                let _e2756 = local_2.group;
                                phi_3381_ = (_e2756 + countOneBits(((_e2739 & ~((4294967295u << bitcast<u32>((((_e2735 - 24u) ^ _e359) & 31u))))) & 255u)));
                            } else {
                                phi_3381_ = 4294967295u;
                            }
                            let _e2759 = phi_3381_;
                            phi_3382_ = _e2759;
                        } else {
                            phi_3382_ = u32();
                        }
                        let _e2761 = phi_3382_;
                        phi_1114_ = _e2761;
                        let _e3161 = local_18;
                        phi_1117_ = _e3161;
                        let _e3164 = local_19;
                        phi_3383_ = _e3164;
                        phi_3384_ = false;
                    } else {
                        phi_1114_ = u32();
                        phi_1117_ = bool();
                        phi_3383_ = false;
                        phi_3384_ = true;
                    }
                    let _e2763 = phi_1114_;
                    let _e2765 = phi_1117_;
                    let _e2767 = phi_3383_;
                    let _e2769 = phi_3384_;
                    local_12 = _e2769;
                    continue;
                    continuing {
                        phi_1113_ = _e2763;
                        phi_1116_ = _e2765;
                        break if !(_e2767);
                    }
                }
                let _e2772 = local_12;
                if _e2772 {
                    phi_3388_ = false;
                } else {
                    phi_3388_ = true;
                }
                let _e2774 = phi_3388_;
                if _e2774 {
                }
                phi_3392_ = _e2774;
            }
            let _e2776 = phi_3392_;
            phi_3393_ = _e211;
            phi_3394_ = _e2776;
        } else {
            phi_3393_ = true;
            phi_3394_ = false;
        }
        let _e2778 = phi_3393_;
        let _e2780 = phi_3394_;
        if _e2778 {
            phi_3398_ = false;
            phi_3399_ = true;
        } else {
            phi_3398_ = true;
            phi_3399_ = _e2780;
        }
        let _e2782 = phi_3398_;
        let _e2784 = phi_3399_;
        if _e2784 {
            phi_3403_ = _e2782;
        } else {
            phi_3403_ = false;
        }
        let _e2786 = phi_3403_;
        if _e2786 {
            phi_3407_ = 0f;
        } else {
            phi_3407_ = 1f;
        }
        let _e2788 = phi_3407_;
        if (_e115 < _e84) {
        } else {
            return;
        }
        visibility.member[(0u + _e115)] = _e2788;
        let _e2794 = p.member.light.number;
        let _e2795 = (_e2794 * 3u);
        let _e2796 = (_e2795 / 32u);
        let _e2797 = (_e2795 % 32u);
        let _e2799 = p.member.light.mask_words;
        if (_e115 < _e84) {
        } else {
            return;
        }
        let _e2803 = visibility.member[(0u + _e115)];
        let _e2805 = ((_e115 * _e2799) + _e2796);
        if (_e2797 > 29u) {
            let _e2807 = (_e2805 + 1u);
            if (_e2807 < _e90) {
            } else {
                return;
            }
            let _e2811 = bits.member[(0u + _e2807)];
            phi_3448_ = _e2811;
        } else {
            phi_3448_ = 0u;
        }
        let _e2813 = phi_3448_;
        if (_e2805 < _e90) {
        } else {
            return;
        }
        let _e2817 = bits.member[(0u + _e2805)];
        let _e2820 = (_e2817 >> bitcast<u32>((_e2797 & 31u)));
        if (_e2797 > 29u) {
            phi_3467_ = (_e2820 | (_e2813 << bitcast<u32>(((32u - _e2797) & 31u))));
        } else {
            phi_3467_ = _e2820;
        }
        let _e2828 = phi_3467_;
        if ((_e2828 & 2u) == 0u) {
            phi_3475_ = (_e2828 & 1u);
        } else {
            phi_3475_ = (_e2828 & 7u);
        }
        let _e2834 = phi_3475_;
        if ((_e2834 & 1u) != 0u) {
            phi_3483_ = (2u | 1u);
        } else {
            phi_3483_ = 2u;
        }
        let _e2840 = phi_3483_;
        if (_e2803 < 0.5f) {
            phi_3488_ = (_e2840 | 4u);
        } else {
            phi_3488_ = _e2840;
        }
        let _e2843 = phi_3488_;
        let _e2845 = ((_e115 * _e2799) + _e2796);
        if (_e2845 < _e90) {
        } else {
            return;
        }
        let _e2849 = bits.member[(0u + _e2845)];
        if (_e2845 < _e90) {
        } else {
            return;
        }
        bits.member[(0u + _e2845)] = ((_e2849 & ~((7u << bitcast<u32>((_e2797 & 31u))))) | (_e2843 << bitcast<u32>((_e2797 & 31u))));
        if (_e2797 > 29u) {
            let _e2863 = (_e2845 + 1u);
            if (_e2863 < _e90) {
            } else {
                return;
            }
            let _e2867 = bits.member[(0u + _e2863)];
            let _e2868 = (32u - _e2797);
            let _e2878 = (_e2845 + 1u);
            if (_e2878 < _e90) {
            } else {
                return;
            }
            bits.member[(0u + _e2878)] = ((_e2867 & ~((7u >> bitcast<u32>((_e2868 & 31u))))) | (_e2843 >> bitcast<u32>((_e2868 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
