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
                let _e310 = phi_915_;
                if (_e162.direction.x < 0f) {
                    phi_922_ = (-1f / _e310);
                } else {
                    phi_922_ = (1f / _e310);
                }
                let _e315 = phi_922_;
                if (abs(_e162.direction.y) < _e304) {
                    phi_930_ = _e304;
                } else {
                    phi_930_ = abs(_e162.direction.y);
                }
                let _e321 = phi_930_;
                if (_e162.direction.y < 0f) {
                    phi_937_ = (-1f / _e321);
                } else {
                    phi_937_ = (1f / _e321);
                }
                let _e326 = phi_937_;
                if (abs(_e162.direction.z) < _e304) {
                    phi_945_ = _e304;
                } else {
                    phi_945_ = abs(_e162.direction.z);
                }
                let _e332 = phi_945_;
                if (_e162.direction.z < 0f) {
                    phi_952_ = (-1f / _e332);
                } else {
                    phi_952_ = (1f / _e332);
                }
                let _e337 = phi_952_;
                let _e345 = abs((bitcast<f32>(_e240) - _e162.origin.x));
                let _e346 = abs((bitcast<f32>(_e244) - _e162.origin.y));
                let _e347 = abs((bitcast<f32>(_e248) - _e162.origin.z));
                let _e355 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e264 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.x));
                let _e356 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e264 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.y));
                let _e357 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e264 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.z));
                if (_e345 > _e355) {
                    phi_977_ = _e345;
                } else {
                    phi_977_ = _e355;
                }
                let _e360 = phi_977_;
                if (_e346 > _e356) {
                    phi_982_ = _e346;
                } else {
                    phi_982_ = _e356;
                }
                let _e363 = phi_982_;
                if (_e347 > _e357) {
                    phi_987_ = _e347;
                } else {
                    phi_987_ = _e357;
                }
                let _e366 = phi_987_;
                let _e367 = core_intrinsics_maximum_number_nsz_f32_(_e360, _e363);
                let _e368 = core_intrinsics_maximum_number_nsz_f32_(_e367, _e366);
                let _e373 = (_e368 * 0.0000019073486f);
                let _e374 = (abs(_e315) * _e373);
                let _e375 = (abs(_e326) * _e373);
                let _e376 = (abs(_e337) * _e373);
                let _e380 = (_e368 * 0.0000009536743f);
                let _e381 = (abs(_e315) * _e380);
                let _e382 = (abs(_e326) * _e380);
                let _e383 = (abs(_e337) * _e380);
                if (_e315 < 0f) {
                    phi_1009_ = 0u;
                } else {
                    phi_1009_ = 1u;
                }
                let _e386 = phi_1009_;
                if (_e326 < 0f) {
                    phi_1014_ = 0u;
                } else {
                    phi_1014_ = 2u;
                }
                let _e389 = phi_1014_;
                if (_e337 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 4u;
                }
                let _e392 = phi_1019_;
                let _e394 = ((_e386 | _e389) | _e392);
                let _e395 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e111, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e395.first[0], _e395.first[1], _e395.first[2], _e395.first[3], _e395.first[4], _e395.first[5], _e395.first[6], _e395.first[7], _e395.first[8], _e395.first[9], _e395.first[10], _e395.first[11], _e395.first[12], _e395.first[13], _e395.first[14], _e395.first[15], _e395.first[16], _e395.first[17], _e395.first[18], _e395.first[19], _e395.first[20], _e395.first[21], _e395.first[22], _e395.first[23], _e395.first[24], _e395.first[25], _e395.first[26], _e395.first[27], _e395.first[28], _e395.first[29], _e395.first[30], _e395.first[31]), array<u32, 32>(_e395.mask[0], _e395.mask[1], _e395.mask[2], _e395.mask[3], _e395.mask[4], _e395.mask[5], _e395.mask[6], _e395.mask[7], _e395.mask[8], _e395.mask[9], _e395.mask[10], _e395.mask[11], _e395.mask[12], _e395.mask[13], _e395.mask[14], _e395.mask[15], _e395.mask[16], _e395.mask[17], _e395.mask[18], _e395.mask[19], _e395.mask[20], _e395.mask[21], _e395.mask[22], _e395.mask[23], _e395.mask[24], _e395.mask[25], _e395.mask[26], _e395.mask[27], _e395.mask[28], _e395.mask[29], _e395.mask[30], _e395.mask[31]), _e395.len, _e395.group, _e395.group_mask);
                let _e469 = local_3.group_mask;
                if ((_e469 & 4278190080u) == 0u) {
                    let _e473 = local_3.len;
                    if (_e473 == 0u) {
                        phi_1133_ = false;
                    } else {
                        let _e477 = local_3.len;
                        local_3.len = (_e477 - 1u);
                        let _e480 = local_3.len;
                        if (_e480 < 32u) {
                        } else {
                            return;
                        }
                        let _e485 = local_3.first[(0u + _e480)];
                        local_3.group = _e485;
                        let _e488 = local_3.len;
                        if (_e488 < 32u) {
                        } else {
                            return;
                        }
                        let _e493 = local_3.mask[(0u + _e488)];
                        local_3.group_mask = _e493;
                        phi_1133_ = true;
                    }
                    let _e496 = phi_1133_;
                    phi_1134_ = _e496;
                } else {
                    phi_1134_ = true;
                }
                let _e498 = phi_1134_;
                if _e498 {
                    let _e500 = local_3.group_mask;
                    let _e506 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e500)), 32u, (_e500 == 0u)));
                    let _e510 = local_3.group_mask;
                    let _e524 = local_3.group_mask;
                    local_3.group_mask = (_e524 & ~((1u << bitcast<u32>((_e506 & 31u)))));
                    let _e527 = local_3.group;
                    phi_1165_ = (_e527 + countOneBits(((_e510 & ~((4294967295u << bitcast<u32>((((_e506 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1165_ = 4294967295u;
                }
                let _e530 = phi_1165_;
                phi_1167_ = _e530;
                phi_1170_ = _e164;
                loop {
                    let _e532 = phi_1167_;
                    let _e534 = phi_1170_;
                    local_13 = _e534;
                    let _e535 = (_e532 != 4294967295u);
                    if _e535 {
                        if (_e532 < _e78) {
                        } else {
                            return;
                        }
                        let _e543 = nodes.member[(0u + _e532)].frame[3u];
                        let _e568 = (bitcast<f32>((((_e543 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e315);
                        let _e569 = (bitcast<f32>((((_e543 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e570 = (bitcast<f32>((((_e543 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e573 = nodes.member[(0u + _e532)].frame[0u];
                        let _e577 = nodes.member[(0u + _e532)].frame[1u];
                        let _e581 = nodes.member[(0u + _e532)].frame[2u];
                        let _e589 = ((bitcast<f32>(_e573) - _e162.origin.x) * _e315);
                        let _e590 = ((bitcast<f32>(_e577) - _e162.origin.y) * _e326);
                        let _e591 = ((bitcast<f32>(_e581) - _e162.origin.z) * _e337);
                        let _e599 = nodes.member[(0u + _e532)].x;
                        if (_e315 < 0f) {
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e599.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e610.unnamed.word, _e599.w), _e610.unnamed_1);
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e616.unnamed, lt_mask_LightPlace(_e599.x, _e616.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e622.unnamed, lt_mask_LightPlace(_e622.unnamed_1.word, _e599.y));
                        } else {
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e599.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e638.unnamed.word, _e599.y), _e638.unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_mask_LightPlace(_e599.z, _e644.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_mask_LightPlace(_e650.unnamed_1.word, _e599.w));
                        }
                        let _e658 = phi_1255_;
                        let _e668 = nodes.member[(0u + _e532)].y;
                        if (_e326 < 0f) {
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e679.unnamed.word, _e668.w), _e679.unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_mask_LightPlace(_e668.x, _e685.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_mask_LightPlace(_e691.unnamed_1.word, _e668.y));
                        } else {
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e707.unnamed.word, _e668.y), _e707.unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_mask_LightPlace(_e668.z, _e713.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_mask_LightPlace(_e719.unnamed_1.word, _e668.w));
                        }
                        let _e727 = phi_1282_;
                        let _e737 = nodes.member[(0u + _e532)].z;
                        if (_e337 < 0f) {
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e748.unnamed.word, _e737.w), _e748.unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_mask_LightPlace(_e737.x, _e754.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_mask_LightPlace(_e760.unnamed_1.word, _e737.y));
                        } else {
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e776.unnamed.word, _e737.y), _e776.unnamed_1);
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_mask_LightPlace(_e737.z, _e782.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e788.unnamed, lt_mask_LightPlace(_e788.unnamed_1.word, _e737.w));
                        }
                        let _e796 = phi_1309_;
                        phi_1315_ = 0u;
                        phi_1318_ = 0u;
                        loop {
                            let _e806 = phi_1315_;
                            let _e808 = phi_1318_;
                            local_4 = _e808;
                            local_5 = _e808;
                            local_6 = _e808;
                            let _e809 = (_e806 < 8u);
                            if _e809 {
                                let _e811 = (_e806 >> bitcast<u32>(2i));
                                let _e812 = (_e806 & 3u);
                                if (_e811 == 0u) {
                                    phi_1332_ = _e658.unnamed.word;
                                } else {
                                    phi_1332_ = _e658.unnamed.shift;
                                }
                                let _e815 = phi_1332_;
                                if (_e811 == 0u) {
                                    phi_1342_ = _e727.unnamed.word;
                                } else {
                                    phi_1342_ = _e727.unnamed.shift;
                                }
                                let _e824 = phi_1342_;
                                if (_e811 == 0u) {
                                    phi_1352_ = _e796.unnamed.word;
                                } else {
                                    phi_1352_ = _e796.unnamed.shift;
                                }
                                let _e833 = phi_1352_;
                                let _e846 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e815 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e568) + (_e589 - _e374)), ((f32(((_e824 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e569) + (_e590 - _e375)));
                                let _e847 = core_intrinsics_maximum_number_nsz_f32_(_e846, ((f32(((_e833 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e570) + (_e591 - _e376)));
                                if (_e811 == 0u) {
                                    phi_1370_ = _e658.unnamed_1.word;
                                } else {
                                    phi_1370_ = _e658.unnamed_1.shift;
                                }
                                let _e850 = phi_1370_;
                                if (_e811 == 0u) {
                                    phi_1380_ = _e727.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e727.unnamed_1.shift;
                                }
                                let _e859 = phi_1380_;
                                if (_e811 == 0u) {
                                    phi_1390_ = _e796.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e796.unnamed_1.shift;
                                }
                                let _e868 = phi_1390_;
                                let _e881 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e850 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e568) + (_e589 + _e374)), ((f32(((_e859 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e569) + (_e590 + _e375)));
                                let _e882 = core_intrinsics_minimum_number_nsz_f32_(_e881, ((f32(((_e868 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u)) * _e570) + (_e591 + _e376)));
                                if (_e847 <= _e882) {
                                    if (_e847 <= _e534.t) {
                                        if (_e882 >= _e162.tmin) {
                                            if (_e811 == 0u) {
                                                let _e889 = nodes.member[(0u + _e532)].links[2u];
                                                phi_1426_ = _e889;
                                            } else {
                                                let _e892 = nodes.member[(0u + _e532)].links[3u];
                                                phi_1426_ = _e892;
                                            }
                                            let _e894 = phi_1426_;
                                            let _e899 = ((_e894 >> bitcast<u32>(((_e812 * 8u) & 31u))) & 255u);
                                            let _e900 = (_e899 & 31u);
                                            if (_e900 >= 24u) {
                                                phi_1439_ = (24u + ((_e900 - 24u) ^ _e394));
                                            } else {
                                                phi_1439_ = _e900;
                                            }
                                            let _e906 = phi_1439_;
                                            phi_1444_ = (_e808 | ((_e899 >> bitcast<u32>(5i)) << bitcast<u32>((_e906 & 31u))));
                                        } else {
                                            phi_1444_ = _e808;
                                        }
                                        let _e914 = phi_1444_;
                                        phi_1445_ = _e914;
                                    } else {
                                        phi_1445_ = _e808;
                                    }
                                    let _e916 = phi_1445_;
                                    phi_1446_ = _e916;
                                } else {
                                    phi_1446_ = _e808;
                                }
                                let _e918 = phi_1446_;
                                phi_1316_ = (_e806 + 1u);
                                phi_1319_ = _e918;
                            } else {
                                phi_1316_ = u32();
                                phi_1319_ = u32();
                            }
                            let _e921 = phi_1316_;
                            let _e923 = phi_1319_;
                            continue;
                            continuing {
                                phi_1315_ = _e921;
                                phi_1318_ = _e923;
                                break if !(_e809);
                            }
                        }
                        let _e927 = nodes.member[(0u + _e532)].links[0u];
                        let _e931 = nodes.member[(0u + _e532)].frame[3u];
                        let _e935 = local_4;
                        if ((_e935 & 4278190080u) == 0u) {
                        } else {
                            let _e939 = local_3.group_mask;
                            if ((_e939 & 4278190080u) == 0u) {
                            } else {
                                let _e943 = local_3.len;
                                if (_e943 < 32u) {
                                    let _e946 = local_3.group;
                                    let _e948 = local_3.len;
                                    if (_e948 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e948)] = _e946;
                                    let _e954 = local_3.group_mask;
                                    let _e956 = local_3.len;
                                    if (_e956 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e956)] = _e954;
                                    let _e963 = local_3.len;
                                    local_3.len = (_e963 + 1u);
                                }
                            }
                            local_3.group = (_e111 + _e927);
                            let _e967 = local_5;
                            local_3.group_mask = ((_e967 & 4278190080u) | (_e931 >> bitcast<u32>(24i)));
                        }
                        let _e972 = local_6;
                        phi_1504_ = (_e972 & 16777215u);
                        phi_1507_ = _e534;
                        loop {
                            let _e975 = phi_1504_;
                            let _e977 = phi_1507_;
                            local_12 = _e977;
                            if (_e975 == 0u) {
                                phi_1505_ = u32();
                                phi_1508_ = lt_bvh_Hit();
                                phi_3387_ = false;
                            } else {
                                let _e981 = nodes.member[(0u + _e532)].links[1u];
                                let _e985 = (_e981 + select(firstTrailingBit(_e975), 32u, (_e975 == 0u)));
                                if (_e985 < _e93) {
                                } else {
                                    return;
                                }
                                let _e992 = instances.member[(0u + _e985)].low_world;
                                let _e994 = instances.member[(0u + _e985)].high_world;
                                let _e1004 = ((_e992.x - _e162.origin.x) * _e315);
                                let _e1005 = ((_e992.y - _e162.origin.y) * _e326);
                                let _e1006 = ((_e992.z - _e162.origin.z) * _e337);
                                let _e1016 = ((_e994.x - _e162.origin.x) * _e315);
                                let _e1017 = ((_e994.y - _e162.origin.y) * _e326);
                                let _e1018 = ((_e994.z - _e162.origin.z) * _e337);
                                if (_e1004 < _e1016) {
                                    phi_1562_ = _e1004;
                                } else {
                                    phi_1562_ = _e1016;
                                }
                                let _e1021 = phi_1562_;
                                if (_e1005 < _e1017) {
                                    phi_1567_ = _e1005;
                                } else {
                                    phi_1567_ = _e1017;
                                }
                                let _e1024 = phi_1567_;
                                if (_e1006 < _e1018) {
                                    phi_1572_ = _e1006;
                                } else {
                                    phi_1572_ = _e1018;
                                }
                                let _e1027 = phi_1572_;
                                if (_e1004 > _e1016) {
                                    phi_1580_ = _e1004;
                                } else {
                                    phi_1580_ = _e1016;
                                }
                                let _e1033 = phi_1580_;
                                if (_e1005 > _e1017) {
                                    phi_1585_ = _e1005;
                                } else {
                                    phi_1585_ = _e1017;
                                }
                                let _e1036 = phi_1585_;
                                if (_e1006 > _e1018) {
                                    phi_1590_ = _e1006;
                                } else {
                                    phi_1590_ = _e1018;
                                }
                                let _e1039 = phi_1590_;
                                let _e1043 = core_intrinsics_maximum_number_nsz_f32_((_e1021 - _e381), (_e1024 - _e382));
                                let _e1044 = core_intrinsics_maximum_number_nsz_f32_(_e1043, (_e1027 - _e383));
                                let _e1045 = core_intrinsics_minimum_number_nsz_f32_((_e1033 + _e381), (_e1036 + _e382));
                                let _e1046 = core_intrinsics_minimum_number_nsz_f32_(_e1045, (_e1039 + _e383));
                                if (_e1044 <= _e1046) {
                                    if (_e1044 <= _e977.t) {
                                        if (_e1046 >= _e162.tmin) {
                                            let _e1058 = instances.member[(0u + _e985)].world_to_object[0u];
                                            let _e1069 = ((((_e1058.x * _e162.origin.x) + (_e1058.y * _e162.origin.y)) + (_e1058.z * _e162.origin.z)) + (_e1058.w * 1f));
                                            let _e1071 = instances.member[(0u + _e985)].world_to_object[1u];
                                            let _e1082 = ((((_e1071.x * _e162.origin.x) + (_e1071.y * _e162.origin.y)) + (_e1071.z * _e162.origin.z)) + (_e1071.w * 1f));
                                            let _e1084 = instances.member[(0u + _e985)].world_to_object[2u];
                                            let _e1095 = ((((_e1084.x * _e162.origin.x) + (_e1084.y * _e162.origin.y)) + (_e1084.z * _e162.origin.z)) + (_e1084.w * 1f));
                                            let _e1102 = instances.member[(0u + _e985)].world_to_object[0u];
                                            let _e1113 = ((((_e1102.x * _e162.direction.x) + (_e1102.y * _e162.direction.y)) + (_e1102.z * _e162.direction.z)) + (_e1102.w * 0f));
                                            let _e1115 = instances.member[(0u + _e985)].world_to_object[1u];
                                            let _e1126 = ((((_e1115.x * _e162.direction.x) + (_e1115.y * _e162.direction.y)) + (_e1115.z * _e162.direction.z)) + (_e1115.w * 0f));
                                            let _e1128 = instances.member[(0u + _e985)].world_to_object[2u];
                                            let _e1139 = ((((_e1128.x * _e162.direction.x) + (_e1128.y * _e162.direction.y)) + (_e1128.z * _e162.direction.z)) + (_e1128.w * 0f));
                                            let _e1144 = instances.member[(0u + _e985)].root;
                                            let _e1146 = instances.member[(0u + _e985)].first_triangle;
                                            let _e1150 = abs(_e1113);
                                            let _e1151 = abs(_e1126);
                                            let _e1152 = abs(_e1139);
                                            if (abs(_e1069) < 1000000000000000f) {
                                                if (abs(_e1082) < 1000000000000000f) {
                                                    if (abs(_e1095) < 1000000000000000f) {
                                                        if (_e1150 < 1000000000000000f) {
                                                            if (_e1151 < 1000000000000000f) {
                                                                if (_e1152 < 1000000000000000f) {
                                                                    if (_e1150 > 0f) {
                                                                        phi_1747_ = bool();
                                                                        phi_1748_ = true;
                                                                    } else {
                                                                        let _e1160 = (_e1151 > 0f);
                                                                        if _e1160 {
                                                                            phi_1746_ = bool();
                                                                        } else {
                                                                            phi_1746_ = (_e1152 > 0f);
                                                                        }
                                                                        let _e1163 = phi_1746_;
                                                                        phi_1747_ = _e1163;
                                                                        phi_1748_ = _e1160;
                                                                    }
                                                                    let _e1165 = phi_1747_;
                                                                    let _e1167 = phi_1748_;
                                                                    if _e1167 {
                                                                        phi_1752_ = true;
                                                                    } else {
                                                                        phi_1752_ = _e1165;
                                                                    }
                                                                    let _e1169 = phi_1752_;
                                                                    phi_1753_ = _e1169;
                                                                    phi_1754_ = false;
                                                                } else {
                                                                    phi_1753_ = bool();
                                                                    phi_1754_ = true;
                                                                }
                                                                let _e1171 = phi_1753_;
                                                                let _e1173 = phi_1754_;
                                                                phi_1755_ = _e1171;
                                                                phi_1756_ = false;
                                                                phi_1757_ = _e1173;
                                                            } else {
                                                                phi_1755_ = bool();
                                                                phi_1756_ = true;
                                                                phi_1757_ = false;
                                                            }
                                                            let _e1175 = phi_1755_;
                                                            let _e1177 = phi_1756_;
                                                            let _e1179 = phi_1757_;
                                                            phi_1758_ = _e1175;
                                                            phi_1759_ = _e1177;
                                                            phi_1760_ = _e1179;
                                                        } else {
                                                            phi_1758_ = bool();
                                                            phi_1759_ = true;
                                                            phi_1760_ = false;
                                                        }
                                                        let _e1181 = phi_1758_;
                                                        let _e1183 = phi_1759_;
                                                        let _e1185 = phi_1760_;
                                                        phi_1761_ = _e1181;
                                                        phi_1762_ = _e1183;
                                                        phi_1763_ = _e1185;
                                                    } else {
                                                        phi_1761_ = bool();
                                                        phi_1762_ = true;
                                                        phi_1763_ = false;
                                                    }
                                                    let _e1187 = phi_1761_;
                                                    let _e1189 = phi_1762_;
                                                    let _e1191 = phi_1763_;
                                                    phi_1764_ = _e1187;
                                                    phi_1765_ = _e1189;
                                                    phi_1766_ = _e1191;
                                                } else {
                                                    phi_1764_ = bool();
                                                    phi_1765_ = true;
                                                    phi_1766_ = false;
                                                }
                                                let _e1193 = phi_1764_;
                                                let _e1195 = phi_1765_;
                                                let _e1197 = phi_1766_;
                                                phi_1767_ = _e1193;
                                                phi_1768_ = _e1195;
                                                phi_1769_ = _e1197;
                                            } else {
                                                phi_1767_ = bool();
                                                phi_1768_ = true;
                                                phi_1769_ = false;
                                            }
                                            let _e1199 = phi_1767_;
                                            let _e1201 = phi_1768_;
                                            let _e1203 = phi_1769_;
                                            if _e1201 {
                                                phi_1773_ = true;
                                            } else {
                                                phi_1773_ = _e1203;
                                            }
                                            let _e1205 = phi_1773_;
                                            if _e1205 {
                                                phi_1777_ = false;
                                            } else {
                                                phi_1777_ = _e1199;
                                            }
                                            let _e1207 = phi_1777_;
                                            if _e1207 {
                                                let _e1208 = (_e1144 >= _e78);
                                                if _e1208 {
                                                    phi_3377_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1144 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1214 = nodes.member[(0u + _e1144)].frame[0u];
                                                    let _e1218 = nodes.member[(0u + _e1144)].frame[1u];
                                                    let _e1222 = nodes.member[(0u + _e1144)].frame[2u];
                                                    let _e1226 = nodes.member[(0u + _e1144)].frame[0u];
                                                    let _e1230 = nodes.member[(0u + _e1144)].frame[1u];
                                                    let _e1234 = nodes.member[(0u + _e1144)].frame[2u];
                                                    let _e1238 = nodes.member[(0u + _e1144)].frame[3u];
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1113), abs(_e1126));
                                                    let _e1273 = core_intrinsics_maximum_number_nsz_f32_(_e1272, abs(_e1139));
                                                    let _e1274 = (_e1273 * 0.0000000000009094947f);
                                                    if (abs(_e1113) < _e1274) {
                                                        phi_1847_ = _e1274;
                                                    } else {
                                                        phi_1847_ = abs(_e1113);
                                                    }
                                                    let _e1279 = phi_1847_;
                                                    if (_e1113 < 0f) {
                                                        phi_1854_ = (-1f / _e1279);
                                                    } else {
                                                        phi_1854_ = (1f / _e1279);
                                                    }
                                                    let _e1284 = phi_1854_;
                                                    if (abs(_e1126) < _e1274) {
                                                        phi_1861_ = _e1274;
                                                    } else {
                                                        phi_1861_ = abs(_e1126);
                                                    }
                                                    let _e1289 = phi_1861_;
                                                    if (_e1126 < 0f) {
                                                        phi_1868_ = (-1f / _e1289);
                                                    } else {
                                                        phi_1868_ = (1f / _e1289);
                                                    }
                                                    let _e1294 = phi_1868_;
                                                    if (abs(_e1139) < _e1274) {
                                                        phi_1875_ = _e1274;
                                                    } else {
                                                        phi_1875_ = abs(_e1139);
                                                    }
                                                    let _e1299 = phi_1875_;
                                                    if (_e1139 < 0f) {
                                                        phi_1882_ = (-1f / _e1299);
                                                    } else {
                                                        phi_1882_ = (1f / _e1299);
                                                    }
                                                    let _e1304 = phi_1882_;
                                                    let _e1308 = abs((bitcast<f32>(_e1214) - _e1069));
                                                    let _e1309 = abs((bitcast<f32>(_e1218) - _e1082));
                                                    let _e1310 = abs((bitcast<f32>(_e1222) - _e1095));
                                                    let _e1314 = abs(((bitcast<f32>(_e1226) + (bitcast<f32>((((_e1238 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1069));
                                                    let _e1315 = abs(((bitcast<f32>(_e1230) + (bitcast<f32>((((_e1238 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1082));
                                                    let _e1316 = abs(((bitcast<f32>(_e1234) + (bitcast<f32>((((_e1238 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1095));
                                                    if (_e1308 > _e1314) {
                                                        phi_1899_ = _e1308;
                                                    } else {
                                                        phi_1899_ = _e1314;
                                                    }
                                                    let _e1319 = phi_1899_;
                                                    if (_e1309 > _e1315) {
                                                        phi_1904_ = _e1309;
                                                    } else {
                                                        phi_1904_ = _e1315;
                                                    }
                                                    let _e1322 = phi_1904_;
                                                    if (_e1310 > _e1316) {
                                                        phi_1909_ = _e1310;
                                                    } else {
                                                        phi_1909_ = _e1316;
                                                    }
                                                    let _e1325 = phi_1909_;
                                                    let _e1326 = core_intrinsics_maximum_number_nsz_f32_(_e1319, _e1322);
                                                    let _e1327 = core_intrinsics_maximum_number_nsz_f32_(_e1326, _e1325);
                                                    let _e1331 = (_e1327 * 0.0000019073486f);
                                                    let _e1332 = (abs(_e1284) * _e1331);
                                                    let _e1333 = (abs(_e1294) * _e1331);
                                                    let _e1334 = (abs(_e1304) * _e1331);
                                                    let _e1338 = (_e1327 * 0.0000009536743f);
                                                    let _e1339 = (abs(_e1284) * _e1338);
                                                    let _e1340 = (abs(_e1294) * _e1338);
                                                    let _e1341 = (abs(_e1304) * _e1338);
                                                    let _e1342 = abs(_e1113);
                                                    let _e1343 = abs(_e1126);
                                                    let _e1344 = abs(_e1139);
                                                    if (_e1342 >= _e1343) {
                                                        if (_e1342 >= _e1344) {
                                                            phi_1937_ = false;
                                                        } else {
                                                            phi_1937_ = true;
                                                        }
                                                        let _e1348 = phi_1937_;
                                                        phi_1938_ = _e1348;
                                                    } else {
                                                        phi_1938_ = true;
                                                    }
                                                    let _e1350 = phi_1938_;
                                                    if _e1350 {
                                                        if (_e1343 >= _e1344) {
                                                            phi_1946_ = 1u;
                                                        } else {
                                                            phi_1946_ = 2u;
                                                        }
                                                        let _e1353 = phi_1946_;
                                                        phi_1947_ = _e1353;
                                                    } else {
                                                        phi_1947_ = 0u;
                                                    }
                                                    let _e1355 = phi_1947_;
                                                    if (_e1355 == 0u) {
                                                        phi_1959_ = vec3<f32>(_e1126, _e1139, _e1113);
                                                    } else {
                                                        if (_e1355 == 1u) {
                                                            phi_1958_ = vec3<f32>(_e1139, _e1113, _e1126);
                                                        } else {
                                                            phi_1958_ = vec3<f32>(_e1113, _e1126, _e1139);
                                                        }
                                                        let _e1361 = phi_1958_;
                                                        phi_1959_ = _e1361;
                                                    }
                                                    let _e1363 = phi_1959_;
                                                    let _e1366 = (_e1363.x / _e1363.z);
                                                    let _e1369 = (_e1363.y / _e1363.z);
                                                    if (_e1284 < 0f) {
                                                        phi_1972_ = 0u;
                                                    } else {
                                                        phi_1972_ = 1u;
                                                    }
                                                    let _e1374 = phi_1972_;
                                                    if (_e1294 < 0f) {
                                                        phi_1977_ = 0u;
                                                    } else {
                                                        phi_1977_ = 2u;
                                                    }
                                                    let _e1377 = phi_1977_;
                                                    if (_e1304 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 4u;
                                                    }
                                                    let _e1380 = phi_1982_;
                                                    let _e1382 = ((_e1374 | _e1377) | _e1380);
                                                    let _e1383 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1144, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1383.first[0], _e1383.first[1], _e1383.first[2], _e1383.first[3], _e1383.first[4], _e1383.first[5], _e1383.first[6], _e1383.first[7], _e1383.first[8], _e1383.first[9], _e1383.first[10], _e1383.first[11], _e1383.first[12], _e1383.first[13], _e1383.first[14], _e1383.first[15], _e1383.first[16], _e1383.first[17], _e1383.first[18], _e1383.first[19], _e1383.first[20], _e1383.first[21], _e1383.first[22], _e1383.first[23], _e1383.first[24], _e1383.first[25], _e1383.first[26], _e1383.first[27], _e1383.first[28], _e1383.first[29], _e1383.first[30], _e1383.first[31]), array<u32, 32>(_e1383.mask[0], _e1383.mask[1], _e1383.mask[2], _e1383.mask[3], _e1383.mask[4], _e1383.mask[5], _e1383.mask[6], _e1383.mask[7], _e1383.mask[8], _e1383.mask[9], _e1383.mask[10], _e1383.mask[11], _e1383.mask[12], _e1383.mask[13], _e1383.mask[14], _e1383.mask[15], _e1383.mask[16], _e1383.mask[17], _e1383.mask[18], _e1383.mask[19], _e1383.mask[20], _e1383.mask[21], _e1383.mask[22], _e1383.mask[23], _e1383.mask[24], _e1383.mask[25], _e1383.mask[26], _e1383.mask[27], _e1383.mask[28], _e1383.mask[29], _e1383.mask[30], _e1383.mask[31]), _e1383.len, _e1383.group, _e1383.group_mask);
                                                    let _e1457 = local_2.group_mask;
                                                    if ((_e1457 & 4278190080u) == 0u) {
                                                        let _e1461 = local_2.len;
                                                        if (_e1461 == 0u) {
                                                            phi_2096_ = false;
                                                        } else {
                                                            let _e1465 = local_2.len;
                                                            local_2.len = (_e1465 - 1u);
                                                            let _e1468 = local_2.len;
                                                            if (_e1468 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1473 = local_2.first[(0u + _e1468)];
                                                            local_2.group = _e1473;
                                                            let _e1476 = local_2.len;
                                                            if (_e1476 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1481 = local_2.mask[(0u + _e1476)];
                                                            local_2.group_mask = _e1481;
                                                            phi_2096_ = true;
                                                        }
                                                        let _e1484 = phi_2096_;
                                                        phi_2097_ = _e1484;
                                                    } else {
                                                        phi_2097_ = true;
                                                    }
                                                    let _e1486 = phi_2097_;
                                                    if _e1486 {
                                                        let _e1488 = local_2.group_mask;
                                                        let _e1494 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1488)), 32u, (_e1488 == 0u)));
                                                        let _e1498 = local_2.group_mask;
                                                        let _e1512 = local_2.group_mask;
                                                        local_2.group_mask = (_e1512 & ~((1u << bitcast<u32>((_e1494 & 31u)))));
                                                        let _e1515 = local_2.group;
                                                        phi_2128_ = (_e1515 + countOneBits(((_e1498 & ~((4294967295u << bitcast<u32>((((_e1494 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2128_ = 4294967295u;
                                                    }
                                                    let _e1518 = phi_2128_;
                                                    phi_2130_ = _e977;
                                                    phi_2133_ = _e1518;
                                                    loop {
                                                        let _e1520 = phi_2130_;
                                                        let _e1522 = phi_2133_;
                                                        local_11 = _e1520;
                                                        let _e1523 = (_e1522 != 4294967295u);
                                                        if _e1523 {
                                                            if (_e1522 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1530 = nodes.member[(0u + _e1522)].frame[3u];
                                                            let _e1555 = (bitcast<f32>((((_e1530 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1284);
                                                            let _e1556 = (bitcast<f32>((((_e1530 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1294);
                                                            let _e1557 = (bitcast<f32>((((_e1530 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1304);
                                                            let _e1560 = nodes.member[(0u + _e1522)].frame[0u];
                                                            let _e1564 = nodes.member[(0u + _e1522)].frame[1u];
                                                            let _e1568 = nodes.member[(0u + _e1522)].frame[2u];
                                                            let _e1573 = ((bitcast<f32>(_e1560) - _e1069) * _e1284);
                                                            let _e1574 = ((bitcast<f32>(_e1564) - _e1082) * _e1294);
                                                            let _e1575 = ((bitcast<f32>(_e1568) - _e1095) * _e1304);
                                                            let _e1583 = nodes.member[(0u + _e1522)].x;
                                                            if (_e1284 < 0f) {
                                                                let _e1594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1583.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.unnamed.word, _e1583.w), _e1594.unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1600.unnamed, lt_mask_LightPlace(_e1583.x, _e1600.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_mask_LightPlace(_e1606.unnamed_1.word, _e1583.y));
                                                            } else {
                                                                let _e1622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1583.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1622.unnamed.word, _e1583.y), _e1622.unnamed_1);
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1628.unnamed, lt_mask_LightPlace(_e1583.z, _e1628.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_mask_LightPlace(_e1634.unnamed_1.word, _e1583.w));
                                                            }
                                                            let _e1642 = phi_2214_;
                                                            let _e1652 = nodes.member[(0u + _e1522)].y;
                                                            if (_e1294 < 0f) {
                                                                let _e1663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1652.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.unnamed.word, _e1652.w), _e1663.unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1669.unnamed, lt_mask_LightPlace(_e1652.x, _e1669.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_mask_LightPlace(_e1675.unnamed_1.word, _e1652.y));
                                                            } else {
                                                                let _e1691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1652.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1691.unnamed.word, _e1652.y), _e1691.unnamed_1);
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1697.unnamed, lt_mask_LightPlace(_e1652.z, _e1697.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_mask_LightPlace(_e1703.unnamed_1.word, _e1652.w));
                                                            }
                                                            let _e1711 = phi_2241_;
                                                            let _e1721 = nodes.member[(0u + _e1522)].z;
                                                            if (_e1304 < 0f) {
                                                                let _e1732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1721.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.unnamed.word, _e1721.w), _e1732.unnamed_1);
                                                                let _e1744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1738.unnamed, lt_mask_LightPlace(_e1721.x, _e1738.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1744.unnamed, lt_mask_LightPlace(_e1744.unnamed_1.word, _e1721.y));
                                                            } else {
                                                                let _e1760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1721.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1760.unnamed.word, _e1721.y), _e1760.unnamed_1);
                                                                let _e1772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1766.unnamed, lt_mask_LightPlace(_e1721.z, _e1766.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1772.unnamed, lt_mask_LightPlace(_e1772.unnamed_1.word, _e1721.w));
                                                            }
                                                            let _e1780 = phi_2268_;
                                                            phi_2274_ = 0u;
                                                            phi_2277_ = 0u;
                                                            loop {
                                                                let _e1790 = phi_2274_;
                                                                let _e1792 = phi_2277_;
                                                                local_7 = _e1792;
                                                                local_8 = _e1792;
                                                                local_9 = _e1792;
                                                                let _e1793 = (_e1790 < 8u);
                                                                if _e1793 {
                                                                    let _e1795 = (_e1790 >> bitcast<u32>(2i));
                                                                    let _e1796 = (_e1790 & 3u);
                                                                    if (_e1795 == 0u) {
                                                                        phi_2291_ = _e1642.unnamed.word;
                                                                    } else {
                                                                        phi_2291_ = _e1642.unnamed.shift;
                                                                    }
                                                                    let _e1799 = phi_2291_;
                                                                    if (_e1795 == 0u) {
                                                                        phi_2301_ = _e1711.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1711.unnamed.shift;
                                                                    }
                                                                    let _e1808 = phi_2301_;
                                                                    if (_e1795 == 0u) {
                                                                        phi_2311_ = _e1780.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1780.unnamed.shift;
                                                                    }
                                                                    let _e1817 = phi_2311_;
                                                                    let _e1830 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1799 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)), ((f32(((_e1808 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 - _e1333)));
                                                                    let _e1831 = core_intrinsics_maximum_number_nsz_f32_(_e1830, ((f32(((_e1817 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u)) * _e1557) + (_e1575 - _e1334)));
                                                                    if (_e1795 == 0u) {
                                                                        phi_2329_ = _e1642.unnamed_1.word;
                                                                    } else {
                                                                        phi_2329_ = _e1642.unnamed_1.shift;
                                                                    }
                                                                    let _e1834 = phi_2329_;
                                                                    if (_e1795 == 0u) {
                                                                        phi_2339_ = _e1711.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1711.unnamed_1.shift;
                                                                    }
                                                                    let _e1843 = phi_2339_;
                                                                    if (_e1795 == 0u) {
                                                                        phi_2349_ = _e1780.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1780.unnamed_1.shift;
                                                                    }
                                                                    let _e1852 = phi_2349_;
                                                                    let _e1865 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1834 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)), ((f32(((_e1843 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 + _e1333)));
                                                                    let _e1866 = core_intrinsics_minimum_number_nsz_f32_(_e1865, ((f32(((_e1852 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u)) * _e1557) + (_e1575 + _e1334)));
                                                                    if (_e1831 <= _e1866) {
                                                                        if (_e1831 <= _e1520.t) {
                                                                            if (_e1866 >= _e162.tmin) {
                                                                                if (_e1795 == 0u) {
                                                                                    let _e1873 = nodes.member[(0u + _e1522)].links[2u];
                                                                                    phi_2385_ = _e1873;
                                                                                } else {
                                                                                    let _e1876 = nodes.member[(0u + _e1522)].links[3u];
                                                                                    phi_2385_ = _e1876;
                                                                                }
                                                                                let _e1878 = phi_2385_;
                                                                                let _e1883 = ((_e1878 >> bitcast<u32>(((_e1796 * 8u) & 31u))) & 255u);
                                                                                let _e1884 = (_e1883 & 31u);
                                                                                if (_e1884 >= 24u) {
                                                                                    phi_2398_ = (24u + ((_e1884 - 24u) ^ _e1382));
                                                                                } else {
                                                                                    phi_2398_ = _e1884;
                                                                                }
                                                                                let _e1890 = phi_2398_;
                                                                                phi_2403_ = (_e1792 | ((_e1883 >> bitcast<u32>(5i)) << bitcast<u32>((_e1890 & 31u))));
                                                                            } else {
                                                                                phi_2403_ = _e1792;
                                                                            }
                                                                            let _e1898 = phi_2403_;
                                                                            phi_2404_ = _e1898;
                                                                        } else {
                                                                            phi_2404_ = _e1792;
                                                                        }
                                                                        let _e1900 = phi_2404_;
                                                                        phi_2405_ = _e1900;
                                                                    } else {
                                                                        phi_2405_ = _e1792;
                                                                    }
                                                                    let _e1902 = phi_2405_;
                                                                    phi_2275_ = (_e1790 + 1u);
                                                                    phi_2278_ = _e1902;
                                                                } else {
                                                                    phi_2275_ = u32();
                                                                    phi_2278_ = u32();
                                                                }
                                                                let _e1905 = phi_2275_;
                                                                let _e1907 = phi_2278_;
                                                                continue;
                                                                continuing {
                                                                    phi_2274_ = _e1905;
                                                                    phi_2277_ = _e1907;
                                                                    break if !(_e1793);
                                                                }
                                                            }
                                                            let _e1911 = nodes.member[(0u + _e1522)].links[0u];
                                                            let _e1915 = nodes.member[(0u + _e1522)].frame[3u];
                                                            let _e1919 = local_7;
                                                            if ((_e1919 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1923 = local_2.group_mask;
                                                                if ((_e1923 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1927 = local_2.len;
                                                                    if (_e1927 < 32u) {
                                                                        let _e1930 = local_2.group;
                                                                        let _e1932 = local_2.len;
                                                                        if (_e1932 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1932)] = _e1930;
                                                                        let _e1938 = local_2.group_mask;
                                                                        let _e1940 = local_2.len;
                                                                        if (_e1940 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1940)] = _e1938;
                                                                        let _e1947 = local_2.len;
                                                                        local_2.len = (_e1947 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1144 + _e1911);
                                                                let _e1951 = local_8;
                                                                local_2.group_mask = ((_e1951 & 4278190080u) | (_e1915 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1956 = local_9;
                                                            phi_2463_ = _e1520;
                                                            phi_2466_ = (_e1956 & 16777215u);
                                                            loop {
                                                                let _e1959 = phi_2463_;
                                                                let _e1961 = phi_2466_;
                                                                local_10 = _e1959;
                                                                if (_e1961 == 0u) {
                                                                    phi_2464_ = lt_bvh_Hit();
                                                                    phi_2467_ = u32();
                                                                    phi_3305_ = false;
                                                                } else {
                                                                    let _e1965 = nodes.member[(0u + _e1522)].links[1u];
                                                                    let _e1970 = ((_e1146 + _e1965) + select(firstTrailingBit(_e1961), 32u, (_e1961 == 0u)));
                                                                    if (_e1970 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1977 = triangles.member[(0u + _e1970)].v0_;
                                                                    let _e1979 = (_e1977.x - _e1069);
                                                                    let _e1981 = (_e1977.y - _e1082);
                                                                    let _e1983 = (_e1977.z - _e1095);
                                                                    if (_e1355 == 0u) {
                                                                        phi_2511_ = vec3<f32>(_e1981, _e1983, _e1979);
                                                                    } else {
                                                                        if (_e1355 == 1u) {
                                                                            phi_2510_ = vec3<f32>(_e1983, _e1979, _e1981);
                                                                        } else {
                                                                            phi_2510_ = (_e1977 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                        }
                                                                        let _e1991 = phi_2510_;
                                                                        phi_2511_ = _e1991;
                                                                    }
                                                                    let _e1993 = phi_2511_;
                                                                    let _e1997 = (_e1993.x - (_e1366 * _e1993.z));
                                                                    let _e2001 = (_e1993.y - (_e1369 * _e1993.z));
                                                                    let _e2003 = triangles.member[(0u + _e1970)].v1_;
                                                                    let _e2005 = (_e2003.x - _e1069);
                                                                    let _e2007 = (_e2003.y - _e1082);
                                                                    let _e2009 = (_e2003.z - _e1095);
                                                                    if (_e1355 == 0u) {
                                                                        phi_2541_ = vec3<f32>(_e2007, _e2009, _e2005);
                                                                    } else {
                                                                        if (_e1355 == 1u) {
                                                                            phi_2540_ = vec3<f32>(_e2009, _e2005, _e2007);
                                                                        } else {
                                                                            phi_2540_ = (_e2003 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                        }
                                                                        let _e2017 = phi_2540_;
                                                                        phi_2541_ = _e2017;
                                                                    }
                                                                    let _e2019 = phi_2541_;
                                                                    let _e2023 = (_e2019.x - (_e1366 * _e2019.z));
                                                                    let _e2027 = (_e2019.y - (_e1369 * _e2019.z));
                                                                    let _e2029 = triangles.member[(0u + _e1970)].v2_;
                                                                    let _e2031 = (_e2029.x - _e1069);
                                                                    let _e2033 = (_e2029.y - _e1082);
                                                                    let _e2035 = (_e2029.z - _e1095);
                                                                    if (_e1355 == 0u) {
                                                                        phi_2571_ = vec3<f32>(_e2033, _e2035, _e2031);
                                                                    } else {
                                                                        if (_e1355 == 1u) {
                                                                            phi_2570_ = vec3<f32>(_e2035, _e2031, _e2033);
                                                                        } else {
                                                                            phi_2570_ = (_e2029 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                        }
                                                                        let _e2043 = phi_2570_;
                                                                        phi_2571_ = _e2043;
                                                                    }
                                                                    let _e2045 = phi_2571_;
                                                                    let _e2049 = (_e2045.x - (_e1366 * _e2045.z));
                                                                    let _e2053 = (_e2045.y - (_e1369 * _e2045.z));
                                                                    if (_e2023 < _e2049) {
                                                                        phi_2590_ = true;
                                                                    } else {
                                                                        if (_e2023 == _e2049) {
                                                                            phi_2589_ = (_e2027 < _e2053);
                                                                        } else {
                                                                            phi_2589_ = false;
                                                                        }
                                                                        let _e2058 = phi_2589_;
                                                                        phi_2590_ = _e2058;
                                                                    }
                                                                    let _e2060 = phi_2590_;
                                                                    if _e2060 {
                                                                        phi_2594_ = _e2053;
                                                                        phi_2595_ = _e2049;
                                                                        phi_2596_ = _e2027;
                                                                        phi_2597_ = _e2023;
                                                                    } else {
                                                                        phi_2594_ = _e2027;
                                                                        phi_2595_ = _e2023;
                                                                        phi_2596_ = _e2053;
                                                                        phi_2597_ = _e2049;
                                                                    }
                                                                    let _e2062 = phi_2594_;
                                                                    let _e2064 = phi_2595_;
                                                                    let _e2066 = phi_2596_;
                                                                    let _e2068 = phi_2597_;
                                                                    let _e2071 = ((_e2068 * _e2062) - (_e2066 * _e2064));
                                                                    if _e2060 {
                                                                        phi_2605_ = -(_e2071);
                                                                    } else {
                                                                        phi_2605_ = _e2071;
                                                                    }
                                                                    let _e2074 = phi_2605_;
                                                                    if (_e2049 < _e1997) {
                                                                        phi_2616_ = true;
                                                                    } else {
                                                                        if (_e2049 == _e1997) {
                                                                            phi_2615_ = (_e2053 < _e2001);
                                                                        } else {
                                                                            phi_2615_ = false;
                                                                        }
                                                                        let _e2079 = phi_2615_;
                                                                        phi_2616_ = _e2079;
                                                                    }
                                                                    let _e2081 = phi_2616_;
                                                                    if _e2081 {
                                                                        phi_2620_ = _e2001;
                                                                        phi_2621_ = _e1997;
                                                                        phi_2622_ = _e2053;
                                                                        phi_2623_ = _e2049;
                                                                    } else {
                                                                        phi_2620_ = _e2053;
                                                                        phi_2621_ = _e2049;
                                                                        phi_2622_ = _e2001;
                                                                        phi_2623_ = _e1997;
                                                                    }
                                                                    let _e2083 = phi_2620_;
                                                                    let _e2085 = phi_2621_;
                                                                    let _e2087 = phi_2622_;
                                                                    let _e2089 = phi_2623_;
                                                                    let _e2092 = ((_e2089 * _e2083) - (_e2087 * _e2085));
                                                                    if _e2081 {
                                                                        phi_2631_ = -(_e2092);
                                                                    } else {
                                                                        phi_2631_ = _e2092;
                                                                    }
                                                                    let _e2095 = phi_2631_;
                                                                    if (_e1997 < _e2023) {
                                                                        phi_2642_ = true;
                                                                    } else {
                                                                        if (_e1997 == _e2023) {
                                                                            phi_2641_ = (_e2001 < _e2027);
                                                                        } else {
                                                                            phi_2641_ = false;
                                                                        }
                                                                        let _e2100 = phi_2641_;
                                                                        phi_2642_ = _e2100;
                                                                    }
                                                                    let _e2102 = phi_2642_;
                                                                    if _e2102 {
                                                                        phi_2646_ = _e2027;
                                                                        phi_2647_ = _e2023;
                                                                        phi_2648_ = _e2001;
                                                                        phi_2649_ = _e1997;
                                                                    } else {
                                                                        phi_2646_ = _e2001;
                                                                        phi_2647_ = _e1997;
                                                                        phi_2648_ = _e2027;
                                                                        phi_2649_ = _e2023;
                                                                    }
                                                                    let _e2104 = phi_2646_;
                                                                    let _e2106 = phi_2647_;
                                                                    let _e2108 = phi_2648_;
                                                                    let _e2110 = phi_2649_;
                                                                    let _e2113 = ((_e2110 * _e2104) - (_e2108 * _e2106));
                                                                    if _e2102 {
                                                                        phi_2657_ = -(_e2113);
                                                                    } else {
                                                                        phi_2657_ = _e2113;
                                                                    }
                                                                    let _e2116 = phi_2657_;
                                                                    if (_e2074 >= 0f) {
                                                                        if (_e2095 >= 0f) {
                                                                            if (_e2116 >= 0f) {
                                                                                phi_2672_ = ((_e2074 + _e2095) + _e2116);
                                                                                phi_2673_ = false;
                                                                            } else {
                                                                                phi_2672_ = f32();
                                                                                phi_2673_ = true;
                                                                            }
                                                                            let _e2123 = phi_2672_;
                                                                            let _e2125 = phi_2673_;
                                                                            phi_2674_ = _e2123;
                                                                            phi_2675_ = _e2125;
                                                                        } else {
                                                                            phi_2674_ = f32();
                                                                            phi_2675_ = true;
                                                                        }
                                                                        let _e2127 = phi_2674_;
                                                                        let _e2129 = phi_2675_;
                                                                        phi_2676_ = _e2127;
                                                                        phi_2677_ = _e2129;
                                                                    } else {
                                                                        phi_2676_ = f32();
                                                                        phi_2677_ = true;
                                                                    }
                                                                    let _e2131 = phi_2676_;
                                                                    let _e2133 = phi_2677_;
                                                                    if _e2133 {
                                                                        if (_e2074 <= 0f) {
                                                                            if (_e2095 <= 0f) {
                                                                                let _e2136 = (_e2116 <= 0f);
                                                                                if _e2136 {
                                                                                }
                                                                                phi_2695_ = ((_e2074 + _e2095) + _e2116);
                                                                                phi_2696_ = false;
                                                                                phi_2697_ = _e2136;
                                                                            } else {
                                                                                phi_2695_ = f32();
                                                                                phi_2696_ = true;
                                                                                phi_2697_ = false;
                                                                            }
                                                                            let _e2140 = phi_2695_;
                                                                            let _e2142 = phi_2696_;
                                                                            let _e2144 = phi_2697_;
                                                                            phi_2698_ = _e2140;
                                                                            phi_2699_ = _e2142;
                                                                            phi_2700_ = _e2144;
                                                                        } else {
                                                                            phi_2698_ = f32();
                                                                            phi_2699_ = true;
                                                                            phi_2700_ = false;
                                                                        }
                                                                        let _e2146 = phi_2698_;
                                                                        let _e2148 = phi_2699_;
                                                                        let _e2150 = phi_2700_;
                                                                        if _e2148 {
                                                                            phi_2704_ = false;
                                                                        } else {
                                                                            phi_2704_ = _e2150;
                                                                        }
                                                                        let _e2152 = phi_2704_;
                                                                        phi_2705_ = _e2146;
                                                                        phi_2706_ = _e2152;
                                                                    } else {
                                                                        phi_2705_ = _e2131;
                                                                        phi_2706_ = true;
                                                                    }
                                                                    let _e2154 = phi_2705_;
                                                                    let _e2156 = phi_2706_;
                                                                    if _e2156 {
                                                                        let _e2157 = (_e2154 == 0f);
                                                                        if _e2157 {
                                                                            phi_3022_ = lt_bvh_triangle_Intersection();
                                                                            phi_3023_ = false;
                                                                        } else {
                                                                            let _e2159 = triangles.member[(0u + _e1970)].v0_;
                                                                            let _e2161 = (_e2159.x - _e1069);
                                                                            let _e2163 = (_e2159.y - _e1082);
                                                                            let _e2165 = (_e2159.z - _e1095);
                                                                            if (_e1355 == 0u) {
                                                                                phi_2735_ = vec3<f32>(_e2163, _e2165, _e2161);
                                                                            } else {
                                                                                if (_e1355 == 1u) {
                                                                                    phi_2734_ = vec3<f32>(_e2165, _e2161, _e2163);
                                                                                } else {
                                                                                    phi_2734_ = (_e2159 - vec3<f32>(_e1069, _e1082, _e1095));
                                                                                }
                                                                                let _e2173 = phi_2734_;
                                                                                phi_2735_ = _e2173;
                                                                            }
                                                                            let _e2175 = phi_2735_;
                                                                            let _e2177 = triangles.member[(0u + _e1970)].v1_;
                                                                            let _e2179 = triangles.member[(0u + _e1970)].v0_;
                                                                            let _e2182 = (_e2177.x - _e2179.x);
                                                                            let _e2185 = (_e2177.y - _e2179.y);
                                                                            let _e2188 = (_e2177.z - _e2179.z);
                                                                            if (_e1355 == 0u) {
                                                                                phi_2761_ = vec3<f32>(_e2185, _e2188, _e2182);
                                                                            } else {
                                                                                if (_e1355 == 1u) {
                                                                                    phi_2760_ = vec3<f32>(_e2188, _e2182, _e2185);
                                                                                } else {
                                                                                    phi_2760_ = (_e2177 - _e2179);
                                                                                }
                                                                                let _e2195 = phi_2760_;
                                                                                phi_2761_ = _e2195;
                                                                            }
                                                                            let _e2197 = phi_2761_;
                                                                            let _e2199 = triangles.member[(0u + _e1970)].v2_;
                                                                            let _e2201 = triangles.member[(0u + _e1970)].v0_;
                                                                            let _e2204 = (_e2199.x - _e2201.x);
                                                                            let _e2207 = (_e2199.y - _e2201.y);
                                                                            let _e2210 = (_e2199.z - _e2201.z);
                                                                            if (_e1355 == 0u) {
                                                                                phi_2787_ = vec3<f32>(_e2207, _e2210, _e2204);
                                                                            } else {
                                                                                if (_e1355 == 1u) {
                                                                                    phi_2786_ = vec3<f32>(_e2210, _e2204, _e2207);
                                                                                } else {
                                                                                    phi_2786_ = (_e2199 - _e2201);
                                                                                }
                                                                                let _e2217 = phi_2786_;
                                                                                phi_2787_ = _e2217;
                                                                            }
                                                                            let _e2219 = phi_2787_;
                                                                            let _e2226 = ((_e2197.y * _e2219.z) - (_e2197.z * _e2219.y));
                                                                            let _e2233 = ((_e2197.z * _e2219.x) - (_e2197.x * _e2219.z));
                                                                            let _e2240 = ((_e2197.x * _e2219.y) - (_e2197.y * _e2219.x));
                                                                            let _e2254 = (((1f / _e1363.z) * (((_e2226 * _e2175.x) + (_e2233 * _e2175.y)) + (_e2240 * _e2175.z))) / (((_e2226 * _e1366) + (_e2233 * _e1369)) + _e2240));
                                                                            if (_e2254 > _e162.tmin) {
                                                                                if (_e2254 < _e162.tmax) {
                                                                                    let _e2258 = triangles.member[(0u + _e1970)].v0_;
                                                                                    let _e2260 = triangles.member[(0u + _e1970)].v1_;
                                                                                    if (_e2258.x < _e2260.x) {
                                                                                        phi_2843_ = _e2258.x;
                                                                                    } else {
                                                                                        phi_2843_ = _e2260.x;
                                                                                    }
                                                                                    let _e2267 = phi_2843_;
                                                                                    if (_e2258.y < _e2260.y) {
                                                                                        phi_2852_ = _e2258.y;
                                                                                    } else {
                                                                                        phi_2852_ = _e2260.y;
                                                                                    }
                                                                                    let _e2274 = phi_2852_;
                                                                                    if (_e2258.z < _e2260.z) {
                                                                                        phi_2861_ = _e2258.z;
                                                                                    } else {
                                                                                        phi_2861_ = _e2260.z;
                                                                                    }
                                                                                    let _e2281 = phi_2861_;
                                                                                    let _e2283 = triangles.member[(0u + _e1970)].v2_;
                                                                                    if (_e2267 < _e2283.x) {
                                                                                        phi_2870_ = _e2267;
                                                                                    } else {
                                                                                        phi_2870_ = _e2283.x;
                                                                                    }
                                                                                    let _e2288 = phi_2870_;
                                                                                    if (_e2274 < _e2283.y) {
                                                                                        phi_2877_ = _e2274;
                                                                                    } else {
                                                                                        phi_2877_ = _e2283.y;
                                                                                    }
                                                                                    let _e2293 = phi_2877_;
                                                                                    if (_e2281 < _e2283.z) {
                                                                                        phi_2884_ = _e2281;
                                                                                    } else {
                                                                                        phi_2884_ = _e2283.z;
                                                                                    }
                                                                                    let _e2298 = phi_2884_;
                                                                                    let _e2300 = triangles.member[(0u + _e1970)].v0_;
                                                                                    let _e2302 = triangles.member[(0u + _e1970)].v1_;
                                                                                    if (_e2300.x > _e2302.x) {
                                                                                        phi_2897_ = _e2300.x;
                                                                                    } else {
                                                                                        phi_2897_ = _e2302.x;
                                                                                    }
                                                                                    let _e2309 = phi_2897_;
                                                                                    if (_e2300.y > _e2302.y) {
                                                                                        phi_2906_ = _e2300.y;
                                                                                    } else {
                                                                                        phi_2906_ = _e2302.y;
                                                                                    }
                                                                                    let _e2316 = phi_2906_;
                                                                                    if (_e2300.z > _e2302.z) {
                                                                                        phi_2915_ = _e2300.z;
                                                                                    } else {
                                                                                        phi_2915_ = _e2302.z;
                                                                                    }
                                                                                    let _e2323 = phi_2915_;
                                                                                    let _e2325 = triangles.member[(0u + _e1970)].v2_;
                                                                                    if (_e2309 > _e2325.x) {
                                                                                        phi_2924_ = _e2309;
                                                                                    } else {
                                                                                        phi_2924_ = _e2325.x;
                                                                                    }
                                                                                    let _e2330 = phi_2924_;
                                                                                    if (_e2316 > _e2325.y) {
                                                                                        phi_2931_ = _e2316;
                                                                                    } else {
                                                                                        phi_2931_ = _e2325.y;
                                                                                    }
                                                                                    let _e2335 = phi_2931_;
                                                                                    if (_e2323 > _e2325.z) {
                                                                                        phi_2938_ = _e2323;
                                                                                    } else {
                                                                                        phi_2938_ = _e2325.z;
                                                                                    }
                                                                                    let _e2340 = phi_2938_;
                                                                                    let _e2344 = ((_e2288 - _e1069) * _e1284);
                                                                                    let _e2345 = ((_e2293 - _e1082) * _e1294);
                                                                                    let _e2346 = ((_e2298 - _e1095) * _e1304);
                                                                                    let _e2350 = ((_e2330 - _e1069) * _e1284);
                                                                                    let _e2351 = ((_e2335 - _e1082) * _e1294);
                                                                                    let _e2352 = ((_e2340 - _e1095) * _e1304);
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2955_ = _e2344;
                                                                                    } else {
                                                                                        phi_2955_ = _e2350;
                                                                                    }
                                                                                    let _e2355 = phi_2955_;
                                                                                    if (_e2345 < _e2351) {
                                                                                        phi_2960_ = _e2345;
                                                                                    } else {
                                                                                        phi_2960_ = _e2351;
                                                                                    }
                                                                                    let _e2358 = phi_2960_;
                                                                                    if (_e2346 < _e2352) {
                                                                                        phi_2965_ = _e2346;
                                                                                    } else {
                                                                                        phi_2965_ = _e2352;
                                                                                    }
                                                                                    let _e2361 = phi_2965_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_2973_ = _e2344;
                                                                                    } else {
                                                                                        phi_2973_ = _e2350;
                                                                                    }
                                                                                    let _e2367 = phi_2973_;
                                                                                    if (_e2345 > _e2351) {
                                                                                        phi_2978_ = _e2345;
                                                                                    } else {
                                                                                        phi_2978_ = _e2351;
                                                                                    }
                                                                                    let _e2370 = phi_2978_;
                                                                                    if (_e2346 > _e2352) {
                                                                                        phi_2983_ = _e2346;
                                                                                    } else {
                                                                                        phi_2983_ = _e2352;
                                                                                    }
                                                                                    let _e2373 = phi_2983_;
                                                                                    let _e2377 = core_intrinsics_maximum_number_nsz_f32_((_e2355 - _e1339), (_e2358 - _e1340));
                                                                                    let _e2378 = core_intrinsics_maximum_number_nsz_f32_(_e2377, (_e2361 - _e1341));
                                                                                    let _e2379 = core_intrinsics_minimum_number_nsz_f32_((_e2367 + _e1339), (_e2370 + _e1340));
                                                                                    let _e2380 = core_intrinsics_minimum_number_nsz_f32_(_e2379, (_e2373 + _e1341));
                                                                                    if (_e2378 > _e1044) {
                                                                                        phi_2995_ = _e2378;
                                                                                    } else {
                                                                                        phi_2995_ = _e1044;
                                                                                    }
                                                                                    let _e2383 = phi_2995_;
                                                                                    if (_e2380 < _e1046) {
                                                                                        phi_3000_ = _e2380;
                                                                                    } else {
                                                                                        phi_3000_ = _e1046;
                                                                                    }
                                                                                    let _e2386 = phi_3000_;
                                                                                    if (_e2254 < _e2383) {
                                                                                        phi_3005_ = _e2383;
                                                                                    } else {
                                                                                        phi_3005_ = _e2254;
                                                                                    }
                                                                                    let _e2389 = phi_3005_;
                                                                                    if (_e2389 > _e2386) {
                                                                                        phi_3010_ = _e2386;
                                                                                    } else {
                                                                                        phi_3010_ = _e2389;
                                                                                    }
                                                                                    let _e2392 = phi_3010_;
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection(_e2392, (_e2095 / _e2154), (_e2116 / _e2154), (_e2383 <= _e2386));
                                                                                    phi_3016_ = false;
                                                                                } else {
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3016_ = true;
                                                                                }
                                                                                let _e2398 = phi_3015_;
                                                                                let _e2400 = phi_3016_;
                                                                                phi_3017_ = _e2398;
                                                                                phi_3018_ = _e2400;
                                                                            } else {
                                                                                phi_3017_ = lt_bvh_triangle_Intersection();
                                                                                phi_3018_ = true;
                                                                            }
                                                                            let _e2402 = phi_3017_;
                                                                            let _e2404 = phi_3018_;
                                                                            if _e2404 {
                                                                            }
                                                                            phi_3022_ = _e2402;
                                                                            phi_3023_ = _e2404;
                                                                        }
                                                                        let _e2406 = phi_3022_;
                                                                        let _e2408 = phi_3023_;
                                                                        phi_3024_ = _e2406;
                                                                        phi_3025_ = _e2157;
                                                                        phi_3026_ = _e2408;
                                                                    } else {
                                                                        phi_3024_ = lt_bvh_triangle_Intersection();
                                                                        phi_3025_ = true;
                                                                        phi_3026_ = false;
                                                                    }
                                                                    let _e2410 = phi_3024_;
                                                                    let _e2412 = phi_3025_;
                                                                    let _e2414 = phi_3026_;
                                                                    if _e2412 {
                                                                        phi_3030_ = true;
                                                                    } else {
                                                                        phi_3030_ = _e2414;
                                                                    }
                                                                    let _e2416 = phi_3030_;
                                                                    if _e2416 {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3034_ = _e2410;
                                                                    }
                                                                    let _e2418 = phi_3034_;
                                                                    if _e2418.is_hit {
                                                                        if (_e2418.t > _e162.tmin) {
                                                                            if (_e2418.t < _e1959.t) {
                                                                                phi_3082_ = true;
                                                                            } else {
                                                                                if (_e2418.t == _e1959.t) {
                                                                                    if (_e1959.triangle != 4294967295u) {
                                                                                        if (_e1970 < _e1959.triangle) {
                                                                                            phi_3073_ = true;
                                                                                        } else {
                                                                                            if (_e1970 == _e1959.triangle) {
                                                                                                phi_3072_ = (_e985 < _e1959.instance);
                                                                                            } else {
                                                                                                phi_3072_ = false;
                                                                                            }
                                                                                            let _e2436 = phi_3072_;
                                                                                            phi_3073_ = _e2436;
                                                                                        }
                                                                                        let _e2438 = phi_3073_;
                                                                                        phi_3074_ = _e2438;
                                                                                        phi_3075_ = false;
                                                                                    } else {
                                                                                        phi_3074_ = bool();
                                                                                        phi_3075_ = true;
                                                                                    }
                                                                                    let _e2440 = phi_3074_;
                                                                                    let _e2442 = phi_3075_;
                                                                                    phi_3076_ = _e2440;
                                                                                    phi_3077_ = _e2442;
                                                                                } else {
                                                                                    phi_3076_ = bool();
                                                                                    phi_3077_ = true;
                                                                                }
                                                                                let _e2444 = phi_3076_;
                                                                                let _e2446 = phi_3077_;
                                                                                if _e2446 {
                                                                                    phi_3081_ = false;
                                                                                } else {
                                                                                    phi_3081_ = _e2444;
                                                                                }
                                                                                let _e2448 = phi_3081_;
                                                                                phi_3082_ = _e2448;
                                                                            }
                                                                            let _e2450 = phi_3082_;
                                                                            if _e2450 {
                                                                                let _e2452 = triangles.member[(0u + _e1970)].i0_;
                                                                                if ((_e2452 & 2147483648u) == 0u) {
                                                                                    phi_3293_ = true;
                                                                                } else {
                                                                                    if (_e1970 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2461 = triangles.member[(0u + _e1970)].i0_;
                                                                                    let _e2462 = (_e2461 & 2147483647u);
                                                                                    let _e2464 = triangles.member[(0u + _e1970)].i1_;
                                                                                    let _e2466 = triangles.member[(0u + _e1970)].i2_;
                                                                                    if (_e2462 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2470 = vertices.member[(0u + _e2462)];
                                                                                    if (_e2464 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2474 = vertices.member[(0u + _e2464)];
                                                                                    if (_e2466 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2478 = vertices.member[(0u + _e2466)];
                                                                                    let _e2479 = array<abi_Vertex, 3>(_e2470, _e2474, _e2478);
                                                                                    if (_e2479[0].material < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2485 = materials.member[(0u + _e2479[0].material)];
                                                                                    if ((_e2485.flags & 0u) == 0u) {
                                                                                        let _e2490 = ((1f - _e2418.u) - _e2418.v);
                                                                                        if (_e2485.cutoff <= 0f) {
                                                                                            phi_3288_ = true;
                                                                                        } else {
                                                                                            let _e2517 = (_e2485.base_color.w * ((((f32((_e2479[0].color >> bitcast<u32>(24i))) * _e2490) + (f32((_e2479[1].color >> bitcast<u32>(24i))) * _e2418.u)) + (f32((_e2479[2].color >> bitcast<u32>(24i))) * _e2418.v)) * (1f / 255f)));
                                                                                            if (_e2485.alpha_size == 0u) {
                                                                                                phi_3285_ = _e2517;
                                                                                            } else {
                                                                                                local_1.offset = _e2485.alpha_offset;
                                                                                                local_1.size = _e2485.alpha_size;
                                                                                                local_1.flags = _e2485.flags;
                                                                                                let _e2548 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2479[0].u * _e2490) + (_e2479[1].u * _e2418.u)) + (_e2479[2].u * _e2418.v)), (((_e2479[0].v * _e2490) + (_e2479[1].v * _e2418.u)) + (_e2479[2].v * _e2418.v)));
                                                                                                let _e2552 = (_e2548.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2552 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2556 = alpha_texels.member[(0u + _e2552)];
                                                                                                let _e2572 = (_e2548.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2572 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2576 = alpha_texels.member[(0u + _e2572)];
                                                                                                let _e2593 = (_e2548.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2593 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2597 = alpha_texels.member[(0u + _e2593)];
                                                                                                let _e2614 = (_e2548.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2614 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2618 = alpha_texels.member[(0u + _e2614)];
                                                                                                phi_3285_ = (_e2517 * (((((f32(((_e2556 >> bitcast<u32>((((_e2548.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2548.weights.x) + ((f32(((_e2576 >> bitcast<u32>((((_e2548.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2548.weights.y)) + ((f32(((_e2597 >> bitcast<u32>((((_e2548.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2548.weights.z)) + ((f32(((_e2618 >> bitcast<u32>((((_e2548.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2548.weights.w)));
                                                                                            }
                                                                                            let _e2634 = phi_3285_;
                                                                                            phi_3288_ = (_e2634 >= _e2485.cutoff);
                                                                                        }
                                                                                        let _e2638 = phi_3288_;
                                                                                        phi_3289_ = _e2638;
                                                                                    } else {
                                                                                        phi_3289_ = false;
                                                                                    }
                                                                                    let _e2640 = phi_3289_;
                                                                                    if _e2640 {
                                                                                    }
                                                                                    phi_3293_ = _e2640;
                                                                                }
                                                                                let _e2642 = phi_3293_;
                                                                                if _e2642 {
                                                                                    phi_3301_ = lt_bvh_Hit(_e2418.t, _e2418.u, _e2418.v, _e1970, _e985);
                                                                                } else {
                                                                                    phi_3301_ = _e1959;
                                                                                }
                                                                                let _e2648 = phi_3301_;
                                                                                phi_3302_ = _e2648;
                                                                            } else {
                                                                                phi_3302_ = _e1959;
                                                                            }
                                                                            let _e2650 = phi_3302_;
                                                                            phi_3303_ = _e2650;
                                                                        } else {
                                                                            phi_3303_ = _e1959;
                                                                        }
                                                                        let _e2652 = phi_3303_;
                                                                        phi_3304_ = _e2652;
                                                                    } else {
                                                                        phi_3304_ = _e1959;
                                                                    }
                                                                    let _e2654 = phi_3304_;
                                                                    phi_2464_ = _e2654;
                                                                    phi_2467_ = (_e1961 & (_e1961 - 1u));
                                                                    phi_3305_ = true;
                                                                }
                                                                let _e2656 = phi_2464_;
                                                                let _e2658 = phi_2467_;
                                                                let _e2660 = phi_3305_;
                                                                continue;
                                                                continuing {
                                                                    phi_2463_ = _e2656;
                                                                    phi_2466_ = _e2658;
                                                                    break if !(_e2660);
                                                                }
                                                            }
                                                            let _e2663 = local_2.group_mask;
                                                            if ((_e2663 & 4278190080u) == 0u) {
                                                                let _e2667 = local_2.len;
                                                                if (_e2667 == 0u) {
                                                                    phi_3344_ = false;
                                                                } else {
                                                                    let _e2671 = local_2.len;
                                                                    local_2.len = (_e2671 - 1u);
                                                                    let _e2674 = local_2.len;
                                                                    if (_e2674 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2679 = local_2.first[(0u + _e2674)];
                                                                    local_2.group = _e2679;
                                                                    let _e2682 = local_2.len;
                                                                    if (_e2682 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2687 = local_2.mask[(0u + _e2682)];
                                                                    local_2.group_mask = _e2687;
                                                                    phi_3344_ = true;
                                                                }
                                                                let _e2690 = phi_3344_;
                                                                phi_3345_ = _e2690;
                                                            } else {
                                                                phi_3345_ = true;
                                                            }
                                                            let _e2692 = phi_3345_;
                                                            if _e2692 {
                                                                let _e2694 = local_2.group_mask;
                                                                let _e2700 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2694)), 32u, (_e2694 == 0u)));
                                                                let _e2704 = local_2.group_mask;
                                                                let _e2718 = local_2.group_mask;
                                                                local_2.group_mask = (_e2718 & ~((1u << bitcast<u32>((_e2700 & 31u)))));
                                                                let _e2721 = local_2.group;
                                                                phi_3376_ = (_e2721 + countOneBits(((_e2704 & ~((4294967295u << bitcast<u32>((((_e2700 - 24u) ^ _e1382) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3376_ = 4294967295u;
                                                            }
                                                            let _e2724 = phi_3376_;
                                                            let _e3857 = local_10;
                                                            phi_2131_ = _e3857;
                                                            phi_2134_ = _e2724;
                                                        } else {
                                                            phi_2131_ = lt_bvh_Hit();
                                                            phi_2134_ = u32();
                                                        }
                                                        let _e2726 = phi_2131_;
                                                        let _e2728 = phi_2134_;
                                                        continue;
                                                        continuing {
                                                            phi_2130_ = _e2726;
                                                            phi_2133_ = _e2728;
                                                            break if !(_e1523);
                                                        }
                                                    }
                                                    let _e3861 = local_11;
                                                    phi_3377_ = _e3861;
                                                }
                                                let _e2731 = phi_3377_;
                                                phi_3378_ = _e2731;
                                                phi_3379_ = _e1208;
                                            } else {
                                                phi_3378_ = lt_bvh_Hit();
                                                phi_3379_ = true;
                                            }
                                            let _e2733 = phi_3378_;
                                            let _e2735 = phi_3379_;
                                            if _e2735 {
                                                phi_3383_ = _e977;
                                            } else {
                                                phi_3383_ = _e2733;
                                            }
                                            let _e2737 = phi_3383_;
                                            phi_3384_ = _e2737;
                                        } else {
                                            phi_3384_ = _e977;
                                        }
                                        let _e2739 = phi_3384_;
                                        phi_3385_ = _e2739;
                                    } else {
                                        phi_3385_ = _e977;
                                    }
                                    let _e2741 = phi_3385_;
                                    phi_3386_ = _e2741;
                                } else {
                                    phi_3386_ = _e977;
                                }
                                let _e2743 = phi_3386_;
                                phi_1505_ = (_e975 & (_e975 - 1u));
                                phi_1508_ = _e2743;
                                phi_3387_ = true;
                            }
                            let _e2745 = phi_1505_;
                            let _e2747 = phi_1508_;
                            let _e2749 = phi_3387_;
                            continue;
                            continuing {
                                phi_1504_ = _e2745;
                                phi_1507_ = _e2747;
                                break if !(_e2749);
                            }
                        }
                        let _e2752 = local_3.group_mask;
                        if ((_e2752 & 4278190080u) == 0u) {
                            let _e2756 = local_3.len;
                            if (_e2756 == 0u) {
                                phi_3426_ = false;
                            } else {
                                let _e2760 = local_3.len;
                                local_3.len = (_e2760 - 1u);
                                let _e2763 = local_3.len;
                                if (_e2763 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2768 = local_3.first[(0u + _e2763)];
                                local_3.group = _e2768;
                                let _e2771 = local_3.len;
                                if (_e2771 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2776 = local_3.mask[(0u + _e2771)];
                                local_3.group_mask = _e2776;
                                phi_3426_ = true;
                            }
                            let _e2779 = phi_3426_;
                            phi_3427_ = _e2779;
                        } else {
                            phi_3427_ = true;
                        }
                        let _e2781 = phi_3427_;
                        if _e2781 {
                            let _e2783 = local_3.group_mask;
                            let _e2789 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2783)), 32u, (_e2783 == 0u)));
                            let _e2793 = local_3.group_mask;
                            let _e2807 = local_3.group_mask;
                            local_3.group_mask = (_e2807 & ~((1u << bitcast<u32>((_e2789 & 31u)))));
                            let _e2810 = local_3.group;
                            phi_3458_ = (_e2810 + countOneBits(((_e2793 & ~((4294967295u << bitcast<u32>((((_e2789 - 24u) ^ _e394) & 31u))))) & 255u)));
                        } else {
                            phi_3458_ = 4294967295u;
                        }
                        let _e2813 = phi_3458_;
                        phi_1168_ = _e2813;
                        let _e3877 = local_12;
                        phi_1171_ = _e3877;
                    } else {
                        phi_1168_ = u32();
                        phi_1171_ = lt_bvh_Hit();
                    }
                    let _e2815 = phi_1168_;
                    let _e2817 = phi_1171_;
                    continue;
                    continuing {
                        phi_1167_ = _e2815;
                        phi_1170_ = _e2817;
                        break if !(_e535);
                    }
                }
                let _e3880 = local_13;
                phi_3459_ = _e3880;
            }
            let _e2820 = phi_3459_;
            phi_3460_ = _e2820;
            phi_3461_ = _e234;
        } else {
            phi_3460_ = lt_bvh_Hit();
            phi_3461_ = true;
        }
        let _e2822 = phi_3460_;
        let _e2824 = phi_3461_;
        if _e2824 {
            phi_3465_ = _e164;
        } else {
            phi_3465_ = _e2822;
        }
        let _e2826 = phi_3465_;
        if (_e2826.triangle != 4294967295u) {
            let _e2832 = ((1f - _e2826.u) - _e2826.v);
            if (_e2826.triangle < _e81) {
            } else {
                return;
            }
            let _e2837 = triangles.member[(0u + _e2826.triangle)];
            if (_e2826.instance < _e93) {
            } else {
                return;
            }
            let _e2848 = instances.member[(0u + _e2826.instance)].object_to_world[0u];
            let _e2859 = ((((_e2848.x * _e2837.v0_.x) + (_e2848.y * _e2837.v0_.y)) + (_e2848.z * _e2837.v0_.z)) + (_e2848.w * 1f));
            let _e2861 = instances.member[(0u + _e2826.instance)].object_to_world[1u];
            let _e2872 = ((((_e2861.x * _e2837.v0_.x) + (_e2861.y * _e2837.v0_.y)) + (_e2861.z * _e2837.v0_.z)) + (_e2861.w * 1f));
            let _e2874 = instances.member[(0u + _e2826.instance)].object_to_world[2u];
            let _e2885 = ((((_e2874.x * _e2837.v0_.x) + (_e2874.y * _e2837.v0_.y)) + (_e2874.z * _e2837.v0_.z)) + (_e2874.w * 1f));
            let _e2892 = instances.member[(0u + _e2826.instance)].object_to_world[0u];
            let _e2903 = ((((_e2892.x * _e2837.v1_.x) + (_e2892.y * _e2837.v1_.y)) + (_e2892.z * _e2837.v1_.z)) + (_e2892.w * 1f));
            let _e2905 = instances.member[(0u + _e2826.instance)].object_to_world[1u];
            let _e2916 = ((((_e2905.x * _e2837.v1_.x) + (_e2905.y * _e2837.v1_.y)) + (_e2905.z * _e2837.v1_.z)) + (_e2905.w * 1f));
            let _e2918 = instances.member[(0u + _e2826.instance)].object_to_world[2u];
            let _e2929 = ((((_e2918.x * _e2837.v1_.x) + (_e2918.y * _e2837.v1_.y)) + (_e2918.z * _e2837.v1_.z)) + (_e2918.w * 1f));
            let _e2936 = instances.member[(0u + _e2826.instance)].object_to_world[0u];
            let _e2947 = ((((_e2936.x * _e2837.v2_.x) + (_e2936.y * _e2837.v2_.y)) + (_e2936.z * _e2837.v2_.z)) + (_e2936.w * 1f));
            let _e2949 = instances.member[(0u + _e2826.instance)].object_to_world[1u];
            let _e2960 = ((((_e2949.x * _e2837.v2_.x) + (_e2949.y * _e2837.v2_.y)) + (_e2949.z * _e2837.v2_.z)) + (_e2949.w * 1f));
            let _e2962 = instances.member[(0u + _e2826.instance)].object_to_world[2u];
            let _e2973 = ((((_e2962.x * _e2837.v2_.x) + (_e2962.y * _e2837.v2_.y)) + (_e2962.z * _e2837.v2_.z)) + (_e2962.w * 1f));
            let _e2986 = (((_e2859 * _e2832) + (_e2903 * _e2826.u)) + (_e2947 * _e2826.v));
            let _e2987 = (((_e2872 * _e2832) + (_e2916 * _e2826.u)) + (_e2960 * _e2826.v));
            let _e2988 = (((_e2885 * _e2832) + (_e2929 * _e2826.u)) + (_e2973 * _e2826.v));
            let _e2990 = abs(_e2859);
            let _e2991 = abs(_e2872);
            let _e2992 = abs(_e2885);
            let _e2993 = abs(_e2903);
            let _e2994 = abs(_e2916);
            let _e2995 = abs(_e2929);
            if (_e2990 > _e2993) {
                phi_3652_ = _e2990;
            } else {
                phi_3652_ = _e2993;
            }
            let _e2998 = phi_3652_;
            if (_e2991 > _e2994) {
                phi_3657_ = _e2991;
            } else {
                phi_3657_ = _e2994;
            }
            let _e3001 = phi_3657_;
            if (_e2992 > _e2995) {
                phi_3662_ = _e2992;
            } else {
                phi_3662_ = _e2995;
            }
            let _e3004 = phi_3662_;
            let _e3005 = abs(_e2947);
            let _e3006 = abs(_e2960);
            let _e3007 = abs(_e2973);
            if (_e2998 > _e3005) {
                phi_3670_ = _e2998;
            } else {
                phi_3670_ = _e3005;
            }
            let _e3010 = phi_3670_;
            if (_e3001 > _e3006) {
                phi_3675_ = _e3001;
            } else {
                phi_3675_ = _e3006;
            }
            let _e3013 = phi_3675_;
            if (_e3004 > _e3007) {
                phi_3680_ = _e3004;
            } else {
                phi_3680_ = _e3007;
            }
            let _e3016 = phi_3680_;
            let _e3017 = (_e2903 - _e2859);
            let _e3018 = (_e2916 - _e2872);
            let _e3019 = (_e2929 - _e2885);
            let _e3020 = (_e2947 - _e2859);
            let _e3021 = (_e2960 - _e2872);
            let _e3022 = (_e2973 - _e2885);
            let _e3026 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3018), abs(_e3019));
            let _e3027 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3017), _e3026);
            let _e3028 = (_e3017 / _e3027);
            let _e3029 = (_e3018 / _e3027);
            let _e3030 = (_e3019 / _e3027);
            let _e3034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3021), abs(_e3022));
            let _e3035 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3020), _e3034);
            let _e3036 = (_e3020 / _e3035);
            let _e3037 = (_e3021 / _e3035);
            let _e3038 = (_e3022 / _e3035);
            let _e3041 = ((_e3029 * _e3038) - (_e3037 * _e3030));
            let _e3044 = ((_e3030 * _e3036) - (_e3038 * _e3028));
            let _e3047 = ((_e3028 * _e3037) - (_e3036 * _e3029));
            let _e3049 = p.member.eye;
            let _e3062 = (1f / sqrt((((_e3041 * _e3041) + (_e3044 * _e3044)) + (_e3047 * _e3047))));
            let _e3063 = (_e3041 * _e3062);
            let _e3064 = (_e3044 * _e3062);
            let _e3065 = (_e3047 * _e3062);
            if ((((_e3063 * (_e3049.x - _e2986)) + (_e3064 * (_e3049.y - _e2987))) + (_e3065 * (_e3049.z - _e2988))) < 0f) {
                phi_3744_ = vec3<f32>(-(_e3063), -(_e3064), -(_e3065));
            } else {
                phi_3744_ = vec3<f32>(_e3063, _e3064, _e3065);
            }
            let _e3078 = phi_3744_;
            if (_e2826.triangle < _e81) {
            } else {
                return;
            }
            let _e3083 = triangles.member[(0u + _e2826.triangle)];
            let _e3085 = (_e3083.i0_ & 2147483647u);
            if (_e3085 < _e84) {
            } else {
                return;
            }
            let _e3091 = vertices.member[(0u + _e3085)];
            if (_e3083.i1_ < _e84) {
            } else {
                return;
            }
            let _e3095 = vertices.member[(0u + _e3083.i1_)];
            if (_e3083.i2_ < _e84) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3083.i2_)];
            let _e3100 = array<abi_Vertex, 3>(_e3091, _e3095, _e3099);
            if (_e3100[0].material < _e87) {
            } else {
                return;
            }
            let _e3106 = materials.member[(0u + _e3100[0].material)];
            let _e3123 = (1f / 255f);
            let _e3142 = (1f / 255f);
            let _e3164 = (1f / 255f);
            if (_e3106.color_size == 0u) {
                phi_3987_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3106.color_offset;
                local.size = _e3106.color_size;
                local.flags = _e3106.flags;
                let _e3207 = _lt_shaders_texture_TextureView_quad((&local), (((_e3100[0].u * _e2832) + (_e3100[1].u * _e2826.u)) + (_e3100[2].u * _e2826.v)), (((_e3100[0].v * _e2832) + (_e3100[1].v * _e2826.u)) + (_e3100[2].v * _e2826.v)));
                if (_e3207.indices[0] < _e99) {
                } else {
                    return;
                }
                let _e3213 = color_texels.member[(0u + _e3207.indices[0])];
                let _e3224 = (1f / 255f);
                if (_e3207.indices[1] < _e99) {
                } else {
                    return;
                }
                let _e3238 = color_texels.member[(0u + _e3207.indices[1])];
                let _e3249 = (1f / 255f);
                if (_e3207.indices[2] < _e99) {
                } else {
                    return;
                }
                let _e3266 = color_texels.member[(0u + _e3207.indices[2])];
                let _e3277 = (1f / 255f);
                if (_e3207.indices[3] < _e99) {
                } else {
                    return;
                }
                let _e3294 = color_texels.member[(0u + _e3207.indices[3])];
                let _e3305 = (1f / 255f);
                let _e3314 = (((((f32((_e3213 & 255u)) * _e3224) * _e3207.weights.x) + ((f32((_e3238 & 255u)) * _e3249) * _e3207.weights.y)) + ((f32((_e3266 & 255u)) * _e3277) * _e3207.weights.z)) + ((f32((_e3294 & 255u)) * _e3305) * _e3207.weights.w));
                let _e3315 = (((((f32(((_e3213 >> bitcast<u32>(8i)) & 255u)) * _e3224) * _e3207.weights.x) + ((f32(((_e3238 >> bitcast<u32>(8i)) & 255u)) * _e3249) * _e3207.weights.y)) + ((f32(((_e3266 >> bitcast<u32>(8i)) & 255u)) * _e3277) * _e3207.weights.z)) + ((f32(((_e3294 >> bitcast<u32>(8i)) & 255u)) * _e3305) * _e3207.weights.w));
                let _e3316 = (((((f32(((_e3213 >> bitcast<u32>(16i)) & 255u)) * _e3224) * _e3207.weights.x) + ((f32(((_e3238 >> bitcast<u32>(16i)) & 255u)) * _e3249) * _e3207.weights.y)) + ((f32(((_e3266 >> bitcast<u32>(16i)) & 255u)) * _e3277) * _e3207.weights.z)) + ((f32(((_e3294 >> bitcast<u32>(16i)) & 255u)) * _e3305) * _e3207.weights.w));
                phi_3987_ = vec3<f32>((_e3314 * _e3314), (_e3315 * _e3315), (_e3316 * _e3316));
            }
            let _e3322 = phi_3987_;
            let _e3324 = ((_e3106.base_color.x * ((((f32((_e3100[0].color & 255u)) * _e3123) * _e2832) + ((f32((_e3100[1].color & 255u)) * _e3142) * _e2826.u)) + ((f32((_e3100[2].color & 255u)) * _e3164) * _e2826.v))) * _e3322.x);
            let _e3326 = ((_e3106.base_color.y * ((((f32(((_e3100[0].color >> bitcast<u32>(8i)) & 255u)) * _e3123) * _e2832) + ((f32(((_e3100[1].color >> bitcast<u32>(8i)) & 255u)) * _e3142) * _e2826.u)) + ((f32(((_e3100[2].color >> bitcast<u32>(8i)) & 255u)) * _e3164) * _e2826.v))) * _e3322.y);
            let _e3328 = ((_e3106.base_color.z * ((((f32(((_e3100[0].color >> bitcast<u32>(16i)) & 255u)) * _e3123) * _e2832) + ((f32(((_e3100[1].color >> bitcast<u32>(16i)) & 255u)) * _e3142) * _e2826.u)) + ((f32(((_e3100[2].color >> bitcast<u32>(16i)) & 255u)) * _e3164) * _e2826.v))) * _e3322.z);
            let _e3329 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3013, _e3016);
            let _e3330 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3010, _e3329);
            if ((_e3106.flags & 2u) == 0u) {
                phi_4002_ = 0u;
            } else {
                phi_4002_ = 1u;
            }
            let _e3335 = phi_4002_;
            if (_e3100[0].normal == 2147516416u) {
                phi_4232_ = _e3078;
            } else {
                let _e3348 = (f32((bitcast<i32>((_e3100[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3354 = (f32((bitcast<i32>(_e3100[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3358 = ((1f - abs(_e3348)) - abs(_e3354));
                if (_e3358 < 0f) {
                    phi_4029_ = -(_e3358);
                } else {
                    phi_4029_ = 0f;
                }
                let _e3362 = phi_4029_;
                if (_e3348 < 0f) {
                    phi_4036_ = (_e3348 + _e3362);
                } else {
                    phi_4036_ = (_e3348 - _e3362);
                }
                let _e3367 = phi_4036_;
                if (_e3354 < 0f) {
                    phi_4043_ = (_e3354 + _e3362);
                } else {
                    phi_4043_ = (_e3354 - _e3362);
                }
                let _e3372 = phi_4043_;
                let _e3379 = (1f / sqrt((((_e3367 * _e3367) + (_e3372 * _e3372)) + (_e3358 * _e3358))));
                let _e3395 = (f32((bitcast<i32>((_e3100[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3401 = (f32((bitcast<i32>(_e3100[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3405 = ((1f - abs(_e3395)) - abs(_e3401));
                if (_e3405 < 0f) {
                    phi_4078_ = -(_e3405);
                } else {
                    phi_4078_ = 0f;
                }
                let _e3409 = phi_4078_;
                if (_e3395 < 0f) {
                    phi_4085_ = (_e3395 + _e3409);
                } else {
                    phi_4085_ = (_e3395 - _e3409);
                }
                let _e3414 = phi_4085_;
                if (_e3401 < 0f) {
                    phi_4092_ = (_e3401 + _e3409);
                } else {
                    phi_4092_ = (_e3401 - _e3409);
                }
                let _e3419 = phi_4092_;
                let _e3426 = (1f / sqrt((((_e3414 * _e3414) + (_e3419 * _e3419)) + (_e3405 * _e3405))));
                let _e3445 = (f32((bitcast<i32>((_e3100[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3451 = (f32((bitcast<i32>(_e3100[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3455 = ((1f - abs(_e3445)) - abs(_e3451));
                if (_e3455 < 0f) {
                    phi_4130_ = -(_e3455);
                } else {
                    phi_4130_ = 0f;
                }
                let _e3459 = phi_4130_;
                if (_e3445 < 0f) {
                    phi_4137_ = (_e3445 + _e3459);
                } else {
                    phi_4137_ = (_e3445 - _e3459);
                }
                let _e3464 = phi_4137_;
                if (_e3451 < 0f) {
                    phi_4144_ = (_e3451 + _e3459);
                } else {
                    phi_4144_ = (_e3451 - _e3459);
                }
                let _e3469 = phi_4144_;
                let _e3476 = (1f / sqrt((((_e3464 * _e3464) + (_e3469 * _e3469)) + (_e3455 * _e3455))));
                let _e3483 = ((((_e3367 * _e3379) * _e2832) + ((_e3414 * _e3426) * _e2826.u)) + ((_e3464 * _e3476) * _e2826.v));
                let _e3484 = ((((_e3372 * _e3379) * _e2832) + ((_e3419 * _e3426) * _e2826.u)) + ((_e3469 * _e3476) * _e2826.v));
                let _e3485 = ((((_e3358 * _e3379) * _e2832) + ((_e3405 * _e3426) * _e2826.u)) + ((_e3455 * _e3476) * _e2826.v));
                if (_e2826.instance < _e93) {
                } else {
                    return;
                }
                let _e3492 = instances.member[(0u + _e2826.instance)].world_to_object[0u];
                let _e3501 = instances.member[(0u + _e2826.instance)].world_to_object[1u];
                let _e3513 = instances.member[(0u + _e2826.instance)].world_to_object[2u];
                let _e3520 = (((_e3492.x * _e3483) + (_e3501.x * _e3484)) + (_e3513.x * _e3485));
                let _e3521 = (((_e3492.y * _e3483) + (_e3501.y * _e3484)) + (_e3513.y * _e3485));
                let _e3522 = (((_e3492.z * _e3483) + (_e3501.z * _e3484)) + (_e3513.z * _e3485));
                let _e3528 = sqrt((((_e3520 * _e3520) + (_e3521 * _e3521)) + (_e3522 * _e3522)));
                if (_e3528 > 0f) {
                    let _e3530 = (_e3520 / _e3528);
                    let _e3531 = (_e3521 / _e3528);
                    let _e3532 = (_e3522 / _e3528);
                    if ((((_e3530 * _e3078.x) + (_e3531 * _e3078.y)) + (_e3532 * _e3078.z)) < 0f) {
                        phi_4230_ = vec3<f32>(-(_e3530), -(_e3531), -(_e3532));
                    } else {
                        phi_4230_ = vec3<f32>(_e3530, _e3531, _e3532);
                    }
                    let _e3548 = phi_4230_;
                    phi_4231_ = _e3548;
                } else {
                    phi_4231_ = _e3078;
                }
                let _e3550 = phi_4231_;
                phi_4232_ = _e3550;
            }
            let _e3552 = phi_4232_;
            if (_e3324 > 0f) {
                if (_e3324 < 1f) {
                    phi_4241_ = _e3324;
                } else {
                    phi_4241_ = 1f;
                }
                let _e3556 = phi_4241_;
                phi_4242_ = _e3556;
            } else {
                phi_4242_ = 0f;
            }
            let _e3558 = phi_4242_;
            if (_e3326 > 0f) {
                if (_e3326 < 1f) {
                    phi_4252_ = _e3326;
                } else {
                    phi_4252_ = 1f;
                }
                let _e3563 = phi_4252_;
                phi_4253_ = _e3563;
            } else {
                phi_4253_ = 0f;
            }
            let _e3565 = phi_4253_;
            if (_e3328 > 0f) {
                if (_e3328 < 1f) {
                    phi_4263_ = _e3328;
                } else {
                    phi_4263_ = 1f;
                }
                let _e3570 = phi_4263_;
                phi_4264_ = _e3570;
            } else {
                phi_4264_ = 0f;
            }
            let _e3572 = phi_4264_;
            let _e3575 = ((sqrt(_e3558) * 255f) + 0.5f);
            let _e3584 = ((sqrt(_e3565) * 255f) + 0.5f);
            let _e3596 = ((sqrt(_e3572) * 255f) + 0.5f);
            phi_4299_ = abi_Sample(vec3<f32>(_e2986, _e2987, _e2988), _e3330, _e3078, _e3335, _e3552, ((select(select(u32(_e3575), 0u, (_e3575 < bitcast<f32>(0u))), 4294967295u, (_e3575 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3584), 0u, (_e3584 < bitcast<f32>(0u))), 4294967295u, (_e3584 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3596), 0u, (_e3596 < bitcast<f32>(0u))), 4294967295u, (_e3596 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4299_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3610 = phi_4299_;
        if (_e105.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e105.shift)] = _e3610;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
