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

struct type_26 {
    member: array<vec4<f32>>,
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

struct type_35 {
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

struct type_39 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_43 {
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

struct type_47 {
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

struct type_58 {
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
var<storage> vertices: type_43;
@group(0) @binding(4) 
var<storage> materials: type_47;
@group(0) @binding(0) 
var<uniform> p: type_58;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

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
        let _e85 = phi_222_;
        let _e87 = phi_223_;
        phi_224_ = _e85;
        phi_225_ = _e87;
    } else {
        phi_224_ = lt_mask_LightPlace();
        phi_225_ = true;
    }
    let _e89 = phi_224_;
    let _e91 = phi_225_;
    if _e91 {
        phi_230_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_230_ = _e89;
    }
    let _e96 = phi_230_;
    return lt_mask_LightPlace(_e96.word, _e96.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_245_: bool;
    var phi_249_: f32;

    if (param_3 != param_3) {
        phi_245_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_245_ = _e75;
    }
    let _e77 = phi_245_;
    if _e77 {
        phi_249_ = param_4;
    } else {
        phi_249_ = param_3;
    }
    let _e79 = phi_249_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_261_: bool;
    var phi_265_: f32;

    if (param_5 != param_5) {
        phi_261_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_261_ = _e75;
    }
    let _e77 = phi_261_;
    if _e77 {
        phi_265_ = param_6;
    } else {
        phi_265_ = param_5;
    }
    let _e79 = phi_265_;
    return _e79;
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

    let _e76 = (*param_7).size;
    let _e77 = (_e76 & 65535u);
    let _e79 = (*param_7).size;
    let _e81 = (_e79 >> bitcast<u32>(16i));
    let _e83 = (*param_7).flags;
    let _e85 = ((_e83 & 4u) != 0u);
    let _e87 = (*param_7).flags;
    let _e90 = ((_e87 >> bitcast<u32>(4u)) & 3u);
    if (_e90 == 0u) {
        if (param_8 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e103 > param_8) {
                phi_307_ = 1f;
            } else {
                phi_307_ = 0f;
            }
            let _e106 = phi_307_;
            if (param_8 < 8388608f) {
                phi_312_ = (_e103 - _e106);
                phi_313_ = false;
            } else {
                phi_312_ = f32();
                phi_313_ = true;
            }
            let _e109 = phi_312_;
            let _e111 = phi_313_;
            phi_314_ = _e109;
            phi_315_ = _e111;
        } else {
            phi_314_ = f32();
            phi_315_ = true;
        }
        let _e113 = phi_314_;
        let _e115 = phi_315_;
        if _e115 {
            phi_319_ = param_8;
        } else {
            phi_319_ = _e113;
        }
        let _e117 = phi_319_;
        phi_367_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_345_ = 1f;
                } else {
                    phi_345_ = 0f;
                }
                let _e135 = phi_345_;
                if (_e120 < 8388608f) {
                    phi_350_ = (_e132 - _e135);
                    phi_351_ = false;
                } else {
                    phi_350_ = f32();
                    phi_351_ = true;
                }
                let _e138 = phi_350_;
                let _e140 = phi_351_;
                phi_352_ = _e138;
                phi_353_ = _e140;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e142 = phi_352_;
            let _e144 = phi_353_;
            if _e144 {
                phi_357_ = _e120;
            } else {
                phi_357_ = _e142;
            }
            let _e146 = phi_357_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_365_ = (2f - _e148);
            } else {
                phi_365_ = _e148;
            }
            let _e152 = phi_365_;
            phi_366_ = _e152;
        } else {
            phi_366_ = param_8;
        }
        let _e154 = phi_366_;
        phi_367_ = _e154;
    }
    let _e156 = phi_367_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_376_ = _e156;
        } else {
            phi_376_ = 1f;
        }
        let _e160 = phi_376_;
        phi_377_ = _e160;
    } else {
        phi_377_ = 0f;
    }
    let _e162 = phi_377_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_395_ = _e163;
        } else {
            phi_395_ = _e172;
        }
        let _e175 = phi_395_;
        phi_434_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_409_ = _e77;
        } else {
            phi_409_ = _e184;
        }
        let _e187 = phi_409_;
        if (_e90 == 0u) {
            phi_416_ = _e163;
        } else {
            phi_416_ = 0u;
        }
        let _e192 = phi_416_;
        if (_e90 == 0u) {
            phi_421_ = 0u;
        } else {
            phi_421_ = _e163;
        }
        let _e195 = phi_421_;
        if (_e187 == 0u) {
            phi_427_ = _e192;
        } else {
            phi_427_ = (_e187 - 1u);
        }
        let _e199 = phi_427_;
        if (_e187 > _e163) {
            phi_432_ = _e195;
        } else {
            phi_432_ = _e187;
        }
        let _e202 = phi_432_;
        phi_434_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_434_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_462_ = 1f;
            } else {
                phi_462_ = 0f;
            }
            let _e226 = phi_462_;
            if (param_9 < 8388608f) {
                phi_467_ = (_e223 - _e226);
                phi_468_ = false;
            } else {
                phi_467_ = f32();
                phi_468_ = true;
            }
            let _e229 = phi_467_;
            let _e231 = phi_468_;
            phi_469_ = _e229;
            phi_470_ = _e231;
        } else {
            phi_469_ = f32();
            phi_470_ = true;
        }
        let _e233 = phi_469_;
        let _e235 = phi_470_;
        if _e235 {
            phi_474_ = param_9;
        } else {
            phi_474_ = _e233;
        }
        let _e237 = phi_474_;
        phi_522_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_500_ = 1f;
                } else {
                    phi_500_ = 0f;
                }
                let _e255 = phi_500_;
                if (_e240 < 8388608f) {
                    phi_505_ = (_e252 - _e255);
                    phi_506_ = false;
                } else {
                    phi_505_ = f32();
                    phi_506_ = true;
                }
                let _e258 = phi_505_;
                let _e260 = phi_506_;
                phi_507_ = _e258;
                phi_508_ = _e260;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e262 = phi_507_;
            let _e264 = phi_508_;
            if _e264 {
                phi_512_ = _e240;
            } else {
                phi_512_ = _e262;
            }
            let _e266 = phi_512_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_520_ = (2f - _e268);
            } else {
                phi_520_ = _e268;
            }
            let _e272 = phi_520_;
            phi_521_ = _e272;
        } else {
            phi_521_ = param_9;
        }
        let _e274 = phi_521_;
        phi_522_ = _e274;
    }
    let _e276 = phi_522_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_531_ = _e276;
        } else {
            phi_531_ = 1f;
        }
        let _e280 = phi_531_;
        phi_532_ = _e280;
    } else {
        phi_532_ = 0f;
    }
    let _e282 = phi_532_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_550_ = _e283;
        } else {
            phi_550_ = _e292;
        }
        let _e295 = phi_550_;
        phi_589_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_564_ = _e81;
        } else {
            phi_564_ = _e304;
        }
        let _e307 = phi_564_;
        if (_e210 == 0u) {
            phi_571_ = _e283;
        } else {
            phi_571_ = 0u;
        }
        let _e312 = phi_571_;
        if (_e210 == 0u) {
            phi_576_ = 0u;
        } else {
            phi_576_ = _e283;
        }
        let _e315 = phi_576_;
        if (_e307 == 0u) {
            phi_582_ = _e312;
        } else {
            phi_582_ = (_e307 - 1u);
        }
        let _e319 = phi_582_;
        if (_e307 > _e283) {
            phi_587_ = _e315;
        } else {
            phi_587_ = _e307;
        }
        let _e322 = phi_587_;
        phi_589_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_589_;
    let _e329 = (*param_7).offset;
    let _e336 = (*param_7).offset;
    let _e343 = (*param_7).offset;
    let _e350 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e329 + (_e325.low * _e77)) + _e205.low), ((_e336 + (_e325.low * _e77)) + _e205.high), ((_e343 + (_e325.high * _e77)) + _e205.low), ((_e350 + (_e325.high * _e77)) + _e205.high)), vec4<f32>(((1f - _e205.fraction) * (1f - _e325.fraction)), (_e205.fraction * (1f - _e325.fraction)), ((1f - _e205.fraction) * _e325.fraction), (_e205.fraction * _e325.fraction)));
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
    let _e76 = phi_648_;
    return _e76;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_790_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_810_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_837_: bool;
    var phi_913_: f32;
    var phi_920_: f32;
    var phi_928_: f32;
    var phi_935_: f32;
    var phi_943_: f32;
    var phi_950_: f32;
    var phi_973_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1033_: u32;
    var phi_1034_: u32;
    var phi_1051_: vec3<f32>;
    var phi_1052_: vec3<f32>;
    var phi_1065_: u32;
    var phi_1070_: u32;
    var phi_1075_: u32;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1221_: u32;
    var phi_1223_: lt_bvh_Hit;
    var phi_1226_: u32;
    var phi_1311_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1338_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1365_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1371_: u32;
    var phi_1374_: u32;
    var phi_1388_: u32;
    var phi_1398_: u32;
    var phi_1408_: u32;
    var phi_1426_: u32;
    var phi_1436_: u32;
    var phi_1446_: u32;
    var phi_1482_: u32;
    var phi_1495_: u32;
    var phi_1500_: u32;
    var phi_1501_: u32;
    var phi_1502_: u32;
    var phi_1372_: u32;
    var phi_1375_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1560_: lt_bvh_Hit;
    var phi_1563_: u32;
    var phi_1609_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1641_: vec3<f32>;
    var phi_1642_: vec3<f32>;
    var phi_1673_: vec3<f32>;
    var phi_1674_: vec3<f32>;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1708_: f32;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1734_: f32;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1752_: f32;
    var phi_1760_: f32;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1779_: f32;
    var phi_1780_: bool;
    var phi_1798_: f32;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1801_: f32;
    var phi_1802_: bool;
    var phi_1803_: bool;
    var phi_1807_: bool;
    var phi_1808_: f32;
    var phi_1809_: bool;
    var phi_1839_: vec3<f32>;
    var phi_1840_: vec3<f32>;
    var phi_1865_: vec3<f32>;
    var phi_1866_: vec3<f32>;
    var phi_1891_: vec3<f32>;
    var phi_1892_: vec3<f32>;
    var phi_1950_: f32;
    var phi_1959_: f32;
    var phi_1968_: f32;
    var phi_1977_: f32;
    var phi_1984_: f32;
    var phi_1991_: f32;
    var phi_2004_: f32;
    var phi_2013_: f32;
    var phi_2022_: f32;
    var phi_2031_: f32;
    var phi_2038_: f32;
    var phi_2045_: f32;
    var phi_2068_: f32;
    var phi_2073_: f32;
    var phi_2078_: f32;
    var phi_2086_: f32;
    var phi_2091_: f32;
    var phi_2096_: f32;
    var phi_2108_: f32;
    var phi_2113_: f32;
    var phi_2118_: f32;
    var phi_2123_: f32;
    var phi_2128_: lt_bvh_triangle_Intersection;
    var phi_2129_: bool;
    var phi_2130_: lt_bvh_triangle_Intersection;
    var phi_2131_: bool;
    var phi_2135_: lt_bvh_triangle_Intersection;
    var phi_2136_: bool;
    var phi_2137_: lt_bvh_triangle_Intersection;
    var phi_2138_: bool;
    var phi_2139_: bool;
    var phi_2143_: bool;
    var phi_2147_: lt_bvh_triangle_Intersection;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2399_: f32;
    var phi_2402_: bool;
    var phi_2403_: bool;
    var phi_2407_: bool;
    var phi_2415_: lt_bvh_Hit;
    var phi_2416_: lt_bvh_Hit;
    var phi_2417_: lt_bvh_Hit;
    var phi_2418_: lt_bvh_Hit;
    var phi_1561_: lt_bvh_Hit;
    var phi_1564_: u32;
    var phi_2419_: bool;
    var phi_2458_: bool;
    var phi_2459_: bool;
    var phi_2490_: u32;
    var phi_1224_: lt_bvh_Hit;
    var phi_1227_: u32;
    var phi_2491_: lt_bvh_Hit;
    var phi_2492_: lt_bvh_Hit;
    var phi_2493_: bool;
    var phi_2497_: lt_bvh_Hit;
    var phi_2561_: f32;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2582_: f32;
    var phi_2587_: f32;
    var phi_2592_: f32;
    var phi_2668_: vec3<f32>;
    var phi_2911_: vec3<f32>;
    var phi_2926_: u32;
    var phi_2953_: f32;
    var phi_2960_: f32;
    var phi_2967_: f32;
    var phi_3002_: f32;
    var phi_3009_: f32;
    var phi_3016_: f32;
    var phi_3054_: f32;
    var phi_3061_: f32;
    var phi_3068_: f32;
    var phi_3127_: vec3<f32>;
    var phi_3128_: vec3<f32>;
    var phi_3129_: vec3<f32>;
    var phi_3138_: f32;
    var phi_3139_: f32;
    var phi_3149_: f32;
    var phi_3150_: f32;
    var phi_3160_: f32;
    var phi_3161_: f32;
    var phi_3196_: abi_Sample;
    var phi_3287_: vec3<f32>;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&materials.member));
    let _e94 = arrayLength((&alpha_texels.member));
    let _e97 = arrayLength((&color_texels.member));
    let _e100 = arrayLength((&before.member));
    let _e106 = p.member.size[0u];
    let _e108 = p.member.size[1u];
    let _e109 = lt_shaders_entry_pixel_index(_e75, _e106, _e108);
    if (bitcast<i32>(_e109.word) != 0i) {
        let _e117 = p.member.eye;
        let _e122 = p.member.size[0u];
        let _e126 = ((((f32(_e75.x) + 0.5f) / f32(_e122)) * 2f) - 1f);
        let _e131 = p.member.size[1u];
        let _e135 = (1f - (((f32(_e75.y) + 0.5f) / f32(_e131)) * 2f));
        let _e137 = p.member.forward;
        let _e139 = p.member.right;
        let _e153 = p.member.up;
        let _e164 = _lt_bvh_ray_Ray_new(_e117, vec3<f32>(((_e137.x + (_e139.x * _e126)) + (_e153.x * _e135)), ((_e137.y + (_e139.y * _e126)) + (_e153.y * _e135)), ((_e137.z + (_e139.z * _e126)) + (_e153.z * _e135))));
        let _e166 = lt_bvh_Hit(_e164.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e169 = abs(_e164.direction.x);
        let _e171 = abs(_e164.direction.y);
        let _e173 = abs(_e164.direction.z);
        if (abs(_e164.origin.x) < 1000000000000000f) {
            if (abs(_e164.origin.y) < 1000000000000000f) {
                phi_783_ = (abs(_e164.origin.z) < 1000000000000000f);
                phi_784_ = false;
            } else {
                phi_783_ = bool();
                phi_784_ = true;
            }
            let _e185 = phi_783_;
            let _e187 = phi_784_;
            phi_785_ = _e185;
            phi_786_ = _e187;
        } else {
            phi_785_ = bool();
            phi_786_ = true;
        }
        let _e189 = phi_785_;
        let _e191 = phi_786_;
        if _e191 {
            phi_790_ = false;
        } else {
            phi_790_ = _e189;
        }
        let _e193 = phi_790_;
        if _e193 {
            if (_e169 < 1000000000000000f) {
                if (_e171 < 1000000000000000f) {
                    phi_803_ = (_e173 < 1000000000000000f);
                    phi_804_ = false;
                } else {
                    phi_803_ = bool();
                    phi_804_ = true;
                }
                let _e198 = phi_803_;
                let _e200 = phi_804_;
                phi_805_ = _e198;
                phi_806_ = _e200;
            } else {
                phi_805_ = bool();
                phi_806_ = true;
            }
            let _e202 = phi_805_;
            let _e204 = phi_806_;
            if _e204 {
                phi_810_ = false;
            } else {
                phi_810_ = _e202;
            }
            let _e206 = phi_810_;
            if _e206 {
                if (_e169 > 0f) {
                    phi_824_ = bool();
                    phi_825_ = true;
                } else {
                    let _e208 = (_e171 > 0f);
                    if _e208 {
                        phi_823_ = bool();
                    } else {
                        phi_823_ = (_e173 > 0f);
                    }
                    let _e211 = phi_823_;
                    phi_824_ = _e211;
                    phi_825_ = _e208;
                }
                let _e213 = phi_824_;
                let _e215 = phi_825_;
                if _e215 {
                    phi_829_ = true;
                } else {
                    phi_829_ = _e213;
                }
                let _e217 = phi_829_;
                phi_830_ = _e217;
                phi_831_ = false;
            } else {
                phi_830_ = bool();
                phi_831_ = true;
            }
            let _e219 = phi_830_;
            let _e221 = phi_831_;
            phi_832_ = _e219;
            phi_833_ = _e221;
        } else {
            phi_832_ = bool();
            phi_833_ = true;
        }
        let _e223 = phi_832_;
        let _e225 = phi_833_;
        if _e225 {
            phi_837_ = false;
        } else {
            phi_837_ = _e223;
        }
        let _e227 = phi_837_;
        if _e227 {
            let _e228 = (0u >= _e79);
            if _e228 {
                phi_2491_ = lt_bvh_Hit();
            } else {
                if (0u < _e79) {
                } else {
                    return;
                }
                let _e234 = nodes.member[(0u + 0u)].frame[0u];
                let _e238 = nodes.member[(0u + 0u)].frame[1u];
                let _e242 = nodes.member[(0u + 0u)].frame[2u];
                let _e246 = nodes.member[(0u + 0u)].frame[0u];
                let _e250 = nodes.member[(0u + 0u)].frame[1u];
                let _e254 = nodes.member[(0u + 0u)].frame[2u];
                let _e258 = nodes.member[(0u + 0u)].frame[3u];
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(abs(_e164.direction.x), abs(_e164.direction.y));
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(_e297, abs(_e164.direction.z));
                let _e299 = (_e298 * 0.0000000000009094947f);
                if (abs(_e164.direction.x) < _e299) {
                    phi_913_ = _e299;
                } else {
                    phi_913_ = abs(_e164.direction.x);
                }
                let _e305 = phi_913_;
                if (_e164.direction.x < 0f) {
                    phi_920_ = (-1f / _e305);
                } else {
                    phi_920_ = (1f / _e305);
                }
                let _e310 = phi_920_;
                if (abs(_e164.direction.y) < _e299) {
                    phi_928_ = _e299;
                } else {
                    phi_928_ = abs(_e164.direction.y);
                }
                let _e316 = phi_928_;
                if (_e164.direction.y < 0f) {
                    phi_935_ = (-1f / _e316);
                } else {
                    phi_935_ = (1f / _e316);
                }
                let _e321 = phi_935_;
                if (abs(_e164.direction.z) < _e299) {
                    phi_943_ = _e299;
                } else {
                    phi_943_ = abs(_e164.direction.z);
                }
                let _e327 = phi_943_;
                if (_e164.direction.z < 0f) {
                    phi_950_ = (-1f / _e327);
                } else {
                    phi_950_ = (1f / _e327);
                }
                let _e332 = phi_950_;
                let _e339 = abs((bitcast<f32>(_e234) - _e164.origin.x));
                let _e340 = abs((bitcast<f32>(_e238) - _e164.origin.y));
                let _e341 = abs((bitcast<f32>(_e242) - _e164.origin.z));
                let _e348 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e258 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.x));
                let _e349 = abs(((bitcast<f32>(_e250) + (bitcast<f32>((((_e258 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.y));
                let _e350 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e258 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.z));
                if (_e339 > _e348) {
                    phi_973_ = _e339;
                } else {
                    phi_973_ = _e348;
                }
                let _e353 = phi_973_;
                if (_e340 > _e349) {
                    phi_978_ = _e340;
                } else {
                    phi_978_ = _e349;
                }
                let _e356 = phi_978_;
                if (_e341 > _e350) {
                    phi_983_ = _e341;
                } else {
                    phi_983_ = _e350;
                }
                let _e359 = phi_983_;
                if (_e353 > _e356) {
                    phi_988_ = _e353;
                } else {
                    phi_988_ = _e356;
                }
                let _e362 = phi_988_;
                if (_e362 > _e359) {
                    phi_993_ = _e362;
                } else {
                    phi_993_ = _e359;
                }
                let _e365 = phi_993_;
                let _e369 = (_e365 * 0.0000019073486f);
                let _e370 = (abs(_e310) * _e369);
                let _e371 = (abs(_e321) * _e369);
                let _e372 = (abs(_e332) * _e369);
                let _e376 = (_e365 * 0.0000009536743f);
                let _e377 = (abs(_e310) * _e376);
                let _e378 = (abs(_e321) * _e376);
                let _e379 = (abs(_e332) * _e376);
                let _e383 = abs(_e164.direction.x);
                let _e385 = abs(_e164.direction.y);
                let _e387 = abs(_e164.direction.z);
                if (_e383 >= _e385) {
                    if (_e383 >= _e387) {
                        phi_1024_ = false;
                    } else {
                        phi_1024_ = true;
                    }
                    let _e391 = phi_1024_;
                    phi_1025_ = _e391;
                } else {
                    phi_1025_ = true;
                }
                let _e393 = phi_1025_;
                if _e393 {
                    if (_e385 >= _e387) {
                        phi_1033_ = 1u;
                    } else {
                        phi_1033_ = 2u;
                    }
                    let _e396 = phi_1033_;
                    phi_1034_ = _e396;
                } else {
                    phi_1034_ = 0u;
                }
                let _e398 = phi_1034_;
                if (_e398 == 0u) {
                    phi_1052_ = vec3<f32>(_e164.direction.y, _e164.direction.z, _e164.direction.x);
                } else {
                    if (_e398 == 1u) {
                        phi_1051_ = vec3<f32>(_e164.direction.z, _e164.direction.x, _e164.direction.y);
                    } else {
                        phi_1051_ = _e164.direction;
                    }
                    let _e410 = phi_1051_;
                    phi_1052_ = _e410;
                }
                let _e412 = phi_1052_;
                let _e415 = (_e412.x / _e412.z);
                let _e418 = (_e412.y / _e412.z);
                if (_e310 < 0f) {
                    phi_1065_ = 0u;
                } else {
                    phi_1065_ = 1u;
                }
                let _e423 = phi_1065_;
                if (_e321 < 0f) {
                    phi_1070_ = 0u;
                } else {
                    phi_1070_ = 2u;
                }
                let _e426 = phi_1070_;
                if (_e332 < 0f) {
                    phi_1075_ = 0u;
                } else {
                    phi_1075_ = 4u;
                }
                let _e429 = phi_1075_;
                let _e431 = ((_e423 | _e426) | _e429);
                let _e432 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e432.first[0], _e432.first[1], _e432.first[2], _e432.first[3], _e432.first[4], _e432.first[5], _e432.first[6], _e432.first[7], _e432.first[8], _e432.first[9], _e432.first[10], _e432.first[11], _e432.first[12], _e432.first[13], _e432.first[14], _e432.first[15], _e432.first[16], _e432.first[17], _e432.first[18], _e432.first[19], _e432.first[20], _e432.first[21], _e432.first[22], _e432.first[23], _e432.first[24], _e432.first[25], _e432.first[26], _e432.first[27], _e432.first[28], _e432.first[29], _e432.first[30], _e432.first[31]), array<u32, 32>(_e432.mask[0], _e432.mask[1], _e432.mask[2], _e432.mask[3], _e432.mask[4], _e432.mask[5], _e432.mask[6], _e432.mask[7], _e432.mask[8], _e432.mask[9], _e432.mask[10], _e432.mask[11], _e432.mask[12], _e432.mask[13], _e432.mask[14], _e432.mask[15], _e432.mask[16], _e432.mask[17], _e432.mask[18], _e432.mask[19], _e432.mask[20], _e432.mask[21], _e432.mask[22], _e432.mask[23], _e432.mask[24], _e432.mask[25], _e432.mask[26], _e432.mask[27], _e432.mask[28], _e432.mask[29], _e432.mask[30], _e432.mask[31]), _e432.len, _e432.group, _e432.group_mask);
                let _e506 = local_2.group_mask;
                if ((_e506 & 4278190080u) == 0u) {
                    let _e510 = local_2.len;
                    if (_e510 == 0u) {
                        phi_1189_ = false;
                    } else {
                        let _e514 = local_2.len;
                        local_2.len = (_e514 - 1u);
                        let _e517 = local_2.len;
                        if (_e517 < 32u) {
                        } else {
                            return;
                        }
                        let _e522 = local_2.first[(0u + _e517)];
                        local_2.group = _e522;
                        let _e525 = local_2.len;
                        if (_e525 < 32u) {
                        } else {
                            return;
                        }
                        let _e530 = local_2.mask[(0u + _e525)];
                        local_2.group_mask = _e530;
                        phi_1189_ = true;
                    }
                    let _e533 = phi_1189_;
                    phi_1190_ = _e533;
                } else {
                    phi_1190_ = true;
                }
                let _e535 = phi_1190_;
                if _e535 {
                    let _e537 = local_2.group_mask;
                    let _e543 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e537)), 32u, (_e537 == 0u)));
                    let _e547 = local_2.group_mask;
                    let _e561 = local_2.group_mask;
                    local_2.group_mask = (_e561 & ~((1u << bitcast<u32>((_e543 & 31u)))));
                    let _e564 = local_2.group;
                    phi_1221_ = (_e564 + countOneBits(((_e547 & ~((4294967295u << bitcast<u32>((((_e543 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1221_ = 4294967295u;
                }
                let _e567 = phi_1221_;
                phi_1223_ = _e166;
                phi_1226_ = _e567;
                loop {
                    let _e569 = phi_1223_;
                    let _e571 = phi_1226_;
                    local_7 = _e569;
                    let _e572 = (_e571 != 4294967295u);
                    if _e572 {
                        if (_e571 < _e79) {
                        } else {
                            return;
                        }
                        let _e580 = nodes.member[(0u + _e571)].frame[3u];
                        let _e605 = (bitcast<f32>((((_e580 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e606 = (bitcast<f32>((((_e580 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e607 = (bitcast<f32>((((_e580 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e610 = nodes.member[(0u + _e571)].frame[0u];
                        let _e614 = nodes.member[(0u + _e571)].frame[1u];
                        let _e618 = nodes.member[(0u + _e571)].frame[2u];
                        let _e626 = ((bitcast<f32>(_e610) - _e164.origin.x) * _e310);
                        let _e627 = ((bitcast<f32>(_e614) - _e164.origin.y) * _e321);
                        let _e628 = ((bitcast<f32>(_e618) - _e164.origin.z) * _e332);
                        let _e636 = nodes.member[(0u + _e571)].x;
                        if (_e310 < 0f) {
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e636.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e647.unnamed.word, _e636.w), _e647.unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e636.x, _e653.unnamed_1.shift));
                            phi_1311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_mask_LightPlace(_e659.unnamed_1.word, _e636.y));
                        } else {
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e636.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e675.unnamed.word, _e636.y), _e675.unnamed_1);
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_mask_LightPlace(_e636.z, _e681.unnamed_1.shift));
                            phi_1311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e687.unnamed, lt_mask_LightPlace(_e687.unnamed_1.word, _e636.w));
                        }
                        let _e695 = phi_1311_;
                        let _e705 = nodes.member[(0u + _e571)].y;
                        if (_e321 < 0f) {
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e705.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e716.unnamed.word, _e705.w), _e716.unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e705.x, _e722.unnamed_1.shift));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_mask_LightPlace(_e728.unnamed_1.word, _e705.y));
                        } else {
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e705.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e744.unnamed.word, _e705.y), _e744.unnamed_1);
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_mask_LightPlace(_e705.z, _e750.unnamed_1.shift));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e756.unnamed, lt_mask_LightPlace(_e756.unnamed_1.word, _e705.w));
                        }
                        let _e764 = phi_1338_;
                        let _e774 = nodes.member[(0u + _e571)].z;
                        if (_e332 < 0f) {
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e774.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e785.unnamed.word, _e774.w), _e785.unnamed_1);
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e774.x, _e791.unnamed_1.shift));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_mask_LightPlace(_e797.unnamed_1.word, _e774.y));
                        } else {
                            let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e774.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e813.unnamed.word, _e774.y), _e813.unnamed_1);
                            let _e825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_mask_LightPlace(_e774.z, _e819.unnamed_1.shift));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e825.unnamed, lt_mask_LightPlace(_e825.unnamed_1.word, _e774.w));
                        }
                        let _e833 = phi_1365_;
                        phi_1371_ = 0u;
                        phi_1374_ = 0u;
                        loop {
                            let _e843 = phi_1371_;
                            let _e845 = phi_1374_;
                            local_3 = _e845;
                            local_4 = _e845;
                            local_5 = _e845;
                            let _e846 = (_e843 < 8u);
                            if _e846 {
                                let _e848 = (_e843 >> bitcast<u32>(2i));
                                let _e849 = (_e843 & 3u);
                                if (_e848 == 0u) {
                                    phi_1388_ = _e695.unnamed.word;
                                } else {
                                    phi_1388_ = _e695.unnamed.shift;
                                }
                                let _e852 = phi_1388_;
                                if (_e848 == 0u) {
                                    phi_1398_ = _e764.unnamed.word;
                                } else {
                                    phi_1398_ = _e764.unnamed.shift;
                                }
                                let _e861 = phi_1398_;
                                if (_e848 == 0u) {
                                    phi_1408_ = _e833.unnamed.word;
                                } else {
                                    phi_1408_ = _e833.unnamed.shift;
                                }
                                let _e870 = phi_1408_;
                                let _e883 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e852 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e605) + (_e626 - _e370)), ((f32(((_e861 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e606) + (_e627 - _e371)));
                                let _e884 = core_intrinsics_maximum_number_nsz_f32_(_e883, ((f32(((_e870 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e607) + (_e628 - _e372)));
                                if (_e848 == 0u) {
                                    phi_1426_ = _e695.unnamed_1.word;
                                } else {
                                    phi_1426_ = _e695.unnamed_1.shift;
                                }
                                let _e887 = phi_1426_;
                                if (_e848 == 0u) {
                                    phi_1436_ = _e764.unnamed_1.word;
                                } else {
                                    phi_1436_ = _e764.unnamed_1.shift;
                                }
                                let _e896 = phi_1436_;
                                if (_e848 == 0u) {
                                    phi_1446_ = _e833.unnamed_1.word;
                                } else {
                                    phi_1446_ = _e833.unnamed_1.shift;
                                }
                                let _e905 = phi_1446_;
                                let _e918 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e887 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e605) + (_e626 + _e370)), ((f32(((_e896 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e606) + (_e627 + _e371)));
                                let _e919 = core_intrinsics_minimum_number_nsz_f32_(_e918, ((f32(((_e905 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e607) + (_e628 + _e372)));
                                if (_e884 <= _e919) {
                                    if (_e884 <= _e569.t) {
                                        if (_e919 >= _e164.tmin) {
                                            if (_e848 == 0u) {
                                                let _e926 = nodes.member[(0u + _e571)].links[2u];
                                                phi_1482_ = _e926;
                                            } else {
                                                let _e929 = nodes.member[(0u + _e571)].links[3u];
                                                phi_1482_ = _e929;
                                            }
                                            let _e931 = phi_1482_;
                                            let _e936 = ((_e931 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u);
                                            let _e937 = (_e936 & 31u);
                                            if (_e937 >= 24u) {
                                                phi_1495_ = (24u + ((_e937 - 24u) ^ _e431));
                                            } else {
                                                phi_1495_ = _e937;
                                            }
                                            let _e943 = phi_1495_;
                                            phi_1500_ = (_e845 | ((_e936 >> bitcast<u32>(5i)) << bitcast<u32>((_e943 & 31u))));
                                        } else {
                                            phi_1500_ = _e845;
                                        }
                                        let _e951 = phi_1500_;
                                        phi_1501_ = _e951;
                                    } else {
                                        phi_1501_ = _e845;
                                    }
                                    let _e953 = phi_1501_;
                                    phi_1502_ = _e953;
                                } else {
                                    phi_1502_ = _e845;
                                }
                                let _e955 = phi_1502_;
                                phi_1372_ = (_e843 + 1u);
                                phi_1375_ = _e955;
                            } else {
                                phi_1372_ = u32();
                                phi_1375_ = u32();
                            }
                            let _e958 = phi_1372_;
                            let _e960 = phi_1375_;
                            continue;
                            continuing {
                                phi_1371_ = _e958;
                                phi_1374_ = _e960;
                                break if !(_e846);
                            }
                        }
                        let _e964 = nodes.member[(0u + _e571)].links[0u];
                        let _e968 = nodes.member[(0u + _e571)].frame[3u];
                        let _e972 = local_3;
                        if ((_e972 & 4278190080u) == 0u) {
                        } else {
                            let _e976 = local_2.group_mask;
                            if ((_e976 & 4278190080u) == 0u) {
                            } else {
                                let _e980 = local_2.len;
                                if (_e980 < 32u) {
                                    let _e983 = local_2.group;
                                    let _e985 = local_2.len;
                                    if (_e985 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e985)] = _e983;
                                    let _e991 = local_2.group_mask;
                                    let _e993 = local_2.len;
                                    if (_e993 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e993)] = _e991;
                                    let _e1000 = local_2.len;
                                    local_2.len = (_e1000 + 1u);
                                }
                            }
                            local_2.group = (0u + _e964);
                            let _e1004 = local_4;
                            local_2.group_mask = ((_e1004 & 4278190080u) | (_e968 >> bitcast<u32>(24i)));
                        }
                        let _e1009 = local_5;
                        phi_1560_ = _e569;
                        phi_1563_ = (_e1009 & 16777215u);
                        loop {
                            let _e1012 = phi_1560_;
                            let _e1014 = phi_1563_;
                            local_6 = _e1012;
                            if (_e1014 == 0u) {
                                phi_1561_ = lt_bvh_Hit();
                                phi_1564_ = u32();
                                phi_2419_ = false;
                            } else {
                                let _e1018 = nodes.member[(0u + _e571)].links[1u];
                                let _e1023 = ((0u + _e1018) + select(firstTrailingBit(_e1014), 32u, (_e1014 == 0u)));
                                if (_e1023 < _e82) {
                                } else {
                                    return;
                                }
                                let _e1030 = triangles.member[(0u + _e1023)].v0_;
                                let _e1033 = (_e1030.x - _e164.origin.x);
                                let _e1036 = (_e1030.y - _e164.origin.y);
                                let _e1039 = (_e1030.z - _e164.origin.z);
                                if (_e398 == 0u) {
                                    phi_1610_ = vec3<f32>(_e1036, _e1039, _e1033);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1609_ = vec3<f32>(_e1039, _e1033, _e1036);
                                    } else {
                                        phi_1609_ = (_e1030 - _e164.origin);
                                    }
                                    let _e1046 = phi_1609_;
                                    phi_1610_ = _e1046;
                                }
                                let _e1048 = phi_1610_;
                                let _e1052 = (_e1048.x - (_e415 * _e1048.z));
                                let _e1056 = (_e1048.y - (_e418 * _e1048.z));
                                let _e1058 = triangles.member[(0u + _e1023)].v1_;
                                let _e1061 = (_e1058.x - _e164.origin.x);
                                let _e1064 = (_e1058.y - _e164.origin.y);
                                let _e1067 = (_e1058.z - _e164.origin.z);
                                if (_e398 == 0u) {
                                    phi_1642_ = vec3<f32>(_e1064, _e1067, _e1061);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1641_ = vec3<f32>(_e1067, _e1061, _e1064);
                                    } else {
                                        phi_1641_ = (_e1058 - _e164.origin);
                                    }
                                    let _e1074 = phi_1641_;
                                    phi_1642_ = _e1074;
                                }
                                let _e1076 = phi_1642_;
                                let _e1080 = (_e1076.x - (_e415 * _e1076.z));
                                let _e1084 = (_e1076.y - (_e418 * _e1076.z));
                                let _e1086 = triangles.member[(0u + _e1023)].v2_;
                                let _e1089 = (_e1086.x - _e164.origin.x);
                                let _e1092 = (_e1086.y - _e164.origin.y);
                                let _e1095 = (_e1086.z - _e164.origin.z);
                                if (_e398 == 0u) {
                                    phi_1674_ = vec3<f32>(_e1092, _e1095, _e1089);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1673_ = vec3<f32>(_e1095, _e1089, _e1092);
                                    } else {
                                        phi_1673_ = (_e1086 - _e164.origin);
                                    }
                                    let _e1102 = phi_1673_;
                                    phi_1674_ = _e1102;
                                }
                                let _e1104 = phi_1674_;
                                let _e1108 = (_e1104.x - (_e415 * _e1104.z));
                                let _e1112 = (_e1104.y - (_e418 * _e1104.z));
                                if (_e1080 < _e1108) {
                                    phi_1693_ = true;
                                } else {
                                    if (_e1080 == _e1108) {
                                        phi_1692_ = (_e1084 < _e1112);
                                    } else {
                                        phi_1692_ = false;
                                    }
                                    let _e1117 = phi_1692_;
                                    phi_1693_ = _e1117;
                                }
                                let _e1119 = phi_1693_;
                                if _e1119 {
                                    phi_1697_ = _e1112;
                                    phi_1698_ = _e1108;
                                    phi_1699_ = _e1084;
                                    phi_1700_ = _e1080;
                                } else {
                                    phi_1697_ = _e1084;
                                    phi_1698_ = _e1080;
                                    phi_1699_ = _e1112;
                                    phi_1700_ = _e1108;
                                }
                                let _e1121 = phi_1697_;
                                let _e1123 = phi_1698_;
                                let _e1125 = phi_1699_;
                                let _e1127 = phi_1700_;
                                let _e1130 = ((_e1127 * _e1121) - (_e1125 * _e1123));
                                if _e1119 {
                                    phi_1708_ = -(_e1130);
                                } else {
                                    phi_1708_ = _e1130;
                                }
                                let _e1133 = phi_1708_;
                                if (_e1108 < _e1052) {
                                    phi_1719_ = true;
                                } else {
                                    if (_e1108 == _e1052) {
                                        phi_1718_ = (_e1112 < _e1056);
                                    } else {
                                        phi_1718_ = false;
                                    }
                                    let _e1138 = phi_1718_;
                                    phi_1719_ = _e1138;
                                }
                                let _e1140 = phi_1719_;
                                if _e1140 {
                                    phi_1723_ = _e1056;
                                    phi_1724_ = _e1052;
                                    phi_1725_ = _e1112;
                                    phi_1726_ = _e1108;
                                } else {
                                    phi_1723_ = _e1112;
                                    phi_1724_ = _e1108;
                                    phi_1725_ = _e1056;
                                    phi_1726_ = _e1052;
                                }
                                let _e1142 = phi_1723_;
                                let _e1144 = phi_1724_;
                                let _e1146 = phi_1725_;
                                let _e1148 = phi_1726_;
                                let _e1151 = ((_e1148 * _e1142) - (_e1146 * _e1144));
                                if _e1140 {
                                    phi_1734_ = -(_e1151);
                                } else {
                                    phi_1734_ = _e1151;
                                }
                                let _e1154 = phi_1734_;
                                if (_e1052 < _e1080) {
                                    phi_1745_ = true;
                                } else {
                                    if (_e1052 == _e1080) {
                                        phi_1744_ = (_e1056 < _e1084);
                                    } else {
                                        phi_1744_ = false;
                                    }
                                    let _e1159 = phi_1744_;
                                    phi_1745_ = _e1159;
                                }
                                let _e1161 = phi_1745_;
                                if _e1161 {
                                    phi_1749_ = _e1084;
                                    phi_1750_ = _e1080;
                                    phi_1751_ = _e1056;
                                    phi_1752_ = _e1052;
                                } else {
                                    phi_1749_ = _e1056;
                                    phi_1750_ = _e1052;
                                    phi_1751_ = _e1084;
                                    phi_1752_ = _e1080;
                                }
                                let _e1163 = phi_1749_;
                                let _e1165 = phi_1750_;
                                let _e1167 = phi_1751_;
                                let _e1169 = phi_1752_;
                                let _e1172 = ((_e1169 * _e1163) - (_e1167 * _e1165));
                                if _e1161 {
                                    phi_1760_ = -(_e1172);
                                } else {
                                    phi_1760_ = _e1172;
                                }
                                let _e1175 = phi_1760_;
                                if (_e1133 >= 0f) {
                                    if (_e1154 >= 0f) {
                                        if (_e1175 >= 0f) {
                                            phi_1775_ = ((_e1133 + _e1154) + _e1175);
                                            phi_1776_ = false;
                                        } else {
                                            phi_1775_ = f32();
                                            phi_1776_ = true;
                                        }
                                        let _e1182 = phi_1775_;
                                        let _e1184 = phi_1776_;
                                        phi_1777_ = _e1182;
                                        phi_1778_ = _e1184;
                                    } else {
                                        phi_1777_ = f32();
                                        phi_1778_ = true;
                                    }
                                    let _e1186 = phi_1777_;
                                    let _e1188 = phi_1778_;
                                    phi_1779_ = _e1186;
                                    phi_1780_ = _e1188;
                                } else {
                                    phi_1779_ = f32();
                                    phi_1780_ = true;
                                }
                                let _e1190 = phi_1779_;
                                let _e1192 = phi_1780_;
                                if _e1192 {
                                    if (_e1133 <= 0f) {
                                        if (_e1154 <= 0f) {
                                            let _e1195 = (_e1175 <= 0f);
                                            if _e1195 {
                                            }
                                            phi_1798_ = ((_e1133 + _e1154) + _e1175);
                                            phi_1799_ = false;
                                            phi_1800_ = _e1195;
                                        } else {
                                            phi_1798_ = f32();
                                            phi_1799_ = true;
                                            phi_1800_ = false;
                                        }
                                        let _e1199 = phi_1798_;
                                        let _e1201 = phi_1799_;
                                        let _e1203 = phi_1800_;
                                        phi_1801_ = _e1199;
                                        phi_1802_ = _e1201;
                                        phi_1803_ = _e1203;
                                    } else {
                                        phi_1801_ = f32();
                                        phi_1802_ = true;
                                        phi_1803_ = false;
                                    }
                                    let _e1205 = phi_1801_;
                                    let _e1207 = phi_1802_;
                                    let _e1209 = phi_1803_;
                                    if _e1207 {
                                        phi_1807_ = false;
                                    } else {
                                        phi_1807_ = _e1209;
                                    }
                                    let _e1211 = phi_1807_;
                                    phi_1808_ = _e1205;
                                    phi_1809_ = _e1211;
                                } else {
                                    phi_1808_ = _e1190;
                                    phi_1809_ = true;
                                }
                                let _e1213 = phi_1808_;
                                let _e1215 = phi_1809_;
                                if _e1215 {
                                    let _e1216 = (_e1213 == 0f);
                                    if _e1216 {
                                        phi_2135_ = lt_bvh_triangle_Intersection();
                                        phi_2136_ = false;
                                    } else {
                                        let _e1218 = triangles.member[(0u + _e1023)].v0_;
                                        let _e1221 = (_e1218.x - _e164.origin.x);
                                        let _e1224 = (_e1218.y - _e164.origin.y);
                                        let _e1227 = (_e1218.z - _e164.origin.z);
                                        if (_e398 == 0u) {
                                            phi_1840_ = vec3<f32>(_e1224, _e1227, _e1221);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1839_ = vec3<f32>(_e1227, _e1221, _e1224);
                                            } else {
                                                phi_1839_ = (_e1218 - _e164.origin);
                                            }
                                            let _e1234 = phi_1839_;
                                            phi_1840_ = _e1234;
                                        }
                                        let _e1236 = phi_1840_;
                                        let _e1238 = triangles.member[(0u + _e1023)].v1_;
                                        let _e1240 = triangles.member[(0u + _e1023)].v0_;
                                        let _e1243 = (_e1238.x - _e1240.x);
                                        let _e1246 = (_e1238.y - _e1240.y);
                                        let _e1249 = (_e1238.z - _e1240.z);
                                        if (_e398 == 0u) {
                                            phi_1866_ = vec3<f32>(_e1246, _e1249, _e1243);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1865_ = vec3<f32>(_e1249, _e1243, _e1246);
                                            } else {
                                                phi_1865_ = (_e1238 - _e1240);
                                            }
                                            let _e1256 = phi_1865_;
                                            phi_1866_ = _e1256;
                                        }
                                        let _e1258 = phi_1866_;
                                        let _e1260 = triangles.member[(0u + _e1023)].v2_;
                                        let _e1262 = triangles.member[(0u + _e1023)].v0_;
                                        let _e1265 = (_e1260.x - _e1262.x);
                                        let _e1268 = (_e1260.y - _e1262.y);
                                        let _e1271 = (_e1260.z - _e1262.z);
                                        if (_e398 == 0u) {
                                            phi_1892_ = vec3<f32>(_e1268, _e1271, _e1265);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1891_ = vec3<f32>(_e1271, _e1265, _e1268);
                                            } else {
                                                phi_1891_ = (_e1260 - _e1262);
                                            }
                                            let _e1278 = phi_1891_;
                                            phi_1892_ = _e1278;
                                        }
                                        let _e1280 = phi_1892_;
                                        let _e1287 = ((_e1258.y * _e1280.z) - (_e1258.z * _e1280.y));
                                        let _e1294 = ((_e1258.z * _e1280.x) - (_e1258.x * _e1280.z));
                                        let _e1301 = ((_e1258.x * _e1280.y) - (_e1258.y * _e1280.x));
                                        let _e1315 = (((1f / _e412.z) * (((_e1287 * _e1236.x) + (_e1294 * _e1236.y)) + (_e1301 * _e1236.z))) / (((_e1287 * _e415) + (_e1294 * _e418)) + _e1301));
                                        if (_e1315 > _e164.tmin) {
                                            if (_e1315 < _e164.tmax) {
                                                let _e1321 = triangles.member[(0u + _e1023)].v0_;
                                                let _e1323 = triangles.member[(0u + _e1023)].v1_;
                                                if (_e1321.x < _e1323.x) {
                                                    phi_1950_ = _e1321.x;
                                                } else {
                                                    phi_1950_ = _e1323.x;
                                                }
                                                let _e1330 = phi_1950_;
                                                if (_e1321.y < _e1323.y) {
                                                    phi_1959_ = _e1321.y;
                                                } else {
                                                    phi_1959_ = _e1323.y;
                                                }
                                                let _e1337 = phi_1959_;
                                                if (_e1321.z < _e1323.z) {
                                                    phi_1968_ = _e1321.z;
                                                } else {
                                                    phi_1968_ = _e1323.z;
                                                }
                                                let _e1344 = phi_1968_;
                                                let _e1346 = triangles.member[(0u + _e1023)].v2_;
                                                if (_e1330 < _e1346.x) {
                                                    phi_1977_ = _e1330;
                                                } else {
                                                    phi_1977_ = _e1346.x;
                                                }
                                                let _e1351 = phi_1977_;
                                                if (_e1337 < _e1346.y) {
                                                    phi_1984_ = _e1337;
                                                } else {
                                                    phi_1984_ = _e1346.y;
                                                }
                                                let _e1356 = phi_1984_;
                                                if (_e1344 < _e1346.z) {
                                                    phi_1991_ = _e1344;
                                                } else {
                                                    phi_1991_ = _e1346.z;
                                                }
                                                let _e1361 = phi_1991_;
                                                let _e1363 = triangles.member[(0u + _e1023)].v0_;
                                                let _e1365 = triangles.member[(0u + _e1023)].v1_;
                                                if (_e1363.x > _e1365.x) {
                                                    phi_2004_ = _e1363.x;
                                                } else {
                                                    phi_2004_ = _e1365.x;
                                                }
                                                let _e1372 = phi_2004_;
                                                if (_e1363.y > _e1365.y) {
                                                    phi_2013_ = _e1363.y;
                                                } else {
                                                    phi_2013_ = _e1365.y;
                                                }
                                                let _e1379 = phi_2013_;
                                                if (_e1363.z > _e1365.z) {
                                                    phi_2022_ = _e1363.z;
                                                } else {
                                                    phi_2022_ = _e1365.z;
                                                }
                                                let _e1386 = phi_2022_;
                                                let _e1388 = triangles.member[(0u + _e1023)].v2_;
                                                if (_e1372 > _e1388.x) {
                                                    phi_2031_ = _e1372;
                                                } else {
                                                    phi_2031_ = _e1388.x;
                                                }
                                                let _e1393 = phi_2031_;
                                                if (_e1379 > _e1388.y) {
                                                    phi_2038_ = _e1379;
                                                } else {
                                                    phi_2038_ = _e1388.y;
                                                }
                                                let _e1398 = phi_2038_;
                                                if (_e1386 > _e1388.z) {
                                                    phi_2045_ = _e1386;
                                                } else {
                                                    phi_2045_ = _e1388.z;
                                                }
                                                let _e1403 = phi_2045_;
                                                let _e1410 = ((_e1351 - _e164.origin.x) * _e310);
                                                let _e1411 = ((_e1356 - _e164.origin.y) * _e321);
                                                let _e1412 = ((_e1361 - _e164.origin.z) * _e332);
                                                let _e1419 = ((_e1393 - _e164.origin.x) * _e310);
                                                let _e1420 = ((_e1398 - _e164.origin.y) * _e321);
                                                let _e1421 = ((_e1403 - _e164.origin.z) * _e332);
                                                if (_e1410 < _e1419) {
                                                    phi_2068_ = _e1410;
                                                } else {
                                                    phi_2068_ = _e1419;
                                                }
                                                let _e1424 = phi_2068_;
                                                if (_e1411 < _e1420) {
                                                    phi_2073_ = _e1411;
                                                } else {
                                                    phi_2073_ = _e1420;
                                                }
                                                let _e1427 = phi_2073_;
                                                if (_e1412 < _e1421) {
                                                    phi_2078_ = _e1412;
                                                } else {
                                                    phi_2078_ = _e1421;
                                                }
                                                let _e1430 = phi_2078_;
                                                if (_e1410 > _e1419) {
                                                    phi_2086_ = _e1410;
                                                } else {
                                                    phi_2086_ = _e1419;
                                                }
                                                let _e1436 = phi_2086_;
                                                if (_e1411 > _e1420) {
                                                    phi_2091_ = _e1411;
                                                } else {
                                                    phi_2091_ = _e1420;
                                                }
                                                let _e1439 = phi_2091_;
                                                if (_e1412 > _e1421) {
                                                    phi_2096_ = _e1412;
                                                } else {
                                                    phi_2096_ = _e1421;
                                                }
                                                let _e1442 = phi_2096_;
                                                let _e1446 = core_intrinsics_maximum_number_nsz_f32_((_e1424 - _e377), (_e1427 - _e378));
                                                let _e1447 = core_intrinsics_maximum_number_nsz_f32_(_e1446, (_e1430 - _e379));
                                                let _e1448 = core_intrinsics_minimum_number_nsz_f32_((_e1436 + _e377), (_e1439 + _e378));
                                                let _e1449 = core_intrinsics_minimum_number_nsz_f32_(_e1448, (_e1442 + _e379));
                                                if (_e1447 > -300000000000000000000000000000000000000f) {
                                                    phi_2108_ = _e1447;
                                                } else {
                                                    phi_2108_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1452 = phi_2108_;
                                                if (_e1449 < 300000000000000000000000000000000000000f) {
                                                    phi_2113_ = _e1449;
                                                } else {
                                                    phi_2113_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1455 = phi_2113_;
                                                if (_e1315 < _e1452) {
                                                    phi_2118_ = _e1452;
                                                } else {
                                                    phi_2118_ = _e1315;
                                                }
                                                let _e1458 = phi_2118_;
                                                if (_e1458 > _e1455) {
                                                    phi_2123_ = _e1455;
                                                } else {
                                                    phi_2123_ = _e1458;
                                                }
                                                let _e1461 = phi_2123_;
                                                phi_2128_ = lt_bvh_triangle_Intersection(_e1461, (_e1154 / _e1213), (_e1175 / _e1213), (_e1452 <= _e1455));
                                                phi_2129_ = false;
                                            } else {
                                                phi_2128_ = lt_bvh_triangle_Intersection();
                                                phi_2129_ = true;
                                            }
                                            let _e1467 = phi_2128_;
                                            let _e1469 = phi_2129_;
                                            phi_2130_ = _e1467;
                                            phi_2131_ = _e1469;
                                        } else {
                                            phi_2130_ = lt_bvh_triangle_Intersection();
                                            phi_2131_ = true;
                                        }
                                        let _e1471 = phi_2130_;
                                        let _e1473 = phi_2131_;
                                        if _e1473 {
                                        }
                                        phi_2135_ = _e1471;
                                        phi_2136_ = _e1473;
                                    }
                                    let _e1475 = phi_2135_;
                                    let _e1477 = phi_2136_;
                                    phi_2137_ = _e1475;
                                    phi_2138_ = _e1216;
                                    phi_2139_ = _e1477;
                                } else {
                                    phi_2137_ = lt_bvh_triangle_Intersection();
                                    phi_2138_ = true;
                                    phi_2139_ = false;
                                }
                                let _e1479 = phi_2137_;
                                let _e1481 = phi_2138_;
                                let _e1483 = phi_2139_;
                                if _e1481 {
                                    phi_2143_ = true;
                                } else {
                                    phi_2143_ = _e1483;
                                }
                                let _e1485 = phi_2143_;
                                if _e1485 {
                                    phi_2147_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2147_ = _e1479;
                                }
                                let _e1487 = phi_2147_;
                                if _e1487.is_hit {
                                    if (_e1487.t > _e164.tmin) {
                                        if (_e1487.t < _e1012.t) {
                                            phi_2196_ = true;
                                        } else {
                                            if (_e1487.t == _e1012.t) {
                                                if (_e1012.triangle != 4294967295u) {
                                                    if (_e1023 < _e1012.triangle) {
                                                        phi_2187_ = true;
                                                    } else {
                                                        if (_e1023 == _e1012.triangle) {
                                                            phi_2186_ = (4294967295u < _e1012.instance);
                                                        } else {
                                                            phi_2186_ = false;
                                                        }
                                                        let _e1506 = phi_2186_;
                                                        phi_2187_ = _e1506;
                                                    }
                                                    let _e1508 = phi_2187_;
                                                    phi_2188_ = _e1508;
                                                    phi_2189_ = false;
                                                } else {
                                                    phi_2188_ = bool();
                                                    phi_2189_ = true;
                                                }
                                                let _e1510 = phi_2188_;
                                                let _e1512 = phi_2189_;
                                                phi_2190_ = _e1510;
                                                phi_2191_ = _e1512;
                                            } else {
                                                phi_2190_ = bool();
                                                phi_2191_ = true;
                                            }
                                            let _e1514 = phi_2190_;
                                            let _e1516 = phi_2191_;
                                            if _e1516 {
                                                phi_2195_ = false;
                                            } else {
                                                phi_2195_ = _e1514;
                                            }
                                            let _e1518 = phi_2195_;
                                            phi_2196_ = _e1518;
                                        }
                                        let _e1520 = phi_2196_;
                                        if _e1520 {
                                            let _e1522 = triangles.member[(0u + _e1023)].i0_;
                                            if ((_e1522 & 2147483648u) == 0u) {
                                                phi_2407_ = true;
                                            } else {
                                                if (_e1023 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1531 = triangles.member[(0u + _e1023)].i0_;
                                                let _e1532 = (_e1531 & 2147483647u);
                                                let _e1534 = triangles.member[(0u + _e1023)].i1_;
                                                let _e1536 = triangles.member[(0u + _e1023)].i2_;
                                                if (_e1532 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1540 = vertices.member[(0u + _e1532)];
                                                if (_e1534 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1544 = vertices.member[(0u + _e1534)];
                                                if (_e1536 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1548 = vertices.member[(0u + _e1536)];
                                                let _e1549 = array<abi_Vertex, 3>(_e1540, _e1544, _e1548);
                                                if (_e1549[0].material < _e88) {
                                                } else {
                                                    return;
                                                }
                                                let _e1555 = materials.member[(0u + _e1549[0].material)];
                                                if ((_e1555.flags & 0u) == 0u) {
                                                    let _e1560 = ((1f - _e1487.u) - _e1487.v);
                                                    if (_e1555.cutoff <= 0f) {
                                                        phi_2402_ = true;
                                                    } else {
                                                        let _e1587 = (_e1555.base_color.w * ((((f32((_e1549[0].color >> bitcast<u32>(24i))) * _e1560) + (f32((_e1549[1].color >> bitcast<u32>(24i))) * _e1487.u)) + (f32((_e1549[2].color >> bitcast<u32>(24i))) * _e1487.v)) * (1f / 255f)));
                                                        if (_e1555.alpha_size == 0u) {
                                                            phi_2399_ = _e1587;
                                                        } else {
                                                            local_1.offset = _e1555.alpha_offset;
                                                            local_1.size = _e1555.alpha_size;
                                                            local_1.flags = _e1555.flags;
                                                            let _e1618 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1549[0].u * _e1560) + (_e1549[1].u * _e1487.u)) + (_e1549[2].u * _e1487.v)), (((_e1549[0].v * _e1560) + (_e1549[1].v * _e1487.u)) + (_e1549[2].v * _e1487.v)));
                                                            let _e1622 = (_e1618.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1622 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1626 = alpha_texels.member[(0u + _e1622)];
                                                            let _e1642 = (_e1618.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1642 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1646 = alpha_texels.member[(0u + _e1642)];
                                                            let _e1663 = (_e1618.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1663 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1667 = alpha_texels.member[(0u + _e1663)];
                                                            let _e1684 = (_e1618.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1684 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1688 = alpha_texels.member[(0u + _e1684)];
                                                            phi_2399_ = (_e1587 * (((((f32(((_e1626 >> bitcast<u32>((((_e1618.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1618.weights.x) + ((f32(((_e1646 >> bitcast<u32>((((_e1618.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1618.weights.y)) + ((f32(((_e1667 >> bitcast<u32>((((_e1618.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1618.weights.z)) + ((f32(((_e1688 >> bitcast<u32>((((_e1618.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1618.weights.w)));
                                                        }
                                                        let _e1704 = phi_2399_;
                                                        phi_2402_ = (_e1704 >= _e1555.cutoff);
                                                    }
                                                    let _e1708 = phi_2402_;
                                                    phi_2403_ = _e1708;
                                                } else {
                                                    phi_2403_ = false;
                                                }
                                                let _e1710 = phi_2403_;
                                                if _e1710 {
                                                }
                                                phi_2407_ = _e1710;
                                            }
                                            let _e1712 = phi_2407_;
                                            if _e1712 {
                                                phi_2415_ = lt_bvh_Hit(_e1487.t, _e1487.u, _e1487.v, _e1023, 4294967295u);
                                            } else {
                                                phi_2415_ = _e1012;
                                            }
                                            let _e1718 = phi_2415_;
                                            phi_2416_ = _e1718;
                                        } else {
                                            phi_2416_ = _e1012;
                                        }
                                        let _e1720 = phi_2416_;
                                        phi_2417_ = _e1720;
                                    } else {
                                        phi_2417_ = _e1012;
                                    }
                                    let _e1722 = phi_2417_;
                                    phi_2418_ = _e1722;
                                } else {
                                    phi_2418_ = _e1012;
                                }
                                let _e1724 = phi_2418_;
                                phi_1561_ = _e1724;
                                phi_1564_ = (_e1014 & (_e1014 - 1u));
                                phi_2419_ = true;
                            }
                            let _e1726 = phi_1561_;
                            let _e1728 = phi_1564_;
                            let _e1730 = phi_2419_;
                            continue;
                            continuing {
                                phi_1560_ = _e1726;
                                phi_1563_ = _e1728;
                                break if !(_e1730);
                            }
                        }
                        let _e1733 = local_2.group_mask;
                        if ((_e1733 & 4278190080u) == 0u) {
                            let _e1737 = local_2.len;
                            if (_e1737 == 0u) {
                                phi_2458_ = false;
                            } else {
                                let _e1741 = local_2.len;
                                local_2.len = (_e1741 - 1u);
                                let _e1744 = local_2.len;
                                if (_e1744 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1749 = local_2.first[(0u + _e1744)];
                                local_2.group = _e1749;
                                let _e1752 = local_2.len;
                                if (_e1752 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1757 = local_2.mask[(0u + _e1752)];
                                local_2.group_mask = _e1757;
                                phi_2458_ = true;
                            }
                            let _e1760 = phi_2458_;
                            phi_2459_ = _e1760;
                        } else {
                            phi_2459_ = true;
                        }
                        let _e1762 = phi_2459_;
                        if _e1762 {
                            let _e1764 = local_2.group_mask;
                            let _e1770 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1764)), 32u, (_e1764 == 0u)));
                            let _e1774 = local_2.group_mask;
                            let _e1788 = local_2.group_mask;
                            local_2.group_mask = (_e1788 & ~((1u << bitcast<u32>((_e1770 & 31u)))));
                            let _e1791 = local_2.group;
                            phi_2490_ = (_e1791 + countOneBits(((_e1774 & ~((4294967295u << bitcast<u32>((((_e1770 - 24u) ^ _e431) & 31u))))) & 255u)));
                        } else {
                            phi_2490_ = 4294967295u;
                        }
                        let _e1794 = phi_2490_;
                        let _e2715 = local_6;
                        phi_1224_ = _e2715;
                        phi_1227_ = _e1794;
                    } else {
                        phi_1224_ = lt_bvh_Hit();
                        phi_1227_ = u32();
                    }
                    let _e1796 = phi_1224_;
                    let _e1798 = phi_1227_;
                    continue;
                    continuing {
                        phi_1223_ = _e1796;
                        phi_1226_ = _e1798;
                        break if !(_e572);
                    }
                }
                let _e2719 = local_7;
                phi_2491_ = _e2719;
            }
            let _e1801 = phi_2491_;
            phi_2492_ = _e1801;
            phi_2493_ = _e228;
        } else {
            phi_2492_ = lt_bvh_Hit();
            phi_2493_ = true;
        }
        let _e1803 = phi_2492_;
        let _e1805 = phi_2493_;
        if _e1805 {
            phi_2497_ = _e166;
        } else {
            phi_2497_ = _e1803;
        }
        let _e1807 = phi_2497_;
        if (_e1807.triangle != 4294967295u) {
            let _e1813 = ((1f - _e1807.u) - _e1807.v);
            if (_e1807.triangle < _e82) {
            } else {
                return;
            }
            let _e1818 = triangles.member[(0u + _e1807.triangle)];
            let _e1843 = (((_e1818.v0_.x * _e1813) + (_e1818.v1_.x * _e1807.u)) + (_e1818.v2_.x * _e1807.v));
            let _e1844 = (((_e1818.v0_.y * _e1813) + (_e1818.v1_.y * _e1807.u)) + (_e1818.v2_.y * _e1807.v));
            let _e1845 = (((_e1818.v0_.z * _e1813) + (_e1818.v1_.z * _e1807.u)) + (_e1818.v2_.z * _e1807.v));
            let _e1848 = abs(_e1818.v0_.x);
            let _e1850 = abs(_e1818.v0_.y);
            let _e1852 = abs(_e1818.v0_.z);
            let _e1854 = abs(_e1818.v1_.x);
            let _e1856 = abs(_e1818.v1_.y);
            let _e1858 = abs(_e1818.v1_.z);
            if (_e1848 > _e1854) {
                phi_2561_ = _e1848;
            } else {
                phi_2561_ = _e1854;
            }
            let _e1861 = phi_2561_;
            if (_e1850 > _e1856) {
                phi_2566_ = _e1850;
            } else {
                phi_2566_ = _e1856;
            }
            let _e1864 = phi_2566_;
            if (_e1852 > _e1858) {
                phi_2571_ = _e1852;
            } else {
                phi_2571_ = _e1858;
            }
            let _e1867 = phi_2571_;
            let _e1869 = abs(_e1818.v2_.x);
            let _e1871 = abs(_e1818.v2_.y);
            let _e1873 = abs(_e1818.v2_.z);
            if (_e1861 > _e1869) {
                phi_2582_ = _e1861;
            } else {
                phi_2582_ = _e1869;
            }
            let _e1876 = phi_2582_;
            if (_e1864 > _e1871) {
                phi_2587_ = _e1864;
            } else {
                phi_2587_ = _e1871;
            }
            let _e1879 = phi_2587_;
            if (_e1867 > _e1873) {
                phi_2592_ = _e1867;
            } else {
                phi_2592_ = _e1873;
            }
            let _e1882 = phi_2592_;
            let _e1885 = (_e1818.v1_.x - _e1818.v0_.x);
            let _e1888 = (_e1818.v1_.y - _e1818.v0_.y);
            let _e1891 = (_e1818.v1_.z - _e1818.v0_.z);
            let _e1894 = (_e1818.v2_.x - _e1818.v0_.x);
            let _e1897 = (_e1818.v2_.y - _e1818.v0_.y);
            let _e1900 = (_e1818.v2_.z - _e1818.v0_.z);
            let _e1904 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1888), abs(_e1891));
            let _e1905 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1885), _e1904);
            let _e1906 = (_e1885 / _e1905);
            let _e1907 = (_e1888 / _e1905);
            let _e1908 = (_e1891 / _e1905);
            let _e1912 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1897), abs(_e1900));
            let _e1913 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1894), _e1912);
            let _e1914 = (_e1894 / _e1913);
            let _e1915 = (_e1897 / _e1913);
            let _e1916 = (_e1900 / _e1913);
            let _e1919 = ((_e1907 * _e1916) - (_e1915 * _e1908));
            let _e1922 = ((_e1908 * _e1914) - (_e1916 * _e1906));
            let _e1925 = ((_e1906 * _e1915) - (_e1914 * _e1907));
            let _e1927 = p.member.eye;
            let _e1940 = (1f / sqrt((((_e1919 * _e1919) + (_e1922 * _e1922)) + (_e1925 * _e1925))));
            let _e1941 = (_e1919 * _e1940);
            let _e1942 = (_e1922 * _e1940);
            let _e1943 = (_e1925 * _e1940);
            if ((((_e1941 * (_e1927.x - _e1843)) + (_e1942 * (_e1927.y - _e1844))) + (_e1943 * (_e1927.z - _e1845))) < 0f) {
                phi_2668_ = vec3<f32>(-(_e1941), -(_e1942), -(_e1943));
            } else {
                phi_2668_ = vec3<f32>(_e1941, _e1942, _e1943);
            }
            let _e1956 = phi_2668_;
            if (_e1807.triangle < _e82) {
            } else {
                return;
            }
            let _e1961 = triangles.member[(0u + _e1807.triangle)];
            let _e1963 = (_e1961.i0_ & 2147483647u);
            if (_e1963 < _e85) {
            } else {
                return;
            }
            let _e1969 = vertices.member[(0u + _e1963)];
            if (_e1961.i1_ < _e85) {
            } else {
                return;
            }
            let _e1973 = vertices.member[(0u + _e1961.i1_)];
            if (_e1961.i2_ < _e85) {
            } else {
                return;
            }
            let _e1977 = vertices.member[(0u + _e1961.i2_)];
            let _e1978 = array<abi_Vertex, 3>(_e1969, _e1973, _e1977);
            if (_e1978[0].material < _e88) {
            } else {
                return;
            }
            let _e1984 = materials.member[(0u + _e1978[0].material)];
            let _e2001 = (1f / 255f);
            let _e2020 = (1f / 255f);
            let _e2042 = (1f / 255f);
            if (_e1984.color_size == 0u) {
                phi_2911_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1984.color_offset;
                local.size = _e1984.color_size;
                local.flags = _e1984.flags;
                let _e2085 = _lt_shaders_texture_TextureView_quad((&local), (((_e1978[0].u * _e1813) + (_e1978[1].u * _e1807.u)) + (_e1978[2].u * _e1807.v)), (((_e1978[0].v * _e1813) + (_e1978[1].v * _e1807.u)) + (_e1978[2].v * _e1807.v)));
                if (_e2085.indices[0] < _e97) {
                } else {
                    return;
                }
                let _e2091 = color_texels.member[(0u + _e2085.indices[0])];
                let _e2102 = (1f / 255f);
                if (_e2085.indices[1] < _e97) {
                } else {
                    return;
                }
                let _e2116 = color_texels.member[(0u + _e2085.indices[1])];
                let _e2127 = (1f / 255f);
                if (_e2085.indices[2] < _e97) {
                } else {
                    return;
                }
                let _e2144 = color_texels.member[(0u + _e2085.indices[2])];
                let _e2155 = (1f / 255f);
                if (_e2085.indices[3] < _e97) {
                } else {
                    return;
                }
                let _e2172 = color_texels.member[(0u + _e2085.indices[3])];
                let _e2183 = (1f / 255f);
                let _e2192 = (((((f32((_e2091 & 255u)) * _e2102) * _e2085.weights.x) + ((f32((_e2116 & 255u)) * _e2127) * _e2085.weights.y)) + ((f32((_e2144 & 255u)) * _e2155) * _e2085.weights.z)) + ((f32((_e2172 & 255u)) * _e2183) * _e2085.weights.w));
                let _e2193 = (((((f32(((_e2091 >> bitcast<u32>(8i)) & 255u)) * _e2102) * _e2085.weights.x) + ((f32(((_e2116 >> bitcast<u32>(8i)) & 255u)) * _e2127) * _e2085.weights.y)) + ((f32(((_e2144 >> bitcast<u32>(8i)) & 255u)) * _e2155) * _e2085.weights.z)) + ((f32(((_e2172 >> bitcast<u32>(8i)) & 255u)) * _e2183) * _e2085.weights.w));
                let _e2194 = (((((f32(((_e2091 >> bitcast<u32>(16i)) & 255u)) * _e2102) * _e2085.weights.x) + ((f32(((_e2116 >> bitcast<u32>(16i)) & 255u)) * _e2127) * _e2085.weights.y)) + ((f32(((_e2144 >> bitcast<u32>(16i)) & 255u)) * _e2155) * _e2085.weights.z)) + ((f32(((_e2172 >> bitcast<u32>(16i)) & 255u)) * _e2183) * _e2085.weights.w));
                phi_2911_ = vec3<f32>((_e2192 * _e2192), (_e2193 * _e2193), (_e2194 * _e2194));
            }
            let _e2200 = phi_2911_;
            let _e2202 = ((_e1984.base_color.x * ((((f32((_e1978[0].color & 255u)) * _e2001) * _e1813) + ((f32((_e1978[1].color & 255u)) * _e2020) * _e1807.u)) + ((f32((_e1978[2].color & 255u)) * _e2042) * _e1807.v))) * _e2200.x);
            let _e2204 = ((_e1984.base_color.y * ((((f32(((_e1978[0].color >> bitcast<u32>(8i)) & 255u)) * _e2001) * _e1813) + ((f32(((_e1978[1].color >> bitcast<u32>(8i)) & 255u)) * _e2020) * _e1807.u)) + ((f32(((_e1978[2].color >> bitcast<u32>(8i)) & 255u)) * _e2042) * _e1807.v))) * _e2200.y);
            let _e2206 = ((_e1984.base_color.z * ((((f32(((_e1978[0].color >> bitcast<u32>(16i)) & 255u)) * _e2001) * _e1813) + ((f32(((_e1978[1].color >> bitcast<u32>(16i)) & 255u)) * _e2020) * _e1807.u)) + ((f32(((_e1978[2].color >> bitcast<u32>(16i)) & 255u)) * _e2042) * _e1807.v))) * _e2200.z);
            let _e2207 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1879, _e1882);
            let _e2208 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1876, _e2207);
            if ((_e1984.flags & 2u) == 0u) {
                phi_2926_ = 0u;
            } else {
                phi_2926_ = 1u;
            }
            let _e2213 = phi_2926_;
            if (_e1978[0].normal == 2147516416u) {
                phi_3129_ = _e1956;
            } else {
                let _e2226 = (f32((bitcast<i32>((_e1978[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2232 = (f32((bitcast<i32>(_e1978[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2236 = ((1f - abs(_e2226)) - abs(_e2232));
                if (_e2236 < 0f) {
                    phi_2953_ = -(_e2236);
                } else {
                    phi_2953_ = 0f;
                }
                let _e2240 = phi_2953_;
                if (_e2226 < 0f) {
                    phi_2960_ = (_e2226 + _e2240);
                } else {
                    phi_2960_ = (_e2226 - _e2240);
                }
                let _e2245 = phi_2960_;
                if (_e2232 < 0f) {
                    phi_2967_ = (_e2232 + _e2240);
                } else {
                    phi_2967_ = (_e2232 - _e2240);
                }
                let _e2250 = phi_2967_;
                let _e2257 = (1f / sqrt((((_e2245 * _e2245) + (_e2250 * _e2250)) + (_e2236 * _e2236))));
                let _e2273 = (f32((bitcast<i32>((_e1978[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2279 = (f32((bitcast<i32>(_e1978[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2283 = ((1f - abs(_e2273)) - abs(_e2279));
                if (_e2283 < 0f) {
                    phi_3002_ = -(_e2283);
                } else {
                    phi_3002_ = 0f;
                }
                let _e2287 = phi_3002_;
                if (_e2273 < 0f) {
                    phi_3009_ = (_e2273 + _e2287);
                } else {
                    phi_3009_ = (_e2273 - _e2287);
                }
                let _e2292 = phi_3009_;
                if (_e2279 < 0f) {
                    phi_3016_ = (_e2279 + _e2287);
                } else {
                    phi_3016_ = (_e2279 - _e2287);
                }
                let _e2297 = phi_3016_;
                let _e2304 = (1f / sqrt((((_e2292 * _e2292) + (_e2297 * _e2297)) + (_e2283 * _e2283))));
                let _e2323 = (f32((bitcast<i32>((_e1978[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2329 = (f32((bitcast<i32>(_e1978[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2333 = ((1f - abs(_e2323)) - abs(_e2329));
                if (_e2333 < 0f) {
                    phi_3054_ = -(_e2333);
                } else {
                    phi_3054_ = 0f;
                }
                let _e2337 = phi_3054_;
                if (_e2323 < 0f) {
                    phi_3061_ = (_e2323 + _e2337);
                } else {
                    phi_3061_ = (_e2323 - _e2337);
                }
                let _e2342 = phi_3061_;
                if (_e2329 < 0f) {
                    phi_3068_ = (_e2329 + _e2337);
                } else {
                    phi_3068_ = (_e2329 - _e2337);
                }
                let _e2347 = phi_3068_;
                let _e2354 = (1f / sqrt((((_e2342 * _e2342) + (_e2347 * _e2347)) + (_e2333 * _e2333))));
                let _e2365 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2245 * _e2257) * _e1813) + ((_e2292 * _e2304) * _e1807.u)) + ((_e2342 * _e2354) * _e1807.v)), ((((_e2250 * _e2257) * _e1813) + ((_e2297 * _e2304) * _e1807.u)) + ((_e2347 * _e2354) * _e1807.v)), ((((_e2236 * _e2257) * _e1813) + ((_e2283 * _e2304) * _e1807.u)) + ((_e2333 * _e2354) * _e1807.v))));
                let _e2377 = sqrt((((_e2365.x * _e2365.x) + (_e2365.y * _e2365.y)) + (_e2365.z * _e2365.z)));
                if (_e2377 > 0f) {
                    let _e2380 = (_e2365.x / _e2377);
                    let _e2382 = (_e2365.y / _e2377);
                    let _e2384 = (_e2365.z / _e2377);
                    if ((((_e2380 * _e1956.x) + (_e2382 * _e1956.y)) + (_e2384 * _e1956.z)) < 0f) {
                        phi_3127_ = vec3<f32>(-(_e2380), -(_e2382), -(_e2384));
                    } else {
                        phi_3127_ = (_e2365 / vec3(_e2377));
                    }
                    let _e2401 = phi_3127_;
                    phi_3128_ = _e2401;
                } else {
                    phi_3128_ = _e1956;
                }
                let _e2403 = phi_3128_;
                phi_3129_ = _e2403;
            }
            let _e2405 = phi_3129_;
            if (_e2202 > 0f) {
                if (_e2202 < 1f) {
                    phi_3138_ = _e2202;
                } else {
                    phi_3138_ = 1f;
                }
                let _e2409 = phi_3138_;
                phi_3139_ = _e2409;
            } else {
                phi_3139_ = 0f;
            }
            let _e2411 = phi_3139_;
            if (_e2204 > 0f) {
                if (_e2204 < 1f) {
                    phi_3149_ = _e2204;
                } else {
                    phi_3149_ = 1f;
                }
                let _e2416 = phi_3149_;
                phi_3150_ = _e2416;
            } else {
                phi_3150_ = 0f;
            }
            let _e2418 = phi_3150_;
            if (_e2206 > 0f) {
                if (_e2206 < 1f) {
                    phi_3160_ = _e2206;
                } else {
                    phi_3160_ = 1f;
                }
                let _e2423 = phi_3160_;
                phi_3161_ = _e2423;
            } else {
                phi_3161_ = 0f;
            }
            let _e2425 = phi_3161_;
            let _e2428 = ((sqrt(_e2411) * 255f) + 0.5f);
            let _e2437 = ((sqrt(_e2418) * 255f) + 0.5f);
            let _e2449 = ((sqrt(_e2425) * 255f) + 0.5f);
            phi_3196_ = abi_Sample(vec3<f32>(_e1843, _e1844, _e1845), _e2208, _e1956, _e2213, _e2405, ((select(select(u32(_e2428), 0u, (_e2428 < bitcast<f32>(0u))), 4294967295u, (_e2428 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2437), 0u, (_e2437 < bitcast<f32>(0u))), 4294967295u, (_e2437 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2449), 0u, (_e2449 < bitcast<f32>(0u))), 4294967295u, (_e2449 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3196_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2463 = phi_3196_;
        if (_e109.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.shift)] = _e2463;
        if (_e1807.triangle != 4294967295u) {
            let _e2472 = ((1f - _e1807.u) - _e1807.v);
            if (_e1807.triangle < _e82) {
            } else {
                return;
            }
            let _e2477 = triangles.member[(0u + _e1807.triangle)];
            let _e2479 = (_e2477.i0_ & 2147483647u);
            if (_e2479 < _e100) {
            } else {
                return;
            }
            let _e2485 = before.member[(0u + _e2479)];
            if (_e2477.i1_ < _e100) {
            } else {
                return;
            }
            let _e2489 = before.member[(0u + _e2477.i1_)];
            if (_e2477.i2_ < _e100) {
            } else {
                return;
            }
            let _e2493 = before.member[(0u + _e2477.i2_)];
            let _e2498 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2485.x, _e2485.y, _e2485.z));
            let _e2509 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2489.x, _e2489.y, _e2489.z));
            let _e2523 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2493.x, _e2493.y, _e2493.z));
            phi_3287_ = vec3<f32>((((_e2498.x * _e2472) + (_e2509.x * _e1807.u)) + (_e2523.x * _e1807.v)), (((_e2498.y * _e2472) + (_e2509.y * _e1807.u)) + (_e2523.y * _e1807.v)), (((_e2498.z * _e2472) + (_e2509.z * _e1807.u)) + (_e2523.z * _e1807.v)));
        } else {
            phi_3287_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2535 = phi_3287_;
        if (_e109.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.shift)] = vec4<f32>(_e2535.x, _e2535.y, _e2535.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
