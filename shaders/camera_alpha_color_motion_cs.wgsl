struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
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
        let _e86 = phi_222_;
        let _e88 = phi_223_;
        phi_224_ = _e86;
        phi_225_ = _e88;
    } else {
        phi_224_ = lt_mask_LightPlace();
        phi_225_ = true;
    }
    let _e90 = phi_224_;
    let _e92 = phi_225_;
    if _e92 {
        phi_230_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_230_ = _e90;
    }
    let _e97 = phi_230_;
    return lt_mask_LightPlace(_e97.word, _e97.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_245_: bool;
    var phi_249_: f32;

    if (param_3 != param_3) {
        phi_245_ = true;
    } else {
        let _e76 = (param_4 >= param_3);
        if _e76 {
        }
        phi_245_ = _e76;
    }
    let _e78 = phi_245_;
    if _e78 {
        phi_249_ = param_4;
    } else {
        phi_249_ = param_3;
    }
    let _e80 = phi_249_;
    return _e80;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_261_: bool;
    var phi_265_: f32;

    if (param_5 != param_5) {
        phi_261_ = true;
    } else {
        let _e76 = (param_6 <= param_5);
        if _e76 {
        }
        phi_261_ = _e76;
    }
    let _e78 = phi_261_;
    if _e78 {
        phi_265_ = param_6;
    } else {
        phi_265_ = param_5;
    }
    let _e80 = phi_265_;
    return _e80;
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

    let _e77 = (*param_7).size;
    let _e78 = (_e77 & 65535u);
    let _e80 = (*param_7).size;
    let _e82 = (_e80 >> bitcast<u32>(16i));
    let _e84 = (*param_7).flags;
    let _e86 = ((_e84 & 4u) != 0u);
    let _e88 = (*param_7).flags;
    let _e91 = ((_e88 >> bitcast<u32>(4u)) & 3u);
    if (_e91 == 0u) {
        if (param_8 > -8388608f) {
            let _e104 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e104 > param_8) {
                phi_307_ = 1f;
            } else {
                phi_307_ = 0f;
            }
            let _e107 = phi_307_;
            if (param_8 < 8388608f) {
                phi_312_ = (_e104 - _e107);
                phi_313_ = false;
            } else {
                phi_312_ = f32();
                phi_313_ = true;
            }
            let _e110 = phi_312_;
            let _e112 = phi_313_;
            phi_314_ = _e110;
            phi_315_ = _e112;
        } else {
            phi_314_ = f32();
            phi_315_ = true;
        }
        let _e114 = phi_314_;
        let _e116 = phi_315_;
        if _e116 {
            phi_319_ = param_8;
        } else {
            phi_319_ = _e114;
        }
        let _e118 = phi_319_;
        phi_367_ = (param_8 - _e118);
    } else {
        if (_e91 == 1u) {
            let _e121 = (param_8 * 0.5f);
            if (_e121 > -8388608f) {
                let _e133 = f32(select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)));
                if (_e133 > _e121) {
                    phi_345_ = 1f;
                } else {
                    phi_345_ = 0f;
                }
                let _e136 = phi_345_;
                if (_e121 < 8388608f) {
                    phi_350_ = (_e133 - _e136);
                    phi_351_ = false;
                } else {
                    phi_350_ = f32();
                    phi_351_ = true;
                }
                let _e139 = phi_350_;
                let _e141 = phi_351_;
                phi_352_ = _e139;
                phi_353_ = _e141;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e143 = phi_352_;
            let _e145 = phi_353_;
            if _e145 {
                phi_357_ = _e121;
            } else {
                phi_357_ = _e143;
            }
            let _e147 = phi_357_;
            let _e149 = (param_8 - (2f * _e147));
            if (_e149 > 1f) {
                phi_365_ = (2f - _e149);
            } else {
                phi_365_ = _e149;
            }
            let _e153 = phi_365_;
            phi_366_ = _e153;
        } else {
            phi_366_ = param_8;
        }
        let _e155 = phi_366_;
        phi_367_ = _e155;
    }
    let _e157 = phi_367_;
    if (_e157 > 0f) {
        if (_e157 < 1f) {
            phi_376_ = _e157;
        } else {
            phi_376_ = 1f;
        }
        let _e161 = phi_376_;
        phi_377_ = _e161;
    } else {
        phi_377_ = 0f;
    }
    let _e163 = phi_377_;
    let _e164 = (_e78 - 1u);
    let _e166 = (_e163 * f32(_e78));
    if _e86 {
        let _e173 = select(select(u32(_e166), 0u, (_e166 < bitcast<f32>(0u))), 4294967295u, (_e166 > bitcast<f32>(1333788671u)));
        if (_e164 < _e173) {
            phi_395_ = _e164;
        } else {
            phi_395_ = _e173;
        }
        let _e176 = phi_395_;
        phi_434_ = texture_Axis(_e176, _e176, 0f);
    } else {
        let _e178 = (_e166 + 0.5f);
        let _e185 = select(select(u32(_e178), 0u, (_e178 < bitcast<f32>(0u))), 4294967295u, (_e178 > bitcast<f32>(1333788671u)));
        if (_e78 < _e185) {
            phi_409_ = _e78;
        } else {
            phi_409_ = _e185;
        }
        let _e188 = phi_409_;
        if (_e91 == 0u) {
            phi_416_ = _e164;
        } else {
            phi_416_ = 0u;
        }
        let _e193 = phi_416_;
        if (_e91 == 0u) {
            phi_421_ = 0u;
        } else {
            phi_421_ = _e164;
        }
        let _e196 = phi_421_;
        if (_e188 == 0u) {
            phi_427_ = _e193;
        } else {
            phi_427_ = (_e188 - 1u);
        }
        let _e200 = phi_427_;
        if (_e188 > _e164) {
            phi_432_ = _e196;
        } else {
            phi_432_ = _e188;
        }
        let _e203 = phi_432_;
        phi_434_ = texture_Axis(_e200, _e203, (_e178 - f32(_e188)));
    }
    let _e206 = phi_434_;
    let _e208 = (*param_7).flags;
    let _e211 = ((_e208 >> bitcast<u32>(6u)) & 3u);
    if (_e211 == 0u) {
        if (param_9 > -8388608f) {
            let _e224 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e224 > param_9) {
                phi_462_ = 1f;
            } else {
                phi_462_ = 0f;
            }
            let _e227 = phi_462_;
            if (param_9 < 8388608f) {
                phi_467_ = (_e224 - _e227);
                phi_468_ = false;
            } else {
                phi_467_ = f32();
                phi_468_ = true;
            }
            let _e230 = phi_467_;
            let _e232 = phi_468_;
            phi_469_ = _e230;
            phi_470_ = _e232;
        } else {
            phi_469_ = f32();
            phi_470_ = true;
        }
        let _e234 = phi_469_;
        let _e236 = phi_470_;
        if _e236 {
            phi_474_ = param_9;
        } else {
            phi_474_ = _e234;
        }
        let _e238 = phi_474_;
        phi_522_ = (param_9 - _e238);
    } else {
        if (_e211 == 1u) {
            let _e241 = (param_9 * 0.5f);
            if (_e241 > -8388608f) {
                let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
                if (_e253 > _e241) {
                    phi_500_ = 1f;
                } else {
                    phi_500_ = 0f;
                }
                let _e256 = phi_500_;
                if (_e241 < 8388608f) {
                    phi_505_ = (_e253 - _e256);
                    phi_506_ = false;
                } else {
                    phi_505_ = f32();
                    phi_506_ = true;
                }
                let _e259 = phi_505_;
                let _e261 = phi_506_;
                phi_507_ = _e259;
                phi_508_ = _e261;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e263 = phi_507_;
            let _e265 = phi_508_;
            if _e265 {
                phi_512_ = _e241;
            } else {
                phi_512_ = _e263;
            }
            let _e267 = phi_512_;
            let _e269 = (param_9 - (2f * _e267));
            if (_e269 > 1f) {
                phi_520_ = (2f - _e269);
            } else {
                phi_520_ = _e269;
            }
            let _e273 = phi_520_;
            phi_521_ = _e273;
        } else {
            phi_521_ = param_9;
        }
        let _e275 = phi_521_;
        phi_522_ = _e275;
    }
    let _e277 = phi_522_;
    if (_e277 > 0f) {
        if (_e277 < 1f) {
            phi_531_ = _e277;
        } else {
            phi_531_ = 1f;
        }
        let _e281 = phi_531_;
        phi_532_ = _e281;
    } else {
        phi_532_ = 0f;
    }
    let _e283 = phi_532_;
    let _e284 = (_e82 - 1u);
    let _e286 = (_e283 * f32(_e82));
    if _e86 {
        let _e293 = select(select(u32(_e286), 0u, (_e286 < bitcast<f32>(0u))), 4294967295u, (_e286 > bitcast<f32>(1333788671u)));
        if (_e284 < _e293) {
            phi_550_ = _e284;
        } else {
            phi_550_ = _e293;
        }
        let _e296 = phi_550_;
        phi_589_ = texture_Axis(_e296, _e296, 0f);
    } else {
        let _e298 = (_e286 + 0.5f);
        let _e305 = select(select(u32(_e298), 0u, (_e298 < bitcast<f32>(0u))), 4294967295u, (_e298 > bitcast<f32>(1333788671u)));
        if (_e82 < _e305) {
            phi_564_ = _e82;
        } else {
            phi_564_ = _e305;
        }
        let _e308 = phi_564_;
        if (_e211 == 0u) {
            phi_571_ = _e284;
        } else {
            phi_571_ = 0u;
        }
        let _e313 = phi_571_;
        if (_e211 == 0u) {
            phi_576_ = 0u;
        } else {
            phi_576_ = _e284;
        }
        let _e316 = phi_576_;
        if (_e308 == 0u) {
            phi_582_ = _e313;
        } else {
            phi_582_ = (_e308 - 1u);
        }
        let _e320 = phi_582_;
        if (_e308 > _e284) {
            phi_587_ = _e316;
        } else {
            phi_587_ = _e308;
        }
        let _e323 = phi_587_;
        phi_589_ = texture_Axis(_e320, _e323, (_e298 - f32(_e308)));
    }
    let _e326 = phi_589_;
    let _e330 = (*param_7).offset;
    let _e337 = (*param_7).offset;
    let _e344 = (*param_7).offset;
    let _e351 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e330 + (_e326.low * _e78)) + _e206.low), ((_e337 + (_e326.low * _e78)) + _e206.high), ((_e344 + (_e326.high * _e78)) + _e206.low), ((_e351 + (_e326.high * _e78)) + _e206.high)), vec4<f32>(((1f - _e206.fraction) * (1f - _e326.fraction)), (_e206.fraction * (1f - _e326.fraction)), ((1f - _e206.fraction) * _e326.fraction), (_e206.fraction * _e326.fraction)));
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
    let _e77 = phi_648_;
    return _e77;
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
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_807_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_827_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_854_: bool;
    var phi_930_: f32;
    var phi_937_: f32;
    var phi_945_: f32;
    var phi_952_: f32;
    var phi_960_: f32;
    var phi_967_: f32;
    var phi_990_: f32;
    var phi_995_: f32;
    var phi_1000_: f32;
    var phi_1005_: f32;
    var phi_1010_: f32;
    var phi_1041_: bool;
    var phi_1042_: bool;
    var phi_1050_: u32;
    var phi_1051_: u32;
    var phi_1068_: vec3<f32>;
    var phi_1069_: vec3<f32>;
    var phi_1082_: u32;
    var phi_1087_: u32;
    var phi_1092_: u32;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1238_: u32;
    var phi_1240_: lt_bvh_Hit;
    var phi_1243_: u32;
    var phi_1328_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1355_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1382_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1388_: u32;
    var phi_1391_: u32;
    var phi_1405_: u32;
    var phi_1415_: u32;
    var phi_1425_: u32;
    var phi_1443_: u32;
    var phi_1453_: u32;
    var phi_1463_: u32;
    var phi_1499_: u32;
    var phi_1512_: u32;
    var phi_1517_: u32;
    var phi_1518_: u32;
    var phi_1519_: u32;
    var phi_1389_: u32;
    var phi_1392_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1577_: lt_bvh_Hit;
    var phi_1580_: u32;
    var phi_1626_: vec3<f32>;
    var phi_1627_: vec3<f32>;
    var phi_1658_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1690_: vec3<f32>;
    var phi_1691_: vec3<f32>;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1714_: f32;
    var phi_1715_: f32;
    var phi_1716_: f32;
    var phi_1717_: f32;
    var phi_1725_: f32;
    var phi_1735_: bool;
    var phi_1736_: bool;
    var phi_1740_: f32;
    var phi_1741_: f32;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1751_: f32;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1766_: f32;
    var phi_1767_: f32;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1777_: f32;
    var phi_1792_: f32;
    var phi_1793_: bool;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1796_: f32;
    var phi_1797_: bool;
    var phi_1815_: f32;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1818_: f32;
    var phi_1819_: bool;
    var phi_1820_: bool;
    var phi_1824_: bool;
    var phi_1825_: f32;
    var phi_1826_: bool;
    var phi_1856_: vec3<f32>;
    var phi_1857_: vec3<f32>;
    var phi_1882_: vec3<f32>;
    var phi_1883_: vec3<f32>;
    var phi_1908_: vec3<f32>;
    var phi_1909_: vec3<f32>;
    var phi_1967_: f32;
    var phi_1976_: f32;
    var phi_1985_: f32;
    var phi_1994_: f32;
    var phi_2001_: f32;
    var phi_2008_: f32;
    var phi_2021_: f32;
    var phi_2030_: f32;
    var phi_2039_: f32;
    var phi_2048_: f32;
    var phi_2055_: f32;
    var phi_2062_: f32;
    var phi_2085_: f32;
    var phi_2090_: f32;
    var phi_2095_: f32;
    var phi_2103_: f32;
    var phi_2108_: f32;
    var phi_2113_: f32;
    var phi_2125_: f32;
    var phi_2130_: f32;
    var phi_2135_: f32;
    var phi_2140_: f32;
    var phi_2145_: lt_bvh_triangle_Intersection;
    var phi_2146_: bool;
    var phi_2147_: lt_bvh_triangle_Intersection;
    var phi_2148_: bool;
    var phi_2152_: lt_bvh_triangle_Intersection;
    var phi_2153_: bool;
    var phi_2154_: lt_bvh_triangle_Intersection;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var phi_2160_: bool;
    var phi_2164_: lt_bvh_triangle_Intersection;
    var phi_2203_: bool;
    var phi_2204_: bool;
    var phi_2205_: bool;
    var phi_2206_: bool;
    var phi_2207_: bool;
    var phi_2208_: bool;
    var phi_2212_: bool;
    var phi_2213_: bool;
    var phi_2416_: f32;
    var phi_2419_: bool;
    var phi_2420_: bool;
    var phi_2424_: bool;
    var phi_2432_: lt_bvh_Hit;
    var phi_2433_: lt_bvh_Hit;
    var phi_2434_: lt_bvh_Hit;
    var phi_2435_: lt_bvh_Hit;
    var phi_1578_: lt_bvh_Hit;
    var phi_1581_: u32;
    var phi_2436_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2507_: u32;
    var phi_1241_: lt_bvh_Hit;
    var phi_1244_: u32;
    var phi_2508_: lt_bvh_Hit;
    var phi_2509_: lt_bvh_Hit;
    var phi_2510_: bool;
    var phi_2514_: lt_bvh_Hit;
    var phi_2578_: f32;
    var phi_2583_: f32;
    var phi_2588_: f32;
    var phi_2599_: f32;
    var phi_2604_: f32;
    var phi_2609_: f32;
    var phi_2685_: vec3<f32>;
    var phi_2928_: vec3<f32>;
    var phi_2943_: u32;
    var phi_2970_: f32;
    var phi_2977_: f32;
    var phi_2984_: f32;
    var phi_3019_: f32;
    var phi_3026_: f32;
    var phi_3033_: f32;
    var phi_3071_: f32;
    var phi_3078_: f32;
    var phi_3085_: f32;
    var phi_3144_: vec3<f32>;
    var phi_3145_: vec3<f32>;
    var phi_3146_: vec3<f32>;
    var phi_3155_: f32;
    var phi_3156_: f32;
    var phi_3166_: f32;
    var phi_3167_: f32;
    var phi_3177_: f32;
    var phi_3178_: f32;
    var phi_3213_: abi_Sample;
    var phi_3304_: vec3<f32>;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e76 = id_1;
    let _e80 = arrayLength((&nodes.member));
    let _e83 = arrayLength((&triangles.member));
    let _e86 = arrayLength((&vertices.member));
    let _e89 = arrayLength((&materials.member));
    let _e95 = arrayLength((&alpha_texels.member));
    let _e98 = arrayLength((&color_texels.member));
    let _e101 = arrayLength((&before.member));
    let _e107 = p.member.size[0u];
    let _e109 = p.member.size[1u];
    let _e110 = lt_shaders_entry_pixel_index(_e76, _e107, _e109);
    if (bitcast<i32>(_e110.word) != 0i) {
        let _e118 = p.member.eye;
        let _e121 = p.member.grid[0u];
        let _e123 = p.member.grid[1u];
        let _e142 = p.member.size[0u];
        let _e146 = ((((f32(_e76.x) + ((f32((_e76.y & (_e123 - 1u))) + 0.5f) / f32(_e123))) / f32(_e142)) * 2f) - 1f);
        let _e149 = p.member.size[1u];
        let _e153 = (1f - (((f32(_e76.y) + ((f32((_e76.x & (_e121 - 1u))) + 0.5f) / f32(_e121))) / f32(_e149)) * 2f));
        let _e155 = p.member.forward;
        let _e157 = p.member.right;
        let _e171 = p.member.up;
        let _e182 = _lt_bvh_ray_Ray_new(_e118, vec3<f32>(((_e155.x + (_e157.x * _e146)) + (_e171.x * _e153)), ((_e155.y + (_e157.y * _e146)) + (_e171.y * _e153)), ((_e155.z + (_e157.z * _e146)) + (_e171.z * _e153))));
        let _e184 = lt_bvh_Hit(_e182.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e187 = abs(_e182.direction.x);
        let _e189 = abs(_e182.direction.y);
        let _e191 = abs(_e182.direction.z);
        if (abs(_e182.origin.x) < 1000000000000000f) {
            if (abs(_e182.origin.y) < 1000000000000000f) {
                phi_800_ = (abs(_e182.origin.z) < 1000000000000000f);
                phi_801_ = false;
            } else {
                phi_800_ = bool();
                phi_801_ = true;
            }
            let _e203 = phi_800_;
            let _e205 = phi_801_;
            phi_802_ = _e203;
            phi_803_ = _e205;
        } else {
            phi_802_ = bool();
            phi_803_ = true;
        }
        let _e207 = phi_802_;
        let _e209 = phi_803_;
        if _e209 {
            phi_807_ = false;
        } else {
            phi_807_ = _e207;
        }
        let _e211 = phi_807_;
        if _e211 {
            if (_e187 < 1000000000000000f) {
                if (_e189 < 1000000000000000f) {
                    phi_820_ = (_e191 < 1000000000000000f);
                    phi_821_ = false;
                } else {
                    phi_820_ = bool();
                    phi_821_ = true;
                }
                let _e216 = phi_820_;
                let _e218 = phi_821_;
                phi_822_ = _e216;
                phi_823_ = _e218;
            } else {
                phi_822_ = bool();
                phi_823_ = true;
            }
            let _e220 = phi_822_;
            let _e222 = phi_823_;
            if _e222 {
                phi_827_ = false;
            } else {
                phi_827_ = _e220;
            }
            let _e224 = phi_827_;
            if _e224 {
                if (_e187 > 0f) {
                    phi_841_ = bool();
                    phi_842_ = true;
                } else {
                    let _e226 = (_e189 > 0f);
                    if _e226 {
                        phi_840_ = bool();
                    } else {
                        phi_840_ = (_e191 > 0f);
                    }
                    let _e229 = phi_840_;
                    phi_841_ = _e229;
                    phi_842_ = _e226;
                }
                let _e231 = phi_841_;
                let _e233 = phi_842_;
                if _e233 {
                    phi_846_ = true;
                } else {
                    phi_846_ = _e231;
                }
                let _e235 = phi_846_;
                phi_847_ = _e235;
                phi_848_ = false;
            } else {
                phi_847_ = bool();
                phi_848_ = true;
            }
            let _e237 = phi_847_;
            let _e239 = phi_848_;
            phi_849_ = _e237;
            phi_850_ = _e239;
        } else {
            phi_849_ = bool();
            phi_850_ = true;
        }
        let _e241 = phi_849_;
        let _e243 = phi_850_;
        if _e243 {
            phi_854_ = false;
        } else {
            phi_854_ = _e241;
        }
        let _e245 = phi_854_;
        if _e245 {
            let _e246 = (0u >= _e80);
            if _e246 {
                phi_2508_ = lt_bvh_Hit();
            } else {
                if (0u < _e80) {
                } else {
                    return;
                }
                let _e252 = nodes.member[(0u + 0u)].frame[0u];
                let _e256 = nodes.member[(0u + 0u)].frame[1u];
                let _e260 = nodes.member[(0u + 0u)].frame[2u];
                let _e264 = nodes.member[(0u + 0u)].frame[0u];
                let _e268 = nodes.member[(0u + 0u)].frame[1u];
                let _e272 = nodes.member[(0u + 0u)].frame[2u];
                let _e276 = nodes.member[(0u + 0u)].frame[3u];
                let _e315 = core_intrinsics_maximum_number_nsz_f32_(abs(_e182.direction.x), abs(_e182.direction.y));
                let _e316 = core_intrinsics_maximum_number_nsz_f32_(_e315, abs(_e182.direction.z));
                let _e317 = (_e316 * 0.0000000000009094947f);
                if (abs(_e182.direction.x) < _e317) {
                    phi_930_ = _e317;
                } else {
                    phi_930_ = abs(_e182.direction.x);
                }
                let _e323 = phi_930_;
                if (_e182.direction.x < 0f) {
                    phi_937_ = (-1f / _e323);
                } else {
                    phi_937_ = (1f / _e323);
                }
                let _e328 = phi_937_;
                if (abs(_e182.direction.y) < _e317) {
                    phi_945_ = _e317;
                } else {
                    phi_945_ = abs(_e182.direction.y);
                }
                let _e334 = phi_945_;
                if (_e182.direction.y < 0f) {
                    phi_952_ = (-1f / _e334);
                } else {
                    phi_952_ = (1f / _e334);
                }
                let _e339 = phi_952_;
                if (abs(_e182.direction.z) < _e317) {
                    phi_960_ = _e317;
                } else {
                    phi_960_ = abs(_e182.direction.z);
                }
                let _e345 = phi_960_;
                if (_e182.direction.z < 0f) {
                    phi_967_ = (-1f / _e345);
                } else {
                    phi_967_ = (1f / _e345);
                }
                let _e350 = phi_967_;
                let _e357 = abs((bitcast<f32>(_e252) - _e182.origin.x));
                let _e358 = abs((bitcast<f32>(_e256) - _e182.origin.y));
                let _e359 = abs((bitcast<f32>(_e260) - _e182.origin.z));
                let _e366 = abs(((bitcast<f32>(_e264) + (bitcast<f32>((((_e276 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e182.origin.x));
                let _e367 = abs(((bitcast<f32>(_e268) + (bitcast<f32>((((_e276 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e182.origin.y));
                let _e368 = abs(((bitcast<f32>(_e272) + (bitcast<f32>((((_e276 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e182.origin.z));
                if (_e357 > _e366) {
                    phi_990_ = _e357;
                } else {
                    phi_990_ = _e366;
                }
                let _e371 = phi_990_;
                if (_e358 > _e367) {
                    phi_995_ = _e358;
                } else {
                    phi_995_ = _e367;
                }
                let _e374 = phi_995_;
                if (_e359 > _e368) {
                    phi_1000_ = _e359;
                } else {
                    phi_1000_ = _e368;
                }
                let _e377 = phi_1000_;
                if (_e371 > _e374) {
                    phi_1005_ = _e371;
                } else {
                    phi_1005_ = _e374;
                }
                let _e380 = phi_1005_;
                if (_e380 > _e377) {
                    phi_1010_ = _e380;
                } else {
                    phi_1010_ = _e377;
                }
                let _e383 = phi_1010_;
                let _e387 = (_e383 * 0.0000019073486f);
                let _e388 = (abs(_e328) * _e387);
                let _e389 = (abs(_e339) * _e387);
                let _e390 = (abs(_e350) * _e387);
                let _e394 = (_e383 * 0.0000009536743f);
                let _e395 = (abs(_e328) * _e394);
                let _e396 = (abs(_e339) * _e394);
                let _e397 = (abs(_e350) * _e394);
                let _e401 = abs(_e182.direction.x);
                let _e403 = abs(_e182.direction.y);
                let _e405 = abs(_e182.direction.z);
                if (_e401 >= _e403) {
                    if (_e401 >= _e405) {
                        phi_1041_ = false;
                    } else {
                        phi_1041_ = true;
                    }
                    let _e409 = phi_1041_;
                    phi_1042_ = _e409;
                } else {
                    phi_1042_ = true;
                }
                let _e411 = phi_1042_;
                if _e411 {
                    if (_e403 >= _e405) {
                        phi_1050_ = 1u;
                    } else {
                        phi_1050_ = 2u;
                    }
                    let _e414 = phi_1050_;
                    phi_1051_ = _e414;
                } else {
                    phi_1051_ = 0u;
                }
                let _e416 = phi_1051_;
                if (_e416 == 0u) {
                    phi_1069_ = vec3<f32>(_e182.direction.y, _e182.direction.z, _e182.direction.x);
                } else {
                    if (_e416 == 1u) {
                        phi_1068_ = vec3<f32>(_e182.direction.z, _e182.direction.x, _e182.direction.y);
                    } else {
                        phi_1068_ = _e182.direction;
                    }
                    let _e428 = phi_1068_;
                    phi_1069_ = _e428;
                }
                let _e430 = phi_1069_;
                let _e433 = (_e430.x / _e430.z);
                let _e436 = (_e430.y / _e430.z);
                if (_e328 < 0f) {
                    phi_1082_ = 0u;
                } else {
                    phi_1082_ = 1u;
                }
                let _e441 = phi_1082_;
                if (_e339 < 0f) {
                    phi_1087_ = 0u;
                } else {
                    phi_1087_ = 2u;
                }
                let _e444 = phi_1087_;
                if (_e350 < 0f) {
                    phi_1092_ = 0u;
                } else {
                    phi_1092_ = 4u;
                }
                let _e447 = phi_1092_;
                let _e449 = ((_e441 | _e444) | _e447);
                let _e450 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e450.first[0], _e450.first[1], _e450.first[2], _e450.first[3], _e450.first[4], _e450.first[5], _e450.first[6], _e450.first[7], _e450.first[8], _e450.first[9], _e450.first[10], _e450.first[11], _e450.first[12], _e450.first[13], _e450.first[14], _e450.first[15], _e450.first[16], _e450.first[17], _e450.first[18], _e450.first[19], _e450.first[20], _e450.first[21], _e450.first[22], _e450.first[23], _e450.first[24], _e450.first[25], _e450.first[26], _e450.first[27], _e450.first[28], _e450.first[29], _e450.first[30], _e450.first[31]), array<u32, 32>(_e450.mask[0], _e450.mask[1], _e450.mask[2], _e450.mask[3], _e450.mask[4], _e450.mask[5], _e450.mask[6], _e450.mask[7], _e450.mask[8], _e450.mask[9], _e450.mask[10], _e450.mask[11], _e450.mask[12], _e450.mask[13], _e450.mask[14], _e450.mask[15], _e450.mask[16], _e450.mask[17], _e450.mask[18], _e450.mask[19], _e450.mask[20], _e450.mask[21], _e450.mask[22], _e450.mask[23], _e450.mask[24], _e450.mask[25], _e450.mask[26], _e450.mask[27], _e450.mask[28], _e450.mask[29], _e450.mask[30], _e450.mask[31]), _e450.len, _e450.group, _e450.group_mask);
                let _e524 = local_2.group_mask;
                if ((_e524 & 4278190080u) == 0u) {
                    let _e528 = local_2.len;
                    if (_e528 == 0u) {
                        phi_1206_ = false;
                    } else {
                        let _e532 = local_2.len;
                        local_2.len = (_e532 - 1u);
                        let _e535 = local_2.len;
                        if (_e535 < 32u) {
                        } else {
                            return;
                        }
                        let _e540 = local_2.first[(0u + _e535)];
                        local_2.group = _e540;
                        let _e543 = local_2.len;
                        if (_e543 < 32u) {
                        } else {
                            return;
                        }
                        let _e548 = local_2.mask[(0u + _e543)];
                        local_2.group_mask = _e548;
                        phi_1206_ = true;
                    }
                    let _e551 = phi_1206_;
                    phi_1207_ = _e551;
                } else {
                    phi_1207_ = true;
                }
                let _e553 = phi_1207_;
                if _e553 {
                    let _e555 = local_2.group_mask;
                    let _e561 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e555)), 32u, (_e555 == 0u)));
                    let _e565 = local_2.group_mask;
                    let _e579 = local_2.group_mask;
                    local_2.group_mask = (_e579 & ~((1u << bitcast<u32>((_e561 & 31u)))));
                    let _e582 = local_2.group;
                    phi_1238_ = (_e582 + countOneBits(((_e565 & ~((4294967295u << bitcast<u32>((((_e561 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1238_ = 4294967295u;
                }
                let _e585 = phi_1238_;
                phi_1240_ = _e184;
                phi_1243_ = _e585;
                loop {
                    let _e587 = phi_1240_;
                    let _e589 = phi_1243_;
                    local_7 = _e587;
                    let _e590 = (_e589 != 4294967295u);
                    if _e590 {
                        if (_e589 < _e80) {
                        } else {
                            return;
                        }
                        let _e598 = nodes.member[(0u + _e589)].frame[3u];
                        let _e623 = (bitcast<f32>((((_e598 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e624 = (bitcast<f32>((((_e598 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e339);
                        let _e625 = (bitcast<f32>((((_e598 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e350);
                        let _e628 = nodes.member[(0u + _e589)].frame[0u];
                        let _e632 = nodes.member[(0u + _e589)].frame[1u];
                        let _e636 = nodes.member[(0u + _e589)].frame[2u];
                        let _e644 = ((bitcast<f32>(_e628) - _e182.origin.x) * _e328);
                        let _e645 = ((bitcast<f32>(_e632) - _e182.origin.y) * _e339);
                        let _e646 = ((bitcast<f32>(_e636) - _e182.origin.z) * _e350);
                        let _e654 = nodes.member[(0u + _e589)].x;
                        if (_e328 < 0f) {
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e665.unnamed.word, _e654.w), _e665.unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_mask_LightPlace(_e654.x, _e671.unnamed_1.shift));
                            phi_1328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_mask_LightPlace(_e677.unnamed_1.word, _e654.y));
                        } else {
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e693.unnamed.word, _e654.y), _e693.unnamed_1);
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_mask_LightPlace(_e654.z, _e699.unnamed_1.shift));
                            phi_1328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_mask_LightPlace(_e705.unnamed_1.word, _e654.w));
                        }
                        let _e713 = phi_1328_;
                        let _e723 = nodes.member[(0u + _e589)].y;
                        if (_e339 < 0f) {
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e723.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e734.unnamed.word, _e723.w), _e734.unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_mask_LightPlace(_e723.x, _e740.unnamed_1.shift));
                            phi_1355_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_mask_LightPlace(_e746.unnamed_1.word, _e723.y));
                        } else {
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e723.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e762.unnamed.word, _e723.y), _e762.unnamed_1);
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_mask_LightPlace(_e723.z, _e768.unnamed_1.shift));
                            phi_1355_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_mask_LightPlace(_e774.unnamed_1.word, _e723.w));
                        }
                        let _e782 = phi_1355_;
                        let _e792 = nodes.member[(0u + _e589)].z;
                        if (_e350 < 0f) {
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e792.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e803.unnamed.word, _e792.w), _e803.unnamed_1);
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_mask_LightPlace(_e792.x, _e809.unnamed_1.shift));
                            phi_1382_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e815.unnamed, lt_mask_LightPlace(_e815.unnamed_1.word, _e792.y));
                        } else {
                            let _e831 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e792.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e837 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e831.unnamed.word, _e792.y), _e831.unnamed_1);
                            let _e843 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e837.unnamed, lt_mask_LightPlace(_e792.z, _e837.unnamed_1.shift));
                            phi_1382_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e843.unnamed, lt_mask_LightPlace(_e843.unnamed_1.word, _e792.w));
                        }
                        let _e851 = phi_1382_;
                        phi_1388_ = 0u;
                        phi_1391_ = 0u;
                        loop {
                            let _e861 = phi_1388_;
                            let _e863 = phi_1391_;
                            local_3 = _e863;
                            local_4 = _e863;
                            local_5 = _e863;
                            let _e864 = (_e861 < 8u);
                            if _e864 {
                                let _e866 = (_e861 >> bitcast<u32>(2i));
                                let _e867 = (_e861 & 3u);
                                if (_e866 == 0u) {
                                    phi_1405_ = _e713.unnamed.word;
                                } else {
                                    phi_1405_ = _e713.unnamed.shift;
                                }
                                let _e870 = phi_1405_;
                                if (_e866 == 0u) {
                                    phi_1415_ = _e782.unnamed.word;
                                } else {
                                    phi_1415_ = _e782.unnamed.shift;
                                }
                                let _e879 = phi_1415_;
                                if (_e866 == 0u) {
                                    phi_1425_ = _e851.unnamed.word;
                                } else {
                                    phi_1425_ = _e851.unnamed.shift;
                                }
                                let _e888 = phi_1425_;
                                let _e901 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e870 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e623) + (_e644 - _e388)), ((f32(((_e879 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e624) + (_e645 - _e389)));
                                let _e902 = core_intrinsics_maximum_number_nsz_f32_(_e901, ((f32(((_e888 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e625) + (_e646 - _e390)));
                                if (_e866 == 0u) {
                                    phi_1443_ = _e713.unnamed_1.word;
                                } else {
                                    phi_1443_ = _e713.unnamed_1.shift;
                                }
                                let _e905 = phi_1443_;
                                if (_e866 == 0u) {
                                    phi_1453_ = _e782.unnamed_1.word;
                                } else {
                                    phi_1453_ = _e782.unnamed_1.shift;
                                }
                                let _e914 = phi_1453_;
                                if (_e866 == 0u) {
                                    phi_1463_ = _e851.unnamed_1.word;
                                } else {
                                    phi_1463_ = _e851.unnamed_1.shift;
                                }
                                let _e923 = phi_1463_;
                                let _e936 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e905 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e623) + (_e644 + _e388)), ((f32(((_e914 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e624) + (_e645 + _e389)));
                                let _e937 = core_intrinsics_minimum_number_nsz_f32_(_e936, ((f32(((_e923 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e625) + (_e646 + _e390)));
                                if (_e902 <= _e937) {
                                    if (_e902 <= _e587.t) {
                                        if (_e937 >= _e182.tmin) {
                                            if (_e866 == 0u) {
                                                let _e944 = nodes.member[(0u + _e589)].links[2u];
                                                phi_1499_ = _e944;
                                            } else {
                                                let _e947 = nodes.member[(0u + _e589)].links[3u];
                                                phi_1499_ = _e947;
                                            }
                                            let _e949 = phi_1499_;
                                            let _e954 = ((_e949 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u);
                                            let _e955 = (_e954 & 31u);
                                            if (_e955 >= 24u) {
                                                phi_1512_ = (24u + ((_e955 - 24u) ^ _e449));
                                            } else {
                                                phi_1512_ = _e955;
                                            }
                                            let _e961 = phi_1512_;
                                            phi_1517_ = (_e863 | ((_e954 >> bitcast<u32>(5i)) << bitcast<u32>((_e961 & 31u))));
                                        } else {
                                            phi_1517_ = _e863;
                                        }
                                        let _e969 = phi_1517_;
                                        phi_1518_ = _e969;
                                    } else {
                                        phi_1518_ = _e863;
                                    }
                                    let _e971 = phi_1518_;
                                    phi_1519_ = _e971;
                                } else {
                                    phi_1519_ = _e863;
                                }
                                let _e973 = phi_1519_;
                                phi_1389_ = (_e861 + 1u);
                                phi_1392_ = _e973;
                            } else {
                                phi_1389_ = u32();
                                phi_1392_ = u32();
                            }
                            let _e976 = phi_1389_;
                            let _e978 = phi_1392_;
                            continue;
                            continuing {
                                phi_1388_ = _e976;
                                phi_1391_ = _e978;
                                break if !(_e864);
                            }
                        }
                        let _e982 = nodes.member[(0u + _e589)].links[0u];
                        let _e986 = nodes.member[(0u + _e589)].frame[3u];
                        let _e990 = local_3;
                        if ((_e990 & 4278190080u) == 0u) {
                        } else {
                            let _e994 = local_2.group_mask;
                            if ((_e994 & 4278190080u) == 0u) {
                            } else {
                                let _e998 = local_2.len;
                                if (_e998 < 32u) {
                                    let _e1001 = local_2.group;
                                    let _e1003 = local_2.len;
                                    if (_e1003 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e1003)] = _e1001;
                                    let _e1009 = local_2.group_mask;
                                    let _e1011 = local_2.len;
                                    if (_e1011 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e1011)] = _e1009;
                                    let _e1018 = local_2.len;
                                    local_2.len = (_e1018 + 1u);
                                }
                            }
                            local_2.group = (0u + _e982);
                            let _e1022 = local_4;
                            local_2.group_mask = ((_e1022 & 4278190080u) | (_e986 >> bitcast<u32>(24i)));
                        }
                        let _e1027 = local_5;
                        phi_1577_ = _e587;
                        phi_1580_ = (_e1027 & 16777215u);
                        loop {
                            let _e1030 = phi_1577_;
                            let _e1032 = phi_1580_;
                            local_6 = _e1030;
                            if (_e1032 == 0u) {
                                phi_1578_ = lt_bvh_Hit();
                                phi_1581_ = u32();
                                phi_2436_ = false;
                            } else {
                                let _e1036 = nodes.member[(0u + _e589)].links[1u];
                                let _e1041 = ((0u + _e1036) + select(firstTrailingBit(_e1032), 32u, (_e1032 == 0u)));
                                if (_e1041 < _e83) {
                                } else {
                                    return;
                                }
                                let _e1048 = triangles.member[(0u + _e1041)].v0_;
                                let _e1051 = (_e1048.x - _e182.origin.x);
                                let _e1054 = (_e1048.y - _e182.origin.y);
                                let _e1057 = (_e1048.z - _e182.origin.z);
                                if (_e416 == 0u) {
                                    phi_1627_ = vec3<f32>(_e1054, _e1057, _e1051);
                                } else {
                                    if (_e416 == 1u) {
                                        phi_1626_ = vec3<f32>(_e1057, _e1051, _e1054);
                                    } else {
                                        phi_1626_ = (_e1048 - _e182.origin);
                                    }
                                    let _e1064 = phi_1626_;
                                    phi_1627_ = _e1064;
                                }
                                let _e1066 = phi_1627_;
                                let _e1070 = (_e1066.x - (_e433 * _e1066.z));
                                let _e1074 = (_e1066.y - (_e436 * _e1066.z));
                                let _e1076 = triangles.member[(0u + _e1041)].v1_;
                                let _e1079 = (_e1076.x - _e182.origin.x);
                                let _e1082 = (_e1076.y - _e182.origin.y);
                                let _e1085 = (_e1076.z - _e182.origin.z);
                                if (_e416 == 0u) {
                                    phi_1659_ = vec3<f32>(_e1082, _e1085, _e1079);
                                } else {
                                    if (_e416 == 1u) {
                                        phi_1658_ = vec3<f32>(_e1085, _e1079, _e1082);
                                    } else {
                                        phi_1658_ = (_e1076 - _e182.origin);
                                    }
                                    let _e1092 = phi_1658_;
                                    phi_1659_ = _e1092;
                                }
                                let _e1094 = phi_1659_;
                                let _e1098 = (_e1094.x - (_e433 * _e1094.z));
                                let _e1102 = (_e1094.y - (_e436 * _e1094.z));
                                let _e1104 = triangles.member[(0u + _e1041)].v2_;
                                let _e1107 = (_e1104.x - _e182.origin.x);
                                let _e1110 = (_e1104.y - _e182.origin.y);
                                let _e1113 = (_e1104.z - _e182.origin.z);
                                if (_e416 == 0u) {
                                    phi_1691_ = vec3<f32>(_e1110, _e1113, _e1107);
                                } else {
                                    if (_e416 == 1u) {
                                        phi_1690_ = vec3<f32>(_e1113, _e1107, _e1110);
                                    } else {
                                        phi_1690_ = (_e1104 - _e182.origin);
                                    }
                                    let _e1120 = phi_1690_;
                                    phi_1691_ = _e1120;
                                }
                                let _e1122 = phi_1691_;
                                let _e1126 = (_e1122.x - (_e433 * _e1122.z));
                                let _e1130 = (_e1122.y - (_e436 * _e1122.z));
                                if (_e1098 < _e1126) {
                                    phi_1710_ = true;
                                } else {
                                    if (_e1098 == _e1126) {
                                        phi_1709_ = (_e1102 < _e1130);
                                    } else {
                                        phi_1709_ = false;
                                    }
                                    let _e1135 = phi_1709_;
                                    phi_1710_ = _e1135;
                                }
                                let _e1137 = phi_1710_;
                                if _e1137 {
                                    phi_1714_ = _e1130;
                                    phi_1715_ = _e1126;
                                    phi_1716_ = _e1102;
                                    phi_1717_ = _e1098;
                                } else {
                                    phi_1714_ = _e1102;
                                    phi_1715_ = _e1098;
                                    phi_1716_ = _e1130;
                                    phi_1717_ = _e1126;
                                }
                                let _e1139 = phi_1714_;
                                let _e1141 = phi_1715_;
                                let _e1143 = phi_1716_;
                                let _e1145 = phi_1717_;
                                let _e1148 = ((_e1145 * _e1139) - (_e1143 * _e1141));
                                if _e1137 {
                                    phi_1725_ = -(_e1148);
                                } else {
                                    phi_1725_ = _e1148;
                                }
                                let _e1151 = phi_1725_;
                                if (_e1126 < _e1070) {
                                    phi_1736_ = true;
                                } else {
                                    if (_e1126 == _e1070) {
                                        phi_1735_ = (_e1130 < _e1074);
                                    } else {
                                        phi_1735_ = false;
                                    }
                                    let _e1156 = phi_1735_;
                                    phi_1736_ = _e1156;
                                }
                                let _e1158 = phi_1736_;
                                if _e1158 {
                                    phi_1740_ = _e1074;
                                    phi_1741_ = _e1070;
                                    phi_1742_ = _e1130;
                                    phi_1743_ = _e1126;
                                } else {
                                    phi_1740_ = _e1130;
                                    phi_1741_ = _e1126;
                                    phi_1742_ = _e1074;
                                    phi_1743_ = _e1070;
                                }
                                let _e1160 = phi_1740_;
                                let _e1162 = phi_1741_;
                                let _e1164 = phi_1742_;
                                let _e1166 = phi_1743_;
                                let _e1169 = ((_e1166 * _e1160) - (_e1164 * _e1162));
                                if _e1158 {
                                    phi_1751_ = -(_e1169);
                                } else {
                                    phi_1751_ = _e1169;
                                }
                                let _e1172 = phi_1751_;
                                if (_e1070 < _e1098) {
                                    phi_1762_ = true;
                                } else {
                                    if (_e1070 == _e1098) {
                                        phi_1761_ = (_e1074 < _e1102);
                                    } else {
                                        phi_1761_ = false;
                                    }
                                    let _e1177 = phi_1761_;
                                    phi_1762_ = _e1177;
                                }
                                let _e1179 = phi_1762_;
                                if _e1179 {
                                    phi_1766_ = _e1102;
                                    phi_1767_ = _e1098;
                                    phi_1768_ = _e1074;
                                    phi_1769_ = _e1070;
                                } else {
                                    phi_1766_ = _e1074;
                                    phi_1767_ = _e1070;
                                    phi_1768_ = _e1102;
                                    phi_1769_ = _e1098;
                                }
                                let _e1181 = phi_1766_;
                                let _e1183 = phi_1767_;
                                let _e1185 = phi_1768_;
                                let _e1187 = phi_1769_;
                                let _e1190 = ((_e1187 * _e1181) - (_e1185 * _e1183));
                                if _e1179 {
                                    phi_1777_ = -(_e1190);
                                } else {
                                    phi_1777_ = _e1190;
                                }
                                let _e1193 = phi_1777_;
                                if (_e1151 >= 0f) {
                                    if (_e1172 >= 0f) {
                                        if (_e1193 >= 0f) {
                                            phi_1792_ = ((_e1151 + _e1172) + _e1193);
                                            phi_1793_ = false;
                                        } else {
                                            phi_1792_ = f32();
                                            phi_1793_ = true;
                                        }
                                        let _e1200 = phi_1792_;
                                        let _e1202 = phi_1793_;
                                        phi_1794_ = _e1200;
                                        phi_1795_ = _e1202;
                                    } else {
                                        phi_1794_ = f32();
                                        phi_1795_ = true;
                                    }
                                    let _e1204 = phi_1794_;
                                    let _e1206 = phi_1795_;
                                    phi_1796_ = _e1204;
                                    phi_1797_ = _e1206;
                                } else {
                                    phi_1796_ = f32();
                                    phi_1797_ = true;
                                }
                                let _e1208 = phi_1796_;
                                let _e1210 = phi_1797_;
                                if _e1210 {
                                    if (_e1151 <= 0f) {
                                        if (_e1172 <= 0f) {
                                            let _e1213 = (_e1193 <= 0f);
                                            if _e1213 {
                                            }
                                            phi_1815_ = ((_e1151 + _e1172) + _e1193);
                                            phi_1816_ = false;
                                            phi_1817_ = _e1213;
                                        } else {
                                            phi_1815_ = f32();
                                            phi_1816_ = true;
                                            phi_1817_ = false;
                                        }
                                        let _e1217 = phi_1815_;
                                        let _e1219 = phi_1816_;
                                        let _e1221 = phi_1817_;
                                        phi_1818_ = _e1217;
                                        phi_1819_ = _e1219;
                                        phi_1820_ = _e1221;
                                    } else {
                                        phi_1818_ = f32();
                                        phi_1819_ = true;
                                        phi_1820_ = false;
                                    }
                                    let _e1223 = phi_1818_;
                                    let _e1225 = phi_1819_;
                                    let _e1227 = phi_1820_;
                                    if _e1225 {
                                        phi_1824_ = false;
                                    } else {
                                        phi_1824_ = _e1227;
                                    }
                                    let _e1229 = phi_1824_;
                                    phi_1825_ = _e1223;
                                    phi_1826_ = _e1229;
                                } else {
                                    phi_1825_ = _e1208;
                                    phi_1826_ = true;
                                }
                                let _e1231 = phi_1825_;
                                let _e1233 = phi_1826_;
                                if _e1233 {
                                    let _e1234 = (_e1231 == 0f);
                                    if _e1234 {
                                        phi_2152_ = lt_bvh_triangle_Intersection();
                                        phi_2153_ = false;
                                    } else {
                                        let _e1236 = triangles.member[(0u + _e1041)].v0_;
                                        let _e1239 = (_e1236.x - _e182.origin.x);
                                        let _e1242 = (_e1236.y - _e182.origin.y);
                                        let _e1245 = (_e1236.z - _e182.origin.z);
                                        if (_e416 == 0u) {
                                            phi_1857_ = vec3<f32>(_e1242, _e1245, _e1239);
                                        } else {
                                            if (_e416 == 1u) {
                                                phi_1856_ = vec3<f32>(_e1245, _e1239, _e1242);
                                            } else {
                                                phi_1856_ = (_e1236 - _e182.origin);
                                            }
                                            let _e1252 = phi_1856_;
                                            phi_1857_ = _e1252;
                                        }
                                        let _e1254 = phi_1857_;
                                        let _e1256 = triangles.member[(0u + _e1041)].v1_;
                                        let _e1258 = triangles.member[(0u + _e1041)].v0_;
                                        let _e1261 = (_e1256.x - _e1258.x);
                                        let _e1264 = (_e1256.y - _e1258.y);
                                        let _e1267 = (_e1256.z - _e1258.z);
                                        if (_e416 == 0u) {
                                            phi_1883_ = vec3<f32>(_e1264, _e1267, _e1261);
                                        } else {
                                            if (_e416 == 1u) {
                                                phi_1882_ = vec3<f32>(_e1267, _e1261, _e1264);
                                            } else {
                                                phi_1882_ = (_e1256 - _e1258);
                                            }
                                            let _e1274 = phi_1882_;
                                            phi_1883_ = _e1274;
                                        }
                                        let _e1276 = phi_1883_;
                                        let _e1278 = triangles.member[(0u + _e1041)].v2_;
                                        let _e1280 = triangles.member[(0u + _e1041)].v0_;
                                        let _e1283 = (_e1278.x - _e1280.x);
                                        let _e1286 = (_e1278.y - _e1280.y);
                                        let _e1289 = (_e1278.z - _e1280.z);
                                        if (_e416 == 0u) {
                                            phi_1909_ = vec3<f32>(_e1286, _e1289, _e1283);
                                        } else {
                                            if (_e416 == 1u) {
                                                phi_1908_ = vec3<f32>(_e1289, _e1283, _e1286);
                                            } else {
                                                phi_1908_ = (_e1278 - _e1280);
                                            }
                                            let _e1296 = phi_1908_;
                                            phi_1909_ = _e1296;
                                        }
                                        let _e1298 = phi_1909_;
                                        let _e1305 = ((_e1276.y * _e1298.z) - (_e1276.z * _e1298.y));
                                        let _e1312 = ((_e1276.z * _e1298.x) - (_e1276.x * _e1298.z));
                                        let _e1319 = ((_e1276.x * _e1298.y) - (_e1276.y * _e1298.x));
                                        let _e1333 = (((1f / _e430.z) * (((_e1305 * _e1254.x) + (_e1312 * _e1254.y)) + (_e1319 * _e1254.z))) / (((_e1305 * _e433) + (_e1312 * _e436)) + _e1319));
                                        if (_e1333 > _e182.tmin) {
                                            if (_e1333 < _e182.tmax) {
                                                let _e1339 = triangles.member[(0u + _e1041)].v0_;
                                                let _e1341 = triangles.member[(0u + _e1041)].v1_;
                                                if (_e1339.x < _e1341.x) {
                                                    phi_1967_ = _e1339.x;
                                                } else {
                                                    phi_1967_ = _e1341.x;
                                                }
                                                let _e1348 = phi_1967_;
                                                if (_e1339.y < _e1341.y) {
                                                    phi_1976_ = _e1339.y;
                                                } else {
                                                    phi_1976_ = _e1341.y;
                                                }
                                                let _e1355 = phi_1976_;
                                                if (_e1339.z < _e1341.z) {
                                                    phi_1985_ = _e1339.z;
                                                } else {
                                                    phi_1985_ = _e1341.z;
                                                }
                                                let _e1362 = phi_1985_;
                                                let _e1364 = triangles.member[(0u + _e1041)].v2_;
                                                if (_e1348 < _e1364.x) {
                                                    phi_1994_ = _e1348;
                                                } else {
                                                    phi_1994_ = _e1364.x;
                                                }
                                                let _e1369 = phi_1994_;
                                                if (_e1355 < _e1364.y) {
                                                    phi_2001_ = _e1355;
                                                } else {
                                                    phi_2001_ = _e1364.y;
                                                }
                                                let _e1374 = phi_2001_;
                                                if (_e1362 < _e1364.z) {
                                                    phi_2008_ = _e1362;
                                                } else {
                                                    phi_2008_ = _e1364.z;
                                                }
                                                let _e1379 = phi_2008_;
                                                let _e1381 = triangles.member[(0u + _e1041)].v0_;
                                                let _e1383 = triangles.member[(0u + _e1041)].v1_;
                                                if (_e1381.x > _e1383.x) {
                                                    phi_2021_ = _e1381.x;
                                                } else {
                                                    phi_2021_ = _e1383.x;
                                                }
                                                let _e1390 = phi_2021_;
                                                if (_e1381.y > _e1383.y) {
                                                    phi_2030_ = _e1381.y;
                                                } else {
                                                    phi_2030_ = _e1383.y;
                                                }
                                                let _e1397 = phi_2030_;
                                                if (_e1381.z > _e1383.z) {
                                                    phi_2039_ = _e1381.z;
                                                } else {
                                                    phi_2039_ = _e1383.z;
                                                }
                                                let _e1404 = phi_2039_;
                                                let _e1406 = triangles.member[(0u + _e1041)].v2_;
                                                if (_e1390 > _e1406.x) {
                                                    phi_2048_ = _e1390;
                                                } else {
                                                    phi_2048_ = _e1406.x;
                                                }
                                                let _e1411 = phi_2048_;
                                                if (_e1397 > _e1406.y) {
                                                    phi_2055_ = _e1397;
                                                } else {
                                                    phi_2055_ = _e1406.y;
                                                }
                                                let _e1416 = phi_2055_;
                                                if (_e1404 > _e1406.z) {
                                                    phi_2062_ = _e1404;
                                                } else {
                                                    phi_2062_ = _e1406.z;
                                                }
                                                let _e1421 = phi_2062_;
                                                let _e1428 = ((_e1369 - _e182.origin.x) * _e328);
                                                let _e1429 = ((_e1374 - _e182.origin.y) * _e339);
                                                let _e1430 = ((_e1379 - _e182.origin.z) * _e350);
                                                let _e1437 = ((_e1411 - _e182.origin.x) * _e328);
                                                let _e1438 = ((_e1416 - _e182.origin.y) * _e339);
                                                let _e1439 = ((_e1421 - _e182.origin.z) * _e350);
                                                if (_e1428 < _e1437) {
                                                    phi_2085_ = _e1428;
                                                } else {
                                                    phi_2085_ = _e1437;
                                                }
                                                let _e1442 = phi_2085_;
                                                if (_e1429 < _e1438) {
                                                    phi_2090_ = _e1429;
                                                } else {
                                                    phi_2090_ = _e1438;
                                                }
                                                let _e1445 = phi_2090_;
                                                if (_e1430 < _e1439) {
                                                    phi_2095_ = _e1430;
                                                } else {
                                                    phi_2095_ = _e1439;
                                                }
                                                let _e1448 = phi_2095_;
                                                if (_e1428 > _e1437) {
                                                    phi_2103_ = _e1428;
                                                } else {
                                                    phi_2103_ = _e1437;
                                                }
                                                let _e1454 = phi_2103_;
                                                if (_e1429 > _e1438) {
                                                    phi_2108_ = _e1429;
                                                } else {
                                                    phi_2108_ = _e1438;
                                                }
                                                let _e1457 = phi_2108_;
                                                if (_e1430 > _e1439) {
                                                    phi_2113_ = _e1430;
                                                } else {
                                                    phi_2113_ = _e1439;
                                                }
                                                let _e1460 = phi_2113_;
                                                let _e1464 = core_intrinsics_maximum_number_nsz_f32_((_e1442 - _e395), (_e1445 - _e396));
                                                let _e1465 = core_intrinsics_maximum_number_nsz_f32_(_e1464, (_e1448 - _e397));
                                                let _e1466 = core_intrinsics_minimum_number_nsz_f32_((_e1454 + _e395), (_e1457 + _e396));
                                                let _e1467 = core_intrinsics_minimum_number_nsz_f32_(_e1466, (_e1460 + _e397));
                                                if (_e1465 > -300000000000000000000000000000000000000f) {
                                                    phi_2125_ = _e1465;
                                                } else {
                                                    phi_2125_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1470 = phi_2125_;
                                                if (_e1467 < 300000000000000000000000000000000000000f) {
                                                    phi_2130_ = _e1467;
                                                } else {
                                                    phi_2130_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1473 = phi_2130_;
                                                if (_e1333 < _e1470) {
                                                    phi_2135_ = _e1470;
                                                } else {
                                                    phi_2135_ = _e1333;
                                                }
                                                let _e1476 = phi_2135_;
                                                if (_e1476 > _e1473) {
                                                    phi_2140_ = _e1473;
                                                } else {
                                                    phi_2140_ = _e1476;
                                                }
                                                let _e1479 = phi_2140_;
                                                phi_2145_ = lt_bvh_triangle_Intersection(_e1479, (_e1172 / _e1231), (_e1193 / _e1231), (_e1470 <= _e1473));
                                                phi_2146_ = false;
                                            } else {
                                                phi_2145_ = lt_bvh_triangle_Intersection();
                                                phi_2146_ = true;
                                            }
                                            let _e1485 = phi_2145_;
                                            let _e1487 = phi_2146_;
                                            phi_2147_ = _e1485;
                                            phi_2148_ = _e1487;
                                        } else {
                                            phi_2147_ = lt_bvh_triangle_Intersection();
                                            phi_2148_ = true;
                                        }
                                        let _e1489 = phi_2147_;
                                        let _e1491 = phi_2148_;
                                        if _e1491 {
                                        }
                                        phi_2152_ = _e1489;
                                        phi_2153_ = _e1491;
                                    }
                                    let _e1493 = phi_2152_;
                                    let _e1495 = phi_2153_;
                                    phi_2154_ = _e1493;
                                    phi_2155_ = _e1234;
                                    phi_2156_ = _e1495;
                                } else {
                                    phi_2154_ = lt_bvh_triangle_Intersection();
                                    phi_2155_ = true;
                                    phi_2156_ = false;
                                }
                                let _e1497 = phi_2154_;
                                let _e1499 = phi_2155_;
                                let _e1501 = phi_2156_;
                                if _e1499 {
                                    phi_2160_ = true;
                                } else {
                                    phi_2160_ = _e1501;
                                }
                                let _e1503 = phi_2160_;
                                if _e1503 {
                                    phi_2164_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2164_ = _e1497;
                                }
                                let _e1505 = phi_2164_;
                                if _e1505.is_hit {
                                    if (_e1505.t > _e182.tmin) {
                                        if (_e1505.t < _e1030.t) {
                                            phi_2213_ = true;
                                        } else {
                                            if (_e1505.t == _e1030.t) {
                                                if (_e1030.triangle != 4294967295u) {
                                                    if (_e1041 < _e1030.triangle) {
                                                        phi_2204_ = true;
                                                    } else {
                                                        if (_e1041 == _e1030.triangle) {
                                                            phi_2203_ = (4294967295u < _e1030.instance);
                                                        } else {
                                                            phi_2203_ = false;
                                                        }
                                                        let _e1524 = phi_2203_;
                                                        phi_2204_ = _e1524;
                                                    }
                                                    let _e1526 = phi_2204_;
                                                    phi_2205_ = _e1526;
                                                    phi_2206_ = false;
                                                } else {
                                                    phi_2205_ = bool();
                                                    phi_2206_ = true;
                                                }
                                                let _e1528 = phi_2205_;
                                                let _e1530 = phi_2206_;
                                                phi_2207_ = _e1528;
                                                phi_2208_ = _e1530;
                                            } else {
                                                phi_2207_ = bool();
                                                phi_2208_ = true;
                                            }
                                            let _e1532 = phi_2207_;
                                            let _e1534 = phi_2208_;
                                            if _e1534 {
                                                phi_2212_ = false;
                                            } else {
                                                phi_2212_ = _e1532;
                                            }
                                            let _e1536 = phi_2212_;
                                            phi_2213_ = _e1536;
                                        }
                                        let _e1538 = phi_2213_;
                                        if _e1538 {
                                            let _e1540 = triangles.member[(0u + _e1041)].i0_;
                                            if ((_e1540 & 2147483648u) == 0u) {
                                                phi_2424_ = true;
                                            } else {
                                                if (_e1041 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1549 = triangles.member[(0u + _e1041)].i0_;
                                                let _e1550 = (_e1549 & 2147483647u);
                                                let _e1552 = triangles.member[(0u + _e1041)].i1_;
                                                let _e1554 = triangles.member[(0u + _e1041)].i2_;
                                                if (_e1550 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1558 = vertices.member[(0u + _e1550)];
                                                if (_e1552 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1562 = vertices.member[(0u + _e1552)];
                                                if (_e1554 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1566 = vertices.member[(0u + _e1554)];
                                                let _e1567 = array<abi_Vertex, 3>(_e1558, _e1562, _e1566);
                                                if (_e1567[0].material < _e89) {
                                                } else {
                                                    return;
                                                }
                                                let _e1573 = materials.member[(0u + _e1567[0].material)];
                                                if ((_e1573.flags & 0u) == 0u) {
                                                    let _e1578 = ((1f - _e1505.u) - _e1505.v);
                                                    if (_e1573.cutoff <= 0f) {
                                                        phi_2419_ = true;
                                                    } else {
                                                        let _e1605 = (_e1573.base_color.w * ((((f32((_e1567[0].color >> bitcast<u32>(24i))) * _e1578) + (f32((_e1567[1].color >> bitcast<u32>(24i))) * _e1505.u)) + (f32((_e1567[2].color >> bitcast<u32>(24i))) * _e1505.v)) * (1f / 255f)));
                                                        if (_e1573.alpha_size == 0u) {
                                                            phi_2416_ = _e1605;
                                                        } else {
                                                            local_1.offset = _e1573.alpha_offset;
                                                            local_1.size = _e1573.alpha_size;
                                                            local_1.flags = _e1573.flags;
                                                            let _e1636 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1567[0].u * _e1578) + (_e1567[1].u * _e1505.u)) + (_e1567[2].u * _e1505.v)), (((_e1567[0].v * _e1578) + (_e1567[1].v * _e1505.u)) + (_e1567[2].v * _e1505.v)));
                                                            let _e1640 = (_e1636.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1640 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1644 = alpha_texels.member[(0u + _e1640)];
                                                            let _e1660 = (_e1636.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1660 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1664 = alpha_texels.member[(0u + _e1660)];
                                                            let _e1681 = (_e1636.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1681 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1685 = alpha_texels.member[(0u + _e1681)];
                                                            let _e1702 = (_e1636.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1702 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1706 = alpha_texels.member[(0u + _e1702)];
                                                            phi_2416_ = (_e1605 * (((((f32(((_e1644 >> bitcast<u32>((((_e1636.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.x) + ((f32(((_e1664 >> bitcast<u32>((((_e1636.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.y)) + ((f32(((_e1685 >> bitcast<u32>((((_e1636.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.z)) + ((f32(((_e1706 >> bitcast<u32>((((_e1636.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.w)));
                                                        }
                                                        let _e1722 = phi_2416_;
                                                        phi_2419_ = (_e1722 >= _e1573.cutoff);
                                                    }
                                                    let _e1726 = phi_2419_;
                                                    phi_2420_ = _e1726;
                                                } else {
                                                    phi_2420_ = false;
                                                }
                                                let _e1728 = phi_2420_;
                                                if _e1728 {
                                                }
                                                phi_2424_ = _e1728;
                                            }
                                            let _e1730 = phi_2424_;
                                            if _e1730 {
                                                phi_2432_ = lt_bvh_Hit(_e1505.t, _e1505.u, _e1505.v, _e1041, 4294967295u);
                                            } else {
                                                phi_2432_ = _e1030;
                                            }
                                            let _e1736 = phi_2432_;
                                            phi_2433_ = _e1736;
                                        } else {
                                            phi_2433_ = _e1030;
                                        }
                                        let _e1738 = phi_2433_;
                                        phi_2434_ = _e1738;
                                    } else {
                                        phi_2434_ = _e1030;
                                    }
                                    let _e1740 = phi_2434_;
                                    phi_2435_ = _e1740;
                                } else {
                                    phi_2435_ = _e1030;
                                }
                                let _e1742 = phi_2435_;
                                phi_1578_ = _e1742;
                                phi_1581_ = (_e1032 & (_e1032 - 1u));
                                phi_2436_ = true;
                            }
                            let _e1744 = phi_1578_;
                            let _e1746 = phi_1581_;
                            let _e1748 = phi_2436_;
                            continue;
                            continuing {
                                phi_1577_ = _e1744;
                                phi_1580_ = _e1746;
                                break if !(_e1748);
                            }
                        }
                        let _e1751 = local_2.group_mask;
                        if ((_e1751 & 4278190080u) == 0u) {
                            let _e1755 = local_2.len;
                            if (_e1755 == 0u) {
                                phi_2475_ = false;
                            } else {
                                let _e1759 = local_2.len;
                                local_2.len = (_e1759 - 1u);
                                let _e1762 = local_2.len;
                                if (_e1762 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1767 = local_2.first[(0u + _e1762)];
                                local_2.group = _e1767;
                                let _e1770 = local_2.len;
                                if (_e1770 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1775 = local_2.mask[(0u + _e1770)];
                                local_2.group_mask = _e1775;
                                phi_2475_ = true;
                            }
                            let _e1778 = phi_2475_;
                            phi_2476_ = _e1778;
                        } else {
                            phi_2476_ = true;
                        }
                        let _e1780 = phi_2476_;
                        if _e1780 {
                            let _e1782 = local_2.group_mask;
                            let _e1788 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1782)), 32u, (_e1782 == 0u)));
                            let _e1792 = local_2.group_mask;
                            let _e1806 = local_2.group_mask;
                            local_2.group_mask = (_e1806 & ~((1u << bitcast<u32>((_e1788 & 31u)))));
                            let _e1809 = local_2.group;
                            phi_2507_ = (_e1809 + countOneBits(((_e1792 & ~((4294967295u << bitcast<u32>((((_e1788 - 24u) ^ _e449) & 31u))))) & 255u)));
                        } else {
                            phi_2507_ = 4294967295u;
                        }
                        let _e1812 = phi_2507_;
                        let _e2733 = local_6;
                        phi_1241_ = _e2733;
                        phi_1244_ = _e1812;
                    } else {
                        phi_1241_ = lt_bvh_Hit();
                        phi_1244_ = u32();
                    }
                    let _e1814 = phi_1241_;
                    let _e1816 = phi_1244_;
                    continue;
                    continuing {
                        phi_1240_ = _e1814;
                        phi_1243_ = _e1816;
                        break if !(_e590);
                    }
                }
                let _e2737 = local_7;
                phi_2508_ = _e2737;
            }
            let _e1819 = phi_2508_;
            phi_2509_ = _e1819;
            phi_2510_ = _e246;
        } else {
            phi_2509_ = lt_bvh_Hit();
            phi_2510_ = true;
        }
        let _e1821 = phi_2509_;
        let _e1823 = phi_2510_;
        if _e1823 {
            phi_2514_ = _e184;
        } else {
            phi_2514_ = _e1821;
        }
        let _e1825 = phi_2514_;
        if (_e1825.triangle != 4294967295u) {
            let _e1831 = ((1f - _e1825.u) - _e1825.v);
            if (_e1825.triangle < _e83) {
            } else {
                return;
            }
            let _e1836 = triangles.member[(0u + _e1825.triangle)];
            let _e1861 = (((_e1836.v0_.x * _e1831) + (_e1836.v1_.x * _e1825.u)) + (_e1836.v2_.x * _e1825.v));
            let _e1862 = (((_e1836.v0_.y * _e1831) + (_e1836.v1_.y * _e1825.u)) + (_e1836.v2_.y * _e1825.v));
            let _e1863 = (((_e1836.v0_.z * _e1831) + (_e1836.v1_.z * _e1825.u)) + (_e1836.v2_.z * _e1825.v));
            let _e1866 = abs(_e1836.v0_.x);
            let _e1868 = abs(_e1836.v0_.y);
            let _e1870 = abs(_e1836.v0_.z);
            let _e1872 = abs(_e1836.v1_.x);
            let _e1874 = abs(_e1836.v1_.y);
            let _e1876 = abs(_e1836.v1_.z);
            if (_e1866 > _e1872) {
                phi_2578_ = _e1866;
            } else {
                phi_2578_ = _e1872;
            }
            let _e1879 = phi_2578_;
            if (_e1868 > _e1874) {
                phi_2583_ = _e1868;
            } else {
                phi_2583_ = _e1874;
            }
            let _e1882 = phi_2583_;
            if (_e1870 > _e1876) {
                phi_2588_ = _e1870;
            } else {
                phi_2588_ = _e1876;
            }
            let _e1885 = phi_2588_;
            let _e1887 = abs(_e1836.v2_.x);
            let _e1889 = abs(_e1836.v2_.y);
            let _e1891 = abs(_e1836.v2_.z);
            if (_e1879 > _e1887) {
                phi_2599_ = _e1879;
            } else {
                phi_2599_ = _e1887;
            }
            let _e1894 = phi_2599_;
            if (_e1882 > _e1889) {
                phi_2604_ = _e1882;
            } else {
                phi_2604_ = _e1889;
            }
            let _e1897 = phi_2604_;
            if (_e1885 > _e1891) {
                phi_2609_ = _e1885;
            } else {
                phi_2609_ = _e1891;
            }
            let _e1900 = phi_2609_;
            let _e1903 = (_e1836.v1_.x - _e1836.v0_.x);
            let _e1906 = (_e1836.v1_.y - _e1836.v0_.y);
            let _e1909 = (_e1836.v1_.z - _e1836.v0_.z);
            let _e1912 = (_e1836.v2_.x - _e1836.v0_.x);
            let _e1915 = (_e1836.v2_.y - _e1836.v0_.y);
            let _e1918 = (_e1836.v2_.z - _e1836.v0_.z);
            let _e1922 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1906), abs(_e1909));
            let _e1923 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1903), _e1922);
            let _e1924 = (_e1903 / _e1923);
            let _e1925 = (_e1906 / _e1923);
            let _e1926 = (_e1909 / _e1923);
            let _e1930 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1915), abs(_e1918));
            let _e1931 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1912), _e1930);
            let _e1932 = (_e1912 / _e1931);
            let _e1933 = (_e1915 / _e1931);
            let _e1934 = (_e1918 / _e1931);
            let _e1937 = ((_e1925 * _e1934) - (_e1933 * _e1926));
            let _e1940 = ((_e1926 * _e1932) - (_e1934 * _e1924));
            let _e1943 = ((_e1924 * _e1933) - (_e1932 * _e1925));
            let _e1945 = p.member.eye;
            let _e1958 = (1f / sqrt((((_e1937 * _e1937) + (_e1940 * _e1940)) + (_e1943 * _e1943))));
            let _e1959 = (_e1937 * _e1958);
            let _e1960 = (_e1940 * _e1958);
            let _e1961 = (_e1943 * _e1958);
            if ((((_e1959 * (_e1945.x - _e1861)) + (_e1960 * (_e1945.y - _e1862))) + (_e1961 * (_e1945.z - _e1863))) < 0f) {
                phi_2685_ = vec3<f32>(-(_e1959), -(_e1960), -(_e1961));
            } else {
                phi_2685_ = vec3<f32>(_e1959, _e1960, _e1961);
            }
            let _e1974 = phi_2685_;
            if (_e1825.triangle < _e83) {
            } else {
                return;
            }
            let _e1979 = triangles.member[(0u + _e1825.triangle)];
            let _e1981 = (_e1979.i0_ & 2147483647u);
            if (_e1981 < _e86) {
            } else {
                return;
            }
            let _e1987 = vertices.member[(0u + _e1981)];
            if (_e1979.i1_ < _e86) {
            } else {
                return;
            }
            let _e1991 = vertices.member[(0u + _e1979.i1_)];
            if (_e1979.i2_ < _e86) {
            } else {
                return;
            }
            let _e1995 = vertices.member[(0u + _e1979.i2_)];
            let _e1996 = array<abi_Vertex, 3>(_e1987, _e1991, _e1995);
            if (_e1996[0].material < _e89) {
            } else {
                return;
            }
            let _e2002 = materials.member[(0u + _e1996[0].material)];
            let _e2019 = (1f / 255f);
            let _e2038 = (1f / 255f);
            let _e2060 = (1f / 255f);
            if (_e2002.color_size == 0u) {
                phi_2928_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2002.color_offset;
                local.size = _e2002.color_size;
                local.flags = _e2002.flags;
                let _e2103 = _lt_shaders_texture_TextureView_quad((&local), (((_e1996[0].u * _e1831) + (_e1996[1].u * _e1825.u)) + (_e1996[2].u * _e1825.v)), (((_e1996[0].v * _e1831) + (_e1996[1].v * _e1825.u)) + (_e1996[2].v * _e1825.v)));
                if (_e2103.indices[0] < _e98) {
                } else {
                    return;
                }
                let _e2109 = color_texels.member[(0u + _e2103.indices[0])];
                let _e2120 = (1f / 255f);
                if (_e2103.indices[1] < _e98) {
                } else {
                    return;
                }
                let _e2134 = color_texels.member[(0u + _e2103.indices[1])];
                let _e2145 = (1f / 255f);
                if (_e2103.indices[2] < _e98) {
                } else {
                    return;
                }
                let _e2162 = color_texels.member[(0u + _e2103.indices[2])];
                let _e2173 = (1f / 255f);
                if (_e2103.indices[3] < _e98) {
                } else {
                    return;
                }
                let _e2190 = color_texels.member[(0u + _e2103.indices[3])];
                let _e2201 = (1f / 255f);
                let _e2210 = (((((f32((_e2109 & 255u)) * _e2120) * _e2103.weights.x) + ((f32((_e2134 & 255u)) * _e2145) * _e2103.weights.y)) + ((f32((_e2162 & 255u)) * _e2173) * _e2103.weights.z)) + ((f32((_e2190 & 255u)) * _e2201) * _e2103.weights.w));
                let _e2211 = (((((f32(((_e2109 >> bitcast<u32>(8i)) & 255u)) * _e2120) * _e2103.weights.x) + ((f32(((_e2134 >> bitcast<u32>(8i)) & 255u)) * _e2145) * _e2103.weights.y)) + ((f32(((_e2162 >> bitcast<u32>(8i)) & 255u)) * _e2173) * _e2103.weights.z)) + ((f32(((_e2190 >> bitcast<u32>(8i)) & 255u)) * _e2201) * _e2103.weights.w));
                let _e2212 = (((((f32(((_e2109 >> bitcast<u32>(16i)) & 255u)) * _e2120) * _e2103.weights.x) + ((f32(((_e2134 >> bitcast<u32>(16i)) & 255u)) * _e2145) * _e2103.weights.y)) + ((f32(((_e2162 >> bitcast<u32>(16i)) & 255u)) * _e2173) * _e2103.weights.z)) + ((f32(((_e2190 >> bitcast<u32>(16i)) & 255u)) * _e2201) * _e2103.weights.w));
                phi_2928_ = vec3<f32>((_e2210 * _e2210), (_e2211 * _e2211), (_e2212 * _e2212));
            }
            let _e2218 = phi_2928_;
            let _e2220 = ((_e2002.base_color.x * ((((f32((_e1996[0].color & 255u)) * _e2019) * _e1831) + ((f32((_e1996[1].color & 255u)) * _e2038) * _e1825.u)) + ((f32((_e1996[2].color & 255u)) * _e2060) * _e1825.v))) * _e2218.x);
            let _e2222 = ((_e2002.base_color.y * ((((f32(((_e1996[0].color >> bitcast<u32>(8i)) & 255u)) * _e2019) * _e1831) + ((f32(((_e1996[1].color >> bitcast<u32>(8i)) & 255u)) * _e2038) * _e1825.u)) + ((f32(((_e1996[2].color >> bitcast<u32>(8i)) & 255u)) * _e2060) * _e1825.v))) * _e2218.y);
            let _e2224 = ((_e2002.base_color.z * ((((f32(((_e1996[0].color >> bitcast<u32>(16i)) & 255u)) * _e2019) * _e1831) + ((f32(((_e1996[1].color >> bitcast<u32>(16i)) & 255u)) * _e2038) * _e1825.u)) + ((f32(((_e1996[2].color >> bitcast<u32>(16i)) & 255u)) * _e2060) * _e1825.v))) * _e2218.z);
            let _e2225 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1897, _e1900);
            let _e2226 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1894, _e2225);
            if ((_e2002.flags & 2u) == 0u) {
                phi_2943_ = 0u;
            } else {
                phi_2943_ = 1u;
            }
            let _e2231 = phi_2943_;
            if (_e1996[0].normal == 2147516416u) {
                phi_3146_ = _e1974;
            } else {
                let _e2244 = (f32((bitcast<i32>((_e1996[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2250 = (f32((bitcast<i32>(_e1996[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2254 = ((1f - abs(_e2244)) - abs(_e2250));
                if (_e2254 < 0f) {
                    phi_2970_ = -(_e2254);
                } else {
                    phi_2970_ = 0f;
                }
                let _e2258 = phi_2970_;
                if (_e2244 < 0f) {
                    phi_2977_ = (_e2244 + _e2258);
                } else {
                    phi_2977_ = (_e2244 - _e2258);
                }
                let _e2263 = phi_2977_;
                if (_e2250 < 0f) {
                    phi_2984_ = (_e2250 + _e2258);
                } else {
                    phi_2984_ = (_e2250 - _e2258);
                }
                let _e2268 = phi_2984_;
                let _e2275 = (1f / sqrt((((_e2263 * _e2263) + (_e2268 * _e2268)) + (_e2254 * _e2254))));
                let _e2291 = (f32((bitcast<i32>((_e1996[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2297 = (f32((bitcast<i32>(_e1996[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2301 = ((1f - abs(_e2291)) - abs(_e2297));
                if (_e2301 < 0f) {
                    phi_3019_ = -(_e2301);
                } else {
                    phi_3019_ = 0f;
                }
                let _e2305 = phi_3019_;
                if (_e2291 < 0f) {
                    phi_3026_ = (_e2291 + _e2305);
                } else {
                    phi_3026_ = (_e2291 - _e2305);
                }
                let _e2310 = phi_3026_;
                if (_e2297 < 0f) {
                    phi_3033_ = (_e2297 + _e2305);
                } else {
                    phi_3033_ = (_e2297 - _e2305);
                }
                let _e2315 = phi_3033_;
                let _e2322 = (1f / sqrt((((_e2310 * _e2310) + (_e2315 * _e2315)) + (_e2301 * _e2301))));
                let _e2341 = (f32((bitcast<i32>((_e1996[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2347 = (f32((bitcast<i32>(_e1996[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2351 = ((1f - abs(_e2341)) - abs(_e2347));
                if (_e2351 < 0f) {
                    phi_3071_ = -(_e2351);
                } else {
                    phi_3071_ = 0f;
                }
                let _e2355 = phi_3071_;
                if (_e2341 < 0f) {
                    phi_3078_ = (_e2341 + _e2355);
                } else {
                    phi_3078_ = (_e2341 - _e2355);
                }
                let _e2360 = phi_3078_;
                if (_e2347 < 0f) {
                    phi_3085_ = (_e2347 + _e2355);
                } else {
                    phi_3085_ = (_e2347 - _e2355);
                }
                let _e2365 = phi_3085_;
                let _e2372 = (1f / sqrt((((_e2360 * _e2360) + (_e2365 * _e2365)) + (_e2351 * _e2351))));
                let _e2383 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2263 * _e2275) * _e1831) + ((_e2310 * _e2322) * _e1825.u)) + ((_e2360 * _e2372) * _e1825.v)), ((((_e2268 * _e2275) * _e1831) + ((_e2315 * _e2322) * _e1825.u)) + ((_e2365 * _e2372) * _e1825.v)), ((((_e2254 * _e2275) * _e1831) + ((_e2301 * _e2322) * _e1825.u)) + ((_e2351 * _e2372) * _e1825.v))));
                let _e2395 = sqrt((((_e2383.x * _e2383.x) + (_e2383.y * _e2383.y)) + (_e2383.z * _e2383.z)));
                if (_e2395 > 0f) {
                    let _e2398 = (_e2383.x / _e2395);
                    let _e2400 = (_e2383.y / _e2395);
                    let _e2402 = (_e2383.z / _e2395);
                    if ((((_e2398 * _e1974.x) + (_e2400 * _e1974.y)) + (_e2402 * _e1974.z)) < 0f) {
                        phi_3144_ = vec3<f32>(-(_e2398), -(_e2400), -(_e2402));
                    } else {
                        phi_3144_ = (_e2383 / vec3(_e2395));
                    }
                    let _e2419 = phi_3144_;
                    phi_3145_ = _e2419;
                } else {
                    phi_3145_ = _e1974;
                }
                let _e2421 = phi_3145_;
                phi_3146_ = _e2421;
            }
            let _e2423 = phi_3146_;
            if (_e2220 > 0f) {
                if (_e2220 < 1f) {
                    phi_3155_ = _e2220;
                } else {
                    phi_3155_ = 1f;
                }
                let _e2427 = phi_3155_;
                phi_3156_ = _e2427;
            } else {
                phi_3156_ = 0f;
            }
            let _e2429 = phi_3156_;
            if (_e2222 > 0f) {
                if (_e2222 < 1f) {
                    phi_3166_ = _e2222;
                } else {
                    phi_3166_ = 1f;
                }
                let _e2434 = phi_3166_;
                phi_3167_ = _e2434;
            } else {
                phi_3167_ = 0f;
            }
            let _e2436 = phi_3167_;
            if (_e2224 > 0f) {
                if (_e2224 < 1f) {
                    phi_3177_ = _e2224;
                } else {
                    phi_3177_ = 1f;
                }
                let _e2441 = phi_3177_;
                phi_3178_ = _e2441;
            } else {
                phi_3178_ = 0f;
            }
            let _e2443 = phi_3178_;
            let _e2446 = ((sqrt(_e2429) * 255f) + 0.5f);
            let _e2455 = ((sqrt(_e2436) * 255f) + 0.5f);
            let _e2467 = ((sqrt(_e2443) * 255f) + 0.5f);
            phi_3213_ = abi_Sample(vec3<f32>(_e1861, _e1862, _e1863), _e2226, _e1974, _e2231, _e2423, ((select(select(u32(_e2446), 0u, (_e2446 < bitcast<f32>(0u))), 4294967295u, (_e2446 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2455), 0u, (_e2455 < bitcast<f32>(0u))), 4294967295u, (_e2455 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2467), 0u, (_e2467 < bitcast<f32>(0u))), 4294967295u, (_e2467 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3213_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2481 = phi_3213_;
        if (_e110.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e110.shift)] = _e2481;
        if (_e1825.triangle != 4294967295u) {
            let _e2490 = ((1f - _e1825.u) - _e1825.v);
            if (_e1825.triangle < _e83) {
            } else {
                return;
            }
            let _e2495 = triangles.member[(0u + _e1825.triangle)];
            let _e2497 = (_e2495.i0_ & 2147483647u);
            if (_e2497 < _e101) {
            } else {
                return;
            }
            let _e2503 = before.member[(0u + _e2497)];
            if (_e2495.i1_ < _e101) {
            } else {
                return;
            }
            let _e2507 = before.member[(0u + _e2495.i1_)];
            if (_e2495.i2_ < _e101) {
            } else {
                return;
            }
            let _e2511 = before.member[(0u + _e2495.i2_)];
            let _e2516 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2503.x, _e2503.y, _e2503.z));
            let _e2527 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2507.x, _e2507.y, _e2507.z));
            let _e2541 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2511.x, _e2511.y, _e2511.z));
            phi_3304_ = vec3<f32>((((_e2516.x * _e2490) + (_e2527.x * _e1825.u)) + (_e2541.x * _e1825.v)), (((_e2516.y * _e2490) + (_e2527.y * _e1825.u)) + (_e2541.y * _e1825.v)), (((_e2516.z * _e2490) + (_e2527.z * _e1825.u)) + (_e2541.z * _e1825.v)));
        } else {
            phi_3304_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2553 = phi_3304_;
        if (_e110.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e110.shift)] = vec4<f32>(_e2553.x, _e2553.y, _e2553.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
