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
var<storage> before: type_26;
@group(0) @binding(8) 
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
        let _e84 = phi_222_;
        let _e86 = phi_223_;
        phi_224_ = _e84;
        phi_225_ = _e86;
    } else {
        phi_224_ = lt_mask_LightPlace();
        phi_225_ = true;
    }
    let _e88 = phi_224_;
    let _e90 = phi_225_;
    if _e90 {
        phi_230_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_230_ = _e88;
    }
    let _e95 = phi_230_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_245_: bool;
    var phi_249_: f32;

    if (param_3 != param_3) {
        phi_245_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_245_ = _e74;
    }
    let _e76 = phi_245_;
    if _e76 {
        phi_249_ = param_4;
    } else {
        phi_249_ = param_3;
    }
    let _e78 = phi_249_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_261_: bool;
    var phi_265_: f32;

    if (param_5 != param_5) {
        phi_261_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_261_ = _e74;
    }
    let _e76 = phi_261_;
    if _e76 {
        phi_265_ = param_6;
    } else {
        phi_265_ = param_5;
    }
    let _e78 = phi_265_;
    return _e78;
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

    let _e75 = (*param_7).size;
    let _e76 = (_e75 & 65535u);
    let _e78 = (*param_7).size;
    let _e80 = (_e78 >> bitcast<u32>(16i));
    let _e82 = (*param_7).flags;
    let _e84 = ((_e82 & 4u) != 0u);
    let _e86 = (*param_7).flags;
    let _e89 = ((_e86 >> bitcast<u32>(4u)) & 3u);
    if (_e89 == 0u) {
        if (param_8 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e102 > param_8) {
                phi_307_ = 1f;
            } else {
                phi_307_ = 0f;
            }
            let _e105 = phi_307_;
            if (param_8 < 8388608f) {
                phi_312_ = (_e102 - _e105);
                phi_313_ = false;
            } else {
                phi_312_ = f32();
                phi_313_ = true;
            }
            let _e108 = phi_312_;
            let _e110 = phi_313_;
            phi_314_ = _e108;
            phi_315_ = _e110;
        } else {
            phi_314_ = f32();
            phi_315_ = true;
        }
        let _e112 = phi_314_;
        let _e114 = phi_315_;
        if _e114 {
            phi_319_ = param_8;
        } else {
            phi_319_ = _e112;
        }
        let _e116 = phi_319_;
        phi_367_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_345_ = 1f;
                } else {
                    phi_345_ = 0f;
                }
                let _e134 = phi_345_;
                if (_e119 < 8388608f) {
                    phi_350_ = (_e131 - _e134);
                    phi_351_ = false;
                } else {
                    phi_350_ = f32();
                    phi_351_ = true;
                }
                let _e137 = phi_350_;
                let _e139 = phi_351_;
                phi_352_ = _e137;
                phi_353_ = _e139;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e141 = phi_352_;
            let _e143 = phi_353_;
            if _e143 {
                phi_357_ = _e119;
            } else {
                phi_357_ = _e141;
            }
            let _e145 = phi_357_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_365_ = (2f - _e147);
            } else {
                phi_365_ = _e147;
            }
            let _e151 = phi_365_;
            phi_366_ = _e151;
        } else {
            phi_366_ = param_8;
        }
        let _e153 = phi_366_;
        phi_367_ = _e153;
    }
    let _e155 = phi_367_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_376_ = _e155;
        } else {
            phi_376_ = 1f;
        }
        let _e159 = phi_376_;
        phi_377_ = _e159;
    } else {
        phi_377_ = 0f;
    }
    let _e161 = phi_377_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_395_ = _e162;
        } else {
            phi_395_ = _e171;
        }
        let _e174 = phi_395_;
        phi_434_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_409_ = _e76;
        } else {
            phi_409_ = _e183;
        }
        let _e186 = phi_409_;
        if (_e89 == 0u) {
            phi_416_ = _e162;
        } else {
            phi_416_ = 0u;
        }
        let _e191 = phi_416_;
        if (_e89 == 0u) {
            phi_421_ = 0u;
        } else {
            phi_421_ = _e162;
        }
        let _e194 = phi_421_;
        if (_e186 == 0u) {
            phi_427_ = _e191;
        } else {
            phi_427_ = (_e186 - 1u);
        }
        let _e198 = phi_427_;
        if (_e186 > _e162) {
            phi_432_ = _e194;
        } else {
            phi_432_ = _e186;
        }
        let _e201 = phi_432_;
        phi_434_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_434_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_462_ = 1f;
            } else {
                phi_462_ = 0f;
            }
            let _e225 = phi_462_;
            if (param_9 < 8388608f) {
                phi_467_ = (_e222 - _e225);
                phi_468_ = false;
            } else {
                phi_467_ = f32();
                phi_468_ = true;
            }
            let _e228 = phi_467_;
            let _e230 = phi_468_;
            phi_469_ = _e228;
            phi_470_ = _e230;
        } else {
            phi_469_ = f32();
            phi_470_ = true;
        }
        let _e232 = phi_469_;
        let _e234 = phi_470_;
        if _e234 {
            phi_474_ = param_9;
        } else {
            phi_474_ = _e232;
        }
        let _e236 = phi_474_;
        phi_522_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_500_ = 1f;
                } else {
                    phi_500_ = 0f;
                }
                let _e254 = phi_500_;
                if (_e239 < 8388608f) {
                    phi_505_ = (_e251 - _e254);
                    phi_506_ = false;
                } else {
                    phi_505_ = f32();
                    phi_506_ = true;
                }
                let _e257 = phi_505_;
                let _e259 = phi_506_;
                phi_507_ = _e257;
                phi_508_ = _e259;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e261 = phi_507_;
            let _e263 = phi_508_;
            if _e263 {
                phi_512_ = _e239;
            } else {
                phi_512_ = _e261;
            }
            let _e265 = phi_512_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_520_ = (2f - _e267);
            } else {
                phi_520_ = _e267;
            }
            let _e271 = phi_520_;
            phi_521_ = _e271;
        } else {
            phi_521_ = param_9;
        }
        let _e273 = phi_521_;
        phi_522_ = _e273;
    }
    let _e275 = phi_522_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_531_ = _e275;
        } else {
            phi_531_ = 1f;
        }
        let _e279 = phi_531_;
        phi_532_ = _e279;
    } else {
        phi_532_ = 0f;
    }
    let _e281 = phi_532_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_550_ = _e282;
        } else {
            phi_550_ = _e291;
        }
        let _e294 = phi_550_;
        phi_589_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_564_ = _e80;
        } else {
            phi_564_ = _e303;
        }
        let _e306 = phi_564_;
        if (_e209 == 0u) {
            phi_571_ = _e282;
        } else {
            phi_571_ = 0u;
        }
        let _e311 = phi_571_;
        if (_e209 == 0u) {
            phi_576_ = 0u;
        } else {
            phi_576_ = _e282;
        }
        let _e314 = phi_576_;
        if (_e306 == 0u) {
            phi_582_ = _e311;
        } else {
            phi_582_ = (_e306 - 1u);
        }
        let _e318 = phi_582_;
        if (_e306 > _e282) {
            phi_587_ = _e314;
        } else {
            phi_587_ = _e306;
        }
        let _e321 = phi_587_;
        phi_589_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_589_;
    let _e328 = (*param_7).offset;
    let _e335 = (*param_7).offset;
    let _e342 = (*param_7).offset;
    let _e349 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e328 + (_e324.low * _e76)) + _e204.low), ((_e335 + (_e324.low * _e76)) + _e204.high), ((_e342 + (_e324.high * _e76)) + _e204.low), ((_e349 + (_e324.high * _e76)) + _e204.high)), vec4<f32>(((1f - _e204.fraction) * (1f - _e324.fraction)), (_e204.fraction * (1f - _e324.fraction)), ((1f - _e204.fraction) * _e324.fraction), (_e204.fraction * _e324.fraction)));
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
    let _e75 = phi_648_;
    return _e75;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_16: vec3<f32>) -> vec3<f32> {
    return param_16;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_809_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_912_: f32;
    var phi_919_: f32;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1032_: u32;
    var phi_1033_: u32;
    var phi_1050_: vec3<f32>;
    var phi_1051_: vec3<f32>;
    var phi_1064_: u32;
    var phi_1069_: u32;
    var phi_1074_: u32;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1220_: u32;
    var phi_1222_: lt_bvh_Hit;
    var phi_1225_: u32;
    var phi_1310_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1337_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1364_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1370_: u32;
    var phi_1373_: u32;
    var phi_1387_: u32;
    var phi_1397_: u32;
    var phi_1407_: u32;
    var phi_1425_: u32;
    var phi_1435_: u32;
    var phi_1445_: u32;
    var phi_1481_: u32;
    var phi_1494_: u32;
    var phi_1499_: u32;
    var phi_1500_: u32;
    var phi_1501_: u32;
    var phi_1371_: u32;
    var phi_1374_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1559_: lt_bvh_Hit;
    var phi_1562_: u32;
    var phi_1608_: vec3<f32>;
    var phi_1609_: vec3<f32>;
    var phi_1640_: vec3<f32>;
    var phi_1641_: vec3<f32>;
    var phi_1672_: vec3<f32>;
    var phi_1673_: vec3<f32>;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1696_: f32;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1707_: f32;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1722_: f32;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1733_: f32;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1748_: f32;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1759_: f32;
    var phi_1774_: f32;
    var phi_1775_: bool;
    var phi_1776_: f32;
    var phi_1777_: bool;
    var phi_1778_: f32;
    var phi_1779_: bool;
    var phi_1797_: f32;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1800_: f32;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var phi_1806_: bool;
    var phi_1807_: f32;
    var phi_1808_: bool;
    var phi_1838_: vec3<f32>;
    var phi_1839_: vec3<f32>;
    var phi_1864_: vec3<f32>;
    var phi_1865_: vec3<f32>;
    var phi_1890_: vec3<f32>;
    var phi_1891_: vec3<f32>;
    var phi_1949_: f32;
    var phi_1958_: f32;
    var phi_1967_: f32;
    var phi_1976_: f32;
    var phi_1983_: f32;
    var phi_1990_: f32;
    var phi_2003_: f32;
    var phi_2012_: f32;
    var phi_2021_: f32;
    var phi_2030_: f32;
    var phi_2037_: f32;
    var phi_2044_: f32;
    var phi_2067_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2085_: f32;
    var phi_2090_: f32;
    var phi_2095_: f32;
    var phi_2107_: f32;
    var phi_2112_: f32;
    var phi_2117_: f32;
    var phi_2122_: f32;
    var phi_2127_: lt_bvh_triangle_Intersection;
    var phi_2128_: bool;
    var phi_2129_: lt_bvh_triangle_Intersection;
    var phi_2130_: bool;
    var phi_2134_: lt_bvh_triangle_Intersection;
    var phi_2135_: bool;
    var phi_2136_: lt_bvh_triangle_Intersection;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2142_: bool;
    var phi_2146_: lt_bvh_triangle_Intersection;
    var phi_2185_: bool;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2194_: bool;
    var phi_2195_: bool;
    var phi_2398_: f32;
    var phi_2401_: bool;
    var phi_2402_: bool;
    var phi_2406_: bool;
    var phi_2414_: lt_bvh_Hit;
    var phi_2415_: lt_bvh_Hit;
    var phi_2416_: lt_bvh_Hit;
    var phi_2417_: lt_bvh_Hit;
    var phi_1560_: lt_bvh_Hit;
    var phi_1563_: u32;
    var phi_2418_: bool;
    var phi_2457_: bool;
    var phi_2458_: bool;
    var phi_2489_: u32;
    var phi_1223_: lt_bvh_Hit;
    var phi_1226_: u32;
    var phi_2490_: lt_bvh_Hit;
    var phi_2491_: lt_bvh_Hit;
    var phi_2492_: bool;
    var phi_2496_: lt_bvh_Hit;
    var phi_2561_: f32;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2582_: f32;
    var phi_2587_: f32;
    var phi_2592_: f32;
    var phi_2668_: vec3<f32>;
    var phi_2789_: u32;
    var phi_2816_: f32;
    var phi_2823_: f32;
    var phi_2830_: f32;
    var phi_2865_: f32;
    var phi_2872_: f32;
    var phi_2879_: f32;
    var phi_2917_: f32;
    var phi_2924_: f32;
    var phi_2931_: f32;
    var phi_2990_: vec3<f32>;
    var phi_2991_: vec3<f32>;
    var phi_2992_: vec3<f32>;
    var phi_3001_: f32;
    var phi_3002_: f32;
    var phi_3012_: f32;
    var phi_3013_: f32;
    var phi_3023_: f32;
    var phi_3024_: f32;
    var phi_3059_: abi_Sample;
    var phi_3150_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&alpha_texels.member));
    let _e95 = arrayLength((&before.member));
    let _e101 = p.member.size[0u];
    let _e103 = p.member.size[1u];
    let _e104 = lt_shaders_entry_pixel_index(_e73, _e101, _e103);
    if (bitcast<i32>(_e104.word) != 0i) {
        let _e112 = p.member.eye;
        let _e117 = p.member.size[0u];
        let _e121 = ((((f32(_e73.x) + 0.5f) / f32(_e117)) * 2f) - 1f);
        let _e126 = p.member.size[1u];
        let _e130 = (1f - (((f32(_e73.y) + 0.5f) / f32(_e126)) * 2f));
        let _e132 = p.member.forward;
        let _e134 = p.member.right;
        let _e148 = p.member.up;
        let _e159 = _lt_bvh_ray_Ray_new(_e112, vec3<f32>(((_e132.x + (_e134.x * _e121)) + (_e148.x * _e130)), ((_e132.y + (_e134.y * _e121)) + (_e148.y * _e130)), ((_e132.z + (_e134.z * _e121)) + (_e148.z * _e130))));
        let _e161 = lt_bvh_Hit(_e159.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e164 = abs(_e159.direction.x);
        let _e166 = abs(_e159.direction.y);
        let _e168 = abs(_e159.direction.z);
        if (abs(_e159.origin.x) < 1000000000000000f) {
            if (abs(_e159.origin.y) < 1000000000000000f) {
                phi_782_ = (abs(_e159.origin.z) < 1000000000000000f);
                phi_783_ = false;
            } else {
                phi_782_ = bool();
                phi_783_ = true;
            }
            let _e180 = phi_782_;
            let _e182 = phi_783_;
            phi_784_ = _e180;
            phi_785_ = _e182;
        } else {
            phi_784_ = bool();
            phi_785_ = true;
        }
        let _e184 = phi_784_;
        let _e186 = phi_785_;
        if _e186 {
            phi_789_ = false;
        } else {
            phi_789_ = _e184;
        }
        let _e188 = phi_789_;
        if _e188 {
            if (_e164 < 1000000000000000f) {
                if (_e166 < 1000000000000000f) {
                    phi_802_ = (_e168 < 1000000000000000f);
                    phi_803_ = false;
                } else {
                    phi_802_ = bool();
                    phi_803_ = true;
                }
                let _e193 = phi_802_;
                let _e195 = phi_803_;
                phi_804_ = _e193;
                phi_805_ = _e195;
            } else {
                phi_804_ = bool();
                phi_805_ = true;
            }
            let _e197 = phi_804_;
            let _e199 = phi_805_;
            if _e199 {
                phi_809_ = false;
            } else {
                phi_809_ = _e197;
            }
            let _e201 = phi_809_;
            if _e201 {
                if (_e164 > 0f) {
                    phi_823_ = bool();
                    phi_824_ = true;
                } else {
                    let _e203 = (_e166 > 0f);
                    if _e203 {
                        phi_822_ = bool();
                    } else {
                        phi_822_ = (_e168 > 0f);
                    }
                    let _e206 = phi_822_;
                    phi_823_ = _e206;
                    phi_824_ = _e203;
                }
                let _e208 = phi_823_;
                let _e210 = phi_824_;
                if _e210 {
                    phi_828_ = true;
                } else {
                    phi_828_ = _e208;
                }
                let _e212 = phi_828_;
                phi_829_ = _e212;
                phi_830_ = false;
            } else {
                phi_829_ = bool();
                phi_830_ = true;
            }
            let _e214 = phi_829_;
            let _e216 = phi_830_;
            phi_831_ = _e214;
            phi_832_ = _e216;
        } else {
            phi_831_ = bool();
            phi_832_ = true;
        }
        let _e218 = phi_831_;
        let _e220 = phi_832_;
        if _e220 {
            phi_836_ = false;
        } else {
            phi_836_ = _e218;
        }
        let _e222 = phi_836_;
        if _e222 {
            let _e223 = (0u >= _e77);
            if _e223 {
                phi_2490_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e229 = nodes.member[(0u + 0u)].frame[0u];
                let _e233 = nodes.member[(0u + 0u)].frame[1u];
                let _e237 = nodes.member[(0u + 0u)].frame[2u];
                let _e241 = nodes.member[(0u + 0u)].frame[0u];
                let _e245 = nodes.member[(0u + 0u)].frame[1u];
                let _e249 = nodes.member[(0u + 0u)].frame[2u];
                let _e253 = nodes.member[(0u + 0u)].frame[3u];
                let _e292 = core_intrinsics_maximum_number_nsz_f32_(abs(_e159.direction.x), abs(_e159.direction.y));
                let _e293 = core_intrinsics_maximum_number_nsz_f32_(_e292, abs(_e159.direction.z));
                let _e294 = (_e293 * 0.0000000000009094947f);
                if (abs(_e159.direction.x) < _e294) {
                    phi_912_ = _e294;
                } else {
                    phi_912_ = abs(_e159.direction.x);
                }
                let _e300 = phi_912_;
                if (_e159.direction.x < 0f) {
                    phi_919_ = (-1f / _e300);
                } else {
                    phi_919_ = (1f / _e300);
                }
                let _e305 = phi_919_;
                if (abs(_e159.direction.y) < _e294) {
                    phi_927_ = _e294;
                } else {
                    phi_927_ = abs(_e159.direction.y);
                }
                let _e311 = phi_927_;
                if (_e159.direction.y < 0f) {
                    phi_934_ = (-1f / _e311);
                } else {
                    phi_934_ = (1f / _e311);
                }
                let _e316 = phi_934_;
                if (abs(_e159.direction.z) < _e294) {
                    phi_942_ = _e294;
                } else {
                    phi_942_ = abs(_e159.direction.z);
                }
                let _e322 = phi_942_;
                if (_e159.direction.z < 0f) {
                    phi_949_ = (-1f / _e322);
                } else {
                    phi_949_ = (1f / _e322);
                }
                let _e327 = phi_949_;
                let _e334 = abs((bitcast<f32>(_e229) - _e159.origin.x));
                let _e335 = abs((bitcast<f32>(_e233) - _e159.origin.y));
                let _e336 = abs((bitcast<f32>(_e237) - _e159.origin.z));
                let _e343 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e253 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.x));
                let _e344 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e253 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.y));
                let _e345 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e253 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.z));
                if (_e334 > _e343) {
                    phi_972_ = _e334;
                } else {
                    phi_972_ = _e343;
                }
                let _e348 = phi_972_;
                if (_e335 > _e344) {
                    phi_977_ = _e335;
                } else {
                    phi_977_ = _e344;
                }
                let _e351 = phi_977_;
                if (_e336 > _e345) {
                    phi_982_ = _e336;
                } else {
                    phi_982_ = _e345;
                }
                let _e354 = phi_982_;
                if (_e348 > _e351) {
                    phi_987_ = _e348;
                } else {
                    phi_987_ = _e351;
                }
                let _e357 = phi_987_;
                if (_e357 > _e354) {
                    phi_992_ = _e357;
                } else {
                    phi_992_ = _e354;
                }
                let _e360 = phi_992_;
                let _e364 = (_e360 * 0.0000019073486f);
                let _e365 = (abs(_e305) * _e364);
                let _e366 = (abs(_e316) * _e364);
                let _e367 = (abs(_e327) * _e364);
                let _e371 = (_e360 * 0.0000009536743f);
                let _e372 = (abs(_e305) * _e371);
                let _e373 = (abs(_e316) * _e371);
                let _e374 = (abs(_e327) * _e371);
                let _e378 = abs(_e159.direction.x);
                let _e380 = abs(_e159.direction.y);
                let _e382 = abs(_e159.direction.z);
                if (_e378 >= _e380) {
                    if (_e378 >= _e382) {
                        phi_1023_ = false;
                    } else {
                        phi_1023_ = true;
                    }
                    let _e386 = phi_1023_;
                    phi_1024_ = _e386;
                } else {
                    phi_1024_ = true;
                }
                let _e388 = phi_1024_;
                if _e388 {
                    if (_e380 >= _e382) {
                        phi_1032_ = 1u;
                    } else {
                        phi_1032_ = 2u;
                    }
                    let _e391 = phi_1032_;
                    phi_1033_ = _e391;
                } else {
                    phi_1033_ = 0u;
                }
                let _e393 = phi_1033_;
                if (_e393 == 0u) {
                    phi_1051_ = vec3<f32>(_e159.direction.y, _e159.direction.z, _e159.direction.x);
                } else {
                    if (_e393 == 1u) {
                        phi_1050_ = vec3<f32>(_e159.direction.z, _e159.direction.x, _e159.direction.y);
                    } else {
                        phi_1050_ = _e159.direction;
                    }
                    let _e405 = phi_1050_;
                    phi_1051_ = _e405;
                }
                let _e407 = phi_1051_;
                let _e410 = (_e407.x / _e407.z);
                let _e413 = (_e407.y / _e407.z);
                if (_e305 < 0f) {
                    phi_1064_ = 0u;
                } else {
                    phi_1064_ = 1u;
                }
                let _e418 = phi_1064_;
                if (_e316 < 0f) {
                    phi_1069_ = 0u;
                } else {
                    phi_1069_ = 2u;
                }
                let _e421 = phi_1069_;
                if (_e327 < 0f) {
                    phi_1074_ = 0u;
                } else {
                    phi_1074_ = 4u;
                }
                let _e424 = phi_1074_;
                let _e426 = ((_e418 | _e421) | _e424);
                let _e427 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e427.first[0], _e427.first[1], _e427.first[2], _e427.first[3], _e427.first[4], _e427.first[5], _e427.first[6], _e427.first[7], _e427.first[8], _e427.first[9], _e427.first[10], _e427.first[11], _e427.first[12], _e427.first[13], _e427.first[14], _e427.first[15], _e427.first[16], _e427.first[17], _e427.first[18], _e427.first[19], _e427.first[20], _e427.first[21], _e427.first[22], _e427.first[23], _e427.first[24], _e427.first[25], _e427.first[26], _e427.first[27], _e427.first[28], _e427.first[29], _e427.first[30], _e427.first[31]), array<u32, 32>(_e427.mask[0], _e427.mask[1], _e427.mask[2], _e427.mask[3], _e427.mask[4], _e427.mask[5], _e427.mask[6], _e427.mask[7], _e427.mask[8], _e427.mask[9], _e427.mask[10], _e427.mask[11], _e427.mask[12], _e427.mask[13], _e427.mask[14], _e427.mask[15], _e427.mask[16], _e427.mask[17], _e427.mask[18], _e427.mask[19], _e427.mask[20], _e427.mask[21], _e427.mask[22], _e427.mask[23], _e427.mask[24], _e427.mask[25], _e427.mask[26], _e427.mask[27], _e427.mask[28], _e427.mask[29], _e427.mask[30], _e427.mask[31]), _e427.len, _e427.group, _e427.group_mask);
                let _e501 = local_1.group_mask;
                if ((_e501 & 4278190080u) == 0u) {
                    let _e505 = local_1.len;
                    if (_e505 == 0u) {
                        phi_1188_ = false;
                    } else {
                        let _e509 = local_1.len;
                        local_1.len = (_e509 - 1u);
                        let _e512 = local_1.len;
                        if (_e512 < 32u) {
                        } else {
                            return;
                        }
                        let _e517 = local_1.first[(0u + _e512)];
                        local_1.group = _e517;
                        let _e520 = local_1.len;
                        if (_e520 < 32u) {
                        } else {
                            return;
                        }
                        let _e525 = local_1.mask[(0u + _e520)];
                        local_1.group_mask = _e525;
                        phi_1188_ = true;
                    }
                    let _e528 = phi_1188_;
                    phi_1189_ = _e528;
                } else {
                    phi_1189_ = true;
                }
                let _e530 = phi_1189_;
                if _e530 {
                    let _e532 = local_1.group_mask;
                    let _e538 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e532)), 32u, (_e532 == 0u)));
                    let _e542 = local_1.group_mask;
                    let _e556 = local_1.group_mask;
                    local_1.group_mask = (_e556 & ~((1u << bitcast<u32>((_e538 & 31u)))));
                    let _e559 = local_1.group;
                    phi_1220_ = (_e559 + countOneBits(((_e542 & ~((4294967295u << bitcast<u32>((((_e538 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1220_ = 4294967295u;
                }
                let _e562 = phi_1220_;
                phi_1222_ = _e161;
                phi_1225_ = _e562;
                loop {
                    let _e564 = phi_1222_;
                    let _e566 = phi_1225_;
                    local_6 = _e564;
                    let _e567 = (_e566 != 4294967295u);
                    if _e567 {
                        if (_e566 < _e77) {
                        } else {
                            return;
                        }
                        let _e575 = nodes.member[(0u + _e566)].frame[3u];
                        let _e600 = (bitcast<f32>((((_e575 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e305);
                        let _e601 = (bitcast<f32>((((_e575 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e316);
                        let _e602 = (bitcast<f32>((((_e575 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e327);
                        let _e605 = nodes.member[(0u + _e566)].frame[0u];
                        let _e609 = nodes.member[(0u + _e566)].frame[1u];
                        let _e613 = nodes.member[(0u + _e566)].frame[2u];
                        let _e621 = ((bitcast<f32>(_e605) - _e159.origin.x) * _e305);
                        let _e622 = ((bitcast<f32>(_e609) - _e159.origin.y) * _e316);
                        let _e623 = ((bitcast<f32>(_e613) - _e159.origin.z) * _e327);
                        let _e631 = nodes.member[(0u + _e566)].x;
                        if (_e305 < 0f) {
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e631.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e642.unnamed.word, _e631.w), _e642.unnamed_1);
                            let _e654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_mask_LightPlace(_e631.x, _e648.unnamed_1.shift));
                            phi_1310_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e654.unnamed, lt_mask_LightPlace(_e654.unnamed_1.word, _e631.y));
                        } else {
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e631.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e670.unnamed.word, _e631.y), _e670.unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e631.z, _e676.unnamed_1.shift));
                            phi_1310_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_mask_LightPlace(_e682.unnamed_1.word, _e631.w));
                        }
                        let _e690 = phi_1310_;
                        let _e700 = nodes.member[(0u + _e566)].y;
                        if (_e316 < 0f) {
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e700.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e711.unnamed.word, _e700.w), _e711.unnamed_1);
                            let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_mask_LightPlace(_e700.x, _e717.unnamed_1.shift));
                            phi_1337_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e723.unnamed, lt_mask_LightPlace(_e723.unnamed_1.word, _e700.y));
                        } else {
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e700.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e739.unnamed.word, _e700.y), _e739.unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e700.z, _e745.unnamed_1.shift));
                            phi_1337_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_mask_LightPlace(_e751.unnamed_1.word, _e700.w));
                        }
                        let _e759 = phi_1337_;
                        let _e769 = nodes.member[(0u + _e566)].z;
                        if (_e327 < 0f) {
                            let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e769.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e780.unnamed.word, _e769.w), _e780.unnamed_1);
                            let _e792 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e786.unnamed, lt_mask_LightPlace(_e769.x, _e786.unnamed_1.shift));
                            phi_1364_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e792.unnamed, lt_mask_LightPlace(_e792.unnamed_1.word, _e769.y));
                        } else {
                            let _e808 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e769.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e814 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e808.unnamed.word, _e769.y), _e808.unnamed_1);
                            let _e820 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e814.unnamed, lt_mask_LightPlace(_e769.z, _e814.unnamed_1.shift));
                            phi_1364_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e820.unnamed, lt_mask_LightPlace(_e820.unnamed_1.word, _e769.w));
                        }
                        let _e828 = phi_1364_;
                        phi_1370_ = 0u;
                        phi_1373_ = 0u;
                        loop {
                            let _e838 = phi_1370_;
                            let _e840 = phi_1373_;
                            local_2 = _e840;
                            local_3 = _e840;
                            local_4 = _e840;
                            let _e841 = (_e838 < 8u);
                            if _e841 {
                                let _e843 = (_e838 >> bitcast<u32>(2i));
                                let _e844 = (_e838 & 3u);
                                if (_e843 == 0u) {
                                    phi_1387_ = _e690.unnamed.word;
                                } else {
                                    phi_1387_ = _e690.unnamed.shift;
                                }
                                let _e847 = phi_1387_;
                                if (_e843 == 0u) {
                                    phi_1397_ = _e759.unnamed.word;
                                } else {
                                    phi_1397_ = _e759.unnamed.shift;
                                }
                                let _e856 = phi_1397_;
                                if (_e843 == 0u) {
                                    phi_1407_ = _e828.unnamed.word;
                                } else {
                                    phi_1407_ = _e828.unnamed.shift;
                                }
                                let _e865 = phi_1407_;
                                let _e878 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e847 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e365)), ((f32(((_e856 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e366)));
                                let _e879 = core_intrinsics_maximum_number_nsz_f32_(_e878, ((f32(((_e865 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u)) * _e602) + (_e623 - _e367)));
                                if (_e843 == 0u) {
                                    phi_1425_ = _e690.unnamed_1.word;
                                } else {
                                    phi_1425_ = _e690.unnamed_1.shift;
                                }
                                let _e882 = phi_1425_;
                                if (_e843 == 0u) {
                                    phi_1435_ = _e759.unnamed_1.word;
                                } else {
                                    phi_1435_ = _e759.unnamed_1.shift;
                                }
                                let _e891 = phi_1435_;
                                if (_e843 == 0u) {
                                    phi_1445_ = _e828.unnamed_1.word;
                                } else {
                                    phi_1445_ = _e828.unnamed_1.shift;
                                }
                                let _e900 = phi_1445_;
                                let _e913 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e882 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e365)), ((f32(((_e891 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u)) * _e601) + (_e622 + _e366)));
                                let _e914 = core_intrinsics_minimum_number_nsz_f32_(_e913, ((f32(((_e900 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u)) * _e602) + (_e623 + _e367)));
                                if (_e879 <= _e914) {
                                    if (_e879 <= _e564.t) {
                                        if (_e914 >= _e159.tmin) {
                                            if (_e843 == 0u) {
                                                let _e921 = nodes.member[(0u + _e566)].links[2u];
                                                phi_1481_ = _e921;
                                            } else {
                                                let _e924 = nodes.member[(0u + _e566)].links[3u];
                                                phi_1481_ = _e924;
                                            }
                                            let _e926 = phi_1481_;
                                            let _e931 = ((_e926 >> bitcast<u32>(((_e844 * 8u) & 31u))) & 255u);
                                            let _e932 = (_e931 & 31u);
                                            if (_e932 >= 24u) {
                                                phi_1494_ = (24u + ((_e932 - 24u) ^ _e426));
                                            } else {
                                                phi_1494_ = _e932;
                                            }
                                            let _e938 = phi_1494_;
                                            phi_1499_ = (_e840 | ((_e931 >> bitcast<u32>(5i)) << bitcast<u32>((_e938 & 31u))));
                                        } else {
                                            phi_1499_ = _e840;
                                        }
                                        let _e946 = phi_1499_;
                                        phi_1500_ = _e946;
                                    } else {
                                        phi_1500_ = _e840;
                                    }
                                    let _e948 = phi_1500_;
                                    phi_1501_ = _e948;
                                } else {
                                    phi_1501_ = _e840;
                                }
                                let _e950 = phi_1501_;
                                phi_1371_ = (_e838 + 1u);
                                phi_1374_ = _e950;
                            } else {
                                phi_1371_ = u32();
                                phi_1374_ = u32();
                            }
                            let _e953 = phi_1371_;
                            let _e955 = phi_1374_;
                            continue;
                            continuing {
                                phi_1370_ = _e953;
                                phi_1373_ = _e955;
                                break if !(_e841);
                            }
                        }
                        let _e959 = nodes.member[(0u + _e566)].links[0u];
                        let _e963 = nodes.member[(0u + _e566)].frame[3u];
                        let _e967 = local_2;
                        if ((_e967 & 4278190080u) == 0u) {
                        } else {
                            let _e971 = local_1.group_mask;
                            if ((_e971 & 4278190080u) == 0u) {
                            } else {
                                let _e975 = local_1.len;
                                if (_e975 < 32u) {
                                    let _e978 = local_1.group;
                                    let _e980 = local_1.len;
                                    if (_e980 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e980)] = _e978;
                                    let _e986 = local_1.group_mask;
                                    let _e988 = local_1.len;
                                    if (_e988 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e988)] = _e986;
                                    let _e995 = local_1.len;
                                    local_1.len = (_e995 + 1u);
                                }
                            }
                            local_1.group = (0u + _e959);
                            let _e999 = local_3;
                            local_1.group_mask = ((_e999 & 4278190080u) | (_e963 >> bitcast<u32>(24i)));
                        }
                        let _e1004 = local_4;
                        phi_1559_ = _e564;
                        phi_1562_ = (_e1004 & 16777215u);
                        loop {
                            let _e1007 = phi_1559_;
                            let _e1009 = phi_1562_;
                            local_5 = _e1007;
                            if (_e1009 == 0u) {
                                phi_1560_ = lt_bvh_Hit();
                                phi_1563_ = u32();
                                phi_2418_ = false;
                            } else {
                                let _e1013 = nodes.member[(0u + _e566)].links[1u];
                                let _e1018 = ((0u + _e1013) + select(firstTrailingBit(_e1009), 32u, (_e1009 == 0u)));
                                if (_e1018 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1025 = triangles.member[(0u + _e1018)].v0_;
                                let _e1028 = (_e1025.x - _e159.origin.x);
                                let _e1031 = (_e1025.y - _e159.origin.y);
                                let _e1034 = (_e1025.z - _e159.origin.z);
                                if (_e393 == 0u) {
                                    phi_1609_ = vec3<f32>(_e1031, _e1034, _e1028);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1608_ = vec3<f32>(_e1034, _e1028, _e1031);
                                    } else {
                                        phi_1608_ = (_e1025 - _e159.origin);
                                    }
                                    let _e1041 = phi_1608_;
                                    phi_1609_ = _e1041;
                                }
                                let _e1043 = phi_1609_;
                                let _e1047 = (_e1043.x - (_e410 * _e1043.z));
                                let _e1051 = (_e1043.y - (_e413 * _e1043.z));
                                let _e1053 = triangles.member[(0u + _e1018)].v1_;
                                let _e1056 = (_e1053.x - _e159.origin.x);
                                let _e1059 = (_e1053.y - _e159.origin.y);
                                let _e1062 = (_e1053.z - _e159.origin.z);
                                if (_e393 == 0u) {
                                    phi_1641_ = vec3<f32>(_e1059, _e1062, _e1056);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1640_ = vec3<f32>(_e1062, _e1056, _e1059);
                                    } else {
                                        phi_1640_ = (_e1053 - _e159.origin);
                                    }
                                    let _e1069 = phi_1640_;
                                    phi_1641_ = _e1069;
                                }
                                let _e1071 = phi_1641_;
                                let _e1075 = (_e1071.x - (_e410 * _e1071.z));
                                let _e1079 = (_e1071.y - (_e413 * _e1071.z));
                                let _e1081 = triangles.member[(0u + _e1018)].v2_;
                                let _e1084 = (_e1081.x - _e159.origin.x);
                                let _e1087 = (_e1081.y - _e159.origin.y);
                                let _e1090 = (_e1081.z - _e159.origin.z);
                                if (_e393 == 0u) {
                                    phi_1673_ = vec3<f32>(_e1087, _e1090, _e1084);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1672_ = vec3<f32>(_e1090, _e1084, _e1087);
                                    } else {
                                        phi_1672_ = (_e1081 - _e159.origin);
                                    }
                                    let _e1097 = phi_1672_;
                                    phi_1673_ = _e1097;
                                }
                                let _e1099 = phi_1673_;
                                let _e1103 = (_e1099.x - (_e410 * _e1099.z));
                                let _e1107 = (_e1099.y - (_e413 * _e1099.z));
                                if (_e1075 < _e1103) {
                                    phi_1692_ = true;
                                } else {
                                    if (_e1075 == _e1103) {
                                        phi_1691_ = (_e1079 < _e1107);
                                    } else {
                                        phi_1691_ = false;
                                    }
                                    let _e1112 = phi_1691_;
                                    phi_1692_ = _e1112;
                                }
                                let _e1114 = phi_1692_;
                                if _e1114 {
                                    phi_1696_ = _e1107;
                                    phi_1697_ = _e1103;
                                    phi_1698_ = _e1079;
                                    phi_1699_ = _e1075;
                                } else {
                                    phi_1696_ = _e1079;
                                    phi_1697_ = _e1075;
                                    phi_1698_ = _e1107;
                                    phi_1699_ = _e1103;
                                }
                                let _e1116 = phi_1696_;
                                let _e1118 = phi_1697_;
                                let _e1120 = phi_1698_;
                                let _e1122 = phi_1699_;
                                let _e1125 = ((_e1122 * _e1116) - (_e1120 * _e1118));
                                if _e1114 {
                                    phi_1707_ = -(_e1125);
                                } else {
                                    phi_1707_ = _e1125;
                                }
                                let _e1128 = phi_1707_;
                                if (_e1103 < _e1047) {
                                    phi_1718_ = true;
                                } else {
                                    if (_e1103 == _e1047) {
                                        phi_1717_ = (_e1107 < _e1051);
                                    } else {
                                        phi_1717_ = false;
                                    }
                                    let _e1133 = phi_1717_;
                                    phi_1718_ = _e1133;
                                }
                                let _e1135 = phi_1718_;
                                if _e1135 {
                                    phi_1722_ = _e1051;
                                    phi_1723_ = _e1047;
                                    phi_1724_ = _e1107;
                                    phi_1725_ = _e1103;
                                } else {
                                    phi_1722_ = _e1107;
                                    phi_1723_ = _e1103;
                                    phi_1724_ = _e1051;
                                    phi_1725_ = _e1047;
                                }
                                let _e1137 = phi_1722_;
                                let _e1139 = phi_1723_;
                                let _e1141 = phi_1724_;
                                let _e1143 = phi_1725_;
                                let _e1146 = ((_e1143 * _e1137) - (_e1141 * _e1139));
                                if _e1135 {
                                    phi_1733_ = -(_e1146);
                                } else {
                                    phi_1733_ = _e1146;
                                }
                                let _e1149 = phi_1733_;
                                if (_e1047 < _e1075) {
                                    phi_1744_ = true;
                                } else {
                                    if (_e1047 == _e1075) {
                                        phi_1743_ = (_e1051 < _e1079);
                                    } else {
                                        phi_1743_ = false;
                                    }
                                    let _e1154 = phi_1743_;
                                    phi_1744_ = _e1154;
                                }
                                let _e1156 = phi_1744_;
                                if _e1156 {
                                    phi_1748_ = _e1079;
                                    phi_1749_ = _e1075;
                                    phi_1750_ = _e1051;
                                    phi_1751_ = _e1047;
                                } else {
                                    phi_1748_ = _e1051;
                                    phi_1749_ = _e1047;
                                    phi_1750_ = _e1079;
                                    phi_1751_ = _e1075;
                                }
                                let _e1158 = phi_1748_;
                                let _e1160 = phi_1749_;
                                let _e1162 = phi_1750_;
                                let _e1164 = phi_1751_;
                                let _e1167 = ((_e1164 * _e1158) - (_e1162 * _e1160));
                                if _e1156 {
                                    phi_1759_ = -(_e1167);
                                } else {
                                    phi_1759_ = _e1167;
                                }
                                let _e1170 = phi_1759_;
                                if (_e1128 >= 0f) {
                                    if (_e1149 >= 0f) {
                                        if (_e1170 >= 0f) {
                                            phi_1774_ = ((_e1128 + _e1149) + _e1170);
                                            phi_1775_ = false;
                                        } else {
                                            phi_1774_ = f32();
                                            phi_1775_ = true;
                                        }
                                        let _e1177 = phi_1774_;
                                        let _e1179 = phi_1775_;
                                        phi_1776_ = _e1177;
                                        phi_1777_ = _e1179;
                                    } else {
                                        phi_1776_ = f32();
                                        phi_1777_ = true;
                                    }
                                    let _e1181 = phi_1776_;
                                    let _e1183 = phi_1777_;
                                    phi_1778_ = _e1181;
                                    phi_1779_ = _e1183;
                                } else {
                                    phi_1778_ = f32();
                                    phi_1779_ = true;
                                }
                                let _e1185 = phi_1778_;
                                let _e1187 = phi_1779_;
                                if _e1187 {
                                    if (_e1128 <= 0f) {
                                        if (_e1149 <= 0f) {
                                            let _e1190 = (_e1170 <= 0f);
                                            if _e1190 {
                                            }
                                            phi_1797_ = ((_e1128 + _e1149) + _e1170);
                                            phi_1798_ = false;
                                            phi_1799_ = _e1190;
                                        } else {
                                            phi_1797_ = f32();
                                            phi_1798_ = true;
                                            phi_1799_ = false;
                                        }
                                        let _e1194 = phi_1797_;
                                        let _e1196 = phi_1798_;
                                        let _e1198 = phi_1799_;
                                        phi_1800_ = _e1194;
                                        phi_1801_ = _e1196;
                                        phi_1802_ = _e1198;
                                    } else {
                                        phi_1800_ = f32();
                                        phi_1801_ = true;
                                        phi_1802_ = false;
                                    }
                                    let _e1200 = phi_1800_;
                                    let _e1202 = phi_1801_;
                                    let _e1204 = phi_1802_;
                                    if _e1202 {
                                        phi_1806_ = false;
                                    } else {
                                        phi_1806_ = _e1204;
                                    }
                                    let _e1206 = phi_1806_;
                                    phi_1807_ = _e1200;
                                    phi_1808_ = _e1206;
                                } else {
                                    phi_1807_ = _e1185;
                                    phi_1808_ = true;
                                }
                                let _e1208 = phi_1807_;
                                let _e1210 = phi_1808_;
                                if _e1210 {
                                    let _e1211 = (_e1208 == 0f);
                                    if _e1211 {
                                        phi_2134_ = lt_bvh_triangle_Intersection();
                                        phi_2135_ = false;
                                    } else {
                                        let _e1213 = triangles.member[(0u + _e1018)].v0_;
                                        let _e1216 = (_e1213.x - _e159.origin.x);
                                        let _e1219 = (_e1213.y - _e159.origin.y);
                                        let _e1222 = (_e1213.z - _e159.origin.z);
                                        if (_e393 == 0u) {
                                            phi_1839_ = vec3<f32>(_e1219, _e1222, _e1216);
                                        } else {
                                            if (_e393 == 1u) {
                                                phi_1838_ = vec3<f32>(_e1222, _e1216, _e1219);
                                            } else {
                                                phi_1838_ = (_e1213 - _e159.origin);
                                            }
                                            let _e1229 = phi_1838_;
                                            phi_1839_ = _e1229;
                                        }
                                        let _e1231 = phi_1839_;
                                        let _e1233 = triangles.member[(0u + _e1018)].v1_;
                                        let _e1235 = triangles.member[(0u + _e1018)].v0_;
                                        let _e1238 = (_e1233.x - _e1235.x);
                                        let _e1241 = (_e1233.y - _e1235.y);
                                        let _e1244 = (_e1233.z - _e1235.z);
                                        if (_e393 == 0u) {
                                            phi_1865_ = vec3<f32>(_e1241, _e1244, _e1238);
                                        } else {
                                            if (_e393 == 1u) {
                                                phi_1864_ = vec3<f32>(_e1244, _e1238, _e1241);
                                            } else {
                                                phi_1864_ = (_e1233 - _e1235);
                                            }
                                            let _e1251 = phi_1864_;
                                            phi_1865_ = _e1251;
                                        }
                                        let _e1253 = phi_1865_;
                                        let _e1255 = triangles.member[(0u + _e1018)].v2_;
                                        let _e1257 = triangles.member[(0u + _e1018)].v0_;
                                        let _e1260 = (_e1255.x - _e1257.x);
                                        let _e1263 = (_e1255.y - _e1257.y);
                                        let _e1266 = (_e1255.z - _e1257.z);
                                        if (_e393 == 0u) {
                                            phi_1891_ = vec3<f32>(_e1263, _e1266, _e1260);
                                        } else {
                                            if (_e393 == 1u) {
                                                phi_1890_ = vec3<f32>(_e1266, _e1260, _e1263);
                                            } else {
                                                phi_1890_ = (_e1255 - _e1257);
                                            }
                                            let _e1273 = phi_1890_;
                                            phi_1891_ = _e1273;
                                        }
                                        let _e1275 = phi_1891_;
                                        let _e1282 = ((_e1253.y * _e1275.z) - (_e1253.z * _e1275.y));
                                        let _e1289 = ((_e1253.z * _e1275.x) - (_e1253.x * _e1275.z));
                                        let _e1296 = ((_e1253.x * _e1275.y) - (_e1253.y * _e1275.x));
                                        let _e1310 = (((1f / _e407.z) * (((_e1282 * _e1231.x) + (_e1289 * _e1231.y)) + (_e1296 * _e1231.z))) / (((_e1282 * _e410) + (_e1289 * _e413)) + _e1296));
                                        if (_e1310 > _e159.tmin) {
                                            if (_e1310 < _e159.tmax) {
                                                let _e1316 = triangles.member[(0u + _e1018)].v0_;
                                                let _e1318 = triangles.member[(0u + _e1018)].v1_;
                                                if (_e1316.x < _e1318.x) {
                                                    phi_1949_ = _e1316.x;
                                                } else {
                                                    phi_1949_ = _e1318.x;
                                                }
                                                let _e1325 = phi_1949_;
                                                if (_e1316.y < _e1318.y) {
                                                    phi_1958_ = _e1316.y;
                                                } else {
                                                    phi_1958_ = _e1318.y;
                                                }
                                                let _e1332 = phi_1958_;
                                                if (_e1316.z < _e1318.z) {
                                                    phi_1967_ = _e1316.z;
                                                } else {
                                                    phi_1967_ = _e1318.z;
                                                }
                                                let _e1339 = phi_1967_;
                                                let _e1341 = triangles.member[(0u + _e1018)].v2_;
                                                if (_e1325 < _e1341.x) {
                                                    phi_1976_ = _e1325;
                                                } else {
                                                    phi_1976_ = _e1341.x;
                                                }
                                                let _e1346 = phi_1976_;
                                                if (_e1332 < _e1341.y) {
                                                    phi_1983_ = _e1332;
                                                } else {
                                                    phi_1983_ = _e1341.y;
                                                }
                                                let _e1351 = phi_1983_;
                                                if (_e1339 < _e1341.z) {
                                                    phi_1990_ = _e1339;
                                                } else {
                                                    phi_1990_ = _e1341.z;
                                                }
                                                let _e1356 = phi_1990_;
                                                let _e1358 = triangles.member[(0u + _e1018)].v0_;
                                                let _e1360 = triangles.member[(0u + _e1018)].v1_;
                                                if (_e1358.x > _e1360.x) {
                                                    phi_2003_ = _e1358.x;
                                                } else {
                                                    phi_2003_ = _e1360.x;
                                                }
                                                let _e1367 = phi_2003_;
                                                if (_e1358.y > _e1360.y) {
                                                    phi_2012_ = _e1358.y;
                                                } else {
                                                    phi_2012_ = _e1360.y;
                                                }
                                                let _e1374 = phi_2012_;
                                                if (_e1358.z > _e1360.z) {
                                                    phi_2021_ = _e1358.z;
                                                } else {
                                                    phi_2021_ = _e1360.z;
                                                }
                                                let _e1381 = phi_2021_;
                                                let _e1383 = triangles.member[(0u + _e1018)].v2_;
                                                if (_e1367 > _e1383.x) {
                                                    phi_2030_ = _e1367;
                                                } else {
                                                    phi_2030_ = _e1383.x;
                                                }
                                                let _e1388 = phi_2030_;
                                                if (_e1374 > _e1383.y) {
                                                    phi_2037_ = _e1374;
                                                } else {
                                                    phi_2037_ = _e1383.y;
                                                }
                                                let _e1393 = phi_2037_;
                                                if (_e1381 > _e1383.z) {
                                                    phi_2044_ = _e1381;
                                                } else {
                                                    phi_2044_ = _e1383.z;
                                                }
                                                let _e1398 = phi_2044_;
                                                let _e1405 = ((_e1346 - _e159.origin.x) * _e305);
                                                let _e1406 = ((_e1351 - _e159.origin.y) * _e316);
                                                let _e1407 = ((_e1356 - _e159.origin.z) * _e327);
                                                let _e1414 = ((_e1388 - _e159.origin.x) * _e305);
                                                let _e1415 = ((_e1393 - _e159.origin.y) * _e316);
                                                let _e1416 = ((_e1398 - _e159.origin.z) * _e327);
                                                if (_e1405 < _e1414) {
                                                    phi_2067_ = _e1405;
                                                } else {
                                                    phi_2067_ = _e1414;
                                                }
                                                let _e1419 = phi_2067_;
                                                if (_e1406 < _e1415) {
                                                    phi_2072_ = _e1406;
                                                } else {
                                                    phi_2072_ = _e1415;
                                                }
                                                let _e1422 = phi_2072_;
                                                if (_e1407 < _e1416) {
                                                    phi_2077_ = _e1407;
                                                } else {
                                                    phi_2077_ = _e1416;
                                                }
                                                let _e1425 = phi_2077_;
                                                if (_e1405 > _e1414) {
                                                    phi_2085_ = _e1405;
                                                } else {
                                                    phi_2085_ = _e1414;
                                                }
                                                let _e1431 = phi_2085_;
                                                if (_e1406 > _e1415) {
                                                    phi_2090_ = _e1406;
                                                } else {
                                                    phi_2090_ = _e1415;
                                                }
                                                let _e1434 = phi_2090_;
                                                if (_e1407 > _e1416) {
                                                    phi_2095_ = _e1407;
                                                } else {
                                                    phi_2095_ = _e1416;
                                                }
                                                let _e1437 = phi_2095_;
                                                let _e1441 = core_intrinsics_maximum_number_nsz_f32_((_e1419 - _e372), (_e1422 - _e373));
                                                let _e1442 = core_intrinsics_maximum_number_nsz_f32_(_e1441, (_e1425 - _e374));
                                                let _e1443 = core_intrinsics_minimum_number_nsz_f32_((_e1431 + _e372), (_e1434 + _e373));
                                                let _e1444 = core_intrinsics_minimum_number_nsz_f32_(_e1443, (_e1437 + _e374));
                                                if (_e1442 > -300000000000000000000000000000000000000f) {
                                                    phi_2107_ = _e1442;
                                                } else {
                                                    phi_2107_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1447 = phi_2107_;
                                                if (_e1444 < 300000000000000000000000000000000000000f) {
                                                    phi_2112_ = _e1444;
                                                } else {
                                                    phi_2112_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1450 = phi_2112_;
                                                if (_e1310 < _e1447) {
                                                    phi_2117_ = _e1447;
                                                } else {
                                                    phi_2117_ = _e1310;
                                                }
                                                let _e1453 = phi_2117_;
                                                if (_e1453 > _e1450) {
                                                    phi_2122_ = _e1450;
                                                } else {
                                                    phi_2122_ = _e1453;
                                                }
                                                let _e1456 = phi_2122_;
                                                phi_2127_ = lt_bvh_triangle_Intersection(_e1456, (_e1149 / _e1208), (_e1170 / _e1208), (_e1447 <= _e1450));
                                                phi_2128_ = false;
                                            } else {
                                                phi_2127_ = lt_bvh_triangle_Intersection();
                                                phi_2128_ = true;
                                            }
                                            let _e1462 = phi_2127_;
                                            let _e1464 = phi_2128_;
                                            phi_2129_ = _e1462;
                                            phi_2130_ = _e1464;
                                        } else {
                                            phi_2129_ = lt_bvh_triangle_Intersection();
                                            phi_2130_ = true;
                                        }
                                        let _e1466 = phi_2129_;
                                        let _e1468 = phi_2130_;
                                        if _e1468 {
                                        }
                                        phi_2134_ = _e1466;
                                        phi_2135_ = _e1468;
                                    }
                                    let _e1470 = phi_2134_;
                                    let _e1472 = phi_2135_;
                                    phi_2136_ = _e1470;
                                    phi_2137_ = _e1211;
                                    phi_2138_ = _e1472;
                                } else {
                                    phi_2136_ = lt_bvh_triangle_Intersection();
                                    phi_2137_ = true;
                                    phi_2138_ = false;
                                }
                                let _e1474 = phi_2136_;
                                let _e1476 = phi_2137_;
                                let _e1478 = phi_2138_;
                                if _e1476 {
                                    phi_2142_ = true;
                                } else {
                                    phi_2142_ = _e1478;
                                }
                                let _e1480 = phi_2142_;
                                if _e1480 {
                                    phi_2146_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2146_ = _e1474;
                                }
                                let _e1482 = phi_2146_;
                                if _e1482.is_hit {
                                    if (_e1482.t > _e159.tmin) {
                                        if (_e1482.t < _e1007.t) {
                                            phi_2195_ = true;
                                        } else {
                                            if (_e1482.t == _e1007.t) {
                                                if (_e1007.triangle != 4294967295u) {
                                                    if (_e1018 < _e1007.triangle) {
                                                        phi_2186_ = true;
                                                    } else {
                                                        if (_e1018 == _e1007.triangle) {
                                                            phi_2185_ = (4294967295u < _e1007.instance);
                                                        } else {
                                                            phi_2185_ = false;
                                                        }
                                                        let _e1501 = phi_2185_;
                                                        phi_2186_ = _e1501;
                                                    }
                                                    let _e1503 = phi_2186_;
                                                    phi_2187_ = _e1503;
                                                    phi_2188_ = false;
                                                } else {
                                                    phi_2187_ = bool();
                                                    phi_2188_ = true;
                                                }
                                                let _e1505 = phi_2187_;
                                                let _e1507 = phi_2188_;
                                                phi_2189_ = _e1505;
                                                phi_2190_ = _e1507;
                                            } else {
                                                phi_2189_ = bool();
                                                phi_2190_ = true;
                                            }
                                            let _e1509 = phi_2189_;
                                            let _e1511 = phi_2190_;
                                            if _e1511 {
                                                phi_2194_ = false;
                                            } else {
                                                phi_2194_ = _e1509;
                                            }
                                            let _e1513 = phi_2194_;
                                            phi_2195_ = _e1513;
                                        }
                                        let _e1515 = phi_2195_;
                                        if _e1515 {
                                            let _e1517 = triangles.member[(0u + _e1018)].i0_;
                                            if ((_e1517 & 2147483648u) == 0u) {
                                                phi_2406_ = true;
                                            } else {
                                                if (_e1018 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1526 = triangles.member[(0u + _e1018)].i0_;
                                                let _e1527 = (_e1526 & 2147483647u);
                                                let _e1529 = triangles.member[(0u + _e1018)].i1_;
                                                let _e1531 = triangles.member[(0u + _e1018)].i2_;
                                                if (_e1527 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1535 = vertices.member[(0u + _e1527)];
                                                if (_e1529 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1539 = vertices.member[(0u + _e1529)];
                                                if (_e1531 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1543 = vertices.member[(0u + _e1531)];
                                                let _e1544 = array<abi_Vertex, 3>(_e1535, _e1539, _e1543);
                                                if (_e1544[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1550 = materials.member[(0u + _e1544[0].material)];
                                                if ((_e1550.flags & 0u) == 0u) {
                                                    let _e1555 = ((1f - _e1482.u) - _e1482.v);
                                                    if (_e1550.cutoff <= 0f) {
                                                        phi_2401_ = true;
                                                    } else {
                                                        let _e1582 = (_e1550.base_color.w * ((((f32((_e1544[0].color >> bitcast<u32>(24i))) * _e1555) + (f32((_e1544[1].color >> bitcast<u32>(24i))) * _e1482.u)) + (f32((_e1544[2].color >> bitcast<u32>(24i))) * _e1482.v)) * (1f / 255f)));
                                                        if (_e1550.alpha_size == 0u) {
                                                            phi_2398_ = _e1582;
                                                        } else {
                                                            local.offset = _e1550.alpha_offset;
                                                            local.size = _e1550.alpha_size;
                                                            local.flags = _e1550.flags;
                                                            let _e1613 = _lt_shaders_texture_TextureView_quad((&local), (((_e1544[0].u * _e1555) + (_e1544[1].u * _e1482.u)) + (_e1544[2].u * _e1482.v)), (((_e1544[0].v * _e1555) + (_e1544[1].v * _e1482.u)) + (_e1544[2].v * _e1482.v)));
                                                            let _e1617 = (_e1613.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1617 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1621 = alpha_texels.member[(0u + _e1617)];
                                                            let _e1637 = (_e1613.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1637 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1641 = alpha_texels.member[(0u + _e1637)];
                                                            let _e1658 = (_e1613.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1658 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1662 = alpha_texels.member[(0u + _e1658)];
                                                            let _e1679 = (_e1613.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1679 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1683 = alpha_texels.member[(0u + _e1679)];
                                                            phi_2398_ = (_e1582 * (((((f32(((_e1621 >> bitcast<u32>((((_e1613.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1613.weights.x) + ((f32(((_e1641 >> bitcast<u32>((((_e1613.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1613.weights.y)) + ((f32(((_e1662 >> bitcast<u32>((((_e1613.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1613.weights.z)) + ((f32(((_e1683 >> bitcast<u32>((((_e1613.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1613.weights.w)));
                                                        }
                                                        let _e1699 = phi_2398_;
                                                        phi_2401_ = (_e1699 >= _e1550.cutoff);
                                                    }
                                                    let _e1703 = phi_2401_;
                                                    phi_2402_ = _e1703;
                                                } else {
                                                    phi_2402_ = false;
                                                }
                                                let _e1705 = phi_2402_;
                                                if _e1705 {
                                                }
                                                phi_2406_ = _e1705;
                                            }
                                            let _e1707 = phi_2406_;
                                            if _e1707 {
                                                phi_2414_ = lt_bvh_Hit(_e1482.t, _e1482.u, _e1482.v, _e1018, 4294967295u);
                                            } else {
                                                phi_2414_ = _e1007;
                                            }
                                            let _e1713 = phi_2414_;
                                            phi_2415_ = _e1713;
                                        } else {
                                            phi_2415_ = _e1007;
                                        }
                                        let _e1715 = phi_2415_;
                                        phi_2416_ = _e1715;
                                    } else {
                                        phi_2416_ = _e1007;
                                    }
                                    let _e1717 = phi_2416_;
                                    phi_2417_ = _e1717;
                                } else {
                                    phi_2417_ = _e1007;
                                }
                                let _e1719 = phi_2417_;
                                phi_1560_ = _e1719;
                                phi_1563_ = (_e1009 & (_e1009 - 1u));
                                phi_2418_ = true;
                            }
                            let _e1721 = phi_1560_;
                            let _e1723 = phi_1563_;
                            let _e1725 = phi_2418_;
                            continue;
                            continuing {
                                phi_1559_ = _e1721;
                                phi_1562_ = _e1723;
                                break if !(_e1725);
                            }
                        }
                        let _e1728 = local_1.group_mask;
                        if ((_e1728 & 4278190080u) == 0u) {
                            let _e1732 = local_1.len;
                            if (_e1732 == 0u) {
                                phi_2457_ = false;
                            } else {
                                let _e1736 = local_1.len;
                                local_1.len = (_e1736 - 1u);
                                let _e1739 = local_1.len;
                                if (_e1739 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1744 = local_1.first[(0u + _e1739)];
                                local_1.group = _e1744;
                                let _e1747 = local_1.len;
                                if (_e1747 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1752 = local_1.mask[(0u + _e1747)];
                                local_1.group_mask = _e1752;
                                phi_2457_ = true;
                            }
                            let _e1755 = phi_2457_;
                            phi_2458_ = _e1755;
                        } else {
                            phi_2458_ = true;
                        }
                        let _e1757 = phi_2458_;
                        if _e1757 {
                            let _e1759 = local_1.group_mask;
                            let _e1765 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1759)), 32u, (_e1759 == 0u)));
                            let _e1769 = local_1.group_mask;
                            let _e1783 = local_1.group_mask;
                            local_1.group_mask = (_e1783 & ~((1u << bitcast<u32>((_e1765 & 31u)))));
                            let _e1786 = local_1.group;
                            phi_2489_ = (_e1786 + countOneBits(((_e1769 & ~((4294967295u << bitcast<u32>((((_e1765 - 24u) ^ _e426) & 31u))))) & 255u)));
                        } else {
                            phi_2489_ = 4294967295u;
                        }
                        let _e1789 = phi_2489_;
                        let _e2566 = local_5;
                        phi_1223_ = _e2566;
                        phi_1226_ = _e1789;
                    } else {
                        phi_1223_ = lt_bvh_Hit();
                        phi_1226_ = u32();
                    }
                    let _e1791 = phi_1223_;
                    let _e1793 = phi_1226_;
                    continue;
                    continuing {
                        phi_1222_ = _e1791;
                        phi_1225_ = _e1793;
                        break if !(_e567);
                    }
                }
                let _e2570 = local_6;
                phi_2490_ = _e2570;
            }
            let _e1796 = phi_2490_;
            phi_2491_ = _e1796;
            phi_2492_ = _e223;
        } else {
            phi_2491_ = lt_bvh_Hit();
            phi_2492_ = true;
        }
        let _e1798 = phi_2491_;
        let _e1800 = phi_2492_;
        if _e1800 {
            phi_2496_ = _e161;
        } else {
            phi_2496_ = _e1798;
        }
        let _e1802 = phi_2496_;
        if (_e1802.triangle != 4294967295u) {
            let _e1808 = ((1f - _e1802.u) - _e1802.v);
            if (_e1802.triangle < _e80) {
            } else {
                return;
            }
            let _e1814 = triangles.member[(0u + _e1802.triangle)];
            let _e1839 = (((_e1814.v0_.x * _e1808) + (_e1814.v1_.x * _e1802.u)) + (_e1814.v2_.x * _e1802.v));
            let _e1840 = (((_e1814.v0_.y * _e1808) + (_e1814.v1_.y * _e1802.u)) + (_e1814.v2_.y * _e1802.v));
            let _e1841 = (((_e1814.v0_.z * _e1808) + (_e1814.v1_.z * _e1802.u)) + (_e1814.v2_.z * _e1802.v));
            let _e1844 = abs(_e1814.v0_.x);
            let _e1846 = abs(_e1814.v0_.y);
            let _e1848 = abs(_e1814.v0_.z);
            let _e1850 = abs(_e1814.v1_.x);
            let _e1852 = abs(_e1814.v1_.y);
            let _e1854 = abs(_e1814.v1_.z);
            if (_e1844 > _e1850) {
                phi_2561_ = _e1844;
            } else {
                phi_2561_ = _e1850;
            }
            let _e1857 = phi_2561_;
            if (_e1846 > _e1852) {
                phi_2566_ = _e1846;
            } else {
                phi_2566_ = _e1852;
            }
            let _e1860 = phi_2566_;
            if (_e1848 > _e1854) {
                phi_2571_ = _e1848;
            } else {
                phi_2571_ = _e1854;
            }
            let _e1863 = phi_2571_;
            let _e1865 = abs(_e1814.v2_.x);
            let _e1867 = abs(_e1814.v2_.y);
            let _e1869 = abs(_e1814.v2_.z);
            if (_e1857 > _e1865) {
                phi_2582_ = _e1857;
            } else {
                phi_2582_ = _e1865;
            }
            let _e1872 = phi_2582_;
            if (_e1860 > _e1867) {
                phi_2587_ = _e1860;
            } else {
                phi_2587_ = _e1867;
            }
            let _e1875 = phi_2587_;
            if (_e1863 > _e1869) {
                phi_2592_ = _e1863;
            } else {
                phi_2592_ = _e1869;
            }
            let _e1878 = phi_2592_;
            let _e1881 = (_e1814.v1_.x - _e1814.v0_.x);
            let _e1884 = (_e1814.v1_.y - _e1814.v0_.y);
            let _e1887 = (_e1814.v1_.z - _e1814.v0_.z);
            let _e1890 = (_e1814.v2_.x - _e1814.v0_.x);
            let _e1893 = (_e1814.v2_.y - _e1814.v0_.y);
            let _e1896 = (_e1814.v2_.z - _e1814.v0_.z);
            let _e1900 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1884), abs(_e1887));
            let _e1901 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1881), _e1900);
            let _e1902 = (_e1881 / _e1901);
            let _e1903 = (_e1884 / _e1901);
            let _e1904 = (_e1887 / _e1901);
            let _e1908 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1893), abs(_e1896));
            let _e1909 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1890), _e1908);
            let _e1910 = (_e1890 / _e1909);
            let _e1911 = (_e1893 / _e1909);
            let _e1912 = (_e1896 / _e1909);
            let _e1915 = ((_e1903 * _e1912) - (_e1911 * _e1904));
            let _e1918 = ((_e1904 * _e1910) - (_e1912 * _e1902));
            let _e1921 = ((_e1902 * _e1911) - (_e1910 * _e1903));
            let _e1923 = p.member.eye;
            let _e1936 = (1f / sqrt((((_e1915 * _e1915) + (_e1918 * _e1918)) + (_e1921 * _e1921))));
            let _e1937 = (_e1915 * _e1936);
            let _e1938 = (_e1918 * _e1936);
            let _e1939 = (_e1921 * _e1936);
            if ((((_e1937 * (_e1923.x - _e1839)) + (_e1938 * (_e1923.y - _e1840))) + (_e1939 * (_e1923.z - _e1841))) < 0f) {
                phi_2668_ = vec3<f32>(-(_e1937), -(_e1938), -(_e1939));
            } else {
                phi_2668_ = vec3<f32>(_e1937, _e1938, _e1939);
            }
            let _e1952 = phi_2668_;
            if (_e1802.triangle < _e80) {
            } else {
                return;
            }
            let _e1957 = triangles.member[(0u + _e1802.triangle)];
            let _e1959 = (_e1957.i0_ & 2147483647u);
            if (_e1959 < _e83) {
            } else {
                return;
            }
            let _e1965 = vertices.member[(0u + _e1959)];
            if (_e1957.i1_ < _e83) {
            } else {
                return;
            }
            let _e1969 = vertices.member[(0u + _e1957.i1_)];
            if (_e1957.i2_ < _e83) {
            } else {
                return;
            }
            let _e1973 = vertices.member[(0u + _e1957.i2_)];
            let _e1974 = array<abi_Vertex, 3>(_e1965, _e1969, _e1973);
            if (_e1974[0].material < _e86) {
            } else {
                return;
            }
            let _e1980 = materials.member[(0u + _e1974[0].material)];
            let _e1997 = (1f / 255f);
            let _e2016 = (1f / 255f);
            let _e2038 = (1f / 255f);
            let _e2051 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1808, _e1802.u, _e1802.v));
            let _e2053 = ((_e1980.base_color.x * ((((f32((_e1974[0].color & 255u)) * _e1997) * _e1808) + ((f32((_e1974[1].color & 255u)) * _e2016) * _e1802.u)) + ((f32((_e1974[2].color & 255u)) * _e2038) * _e1802.v))) * _e2051.x);
            let _e2055 = ((_e1980.base_color.y * ((((f32(((_e1974[0].color >> bitcast<u32>(8i)) & 255u)) * _e1997) * _e1808) + ((f32(((_e1974[1].color >> bitcast<u32>(8i)) & 255u)) * _e2016) * _e1802.u)) + ((f32(((_e1974[2].color >> bitcast<u32>(8i)) & 255u)) * _e2038) * _e1802.v))) * _e2051.y);
            let _e2057 = ((_e1980.base_color.z * ((((f32(((_e1974[0].color >> bitcast<u32>(16i)) & 255u)) * _e1997) * _e1808) + ((f32(((_e1974[1].color >> bitcast<u32>(16i)) & 255u)) * _e2016) * _e1802.u)) + ((f32(((_e1974[2].color >> bitcast<u32>(16i)) & 255u)) * _e2038) * _e1802.v))) * _e2051.z);
            let _e2058 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1875, _e1878);
            let _e2059 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1872, _e2058);
            if ((_e1980.flags & 2u) == 0u) {
                phi_2789_ = 0u;
            } else {
                phi_2789_ = 1u;
            }
            let _e2064 = phi_2789_;
            if (_e1974[0].normal == 2147516416u) {
                phi_2992_ = _e1952;
            } else {
                let _e2077 = (f32((bitcast<i32>((_e1974[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2083 = (f32((bitcast<i32>(_e1974[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2087 = ((1f - abs(_e2077)) - abs(_e2083));
                if (_e2087 < 0f) {
                    phi_2816_ = -(_e2087);
                } else {
                    phi_2816_ = 0f;
                }
                let _e2091 = phi_2816_;
                if (_e2077 < 0f) {
                    phi_2823_ = (_e2077 + _e2091);
                } else {
                    phi_2823_ = (_e2077 - _e2091);
                }
                let _e2096 = phi_2823_;
                if (_e2083 < 0f) {
                    phi_2830_ = (_e2083 + _e2091);
                } else {
                    phi_2830_ = (_e2083 - _e2091);
                }
                let _e2101 = phi_2830_;
                let _e2108 = (1f / sqrt((((_e2096 * _e2096) + (_e2101 * _e2101)) + (_e2087 * _e2087))));
                let _e2124 = (f32((bitcast<i32>((_e1974[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2130 = (f32((bitcast<i32>(_e1974[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2134 = ((1f - abs(_e2124)) - abs(_e2130));
                if (_e2134 < 0f) {
                    phi_2865_ = -(_e2134);
                } else {
                    phi_2865_ = 0f;
                }
                let _e2138 = phi_2865_;
                if (_e2124 < 0f) {
                    phi_2872_ = (_e2124 + _e2138);
                } else {
                    phi_2872_ = (_e2124 - _e2138);
                }
                let _e2143 = phi_2872_;
                if (_e2130 < 0f) {
                    phi_2879_ = (_e2130 + _e2138);
                } else {
                    phi_2879_ = (_e2130 - _e2138);
                }
                let _e2148 = phi_2879_;
                let _e2155 = (1f / sqrt((((_e2143 * _e2143) + (_e2148 * _e2148)) + (_e2134 * _e2134))));
                let _e2174 = (f32((bitcast<i32>((_e1974[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2180 = (f32((bitcast<i32>(_e1974[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2184 = ((1f - abs(_e2174)) - abs(_e2180));
                if (_e2184 < 0f) {
                    phi_2917_ = -(_e2184);
                } else {
                    phi_2917_ = 0f;
                }
                let _e2188 = phi_2917_;
                if (_e2174 < 0f) {
                    phi_2924_ = (_e2174 + _e2188);
                } else {
                    phi_2924_ = (_e2174 - _e2188);
                }
                let _e2193 = phi_2924_;
                if (_e2180 < 0f) {
                    phi_2931_ = (_e2180 + _e2188);
                } else {
                    phi_2931_ = (_e2180 - _e2188);
                }
                let _e2198 = phi_2931_;
                let _e2205 = (1f / sqrt((((_e2193 * _e2193) + (_e2198 * _e2198)) + (_e2184 * _e2184))));
                let _e2216 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2096 * _e2108) * _e1808) + ((_e2143 * _e2155) * _e1802.u)) + ((_e2193 * _e2205) * _e1802.v)), ((((_e2101 * _e2108) * _e1808) + ((_e2148 * _e2155) * _e1802.u)) + ((_e2198 * _e2205) * _e1802.v)), ((((_e2087 * _e2108) * _e1808) + ((_e2134 * _e2155) * _e1802.u)) + ((_e2184 * _e2205) * _e1802.v))));
                let _e2228 = sqrt((((_e2216.x * _e2216.x) + (_e2216.y * _e2216.y)) + (_e2216.z * _e2216.z)));
                if (_e2228 > 0f) {
                    let _e2231 = (_e2216.x / _e2228);
                    let _e2233 = (_e2216.y / _e2228);
                    let _e2235 = (_e2216.z / _e2228);
                    if ((((_e2231 * _e1952.x) + (_e2233 * _e1952.y)) + (_e2235 * _e1952.z)) < 0f) {
                        phi_2990_ = vec3<f32>(-(_e2231), -(_e2233), -(_e2235));
                    } else {
                        phi_2990_ = (_e2216 / vec3(_e2228));
                    }
                    let _e2252 = phi_2990_;
                    phi_2991_ = _e2252;
                } else {
                    phi_2991_ = _e1952;
                }
                let _e2254 = phi_2991_;
                phi_2992_ = _e2254;
            }
            let _e2256 = phi_2992_;
            if (_e2053 > 0f) {
                if (_e2053 < 1f) {
                    phi_3001_ = _e2053;
                } else {
                    phi_3001_ = 1f;
                }
                let _e2260 = phi_3001_;
                phi_3002_ = _e2260;
            } else {
                phi_3002_ = 0f;
            }
            let _e2262 = phi_3002_;
            if (_e2055 > 0f) {
                if (_e2055 < 1f) {
                    phi_3012_ = _e2055;
                } else {
                    phi_3012_ = 1f;
                }
                let _e2267 = phi_3012_;
                phi_3013_ = _e2267;
            } else {
                phi_3013_ = 0f;
            }
            let _e2269 = phi_3013_;
            if (_e2057 > 0f) {
                if (_e2057 < 1f) {
                    phi_3023_ = _e2057;
                } else {
                    phi_3023_ = 1f;
                }
                let _e2274 = phi_3023_;
                phi_3024_ = _e2274;
            } else {
                phi_3024_ = 0f;
            }
            let _e2276 = phi_3024_;
            let _e2279 = ((sqrt(_e2262) * 255f) + 0.5f);
            let _e2288 = ((sqrt(_e2269) * 255f) + 0.5f);
            let _e2300 = ((sqrt(_e2276) * 255f) + 0.5f);
            phi_3059_ = abi_Sample(vec3<f32>(_e1839, _e1840, _e1841), _e2059, _e1952, _e2064, _e2256, ((select(select(u32(_e2279), 0u, (_e2279 < bitcast<f32>(0u))), 4294967295u, (_e2279 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2288), 0u, (_e2288 < bitcast<f32>(0u))), 4294967295u, (_e2288 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2300), 0u, (_e2300 < bitcast<f32>(0u))), 4294967295u, (_e2300 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3059_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2314 = phi_3059_;
        if (_e104.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e104.shift)] = _e2314;
        if (_e1802.triangle != 4294967295u) {
            let _e2323 = ((1f - _e1802.u) - _e1802.v);
            if (_e1802.triangle < _e80) {
            } else {
                return;
            }
            let _e2328 = triangles.member[(0u + _e1802.triangle)];
            let _e2330 = (_e2328.i0_ & 2147483647u);
            if (_e2330 < _e95) {
            } else {
                return;
            }
            let _e2336 = before.member[(0u + _e2330)];
            if (_e2328.i1_ < _e95) {
            } else {
                return;
            }
            let _e2340 = before.member[(0u + _e2328.i1_)];
            if (_e2328.i2_ < _e95) {
            } else {
                return;
            }
            let _e2344 = before.member[(0u + _e2328.i2_)];
            let _e2349 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2336.x, _e2336.y, _e2336.z));
            let _e2360 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2340.x, _e2340.y, _e2340.z));
            let _e2374 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2344.x, _e2344.y, _e2344.z));
            phi_3150_ = vec3<f32>((((_e2349.x * _e2323) + (_e2360.x * _e1802.u)) + (_e2374.x * _e1802.v)), (((_e2349.y * _e2323) + (_e2360.y * _e1802.u)) + (_e2374.y * _e1802.v)), (((_e2349.z * _e2323) + (_e2360.z * _e1802.u)) + (_e2374.z * _e1802.v)));
        } else {
            phi_3150_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2386 = phi_3150_;
        if (_e104.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e104.shift)] = vec4<f32>(_e2386.x, _e2386.y, _e2386.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
