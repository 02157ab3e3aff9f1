struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
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

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_31 {
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

struct type_35 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_39 {
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

struct type_43 {
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

struct type_57 {
    member: array<lt_bvh_Instance>,
}

struct type_61 {
    member: abi_CameraParams,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
}

struct lt_bvh_Hit {
    t: f32,
    u: f32,
    v: f32,
    triangle: u32,
    instance: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_39;
@group(0) @binding(4) 
var<storage> materials: type_43;
@group(0) @binding(0) 
var<uniform> p: type_61;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_57;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_224_: lt_mask_LightPlace;
    var phi_225_: bool;
    var phi_226_: lt_mask_LightPlace;
    var phi_227_: bool;
    var phi_232_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_224_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_225_ = false;
        } else {
            phi_224_ = lt_mask_LightPlace();
            phi_225_ = true;
        }
        let _e83 = phi_224_;
        let _e85 = phi_225_;
        phi_226_ = _e83;
        phi_227_ = _e85;
    } else {
        phi_226_ = lt_mask_LightPlace();
        phi_227_ = true;
    }
    let _e87 = phi_226_;
    let _e89 = phi_227_;
    if _e89 {
        phi_232_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_232_ = _e87;
    }
    let _e94 = phi_232_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_247_ = _e73;
    }
    let _e75 = phi_247_;
    if _e75 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e77 = phi_251_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_263_ = _e73;
    }
    let _e75 = phi_263_;
    if _e75 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e77 = phi_267_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_309_: f32;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_321_: f32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_397_: u32;
    var phi_411_: u32;
    var phi_418_: u32;
    var phi_423_: u32;
    var phi_429_: u32;
    var phi_434_: u32;
    var phi_436_: texture_Axis;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_476_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_514_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_534_: f32;
    var phi_552_: u32;
    var phi_566_: u32;
    var phi_573_: u32;
    var phi_578_: u32;
    var phi_584_: u32;
    var phi_589_: u32;
    var phi_591_: texture_Axis;

    let _e74 = (*param_7).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_7).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_7).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_7).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_8 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e101 > param_8) {
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e104 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e101 - _e104);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e107 = phi_314_;
            let _e109 = phi_315_;
            phi_316_ = _e107;
            phi_317_ = _e109;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e111 = phi_316_;
        let _e113 = phi_317_;
        if _e113 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e111;
        }
        let _e115 = phi_321_;
        phi_369_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e133 = phi_347_;
                if (_e118 < 8388608f) {
                    phi_352_ = (_e130 - _e133);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e136 = phi_352_;
                let _e138 = phi_353_;
                phi_354_ = _e136;
                phi_355_ = _e138;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e140 = phi_354_;
            let _e142 = phi_355_;
            if _e142 {
                phi_359_ = _e118;
            } else {
                phi_359_ = _e140;
            }
            let _e144 = phi_359_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_367_ = (2f - _e146);
            } else {
                phi_367_ = _e146;
            }
            let _e150 = phi_367_;
            phi_368_ = _e150;
        } else {
            phi_368_ = param_8;
        }
        let _e152 = phi_368_;
        phi_369_ = _e152;
    }
    let _e154 = phi_369_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_378_ = _e154;
        } else {
            phi_378_ = 1f;
        }
        let _e158 = phi_378_;
        phi_379_ = _e158;
    } else {
        phi_379_ = 0f;
    }
    let _e160 = phi_379_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_397_ = _e161;
        } else {
            phi_397_ = _e170;
        }
        let _e173 = phi_397_;
        phi_436_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_411_ = _e75;
        } else {
            phi_411_ = _e182;
        }
        let _e185 = phi_411_;
        if (_e88 == 0u) {
            phi_418_ = _e161;
        } else {
            phi_418_ = 0u;
        }
        let _e190 = phi_418_;
        if (_e88 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e161;
        }
        let _e193 = phi_423_;
        if (_e185 == 0u) {
            phi_429_ = _e190;
        } else {
            phi_429_ = (_e185 - 1u);
        }
        let _e197 = phi_429_;
        if (_e185 > _e161) {
            phi_434_ = _e193;
        } else {
            phi_434_ = _e185;
        }
        let _e200 = phi_434_;
        phi_436_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_436_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e224 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e221 - _e224);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e227 = phi_469_;
            let _e229 = phi_470_;
            phi_471_ = _e227;
            phi_472_ = _e229;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e231 = phi_471_;
        let _e233 = phi_472_;
        if _e233 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e231;
        }
        let _e235 = phi_476_;
        phi_524_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e253 = phi_502_;
                if (_e238 < 8388608f) {
                    phi_507_ = (_e250 - _e253);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e256 = phi_507_;
                let _e258 = phi_508_;
                phi_509_ = _e256;
                phi_510_ = _e258;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e260 = phi_509_;
            let _e262 = phi_510_;
            if _e262 {
                phi_514_ = _e238;
            } else {
                phi_514_ = _e260;
            }
            let _e264 = phi_514_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_522_ = (2f - _e266);
            } else {
                phi_522_ = _e266;
            }
            let _e270 = phi_522_;
            phi_523_ = _e270;
        } else {
            phi_523_ = param_9;
        }
        let _e272 = phi_523_;
        phi_524_ = _e272;
    }
    let _e274 = phi_524_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_533_ = _e274;
        } else {
            phi_533_ = 1f;
        }
        let _e278 = phi_533_;
        phi_534_ = _e278;
    } else {
        phi_534_ = 0f;
    }
    let _e280 = phi_534_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_552_ = _e281;
        } else {
            phi_552_ = _e290;
        }
        let _e293 = phi_552_;
        phi_591_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_566_ = _e79;
        } else {
            phi_566_ = _e302;
        }
        let _e305 = phi_566_;
        if (_e208 == 0u) {
            phi_573_ = _e281;
        } else {
            phi_573_ = 0u;
        }
        let _e310 = phi_573_;
        if (_e208 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e281;
        }
        let _e313 = phi_578_;
        if (_e305 == 0u) {
            phi_584_ = _e310;
        } else {
            phi_584_ = (_e305 - 1u);
        }
        let _e317 = phi_584_;
        if (_e305 > _e281) {
            phi_589_ = _e313;
        } else {
            phi_589_ = _e305;
        }
        let _e320 = phi_589_;
        phi_591_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_591_;
    let _e327 = (*param_7).offset;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_650_: f32;

    if (param_12 > param_13) {
        phi_650_ = param_12;
    } else {
        phi_650_ = param_13;
    }
    let _e74 = phi_650_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_794_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_814_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_841_: bool;
    var phi_917_: f32;
    var phi_924_: f32;
    var phi_932_: f32;
    var phi_939_: f32;
    var phi_947_: f32;
    var phi_954_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1016_: u32;
    var phi_1021_: u32;
    var phi_1026_: u32;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1172_: u32;
    var phi_1174_: u32;
    var phi_1177_: lt_bvh_Hit;
    var phi_1262_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1289_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1316_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1322_: u32;
    var phi_1325_: u32;
    var phi_1339_: u32;
    var phi_1349_: u32;
    var phi_1359_: u32;
    var phi_1377_: u32;
    var phi_1387_: u32;
    var phi_1397_: u32;
    var phi_1433_: u32;
    var phi_1446_: u32;
    var phi_1451_: u32;
    var phi_1452_: u32;
    var phi_1453_: u32;
    var phi_1323_: u32;
    var phi_1326_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1511_: u32;
    var phi_1514_: lt_bvh_Hit;
    var phi_1569_: f32;
    var phi_1574_: f32;
    var phi_1579_: f32;
    var phi_1587_: f32;
    var phi_1592_: f32;
    var phi_1597_: f32;
    var phi_1729_: bool;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1736_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1751_: bool;
    var phi_1752_: bool;
    var phi_1756_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1867_: f32;
    var phi_1874_: f32;
    var phi_1881_: f32;
    var phi_1888_: f32;
    var phi_1905_: f32;
    var phi_1910_: f32;
    var phi_1915_: f32;
    var phi_1920_: f32;
    var phi_1925_: f32;
    var phi_1951_: bool;
    var phi_1952_: bool;
    var phi_1960_: u32;
    var phi_1961_: u32;
    var phi_1972_: vec3<f32>;
    var phi_1973_: vec3<f32>;
    var phi_1986_: u32;
    var phi_1991_: u32;
    var phi_1996_: u32;
    var phi_2110_: bool;
    var phi_2111_: bool;
    var phi_2142_: u32;
    var phi_2144_: lt_bvh_Hit;
    var phi_2147_: u32;
    var phi_2228_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2255_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2282_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2288_: u32;
    var phi_2291_: u32;
    var phi_2305_: u32;
    var phi_2315_: u32;
    var phi_2325_: u32;
    var phi_2343_: u32;
    var phi_2353_: u32;
    var phi_2363_: u32;
    var phi_2399_: u32;
    var phi_2412_: u32;
    var phi_2417_: u32;
    var phi_2418_: u32;
    var phi_2419_: u32;
    var phi_2289_: u32;
    var phi_2292_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2477_: lt_bvh_Hit;
    var phi_2480_: u32;
    var phi_2524_: vec3<f32>;
    var phi_2525_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2555_: vec3<f32>;
    var phi_2584_: vec3<f32>;
    var phi_2585_: vec3<f32>;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2608_: f32;
    var phi_2609_: f32;
    var phi_2610_: f32;
    var phi_2611_: f32;
    var phi_2619_: f32;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2634_: f32;
    var phi_2635_: f32;
    var phi_2636_: f32;
    var phi_2637_: f32;
    var phi_2645_: f32;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2660_: f32;
    var phi_2661_: f32;
    var phi_2662_: f32;
    var phi_2663_: f32;
    var phi_2671_: f32;
    var phi_2686_: f32;
    var phi_2687_: bool;
    var phi_2688_: f32;
    var phi_2689_: bool;
    var phi_2690_: f32;
    var phi_2691_: bool;
    var phi_2709_: f32;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2712_: f32;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2718_: bool;
    var phi_2719_: f32;
    var phi_2720_: bool;
    var phi_2748_: vec3<f32>;
    var phi_2749_: vec3<f32>;
    var phi_2774_: vec3<f32>;
    var phi_2775_: vec3<f32>;
    var phi_2800_: vec3<f32>;
    var phi_2801_: vec3<f32>;
    var phi_2857_: f32;
    var phi_2866_: f32;
    var phi_2875_: f32;
    var phi_2884_: f32;
    var phi_2891_: f32;
    var phi_2898_: f32;
    var phi_2911_: f32;
    var phi_2920_: f32;
    var phi_2929_: f32;
    var phi_2938_: f32;
    var phi_2945_: f32;
    var phi_2952_: f32;
    var phi_2969_: f32;
    var phi_2974_: f32;
    var phi_2979_: f32;
    var phi_2987_: f32;
    var phi_2992_: f32;
    var phi_2997_: f32;
    var phi_3009_: f32;
    var phi_3014_: f32;
    var phi_3019_: f32;
    var phi_3024_: f32;
    var phi_3029_: lt_bvh_triangle_Intersection;
    var phi_3030_: bool;
    var phi_3031_: lt_bvh_triangle_Intersection;
    var phi_3032_: bool;
    var phi_3036_: lt_bvh_triangle_Intersection;
    var phi_3037_: bool;
    var phi_3038_: lt_bvh_triangle_Intersection;
    var phi_3039_: bool;
    var phi_3040_: bool;
    var phi_3044_: bool;
    var phi_3048_: lt_bvh_triangle_Intersection;
    var phi_3086_: bool;
    var phi_3087_: bool;
    var phi_3088_: bool;
    var phi_3089_: bool;
    var phi_3090_: bool;
    var phi_3091_: bool;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3299_: f32;
    var phi_3302_: bool;
    var phi_3303_: bool;
    var phi_3307_: bool;
    var phi_3315_: lt_bvh_Hit;
    var phi_3316_: lt_bvh_Hit;
    var phi_3317_: lt_bvh_Hit;
    var phi_3318_: lt_bvh_Hit;
    var phi_2478_: lt_bvh_Hit;
    var phi_2481_: u32;
    var phi_3319_: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3390_: u32;
    var phi_2145_: lt_bvh_Hit;
    var phi_2148_: u32;
    var phi_3391_: lt_bvh_Hit;
    var phi_3392_: lt_bvh_Hit;
    var phi_3393_: bool;
    var phi_3397_: lt_bvh_Hit;
    var phi_3398_: lt_bvh_Hit;
    var phi_3399_: lt_bvh_Hit;
    var phi_3400_: lt_bvh_Hit;
    var phi_1512_: u32;
    var phi_1515_: lt_bvh_Hit;
    var phi_3401_: bool;
    var phi_3440_: bool;
    var phi_3441_: bool;
    var phi_3472_: u32;
    var phi_1175_: u32;
    var phi_1178_: lt_bvh_Hit;
    var phi_3473_: lt_bvh_Hit;
    var phi_3474_: lt_bvh_Hit;
    var phi_3475_: bool;
    var phi_3479_: lt_bvh_Hit;
    var phi_3666_: f32;
    var phi_3671_: f32;
    var phi_3676_: f32;
    var phi_3684_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3758_: vec3<f32>;
    var phi_4001_: vec3<f32>;
    var phi_4016_: u32;
    var phi_4043_: f32;
    var phi_4050_: f32;
    var phi_4057_: f32;
    var phi_4092_: f32;
    var phi_4099_: f32;
    var phi_4106_: f32;
    var phi_4144_: f32;
    var phi_4151_: f32;
    var phi_4158_: f32;
    var phi_4244_: vec3<f32>;
    var phi_4245_: vec3<f32>;
    var phi_4246_: vec3<f32>;
    var phi_4255_: f32;
    var phi_4256_: f32;
    var phi_4266_: f32;
    var phi_4267_: f32;
    var phi_4277_: f32;
    var phi_4278_: f32;
    var phi_4313_: abi_Sample;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&materials.member));
    let _e93 = arrayLength((&instances.member));
    let _e96 = arrayLength((&alpha_texels.member));
    let _e99 = arrayLength((&color_texels.member));
    let _e102 = p.member.size[0u];
    let _e104 = p.member.size[1u];
    let _e105 = lt_shaders_entry_pixel_index(_e74, _e102, _e104);
    if (bitcast<i32>(_e105.word) != 0i) {
        let _e111 = p.member.root;
        let _e115 = p.member.eye;
        let _e120 = p.member.size[0u];
        let _e124 = ((((f32(_e74.x) + 0.5f) / f32(_e120)) * 2f) - 1f);
        let _e129 = p.member.size[1u];
        let _e133 = (1f - (((f32(_e74.y) + 0.5f) / f32(_e129)) * 2f));
        let _e135 = p.member.forward;
        let _e137 = p.member.right;
        let _e151 = p.member.up;
        let _e162 = _lt_bvh_ray_Ray_new(_e115, vec3<f32>(((_e135.x + (_e137.x * _e124)) + (_e151.x * _e133)), ((_e135.y + (_e137.y * _e124)) + (_e151.y * _e133)), ((_e135.z + (_e137.z * _e124)) + (_e151.z * _e133))));
        let _e164 = lt_bvh_Hit(_e162.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e167 = abs(_e162.direction.x);
        let _e169 = abs(_e162.direction.y);
        let _e171 = abs(_e162.direction.z);
        if (abs(_e162.origin.x) < 1000000000000000f) {
            if (abs(_e162.origin.y) < 1000000000000000f) {
                phi_787_ = (abs(_e162.origin.z) < 1000000000000000f);
                phi_788_ = false;
            } else {
                phi_787_ = bool();
                phi_788_ = true;
            }
            let _e183 = phi_787_;
            let _e185 = phi_788_;
            phi_789_ = _e183;
            phi_790_ = _e185;
        } else {
            phi_789_ = bool();
            phi_790_ = true;
        }
        let _e187 = phi_789_;
        let _e189 = phi_790_;
        if _e189 {
            phi_794_ = false;
        } else {
            phi_794_ = _e187;
        }
        let _e191 = phi_794_;
        if _e191 {
            if (_e167 < 1000000000000000f) {
                if (_e169 < 1000000000000000f) {
                    phi_807_ = (_e171 < 1000000000000000f);
                    phi_808_ = false;
                } else {
                    phi_807_ = bool();
                    phi_808_ = true;
                }
                let _e196 = phi_807_;
                let _e198 = phi_808_;
                phi_809_ = _e196;
                phi_810_ = _e198;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
            }
            let _e200 = phi_809_;
            let _e202 = phi_810_;
            if _e202 {
                phi_814_ = false;
            } else {
                phi_814_ = _e200;
            }
            let _e204 = phi_814_;
            if _e204 {
                if (_e167 > 0f) {
                    phi_828_ = bool();
                    phi_829_ = true;
                } else {
                    let _e206 = (_e169 > 0f);
                    if _e206 {
                        phi_827_ = bool();
                    } else {
                        phi_827_ = (_e171 > 0f);
                    }
                    let _e209 = phi_827_;
                    phi_828_ = _e209;
                    phi_829_ = _e206;
                }
                let _e211 = phi_828_;
                let _e213 = phi_829_;
                if _e213 {
                    phi_833_ = true;
                } else {
                    phi_833_ = _e211;
                }
                let _e215 = phi_833_;
                phi_834_ = _e215;
                phi_835_ = false;
            } else {
                phi_834_ = bool();
                phi_835_ = true;
            }
            let _e217 = phi_834_;
            let _e219 = phi_835_;
            phi_836_ = _e217;
            phi_837_ = _e219;
        } else {
            phi_836_ = bool();
            phi_837_ = true;
        }
        let _e221 = phi_836_;
        let _e223 = phi_837_;
        if _e223 {
            phi_841_ = false;
        } else {
            phi_841_ = _e221;
        }
        let _e225 = phi_841_;
        if _e225 {
            let _e226 = (_e111 >= _e78);
            if _e226 {
                phi_3473_ = lt_bvh_Hit();
            } else {
                if (_e111 < _e78) {
                } else {
                    return;
                }
                let _e232 = nodes.member[(0u + _e111)].frame[0u];
                let _e236 = nodes.member[(0u + _e111)].frame[1u];
                let _e240 = nodes.member[(0u + _e111)].frame[2u];
                let _e244 = nodes.member[(0u + _e111)].frame[0u];
                let _e248 = nodes.member[(0u + _e111)].frame[1u];
                let _e252 = nodes.member[(0u + _e111)].frame[2u];
                let _e256 = nodes.member[(0u + _e111)].frame[3u];
                let _e295 = core_intrinsics_maximum_number_nsz_f32_(abs(_e162.direction.x), abs(_e162.direction.y));
                let _e296 = core_intrinsics_maximum_number_nsz_f32_(_e295, abs(_e162.direction.z));
                let _e297 = (_e296 * 0.0000000000009094947f);
                if (abs(_e162.direction.x) < _e297) {
                    phi_917_ = _e297;
                } else {
                    phi_917_ = abs(_e162.direction.x);
                }
                let _e303 = phi_917_;
                if (_e162.direction.x < 0f) {
                    phi_924_ = (-1f / _e303);
                } else {
                    phi_924_ = (1f / _e303);
                }
                let _e308 = phi_924_;
                if (abs(_e162.direction.y) < _e297) {
                    phi_932_ = _e297;
                } else {
                    phi_932_ = abs(_e162.direction.y);
                }
                let _e314 = phi_932_;
                if (_e162.direction.y < 0f) {
                    phi_939_ = (-1f / _e314);
                } else {
                    phi_939_ = (1f / _e314);
                }
                let _e319 = phi_939_;
                if (abs(_e162.direction.z) < _e297) {
                    phi_947_ = _e297;
                } else {
                    phi_947_ = abs(_e162.direction.z);
                }
                let _e325 = phi_947_;
                if (_e162.direction.z < 0f) {
                    phi_954_ = (-1f / _e325);
                } else {
                    phi_954_ = (1f / _e325);
                }
                let _e330 = phi_954_;
                let _e337 = abs((bitcast<f32>(_e232) - _e162.origin.x));
                let _e338 = abs((bitcast<f32>(_e236) - _e162.origin.y));
                let _e339 = abs((bitcast<f32>(_e240) - _e162.origin.z));
                let _e346 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e256 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.x));
                let _e347 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e256 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.y));
                let _e348 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e256 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.z));
                if (_e337 > _e346) {
                    phi_977_ = _e337;
                } else {
                    phi_977_ = _e346;
                }
                let _e351 = phi_977_;
                if (_e338 > _e347) {
                    phi_982_ = _e338;
                } else {
                    phi_982_ = _e347;
                }
                let _e354 = phi_982_;
                if (_e339 > _e348) {
                    phi_987_ = _e339;
                } else {
                    phi_987_ = _e348;
                }
                let _e357 = phi_987_;
                if (_e351 > _e354) {
                    phi_992_ = _e351;
                } else {
                    phi_992_ = _e354;
                }
                let _e360 = phi_992_;
                if (_e360 > _e357) {
                    phi_997_ = _e360;
                } else {
                    phi_997_ = _e357;
                }
                let _e363 = phi_997_;
                let _e367 = (_e363 * 0.0000019073486f);
                let _e368 = (abs(_e308) * _e367);
                let _e369 = (abs(_e319) * _e367);
                let _e370 = (abs(_e330) * _e367);
                let _e374 = (_e363 * 0.0000009536743f);
                let _e375 = (abs(_e308) * _e374);
                let _e376 = (abs(_e319) * _e374);
                let _e377 = (abs(_e330) * _e374);
                if (_e308 < 0f) {
                    phi_1016_ = 0u;
                } else {
                    phi_1016_ = 1u;
                }
                let _e380 = phi_1016_;
                if (_e319 < 0f) {
                    phi_1021_ = 0u;
                } else {
                    phi_1021_ = 2u;
                }
                let _e383 = phi_1021_;
                if (_e330 < 0f) {
                    phi_1026_ = 0u;
                } else {
                    phi_1026_ = 4u;
                }
                let _e386 = phi_1026_;
                let _e388 = ((_e380 | _e383) | _e386);
                let _e389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e111, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e389.first[0], _e389.first[1], _e389.first[2], _e389.first[3], _e389.first[4], _e389.first[5], _e389.first[6], _e389.first[7], _e389.first[8], _e389.first[9], _e389.first[10], _e389.first[11], _e389.first[12], _e389.first[13], _e389.first[14], _e389.first[15], _e389.first[16], _e389.first[17], _e389.first[18], _e389.first[19], _e389.first[20], _e389.first[21], _e389.first[22], _e389.first[23], _e389.first[24], _e389.first[25], _e389.first[26], _e389.first[27], _e389.first[28], _e389.first[29], _e389.first[30], _e389.first[31]), array<u32, 32>(_e389.mask[0], _e389.mask[1], _e389.mask[2], _e389.mask[3], _e389.mask[4], _e389.mask[5], _e389.mask[6], _e389.mask[7], _e389.mask[8], _e389.mask[9], _e389.mask[10], _e389.mask[11], _e389.mask[12], _e389.mask[13], _e389.mask[14], _e389.mask[15], _e389.mask[16], _e389.mask[17], _e389.mask[18], _e389.mask[19], _e389.mask[20], _e389.mask[21], _e389.mask[22], _e389.mask[23], _e389.mask[24], _e389.mask[25], _e389.mask[26], _e389.mask[27], _e389.mask[28], _e389.mask[29], _e389.mask[30], _e389.mask[31]), _e389.len, _e389.group, _e389.group_mask);
                let _e463 = local_3.group_mask;
                if ((_e463 & 4278190080u) == 0u) {
                    let _e467 = local_3.len;
                    if (_e467 == 0u) {
                        phi_1140_ = false;
                    } else {
                        let _e471 = local_3.len;
                        local_3.len = (_e471 - 1u);
                        let _e474 = local_3.len;
                        if (_e474 < 32u) {
                        } else {
                            return;
                        }
                        let _e479 = local_3.first[(0u + _e474)];
                        local_3.group = _e479;
                        let _e482 = local_3.len;
                        if (_e482 < 32u) {
                        } else {
                            return;
                        }
                        let _e487 = local_3.mask[(0u + _e482)];
                        local_3.group_mask = _e487;
                        phi_1140_ = true;
                    }
                    let _e490 = phi_1140_;
                    phi_1141_ = _e490;
                } else {
                    phi_1141_ = true;
                }
                let _e492 = phi_1141_;
                if _e492 {
                    let _e494 = local_3.group_mask;
                    let _e500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u)));
                    let _e504 = local_3.group_mask;
                    let _e518 = local_3.group_mask;
                    local_3.group_mask = (_e518 & ~((1u << bitcast<u32>((_e500 & 31u)))));
                    let _e521 = local_3.group;
                    phi_1172_ = (_e521 + countOneBits(((_e504 & ~((4294967295u << bitcast<u32>((((_e500 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1172_ = 4294967295u;
                }
                let _e524 = phi_1172_;
                phi_1174_ = _e524;
                phi_1177_ = _e164;
                loop {
                    let _e526 = phi_1174_;
                    let _e528 = phi_1177_;
                    local_13 = _e528;
                    let _e529 = (_e526 != 4294967295u);
                    if _e529 {
                        if (_e526 < _e78) {
                        } else {
                            return;
                        }
                        let _e537 = nodes.member[(0u + _e526)].frame[3u];
                        let _e562 = (bitcast<f32>((((_e537 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e563 = (bitcast<f32>((((_e537 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e319);
                        let _e564 = (bitcast<f32>((((_e537 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e330);
                        let _e567 = nodes.member[(0u + _e526)].frame[0u];
                        let _e571 = nodes.member[(0u + _e526)].frame[1u];
                        let _e575 = nodes.member[(0u + _e526)].frame[2u];
                        let _e583 = ((bitcast<f32>(_e567) - _e162.origin.x) * _e308);
                        let _e584 = ((bitcast<f32>(_e571) - _e162.origin.y) * _e319);
                        let _e585 = ((bitcast<f32>(_e575) - _e162.origin.z) * _e330);
                        let _e593 = nodes.member[(0u + _e526)].x;
                        if (_e308 < 0f) {
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e593.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e604.unnamed.word, _e593.w), _e604.unnamed_1);
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_mask_LightPlace(_e593.x, _e610.unnamed_1.shift));
                            phi_1262_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e616.unnamed, lt_mask_LightPlace(_e616.unnamed_1.word, _e593.y));
                        } else {
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e593.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.unnamed.word, _e593.y), _e632.unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_mask_LightPlace(_e593.z, _e638.unnamed_1.shift));
                            phi_1262_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_mask_LightPlace(_e644.unnamed_1.word, _e593.w));
                        }
                        let _e652 = phi_1262_;
                        let _e662 = nodes.member[(0u + _e526)].y;
                        if (_e319 < 0f) {
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e673.unnamed.word, _e662.w), _e673.unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_mask_LightPlace(_e662.x, _e679.unnamed_1.shift));
                            phi_1289_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_mask_LightPlace(_e685.unnamed_1.word, _e662.y));
                        } else {
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.unnamed.word, _e662.y), _e701.unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_mask_LightPlace(_e662.z, _e707.unnamed_1.shift));
                            phi_1289_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_mask_LightPlace(_e713.unnamed_1.word, _e662.w));
                        }
                        let _e721 = phi_1289_;
                        let _e731 = nodes.member[(0u + _e526)].z;
                        if (_e330 < 0f) {
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e742.unnamed.word, _e731.w), _e742.unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_mask_LightPlace(_e731.x, _e748.unnamed_1.shift));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_mask_LightPlace(_e754.unnamed_1.word, _e731.y));
                        } else {
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e770.unnamed.word, _e731.y), _e770.unnamed_1);
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_mask_LightPlace(_e731.z, _e776.unnamed_1.shift));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_mask_LightPlace(_e782.unnamed_1.word, _e731.w));
                        }
                        let _e790 = phi_1316_;
                        phi_1322_ = 0u;
                        phi_1325_ = 0u;
                        loop {
                            let _e800 = phi_1322_;
                            let _e802 = phi_1325_;
                            local_4 = _e802;
                            local_5 = _e802;
                            local_6 = _e802;
                            let _e803 = (_e800 < 8u);
                            if _e803 {
                                let _e805 = (_e800 >> bitcast<u32>(2i));
                                let _e806 = (_e800 & 3u);
                                if (_e805 == 0u) {
                                    phi_1339_ = _e652.unnamed.word;
                                } else {
                                    phi_1339_ = _e652.unnamed.shift;
                                }
                                let _e809 = phi_1339_;
                                if (_e805 == 0u) {
                                    phi_1349_ = _e721.unnamed.word;
                                } else {
                                    phi_1349_ = _e721.unnamed.shift;
                                }
                                let _e818 = phi_1349_;
                                if (_e805 == 0u) {
                                    phi_1359_ = _e790.unnamed.word;
                                } else {
                                    phi_1359_ = _e790.unnamed.shift;
                                }
                                let _e827 = phi_1359_;
                                let _e840 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e809 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e562) + (_e583 - _e368)), ((f32(((_e818 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)));
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(_e840, ((f32(((_e827 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                if (_e805 == 0u) {
                                    phi_1377_ = _e652.unnamed_1.word;
                                } else {
                                    phi_1377_ = _e652.unnamed_1.shift;
                                }
                                let _e844 = phi_1377_;
                                if (_e805 == 0u) {
                                    phi_1387_ = _e721.unnamed_1.word;
                                } else {
                                    phi_1387_ = _e721.unnamed_1.shift;
                                }
                                let _e853 = phi_1387_;
                                if (_e805 == 0u) {
                                    phi_1397_ = _e790.unnamed_1.word;
                                } else {
                                    phi_1397_ = _e790.unnamed_1.shift;
                                }
                                let _e862 = phi_1397_;
                                let _e875 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e562) + (_e583 + _e368)), ((f32(((_e853 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)));
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                if (_e841 <= _e876) {
                                    if (_e841 <= _e528.t) {
                                        if (_e876 >= _e162.tmin) {
                                            if (_e805 == 0u) {
                                                let _e883 = nodes.member[(0u + _e526)].links[2u];
                                                phi_1433_ = _e883;
                                            } else {
                                                let _e886 = nodes.member[(0u + _e526)].links[3u];
                                                phi_1433_ = _e886;
                                            }
                                            let _e888 = phi_1433_;
                                            let _e893 = ((_e888 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u);
                                            let _e894 = (_e893 & 31u);
                                            if (_e894 >= 24u) {
                                                phi_1446_ = (24u + ((_e894 - 24u) ^ _e388));
                                            } else {
                                                phi_1446_ = _e894;
                                            }
                                            let _e900 = phi_1446_;
                                            phi_1451_ = (_e802 | ((_e893 >> bitcast<u32>(5i)) << bitcast<u32>((_e900 & 31u))));
                                        } else {
                                            phi_1451_ = _e802;
                                        }
                                        let _e908 = phi_1451_;
                                        phi_1452_ = _e908;
                                    } else {
                                        phi_1452_ = _e802;
                                    }
                                    let _e910 = phi_1452_;
                                    phi_1453_ = _e910;
                                } else {
                                    phi_1453_ = _e802;
                                }
                                let _e912 = phi_1453_;
                                phi_1323_ = (_e800 + 1u);
                                phi_1326_ = _e912;
                            } else {
                                phi_1323_ = u32();
                                phi_1326_ = u32();
                            }
                            let _e915 = phi_1323_;
                            let _e917 = phi_1326_;
                            continue;
                            continuing {
                                phi_1322_ = _e915;
                                phi_1325_ = _e917;
                                break if !(_e803);
                            }
                        }
                        let _e921 = nodes.member[(0u + _e526)].links[0u];
                        let _e925 = nodes.member[(0u + _e526)].frame[3u];
                        let _e929 = local_4;
                        if ((_e929 & 4278190080u) == 0u) {
                        } else {
                            let _e933 = local_3.group_mask;
                            if ((_e933 & 4278190080u) == 0u) {
                            } else {
                                let _e937 = local_3.len;
                                if (_e937 < 32u) {
                                    let _e940 = local_3.group;
                                    let _e942 = local_3.len;
                                    if (_e942 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e942)] = _e940;
                                    let _e948 = local_3.group_mask;
                                    let _e950 = local_3.len;
                                    if (_e950 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e950)] = _e948;
                                    let _e957 = local_3.len;
                                    local_3.len = (_e957 + 1u);
                                }
                            }
                            local_3.group = (_e111 + _e921);
                            let _e961 = local_5;
                            local_3.group_mask = ((_e961 & 4278190080u) | (_e925 >> bitcast<u32>(24i)));
                        }
                        let _e966 = local_6;
                        phi_1511_ = (_e966 & 16777215u);
                        phi_1514_ = _e528;
                        loop {
                            let _e969 = phi_1511_;
                            let _e971 = phi_1514_;
                            local_12 = _e971;
                            if (_e969 == 0u) {
                                phi_1512_ = u32();
                                phi_1515_ = lt_bvh_Hit();
                                phi_3401_ = false;
                            } else {
                                let _e975 = nodes.member[(0u + _e526)].links[1u];
                                let _e979 = (_e975 + select(firstTrailingBit(_e969), 32u, (_e969 == 0u)));
                                if (_e979 < _e93) {
                                } else {
                                    return;
                                }
                                let _e986 = instances.member[(0u + _e979)].low_world;
                                let _e988 = instances.member[(0u + _e979)].high_world;
                                let _e998 = ((_e986.x - _e162.origin.x) * _e308);
                                let _e999 = ((_e986.y - _e162.origin.y) * _e319);
                                let _e1000 = ((_e986.z - _e162.origin.z) * _e330);
                                let _e1010 = ((_e988.x - _e162.origin.x) * _e308);
                                let _e1011 = ((_e988.y - _e162.origin.y) * _e319);
                                let _e1012 = ((_e988.z - _e162.origin.z) * _e330);
                                if (_e998 < _e1010) {
                                    phi_1569_ = _e998;
                                } else {
                                    phi_1569_ = _e1010;
                                }
                                let _e1015 = phi_1569_;
                                if (_e999 < _e1011) {
                                    phi_1574_ = _e999;
                                } else {
                                    phi_1574_ = _e1011;
                                }
                                let _e1018 = phi_1574_;
                                if (_e1000 < _e1012) {
                                    phi_1579_ = _e1000;
                                } else {
                                    phi_1579_ = _e1012;
                                }
                                let _e1021 = phi_1579_;
                                if (_e998 > _e1010) {
                                    phi_1587_ = _e998;
                                } else {
                                    phi_1587_ = _e1010;
                                }
                                let _e1027 = phi_1587_;
                                if (_e999 > _e1011) {
                                    phi_1592_ = _e999;
                                } else {
                                    phi_1592_ = _e1011;
                                }
                                let _e1030 = phi_1592_;
                                if (_e1000 > _e1012) {
                                    phi_1597_ = _e1000;
                                } else {
                                    phi_1597_ = _e1012;
                                }
                                let _e1033 = phi_1597_;
                                let _e1037 = core_intrinsics_maximum_number_nsz_f32_((_e1015 - _e375), (_e1018 - _e376));
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_(_e1037, (_e1021 - _e377));
                                let _e1039 = core_intrinsics_minimum_number_nsz_f32_((_e1027 + _e375), (_e1030 + _e376));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_(_e1039, (_e1033 + _e377));
                                if (_e1038 <= _e1040) {
                                    if (_e1038 <= _e971.t) {
                                        if (_e1040 >= _e162.tmin) {
                                            let _e1052 = instances.member[(0u + _e979)].world_to_object[0u];
                                            let _e1063 = ((((_e1052.x * _e162.origin.x) + (_e1052.y * _e162.origin.y)) + (_e1052.z * _e162.origin.z)) + (_e1052.w * 1f));
                                            let _e1065 = instances.member[(0u + _e979)].world_to_object[1u];
                                            let _e1076 = ((((_e1065.x * _e162.origin.x) + (_e1065.y * _e162.origin.y)) + (_e1065.z * _e162.origin.z)) + (_e1065.w * 1f));
                                            let _e1078 = instances.member[(0u + _e979)].world_to_object[2u];
                                            let _e1089 = ((((_e1078.x * _e162.origin.x) + (_e1078.y * _e162.origin.y)) + (_e1078.z * _e162.origin.z)) + (_e1078.w * 1f));
                                            let _e1096 = instances.member[(0u + _e979)].world_to_object[0u];
                                            let _e1107 = ((((_e1096.x * _e162.direction.x) + (_e1096.y * _e162.direction.y)) + (_e1096.z * _e162.direction.z)) + (_e1096.w * 0f));
                                            let _e1109 = instances.member[(0u + _e979)].world_to_object[1u];
                                            let _e1120 = ((((_e1109.x * _e162.direction.x) + (_e1109.y * _e162.direction.y)) + (_e1109.z * _e162.direction.z)) + (_e1109.w * 0f));
                                            let _e1122 = instances.member[(0u + _e979)].world_to_object[2u];
                                            let _e1133 = ((((_e1122.x * _e162.direction.x) + (_e1122.y * _e162.direction.y)) + (_e1122.z * _e162.direction.z)) + (_e1122.w * 0f));
                                            let _e1138 = instances.member[(0u + _e979)].root;
                                            let _e1140 = instances.member[(0u + _e979)].first_triangle;
                                            let _e1141 = abs(_e1107);
                                            let _e1142 = abs(_e1120);
                                            let _e1143 = abs(_e1133);
                                            if (abs(_e1063) < 1000000000000000f) {
                                                if (abs(_e1076) < 1000000000000000f) {
                                                    phi_1729_ = (abs(_e1089) < 1000000000000000f);
                                                    phi_1730_ = false;
                                                } else {
                                                    phi_1729_ = bool();
                                                    phi_1730_ = true;
                                                }
                                                let _e1151 = phi_1729_;
                                                let _e1153 = phi_1730_;
                                                phi_1731_ = _e1151;
                                                phi_1732_ = _e1153;
                                            } else {
                                                phi_1731_ = bool();
                                                phi_1732_ = true;
                                            }
                                            let _e1155 = phi_1731_;
                                            let _e1157 = phi_1732_;
                                            if _e1157 {
                                                phi_1736_ = false;
                                            } else {
                                                phi_1736_ = _e1155;
                                            }
                                            let _e1159 = phi_1736_;
                                            if _e1159 {
                                                if (_e1141 < 1000000000000000f) {
                                                    if (_e1142 < 1000000000000000f) {
                                                        phi_1749_ = (_e1143 < 1000000000000000f);
                                                        phi_1750_ = false;
                                                    } else {
                                                        phi_1749_ = bool();
                                                        phi_1750_ = true;
                                                    }
                                                    let _e1164 = phi_1749_;
                                                    let _e1166 = phi_1750_;
                                                    phi_1751_ = _e1164;
                                                    phi_1752_ = _e1166;
                                                } else {
                                                    phi_1751_ = bool();
                                                    phi_1752_ = true;
                                                }
                                                let _e1168 = phi_1751_;
                                                let _e1170 = phi_1752_;
                                                if _e1170 {
                                                    phi_1756_ = false;
                                                } else {
                                                    phi_1756_ = _e1168;
                                                }
                                                let _e1172 = phi_1756_;
                                                if _e1172 {
                                                    if (_e1141 > 0f) {
                                                        phi_1770_ = bool();
                                                        phi_1771_ = true;
                                                    } else {
                                                        let _e1174 = (_e1142 > 0f);
                                                        if _e1174 {
                                                            phi_1769_ = bool();
                                                        } else {
                                                            phi_1769_ = (_e1143 > 0f);
                                                        }
                                                        let _e1177 = phi_1769_;
                                                        phi_1770_ = _e1177;
                                                        phi_1771_ = _e1174;
                                                    }
                                                    let _e1179 = phi_1770_;
                                                    let _e1181 = phi_1771_;
                                                    if _e1181 {
                                                        phi_1775_ = true;
                                                    } else {
                                                        phi_1775_ = _e1179;
                                                    }
                                                    let _e1183 = phi_1775_;
                                                    phi_1776_ = _e1183;
                                                    phi_1777_ = false;
                                                } else {
                                                    phi_1776_ = bool();
                                                    phi_1777_ = true;
                                                }
                                                let _e1185 = phi_1776_;
                                                let _e1187 = phi_1777_;
                                                phi_1778_ = _e1185;
                                                phi_1779_ = _e1187;
                                            } else {
                                                phi_1778_ = bool();
                                                phi_1779_ = true;
                                            }
                                            let _e1189 = phi_1778_;
                                            let _e1191 = phi_1779_;
                                            if _e1191 {
                                                phi_1783_ = false;
                                            } else {
                                                phi_1783_ = _e1189;
                                            }
                                            let _e1193 = phi_1783_;
                                            if _e1193 {
                                                let _e1194 = (_e1138 >= _e78);
                                                if _e1194 {
                                                    phi_3391_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1138 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1200 = nodes.member[(0u + _e1138)].frame[0u];
                                                    let _e1204 = nodes.member[(0u + _e1138)].frame[1u];
                                                    let _e1208 = nodes.member[(0u + _e1138)].frame[2u];
                                                    let _e1212 = nodes.member[(0u + _e1138)].frame[0u];
                                                    let _e1216 = nodes.member[(0u + _e1138)].frame[1u];
                                                    let _e1220 = nodes.member[(0u + _e1138)].frame[2u];
                                                    let _e1224 = nodes.member[(0u + _e1138)].frame[3u];
                                                    let _e1258 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1107), abs(_e1120));
                                                    let _e1259 = core_intrinsics_maximum_number_nsz_f32_(_e1258, abs(_e1133));
                                                    let _e1260 = (_e1259 * 0.0000000000009094947f);
                                                    if (abs(_e1107) < _e1260) {
                                                        phi_1853_ = _e1260;
                                                    } else {
                                                        phi_1853_ = abs(_e1107);
                                                    }
                                                    let _e1265 = phi_1853_;
                                                    if (_e1107 < 0f) {
                                                        phi_1860_ = (-1f / _e1265);
                                                    } else {
                                                        phi_1860_ = (1f / _e1265);
                                                    }
                                                    let _e1270 = phi_1860_;
                                                    if (abs(_e1120) < _e1260) {
                                                        phi_1867_ = _e1260;
                                                    } else {
                                                        phi_1867_ = abs(_e1120);
                                                    }
                                                    let _e1275 = phi_1867_;
                                                    if (_e1120 < 0f) {
                                                        phi_1874_ = (-1f / _e1275);
                                                    } else {
                                                        phi_1874_ = (1f / _e1275);
                                                    }
                                                    let _e1280 = phi_1874_;
                                                    if (abs(_e1133) < _e1260) {
                                                        phi_1881_ = _e1260;
                                                    } else {
                                                        phi_1881_ = abs(_e1133);
                                                    }
                                                    let _e1285 = phi_1881_;
                                                    if (_e1133 < 0f) {
                                                        phi_1888_ = (-1f / _e1285);
                                                    } else {
                                                        phi_1888_ = (1f / _e1285);
                                                    }
                                                    let _e1290 = phi_1888_;
                                                    let _e1294 = abs((bitcast<f32>(_e1200) - _e1063));
                                                    let _e1295 = abs((bitcast<f32>(_e1204) - _e1076));
                                                    let _e1296 = abs((bitcast<f32>(_e1208) - _e1089));
                                                    let _e1300 = abs(((bitcast<f32>(_e1212) + (bitcast<f32>((((_e1224 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1063));
                                                    let _e1301 = abs(((bitcast<f32>(_e1216) + (bitcast<f32>((((_e1224 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1076));
                                                    let _e1302 = abs(((bitcast<f32>(_e1220) + (bitcast<f32>((((_e1224 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    if (_e1294 > _e1300) {
                                                        phi_1905_ = _e1294;
                                                    } else {
                                                        phi_1905_ = _e1300;
                                                    }
                                                    let _e1305 = phi_1905_;
                                                    if (_e1295 > _e1301) {
                                                        phi_1910_ = _e1295;
                                                    } else {
                                                        phi_1910_ = _e1301;
                                                    }
                                                    let _e1308 = phi_1910_;
                                                    if (_e1296 > _e1302) {
                                                        phi_1915_ = _e1296;
                                                    } else {
                                                        phi_1915_ = _e1302;
                                                    }
                                                    let _e1311 = phi_1915_;
                                                    if (_e1305 > _e1308) {
                                                        phi_1920_ = _e1305;
                                                    } else {
                                                        phi_1920_ = _e1308;
                                                    }
                                                    let _e1314 = phi_1920_;
                                                    if (_e1314 > _e1311) {
                                                        phi_1925_ = _e1314;
                                                    } else {
                                                        phi_1925_ = _e1311;
                                                    }
                                                    let _e1317 = phi_1925_;
                                                    let _e1321 = (_e1317 * 0.0000019073486f);
                                                    let _e1322 = (abs(_e1270) * _e1321);
                                                    let _e1323 = (abs(_e1280) * _e1321);
                                                    let _e1324 = (abs(_e1290) * _e1321);
                                                    let _e1328 = (_e1317 * 0.0000009536743f);
                                                    let _e1329 = (abs(_e1270) * _e1328);
                                                    let _e1330 = (abs(_e1280) * _e1328);
                                                    let _e1331 = (abs(_e1290) * _e1328);
                                                    let _e1332 = abs(_e1107);
                                                    let _e1333 = abs(_e1120);
                                                    let _e1334 = abs(_e1133);
                                                    if (_e1332 >= _e1333) {
                                                        if (_e1332 >= _e1334) {
                                                            phi_1951_ = false;
                                                        } else {
                                                            phi_1951_ = true;
                                                        }
                                                        let _e1338 = phi_1951_;
                                                        phi_1952_ = _e1338;
                                                    } else {
                                                        phi_1952_ = true;
                                                    }
                                                    let _e1340 = phi_1952_;
                                                    if _e1340 {
                                                        if (_e1333 >= _e1334) {
                                                            phi_1960_ = 1u;
                                                        } else {
                                                            phi_1960_ = 2u;
                                                        }
                                                        let _e1343 = phi_1960_;
                                                        phi_1961_ = _e1343;
                                                    } else {
                                                        phi_1961_ = 0u;
                                                    }
                                                    let _e1345 = phi_1961_;
                                                    if (_e1345 == 0u) {
                                                        phi_1973_ = vec3<f32>(_e1120, _e1133, _e1107);
                                                    } else {
                                                        if (_e1345 == 1u) {
                                                            phi_1972_ = vec3<f32>(_e1133, _e1107, _e1120);
                                                        } else {
                                                            phi_1972_ = vec3<f32>(_e1107, _e1120, _e1133);
                                                        }
                                                        let _e1351 = phi_1972_;
                                                        phi_1973_ = _e1351;
                                                    }
                                                    let _e1353 = phi_1973_;
                                                    let _e1356 = (_e1353.x / _e1353.z);
                                                    let _e1359 = (_e1353.y / _e1353.z);
                                                    if (_e1270 < 0f) {
                                                        phi_1986_ = 0u;
                                                    } else {
                                                        phi_1986_ = 1u;
                                                    }
                                                    let _e1364 = phi_1986_;
                                                    if (_e1280 < 0f) {
                                                        phi_1991_ = 0u;
                                                    } else {
                                                        phi_1991_ = 2u;
                                                    }
                                                    let _e1367 = phi_1991_;
                                                    if (_e1290 < 0f) {
                                                        phi_1996_ = 0u;
                                                    } else {
                                                        phi_1996_ = 4u;
                                                    }
                                                    let _e1370 = phi_1996_;
                                                    let _e1372 = ((_e1364 | _e1367) | _e1370);
                                                    let _e1373 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1138, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1373.first[0], _e1373.first[1], _e1373.first[2], _e1373.first[3], _e1373.first[4], _e1373.first[5], _e1373.first[6], _e1373.first[7], _e1373.first[8], _e1373.first[9], _e1373.first[10], _e1373.first[11], _e1373.first[12], _e1373.first[13], _e1373.first[14], _e1373.first[15], _e1373.first[16], _e1373.first[17], _e1373.first[18], _e1373.first[19], _e1373.first[20], _e1373.first[21], _e1373.first[22], _e1373.first[23], _e1373.first[24], _e1373.first[25], _e1373.first[26], _e1373.first[27], _e1373.first[28], _e1373.first[29], _e1373.first[30], _e1373.first[31]), array<u32, 32>(_e1373.mask[0], _e1373.mask[1], _e1373.mask[2], _e1373.mask[3], _e1373.mask[4], _e1373.mask[5], _e1373.mask[6], _e1373.mask[7], _e1373.mask[8], _e1373.mask[9], _e1373.mask[10], _e1373.mask[11], _e1373.mask[12], _e1373.mask[13], _e1373.mask[14], _e1373.mask[15], _e1373.mask[16], _e1373.mask[17], _e1373.mask[18], _e1373.mask[19], _e1373.mask[20], _e1373.mask[21], _e1373.mask[22], _e1373.mask[23], _e1373.mask[24], _e1373.mask[25], _e1373.mask[26], _e1373.mask[27], _e1373.mask[28], _e1373.mask[29], _e1373.mask[30], _e1373.mask[31]), _e1373.len, _e1373.group, _e1373.group_mask);
                                                    let _e1447 = local_2.group_mask;
                                                    if ((_e1447 & 4278190080u) == 0u) {
                                                        let _e1451 = local_2.len;
                                                        if (_e1451 == 0u) {
                                                            phi_2110_ = false;
                                                        } else {
                                                            let _e1455 = local_2.len;
                                                            local_2.len = (_e1455 - 1u);
                                                            let _e1458 = local_2.len;
                                                            if (_e1458 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1463 = local_2.first[(0u + _e1458)];
                                                            local_2.group = _e1463;
                                                            let _e1466 = local_2.len;
                                                            if (_e1466 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1471 = local_2.mask[(0u + _e1466)];
                                                            local_2.group_mask = _e1471;
                                                            phi_2110_ = true;
                                                        }
                                                        let _e1474 = phi_2110_;
                                                        phi_2111_ = _e1474;
                                                    } else {
                                                        phi_2111_ = true;
                                                    }
                                                    let _e1476 = phi_2111_;
                                                    if _e1476 {
                                                        let _e1478 = local_2.group_mask;
                                                        let _e1484 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1478)), 32u, (_e1478 == 0u)));
                                                        let _e1488 = local_2.group_mask;
                                                        let _e1502 = local_2.group_mask;
                                                        local_2.group_mask = (_e1502 & ~((1u << bitcast<u32>((_e1484 & 31u)))));
                                                        let _e1505 = local_2.group;
                                                        phi_2142_ = (_e1505 + countOneBits(((_e1488 & ~((4294967295u << bitcast<u32>((((_e1484 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2142_ = 4294967295u;
                                                    }
                                                    let _e1508 = phi_2142_;
                                                    phi_2144_ = _e971;
                                                    phi_2147_ = _e1508;
                                                    loop {
                                                        let _e1510 = phi_2144_;
                                                        let _e1512 = phi_2147_;
                                                        local_11 = _e1510;
                                                        let _e1513 = (_e1512 != 4294967295u);
                                                        if _e1513 {
                                                            if (_e1512 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1520 = nodes.member[(0u + _e1512)].frame[3u];
                                                            let _e1545 = (bitcast<f32>((((_e1520 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1270);
                                                            let _e1546 = (bitcast<f32>((((_e1520 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1280);
                                                            let _e1547 = (bitcast<f32>((((_e1520 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1290);
                                                            let _e1550 = nodes.member[(0u + _e1512)].frame[0u];
                                                            let _e1554 = nodes.member[(0u + _e1512)].frame[1u];
                                                            let _e1558 = nodes.member[(0u + _e1512)].frame[2u];
                                                            let _e1563 = ((bitcast<f32>(_e1550) - _e1063) * _e1270);
                                                            let _e1564 = ((bitcast<f32>(_e1554) - _e1076) * _e1280);
                                                            let _e1565 = ((bitcast<f32>(_e1558) - _e1089) * _e1290);
                                                            let _e1573 = nodes.member[(0u + _e1512)].x;
                                                            if (_e1270 < 0f) {
                                                                let _e1584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1573.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1584.unnamed.word, _e1573.w), _e1584.unnamed_1);
                                                                let _e1596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1590.unnamed, lt_mask_LightPlace(_e1573.x, _e1590.unnamed_1.shift));
                                                                phi_2228_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1596.unnamed, lt_mask_LightPlace(_e1596.unnamed_1.word, _e1573.y));
                                                            } else {
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1573.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1612.unnamed.word, _e1573.y), _e1612.unnamed_1);
                                                                let _e1624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1618.unnamed, lt_mask_LightPlace(_e1573.z, _e1618.unnamed_1.shift));
                                                                phi_2228_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1624.unnamed, lt_mask_LightPlace(_e1624.unnamed_1.word, _e1573.w));
                                                            }
                                                            let _e1632 = phi_2228_;
                                                            let _e1642 = nodes.member[(0u + _e1512)].y;
                                                            if (_e1280 < 0f) {
                                                                let _e1653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1642.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1653.unnamed.word, _e1642.w), _e1653.unnamed_1);
                                                                let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1659.unnamed, lt_mask_LightPlace(_e1642.x, _e1659.unnamed_1.shift));
                                                                phi_2255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1665.unnamed, lt_mask_LightPlace(_e1665.unnamed_1.word, _e1642.y));
                                                            } else {
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1642.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1681.unnamed.word, _e1642.y), _e1681.unnamed_1);
                                                                let _e1693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1687.unnamed, lt_mask_LightPlace(_e1642.z, _e1687.unnamed_1.shift));
                                                                phi_2255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1693.unnamed, lt_mask_LightPlace(_e1693.unnamed_1.word, _e1642.w));
                                                            }
                                                            let _e1701 = phi_2255_;
                                                            let _e1711 = nodes.member[(0u + _e1512)].z;
                                                            if (_e1290 < 0f) {
                                                                let _e1722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1711.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1722.unnamed.word, _e1711.w), _e1722.unnamed_1);
                                                                let _e1734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1728.unnamed, lt_mask_LightPlace(_e1711.x, _e1728.unnamed_1.shift));
                                                                phi_2282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1734.unnamed, lt_mask_LightPlace(_e1734.unnamed_1.word, _e1711.y));
                                                            } else {
                                                                let _e1750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1711.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1750.unnamed.word, _e1711.y), _e1750.unnamed_1);
                                                                let _e1762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1756.unnamed, lt_mask_LightPlace(_e1711.z, _e1756.unnamed_1.shift));
                                                                phi_2282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1762.unnamed, lt_mask_LightPlace(_e1762.unnamed_1.word, _e1711.w));
                                                            }
                                                            let _e1770 = phi_2282_;
                                                            phi_2288_ = 0u;
                                                            phi_2291_ = 0u;
                                                            loop {
                                                                let _e1780 = phi_2288_;
                                                                let _e1782 = phi_2291_;
                                                                local_7 = _e1782;
                                                                local_8 = _e1782;
                                                                local_9 = _e1782;
                                                                let _e1783 = (_e1780 < 8u);
                                                                if _e1783 {
                                                                    let _e1785 = (_e1780 >> bitcast<u32>(2i));
                                                                    let _e1786 = (_e1780 & 3u);
                                                                    if (_e1785 == 0u) {
                                                                        phi_2305_ = _e1632.unnamed.word;
                                                                    } else {
                                                                        phi_2305_ = _e1632.unnamed.shift;
                                                                    }
                                                                    let _e1789 = phi_2305_;
                                                                    if (_e1785 == 0u) {
                                                                        phi_2315_ = _e1701.unnamed.word;
                                                                    } else {
                                                                        phi_2315_ = _e1701.unnamed.shift;
                                                                    }
                                                                    let _e1798 = phi_2315_;
                                                                    if (_e1785 == 0u) {
                                                                        phi_2325_ = _e1770.unnamed.word;
                                                                    } else {
                                                                        phi_2325_ = _e1770.unnamed.shift;
                                                                    }
                                                                    let _e1807 = phi_2325_;
                                                                    let _e1820 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1789 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u)) * _e1545) + (_e1563 - _e1322)), ((f32(((_e1798 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u)) * _e1546) + (_e1564 - _e1323)));
                                                                    let _e1821 = core_intrinsics_maximum_number_nsz_f32_(_e1820, ((f32(((_e1807 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u)) * _e1547) + (_e1565 - _e1324)));
                                                                    if (_e1785 == 0u) {
                                                                        phi_2343_ = _e1632.unnamed_1.word;
                                                                    } else {
                                                                        phi_2343_ = _e1632.unnamed_1.shift;
                                                                    }
                                                                    let _e1824 = phi_2343_;
                                                                    if (_e1785 == 0u) {
                                                                        phi_2353_ = _e1701.unnamed_1.word;
                                                                    } else {
                                                                        phi_2353_ = _e1701.unnamed_1.shift;
                                                                    }
                                                                    let _e1833 = phi_2353_;
                                                                    if (_e1785 == 0u) {
                                                                        phi_2363_ = _e1770.unnamed_1.word;
                                                                    } else {
                                                                        phi_2363_ = _e1770.unnamed_1.shift;
                                                                    }
                                                                    let _e1842 = phi_2363_;
                                                                    let _e1855 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1824 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u)) * _e1545) + (_e1563 + _e1322)), ((f32(((_e1833 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u)) * _e1546) + (_e1564 + _e1323)));
                                                                    let _e1856 = core_intrinsics_minimum_number_nsz_f32_(_e1855, ((f32(((_e1842 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u)) * _e1547) + (_e1565 + _e1324)));
                                                                    if (_e1821 <= _e1856) {
                                                                        if (_e1821 <= _e1510.t) {
                                                                            if (_e1856 >= _e162.tmin) {
                                                                                if (_e1785 == 0u) {
                                                                                    let _e1863 = nodes.member[(0u + _e1512)].links[2u];
                                                                                    phi_2399_ = _e1863;
                                                                                } else {
                                                                                    let _e1866 = nodes.member[(0u + _e1512)].links[3u];
                                                                                    phi_2399_ = _e1866;
                                                                                }
                                                                                let _e1868 = phi_2399_;
                                                                                let _e1873 = ((_e1868 >> bitcast<u32>(((_e1786 * 8u) & 31u))) & 255u);
                                                                                let _e1874 = (_e1873 & 31u);
                                                                                if (_e1874 >= 24u) {
                                                                                    phi_2412_ = (24u + ((_e1874 - 24u) ^ _e1372));
                                                                                } else {
                                                                                    phi_2412_ = _e1874;
                                                                                }
                                                                                let _e1880 = phi_2412_;
                                                                                phi_2417_ = (_e1782 | ((_e1873 >> bitcast<u32>(5i)) << bitcast<u32>((_e1880 & 31u))));
                                                                            } else {
                                                                                phi_2417_ = _e1782;
                                                                            }
                                                                            let _e1888 = phi_2417_;
                                                                            phi_2418_ = _e1888;
                                                                        } else {
                                                                            phi_2418_ = _e1782;
                                                                        }
                                                                        let _e1890 = phi_2418_;
                                                                        phi_2419_ = _e1890;
                                                                    } else {
                                                                        phi_2419_ = _e1782;
                                                                    }
                                                                    let _e1892 = phi_2419_;
                                                                    phi_2289_ = (_e1780 + 1u);
                                                                    phi_2292_ = _e1892;
                                                                } else {
                                                                    phi_2289_ = u32();
                                                                    phi_2292_ = u32();
                                                                }
                                                                let _e1895 = phi_2289_;
                                                                let _e1897 = phi_2292_;
                                                                continue;
                                                                continuing {
                                                                    phi_2288_ = _e1895;
                                                                    phi_2291_ = _e1897;
                                                                    break if !(_e1783);
                                                                }
                                                            }
                                                            let _e1901 = nodes.member[(0u + _e1512)].links[0u];
                                                            let _e1905 = nodes.member[(0u + _e1512)].frame[3u];
                                                            let _e1909 = local_7;
                                                            if ((_e1909 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1913 = local_2.group_mask;
                                                                if ((_e1913 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1917 = local_2.len;
                                                                    if (_e1917 < 32u) {
                                                                        let _e1920 = local_2.group;
                                                                        let _e1922 = local_2.len;
                                                                        if (_e1922 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1922)] = _e1920;
                                                                        let _e1928 = local_2.group_mask;
                                                                        let _e1930 = local_2.len;
                                                                        if (_e1930 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1930)] = _e1928;
                                                                        let _e1937 = local_2.len;
                                                                        local_2.len = (_e1937 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1138 + _e1901);
                                                                let _e1941 = local_8;
                                                                local_2.group_mask = ((_e1941 & 4278190080u) | (_e1905 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1946 = local_9;
                                                            phi_2477_ = _e1510;
                                                            phi_2480_ = (_e1946 & 16777215u);
                                                            loop {
                                                                let _e1949 = phi_2477_;
                                                                let _e1951 = phi_2480_;
                                                                local_10 = _e1949;
                                                                if (_e1951 == 0u) {
                                                                    phi_2478_ = lt_bvh_Hit();
                                                                    phi_2481_ = u32();
                                                                    phi_3319_ = false;
                                                                } else {
                                                                    let _e1955 = nodes.member[(0u + _e1512)].links[1u];
                                                                    let _e1960 = ((_e1140 + _e1955) + select(firstTrailingBit(_e1951), 32u, (_e1951 == 0u)));
                                                                    if (_e1960 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1967 = triangles.member[(0u + _e1960)].v0_;
                                                                    let _e1969 = (_e1967.x - _e1063);
                                                                    let _e1971 = (_e1967.y - _e1076);
                                                                    let _e1973 = (_e1967.z - _e1089);
                                                                    if (_e1345 == 0u) {
                                                                        phi_2525_ = vec3<f32>(_e1971, _e1973, _e1969);
                                                                    } else {
                                                                        if (_e1345 == 1u) {
                                                                            phi_2524_ = vec3<f32>(_e1973, _e1969, _e1971);
                                                                        } else {
                                                                            phi_2524_ = (_e1967 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e1981 = phi_2524_;
                                                                        phi_2525_ = _e1981;
                                                                    }
                                                                    let _e1983 = phi_2525_;
                                                                    let _e1987 = (_e1983.x - (_e1356 * _e1983.z));
                                                                    let _e1991 = (_e1983.y - (_e1359 * _e1983.z));
                                                                    let _e1993 = triangles.member[(0u + _e1960)].v1_;
                                                                    let _e1995 = (_e1993.x - _e1063);
                                                                    let _e1997 = (_e1993.y - _e1076);
                                                                    let _e1999 = (_e1993.z - _e1089);
                                                                    if (_e1345 == 0u) {
                                                                        phi_2555_ = vec3<f32>(_e1997, _e1999, _e1995);
                                                                    } else {
                                                                        if (_e1345 == 1u) {
                                                                            phi_2554_ = vec3<f32>(_e1999, _e1995, _e1997);
                                                                        } else {
                                                                            phi_2554_ = (_e1993 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e2007 = phi_2554_;
                                                                        phi_2555_ = _e2007;
                                                                    }
                                                                    let _e2009 = phi_2555_;
                                                                    let _e2013 = (_e2009.x - (_e1356 * _e2009.z));
                                                                    let _e2017 = (_e2009.y - (_e1359 * _e2009.z));
                                                                    let _e2019 = triangles.member[(0u + _e1960)].v2_;
                                                                    let _e2021 = (_e2019.x - _e1063);
                                                                    let _e2023 = (_e2019.y - _e1076);
                                                                    let _e2025 = (_e2019.z - _e1089);
                                                                    if (_e1345 == 0u) {
                                                                        phi_2585_ = vec3<f32>(_e2023, _e2025, _e2021);
                                                                    } else {
                                                                        if (_e1345 == 1u) {
                                                                            phi_2584_ = vec3<f32>(_e2025, _e2021, _e2023);
                                                                        } else {
                                                                            phi_2584_ = (_e2019 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e2033 = phi_2584_;
                                                                        phi_2585_ = _e2033;
                                                                    }
                                                                    let _e2035 = phi_2585_;
                                                                    let _e2039 = (_e2035.x - (_e1356 * _e2035.z));
                                                                    let _e2043 = (_e2035.y - (_e1359 * _e2035.z));
                                                                    if (_e2013 < _e2039) {
                                                                        phi_2604_ = true;
                                                                    } else {
                                                                        if (_e2013 == _e2039) {
                                                                            phi_2603_ = (_e2017 < _e2043);
                                                                        } else {
                                                                            phi_2603_ = false;
                                                                        }
                                                                        let _e2048 = phi_2603_;
                                                                        phi_2604_ = _e2048;
                                                                    }
                                                                    let _e2050 = phi_2604_;
                                                                    if _e2050 {
                                                                        phi_2608_ = _e2043;
                                                                        phi_2609_ = _e2039;
                                                                        phi_2610_ = _e2017;
                                                                        phi_2611_ = _e2013;
                                                                    } else {
                                                                        phi_2608_ = _e2017;
                                                                        phi_2609_ = _e2013;
                                                                        phi_2610_ = _e2043;
                                                                        phi_2611_ = _e2039;
                                                                    }
                                                                    let _e2052 = phi_2608_;
                                                                    let _e2054 = phi_2609_;
                                                                    let _e2056 = phi_2610_;
                                                                    let _e2058 = phi_2611_;
                                                                    let _e2061 = ((_e2058 * _e2052) - (_e2056 * _e2054));
                                                                    if _e2050 {
                                                                        phi_2619_ = -(_e2061);
                                                                    } else {
                                                                        phi_2619_ = _e2061;
                                                                    }
                                                                    let _e2064 = phi_2619_;
                                                                    if (_e2039 < _e1987) {
                                                                        phi_2630_ = true;
                                                                    } else {
                                                                        if (_e2039 == _e1987) {
                                                                            phi_2629_ = (_e2043 < _e1991);
                                                                        } else {
                                                                            phi_2629_ = false;
                                                                        }
                                                                        let _e2069 = phi_2629_;
                                                                        phi_2630_ = _e2069;
                                                                    }
                                                                    let _e2071 = phi_2630_;
                                                                    if _e2071 {
                                                                        phi_2634_ = _e1991;
                                                                        phi_2635_ = _e1987;
                                                                        phi_2636_ = _e2043;
                                                                        phi_2637_ = _e2039;
                                                                    } else {
                                                                        phi_2634_ = _e2043;
                                                                        phi_2635_ = _e2039;
                                                                        phi_2636_ = _e1991;
                                                                        phi_2637_ = _e1987;
                                                                    }
                                                                    let _e2073 = phi_2634_;
                                                                    let _e2075 = phi_2635_;
                                                                    let _e2077 = phi_2636_;
                                                                    let _e2079 = phi_2637_;
                                                                    let _e2082 = ((_e2079 * _e2073) - (_e2077 * _e2075));
                                                                    if _e2071 {
                                                                        phi_2645_ = -(_e2082);
                                                                    } else {
                                                                        phi_2645_ = _e2082;
                                                                    }
                                                                    let _e2085 = phi_2645_;
                                                                    if (_e1987 < _e2013) {
                                                                        phi_2656_ = true;
                                                                    } else {
                                                                        if (_e1987 == _e2013) {
                                                                            phi_2655_ = (_e1991 < _e2017);
                                                                        } else {
                                                                            phi_2655_ = false;
                                                                        }
                                                                        let _e2090 = phi_2655_;
                                                                        phi_2656_ = _e2090;
                                                                    }
                                                                    let _e2092 = phi_2656_;
                                                                    if _e2092 {
                                                                        phi_2660_ = _e2017;
                                                                        phi_2661_ = _e2013;
                                                                        phi_2662_ = _e1991;
                                                                        phi_2663_ = _e1987;
                                                                    } else {
                                                                        phi_2660_ = _e1991;
                                                                        phi_2661_ = _e1987;
                                                                        phi_2662_ = _e2017;
                                                                        phi_2663_ = _e2013;
                                                                    }
                                                                    let _e2094 = phi_2660_;
                                                                    let _e2096 = phi_2661_;
                                                                    let _e2098 = phi_2662_;
                                                                    let _e2100 = phi_2663_;
                                                                    let _e2103 = ((_e2100 * _e2094) - (_e2098 * _e2096));
                                                                    if _e2092 {
                                                                        phi_2671_ = -(_e2103);
                                                                    } else {
                                                                        phi_2671_ = _e2103;
                                                                    }
                                                                    let _e2106 = phi_2671_;
                                                                    if (_e2064 >= 0f) {
                                                                        if (_e2085 >= 0f) {
                                                                            if (_e2106 >= 0f) {
                                                                                phi_2686_ = ((_e2064 + _e2085) + _e2106);
                                                                                phi_2687_ = false;
                                                                            } else {
                                                                                phi_2686_ = f32();
                                                                                phi_2687_ = true;
                                                                            }
                                                                            let _e2113 = phi_2686_;
                                                                            let _e2115 = phi_2687_;
                                                                            phi_2688_ = _e2113;
                                                                            phi_2689_ = _e2115;
                                                                        } else {
                                                                            phi_2688_ = f32();
                                                                            phi_2689_ = true;
                                                                        }
                                                                        let _e2117 = phi_2688_;
                                                                        let _e2119 = phi_2689_;
                                                                        phi_2690_ = _e2117;
                                                                        phi_2691_ = _e2119;
                                                                    } else {
                                                                        phi_2690_ = f32();
                                                                        phi_2691_ = true;
                                                                    }
                                                                    let _e2121 = phi_2690_;
                                                                    let _e2123 = phi_2691_;
                                                                    if _e2123 {
                                                                        if (_e2064 <= 0f) {
                                                                            if (_e2085 <= 0f) {
                                                                                let _e2126 = (_e2106 <= 0f);
                                                                                if _e2126 {
                                                                                }
                                                                                phi_2709_ = ((_e2064 + _e2085) + _e2106);
                                                                                phi_2710_ = false;
                                                                                phi_2711_ = _e2126;
                                                                            } else {
                                                                                phi_2709_ = f32();
                                                                                phi_2710_ = true;
                                                                                phi_2711_ = false;
                                                                            }
                                                                            let _e2130 = phi_2709_;
                                                                            let _e2132 = phi_2710_;
                                                                            let _e2134 = phi_2711_;
                                                                            phi_2712_ = _e2130;
                                                                            phi_2713_ = _e2132;
                                                                            phi_2714_ = _e2134;
                                                                        } else {
                                                                            phi_2712_ = f32();
                                                                            phi_2713_ = true;
                                                                            phi_2714_ = false;
                                                                        }
                                                                        let _e2136 = phi_2712_;
                                                                        let _e2138 = phi_2713_;
                                                                        let _e2140 = phi_2714_;
                                                                        if _e2138 {
                                                                            phi_2718_ = false;
                                                                        } else {
                                                                            phi_2718_ = _e2140;
                                                                        }
                                                                        let _e2142 = phi_2718_;
                                                                        phi_2719_ = _e2136;
                                                                        phi_2720_ = _e2142;
                                                                    } else {
                                                                        phi_2719_ = _e2121;
                                                                        phi_2720_ = true;
                                                                    }
                                                                    let _e2144 = phi_2719_;
                                                                    let _e2146 = phi_2720_;
                                                                    if _e2146 {
                                                                        let _e2147 = (_e2144 == 0f);
                                                                        if _e2147 {
                                                                            phi_3036_ = lt_bvh_triangle_Intersection();
                                                                            phi_3037_ = false;
                                                                        } else {
                                                                            let _e2149 = triangles.member[(0u + _e1960)].v0_;
                                                                            let _e2151 = (_e2149.x - _e1063);
                                                                            let _e2153 = (_e2149.y - _e1076);
                                                                            let _e2155 = (_e2149.z - _e1089);
                                                                            if (_e1345 == 0u) {
                                                                                phi_2749_ = vec3<f32>(_e2153, _e2155, _e2151);
                                                                            } else {
                                                                                if (_e1345 == 1u) {
                                                                                    phi_2748_ = vec3<f32>(_e2155, _e2151, _e2153);
                                                                                } else {
                                                                                    phi_2748_ = (_e2149 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                                }
                                                                                let _e2163 = phi_2748_;
                                                                                phi_2749_ = _e2163;
                                                                            }
                                                                            let _e2165 = phi_2749_;
                                                                            let _e2167 = triangles.member[(0u + _e1960)].v1_;
                                                                            let _e2169 = triangles.member[(0u + _e1960)].v0_;
                                                                            let _e2172 = (_e2167.x - _e2169.x);
                                                                            let _e2175 = (_e2167.y - _e2169.y);
                                                                            let _e2178 = (_e2167.z - _e2169.z);
                                                                            if (_e1345 == 0u) {
                                                                                phi_2775_ = vec3<f32>(_e2175, _e2178, _e2172);
                                                                            } else {
                                                                                if (_e1345 == 1u) {
                                                                                    phi_2774_ = vec3<f32>(_e2178, _e2172, _e2175);
                                                                                } else {
                                                                                    phi_2774_ = (_e2167 - _e2169);
                                                                                }
                                                                                let _e2185 = phi_2774_;
                                                                                phi_2775_ = _e2185;
                                                                            }
                                                                            let _e2187 = phi_2775_;
                                                                            let _e2189 = triangles.member[(0u + _e1960)].v2_;
                                                                            let _e2191 = triangles.member[(0u + _e1960)].v0_;
                                                                            let _e2194 = (_e2189.x - _e2191.x);
                                                                            let _e2197 = (_e2189.y - _e2191.y);
                                                                            let _e2200 = (_e2189.z - _e2191.z);
                                                                            if (_e1345 == 0u) {
                                                                                phi_2801_ = vec3<f32>(_e2197, _e2200, _e2194);
                                                                            } else {
                                                                                if (_e1345 == 1u) {
                                                                                    phi_2800_ = vec3<f32>(_e2200, _e2194, _e2197);
                                                                                } else {
                                                                                    phi_2800_ = (_e2189 - _e2191);
                                                                                }
                                                                                let _e2207 = phi_2800_;
                                                                                phi_2801_ = _e2207;
                                                                            }
                                                                            let _e2209 = phi_2801_;
                                                                            let _e2216 = ((_e2187.y * _e2209.z) - (_e2187.z * _e2209.y));
                                                                            let _e2223 = ((_e2187.z * _e2209.x) - (_e2187.x * _e2209.z));
                                                                            let _e2230 = ((_e2187.x * _e2209.y) - (_e2187.y * _e2209.x));
                                                                            let _e2244 = (((1f / _e1353.z) * (((_e2216 * _e2165.x) + (_e2223 * _e2165.y)) + (_e2230 * _e2165.z))) / (((_e2216 * _e1356) + (_e2223 * _e1359)) + _e2230));
                                                                            if (_e2244 > _e162.tmin) {
                                                                                if (_e2244 < _e162.tmax) {
                                                                                    let _e2248 = triangles.member[(0u + _e1960)].v0_;
                                                                                    let _e2250 = triangles.member[(0u + _e1960)].v1_;
                                                                                    if (_e2248.x < _e2250.x) {
                                                                                        phi_2857_ = _e2248.x;
                                                                                    } else {
                                                                                        phi_2857_ = _e2250.x;
                                                                                    }
                                                                                    let _e2257 = phi_2857_;
                                                                                    if (_e2248.y < _e2250.y) {
                                                                                        phi_2866_ = _e2248.y;
                                                                                    } else {
                                                                                        phi_2866_ = _e2250.y;
                                                                                    }
                                                                                    let _e2264 = phi_2866_;
                                                                                    if (_e2248.z < _e2250.z) {
                                                                                        phi_2875_ = _e2248.z;
                                                                                    } else {
                                                                                        phi_2875_ = _e2250.z;
                                                                                    }
                                                                                    let _e2271 = phi_2875_;
                                                                                    let _e2273 = triangles.member[(0u + _e1960)].v2_;
                                                                                    if (_e2257 < _e2273.x) {
                                                                                        phi_2884_ = _e2257;
                                                                                    } else {
                                                                                        phi_2884_ = _e2273.x;
                                                                                    }
                                                                                    let _e2278 = phi_2884_;
                                                                                    if (_e2264 < _e2273.y) {
                                                                                        phi_2891_ = _e2264;
                                                                                    } else {
                                                                                        phi_2891_ = _e2273.y;
                                                                                    }
                                                                                    let _e2283 = phi_2891_;
                                                                                    if (_e2271 < _e2273.z) {
                                                                                        phi_2898_ = _e2271;
                                                                                    } else {
                                                                                        phi_2898_ = _e2273.z;
                                                                                    }
                                                                                    let _e2288 = phi_2898_;
                                                                                    let _e2290 = triangles.member[(0u + _e1960)].v0_;
                                                                                    let _e2292 = triangles.member[(0u + _e1960)].v1_;
                                                                                    if (_e2290.x > _e2292.x) {
                                                                                        phi_2911_ = _e2290.x;
                                                                                    } else {
                                                                                        phi_2911_ = _e2292.x;
                                                                                    }
                                                                                    let _e2299 = phi_2911_;
                                                                                    if (_e2290.y > _e2292.y) {
                                                                                        phi_2920_ = _e2290.y;
                                                                                    } else {
                                                                                        phi_2920_ = _e2292.y;
                                                                                    }
                                                                                    let _e2306 = phi_2920_;
                                                                                    if (_e2290.z > _e2292.z) {
                                                                                        phi_2929_ = _e2290.z;
                                                                                    } else {
                                                                                        phi_2929_ = _e2292.z;
                                                                                    }
                                                                                    let _e2313 = phi_2929_;
                                                                                    let _e2315 = triangles.member[(0u + _e1960)].v2_;
                                                                                    if (_e2299 > _e2315.x) {
                                                                                        phi_2938_ = _e2299;
                                                                                    } else {
                                                                                        phi_2938_ = _e2315.x;
                                                                                    }
                                                                                    let _e2320 = phi_2938_;
                                                                                    if (_e2306 > _e2315.y) {
                                                                                        phi_2945_ = _e2306;
                                                                                    } else {
                                                                                        phi_2945_ = _e2315.y;
                                                                                    }
                                                                                    let _e2325 = phi_2945_;
                                                                                    if (_e2313 > _e2315.z) {
                                                                                        phi_2952_ = _e2313;
                                                                                    } else {
                                                                                        phi_2952_ = _e2315.z;
                                                                                    }
                                                                                    let _e2330 = phi_2952_;
                                                                                    let _e2334 = ((_e2278 - _e1063) * _e1270);
                                                                                    let _e2335 = ((_e2283 - _e1076) * _e1280);
                                                                                    let _e2336 = ((_e2288 - _e1089) * _e1290);
                                                                                    let _e2340 = ((_e2320 - _e1063) * _e1270);
                                                                                    let _e2341 = ((_e2325 - _e1076) * _e1280);
                                                                                    let _e2342 = ((_e2330 - _e1089) * _e1290);
                                                                                    if (_e2334 < _e2340) {
                                                                                        phi_2969_ = _e2334;
                                                                                    } else {
                                                                                        phi_2969_ = _e2340;
                                                                                    }
                                                                                    let _e2345 = phi_2969_;
                                                                                    if (_e2335 < _e2341) {
                                                                                        phi_2974_ = _e2335;
                                                                                    } else {
                                                                                        phi_2974_ = _e2341;
                                                                                    }
                                                                                    let _e2348 = phi_2974_;
                                                                                    if (_e2336 < _e2342) {
                                                                                        phi_2979_ = _e2336;
                                                                                    } else {
                                                                                        phi_2979_ = _e2342;
                                                                                    }
                                                                                    let _e2351 = phi_2979_;
                                                                                    if (_e2334 > _e2340) {
                                                                                        phi_2987_ = _e2334;
                                                                                    } else {
                                                                                        phi_2987_ = _e2340;
                                                                                    }
                                                                                    let _e2357 = phi_2987_;
                                                                                    if (_e2335 > _e2341) {
                                                                                        phi_2992_ = _e2335;
                                                                                    } else {
                                                                                        phi_2992_ = _e2341;
                                                                                    }
                                                                                    let _e2360 = phi_2992_;
                                                                                    if (_e2336 > _e2342) {
                                                                                        phi_2997_ = _e2336;
                                                                                    } else {
                                                                                        phi_2997_ = _e2342;
                                                                                    }
                                                                                    let _e2363 = phi_2997_;
                                                                                    let _e2367 = core_intrinsics_maximum_number_nsz_f32_((_e2345 - _e1329), (_e2348 - _e1330));
                                                                                    let _e2368 = core_intrinsics_maximum_number_nsz_f32_(_e2367, (_e2351 - _e1331));
                                                                                    let _e2369 = core_intrinsics_minimum_number_nsz_f32_((_e2357 + _e1329), (_e2360 + _e1330));
                                                                                    let _e2370 = core_intrinsics_minimum_number_nsz_f32_(_e2369, (_e2363 + _e1331));
                                                                                    if (_e2368 > _e1038) {
                                                                                        phi_3009_ = _e2368;
                                                                                    } else {
                                                                                        phi_3009_ = _e1038;
                                                                                    }
                                                                                    let _e2373 = phi_3009_;
                                                                                    if (_e2370 < _e1040) {
                                                                                        phi_3014_ = _e2370;
                                                                                    } else {
                                                                                        phi_3014_ = _e1040;
                                                                                    }
                                                                                    let _e2376 = phi_3014_;
                                                                                    if (_e2244 < _e2373) {
                                                                                        phi_3019_ = _e2373;
                                                                                    } else {
                                                                                        phi_3019_ = _e2244;
                                                                                    }
                                                                                    let _e2379 = phi_3019_;
                                                                                    if (_e2379 > _e2376) {
                                                                                        phi_3024_ = _e2376;
                                                                                    } else {
                                                                                        phi_3024_ = _e2379;
                                                                                    }
                                                                                    let _e2382 = phi_3024_;
                                                                                    phi_3029_ = lt_bvh_triangle_Intersection(_e2382, (_e2085 / _e2144), (_e2106 / _e2144), (_e2373 <= _e2376));
                                                                                    phi_3030_ = false;
                                                                                } else {
                                                                                    phi_3029_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3030_ = true;
                                                                                }
                                                                                let _e2388 = phi_3029_;
                                                                                let _e2390 = phi_3030_;
                                                                                phi_3031_ = _e2388;
                                                                                phi_3032_ = _e2390;
                                                                            } else {
                                                                                phi_3031_ = lt_bvh_triangle_Intersection();
                                                                                phi_3032_ = true;
                                                                            }
                                                                            let _e2392 = phi_3031_;
                                                                            let _e2394 = phi_3032_;
                                                                            if _e2394 {
                                                                            }
                                                                            phi_3036_ = _e2392;
                                                                            phi_3037_ = _e2394;
                                                                        }
                                                                        let _e2396 = phi_3036_;
                                                                        let _e2398 = phi_3037_;
                                                                        phi_3038_ = _e2396;
                                                                        phi_3039_ = _e2147;
                                                                        phi_3040_ = _e2398;
                                                                    } else {
                                                                        phi_3038_ = lt_bvh_triangle_Intersection();
                                                                        phi_3039_ = true;
                                                                        phi_3040_ = false;
                                                                    }
                                                                    let _e2400 = phi_3038_;
                                                                    let _e2402 = phi_3039_;
                                                                    let _e2404 = phi_3040_;
                                                                    if _e2402 {
                                                                        phi_3044_ = true;
                                                                    } else {
                                                                        phi_3044_ = _e2404;
                                                                    }
                                                                    let _e2406 = phi_3044_;
                                                                    if _e2406 {
                                                                        phi_3048_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3048_ = _e2400;
                                                                    }
                                                                    let _e2408 = phi_3048_;
                                                                    if _e2408.is_hit {
                                                                        if (_e2408.t > _e162.tmin) {
                                                                            if (_e2408.t < _e1949.t) {
                                                                                phi_3096_ = true;
                                                                            } else {
                                                                                if (_e2408.t == _e1949.t) {
                                                                                    if (_e1949.triangle != 4294967295u) {
                                                                                        if (_e1960 < _e1949.triangle) {
                                                                                            phi_3087_ = true;
                                                                                        } else {
                                                                                            if (_e1960 == _e1949.triangle) {
                                                                                                phi_3086_ = (_e979 < _e1949.instance);
                                                                                            } else {
                                                                                                phi_3086_ = false;
                                                                                            }
                                                                                            let _e2426 = phi_3086_;
                                                                                            phi_3087_ = _e2426;
                                                                                        }
                                                                                        let _e2428 = phi_3087_;
                                                                                        phi_3088_ = _e2428;
                                                                                        phi_3089_ = false;
                                                                                    } else {
                                                                                        phi_3088_ = bool();
                                                                                        phi_3089_ = true;
                                                                                    }
                                                                                    let _e2430 = phi_3088_;
                                                                                    let _e2432 = phi_3089_;
                                                                                    phi_3090_ = _e2430;
                                                                                    phi_3091_ = _e2432;
                                                                                } else {
                                                                                    phi_3090_ = bool();
                                                                                    phi_3091_ = true;
                                                                                }
                                                                                let _e2434 = phi_3090_;
                                                                                let _e2436 = phi_3091_;
                                                                                if _e2436 {
                                                                                    phi_3095_ = false;
                                                                                } else {
                                                                                    phi_3095_ = _e2434;
                                                                                }
                                                                                let _e2438 = phi_3095_;
                                                                                phi_3096_ = _e2438;
                                                                            }
                                                                            let _e2440 = phi_3096_;
                                                                            if _e2440 {
                                                                                let _e2442 = triangles.member[(0u + _e1960)].i0_;
                                                                                if ((_e2442 & 2147483648u) == 0u) {
                                                                                    phi_3307_ = true;
                                                                                } else {
                                                                                    if (_e1960 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2451 = triangles.member[(0u + _e1960)].i0_;
                                                                                    let _e2452 = (_e2451 & 2147483647u);
                                                                                    let _e2454 = triangles.member[(0u + _e1960)].i1_;
                                                                                    let _e2456 = triangles.member[(0u + _e1960)].i2_;
                                                                                    if (_e2452 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2460 = vertices.member[(0u + _e2452)];
                                                                                    if (_e2454 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2464 = vertices.member[(0u + _e2454)];
                                                                                    if (_e2456 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2468 = vertices.member[(0u + _e2456)];
                                                                                    let _e2469 = array<abi_Vertex, 3>(_e2460, _e2464, _e2468);
                                                                                    if (_e2469[0].material < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2475 = materials.member[(0u + _e2469[0].material)];
                                                                                    if ((_e2475.flags & 0u) == 0u) {
                                                                                        let _e2480 = ((1f - _e2408.u) - _e2408.v);
                                                                                        if (_e2475.cutoff <= 0f) {
                                                                                            phi_3302_ = true;
                                                                                        } else {
                                                                                            let _e2507 = (_e2475.base_color.w * ((((f32((_e2469[0].color >> bitcast<u32>(24i))) * _e2480) + (f32((_e2469[1].color >> bitcast<u32>(24i))) * _e2408.u)) + (f32((_e2469[2].color >> bitcast<u32>(24i))) * _e2408.v)) * (1f / 255f)));
                                                                                            if (_e2475.alpha_size == 0u) {
                                                                                                phi_3299_ = _e2507;
                                                                                            } else {
                                                                                                local_1.offset = _e2475.alpha_offset;
                                                                                                local_1.size = _e2475.alpha_size;
                                                                                                local_1.flags = _e2475.flags;
                                                                                                let _e2538 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2469[0].u * _e2480) + (_e2469[1].u * _e2408.u)) + (_e2469[2].u * _e2408.v)), (((_e2469[0].v * _e2480) + (_e2469[1].v * _e2408.u)) + (_e2469[2].v * _e2408.v)));
                                                                                                let _e2542 = (_e2538.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2542 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2546 = alpha_texels.member[(0u + _e2542)];
                                                                                                let _e2562 = (_e2538.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2562 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2566 = alpha_texels.member[(0u + _e2562)];
                                                                                                let _e2583 = (_e2538.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2583 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2587 = alpha_texels.member[(0u + _e2583)];
                                                                                                let _e2604 = (_e2538.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2604 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2608 = alpha_texels.member[(0u + _e2604)];
                                                                                                phi_3299_ = (_e2507 * (((((f32(((_e2546 >> bitcast<u32>((((_e2538.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2538.weights.x) + ((f32(((_e2566 >> bitcast<u32>((((_e2538.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2538.weights.y)) + ((f32(((_e2587 >> bitcast<u32>((((_e2538.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2538.weights.z)) + ((f32(((_e2608 >> bitcast<u32>((((_e2538.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2538.weights.w)));
                                                                                            }
                                                                                            let _e2624 = phi_3299_;
                                                                                            phi_3302_ = (_e2624 >= _e2475.cutoff);
                                                                                        }
                                                                                        let _e2628 = phi_3302_;
                                                                                        phi_3303_ = _e2628;
                                                                                    } else {
                                                                                        phi_3303_ = false;
                                                                                    }
                                                                                    let _e2630 = phi_3303_;
                                                                                    if _e2630 {
                                                                                    }
                                                                                    phi_3307_ = _e2630;
                                                                                }
                                                                                let _e2632 = phi_3307_;
                                                                                if _e2632 {
                                                                                    phi_3315_ = lt_bvh_Hit(_e2408.t, _e2408.u, _e2408.v, _e1960, _e979);
                                                                                } else {
                                                                                    phi_3315_ = _e1949;
                                                                                }
                                                                                let _e2638 = phi_3315_;
                                                                                phi_3316_ = _e2638;
                                                                            } else {
                                                                                phi_3316_ = _e1949;
                                                                            }
                                                                            let _e2640 = phi_3316_;
                                                                            phi_3317_ = _e2640;
                                                                        } else {
                                                                            phi_3317_ = _e1949;
                                                                        }
                                                                        let _e2642 = phi_3317_;
                                                                        phi_3318_ = _e2642;
                                                                    } else {
                                                                        phi_3318_ = _e1949;
                                                                    }
                                                                    let _e2644 = phi_3318_;
                                                                    phi_2478_ = _e2644;
                                                                    phi_2481_ = (_e1951 & (_e1951 - 1u));
                                                                    phi_3319_ = true;
                                                                }
                                                                let _e2646 = phi_2478_;
                                                                let _e2648 = phi_2481_;
                                                                let _e2650 = phi_3319_;
                                                                continue;
                                                                continuing {
                                                                    phi_2477_ = _e2646;
                                                                    phi_2480_ = _e2648;
                                                                    break if !(_e2650);
                                                                }
                                                            }
                                                            let _e2653 = local_2.group_mask;
                                                            if ((_e2653 & 4278190080u) == 0u) {
                                                                let _e2657 = local_2.len;
                                                                if (_e2657 == 0u) {
                                                                    phi_3358_ = false;
                                                                } else {
                                                                    let _e2661 = local_2.len;
                                                                    local_2.len = (_e2661 - 1u);
                                                                    let _e2664 = local_2.len;
                                                                    if (_e2664 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2669 = local_2.first[(0u + _e2664)];
                                                                    local_2.group = _e2669;
                                                                    let _e2672 = local_2.len;
                                                                    if (_e2672 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2677 = local_2.mask[(0u + _e2672)];
                                                                    local_2.group_mask = _e2677;
                                                                    phi_3358_ = true;
                                                                }
                                                                let _e2680 = phi_3358_;
                                                                phi_3359_ = _e2680;
                                                            } else {
                                                                phi_3359_ = true;
                                                            }
                                                            let _e2682 = phi_3359_;
                                                            if _e2682 {
                                                                let _e2684 = local_2.group_mask;
                                                                let _e2690 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2684)), 32u, (_e2684 == 0u)));
                                                                let _e2694 = local_2.group_mask;
                                                                let _e2708 = local_2.group_mask;
                                                                local_2.group_mask = (_e2708 & ~((1u << bitcast<u32>((_e2690 & 31u)))));
                                                                let _e2711 = local_2.group;
                                                                phi_3390_ = (_e2711 + countOneBits(((_e2694 & ~((4294967295u << bitcast<u32>((((_e2690 - 24u) ^ _e1372) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3390_ = 4294967295u;
                                                            }
                                                            let _e2714 = phi_3390_;
                                                            let _e3843 = local_10;
                                                            phi_2145_ = _e3843;
                                                            phi_2148_ = _e2714;
                                                        } else {
                                                            phi_2145_ = lt_bvh_Hit();
                                                            phi_2148_ = u32();
                                                        }
                                                        let _e2716 = phi_2145_;
                                                        let _e2718 = phi_2148_;
                                                        continue;
                                                        continuing {
                                                            phi_2144_ = _e2716;
                                                            phi_2147_ = _e2718;
                                                            break if !(_e1513);
                                                        }
                                                    }
                                                    let _e3847 = local_11;
                                                    phi_3391_ = _e3847;
                                                }
                                                let _e2721 = phi_3391_;
                                                phi_3392_ = _e2721;
                                                phi_3393_ = _e1194;
                                            } else {
                                                phi_3392_ = lt_bvh_Hit();
                                                phi_3393_ = true;
                                            }
                                            let _e2723 = phi_3392_;
                                            let _e2725 = phi_3393_;
                                            if _e2725 {
                                                phi_3397_ = _e971;
                                            } else {
                                                phi_3397_ = _e2723;
                                            }
                                            let _e2727 = phi_3397_;
                                            phi_3398_ = _e2727;
                                        } else {
                                            phi_3398_ = _e971;
                                        }
                                        let _e2729 = phi_3398_;
                                        phi_3399_ = _e2729;
                                    } else {
                                        phi_3399_ = _e971;
                                    }
                                    let _e2731 = phi_3399_;
                                    phi_3400_ = _e2731;
                                } else {
                                    phi_3400_ = _e971;
                                }
                                let _e2733 = phi_3400_;
                                phi_1512_ = (_e969 & (_e969 - 1u));
                                phi_1515_ = _e2733;
                                phi_3401_ = true;
                            }
                            let _e2735 = phi_1512_;
                            let _e2737 = phi_1515_;
                            let _e2739 = phi_3401_;
                            continue;
                            continuing {
                                phi_1511_ = _e2735;
                                phi_1514_ = _e2737;
                                break if !(_e2739);
                            }
                        }
                        let _e2742 = local_3.group_mask;
                        if ((_e2742 & 4278190080u) == 0u) {
                            let _e2746 = local_3.len;
                            if (_e2746 == 0u) {
                                phi_3440_ = false;
                            } else {
                                let _e2750 = local_3.len;
                                local_3.len = (_e2750 - 1u);
                                let _e2753 = local_3.len;
                                if (_e2753 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2758 = local_3.first[(0u + _e2753)];
                                local_3.group = _e2758;
                                let _e2761 = local_3.len;
                                if (_e2761 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2766 = local_3.mask[(0u + _e2761)];
                                local_3.group_mask = _e2766;
                                phi_3440_ = true;
                            }
                            let _e2769 = phi_3440_;
                            phi_3441_ = _e2769;
                        } else {
                            phi_3441_ = true;
                        }
                        let _e2771 = phi_3441_;
                        if _e2771 {
                            let _e2773 = local_3.group_mask;
                            let _e2779 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2773)), 32u, (_e2773 == 0u)));
                            let _e2783 = local_3.group_mask;
                            let _e2797 = local_3.group_mask;
                            local_3.group_mask = (_e2797 & ~((1u << bitcast<u32>((_e2779 & 31u)))));
                            let _e2800 = local_3.group;
                            phi_3472_ = (_e2800 + countOneBits(((_e2783 & ~((4294967295u << bitcast<u32>((((_e2779 - 24u) ^ _e388) & 31u))))) & 255u)));
                        } else {
                            phi_3472_ = 4294967295u;
                        }
                        let _e2803 = phi_3472_;
                        phi_1175_ = _e2803;
                        let _e3863 = local_12;
                        phi_1178_ = _e3863;
                    } else {
                        phi_1175_ = u32();
                        phi_1178_ = lt_bvh_Hit();
                    }
                    let _e2805 = phi_1175_;
                    let _e2807 = phi_1178_;
                    continue;
                    continuing {
                        phi_1174_ = _e2805;
                        phi_1177_ = _e2807;
                        break if !(_e529);
                    }
                }
                let _e3866 = local_13;
                phi_3473_ = _e3866;
            }
            let _e2810 = phi_3473_;
            phi_3474_ = _e2810;
            phi_3475_ = _e226;
        } else {
            phi_3474_ = lt_bvh_Hit();
            phi_3475_ = true;
        }
        let _e2812 = phi_3474_;
        let _e2814 = phi_3475_;
        if _e2814 {
            phi_3479_ = _e164;
        } else {
            phi_3479_ = _e2812;
        }
        let _e2816 = phi_3479_;
        if (_e2816.triangle != 4294967295u) {
            let _e2822 = ((1f - _e2816.u) - _e2816.v);
            if (_e2816.triangle < _e81) {
            } else {
                return;
            }
            let _e2827 = triangles.member[(0u + _e2816.triangle)];
            if (_e2816.instance < _e93) {
            } else {
                return;
            }
            let _e2838 = instances.member[(0u + _e2816.instance)].object_to_world[0u];
            let _e2849 = ((((_e2838.x * _e2827.v0_.x) + (_e2838.y * _e2827.v0_.y)) + (_e2838.z * _e2827.v0_.z)) + (_e2838.w * 1f));
            let _e2851 = instances.member[(0u + _e2816.instance)].object_to_world[1u];
            let _e2862 = ((((_e2851.x * _e2827.v0_.x) + (_e2851.y * _e2827.v0_.y)) + (_e2851.z * _e2827.v0_.z)) + (_e2851.w * 1f));
            let _e2864 = instances.member[(0u + _e2816.instance)].object_to_world[2u];
            let _e2875 = ((((_e2864.x * _e2827.v0_.x) + (_e2864.y * _e2827.v0_.y)) + (_e2864.z * _e2827.v0_.z)) + (_e2864.w * 1f));
            let _e2882 = instances.member[(0u + _e2816.instance)].object_to_world[0u];
            let _e2893 = ((((_e2882.x * _e2827.v1_.x) + (_e2882.y * _e2827.v1_.y)) + (_e2882.z * _e2827.v1_.z)) + (_e2882.w * 1f));
            let _e2895 = instances.member[(0u + _e2816.instance)].object_to_world[1u];
            let _e2906 = ((((_e2895.x * _e2827.v1_.x) + (_e2895.y * _e2827.v1_.y)) + (_e2895.z * _e2827.v1_.z)) + (_e2895.w * 1f));
            let _e2908 = instances.member[(0u + _e2816.instance)].object_to_world[2u];
            let _e2919 = ((((_e2908.x * _e2827.v1_.x) + (_e2908.y * _e2827.v1_.y)) + (_e2908.z * _e2827.v1_.z)) + (_e2908.w * 1f));
            let _e2926 = instances.member[(0u + _e2816.instance)].object_to_world[0u];
            let _e2937 = ((((_e2926.x * _e2827.v2_.x) + (_e2926.y * _e2827.v2_.y)) + (_e2926.z * _e2827.v2_.z)) + (_e2926.w * 1f));
            let _e2939 = instances.member[(0u + _e2816.instance)].object_to_world[1u];
            let _e2950 = ((((_e2939.x * _e2827.v2_.x) + (_e2939.y * _e2827.v2_.y)) + (_e2939.z * _e2827.v2_.z)) + (_e2939.w * 1f));
            let _e2952 = instances.member[(0u + _e2816.instance)].object_to_world[2u];
            let _e2963 = ((((_e2952.x * _e2827.v2_.x) + (_e2952.y * _e2827.v2_.y)) + (_e2952.z * _e2827.v2_.z)) + (_e2952.w * 1f));
            let _e2976 = (((_e2849 * _e2822) + (_e2893 * _e2816.u)) + (_e2937 * _e2816.v));
            let _e2977 = (((_e2862 * _e2822) + (_e2906 * _e2816.u)) + (_e2950 * _e2816.v));
            let _e2978 = (((_e2875 * _e2822) + (_e2919 * _e2816.u)) + (_e2963 * _e2816.v));
            let _e2980 = abs(_e2849);
            let _e2981 = abs(_e2862);
            let _e2982 = abs(_e2875);
            let _e2983 = abs(_e2893);
            let _e2984 = abs(_e2906);
            let _e2985 = abs(_e2919);
            if (_e2980 > _e2983) {
                phi_3666_ = _e2980;
            } else {
                phi_3666_ = _e2983;
            }
            let _e2988 = phi_3666_;
            if (_e2981 > _e2984) {
                phi_3671_ = _e2981;
            } else {
                phi_3671_ = _e2984;
            }
            let _e2991 = phi_3671_;
            if (_e2982 > _e2985) {
                phi_3676_ = _e2982;
            } else {
                phi_3676_ = _e2985;
            }
            let _e2994 = phi_3676_;
            let _e2995 = abs(_e2937);
            let _e2996 = abs(_e2950);
            let _e2997 = abs(_e2963);
            if (_e2988 > _e2995) {
                phi_3684_ = _e2988;
            } else {
                phi_3684_ = _e2995;
            }
            let _e3000 = phi_3684_;
            if (_e2991 > _e2996) {
                phi_3689_ = _e2991;
            } else {
                phi_3689_ = _e2996;
            }
            let _e3003 = phi_3689_;
            if (_e2994 > _e2997) {
                phi_3694_ = _e2994;
            } else {
                phi_3694_ = _e2997;
            }
            let _e3006 = phi_3694_;
            let _e3007 = (_e2893 - _e2849);
            let _e3008 = (_e2906 - _e2862);
            let _e3009 = (_e2919 - _e2875);
            let _e3010 = (_e2937 - _e2849);
            let _e3011 = (_e2950 - _e2862);
            let _e3012 = (_e2963 - _e2875);
            let _e3016 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3008), abs(_e3009));
            let _e3017 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3007), _e3016);
            let _e3018 = (_e3007 / _e3017);
            let _e3019 = (_e3008 / _e3017);
            let _e3020 = (_e3009 / _e3017);
            let _e3024 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3011), abs(_e3012));
            let _e3025 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3010), _e3024);
            let _e3026 = (_e3010 / _e3025);
            let _e3027 = (_e3011 / _e3025);
            let _e3028 = (_e3012 / _e3025);
            let _e3031 = ((_e3019 * _e3028) - (_e3027 * _e3020));
            let _e3034 = ((_e3020 * _e3026) - (_e3028 * _e3018));
            let _e3037 = ((_e3018 * _e3027) - (_e3026 * _e3019));
            let _e3039 = p.member.eye;
            let _e3052 = (1f / sqrt((((_e3031 * _e3031) + (_e3034 * _e3034)) + (_e3037 * _e3037))));
            let _e3053 = (_e3031 * _e3052);
            let _e3054 = (_e3034 * _e3052);
            let _e3055 = (_e3037 * _e3052);
            if ((((_e3053 * (_e3039.x - _e2976)) + (_e3054 * (_e3039.y - _e2977))) + (_e3055 * (_e3039.z - _e2978))) < 0f) {
                phi_3758_ = vec3<f32>(-(_e3053), -(_e3054), -(_e3055));
            } else {
                phi_3758_ = vec3<f32>(_e3053, _e3054, _e3055);
            }
            let _e3068 = phi_3758_;
            if (_e2816.triangle < _e81) {
            } else {
                return;
            }
            let _e3073 = triangles.member[(0u + _e2816.triangle)];
            let _e3075 = (_e3073.i0_ & 2147483647u);
            if (_e3075 < _e84) {
            } else {
                return;
            }
            let _e3081 = vertices.member[(0u + _e3075)];
            if (_e3073.i1_ < _e84) {
            } else {
                return;
            }
            let _e3085 = vertices.member[(0u + _e3073.i1_)];
            if (_e3073.i2_ < _e84) {
            } else {
                return;
            }
            let _e3089 = vertices.member[(0u + _e3073.i2_)];
            let _e3090 = array<abi_Vertex, 3>(_e3081, _e3085, _e3089);
            if (_e3090[0].material < _e87) {
            } else {
                return;
            }
            let _e3096 = materials.member[(0u + _e3090[0].material)];
            let _e3113 = (1f / 255f);
            let _e3132 = (1f / 255f);
            let _e3154 = (1f / 255f);
            if (_e3096.color_size == 0u) {
                phi_4001_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3096.color_offset;
                local.size = _e3096.color_size;
                local.flags = _e3096.flags;
                let _e3197 = _lt_shaders_texture_TextureView_quad((&local), (((_e3090[0].u * _e2822) + (_e3090[1].u * _e2816.u)) + (_e3090[2].u * _e2816.v)), (((_e3090[0].v * _e2822) + (_e3090[1].v * _e2816.u)) + (_e3090[2].v * _e2816.v)));
                if (_e3197.indices[0] < _e99) {
                } else {
                    return;
                }
                let _e3203 = color_texels.member[(0u + _e3197.indices[0])];
                let _e3214 = (1f / 255f);
                if (_e3197.indices[1] < _e99) {
                } else {
                    return;
                }
                let _e3228 = color_texels.member[(0u + _e3197.indices[1])];
                let _e3239 = (1f / 255f);
                if (_e3197.indices[2] < _e99) {
                } else {
                    return;
                }
                let _e3256 = color_texels.member[(0u + _e3197.indices[2])];
                let _e3267 = (1f / 255f);
                if (_e3197.indices[3] < _e99) {
                } else {
                    return;
                }
                let _e3284 = color_texels.member[(0u + _e3197.indices[3])];
                let _e3295 = (1f / 255f);
                let _e3304 = (((((f32((_e3203 & 255u)) * _e3214) * _e3197.weights.x) + ((f32((_e3228 & 255u)) * _e3239) * _e3197.weights.y)) + ((f32((_e3256 & 255u)) * _e3267) * _e3197.weights.z)) + ((f32((_e3284 & 255u)) * _e3295) * _e3197.weights.w));
                let _e3305 = (((((f32(((_e3203 >> bitcast<u32>(8i)) & 255u)) * _e3214) * _e3197.weights.x) + ((f32(((_e3228 >> bitcast<u32>(8i)) & 255u)) * _e3239) * _e3197.weights.y)) + ((f32(((_e3256 >> bitcast<u32>(8i)) & 255u)) * _e3267) * _e3197.weights.z)) + ((f32(((_e3284 >> bitcast<u32>(8i)) & 255u)) * _e3295) * _e3197.weights.w));
                let _e3306 = (((((f32(((_e3203 >> bitcast<u32>(16i)) & 255u)) * _e3214) * _e3197.weights.x) + ((f32(((_e3228 >> bitcast<u32>(16i)) & 255u)) * _e3239) * _e3197.weights.y)) + ((f32(((_e3256 >> bitcast<u32>(16i)) & 255u)) * _e3267) * _e3197.weights.z)) + ((f32(((_e3284 >> bitcast<u32>(16i)) & 255u)) * _e3295) * _e3197.weights.w));
                phi_4001_ = vec3<f32>((_e3304 * _e3304), (_e3305 * _e3305), (_e3306 * _e3306));
            }
            let _e3312 = phi_4001_;
            let _e3314 = ((_e3096.base_color.x * ((((f32((_e3090[0].color & 255u)) * _e3113) * _e2822) + ((f32((_e3090[1].color & 255u)) * _e3132) * _e2816.u)) + ((f32((_e3090[2].color & 255u)) * _e3154) * _e2816.v))) * _e3312.x);
            let _e3316 = ((_e3096.base_color.y * ((((f32(((_e3090[0].color >> bitcast<u32>(8i)) & 255u)) * _e3113) * _e2822) + ((f32(((_e3090[1].color >> bitcast<u32>(8i)) & 255u)) * _e3132) * _e2816.u)) + ((f32(((_e3090[2].color >> bitcast<u32>(8i)) & 255u)) * _e3154) * _e2816.v))) * _e3312.y);
            let _e3318 = ((_e3096.base_color.z * ((((f32(((_e3090[0].color >> bitcast<u32>(16i)) & 255u)) * _e3113) * _e2822) + ((f32(((_e3090[1].color >> bitcast<u32>(16i)) & 255u)) * _e3132) * _e2816.u)) + ((f32(((_e3090[2].color >> bitcast<u32>(16i)) & 255u)) * _e3154) * _e2816.v))) * _e3312.z);
            let _e3319 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3003, _e3006);
            let _e3320 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3000, _e3319);
            if ((_e3096.flags & 2u) == 0u) {
                phi_4016_ = 0u;
            } else {
                phi_4016_ = 1u;
            }
            let _e3325 = phi_4016_;
            if (_e3090[0].normal == 2147516416u) {
                phi_4246_ = _e3068;
            } else {
                let _e3338 = (f32((bitcast<i32>((_e3090[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3344 = (f32((bitcast<i32>(_e3090[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3348 = ((1f - abs(_e3338)) - abs(_e3344));
                if (_e3348 < 0f) {
                    phi_4043_ = -(_e3348);
                } else {
                    phi_4043_ = 0f;
                }
                let _e3352 = phi_4043_;
                if (_e3338 < 0f) {
                    phi_4050_ = (_e3338 + _e3352);
                } else {
                    phi_4050_ = (_e3338 - _e3352);
                }
                let _e3357 = phi_4050_;
                if (_e3344 < 0f) {
                    phi_4057_ = (_e3344 + _e3352);
                } else {
                    phi_4057_ = (_e3344 - _e3352);
                }
                let _e3362 = phi_4057_;
                let _e3369 = (1f / sqrt((((_e3357 * _e3357) + (_e3362 * _e3362)) + (_e3348 * _e3348))));
                let _e3385 = (f32((bitcast<i32>((_e3090[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3391 = (f32((bitcast<i32>(_e3090[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3395 = ((1f - abs(_e3385)) - abs(_e3391));
                if (_e3395 < 0f) {
                    phi_4092_ = -(_e3395);
                } else {
                    phi_4092_ = 0f;
                }
                let _e3399 = phi_4092_;
                if (_e3385 < 0f) {
                    phi_4099_ = (_e3385 + _e3399);
                } else {
                    phi_4099_ = (_e3385 - _e3399);
                }
                let _e3404 = phi_4099_;
                if (_e3391 < 0f) {
                    phi_4106_ = (_e3391 + _e3399);
                } else {
                    phi_4106_ = (_e3391 - _e3399);
                }
                let _e3409 = phi_4106_;
                let _e3416 = (1f / sqrt((((_e3404 * _e3404) + (_e3409 * _e3409)) + (_e3395 * _e3395))));
                let _e3435 = (f32((bitcast<i32>((_e3090[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3441 = (f32((bitcast<i32>(_e3090[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3445 = ((1f - abs(_e3435)) - abs(_e3441));
                if (_e3445 < 0f) {
                    phi_4144_ = -(_e3445);
                } else {
                    phi_4144_ = 0f;
                }
                let _e3449 = phi_4144_;
                if (_e3435 < 0f) {
                    phi_4151_ = (_e3435 + _e3449);
                } else {
                    phi_4151_ = (_e3435 - _e3449);
                }
                let _e3454 = phi_4151_;
                if (_e3441 < 0f) {
                    phi_4158_ = (_e3441 + _e3449);
                } else {
                    phi_4158_ = (_e3441 - _e3449);
                }
                let _e3459 = phi_4158_;
                let _e3466 = (1f / sqrt((((_e3454 * _e3454) + (_e3459 * _e3459)) + (_e3445 * _e3445))));
                let _e3473 = ((((_e3357 * _e3369) * _e2822) + ((_e3404 * _e3416) * _e2816.u)) + ((_e3454 * _e3466) * _e2816.v));
                let _e3474 = ((((_e3362 * _e3369) * _e2822) + ((_e3409 * _e3416) * _e2816.u)) + ((_e3459 * _e3466) * _e2816.v));
                let _e3475 = ((((_e3348 * _e3369) * _e2822) + ((_e3395 * _e3416) * _e2816.u)) + ((_e3445 * _e3466) * _e2816.v));
                if (_e2816.instance < _e93) {
                } else {
                    return;
                }
                let _e3482 = instances.member[(0u + _e2816.instance)].world_to_object[0u];
                let _e3491 = instances.member[(0u + _e2816.instance)].world_to_object[1u];
                let _e3503 = instances.member[(0u + _e2816.instance)].world_to_object[2u];
                let _e3510 = (((_e3482.x * _e3473) + (_e3491.x * _e3474)) + (_e3503.x * _e3475));
                let _e3511 = (((_e3482.y * _e3473) + (_e3491.y * _e3474)) + (_e3503.y * _e3475));
                let _e3512 = (((_e3482.z * _e3473) + (_e3491.z * _e3474)) + (_e3503.z * _e3475));
                let _e3518 = sqrt((((_e3510 * _e3510) + (_e3511 * _e3511)) + (_e3512 * _e3512)));
                if (_e3518 > 0f) {
                    let _e3520 = (_e3510 / _e3518);
                    let _e3521 = (_e3511 / _e3518);
                    let _e3522 = (_e3512 / _e3518);
                    if ((((_e3520 * _e3068.x) + (_e3521 * _e3068.y)) + (_e3522 * _e3068.z)) < 0f) {
                        phi_4244_ = vec3<f32>(-(_e3520), -(_e3521), -(_e3522));
                    } else {
                        phi_4244_ = vec3<f32>(_e3520, _e3521, _e3522);
                    }
                    let _e3538 = phi_4244_;
                    phi_4245_ = _e3538;
                } else {
                    phi_4245_ = _e3068;
                }
                let _e3540 = phi_4245_;
                phi_4246_ = _e3540;
            }
            let _e3542 = phi_4246_;
            if (_e3314 > 0f) {
                if (_e3314 < 1f) {
                    phi_4255_ = _e3314;
                } else {
                    phi_4255_ = 1f;
                }
                let _e3546 = phi_4255_;
                phi_4256_ = _e3546;
            } else {
                phi_4256_ = 0f;
            }
            let _e3548 = phi_4256_;
            if (_e3316 > 0f) {
                if (_e3316 < 1f) {
                    phi_4266_ = _e3316;
                } else {
                    phi_4266_ = 1f;
                }
                let _e3553 = phi_4266_;
                phi_4267_ = _e3553;
            } else {
                phi_4267_ = 0f;
            }
            let _e3555 = phi_4267_;
            if (_e3318 > 0f) {
                if (_e3318 < 1f) {
                    phi_4277_ = _e3318;
                } else {
                    phi_4277_ = 1f;
                }
                let _e3560 = phi_4277_;
                phi_4278_ = _e3560;
            } else {
                phi_4278_ = 0f;
            }
            let _e3562 = phi_4278_;
            let _e3565 = ((sqrt(_e3548) * 255f) + 0.5f);
            let _e3574 = ((sqrt(_e3555) * 255f) + 0.5f);
            let _e3586 = ((sqrt(_e3562) * 255f) + 0.5f);
            phi_4313_ = abi_Sample(vec3<f32>(_e2976, _e2977, _e2978), _e3320, _e3068, _e3325, _e3542, ((select(select(u32(_e3565), 0u, (_e3565 < bitcast<f32>(0u))), 4294967295u, (_e3565 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3574), 0u, (_e3574 < bitcast<f32>(0u))), 4294967295u, (_e3574 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3586), 0u, (_e3586 < bitcast<f32>(0u))), 4294967295u, (_e3586 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4313_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3600 = phi_4313_;
        if (_e105.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e105.shift)] = _e3600;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
