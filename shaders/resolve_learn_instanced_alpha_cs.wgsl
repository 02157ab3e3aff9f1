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
    var phi_709_: f32;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_748_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_768_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_795_: bool;
    var phi_865_: f32;
    var phi_872_: f32;
    var phi_879_: f32;
    var phi_886_: f32;
    var phi_893_: f32;
    var phi_900_: f32;
    var phi_917_: f32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_937_: f32;
    var phi_956_: u32;
    var phi_961_: u32;
    var phi_966_: u32;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1112_: u32;
    var phi_1114_: u32;
    var phi_1117_: bool;
    var phi_1197_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1224_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1251_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1257_: u32;
    var phi_1260_: u32;
    var phi_1274_: u32;
    var phi_1284_: u32;
    var phi_1294_: u32;
    var phi_1312_: u32;
    var phi_1322_: u32;
    var phi_1332_: u32;
    var phi_1368_: u32;
    var phi_1381_: u32;
    var phi_1386_: u32;
    var phi_1387_: u32;
    var phi_1388_: u32;
    var phi_1258_: u32;
    var phi_1261_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1446_: u32;
    var phi_1449_: bool;
    var phi_1498_: f32;
    var phi_1503_: f32;
    var phi_1508_: f32;
    var phi_1516_: f32;
    var phi_1521_: f32;
    var phi_1526_: f32;
    var phi_1646_: bool;
    var phi_1647_: bool;
    var phi_1648_: bool;
    var phi_1649_: bool;
    var phi_1653_: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1673_: bool;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1700_: bool;
    var phi_1770_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1791_: f32;
    var phi_1798_: f32;
    var phi_1805_: f32;
    var phi_1822_: f32;
    var phi_1827_: f32;
    var phi_1832_: f32;
    var phi_1837_: f32;
    var phi_1842_: f32;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1877_: u32;
    var phi_1878_: u32;
    var phi_1889_: vec3<f32>;
    var phi_1890_: vec3<f32>;
    var phi_1903_: u32;
    var phi_1908_: u32;
    var phi_1913_: u32;
    var phi_2027_: bool;
    var phi_2028_: bool;
    var phi_2059_: u32;
    var phi_2061_: u32;
    var phi_2064_: bool;
    var phi_2144_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2171_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2198_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2204_: u32;
    var phi_2207_: u32;
    var phi_2221_: u32;
    var phi_2231_: u32;
    var phi_2241_: u32;
    var phi_2259_: u32;
    var phi_2269_: u32;
    var phi_2279_: u32;
    var phi_2315_: u32;
    var phi_2328_: u32;
    var phi_2333_: u32;
    var phi_2334_: u32;
    var phi_2335_: u32;
    var phi_2205_: u32;
    var phi_2208_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2393_: u32;
    var phi_2396_: bool;
    var phi_2440_: vec3<f32>;
    var phi_2441_: vec3<f32>;
    var phi_2470_: vec3<f32>;
    var phi_2471_: vec3<f32>;
    var phi_2500_: vec3<f32>;
    var phi_2501_: vec3<f32>;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2524_: f32;
    var phi_2525_: f32;
    var phi_2526_: f32;
    var phi_2527_: f32;
    var phi_2535_: f32;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2550_: f32;
    var phi_2551_: f32;
    var phi_2552_: f32;
    var phi_2553_: f32;
    var phi_2561_: f32;
    var phi_2571_: bool;
    var phi_2572_: bool;
    var phi_2576_: f32;
    var phi_2577_: f32;
    var phi_2578_: f32;
    var phi_2579_: f32;
    var phi_2587_: f32;
    var phi_2602_: f32;
    var phi_2603_: bool;
    var phi_2604_: f32;
    var phi_2605_: bool;
    var phi_2606_: f32;
    var phi_2607_: bool;
    var phi_2625_: f32;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2628_: f32;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2634_: bool;
    var phi_2635_: f32;
    var phi_2636_: bool;
    var phi_2664_: vec3<f32>;
    var phi_2665_: vec3<f32>;
    var phi_2690_: vec3<f32>;
    var phi_2691_: vec3<f32>;
    var phi_2716_: vec3<f32>;
    var phi_2717_: vec3<f32>;
    var phi_2773_: f32;
    var phi_2782_: f32;
    var phi_2791_: f32;
    var phi_2800_: f32;
    var phi_2807_: f32;
    var phi_2814_: f32;
    var phi_2827_: f32;
    var phi_2836_: f32;
    var phi_2845_: f32;
    var phi_2854_: f32;
    var phi_2861_: f32;
    var phi_2868_: f32;
    var phi_2885_: f32;
    var phi_2890_: f32;
    var phi_2895_: f32;
    var phi_2903_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2925_: f32;
    var phi_2930_: f32;
    var phi_2935_: f32;
    var phi_2940_: f32;
    var phi_2945_: lt_bvh_triangle_Intersection;
    var phi_2946_: bool;
    var phi_2947_: lt_bvh_triangle_Intersection;
    var phi_2948_: bool;
    var phi_2952_: lt_bvh_triangle_Intersection;
    var phi_2953_: bool;
    var phi_2954_: lt_bvh_triangle_Intersection;
    var phi_2955_: bool;
    var phi_2956_: bool;
    var phi_2960_: bool;
    var phi_2964_: lt_bvh_triangle_Intersection;
    var phi_3178_: f32;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3187_: bool;
    var phi_3188_: bool;
    var phi_3189_: bool;
    var phi_3190_: bool;
    var phi_3191_: bool;
    var phi_3192_: bool;
    var phi_3193_: bool;
    var phi_3194_: bool;
    var phi_3195_: bool;
    var phi_3196_: bool;
    var phi_2394_: u32;
    var phi_2397_: bool;
    var phi_3200_: bool;
    var phi_3201_: bool;
    var local_9: bool;
    var phi_3243_: bool;
    var phi_3244_: bool;
    var phi_3275_: u32;
    var phi_3276_: u32;
    var phi_2062_: u32;
    var phi_2065_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var local_10: bool;
    var phi_3283_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3294_: bool;
    var phi_3298_: bool;
    var phi_3299_: bool;
    var phi_3300_: bool;
    var phi_3301_: bool;
    var phi_3302_: bool;
    var phi_3303_: bool;
    var phi_3304_: bool;
    var phi_1447_: u32;
    var phi_1450_: bool;
    var phi_3308_: bool;
    var local_11: bool;
    var phi_3350_: bool;
    var phi_3351_: bool;
    var phi_3382_: u32;
    var phi_3383_: u32;
    var phi_1115_: u32;
    var phi_1118_: bool;
    var phi_3384_: bool;
    var phi_3385_: bool;
    var local_12: bool;
    var phi_3389_: bool;
    var phi_3393_: bool;
    var phi_3394_: bool;
    var phi_3395_: bool;
    var phi_3399_: bool;
    var phi_3400_: bool;
    var phi_3404_: bool;
    var phi_3408_: f32;
    var phi_3449_: u32;
    var phi_3468_: u32;
    var phi_3476_: u32;
    var phi_3484_: u32;
    var phi_3489_: u32;
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
        let _e116 = (_e115 & 2147483647u);
        let _e118 = p.member.root;
        if (_e116 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e124 = samples.member[(0u + _e116)].position;
        let _e126 = samples.member[(0u + _e116)].normal;
        let _e128 = samples.member[(0u + _e116)].magnitude;
        let _e130 = ((8f / 8388608f) * _e128);
        let _e138 = (_e124.x + (_e126.x * _e130));
        let _e140 = (_e124.y + (_e126.y * _e130));
        let _e142 = (_e124.z + (_e126.z * _e130));
        let _e144 = p.member.light.place;
        if (_e144.w == 0f) {
            phi_709_ = 300000000000000000000000000000000000000f;
        } else {
            phi_709_ = 1f;
        }
        let _e148 = phi_709_;
        let _e156 = (_e144.x - (_e138 * _e144.w));
        let _e157 = (_e144.y - (_e140 * _e144.w));
        let _e158 = (_e144.z - (_e142 * _e144.w));
        let _e159 = abs(_e156);
        let _e160 = abs(_e157);
        let _e161 = abs(_e158);
        if (abs(_e138) < 1000000000000000f) {
            if (abs(_e140) < 1000000000000000f) {
                phi_741_ = (abs(_e142) < 1000000000000000f);
                phi_742_ = false;
            } else {
                phi_741_ = bool();
                phi_742_ = true;
            }
            let _e169 = phi_741_;
            let _e171 = phi_742_;
            phi_743_ = _e169;
            phi_744_ = _e171;
        } else {
            phi_743_ = bool();
            phi_744_ = true;
        }
        let _e173 = phi_743_;
        let _e175 = phi_744_;
        if _e175 {
            phi_748_ = false;
        } else {
            phi_748_ = _e173;
        }
        let _e177 = phi_748_;
        if _e177 {
            if (_e159 < 1000000000000000f) {
                if (_e160 < 1000000000000000f) {
                    phi_761_ = (_e161 < 1000000000000000f);
                    phi_762_ = false;
                } else {
                    phi_761_ = bool();
                    phi_762_ = true;
                }
                let _e182 = phi_761_;
                let _e184 = phi_762_;
                phi_763_ = _e182;
                phi_764_ = _e184;
            } else {
                phi_763_ = bool();
                phi_764_ = true;
            }
            let _e186 = phi_763_;
            let _e188 = phi_764_;
            if _e188 {
                phi_768_ = false;
            } else {
                phi_768_ = _e186;
            }
            let _e190 = phi_768_;
            if _e190 {
                if (_e159 > 0f) {
                    phi_782_ = bool();
                    phi_783_ = true;
                } else {
                    let _e192 = (_e160 > 0f);
                    if _e192 {
                        phi_781_ = bool();
                    } else {
                        phi_781_ = (_e161 > 0f);
                    }
                    let _e195 = phi_781_;
                    phi_782_ = _e195;
                    phi_783_ = _e192;
                }
                let _e197 = phi_782_;
                let _e199 = phi_783_;
                if _e199 {
                    phi_787_ = true;
                } else {
                    phi_787_ = _e197;
                }
                let _e201 = phi_787_;
                phi_788_ = _e201;
                phi_789_ = false;
            } else {
                phi_788_ = bool();
                phi_789_ = true;
            }
            let _e203 = phi_788_;
            let _e205 = phi_789_;
            phi_790_ = _e203;
            phi_791_ = _e205;
        } else {
            phi_790_ = bool();
            phi_791_ = true;
        }
        let _e207 = phi_790_;
        let _e209 = phi_791_;
        if _e209 {
            phi_795_ = false;
        } else {
            phi_795_ = _e207;
        }
        let _e211 = phi_795_;
        if _e211 {
            let _e212 = (_e118 >= _e78);
            if _e212 {
                phi_3393_ = false;
            } else {
                if (_e118 < _e78) {
                } else {
                    return;
                }
                let _e218 = nodes.member[(0u + _e118)].frame[0u];
                let _e222 = nodes.member[(0u + _e118)].frame[1u];
                let _e226 = nodes.member[(0u + _e118)].frame[2u];
                let _e230 = nodes.member[(0u + _e118)].frame[0u];
                let _e234 = nodes.member[(0u + _e118)].frame[1u];
                let _e238 = nodes.member[(0u + _e118)].frame[2u];
                let _e242 = nodes.member[(0u + _e118)].frame[3u];
                let _e276 = core_intrinsics_maximum_number_nsz_f32_(abs(_e156), abs(_e157));
                let _e277 = core_intrinsics_maximum_number_nsz_f32_(_e276, abs(_e158));
                let _e278 = (_e277 * 0.0000000000009094947f);
                if (abs(_e156) < _e278) {
                    phi_865_ = _e278;
                } else {
                    phi_865_ = abs(_e156);
                }
                let _e283 = phi_865_;
                if (_e156 < 0f) {
                    phi_872_ = (-1f / _e283);
                } else {
                    phi_872_ = (1f / _e283);
                }
                let _e288 = phi_872_;
                if (abs(_e157) < _e278) {
                    phi_879_ = _e278;
                } else {
                    phi_879_ = abs(_e157);
                }
                let _e293 = phi_879_;
                if (_e157 < 0f) {
                    phi_886_ = (-1f / _e293);
                } else {
                    phi_886_ = (1f / _e293);
                }
                let _e298 = phi_886_;
                if (abs(_e158) < _e278) {
                    phi_893_ = _e278;
                } else {
                    phi_893_ = abs(_e158);
                }
                let _e303 = phi_893_;
                if (_e158 < 0f) {
                    phi_900_ = (-1f / _e303);
                } else {
                    phi_900_ = (1f / _e303);
                }
                let _e308 = phi_900_;
                let _e312 = abs((bitcast<f32>(_e218) - _e138));
                let _e313 = abs((bitcast<f32>(_e222) - _e140));
                let _e314 = abs((bitcast<f32>(_e226) - _e142));
                let _e318 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138));
                let _e319 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e140));
                let _e320 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e142));
                if (_e312 > _e318) {
                    phi_917_ = _e312;
                } else {
                    phi_917_ = _e318;
                }
                let _e323 = phi_917_;
                if (_e313 > _e319) {
                    phi_922_ = _e313;
                } else {
                    phi_922_ = _e319;
                }
                let _e326 = phi_922_;
                if (_e314 > _e320) {
                    phi_927_ = _e314;
                } else {
                    phi_927_ = _e320;
                }
                let _e329 = phi_927_;
                if (_e323 > _e326) {
                    phi_932_ = _e323;
                } else {
                    phi_932_ = _e326;
                }
                let _e332 = phi_932_;
                if (_e332 > _e329) {
                    phi_937_ = _e332;
                } else {
                    phi_937_ = _e329;
                }
                let _e335 = phi_937_;
                let _e339 = (_e335 * 0.0000019073486f);
                let _e340 = (abs(_e288) * _e339);
                let _e341 = (abs(_e298) * _e339);
                let _e342 = (abs(_e308) * _e339);
                let _e346 = (_e335 * 0.0000009536743f);
                let _e347 = (abs(_e288) * _e346);
                let _e348 = (abs(_e298) * _e346);
                let _e349 = (abs(_e308) * _e346);
                if (_e288 < 0f) {
                    phi_956_ = 0u;
                } else {
                    phi_956_ = 1u;
                }
                let _e352 = phi_956_;
                if (_e298 < 0f) {
                    phi_961_ = 0u;
                } else {
                    phi_961_ = 2u;
                }
                let _e355 = phi_961_;
                if (_e308 < 0f) {
                    phi_966_ = 0u;
                } else {
                    phi_966_ = 4u;
                }
                let _e358 = phi_966_;
                let _e360 = ((_e352 | _e355) | _e358);
                let _e361 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e118, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e361.first[0], _e361.first[1], _e361.first[2], _e361.first[3], _e361.first[4], _e361.first[5], _e361.first[6], _e361.first[7], _e361.first[8], _e361.first[9], _e361.first[10], _e361.first[11], _e361.first[12], _e361.first[13], _e361.first[14], _e361.first[15], _e361.first[16], _e361.first[17], _e361.first[18], _e361.first[19], _e361.first[20], _e361.first[21], _e361.first[22], _e361.first[23], _e361.first[24], _e361.first[25], _e361.first[26], _e361.first[27], _e361.first[28], _e361.first[29], _e361.first[30], _e361.first[31]), array<u32, 32>(_e361.mask[0], _e361.mask[1], _e361.mask[2], _e361.mask[3], _e361.mask[4], _e361.mask[5], _e361.mask[6], _e361.mask[7], _e361.mask[8], _e361.mask[9], _e361.mask[10], _e361.mask[11], _e361.mask[12], _e361.mask[13], _e361.mask[14], _e361.mask[15], _e361.mask[16], _e361.mask[17], _e361.mask[18], _e361.mask[19], _e361.mask[20], _e361.mask[21], _e361.mask[22], _e361.mask[23], _e361.mask[24], _e361.mask[25], _e361.mask[26], _e361.mask[27], _e361.mask[28], _e361.mask[29], _e361.mask[30], _e361.mask[31]), _e361.len, _e361.group, _e361.group_mask);
                let _e435 = local_2.group_mask;
                if ((_e435 & 4278190080u) == 0u) {
                    let _e439 = local_2.len;
                    if (_e439 == 0u) {
                        phi_1080_ = false;
                    } else {
                        let _e443 = local_2.len;
                        local_2.len = (_e443 - 1u);
                        let _e446 = local_2.len;
                        if (_e446 < 32u) {
                        } else {
                            return;
                        }
                        let _e451 = local_2.first[(0u + _e446)];
                        local_2.group = _e451;
                        let _e454 = local_2.len;
                        if (_e454 < 32u) {
                        } else {
                            return;
                        }
                        let _e459 = local_2.mask[(0u + _e454)];
                        local_2.group_mask = _e459;
                        phi_1080_ = true;
                    }
                    let _e462 = phi_1080_;
                    phi_1081_ = _e462;
                } else {
                    phi_1081_ = true;
                }
                let _e464 = phi_1081_;
                if _e464 {
                    let _e466 = local_2.group_mask;
                    let _e472 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, (_e466 == 0u)));
                    let _e476 = local_2.group_mask;
                    let _e490 = local_2.group_mask;
                    local_2.group_mask = (_e490 & ~((1u << bitcast<u32>((_e472 & 31u)))));
                    let _e493 = local_2.group;
                    phi_1112_ = (_e493 + countOneBits(((_e476 & ~((4294967295u << bitcast<u32>((((_e472 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1112_ = 4294967295u;
                }
                let _e496 = phi_1112_;
                phi_1114_ = _e496;
                phi_1117_ = false;
                loop {
                    let _e498 = phi_1114_;
                    let _e500 = phi_1117_;
                    if (_e498 != 4294967295u) {
                        if (_e498 < _e78) {
                        } else {
                            return;
                        }
                        let _e507 = nodes.member[(0u + _e498)].frame[3u];
                        let _e532 = (bitcast<f32>((((_e507 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e288);
                        let _e533 = (bitcast<f32>((((_e507 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e298);
                        let _e534 = (bitcast<f32>((((_e507 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e537 = nodes.member[(0u + _e498)].frame[0u];
                        let _e541 = nodes.member[(0u + _e498)].frame[1u];
                        let _e545 = nodes.member[(0u + _e498)].frame[2u];
                        let _e550 = ((bitcast<f32>(_e537) - _e138) * _e288);
                        let _e551 = ((bitcast<f32>(_e541) - _e140) * _e298);
                        let _e552 = ((bitcast<f32>(_e545) - _e142) * _e308);
                        let _e560 = nodes.member[(0u + _e498)].x;
                        if (_e288 < 0f) {
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e571.unnamed.root, _e560.w), _e571.unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e560.x, _e577.unnamed_1.first_primitive));
                            phi_1197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_bvh_traverse_Tree(_e583.unnamed_1.root, _e560.y));
                        } else {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.unnamed.root, _e560.y), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e560.z, _e605.unnamed_1.first_primitive));
                            phi_1197_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_bvh_traverse_Tree(_e611.unnamed_1.root, _e560.w));
                        }
                        let _e619 = phi_1197_;
                        let _e629 = nodes.member[(0u + _e498)].y;
                        if (_e298 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.unnamed.root, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e629.x, _e646.unnamed_1.first_primitive));
                            phi_1224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e652.unnamed_1.root, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.unnamed.root, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e629.z, _e674.unnamed_1.first_primitive));
                            phi_1224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e680.unnamed_1.root, _e629.w));
                        }
                        let _e688 = phi_1224_;
                        let _e698 = nodes.member[(0u + _e498)].z;
                        if (_e308 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e698.x, _e715.unnamed_1.first_primitive));
                            phi_1251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.unnamed.root, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e698.z, _e743.unnamed_1.first_primitive));
                            phi_1251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e749.unnamed_1.root, _e698.w));
                        }
                        let _e757 = phi_1251_;
                        phi_1257_ = 0u;
                        phi_1260_ = 0u;
                        loop {
                            let _e767 = phi_1257_;
                            let _e769 = phi_1260_;
                            local_3 = _e769;
                            local_4 = _e769;
                            local_5 = _e769;
                            let _e770 = (_e767 < 8u);
                            if _e770 {
                                let _e772 = (_e767 >> bitcast<u32>(2i));
                                let _e773 = (_e767 & 3u);
                                if (_e772 == 0u) {
                                    phi_1274_ = _e619.unnamed.root;
                                } else {
                                    phi_1274_ = _e619.unnamed.first_primitive;
                                }
                                let _e776 = phi_1274_;
                                if (_e772 == 0u) {
                                    phi_1284_ = _e688.unnamed.root;
                                } else {
                                    phi_1284_ = _e688.unnamed.first_primitive;
                                }
                                let _e785 = phi_1284_;
                                if (_e772 == 0u) {
                                    phi_1294_ = _e757.unnamed.root;
                                } else {
                                    phi_1294_ = _e757.unnamed.first_primitive;
                                }
                                let _e794 = phi_1294_;
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e776 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e340)), ((f32(((_e785 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e341)));
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(_e807, ((f32(((_e794 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e342)));
                                if (_e772 == 0u) {
                                    phi_1312_ = _e619.unnamed_1.root;
                                } else {
                                    phi_1312_ = _e619.unnamed_1.first_primitive;
                                }
                                let _e811 = phi_1312_;
                                if (_e772 == 0u) {
                                    phi_1322_ = _e688.unnamed_1.root;
                                } else {
                                    phi_1322_ = _e688.unnamed_1.first_primitive;
                                }
                                let _e820 = phi_1322_;
                                if (_e772 == 0u) {
                                    phi_1332_ = _e757.unnamed_1.root;
                                } else {
                                    phi_1332_ = _e757.unnamed_1.first_primitive;
                                }
                                let _e829 = phi_1332_;
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e811 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e340)), ((f32(((_e820 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e341)));
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(_e842, ((f32(((_e829 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e342)));
                                if (_e808 <= _e843) {
                                    if (_e808 <= _e148) {
                                        if (_e843 >= 0f) {
                                            if (_e772 == 0u) {
                                                let _e850 = nodes.member[(0u + _e498)].links[2u];
                                                phi_1368_ = _e850;
                                            } else {
                                                let _e853 = nodes.member[(0u + _e498)].links[3u];
                                                phi_1368_ = _e853;
                                            }
                                            let _e855 = phi_1368_;
                                            let _e860 = ((_e855 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u);
                                            let _e861 = (_e860 & 31u);
                                            if (_e861 >= 24u) {
                                                phi_1381_ = (24u + ((_e861 - 24u) ^ _e360));
                                            } else {
                                                phi_1381_ = _e861;
                                            }
                                            let _e867 = phi_1381_;
                                            phi_1386_ = (_e769 | ((_e860 >> bitcast<u32>(5i)) << bitcast<u32>((_e867 & 31u))));
                                        } else {
                                            phi_1386_ = _e769;
                                        }
                                        let _e875 = phi_1386_;
                                        phi_1387_ = _e875;
                                    } else {
                                        phi_1387_ = _e769;
                                    }
                                    let _e877 = phi_1387_;
                                    phi_1388_ = _e877;
                                } else {
                                    phi_1388_ = _e769;
                                }
                                let _e879 = phi_1388_;
                                phi_1258_ = (_e767 + 1u);
                                phi_1261_ = _e879;
                            } else {
                                phi_1258_ = u32();
                                phi_1261_ = u32();
                            }
                            let _e882 = phi_1258_;
                            let _e884 = phi_1261_;
                            continue;
                            continuing {
                                phi_1257_ = _e882;
                                phi_1260_ = _e884;
                                break if !(_e770);
                            }
                        }
                        let _e888 = nodes.member[(0u + _e498)].links[0u];
                        let _e892 = nodes.member[(0u + _e498)].frame[3u];
                        let _e896 = local_3;
                        if ((_e896 & 4278190080u) == 0u) {
                        } else {
                            let _e900 = local_2.group_mask;
                            if ((_e900 & 4278190080u) == 0u) {
                            } else {
                                let _e904 = local_2.len;
                                if (_e904 < 32u) {
                                    let _e907 = local_2.group;
                                    let _e909 = local_2.len;
                                    if (_e909 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e909)] = _e907;
                                    let _e915 = local_2.group_mask;
                                    let _e917 = local_2.len;
                                    if (_e917 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e917)] = _e915;
                                    let _e924 = local_2.len;
                                    local_2.len = (_e924 + 1u);
                                }
                            }
                            local_2.group = (_e118 + _e888);
                            let _e928 = local_4;
                            local_2.group_mask = ((_e928 & 4278190080u) | (_e892 >> bitcast<u32>(24i)));
                        }
                        let _e933 = local_5;
                        phi_1446_ = (_e933 & 16777215u);
                        phi_1449_ = _e500;
                        loop {
                            let _e936 = phi_1446_;
                            let _e938 = phi_1449_;
                            local_18 = _e938;
                            let _e939 = (_e936 == 0u);
                            local_11 = _e939;
                            local_19 = _e939;
                            if _e939 {
                                phi_1447_ = u32();
                                phi_1450_ = bool();
                                phi_3308_ = false;
                            } else {
                                let _e942 = nodes.member[(0u + _e498)].links[1u];
                                let _e946 = (_e942 + select(firstTrailingBit(_e936), 32u, (_e936 == 0u)));
                                if (_e946 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e953 = instances.member[(0u + _e946)].low_world;
                                let _e955 = instances.member[(0u + _e946)].high_world;
                                let _e962 = ((_e953.x - _e138) * _e288);
                                let _e963 = ((_e953.y - _e140) * _e298);
                                let _e964 = ((_e953.z - _e142) * _e308);
                                let _e971 = ((_e955.x - _e138) * _e288);
                                let _e972 = ((_e955.y - _e140) * _e298);
                                let _e973 = ((_e955.z - _e142) * _e308);
                                if (_e962 < _e971) {
                                    phi_1498_ = _e962;
                                } else {
                                    phi_1498_ = _e971;
                                }
                                let _e976 = phi_1498_;
                                if (_e963 < _e972) {
                                    phi_1503_ = _e963;
                                } else {
                                    phi_1503_ = _e972;
                                }
                                let _e979 = phi_1503_;
                                if (_e964 < _e973) {
                                    phi_1508_ = _e964;
                                } else {
                                    phi_1508_ = _e973;
                                }
                                let _e982 = phi_1508_;
                                if (_e962 > _e971) {
                                    phi_1516_ = _e962;
                                } else {
                                    phi_1516_ = _e971;
                                }
                                let _e988 = phi_1516_;
                                if (_e963 > _e972) {
                                    phi_1521_ = _e963;
                                } else {
                                    phi_1521_ = _e972;
                                }
                                let _e991 = phi_1521_;
                                if (_e964 > _e973) {
                                    phi_1526_ = _e964;
                                } else {
                                    phi_1526_ = _e973;
                                }
                                let _e994 = phi_1526_;
                                let _e998 = core_intrinsics_maximum_number_nsz_f32_((_e976 - _e347), (_e979 - _e348));
                                let _e999 = core_intrinsics_maximum_number_nsz_f32_(_e998, (_e982 - _e349));
                                let _e1000 = core_intrinsics_minimum_number_nsz_f32_((_e988 + _e347), (_e991 + _e348));
                                let _e1001 = core_intrinsics_minimum_number_nsz_f32_(_e1000, (_e994 + _e349));
                                if (_e999 <= _e1001) {
                                    if (_e999 <= _e148) {
                                        if (_e1001 >= 0f) {
                                            let _e1007 = instances.member[(0u + _e946)].world_to_object[0u];
                                            let _e1018 = ((((_e1007.x * _e138) + (_e1007.y * _e140)) + (_e1007.z * _e142)) + (_e1007.w * 1f));
                                            let _e1020 = instances.member[(0u + _e946)].world_to_object[1u];
                                            let _e1031 = ((((_e1020.x * _e138) + (_e1020.y * _e140)) + (_e1020.z * _e142)) + (_e1020.w * 1f));
                                            let _e1033 = instances.member[(0u + _e946)].world_to_object[2u];
                                            let _e1044 = ((((_e1033.x * _e138) + (_e1033.y * _e140)) + (_e1033.z * _e142)) + (_e1033.w * 1f));
                                            let _e1047 = instances.member[(0u + _e946)].world_to_object[0u];
                                            let _e1058 = ((((_e1047.x * _e156) + (_e1047.y * _e157)) + (_e1047.z * _e158)) + (_e1047.w * 0f));
                                            let _e1060 = instances.member[(0u + _e946)].world_to_object[1u];
                                            let _e1071 = ((((_e1060.x * _e156) + (_e1060.y * _e157)) + (_e1060.z * _e158)) + (_e1060.w * 0f));
                                            let _e1073 = instances.member[(0u + _e946)].world_to_object[2u];
                                            let _e1084 = ((((_e1073.x * _e156) + (_e1073.y * _e157)) + (_e1073.z * _e158)) + (_e1073.w * 0f));
                                            let _e1087 = instances.member[(0u + _e946)].root;
                                            let _e1089 = instances.member[(0u + _e946)].first_triangle;
                                            let _e1090 = abs(_e1058);
                                            let _e1091 = abs(_e1071);
                                            let _e1092 = abs(_e1084);
                                            if (abs(_e1018) < 1000000000000000f) {
                                                if (abs(_e1031) < 1000000000000000f) {
                                                    phi_1646_ = (abs(_e1044) < 1000000000000000f);
                                                    phi_1647_ = false;
                                                } else {
                                                    phi_1646_ = bool();
                                                    phi_1647_ = true;
                                                }
                                                let _e1100 = phi_1646_;
                                                let _e1102 = phi_1647_;
                                                phi_1648_ = _e1100;
                                                phi_1649_ = _e1102;
                                            } else {
                                                phi_1648_ = bool();
                                                phi_1649_ = true;
                                            }
                                            let _e1104 = phi_1648_;
                                            let _e1106 = phi_1649_;
                                            if _e1106 {
                                                phi_1653_ = false;
                                            } else {
                                                phi_1653_ = _e1104;
                                            }
                                            let _e1108 = phi_1653_;
                                            if _e1108 {
                                                if (_e1090 < 1000000000000000f) {
                                                    if (_e1091 < 1000000000000000f) {
                                                        phi_1666_ = (_e1092 < 1000000000000000f);
                                                        phi_1667_ = false;
                                                    } else {
                                                        phi_1666_ = bool();
                                                        phi_1667_ = true;
                                                    }
                                                    let _e1113 = phi_1666_;
                                                    let _e1115 = phi_1667_;
                                                    phi_1668_ = _e1113;
                                                    phi_1669_ = _e1115;
                                                } else {
                                                    phi_1668_ = bool();
                                                    phi_1669_ = true;
                                                }
                                                let _e1117 = phi_1668_;
                                                let _e1119 = phi_1669_;
                                                if _e1119 {
                                                    phi_1673_ = false;
                                                } else {
                                                    phi_1673_ = _e1117;
                                                }
                                                let _e1121 = phi_1673_;
                                                if _e1121 {
                                                    if (_e1090 > 0f) {
                                                        phi_1687_ = bool();
                                                        phi_1688_ = true;
                                                    } else {
                                                        let _e1123 = (_e1091 > 0f);
                                                        if _e1123 {
                                                            phi_1686_ = bool();
                                                        } else {
                                                            phi_1686_ = (_e1092 > 0f);
                                                        }
                                                        let _e1126 = phi_1686_;
                                                        phi_1687_ = _e1126;
                                                        phi_1688_ = _e1123;
                                                    }
                                                    let _e1128 = phi_1687_;
                                                    let _e1130 = phi_1688_;
                                                    if _e1130 {
                                                        phi_1692_ = true;
                                                    } else {
                                                        phi_1692_ = _e1128;
                                                    }
                                                    let _e1132 = phi_1692_;
                                                    phi_1693_ = _e1132;
                                                    phi_1694_ = false;
                                                } else {
                                                    phi_1693_ = bool();
                                                    phi_1694_ = true;
                                                }
                                                let _e1134 = phi_1693_;
                                                let _e1136 = phi_1694_;
                                                phi_1695_ = _e1134;
                                                phi_1696_ = _e1136;
                                            } else {
                                                phi_1695_ = bool();
                                                phi_1696_ = true;
                                            }
                                            let _e1138 = phi_1695_;
                                            let _e1140 = phi_1696_;
                                            if _e1140 {
                                                phi_1700_ = false;
                                            } else {
                                                phi_1700_ = _e1138;
                                            }
                                            let _e1142 = phi_1700_;
                                            if _e1142 {
                                                let _e1143 = (_e1087 >= _e78);
                                                if _e1143 {
                                                    phi_3288_ = bool();
                                                } else {
                                                    if (_e1087 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1149 = nodes.member[(0u + _e1087)].frame[0u];
                                                    let _e1153 = nodes.member[(0u + _e1087)].frame[1u];
                                                    let _e1157 = nodes.member[(0u + _e1087)].frame[2u];
                                                    let _e1161 = nodes.member[(0u + _e1087)].frame[0u];
                                                    let _e1165 = nodes.member[(0u + _e1087)].frame[1u];
                                                    let _e1169 = nodes.member[(0u + _e1087)].frame[2u];
                                                    let _e1173 = nodes.member[(0u + _e1087)].frame[3u];
                                                    let _e1207 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1058), abs(_e1071));
                                                    let _e1208 = core_intrinsics_maximum_number_nsz_f32_(_e1207, abs(_e1084));
                                                    let _e1209 = (_e1208 * 0.0000000000009094947f);
                                                    if (abs(_e1058) < _e1209) {
                                                        phi_1770_ = _e1209;
                                                    } else {
                                                        phi_1770_ = abs(_e1058);
                                                    }
                                                    let _e1214 = phi_1770_;
                                                    if (_e1058 < 0f) {
                                                        phi_1777_ = (-1f / _e1214);
                                                    } else {
                                                        phi_1777_ = (1f / _e1214);
                                                    }
                                                    let _e1219 = phi_1777_;
                                                    if (abs(_e1071) < _e1209) {
                                                        phi_1784_ = _e1209;
                                                    } else {
                                                        phi_1784_ = abs(_e1071);
                                                    }
                                                    let _e1224 = phi_1784_;
                                                    if (_e1071 < 0f) {
                                                        phi_1791_ = (-1f / _e1224);
                                                    } else {
                                                        phi_1791_ = (1f / _e1224);
                                                    }
                                                    let _e1229 = phi_1791_;
                                                    if (abs(_e1084) < _e1209) {
                                                        phi_1798_ = _e1209;
                                                    } else {
                                                        phi_1798_ = abs(_e1084);
                                                    }
                                                    let _e1234 = phi_1798_;
                                                    if (_e1084 < 0f) {
                                                        phi_1805_ = (-1f / _e1234);
                                                    } else {
                                                        phi_1805_ = (1f / _e1234);
                                                    }
                                                    let _e1239 = phi_1805_;
                                                    let _e1243 = abs((bitcast<f32>(_e1149) - _e1018));
                                                    let _e1244 = abs((bitcast<f32>(_e1153) - _e1031));
                                                    let _e1245 = abs((bitcast<f32>(_e1157) - _e1044));
                                                    let _e1249 = abs(((bitcast<f32>(_e1161) + (bitcast<f32>((((_e1173 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1018));
                                                    let _e1250 = abs(((bitcast<f32>(_e1165) + (bitcast<f32>((((_e1173 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1031));
                                                    let _e1251 = abs(((bitcast<f32>(_e1169) + (bitcast<f32>((((_e1173 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1044));
                                                    if (_e1243 > _e1249) {
                                                        phi_1822_ = _e1243;
                                                    } else {
                                                        phi_1822_ = _e1249;
                                                    }
                                                    let _e1254 = phi_1822_;
                                                    if (_e1244 > _e1250) {
                                                        phi_1827_ = _e1244;
                                                    } else {
                                                        phi_1827_ = _e1250;
                                                    }
                                                    let _e1257 = phi_1827_;
                                                    if (_e1245 > _e1251) {
                                                        phi_1832_ = _e1245;
                                                    } else {
                                                        phi_1832_ = _e1251;
                                                    }
                                                    let _e1260 = phi_1832_;
                                                    if (_e1254 > _e1257) {
                                                        phi_1837_ = _e1254;
                                                    } else {
                                                        phi_1837_ = _e1257;
                                                    }
                                                    let _e1263 = phi_1837_;
                                                    if (_e1263 > _e1260) {
                                                        phi_1842_ = _e1263;
                                                    } else {
                                                        phi_1842_ = _e1260;
                                                    }
                                                    let _e1266 = phi_1842_;
                                                    let _e1270 = (_e1266 * 0.0000019073486f);
                                                    let _e1271 = (abs(_e1219) * _e1270);
                                                    let _e1272 = (abs(_e1229) * _e1270);
                                                    let _e1273 = (abs(_e1239) * _e1270);
                                                    let _e1277 = (_e1266 * 0.0000009536743f);
                                                    let _e1278 = (abs(_e1219) * _e1277);
                                                    let _e1279 = (abs(_e1229) * _e1277);
                                                    let _e1280 = (abs(_e1239) * _e1277);
                                                    let _e1281 = abs(_e1058);
                                                    let _e1282 = abs(_e1071);
                                                    let _e1283 = abs(_e1084);
                                                    if (_e1281 >= _e1282) {
                                                        if (_e1281 >= _e1283) {
                                                            phi_1868_ = false;
                                                        } else {
                                                            phi_1868_ = true;
                                                        }
                                                        let _e1287 = phi_1868_;
                                                        phi_1869_ = _e1287;
                                                    } else {
                                                        phi_1869_ = true;
                                                    }
                                                    let _e1289 = phi_1869_;
                                                    if _e1289 {
                                                        if (_e1282 >= _e1283) {
                                                            phi_1877_ = 1u;
                                                        } else {
                                                            phi_1877_ = 2u;
                                                        }
                                                        let _e1292 = phi_1877_;
                                                        phi_1878_ = _e1292;
                                                    } else {
                                                        phi_1878_ = 0u;
                                                    }
                                                    let _e1294 = phi_1878_;
                                                    if (_e1294 == 0u) {
                                                        phi_1890_ = vec3<f32>(_e1071, _e1084, _e1058);
                                                    } else {
                                                        if (_e1294 == 1u) {
                                                            phi_1889_ = vec3<f32>(_e1084, _e1058, _e1071);
                                                        } else {
                                                            phi_1889_ = vec3<f32>(_e1058, _e1071, _e1084);
                                                        }
                                                        let _e1300 = phi_1889_;
                                                        phi_1890_ = _e1300;
                                                    }
                                                    let _e1302 = phi_1890_;
                                                    let _e1305 = (_e1302.x / _e1302.z);
                                                    let _e1308 = (_e1302.y / _e1302.z);
                                                    if (_e1219 < 0f) {
                                                        phi_1903_ = 0u;
                                                    } else {
                                                        phi_1903_ = 1u;
                                                    }
                                                    let _e1313 = phi_1903_;
                                                    if (_e1229 < 0f) {
                                                        phi_1908_ = 0u;
                                                    } else {
                                                        phi_1908_ = 2u;
                                                    }
                                                    let _e1316 = phi_1908_;
                                                    if (_e1239 < 0f) {
                                                        phi_1913_ = 0u;
                                                    } else {
                                                        phi_1913_ = 4u;
                                                    }
                                                    let _e1319 = phi_1913_;
                                                    let _e1321 = ((_e1313 | _e1316) | _e1319);
                                                    let _e1322 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1087, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1322.first[0], _e1322.first[1], _e1322.first[2], _e1322.first[3], _e1322.first[4], _e1322.first[5], _e1322.first[6], _e1322.first[7], _e1322.first[8], _e1322.first[9], _e1322.first[10], _e1322.first[11], _e1322.first[12], _e1322.first[13], _e1322.first[14], _e1322.first[15], _e1322.first[16], _e1322.first[17], _e1322.first[18], _e1322.first[19], _e1322.first[20], _e1322.first[21], _e1322.first[22], _e1322.first[23], _e1322.first[24], _e1322.first[25], _e1322.first[26], _e1322.first[27], _e1322.first[28], _e1322.first[29], _e1322.first[30], _e1322.first[31]), array<u32, 32>(_e1322.mask[0], _e1322.mask[1], _e1322.mask[2], _e1322.mask[3], _e1322.mask[4], _e1322.mask[5], _e1322.mask[6], _e1322.mask[7], _e1322.mask[8], _e1322.mask[9], _e1322.mask[10], _e1322.mask[11], _e1322.mask[12], _e1322.mask[13], _e1322.mask[14], _e1322.mask[15], _e1322.mask[16], _e1322.mask[17], _e1322.mask[18], _e1322.mask[19], _e1322.mask[20], _e1322.mask[21], _e1322.mask[22], _e1322.mask[23], _e1322.mask[24], _e1322.mask[25], _e1322.mask[26], _e1322.mask[27], _e1322.mask[28], _e1322.mask[29], _e1322.mask[30], _e1322.mask[31]), _e1322.len, _e1322.group, _e1322.group_mask);
                                                    let _e1396 = local_1.group_mask;
                                                    if ((_e1396 & 4278190080u) == 0u) {
                                                        let _e1400 = local_1.len;
                                                        if (_e1400 == 0u) {
                                                            phi_2027_ = false;
                                                        } else {
                                                            let _e1404 = local_1.len;
                                                            local_1.len = (_e1404 - 1u);
                                                            let _e1407 = local_1.len;
                                                            if (_e1407 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1412 = local_1.first[(0u + _e1407)];
                                                            local_1.group = _e1412;
                                                            let _e1415 = local_1.len;
                                                            if (_e1415 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1420 = local_1.mask[(0u + _e1415)];
                                                            local_1.group_mask = _e1420;
                                                            phi_2027_ = true;
                                                        }
                                                        let _e1423 = phi_2027_;
                                                        phi_2028_ = _e1423;
                                                    } else {
                                                        phi_2028_ = true;
                                                    }
                                                    let _e1425 = phi_2028_;
                                                    if _e1425 {
                                                        let _e1427 = local_1.group_mask;
                                                        let _e1433 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1427)), 32u, (_e1427 == 0u)));
                                                        let _e1437 = local_1.group_mask;
                                                        let _e1451 = local_1.group_mask;
                                                        local_1.group_mask = (_e1451 & ~((1u << bitcast<u32>((_e1433 & 31u)))));
                                                        let _e1454 = local_1.group;
                                                        phi_2059_ = (_e1454 + countOneBits(((_e1437 & ~((4294967295u << bitcast<u32>((((_e1433 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2059_ = 4294967295u;
                                                    }
                                                    let _e1457 = phi_2059_;
                                                    phi_2061_ = _e1457;
                                                    phi_2064_ = _e938;
                                                    loop {
                                                        let _e1459 = phi_2061_;
                                                        let _e1461 = phi_2064_;
                                                        local_17 = _e1461;
                                                        if (_e1459 != 4294967295u) {
                                                            if (_e1459 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1468 = nodes.member[(0u + _e1459)].frame[3u];
                                                            let _e1493 = (bitcast<f32>((((_e1468 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1219);
                                                            let _e1494 = (bitcast<f32>((((_e1468 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1229);
                                                            let _e1495 = (bitcast<f32>((((_e1468 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1239);
                                                            let _e1498 = nodes.member[(0u + _e1459)].frame[0u];
                                                            let _e1502 = nodes.member[(0u + _e1459)].frame[1u];
                                                            let _e1506 = nodes.member[(0u + _e1459)].frame[2u];
                                                            let _e1511 = ((bitcast<f32>(_e1498) - _e1018) * _e1219);
                                                            let _e1512 = ((bitcast<f32>(_e1502) - _e1031) * _e1229);
                                                            let _e1513 = ((bitcast<f32>(_e1506) - _e1044) * _e1239);
                                                            let _e1521 = nodes.member[(0u + _e1459)].x;
                                                            if (_e1219 < 0f) {
                                                                let _e1532 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1521.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1538 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1532.unnamed.root, _e1521.w), _e1532.unnamed_1);
                                                                let _e1544 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1538.unnamed, lt_bvh_traverse_Tree(_e1521.x, _e1538.unnamed_1.first_primitive));
                                                                phi_2144_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1544.unnamed, lt_bvh_traverse_Tree(_e1544.unnamed_1.root, _e1521.y));
                                                            } else {
                                                                let _e1560 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1521.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1560.unnamed.root, _e1521.y), _e1560.unnamed_1);
                                                                let _e1572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1566.unnamed, lt_bvh_traverse_Tree(_e1521.z, _e1566.unnamed_1.first_primitive));
                                                                phi_2144_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1572.unnamed, lt_bvh_traverse_Tree(_e1572.unnamed_1.root, _e1521.w));
                                                            }
                                                            let _e1580 = phi_2144_;
                                                            let _e1590 = nodes.member[(0u + _e1459)].y;
                                                            if (_e1229 < 0f) {
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1590.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1601.unnamed.root, _e1590.w), _e1601.unnamed_1);
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1607.unnamed, lt_bvh_traverse_Tree(_e1590.x, _e1607.unnamed_1.first_primitive));
                                                                phi_2171_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1613.unnamed, lt_bvh_traverse_Tree(_e1613.unnamed_1.root, _e1590.y));
                                                            } else {
                                                                let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1590.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1629.unnamed.root, _e1590.y), _e1629.unnamed_1);
                                                                let _e1641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1635.unnamed, lt_bvh_traverse_Tree(_e1590.z, _e1635.unnamed_1.first_primitive));
                                                                phi_2171_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1641.unnamed, lt_bvh_traverse_Tree(_e1641.unnamed_1.root, _e1590.w));
                                                            }
                                                            let _e1649 = phi_2171_;
                                                            let _e1659 = nodes.member[(0u + _e1459)].z;
                                                            if (_e1239 < 0f) {
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1659.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1670.unnamed.root, _e1659.w), _e1670.unnamed_1);
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1676.unnamed, lt_bvh_traverse_Tree(_e1659.x, _e1676.unnamed_1.first_primitive));
                                                                phi_2198_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1682.unnamed, lt_bvh_traverse_Tree(_e1682.unnamed_1.root, _e1659.y));
                                                            } else {
                                                                let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1659.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1698.unnamed.root, _e1659.y), _e1698.unnamed_1);
                                                                let _e1710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1704.unnamed, lt_bvh_traverse_Tree(_e1659.z, _e1704.unnamed_1.first_primitive));
                                                                phi_2198_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1710.unnamed, lt_bvh_traverse_Tree(_e1710.unnamed_1.root, _e1659.w));
                                                            }
                                                            let _e1718 = phi_2198_;
                                                            phi_2204_ = 0u;
                                                            phi_2207_ = 0u;
                                                            loop {
                                                                let _e1728 = phi_2204_;
                                                                let _e1730 = phi_2207_;
                                                                local_6 = _e1730;
                                                                local_7 = _e1730;
                                                                local_8 = _e1730;
                                                                let _e1731 = (_e1728 < 8u);
                                                                if _e1731 {
                                                                    let _e1733 = (_e1728 >> bitcast<u32>(2i));
                                                                    let _e1734 = (_e1728 & 3u);
                                                                    if (_e1733 == 0u) {
                                                                        phi_2221_ = _e1580.unnamed.root;
                                                                    } else {
                                                                        phi_2221_ = _e1580.unnamed.first_primitive;
                                                                    }
                                                                    let _e1737 = phi_2221_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2231_ = _e1649.unnamed.root;
                                                                    } else {
                                                                        phi_2231_ = _e1649.unnamed.first_primitive;
                                                                    }
                                                                    let _e1746 = phi_2231_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2241_ = _e1718.unnamed.root;
                                                                    } else {
                                                                        phi_2241_ = _e1718.unnamed.first_primitive;
                                                                    }
                                                                    let _e1755 = phi_2241_;
                                                                    let _e1768 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1737 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 - _e1271)), ((f32(((_e1746 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1272)));
                                                                    let _e1769 = core_intrinsics_maximum_number_nsz_f32_(_e1768, ((f32(((_e1755 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 - _e1273)));
                                                                    if (_e1733 == 0u) {
                                                                        phi_2259_ = _e1580.unnamed_1.root;
                                                                    } else {
                                                                        phi_2259_ = _e1580.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1772 = phi_2259_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2269_ = _e1649.unnamed_1.root;
                                                                    } else {
                                                                        phi_2269_ = _e1649.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1781 = phi_2269_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2279_ = _e1718.unnamed_1.root;
                                                                    } else {
                                                                        phi_2279_ = _e1718.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1790 = phi_2279_;
                                                                    let _e1803 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1772 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 + _e1271)), ((f32(((_e1781 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1272)));
                                                                    let _e1804 = core_intrinsics_minimum_number_nsz_f32_(_e1803, ((f32(((_e1790 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 + _e1273)));
                                                                    if (_e1769 <= _e1804) {
                                                                        if (_e1769 <= _e148) {
                                                                            if (_e1804 >= 0f) {
                                                                                if (_e1733 == 0u) {
                                                                                    let _e1811 = nodes.member[(0u + _e1459)].links[2u];
                                                                                    phi_2315_ = _e1811;
                                                                                } else {
                                                                                    let _e1814 = nodes.member[(0u + _e1459)].links[3u];
                                                                                    phi_2315_ = _e1814;
                                                                                }
                                                                                let _e1816 = phi_2315_;
                                                                                let _e1821 = ((_e1816 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u);
                                                                                let _e1822 = (_e1821 & 31u);
                                                                                if (_e1822 >= 24u) {
                                                                                    phi_2328_ = (24u + ((_e1822 - 24u) ^ _e1321));
                                                                                } else {
                                                                                    phi_2328_ = _e1822;
                                                                                }
                                                                                let _e1828 = phi_2328_;
                                                                                phi_2333_ = (_e1730 | ((_e1821 >> bitcast<u32>(5i)) << bitcast<u32>((_e1828 & 31u))));
                                                                            } else {
                                                                                phi_2333_ = _e1730;
                                                                            }
                                                                            let _e1836 = phi_2333_;
                                                                            phi_2334_ = _e1836;
                                                                        } else {
                                                                            phi_2334_ = _e1730;
                                                                        }
                                                                        let _e1838 = phi_2334_;
                                                                        phi_2335_ = _e1838;
                                                                    } else {
                                                                        phi_2335_ = _e1730;
                                                                    }
                                                                    let _e1840 = phi_2335_;
                                                                    phi_2205_ = (_e1728 + 1u);
                                                                    phi_2208_ = _e1840;
                                                                } else {
                                                                    phi_2205_ = u32();
                                                                    phi_2208_ = u32();
                                                                }
                                                                let _e1843 = phi_2205_;
                                                                let _e1845 = phi_2208_;
                                                                continue;
                                                                continuing {
                                                                    phi_2204_ = _e1843;
                                                                    phi_2207_ = _e1845;
                                                                    break if !(_e1731);
                                                                }
                                                            }
                                                            let _e1849 = nodes.member[(0u + _e1459)].links[0u];
                                                            let _e1853 = nodes.member[(0u + _e1459)].frame[3u];
                                                            let _e1857 = local_6;
                                                            if ((_e1857 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1861 = local_1.group_mask;
                                                                if ((_e1861 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1865 = local_1.len;
                                                                    if (_e1865 < 32u) {
                                                                        let _e1868 = local_1.group;
                                                                        let _e1870 = local_1.len;
                                                                        if (_e1870 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1870)] = _e1868;
                                                                        let _e1876 = local_1.group_mask;
                                                                        let _e1878 = local_1.len;
                                                                        if (_e1878 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1878)] = _e1876;
                                                                        let _e1885 = local_1.len;
                                                                        local_1.len = (_e1885 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1087 + _e1849);
                                                                let _e1889 = local_7;
                                                                local_1.group_mask = ((_e1889 & 4278190080u) | (_e1853 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1894 = local_8;
                                                            phi_2393_ = (_e1894 & 16777215u);
                                                            phi_2396_ = _e1461;
                                                            loop {
                                                                let _e1897 = phi_2393_;
                                                                let _e1899 = phi_2396_;
                                                                local_13 = _e1899;
                                                                let _e1900 = (_e1897 == 0u);
                                                                local_9 = _e1900;
                                                                local_15 = _e1900;
                                                                if _e1900 {
                                                                    phi_2394_ = u32();
                                                                    phi_2397_ = bool();
                                                                    phi_3200_ = bool();
                                                                    phi_3201_ = false;
                                                                } else {
                                                                    let _e1903 = nodes.member[(0u + _e1459)].links[1u];
                                                                    let _e1908 = ((_e1089 + _e1903) + select(firstTrailingBit(_e1897), 32u, (_e1897 == 0u)));
                                                                    if (_e1908 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1915 = triangles.member[(0u + _e1908)].v0_;
                                                                    let _e1917 = (_e1915.x - _e1018);
                                                                    let _e1919 = (_e1915.y - _e1031);
                                                                    let _e1921 = (_e1915.z - _e1044);
                                                                    if (_e1294 == 0u) {
                                                                        phi_2441_ = vec3<f32>(_e1919, _e1921, _e1917);
                                                                    } else {
                                                                        if (_e1294 == 1u) {
                                                                            phi_2440_ = vec3<f32>(_e1921, _e1917, _e1919);
                                                                        } else {
                                                                            phi_2440_ = (_e1915 - vec3<f32>(_e1018, _e1031, _e1044));
                                                                        }
                                                                        let _e1929 = phi_2440_;
                                                                        phi_2441_ = _e1929;
                                                                    }
                                                                    let _e1931 = phi_2441_;
                                                                    let _e1935 = (_e1931.x - (_e1305 * _e1931.z));
                                                                    let _e1939 = (_e1931.y - (_e1308 * _e1931.z));
                                                                    let _e1941 = triangles.member[(0u + _e1908)].v1_;
                                                                    let _e1943 = (_e1941.x - _e1018);
                                                                    let _e1945 = (_e1941.y - _e1031);
                                                                    let _e1947 = (_e1941.z - _e1044);
                                                                    if (_e1294 == 0u) {
                                                                        phi_2471_ = vec3<f32>(_e1945, _e1947, _e1943);
                                                                    } else {
                                                                        if (_e1294 == 1u) {
                                                                            phi_2470_ = vec3<f32>(_e1947, _e1943, _e1945);
                                                                        } else {
                                                                            phi_2470_ = (_e1941 - vec3<f32>(_e1018, _e1031, _e1044));
                                                                        }
                                                                        let _e1955 = phi_2470_;
                                                                        phi_2471_ = _e1955;
                                                                    }
                                                                    let _e1957 = phi_2471_;
                                                                    let _e1961 = (_e1957.x - (_e1305 * _e1957.z));
                                                                    let _e1965 = (_e1957.y - (_e1308 * _e1957.z));
                                                                    let _e1967 = triangles.member[(0u + _e1908)].v2_;
                                                                    let _e1969 = (_e1967.x - _e1018);
                                                                    let _e1971 = (_e1967.y - _e1031);
                                                                    let _e1973 = (_e1967.z - _e1044);
                                                                    if (_e1294 == 0u) {
                                                                        phi_2501_ = vec3<f32>(_e1971, _e1973, _e1969);
                                                                    } else {
                                                                        if (_e1294 == 1u) {
                                                                            phi_2500_ = vec3<f32>(_e1973, _e1969, _e1971);
                                                                        } else {
                                                                            phi_2500_ = (_e1967 - vec3<f32>(_e1018, _e1031, _e1044));
                                                                        }
                                                                        let _e1981 = phi_2500_;
                                                                        phi_2501_ = _e1981;
                                                                    }
                                                                    let _e1983 = phi_2501_;
                                                                    let _e1987 = (_e1983.x - (_e1305 * _e1983.z));
                                                                    let _e1991 = (_e1983.y - (_e1308 * _e1983.z));
                                                                    if (_e1961 < _e1987) {
                                                                        phi_2520_ = true;
                                                                    } else {
                                                                        if (_e1961 == _e1987) {
                                                                            phi_2519_ = (_e1965 < _e1991);
                                                                        } else {
                                                                            phi_2519_ = false;
                                                                        }
                                                                        let _e1996 = phi_2519_;
                                                                        phi_2520_ = _e1996;
                                                                    }
                                                                    let _e1998 = phi_2520_;
                                                                    if _e1998 {
                                                                        phi_2524_ = _e1991;
                                                                        phi_2525_ = _e1987;
                                                                        phi_2526_ = _e1965;
                                                                        phi_2527_ = _e1961;
                                                                    } else {
                                                                        phi_2524_ = _e1965;
                                                                        phi_2525_ = _e1961;
                                                                        phi_2526_ = _e1991;
                                                                        phi_2527_ = _e1987;
                                                                    }
                                                                    let _e2000 = phi_2524_;
                                                                    let _e2002 = phi_2525_;
                                                                    let _e2004 = phi_2526_;
                                                                    let _e2006 = phi_2527_;
                                                                    let _e2009 = ((_e2006 * _e2000) - (_e2004 * _e2002));
                                                                    if _e1998 {
                                                                        phi_2535_ = -(_e2009);
                                                                    } else {
                                                                        phi_2535_ = _e2009;
                                                                    }
                                                                    let _e2012 = phi_2535_;
                                                                    if (_e1987 < _e1935) {
                                                                        phi_2546_ = true;
                                                                    } else {
                                                                        if (_e1987 == _e1935) {
                                                                            phi_2545_ = (_e1991 < _e1939);
                                                                        } else {
                                                                            phi_2545_ = false;
                                                                        }
                                                                        let _e2017 = phi_2545_;
                                                                        phi_2546_ = _e2017;
                                                                    }
                                                                    let _e2019 = phi_2546_;
                                                                    if _e2019 {
                                                                        phi_2550_ = _e1939;
                                                                        phi_2551_ = _e1935;
                                                                        phi_2552_ = _e1991;
                                                                        phi_2553_ = _e1987;
                                                                    } else {
                                                                        phi_2550_ = _e1991;
                                                                        phi_2551_ = _e1987;
                                                                        phi_2552_ = _e1939;
                                                                        phi_2553_ = _e1935;
                                                                    }
                                                                    let _e2021 = phi_2550_;
                                                                    let _e2023 = phi_2551_;
                                                                    let _e2025 = phi_2552_;
                                                                    let _e2027 = phi_2553_;
                                                                    let _e2030 = ((_e2027 * _e2021) - (_e2025 * _e2023));
                                                                    if _e2019 {
                                                                        phi_2561_ = -(_e2030);
                                                                    } else {
                                                                        phi_2561_ = _e2030;
                                                                    }
                                                                    let _e2033 = phi_2561_;
                                                                    if (_e1935 < _e1961) {
                                                                        phi_2572_ = true;
                                                                    } else {
                                                                        if (_e1935 == _e1961) {
                                                                            phi_2571_ = (_e1939 < _e1965);
                                                                        } else {
                                                                            phi_2571_ = false;
                                                                        }
                                                                        let _e2038 = phi_2571_;
                                                                        phi_2572_ = _e2038;
                                                                    }
                                                                    let _e2040 = phi_2572_;
                                                                    if _e2040 {
                                                                        phi_2576_ = _e1965;
                                                                        phi_2577_ = _e1961;
                                                                        phi_2578_ = _e1939;
                                                                        phi_2579_ = _e1935;
                                                                    } else {
                                                                        phi_2576_ = _e1939;
                                                                        phi_2577_ = _e1935;
                                                                        phi_2578_ = _e1965;
                                                                        phi_2579_ = _e1961;
                                                                    }
                                                                    let _e2042 = phi_2576_;
                                                                    let _e2044 = phi_2577_;
                                                                    let _e2046 = phi_2578_;
                                                                    let _e2048 = phi_2579_;
                                                                    let _e2051 = ((_e2048 * _e2042) - (_e2046 * _e2044));
                                                                    if _e2040 {
                                                                        phi_2587_ = -(_e2051);
                                                                    } else {
                                                                        phi_2587_ = _e2051;
                                                                    }
                                                                    let _e2054 = phi_2587_;
                                                                    if (_e2012 >= 0f) {
                                                                        if (_e2033 >= 0f) {
                                                                            if (_e2054 >= 0f) {
                                                                                phi_2602_ = ((_e2012 + _e2033) + _e2054);
                                                                                phi_2603_ = false;
                                                                            } else {
                                                                                phi_2602_ = f32();
                                                                                phi_2603_ = true;
                                                                            }
                                                                            let _e2061 = phi_2602_;
                                                                            let _e2063 = phi_2603_;
                                                                            phi_2604_ = _e2061;
                                                                            phi_2605_ = _e2063;
                                                                        } else {
                                                                            phi_2604_ = f32();
                                                                            phi_2605_ = true;
                                                                        }
                                                                        let _e2065 = phi_2604_;
                                                                        let _e2067 = phi_2605_;
                                                                        phi_2606_ = _e2065;
                                                                        phi_2607_ = _e2067;
                                                                    } else {
                                                                        phi_2606_ = f32();
                                                                        phi_2607_ = true;
                                                                    }
                                                                    let _e2069 = phi_2606_;
                                                                    let _e2071 = phi_2607_;
                                                                    if _e2071 {
                                                                        if (_e2012 <= 0f) {
                                                                            if (_e2033 <= 0f) {
                                                                                let _e2074 = (_e2054 <= 0f);
                                                                                if _e2074 {
                                                                                }
                                                                                phi_2625_ = ((_e2012 + _e2033) + _e2054);
                                                                                phi_2626_ = false;
                                                                                phi_2627_ = _e2074;
                                                                            } else {
                                                                                phi_2625_ = f32();
                                                                                phi_2626_ = true;
                                                                                phi_2627_ = false;
                                                                            }
                                                                            let _e2078 = phi_2625_;
                                                                            let _e2080 = phi_2626_;
                                                                            let _e2082 = phi_2627_;
                                                                            phi_2628_ = _e2078;
                                                                            phi_2629_ = _e2080;
                                                                            phi_2630_ = _e2082;
                                                                        } else {
                                                                            phi_2628_ = f32();
                                                                            phi_2629_ = true;
                                                                            phi_2630_ = false;
                                                                        }
                                                                        let _e2084 = phi_2628_;
                                                                        let _e2086 = phi_2629_;
                                                                        let _e2088 = phi_2630_;
                                                                        if _e2086 {
                                                                            phi_2634_ = false;
                                                                        } else {
                                                                            phi_2634_ = _e2088;
                                                                        }
                                                                        let _e2090 = phi_2634_;
                                                                        phi_2635_ = _e2084;
                                                                        phi_2636_ = _e2090;
                                                                    } else {
                                                                        phi_2635_ = _e2069;
                                                                        phi_2636_ = true;
                                                                    }
                                                                    let _e2092 = phi_2635_;
                                                                    let _e2094 = phi_2636_;
                                                                    if _e2094 {
                                                                        let _e2095 = (_e2092 == 0f);
                                                                        if _e2095 {
                                                                            phi_2952_ = lt_bvh_triangle_Intersection();
                                                                            phi_2953_ = false;
                                                                        } else {
                                                                            let _e2097 = triangles.member[(0u + _e1908)].v0_;
                                                                            let _e2099 = (_e2097.x - _e1018);
                                                                            let _e2101 = (_e2097.y - _e1031);
                                                                            let _e2103 = (_e2097.z - _e1044);
                                                                            if (_e1294 == 0u) {
                                                                                phi_2665_ = vec3<f32>(_e2101, _e2103, _e2099);
                                                                            } else {
                                                                                if (_e1294 == 1u) {
                                                                                    phi_2664_ = vec3<f32>(_e2103, _e2099, _e2101);
                                                                                } else {
                                                                                    phi_2664_ = (_e2097 - vec3<f32>(_e1018, _e1031, _e1044));
                                                                                }
                                                                                let _e2111 = phi_2664_;
                                                                                phi_2665_ = _e2111;
                                                                            }
                                                                            let _e2113 = phi_2665_;
                                                                            let _e2115 = triangles.member[(0u + _e1908)].v1_;
                                                                            let _e2117 = triangles.member[(0u + _e1908)].v0_;
                                                                            let _e2120 = (_e2115.x - _e2117.x);
                                                                            let _e2123 = (_e2115.y - _e2117.y);
                                                                            let _e2126 = (_e2115.z - _e2117.z);
                                                                            if (_e1294 == 0u) {
                                                                                phi_2691_ = vec3<f32>(_e2123, _e2126, _e2120);
                                                                            } else {
                                                                                if (_e1294 == 1u) {
                                                                                    phi_2690_ = vec3<f32>(_e2126, _e2120, _e2123);
                                                                                } else {
                                                                                    phi_2690_ = (_e2115 - _e2117);
                                                                                }
                                                                                let _e2133 = phi_2690_;
                                                                                phi_2691_ = _e2133;
                                                                            }
                                                                            let _e2135 = phi_2691_;
                                                                            let _e2137 = triangles.member[(0u + _e1908)].v2_;
                                                                            let _e2139 = triangles.member[(0u + _e1908)].v0_;
                                                                            let _e2142 = (_e2137.x - _e2139.x);
                                                                            let _e2145 = (_e2137.y - _e2139.y);
                                                                            let _e2148 = (_e2137.z - _e2139.z);
                                                                            if (_e1294 == 0u) {
                                                                                phi_2717_ = vec3<f32>(_e2145, _e2148, _e2142);
                                                                            } else {
                                                                                if (_e1294 == 1u) {
                                                                                    phi_2716_ = vec3<f32>(_e2148, _e2142, _e2145);
                                                                                } else {
                                                                                    phi_2716_ = (_e2137 - _e2139);
                                                                                }
                                                                                let _e2155 = phi_2716_;
                                                                                phi_2717_ = _e2155;
                                                                            }
                                                                            let _e2157 = phi_2717_;
                                                                            let _e2164 = ((_e2135.y * _e2157.z) - (_e2135.z * _e2157.y));
                                                                            let _e2171 = ((_e2135.z * _e2157.x) - (_e2135.x * _e2157.z));
                                                                            let _e2178 = ((_e2135.x * _e2157.y) - (_e2135.y * _e2157.x));
                                                                            let _e2192 = (((1f / _e1302.z) * (((_e2164 * _e2113.x) + (_e2171 * _e2113.y)) + (_e2178 * _e2113.z))) / (((_e2164 * _e1305) + (_e2171 * _e1308)) + _e2178));
                                                                            if (_e2192 > 0f) {
                                                                                if (_e2192 < _e148) {
                                                                                    let _e2196 = triangles.member[(0u + _e1908)].v0_;
                                                                                    let _e2198 = triangles.member[(0u + _e1908)].v1_;
                                                                                    if (_e2196.x < _e2198.x) {
                                                                                        phi_2773_ = _e2196.x;
                                                                                    } else {
                                                                                        phi_2773_ = _e2198.x;
                                                                                    }
                                                                                    let _e2205 = phi_2773_;
                                                                                    if (_e2196.y < _e2198.y) {
                                                                                        phi_2782_ = _e2196.y;
                                                                                    } else {
                                                                                        phi_2782_ = _e2198.y;
                                                                                    }
                                                                                    let _e2212 = phi_2782_;
                                                                                    if (_e2196.z < _e2198.z) {
                                                                                        phi_2791_ = _e2196.z;
                                                                                    } else {
                                                                                        phi_2791_ = _e2198.z;
                                                                                    }
                                                                                    let _e2219 = phi_2791_;
                                                                                    let _e2221 = triangles.member[(0u + _e1908)].v2_;
                                                                                    if (_e2205 < _e2221.x) {
                                                                                        phi_2800_ = _e2205;
                                                                                    } else {
                                                                                        phi_2800_ = _e2221.x;
                                                                                    }
                                                                                    let _e2226 = phi_2800_;
                                                                                    if (_e2212 < _e2221.y) {
                                                                                        phi_2807_ = _e2212;
                                                                                    } else {
                                                                                        phi_2807_ = _e2221.y;
                                                                                    }
                                                                                    let _e2231 = phi_2807_;
                                                                                    if (_e2219 < _e2221.z) {
                                                                                        phi_2814_ = _e2219;
                                                                                    } else {
                                                                                        phi_2814_ = _e2221.z;
                                                                                    }
                                                                                    let _e2236 = phi_2814_;
                                                                                    let _e2238 = triangles.member[(0u + _e1908)].v0_;
                                                                                    let _e2240 = triangles.member[(0u + _e1908)].v1_;
                                                                                    if (_e2238.x > _e2240.x) {
                                                                                        phi_2827_ = _e2238.x;
                                                                                    } else {
                                                                                        phi_2827_ = _e2240.x;
                                                                                    }
                                                                                    let _e2247 = phi_2827_;
                                                                                    if (_e2238.y > _e2240.y) {
                                                                                        phi_2836_ = _e2238.y;
                                                                                    } else {
                                                                                        phi_2836_ = _e2240.y;
                                                                                    }
                                                                                    let _e2254 = phi_2836_;
                                                                                    if (_e2238.z > _e2240.z) {
                                                                                        phi_2845_ = _e2238.z;
                                                                                    } else {
                                                                                        phi_2845_ = _e2240.z;
                                                                                    }
                                                                                    let _e2261 = phi_2845_;
                                                                                    let _e2263 = triangles.member[(0u + _e1908)].v2_;
                                                                                    if (_e2247 > _e2263.x) {
                                                                                        phi_2854_ = _e2247;
                                                                                    } else {
                                                                                        phi_2854_ = _e2263.x;
                                                                                    }
                                                                                    let _e2268 = phi_2854_;
                                                                                    if (_e2254 > _e2263.y) {
                                                                                        phi_2861_ = _e2254;
                                                                                    } else {
                                                                                        phi_2861_ = _e2263.y;
                                                                                    }
                                                                                    let _e2273 = phi_2861_;
                                                                                    if (_e2261 > _e2263.z) {
                                                                                        phi_2868_ = _e2261;
                                                                                    } else {
                                                                                        phi_2868_ = _e2263.z;
                                                                                    }
                                                                                    let _e2278 = phi_2868_;
                                                                                    let _e2282 = ((_e2226 - _e1018) * _e1219);
                                                                                    let _e2283 = ((_e2231 - _e1031) * _e1229);
                                                                                    let _e2284 = ((_e2236 - _e1044) * _e1239);
                                                                                    let _e2288 = ((_e2268 - _e1018) * _e1219);
                                                                                    let _e2289 = ((_e2273 - _e1031) * _e1229);
                                                                                    let _e2290 = ((_e2278 - _e1044) * _e1239);
                                                                                    if (_e2282 < _e2288) {
                                                                                        phi_2885_ = _e2282;
                                                                                    } else {
                                                                                        phi_2885_ = _e2288;
                                                                                    }
                                                                                    let _e2293 = phi_2885_;
                                                                                    if (_e2283 < _e2289) {
                                                                                        phi_2890_ = _e2283;
                                                                                    } else {
                                                                                        phi_2890_ = _e2289;
                                                                                    }
                                                                                    let _e2296 = phi_2890_;
                                                                                    if (_e2284 < _e2290) {
                                                                                        phi_2895_ = _e2284;
                                                                                    } else {
                                                                                        phi_2895_ = _e2290;
                                                                                    }
                                                                                    let _e2299 = phi_2895_;
                                                                                    if (_e2282 > _e2288) {
                                                                                        phi_2903_ = _e2282;
                                                                                    } else {
                                                                                        phi_2903_ = _e2288;
                                                                                    }
                                                                                    let _e2305 = phi_2903_;
                                                                                    if (_e2283 > _e2289) {
                                                                                        phi_2908_ = _e2283;
                                                                                    } else {
                                                                                        phi_2908_ = _e2289;
                                                                                    }
                                                                                    let _e2308 = phi_2908_;
                                                                                    if (_e2284 > _e2290) {
                                                                                        phi_2913_ = _e2284;
                                                                                    } else {
                                                                                        phi_2913_ = _e2290;
                                                                                    }
                                                                                    let _e2311 = phi_2913_;
                                                                                    let _e2315 = core_intrinsics_maximum_number_nsz_f32_((_e2293 - _e1278), (_e2296 - _e1279));
                                                                                    let _e2316 = core_intrinsics_maximum_number_nsz_f32_(_e2315, (_e2299 - _e1280));
                                                                                    let _e2317 = core_intrinsics_minimum_number_nsz_f32_((_e2305 + _e1278), (_e2308 + _e1279));
                                                                                    let _e2318 = core_intrinsics_minimum_number_nsz_f32_(_e2317, (_e2311 + _e1280));
                                                                                    if (_e2316 > _e999) {
                                                                                        phi_2925_ = _e2316;
                                                                                    } else {
                                                                                        phi_2925_ = _e999;
                                                                                    }
                                                                                    let _e2321 = phi_2925_;
                                                                                    if (_e2318 < _e1001) {
                                                                                        phi_2930_ = _e2318;
                                                                                    } else {
                                                                                        phi_2930_ = _e1001;
                                                                                    }
                                                                                    let _e2324 = phi_2930_;
                                                                                    if (_e2192 < _e2321) {
                                                                                        phi_2935_ = _e2321;
                                                                                    } else {
                                                                                        phi_2935_ = _e2192;
                                                                                    }
                                                                                    let _e2327 = phi_2935_;
                                                                                    if (_e2327 > _e2324) {
                                                                                        phi_2940_ = _e2324;
                                                                                    } else {
                                                                                        phi_2940_ = _e2327;
                                                                                    }
                                                                                    let _e2330 = phi_2940_;
                                                                                    phi_2945_ = lt_bvh_triangle_Intersection(_e2330, (_e2033 / _e2092), (_e2054 / _e2092), (_e2321 <= _e2324));
                                                                                    phi_2946_ = false;
                                                                                } else {
                                                                                    phi_2945_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2946_ = true;
                                                                                }
                                                                                let _e2336 = phi_2945_;
                                                                                let _e2338 = phi_2946_;
                                                                                phi_2947_ = _e2336;
                                                                                phi_2948_ = _e2338;
                                                                            } else {
                                                                                phi_2947_ = lt_bvh_triangle_Intersection();
                                                                                phi_2948_ = true;
                                                                            }
                                                                            let _e2340 = phi_2947_;
                                                                            let _e2342 = phi_2948_;
                                                                            if _e2342 {
                                                                            }
                                                                            phi_2952_ = _e2340;
                                                                            phi_2953_ = _e2342;
                                                                        }
                                                                        let _e2344 = phi_2952_;
                                                                        let _e2346 = phi_2953_;
                                                                        phi_2954_ = _e2344;
                                                                        phi_2955_ = _e2095;
                                                                        phi_2956_ = _e2346;
                                                                    } else {
                                                                        phi_2954_ = lt_bvh_triangle_Intersection();
                                                                        phi_2955_ = true;
                                                                        phi_2956_ = false;
                                                                    }
                                                                    let _e2348 = phi_2954_;
                                                                    let _e2350 = phi_2955_;
                                                                    let _e2352 = phi_2956_;
                                                                    if _e2350 {
                                                                        phi_2960_ = true;
                                                                    } else {
                                                                        phi_2960_ = _e2352;
                                                                    }
                                                                    let _e2354 = phi_2960_;
                                                                    if _e2354 {
                                                                        phi_2964_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2964_ = _e2348;
                                                                    }
                                                                    let _e2356 = phi_2964_;
                                                                    if _e2356.is_hit {
                                                                        if (_e2356.t > 0f) {
                                                                            if (_e2356.t < _e148) {
                                                                                let _e2363 = triangles.member[(0u + _e1908)].i0_;
                                                                                if ((_e2363 & 2147483648u) == 0u) {
                                                                                    phi_3183_ = true;
                                                                                } else {
                                                                                    if (_e1908 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2372 = triangles.member[(0u + _e1908)].i0_;
                                                                                    let _e2373 = (_e2372 & 2147483647u);
                                                                                    let _e2375 = triangles.member[(0u + _e1908)].i1_;
                                                                                    let _e2377 = triangles.member[(0u + _e1908)].i2_;
                                                                                    if (_e2373 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2381 = vertices.member[(0u + _e2373)];
                                                                                    if (_e2375 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2385 = vertices.member[(0u + _e2375)];
                                                                                    if (_e2377 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2389 = vertices.member[(0u + _e2377)];
                                                                                    let _e2390 = array<abi_Vertex, 3>(_e2381, _e2385, _e2389);
                                                                                    if (_e2390[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2396 = materials.member[(0u + _e2390[0].material)];
                                                                                    if ((_e2396.flags & 1u) == 1u) {
                                                                                        let _e2401 = ((1f - _e2356.u) - _e2356.v);
                                                                                        if (_e2396.cutoff <= 0f) {
                                                                                            phi_3181_ = true;
                                                                                        } else {
                                                                                            let _e2428 = (_e2396.base_color.w * ((((f32((_e2390[0].color >> bitcast<u32>(24i))) * _e2401) + (f32((_e2390[1].color >> bitcast<u32>(24i))) * _e2356.u)) + (f32((_e2390[2].color >> bitcast<u32>(24i))) * _e2356.v)) * (1f / 255f)));
                                                                                            if (_e2396.alpha_size == 0u) {
                                                                                                phi_3178_ = _e2428;
                                                                                            } else {
                                                                                                local.offset = _e2396.alpha_offset;
                                                                                                local.size = _e2396.alpha_size;
                                                                                                local.flags = _e2396.flags;
                                                                                                let _e2459 = _lt_shaders_texture_TextureView_quad((&local), (((_e2390[0].u * _e2401) + (_e2390[1].u * _e2356.u)) + (_e2390[2].u * _e2356.v)), (((_e2390[0].v * _e2401) + (_e2390[1].v * _e2356.u)) + (_e2390[2].v * _e2356.v)));
                                                                                                let _e2463 = (_e2459.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2463 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2467 = alpha_texels.member[(0u + _e2463)];
                                                                                                let _e2483 = (_e2459.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2483 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2487 = alpha_texels.member[(0u + _e2483)];
                                                                                                let _e2504 = (_e2459.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2504 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2508 = alpha_texels.member[(0u + _e2504)];
                                                                                                let _e2525 = (_e2459.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2525 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2529 = alpha_texels.member[(0u + _e2525)];
                                                                                                phi_3178_ = (_e2428 * (((((f32(((_e2467 >> bitcast<u32>((((_e2459.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2459.weights.x) + ((f32(((_e2487 >> bitcast<u32>((((_e2459.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2459.weights.y)) + ((f32(((_e2508 >> bitcast<u32>((((_e2459.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2459.weights.z)) + ((f32(((_e2529 >> bitcast<u32>((((_e2459.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2459.weights.w)));
                                                                                            }
                                                                                            let _e2545 = phi_3178_;
                                                                                            phi_3181_ = (_e2545 >= _e2396.cutoff);
                                                                                        }
                                                                                        let _e2549 = phi_3181_;
                                                                                        phi_3182_ = _e2549;
                                                                                    } else {
                                                                                        phi_3182_ = false;
                                                                                    }
                                                                                    let _e2551 = phi_3182_;
                                                                                    phi_3183_ = _e2551;
                                                                                }
                                                                                let _e2553 = phi_3183_;
                                                                                if _e2553 {
                                                                                    phi_3187_ = false;
                                                                                } else {
                                                                                    phi_3187_ = true;
                                                                                }
                                                                                let _e2555 = phi_3187_;
                                                                                phi_3188_ = _e2553;
                                                                                phi_3189_ = _e2553;
                                                                                phi_3190_ = _e2555;
                                                                            } else {
                                                                                phi_3188_ = bool();
                                                                                phi_3189_ = _e1899;
                                                                                phi_3190_ = true;
                                                                            }
                                                                            let _e2557 = phi_3188_;
                                                                            let _e2559 = phi_3189_;
                                                                            let _e2561 = phi_3190_;
                                                                            phi_3191_ = _e2557;
                                                                            phi_3192_ = _e2559;
                                                                            phi_3193_ = _e2561;
                                                                        } else {
                                                                            phi_3191_ = bool();
                                                                            phi_3192_ = _e1899;
                                                                            phi_3193_ = true;
                                                                        }
                                                                        let _e2563 = phi_3191_;
                                                                        let _e2565 = phi_3192_;
                                                                        let _e2567 = phi_3193_;
                                                                        phi_3194_ = _e2563;
                                                                        phi_3195_ = _e2565;
                                                                        phi_3196_ = _e2567;
                                                                    } else {
                                                                        phi_3194_ = bool();
                                                                        phi_3195_ = _e1899;
                                                                        phi_3196_ = true;
                                                                    }
                                                                    let _e2569 = phi_3194_;
                                                                    let _e2571 = phi_3195_;
                                                                    let _e2573 = phi_3196_;
                                                                    if _e2573 {
                                                                    }
                                                                    phi_2394_ = (_e1897 & (_e1897 - 1u));
                                                                    phi_2397_ = _e2571;
                                                                    phi_3200_ = _e2569;
                                                                    phi_3201_ = _e2573;
                                                                }
                                                                let _e2575 = phi_2394_;
                                                                let _e2577 = phi_2397_;
                                                                let _e2579 = phi_3200_;
                                                                let _e2581 = phi_3201_;
                                                                local_14 = _e2579;
                                                                continue;
                                                                continuing {
                                                                    phi_2393_ = _e2575;
                                                                    phi_2396_ = _e2577;
                                                                    break if !(_e2581);
                                                                }
                                                            }
                                                            let _e2584 = local_9;
                                                            if _e2584 {
                                                                let _e2586 = local_1.group_mask;
                                                                if ((_e2586 & 4278190080u) == 0u) {
                                                                    let _e2590 = local_1.len;
                                                                    if (_e2590 == 0u) {
                                                                        phi_3243_ = false;
                                                                    } else {
                                                                        let _e2594 = local_1.len;
                                                                        local_1.len = (_e2594 - 1u);
                                                                        let _e2597 = local_1.len;
                                                                        if (_e2597 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2602 = local_1.first[(0u + _e2597)];
                                                                        local_1.group = _e2602;
                                                                        let _e2605 = local_1.len;
                                                                        if (_e2605 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2610 = local_1.mask[(0u + _e2605)];
                                                                        local_1.group_mask = _e2610;
                                                                        phi_3243_ = true;
                                                                    }
                                                                    let _e2613 = phi_3243_;
                                                                    phi_3244_ = _e2613;
                                                                } else {
                                                                    phi_3244_ = true;
                                                                }
                                                                let _e2615 = phi_3244_;
                                                                if _e2615 {
                                                                    let _e2617 = local_1.group_mask;
                                                                    let _e2623 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2617)), 32u, (_e2617 == 0u)));
                                                                    let _e2627 = local_1.group_mask;
                                                                    let _e2641 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2641 & ~((1u << bitcast<u32>((_e2623 & 31u)))));
                                                                    let _e2644 = local_1.group;
                                                                    phi_3275_ = (_e2644 + countOneBits(((_e2627 & ~((4294967295u << bitcast<u32>((((_e2623 - 24u) ^ _e1321) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3275_ = 4294967295u;
                                                                }
                                                                let _e2647 = phi_3275_;
                                                                phi_3276_ = _e2647;
                                                            } else {
                                                                phi_3276_ = u32();
                                                            }
                                                            let _e2649 = phi_3276_;
                                                            phi_2062_ = _e2649;
                                                            let _e3125 = local_13;
                                                            phi_2065_ = _e3125;
                                                            let _e3128 = local_14;
                                                            phi_3277_ = _e3128;
                                                            let _e3131 = local_15;
                                                            phi_3278_ = _e3131;
                                                            phi_3279_ = false;
                                                        } else {
                                                            phi_2062_ = u32();
                                                            phi_2065_ = bool();
                                                            phi_3277_ = bool();
                                                            phi_3278_ = false;
                                                            phi_3279_ = true;
                                                        }
                                                        let _e2651 = phi_2062_;
                                                        let _e2653 = phi_2065_;
                                                        let _e2655 = phi_3277_;
                                                        let _e2657 = phi_3278_;
                                                        let _e2659 = phi_3279_;
                                                        local_10 = _e2659;
                                                        local_16 = _e2655;
                                                        continue;
                                                        continuing {
                                                            phi_2061_ = _e2651;
                                                            phi_2064_ = _e2653;
                                                            break if !(_e2657);
                                                        }
                                                    }
                                                    let _e2662 = local_10;
                                                    if _e2662 {
                                                        phi_3283_ = false;
                                                    } else {
                                                        phi_3283_ = true;
                                                    }
                                                    let _e2664 = phi_3283_;
                                                    if _e2664 {
                                                        let _e3137 = local_16;
                                                        phi_3287_ = _e3137;
                                                    } else {
                                                        let _e3139 = local_17;
                                                        phi_3287_ = _e3139;
                                                    }
                                                    let _e2666 = phi_3287_;
                                                    phi_3288_ = _e2666;
                                                }
                                                let _e2668 = phi_3288_;
                                                phi_3289_ = _e2668;
                                                phi_3290_ = _e1143;
                                            } else {
                                                phi_3289_ = bool();
                                                phi_3290_ = true;
                                            }
                                            let _e2670 = phi_3289_;
                                            let _e2672 = phi_3290_;
                                            if _e2672 {
                                                phi_3294_ = _e938;
                                            } else {
                                                phi_3294_ = _e2670;
                                            }
                                            let _e2674 = phi_3294_;
                                            if _e2674 {
                                                phi_3298_ = false;
                                            } else {
                                                phi_3298_ = true;
                                            }
                                            let _e2676 = phi_3298_;
                                            phi_3299_ = _e2674;
                                            phi_3300_ = _e2676;
                                        } else {
                                            phi_3299_ = _e938;
                                            phi_3300_ = true;
                                        }
                                        let _e2678 = phi_3299_;
                                        let _e2680 = phi_3300_;
                                        phi_3301_ = _e2678;
                                        phi_3302_ = _e2680;
                                    } else {
                                        phi_3301_ = _e938;
                                        phi_3302_ = true;
                                    }
                                    let _e2682 = phi_3301_;
                                    let _e2684 = phi_3302_;
                                    phi_3303_ = _e2682;
                                    phi_3304_ = _e2684;
                                } else {
                                    phi_3303_ = _e938;
                                    phi_3304_ = true;
                                }
                                let _e2686 = phi_3303_;
                                let _e2688 = phi_3304_;
                                if _e2688 {
                                }
                                phi_1447_ = (_e936 & (_e936 - 1u));
                                phi_1450_ = _e2686;
                                phi_3308_ = _e2688;
                            }
                            let _e2690 = phi_1447_;
                            let _e2692 = phi_1450_;
                            let _e2694 = phi_3308_;
                            continue;
                            continuing {
                                phi_1446_ = _e2690;
                                phi_1449_ = _e2692;
                                break if !(_e2694);
                            }
                        }
                        let _e2697 = local_11;
                        if _e2697 {
                            let _e2699 = local_2.group_mask;
                            if ((_e2699 & 4278190080u) == 0u) {
                                let _e2703 = local_2.len;
                                if (_e2703 == 0u) {
                                    phi_3350_ = false;
                                } else {
                                    let _e2707 = local_2.len;
                                    local_2.len = (_e2707 - 1u);
                                    let _e2710 = local_2.len;
                                    if (_e2710 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2715 = local_2.first[(0u + _e2710)];
                                    local_2.group = _e2715;
                                    let _e2718 = local_2.len;
                                    if (_e2718 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2723 = local_2.mask[(0u + _e2718)];
                                    local_2.group_mask = _e2723;
                                    phi_3350_ = true;
                                }
                                let _e2726 = phi_3350_;
                                phi_3351_ = _e2726;
                            } else {
                                phi_3351_ = true;
                            }
                            let _e2728 = phi_3351_;
                            if _e2728 {
                                let _e2730 = local_2.group_mask;
                                let _e2736 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2730)), 32u, (_e2730 == 0u)));
                                let _e2740 = local_2.group_mask;
                                let _e2754 = local_2.group_mask;
                                local_2.group_mask = (_e2754 & ~((1u << bitcast<u32>((_e2736 & 31u)))));
                                let _e2757 = local_2.group;
                                phi_3382_ = (_e2757 + countOneBits(((_e2740 & ~((4294967295u << bitcast<u32>((((_e2736 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_3382_ = 4294967295u;
                            }
                            let _e2760 = phi_3382_;
                            phi_3383_ = _e2760;
                        } else {
                            phi_3383_ = u32();
                        }
                        let _e2762 = phi_3383_;
                        phi_1115_ = _e2762;
                        let _e3162 = local_18;
                        phi_1118_ = _e3162;
                        let _e3165 = local_19;
                        phi_3384_ = _e3165;
                        phi_3385_ = false;
                    } else {
                        phi_1115_ = u32();
                        phi_1118_ = bool();
                        phi_3384_ = false;
                        phi_3385_ = true;
                    }
                    let _e2764 = phi_1115_;
                    let _e2766 = phi_1118_;
                    let _e2768 = phi_3384_;
                    let _e2770 = phi_3385_;
                    local_12 = _e2770;
                    continue;
                    continuing {
                        phi_1114_ = _e2764;
                        phi_1117_ = _e2766;
                        break if !(_e2768);
                    }
                }
                let _e2773 = local_12;
                if _e2773 {
                    phi_3389_ = false;
                } else {
                    phi_3389_ = true;
                }
                let _e2775 = phi_3389_;
                if _e2775 {
                }
                phi_3393_ = _e2775;
            }
            let _e2777 = phi_3393_;
            phi_3394_ = _e212;
            phi_3395_ = _e2777;
        } else {
            phi_3394_ = true;
            phi_3395_ = false;
        }
        let _e2779 = phi_3394_;
        let _e2781 = phi_3395_;
        if _e2779 {
            phi_3399_ = false;
            phi_3400_ = true;
        } else {
            phi_3399_ = true;
            phi_3400_ = _e2781;
        }
        let _e2783 = phi_3399_;
        let _e2785 = phi_3400_;
        if _e2785 {
            phi_3404_ = _e2783;
        } else {
            phi_3404_ = false;
        }
        let _e2787 = phi_3404_;
        if _e2787 {
            phi_3408_ = 0f;
        } else {
            phi_3408_ = 1f;
        }
        let _e2789 = phi_3408_;
        if (_e116 < _e84) {
        } else {
            return;
        }
        visibility.member[(0u + _e116)] = _e2789;
        let _e2795 = p.member.light.number;
        let _e2796 = (_e2795 * 3u);
        let _e2797 = (_e2796 / 32u);
        let _e2798 = (_e2796 % 32u);
        let _e2800 = p.member.light.mask_words;
        if (_e116 < _e84) {
        } else {
            return;
        }
        let _e2804 = visibility.member[(0u + _e116)];
        let _e2806 = ((_e116 * _e2800) + _e2797);
        if (_e2798 > 29u) {
            let _e2808 = (_e2806 + 1u);
            if (_e2808 < _e90) {
            } else {
                return;
            }
            let _e2812 = bits.member[(0u + _e2808)];
            phi_3449_ = _e2812;
        } else {
            phi_3449_ = 0u;
        }
        let _e2814 = phi_3449_;
        if (_e2806 < _e90) {
        } else {
            return;
        }
        let _e2818 = bits.member[(0u + _e2806)];
        let _e2821 = (_e2818 >> bitcast<u32>((_e2798 & 31u)));
        if (_e2798 > 29u) {
            phi_3468_ = (_e2821 | (_e2814 << bitcast<u32>(((32u - _e2798) & 31u))));
        } else {
            phi_3468_ = _e2821;
        }
        let _e2829 = phi_3468_;
        if ((_e2829 & 2u) == 0u) {
            phi_3476_ = (_e2829 & 1u);
        } else {
            phi_3476_ = (_e2829 & 7u);
        }
        let _e2835 = phi_3476_;
        if ((_e2835 & 1u) != 0u) {
            phi_3484_ = (2u | 1u);
        } else {
            phi_3484_ = 2u;
        }
        let _e2841 = phi_3484_;
        if (_e2804 < 0.5f) {
            phi_3489_ = (_e2841 | 4u);
        } else {
            phi_3489_ = _e2841;
        }
        let _e2844 = phi_3489_;
        let _e2846 = ((_e116 * _e2800) + _e2797);
        if (_e2846 < _e90) {
        } else {
            return;
        }
        let _e2850 = bits.member[(0u + _e2846)];
        if (_e2846 < _e90) {
        } else {
            return;
        }
        bits.member[(0u + _e2846)] = ((_e2850 & ~((7u << bitcast<u32>((_e2798 & 31u))))) | (_e2844 << bitcast<u32>((_e2798 & 31u))));
        if (_e2798 > 29u) {
            let _e2864 = (_e2846 + 1u);
            if (_e2864 < _e90) {
            } else {
                return;
            }
            let _e2868 = bits.member[(0u + _e2864)];
            let _e2869 = (32u - _e2798);
            let _e2879 = (_e2846 + 1u);
            if (_e2879 < _e90) {
            } else {
                return;
            }
            bits.member[(0u + _e2879)] = ((_e2868 & ~((7u >> bitcast<u32>((_e2869 & 31u))))) | (_e2844 >> bitcast<u32>((_e2869 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
