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
    var phi_222_: lt_mask_LightPlace;
    var phi_223_: bool;
    var phi_224_: lt_mask_LightPlace;
    var phi_225_: bool;
    var phi_230_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_222_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_223_ = false;
        } else {
            phi_222_ = lt_mask_LightPlace();
            phi_223_ = true;
        }
        let _e83 = phi_222_;
        let _e85 = phi_223_;
        phi_224_ = _e83;
        phi_225_ = _e85;
    } else {
        phi_224_ = lt_mask_LightPlace();
        phi_225_ = true;
    }
    let _e87 = phi_224_;
    let _e89 = phi_225_;
    if _e89 {
        phi_230_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_230_ = _e87;
    }
    let _e94 = phi_230_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_245_: bool;
    var phi_249_: f32;

    if (param_3 != param_3) {
        phi_245_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_245_ = _e73;
    }
    let _e75 = phi_245_;
    if _e75 {
        phi_249_ = param_4;
    } else {
        phi_249_ = param_3;
    }
    let _e77 = phi_249_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_261_: bool;
    var phi_265_: f32;

    if (param_5 != param_5) {
        phi_261_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_261_ = _e73;
    }
    let _e75 = phi_261_;
    if _e75 {
        phi_265_ = param_6;
    } else {
        phi_265_ = param_5;
    }
    let _e77 = phi_265_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_313_: bool;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_319_: f32;
    var phi_345_: f32;
    var phi_350_: f32;
    var phi_351_: bool;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_357_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_376_: f32;
    var phi_377_: f32;
    var phi_395_: u32;
    var phi_409_: u32;
    var phi_416_: u32;
    var phi_421_: u32;
    var phi_427_: u32;
    var phi_432_: u32;
    var phi_434_: texture_Axis;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_474_: f32;
    var phi_500_: f32;
    var phi_505_: f32;
    var phi_506_: bool;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_512_: f32;
    var phi_520_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_550_: u32;
    var phi_564_: u32;
    var phi_571_: u32;
    var phi_576_: u32;
    var phi_582_: u32;
    var phi_587_: u32;
    var phi_589_: texture_Axis;

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
                phi_307_ = 1f;
            } else {
                phi_307_ = 0f;
            }
            let _e104 = phi_307_;
            if (param_8 < 8388608f) {
                phi_312_ = (_e101 - _e104);
                phi_313_ = false;
            } else {
                phi_312_ = f32();
                phi_313_ = true;
            }
            let _e107 = phi_312_;
            let _e109 = phi_313_;
            phi_314_ = _e107;
            phi_315_ = _e109;
        } else {
            phi_314_ = f32();
            phi_315_ = true;
        }
        let _e111 = phi_314_;
        let _e113 = phi_315_;
        if _e113 {
            phi_319_ = param_8;
        } else {
            phi_319_ = _e111;
        }
        let _e115 = phi_319_;
        phi_367_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_345_ = 1f;
                } else {
                    phi_345_ = 0f;
                }
                let _e133 = phi_345_;
                if (_e118 < 8388608f) {
                    phi_350_ = (_e130 - _e133);
                    phi_351_ = false;
                } else {
                    phi_350_ = f32();
                    phi_351_ = true;
                }
                let _e136 = phi_350_;
                let _e138 = phi_351_;
                phi_352_ = _e136;
                phi_353_ = _e138;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e140 = phi_352_;
            let _e142 = phi_353_;
            if _e142 {
                phi_357_ = _e118;
            } else {
                phi_357_ = _e140;
            }
            let _e144 = phi_357_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_365_ = (2f - _e146);
            } else {
                phi_365_ = _e146;
            }
            let _e150 = phi_365_;
            phi_366_ = _e150;
        } else {
            phi_366_ = param_8;
        }
        let _e152 = phi_366_;
        phi_367_ = _e152;
    }
    let _e154 = phi_367_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_376_ = _e154;
        } else {
            phi_376_ = 1f;
        }
        let _e158 = phi_376_;
        phi_377_ = _e158;
    } else {
        phi_377_ = 0f;
    }
    let _e160 = phi_377_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_395_ = _e161;
        } else {
            phi_395_ = _e170;
        }
        let _e173 = phi_395_;
        phi_434_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_409_ = _e75;
        } else {
            phi_409_ = _e182;
        }
        let _e185 = phi_409_;
        if (_e88 == 0u) {
            phi_416_ = _e161;
        } else {
            phi_416_ = 0u;
        }
        let _e190 = phi_416_;
        if (_e88 == 0u) {
            phi_421_ = 0u;
        } else {
            phi_421_ = _e161;
        }
        let _e193 = phi_421_;
        if (_e185 == 0u) {
            phi_427_ = _e190;
        } else {
            phi_427_ = (_e185 - 1u);
        }
        let _e197 = phi_427_;
        if (_e185 > _e161) {
            phi_432_ = _e193;
        } else {
            phi_432_ = _e185;
        }
        let _e200 = phi_432_;
        phi_434_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_434_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_462_ = 1f;
            } else {
                phi_462_ = 0f;
            }
            let _e224 = phi_462_;
            if (param_9 < 8388608f) {
                phi_467_ = (_e221 - _e224);
                phi_468_ = false;
            } else {
                phi_467_ = f32();
                phi_468_ = true;
            }
            let _e227 = phi_467_;
            let _e229 = phi_468_;
            phi_469_ = _e227;
            phi_470_ = _e229;
        } else {
            phi_469_ = f32();
            phi_470_ = true;
        }
        let _e231 = phi_469_;
        let _e233 = phi_470_;
        if _e233 {
            phi_474_ = param_9;
        } else {
            phi_474_ = _e231;
        }
        let _e235 = phi_474_;
        phi_522_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_500_ = 1f;
                } else {
                    phi_500_ = 0f;
                }
                let _e253 = phi_500_;
                if (_e238 < 8388608f) {
                    phi_505_ = (_e250 - _e253);
                    phi_506_ = false;
                } else {
                    phi_505_ = f32();
                    phi_506_ = true;
                }
                let _e256 = phi_505_;
                let _e258 = phi_506_;
                phi_507_ = _e256;
                phi_508_ = _e258;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e260 = phi_507_;
            let _e262 = phi_508_;
            if _e262 {
                phi_512_ = _e238;
            } else {
                phi_512_ = _e260;
            }
            let _e264 = phi_512_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_520_ = (2f - _e266);
            } else {
                phi_520_ = _e266;
            }
            let _e270 = phi_520_;
            phi_521_ = _e270;
        } else {
            phi_521_ = param_9;
        }
        let _e272 = phi_521_;
        phi_522_ = _e272;
    }
    let _e274 = phi_522_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_531_ = _e274;
        } else {
            phi_531_ = 1f;
        }
        let _e278 = phi_531_;
        phi_532_ = _e278;
    } else {
        phi_532_ = 0f;
    }
    let _e280 = phi_532_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_550_ = _e281;
        } else {
            phi_550_ = _e290;
        }
        let _e293 = phi_550_;
        phi_589_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_564_ = _e79;
        } else {
            phi_564_ = _e302;
        }
        let _e305 = phi_564_;
        if (_e208 == 0u) {
            phi_571_ = _e281;
        } else {
            phi_571_ = 0u;
        }
        let _e310 = phi_571_;
        if (_e208 == 0u) {
            phi_576_ = 0u;
        } else {
            phi_576_ = _e281;
        }
        let _e313 = phi_576_;
        if (_e305 == 0u) {
            phi_582_ = _e310;
        } else {
            phi_582_ = (_e305 - 1u);
        }
        let _e317 = phi_582_;
        if (_e305 > _e281) {
            phi_587_ = _e313;
        } else {
            phi_587_ = _e305;
        }
        let _e320 = phi_587_;
        phi_589_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_589_;
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
    var phi_648_: f32;

    if (param_12 > param_13) {
        phi_648_ = param_12;
    } else {
        phi_648_ = param_13;
    }
    let _e74 = phi_648_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_840_: bool;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_930_: f32;
    var phi_937_: f32;
    var phi_945_: f32;
    var phi_952_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_987_: f32;
    var phi_1009_: u32;
    var phi_1014_: u32;
    var phi_1019_: u32;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1165_: u32;
    var phi_1167_: u32;
    var phi_1170_: lt_bvh_Hit;
    var phi_1255_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1282_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1309_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1315_: u32;
    var phi_1318_: u32;
    var phi_1332_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1370_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1426_: u32;
    var phi_1439_: u32;
    var phi_1444_: u32;
    var phi_1445_: u32;
    var phi_1446_: u32;
    var phi_1316_: u32;
    var phi_1319_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1504_: u32;
    var phi_1507_: lt_bvh_Hit;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1580_: f32;
    var phi_1585_: f32;
    var phi_1590_: f32;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: bool;
    var phi_1777_: bool;
    var phi_1847_: f32;
    var phi_1854_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1899_: f32;
    var phi_1904_: f32;
    var phi_1909_: f32;
    var phi_1937_: bool;
    var phi_1938_: bool;
    var phi_1946_: u32;
    var phi_1947_: u32;
    var phi_1958_: vec3<f32>;
    var phi_1959_: vec3<f32>;
    var phi_1972_: u32;
    var phi_1977_: u32;
    var phi_1982_: u32;
    var phi_2096_: bool;
    var phi_2097_: bool;
    var phi_2128_: u32;
    var phi_2130_: lt_bvh_Hit;
    var phi_2133_: u32;
    var phi_2214_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2241_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2268_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2274_: u32;
    var phi_2277_: u32;
    var phi_2291_: u32;
    var phi_2301_: u32;
    var phi_2311_: u32;
    var phi_2329_: u32;
    var phi_2339_: u32;
    var phi_2349_: u32;
    var phi_2385_: u32;
    var phi_2398_: u32;
    var phi_2403_: u32;
    var phi_2404_: u32;
    var phi_2405_: u32;
    var phi_2275_: u32;
    var phi_2278_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2463_: lt_bvh_Hit;
    var phi_2466_: u32;
    var phi_2510_: vec3<f32>;
    var phi_2511_: vec3<f32>;
    var phi_2540_: vec3<f32>;
    var phi_2541_: vec3<f32>;
    var phi_2570_: vec3<f32>;
    var phi_2571_: vec3<f32>;
    var phi_2589_: bool;
    var phi_2590_: bool;
    var phi_2594_: f32;
    var phi_2595_: f32;
    var phi_2596_: f32;
    var phi_2597_: f32;
    var phi_2605_: f32;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2620_: f32;
    var phi_2621_: f32;
    var phi_2622_: f32;
    var phi_2623_: f32;
    var phi_2631_: f32;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2646_: f32;
    var phi_2647_: f32;
    var phi_2648_: f32;
    var phi_2649_: f32;
    var phi_2657_: f32;
    var phi_2672_: f32;
    var phi_2673_: bool;
    var phi_2674_: f32;
    var phi_2675_: bool;
    var phi_2676_: f32;
    var phi_2677_: bool;
    var phi_2695_: f32;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: f32;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2704_: bool;
    var phi_2705_: f32;
    var phi_2706_: bool;
    var phi_2734_: vec3<f32>;
    var phi_2735_: vec3<f32>;
    var phi_2760_: vec3<f32>;
    var phi_2761_: vec3<f32>;
    var phi_2786_: vec3<f32>;
    var phi_2787_: vec3<f32>;
    var phi_2843_: f32;
    var phi_2852_: f32;
    var phi_2861_: f32;
    var phi_2870_: f32;
    var phi_2877_: f32;
    var phi_2884_: f32;
    var phi_2897_: f32;
    var phi_2906_: f32;
    var phi_2915_: f32;
    var phi_2924_: f32;
    var phi_2931_: f32;
    var phi_2938_: f32;
    var phi_2955_: f32;
    var phi_2960_: f32;
    var phi_2965_: f32;
    var phi_2973_: f32;
    var phi_2978_: f32;
    var phi_2983_: f32;
    var phi_2995_: f32;
    var phi_3000_: f32;
    var phi_3005_: f32;
    var phi_3010_: f32;
    var phi_3015_: lt_bvh_triangle_Intersection;
    var phi_3016_: bool;
    var phi_3017_: lt_bvh_triangle_Intersection;
    var phi_3018_: bool;
    var phi_3022_: lt_bvh_triangle_Intersection;
    var phi_3023_: bool;
    var phi_3024_: lt_bvh_triangle_Intersection;
    var phi_3025_: bool;
    var phi_3026_: bool;
    var phi_3030_: bool;
    var phi_3034_: lt_bvh_triangle_Intersection;
    var phi_3072_: bool;
    var phi_3073_: bool;
    var phi_3074_: bool;
    var phi_3075_: bool;
    var phi_3076_: bool;
    var phi_3077_: bool;
    var phi_3081_: bool;
    var phi_3082_: bool;
    var phi_3285_: f32;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3293_: bool;
    var phi_3301_: lt_bvh_Hit;
    var phi_3302_: lt_bvh_Hit;
    var phi_3303_: lt_bvh_Hit;
    var phi_3304_: lt_bvh_Hit;
    var phi_2464_: lt_bvh_Hit;
    var phi_2467_: u32;
    var phi_3305_: bool;
    var phi_3344_: bool;
    var phi_3345_: bool;
    var phi_3376_: u32;
    var phi_2131_: lt_bvh_Hit;
    var phi_2134_: u32;
    var phi_3377_: lt_bvh_Hit;
    var phi_3378_: lt_bvh_Hit;
    var phi_3379_: bool;
    var phi_3383_: lt_bvh_Hit;
    var phi_3384_: lt_bvh_Hit;
    var phi_3385_: lt_bvh_Hit;
    var phi_3386_: lt_bvh_Hit;
    var phi_1505_: u32;
    var phi_1508_: lt_bvh_Hit;
    var phi_3387_: bool;
    var phi_3426_: bool;
    var phi_3427_: bool;
    var phi_3458_: u32;
    var phi_1168_: u32;
    var phi_1171_: lt_bvh_Hit;
    var phi_3459_: lt_bvh_Hit;
    var phi_3460_: lt_bvh_Hit;
    var phi_3461_: bool;
    var phi_3465_: lt_bvh_Hit;
    var phi_3652_: f32;
    var phi_3657_: f32;
    var phi_3662_: f32;
    var phi_3670_: f32;
    var phi_3675_: f32;
    var phi_3680_: f32;
    var phi_3744_: vec3<f32>;
    var phi_3987_: vec3<f32>;
    var phi_4002_: u32;
    var phi_4029_: f32;
    var phi_4036_: f32;
    var phi_4043_: f32;
    var phi_4078_: f32;
    var phi_4085_: f32;
    var phi_4092_: f32;
    var phi_4130_: f32;
    var phi_4137_: f32;
    var phi_4144_: f32;
    var phi_4230_: vec3<f32>;
    var phi_4231_: vec3<f32>;
    var phi_4232_: vec3<f32>;
    var phi_4241_: f32;
    var phi_4242_: f32;
    var phi_4252_: f32;
    var phi_4253_: f32;
    var phi_4263_: f32;
    var phi_4264_: f32;
    var phi_4299_: abi_Sample;
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
        let _e174 = abs(_e162.direction.x);
        let _e176 = abs(_e162.direction.y);
        let _e178 = abs(_e162.direction.z);
        if (abs(_e162.origin.x) < 1000000000000000f) {
            if (abs(_e162.origin.y) < 1000000000000000f) {
                if (abs(_e162.origin.z) < 1000000000000000f) {
                    if (_e174 < 1000000000000000f) {
                        if (_e176 < 1000000000000000f) {
                            if (_e178 < 1000000000000000f) {
                                if (_e174 > 0f) {
                                    phi_810_ = bool();
                                    phi_811_ = true;
                                } else {
                                    let _e186 = (_e176 > 0f);
                                    if _e186 {
                                        phi_809_ = bool();
                                    } else {
                                        phi_809_ = (_e178 > 0f);
                                    }
                                    let _e189 = phi_809_;
                                    phi_810_ = _e189;
                                    phi_811_ = _e186;
                                }
                                let _e191 = phi_810_;
                                let _e193 = phi_811_;
                                if _e193 {
                                    phi_815_ = true;
                                } else {
                                    phi_815_ = _e191;
                                }
                                let _e195 = phi_815_;
                                phi_816_ = _e195;
                                phi_817_ = false;
                            } else {
                                phi_816_ = bool();
                                phi_817_ = true;
                            }
                            let _e197 = phi_816_;
                            let _e199 = phi_817_;
                            phi_818_ = _e197;
                            phi_819_ = false;
                            phi_820_ = _e199;
                        } else {
                            phi_818_ = bool();
                            phi_819_ = true;
                            phi_820_ = false;
                        }
                        let _e201 = phi_818_;
                        let _e203 = phi_819_;
                        let _e205 = phi_820_;
                        phi_821_ = _e201;
                        phi_822_ = _e203;
                        phi_823_ = _e205;
                    } else {
                        phi_821_ = bool();
                        phi_822_ = true;
                        phi_823_ = false;
                    }
                    let _e207 = phi_821_;
                    let _e209 = phi_822_;
                    let _e211 = phi_823_;
                    phi_824_ = _e207;
                    phi_825_ = _e209;
                    phi_826_ = _e211;
                } else {
                    phi_824_ = bool();
                    phi_825_ = true;
                    phi_826_ = false;
                }
                let _e213 = phi_824_;
                let _e215 = phi_825_;
                let _e217 = phi_826_;
                phi_827_ = _e213;
                phi_828_ = _e215;
                phi_829_ = _e217;
            } else {
                phi_827_ = bool();
                phi_828_ = true;
                phi_829_ = false;
            }
            let _e219 = phi_827_;
            let _e221 = phi_828_;
            let _e223 = phi_829_;
            phi_830_ = _e219;
            phi_831_ = _e221;
            phi_832_ = _e223;
        } else {
            phi_830_ = bool();
            phi_831_ = true;
            phi_832_ = false;
        }
        let _e225 = phi_830_;
        let _e227 = phi_831_;
        let _e229 = phi_832_;
        if _e227 {
            phi_836_ = true;
        } else {
            phi_836_ = _e229;
        }
        let _e231 = phi_836_;
        if _e231 {
            phi_840_ = false;
        } else {
            phi_840_ = _e225;
        }
        let _e233 = phi_840_;
        if _e233 {
            let _e234 = (_e111 >= _e78);
            if _e234 {
                phi_3459_ = lt_bvh_Hit();
            } else {
                if (_e111 < _e78) {
                } else {
                    return;
                }
                let _e240 = nodes.member[(0u + _e111)].frame[0u];
                let _e244 = nodes.member[(0u + _e111)].frame[1u];
                let _e248 = nodes.member[(0u + _e111)].frame[2u];
                let _e252 = nodes.member[(0u + _e111)].frame[0u];
                let _e256 = nodes.member[(0u + _e111)].frame[1u];
                let _e260 = nodes.member[(0u + _e111)].frame[2u];
                let _e264 = nodes.member[(0u + _e111)].frame[3u];
                let _e302 = core_intrinsics_maximum_number_nsz_f32_(abs(_e162.direction.x), abs(_e162.direction.y));
                let _e303 = core_intrinsics_maximum_number_nsz_f32_(_e302, abs(_e162.direction.z));
                let _e304 = (_e303 * 0.0000000000009094947f);
                if (abs(_e162.direction.x) < _e304) {
                    phi_915_ = _e304;
                } else {
                    phi_915_ = abs(_e162.direction.x);
                }
                let _e311 = phi_915_;
                if (_e162.direction.x < 0f) {
                    phi_922_ = (-1f / _e311);
                } else {
                    phi_922_ = (1f / _e311);
                }
                let _e316 = phi_922_;
                if (abs(_e162.direction.y) < _e304) {
                    phi_930_ = _e304;
                } else {
                    phi_930_ = abs(_e162.direction.y);
                }
                let _e323 = phi_930_;
                if (_e162.direction.y < 0f) {
                    phi_937_ = (-1f / _e323);
                } else {
                    phi_937_ = (1f / _e323);
                }
                let _e328 = phi_937_;
                if (abs(_e162.direction.z) < _e304) {
                    phi_945_ = _e304;
                } else {
                    phi_945_ = abs(_e162.direction.z);
                }
                let _e335 = phi_945_;
                if (_e162.direction.z < 0f) {
                    phi_952_ = (-1f / _e335);
                } else {
                    phi_952_ = (1f / _e335);
                }
                let _e340 = phi_952_;
                let _e348 = abs((bitcast<f32>(_e240) - _e162.origin.x));
                let _e349 = abs((bitcast<f32>(_e244) - _e162.origin.y));
                let _e350 = abs((bitcast<f32>(_e248) - _e162.origin.z));
                let _e358 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e264 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.x));
                let _e359 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e264 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.y));
                let _e360 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e264 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.z));
                if (_e348 > _e358) {
                    phi_977_ = _e348;
                } else {
                    phi_977_ = _e358;
                }
                let _e363 = phi_977_;
                if (_e349 > _e359) {
                    phi_982_ = _e349;
                } else {
                    phi_982_ = _e359;
                }
                let _e366 = phi_982_;
                if (_e350 > _e360) {
                    phi_987_ = _e350;
                } else {
                    phi_987_ = _e360;
                }
                let _e369 = phi_987_;
                let _e370 = core_intrinsics_maximum_number_nsz_f32_(_e363, _e366);
                let _e371 = core_intrinsics_maximum_number_nsz_f32_(_e370, _e369);
                let _e376 = (_e371 * 0.0000019073486f);
                let _e377 = (abs(_e316) * _e376);
                let _e378 = (abs(_e328) * _e376);
                let _e379 = (abs(_e340) * _e376);
                let _e383 = (_e371 * 0.0000009536743f);
                let _e384 = (abs(_e316) * _e383);
                let _e385 = (abs(_e328) * _e383);
                let _e386 = (abs(_e340) * _e383);
                if (_e316 < 0f) {
                    phi_1009_ = 0u;
                } else {
                    phi_1009_ = 1u;
                }
                let _e389 = phi_1009_;
                if (_e328 < 0f) {
                    phi_1014_ = 0u;
                } else {
                    phi_1014_ = 2u;
                }
                let _e392 = phi_1014_;
                if (_e340 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 4u;
                }
                let _e395 = phi_1019_;
                let _e397 = ((_e389 | _e392) | _e395);
                let _e398 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e111, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e398.first[0], _e398.first[1], _e398.first[2], _e398.first[3], _e398.first[4], _e398.first[5], _e398.first[6], _e398.first[7], _e398.first[8], _e398.first[9], _e398.first[10], _e398.first[11], _e398.first[12], _e398.first[13], _e398.first[14], _e398.first[15], _e398.first[16], _e398.first[17], _e398.first[18], _e398.first[19], _e398.first[20], _e398.first[21], _e398.first[22], _e398.first[23], _e398.first[24], _e398.first[25], _e398.first[26], _e398.first[27], _e398.first[28], _e398.first[29], _e398.first[30], _e398.first[31]), array<u32, 32>(_e398.mask[0], _e398.mask[1], _e398.mask[2], _e398.mask[3], _e398.mask[4], _e398.mask[5], _e398.mask[6], _e398.mask[7], _e398.mask[8], _e398.mask[9], _e398.mask[10], _e398.mask[11], _e398.mask[12], _e398.mask[13], _e398.mask[14], _e398.mask[15], _e398.mask[16], _e398.mask[17], _e398.mask[18], _e398.mask[19], _e398.mask[20], _e398.mask[21], _e398.mask[22], _e398.mask[23], _e398.mask[24], _e398.mask[25], _e398.mask[26], _e398.mask[27], _e398.mask[28], _e398.mask[29], _e398.mask[30], _e398.mask[31]), _e398.len, _e398.group, _e398.group_mask);
                let _e472 = local_3.group_mask;
                if ((_e472 & 4278190080u) == 0u) {
                    let _e476 = local_3.len;
                    if (_e476 == 0u) {
                        phi_1133_ = false;
                    } else {
                        let _e480 = local_3.len;
                        local_3.len = (_e480 - 1u);
                        let _e483 = local_3.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_3.first[(0u + _e483)];
                        local_3.group = _e488;
                        let _e491 = local_3.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_3.mask[(0u + _e491)];
                        local_3.group_mask = _e496;
                        phi_1133_ = true;
                    }
                    let _e499 = phi_1133_;
                    phi_1134_ = _e499;
                } else {
                    phi_1134_ = true;
                }
                let _e501 = phi_1134_;
                if _e501 {
                    let _e503 = local_3.group_mask;
                    let _e509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e503)), 32u, (_e503 == 0u)));
                    let _e513 = local_3.group_mask;
                    let _e527 = local_3.group_mask;
                    local_3.group_mask = (_e527 & ~((1u << bitcast<u32>((_e509 & 31u)))));
                    let _e530 = local_3.group;
                    phi_1165_ = (_e530 + countOneBits(((_e513 & ~((4294967295u << bitcast<u32>((((_e509 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1165_ = 4294967295u;
                }
                let _e533 = phi_1165_;
                phi_1167_ = _e533;
                phi_1170_ = _e164;
                loop {
                    let _e535 = phi_1167_;
                    let _e537 = phi_1170_;
                    local_13 = _e537;
                    let _e538 = (_e535 != 4294967295u);
                    if _e538 {
                        if (_e535 < _e78) {
                        } else {
                            return;
                        }
                        let _e546 = nodes.member[(0u + _e535)].frame[3u];
                        let _e571 = (bitcast<f32>((((_e546 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e316);
                        let _e572 = (bitcast<f32>((((_e546 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e573 = (bitcast<f32>((((_e546 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e340);
                        let _e576 = nodes.member[(0u + _e535)].frame[0u];
                        let _e580 = nodes.member[(0u + _e535)].frame[1u];
                        let _e584 = nodes.member[(0u + _e535)].frame[2u];
                        let _e592 = ((bitcast<f32>(_e576) - _e162.origin.x) * _e316);
                        let _e593 = ((bitcast<f32>(_e580) - _e162.origin.y) * _e328);
                        let _e594 = ((bitcast<f32>(_e584) - _e162.origin.z) * _e340);
                        let _e602 = nodes.member[(0u + _e535)].x;
                        if (_e316 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e613.unnamed.word, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_mask_LightPlace(_e602.x, _e619.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_mask_LightPlace(_e625.unnamed_1.word, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e602.z, _e647.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e602.w));
                        }
                        let _e661 = phi_1255_;
                        let _e671 = nodes.member[(0u + _e535)].y;
                        if (_e328 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e682.unnamed.word, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e671.x, _e688.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e694.unnamed_1.word, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e671.z, _e716.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e671.w));
                        }
                        let _e730 = phi_1282_;
                        let _e740 = nodes.member[(0u + _e535)].z;
                        if (_e340 < 0f) {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e751.unnamed.word, _e740.w), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e740.x, _e757.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_mask_LightPlace(_e763.unnamed_1.word, _e740.y));
                        } else {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e740.y), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e740.z, _e785.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e740.w));
                        }
                        let _e799 = phi_1309_;
                        phi_1315_ = 0u;
                        phi_1318_ = 0u;
                        loop {
                            let _e809 = phi_1315_;
                            let _e811 = phi_1318_;
                            local_4 = _e811;
                            local_5 = _e811;
                            local_6 = _e811;
                            let _e812 = (_e809 < 8u);
                            if _e812 {
                                let _e814 = (_e809 >> bitcast<u32>(2i));
                                let _e815 = (_e809 & 3u);
                                if (_e814 == 0u) {
                                    phi_1332_ = _e661.unnamed.word;
                                } else {
                                    phi_1332_ = _e661.unnamed.shift;
                                }
                                let _e818 = phi_1332_;
                                if (_e814 == 0u) {
                                    phi_1342_ = _e730.unnamed.word;
                                } else {
                                    phi_1342_ = _e730.unnamed.shift;
                                }
                                let _e827 = phi_1342_;
                                if (_e814 == 0u) {
                                    phi_1352_ = _e799.unnamed.word;
                                } else {
                                    phi_1352_ = _e799.unnamed.shift;
                                }
                                let _e836 = phi_1352_;
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e818 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)), ((f32(((_e827 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                let _e850 = core_intrinsics_maximum_number_nsz_f32_(_e849, ((f32(((_e836 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 - _e379)));
                                if (_e814 == 0u) {
                                    phi_1370_ = _e661.unnamed_1.word;
                                } else {
                                    phi_1370_ = _e661.unnamed_1.shift;
                                }
                                let _e853 = phi_1370_;
                                if (_e814 == 0u) {
                                    phi_1380_ = _e730.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e730.unnamed_1.shift;
                                }
                                let _e862 = phi_1380_;
                                if (_e814 == 0u) {
                                    phi_1390_ = _e799.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e799.unnamed_1.shift;
                                }
                                let _e871 = phi_1390_;
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)), ((f32(((_e862 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                let _e885 = core_intrinsics_minimum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 + _e379)));
                                if (_e850 <= _e885) {
                                    if (_e850 <= _e537.t) {
                                        if (_e885 >= _e162.tmin) {
                                            if (_e814 == 0u) {
                                                let _e892 = nodes.member[(0u + _e535)].links[2u];
                                                phi_1426_ = _e892;
                                            } else {
                                                let _e895 = nodes.member[(0u + _e535)].links[3u];
                                                phi_1426_ = _e895;
                                            }
                                            let _e897 = phi_1426_;
                                            let _e902 = ((_e897 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u);
                                            let _e903 = (_e902 & 31u);
                                            if (_e903 >= 24u) {
                                                phi_1439_ = (24u + ((_e903 - 24u) ^ _e397));
                                            } else {
                                                phi_1439_ = _e903;
                                            }
                                            let _e909 = phi_1439_;
                                            phi_1444_ = (_e811 | ((_e902 >> bitcast<u32>(5i)) << bitcast<u32>((_e909 & 31u))));
                                        } else {
                                            phi_1444_ = _e811;
                                        }
                                        let _e917 = phi_1444_;
                                        phi_1445_ = _e917;
                                    } else {
                                        phi_1445_ = _e811;
                                    }
                                    let _e919 = phi_1445_;
                                    phi_1446_ = _e919;
                                } else {
                                    phi_1446_ = _e811;
                                }
                                let _e921 = phi_1446_;
                                phi_1316_ = (_e809 + 1u);
                                phi_1319_ = _e921;
                            } else {
                                phi_1316_ = u32();
                                phi_1319_ = u32();
                            }
                            let _e924 = phi_1316_;
                            let _e926 = phi_1319_;
                            continue;
                            continuing {
                                phi_1315_ = _e924;
                                phi_1318_ = _e926;
                                break if !(_e812);
                            }
                        }
                        let _e930 = nodes.member[(0u + _e535)].links[0u];
                        let _e934 = nodes.member[(0u + _e535)].frame[3u];
                        let _e938 = local_4;
                        if ((_e938 & 4278190080u) == 0u) {
                        } else {
                            let _e942 = local_3.group_mask;
                            if ((_e942 & 4278190080u) == 0u) {
                            } else {
                                let _e946 = local_3.len;
                                if (_e946 < 32u) {
                                    let _e949 = local_3.group;
                                    let _e951 = local_3.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e951)] = _e949;
                                    let _e957 = local_3.group_mask;
                                    let _e959 = local_3.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e959)] = _e957;
                                    let _e966 = local_3.len;
                                    local_3.len = (_e966 + 1u);
                                }
                            }
                            local_3.group = (_e111 + _e930);
                            let _e970 = local_5;
                            local_3.group_mask = ((_e970 & 4278190080u) | (_e934 >> bitcast<u32>(24i)));
                        }
                        let _e975 = local_6;
                        phi_1504_ = (_e975 & 16777215u);
                        phi_1507_ = _e537;
                        loop {
                            let _e978 = phi_1504_;
                            let _e980 = phi_1507_;
                            local_12 = _e980;
                            if (_e978 == 0u) {
                                phi_1505_ = u32();
                                phi_1508_ = lt_bvh_Hit();
                                phi_3387_ = false;
                            } else {
                                let _e984 = nodes.member[(0u + _e535)].links[1u];
                                let _e988 = (_e984 + select(firstTrailingBit(_e978), 32u, (_e978 == 0u)));
                                if (_e988 < _e93) {
                                } else {
                                    return;
                                }
                                let _e995 = instances.member[(0u + _e988)].low_world;
                                let _e997 = instances.member[(0u + _e988)].high_world;
                                let _e1007 = ((_e995.x - _e162.origin.x) * _e316);
                                let _e1008 = ((_e995.y - _e162.origin.y) * _e328);
                                let _e1009 = ((_e995.z - _e162.origin.z) * _e340);
                                let _e1019 = ((_e997.x - _e162.origin.x) * _e316);
                                let _e1020 = ((_e997.y - _e162.origin.y) * _e328);
                                let _e1021 = ((_e997.z - _e162.origin.z) * _e340);
                                if (_e1007 < _e1019) {
                                    phi_1562_ = _e1007;
                                } else {
                                    phi_1562_ = _e1019;
                                }
                                let _e1024 = phi_1562_;
                                if (_e1008 < _e1020) {
                                    phi_1567_ = _e1008;
                                } else {
                                    phi_1567_ = _e1020;
                                }
                                let _e1027 = phi_1567_;
                                if (_e1009 < _e1021) {
                                    phi_1572_ = _e1009;
                                } else {
                                    phi_1572_ = _e1021;
                                }
                                let _e1030 = phi_1572_;
                                if (_e1007 > _e1019) {
                                    phi_1580_ = _e1007;
                                } else {
                                    phi_1580_ = _e1019;
                                }
                                let _e1036 = phi_1580_;
                                if (_e1008 > _e1020) {
                                    phi_1585_ = _e1008;
                                } else {
                                    phi_1585_ = _e1020;
                                }
                                let _e1039 = phi_1585_;
                                if (_e1009 > _e1021) {
                                    phi_1590_ = _e1009;
                                } else {
                                    phi_1590_ = _e1021;
                                }
                                let _e1042 = phi_1590_;
                                let _e1046 = core_intrinsics_maximum_number_nsz_f32_((_e1024 - _e384), (_e1027 - _e385));
                                let _e1047 = core_intrinsics_maximum_number_nsz_f32_(_e1046, (_e1030 - _e386));
                                let _e1048 = core_intrinsics_minimum_number_nsz_f32_((_e1036 + _e384), (_e1039 + _e385));
                                let _e1049 = core_intrinsics_minimum_number_nsz_f32_(_e1048, (_e1042 + _e386));
                                if (_e1047 <= _e1049) {
                                    if (_e1047 <= _e980.t) {
                                        if (_e1049 >= _e162.tmin) {
                                            let _e1061 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1072 = ((((_e1061.x * _e162.origin.x) + (_e1061.y * _e162.origin.y)) + (_e1061.z * _e162.origin.z)) + (_e1061.w * 1f));
                                            let _e1074 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1085 = ((((_e1074.x * _e162.origin.x) + (_e1074.y * _e162.origin.y)) + (_e1074.z * _e162.origin.z)) + (_e1074.w * 1f));
                                            let _e1087 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1098 = ((((_e1087.x * _e162.origin.x) + (_e1087.y * _e162.origin.y)) + (_e1087.z * _e162.origin.z)) + (_e1087.w * 1f));
                                            let _e1105 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1116 = ((((_e1105.x * _e162.direction.x) + (_e1105.y * _e162.direction.y)) + (_e1105.z * _e162.direction.z)) + (_e1105.w * 0f));
                                            let _e1118 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1129 = ((((_e1118.x * _e162.direction.x) + (_e1118.y * _e162.direction.y)) + (_e1118.z * _e162.direction.z)) + (_e1118.w * 0f));
                                            let _e1131 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1142 = ((((_e1131.x * _e162.direction.x) + (_e1131.y * _e162.direction.y)) + (_e1131.z * _e162.direction.z)) + (_e1131.w * 0f));
                                            let _e1147 = instances.member[(0u + _e988)].root;
                                            let _e1149 = instances.member[(0u + _e988)].first_triangle;
                                            let _e1153 = abs(_e1116);
                                            let _e1154 = abs(_e1129);
                                            let _e1155 = abs(_e1142);
                                            if (abs(_e1072) < 1000000000000000f) {
                                                if (abs(_e1085) < 1000000000000000f) {
                                                    if (abs(_e1098) < 1000000000000000f) {
                                                        if (_e1153 < 1000000000000000f) {
                                                            if (_e1154 < 1000000000000000f) {
                                                                if (_e1155 < 1000000000000000f) {
                                                                    if (_e1153 > 0f) {
                                                                        phi_1747_ = bool();
                                                                        phi_1748_ = true;
                                                                    } else {
                                                                        let _e1163 = (_e1154 > 0f);
                                                                        if _e1163 {
                                                                            phi_1746_ = bool();
                                                                        } else {
                                                                            phi_1746_ = (_e1155 > 0f);
                                                                        }
                                                                        let _e1166 = phi_1746_;
                                                                        phi_1747_ = _e1166;
                                                                        phi_1748_ = _e1163;
                                                                    }
                                                                    let _e1168 = phi_1747_;
                                                                    let _e1170 = phi_1748_;
                                                                    if _e1170 {
                                                                        phi_1752_ = true;
                                                                    } else {
                                                                        phi_1752_ = _e1168;
                                                                    }
                                                                    let _e1172 = phi_1752_;
                                                                    phi_1753_ = _e1172;
                                                                    phi_1754_ = false;
                                                                } else {
                                                                    phi_1753_ = bool();
                                                                    phi_1754_ = true;
                                                                }
                                                                let _e1174 = phi_1753_;
                                                                let _e1176 = phi_1754_;
                                                                phi_1755_ = _e1174;
                                                                phi_1756_ = false;
                                                                phi_1757_ = _e1176;
                                                            } else {
                                                                phi_1755_ = bool();
                                                                phi_1756_ = true;
                                                                phi_1757_ = false;
                                                            }
                                                            let _e1178 = phi_1755_;
                                                            let _e1180 = phi_1756_;
                                                            let _e1182 = phi_1757_;
                                                            phi_1758_ = _e1178;
                                                            phi_1759_ = _e1180;
                                                            phi_1760_ = _e1182;
                                                        } else {
                                                            phi_1758_ = bool();
                                                            phi_1759_ = true;
                                                            phi_1760_ = false;
                                                        }
                                                        let _e1184 = phi_1758_;
                                                        let _e1186 = phi_1759_;
                                                        let _e1188 = phi_1760_;
                                                        phi_1761_ = _e1184;
                                                        phi_1762_ = _e1186;
                                                        phi_1763_ = _e1188;
                                                    } else {
                                                        phi_1761_ = bool();
                                                        phi_1762_ = true;
                                                        phi_1763_ = false;
                                                    }
                                                    let _e1190 = phi_1761_;
                                                    let _e1192 = phi_1762_;
                                                    let _e1194 = phi_1763_;
                                                    phi_1764_ = _e1190;
                                                    phi_1765_ = _e1192;
                                                    phi_1766_ = _e1194;
                                                } else {
                                                    phi_1764_ = bool();
                                                    phi_1765_ = true;
                                                    phi_1766_ = false;
                                                }
                                                let _e1196 = phi_1764_;
                                                let _e1198 = phi_1765_;
                                                let _e1200 = phi_1766_;
                                                phi_1767_ = _e1196;
                                                phi_1768_ = _e1198;
                                                phi_1769_ = _e1200;
                                            } else {
                                                phi_1767_ = bool();
                                                phi_1768_ = true;
                                                phi_1769_ = false;
                                            }
                                            let _e1202 = phi_1767_;
                                            let _e1204 = phi_1768_;
                                            let _e1206 = phi_1769_;
                                            if _e1204 {
                                                phi_1773_ = true;
                                            } else {
                                                phi_1773_ = _e1206;
                                            }
                                            let _e1208 = phi_1773_;
                                            if _e1208 {
                                                phi_1777_ = false;
                                            } else {
                                                phi_1777_ = _e1202;
                                            }
                                            let _e1210 = phi_1777_;
                                            if _e1210 {
                                                let _e1211 = (_e1147 >= _e78);
                                                if _e1211 {
                                                    phi_3377_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1147 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1217 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1221 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1225 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1229 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1233 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1237 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1241 = nodes.member[(0u + _e1147)].frame[3u];
                                                    let _e1275 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1116), abs(_e1129));
                                                    let _e1276 = core_intrinsics_maximum_number_nsz_f32_(_e1275, abs(_e1142));
                                                    let _e1277 = (_e1276 * 0.0000000000009094947f);
                                                    if (abs(_e1116) < _e1277) {
                                                        phi_1847_ = _e1277;
                                                    } else {
                                                        phi_1847_ = abs(_e1116);
                                                    }
                                                    let _e1282 = phi_1847_;
                                                    if (_e1116 < 0f) {
                                                        phi_1854_ = (-1f / _e1282);
                                                    } else {
                                                        phi_1854_ = (1f / _e1282);
                                                    }
                                                    let _e1287 = phi_1854_;
                                                    if (abs(_e1129) < _e1277) {
                                                        phi_1861_ = _e1277;
                                                    } else {
                                                        phi_1861_ = abs(_e1129);
                                                    }
                                                    let _e1292 = phi_1861_;
                                                    if (_e1129 < 0f) {
                                                        phi_1868_ = (-1f / _e1292);
                                                    } else {
                                                        phi_1868_ = (1f / _e1292);
                                                    }
                                                    let _e1297 = phi_1868_;
                                                    if (abs(_e1142) < _e1277) {
                                                        phi_1875_ = _e1277;
                                                    } else {
                                                        phi_1875_ = abs(_e1142);
                                                    }
                                                    let _e1302 = phi_1875_;
                                                    if (_e1142 < 0f) {
                                                        phi_1882_ = (-1f / _e1302);
                                                    } else {
                                                        phi_1882_ = (1f / _e1302);
                                                    }
                                                    let _e1307 = phi_1882_;
                                                    let _e1311 = abs((bitcast<f32>(_e1217) - _e1072));
                                                    let _e1312 = abs((bitcast<f32>(_e1221) - _e1085));
                                                    let _e1313 = abs((bitcast<f32>(_e1225) - _e1098));
                                                    let _e1317 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    let _e1318 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1085));
                                                    let _e1319 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1098));
                                                    if (_e1311 > _e1317) {
                                                        phi_1899_ = _e1311;
                                                    } else {
                                                        phi_1899_ = _e1317;
                                                    }
                                                    let _e1322 = phi_1899_;
                                                    if (_e1312 > _e1318) {
                                                        phi_1904_ = _e1312;
                                                    } else {
                                                        phi_1904_ = _e1318;
                                                    }
                                                    let _e1325 = phi_1904_;
                                                    if (_e1313 > _e1319) {
                                                        phi_1909_ = _e1313;
                                                    } else {
                                                        phi_1909_ = _e1319;
                                                    }
                                                    let _e1328 = phi_1909_;
                                                    let _e1329 = core_intrinsics_maximum_number_nsz_f32_(_e1322, _e1325);
                                                    let _e1330 = core_intrinsics_maximum_number_nsz_f32_(_e1329, _e1328);
                                                    let _e1334 = (_e1330 * 0.0000019073486f);
                                                    let _e1335 = (abs(_e1287) * _e1334);
                                                    let _e1336 = (abs(_e1297) * _e1334);
                                                    let _e1337 = (abs(_e1307) * _e1334);
                                                    let _e1341 = (_e1330 * 0.0000009536743f);
                                                    let _e1342 = (abs(_e1287) * _e1341);
                                                    let _e1343 = (abs(_e1297) * _e1341);
                                                    let _e1344 = (abs(_e1307) * _e1341);
                                                    let _e1345 = abs(_e1116);
                                                    let _e1346 = abs(_e1129);
                                                    let _e1347 = abs(_e1142);
                                                    if (_e1345 >= _e1346) {
                                                        if (_e1345 >= _e1347) {
                                                            phi_1937_ = false;
                                                        } else {
                                                            phi_1937_ = true;
                                                        }
                                                        let _e1351 = phi_1937_;
                                                        phi_1938_ = _e1351;
                                                    } else {
                                                        phi_1938_ = true;
                                                    }
                                                    let _e1353 = phi_1938_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1946_ = 1u;
                                                        } else {
                                                            phi_1946_ = 2u;
                                                        }
                                                        let _e1356 = phi_1946_;
                                                        phi_1947_ = _e1356;
                                                    } else {
                                                        phi_1947_ = 0u;
                                                    }
                                                    let _e1358 = phi_1947_;
                                                    if (_e1358 == 0u) {
                                                        phi_1959_ = vec3<f32>(_e1129, _e1142, _e1116);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1958_ = vec3<f32>(_e1142, _e1116, _e1129);
                                                        } else {
                                                            phi_1958_ = vec3<f32>(_e1116, _e1129, _e1142);
                                                        }
                                                        let _e1364 = phi_1958_;
                                                        phi_1959_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1959_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    if (_e1287 < 0f) {
                                                        phi_1972_ = 0u;
                                                    } else {
                                                        phi_1972_ = 1u;
                                                    }
                                                    let _e1377 = phi_1972_;
                                                    if (_e1297 < 0f) {
                                                        phi_1977_ = 0u;
                                                    } else {
                                                        phi_1977_ = 2u;
                                                    }
                                                    let _e1380 = phi_1977_;
                                                    if (_e1307 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 4u;
                                                    }
                                                    let _e1383 = phi_1982_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1147, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_2.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_2.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2096_ = false;
                                                        } else {
                                                            let _e1468 = local_2.len;
                                                            local_2.len = (_e1468 - 1u);
                                                            let _e1471 = local_2.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_2.first[(0u + _e1471)];
                                                            local_2.group = _e1476;
                                                            let _e1479 = local_2.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_2.mask[(0u + _e1479)];
                                                            local_2.group_mask = _e1484;
                                                            phi_2096_ = true;
                                                        }
                                                        let _e1487 = phi_2096_;
                                                        phi_2097_ = _e1487;
                                                    } else {
                                                        phi_2097_ = true;
                                                    }
                                                    let _e1489 = phi_2097_;
                                                    if _e1489 {
                                                        let _e1491 = local_2.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_2.group_mask;
                                                        let _e1515 = local_2.group_mask;
                                                        local_2.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_2.group;
                                                        phi_2128_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2128_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2128_;
                                                    phi_2130_ = _e980;
                                                    phi_2133_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2130_;
                                                        let _e1525 = phi_2133_;
                                                        local_11 = _e1523;
                                                        let _e1526 = (_e1525 != 4294967295u);
                                                        if _e1526 {
                                                            if (_e1525 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1533 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1558 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1287);
                                                            let _e1559 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1297);
                                                            let _e1560 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1307);
                                                            let _e1563 = nodes.member[(0u + _e1525)].frame[0u];
                                                            let _e1567 = nodes.member[(0u + _e1525)].frame[1u];
                                                            let _e1571 = nodes.member[(0u + _e1525)].frame[2u];
                                                            let _e1576 = ((bitcast<f32>(_e1563) - _e1072) * _e1287);
                                                            let _e1577 = ((bitcast<f32>(_e1567) - _e1085) * _e1297);
                                                            let _e1578 = ((bitcast<f32>(_e1571) - _e1098) * _e1307);
                                                            let _e1586 = nodes.member[(0u + _e1525)].x;
                                                            if (_e1287 < 0f) {
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1597.unnamed.word, _e1586.w), _e1597.unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1603.unnamed, lt_mask_LightPlace(_e1586.x, _e1603.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1609.unnamed_1.word, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1625.unnamed.word, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_mask_LightPlace(_e1586.z, _e1631.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_mask_LightPlace(_e1637.unnamed_1.word, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2214_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1297 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1666.unnamed.word, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_mask_LightPlace(_e1655.x, _e1672.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1678.unnamed_1.word, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1694.unnamed.word, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_mask_LightPlace(_e1655.z, _e1700.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_mask_LightPlace(_e1706.unnamed_1.word, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2241_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1307 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1735.unnamed.word, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_mask_LightPlace(_e1724.x, _e1741.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_mask_LightPlace(_e1747.unnamed_1.word, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1763.unnamed.word, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_mask_LightPlace(_e1724.z, _e1769.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_mask_LightPlace(_e1775.unnamed_1.word, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2268_;
                                                            phi_2274_ = 0u;
                                                            phi_2277_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2274_;
                                                                let _e1795 = phi_2277_;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                local_9 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2291_ = _e1645.unnamed.word;
                                                                    } else {
                                                                        phi_2291_ = _e1645.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2291_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2301_ = _e1714.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1714.unnamed.shift;
                                                                    }
                                                                    let _e1811 = phi_2301_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2311_ = _e1783.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1783.unnamed.shift;
                                                                    }
                                                                    let _e1820 = phi_2311_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2329_ = _e1645.unnamed_1.word;
                                                                    } else {
                                                                        phi_2329_ = _e1645.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2329_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2339_ = _e1714.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1714.unnamed_1.shift;
                                                                    }
                                                                    let _e1846 = phi_2339_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2349_ = _e1783.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1783.unnamed_1.shift;
                                                                    }
                                                                    let _e1855 = phi_2349_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e162.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2385_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2385_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2385_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2398_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2398_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2398_;
                                                                                phi_2403_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2403_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2403_;
                                                                            phi_2404_ = _e1901;
                                                                        } else {
                                                                            phi_2404_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2404_;
                                                                        phi_2405_ = _e1903;
                                                                    } else {
                                                                        phi_2405_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2405_;
                                                                    phi_2275_ = (_e1793 + 1u);
                                                                    phi_2278_ = _e1905;
                                                                } else {
                                                                    phi_2275_ = u32();
                                                                    phi_2278_ = u32();
                                                                }
                                                                let _e1908 = phi_2275_;
                                                                let _e1910 = phi_2278_;
                                                                continue;
                                                                continuing {
                                                                    phi_2274_ = _e1908;
                                                                    phi_2277_ = _e1910;
                                                                    break if !(_e1796);
                                                                }
                                                            }
                                                            let _e1914 = nodes.member[(0u + _e1525)].links[0u];
                                                            let _e1918 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1922 = local_7;
                                                            if ((_e1922 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1926 = local_2.group_mask;
                                                                if ((_e1926 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1930 = local_2.len;
                                                                    if (_e1930 < 32u) {
                                                                        let _e1933 = local_2.group;
                                                                        let _e1935 = local_2.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1935)] = _e1933;
                                                                        let _e1941 = local_2.group_mask;
                                                                        let _e1943 = local_2.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1943)] = _e1941;
                                                                        let _e1950 = local_2.len;
                                                                        local_2.len = (_e1950 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1147 + _e1914);
                                                                let _e1954 = local_8;
                                                                local_2.group_mask = ((_e1954 & 4278190080u) | (_e1918 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1959 = local_9;
                                                            phi_2463_ = _e1523;
                                                            phi_2466_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2463_;
                                                                let _e1964 = phi_2466_;
                                                                local_10 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2464_ = lt_bvh_Hit();
                                                                    phi_2467_ = u32();
                                                                    phi_3305_ = false;
                                                                } else {
                                                                    let _e1968 = nodes.member[(0u + _e1525)].links[1u];
                                                                    let _e1973 = ((_e1149 + _e1968) + select(firstTrailingBit(_e1964), 32u, (_e1964 == 0u)));
                                                                    if (_e1973 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1980 = triangles.member[(0u + _e1973)].v0_;
                                                                    let _e1982 = (_e1980.x - _e1072);
                                                                    let _e1984 = (_e1980.y - _e1085);
                                                                    let _e1986 = (_e1980.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2511_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2510_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2510_ = (_e1980 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e1994 = phi_2510_;
                                                                        phi_2511_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2511_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2006 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2008 = (_e2006.x - _e1072);
                                                                    let _e2010 = (_e2006.y - _e1085);
                                                                    let _e2012 = (_e2006.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2541_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2540_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                        } else {
                                                                            phi_2540_ = (_e2006 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2020 = phi_2540_;
                                                                        phi_2541_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2541_;
                                                                    let _e2026 = (_e2022.x - (_e1369 * _e2022.z));
                                                                    let _e2030 = (_e2022.y - (_e1372 * _e2022.z));
                                                                    let _e2032 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1072);
                                                                    let _e2036 = (_e2032.y - _e1085);
                                                                    let _e2038 = (_e2032.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2571_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2570_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2570_ = (_e2032 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2046 = phi_2570_;
                                                                        phi_2571_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2571_;
                                                                    let _e2052 = (_e2048.x - (_e1369 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1372 * _e2048.z));
                                                                    if (_e2026 < _e2052) {
                                                                        phi_2590_ = true;
                                                                    } else {
                                                                        if (_e2026 == _e2052) {
                                                                            phi_2589_ = (_e2030 < _e2056);
                                                                        } else {
                                                                            phi_2589_ = false;
                                                                        }
                                                                        let _e2061 = phi_2589_;
                                                                        phi_2590_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2590_;
                                                                    if _e2063 {
                                                                        phi_2594_ = _e2056;
                                                                        phi_2595_ = _e2052;
                                                                        phi_2596_ = _e2030;
                                                                        phi_2597_ = _e2026;
                                                                    } else {
                                                                        phi_2594_ = _e2030;
                                                                        phi_2595_ = _e2026;
                                                                        phi_2596_ = _e2056;
                                                                        phi_2597_ = _e2052;
                                                                    }
                                                                    let _e2065 = phi_2594_;
                                                                    let _e2067 = phi_2595_;
                                                                    let _e2069 = phi_2596_;
                                                                    let _e2071 = phi_2597_;
                                                                    let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                    if _e2063 {
                                                                        phi_2605_ = -(_e2074);
                                                                    } else {
                                                                        phi_2605_ = _e2074;
                                                                    }
                                                                    let _e2077 = phi_2605_;
                                                                    if (_e2052 < _e2000) {
                                                                        phi_2616_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e2000) {
                                                                            phi_2615_ = (_e2056 < _e2004);
                                                                        } else {
                                                                            phi_2615_ = false;
                                                                        }
                                                                        let _e2082 = phi_2615_;
                                                                        phi_2616_ = _e2082;
                                                                    }
                                                                    let _e2084 = phi_2616_;
                                                                    if _e2084 {
                                                                        phi_2620_ = _e2004;
                                                                        phi_2621_ = _e2000;
                                                                        phi_2622_ = _e2056;
                                                                        phi_2623_ = _e2052;
                                                                    } else {
                                                                        phi_2620_ = _e2056;
                                                                        phi_2621_ = _e2052;
                                                                        phi_2622_ = _e2004;
                                                                        phi_2623_ = _e2000;
                                                                    }
                                                                    let _e2086 = phi_2620_;
                                                                    let _e2088 = phi_2621_;
                                                                    let _e2090 = phi_2622_;
                                                                    let _e2092 = phi_2623_;
                                                                    let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                    if _e2084 {
                                                                        phi_2631_ = -(_e2095);
                                                                    } else {
                                                                        phi_2631_ = _e2095;
                                                                    }
                                                                    let _e2098 = phi_2631_;
                                                                    if (_e2000 < _e2026) {
                                                                        phi_2642_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2026) {
                                                                            phi_2641_ = (_e2004 < _e2030);
                                                                        } else {
                                                                            phi_2641_ = false;
                                                                        }
                                                                        let _e2103 = phi_2641_;
                                                                        phi_2642_ = _e2103;
                                                                    }
                                                                    let _e2105 = phi_2642_;
                                                                    if _e2105 {
                                                                        phi_2646_ = _e2030;
                                                                        phi_2647_ = _e2026;
                                                                        phi_2648_ = _e2004;
                                                                        phi_2649_ = _e2000;
                                                                    } else {
                                                                        phi_2646_ = _e2004;
                                                                        phi_2647_ = _e2000;
                                                                        phi_2648_ = _e2030;
                                                                        phi_2649_ = _e2026;
                                                                    }
                                                                    let _e2107 = phi_2646_;
                                                                    let _e2109 = phi_2647_;
                                                                    let _e2111 = phi_2648_;
                                                                    let _e2113 = phi_2649_;
                                                                    let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                    if _e2105 {
                                                                        phi_2657_ = -(_e2116);
                                                                    } else {
                                                                        phi_2657_ = _e2116;
                                                                    }
                                                                    let _e2119 = phi_2657_;
                                                                    if (_e2077 >= 0f) {
                                                                        if (_e2098 >= 0f) {
                                                                            if (_e2119 >= 0f) {
                                                                                phi_2672_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2673_ = false;
                                                                            } else {
                                                                                phi_2672_ = f32();
                                                                                phi_2673_ = true;
                                                                            }
                                                                            let _e2126 = phi_2672_;
                                                                            let _e2128 = phi_2673_;
                                                                            phi_2674_ = _e2126;
                                                                            phi_2675_ = _e2128;
                                                                        } else {
                                                                            phi_2674_ = f32();
                                                                            phi_2675_ = true;
                                                                        }
                                                                        let _e2130 = phi_2674_;
                                                                        let _e2132 = phi_2675_;
                                                                        phi_2676_ = _e2130;
                                                                        phi_2677_ = _e2132;
                                                                    } else {
                                                                        phi_2676_ = f32();
                                                                        phi_2677_ = true;
                                                                    }
                                                                    let _e2134 = phi_2676_;
                                                                    let _e2136 = phi_2677_;
                                                                    if _e2136 {
                                                                        if (_e2077 <= 0f) {
                                                                            if (_e2098 <= 0f) {
                                                                                let _e2139 = (_e2119 <= 0f);
                                                                                if _e2139 {
                                                                                }
                                                                                phi_2695_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2696_ = false;
                                                                                phi_2697_ = _e2139;
                                                                            } else {
                                                                                phi_2695_ = f32();
                                                                                phi_2696_ = true;
                                                                                phi_2697_ = false;
                                                                            }
                                                                            let _e2143 = phi_2695_;
                                                                            let _e2145 = phi_2696_;
                                                                            let _e2147 = phi_2697_;
                                                                            phi_2698_ = _e2143;
                                                                            phi_2699_ = _e2145;
                                                                            phi_2700_ = _e2147;
                                                                        } else {
                                                                            phi_2698_ = f32();
                                                                            phi_2699_ = true;
                                                                            phi_2700_ = false;
                                                                        }
                                                                        let _e2149 = phi_2698_;
                                                                        let _e2151 = phi_2699_;
                                                                        let _e2153 = phi_2700_;
                                                                        if _e2151 {
                                                                            phi_2704_ = false;
                                                                        } else {
                                                                            phi_2704_ = _e2153;
                                                                        }
                                                                        let _e2155 = phi_2704_;
                                                                        phi_2705_ = _e2149;
                                                                        phi_2706_ = _e2155;
                                                                    } else {
                                                                        phi_2705_ = _e2134;
                                                                        phi_2706_ = true;
                                                                    }
                                                                    let _e2157 = phi_2705_;
                                                                    let _e2159 = phi_2706_;
                                                                    if _e2159 {
                                                                        let _e2160 = (_e2157 == 0f);
                                                                        if _e2160 {
                                                                            phi_3022_ = lt_bvh_triangle_Intersection();
                                                                            phi_3023_ = false;
                                                                        } else {
                                                                            let _e2162 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2164 = (_e2162.x - _e1072);
                                                                            let _e2166 = (_e2162.y - _e1085);
                                                                            let _e2168 = (_e2162.z - _e1098);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2735_ = vec3<f32>(_e2166, _e2168, _e2164);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2734_ = vec3<f32>(_e2168, _e2164, _e2166);
                                                                                } else {
                                                                                    phi_2734_ = (_e2162 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                                }
                                                                                let _e2176 = phi_2734_;
                                                                                phi_2735_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2735_;
                                                                            let _e2180 = triangles.member[(0u + _e1973)].v1_;
                                                                            let _e2182 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2761_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2760_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2760_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2760_;
                                                                                phi_2761_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2761_;
                                                                            let _e2202 = triangles.member[(0u + _e1973)].v2_;
                                                                            let _e2204 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2207 = (_e2202.x - _e2204.x);
                                                                            let _e2210 = (_e2202.y - _e2204.y);
                                                                            let _e2213 = (_e2202.z - _e2204.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2787_ = vec3<f32>(_e2210, _e2213, _e2207);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2786_ = vec3<f32>(_e2213, _e2207, _e2210);
                                                                                } else {
                                                                                    phi_2786_ = (_e2202 - _e2204);
                                                                                }
                                                                                let _e2220 = phi_2786_;
                                                                                phi_2787_ = _e2220;
                                                                            }
                                                                            let _e2222 = phi_2787_;
                                                                            let _e2229 = ((_e2200.y * _e2222.z) - (_e2200.z * _e2222.y));
                                                                            let _e2236 = ((_e2200.z * _e2222.x) - (_e2200.x * _e2222.z));
                                                                            let _e2243 = ((_e2200.x * _e2222.y) - (_e2200.y * _e2222.x));
                                                                            let _e2257 = (((1f / _e1366.z) * (((_e2229 * _e2178.x) + (_e2236 * _e2178.y)) + (_e2243 * _e2178.z))) / (((_e2229 * _e1369) + (_e2236 * _e1372)) + _e2243));
                                                                            if (_e2257 > _e162.tmin) {
                                                                                if (_e2257 < _e162.tmax) {
                                                                                    let _e2261 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2263 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2261.x < _e2263.x) {
                                                                                        phi_2843_ = _e2261.x;
                                                                                    } else {
                                                                                        phi_2843_ = _e2263.x;
                                                                                    }
                                                                                    let _e2270 = phi_2843_;
                                                                                    if (_e2261.y < _e2263.y) {
                                                                                        phi_2852_ = _e2261.y;
                                                                                    } else {
                                                                                        phi_2852_ = _e2263.y;
                                                                                    }
                                                                                    let _e2277 = phi_2852_;
                                                                                    if (_e2261.z < _e2263.z) {
                                                                                        phi_2861_ = _e2261.z;
                                                                                    } else {
                                                                                        phi_2861_ = _e2263.z;
                                                                                    }
                                                                                    let _e2284 = phi_2861_;
                                                                                    let _e2286 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2270 < _e2286.x) {
                                                                                        phi_2870_ = _e2270;
                                                                                    } else {
                                                                                        phi_2870_ = _e2286.x;
                                                                                    }
                                                                                    let _e2291 = phi_2870_;
                                                                                    if (_e2277 < _e2286.y) {
                                                                                        phi_2877_ = _e2277;
                                                                                    } else {
                                                                                        phi_2877_ = _e2286.y;
                                                                                    }
                                                                                    let _e2296 = phi_2877_;
                                                                                    if (_e2284 < _e2286.z) {
                                                                                        phi_2884_ = _e2284;
                                                                                    } else {
                                                                                        phi_2884_ = _e2286.z;
                                                                                    }
                                                                                    let _e2301 = phi_2884_;
                                                                                    let _e2303 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2305 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2303.x > _e2305.x) {
                                                                                        phi_2897_ = _e2303.x;
                                                                                    } else {
                                                                                        phi_2897_ = _e2305.x;
                                                                                    }
                                                                                    let _e2312 = phi_2897_;
                                                                                    if (_e2303.y > _e2305.y) {
                                                                                        phi_2906_ = _e2303.y;
                                                                                    } else {
                                                                                        phi_2906_ = _e2305.y;
                                                                                    }
                                                                                    let _e2319 = phi_2906_;
                                                                                    if (_e2303.z > _e2305.z) {
                                                                                        phi_2915_ = _e2303.z;
                                                                                    } else {
                                                                                        phi_2915_ = _e2305.z;
                                                                                    }
                                                                                    let _e2326 = phi_2915_;
                                                                                    let _e2328 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2312 > _e2328.x) {
                                                                                        phi_2924_ = _e2312;
                                                                                    } else {
                                                                                        phi_2924_ = _e2328.x;
                                                                                    }
                                                                                    let _e2333 = phi_2924_;
                                                                                    if (_e2319 > _e2328.y) {
                                                                                        phi_2931_ = _e2319;
                                                                                    } else {
                                                                                        phi_2931_ = _e2328.y;
                                                                                    }
                                                                                    let _e2338 = phi_2931_;
                                                                                    if (_e2326 > _e2328.z) {
                                                                                        phi_2938_ = _e2326;
                                                                                    } else {
                                                                                        phi_2938_ = _e2328.z;
                                                                                    }
                                                                                    let _e2343 = phi_2938_;
                                                                                    let _e2347 = ((_e2291 - _e1072) * _e1287);
                                                                                    let _e2348 = ((_e2296 - _e1085) * _e1297);
                                                                                    let _e2349 = ((_e2301 - _e1098) * _e1307);
                                                                                    let _e2353 = ((_e2333 - _e1072) * _e1287);
                                                                                    let _e2354 = ((_e2338 - _e1085) * _e1297);
                                                                                    let _e2355 = ((_e2343 - _e1098) * _e1307);
                                                                                    if (_e2347 < _e2353) {
                                                                                        phi_2955_ = _e2347;
                                                                                    } else {
                                                                                        phi_2955_ = _e2353;
                                                                                    }
                                                                                    let _e2358 = phi_2955_;
                                                                                    if (_e2348 < _e2354) {
                                                                                        phi_2960_ = _e2348;
                                                                                    } else {
                                                                                        phi_2960_ = _e2354;
                                                                                    }
                                                                                    let _e2361 = phi_2960_;
                                                                                    if (_e2349 < _e2355) {
                                                                                        phi_2965_ = _e2349;
                                                                                    } else {
                                                                                        phi_2965_ = _e2355;
                                                                                    }
                                                                                    let _e2364 = phi_2965_;
                                                                                    if (_e2347 > _e2353) {
                                                                                        phi_2973_ = _e2347;
                                                                                    } else {
                                                                                        phi_2973_ = _e2353;
                                                                                    }
                                                                                    let _e2370 = phi_2973_;
                                                                                    if (_e2348 > _e2354) {
                                                                                        phi_2978_ = _e2348;
                                                                                    } else {
                                                                                        phi_2978_ = _e2354;
                                                                                    }
                                                                                    let _e2373 = phi_2978_;
                                                                                    if (_e2349 > _e2355) {
                                                                                        phi_2983_ = _e2349;
                                                                                    } else {
                                                                                        phi_2983_ = _e2355;
                                                                                    }
                                                                                    let _e2376 = phi_2983_;
                                                                                    let _e2380 = core_intrinsics_maximum_number_nsz_f32_((_e2358 - _e1342), (_e2361 - _e1343));
                                                                                    let _e2381 = core_intrinsics_maximum_number_nsz_f32_(_e2380, (_e2364 - _e1344));
                                                                                    let _e2382 = core_intrinsics_minimum_number_nsz_f32_((_e2370 + _e1342), (_e2373 + _e1343));
                                                                                    let _e2383 = core_intrinsics_minimum_number_nsz_f32_(_e2382, (_e2376 + _e1344));
                                                                                    if (_e2381 > _e1047) {
                                                                                        phi_2995_ = _e2381;
                                                                                    } else {
                                                                                        phi_2995_ = _e1047;
                                                                                    }
                                                                                    let _e2386 = phi_2995_;
                                                                                    if (_e2383 < _e1049) {
                                                                                        phi_3000_ = _e2383;
                                                                                    } else {
                                                                                        phi_3000_ = _e1049;
                                                                                    }
                                                                                    let _e2389 = phi_3000_;
                                                                                    if (_e2257 < _e2386) {
                                                                                        phi_3005_ = _e2386;
                                                                                    } else {
                                                                                        phi_3005_ = _e2257;
                                                                                    }
                                                                                    let _e2392 = phi_3005_;
                                                                                    if (_e2392 > _e2389) {
                                                                                        phi_3010_ = _e2389;
                                                                                    } else {
                                                                                        phi_3010_ = _e2392;
                                                                                    }
                                                                                    let _e2395 = phi_3010_;
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection(_e2395, (_e2098 / _e2157), (_e2119 / _e2157), (_e2386 <= _e2389));
                                                                                    phi_3016_ = false;
                                                                                } else {
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3016_ = true;
                                                                                }
                                                                                let _e2401 = phi_3015_;
                                                                                let _e2403 = phi_3016_;
                                                                                phi_3017_ = _e2401;
                                                                                phi_3018_ = _e2403;
                                                                            } else {
                                                                                phi_3017_ = lt_bvh_triangle_Intersection();
                                                                                phi_3018_ = true;
                                                                            }
                                                                            let _e2405 = phi_3017_;
                                                                            let _e2407 = phi_3018_;
                                                                            if _e2407 {
                                                                            }
                                                                            phi_3022_ = _e2405;
                                                                            phi_3023_ = _e2407;
                                                                        }
                                                                        let _e2409 = phi_3022_;
                                                                        let _e2411 = phi_3023_;
                                                                        phi_3024_ = _e2409;
                                                                        phi_3025_ = _e2160;
                                                                        phi_3026_ = _e2411;
                                                                    } else {
                                                                        phi_3024_ = lt_bvh_triangle_Intersection();
                                                                        phi_3025_ = true;
                                                                        phi_3026_ = false;
                                                                    }
                                                                    let _e2413 = phi_3024_;
                                                                    let _e2415 = phi_3025_;
                                                                    let _e2417 = phi_3026_;
                                                                    if _e2415 {
                                                                        phi_3030_ = true;
                                                                    } else {
                                                                        phi_3030_ = _e2417;
                                                                    }
                                                                    let _e2419 = phi_3030_;
                                                                    if _e2419 {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3034_ = _e2413;
                                                                    }
                                                                    let _e2421 = phi_3034_;
                                                                    if _e2421.is_hit {
                                                                        if (_e2421.t > _e162.tmin) {
                                                                            if (_e2421.t < _e1962.t) {
                                                                                phi_3082_ = true;
                                                                            } else {
                                                                                if (_e2421.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_3073_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_3072_ = (_e988 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_3072_ = false;
                                                                                            }
                                                                                            let _e2439 = phi_3072_;
                                                                                            phi_3073_ = _e2439;
                                                                                        }
                                                                                        let _e2441 = phi_3073_;
                                                                                        phi_3074_ = _e2441;
                                                                                        phi_3075_ = false;
                                                                                    } else {
                                                                                        phi_3074_ = bool();
                                                                                        phi_3075_ = true;
                                                                                    }
                                                                                    let _e2443 = phi_3074_;
                                                                                    let _e2445 = phi_3075_;
                                                                                    phi_3076_ = _e2443;
                                                                                    phi_3077_ = _e2445;
                                                                                } else {
                                                                                    phi_3076_ = bool();
                                                                                    phi_3077_ = true;
                                                                                }
                                                                                let _e2447 = phi_3076_;
                                                                                let _e2449 = phi_3077_;
                                                                                if _e2449 {
                                                                                    phi_3081_ = false;
                                                                                } else {
                                                                                    phi_3081_ = _e2447;
                                                                                }
                                                                                let _e2451 = phi_3081_;
                                                                                phi_3082_ = _e2451;
                                                                            }
                                                                            let _e2453 = phi_3082_;
                                                                            if _e2453 {
                                                                                let _e2455 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2455 & 2147483648u) == 0u) {
                                                                                    phi_3293_ = true;
                                                                                } else {
                                                                                    if (_e1973 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2464 = triangles.member[(0u + _e1973)].i0_;
                                                                                    let _e2465 = (_e2464 & 2147483647u);
                                                                                    let _e2467 = triangles.member[(0u + _e1973)].i1_;
                                                                                    let _e2469 = triangles.member[(0u + _e1973)].i2_;
                                                                                    if (_e2465 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2473 = vertices.member[(0u + _e2465)];
                                                                                    if (_e2467 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2477 = vertices.member[(0u + _e2467)];
                                                                                    if (_e2469 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2481 = vertices.member[(0u + _e2469)];
                                                                                    let _e2482 = array<abi_Vertex, 3>(_e2473, _e2477, _e2481);
                                                                                    if (_e2482[0].material < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2488 = materials.member[(0u + _e2482[0].material)];
                                                                                    if ((_e2488.flags & 0u) == 0u) {
                                                                                        let _e2493 = ((1f - _e2421.u) - _e2421.v);
                                                                                        if (_e2488.cutoff <= 0f) {
                                                                                            phi_3288_ = true;
                                                                                        } else {
                                                                                            let _e2520 = (_e2488.base_color.w * ((((f32((_e2482[0].color >> bitcast<u32>(24i))) * _e2493) + (f32((_e2482[1].color >> bitcast<u32>(24i))) * _e2421.u)) + (f32((_e2482[2].color >> bitcast<u32>(24i))) * _e2421.v)) * (1f / 255f)));
                                                                                            if (_e2488.alpha_size == 0u) {
                                                                                                phi_3285_ = _e2520;
                                                                                            } else {
                                                                                                local_1.offset = _e2488.alpha_offset;
                                                                                                local_1.size = _e2488.alpha_size;
                                                                                                local_1.flags = _e2488.flags;
                                                                                                let _e2551 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2482[0].u * _e2493) + (_e2482[1].u * _e2421.u)) + (_e2482[2].u * _e2421.v)), (((_e2482[0].v * _e2493) + (_e2482[1].v * _e2421.u)) + (_e2482[2].v * _e2421.v)));
                                                                                                let _e2555 = (_e2551.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2555 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2559 = alpha_texels.member[(0u + _e2555)];
                                                                                                let _e2575 = (_e2551.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2575 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2579 = alpha_texels.member[(0u + _e2575)];
                                                                                                let _e2596 = (_e2551.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2596 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2600 = alpha_texels.member[(0u + _e2596)];
                                                                                                let _e2617 = (_e2551.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2617 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2621 = alpha_texels.member[(0u + _e2617)];
                                                                                                phi_3285_ = (_e2520 * (((((f32(((_e2559 >> bitcast<u32>((((_e2551.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.x) + ((f32(((_e2579 >> bitcast<u32>((((_e2551.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.y)) + ((f32(((_e2600 >> bitcast<u32>((((_e2551.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.z)) + ((f32(((_e2621 >> bitcast<u32>((((_e2551.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.w)));
                                                                                            }
                                                                                            let _e2637 = phi_3285_;
                                                                                            phi_3288_ = (_e2637 >= _e2488.cutoff);
                                                                                        }
                                                                                        let _e2641 = phi_3288_;
                                                                                        phi_3289_ = _e2641;
                                                                                    } else {
                                                                                        phi_3289_ = false;
                                                                                    }
                                                                                    let _e2643 = phi_3289_;
                                                                                    if _e2643 {
                                                                                    }
                                                                                    phi_3293_ = _e2643;
                                                                                }
                                                                                let _e2645 = phi_3293_;
                                                                                if _e2645 {
                                                                                    phi_3301_ = lt_bvh_Hit(_e2421.t, _e2421.u, _e2421.v, _e1973, _e988);
                                                                                } else {
                                                                                    phi_3301_ = _e1962;
                                                                                }
                                                                                let _e2651 = phi_3301_;
                                                                                phi_3302_ = _e2651;
                                                                            } else {
                                                                                phi_3302_ = _e1962;
                                                                            }
                                                                            let _e2653 = phi_3302_;
                                                                            phi_3303_ = _e2653;
                                                                        } else {
                                                                            phi_3303_ = _e1962;
                                                                        }
                                                                        let _e2655 = phi_3303_;
                                                                        phi_3304_ = _e2655;
                                                                    } else {
                                                                        phi_3304_ = _e1962;
                                                                    }
                                                                    let _e2657 = phi_3304_;
                                                                    phi_2464_ = _e2657;
                                                                    phi_2467_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3305_ = true;
                                                                }
                                                                let _e2659 = phi_2464_;
                                                                let _e2661 = phi_2467_;
                                                                let _e2663 = phi_3305_;
                                                                continue;
                                                                continuing {
                                                                    phi_2463_ = _e2659;
                                                                    phi_2466_ = _e2661;
                                                                    break if !(_e2663);
                                                                }
                                                            }
                                                            let _e2666 = local_2.group_mask;
                                                            if ((_e2666 & 4278190080u) == 0u) {
                                                                let _e2670 = local_2.len;
                                                                if (_e2670 == 0u) {
                                                                    phi_3344_ = false;
                                                                } else {
                                                                    let _e2674 = local_2.len;
                                                                    local_2.len = (_e2674 - 1u);
                                                                    let _e2677 = local_2.len;
                                                                    if (_e2677 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2682 = local_2.first[(0u + _e2677)];
                                                                    local_2.group = _e2682;
                                                                    let _e2685 = local_2.len;
                                                                    if (_e2685 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2690 = local_2.mask[(0u + _e2685)];
                                                                    local_2.group_mask = _e2690;
                                                                    phi_3344_ = true;
                                                                }
                                                                let _e2693 = phi_3344_;
                                                                phi_3345_ = _e2693;
                                                            } else {
                                                                phi_3345_ = true;
                                                            }
                                                            let _e2695 = phi_3345_;
                                                            if _e2695 {
                                                                let _e2697 = local_2.group_mask;
                                                                let _e2703 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2697)), 32u, (_e2697 == 0u)));
                                                                let _e2707 = local_2.group_mask;
                                                                let _e2721 = local_2.group_mask;
                                                                local_2.group_mask = (_e2721 & ~((1u << bitcast<u32>((_e2703 & 31u)))));
                                                                let _e2724 = local_2.group;
                                                                phi_3376_ = (_e2724 + countOneBits(((_e2707 & ~((4294967295u << bitcast<u32>((((_e2703 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3376_ = 4294967295u;
                                                            }
                                                            let _e2727 = phi_3376_;
                                                            let _e3860 = local_10;
                                                            phi_2131_ = _e3860;
                                                            phi_2134_ = _e2727;
                                                        } else {
                                                            phi_2131_ = lt_bvh_Hit();
                                                            phi_2134_ = u32();
                                                        }
                                                        let _e2729 = phi_2131_;
                                                        let _e2731 = phi_2134_;
                                                        continue;
                                                        continuing {
                                                            phi_2130_ = _e2729;
                                                            phi_2133_ = _e2731;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3864 = local_11;
                                                    phi_3377_ = _e3864;
                                                }
                                                let _e2734 = phi_3377_;
                                                phi_3378_ = _e2734;
                                                phi_3379_ = _e1211;
                                            } else {
                                                phi_3378_ = lt_bvh_Hit();
                                                phi_3379_ = true;
                                            }
                                            let _e2736 = phi_3378_;
                                            let _e2738 = phi_3379_;
                                            if _e2738 {
                                                phi_3383_ = _e980;
                                            } else {
                                                phi_3383_ = _e2736;
                                            }
                                            let _e2740 = phi_3383_;
                                            phi_3384_ = _e2740;
                                        } else {
                                            phi_3384_ = _e980;
                                        }
                                        let _e2742 = phi_3384_;
                                        phi_3385_ = _e2742;
                                    } else {
                                        phi_3385_ = _e980;
                                    }
                                    let _e2744 = phi_3385_;
                                    phi_3386_ = _e2744;
                                } else {
                                    phi_3386_ = _e980;
                                }
                                let _e2746 = phi_3386_;
                                phi_1505_ = (_e978 & (_e978 - 1u));
                                phi_1508_ = _e2746;
                                phi_3387_ = true;
                            }
                            let _e2748 = phi_1505_;
                            let _e2750 = phi_1508_;
                            let _e2752 = phi_3387_;
                            continue;
                            continuing {
                                phi_1504_ = _e2748;
                                phi_1507_ = _e2750;
                                break if !(_e2752);
                            }
                        }
                        let _e2755 = local_3.group_mask;
                        if ((_e2755 & 4278190080u) == 0u) {
                            let _e2759 = local_3.len;
                            if (_e2759 == 0u) {
                                phi_3426_ = false;
                            } else {
                                let _e2763 = local_3.len;
                                local_3.len = (_e2763 - 1u);
                                let _e2766 = local_3.len;
                                if (_e2766 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2771 = local_3.first[(0u + _e2766)];
                                local_3.group = _e2771;
                                let _e2774 = local_3.len;
                                if (_e2774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2779 = local_3.mask[(0u + _e2774)];
                                local_3.group_mask = _e2779;
                                phi_3426_ = true;
                            }
                            let _e2782 = phi_3426_;
                            phi_3427_ = _e2782;
                        } else {
                            phi_3427_ = true;
                        }
                        let _e2784 = phi_3427_;
                        if _e2784 {
                            let _e2786 = local_3.group_mask;
                            let _e2792 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2786)), 32u, (_e2786 == 0u)));
                            let _e2796 = local_3.group_mask;
                            let _e2810 = local_3.group_mask;
                            local_3.group_mask = (_e2810 & ~((1u << bitcast<u32>((_e2792 & 31u)))));
                            let _e2813 = local_3.group;
                            phi_3458_ = (_e2813 + countOneBits(((_e2796 & ~((4294967295u << bitcast<u32>((((_e2792 - 24u) ^ _e397) & 31u))))) & 255u)));
                        } else {
                            phi_3458_ = 4294967295u;
                        }
                        let _e2816 = phi_3458_;
                        phi_1168_ = _e2816;
                        let _e3880 = local_12;
                        phi_1171_ = _e3880;
                    } else {
                        phi_1168_ = u32();
                        phi_1171_ = lt_bvh_Hit();
                    }
                    let _e2818 = phi_1168_;
                    let _e2820 = phi_1171_;
                    continue;
                    continuing {
                        phi_1167_ = _e2818;
                        phi_1170_ = _e2820;
                        break if !(_e538);
                    }
                }
                let _e3883 = local_13;
                phi_3459_ = _e3883;
            }
            let _e2823 = phi_3459_;
            phi_3460_ = _e2823;
            phi_3461_ = _e234;
        } else {
            phi_3460_ = lt_bvh_Hit();
            phi_3461_ = true;
        }
        let _e2825 = phi_3460_;
        let _e2827 = phi_3461_;
        if _e2827 {
            phi_3465_ = _e164;
        } else {
            phi_3465_ = _e2825;
        }
        let _e2829 = phi_3465_;
        if (_e2829.triangle != 4294967295u) {
            let _e2835 = ((1f - _e2829.u) - _e2829.v);
            if (_e2829.triangle < _e81) {
            } else {
                return;
            }
            let _e2840 = triangles.member[(0u + _e2829.triangle)];
            if (_e2829.instance < _e93) {
            } else {
                return;
            }
            let _e2851 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2862 = ((((_e2851.x * _e2840.v0_.x) + (_e2851.y * _e2840.v0_.y)) + (_e2851.z * _e2840.v0_.z)) + (_e2851.w * 1f));
            let _e2864 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2875 = ((((_e2864.x * _e2840.v0_.x) + (_e2864.y * _e2840.v0_.y)) + (_e2864.z * _e2840.v0_.z)) + (_e2864.w * 1f));
            let _e2877 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2888 = ((((_e2877.x * _e2840.v0_.x) + (_e2877.y * _e2840.v0_.y)) + (_e2877.z * _e2840.v0_.z)) + (_e2877.w * 1f));
            let _e2895 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2906 = ((((_e2895.x * _e2840.v1_.x) + (_e2895.y * _e2840.v1_.y)) + (_e2895.z * _e2840.v1_.z)) + (_e2895.w * 1f));
            let _e2908 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2919 = ((((_e2908.x * _e2840.v1_.x) + (_e2908.y * _e2840.v1_.y)) + (_e2908.z * _e2840.v1_.z)) + (_e2908.w * 1f));
            let _e2921 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2932 = ((((_e2921.x * _e2840.v1_.x) + (_e2921.y * _e2840.v1_.y)) + (_e2921.z * _e2840.v1_.z)) + (_e2921.w * 1f));
            let _e2939 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2950 = ((((_e2939.x * _e2840.v2_.x) + (_e2939.y * _e2840.v2_.y)) + (_e2939.z * _e2840.v2_.z)) + (_e2939.w * 1f));
            let _e2952 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2963 = ((((_e2952.x * _e2840.v2_.x) + (_e2952.y * _e2840.v2_.y)) + (_e2952.z * _e2840.v2_.z)) + (_e2952.w * 1f));
            let _e2965 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2976 = ((((_e2965.x * _e2840.v2_.x) + (_e2965.y * _e2840.v2_.y)) + (_e2965.z * _e2840.v2_.z)) + (_e2965.w * 1f));
            let _e2989 = (((_e2862 * _e2835) + (_e2906 * _e2829.u)) + (_e2950 * _e2829.v));
            let _e2990 = (((_e2875 * _e2835) + (_e2919 * _e2829.u)) + (_e2963 * _e2829.v));
            let _e2991 = (((_e2888 * _e2835) + (_e2932 * _e2829.u)) + (_e2976 * _e2829.v));
            let _e2993 = abs(_e2862);
            let _e2994 = abs(_e2875);
            let _e2995 = abs(_e2888);
            let _e2996 = abs(_e2906);
            let _e2997 = abs(_e2919);
            let _e2998 = abs(_e2932);
            if (_e2993 > _e2996) {
                phi_3652_ = _e2993;
            } else {
                phi_3652_ = _e2996;
            }
            let _e3001 = phi_3652_;
            if (_e2994 > _e2997) {
                phi_3657_ = _e2994;
            } else {
                phi_3657_ = _e2997;
            }
            let _e3004 = phi_3657_;
            if (_e2995 > _e2998) {
                phi_3662_ = _e2995;
            } else {
                phi_3662_ = _e2998;
            }
            let _e3007 = phi_3662_;
            let _e3008 = abs(_e2950);
            let _e3009 = abs(_e2963);
            let _e3010 = abs(_e2976);
            if (_e3001 > _e3008) {
                phi_3670_ = _e3001;
            } else {
                phi_3670_ = _e3008;
            }
            let _e3013 = phi_3670_;
            if (_e3004 > _e3009) {
                phi_3675_ = _e3004;
            } else {
                phi_3675_ = _e3009;
            }
            let _e3016 = phi_3675_;
            if (_e3007 > _e3010) {
                phi_3680_ = _e3007;
            } else {
                phi_3680_ = _e3010;
            }
            let _e3019 = phi_3680_;
            let _e3020 = (_e2906 - _e2862);
            let _e3021 = (_e2919 - _e2875);
            let _e3022 = (_e2932 - _e2888);
            let _e3023 = (_e2950 - _e2862);
            let _e3024 = (_e2963 - _e2875);
            let _e3025 = (_e2976 - _e2888);
            let _e3029 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3021), abs(_e3022));
            let _e3030 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3020), _e3029);
            let _e3031 = (_e3020 / _e3030);
            let _e3032 = (_e3021 / _e3030);
            let _e3033 = (_e3022 / _e3030);
            let _e3037 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3024), abs(_e3025));
            let _e3038 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3023), _e3037);
            let _e3039 = (_e3023 / _e3038);
            let _e3040 = (_e3024 / _e3038);
            let _e3041 = (_e3025 / _e3038);
            let _e3044 = ((_e3032 * _e3041) - (_e3040 * _e3033));
            let _e3047 = ((_e3033 * _e3039) - (_e3041 * _e3031));
            let _e3050 = ((_e3031 * _e3040) - (_e3039 * _e3032));
            let _e3052 = p.member.eye;
            let _e3065 = (1f / sqrt((((_e3044 * _e3044) + (_e3047 * _e3047)) + (_e3050 * _e3050))));
            let _e3066 = (_e3044 * _e3065);
            let _e3067 = (_e3047 * _e3065);
            let _e3068 = (_e3050 * _e3065);
            if ((((_e3066 * (_e3052.x - _e2989)) + (_e3067 * (_e3052.y - _e2990))) + (_e3068 * (_e3052.z - _e2991))) < 0f) {
                phi_3744_ = vec3<f32>(-(_e3066), -(_e3067), -(_e3068));
            } else {
                phi_3744_ = vec3<f32>(_e3066, _e3067, _e3068);
            }
            let _e3081 = phi_3744_;
            if (_e2829.triangle < _e81) {
            } else {
                return;
            }
            let _e3086 = triangles.member[(0u + _e2829.triangle)];
            let _e3088 = (_e3086.i0_ & 2147483647u);
            if (_e3088 < _e84) {
            } else {
                return;
            }
            let _e3094 = vertices.member[(0u + _e3088)];
            if (_e3086.i1_ < _e84) {
            } else {
                return;
            }
            let _e3098 = vertices.member[(0u + _e3086.i1_)];
            if (_e3086.i2_ < _e84) {
            } else {
                return;
            }
            let _e3102 = vertices.member[(0u + _e3086.i2_)];
            let _e3103 = array<abi_Vertex, 3>(_e3094, _e3098, _e3102);
            if (_e3103[0].material < _e87) {
            } else {
                return;
            }
            let _e3109 = materials.member[(0u + _e3103[0].material)];
            let _e3126 = (1f / 255f);
            let _e3145 = (1f / 255f);
            let _e3167 = (1f / 255f);
            if (_e3109.color_size == 0u) {
                phi_3987_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3109.color_offset;
                local.size = _e3109.color_size;
                local.flags = _e3109.flags;
                let _e3210 = _lt_shaders_texture_TextureView_quad((&local), (((_e3103[0].u * _e2835) + (_e3103[1].u * _e2829.u)) + (_e3103[2].u * _e2829.v)), (((_e3103[0].v * _e2835) + (_e3103[1].v * _e2829.u)) + (_e3103[2].v * _e2829.v)));
                if (_e3210.indices[0] < _e99) {
                } else {
                    return;
                }
                let _e3216 = color_texels.member[(0u + _e3210.indices[0])];
                let _e3227 = (1f / 255f);
                if (_e3210.indices[1] < _e99) {
                } else {
                    return;
                }
                let _e3241 = color_texels.member[(0u + _e3210.indices[1])];
                let _e3252 = (1f / 255f);
                if (_e3210.indices[2] < _e99) {
                } else {
                    return;
                }
                let _e3269 = color_texels.member[(0u + _e3210.indices[2])];
                let _e3280 = (1f / 255f);
                if (_e3210.indices[3] < _e99) {
                } else {
                    return;
                }
                let _e3297 = color_texels.member[(0u + _e3210.indices[3])];
                let _e3308 = (1f / 255f);
                let _e3317 = (((((f32((_e3216 & 255u)) * _e3227) * _e3210.weights.x) + ((f32((_e3241 & 255u)) * _e3252) * _e3210.weights.y)) + ((f32((_e3269 & 255u)) * _e3280) * _e3210.weights.z)) + ((f32((_e3297 & 255u)) * _e3308) * _e3210.weights.w));
                let _e3318 = (((((f32(((_e3216 >> bitcast<u32>(8i)) & 255u)) * _e3227) * _e3210.weights.x) + ((f32(((_e3241 >> bitcast<u32>(8i)) & 255u)) * _e3252) * _e3210.weights.y)) + ((f32(((_e3269 >> bitcast<u32>(8i)) & 255u)) * _e3280) * _e3210.weights.z)) + ((f32(((_e3297 >> bitcast<u32>(8i)) & 255u)) * _e3308) * _e3210.weights.w));
                let _e3319 = (((((f32(((_e3216 >> bitcast<u32>(16i)) & 255u)) * _e3227) * _e3210.weights.x) + ((f32(((_e3241 >> bitcast<u32>(16i)) & 255u)) * _e3252) * _e3210.weights.y)) + ((f32(((_e3269 >> bitcast<u32>(16i)) & 255u)) * _e3280) * _e3210.weights.z)) + ((f32(((_e3297 >> bitcast<u32>(16i)) & 255u)) * _e3308) * _e3210.weights.w));
                phi_3987_ = vec3<f32>((_e3317 * _e3317), (_e3318 * _e3318), (_e3319 * _e3319));
            }
            let _e3325 = phi_3987_;
            let _e3327 = ((_e3109.base_color.x * ((((f32((_e3103[0].color & 255u)) * _e3126) * _e2835) + ((f32((_e3103[1].color & 255u)) * _e3145) * _e2829.u)) + ((f32((_e3103[2].color & 255u)) * _e3167) * _e2829.v))) * _e3325.x);
            let _e3329 = ((_e3109.base_color.y * ((((f32(((_e3103[0].color >> bitcast<u32>(8i)) & 255u)) * _e3126) * _e2835) + ((f32(((_e3103[1].color >> bitcast<u32>(8i)) & 255u)) * _e3145) * _e2829.u)) + ((f32(((_e3103[2].color >> bitcast<u32>(8i)) & 255u)) * _e3167) * _e2829.v))) * _e3325.y);
            let _e3331 = ((_e3109.base_color.z * ((((f32(((_e3103[0].color >> bitcast<u32>(16i)) & 255u)) * _e3126) * _e2835) + ((f32(((_e3103[1].color >> bitcast<u32>(16i)) & 255u)) * _e3145) * _e2829.u)) + ((f32(((_e3103[2].color >> bitcast<u32>(16i)) & 255u)) * _e3167) * _e2829.v))) * _e3325.z);
            let _e3332 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3016, _e3019);
            let _e3333 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3013, _e3332);
            if ((_e3109.flags & 2u) == 0u) {
                phi_4002_ = 0u;
            } else {
                phi_4002_ = 1u;
            }
            let _e3338 = phi_4002_;
            if (_e3103[0].normal == 2147516416u) {
                phi_4232_ = _e3081;
            } else {
                let _e3351 = (f32((bitcast<i32>((_e3103[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3357 = (f32((bitcast<i32>(_e3103[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3361 = ((1f - abs(_e3351)) - abs(_e3357));
                if (_e3361 < 0f) {
                    phi_4029_ = -(_e3361);
                } else {
                    phi_4029_ = 0f;
                }
                let _e3365 = phi_4029_;
                if (_e3351 < 0f) {
                    phi_4036_ = (_e3351 + _e3365);
                } else {
                    phi_4036_ = (_e3351 - _e3365);
                }
                let _e3370 = phi_4036_;
                if (_e3357 < 0f) {
                    phi_4043_ = (_e3357 + _e3365);
                } else {
                    phi_4043_ = (_e3357 - _e3365);
                }
                let _e3375 = phi_4043_;
                let _e3382 = (1f / sqrt((((_e3370 * _e3370) + (_e3375 * _e3375)) + (_e3361 * _e3361))));
                let _e3398 = (f32((bitcast<i32>((_e3103[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3404 = (f32((bitcast<i32>(_e3103[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3408 = ((1f - abs(_e3398)) - abs(_e3404));
                if (_e3408 < 0f) {
                    phi_4078_ = -(_e3408);
                } else {
                    phi_4078_ = 0f;
                }
                let _e3412 = phi_4078_;
                if (_e3398 < 0f) {
                    phi_4085_ = (_e3398 + _e3412);
                } else {
                    phi_4085_ = (_e3398 - _e3412);
                }
                let _e3417 = phi_4085_;
                if (_e3404 < 0f) {
                    phi_4092_ = (_e3404 + _e3412);
                } else {
                    phi_4092_ = (_e3404 - _e3412);
                }
                let _e3422 = phi_4092_;
                let _e3429 = (1f / sqrt((((_e3417 * _e3417) + (_e3422 * _e3422)) + (_e3408 * _e3408))));
                let _e3448 = (f32((bitcast<i32>((_e3103[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3454 = (f32((bitcast<i32>(_e3103[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3458 = ((1f - abs(_e3448)) - abs(_e3454));
                if (_e3458 < 0f) {
                    phi_4130_ = -(_e3458);
                } else {
                    phi_4130_ = 0f;
                }
                let _e3462 = phi_4130_;
                if (_e3448 < 0f) {
                    phi_4137_ = (_e3448 + _e3462);
                } else {
                    phi_4137_ = (_e3448 - _e3462);
                }
                let _e3467 = phi_4137_;
                if (_e3454 < 0f) {
                    phi_4144_ = (_e3454 + _e3462);
                } else {
                    phi_4144_ = (_e3454 - _e3462);
                }
                let _e3472 = phi_4144_;
                let _e3479 = (1f / sqrt((((_e3467 * _e3467) + (_e3472 * _e3472)) + (_e3458 * _e3458))));
                let _e3486 = ((((_e3370 * _e3382) * _e2835) + ((_e3417 * _e3429) * _e2829.u)) + ((_e3467 * _e3479) * _e2829.v));
                let _e3487 = ((((_e3375 * _e3382) * _e2835) + ((_e3422 * _e3429) * _e2829.u)) + ((_e3472 * _e3479) * _e2829.v));
                let _e3488 = ((((_e3361 * _e3382) * _e2835) + ((_e3408 * _e3429) * _e2829.u)) + ((_e3458 * _e3479) * _e2829.v));
                if (_e2829.instance < _e93) {
                } else {
                    return;
                }
                let _e3495 = instances.member[(0u + _e2829.instance)].world_to_object[0u];
                let _e3504 = instances.member[(0u + _e2829.instance)].world_to_object[1u];
                let _e3516 = instances.member[(0u + _e2829.instance)].world_to_object[2u];
                let _e3523 = (((_e3495.x * _e3486) + (_e3504.x * _e3487)) + (_e3516.x * _e3488));
                let _e3524 = (((_e3495.y * _e3486) + (_e3504.y * _e3487)) + (_e3516.y * _e3488));
                let _e3525 = (((_e3495.z * _e3486) + (_e3504.z * _e3487)) + (_e3516.z * _e3488));
                let _e3531 = sqrt((((_e3523 * _e3523) + (_e3524 * _e3524)) + (_e3525 * _e3525)));
                if (_e3531 > 0f) {
                    let _e3533 = (_e3523 / _e3531);
                    let _e3534 = (_e3524 / _e3531);
                    let _e3535 = (_e3525 / _e3531);
                    if ((((_e3533 * _e3081.x) + (_e3534 * _e3081.y)) + (_e3535 * _e3081.z)) < 0f) {
                        phi_4230_ = vec3<f32>(-(_e3533), -(_e3534), -(_e3535));
                    } else {
                        phi_4230_ = vec3<f32>(_e3533, _e3534, _e3535);
                    }
                    let _e3551 = phi_4230_;
                    phi_4231_ = _e3551;
                } else {
                    phi_4231_ = _e3081;
                }
                let _e3553 = phi_4231_;
                phi_4232_ = _e3553;
            }
            let _e3555 = phi_4232_;
            if (_e3327 > 0f) {
                if (_e3327 < 1f) {
                    phi_4241_ = _e3327;
                } else {
                    phi_4241_ = 1f;
                }
                let _e3559 = phi_4241_;
                phi_4242_ = _e3559;
            } else {
                phi_4242_ = 0f;
            }
            let _e3561 = phi_4242_;
            if (_e3329 > 0f) {
                if (_e3329 < 1f) {
                    phi_4252_ = _e3329;
                } else {
                    phi_4252_ = 1f;
                }
                let _e3566 = phi_4252_;
                phi_4253_ = _e3566;
            } else {
                phi_4253_ = 0f;
            }
            let _e3568 = phi_4253_;
            if (_e3331 > 0f) {
                if (_e3331 < 1f) {
                    phi_4263_ = _e3331;
                } else {
                    phi_4263_ = 1f;
                }
                let _e3573 = phi_4263_;
                phi_4264_ = _e3573;
            } else {
                phi_4264_ = 0f;
            }
            let _e3575 = phi_4264_;
            let _e3578 = ((sqrt(_e3561) * 255f) + 0.5f);
            let _e3587 = ((sqrt(_e3568) * 255f) + 0.5f);
            let _e3599 = ((sqrt(_e3575) * 255f) + 0.5f);
            phi_4299_ = abi_Sample(vec3<f32>(_e2989, _e2990, _e2991), _e3333, _e3081, _e3338, _e3555, ((select(select(u32(_e3578), 0u, (_e3578 < bitcast<f32>(0u))), 4294967295u, (_e3578 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3587), 0u, (_e3587 < bitcast<f32>(0u))), 4294967295u, (_e3587 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3599), 0u, (_e3599 < bitcast<f32>(0u))), 4294967295u, (_e3599 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4299_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3613 = phi_4299_;
        if (_e105.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e105.shift)] = _e3613;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
